//! The arm check: branch and bound against a plain grid sampler of 720 configurations an arm, in one run.
//!
//! Random scenes (7 capsule links, 20 boxes, 64 placements, two arms each) as an average cell, and a person at a fence
//! with an opening as a hard one. The grid has no guarantee; the branch and bound misses no contact deeper than 20 mm
//! that leaves as much clearance. Each iteration of `random_*` is 128 arm checks.

use std::sync::LazyLock;

use divan::{Bencher, black_box};
use fmi_hazard::geometry::distance::segment_segment;
use fmi_hazard::geometry::kinematics::Neighbourhood;
use fmi_hazard::geometry::segment_cuboid::{segment_cuboid, segment_hits_cuboid};
use fmi_hazard::geometry::{Capsule, Cuboid, Pose, Rotation, Solid, Vec3, rotation_about};
use fmi_hazard::human::Side;
use fmi_hazard::human::arm::{ABDUCTION, ArmModel, ELBOW, flexion_range, rotation_range};
use fmi_hazard::human::reach::{ArmSegment, ContactScore, ReachQuery, reach};
use fmi_hazard::search::Rng;

fn main() {
    divan::main();
}

/// Every contact counts the same: is there one?
struct Any;

impl ContactScore for Any {
    fn upper_bound(&self, _: ArmSegment, _: usize) -> f64 {
        1.0
    }
    fn upper_bound_near(&self, _: ArmSegment, _: usize, _: &Neighbourhood<'_>) -> f64 {
        1.0
    }
    fn score(&self, _: ArmSegment, _: usize, _: Vec3) -> f64 {
        1.0
    }
}

struct Scene {
    shoulder: Pose,
    links: Vec<Solid>,
    obstacles: Vec<Cuboid>,
}

fn uniform(rng: &mut Rng, low: f64, high: f64) -> f64 {
    let unit = f64::from(u32::try_from(rng.below(1 << 20)).unwrap_or(0)) / f64::from(1 << 20);
    low + (high - low) * unit
}

fn vector(rng: &mut Rng, size: f64) -> Vec3 {
    Vec3::new(uniform(rng, -size, size), uniform(rng, -size, size), uniform(rng, -size, size))
}

static RANDOM: LazyLock<Vec<Scene>> = LazyLock::new(|| {
    let mut rng = Rng::new(1);
    (0..64)
        .map(|_| {
            let middle = vector(&mut rng, 1.2);
            let link = |rng: &mut Rng| {
                let a = middle + vector(rng, 0.5);
                Solid::Capsule(Capsule { a, b: a + vector(rng, 0.25), radius: 0.07 })
            };
            let links = (0..7).map(|_| link(&mut rng)).collect();
            let cuboid = |rng: &mut Rng| Cuboid {
                centre: vector(rng, 1.5),
                half: vector(rng, 0.15).abs() + Vec3::splat(0.03),
                rotation: rotation_about(Vec3::Z, uniform(rng, 0.0, 3.0)),
            };
            let obstacles = (0..20).map(|_| cuboid(&mut rng)).collect();
            let shoulder = Pose::from_parts(Vec3::ZERO, rotation_about(Vec3::Z, uniform(&mut rng, -3.0, 3.0)));
            Scene { shoulder, links, obstacles }
        })
        .collect()
});

static FENCE: LazyLock<Scene> = LazyLock::new(|| {
    let panel = |x: (f64, f64), z: (f64, f64)| Cuboid {
        centre: Vec3::new(0.5 * (x.0 + x.1), 0.0, 0.5 * (z.0 + z.1)),
        half: Vec3::new(0.5 * (x.1 - x.0), 0.01, 0.5 * (z.1 - z.0)),
        rotation: Rotation::IDENTITY,
    };
    let tool = Vec3::new(0.0, 0.9, 1.0);
    Scene {
        shoulder: Pose::from_parts(Vec3::new(0.45, -0.2, 1.4), rotation_about(Vec3::Z, 1.6)),
        links: vec![Solid::Capsule(Capsule { a: tool, b: tool, radius: 0.08 })],
        obstacles: vec![
            panel((-1.5, -0.3), (0.0, 2.0)),
            panel((0.3, 1.5), (0.0, 2.0)),
            panel((-0.3, 0.3), (0.0, 0.8)),
            panel((-0.3, 0.3), (1.2, 2.0)),
        ],
    }
});

