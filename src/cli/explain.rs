//! `fmi-hazard explain`: a hazard in plain words, its force with every number, and what would remove it.

use std::path::PathBuf;
use std::sync::Mutex;

use super::exit::{Failure, NO_HAZARD};
use super::hosting::HostingArguments;
use super::output::{Format, Progress};
use super::{earlier, output};
use crate::report::verified::Outcome;
use crate::scan::explain::explain;
use crate::scan::remedy::{Effort, remedies};
use crate::scan::verify::verify;
use crate::scan::{ScanError, StateChoice, film};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A scan.json, or the folder with the results of a scan
    scan: PathBuf,
    /// Id of a hazard in it
    id: String,
    /// The cell file or FMU, when it is no longer where it was
    #[arg(long)]
    cell: Option<PathBuf>,
    /// Do not look for changes that remove it
    #[arg(long)]
    no_changes: bool,
    /// Sequences that try out each change
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u32).range(1..))]
    iterations: u32,
    /// Threads (default: one a core); the result is the same
    #[arg(long)]
    workers: Option<usize>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    hosting: HostingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let recorded = earlier::read(&arguments.scan)?;
    let hazard = earlier::hazard(&recorded, &arguments.id, &arguments.scan)?;
    let prepared = earlier::prepare(&recorded, arguments.cell.as_deref(), &arguments.hosting.hosting()?)?;
    match verify(&prepared, hazard).outcome {
        Outcome::NotRun { cause } => return Err(Failure::running(format!("the FMU failed: {cause}"))),
        Outcome::StillThere { body_region, robot_link, .. }
            if body_region == hazard.body_region.to_string() && robot_link == hazard.robot_link => {}
        other => {
            let now = match other {
                Outcome::StillThere { body_region, robot_link, .. } => {
                    format!("its sequences lead to {body_region} <- {robot_link} now")
                }
                _ => "its sequences end without an unsafe contact now".to_owned(),
            };
            return Err(Failure::unusable_with_help(
                format!("{} is not there any more in {}: {now}", hazard.id, prepared.subject.path),
                "the cell or the FMU has changed since the scan: scan again, or name the cell that was scanned with --cell",
            ));
        }
    }
    let failed = |cause| Failure::from(ScanError { cause });
    let mut simulation = prepared.simulation(StateChoice::Auto, false).map_err(failed)?;
    let watched = film::watch(&mut simulation, &prepared, hazard).map_err(failed)?;
    let Some(mut explanation) = explain(&prepared, hazard, &watched) else {
        return Err(Failure::unusable(format!("the cell has no link {}", hazard.robot_link)));
    };
    if !arguments.no_changes {
        let cores = || std::thread::available_parallelism().map_or(1, Into::into);
        let effort = Effort { iterations: arguments.iterations, workers: arguments.workers.unwrap_or_else(cores) };
        // Threads tell of their progress, one after the other.
        let progress: Mutex<Option<Progress>> = Mutex::new(None);
        let tell = |done: usize, of: usize| {
            if let Ok(mut progress) = progress.lock() {
                progress.get_or_insert_with(|| Progress::new(of as u64, "changes tried")).at(done as u64, "");
            }
        };
        explanation.remedies = remedies(&prepared, hazard, &recorded.hazards, effort, &tell).map_err(failed)?;
        if let Ok(Some(progress)) = progress.into_inner() {
            progress.finish();
        }
    }
    match arguments.format {
        Format::Table => output::result(&explanation.render()),
        Format::Json => {
            output::json_of(&explanation)?;
        }
    }
    Ok(NO_HAZARD)
}
