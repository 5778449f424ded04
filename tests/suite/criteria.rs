//! What counts as unsafe beside the transient force: clamping, pressure, moving contacts, separation, on the example cells with few
//! actions. Figures are worked out again from what a result tells.

use std::collections::BTreeMap;
use std::path::Path;

use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;
use serde_json::Value;

/// Scans a variant of an example cell with all sequences; exit code, what is said, and `scan.json`.
fn scanned(dir: &Path, example: &str, actions: u32, criteria: &str) -> (Option<i32>, String, Value) {
    let name = format!("{example}-{}", criteria.len());
    let folder = example.split('/').next().unwrap();
    let base = example.split('/').nth(1).unwrap();
    let file = write(
        &dir.join(folder),
        &format!("{base}-{}.toml", criteria.len()),
        &format!(
            "schema = 1\nname = \"{}\"\nextends = \"{base}.toml\"\n[search]\nactions = {actions}\n{criteria}",
            name.replace('/', "-")
        ),
    );
    let out = dir.join(format!("out-{}", name.replace('/', "-")));
    let output = fmi_hazard(dir)
        .args(["scan", "--no-advice", "--strategy", "exhaustive", "--out"])
        .arg(&out)
        .arg(&file)
        .output()
        .unwrap();
    let said = format!("{}{}", String::from_utf8_lossy(&output.stdout), String::from_utf8_lossy(&output.stderr));
    assert!(matches!(output.status.code(), Some(0 | 1 | 4)), "{said}");
    (output.status.code(), said, scan_json(&out))
}

fn hazards<'a>(scan: &'a Value, class: &str) -> Vec<&'a Value> {
    scan["hazards"].as_array().unwrap().iter().filter(|hazard| hazard["class"] == class).collect()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("{value} is no number"))
}

/// Those of the transient force as they are without: id, sequences, ratio.
fn by_force(scan: &Value) -> BTreeMap<String, (Value, Value)> {
    let all = hazards(scan, "force").into_iter().chain(hazards(scan, "head_contact"));
    all.map(|hazard| (hazard["id"].to_string(), (hazard["sequences"].clone(), hazard["ratio"].clone()))).collect()
}

/// What does not end a sequence hides nothing behind it: the same hazards by force, each of as many sequences, with the same
/// certificate, and moving contacts within all limits besides. Of the repaired cell both are clean.
#[test]
fn moving_contacts_are_told_beside_what_ends_sequences() {
    if !sample::is_turn(9, 12) {
        return;
    }
    let dir = examples();
    let (_, _, plain) = scanned(dir.path(), "heavy-workpiece/cell", 5, "");
    let (code, said, moving) = scanned(dir.path(), "heavy-workpiece/cell", 5, "[criteria]\nmoving_contact = true\n");
    assert_eq!(code, Some(1), "{said}");
    assert_eq!(by_force(&plain), by_force(&moving));
    assert_eq!(plain["certificate"]["hazardous"], moving["certificate"]["hazardous"]);
    assert!(moving["certificate"]["complete"] == true && plain["settings"]["criteria"].is_null());
    let touched = hazards(&moving, "moving_contact");
    assert!(!touched.is_empty(), "{said}");
    for hazard in touched {
        assert!(hazard["confirmed"] == true && hazard["sequences"].is_null(), "{hazard}");
        assert!(number(&hazard["ratio"]) <= 1.0 && number(&hazard["speed_m_s"]) > 1e-3, "{hazard}");
        assert_eq!(hazard["judged"]["limit"], "motion");
    }
    // Only what is faster than said counts.
    let fast = "[criteria]\nmoving_contact = { faster_than_m_s = 0.3 }\n";
    let (_, _, moving) = scanned(dir.path(), "heavy-workpiece/cell", 5, fast);
    assert!(hazards(&moving, "moving_contact").iter().all(|hazard| number(&hazard["speed_m_s"]) > 0.3));
    // In five actions nobody gets near the robot, which is all that is open.
    let actions = if sample::is_whole() { 7 } else { 5 };
    let (code, said, fixed) = scanned(dir.path(), "safety-fence/fixed", actions, "[criteria]\nmoving_contact = true\n");
    let is_open = |one: &&Value| one["standing"] == "open";
    let open: Vec<&Value> = fixed["obligations"].as_array().unwrap().iter().filter(is_open).collect();
    let only_far = code == Some(4) && open.iter().all(|one| one["need"] == "near");
    assert!(code == Some(0) || only_far, "{said}");
}

