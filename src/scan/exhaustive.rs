//! The exhaustive search of a cell: its groups with counts, and the certificate of what was covered.

use std::ops::ControlFlow;
use std::sync::Arc;

use num_bigint::BigUint;
use num_traits::ToPrimitive as _;

use super::prepare::{Prepared, StateChoice};
use super::run::{Progress, ScanError};
use crate::hazard::{Finding, Groups};
use crate::host::{Effort, Hosted, PlantError};
use crate::human::Action;
use crate::report::model::{Certificate, FaultRecord, Hazard, RandomSearch};
use crate::search::exhaustive::{Account, Budget, Expansion as _, Stopped, Told, exhaust};
use crate::search::statistics::Independent;
use crate::sim::Coverage;
use crate::sim::expansion::{Expander, Merge};
use crate::sim::journal::Journal;
use crate::sim::motion::Motion;

/// Budget of the random search whose figures stand in the certificate: the paper's.
const RANDOM_ITERATIONS: u32 = 320;

/// Different faults kept with their sequences; further ones are only counted.
const FAULTS_KEPT: usize = 20;

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exhaustive {
    /// Limits.
    pub budget: Budget,
    /// How equal states of the FMU are told.
    pub merge: Merge,
    /// Threads.
    pub workers: usize,
}

/// What came out, besides the groups.
pub(super) struct Census {
    /// What was covered; nothing if the FMU ended the search.
    pub certificate: Option<Certificate>,
    pub coverage: Coverage,
    pub motion: Motion,
    pub fmu_steps: u64,
    pub fmu_states: usize,
    pub effort: Effort,
    /// Questions whose answers were in the journal.
    pub remembered: u64,
    pub faults: Vec<FaultRecord>,
    /// The user ended the search.
    pub interrupted: bool,
    /// The failure that ended the search.
    pub broken: Option<PlantError>,
}

/// Looks at every sequence; findings go into `groups`.
pub(super) fn census(
    prepared: &Prepared,
    state: StateChoice,
    options: Exhaustive,
    journal: Journal,
    links: &[String],
    groups: &mut Groups,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<Census, ScanError> {
    let (cell, binding) = (Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
    let sensors: Vec<String> = cell.sensors.iter().map(|s| s.name.clone()).collect();
    let policy = prepared.policy(state);
    let merge = if prepared.tells_states_by_bytes() { options.merge } else { Merge::History };
    let mut expander = Expander::new(cell, binding, prepared.plant(state), policy, merge, options.workers)
        .map_err(|cause| ScanError { cause })?
        .with_journal(journal);
    let mut faults = Vec::new();
    let outcome = exhaust(&mut expander, options.budget, &mut |told| match told {
        Told::Met(met) => {
            let mut actions: Vec<Action> = met.prefixes.calmest.iter().map(|&a| Action::ALL[usize::from(a)]).collect();
            actions.extend(&met.unsafe_state.actions);
            let finding = Finding { actions, ..met.unsafe_state };
            let Some(id) = groups.add_counted(finding, Some(met.sequences), 0, links) else {
                return ControlFlow::Continue(());
            };
            groups
                .get(&id)
                .map_or(ControlFlow::Continue(()), |group| tell(Progress::Found(&Hazard::new(group, links, &sensors))))
        }
        Told::Failed { reason, action, prefixes } => {
            if faults.len() < FAULTS_KEPT && faults.iter().all(|known: &FaultRecord| known.message != reason) {
                let mut actions: Vec<Action> = prefixes.calmest.iter().map(|&a| Action::ALL[usize::from(a)]).collect();
                actions.push(Action::ALL[action]);
                faults.push(FaultRecord { message: reason, actions });
            }
            ControlFlow::Continue(())
        }
        Told::Working => tell(Progress::Working),
        Told::Progress { depth, done, of } => tell(Progress::Level { depth, done, of, hazards: groups.len() }),
    });
    let (account, broken) = match outcome {
        Ok(account) => (Some(account), None),
        Err(error) => (None, Some(error)),
    };
    Ok(Census {
        interrupted: account.as_ref().is_some_and(|a| a.stopped == Stopped::Asked),
        certificate: account.map(|account| certificate(&expander, &account, options)),
        coverage: expander.coverage().clone(),
        motion: expander.motion().clone(),
        fmu_steps: expander.recall().steps(),
        fmu_states: expander.recall().states(),
        effort: expander.recall().effort_of_workers(),
        remembered: expander.journal().remembered(),
        faults,
        broken,
    })
}

fn certificate(expander: &Expander<Hosted>, account: &Account, options: Exhaustive) -> Certificate {
    let mut reasons = Vec::new();
    match account.stopped {
        Stopped::Complete => {}
        Stopped::Budget => reasons.push(format!(
            "the budget of {} states, {} MB and {} million joint-angle boxes is spent: all sequences of {} actions were \
             looked at, longer ones in part. Raise --max-states, --max-memory or --max-work",
            options.budget.states,
            options.budget.bytes / 1_000_000,
            options.budget.work / 1_000_000,
            account.depth
        )),
        Stopped::Asked => reasons.push(format!(
            "it was stopped: all sequences of {} actions were looked at, longer ones in part",
            account.depth
        )),
    }
    if account.not_evaluated > BigUint::ZERO {
        reasons.push("the FMU could not finish some actions: what follows from them is not known".to_owned());
    }
    let unfinished = expander.coverage().arm_checks_incomplete;
    if unfinished > 0 {
        reasons
            .push(format!("{unfinished} arm checks stopped at their work limit: an arm contact may be missed there"));
    }
    if account.stopped == Stopped::Budget && !expander.merges_by_bytes() {
        reasons.push(
            "the FMU does not offer serialised states, so its states are told apart by the inputs they received: with \
             inputs that follow the person's place hardly any two are equal"
                .to_owned(),
        );
    }
    let complete = reasons.is_empty();
    let share = account.hazardous.to_f64().unwrap_or(0.0) / account.total.to_f64().unwrap_or(f64::INFINITY);
    let independent = Independent { probability: share, cap: RANDOM_ITERATIONS };
    let (mean_iterations, sigma) = independent.mean_and_sigma();
    let random = RandomSearch {
        iterations: RANDOM_ITERATIONS,
        iterations_to_hazard: independent.mean(),
        mean_iterations,
        sigma,
        miss_probability: independent.miss(),
    };
    let merges = expander.recall().merges();
    let merged_by = if expander.merges_by_bytes() { "serialised states, byte for byte" } else { "inputs received" };
    Certificate {
        complete,
        reasons,
        sequences: account.total.to_string(),
        covered: account.covered().to_string(),
        hazardous: account.hazardous.to_string(),
        harmless: account.harmless.to_string(),
        excluded: account.excluded.to_string(),
        not_evaluated: account.not_evaluated.to_string(),
        hazardous_share: share,
        states: account.states(),
        levels: account.levels.iter().map(|l| [l.states, l.dropped]).collect(),
        complete_for_actions: account.depth,
        fmu_transitions: expander.recall().states() - 1,
        questions: expander.questions(),
        merged_by: merged_by.to_owned(),
        merged: merges.merged,
        merges_tried_out: merges.tried_out,
        actions: expander.actions(),
        horizon: expander.horizon(),
        random_search: complete.then_some(random),
    }
}
