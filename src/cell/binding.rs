//! Names in the cell file to variables of the FMU: existence, direction, type and unit are checked, and each quantity
//! the simulation needs becomes a [`Reader`] over the FMU's bound outputs.

use toml::Spanned;

use super::error::{Source, nearest};
use super::format::{Literal, VariableTable};
use super::{CellError, Workcell};
use crate::fmi::{Causality, ModelDescription, Variable, VariableType};
use crate::host::port::{Port, PortKind};

/// Which FMU variables are written and read, and how.
#[derive(Clone, Debug, PartialEq)]
pub struct Binding {
    /// Parameters set before initialisation.
    pub parameters: Vec<(Port, f64)>,
    /// Inputs written at every step: first one a distinct sensor variable, then the constants.
    pub inputs: Vec<Port>,
    /// For each sensor, the index of its input.
    pub sensor_inputs: Vec<usize>,
    /// Values of the constant inputs, following the sensor inputs.
    pub constants: Vec<f64>,
    /// Outputs read after every step.
    pub outputs: Vec<Port>,
    /// Joint angles, rad.
    pub angles: Vec<Reader>,
    /// Joint speeds, rad/s.
    pub speeds: Vec<Reader>,
    /// Payload, kg.
    pub payload: Reader,
    /// Programme phase, a whole number.
    pub phase: Option<Reader>,
    /// Things the user should know, for instance an assumed unit.
    pub warnings: Vec<String>,
}

/// A linear combination of bound outputs: `offset + sum(factor * output)`, SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reader {
    terms: Vec<(usize, f64)>,
    offset: f64,
}

impl Reader {
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
}

impl Quantity {
    fn units(self) -> &'static [(&'static str, f64)] {
        const DEG: f64 = std::f64::consts::PI / 180.0;
        const RPM: f64 = std::f64::consts::PI / 30.0;
        match self {
            Self::Angle => &[("rad", 1.0), ("deg", DEG), ("mrad", 1e-3)],
            Self::AngularSpeed => &[("rad/s", 1.0), ("deg/s", DEG), ("rpm", RPM), ("1/min", RPM)],
            Self::Mass => &[("kg", 1.0), ("g", 1e-3)],
        }
    }
}

/// A map's key with the place of its value, for messages (keys have no place of their own).
fn named<T>(name: &str, value: &Spanned<T>) -> Spanned<String> {
    Spanned::new(value.span(), name.to_owned())
}

struct Binder<'a> {
    source: &'a Source,
    description: &'a ModelDescription,
    fmu: String,
    outputs: Vec<Port>,
    warnings: Vec<String>,
}

/// Binds `cell` to the FMU described by `description` (`fmu` is its name in messages).
///
/// # Errors
/// The first name, type or unit that does not fit, with its line in the cell file.
pub fn bind(
    cell: &Workcell,
    source: &Source,
    description: &ModelDescription,
    fmu: &str,
) -> Result<Binding, Box<CellError>> {
    let mut b = Binder { source, description, fmu: fmu.to_owned(), outputs: Vec::new(), warnings: Vec::new() };
    let file = &cell.file;
    let robot = file.robot.get_ref();
    let mut angles = Vec::new();
    let mut speeds = Vec::new();
    for joint in &robot.joints {
        angles.push(b.reader(&joint.angle, Quantity::Angle)?);
        speeds.push(b.reader(&joint.speed, Quantity::AngularSpeed)?);
    }
    let payload = match (&robot.payload_kg, &robot.payload) {
        (Some(kg), None) => Reader { terms: Vec::new(), offset: *kg.get_ref() },
        (None, Some(table)) => b.reader(table, Quantity::Mass)?,
        _ => {
            let message = "the robot needs either `payload_kg` (a number) or `payload` (an FMU output)";
            let help = Some("a robot that carries nothing has payload_kg = 0".to_owned());
            return Err(source.error(file.robot.span(), "this robot", message, help));
        }
    };
    let phase = robot.phase.as_ref().map(|name| b.whole_number(name)).transpose()?;
    let mut inputs: Vec<Port> = Vec::new();
    let mut sensor_inputs = Vec::new();
    for sensor in &file.sensors {
        let port = b.input(&sensor.variable, true)?;
        let index = inputs.iter().position(|p| *p == port).unwrap_or(inputs.len());
        if index == inputs.len() {
            inputs.push(port);
        } else if let Some(other) = sensor_inputs.iter().position(|&i| i == index) {
            let differs = file.sensors[other].active != sensor.active;
            if differs {
                let message = format!(
                    "sensors `{}` and `{}` drive one input with opposite polarity",
                    file.sensors[other].name, sensor.name
                );
                return Err(source.error(sensor.variable.span(), "here", message, None));
            }
        }
        sensor_inputs.push(index);
    }
    let mut constants = Vec::new();
    for (name, literal) in &file.inputs {
        let name = &named(name, literal);
        let literal = literal.get_ref();
        let port = b.input(name, false)?;
        if inputs.contains(&port) {
            let message = format!("`{}` is driven by a sensor and held constant at once", name.get_ref());
            return Err(source.error(name.span(), "here", message, Some("remove one of the two".to_owned())));
        }
        constants.push(b.literal(name, &port, *literal)?);
        inputs.push(port);
    }
    let mut parameters = Vec::new();
    for (name, literal) in &file.parameters {
        let name = &named(name, literal);
        let literal = literal.get_ref();
        let variable = b.find(name)?;
        if variable.causality != Causality::Parameter {
            let message = format!("`{}` is not a parameter of {fmu}", name.get_ref());
            return Err(source.error(name.span(), "here", message, Some("inputs belong under [inputs]".to_owned())));
        }
        let port = b.port(name, variable)?;
        let value = b.literal(name, &port, *literal)?;
        parameters.push((port, value));
    }
    Ok(Binding {
        parameters,
        inputs,
        sensor_inputs,
        constants,
        outputs: b.outputs,
        angles,
        speeds,
        payload,
        phase,
        warnings: b.warnings,
    })
}

