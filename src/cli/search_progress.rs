//! A search from a beginning while it runs: progress at the terminal, as events, and the hazards in a file as they are found.

use std::collections::BTreeSet;
use std::fs::File;
use std::io::{Seek as _, Write as _};
use std::path::Path;

use super::events::Event;
use super::exit::Failure;
use super::output::{self, Estimate, Levels, Progress};
use crate::record::hazard::Hazard;
use crate::record::judged::measure_cell;
use crate::scan::Prepared;
use crate::scan::options::{Method, Progress as Heard, ScanOptions};
use crate::stop::Stop;

/// The hazards as they are found.
pub(super) const LOG: &str = "hazards.jsonl";

/// What is shown of a search.
pub(super) struct Shown<'a> {
    stop: &'a Stop,
    /// Most iterations, and the actions of a sequence.
    iterations: u32,
    actions: u32,
    log: File,
    /// Ids of the hazards in the log.
    logged: BTreeSet<String>,
    progress: Progress,
    levels: Levels,
    estimate: Estimate,
    run_again: Option<Progress>,
}

impl<'a> Shown<'a> {
    /// Nothing yet; the log is in `out`.
    pub(super) fn new(prepared: &Prepared, options: &ScanOptions, stop: &'a Stop, out: &Path) -> Result<Self, Failure> {
        let log = File::create(out.join(LOG))
            .map_err(|e| Failure::unusable(format!("cannot write results to {}: {e}", out.display())))?;
        let iterating = !matches!(options.method, Method::Exhaustive(_));
        let actions = prepared.cell.search.actions;
        Ok(Self {
            stop,
            iterations: options.iterations,
            actions,
            log,
            logged: BTreeSet::new(),
            progress: Progress::new(if iterating { u64::from(options.iterations) } else { 1 }, "iterations"),
            levels: Levels::new(actions),
            estimate: Estimate::new(actions),
            run_again: None,
        })
    }

    /// What the search says.
    pub(super) fn hear(&mut self, heard: Heard<'_>) {
        match heard {
            Heard::Working => {}
            Heard::Shortening { done, of } => {
                output::phase(&format!("looking for shorter sequences: {done} of {of} hazards"));
            }
            Heard::Confirming { done, of } => {
                output::phase(&format!("confirming from a fresh start: {done} of {of} hazards"));
            }
            Heard::RunAgain { done, of } => {
                output::phase(&format!("running what the FMU did again from the start: {done} of {of}"));
                self.levels.finish();
                let again = self.run_again.get_or_insert_with(|| Progress::new(of as u64, "runs from the start"));
                again.at(done as u64, "");
            }
            Heard::SearchAgain { because } => self.again(because),
            Heard::Iteration { done, hazards } => {
                let counted = counted(hazards);
                output::phase(&format!("sequence {done} of at most {}, {counted}", self.iterations));
                self.progress.at(u64::from(done), &counted);
            }
            Heard::Level { depth, done, of, hazards, cost: _ } => self.level(depth, (done, of), hazards),
            Heard::Found(hazard) => self.found(hazard),
        }
    }

    /// What was found so far does not count.
    fn again(&mut self, because: &str) {
        self.progress.finish();
        self.levels.finish();
        output::warning(because);
        (self.run_again, self.levels) = (None, Levels::new(self.actions));
        self.logged.clear();
        let _ = self.log.set_len(0).and_then(|()| self.log.rewind());
    }

    /// So many states after so many actions, of all.
    fn level(&mut self, depth: usize, (done, of): (usize, usize), hazards: usize) {
        self.progress.finish();
        self.estimate.level(depth, done, of);
        let told = format!("{}{}", counted(hazards), self.estimate.left(self.stop.left()));
        output::phase(&format!("action {} of {}: {done}/{of} states, {told}", depth + 1, self.actions));
        self.levels.at(depth, done, of, &told);
    }

    fn found(&mut self, hazard: &Hazard) {
        output::event(&Event::Hazard { hazard });
        // One line each would bury the terminal; what auto found before is not told again.
        if output::verbose() && hazard.first_iteration > 0 {
            self.progress.line(&found(hazard));
        }
        if self.logged.insert(hazard.id.clone()) {
            // A full disk must not end the search: scan.json at the end reports the problem.
            let line = serde_json::to_string(hazard).unwrap_or_default();
            let _ = writeln!(self.log, "{line}").and_then(|()| self.log.flush());
        }
    }

    /// The search is over.
    pub(super) fn finish(&mut self) {
        self.progress.finish();
        self.levels.finish();
        if let Some(again) = &self.run_again {
            again.finish();
        }
    }
}

fn counted(hazards: usize) -> String {
    format!("{hazards} hazard{}", if hazards == 1 { "" } else { "s" })
}

fn found(h: &Hazard) -> String {
    format!(
        "     Found {}  {} <- {}  {}  {:.2}x  after {} actions ({:.2} s), iteration {}",
        h.id,
        h.body_region,
        h.robot_link,
        measure_cell(h.class, h.judged.as_ref(), (h.deciding_force_n(), h.deciding_limit_n(), h.speed_m_s)),
        h.ratio,
        h.actions.len(),
        h.time_s,
        h.first_iteration
    )
}
