//! Doors and two-hand controls: each against a light curtain or a mat that must come to the same.

use std::path::Path;

use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;
use serde_json::Value;

/// The sensor of the example `light-curtain`.
const CURTAIN: &str = r#"kind = "light_curtain"
zone = { line_m = [[-0.5, 0], [0.5, 0]], heights_m = [0, 1.8] }"#;

/// The example with another sensor, other changes, and fewer actions.
fn cell(dir: &Path, kind: &str, zone: &str, changes: &[(&str, &str)]) -> String {
    let text = std::fs::read_to_string(dir.join("light-curtain/cell.toml")).unwrap();
    let sensor = format!("kind = \"{kind}\"\nzone = {zone}");
    changes.iter().chain([&(CURTAIN, sensor.as_str())]).fold(text, |text, (old, new)| {
        assert_eq!(text.matches(old).count(), 1, "{old}");
        text.replace(old, new)
    })
}

/// Hazards of every sequence of so many actions.
fn hazards(dir: &Path, name: &str, cell: &str, actions: usize) -> Vec<Value> {
    let text = format!("{cell}\n[search]\nactions = {actions}\n");
    let path = write(dir, &format!("light-curtain/{name}.toml"), &text);
    let out = dir.join(name);
    let mut scan = fmi_hazard(dir);
    scan.args(["scan", "--no-advice", "--strategy", "exhaustive", "--out"]).arg(&out).arg(path);
    scan.assert().code(1);
    scan_json(&out)["hazards"].as_array().unwrap().clone()
}

const START: &str = "start = { xy_m = [0.1, -1], heading_deg = 90 }";

#[test]
fn a_door_tells_of_what_a_light_curtain_in_its_place_does() {
    if !sample::is_turn(1, 2) {
        return;
    }
    let dir = examples();
    let zone = "{ line_m = [[-0.5, 0], [0.5, 0]], heights_m = [0, 1.8] }";
    let [curtain, door] = ["light_curtain", "interlocked_door"]
        .map(|kind| hazards(dir.path(), kind, &cell(dir.path(), kind, zone, &[]), 3));
    assert!(curtain.iter().any(|hazard| hazard["through_curtain"].is_string()));
    assert_eq!(curtain, door);
}

#[test]
fn hands_that_let_go_are_as_far_as_those_that_break_a_light_curtain() {
    let dir = examples();
    // No body gets through the plane, because a low wall stops it; hands get over that. Nobody leans, which alone a
    // two-hand control would not notice.
    let person = "start = { xy_m = [0.1, -0.3], heading_deg = 90 }\nbend_forward_deg = 0\nbend_lateral_deg = 0\n\
                  [[obstacle]]\nname = \"kerb\"\ncentre_m = [0, -0.1, 0.2]\nsize_m = [8, 0.02, 0.4]";
    let changes = [(START, person), ("xyz_m = [0, 1.55, 0.275]", "xyz_m = [0, 1.4, 0.275]")];
    let wide = "{ line_m = [[-3.5, 0], [3.5, 0]], heights_m = [0, 6] }";
    let post = "{ polygon_m = [[-9, -9], [9, -9], [9, -0.05], [-9, -0.05]], line_m = [[-0.5, 0], [0.5, 0]] }";
    let curtain = hazards(dir.path(), "wide", &cell(dir.path(), "light_curtain", wide, &changes), 3);
    let control = hazards(dir.path(), "held", &cell(dir.path(), "two_hand_control", post, &changes), 3);
    assert!(!curtain.is_empty() && curtain.iter().all(|hazard| hazard["through_curtain"].is_string()));
    assert_eq!(curtain, control);
}

#[test]
fn who_leaves_the_post_is_seen_as_by_a_mat_around_it() {
    let dir = examples();
    let changes = [(START, "start = { xy_m = [0.1, -0.3], heading_deg = 90 }")];
    // The buttons are behind the operator: they keep no hand from the robot.
    let post = "{ polygon_m = [[-0.2, -0.6], [0.4, -0.6], [0.4, 0], [-0.2, 0]], line_m = [[-1, -5], [1, -5]] }";
    // All of the floor but the post, with a slit to it.
    let around = "{ polygon_m = [[-9, -9], [9, -9], [9, 9], [-9, 9], [-9, 0], [-0.2, 0], [0.4, 0], [0.4, -0.6], \
                  [-0.2, -0.6], [-0.2, 0], [-9, 0]] }";
    let control = hazards(dir.path(), "post", &cell(dir.path(), "two_hand_control", post, &changes), 3);
    let mat = hazards(dir.path(), "mat", &cell(dir.path(), "mat", around, &changes), 3);
    let reported = |hazard: &Value| hazard["sensors"][0]["person_detected"] == true;
    assert!(control.iter().any(reported) && !control.iter().all(reported));
    assert_eq!(control, mat);
}

