//! An FMU in this process, as a [`Plant`].

use super::activity::{Activity, Call};
use super::plant::{Plant, PlantError, Reads};
use super::port::{Port, PortKind};
use super::rounding;
use crate::fmi::{self, Handle, Initializing, Instance, Instantiated, Plan, Slave, State, Stepping};
use crate::stop::Stop;

/// What to write to and read from an FMU, and at which steps.
#[derive(Clone, Debug)]
pub struct Setup {
    /// Parameters and their values, set before initialisation.
    pub parameters: Vec<(Port, f64)>,
    /// Inputs, written before every step.
    pub inputs: Vec<Port>,
    /// Input values for initialisation.
    pub initial_inputs: Vec<f64>,
    /// Outputs, read after every step.
    pub outputs: Vec<Port>,
    /// Further ones, which come last and may be no numbers.
    pub watched: Vec<Port>,
    /// Communication step, s.
    pub step_s: f64,
}

/// The plan for rows of these ports.
fn plan<'a>(slave: &Slave, ports: impl IntoIterator<Item = &'a Port>) -> Plan {
    let handles: Vec<Handle> = ports.into_iter().map(|p| p.handle).collect();
    Plan::new(slave, &handles)
}

/// What stands in a row for a watched value that is no number, and for watched values that could not be read: all that is
/// asked of them is to be the same again.
pub(super) const NO_NUMBER: f64 = f64::MAX;
pub(super) const REFUSED: f64 = f64::MIN;

/// A running FMU in this process.
pub(crate) struct InProcess {
    slave: Slave,
    setup: Setup,
    inputs: Plan,
    outputs: Plan,
    watched: Plan,
    instance: Option<Instance<Stepping>>,
    /// Communication steps taken since time zero; time is `step * step_s`, never accumulated.
    step: u64,
    activity: Activity,
    stop: Stop,
}

/// A saved FMU state together with the master's own clock.
pub struct Checkpoint {
    state: State,
    step: u64,
}

impl Checkpoint {
    /// Communication steps taken when it was saved.
    pub(super) const fn step(&self) -> u64 {
        self.step
    }
}

impl InProcess {
    /// A plant for `slave`; nothing is instantiated yet.
    #[must_use]
    pub(crate) fn new(slave: Slave, setup: Setup) -> Self {
        let (inputs, outputs) = (plan(&slave, &setup.inputs), plan(&slave, &setup.outputs));
        let watched = plan(&slave, &setup.watched);
        let (activity, stop) = (Activity::unseen(), Stop::default());
        Self { slave, setup, inputs, outputs, watched, instance: None, step: 0, activity, stop }
    }

    /// From now on no step is begun once `stop` says so.
    pub(super) fn heed(&mut self, stop: Stop) {
        self.stop = stop;
    }

    /// From now on `activity` is told what is being done.
    pub(super) fn watch(&mut self, activity: Activity) {
        self.activity = activity;
    }

    /// Replaces the input values for initialisation.
    pub(super) fn set_initial_inputs(&mut self, values: Vec<f64>) {
        self.setup.initial_inputs = values;
    }

    /// The FMU behind this plant.
    #[must_use]
    pub(crate) const fn slave(&self) -> &Slave {
        &self.slave
    }

    /// Makes the instance ready to step: parameters, inputs, initialisation.
    fn initialise(&mut self, mut instance: Instance<Instantiated>) -> Result<Instance<Stepping>, PlantError> {
        self.activity.begin(Call::Initialise, 0);
        let ports = self.setup.parameters.iter().map(|(port, _)| port);
        let values: Vec<f64> = self.setup.parameters.iter().map(|(_, value)| *value).collect();
        let written = plan(&self.slave, ports.clone()).write(&mut instance, &values);
        written.map_err(|e| failure_of("setting", ports, &e, 0.0))?;
        let written = self.inputs.write(&mut instance, &self.setup.initial_inputs);
        written.map_err(|e| failure_of("setting", &self.setup.inputs, &e, 0.0))?;
        // No stop time is set: beyond one that is, an FMU has to return an error (FMI 2.0.4, section 2.1.6; FMI 3.0,
        // fmi3EnterInitializationMode). The one of the default experiment is a suggestion, often the length of a demonstration.
        let initializing: Instance<Initializing> =
            instance.enter_initialization(0.0, None).map_err(|e| failed_start(&e))?;
        initializing.exit_initialization().map_err(|e| failed_start(&e))
    }

