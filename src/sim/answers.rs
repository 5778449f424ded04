//! Answers to questions whether a person can be touched, known by what they follow from and nothing else: how the person stands,
//! and where and how fast the robots are. So several machines can share the questions of one exhaustive search out.
//!
//! Each goes the same way through the cell and answers its own questions; those of others it takes for harmless, so it comes to
//! every state that the whole search comes to, and to some more. What it wrote down is looked up when the whole search is run
//! again. A question that nobody answered is worked out then: what is looked up may save work, and never changes a result.
//!
//! Only questions with a robot in reach are shared out. The others, most of them, cost less than looking them up.

use std::collections::BTreeMap;
use std::hash::Hasher;
use std::io;
use std::sync::Arc;
use std::sync::atomic::{AtomicU64, Ordering};

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::Coverage;
use super::coverage::RobotCoverage;

/// What a question is known by: a part of the SHA-256 of what it follows from.
pub(super) type Key = [u8; 16];

/// What came out of a question.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) enum Answer {
    /// Something: it is worked out again, for what it is.
    Something,
    /// Nothing unsafe, and what was counted meanwhile.
    Nothing(Counted),
}

/// The part of [`Coverage`] that a question adds to.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Counted {
    contact_checks: u64,
    arm_checks: u64,
    arm_checks_incomplete: u64,
    arm_runs_not_evaluated: u64,
    arm_boxes: u64,
    closest_approach_m: f64,
    /// Of each robot, as far as any was looked at.
    closest_of_robots_m: Vec<f64>,
    checks_with_robot_in_arm_reach: u64,
    contacts_within_limits: u64,
    highest_ratio_within_limits: f64,
}

impl Counted {
    /// What was counted for one question; nothing if that is more than can be kept.
    pub(super) fn of(coverage: &Coverage) -> Option<Self> {
        let Coverage {
            episodes,
            episodes_not_evaluated,
            actions,
            contact_checks,
            arm_checks,
            arm_checks_incomplete,
            arm_runs_not_evaluated,
            arm_boxes,
            closest_approach_m,
            checks_with_robot_in_arm_reach,
            contacts_within_limits,
            highest_ratio_within_limits,
            robot_top_speed_m_s,
            sensor_actions,
            walks_blocked,
            control_actions,
            robots,
        } = coverage;
        let others = episodes + episodes_not_evaluated + actions + walks_blocked;
        let others = others + sensor_actions.iter().chain(control_actions).sum::<u64>();
        let closest_of_robots_m = robots.iter().map(RobotCoverage::of_question).collect::<Option<_>>()?;
        (others == 0 && *robot_top_speed_m_s <= 0.0).then_some(Self {
            contact_checks: *contact_checks,
            arm_checks: *arm_checks,
            arm_checks_incomplete: *arm_checks_incomplete,
            arm_runs_not_evaluated: *arm_runs_not_evaluated,
            arm_boxes: *arm_boxes,
            closest_approach_m: *closest_approach_m,
            closest_of_robots_m,
            checks_with_robot_in_arm_reach: *checks_with_robot_in_arm_reach,
            contacts_within_limits: *contacts_within_limits,
            highest_ratio_within_limits: *highest_ratio_within_limits,
        })
    }

    /// The same for a cell with so many sensors.
    pub(super) fn coverage(&self, sensors: usize) -> Coverage {
        let closest = |&closest_approach_m: &f64| RobotCoverage { closest_approach_m, ..RobotCoverage::default() };
        Coverage {
            robots: self.closest_of_robots_m.iter().map(closest).collect(),
            contact_checks: self.contact_checks,
            arm_checks: self.arm_checks,
            arm_checks_incomplete: self.arm_checks_incomplete,
            arm_runs_not_evaluated: self.arm_runs_not_evaluated,
            arm_boxes: self.arm_boxes,
            closest_approach_m: self.closest_approach_m,
            checks_with_robot_in_arm_reach: self.checks_with_robot_in_arm_reach,
            contacts_within_limits: self.contacts_within_limits,
            highest_ratio_within_limits: self.highest_ratio_within_limits,
            ..Coverage::new(sensors)
        }
    }
}

/// Answers that were worked out elsewhere.
#[derive(Debug, Default)]
pub(crate) struct Answers {
    known: BTreeMap<Key, Answer>,
    looked_up: AtomicU64,
    unanswered: AtomicU64,
}

impl Answers {
    /// Adds those of a part, as [`Share::into_bytes`] gave them.
    ///
    /// # Errors
    /// When the bytes are something else.
    pub(crate) fn add(&mut self, bytes: &[u8]) -> io::Result<()> {
        let all: Vec<(Key, Answer)> = postcard::from_bytes(bytes).map_err(io::Error::other)?;
        self.known.extend(all);
        Ok(())
    }

    /// How many there are.
    #[must_use]
    pub(crate) fn count(&self) -> usize {
        self.known.len()
    }

