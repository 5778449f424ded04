//! What the program and its workers say to each other: one message there and one back for each action.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::fmi::Fmu;
use crate::host::plant::{Fingerprint, PlantError};
use crate::host::selftest::{SelfTest, Stage};
use crate::host::system::SystemSetup;

/// What is asked of a worker.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum Question {
    /// Load these FMUs. The first question.
    Load(Box<Load>),
    /// [`crate::host::selftest::selftest`].
    SelfTest { steps: usize, skip: Vec<Stage> },
    /// So many runs of so many steps with moving inputs, and what the FMU does to the process meanwhile.
    Habits { steps: usize, runs: usize },
    /// [`crate::host::Plant::restart`].
    Restart,
    /// [`crate::host::Plant::advance`].
    Advance { steps: usize, inputs: Vec<f64> },
    /// [`crate::host::Plant::save`], under this number.
    Save { number: u32, how: Saving },
    /// [`crate::host::Plant::restore`].
    Restore { number: u32, how: Saving },
    /// States the FMU saved that nobody needs any more.
    Forget(Vec<u32>),
    /// [`crate::host::Plant::fingerprint`].
    Fingerprint,
}

/// How a worker keeps a state.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Saving {
    /// The FMU does.
    ByFmu,
    /// A copy of the process, parked.
    ByFork,
}

/// An FMU that was opened by the program.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Unpacked {
    /// Where it was opened from, for messages.
    pub path: PathBuf,
    /// Where its files are.
    pub folder: PathBuf,
}

impl Unpacked {
    /// The files of `fmu`, which must live as long as they are needed.
    #[must_use]
    pub fn of(fmu: &Fmu) -> Self {
        Self { path: fmu.path().to_owned(), folder: fmu.folder().to_owned() }
    }
}

/// What a worker needs to know of its FMUs.
#[derive(Clone, Debug, Serialize, Deserialize)]
pub(super) struct Load {
    /// The FMUs.
    pub fmus: Vec<Unpacked>,
    /// What is written and read.
    pub setup: SystemSetup,
    /// Whether each FMU is driven with its event mode, where that is known already.
    pub event_mode: Option<Vec<bool>>,
    /// What the worker must not do.
    pub sandbox: Option<super::sandbox::Rules>,
}

/// What a worker answers.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum Answer {
    /// Done.
    Done,
    /// The FMUs are loaded; what of the sandbox this system lacks.
    Loaded { missing: Vec<String> },
    /// They cannot be loaded.
    NotLoaded { message: String, running: bool },
    /// Outputs, row-major.
    Rows(Vec<f64>),
    /// The self-test's result, as JSON, and the event modes it settled on.
    Tested { result: String, event_mode: Vec<bool> },
    /// See [`Question::Fingerprint`].
    Print(Option<Fingerprint>),
    /// See [`Question::Habits`]; as JSON.
    Habits(String),
    /// The FMU failed.
    Failed(PlantError),
}

impl Answer {
    /// The result of the self-test.
    pub(super) fn tested(result: &SelfTest, event_mode: Vec<bool>) -> Self {
        Self::Tested { result: serde_json::to_string(result).unwrap_or_default(), event_mode }
    }
}
