//! One task: a scan of one cell from one of its beginnings, whose result is what `scan.json` has after the same scan alone; or a part
//! of the questions of one, whose result is their answers.

use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::Arc;

use clap::ValueEnum as _;

use super::CampaignError;
use super::description::{AUTO, EXHAUSTIVE};
use super::manifest::{Manifest, ScanEntry, Task};
use crate::cell::find::open;
use crate::scan::moved;
use crate::scan::portion::portion;
use crate::scan::prepare::prepare_in;
use crate::scan::probe::wrong_polarities;
use crate::scan::{Exhaustive, Hosting, Method, Prepared, Progress, ScanOptions, StateChoice, StrategyName, scan_with};
use crate::search::exhaustive::Budget;
use crate::sequences::Merge;
use crate::sim::answers::{Answers, Share};
use crate::stop::Stop;

/// Work of the exhaustive part of `auto` unless told otherwise, millions of boxes: as in a scan alone.
const AUTO_WORK: u64 = 600;

/// What answers of a part say that they are; a task's name says of which search.
pub(super) const ANSWERS: &str = "answers 2";

/// Does tasks, one after the other. A cell is prepared once for those that follow each other.
pub(crate) struct Runner<'a> {
    folder: &'a Path,
    manifest: &'a Manifest,
    hosting: &'a Hosting,
    workers: usize,
    stop: Stop,
    ready: Option<(usize, Prepared)>,
}

/// Where the result of a scan, from 0, is when all are put together, in the folder of the campaign.
#[must_use]
pub(crate) fn folder_of(scan: usize) -> PathBuf {
    Path::new("scans").join(format!("{:04}", scan + 1))
}

impl<'a> Runner<'a> {
    /// For the tasks of this plan; `workers` threads search, which changes no result.
    #[must_use]
    pub(crate) const fn new(
        folder: &'a Path,
        manifest: &'a Manifest,
        hosting: &'a Hosting,
        workers: usize,
        stop: Stop,
    ) -> Self {
        Self { folder, manifest, hosting, workers, stop, ready: None }
    }

    /// The result of a task; nothing if it was stopped.
    ///
    /// # Errors
    /// When the cell cannot be simulated, or is not the one that was planned.
    pub(crate) fn result(
        &mut self,
        task: Task,
        tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
    ) -> Result<Option<Vec<u8>>, CampaignError> {
        match task.part {
            None => self.scan(task.scan, &Arc::default(), tell),
            Some(share) => self.part(task.scan, share, tell),
        }
    }

    /// The answers of a part of a search; nothing if it was stopped.
    fn part(
        &mut self,
        scan: usize,
        share: Share,
        tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
    ) -> Result<Option<Vec<u8>>, CampaignError> {
        let entry = &self.manifest.scans[scan];
        let (workers, stop) = (self.workers, self.stop.clone());
        let prepared = self.prepared(entry.cell)?.beginning(entry.beginning - 1)?;
        let Method::Exhaustive(how) = options(self.manifest, entry, &prepared, workers).method else {
            return Err(CampaignError::Ours("only exhaustive searches have parts".to_owned()));
        };
        stop.searching();
        let Some(answers) = portion(&prepared, how, share, tell)? else { return Ok(None) };
        let bytes = answers.to_bytes(ANSWERS).map_err(|e| CampaignError::Ours(e.to_string()))?;
        Ok((!stop.is_asked()).then_some(bytes))
    }

    /// What stands in the `scan.json` of a scan of which these answers are known; nothing if it was stopped.
    pub(super) fn scan(
        &mut self,
        scan: usize,
        answers: &Arc<Answers>,
        tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>,
    ) -> Result<Option<Vec<u8>>, CampaignError> {
        let entry = &self.manifest.scans[scan];
        let folder = self.folder.join(folder_of(scan));
        std::fs::create_dir_all(&folder).map_err(CampaignError::machine("make the folder", &folder))?;
        let (workers, stop) = (self.workers, self.stop.clone());
        let prepared = self.prepared(entry.cell)?.beginning(entry.beginning - 1)?;
        let options = options(self.manifest, entry, &prepared, workers);
        stop.searching();
        let scanned = scan_with(&prepared, options, answers, tell)?;
        if stop.is_asked() {
            return Ok(None);
        }
        let report = moved::relative(&scanned.report, &folder);
        let text = serde_json::to_string_pretty(&report).map_err(|e| CampaignError::Ours(e.to_string()))?;
        Ok(Some((text + "\n").into_bytes()))
    }

    /// The cell of this number, as it was planned.
    fn prepared(&mut self, cell: usize) -> Result<&Prepared, CampaignError> {
        let ready = match self.ready.take() {
            Some(ready) if ready.0 == cell => ready,
            _ => {
                let entry = &self.manifest.cells[cell];
                let path = self.folder.join(&entry.path);
                entry.same_as(&open(&path, None)?)?;
                let mut prepared = prepare_in(&path, None, self.hosting)?;
                prepared.warn(wrong_polarities(&prepared));
                (cell, prepared)
            }
        };
        Ok(&self.ready.insert(ready).1)
    }
}

/// How a scan searches: as `fmi-hazard scan` does when it is told the same.
fn options(manifest: &Manifest, entry: &ScanEntry, prepared: &Prepared, workers: usize) -> ScanOptions {
    let own = &manifest.search;
    let auto = entry.strategy == AUTO;
    let work = own.max_work.or_else(|| auto.then_some(AUTO_WORK)).map_or(u64::MAX, |w| w.saturating_mul(1_000_000));
    let bytes = own.max_memory.saturating_mul(1_000_000);
    let budget = Budget { states: own.max_states, bytes, work, drop: true };
    let how = Exhaustive { budget, merge: Merge::Auto, workers };
    let method = match entry.strategy.as_str() {
        EXHAUSTIVE => Method::Exhaustive(how),
        AUTO => Method::Auto(StrategyName::default(), how),
        name => Method::Strategy(StrategyName::from_str(name, false).unwrap_or_default()),
    };
    ScanOptions {
        method,
        seed: entry.seed.unwrap_or(prepared.cell.search.seed),
        iterations: own.iterations.unwrap_or(prepared.cell.search.iterations),
        stop_at_first: own.stop_at_first,
        posture_sweep: true,
        state: StateChoice::Auto,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::campaign::plan::plan;

    #[test]
    fn a_scan_that_was_stopped_has_no_result() {
        let dir = tempfile::tempdir().unwrap();
        crate::examples::export(dir.path()).unwrap();
        let (path, folder) = (dir.path().join("few.toml"), dir.path().join("few"));
        let text = "schema = 1\nname = \"few\"\ncells = [\"sensor-mat/cell.toml\"]\n[over.search]\nactions = 1\n\
                    [search]\nstrategies = [\"random\"]\niterations = 3\n";
        std::fs::write(&path, text).unwrap();
        let manifest = plan(&path, &folder).unwrap();
        let stop = Stop::default();
        let hosting = Hosting::InProcess(stop.clone());
        let mut runner = Runner::new(&folder, &manifest, &hosting, 1, stop.clone());
        let mut result = |stops: bool| {
            // Asked while it searches.
            let mut tell = |_: Progress<'_>| {
                if stops {
                    stop.ask();
                    return ControlFlow::Break(());
                }
                ControlFlow::Continue(())
            };
            runner.result(manifest.tasks()[0], &mut tell).unwrap()
        };
        assert!(result(false).is_some());
        assert_eq!(result(true), None);
    }
}
