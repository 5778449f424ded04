//! What would be enough against the causes of a scan: the smallest changes for the worst hazard of each, written into its
//! report.

use super::prepare::Prepared;
use super::risk_reduction::{ExhaustiveBudget, RiskReductionBudget, RiskReductionEvent, risk_reductions};
use crate::host::PlantError;
use crate::host::selftest::StateRestore;
use crate::record::advice::RiskReduction;
use crate::record::cause::{CauseAdvice, Change};
use crate::record::model::ScanReport;

/// Causes for which changes are looked for, worst first. What removes one often removes the others.
const CAUSES: usize = 3;

/// Looks for changes against the causes of `report` and writes what it finds into it; returns everything that came of them,
/// with the number of the cause it is about. A cause that falls with a change for a worse one gets that change. All complete
/// searches together take what `effort` allows; states are brought back as plainly as `rung` asks.
///
/// # Errors
/// When the FMU fails in the cell as it is; what was found by then is in the report.
pub fn advise(
    prepared: &Prepared,
    rung: StateRestore,
    report: &mut ScanReport,
    effort: RiskReductionBudget,
    tell: &(dyn Fn(RiskReductionEvent<'_>) + Sync),
) -> Result<Vec<(usize, Vec<RiskReduction>)>, PlantError> {
    let Ok(mut plainly) = prepared.beginning(prepared.cell.beginning) else { return Ok(Vec::new()) };
    plainly.rung = plainly.rung.max(rung);
    let mut purse = ExhaustiveBudget::new(&effort);
    let mut found = Vec::new();
    let mut for_all: Vec<Change> = Vec::new();
    for (number, cause) in report.causes.iter_mut().enumerate() {
        if !for_all.is_empty() {
            cause.advice = Some(CauseAdvice::as_for_a_worse_one(for_all.clone()));
            continue;
        }
        let worst = report.hazards.iter().find(|hazard| hazard.id == cause.worst && hazard.confirmed == Some(true));
        let Some(worst) = worst.filter(|_| number < CAUSES && !plainly.stop().ends_search()) else { continue };
        let remedies = risk_reductions(&plainly, worst, &report.hazards, effort, &mut purse, tell)?;
        let stopped = plainly.stop().ends_search();
        if stopped && remedies.is_empty() {
            break;
        }
        let advice = CauseAdvice::of(&remedies, stopped);
        for_all.extend(advice.changes.iter().filter(|change| change.removes_all).cloned());
        cause.advice = Some(advice);
        found.push((number, remedies));
    }
    Ok(found)
}
