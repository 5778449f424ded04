//! One FMU, or several coupled ones, as one [`Plant`].
//!
//! The FMUs are stepped one after the other in data-flow order: what one gives at the end of a communication step is
//! what the next one gets for that same step. A signal that changes within a step so acts downstream from the step's
//! beginning, up to one step early; a connection with `delay_steps` holds values back by whole steps, which a loop needs
//! somewhere. [`SystemSetup::couplings`] says what each connection does.

use std::collections::VecDeque;
use std::fmt;

use serde::{Deserialize, Serialize};
use sha2::{Digest as _, Sha256};

use super::activity::Activity;
use super::in_process::{self, InProcess, Setup};
use super::plant::{Fingerprint, Plant, PlantError, Reads};
use super::port::Port;
use crate::fmi::Slave;
use crate::stop::Stop;

/// A variable of one of the FMUs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct UnitPort {
    /// Which FMU.
    pub unit: usize,
    /// The variable.
    pub port: Port,
}

/// An output that drives an input.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Connection {
    /// The output.
    pub from: UnitPort,
    /// The input.
    pub to: UnitPort,
    /// Whole communication steps by which the value is held back.
    pub delay_steps: usize,
    /// The input gets `factor * output + offset`.
    pub factor: f64,
    /// See `factor`.
    pub offset: f64,
}

/// What to write to and read from the FMUs, and at which steps.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct SystemSetup {
    /// Names of the FMUs, for messages.
    pub names: Vec<String>,
    /// Parameters and their values, set before initialisation.
    pub parameters: Vec<(UnitPort, f64)>,
    /// Inputs, written before every step.
    pub inputs: Vec<UnitPort>,
    /// Input values for initialisation.
    pub initial_inputs: Vec<f64>,
    /// Outputs, read after every step.
    pub outputs: Vec<UnitPort>,
    /// Connections between the FMUs.
    pub connections: Vec<Connection>,
    /// Further variables that get what is written to an input: its column, and the variable.
    pub mirrors: Vec<(usize, UnitPort)>,
    /// Communication step, s.
    pub step_s: f64,
    /// Steps with the initial inputs that come before anything else happens.
    #[serde(default)]
    pub lead_in_steps: usize,
    /// Further outputs, read after the others: only the self-test looks at them. They may be no numbers, or refuse to be
    /// read.
    #[serde(default)]
    pub watched: Vec<UnitPort>,
}

/// Connections without delay that lead back to where they come from: nothing can be stepped first.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct AlgebraicLoop {
    /// The FMUs in the loop.
    pub units: Vec<String>,
}

impl fmt::Display for AlgebraicLoop {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the connections between {} form a loop without delay", self.units.join(", "))
    }
}

impl std::error::Error for AlgebraicLoop {}

impl SystemSetup {
    /// Columns of a row of outputs.
    #[must_use]
    pub(crate) fn columns(&self) -> usize {
        self.outputs.len() + self.watched.len()
    }

    /// Their names; with that of the FMU where there are several.
    #[must_use]
    pub fn column_names(&self) -> Vec<String> {
        let name = |p: &UnitPort| match self.names.len() {
            1 => p.port.name.clone(),
            _ => format!("{}:{}", self.names[p.unit], p.port.name),
        };
        self.outputs.iter().chain(&self.watched).map(name).collect()
    }

    /// The order in which the FMUs are stepped: sources first, else as listed.
    ///
    /// # Errors
    /// A loop of connections without delay.
    pub fn order(&self) -> Result<Vec<usize>, AlgebraicLoop> {
        let count = self.names.len();
        let mut order: Vec<usize> = Vec::with_capacity(count);
        while order.len() < count {
            let waits = |unit: usize| {
                let direct = self.connections.iter().filter(|c| c.delay_steps == 0 && c.to.unit == unit);
                direct.into_iter().any(|c| !order.contains(&c.from.unit))
            };
            match (0..count).find(|unit| !order.contains(unit) && !waits(*unit)) {
                Some(next) => order.push(next),
                None => {
                    let left = (0..count).filter(|unit| !order.contains(unit));
                    return Err(AlgebraicLoop { units: left.map(|unit| self.names[unit].clone()).collect() });
                }
            }
        }
        Ok(order)
    }

