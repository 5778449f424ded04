//! `fmi-hazard replay`: simulate recorded hazards again and say whether they reproduce, or in a changed cell whether they are still there.

mod changed;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use schemars::JsonSchema;
use serde::Serialize;

use super::events::Event;
use super::exit::{Failure, HAZARDS, INCONCLUSIVE, NO_HAZARD};
use super::hosting::HostingArguments;
use super::output::Format;
use super::{earlier, output, recording};
use crate::hazard::Finding;
use crate::record::begin::InitialConditionRecord;
use crate::record::hazard::Hazard;
use crate::record::recorded::Recorded;
use crate::report::verified::Standing;
use crate::scan::verify::Again;
use crate::scan::{Prepared, StateChoice};
use crate::sim::replay::{Wanted, replay_watched};
use crate::standards::BodyRegion;

/// A recorded hazard, simulated again.
#[derive(Debug, Serialize, JsonSchema)]
#[schemars(rename = "ReplayedHazard")]
pub(super) struct Replayed {
    /// Its id.
    id: String,
    /// What came of it.
    result: Reproduction,
    /// The contact as it was recorded.
    recorded: ReplayedContact,
    /// The contact now, if there is an unsafe one.
    now: Option<ReplayedContact>,
    /// Where it begins, if that is not where the cell file says.
    begins: Option<InitialConditionRecord>,
    /// Why there is none.
    because: Option<String>,
}

/// What came of a hazard that was simulated again.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
enum Reproduction {
    /// As recorded, to the last bit.
    Reproduced,
    /// There is an unsafe contact, but another one.
    Differs,
    /// There is none.
    NotReproduced,
}

/// A contact.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "ReplayedContact")]
struct ReplayedContact {
    /// Force by the speed that decides, N.
    force_n: f64,
    /// When, s.
    time_s: f64,
    /// What is hit.
    body_region: BodyRegion,
    /// By what.
    robot_link: String,
}

impl ReplayedContact {
    fn words(&self) -> String {
        let Self { force_n, time_s, body_region, robot_link } = self;
        format!("{force_n:.3} N at {time_s:.3} s ({body_region} <- {robot_link})")
    }
}

impl Replayed {
    fn line(&self) -> String {
        let Self { id, recorded, .. } = self;
        let begins = self.begins.map_or_else(String::new, |begins| format!("; begins {}", begins.words()));
        match (&self.now, self.result) {
            (Some(now), Reproduction::Reproduced) => {
                format!("{id} reproduced: {}, as recorded to the last bit{begins}", now.words())
            }
            (Some(now), _) => format!("{id} DIFFERS: {}, recorded {}", now.words(), recorded.words()),
            (None, _) => format!("{id} NOT reproduced: {}", self.because.as_deref().unwrap_or_default()),
        }
    }
}

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A scan.json, or the folder with the results of a scan
    scan: PathBuf,
    /// Id of a hazard in it, or of a cause, or `all`
    #[arg(default_value = "all")]
    id: String,
    /// Try the hazards in this changed cell, from where they began: a cell file (.toml), or an FMU with a cell file beside it or inside it,
    /// or named with --cell. Exit code 1 if one is still there, 4 if one is not shown to be gone
    #[arg(long, value_name = "CELL", conflicts_with_all = ["fmu", "mcap"])]
    changed: Option<PathBuf>,
    /// With --changed: write the result as JUnit XML into this file too
    #[arg(long, value_name = "FILE", requires = "changed")]
    junit: Option<PathBuf>,
    #[command(flatten)]
    elsewhere: earlier::Elsewhere,
    /// Write the hazard as a recording for Foxglove and PlotJuggler
    #[arg(long, value_name = "FILE")]
    mcap: Option<PathBuf>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    hosting: HostingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let mut recorded = earlier::read(&arguments.scan)?;
    let wanted = |recorded: &Recorded| -> Result<Vec<Hazard>, Failure> {
        if arguments.id == "all" && !recorded.hazards.is_empty() {
            return Ok(recorded.hazards.clone());
        }
        Ok(vec![earlier::hazard(recorded, &arguments.id, &arguments.scan)?.clone()])
    };
    if let Some(changed) = &arguments.changed {
        // Where nothing was known nothing is tried.
        let known = if recorded.hazards.is_empty() && arguments.id == "all" { Vec::new() } else { wanted(&recorded)? };
        return changed::run(arguments, &recorded, &known, changed);
    }
    let count = wanted(&recorded)?.len();
    if let Some(file) = &arguments.mcap {
        recording::possible(count, file)?;
    }
    let prepared = earlier::prepare(&mut recorded, &arguments.elsewhere, &arguments.hosting.hosting()?)?;
    let known = Again::new(&prepared, &recorded)?;
    let wanted = wanted(&recorded)?;
    let mut all = Vec::with_capacity(count);
    let (mut shown, total) = (true, count as u64);
    for (done, hazard) in (1..).zip(&wanted) {
        let mut replayed = again(&prepared, hazard, arguments.mcap.as_deref())?;
        if replayed.now.is_none() {
            // Whether that says something.
            let outcome = known.verify(hazard)?.outcome;
            shown &= outcome.standing() == Standing::Fixed;
            if matches!(outcome.standing(), Standing::NotJudged | Standing::NotShown) {
                replayed.because = Some(outcome.words());
            }
        }
        if arguments.format == Format::Table {
            output::result(&(replayed.line() + "\n"));
        }
        all.push(replayed);
        output::event(&Event::Progress { done, total, unit: "hazards", text: "" });
    }
    if arguments.format == Format::Json {
        output::json_of(&all)?;
    }
    Ok(match all.iter().any(|replayed| replayed.now.is_some()) {
        true => HAZARDS,
        false if shown => NO_HAZARD,
        false => INCONCLUSIVE,
    })
}