impl<'a> Binder<'a> {
    fn find(&self, name: &Spanned<String>) -> Result<&'a Variable, Box<CellError>> {
        let wanted = name.get_ref().as_str();
        if let Some(variable) = self.description.variable(wanted) {
            return Ok(variable);
        }
        let all = self.description.variables.iter().map(|v| v.name.as_str());
        let help = nearest(wanted, all).and_then(|n| self.description.variable(n)).map_or_else(
            || "`fmi-hazard inspect` lists the FMU's variables".to_owned(),
            |v| format!("did you mean `{}`? ({}, {})", v.name, v.causality, type_name(v)),
        );
        Err(self.source.error(
            name.span(),
            "named here",
            format!("variable `{wanted}` is not in {}", self.fmu),
            Some(help),
        ))
    }

    fn port(&self, name: &Spanned<String>, variable: &Variable) -> Result<Port, Box<CellError>> {
        let kind = match variable.kind {
            VariableType::Real { .. } => PortKind::Real,
            VariableType::Integer { .. } | VariableType::Enumeration { .. } => PortKind::Integer,
            VariableType::Boolean { .. } => PortKind::Boolean,
            _ => {
                let message =
                    format!("`{}` is a {} variable, which cannot be used here", variable.name, type_name(variable));
                return Err(self.source.error(name.span(), "named here", message, None));
            }
        };
        Ok(Port { name: variable.name.clone(), value_reference: variable.value_reference, kind })
    }

    fn input(&self, name: &Spanned<String>, boolean: bool) -> Result<Port, Box<CellError>> {
        let variable = self.find(name)?;
        if variable.causality != Causality::Input {
            let message = format!("`{}` is not an input of {}", variable.name, self.fmu);
            return Err(self.source.error(name.span(), "named here", message, None));
        }
        let port = self.port(name, variable)?;
        if boolean && port.kind != PortKind::Boolean {
            let message =
                format!("a sensor drives a Boolean input, but `{}` is {}", variable.name, type_name(variable));
            return Err(self.source.error(name.span(), "named here", message, None));
        }
        Ok(port)
    }

    fn literal(&self, name: &Spanned<String>, port: &Port, literal: Literal) -> Result<f64, Box<CellError>> {
        let wrong = |wanted: &str| {
            let message = format!("`{}` needs {wanted}", port.name);
            Err(self.source.error(name.span(), "set here", message, None))
        };
        match (port.kind, literal) {
            (PortKind::Boolean, Literal::Bool(b)) => Ok(f64::from(u8::from(b))),
            (PortKind::Boolean, Literal::Number(_)) => wrong("true or false"),
            (_, Literal::Bool(_)) => wrong("a number"),
            (PortKind::Integer, Literal::Number(v)) if v.fract() != 0.0 || v.abs() > f64::from(i32::MAX) => {
                wrong("a whole number")
            }
            (_, Literal::Number(v)) if !v.is_finite() => wrong("a finite number"),
            (_, Literal::Number(v)) => Ok(v),
        }
    }

    /// Index of `port` among the bound outputs.
    fn output(&mut self, port: Port) -> usize {
        self.outputs.iter().position(|p| *p == port).unwrap_or_else(|| {
            self.outputs.push(port);
            self.outputs.len() - 1
        })
    }

    fn readable(&self, name: &Spanned<String>) -> Result<&'a Variable, Box<CellError>> {
        let variable = self.find(name)?;
        if matches!(variable.causality, Causality::Output | Causality::Local | Causality::CalculatedParameter) {
            return Ok(variable);
        }
        let message = format!("`{}` cannot be read as a result: it is not an output of {}", variable.name, self.fmu);
        Err(self.source.error(name.span(), "named here", message, None))
    }

    fn whole_number(&mut self, name: &Spanned<String>) -> Result<Reader, Box<CellError>> {
        let variable = self.readable(name)?;
        let port = self.port(name, variable)?;
        if port.kind == PortKind::Real {
            let message =
                format!("the programme phase must be an Integer or Boolean output, `{}` is Real", variable.name);
            return Err(self.source.error(name.span(), "named here", message, None));
        }
        Ok(Reader { terms: vec![(self.output(port), 1.0)], offset: 0.0 })
    }

    fn reader(&mut self, table: &VariableTable, quantity: Quantity) -> Result<Reader, Box<CellError>> {
        let factor = self.factor(&table.variable, table.unit.as_ref(), quantity)?;
        if table.sign.abs() != 1.0 {
            let message = format!("sign is {}, it can only be 1 or -1", table.sign);
            return Err(self.source.error(table.variable.span(), "for this variable", message, None));
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
            Quantity::AngularSpeed | Quantity::Mass => 0.0,
        };
        Ok(Reader { terms, offset })
    }

    fn real_output(&mut self, name: &Spanned<String>) -> Result<usize, Box<CellError>> {
        let variable = self.readable(name)?;
        let port = self.port(name, variable)?;
        if port.kind != PortKind::Real {
            let message = format!("a Real output is needed here, `{}` is {}", variable.name, type_name(variable));
            return Err(self.source.error(name.span(), "named here", message, None));
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
        let variable = self.find(name)?;
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

fn type_name(variable: &Variable) -> &'static str {
    match variable.kind {
        VariableType::Real { .. } => "Real",
        VariableType::Integer { .. } => "Integer",
        VariableType::Boolean { .. } => "Boolean",
        VariableType::Enumeration { .. } => "Enumeration",
        _ => "String",
    }
}
