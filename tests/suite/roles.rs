//! What variables are for, guessed from their names: right for every example, and for most names that robots, safety PLCs and
//! published FMUs use.

use std::collections::BTreeMap;

use crate::common::archives::{run, with_xml};
use crate::common::{examples, faulty_cell, fmi_hazard, write};
use fmi_hazard::cell::draft::interface::Interface;
use fmi_hazard::cell::draft::roles::{Guess, Role, guess};
use fmi_hazard::cell::draft::{Facts, draft};
use fmi_hazard::fmi::{Fmu, ModelDescription};

/// A description with these variables: causality, type and name, unit.
fn description(variables: &[(&str, &str, &str)]) -> ModelDescription {
    let (mut listed, mut outputs) = (String::new(), String::new());
    let mut units: Vec<&str> = variables.iter().map(|(.., unit)| *unit).filter(|unit| !unit.is_empty()).collect();
    units.sort_unstable();
    units.dedup();
    let units: String = units.into_iter().map(|unit| format!("<Unit name=\"{unit}\"/>")).collect();
    for (number, (causality, name, unit)) in variables.iter().enumerate() {
        let (kind, name) = name.split_once(' ').unwrap();
        let unit = if unit.is_empty() { String::new() } else { format!(" unit=\"{unit}\"") };
        let start = match (*causality, kind) {
            ("input", "Boolean") => " start=\"false\"",
            ("input", _) => " start=\"0\"",
            _ => "",
        };
        listed += &format!(
            "<ScalarVariable name=\"{name}\" valueReference=\"{number}\" causality=\"{causality}\" variability=\"{}\">\
             <{kind}{unit}{start}/></ScalarVariable>",
            if kind == "Real" { "continuous" } else { "discrete" }
        );
        if *causality == "output" {
            outputs += &format!("<Unknown index=\"{}\"/>", number + 1);
        }
    }
    let xml = format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?><fmiModelDescription fmiVersion=\"2.0\" modelName=\"m\" guid=\"g\">\
         <CoSimulation modelIdentifier=\"m\"/><UnitDefinitions>{units}</UnitDefinitions>\
         <ModelVariables>{listed}</ModelVariables><ModelStructure><Outputs>{outputs}</Outputs>\
         <InitialUnknowns>{outputs}</InitialUnknowns></ModelStructure></fmiModelDescription>"
    );
    ModelDescription::from_xml(xml.as_bytes()).unwrap().0
}

fn by_name(guesses: Vec<Guess>) -> BTreeMap<String, Role> {
    guesses.into_iter().map(|guess| (guess.variable, guess.role)).collect()
}

/// Short form of a role, as the table below has it.
fn short(role: Option<&Role>) -> String {
    let active = |active: &Option<bool>| active.map_or_else(|| "?".to_owned(), |value| value.to_string());
    match role {
        None => "-".to_owned(),
        Some(Role::JointAngle { number, .. }) => format!("angle {number}"),
        Some(Role::JointSpeed { number, .. }) => format!("speed {number}"),
        Some(Role::LinkPose { part, .. }) => format!("pose {part}"),
        Some(Role::Payload) => "payload".to_owned(),
        Some(Role::Phase) => "phase".to_owned(),
        Some(Role::SensorInput { active: a }) => format!("sensor {}", active(a)),
        Some(Role::SensorNumber { clear, detected }) => format!("number {clear:?} {detected:?}"),
        Some(Role::SensorOutput { active: a }) => format!("reported {}", active(a)),
        Some(Role::Human { quantity }) => format!("human {quantity}"),
        Some(Role::Constant) => "constant".to_owned(),
    }
}

