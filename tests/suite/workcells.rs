//! The six cells of the paper: the flaw that is found is the one the scenario's README names, the repaired cells have
//! none, and FMI 2.0, FMI 3.0 and coupled FMUs give the same.

use std::collections::BTreeSet;
use std::path::Path;
use std::sync::Arc;

use crate::common::{examples, fmi_hazard, scan_json, test_fmus};
use crate::sample;
use fmi_hazard::geometry::Solid;
use fmi_hazard::host::Plant as _;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::sim::World;
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::standards::BodyRegion;
use serde_json::Value;

/// What the README of a scenario says of its flaw.
struct Flaw {
    cell: &'static str,
    /// Seed and budget of a search that meets it.
    seed: &'static str,
    iterations: &'static str,
    regions: &'static [&'static str],
    links: &'static [&'static str],
    /// Sensor states at the contact.
    sensors: &'static [(&'static str, bool)],
    /// Where the person stands: x from and to, y from and to, m.
    place: [f64; 4],
}

const FLAWS: [Flaw; 6] = [
    Flaw {
        cell: "safety-fence",
        seed: "1",
        iterations: "120",
        regions: &["hand", "lower_arm", "upper_arm"],
        links: &["gripper", "tool", "wrist", "forearm"],
        sensors: &[],
        place: [-0.9, 1.2, -0.95, -0.1],
    },
    Flaw {
        cell: "sensor-mat",
        seed: "1",
        iterations: "320",
        regions: &["hand", "lower_arm", "upper_arm"],
        links: &["gripper", "tool", "wrist", "flange", "forearm"],
        sensors: &[],
        place: [-1.7, -0.8, -1.1, 0.0],
    },
    Flaw {
        cell: "head-collision",
        seed: "1",
        iterations: "200",
        regions: &["skull_forehead", "face", "neck_front"],
        links: &["gripper", "tool", "wrist_1", "wrist_2", "forearm", "elbow"],
        sensors: &[("field", true)],
        place: [-0.6, 1.0, -0.7, -0.1],
    },
    Flaw {
        cell: "light-curtain",
        seed: "1",
        iterations: "60",
        regions: &["hand", "lower_arm", "upper_arm", "chest", "back_shoulders", "face", "skull_forehead", "neck_front"],
        links: &["gripper", "tool", "wrist", "forearm"],
        sensors: &[("curtain", true)],
        place: [-0.5, 0.85, -0.8, 0.3],
    },
    Flaw {
        cell: "two-scanners",
        seed: "1",
        iterations: "320",
        regions: &["hand", "lower_arm", "upper_arm"],
        links: &["robot B gripper", "robot B tool", "robot B wrist", "robot B forearm"],
        sensors: &[("field A", true), ("field B", false)],
        place: [-0.9, 0.4, -1.0, -0.1],
    },
    Flaw {
        cell: "heavy-workpiece",
        seed: "1",
        iterations: "120",
        regions: &["chest", "thigh"],
        links: &["workpiece", "wrist_1", "wrist_2", "tool", "forearm"],
        sensors: &[],
        place: [0.2, 0.8, -1.0, -0.1],
    },
];

fn scan(dir: &Path, cell: &str, arguments: &[&str]) -> Value {
    let out = format!("out-{}", cell.replace(['/', '.'], "-"));
    let _ = fmi_hazard(dir).args(["scan", "--no-advice", cell, "--out", &out]).args(arguments).output().unwrap();
    scan_json(&dir.join(out))
}

