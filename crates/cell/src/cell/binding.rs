//! Names in the cell file to variables of the FMU: existence, direction, type and unit are checked, and each quantity
//! the simulation needs becomes a [`Reader`] over the FMU's bound outputs.
//!
//! `lookup` finds variables and converts their units, `robot` binds what moves a robot, `system` the connections between FMUs;
//! `reading` is what is left of all that in a scan. [`alone`] is for FMUs without a cell.

pub mod alone;
mod lookup;
mod reading;
mod robot;
mod system;

use std::borrow::Cow;
use std::collections::BTreeMap;

use toml::Spanned;

use self::lookup::Quantity;
use super::error::{Problems, Source};
use super::file::format::{
    CellFile, ControlTable, Literal, MovesTable, ObstacleTable, ParameterLimits, SensorTable, ValuesTable, WhileTable,
};
use super::file::signal;
use super::foreign::ssp::Wiring;
use super::sensor::Signal;
use super::{CellError, Workcell};
use crate::fmi::{Causality, FmiVersion, Fmu, ModelDescription, Variable, VariableType};
use crate::host::port::PortKind;
use crate::host::system::{Connection, SystemSetup, UnitPort};

pub use reading::{Derived, HARDEST, Orientation, Reader, jumps};

/// Which FMU variables are written and read, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Binding {
    /// Parameters set before initialisation.
    pub parameters: Vec<(UnitPort, f64)>,
    /// Inputs written at every step: first the distinct sensor variables, then the person's pose, then the controls, then the
    /// constants.
    pub inputs: Vec<UnitPort>,
    /// For each sensor, the index of its input, or how to read it.
    pub sensors: Vec<SensorBinding>,
    /// Number of distinct inputs driven by sensors.
    pub sensor_inputs: usize,
    /// For each control its values, released and pressed; their inputs follow those of the pose.
    pub controls: Vec<[f64; 2]>,
    /// Values of the constant inputs, following the others.
    pub constants: Vec<f64>,
    /// Outputs read after every step.
    pub outputs: Vec<UnitPort>,
    /// What is worked out from them, and follows them in each row.
    pub derived: Vec<Derived>,
    /// Connections between FMUs.
    pub connections: Vec<Connection>,
    /// Further variables that get what an input gets: its column, and the variable.
    pub mirrors: Vec<(usize, UnitPort)>,
    /// Robots, in the order of the cell.
    pub robots: Vec<RobotBinding>,
    /// What obstacles, sensors and controls follow: of each obstacle whether it stands, then how far it is; then whether sensors count; then
    /// whether controls can be worked.
    pub followed: Vec<Reader>,
    /// Things the user should know, for instance an assumed unit.
    pub warnings: Vec<String>,
}

/// Where a sensor's reading goes to or comes from.
#[derive(Clone, Debug, PartialEq)]
pub enum SensorBinding {
    /// Index of the input that it drives.
    Input(usize),
    /// The output that tells it.
    Output(Reader),
    /// The FMU evaluates it as far as it knows the person's pose, and is told of the rest.
    Both {
        /// Index of the input that tells of arms, and of bodies that bend.
        input: usize,
        /// The output that tells what the FMU sees.
        output: Reader,
        /// The value of that output while it sees somebody.
        active: bool,
    },
}

impl SensorBinding {
    /// Index of the input that it drives, if it drives one.
    #[must_use]
    pub const fn input(&self) -> Option<usize> {
        match self {
            Self::Input(input) | Self::Both { input, .. } => Some(*input),
            Self::Output(_) => None,
        }
    }

    /// Whether the FMU evaluates it, wholly or in part.
    #[must_use]
    pub const fn is_evaluated(&self) -> bool {
        !matches!(self, Self::Input(_))
    }

    /// Whether the FMU itself reports somebody in a row of its outputs; `signal` is the sensor's own.
    #[must_use]
    pub fn reports(&self, row: &[f64], signal: Signal) -> bool {
        match self {
            Self::Input(_) => false,
            Self::Output(reader) => signal.detects(reader.read(row)),
            Self::Both { output, active, .. } => (output.read(row) != 0.0) == *active,
        }
    }
}

