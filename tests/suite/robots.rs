//! Robots from robot descriptions and meshes, and speeds that the FMU does not give: each against a second route.

use std::fmt::Write as _;
use std::path::Path;

use crate::common::archives::with_xml;
use crate::common::{assert_same_hazards, examples, faulty_cell, fmi_hazard, scan_json, write};
use fmi_hazard::cell::appearance;
use fmi_hazard::cell::binding::MotionBinding;
use fmi_hazard::cell::error::Source;
use fmi_hazard::cell::file::validate::validate;
use fmi_hazard::cell::workcell::Workcell;
use fmi_hazard::geometry::{Pose, Rotation, Solid, Vec3};
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard_sample::meshes;

/// A cell with a robot from `urdf`, its joints named as told.
fn cell_of(folder: &Path, urdf: &str, joints: &[&str], more: &str) -> Workcell {
    let mut text = format!(
        "schema = 1\nname = \"r\"\nfmu = \"r.fmu\"\n[human]\nstart = {{ xy_m = [0, -2], heading_deg = 90 }}\n\
         [[robot]]\nname = \"r\"\nurdf = \"{urdf}\"\npayload_kg = 1\n{more}"
    );
    for (number, joint) in joints.iter().enumerate() {
        let way = if joint.contains("finger") { "position" } else { "angle" };
        write!(text, "\n[[robot.joint]]\nname = \"{joint}\"\n{way} = {{ variable = \"q[{number}]\" }}\n").unwrap();
    }
    validate(&Source::new("cell.toml", &text).in_folder(folder)).map_err(|e| format!("{e}: {:?}", e.help)).unwrap()
}

const UR10E: [&str; 6] = ["shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"];

/// d, a and alpha in right angles: the makers' tables of Denavit-Hartenberg parameters.
const UR10E_DH: [(f64, f64, f64); 6] = [
    (0.1807, 0.0, 1.0),
    (0.0, -0.6127, 0.0),
    (0.0, -0.57155, 0.0),
    (0.17415, 0.0, 1.0),
    (0.11985, 0.0, -1.0),
    (0.11655, 0.0, 0.0),
];
const IIWA_DH: [(f64, f64, f64); 7] = [
    (0.36, 0.0, -1.0),
    (0.0, 0.0, 1.0),
    (0.42, 0.0, 1.0),
    (0.0, 0.0, -1.0),
    (0.4, 0.0, -1.0),
    (0.0, 0.0, 1.0),
    (0.126, 0.0, 0.0),
];

/// Rz(theta) Tz(d) Tx(a) Rx(alpha), one joint after the other.
fn tool(dh: &[(f64, f64, f64)], angles: &[f64]) -> Pose {
    dh.iter().zip(angles).fold(Pose::IDENTITY, |pose, (&(d, a, alpha), &theta)| {
        let turn = Pose::from_parts(Vec3::ZERO, Rotation::from_rotation_z(theta));
        let tilt = Rotation::from_rotation_x(alpha * std::f64::consts::FRAC_PI_2);
        pose * turn * Pose::from_parts(Vec3::new(a, 0.0, d), tilt)
    })
}