#[test]
fn each_flaw_is_the_one_its_readme_names() {
    let dir = examples();
    for flaw in sample::some(FLAWS, 3) {
        let cell = format!("{}/cell.toml", flaw.cell);
        let result =
            scan(dir.path(), &cell, &["--strategy", "mcts-dpw", "--seed", flaw.seed, "--iterations", flaw.iterations]);
        let hazards = result["hazards"].as_array().unwrap();
        assert!(!hazards.is_empty(), "{}: nothing found", flaw.cell);
        let mut as_named = 0;
        for hazard in hazards {
            let text = |key: &str| hazard[key].as_str().unwrap();
            assert_eq!(hazard["confirmed"], true, "{hazard}");
            assert!(flaw.regions.contains(&text("body_region")), "{}: {hazard}", flaw.cell);
            assert!(flaw.links.contains(&text("robot_link")), "{}: {hazard}", flaw.cell);
            let states = hazard["sensors"].as_array().unwrap();
            let seen = |name: &str| states.iter().find(|s| s["name"] == name).unwrap()["person_detected"] == true;
            as_named += usize::from(flaw.sensors.iter().all(|(name, on)| seen(name) == *on));
            let [x, y] = [0, 1].map(|i| hazard["person_xy_m"][i].as_f64().unwrap());
            let [left, right, front, back] = flaw.place;
            assert!(left <= x && x <= right && front <= y && y <= back, "{}: ({x}, {y}) {hazard}", flaw.cell);
        }
        // A foot that has just crossed to the next field is reported there while the robot still stops.
        assert!(2 * as_named > hazards.len(), "{}: {as_named} of {}", flaw.cell, hazards.len());
    }
}

#[test]
fn the_repaired_cells_have_no_hazard_and_the_search_really_tried() {
    let dir = examples();
    for (number, flaw) in FLAWS.iter().enumerate() {
        let searches = [("1", "mcts-dpw"), ("2", "random")].into_iter().enumerate();
        for (_, (seed, strategy)) in searches.filter(|(search, _)| sample::takes(2 * search + number, 4)) {
            let cell = format!("{}/fixed.toml", flaw.cell);
            let result = scan(dir.path(), &cell, &["--seed", seed, "--strategy", strategy, "--iterations", "60"]);
            assert_eq!(result["hazards"], serde_json::json!([]), "{} {strategy}", flaw.cell);
            let coverage = &result["coverage"];
            assert!(coverage["robot_top_speed_m_s"].as_f64().unwrap() > 0.14, "{}: {coverage}", flaw.cell);
            assert!(coverage["contact_checks"].as_u64().unwrap() > 1000, "{}: {coverage}", flaw.cell);
            let fired = coverage["sensor_actions"].as_array().unwrap();
            assert!(fired.iter().all(|n| n.as_u64().unwrap() > 0), "{}: a sensor never fired: {coverage}", flaw.cell);
        }
    }
}

/// The limit of the repaired heavy-workpiece holds for the whole cycle, not for the paper's start alone: no point of the
/// robot is ever fast enough to harm anything but a head or a throat, which are above it.
#[test]
fn the_repaired_speed_limit_harms_nobody_at_any_time() {
    let dir = examples();
    let prepared = prepare(&dir.path().join("heavy-workpiece/fixed.toml"), None).unwrap();
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let inputs = World::new(Arc::clone(cell), Arc::clone(binding)).initial_inputs();
    // Two cycles of 14.5 s.
    let steps = 1450;
    let mut plant = prepared.plant(StateChoice::Replay);
    plant.restart().unwrap();
    let rows = plant.advance(steps, &inputs.repeat(steps)).unwrap();
    let (mut phases, mut worst) = (BTreeSet::new(), 0.0_f64);
    for row in rows.chunks(binding.outputs.len()) {
        let frame = RobotFrame::new(cell, binding, row);
        phases.insert(frame.phase(0));
        for (link, solid) in frame.links.iter().enumerate() {
            let may_be_hit = |region: &BodyRegion| !region.permits_no_contact() && *region != BodyRegion::LowerLeg;
            for region in BodyRegion::ALL.into_iter().filter(may_be_hit) {
                worst = worst.max(frame.ratio(region, link, frame.speed_bounds[link]));
            }
            // Lower legs end at 0.55 m, and the throat of somebody who bends forward and sideways is 1.17 m above the floor.
            let Solid::Capsule(c) = solid else { unreachable!("the cell has capsules") };
            let (bottom, top) = (c.a.z.min(c.b.z) - c.radius, c.a.z.max(c.b.z) + c.radius);
            assert!(bottom > 0.55 && top < 1.17, "link {link} from {bottom} to {top} m");
        }
    }
    assert_eq!(phases.len(), 5, "{phases:?}");
    assert!(worst < 1.0 && worst > 0.8, "{worst}");
}

