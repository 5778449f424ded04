//! Names in the cell file to variables of the FMU: existence, direction, type and unit are checked, and each quantity
//! the simulation needs becomes a [`Reader`] over the FMU's bound outputs.

use std::borrow::Cow;

use toml::Spanned;

use super::CellError;
use super::error::{Problems, Source, nearest};
use super::find::Wiring;
use super::format::{
    CellFile, ConnectionTable, FrameTable, JointTable, Literal, RobotTable, SensorKind, SensorTable, VariableTable,
};
use super::sensors::fail_safe;
use super::ssp::{Link, Structure};
use crate::fmi::{Causality, FmiVersion, ModelDescription, Variable, VariableType};
use crate::geometry::{Matrix3, Rotation, Vec3};
use crate::host::port::{Port, PortKind};
use crate::host::system::{AlgebraicLoop, Connection, SystemSetup, UnitPort};

/// Which FMU variables are written and read, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Binding {
    /// Parameters set before initialisation.
    pub parameters: Vec<(UnitPort, f64)>,
    /// Inputs written at every step: first the distinct sensor variables, then the person's pose, then the constants.
    pub inputs: Vec<UnitPort>,
    /// For each sensor, the index of its input, or how to read it.
    pub sensors: Vec<SensorBinding>,
    /// Number of distinct inputs driven by sensors.
    pub sensor_inputs: usize,
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

/// How a part is turned, in the base frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Orientation {
    /// Not known: the part is a point.
    Unknown,
    /// Quaternion w, x, y, z.
    Quaternion(Box<[Reader; 4]>),
    /// Rotation matrix, row by row.
    Matrix(Box<[[Reader; 3]; 3]>),
}

impl Orientation {
    /// `base_from_frame` in one row of outputs.
    #[must_use]
    pub fn read(&self, outputs: &[f64]) -> Rotation {
        match self {
            Self::Unknown => Rotation::IDENTITY,
            Self::Quaternion(readers) => {
                let [w, x, y, z] = readers.each_ref().map(|r| r.read(outputs));
                Rotation::from_xyzw(x, y, z, w).normalize()
            }
            Self::Matrix(readers) => {
                let rows = readers.each_ref().map(|row| row.each_ref().map(|r| r.read(outputs)));
                from_matrix(rows).normalize()
            }
        }
    }
}

/// What is worked out from outputs of two steps one after the other: their backward difference, so the mean over the step.
#[derive(Clone, Debug, PartialEq)]
pub enum Derived {
    /// Change of a value per second.
    Rate {
        /// The value.
        of: Reader,
        /// Whether it is an angle, which may jump by full turns.
        turns: bool,
    },
    /// Angular velocity x, y, z of what is turned so.
    Turning {
        /// How it is turned.
        of: Orientation,
    },
}

impl Derived {
    /// How many columns it has.
    const fn columns(&self) -> usize {
        match self {
            Self::Rate { .. } => 1,
            Self::Turning { .. } => 3,
        }
    }

    fn append(&self, now: &[f64], before: &[f64], step_s: f64, to: &mut Vec<f64>) {
        match self {
            Self::Rate { of, turns } => {
                let change = of.read(now) - of.read(before);
                let whole = if *turns { (change / std::f64::consts::TAU).round() } else { 0.0 };
                to.push((change - whole * std::f64::consts::TAU) / step_s);
            }
            Self::Turning { of } => {
                let turned = of.read(now) * of.read(before).inverse();
                // The shorter way: a quaternion and its negative are one rotation.
                let sign = if turned.w < 0.0 { -1.0 } else { 1.0 };
                let vector = Vec3::new(turned.x, turned.y, turned.z) * sign;
                let sin = vector.length();
                let angle = 2.0 * libm::atan2(sin, turned.w * sign);
                let per_s = if sin > 0.0 { angle / (sin * step_s) } else { 0.0 };
                to.extend((vector * per_s).to_array());
            }
        }
    }
}

/// The rotation of a matrix, given row by row.
fn from_matrix(rows: [[f64; 3]; 3]) -> Rotation {
    Rotation::from_mat3(&Matrix3::from_cols_array_2d(&rows).transpose())
}

/// A linear combination of bound outputs: `offset + sum(factor * output)`, SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reader {
    terms: Vec<(usize, f64)>,
    offset: f64,
}

/// In a term: the column is counted from the first that is derived.
const DERIVED: usize = 1 << 32;

