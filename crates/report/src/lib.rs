//! What people and programs read of results. Records in, text out: one file a format.
//!
//! - [`difference`]: two scans side by side
//! - [`baseline`]: hazards that are known already
//! - [`assessment`]: what people decided about hazards
//! - [`csv`], [`junit`], [`sarif`]: the hazards for other tools
//! - [`assumptions`]: what every report rests on beside its obligations
//! - [`page`]: the report that one looks at
//! - [`words`]: every sentence that it shows
//! - [`explanation`]: a hazard in plain words and with all its numbers
//! - [`does`]: what people do in an action, in words
//! - [`verified`]: what became of known hazards
//! - [`trace`]: what an FMU gets during a hazard
//! - [`mcap`], `foxglove`: a hazard as a recording for Foxglove and PlotJuggler
//! - [`from_anywhere`]: what is known of people who come from anywhere, at a terminal
//! - [`distance`]: safeguards and their distances
//! - [`covered`]: what a search covered, in sentences
//! - `basis`: what a result rests on, in words
//! - [`terminal`], [`view`]: the table on the terminal, and how it is shown
//! - [`top_view`]: an SVG of the cell from above with one hazard in it
//! - [`floor_map`], [`floorplan`]: the floor for these, as data and as an SVG
//! - [`survey`], [`survey_charts`], [`survey_page`]: many scans together, as data, as SVG and as a page

pub mod assessment;
pub(crate) mod assumptions;
pub mod baseline;
mod basis;
mod columns;
pub(crate) mod covered;
pub mod csv;
pub mod difference;
pub mod distance;
pub(crate) mod does;
pub mod explanation;
pub mod floor_map;
pub mod floorplan;
pub(crate) mod foxglove;
pub mod from_anywhere;
pub mod junit;
pub mod mcap;
pub mod page;
pub mod sarif;
pub mod survey;
pub mod survey_charts;
pub mod survey_page;
pub mod terminal;
pub mod top_view;
pub mod trace;
pub mod verified;
pub mod view;
pub(crate) mod words;

pub use columns::columns;

use fmi_hazard_criteria as hazard;
use fmi_hazard_human::{geometry, human, standards};
use fmi_hazard_outcome as obligations;
