//! The models: one for all workcells, which are data; one for the parts of a coupled cell; one that misbehaves; one with
//! all that can be set wrongly.

pub mod coupled;
pub mod faulty;
pub mod guarded;
pub mod workcell;