/// Arms are posed at once; what keeps the repaired curtain from looking unsafe is that a hand behind it must have broken
/// it long enough before. From the curtain's edge arms could be at the robot from the first instant on.
#[test]
fn a_hand_does_not_get_through_the_repaired_light_curtain_in_no_time() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let dir = examples();
    let fixed = std::fs::read_to_string(dir.path().join("light-curtain/fixed.toml")).unwrap();
    let near = fixed.replace("xy_m = [0.1, -1]", "xy_m = [-0.2, -0.35]");
    assert_ne!(near, fixed);
    std::fs::write(dir.path().join("light-curtain/near.toml"), near).unwrap();
    for strategy in ["mcts-dpw", "random"] {
        let arguments = ["--strategy", strategy, "--iterations", "80"];
        let result = scan(dir.path(), "light-curtain/near.toml", &arguments);
        assert_eq!(result["hazards"], serde_json::json!([]), "{strategy}");
        assert_eq!(result["coverage"]["arm_checks_incomplete"], 0, "{}", result["coverage"]);
        assert!(
            result["coverage"]["checks_with_robot_in_arm_reach"].as_u64().unwrap() > 1000,
            "{}",
            result["coverage"]
        );
    }
}

#[test]
fn fmi_2_and_fmi_3_give_the_same_bytes() {
    let dir = examples();
    for flaw in sample::some(&FLAWS, 6) {
        let run = |version: &str| {
            let fmu = format!("{0}/{0}{version}.fmu", flaw.cell);
            let cell = format!("{}/cell.toml", flaw.cell);
            let arguments = ["--cell", &cell, "--strategy", "mcts-dpw", "--iterations", "25", "--seed", "3"];
            let mut result = scan(dir.path(), &fmu, &arguments);
            let version = result["subject"]["fmus"][0]["fmi_version"].clone();
            result.as_object_mut().unwrap().remove("subject");
            (version, serde_json::to_string(&result).unwrap())
        };
        let ((two, first), (three, second)) = (run(""), run("-fmi3"));
        assert_eq!((two, three), ("2.0".into(), "3.0".into()));
        assert!(first == second, "{} differs between FMI 2.0 and FMI 3.0", flaw.cell);
    }
}

