//! What a program is told on standard error with `--progress json`: one JSON object a line.

use std::time::{Duration, Instant};

use schemars::JsonSchema;
use serde::Serialize;

use crate::record::hazard::Hazard;

/// Shortest time between two lines on how far something is.
pub(super) const BETWEEN: Duration = Duration::from_millis(100);

/// A line on standard error with `--progress json`. There may be other lines: what the system says, or a mistake in the options.
#[derive(Debug, Serialize, JsonSchema)]
#[serde(tag = "event", rename_all = "snake_case")]
pub(super) enum Event<'a> {
    /// What is being done, whenever that changes.
    Doing {
        /// In words.
        text: &'a str,
    },
    /// How far it is, at most ten times a second.
    Progress {
        /// So many are done.
        done: u64,
        /// Of so many. A search of all sequences begins anew with each action.
        total: u64,
        /// What is counted.
        unit: &'a str,
        /// What came of it so far, in words.
        text: &'a str,
    },
    /// A hazard was found. It is not confirmed yet: what counts stands in the results.
    Hazard {
        /// As in hazards.jsonl.
        hazard: &'a Hazard,
    },
    /// The results are written into this folder.
    Results {
        /// From the folder in which the program was started.
        folder: String,
    },
    /// Something to know.
    Note {
        /// In words.
        text: &'a str,
    },
    /// Something that may make a result mean something else.
    Warning {
        /// In words.
        text: &'a str,
    },
    /// Why the program ends, or why a part of its work was left out.
    Error {
        /// What it is, and what to do about it.
        text: &'a str,
    },
}

/// Tells what changes all the time only now and then.
#[derive(Debug, Default)]
pub(super) struct Sometimes(Option<Instant>);

impl Sometimes {
    /// Whether it is time again, or this is the `last`.
    pub(super) fn again(&mut self, last: bool) -> bool {
        let due = last || self.0.is_none_or(|told| told.elapsed() >= BETWEEN);
        if due {
            self.0 = Some(Instant::now());
        }
        due
    }
}

/// The same as Ctrl-C at a terminal.
pub(super) fn interrupt() {
    let _ = rustix::process::kill_process(rustix::process::getpid(), rustix::process::Signal::INT);
}
