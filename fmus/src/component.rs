//! One FMU instance: the rules of FMI co-simulation, 2.0 and 3.0, around a model, without any pointer.
//!
//! It keeps the mode, the clock of communication points and the bookkeeping of saved states. The time of the master is
//! rounded to whole milliseconds from its absolute value, so any step size works and nothing drifts.

use crate::bytes::{Reader, Writer};
use crate::interface::variables::{Causality, Interface, Value, Variant};
use crate::model::{AnyModel, Outcome, Special, interface_of};
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

    /// `fmi3UpdateDiscreteStates`: once is enough for every model.
    pub fn update_discrete(&mut self) -> Answer {
        self.expect_mode(&[Mode::Event])?;
        self.values_are_current = false;
        self.model.handle_event();
        Ok(())
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
        let early = special == Special::EarlyReturn && self.importer.allows_early_return;
        let half = time + step / 2.0;
        let reached = if early { half } else { time + step };
        let end = ticks_at(reached)?;
        self.values_are_current = false;
        let (severity, message) = match self.model.get_mut().step(end - self.tick) {
            Outcome::Done => {
                self.tick = end;
                let event = special == Special::Event && self.importer.uses_events;
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
mod tests {
    use super::*;
    use crate::interface::workcell::interface;
    use crate::interface::{WORKCELLS, coupled, faulty, safety_fence};

    fn fence() -> Interface {
        interface(&safety_fence::SPEC, Variant::Faithful).0
    }

    /// All models that save their states.
    fn models() -> Vec<Interface> {
        let cells = WORKCELLS.into_iter().map(|spec| interface(spec, Variant::Faithful).0);
        cells.chain(coupled::all().into_iter().take(2)).chain([faulty::interface(Variant::Faithful)]).collect()
    }

    fn stepping(interface: &Interface, integers: &[(usize, i32)]) -> Component {
        let mut component = Component::new(&interface.guid()).unwrap();
        for &(place, value) in integers {
            component.set(u32::try_from(place).unwrap(), Value::Integer(value)).unwrap();
        }
        start(&mut component);
        component
    }

    fn start(component: &mut Component) {
        component.setup(0.0).unwrap();
        component.enter_initialization().unwrap();
        component.exit_initialization().unwrap();
    }

    /// Outputs over `steps` steps of 20 ms with inputs that change.
    fn future(component: &mut Component, steps: u32) -> Vec<Value> {
        let mut values = Vec::new();
        let first = component.tick / 20;
        for k in 0..u64::from(steps) {
            for place in 0..component.interface.variables.len() {
                let variable = &component.interface.variables[place];
                if variable.causality == Causality::Input && matches!(variable.kind.start(), Value::Boolean(_)) {
                    let value = Value::Boolean((first + k + place as u64) % 7 < 4);
                    component.set(u32::try_from(place).unwrap(), value).unwrap();
                }
            }
            component.step((first + k) as f64 * 0.02, 0.02).unwrap();
            for place in 0..component.interface.variables.len() {
                if component.interface.variables[place].causality == Causality::Output {
                    values.push(component.get(u32::try_from(place).unwrap()).unwrap());
                }
            }
        }
        values
    }

    #[test]
    fn a_restored_state_has_the_same_future() {
        for interface in models() {
            let mut component = stepping(&interface, &[]);
            future(&mut component, 13);
            let early = component.save().unwrap();
            future(&mut component, 5);
            let late = component.save().unwrap();
            let expected = future(&mut component, 60);
            component.restore(&early).unwrap();
            future(&mut component, 2);
            component.restore(&late).unwrap();
            assert_eq!(future(&mut component, 60), expected, "{}", interface.name);
        }
    }

    #[test]
    fn bytes_carry_a_state_to_another_instance() {
        for interface in models() {
            let mut component = stepping(&interface, &[]);
            future(&mut component, 17);
            let saved = component.save().unwrap();
            let bytes = component.serialize(&saved).unwrap();
            let expected = future(&mut component, 60);
            let mut other = Component::new(&interface.guid()).unwrap();
            let read = other.deserialize(&bytes).unwrap();
            assert_eq!(other.serialize(&read).unwrap(), bytes);
            other.restore(&read).unwrap();
            assert_eq!(future(&mut other, 60), expected, "{}", interface.name);
            assert!(other.deserialize(&bytes[..bytes.len() - 1]).is_err(), "cut short");
            assert!(other.deserialize(&[&bytes[..], &[0]].concat()).is_err(), "too long");
        }
    }

    #[test]
    fn reset_brings_back_the_start_values() {
        let mut component = stepping(&fence(), &[]);
        let expected = future(&mut component, 60);
        component.reset().unwrap();
        start(&mut component);
        assert_eq!(future(&mut component, 60), expected);
    }

    #[test]
    fn any_step_size_leads_to_the_same_place() {
        let reference = u32::try_from(fence().place("robot.q[1]").unwrap()).unwrap();
        let mut whole = stepping(&fence(), &[]);
        whole.step(0.0, 1.234).unwrap();
        let mut parts = stepping(&fence(), &[]);
        let mut time = 0.0;
        for size in [0.000_4, 0.01, 0.333_3, 0.2, 0.000_2, 0.690_1] {
            parts.step(time, size).unwrap();
            time += size;
        }
        assert_eq!(parts.get(reference), whole.get(reference));
    }

    #[test]
    fn a_step_that_does_not_continue_is_an_error() {
        let mut component = stepping(&fence(), &[]);
        component.step(0.0, 0.02).unwrap();
        assert!(component.step(0.0, 0.02).is_err());
        assert!(component.step(0.02, f64::NAN).is_err());
        assert!(component.step(0.02, -0.01).is_err());
    }

    #[test]
    fn each_fault_does_what_it_says() {
        let fault = |kind: i32| {
            let settings = [(faulty::vr::FAULT_KIND, kind), (faulty::vr::FAULT_STEP, 2)];
            let mut component = stepping(&faulty::interface(Variant::Faithful), &settings);
            future(&mut component, 2);
            component
        };
        let q = |component: &mut Component| match component.get(u32::try_from(faulty::vr::Q).unwrap()) {
            Ok(Value::Real(q)) => q,
            other => panic!("{other:?}"),
        };
        for (kind, severity, mode) in [
            (2, Severity::Error, Mode::Failed),
            (3, Severity::Discard, Mode::Stepping),
            (4, Severity::Fatal, Mode::Dead),
        ] {
            let mut component = fault(kind);
            assert_eq!(component.step(0.04, 0.02).unwrap_err().severity, severity);
            assert_eq!(component.mode(), mode);
        }
        for kind in [1, 9] {
            let mut component = fault(kind);
            assert!(q(&mut component).is_finite());
            component.step(0.04, 0.02).unwrap();
            assert_eq!(q(&mut component).is_nan(), kind == 1);
            assert_eq!(q(&mut component).is_infinite(), kind == 9);
        }
        let (mut one, mut two) = (fault(5), fault(5));
        assert_eq!(q(&mut one), q(&mut two));
        assert_ne!(future(&mut one, 1), future(&mut two, 1));

        let mut sharing = fault(7);
        let first = sharing.save().unwrap();
        sharing.restore(&first).unwrap();
        assert_eq!(sharing.tick, 40, "one round trip looks well");
        future(&mut sharing, 3);
        sharing.save().unwrap();
        sharing.restore(&first).unwrap();
        assert_eq!(sharing.tick, 100, "the second state has overwritten the first");

        let mut stubborn = fault(8);
        let before = q(&mut stubborn);
        stubborn.reset().unwrap();
        start(&mut stubborn);
        assert_eq!(q(&mut stubborn), before);
        let mut honest = fault(0);
        honest.reset().unwrap();
        start(&mut honest);
        assert_eq!(q(&mut honest), 0.0);
    }

    /// An instance with a fault in its third step, which starts at 0.04 s; the importer can do what FMI 3.0 allows.
    fn fault3(kind: i32, importer: Importer) -> Component {
        let mut component = Component::new(&faulty::interface(Variant::Faithful).guid()).unwrap();
        component.serve(importer).unwrap();
        for (place, value) in [(faulty::vr::FAULT_KIND, kind), (faulty::vr::FAULT_STEP, 2)] {
            component.set(u32::try_from(place).unwrap(), Value::Integer(value)).unwrap();
        }
        start(&mut component);
        if importer.uses_events {
            component.update_discrete().unwrap();
            component.enter_step().unwrap();
        }
        future(&mut component, 2);
        component
    }

    const ABLE: Importer = Importer { uses_events: true, allows_early_return: true };

    #[test]
    fn an_early_return_stops_halfway_and_the_rest_follows() {
        let plain = StepEnd { event: false, terminate: false, early: false, time: 0.06 };
        let mut honest = fault3(0, ABLE);
        assert_eq!(honest.step(0.04, 0.02), Ok(plain));
        let mut early = fault3(10, ABLE);
        assert_eq!(early.step(0.04, 0.02), Ok(StepEnd { early: true, time: 0.05, ..plain }));
        assert_eq!(early.tick, 50);
        assert!(early.step(0.06, 0.02).is_err(), "not there yet");
        assert_eq!(early.step(0.05, 0.06 - 0.05), Ok(plain));
        assert_eq!(future(&mut early, 5)[..], future(&mut honest, 5)[..]);
        assert_eq!(fault3(10, Importer::default()).step(0.04, 0.02), Ok(plain), "not allowed, so not done");
    }

    #[test]
    fn a_model_that_ends_the_simulation_takes_no_further_step() {
        let mut component = fault3(11, ABLE);
        let before = component.save().unwrap();
        let end = component.step(0.04, 0.02).unwrap();
        assert!(end.terminate && !end.early);
        assert_eq!((end.time, component.mode()), (0.06, Mode::Ended));
        assert!(component.step(0.06, 0.02).is_err());
        component.get(0).unwrap();
        component.restore(&before).unwrap();
        assert_eq!(component.mode(), Mode::Stepping);
        component.step(0.04, 0.02).unwrap();
        component.terminate().unwrap();
    }

    #[test]
    fn an_event_has_the_same_effect_in_event_mode_and_without() {
        let mut without = fault3(12, Importer::default());
        assert!(!without.step(0.04, 0.02).unwrap().event);
        let mut with = fault3(12, ABLE);
        assert!(with.step(0.04, 0.02).unwrap().event);
        let mut forgetful = fault3(12, ABLE);
        forgetful.step(0.04, 0.02).unwrap();
        with.enter_event().unwrap();
        assert!(with.step(0.06, 0.02).is_err(), "not in event mode");
        let waiting = with.save().unwrap();
        with.update_discrete().unwrap();
        with.restore(&waiting).unwrap();
        with.update_discrete().unwrap();
        with.enter_step().unwrap();
        let expected = future(&mut without, 30);
        assert_eq!(future(&mut with, 30), expected);
        assert_ne!(future(&mut forgetful, 30), expected, "only an event that was handled has an effect");
        assert!(without.enter_event().is_err(), "this importer has no event mode");
    }

    #[test]
    fn a_lying_step_is_made_in_full() {
        let mut component = fault3(13, ABLE);
        let end = component.step(0.04, 0.02).unwrap();
        assert_eq!((end.early, end.time, component.tick), (false, 0.05, 60));
    }

    #[test]
    fn modes_of_fmi_3_are_kept_apart_and_saved() {
        let mut cell = Component::new(&fence().guid()).unwrap();
        assert!(cell.serve(ABLE).is_err(), "the cells have no event mode");
        let mut component = Component::new(&faulty::interface(Variant::Faithful).guid()).unwrap();
        component.enter_configuration().unwrap();
        assert!(component.enter_initialization().is_err());
        assert!(component.set(4, Value::Real(0.5)).is_err());
        let saved = component.save().unwrap();
        component.exit_configuration().unwrap();
        let read = component.deserialize(&component.serialize(&saved).unwrap()).unwrap();
        component.restore(&read).unwrap();
        assert_eq!(component.mode(), Mode::Configuring);
    }

    #[test]
    fn without_state_functions_every_one_of_them_refuses() {
        let mut component = stepping(&faulty::interface(Variant::NoState), &[]);
        assert!(component.save().is_err());
        assert!(component.deserialize(b"").is_err());
        let saved = stepping(&faulty::interface(Variant::Faithful), &[]).save().unwrap();
        assert!(component.restore(&saved).is_err());
        assert!(component.serialize(&saved).is_err());
    }

    #[test]
    fn what_may_not_be_set_is_refused() {
        let mut component = stepping(&fence(), &[]);
        let reference = |place: usize| u32::try_from(place).unwrap();
        assert!(
            component.set(reference(fence().place("ctrl.t_ramp").unwrap()), Value::Real(0.4)).is_err(),
            "fixed by now"
        );
        component.set(reference(fence().place("ctrl.t_ramp").unwrap()), Value::Real(0.3)).unwrap();
        assert!(component.set(reference(fence().place("robot.q[1]").unwrap()), Value::Real(0.0)).is_err(), "an output");
        assert!(component.set(reference(fence().place("plc.reset").unwrap()), Value::Real(1.0)).is_err(), "wrong type");
        assert!(component.set(99, Value::Real(1.0)).is_err(), "unknown");
        assert!(component.get(99).is_err(), "unknown");
        let mut early = Component::new(&fence().guid()).unwrap();
        assert!(
            early.set(reference(fence().place("ctrl.t_ramp").unwrap()), Value::Real(f64::NAN)).is_err(),
            "not a number"
        );
        assert!(early.set(reference(fence().place("ctrl.t_ramp").unwrap()), Value::Real(9.0)).is_err(), "out of range");
        assert!(Component::new("{other}").is_err());
    }
}
