//! The seam between a search and whatever runs the FMU: one action, one message.
//!
//! The human's motion during an action does not depend on the robot, so the whole trace of inputs is known before the
//! action starts. [`Plant::advance`] takes it and gives back the trace of outputs.

use std::borrow::Cow;
use std::fmt;

use fmu_self_test::Said;
use serde::{Deserialize, Serialize};

use crate::stop::Stop;

/// A running workcell model, in this process or elsewhere.
///
/// Traces are row-major: one row per communication step, one column per bound variable (Booleans as 0 and 1).
pub trait Plant {
    /// A saved state.
    type Checkpoint;

    /// Number of bound inputs.
    fn input_count(&self) -> usize;

    /// Number of bound outputs.
    fn output_count(&self) -> usize;

    /// Begins again at time zero with a fresh instance; returns the outputs at that time.
    ///
    /// # Errors
    /// When the FMU cannot be instantiated or initialised.
    fn restart(&mut self) -> Result<Vec<f64>, PlantError>;

    /// Takes `inputs.len() / input_count()` communication steps (`steps` of them) and returns the outputs after each.
    ///
    /// # Errors
    /// When the FMU refuses a step or an output is not finite. The plant must then be restarted or restored.
    fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError>;

    /// [`advance`](Self::advance) with the outputs after some of the steps only.
    ///
    /// # Errors
    /// The same.
    fn advance_reading(&mut self, steps: usize, inputs: &[f64], reads: Reads) -> Result<Vec<f64>, PlantError> {
        let all = self.advance(steps, inputs)?;
        Ok(match reads {
            Reads::Each => all,
            Reads::Last => all[all.len().saturating_sub(self.output_count())..].to_vec(),
        })
    }

    /// [`advance`](Self::advance), and something of the state that it leads to: one message where the plant lives
    /// elsewhere. An error in what it gives is that of the stocktaking, after steps that went well.
    ///
    /// # Errors
    /// When the steps fail.
    fn advance_and(
        &mut self,
        steps: usize,
        inputs: &[f64],
        then: Then,
    ) -> Result<Stepped<Self::Checkpoint>, PlantError> {
        let outputs = self.advance(steps, inputs)?;
        let taken = match then {
            Then::Nothing => Ok(StateCopy::Nothing),
            Then::Fingerprint => self.fingerprint().map(StateCopy::Fingerprint),
            Then::Save => self.save().map(StateCopy::Saved),
        };
        Ok((outputs, taken))
    }

    /// Goes on from saved states, or from where other legs ended: one message for all of them where the plant lives elsewhere.
    ///
    /// # Errors
    /// When some steps fail, or the FMU fails otherwise.
    fn advance_each(
        &mut self,
        legs: &[Leg<'_, Self::Checkpoint>],
    ) -> Result<Vec<Arrived<Self::Checkpoint>>, PlantError> {
        let mut all = Vec::with_capacity(legs.len());
        one_by_one(self, legs, &mut all)?;
        Ok(all)
    }

    /// Saves the present state.
    ///
    /// # Errors
    /// When the FMU does not offer it or fails.
    fn save(&mut self) -> Result<Self::Checkpoint, PlantError>;

    /// What tells the present state from others, if the FMU offers serialised states.
    ///
    /// # Errors
    /// When the FMU fails.
    fn fingerprint(&mut self) -> Result<Option<Fingerprint>, PlantError> {
        Ok(None)
    }

    /// Comes back to a state saved from this plant since its last restart.
    ///
    /// # Errors
    /// When the FMU fails.
    fn restore(&mut self, checkpoint: &Self::Checkpoint) -> Result<(), PlantError>;

    /// [`restore`](Self::restore), just before steps are asked for: where the plant lives elsewhere, one message for both.
    /// That it failed may be told only then, see [`PlantError::restoring`]; it is then not put off again.
    ///
    /// # Errors
    /// When the FMU fails.
    fn restore_soon(&mut self, checkpoint: &Self::Checkpoint) -> Result<(), PlantError> {
        self.restore(checkpoint)
    }

    /// Whether a saved state can still be restored; some are lost with the process that held them.
    fn holds(&self, _checkpoint: &Self::Checkpoint) -> bool {
        true
    }

    /// When work with it has to end.
    fn stop(&self) -> Stop {
        Stop::default()
    }
}

/// Steps from a saved state, after which the state is saved.
#[derive(Debug)]
pub struct Leg<'a, C> {
    /// Where it begins.
    pub from: LegStart<'a, C>,
    /// How many.
    pub steps: usize,
    /// What the FMU is told, row-major: the last row for the rest of the steps, too.
    pub inputs: Vec<f64>,
    /// After which steps outputs are read.
    pub reads: Reads,
}

