//! From an FMU to a cell file: `init`, `check` and `probe`.

use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

use crate::common::{examples, fmi_hazard, json, scan_json, write};
use crate::sample;

const CELLS: [&str; 10] = [
    "safety-fence",
    "sensor-mat",
    "two-scanners",
    "light-curtain",
    "heavy-workpiece",
    "head-collision",
    "hand-at-table",
    "wall-behind",
    "sharp-workpiece",
    "short-zone",
];

/// Exit code, stdout and stderr without line breaks and box drawing.
fn run(dir: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr).replace(['│', '\n'], " ");
    assert!(!stderr.contains("panicked"), "{stderr}");
    let stderr = stderr.split_whitespace().collect::<Vec<_>>().join(" ");
    (output.status.code().unwrap(), String::from_utf8(output.stdout).unwrap(), stderr)
}

/// Each robot's variables in order, and the sensors with polarity and whether they are inside the FMU.
#[derive(Debug, PartialEq)]
struct Bound {
    robots: BTreeSet<Vec<String>>,
    sensors: BTreeMap<String, (bool, bool)>,
    payload: BTreeSet<String>,
    pose: BTreeSet<String>,
    inputs: BTreeMap<String, String>,
}

fn bound(text: &str) -> Bound {
    let table: toml::Table = text.parse().unwrap();
    let list = |key: &str| table.get(key).and_then(toml::Value::as_array).cloned().unwrap_or_default();
    let name = |value: &toml::Value| value.as_str().unwrap().to_owned();
    let mut found = Bound {
        robots: BTreeSet::new(),
        sensors: BTreeMap::new(),
        payload: BTreeSet::new(),
        pose: BTreeSet::new(),
        inputs: BTreeMap::new(),
    };
    for robot in list("robot") {
        let mut variables = Vec::new();
        for joint in robot.get("joint").and_then(toml::Value::as_array).into_iter().flatten() {
            variables.extend(["angle", "speed"].map(|key| name(&joint[key]["variable"])));
        }
        for frame in robot.get("frame").and_then(toml::Value::as_array).into_iter().flatten() {
            for key in ["position", "quaternion", "velocity", "angular_velocity"] {
                variables.extend(frame[key].as_array().unwrap().iter().map(name));
            }
        }
        found.robots.insert(variables);
        found.payload.extend(robot.get("payload").map(|payload| name(&payload["variable"])));
    }
    for sensor in list("sensor") {
        let inside = sensor["kind"].as_str() == Some("reported");
        found.sensors.insert(name(&sensor["variable"]), (sensor["active"].as_bool().unwrap(), inside));
    }
    let pose = table.get("pose").and_then(toml::Value::as_table).cloned().unwrap_or_default();
    found.pose.extend(pose.iter().map(|(key, value)| format!("{key} {}", value.as_str().unwrap())));
    let inputs = table.get("inputs").and_then(toml::Value::as_table).cloned().unwrap_or_default();
    found.inputs.extend(inputs.iter().map(|(key, value)| (key.clone(), value.to_string())));
    found
}

#[test]
fn init_guesses_every_joint_sensor_and_input_of_the_examples() {
    let dir = examples();
    for cell in CELLS {
        for suffix in ["", "-fmi3"] {
            let fmu = format!("{cell}/{cell}{suffix}.fmu");
            let (code, out, said) = run(dir.path(), &["init", &fmu, "--out", "first.toml", "--force"]);
            assert!(code == 0 && out == "first.toml\n" && said.contains("fill in"), "{fmu}: {code} {said}");
            let first = std::fs::read_to_string(dir.path().join("first.toml")).unwrap();
            let expected = std::fs::read_to_string(dir.path().join(cell).join("cell.toml")).unwrap();
            assert_eq!(bound(&first), bound(&expected), "{fmu}");
            assert!(first.starts_with("#:schema ./cell.schema.json\n"));
            // What cannot be known is asked for, and a check says so line by line.
            let (code, out, _) = run(dir.path(), &["check", "first.toml"]);
            assert!(code == 2 && out.contains("where the person begins") && out.contains("problems"), "{out}");
            // Once: what is told as missing, with its place, is no line to be filled in as well.
            let (_, out, _) = run(dir.path(), &["check", "first.toml", "--format", "json"]);
            let told: serde_json::Value = serde_json::from_str(&out).unwrap();
            let problems = told["problems"].as_array().unwrap();
            let about = |words: &str| problems.iter().filter(|p| p.to_string().contains(words)).count();
            assert_eq!(about("still to be filled in: #"), 0, "{out}");
            assert!(about("hull_m") == about("moving_mass_kg") && about("where its base stands") > 0, "{out}");
        }
    }
    assert!(json(&dir.path().join("cell.schema.json"))["properties"]["robot"].is_object());
}

