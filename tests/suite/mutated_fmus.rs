//! Some thousand mutations of small FMUs and descriptions, the same at every run: no panic, no end without an end, a
//! message for every refusal, nothing written outside. The seeds and the rules are those of `fuzz/`, which goes further.

#[path = "../../fuzz/checks.rs"]
mod checks;

use std::io::{Cursor, Write as _};
use std::path::PathBuf;
use std::process::Command;
use std::sync::Mutex;

use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use zip::write::SimpleFileOptions;

/// The seeds in one folder of `fuzz/seeds`, sorted by name.
fn seeds(folder: &str) -> Vec<Vec<u8>> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fuzz/seeds").join(folder);
    let mut paths: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.sort();
    paths.iter().map(|path| std::fs::read(path).unwrap()).collect()
}

/// The words of `fuzz/description.dict`.
fn words() -> Vec<Vec<u8>> {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("fuzz/description.dict");
    let text = std::fs::read_to_string(path).unwrap();
    let quoted = text.lines().filter_map(|line| line.strip_prefix('"')?.strip_suffix('"'));
    quoted.map(|word| unescaped(word.as_bytes())).collect()
}

/// A dictionary word without its escapes: `\"` and `\xff`.
fn unescaped(word: &[u8]) -> Vec<u8> {
    match word {
        [b'\\', b'x', a, b, rest @ ..] => {
            let byte = u8::from_str_radix(std::str::from_utf8(&[*a, *b]).unwrap(), 16).unwrap();
            [vec![byte], unescaped(rest)].concat()
        }
        [b'\\', c, rest @ ..] | [c, rest @ ..] => [vec![*c], unescaped(rest)].concat(),
        [] => Vec::new(),
    }
}

/// Numbers that headers of archives do not expect, and what entries begin with.
fn zip_words() -> Vec<Vec<u8>> {
    let words: [&[u8]; 10] = [
        b"PK\x01\x02",
        b"PK\x03\x04",
        b"PK\x05\x06",
        b"PK\x06\x06",
        &[0xFF; 4],
        &[0; 4],
        &[0xFF; 8],
        b"../../../",
        b"modelDescription.xml",
        &[0, 0, 0, 0xA0],
    ];
    words.iter().map(|word| word.to_vec()).collect()
}

/// One change; places are parts of the whole length.
#[derive(Clone, Debug)]
enum Change {
    Flip(f64, u8),
    Set(f64, u8),
    Remove(f64, usize),
    Repeat(f64, usize, usize),
    Insert(f64, prop::sample::Index),
    Overwrite(f64, prop::sample::Index),
    Move(f64, f64, usize),
    Cut(f64),
}

fn change() -> impl Strategy<Value = Change> {
    let place = || 0.0..1.0_f64;
    prop_oneof![
        3 => (place(), 0..8_u8).prop_map(|(at, bit)| Change::Flip(at, bit)),
        2 => (place(), any::<u8>()).prop_map(|(at, byte)| Change::Set(at, byte)),
        2 => (place(), 1..40_usize).prop_map(|(at, length)| Change::Remove(at, length)),
        2 => (place(), 1..200_usize, 1..20_usize).prop_map(|(at, length, times)| Change::Repeat(at, length, times)),
        4 => (place(), any::<prop::sample::Index>()).prop_map(|(at, word)| Change::Insert(at, word)),
        2 => (place(), any::<prop::sample::Index>()).prop_map(|(at, word)| Change::Overwrite(at, word)),
        2 => (place(), place(), 1..200_usize).prop_map(|(from, to, length)| Change::Move(from, to, length)),
        1 => place().prop_map(Change::Cut),
    ]
}

#[allow(clippy::cast_possible_truncation, clippy::cast_sign_loss, clippy::cast_precision_loss, reason = "a place")]
fn apply(bytes: &mut Vec<u8>, change: &Change, words: &[Vec<u8>]) {
    let length = bytes.len();
    let at = |part: f64| ((part * length as f64) as usize).min(length.saturating_sub(1));
    match change {
        _ if bytes.is_empty() => {}
        Change::Flip(place, bit) => bytes[at(*place)] ^= 1 << bit,
        Change::Set(place, byte) => bytes[at(*place)] = *byte,
        Change::Remove(place, n) => drop(bytes.drain(at(*place)..(at(*place) + n).min(length))),
        Change::Repeat(place, n, times) => {
            let piece = bytes[at(*place)..(at(*place) + n).min(length)].repeat(*times);
            drop(bytes.splice(at(*place)..at(*place), piece));
        }
        Change::Insert(place, word) => drop(bytes.splice(at(*place)..at(*place), word.get(words).clone())),
        Change::Overwrite(place, word) => {
            let word = word.get(words);
            drop(bytes.splice(at(*place)..(at(*place) + word.len()).min(length), word.clone()));
        }
        Change::Move(from, to, n) => {
            let piece: Vec<u8> = bytes[at(*from)..(at(*from) + n).min(length)].to_vec();
            drop(bytes.splice(at(*to)..at(*to), piece));
        }
        Change::Cut(place) => bytes.truncate(at(*place)),
    }
}

