//! `fmi-hazard compare`: two scans side by side.

use std::path::{Path, PathBuf};

use clap::ValueEnum;
use sha2::{Digest as _, Sha256};

use super::exit::{Failure, HAZARDS, NO_HAZARD};
use super::output;
use crate::report::difference::Difference;
use crate::report::recorded::Recorded;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The earlier scan: its scan.json, or the folder with its results
    before: PathBuf,
    /// The later scan
    after: PathBuf,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people
    #[default]
    Table,
    /// For programs
    Json,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let (before, after) = (read(&arguments.before)?, read(&arguments.after)?);
    let texts = [&before, &after].map(cell_text);
    let difference = Difference::between(&before, &after, [texts[0].as_deref(), texts[1].as_deref()]);
    match arguments.format {
        Format::Table => output::result(&difference.render()),
        Format::Json => {
            let text = serde_json::to_string_pretty(&difference).map_err(Failure::unusable)?;
            output::json(&(text + "\n"));
        }
    }
    Ok(if difference.is_worse() { HAZARDS } else { NO_HAZARD })
}

/// A recorded scan.
pub(super) fn read(path: &Path) -> Result<Recorded, Failure> {
    Recorded::read(path).map_err(|error| Failure::unusable_with_help(&error, error.help()))
}

/// The cell file of a scan, if it is still where it was and as it was.
fn cell_text(scan: &Recorded) -> Option<String> {
    let text = std::fs::read_to_string(&scan.subject.path).ok()?;
    let hash: String = Sha256::digest(text.as_bytes()).iter().map(|byte| format!("{byte:02x}")).collect();
    (hash == scan.subject.cell_sha256).then_some(text)
}
