//! What both searches ask of a cell at many instants.
//!
//! - [`expansion`]: all actions from many states at once, on all cores
//! - [`anywhere`]: where people may be who come from anywhere
//! - [`answers`]: what either search has worked out, to go on with and for several machines that share one search out

pub mod answers;
pub mod anywhere;
pub mod expansion;

pub use fmi_hazard_simulation::*;