#[test]
fn three_coupled_fmus_find_what_the_one_finds_in_both_versions() {
    if !sample::is_turn(4, 6) {
        return;
    }
    let dir = examples();
    let path = dir.path().join("sensor-mat/coupled.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    std::fs::write(dir.path().join("sensor-mat/coupled3.toml"), text.replace(".fmu", "-fmi3.fmu")).unwrap();
    let text = std::fs::read_to_string(dir.path().join("sensor-mat/cell.toml")).unwrap();
    std::fs::write(dir.path().join("sensor-mat/one.toml"), text.replace("step_s = 0.02", "step_s = 0.01")).unwrap();
    let of = |file: &str| {
        let iterations = if sample::is_whole() { "150" } else { "75" };
        let arguments = ["--seed", "5", "--iterations", iterations, "--strategy", "random"];
        let result = scan(dir.path(), &format!("sensor-mat/{file}"), &arguments);
        let mut hazards = result["hazards"].as_array().unwrap().clone();
        // Two of equal force may change places over the last bit.
        hazards.sort_by_key(|h| h["id"].as_str().unwrap().to_owned());
        (result["subject"].clone(), hazards)
    };
    let ((_, one), (subject, coupled), (_, coupled3)) = (of("one.toml"), of("coupled.toml"), of("coupled3.toml"));
    assert_eq!(coupled, coupled3);
    let names: Vec<&str> = subject["fmus"].as_array().unwrap().iter().map(|f| f["unit"].as_str().unwrap()).collect();
    assert_eq!(names, ["plc", "controller", "kinematics"]);
    assert!(subject["couplings"][0].as_str().unwrap().contains("plc:stop -> controller:stop: 10 ms later"));
    assert!(!one.is_empty() && one.len() == coupled.len(), "{one:?}\n{coupled:?}");
    for (a, b) in one.iter().zip(&coupled) {
        // The kinematics start Newton's method elsewhere, so the last bits differ.
        assert_eq!((&a["id"], &a["actions"], &a["time_s"]), (&b["id"], &b["actions"], &b["time_s"]));
        assert!((a["force_n"].as_f64().unwrap() - b["force_n"].as_f64().unwrap()).abs() < 1e-6, "{a} {b}");
    }
}

#[test]
fn fmus_that_break_promises_about_states_give_the_same_hazards() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let dir = examples();
    for cell in sample::some(["safety-fence", "sensor-mat"], 2) {
        let file = format!("{cell}/cell.toml");
        let arguments = ["--cell", &file, "--seed", "2", "--iterations", "30", "--strategy", "random"];
        let mut results = Vec::new();
        for (number, ending) in ["", "-nostate", "-idlereset", "-forgets"].into_iter().enumerate() {
            let versions = ["", "-fmi3"].into_iter().enumerate();
            for (_, version) in versions.filter(|(version, _)| sample::takes(version + number, 2)) {
                let name = format!("{cell}{ending}{version}.fmu");
                std::fs::copy(test_fmus().join(&name), dir.path().join(&name)).unwrap();
                let result = scan(dir.path(), &name, &arguments);
                let restore = result["self_test"]["restore"]["result"].as_str().unwrap().to_owned();
                let expected = match ending {
                    "-nostate" => "not_offered",
                    "-forgets" => "differs",
                    _ => "exact",
                };
                assert_eq!(restore, expected, "{name}");
                let reset = if ending == "-idlereset" { "differs" } else { "exact" };
                assert_eq!(result["self_test"]["reset"]["result"], reset, "{name}");
                results.push((result["hazards"].clone(), result["coverage"].clone()));
            }
        }
        assert!(results.iter().all(|r| *r == results[0]), "{cell}");
    }
}

#[test]
fn an_fmu_for_one_instance_in_a_process_gives_the_same_hazards() {
    let dir = examples();
    std::fs::copy(test_fmus().join("sensor-mat-once.fmu"), dir.path().join("once.fmu")).unwrap();
    let scan = |fmu: &str, extra: &[&str]| {
        let arguments = [
            "scan",
            "--no-advice",
            fmu,
            "--cell",
            "sensor-mat/cell.toml",
            "--strategy",
            "hybrid",
            "--iterations",
            "15",
        ];
        let output = fmi_hazard(dir.path()).args(arguments).args(["--out", "o"]).args(extra).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    // In one process it can be made once only, and says so.
    let (code, text) = scan("once.fmu", &["--in-process"]);
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(code == Some(3) && text.contains("one instance in a process"), "{code:?} {text}");
    let (code, text) = scan("once.fmu", &[]);
    assert!(code == Some(1) && text.contains("runs once in a process"), "{code:?} {text}");
    let once = scan_json(&dir.path().join("o"));
    assert_eq!(scan("sensor-mat/sensor-mat.fmu", &[]).0, Some(1));
    let usual = scan_json(&dir.path().join("o"));
    assert_eq!(once["hazards"], usual["hazards"]);
    assert_eq!(once["coverage"], usual["coverage"]);
}

#[test]
fn the_papers_table_does_not_depend_on_the_number_of_workers() {
    let dir = tempfile::TempDir::new().unwrap();
    let run = |workers: &str, format: &str| {
        let arguments =
            ["bench", "paper", "--seeds", "2", "--iterations", "6", "--workers", workers, "--format", format];
        String::from_utf8(fmi_hazard(dir.path()).args(arguments).assert().code(0).get_output().stdout.clone()).unwrap()
    };
    assert_eq!(run("1", "json"), run("3", "json"));
    let (csv, markdown) = (run("2", "csv"), run("2", "md"));
    // A header and two strategies for each of six cells.
    assert_eq!((csv.lines().count(), markdown.lines().count()), (13, 14));
    assert!(csv.lines().all(|line| line.split(',').count() == 18), "{csv}");
    assert!(markdown.contains("heavy-workpiece") && markdown.contains("71.1"), "{markdown}");
}
