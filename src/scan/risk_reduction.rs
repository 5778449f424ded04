//! The smallest change of a cell after which nothing in it is hazardous, for each design parameter.
//!
//! Hazardous is any hazard, whatever region of the body and robot it is about: a change that removes one cause of a scan and
//! leaves others is told apart (`target_cause`), and never as enough. What is cheap comes first (`minimal_change`, `checks`):
//!
//! 1. **Against the change itself** (`response`): the person would start inside a field, the robot would hardly move, run into
//!    an obstacle or merely be elsewhere in its programme, or sensors and robot would answer later to the same walks: a safeguard made
//!    smaller. Such changes are no advice.
//! 2. **Known sequences**, of all hazards of the scan, each from where it begins.
//! 3. **Quick searches**: from the start, for longer than the cell file says (a hazard that only comes later is not gone),
//!    from the cell's other beginnings, and from places beside the start (`condition`): the person starts as precisely as
//!    people do, and a gap is open to those who come from 3 cm beside.
//! 4. **Every sequence**, from the start and the cell's other beginnings; from beside the start too where that is cheap.
//!
//! Trying a change, and all complete searches together, have budgets of work that do not depend on the machine, so what is said
//! to be looked at does not either.
//!
//! 5. **From anywhere** (`reachability`), where that is asked for: whoever is hit is one more known sequence, and the search for the
//!    smallest change goes on.
//!
//! A change is called enough only where all of the last two found nothing and nothing is open. Of the others is said how far they
//! were looked at: where a budget ended a search, how far that came.

mod checks;
mod condition;
mod minimal_change;
mod reachability;
mod response;
mod target_cause;

use std::panic::resume_unwind;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};

pub(crate) use self::checks::ExhaustiveBudget;
use self::checks::KnownSequence;
use self::condition::{TrialCondition, begin_at, with_each_start};
use self::minimal_change::MinimalChange;
use self::response::{Answers, Names, Objection, SafeguardResponse, probes};
use self::target_cause::{TargetCause, Whose};
use super::hosting::StateChoice;
use super::prepare::Prepared;
use super::reachability::Until;
use crate::cell::binding::BoundUnit;
use crate::cell::design_parameter::{DesignParameters, Encounter};
use crate::hazard::cause::Member;
use crate::host::PlantError;
use crate::human::Action;
use crate::record::advice::{RiskReduction, RiskReductionOutcome};
use crate::record::hazard::Hazard;

/// How hard a remedy is tried.
#[derive(Clone, Copy, Debug)]
pub struct RiskReductionBudget {
    /// Iterations of each quick search.
    pub iterations: u32,
    /// Most work of trying one change without complete searches, in communication steps of an FMU, about.
    pub quick: u64,
    /// Most distinct states of all complete searches together; none means that there are no such searches.
    pub states: usize,
    /// Most work of them, joint-angle boxes.
    pub work: u64,
    /// Most memory of each of them, bytes, about.
    pub bytes: usize,
    /// Threads; the result is the same.
    pub workers: usize,
    /// How changes are looked at from anywhere, if they are.
    pub everywhere: Option<ReachabilityBudget>,
}

impl RiskReductionBudget {
    /// What people wait for: less than a minute on two cores for the examples.
    #[must_use]
    pub fn usual() -> Self {
        let workers = std::thread::available_parallelism().map_or(1, Into::into);
        Self {
            iterations: 20,
            quick: 560_000,
            states: STATES as usize,
            work: WORK,
            bytes: 2_000_000_000,
            workers,
            everywhere: None,
        }
    }

    /// The same with no limit but memory.
    #[must_use]
    pub(crate) fn without_end(self) -> Self {
        Self { quick: u64::MAX, states: usize::MAX, work: u64::MAX, ..self }
    }
}

/// The states that are usual.
pub(crate) const STATES: u32 = 18_000;
/// The work that is usual.
const WORK: u64 = MILLIONS as u64 * 1_000_000;
/// The same in millions of boxes.
pub(crate) const MILLIONS: u32 = 3;

