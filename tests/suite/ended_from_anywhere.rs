//! A search from anywhere that ended before it was through, in cells of several kinds, flawed and repaired, by FMUs of both versions: all
//! floor that it did not look at is told, and nothing clean is said of it.

use std::ops::ControlFlow;

use crate::common::anywhere::look_with;
use crate::common::write;
use crate::restarts::{UNTIL_S, WATCHES, cell, folder};
use crate::sample;
use fmi_hazard::record::model::Verdict;
use fmi_hazard::record::reachability::ReachabilityResult;
use fmi_hazard::scan::reachability::AnalysisEvent;
use fmi_hazard::sim::answers::Answers;

#[test]
fn floor_that_was_not_looked_at_is_told_and_never_clean() {
    let fmus = ["gantry.fmu", "gantry-fmi3.fmu"];
    let cases = fmus.into_iter().flat_map(|fmu| WATCHES.map(|watches| (fmu, watches)));
    for (fmu, watches) in sample::some(cases, 6) {
        let dir = folder(fmu);
        for latched_by in ["nobody", "PLC"] {
            let path = write(dir.path(), "cell.toml", &cell(watches, latched_by));
            let ended = |at: f64| {
                let mut tell = |told: AnalysisEvent| match told {
                    AnalysisEvent::Floor(share, _) if share >= at => ControlFlow::Break(()),
                    _ => ControlFlow::Continue(()),
                };
                look_with((&path, UNTIL_S, 2), &Answers::default(), &mut tell).found
            };
            let whole = ended(2.0);
            assert!(whole.not_looked_at == 0 && whole.not_looked_at_m.is_empty(), "{fmu} {watches}");
            for at in [0.0, 0.4] {
                is_told(&ended(at), &whole);
            }
        }
    }
}

/// Where somebody is hit, or it is not known, in the whole, the search that ended says so, or that it did not look there.
fn is_told(ended: &ReachabilityResult, whole: &ReachabilityResult) {
    assert!(!ended.verdict.is_clean() && ended.not_looked_at > 0, "{:?}", ended.verdict);
    assert!(ended.verdict == Verdict::HazardsFound || !ended.reasons.is_empty());
    assert!(ended.reasons.iter().all(|reason| !reason.contains("no robot moved")), "{:?}", ended.reasons);
    for cell in &whole.floor {
        let [x, y] = cell.xy_m;
        let holds = |[left, low, right, high]: &[f64; 4]| *left < x && x < *right && *low < y && y < *high;
        let told = ended.floor.iter().any(|other| other.xy_m == cell.xy_m) || ended.not_looked_at_m.iter().any(holds);
        assert!(told, "{:?} is neither told nor not looked at", cell.xy_m);
    }
}