#[test]
fn init_asks_nothing_without_a_terminal_and_replaces_nothing() {
    let dir = examples();
    let fmu = "sensor-mat/sensor-mat.fmu";
    let (code, _, said) = run(dir.path(), &["init", fmu, "--urdf", "robots/ur10e.urdf", "--out", "sub.toml"]);
    assert!(code == 0 && !said.contains('?'), "{said}");
    let text = std::fs::read_to_string(dir.path().join("sub.toml")).unwrap();
    assert!(
        text.contains("fmu = \"sensor-mat/sensor-mat.fmu\"\n") && text.contains("urdf = \"robots/ur10e.urdf\"\n"),
        "{text}"
    );
    let (code, _, said) = run(dir.path(), &["init", fmu, "--out", "sub.toml"]);
    assert!(code == 2 && said.contains("is there already") && said.contains("--force"), "{said}");
    assert_eq!(std::fs::read_to_string(dir.path().join("sub.toml")).unwrap(), text);
    // Filled in, it is a cell: the robot of the URDF, moved by this FMU.
    let filled = text
        .replace(
            "# zone = { polygon_m = [[-1, -2], [1, -2], [1, -1], [-1, -1]] } # TODO corners on the floor",
            "zone = { polygon_m = [[-1, -2], [1, -2], [1, -1], [-1, -1]] }",
        )
        .replace(" # TODO where its base stands", "")
        .replace(" # TODO where the person begins and looks (0: +x, 90: +y)", "");
    write(dir.path(), "filled.toml", &filled);
    let (code, out, said) = run(dir.path(), &["check", "filled.toml"]);
    assert!(code == 0 && out.contains("29.1 kg moving") && out.contains("nothing wrong"), "{out} {said}");
}

