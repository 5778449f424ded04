//! `fmi-hazard replay --changed`: known hazards tried again in a changed cell, from where they began.

use std::path::Path;

use super::Arguments;
use crate::cli::exit::{FMU_FAILED, Failure, HAZARDS, INCONCLUSIVE, NO_HAZARD};
use crate::cli::output::{self, Format};
use crate::record::hazard::Hazard;
use crate::record::recorded::Recorded;
use crate::report::verified::{Standing, as_junit, render, rows, together};
use crate::scan::PrepareError;
use crate::scan::prepare::prepare_unplaced;
use crate::scan::verify::Again;

/// Tries the `wanted` hazards of `known` again in the `changed` cell, an FMU or a cell file.
pub(super) fn run(arguments: &Arguments, known: &Recorded, wanted: &[Hazard], changed: &Path) -> Result<u8, Failure> {
    let hosting = arguments.hosting.hosting()?;
    let (prepared, free_start) = prepare_unplaced(changed, arguments.elsewhere.cell(), &hosting)?;
    match free_start {
        // It begins where the scan did, not where the cell says.
        Ok(()) | Err(PrepareError::NoRoom(_) | PrepareError::DetectedAtTimes { .. }) => {}
        Err(error) => return Err(error.into()),
    }
    let again = Again::new(&prepared, known)?;
    let mut progress = output::Progress::new(wanted.len() as u64, "hazards");
    let mut verified = Vec::with_capacity(wanted.len());
    for (done, hazard) in (1..).zip(wanted) {
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
