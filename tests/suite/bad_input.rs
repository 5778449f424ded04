//! Whatever a user gives by mistake: one clear message that says what to do, the right exit code, no panic.

use std::path::Path;

use crate::common::{examples, faulty_cell, fmi_hazard, scan_json, test_fmus, write};
use fmi_hazard_sample::meshes;

/// Runs `scan` on `path`, expects `code` and all of `words` on stderr; returns stderr.
fn fails(dir: &Path, path: &str, code: i32, words: &[&str]) -> String {
    let output = fmi_hazard(dir)
        .args(["scan", "--no-advice", path, "--out", "o", "--strategy", "random", "--iterations", "1"])
        .assert()
        .code(code)
        .get_output()
        .clone();
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    // miette wraps lines: compare without line breaks and box drawing.
    let flat = text.replace(['│', '\n'], " ").split_whitespace().collect::<Vec<_>>().join(" ");
    for word in words {
        assert!(flat.contains(word), "`{word}` is not in:\n{text}");
    }
    assert!(!text.contains("panicked"), "{text}");
    text
}

#[test]
fn files_that_are_not_what_they_should_be() {
    let dir = tempfile::TempDir::new().unwrap();
    fails(dir.path(), "missing.fmu", 2, &["missing.fmu"]);
    fails(dir.path(), "missing.toml", 2, &["missing.toml"]);
    write(dir.path(), "text.fmu", "this is no zip");
    fails(dir.path(), "text.fmu", 2, &["text.fmu", "not a"]);
}

#[test]
fn an_fmu_without_a_cell_says_where_it_looked() {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::copy(test_fmus().join("faulty.fmu"), dir.path().join("x.fmu")).unwrap();
    fails(dir.path(), "x.fmu", 2, &["without a cell file", "x.cell.toml", "cell.toml", "extra/", "examples export"]);
}

/// The first obstacle of the example's cell file.
const FENCE: &str = "centre_m = [-0.9, 0, 1]\nsize_m = [1.2, 0.02, 2]";

