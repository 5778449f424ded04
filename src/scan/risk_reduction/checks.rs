//! Looking for hazards in a changed cell: by known sequences, by a quick search, by looking at every sequence.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::condition::TrialCondition;
use super::target_cause::member_of;
use super::{Goal, ReachabilityBudget, Rejection, RiskReductionBudget, SearchContext};
use crate::cell::design_parameter::DesignParameter;
use crate::geometry::Vec3;
use crate::geometry::segment_cuboid::{point_cuboid, segment_cuboid};
use crate::hazard::{Class, Finding, Groups, Identity};
use crate::host::Hosted;
use crate::human::{Action, Posture, Walk};
use crate::record::advice::{ExhaustiveCheck, HazardAfterChange};
use crate::record::begin::InitialConditionRecord;
use crate::record::certificate::Certificate;
use crate::record::hazard::Hazard;
use crate::record::model::Verdict;
use crate::scan::causes::member;
use crate::scan::hosting::StateChoice;
use crate::scan::options::{Method, Progress, StrategyName};
use crate::scan::prepare::Prepared;
use crate::scan::run::scan_alone;
use crate::scan::{Exhaustive, ScanOptions};
use crate::search::exhaustive::Budget;
use crate::search::{End, Environment as _, Rng};
use crate::sequences::Merge;
use crate::sim::Simulation;
use crate::standards::BodyRegion;

use super::response::{ADDED, Answers, SafeguardResponse};

/// A sequence that led to a hazard, and from where.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct KnownSequence {
    pub standpoint: TrialCondition,
    pub actions: Vec<Action>,
}

/// A hazard that was met after a change.
#[derive(Clone, Debug)]
pub(super) struct Witness {
    pub known: KnownSequence,
    pub class: Class,
    pub region: BodyRegion,
    pub link: usize,
    pub ratio: f64,
    pub time_s: f64,
}

impl Witness {
    pub(crate) fn new(finding: &Finding, standpoint: TrialCondition) -> Self {
        let contact = &finding.contact;
        Self {
            known: KnownSequence { standpoint, actions: finding.actions.clone() },
            class: finding.class,
            region: contact.region,
            link: contact.link,
            ratio: contact.ratio(),
            time_s: finding.time_s,
        }
    }

    fn of(hazard: &Hazard, prepared: &Prepared, standpoint: TrialCondition) -> Self {
        let link = prepared.cell.links.iter().position(|link| link.name == hazard.robot_link);
        Self {
            known: KnownSequence { standpoint, actions: hazard.actions.clone() },
            class: hazard.class,
            region: hazard.body_region,
            link: link.unwrap_or_default(),
            ratio: hazard.ratio,
            time_s: hazard.time_s,
        }
    }
}

/// Most of the known sequences that are tried with stops before and after them, and from beside the start.
pub(super) const SHIFTED: usize = 6;

/// The cell with a knob turned.
pub(super) struct Changed<'a> {
    bench: &'a SearchContext<'a>,
    /// Its file.
    pub table: toml::Table,
    own: Prepared,
    /// Whether a robot moves otherwise, or elsewhere.
    moves: bool,
}

/// A known sequence, or a search, runs into something.
type HazardCheck = Result<Option<Witness>, Rejection>;

impl<'a> Changed<'a> {
    /// The cell with `knob` turned so far; or why that is none, or no help that counts.
    pub(crate) fn new(bench: &'a SearchContext<'a>, knob: &DesignParameter, steps: u32) -> Result<Self, Rejection> {
        let not_tried = |cause: String| Rejection::NotTried(cause);
        let table = knob.turned(&bench.text, steps);
        let table = table.ok_or_else(|| not_tried("the cell file cannot be changed so".to_owned()))?;
        let own = TrialCondition::own(bench.prepared).of(bench.prepared, &table).map_err(not_tried)?;
        let mut simulation = own.simulation(StateChoice::Auto, false).map_err(|e| not_tried(e.message))?;
        let after = SafeguardResponse::observe(&mut simulation, bench.rest).map_err(|e| not_tried(e.message))?;
        match bench.before.objection(&after, knob.is_time(), bench.names()) {
            None => {
                if let Some(obstacle) = beyond(bench.prepared, &own, bench.robot) {
                    return Err(Rejection::NoAdvice(format!(
                        "{} then stands beyond {obstacle}",
                        bench.robots[bench.robot]
                    )));
                }
                let moves = knob.farther_m(steps) > 0.0 || knob.speed_left(steps).is_some();
                Ok(Self { bench, table, own, moves })
            }
            Some(objection) => Err(objection.into()),
        }
    }