#[test]
fn public_robots_are_where_their_makers_tables_say_and_as_heavy() {
    let dir = examples();
    let iiwa: Vec<String> = (1..=7).map(|n| format!("lbr_A{n}_joint")).collect();
    let ur: Vec<String> = UR10E.iter().map(|name| format!("{name}_joint")).collect();
    let robots: [(&str, &[String], &[_], &str, f64); 2] = [
        ("robots/ur10e.urdf", &ur, &UR10E_DH, "tool0", 29.104),
        ("robots/lbr_iiwa14_r820.urdf", &iiwa, &IIWA_DH, "lbr_link_ee", 22.85),
    ];
    for (urdf, joints, dh, tip, mass) in robots {
        let joints: Vec<&str> = joints.iter().map(String::as_str).collect();
        // A sphere at the tool's centre, named by the fixed link that is there.
        let sphere = format!(
            "[[robot.link]]\nname = \"tip\"\njoint = \"{tip}\"\ncapsule = {{ from_m = [0, 0, 0], to_m = [0, 0, 0], \
             radius_m = 0.01 }}\n"
        );
        let cell = cell_of(dir.path(), urdf, &joints, &sphere);
        assert!((cell.robots[0].moving_mass_kg - mass).abs() < 1e-9, "{}", cell.robots[0].moving_mass_kg);
        assert_eq!(cell.files.len(), 1);
        let kinematics = cell.robots[0].kinematics.as_ref().unwrap();
        let tip = cell.links.iter().find(|link| link.name == "tip").unwrap();
        for round in 0..20 {
            let angle = |n: usize| 0.3 * f64::from(round) * [1.0, -0.7, 0.9, -0.4, 1.3, 0.6, -1.1][n] + 0.1;
            let angles: Vec<f64> = (0..dh.len()).map(angle).collect();
            let placed = kinematics.tree.place(&angles);
            let Solid::Capsule(sphere) = tip.shape.placed(placed.world_from_link[tip.joint]) else {
                panic!("a sphere")
            };
            let expected = tool(dh, &angles).translation;
            assert!((sphere.a - expected).length() < 1e-9, "{urdf}: {} {expected}", sphere.a);
        }
        // Its shapes are near its axes: no part is farther from the frame that carries it than the arm is long.
        assert!(cell.links.len() > 7 && cell.warnings.is_empty(), "{:?}", cell.warnings);
        for link in &cell.links {
            let (centre, radius) = link.shape.bounding_sphere();
            assert!(centre.length() + radius < 0.75, "{urdf}: {}", link.name);
        }
    }
}

/// The example cell with its robot written as a URDF file: joints, and its capsules.
fn as_urdf(cell: &toml::Table) -> String {
    let robot = &cell["robot"].as_array().unwrap()[0];
    let triple = |value: Option<&toml::Value>| -> [f64; 3] {
        let Some(list) = value.and_then(toml::Value::as_array) else { return [0.0; 3] };
        let number = |v: &toml::Value| v.as_float().or(v.as_integer().map(|i| i as f64)).unwrap();
        [number(&list[0]), number(&list[1]), number(&list[2])]
    };
    let words = |v: [f64; 3]| format!("{} {} {}", v[0], v[1], v[2]);
    let mut text = String::from("<robot name=\"r\"><link name=\"base\"/>\n");
    let mut before = "base".to_owned();
    for joint in robot["joint"].as_array().unwrap() {
        let name = joint["name"].as_str().unwrap();
        let origin = triple(joint.get("origin").and_then(|o| o.get("xyz_m")));
        // A fixed link between: it must make no difference.
        let part = [0.25 * origin[0], 0.25 * origin[1], 0.25 * origin[2]];
        let rest = [0.75 * origin[0], 0.75 * origin[1], 0.75 * origin[2]];
        write!(
            text,
            "<link name=\"{name}_stand\"/><joint name=\"{name}_fixed\" type=\"fixed\"><parent link=\"{before}\"/><child \
             link=\"{name}_stand\"/><origin xyz=\"{}\"/></joint>\n<joint name=\"{name}\" type=\"continuous\"><parent \
             link=\"{name}_stand\"/><child link=\"{name}_link\"/><origin xyz=\"{}\"/><axis xyz=\"{}\"/></joint>\n\
             <link name=\"{name}_link\">",
            words(part),
            words(rest),
            words(triple(joint.get("axis")))
        )
        .unwrap();
        for link in robot["link"].as_array().unwrap().iter().filter(|link| link["joint"].as_str() == Some(name)) {
            let capsule = &link["capsule"];
            let (from, to) = (triple(capsule.get("from_m")), triple(capsule.get("to_m")));
            let along = Vec3::from_array(to) - Vec3::from_array(from);
            let middle = (Vec3::from_array(to) + Vec3::from_array(from)) * 0.5;
            // The axis of a URDF capsule is z: along x by a quarter turn about y.
            let rpy = if along.x.abs() > 1e-9 { "0 1.5707963267948966 0" } else { "0 0 0" };
            let shape = match along.length() {
                0.0 => format!("<sphere radius=\"{}\"/>", capsule["radius_m"]),
                length => format!("<capsule radius=\"{}\" length=\"{length}\"/>", capsule["radius_m"]),
            };
            write!(
                text,
                "<collision><origin xyz=\"{}\" rpy=\"{rpy}\"/><geometry>{shape}</geometry></collision>",
                words(middle.to_array())
            )
            .unwrap();
        }
        text.push_str("</link>\n");
        before = format!("{name}_link");
    }
    text + "</robot>\n"
}

