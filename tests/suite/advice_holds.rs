//! Advice put to the proof: every change of ten cells after which nothing is said to be left is made, and the changed cell is searched from
//! its starts and from anywhere; one step less leads to a hazard, where a change has a size. Prints a table.

use std::io::Write as _;
use std::ops::ControlFlow;
use std::path::Path;

use crate::common::guarded::{bar, every_sequence, guarded};
use fmi_hazard::host::PlantError;
use fmi_hazard::record::advice::{NextSmaller, RiskReduction, RiskReductionOutcome, TestedAgainst};
use fmi_hazard::record::model::Verdict;
use fmi_hazard::scan::advise::advise;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::reachability::{AnalysisLimits as AnywhereEffort, Until, analyse, refusal};
use fmi_hazard::scan::risk_reduction::{ReachabilityBudget, RiskReductionBudget};
use fmi_hazard::scan::{Prepared, StateChoice};
use fmi_hazard::sim::answers::Answers;
use tempfile::TempDir;

/// How long everybody from anywhere is looked for: the first cycle of the bar, and some more.
const UNTIL: Until = Until::Seconds(2.0);

/// What explain has by default, with a little more for complete searches.
fn effort() -> RiskReductionBudget {
    let everywhere =
        ReachabilityBudget { until: UNTIL, presses: 1, states: 100_000, searches: ReachabilityBudget::OF_ONE };
    RiskReductionBudget {
        states: 200_000,
        work: 60_000_000,
        everywhere: Some(everywhere),
        ..RiskReductionBudget::usual()
    }
}

/// One line of the table.
struct Line {
    cell: String,
    change: String,
    from_start: &'static str,
    from_anywhere: String,
    one_less: &'static str,
}

impl Line {
    /// Whether the claim is refuted: a hazard from the starts, or one from anywhere where that was claimed, or none with one step less.
    fn is_refuted(&self, claims_anywhere: bool) -> bool {
        self.from_start == "hazard"
            || (claims_anywhere && self.from_anywhere.starts_with("hazard"))
            || self.one_less == "none"
    }
}

fn of_starts(prepared: &Prepared, text: &str) -> &'static str {
    let Ok(changed) = prepared.changed(text) else { return "not run" };
    for beginning in 0..changed.cell.beginnings.len() {
        let there = changed.beginning(beginning).unwrap();
        if !every_sequence(&there, true).hazards.is_empty() {
            return "hazard";
        }
    }
    "none"
}

fn of_anywhere(prepared: &Prepared, text: &str) -> String {
    let Ok(changed) = prepared.changed(text) else { return "not run".to_owned() };
    if let Some(why) = refusal(&changed) {
        return format!("refused: {why}");
    }
    let answers = Answers::default();
    let effort = AnywhereEffort {
        until: UNTIL,
        workers: 2,
        most_states: 100_000,
        presses: 1,
        state: StateChoice::Auto,
        answers: &answers,
    };
    match analyse(&changed, effort, &mut |_| ControlFlow::Continue(())) {
        Err(error) => format!("failed: {}", error.cause.message),
        Ok(looked) => match looked.found.verdict {
            Verdict::HazardsFound => {
                let worst = looked.found.hazards.iter().map(|place| place.ratio).fold(0.0, f64::max);
                format!("hazard {worst:.2}x")
            }
            Verdict::NoneFound(_) => "nobody".to_owned(),
            _ => format!("open: {}", looked.found.reasons.join("; ")),
        },
    }
}

fn of_one_less(prepared: &Prepared, checked: &TestedAgainst) -> &'static str {
    match &checked.one_less {
        NextSmaller::AsItIs => "as it is",
        NextSmaller::NotTried { .. } | NextSmaller::Close { met: None, .. } => "not run",
        // It begins later or elsewhere than the cell says: the run that showed it is looked at in other tests.
        NextSmaller::Met(met) | NextSmaller::Close { met: Some(met), .. }
            if met.from.is_some() || met.actions.len() > prepared.cell.search.actions as usize =>
        {
            "elsewhere"
        }
        NextSmaller::Met(met) | NextSmaller::Close { met: Some(met), .. } => of_starts(prepared, &met.cell),
    }
}

