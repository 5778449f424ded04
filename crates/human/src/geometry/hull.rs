//! A convex hull placed in the world: its distances, depths and speeds.
//!
//! A hull of many corners, which is a mesh's, is also cut into slabs across its longest side: together they are the hull, and each is small
//! enough for what is told of its surroundings to be tight.

use std::sync::Arc;

use parry3d_f64::shape::ConvexPolyhedron;

use super::distance::{beyond, segment_segment};
use super::polyhedron::{Nearest, Polyhedron};
use super::samples::Samples;
use super::slabs::Slabs;
use super::{Capsule, Closest, Pose, Vec3};

/// A convex polyhedron shared between placements, with where it is.
#[derive(Clone, Debug)]
pub struct Hull {
    shape: Arc<Polyhedron>,
    slabs: Slabs,
    is_cut: bool,
    pose: Pose,
    /// The capsule around it where it stands.
    around: Capsule,
    /// What is no farther from it than this belongs to it, m.
    margin_m: f64,
}

impl Hull {
    /// The convex hull of points in the link's own frame, not yet moved; `None` when they do not span a volume.
    #[must_use]
    pub fn from_points(points: &[Vec3]) -> Option<Self> {
        Polyhedron::around(points).map(|shape| Self::new(Arc::new(shape)))
    }

    fn new(shape: Arc<Polyhedron>) -> Self {
        let (slabs, around) = (Slabs::of(&shape), shape.around);
        Self { shape, is_cut: !slabs.all.is_empty(), slabs, pose: Pose::IDENTITY, around, margin_m: 0.0 }
    }

    /// The slabs that it is cut into, where they stand: they hold it, and a millimetre more at most; none of a hull of few corners.
    pub(crate) fn slabs(&self) -> impl Iterator<Item = Self> {
        let slab = |shape: &Arc<Polyhedron>| Self {
            shape: Arc::clone(shape),
            slabs: Slabs::default(),
            is_cut: true,
            pose: Pose::IDENTITY,
            around: shape.around,
            margin_m: self.margin_m + self.slabs.margin_m,
        };
        self.slabs.all.iter().map(move |shape| slab(shape).placed(self.pose))
    }

    /// Whether it has so many corners that it is cut into slabs, or is one of them.
    #[must_use]
    pub(crate) const fn is_cut(&self) -> bool {
        self.is_cut
    }

    /// How far it reaches along a direction, from the origin, m: nothing of it is beyond.
    #[must_use]
    pub fn reach_along(&self, direction: Vec3) -> f64 {
        let along = self.shape.reach(self.pose.rotation.inverse() * direction);
        along + direction.dot(self.pose.translation) + self.margin_m
    }

    /// The corner that is outermost along a direction, without what it is grown by.
    #[must_use]
    pub fn outermost(&self, direction: Vec3) -> Vec3 {
        self.pose * self.shape.support(self.pose.rotation.inverse() * direction)
    }

    /// Its corners, without what it is grown by.
    pub(crate) fn corners(&self) -> impl Iterator<Item = Vec3> {
        self.shape.corners().iter().map(|corner| self.pose * *corner)
    }

    /// What it is grown by, m.
    #[must_use]
    pub(crate) const fn margin_m(&self) -> f64 {
        self.margin_m
    }

    /// The polyhedron in its own frame.
    #[must_use]
    pub fn shape(&self) -> &ConvexPolyhedron {
        self.shape.convex()
    }

    /// Points of its surface that were worked out before.
    pub(super) fn sampled(&self) -> &Samples {
        &self.shape.sampled
    }

    /// `world_from_local` of the polyhedron.
    #[must_use]
    pub const fn pose(&self) -> Pose {
        self.pose
    }

    /// The hull moved by `pose`.
    pub(super) fn placed(&self, pose: Pose) -> Self {
        let pose = pose * self.pose;
        let Capsule { a, b, radius } = self.shape.around;
        Self { pose, around: Capsule { a: pose * a, b: pose * b, radius }, ..self.clone() }
    }

    /// The hull with everything that is no farther than `by_m` from it.
    pub(super) fn grown(&self, by_m: f64) -> Self {
        Self { margin_m: self.margin_m + by_m, ..self.clone() }
    }

    /// The distance from the segment between `a` and `b` is at least this, m.
    pub(super) fn at_least(&self, a: Vec3, b: Vec3) -> f64 {
        self.bare_at_least(a, b) - self.margin_m
    }