    /// Why it would help for nothing but where people begin: a sensor reports them already at another beginning of the cell, or a few
    /// centimetres beside the start; and what it cost to see that.
    pub(crate) fn reported_anew(&self) -> (Option<Rejection>, u64) {
        let bench = self.bench;
        let beginnings =
            bench.beginnings.iter().zip(&bench.at_beginnings).map(|(at, before)| (at, before, "at another start"));
        let around = bench.around.iter().map(|at| (at, &bench.before, "a few centimetres beside the start"));
        let mut cost = 0;
        for (standpoint, before, place) in beginnings.chain(around) {
            let Some(there) = self.from(standpoint) else { continue };
            let after = self.simulation(&there, false).and_then(|mut simulation| {
                let after = SafeguardResponse::observe(&mut simulation, bench.rest);
                cost += simulation.cost();
                after.map_err(|error| Rejection::NotTried(error.message))
            });
            match after.map(|after| before.reported_anew(&after)) {
                Ok(None) => {}
                Ok(Some(sensor)) => {
                    let name = bench.sensors.get(sensor).unwrap_or(&ADDED);
                    let why = format!("{name} then reports the person {place} already");
                    return (Some(Rejection::NoAdvice(why)), cost);
                }
                Err(why) => return (Some(why), cost),
            }
        }
        (None, cost)
    }

    /// Whether a safeguard is smaller or slower in it, and what it cost to see that.
    pub(crate) fn smaller(&self) -> (Option<Rejection>, u64) {
        let mut simulation = match self.simulation(&self.own, false) {
            Ok(simulation) => simulation,
            Err(why) => return (Some(why), 0),
        };
        let smaller = match Answers::observe(&mut simulation, &self.bench.probes) {
            Ok(after) => self.bench.answers.smaller(&after, &self.bench.sensors).map(Rejection::from),
            Err(error) => Some(Rejection::NotTried(error.message)),
        };
        (smaller, simulation.cost())
    }

    /// Whether the person has room there.
    pub(crate) fn has_room(&self, standpoint: &TrialCondition) -> bool {
        self.from(standpoint).is_some()
    }

    /// The cell from its own start.
    pub(crate) fn own(&self) -> &Prepared {
        &self.own
    }

    /// The cell file as text.
    pub(crate) fn text(&self) -> &str {
        &self.own.text
    }

    /// The cell from somewhere; nothing if the person has no room there.
    fn from(&self, standpoint: &TrialCondition) -> Option<Prepared> {
        standpoint.of(self.bench.prepared, &self.table).ok()
    }

    /// What is told of a witness.
    pub(crate) fn met(&self, witness: &Witness) -> HazardAfterChange {
        let standpoint = &witness.known.standpoint;
        let there = self.from(standpoint);
        let elsewhere = TrialCondition { more: 0, ..*standpoint } != TrialCondition::own(self.bench.prepared);
        let begin = |prepared: &Prepared| InitialConditionRecord {
            xy_m: prepared.cell.start.xy_m(),
            heading_deg: prepared.cell.start.heading_deg(),
            begins_s: prepared.cell.begins_s(),
        };
        HazardAfterChange {
            class: witness.class,
            body_region: witness.region,
            robot_link: self.own.cell.links[witness.link].name.clone(),
            ratio: witness.ratio,
            time_s: witness.time_s,
            actions: witness.known.actions.clone(),
            from: there.as_ref().filter(|_| elsewhere).map(begin),
            cell: there.map_or_else(String::new, |prepared| prepared.text),
            beginning: standpoint.beginning,
        }
    }

    /// Runs sequences, those from one place together; the first hazard that counts.
    pub(crate) fn run_all(&self, known: &[&KnownSequence], pass: &mut QuickBudget) -> HazardCheck {
        let mut standpoints: Vec<TrialCondition> = Vec::new();
        for KnownSequence { standpoint, .. } in known {
            if !standpoints.contains(standpoint) {
                standpoints.push(*standpoint);
            }
        }
        for standpoint in standpoints {
            let from = known.iter().filter(|known| known.standpoint == standpoint);
            if let Some(witness) = self.run(standpoint, from.map(|known| known.actions.as_slice()), pass)? {
                return Ok(Some(witness));
            }
        }
        Ok(None)
    }

