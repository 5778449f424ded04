//! The result as JUnit XML: one test case a cause, so that a pipeline shows which are there, which are known, and which
//! of the known ones are gone.

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use super::baseline::{Baseline, Standing};
use fmi_hazard_record::cause::grouped;
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::model::{ScanReport, Verdict};
use fmi_hazard_record::recorded::is_complete;

/// The report. A cause fails if one of its hazards is new or worse, and is skipped if `baseline` knows them all. What that
/// knows and is not there any more is a success if the scan is complete and would have told it; else it may still be there, and is
/// skipped too.
///
/// # Errors
/// When it cannot be written as XML.
pub fn render(report: &ScanReport, baseline: Option<&Baseline>) -> Result<String, quick_junit::SerializeError> {
    let cell = xml(&report.subject.title());
    let mut cases = Vec::new();
    for cause in grouped(&report.causes, &report.hazards) {
        let standing = |hazard: &Hazard| baseline.map_or(Standing::New, |known| known.standing(hazard));
        let of: Vec<Standing> = cause.hazards.iter().map(|hazard| standing(hazard)).collect();
        let failing = of.iter().filter(|standing| **standing != Standing::Known).count();
        let status = if failing == 0 {
            skipped("known: it stands in the baseline")
        } else {
            let mut failure = TestCaseStatus::non_success(NonSuccessKind::Failure);
            let all_worse = of.iter().all(|standing| matches!(standing, Standing::Known | Standing::Worse { .. }));
            failure.set_type(if all_worse { "hazard that became worse" } else { "hazard" });
            failure.set_message(xml(&cause.sentence));
            let mut text = String::new();
            for (hazard, standing) in cause.hazards.iter().zip(&of) {
                let word = match (baseline, standing) {
                    (None, _) => "",
                    (Some(_), Standing::New) => "new: ",
                    (Some(_), Standing::Worse { .. }) => "worse: ",
                    (Some(_), Standing::Known) => "known: ",
                };
                text += &format!("{word}{} {}\n", hazard.id, hazard.sentence());
            }
            text += &format!("replay: fmi-hazard replay scan.json {}", cause.hazards[0].id);
            failure.set_description(xml(&text));
            failure
        };
        cases.push(case(&xml(&cause.title()), &cell, status));
    }
    cases.extend(baseline.into_iter().flat_map(|known| gone(report, known, &cell)));
    for fault in &report.faults {
        let mut error = TestCaseStatus::non_success(NonSuccessKind::Error);
        error.set_type("FMU fault");
        error.set_message(xml(&fault.message));
        let actions: Vec<String> = fault.actions.iter().map(ToString::to_string).collect();
        cases.push(case(&xml(&format!("FMU after {}", actions.join(", "))), &cell, error));
    }
    let scan = match report.verdict {
        Verdict::HazardsFound | Verdict::NoneFound(_) => TestCaseStatus::success(),
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

/// A case for each cause that the baseline knows and the scan did not find.
fn gone(report: &ScanReport, known: &Baseline, cell: &str) -> Vec<TestCase> {
    let certified = report.certificate.as_ref().is_some_and(|certificate| certificate.complete);
    let complete = is_complete(report.verdict, &report.settings.strategy, certified);
    let gone = known.gone_causes(report).into_iter().map(|cause| {
        let status = match cause.hazards.iter().find_map(|hazard| known.narrower(report, hazard)) {
            _ if !complete => skipped("not found again, but the scan is not complete"),
            Some(narrower) => {
                skipped(&xml(&format!("not found again, but the scan {}: {}", narrower.words(), narrower.help())))
            }
            None => TestCaseStatus::success(),
        };
        case(&xml(&cause.title()), cell, status)
    });
    gone.collect()
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

/// Without the characters that XML cannot hold, even escaped.
pub(super) fn xml(text: &str) -> String {
    text.chars()
        .map(|c| if c < ' ' && !"\t\n\r".contains(c) || matches!(c, '\u{fffe}' | '\u{ffff}') { '\u{fffd}' } else { c })
        .collect()
}