impl MotionBinding {
    /// Every reader.
    fn readers(&mut self) -> Vec<&mut Reader> {
        match self {
            Self::Joints { positions, speeds } => positions.iter_mut().chain(speeds).collect(),
            Self::Frames(frames) => {
                frames.iter_mut().flat_map(|f| f.velocity.iter_mut().chain(&mut f.angular_velocity)).collect()
            }
        }
    }

    /// Puts what is derived behind so many outputs.
    fn settle(&mut self, outputs: usize) {
        for (column, _) in self.readers().into_iter().flat_map(|reader| &mut reader.terms) {
            if *column >= DERIVED {
                *column = *column - DERIVED + outputs;
            }
        }
    }
}

impl Reader {
    /// The value of a column that is derived.
    fn derived(column: usize) -> Self {
        Self { terms: vec![(DERIVED + column, 1.0)], offset: 0.0 }
    }

    /// The value in one row of outputs.
    #[must_use]
    pub fn read(&self, outputs: &[f64]) -> f64 {
        self.terms.iter().fold(self.offset, |sum, &(i, factor)| sum + factor * outputs[i])
    }
}

/// What a bound output measures, with the units that can stand for it and their SI factors.
#[derive(Clone, Copy)]
enum Quantity {
    Angle,
    AngularSpeed,
    Mass,
    Length,
    Speed,
    Number,
}

impl Quantity {
    fn units(self) -> &'static [(&'static str, f64)] {
        const DEG: f64 = std::f64::consts::PI / 180.0;
        const RPM: f64 = std::f64::consts::PI / 30.0;
        match self {
            Self::Angle => &[("rad", 1.0), ("deg", DEG), ("mrad", 1e-3)],
            Self::AngularSpeed => &[("rad/s", 1.0), ("deg/s", DEG), ("rpm", RPM), ("1/min", RPM)],
            Self::Mass => &[("kg", 1.0), ("g", 1e-3)],
            Self::Length => &[("m", 1.0), ("mm", 1e-3)],
            Self::Speed => &[("m/s", 1.0), ("mm/s", 1e-3)],
            Self::Number => &[("1", 1.0)],
        }
    }
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
    let mut b = Binder {
        source,
        wiring,
        mirrors: Vec::new(),
        problems,
        units,
        outputs: Vec::new(),
        derived: Vec::new(),
        warnings: Vec::new(),
    };
    let mut robots: Vec<RobotBinding> = file.robots.iter().filter_map(|robot| b.robot(robot)).collect();
    let mut inputs: Vec<UnitPort> = Vec::new();
    let mut sensors: Vec<Option<SensorBinding>> = Vec::new();
    for (number, sensor) in file.sensors.iter().enumerate() {
        let binding = problems.keep(b.sensor(sensor, &mut inputs));
        let twin = (0..number).find(|&other| {
            matches!(binding, Some(SensorBinding::Input(_)))
                && sensors[other] == binding
                && polarity(&file.sensors[other]) != polarity(sensor)
        });
        if let Some(other) = twin {
            let (one, two) = (&file.sensors[other].name, &sensor.name);
            let message = format!("sensors `{one}` and `{two}` drive one input with opposite polarity");
            let help = Some("give both the same `active`, or each an input of its own".to_owned());
            let _ = problems.keep(Err::<(), _>(source.error(sensor.variable.span(), "here", message, help)));
        }
        sensors.push(binding);
    }
    let sensor_inputs = inputs.len();
    for name in file.pose.values() {
        let port = b.input(name, Some(PortKind::Real));
        inputs.extend(problems.keep(port.and_then(|port| b.driven_once(name, port, &inputs))));
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
    let mirrors = b.mirrors.iter().filter_map(|(first, other)| {
        inputs.iter().position(|input| input == first).map(|column| (column, other.clone()))
    });
    let mirrors: Vec<(usize, UnitPort)> = mirrors.collect();
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
    let connections = without_loops(units, [system, connections]);
    let parameters = b.system_parameters(&parameters).into_iter().chain(parameters).collect();
    let _ = problems.keep(b.not_written_and_read(&inputs));
    // What is derived stands behind all outputs, whose number is known only now.
    robots.iter_mut().for_each(|robot| robot.motion.settle(b.outputs.len()));
    let binding = Binding {
        parameters,
        inputs,
        sensors: sensors.into_iter().flatten().collect(),
        sensor_inputs,
        constants,
        outputs: b.outputs,
        derived: b.derived,
        connections,
        mirrors,
        robots,
        warnings: b.warnings,
    };
    problems.take_or(binding)
}

