//! What inputs do to the robots, found out by running the FMU: which slow them, after how long, and with which polarity.
//!
//! A run with all inputs idle is compared with runs in which one input changes, or all that sensors drive, at several moments
//! while the robots move. The person plays a part for sensors inside the FMU only (`probe/places.rs`).

mod others;
mod places;
mod plausible;

use std::cell::RefCell;
use std::sync::Arc;

use schemars::JsonSchema;
use serde::Serialize;

use super::hosting::StateChoice;
use super::prepare::Prepared;
use super::stop_time;
use crate::cell::sensor::Signal;
use crate::host::{Plant, PlantError};
use crate::human::action::ACTION_S;
use crate::sim::World;
use crate::sim::motion::{Comparison, Motion};
use crate::sim::robot::RobotFrame;

pub(crate) use places::Reported;

/// How long an FMU is run to see what it does, unless its stopTime is before, s.
pub(crate) const RUN_S: f64 = 10.0;

/// A robot slower than this stands still: m/s, or the unit of what is measured per second.
const STILL: f64 = 1e-3;

/// So many inputs that no sensor drives are tried before a scan.
const MOST_OTHERS: usize = 8;

/// What the robots do after an input has changed.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Effect {
    /// They come to rest.
    Stops,
    /// They go on, more slowly.
    Slows,
    /// They stood still and begin to move.
    Starts,
    /// They become faster.
    SpeedsUp,
    /// Something changes, not how fast they are.
    Changes,
    /// Every output is the same to the last bit.
    Nothing,
}

/// What an input does.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Reaction {
    /// The input, or the sensor that drives it.
    pub input: String,
    /// Its value in the run to compare with.
    pub idle: bool,
    /// What the other value does.
    pub effect: Effect,
    /// Time from the change of the input to the first change of any output, s.
    pub first_change_s: Option<f64>,
    /// Time from the change of the input until the robots stand still, s.
    pub still_after_s: Option<f64>,
    /// Mean speed in the second half of the time after the change: idle, then changed.
    pub mean_speed: [f64; 2],
    /// Time from the beginning of the run to the change of the input, s.
    pub at_s: f64,
    /// What the same change does at other moments, where that was tried.
    pub at_other_moments: Vec<Moment>,
}

/// What an input does at another moment.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, JsonSchema)]
pub struct Moment {
    /// Time from the beginning of the run to the change of the input, s.
    pub at_s: f64,
    /// What it does then.
    pub effect: Effect,
    /// Time from the change until the robots stand still, s.
    pub still_after_s: Option<f64>,
}

impl Reaction {
    /// The value that means that a person is detected, if the robots' reaction tells.
    #[must_use]
    pub(crate) const fn active(&self) -> Option<bool> {
        match self.effect {
            Effect::Stops | Effect::Slows => Some(!self.idle),
            Effect::Starts | Effect::SpeedsUp => Some(self.idle),
            Effect::Changes | Effect::Nothing => None,
        }
    }
}

/// A run of the FMU, and how fast the robots were after each step.
pub(crate) struct ProbeRun {
    /// Outputs at the start and after each step, row-major.
    pub rows: Vec<f64>,
    /// Speed after each step.
    pub speeds: Vec<f64>,
}

impl ProbeRun {
    /// The fastest that anything was.
    #[must_use]
    pub(crate) fn fastest(&self) -> f64 {
        self.speeds.iter().copied().fold(0.0, f64::max)
    }

    /// Whether anything moved.
    #[must_use]
    pub(crate) fn moves(&self) -> bool {
        self.fastest() > STILL
    }
}

/// Whether the robots moved for most of the time and then came to rest: a programme at its end, not a stop at the beginning.
fn ended(run: &ProbeRun) -> bool {
    let moving = run.speeds.iter().filter(|speed| **speed > STILL).count();
    moving * 2 > run.speeds.len()
}

/// Runs a plant with constant inputs, which may change once.
pub(crate) struct Prober<'a, P: Plant> {
    /// A plant that is initialised with these inputs.
    plant: &'a dyn Fn(&[f64]) -> P,
    step_s: f64,
    run_s: f64,
    /// How fast the robots are after each step, from the outputs at the start and after each step.
    speeds: &'a dyn Fn(&[f64]) -> Vec<f64>,
}

impl<'a, P: Plant> Prober<'a, P> {
    /// A prober of what `plant` gives for the inputs that it is initialised with, with steps of `step_s` seconds, for runs of `run_s`.
    pub(crate) const fn new(
        plant: &'a dyn Fn(&[f64]) -> P,
        step_s: f64,
        run_s: f64,
        speeds: &'a dyn Fn(&[f64]) -> Vec<f64>,
    ) -> Self {
        Self { plant, step_s, run_s, speeds }
    }