    /// One line for each connection: what drives what, and what the coupling adds.
    #[must_use]
    pub fn couplings(&self) -> Vec<String> {
        let step_ms = self.step_s * 1000.0;
        let name = |p: &UnitPort| format!("{}:{}", self.names[p.unit], p.port.name);
        let delay = |c: &Connection| match c.delay_steps {
            0 => format!("within the step (a change inside a step acts up to {step_ms:.0} ms early, never late)"),
            #[expect(clippy::cast_precision_loss, reason = "a few steps")]
            n => format!("{:.0} ms later", n as f64 * step_ms),
        };
        self.connections.iter().map(|c| format!("{} -> {}: {}", name(&c.from), name(&c.to), delay(c))).collect()
    }

    /// The part of one FMU: its external inputs, those that mirror others, then its connected inputs; its bound outputs, then
    /// what it passes on.
    #[must_use]
    pub fn unit(&self, unit: usize) -> Setup {
        let own = |p: &UnitPort| p.unit == unit;
        let ports = |all: &[UnitPort]| all.iter().filter(|p| own(p)).map(|p| p.port.clone()).collect::<Vec<_>>();
        let mut inputs = ports(&self.inputs);
        let mirrors = || self.mirrors.iter().filter(|(_, p)| own(p));
        inputs.extend(mirrors().map(|(_, p)| p.port.clone()));
        inputs.extend(self.connections.iter().filter(|c| own(&c.to)).map(|c| c.to.port.clone()));
        let mut outputs = ports(&self.outputs);
        outputs.extend(self.connections.iter().filter(|c| own(&c.from)).map(|c| c.from.port.clone()));
        let external = self.inputs.iter().zip(&self.initial_inputs).filter(|(p, _)| own(p)).map(|(_, v)| *v);
        let mirrored = mirrors().map(|(column, _)| self.initial_inputs[*column]);
        let connected = self.connections.iter().filter(|c| own(&c.to)).map(|c| c.to.port.start);
        Setup {
            parameters: self.parameters.iter().filter(|(p, _)| own(p)).map(|(p, v)| (p.port.clone(), *v)).collect(),
            initial_inputs: external.chain(mirrored).chain(connected).collect(),
            inputs,
            outputs,
            watched: ports(&self.watched),
            step_s: self.step_s,
        }
    }
}

/// Where the columns of one FMU's rows come from and go to.
#[derive(Clone, Debug)]
struct Wiring {
    /// For each of its inputs.
    inputs: Vec<Source>,
    /// Columns of the system's outputs, in the order of its bound outputs.
    outputs: Vec<usize>,
    /// Connections that it feeds, in the order of its further outputs.
    feeds: Vec<usize>,
    /// Columns of the system's outputs of what is watched, which comes last.
    watched: Vec<usize>,
}

#[derive(Clone, Copy, Debug)]
enum Source {
    /// A column of the system's inputs.
    External(usize),
    /// A connection.
    Connection(usize),
}

/// The FMUs of a cell.
pub struct System {
    setup: SystemSetup,
    order: Vec<usize>,
    units: Vec<InProcess>,
    wiring: Vec<Wiring>,
    /// For each connection its last values, the newest at the back.
    lines: Vec<VecDeque<f64>>,
}

/// Saved states of all FMUs, and the values under way between them.
pub struct Checkpoint {
    units: Vec<in_process::Checkpoint>,
    lines: Vec<VecDeque<f64>>,
}

/// Serialised states of all FMUs, and the values under way between them.
pub(super) struct Serialized {
    units: Vec<(Vec<u8>, u64)>,
    lines: Vec<VecDeque<f64>>,
}

impl Serialized {
    /// Bytes of all states.
    pub(super) fn size(&self) -> usize {
        self.units.iter().map(|(bytes, _)| bytes.len()).sum()
    }
}

