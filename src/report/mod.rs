//! What people and pipelines read. Plain data in, text out: one file a format.
//!
//! - [`model`]: the result of a scan as it stands in `scan.json`
//! - [`hazard`], [`cause`]: a hazard in it; hazards that are one flaw
//! - [`certificate`]: what a search of all sequences came to
//! - [`begin`]: where and when a person begins
//! - [`recorded`]: the same, read back
//! - [`looks`]: what a scan looks for, and whether that is as much as an earlier one did
//! - [`narrower`]: why it is not
//! - [`difference`]: two scans side by side
//! - [`baseline`]: hazards that are known already
//! - [`assessment`]: what people decided about hazards
//! - [`csv`], [`junit`], [`sarif`]: the hazards for other tools
//! - [`assumptions`]: what every report rests on beside its obligations
//! - [`page`]: the report that one looks at
//! - [`words`]: every sentence that it shows
//! - [`worked`]: controls that are worked on the way to a hazard
//! - [`explanation`]: a hazard in plain words and with all its numbers
//! - [`does`]: what people do in an action, in words
//! - [`forces`], [`formula`]: both forces of a hazard; what happens at a contact and how its force comes about
//! - [`advice`]: changes of a cell, and what came of them
//! - [`verified`]: what became of known hazards
//! - [`trace`]: what an FMU gets during a hazard
//! - `mcap`, `foxglove`: a hazard as a recording for Foxglove and PlotJuggler (feature `mcap`)
//! - [`distance`]: safeguards and their distances
//! - [`share`]: how much of the robots' cycle a search from the start met
//! - [`speeds`]: told speeds that are not those of the motion
//! - [`covered`]: what a search covered, in sentences
//! - [`headline`]: what was found, and of what that is said
//! - `resting`: what a result rests on, in words
//! - [`terminal`], [`view`]: the table on the terminal, and how it is shown
//! - [`figures`]: figures in words
//! - [`topview`]: an SVG of the cell from above with one hazard in it
//! - [`anywhere`]: what is known of people who come from anywhere
//! - [`whole`], [`floorplan`]: the floor for these, as data and as an SVG
//! - [`survey`], [`survey_pictures`], [`survey_page`]: many scans together, as data, as SVG and as a page

pub(crate) mod assessment;
pub(crate) mod assumptions;
pub(crate) mod baseline;
mod columns;
pub(crate) mod covered;
pub(crate) mod csv;
pub(crate) mod difference;
pub(crate) mod distance;
pub(crate) mod does;
pub(crate) mod explanation;
pub(crate) mod floorplan;
pub(crate) mod foxglove;
pub(crate) mod from_anywhere;
pub(crate) mod junit;
pub(crate) mod mcap;
pub mod page;
mod resting;
pub(crate) mod sarif;
pub(crate) mod survey;
pub(crate) mod survey_page;
pub(crate) mod survey_pictures;
pub(crate) mod terminal;
pub(crate) mod topview;
pub(crate) mod trace;
pub(crate) mod verified;
pub(crate) mod view;
pub(crate) mod whole;
pub(crate) mod words;

pub use columns::columns;
