//! Speeds that an FMU tells against the way that its robot comes: where they disagree nothing is certified, and no cell
//! that tells the truth is accused.

use std::path::{Path, PathBuf};

use crate::common::{examples, faulty_cell, fmi_hazard, scan_json, test_fmus, write};
use crate::sample;
use fmi_hazard::host::Plant as _;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::speeds::Speeds;
use fmi_hazard::sim::World;
use fmi_hazard::sim::motion::{Comparison, Motion};
use serde_json::Value;

/// What is said of a cell's motion over 10 s: idle, and with every sensor reporting for a while, from several moments on.
fn said(path: &Path) -> Speeds {
    let prepared = prepare(path, None).unwrap();
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let comparison = Comparison::new(cell, binding);
    let mut motion = Motion::default();
    let world = World::new(cell.clone(), binding.clone());
    let idle = world.initial_inputs();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "hundreds")]
    let steps = (10.0 / cell.step_s) as usize;
    for at in [steps, steps / 7, steps / 5, steps / 3, steps / 2] {
        let mut plant = prepared.plant_from(StateChoice::Replay, &idle);
        let mut rows = plant.restart().unwrap();
        let mut stop = idle.clone();
        for (number, sensor) in cell.sensors.iter().enumerate() {
            if let fmi_hazard::cell::binding::SensorBinding::Input(column) = binding.sensors[number] {
                stop[column] = sensor.signal.value(true);
            }
        }
        for step in 0..steps {
            let stopped = (at..at + steps / 7).contains(&step);
            rows.extend(plant.advance(1, if stopped { &stop } else { &idle }).unwrap());
        }
        comparison.look(&rows, 0, 0, &mut motion);
    }
    assert!(!motion.moved.is_empty(), "{}", path.display());
    Speeds::new(cell, binding, &motion)
}

#[test]
fn no_cell_that_tells_the_truth_is_accused() {
    let dir = examples();
    let mut cells: Vec<PathBuf> = Vec::new();
    for name in fmi_hazard::examples::all().iter().map(|example| example.name) {
        for file in ["cell.toml", "fixed.toml"] {
            let path = dir.path().join(name).join(file);
            let fmi3 = test_fmus().join(format!("{name}-fmi3.fmu"));
            let fmi3 = format!("extends = \"{file}\"\nname = \"fmi3\"\nfmu = \"{}\"\n", fmi3.display());
            // One is in parts only.
            if test_fmus().join(format!("{name}.fmu")).is_file() {
                cells.push(write(dir.path(), &format!("{name}/fmi3-{file}"), &fmi3));
            }
            cells.push(path);
        }
    }
    cells.push(dir.path().join("sensor-mat/coupled.toml"));
    for fmu in FMUS {
        let fmu = test_fmus().join(fmu).display().to_string();
        cells.push(write(dir.path(), "honest.toml", &faulty_cell(&fmu, 0, 0)));
    }
    for cell in sample::some(&cells, 3) {
        let said = said(cell);
        assert_eq!(said.sentences(), Vec::<String>::new(), "{}", cell.display());
    }
}

/// A speed for the joint of the faulty cell that is none, and what is said of it.
const LIES: [(&str, &str); 5] = [
    ("{ variable = \"qd\", plus = { \"qd\" = -1 } }", "is always 0"),
    ("{ variable = \"qd\", sign = -1 }", "opposite sign"),
    ("{ variable = \"qd\", plus = { \"qd\" = 56.29578 } }", "57.3 times"),
    ("{ variable = \"qd\", plus = { \"qd\" = 1 } }", "0.50 times"),
    ("{ variable = \"qd\", plus = { \"qd\" = -0.5 } }", "2.00 times"),
];

const FMUS: [&str; 2] = ["faulty.fmu", "faulty-fmi3.fmu"];

/// All rungs.
const STATES: [&str; 4] = ["fmu", "fork", "replay", "process"];

const TRUE_SPEED: &str = "{ variable = \"qd\", unit = \"rad/s\" }";