/// How changes are looked at from anywhere.
#[derive(Clone, Copy, Debug)]
pub struct ReachabilityBudget {
    /// How long after the start of the FMU.
    pub until: Until,
    /// Most presses of controls.
    pub presses: u32,
    /// Most states of the FMU.
    pub states: usize,
    /// Most such searches, for all changes together.
    pub searches: u32,
}

impl ReachabilityBudget {
    /// Most searches against the causes of a scan, and against one that is asked about.
    pub(crate) const OF_A_SCAN: u32 = 4;
    /// See there.
    pub const OF_ONE: u32 = 12;
}

/// What is told while changes are tried.
pub enum RiskReductionEvent<'a> {
    /// So many of so many were tried without complete searches.
    Tried(usize, usize),
    /// So many of so many that held until then are looked at completely.
    Completely(usize, usize),
    /// One that holds without a complete search.
    Held(&'a RiskReduction),
    /// What came of one of these.
    Done(&'a RiskReduction),
}

/// What a change shall do.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Goal {
    /// Nothing is hazardous, from anywhere, and not later either.
    Lasting,
    /// Nothing is hazardous within the time that the cell file looks at.
    ForNow,
    /// This cause is gone, from anywhere, and later too; from the start there are hazards of the scan's other causes only.
    Cause,
}

/// Why a change is not tried any further.
#[derive(Clone, Debug, PartialEq)]
enum Rejection {
    /// The cell or the FMU does not take it.
    NotTried(String),
    /// It makes a safeguard smaller or slower.
    Smaller(String),
    /// It would help for a reason that does not count.
    NoAdvice(String),
}

impl From<Objection> for Rejection {
    fn from(objection: Objection) -> Self {
        match objection {
            Objection::Smaller(cause) => Self::Smaller(cause),
            Objection::Other(cause) => Self::NoAdvice(cause),
        }
    }
}

impl Rejection {
    fn cause(&self) -> &str {
        let (Self::NotTried(cause) | Self::Smaller(cause) | Self::NoAdvice(cause)) = self;
        cause
    }
}

/// Most sequences of the scan by which the number of steps is found; all of them are tried with what comes of that.
const KNOWN: usize = 24;

/// Most of these that begin elsewhere: each is run in a cell of its own.
const ELSEWHERE: usize = 6;

/// What all trials have in common.
struct SearchContext<'a> {
    prepared: &'a Prepared,
    text: toml::Table,
    aim: TargetCause,
    robot: usize,
    effort: RiskReductionBudget,
    own: TrialCondition,
    beginnings: Vec<TrialCondition>,
    /// What is seen of the person at each of them.
    at_beginnings: Vec<SafeguardResponse>,
    around: Vec<TrialCondition>,
    known: Vec<KnownSequence>,
    /// The sequences of all hazards of the scan.
    all: Vec<KnownSequence>,
    links: Vec<String>,
    sensors: Vec<&'a str>,
    robots: Vec<&'a str>,
    named_links: Vec<&'a str>,
    obstacles: Vec<&'a str>,
    probes: Vec<Vec<Action>>,
    /// For so many actions the person stands still to see what the robots do.
    rest: usize,
    before: SafeguardResponse,
    answers: Answers,
}