/// A hazard once more.
fn again(prepared: &Prepared, hazard: &Hazard, recording: Option<&Path>) -> Result<Replayed, Failure> {
    let recorded = ReplayedContact {
        force_n: hazard.deciding_force_n(),
        time_s: hazard.time_s,
        body_region: hazard.body_region,
        robot_link: hazard.robot_link.clone(),
    };
    let replayed = |result, now, because| Replayed {
        id: hazard.id.clone(),
        result,
        recorded: recorded.clone(),
        now,
        begins: hazard.begins,
        because,
    };
    let there = match prepared.of_hazard(hazard) {
        Ok(there) => there,
        Err(error) => return Ok(replayed(Reproduction::NotReproduced, None, Some(error.to_string()))),
    };
    let cell = (Arc::clone(&there.cell), Arc::clone(&there.binding));
    let who = there.cell.who(hazard.person.as_deref());
    // In one action somebody may be hit first and clamped then.
    let like = |found: &Finding| {
        let link = &there.cell.links[found.contact.link].name;
        found.class == hazard.class
            && found.time_s.to_bits() == hazard.time_s.to_bits()
            && (found.contact.region, link) == (hazard.body_region, &hazard.robot_link)
    };
    let plant = there.plant(StateChoice::Replay);
    let again = replay_watched(cell.0, cell.1, plant, &hazard.actions, &Wanted { who, like: &like })
        .map_err(|error| Failure::running(format!("{}: the FMU failed: {error}", hazard.id)))?;
    if let Some(file) = recording {
        recording::write(&there, hazard, file)?;
        output::note(&format!("   Wrote   {}", file.display()));
    }
    let Some(found) = again.found else {
        let because = "the sequence ends without an unsafe contact".to_owned();
        return Ok(replayed(Reproduction::NotReproduced, None, Some(because)));
    };
    let contact = &found.contact;
    let now = ReplayedContact {
        force_n: contact.deciding_force_n(),
        time_s: found.time_s,
        body_region: contact.region,
        robot_link: there.cell.links[contact.link].name.clone(),
    };
    // Two links may hit equally hard.
    let same = contact.force_n.to_bits() == hazard.force_n.to_bits()
        && now.time_s.to_bits() == hazard.time_s.to_bits()
        && (now.body_region, &now.robot_link) == (hazard.body_region, &hazard.robot_link);
    let result = if same { Reproduction::Reproduced } else { Reproduction::Differs };
    Ok(replayed(result, Some(now), None))
}
