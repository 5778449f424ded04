//! One run of `fmi-hazard scan`: what it was given, the hazards that are known before, and how it ends.

use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::exit::{self, Failure};
use super::scan_arguments::Arguments;
use super::{earlier, initial_conditions, output};
use crate::cell::file::validate::BASELINE;
use crate::record::model::{NumberedInitialCondition, ScanReport, Verdict};
use crate::report::assessment::Assessments;
use crate::report::baseline::Baseline;
use crate::scan::{Prepared, moved};
use crate::stop::Stop;

/// One run of the command.
pub(super) struct Run<'a> {
    pub(super) arguments: &'a Arguments,
    pub(super) path: &'a Path,
    pub(super) cell_path: &'a Path,
    pub(super) assessments: &'a Assessments,
    pub(super) stop: &'a Stop,
    /// When its time began.
    pub(super) began: Instant,
    /// Whether it goes on with an interrupted one.
    pub(super) goes_on: bool,
    /// Whether the cell is searched from several beginnings.
    pub(super) several: bool,
}

impl Run<'_> {
    /// What is left of the time that is given.
    pub(super) fn time_left(&self) -> Option<Duration> {
        Some(self.arguments.time()?.saturating_sub(self.began.elapsed()))
    }

    /// Tells where everything is and what is new, keeps the baseline if that is wanted, and gives the exit code.
    pub(super) fn conclude(
        &self,
        (prepared, report, interrupted): (&Prepared, &ScanReport, bool),
        baseline: Option<&Baseline>,
        out: &Path,
    ) -> Result<u8, Failure> {
        conclude(report, out);
        if let Some(baseline) = baseline {
            against(report, baseline);
        }
        if self.arguments.write_baseline {
            let path = self.baseline_path(prepared, report.subject.beginning.as_ref());
            let path = path.unwrap_or_else(|| self.cell_path.with_file_name(BASELINE));
            if !interrupted && matches!(report.verdict, Verdict::HazardsFound | Verdict::NoneFound(_)) {
                let beside = path.parent().unwrap_or(Path::new(""));
                output::write_file(&path, &output::pretty(&moved::relative(report, beside))?)?;
                output::note(&format!(" Baseline kept in {}: {} hazards", path.display(), report.hazards.len()));
            } else {
                output::warning(&format!(
                    "{} is not written: the scan has no result to hold others against",
                    path.display()
                ));
            }
        }
        Ok(code(report, baseline, interrupted))
    }

    /// The hazards that are known from this beginning. Of one that a folder of earlier results has not, none is.
    pub(super) fn baseline(
        &self,
        prepared: &Prepared,
        beginning: Option<&NumberedInitialCondition>,
    ) -> Result<Option<Baseline>, Failure> {
        if self.arguments.write_baseline {
            return Ok(None);
        }
        let named = self.arguments.baseline.is_some() || prepared.cell.baseline.is_some();
        match self.baseline_path(prepared, beginning) {
            Some(path) => known(&path, self.arguments).map(Some),
            None => Ok(named.then(Baseline::default)),
        }
    }

    /// The baseline: what the command line says, else what the cell says.
    fn baseline_path(&self, prepared: &Prepared, beginning: Option<&NumberedInitialCondition>) -> Option<PathBuf> {
        let own = || prepared.cell.baseline.as_ref().map(|name| self.cell_path.with_file_name(name));
        let path = self.arguments.baseline.clone().or_else(own)?;
        // The folder with a scan's results, as everywhere.
        Some(if initial_conditions::are_in(&path) {
            match initial_conditions::same_in(&path, beginning) {
                Ok(found) => found?.join("scan.json"),
                // Reading it tells what is wrong with it.
                Err(table) => table,
            }
        } else if path.is_dir() {
            path.join("scan.json")
        } else {
            path
        })
    }
}

