//! A convex hull placed in the world: distances by parry, depths exactly.
//!
//! How far something inside has to be moved to come out is worked out from the hull's faces and edges: parry finds it by
//! expanding a polytope, which may end some millimetres too early.

use std::sync::Arc;

use parry3d_f64::query::{self, ClosestPoints, PointQuery as _};
use parry3d_f64::shape::{ConvexPolyhedron, Segment};

use super::distance::{point_segment, segment_segment};
use super::solid::beyond;
use super::{Capsule, Closest, Pose, Vec3};

/// A convex polyhedron with what its depths follow from, in its own frame.
#[derive(Debug)]
struct Polyhedron {
    convex: ConvexPolyhedron,
    /// Outward normal of each face, and how far the polyhedron reaches along it, m.
    faces: Vec<(Vec3, f64)>,
    /// The ends of each edge.
    edges: Vec<[Vec3; 2]>,
    /// A capsule that holds it: what is far from that is far from the polyhedron.
    around: Capsule,
}

/// A convex polyhedron shared between placements, with where it is.
#[derive(Clone, Debug)]
pub struct Hull {
    shape: Arc<Polyhedron>,
    pose: Pose,
    centre: Vec3,
    radius: f64,
    /// The capsule around it where it stands.
    around: Capsule,
    /// What is no farther from it than this belongs to it, m.
    margin_m: f64,
}

impl Hull {
    /// The convex hull of points in the link's own frame, not yet moved; `None` when they do not span a volume.
    #[must_use]
    pub fn from_points(points: &[Vec3]) -> Option<Self> {
        if !span_a_volume(points) {
            return None;
        }
        ConvexPolyhedron::from_convex_hull(points).map(Self::new)
    }

    fn new(convex: ConvexPolyhedron) -> Self {
        let points = convex.points();
        let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        for point in points {
            low = low.min(*point);
            high = high.max(*point);
        }
        let centre = (low + high) * 0.5;
        let radius = points.iter().map(|point| (*point - centre).length()).fold(0.0, f64::max);
        let reach = |normal: Vec3| points.iter().map(|point| normal.dot(*point)).fold(f64::NEG_INFINITY, f64::max);
        // Of a face without area there is no normal.
        let normals = convex.faces().iter().filter_map(|face| face.normal.try_normalize());
        let faces: Vec<(Vec3, f64)> = normals.map(|normal| (normal, reach(normal))).collect();
        let edges = convex.edges().iter().map(|edge| edge.vertices.map(|corner| points[corner as usize])).collect();
        let around = capsule_around(points, low, high);
        let shape = Arc::new(Polyhedron { convex, faces, edges, around });
        Self { shape, pose: Pose::IDENTITY, centre, radius, around, margin_m: 0.0 }
    }

    /// The polyhedron in its own frame.
    #[must_use]
    pub fn shape(&self) -> &ConvexPolyhedron {
        &self.shape.convex
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
        segment_segment(a, b, self.around.a, self.around.b).distance - self.around.radius
    }

    /// Centre and radius of a sphere around it, world.
    pub(super) fn sphere(&self) -> (Vec3, f64) {
        (self.pose * self.centre, self.radius + self.margin_m)
    }

    pub(super) fn point_distance(&self, point: Vec3) -> Closest {
        beyond(self.bare_point_distance(point), self.margin_m)
    }

    pub(super) fn segment_distance(&self, a: Vec3, b: Vec3) -> Closest {
        beyond(self.bare_segment_distance(a, b), self.margin_m)
    }

    fn bare_point_distance(&self, point: Vec3) -> Closest {
        let local = self.pose.inverse_transform_point(point);
        if self.bare_at_least(point, point) <= 0.0 {
            let (normal, depth) = self.shape.shallowest(local, local);
            if depth >= 0.0 {
                return Closest { distance: -depth, on_first: point, on_second: self.pose * (local + normal * depth) };
            }
        }
        let on = self.shape.convex.project_local_point(local, false).point;
        Closest { distance: (on - local).length(), on_first: point, on_second: self.pose * on }
    }

    fn bare_segment_distance(&self, a: Vec3, b: Vec3) -> Closest {
        if (b - a).length_squared() < 1e-18 {
            return self.bare_point_distance(a);
        }
        let segment = Segment::new(a, b);
        let nearest = query::closest_points(&Pose::IDENTITY, &segment, &self.pose, &self.shape.convex, f64::MAX);
        if let Ok(ClosestPoints::WithinMargin(on_first, on_second)) = nearest {
            return Closest { distance: (on_first - on_second).length(), on_first, on_second };
        }
        let [a, b] = [a, b].map(|end| self.pose.inverse_transform_point(end));
        let (depth, on, normal) = self.shape.depth(a, b);
        // By rounding, what just touches may have no depth.
        let depth = depth.max(0.0);
        Closest { distance: -depth, on_first: self.pose * on, on_second: self.pose * (on + normal * depth) }
    }
}