/// Rows of so many columns for so many steps, of which the last goes on where there are fewer.
#[must_use]
pub fn for_all_steps(inputs: &[f64], columns: usize, steps: usize) -> Cow<'_, [f64]> {
    let missing = (steps * columns).saturating_sub(inputs.len());
    if missing == 0 {
        return Cow::Borrowed(inputs);
    }
    let last = &inputs[inputs.len().saturating_sub(columns)..];
    let rest = last.iter().copied().cycle().take(missing);
    Cow::Owned(inputs.iter().copied().chain(rest).collect())
}

/// After which steps outputs are read.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Reads {
    /// After each.
    Each,
    /// After the last.
    Last,
}

impl Reads {
    /// How many rows of outputs so many steps have.
    #[must_use]
    pub(crate) const fn rows(self, steps: usize) -> usize {
        match self {
            Self::Each => steps,
            Self::Last if steps == 0 => 0,
            Self::Last => 1,
        }
    }
}

/// Where a leg begins.
#[derive(Debug)]
pub enum LegStart<'a, C> {
    /// At a saved state.
    At(&'a C),
    /// Where an earlier leg of the same message ended, by its number.
    After(usize),
}

/// Outputs after the steps that are read, row-major, and the state after the last.
pub type Arrived<C> = (Vec<f64>, C);

/// Takes legs with a message each, or more.
pub(super) fn one_by_one<P: Plant + ?Sized>(
    plant: &mut P,
    legs: &[Leg<'_, P::Checkpoint>],
    all: &mut Vec<Arrived<P::Checkpoint>>,
) -> Result<(), PlantError> {
    for leg in legs {
        match leg.from {
            LegStart::At(saved) => plant.restore_soon(saved)?,
            LegStart::After(number) => plant.restore_soon(&all[number].1)?,
        }
        let inputs = for_all_steps(&leg.inputs, plant.input_count(), leg.steps);
        let (mut outputs, taken) = plant.advance_and(leg.steps, &inputs, Then::Save)?;
        let rows = leg.reads.rows(leg.steps) * plant.output_count();
        outputs.drain(..outputs.len().saturating_sub(rows));
        let StateCopy::Saved(saved) = taken? else { return Err(PlantError::of("this plant keeps no states")) };
        all.push((outputs, saved));
    }
    Ok(())
}

/// What is wanted of a state right after it was reached.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Then {
    /// Nothing.
    Nothing,
    /// [`Plant::fingerprint`].
    Fingerprint,
    /// [`Plant::save`].
    Save,
}

/// Outputs after each step, row-major, and what was taken of the state after the last.
pub(crate) type Stepped<C> = (Vec<f64>, Result<StateCopy<C>, PlantError>);

/// What was taken of a state right after it was reached.
#[derive(Debug)]
pub enum StateCopy<C> {
    /// Nothing.
    Nothing,
    /// See [`Plant::fingerprint`].
    Fingerprint(Option<Fingerprint>),
    /// See [`Plant::save`].
    Saved(C),
}

impl<C> StateCopy<C> {
    /// The same with another kind of saved state.
    pub(super) fn map<D>(self, into: impl FnOnce(C) -> D) -> StateCopy<D> {
        match self {
            Self::Nothing => StateCopy::Nothing,
            Self::Fingerprint(print) => StateCopy::Fingerprint(print),
            Self::Saved(checkpoint) => StateCopy::Saved(into(checkpoint)),
        }
    }
}

/// A plant that is lent.
impl<P: Plant> Plant for &mut P {
    type Checkpoint = P::Checkpoint;

    fn input_count(&self) -> usize {
        (**self).input_count()
    }

    fn output_count(&self) -> usize {
        (**self).output_count()
    }

    fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
        (**self).restart()
    }

    fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
        (**self).advance(steps, inputs)
    }

    fn advance_and(&mut self, steps: usize, inputs: &[f64], then: Then) -> Result<Stepped<P::Checkpoint>, PlantError> {
        (**self).advance_and(steps, inputs, then)
    }

    fn advance_reading(&mut self, steps: usize, inputs: &[f64], reads: Reads) -> Result<Vec<f64>, PlantError> {
        (**self).advance_reading(steps, inputs, reads)
    }

    fn advance_each(&mut self, legs: &[Leg<'_, P::Checkpoint>]) -> Result<Vec<Arrived<P::Checkpoint>>, PlantError> {
        (**self).advance_each(legs)
    }

    fn save(&mut self) -> Result<P::Checkpoint, PlantError> {
        (**self).save()
    }

    fn fingerprint(&mut self) -> Result<Option<Fingerprint>, PlantError> {
        (**self).fingerprint()
    }

    fn restore(&mut self, checkpoint: &P::Checkpoint) -> Result<(), PlantError> {
        (**self).restore(checkpoint)
    }

    fn restore_soon(&mut self, checkpoint: &P::Checkpoint) -> Result<(), PlantError> {
        (**self).restore_soon(checkpoint)
    }

    fn holds(&self, checkpoint: &P::Checkpoint) -> bool {
        (**self).holds(checkpoint)
    }

    fn stop(&self) -> Stop {
        (**self).stop()
    }
}

