//! One knob: the fewest steps after which nothing is hazardous.
//!
//! Steps are tried from below: the fewest with which no known sequence leads to a hazard. If a search then meets one, its
//! sequence joins the known ones, and it goes on above (counterexample-guided, as in program synthesis). When that has
//! happened often, steps grow; then the range between the last that failed and the first that held is halved. So whatever is
//! offered held itself, and of one step less a hazard is known. Where more of a change is worse, a smaller one may hold too.

use std::collections::BTreeMap;

use super::checks::{Changed, ExhaustiveBudget, KnownSequence, QuickBudget, SHIFTED, SPENT, Witness, shifted};
use super::condition::MOST_ACTIONS;
use super::{Goal, Rejection, SearchContext};
use crate::cell::design_parameter::DesignParameter;
use crate::human::action::ACTION_S;
use crate::record::advice::{
    HazardAfterChange, NextSmaller, RemainingHazards, RiskReduction, RiskReductionOutcome, TestedAgainst,
};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// After so many counterexamples steps grow.
const PATIENCE: u32 = 4;

/// Actions more than the cell says, for hazards that only come later.
const LATER: u32 = 4;

/// Steps more than the fewest with which nothing is met, where those are too close to be shown.
const MORE: [u32; 4] = [2, 5, 12, 28];

/// Why a robot is not made slower.
const TOO_SLOW: &str = "the robot would be so slow that what it does later was not looked at";

/// One knob being tried.
pub(super) struct MinimalChange<'a> {
    bench: &'a SearchContext<'a>,
    knob: &'a DesignParameter,
    known: Vec<KnownSequence>,
    counterexamples: u32,
    /// Cells changed so far.
    changed: BTreeMap<u32, Result<Changed<'a>, Rejection>>,
    /// Whether a safeguard is smaller in them.
    smaller: BTreeMap<u32, Option<Rejection>>,
    /// What is to be reached.
    goal: Goal,
    /// Steps that held for it against everything but the complete search.
    held: BTreeMap<u32, (TestedAgainst, Left)>,
    /// Most steps that the cell takes, and why not more.
    most: u32,
    limit: Option<Rejection>,
    /// Where the search for the fewest steps stands.
    low: u32,
    below: NextSmaller,
    /// Some number of steps led to a hazard.
    met: bool,
    /// Why some number of steps could not be tried.
    untried: Option<String>,
    /// Why some number of steps is no advice, though nothing was met.
    unadvised: Option<String>,
    /// A hazard was met beyond the time that the cell file looks at.
    later: bool,
    /// What may still be spent, but on complete searches.
    left: u64,
}

/// Hazards that are left after a change, and are no reason against it.
#[derive(Clone, Default)]
struct Left {
    at_least: usize,
    worst: Option<Witness>,
}

/// What came of a step.
enum StepVerdict {
    Met(Witness),
    Impossible(Rejection),
    Held(Box<(TestedAgainst, Left)>),
}

impl<'a> MinimalChange<'a> {
    pub(crate) fn new(bench: &'a SearchContext<'a>, knob: &'a DesignParameter) -> Self {
        Self {
            bench,
            knob,
            known: bench.known.clone(),
            counterexamples: 0,
            changed: BTreeMap::new(),
            smaller: BTreeMap::new(),
            goal: Goal::Lasting,
            held: BTreeMap::new(),
            most: knob.steps,
            limit: knob.end().map(|end| Rejection::NotTried(end.to_owned())),
            low: 0,
            below: NextSmaller::AsItIs,
            met: false,
            untried: None,
            unadvised: None,
            later: false,
            left: bench.effort.quick,
        }
    }

    /// All but complete searches; what they are to confirm comes as [`RiskReductionOutcome::NotMet`] or [`RiskReductionOutcome::OthersRemain`].
    pub(crate) fn quick(&mut self) -> RiskReduction {
        if let Some(outcome) = self.limited() {
            return self.remedy(self.most, outcome);
        }
        if let Some((steps, checked, left)) = self.fewest(Goal::Lasting, None) {
            return self.reached(steps, checked, left);
        }
        if self.bench.aim.is_one_of_several() {
            if let Some((steps, checked, left)) = self.fewest(Goal::Cause, None) {
                return self.reached(steps, checked, left);
            }
        } else if self.later
            // What only puts it off is no advice.
            && let Some((steps, ..)) = self.fewest(Goal::ForNow, None)
            && let Some(met) = self.met_later(steps)
        {
            return self.remedy(steps, RiskReductionOutcome::OnlyLater(met));
        }
        self.no_help()
    }

