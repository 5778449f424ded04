//! An FMU, or a system of FMUs, that a command is about without a cell.

use std::path::Path;

use super::exit::Failure;
use crate::cell::binding::alone::Alone;
use crate::cell::draft::interface::Interface;
use crate::cell::draft::roles::Guess;
use crate::cell::foreign::ssp::{self, System};
use crate::fmi::Fmu;
use crate::host::UnitPort;
use crate::host::port::Port;

/// What a command is about.
pub(super) enum Subject {
    Fmu(Box<Fmu>),
    System(Box<System>),
}

impl Subject {
    /// Opens an FMU, or a system by its ending (.ssp, .ssd).
    pub(super) fn open(path: &Path) -> Result<Self, Failure> {
        Ok(if ssp::is_ssp(path) {
            Self::System(Box::new(ssp::open(path)?))
        } else {
            Self::Fmu(Box::new(Fmu::open(path)?))
        })
    }

    /// Its variables and what they seem to be for.
    pub(super) fn interface(&self) -> Interface<'_> {
        match self {
            Self::Fmu(fmu) => Interface::of_fmu(fmu.description()),
            Self::System(system) => Interface::of_system(system),
        }
    }

    /// Its FMUs, in the order of its setup.
    pub(super) fn fmus(&self) -> Vec<&Fmu> {
        match self {
            Self::Fmu(fmu) => vec![fmu],
            Self::System(system) => system.fmus.iter().map(|(_, fmu)| fmu).collect(),
        }
    }

    /// So many steps, or as many as none of its FMUs is run beyond its stopTime with.
    pub(super) fn steps(&self, wanted: usize, step_s: f64) -> usize {
        let within = |fmu: &Fmu| fmu.description().default_experiment.steps(wanted, step_s);
        self.fmus().into_iter().map(within).min().unwrap_or(wanted)
    }

    /// The first stopTime of its FMUs, s.
    pub(super) fn ends_s(&self) -> Option<f64> {
        self.fmus().into_iter().filter_map(|fmu| fmu.description().default_experiment.ends_s()).reduce(f64::min)
    }

    /// The model's name, or the system's.
    pub(super) fn name(&self) -> &str {
        match self {
            Self::Fmu(fmu) => &fmu.description().model_name,
            Self::System(system) => &system.structure.name,
        }
    }

    /// All its inputs are moved, all its outputs compared, with steps of `step_s` seconds or its own.
    pub(super) fn alone(&self, step_s: Option<f64>) -> Result<Alone, Failure> {
        let mut alone = match self {
            Self::Fmu(fmu) => Alone::of_fmu(fmu.description()),
            Self::System(system) => Alone::of_system(system)?,
        };
        if alone.setup.outputs.is_empty() {
            return Err(Failure::unusable_with_help(
                "this FMU has no numeric output or local variable to compare",
                "a self-test needs at least one",
            ));
        }
        let own = self.fmus().into_iter().filter_map(|fmu| fmu.description().default_experiment.step_size);
        let own = own.filter(|step| step.is_finite() && *step > 0.0).reduce(f64::min);
        alone.setup.step_s = step_s.or(own).unwrap_or(0.02);
        Ok(alone)
    }

    /// Adds the locals that have one of these roles to what is read.
    pub(super) fn add_locals(&self, alone: &mut Alone, roles: &[Guess]) {
        for guess in roles
            .iter()
            .filter(|guess| guess.local && !alone.outputs.contains(&guess.variable))
            .cloned()
            .collect::<Vec<_>>()
        {
            let (unit, name) = match self {
                Self::Fmu(_) => (Some(0), guess.variable.as_str()),
                Self::System(_) => {
                    let (component, name) = guess.variable.split_once(':').unwrap_or(("", &guess.variable));
                    (alone.setup.names.iter().position(|known| known == component), name)
                }
            };
            let port = unit.and_then(|unit| {
                let handle = self.fmus()[unit].description().handle(name)?;
                Some(UnitPort { unit, port: Port::new(name.to_owned(), handle, 0.0)? })
            });
            if let Some(port) = port {
                alone.setup.outputs.push(port);
                alone.outputs.push(guess.variable);
            }
        }
    }
}
