//! A convex polyhedron in its own frame: how far it reaches, how near a segment is to it, and how deep one is inside.
//!
//! Depths are worked out from faces and edges: parry finds them by expanding a polytope, which may end some millimetres too early.
//! A polyhedron of many corners finds the one that reaches farthest by climbing: it begins at one that is known to be good for such
//! directions, and goes on to a neighbour that reaches farther until there is none. No corner of a convex polyhedron but the farthest has
//! no such neighbour.

use parry3d_f64::query::details::{
    closest_points_support_map_support_map_with_params, local_point_projection_on_support_map,
};
use parry3d_f64::query::gjk::{GJKResult, VoronoiSimplex};
use parry3d_f64::shape::{ConvexPolyhedron, Segment, SupportMap};
use parry3d_f64::transformation::try_convex_hull;
use parry3d_f64::utils::{point_cloud_support_point, point_cloud_support_point_id};

use super::distance::{point_segment, segment_segment};
use super::facing::{Facing, longest};
use super::samples::Samples;
use super::slices::Slices;
use super::{Capsule, Pose, Vec3};
use crate::stop::count_work;

/// See the top of this file.
#[derive(Debug)]
pub(super) struct Polyhedron {
    convex: ConvexPolyhedron,
    /// Outward normal of each face, and how far the polyhedron reaches along it, m.
    faces: Vec<(Vec3, f64)>,
    facing: Facing,
    edges: Vec<Edge>,
    climb: Climb,
    slices: Slices,
    /// The middle of the box along the axes that holds it, and how far the farthest corner is from there, m.
    pub(super) sphere: (Vec3, f64),
    /// A capsule that holds it: what is far from that is far from the polyhedron.
    pub(super) around: Capsule,
    /// Points of its surface.
    pub(super) sampled: Samples,
}

/// Between two faces.
#[derive(Debug)]
struct Edge {
    ends: [Vec3; 2],
    /// The outward normals of both; zero of a face without area.
    normals: [Vec3; 2],
}

/// Neighbours of each corner.
#[derive(Debug)]
struct Climb {
    /// The numbers of all neighbours, corner by corner.
    neighbours: Vec<u32>,
    /// Where those of each corner begin, and where the last end.
    begins: Vec<usize>,
    /// A corner to begin with for each square on the sides of a cube around the origin.
    starts: Vec<u32>,
}

/// How a segment and a polyhedron are to each other.
pub(super) enum Nearest {
    /// Apart: the nearest point of each.
    Separate(Vec3, Vec3),
    /// Farther apart than asked, along this unit vector from the polyhedron to the segment.
    Beyond(Vec3),
    /// They meet.
    Intersecting,
}

/// Of so many corners at most all are looked at: that is as fast.
const FEW: usize = 32;

/// Of so many corners the ones that are outermost along the normals of its faces are climbed to.
const MANY: usize = 512;

/// Squares along an edge of the cube of directions.
const SQUARES: usize = 8;

/// More than placing a shape in a workshop rounds by, m.
const ROUNDING_M: f64 = 1e-9;

/// Sine of the angle below which a segment and an edge are parallel.
const PARALLEL: f64 = 1e-9;

/// Thinner than this is flat, m.
const FLAT_M: f64 = 1e-6;

impl Polyhedron {
    /// The convex hull of points; `None` when they do not span a volume.
    pub(super) fn around(points: &[Vec3]) -> Option<Self> {
        if !span_a_volume(points) {
            return None;
        }
        let (corners, triangles) = try_convex_hull(&different(points)).ok()?;
        let convex = ConvexPolyhedron::from_convex_mesh(corners, &triangles)?;
        Some(Self::new(convex, &triangles))
    }

    fn new(convex: ConvexPolyhedron, triangles: &[[u32; 3]]) -> Self {
        let corners = convex.points();
        let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        for corner in corners {
            low = low.min(*corner);
            high = high.max(*corner);
        }
        let centre = (low + high) * 0.5;
        let radius = corners.iter().map(|corner| (*corner - centre).length()).fold(0.0, f64::max);
        let (climb, slices) = (Climb::new(&convex), Slices::of(corners));
        let reach = |normal: Vec3| match corners.len() {
            // Faces times corners: of thousands each that would take as long as all the rest.
            MANY.. => corners[climb.farthest(corners, normal)].dot(normal),
            _ => corners.iter().map(|point| normal.dot(*point)).fold(f64::NEG_INFINITY, f64::max),
        };
        // Of a face without area there is no normal.
        let normals = convex.faces().iter().filter_map(|face| face.normal.try_normalize());
        let faces: Vec<_> = normals.map(|normal| (normal, reach(normal))).collect();
        let facing = Facing::new(centre, faces.clone());
        let edges = edges(&convex, triangles);
        let around = capsule_around(corners, low, high);
        Self {
            convex,
            faces,
            facing,
            edges,
            climb,
            slices,
            sphere: (centre, radius),
            around,
            sampled: Samples::default(),
        }
    }