/// The faulty cell with two actions and this speed of its joint.
fn cell_with(fmu: &str, kind: i32, step: i32, speed: &str) -> String {
    let fmu = test_fmus().join(fmu).display().to_string();
    let cell = faulty_cell(&fmu, kind, step).replace(TRUE_SPEED, speed);
    assert!(cell.contains(speed));
    // From here the person gets onto the mat, and no hand is hurt at 0.5 m/s.
    let cell = cell.replace("xy_m = [0, -1.6]", "xy_m = [1.7, -1.1]");
    cell.replace("iterations = 12", "actions = 2\niterations = 12")
}

/// Exit code, what is said, and `scan.json` of an exhaustive scan.
fn scan(dir: &Path, cell: &str, state: &str) -> (i32, String, Value) {
    let mut scan = fmi_hazard(dir);
    let scan = scan.args(["scan", "--no-advice", cell, "--out", "out", "--strategy", "exhaustive", "--state", state]);
    let output = scan.output().unwrap();
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    (output.status.code().unwrap(), text, scan_json(&dir.join("out")))
}

fn warned(result: &Value, what: &str) -> bool {
    result["warnings"].as_array().unwrap().iter().any(|warning| warning.as_str().unwrap().contains(what))
}

#[test]
fn nothing_is_certified_where_told_speeds_are_not_those_of_the_motion() {
    if !sample::is_turn(0, 4) {
        return;
    }
    let dir = tempfile::TempDir::new().unwrap();
    for fmu in sample::some(FMUS, 2) {
        write(dir.path(), "true.toml", &cell_with(fmu, 0, 0, TRUE_SPEED));
        let (code, text, result) = scan(dir.path(), "true.toml", "auto");
        assert!(code == 0 && result["certificate"]["complete"] == true, "{text}");
        assert!(result["speeds"].is_null());
        for (speed, cause) in LIES {
            write(dir.path(), "lie.toml", &cell_with(fmu, 0, 0, speed));
            let (code, text, result) = scan(dir.path(), "lie.toml", "auto");
            assert_eq!(result["certificate"]["complete"], false, "{speed}: {text}");
            // Where it is told too fast there may be hazards that are none.
            let fast = speed.contains("56.2") || speed.contains("= 1 }");
            assert!(code == 4 && result["verdict"] == "inconclusive" || fast && code == 1, "{speed}: {text}");
            assert!(!text.contains("Complete:") && !text.contains("never moved"), "{speed}: {text}");
            assert!(result["speeds"][0]["cause"].as_str().unwrap().contains(cause), "{speed}: {}", result["speeds"]);
            assert!(warned(&result, "is not that of its motion"), "{text}");
        }
    }
    // Two rungs or three in each run, by turns with either version.
    for (fmu, state) in sample::some(STATES.into_iter().flat_map(|state| FMUS.map(|fmu| (fmu, state))), 3) {
        for (speed, _) in [LIES[0], LIES[1], LIES[4]] {
            write(dir.path(), "lie.toml", &cell_with(fmu, 0, 0, speed));
            let (code, text, result) = scan(dir.path(), "lie.toml", state);
            assert!(code == 4 && result["certificate"]["complete"] == false, "{state}: {text}");
            assert_eq!(result["speeds"][0]["steps"], 18, "{state}: all steps but the first and the last: {text}");
        }
        // Put somewhere else in the middle.
        write(dir.path(), "later.toml", &cell_with(fmu, 15, 9, TRUE_SPEED));
        let (code, text, result) = scan(dir.path(), "later.toml", state);
        assert!(code == 4 && result["certificate"]["complete"] == false, "{state}: {text}");
    }
}

