//! The models: one for all workcells, which are data; one for the parts of a coupled cell; one that misbehaves.

pub mod coupled;
pub mod faulty;
pub mod workcell;
