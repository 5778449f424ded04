//! A flawed cell and its repaired variant side by side: `compare` and `verify`.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::path::Path;

use common::{examples, fmi_hazard};

fn ran(dir: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// Flawed cells are scanned quickly, repaired ones to the end.
fn scan(dir: &Path, cell: &str, strategy: &str, out: &str) {
    let (code, _, said) = ran(dir, &["scan", cell, "--strategy", strategy, "--iterations", "10", "--out", out]);
    assert!(code == Some(0) || code == Some(1), "{cell}: {said}");
}

#[test]
fn what_a_repair_fixed_is_told_and_what_undoing_it_brings_back() {
    let dir = examples();
    let dir = dir.path();
    for example in ["safety-fence", "head-collision", "two-scanners"] {
        let [flawed, fixed] = ["cell", "fixed"].map(|name| format!("{example}/{name}.toml"));
        let (before, after) = (format!("{example}-before"), format!("{example}-after"));
        scan(dir, &flawed, "hybrid", &before);
        // One of the repaired cells is not searched to the end: that has its say too.
        let whole = example != "two-scanners";
        scan(dir, &fixed, if whole { "exhaustive" } else { "hybrid" }, &after);
        let (code, text, _) = ran(dir, &["compare", &before, &after]);
        assert_eq!(code, Some(0), "{text}");
        let (expected, other) = if whole { ("fixed", "not found again") } else { ("not found again", "fixed") };
        assert!(text.contains(&format!(" {expected}")) && !text.contains(&format!(" {other}  ")), "{text}");
        assert!(!text.contains("NEW") && !text.contains("same "), "{text}");
        assert!(text.contains("Differs: cell file, "), "{text}");
        let (code, text, _) = ran(dir, &["compare", &after, &before, "--format", "json"]);
        let result: serde_json::Value = serde_json::from_str(&text).unwrap();
        assert_eq!(code, Some(1));
        assert!(result["hazards"].as_array().unwrap().iter().all(|row| row["change"] == "new"), "{text}");
        // The same sequences in the repaired cell, and in the flawed one.
        let (code, text, said) = ran(dir, &["verify", &before, &fixed, "--junit", "verified.xml"]);
        assert_eq!(code, Some(0), "{text}{said}");
        assert!(text.contains(" fixed ") && !text.contains("STILL"), "{text}");
        assert!(!std::fs::read_to_string(dir.join("verified.xml")).unwrap().contains("<failure"));
        let (code, text, _) = ran(dir, &["verify", &before, &flawed, "--junit", "verified.xml"]);
        assert_eq!(code, Some(1), "{text}");
        assert!(text.contains(" 0 of ") && !text.contains(" fixed  "), "{text}");
        assert!(std::fs::read_to_string(dir.join("verified.xml")).unwrap().contains("<failure"));
    }
}

#[test]
fn a_scan_compared_with_itself_is_the_same_and_what_is_no_scan_is_refused() {
    let dir = examples();
    let dir = dir.path();
    scan(dir, "head-collision/cell.toml", "hybrid", "out");
    let (code, text, _) = ran(dir, &["compare", "out", "out/scan.json"]);
    assert_eq!(code, Some(0));
    assert!(text.contains(" same.") && text.contains("Inputs are the same"), "{text}");
    assert!(text.contains("The first scan did not account for every sequence"), "{text}");
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
