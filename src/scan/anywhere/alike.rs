//! What a search from anywhere takes for granted of an FMU, tried out: that its robots do the same with all people of whom the
//! same is reported, where it is told where they are; and which sensors each robot heeds.
//!
//! Runs with random readings are made twice: with other people of whom the same is reported, or with one sensor that reports
//! something else. What comes out the same to the last bit in all of them is taken to be so.

use crate::cell::{Binding, Workcell};
use crate::host::{Plant, PlantError};
use crate::human::Presses;
use crate::search::Rng;
use crate::sim::anywhere::told::{Stance, seen};
use crate::sim::robot::moves_alike;
use crate::sim::sensors::{DelayLine, input_row};

/// Runs with other people.
const OTHER_PEOPLE: u32 = 48;
/// Runs with other readings of each sensor.
const OTHER_READINGS: u32 = 32;
/// Readings last for so many steps on average, in one run and another.
const LASTING: [usize; 4] = [3, 10, 30, 80];

/// Something that may be reported of somebody, and people of whom it is.
pub(super) struct Kind {
    pub readings: Vec<bool>,
    pub people: Vec<Stance>,
}

/// An FMU that is tried out.
pub(super) struct Trial<'a, P: Plant> {
    pub plant: P,
    pub cell: &'a Workcell,
    pub binding: &'a Binding,
    /// The first is that of the very start.
    pub kinds: &'a [Kind],
    pub steps: usize,
    pub rng: Rng,
    /// Whether controls are worked at random as well.
    pub presses: bool,
    /// Steps that were taken.
    pub taken: u64,
}

