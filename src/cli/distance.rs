//! `fmi-hazard distance`: how far safeguards stand from the robots, against the safety distance of ISO 13855.

use std::path::PathBuf;

use clap::ValueEnum;

use super::exit::{Failure, HAZARDS, INCONCLUSIVE, NO_HAZARD};
use super::hosting::HostingArguments;
use super::output::{self, Format};
use crate::report::distance::Placed;
use crate::scan::distance::{Asked, distances};
use crate::scan::prepare::prepare_in;
use crate::standards::iso_13855;

/// What this command's exit code means.
const HELP: &str = "Exit codes: 0 all safeguards are far enough; 1 some are too near; 2 usage, cell file or FMU file error; 3 the FMU \
failed while running; 4 of some it is not known";

#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub(super) struct Arguments {
    /// A cell file (.toml), or an FMU with a cell file beside it or inside it
    path: PathBuf,
    /// The cell file of an FMU that has none of its own
    #[arg(long)]
    cell: Option<PathBuf>,
    /// Edition of ISO 13855
    #[arg(long, value_enum, default_value_t)]
    edition: Edition,
    /// Resolution of light curtains and scanner fields of which the cell file says none, mm
    #[arg(long, value_name = "MM", value_parser = millimetres)]
    resolution_mm: Option<f64>,
    /// How long the FMU is run each time, s: a whole cycle of the robots or more (default: 10, or up to its stopTime)
    #[arg(long = "for", value_name = "SECONDS", value_parser = seconds)]
    run_s: Option<f64>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    hosting: HostingArguments,
}

/// Editions.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Edition {
    /// That of 2010
    #[value(name = "2010")]
    Of2010,
    /// That of 2024
    #[default]
    #[value(name = "2024")]
    Of2024,
}

fn millimetres(text: &str) -> Result<f64, String> {
    within(text, 500.0)
}

fn seconds(text: &str) -> Result<f64, String> {
    within(text, 3600.0)
}

/// A number above 0, and no more than so.
fn within(text: &str, most: f64) -> Result<f64, String> {
    let number: f64 = text.parse().map_err(|_| "this is no number".to_owned())?;
    if number > 0.0 && number <= most { Ok(number) } else { Err(format!("use more than 0, and {most} at most")) }
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let hosting = arguments.hosting.hosting()?;
    let prepared = prepare_in(&arguments.path, arguments.cell.as_deref(), &hosting)?;
    let asked = Asked {
        edition: match arguments.edition {
            Edition::Of2010 => iso_13855::Edition::Of2010,
            Edition::Of2024 => iso_13855::Edition::Of2024,
        },
        resolution_m: arguments.resolution_mm.map(|mm| mm / 1000.0),
        run_s: arguments.run_s,
    };
    let found = distances(&prepared, &asked).map_err(|error| Failure::running(format!("the FMU failed: {error}")))?;
    match arguments.format {
        Format::Json => output::json_of(&found)?,
        Format::Table => {
            output::result(&found.render(&arguments.path.display().to_string()));
            found.warnings.iter().for_each(|warning| output::warning(warning));
        }
    }
    Ok(match found.placed() {
        Placed::FarEnough => NO_HAZARD,
        Placed::TooNear => HAZARDS,
        Placed::NotKnown => INCONCLUSIVE,
    })
}
