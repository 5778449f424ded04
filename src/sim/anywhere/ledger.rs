//! Answers to questions about sets of poses, on disk: so that a search that was interrupted can go on, and so that one search can be
//! done in parts, on many machines.
//!
//! The search itself is not written down: it is deterministic and is simply run again. Nearly all its time goes into questions about
//! squares of the floor in one history of the FMU. Each is known by a digest of all that its answer depends on; what is the
//! same in the whole search (cell, FMU, program, until when) stands at the top of the file. So the order does not matter, nor who asked.
//!
//! A part answers the questions about its own share of the first squares, chosen by a digest, and everything that follows from them.
//! With the answers of all parts the whole search has the result of one that nobody divided; what no part answered is worked out then.

use std::collections::BTreeMap;
use std::fs::File;
use std::io;
use std::path::Path;
use std::str::FromStr;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::History;
use crate::human::PoseBox;
use crate::sim::Coverage;
use crate::sim::journal::{append, read_records};

/// What a question is known by.
type Key = [u8; 32];

/// One of so many parts of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Share {
    /// Which one, from 0.
    number: u32,
    /// Of so many.
    of: u32,
}

impl FromStr for Share {
    type Err = String;

    /// As `2/4`, the second of four.
    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
        match parts {
            Some((number, of)) if (1..=of).contains(&number) => Ok(Self { number: number - 1, of }),
            _ => Err("give a part as 2/4, the second of four".to_owned()),
        }
    }
}

impl std::fmt::Display for Share {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{}/{}", self.number + 1, self.of)
    }
}

/// See the top of this file. Without a file nothing is written, and nothing is known.
#[derive(Debug, Default)]
pub struct Ledger {
    file: Option<Mutex<File>>,
    known: BTreeMap<Key, Vec<u8>>,
    share: Option<Share>,
    remembered: AtomicU64,
    asked: AtomicU64,
}

/// A question's answer, and what was counted on the way.
#[derive(Serialize, Deserialize)]
struct Answer<T> {
    key: Key,
    answer: T,
    coverage: Coverage,
}

impl Ledger {
    /// The one at `path` of the search that `subject` describes; empty if there is none. What follows is added to it.
    ///
    /// # Errors
    /// When the file cannot be read or written, or is that of another search.
    pub fn open(path: &Path, subject: &str) -> io::Result<Self> {
        let (file, records) = read_records(path, subject)?;
        let mut this = Self { file: Some(Mutex::new(file)), ..Self::default() };
        this.know(records);
        Ok(this)
    }

    /// Takes in what another run of the same search answered.
    ///
    /// # Errors
    /// When the file cannot be read, or is that of another search.
    pub fn take_in(&mut self, path: &Path, subject: &str) -> io::Result<()> {
        // There must be one: nothing is made where answers of others are.
        std::fs::metadata(path)?;
        let (_, records) = read_records(path, subject)?;
        self.know(records);
        Ok(())
    }

    fn know(&mut self, records: Vec<Vec<u8>>) {
        for bytes in records {
            if let Some(key) = bytes.first_chunk() {
                self.known.insert(*key, bytes);
            }
        }
    }

    /// The same for one part of the search.
    #[must_use]
    pub fn only(self, share: Option<Share>) -> Self {
        Self { share, ..self }
    }

    /// The part that it is for, if not for all.
    #[must_use]
    pub(crate) const fn share(&self) -> Option<Share> {
        self.share
    }

    /// Questions whose answers were known from before, and all.
    #[must_use]
    pub fn remembered(&self) -> (u64, u64) {
        (self.remembered.load(Ordering::Relaxed), self.asked.load(Ordering::Relaxed))
    }

    /// The questions about one history.
    pub(super) fn about<'a>(&'a self, histories: [&History; 2]) -> Questions<'a> {
        let mut digest = Sha256::new();
        if self.file.is_some() || !self.known.is_empty() || self.share.is_some() {
            histories.iter().for_each(|history| history.tell(&mut digest));
        }
        Questions { ledger: self, about: digest.finalize().into() }
    }

    fn write(&self, record: &[u8]) {
        if let Some(file) = &self.file {
            // A full disk must not end the search: what is not written is worked out again.
            let _ = append(&mut file.lock().unwrap_or_else(PoisonError::into_inner), record);
        }
    }
}

/// Questions about one history.
#[derive(Debug)]
pub(super) struct Questions<'a> {
    ledger: &'a Ledger,
    about: Key,
}

