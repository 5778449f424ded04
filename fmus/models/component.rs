//! One FMU instance: the rules of FMI co-simulation, 2.0 and 3.0, around a model, without any pointer.
//!
//! It keeps the mode, the clock of communication points and the bookkeeping of saved states. The time of the master is
//! rounded to whole milliseconds from its absolute value, so any step size works and nothing drifts.

use crate::any_model::{AnyModel, interface_of};
use crate::bytes::{Reader, Writer};
use crate::interface::variables::{Causality, Interface, Value, Variant};
use crate::model::{Outcome, Special};
use std::collections::BTreeSet;
use std::sync::{Mutex, PoisonError};

/// The status codes that go with a message; each has the same meaning in FMI 3.0.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Severity {
    /// `fmi2Discard`
    Discard,
    /// `fmi2Error`
    Error,
    /// `fmi2Fatal`
    Fatal,
}

/// Why a call was not carried out.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Refusal {
    /// The status to return.
    pub severity: Severity,
    /// The line for the log.
    pub message: String,
}

/// The result of a call.
pub type Answer<T = ()> = Result<T, Refusal>;

/// A refusal with `fmi2Error`.
pub fn error<T>(message: impl Into<String>) -> Answer<T> {
    Err(Refusal { severity: Severity::Error, message: message.into() })
}

/// Where the instance is in the state machine of FMI 2.0, section 4.2.4, or of FMI 3.0, section 4.2.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Mode {
    /// After instantiation or reset.
    Instantiated,
    /// Where FMI 3.0 allows structural parameters to be set.
    Configuring,
    /// Between Enter- and ExitInitializationMode.
    Initializing,
    /// At a communication point.
    Stepping,
    /// At a communication point of FMI 3.0 where discrete states may change.
    Event,
    /// After a step with which the model ended the simulation.
    Ended,
    /// After terminate.
    Terminated,
    /// After a step that failed: only a restore or a reset helps.
    Failed,
    /// Nothing helps.
    Dead,
}

/// What the importer of FMI 3.0 says of itself; FMI 2.0 has neither.
#[derive(Debug, Clone, Copy, Default)]
pub struct Importer {
    /// `eventModeUsed`
    pub uses_events: bool,
    /// `earlyReturnAllowed`
    pub allows_early_return: bool,
}

/// How a step that was made ended.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct StepEnd {
    /// Whether the importer has to enter event mode.
    pub event: bool,
    /// Whether the model ends the simulation here.
    pub terminate: bool,
    /// Whether the step ended before its time.
    pub early: bool,
    /// The time the FMU says it has come to, s.
    pub time: f64,
}

/// What `fmi2GetFMUstate` hands out.
#[derive(Debug, Clone, Copy)]
pub struct Saved {
    mode: Mode,
    tick: u64,
    model: AnyModel,
}

/// An instance.
#[derive(Debug)]
pub struct Component {
    interface: &'static Interface,
    importer: Importer,
    mode: Mode,
    /// The communication point, ms.
    tick: u64,
    model: AnyModel,
    /// The last state handed out: what fault 7 of the faulty model falls back to.
    last_saved: Option<Saved>,
    /// The values of all variables at this point, if already asked for.
    values: Vec<Value>,
    values_are_current: bool,
}

impl Component {
    /// The instance of the model with this GUID.
    pub fn new(guid: &str) -> Answer<Self> {
        let Some(interface) = interface_of(guid) else {
            return error(format!(
                "no model in this binary has the guid {guid}: modelDescription.xml is of another build"
            ));
        };
        if interface.variant == Variant::OncePerProcess && !first_use(&interface.identifier) {
            return error(format!("{} allows one instance in a process only", interface.name));
        }
        let Some(model) = AnyModel::new(&interface.identifier) else {
            return error(format!("this binary has no model {}", interface.identifier));
        };
        let values = interface.variables.iter().map(|variable| variable.kind.start()).collect();
        Ok(Self {
            interface,
            importer: Importer::default(),
            mode: Mode::Instantiated,
            tick: 0,
            model,
            last_saved: None,
            values,
            values_are_current: false,
        })
    }

