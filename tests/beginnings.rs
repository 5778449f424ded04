//! Several starts and times: each is searched as a cell of its own would be, and what comes before the person begins is part
//! of what others simulate again.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::path::Path;
use std::sync::Arc;

use common::formats::read_by_others;
use common::{examples, fmi_hazard, json, scan_json, write};
use fmi_hazard::human::Action;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::sim::replay::replay;

/// The example with two starts at two times, three actions.
const HUMAN: &str = "[search]\nactions = 3\n[human]\nother_starts = [{ xy_m = [0.5, -0.7], heading_deg = 45 }]\n\
                     begins_s = [0.4, 1.2]";

fn cell(dir: &Path, name: &str, human: &str) {
    let text = std::fs::read_to_string(dir.join("safety-fence/cell.toml")).unwrap();
    assert!(text.contains("[human]") && text.contains("xy_m = [1.05, -1.7]"));
    let text = text.replace("[human]", human).replace("xy_m = [1.05, -1.7]", "xy_m = [0.45, -0.7]");
    write(dir, &format!("safety-fence/{name}.toml"), &text);
}

fn scan<'a>(name: &'a str, out: &'a str) -> [&'a str; 6] {
    ["scan", name, "--strategy", "exhaustive", "--out", out]
}

#[test]
fn a_later_beginning_is_as_if_the_person_had_stood_still_before() {
    let dir = examples();
    let dir = dir.path();
    cell(dir, "many", HUMAN);
    cell(dir, "once", "[human]");
    let printed = fmi_hazard(dir).args(scan("safety-fence/many.toml", "o")).assert().code(1).get_output().clone();
    let printed = String::from_utf8_lossy(&printed.stdout).into_owned();
    assert!(printed.contains("4 beginnings") && printed.contains("o/begin-4"), "{printed}");
    let table = json(&dir.join("o/beginnings.json"));
    let mut hazards = 0;
    for (number, (start, stops)) in (1..).zip([(0, 2), (1, 2), (0, 6), (1, 6)]) {
        let out = dir.join(format!("o/begin-{number}"));
        let found = scan_json(&out);
        let found = found["hazards"].as_array().unwrap();
        assert_eq!(table["beginnings"][number - 1]["hazards"], found.len());
        // The other start is one of another cell here.
        let human =
            ["[human]", "[human]\nbegins_s = [0]\nother_starts = [{ xy_m = [0.5, -0.7], heading_deg = 45 }]"][start];
        cell(dir, "once", human);
        let once = prepare(&dir.join("safety-fence/once.toml"), None).unwrap().beginning(start).unwrap();
        for hazard in found {
            let own: Vec<Action> = serde_json::from_value(hazard["actions"].clone()).unwrap();
            let still: Action = "stop/upright".parse().unwrap();
            let actions: Vec<Action> = std::iter::repeat_n(still, stops).chain(own).collect();
            let plant = once.plant(StateChoice::Replay);
            let again = replay(Arc::clone(&once.cell), Arc::clone(&once.binding), plant, &actions).unwrap().unwrap();
            assert_eq!(hazard["force_n"], again.contact.force_n);
            let later = 0.2 * f64::from(u32::try_from(stops).unwrap());
            assert!((hazard["time_s"].as_f64().unwrap() + later - again.time_s).abs() < 1e-9);
            hazards += 1;
        }
        let folder = format!("o/begin-{number}");
        if let Some(worst) = found.first() {
            let id = worst["id"].as_str().unwrap();
            let replayed = fmi_hazard(dir).args(["replay", &folder, id]).assert().code(1).get_output().clone();
            assert!(String::from_utf8_lossy(&replayed.stdout).contains("to the last bit"));
            // FMPy simulates the whole of it, the time before the person begins included.
            let inputs = std::fs::read_to_string(out.join(format!("{id}.outputs.csv"))).unwrap();
            assert!(inputs.lines().count() > stops * 10, "{inputs}");
        }
        read_by_others(&out, Some(&dir.join("safety-fence/safety-fence.fmu")));
    }
    assert!(hazards > 10, "{hazards} hazards show too little");
    let of_all = fmi_hazard(dir).args(["replay", "o", "all"]).assert().code(2).get_output().clone();
    assert!(String::from_utf8_lossy(&of_all.stderr).contains("o/begin-1"));
    // One alone, in a worker that restores nothing; and known hazards are known by beginning.
    let mut alone = fmi_hazard(dir);
    alone.args(scan("safety-fence/many.toml", "alone")).args(["--begin", "3", "--state", "replay"]).assert().code(1);
    assert_eq!(scan_json(&dir.join("alone"))["hazards"], scan_json(&dir.join("o/begin-3"))["hazards"]);
    fmi_hazard(dir).args(scan("safety-fence/many.toml", "again")).args(["--baseline", "o"]).assert().code(0);
    fmi_hazard(dir).args(scan("safety-fence/many.toml", "no")).args(["--begin", "5"]).assert().code(2);
    fmi_hazard(dir).args(scan("safety-fence/many.toml", "no")).arg("--write-baseline").assert().code(2);
}

