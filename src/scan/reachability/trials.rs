//! What a search from anywhere takes for granted of an FMU, tried out: that its robots do the same with all people of whom the
//! same is reported, where it is told where they are; and which sensors each robot heeds (`heeded.rs`).
//!
//! Runs are made twice: with other people of whom the same is reported, or with one sensor that reports something else. Some begin with
//! the FMU and report at random until the end; others begin at many moments at which nothing was reported before. What comes out the same
//! to the last bit in all of them was tried out, and is no more than that.

use super::trial_instants::{Moments, TrialStep};
use crate::cell::{Binding, Workcell};
use crate::host::{Plant, PlantError};
use crate::human::Presses;
use crate::reachability::internal_sensors::StandingPose;
use crate::search::Rng;

/// Runs with other people, from the start and from each moment.
const OTHER_PEOPLE: u32 = 48;
const OTHERS_AT_A_MOMENT: u32 = 2;
/// Readings last for so many steps on average, in one run and another.
const LASTING: [usize; 4] = [3, 10, 30, 80];
/// A run from a moment goes on for so many steps.
pub(super) const WINDOW: usize = 80;

/// Something that may be reported of somebody, and people of whom it is.
pub(super) struct Kind {
    pub readings: Vec<bool>,
    pub people: Vec<StandingPose>,
}

impl Kind {
    /// The person who stands for all of them.
    pub(crate) fn person(&self) -> StandingPose {
        self.people.first().copied().unwrap_or_default()
    }
}

/// An FMU that is tried out.
pub(super) struct Trial<'a, P: Plant> {
    pub moments: Moments<'a, P>,
    pub cell: &'a Workcell,
    pub binding: &'a Binding,
    /// The first is that of the very start.
    pub kinds: &'a [Kind],
    pub steps: usize,
    pub rng: Rng,
    /// Whether controls are worked at random as well.
    pub presses: bool,
    /// Runs that were compared.
    pub runs: u32,
}

impl<P: Plant> Trial<'_, P> {
    /// Whether the outputs are the same with all people of whom the same is reported, as far as was tried.
    pub(crate) fn are_people_alike(&mut self) -> Result<bool, PlantError> {
        for run in 0..OTHER_PEOPLE {
            if !self.are_others_alike(0, self.steps, run)? {
                return Ok(false);
            }
        }
        for moment in 1..self.moments.count() {
            for run in 0..OTHERS_AT_A_MOMENT {
                let number = u32::try_from(moment).unwrap_or(u32::MAX) * OTHERS_AT_A_MOMENT + run;
                if !self.are_others_alike(moment, WINDOW.min(self.steps), number)? {
                    return Ok(false);
                }
            }
        }
        Ok(true)
    }

    /// The same readings with others, from a moment on.
    fn are_others_alike(&mut self, moment: usize, steps: usize, run: u32) -> Result<bool, PlantError> {
        let readings = self.random(steps, run);
        let same = self.persons(&readings);
        // Somebody else at each step, or for as long as the readings last.
        let mut others: Vec<StandingPose> = Vec::new();
        for (step, kind) in readings.iter().enumerate() {
            let stays = run.is_multiple_of(2) && step > 0 && readings[step] == readings[step - 1];
            let people = &self.kinds[*kind].people;
            let other = if stays {
                others[step - 1]
            } else {
                people.get(self.rng.below(people.len().max(1))).copied().unwrap_or_default()
            };
            others.push(other);
        }
        let pressed = self.pressed(steps, run);
        let (a, b) = (self.told(&readings, &same, &pressed), self.told(&readings, &others, &pressed));
        let (a, b) = (self.moments.run(moment, &a)?, self.moments.run(moment, &b)?);
        self.runs += 1;
        Ok(a.iter().zip(&b).all(|(a, b)| a.to_bits() == b.to_bits()))
    }

    /// Those who stand for what is reported.
    pub(super) fn persons(&self, readings: &[usize]) -> Vec<StandingPose> {
        readings.iter().map(|kind| self.kinds[*kind].person()).collect()
    }

    /// Readings at random, each for a while, from those of the start on.
    pub(super) fn random(&mut self, steps: usize, run: u32) -> Vec<usize> {
        let lasting = LASTING[run as usize % LASTING.len()];
        let mut kinds = vec![0; steps];
        for step in 1..steps {
            let changes = self.rng.below(lasting) == 0;
            kinds[step] = if changes { self.rng.below(self.kinds.len()) } else { kinds[step - 1] };
        }
        kinds
    }

    /// Which controls are on at each step, at random, each for a while.
    pub(super) fn pressed(&mut self, steps: usize, run: u32) -> Vec<Presses> {
        let lasting = LASTING[run as usize % LASTING.len()];
        let mut pressed = vec![Presses::NONE; steps];
        if self.presses {
            for step in 1..steps {
                let some = Presses::all(self.cell.controls.len()).nth(self.rng.below(1 << self.cell.controls.len()));
                let changes = self.rng.below(lasting) == 0;
                pressed[step] = some.filter(|_| changes).unwrap_or(pressed[step - 1]);
            }
        }
        pressed
    }

    /// What the FMU is told.
    pub(super) fn told(&self, readings: &[usize], people: &[StandingPose], pressed: &[Presses]) -> Vec<TrialStep> {
        let step = |((kind, person), pressed): ((&usize, &StandingPose), &Presses)| TrialStep {
            readings: self.kinds[*kind].readings.clone(),
            person: *person,
            pressed: *pressed,
        };
        readings.iter().zip(people).zip(pressed).map(step).collect()
    }

    /// When trials began, in words.
    pub(crate) fn began(&self) -> String {
        let last_s = self.moments.at(self.moments.count().saturating_sub(1)) as f64 * self.cell.step_s;
        match self.moments.count() {
            1 => "at the start".to_owned(),
            many => format!("at {many} moments from 0 s to {last_s:.2} s at which nothing had been reported before"),
        }
    }
}