    /// As parry has it.
    pub(super) const fn convex(&self) -> &ConvexPolyhedron {
        &self.convex
    }

    /// Its corners.
    pub(super) fn corners(&self) -> &[Vec3] {
        self.convex.points()
    }

    /// The outward normal of each face, and how far the polyhedron reaches along it, m.
    pub(super) fn faces(&self) -> impl Iterator<Item = (Vec3, f64)> {
        self.faces.iter().copied()
    }

    /// The ends of its edges; those between triangles of one face are among them.
    pub(super) fn edges(&self) -> impl Iterator<Item = [Vec3; 2]> {
        self.edges.iter().map(|edge| edge.ends)
    }

    /// The corner that reaches farthest along a direction.
    pub(super) fn support(&self, direction: Vec3) -> Vec3 {
        if self.corners().len() <= FEW {
            count_work(looked_at(self.corners().len()));
            point_cloud_support_point(direction, self.corners())
        } else {
            self.corners()[self.climb.farthest(self.corners(), direction)]
        }
    }

    /// The number of the corner that reaches farthest along a direction.
    pub(super) fn outermost(&self, direction: Vec3) -> usize {
        if self.corners().len() <= FEW {
            count_work(looked_at(self.corners().len()));
            point_cloud_support_point_id(direction, self.corners())
        } else {
            self.climb.farthest(self.corners(), direction)
        }
    }

    /// How far it reaches along a direction, m.
    pub(super) fn reach(&self, normal: Vec3) -> f64 {
        self.support(normal).dot(normal)
    }

    /// The segment from `a` to `b` is no nearer than this, m; soon told.
    pub(super) fn at_least(&self, a: Vec3, b: Vec3) -> f64 {
        self.slices.at_least(a, b)
    }

    /// The nearest points of the segment from `a` to `b`, which is in the frame that the polyhedron stands at `pose` in; those farther
    /// apart than `far_m` are soon told.
    pub(super) fn nearest(&self, pose: &Pose, [a, b]: [Vec3; 2], far_m: f64) -> Nearest {
        let begin = (self.corners().len() > FEW).then(|| {
            let [a, b] = [a, b].map(|end| pose.inverse_transform_point(end));
            let near = segment_segment(a, b, self.around.a, self.around.b);
            pose.rotation * (near.on_second - near.on_first)
        });
        let (segment, mut simplex) = (Segment::new(a, b), VoronoiSimplex::new());
        let found =
            closest_points_support_map_support_map_with_params(pose, &segment, self, far_m, &mut simplex, begin);
        match found {
            // From the polyhedron's frame, as parry gives it elsewhere, to the last bit.
            GJKResult::ClosestPoints(on_segment, on_hull, _) => {
                Nearest::Separate(on_segment, *pose * pose.inverse_transform_point(on_hull))
            }
            GJKResult::NoIntersection(towards) => Nearest::Beyond(-towards),
            _ => Nearest::Intersecting,
        }
    }

    /// The nearest point to one, if that is outside.
    pub(super) fn nearest_to(&self, point: Vec3) -> Vec3 {
        local_point_projection_on_support_map(self, &mut VoronoiSimplex::new(), point, false).point
    }

    /// The nearest point to one that is outside; nothing of one inside.
    pub(super) fn outside(&self, point: Vec3) -> Option<Vec3> {
        let nearest = local_point_projection_on_support_map(self, &mut VoronoiSimplex::new(), point, true);
        (!nearest.is_inside).then_some(nearest.point)
    }

    /// Where the line from `a` to `b` enters what is no farther than `margin_m` behind each face, and where it leaves that, as parts of
    /// the line.
    pub(super) fn inside(&self, a: Vec3, b: Vec3, margin_m: f64) -> [f64; 2] {
        let (mut enters, mut leaves) = (0.0_f64, 1.0_f64);
        self.facing.beyond(a, b, |from, to| {
            let (from, to) = (from - margin_m, to - margin_m);
            if from > 0.0 && to < from {
                enters = enters.max(from / (from - to));
            }
            if to > 0.0 && from < to {
                leaves = leaves.min(from / (from - to));
            }
        });
        [enters.min(1.0), leaves.max(enters).min(1.0)]
    }

