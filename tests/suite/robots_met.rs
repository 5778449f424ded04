//! What a scan from the start tells of each robot, whether it moved and whether anybody was near it; and how much of the robots' cycle
//! was met. Cells in which nobody could have been hit, each beside its repaired twin.

use serde_json::Value;

use crate::common::{faulty_cell, fmi_hazard, scan_json, test_fmus, write};

/// FMUs of the turning joint, FMI 2 and 3.
const FMUS: [&str; 2] = ["faulty.fmu", "faulty-fmi3.fmu"];

/// The cell of the turning joint with these changes of its text, `actions` in a row.
fn cell(fmu: &str, actions: u32, changes: &[(&str, &str)]) -> String {
    let mut text = faulty_cell(fmu, 0, 0).replace("iterations = 12", &format!("iterations = 3\nactions = {actions}"));
    for (old, new) in changes {
        assert!(text.contains(old), "the cell is another one: {old}");
        text = text.replace(old, new);
    }
    text
}

/// `scan.json` of a scan of such a cell.
fn scanned(text: &str, more: &[&str]) -> Value {
    let dir = tempfile::TempDir::new().unwrap();
    for fmu in FMUS {
        std::fs::copy(test_fmus().join(fmu), dir.path().join(fmu)).unwrap();
    }
    write(dir.path(), "cell.toml", text);
    let arguments = ["scan", "--no-advice", "cell.toml", "--out", "o"];
    let ran = fmi_hazard(dir.path()).args(arguments).args(more).output().unwrap();
    let told = String::from_utf8_lossy(&ran.stderr);
    assert!(dir.path().join("o/scan.json").exists(), "{told}");
    scan_json(&dir.path().join("o"))
}

const ALL: [&str; 2] = ["--strategy", "exhaustive"];
const SOME: [&str; 2] = ["--strategy", "random"];

/// Figures of a robot, by its number.
fn robot(scan: &Value, number: usize) -> &Value {
    &scan["coverage"]["robots"][number]
}

fn count(figure: &Value) -> u64 {
    figure.as_u64().expect("a count")
}

/// Somebody was near it, and it moved.
fn is_met(robot: &Value) {
    assert!(robot["moved"] == true && robot["reachable"] == true, "{robot}");
    assert!(count(&robot["instants_in_reach"]) > 0 && count(&robot["instants_to_walk_to"]) > 0, "{robot}");
    assert!(robot["top_speed_m_s"].as_f64().unwrap() > 0.3, "{robot}");
    assert!(robot["closest_approach_m"].as_f64().unwrap() < 2.0, "{robot}");
}

/// What is open of such a scan, which says nothing clean then.
fn open_needs(scan: &Value) -> Vec<&str> {
    assert_ne!(scan["verdict"], "none_found", "{}", scan["headline"]);
    let all = scan["obligations"].as_array().unwrap().iter().filter(|one| one["standing"] == "open");
    all.map(|one| one["need"].as_str().unwrap()).collect()
}

/// Nobody could be near it.
fn is_far(robot: &Value) {
    assert_eq!((count(&robot["instants_in_reach"]), count(&robot["instants_to_walk_to"])), (0, 0), "{robot}");
    assert!(robot["closest_approach_m"].as_f64().unwrap() > 1e6, "{robot}");
}

#[test]
fn a_base_far_up_leaves_nobody_near() {
    for fmu in FMUS {
        let up = cell(fmu, 2, &[("xyz_m = [0, 0, 0.9]", "xyz_m = [0, 0, 29]")]);
        let all = scanned(&up, &ALL);
        is_far(robot(&all, 0));
        // By lengths alone, so nothing was simulated; whether it would have moved is not known.
        assert_eq!((&robot(&all, 0)["reachable"], &all["coverage"]["actions"]), (&Value::Bool(false), &Value::from(0)));
        let some = scanned(&up, &SOME);
        is_far(robot(&some, 0));
        assert!([&all, &some].iter().all(|scan| open_needs(scan).contains(&"near")), "{}", all["obligations"]);
        assert!(robot(&some, 0)["moved"] == true && count(&some["coverage"]["actions"]) > 0, "{}", some["coverage"]);
        for how in [&ALL, &SOME] {
            is_met(robot(&scanned(&cell(fmu, 2, &[]), how), 0));
        }
    }
}

#[test]
fn a_joint_in_radians_where_degrees_are_asked_for_turns_the_robot_away() {
    // A boom of 2.5 m on a column that does not turn, with the bar at its end.
    let boom = |fmu: &str, held_deg: &str| {
        let column =
            format!("name = \"column\"\naxis = [0, 0, 1]\nheld_deg = {held_deg}\n[[robot.joint]]\nname = \"table\"");
        let origin = "name = \"table\"\norigin = { xyz_m = [2.5, 0, 0] }";
        let start = ("start = { xy_m = [0, -1.6]", "start = { xy_m = [0, -4.2]");
        cell(fmu, 2, &[("name = \"table\"", &column), ("name = \"table\"", origin), start])
    };
    for fmu in FMUS {
        let wrong = scanned(&boom(fmu, "-1.57"), &ALL);
        is_far(robot(&wrong, 0));
        assert!(open_needs(&wrong).contains(&"near"), "{}", wrong["obligations"]);
        // Within its lengths somebody is: it is where it is that tells.
        assert!(robot(&wrong, 0)["moved"] == true && robot(&wrong, 0)["reachable"] == true, "{}", robot(&wrong, 0));
        is_met(robot(&scanned(&boom(fmu, "-90"), &ALL), 0));
    }
}

