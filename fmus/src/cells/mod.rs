//! The models: one for all workcells, which are data; one for the parts of a coupled cell; two that misbehave; and one whose
//! safety controller can be set to do badly.

pub mod coupled;
pub mod faulty;
pub mod gantry;
pub mod liar;
pub mod workcell;