#[test]
fn a_beginning_is_its_start_and_time_not_its_number() {
    let dir = examples();
    let dir = dir.path();
    let human = |starts: &str| HUMAN.replace("other_starts = [", &format!("other_starts = [{starts}"));
    cell(dir, "many", HUMAN);
    let few = ["scan", "safety-fence/many.toml", "--strategy", "random", "--iterations", "8"];
    fmi_hazard(dir).args(few).args(["--out", "o"]).assert().code(1);
    // One more start in front: what was the third is the fourth.
    cell(dir, "more", &human("{ xy_m = [0.48, -0.75], heading_deg = 90 }, "));
    let known = scan_json(&dir.join("o/begin-3"));
    assert!(!known["hazards"].as_array().unwrap().is_empty());
    let verified = fmi_hazard(dir).args(["verify", "o/begin-3", "safety-fence/more.toml"]).assert().code(1);
    let said = String::from_utf8_lossy(&verified.get_output().stdout).into_owned();
    assert!(!said.contains("fixed") || said.contains(" 0 fixed") || said.contains("0 of"), "{said}");
    // Known from where it was known; all of the new start's is new.
    let more = ["scan", "safety-fence/more.toml", "--strategy", "random", "--iterations", "8", "--baseline", "o"];
    fmi_hazard(dir).args(more).args(["--begin", "4", "--out", "four"]).assert().code(0);
    assert_eq!(scan_json(&dir.join("four"))["hazards"], known["hazards"]);
    let new = fmi_hazard(dir).args(more).args(["--begin", "2", "--out", "two"]).assert().get_output().clone();
    let told = String::from_utf8_lossy(&new.stderr).into_owned();
    assert!(told.contains("0 known"), "{told}");
    let other = fmi_hazard(dir).args(["compare", "o/begin-1", "o/begin-3"]).assert().get_output().clone();
    assert!(String::from_utf8_lossy(&other.stdout).contains("the person begins: at (0.45, -0.70) m"));
    // What cannot be read is not taken for nothing known.
    std::fs::create_dir(dir.join("torn")).unwrap();
    std::fs::write(dir.join("torn/beginnings.json"), "{").unwrap();
    fmi_hazard(dir).args(few).args(["--out", "no", "--baseline", "torn"]).assert().code(2);
    // A beginning that is gone is not taken for another.
    cell(dir, "once", "[human]");
    let gone =
        fmi_hazard(dir).args(["verify", "o/begin-3", "safety-fence/once.toml"]).assert().code(2).get_output().clone();
    assert!(String::from_utf8_lossy(&gone.stderr).contains("any more"));
    // One of several goes where the others are, unless told otherwise; and can be looked at there.
    fmi_hazard(dir).args(few).args(["--begin", "3"]).assert().code(1);
    let id = scan_json(&dir.join("out/safety-fence/begin-3"))["hazards"][0]["id"].as_str().unwrap().to_owned();
    fmi_hazard(dir).args(["replay", "out/safety-fence/begin-3", &id]).assert().code(1);
}
