//! The shape of a robot link placed in the world: a capsule (closed form), a convex hull (parry) or the
//! surface of a mesh.
//!
//! Everything that is asked of it is a distance from a line segment, because human limbs are segments with a radius.

use super::distance::{perpendicular_to, point_segment, segment_segment};
use super::{Capsule, Closest, Hull, Mesh, Pose, Vec3};

/// A robot link where it stands.
#[derive(Clone, Debug)]
pub enum Solid {
    /// A capsule in world coordinates.
    Capsule(Capsule),
    /// A placed convex polyhedron.
    Hull(Hull),
    /// A placed closed surface, the only one that need not be convex.
    Mesh(Mesh),
}

impl Solid {
    /// Signed distance from the segment between `a` and `b` (the first shape, without radius) to the link's surface.
    ///
    /// Negative when the segment enters the link: for a capsule the core distance less the radius, for a hull the
    /// penetration depth, for a mesh the depth of the deepest of some points of the segment. Changes by no more than the
    /// segment's points are moved.
    #[must_use]
    pub fn segment_distance(&self, a: Vec3, b: Vec3) -> Closest {
        match self {
            Self::Capsule(link) => {
                let core = segment_segment(a, b, link.a, link.b);
                surface(core, link.radius, b - a, link.b - link.a)
            }
            Self::Hull(hull) => hull.segment_distance(a, b),
            Self::Mesh(mesh) => mesh.segment_distance(a, b),
        }
    }

    /// The signed distance from the segment between `a` and `b` is at least this, m: soon told for all shapes, and for a
    /// capsule the distance itself.
    #[must_use]
    pub fn at_least(&self, a: Vec3, b: Vec3) -> f64 {
        match self {
            Self::Capsule(_) => self.segment_distance(a, b).distance,
            Self::Hull(hull) => hull.at_least(a, b),
            Self::Mesh(mesh) => mesh.at_least(a, b),
        }
    }

    /// Signed distance from a point to the link's surface, negative inside.
    #[must_use]
    pub fn point_distance(&self, point: Vec3) -> Closest {
        match self {
            Self::Capsule(link) => {
                let core = point_segment(point, link.a, link.b);
                surface(core, link.radius, Vec3::ZERO, link.b - link.a)
            }
            Self::Hull(hull) => hull.point_distance(point),
            Self::Mesh(mesh) => mesh.point_distance(point),
        }
    }

    /// The unit vector from the link to the nearest point of a segment or point, or from inside on outwards: the gradient
    /// of the signed distance where they are nearest. None where they touch, and for a segment that enters a hull or mesh.
    #[must_use]
    pub fn outward(&self, near: &Closest) -> Option<Vec3> {
        let towards = near.on_first - near.on_second;
        match self {
            Self::Hull(_) | Self::Mesh(_) if near.distance <= 0.0 => None,
            _ if near.distance > 0.0 => towards.try_normalize(),
            _ => (-towards).try_normalize(),
        }
    }

    /// Centre and radius of a sphere around the link.
    #[must_use]
    pub fn bounding_sphere(&self) -> (Vec3, f64) {
        match self {
            Self::Capsule(link) => ((link.a + link.b) * 0.5, 0.5 * (link.b - link.a).length() + link.radius),
            Self::Hull(hull) => hull.sphere(),
            Self::Mesh(mesh) => mesh.sphere(),
        }
    }

    /// The link moved by `pose` (`pose * old placement`).
    #[must_use]
    pub fn placed(&self, pose: Pose) -> Self {
        match self {
            Self::Capsule(link) => Self::Capsule(Capsule { a: pose * link.a, b: pose * link.b, radius: link.radius }),
            Self::Hull(hull) => Self::Hull(hull.placed(pose)),
            Self::Mesh(mesh) => Self::Mesh(mesh.placed(pose)),
        }
    }

    /// Whether the line between any two of its points stays inside: then the signed distance is convex, and the nearest
    /// point moves no farther than what it is near to.
    #[must_use]
    pub const fn is_convex(&self) -> bool {
        !matches!(self, Self::Mesh(_))
    }

    /// A ball that holds the nearest point for every point within `movement` of `point`, whose nearest point now is
    /// `near`; of points inside, themselves.
    #[must_use]
    pub fn nearest_within(&self, point: Vec3, near: &Closest, movement: f64) -> (Vec3, f64) {
        match self {
            Self::Mesh(mesh) => mesh.nearest_within(point, near, movement),
            _ if near.distance > 0.0 => (near.on_second, movement),
            _ => (point, movement),
        }
    }
}

/// From the core of a capsule link to its surface.
fn surface(core: Closest, radius: f64, along_first: Vec3, along_second: Vec3) -> Closest {
    let outward =
        (core.on_first - core.on_second).try_normalize().unwrap_or_else(|| perpendicular_to(along_first, along_second));
    Closest { distance: core.distance - radius, on_first: core.on_first, on_second: core.on_second + outward * radius }
}
