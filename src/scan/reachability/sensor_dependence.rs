//! Which sensors each robot heeds: those that made a difference to it in any trial. Each reports by itself at many moments, for one to
//! thirty steps, where nothing was reported before and after another sensor did; and at random, from the start until the end. All robots
//! are looked at in each run.

use super::trials::{Trial, WINDOW};
use crate::host::{Plant, PlantError};
use crate::human::Presses;
use crate::sim::robot::moves_alike;

/// Runs with other readings of each sensor, at random.
const OTHER_READINGS: u32 = 32;
/// For so many steps a sensor reports by itself.
const ALONE: [usize; 4] = [1, 3, 10, 30];
/// So many steps after another sensor a sensor reports as well, and for how many.
const AFTER: [(usize, usize); 2] = [(1, 10), (30, 10)];
/// About so many steps are taken at most for pairs of sensors.
const MOST_STEPS_OF_PAIRS: usize = 60_000;

/// What the outcome rests on.
pub(super) struct SensorDependence {
    /// Of each robot, by sensor, whether it made a difference to it.
    pub by_robot: Vec<Vec<bool>>,
    /// Of each sensor what was tried, in words.
    pub tried: Vec<String>,
}

impl<P: Plant> Trial<'_, P> {
    /// Of each robot the sensors that it heeds.
    pub(crate) fn heeded(&mut self) -> Result<SensorDependence, PlantError> {
        let sensors = self.cell.sensors.len();
        let mut heeded =
            SensorDependence { by_robot: vec![vec![false; sensors]; self.cell.robots.len()], tried: Vec::new() };
        for sensor in 0..sensors {
            let alone = self.alone(sensor, &mut heeded.by_robot)?;
            let after = self.after_others(sensor, &mut heeded.by_robot)?;
            let random = self.at_random(sensor, &mut heeded.by_robot)?;
            // What never changes alone was not told apart.
            if alone + random == 0 {
                heeded.by_robot.iter_mut().for_each(|heeds| heeds[sensor] = true);
            }
            let pairs = if after > 0 { format!(", {after} times after another sensor") } else { String::new() };
            heeded.tried.push(format!(
                "it did the same whatever that reported, by itself {}, for 1 to 30 steps{pairs}, and in {random} runs at random from the \
                 start",
                self.began()
            ));
        }
        Ok(heeded)
    }

    /// What is reported when one sensor reports what it does in one kind, and all others what they do in another; if that is ever so.
    fn with(&self, kind: usize, sensor: usize, reading: bool) -> Option<usize> {
        let mut wanted = self.kinds[kind].readings.clone();
        wanted[sensor] = reading;
        self.kinds.iter().position(|kind| kind.readings == wanted)
    }

    /// The other reading of a sensor in a kind.
    fn flipped(&self, kind: usize, sensor: usize) -> Option<usize> {
        self.with(kind, sensor, !self.kinds[kind].readings[sensor])
    }

    /// Which robots do something else when this is told than with these outputs.
    fn note(&self, sensor: usize, a: &[f64], b: &[f64], heeded: &mut [Vec<bool>]) {
        let rows = |outputs: &[f64]| self.binding.rows(outputs, None, self.cell.step_s).into_owned();
        let (width, a, b) = (self.binding.columns(), rows(a), rows(b));
        for (robot, heeds) in heeded.iter_mut().enumerate() {
            let (of, bound) = (&self.cell.robots[robot], &self.binding.robots[robot]);
            heeds[sensor] |= a.chunks(width).zip(b.chunks(width)).any(|(a, b)| !moves_alike(of, bound, a, b));
        }
    }

    /// A sensor by itself, at each moment; how often that was tried.
    fn alone(&mut self, sensor: usize, heeded: &mut [Vec<bool>]) -> Result<u32, PlantError> {
        let Some(reported) = self.flipped(0, sensor) else { return Ok(0) };
        let mut tried = 0;
        for moment in 0..self.moments.count() {
            for steps in ALONE {
                let mut readings = vec![reported; steps];
                readings.resize(steps + WINDOW, 0);
                let run = self.run(moment, &readings)?;
                let undisturbed = self.moments.undisturbed(moment, readings.len()).to_vec();
                self.note(sensor, &undisturbed, &run, heeded);
                (tried, self.runs) = (tried + 1, self.runs + 1);
            }
        }
        Ok(tried)
    }

    /// A sensor after each other one, which goes on to report; how often that was tried.
    fn after_others(&mut self, sensor: usize, heeded: &mut [Vec<bool>]) -> Result<u32, PlantError> {
        let sensors = self.cell.sensors.len();
        let others: Vec<usize> = (0..sensors).filter(|other| *other != sensor).collect();
        let at_a_moment = others.len() * sensors * (AFTER.len() + 1) * (WINDOW + ALONE[3]);
        let every = self.moments.count().div_ceil((MOST_STEPS_OF_PAIRS / at_a_moment.max(1)).max(4));
        let mut tried = 0;
        for moment in (0..self.moments.count()).step_by(every.max(1)) {
            for other in &others {
                let Some(reported) = self.flipped(0, *other) else { continue };
                let Some(both) = self.flipped(reported, sensor) else { continue };
                let before = vec![reported; WINDOW + ALONE[3]];
                let without = self.run(moment, &before)?;
                for (after, steps) in AFTER {
                    let mut readings = before.clone();
                    readings[after..after + steps].fill(both);
                    let run = self.run(moment, &readings)?;
                    self.note(sensor, &without, &run, heeded);
                    (tried, self.runs) = (tried + 1, self.runs + 1);
                }
            }
        }
        Ok(tried)
    }

    /// A sensor with other readings than in runs at random, from the start; how often that was tried.
    fn at_random(&mut self, sensor: usize, heeded: &mut [Vec<bool>]) -> Result<u32, PlantError> {
        let mut tried = 0;
        for run in 0..OTHER_READINGS {
            let (one, flips) = (self.random(self.steps, run), self.random(self.steps, run / 4));
            let other: Vec<usize> = one
                .iter()
                .zip(&flips)
                .map(|(kind, flip)| self.with(*kind, sensor, self.kinds[*flip].readings[sensor]).unwrap_or(*kind))
                .collect();
            if one == other {
                continue;
            }
            let pressed = self.pressed(self.steps, run);
            let (of_one, of_other) = (self.persons(&one), self.persons(&other));
            let (a, b) = (self.told(&one, &of_one, &pressed), self.told(&other, &of_other, &pressed));
            let (a, b) = (self.moments.run(0, &a)?, self.moments.run(0, &b)?);
            self.note(sensor, &a, &b, heeded);
            (tried, self.runs) = (tried + 1, self.runs + 1);
        }
        Ok(tried)
    }

    /// The outputs after each step, with nothing worked.
    fn run(&mut self, moment: usize, readings: &[usize]) -> Result<Vec<f64>, PlantError> {
        let told = self.told(readings, &self.persons(readings), &vec![Presses::NONE; readings.len()]);
        self.moments.run(moment, &told)
    }
}

