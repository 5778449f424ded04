//! Earlier scans that an argument names: reading them, finding a hazard in one, and preparing what they scanned again.

use std::path::Path;

use super::exit::Failure;
use super::{beginnings, output};
use crate::cell::error::{Source, nearest};
use crate::host::selftest::Rung;
use crate::report::model::{FmuSubject, Hazard};
use crate::report::recorded::Recorded;
use crate::scan::prepare::prepare_in;
use crate::scan::{Hosting, Prepared};

/// A recorded scan: its scan.json, or the folder with its results.
pub(super) fn read(path: &Path) -> Result<Recorded, Failure> {
    if beginnings::are_in(path) {
        let message = format!("{} holds a scan for each of the cell's beginnings", path.display());
        let first = path.join(beginnings::folder(1));
        return Err(Failure::unusable_with_help(message, format!("name one of them: {}", first.display())));
    }
    Recorded::read(path).map_err(|error| Failure::unusable_with_help(&error, error.help()))
}

/// The hazard `id` of a scan that was read from `path`.
pub(super) fn hazard<'a>(scan: &'a Recorded, id: &str, path: &Path) -> Result<&'a Hazard, Failure> {
    if let Some(hazard) = scan.hazards.iter().find(|hazard| hazard.id == id) {
        return Ok(hazard);
    }
    let help = match nearest(id, scan.hazards.iter().map(|hazard| hazard.id.as_str())) {
        Some(id) => format!("did you mean {id}?"),
        None => format!("it holds {} hazards; their ids stand in report.html and hazards.csv", scan.hazards.len()),
    };
    Err(Failure::unusable_with_help(format!("there is no hazard {id} in {}", path.display()), help))
}

/// The cell file of a scan, if it is still where it was and as it was.
pub(super) fn cell_text(scan: &Recorded) -> Option<String> {
    let file = scan.subject.cell_file.as_ref().unwrap_or(&scan.subject.path);
    let text = std::fs::read_to_string(file).ok()?;
    (Source::new("", &text).sha256() == scan.subject.cell_sha256).then_some(text)
}

/// What was scanned, again: from where it was, or from `cell`, a cell file or an FMU, if it is elsewhere now. Warns of what
/// is not as it was.
pub(super) fn prepare(scan: &Recorded, cell: Option<&Path>, hosting: &Hosting) -> Result<Prepared, Failure> {
    let is_cell = |path: &Path| path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"));
    let own = &scan.subject;
    let prepared = match cell {
        // The FMU was named, and a cell file that need not name it.
        Some(cell) if is_cell(cell) && !is_cell(&own.path) => prepare_in(&own.path, Some(cell), hosting)?,
        Some(other) => prepare_in(other, None, hosting)?,
        None => prepare_in(&own.path, own.cell_file.as_deref(), hosting)?,
    };
    let prepared = prepared.beginning_of(own.beginning.as_ref())?;
    if own.cell_sha256 != prepared.subject.cell_sha256 {
        output::warning("the cell file has changed since the scan");
    }
    if own.files != prepared.subject.files {
        output::warning("a robot description, a mesh or the system of FMUs has changed since the scan");
    }
    let hashes = |fmus: &[FmuSubject]| fmus.iter().map(|fmu| fmu.sha256.clone()).collect::<Vec<_>>();
    if hashes(&own.fmus) != hashes(&prepared.subject.fmus) {
        output::warning("the FMU has changed since the scan");
    }
    Ok(prepared)
}

/// The same, with states brought back as plainly as the scan in `path` did: it may have found out that the FMU needs that.
pub(super) fn as_plainly(mut prepared: Prepared, path: &Path) -> Prepared {
    #[derive(serde::Deserialize)]
    struct Run {
        states_by: Rung,
    }
    let folder = if path.is_dir() { Some(path) } else { path.parent() };
    let text = folder.and_then(|folder| std::fs::read_to_string(folder.join("run.json")).ok());
    let run: Option<Run> = text.and_then(|text| serde_json::from_str(&text).ok());
    prepared.rung = run.map_or(prepared.rung, |run| run.states_by.max(prepared.rung));
    prepared
}