/// How a robot's state is read.
#[derive(Clone, Debug, PartialEq)]
pub struct RobotBinding {
    /// Its motion.
    pub motion: MotionBinding,
    /// Payload, kg.
    pub payload: Reader,
    /// Programme phase, a whole number.
    pub phase: Option<Reader>,
}

/// How a robot's motion is read.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionBinding {
    /// Joint positions, rad or m, and speeds, rad/s or m/s, of those that the cell file names.
    Joints {
        /// Position of each joint.
        positions: Vec<Reader>,
        /// Speed of each joint.
        speeds: Vec<Reader>,
    },
    /// Pose and velocity of each part, base frame.
    Frames(Vec<FrameBinding>),
}

/// How a moving part is read; SI, base frame.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameBinding {
    /// Origin x, y, z.
    pub position: [Reader; 3],
    /// How it is turned.
    pub orientation: Orientation,
    /// Velocity of the origin.
    pub velocity: [Reader; 3],
    /// Angular velocity.
    pub angular_velocity: [Reader; 3],
}

/// A map's key with the place of its value, for messages (keys have no place of their own).
fn named<T>(name: &str, value: &Spanned<T>) -> Spanned<String> {
    Spanned::new(value.span(), name.to_owned())
}

/// One of the FMUs as the binder sees it.
pub struct BoundUnit<'a> {
    /// Name in front of its variables; empty for the only one.
    pub name: &'a str,
    /// Its variables.
    pub description: &'a ModelDescription,
    /// Its file, for messages.
    pub file: String,
}

impl<'a> BoundUnit<'a> {
    /// FMUs by their names.
    pub fn all(units: impl IntoIterator<Item = (&'a String, &'a Fmu)>) -> Vec<Self> {
        let file = |fmu: &Fmu| fmu.path().file_name().map_or_else(String::new, |f| f.to_string_lossy().into_owned());
        let unit = |(name, fmu): (&'a String, &'a Fmu)| Self { name, description: fmu.description(), file: file(fmu) };
        units.into_iter().map(unit).collect()
    }
}

struct Binder<'a> {
    source: &'a Source,
    /// The system that the units come in.
    wiring: Option<&'a Wiring>,
    /// Inputs of the system that drive several variables: the first, and each of the others.
    mirrors: Vec<(UnitPort, UnitPort)>,
    problems: &'a Problems,
    units: &'a [BoundUnit<'a>],
    outputs: Vec<UnitPort>,
    derived: Vec<Derived>,
    /// Variables whose unit is not told, by the unit that they are taken to be in.
    unitless: BTreeMap<&'static str, Vec<String>>,
    /// What is differentiated.
    differentiated: Vec<String>,
    warnings: Vec<String>,
}

