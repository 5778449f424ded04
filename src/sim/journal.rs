//! What an exhaustive search has worked out so far, on disk: so that one that was interrupted can go on.
//!
//! The search itself is not written down: it is deterministic and is simply run again. Nearly all its time goes into
//! questions whether a person can be touched, which it asks in blocks, always in the same order. For each block the
//! journal holds which questions found something, and what was counted on the way; only those few are worked out again.
//!
//! What the FMU gave until then is part of what a block is known by, so the answers of a search on one rung of the ladder of
//! states are those of another one only where the FMU gave the same to the last bit.
//!
//! A block is written when it is complete. A torn end of the file, after a power failure say, is left out.

use std::collections::VecDeque;
use std::fs::{File, OpenOptions};
use std::io::{self, Write as _};
use std::path::Path;
use std::sync::Arc;

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::Coverage;
use super::answers::{Answers, Share, Sharing};

/// The answers to a block of questions.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub(super) struct Block {
    /// How many questions were asked, a digest of them, after which answers of the FMU.
    pub asked: (u64, u64, u64),
    /// Which found something: number of the stance, and of the question about it.
    pub found: Vec<(u32, u32)>,
    /// What was counted.
    pub coverage: Coverage,
}

/// The blocks of one search. Without a file it holds nothing.
#[derive(Debug, Default)]
pub struct Journal {
    file: Option<File>,
    known: VecDeque<Block>,
    remembered: u64,
    /// Whether other machines have a part in it.
    pub(super) sharing: Sharing,
}

/// Bytes of the checksum before each record.
const CHECK: usize = 8;

impl Journal {
    /// The journal at `path` of the search that `subject` describes; empty if there is none. What follows is added to it.
    ///
    /// # Errors
    /// When the file cannot be read or written, or is that of another search.
    pub(crate) fn open(path: &Path, subject: &str) -> io::Result<Self> {
        let (file, records) = read_records(path, subject)?;
        let known = records.iter().map_while(|bytes| postcard::from_bytes(bytes).ok()).collect();
        Ok(Self { file: Some(file), known, ..Self::default() })
    }

    /// That of a search which answers a part of its questions only.
    #[must_use]
    pub(crate) fn of_part(share: Share) -> Self {
        Self { sharing: Sharing::Share(share), ..Self::default() }
    }

    /// That of a search whose questions were answered elsewhere.
    #[must_use]
    pub(crate) fn looking_up(answers: Arc<Answers>) -> Self {
        Self { sharing: Sharing::LookUp(answers), ..Self::default() }
    }

    /// What a part has answered.
    #[must_use]
    pub(crate) fn into_part(self) -> Option<Share> {
        if let Sharing::Share(share) = self.sharing { Some(share) } else { None }
    }

    /// The next block, if it was worked out before.
    pub(super) fn next(&mut self, asked: (u64, u64, u64)) -> Option<Block> {
        let block = self.known.pop_front()?;
        if block.asked != asked {
            // Not this search after all; what is left is worked out again.
            self.known.clear();
            return None;
        }
        self.remembered += asked.0;
        Some(block)
    }

    /// A block was worked out. A full disk must not end the search.
    pub(super) fn add(&mut self, block: &Block) {
        let Some(file) = &mut self.file else { return };
        let written = postcard::to_stdvec(block).map_err(io::Error::other).and_then(|bytes| append(file, &bytes));
        if written.is_err() {
            self.file = None;
        }
    }

    /// Whether blocks are kept at all.
    pub(super) const fn keeps(&self) -> bool {
        self.file.is_some()
    }

    /// Questions whose answers were known from before.
    #[must_use]
    pub(crate) const fn remembered(&self) -> u64 {
        self.remembered
    }
}