/// Who is hit where and how hard; not the names of links, which are others in a URDF.
fn hits(dir: &Path, cell: &str) -> Vec<(String, f64, String)> {
    fmi_hazard(dir)
        .args(["scan", "--no-advice", cell, "--out", "out", "--iterations", "60", "--strategy", "mcts-dpw"])
        .assert()
        .code(1);
    let scan = scan_json(&dir.join("out"));
    let mut hits: Vec<(String, f64, String)> = scan["hazards"]
        .as_array()
        .unwrap()
        .iter()
        .map(|h| {
            let region = h["body_region"].as_str().unwrap().to_owned();
            (region, h["force_n"].as_f64().unwrap(), h["actions"].to_string())
        })
        .collect();
    hits.sort_by(|a, b| a.1.total_cmp(&b.1).then_with(|| a.2.cmp(&b.2)));
    hits
}

#[test]
fn a_cell_whose_robot_comes_from_a_urdf_has_the_same_hazards() {
    let dir = examples();
    let folder = dir.path().join("safety-fence");
    let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let mut table: toml::Table = text.parse().unwrap();
    std::fs::create_dir(folder.join("geometry")).unwrap();
    write(&folder, "geometry/robot.urdf", &as_urdf(&table));
    let robot = table["robot"].as_array_mut().unwrap()[0].as_table_mut().unwrap();
    robot.remove("link");
    robot.insert("urdf".to_owned(), "geometry/robot.urdf".into());
    for joint in robot["joint"].as_array_mut().unwrap() {
        joint.as_table_mut().unwrap().remove("origin");
        joint.as_table_mut().unwrap().remove("axis");
    }
    write(&folder, "by-urdf.toml", &toml::to_string(&table).unwrap());
    let (by_hand, by_urdf) = (hits(&folder, "cell.toml"), hits(&folder, "by-urdf.toml"));
    assert!(!by_hand.is_empty());
    assert_eq!(by_hand.len(), by_urdf.len());
    for (a, b) in by_hand.iter().zip(&by_urdf) {
        assert!(a.0 == b.0 && (a.1 - b.1).abs() < 1e-6 && a.2 == b.2, "{a:?} {b:?}");
    }
    let scan = scan_json(&folder.join("out"));
    assert_eq!(scan["subject"]["files"][0]["path"], "geometry/robot.urdf");
    // Another robot under the same name is told.
    let changed = std::fs::read_to_string(folder.join("geometry/robot.urdf")).unwrap() + "<!-- -->\n";
    write(&folder, "geometry/robot.urdf", &changed);
    let replay = fmi_hazard(&folder).args(["replay", "out", scan["hazards"][0]["id"].as_str().unwrap()]).assert();
    let text = String::from_utf8_lossy(&replay.get_output().stderr).into_owned();
    assert!(text.contains("robot description, a mesh or the system of FMUs has changed"), "{text}");
}

/// Centre and its velocity of every shape over a second of the cell at rest from people.
fn motions(dir: &Path, cell: &str) -> Vec<Vec<(Vec3, Vec3)>> {
    use fmi_hazard::host::Plant as _;
    use fmi_hazard::sim::robot::RobotFrame;
    let prepared = prepare(&dir.join(cell), None).unwrap();
    let mut plant = prepared.plant(fmi_hazard::scan::StateChoice::Auto);
    let start = plant.restart().unwrap();
    let world = fmi_hazard::sim::World::new(prepared.cell.clone(), prepared.binding.clone());
    let rows = plant.advance(50, &world.initial_inputs().repeat(50)).unwrap();
    let rows = prepared.binding.rows(&rows, Some(&start), prepared.cell.step_s);
    let frame = |row: &[f64]| RobotFrame::new(&prepared.cell, &prepared.binding, row);
    let rows = rows.chunks(prepared.binding.columns()).map(frame);
    rows.map(|frame| {
        let centre = |n: usize| frame.links[n].bounding_sphere().0;
        let of = |n: usize| (centre(n), frame.velocity(n, centre(n)));
        (0..frame.links.len()).map(of).collect()
    })
    .collect()
}