/// Binds what `file` names to its FMUs.
///
/// # Errors
/// All names, types and units that do not fit, each with its line in the cell file.
pub fn bind(
    file: &CellFile,
    source: &Source,
    units: &[BoundUnit<'_>],
    wiring: Option<&Wiring>,
) -> Result<Binding, Box<CellError>> {
    let problems = &Problems::default();
    let mut b = Binder::new(source, units, wiring, problems);
    let robots: Vec<RobotBinding> = file.robots.iter().filter_map(|robot| b.robot(robot)).collect();
    let mut inputs: Vec<UnitPort> = Vec::new();
    let mut sensors: Vec<Option<SensorBinding>> = Vec::new();
    for (number, sensor) in file.sensors.iter().enumerate() {
        let binding = problems.keep(b.sensor(sensor, &mut inputs));
        let twin = (0..number).find(|&other| {
            let input = binding.as_ref().and_then(SensorBinding::input);
            input.is_some()
                && sensors[other].as_ref().and_then(SensorBinding::input) == input
                && signal(&file.sensors[other]) != signal(sensor)
        });
        if let Some(other) = twin {
            let (one, two) = (&file.sensors[other].name, &sensor.name);
            let message = format!("sensors `{one}` and `{two}` drive one input with different values");
            let help = Some("give both the same `active` or `values`, or each an input of its own".to_owned());
            problems.tell(source.error(sensor.variable.span(), "here", message, help));
        }
        sensors.push(binding);
    }
    let sensor_inputs = inputs.len();
    let followed = problems.keep_all(followed(file).map(|followed| b.followed(&followed)));
    for name in file.pose.values() {
        let port = b.input(name, Some(PortKind::Real));
        inputs.extend(problems.keep(port.and_then(|port| b.driven_once(name, port, &inputs))));
    }
    let mut controls = Vec::new();
    for control in &file.controls {
        if let Some((port, values)) = problems.keep(b.control(control, &inputs)) {
            controls.push(values);
            inputs.push(port);
        }
    }
    let mut constants = Vec::new();
    for (name, literal) in &file.inputs {
        if let Some((port, value)) = problems.keep(b.constant(&named(name, literal), *literal.get_ref(), &inputs)) {
            constants.push(value);
            inputs.push(port);
        }
    }
    let parameters = file.parameters.iter();
    let parameters =
        problems.keep_all(parameters.map(|(name, literal)| b.parameter(&named(name, literal), *literal.get_ref())));
    for (name, limits) in &file.explain.parameters {
        let _ = problems.keep(b.limited(&named(name, limits), limits.get_ref()));
    }
    let mirrors = b.mirrors.iter().filter_map(|(first, other)| {
        inputs.iter().position(|input| input == first).map(|column| (column, other.clone()))
    });
    let mirrors: Vec<(usize, UnitPort)> = mirrors.collect();
    for (place, (_, port)) in mirrors.iter().enumerate() {
        if inputs.contains(port) || mirrors[..place].iter().any(|(_, other)| other == port) {
            let message = format!("`{}:{}` is driven by two things at once", units[port.unit].name, port.port.name);
            let help = "an input of the system drives it too: remove one of the two".to_owned();
            problems.tell(source.error(0..0, "in this file", message, Some(help)));
        }
    }
    let driven: Vec<UnitPort> = inputs.iter().chain(mirrors.iter().map(|(_, port)| port)).cloned().collect();
    let mut system = b.system(&driven);
    let mut connections: Vec<Connection> = Vec::new();
    for table in &file.connections {
        let others = connections.iter().chain(&system).map(|c| c.to.clone());
        let taken: Vec<UnitPort> = others.chain(driven.iter().cloned()).collect();
        // A connection of the system may be given a delay.
        if let Some(known) = problems.keep(b.of_system(table, &mut system)) {
            known.unwrap_or_else(|| connections.extend(problems.keep(b.connection(table, &taken))));
        }
    }
    let connections = system::without_loops(units, [system, connections]);
    let parameters = b.system_parameters(&parameters).into_iter().chain(parameters).collect();
    let _ = problems.keep(b.not_written_and_read(&inputs));
    if b.outputs.is_empty() && !file.robots.is_empty() {
        let help = "name the FMU output that moves at least one joint or frame".to_owned();
        let message = "nothing is read from the FMU: no robot could move";
        problems.tell(source.error(0..0, "in this file", message, Some(help)));
    }
    if !b.differentiated.is_empty() {
        b.warnings.push(format!(
            "not given by the FMU, so differentiated from positions: {}. Such a speed is the mean over each step, and lags \
             behind by half a step",
            b.differentiated.join(", ")
        ));
    }
    let unitless = b.unitless.iter().map(|(si, names)| {
        let all: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
        let has = if all.len() == 1 { "has" } else { "have" };
        format!("{} {has} no unit in the FMU: taken as {si}; confirm with unit = \"{si}\"", all.join(", "))
    });
    let unitless: Vec<String> = unitless.collect();
    let binding = Binding {
        parameters,
        inputs,
        sensors: sensors.into_iter().flatten().collect(),
        sensor_inputs,
        controls,
        constants,
        outputs: b.outputs,
        derived: b.derived,
        connections,
        mirrors,
        robots,
        followed,
        warnings: b.warnings.into_iter().chain(unitless).collect(),
    };
    problems.take_or(binding)
}

impl Binding {
    /// The column of an input that a sensor drives or that is held, and the value that it has while the sensor reports somebody, or
    /// that it is not held at: what `name` in the cell file means, a sensor or an FMU input.
    #[must_use]
    pub fn command(&self, cell: &Workcell, name: &str) -> Option<(usize, f64)> {
        if let Some(sensor) = cell.sensors.iter().position(|sensor| sensor.name == name) {
            let column = self.sensors[sensor].input()?;
            return Some((column, cell.sensors[sensor].signal.value(true)));
        }
        let held = cell.file().inputs.keys().position(|input| input == name)?;
        let idle = self.constants.get(held)?;
        Some((self.inputs.len() - self.constants.len() + held, 1.0 - idle))
    }

    /// Numbers in a row: outputs, then what is derived from them.
    #[must_use]
    pub fn columns(&self) -> usize {
        self.outputs.len() + self.derived.iter().map(Derived::columns).sum::<usize>()
    }

    /// Rows of `outputs`, one a step of `step_s` seconds, with what is derived from them. `before` are rows that end with
    /// the one before the first; without them nothing moves in the first.
    #[must_use]
    pub fn rows<'a>(&self, outputs: &'a [f64], before: Option<&[f64]>, step_s: f64) -> Cow<'a, [f64]> {
        let width = self.outputs.len();
        if self.derived.is_empty() {
            return Cow::Borrowed(outputs);
        }
        let mut rows = Vec::with_capacity(outputs.len() / width * self.columns());
        let mut derived = Vec::new();
        let mut before = before.map_or(&outputs[..width], |rows| &rows[rows.len() - width..]);
        for row in outputs.chunks(width) {
            rows.extend_from_slice(row);
            derived.clear();
            self.derived.iter().for_each(|one| one.append(row, before, step_s, &mut derived));
            rows.extend(derived.iter().rev());
            before = row;
        }
        Cow::Owned(rows)
    }

    /// Steps from the FMU's own start on after which every output follows from a step of the FMUs: the first, and as many
    /// more as connections hold values back.
    #[must_use]
    pub fn settled_steps(&self) -> usize {
        1 + self.connections.iter().map(|connection| connection.delay_steps).sum::<usize>()
    }

    /// The same as [`Binding::rows`] for the first rows of a run, of which `unsettled` may follow a row that is no pose of
    /// the robot: outputs after initialisation are often all 0. A speed that is worked out over such a jump is no speed.
    /// The first one after it stands in for it: it is as near in time as any that is known.
    #[must_use]
    pub fn first_rows<'a>(
        &self,
        outputs: &'a [f64],
        before: Option<&[f64]>,
        step_s: f64,
        unsettled: usize,
    ) -> Cow<'a, [f64]> {
        let (width, columns) = (self.outputs.len(), self.columns());
        let mut rows = self.rows(outputs, before, step_s);
        let value = |rows: &[f64], row: usize, column: usize| rows[row * columns + column];
        if rows.len() < (unsettled + 2) * columns {
            return rows;
        }
        let jumped = |row: usize| {
            let column_jumps = |column: usize| {
                let next = [0, 1].map(|after| value(&rows, unsettled + after, column));
                jumps(value(&rows, row, column), next, step_s)
            };
            (width..columns).any(column_jumps)
        };
        if let Some(last) = (0..unsettled).rev().find(|row| jumped(*row)) {
            let from = unsettled * columns;
            let stand_in = rows[from + width..from + columns].to_vec();
            let rows = rows.to_mut();
            for row in 0..=last {
                rows[row * columns + width..(row + 1) * columns].copy_from_slice(&stand_in);
            }
        }
        rows
    }

    /// Of each output, whether it tells where robots are or how fast.
    #[must_use]
    pub fn moves(&self) -> Vec<bool> {
        let mut read = vec![false; self.outputs.len()];
        let mut take = |reader: &Reader| reader.outputs().for_each(|column| read[column] = true);
        for RobotBinding { motion, .. } in &self.robots {
            match motion {
                MotionBinding::Joints { positions, speeds } => positions.iter().chain(speeds).for_each(&mut take),
                MotionBinding::Frames(frames) => {
                    for FrameBinding { position, orientation, velocity, angular_velocity } in frames {
                        position.iter().chain(velocity).chain(angular_velocity).for_each(&mut take);
                        orientation.readers().for_each(&mut take);
                    }
                }
            }
        }
        self.derived.iter().for_each(|derived| match derived {
            Derived::Rate { of, turns: _ } => take(of),
            Derived::Turning { of } => of.readers().for_each(&mut take),
        });
        read
    }

    /// Of each output, whether anything but programme phases is read from it: these name hazards, and harm nobody.
    #[must_use]
    pub fn matters(&self) -> Vec<bool> {
        let mut read = self.moves();
        let mut take = |reader: &Reader| reader.outputs().for_each(|column| read[column] = true);
        for RobotBinding { motion: _, payload, phase: _ } in &self.robots {
            take(payload);
        }
        for sensor in &self.sensors {
            match sensor {
                SensorBinding::Input(_) => {}
                SensorBinding::Output(reader) | SensorBinding::Both { output: reader, .. } => take(reader),
            }
        }
        self.followed.iter().for_each(take);
        read
    }

    /// The setup of the FMUs for this binding.
    #[must_use]
    pub fn setup(&self, names: &[&str], initial_inputs: Vec<f64>, step_s: f64) -> SystemSetup {
        SystemSetup {
            names: names.iter().map(|name| (*name).to_owned()).collect(),
            parameters: self.parameters.clone(),
            inputs: self.inputs.clone(),
            initial_inputs,
            outputs: self.outputs.clone(),
            connections: self.connections.clone(),
            mirrors: self.mirrors.clone(),
            step_s,
            lead_in_steps: 0,
            watched: Vec::new(),
        }
    }
}