impl Binding {
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
        let mut before = before.map_or(&outputs[..width], |rows| &rows[rows.len() - width..]);
        for row in outputs.chunks(width) {
            rows.extend_from_slice(row);
            self.derived.iter().for_each(|derived| derived.append(row, before, step_s, &mut rows));
            before = row;
        }
        Cow::Owned(rows)
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
        }
    }
}

impl<'a> Binder<'a> {
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
        if sensor.kind == SensorKind::Reported {
            return Ok(SensorBinding::Output(self.whole_number(&sensor.variable, "a reported sensor")?));
        }
        let port = self.input(&sensor.variable, Some(PortKind::Boolean))?;
        let index = inputs.iter().position(|p| *p == port).unwrap_or(inputs.len());
        if index == inputs.len() {
            inputs.push(port);
        }
        Ok(SensorBinding::Input(index))
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

    fn robot(&mut self, table: &Spanned<RobotTable>) -> Option<RobotBinding> {
        let (robot, problems) = (table.get_ref(), self.problems);
        let motion = if robot.frames.is_empty() {
            let joints = robot.joints.iter().filter_map(|joint| problems.keep(self.joint(joint)));
            let (positions, speeds) = joints.unzip();
            MotionBinding::Joints { positions, speeds }
        } else {
            MotionBinding::Frames(problems.keep_all(robot.frames.iter().map(|f| self.frame(f))))
        };
        let payload = problems.keep(self.payload(table));
        let phase = robot.phase.as_ref().map(|name| self.whole_number(name, "the programme phase")).transpose();
        Some(RobotBinding { motion, payload: payload?, phase: problems.keep(phase)? })
    }

    fn payload(&mut self, table: &Spanned<RobotTable>) -> Result<Reader, Box<CellError>> {
        let robot = table.get_ref();
        match (&robot.payload_kg, &robot.payload) {
            (Some(kg), None) => Ok(Reader { terms: Vec::new(), offset: *kg.get_ref() }),
            (None, Some(table)) => self.reader(table, Quantity::Mass),
            _ => {
                let message = "the robot needs either `payload_kg` (a number) or `payload` (an FMU output)";
                let help = Some("a robot that carries nothing has payload_kg = 0".to_owned());
                Err(self.source.error(table.span(), "this robot", message, help))
            }
        }
    }

    /// Position and speed of a joint.
    fn joint(&mut self, joint: &JointTable) -> Result<(Reader, Reader), Box<CellError>> {
        let still = joint.held_deg.map(f64::to_radians).or(joint.held_m);
        if let Some(offset) = still {
            return Ok((Reader { terms: Vec::new(), offset }, Reader::default()));
        }
        let (table, position, speed) = match (&joint.angle, &joint.position) {
            (Some(angle), _) => (angle, Quantity::Angle, Quantity::AngularSpeed),
            (None, Some(position)) => (position, Quantity::Length, Quantity::Speed),
            // Checked before; what is missing there is told there.
            (None, None) => return Ok((Reader::default(), Reader::default())),
        };
        let reader = self.reader(table, position)?;
        let speed = match &joint.speed {
            Some(table) => self.reader(table, speed)?,
            None => {
                let turns = matches!(position, Quantity::Angle);
                self.differentiated(&format!("the speed of joint `{}`", joint.name.get_ref()));
                self.derive(Derived::Rate { of: reader.clone(), turns })
            }
        };
        Ok((reader, speed))
    }

    /// Adds what is derived; a reader of its first column.
    fn derive(&mut self, derived: Derived) -> Reader {
        let column = self.derived.iter().map(Derived::columns).sum();
        self.derived.push(derived);
        Reader::derived(column)
    }

    fn differentiated(&mut self, what: &str) {
        self.warnings.push(format!(
            "{what} is differentiated from its positions: it is the mean over each step, and lags behind by half a step"
        ));
    }