    /// How long a run really is, s: so many steps at least that something can be told, and no more than can be kept.
    #[must_use]
    pub(crate) fn run_s(&self) -> f64 {
        #[expect(clippy::cast_precision_loss, reason = "limited")]
        let steps = self.steps() as f64;
        steps * self.step_s
    }

    /// Steps of a run.
    fn steps(&self) -> usize {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "limited")]
        let steps = (self.run_s / self.step_s).round().clamp(10.0, 50_000.0) as usize;
        steps
    }

    /// Runs with `inputs`, and with `changed` from step `at` on.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(crate) fn run(&self, inputs: &[f64], change: Option<(usize, &[f64])>) -> Result<ProbeRun, PlantError> {
        let steps = self.steps();
        let mut plant = (self.plant)(inputs);
        let mut rows = plant.restart()?;
        let (at, changed) = change.unwrap_or((steps, inputs));
        rows.extend(plant.advance(at, &inputs.repeat(at))?);
        if at < steps {
            rows.extend(plant.advance(steps - at, &changed.repeat(steps - at))?);
        }
        let speeds = (self.speeds)(&rows);
        Ok(ProbeRun { rows, speeds })
    }

    /// The step at which the robots are fastest in the first half of a run, so that the time to standstill is a long one,
    /// and early enough to see what follows; then the fastest of each of four parts of that half, where they move.
    fn moments(&self, idle: &ProbeRun) -> (usize, Vec<usize>) {
        let half = &idle.speeds[..self.steps() / 2];
        let fastest = |from: usize, to: usize| {
            let steps = half[from..to].iter().enumerate();
            steps.max_by(|a, b| a.1.total_cmp(b.1)).map_or(1, |(step, _)| (from + step).max(1))
        };
        let part = half.len() / 4;
        let parts = (0..4).map(|n| fastest(n * part, (n + 1) * part)).filter(|step| half[*step] > STILL);
        (fastest(0, half.len()), parts.collect())
    }

    /// What another value of an input does, given by its column, while the robots move as in `idle`, the run with `inputs`.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(crate) fn reaction(
        &self,
        name: &str,
        inputs: &[f64],
        other: (usize, f64),
        idle: &ProbeRun,
    ) -> Result<Reaction, PlantError> {
        self.reaction_at(name, inputs, &[other], idle, self.moments(idle).0)
    }

    /// The same for several inputs at once, at several moments.
    ///
    /// # Errors
    /// When the FMU fails.
    pub(crate) fn reactions(
        &self,
        name: &str,
        inputs: &[f64],
        others: &[(usize, f64)],
        idle: &ProbeRun,
    ) -> Result<Reaction, PlantError> {
        let (at, moments) = self.moments(idle);
        let first = self.reaction_at(name, inputs, others, idle, at)?;
        let moments = moments.into_iter().filter(|moment| *moment != at).map(|moment| {
            let Reaction { at_s, effect, still_after_s, .. } = self.reaction_at(name, inputs, others, idle, moment)?;
            Ok(Moment { at_s, effect, still_after_s })
        });
        Ok(Reaction { at_other_moments: moments.collect::<Result<_, PlantError>>()?, ..first })
    }

    fn reaction_at(
        &self,
        name: &str,
        inputs: &[f64],
        others: &[(usize, f64)],
        idle: &ProbeRun,
        at: usize,
    ) -> Result<Reaction, PlantError> {
        let steps = self.steps();
        let mut changed = inputs.to_vec();
        others.iter().for_each(|&(column, value)| changed[column] = value);
        let run = self.run(inputs, Some((at, &changed)))?;
        let width = run.rows.len() / (steps + 1);
        let differs = |step: &usize| {
            let row = |run: &ProbeRun| run.rows[(step + 1) * width..(step + 2) * width].to_vec();
            row(&run).iter().zip(row(idle)).any(|(a, b)| a.to_bits() != b.to_bits())
        };
        let first = (at..steps).find(differs);
        let settled = at + (steps - at) / 2;
        #[expect(clippy::cast_precision_loss, reason = "thousands")]
        let mean = |run: &ProbeRun| run.speeds[settled..].iter().sum::<f64>() / (steps - settled) as f64;
        let mut means = [mean(idle), mean(&run)];
        // A stop may be kept until somebody resets it: then only a run that begins with the other value tells.
        let kept = means.iter().all(|mean| *mean <= STILL) && !ended(idle);
        let begun = if kept { mean(&self.run(&changed, None)?) } else { 0.0 };
        means[1] = means[1].max(begun);
        let still = run.speeds[settled..].iter().all(|speed| *speed <= STILL);
        let moved = run.speeds.iter().rposition(|speed| *speed > STILL).unwrap_or(at);
        #[expect(clippy::cast_precision_loss, reason = "thousands")]
        let seconds = |steps: usize| steps as f64 * self.step_s;
        let after = |step: usize| seconds(step + 1 - at);
        let peak = |run: &ProbeRun| run.speeds[at..].iter().copied().fold(0.0, f64::max);
        // By the means: robots may take a moment to come to rest, or to begin, in either run.
        let effect = match (first, means[0] > STILL, means[1] > STILL) {
            (None, ..) if begun <= STILL => Effect::Nothing,
            (_, true, _) if still => Effect::Stops,
            (_, true, _) if means[1] < 0.8 * means[0] => Effect::Slows,
            // A programme that has come to its end says nothing: slowed down, it would still be on its way.
            (_, false, true) if !ended(idle) => Effect::Starts,
            (_, true, _) if means[1] > 1.25 * means[0] && peak(&run) > 1.25 * peak(idle) => Effect::SpeedsUp,
            _ => Effect::Changes,
        };
        Ok(Reaction {
            input: name.to_owned(),
            idle: others.iter().any(|&(column, _)| inputs[column] != 0.0),
            effect,
            first_change_s: first.map(after),
            still_after_s: (effect == Effect::Stops).then(|| after((moved + 1).max(at))),
            mean_speed: means,
            at_s: seconds(at),
            at_other_moments: Vec::new(),
        })
    }
}