/// The serialised state of a plant, in short.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub struct Fingerprint {
    /// SHA-256 of its bytes.
    pub digest: [u8; 32],
    /// How many bytes it has.
    pub bytes: usize,
}

/// What went wrong in a plant.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize)]
pub struct PlantError {
    /// What happened, in words, with the FMU's own last log lines.
    pub message: String,
    /// The last lines that the FMU printed before, if any. They are for people: how many there are depends on what its process
    /// did before, and they are part of no result.
    pub printed: Vec<String>,
    /// Simulation time, s, when known.
    pub time_s: Option<f64>,
    /// The FMU must not be called any more: the search has to end.
    pub fatal: bool,
    /// The process in which the FMU ran is gone, and all its states. The next call meets a fresh one. This need not be
    /// the FMU's doing.
    pub lost: bool,
    /// With `lost`: this program ended it, because it gave no answer or took too much.
    pub ended_by_us: bool,
    /// With `ended_by_us`: it happened so often that it is not tried again.
    pub settled: bool,
    /// It was ended because all work has to end, see [`Stop`]: this says nothing about the FMU.
    pub stopped: bool,
    /// The state that was to be brought back first was not: no step was made.
    pub restoring: bool,
    /// The FMU refused to be instantiated or initialised: it made no step.
    pub not_started: bool,
    /// The FMU could not be loaded: nothing of it has run.
    pub not_loaded: bool,
    /// The FMU did not do again what it did before: what this shows to be wrong.
    pub unlike: Option<Unlike>,
}

/// What is wrong when an FMU goes on differently from what is known of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub enum Unlike {
    /// A state that was brought back is not the state that it was.
    State,
    /// Two states with equal bytes are two states.
    Merge,
    /// Two plain runs from the start, with the same inputs.
    Plain,
}

impl PlantError {
    /// A failure of one call; the plant can be restarted.
    #[must_use]
    pub fn of(message: impl Into<String>) -> Self {
        Self { message: message.into(), ..Self::default() }
    }

    /// In how many fresh processes something is tried before such a failure counts as the FMU's own. Fewer where it has
    /// to be ended because it gave no answer or took too much, which takes long.
    pub(super) const fn tries(&self) -> u32 {
        match self {
            Self { stopped: true, .. } | Self { settled: true, .. } => 1,
            Self { ended_by_us: true, .. } => 2,
            _ => 5,
        }
    }

    /// Whether the FMU could not even begin: nothing was tried.
    #[must_use]
    pub const fn tried_nothing(&self) -> bool {
        self.stopped || self.not_started || self.not_loaded || (self.fatal && self.time_s.is_none())
    }

    /// Work was ended, see [`Stop`].
    #[must_use]
    pub fn stopped() -> Self {
        Self { stopped: true, lost: true, fatal: true, ..Self::of("stopped") }
    }

    /// The same at a simulation time.
    #[must_use]
    pub(crate) fn at(self, time_s: f64) -> Self {
        Self { time_s: Some(time_s), ..self }
    }

    /// The same, which shows that something is not as it was.
    #[must_use]
    pub(crate) fn unlike(self, what: Unlike) -> Self {
        Self { unlike: Some(what), ..self }
    }

    /// The same, and nothing can go on.
    #[must_use]
    pub(crate) fn fatal(self) -> Self {
        Self { fatal: true, ..self }
    }
}

impl fmt::Display for PlantError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        Said { message: &self.message, printed: &self.printed }.fmt(f)
    }
}

impl std::error::Error for PlantError {}

/// Tries again when the process of the FMU is gone.
pub(super) fn insist<T>(attempt: &mut dyn FnMut() -> Result<T, PlantError>) -> Result<T, PlantError> {
    let mut tries = 1;
    loop {
        match attempt() {
            Err(error) if error.lost && tries < error.tries() => tries += 1,
            outcome => return outcome,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::for_all_steps;

    #[test]
    fn the_last_row_goes_on() {
        assert_eq!(*for_all_steps(&[1.0, 2.0, 3.0, 4.0], 2, 4), [1.0, 2.0, 3.0, 4.0, 3.0, 4.0, 3.0, 4.0]);
        assert_eq!(*for_all_steps(&[1.0, 2.0], 2, 1), [1.0, 2.0]);
        assert!(for_all_steps(&[], 0, 3).is_empty());
    }
}
