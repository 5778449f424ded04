//! What an interrupted scan leaves behind so that it can go on: its command line and the journal of its exhaustive part.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::exit::Failure;
use super::output;
use crate::report::moved::{found, seen_from};
use crate::scan::Prepared;
use crate::sim::journal::Journal;

/// The command line of a scan, and where it was given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Command {
    /// What stood after `fmi-hazard scan`.
    pub arguments: Vec<String>,
    /// The working folder; in the file relative to the results, so that both may be moved.
    pub folder: PathBuf,
}

const COMMAND: &str = "resume.json";
const JOURNAL: &str = "journal.bin";

impl Command {
    /// The command line of this process; nothing if it cannot be written down.
    pub(super) fn of_this_process() -> Option<Self> {
        // Options for every command may stand before this one's name.
        let own = std::env::args_os().skip_while(|argument| argument != "scan").skip(1);
        let arguments = own.map(|a| a.into_string().ok()).collect::<Option<_>>()?;
        Some(Self { arguments, folder: std::env::current_dir().ok()? })
    }

    /// The one of the scan whose results are in `out`.
    pub(super) fn of_scan(out: &Path) -> Result<Self, Failure> {
        let path = out.join(COMMAND);
        let text = std::fs::read_to_string(&path).map_err(|e| {
            Failure::unusable_with_help(
                format!("there is no scan to go on with in {}: cannot read {}: {e}", out.display(), path.display()),
                "give the folder of the results of a scan that was interrupted; one that has ended needs no more",
            )
        })?;
        let command: Self = serde_json::from_str(&text).map_err(|e| {
            Failure::unusable_with_help(format!("{} is damaged: {e}", path.display()), "scan again from the beginning")
        })?;
        let folder = found(&command.folder, &std::path::absolute(out).unwrap_or_else(|_| out.to_owned()));
        Ok(Self { folder, ..command })
    }

    /// Writes it into the folder of the results.
    pub(super) fn write(&self, out: &Path) -> Result<(), Failure> {
        let command = Self { folder: seen_from(&self.folder, out).into(), ..self.clone() };
        output::write_file(&out.join(COMMAND), &output::pretty(&command)?)
    }
}

/// The journal in the folder of the results: that of an interrupted scan of the same cell, or a new one.
pub(super) fn journal(out: &Path, prepared: &Prepared, goes_on: bool) -> Result<Journal, Failure> {
    let path = out.join(JOURNAL);
    if !goes_on {
        let _ = std::fs::remove_file(&path);
    }
    let fmus: Vec<&str> = prepared.subject.fmus.iter().map(|fmu| fmu.sha256.as_str()).collect();
    let files = prepared.subject.files.iter().map(|file| format!(" {}", file.sha256));
    let subject = format!(
        "fmi-hazard {}, journal 4, cell {}, beginning {}{}, FMUs {}, told by bytes: {}",
        env!("CARGO_PKG_VERSION"),
        prepared.subject.cell_sha256,
        prepared.cell.beginning + 1,
        files.collect::<String>(),
        fmus.join(" "),
        prepared.tells_states_by_bytes()
    );
    Journal::open(&path, &subject).map_err(|e| {
        let help = "scan again from the beginning, without --resume";
        Failure::unusable_with_help(format!("cannot go on with {}: {e}", path.display()), help)
    })
}

/// Nothing is left to go on with.
pub(super) fn finished(out: &Path) {
    for name in [COMMAND, JOURNAL] {
        let _ = std::fs::remove_file(out.join(name));
    }
}
