//! What trying an FMU showed, as plain data and in words: whether it repeats its runs, whether its states come back, and whether its motion
//! is its own. `fmu-host` fills it; who shows results needs no more of an FMU than this.

mod agreement;
mod motion;
mod reliance;
mod rung;
mod text;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use agreement::{Agreement, Difference};
pub use motion::{Apart, Motion, Untried};
pub use rung::StateRestore;
pub use text::{Said, number};

/// The outcome of the self-test.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SelfTest {
    /// Steps of one run.
    pub steps: usize,
    /// Communication step, s.
    pub step_s: f64,
    /// Inputs moved and outputs compared.
    pub inputs: usize,
    /// Outputs compared.
    pub outputs: usize,
    /// Two fresh instances, one after the other, same inputs.
    pub deterministic: Agreement,
    /// A second instance beside a living first one.
    pub second_instance: Agreement,
    /// Restoring a state against the uninterrupted run: two states held, both returned to, the first one twice.
    pub restore: Agreement,
    /// The same with copies of the FMU's process as states, for FMUs in workers.
    pub fork: Agreement,
    /// Two fresh processes, for FMUs in workers.
    pub fresh_process: Agreement,
    /// `fmi2Reset` against a fresh instance.
    pub reset: Agreement,
    /// A serialised state brought back in another instance.
    pub serialize: Agreement,
    /// The motion of the first run against that in half steps.
    #[serde(default)]
    pub half_steps: Motion,
    /// The motion of the first run against that of the other of with Event Mode and without.
    #[serde(default)]
    pub event_mode: Motion,
    /// Whether an FMU is run with its Event Mode.
    #[serde(default)]
    pub uses_event_mode: bool,
    /// What the FMUs said of events in the first run that could not be followed.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub remarks: Vec<String>,
    /// Bytes of a serialised state.
    pub bytes_per_state: Option<usize>,
    /// Largest change of any output over the run: zero means that nothing moves.
    pub output_range: f64,
}

impl SelfTest {
    /// Whether results can be replayed at all: in another process, where there are any.
    #[must_use]
    pub fn repeatable(&self) -> bool {
        match self.fresh_process {
            Agreement::NotOffered => self.deterministic == Agreement::Exact,
            _ => self.fresh_process == Agreement::Exact,
        }
    }

    /// How runs that should be the same differ, where results cannot be replayed.
    #[must_use]
    pub fn unrepeated(&self) -> Option<&Agreement> {
        let worse = match self.fresh_process {
            Agreement::NotOffered => &self.deterministic,
            _ => &self.fresh_process,
        };
        (!self.repeatable()).then_some(worse)
    }

    /// The way of bringing states back that this FMU deserves. `fork_pays` where its actions cost more than a copy of its
    /// process.
    #[must_use]
    pub fn rung(&self, fork_pays: bool) -> StateRestore {
        match (&self.restore, &self.fork, &self.deterministic) {
            (Agreement::Exact, _, Agreement::Exact) => StateRestore::SavedStates,
            (_, Agreement::Exact, Agreement::Exact) if fork_pays => StateRestore::Copies,
            (_, _, Agreement::Exact) => StateRestore::Instances,
            // One instance in a process: its copies do, and so do fresh processes.
            (_, Agreement::Exact, _) => StateRestore::Copies,
            _ => StateRestore::Processes,
        }
    }

    /// At most this many states may be kept within a budget.
    #[must_use]
    pub fn most_states(&self, budget_bytes: usize) -> usize {
        // Without serialisation the size is unknown; 64 KiB is above what small FMUs need.
        let size = self.bytes_per_state.unwrap_or(64 * 1024).max(256);
        (budget_bytes / size).max(16)
    }

    /// Why states are brought back as they are.
    #[must_use]
    pub fn because(&self, rung: StateRestore) -> String {
        let saving = match &self.restore {
            Agreement::Exact => "restored exactly",
            Agreement::NotOffered => "the FMU cannot save its state",
            Agreement::Differs { .. } | Agreement::Failed { .. } => {
                "the FMU says it can save its state, but does not do it exactly"
            }
        };
        let single = if self.deterministic == Agreement::Exact { "" } else { ", and runs once in a process" };
        format!("{rung} ({saving}{single})")
    }
}