/// The file at `path` with records of the search that `subject` describes, ready for more of them, and those that are whole; a new
/// one if there is none.
///
/// # Errors
/// When the file cannot be read or written, or is that of another search.
pub(super) fn read_records(path: &Path, subject: &str) -> io::Result<(File, Vec<Vec<u8>>)> {
    let mut file = OpenOptions::new().read(true).append(true).create(true).open(path)?;
    let bytes = std::fs::read(path)?;
    let mut rest = bytes.as_slice();
    let Some(found) = record(&mut rest) else {
        file.set_len(0)?;
        append(&mut file, subject.as_bytes())?;
        return Ok((file, Vec::new()));
    };
    if found != subject.as_bytes() {
        return Err(io::Error::other(
            "it is that of another search: the cell, the FMU, a setting or this program differs",
        ));
    }
    let mut known = Vec::new();
    let mut good = bytes.len() - rest.len();
    while let Some(bytes_of) = record(&mut rest) {
        known.push(bytes_of.to_vec());
        good = bytes.len() - rest.len();
    }
    file.set_len(good as u64)?;
    Ok((file, known))
}

/// One record: its checksum, its length, its bytes.
pub(super) fn append(file: &mut File, bytes: &[u8]) -> io::Result<()> {
    let length = u32::try_from(bytes.len()).map_err(io::Error::other)?;
    let mut record = Sha256::digest(bytes)[..CHECK].to_vec();
    record.extend(length.to_le_bytes());
    record.extend(bytes);
    file.write_all(&record)
}

/// The next whole and undamaged record.
fn record<'a>(rest: &mut &'a [u8]) -> Option<&'a [u8]> {
    let (check, after) = rest.split_at_checked(CHECK)?;
    let (length, after) = after.split_first_chunk::<4>()?;
    let (bytes, after) = after.split_at_checked(usize::try_from(u32::from_le_bytes(*length)).ok()?)?;
    if Sha256::digest(bytes)[..CHECK] != *check {
        return None;
    }
    *rest = after;
    Some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn block(asked: u64) -> Block {
        let mut coverage = Coverage::new(2);
        coverage.arm_boxes = asked * 3;
        Block { asked: (asked, 1, 5), found: vec![(0, 7)], coverage }
    }

    #[test]
    fn what_was_added_is_there_again_and_a_torn_end_is_left_out() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal.bin");
        let mut journal = Journal::open(&path, "cell").unwrap();
        (1..=3).for_each(|i| journal.add(&block(i)));
        let whole = std::fs::read(&path).unwrap();
        for (cut, blocks) in [(0, 3), (1, 2), (30, 2)] {
            std::fs::write(&path, &whole[..whole.len() - cut]).unwrap();
            let mut again = Journal::open(&path, "cell").unwrap();
            for i in 1..=blocks {
                assert_eq!(again.next((i, 1, 5)), Some(block(i)), "{cut}");
            }
            assert_eq!(again.next((9, 1, 5)), None);
            again.add(&block(9));
            let mut further = Journal::open(&path, "cell").unwrap();
            assert_eq!(further.known.len() as u64, blocks + 1);
            assert_eq!(further.next((1, 1, 6)), None, "the same question about another FMU");
            assert_eq!(further.next((2, 1, 5)), None, "and nothing after it");
        }
        assert!(Journal::open(&path, "another cell").is_err());
    }

    #[test]
    fn damage_in_the_middle_ends_what_is_known() {
        let dir = tempfile::tempdir().unwrap();
        let path = dir.path().join("journal.bin");
        let mut journal = Journal::open(&path, "cell").unwrap();
        journal.add(&block(1));
        let first = std::fs::metadata(&path).unwrap().len();
        (2..=4).for_each(|i| journal.add(&block(i)));
        let mut bytes = std::fs::read(&path).unwrap();
        bytes[usize::try_from(first).unwrap() + 20] ^= 1;
        std::fs::write(&path, bytes).unwrap();
        assert_eq!(Journal::open(&path, "cell").unwrap().known, [block(1)]);
    }
}