/// Names in the wild and what they are: controllers (KUKA A1, ABB rax_1, Fanuc J1, UR's RTDE), URDF, flex-cell and UniFMU
/// FMUs, PLCopen safety blocks, OPC UA Robotics. `#` stands for 1 to 6, `0#` for 0 to 5.
const NAMES: &[(&str, &str, &str, &str)] = &[
    ("output", "Real actual_q0#", "rad", "angle"),
    ("output", "Real actual_q0#", "", "angle"),
    ("output", "Real actual_qd0#", "rad/s", "speed"),
    ("output", "Real q#", "rad", "angle"),
    ("output", "Real qd#", "rad/s", "speed"),
    ("output", "Real robot.q[#]", "", "angle"),
    ("output", "Real robot.A#_deg", "deg", "angle"),
    ("output", "Real A#", "deg", "angle"),
    ("output", "Real rax_#", "deg", "angle"),
    ("output", "Real J#", "deg", "angle"),
    ("output", "Real axis#", "deg", "angle"),
    ("output", "Real axis#.position", "rad", "angle"),
    ("output", "Real axis#.velocity", "rad/s", "speed"),
    ("output", "Real joint_#", "rad", "angle"),
    ("output", "Real Axes/Axis_#/ParameterSet/ActualPosition", "deg", "angle"),
    ("output", "Real Axes/Axis_#/ParameterSet/ActualSpeed", "deg/s", "speed"),
    ("output", "Real mechanics.axis#.phi", "rad", "angle"),
    ("output", "Real mechanics.axis#.w", "rad/s", "speed"),
    ("output", "Real payload", "kg", "payload"),
    ("output", "Real FlangeLoad", "kg", "payload"),
    ("output", "Real ParameterSet/FlangeLoad.Mass", "kg", "payload"),
    ("output", "Integer safety_mode", "", "phase"),
    ("output", "Integer OperationalMode", "", "phase"),
    ("output", "Integer program_step", "", "phase"),
    ("input", "Boolean S_ESPE_In", "", "sensor false"),
    ("input", "Boolean S_PSE_In", "", "sensor false"),
    ("input", "Boolean S_OSSD_In", "", "sensor false"),
    ("input", "Boolean S_GuardSwitch1", "", "sensor false"),
    ("input", "Boolean S_EStopIn", "", "sensor false"),
    ("input", "Boolean plc.S_PSE_Mat", "", "sensor false"),
    ("input", "Boolean plc.S_ScannerWarn", "", "sensor false"),
    ("input", "Boolean mat_clear", "", "sensor false"),
    ("input", "Boolean mat_pressed", "", "sensor true"),
    ("input", "Boolean curtain_broken", "", "sensor true"),
    ("input", "Boolean fieldA_occupied", "", "sensor true"),
    ("input", "Boolean doorClosed", "", "sensor false"),
    ("input", "Boolean reset", "", "constant"),
    ("input", "Boolean plc.ack_button", "", "constant"),
    ("output", "Boolean scanner.a.occupied", "", "reported true"),
    ("input", "Real human.x", "m", "human x"),
    ("input", "Real human.y", "m", "human y"),
    ("input", "Real human.yaw", "rad", "human heading"),
    ("input", "Real operator_x", "m", "human x"),
    ("input", "Real person_heading", "rad", "human heading"),
    ("input", "Real human.left_foot.x", "m", "human left_foot_x"),
    // Not roles that a scan uses.
    ("output", "Real actual_current_#", "A", "-"),
    ("output", "Real target_q#", "rad", "-"),
    ("output", "Real robot.torque[#]", "N.m", "-"),
    ("output", "Real temperature_#", "", "-"),
    ("output", "Real plc.cycle_time", "s", "-"),
    ("input", "Real setpoint", "rad", "-"),
];

#[test]
fn most_names_in_the_wild() {
    let (mut right, mut all, mut wrong) = (0, 0, Vec::new());
    for (causality, name, unit, expected) in NAMES {
        let zero = name.contains("0#");
        let count = if name.contains('#') { 6 } else { 1 };
        let names: Vec<String> =
            (1..=count).map(|n| name.replace("0#", &(n - 1).to_string()).replace('#', &n.to_string())).collect();
        let variables: Vec<(&str, &str, &str)> = names.iter().map(|name| (*causality, name.as_str(), *unit)).collect();
        let roles = by_name(guess(&description(&variables)));
        for (number, name) in (1..).zip(&names) {
            let (_, variable) = name.split_once(' ').unwrap();
            let numbered = ["angle", "speed"].contains(expected);
            let expected = if numbered { format!("{expected} {number}") } else { (*expected).to_owned() };
            let got = short(roles.get(variable));
            all += 1;
            if got == expected { right += 1 } else { wrong.push(format!("{variable}: {got}, not {expected}")) }
        }
        assert!(!zero || names[0].contains('0'));
    }
    let share = f64::from(right) / f64::from(all);
    assert!(share >= 0.95, "{right} of {all}; {wrong:#?}");
}