/// (what is replaced, by what, words of the message); each applied to the example's cell file.
const CELL_MISTAKES: &[(&str, &str, &[&str])] = &[
    ("moving_mass_kg", "moving_mas_kg", &["unknown field", "did you mean `moving_mass_kg`", "wrong.toml:13"]),
    ("[human]", "[humann]", &["unknown field `humann`", "did you mean `human`"]),
    ("schema = 1", "schema = 2", &["format 2", "schema = 1"]),
    ("robot.q[3]", "robot.q[7]", &["`robot.q[7]` is not in safety-fence.fmu", "did you mean"]),
    ("\"robot.q[1]\" }", "\"robot.q[1]\", unit = \"mm\" }", &["`mm` does not fit", "rad, deg"]),
    ("\"robot.q[1]\" }", "\"robot.q[1]\", unit = \"deg\" }", &["in `rad`", "says `deg`"]),
    ("\"robot.q[1]\" }", "\"ctrl.leg\" }", &["ctrl.leg"]),
    ("\"robot.q[1]\" }", "\"gripper.payload\" }", &["`gripper.payload` is in `kg`, which does not fit"]),
    ("\"plc.guard_closed\" = true", "\"plc.guard_closed\" = 1", &["needs true or false"]),
    ("\"plc.reset\" = false", "\"robot.q[1]\" = 0", &["not an input"]),
    ("axis = [0, 1, 0]", "axis = [0, 0, 0]", &["no direction"]),
    ("joint = \"joint_4\"", "joint = \"joint_44\"", &["no joint `joint_44`", "did you mean `joint_4`"]),
    ("step_s = 0.02", "step_s = 0.03", &["time.step_s", "0.02"]),
    ("step_s = 0.02", "step_s = 0.0001", &["time.step_s is 0.0001", "1000 steps at most", "use 0.0002 or more"]),
    ("step_s = 0.02", "step_s = 1e-300", &["time.step_s is 1e-300", "1000 steps at most"]),
    ("axis = [0, 1, 0]", "axis = [0, 1]", &["invalid length 2", "schema"]),
    ("step_s = 0.02", "step_s = 0.015", &["does not divide", "0.02, 0.01"]),
    ("moving_mass_kg = 40.4", "moving_mass_kg = -1", &["greater than zero"]),
    ("heading_deg = 90", "heading_deg = \"north\"", &["invalid type"]),
    ("xy_m = [1.05, -1.7]", "xy_m = [0.9, 0.0]", &["inside an obstacle", "human.start"]),
    ("fmu = \"safety-fence.fmu\"", "fmu = \"other.fmu\"", &["does not exist", "relative to the cell file"]),
    ("fmu = \"safety-fence.fmu\"\n", "", &["does not say which FMU", "fmu ="]),
    (
        "[[robot]]",
        "[[unit]]\nname = \"a\"\nfmu = \"safety-fence.fmu\"\n[[robot]]",
        &["names one FMU with `fmu` and others"],
    ),
    (
        "fmu = \"safety-fence.fmu\"",
        "[[unit]]\nname = \"a\"\nfmu = \"safety-fence.fmu\"",
        &["which FMU", "write `unit:"],
    ),
    ("[human]", "[fail_on]\nbaseline = \"b.json\"\n[human]", &["never read", "new_only = true"]),
    ("[human]", "[fail_on]\nnew_only = true\n[human]", &["baseline.json does not exist", "--write-baseline"]),
    ("size_m = [1.2, 0.02, 2]", "size_m = [1.2, 0, 2]", &["fence front left", "greater than zero"]),
    ("size_m = [1.2, 0.02, 2]\n", "", &["`fence front left` needs centre_m and size_m, or a mesh", "a box is"]),
    (
        "size_m = [1.2, 0.02, 2]",
        "size_m = [1.2, 0.02, 2]\nmesh = { file = \"open.stl\", metres_per_unit = 1 }",
        &["is a box and a mesh", "remove one of the two"],
    ),
    (
        "size_m = [1.2, 0.02, 2]",
        "size_m = [1.2, 0.02, 2]\nresolution_m = 0.1",
        &["resolution_m of obstacle `fence front left` is for meshes", "remove it"],
    ),
    (
        FENCE,
        "mesh = { file = \"open.stl\", metres_per_unit = 0.001 }",
        &["nothing of the mesh can be taken", "open at 3 edges", "give the obstacle as boxes"],
    ),
    (FENCE, "mesh = { file = \"open.stl\" }", &["does not say its unit", "add metres_per_unit: 0.001"]),
    (
        FENCE,
        "rpy_deg = [0, 0, 9]\nmesh = { file = \"open.stl\", metres_per_unit = 0.001 }",
        &["rpy_deg of obstacle `fence front left` is for boxes", "at = { rpy_deg"],
    ),
    (
        FENCE,
        "resolution_m = 0.5\nmesh = { file = \"open.stl\", metres_per_unit = 0.001 }",
        &["resolution_m of obstacle `fence front left` is 0.5", "0.01 to 0.2"],
    ),
    (FENCE, "mesh = { file = \"no.glb\" }", &["cannot read no.glb", "glTF and GLB are read"]),
    (FENCE, "mesh = { file = \"open.stl\", metres_per_unit = 0.001, exact = true }", &["unknown field `exact`"]),
    (FENCE, "mesh = { file = \"open.stl\", metres_per_unit = 1e6 }", &["more than 10 km away", "metres_per_unit"]),
    ("schema = 1", "schema = one", &["TOML", "quotes"]),
    ("schema = 1\n", "", &["missing field `schema`", "add `schema`"]),
    ("name = \"joint_2\"", "name = \"joint_1\"", &["two joints or frames are called `joint_1`", "its own name"]),
    ("axis = [0, 1, 0]\n", "", &["joint `joint_2` has no axis", "axis = [0, 0, 1]"]),
    ("angle = { variable = \"robot.q[1]\" }\n", "", &["needs one of angle, position, held_deg", "variable ="]),
    (
        "axis = [0, 1, 0]",
        "axis = [0, 1, 0]\nheld_deg = 3",
        &["needs one of angle, position, held_deg", "stays where it is"],
    ),
    ("moving_mass_kg = 40.4\n", "", &["no moving mass", "data sheet"]),
    ("moving_mass_kg = 40.4", "moving_mass_kg = \"40 kg\"", &["invalid type", "numbers and true or false do not"]),
    ("payload = {", "payload_kg = 3\npayload = {", &["either `payload_kg`", "payload_kg = 0"]),
    ("payload = { variable = \"gripper.payload\" }", "payload_kg = -2", &["payload_kg is -2", "zero or more"]),
    ("phase = \"ctrl.leg\"", "phase = \"robot.q[1]\"", &["Integer or Boolean output", "inspect"]),
    ("radius_m = 0.142", "radius_m = -0.142", &["radius of a link", "greater than zero"]),
    ("radius_m = 0.142 }", "radius_m = 0.142 }\nhull_m = [[0, 0, 0]]", &["needs one shape", "several [[robot.link]]"]),
    (
        "capsule = { from_m = [0.006, 0, -0.125], to_m = [0.006, 0, 0.02], radius_m = 0.142 }",
        "hull_m = [[0, 0, 0], [1, 0, 0], [0, 1, 0], [1, 1, 0]]",
        &["no convex hull with volume", "not in one plane"],
    ),
    (
        "capsule = { from_m = [0.006, 0, -0.125], to_m = [0.006, 0, 0.02], radius_m = 0.142 }",
        "mesh = { file = \"turret.stl\", metres_per_unit = 0.001 }",
        &["cannot read turret.stl", "relative to the cell file"],
    ),
    (
        "capsule = { from_m = [0.006, 0, -0.125], to_m = [0.006, 0, 0.02], radius_m = 0.142 }",
        "mesh = { file = \"cell.toml\", metres_per_unit = 0.001 }",
        &["meshes of type `toml` are not read", "STL and OBJ"],
    ),
    (
        "capsule = { from_m = [0.006, 0, -0.125], to_m = [0.006, 0, 0.02], radius_m = 0.142 }",
        "mesh = { file = \"open.stl\", metres_per_unit = 0.001, exact = true }",
        &["not closed: 3 of its edges have a triangle on one side only", "leave out `exact`", "hull"],
    ),
    (
        "capsule = { from_m = [0.006, 0, -0.125], to_m = [0.006, 0, 0.02], radius_m = 0.142 }",
        "mesh = { file = \"turned.stl\", metres_per_unit = 0.001, exact = true }",
        &["inside out in parts, at 3 of its edges", "mend it in CAD"],
    ),
    (
        "capsule = { from_m = [0.006, 0, -0.125], to_m = [0.006, 0, 0.02], radius_m = 0.142 }",
        "mesh = { file = \"open.stl\", metres_per_unit = 0.001, exact = \"yes\" }",
        &["invalid type", "texts stand in quotes"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"mat\"\nvariable = \"plc.reset\"\nactive = true\n[human]",
        &["no zone", "polygon_m"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"matt\"\nvariable = \"plc.reset\"\nactive = true\n[human]",
        &["unknown variant `matt`", "did you mean `mat`"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"mat\"\nzone = { polygon_m = [[0, 0], [1, 0]] }\nvariable = \"plc.reset\"\nactive = \
         true\n[human]",
        &["at least three corners", "[[x, y], ...]"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"mat\"\nzone = { polygon_m = [[0, 0], [1, 0], [1, 1]] }\nvariable = \
         \"plc.reset\"\n[human]",
        &["does not say which value of `plc.reset` means a person", "active = false", "inspect --run"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"mat\"\nzone = { polygon_m = [[0, 0], [1, 0], [1, 1]] }\nvariable = \
         \"plc.reset\"\nactive = true\n[human]",
        &["`plc.reset` is driven by two things at once", "remove one of the two"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"scanner_field\"\nzone = { polygon_m = [[0, 0], [1, 0], [1, 1]], height_m = 3 \
         }\nvariable = \"plc.guard_closed\"\nactive = false\n[human]",
        &["height of sensor `m` is 3 m", "0 to 1 m"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"light_curtain\"\nzone = { line_m = [[0, 0], [1, 0]] }\nvariable = \
         \"plc.guard_closed\"\nactive = false\n[human]",
        &["needs `line_m` and `heights_m`", "zone = {"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"mat\"\nzone = { polygon_m = [[0, 0], [1, 0], [1, 1]] }\nvariable = \
         \"plc.guard_closed\"\nactive = false\ndelay_ms = -5\n[human]",
        &["delay_ms of sensor `m` is -5", "use 0 to"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"interlocked_door\"\nzone = { line_m = [[0, 0], [0, 0]], heights_m = [0, 2] \
         }\nvariable = \"plc.guard_closed\"\nactive = false\n[human]",
        &["the plane of door `m` has no extent", "two ends"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"two_hand_control\"\nzone = { polygon_m = [[0, 0], [1, 0], [1, 1]] }\nvariable \
         = \"plc.guard_closed\"\nactive = false\n[human]",
        &["two-hand control `m` does not say where its buttons are", "add line_m"],
    ),
    (
        "[human]",
        "[[sensor]]\nname = \"m\"\nkind = \"two_hand_control\"\nzone = { polygon_m = [[0, 0], [1, 0], [1, 1]], line_m = \
         [[0, 0.5], [1, 0.5]] }\nvariable = \"plc.guard_closed\"\nactive = false\n[human]",
        &["goes through its operator's post", "on one side of line_m"],
    ),
    (
        "step_s = 0.02",
        "step_s = 0.005\n[[sensor]]\nname = \"m\"\nkind = \"light_curtain\"\nzone = { line_m = [[0, 0], [1, 0]], \
         heights_m = [0, 2] }\nvariable = \"plc.guard_closed\"\nactive = false",
        &["time.step_s is 0.005, too short for m", "use 0.01 or 0.02"],
    ),
    ("[human]", "[human]\nradii_m = { head = 1.2 }", &["radius of `head` is 1.2 m", "0.02 to 0.4 m"]),
    ("[human]", "[human]\nradii_m = { hed = 0.1 }", &["unknown field `hed`", "did you mean `head`"]),
    ("[human]", "[human]\nbegins_s = []", &["human.begins_s is empty", "leave it out"]),
    ("[human]", "[human]\nbegins_s = [0, -1]", &["human.begins_s has -1", "0 to 3600 s"]),
    (
        "[human]",
        "[human]\nother_starts = [{ xy_m = [0.9, 0.0], heading_deg = 90 }]",
        &[
            "the person's start (0.90, 0.00) m is inside an obstacle",
            "move this one of human.other_starts",
            "wrong.toml:",
        ],
    ),
    ("[human]", "[pose]\nx = \"plc.reset\"\n[human]", &["a Real input is needed", "inspect"]),
    ("[human]", "[pose]\nxx = \"plc.reset\"\n[human]", &["unknown variant `xx`", "did you mean"]),
    ("[human]", "[parameters]\n\"plc.reset\" = true\n[human]", &["not a parameter", "[inputs]"]),
    ("[human]", "[human]\npercentile = 40", &["5, 50 and 95, not 40", "nearest"]),
    ("[human]", "[human]\nbend_forward_deg = 120", &["120", "between 0 and 90"]),
    ("[human]", "[human]\nsex = \"male\"", &["unknown variant `male`", "did you mean `man`"]),
    ("[human]", "[search]\nactions = 0\n[human]", &["actions from 1 to 64", "the paper uses"]),
    ("[human]", "[search]\nreach_tolerance_m = 1\n[human]", &["reach_tolerance_m is 1", "0.001 to 0.05"]),
    ("[human]", "[human]\n[human]", &["duplicate key", "remove one of the two"]),
    ("[[robot.joint]]", "urdf = \"no.urdf\"\n[[robot.joint]]", &["cannot read no.urdf", "relative to the cell file"]),
    ("[[robot.joint]]", "urdf = \"bad.urdf\"\n[[robot.joint]]", &["it is no XML", "xacro", "bad.urdf:2"]),
    ("[[robot.joint]]", "urdf = \"loop.urdf\"\n[[robot.joint]]", &["is part of a loop", "a tree", "loop.urdf:4"]),
    (
        "[[robot.joint]]",
        "urdf = \"kinds.urdf\"\n[[robot.joint]]",
        &["`joint_1` of the URDF slides", "`position` or `held_m`"],
    ),
    (
        "payload = { variable = \"gripper.payload\" }",
        "payload = { variable = \"gripper.payload\", offset_deg = 3 }",
        &["offset_deg is for angles"],
    ),
    ("[[robot.joint]]", "urdf = \"mesh.urdf\"\n[[robot.joint]]", &["axis", "remove `axis` and `origin` here"]),
];

/// Robot descriptions with mistakes, beside the cell file.
const DESCRIPTIONS: &[(&str, &str)] = &[
    ("bad.urdf", "<robot name=\"r\">\n<link name=\"a\"></lnk>\n</robot>\n"),
    (
        "loop.urdf",
        "<robot name=\"r\">\n<link name=\"a\"/>\n<link name=\"b\"/>\n<joint name=\"joint_1\" type=\"fixed\"><parent \
         link=\"a\"/><child link=\"b\"/></joint>\n<joint name=\"joint_2\" type=\"fixed\"><parent link=\"b\"/><child \
         link=\"a\"/></joint>\n</robot>\n",
    ),
    (
        "kinds.urdf",
        "<robot name=\"r\">\n<link name=\"l0\"/><link name=\"l1\"/><link name=\"l2\"/><link name=\"l3\"/><link \
         name=\"l4\"/><link name=\"l5\"/><link name=\"l6\"/>\n<joint name=\"joint_1\" type=\"prismatic\"><parent \
         link=\"l0\"/><child link=\"l1\"/></joint><joint name=\"joint_2\" type=\"revolute\"><parent link=\"l1\"/><child \
         link=\"l2\"/></joint><joint name=\"joint_3\" type=\"revolute\"><parent link=\"l2\"/><child \
         link=\"l3\"/></joint><joint name=\"joint_4\" type=\"revolute\"><parent link=\"l3\"/><child \
         link=\"l4\"/></joint><joint name=\"joint_5\" type=\"revolute\"><parent link=\"l4\"/><child \
         link=\"l5\"/></joint><joint name=\"joint_6\" type=\"revolute\"><parent link=\"l5\"/><child \
         link=\"l6\"/></joint>\n</robot>\n",
    ),
    ("mesh.urdf", "<robot name=\"r\">\n<link name=\"a\"/>\n</robot>\n"),
];

/// A box in millimetres without one of its triangles, and with one turned.
fn meshes_with_flaws(folder: &Path) {
    let (points, mut triangles) = meshes::cuboid([0.0; 3], [100.0; 3]);
    write(folder, "open.stl", &meshes::stl(&points, &triangles[1..]));
    triangles[0].swap(0, 1);
    write(folder, "turned.stl", &meshes::stl(&points, &triangles));
}

#[test]
fn mistakes_in_the_cell_file_are_named_with_their_line_and_a_way_out() {
    let dir = examples();
    let cell = std::fs::read_to_string(dir.path().join("safety-fence/cell.toml")).unwrap();
    for (name, text) in DESCRIPTIONS {
        write(&dir.path().join("safety-fence"), name, text);
    }
    meshes_with_flaws(&dir.path().join("safety-fence"));
    assert!(CELL_MISTAKES.len() >= 60);
    for (from, to, words) in CELL_MISTAKES {
        assert!(cell.contains(from), "{from}");
        let wrong = write(dir.path(), "safety-fence/wrong.toml", &cell.replacen(from, to, 1));
        let text = fails(dir.path(), "safety-fence/wrong.toml", 2, words);
        // Every one: in which file and line, and what to do.
        let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains("help:"), "{from} -> {to}: no help in:\n{text}");
        let lines = text.matches(".toml:").count() + text.matches(".urdf:").count();
        let somewhere = lines > 0 || text.contains("fail_on.baseline");
        assert!(somewhere, "{from} -> {to}: no line in:\n{text}");
        std::fs::remove_file(wrong).unwrap();
    }
}

#[test]
fn a_cell_without_robot_geometry_is_refused() {
    let dir = examples();
    let cell = std::fs::read_to_string(dir.path().join("safety-fence/cell.toml")).unwrap();
    let lines: Vec<&str> = cell.split("[[robot.link]]").collect();
    let rest = lines.last().unwrap().split_once("# The fence").unwrap().1;
    write(dir.path(), "safety-fence/bare.toml", &format!("{}# The fence{rest}", lines[0]));
    fails(dir.path(), "safety-fence/bare.toml", 2, &["no robot geometry", "[[robot.link]]"]);
}

/// A faulty FMU beside its cell, in a fresh folder.
fn faulty(kind: i32, step: i32) -> tempfile::TempDir {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::copy(test_fmus().join("faulty.fmu"), dir.path().join("faulty.fmu")).unwrap();
    write(dir.path(), "cell.toml", &faulty_cell("faulty.fmu", kind, step));
    dir
}

#[test]
fn an_fmu_that_fails_from_the_start_is_exit_code_3() {
    for (kind, words) in [(1, "NaN"), (2, "fmi2DoStep"), (3, "iscard"), (4, "atal"), (9, "infinite")] {
        fails(faulty(kind, 5).path(), "cell.toml", 3, &[words, "--self-test"]);
    }
}

#[test]
fn an_fmu_that_does_not_repeat_itself_in_a_process_gets_fresh_ones_or_is_refused() {
    let dir = faulty(5, 0);
    let scan = |extra: &[&str]| {
        let output = fmi_hazard(dir.path())
            .args(["scan", "--from", "start", "--no-advice", "cell.toml", "--out", "o"])
            .args(extra)
            .output()
            .unwrap();
        (output.status.code().unwrap(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (code, text) = scan(&["--in-process"]);
    assert!(code == 3 && text.contains("different outputs for the same inputs"), "{text}");
    assert!(text.contains("deterministic"), "{text}");
    let (code, text) = scan(&["--strategy", "random"]);
    assert!(code != 3 && text.contains("copies of the FMU's process"), "{text}");
    assert_eq!(crate::common::json(&dir.path().join("o/run.json"))["states_by"], "copies");
}

#[test]
fn a_state_that_lies_is_not_used_and_the_result_is_the_same() {
    let results: Vec<_> = [0, 6, 7, 8]
        .iter()
        .map(|&kind| {
            let dir = faulty(kind, 0);
            let _ = fmi_hazard(dir.path())
                .args(["scan", "--no-advice", "cell.toml", "--strategy", "mcts-dpw", "--out", "o"])
                .output();
            let scan = scan_json(&dir.path().join("o"));
            let restore = scan["self_test"]["restore"]["result"].as_str().unwrap().to_owned();
            assert_eq!(restore == "exact", kind == 0 || kind == 8, "fault {kind}: {restore}");
            assert_eq!(scan["self_test"]["reset"]["result"] == "exact", kind != 8, "fault {kind}");
            scan["coverage"].clone()
        })
        .collect();
    assert_eq!(results[0], results[1]);
    assert_eq!(results[0], results[2]);
    assert_eq!(results[0], results[3]);
}

#[test]
fn a_cell_in_which_no_sensor_can_fire_is_inconclusive() {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::copy(test_fmus().join("faulty.fmu"), dir.path().join("faulty.fmu")).unwrap();
    // The person starts too far away to reach the mat, or the robot, within the horizon.
    let cell = faulty_cell("faulty.fmu", 0, 0).replace("xy_m = [0, -1.6]", "xy_m = [0, -6]");
    write(dir.path(), "cell.toml", &cell);
    let output = fmi_hazard(dir.path())
        .args(["scan", "--from", "start", "--no-advice", "cell.toml", "--out", "o"])
        .assert()
        .code(4)
        .get_output()
        .clone();
    let text = String::from_utf8(output.stdout).unwrap();
    for words in [
        "not shown because turntable was never near enough",
        "Sensors report people: no sensor ever reported the person",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert_eq!(scan_json(&dir.path().join("o"))["verdict"], "inconclusive");
}

#[test]
fn a_cell_that_reads_nothing_from_its_fmu_is_refused() {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::copy(test_fmus().join("faulty.fmu"), dir.path().join("faulty.fmu")).unwrap();
    let cell = faulty_cell("faulty.fmu", 0, 0);
    let held = cell
        .replace("angle = { variable = \"q\", unit = \"rad\" }", "held_deg = 30")
        .replace("speed = { variable = \"qd\", unit = \"rad/s\" }\n", "");
    assert!(held.contains("held_deg") && !held.contains("speed ="));
    write(dir.path(), "cell.toml", &held);
    fails(dir.path(), "cell.toml", 2, &["nothing is read from the FMU", "at least one joint or frame"]);
}