impl<P: Plant> Trial<'_, P> {
    /// Whether the outputs are the same with all people of whom the same is reported, as far as was tried.
    pub fn are_people_alike(&mut self) -> Result<bool, PlantError> {
        for run in 0..OTHER_PEOPLE {
            let readings = self.random(run);
            let first = |kind: &usize| self.kinds[*kind].people.first().copied().unwrap_or_default();
            let same: Vec<Stance> = readings.iter().map(first).collect();
            let all: Vec<&[Stance]> = readings.iter().map(|kind| self.kinds[*kind].people.as_slice()).collect();
            // Somebody else at each step, or for as long as the readings last.
            let mut others: Vec<Stance> = Vec::new();
            for (step, people) in all.iter().enumerate() {
                let stays = run % 2 == 0 && step > 0 && readings[step] == readings[step - 1];
                let other = if stays { others[step - 1] } else { people[self.rng.below(people.len().max(1))] };
                others.push(other);
            }
            let pressed = self.pressed(run);
            let (a, b) = (self.run(&readings, &same, &pressed)?, self.run(&readings, &others, &pressed)?);
            if a.iter().zip(&b).any(|(a, b)| a.to_bits() != b.to_bits()) {
                return Ok(false);
            }
        }
        Ok(true)
    }

    /// Of each robot the sensors that it heeds: those that made a difference to it in any run.
    pub fn heeded(&mut self) -> Result<Vec<Vec<bool>>, PlantError> {
        let sensors = self.cell.sensors.len();
        let mut heeded = vec![vec![false; sensors]; self.cell.robots.len()];
        for sensor in 0..sensors {
            let mut is_tried = false;
            for run in 0..OTHER_READINGS {
                let (one, flips) = (self.random(run), self.random(run / 4));
                let other: Vec<usize> = one
                    .iter()
                    .zip(&flips)
                    .map(|(kind, flip)| {
                        let mut wanted = self.kinds[*kind].readings.clone();
                        wanted[sensor] = self.kinds[*flip].readings[sensor];
                        self.kinds.iter().position(|kind| kind.readings == wanted).unwrap_or(*kind)
                    })
                    .collect();
                if one == other {
                    continue;
                }
                is_tried = true;
                let people = |kinds: &[usize]| -> Vec<Stance> {
                    kinds.iter().map(|kind| self.kinds[*kind].people.first().copied().unwrap_or_default()).collect()
                };
                let (of_one, of_other) = (people(&one), people(&other));
                let pressed = self.pressed(run);
                let (a, b) = (self.run(&one, &of_one, &pressed)?, self.run(&other, &of_other, &pressed)?);
                let (a, b) = (self.rows(&a), self.rows(&b));
                for (robot, heeds) in heeded.iter_mut().enumerate() {
                    let (of, bound) = (&self.cell.robots[robot], &self.binding.robots[robot]);
                    let width = self.binding.columns();
                    heeds[sensor] |= a.chunks(width).zip(b.chunks(width)).any(|(a, b)| !moves_alike(of, bound, a, b));
                }
            }
            // What never changes alone was not told apart.
            heeded.iter_mut().for_each(|heeds| heeds[sensor] |= !is_tried);
        }
        Ok(heeded)
    }

    /// Readings at random, each for a while.
    fn random(&mut self, run: u32) -> Vec<usize> {
        let lasting = LASTING[run as usize % LASTING.len()];
        let mut kinds = vec![0; self.steps];
        for step in 1..self.steps {
            let changes = self.rng.below(lasting) == 0;
            kinds[step] = if changes { self.rng.below(self.kinds.len()) } else { kinds[step - 1] };
        }
        kinds
    }

    /// Which controls are on at each step, at random, each for a while.
    fn pressed(&mut self, run: u32) -> Vec<Presses> {
        let lasting = LASTING[run as usize % LASTING.len()];
        let mut pressed = vec![Presses::NONE; self.steps];
        if self.presses {
            for step in 1..self.steps {
                let some = Presses::all(self.cell.controls.len()).nth(self.rng.below(1 << self.cell.controls.len()));
                let changes = self.rng.below(lasting) == 0;
                pressed[step] = some.filter(|_| changes).unwrap_or(pressed[step - 1]);
            }
        }
        pressed
    }

    /// The outputs after each step.
    fn run(&mut self, readings: &[usize], people: &[Stance], pressed: &[Presses]) -> Result<Vec<f64>, PlantError> {
        let (cell, binding) = (self.cell, self.binding);
        let first = self.kinds.first().map_or(&[][..], |kind| kind.readings.as_slice());
        let mut lines: Vec<DelayLine> =
            cell.sensors.iter().zip(first).map(|(sensor, raw)| DelayLine::settled(*raw, sensor.delay_steps)).collect();
        let mut inputs = Vec::new();
        for ((kind, person), on) in readings.iter().zip(people).zip(pressed) {
            let own = cell.sensors.iter().zip(&mut lines).zip(&self.kinds[*kind].readings);
            let told: Vec<bool> = own.map(|((sensor, line), raw)| line.push(*raw, sensor.delay_steps)).collect();
            input_row(cell, binding, &told, &seen(cell, *person), *on, &mut inputs);
        }
        self.plant.restart()?;
        self.taken += readings.len() as u64;
        self.plant.advance(readings.len(), &inputs)
    }

    fn rows(&self, outputs: &[f64]) -> Vec<f64> {
        self.binding.rows(outputs, None, self.cell.step_s).into_owned()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::cell::binding::{BoundUnit, bind};
    use crate::cell::find::open;

    /// Robots that stand still, whatever is reported.
    struct Still {
        inputs: usize,
        outputs: usize,
    }

    impl Plant for Still {
        type Checkpoint = ();

        fn input_count(&self) -> usize {
            self.inputs
        }

        fn output_count(&self) -> usize {
            self.outputs
        }

        fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
            Ok(vec![0.0; self.outputs])
        }

        fn advance(&mut self, steps: usize, _: &[f64]) -> Result<Vec<f64>, PlantError> {
            Ok(vec![0.0; steps * self.outputs])
        }

        fn save(&mut self) -> Result<(), PlantError> {
            Ok(())
        }

        fn restore(&mut self, (): &()) -> Result<(), PlantError> {
            Ok(())
        }
    }

    /// Two robots that do the same whatever two sensors report heed none of them, as far as each was tried without the other. Where it was
    /// not, they may heed it.
    #[test]
    fn a_sensor_that_never_changes_alone_counts_as_heeded() {
        let dir = tempfile::tempdir().unwrap();
        crate::examples::by_name("two-scanners").unwrap().export(dir.path()).unwrap();
        let opened = open(&dir.path().join("two-scanners/cell.toml"), None).unwrap();
        let units = BoundUnit::all(opened.fmus.iter().map(|(name, fmu)| (name, fmu)));
        let binding = bind(opened.cell.file(), &opened.source, &units, None).unwrap();
        let heeded = |reported: &[[bool; 2]]| {
            let kind = |readings: &[bool; 2]| Kind { readings: readings.to_vec(), people: vec![Stance::default()] };
            let kinds: Vec<Kind> = reported.iter().map(kind).collect();
            let mut trial = Trial {
                plant: Still { inputs: binding.inputs.len(), outputs: binding.outputs.len() },
                cell: &opened.cell,
                binding: &binding,
                kinds: &kinds,
                steps: 40,
                rng: Rng::new(1),
                presses: false,
                taken: 0,
            };
            trial.heeded().unwrap()
        };
        let [neither, one, other, both] = [[false, false], [true, false], [false, true], [true, true]];
        assert_eq!(heeded(&[neither, one, other, both]), [[false, false]; 2]);
        // Together only; the first alone.
        assert_eq!(heeded(&[neither, both]), [[true, true]; 2]);
        assert_eq!(heeded(&[neither, one]), [[false, true]; 2]);
    }
}
