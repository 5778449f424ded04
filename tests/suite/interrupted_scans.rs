//! A scan that was interrupted, or killed, goes on with `--resume` and ends as if nothing had happened.

use std::path::Path;

use crate::common::started::Started;
use crate::common::{examples, fmi_hazard, json, scan_json};
use crate::sample;

/// Starts a scan and sends it a signal once it says `word`; its exit code, if it ended by itself.
fn interrupted(dir: &Path, arguments: &[&str], word: &str, signal: &str) -> Option<i32> {
    let scan = Started::until(dir, arguments, word);
    scan.signal(signal);
    scan.end().0
}

#[test]
fn an_exhaustive_search_goes_on_where_it_was() {
    if !sample::is_turn(4, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let cell = std::fs::read_to_string(dir.join("heavy-workpiece/cell.toml")).unwrap();
    let actions = if sample::is_whole() { 7 } else { 6 };
    let short = format!("{cell}\n[search]\nactions = {actions}\n");
    std::fs::write(dir.join("heavy-workpiece/short.toml"), short).unwrap();
    let scan = |out| ["scan", "--no-advice", "heavy-workpiece/short.toml", "--strategy", "exhaustive", "--out", out];
    fmi_hazard(dir).args(scan("whole")).assert().code(1);
    assert!(!dir.join("whole/resume.json").exists() && !dir.join("whole/answers.bin").exists());
    for (out, signal, code) in sample::some([("stopped", "-INT", Some(130)), ("killed", "-KILL", None)], 2) {
        // The last but one action begins when the others are in the file.
        let last_but_one = format!("action {} of {actions}", actions - 1);
        assert_eq!(interrupted(dir, &scan(out), &last_but_one, signal), code);
        if signal == "-INT" {
            let so_far = scan_json(&dir.join(out));
            assert_eq!(so_far["certificate"]["complete"], false);
            assert_eq!(json(&dir.join(out).join("resume.json"))["folder"], "..", "so that both may be moved");
        }
        // From another folder, and with less than was known: the end of the file is torn.
        let kept = dir.join(out).join("answers.bin");
        let bytes = std::fs::read(&kept).unwrap();
        std::fs::write(&kept, &bytes[..bytes.len() - 5]).unwrap();
        let elsewhere = dir.join("safety-fence");
        let folder = format!("../{out}");
        fmi_hazard(&elsewhere).args(["scan", "--resume", &folder]).assert().code(1);
        for file in ["scan.json", "hazards.jsonl"] {
            let read = |out: &str| std::fs::read_to_string(dir.join(out).join(file)).unwrap();
            assert!(read(out) == read("whole"), "{out} {file}");
        }
        assert!(json(&dir.join(out).join("run.json"))["questions_from_journal"].as_u64().unwrap() > 1000);
        assert!(!kept.exists() && !dir.join(out).join("resume.json").exists());
        // There is nothing left to do.
        let output = fmi_hazard(dir).args(["scan", "--resume", out]).assert().code(2).get_output().clone();
        assert!(String::from_utf8_lossy(&output.stderr).contains("no scan to go on with"));
    }
}

#[test]
fn a_changed_cell_is_not_gone_on_with() {
    let dir = examples();
    let dir = dir.path();
    let scan = ["scan", "--no-advice", "heavy-workpiece/cell.toml", "--strategy", "exhaustive", "--out", "o"];
    assert_eq!(interrupted(dir, &scan, "action 5 of 8", "-INT"), Some(130));
    let path = dir.join("heavy-workpiece/cell.toml");
    let cell = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, cell.replace("heading_deg = 180", "heading_deg = 225")).unwrap();
    let output = fmi_hazard(dir).args(["scan", "--resume", "o"]).assert().code(2).get_output().clone();
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(text.contains("another search") && text.contains("without --resume"), "{text}");
}

#[test]
fn a_strategy_is_run_again_with_the_same_result() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let scan = |out| {
        ["scan", "--no-advice", "sensor-mat/cell.toml", "--strategy", "hybrid", "--iterations", "40", "--out", out]
    };
    let code = fmi_hazard(dir).args(scan("whole")).assert().get_output().status.code();
    assert_eq!(interrupted(dir, &scan("stopped"), "States", "-INT"), Some(130));
    let again = fmi_hazard(dir).args(["scan", "--resume", "stopped"]).assert().get_output().status.code();
    assert_eq!(again, code);
    let read = |out: &str| std::fs::read_to_string(dir.join(out).join("scan.json")).unwrap();
    assert!(read("stopped") == read("whole"));
}

#[test]
fn of_several_beginnings_those_that_ended_are_not_searched_again() {
    let dir = examples();
    let dir = dir.path();
    let cell = std::fs::read_to_string(dir.join("safety-fence/cell.toml")).unwrap();
    let several = "[search]\nactions = 4\n[human]\nbegins_s = [0, 0.8, 1.6]";
    std::fs::write(dir.join("safety-fence/many.toml"), cell.replace("[human]", several)).unwrap();
    let scan = |out| ["scan", "--no-advice", "safety-fence/many.toml", "--strategy", "exhaustive", "--out", out];
    let code = fmi_hazard(dir).args(scan("whole")).assert().get_output().status.code();
    assert_eq!(interrupted(dir, &scan("stopped"), "Begins  2 of 3", "-INT"), Some(130));
    let again = fmi_hazard(dir).args(["scan", "--resume", "stopped"]).assert().get_output().clone();
    assert_eq!(again.status.code(), code);
    let told = String::from_utf8_lossy(&again.stderr).into_owned();
    assert!(!told.contains("Begins  1 of 3") && told.contains("Begins  2 of 3"), "{told}");
    for file in ["beginnings.json", "begin-1/scan.json", "begin-2/scan.json", "begin-3/scan.json"] {
        let read = |out: &str| std::fs::read_to_string(dir.join(out).join(file)).unwrap();
        assert!(read("stopped") == read("whole"), "{file}");
    }
    assert!(!dir.join("stopped/resume.json").exists());
}