#[test]
fn check_tells_all_problems_at_once_and_draws_what_is_right() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    for cell in CELLS {
        let (code, out, said) = run(dir.path(), &["check", &format!("{cell}/cell.toml")]);
        assert!(code == 0 && out.contains("nothing wrong"), "{cell}: {out} {said}");
        let picture = std::fs::read_to_string(dir.path().join(cell).join("cell.check.svg")).unwrap();
        assert!(picture.starts_with("<svg") && picture.contains("the cell from above"), "{cell}");
        let parts = |what: &str| picture.matches(what).count();
        assert!(parts("<circle") > 100 && parts("#dd6b20") > 20, "{cell}: places and robots are drawn");
    }
    let text = std::fs::read_to_string(dir.path().join("sensor-mat/cell.toml")).unwrap();
    let mut wrong = text.clone();
    let mistakes = [
        ("schema = 1", "schema = 2", "format 2"),
        ("robot.q[3]", "robot.q[7]", "`robot.q[7]` is not in sensor-mat.fmu"),
        ("robot.qd[5]", "robot.qqd[5]", "`robot.qqd[5]` is not in sensor-mat.fmu"),
        ("axis = [0, 0, 1]", "axis = [0, 0, 0]", "no direction"),
        ("\"plc.mat_clear\"", "\"robot.q[1]\"", "not an input"),
        ("joint = \"joint_6\"", "joint = \"joint_66\"", "no joint `joint_66`"),
        ("heading_deg", "# TODO which way\nheading_deg", "which way"),
    ];
    for (from, to, _) in &mistakes[..6] {
        assert!(wrong.contains(from), "{from}");
        wrong = wrong.replacen(from, to, 1);
    }
    wrong.push_str("# TODO which way\n");
    write(dir.path(), "sensor-mat/wrong.toml", &wrong);
    let (code, out, said) = run(dir.path(), &["check", "sensor-mat/wrong.toml"]);
    assert_eq!(code, 2);
    for (.., words) in &mistakes {
        assert!(said.contains(words) || out.contains(words), "`{words}`: {out} {said}");
    }
    assert!(out.contains("wrong.toml: 7 problems"), "{out}");
    let (_, out, _) = run(dir.path(), &["check", "sensor-mat/wrong.toml", "--format", "json"]);
    let told: serde_json::Value = serde_json::from_str(&out).unwrap();
    let problems = told["problems"].as_array().unwrap();
    assert_eq!(problems.len(), 7);
    for problem in problems {
        assert!(problem["line"].as_u64().is_some() && problem["help"].as_str().is_some(), "{problem}");
    }
    // A value of another type, or of another length, hides nothing: neither others of them, nor what is wrong otherwise; and
    // what stands in for it is not complained about.
    let mut types = text.clone();
    let mistakes = [
        ("step_s = 0.02", "step_s = \"fast\"", "string \"fast\""),
        ("moving_mass_kg = ", "moving_mass_kg = \"heavy\" #", "string \"heavy\""),
        ("axis = [0, 0, 1]", "axis = [0, 0]", "invalid length 2"),
        ("name = \"joint_3\"", "name = 3", "integer `3`"),
        ("kind = \"mat\"", "kind = \"matt\"", "unknown variant `matt`"),
        ("active = false", "active = \"false\"", "string \"false\""),
        ("payload =", "payloat =", "unknown field `payloat`"),
        ("robot.q[4]", "robot.q[7]", "`robot.q[7]` is not in sensor-mat.fmu"),
        ("joint = \"joint_6\"", "joint = \"joint_66\"", "no joint `joint_66`"),
        ("joint = \"joint_3\"", "joint = \"3\"", ""),
    ];
    for (from, to, _) in &mistakes {
        assert!(types.contains(from), "{from}");
        types = types.replacen(from, to, 1);
    }
    write(dir.path(), "sensor-mat/types.toml", &types);
    let (code, out, said) = run(dir.path(), &["check", "sensor-mat/types.toml", "--no-run"]);
    for (.., words) in &mistakes {
        assert!(said.contains(words), "`{words}`: {said}");
    }
    assert!(code == 2 && out.contains("types.toml: 9 problems"), "{out} {said}");
    let (code, _, said) = run(dir.path(), &["scan", "--no-advice", "sensor-mat/types.toml"]);
    assert!(code == 2 && said.contains("integer `3`") && said.contains("no joint `joint_66`"), "{said}");
    // Unknown keys do not hide one another.
    let unknown = text.replacen("moving_mass_kg", "moving_mas_kg", 1).replacen("heading_deg", "heding_deg", 1);
    let unknown = unknown.replacen("payload =", "payloat =", 1).replacen("phase =", "phases =", 1);
    write(dir.path(), "sensor-mat/unknown.toml", &unknown);
    let (_, _, said) = run(dir.path(), &["check", "sensor-mat/unknown.toml", "--no-run"]);
    for key in ["moving_mas_kg", "payloat", "phases"] {
        assert!(said.contains(&format!("unknown field `{key}`")), "{key}: {said}");
    }
}