    fn no_help(&mut self) -> RiskReduction {
        if self.left == 0 {
            return self.remedy(self.most, RiskReductionOutcome::NotTried { cause: SPENT.to_owned() });
        }
        if let Some(cause) = self.unadvised.clone() {
            return self.remedy(self.most, RiskReductionOutcome::NoAdvice { cause });
        }
        if let Some(cause) = self.untried.clone().filter(|_| !self.met) {
            return self.remedy(self.most, RiskReductionOutcome::NotTried { cause });
        }
        let limit = self.limit.as_ref().map(|why| why.cause().to_owned());
        self.remedy(self.most, RiskReductionOutcome::NoHelp { limit })
    }

    /// Goes on with complete searches from where [`Self::quick`] ended with something that held.
    pub(crate) fn complete(&mut self, purse: &mut ExhaustiveBudget, workers: usize) -> RiskReduction {
        // Its own share again: what the searches find is held against other steps.
        self.left = self.bench.effort.quick;
        let first = self.goal;
        if let Some((steps, checked, left)) = self.fewest(first, Some((&mut *purse, workers))) {
            let (steps, checked, left) = self.shown_with_more(steps, checked, left, purse, workers);
            return self.reached(steps, checked, left);
        }
        if first != Goal::Cause
            && self.bench.aim.is_one_of_several()
            && let Some((steps, checked, left)) = self.fewest(Goal::Cause, Some((purse, workers)))
        {
            return self.reached(steps, checked, left);
        }
        self.no_help()
    }

    /// The fewest steps with which nothing was met; or a few more, where those are too close for a search from anywhere to show that nobody
    /// is hit, and with these it does.
    fn shown_with_more(
        &mut self,
        steps: u32,
        checked: TestedAgainst,
        left: Left,
        purse: &mut ExhaustiveBudget,
        workers: usize,
    ) -> (u32, TestedAgainst, Left) {
        let is_close =
            checked.everywhere.as_ref().is_some_and(|everywhere| everywhere.is_close && !checked.is_enough());
        for more in MORE {
            if !is_close || steps + more > self.most || !purse.has_searches() {
                break;
            }
            // Where more of it leads to something else, the fewest stay.
            let StepVerdict::Held(kept) = self.judge(steps + more, &mut Some((&mut *purse, workers))) else { break };
            let (shown, others) = *kept;
            if shown.is_enough() {
                let met = match std::mem::take(&mut self.below) {
                    NextSmaller::Met(met) => Some(met),
                    _ => None,
                };
                self.below = NextSmaller::Close { change: self.knob.words(steps), met };
                return (steps + more, shown, others);
            }
        }
        (steps, checked, left)
    }

    /// The goal is reached.
    fn reached(&mut self, steps: u32, checked: TestedAgainst, left: Left) -> RiskReduction {
        let checked = TestedAgainst { counterexamples: self.counterexamples, one_less: self.below.clone(), ..checked };
        let all = checked.is_complete();
        if self.goal != Goal::Cause {
            return self.remedy(
                steps,
                if all { RiskReductionOutcome::Sufficient(checked) } else { RiskReductionOutcome::NotMet(checked) },
            );
        }
        let worst = left.worst.and_then(|worst| self.changed(steps).ok().map(|changed| changed.met(&worst)));
        self.remedy(
            steps,
            RiskReductionOutcome::OthersRemain(RemainingHazards {
                at_least: left.at_least,
                worst,
                complete: all,
                checked,
            }),
        )
    }

    fn remedy(&mut self, steps: u32, outcome: RiskReductionOutcome) -> RiskReduction {
        let cell = self.changed(steps).map_or_else(|_| String::new(), |changed| changed.text().to_owned());
        let reached = matches!(
            outcome,
            RiskReductionOutcome::Sufficient(_)
                | RiskReductionOutcome::NotMet(_)
                | RiskReductionOutcome::OthersRemain(_)
        );
        let limit = self.knob.end().filter(|_| !reached && self.most == self.knob.steps).map(str::to_owned);
        RiskReduction { change: self.knob.words(steps), cell, limit, outcome }
    }

    /// The hazard that is met after so many steps later than the cell file looks.
    fn met_later(&mut self, steps: u32) -> Option<HazardAfterChange> {
        self.aim_at(Goal::Lasting);
        let StepVerdict::Met(witness) = self.judge(steps, &mut None) else { return None };
        self.changed(steps).ok().map(|changed| changed.met(&witness))
    }

