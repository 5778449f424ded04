//! A scan of a cell with several beginnings: one scan each, in a folder each, and a table of them all.

use std::fmt::Write as _;
use std::path::Path;

use serde::{Deserialize, Serialize};

use super::exit::{self, Failure};
use super::output;
use crate::report::model::{BeginningSubject, ScanReport};

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

/// What came out of each beginning so far.
#[derive(Debug, Default, Serialize, Deserialize)]
pub(super) struct Table {
    /// Name of the cell.
    cell: String,
    /// One entry each, in their order.
    beginnings: Vec<Entry>,
}

/// What came out of one.
#[derive(Debug, Serialize, Deserialize)]
struct Entry {
    beginning: BeginningSubject,
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
    pub(super) fn begun(out: &Path, cell: &str, goes_on: bool) -> Self {
        let path = out.join(TABLE);
        let kept = std::fs::read_to_string(&path).ok().filter(|_| goes_on);
        let kept: Option<Self> = kept.and_then(|text| serde_json::from_str(&text).ok());
        let _ = std::fs::remove_file(path);
        kept.unwrap_or_else(|| Self { cell: cell.to_owned(), beginnings: Vec::new() })
    }

    /// Whether one has ended before.
    pub(super) fn has(&self, number: usize) -> bool {
        self.beginnings.iter().any(|entry| entry.beginning.number == number)
    }

    /// Adds what came out of one and keeps the table in `out`.
    pub(super) fn add(&mut self, report: &ScanReport, exit_code: u8, out: &Path) -> Result<(), Failure> {
        let Some(beginning) = report.subject.beginning.clone() else { return Ok(()) };
        let worst = report.hazards.first().map(|hazard| Worst { id: hazard.id.clone(), ratio: hazard.ratio });
        let folder = folder(beginning.number);
        self.beginnings.push(Entry { beginning, folder, exit_code, hazards: report.hazards.len(), worst });
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
        ranks.into_iter().find(any).unwrap_or(exit::NO_HAZARD)
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
                (None, exit::INCONCLUSIVE) => "inconclusive".to_owned(),
                (None, _) => "no hazard found".to_owned(),
            };
            let _ = writeln!(text, "  {}  {}: {found}", entry.beginning.number, entry.beginning.words());
            let _ = writeln!(text, "     {}", out.join(&entry.folder).display());
        }
        text
    }
}
