//! Several starts and times: each is searched as a cell of its own would be, and what comes before the person begins is part
//! of what others simulate again.

use std::path::Path;
use std::sync::Arc;

use crate::common::formats::read_by_others;
use crate::common::{examples, fmi_hazard, json, scan_json, write};
use crate::sample;
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

fn scan<'a>(name: &'a str, out: &'a str) -> [&'a str; 7] {
    ["scan", "--no-advice", name, "--strategy", "exhaustive", "--out", out]
}

#[test]
fn a_later_beginning_is_as_if_the_person_had_stood_still_before() {
    if !sample::is_turn(2, 12) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    cell(dir, "many", &HUMAN.replace("actions = 3", if sample::is_whole() { "actions = 3" } else { "actions = 2" }));
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
            let again =
                replay(Arc::clone(&once.cell), Arc::clone(&once.binding), plant, &actions, None).unwrap().unwrap();
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
        if sample::takes(number, 2) {
            read_by_others(&out, Some(&dir.join("safety-fence/safety-fence.fmu")));
        }
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
    if !sample::is_turn(4, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let human = |starts: &str| HUMAN.replace("other_starts = [", &format!("other_starts = [{starts}"));
    cell(dir, "many", HUMAN);
    let few = ["scan", "--no-advice", "safety-fence/many.toml", "--strategy", "random", "--iterations", "8"];
    fmi_hazard(dir).args(few).args(["--out", "o"]).assert().code(1);
    // One more start in front: what was the third is the fourth.
    cell(dir, "more", &human("{ xy_m = [0.48, -0.75], heading_deg = 90 }, "));
    let known = scan_json(&dir.join("o/begin-3"));
    assert!(!known["hazards"].as_array().unwrap().is_empty());
    let verified =
        fmi_hazard(dir).args(["replay", "o/begin-3", "--changed", "safety-fence/more.toml"]).assert().code(1);
    let said = String::from_utf8_lossy(&verified.get_output().stdout).into_owned();
    assert!(!said.contains("fixed") || said.contains(" 0 fixed") || said.contains("0 of"), "{said}");
    // Known from where it was known; all of the new start's is new.
    let more = [
        "scan",
        "--no-advice",
        "safety-fence/more.toml",
        "--strategy",
        "random",
        "--iterations",
        "8",
        "--baseline",
        "o",
    ];
    // A few sequences show nothing of the others.
    fmi_hazard(dir).args(more).args(["--begin", "4", "--out", "four"]).assert().code(4);
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
    // A beginning that the cell has no more is not taken for another: what was found from there is tried from there.
    cell(dir, "once", "[human]");
    let gone = fmi_hazard(dir)
        .args(["replay", "o/begin-3", "--changed", "safety-fence/once.toml"])
        .assert()
        .code(1)
        .get_output()
        .clone();
    assert!(String::from_utf8_lossy(&gone.stdout).contains("STILL THERE"));
    // One of several goes where the others are, unless told otherwise; and can be looked at there.
    fmi_hazard(dir).args(few).args(["--begin", "3"]).assert().code(1);
    let id = scan_json(&dir.join("out/safety-fence/begin-3"))["hazards"][0]["id"].as_str().unwrap().to_owned();
    fmi_hazard(dir).args(["replay", "out/safety-fence/begin-3", &id]).assert().code(1);
}

/// The example with these lines of `[human]`, which have the start.
fn with_human(dir: &Path, name: &str, lines: &str) {
    let text = std::fs::read_to_string(dir.join("safety-fence/cell.toml")).unwrap();
    let text = text.replace("start = { xy_m = [1.05, -1.7], heading_deg = 90 }", lines);
    let actions = if sample::is_whole() { 3 } else { 2 };
    write(dir, &format!("safety-fence/{name}.toml"), &format!("{text}\n[search]\nactions = {actions}\n"));
}

/// Where the starts of a cell are, in their order.
fn starts(dir: &Path, name: &str) -> Vec<([f64; 2], f64)> {
    let cell = fmi_hazard::cell::find::open(&dir.join(format!("safety-fence/{name}.toml")), None).unwrap().cell;
    cell.beginnings.iter().map(|b| (b.start.xy_m(), (b.start.heading_deg() * 1e6).round() / 1e6)).collect()
}

#[test]
fn an_area_is_a_lattice_of_starts_that_stays_where_it_is() {
    let dir = examples();
    let dir = dir.path();
    let area = |polygon: &str, rest: &str| format!("start_area = [{{ polygon_m = {polygon}, {rest} }}]");
    let square = "[[-1, -1], [1, -1], [1, 0], [-1, 0]]";
    with_human(dir, "area", &area(square, "spacing_m = 0.25, heading_deg = [90, 270]"));
    // By hand: nine columns from -1 to 1 m; rows at -1, -0.75, -0.5 and -0.25 m, the edge included. At 0 m the fence stands,
    // and the conveyor from it to -0.3 m, 0.28 m to both sides.
    let found = starts(dir, "area");
    let mut expected = Vec::new();
    for row in [-1.0, -0.75, -0.5, -0.25] {
        for column in (-4..=4_i32).filter(|column| row < -0.3 || column.abs() > 1) {
            expected.extend([90.0, 270.0].map(|heading| ([f64::from(column) * 0.25, row], heading)));
        }
    }
    assert_eq!(found, expected);
    let checked = fmi_hazard(dir).args(["check", "safety-fence/area.toml"]).assert().code(0).get_output().clone();
    let text = String::from_utf8_lossy(&checked.stdout).into_owned();
    let words =
        "starts at 33 places of an area, 0.25 m apart, 2 headings each; 12 more are left out: obstacles are there";
    assert!(text.contains(words) && text.contains("66 beginnings") && !text.contains("starts at ("), "{text}");
    let picture = std::fs::read_to_string(dir.join("safety-fence/area.check.svg")).unwrap();
    assert_eq!(picture.matches("r=\"3\"").count(), 66, "every start is drawn");
    // A notch, and a corner elsewhere: places that are left are the same ones. 0.1 is no binary fraction.
    let notched = "[[-1.07, -1], [1, -1], [1, -0.2], [0.1, -0.2], [0.1, -0.6], [-0.5, -0.2], [-1.07, -0.2]]";
    with_human(dir, "area", &area(square, "spacing_m = 0.1, heading_deg = [90]"));
    with_human(dir, "notched", &area(notched, "spacing_m = 0.1, heading_deg = [90]"));
    let [all, some] = ["area", "notched"].map(|name| starts(dir, name));
    assert!(some.len() < all.len() && some.len() > 100 && some.iter().all(|start| all.contains(start)));
    assert!(all.contains(&([0.3, -0.7], 90.0)) && some.contains(&([0.1, -0.6], 90.0)));
    // Beside starts by themselves, each once, and at every time.
    let lines = format!(
        "start = {{ xy_m = [0.5, -0.75], heading_deg = 90 }}\nbegins_s = [0, 0.4]\n{}",
        area("[[0.4, -0.8], [0.6, -0.8], [0.6, -0.4], [0.4, -0.4]]", "spacing_m = 0.25, heading_deg = [90, 0]")
    );
    with_human(dir, "both", &lines);
    let both = starts(dir, "both");
    let once = [([0.5, -0.75], 90.0), ([0.5, -0.75], 0.0), ([0.5, -0.5], 90.0), ([0.5, -0.5], 0.0)];
    assert_eq!(both, [once, once].concat());
    let checked = fmi_hazard(dir).args(["check", "safety-fence/both.toml"]).assert().code(0).get_output().clone();
    let text = String::from_utf8_lossy(&checked.stdout).into_owned();
    let words = "4 starts at 2 times, the last 0.40 s after the FMU: 8 beginnings";
    assert!(text.contains("starts at (0.50, -0.75) m") && text.contains(words), "{text}");
}

#[test]
fn a_place_of_an_area_is_searched_as_a_start_by_itself() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    // Two places: 0.45 m, and -0.75 or -0.6 m.
    let area = "[[human.start_area]]\npolygon_m = [[0.45, -0.75], [0.5, -0.75], [0.5, -0.6], [0.45, -0.6]]\n\
                spacing_m = 0.15\nheading_deg = [45]";
    with_human(dir, "area", area);
    with_human(
        dir,
        "written",
        "start = { xy_m = [0.45, -0.75], heading_deg = 45 }\nother_starts = [{ xy_m = [0.45, -0.6], heading_deg = 45 }]",
    );
    let code = fmi_hazard(dir).args(scan("safety-fence/area.toml", "a")).output().unwrap().status.code();
    assert_eq!(fmi_hazard(dir).args(scan("safety-fence/written.toml", "w")).output().unwrap().status.code(), code);
    assert_eq!(code, Some(1));
    for begin in ["begin-1", "begin-2"] {
        let [a, w] = ["a", "w"].map(|out| scan_json(&dir.join(out).join(begin)));
        assert_eq!(a["hazards"], w["hazards"]);
        assert_eq!(a["subject"]["beginning"], w["subject"]["beginning"]);
    }
    assert!(dir.join("a/beginnings.json").is_file() && !dir.join("a/begin-3").exists());
    let alone = scan("safety-fence/area.toml", "two");
    fmi_hazard(dir).args(alone).args(["--begin", "2"]).output().unwrap();
    assert_eq!(scan_json(&dir.join("two"))["hazards"], scan_json(&dir.join("a/begin-2"))["hazards"]);
    // What explains a hazard from there begins there.
    let of = ["a/begin-1", "a/begin-2"].into_iter().find_map(|folder| {
        let id = scan_json(&dir.join(folder))["hazards"][0]["id"].as_str()?.to_owned();
        Some((folder, id))
    });
    let (folder, id) = of.unwrap();
    // A few things that it may change show it, and take less time than all: parameters, and a fence and the robot where all cases are
    // looked at.
    let cell = std::fs::read_to_string(dir.join("safety-fence/area.toml")).unwrap();
    let table: toml::Table = cell.parse().unwrap();
    let names = table["obstacle"].as_array().unwrap().iter().map(|obstacle| obstacle["name"].as_str().unwrap());
    let names = names.filter(|name| !sample::is_whole() || *name != "fence above the opening");
    let mut fixed: String = names.map(|name| format!("\"{name}\".fixed = true\n")).collect();
    if !sample::is_whole() {
        let robot = table["robot"][0]["name"].as_str().unwrap();
        fixed = format!("{fixed}[explain.robot]\n\"{robot}\".fixed = true\n");
    }
    write(dir, "safety-fence/area.toml", &format!("{cell}\n[explain.obstacle]\n{fixed}"));
    let mut explain = fmi_hazard(dir);
    explain.args(["explain", folder, &id, "--from", "start", "--quick", "--iterations", "1", "--format", "json"]);
    let told: serde_json::Value = serde_json::from_slice(&explain.output().unwrap().stdout).unwrap();
    let remedies = told["remedies"].as_array().unwrap();
    let tried = remedies.iter().filter(|remedy| remedy["outcome"].get("not_tried").is_none());
    assert!(tried.count() >= 3 && remedies.iter().any(|remedy| remedy["change"] == "fence back"), "{told}");
    fmi_hazard(dir).args(["replay", folder, &id]).assert().code(1);
}

