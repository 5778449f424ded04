//! Names of the cell file to variables of the FMUs: existence, direction, type, unit.

use toml::Spanned;

use super::reading::Column;
use super::{Binder, BoundUnit, Reader, named};
use crate::cell::CellError;
use crate::cell::error::nearest;
use crate::cell::file::format::{Literal, VariableTable};
use crate::fmi::{Causality, Variable, VariableType, number};
use crate::host::port::{Port, PortKind};
use crate::host::system::UnitPort;

/// What a bound output measures, with the units that can stand for it and their SI factors.
#[derive(Clone, Copy)]
pub(super) enum Quantity {
    Angle,
    AngularSpeed,
    Mass,
    Length,
    Speed,
    Duration,
    Number,
}

/// What a value in unit `a` is multiplied by for unit `b`; nothing if they are no units of one quantity.
pub(super) fn ratio(a: &str, b: &str) -> Option<f64> {
    let factor = |quantity: Quantity, of: &str| quantity.units().iter().find(|(name, _)| *name == of).map(|(_, f)| *f);
    Quantity::ALL.into_iter().find_map(|quantity| Some(factor(quantity, a)? / factor(quantity, b)?))
}

/// The unit that an FMU gives a variable.
pub(super) fn declared(variable: &Variable) -> Option<&str> {
    match &variable.kind {
        VariableType::Real { unit, .. } => unit.as_deref(),
        _ => None,
    }
}

/// Whether the FMU defines the unit of `variable` as something to compute with. One with a factor of 0, or of no number, may
/// stand for anything. If not: what is wrong, and what to do.
pub(super) fn sound(fmu: &BoundUnit<'_>, variable: &Variable) -> Result<(), (String, String)> {
    let Some(unit) = declared(variable) else { return Ok(()) };
    let factor = fmu.description.units.get(unit).copied().unwrap_or(1.0);
    if factor.is_finite() && factor != 0.0 {
        return Ok(());
    }
    let message = format!(
        "`{}` is in `{unit}`, which modelDescription.xml defines with the factor {}: nothing can be converted with that",
        variable.name,
        number(factor)
    );
    let help = format!(
        "have the FMU exported with a right <BaseUnit> of `{unit}`; where the cell file can give a unit, unit = \"{unit}\" \
         says what is meant"
    );
    Err((message, help))
}

impl Quantity {
    const ALL: [Self; 7] =
        [Self::Angle, Self::AngularSpeed, Self::Mass, Self::Length, Self::Speed, Self::Duration, Self::Number];

    fn units(self) -> &'static [(&'static str, f64)] {
        const DEG: f64 = std::f64::consts::PI / 180.0;
        const RPM: f64 = std::f64::consts::PI / 30.0;
        match self {
            Self::Angle => &[("rad", 1.0), ("deg", DEG), ("mrad", 1e-3)],
            Self::AngularSpeed => &[("rad/s", 1.0), ("deg/s", DEG), ("rpm", RPM), ("1/min", RPM)],
            Self::Mass => &[("kg", 1.0), ("g", 1e-3)],
            Self::Length => &[("m", 1.0), ("mm", 1e-3), ("cm", 1e-2)],
            Self::Speed => &[("m/s", 1.0), ("mm/s", 1e-3)],
            Self::Duration => &[("s", 1.0), ("ms", 1e-3)],
            Self::Number => &[("1", 1.0)],
        }
    }
}

