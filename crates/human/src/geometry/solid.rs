//! The shape of a robot link placed in the world: a capsule (closed form), a convex hull (parry) or the
//! surface of a mesh.
//!
//! Everything that is asked of it is a distance from a line segment, because human limbs are segments with a radius.

use std::f64::consts::TAU;

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

    /// The same where they are apart; how deep a segment that meets a hull is in it is not told: it only touches.
    #[must_use]
    pub(crate) fn segment_gap(&self, a: Vec3, b: Vec3) -> Closest {
        match self {
            Self::Hull(hull) => hull.segment_gap(a, b),
            Self::Capsule(_) | Self::Mesh(_) => self.segment_distance(a, b),
        }
    }

    /// Whether the segment between `a` and `b` is no farther than `far_m` from the link, m.
    #[must_use]
    pub fn is_within(&self, far_m: f64, a: Vec3, b: Vec3) -> bool {
        match self {
            Self::Hull(hull) if hull.is_cut() => {
                hull.at_least(a, b) <= far_m && hull.within(a, b, far_m).is_ok_and(|near| near.distance <= far_m)
            }
            _ => self.segment_distance(a, b).distance <= far_m,
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

    /// Whether a point is inside, or on the surface.
    #[must_use]
    pub fn holds(&self, point: Vec3) -> bool {
        match self {
            Self::Hull(hull) => hull.holds(point),
            Self::Capsule(_) | Self::Mesh(_) => self.point_distance(point).distance <= 0.0,
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

    /// The corners of a box along the axes around the link.
    #[must_use]
    pub fn bounds(&self) -> (Vec3, Vec3) {
        match self {
            Self::Capsule(link) => {
                let around = Vec3::splat(link.radius);
                (link.a.min(link.b) - around, link.a.max(link.b) + around)
            }
            Self::Hull(hull) => {
                let far = |sign: f64| Vec3::AXES.map(|axis| sign * hull.reach_along(axis * sign));
                (Vec3::from_array(far(-1.0)), Vec3::from_array(far(1.0)))
            }
            Self::Mesh(_) => {
                let (centre, radius) = self.bounding_sphere();
                (centre - Vec3::splat(radius), centre + Vec3::splat(radius))
            }
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

    /// The link with everything that is no farther than `by_m` from it.
    #[must_use]
    pub fn grown(&self, by_m: f64) -> Self {
        match self {
            Self::Capsule(link) => Self::Capsule(Capsule { radius: link.radius + by_m, ..*link }),
            Self::Hull(hull) => Self::Hull(hull.grown(by_m)),
            Self::Mesh(mesh) => Self::Mesh(mesh.grown(by_m)),
        }
    }

    /// Whether some of the link may be no farther than `reach_m` from a point, m: of others than capsules, some of what is around them.
    #[must_use]
    pub fn is_nearer_than(&self, reach_m: f64, point: Vec3) -> bool {
        match self {
            Self::Capsule(link) => point_segment(point, link.a, link.b).distance <= reach_m + link.radius,
            solid @ (Self::Hull(_) | Self::Mesh(_)) => {
                let (middle, radius) = solid.bounding_sphere();
                (middle - point).length() <= reach_m + radius
            }
        }
    }

    /// No point of the link is farther from where it is in another placement of the same shape, m.
    #[must_use]
    pub fn moved_from(&self, other: &Self) -> f64 {
        let ((to, radius), (from, _)) = (self.bounding_sphere(), other.bounding_sphere());
        let turned = |to: Pose, from: Pose| {
            let angle = (to.rotation * from.rotation.inverse()).to_axis_angle().1;
            angle.min(TAU - angle)
        };
        match (self, other) {
            (Self::Capsule(a), Self::Capsule(b)) => (a.a - b.a).length().max((a.b - b.b).length()),
            (Self::Hull(a), Self::Hull(b)) => (to - from).length() + radius * turned(a.pose(), b.pose()),
            (Self::Mesh(a), Self::Mesh(b)) => (to - from).length() + radius * turned(a.pose(), b.pose()),
            _ => f64::INFINITY,
        }
    }

    /// Whether the line between any two of its points stays inside: then the signed distance is convex, and the nearest
    /// point moves no farther than what it is near to.
    #[must_use]
    pub(crate) const fn is_convex(&self) -> bool {
        !matches!(self, Self::Mesh(_))
    }

    /// Whether it is a capsule.
    #[must_use]
    pub const fn is_capsule(&self) -> bool {
        matches!(self, Self::Capsule(_))
    }

    /// A ball that holds the nearest point for every point within `movement` of `point`, whose nearest point now is
    /// `near`; of points inside, themselves.
    #[must_use]
    pub(crate) fn nearest_within(&self, point: Vec3, near: &Closest, movement: f64) -> (Vec3, f64) {
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

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::geometry::surface::{Surface, Triangles};
    use crate::geometry::{rotation_about, test_meshes};

    /// A long box as a hull and as a mesh, with its corners, and a capsule with its ends.
    fn shapes() -> [(Solid, Vec<Vec3>); 3] {
        let (points, triangles) = test_meshes::cuboid([-0.3, -0.2, -0.1], [0.3, 0.2, 0.1]);
        let corners: Vec<Vec3> = points.into_iter().map(Vec3::from_array).collect();
        let hull = Solid::Hull(Hull::from_points(&corners).unwrap());
        let surface = Surface::new(Triangles::merged(&corners, &triangles)).unwrap();
        let mesh = Solid::Mesh(Mesh::new(Arc::new(surface), Pose::IDENTITY));
        let ends = vec![Vec3::new(-0.3, 0.0, 0.1), Vec3::new(0.2, 0.1, 0.0)];
        let capsule = Solid::Capsule(Capsule { a: ends[0], b: ends[1], radius: 0.05 });
        [(hull, corners.clone()), (mesh, corners), (capsule, ends)]
    }

    fn vectors() -> impl FnMut(f64) -> Vec3 {
        let mut random = Pcg64::seed_from_u64(3);
        move |size| {
            let mut unit = || (f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0) * size;
            Vec3::new(unit(), unit(), unit())
        }
    }

    /// The nearest point of what is grown is on its surface, and where the signed distance says.
    #[test]
    fn what_is_grown_is_nearer_by_as_much() {
        let mut vector = vectors();
        for (solid, _) in shapes() {
            let grown = solid.grown(0.03).placed(Pose::from_parts(Vec3::X, rotation_about(Vec3::Z, 1.0)));
            let solid = solid.placed(Pose::from_parts(Vec3::X, rotation_about(Vec3::Z, 1.0)));
            assert!((grown.bounding_sphere().1 - solid.bounding_sphere().1 - 0.03).abs() < 1e-12);
            for _ in 0..2000 {
                let [a, b] = [(); 2].map(|()| Vec3::X + vector(0.5));
                assert!(grown.at_least(a, b) <= grown.segment_distance(a, b).distance + 1e-9);
                for [one, other] in [
                    [solid.point_distance(a), grown.point_distance(a)],
                    [solid.segment_distance(a, b), grown.segment_distance(a, b)],
                ] {
                    assert!((one.distance - other.distance - 0.03).abs() < 1e-9, "{one:?} {other:?}");
                    if one.distance.abs() > 1e-6 {
                        let apart = (other.on_first - other.on_second).length();
                        assert!((apart - other.distance.abs()).abs() < 1e-6, "{one:?} {other:?}");
                    }
                }
                // And a point within a movement has its nearest one in the ball that is told.
                let (near, by) = (grown.point_distance(a), vector(0.02));
                let (centre, radius) = grown.nearest_within(a, &near, by.length());
                let moved = grown.point_distance(a + by);
                let point = if moved.distance > 0.0 { moved.on_second } else { a + by };
                assert!((point - centre).length() <= radius + 1e-9, "{near:?} {moved:?}");
            }
        }
    }

    /// 0.5 m beyond a corner, seen from the middle of the box, the corner is in reach of 0.51 m, and so some of the link is.
    #[test]
    fn a_link_is_near_where_some_of_it_is() {
        for (solid, corners) in shapes() {
            for corner in corners {
                let point = corner + corner.normalize() * 0.5;
                assert!(solid.is_nearer_than(0.51, point), "{solid:?} {point}");
            }
            // None of it is farther than 0.4 m from the middle.
            assert!(!solid.is_nearer_than(1.0, Vec3::X * 2.0), "{solid:?}");
        }
    }

    /// No corner is farther from where it was, and some turns are told with little to spare.
    #[test]
    fn nothing_moves_farther_than_told() {
        let mut vector = vectors();
        for (solid, corners) in shapes() {
            let mut tightest = f64::INFINITY;
            for _ in 0..500 {
                let place = |vector: &mut dyn FnMut(f64) -> Vec3| {
                    Pose::from_parts(vector(0.1), rotation_about(vector(1.0).normalize(), vector(0.5).x))
                };
                let (one, other) = (place(&mut vector), place(&mut vector));
                let moved = corners.iter().map(|at| (one * *at - other * *at).length()).fold(0.0, f64::max);
                let told = solid.placed(one).moved_from(&solid.placed(other));
                assert!(moved <= told + 1e-9, "{moved} {told}");
                tightest = tightest.min(told / moved);
            }
            assert!(tightest < 1.1, "{tightest}");
        }
    }
}