    /// The face through which the way out is shortest for the segment from `a` to `b`: its normal, and how far, m; not
    /// positive if the segment is outside.
    pub(super) fn shallowest(&self, a: Vec3, b: Vec3) -> (Vec3, f64) {
        let out = |(normal, reach): &(Vec3, f64)| (*normal, reach - normal.dot(a).min(normal.dot(b)));
        count_work(looked_at(self.faces.len()));
        let shorter = |one: (Vec3, f64), other: (Vec3, f64)| if other.1 < one.1 { other } else { one };
        self.faces.iter().map(out).fold((Vec3::Z, f64::INFINITY), shorter)
    }

    /// The shortest way out for a segment that meets the polyhedron: how far, m, the point of the segment that then leaves
    /// last, and the way.
    ///
    /// It is the distance of the origin from the surface of the Minkowski difference of the two, whose faces are those of
    /// the polyhedron, moved, and those that the segment spans with edges whose faces turn away to different sides of it. Along any
    /// direction there is a way out: what is spanned and is no face is a longer one.
    pub(super) fn depth(&self, a: Vec3, b: Vec3) -> (f64, Vec3, Vec3) {
        let (normal, depth) = self.shallowest(a, b);
        let last = if normal.dot(a) <= normal.dot(b) { a } else { b };
        let mut best = (depth, last, normal);
        let length = b - a;
        let unit = length.normalize_or_zero();
        count_work(looked_at(self.edges.len()));
        for Edge { ends: [from, to], normals: [one, other] } in &self.edges {
            if one.dot(unit) * other.dot(unit) > PARALLEL {
                continue;
            }
            let along = *to - *from;
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

impl SupportMap for Polyhedron {
    fn local_support_point(&self, direction: Vec3) -> Vec3 {
        self.support(direction)
    }
}

impl Climb {
    fn new(convex: &ConvexPolyhedron) -> Self {
        let corners = convex.points();
        if corners.len() <= FEW {
            return Self { neighbours: Vec::new(), begins: Vec::new(), starts: Vec::new() };
        }
        let mut of_corner = vec![Vec::new(); corners.len()];
        for [a, b] in convex.edges().iter().map(|edge| edge.vertices) {
            of_corner[a as usize].push(b);
            of_corner[b as usize].push(a);
        }
        let mut begins = vec![0];
        for neighbours in &of_corner {
            begins.push(begins[begins.len() - 1] + neighbours.len());
        }
        let neighbours = of_corner.concat();
        let mut this = Self { neighbours, begins, starts: vec![0; 6 * SQUARES * SQUARES] };
        // From square to square they change little.
        let mut at = u32::try_from(point_cloud_support_point_id(middle(0), corners)).unwrap_or(0);
        for number in 0..this.starts.len() {
            at = this.from(corners, at, middle(number));
            this.starts[number] = at;
        }
        this
    }

    fn farthest(&self, corners: &[Vec3], direction: Vec3) -> usize {
        self.from(corners, self.starts[square(direction)], direction) as usize
    }

    /// The number of the corner that reaches farthest, from one on.
    fn from(&self, corners: &[Vec3], start: u32, direction: Vec3) -> u32 {
        let mut at = start;
        let mut best = corners[at as usize].dot(direction);
        loop {
            let neighbours = &self.neighbours[self.begins[at as usize]..self.begins[at as usize + 1]];
            let before = at;
            count_work(looked_at(neighbours.len()));
            for neighbour in neighbours {
                let far = corners[*neighbour as usize].dot(direction);
                if far > best {
                    (best, at) = (far, *neighbour);
                }
            }
            if at == before {
                return at;
            }
        }
    }
}

/// Each of these points once, in their order: files give the corners of each triangle.
fn different(points: &[Vec3]) -> Vec<Vec3> {
    // Zero is zero, whatever its sign.
    let key = |point: &Vec3| point.to_array().map(|value| (value + 0.0).to_bits());
    let mut all: Vec<_> = points.iter().map(key).zip(0_usize..).collect();
    all.sort_unstable();
    all.dedup_by_key(|(key, _)| *key);
    all.sort_unstable_by_key(|(_, number)| *number);
    all.into_iter().map(|(_, number)| points[number]).collect()
}

/// The work to look at so many corners, faces or edges.
const fn looked_at(number: usize) -> usize {
    number.div_ceil(8)
}

/// The number of the square that a direction goes through.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "from 0 to the squares of a side")]
fn square(direction: Vec3) -> usize {
    let along = direction.to_array();
    let axis = (1..3).fold(0, |most, axis| if along[axis].abs() > along[most].abs() { axis } else { most });
    let most = along[axis].abs();
    if most <= 0.0 {
        return 0;
    }
    let line =
        |axis: usize| ((along[axis] / most * 0.5 + 0.5) * SQUARES as f64).clamp(0.0, SQUARES as f64 - 1.0) as usize;
    let side = 2 * axis + usize::from(along[axis] > 0.0);
    (side * SQUARES + line((axis + 1) % 3)) * SQUARES + line((axis + 2) % 3)
}

/// The direction through the middle of a square.
#[expect(clippy::cast_precision_loss, reason = "a few squares")]
fn middle(square: usize) -> Vec3 {
    let side = square / (SQUARES * SQUARES);
    let at = |line: usize| ((line as f64 + 0.5) / SQUARES as f64 - 0.5) * 2.0;
    let mut along = [0.0; 3];
    along[side / 2] = if side % 2 == 1 { 1.0 } else { -1.0 };
    along[(side / 2 + 1) % 3] = at(square / SQUARES % SQUARES);
    along[(side / 2 + 2) % 3] = at(square % SQUARES);
    Vec3::from_array(along)
}

fn edges(convex: &ConvexPolyhedron, triangles: &[[u32; 3]]) -> Vec<Edge> {
    let at = |corner: u32| convex.points()[corner as usize];
    let sorted = |from: u32, to: u32| [from.min(to), from.max(to)];
    let mut beside: Vec<([u32; 2], Vec3)> = Vec::with_capacity(3 * triangles.len());
    for [a, b, c] in triangles {
        let normal = (at(*b) - at(*a)).cross(at(*c) - at(*a)).normalize_or_zero();
        beside.extend([[a, b], [b, c], [c, a]].map(|[from, to]| (sorted(*from, *to), normal)));
    }
    // Those of one edge stay in the order of its triangles.
    beside.sort_by_key(|(ends, _)| *ends);
    let edge = |[from, to]: [u32; 2]| {
        let ends = sorted(from, to);
        let mut normals = beside[beside.partition_point(|(other, _)| *other < ends)..]
            .iter()
            .take_while(|(other, _)| *other == ends)
            .map(|(_, normal)| *normal);
        let mut normal = || normals.next().unwrap_or(Vec3::ZERO);
        Edge { ends: [at(from), at(to)], normals: [normal(), normal()] }
    };
    convex.edges().iter().map(|one| edge(one.vertices)).collect()
}

/// A capsule along the longest side of the box that holds these points, which holds them too.
fn capsule_around(points: &[Vec3], low: Vec3, high: Vec3) -> Capsule {
    let (centre, half) = ((low + high) * 0.5, (high - low) * 0.5);
    let axis = longest(half);
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
    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;

    /// Climbing ends at the corner that looking at all of them finds.
    #[test]
    fn climbing_gets_to_the_farthest_corner() {
        let mut random = Pcg64::seed_from_u64(8);
        let mut unit = || f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0;
        // A ball of corners, and a prism with rings in its mantle, as meshes of arms are.
        let ball: Vec<Vec3> = (0..900).map(|_| Vec3::new(unit(), unit(), unit()).normalize()).collect();
        let turns = (0..400).map(|n| libm::sincos(f64::from(n) * 0.015_707_963_267_948_967));
        let prism: Vec<Vec3> =
            turns.flat_map(|(y, x)| [0.0, 0.3, 1.0].map(|z| Vec3::new(0.1 * x, 0.1 * y, z))).collect();
        for points in [ball, prism] {
            let hull = Polyhedron::around(&points).unwrap();
            assert!(hull.corners().len() > FEW);
            let axes = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z];
            for direction in axes.into_iter().chain((0..2000).map(|_| Vec3::new(unit(), unit(), unit()))) {
                let far = points.iter().map(|point| point.dot(direction)).fold(f64::MIN, f64::max);
                assert!((hull.reach(direction) - far).abs() < 1e-9, "{direction} {far}");
            }
            // Along its faces' normals several corners are as far.
            assert!(hull.corners().len() >= MANY && hull.faces().count() > 100);
            for (normal, reach) in hull.faces() {
                let far = points.iter().map(|point| point.dot(normal)).fold(f64::MIN, f64::max);
                assert!((reach - far).abs() < 1e-12, "{normal} {reach} {far}");
            }
        }
    }
}
