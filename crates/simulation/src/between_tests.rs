//! Where a robot may be between two instants holds for random ways of its joints, and by hand for a point.

use super::*;
use crate::geometry::kinematics::{Joint, KinematicTree, Motion};
use crate::geometry::{Pose, rotation_about};
use crate::search::Rng;

/// A joint that turns, one that slides on it, and one that turns at its end.
fn tree() -> KinematicTree {
    let joint =
        |parent, x, motion, axis| Joint { parent, parent_from_joint: Pose::translation(x, 0.0, 0.2), motion, axis };
    KinematicTree {
        world_from_base: Pose::from_parts(Vec3::new(0.3, -0.2, 0.4), rotation_about(Vec3::X, 0.4)),
        joints: vec![
            joint(None, 0.0, Motion::Revolute, Vec3::Z),
            joint(Some(0), 0.5, Motion::Prismatic, Vec3::X),
            joint(Some(1), 0.4, Motion::Revolute, Vec3::Y),
        ],
    }
}

/// Random joints near others: no point of a link's core, or around it, is farther from where it was than told, and some are nearly as
/// far.
#[test]
fn no_point_moves_farther_than_its_joints_let_it() {
    let mut rng = Rng::new(5);
    let mut uniform = |low: f64, high: f64| {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    };
    let tree = tree();
    let (a, b) = (Vec3::new(-0.1, 0.0, 0.0), Vec3::new(0.6, 0.1, 0.0));
    let mut nearest: f64 = 0.0;
    for _ in 0..2000 {
        let at: Vec<f64> = (0..3).map(|_| uniform(-2.0, 2.0)).collect();
        let by: Vec<f64> = (0..3).map(|_| uniform(0.0, 0.1)).collect();
        let placed = tree.place(&at);
        for joint in 0..3 {
            // Half of the links are thick, and around them the points count.
            let radius_m = 0.3 * uniform(0.0, 2.0).floor();
            let around = Vec3::new(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0));
            let around = around * (radius_m / around.length());
            let on = |placed: &PlacedTree<'_>, beside: Vec3| {
                [a, b].map(|point| placed.world_from_link[joint] * (point + beside))
            };
            let (core, own) = (on(&placed, Vec3::ZERO), on(&placed, around));
            let told = placed.moves_m(joint, (core[0], core[1]), radius_m, &by);
            for _ in 0..8 {
                let other: Vec<f64> =
                    at.iter().zip(&by).map(|(at, by)| at + by * uniform(-1.0, 1.0).signum()).collect();
                let moved = on(&tree.place(&other), around);
                let far = (0..2).map(|end| (moved[end] - own[end]).length()).fold(0.0, f64::max);
                assert!(far <= told + 1e-12, "{far} of {told} by {by:?} at {at:?}");
                nearest = nearest.max(far / told);
            }
        }
    }
    assert!(nearest > 0.9, "{nearest}");
}

/// Joints that go at any speed up to the faster of both ends, and arrive in time, are never farther from a steady joint than told: in
/// the middle of a part, and in all of it.
#[test]
fn a_joint_that_arrives_in_time_is_never_far_from_a_steady_one() {
    let mut rng = Rng::new(6);
    let mut uniform = |low: f64, high: f64| {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    };
    let parts = 8;
    let mut nearest: f64 = 0.0;
    for _ in 0..2000 {
        // As fast as it may be, one way and the other, for some of the time each: as far from steady as may be.
        let (fastest, turns) = (uniform(0.1, 1.0), uniform(0.0, 1.0));
        let first = if uniform(0.0, 1.0) < 0.5 { fastest } else { -fastest };
        let at = |time: f64| first * time.min(turns) - first * (time - turns).max(0.0);
        let moved = at(1.0);
        for number in 0..parts {
            let part = StepFraction { number, of: parts, step_s: 1.0 };
            let (middle, half) = part.middle();
            let by = off(moved, fastest, half);
            for share in 0..=10 {
                let time = middle + half * (f64::from(share) / 5.0 - 1.0);
                let far = (at(time) - middle * moved).abs();
                assert!(far <= by + 1e-12, "{far} of {by}: {fastest} {turns} in part {number}");
                nearest = nearest.max(far / by);
            }
        }
    }
    assert!(nearest > 0.85, "{nearest}");
}

/// By hand: a point that goes 3 mm, and could go 5 mm, is no farther from the straight way than 2 mm along it, and 2 mm beside it.
#[test]
fn a_point_between_two_places_by_hand() {
    assert!((beside_m(0.003, 0.005) - libm::hypot(0.002, 0.002)).abs() < 1e-12);
    assert!(beside_m(0.004, 0.004).abs() < 1e-12);
    // There and back: half of what it could go, and what is told is more.
    assert!(beside_m(0.0, 0.004) >= 0.002);
}
