//! The interfaces of all example FMUs as tables, and the modelDescription.xml made from them.
//!
//! This folder knows nothing of how a model behaves. The build script includes it as source, therefore paths within
//! it are relative (`super::`).

pub mod description;
pub mod faulty;
pub mod irb1200;
pub mod safety_fence;
pub mod variables;

use variables::Interface;

/// Builds the interfaces of all models, in a fixed order.
pub fn all() -> Vec<Interface> {
    vec![safety_fence::interface(), faulty::interface(), faulty::interface_without_state()]
}