#[test]
fn joints_of_urdf_names_belong_together() {
    let names = ["shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"];
    let names = names.map(|name| format!("Real ur.{name}_joint"));
    let variables: Vec<(&str, &str, &str)> = names.iter().map(|name| ("output", name.as_str(), "rad")).collect();
    let roles = by_name(guess(&description(&variables)));
    for (number, name) in (1..).zip(&names) {
        let role = roles.get(&name["Real ".len()..]);
        assert_eq!(role, Some(&Role::JointAngle { robot: "ur".to_owned(), number }), "{name}");
    }
}

/// Roles of these variables, in short form.
fn roles_of(variables: &[(&str, &str, &str)]) -> Vec<(String, String)> {
    let guesses = guess(&description(variables)).into_iter();
    guesses.map(|guess| (guess.variable, short(Some(&guess.role)))).collect()
}

#[test]
fn limits_and_valves_are_no_joints() {
    for name in ["valve_q_max_#", "q_limits[#]", "q_lim#", "q_min[#]", "valve#_angle_limit", "valve[#].phi"] {
        let names: Vec<String> = (1..=6).map(|n| format!("Real {}", name.replace('#', &n.to_string()))).collect();
        let variables: Vec<(&str, &str, &str)> = names.iter().map(|name| ("output", name.as_str(), "rad")).collect();
        assert_eq!(roles_of(&variables), [], "{name}");
    }
    let alone = [("output", "Real q_limit", "rad"), ("output", "Real qd_limit", "rad/s")];
    assert_eq!(roles_of(&alone), []);
    assert_eq!(roles_of(&[("output", "Real valve_q_max", "rad"), ("output", "Real valve_qd_max", "rad/s")]), []);
}

#[test]
fn an_angle_and_its_speed_are_a_joint_without_a_number() {
    let joints = |names: &[(&str, &str)]| -> Vec<(String, String)> {
        let variables: Vec<(String, &str)> = names.iter().map(|(name, unit)| (format!("Real {name}"), *unit)).collect();
        roles_of(&variables.iter().map(|(name, unit)| ("output", name.as_str(), *unit)).collect::<Vec<_>>())
    };
    for (angle, speed, unit) in [
        ("q", "qd", "rad"),
        ("table.phi", "table.w", "rad"),
        ("joint_angle", "joint_speed", "deg"),
        ("turntable/position", "turntable/velocity", "rad"),
    ] {
        let expected = [(angle, "angle 1"), (speed, "speed 1")].map(|(a, b)| (a.to_owned(), b.to_owned()));
        assert_eq!(joints(&[(angle, unit), (speed, &format!("{unit}/s"))]), expected);
    }
    // Which joint a speed belongs to has to be told, and an angle alone may be anything.
    assert_eq!(joints(&[("q", "rad"), ("phi", "rad"), ("w", "rad/s")]), []);
    assert_eq!(joints(&[("q", "rad"), ("tool.w", "rad/s")]), []);
    assert_eq!(joints(&[("q", "rad"), ("qd", "deg/s")]), []);
    // Where joints are counted, another angle is none.
    let numbered = joints(&[("q1", "rad"), ("q2", "rad"), ("door.phi", "rad"), ("door.w", "rad/s")]);
    assert_eq!(numbered.len(), 2, "{numbered:?}");
}

