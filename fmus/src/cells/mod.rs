//! The models: one for all workcells, which are data; one for the parts of a coupled cell; two that misbehave.

pub mod coupled;
pub mod faulty;
pub mod liar;
pub mod workcell;