#[test]
fn probe_finds_what_stops_the_robot_after_how_long_and_with_which_polarity() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let dir = examples();
    // By the FMU alone: a mat that stops, a field that slows down, a curtain that stops; from scenarios.md: the mat's
    // controller reacts after 0.06 s and ramps down in 0.3 s.
    for (cell, input, effect, active) in [
        ("sensor-mat", "plc.mat_clear", "stops", Some(false)),
        ("light-curtain", "plc.curtain_clear", "stops", Some(false)),
        ("head-collision", "plc.field_clear", "slows", Some(false)),
        ("safety-fence", "plc.guard_closed", "stops", Some(false)),
    ] {
        let fmu = format!("{cell}/{cell}.fmu");
        let (code, out, said) = run(dir.path(), &["inspect", "--run", &fmu, "--fmu-only", "--format", "json"]);
        assert_eq!(code, 0, "{said}");
        let told: serde_json::Value = serde_json::from_str(&out).unwrap();
        assert!(told["fastest"].as_f64().unwrap() > 0.1, "{cell}: {out}");
        let reactions = told["reactions"].as_array().unwrap();
        let reaction = reactions.iter().find(|reaction| reaction["input"] == input).unwrap_or_else(|| panic!("{out}"));
        assert_eq!(reaction["effect"], effect, "{cell}: {out}");
        assert_eq!(reaction["idle"].as_bool(), active.map(|active| !active), "{cell}");
        let first = reaction["first_change_s"].as_f64().unwrap();
        assert!(first > 0.0 && first < 0.2, "{cell}: first change after {first} s");
        let (_, table, _) = run(dir.path(), &["inspect", "--run", &fmu, "--fmu-only"]);
        assert!(table.contains("so active = false would mean a person"), "{table}");
    }
    let (_, out, _) =
        run(dir.path(), &["inspect", "--run", "sensor-mat/sensor-mat.fmu", "--fmu-only", "--format", "json"]);
    let told: serde_json::Value = serde_json::from_str(&out).unwrap();
    let mat = told["reactions"].as_array().unwrap().iter().find(|r| r["input"] == "plc.mat_clear").unwrap().clone();
    assert!((mat["still_after_s"].as_f64().unwrap() - 0.35).abs() < 0.03, "{mat}");
}

#[test]
fn a_wrong_polarity_is_told_before_a_scan() {
    let dir = examples();
    let cells = [("sensor-mat", "stand still"), ("light-curtain", "stand still"), ("head-collision", "are slower")];
    for (cell, effect) in sample::some(cells, 3) {
        let folder = dir.path().join(cell);
        let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
        let wrong = text.replacen("active = false", "active = true", 1);
        assert_ne!(text, wrong);
        write(&folder, "wrong.toml", &wrong);
        let scan = ["scan", "--no-advice", "wrong.toml", "--out", "o", "--iterations", "5", "--strategy", "random"];
        let (_, _, said) = run(&folder, &scan);
        let (warned, searched) = (said.find("wrong polarity").unwrap(), said.find("iterations").unwrap());
        assert!(
            warned < searched
                && said.contains(effect)
                && said.contains("then active = false")
                && said.contains("flaw of the cell"),
            "{cell}: {said}"
        );
        let warnings = scan_json(&folder.join("o"))["warnings"].to_string();
        assert!(warnings.contains("wrong polarity"), "{warnings}");
        let (_, out, said) = run(&folder, &["check", "wrong.toml"]);
        assert!(said.contains("wrong polarity"), "{said}");
        assert!(
            out.contains("nothing wrong that keeps it from being scanned; ") && out.ends_with("to read\n"),
            "{out}"
        );
        // And not where it is right.
        let right = ["scan", "--no-advice", "cell.toml", "--out", "r", "--iterations", "5", "--strategy", "random"];
        assert!(!run(&folder, &right).2.contains("wrong polarity"));
        assert!(!run(&folder, &["check", "cell.toml"]).2.contains("Warning"));
    }
}