/// A capsule along the longest side of the box that holds these points, which holds them too.
fn capsule_around(points: &[Vec3], low: Vec3, high: Vec3) -> Capsule {
    let (centre, half) = ((low + high) * 0.5, (high - low) * 0.5);
    let axis = [Vec3::X, Vec3::Y, Vec3::Z]
        .into_iter()
        .fold(Vec3::X, |longest, axis| if half.dot(axis) > half.dot(longest) { axis } else { longest });
    // As thick as it is across; its core is as short as the points allow.
    let across = |point: &Vec3| {
        let off = *point - centre;
        (off - axis * off.dot(axis)).length()
    };
    let least = points.iter().map(across).fold(0.0, f64::max);
    let core = (half.dot(axis) - 0.5 * least).max(0.0);
    let (a, b) = (centre - axis * core, centre + axis * core);
    let radius = points.iter().map(|point| point_segment(*point, a, b).distance).fold(0.0, f64::max);
    // Placing it elsewhere rounds.
    Capsule { a, b, radius: radius + ROUNDING_M }
}

/// More than placing a shape in a workshop rounds by, m.
const ROUNDING_M: f64 = 1e-9;

/// Sine of the angle below which a segment and an edge are parallel.
const PARALLEL: f64 = 1e-9;

impl Polyhedron {
    /// How far it reaches along a direction, m.
    fn reach(&self, normal: Vec3) -> f64 {
        self.convex.points().iter().map(|point| normal.dot(*point)).fold(f64::NEG_INFINITY, f64::max)
    }

    /// The face through which the way out is shortest for the segment from `a` to `b`: its normal, and how far, m; not
    /// positive if the segment is outside.
    fn shallowest(&self, a: Vec3, b: Vec3) -> (Vec3, f64) {
        let out = |(normal, reach): &(Vec3, f64)| (*normal, reach - normal.dot(a).min(normal.dot(b)));
        let shorter = |one: (Vec3, f64), other: (Vec3, f64)| if other.1 < one.1 { other } else { one };
        self.faces.iter().map(out).fold((Vec3::Z, f64::INFINITY), shorter)
    }

    /// The shortest way out for a segment that meets the polyhedron: how far, m, the point of the segment that then leaves
    /// last, and the way.
    ///
    /// It is the distance of the origin from the surface of the Minkowski difference of the two, whose faces are those of
    /// the polyhedron, moved, and some of those that its edges span with the segment. Along any direction there is a way
    /// out: what is spanned and is no face is a longer one.
    fn depth(&self, a: Vec3, b: Vec3) -> (f64, Vec3, Vec3) {
        let (normal, depth) = self.shallowest(a, b);
        let last = if normal.dot(a) <= normal.dot(b) { a } else { b };
        let mut best = (depth, last, normal);
        for [from, to] in &self.edges {
            let (along, length) = (*to - *from, b - a);
            let across = along.cross(length);
            // Of parallels there is none: what rounding leaves points anywhere.
            if across.length() <= PARALLEL * along.length() * length.length() {
                continue;
            }
            for normal in [across.normalize(), -across.normalize()] {
                let low = normal.dot(a).min(normal.dot(b));
                // No corner reaches less far than the edge's.
                if normal.dot(*from) - low >= best.0 {
                    continue;
                }
                let depth = self.reach(normal) - low;
                if depth < best.0 {
                    best = (depth, segment_segment(a, b, *from, *to).on_first, normal);
                }
            }
        }
        best
    }
}

/// Thinner than this is flat, m.
const FLAT_M: f64 = 1e-6;

/// Whether points are in no common plane.
fn span_a_volume(points: &[Vec3]) -> bool {
    let farthest = |distance: &dyn Fn(Vec3) -> f64| {
        let by = |a: &&Vec3, b: &&Vec3| distance(**a).total_cmp(&distance(**b));
        points.iter().max_by(by).map(|point| (*point, distance(*point))).filter(|(_, far)| *far > FLAT_M)
    };
    let Some(&a) = points.first() else { return false };
    let Some((b, length)) = farthest(&|p| (p - a).length()) else { return false };
    let along = (b - a) / length;
    let Some((c, _)) = farthest(&|p| (p - a).cross(along).length()) else { return false };
    let Some(normal) = (c - a).cross(along).try_normalize() else { return false };
    farthest(&|p| (p - a).dot(normal).abs()).is_some()
}

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