    /// Tells what the importer can do; to be called before anything else.
    pub fn serve(&mut self, importer: Importer) -> Answer {
        if importer.uses_events && !self.interface.has_event_mode() {
            return error(format!("model {} has no event mode (hasEventMode is false)", self.interface.name));
        }
        self.importer = importer;
        Ok(())
    }

    /// The mode.
    pub fn mode(&self) -> Mode {
        self.mode
    }

    /// The present communication point, s.
    #[expect(clippy::cast_precision_loss, reason = "exact below 2^53 ms")]
    pub fn time(&self) -> f64 {
        self.tick as f64 / 1000.0
    }

    fn expect_mode(&self, allowed: &[Mode]) -> Answer {
        if allowed.contains(&self.mode) {
            Ok(())
        } else {
            error(format!("not allowed in mode {:?}, only in {allowed:?}", self.mode))
        }
    }

    /// Refuses where no variable can be read.
    pub fn expect_readable(&self) -> Answer {
        self.expect_mode(&[
            Mode::Initializing,
            Mode::Stepping,
            Mode::Event,
            Mode::Ended,
            Mode::Terminated,
            Mode::Failed,
        ])
    }

    /// Refuses where no input can be set.
    pub fn expect_settable(&self) -> Answer {
        self.expect_mode(&[Mode::Instantiated, Mode::Initializing, Mode::Stepping, Mode::Event])
    }

    /// Whether parameters can still change.
    pub fn takes_parameters(&self) -> bool {
        matches!(self.mode, Mode::Instantiated | Mode::Initializing)
    }

    /// `fmi2SetupExperiment`.
    pub fn setup(&mut self, start_time: f64) -> Answer {
        self.expect_mode(&[Mode::Instantiated])?;
        self.tick = ticks_at(start_time)?;
        Ok(())
    }

    /// `fmi2EnterInitializationMode`.
    pub fn enter_initialization(&mut self) -> Answer {
        self.expect_mode(&[Mode::Instantiated])?;
        self.mode = Mode::Initializing;
        Ok(())
    }

    /// `fmi2ExitInitializationMode`.
    pub fn exit_initialization(&mut self) -> Answer {
        self.expect_mode(&[Mode::Initializing])?;
        self.mode = if self.importer.uses_events { Mode::Event } else { Mode::Stepping };
        Ok(())
    }

    /// `fmi3EnterConfigurationMode`.
    pub fn enter_configuration(&mut self) -> Answer {
        self.expect_mode(&[Mode::Instantiated])?;
        self.mode = Mode::Configuring;
        Ok(())
    }

    /// `fmi3ExitConfigurationMode`.
    pub fn exit_configuration(&mut self) -> Answer {
        self.expect_mode(&[Mode::Configuring])?;
        self.mode = Mode::Instantiated;
        Ok(())
    }

    /// `fmi3EnterEventMode`.
    pub fn enter_event(&mut self) -> Answer {
        self.expect_mode(&[Mode::Stepping])?;
        if !self.importer.uses_events {
            return error("the instance was made without event mode (eventModeUsed was false)");
        }
        self.mode = Mode::Event;
        Ok(())
    }

    /// `fmi3EnterStepMode`.
    pub fn enter_step(&mut self) -> Answer {
        self.expect_mode(&[Mode::Event])?;
        self.mode = Mode::Stepping;
        Ok(())
    }

    /// `fmi3UpdateDiscreteStates`: once is enough for every model. The time of the next event that is known, s.
    #[expect(clippy::cast_precision_loss, reason = "exact below 2^53 ms")]
    pub fn update_discrete(&mut self) -> Answer<Option<f64>> {
        self.expect_mode(&[Mode::Event])?;
        self.values_are_current = false;
        self.model.handle_event();
        Ok(self.model.announced().map(|at| at as f64 / 1000.0))
    }

    /// `fmi2Terminate`.
    pub fn terminate(&mut self) -> Answer {
        self.expect_mode(&[Mode::Stepping, Mode::Event, Mode::Ended, Mode::Failed])?;
        self.mode = Mode::Terminated;
        Ok(())
    }