/// A robot that lifts workpieces beside a stand clamps people against stand and floor more slowly than it may hit them.
#[test]
fn clamped_parts_bear_half_and_the_whole_robot_is_behind() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let dir = examples();
    let (_, _, plain) = scanned(dir.path(), "heavy-workpiece/cell", 5, "");
    let (code, said, scan) = scanned(dir.path(), "heavy-workpiece/cell", 5, "[criteria]\nclamping = true\n");
    assert_eq!(code, Some(1), "{said}");
    assert!(scan["certificate"]["complete"] == true && said.contains("Unsafe is"), "{said}");
    let gaps = [("hand", 0.1), ("lower_arm", 0.12), ("upper_arm", 0.12), ("thigh", 0.18), ("lower_leg", 0.18)];
    let quasi_static =
        [("hand", 135.0), ("lower_arm", 160.0), ("upper_arm", 150.0), ("thigh", 220.0), ("lower_leg", 125.0)];
    let springs = [("hand", 75e3), ("lower_arm", 40e3), ("upper_arm", 30e3), ("thigh", 50e3), ("lower_leg", 60e3)];
    let of =
        |rows: &[(&str, f64)], region: &str| rows.iter().find(|(name, _)| *name == region).map(|(_, value)| *value);
    let clamped = hazards(&scan, "clamping");
    assert!(!clamped.is_empty(), "{said}");
    for hazard in &clamped {
        let (judged, region) = (&hazard["judged"], hazard["body_region"].as_str().unwrap());
        let held = &judged["clamping"];
        assert!(hazard["confirmed"] == true && judged["contact"] == "quasi_static", "{hazard}");
        assert!(!held["against"].as_str().unwrap().starts_with("obstacle "), "{held}");
        assert!(number(&held["gap_m"]) <= of(&gaps, region).unwrap_or(0.5) + 1e-9, "{hazard}");
        if let (Some(limit), Some(spring)) = (of(&quasi_static, region), of(&springs, region)) {
            let force = number(&held["closing_m_s"]) * (number(&hazard["effective_mass_kg"]) * spring).sqrt();
            assert!(
                (number(&held["force_n"]) / force - 1.0).abs() < 1e-9 && number(&held["limit_n"]) == limit,
                "{hazard}"
            );
            assert!((number(&hazard["ratio"]) - force / limit).abs() < 1e-9, "{hazard}");
        }
    }
    // What was unsafe before is so still, by one criterion or the other, no later.
    let earliest = |scan: &Value| {
        let all = scan["hazards"].as_array().unwrap().iter();
        all.map(|hazard| number(&hazard["earliest_time_s"])).fold(f64::INFINITY, f64::min)
    };
    assert!(earliest(&scan) <= earliest(&plain));
    let text = std::fs::read_to_string(dir.path().join("out-heavy-workpiece-cell-27/hazards.csv")).unwrap();
    assert!(text.lines().next().unwrap().ends_with("criterion,contact_kind,limit_kind,held_against,measure_and_limit"));
    assert!(text.contains(",crushing,") && text.contains(",clamping,quasi_static,force,"), "{text}");
    // In words.
    let output = fmi_hazard(dir.path())
        .args(["explain", "--no-changes", "out-heavy-workpiece-cell-27"])
        .arg(clamped[0]["id"].as_str().unwrap())
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&output.stdout);
    assert!(told.contains("does not give way") && told.contains("F = c sqrt(m_R k)"), "{told}");
}

/// A link that does not say how small it touches is not known, and passes nobody; one that says so is judged.
#[test]
fn pressure_of_links_that_say_nothing_is_not_known() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    let (code, said, scan) = scanned(dir.path(), "safety-fence/fixed", 4, "[criteria]\npressure = true\n");
    assert_eq!(code, Some(4), "{said}");
    assert!(scan["hazards"].as_array().unwrap().is_empty() && scan["verdict"] == "inconclusive");
    assert!(scan["certificate"]["complete"] == false && !said.contains("Complete: all"), "{said}");
    let unknown =
        scan["obligations"].as_array().unwrap().iter().find(|one| one["need"] == "pressure").unwrap().to_string();
    assert!(unknown.contains("gripper") && unknown.contains("turret") && said.contains("Not shown"), "{said}");
    let edge = "[criteria]\npressure = true\ntransient_force = false\n[[robot]]\nname = \"IRB 1200-5/0.9\"\n\
                contact = { radius_m = 0.002 }\n";
    let (code, said, scan) = scanned(dir.path(), "safety-fence/cell", 7, edge);
    assert_eq!(code, Some(1), "{said}");
    assert!(scan["unknown"].is_null() && hazards(&scan, "force").is_empty());
    for hazard in hazards(&scan, "pressure") {
        // A ball of 2 mm in a hand: the greater of Hertz's pressure and of the force over its cross-section.
        let (force, radius) = (number(&hazard["force_n"]), 0.002_f64);
        let spring = match hazard["body_region"].as_str().unwrap() {
            "hand" => 75e3,
            "lower_arm" => 40e3,
            _ => continue,
        };
        let modulus = spring / (2.0 * 0.005_641_895_835);
        let hertz = (6.0 * force * modulus * modulus / (std::f64::consts::PI.powi(3) * radius * radius)).cbrt();
        let told = number(&hazard["judged"]["pressure"]["n_cm2"]) * 1e4;
        let expected = hertz.max(force / (std::f64::consts::PI * radius * radius));
        assert!((told / expected - 1.0).abs() < 1e-9, "{told} {expected}");
    }
}

