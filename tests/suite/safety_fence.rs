//! Scenario 1: the flaw is found and is the right one; the repaired cell has none, and the search really tried.

use std::path::Path;

use fmi_hazard::scan::StateChoice;
use serde_json::json;

use crate::common::started::Started;
use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;

/// The search for changes, which comes after it, is ended.
#[test]
fn an_example_that_is_run_ends_with_a_confirmed_hazard_and_exit_code_1() {
    let dir = tempfile::TempDir::new().unwrap();
    let run = Started::until(dir.path(), &["examples", "run"], "Looking for changes");
    run.signal("-INT");
    let (code, text) = run.end();
    assert_eq!(code, Some(1), "{text}");
    the_planted_flaw_is_found(dir.path(), &text);
}

#[test]
#[ignore = "half a minute: its search for changes; `an_example_that_is_run_ends_with_a_confirmed_hazard_and_exit_code_1` ends it"]
fn an_example_that_is_run_looks_for_changes_too() {
    let dir = tempfile::TempDir::new().unwrap();
    let said = fmi_hazard(dir.path()).args(["examples", "run"]).assert().code(1).get_output().stdout.clone();
    the_planted_flaw_is_found(dir.path(), &String::from_utf8(said).unwrap());
    let scan = scan_json(&dir.path().join("out/examples/safety-fence"));
    assert!(!scan["causes"][0]["advice"].is_null(), "{}", scan["causes"]);
}

/// What it says and leaves behind below this folder.
fn the_planted_flaw_is_found(dir: &Path, text: &str) {
    assert!(text.contains("confirmed by a fresh replay") && text.contains("not proof of safety"), "{text}");
    let out = dir.join("out/examples/safety-fence");
    let scan = scan_json(&out);
    let worst = &scan["hazards"][0];
    // The planted flaw: an arm through the opening (z 0.80 to 1.20 at y = 0) meets the fast leg of the tool.
    assert_eq!(worst["confirmed"], true);
    assert!(["hand", "lower_arm", "upper_arm"].contains(&worst["body_region"].as_str().unwrap()), "{worst}");
    assert!(["gripper", "tool", "wrist", "forearm"].contains(&worst["robot_link"].as_str().unwrap()), "{worst}");
    assert!(worst["ratio"].as_f64().unwrap() > 1.0);
    let arm = &worst["arm"];
    let at = |joint: &str, axis: usize| arm[joint][axis].as_f64().unwrap();
    assert!(at("shoulder_m", 1) < 0.0, "the person stays outside: {arm}");
    let reached = worst["contact_point_m"][1].as_f64().unwrap();
    assert!(reached > 0.0, "the contact is inside: {worst}");
    assert!(out.join(format!("{}.svg", worst["id"].as_str().unwrap())).is_file());
    let lines = std::fs::read_to_string(out.join("hazards.jsonl")).unwrap();
    assert_eq!(lines.lines().count(), scan["hazards"].as_array().unwrap().len());
}

