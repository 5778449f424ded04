//! Answers to questions whether people can be touched, each known by a digest of all that it follows from and nothing
//! else. So a search that was interrupted can go on, and several machines can share one search out.
//!
//! The search itself is not written down: it is deterministic and is simply run again. Nearly all its time goes into
//! such questions. Those that were answered before are looked up, whoever asked them and in whatever order; the others
//! are worked out. So what is looked up saves work, and never changes a result. What is the same in the whole search
//! (cell, FMU, program) is not part of what a question is known by: it stands at the top of a file.
//!
//! A [`Share`] of a search answers its own questions only; of these it answers the same in whatever order and however
//! often it is run. With the answers of all shares the whole search has the result of one that nobody divided.

mod records;

use std::collections::BTreeMap;
use std::fmt;
use std::fs::{File, OpenOptions};
use std::hash::Hasher;
use std::io;
use std::path::Path;
use std::str::FromStr;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};

use serde::Serialize;
use serde::de::DeserializeOwned;
use sha2::{Digest as _, Sha256};

use super::Coverage;

/// What a question is known by: a part of the SHA-256 of what it follows from.
pub type Key = [u8; 16];

/// Answers by what their questions are known by, each with what was counted on the way. See the top of this file.
#[derive(Debug, Default)]
pub struct Answers {
    known: Mutex<BTreeMap<Key, Vec<u8>>>,
    keeps: Keeps,
    share: Option<Share>,
    remembered: AtomicU64,
    asked: AtomicU64,
}

/// What becomes of new answers.
#[derive(Debug, Default)]
enum Keeps {
    #[default]
    Nothing,
    InMemory,
    /// As long as it can be written.
    InFile(Mutex<Option<File>>),
}

impl Answers {
    /// Those at `path` of the search that `subject` describes; none if there is no file. What follows is added to it.
    ///
    /// # Errors
    /// When the file cannot be read or written, or is that of another search.
    pub fn open(path: &Path, subject: &str) -> io::Result<Self> {
        let mut file = OpenOptions::new().read(true).append(true).create(true).open(path)?;
        let bytes = std::fs::read(path)?;
        let (records, end) = records::read(&bytes, subject)?;
        file.set_len(end as u64)?;
        if end == 0 {
            records::append(&mut file, subject.as_bytes())?;
        }
        let this = Self { keeps: Keeps::InFile(Mutex::new(Some(file))), ..Self::default() };
        this.know(&records);
        Ok(this)
    }

    /// None yet, of a share of a search; they are kept until they are given away.
    #[must_use]
    pub fn in_memory(share: Share) -> Self {
        Self { keeps: Keeps::InMemory, share: Some(share), ..Self::default() }
    }

    /// The same for one share of the search, if it is shared out.
    #[must_use]
    pub fn only(self, share: Option<Share>) -> Self {
        Self { share, ..self }
    }

    /// All that are known, the same bytes in whatever order they came.
    ///
    /// # Errors
    /// Never, in practice.
    pub fn to_bytes(&self, subject: &str) -> io::Result<Vec<u8>> {
        let mut bytes = Vec::new();
        records::append(&mut bytes, subject.as_bytes())?;
        for (key, answer) in &*lock(&self.known) {
            records::append(&mut bytes, &[&key[..], answer].concat())?;
        }
        Ok(bytes)
    }

    /// Takes in what another run of the same search answered: its file, or what [`Self::to_bytes`] gave.
    ///
    /// # Errors
    /// When it is that of another search, or something else.
    pub fn take_in(&self, bytes: &[u8], subject: &str) -> io::Result<()> {
        let (records, end) = records::read(bytes, subject)?;
        self.know(&records);
        if end == 0 { Err(io::Error::other("it holds no answers")) } else { Ok(()) }
    }

    fn know(&self, records: &[&[u8]]) {
        let answers = records.iter().filter_map(|record| record.split_first_chunk());
        lock(&self.known).extend(answers.map(|(key, answer)| (*key, answer.to_vec())));
    }

    /// The share of the search that they are of, if not of all.
    #[must_use]
    pub const fn share(&self) -> Option<Share> {
        self.share
    }

    /// Whether it matters what questions are known by.
    pub fn is_used(&self) -> bool {
        self.share.is_some() || !matches!(self.keeps, Keeps::Nothing) || !lock(&self.known).is_empty()
    }

    /// Whether the search is shared out, or put together from what shares answered.
    pub const fn is_shared_out(&self) -> bool {
        self.share.is_some() || !matches!(self.keeps, Keeps::InFile(_))
    }

    /// Questions whose answers were known from before, and all.
    #[must_use]
    pub fn remembered(&self) -> (u64, u64) {
        (self.remembered.load(Ordering::Relaxed), self.asked.load(Ordering::Relaxed))
    }

