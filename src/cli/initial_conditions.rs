//! A scan of a cell with several beginnings: one scan each, in a folder each, and a table of them all.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::exit::{self, Failure};
use super::output;
use crate::record::hazard::Hazard;
use crate::record::model::{FileSubject, NumberedInitialCondition, Subject};

/// Where the table is kept.
const TABLE: &str = "beginnings.json";

/// Name of the folder with the results of one beginning, from 1.
pub(super) fn folder(number: usize) -> String {
    format!("begin-{number}")
}

/// Whether `out` holds the results of a scan of several beginnings.
pub(super) fn are_in(out: &Path) -> bool {
    out.join(TABLE).is_file()
}

/// The results in `out` are of something else now.
pub(super) fn forget(out: &Path) {
    let _ = std::fs::remove_file(out.join(TABLE));
}

/// The folder in `out` with the results of the same start at the same time, whatever its number there; the table, if it
/// cannot be read.
pub(super) fn same_in(out: &Path, beginning: Option<&NumberedInitialCondition>) -> Result<Option<PathBuf>, PathBuf> {
    let table = Table::read(out).ok_or_else(|| out.join(TABLE))?;
    let same = |entry: &&Entry| beginning.is_some_and(|wanted| wanted.same(&entry.beginning));
    Ok(table.beginnings.iter().find(same).map(|entry| out.join(&entry.folder)))
}

/// What came out of each beginning so far.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(super) struct Table {
    /// Name of the cell.
    cell: String,
    /// SHA-256 of the cell file.
    cell_sha256: String,
    /// The files that it extends or names, with theirs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    files: Vec<FileSubject>,
    /// One entry each, in their order.
    beginnings: Vec<Entry>,
}

/// What came out of one.
#[derive(Debug, Serialize, Deserialize)]
struct Entry {
    beginning: NumberedInitialCondition,
    /// Folder with its results, relative to the table.
    folder: String,
    exit_code: u8,
    hazards: usize,
    worst: Option<Worst>,
}

#[derive(Debug, Serialize, Deserialize)]
struct Worst {
    id: String,
    ratio: f64,
}

impl Table {
    /// A table of nothing so far; or, if the scan goes on, of what there was.
    pub(super) fn initial_condition_of(out: &Path, subject: &Subject, goes_on: bool) -> Self {
        let same = |kept: &Self| kept.cell_sha256 == subject.cell_sha256 && kept.files == subject.files;
        let kept = Self::read(out).filter(|kept| goes_on && same(kept));
        forget(out);
        kept.unwrap_or_else(|| Self {
            cell: subject.cell.clone(),
            cell_sha256: subject.cell_sha256.clone(),
            files: subject.files.clone(),
            beginnings: Vec::new(),
        })
    }

    fn read(out: &Path) -> Option<Self> {
        serde_json::from_str(&std::fs::read_to_string(out.join(TABLE)).ok()?).ok()
    }

    /// Whether one has ended before.
    pub(super) fn has(&self, number: usize) -> bool {
        self.beginnings.iter().any(|entry| entry.beginning.number == number)
    }

    /// Adds what came out of one and keeps the table in `out`. There are no hazards where the FMU failed at once.
    pub(super) fn add(
        &mut self,
        subject: &Subject,
        hazards: &[Hazard],
        exit_code: u8,
        out: &Path,
    ) -> Result<(), Failure> {
        let Some(beginning) = subject.beginning.clone() else { return Ok(()) };
        let worst = hazards.first().map(|hazard| Worst { id: hazard.id.clone(), ratio: hazard.ratio });
        let folder = folder(beginning.number);
        self.beginnings.push(Entry { beginning, folder, exit_code, hazards: hazards.len(), worst });
        self.keep(out)
    }

    /// Writes it into `out`.
    pub(super) fn keep(&self, out: &Path) -> Result<(), Failure> {
        output::write_file(&out.join(TABLE), &output::pretty(self)?)
    }

    /// The exit code of all together: hazards count most, then what says nothing.
    pub(super) fn exit_code(&self) -> u8 {
        let ranks = [exit::HAZARDS, exit::FMU_FAILED, exit::INCONCLUSIVE];
        let any = |code: &u8| self.beginnings.iter().any(|entry| entry.exit_code == *code);
        // Of none, nothing is known.
        let none = if self.beginnings.is_empty() { exit::INCONCLUSIVE } else { exit::NO_HAZARD };
        ranks.into_iter().find(any).unwrap_or(none)
    }

    /// For people.
    pub(super) fn render(&self, out: &Path) -> String {
        let mut text = format!("\n{}: {} beginnings\n\n", self.cell, self.beginnings.len());
        for entry in &self.beginnings {
            let found = match (&entry.worst, entry.exit_code) {
                (Some(worst), _) => {
                    let s = if entry.hazards == 1 { "" } else { "s" };
                    format!("{} hazard{s}, worst {:.2}x {}", entry.hazards, worst.ratio, worst.id)
                }
                (None, exit::FMU_FAILED) => "the FMU failed".to_owned(),
                (None, exit::NO_HAZARD) => "no sequence of actions is hazardous".to_owned(),
                (None, _) => "nothing was found; not shown that there is nothing".to_owned(),
            };
            let _ = writeln!(text, "  {}  {}: {found}", entry.beginning.number, entry.beginning.words());
            let _ = writeln!(text, "     {}", out.join(&entry.folder).display());
        }
        text
    }
}