impl<'a> Binder<'a> {
    /// The FMU and variable that a name of the cell file means.
    pub(super) fn find(&self, name: &Spanned<String>) -> Result<(usize, &'a Variable), Box<CellError>> {
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
            || "`fmi-hazard inspect --locals` lists the FMU's variables".to_owned(),
            |v| format!("did you mean `{}`? ({}, {})", v.name, v.causality, self.type_name(unit, v)),
        );
        Err(self.source.error(
            name.span(),
            "named here",
            format!("variable `{wanted}` is not in {}", self.units[unit].file),
            Some(help),
        ))
    }

    pub(super) fn port(
        &self,
        name: &Spanned<String>,
        unit: usize,
        variable: &Variable,
    ) -> Result<UnitPort, Box<CellError>> {
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
    pub(super) fn input(
        &mut self,
        name: &Spanned<String>,
        wanted: Option<PortKind>,
    ) -> Result<UnitPort, Box<CellError>> {
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

    pub(super) fn literal(&self, name: &Spanned<String>, port: &Port, literal: Literal) -> Result<f64, Box<CellError>> {
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
    pub(super) fn output(&mut self, port: UnitPort) -> usize {
        self.outputs.iter().position(|p| *p == port).unwrap_or_else(|| {
            self.outputs.push(port);
            self.outputs.len() - 1
        })
    }

    pub(super) fn readable(&self, name: &Spanned<String>) -> Result<(usize, &'a Variable), Box<CellError>> {
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
            Some("`fmi-hazard inspect --locals` lists outputs and locals".to_owned()),
        ))
    }

    pub(super) fn whole_number(&mut self, name: &Spanned<String>, what: &str) -> Result<Reader, Box<CellError>> {
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
        Ok(Reader::output(self.output(port), 1.0))
    }

    pub(super) fn reader(&mut self, table: &VariableTable, quantity: Quantity) -> Result<Reader, Box<CellError>> {
        let factor = self.factor(&table.variable, table.unit.as_ref(), quantity)?;
        if table.sign.abs() != 1.0 {
            let message = format!("sign is {}, it can only be 1 or -1", number(table.sign));
            let help = Some("a coupled axis with another factor stands under `plus`".to_owned());
            return Err(self.source.error(table.variable.span(), "for this variable", message, help));
        }
        let mut terms = vec![(Column::Output(self.real_output(&table.variable)?), table.sign * factor)];
        for (name, weight) in &table.plus {
            let name = &named(name, weight);
            let weight = weight.get_ref();
            let factor = self.factor(name, table.unit.as_ref(), quantity)?;
            terms.push((Column::Output(self.real_output(name)?), weight * factor));
        }
        if table.offset_deg != 0.0 && !matches!(quantity, Quantity::Angle) {
            let message = "offset_deg is for angles".to_owned();
            let help = "remove it here; a slide with another zero has it in the `origin` of its joint".to_owned();
            return Err(self.source.error(table.variable.span(), "for this variable", message, Some(help)));
        }
        let offset = match quantity {
            Quantity::Angle => table.offset_deg.to_radians(),
            _ => 0.0,
        };
        Ok(Reader { terms, offset })
    }

    pub(super) fn real_output(&mut self, name: &Spanned<String>) -> Result<usize, Box<CellError>> {
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
    pub(super) fn factor(
        &mut self,
        name: &Spanned<String>,
        unit: Option<&Spanned<String>>,
        quantity: Quantity,
    ) -> Result<f64, Box<CellError>> {
        let units = quantity.units();
        let known = |u: &str| units.iter().find(|(n, _)| *n == u).map(|(_, f)| *f);
        let list = || units.iter().map(|(n, _)| *n).collect::<Vec<_>>().join(", ");
        let (unit_number, variable) = self.find(name)?;
        let declared = declared(variable);
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
        sound(&self.units[unit_number], variable)
            .map_err(|(message, help)| self.source.error(name.span(), "named here", message, Some(help)))?;
        match declared {
            Some(declared) => known(declared).ok_or_else(|| {
                let message = format!("`{}` is in `{declared}`, which does not fit here", variable.name);
                self.source.error(name.span(), "named here", message, Some(format!("usable units: {}", list())))
            }),
            None if matches!(quantity, Quantity::Number) => Ok(1.0),
            None => {
                let si = units[0].0;
                let names = self.unitless.entry(si).or_default();
                if !names.contains(&variable.name) {
                    names.push(variable.name.clone());
                }
                Ok(1.0)
            }
        }
    }
}

/// Whether the port's integer type can hold `v`.
fn fits(port: &Port, v: f64) -> bool {
    #[expect(clippy::cast_possible_truncation, reason = "saturates, and no range reaches that far")]
    port.handle.scalar.range().is_none_or(|(low, high)| (low..=high).contains(&(v as i128)))
}
