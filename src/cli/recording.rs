//! Writing a hazard as an MCAP recording, in builds that can.

use std::path::Path;

use super::exit::Failure;
use crate::report::model::Hazard;
use crate::scan::Prepared;

/// Refuses what cannot be recorded before anything is simulated.
pub(super) fn possible(hazards: usize, file: &Path) -> Result<(), Failure> {
    if !cfg!(feature = "mcap") {
        return Err(Failure::unusable_with_help(
            "this build cannot write MCAP recordings",
            "build fmi-hazard with them: `cargo install --path . --features mcap`",
        ));
    }
    if hazards > 1 {
        return Err(Failure::unusable_with_help(
            format!("{hazards} hazards do not fit into one recording, {}", file.display()),
            "name one of them",
        ));
    }
    Ok(())
}

/// Runs the hazard's sequence once more, in the cell with its beginning, and writes what there is to see.
#[cfg(feature = "mcap")]
pub(super) fn write(prepared: &Prepared, hazard: &Hazard, file: &Path) -> Result<(), Failure> {
    use crate::report::mcap::{self, Recording};
    use crate::scan::{ScanError, StateChoice, film};

    let failed = |cause| Failure::from(ScanError { cause });
    let mut simulation = prepared.simulation(StateChoice::Replay, false).map_err(failed)?;
    let watched = film::watch(&mut simulation, prepared, hazard).map_err(failed)?;
    let trace = film::trace(prepared, &watched).map_err(failed)?;
    let recording = Recording {
        hazard,
        subject: &prepared.subject,
        scenery: &film::scenery(prepared),
        replay: &film::replay(prepared, hazard, &watched, String::new()),
        trace: trace.as_ref(),
    };
    let cannot = |error: &dyn std::fmt::Display| Failure::unusable(format!("cannot write {}: {error}", file.display()));
    let to = std::fs::File::create(file).map_err(|error| cannot(&error))?;
    mcap::write(&recording, std::io::BufWriter::new(to)).map_err(|error| cannot(&error))
}

/// Never: [`possible`] has refused it.
#[cfg(not(feature = "mcap"))]
pub(super) fn write(_: &Prepared, _: &Hazard, _: &Path) -> Result<(), Failure> {
    possible(1, Path::new(""))
}
