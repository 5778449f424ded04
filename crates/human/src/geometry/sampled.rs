//! The surface of a robot link as points with outward normals, close enough together that every point of it is near one.

use std::collections::BTreeMap;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;

use super::distance::perpendicular_to;
use super::samples::SurfacePoint;
use super::triangle::{Corners, normal};
use super::{Capsule, Solid, Vec3};

/// Points of the surface; no point of it is farther than `within_m` from the nearest of them. Of what is grown they are on
/// what it was before.
#[must_use]
pub fn surface_points(solid: &Solid, within_m: f64) -> Vec<SurfacePoint> {
    let (once, pose) = match solid {
        Solid::Capsule(capsule) => {
            let mut points = Vec::new();
            of_capsule(capsule, within_m, &mut points);
            return points;
        }
        Solid::Hull(hull) => (hull.sampled(), hull.pose()),
        Solid::Mesh(mesh) => (&mesh.surface().sampled, mesh.pose()),
    };
    let (known_m, known) = once.get_or_init(|| (within_m, in_own_frame(solid, within_m)));
    #[expect(clippy::float_cmp, reason = "the same question")]
    let points = if *known_m == within_m { Arc::clone(known) } else { in_own_frame(solid, within_m) };
    points.iter().map(|point| SurfacePoint { at: pose * point.at, outward: pose.rotation * point.outward }).collect()
}

/// The same of a shape of triangles, where it was made.
fn in_own_frame(solid: &Solid, within_m: f64) -> Arc<[SurfacePoint]> {
    let mut points = Kept::new(within_m);
    match solid {
        Solid::Capsule(_) => {}
        Solid::Hull(hull) => {
            let (corners, triangles) = hull.shape().to_trimesh();
            for triangle in triangles {
                points.of_triangle(&triangle.map(|corner| corners[corner as usize]));
            }
        }
        Solid::Mesh(mesh) => {
            let triangles = mesh.surface().triangles();
            for triangle in 0..triangles.triangles.len() {
                points.of_triangle(&triangles.corners(triangle));
            }
        }
    }
    points.all.into()
}

/// Points of triangles, without those that others stand for: a mesh of a robot has thousands of triangles of a few millimetres.
struct Kept {
    within_m: f64,
    all: Vec<SurfacePoint>,
    /// Their numbers, by the cell of a grid of `within_m` that they are in.
    by_cell: BTreeMap<[i64; 3], Vec<usize>>,
}

impl Kept {
    const fn new(within_m: f64) -> Self {
        Self { within_m, all: Vec::new(), by_cell: BTreeMap::new() }
    }

    /// A grid between two sides, corners included. A point of a triangle is no farther from the nearest corner than its longest side by the
    /// root of three, so neither is one of a part of the grid; what is within the rest may stand for a corner, if it faces the same way.
    fn of_triangle(&mut self, corners: &Corners) {
        let Some(outward) = normal(corners).try_normalize() else { return };
        let [a, b, c] = *corners;
        let longest = (b - a).length().max((c - a).length()).max((c - b).length());
        let count = steps(longest, self.within_m);
        let spare_m = self.within_m - longest / f64::from(count) / 3.0_f64.sqrt();
        for i in 0..=count {
            for j in 0..=count - i {
                let at = a + (b - a) * (f64::from(i) / f64::from(count)) + (c - a) * (f64::from(j) / f64::from(count));
                self.add(SurfacePoint { at, outward }, spare_m);
            }
        }
    }

    /// Adds a point, if none that faces as it does is within `spare_m`.
    fn add(&mut self, point: SurfacePoint, spare_m: f64) {
        #[expect(
            clippy::cast_possible_truncation,
            reason = "sizes are bounded where files are read; else it saturates"
        )]
        let cell = point.at.to_array().map(|along| (along / self.within_m).floor() as i64);
        let stands_for = |number: &usize| {
            let other = &self.all[*number];
            (other.at - point.at).length() <= spare_m && other.outward.dot(point.outward) >= ALIKE
        };
        let stands_in = |cell: &[i64; 3]| self.by_cell.get(cell).is_some_and(|numbers| numbers.iter().any(stands_for));
        let around = |axis: usize| cell[axis].saturating_sub(1)..=cell[axis].saturating_add(1);
        let mut near = around(0).flat_map(|x| around(1).flat_map(move |y| around(2).map(move |z| [x, y, z])));
        // Most often it is in the same cell.
        if stands_in(&cell) || near.any(|cell| stands_in(&cell)) {
            return;
        }
        self.by_cell.entry(cell).or_default().push(self.all.len());
        self.all.push(point);
    }
}

/// Surfaces face the same way where the cosine of the angle between them is no less: 14 degrees, less than from point to point of a capsule.
const ALIKE: f64 = 0.97;