    /// Questions that were looked up and found, and those that were not found and had to be worked out.
    #[must_use]
    pub(crate) fn used(&self) -> (u64, u64) {
        (self.looked_up.load(Ordering::Relaxed), self.unanswered.load(Ordering::Relaxed))
    }

    pub(super) fn get(&self, key: &Key) -> Option<Answer> {
        let found = self.known.get(key).cloned();
        let counter = if found.is_some() { &self.looked_up } else { &self.unanswered };
        counter.fetch_add(1, Ordering::Relaxed);
        found
    }
}

/// One of several parts of a search, and what it has answered.
#[derive(Debug)]
pub struct Share {
    /// From 0.
    number: u64,
    of: u64,
    answers: BTreeMap<Key, Answer>,
}

impl Share {
    /// Part `number`, from 1, of so many.
    #[must_use]
    pub(crate) fn new(number: u32, of: u32) -> Self {
        Self { number: u64::from(number.max(1) - 1), of: u64::from(of.max(1)), answers: BTreeMap::new() }
    }

    /// Whether it answers questions about this pose: a property of the pose alone.
    pub(super) fn answers(&self, pose: &Key) -> bool {
        let (first, _) = pose.split_first_chunk::<8>().unwrap_or((&[0; 8], &[]));
        u64::from_le_bytes(*first) % self.of == self.number
    }

    pub(super) fn add(&mut self, key: Key, answer: Answer) {
        self.answers.insert(key, answer);
    }

    /// What it answered, the same bytes whenever it is done.
    ///
    /// # Errors
    /// Never, in practice.
    pub(crate) fn into_bytes(self) -> io::Result<Vec<u8>> {
        postcard::to_stdvec(&self.answers.into_iter().collect::<Vec<_>>()).map_err(io::Error::other)
    }
}

/// Where the answers of a search come from.
#[derive(Debug, Default)]
pub(super) enum Sharing {
    /// It works all of them out.
    #[default]
    Nothing,
    /// It works out its share, and nothing else.
    Share(Share),
    /// They are looked up, and worked out where they are not there.
    LookUp(Arc<Answers>),
}

/// What things come to, as a key. Of each part the length is told, so that none runs into the next.
#[derive(Default)]
pub(super) struct Digest(Sha256);

impl Digest {
    pub(super) fn numbers(&mut self, numbers: impl ExactSizeIterator<Item = u64>) {
        self.0.update((numbers.len() as u64).to_le_bytes());
        numbers.for_each(|number| self.0.update(number.to_le_bytes()));
    }

    /// What it all came to.
    pub(super) fn key(self) -> Key {
        let mut key = Key::default();
        key.copy_from_slice(&self.0.finalize()[..16]);
        key
    }
}

impl Hasher for Digest {
    fn write(&mut self, bytes: &[u8]) {
        self.0.update(bytes);
    }

    /// Nobody asks for so short a one.
    fn finish(&self) -> u64 {
        0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_question_has_one_part_and_what_was_counted_comes_back() {
        let keys: Vec<Key> = (0..1000_u64)
            .map(|n| {
                let mut digest = Digest::default();
                digest.numbers([n].into_iter());
                digest.key()
            })
            .collect();
        let parts: Vec<Share> = (1..=4).map(|number| Share::new(number, 4)).collect();
        for key in &keys {
            assert_eq!(parts.iter().filter(|part| part.answers(key)).count(), 1);
        }
        assert!(parts.iter().all(|part| keys.iter().filter(|key| part.answers(key)).count() > 200));
        let mut coverage = Coverage::new(3);
        (coverage.arm_boxes, coverage.contact_checks, coverage.closest_approach_m) = (7, 2, 0.25);
        let counted = Counted::of(&coverage).unwrap();
        assert_eq!(counted.coverage(3), coverage);
        coverage.robot(1).closest_approach_m = 0.25;
        let counted = Counted::of(&coverage).unwrap();
        assert_eq!(counted.coverage(3), coverage, "which robot was how near");
        let mut part = Share::new(1, 1);
        part.add(keys[1], Answer::Nothing(counted.clone()));
        part.add(keys[0], Answer::Something);
        let mut answers = Answers::default();
        answers.add(&part.into_bytes().unwrap()).unwrap();
        assert_eq!(answers.get(&keys[1]), Some(Answer::Nothing(counted)));
        assert_eq!((answers.get(&keys[2]), answers.used()), (None, (1, 1)));
        assert!(answers.add(b"\xff\xff\xff").is_err());
        coverage.actions = 1;
        assert_eq!(Counted::of(&coverage), None, "it would be lost");
        coverage.actions = 0;
        assert!(Counted::of(&coverage).is_some());
        coverage.robot(1).instants_in_reach = 1;
        assert_eq!(Counted::of(&coverage), None, "it would be lost, too");
    }
}
