//! `fmi-hazard inspect`: what an FMU is. Nothing of it is loaded or run.

use std::path::PathBuf;

use super::exit::{Failure, NO_HAZARD};
use super::output::{self, Format};
use crate::fmi::Fmu;
use crate::report::inspection::{Filter, Inspection};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The FMU
    fmu: PathBuf,
    /// List local variables and parameters too
    #[arg(long)]
    all: bool,
    /// List only variables whose name or description holds this text
    #[arg(long, value_name = "TEXT")]
    find: Option<String>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let fmu = Fmu::open(&arguments.fmu)?;
    let filter = Filter { all: arguments.all, containing: arguments.find.clone() };
    let inspection = Inspection::new(&fmu, &filter);
    match arguments.format {
        Format::Table => output::result(&inspection.render()),
        Format::Json => output::json(&(serde_json::to_string_pretty(&inspection).map_err(Failure::unusable)? + "\n")),
    }
    for warning in fmu.warnings() {
        output::warning(&warning.to_string());
    }
    Ok(NO_HAZARD)
}
