//! The models: one for all workcells, which are data; one for the parts of a coupled cell; one that misbehaves;
//! and one whose safety controller can be set to do badly.

pub mod coupled;
pub mod faulty;
pub mod gantry;
pub mod workcell;
