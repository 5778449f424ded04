//! Same cell, seed and version: the same bytes, whichever way states are brought back and however many workers.

use crate::common::stored::scanned;
use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;

const CELL: &str = "safety-fence/cell.toml";

#[test]
fn twice_the_same_scan_gives_the_same_bytes() {
    let dir = examples();
    for out in ["a", "b"] {
        fmi_hazard(dir.path())
            .args(["scan", "--no-advice", CELL, "--strategy", "mcts-dpw", "--iterations", "60", "--out", out])
            .assert()
            .code(1);
    }
    for file in ["scan.json", "hazards.jsonl"] {
        let read = |out: &str| std::fs::read(dir.path().join(out).join(file)).unwrap();
        assert!(read("a") == read("b"), "{file} differs");
    }
}

#[test]
fn saved_states_and_full_resimulation_give_identical_hazards() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let dir = examples();
    for strategy in sample::some(["mcts-dpw", "random"], 2) {
        let scan = |state: &str, extra: &[&str]| {
            let out = format!("{strategy}-{state}");
            let args = [
                "scan",
                "--no-advice",
                CELL,
                "--iterations",
                "25",
                "--strategy",
                strategy,
                "--state",
                state,
                "--out",
                &out,
            ];
            fmi_hazard(dir.path()).args(args).args(extra).assert().code(1);
            let read = |file: &str| std::fs::read_to_string(dir.path().join(&out).join(file)).unwrap();
            (read("scan.json"), serde_json::from_str::<serde_json::Value>(&read("run.json")).unwrap())
        };
        let ((saved_result, saved), (replayed_result, replayed)) = (scan("fmu", &[]), scan("replay", &[]));
        assert!(saved_result == replayed_result, "{strategy}");
        // It really was done another way: without memory every action of every sequence is stepped.
        let steps = |v: &serde_json::Value| v["fmu"]["steps"].as_u64().unwrap();
        assert!(steps(&replayed) > 10 * steps(&saved), "{} {}", steps(&replayed), steps(&saved));
    }
}

#[test]
fn every_recorded_hazard_replays_to_the_last_bit() {
    if !sample::is_turn(0, 2) {
        return;
    }
    let dir = examples();
    let args = ["--no-advice", CELL, "--strategy", "mcts-dpw", "--iterations", "200", "--out", "o"];
    assert_eq!(scanned(dir.path(), &args).code, Some(1));
    let scan = scan_json(&dir.path().join("o"));
    let hazards = scan["hazards"].as_array().unwrap();
    assert!(!hazards.is_empty());
    assert!(hazards.iter().all(|h| h["confirmed"] == true), "{hazards:?}");
    let output = fmi_hazard(dir.path()).args(["replay", "o/scan.json", "all"]).assert().code(1).get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    assert_eq!(text.lines().filter(|l| l.contains("to the last bit")).count(), hazards.len(), "{text}");
}

#[test]
fn the_number_of_workers_does_not_matter() {
    let dir = examples();
    let bench = |workers: &str| {
        let args = ["bench", CELL, "--seeds", "4", "--iterations", "40", "--format", "json", "--workers", workers];
        fmi_hazard(dir.path()).args(args).assert().code(0).get_output().stdout.clone()
    };
    let one = bench("1");
    assert!(one == bench("8"));
    assert!(String::from_utf8(one).unwrap().contains("mcts-dpw"));
}

#[test]
fn the_posture_sweep_changes_what_is_found_but_not_where_the_search_goes() {
    let dir = examples();
    let scan = |out: &str, extra: &[&str]| {
        let args = ["--no-advice", CELL, "--strategy", "random", "--iterations", "100", "--seed", "4"];
        scanned(dir.path(), &[&args[..], extra, &["--out", out]].concat());
        scan_json(&dir.path().join(out))
    };
    let (sweep, paper) = (scan("sweep", &[]), scan("paper", &["--paper-iterations"]));
    assert_eq!(sweep["spent"]["actions"], paper["spent"]["actions"]);
    let found = |v: &serde_json::Value| -> u64 {
        v["hazards"].as_array().unwrap().iter().map(|h| h["times_found"].as_u64().unwrap()).sum()
    };
    assert!(found(&sweep) > found(&paper), "{} {}", found(&sweep), found(&paper));
}
