//! Telling how the search for changes of a cell goes, for `explain` and for the end of a scan.

use std::sync::Mutex;

use super::output::{self, Progress};
use crate::record::advice::RiskReductionOutcome;
use crate::scan::risk_reduction::RiskReductionEvent;

/// What is told, by threads one after the other.
pub(super) struct ProgressPrinter {
    progress: Mutex<Option<Progress>>,
    /// Also each change as soon as something is known of it.
    each: bool,
}

impl ProgressPrinter {
    pub(super) fn new(each: bool) -> Self {
        Self { progress: Mutex::new(None), each }
    }

    /// Hears how it goes.
    pub(super) fn hear(&self, told: &RiskReductionEvent<'_>) {
        let Ok(mut progress) = self.progress.lock() else { return };
        match told {
            RiskReductionEvent::Tried(done, of) => {
                output::phase(&format!("trying changes: {done} of {of}"));
                let bar = progress.get_or_insert_with(|| Progress::new(*of as u64, "changes tried"));
                bar.at(*done as u64, "");
                if done == of {
                    bar.finish();
                    *progress = None;
                }
            }
            RiskReductionEvent::Completely(number, of) => {
                output::phase(&format!("looking at every sequence with change {number} of {of}"));
                if self.each {
                    output::note(&format!("  change {number} of {of} that held so far: looking at every sequence"));
                }
            }
            RiskReductionEvent::Held(remedy) if self.each => {
                let gone = match remedy.outcome {
                    RiskReductionOutcome::OthersRemain(_) => "this cause is not met",
                    _ => "nothing is met",
                };
                let line = format!("   So far {gone} with: {}", remedy.change);
                progress.as_ref().map_or_else(|| output::note(&line), |bar| bar.line(&line));
            }
            RiskReductionEvent::Done(remedy) if self.each => {
                remedy.told().iter().for_each(|line| output::note(&format!("   {line}")));
            }
            RiskReductionEvent::Held(_) | RiskReductionEvent::Done(_) => {}
        }
    }
}
