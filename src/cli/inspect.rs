//! `fmi-hazard inspect`: what an FMU or a system of FMUs is. Nothing of it is loaded or run.

use std::path::PathBuf;

use super::exit::{Failure, NO_HAZARD};
use super::output::{self, Format};
use crate::cell::foreign::ssp;
use crate::fmi::Fmu;
use crate::report::inspection::{Filter, Inspection, SystemInspection};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The FMU, or the system of FMUs (.ssp, .ssd)
    fmu: PathBuf,
    /// List local variables and parameters too
    #[arg(long)]
    all: bool,
    /// List local variables too: a cell may bind them like outputs
    #[arg(long)]
    locals: bool,
    /// List only variables whose name or description holds this text
    #[arg(long, value_name = "TEXT")]
    find: Option<String>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let filter = Filter { all: arguments.all, locals: arguments.locals, containing: arguments.find.clone() };
    if ssp::is_ssp(&arguments.fmu) {
        return system(arguments, &filter);
    }
    let fmu = Fmu::open(&arguments.fmu)?;
    let inspection = Inspection::new(&fmu, &filter);
    match arguments.format {
        Format::Table => output::result(&inspection.render()),
        Format::Json => output::json_of(&inspection)?,
    }
    for warning in fmu.warnings() {
        output::warning(&warning.to_string());
    }
    Ok(NO_HAZARD)
}

/// What a system is: its components, each as an FMU, and what is connected.
fn system(arguments: &Arguments, filter: &Filter) -> Result<u8, Failure> {
    let system = ssp::open(&arguments.fmu)?;
    let components: Vec<(String, Inspection)> =
        system.fmus.iter().map(|(name, fmu)| (name.clone(), Inspection::new(fmu, filter))).collect();
    let inspection = SystemInspection::new(&arguments.fmu, &system, components);
    match arguments.format {
        Format::Table => output::result(&inspection.render()),
        Format::Json => output::json_of(&inspection)?,
    }
    for warning in &inspection.warnings {
        output::warning(warning);
    }
    Ok(NO_HAZARD)
}