/// The sensor that stops the robot, and some uncertainty.
const SEPARATION: &str =
    "[criteria]\nseparation = { stop = \"mat\", intrusion_m = 0.2, person_uncertainty_m = 0.05 }\n";

/// A sensor that tells later stops the robot later by as much.
#[test]
fn a_sensor_that_tells_later_asks_for_more_separation() {
    if !sample::is_turn(5, 6) {
        return;
    }
    let dir = examples();
    let late = format!("{SEPARATION}[[sensor]]\nname = \"mat\"\ndelay_ms = 100\n");
    let [(_, _, scan), (_, _, later)] = [SEPARATION, &late]
        .map(|criteria| scanned(dir.path(), "sensor-mat/cell", if sample::is_whole() { 6 } else { 5 }, criteria));
    let longest = |scan: &Value| {
        let all = hazards(scan, "separation").into_iter();
        all.filter_map(|h| h["judged"]["separation"]["stops_after_s"].as_f64()).fold(0.0, f64::max)
    };
    assert!(longest(&scan) > 0.0 && longest(&later) >= longest(&scan) + 0.08, "{} {}", longest(&later), longest(&scan));
}

/// The protective separation distance from what the FMU itself shows of a stop, by the figures that a result tells.
#[test]
fn separation_is_what_the_stop_of_that_very_state_asks_for() {
    if !sample::is_turn(1, 6) {
        return;
    }
    let dir = examples();
    let criteria = SEPARATION;
    let (_, _, plain) = scanned(dir.path(), "sensor-mat/cell", 6, "");
    let (code, said, scan) = scanned(dir.path(), "sensor-mat/cell", 6, criteria);
    assert_eq!(code, Some(1), "{said}");
    assert_eq!(by_force(&plain), by_force(&scan));
    let near = hazards(&scan, "separation");
    assert!(!near.is_empty(), "{said}");
    let mut finite = 0;
    for hazard in near {
        assert!(hazard["confirmed"] == true && hazard["judged"]["contact"] == "none", "{hazard}");
        let told = &hazard["judged"]["separation"];
        let (Some(required), Some(stops)) = (told["required_m"].as_f64(), told["stops_after_s"].as_f64()) else {
            continue;
        };
        let by_hand = 1.6 * stops + number(&told["travel_m"]) + 0.2 + 0.05;
        assert!((required - by_hand).abs() < 1e-9 && number(&told["distance_m"]) < required, "{told}");
        finite += 1;
    }
    assert!(finite > 0, "{said}");
    // What a cell does not count any more is neither fixed nor gone.
    let run = |arguments: &[&str]| {
        let output = fmi_hazard(dir.path()).args(arguments).output().unwrap();
        (output.status.code(), String::from_utf8_lossy(&output.stdout).into_owned())
    };
    let before = format!("out-sensor-mat-cell-{}", criteria.len());
    let (code, told) = run(&["replay", &before, "--changed", "sensor-mat/fixed.toml"]);
    assert!(code == Some(4) && told.contains("NOT JUDGED") && told.contains("does not count separation:"), "{told}");
    let (_, told) = run(&["compare", &before, "out-sensor-mat-cell-0", "--format", "json"]);
    let rows: Value = serde_json::from_str(&told).unwrap();
    let counts = &rows["counts"];
    assert!(counts["fixed"].is_null() && counts["not_found_again"].as_u64().is_some_and(|n| n > 0), "{counts}");
    // Nothing to stop with, or something that does not exist.
    let wrong = "[criteria]\nseparation = { stop = \"fild\", intrusion_m = 0.2 }\n";
    let file = write(
        &dir.path().join("head-collision"),
        "wrong.toml",
        &format!("schema = 1\nname = \"wrong\"\nextends = \"cell.toml\"\n{wrong}"),
    );
    let output = fmi_hazard(dir.path()).arg("check").arg(&file).output().unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.code() == Some(2) && said.contains("did you mean `field`"), "{said}");
}
