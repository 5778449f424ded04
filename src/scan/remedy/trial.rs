//! One knob: the fewest steps after which nothing is hazardous.
//!
//! Steps are tried from below: the fewest with which no known sequence leads to a hazard. If a search then meets one, its
//! sequence joins the known ones, and it goes on above (counterexample-guided, as in program synthesis). When that has
//! happened often, steps grow; then the range between the last that failed and the first that held is halved. So whatever is
//! offered held itself, and of one step less a hazard is known. Where more of a change is worse, a smaller one may hold too.

use std::collections::BTreeMap;

use super::looking::{Changed, Known, SHIFTED, Witness, shifted};
use super::standpoint::Standpoint;
use super::{Bench, Goal, Why};
use crate::cell::knob::Knob;
use crate::hazard::Groups;
use crate::human::action::ACTION_S;
use crate::report::advice::{Checked, OneLess, Others, Outcome, Remedy};
use crate::search::exhaustive::Budget;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// After so many counterexamples steps grow.
const PATIENCE: u32 = 4;

/// Actions more than the cell says, for hazards that only come later.
const LATER: u32 = 4;

/// One knob being tried.
pub(super) struct Trial<'a> {
    bench: &'a Bench<'a>,
    knob: &'a Knob,
    known: Vec<Known>,
    counterexamples: u32,
    /// Cells changed so far.
    changed: BTreeMap<u32, Result<Changed<'a>, Why>>,
    /// Steps that held against everything but the complete search.
    held: BTreeMap<u32, Checked>,
    /// Most steps that the cell takes, and why not more.
    most: u32,
    limit: Option<Why>,
    /// Where the search for the fewest steps stands.
    low: u32,
    below: OneLess,
    /// A hazard was met beyond the time that the cell file looks at.
    later: bool,
}

/// What came of a step.
enum Judged {
    Met(Witness),
    Impossible(Why),
    Held(Checked, Groups),
}

impl<'a> Trial<'a> {
    pub fn new(bench: &'a Bench<'a>, knob: &'a Knob) -> Self {
        Self {
            bench,
            knob,
            known: bench.known.clone(),
            counterexamples: 0,
            changed: BTreeMap::new(),
            held: BTreeMap::new(),
            most: knob.steps,
            limit: knob.end().map(|end| Why::NotTried(end.to_owned())),
            low: 0,
            below: OneLess::AsItIs,
            later: false,
        }
    }

    /// All but complete searches; what they are to confirm comes as [`Outcome::NotMet`].
    pub fn quick(&mut self) -> Remedy {
        if let Some(outcome) = self.limited() {
            return self.remedy(self.most, outcome);
        }
        self.attempt(None)
    }

    /// Goes on with complete searches from where [`Self::quick`] ended.
    pub fn complete(&mut self, workers: usize) -> Remedy {
        self.attempt(Some(workers))
    }

    fn remedy(&mut self, steps: u32, outcome: Outcome) -> Remedy {
        let cell = self.changed(steps).map_or_else(|_| String::new(), |changed| changed.text().to_owned());
        let ended = !matches!(outcome, Outcome::Sufficient(_) | Outcome::NotMet(_)) && self.most == self.knob.steps;
        let limit = self.knob.end().filter(|_| ended).map(str::to_owned);
        Remedy { change: self.knob.words(steps), cell, limit, outcome }
    }

    fn attempt(&mut self, workers: Option<usize>) -> Remedy {
        if let Some((steps, checked, _)) = self.fewest(Goal::Lasting, workers) {
            let checked = Checked { counterexamples: self.counterexamples, one_less: self.below.clone(), ..checked };
            let all = !checked.complete.is_empty() && checked.complete.iter().all(|c| c.reasons.is_empty());
            return self.remedy(steps, if all { Outcome::Sufficient(checked) } else { Outcome::NotMet(checked) });
        }
        // What is left is no advice: nothing of it needs a complete search.
        if self.later {
            (self.low, self.below) = (0, OneLess::AsItIs);
            if let Some((steps, ..)) = self.fewest(Goal::ForNow, None)
                && let Judged::Met(witness) = self.judge(steps, Goal::Lasting, None)
                && let Ok(changed) = self.changed(steps)
            {
                let met = changed.met(&witness);
                return self.remedy(steps, Outcome::OnlyLater(met));
            }
        }
        (self.low, self.below) = (0, OneLess::AsItIs);
        if let Some((steps, _, others)) = self.fewest(Goal::Hazard, None) {
            let worst =
                others.ranked().first().map(|group| Witness::new(&group.worst, Standpoint::own(self.bench.prepared)));
            if let (Some(worst), Ok(changed)) = (worst, self.changed(steps)) {
                let others = Others { at_least: others.len(), worst: changed.met(&worst) };
                return self.remedy(steps, Outcome::OthersRemain(others));
            }
        }
        let limit = self.limit.as_ref().map(|why| why.cause().to_owned());
        self.remedy(self.most, Outcome::NoHelp { limit })
    }

