//! `fmi-hazard distance` on the example cells: the stop time is that of `probe`, the distance agrees with what is known of the cells,
//! S and the margin with a calculation by hand.

use std::path::Path;

use serde_json::Value;

use crate::common::{examples, fmi_hazard, write};
use crate::sample;

/// What it says, and its exit code.
fn distance(dir: &Path, cell: &str, more: &[&str]) -> (Value, Option<i32>) {
    let output = fmi_hazard(dir).args(["distance", cell, "--format", "json"]).args(more).output().unwrap();
    let said = serde_json::from_slice(&output.stdout);
    (said.unwrap_or_else(|_| panic!("{}", String::from_utf8_lossy(&output.stderr))), output.status.code())
}

/// The longest time to standstill that `probe` tells of the first sensor, s.
fn probed_s(dir: &Path, cell: &str) -> f64 {
    let output = fmi_hazard(dir).args(["inspect", "--run", cell, "--format", "json"]).output().unwrap();
    let probe: Value = serde_json::from_slice(&output.stdout).unwrap();
    let first = &probe["reactions"][0];
    let others = first["at_other_moments"].as_array().unwrap().iter();
    others.chain([first]).map(|moment| moment["still_after_s"].as_f64().unwrap()).fold(0.0, f64::max)
}

/// A way past the first safeguard: S, where it stands, and the margin, mm.
fn way(said: &Value, how: &str) -> [i64; 3] {
    let ways = said["safeguards"][0]["ways"].as_array().unwrap();
    let way = ways.iter().find(|way| way["how"] == how).unwrap_or_else(|| panic!("{ways:?}"));
    ["s_mm", "stands_mm", "margin_mm"].map(|key| way[key].as_i64().unwrap())
}

/// An example with a text in it replaced.
fn changed(dir: &Path, cell: &str, name: &str, changes: &[(&str, &str)]) -> String {
    let text = std::fs::read_to_string(dir.join(cell)).unwrap();
    let text = changes.iter().fold(text, |text, (old, new)| {
        assert_eq!(text.matches(old).count(), 1, "{old}");
        text.replace(old, new)
    });
    let folder = Path::new(cell).parent().unwrap();
    write(dir, folder.join(name).to_str().unwrap(), &text);
    folder.join(name).to_str().unwrap().to_owned()
}

#[test]
fn stop_times_are_those_of_probe() {
    if !sample::is_turn(0, 4) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let cells = [
        ("sensor-mat/cell.toml", 0.36),
        ("sensor-mat/fixed.toml", 0.36),
        ("light-curtain/cell.toml", 0.46),
        ("light-curtain/fixed.toml", 0.46),
        ("head-collision/fixed.toml", 0.62),
    ];
    for (cell, stop_s) in sample::some(cells, 2) {
        let (said, _) = distance(dir, cell, &[]);
        let own = said["safeguards"][0]["stop_s"].as_f64().unwrap();
        assert!((own - probed_s(dir, cell)).abs() < 1e-12 && (own - stop_s).abs() < 1e-9, "{cell}: {own}");
    }
    // The response time of the sensor comes on top of it, in whole steps.
    let slow =
        changed(dir, "sensor-mat/fixed.toml", "slow.toml", &[("active = false", "active = false\ndelay_ms = 30")]);
    let (said, _) = distance(dir, &slow, &["--edition", "2010"]);
    assert!((said["safeguards"][0]["t_s"].as_f64().unwrap() - 0.40).abs() < 1e-9, "{said}");
    // 1600 x 0.40 + 1200.
    assert_eq!(way(&said, "into it")[0], 1840);
}

#[test]
fn a_mat_is_measured_from_where_people_step_onto_it() {
    let dir = examples();
    let dir = dir.path();
    // 1600 mm/s x 0.36 s + 1200 mm = 1776 mm in both editions.
    for edition in ["2010", "2024"] {
        let (said, code) = distance(dir, "sensor-mat/fixed.toml", &["--edition", edition]);
        let [s, stands, margin] = way(&said, "into it");
        assert_eq!((s, margin, code), (1776, stands - 1776, Some(0)));
        // The fences close both sides and the back, so its front edge counts, at y = -1.8.
        let edge = &said["safeguards"][0]["ways"][0]["edge_m"];
        assert!((edge[1].as_f64().unwrap() + 1.8).abs() < 1e-6, "{edge}");
        // An edge 0.2 m nearer is 200 mm nearer, and too near by what is left.
        let polygon = ("[[-1, -1.8], [1, -1.8],", "[[-1, -1.6], [1, -1.6],");
        let nearer = changed(dir, "sensor-mat/fixed.toml", "nearer.toml", &[polygon]);
        let (said, code) = distance(dir, &nearer, &["--edition", edition]);
        assert_eq!((way(&said, "into it"), code), ([1776, stands - 200, stands - 200 - 1776], Some(1)));
    }
    // In the flawed cell the fences begin at y = 0, and the mat at -1.2: one steps onto it from the side, at x = -1 or 1.
    let (said, code) = distance(dir, "sensor-mat/cell.toml", &[]);
    let edge = &said["safeguards"][0]["ways"][0]["edge_m"];
    assert!((edge[0].as_f64().unwrap().abs() - 1.0).abs() < 1e-6 && edge[1].as_f64().unwrap() < 0.1, "{edge}");
    assert!(code == Some(1) && way(&said, "into it")[1] < 1200);
}