    fn read_row(&mut self) -> Result<Vec<f64>, PlantError> {
        let time_s = self.time_s();
        let mut row = vec![0.0; self.setup.outputs.len()];
        let Some(instance) = self.instance.as_mut() else { return Err(not_started()) };
        self.activity.begin(Call::Read, self.step.saturating_sub(1));
        let read = self.outputs.read(instance, &mut row);
        rounding::restore();
        if let Err(error) = read {
            let outputs = &self.setup.outputs;
            let refused = if error.is_fatal() { Vec::new() } else { refused(&self.slave, instance, outputs, &error) };
            rounding::restore();
            let named: Vec<&Port> = if refused.is_empty() { outputs.iter().collect() } else { refused };
            return Err(failure_of("reading", named, &error, time_s));
        }
        if let Some(bad) = row.iter().position(|v| !v.is_finite()) {
            return Err(not_finite(&self.setup, bad, row[bad], self.step).at(time_s));
        }
        if !self.setup.watched.is_empty() {
            let mut further = vec![0.0; self.setup.watched.len()];
            if self.watched.read(instance, &mut further).is_err() {
                further.fill(REFUSED);
            }
            rounding::restore();
            row.extend(further.into_iter().map(|value| if value.is_finite() { value } else { NO_NUMBER }));
        }
        Ok(row)
    }

    #[expect(clippy::cast_precision_loss, reason = "step counts are far below 2^53")]
    fn time_s(&self) -> f64 {
        self.step as f64 * self.setup.step_s
    }

    /// Resets the running instance with the FMU's reset function and initialises it again (only the self-test trusts this).
    ///
    /// # Errors
    /// When the FMU refuses.
    pub(super) fn reset(&mut self) -> Result<Vec<f64>, PlantError> {
        let instance = self.instance.take().ok_or_else(not_started)?;
        self.activity.begin(Call::Reset, self.step);
        let instance = instance.reset().map_err(|e| failure(&e, 0.0))?;
        self.instance = Some(self.initialise(instance)?);
        self.step = 0;
        self.read_row()
    }

    /// Bytes of a serialised state.
    ///
    /// # Errors
    /// When the FMU does not serialise.
    pub(super) fn serialize(&mut self, checkpoint: &Checkpoint) -> Result<Vec<u8>, PlantError> {
        let time_s = self.time_s();
        let instance = self.instance.as_mut().ok_or_else(not_started)?;
        self.activity.begin(Call::Serialize, self.step);
        instance.serialize(&checkpoint.state).map_err(|e| failure(&e, time_s))
    }

    /// A checkpoint from serialised bytes taken after `step` steps.
    ///
    /// # Errors
    /// When the FMU refuses.
    pub(super) fn deserialize(&mut self, bytes: &[u8], step: u64) -> Result<Checkpoint, PlantError> {
        let instance = self.instance.as_mut().ok_or_else(not_started)?;
        self.activity.begin(Call::Serialize, self.step);
        let state = instance.deserialize(bytes).map_err(|e| failure(&e, 0.0))?;
        Ok(Checkpoint { state, step })
    }
}

fn not_started() -> PlantError {
    PlantError::of("the FMU is not running: it has to be restarted first")
}

fn failure(error: &fmi::Error, time_s: f64) -> PlantError {
    PlantError { fatal: error.is_fatal(), ..PlantError::of(error.to_string()).at(time_s) }
}

/// The failure of an FMU that does not begin.
fn failed_start(error: &fmi::Error) -> PlantError {
    PlantError { not_started: true, ..failure(error, 0.0) }
}

/// An output that is no number, or none that can be computed with.
fn not_finite(setup: &Setup, column: usize, value: f64, step: u64) -> PlantError {
    let what = if value.is_nan() { "NaN (not a number)" } else { "infinite" };
    let (name, step_s) = (&setup.outputs[column].name, setup.step_s);
    #[expect(clippy::cast_precision_loss, reason = "step counts are far below 2^53")]
    let time_s = step as f64 * step_s;
    // Before the first step it cannot be the step's size.
    let hint = match step {
        0 => "before its first step: look at the start values of its inputs and parameters".to_owned(),
        _ => format!(
            "if it computes well in its own tool, communication steps of {} s may be too long for it: try a smaller \
             time.step_s in the cell file, or --step of `fmi-hazard inspect --self-test`",
            fmi::number(step_s)
        ),
    };
    PlantError::of(format!("the FMU's output `{name}` is {what} at t = {time_s:.3} s; {hint}"))
}

