//! Advice that is called enough, in cells whose remedies are known: each change is made, and the changed cell is searched with every
//! sequence and from anywhere; less of it leads to a hazard. What helps from the start alone, or for a reason that does not count, is not.

use std::ops::ControlFlow;

use crate::common::anywhere::look_with;
use crate::common::guarded::every_sequence;
use crate::common::{fmi_hazard, scan_json, write};
use crate::restarts::{UNTIL_S, WATCHES, cell, folder};
use crate::sample;
use fmi_hazard::record::advice::{HazardAfterChange, NextSmaller, RiskReduction, RiskReductionOutcome};
use fmi_hazard::scan::Prepared;
use fmi_hazard::scan::advise::advise;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::reachability::Until;
use fmi_hazard::scan::risk_reduction::{ReachabilityBudget, RiskReductionBudget};
use fmi_hazard::sim::answers::Answers;
use serde_json::Value;
use tempfile::TempDir;

/// Parameters of the gantry that are no remedies here.
const FIXED: [&str; 8] = [
    "axis.stroke[1]",
    "axis.stroke[2]",
    "axis.speed[1]",
    "axis.speed[2]",
    "axis.phase0[1]",
    "axis.phase0[2]",
    "curtain.own_y",
    "curtain.own_depth",
];

/// The slide of `restarts` with other parts around it, from so far before it, for so many actions.
fn slide(parts: &str, human: &str, actions: u32) -> String {
    let text = cell("", "PLC");
    let (from, to) = (text.find("[[sensor]]").unwrap(), text.find("[human]").unwrap());
    let start = text.find("start = ").unwrap();
    let end = text[start..].find("[search]").unwrap() + start;
    let fixed: String = FIXED.iter().map(|name| format!("\"{name}\" = {{ fixed = true }}\n")).collect();
    let search = text[end..].replace("actions = 5", &format!("actions = {actions}"));
    format!("{}{parts}{}{human}{search}[explain.parameters]\n{fixed}", &text[..from], &text[to..start])
}

fn wall(name: &str, [x, y]: [f64; 2], [wide, high]: [f64; 2]) -> String {
    format!("[[obstacle]]\nname = \"{name}\"\ncentre_m = [{x}, {y}, {}]\nsize_m = [{wide}, 0.04, {high}]\n", 0.5 * high)
}

/// A cell, and what comes of changes against its worst cause.
struct Advised {
    prepared: Prepared,
    remedies: Vec<RiskReduction>,
    dir: TempDir,
    until_s: f64,
}

fn advised(text: &str, until_s: f64) -> Advised {
    let dir = folder("gantry.fmu");
    let prepared = prepare(&write(dir.path(), "cell.toml", text), None).unwrap();
    let mut report = every_sequence(&prepared, false);
    assert!(!report.hazards.is_empty());
    let everywhere = ReachabilityBudget { until: Until::Seconds(until_s), presses: 0, states: 100_000, searches: 12 };
    let effort = RiskReductionBudget { everywhere: Some(everywhere), workers: 2, ..RiskReductionBudget::usual() };
    let mut found = advise(&prepared, prepared.rung, &mut report, effort, &|_| {}).unwrap();
    Advised { prepared, remedies: found.remove(0).1, dir, until_s }
}

impl Advised {
    fn of(&self, words: &str) -> &RiskReduction {
        let mut of = self.remedies.iter().filter(|remedy| remedy.change.contains(words));
        of.next().unwrap_or_else(|| panic!("{words}: {:#?}", self.remedies))
    }

    fn is_hazardous(&self, text: &str) -> bool {
        let changed = self.prepared.changed(text).unwrap();
        !every_sequence(&changed, true).hazards.is_empty()
    }

    /// The change is called enough, and is; what less of it leads to.
    fn is_enough(&self, words: &str) -> Option<HazardAfterChange> {
        let remedy = self.of(words);
        let RiskReductionOutcome::Sufficient(checked) = &remedy.outcome else { panic!("{remedy:#?}") };
        assert!(checked.is_enough(), "{remedy:#?}");
        assert!(!self.is_hazardous(&remedy.cell), "{}", remedy.change);
        let path = write(self.dir.path(), "changed.toml", &remedy.cell);
        let looked = look_with((&path, self.until_s, 2), &Answers::default(), &mut |_| ControlFlow::Continue(()));
        assert!(looked.found.verdict.is_clean(), "{}: {:?}", remedy.change, looked.found.reasons);
        let less = match &checked.one_less {
            NextSmaller::AsItIs => return None,
            NextSmaller::Met(met) => met,
            NextSmaller::Close { met, .. } => met.as_ref().unwrap(),
            NextSmaller::NotTried { cause } => panic!("{cause}"),
        };
        let begins_there = less.from.is_none() && less.actions.len() <= self.prepared.cell.search.actions as usize;
        assert!(!begins_there || self.is_hazardous(&less.cell), "{}: {less:?}", remedy.change);
        Some(less.clone())
    }
}

