//! Triangles as a closed surface: whether it is closed, what is inside, and how far points and segments are from it.
//!
//! What is inside follows from how often a ray leaves the surface less how often it enters: right for hollow bodies, bodies
//! that overlap, and triangles without area, where normals alone would tell the wrong side.

use std::collections::BTreeMap;

use parry3d_f64::bounding_volume::Aabb;
use parry3d_f64::partitioning::{Bvh, BvhBuildStrategy, BvhNode};
use parry3d_f64::query::{Ray, RayCast as _};

use super::samples::Samples;
use super::segment_cuboid::segment_box_local;
use super::triangle::{Corners, nearest_to_point, nearest_to_segment};
use super::{Rotation, Vec3};

/// Triangles between corners that they share, anticlockwise as seen from outside; m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Triangles {
    /// Corners, each once.
    pub points: Vec<Vec3>,
    /// Three different corners each.
    pub triangles: Vec<[u32; 3]>,
}

/// Why triangles are no closed surface.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Flaw {
    /// So many edges have a triangle on one side only.
    Open(usize),
    /// At so many edges neighbours are turned in opposite ways.
    Turned(usize),
    /// It holds no volume.
    Flat,
}

/// Less than a cube of 0.1 mm is no volume, m³.
const NO_VOLUME_M3: f64 = 1e-12;

impl Triangles {
    /// Triangles by indices into `points`: equal points become one; what has no three different corners, or names a point
    /// that is not there, is left out.
    #[must_use]
    pub fn merged(points: &[Vec3], triangles: &[[u32; 3]]) -> Self {
        let mut known: BTreeMap<[u64; 3], u32> = BTreeMap::new();
        let mut merged = Self::default();
        for triangle in triangles {
            let [Some(a), Some(b), Some(c)] = triangle.map(|corner| points.get(corner as usize)) else { continue };
            let corners = [a, b, c].map(|point| {
                // Minus zero is zero.
                let key = point.to_array().map(|value| (value + 0.0).to_bits());
                *known.entry(key).or_insert_with(|| {
                    merged.points.push(*point);
                    u32::try_from(merged.points.len() - 1).unwrap_or(u32::MAX)
                })
            });
            if corners[0] != corners[1] && corners[1] != corners[2] && corners[2] != corners[0] {
                merged.triangles.push(corners);
            }
        }
        merged
    }

    /// The same with every point moved by `place`.
    #[must_use]
    pub fn mapped(&self, place: impl Fn(Vec3) -> Vec3) -> Self {
        Self { points: self.points.iter().map(|point| place(*point)).collect(), triangles: self.triangles.clone() }
    }

    /// The corners of a triangle.
    #[must_use]
    pub(crate) fn corners(&self, triangle: usize) -> Corners {
        self.triangles[triangle].map(|corner| self.points[corner as usize])
    }

    /// The volume inside, m³; negative for a surface that is inside out, without meaning for one that is open.
    #[must_use]
    pub fn volume(&self) -> f64 {
        let Some(origin) = self.points.first() else { return 0.0 };
        let of = |triangle: usize| {
            let [a, b, c] = self.corners(triangle).map(|corner| corner - *origin);
            a.cross(b).dot(c) / 6.0
        };
        (0..self.triangles.len()).map(of).sum()
    }

    /// Adds other triangles.
    pub fn add(&mut self, other: &Self) {
        let before = u32::try_from(self.points.len()).unwrap_or(u32::MAX);
        let points = [self.points.as_slice(), &other.points].concat();
        let more = other.triangles.iter().map(|triangle| triangle.map(|corner| corner.saturating_add(before)));
        let triangles: Vec<[u32; 3]> = self.triangles.iter().copied().chain(more).collect();
        *self = Self::merged(&points, &triangles);
    }

    /// With the other side out.
    #[must_use]
    pub fn turned(mut self) -> Self {
        for triangle in &mut self.triangles {
            triangle.swap(1, 2);
        }
        self
    }