    /// `fmi2Reset`.
    pub fn reset(&mut self) -> Answer {
        if self.mode == Mode::Dead {
            return error("not allowed after a fatal error");
        }
        self.model.reset(self.interface.variant);
        self.values_are_current = false;
        self.tick = 0;
        self.mode = Mode::Instantiated;
        Ok(())
    }

    /// The value of a variable.
    pub fn get(&mut self, reference: u32) -> Answer<Value> {
        self.expect_readable()?;
        let place = self.place(reference)?;
        if self.interface.variables[place].causality == Causality::Independent {
            return Ok(Value::Real(self.time()));
        }
        Ok(self.current(place))
    }

    fn current(&mut self, place: usize) -> Value {
        if !self.values_are_current {
            self.model.get().read_out(&mut self.values);
            self.values_are_current = true;
        }
        self.values[place]
    }

    /// Sets an input or a parameter.
    pub fn set(&mut self, reference: u32, value: Value) -> Answer {
        self.expect_settable()?;
        let place = self.place(reference)?;
        let variable = &self.interface.variables[place];
        if !variable.kind.admits(value) {
            return error(format!("{} cannot be set to {value:?}: it is {:?}", variable.name, variable.kind));
        }
        match variable.causality {
            Causality::Input => {}
            Causality::Parameter if self.takes_parameters() => {}
            // Importers write all parameters again after a restore; the same value changes nothing.
            Causality::Parameter if self.current(place) == value => {}
            Causality::Parameter => {
                return error(format!("{} is a fixed parameter and cannot change after initialisation", variable.name));
            }
            Causality::Output | Causality::Independent => {
                return error(format!("{} is computed by the model and cannot be set", variable.name));
            }
        }
        self.values_are_current = false;
        self.model.get_mut().set(place, value);
        Ok(())
    }

    fn place(&self, reference: u32) -> Answer<usize> {
        match usize::try_from(reference) {
            Ok(place) if place < self.interface.variables.len() => Ok(place),
            _ => error(format!("model {} has no value reference {reference}", self.interface.name)),
        }
    }

    /// `fmi2DoStep` from `time` over `step` (s). A step that is discarded changes nothing.
    pub fn step(&mut self, time: f64, step: f64) -> Answer<StepEnd> {
        self.expect_mode(&[Mode::Stepping])?;
        if ticks_at(time)? != self.tick {
            return error(format!("the step starts at {time:?} s, but the FMU is at {:?} s", self.time()));
        }
        if !(step.is_finite() && step >= 0.0) {
            return error(format!("the step size is {step:?} s"));
        }
        let special = self.model.special();
        let early =
            matches!(special, Special::EarlyReturn | Special::EventHalfway) && self.importer.allows_early_return;
        let half = time + step / 2.0;
        let reached = if early { half } else { time + step };
        let end = ticks_at(reached)?;
        let is_halfway = special == Special::EventHalfway;
        let alone = !self.importer.uses_events && self.model.handles_announced();
        let announced = self.model.announced().filter(|at| alone && (self.tick..=end).contains(at));
        let event_at = if is_halfway && !early { Some(ticks_at(half)?) } else { announced };
        self.values_are_current = false;
        let (severity, message) = match self.advance(event_at, end) {
            Outcome::Done => {
                let left = self.importer.uses_events && (special == Special::Event || is_halfway && early);
                let event = left || special == Special::EventLeft;
                if special == Special::Event && !event {
                    self.model.handle_event();
                }
                let terminate = special == Special::Terminate;
                if terminate {
                    self.mode = Mode::Ended;
                }
                let time = if special == Special::WrongTime { half } else { reached };
                return Ok(StepEnd { event, terminate, early, time });
            }
            Outcome::Discarded(message) => (Severity::Discard, message),
            Outcome::Failed(message) => {
                self.mode = Mode::Failed;
                (Severity::Error, message)
            }
            Outcome::Fatal(message) => {
                self.mode = Mode::Dead;
                (Severity::Fatal, message)
            }
        };
        Err(Refusal { severity, message: format!("step from {time:?} s: {message}") })
    }