#[test]
fn another_joint_s_speed_is_recognised_and_check_names_the_line() {
    let dir = examples();
    let fmus = ["sensor-mat.fmu".to_owned(), test_fmus().join("sensor-mat-fmi3.fmu").display().to_string()];
    for fmu in sample::some(fmus, 2) {
        let folder = dir.path().join("sensor-mat");
        let text = std::fs::read_to_string(folder.join("fixed.toml")).unwrap();
        let text = text.replace("fmu = \"sensor-mat.fmu\"", &format!("fmu = \"{fmu}\""));
        let old = "speed = { variable = \"robot.qd[2]\" }";
        assert_eq!(text.matches(old).count(), 1);
        let line = text[..text.find(old).unwrap()].matches('\n').count() + 1;
        let wrong = text.replace(old, "speed = { variable = \"robot.qd[1]\" }") + "\n[search]\nactions = 3\n";
        write(&folder, "wrong.toml", &wrong);
        let output = fmi_hazard(&folder).args(["check", "wrong.toml"]).output().unwrap();
        let said = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
        assert_eq!(output.status.code(), Some(2), "{said}");
        assert!(said.contains(&format!("wrong.toml:{line}:")) && !said.contains("nothing wrong"), "{said}");
        let output = fmi_hazard(&folder).args(["check", "wrong.toml", "--format", "json"]).output().unwrap();
        let told: Value = serde_json::from_slice(&output.stdout).unwrap();
        assert_eq!((output.status.code(), &told["problems"][0]["line"]), (Some(2), &line.into()), "{told}");
        let help = told["problems"][0]["help"].as_str().unwrap();
        assert!(help.contains("`robot.qd[1]` is how joint `joint_1` moves"), "{told}");
        let (_, text, result) = scan(&folder, "wrong.toml", "auto");
        assert_eq!(result["certificate"]["complete"], false, "{text}");
        assert!(!text.contains("Complete:"), "{text}");
    }
}

#[test]
fn frames_are_compared_too() {
    let dir = examples();
    let folder = dir.path().join("head-collision");
    let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let velocity = "velocity = [\"robot.link[6].vx\", \"robot.link[6].vy\", \"robot.link[6].vz\"]";
    let angular = "angular_velocity = [\"robot.link[4].wx\", \"robot.link[4].wy\", \"robot.link[4].wz\"]";
    for (old, part, new) in [
        (velocity, "frame `joint_6`", velocity.replace("vy", "vz")),
        (angular, "the turning of frame `joint_4`", angular.replace("[4]", "[3]")),
    ] {
        assert_eq!(text.matches(old).count(), 1);
        let said = said(&write(&folder, "wrong.toml", &text.replace(old, &new)));
        assert_eq!(said.records.len(), 1, "{:?}", said.records);
        assert_eq!(said.records[0].part, part);
    }
}

#[test]
fn a_jump_of_the_first_step_is_no_motion_and_a_later_one_is() {
    let dir = tempfile::TempDir::new().unwrap();
    for fmu in sample::some(FMUS, 2) {
        let told = cell_with(fmu, 14, 0, TRUE_SPEED);
        let differentiated = told.replace(&format!("speed = {TRUE_SPEED}\n"), "");
        assert_ne!(told, differentiated);
        for cell in [told, differentiated] {
            write(dir.path(), "jump.toml", &cell);
            let (_, text, result) = scan(dir.path(), "jump.toml", "auto");
            assert_eq!(result["certificate"]["complete"], true, "{text}");
            assert!(warned(&result, "outputs after initialisation are not the robot's pose"), "{text}");
            // 0.8 m of bar and its radius at 0.6 rad/s at most.
            let fastest = result["coverage"]["robot_top_speed_m_s"].as_f64().unwrap();
            assert!(fastest > 0.3 && fastest < 0.6, "{fastest} m/s");
            let output = fmi_hazard(dir.path()).args(["check", "jump.toml"]).output().unwrap();
            assert!(String::from_utf8_lossy(&output.stderr).contains("after initialisation"));
            assert_eq!(output.status.code(), Some(0));
        }
        // Put somewhere else in the middle, and in the very last step.
        for step in [9, 19] {
            write(dir.path(), "later.toml", &cell_with(fmu, 15, step, TRUE_SPEED));
            let (code, text, result) = scan(dir.path(), "later.toml", "auto");
            assert!(code == 4 && result["certificate"]["complete"] == false, "{text}");
            assert_eq!(result["speeds"][0]["steps"], 1, "{text}");
            assert_eq!(result["speeds"][0]["slower_than_it_is"], true);
            let at = result["speeds"][0]["time_s"].as_f64().unwrap();
            assert!((at - 0.02 * f64::from(step + 1)).abs() < 1e-9, "{at} s");
        }
    }
}

