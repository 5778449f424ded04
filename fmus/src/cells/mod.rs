//! The models, one file each.

pub mod faulty;
pub mod safety_fence;
