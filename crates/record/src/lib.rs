//! Plain records of results: what stands in `scan.json` and beside it, below all that fills them and all that shows them.
//!
//! - [`model`]: the result of a scan
//! - [`hazard`], [`cause`]: a hazard in it; hazards that are one flaw
//! - [`judged`]: how a hazard was judged where another criterion counts than the transient force
//! - [`forces`], [`formula`], `other_criteria`: its forces, and how they come about, in words
//! - [`worked`]: controls that are worked on the way to a hazard
//! - [`advice`]: changes of a cell, and what came of them
//! - [`certificate`], [`coverage`]: what a search of all sequences came to; what any search has seen
//! - [`share`]: how much of the robots' cycle a search from the start met
//! - [`anywhere`]: what is known of people who come from anywhere
//! - [`speeds`]: told speeds that are not those of the motion
//! - [`people`], [`criteria`], [`begin`]: who is in the cell, what counts as unsafe, where and when a person begins
//! - [`headline`]: what was found, and of what that is said
//! - [`recorded`]: a result read back
//! - [`looks`], [`narrower`]: what a scan looks for, and whether that is as much as an earlier one did
//! - [`figures`], [`paragraph`]: figures and paragraphs as people read them

pub mod advice;
pub mod anywhere;
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
pub mod looks;
pub mod model;
pub mod narrower;
mod other_criteria;
pub mod paragraph;
pub mod people;
pub mod recorded;
pub mod share;
pub mod speeds;
pub mod worked;

use fmi_hazard_human::{human, standards};
use fmi_hazard_outcome as obligations;