    /// Whether the surface is closed: along every edge as many triangles run one way as the other.
    ///
    /// # Errors
    /// What is wrong with it.
    pub fn closed(&self) -> Result<(), Flaw> {
        // Triangles that run along each edge upwards and downwards.
        let mut edges: BTreeMap<[u32; 2], [usize; 2]> = BTreeMap::new();
        for &[a, b, c] in &self.triangles {
            for (from, to) in [(a, b), (b, c), (c, a)] {
                edges.entry([from.min(to), from.max(to)]).or_default()[usize::from(from > to)] += 1;
            }
        }
        let count = |flaw: fn(&[usize; 2]) -> bool| edges.values().filter(|ways| flaw(ways)).count();
        let open = count(|[up, down]| !(up + down).is_multiple_of(2));
        let turned = count(|[up, down]| up != down);
        match (open, turned) {
            (0, 0) if self.volume().abs() < NO_VOLUME_M3 => Err(Flaw::Flat),
            (0, 0) => Ok(()),
            (0, turned) => Err(Flaw::Turned(turned)),
            (open, _) => Err(Flaw::Open(open)),
        }
    }
}

/// A closed surface in its own frame, m.
#[derive(Clone, Debug)]
pub struct Surface {
    triangles: Triangles,
    /// The corners, in a frame in which the rays go along z.
    along_rays: Vec<Vec3>,
    tree: Bvh,
    low: Vec3,
    high: Vec3,
    centre: Vec3,
    radius: f64,
    /// Points of it.
    pub(super) sampled: Samples,
}

/// `ray_from_local`: a direction in which no machine part has its faces.
const RAY_FROM_LOCAL: Rotation =
    Rotation::from_xyzw(0.365_148_371_670_110_7, 0.547_722_557_505_166_1, 0.0, 0.752_772_652_709_081);

/// Boxes around triangles are this much larger for rays, m, so that rounding makes none miss.
const ROUNDING_M: f64 = 1e-9;

impl Surface {
    /// A surface of triangles; outside is where they enclose nothing, whichever way they are turned.
    ///
    /// # Errors
    /// When they are not closed.
    pub fn new(triangles: Triangles) -> Result<Self, Flaw> {
        triangles.closed()?;
        let triangles = if triangles.volume() < 0.0 { triangles.turned() } else { triangles };
        let (mut low, mut high) = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
        for point in &triangles.points {
            low = low.min(*point);
            high = high.max(*point);
        }
        let centre = (low + high) * 0.5;
        let radius = triangles.points.iter().map(|point| (*point - centre).length()).fold(0.0, f64::max);
        let around = |triangle: usize| {
            let [a, b, c] = triangles.corners(triangle);
            Aabb::new(a.min(b).min(c), a.max(b).max(c))
        };
        let boxes: Vec<Aabb> = (0..triangles.triangles.len()).map(around).collect();
        let tree = Bvh::from_leaves(BvhBuildStrategy::Binned, &boxes);
        let along_rays = triangles.points.iter().map(|point| RAY_FROM_LOCAL * *point).collect();
        Ok(Self { triangles, along_rays, tree, low, high, centre, radius, sampled: Samples::default() })
    }

    /// The triangles, turned outwards.
    #[must_use]
    pub const fn triangles(&self) -> &Triangles {
        &self.triangles
    }

    /// Centre and radius of a sphere around it.
    #[must_use]
    pub(crate) const fn sphere(&self) -> (Vec3, f64) {
        (self.centre, self.radius)
    }

    /// Least and greatest coordinates.
    #[cfg(test)]
    pub(crate) const fn extent(&self) -> (Vec3, Vec3) {
        (self.low, self.high)
    }

    fn corners(&self, leaf: u32) -> Corners {
        self.triangles.corners(leaf as usize)
    }

    /// Whether a point is inside.
    #[must_use]
    pub fn holds(&self, point: Vec3) -> bool {
        if point.cmplt(self.low).any() || point.cmpgt(self.high).any() {
            return false;
        }
        let ray = Ray::new(point, RAY_FROM_LOCAL.inverse() * Vec3::Z);
        let met = |node: &BvhNode| {
            let around = node.aabb();
            let room = Vec3::splat(ROUNDING_M);
            Aabb::new(around.mins - room, around.maxs + room).intersects_local_ray(&ray, f64::MAX)
        };
        let from = RAY_FROM_LOCAL * point;
        self.tree.leaves(met).map(|leaf| self.passed(from, leaf)).sum::<i32>() != 0
    }