/// Which of these outputs the FMU refuses when they are read one by one, after it has refused them together. FMI allows to
/// read values after an error.
fn refused<'a>(
    slave: &Slave,
    instance: &mut Instance<Stepping>,
    ports: &'a [Port],
    error: &fmi::Error,
) -> Vec<&'a Port> {
    if !matches!(error, fmi::Error::Call(_) | fmi::Error::MissingFunction(_)) {
        return Vec::new();
    }
    let mut found = Vec::new();
    for port in ports {
        match plan(slave, [port]).read(instance, &mut [0.0]) {
            Ok(()) => {}
            // Nothing may be called any more.
            Err(error) if error.is_fatal() => return vec![port],
            Err(_) => found.push(port),
        }
    }
    found
}

/// Names told in a failure.
const NAMES: usize = 8;

/// The failure of a call for a row of variables, which are named: the FMU says only that it refused.
fn failure_of<'a>(
    doing: &str,
    ports: impl IntoIterator<Item = &'a Port>,
    error: &fmi::Error,
    time_s: f64,
) -> PlantError {
    let mut failed = failure(error, time_s);
    let function = match error {
        fmi::Error::Call(call) => call.function,
        fmi::Error::MissingFunction(function) => function,
        _ => return failed,
    };
    let kind = match function {
        name if name.contains("Real") || name.contains("Float") => PortKind::Real,
        name if name.contains("Boolean") => PortKind::Boolean,
        name if name.contains("Int") => PortKind::Integer,
        _ => return failed,
    };
    let name = |p: &Port| format!("`{}` (value reference {})", p.name, p.handle.value_reference);
    let mut names: Vec<String> = ports.into_iter().filter(|p| p.kind == kind).map(name).collect();
    let more = names.len().saturating_sub(NAMES);
    names.truncate(NAMES);
    let more = if more > 0 { format!(" and {more} more") } else { String::new() };
    failed.message = format!("{doing} {}{more}: {}", names.join(", "), failed.message);
    failed
}

impl Drop for InProcess {
    fn drop(&mut self) {
        // The instance goes right after this.
        if self.instance.is_some() {
            self.activity.begin(Call::Free, self.step);
        }
    }
}

impl Plant for InProcess {
    type Checkpoint = Checkpoint;

    fn input_count(&self) -> usize {
        self.setup.inputs.len()
    }

    fn output_count(&self) -> usize {
        self.setup.outputs.len() + self.setup.watched.len()
    }

    fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
        // The old instance goes first: some FMUs cannot have two.
        self.activity.begin(Call::Free, self.step);
        self.instance = None;
        self.step = 0;
        self.activity.begin(Call::Instantiate, 0);
        let instance = self.slave.instantiate("cell").map_err(|e| failed_start(&e))?;
        self.instance = Some(self.initialise(instance)?);
        self.read_row()
    }

    fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
        self.advance_reading(steps, inputs, Reads::Each)
    }

    fn advance_reading(&mut self, steps: usize, inputs: &[f64], reads: Reads) -> Result<Vec<f64>, PlantError> {
        let width = self.setup.inputs.len();
        let mut trace = Vec::with_capacity(reads.rows(steps) * self.setup.outputs.len());
        for i in 0..steps {
            if self.stop.is_due() {
                return Err(PlantError::stopped());
            }
            let time_s = self.time_s();
            let instance = self.instance.as_mut().ok_or_else(not_started)?;
            self.activity.begin(Call::Write, self.step);
            let written = self.inputs.write(instance, &inputs[i * width..(i + 1) * width]);
            written.map_err(|e| failure_of("setting", &self.setup.inputs, &e, time_s))?;
            self.activity.begin(Call::Step, self.step);
            instance.do_step(time_s, self.setup.step_s).map_err(|e| failure(&e, time_s))?;
            rounding::restore();
            self.step += 1;
            if reads == Reads::Each || i + 1 == steps {
                trace.extend(self.read_row()?);
            }
        }
        Ok(trace)
    }

    fn save(&mut self) -> Result<Checkpoint, PlantError> {
        let (time_s, step) = (self.time_s(), self.step);
        let instance = self.instance.as_mut().ok_or_else(not_started)?;
        self.activity.begin(Call::Save, self.step);
        let state = instance.save().map_err(|e| failure(&e, time_s))?;
        Ok(Checkpoint { state, step })
    }

    fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), PlantError> {
        let time_s = self.time_s();
        let instance = self.instance.as_mut().ok_or_else(not_started)?;
        self.activity.begin(Call::Restore, self.step);
        instance.restore(&checkpoint.state).map_err(|e| failure(&e, time_s))?;
        self.step = checkpoint.step;
        Ok(())
    }

    fn stop(&self) -> Stop {
        self.stop.clone()
    }
}