#[test]
fn speeds_that_no_robot_has_are_told() {
    let dir = tempfile::TempDir::new().unwrap();
    for fmu in FMUS {
        // A hundred times as fast, by position and speed alike: 80 m/s and more at the end of the bar.
        let fast = cell_with(fmu, 0, 0, "{ variable = \"qd\", plus = { \"qd\" = 199 } }");
        let angle = "angle = { variable = \"q\", unit = \"rad\" }";
        assert!(fast.contains(angle));
        let fast = fast.replace(angle, "angle = { variable = \"q\", plus = { \"q\" = 199 } }");
        write(dir.path(), "fast.toml", &fast);
        let said_of = said(&dir.path().join("fast.toml"));
        assert_eq!(said_of.records, [], "position and speed agree");
        let (_, text, result) = scan(dir.path(), "fast.toml", "auto");
        assert!(warned(&result, "No robot is faster than about 12 m/s"), "{text}");
    }
    let urdf = r#"<robot name="t"><link name="base"/><link name="bar"><inertial><mass value="4"/></inertial><collision>
<origin xyz="0.4 0 0"/><geometry><sphere radius="0.1"/></geometry></collision></link>
<joint name="table" type="continuous"><parent link="base"/><child link="bar"/><axis xyz="0 0 1"/>
<limit effort="1" velocity="LIMIT"/></joint></robot>"#;
    for (limit, told) in [("0.3", true), ("0.58", false), ("0", false), ("inf", false)] {
        write(dir.path(), "robot.urdf", &urdf.replace("LIMIT", limit));
        let cell = cell_with("faulty.fmu", 0, 0, TRUE_SPEED).replace("axis = [0, 0, 1]\n", "");
        let link = cell.find("[[robot.link]]").unwrap()..cell.find("[[sensor]]").unwrap();
        let cell = cell.replace(&cell[link], "").replace("payload_kg = 3", "payload_kg = 3\nurdf = \"robot.urdf\"");
        let warnings = said(&write(dir.path(), "limited.toml", &cell)).warnings;
        assert_eq!(warnings.iter().any(|w| w.contains("its URDF allows 0.30 rad/s")), told, "{limit}: {warnings:?}");
    }
}

#[test]
fn sensors_are_tried_with_people_at_many_places_and_starts_in_a_field_are_told() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let dir = examples();
    let folder = dir.path().join("two-scanners");
    let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let check = |name: &str, text: &str| {
        write(&folder, name, text);
        let output = fmi_hazard(&folder).args(["check", name, "--format", "json"]).output().unwrap();
        let told: Value = serde_json::from_slice(&output.stdout).unwrap();
        (told["warnings"].to_string(), told)
    };
    let (warnings, told) = check("right.toml", &text);
    assert!(!warnings.contains("inside the FMU") && !warnings.contains("starts at"), "{warnings}");
    for sensor in told["probe"]["reported"].as_array().unwrap() {
        assert!(sensor["at"].as_u64().unwrap() > 0 && sensor["far_away"] == false, "{told}");
    }
    let wrong = text.replacen("active = true", "active = false", 1);
    let (warnings, _) = check("wrong.toml", &wrong);
    assert!(
        warnings.contains("reports a person who is 20 m away") && warnings.contains("flaw of the cell"),
        "{warnings}"
    );
    // Feet that the FMU is never told of.
    let feet = text.find("left_foot_x = ").unwrap()..text.find("[human]").unwrap();
    let lost = text.replace(&text[feet], "x = \"human.left_foot.x\"\n");
    let (warnings, _) = check("lost.toml", &lost);
    assert!(warnings.contains("never fired"), "{warnings}");
    let folder = dir.path().join("sensor-mat");
    let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let start = text.find("start = { xy_m = ").unwrap();
    let end = start + text[start..].find('\n').unwrap();
    let on_mat = text.replace(&text[start..end], "start = { xy_m = [0, -0.5], heading_deg = 90 }");
    write(&folder, "inside.toml", &on_mat);
    for arguments in [
        &["check"][..],
        &["inspect", "--run"],
        &["scan", "--no-advice", "--iterations", "2", "--strategy", "random", "--out", "o"],
    ] {
        let output = fmi_hazard(&folder).args(arguments).arg("inside.toml").output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(said.contains("the person starts at (0.00, -0.50) m where"), "{arguments:?}: {said}");
    }
}