#[test]
fn areas_without_a_place_and_with_too_many_are_refused() {
    let dir = examples();
    let dir = dir.path();
    for (lines, words) in [
        ("sex = \"man\"", "the person has no start"),
        (
            "start_area = [{ polygon_m = [[-1, -0.1], [1, -0.1], [1, 0.1], [-1, 0.1]], spacing_m = 0.2, heading_deg = [0] }]",
            "obstacles are in the way at all 11 places",
        ),
        (
            "start_area = [{ polygon_m = [[0.1, 0.1], [0.2, 0.1], [0.2, 0.2]], spacing_m = 1, heading_deg = [0] }]",
            "no place of a lattice of 1 m is in the start area",
        ),
        (
            "begins_s = [0, 1]\nstart_area = [{ polygon_m = [[-10, -12], [10, -12], [10, -2], [-10, -2]], spacing_m = 0.1, \
             heading_deg = [0] }]",
            "the person has 40602 beginnings: 20301 starts at 2 times",
        ),
        (
            "start_area = [{ polygon_m = [[-199, -199], [199, -199], [0, 199]], spacing_m = 0.1, heading_deg = [0] }]",
            "places around the start area",
        ),
        ("start_area = [{ polygon_m = [[0, 0], [1, 0]], spacing_m = 0.1, heading_deg = [0] }]", "three corners"),
        ("start_area = [{ polygon_m = [[0, 0], [1, 0], [1, 1]], spacing_m = 0, heading_deg = [0] }]", "spacing_m"),
        ("start_area = [{ polygon_m = [[0, 0], [1, 0], [1, 1]], spacing_m = 0.1, heading_deg = [] }]", "no heading"),
    ] {
        with_human(dir, "wrong", lines);
        let checked = fmi_hazard(dir).args(["check", "safety-fence/wrong.toml", "--no-run"]).assert().code(2);
        let text = String::from_utf8_lossy(&checked.get_output().stderr).into_owned();
        // As on one line, whatever the terminal's width.
        let text = text.replace('│', " ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(words), "{words}: {text}");
        assert_eq!(text.matches("Error:").count(), 1, "{text}");
    }
}