impl System {
    /// A plant of `slaves`, one for each of the setup's names; nothing is instantiated yet.
    ///
    /// # Errors
    /// A loop of connections without delay.
    pub fn new(slaves: &[Slave], setup: SystemSetup) -> Result<Self, AlgebraicLoop> {
        let order = setup.order()?;
        let units = slaves.iter().enumerate().map(|(i, slave)| InProcess::new(slave.clone(), setup.unit(i))).collect();
        let columns = |all: &[UnitPort], unit: usize| {
            all.iter().enumerate().filter(|(_, p)| p.unit == unit).map(|(column, _)| column).collect::<Vec<_>>()
        };
        let wires = |unit: usize| {
            let at = |end: fn(&Connection) -> usize| {
                let found = setup.connections.iter().enumerate().filter(move |(_, c)| end(c) == unit);
                found.map(|(i, _)| i).collect::<Vec<_>>()
            };
            let mirrors = setup.mirrors.iter().filter(|(_, p)| p.unit == unit).map(|(column, _)| *column);
            let external = columns(&setup.inputs, unit).into_iter().chain(mirrors).map(Source::External);
            let connected = at(|c| c.to.unit).into_iter().map(Source::Connection);
            Wiring {
                inputs: external.chain(connected).collect(),
                outputs: columns(&setup.outputs, unit),
                feeds: at(|c| c.from.unit),
                watched: columns(&setup.watched, unit).into_iter().map(|i| setup.outputs.len() + i).collect(),
            }
        };
        let wiring = (0..slaves.len()).map(wires).collect();
        Ok(Self { order, units, wiring, lines: vec![VecDeque::new(); setup.connections.len()], setup })
    }

    /// The same, telling `activity` what it does.
    #[must_use]
    pub(super) fn watched(mut self, activity: Activity) -> Self {
        self.units.iter_mut().for_each(|unit| unit.watch(activity));
        self
    }

    /// The same; its steps end when `stop` says so.
    #[must_use]
    pub fn heeding(mut self, stop: &Stop) -> Self {
        self.units.iter_mut().for_each(|unit| unit.heed(stop.clone()));
        self
    }

    /// Begins again at time zero, each FMU by `begin`, in the order in which they are stepped; then come the steps that lead
    /// in.
    fn begin(
        &mut self,
        begin: impl Fn(&mut InProcess) -> Result<Vec<f64>, PlantError>,
    ) -> Result<Vec<f64>, PlantError> {
        let mut row = vec![0.0; self.setup.columns()];
        self.lines.iter_mut().for_each(VecDeque::clear);
        let initial = self.setup.initial_inputs.clone();
        for place in 0..self.order.len() {
            let unit = self.order[place];
            let values = self.unit_row(unit, &initial);
            self.units[unit].set_initial_inputs(values);
            let given = begin(&mut self.units[unit]).map_err(|e| self.blame(unit, e))?;
            self.collect(unit, &given, &mut row);
        }
        if self.setup.lead_in_steps == 0 {
            return Ok(row);
        }
        let rows = self.advance(self.setup.lead_in_steps, &initial.repeat(self.setup.lead_in_steps))?;
        Ok(rows[rows.len() - row.len()..].to_vec())
    }

    /// Resets all FMUs and initialises them again (only the self-test trusts this).
    pub(super) fn reset(&mut self) -> Result<Vec<f64>, PlantError> {
        self.begin(InProcess::reset)
    }

    /// The bytes of a saved state.
    pub(super) fn serialize(&mut self, checkpoint: &Checkpoint) -> Result<Serialized, PlantError> {
        let units = self.units.iter_mut().zip(&checkpoint.units);
        let units = units.map(|(unit, saved)| Ok((unit.serialize(saved)?, saved.step())));
        Ok(Serialized { units: units.collect::<Result<_, PlantError>>()?, lines: checkpoint.lines.clone() })
    }