/// Without `keys` in joints or frames.
fn without(text: &str, keys: &[&str]) -> String {
    let kept = text.lines().filter(|line| !keys.iter().any(|key| line.starts_with(&format!("{key} ="))));
    kept.collect::<Vec<_>>().join("\n")
}

#[test]
fn speeds_that_the_fmu_does_not_give_are_differentiated_and_marked() {
    let dir = examples();
    for (name, keys) in [("safety-fence", &["speed"][..]), ("head-collision", &["velocity", "angular_velocity"])] {
        let folder = dir.path().join(name);
        let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
        write(&folder, "bare.toml", &without(&text, keys));
        let (given, differentiated) = (motions(&folder, "cell.toml"), motions(&folder, "bare.toml"));
        let mut fastest: f64 = 0.0;
        let mut compared = 0;
        for (step, (a, b)) in given.windows(2).zip(differentiated.windows(2)).enumerate() {
            for link in 0..a[0].len() {
                let ((_, before), (_, after)) = (a[0][link], a[1][link]);
                let ((from, _), (to, mean)) = (b[0][link], b[1][link]);
                fastest = fastest.max(after.length());
                // The way of the centre over the step, but for its curvature: v w h / 2 at 2 m/s and 5 rad/s is 0.1 m/s.
                let way = (to - from) / 0.02;
                assert!((way - mean).length() < 0.12, "{name}, step {step}: {way} m/s on the way, {mean} m/s told");
                // Where the FMU's own velocity hardly changes, it is that.
                if (after - before).length() < 0.05 {
                    compared += 1;
                    assert!((mean - after).length() < 0.12, "{name}, step {step}: {after} m/s given, {mean} m/s told");
                }
            }
        }
        assert!(compared > 50, "{name}: {compared} instants");
        assert!(fastest > 0.5, "{name} moves: {fastest} m/s");
        let arguments =
            ["scan", "--no-advice", "bare.toml", "--out", "o", "--iterations", "40", "--strategy", "mcts-dpw"];
        let output = fmi_hazard(&folder).args(arguments).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(said.contains("differentiated"), "{said}");
        let scan = scan_json(&folder.join("o"));
        let warned = scan["warnings"].as_array().unwrap().iter().any(|w| w.as_str().unwrap().contains("half a step"));
        assert!(warned, "{}", scan["warnings"]);
    }
}