    /// What is known under this key, which so many questions have together, and what was counted for it.
    pub fn get<T: DeserializeOwned>(&self, key: &Key, questions: u64) -> Option<(T, Coverage)> {
        self.asked.fetch_add(questions, Ordering::Relaxed);
        let known = lock(&self.known).get(key).and_then(|bytes| postcard::from_bytes(bytes).ok())?;
        self.remembered.fetch_add(questions, Ordering::Relaxed);
        Some(known)
    }

    /// Keeps an answer, if any are kept. A full disk must not end the search: what is not written is worked out again.
    pub fn keep(&self, key: &Key, answer: &impl Serialize, counted: &Coverage) {
        if matches!(self.keeps, Keeps::Nothing) {
            return;
        }
        let Ok(bytes) = postcard::to_stdvec(&(answer, counted)) else { return };
        let Keeps::InFile(file) = &self.keeps else {
            lock(&self.known).insert(*key, bytes);
            return;
        };
        let mut file = lock(file);
        if file.as_mut().is_some_and(|file| records::append(file, &[&key[..], &bytes].concat()).is_err()) {
            // Nothing is found behind a record that was written in part.
            *file = None;
        }
    }

    /// What `work` answers to a question, or has answered before. What `is_cut_short` is not kept.
    pub fn answer<T: Serialize + DeserializeOwned>(
        &self,
        key: impl FnOnce() -> Key,
        coverage: &mut Coverage,
        is_cut_short: impl FnOnce() -> bool,
        work: impl FnOnce(&mut Coverage) -> T,
    ) -> T {
        if !self.is_used() {
            return work(coverage);
        }
        let key = key();
        let (answer, counted) = self.get(&key, 1).unwrap_or_else(|| {
            let mut counted = Coverage::new(coverage.sensor_actions.len());
            let answer = work(&mut counted);
            if !is_cut_short() {
                self.keep(&key, &answer, &counted);
            }
            (answer, counted)
        });
        coverage.merge(&counted);
        answer
    }
}

fn lock<T>(of: &Mutex<T>) -> MutexGuard<'_, T> {
    of.lock().unwrap_or_else(PoisonError::into_inner)
}

/// One of so many shares of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Share {
    /// Which one, from 1.
    pub number: u32,
    /// Of so many.
    pub of: u32,
}

impl Share {
    /// All of so many.
    pub fn all(of: u32) -> impl Iterator<Item = Self> {
        (1..=of).map(move |number| Self { number, of })
    }

    /// Whether what is known by this key is its own: each key is that of one of them.
    pub fn owns(self, key: &Key) -> bool {
        u128::from_le_bytes(*key) % u128::from(self.of) == u128::from(self.number - 1)
    }
}

impl FromStr for Share {
    type Err = String;

    /// As `2/4`, the second of four.
    fn from_str(text: &str) -> Result<Self, String> {
        let parts = text.split_once('/').and_then(|(number, of)| Some((number.parse().ok()?, of.parse().ok()?)));
        match parts {
            Some((number, of)) if (1..=of).contains(&number) => Ok(Self { number, of }),
            _ => Err("give a part as 2/4, the second of four".to_owned()),
        }
    }
}

impl fmt::Display for Share {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "{}/{}", self.number, self.of)
    }
}

/// What things come to, as a key.
#[derive(Default)]
pub struct Digest(Sha256);

impl Digest {
    /// Numbers, with how many they are, so that they do not run into what follows.
    pub fn numbers(&mut self, numbers: &[f64]) {
        self.write_usize(numbers.len());
        numbers.iter().for_each(|number| self.write_u64(number.to_bits()));
    }

    /// What it all came to.
    pub fn key(self) -> Key {
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

    fn key(of: u64) -> Key {
        let mut digest = Digest::default();
        digest.write_u64(of);
        digest.key()
    }

    /// What is answered to a question, what was counted, and whether it was worked out now.
    fn ask(answers: &Answers, of: u64, is_cut_short: bool) -> (u64, u64, bool) {
        let (mut coverage, mut worked) = (Coverage::new(1), false);
        let work = |coverage: &mut Coverage| {
            worked = true;
            coverage.arm_boxes += 7;
            coverage.robot(1).closest_approach_m = 0.25;
            2 * of
        };
        let answer = answers.answer(|| key(of), &mut coverage, || is_cut_short, work);
        assert!((coverage.robots[1].closest_approach_m - 0.25).abs() < 1e-9, "which robot was how near");
        (answer, coverage.arm_boxes, worked)
    }

    fn fill(answers: &Answers, all: impl IntoIterator<Item = u64>) {
        assert!(all.into_iter().all(|of| ask(answers, of, false).2));
    }

    #[test]
    fn what_was_answered_is_known_again_and_what_was_cut_short_is_not() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("answers.bin");
        let answers = Answers::open(&path, "cell").unwrap();
        assert_eq!((ask(&answers, 3, false), ask(&answers, 4, true)), ((6, 7, true), (8, 7, true)));
        let again = Answers::open(&path, "cell").unwrap();
        assert_eq!((ask(&again, 3, false), ask(&again, 4, false)), ((6, 7, false), (8, 7, true)));
        assert_eq!(again.remembered(), (1, 2));
        assert_eq!(again.get::<u64>(&key(3), 5).map(|(answer, _)| answer), Some(6));
        assert_eq!(again.remembered(), (6, 7), "several questions under one key");
        let none = Answers::default();
        assert!(!none.is_used() && ask(&none, 3, false).2 && ask(&none, 3, false).2 && none.remembered() == (0, 0));
    }