/// What was found out about a cell.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Probe {
    /// Fastest point of any robot while nobody is detected, m/s.
    pub fastest_m_s: f64,
    /// What each sensor does that the cell drives.
    pub reactions: Vec<Reaction>,
    /// What each other input does that is true or false, and that no sensor drives; where it was asked for.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub others: Vec<Reaction>,
    /// Inputs that were not tried, because they are neither true nor false.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub not_tried: Vec<String>,
    /// What all of them together do, if there are several.
    pub together: Option<Reaction>,
    /// What sensors inside the FMU report.
    pub reported: Vec<Reported>,
    /// What seems to be wrong.
    pub warnings: Vec<String>,
    /// Sensors that change nothing.
    pub idle_sensors: Vec<String>,
    /// Outputs of the run with nobody detected: at the start and after each step.
    #[serde(skip)]
    pub rows: Vec<f64>,
    /// How long each run was, s.
    pub run_s: f64,
    /// What was seen of the robots' motion in all runs.
    #[serde(skip)]
    pub motion: Motion,
}

/// What is odd about sensors, tried for as long as a sequence takes and at one moment each: for a scan, which must not wait
/// for long. An FMU that fails in it is left for the search to tell.
#[must_use]
pub(crate) fn wrong_polarities(prepared: &Prepared) -> Vec<String> {
    let horizon_s = f64::from(prepared.cell.search.actions) * ACTION_S;
    probed(prepared, horizon_s, Depth::Sensors).map_or_else(|_| Vec::new(), |found| found.warnings)
}

/// How long [`probe`] runs the FMU of a cell, s: [`RUN_S`], or as far as its stopTime, but as long as its sequences.
#[must_use]
pub(crate) fn run_s(prepared: &Prepared) -> f64 {
    stop_time::run_s(&prepared.cell, &prepared.fmus, RUN_S)
}

/// Runs the FMU of a cell for some seconds, see [`run_s`], with nobody detected, then with each sensor and all of them reporting a person
/// at several moments, then with a person at many places for sensors inside the FMU.
///
/// # Errors
/// When the FMU fails.
pub fn probe(prepared: &Prepared) -> Result<Probe, PlantError> {
    probed(prepared, run_s(prepared), Depth::Moments)
}

/// The same in runs so long, s.
///
/// # Errors
/// When the FMU fails.
pub(crate) fn probe_for(prepared: &Prepared, run_s: f64) -> Result<Probe, PlantError> {
    probed(prepared, run_s, Depth::Moments)
}

/// What [`probe`] does, and what each other input does.
///
/// # Errors
/// When the FMU fails.
pub(crate) fn probe_inputs(prepared: &Prepared) -> Result<Probe, PlantError> {
    probed(prepared, run_s(prepared), Depth::Inputs)
}