    /// The same of the polyhedron.
    fn bare_at_least(&self, a: Vec3, b: Vec3) -> f64 {
        let beyond = segment_segment(a, b, self.around.a, self.around.b).distance - self.around.radius;
        if !self.is_cut {
            return beyond;
        }
        let [a, b] = [a, b].map(|end| self.pose.inverse_transform_point(end));
        beyond.max(self.shape.at_least(a, b) - ROUNDING_M)
    }

    /// Centre and radius of a sphere around it, world.
    pub(super) fn sphere(&self) -> (Vec3, f64) {
        let (centre, radius) = self.shape.sphere;
        (self.pose * centre, radius + self.margin_m)
    }

    pub(super) fn point_distance(&self, point: Vec3) -> Closest {
        beyond(self.bare_point_distance(point), self.margin_m)
    }

    pub(super) fn segment_distance(&self, a: Vec3, b: Vec3) -> Closest {
        beyond(self.bare_segment_distance(a, b), self.margin_m)
    }

    /// Where the segment between `a` and `b` is nearest; what meets the hull is as deep as what touches it. Of one that is farther than
    /// `far_m`, a unit vector along which it is.
    pub(crate) fn within(&self, a: Vec3, b: Vec3, far_m: f64) -> Result<Closest, Vec3> {
        let touching = Closest { distance: 0.0, on_first: a, on_second: a };
        let bare = if (b - a).length_squared() < SHORT_M2 {
            Some(self.bare_point_distance(a)).filter(|near| near.distance > 0.0)
        } else {
            match self.shape.nearest(&self.pose, [a, b], far_m + self.margin_m) {
                Nearest::Beyond(along) => return Err(along),
                Nearest::Separate(on_first, on_second) => Some(closest(on_first, on_second)),
                Nearest::Intersecting => None,
            }
        };
        Ok(beyond(bare.unwrap_or(touching), self.margin_m))
    }

    /// The same as the distance where they are apart; what meets the hull is as deep as what touches it.
    pub(super) fn segment_gap(&self, a: Vec3, b: Vec3) -> Closest {
        let touching = Closest { distance: 0.0, on_first: a, on_second: a };
        beyond(self.apart(a, b).unwrap_or(touching), self.margin_m)
    }

    /// What of the segment between `a` and `b` is inside, of one that meets the hull: its ends.
    #[must_use]
    pub(crate) fn inside(&self, a: Vec3, b: Vec3) -> [Vec3; 2] {
        let [from, to] = [a, b].map(|end| self.pose.inverse_transform_point(end));
        let [enters, leaves] = self.shape.inside(from, to, self.margin_m);
        [enters, leaves].map(|part| a + (b - a) * part)
    }

    /// Whether a point is inside, or on the surface: told sooner than how deep it is.
    pub(super) fn holds(&self, point: Vec3) -> bool {
        if self.at_least(point, point) > 0.0 {
            return false;
        }
        if !self.is_cut {
            return self.point_distance(point).distance <= 0.0;
        }
        let local = self.pose.inverse_transform_point(point);
        self.shape.outside(local).is_none_or(|on| (on - local).length() <= self.margin_m)
    }

    fn bare_point_distance(&self, point: Vec3) -> Closest {
        let local = self.pose.inverse_transform_point(point);
        let outside =
            |on: Vec3| Closest { distance: (on - local).length(), on_first: point, on_second: self.pose * on };
        let inside = |(normal, depth): (Vec3, f64)| Closest {
            distance: -depth,
            on_first: point,
            on_second: self.pose * (local + normal * depth),
        };
        if self.is_cut() {
            // Many faces: they are looked at only where the point is inside.
            return self.shape.outside(local).map_or_else(|| inside(self.shape.shallowest(local, local)), outside);
        }
        if self.bare_at_least(point, point) <= 0.0 {
            let way_out = self.shape.shallowest(local, local);
            if way_out.1 >= 0.0 {
                return inside(way_out);
            }
        }
        outside(self.shape.nearest_to(local))
    }

    fn bare_segment_distance(&self, a: Vec3, b: Vec3) -> Closest {
        if (b - a).length_squared() < SHORT_M2 {
            return self.bare_point_distance(a);
        }
        self.apart(a, b).unwrap_or_else(|| {
            let [a, b] = [a, b].map(|end| self.pose.inverse_transform_point(end));
            let (depth, on, normal) = self.shape.depth(a, b);
            // By rounding, what just touches may have no depth.
            let depth = depth.max(0.0);
            Closest { distance: -depth, on_first: self.pose * on, on_second: self.pose * (on + normal * depth) }
        })
    }