    /// Finds out how far the knob can be turned; an outcome if that is not at all.
    fn limited(&mut self) -> Option<RiskReductionOutcome> {
        let (mut low, mut high) = (0, self.knob.steps);
        if let Err(why) = self.allowed(high) {
            self.limit = Some(why);
            // What is turned the wrong way, or ends the FMU, does so from the first step: others are not tried.
            if let Err(why) = self.allowed(1) {
                (high, self.limit) = (1, Some(why));
            }
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                match self.allowed(middle) {
                    Ok(()) => low = middle,
                    Err(why) => {
                        high = middle;
                        self.limit = Some(why);
                    }
                }
            }
            self.most = low.max(1);
            if low == 0 {
                return self.limit.clone().map(|why| match why {
                    Rejection::NotTried(cause) => RiskReductionOutcome::NotTried { cause },
                    Rejection::Smaller(cause) | Rejection::NoAdvice(cause) => RiskReductionOutcome::NoAdvice { cause },
                });
            }
        }
        None
    }

    /// Whether the cell takes so many steps, and no safeguard is smaller for it.
    fn allowed(&mut self, steps: u32) -> Result<(), Rejection> {
        self.changed(steps)?;
        if !self.knob.may_set_a_safeguard() {
            return Ok(());
        }
        let smaller = match self.smaller.get(&steps) {
            Some(known) => known.clone(),
            None => {
                let (smaller, cost) = self.changed(steps)?.smaller();
                self.left = self.left.saturating_sub(cost);
                self.smaller.insert(steps, smaller.clone());
                smaller
            }
        };
        smaller.map_or(Ok(()), Err)
    }

    fn changed(&mut self, steps: u32) -> Result<&Changed<'a>, Rejection> {
        let (bench, knob) = (self.bench, self.knob);
        self.changed.entry(steps).or_insert_with(|| Changed::new(bench, knob, steps)).as_ref().map_err(Clone::clone)
    }

    /// Begins anew for another goal.
    fn aim_at(&mut self, goal: Goal) {
        self.goal = goal;
        self.held.clear();
        (self.low, self.below) = (0, NextSmaller::AsItIs);
    }

    /// The fewest steps that reach a goal, what they were held against, and which hazards are left all the same. Leaves in
    /// `below` what one step less leads to.
    fn fewest(
        &mut self,
        goal: Goal,
        mut completely: Option<(&mut ExhaustiveBudget, usize)>,
    ) -> Option<(u32, TestedAgainst, Left)> {
        if self.goal != goal {
            self.aim_at(goal);
        }
        let most = self.most_that_helps()?;
        let mut high = most;
        let mut misses = 0_u32;
        let mut held: Option<(TestedAgainst, Left)> = None;
        loop {
            if self.low >= high {
                return None;
            }
            let candidate = match held.take() {
                Some((checked, groups)) if high - self.low == 1 => return Some((high, checked, groups)),
                Some(kept) => {
                    held = Some(kept);
                    self.low + (high - self.low) / 2
                }
                None => {
                    let least = self.least_for_known(most);
                    let growth = misses.saturating_sub(PATIENCE).min(6);
                    if growth > 0 { (least + (1 << growth)).min(most) } else { least }
                }
            };
            match self.judge(candidate, &mut completely) {
                StepVerdict::Held(kept) => {
                    // What every sequence was looked at with is worth more than a little less with which some were.
                    if let Some((checked, left)) = held.take_if(|(checked, _)| checked.rank() > kept.0.rank()) {
                        self.below = NextSmaller::NotTried { cause: SPENT.to_owned() };
                        return Some((high, checked, left));
                    }
                    high = candidate;
                    held = Some(*kept);
                }
                StepVerdict::Met(witness) => {
                    self.fails(candidate, &witness);
                    if !self.known.contains(&witness.known) {
                        self.known.insert(0, witness.known);
                        self.counterexamples += 1;
                    }
                    misses += 1;
                }
                StepVerdict::Impossible(why) => {
                    misses += 1;
                    self.cannot(candidate, &why);
                }
            }
        }
    }

    /// So many steps cannot be tried.
    fn cannot(&mut self, steps: u32, why: &Rejection) {
        let cause = why.cause().to_owned();
        if let Rejection::NoAdvice(_) = why {
            self.unadvised = Some(cause.clone());
        }
        self.untried = Some(cause.clone());
        (self.low, self.below) = (steps, NextSmaller::NotTried { cause });
    }

    /// So many steps lead to a hazard.
    fn fails(&mut self, steps: u32, witness: &Witness) {
        self.met = true;
        self.later |= witness.known.standpoint.more > 0;
        let met = self.changed(steps).map(|changed| changed.met(witness));
        (self.low, self.below) = (steps, met.map_or_else(|_| NextSmaller::AsItIs, NextSmaller::Met));
    }

    /// Of all steps, their half, their quarter and so on the first that helps against the known sequences: fewer may where
    /// more do not, because they lead past the person.
    fn most_that_helps(&mut self) -> Option<u32> {
        let mut steps = self.most;
        while steps > self.low {
            match self.known(steps) {
                Ok(None) => return Some(steps),
                Ok(Some(_)) => self.met = true,
                Err(why) => self.untried = Some(why.cause().to_owned()),
            }
            steps /= 2;
        }
        None
    }

    /// The fewest steps above those that fail with which no known sequence leads to a hazard, by halving.
    fn least_for_known(&mut self, most: u32) -> u32 {
        let mut high = most;
        while high - self.low > 1 {
            let middle = self.low + (high - self.low) / 2;
            match self.known(middle) {
                Ok(None) => high = middle,
                Ok(Some(witness)) => self.fails(middle, &witness),
                Err(why) => self.cannot(middle, &why),
            }
        }
        high
    }

    /// What the known sequences lead to. One that leads to a hazard then stands first: it is likely to do so again.
    fn known(&mut self, steps: u32) -> Result<Option<Witness>, Rejection> {
        let mut pass = QuickBudget::new(self.goal, self.left);
        let looked = self.known_with(steps, &mut pass);
        self.left = pass.left();
        looked
    }

    fn known_with(&mut self, steps: u32, pass: &mut QuickBudget) -> Result<Option<Witness>, Rejection> {
        let (bench, goal) = (self.bench, self.goal);
        let known: Vec<KnownSequence> =
            self.known.iter().filter(|known| bench.is_from(goal, &known.standpoint)).cloned().collect();
        let witness = self.changed(steps)?.run_all(&known.iter().collect::<Vec<_>>(), pass)?;
        if let Some(Witness { known: KnownSequence { standpoint, actions }, .. }) = &witness {
            let led = |known: &KnownSequence| known.standpoint == *standpoint && known.actions.starts_with(actions);
            if let Some(place) = self.known.iter().position(led) {
                self.known[..=place].rotate_right(1);
            }
        }
        Ok(witness)
    }

    /// Tries a step; completely if there is a purse for it.
    fn judge(&mut self, steps: u32, completely: &mut Option<(&mut ExhaustiveBudget, usize)>) -> StepVerdict {
        let looked = match self.held.get(&steps) {
            Some(held) => Ok(Ok(held.clone())),
            None => self.look_quickly(steps),
        };
        let looked = looked.and_then(|looked| match (looked, completely) {
            (Ok(held), Some((purse, workers))) => self.look_completely(steps, held, purse, *workers),
            (looked, _) => Ok(looked),
        });
        match looked {
            Ok(Ok(held)) => StepVerdict::Held(Box::new(held)),
            Ok(Err(witness)) => StepVerdict::Met(witness),
            Err(why) => StepVerdict::Impossible(why),
        }
    }

    /// Everything but complete searches.
    fn look_quickly(&mut self, steps: u32) -> Result<Result<(TestedAgainst, Left), Witness>, Rejection> {
        let mut pass = QuickBudget::new(self.goal, self.left);
        let looked = match self.known_with(steps, &mut pass) {
            Ok(None) => self.search(steps, &mut pass),
            Ok(Some(witness)) => Ok(Err(witness)),
            Err(why) => Err(why),
        };
        self.left = pass.left();
        let checked = match looked? {
            Ok(checked) => checked,
            Err(witness) => return Ok(Err(witness)),
        };
        self.allowed(steps)?;
        let (why, cost) = self.changed(steps)?.reported_anew();
        self.left = self.left.saturating_sub(cost);
        why.map_or(Ok(()), Err)?;
        let worst = pass.others.ranked().first().map(|group| Witness::new(&group.worst, self.bench.own));
        let held = (checked, Left { at_least: pass.others.len(), worst });
        self.held.insert(steps, held.clone());
        Ok(Ok(held))
    }

    /// Every sequence, as far as the purse goes: from the start and the cell's other beginnings, or, where only one cause is
    /// to be gone, from the start.
    fn look_completely(
        &mut self,
        steps: u32,
        (mut checked, left): (TestedAgainst, Left),
        purse: &mut ExhaustiveBudget,
        workers: usize,
    ) -> Result<Result<(TestedAgainst, Left), Witness>, Rejection> {
        let (bench, goal) = (self.bench, self.goal);
        let changed = self.changed(steps)?;
        let before = *purse;
        let beginnings = if goal == Goal::Cause { &[][..] } else { &bench.beginnings };
        for standpoint in std::iter::once(&bench.own).chain(beginnings) {
            if purse.is_empty() {
                checked.complete.clear();
                return Ok(Ok((checked, left)));
            }
            match changed.all(*standpoint, goal, purse, workers)? {
                Ok(complete) => checked.complete.push(complete),
                Err(witness) => return Ok(Err(witness)),
            }
        }
        // From beside the start as well, where that is cheap.
        let around = if goal == Goal::Cause { &[][..] } else { &bench.around };
        if checked.is_complete() && !around.is_empty() && purse.has_twice(&before, checked.complete.len(), around.len())
        {
            checked.around_complete = true;
            // Where the change leaves no room nobody begins.
            for standpoint in around.iter().filter(|standpoint| changed.has_room(standpoint)) {
                match changed.all(*standpoint, goal, purse, workers)? {
                    Ok(complete) => checked.around_complete &= complete.reasons.is_empty(),
                    Err(witness) => return Ok(Err(witness)),
                }
            }
        }
        if goal == Goal::Lasting && checked.is_complete() {
            match changed.everywhere(purse, workers) {
                Ok(everywhere) => checked.everywhere = everywhere,
                Err(witness) => return Ok(Err(*witness)),
            }
        }
        Ok(Ok((checked, left)))
    }

    /// Quick searches from everywhere.
    fn search(&mut self, steps: u32, pass: &mut QuickBudget) -> Result<Result<TestedAgainst, Witness>, Rejection> {
        let (bench, known) = (self.bench, self.known.clone());
        let known_sequences = bench.all.len();
        let changed = self.changed(steps)?;
        let iterations = bench.effort.iterations;
        let mut checked = TestedAgainst { known_sequences, searched: iterations, ..TestedAgainst::default() };
        if let Some(witness) = match changed.run_all(&bench.all.iter().collect::<Vec<_>>(), pass)? {
            None => changed.search(bench.own, iterations, pass)?,
            met => met,
        } {
            return Ok(Err(witness));
        }
        if pass.goal != Goal::ForNow
            && let Some(witness) = self.search_later(steps, &mut checked, pass)?
        {
            return Ok(Err(witness));
        }
        let changed = self.changed(steps)?;
        for standpoint in bench.beginnings.iter().chain(&bench.around) {
            let worst = known.iter().filter(|known| known.standpoint == bench.own).take(SHIFTED / 2);
            let worst = worst.map(|known| known.actions.as_slice());
            if let Some(witness) = match changed.run(*standpoint, worst, pass)? {
                None => changed.search(*standpoint, iterations.div_ceil(2), pass)?,
                met => met,
            } {
                return Ok(Err(witness));
            }
        }
        checked.around = bench.around.iter().filter(|standpoint| changed.has_room(standpoint)).count();
        Ok(Ok(checked))
    }

    /// Quick searches for longer than the cell file says.
    fn search_later(
        &mut self,
        steps: u32,
        checked: &mut TestedAgainst,
        pass: &mut QuickBudget,
    ) -> Result<Option<Witness>, Rejection> {
        let (bench, knob, known) = (self.bench, self.knob, self.known.clone());
        let changed = self.changed(steps)?;
        // A slower robot is where it was so much later, counted from the FMU's own start.
        let cell = &bench.prepared.cell;
        let actions = cell.search.actions;
        let before = cell.begins_s() / ACTION_S;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "at most some hundreds")]
        let slower = |left: f64| ((before + f64::from(actions)) * (1.0 / left.max(0.01) - 1.0)).ceil() as u32;
        // And a robot that is farther away is reached so much later.
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few")]
        let way = (knob.farther_m(steps) / (WALKING_SPEED_M_S * ACTION_S)).ceil() as u32;
        let more = LATER + knob.speed_left(steps).map_or(0, slower) + way;
        if actions + more > MOST_ACTIONS {
            return Err(Rejection::NotTried(TOO_SLOW.to_owned()));
        }
        let later = bench.own.longer(more);
        let sequences = shifted(&known, actions as usize, more as usize);
        let met = match changed.run(later, sequences.iter().map(Vec::as_slice), pass)? {
            None => changed.search(later, bench.effort.iterations, pass)?,
            met => met,
        };
        checked.longest_s = f64::from(actions + more) * ACTION_S;
        Ok(met)
    }
}
