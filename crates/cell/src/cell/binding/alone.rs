//! FMUs without a cell: everything that is free is written, every result is read.

use super::{Binder, BoundUnit, system};
use crate::cell::CellError;
use crate::cell::error::{Problems, Source};
use crate::cell::foreign::ssp::{System, Wiring};
use crate::fmi::{Causality, ModelDescription};
use crate::host::port::{Port, changing, ports};
use crate::host::system::{SystemSetup, UnitPort};

/// FMUs with all their inputs and outputs.
#[derive(Clone, Debug)]
pub struct Alone {
    /// What is written and read; the step is for the caller to set.
    pub setup: SystemSetup,
    /// The inputs as cell files name them.
    pub inputs: Vec<String>,
    /// The outputs as cell files name them.
    pub outputs: Vec<String>,
}

/// Outputs; for an FMU without any, its changing local variables.
fn results(description: &ModelDescription) -> Vec<Port> {
    let outputs = changing(description, Causality::Output);
    if outputs.is_empty() { changing(description, Causality::Local) } else { outputs }
}

/// Inputs with their start values.
fn free(description: &ModelDescription) -> impl Iterator<Item = (Port, f64)> {
    let inputs = description.variables.iter().filter(|v| v.causality == Causality::Input);
    inputs.flat_map(|variable| ports(description, variable))
}

impl Alone {
    /// One FMU.
    #[must_use]
    pub fn of_fmu(description: &ModelDescription) -> Self {
        let (inputs, initial_inputs): (Vec<Port>, Vec<f64>) = free(description).unzip();
        let outputs = results(description);
        let names = |ports: &[Port]| ports.iter().map(|port| port.name.clone()).collect();
        let of_unit = |ports: Vec<Port>| ports.into_iter().map(|port| UnitPort { unit: 0, port }).collect();
        Self {
            inputs: names(&inputs),
            outputs: names(&outputs),
            setup: SystemSetup {
                names: vec![String::new()],
                inputs: of_unit(inputs),
                initial_inputs,
                outputs: of_unit(outputs),
                ..SystemSetup::default()
            },
        }
    }

    /// A system of FMUs, with its connections and parameters.
    ///
    /// # Errors
    /// When it connects or sets what its FMUs do not have, with the line in its description.
    pub fn of_system(system: &System) -> Result<Self, Box<CellError>> {
        let units = BoundUnit::all(system.fmus.iter().map(|(name, fmu)| (name, fmu)));
        let wiring = Wiring {
            structure: system.structure.clone(),
            source: system.source.clone(),
            path: Default::default(),
            sha256: system.sha256.clone(),
            archive: system.archive.clone(),
        };
        let (source, problems) = (Source::new("", ""), Problems::default());
        let mut binder = Binder::new(&source, &units, Some(&wiring), &problems);
        let connections = system::without_loops(&units, [binder.system(&[]), Vec::new()]);
        let parameters = binder.system_parameters(&[]);
        let mut alone = Self {
            inputs: Vec::new(),
            outputs: Vec::new(),
            setup: SystemSetup {
                names: system.fmus.iter().map(|(name, _)| name.clone()).collect(),
                parameters,
                connections,
                ..SystemSetup::default()
            },
        };
        for (unit, (component, fmu)) in system.fmus.iter().enumerate() {
            for (port, start) in free(fmu.description()) {
                alone.input(system, UnitPort { unit, port }, start);
            }
            for port in results(fmu.description()) {
                alone.outputs.push(format!("{component}:{}", port.name));
                alone.setup.outputs.push(UnitPort { unit, port });
            }
        }
        problems.take_or(alone)
    }

    /// One input of a component, unless a connection drives it. Those that one input of the system drives get what the first
    /// of them gets.
    fn input(&mut self, system: &System, port: UnitPort, start: f64) {
        let setup = &mut self.setup;
        let same = |other: &UnitPort| other.unit == port.unit && other.port.handle == port.port.handle;
        if setup.connections.iter().any(|connection| same(&connection.to)) {
            return;
        }
        let own = system.structure.inputs.iter().find_map(|(name, targets)| {
            let rest = |target: &(usize, String)| match port.port.name.strip_prefix(target.1.as_str()) {
                Some(rest) if target.0 == port.unit && (rest.is_empty() || rest.starts_with('[')) => Some(rest),
                _ => None,
            };
            targets.iter().find_map(rest).map(|rest| format!("{name}{rest}"))
        });
        let name = own.unwrap_or_else(|| format!("{}:{}", system.fmus[port.unit].0, port.port.name));
        match self.inputs.iter().position(|known| *known == name) {
            Some(column) => setup.mirrors.push((column, port)),
            None => {
                self.inputs.push(name);
                setup.inputs.push(port);
                setup.initial_inputs.push(start);
            }
        }
    }
}