/// A guard that is held open keeps the robot from moving, and nobody is hit: two names that changed places in [inputs]. The scan has no
/// hazard, and says so with what it rests on.
#[test]
fn an_input_that_holds_robots_back_is_told() {
    let dir = examples();
    let folder = dir.path().join("safety-fence");
    let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let exchanged = text
        .replacen("\"plc.guard_closed\"", "\"other\"", 1)
        .replacen("\"plc.reset\"", "\"plc.guard_closed\"", 1)
        .replacen("\"other\"", "\"plc.reset\"", 1);
    write(&folder, "exchanged.toml", &exchanged);
    let scan = ["scan", "exchanged.toml", "--no-advice", "--from", "start", "--out", "o"];
    let (code, out, said) = run(&folder, &scan);
    let told = "input `plc.guard_closed` is false all the time, and robots move when it is true";
    assert!(code == 0 && said.contains(told), "{code} {out}{said}");
    assert!(scan_json(&folder.join("o"))["warnings"].to_string().contains(told));
    assert!(run(&folder, &["check", "exchanged.toml"]).2.contains(told));
}

/// Name, compressed bytes and checksum of every entry.
fn entries(path: &Path) -> BTreeMap<String, (Vec<u8>, u32)> {
    use std::io::Read as _;
    let mut archive = zip::ZipArchive::new(std::fs::File::open(path).unwrap()).unwrap();
    let mut all = BTreeMap::new();
    for index in 0..archive.len() {
        let mut entry = archive.by_index_raw(index).unwrap();
        let mut bytes = Vec::new();
        entry.read_to_end(&mut bytes).unwrap();
        all.insert(entry.name().unwrap().into_owned(), (bytes, entry.crc32()));
    }
    all
}

#[test]
fn a_packed_fmu_is_scanned_alone_and_is_otherwise_the_same() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    std::fs::create_dir(folder.join("geometry")).unwrap();
    std::fs::copy(dir.path().join("robots/ur10e.urdf"), folder.join("geometry/ur10e.urdf")).unwrap();
    let (code, ..) = run(&folder, &["init", "sensor-mat.fmu", "--urdf", "geometry/ur10e.urdf", "--out", "first.toml"]);
    assert_eq!(code, 0);
    let text = std::fs::read_to_string(folder.join("first.toml")).unwrap();
    let text = text.replace(
        "# zone = { polygon_m = [[-1, -2], [1, -2], [1, -1], [-1, -1]] }",
        "zone = { polygon_m = [[-1, -2], [1, -2], [1, -1], [-1, -1]] }",
    );
    write(&folder, "first.toml", &text);
    let (code, out, said) = run(&folder, &["pack", "first.toml"]);
    assert!(code == 0 && out == "sensor-mat-packed.fmu\n", "{out} {said}");
    let (code, _, said) = run(&folder, &["pack", "first.toml"]);
    assert!(code == 2 && said.contains("--force"), "{said}");
    let (before, mut after) = (entries(&folder.join("sensor-mat.fmu")), entries(&folder.join("sensor-mat-packed.fmu")));
    for name in ["cell.toml", "geometry/ur10e.urdf"] {
        assert!(after.remove(&format!("extra/io.github.fmi-hazard/{name}")).is_some(), "{name}");
    }
    assert!(!after.is_empty());
    for (name, entry) in &after {
        assert_eq!(before.get(name), Some(entry), "{name}");
    }
    // Nothing else is needed.
    let alone = tempfile::TempDir::new().unwrap();
    std::fs::copy(folder.join("sensor-mat-packed.fmu"), alone.path().join("x.fmu")).unwrap();
    let budget = ["--iterations", "20", "--strategy", "random"];
    let scan = |dir: &Path, what: &str| {
        let (code, _, said) = run(dir, &[&["scan", "--no-advice", what, "--out", "o"], &budget[..]].concat());
        assert!([0, 1, 4].contains(&code), "{said}");
        scan_json(&dir.join("o"))
    };
    let (packed, beside) = (scan(alone.path(), "x.fmu"), scan(&folder, "first.toml"));
    assert_eq!(packed["hazards"], beside["hazards"]);
    assert_eq!(packed["coverage"], beside["coverage"]);
    assert_eq!(packed["subject"]["files"], beside["subject"]["files"]);
    assert!(packed["subject"]["cell_found"].as_str().unwrap().contains("x.fmu!extra/"));
    crate::common::fmpy::compare(&folder, &folder.join("sensor-mat-packed.fmu"));
    // What is outside the folder cannot travel.
    let (code, _, said) = run(
        dir.path(),
        &["init", "sensor-mat/sensor-mat.fmu", "--urdf", "robots/ur10e.urdf", "--out", "sensor-mat/out.toml"],
    );
    assert_eq!(code, 0, "{said}");
    let text = std::fs::read_to_string(folder.join("out.toml")).unwrap();
    write(&folder, "out.toml", &text.replace("# zone = { polygon_m", "zone = { polygon_m"));
    let (code, _, said) = run(&folder, &["pack", "out.toml", "--force"]);
    assert!(code == 2 && said.contains("outside the folder of the cell file"), "{said}");
}

