//! `fmi-hazard compare`: two scans side by side.

use std::path::PathBuf;

use super::exit::{Failure, HAZARDS, INCONCLUSIVE, NO_HAZARD};
use super::output::Format;
use super::{earlier, output};
use crate::report::difference::Difference;

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

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let (before, after) = (earlier::read(&arguments.before)?, earlier::read(&arguments.after)?);
    let texts = [&before, &after].map(earlier::cell_text);
    let difference = Difference::between(&before, &after, [texts[0].as_deref(), texts[1].as_deref()]);
    match arguments.format {
        Format::Table => output::result(&difference.render(output::view().verbose)),
        Format::Json => {
            let text = serde_json::to_string_pretty(&difference).map_err(Failure::unusable)?;
            output::json(&(text + "\n"));
        }
    }
    Ok(match (difference.is_worse(), difference.is_shown()) {
        (true, _) => HAZARDS,
        (false, true) => NO_HAZARD,
        (false, false) => INCONCLUSIVE,
    })
}
