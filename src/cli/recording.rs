//! Writing a hazard as an MCAP recording.

use std::path::Path;

use super::exit::Failure;
use crate::record::hazard::Hazard;
use crate::report::mcap::{self, Recording};
use crate::scan::{Prepared, ScanError, StateChoice, replay};

/// Refuses what cannot be recorded before anything is simulated.
pub(super) fn possible(hazards: usize, file: &Path) -> Result<(), Failure> {
    if hazards > 1 {
        return Err(Failure::unusable_with_help(
            format!("{hazards} hazards do not fit into one recording, {}", file.display()),
            "name one of them",
        ));
    }
    Ok(())
}

/// Runs the hazard's sequence once more, in the cell with its beginning, and writes what there is to see.
pub(super) fn write(prepared: &Prepared, hazard: &Hazard, file: &Path) -> Result<(), Failure> {
    let failed = |cause| Failure::from(ScanError { cause });
    let mut simulation = prepared.simulation(StateChoice::Replay, false).map_err(failed)?;
    let watched = replay::watch(&mut simulation, prepared, hazard).map_err(failed)?;
    let trace = replay::trace(prepared, &watched).map_err(failed)?;
    let recording = Recording {
        hazard,
        subject: &prepared.subject,
        scenery: &replay::scenery(prepared),
        replay: &replay::record(prepared, hazard, &watched, String::new()),
        trace: trace.as_ref(),
    };
    let cannot = |error: &dyn std::fmt::Display| Failure::unusable(format!("cannot write {}: {error}", file.display()));
    let to = std::fs::File::create(file).map_err(|error| cannot(&error))?;
    mcap::write(&recording, std::io::BufWriter::new(to)).map_err(|error| cannot(&error))
}