#[allow(clippy::ptr_arg, reason = "tells what an index into the seeds gives")]
fn mutated(seed: &Vec<u8>, changes: &[Change], words: &[Vec<u8>]) -> Vec<u8> {
    let mut bytes = seed.clone();
    changes.iter().for_each(|change| apply(&mut bytes, change, words));
    bytes
}

fn runner(cases: u32) -> TestRunner {
    let config = Config { cases, failure_persistence: None, ..Config::default() };
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}

/// Both outcomes happened, often enough that the test says something.
fn both_ways(good: &Mutex<[u32; 2]>) {
    let [refused, accepted] = *good.lock().unwrap();
    assert!(refused > 30 && accepted > 30, "{refused} refused, {accepted} accepted");
}

fn count(outcomes: &Mutex<[u32; 2]>, good: bool) {
    outcomes.lock().unwrap()[usize::from(good)] += 1;
}

/// Runs a test of this file in a process of its own: the rules for archives watch the folder for temporary files, and what
/// the other tests of this process put there would be taken for something left behind.
fn alone(test: &str, run: impl FnOnce()) {
    const ALONE: &str = "FMI_HAZARD_TEST_ALONE";
    if std::env::var_os(ALONE).is_some() {
        return run();
    }
    let mut itself = Command::new(std::env::current_exe().unwrap());
    let output = itself.args(["--exact", &format!("mutated_fmus::{test}")]).env(ALONE, "1").output().unwrap();
    let printed = String::from_utf8_lossy(&output.stdout);
    assert!(output.status.success(), "{printed}{}", String::from_utf8_lossy(&output.stderr));
    assert!(printed.contains("1 passed"), "{printed}");
}

#[test]
fn seeds_are_what_they_should_be() {
    assert!(seeds("description").iter().all(|bytes| checks::description(bytes)));
    alone("seeds_are_what_they_should_be", || {
        // deflated, nested, stored: one of them is refused.
        let opened: Vec<_> = seeds("archive").iter().map(|bytes| checks::archive(bytes)).collect();
        assert_eq!(opened, [true, false, true]);
    });
}

#[test]
fn descriptions() {
    let (seeds, words, outcomes) = (seeds("description"), words(), Mutex::default());
    let cases = (any::<prop::sample::Index>(), prop::collection::vec(change(), 1..6));
    let result = runner(4000).run(&cases, |(seed, changes)| {
        count(&outcomes, checks::description(&mutated(seed.get(&seeds), &changes, &words)));
        Ok(())
    });
    result.unwrap();
    both_ways(&outcomes);
}

#[test]
fn bytes_of_archives() {
    alone("bytes_of_archives", || {
        let (seeds, words, outcomes) = (seeds("archive"), zip_words(), Mutex::default());
        let cases = (any::<prop::sample::Index>(), prop::collection::vec(change(), 1..3));
        let result = runner(1500).run(&cases, |(seed, changes)| {
            count(&outcomes, checks::archive(&mutated(seed.get(&seeds), &changes, &words)));
            Ok(())
        });
        result.unwrap();
        both_ways(&outcomes);
    });
}

#[test]
fn names_in_archives_and_descriptions_inside() {
    alone("names_in_archives_and_descriptions_inside", || {
        let (seeds, words, outcomes) = (seeds("description"), words(), Mutex::default());
        let part = prop::sample::select(vec![
            "..",
            ".",
            "",
            "a",
            "b",
            "A",
            "modelDescription.xml",
            "c:",
            "\\..",
            "\u{202e}",
            "\n",
        ]);
        let name = prop::collection::vec(part, 1..6).prop_map(|parts| parts.join("/"));
        let cases = (
            any::<prop::sample::Index>(),
            prop::collection::vec(change(), 0..2),
            prop::collection::vec(name, 0..4),
            prop::collection::vec(any::<bool>(), 4),
        );
        let result = runner(1500).run(&cases, |(seed, changes, names, links)| {
            let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
            archive.start_file("modelDescription.xml", SimpleFileOptions::default()).unwrap();
            archive.write_all(&mutated(seed.get(&seeds), &changes, &words)).unwrap();
            for (name, link) in names.iter().zip(&links) {
                // The library refuses to write the same name twice.
                let _ = if *link && name.len() % 3 == 0 {
                    archive.add_symlink(name.as_str(), "/", SimpleFileOptions::default())
                } else {
                    archive.start_file(name.as_str(), SimpleFileOptions::default())
                };
            }
            count(&outcomes, checks::archive(&archive.finish().unwrap().into_inner()));
            Ok(())
        });
        result.unwrap();
        both_ways(&outcomes);
    });
}
