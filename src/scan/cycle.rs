//! How often the robots repeat what they do while nobody comes: what `--until 2cycles` is counted in, and what the share of a cycle is
//! of that a search met.

use crate::geometry::{Solid, Vec3};
use crate::sim::robot::RobotFrame;

/// Places that differ by no more, and by this share of what is moved in a step, are the same, m.
const SAME_M: f64 = 0.005;
const SAME_SHARE: f64 = 0.1;
/// Parts of a step by which a cycle may be no multiple of steps.
const PARTS: u32 = 20;
/// Of the way that the robots take altogether, they take at least this share in a cycle.
const WHOLE: f64 = 0.95;
/// Robots that get no farther than this stand still, m.
pub(super) const STILL_M: f64 = 10.0 * SAME_M;

/// So long robots are watched for a cycle, s.
pub(super) const LONGEST_WATCHED_S: f64 = 64.0;

/// Rounding of what is added, generously, m.
const ROUNDING_M: f64 = 1e-9;

/// What is repeated.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Cycle {
    /// From this instant on, steps after the first.
    pub(super) from: usize,
    /// Every so many steps.
    pub(super) steps: f64,
}

/// Points of the links, of which an instant has as many as the others: two of a capsule, and the middle of another shape.
pub(super) fn points(frame: &RobotFrame) -> Vec<Vec3> {
    let of = |link: &Solid| match link {
        Solid::Capsule(c) => vec![c.a, c.b],
        solid @ (Solid::Hull(_) | Solid::Mesh(_)) => vec![solid.bounding_sphere().0],
    };
    frame.links.iter().flat_map(of).collect()
}

/// How far apart the points are at two instants, the farthest of them, m.
fn apart(a: &[Vec3], b: &[Vec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (*a - *b).length()).fold(0.0, f64::max)
}

/// How far anything gets from where it is at first, m.
pub(super) fn path_m(instants: &[Vec<Vec3>]) -> f64 {
    let Some(first) = instants.first() else { return 0.0 };
    instants.iter().map(|instant| apart(instant, first)).fold(0.0, f64::max)
}

/// The shortest cycle of which the last two are equal; nothing if robots stand still at last, or do not repeat what they do.
pub(super) fn cycle(instants: &[Vec<Vec3>]) -> Option<Cycle> {
    let count = instants.len();
    let farthest = |from: usize, to: usize| {
        instants[from..to].iter().map(|instant| apart(instant, &instants[from])).fold(0.0, f64::max)
    };
    // Nothing is farther apart than twice what all are from the first.
    if path_m(instants) < STILL_M / 2.0 {
        return None;
    }
    // What the robots did at an instant, and part of a step later.
    let later = |at: usize, part: f64| -> Vec<Vec3> {
        instants[at].iter().zip(&instants[at + 1]).map(|(a, b)| *a + (*b - *a) * part).collect()
    };
    (2..=count / 2).find_map(|steps| {
        let last = count - 2 * steps;
        // Soon said of most: the last instant is not one of these, however much of a step later.
        let (before, end) = (count - steps - 1, count - 1);
        let moved = apart(&instants[before], &instants[before + 1]);
        if apart(&instants[before], &instants[end]) > SAME_M + (1.0 + SAME_SHARE) * moved + ROUNDING_M {
            return None;
        }
        if farthest(last, last + steps) < WHOLE * farthest(last, count) || farthest(last, count) < STILL_M {
            return None;
        }
        (0..PARTS).find_map(|part| {
            let part = f64::from(part) / f64::from(PARTS);
            let same = |at: &usize| {
                let moved = apart(&instants[*at], &instants[at + 1]);
                apart(&later(*at, part), &instants[at + steps]) <= SAME_M + SAME_SHARE * moved
            };
            let from = count - steps - (0..count - steps).rev().take_while(same).count();
            #[expect(clippy::cast_precision_loss, reason = "some thousand steps")]
            (from <= last).then_some(Cycle { from, steps: steps as f64 - part })
        })
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::TAU;

    use libm::{cos, sin};

    /// An arm that swings after it has come from elsewhere, `period` steps to and fro.
    fn swings(period: f64, start: u32, count: u32) -> Vec<Vec<Vec3>> {
        let at = |n: u32| {
            let late = f64::from(n) - f64::from(start);
            let angle = 0.9 * sin(TAU * late / period) + 0.2 * cos(2.0 * TAU * late / period);
            let comes = (-late).max(0.0) * 0.02;
            vec![Vec3::new(cos(angle) + comes, sin(angle), 1.0), Vec3::new(0.5 * cos(angle), 0.5 * sin(angle), 1.0)]
        };
        (0..count).map(at).collect()
    }

    #[test]
    fn a_cycle_is_found_after_what_comes_before_it_and_between_steps() {
        let found = cycle(&swings(96.05, 30, 300)).unwrap();
        assert!((found.steps - 96.05).abs() < 0.06 && (25..=30).contains(&found.from), "{found:?}");
        let found = cycle(&swings(40.0, 0, 90)).unwrap();
        assert!((found.steps - 40.0).abs() < 0.06 && found.from == 0, "{found:?}");
    }

    #[test]
    fn what_is_not_seen_twice_or_stands_still_is_none() {
        assert_eq!(cycle(&swings(96.05, 30, 200)), None);
        assert_eq!(cycle(&vec![vec![Vec3::ZERO]; 100]), None);
        let ever_on: Vec<_> = (0..200).map(|n| vec![Vec3::new(0.02 * f64::from(n), 0.0, 1.0)]).collect();
        assert_eq!(cycle(&ever_on), None);
    }
}
