//! `fmi-hazard verify`: known hazards tried again in a changed cell.

use std::path::PathBuf;

use super::exit::{FMU_FAILED, Failure, HAZARDS, INCONCLUSIVE, NO_HAZARD};
use super::hosting::HostingArguments;
use super::output::Format;
use super::{earlier, output};
use crate::report::verified::{Standing, as_junit, render, rows, together};
use crate::scan::PrepareError;
use crate::scan::prepare::prepare_unplaced;
use crate::scan::verify::Again;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The scan that knows the hazards: its scan.json, or the folder with its results
    scan: PathBuf,
    /// The changed cell: a cell file (.toml), or an FMU with a cell file beside it or inside it
    path: PathBuf,
    /// The cell file of an FMU that has none of its own
    #[arg(long)]
    cell: Option<PathBuf>,
    /// Write the result as JUnit XML into this file too
    #[arg(long, value_name = "FILE")]
    junit: Option<PathBuf>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    hosting: HostingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let known = earlier::read(&arguments.scan)?;
    let (prepared, free_start) =
        prepare_unplaced(&arguments.path, arguments.cell.as_deref(), &arguments.hosting.hosting()?)?;
    match free_start {
        // It begins where the scan did, not where the cell says.
        Ok(()) | Err(PrepareError::NoRoom(_) | PrepareError::SeenAtTimes { .. }) => {}
        Err(error) => return Err(error.into()),
    }
    let again = Again::new(&prepared, &known)?;
    let mut progress = output::Progress::new(known.hazards.len() as u64, "hazards");
    let mut verified = Vec::with_capacity(known.hazards.len());
    for (done, hazard) in (1..).zip(&known.hazards) {
        verified.push(again.verify(hazard)?);
        progress.at(done, "");
    }
    progress.finish();
    match arguments.format {
        Format::Table => output::result(&render(&known.causes, &verified)),
        Format::Json => output::json_of(&rows(&known.causes, &verified))?,
    }
    if let Some(path) = &arguments.junit {
        output::write_file(path, &as_junit(&prepared.cell.name, &known.causes, &verified).map_err(Failure::unusable)?)?;
    }
    Ok(match together(&verified) {
        Some(Standing::StillThere) => HAZARDS,
        Some(Standing::NotRun) => FMU_FAILED,
        // Where nothing was known nothing was tried.
        Some(Standing::NotJudged | Standing::NotShown) | None => INCONCLUSIVE,
        Some(Standing::Fixed) => NO_HAZARD,
    })
}
