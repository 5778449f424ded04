//! A flawed cell and its repaired variant side by side: `compare` and `replay --changed`.

use std::path::Path;

use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;

fn ran(dir: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

fn scan(dir: &Path, cell: &str, strategy: &str, out: &str) {
    let (code, _, said) =
        ran(dir, &["scan", "--no-advice", cell, "--strategy", strategy, "--iterations", "10", "--out", out]);
    assert!(matches!(code, Some(0 | 1 | 4)), "{cell}: {said}");
}

/// Each cell with as many actions as its first hazards take, so that every sequence is looked at within seconds.
const CELLS: [(&str, u32); 6] = [
    ("safety-fence", 7),
    ("sensor-mat", 6),
    ("head-collision", 5),
    ("light-curtain", 3),
    ("two-scanners", 5),
    ("heavy-workpiece", 5),
];

#[test]
fn what_a_repair_fixed_is_told_and_what_undoing_it_brings_back() {
    let dir = examples();
    let dir = dir.path();
    // One of them.
    for (example, actions) in sample::some(CELLS, 6) {
        let [flawed, fixed] = ["cell", "fixed"].map(|name| {
            let text = std::fs::read_to_string(dir.join(format!("{example}/{name}.toml"))).unwrap();
            let short = format!("{example}/short-{name}.toml");
            std::fs::write(dir.join(&short), format!("{text}\n[search]\nactions = {actions}\n")).unwrap();
            short
        });
        let (before, after) = (format!("{example}-before"), format!("{example}-after"));
        scan(dir, &flawed, "exhaustive", &before);
        scan(dir, &fixed, "exhaustive", &after);
        let hazards = scan_json(&dir.join(&before))["hazards"].as_array().unwrap().len();
        let (code, text, _) = ran(dir, &["compare", &before, &after]);
        // Of whom the repair has begin elsewhere the first start is not known.
        let same_start = ["safety-fence", "light-curtain"].contains(&example);
        assert_eq!(code, Some(if same_start { 0 } else { 4 }), "{text}");
        let gone = if same_start { "fixed" } else { "not found again" };
        assert!(hazards > 0 && text.contains(&format!("\n {hazards} {gone}.")), "{text}");
        assert!(text.contains("Differs: cell file, ") && !text.contains("is not complete"), "{text}");
        assert_eq!(text.contains("begins at another place or time"), !same_start, "{text}");
        let (code, text, _) = ran(dir, &["compare", &after, &before, "--format", "json"]);
        let result: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(code, Some(1));
        let rows = result["hazards"].as_array().unwrap();
        assert!(rows.len() == hazards && rows.iter().all(|row| row["change"] == "new"), "{text}");
        // Three actions are too short for them, and in one nothing was seen: they are not fixed by that.
        for short in [3, 1].into_iter().filter(|_| example == "head-collision") {
            let text = "schema = 1\nname = \"too-short\"\nextends = \"short-cell.toml\"\n[search]\nactions = ";
            std::fs::write(dir.join("head-collision/too-short.toml"), format!("{text}{short}\n")).unwrap();
            let out = format!("after-{short}");
            ran(
                dir,
                &["scan", "--no-advice", "head-collision/too-short.toml", "--strategy", "exhaustive", "--out", &out],
            );
            let (code, text, _) = ran(dir, &["compare", &before, &out]);
            let all = text.contains(&format!("\n {hazards} not found again."));
            assert!(code == Some(4) && all && text.contains("the second scan ends earlier"), "{text}");
        }
        // The same sequences in the repaired cell, and in the flawed one.
        let (code, text, said) = ran(dir, &["replay", &before, "--changed", &fixed, "--junit", "verified.xml"]);
        // These have the larger safeguard over the first start.
        let over_start = ["sensor-mat", "head-collision"].contains(&example);
        assert_eq!(code, Some(if over_start { 4 } else { 0 }), "{text}{said}");
        assert!(text.contains(if over_start { " NOT SHOWN " } else { " fixed " }) && !text.contains("STILL"), "{text}");
        let junit = std::fs::read_to_string(dir.join("verified.xml")).unwrap();
        assert!(!junit.contains("<failure") && junit.contains("<error") == over_start, "{junit}");
        let (code, text, _) = ran(dir, &["replay", &before, "--changed", &flawed, "--junit", "verified.xml"]);
        assert_eq!(code, Some(1), "{text}");
        assert!(text.contains(" 0 of ") && !text.contains(" fixed  "), "{text}");
        assert!(std::fs::read_to_string(dir.join("verified.xml")).unwrap().contains("<failure"));
    }
}

#[test]
fn a_hazard_that_a_scan_might_have_missed_is_not_called_fixed() {
    let dir = examples();
    let dir = dir.path();
    scan(dir, "two-scanners/cell.toml", "hybrid", "before");
    scan(dir, "two-scanners/fixed.toml", "hybrid", "after");
    let (code, text, _) = ran(dir, &["compare", "before", "after"]);
    assert_eq!(code, Some(4), "{text}");
    assert!(text.contains(" not found again") && !text.contains(" fixed  "), "{text}");
    assert!(text.contains("The second scan is not complete"), "{text}");
}

#[test]
fn a_scan_compared_with_itself_is_the_same_and_what_is_no_scan_is_refused() {
    let dir = examples();
    let dir = dir.path();
    scan(dir, "head-collision/cell.toml", "hybrid", "out");
    let (code, text, _) = ran(dir, &["compare", "out", "out/scan.json"]);
    assert_eq!(code, Some(4));
    assert!(text.contains(" same.") && text.contains("Inputs are the same"), "{text}");
    assert!(text.contains("The first scan is not complete"), "{text}");
    for (arguments, problem) in [
        (["compare", "nowhere", "out"], "cannot read nowhere: "),
        (["compare", "out", "head-collision/cell.toml"], "is not a scan result: "),
    ] {
        let (code, _, said) = ran(dir, &arguments);
        assert!(code == Some(2) && said.contains(problem) && said.contains("give the scan.json of a scan"), "{said}");
    }
    std::fs::write(dir.join("old.json"), r#"{"schema_version": 1}"#).unwrap();
    let (code, _, said) = ran(dir, &["compare", "old.json", "out"]);
    assert!(code == Some(2) && said.contains("has format 1, this version reads 3"), "{said}");
}

/// A hazard has two sequences: where one of them leads nowhere any more, the other still counts.
#[test]
fn either_sequence_of_a_hazard_shows_that_it_is_still_there() {
    let dir = examples();
    let dir = dir.path();
    let scan = [
        "scan",
        "--no-advice",
        "heavy-workpiece/cell.toml",
        "--strategy",
        "random",
        "--iterations",
        "5",
        "--out",
        "before",
    ];
    assert_eq!(ran(dir, &scan).0, Some(1));
    let path = dir.join("before/scan.json");
    let whole = scan_json(&dir.join("before"));
    let stays = |sequence: &mut serde_json::Value| {
        for action in sequence.as_array_mut().unwrap() {
            *action = "stop/upright".into();
        }
    };
    for [first, shortest] in [[true, false], [false, true], [true, true]] {
        let mut changed = whole.clone();
        for hazard in changed["hazards"].as_array_mut().unwrap() {
            if first {
                stays(&mut hazard["actions"]);
            }
            if shortest {
                stays(&mut hazard["shortest"]["actions"]);
            }
        }
        std::fs::write(&path, changed.to_string()).unwrap();
        let (_, text, said) = ran(dir, &["replay", "before", "--changed", "heavy-workpiece/cell.toml"]);
        assert_eq!(text.contains("STILL THERE"), !(first && shortest), "{text}{said}");
    }
}