#[test]
fn a_hull_is_the_same_from_its_corners_and_from_mesh_files() {
    let dir = tempfile::TempDir::new().unwrap();
    // A wedge of 200 x 100 x 50 mm.
    let corners = [
        [0.0, 0.0, 0.0],
        [200.0, 0.0, 0.0],
        [200.0, 100.0, 0.0],
        [0.0, 100.0, 0.0],
        [0.0, 0.0, 50.0],
        [0.0, 100.0, 50.0],
    ];
    let faces = [[0, 1, 2], [0, 2, 3], [0, 4, 1], [3, 2, 5], [1, 4, 5], [1, 5, 2], [0, 3, 5], [0, 5, 4]];
    let mut obj = String::new();
    let mut stl = String::from("solid wedge\n");
    for [x, y, z] in corners {
        // In the file y is up.
        writeln!(obj, "v {x} {z} {}", -y).unwrap();
    }
    for face in faces {
        writeln!(obj, "f {} {} {}", face[0] + 1, face[1] + 1, face[2] + 1).unwrap();
        stl.push_str("facet normal 0 0 0\nouter loop\n");
        for corner in face {
            let [x, y, z] = corners[corner];
            writeln!(stl, "vertex {x} {y} {z}").unwrap();
        }
        stl.push_str("endloop\nendfacet\n");
    }
    write(dir.path(), "wedge.obj", &obj);
    write(dir.path(), "wedge.stl", &(stl + "endsolid wedge\n"));
    let metres: Vec<String> =
        corners.iter().map(|c| format!("[{}, {}, {}]", c[0] / 1e3, c[1] / 1e3, c[2] / 1e3)).collect();
    let shapes = [
        format!("hull_m = [{}]", metres.join(", ")),
        "mesh = { file = \"wedge.stl\", metres_per_unit = 0.001 }".to_owned(),
        "mesh = { file = \"wedge.obj\", metres_per_unit = 0.001, up = \"y\" }".to_owned(),
    ];
    let mut text = String::from(
        "schema = 1\nname = \"r\"\nfmu = \"r.fmu\"\n[human]\nstart = { xy_m = [0, -2], heading_deg = 90 }\n[[robot]]\nname = \
         \"r\"\npayload_kg = 1\nmoving_mass_kg = 20\n[[robot.joint]]\nname = \"j\"\naxis = [0, 0, 1]\nangle = { variable = \
         \"q\" }\n",
    );
    for shape in &shapes {
        write!(text, "[[robot.link]]\nname = \"wedge\"\njoint = \"j\"\n{shape}\n").unwrap();
    }
    let cell = validate(&Source::new("cell.toml", &text).in_folder(dir.path())).unwrap();
    assert_eq!(cell.files.len(), 2);
    for n in 0..200 {
        let n = f64::from(n);
        let point = Vec3::new(0.4 * libm::sin(n * 0.7), 0.3 * libm::cos(n * 1.3), 0.2 * libm::sin(n * 2.1));
        let distances: Vec<f64> = cell.links.iter().map(|link| link.shape.point_distance(point).distance).collect();
        assert!(distances.iter().all(|d| (d - distances[0]).abs() < 1e-7), "{point}: {distances:?}");
    }
}

#[test]
fn a_box_taken_exactly_from_a_mesh_has_the_hazards_of_its_hull() {
    let dir = examples();
    let folder = dir.path().join("heavy-workpiece");
    let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let sphere = "capsule = { from_m = [0, -0.21655, 0], to_m = [0, -0.21655, 0], radius_m = 0.13 }";
    assert!(text.contains(sphere));
    let (points, triangles) = meshes::cuboid([-130.0, -346.0, -90.0], [130.0, -86.0, 90.0]);
    write(&folder, "workpiece.stl", &meshes::stl(&points, &triangles));
    let corners: Vec<[f64; 3]> = points.iter().map(|corner| corner.map(|edge| edge * 1e-3)).collect();
    let mesh = |more: &str| format!("mesh = {{ file = \"workpiece.stl\", metres_per_unit = 0.001{more} }}");
    let shapes = [("hull", format!("hull_m = {corners:?}")), ("mesh", mesh("")), ("exact", mesh(", exact = true"))];
    let scans = shapes.map(|(name, shape)| {
        write(&folder, &format!("{name}.toml"), &text.replace(sphere, &shape));
        let arguments = [
            "scan",
            "--no-advice",
            &format!("{name}.toml"),
            "--out",
            name,
            "--iterations",
            "60",
            "--strategy",
            "random",
        ];
        fmi_hazard(&folder).args(arguments).assert().code(1);
        scan_json(&folder.join(name))
    });
    assert_eq!(scans[2]["subject"]["files"][0]["path"], "workpiece.stl");
    let hazards = scans[0]["hazards"].as_array().unwrap();
    assert!(hazards.iter().any(|hazard| hazard["robot_link"] == "workpiece"));
    scans[1..].iter().for_each(|other| assert_same_hazards(&scans[0], other));
}

