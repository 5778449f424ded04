//! The models: one for all workcells, which are data; one for the parts of a coupled cell; two that misbehave; two whose
//! safeguards can be set to do badly.

pub mod coupled;
pub mod faulty;
pub mod gantry;
pub mod guarded;
pub mod liar;
pub mod workcell;