    fn frame(&mut self, frame: &FrameTable) -> Result<FrameBinding, Box<CellError>> {
        let name = frame.name.get_ref();
        let position = self.readers(&frame.position, Quantity::Length)?;
        let orientation = match (&frame.quaternion, &frame.rotation_matrix) {
            (Some(names), _) => Orientation::Quaternion(Box::new(self.readers(names, Quantity::Number)?)),
            (None, Some([a, b, c])) => Orientation::Matrix(Box::new([
                self.readers(a, Quantity::Number)?,
                self.readers(b, Quantity::Number)?,
                self.readers(c, Quantity::Number)?,
            ])),
            (None, None) => Orientation::Unknown,
        };
        let velocity = if let Some(names) = &frame.velocity {
            self.readers(names, Quantity::Speed)?
        } else {
            self.differentiated(&format!("the velocity of frame `{name}`"));
            position.clone().map(|of| self.derive(Derived::Rate { of, turns: false }))
        };
        let angular_velocity = match (&frame.angular_velocity, &orientation) {
            (Some(names), _) => self.readers(names, Quantity::AngularSpeed)?,
            (None, Orientation::Unknown) => std::array::from_fn(|_| Reader::default()),
            (None, _) => {
                self.differentiated(&format!("the angular velocity of frame `{name}`"));
                let Reader { terms, .. } = self.derive(Derived::Turning { of: orientation.clone() });
                let first = terms[0].0 - DERIVED;
                std::array::from_fn(|axis| Reader::derived(first + axis))
            }
        };
        Ok(FrameBinding { position, orientation, velocity, angular_velocity })
    }

    fn readers<const N: usize>(
        &mut self,
        names: &[Spanned<String>; N],
        quantity: Quantity,
    ) -> Result<[Reader; N], Box<CellError>> {
        let mut readers = std::array::from_fn(|_| Reader::default());
        for (reader, name) in readers.iter_mut().zip(names) {
            let factor = self.factor(name, None, quantity)?;
            *reader = Reader { terms: vec![(self.real_output(name)?, factor)], offset: 0.0 };
        }
        Ok(readers)
    }

    fn connection(&mut self, table: &ConnectionTable, taken: &[UnitPort]) -> Result<Connection, Box<CellError>> {
        let (unit, variable) = self.readable(&table.from)?;
        let from = self.port(&table.from, unit, variable)?;
        let to = self.input(&table.to, Some(from.port.kind))?;
        let unit_of = |p: &UnitPort| {
            let found = self.units[p.unit].description.element(&p.port.name);
            found.and_then(|(variable, _, _)| match &variable.kind {
                VariableType::Real { unit, .. } => unit.clone(),
                _ => None,
            })
        };
        if let (Some(a), Some(b)) = (unit_of(&from), unit_of(&to))
            && a != b
        {
            let message = format!("`{}` is in `{a}`, `{}` in `{b}`", table.from.get_ref(), table.to.get_ref());
            let help = Some("connect variables of one unit".to_owned());
            return Err(self.source.error(table.to.span(), "here", message, help));
        }
        let to = self.driven_once(&table.to, to, taken)?;
        Ok(Connection { from, to, delay_steps: usize::from(table.delay_steps), factor: 1.0, offset: 0.0 })
    }

    /// The connections of the system. Problems point into its description.
    fn system(&self, driven: &[UnitPort]) -> Vec<Connection> {
        let Some(Wiring { structure, source, .. }) = self.wiring else { return Vec::new() };
        let mut taken = driven.to_vec();
        let mut connections = Vec::new();
        for link in &structure.links {
            let connection = self.system_link(structure, link, &taken);
            let connection =
                connection.map_err(|(message, help)| source.error(link.place.clone(), "here", message, Some(help)));
            if let Some(connection) = self.problems.keep(connection) {
                taken.push(connection.to.clone());
                connections.push(connection);
            }
        }
        connections
    }