/// How much is tried.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Depth {
    /// Each sensor at one moment.
    Sensors,
    /// Each sensor at several, all together, and persons at many places.
    Moments,
    /// And what each input does that no sensor drives is told.
    Inputs,
}

fn probed(prepared: &Prepared, run_s: f64, depth: Depth) -> Result<Probe, PlantError> {
    let thoroughly = depth != Depth::Sensors;
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let world = World::new(Arc::clone(cell), Arc::clone(binding));
    let mut inputs = world.initial_inputs();
    let driven = |sensor: usize| binding.sensors[sensor].input();
    for (number, sensor) in cell.sensors.iter().enumerate() {
        if let Some(column) = driven(number) {
            inputs[column] = sensor.signal.value(false);
        }
    }
    let width = binding.outputs.len();
    let comparison = Comparison::new(cell, binding);
    let motion = RefCell::new(Motion::default());
    let speeds = |rows: &[f64]| -> Vec<f64> {
        let (first, rest) = rows.split_at(width);
        let derived = binding.first_rows(rest, Some(first), cell.step_s, comparison.unsettled());
        let frame = |row| Arc::new(RobotFrame::new(cell, binding, row));
        let frames: Vec<Arc<RobotFrame>> = derived.chunks(binding.columns()).map(frame).collect();
        let mut motion = motion.borrow_mut();
        comparison.look(rows, 0, 0, &mut motion);
        motion.look_at_links(&frames, 1);
        frames.iter().map(|frame| frame.fastest).collect()
    };
    let plant = |inputs: &[f64]| prepared.plant_from(StateChoice::Replay, inputs);
    let prober = Prober::new(&plant, cell.step_s, run_s, &speeds);
    let run_s = prober.run_s();
    let idle = prober.run(&inputs, None)?;
    let mut found = Probe {
        fastest_m_s: idle.fastest(),
        reactions: Vec::new(),
        others: Vec::new(),
        not_tried: Vec::new(),
        together: None,
        reported: Vec::new(),
        warnings: [
            places::starts_seen(prepared, &idle.rows),
            places::evaluated(prepared),
            plausible::odd(prepared, &idle.rows, thoroughly),
        ]
        .concat(),
        idle_sensors: Vec::new(),
        rows: idle.rows.clone(),
        run_s,
        motion: Motion::default(),
    };
    let mut tried = Vec::new();
    for (number, sensor) in cell.sensors.iter().enumerate() {
        let is_new = |column: &usize| tried.iter().all(|(tried, _)| tried != column);
        let Some(column) = driven(number).filter(is_new) else { continue };
        let other = (column, sensor.signal.value(true));
        tried.push(other);
        let reaction = match thoroughly {
            true => prober.reactions(&sensor.name, &inputs, &[other], &idle)?,
            false => prober.reaction(&sensor.name, &inputs, other, &idle)?,
        };
        let variable = &binding.inputs[column].port.name;
        if reaction.effect == Effect::Nothing {
            found.idle_sensors.push(format!(
                "sensor `{}` changes nothing: with `{variable}` = {} every output that the cell uses stays the same, in a \
                 run of {run_s} s",
                sensor.name, sensor.signal
            ));
        }
        found.warnings.extend(odd(&reaction, variable, sensor.signal));
        found.reactions.push(reaction);
    }
    if thoroughly {
        if tried.len() > 1 {
            found.together = Some(prober.reactions("all sensors together", &inputs, &tried, &idle)?);
        }
        found.reported = places::reported(prepared, &idle.rows, run_s)?;
        let signal = |name: &str| cell.sensors.iter().find(|sensor| sensor.name == name).map(|sensor| sensor.signal);
        found.warnings.extend(found.reported.iter().filter_map(|one| one.warning(signal(&one.sensor)?)));
    }
    // A scan must not wait for long.
    let most = if thoroughly { usize::MAX } else { MOST_OTHERS };
    let (others, not_tried) = others::tried(prepared, &inputs, (run_s, most), &speeds)?;
    if let Some(error) = others.iter().find_map(|one| one.as_ref().err().filter(|error| error.stopped)) {
        return Err(error.clone());
    }
    found.warnings.extend(others.iter().flatten().filter_map(others::held_back));
    if depth == Depth::Inputs {
        (found.others, found.not_tried) = (others.into_iter().collect::<Result<_, _>>()?, not_tried);
    }
    found.motion = motion.into_inner();
    Ok(found)
}