/// The hazards that a baseline holds.
fn known(path: &Path, arguments: &Arguments) -> Result<Baseline, Failure> {
    if arguments.baseline.is_none() && !path.exists() {
        return Err(Failure::unusable_with_help(
            format!("the cell's fail_on.baseline {} does not exist", path.display()),
            "write it with `fmi-hazard scan ... --write-baseline`, look at each of its hazards, and keep it beside the \
             cell file",
        ));
    }
    Ok(Baseline::of(earlier::read(path)?))
}

fn code(report: &ScanReport, baseline: Option<&Baseline>, interrupted: bool) -> u8 {
    match report.verdict {
        _ if interrupted => exit::INTERRUPTED,
        // Of what is not shown, others than the known ones may be left.
        Verdict::HazardsFound if baseline.is_some_and(|known| known.failing(report).next().is_none()) => {
            if report.obligations.clean().is_some() { exit::NO_HAZARD } else { exit::INCONCLUSIVE }
        }
        Verdict::HazardsFound => exit::HAZARDS,
        Verdict::NoneFound(_) => exit::NO_HAZARD,
        Verdict::Inconclusive => exit::INCONCLUSIVE,
        Verdict::FmuFailed => exit::FMU_FAILED,
        Verdict::Interrupted => exit::INTERRUPTED,
    }
}

fn conclude(report: &ScanReport, out: &Path) {
    let picture = report.hazards.first().map_or_else(String::new, |h| format!(", {}.svg (seen from above)", h.id));
    output::note(&format!(" Report  {}", out.join("report.html").display()));
    output::detail(&format!(
        "         and beside it scan.json, causes.csv, hazards.csv, junit.xml, hazards.sarif{picture}"
    ));
    if let Some(cause) = report.causes.first() {
        output::note(&format!(" Next    fmi-hazard explain {} {}", out.display(), cause.id));
    }
}

/// What is new against the hazards that are known.
fn against(report: &ScanReport, baseline: &Baseline) {
    let failing: Vec<&str> = baseline.failing(report).map(|hazard| hazard.id.as_str()).collect();
    let known = report.hazards.len() - failing.len();
    let gone = baseline.gone(report).count();
    let which = if failing.is_empty() { String::new() } else { format!(": {}", failing.join(", ")) };
    output::note(&format!(
        " Against the baseline: {} new or worse{which}; {known} known, {gone} not found again",
        failing.len()
    ));
}

/// A folder name from a cell's name.
pub(super) fn file_name(name: &str) -> String {
    let safe = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '-' };
    let name: String = name.chars().map(safe).collect();
    if name.trim_matches('.').is_empty() { "cell".to_owned() } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::record::fixtures;
    use crate::scan::Hosting;
    use crate::scan::prepare::prepare_in;

    /// There may be more than it found by then.
    #[test]
    fn an_interrupted_scan_is_not_kept_as_the_baseline() {
        let folder = tempfile::tempdir().unwrap();
        crate::examples::export(folder.path()).unwrap();
        let path = folder.path().join("safety-fence/cell.toml");
        let prepared = prepare_in(&path, None, &Hosting::InProcess(Stop::default())).unwrap();
        let mut arguments = Arguments::of_example(path.clone(), folder.path().to_owned(), 1);
        arguments.write_baseline = true;
        let (assessments, stop) = (Assessments::new(), Stop::default());
        let run = Run {
            arguments: &arguments,
            path: &path,
            cell_path: &path,
            assessments: &assessments,
            began: Instant::now(),
            stop: &stop,
            goes_on: false,
            several: false,
        };
        let report = fixtures::report(vec![fixtures::hazard("H-000001", 1.5)], Vec::new());
        let code = |interrupted: bool| run.conclude((&prepared, &report, interrupted), None, folder.path()).ok();
        let kept = path.with_file_name(BASELINE);
        assert_eq!((code(true), kept.exists()), (Some(exit::INTERRUPTED), false));
        assert_eq!((code(false), kept.exists()), (Some(exit::HAZARDS), true));
    }
}