    #[test]
    fn a_torn_end_is_left_out_and_another_search_is_refused() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("answers.bin");
        let open = || Answers::open(&path, "cell").unwrap();
        let known = |answers: &Answers, of: u64| answers.get::<u64>(&key(of), 1).is_some();
        let answers = open();
        fill(&answers, 1..=3);
        let whole = std::fs::read(&path).unwrap();
        for (cut, kept) in [(0, 3), (1, 2), (30, 2)] {
            std::fs::write(&path, &whole[..whole.len() - cut]).unwrap();
            let again = open();
            assert!((1..=4).all(|of| known(&again, of) == (of <= kept)), "{cut}");
            assert!(ask(&again, 9, false).2);
            let further = open();
            // In any order.
            assert!((1..=9).rev().all(|of| known(&further, of) == (of <= kept || of == 9)), "{cut}");
        }
        assert!(Answers::open(&path, "another cell").is_err());
        std::fs::write(&path, &whole[..5]).unwrap();
        assert!(!known(&open(), 1) && Answers::open(&path, "another cell").is_err(), "a new one");
    }

    #[test]
    fn damage_in_the_middle_ends_what_is_known() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("answers.bin");
        let answers = Answers::open(&path, "cell").unwrap();
        fill(&answers, 1..=1);
        let first = std::fs::metadata(&path).unwrap().len();
        fill(&answers, 2..=4);
        let mut bytes = std::fs::read(&path).unwrap();
        bytes[usize::try_from(first).unwrap() + 20] ^= 1;
        std::fs::write(&path, bytes).unwrap();
        let again = Answers::open(&path, "cell").unwrap();
        assert_eq!([1, 2, 3, 4].map(|of| ask(&again, of, false).2), [false, true, true, true]);
    }

    #[test]
    fn what_shares_answered_is_put_together_in_any_order() {
        let shares: Vec<Share> = Share::all(2).collect();
        let answered = |share: Share, order: &[u64]| {
            let answers = Answers::in_memory(share);
            fill(&answers, order.iter().copied().filter(|of| share.owns(&key(*of))));
            answers.to_bytes("cell").unwrap()
        };
        let (order, reversed): (Vec<u64>, Vec<u64>) = ((0..20).collect(), (0..20).rev().collect());
        assert!(shares.iter().all(|share| answered(*share, &order) == answered(*share, &reversed)));
        let merged = Answers::default();
        for share in shares.into_iter().rev() {
            merged.take_in(&answered(share, &order), "cell").unwrap();
        }
        assert!(order.iter().all(|of| ask(&merged, *of, false) == (2 * of, 7, false)));
        assert!(ask(&merged, 20, false).2, "nobody answered it");
        assert_eq!(merged.remembered(), (20, 21));
        let bytes = merged.to_bytes("cell").unwrap();
        assert!(merged.take_in(&bytes, "another cell").is_err() && merged.take_in(b"\xff\xff\xff", "cell").is_err());
    }

    #[test]
    fn every_key_belongs_to_exactly_one_share() {
        let mut counts = [0; 4];
        for n in 0..400 {
            let owners: Vec<usize> =
                Share::all(4).enumerate().filter(|(_, s)| s.owns(&key(n))).map(|(n, _)| n).collect();
            assert_eq!(owners.len(), 1);
            counts[owners[0]] += 1;
        }
        assert!(counts.iter().all(|count| (70..130).contains(count)), "{counts:?}");
        let second: Share = "2/4".parse().unwrap();
        assert_eq!((Share::all(4).nth(1), second.to_string().as_str()), (Some(second), "2/4"));
        for wrong in ["0/4", "5/4", "1", "a/b", "1/0"] {
            assert!(wrong.parse::<Share>().is_err(), "{wrong}");
        }
    }
}