    /// Runs sequences from one place; the first hazard that counts.
    pub(crate) fn run<'s>(
        &self,
        standpoint: TrialCondition,
        sequences: impl Iterator<Item = &'s [Action]>,
        pass: &mut QuickBudget,
    ) -> HazardCheck {
        let mut sequences = sequences.peekable();
        if sequences.peek().is_none() {
            return Ok(None);
        }
        let Some(prepared) = self.from(&standpoint) else { return Ok(None) };
        let mut simulation = self.simulation(&prepared, false)?;
        for actions in sequences {
            let (before, mut unfinished) = (simulation.cost(), false);
            simulation.reset().map_err(|e| Rejection::NotTried(e.message))?;
            for action in actions.iter().take(simulation.horizon()) {
                match simulation.take(*action).map_err(|e| Rejection::NotTried(e.message))?.end {
                    // Clamping is looked for behind a first contact.
                    Some(End::Unsafe) if simulation.goes_on() => {}
                    Some(End::NotEvaluated) if simulation.goes_on() => {
                        unfinished = true;
                        break;
                    }
                    Some(End::NotEvaluated) => return Err(Rejection::NotTried(simulation.not_evaluated().message)),
                    Some(_) => break,
                    None => {}
                }
            }
            pass.pay(simulation.cost() - before);
            if let Some(witness) = self.sort(&mut simulation, standpoint, pass) {
                return Ok(Some(witness));
            }
            if unfinished || !simulation.is_evaluated() {
                return Err(Rejection::NotTried(simulation.not_evaluated().message));
            }
            pass.goes_on()?;
        }
        Ok(None)
    }

    /// A quick search from one place, which ends when it meets a hazard that counts.
    pub(crate) fn search(&self, standpoint: TrialCondition, iterations: u32, pass: &mut QuickBudget) -> HazardCheck {
        let Some(prepared) = self.from(&standpoint) else { return Ok(None) };
        let mut simulation = self.simulation(&prepared, true)?;
        // What a strategy that plans spends on imagining is more than these few sequences cost.
        let mut strategy = StrategyName::MctsDpw.build();
        let mut rng = Rng::new(prepared.cell.search.seed);
        let mut behind = Rng::new(prepared.cell.search.seed);
        for _ in 0..iterations {
            let before = simulation.cost();
            let iteration = strategy.iterate(&mut simulation, &mut rng).map_err(|e| Rejection::NotTried(e.message))?;
            simulation.look_behind(&mut behind).map_err(|e| Rejection::NotTried(e.message))?;
            if iteration.end == End::NotEvaluated {
                return Err(Rejection::NotTried(simulation.not_evaluated().message));
            }
            pass.pay(simulation.cost() - before);
            if let Some(witness) = self.sort(&mut simulation, standpoint, pass) {
                return Ok(Some(witness));
            }
            pass.goes_on()?;
        }
        Ok(None)
    }

    fn simulation(&self, prepared: &Prepared, posture_sweep: bool) -> Result<Simulation<Hosted>, Rejection> {
        prepared.simulation(StateChoice::Auto, posture_sweep).map_err(|e| Rejection::NotTried(e.message))
    }

    /// The first finding that counts; others are kept.
    fn sort(
        &self,
        simulation: &mut Simulation<Hosted>,
        standpoint: TrialCondition,
        pass: &mut QuickBudget,
    ) -> Option<Witness> {
        let behind = simulation.take_behind();
        for finding in simulation.take_findings().into_iter().chain(behind) {
            let id = Identity::of(&finding, &self.bench.links).id();
            if self.bench.counts(pass.goal, &standpoint, (&id, &member_of(&self.own.cell, &finding)), self.moves) {
                return Some(Witness::new(&finding, standpoint));
            }
            if standpoint == self.bench.own {
                pass.others.add(finding, 0, &self.bench.links);
            }
        }
        None
    }

    /// Looks at every sequence from one place, as far as what is left in `purse` goes; ends when it meets a hazard that
    /// counts.
    pub(crate) fn all(
        &self,
        standpoint: TrialCondition,
        goal: Goal,
        purse: &mut ExhaustiveBudget,
        workers: usize,
    ) -> Result<Result<ExhaustiveCheck, Witness>, Rejection> {
        let prepared =
            self.from(&standpoint).ok_or_else(|| Rejection::NotTried("the person has no room there".to_owned()))?;
        let how = Exhaustive { budget: purse.budget(&self.bench.effort), merge: Merge::Auto, workers };
        let options = ScanOptions {
            method: Method::Exhaustive(how),
            seed: prepared.cell.search.seed,
            iterations: 0,
            stop_at_first: false,
            posture_sweep: true,
            state: StateChoice::Auto,
        };
        let counts = |hazard: &Hazard| {
            self.bench.counts(goal, &standpoint, (&hazard.id, &member(&prepared, hazard)), self.moves)
        };
        let mut met: Option<Hazard> = None;
        let mut tell = |event: Progress<'_>| {
            if let Progress::Found(hazard) = event
                && met.is_none()
                && counts(hazard)
            {
                met = Some(hazard.clone());
            }
            if met.is_some() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let report = scan_alone(&prepared, options, &Arc::default(), &mut tell)
            .map_err(|e| Rejection::NotTried(e.cause.message))?
            .report;
        let states = report.certificate.as_ref().map_or(0, |certificate| certificate.states);
        purse.pay(states, report.coverage.arm_boxes);
        let is_cut_short = |certificate: &Certificate| certificate.complete_for_actions < certificate.horizon;
        if met.is_none() && report.certificate.as_ref().is_some_and(is_cut_short) {
            purse.unended += 1;
        }
        if let Some(hazard) = report.hazards.iter().find(|hazard| counts(hazard)).or(met.as_ref()) {
            return Ok(Err(Witness::of(hazard, &prepared, standpoint)));
        }
        let failed =
            || report.faults.first().map_or_else(|| "the FMU failed".to_owned(), |fault| fault.message.clone());
        // What is open with hazards that are no reason against the change is not about these.
        let open = if report.verdict == Verdict::HazardsFound { Vec::new() } else { report.obligations.reasons() };
        match report.certificate {
            None => Err(Rejection::NotTried(failed())),
            Some(certificate) => Ok(Ok(ExhaustiveCheck {
                beginning: standpoint.beginning + 1,
                sequences: certificate.sequences,
                actions: certificate.horizon,
                looked_at: certificate.complete_for_actions,
                reasons: if open.is_empty() { certificate.reasons } else { open },
            })),
        }
    }
}