    /// A state from its bytes.
    pub(super) fn deserialize(&mut self, bytes: &Serialized) -> Result<Checkpoint, PlantError> {
        let units = self.units.iter_mut().zip(&bytes.units);
        let units = units.map(|(unit, (bytes, step))| unit.deserialize(bytes, *step));
        Ok(Checkpoint { units: units.collect::<Result<_, _>>()?, lines: bytes.lines.clone() })
    }

    /// What a connection's input gets in the present step: the output `delay_steps` before the end of this step.
    fn arriving(&self, connection: usize) -> f64 {
        let Connection { from, to, delay_steps, .. } = &self.setup.connections[connection];
        let place = |unit: usize| self.order.iter().position(|&u| u == unit);
        // A source that comes later in the order has not given its value of this step yet.
        let behind = if place(from.unit) < place(to.unit) { *delay_steps } else { delay_steps.saturating_sub(1) };
        let line = &self.lines[connection];
        let at = line.len().saturating_sub(1 + behind);
        line.get(at).copied().unwrap_or(to.port.start)
    }

    /// The row of one FMU: columns of the system's row, and what its connections hold.
    fn unit_row(&self, unit: usize, row: &[f64]) -> Vec<f64> {
        let value = |source: &Source| match *source {
            Source::External(column) => row[column],
            Source::Connection(connection) => self.arriving(connection),
        };
        self.wiring[unit].inputs.iter().map(value).collect()
    }

    /// Takes in what one FMU gave: bound outputs go to `row`, passed on ones into their lines.
    fn collect(&mut self, unit: usize, given: &[f64], row: &mut [f64]) {
        let wiring = &self.wiring[unit];
        for (&column, &value) in wiring.outputs.iter().zip(given) {
            row[column] = value;
        }
        let before = wiring.outputs.len() + wiring.feeds.len();
        for (&column, &value) in wiring.watched.iter().zip(&given[before..]) {
            row[column] = value;
        }
        for (&connection, &value) in wiring.feeds.iter().zip(&given[wiring.outputs.len()..]) {
            let Connection { delay_steps, factor, offset, .. } = self.setup.connections[connection];
            let line = &mut self.lines[connection];
            line.push_back(factor * value + offset);
            while line.len() > delay_steps + 1 {
                line.pop_front();
            }
        }
    }

    /// An error that names the FMU, where there are several.
    fn blame(&self, unit: usize, error: PlantError) -> PlantError {
        match self.units.len() {
            1 => error,
            _ => PlantError { message: format!("{}: {}", self.setup.names[unit], error.message), ..error },
        }
    }
}

impl Plant for System {
    type Checkpoint = Checkpoint;

    fn input_count(&self) -> usize {
        self.setup.inputs.len()
    }

    fn output_count(&self) -> usize {
        self.setup.columns()
    }

    fn restart(&mut self) -> Result<Vec<f64>, PlantError> {
        self.begin(Plant::restart)
    }

    fn advance(&mut self, steps: usize, inputs: &[f64]) -> Result<Vec<f64>, PlantError> {
        self.advance_reading(steps, inputs, Reads::Each)
    }

    fn advance_reading(&mut self, steps: usize, inputs: &[f64], reads: Reads) -> Result<Vec<f64>, PlantError> {
        if self.setup.connections.is_empty() && self.units.len() == 1 {
            return self.units[0].advance_reading(steps, inputs, reads);
        }
        let (width, rows) = (self.setup.inputs.len(), self.setup.columns());
        let mut trace = Vec::with_capacity(reads.rows(steps) * rows);
        for step in 0..steps {
            let mut row = vec![0.0; rows];
            for place in 0..self.order.len() {
                let unit = self.order[place];
                let values = self.unit_row(unit, &inputs[step * width..(step + 1) * width]);
                let given = self.units[unit].advance(1, &values).map_err(|e| self.blame(unit, e))?;
                self.collect(unit, &given, &mut row);
            }
            if reads == Reads::Each || step + 1 == steps {
                trace.extend(row);
            }
        }
        Ok(trace)
    }

    fn save(&mut self) -> Result<Checkpoint, PlantError> {
        let units = (0..self.units.len()).map(|unit| {
            let saved = self.units[unit].save();
            saved.map_err(|e| self.blame(unit, e))
        });
        Ok(Checkpoint { units: units.collect::<Result<_, _>>()?, lines: self.lines.clone() })
    }

