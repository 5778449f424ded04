//! `fmi-hazard inspect`: what an FMU or a system of FMUs is, without loading it; and with options, what it does when it is run.

mod inspection;
mod running;
mod self_test;

use std::path::PathBuf;

use self::inspection::{Filter, Inspection, SystemInspection};
use super::exit::{Failure, NO_HAZARD};
use super::hosting::HostingArguments;
use super::output::{self, Format};
use crate::cell::foreign::ssp;
use crate::fmi::Fmu;
pub(super) use running::{reported_words, shortened, words};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The FMU, or the system of FMUs (.ssp, .ssd); with --run also a cell file (.toml)
    path: PathBuf,
    /// List local variables and parameters too
    #[arg(long)]
    all: bool,
    /// List local variables too: a cell may bind them like outputs
    #[arg(long)]
    locals: bool,
    /// List only variables whose name or description holds this text
    #[arg(long, value_name = "TEXT")]
    find: Option<String>,
    /// Run it: whether it moves, repeats itself, and which inputs stop it, after how long, with which polarity
    #[arg(long, conflicts_with_all = ["all", "locals", "find", "self_test"])]
    run: bool,
    /// With --run: the cell file of an FMU that has none of its own
    #[arg(long, requires = "run")]
    cell: Option<PathBuf>,
    /// With --run: do as if there were no cell file, so that what is tried follows from the FMU alone
    #[arg(long, requires = "run", conflicts_with = "cell")]
    fmu_only: bool,
    /// Run it in parts: what its promises about its state are worth
    #[arg(long, conflicts_with_all = ["all", "locals", "find"])]
    self_test: bool,
    /// With --self-test: communication step, s (default: the FMU's own, else 0.02)
    #[arg(long, requires = "self_test", value_parser = positive)]
    step: Option<f64>,
    /// With --self-test: number of steps in a run (default: 80, but none beyond the FMU's stopTime)
    #[arg(long, requires = "self_test", value_parser = clap::value_parser!(u32).range(8..100_000))]
    steps: Option<u32>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    hosting: HostingArguments,
}

fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(v) if v.is_finite() && v > 0.0 => Ok(v),
        _ => Err("a number greater than zero is needed".to_owned()),
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    if arguments.run {
        return running::run(arguments);
    }
    if arguments.self_test {
        return self_test::run(arguments);
    }
    if let Some(option) = arguments.hosting.given() {
        return Err(Failure::unusable_with_help(
            format!("{option} says how an FMU is run, and `inspect` does not run it"),
            "add --run or --self-test",
        ));
    }
    let filter = Filter { all: arguments.all, locals: arguments.locals, containing: arguments.find.clone() };
    if ssp::is_ssp(&arguments.path) {
        return system(arguments, &filter);
    }
    let fmu = Fmu::open(&arguments.path)?;
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
    let system = ssp::open(&arguments.path)?;
    let components: Vec<(String, Inspection)> =
        system.fmus.iter().map(|(name, fmu)| (name.clone(), Inspection::new(fmu, filter))).collect();
    let inspection = SystemInspection::new(&arguments.path, &system, components);
    match arguments.format {
        Format::Table => output::result(&inspection.render()),
        Format::Json => output::json_of(&inspection)?,
    }
    for warning in &inspection.warnings {
        output::warning(warning);
    }
    Ok(NO_HAZARD)
}