/// What a robot was moved across on the floor plan, if anything.
fn beyond(before: &Prepared, after: &Prepared, robot: usize) -> Option<String> {
    let base = |prepared: &Prepared| prepared.cell.robots[robot].world_from_base.translation;
    let (from, to) = (base(before), base(after));
    if (to - from).length() <= 0.0 {
        return None;
    }
    let crossed = |obstacle: &&crate::cell::workcell::Obstacle| {
        let at = |place: Vec3| Vec3::new(place.x, place.y, obstacle.cuboid.centre.z);
        point_cuboid(at(from), &obstacle.cuboid).distance > 0.0
            && segment_cuboid(at(from), at(to), &obstacle.cuboid).distance <= 0.0
    };
    before.cell.obstacles.iter().find(crossed).map(|obstacle| obstacle.name.clone())
}

/// One go at a change without complete searches.
pub(super) struct QuickBudget {
    /// What it shall reach.
    pub goal: Goal,
    /// Hazards that do not count.
    pub others: Groups,
    /// What may still be spent.
    left: u64,
}

impl QuickBudget {
    pub(crate) fn new(goal: Goal, left: u64) -> Self {
        Self { goal, others: Groups::default(), left }
    }

    /// What is left of it.
    pub(crate) fn left(&self) -> u64 {
        self.left
    }

    fn pay(&mut self, cost: u64) {
        self.left = self.left.saturating_sub(cost);
    }

    fn goes_on(&self) -> Result<(), Rejection> {
        if self.left == 0 { Err(Rejection::NotTried(SPENT.to_owned())) } else { Ok(()) }
    }
}

/// Why a change was not tried to the end.
pub(super) const SPENT: &str = "looking at it took more work than one change may take";