/// What is odd about a sensor's reaction.
fn odd(reaction: &Reaction, variable: &str, signal: Signal) -> Option<String> {
    let name = &reaction.input;
    let others = &reaction.at_other_moments;
    let faster = |effect: &Effect| matches!(effect, Effect::Starts | Effect::SpeedsUp);
    let mut all = std::iter::once(reaction.effect).chain(others.iter().map(|moment| moment.effect));
    if let Some(effect) = all.find(faster) {
        let (before, after) =
            if effect == Effect::Starts { ("stand still", "move") } else { ("are slower", "are faster") };
        return Some(format!(
            "sensor `{name}`: wrong polarity, or a flaw of the cell. While `{variable}` says that nobody is there the robots \
             {before}, and when it says that somebody is they {after}. Either the cell file has the polarity the other way \
             round (then {}), or the safety controller really lets the robots go while somebody is detected: look at the \
             circuit diagram before you change the file",
            signal.turned()
        ));
    }
    let guards = matches!(reaction.effect, Effect::Stops | Effect::Slows);
    let blind = others.iter().find(|moment| guards && moment.effect == Effect::Nothing)?;
    Some(format!(
        "sensor `{name}` acts on the robots when it begins to report at {:.2} s, and changes nothing at {:.2} s: whoever comes \
         then is not guarded by it",
        reaction.at_s, blind.at_s
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A robot that moves at 1 m/s, until `way` is done or for ever; its input stops it (for ever, if `latched`) or slows it.
    #[derive(Clone)]
    struct Toy {
        way: f64,
        done: f64,
        stops: bool,
        latched: bool,
        stopped: bool,
        demand: f64,
    }

    impl Plant for Toy {
        type Checkpoint = ();

        fn input_count(&self) -> usize {
            1
        }

        fn output_count(&self) -> usize {
            1
        }

        fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
            (self.done, self.stopped) = (0.0, false);
            Ok(vec![0.0])
        }

        fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
            let row = |step: usize| {
                let demanded = inputs[step].to_bits() == self.demand.to_bits();
                self.stopped = demanded && self.stops || self.stopped && self.latched;
                let speed = match () {
                    () if self.stopped || self.done >= self.way => 0.0,
                    () if demanded => 0.25,
                    () => 1.0,
                };
                self.done += 0.02 * speed;
                speed
            };
            Ok((0..steps).map(row).collect())
        }

        fn save(&mut self) -> Result<(), PlantError> {
            Ok(())
        }

        fn restore(&mut self, (): &()) -> Result<(), PlantError> {
            Ok(())
        }
    }

    /// What changing the input from `idle` does.
    fn effect(toy: &Toy, idle: f64) -> Reaction {
        let plant = |_: &[f64]| toy.clone();
        let speeds = |rows: &[f64]| rows[1..].to_vec();
        let prober = Prober::new(&plant, 0.02, RUN_S, &speeds);
        let run = prober.run(&[idle], None).unwrap();
        prober.reaction("input", &[idle], (0, 1.0 - idle), &run).unwrap()
    }

    #[test]
    fn the_robots_tell_the_polarity() {
        let endless = Toy { way: f64::INFINITY, done: 0.0, stops: true, latched: false, stopped: false, demand: 0.0 };
        let stops = effect(&endless, 1.0);
        assert_eq!((stops.effect, stops.active()), (Effect::Stops, Some(false)));
        // It stands from the first step with the other value on.
        assert!((stops.still_after_s.unwrap() - 0.02).abs() < 1e-12, "{stops:?}");
        let slows = effect(&Toy { stops: false, ..endless.clone() }, 1.0);
        assert_eq!((slows.effect, slows.active()), (Effect::Slows, Some(false)));
        // The wrong way round, and also where a stop is kept.
        for latched in [false, true] {
            let starts = effect(&Toy { latched, ..endless.clone() }, 0.0);
            assert_eq!((starts.effect, starts.active()), (Effect::Starts, Some(false)), "latched: {latched}");
        }
        let faster = effect(&Toy { stops: false, ..endless }, 0.0);
        assert_eq!((faster.effect, faster.active()), (Effect::SpeedsUp, Some(false)));
    }

    #[test]
    fn a_programme_that_has_come_to_its_end_tells_no_polarity() {
        // Done after 6 s of 10, slowed down it would be on its way still.
        let ending = Toy { way: 6.0, done: 0.0, stops: false, latched: false, stopped: false, demand: 0.0 };
        let changes = effect(&ending, 1.0);
        assert_eq!((changes.effect, changes.active()), (Effect::Changes, None), "{changes:?}");
    }
}