    /// To a tick, through an event at one before it.
    fn advance(&mut self, event_at: Option<u64>, end: u64) -> Outcome {
        if let Some(at) = event_at {
            match self.model.get_mut().step(at - self.tick) {
                Outcome::Done => self.tick = at,
                other => return other,
            }
            self.model.handle_event();
        }
        let outcome = self.model.get_mut().step(end - self.tick);
        if outcome == Outcome::Done {
            self.tick = end;
        }
        outcome
    }

    /// Everything that the future depends on.
    pub fn save(&mut self) -> Answer<Saved> {
        self.expect_state_functions()?;
        let saved = Saved { mode: self.mode, tick: self.tick, model: self.model };
        self.last_saved = Some(saved);
        Ok(saved)
    }

    /// Back to a saved state.
    pub fn restore(&mut self, saved: &Saved) -> Answer {
        self.expect_state_functions()?;
        let source = if self.model.shares_saved_states() { self.last_saved.unwrap_or(*saved) } else { *saved };
        if std::mem::discriminant(&self.model) != std::mem::discriminant(&source.model) {
            return error("the saved state belongs to another model");
        }
        self.mode = source.mode;
        self.tick = source.tick;
        self.model.restore(&source.model, self.interface.variant);
        self.values_are_current = false;
        Ok(())
    }

    /// The saved state as bytes.
    pub fn serialize(&self, saved: &Saved) -> Answer<Vec<u8>> {
        self.expect_state_functions()?;
        let mut out = Writer::default();
        out.0.extend_from_slice(self.interface.guid().as_bytes());
        out.u64(match saved.mode {
            Mode::Instantiated => 0,
            Mode::Initializing => 1,
            Mode::Stepping => 2,
            Mode::Terminated => 3,
            Mode::Failed => 4,
            Mode::Dead => 5,
            Mode::Configuring => 6,
            Mode::Event => 7,
            Mode::Ended => 8,
        });
        out.u64(saved.tick);
        saved.model.get().write(&mut out);
        Ok(out.0)
    }

    /// The saved state in these bytes.
    pub fn deserialize(&self, bytes: &[u8]) -> Answer<Saved> {
        self.expect_state_functions()?;
        let Some(rest) = bytes.strip_prefix(self.interface.guid().as_bytes()) else {
            return error("the bytes are not a state of this model");
        };
        let mut input = Reader(rest);
        match self.read(&mut input) {
            Some(saved) if input.0.is_empty() => Ok(saved),
            _ => error("the bytes are a damaged state of this model"),
        }
    }

    fn read(&self, input: &mut Reader) -> Option<Saved> {
        let mode = match input.u64()? {
            0 => Mode::Instantiated,
            1 => Mode::Initializing,
            2 => Mode::Stepping,
            3 => Mode::Terminated,
            4 => Mode::Failed,
            6 => Mode::Configuring,
            7 => Mode::Event,
            8 => Mode::Ended,
            _ => return None,
        };
        Some(Saved { mode, tick: input.u64()?, model: self.model.read(input)? })
    }

    /// Refuses where modelDescription.xml says that states cannot be saved.
    pub fn expect_state_functions(&self) -> Answer {
        if !self.interface.variant.saves_state() {
            return error(format!(
                "model {} cannot save its state (canGetAndSetFMUstate is false)",
                self.interface.name
            ));
        }
        if self.mode == Mode::Dead {
            return error("not allowed after a fatal error");
        }
        Ok(())
    }
}

/// Whether this is the first instance of the model in this process.
fn first_use(identifier: &str) -> bool {
    static USED: Mutex<BTreeSet<String>> = Mutex::new(BTreeSet::new());
    USED.lock().unwrap_or_else(PoisonError::into_inner).insert(identifier.to_owned())
}

/// A time of the master in whole milliseconds.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked to lie in 0..1e12")]
fn ticks_at(time: f64) -> Answer<u64> {
    if (0.0..1e12).contains(&time) {
        Ok((time * 1000.0).round() as u64)
    } else {
        error(format!("the time {time:?} s is negative, not finite or too large"))
    }
}

#[cfg(test)]
#[path = "component_tests.rs"]
mod tests;
