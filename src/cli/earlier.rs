//! Earlier scans that an argument names: reading them, and finding a hazard in one.

use std::path::Path;

use super::exit::Failure;
use crate::cell::error::{Source, nearest};
use crate::report::model::Hazard;
use crate::report::recorded::Recorded;

/// A recorded scan: its scan.json, or the folder with its results.
pub(super) fn read(path: &Path) -> Result<Recorded, Failure> {
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
    let text = std::fs::read_to_string(&scan.subject.path).ok()?;
    (Source::new("", &text).sha256() == scan.subject.cell_sha256).then_some(text)
}