#[test]
fn a_second_robot_that_never_moves_is_told_by_itself() {
    // Both beside the person; the second one's joint is held, or turns as the first one's does.
    let two = |fmu: &str, joint: &str| {
        let second = format!(
            "[[robot]]\nname = \"second\"\nbase = {{ xyz_m = [0.6, 0, 0.9] }}\nmoving_mass_kg = 40\npayload_kg = 3\n\
             [[robot.joint]]\nname = \"own\"\naxis = [0, 0, 1]\n{joint}\n[[robot.link]]\nname = \"own bar\"\njoint = \"own\"\n\
             capsule = {{ from_m = [0, 0, 0], to_m = [0.8, 0, 0], radius_m = 0.05 }}\n[[sensor]]"
        );
        cell(fmu, 2, &[("[[sensor]]", &second)])
    };
    let turns = "angle = { variable = \"q\", unit = \"rad\" }\nspeed = { variable = \"qd\", unit = \"rad/s\" }";
    for fmu in FMUS {
        let (still, both) = (scanned(&two(fmu, "held_deg = 0"), &ALL), scanned(&two(fmu, turns), &ALL));
        let open = open_needs(&still);
        assert!(open.contains(&"moves") && !open.contains(&"near"), "{open:?}");
        is_met(robot(&still, 0));
        is_met(robot(&both, 0));
        is_met(robot(&both, 1));
        let second = robot(&still, 1);
        assert!(second["moved"] == false && second["top_speed_m_s"] == 0.0 && second["name"] == "second", "{second}");
        // An exhaustive search asks nothing of robots that are too slow to harm: still it tells that somebody was near.
        assert!(count(&second["instants_in_reach"]) > 0, "{second}");
    }
}

#[test]
fn near_instants_and_worked_controls_are_counted_as_by_hand() {
    // Beside the robot, and no more than 0.32 m from there after one action: always near. A bar of 0.8 m about the base at 0.9 m height.
    let start = ("start = { xy_m = [0, -1.6]", "start = { xy_m = [0, -0.7]");
    let button = |at: &str| format!("[[control]]\nname = \"jog\"\nvariable = \"push\"\nat_m = {at}\n[parameters]");
    let no_mat = |text: &str| {
        let (before, rest) = text.split_once("[[sensor]]").unwrap();
        format!("{before}{}", &rest[rest.find("[[control]]").unwrap()..])
    };
    for fmu in FMUS {
        let near = scanned(&no_mat(&cell(fmu, 1, &[start, ("[parameters]", &button("[0.3, -1.0, 1.1]"))])), &ALL);
        let coverage = &near["coverage"];
        let steps = (0.2 / near["settings"]["contact_check_interval_s"].as_f64().unwrap()).round();
        let instants = coverage["actions"].as_f64().unwrap() * steps;
        assert_eq!(robot(&near, 0)["instants_in_reach"].as_f64().unwrap(), instants, "{coverage}");
        assert_eq!(robot(&near, 0)["instants_to_walk_to"].as_f64().unwrap(), instants, "{coverage}");
        // Of actions that differ in the button alone the FMU hears of the button: each comes twice, worked and not.
        let worked = count(&coverage["control_actions"][0]);
        assert!(worked > 0 && worked < count(&coverage["actions"]), "{coverage}");
        let far = scanned(&no_mat(&cell(fmu, 1, &[start, ("[parameters]", &button("[9, -9, 1.1]"))])), &ALL);
        assert_eq!(count(&far["coverage"]["control_actions"][0]), 0, "{}", far["coverage"]);
    }
}

#[test]
fn the_share_of_the_cycle_is_told() {
    // 0.5 rad/s with a swell of a fifth, a tenth in the mean: a turn takes 2 pi / 0.55 s.
    let turn_s = std::f64::consts::TAU / 0.55;
    for fmu in FMUS {
        for begins_s in [0.0, 1.0] {
            let begins = format!("[human]\nbegins_s = [{begins_s}]");
            // The swell is another one in each turn: at 0.7 m that makes less than the 5 mm that are the same place.
            let shorter = ("to_m = [0.8, 0, 0]", "to_m = [0.7, 0, 0]");
            let cycle = &scanned(&cell(fmu, 2, &[("[human]", &begins), shorter]), &SOME)["cycle"];
            let of = |key: &str| cycle[key].as_f64().expect("a number");
            assert!((of("cycle_s") - turn_s).abs() < 0.03, "{cycle}");
            // The drive takes half a second to come to its pace.
            assert!(of("repeats_from_s") >= begins_s && of("repeats_from_s") <= begins_s.max(0.6), "{cycle}");
            assert!((of("from_s") - begins_s).abs() < 1e-9 && (of("until_s") - begins_s - 0.4).abs() < 1e-9, "{cycle}");
            assert_eq!((of("watched_s"), &cycle["moves"]), (32.0, &Value::Bool(true)), "two turns take 22.8 s");
        }
        // The person stands on the mat: the robot comes to rest, and there is no cycle.
        let stopped = cell(fmu, 2, &[("start = { xy_m = [0, -1.6]", "start = { xy_m = [0, -0.7]")]);
        let cycle = &scanned(&stopped, &SOME)["cycle"];
        assert_eq!((&cycle["cycle_s"], &cycle["watched_s"]), (&Value::Null, &Value::from(60.0)), "{cycle}");
    }
}