    fn system_link(
        &self,
        structure: &Structure,
        link: &Link,
        taken: &[UnitPort],
    ) -> Result<Connection, (String, String)> {
        let inspect = || "`fmi-hazard inspect` lists the variables of each component".to_owned();
        let end = |(unit, name): &(usize, String), input: bool| {
            let shown = format!("{}.{name}", structure.components[*unit].name);
            let found = self.units[*unit].description.element(name);
            let (variable, _, _) = found.ok_or_else(|| (format!("there is no variable `{shown}`"), inspect()))?;
            let fits = match variable.causality {
                Causality::Input => input,
                Causality::Output | Causality::Local | Causality::CalculatedParameter => !input,
                _ => false,
            };
            if !fits {
                let what = if input { "an input" } else { "an output" };
                return Err((format!("`{shown}` is not {what} of its FMU"), inspect()));
            }
            let at = Spanned::new(0..0, format!("{}:{name}", self.units[*unit].name));
            let port = self.port(&at, *unit, variable);
            port.map(|port| (port, variable)).map_err(|error| (error.message, inspect()))
        };
        let ((from, source), (to, target)) = (end(&link.from, false)?, end(&link.to, true)?);
        if from.port.kind != to.port.kind {
            let (a, b) = (self.type_name(from.unit, source), self.type_name(to.unit, target));
            return Err((format!("{a} is connected with {b}"), "connect variables of one type".to_owned()));
        }
        if taken.contains(&to) {
            let message = format!("`{}.{}` is driven by two things at once", self.units[to.unit].name, to.port.name);
            let help =
                "another connection, or a sensor, the pose or a constant of the cell file: remove one".to_owned();
            return Err((message, help));
        }
        let plain = link.factor == 1.0 && link.offset == 0.0;
        if !plain && from.port.kind != PortKind::Real {
            return Err(("a transformation of what is no Real".to_owned(), "transform Reals only".to_owned()));
        }
        let declared = |variable: &Variable| match &variable.kind {
            VariableType::Real { unit, .. } => unit.clone(),
            _ => None,
        };
        let units = [link.units[0].clone().or(declared(source)), link.units[1].clone().or(declared(target))];
        let converted = match units {
            [Some(a), Some(b)] if a != b && link.converts && plain => {
                let factor = |units: &[(&str, f64)], of: &str| units.iter().find(|(n, _)| *n == of).map(|(_, f)| *f);
                let both = CONVERTIBLE.iter().find_map(|units| Some(factor(units, &a)? / factor(units, &b)?));
                both.ok_or_else(|| {
                    let help = "describe both in <Units> of the system, or give the connection a LinearTransformation";
                    (format!("how `{a}` is converted to `{b}` is not known"), help.to_owned())
                })?
            }
            _ => 1.0,
        };
        Ok(Connection { from, to, delay_steps: 0, factor: link.factor * converted, offset: link.offset })
    }

    /// Gives a connection of the system the delay that the cell file wants; nothing if it is none of the system's.
    fn of_system(&self, table: &ConnectionTable, system: &mut [Connection]) -> Result<Option<()>, Box<CellError>> {
        if self.wiring.is_none() {
            return Ok(None);
        }
        let (unit, variable) = self.readable(&table.from)?;
        let from = self.port(&table.from, unit, variable)?;
        let (unit, variable) = self.find(&table.to)?;
        let to = self.port(&table.to, unit, variable)?;
        let known = system.iter_mut().find(|connection| connection.from == from && connection.to == to);
        Ok(known.map(|connection| connection.delay_steps = usize::from(table.delay_steps)))
    }

    /// The parameters that the system gives and the cell file does not.
    fn system_parameters(&mut self, own: &[(UnitPort, f64)]) -> Vec<(UnitPort, f64)> {
        let Some(wiring) = self.wiring else { return Vec::new() };
        let mut all: Vec<(UnitPort, f64)> = Vec::new();
        for parameter in &wiring.structure.parameters {
            let name = format!("{}:{}", self.units[parameter.component].name, parameter.name);
            let value = self.parameter(&Spanned::new(0..0, name), parameter.value);
            let value = value.map_err(|error| {
                let help = error.help.clone();
                parameter.source.error(parameter.place.clone(), "here", error.message.clone(), help)
            });
            let Some((port, value)) = self.problems.keep(value) else { continue };
            all.retain(|(other, _)| *other != port);
            if own.iter().all(|(other, _)| *other != port) {
                all.push((port, value));
            }
        }
        all
    }

    /// What a name of the system's own connectors stands for.
    fn canonical(&self, name: &Spanned<String>) -> Spanned<String> {
        let variable = || {
            let structure = &self.wiring?.structure;
            let written = name.get_ref();
            let input = structure.inputs.get(written).and_then(|driven| driven.first());
            let (component, variable) = input.or_else(|| structure.outputs.get(written))?;
            Some(format!("{}:{variable}", self.units[*component].name))
        };
        Spanned::new(name.span(), variable().unwrap_or_else(|| name.get_ref().clone()))
    }

