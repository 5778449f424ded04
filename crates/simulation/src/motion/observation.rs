//! What was seen of the motion in all runs. Every figure is a greatest, a first or a set, so that it does not matter how often a
//! step is looked at, nor in which order.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::super::robot::RobotFrame;
use super::IMPLAUSIBLE_M_S;

/// A speed up to so much above the limit in a URDF is not told.
const ABOVE_LIMIT: f64 = 1.05;

/// A step at which the speed that is told is not that of the motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Disagreement {
    /// By how much it is beyond what the step explains, rad/s or m/s.
    pub beyond: f64,
    /// Number of the step from the person's beginning, from 1.
    pub step: usize,
    /// The speed of the motion; a length if it has components.
    pub motion: f64,
    /// The speed that is told.
    pub told: f64,
}

/// What was seen of a signal that is compared.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct SignalObservation {
    /// The largest disagreement.
    pub worst: Option<Disagreement>,
    /// Numbers of the steps at which the two disagree.
    pub steps: BTreeSet<usize>,
    /// Whether it was told to be slower than it is, and whether faster.
    pub slower_faster: [bool; 2],
    /// The fastest by its motion, and as told, with the number of the step.
    pub fastest: [(f64, usize); 2],
    /// Least and greatest motion in parts of what is told, where they disagree and what is told hardly changes.
    pub ratio: Option<[f64; 2]>,
    /// Signals whose motion the told speed is where the two disagree, and those whose it is not.
    pub(super) others: [BTreeSet<usize>; 2],
    /// Whether it was somewhere else at first: outputs after initialisation that are no pose of the robot.
    pub jumped: bool,
}

/// What was seen of everything that moves.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Motion {
    pub(super) seen: Vec<SignalObservation>,
    /// The greatest speed of a link that no robot has: index of the link, m/s, number of the step.
    pub implausible: Option<(usize, f64, usize)>,
    /// Robots of which anything changed its place, by their numbers.
    pub moved: BTreeSet<usize>,
    /// Number of the last step that was looked at.
    pub last: usize,
}

impl Motion {
    /// Looks at the robots after the steps from number `from` on for links faster than any robot's.
    pub fn look_at_links(&mut self, frames: &[Arc<RobotFrame>], from: usize) {
        for (i, frame) in frames.iter().enumerate().filter(|(_, frame)| frame.fastest > IMPLAUSIBLE_M_S) {
            for link in 0..frame.links.len() {
                let (speed, step) = (frame.certain_speed(link), from + i);
                let known = self.implausible.map_or((IMPLAUSIBLE_M_S, usize::MAX, 0), |(l, s, at)| (s, at, l));
                let first = speed >= known.0 && (step, link) < (known.1, known.2);
                if speed > known.0 || (first && self.implausible.is_some()) {
                    self.implausible = Some((link, speed, step));
                }
            }
        }
    }

    /// What was seen of each signal.
    #[must_use]
    pub fn seen(&self) -> &[SignalObservation] {
        &self.seen
    }

    /// Whether some told speed is not that of the motion.
    #[cfg(test)]
    pub(crate) fn disagrees(&self) -> bool {
        self.seen.iter().any(|seen| seen.worst.is_some())
    }

    /// Whether outputs were no pose of the robot at first.
    #[must_use]
    pub fn jumped(&self) -> bool {
        self.seen.iter().any(|seen| seen.jumped)
    }

    /// Adds what was seen in other runs of the same cell.
    pub fn merge(&mut self, other: &Self) {
        let count = self.seen.len().max(other.seen.len());
        self.seen.resize(count, SignalObservation::default());
        self.seen.iter_mut().zip(&other.seen).for_each(|(seen, other)| seen.merge(other));
        let further = |a: &(usize, f64, usize), b: &(usize, f64, usize)| {
            a.1.total_cmp(&b.1).then_with(|| (b.2, b.0).cmp(&(a.2, a.0)))
        };
        self.implausible = self.implausible.into_iter().chain(other.implausible).max_by(further);
        self.moved.extend(&other.moved);
        self.last = self.last.max(other.last);
    }
}

impl SignalObservation {
    /// Signals whose motion the told speed is wherever it disagrees with its own.
    pub fn of_others(&self) -> impl Iterator<Item = usize> {
        self.others[0].difference(&self.others[1]).copied()
    }

    /// Whether it is told never to move.
    #[must_use]
    pub fn reported_zero(&self) -> bool {
        self.fastest[1].0 <= 0.0
    }

    /// The speed above the limit, and the number of the step.
    #[must_use]
    pub fn above(&self, limit: f64) -> Option<(f64, usize)> {
        let fastest = if self.fastest[1].0 > self.fastest[0].0 { self.fastest[1] } else { self.fastest[0] };
        Some(fastest).filter(|(speed, _)| *speed > ABOVE_LIMIT * limit)
    }

    fn merge(&mut self, other: &Self) {
        if let Some(theirs) = other.worst
            && self.worst.is_none_or(|own| (theirs.beyond, own.step) > (own.beyond, theirs.step))
        {
            self.worst = Some(theirs);
        }
        self.steps.extend(&other.steps);
        for (own, theirs) in self.slower_faster.iter_mut().zip(other.slower_faster) {
            *own |= theirs;
        }
        for (own, theirs) in self.fastest.iter_mut().zip(other.fastest) {
            if theirs.0 > own.0 || (theirs.0 >= own.0 && theirs.1 < own.1) {
                *own = theirs;
            }
        }
        let both = self.ratio.into_iter().chain(other.ratio);
        self.ratio = both.reduce(|a, b| [a[0].min(b[0]), a[1].max(b[1])]);
        for (own, theirs) in self.others.iter_mut().zip(&other.others) {
            own.extend(theirs);
        }
        self.jumped |= other.jumped;
    }
}