impl<'a> SearchContext<'a> {
    /// Nothing if the cell is not the one that was scanned.
    fn new(
        prepared: &'a Prepared,
        hazard: &Hazard,
        known: &[Hazard],
        effort: RiskReductionBudget,
    ) -> Result<Option<Self>, PlantError> {
        let cell = &prepared.cell;
        let Ok(text) = prepared.text.parse::<toml::Table>() else { return Ok(None) };
        let Some(mut text) = with_each_start(text, cell) else { return Ok(None) };
        if let Some(begins) = hazard.begins
            && begin_at(&mut text, begins, cell.search.actions).is_none()
        {
            return Ok(None);
        }
        let kind = |hazard: &Hazard| {
            let link = cell.links.iter().find(|link| link.name == hazard.robot_link)?;
            Some((hazard.body_region, link.robot))
        };
        let Some(own @ (_, robot)) = kind(hazard) else { return Ok(None) };
        // This hazard first, then in turns those of its kind and all of them, worst first as they stand in the scan.
        let alike: Vec<&Hazard> = known.iter().filter(|other| kind(other) == Some(own)).collect();
        let standpoint = TrialCondition::own(prepared);
        let mut all: Vec<KnownSequence> = Vec::new();
        let mut add = |other: &Hazard| {
            let Some(standpoint) = standpoint.of_hazard(hazard.begins, other) else { return };
            for actions in [&other.actions, &other.shortest.actions] {
                let known = KnownSequence { standpoint, actions: actions.clone() };
                if !all.contains(&known) {
                    all.push(known);
                }
            }
        };
        add(hazard);
        for (number, any) in known.iter().enumerate() {
            alike.get(number).into_iter().copied().chain([any]).for_each(&mut add);
        }
        let here = all.iter().filter(|known| known.standpoint == standpoint).take(KNOWN);
        let sequences: Vec<Vec<Action>> = here.clone().map(|known| known.actions.clone()).collect();
        let elsewhere = all.iter().filter(|known| known.standpoint != standpoint).take(ELSEWHERE);
        let first: Vec<KnownSequence> = here.chain(elsewhere).cloned().collect();
        let actions = cell.search.actions as usize;
        let probes = probes(&sequences, actions, &cell.repertoire, cell.search.seed);
        let rest = actions + 4;
        let mut simulation = prepared.simulation(StateChoice::Auto, false)?;
        let before = SafeguardResponse::observe(&mut simulation, rest)?;
        let answers = Answers::observe(&mut simulation, &probes)?;
        let (beginnings, around) = TrialCondition::others(prepared);
        let mut bench = Self {
            prepared,
            text,
            aim: TargetCause::new(prepared, hazard, known),
            robot,
            effort,
            own: standpoint,
            at_beginnings: Vec::new(),
            beginnings,
            around: Vec::new(),
            all,
            known: first,
            links: cell.links.iter().map(|link| link.name.clone()).collect(),
            sensors: cell.sensors.iter().map(|sensor| sensor.name.as_str()).collect(),
            robots: cell.robots.iter().map(|robot| robot.name.as_str()).collect(),
            named_links: cell.links.iter().map(|link| link.name.as_str()).collect(),
            obstacles: cell.obstacles.iter().map(|o| o.name.as_str()).collect(),
            probes,
            rest,
            before,
            answers,
        };
        for number in 0..bench.beginnings.len() {
            let there = bench.beginnings[number].of(prepared, &bench.text).map_err(PlantError::of)?;
            let at = SafeguardResponse::observe(&mut there.simulation(StateChoice::Auto, false)?, rest)?;
            bench.at_beginnings.push(at);
        }
        for place in around {
            if bench.is_like_the_start(&place)? {
                bench.around.push(place);
            }
        }
        Ok(Some(bench))
    }

    /// Whether the person has room beside the start and no sensor reports them there that does not at the start.
    fn is_like_the_start(&self, place: &TrialCondition) -> Result<bool, PlantError> {
        let Ok(prepared) = place.of(self.prepared, &self.text) else { return Ok(false) };
        let there = SafeguardResponse::observe(&mut prepared.simulation(StateChoice::Auto, false)?, self.rest)?;
        Ok(self.before.objection(&there, false, self.names()).is_none())
    }

    fn names(&self) -> Names<'_> {
        let Self { sensors, robots, named_links, obstacles, .. } = self;
        Names { sensors, robots, links: named_links, obstacles }
    }

    /// Whether a goal is about sequences from there.
    fn is_from(&self, goal: Goal, standpoint: &TrialCondition) -> bool {
        goal != Goal::ForNow || standpoint.more == 0
    }

    /// Whether a hazard that is met from there counts against a goal, after a change that `moves` what a robot does.
    fn counts(&self, goal: Goal, standpoint: &TrialCondition, (id, met): (&str, &Member), moves: bool) -> bool {
        goal != Goal::Cause
            || match self.aim.whose(id, met) {
                Whose::Own => true,
                Whose::Others => false,
                // Elsewhere and later the scan has not looked: what it does not know may have been there before. But where a
                // robot moves otherwise, it may be the cause itself, at another place.
                Whose::Nobodys => moves || *standpoint == self.own,
            }
    }
}

