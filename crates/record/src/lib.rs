//! Plain records of results: what stands in `scan.json` and beside it, below all that fills them and all that shows them.
//!
//! - [`model`]: the result of a scan
//! - [`hazard`], [`cause`]: a hazard in it; hazards that are one flaw
//! - [`judged`]: how a hazard was judged where another criterion counts than the transient force
//! - [`forces`], [`formula`], `other_criteria`: its forces, and how they come about, in words
//! - [`operated`]: controls that are operated before a hazard
//! - [`advice`]: changes of a cell, and what came of them
//! - [`certificate`], [`coverage`]: what a search of all sequences came to; what any search has seen
//! - [`share`]: how much of the robots' cycle a search from the start met
//! - [`reachability`]: what is known of people who come from anywhere
//! - [`speeds`]: reported speeds that are not those of the motion
//! - [`people`], [`criteria`], [`begin`]: who is in the cell, what counts as unsafe, where and when a person begins
//! - [`headline`]: what was found, and of what that is said
//! - [`recorded`]: a result read back
//! - [`scan_question`], [`narrower`]: what a scan asks, and whether that is as much as an earlier one asked
//! - [`figures`], [`paragraph`]: figures and paragraphs as people read them

pub mod advice;
pub mod begin;
pub mod cause;
pub mod certificate;
pub mod coverage;
pub mod criteria;
pub mod figures;
#[cfg(any(test, feature = "fixtures"))]
pub mod fixtures;
pub mod forces;
pub mod formula;
pub mod hazard;
pub mod headline;
mod immovable;
pub mod judged;
pub mod model;
pub mod narrower;
pub mod operated;
mod other_criteria;
pub mod paragraph;
pub mod people;
pub mod reachability;
pub mod recorded;
pub mod scan_question;
pub mod share;
pub mod speeds;

use fmi_hazard_human::{human, standards};
use fmi_hazard_outcome as obligations;