    /// Whether the ray along z passes a triangle: 1 on the way out, -1 on the way in. Which side of an edge the ray is on
    /// is the same for both triangles there: it passes one of them.
    fn passed(&self, from: Vec3, leaf: u32) -> i32 {
        let corners = self.triangles.triangles[leaf as usize];
        let at = |corner: u32| self.along_rays[corner as usize];
        let area = |i: u32, j: u32| {
            let (a, b) = (at(i.min(j)) - from, at(i.max(j)) - from);
            let area = a.x * b.y - a.y * b.x;
            if i < j { area } else { -area }
        };
        let [a, b, c] = corners;
        let opposite = [area(b, c), area(c, a), area(a, b)];
        let left = [(b, c), (c, a), (a, b)]
            .into_iter()
            .zip(opposite)
            .map(|((i, j), area)| if i < j { area > 0.0 } else { area >= 0.0 });
        let left = left.filter(|left| *left).count();
        if left != 0 && left != 3 {
            return 0;
        }
        let heights = corners.map(|corner| at(corner).z);
        let [lowest, highest] = [
            heights.iter().copied().fold(f64::INFINITY, f64::min),
            heights.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ];
        let total: f64 = opposite.iter().sum();
        let weighted: f64 = opposite.iter().zip(heights).map(|(area, height)| area * height).sum();
        let height = if total == 0.0 { lowest } else { (weighted / total).clamp(lowest, highest) };
        match (height > from.z, left) {
            (true, 3) => 1,
            (true, _) => -1,
            (false, _) => 0,
        }
    }

    /// The point of the surface that is nearest to a point.
    #[must_use]
    pub(crate) fn nearest(&self, point: Vec3) -> Vec3 {
        let leaf = |leaf: u32, _: f64| {
            let on = nearest_to_point(point, &self.corners(leaf));
            Some(((on - point).length(), on))
        };
        let found = self.tree.find_best(f64::MAX, |node, _| outside(&node.aabb(), point), leaf);
        found.map_or(point, |(_, (_, on))| on)
    }

    /// Distance of a segment from the surface, m, with the nearest points of the one and of the other; zero where they meet.
    #[must_use]
    pub(crate) fn nearest_to_segment(&self, a: Vec3, b: Vec3) -> (f64, Vec3, Vec3) {
        let node = |node: &BvhNode, best: f64| {
            let around = node.aabb();
            // Quickly, and exactly only where that may tell more.
            let quick = (a.min(b) - around.maxs).max(around.mins - a.max(b)).max_element();
            if quick >= best {
                return quick;
            }
            let (centre, half) = ((around.mins + around.maxs) * 0.5, (around.maxs - around.mins) * 0.5);
            segment_box_local(a - centre, b - centre, half).0.max(0.0)
        };
        let leaf = |leaf: u32, _: f64| {
            let (distance, on_segment, on_triangle) = nearest_to_segment(a, b, &self.corners(leaf));
            Some((distance, (on_segment, on_triangle)))
        };
        let found = self.tree.find_best(f64::MAX, node, leaf);
        found.map_or((f64::MAX, a, a), |(_, (distance, (on_segment, on_triangle)))| (distance, on_segment, on_triangle))
    }

    /// A ball around the nearest points of all triangles that are within `distance` of a point; none for more than `most`
    /// triangles.
    #[must_use]
    pub(crate) fn near_points(&self, point: Vec3, distance: f64, most: usize) -> Option<(Vec3, f64)> {
        let mut near = Vec::new();
        for leaf in self.tree.leaves(|node: &BvhNode| outside(&node.aabb(), point) <= distance).take(most + 1) {
            near.push(nearest_to_point(point, &self.corners(leaf)));
        }
        if near.len() > most {
            return None;
        }
        near.retain(|on| (*on - point).length() <= distance);
        let low = near.iter().copied().reduce(Vec3::min)?;
        let high = near.iter().copied().reduce(Vec3::max)?;
        let centre = (low + high) * 0.5;
        Some((centre, near.iter().map(|on| (*on - centre).length()).fold(0.0, f64::max)))
    }
}

/// Distance of a point from a box; zero inside.
fn outside(around: &Aabb, point: Vec3) -> f64 {
    (point - point.clamp(around.mins, around.maxs)).length()
}