#[cfg(test)]
mod tests {
    use super::super::trial_instants::{Moments, TrialStep};
    use super::super::trials::Kind;
    use super::*;
    use crate::cell::binding::{BoundUnit, bind};
    use crate::cell::find::open;
    use crate::reachability::internal_sensors::StandingPose;
    use crate::search::Rng;

    /// How far the robot turns, by what the first two sensors have reported so far.
    type Turns = fn(&[[bool; 2]]) -> f64;

    /// The robot turns by as much as this says of when the first two sensors reported.
    struct Scripted {
        inputs: usize,
        outputs: usize,
        /// Something that the robot is moved by.
        moves: usize,
        /// What the first two inputs are while they do.
        reports: [f64; 2],
        heard: Vec<[bool; 2]>,
        turns: Turns,
    }

    impl Plant for Scripted {
        type Checkpoint = Vec<[bool; 2]>;

        fn input_count(&self) -> usize {
            self.inputs
        }

        fn output_count(&self) -> usize {
            self.outputs
        }

        fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
            self.heard.clear();
            Ok(vec![0.0; self.outputs])
        }

        fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
            let mut outputs = Vec::new();
            for told in inputs.chunks(self.inputs).take(steps) {
                self.heard.push([0, 1].map(|sensor| told[sensor] == self.reports[sensor]));
                let mut row = vec![0.0; self.outputs];
                row[self.moves] = (self.turns)(&self.heard);
                outputs.extend(row);
            }
            Ok(outputs)
        }

        fn save(&mut self) -> Result<Vec<[bool; 2]>, PlantError> {
            Ok(self.heard.clone())
        }

        fn restore(&mut self, saved: &Vec<[bool; 2]>) -> Result<(), PlantError> {
            self.heard.clone_from(saved);
            Ok(())
        }
    }

    /// Of the robot of `two-operators`, if it did this, by sensor whether it heeds it, where these are reported: by random runs alone, and by
    /// all.
    fn heeded(turns: Turns, reported: &[[bool; 3]], saves: bool) -> [Vec<bool>; 2] {
        let dir = tempfile::tempdir().unwrap();
        crate::examples::by_name("two-operators").unwrap().export(dir.path()).unwrap();
        let opened = open(&dir.path().join("two-operators/cell.toml"), None).unwrap();
        let units = BoundUnit::all(opened.fmus.iter().map(|(name, fmu)| (name, fmu)));
        let binding = bind(opened.cell.file(), &opened.source, &units, None).unwrap();
        let kind = |readings: &[bool; 3]| Kind { readings: readings.to_vec(), people: vec![StandingPose::default()] };
        let kinds: Vec<Kind> = reported.iter().map(kind).collect();
        let outputs = binding.outputs.len();
        let moved_by = |output: &usize| {
            let (still, mut moved) = (vec![0.0; outputs], vec![0.0; outputs]);
            moved[*output] = 1.0;
            let rows = [still, moved].map(|row| binding.rows(&row, None, 0.02).into_owned());
            !moves_alike(&opened.cell.robots[0], &binding.robots[0], &rows[0], &rows[1])
        };
        let (inputs, moves) = (binding.inputs.len(), (0..outputs).find(moved_by).unwrap());
        let reports = [0, 1].map(|sensor: usize| opened.cell.sensors[sensor].signal.value(true));
        let plant = || Scripted { inputs, outputs, moves, reports, heard: Vec::new(), turns };
        let nobody = || TrialStep { readings: vec![false; 3], person: StandingPose::default(), pressed: Presses::NONE };
        let trial = || Trial {
            moments: Moments::new(plant(), (&opened.cell, &binding), nobody(), (700, saves), &mut Rng::new(1)).unwrap(),
            cell: &opened.cell,
            binding: &binding,
            kinds: &kinds,
            steps: 700,
            rng: Rng::new(1),
            presses: false,
            runs: 0,
        };
        let mut at_random = vec![vec![false; 3]];
        for sensor in 0..3 {
            trial().at_random(sensor, &mut at_random).unwrap();
        }
        [at_random, trial().heeded().unwrap().by_robot].map(|mut by_robot| by_robot.remove(0))
    }

    const NOBODY: [bool; 3] = [false, false, false];
    const A: [bool; 3] = [true, false, false];
    const B: [bool; 3] = [false, true, false];
    const BOTH: [bool; 3] = [true, true, false];
    const C: [bool; 3] = [false, false, true];

    /// A robot that does the same whatever sensors report heeds none of them, as far as each was tried without the others. Where one was
    /// not, it may heed it.
    #[test]
    fn a_sensor_that_never_changes_alone_counts_as_heeded() {
        let all = |reported: &[[bool; 3]]| heeded(|_| 0.0, reported, true)[1].clone();
        assert_eq!(all(&[NOBODY, A, B, C]), [false, false, false]);
        // Together only; the first alone.
        assert_eq!(all(&[NOBODY, BOTH, C]), [true, true, false]);
        assert_eq!(all(&[NOBODY, A]), [false, true, true]);
    }

    /// The first report decides, and counts late or for some time only: random runs report long before. With saved states and without.
    #[test]
    fn a_sensor_that_is_heeded_late_is_heeded() {
        fn first(heard: &[[bool; 2]], from: usize, to: usize) -> f64 {
            let first = heard.iter().position(|now| now[1]);
            first.filter(|first| (from..to).contains(first)).map_or(0.0, |_| 1.0)
        }
        let each: [Turns; 2] = [|heard| first(heard, 630, 700), |heard| first(heard, 320, 380)];
        for saves in [true, false] {
            for (number, turns) in each.into_iter().enumerate() {
                let [at_random, all] = heeded(turns, &[NOBODY, A, B, BOTH, C], saves);
                // By chance they may begin just then.
                assert!(number == 1 || at_random == [false; 3], "{saves}: it is found without moments, too");
                assert_eq!(all, [false, true, false], "{saves} {number}");
            }
        }
    }

    /// Only a report of 20 steps counts, only one of a single step, or only one after another sensor has called the robot.
    #[test]
    fn a_sensor_that_is_heeded_for_long_or_at_once_is_heeded() {
        let long =
            |heard: &[[bool; 2]]| f64::from(u8::from(heard.windows(20).any(|part| part.iter().all(|now| now[1]))));
        let short = |heard: &[[bool; 2]]| {
            f64::from(u8::from(heard.windows(3).any(|part| !part[0][1] && part[1][1] && !part[2][1])))
        };
        for turns in [long, short] {
            assert_eq!(heeded(turns, &[NOBODY, A, B, C], true)[1], [false, true, false]);
        }
        // A calls the robot after 12 s, and B sends it back: by itself B does nothing.
        let called = |heard: &[[bool; 2]]| {
            let from = heard.iter().position(|now| now[0]).filter(|first| *first >= 600);
            from.map_or(0.0, |from| f64::from(u8::from(!heard[from..].iter().any(|now| now[1]))))
        };
        let [at_random, all] = heeded(called, &[NOBODY, A, B, BOTH, C], true);
        assert_eq!((at_random, all), (vec![false; 3], vec![true, true, false]));
    }
}
