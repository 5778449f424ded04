//! The exhaustive search of a cell: its groups with counts, the audit of what it rests on, and the certificate of what was
//! covered.

use std::ops::ControlFlow;
use std::sync::Arc;

use num_bigint::BigUint;
use num_traits::ToPrimitive as _;

use super::execution::{Doubt, ExecutionMode};
use super::options::{Exhaustive, Progress, ScanError};
use super::prepare::Prepared;
use crate::hazard::{Finding, Groups};
use crate::host::audit::{Audit, Difference, Scope, audit};
use crate::host::{FmuUsage, Hosted, PlantError, Recall};
use crate::human::Action;
use crate::obligations::{Need, Point};
use crate::record::certificate::{Certificate, RandomSearch, RunAgain};
use crate::record::hazard::Hazard;
use crate::record::model::FaultRecord;
use crate::search::exhaustive::{Account, Budget, Expansion as _, Prefixes, SearchEvent, Stopped, exhaust_watched};
use crate::search::statistics::Independent;
use crate::sequences::Expander;
use crate::sim::answers::Answers;
use crate::sim::motion::Motion;
use crate::sim::{Coverage, World};

/// Budget of the random search whose figures stand in the certificate: the paper's.
const RANDOM_ITERATIONS: u32 = 320;

/// Different faults kept with their sequences; further ones are only counted.
const FAULTS_KEPT: usize = 20;

/// What came out, besides the groups.
pub(super) struct ExhaustiveResult {
    /// What was covered; nothing if the FMU ended the search.
    pub certificate: Option<Certificate>,
    /// What it left open, and why.
    pub gaps: Vec<(Need, Point)>,
    pub coverage: Coverage,
    pub motion: Motion,
    pub fmu_steps: u64,
    pub fmu_states: usize,
    pub effort: FmuUsage,
    pub faults: Vec<FaultRecord>,
    /// The user ended the search.
    pub interrupted: bool,
    /// The failure that ended the search.
    pub broken: Option<PlantError>,
    /// Why it is not to be relied on.
    pub doubt: Option<Doubt>,
}

/// States met before the first look at some of their transitions, which catches most lies before much time is spent; the
/// next look comes at twice as many.
const FIRST_LOOK: usize = 64;

/// Runs of such a look.
const LOOK: usize = 24;

/// Looks at a search now and then.
struct Looks<'a> {
    plain: &'a mut Hosted,
    footing: ExecutionMode,
    /// States met at the last look, and at which the next one is due.
    looked: usize,
    due: usize,
    /// What the FMU gave that is not what it gives in a run from the start: it ended the search.
    unlike: Option<Difference>,
}

impl Looks<'_> {
    /// Runs some of the transitions that are new plainly; `false` if told to stop, or where they are unlike.
    fn look(&mut self, recall: &Recall<Hosted>, go_on: &mut dyn FnMut() -> bool) -> Result<bool, PlantError> {
        let states = recall.states();
        if states < self.due {
            return Ok(true);
        }
        let scope = Scope { since: self.looked, runs: LOOK, steps: u64::MAX, instance: self.footing.instance() };
        (self.looked, self.due) = (states, states * 2);
        match audit(self.plain, recall, scope, &mut |_, _| go_on()) {
            Ok(found) => {
                self.unlike = found.difference;
                Ok(self.unlike.is_none() && !found.stopped)
            }
            Err(error) if error.stopped => Ok(false),
            Err(error) => Err(error),
        }
    }
}

/// Communication steps that the audit may take: as many as the search, where steps are what costs, and a small part of what
/// the contacts cost, else.
fn audit_steps(expander: &Expander<Hosted>, footing: ExecutionMode) -> u64 {
    let steps = expander.recall().steps();
    footing.least_audit() + steps + (expander.cost() - steps) / 16
}

/// A finding with the actions before it.
fn after(world: &World, prefixes: &Prefixes, finding: Finding) -> Finding {
    Finding { actions: taken(world, prefixes, finding.actions.iter().copied()), ..finding }
}

/// The calmest of many beginnings and what comes then, as the person takes it.
fn taken(world: &World, prefixes: &Prefixes, then: impl Iterator<Item = Action>) -> Vec<Action> {
    let before = prefixes.calmest.iter().map(|&action| world.cell.repertoire.action(action as usize));
    world.as_taken(&before.chain(then).collect::<Vec<_>>())
}