    /// Finds out how far the knob can be turned; an outcome if that is not at all.
    fn limited(&mut self) -> Option<Outcome> {
        let (mut low, mut high) = (0, self.knob.steps);
        if let Err(why) = self.changed(high) {
            self.limit = Some(why);
            while high - low > 1 {
                let middle = low + (high - low) / 2;
                match self.changed(middle) {
                    Ok(_) => low = middle,
                    Err(why) => {
                        high = middle;
                        self.limit = Some(why);
                    }
                }
            }
            self.most = low.max(1);
            if low == 0 {
                return self.limit.clone().map(|why| match why {
                    Why::NotTried(cause) => Outcome::NotTried { cause },
                    Why::Smaller(cause) | Why::NoAdvice(cause) => Outcome::NoAdvice { cause },
                });
            }
        }
        None
    }

    fn changed(&mut self, steps: u32) -> Result<&Changed<'a>, Why> {
        let (bench, knob) = (self.bench, self.knob);
        self.changed.entry(steps).or_insert_with(|| Changed::new(bench, knob, steps)).as_ref().map_err(Clone::clone)
    }

    /// The fewest steps that reach a goal, what they were held against, and which hazards are left all the same. Leaves in
    /// `below` what one step less leads to.
    fn fewest(&mut self, goal: Goal, workers: Option<usize>) -> Option<(u32, Checked, Groups)> {
        let most = self.most_that_helps(goal)?;
        let mut high = most;
        let mut misses = 0_u32;
        let mut held: Option<(Checked, Groups)> = None;
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
                    let least = self.least_for_known(goal, most);
                    let growth = misses.saturating_sub(PATIENCE).min(6);
                    if growth > 0 { (least + (1 << growth)).min(most) } else { least }
                }
            };
            match self.judge(candidate, goal, workers) {
                Judged::Held(checked, groups) => {
                    high = candidate;
                    held = Some((checked, groups));
                }
                Judged::Met(witness) => {
                    self.fails(candidate, &witness);
                    if !self.known.contains(&witness.known) {
                        self.known.insert(0, witness.known);
                        self.counterexamples += 1;
                    }
                    misses += 1;
                }
                Judged::Impossible(why) => {
                    (self.low, self.below) = (candidate, OneLess::NotTried { cause: why.cause().to_owned() });
                }
            }
        }
    }

    /// So many steps lead to a hazard.
    fn fails(&mut self, steps: u32, witness: &Witness) {
        self.later |= witness.known.standpoint.more > 0;
        let met = self.changed(steps).map(|changed| changed.met(witness));
        (self.low, self.below) = (steps, met.map_or_else(|_| OneLess::AsItIs, OneLess::Met));
    }

    /// Of all steps, their half, their quarter and so on the first that helps against the known sequences: fewer may where
    /// more do not, because they lead past the person.
    fn most_that_helps(&mut self, goal: Goal) -> Option<u32> {
        let mut steps = self.most;
        while steps > self.low {
            if matches!(self.known(steps, goal, &mut Groups::default()), Ok(None)) {
                return Some(steps);
            }
            steps /= 2;
        }
        None
    }

    /// The fewest steps above those that fail with which no known sequence leads to a hazard, by halving.
    fn least_for_known(&mut self, goal: Goal, most: u32) -> u32 {
        let mut high = most;
        while high - self.low > 1 {
            let middle = self.low + (high - self.low) / 2;
            match self.known(middle, goal, &mut Groups::default()) {
                Ok(None) => high = middle,
                Ok(Some(witness)) => self.fails(middle, &witness),
                Err(why) => (self.low, self.below) = (middle, OneLess::NotTried { cause: why.cause().to_owned() }),
            }
        }
        high
    }

    /// What the known sequences lead to. One that leads to a hazard then stands first: it is likely to do so again.
    fn known(&mut self, steps: u32, goal: Goal, others: &mut Groups) -> Result<Option<Witness>, Why> {
        let known: Vec<Known> =
            self.known.iter().filter(|known| self.bench.is_from(goal, &known.standpoint)).cloned().collect();
        let changed = self.changed(steps)?;
        let mut standpoints: Vec<Standpoint> = Vec::new();
        for Known { standpoint, .. } in &known {
            if !standpoints.contains(standpoint) {
                standpoints.push(*standpoint);
            }
        }
        for standpoint in standpoints {
            let from =
                known.iter().filter(|known| known.standpoint == standpoint).map(|known| known.actions.as_slice());
            if let Some(witness) = changed.run(standpoint, from, goal, others)? {
                let led =
                    |known: &Known| known.standpoint == standpoint && known.actions.starts_with(&witness.known.actions);
                if let Some(place) = self.known.iter().position(led) {
                    self.known[..=place].rotate_right(1);
                }
                return Ok(Some(witness));
            }
        }
        Ok(None)
    }

    /// Tries a step; completely if there are `workers` for it.
    fn judge(&mut self, steps: u32, goal: Goal, workers: Option<usize>) -> Judged {
        let mut others = Groups::default();
        let looked = self.known(steps, goal, &mut others).and_then(|met| match met {
            Some(witness) => Ok(Err(witness)),
            None => self.look(steps, goal, workers, &mut others),
        });
        match looked {
            Ok(Ok(checked)) => Judged::Held(checked, others),
            Ok(Err(witness)) => Judged::Met(witness),
            Err(why) => Judged::Impossible(why),
        }
    }

    /// Everything but the known sequences.
    fn look(
        &mut self,
        steps: u32,
        goal: Goal,
        workers: Option<usize>,
        others: &mut Groups,
    ) -> Result<Result<Checked, Witness>, Why> {
        let before = if goal == Goal::Lasting { self.held.get(&steps).cloned() } else { None };
        let mut checked = match before {
            Some(checked) => checked,
            None => match self.look_quickly(steps, goal, others)? {
                Ok(checked) => checked,
                Err(witness) => return Ok(Err(witness)),
            },
        };
        if goal == Goal::Lasting {
            self.held.insert(steps, checked.clone());
        }
        let (Some(workers), bench) = (workers, self.bench) else { return Ok(Ok(checked)) };
        let changed = self.changed(steps)?;
        let (states, work) = (bench.effort.states, bench.effort.work);
        let budget = Budget { states, bytes: bench.effort.bytes, work, drop: true };
        let mut spent = [0, 0];
        for standpoint in std::iter::once(&bench.own).chain(&bench.beginnings) {
            match changed.all(*standpoint, budget, workers)? {
                Ok((complete, cost)) => {
                    checked.complete.push(complete);
                    spent = [spent[0] + cost[0], spent[1] + cost[1]];
                }
                Err(witness) => return Ok(Err(witness)),
            }
        }
        // From beside the start as well, where that is cheap.
        let (done, left) = (checked.complete.len() as u64, bench.around.len() as u64);
        let enough = |spent: u64, budget: u64| spent / done.max(1) * left * 2 <= budget;
        let complete = checked.complete.iter().all(|complete| complete.reasons.is_empty());
        if complete && enough(spent[0], states as u64) && enough(spent[1], work) {
            checked.around_complete = true;
            for standpoint in &bench.around {
                match changed.all(*standpoint, budget, workers)? {
                    Ok((complete, _)) => checked.around_complete &= complete.reasons.is_empty(),
                    Err(witness) => return Ok(Err(witness)),
                }
            }
        }
        Ok(Ok(checked))
    }

    /// Quick searches from everywhere.
    fn look_quickly(&mut self, steps: u32, goal: Goal, others: &mut Groups) -> Result<Result<Checked, Witness>, Why> {
        let (bench, knob, known) = (self.bench, self.knob, self.known.clone());
        let known_sequences = bench.known.len();
        let changed = self.changed(steps)?;
        let iterations = bench.effort.iterations;
        let mut checked = Checked { known_sequences, searched: iterations, ..Checked::default() };
        if let Some(witness) = changed.search(bench.own, iterations, goal, others)? {
            return Ok(Err(witness));
        }
        if goal == Goal::Lasting {
            // A slower robot is where it was so much later.
            let actions = bench.prepared.cell.search.actions;
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to twice the actions")]
            let slower =
                |left: f64| (f64::from(actions) * (1.0 / left.max(0.1) - 1.0)).ceil().min(f64::from(actions)) as u32;
            // And a robot that is farther away is reached so much later.
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few")]
            let way = (knob.farther_m(steps) / (WALKING_SPEED_M_S * ACTION_S)).ceil() as u32;
            let more = LATER + knob.speed_left(steps).map_or(0, slower) + way;
            let later = bench.own.longer(more);
            let sequences = shifted(&known, actions as usize, more as usize);
            let met = changed.run(later, sequences.iter().map(Vec::as_slice), goal, others)?;
            if let Some(witness) = match met {
                None => changed.search(later, iterations, goal, others)?,
                met => met,
            } {
                return Ok(Err(witness));
            }
            checked.longest_s = f64::from(actions + more) * ACTION_S;
        }
        if goal != Goal::Hazard {
            for standpoint in bench.beginnings.iter().chain(&bench.around) {
                let worst = known.iter().filter(|known| known.standpoint == bench.own).take(SHIFTED / 2);
                let worst = worst.map(|known| known.actions.as_slice());
                if let Some(witness) = match changed.run(*standpoint, worst, goal, others)? {
                    None => changed.search(*standpoint, iterations.div_ceil(2), goal, others)?,
                    met => met,
                } {
                    return Ok(Err(witness));
                }
            }
            checked.around = bench.around.len();
        }
        Ok(Ok(checked))
    }
}
