//! The example cells whose flaw the transient force does not see: each is found by its own criterion and by no other, on the parts
//! of the body and against the thing that its README names, as hard as that computes by hand; and the repaired twin has none.

use std::collections::BTreeMap;
use std::path::Path;

use serde_json::Value;

use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;

/// What the README of a flawed cell says.
struct Flaw {
    cell: &'static str,
    criterion: &'static str,
    /// Actions in which all of it is there.
    actions: u32,
    /// Each part of the body, and the worst for it over its limit, by hand.
    worst: &'static [(&'static str, f64)],
    links: &'static [&'static str],
    /// What holds the part of the body.
    against: Option<&'static str>,
    /// In the sentence of its cause.
    words: &'static str,
}

const FLAWS: [Flaw; 3] = [
    Flaw {
        cell: "hand-at-table",
        criterion: "clamping",
        actions: 6,
        // 0.25 m/s x sqrt(16.05 kg k) with 75 and 40 kN/m, over 135 and 160 N.
        worst: &[("hand", 2.03), ("lower_arm", 1.25)],
        links: &["gripper"],
        against: Some("table"),
        words: "clamps the hand that reaches over table against table",
    },
    Flaw {
        cell: "wall-behind",
        criterion: "clamping",
        actions: 5,
        // 0.30 m/s x sqrt(17.05 kg k) with 25, 10, 35 and 25 kN/m, over 140, 110, 210 and 180 N.
        worst: &[("chest", 1.40), ("abdomen", 1.13), ("back_shoulders", 1.10), ("pelvis", 1.09)],
        links: &["part"],
        against: Some("wall"),
        words: "clamps the chest against wall",
    },
    Flaw {
        cell: "sharp-workpiece",
        criterion: "pressure",
        actions: 3,
        // 0.40 m/s x sqrt(mu k) over pi (2 mm)^2: 665, 858 and 890 N/cm2, over 380, 360 and 360 N/cm2.
        worst: &[("hand", 1.75), ("lower_arm", 2.38), ("upper_arm", 2.47)],
        links: &["sheet"],
        against: None,
        words: "presses the upper arm that reaches over bench with too small a surface",
    },
];

/// The result of looking at every sequence.
fn scan(dir: &Path, cell: &str, code: i32) -> Value {
    let arguments = ["scan", "--no-advice", cell, "--strategy", "exhaustive", "--out", "out"];
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr).into_owned();
    assert_eq!(output.status.code(), Some(code), "{cell}: {said}");
    let result = scan_json(&dir.join("out"));
    assert_eq!(result["certificate"]["complete"], true, "{cell}: {said}");
    result
}

/// A variant of a cell file of fewer actions.
fn shorter(dir: &Path, file: &str, actions: u32) -> String {
    let (folder, name) = file.split_once('/').unwrap();
    write(
        dir,
        &format!("{folder}/shorter.toml"),
        &format!("extends = \"{name}\"\nname = \"shorter\"\n[search]\nactions = {actions}\n"),
    );
    format!("{folder}/shorter.toml")
}

#[test]
fn each_flaw_is_found_by_its_own_criterion_as_hard_as_by_hand() {
    if !sample::is_turn(8, 12) {
        return;
    }
    let dir = examples();
    for flaw in sample::some(&FLAWS, 2) {
        let result = scan(dir.path(), &shorter(dir.path(), &format!("{}/cell.toml", flaw.cell), flaw.actions), 1);
        let mut worst: BTreeMap<&str, f64> = BTreeMap::new();
        for hazard in result["hazards"].as_array().unwrap() {
            let text = |key: &str| hazard[key].as_str().unwrap();
            assert_eq!((text("class"), &hazard["confirmed"]), (flaw.criterion, &true.into()), "{hazard}");
            assert_eq!(hazard["judged"]["breaks"], serde_json::json!([flaw.criterion]), "{hazard}");
            assert_eq!(hazard["judged"]["clamping"]["against"].as_str(), flaw.against, "{hazard}");
            assert!(flaw.links.contains(&text("robot_link")), "{hazard}");
            let ratio = hazard["ratio"].as_f64().unwrap();
            let most = worst.entry(text("body_region")).or_default();
            *most = most.max(ratio);
        }
        let by_hand: BTreeMap<&str, f64> = flaw.worst.iter().copied().collect();
        assert!(worst.keys().eq(by_hand.keys()), "{}: {worst:?}", flaw.cell);
        for (region, ratio) in worst {
            assert!((ratio - by_hand[region]).abs() < 0.005, "{}: {region} {ratio}", flaw.cell);
        }
        let causes = result["causes"].as_array().unwrap();
        let told = |cause: &Value| cause["sentence"].as_str().unwrap().contains(flaw.words);
        assert!(causes.iter().any(told), "{}: {causes:?}", flaw.cell);
    }
}

/// Of as many actions as are enough in the flawed cells.
#[test]
fn the_repaired_twins_have_none_in_as_many_actions() {
    if !sample::is_turn(4, 6) {
        return;
    }
    let dir = examples();
    for flaw in &FLAWS {
        let result = scan(dir.path(), &shorter(dir.path(), &format!("{}/fixed.toml", flaw.cell), flaw.actions), 0);
        let sequences = 36_u64.pow(flaw.actions).to_string();
        assert_eq!(
            (&result["verdict"], &result["certificate"]["sequences"]),
            (&"none_found".into(), &sequences.into()),
            "{}",
            flaw.cell
        );
    }
}

/// All 36^8 sequences of each.
#[test]
#[ignore = "a minute: eight actions; `the_repaired_twins_have_none_in_as_many_actions` has three to six"]
fn the_repaired_twins_have_none() {
    let dir = examples();
    for flaw in &FLAWS {
        let result = scan(dir.path(), &format!("{}/fixed.toml", flaw.cell), 0);
        assert_eq!(
            (&result["verdict"], &result["certificate"]["sequences"]),
            (&"none_found".into(), &"2821109907456".into())
        );
    }
}

/// The same sequences, looked at as in the paper: nobody would know.
#[test]
fn the_transient_force_sees_none_of_them() {
    if !sample::is_turn(4, 6) {
        return;
    }
    let dir = examples();
    let cells = FLAWS.iter().map(|flaw| (flaw.cell, flaw.criterion, flaw.actions));
    for (cell, criterion, actions) in cells.chain([("short-zone", "separation", 8)]) {
        let file = format!("{cell}/cell.toml");
        let text = std::fs::read_to_string(dir.path().join(&file)).unwrap();
        let (before, criteria) = text.split_once("[criteria]\n").unwrap();
        let (line, after) = criteria.split_once('\n').unwrap();
        assert!(line.starts_with(criterion) && after.starts_with('\n'), "{line}");
        write(dir.path(), &file, &format!("{before}{after}"));
        let result = scan(dir.path(), &shorter(dir.path(), &file, actions), 0);
        assert_eq!(result["verdict"], "none_found", "{cell}");
    }
}