/// Two panels over which people step.
fn low_fence() -> String {
    let panels = wall("left", [-0.6, -0.7], [1.2, 0.04]) + &wall("right", [0.6, -0.7], [1.2, 0.04]);
    let human =
        "start = { xy_m = [0, -1.1], heading_deg = 90 }\nfloor_m = [[-0.2, -1.4], [0.2, -1.4], [0.2, 0], [-0.2, 0]]\n";
    slide(&panels, human, 4)
}

/// The panels are raised together, not one by one.
#[test]
fn a_fence_is_raised_as_far_as_it_has_to_be() {
    let advised = advised(&low_fence(), 0.8);
    assert!(advised.is_enough("left and right").is_some());
    assert!(advised.of("left and right").change.ends_with("m higher"));
    for words in ["left 1", "right 1"] {
        assert!(matches!(advised.of(words).outcome, RiskReductionOutcome::NoHelp { .. }), "{:#?}", advised.of(words));
    }
}

/// A stop that ends with the demand: a latch is enough, in the PLC or by the host; other changes of its sensor are not.
#[test]
fn a_stop_that_restarts_by_itself_is_latched() {
    if !sample::is_turn(1, 4) {
        return;
    }
    for watches in sample::some(WATCHES, 3) {
        let text = cell(watches, "nobody")
            .replace("xy_m = [0, -1.1]", "xy_m = [0, -0.9]")
            .replace("actions = 5", "actions = 3");
        let fixed: String = FIXED.iter().map(|name| format!("\"{name}\" = {{ fixed = true }}\n")).collect();
        let advised = advised(
            &format!("{text}[explain]\nrobot = {{ slide = {{ fixed = true }} }}\n[explain.parameters]\n{fixed}"),
            UNTIL_S,
        );
        for words in ["plc.latched = true", "watch held once it has reported"] {
            assert_eq!(advised.is_enough(words), None, "{watches}");
        }
    }
}

/// A mat that has to be so wide that somebody else begins in it, and a robot that would stand behind a barrier.
#[test]
fn what_helps_because_of_where_somebody_begins_is_no_advice() {
    let mat = "[[sensor]]\nname = \"mat\"\nkind = \"mat\"\nvariable = \"plc.curtain_clear\"\nactive = false\nzone = { polygon_m = \
               [[-0.9, -0.45], [0.9, -0.45], [0.9, -0.25], [-0.9, -0.25]] }\n";
    let floor = "floor_m = [[-0.2, -1.7], [0.2, -1.7], [0.2, 1.2], [-0.2, 1.2]]\n";
    let starts =
        "start = { xy_m = [0, -1.3], heading_deg = 90 }\nother_starts = [{ xy_m = [0, 0.45], heading_deg = 270 }]\n";
    let two = advised(&slide(mat, &format!("{starts}{floor}"), 4), 0.6);
    let told = format!("{:?}", two.of("zone of mat").outcome);
    assert!(told.contains("mat then reports the person at another start already"), "{told}");
    let low = |name: &str, x: f64| {
        let across = wall(name, [x, 0.0], [0.04, 0.22]);
        across.replace("0.04, 0.04, 0.22]", "0.04, 3, 0.22]")
    };
    let around = wall("back", [0.0, 0.3], [3.0, 0.22]) + &low("left", -0.5) + &low("right", 0.5);
    let start =
        "start = { xy_m = [0, -0.7], heading_deg = 90 }\nfloor_m = [[-0.2, -1], [0.2, -1], [0.2, 0.4], [-0.2, 0.4]]\n";
    let behind = advised(&slide(&around, start, 4), 0.4);
    let told = format!("{:?}", behind.of("slide").outcome);
    assert!(told.contains("slide then stands beyond"), "{told}");
}

/// `explain` looks as far as it is told to: with little nothing is called enough, to the end it is.
#[test]
fn explain_looks_to_the_end_on_request() {
    let dir = folder("gantry.fmu");
    write(dir.path(), "cell.toml", &low_fence());
    let ran = |arguments: &[&str]| {
        let output = fmi_hazard(dir.path()).args(arguments).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    };
    ran(&["scan", "cell.toml", "--from", "start", "--no-advice", "--strategy", "exhaustive", "--out", "o"]);
    let id = scan_json(&dir.path().join("o"))["causes"][0]["id"].as_str().unwrap().to_owned();
    let enough = |more: &str| {
        let limits: Vec<&str> = more.split_whitespace().collect();
        let explain = ["explain", "o", &id, "--until", "1s", "--from", "anywhere", "--format", "json"];
        let told: Value = serde_json::from_str(&ran(&[&explain[..], &limits].concat())).unwrap();
        let shown = |remedy: &&Value| {
            remedy["outcome"]["sufficient"]["everywhere"]["reasons"].as_array().is_some_and(Vec::is_empty)
        };
        told["remedies"].as_array().unwrap().iter().filter(shown).count()
    };
    assert_eq!((enough("--max-states 2"), enough("--complete")), (0, 1));
}
