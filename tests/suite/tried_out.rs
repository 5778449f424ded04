//! What can only be tried out of an FMU, from anywhere: it is tried at many moments and stays open until the cell file accepts it; what a
//! trial shows to be otherwise is told. By FMUs of both versions, flawed and repaired.

use std::ops::ControlFlow;

use crate::common::anywhere::{cell, look, two_bars};
use crate::common::guarded::guarded;
use crate::common::{test_fmus, write};
use crate::sample;
use fmi_hazard::obligations::{Need, Standing};
use fmi_hazard::record::reachability::ReachabilityResult;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::reachability::{AnalysisLimits, Until, analyse};
use fmi_hazard::sim::answers::Answers;

/// The folder of the bar's FMU, and of that of FMI 3 by the same name: one of them, or both where all cases are looked at.
fn both() -> impl Iterator<Item = tempfile::TempDir> {
    let (second, third) = (guarded(), guarded());
    std::fs::copy(test_fmus().join("guarded-fmi3.fmu"), third.path().join("guarded.fmu")).unwrap();
    sample::some([second, third], 2)
}

/// What is open of one need, in words.
fn open(found: &ReachabilityResult, need: Need) -> Vec<String> {
    let all = found.obligations.open().filter(|one| one.need == need);
    all.map(|one| match &one.standing {
        Standing::Open { why, .. } => why.clone(),
        other => format!("{other:?}"),
    })
    .collect()
}

/// By legs alone on a strip of floor, from so far before the bar.
fn strip(text: &str) -> String {
    let straight = text.replace("[human]\n", "[human]\nbend_forward_deg = 0\nbend_lateral_deg = 0\n");
    straight.replace(
        "start = { xy_m = [0, -3], heading_deg = 90 }\n",
        "start = { xy_m = [0, -2], heading_deg = 90 }\nfloor_m = [[-0.25, -2.2], [0.25, -2.2], [0.25, 0], [-0.25, 0]]\n",
    )
}

/// The bar with a field of its own, and people of whom it is told where they are.
fn with_field(parameters: &str) -> String {
    let field = "[[sensor]]\nname = \"field\"\nkind = \"reported\"\nvariable = \"field.occupied\"\nactive = true\n[pose]\nx = \
                 \"person.x\"\ny = \"person.y\"\n";
    strip(&format!("{}\"field.radius\" = 1.2\n{parameters}", cell(0.45, field)))
        .replace("\"drive.speed\" = 5", "\"drive.speed\" = 0.5")
}

/// A field that is off, smaller, or larger from some time on; and one that stays.
#[test]
fn a_sensor_inside_the_fmu_that_sees_otherwise_later_is_told() {
    for dir in both() {
        let looked = |parameters: &str| look(dir.path(), &with_field(parameters), 0.7, 2);
        for (until_s, later_m, words) in
            [(0.1, 0.0, "field reports, and soon"), (0.4, 0.8, "field does not report"), (0.5, 1.9, "field reports")]
        {
            let found = looked(&format!("\"field.until\" = {until_s}\n\"field.later\" = {later_m}\n"));
            let told = open(&found, Need::ReportsLater);
            assert!(!found.verdict.is_clean() && told.len() == 1 && told[0].starts_with(words), "{until_s}: {told:?}");
            // It cannot be accepted.
            let lines = found.obligations.lines_to_accept().unwrap_or_default();
            assert!(!lines.contains("sensor_sees_alike"), "{lines}");
        }
        let same = looked("\"field.until\" = 0.2\n\"field.later\" = 1.2\n");
        let told = open(&same, Need::ReportsLater);
        assert!(
            told.len() == 1 && told[0].contains("field sees the same people at any time: asked again at 12 moments"),
            "{told:?}"
        );
        let accepted = signed(&same);
        let clean = look(dir.path(), &format!("{}\n{accepted}", with_field("")), 0.7, 2);
        assert!(clean.verdict.is_clean(), "{:?}", clean.reasons);
        assert!(accepted.contains("sensor_sees_alike") && accepted.contains("people_alike"), "{accepted}");
    }
}

/// The lines that accept what can be, with a name and a reason.
fn signed(found: &ReachabilityResult) -> String {
    let lines = found.obligations.lines_to_accept().expect("something can be accepted");
    lines.replace("by = \"\"", "by = \"A. B.\"").replace("because = \"\"", "because = \"drawing 17\"")
}

/// A distance to people that counts from some time on makes people unlike; at the start they are alike.
#[test]
fn people_who_are_told_apart_later_are_not_alike() {
    for dir in both() {
        let unlike = |from_s: f64| {
            let text = with_field(&format!("\"ssm.from\" = {from_s}\n"))
                .replace("\"ssm.distance\" = 0.0", "\"ssm.distance\" = 1.9");
            let told = open(&look(dir.path(), &text, 0.5, 2), Need::PeopleAlike);
            told.iter().any(|why| why.contains("depends on where somebody is in more ways"))
        };
        assert_eq!([0.0, 0.2, 0.4].map(unlike), [true; 3]);
        // After the time that is looked at it does not matter.
        assert!(!unlike(5.0));
    }
}

/// Two bars with a mat each, of which the second one's stop is muted until some time, and looks at its first demand alone: whoever steps on
/// its mat early uses that up, so it seems not to heed it.
#[test]
fn a_mat_that_is_heeded_late_is_heeded() {
    const UNTIL_S: f64 = 0.4;
    let floor = "floor_m = [[-4.6, -0.1], [4.6, -0.1], [4.6, 0.1], [-4.6, 0.1]]\nstart = { xy_m = [0, 0]";
    for dir in both() {
        for hold_s in [0.0, 0.3] {
            let muted =
                format!("\"b:muting.enabled\" = true\n\"b:muting.hold_time\" = {hold_s}\n\"b:latch.once\" = 1\n");
            let text = strip(&two_bars(["a", "b"])).replace("start = { xy_m = [0, -3]", floor);
            let text = format!("{text}{muted}").replace("drive.speed\" = 5", "drive.speed\" = 0.3");
            let told = open(&look(dir.path(), &text, UNTIL_S, 2), Need::Heeds);
            let ignores: Vec<&str> = told.iter().filter_map(|why| why.split(':').next()).collect();
            assert_eq!(ignores, ["a does not heed mat b", "b does not heed mat a"], "{hold_s}");
            assert!(told[0].contains("by itself at 20 moments"), "{told:?}");
        }
    }
}

/// What was tried is the same with saved states and by running the FMU there again each time.
#[test]
fn the_same_is_tried_however_states_are_brought_back() {
    let dir = guarded();
    let floor = "floor_m = [[-4.6, -0.1], [4.6, -0.1], [4.6, 0.1], [-4.6, 0.1]]\nstart = { xy_m = [0, 0]";
    let bars = strip(&two_bars(["a", "b"])).replace("start = { xy_m = [0, -3]", floor);
    for (text, until_s) in [(bars, 0.2), (with_field(""), 0.12)] {
        let path = write(dir.path(), "cell.toml", &text);
        let [saved, replayed] = [StateChoice::Auto, StateChoice::Replay].map(|state| {
            let (prepared, answers) = (prepare(&path, None).unwrap(), Answers::default());
            let until = Until::Seconds(until_s);
            let effort =
                AnalysisLimits { until, workers: 2, most_states: 100_000, presses: 1, state, answers: &answers };
            let found = analyse(&prepared, effort, &mut |_| ControlFlow::Continue(())).unwrap().found;
            (found.obligations.reasons(), found.spent.fmu_steps)
        });
        assert_eq!(saved, replayed);
        assert!(saved.0.len() > 1, "{saved:?}");
    }
}