/// A robot with one joint and one link, whose shape is in a mesh of package `arm`.
const ARM: &str = "<robot name=\"r\"><link name=\"base\"/><link name=\"bar\"><inertial><mass value=\"20\"/></inertial>\
    <collision><geometry><mesh filename=\"package://arm/meshes/bar.stl\"/></geometry></collision></link>\
    <joint name=\"table\" type=\"revolute\"><parent link=\"base\"/><child link=\"bar\"/><axis xyz=\"0 0 1\"/></joint></robot>";

/// A folder with a turning FMU, and a robot and its mesh at these places.
fn with_package(urdf: &str, mesh: &str) -> tempfile::TempDir {
    let dir = tempfile::TempDir::new().unwrap();
    let (points, triangles) = fmi_hazard_sample::meshes::cuboid([0.0, -0.05, 0.8], [0.8, 0.05, 0.9]);
    for (name, text) in [(urdf, ARM.to_owned()), (mesh, fmi_hazard_sample::meshes::stl(&points, &triangles))] {
        std::fs::create_dir_all(dir.path().join(name).parent().unwrap()).unwrap();
        write(dir.path(), name, &text);
    }
    std::fs::create_dir(dir.path().join("mine")).unwrap();
    std::fs::copy(crate::common::test_fmus().join("faulty.fmu"), dir.path().join("mine/x.fmu")).unwrap();
    dir
}

/// A cell that `init` wrote with everything filled in.
fn filled(dir: &Path, name: &str) {
    let text = std::fs::read_to_string(dir.join(name)).unwrap();
    // What the stop is for cannot be known; the robot turns without it.
    let tables = text.split("\n\n").filter(|table| !table.starts_with("[[sensor]]")).collect::<Vec<_>>().join("\n\n");
    let lines: Vec<&str> = tables.lines().map(|line| line.split(" # TODO").next().unwrap()).collect();
    write(dir, name, &lines.join("\n"));
}

#[test]
fn init_and_check_find_packages_of_robots_in_the_same_places() {
    for (urdf, mesh) in [
        ("arm/urdf/x.urdf", "arm/meshes/bar.stl"),
        ("arm/robots/x.urdf", "arm/meshes/bar.stl"),
        ("x.urdf", "arm/meshes/bar.stl"),
        ("opt/share/other/urdf/x.urdf", "opt/share/arm/meshes/bar.stl"),
    ] {
        let dir = with_package(urdf, mesh);
        let work = dir.path().join("mine");
        let named = format!("../{urdf}");
        let (code, _, said) = run(&work, &["init", "x.fmu", "--urdf", &named, "--out", "c.toml"]);
        assert!(code == 0 && !said.contains("kinematics only"), "{urdf}: {said}");
        let text = std::fs::read_to_string(work.join("c.toml")).unwrap();
        assert!(!text.contains("urdf_shapes") && !text.contains("packages"), "{urdf}: {text}");
        filled(&work, "c.toml");
        let (code, out, said) = run(&work, &["check", "c.toml"]);
        assert!(code == 0 && out.contains("1 shapes, 20.0 kg"), "{urdf}: {out} {said}");
    }
}

