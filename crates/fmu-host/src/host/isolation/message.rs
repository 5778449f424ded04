//! What the program and its workers say to each other: one message there and one back for each action.

use std::path::PathBuf;

use serde::{Deserialize, Serialize};

use crate::fmi::Fmu;
use crate::host::plant::{Fingerprint, PlantError, Reads};
use crate::host::selftest::Stage;
use crate::host::system::SystemSetup;

/// What is asked of a worker.
#[derive(Debug, Serialize, Deserialize)]
pub(super) enum WorkerRequest {
    /// Load these FMUs. The first question.
    Load(Box<Load>),
    /// A stage of [`crate::host::selftest::selftest`] against the first run, which this process makes itself if it is not
    /// told.
    SelfTest {
        steps: usize,
        stage: Stage,
        #[serde(with = "numbers")]
        reference: Vec<f64>,
    },
    /// So many runs of so many steps with moving inputs, and what the FMU does to the process meanwhile.
    Habits { steps: usize, runs: usize },
    /// [`crate::host::Plant::restart`].
    Restart,
    /// [`crate::host::Plant::advance_and`].
    Advance {
        /// A state that the FMU saved, to be restored first.
        from: Option<u32>,
        steps: usize,
        #[serde(with = "numbers")]
        inputs: Vec<f64>,
        then: Then,
    },
    /// [`crate::host::Plant::advance_each`], without states that nobody needs any more.
    Legs { legs: Vec<Leg>, forget: Vec<u32> },
    /// [`crate::host::Plant::save`], under this number.
    Save { number: u32, how: Saving },
    /// [`crate::host::Plant::restore`].
    Restore { number: u32, how: Saving },
    /// States the FMU saved that nobody needs any more.
    Forget(Vec<u32>),
    /// [`crate::host::Plant::fingerprint`].
    Fingerprint,
}

/// Steps from a state that the FMU saved, after which it saves its state again: by number.
#[derive(Debug, Serialize, Deserialize)]
pub(super) struct Leg {
    pub from: u32,
    pub steps: usize,
    #[serde(with = "numbers")]
    pub inputs: Vec<f64>,
    pub reads: Reads,
    pub to: u32,
}

/// What is done after an action.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum Then {
    Nothing,
    /// See [`WorkerRequest::Fingerprint`].
    Fingerprint,
    /// See [`WorkerRequest::Save`].
    Save {
        number: u32,
        how: Saving,
    },
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
pub(super) enum WorkerReply {
    /// Done.
    Done,
    /// The FMUs are loaded; what of the sandbox this system lacks.
    Loaded { missing: Vec<String> },
    /// They cannot be loaded.
    NotLoaded { message: String, running: bool },
    /// Outputs, row-major.
    Rows(#[serde(with = "numbers")] Vec<f64>),
    /// Outputs of an action, row-major, and what was done after it.
    Stepped {
        #[serde(with = "numbers")]
        rows: Vec<f64>,
        taken: Result<StateCopyReply, PlantError>,
    },
    /// The first run of the self-test, and what else it told, as JSON.
    FirstRun {
        #[serde(with = "numbers")]
        rows: Vec<f64>,
        facts: String,
    },
    /// What a later stage of the self-test found, as JSON.
    Tested(String),
    /// See [`WorkerRequest::Fingerprint`].
    Print(Option<Fingerprint>),
    /// See [`WorkerRequest::Habits`]; as JSON.
    Habits(String),
    /// The FMU failed.
    Failed(PlantError),
}

/// What was taken after an action.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) enum StateCopyReply {
    Nothing,
    Fingerprint(Option<Fingerprint>),
    Saved,
}

/// Numbers as their bytes, which takes a copy instead of a call for each.
mod numbers {
    use serde::de::Error as _;
    use serde::{Deserialize as _, Deserializer, Serializer};

    pub(super) fn serialize<S: Serializer>(numbers: &[f64], to: S) -> Result<S::Ok, S::Error> {
        let bytes: Vec<u8> = numbers.iter().flat_map(|number| number.to_le_bytes()).collect();
        to.serialize_bytes(&bytes)
    }

    pub(super) fn deserialize<'a, D: Deserializer<'a>>(from: D) -> Result<Vec<f64>, D::Error> {
        let (numbers, rest) = <&[u8]>::deserialize(from)?.as_chunks();
        if !rest.is_empty() {
            return Err(D::Error::custom("part of a number"));
        }
        Ok(numbers.iter().map(|bytes| f64::from_le_bytes(*bytes)).collect())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_keep_every_bit_and_parts_of_numbers_are_refused() {
        let rows = vec![0.0, -0.0, 1.0 / 3.0, f64::MIN_POSITIVE / 8.0, f64::INFINITY, -f64::NAN];
        let bytes = postcard::to_stdvec(&WorkerReply::Rows(rows.clone())).unwrap();
        let Ok(WorkerReply::Rows(back)) = postcard::from_bytes(&bytes) else { panic!("not rows") };
        assert!(back.len() == rows.len() && back.iter().zip(&rows).all(|(a, b)| a.to_bits() == b.to_bits()));
        // Number of the kind, number of bytes, bytes.
        assert_eq!(usize::from(bytes[1]), bytes.len() - 2);
        let cut = [&[bytes[0], bytes[1] - 1], &bytes[2..bytes.len() - 1]].concat();
        assert!(postcard::from_bytes::<WorkerReply>(&cut).is_err());
    }
}
