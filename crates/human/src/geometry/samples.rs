//! Points of a surface, which what has the surface keeps once they were worked out.

use std::sync::{Arc, OnceLock};

use super::Vec3;

/// A point of a surface.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfacePoint {
    /// Where it is, world, m.
    pub at: Vec3,
    /// Unit vector outwards.
    pub outward: Vec3,
}

/// Points of a surface in its own frame that were worked out once, and how far apart, m.
pub(super) type Samples = OnceLock<(f64, Arc<[SurfacePoint]>)>;