/// What all complete searches together may still take.
#[derive(Clone, Copy, Debug)]
pub(crate) struct ExhaustiveBudget {
    states: usize,
    work: u64,
    /// Searches that their budgets ended.
    unended: u32,
    /// How changes are looked at from anywhere, and how often that may still be.
    everywhere: Option<ReachabilityBudget>,
}

impl ExhaustiveBudget {
    /// All of it.
    #[must_use]
    pub(crate) fn new(effort: &RiskReductionBudget) -> Self {
        Self { states: effort.states, work: effort.work, unended: 0, everywhere: effort.everywhere }
    }

    /// How a change is looked at from anywhere, once; nothing if that is not to be.
    pub(super) fn everywhere(&mut self) -> Option<ReachabilityBudget> {
        let how = self.everywhere.as_mut().filter(|how| how.searches > 0)?;
        how.searches -= 1;
        Some(*how)
    }

    /// Whether a search from anywhere is left.
    pub(super) fn has_searches(&self) -> bool {
        self.everywhere.is_some_and(|how| how.searches > 0)
    }

    /// Whether there is nothing left.
    pub(super) fn is_empty(&self) -> bool {
        self.states == 0 || self.work == 0
    }

    /// That of the next search.
    fn budget(&self, effort: &RiskReductionBudget) -> Budget {
        // One change with much work of arms is not to take it all: those of fences are looked at with little. And what one search
        // could not end with, another in the same cell seldom can: each of these is tried with a quarter of what the one before had.
        let share = |all: u64| all.checked_shr(2 * self.unended).unwrap_or(0).max(1);
        let states = usize::try_from(share(effort.states as u64)).unwrap_or(usize::MAX).min(self.states);
        Budget { states, bytes: effort.bytes, work: share(effort.work / 3).min(self.work), drop: true }
    }

    /// What so many more searches may take that cost as much as those since `before`, `done` of them, is left twice.
    pub(super) fn has_twice(&self, before: &Self, done: usize, more: usize) -> bool {
        let (states, work) = (before.states - self.states, before.work - self.work);
        let more = |spent: u64| spent / done.max(1) as u64 * more as u64 * 2;
        more(states as u64) <= self.states as u64 && more(work) <= self.work
    }

    fn pay(&mut self, states: usize, work: u64) {
        (self.states, self.work) = (self.states.saturating_sub(states), self.work.saturating_sub(work));
    }
}

/// Known sequences begun later, and with the person standing still or walking on after them: of each, some stops in front, and
/// what there is time for behind.
pub(super) fn shifted(known: &[KnownSequence], actions: usize, more: usize) -> Vec<Vec<Action>> {
    let whole = actions + more;
    let mut all: Vec<Vec<Action>> = Vec::new();
    let is_here = |known: &&KnownSequence| known.standpoint.more == 0 && known.standpoint.elsewhere.is_none();
    for KnownSequence { actions, .. } in known.iter().filter(is_here).take(SHIFTED) {
        for stops in (0..=more).step_by(2) {
            let on = Action::new(Walk::Forward, Posture::Upright);
            let two = actions.iter().any(|action| action.is_of_two()).then(|| [Action::REST.beside(on), on.beside(on)]);
            for then in [Action::REST, on].into_iter().chain(two.into_iter().flatten()) {
                let mut sequence = vec![Action::REST; stops];
                sequence.extend(actions);
                sequence.resize(sequence.len().max(whole), then);
                sequence.truncate(whole);
                if !all.contains(&sequence) {
                    all.push(sequence);
                }
            }
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::human::Repertoire;

    #[test]
    fn sequences_begin_later_and_end_with_standing_still() {
        let standpoint = TrialCondition { beginning: 0, beside: [0.0; 3], more: 0, elsewhere: None };
        let walk = Repertoire::usual(0).action(7);
        let known = [
            KnownSequence { standpoint, actions: vec![walk; 2] },
            KnownSequence { standpoint: standpoint.longer(1), actions: vec![] },
        ];
        let (rest, on) = (Action::REST, Action::new(Walk::Forward, Posture::Upright));
        let expected = [
            [walk, walk, rest, rest, rest],
            [walk, walk, on, on, on],
            [rest, rest, walk, walk, rest],
            [rest, rest, walk, walk, on],
        ];
        assert_eq!(shifted(&known, 3, 2), expected);
    }
}
