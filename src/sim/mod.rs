//! What both searches ask of a cell at many instants.
//!
//! - [`expansion`]: all actions from many states at once, on all cores
//! - [`journal`]: what such a search has worked out, on disk
//! - [`answers`]: the same of several machines that share one search out
//! - [`anywhere`]: where people may be who come from anywhere

pub(crate) mod answers;
pub mod anywhere;
pub mod expansion;
pub(crate) mod journal;

pub use fmi_hazard_simulation::*;