/// Every change of a cell after which nothing is said to be left, proved; with whether it is called enough.
fn proved(name: &str, path: &Path) -> Result<Vec<(Line, bool)>, PlantError> {
    let prepared = prepare(path, None).unwrap();
    let mut report = every_sequence(&prepared, false);
    let found = advise(&prepared, prepared.rung, &mut report, effort(), &|_| {})?;
    let enough = |remedy: RiskReduction| match remedy.outcome {
        RiskReductionOutcome::Sufficient(checked) => Some((remedy.change, remedy.cell, checked)),
        _ => None,
    };
    let line = |(change, cell, checked): (String, String, TestedAgainst)| {
        let line = Line {
            cell: name.to_owned(),
            change,
            from_start: of_starts(&prepared, &cell),
            from_anywhere: of_anywhere(&prepared, &cell),
            one_less: of_one_less(&prepared, &checked),
        };
        (line, checked.is_enough())
    };
    Ok(found.into_iter().flat_map(|(_, remedies)| remedies).filter_map(enough).map(line).collect())
}

/// Cells of our own: a bar at knee height behind safeguards that are too small, too late, in part, or not there.
fn own() -> Vec<(&'static str, String)> {
    let mat = |edge: f64, back: f64| {
        format!(
            "[[sensor]]\nname = \"mat\"\nkind = \"mat\"\nzone = {{ polygon_m = [[-3, {edge}], [3, {edge}], [3, {back}], [-3, {back}]] }}\n\
             variable = \"clear\"\nactive = false\n"
        )
    };
    let wall = |name: &str, x: f64, top: f64| {
        format!("[[obstacle]]\nname = \"{name}\"\ncentre_m = [{x}, -1.3, {}]\nsize_m = [3, 0.04, {top}]\n", 0.5 * top)
    };
    let cell = |parts: &str, parameters: &str, floor: &str| {
        let bar = bar("bar", 0.0, 0.45);
        format!(
            "schema = 1\nname = \"own\"\nfmu = \"guarded.fmu\"\n{parts}{bar}[pose]\nx = \"person.x\"\ny = \"person.y\"\n\
             [parameters]\n{parameters}\n[human]\n{floor}start = {{ xy_m = [0, -1.8], heading_deg = 90 }}\n[search]\nactions = 4\n"
        )
    };
    let front = "floor_m = [[-2.9, -4], [2.9, -4], [2.9, -1.35], [-2.9, -1.35]]\n";
    let between = "floor_m = [[-2.9, -4], [2.9, -4], [2.9, 2], [-2.9, 2]]\n";
    vec![
        ("narrow mat", cell(&mat(-0.95, 3.0), "\"plc.t_ramp\" = 0.5", "")),
        ("slow controller", cell(&mat(-1.5, 3.0), "\"plc.t_react\" = 0.7", "")),
        ("slow filter", cell(&mat(-1.5, 3.0), "\"filter.tau\" = 0.6", "")),
        ("muted mat", cell(&mat(-1.5, 3.0), "\"muting.enabled\" = true\n\"muting.hold_time\" = 1.5", "")),
        ("short distance", cell("", "\"ssm.distance\" = 1.0", "")),
        ("no safeguard", cell("", "", "")),
        ("low barrier in front", cell(&[wall("left", -1.5, 0.04), wall("right", 1.5, 0.04)].concat(), "", front)),
        ("low barrier, all floor", cell(&[wall("left", -1.5, 0.04), wall("right", 1.5, 0.04)].concat(), "", "")),
        ("strip of mat", cell(&mat(-1.7, -1.2), "", between)),
        ("gap in a wall", cell(&[wall("left", -1.75, 2.2), wall("right", 1.75, 2.2)].concat(), "", between)),
    ]
}

fn table(lines: &[(Line, bool)]) {
    let mut out = std::io::stdout();
    for (line, enough) in lines {
        let called = if *enough { "enough" } else { "in part" };
        let Line { cell, change, from_start, from_anywhere, one_less } = line;
        let _ = writeln!(out, "{cell} | {change} | {called} | {from_start} | {from_anywhere} | {one_less}");
    }
}

#[test]
#[ignore = "many minutes: ten cells, all changes, each searched from anywhere; `advice` looks at some of them from the start"]
fn what_is_said_to_leave_nothing_in_ten_cells_leaves_nothing() {
    let mut lines = Vec::new();
    let _ = writeln!(std::io::stdout(), "cell | change | called | from the starts | from anywhere | one step less");
    for (name, text) in own() {
        let dir: TempDir = guarded();
        let path = dir.path().join("cell.toml");
        std::fs::write(&path, text).unwrap();
        let of_cell = proved(name, &path).unwrap();
        table(&of_cell);
        lines.extend(of_cell);
    }
    assert!(!lines.is_empty());
    assert!(lines.iter().all(|(line, anywhere)| !line.is_refuted(*anywhere)));
}
