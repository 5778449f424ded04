//! The result as JUnit XML: one test case a hazard, so that a pipeline shows which are there, which are known, and which
//! of the known ones are gone.

use quick_junit::{NonSuccessKind, Report, TestCase, TestCaseStatus, TestSuite};

use super::baseline::{Baseline, Standing};
use super::model::{Hazard, ScanReport, Verdict};

/// The report. Hazards are failures, unless `baseline` knows them: then they are skipped; what it knows and is not there
/// any more is a success.
///
/// # Errors
/// When it cannot be written as XML.
pub fn render(report: &ScanReport, baseline: Option<&Baseline>) -> Result<String, quick_junit::SerializeError> {
    let cell = xml(&report.subject.cell);
    let mut suite = TestSuite::new(cell.as_str());
    for hazard in &report.hazards {
        let standing = baseline.map_or(Standing::New, |known| known.standing(hazard));
        let status = match standing {
            Standing::Known => {
                let mut skipped = TestCaseStatus::skipped();
                skipped.set_message("known: it stands in the baseline");
                skipped
            }
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
        suite.add_test_case(case(&title(hazard), &cell, status));
    }
    let gone = baseline.into_iter().flat_map(|known| known.gone(report));
    for hazard in gone {
        suite.add_test_case(case(&title(hazard), &cell, TestCaseStatus::success()));
    }
    for fault in &report.faults {
        let mut error = TestCaseStatus::non_success(NonSuccessKind::Error);
        error.set_type("FMU fault");
        error.set_message(xml(&fault.message));
        let actions: Vec<String> = fault.actions.iter().map(ToString::to_string).collect();
        suite.add_test_case(case(&xml(&format!("FMU after {}", actions.join(", "))), &cell, error));
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
    suite.add_test_case(case("the scan has a result", &cell, scan));
    let mut whole = Report::new("fmi-hazard");
    whole.add_test_suite(suite);
    whole.to_string()
}

fn case(name: &str, cell: &str, status: TestCaseStatus) -> TestCase {
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