#[test]
fn packages_elsewhere_are_named_once_and_stay_in_the_cell_file() {
    let dir = with_package("robot/x.urdf", "far/workspace/src/of/arm/meshes/bar.stl");
    let work = dir.path().join("mine");
    let init = |more: &[&str], variables: &[(&str, &str)]| {
        let arguments = ["init", "x.fmu", "--urdf", "../robot/x.urdf", "--out", "c.toml", "--force"];
        let mut command = fmi_hazard(&work);
        command.args(arguments).args(more).env_remove("ROS_PACKAGE_PATH").env_remove("AMENT_PREFIX_PATH");
        let output = command.envs(variables.iter().copied()).output().unwrap();
        let text = std::fs::read_to_string(work.join("c.toml")).unwrap_or_default();
        (output.status.code(), text, crate::common::archives::flat(&String::from_utf8_lossy(&output.stderr)))
    };
    // Nowhere: every place is named, and the way out.
    let (code, text, said) = init(&[], &[]);
    assert!(code == Some(0) && text.contains("urdf_shapes = false"), "{text}");
    let squeezed = said.split_whitespace().collect::<String>();
    for words in ["robot,", "share/arm", "/mine/arm", "ROS_PACKAGE_PATHisnotset", "--packagearm=FOLDER"] {
        assert!(squeezed.contains(words), "{words}: {said}");
    }
    assert!(squeezed.contains(&dir.path().display().to_string()), "{said}");
    let src = dir.path().join("far/workspace/src");
    let path = format!("/nowhere:{}", src.display());
    let by_option = init(&["--package", "arm=../far/workspace/src/of/arm"], &[]);
    for (code, text, said) in [by_option, init(&[], &[("ROS_PACKAGE_PATH", &path)])] {
        assert!(code == Some(0) && !text.contains("urdf_shapes"), "{said} {text}");
        assert!(text.contains("packages = { \"arm\" = \"../far/workspace/src/of/arm\" }"), "{text}");
        write(&work, "c.toml", &text);
        filled(&work, "c.toml");
        let (code, out, said) = run(&work, &["check", "c.toml"]);
        assert!(code == 0 && out.contains("1 shapes, 20.0 kg"), "{out} {said}");
    }
    let (code, _, said) = init(&["--package", "arm=nowhere"], &[]);
    assert!(code == Some(2) && said.contains("no folder nowhere"), "{said}");
}

#[test]
fn probe_tells_each_input_that_it_tried_also_with_a_cell() {
    let dir = examples();
    let (code, out, said) = run(dir.path(), &["inspect", "--run", "safety-fence/safety-fence.fmu"]);
    assert_eq!(code, 0, "{said}");
    assert!(out.contains("input     plc.guard_closed = false: stops it, at rest after"), "{out}");
    assert!(out.contains("input     plc.reset = true: changes nothing"), "{out}");
    // A sensor by its own name, an input of the cell file by its variable.
    let (_, out, _) = run(dir.path(), &["inspect", "--run", "sensor-mat/cell.toml"]);
    assert!(
        out.contains("input     mat = false: at ")
            && out.contains("stops it")
            && out.contains("input     plc.reset = true: "),
        "{out}"
    );
    // One that the cell file leaves alone is tried as well; one that is a number is named.
    std::fs::copy(crate::common::test_fmus().join("faulty.fmu"), dir.path().join("x.fmu")).unwrap();
    let cell = crate::common::faulty_cell("x.fmu", 0, 0);
    let (before, after) = cell.split_once("[[sensor]]").unwrap();
    let (_, after) = after.split_once("[parameters]").unwrap();
    write(dir.path(), "x.toml", &format!("{before}[parameters]{after}"));
    let (code, out, said) = run(dir.path(), &["inspect", "--run", "x.toml"]);
    assert!(code == 0 && out.contains("input     stop = true: stops it"), "{out} {said}");
    assert!(out.contains("not tried push: only inputs that are true or false are"), "{out}");
}
