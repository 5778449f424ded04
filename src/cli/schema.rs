//! `fmi-hazard schema`: the JSON Schemas of what people write and of what programs read.

use clap::ValueEnum;

use super::exit::{Failure, NO_HAZARD};
use super::output;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Which file
    #[arg(long, value_enum, default_value_t)]
    of: File,
}

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum File {
    /// The cell file, for editors
    #[default]
    Cell,
    /// scan.json
    Scan,
    /// What other commands print with --format json, and any with --progress json
    Commands,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let schema = match arguments.of {
        File::Cell => crate::cell::json_schema(),
        File::Scan => crate::record::model::json_schema(),
        File::Commands => super::printed::schema(),
    };
    output::json(&format!("{schema:#}\n"));
    Ok(NO_HAZARD)
}