    fn fingerprint(&mut self) -> Result<Option<Fingerprint>, PlantError> {
        let offers = |unit: &InProcess| {
            let capabilities = unit.slave().capabilities();
            capabilities.can_get_and_set_state && capabilities.can_serialize_state
        };
        if !self.units.iter().all(offers) {
            return Ok(None);
        }
        let saved = self.save()?;
        let serialized = self.serialize(&saved)?;
        let mut hash = Sha256::new();
        for (bytes, step) in &serialized.units {
            hash.update(bytes.len().to_le_bytes());
            hash.update(bytes);
            hash.update(step.to_le_bytes());
        }
        for value in serialized.lines.iter().flatten() {
            hash.update(value.to_bits().to_le_bytes());
        }
        Ok(Some(Fingerprint { digest: hash.finalize().into(), bytes: serialized.size() }))
    }

    fn restore(&mut self, checkpoint: &Checkpoint) -> Result<(), PlantError> {
        for (unit, saved) in checkpoint.units.iter().enumerate() {
            self.units[unit].restore(saved).map_err(|e| self.blame(unit, e))?;
        }
        self.lines.clone_from(&checkpoint.lines);
        Ok(())
    }

    fn stop(&self) -> Stop {
        self.units.first().map(Plant::stop).unwrap_or_default()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fmi::{Handle, Scalar};

    /// Units by name, connections as (from, to, delay).
    fn setup(units: &[&str], connections: &[(usize, usize, usize)]) -> SystemSetup {
        let scalar = Scalar::Float64;
        let handle = Handle { value_reference: 0, scalar, offset: 0, count: 1, discrete: false };
        let port = |unit: usize| UnitPort { unit, port: Port::new("v".to_owned(), handle, 0.0).unwrap() };
        let connect = |&(from, to, delay_steps)| Connection {
            from: port(from),
            to: port(to),
            delay_steps,
            factor: 1.0,
            offset: 0.0,
        };
        SystemSetup {
            names: units.iter().map(ToString::to_string).collect(),
            connections: connections.iter().map(connect).collect(),
            ..SystemSetup::default()
        }
    }

    #[test]
    fn sources_are_stepped_first() {
        assert_eq!(setup(&["c", "b", "a"], &[(2, 1, 0), (1, 0, 0)]).order(), Ok(vec![2, 1, 0]));
        assert_eq!(setup(&["a", "b", "c"], &[]).order(), Ok(vec![0, 1, 2]));
        assert_eq!(setup(&["a", "b", "c"], &[(2, 0, 0)]).order(), Ok(vec![1, 2, 0]));
    }

    #[test]
    fn a_loop_needs_a_delay_somewhere() {
        let direct = [(0, 1, 0), (1, 2, 0), (2, 1, 0)];
        let units = vec!["b".to_owned(), "c".to_owned()];
        assert_eq!(setup(&["a", "b", "c"], &direct).order(), Err(AlgebraicLoop { units }));
        let delayed = [(0, 1, 0), (1, 2, 0), (2, 1, 1)];
        assert_eq!(setup(&["a", "b", "c"], &delayed).order(), Ok(vec![0, 1, 2]));
        let itself = setup(&["a"], &[(0, 0, 0)]).order();
        assert!(itself.unwrap_err().to_string().contains("a form a loop without delay"));
    }

    #[test]
    fn values_under_way_between_fmus_tell_states_apart() {
        let mut system = System::new(&[], SystemSetup::default()).unwrap();
        let mut print = |line: [f64; 2]| {
            system.lines = vec![VecDeque::from(line)];
            system.fingerprint().unwrap().unwrap().digest
        };
        let one = print([0.0, 1.0]);
        assert_eq!(print([0.0, 1.0]), one);
        for other in [[0.0, 2.0], [1.0, 0.0], [-0.0, 1.0]] {
            assert_ne!(print(other), one, "{other:?}");
        }
    }
}
