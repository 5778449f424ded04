//! The simple shapes: capsules, of which humans and many robot links are made, and boxes, of which obstacles are.

use super::{Rotation, Vec3};

/// All points within `radius` of the segment from `a` to `b`; a sphere when `a == b`. Metres.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Capsule {
    /// One end of the core segment.
    pub a: Vec3,
    /// The other end of the core segment.
    pub b: Vec3,
    /// Radius around the core segment.
    pub radius: f64,
}

/// A box placed anywhere: `centre`, half edge lengths along its own axes, and the rotation from its axes to the world.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cuboid {
    /// Centre in world coordinates.
    pub centre: Vec3,
    /// Half edge lengths along the box's own x, y and z axes.
    pub half: Vec3,
    /// `world_from_box` rotation.
    pub rotation: Rotation,
}