/// Looks at every sequence; findings go into `groups`. What the FMU did for it is then run again by `plain`.
pub(super) fn census(
    prepared: &Prepared,
    (footing, plain): (ExecutionMode, &mut Hosted),
    (options, answers): (Exhaustive, &Arc<Answers>),
    links: &[String],
    groups: &mut Groups,
    tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
) -> Result<ExhaustiveResult, ScanError> {
    let (cell, binding) = (Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
    let sensors: Vec<String> = cell.sensors.iter().map(|s| s.name.clone()).collect();
    let world = World::new(Arc::clone(&cell), Arc::clone(&binding));
    let people = prepared.cell.names();
    let (plant, policy) = (footing.plant(prepared), footing.policy(prepared));
    let mut expander = Expander::new(cell, binding, plant, policy, footing.merge, options.workers)
        .map_err(|cause| ScanError { cause })?
        .with_answers(Arc::clone(answers));
    let mut looks = Looks { plain, footing, looked: 0, due: FIRST_LOOK, unlike: None };
    let mut faults = Vec::new();
    let mut look = |expander: &Expander<Hosted>, go_on: &mut dyn FnMut() -> bool| looks.look(expander.recall(), go_on);
    let outcome = exhaust_watched(&mut expander, options.budget, &mut look, &mut |told| match told {
        SearchEvent::UnsafeState(met) => {
            let finding = after(&world, met.prefixes, met.unsafe_state);
            let Some(id) = groups.add_counted(finding, Some(met.sequences), 0, links) else {
                return ControlFlow::Continue(());
            };
            groups.get(&id).map_or(ControlFlow::Continue(()), |group| {
                tell(Progress::Found(&Hazard::new(group, links, &sensors, people)))
            })
        }
        SearchEvent::Noted { unsafe_state, prefixes, with_end } => {
            // Of two who are hit at once the sequence counts for the first.
            let counted = with_end.then_some(BigUint::ZERO);
            let finding = after(&world, prefixes, unsafe_state);
            let Some(id) = groups.add_counted(finding, counted, 0, links) else {
                return ControlFlow::Continue(());
            };
            groups.get(&id).map_or(ControlFlow::Continue(()), |group| {
                tell(Progress::Found(&Hazard::new(group, links, &sensors, people)))
            })
        }
        SearchEvent::Failed { reason, action, prefixes } => {
            if faults.len() < FAULTS_KEPT && faults.iter().all(|known: &FaultRecord| known.message != reason) {
                let actions = taken(&world, prefixes, std::iter::once(world.cell.repertoire.action(action)));
                faults.push(FaultRecord { message: reason, actions });
            }
            ControlFlow::Continue(())
        }
        SearchEvent::Working => tell(Progress::Working),
        SearchEvent::Progress { depth, done, of, cost } => {
            tell(Progress::Level { depth, done, of, hazards: groups.len(), cost })
        }
    });
    let Looks { plain, unlike, .. } = looks;
    faults.extend(expander.arm_run_unfinished().map(|message| FaultRecord { message, actions: Vec::new() }));
    let (mut broken, mut doubt, mut again) = (None, None, Audit::default());
    let account = match (outcome, unlike) {
        (_, Some(difference)) => {
            doubt = Some(Doubt::of_audit(difference));
            None
        }
        (Ok(account), None) => Some(account),
        (Err(error), None) => {
            doubt = Doubt::of_search(&error);
            broken = Some(error);
            None
        }
    };
    let mut interrupted = account.as_ref().is_some_and(|a| a.stopped == Stopped::Asked);
    if account.is_some() && !interrupted {
        let steps = audit_steps(&expander, footing);
        let scope = Scope { since: 0, runs: usize::MAX, steps, instance: footing.instance() };
        let mut told = |done, of| tell(Progress::RunAgain { done, of }).is_continue();
        match audit(plain, expander.recall(), scope, &mut told) {
            Ok(audited) => {
                again = audited;
                doubt = again.difference.take().map(Doubt::of_audit);
                interrupted |= again.stopped;
            }
            // What was found is told all the same, without a certificate.
            Err(error) => {
                again.stopped = true;
                broken = Some(error);
            }
        }
    } else {
        again.stopped = true;
    }
    let gaps = account.as_ref().map_or_else(Vec::new, |account| gaps(&expander, account, options, &again));
    let certificate = account.map(|account| certificate(&expander, &account, &again));
    Ok(ExhaustiveResult {
        interrupted,
        certificate,
        gaps,
        coverage: expander.coverage().clone(),
        motion: expander.motion().clone(),
        fmu_steps: expander.recall().steps(),
        fmu_states: expander.recall().states(),
        effort: expander.recall().effort_of_workers(),
        faults,
        broken,
        doubt,
    })
}

/// The bounds of a budget; what is not bounded is not named.
fn words(budget: Budget) -> String {
    let of = |is_bounded: bool, words: String| is_bounded.then_some(words);
    let millions = format!("{}.{}", budget.work / 1_000_000, budget.work / 100_000 % 10);
    let all = [
        of(budget.states != usize::MAX, format!("{} states", budget.states)),
        of(budget.bytes != usize::MAX, format!("{} MB", budget.bytes / 1_000_000)),
        of(budget.work != u64::MAX, format!("{} million joint-angle boxes", millions.trim_end_matches(".0"))),
    ];
    all.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// What a search left open of what an answer needs.
fn gaps(expander: &Expander<Hosted>, account: &Account, options: Exhaustive, again: &Audit) -> Vec<(Need, Point)> {
    let mut gaps = Vec::new();
    let part = format!("all sequences of {} actions were looked at, longer ones in part", account.depth);
    match account.stopped {
        Stopped::Complete => {}
        Stopped::Budget => {
            let why = format!("the budget of {} is spent: {part}", words(options.budget));
            let what_to_do = match expander.merges_by_bytes() {
                true => "Raise --max-states, --max-memory or --max-work",
                false => {
                    "Raise --max-states, --max-memory or --max-work. The FMU does not offer serialised states, so its states are told \
                     apart by the inputs they received: with inputs that follow the person's place hardly any two are equal"
                }
            };
            gaps.push((Need::Searched, Point::open_until(why, what_to_do)));
        }
        Stopped::Asked => {
            let why = format!("it was stopped, or its time was up: {part}");
            gaps.push((Need::Searched, Point::open_until(why, "Give it more with --time")));
        }
    }
    if account.not_evaluated > BigUint::ZERO {
        let why = "the FMU could not finish some actions: what follows from them is not known";
        gaps.push((Need::Finished, Point::open(why)));
    }
    if account.behind_not_evaluated {
        let why = "the FMU could not finish some actions behind a first contact: whether somebody is clamped there is not known";
        gaps.push((Need::Finished, Point::open(why)));
    }
    if let Some(actions) = account.behind_cut {
        let why = format!(
            "what comes behind a first contact took more than half of the budget of {}: for clamping it was looked at in \
             sequences of {actions} actions, in longer ones in part",
            words(options.budget),
        );
        gaps.push((Need::Searched, Point::open_until(why, "Raise --max-states, --max-memory or --max-work")));
    }
    let runs = expander.coverage().arm_runs_not_evaluated;
    if runs > 0 {
        let (need, why) = match (expander.arm_run_strayed(), expander.arm_run_unfinished().is_some()) {
            (true, false) => (Need::Following, "an obstacle or a sensor that follows the FMU would do so otherwise in"),
            (true, true) => {
                (Need::Finished, "the FMU could not finish, or something that follows it would do so otherwise in,")
            }
            _ => (Need::Finished, "the FMU could not finish"),
        };
        let why = format!("{why} {runs} runs in which a plane tells of an arm: what the arm meets there is not known");
        gaps.push((need, Point::open(why)));
    }
    if again.stopped {
        gaps.push((Need::Repeatable, Point::open("what the FMU did was not all run again from the start")));
    }
    gaps
}

/// What was covered. What it rests on is known later.
fn certificate(expander: &Expander<Hosted>, account: &Account, again: &Audit) -> Certificate {
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
        complete: false,
        reasons: Vec::new(),
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
        run_again: RunAgain {
            transitions: again.transitions,
            compared: again.compared,
            merges: again.merges,
            merges_compared: again.merges_compared,
        },
        actions: expander.actions(),
        horizon: expander.horizon(),
        random_search: Some(random),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::binding::{BoundUnit, bind};
    use crate::cell::find::{OpenedCell, open};
    use crate::host::{Policy, System, SystemSetup};
    use crate::search::exhaustive::Level;
    use crate::sequences::Merge;

    /// All else was looked at. No FMU runs here.
    #[test]
    fn one_run_with_an_arm_that_was_not_finished_leaves_the_search_incomplete() {
        let dir = tempfile::tempdir().unwrap();
        crate::examples::by_name("light-curtain").unwrap().export(dir.path()).unwrap();
        let OpenedCell { cell, source, fmus, wiring, .. } =
            open(&dir.path().join("light-curtain/cell.toml"), None).unwrap();
        let units = BoundUnit::all(fmus.iter().map(|(name, fmu)| (name, fmu)));
        let binding = Arc::new(bind(cell.file(), &source, &units, wiring.as_ref()).unwrap());
        let cell = Arc::new(cell);
        let certified = |runs: u64| {
            let plant = Hosted::Here(System::new(&[], SystemSetup::default()).unwrap());
            let (cell, binding) = (Arc::clone(&cell), Arc::clone(&binding));
            let sensors = cell.sensors.len();
            let expander = Expander::new(cell, binding, plant, Policy::Replay, Merge::History, 1).unwrap();
            let expander = expander.having_seen(Coverage { arm_runs_not_evaluated: runs, ..Coverage::new(sensors) });
            let account = Account {
                total: BigUint::from(36_u32),
                hazardous: BigUint::ZERO,
                harmless: BigUint::from(36_u32),
                excluded: BigUint::ZERO,
                not_evaluated: BigUint::ZERO,
                levels: vec![Level { states: 1, ..Level::default() }],
                depth: 1,
                stopped: Stopped::Complete,
                behind_cut: None,
                behind_not_evaluated: false,
            };
            let budget = Budget { states: usize::MAX, bytes: usize::MAX, work: u64::MAX, drop: true };
            let options = Exhaustive { budget, merge: Merge::History, workers: 1 };
            gaps(&expander, &account, options, &Audit::default())
        };
        assert!(certified(0).is_empty());
        for runs in [1, 2] {
            let part = certified(runs);
            assert!(
                matches!(&part[..], [(Need::Finished, point)] if format!("{point:?}").contains("in which a plane tells of an arm")),
                "{part:?}"
            );
        }
    }
}
