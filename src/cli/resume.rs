//! What an interrupted scan leaves behind so that it can go on: its command line, and the answers of its search. These
//! are what the parts of a divided one bring together, too.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::exit::Failure;
use super::output;
use crate::record::recorded::found;
use crate::scan::Prepared;
use crate::scan::moved::relative_to;
use crate::sim::answers::Answers;

/// The command line of a scan, and where it was given.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
pub(super) struct Command {
    /// What stood after `fmi-hazard scan`.
    pub arguments: Vec<String>,
    /// The working folder; in the file relative to the results, so that both may be moved.
    pub folder: PathBuf,
}

const COMMAND: &str = "resume.json";
const ANSWERS: &str = "answers.bin";

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
        let command = Self { folder: relative_to(&self.folder, out).into(), ..self.clone() };
        output::write_file(&out.join(COMMAND), &output::pretty(&command)?)
    }
}

/// The answers of a search in the folder of its results, those of an interrupted one if it `goes_on`; with those of
/// `parts` that ran elsewhere. `from` says which search of the cell it is.
pub(super) fn answers(
    out: &Path,
    prepared: &Prepared,
    from: &str,
    goes_on: bool,
    parts: &[PathBuf],
) -> Result<Answers, Failure> {
    let path = out.join(ANSWERS);
    if !goes_on {
        let _ = std::fs::remove_file(&path);
    }
    let subject = subject(prepared, from);
    let answers = Answers::open(&path, &subject).map_err(|e| {
        let help = "scan again from the beginning, without --resume";
        Failure::unusable_with_help(format!("cannot go on with {}: {e}", path.display()), help)
    })?;
    for part in parts {
        let path = part.join(ANSWERS);
        std::fs::read(&path).and_then(|bytes| answers.take_in(&bytes, &subject)).map_err(|e| {
            Failure::unusable_with_help(
                format!("cannot take in {}: {e}", path.display()),
                "name folders with results of scans of this cell with --partition and the same --until",
            )
        })?;
    }
    Ok(answers)
}

/// What answers are about.
fn subject(prepared: &Prepared, from: &str) -> String {
    let fmus: Vec<&str> = prepared.subject.fmus.iter().map(|fmu| fmu.sha256.as_str()).collect();
    let files = prepared.subject.files.iter().map(|file| format!(" {}", file.sha256));
    format!(
        "fmi-hazard {}, answers 2, from {from}, cell {}{}, FMUs {}, told by bytes: {}",
        env!("CARGO_PKG_VERSION"),
        prepared.subject.cell_sha256,
        files.collect::<String>(),
        fmus.join(" "),
        prepared.compares_states_by_bytes()
    )
}

/// Nothing is left to go on with; answers of a part stay.
pub(super) fn finished(out: &Path, is_part: bool) {
    let _ = std::fs::remove_file(out.join(COMMAND));
    if !is_part {
        let _ = std::fs::remove_file(out.join(ANSWERS));
    }
}
