//! An FMU at many moments of what it does while nobody is reported: where trials begin. A stop that latches would hide everything that
//! comes after it, so each begins where nothing was reported before.

use crate::cell::{Binding, Workcell};
use crate::host::{Plant, PlantError};
use crate::human::Presses;
use crate::reachability::internal_sensors::{StandingPose, sensor_target};
use crate::search::Rng;
use crate::sim::sensors::{DelayLine, input_row};

/// Most moments. However states are brought back, they are the same.
pub(super) const MOST: usize = 24;

/// What is reported, the person of whom it is, and which controls are worked, in one step.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct TrialStep {
    /// By sensor, before any delay of the host.
    pub readings: Vec<bool>,
    /// As the FMU is told.
    pub person: StandingPose,
    /// Controls that are worked.
    pub pressed: Presses,
}

/// See the top of this file.
pub(super) struct Moments<'a, P: Plant> {
    plant: P,
    cell: &'a Workcell,
    binding: &'a Binding,
    nobody: TrialStep,
    /// Steps from the start, and the state there, if states can be saved: it is worth nothing after a restart.
    all: Vec<(usize, Option<P::Checkpoint>)>,
    /// Steps that are looked at: no run goes beyond.
    steps: usize,
    /// What the FMU does while nobody is reported: outputs after each step.
    undisturbed: Vec<f64>,
    /// Steps that were taken.
    pub taken: u64,
}

impl<'a, P: Plant> Moments<'a, P> {
    /// Moments of so many steps: the start, and one in each part of the rest; `saves` if the FMU's states are to be saved there.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(crate) fn new(
        plant: P,
        (cell, binding): (&'a Workcell, &'a Binding),
        nobody: TrialStep,
        (steps, saves): (usize, bool),
        rng: &mut Rng,
    ) -> Result<Self, PlantError> {
        let undisturbed = Vec::new();
        let mut moments =
            Self { plant, cell, binding, nobody, all: Vec::new(), steps, undisturbed, taken: steps as u64 };
        let count = MOST.min(steps).max(1);
        moments.plant.restart()?;
        let mut at = 0;
        for number in 0..count {
            // Every other one is anywhere in its part, lest they all meet the same moment of a cycle.
            let off = if number.is_multiple_of(2) { 0 } else { rng.below((steps / count).max(1)) };
            let to = number * steps / count + off;
            moments.wait(at, to)?;
            let saved = if saves { Some(moments.plant.save()?) } else { None };
            moments.all.push((to, saved));
            at = to;
        }
        moments.wait(at, steps)?;
        Ok(moments)
    }

    /// How many there are.
    pub(crate) fn count(&self) -> usize {
        self.all.len()
    }

    /// The steps from the start to one of them.
    pub(crate) fn at(&self, moment: usize) -> usize {
        self.all.get(moment).map_or(0, |(at, _)| *at)
    }

    /// Nobody is reported from one step to another; what the FMU does is noted.
    fn wait(&mut self, from: usize, to: usize) -> Result<(), PlantError> {
        if to > from {
            let inputs = self.inputs(&vec![self.nobody.clone(); to - from]);
            self.undisturbed.extend(self.plant.advance(to - from, &inputs)?);
        }
        Ok(())
    }

    /// What the FMU does in so many steps from a moment while nobody is reported, as far as that is known.
    pub(crate) fn undisturbed(&self, moment: usize, steps: usize) -> &[f64] {
        let width = self.plant.output_count();
        let from = (self.at(moment) * width).min(self.undisturbed.len());
        &self.undisturbed[from..(from + steps * width).min(self.undisturbed.len())]
    }

    /// The outputs after each step when this is told from a moment on, as far as steps are looked at.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(crate) fn run(&mut self, moment: usize, told: &[TrialStep]) -> Result<Vec<f64>, PlantError> {
        let told = &told[..told.len().min(self.steps - self.at(moment).min(self.steps))];
        let inputs = self.inputs(told);
        self.taken += told.len() as u64;
        match self.go(moment, true).and_then(|()| self.plant.advance(told.len(), &inputs)) {
            // The process that held the states is gone, and all of them with it.
            Err(error) if error.lost => {
                self.all.iter_mut().for_each(|(_, saved)| *saved = None);
                self.go(moment, false)?;
                self.plant.advance(told.len(), &inputs)
            }
            outcome => outcome,
        }
    }

    /// Brings the FMU to a moment. Steps that are taken again on the way there do not count: with saved states there are none.
    fn go(&mut self, moment: usize, restores: bool) -> Result<(), PlantError> {
        let Some((at, saved)) = self.all.get(moment) else { return Ok(()) };
        if let Some(saved) = saved.as_ref().filter(|saved| restores && self.plant.holds(saved)) {
            return self.plant.restore(saved);
        }
        let waiting = self.inputs(&vec![self.nobody.clone(); *at]);
        let at = *at;
        self.plant.restart()?;
        // What was saved before belongs to the run that this ended.
        self.all.iter_mut().for_each(|(_, saved)| *saved = None);
        if at > 0 {
            self.plant.advance(at, &waiting)?;
        }
        Ok(())
    }

    /// Sensors have reported for long what they report of nobody.
    fn inputs(&self, told: &[TrialStep]) -> Vec<f64> {
        let (cell, binding) = (self.cell, self.binding);
        let settled = |(sensor, raw): (&crate::cell::Sensor, &bool)| {
            DelayLine::steady(*raw, sensor.delay_steps).latching(sensor.latched, *raw)
        };
        let mut lines: Vec<DelayLine> = cell.sensors.iter().zip(&self.nobody.readings).map(settled).collect();
        let mut inputs = Vec::new();
        for TrialStep { readings, person, pressed } in told {
            let own = cell.sensors.iter().zip(&mut lines).zip(readings);
            let late: Vec<bool> = own.map(|((sensor, line), raw)| line.push(*raw, sensor.delay_steps)).collect();
            input_row(cell, binding, &late, &sensor_target(cell, *person), *pressed, &mut inputs);
        }
        inputs
    }
}