/// Looks for the smallest turn of each knob after which nothing is hazardous. `known` are all hazards of the scan that
/// `hazard` is from; complete searches take from `purse`. Nothing if the cell is not the one that was scanned.
///
/// # Errors
/// When the FMU fails in the cell as it is.
pub(crate) fn risk_reductions(
    prepared: &Prepared,
    hazard: &Hazard,
    known: &[Hazard],
    effort: RiskReductionBudget,
    purse: &mut ExhaustiveBudget,
    tell: &(dyn Fn(RiskReductionEvent<'_>) + Sync),
) -> Result<Vec<RiskReduction>, PlantError> {
    // Who has no room there is told by whoever runs the hazard first.
    let Ok(there) = prepared.of_hazard(hazard) else { return Ok(Vec::new()) };
    let Some(bench) = SearchContext::new(&there, hazard, known, effort)? else { return Ok(Vec::new()) };
    let units = BoundUnit::all(prepared.names.iter().zip(prepared.fmus.iter()));
    let encounter = Encounter { person_m: hazard.person_xy_m, robot: bench.robot };
    let DesignParameters { turned: knobs, held: kept } =
        DesignParameters::of(&prepared.cell, &bench.text, &units, &encounter);
    let (next, done) = (AtomicUsize::new(0), Mutex::new(0));
    let held = |remedy: &RiskReduction| {
        matches!(remedy.outcome, RiskReductionOutcome::NotMet(_) | RiskReductionOutcome::OthersRemain(_))
    };
    let work = || {
        let mut mine = Vec::new();
        while let Some((number, knob)) =
            Some(next.fetch_add(1, Ordering::Relaxed)).and_then(|n| Some((n, knobs.get(n)?)))
        {
            let mut trial = MinimalChange::new(&bench, knob);
            let remedy = trial.quick();
            // What was being tried then says nothing; once it ends it ends for good, whatever the searches within are at.
            if prepared.stop().ends_search() {
                break;
            }
            if held(&remedy) {
                tell(RiskReductionEvent::Held(&remedy));
            }
            mine.push((number, trial, remedy));
            // One after the other, so that nobody hears of fewer after more.
            if let Ok(mut done) = done.lock() {
                *done += 1;
                tell(RiskReductionEvent::Tried(*done, knobs.len()));
            }
        }
        mine
    };
    let mut all: Vec<(usize, MinimalChange<'_>, RiskReduction)> = std::thread::scope(|scope| {
        let threads: Vec<_> = (0..effort.workers.clamp(1, knobs.len().max(1))).map(|_| scope.spawn(work)).collect();
        let joined = threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
        joined.flatten().collect()
    });
    all.sort_by_key(|(number, ..)| *number);
    let of = if effort.states > 0 { all.iter().filter(|(.., remedy)| held(remedy)).count() } else { 0 };
    let mut number = 0;
    for (_, trial, remedy) in &mut all {
        if !held(remedy) {
            continue;
        }
        if of > 0 && !purse.is_empty() {
            number += 1;
            tell(RiskReductionEvent::Completely(number, of));
            let complete = trial.complete(purse, effort.workers);
            if prepared.stop().ends_search() {
                break;
            }
            *remedy = complete;
        }
        tell(RiskReductionEvent::Done(remedy));
    }
    let kept = kept.into_iter().map(|(change, cause)| not_tried(change, cause));
    Ok(all.into_iter().map(|(.., remedy)| remedy).chain(kept).collect())
}

/// A change that the cell file rules out, and why.
fn not_tried(change: String, cause: String) -> RiskReduction {
    RiskReduction { change, cell: String::new(), limit: None, outcome: RiskReductionOutcome::NotTried { cause } }
}