    /// Where the polyhedron and the segment are nearest; nothing if they meet.
    fn apart(&self, a: Vec3, b: Vec3) -> Option<Closest> {
        if (b - a).length_squared() < SHORT_M2 {
            return Some(self.bare_point_distance(a)).filter(|near| near.distance > 0.0);
        }
        match self.shape.nearest(&self.pose, [a, b], f64::MAX) {
            Nearest::Separate(on_first, on_second) => Some(closest(on_first, on_second)),
            Nearest::Beyond(_) | Nearest::Intersecting => None,
        }
    }
}

fn closest(on_first: Vec3, on_second: Vec3) -> Closest {
    Closest { distance: (on_first - on_second).length(), on_first, on_second }
}

/// More than going to another frame rounds by, m.
const ROUNDING_M: f64 = 1e-9;

/// The square of a length below which a segment is a point.
const SHORT_M2: f64 = 1e-18;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::segment_cuboid::segment_cuboid;
    use crate::geometry::{Cuboid, Rotation, Solid, rotation_about};

    /// Numbers in -1 to 1 that repeat themselves.
    fn numbers(seed: u64) -> impl FnMut() -> f64 {
        let mut state = seed;
        move || {
            state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
            f64::from(u32::try_from(state >> 33).unwrap()) / f64::from(1_u32 << 30) - 1.0
        }
    }

    fn point(next: &mut impl FnMut() -> f64) -> Vec3 {
        Vec3::new(next(), next(), next())
    }

    /// Of hulls of few and of many corners, and of what is grown.
    #[test]
    fn it_holds_what_is_at_no_distance() {
        let mut next = numbers(17);
        for corners in [8, 60, 900] {
            let points: Vec<Vec3> = (0..corners).map(|_| point(&mut next).normalize() * 0.3).collect();
            let hull = Hull::from_points(&points).unwrap();
            let mut held = 0;
            for hull in [hull.clone(), hull.grown(0.05)] {
                let hull = hull.placed(Pose::from_parts(Vec3::new(0.3, -0.2, 1.0), rotation_about(Vec3::X, 0.7)));
                for _ in 0..2000 {
                    let at = hull.sphere().0 + point(&mut next) * 0.4;
                    assert_eq!(hull.holds(at), hull.point_distance(at).distance <= 0.0, "{corners} corners, {at}");
                    held += usize::from(hull.holds(at));
                }
            }
            assert!(held > 100 && held < 3900, "{held}");
        }
    }

    /// The depth of a segment by trying directions: no way out is shorter than the shortest, and near the shortest there
    /// is one of those tried.
    fn tried(points: &[Vec3], a: Vec3, b: Vec3) -> f64 {
        let mut best = f64::INFINITY;
        let out = |n: Vec3| {
            let reach = points.iter().map(|p| n.dot(*p)).fold(f64::NEG_INFINITY, f64::max);
            reach - n.dot(a).min(n.dot(b))
        };
        let mut direction = Vec3::Z;
        for i in 0..200_u32 {
            for j in 0..400_u32 {
                let (polar, around) = (f64::from(i) * 0.0158, f64::from(j) * 0.01571);
                let n = {
                    let ((low, high), (y, x)) = (libm::sincos(polar), libm::sincos(around));
                    Vec3::new(low * x, low * y, high)
                };
                if out(n) < best {
                    (best, direction) = (out(n), n);
                }
            }
        }
        // Downhill from there.
        let mut step = 0.02;
        while step > 1e-9 {
            let aside = direction.any_orthonormal_vector();
            // Down a narrow valley only few ways lead.
            let ways = (0..64).map(|n| rotation_about(direction, f64::from(n) * 0.098_175) * aside);
            let next: Vec<Vec3> = ways.map(|way| (direction + way * step).normalize()).collect();
            match next.into_iter().min_by(|m, n| out(*m).total_cmp(&out(*n))).filter(|n| out(*n) < best) {
                Some(n) => (best, direction) = (out(n), n),
                None => step *= 0.7,
            }
        }
        best
    }

    #[test]
    fn depths_are_the_shortest_way_out() {
        let mut next = numbers(7);
        let mut deep = 0;
        for _ in 0..40 {
            let points: Vec<Vec3> = (0..12).map(|_| point(&mut next) * Vec3::new(0.3, 0.2, 0.1)).collect();
            let hull = Solid::Hull(Hull::from_points(&points).unwrap());
            let place = Pose::from_parts(point(&mut next), rotation_about(point(&mut next).normalize(), next()));
            let (a, b) = (point(&mut next) * 0.3, point(&mut next) * 0.3);
            let near = hull.placed(place).segment_distance(place * a, place * b);
            if near.distance > 0.0 {
                continue;
            }
            let expected = tried(&points, a, b);
            assert!(-near.distance <= expected + 1e-9, "{} is too deep: {expected}", near.distance);
            assert!(-near.distance >= expected - 1e-5, "{} is not deep enough: {expected}", near.distance);
            assert!(((near.on_second - near.on_first).length() + near.distance).abs() < 1e-9);
            deep += 1;
        }
        assert!(deep > 10, "{deep}");
    }

    #[test]
    fn what_files_bring_has_depths_too() {
        // Corners as in files, rounded to 32 bits, many in one face: boxes as grids of points, and prisms with rings.
        let mut next = numbers(5);
        for round in 0..60 {
            let place = Pose::from_parts(point(&mut next), rotation_about(point(&mut next).normalize(), 3.0 * next()));
            let grid =
                (0..60).map(|n| Vec3::new(f64::from(n % 5) * 0.1, f64::from(n / 5 % 3) * 0.1, f64::from(n / 15) * 0.1));
            let ring = (0..72).map(|n| {
                let (y, x) = libm::sincos(f64::from(n % 24) * 0.261_799_387_799_149_4);
                Vec3::new(0.2 + 0.1 * x, 0.1 + 0.1 * y, f64::from(n / 24) * 0.15)
            });
            let points: Vec<Vec3> = if round % 2 == 0 { grid.collect() } else { ring.collect() };
            #[expect(clippy::cast_possible_truncation, reason = "as a file does")]
            let rounded = |p: Vec3| Vec3::from_array((place * p).to_array().map(|v| f64::from(v as f32)));
            let points: Vec<Vec3> = points.into_iter().map(rounded).collect();
            let hull = Hull::from_points(&points).unwrap();
            // Upright in the body, beside an edge of it.
            let (a, b) = (Vec3::new(0.2, 0.03, -0.1), Vec3::new(0.2, 0.03, 0.5));
            let (a, b) = (place * a, place * b);
            // The box's nearest side; of the prism the side that is 7.5 degrees aside: (0.1 - 0.07) cos 7.5.
            let expected = if round % 2 == 0 { 0.03 } else { 0.03 * libm::cos(0.130_899_693_899_574_7) };
            let depth = -hull.segment_distance(a, b).distance;
            assert!((depth - expected).abs() < 1e-6, "{round}: {depth} {expected}");
            let inside = hull.point_distance(place * Vec3::new(0.2, 0.1, 0.15)).distance;
            assert!(inside < -0.09, "{round}: {inside}");
        }
    }

    #[test]
    fn distances_change_by_no_more_than_points_move() {
        let mut next = numbers(11);
        for _ in 0..60 {
            let points: Vec<Vec3> = (0..14).map(|_| point(&mut next) * Vec3::new(0.2, 0.2, 0.05)).collect();
            let hull = Solid::Hull(Hull::from_points(&points).unwrap());
            let (a, b) = (point(&mut next) * 0.25, point(&mut next) * 0.25);
            for _ in 0..40 {
                let by = 0.03;
                let [c, d] = [a, b].map(|end| end + point(&mut next).normalize() * by);
                let [one, other] = [(a, b), (c, d)].map(|(a, b)| hull.segment_distance(a, b).distance);
                assert!((one - other).abs() <= by + 1e-7, "{one} {other}");
                let depth = hull.point_distance(a).distance;
                assert!(one <= depth + 1e-7, "a point of the segment is deeper: {depth}, {one}");
            }
        }
    }

    #[test]
    fn a_long_box_is_as_deep_as_a_box() {
        let half = Vec3::new(0.4, 0.05, 0.1);
        let corners: Vec<Vec3> = (0..8_u8)
            .map(|n| half * Vec3::new(f64::from(n & 1), f64::from(n >> 1 & 1), f64::from(n >> 2)) * 2.0 - half)
            .collect();
        let hull = Solid::Hull(Hull::from_points(&corners).unwrap());
        let cuboid = Cuboid { centre: Vec3::ZERO, half, rotation: Rotation::IDENTITY };
        let mut next = numbers(3);
        for _ in 0..500 {
            let (a, b) = (point(&mut next) * 0.5, point(&mut next) * 0.5);
            let (one, other) = (hull.segment_distance(a, b), segment_cuboid(a, b, &cuboid));
            assert!((one.distance - other.distance).abs() < 1e-6, "{} {}", one.distance, other.distance);
        }
    }
}