/// What is added to an axis is in the unit of its table, like the axis itself: 90 and half of 90 are 135 degrees.
#[test]
fn coupled_axes_are_added_in_their_unit() {
    let dir = tempfile::TempDir::new().unwrap();
    // An FMU that says nothing of units.
    let fmu = with_xml(|text| text.replace(" unit=\"rad\"", "").replace(" unit=\"rad/s\"", ""));
    std::fs::write(dir.path().join("faulty.fmu"), fmu).unwrap();
    let coupled = "{ variable = \"q\", unit = \"deg\", plus = { \"qd\" = 0.5 } }";
    let text = faulty_cell("faulty.fmu", 0, 0).replace("{ variable = \"q\", unit = \"rad\" }", coupled);
    assert!(text.contains(coupled));
    let binding = prepare(&write(dir.path(), "cell.toml", &text), None).unwrap().binding;
    let MotionBinding::Joints { positions, .. } = &binding.robots[0].motion else { panic!("it has a joint") };
    let read = positions[0].read(&vec![90.0; binding.columns()]);
    assert!((read - 0.75 * std::f64::consts::PI).abs() < 1e-12, "{read}");
}

#[test]
fn joints_that_slide_mimic_or_are_held() {
    let dir = tempfile::TempDir::new().unwrap();
    let finger = |name: &str, axis: &str, more: &str| {
        format!(
            "<joint name=\"{name}\" type=\"prismatic\"><parent link=\"hand\"/><child link=\"{name}_l\"/><origin xyz=\"0 0 \
             0.1\"/><axis xyz=\"{axis}\"/>{more}</joint><link name=\"{name}_l\"><collision><geometry><sphere \
             radius=\"0.01\"/></geometry></collision><inertial><mass value=\"0.5\"/></inertial></link>"
        )
    };
    let urdf = format!(
        "<robot name=\"g\"><link name=\"base\"/><link name=\"hand\"><inertial><mass value=\"2\"/></inertial><visual/></link>\
         <joint name=\"turn\" type=\"revolute\"><parent link=\"base\"/><child link=\"hand\"/><axis xyz=\"0 0 1\"/></joint>{}{}\
         </robot>",
        finger("right_finger", "0 -1 0", "<mimic joint=\"left_finger\" multiplier=\"0.5\" offset=\"0.01\"/>"),
        finger("left_finger", "0 1 0", "")
    );
    write(dir.path(), "g.urdf", &urdf);
    let cell = cell_of(dir.path(), "g.urdf", &["turn", "left_finger"], "");
    let robot = &cell.robots[0];
    assert!((robot.moving_mass_kg - 3.0).abs() < 1e-12);
    assert!(cell.warnings[0].contains("`hand` can be seen and has no collision shape"), "{:?}", cell.warnings);
    let kinematics = robot.kinematics.as_ref().unwrap();
    let (positions, speeds) = kinematics.all(&[0.0, 0.04], &[0.0, 0.2]);
    let placed = kinematics.tree.place(&positions);
    let at = |name: &str| {
        let link = cell.links.iter().find(|link| link.name == name).unwrap();
        (link.shape.placed(placed.world_from_link[link.joint]).bounding_sphere().0, link.joint)
    };
    // By hand: the left finger is 0.04 m to +y, the right one 0.5 x 0.04 + 0.01 m to -y.
    let (left, right) = (at("left_finger_l"), at("right_finger_l"));
    assert!((left.0 - Vec3::new(0.0, 0.04, 0.1)).length() < 1e-12, "{}", left.0);
    assert!((right.0 - Vec3::new(0.0, -0.03, 0.1)).length() < 1e-12, "{}", right.0);
    let twists = placed.twists(&speeds);
    assert!((twists[right.1].velocity_at(right.0) - Vec3::new(0.0, -0.1, 0.0)).length() < 1e-12);
    // Held: the finger has no variable.
    let held = "[[robot.joint]]\nname = \"left_finger\"\nheld_m = 0.02\n";
    let cell = cell_of(dir.path(), "g.urdf", &["turn"], held);
    assert_eq!(cell.robots[0].kinematics.as_ref().unwrap().driven.len(), 3);
}

