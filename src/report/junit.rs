//! The result as JUnit XML: one test case a hazard, so that a pipeline shows which are there, which are known, and which
//! of the known ones are gone.

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use super::baseline::{Baseline, Standing};
use super::model::{Hazard, ScanReport, Verdict};

/// The report. Hazards are failures, unless `baseline` knows them: then they are skipped. What it knows and is not there
/// any more is a success if the scan accounted for every sequence; else it may still be there, and is skipped too.
///
/// # Errors
/// When it cannot be written as XML.
pub fn render(report: &ScanReport, baseline: Option<&Baseline>) -> Result<String, quick_junit::SerializeError> {
    let cell = xml(&report.subject.title());
    let mut cases = Vec::new();
    for hazard in &report.hazards {
        let standing = baseline.map_or(Standing::New, |known| known.standing(hazard));
        let status = match standing {
            Standing::Known => skipped("known: it stands in the baseline"),
            Standing::New | Standing::Worse { .. } => {
                let mut failure = TestCaseStatus::non_success(NonSuccessKind::Failure);
                failure.set_type(if standing == Standing::New { "hazard" } else { "hazard that became worse" });
                failure.set_message(xml(&hazard.sentence()));
                let actions: Vec<String> = hazard.actions.iter().map(ToString::to_string).collect();
                failure.set_description(xml(&format!(
                    "actions of {} s: {}\nreplay: fmi-hazard replay scan.json {}",
                    report.settings.action_s,
                    actions.join(", "),
                    hazard.id
                )));
                failure
            }
        };
        cases.push(case(&title(hazard), &cell, status));
    }
    let complete = report.certificate.as_ref().is_some_and(|certificate| certificate.complete);
    for hazard in baseline.into_iter().flat_map(|known| known.gone(report)) {
        let status = if complete {
            TestCaseStatus::success()
        } else {
            skipped("not found again, but the scan did not account for every sequence")
        };
        cases.push(case(&title(hazard), &cell, status));
    }
    for fault in &report.faults {
        let mut error = TestCaseStatus::non_success(NonSuccessKind::Error);
        error.set_type("FMU fault");
        error.set_message(xml(&fault.message));
        let actions: Vec<String> = fault.actions.iter().map(ToString::to_string).collect();
        cases.push(case(&xml(&format!("FMU after {}", actions.join(", "))), &cell, error));
    }
    let scan = match report.verdict {
        Verdict::HazardsFound | Verdict::NoneFound => TestCaseStatus::success(),
        Verdict::Inconclusive | Verdict::FmuFailed | Verdict::Interrupted => {
            let mut error = TestCaseStatus::non_success(NonSuccessKind::Error);
            error.set_type("no result");
            error.set_message(xml(&report.warnings.join("; ")));
            error
        }
    };
    cases.push(case("the scan has a result", &cell, scan));
    write(&cell, cases)
}

/// The XML of one suite.
pub(super) fn write(cell: &str, cases: Vec<TestCase>) -> Result<String, quick_junit::SerializeError> {
    let mut suite = TestSuite::new(cell);
    suite.add_test_cases(cases);
    let mut whole = Report::new("fmi-hazard");
    whole.add_test_suite(suite);
    whole.to_string()
}

fn skipped(why: &str) -> TestCaseStatus {
    let mut status = TestCaseStatus::skipped();
    status.set_message(why);
    status
}

/// A test case of a cell.
pub(super) fn case(name: &str, cell: &str, status: TestCaseStatus) -> TestCase {
    let mut case = TestCase::new(name, status);
    case.set_classname(cell);
    case
}

/// Name of a hazard's test case.
pub(super) fn title(hazard: &Hazard) -> String {
    xml(&format!("{} {} <- {}", hazard.id, hazard.body_region, hazard.robot_link))
}

/// Without the characters that XML cannot hold, even escaped.
pub(super) fn xml(text: &str) -> String {
    text.chars()
        .map(|c| if c < ' ' && !"\t\n\r".contains(c) || matches!(c, '\u{fffe}' | '\u{ffff}') { '\u{fffd}' } else { c })
        .collect()
}
