//! `fmi-hazard report`: the report of an earlier scan once more, with the replays that are asked for.

use std::path::PathBuf;

use super::exit::{Failure, INTERRUPTED, NO_HAZARD};
use super::hosting::HostingArguments;
use super::{earlier, output, results, stopping};
use crate::record::model::Headline;
use crate::report::page;
use crate::scan::causes::causes;
use crate::scan::replay;
use crate::stop::Stop;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A scan.json, or the folder with the results of a scan
    scan: PathBuf,
    /// Id of a hazard or a cause whose replay the report shall carry; can be given several times
    #[arg(long = "hazard", value_name = "ID")]
    hazards: Vec<String>,
    /// The replays of all hazards: a large file
    #[arg(long, conflicts_with = "hazards")]
    all: bool,
    /// Where to write it (default: report.html beside the scan)
    #[arg(long, value_name = "FILE")]
    out: Option<PathBuf>,
    #[command(flatten)]
    elsewhere: earlier::Elsewhere,
    #[command(flatten)]
    hosting: HostingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let mut recorded = earlier::read(&arguments.scan)?;
    let asked: Vec<String> = if arguments.all {
        recorded.hazards.iter().map(|hazard| hazard.id.clone()).collect()
    } else {
        let id = |id: &String| Ok(earlier::hazard(&recorded, id, &arguments.scan)?.id.clone());
        arguments.hazards.iter().map(id).collect::<Result<_, Failure>>()?
    };
    let stop = Stop::default();
    let prepared = earlier::prepare(&mut recorded, &arguments.elsewhere, &arguments.hosting.heeding(&stop)?)?;
    let prepared = earlier::as_plainly(prepared, &arguments.scan);
    stopping::by_signals(&stop);
    output::phase("running the sequences again");
    let cell_file = recorded.cell_file().unwrap_or_else(|| recorded.subject_path());
    let assessments = results::assessments(&cell_file)?;
    let hazards = results::shown(&recorded.causes, &recorded.hazards, &asked);
    let replays = results::replays(&prepared, prepared.rung, &hazards, |_, _, _, _| Ok(()))?;
    if stop.is_asked() {
        return Ok(INTERRUPTED);
    }
    let json = earlier::text_of(&arguments.scan)?;
    let mut scan: serde_json::Value = serde_json::from_str(&json).map_err(Failure::unusable)?;
    if recorded.causes.is_empty() {
        // As older versions wrote it.
        let causes = causes(&prepared, prepared.rung, &recorded.hazards, None);
        scan["causes"] = serde_json::to_value(causes).map_err(Failure::unusable)?;
    }
    if scan["headline"].is_null() {
        let headline = Headline::of_an_earlier_version();
        scan["headline"] = serde_json::to_value(headline).map_err(Failure::unusable)?;
    }
    let subject = &prepared.subject;
    let reproduce = earlier::reproduce(&arguments.scan)
        .unwrap_or_else(|| format!("fmi-hazard scan {}", recorded.subject.path.display()));
    let page =
        page::render(&scan, &subject.title(), &reproduce, &assessments, &replay::scenery(&prepared), &replays, None);
    let out = arguments.out.clone().unwrap_or_else(|| recorded.folder.join("report.html"));
    output::write_file(&out, &page.map_err(Failure::unusable)?)?;
    output::note(&format!(" Report  {} with {} replays", out.display(), replays.len()));
    Ok(NO_HAZARD)
}