    /// Notes what else an input of the system drives.
    fn mirror(&mut self, name: &Spanned<String>, port: &UnitPort) -> Result<(), Box<CellError>> {
        let Some(driven) = self.wiring.and_then(|wiring| wiring.structure.inputs.get(name.get_ref())) else {
            return Ok(());
        };
        for (component, variable) in driven.iter().skip(1) {
            let other = Spanned::new(name.span(), format!("{}:{variable}", self.units[*component].name));
            let other = self.input(&other, Some(port.port.kind))?;
            if !self.mirrors.iter().any(|(_, known)| *known == other) {
                self.mirrors.push((port.clone(), other));
            }
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
        let help = Some("a sensor, the pose, a constant or a connection: remove one of the two".to_owned());
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
                return Err(self.source.error(0..0, "", message, help));
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

    /// The FMU and variable that a name of the cell file means.
    fn find(&self, name: &Spanned<String>) -> Result<(usize, &'a Variable), Box<CellError>> {
        let name = &self.canonical(name);
        let written = name.get_ref().as_str();
        let (unit, wanted) = if let [BoundUnit { name: "", .. }] = self.units {
            (0, written)
        } else {
            let names = || self.units.iter().map(|u| u.name);
            let Some((prefix, wanted)) = written.split_once(':') else {
                let units = names().collect::<Vec<_>>().join(", ");
                let own = self.wiring.map(|wiring| &wiring.structure);
                let own: Vec<&str> =
                    own.into_iter().flat_map(|s| s.inputs.keys().chain(s.outputs.keys())).map(String::as_str).collect();
                let help = match own.as_slice() {
                    [] => format!("write `unit:{written}`; the units are {units}"),
                    own => format!(
                        "write `unit:{written}`, the units being {units}, or one of the system's own: {}",
                        own.join(", ")
                    ),
                };
                let message = format!("`{written}` does not say which FMU it belongs to");
                return Err(self.source.error(name.span(), "named here", message, Some(help)));
            };
            let Some(unit) = names().position(|n| n == prefix) else {
                let help = nearest(prefix, names()).map_or_else(
                    || format!("the units are {}", names().collect::<Vec<_>>().join(", ")),
                    |n| format!("did you mean `{n}`?"),
                );
                let message = format!("there is no unit `{prefix}`");
                return Err(self.source.error(name.span(), "named here", message, Some(help)));
            };
            (unit, wanted)
        };
        let (description, span) = (self.units[unit].description, name.span());
        if let Some((variable, _, _)) = description.element(wanted) {
            return Ok((unit, variable));
        }
        let array = description.variable(wanted.split('[').next().unwrap_or(wanted));
        if let Some(extents) = array.filter(|v| !v.dimensions.is_empty()).and_then(|v| description.extents(v)) {
            let name = array.map_or(wanted, |v| v.name.as_str());
            let join =
                |numbers: &[usize], by: &str| numbers.iter().map(ToString::to_string).collect::<Vec<_>>().join(by);
            let message =
                format!("`{name}` is an array of {} values, `{wanted}` is none of them", join(&extents, " x "));
            let (first, last) = (join(&vec![1; extents.len()], ","), join(&extents, ","));
            let help = Some(format!("name one, from `{name}[{first}]` to `{name}[{last}]`"));
            return Err(self.source.error(span, "named here", message, help));
        }
        let all = description.variables.iter().map(|v| v.name.as_str());
        let help = nearest(wanted, all).and_then(|n| description.variable(n)).map_or_else(
            || "`fmi-hazard inspect` lists the FMU's variables".to_owned(),
            |v| format!("did you mean `{}`? ({}, {})", v.name, v.causality, self.type_name(unit, v)),
        );
        Err(self.source.error(
            name.span(),
            "named here",
            format!("variable `{wanted}` is not in {}", self.units[unit].file),
            Some(help),
        ))
    }

    fn port(&self, name: &Spanned<String>, unit: usize, variable: &Variable) -> Result<UnitPort, Box<CellError>> {
        // Found under this name before, so there is a handle.
        let name = &self.canonical(name);
        let local = self.local(name.get_ref());
        let handle = self.units[unit].description.handle(local);
        let start = variable.numeric_start();
        let port = handle.and_then(|handle| {
            let start = start.get(handle.offset).or(start.first()).copied().unwrap_or(0.0);
            Port::new(local.to_owned(), handle, start)
        });
        port.map(|port| UnitPort { unit, port }).ok_or_else(|| {
            let kind = self.type_name(unit, variable);
            let message = format!("`{}` is a {kind} variable, which cannot be used here", variable.name);
            let help = Some("numbers and truth values can be used: Real, Integer, Boolean and their kin".to_owned());
            self.source.error(name.span(), "named here", message, help)
        })
    }

    /// An input of this type, if one is asked for.
    fn input(&mut self, name: &Spanned<String>, wanted: Option<PortKind>) -> Result<UnitPort, Box<CellError>> {
        let (unit, variable) = self.find(name)?;
        if variable.causality != Causality::Input {
            let message = format!("`{}` is not an input of {}", variable.name, self.units[unit].file);
            return Err(self.source.error(
                name.span(),
                "named here",
                message,
                Some("`fmi-hazard inspect` lists the inputs".to_owned()),
            ));
        }
        let port = self.port(name, unit, variable)?;
        if let Some(wanted) = wanted.filter(|wanted| *wanted != port.port.kind) {
            let message = format!(
                "a {wanted:?} input is needed here, but `{}` is {}",
                variable.name,
                self.type_name(unit, variable)
            );
            return Err(self.source.error(
                name.span(),
                "named here",
                message,
                Some("`fmi-hazard inspect` lists the inputs with their types".to_owned()),
            ));
        }
        self.mirror(name, &port)?;
        Ok(port)
    }

    fn literal(&self, name: &Spanned<String>, port: &Port, literal: Literal) -> Result<f64, Box<CellError>> {
        let wrong = |wanted: &str| {
            let message = format!("`{}` needs {wanted}", port.name);
            let help = Some("write true or false for Booleans, a number for all others".to_owned());
            Err(self.source.error(name.span(), "set here", message, help))
        };
        match (port.kind, literal) {
            (PortKind::Boolean, Literal::Bool(b)) => Ok(f64::from(u8::from(b))),
            (PortKind::Boolean, Literal::Number(_)) => wrong("true or false"),
            (_, Literal::Bool(_)) => wrong("a number"),
            (PortKind::Integer, Literal::Number(v)) if v.fract() != 0.0 => wrong("a whole number"),
            (PortKind::Integer, Literal::Number(v)) if !fits(port, v) => {
                wrong(&format!("a number that its type {} can hold", port.handle.scalar))
            }
            (_, Literal::Number(v)) if !v.is_finite() => wrong("a finite number"),
            (_, Literal::Number(v)) => Ok(v),
        }
    }

    /// Index of `port` among the bound outputs.
    fn output(&mut self, port: UnitPort) -> usize {
        self.outputs.iter().position(|p| *p == port).unwrap_or_else(|| {
            self.outputs.push(port);
            self.outputs.len() - 1
        })
    }

    fn readable(&self, name: &Spanned<String>) -> Result<(usize, &'a Variable), Box<CellError>> {
        let (unit, variable) = self.find(name)?;
        if matches!(variable.causality, Causality::Output | Causality::Local | Causality::CalculatedParameter) {
            return Ok((unit, variable));
        }
        let file = &self.units[unit].file;
        let message = format!("`{}` cannot be read as a result: it is not an output of {file}", variable.name);
        Err(self.source.error(
            name.span(),
            "named here",
            message,
            Some("`fmi-hazard inspect` lists the outputs".to_owned()),
        ))
    }

    fn whole_number(&mut self, name: &Spanned<String>, what: &str) -> Result<Reader, Box<CellError>> {
        let (unit, variable) = self.readable(name)?;
        let port = self.port(name, unit, variable)?;
        if port.port.kind == PortKind::Real {
            let message = format!("{what} must be an Integer or Boolean output, `{}` is Real", variable.name);
            return Err(self.source.error(
                name.span(),
                "named here",
                message,
                Some("`fmi-hazard inspect` lists the outputs with their types".to_owned()),
            ));
        }
        Ok(Reader { terms: vec![(self.output(port), 1.0)], offset: 0.0 })
    }

    fn reader(&mut self, table: &VariableTable, quantity: Quantity) -> Result<Reader, Box<CellError>> {
        let factor = self.factor(&table.variable, table.unit.as_ref(), quantity)?;
        if table.sign.abs() != 1.0 {
            let message = format!("sign is {}, it can only be 1 or -1", table.sign);
            let help = Some("a coupled axis with another factor stands under `plus`".to_owned());
            return Err(self.source.error(table.variable.span(), "for this variable", message, help));
        }
        let mut terms = vec![(self.real_output(&table.variable)?, table.sign * factor)];
        for (name, weight) in &table.plus {
            let name = &named(name, weight);
            let weight = weight.get_ref();
            let factor = self.factor(name, table.unit.as_ref(), quantity)?;
            terms.push((self.real_output(name)?, weight * factor));
        }
        let offset = match quantity {
            Quantity::Angle => table.offset_deg.to_radians(),
            _ => 0.0,
        };
        Ok(Reader { terms, offset })
    }

    fn real_output(&mut self, name: &Spanned<String>) -> Result<usize, Box<CellError>> {
        let (unit, variable) = self.readable(name)?;
        let port = self.port(name, unit, variable)?;
        if port.port.kind != PortKind::Real {
            let message =
                format!("a Real output is needed here, `{}` is {}", variable.name, self.type_name(unit, variable));
            return Err(self.source.error(
                name.span(),
                "named here",
                message,
                Some("`fmi-hazard inspect` lists the outputs with their types".to_owned()),
            ));
        }
        Ok(self.output(port))
    }

    /// SI factor of a variable: from `unit` in the cell, else the FMU's unit, else SI with a warning.
    fn factor(
        &mut self,
        name: &Spanned<String>,
        unit: Option<&Spanned<String>>,
        quantity: Quantity,
    ) -> Result<f64, Box<CellError>> {
        let units = quantity.units();
        let known = |u: &str| units.iter().find(|(n, _)| *n == u).map(|(_, f)| *f);
        let list = || units.iter().map(|(n, _)| *n).collect::<Vec<_>>().join(", ");
        let (_, variable) = self.find(name)?;
        let declared = match &variable.kind {
            VariableType::Real { unit, .. } => unit.as_deref(),
            _ => None,
        };
        if let Some(unit) = unit {
            let Some(factor) = known(unit.get_ref()) else {
                let message = format!("unit `{}` does not fit here", unit.get_ref());
                return Err(self.source.error(unit.span(), "here", message, Some(format!("use one of: {}", list()))));
            };
            if let Some(declared) = declared.filter(|d| d != unit.get_ref()) {
                let message = format!(
                    "the FMU says that `{}` is in `{declared}`, the cell says `{}`",
                    variable.name,
                    unit.get_ref()
                );
                let help = "leave `unit` out to use the FMU's".to_owned();
                return Err(self.source.error(unit.span(), "here", message, Some(help)));
            }
            return Ok(factor);
        }
        match declared {
            Some(declared) => known(declared).ok_or_else(|| {
                let message = format!("`{}` is in `{declared}`, which does not fit here", variable.name);
                self.source.error(name.span(), "named here", message, Some(format!("usable units: {}", list())))
            }),
            None if matches!(quantity, Quantity::Number) => Ok(1.0),
            None => {
                let si = units[0].0;
                self.warnings.push(format!(
                    "`{}` has no unit in the FMU: taken as {si}; confirm with unit = \"{si}\"",
                    variable.name
                ));
                Ok(1.0)
            }
        }
    }
}

/// The connections of a system and of a cell file; where those of the system form a loop, its last ones are held back by a
/// step.
fn without_loops(units: &[BoundUnit<'_>], [mut system, own]: [Vec<Connection>; 2]) -> Vec<Connection> {
    let names: Vec<String> = units.iter().map(|unit| unit.name.to_owned()).collect();
    loop {
        let connections: Vec<Connection> = system.iter().chain(&own).cloned().collect();
        let setup = SystemSetup { names: names.clone(), connections, ..SystemSetup::default() };
        let Err(AlgebraicLoop { units: inside }) = setup.order() else { return setup.connections };
        let within = |c: &&mut Connection| {
            c.delay_steps == 0 && [&c.from, &c.to].iter().all(|end| inside.contains(&names[end.unit]))
        };
        match system.iter_mut().rev().find(within) {
            Some(connection) => connection.delay_steps = 1,
            None => return setup.connections,
        }
    }
}

/// SI factors of units that may be converted into one another.
const CONVERTIBLE: [&[(&str, f64)]; 6] = [
    &[("rad", 1.0), ("deg", std::f64::consts::PI / 180.0), ("mrad", 1e-3)],
    &[("rad/s", 1.0), ("deg/s", std::f64::consts::PI / 180.0), ("rpm", std::f64::consts::PI / 30.0)],
    &[("m", 1.0), ("mm", 1e-3), ("cm", 1e-2)],
    &[("m/s", 1.0), ("mm/s", 1e-3)],
    &[("kg", 1.0), ("g", 1e-3)],
    &[("s", 1.0), ("ms", 1e-3)],
];

/// Value while a person is detected, as far as it is said.
fn polarity(sensor: &SensorTable) -> Option<bool> {
    sensor.active.or_else(|| fail_safe(sensor.variable.get_ref()))
}

/// Whether the port's integer type can hold `v`.
fn fits(port: &Port, v: f64) -> bool {
    #[expect(clippy::cast_possible_truncation, reason = "saturates, and no range reaches that far")]
    port.handle.scalar.range().is_none_or(|(low, high)| (low..=high).contains(&(v as i128)))
}
