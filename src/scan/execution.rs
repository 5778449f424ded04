//! What a search stands on: how states are brought back, how equal ones are told, and what counts as a plain run. When one
//! of these is found to be wrong, the search is made again on the next rung.

use super::hosting::StateChoice;
use super::prepare::Prepared;
use crate::host::audit::Difference;
use crate::host::selftest::{Agreement, StateRestore};
use crate::host::{Hosted, PlantError, Policy, Unlike};
use crate::sequences::Merge;

/// How states are brought back.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum RestoreBy {
    /// As the user asked, or as the self-test recommends.
    Asked(StateChoice),
    /// By this rung, because another one was found to be wrong.
    By(StateRestore),
}

/// What a search stands on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct ExecutionMode {
    states: RestoreBy,
    /// How equal states are told.
    pub merge: Merge,
    /// Whether a plain run has a process of its own, instead of an instance.
    processes: bool,
}

/// A reason not to rely on what was found.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Doubt {
    /// What is wrong.
    pub unlike: Unlike,
    /// Where it showed itself.
    pub shown: DoubtOrigin,
}

/// Where a doubt showed itself.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum DoubtOrigin {
    /// In a run from the start.
    Audit(Difference),
    /// While searching.
    Search(PlantError),
    /// Hazards, so many, that a replay did not confirm.
    Unconfirmed(usize),
}

impl Doubt {
    /// That of an audit.
    pub(crate) fn of_audit(difference: Difference) -> Self {
        Self { unlike: difference.unlike, shown: DoubtOrigin::Audit(difference) }
    }

    /// That of a failure of the search, if it is one.
    pub(crate) fn of_search(error: &PlantError) -> Option<Self> {
        Some(Self { unlike: error.unlike?, shown: DoubtOrigin::Search(error.clone()) })
    }

    /// How it showed itself, in words.
    pub(crate) fn words(&self) -> String {
        match &self.shown {
            DoubtOrigin::Audit(Difference { action: 0, .. }) => {
                "run again from the start, the FMU gave other outputs at its start".to_owned()
            }
            DoubtOrigin::Audit(Difference { action, .. }) => {
                format!("run again from the start, the FMU gave other outputs in action {action} of a sequence")
            }
            DoubtOrigin::Search(error) => error.message.clone(),
            DoubtOrigin::Unconfirmed(1) => "a replay did not confirm 1 hazard".to_owned(),
            DoubtOrigin::Unconfirmed(hazards) => format!("a replay did not confirm {hazards} hazards"),
        }
    }
}

impl ExecutionMode {
    /// As the user asked.
    pub(crate) fn asked(prepared: &Prepared, choice: StateChoice, merge: Merge) -> Self {
        let merge = if prepared.compares_states_by_bytes() { merge } else { Merge::History };
        let processes = prepared.has_processes() && prepared.self_test.deterministic != Agreement::Exact;
        Self { states: RestoreBy::Asked(choice), merge, processes }
    }

    /// The way in which states are brought back.
    pub(crate) fn rung(&self, prepared: &Prepared) -> StateRestore {
        match self.states {
            RestoreBy::By(rung) => rung,
            RestoreBy::Asked(StateChoice::Auto) => prepared.rung,
            RestoreBy::Asked(StateChoice::Fmu) => StateRestore::SavedStates,
            RestoreBy::Asked(StateChoice::Fork) => StateRestore::Copies,
            RestoreBy::Asked(StateChoice::Replay) => StateRestore::Instances,
            RestoreBy::Asked(StateChoice::Process) => StateRestore::Processes,
        }
    }

    /// The FMUs, not yet started, to search with.
    pub(crate) fn plant(&self, prepared: &Prepared) -> Hosted {
        match self.states {
            RestoreBy::Asked(choice) => prepared.plant(choice),
            RestoreBy::By(rung) => prepared.plant_by(rung),
        }
    }

    /// How states are brought back.
    pub(crate) fn policy(&self, prepared: &Prepared) -> Policy {
        match self.states {
            RestoreBy::Asked(choice) => prepared.policy(choice),
            RestoreBy::By(rung) => prepared.policy_by(rung),
        }
    }

    /// The FMUs, not yet started, for plain runs: from a fresh instance or in a fresh process each, without any restore.
    pub(crate) fn plain(&self, prepared: &Prepared) -> Hosted {
        prepared.plant_by(if self.processes { StateRestore::Processes } else { StateRestore::Instances })
    }

    /// What a fresh start of a plain run costs, in communication steps, about.
    pub(crate) const fn instance(&self) -> u64 {
        if self.processes { 3000 } else { 60 }
    }

    /// Communication steps that an audit may take at least: about a second, or as many processes as start in some.
    pub(crate) const fn least_audit(&self) -> u64 {
        if self.processes { 1_000_000 } else { 150_000 }
    }

    /// The next rung, if there is one; none of those that were left is come back to.
    pub(crate) fn lower(self, prepared: &Prepared, unlike: Unlike) -> Option<Self> {
        let by = |rung| Self { states: RestoreBy::By(rung), merge: Merge::History, ..self };
        let processes = (prepared.has_processes() && !self.processes)
            .then_some(Self { processes: true, ..by(StateRestore::Processes) });
        let instances = if self.processes { by(StateRestore::Processes) } else { by(StateRestore::Instances) };
        match (unlike, self.rung(prepared)) {
            (Unlike::Merge, _) if self.merge == Merge::Auto => Some(Self { merge: Merge::History, ..self }),
            (Unlike::Plain, _) => processes,
            (_, StateRestore::SavedStates) if prepared.self_test.fork == Agreement::Exact => {
                Some(by(StateRestore::Copies))
            }
            (_, StateRestore::SavedStates | StateRestore::Copies) => Some(instances),
            (_, StateRestore::Instances | StateRestore::Processes) => processes,
        }
    }

    /// What is said when a search is made again: what was found, and what is done.
    pub(crate) fn lowered(self, prepared: &Prepared, doubt: &Doubt, to: Self) -> String {
        let (from, by) = (self.rung(prepared), to.rung(prepared));
        let found = doubt.words();
        if self.merge != to.merge && from == by {
            return format!(
                "two states of the FMU with the same bytes are two states: {found}. Equal states are told by the inputs \
                 instead, and everything was searched again"
            );
        }
        match doubt.unlike {
            Unlike::Plain => format!(
                "fresh instances of the FMU in one process do not agree: {found}. Each run has a process of its own \
                 instead, and everything was searched again"
            ),
            _ => format!("{from} cannot be relied on with this FMU: {found}. Everything was searched again with {by}"),
        }
    }
}

/// Why nothing is certified of an FMU that does not even repeat itself in plain runs.
pub(super) fn not_repeatable(doubt: &Doubt) -> String {
    match doubt.shown {
        DoubtOrigin::Unconfirmed(_) => {
            format!("{}: what is listed as not confirmed may not be there, and more may be", doubt.words())
        }
        _ => format!(
            "the FMU does not repeat itself: {}, with the same inputs. Its results depend on something else (a clock, a \
             random generator, another process), so nothing can be certified. Ask its maker for a deterministic export",
            doubt.words()
        ),
    }
}