#[test]
fn hands_on_a_two_hand_control_are_hit_by_nothing_behind_it() {
    if !sample::is_turn(0, 2) {
        return;
    }
    let dir = examples();
    let changes = [(START, "start = { xy_m = [0.1, -0.3], heading_deg = 90 }")];
    let post = "{ polygon_m = [[-0.2, -0.6], [0.4, -0.6], [0.4, 0], [-0.2, 0]], line_m = [[-0.5, 0.05], [0.5, 0.05]] }";
    let found = hazards(dir.path(), "operator", &cell(dir.path(), "two_hand_control", post, &changes), 2);
    let held = |hazard: &&Value| hazard["sensors"][0]["person_detected"] == false;
    let deep = |hazard: &&Value| hazard["contact_point_m"][1].as_f64() > Some(0.05 + 0.1);
    // Whoever leans over the buttons still holds them.
    let leaning = |hazard: &&Value| hazard["body_region"] == "skull_forehead" && held(hazard) && deep(hazard);
    assert!(found.iter().any(|hazard| leaning(&hazard)));
    let of_an_arm = |hazard: &&Value| !hazard["arm"].is_null();
    assert!(found.iter().filter(of_an_arm).any(|hazard| hazard["through_curtain"].is_string()));
    let not_let_go = |hazard: &&Value| hazard["through_curtain"].is_null();
    assert!(!found.iter().filter(of_an_arm).filter(not_let_go).any(|hazard| held(&hazard) && deep(&hazard)));
}

/// What happens, whatever the sensors are.
fn events(hazards: &[Value]) -> Vec<String> {
    let of = |hazard: &Value| {
        let [region, link, force, time] = ["body_region", "robot_link", "force_n", "time_s"].map(|key| &hazard[key]);
        format!("{region} {link} {force} {time} {}", hazard["contact_point_m"])
    };
    let mut events: Vec<String> = hazards.iter().map(of).collect();
    events.sort();
    events.dedup();
    events
}

#[test]
fn a_control_that_somebody_else_left_long_ago_holds_nobody_back() {
    let dir = examples();
    let near = [(START, "start = { xy_m = [0.1, -0.3], heading_deg = 90 }"), ("xyz_m = [0, 1.55", "xyz_m = [0, 1.4")];
    // No sensor at all; and a control far away, of which the person stands behind the line, that changes nothing.
    let whole = |variable: &str, kind: &str, zone: &str| {
        cell(dir.path(), kind, zone, &near)
            .replace("variable = \"plc.curtain_clear\"", &format!("variable = \"{variable}\""))
    };
    let away = "{ polygon_m = [[-1, -9], [1, -9], [1, -8], [-1, -8]], line_m = [[-1, -4], [1, -4]] }";
    let control = whole("plc.reset", "two_hand_control", away)
        .replace("active = false", "active = false # pressed is held")
        .replace("\"plc.reset\" = false", "\"plc.curtain_clear\" = true");
    let nowhere = "{ polygon_m = [[-9, -9], [-8, -9], [-8, -8]] }";
    let none = whole("plc.reset", "mat", nowhere)
        .replace("active = false", "active = true")
        .replace("\"plc.reset\" = false", "\"plc.curtain_clear\" = true");
    let [control, none] = [("away", control), ("none", none)].map(|(name, cell)| hazards(dir.path(), name, &cell, 2));
    assert!(none.iter().any(|hazard| !hazard["arm"].is_null() && hazard["time_s"].as_f64() < Some(0.3)));
    assert_eq!(events(&control), events(&none));
}

#[test]
fn three_planes_are_warned_of() {
    let dir = examples();
    let door = |name: &str, y: f64| {
        format!(
            "[[sensor]]\nname = \"{name}\"\nkind = \"interlocked_door\"\nzone = {{ line_m = [[-0.5, {y}], [0.5, {y}]], \
             heights_m = [0, 2] }}\nvariable = \"plc.curtain_clear\"\nactive = false\n"
        )
    };
    let more = format!("{}{}[inputs]", door("door", 1.0), door("gate", 2.0));
    let text = std::fs::read_to_string(dir.path().join("light-curtain/cell.toml")).unwrap().replace("[inputs]", &more);
    write(dir.path(), "light-curtain/three.toml", &text);
    let output =
        fmi_hazard(dir.path()).args(["check", "light-curtain/three.toml"]).assert().code(0).get_output().clone();
    let text = String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(text.contains("arms that reach through three of curtain, door, gate at once are not looked for"), "{text}");
}