#[test]
fn a_light_curtain_is_reached_through_and_over() {
    if !sample::is_turn(2, 4) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let asked = ["--edition", "2010", "--resolution-mm", "30"];
    // The cell's own page: the robot comes to 0.35 m behind the curtain, and to 1.35 m in the repaired one.
    // Through: 1600 mm/s x 0.46 s + 8 (30 - 14) mm = 736 mm + 128 mm. Over its upper edge at 1800 mm, for what is 1400 to 1600 mm high,
    // the table has 450 mm.
    let (said, code) = distance(dir, "light-curtain/cell.toml", &asked);
    assert_eq!((way(&said, "through"), code), ([864, 350, -514], Some(1)));
    let [over, near, _] = way(&said, "over");
    let (said, code) = distance(dir, "light-curtain/fixed.toml", &asked);
    assert_eq!((way(&said, "through"), code), ([864, 1350, 486], Some(0)));
    // All of the robot is 1 m farther away.
    assert_eq!((over, way(&said, "over")), (736 + 450, [1186, near + 1000, near + 1000 - 1186]));
    // Without its resolution nothing is passed, but what is too near for the finest is told.
    let (said, code) = distance(dir, "light-curtain/fixed.toml", &["--edition", "2010"]);
    assert_eq!((&said["safeguards"][0]["placed"], way(&said, "through")[0], code), (&"not_known".into(), 736, Some(4)));
    assert_eq!(distance(dir, "light-curtain/cell.toml", &["--edition", "2010"]).1, Some(1));
    // Nor without the table of 2024; where a panel closes what is above, nobody reaches over.
    assert_eq!(distance(dir, "light-curtain/fixed.toml", &["--resolution-mm", "30"]).1, Some(4));
    let panel = "[[obstacle]]\nname = \"panel\"\ncentre_m = [0, 0, 2.3]\nsize_m = [1, 0.02, 1]\n\n[[sensor]]";
    let own = ("kind = \"light_curtain\"", "kind = \"light_curtain\"\nresolution_mm = 14");
    let closed = changed(dir, "light-curtain/fixed.toml", "closed.toml", &[("[[sensor]]", panel), own]);
    let (said, code) = distance(dir, &closed, &[]);
    assert_eq!((way(&said, "through"), code), ([736, 1350, 614], Some(0)), "{said}");
    // Three beams stand at 300, 700 and 1100 mm; an arm gets through between them.
    let beams = [
        ("kind = \"light_curtain\"", "kind = \"light_curtain\"\nbeams = 3"),
        ("heights_m = [0, 1.8]", "heights_m = [0.3, 1.8]"),
    ];
    let cell = changed(dir, "light-curtain/fixed.toml", "beams.toml", &beams);
    let (said, code) = distance(dir, &cell, &["--edition", "2010"]);
    assert_eq!((way(&said, "through"), code), ([1586, 1350, -236], Some(1)));
}

#[test]
fn a_field_that_only_slows_the_robot_has_no_distance() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let asked = ["--edition", "2010", "--resolution-mm", "50"];
    let (said, code) = distance(dir, "head-collision/cell.toml", &asked);
    let field = &said["safeguards"][0];
    assert!(code == Some(4) && field["stop_s"].is_null() && field["margin_mm"].is_null(), "{said}");
    assert!(field["not_known"][0].as_str().unwrap().contains("slows it. So S has no value"), "{said}");
    // Repaired, at a height of 200 mm: 1600 mm/s x 0.62 s + 1200 mm - 0.4 x 200 mm, and 1200 mm in 2024.
    let (said, _) = distance(dir, "head-collision/fixed.toml", &asked);
    let [s, stands, margin] = way(&said, "into it");
    assert_eq!((s, margin), (992 + 1120, stands - 2112));
    let (said, code) = distance(dir, "head-collision/fixed.toml", &["--resolution-mm", "50"]);
    assert_eq!(way(&said, "into it"), [2192, stands, stands - 2192]);
    // Its back edge, at y = 3, is nearer than its front: 2.30 m, which were measured when the cell was made.
    let edge = &said["safeguards"][0]["ways"][0]["edge_m"][1];
    assert!((edge.as_f64().unwrap() - 3.0).abs() < 1e-6 && code == Some(1), "{said}");
    // With people in front only, the front edge counts: 1.1 m farther than that of the flawed cell, whose gripper is nearest.
    let front = "[human]\nfloor_m = [[-4, -4], [4, -4], [4, -1], [-4, -1]]\n";
    let in_front = |cell: &str| {
        let path = changed(dir, &format!("head-collision/{cell}"), "front.toml", &[("[human]\n", front)]);
        distance(dir, &path, &["--resolution-mm", "50"])
    };
    let near = in_front("cell.toml").0["safeguards"][0]["ways"][0]["stands_mm"].as_i64().unwrap();
    let (said, code) = in_front("fixed.toml");
    assert_eq!((way(&said, "into it"), code), ([2192, near + 1100, near + 1100 - 2192], Some(0)));
    // Too coarse for its height: H >= 15 (70 - 50) = 300 mm.
    let (said, code) = distance(dir, "head-collision/fixed.toml", &["--edition", "2010", "--resolution-mm", "70"]);
    assert!(code == Some(4) && said["safeguards"][0]["not_known"][0].as_str().unwrap().contains("300 mm"), "{said}");
}

