//! Where robots may be in a part of a communication step, of which only both ends are known.
//!
//! A joint comes from its position at the beginning to that at the end and is never faster than at the faster of both. So it is
//! never far from where it would be at a steady speed: if it moves by `d`, and by `w` at its fastest, no farther than `w - d`, as it
//! can get ahead, or fall behind, by no more and still arrive in time. Links are looked at where steady joints have them in the middle
//! of a part, larger by what their joints may be off by and by what they move in half of it.
//!
//! Of parts that the FMU places itself the points are taken as joints are, one by one: never faster than at the faster of both ends.
//! A point that is `d` from where it was, and goes no farther than `w`, is never farther from the straight way between both than
//! `hypot(w - d, sqrt(w^2 - d^2) / 2)`: its ways from both ends are no longer than `w` together.

use std::f64::consts::PI;

use super::robot::{RobotFrame, joints};
use crate::cell::binding::MotionBinding;
use crate::cell::workcell::Kinematics;
use crate::cell::{Binding, Workcell};
use crate::geometry::kinematics::{Motion, PlacedTree};
use crate::geometry::{Capsule, Solid, Vec3};

/// Links are looked at smaller by this, m, but not smaller than they are: of a contact between two instants that is gone then it is not
/// told. What joints may be off by while a robot starts or brakes is about as much.
pub const STEP_TOLERANCE_M: f64 = 0.005;

/// Joints do not come farther than their speeds take them by more than this, rad or m: else they were told in another way, as angles are
/// that begin anew after a turn.
const JUMP: f64 = 0.02;

/// How far a joint may be from where a steady one is in the middle of a part, in half of which it takes that share of a step: one that
/// moves by so much, and could by `fastest`.
fn off(moved: f64, fastest: f64, half: f64) -> f64 {
    // Where it came farther than it is told to go, that was off by as much.
    (fastest - moved.abs()).abs() + half * moved.abs()
}

/// How far a point may be from the straight way between two places so far apart, at the same share of the step, if it can go so far, m.
fn beside_m(far_m: f64, way_m: f64) -> f64 {
    let way_m = way_m.max(far_m);
    libm::hypot(way_m - far_m, 0.5 * ((way_m - far_m) * (way_m + far_m)).sqrt())
}

/// What a link is larger by, with the tolerance.
fn smaller(by_m: f64) -> f64 {
    (by_m - STEP_TOLERANCE_M).max(0.0)
}

/// More than what rounding does to a way, m.
const ROUNDING_M: f64 = 1e-6;

/// One of some equal parts of a communication step.
#[derive(Clone, Copy, Debug)]
pub struct StepFraction {
    /// Which one, from 0.
    pub number: usize,
    /// Of so many, an even number.
    pub of: usize,
    /// How long the step lasts, s.
    pub step_s: f64,
}

impl StepFraction {
    /// Its middle, and half of it, as shares of the step.
    #[expect(clippy::cast_precision_loss, reason = "a few parts")]
    fn middle(&self) -> (f64, f64) {
        ((self.number as f64 + 0.5) / self.of as f64, 0.5 / self.of as f64)
    }
}

/// Steady joints in the middle of a part, and how far each may be from there in it.
struct Steady<'a> {
    placed: PlacedTree<'a>,
    by: Vec<f64>,
}

impl<'a> Steady<'a> {
    /// None where joints come farther than their speeds take them.
    fn new(kinematics: &'a Kinematics, motion: &MotionBinding, rows: [&[f64]; 2], part: &StepFraction) -> Option<Self> {
        let MotionBinding::Joints { positions, speeds } = motion else { return None };
        let [(from, before), (to, after)] = rows.map(|row| joints(kinematics, positions, speeds, row));
        let (middle, half) = part.middle();
        let (mut at, mut by) = (Vec::new(), Vec::new());
        for joint in 0..from.len() {
            let moved = to[joint] - from[joint];
            let fastest = before[joint].abs().max(after[joint].abs()) * part.step_s;
            let is_turn = kinematics.tree.joints[joint].motion == Motion::Revolute && moved.abs() > PI;
            if moved.abs() > fastest + JUMP || is_turn {
                return None;
            }
            at.push(from[joint] + middle * moved);
            by.push(off(moved, fastest, half));
        }
        Some(Self { placed: kinematics.tree.place(&at), by })
    }

    /// A link that a joint carries, unless it may be farther from there than so, m.
    fn link(&self, joint: usize, shape: &Solid, most_m: f64) -> Option<Solid> {
        let link = shape.placed(self.placed.world_from_link[joint]);
        let (core, radius_m) = match &link {
            Solid::Capsule(capsule) => ((capsule.a, capsule.b), 0.0),
            solid @ (Solid::Hull(_) | Solid::Mesh(_)) => {
                let (middle, radius_m) = solid.bounding_sphere();
                ((middle, middle), radius_m)
            }
        };
        let by_m = self.placed.moves_m(joint, core, radius_m, &self.by);
        (by_m <= most_m).then(|| link.grown(smaller(by_m)))
    }
}

/// The robots in a part of the step between two instants, every link as large as what it may be in then, with the speeds of the nearer
/// instant.
#[must_use]
pub fn in_part_of_step(
    cell: &Workcell,
    binding: &Binding,
    [from, to]: [&RobotFrame; 2],
    part: &StepFraction,
) -> RobotFrame {
    let nearer = if part.middle().0 <= 0.5 { from } else { to };
    let rows = [from.outputs(), to.outputs()];
    let of_robots = cell.robots.iter().zip(&binding.robots);
    let robots: Vec<Option<Steady<'_>>> =
        of_robots.map(|(robot, bound)| Steady::new(robot.kinematics.as_deref()?, &bound.motion, rows, part)).collect();
    let swept_m = from.swept_m(to, part.step_s);
    let link = |number: usize| {
        let link = &cell.links[number];
        let is_placed = matches!(binding.robots[link.robot].motion, MotionBinding::Frames(_));
        let closely = match (&robots[link.robot], &from.links[number], &to.links[number]) {
            (Some(steady), ..) => steady.link(link.joint, &link.shape, swept_m[number]),
            (None, Solid::Capsule(a), Solid::Capsule(b)) if is_placed => straight(number, [from, to], [a, b], part),
            _ => None,
        };
        // What holds for half a step holds for parts of it.
        closely.unwrap_or_else(|| nearer.links[number].grown(smaller(swept_m[number])))
    };
    nearer.with_links((0..cell.links.len()).map(link).collect())
}

/// A capsule on the straight ways of both ends of its core: between them every point of the core is off as both ends are. None where
/// they come farther than their speeds take them.
fn straight(link: usize, [from, to]: [&RobotFrame; 2], [a, b]: [&Capsule; 2], part: &StepFraction) -> Option<Solid> {
    let (middle, half) = part.middle();
    let end = |before: Vec3, after: Vec3| {
        let speed = from.velocity(link, before).length().max(to.velocity(link, after).length());
        let (far_m, way_m) = ((after - before).length(), speed * part.step_s);
        let off_m = (far_m <= way_m + ROUNDING_M).then(|| beside_m(far_m, way_m) + half * far_m);
        Some((before + (after - before) * middle, off_m?))
    };
    let ((first, off), (last, other)) = (end(a.a, b.a)?, end(a.b, b.b)?);
    Some(Solid::Capsule(Capsule { a: first, b: last, radius: a.radius.max(b.radius) + smaller(off.max(other)) }))
}

#[cfg(test)]
#[path = "between_tests.rs"]
mod tests;
