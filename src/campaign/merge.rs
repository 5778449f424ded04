//! All results of a campaign together: the same bytes in whatever order, by whomever and how often its tasks were done.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;

use super::CampaignError;
use super::manifest::{Manifest, Task};
use super::part::{ANSWERS, Runner, folder_of};
use super::sealed::{self, Kept, kept};
use super::status::status;
use crate::report::survey::{Row, ScanOutcome, Survey};
use crate::report::{survey_charts, survey_page};
use crate::scan::Hosting;
use crate::sim::answers::Answers;
use crate::stop::Stop;

/// How it went, which is no result.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(crate) struct Merged {
    /// Tasks that had no result and were worked out here.
    pub worked_out: usize,
    /// Questions of divided searches whose answers were there, and those that nobody had answered.
    pub looked_up: u64,
    /// See there.
    pub unanswered: u64,
}

/// Puts a campaign together in its folder: `campaign.json` and what is made from it, and the `scan.json` of each scan. What is
/// missing is worked out if `work_out` says so.
///
/// # Errors
/// When something is missing, cannot be worked out, or cannot be written.
pub(crate) fn merge(
    folder: &Path,
    manifest: &Manifest,
    hosting: &Hosting,
    (workers, stop): (usize, &Stop),
    work_out: bool,
    tell: &mut dyn FnMut(usize, usize),
) -> Result<Option<(Survey, Merged)>, CampaignError> {
    let state = status(folder, manifest);
    let of = manifest.tasks().len();
    if let (Some(first), false) = (state.missing.first(), work_out) {
        let first = format!("{} ({})", manifest.name(*first), manifest.words(first.scan));
        return Err(CampaignError::Missing { missing: state.missing.len(), of, first });
    }
    let mut runner = Runner::new(folder, manifest, hosting, workers, stop.clone());
    let mut merged = Merged::default();
    let mut rows = Vec::with_capacity(manifest.scans.len());
    for scan in 0..manifest.scans.len() {
        tell(scan, manifest.scans.len());
        let Some(bytes) = scan_json(folder, manifest, scan, &mut runner, stop, &mut merged)? else {
            return Ok(None);
        };
        let own = folder_of(scan);
        sealed::write(&folder.join(&own).join("scan.json"), &bytes)?;
        rows.push(row(manifest, scan, &own, &bytes)?);
    }
    forget_others(folder, manifest.scans.len());
    let survey = Survey::new(&manifest.campaign, &manifest.tool, &manifest.sweeps, rows);
    let json = serde_json::to_string_pretty(&survey).map_err(|e| CampaignError::Ours(e.to_string()))? + "\n";
    let table = survey.csv().map_err(CampaignError::Ours)?;
    let pictures = survey_charts::all(&survey);
    for (name, text) in [("campaign.json", &json), ("campaign.csv", &table)] {
        sealed::write(&folder.join(name), text.as_bytes())?;
    }
    for name in survey_charts::NAMES {
        let drawn = pictures.iter().find(|picture| picture.name == name);
        match drawn {
            Some(picture) => sealed::write(&folder.join(name), picture.svg.as_bytes())?,
            None => drop(std::fs::remove_file(folder.join(name))),
        }
    }
    sealed::write(&folder.join("campaign.html"), survey_page::render(&survey, &pictures).as_bytes())?;
    Ok(Some((survey, merged)))
}

/// What stands in the `scan.json` of a scan; nothing if it was stopped.
fn scan_json(
    folder: &Path,
    manifest: &Manifest,
    scan: usize,
    runner: &mut Runner<'_>,
    stop: &Stop,
    merged: &mut Merged,
) -> Result<Option<Vec<u8>>, CampaignError> {
    let whole = Task { scan, part: None };
    if let Kept::Whole(bytes, _) = kept(folder, &manifest.name(whole)) {
        return Ok(Some(bytes));
    }
    let (answers, missing) = answers(folder, manifest, scan)?;
    let mut go_on = |_: crate::scan::Progress<'_>| match stop.ends_search() {
        true => ControlFlow::Break(()),
        false => ControlFlow::Continue(()),
    };
    let began = std::time::Instant::now();
    let Some(bytes) = runner.scan(scan, &answers, &mut go_on)? else { return Ok(None) };
    let (looked_up, asked) = answers.remembered();
    merged.worked_out += missing;
    merged.looked_up += looked_up;
    merged.unanswered += asked - looked_up;
    sealed::keep(folder, &manifest.name(whole), &bytes, began.elapsed().as_secs_f64())?;
    Ok(Some(bytes))
}

/// What the parts of a scan's search have answered, and how many tasks of it have no result.
fn answers(folder: &Path, manifest: &Manifest, scan: usize) -> Result<(Arc<Answers>, usize), CampaignError> {
    let (answers, mut missing) = (Arc::new(Answers::default()), 0);
    for task in manifest.tasks_of(scan) {
        match kept(folder, &manifest.name(task)) {
            Kept::Whole(bytes, _) if task.part.is_some() => {
                answers.take_in(&bytes, ANSWERS).map_err(|e| CampaignError::Ours(e.to_string()))?;
            }
            _ => missing += 1,
        }
    }
    Ok((answers, missing))
}

/// A row of the table.
fn row(manifest: &Manifest, scan: usize, own: &Path, bytes: &[u8]) -> Result<Row, CampaignError> {
    let entry = &manifest.scans[scan];
    let cell = &manifest.cells[entry.cell];
    let outcome =
        ScanOutcome::read(bytes).map_err(|e| CampaignError::Ours(format!("{} cannot be read: {e}", own.display())))?;
    Ok(Row {
        number: scan + 1,
        cell: cell.name.clone(),
        of: cell.of.clone(),
        at: cell.at.clone(),
        body: cell.body.clone(),
        begins: entry.begins,
        beginning: entry.beginning,
        strategy: entry.strategy.clone(),
        seed: entry.seed,
        folder: own.display().to_string(),
        outcome,
    })
}

/// Results of scans that an earlier plan had more.
fn forget_others(folder: &Path, scans: usize) {
    for entry in std::fs::read_dir(folder.join("scans")).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let number = name.to_str().and_then(|name| name.parse::<usize>().ok());
        if number.is_some_and(|number| number > scans) {
            let _ = std::fs::remove_file(entry.path().join("scan.json"));
            let _ = std::fs::remove_dir(entry.path());
        }
    }
}