fn branch_and_bound(scene: &Scene, side: Side) -> bool {
    let outcome = reach(&ReachQuery {
        arm: &ArmModel::default(),
        side,
        world_from_shoulder: scene.shoulder,
        carried_m: 0.0,
        hangs_from: None,
        known: None,
        wrist_within: None,
        links: &scene.links,
        obstacles: &scene.obstacles,
        score: &Any,
        threshold: 0.5,
        tolerance_m: 0.02,
        enough: 0.5,
        work_limit: 400_000,
        stop: None,
    });
    black_box(outcome.best.is_some())
}

/// 6 x 6 x 4 x 5 configurations, robot first, the first free contact ends it: no gates, no bounds.
fn grid(scene: &Scene, side: Side) -> bool {
    let arm = ArmModel::default();
    let at = |i: u32, n: u32, (low, high): (f64, f64)| low + (high - low) * (f64::from(i) + 0.5) / f64::from(n);
    for i in 0..6 * 6 * 4 * 5 {
        let abduction = at(i / 120, 6, ABDUCTION);
        let flexion = at(i / 20 % 6, 6, flexion_range(abduction));
        let rotation = at(i / 5 % 4, 4, rotation_range(abduction, flexion));
        let (elbow, wrist) = arm.forward(side, [abduction, flexion, rotation, at(i % 5, 5, ELBOW)]);
        let (from, elbow, wrist) =
            (scene.shoulder.translation, scene.shoulder.transform_point(elbow), scene.shoulder.transform_point(wrist));
        let touches = scene.links.iter().any(|link| {
            let Solid::Capsule(c) = link else { return false };
            segment_segment(elbow, wrist, c.a, c.b).distance < c.radius + arm.forearm_radius_m
                || segment_segment(from, elbow, c.a, c.b).distance < c.radius + arm.upper_arm_radius_m
                || {
                    let near = link.point_distance(wrist);
                    near.distance < arm.hand_radius_m
                        && !scene.obstacles.iter().any(|o| segment_hits_cuboid(wrist, near.on_second, o))
                }
        });
        let free = |o: &Cuboid| {
            segment_cuboid(elbow, wrist, o).distance >= arm.forearm_radius_m
                && segment_cuboid(from, elbow, o).distance >= arm.upper_arm_radius_m
        };
        if touches && scene.obstacles.iter().all(free) {
            return black_box(true);
        }
    }
    black_box(false)
}

fn all(check: fn(&Scene, Side) -> bool) -> usize {
    RANDOM.iter().map(|s| Side::BOTH.into_iter().filter(|&side| check(s, side)).count()).sum()
}

#[divan::bench(sample_count = 20)]
fn random_branch_and_bound(bencher: Bencher) {
    let (found, by_grid) = (all(branch_and_bound), all(grid));
    assert!(found >= by_grid, "branch and bound {found}, grid {by_grid}");
    bencher.bench_local(|| all(branch_and_bound));
}

#[divan::bench(sample_count = 20)]
fn random_grid(bencher: Bencher) {
    bencher.bench_local(|| all(grid));
}

#[divan::bench(sample_count = 20)]
fn fence_branch_and_bound(bencher: Bencher) {
    bencher.bench_local(|| branch_and_bound(&FENCE, Side::Left));
}

#[divan::bench(sample_count = 20)]
fn fence_grid(bencher: Bencher) {
    bencher.bench_local(|| grid(&FENCE, Side::Left));
}