/// What the cell file has something follow.
enum Followed<'a> {
    /// A number, as it is.
    Number(&'a Spanned<String>),
    /// A length.
    Length(&'a MovesTable),
}

/// All that a cell file has something follow, in the order of [`Binding::followed`].
fn followed(file: &CellFile) -> impl Iterator<Item = Followed<'_>> {
    fn number(table: &Spanned<WhileTable>) -> Followed<'_> {
        Followed::Number(&table.get_ref().variable)
    }
    fn of_obstacle(obstacle: &ObstacleTable) -> impl Iterator<Item = Followed<'_>> {
        let moves = obstacle.moves_with.as_ref().map(|table| Followed::Length(table.get_ref()));
        obstacle.stands_while.as_ref().map(number).into_iter().chain(moves)
    }
    let sensors = file.sensors.iter().filter_map(|sensor| sensor.counts_while.as_ref().map(number));
    let controls = file.controls.iter().filter_map(|control| control.works_while.as_ref().map(number));
    file.obstacles.iter().flat_map(of_obstacle).chain(sensors).chain(controls)
}

impl<'a> Binder<'a> {
    const fn new(
        source: &'a Source,
        units: &'a [BoundUnit<'a>],
        wiring: Option<&'a Wiring>,
        problems: &'a Problems,
    ) -> Self {
        Self {
            source,
            wiring,
            mirrors: Vec::new(),
            problems,
            units,
            outputs: Vec::new(),
            derived: Vec::new(),
            unitless: BTreeMap::new(),
            differentiated: Vec::new(),
            warnings: Vec::new(),
        }
    }

    /// The type of a variable as its FMU calls it.
    fn type_name(&self, unit: usize, variable: &Variable) -> String {
        variable.type_name(self.units[unit].description.version().unwrap_or(FmiVersion::V2))
    }

    /// A name without the unit in front.
    fn local<'n>(&self, name: &'n str) -> &'n str {
        match self.units {
            [BoundUnit { name: "", .. }] => name,
            _ => name.split_once(':').map_or(name, |(_, local)| local),
        }
    }

    /// Where a sensor's reading goes to or comes from; a new input joins `inputs`.
    fn sensor(&mut self, sensor: &SensorTable, inputs: &mut Vec<UnitPort>) -> Result<SensorBinding, Box<CellError>> {
        if sensor.kind.is_in_fmu() {
            let Some(values) = &sensor.values else {
                return Ok(SensorBinding::Output(self.whole_number(&sensor.variable, "a reported sensor")?));
            };
            let (unit, variable) = self.readable(&sensor.variable)?;
            let port = self.port(&sensor.variable, unit, variable)?;
            self.values(sensor, values, &port)?;
            return Ok(SensorBinding::Output(Reader::output(self.output(port), 1.0)));
        }
        let port = self.input(&sensor.variable, None)?;
        match &sensor.values {
            Some(values) => self.values(sensor, values, &port)?,
            None if port.port.kind != PortKind::Boolean => {
                let name = &port.port.name;
                let message = format!("the input `{name}` of sensor `{}` is a number", sensor.name);
                let help = format!(
                    "say which it is while nobody and while somebody is detected, for instance values = {{ clear = 1, detected = 0 }}; \
                     `fmi-hazard inspect` has the description of `{name}`"
                );
                return Err(self.source.error(sensor.variable.span(), "named here", message, Some(help)));
            }
            None => {}
        }
        let index = inputs.iter().position(|p| *p == port).unwrap_or(inputs.len());
        if index == inputs.len() {
            inputs.push(port);
        }
        let Some(evaluated) = sensor.evaluated.as_ref().map(Spanned::get_ref) else {
            return Ok(SensorBinding::Input(index));
        };
        let output = self.whole_number(&evaluated.variable, "a sensor that the FMU evaluates")?;
        let active = evaluated.active.or_else(|| match signal(sensor)? {
            Signal::Boolean { active } => Some(active),
            Signal::Number { .. } => None,
        });
        Ok(SensorBinding::Both { input: index, output, active: active.unwrap_or_default() })
    }

    /// Whether a sensor's variable can have the values that are said of it, and is no Boolean.
    fn values(
        &mut self,
        sensor: &SensorTable,
        values: &Spanned<ValuesTable>,
        port: &UnitPort,
    ) -> Result<(), Box<CellError>> {
        if port.port.kind == PortKind::Boolean {
            let message = format!("`{}` is true or false, and has no other values", port.port.name);
            let help = Some("say with `active` which of the two it is while somebody is detected".to_owned());
            return Err(self.source.error(values.span(), "given here", message, help));
        }
        let ValuesTable { clear, detected } = *values.get_ref();
        for value in [clear, detected] {
            self.literal(&sensor.variable, &port.port, Literal::Number(value))?;
            self.within_limits(port, value);
        }
        Ok(())
    }

    /// What obstacles and sensors follow.
    fn followed(&mut self, followed: &Followed<'_>) -> Result<Reader, Box<CellError>> {
        match followed {
            Followed::Number(name) => {
                let (unit, variable) = self.readable(name)?;
                let port = self.port(name, unit, variable)?;
                Ok(Reader::output(self.output(port), 1.0))
            }
            Followed::Length(MovesTable { variable, unit, .. }) => {
                let factor = self.factor(variable, unit.as_ref(), Quantity::Length)?;
                Ok(Reader::output(self.real_output(variable)?, factor))
            }
        }
    }

    /// The input that a control drives, and its values, released and pressed.
    fn control(&mut self, control: &ControlTable, taken: &[UnitPort]) -> Result<(UnitPort, [f64; 2]), Box<CellError>> {
        let name = &control.variable;
        let port = self.input(name, None)?;
        let port = self.driven_once(name, port, taken)?;
        let mut values = [0.0; 2];
        for (value, (given, pressed)) in values.iter_mut().zip([(&control.released, false), (&control.pressed, true)]) {
            let usual = match port.port.kind {
                PortKind::Boolean => Literal::Bool(pressed),
                _ => Literal::Number(f64::from(u8::from(pressed))),
            };
            let literal = given.as_ref().map_or(usual, |given| *given.get_ref());
            *value = self.literal(name, &port.port, literal)?;
            self.within_limits(&port, *value);
        }
        if values[0].to_bits() == values[1].to_bits() {
            let message = format!("control `{}` has one value, pressed or not", control.name);
            let help = Some("give `released` and `pressed` different values".to_owned());
            return Err(self.source.error(name.span(), "here", message, help));
        }
        Ok((port, values))
    }

    /// An input that is held constant.
    fn constant(
        &mut self,
        name: &Spanned<String>,
        literal: Literal,
        taken: &[UnitPort],
    ) -> Result<(UnitPort, f64), Box<CellError>> {
        let port = self.input(name, None)?;
        let port = self.driven_once(name, port, taken)?;
        let value = self.literal(name, &port.port, literal)?;
        self.within_limits(&port, value);
        Ok((port, value))
    }

    fn parameter(&mut self, name: &Spanned<String>, literal: Literal) -> Result<(UnitPort, f64), Box<CellError>> {
        let (unit, variable) = self.find(name)?;
        if variable.causality != Causality::Parameter {
            let message = format!("`{}` is not a parameter of {}", name.get_ref(), self.units[unit].file);
            let help = Some("inputs belong under [inputs]".to_owned());
            return Err(self.source.error(name.span(), "here", message, help));
        }
        let port = self.port(name, unit, variable)?;
        let value = self.literal(name, &port.port, literal)?;
        self.within_limits(&port, value);
        Ok((port, value))
    }

    /// Whether `explain` may be told about a parameter, and so.
    fn limited(&self, name: &Spanned<String>, limits: &ParameterLimits) -> Result<(), Box<CellError>> {
        let (unit, variable) = self.find(name)?;
        let refused = |message: String, help: String| Err(self.source.error(name.span(), "here", message, Some(help)));
        if variable.causality != Causality::Parameter {
            let message = format!("`{}` is not a parameter of {}", name.get_ref(), self.units[unit].file);
            return refused(message, "`explain` changes parameters alone".to_owned());
        }
        let own = &self.units[unit].name;
        let known = if own.is_empty() { variable.name.clone() } else { format!("{own}:{}", variable.name) };
        if known != *name.get_ref() {
            return refused(format!("`{}` is another name of `{known}`", name.get_ref()), "write that one".to_owned());
        }
        let whole = matches!(variable.kind, VariableType::Boolean { .. });
        if whole && !limits.fixed {
            let message = format!("`{known}` is a truth value, which has no range");
            return refused(message, "write `fixed = true`, or remove it".to_owned());
        }
        Ok(())
    }

    /// Refuses an input that something else drives already.
    fn driven_once(
        &self,
        name: &Spanned<String>,
        port: UnitPort,
        taken: &[UnitPort],
    ) -> Result<UnitPort, Box<CellError>> {
        if !taken.contains(&port) {
            return Ok(port);
        }
        let message = format!("`{}` is driven by two things at once", name.get_ref());
        let help = Some("a sensor, the pose, a control, a constant or a connection: remove one of the two".to_owned());
        Err(self.source.error(name.span(), "here", message, help))
    }

    /// Refuses results that are nothing but what is written: some exports give an output and an input one value
    /// reference.
    fn not_written_and_read(&self, inputs: &[UnitPort]) -> Result<(), Box<CellError>> {
        let handle = |p: &UnitPort| (p.unit, p.port.handle.value_reference, p.port.handle.scalar);
        for output in &self.outputs {
            if let Some(input) = inputs.iter().find(|input| handle(input) == handle(output)) {
                let message = format!(
                    "`{}` and `{}` are one variable in the FMU (value reference {}): reading the one gives what was \
                     written to the other",
                    output.port.name, input.port.name, output.port.handle.value_reference
                );
                let help =
                    Some("use another output, or have the FMU exported with a value reference for each".to_owned());
                return Err(self.source.error(0..0, "in this file", message, help));
            }
        }
        Ok(())
    }

    /// A word about a value that the FMU's own limits forbid; some FMUs stop over one.
    fn within_limits(&mut self, port: &UnitPort, value: f64) {
        let found = self.units[port.unit].description.element(&port.port.name);
        let Some(VariableType::Real { min, max, .. }) = found.map(|(variable, _, _)| &variable.kind) else { return };
        let (low, high) = (min.unwrap_or(f64::NEG_INFINITY), max.unwrap_or(f64::INFINITY));
        if value < low || value > high {
            let name = &port.port.name;
            self.warnings.push(format!("`{name}` is set to {value}, the FMU allows {low} to {high}"));
        }
    }
}
