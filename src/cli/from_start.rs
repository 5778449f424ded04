//! `fmi-hazard scan` from the beginnings in the cell file: one after the other, each with results of its own.

use std::ops::ControlFlow;
use std::path::Path;
use std::sync::Arc;
use std::time::Instant;

use super::changes::ProgressPrinter;
use super::exit::{self, Failure};
use super::output::{self, Format};
use super::run::Run;
use super::search_progress::{LOG, Shown};
use super::{earlier, initial_conditions, results, resume};
use crate::host::selftest::StateRestore;
use crate::record::model::{ScanReport, Verdict};
use crate::report::baseline::Baseline;
use crate::report::terminal;
use crate::scan::advise::advise;
use crate::scan::options::Progress;
use crate::scan::{Prepared, Scanned, scan_with};
use crate::sim::answers::Answers;

/// What came out of a search.
pub(super) struct Ended {
    report: ScanReport,
    pub(super) code: u8,
}

impl Run<'_> {
    /// One beginning after the other.
    pub(super) fn all(
        &self,
        all: &[Prepared],
        baselines: &[Option<Baseline>],
        out: &Path,
        keeps: bool,
    ) -> Result<u8, Failure> {
        let mut table = initial_conditions::Table::initial_condition_of(out, &all[0].subject, self.goes_on);
        table.keep(out)?;
        let mut left = all.iter().filter(|prepared| !table.has(prepared.cell.beginning + 1)).count();
        for (prepared, baseline) in all.iter().zip(baselines) {
            let number = prepared.cell.beginning + 1;
            if table.has(number) {
                continue;
            }
            // What one does not use of its time, the others have.
            if let Some(time) = self.time_left() {
                self.stop.within(time / u32::try_from(left).unwrap_or(1));
            }
            left -= 1;
            if let Some(beginning) = &prepared.subject.beginning {
                output::note(&format!("   Begins  {number} of {}: {}", all.len(), beginning.words()));
            }
            let own = out.join(initial_conditions::folder(number));
            let (hazards, code) = match self.one(prepared, baseline.as_ref(), &own, keeps) {
                Ok(Ended { report, code }) => (report.hazards, code),
                // The others are searched all the same.
                Err(failure) if failure.code() == exit::FMU_FAILED => (Vec::new(), output::failed(&failure)),
                Err(failure) => return Err(failure),
            };
            if code == exit::INTERRUPTED {
                return Ok(code);
            }
            if keeps {
                resume::finished(&own, false);
            }
            table.add(&prepared.subject, &hazards, code, out)?;
        }
        match self.arguments.format {
            Format::Json => output::json_of(&table)?,
            Format::Table => output::result(&table.render(out)),
        }
        Ok(table.exit_code())
    }

    /// A search from one beginning, and its results.
    pub(super) fn one(
        &self,
        prepared: &Prepared,
        baseline: Option<&Baseline>,
        out: &Path,
        keeps: bool,
    ) -> Result<Ended, Failure> {
        let Self { arguments, path, cell_path, assessments, stop, .. } = *self;
        let options = arguments.options(&prepared.cell.search);
        stop.searching();
        let cannot = |e: std::io::Error| Failure::unusable(format!("cannot write results to {}: {e}", out.display()));
        std::fs::create_dir_all(out).map_err(cannot)?;
        let from = format!("the start, beginning {}", prepared.cell.beginning + 1);
        let kept = || resume::answers(out, prepared, &from, self.goes_on, &[]);
        let answers = Arc::new(if keeps { kept()? } else { Answers::default() });
        let before = self.goes_on.then(|| InterruptedScan::of(out)).flatten();
        let mut shown = Shown::new(prepared, &options, stop, out)?;
        let mut tell = |event: Progress<'_>| {
            shown.hear(event);
            if stop.ends_search() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let began = Instant::now();
        let Scanned { mut report, rung, effort } = scan_with(prepared, options, &answers, &mut tell)?;
        let searched = began.elapsed();
        shown.finish();
        output::phase("writing the results");
        let interrupted = stop.is_asked();
        if let Some(before) =
            before.filter(|before| report.verdict == Verdict::Interrupted || (interrupted && before.has_more(&report)))
        {
            before.put_back(out)?;
            output::note(&format!(
                " Stopped before it came as far as the scan that it goes on with: the results in {} are still those",
                out.display()
            ));
            return Ok(Ended { report, code: exit::INTERRUPTED });
        }
        let several = prepared.cell.beginnings.len() > 1;
        let beginning = several.then_some(prepared.cell.beginning + 1);
        let reproduce = &arguments.reproduce(path, out, beginning, Some(&options));
        let context =
            results::Context { prepared, rung, path: cell_path, reproduce, baseline, assessments, whole: None };
        let mut json = results::write(&report, &context, out)?;
        results::write_run(prepared, rung, (effort, answers.remembered().0), reproduce, out)?;
        let written = began.elapsed() - searched;
        // What was found is kept by now, whatever becomes of the search for changes.
        if self.advise(prepared, rung, &mut report) {
            json = results::write(&report, &context, out)?;
        }
        let (advised, calls) = (began.elapsed() - searched - written, effort.steps);
        output::detail(&format!(
            "   Took    {:.1} s to search and confirm ({calls} FMU steps), {:.1} s to write the results, {:.1} s to look for \
             changes",
            searched.as_secs_f64(),
            written.as_secs_f64(),
            advised.as_secs_f64()
        ));
        match arguments.format {
            Format::Json if self.several => {}
            Format::Json => output::json(&json),
            Format::Table => output::result(&(String::from("\n") + &terminal::render(&report, output::view()))),
        }
        let code = self.conclude((prepared, &report, interrupted), baseline, out)?;
        Ok(Ended { report, code })
    }

    /// Looks for changes that would be enough, and says whether there is something new to write: whoever interrupts that has
    /// all but it.
    fn advise(&self, prepared: &Prepared, rung: StateRestore, report: &mut ScanReport) -> bool {
        let stop = self.stop;
        let how = self
            .arguments
            .advice(&prepared.cell, self.several)
            .filter(|_| !report.causes.is_empty() && !stop.ends_search());
        let Some(how) = how else { return false };
        output::note("   Looking for changes that would be enough. Ctrl-C ends that and keeps the results");
        let telling = ProgressPrinter::new(false);
        stop.searching();
        let advised = advise(prepared, rung, report, how, &|told| telling.hear(&told));
        stop.finishing();
        // The FMU may fail where nobody looked before: what was found stays.
        if let Err(error) = advised
            && !error.stopped
        {
            output::warning(&format!("changes were not looked for to the end: the FMU failed: {}", error.message));
        }
        !stop.is_asked() && report.causes.iter().any(|cause| cause.advice.is_some())
    }
}

/// What an interrupted scan left, for one that goes on with it and is interrupted before it comes as far.
struct InterruptedScan {
    hazards: Vec<String>,
    log: String,
}

impl InterruptedScan {
    /// In this folder, if there is a result.
    fn of(out: &Path) -> Option<Self> {
        let recorded = earlier::read(out).ok()?;
        let log = std::fs::read_to_string(out.join(LOG)).ok()?;
        Some(Self { hazards: recorded.hazards.into_iter().map(|hazard| hazard.id).collect(), log })
    }

    /// Whether it holds a hazard that is not found again yet.
    fn has_more(&self, report: &ScanReport) -> bool {
        self.hazards.iter().any(|id| report.hazards.iter().all(|hazard| hazard.id != *id))
    }

    /// All but its log is still there.
    fn put_back(&self, out: &Path) -> Result<(), Failure> {
        output::write_file(&out.join(LOG), &self.log)
    }
}