#[test]
fn locals_are_for_what_no_output_is_for() {
    let inner = [("local", "Real arm.q[#]", "rad"), ("local", "Real arm.qd[#]", "rad/s")];
    let outer = [("output", "Real out.q[#]", "rad")];
    let all = |of: &[(&'static str, &'static str, &'static str)]| {
        let names: Vec<(&str, String, &str)> = of
            .iter()
            .flat_map(|(causality, name, unit)| {
                (1..=6).map(move |n: u8| (*causality, name.replace('#', &n.to_string()), *unit))
            })
            .collect();
        let variables: Vec<(&str, &str, &str)> = names.iter().map(|(c, n, u)| (*c, n.as_str(), *u)).collect();
        guess(&description(&variables))
    };
    let found = all(&inner);
    assert_eq!(found.len(), 12);
    assert!(found.iter().all(|guess| guess.local && guess.confidence < 0.95), "{found:?}");
    // The joints are told outside, their speeds only inside.
    let found = all(&[&outer[..], &inner].concat());
    let angles: Vec<&Guess> = found.iter().filter(|g| matches!(g.role, Role::JointAngle { .. })).collect();
    assert!(angles.len() == 6 && angles.iter().all(|guess| !guess.local), "{angles:?}");
    assert_eq!(found.iter().filter(|guess| guess.local).count(), 6);
}

#[test]
fn locals_are_counted_listed_on_demand_and_bound() {
    let inside = |x: &str| {
        let (before, rest) = x.split_once("<Outputs>").unwrap();
        let (_, after) = rest.split_once("</InitialUnknowns>").unwrap();
        format!("{before}{after}").replace("causality=\"output\"", "causality=\"local\"")
    };
    let dir = crate::common::archives::folder_with(&with_xml(inside));
    let inspect = |more: &[&str]| {
        let (code, out, said) = run(dir.path(), &[&["inspect", "x.fmu"], more].concat());
        assert_eq!(code, 0, "{said}");
        out
    };
    let text = inspect(&[]);
    assert!(text.contains("2 locals)") && text.contains("listed with --locals"), "{text}");
    assert!(text.contains("joint angles, local") && !text.contains("Angle of the joint"), "{text}");
    let text = inspect(&["--locals"]);
    assert!(text.contains("Angle of the joint") && !text.contains("fault.kind"), "{text}");
    let (code, ..) = run(dir.path(), &["init", "x.fmu", "--out", "first.toml"]);
    let first = std::fs::read_to_string(dir.path().join("first.toml")).unwrap();
    assert!(code == 0 && first.contains("angle = { variable = \"q\" } # GUESS"), "{first}");
    write(dir.path(), "cell.toml", &faulty_cell("x.fmu", 0, 0));
    let (code, out, said) = run(dir.path(), &["check", "cell.toml"]);
    assert!(code == 0 && out.contains("moves     up to 0."), "{out} {said}");
    // Who gets a name wrong is told where they stand.
    write(dir.path(), "wrong.toml", &faulty_cell("x.fmu", 0, 0).replace("\"q\"", "\"stop\""));
    let (_, _, said) = run(dir.path(), &["check", "wrong.toml", "--no-run"]);
    assert!(said.contains("--locals"), "{said}");
}

#[test]
fn all_joints_and_sensors_of_the_examples() {
    let dir = examples();
    for example in fmi_hazard::examples::all() {
        let folder = dir.path().join(example.name);
        let cell: toml::Table = std::fs::read_to_string(folder.join("cell.toml")).unwrap().parse().unwrap();
        for (file, _) in example
            .fmus
            .iter()
            .filter(|(file, _)| file.trim_end_matches("-fmi3.fmu").trim_end_matches(".fmu") == example.name)
        {
            let roles = by_name(guess(Fmu::open(&folder.join(file)).unwrap().description()));
            let of = |name: &toml::Value| roles.get(name.as_str().unwrap());
            let mut found = 0;
            let list = |table: &toml::Table, key: &str| {
                table.get(key).and_then(|list| list.as_array().cloned()).unwrap_or_default()
            };
            for robot in list(&cell, "robot") {
                let robot = robot.as_table().unwrap().clone();
                for (number, joint) in (1..).zip(list(&robot, "joint")) {
                    assert_eq!(short(of(&joint["angle"]["variable"])), format!("angle {number}"), "{file}");
                    assert_eq!(short(of(&joint["speed"]["variable"])), format!("speed {number}"), "{file}");
                    found += 1;
                }
                for frame in list(&robot, "frame") {
                    for (key, parts) in [
                        ("position", "x y z"),
                        ("quaternion", "qw qx qy qz"),
                        ("velocity", "vx vy vz"),
                        ("angular_velocity", "wx wy wz"),
                    ] {
                        for (name, part) in frame[key].as_array().unwrap().iter().zip(parts.split(' ')) {
                            assert_eq!(short(of(name)), format!("pose {part}"), "{file}: {name}");
                        }
                    }
                    found += 1;
                }
                assert_eq!(short(of(&robot["payload"]["variable"])), "payload", "{file}");
                assert_eq!(short(of(&robot["phase"])), "phase", "{file}");
            }
            assert!(found >= 6, "{file}");
            for sensor in list(&cell, "sensor") {
                let kind = if sensor["kind"].as_str() == Some("reported") { "reported" } else { "sensor" };
                let expected = format!("{kind} {}", sensor["active"].as_bool().unwrap());
                assert_eq!(short(of(&sensor["variable"])), expected, "{file}");
            }
            for (quantity, name) in cell.get("pose").and_then(toml::Value::as_table).into_iter().flatten() {
                assert_eq!(short(of(name)), format!("human {quantity}"), "{file}");
            }
            for (name, _) in cell.get("inputs").and_then(toml::Value::as_table).into_iter().flatten() {
                let role = roles.get(name);
                assert!(matches!(role, Some(Role::Constant | Role::SensorInput { .. })), "{file}: {name} {role:?}");
            }
        }
    }
}

#[test]
fn inspect_tells_them_and_what_a_scan_would_miss() {
    let dir = examples();
    let dir = dir.path();
    let run = |arguments: &[&str]| {
        let output = fmi_hazard(dir).arg("inspect").args(arguments).output().unwrap();
        assert_eq!(output.status.code(), Some(0), "{}", String::from_utf8_lossy(&output.stderr));
        String::from_utf8(output.stdout).unwrap()
    };
    let fmu = "sensor-mat/sensor-mat.fmu";
    let text = run(&[fmu]);
    for words in [
        "this machine's is among them",
        "joint angles of robot",
        "robot.q[1] ... robot.q[6] (6)",
        "safety input (false = person)",
        "plc.mat_clear",
        "held constant",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(!text.contains("ctrl.t_ramp") && run(&[fmu, "--all"]).contains("ctrl.t_ramp"));
    let found = run(&[fmu, "--find", "PAYLOAD"]);
    assert!(found.contains("gripper.payload") && !found.contains("Speed of joint"), "{found}");
    let json: serde_json::Value = serde_json::from_str(&run(&[fmu, "--format", "json"])).unwrap();
    assert_eq!(json["runs_here"], true);
    let roles = json["roles"].as_array().unwrap();
    let mat = roles.iter().find(|role| role["variable"] == "plc.mat_clear").unwrap();
    assert_eq!((&mat["role"], &mat["active"]), (&"sensor_input".into(), &false.into()));
    // A part of a cell lacks something.
    let text = run(&["sensor-mat/sensor-mat-plc.fmu"]);
    assert!(text.contains("missing      how the robot moves") && text.contains("missing      a cell file"), "{text}");
}

/// Inputs whose names say little and whose descriptions say what they are: type, description, and the lines that a draft has of them.
const DESCRIBED: &[(&str, &str, &[&str])] = &[
    ("Boolean", "light curtain load station, TRUE = free", &["kind = \"light_curtain\"", "active = false"]),
    ("Boolean", "laser scanner, field 1; true: occupied", &["kind = \"scanner_field\"", "active = true"]),
    ("Boolean", "pressure mat (false = clear)", &["kind = \"mat\" # GUESS 0.6", "active = true"]),
    ("Boolean", "guard door 1 closed", &["[inputs]", "\"x.I1\" = true"]),
    (
        "Integer",
        "light curtain, 1 = free, 0 = interrupted",
        &["kind = \"light_curtain\"", "values = { clear = 1, detected = 0 }"],
    ),
    ("Integer", "light curtain: 7 = free; 3 = interrupted", &["values = { clear = 7, detected = 3 }"]),
    (
        "Integer",
        "area scanner (0: clear / 2: detected)",
        &["kind = \"scanner_field\"", "values = { clear = 0, detected = 2 }"],
    ),
    ("Integer", "guard door state, 4 = closed, 5 = open", &["[inputs]", "\"x.I1\" = 4"]),
    ("Real", "mat level; 1 = pressed, 0 = free", &["kind = \"mat\"", "values = { clear = 0, detected = 1 }"]),
    // What is not said is to be filled in.
    ("Integer", "light curtain", &["kind = \"light_curtain\"", "# values = { clear = 0, detected = 1 } # TODO"]),
    ("Boolean", "light curtain, 0 = not free", &["kind = \"light_curtain\"", "# active = false # TODO"]),
];

#[test]
fn descriptions_say_what_sensors_are_and_which_value_is_which() {
    for (kind, about, expected) in DESCRIBED {
        let mut of = description(&[("input", &format!("{kind} x.I1"), "")]);
        of.variables[0].description = (*about).to_owned();
        let text = draft(&Interface::of_fmu(&of), &Facts { name: "x", fmu: "x.fmu", ..Facts::default() });
        assert!(expected.iter().all(|line| text.contains(line)), "{about}: {text}");
    }
}