/// So many steps of at most `step` make `length`; one at least.
fn steps(length: f64, step: f64) -> u32 {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited, and never negative")]
    let steps = (length / step).ceil().clamp(1.0, 10_000.0) as u32;
    steps
}

/// Rings around the axis: along the core, and over both caps.
fn of_capsule(capsule: &Capsule, within_m: f64, points: &mut Vec<SurfacePoint>) {
    let (radius, along) = (capsule.radius, capsule.b - capsule.a);
    // Rings so far apart, and points in a ring, that half of both is within reach.
    let step = within_m * std::f64::consts::SQRT_2;
    let axis = along.try_normalize().unwrap_or(Vec3::Z);
    let x = perpendicular_to(axis, axis);
    let y = axis.cross(x);
    let mut ring = |centre: Vec3, out: f64, up: f64| {
        let count = steps(TAU * radius * out, step);
        for i in 0..count {
            let (sin, cos) = libm::sincos(TAU * f64::from(i) / f64::from(count));
            let outward = (x * cos + y * sin) * out + axis * up;
            points.push(SurfacePoint { at: centre + outward * radius, outward });
        }
    };
    let length = along.length();
    if length > 0.0 {
        let rings = steps(length, step);
        for i in 0..=rings {
            ring(capsule.a + along * (f64::from(i) / f64::from(rings)), 1.0, 0.0);
        }
    } else {
        ring(capsule.a, 1.0, 0.0);
    }
    let rings = steps(0.5 * PI * radius, step);
    for (centre, side) in [(capsule.a, -1.0), (capsule.b, 1.0)] {
        for i in 1..=rings {
            let (sin, cos) = libm::sincos(0.5 * PI * f64::from(i) / f64::from(rings));
            ring(centre, if i == rings { 0.0 } else { cos }, side * sin);
        }
    }
}

#[cfg(test)]
mod tests {
    use std::sync::Arc;

    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::geometry::surface::{Surface, Triangles};
    use crate::geometry::{Hull, Mesh, Pose, rotation_about, test_meshes};

    /// Corners of a ball, in rings.
    fn ball(radius_m: f64, around: u32) -> Vec<Vec3> {
        let corner = |number: u32| {
            let (sin, cos) = libm::sincos(PI * (f64::from(number / around) + 0.5) / f64::from(around / 2));
            let (y, x) = libm::sincos(TAU * f64::from(number % around) / f64::from(around));
            Vec3::new(sin * x, sin * y, cos) * radius_m
        };
        (0..around * (around / 2)).map(corner).collect()
    }

    /// Random points of the surface, found as the nearest to points around, are all near one that is told; and those lie on the
    /// surface, with normals that lead out of it.
    #[test]
    fn every_point_of_a_surface_is_near_one() {
        let pose = Pose::from_parts(Vec3::new(0.4, -0.2, 1.0), rotation_about(Vec3::new(0.6, 0.0, 0.8), 1.1));
        let (corners, triangles) = test_meshes::cuboid([-0.2, -0.1, -0.05], [0.2, 0.1, 0.05]);
        let corners: Vec<Vec3> = corners.into_iter().map(Vec3::from_array).collect();
        let surface = Surface::new(Triangles::merged(&corners, &triangles)).unwrap();
        let solids = [
            Solid::Capsule(Capsule { a: Vec3::ZERO, b: Vec3::new(0.0, 0.1, 0.3), radius: 0.07 }),
            Solid::Capsule(Capsule { a: Vec3::X, b: Vec3::X, radius: 0.05 }),
            Solid::Hull(Hull::from_points(&corners).unwrap()),
            Solid::Mesh(Mesh::new(Arc::new(surface), Pose::IDENTITY)),
            Solid::Hull(Hull::from_points(&ball(0.15, 60)).unwrap()),
        ];
        let mut random = Pcg64::seed_from_u64(5);
        let mut unit = || f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0;
        for solid in solids.map(|solid| solid.placed(pose)) {
            let points = surface_points(&solid, 0.02);
            // The ball has 1,800 corners and 3,600 triangles.
            assert!(points.len() < 2000, "{}", points.len());
            for point in &points {
                let near = |by: f64| solid.point_distance(point.at + point.outward * by).distance;
                assert!(near(0.0).abs() < 1e-9 && near(0.01) > 0.0 && near(-0.01) < 1e-9, "{point:?}");
            }
            let (centre, radius) = solid.bounding_sphere();
            for _ in 0..3000 {
                let around = centre + Vec3::new(unit(), unit(), unit()) * (1.5 * radius);
                let near = solid.point_distance(around);
                let apart = points.iter().map(|point| (point.at - near.on_second).length()).fold(f64::MAX, f64::min);
                assert!(apart <= 0.02 + 1e-9, "{apart} m from {}", near.on_second);
            }
        }
    }
}
