//! Connections between FMUs: those of the cell file, and those that a system brings with its parameters and its own names.

use toml::Spanned;

use super::lookup::{declared, ratio, sound};
use super::{Binder, BoundUnit};
use crate::cell::CellError;
use crate::cell::file::format::{ConnectionTable, Literal};
use crate::cell::foreign::ssp::{Link, Parameter, Structure, Wiring};
use crate::fmi::Causality;
use crate::host::port::PortKind;
use crate::host::system::{AlgebraicLoop, Connection, SystemSetup, UnitPort};

impl Binder<'_> {
    pub(super) fn connection(
        &mut self,
        table: &ConnectionTable,
        taken: &[UnitPort],
    ) -> Result<Connection, Box<CellError>> {
        let (unit, variable) = self.readable(&table.from)?;
        let from = self.port(&table.from, unit, variable)?;
        let to = self.input(&table.to, Some(from.port.kind))?;
        if self.mirrors.iter().any(|(first, _)| *first == to) {
            let message = format!("`{}` of the system drives several variables", table.to.get_ref());
            let help = "connect each of them by itself, as component:variable".to_owned();
            return Err(self.source.error(table.to.span(), "here", message, Some(help)));
        }
        let unit_of = |p: &UnitPort| {
            let found = self.units[p.unit].description.element(&p.port.name);
            found.and_then(|(variable, _, _)| declared(variable))
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
    pub(super) fn system(&self, driven: &[UnitPort]) -> Vec<Connection> {
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

    pub(super) fn system_link(
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
        let unit = |number: usize, variable| link.units[number].as_deref().or(declared(variable));
        let converted = match [unit(0, source), unit(1, target)] {
            [Some(a), Some(b)] if a != b && link.converts => {
                sound(&self.units[from.unit], source)?;
                sound(&self.units[to.unit], target)?;
                ratio(a, b).ok_or_else(|| {
                    let help = "describe both in <Units> of the system, or give the connection a LinearTransformation";
                    (format!("how `{a}` is converted to `{b}` is not known"), help.to_owned())
                })?
            }
            _ => 1.0,
        };
        Ok(Connection { from, to, delay_steps: 0, factor: link.factor * converted, offset: link.offset })
    }

    /// Gives a connection of the system the delay that the cell file wants; nothing if it is none of the system's.
    pub(super) fn of_system(
        &self,
        table: &ConnectionTable,
        system: &mut [Connection],
    ) -> Result<Option<()>, Box<CellError>> {
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
    pub(super) fn system_parameters(&mut self, own: &[(UnitPort, f64)]) -> Vec<(UnitPort, f64)> {
        let Some(wiring) = self.wiring else { return Vec::new() };
        let mut all: Vec<(UnitPort, f64)> = Vec::new();
        for parameter in &wiring.structure.parameters {
            let name = format!("{}:{}", self.units[parameter.component].name, parameter.name);
            let value = self.in_unit(parameter).and_then(|value| self.parameter(&Spanned::new(0..0, name), value));
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

    /// A parameter's value in the unit of its variable.
    fn in_unit(&self, parameter: &Parameter) -> Result<Literal, Box<CellError>> {
        let found = self.units[parameter.component].description.element(&parameter.name);
        let Some((variable, _, _)) = found else { return Ok(parameter.value) };
        match (&parameter.unit, declared(variable), parameter.value) {
            (Some(a), Some(b), Literal::Number(value)) if a != b => {
                let factor = sound(&self.units[parameter.component], variable).and_then(|()| {
                    let unknown = || {
                        (format!("how `{a}` is converted to `{b}` is not known"), format!("give the value in `{b}`"))
                    };
                    ratio(a, b).ok_or_else(unknown)
                });
                let wrong =
                    |(message, help)| parameter.source.error(parameter.place.clone(), "here", message, Some(help));
                Ok(Literal::Number(value * factor.map_err(wrong)?))
            }
            (.., value) => Ok(value),
        }
    }

    /// What a name of the system's own connectors stands for.
    pub(super) fn canonical(&self, name: &Spanned<String>) -> Spanned<String> {
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
    pub(super) fn mirror(&mut self, name: &Spanned<String>, port: &UnitPort) -> Result<(), Box<CellError>> {
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
}

/// The connections of a system and of a cell file; where those of the system form a loop, its last ones are held back by a
/// step.
pub(super) fn without_loops(units: &[BoundUnit<'_>], [mut system, own]: [Vec<Connection>; 2]) -> Vec<Connection> {
    let names: Vec<String> = units.iter().map(|unit| unit.name.to_owned()).collect();
    loop {
        let connections: Vec<Connection> = system.iter().chain(&own).cloned().collect();
        let setup = SystemSetup { names: names.clone(), connections, ..SystemSetup::default() };
        let Err(AlgebraicLoop { units: inside }) = setup.order() else { return setup.connections };
        let all: Vec<Connection> = setup.connections.clone();
        let within = |c: &&mut Connection| {
            let inside = inside.contains(&names[c.from.unit]);
            inside && c.delay_steps == 0 && leads(&all, c.to.unit, c.from.unit, names.len())
        };
        match system.iter_mut().rev().find(within) {
            Some(connection) => connection.delay_steps = 1,
            None => return setup.connections,
        }
    }
}

/// Whether connections without delay lead from one of so many units to another.
fn leads(connections: &[Connection], from: usize, to: usize, units: usize) -> bool {
    let mut reached = vec![from];
    for _ in 0..units {
        let next = connections.iter().filter(|c| c.delay_steps == 0 && reached.contains(&c.from.unit));
        let next: Vec<usize> = next.map(|c| c.to.unit).filter(|unit| !reached.contains(unit)).collect();
        reached.extend(next);
    }
    reached.contains(&to)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fmi::{Handle, Scalar};
    use crate::host::port::Port;

    #[test]
    fn only_what_leads_back_is_part_of_a_loop() {
        let scalar = Scalar::Float64;
        let handle = Handle { value_reference: 0, scalar, offset: 0, count: 1, discrete: false };
        let port = |unit: usize| UnitPort { unit, port: Port::new("v".to_owned(), handle, 0.0).unwrap() };
        let connect = |(from, to, delay_steps)| Connection {
            from: port(from),
            to: port(to),
            delay_steps,
            factor: 1.0,
            offset: 0.0,
        };
        // 0 and 1 drive each other; 2 follows 1, and drives nothing.
        let loop_and_tail: Vec<Connection> = [(0, 1, 0), (1, 0, 0), (1, 2, 0)].map(connect).to_vec();
        assert!(leads(&loop_and_tail, 1, 0, 3) && leads(&loop_and_tail, 0, 1, 3));
        assert!(!leads(&loop_and_tail, 2, 1, 3), "what follows a loop is not in it");
        let description = crate::fmi::ModelDescription::default();
        let unit = |name| BoundUnit { name, description: &description, file: String::new() };
        let units = [unit("a"), unit("b"), unit("c")];
        let delays: Vec<usize> =
            without_loops(&units, [loop_and_tail, Vec::new()]).iter().map(|c| c.delay_steps).collect();
        assert_eq!(delays, [0, 1, 0]);
    }

    #[test]
    fn units_of_one_quantity_are_converted() {
        assert!((ratio("deg", "rad").unwrap() - 0.017_453_292_519_943_295).abs() < 1e-18);
        assert!((ratio("mm", "m").unwrap() - 1e-3).abs() < 1e-18);
        assert_eq!(ratio("mm", "rad"), None);
    }
}