#[test]
fn sensors_inside_the_fmu_and_cells_without_sensors_are_not_known() {
    let dir = examples();
    let dir = dir.path();
    let (said, code) = distance(dir, "two-scanners/cell.toml", &[]);
    assert!(code == Some(4) && said["safeguards"].as_array().unwrap().len() == 2, "{said}");
    assert_eq!(distance(dir, "safety-fence/cell.toml", &[]).1, Some(4));
}

#[test]
fn doors_and_two_hand_controls() {
    let dir = examples();
    let dir = dir.path();
    let curtain = "kind = \"light_curtain\"\nzone = { line_m = [[-0.5, 0], [0.5, 0]], heights_m = [0, 1.8] }";
    let door = |more: &str| {
        let new = format!(
            "kind = \"interlocked_door\"\nzone = {{ line_m = [[-0.5, 0], [0.5, 0]], heights_m = [0, 2] }}\n{more}"
        );
        let path = changed(dir, "light-curtain/fixed.toml", "door.toml", &[(curtain, &new)]);
        distance(dir, &path, &["--edition", "2010"])
    };
    // 1600 mm/s x 0.46 s; with a gap of 10 mm a hand gets 80 mm through; 0.2 s to open count.
    let (said, code) = door("");
    assert_eq!((way(&said, "through"), code), ([736, 1350, 614], Some(4)));
    let (said, code) = door("opening_mm = 10");
    assert_eq!((way(&said, "through"), code), ([816, 1350, 534], Some(0)));
    assert_eq!(way(&door("opening_mm = 10\nopening_ms = 200\nsupplement_mm = 25").0, "through")[0], 416 + 80 + 25);
    // The robot comes to 1.35 m behind the curtain's place, the buttons are 0.05 m before it; C is 250 mm, and 550 mm in 2024.
    let post = "kind = \"two_hand_control\"\nzone = { polygon_m = [[-0.25, -0.6], [0.25, -0.6], [0.25, -0.1], [-0.25, -0.1]], \
                line_m = [[-0.3, -0.05], [0.3, -0.05]] }";
    let path = changed(dir, "light-curtain/fixed.toml", "held.toml", &[(curtain, post)]);
    assert_eq!(way(&distance(dir, &path, &["--edition", "2010"]).0, "from it"), [986, 1400, 414]);
    assert_eq!(way(&distance(dir, &path, &[]).0, "from it"), [1286, 1400, 114]);
}

#[test]
fn people_read_the_formula_with_its_numbers_and_mistakes_have_their_line() {
    let dir = examples();
    let dir = dir.path();
    let output = fmi_hazard(dir).args(["distance", "sensor-mat/fixed.toml", "--edition", "2010"]).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(text.contains("S = K T + C = 1600 mm/s x 0.360 s + 1200 mm = 1776 mm (clause 7)"), "{text}");
    assert!(text.contains("far enough") && text.contains("not verified"), "{text}");
    for (more, says) in [
        ("beams = 3\nresolution_mm = 30", "has both beams and a resolution"),
        ("beams = 0", "has 0 beams"),
        ("opening_mm = 3", "which only a door has"),
        ("resolution_mm = -1", "resolution_mm of sensor `curtain` is -1"),
    ] {
        let sensor = format!("kind = \"light_curtain\"\n{more}");
        let path = changed(dir, "light-curtain/cell.toml", "bad.toml", &[("kind = \"light_curtain\"", &sensor)]);
        let output = fmi_hazard(dir).args(["distance", &path]).output().unwrap();
        let error = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(output.status.code() == Some(2) && error.contains(says), "{error}");
    }
}