/// The cell file's kinematic chain against the programme that the FMU was written to: scenarios.md, S1.
#[test]
fn the_gripper_follows_the_programme_of_the_scenario() {
    use fmi_hazard::geometry::{Solid, Vec3};
    use fmi_hazard::host::Plant as _;
    use fmi_hazard::sim::robot::RobotFrame;

    let dir = examples();
    let cell = fmi_hazard::scan::prepare::prepare(&dir.path().join("safety-fence/cell.toml"), None).unwrap();
    let mut plant = cell.plant(StateChoice::Auto);
    let mut rows = plant.restart().unwrap();
    let steps = 100;
    rows.extend(plant.advance(steps, &cell.binding.constants.repeat(steps)).unwrap());
    let corners = [[0.0, 0.45, 0.95], [0.0, 0.45, 1.05], [0.6, 0.85, 1.05], [0.6, 0.85, 0.95]].map(Vec3::from_array);
    let mut reached = [f64::MAX; 4];
    let mut fastest: f64 = 0.0;
    let gripper = cell.cell.links.iter().position(|l| l.name == "gripper").unwrap();
    for row in rows.chunks(cell.binding.outputs.len()) {
        let frame = RobotFrame::new(&cell.cell, &cell.binding, row);
        let Solid::Capsule(tool) = &frame.links[gripper] else { panic!("the gripper is a sphere") };
        let off_path = corners.windows(2).map(|leg| {
            let (a, b) = (leg[0], leg[1]);
            let t = ((tool.a - a).dot(b - a) / (b - a).length_squared()).clamp(0.0, 1.0);
            (tool.a - (a + (b - a) * t)).length()
        });
        assert!(off_path.fold(f64::MAX, f64::min) < 1e-9, "off the path at {}", tool.a);
        reached.iter_mut().zip(corners).for_each(|(r, c)| *r = r.min((tool.a - c).length()));
        fastest = fastest.max(frame.velocity(gripper, tool.a).length());
    }
    assert!(reached.iter().all(|r| *r < 0.01), "{reached:?}");
    assert!((fastest - 2.0).abs() < 1e-6, "{fastest}");
}

#[test]
fn an_fmu_alone_carries_its_cell() {
    let dir = examples();
    let alone = dir.path().join("alone.fmu");
    std::fs::copy(dir.path().join("safety-fence/safety-fence.fmu"), &alone).unwrap();
    let args = ["scan", "--no-advice", "alone.fmu", "--stop-at", "first", "--out", "o", "--format", "json"];
    let output = fmi_hazard(dir.path()).args(args).assert().code(1).get_output().clone();
    let scan: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(scan, scan_json(&dir.path().join("o")));
    assert!(scan["subject"]["cell_found"].as_str().unwrap().contains("extra/"), "{}", scan["subject"]);
}

#[test]
fn the_repaired_cell_has_no_hazard_in_ten_seeds_and_the_search_really_tried() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let dir = examples();
    let mut near = f64::MAX;
    for seed in 1..=10 {
        let seed = seed.to_string();
        let args =
            ["scan", "--no-advice", "safety-fence/fixed.toml", "--strategy", "mcts-dpw", "--seed", &seed, "--out", "o"];
        // Samples show nothing of the other sequences.
        fmi_hazard(dir.path()).args(args).assert().code(4);
        let scan = scan_json(&dir.path().join("o"));
        let coverage = &scan["coverage"];
        assert_eq!((&scan["verdict"], &scan["hazards"]), (&"inconclusive".into(), &json!([])));
        assert_eq!(coverage["episodes_not_evaluated"], 0);
        assert!(coverage["robot_top_speed_m_s"].as_f64().unwrap() > 1.9, "{coverage}");
        assert!(coverage["walks_blocked"].as_u64().unwrap() > 10, "{coverage}");
        near = near.min(coverage["closest_approach_m"].as_f64().unwrap());
    }
    assert!(near < 1.2, "the person never came close: {near} m");
}

#[test]
fn starts_right_at_the_repaired_slot_find_nothing_either() {
    if !sample::is_turn(2, 4) {
        return;
    }
    let dir = examples();
    let fixed = std::fs::read_to_string(dir.path().join("safety-fence/fixed.toml")).unwrap();
    for start in ["xy_m = [0.45, -0.70]", "xy_m = [0.0, -0.75]"] {
        let text = fixed.replace("xy_m = [1.05, -1.7]", start);
        assert_ne!(text, fixed);
        std::fs::write(dir.path().join("safety-fence/near.toml"), text).unwrap();
        for strategy in ["mcts-dpw", "random"] {
            let args = ["scan", "--no-advice", "safety-fence/near.toml", "--strategy", strategy, "--out", "o"];
            fmi_hazard(dir.path()).args(args).assert().code(4);
        }
    }
}