#[test]
fn what_a_robot_looks_like_turns_with_its_shape() {
    let dir = tempfile::TempDir::new().unwrap();
    let visual = |file: &str| {
        format!(
            "<visual><origin xyz=\"0.1 0 0\" rpy=\"0 0 1.5707963267948966\"/><geometry><mesh filename=\"{file}\" \
             scale=\"0.001 0.001 0.001\"/></geometry></visual>"
        )
    };
    let urdf = format!(
        "<robot name=\"g\"><link name=\"base\"/><link name=\"hand\"><inertial><mass value=\"2\"/></inertial>{}{}{}{}\
         <collision><origin xyz=\"0.2 0 0\" rpy=\"0 0.4 0.3\"/><geometry><box size=\"0.1 0.2 0.3\"/></geometry></collision>\
         </link><joint name=\"turn\" type=\"revolute\"><parent link=\"base\"/><child link=\"hand\"/><origin xyz=\"0 0 0.5\"/>\
         <axis xyz=\"0 0 1\"/></joint></robot>",
        visual("hand.obj"),
        visual("missing.stl"),
        visual("hand.dae"),
        visual("many.obj")
    );
    write(dir.path(), "g.urdf", &urdf);
    write(dir.path(), "hand.obj", "v 100 0 0\nv 0 100 0\nv 0 0 100\nf 1 2 3\n");
    let corners: String =
        (0..=appearance::MOST_TRIANGLES).map(|n| format!("v {n} 0 1\nv {n} 1 0\nv {n} 2 2\n")).collect();
    let faces: String =
        (0..=appearance::MOST_TRIANGLES).map(|n| format!("f {} {} {}\n", 3 * n + 1, 3 * n + 2, 3 * n + 3)).collect();
    write(dir.path(), "many.obj", &(corners + &faces));
    let cell = cell_of(dir.path(), "g.urdf", &["turn"], "");
    let found = appearance::meshes(&cell);
    let [(0, mesh)] = found.as_slice() else { panic!("one can be read and is small: {}", found.len()) };
    // Nothing depends on them.
    assert!(
        cell.files.iter().all(|file| file.path.extension().is_some_and(|ending| ending == "urdf")),
        "{:?}",
        cell.files
    );
    let kinematics = cell.robots[0].kinematics.as_ref().unwrap();
    let placed = kinematics.tree.place(&[std::f64::consts::FRAC_PI_2]);
    let Solid::Hull(hull) = cell.links[0].shape.placed(placed.world_from_link[0]) else { panic!("a box is a hull") };
    // By hand: 100 mm along x, turned by a right angle and moved by 0.1 m, then turned by another with the joint.
    let corner = hull.pose() * mesh.points[0];
    assert!((corner - Vec3::new(-0.1, 0.1, 0.5)).length() < 1e-9, "{corner}");
}

#[test]
fn part_of_the_masses_is_no_mass() {
    let dir = tempfile::TempDir::new().unwrap();
    let sphere = "<collision><geometry><sphere radius=\"0.1\"/></geometry></collision>";
    let urdf = format!(
        "<robot name=\"g\"><link name=\"base\"/><link name=\"arm\">{sphere}<inertial><mass value=\"2\"/></inertial></link>\
         <link name=\"hand\">{sphere}</link><joint name=\"turn\" type=\"revolute\"><parent link=\"base\"/><child \
         link=\"arm\"/><axis xyz=\"0 0 1\"/></joint><joint name=\"fixed\" type=\"fixed\"><parent link=\"arm\"/><child \
         link=\"hand\"/><axis xyz=\"0 0 0\"/></joint></robot>"
    );
    write(dir.path(), "g.urdf", &urdf);
    let text = |mass: &str| {
        format!(
            "schema = 1\nname = \"r\"\nfmu = \"r.fmu\"\n[human]\nstart = {{ xy_m = [0, -2], heading_deg = 90 }}\n[[robot]]\n\
             name = \"r\"\nurdf = \"g.urdf\"\npayload_kg = 1\n{mass}[[robot.joint]]\nname = \"turn\"\nangle = {{ \
             variable = \"q\" }}\n"
        )
    };
    let read = |mass: &str| validate(&Source::new("cell.toml", &text(mass)).in_folder(dir.path()));
    let error = read("").unwrap_err();
    assert!(error.message.contains("how heavy hand is"), "{error}");
    assert!(error.help.as_ref().unwrap().contains("2.0 kg"), "{:?}", error.help);
    assert!((read("moving_mass_kg = 7\n").unwrap().robots[0].moving_mass_kg - 7.0).abs() < 1e-12);
}
