//! `fmi-hazard replay`: simulate a recorded hazard again and say whether it reproduces.

use std::path::PathBuf;
use std::sync::Arc;

use super::exit::{FMU_FAILED, Failure, HAZARDS, NO_HAZARD};
use super::hosting::HostingArguments;
use super::{earlier, output, recording};
use crate::report::model::Hazard;
use crate::scan::StateChoice;
use crate::sim::replay::replay;
use crate::standards::BodyRegion;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A scan.json, or the folder with the results of a scan
    scan: PathBuf,
    /// Id of a hazard in it, or of a cause, or `all`
    id: String,
    #[command(flatten)]
    elsewhere: earlier::Elsewhere,
    /// Write the hazard as a recording for Foxglove and PlotJuggler (builds with the feature mcap)
    #[arg(long, value_name = "FILE")]
    mcap: Option<PathBuf>,
    #[command(flatten)]
    hosting: HostingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let recorded = earlier::read(&arguments.scan)?;
    let wanted: Vec<&Hazard> = if arguments.id == "all" && !recorded.hazards.is_empty() {
        recorded.hazards.iter().collect()
    } else {
        vec![earlier::hazard(&recorded, &arguments.id, &arguments.scan)?]
    };
    if let Some(file) = &arguments.mcap {
        recording::possible(wanted.len(), file)?;
    }
    let prepared = earlier::prepare(&recorded, &arguments.elsewhere, &arguments.hosting.hosting()?)?;
    let mut still_there = false;
    for hazard in wanted {
        let there = match prepared.of_hazard(hazard) {
            Ok(there) => there,
            Err(error) => {
                output::result(&format!("{} NOT reproduced: {error}\n", hazard.id));
                continue;
            }
        };
        let cell = (Arc::clone(&there.cell), Arc::clone(&there.binding));
        let again = match replay(cell.0, cell.1, there.plant(StateChoice::Replay), &hazard.actions) {
            Ok(again) => again,
            Err(error) => {
                output::error(&format!("{}: the FMU failed: {error}", hazard.id));
                return Ok(FMU_FAILED);
            }
        };
        still_there |= again.is_some();
        let recorded = told(hazard.deciding_force_n(), hazard.time_s, hazard.body_region, &hazard.robot_link);
        let begins = hazard.begins.map_or_else(String::new, |begins| format!("; begins {}", begins.words()));
        let line = match &again {
            Some(f) => {
                let link = &there.cell.links[f.contact.link].name;
                let now = told(f.contact.deciding_force_n(), f.time_s, f.contact.region, link);
                // Two links may hit equally hard.
                let same = f.contact.force_n.to_bits() == hazard.force_n.to_bits()
                    && f.time_s.to_bits() == hazard.time_s.to_bits()
                    && (f.contact.region, link) == (hazard.body_region, &hazard.robot_link);
                match same {
                    true => format!("{} reproduced: {now}, as recorded to the last bit{begins}", hazard.id),
                    false => format!("{} DIFFERS: {now}, recorded {recorded}", hazard.id),
                }
            }
            None => format!("{} NOT reproduced: the sequence ends without an unsafe contact", hazard.id),
        };
        output::result(&(line + "\n"));
        if let Some(file) = &arguments.mcap {
            recording::write(&there, hazard, file)?;
            output::note(&format!("   Wrote   {}", file.display()));
        }
    }
    Ok(if still_there { HAZARDS } else { NO_HAZARD })
}

/// A contact in a line.
fn told(force_n: f64, time_s: f64, region: BodyRegion, link: &str) -> String {
    format!("{force_n:.3} N at {time_s:.3} s ({region} <- {link})")
}