impl Questions<'_> {
    /// Whether the questions about a first square belong to this part.
    pub(crate) fn are_own(&self, square: &PoseBox) -> bool {
        self.ledger.share.is_none_or(|Share { number, of }| {
            let bytes = self.key("share", square);
            let (first, _) = bytes.split_at(8);
            first.iter().fold(0, |rest, byte| (rest * 256 + u64::from(*byte)) % u64::from(of)) == u64::from(number)
        })
    }

    fn key(&self, stage: &str, item: &impl Serialize) -> Key {
        let mut digest = Sha256::new();
        digest.update(self.about);
        digest.update(stage);
        digest.update(postcard::to_stdvec(item).unwrap_or_default());
        digest.finalize().into()
    }

    /// What `work` answers about an item at one stage of the search, or has answered before. What `is_cut_short` is not kept.
    pub(crate) fn answer<T: Serialize + DeserializeOwned>(
        &self,
        (stage, item): (&str, &impl Serialize),
        coverage: &mut Coverage,
        is_cut_short: impl FnOnce() -> bool,
        work: impl FnOnce(&mut Coverage) -> T,
    ) -> T {
        let ledger = self.ledger;
        if ledger.file.is_none() && ledger.known.is_empty() {
            return work(coverage);
        }
        ledger.asked.fetch_add(1, Ordering::Relaxed);
        let key = self.key(stage, item);
        let known = ledger.known.get(&key).and_then(|bytes| postcard::from_bytes::<Answer<T>>(bytes).ok());
        if let Some(known) = known {
            ledger.remembered.fetch_add(1, Ordering::Relaxed);
            coverage.merge(&known.coverage);
            return known.answer;
        }
        let mut own = Coverage::new(coverage.sensor_actions.len());
        let answer = work(&mut own);
        coverage.merge(&own);
        if ledger.file.is_some() && !is_cut_short() {
            let answer = Answer { key, answer, coverage: own };
            ledger.write(&postcard::to_stdvec(&answer).unwrap_or_default());
            return answer.answer;
        }
        answer
    }
}

impl History {
    /// Everything that answers about it depend on.
    fn tell(&self, digest: &mut Sha256) {
        let numbers = |digest: &mut Sha256, all: &mut dyn Iterator<Item = f64>| {
            all.for_each(|number| digest.update(number.to_bits().to_le_bytes()));
        };
        digest.update(format!("{:?} {:?} {}", self.readings, self.links, self.seen.len()));
        for field in &self.fields {
            numbers(digest, &mut field.all().iter().copied());
        }
        for seen in &self.seen {
            digest.update(format!("{} {} ", seen.step, seen.lasting));
            numbers(digest, &mut seen.within_m.into_iter().chain([seen.depth_m]));
            numbers(digest, &mut seen.frame.outputs().iter().copied());
            // As large and as fast as they are here.
            numbers(digest, &mut seen.frame.links.iter().map(|link| link.bounding_sphere().1));
            numbers(digest, &mut seen.frame.speed_bounds.iter().copied());
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn square(x: f64) -> PoseBox {
        PoseBox::point([x, 1.0], 0.0)
    }

    fn ask(questions: &Questions<'_>, x: f64, is_cut_short: bool) -> (f64, u64, bool) {
        let (mut coverage, mut worked) = (Coverage::new(1), false);
        let answer: f64 = questions.answer(
            ("first", &square(x)),
            &mut coverage,
            || is_cut_short,
            |coverage| {
                worked = true;
                coverage.arm_boxes += 7;
                2.0 * x
            },
        );
        (answer, coverage.arm_boxes, worked)
    }

    #[test]
    fn what_was_answered_is_known_again_and_what_was_cut_short_is_not() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("answers.bin");
        let ledger = Ledger::open(&path, "cell").unwrap();
        let questions = Questions { ledger: &ledger, about: [1; 32] };
        assert_eq!((ask(&questions, 3.0, false), ask(&questions, 4.0, true)), ((6.0, 7, true), (8.0, 7, true)));
        let again = Ledger::open(&path, "cell").unwrap();
        let questions = Questions { ledger: &again, about: [1; 32] };
        assert_eq!((ask(&questions, 3.0, false), ask(&questions, 4.0, false)), ((6.0, 7, false), (8.0, 7, true)));
        assert_eq!(again.remembered(), (1, 2));
        // Another history, another search.
        assert!(ask(&Questions { ledger: &again, about: [2; 32] }, 3.0, false).2);
        assert!(Ledger::open(&path, "another cell").is_err());
        let mut merged = Ledger::default();
        assert!(merged.take_in(&dir.path().join("none.bin"), "cell").is_err());
        merged.take_in(&path, "cell").unwrap();
        assert!(!ask(&Questions { ledger: &merged, about: [1; 32] }, 4.0, false).2);
    }

    #[test]
    fn every_square_belongs_to_exactly_one_part() {
        let mut counts = [0; 4];
        for n in 0..400 {
            let at = square(f64::from(n));
            let owners: Vec<usize> = (0..4_usize)
                .filter(|number| {
                    let share = format!("{}/4", number + 1).parse().unwrap();
                    let ledger = Ledger::default().only(Some(share));
                    Questions { ledger: &ledger, about: [3; 32] }.are_own(&at)
                })
                .collect();
            assert_eq!(owners.len(), 1);
            counts[owners[0]] += 1;
        }
        assert!(counts.iter().all(|count| (70..130).contains(count)), "{counts:?}");
        for wrong in ["0/4", "5/4", "1", "a/b", "1/0"] {
            assert!(wrong.parse::<Share>().is_err(), "{wrong}");
        }
    }
}
