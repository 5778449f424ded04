//! How heavy a robot is where it hits, by the inertias of its links: from the cell file and a URDF to scan.json and `explain`.
//! The formula itself is held against calculations by hand and differences of positions in `geometry/inertia_tests.rs`.

use std::fmt::Write as _;
use std::path::Path;

use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;
use fmi_hazard::cell::error::Source;
use fmi_hazard::cell::file::validate::validate;
use fmi_hazard::cell::workcell::Workcell;
use fmi_hazard::geometry::{Inertia, Vec3};
use fmi_hazard::host::Plant as _;
use fmi_hazard::sim::robot::RobotFrame;

/// Six joints, one of which slides, with a fixed link between two of them. What stands in the inertials is what a mechanism
/// could have.
const ARM: &str = r#"<robot name="g"><link name="base"/>
<link name="a"><inertial><origin xyz="0.01 0.02 0.1" rpy="0.3 -0.2 0.5"/><mass value="7.5"/>
  <inertia ixx="0.06" ixy="0.003" ixz="-0.002" iyy="0.05" iyz="0.001" izz="0.03"/></inertial></link>
<link name="b"><inertial><origin xyz="0.2 0 0.05" rpy="0 0.1 0"/><mass value="9"/>
  <inertia ixx="0.02" ixy="0" ixz="0.01" iyy="0.3" iyz="0" izz="0.31"/></inertial></link>
<link name="c"><inertial><origin xyz="0.15 0.03 0"/><mass value="4"/>
  <inertia ixx="0.01" ixy="0" ixz="0" iyy="0.08" iyz="0.002" izz="0.085"/></inertial></link>
<link name="d"><inertial><origin xyz="0 0.02 0.06"/><mass value="2"/>
  <inertia ixx="0.006" ixy="0" ixz="0" iyy="0.005" iyz="0" izz="0.004"/></inertial></link>
<link name="stand"><inertial><origin xyz="0 0 0.02" rpy="0 0.4 0"/><mass value="0.7"/>
  <inertia ixx="0.001" ixy="0" ixz="0" iyy="0.0012" iyz="0" izz="0.0008"/></inertial></link>
<link name="e"><inertial><origin xyz="0 0 0.1"/><mass value="1.5"/>
  <inertia ixx="0.003" ixy="0" ixz="0" iyy="0.003" iyz="0" izz="0.002"/></inertial></link>
<link name="f"><inertial><origin xyz="0.005 0 0.03"/><mass value="0.8"/>
  <inertia ixx="0.0006" ixy="0" ixz="0" iyy="0.0007" iyz="0" izz="0.0009"/></inertial>
  <collision><geometry><sphere radius="0.05"/></geometry></collision></link>
<joint name="1" type="revolute"><parent link="base"/><child link="a"/><origin xyz="0 0 0.15"/><axis xyz="0 0 1"/></joint>
<joint name="2" type="revolute"><parent link="a"/><child link="b"/><origin xyz="0 0.1 0.2" rpy="0.2 0 0.1"/>
  <axis xyz="0 1 0"/></joint>
<joint name="3" type="revolute"><parent link="b"/><child link="c"/><origin xyz="0.45 0 0" rpy="0 0.3 0"/><axis xyz="0 1 0"/></joint>
<joint name="4" type="revolute"><parent link="c"/><child link="d"/><origin xyz="0.35 0 0.02"/><axis xyz="1 0 0"/></joint>
<joint name="fixed" type="fixed"><parent link="d"/><child link="stand"/><origin xyz="0.03 0 0.05" rpy="0 0.25 0"/></joint>
<joint name="5" type="prismatic"><parent link="stand"/><child link="e"/><origin xyz="0 0 0.08" rpy="0 1.2 0"/>
  <axis xyz="0 0.6 0.8"/></joint>
<joint name="6" type="revolute"><parent link="e"/><child link="f"/><origin xyz="0 0 0.1" rpy="0 -0.4 0"/><axis xyz="0 0 1"/></joint>
</robot>
"#;

/// A cell with the robot of `urdf`; `joints` are what follows the name of each.
fn text_of(joints: &[(&str, &str)], more: &str) -> String {
    let mut text = format!(
        "schema = 1\nname = \"r\"\nfmu = \"r.fmu\"\n[human]\nstart = {{ xy_m = [0, -2], heading_deg = 90 }}\n\
         [[robot]]\nname = \"r\"\npayload_kg = 3\n{more}\n"
    );
    for (name, rest) in joints {
        writeln!(text, "[[robot.joint]]\nname = \"{name}\"\n{rest}").unwrap();
    }
    text
}

fn read(folder: &Path, text: &str) -> Result<Workcell, String> {
    let source = Source::new("cell.toml", text).in_folder(folder);
    validate(&source).map_err(|error| {
        let line = error.line().unwrap_or_default();
        format!("{}:{line}: {error}: {}", error.file(), error.help.as_deref().unwrap_or_default())
    })
}

/// The arm's joints, moved by an FMU.
const MOVED: [(&str, &str); 6] = [
    ("1", "angle = { variable = \"q\" }"),
    ("2", "angle = { variable = \"q\" }"),
    ("3", "angle = { variable = \"q\" }"),
    ("4", "angle = { variable = \"q\" }"),
    ("5", "position = { variable = \"q\" }"),
    ("6", "angle = { variable = \"q\" }"),
];

/// The numbers are those of Pinocchio 4.1.0 (`pip install pin`) for the same file: `1 / (a' M^-1 a)` with its mass matrix
/// (`crba`) and its Jacobian (`getJointJacobian`) brought to the point; the payload by `appendBodyToJoint`.
#[test]
fn an_arm_from_a_urdf_weighs_what_another_library_says() {
    let dir = tempfile::TempDir::new().unwrap();
    write(dir.path(), "arm.urdf", ARM);
    let more = "urdf = \"arm.urdf\"\npayload_at = { joint = \"f\", centre_m = [0.02, 0.03, 0.12] }";
    let cell = read(dir.path(), &text_of(&MOVED, more)).unwrap();
    assert!(cell.warnings.is_empty(), "{:?}", cell.warnings);
    let kinematics = cell.robots[0].kinematics.as_ref().unwrap();
    let masses = kinematics.masses.as_ref().unwrap();
    assert!((cell.robots[0].moving_mass_kg - 25.5).abs() < 1e-12);
    let (tip, elbow) = (Vec3::new(0.02, 0.03, 0.2), Vec3::new(0.3, -0.05, 0.04));
    let pushes =
        [(5, tip, Vec3::new(1.0, 0.0, 0.0)), (5, tip, Vec3::new(0.0, 0.6, -0.8)), (2, elbow, Vec3::new(0.0, 0.0, 1.0))];
    let poses = [[0.3, -0.8, 1.1, 0.2, 0.05, 0.9], [-1.2, 0.4, -1.9, 2.0, -0.1, 0.3]];
    let empty = [
        [1.646_568_798_450, 0.575_386_154_122, 12.334_828_097_373],
        [0.736_674_094_520, 1.735_027_256_252, 11.157_527_074_410],
    ];
    let loaded = [
        [4.623_799_598_528, 3.525_751_759_952, 14.079_425_507_452],
        [3.376_449_517_118, 5.343_196_282_427, 11.325_612_886_773],
    ];
    let payload = Some((kinematics.payload_at.0, Inertia::point(3.0, kinematics.payload_at.1)));
    for (load, all) in [(None, empty), (payload, loaded)] {
        for (q, expected) in poses.iter().zip(all) {
            let placed = kinematics.tree.place(q);
            for ((link, local, n), expected) in pushes.iter().zip(expected) {
                let at = placed.world_from_link[*link].transform_point(*local);
                let found = masses.reflected_mass_kg(&placed, load, *link, at, *n);
                assert!((found - expected).abs() < 1e-8, "{q:?} {link} {n}: {found} {expected}");
            }
        }
    }
    // A diagonal of the mass matrix that shows what is merged where: 2.3 kg slide along joint 5, the fixed link does not.
    let matrix = masses.mass_matrix(&kinematics.tree.place(&poses[0]), None);
    assert!((matrix[(4, 4)] - 2.3).abs() < 1e-12 && (matrix[(0, 0)] - 4.271_067_432).abs() < 1e-8, "{matrix}");
}

#[test]
fn part_of_the_inertias_is_none_and_is_told() {
    let dir = tempfile::TempDir::new().unwrap();
    let of = |urdf: &str, joints: &[(&str, &str)]| {
        write(dir.path(), "arm.urdf", urdf);
        let cell = read(dir.path(), &text_of(joints, "urdf = \"arm.urdf\"\nmoving_mass_kg = 25.5")).unwrap();
        let known = cell.robots[0].kinematics.as_ref().unwrap().masses.is_some();
        (known, cell.warnings.join("\n"))
    };
    let c = "<inertia ixx=\"0.01\" ixy=\"0\" ixz=\"0\" iyy=\"0.08\" iyz=\"0.002\" izz=\"0.085\"/>";
    let zero = "<inertia ixx=\"0\" ixy=\"0\" ixz=\"0\" iyy=\"0\" iyz=\"0\" izz=\"0\"/>";
    assert_eq!(of(ARM, &MOVED), (true, String::new()));
    // Tensors of zeros are masses alone, and so are masses alone.
    for instead in ["", zero] {
        let (known, said) = of(&ARM.replace(c, instead), &MOVED);
        assert!(!known && said.ends_with("needs all inertias, and link `c` has none"), "{said}");
    }
    let wrong = ARM.replace("ixx=\"0.01\"", "ixx=\"1.0\"").replace("izz=\"0.0008\"", "izz=\"much\"");
    let (known, said) = of(&wrong, &MOVED);
    assert!(
        !known && said.ends_with("link `c` has one that no body has, link `stand` has one that no body has"),
        "{said}"
    );
    // What the cell file says of the joint counts instead.
    let own = "angle = { variable = \"q\" }\n\
               inertia = { mass_kg = 40, centre_m = [0.15, 0.03, 0], moments_kg_m2 = [0.1, 0.8, 0.85] }";
    let mut joints = MOVED;
    joints[2].1 = own;
    let (known, said) = of(&ARM.replace(c, ""), &joints);
    assert!(
        known && said.ends_with("are those of 61.5 kg, its moving mass is 25.5 kg: one of both is wrong"),
        "{said}"
    );
    // A file without any tells nothing, and need not.
    let without = |part: &str| part.split_once("/></inertial>").map(|(_, rest)| format!("</inertial>{rest}"));
    let plain: String = ARM.split("<inertia ").map(|part| without(part).unwrap_or_else(|| part.to_owned())).collect();
    assert_eq!(of(&plain, &MOVED), (false, String::new()));
}

#[test]
fn held_joints_do_not_give_way_and_those_that_mimic_go_along() {
    let dir = tempfile::TempDir::new().unwrap();
    write(
        dir.path(),
        "arm.urdf",
        &ARM.replace("<axis xyz=\"1 0 0\"/>", "<axis xyz=\"1 0 0\"/><mimic joint=\"2\" multiplier=\"-3\"/>"),
    );
    let mut joints = MOVED.to_vec();
    joints[2].1 = "held_deg = 20";
    joints.remove(3);
    let cell = read(dir.path(), &text_of(&joints, "urdf = \"arm.urdf\"")).unwrap();
    let kinematics = cell.robots[0].kinematics.as_ref().unwrap();
    let masses = kinematics.masses.as_ref().unwrap();
    let drive = |joint: usize| masses.drives[joint].map(|drive| (drive.coordinate, drive.factor));
    let told = [Some((0, 1.0)), Some((1, 1.0)), None, Some((1, -3.0)), Some((3, 1.0)), Some((4, 1.0))];
    assert_eq!([0, 1, 2, 3, 4, 5].map(drive), told);
    // The matrix of all joints, put together from there: what moves with joint 2 is it and joint 4, three times as far back.
    let placed = kinematics.tree.place(&[0.3, -0.8, 1.1, 0.2, 0.05, 0.9]);
    let matrix = masses.mass_matrix(&placed, None);
    // Entries (2,2), (2,4) and (4,4) of Pinocchio's matrix in that pose.
    let expected = 4.797_828_246 - 2.0 * 3.0 * -0.003_856_522 + 9.0 * 0.074_314_126;
    assert!((matrix[(1, 1)] - expected).abs() < 1e-7, "{} {expected}", matrix[(1, 1)]);
    assert_eq!(matrix.row(2).amax(), 0.0, "the coordinate of the held joint moves nothing");
}

#[test]
fn joints_by_hand_tell_theirs_and_mistakes_are_shown_where_they_stand() {
    let dir = tempfile::TempDir::new().unwrap();
    let link = "[[robot.link]]\nname = \"bar\"\njoint = \"b\"\ncapsule = { from_m = [0, 0, 0], to_m = [0.4, 0, 0], radius_m = 0.05 }\n";
    let joint = |x: f64, inertia: &str| {
        format!("origin = {{ xyz_m = [{x}, 0, 0] }}\naxis = [0, 0, 1]\nangle = {{ variable = \"q\" }}\n{inertia}")
    };
    let bar = "inertia = { mass_kg = 2, centre_m = [0.4, 0, 0], moments_kg_m2 = [0, 0, 0] }";
    let of = |first: &str, second: &str, more: &str| {
        let joints = [("a", &*joint(0.0, first)), ("b", &*joint(0.5, second))];
        read(dir.path(), &(text_of(&joints, &format!("moving_mass_kg = 4\n{more}")) + link))
    };
    let kinematics = of(bar, bar, "").unwrap().robots[0].kinematics.clone().unwrap();
    assert_eq!(kinematics.payload_at, (1, Vec3::new(0.2, 0.0, 0.0)), "the middle of the last shape");
    let elbow = Vec3::new(0.5, 0.0, 0.0);
    let placed = kinematics.tree.place(&[0.0, 0.0]);
    // 2 kg at 0.4 m, seen at 0.5 m; the second bar's 2 kg hang at their joint's end: m2 sin^2 q2 = 0.
    let elbow = kinematics.masses.as_ref().unwrap().reflected_mass_kg(&placed, None, 0, elbow, Vec3::Y);
    assert!((elbow - 2.0 * 0.16 / 0.25).abs() < 1e-12, "{elbow}");
    let placed = of(bar, bar, "payload_at = { joint = \"a\", centre_m = [0, 0, 1] }").unwrap();
    assert_eq!(placed.robots[0].kinematics.as_ref().unwrap().payload_at, (0, Vec3::Z));
    let some = of(bar, "", "").unwrap();
    assert!(some.robots[0].kinematics.as_ref().unwrap().masses.is_none());
    assert!(some.warnings[0].ends_with("needs all inertias, and joint `b` has no `inertia`"), "{:?}", some.warnings);
    let none = of("", "", "").unwrap();
    assert!(none.warnings.is_empty() && none.robots[0].kinematics.as_ref().unwrap().masses.is_none());

    let table = |mass: &str, moments: &str, products: &str| {
        format!(
            "inertia = {{ mass_kg = {mass}, centre_m = [0, 0, 0], moments_kg_m2 = {moments}, products_kg_m2 = {products} }}"
        )
    };
    for (mass, moments, products, said) in [
        ("0", "[1, 1, 1]", "[0, 0, 0]", "the mass that joint `b` moves must be greater than zero, not 0"),
        ("1", "[inf, 1, 1]", "[0, 0, 0]", "the inertia of joint `b` is not finite"),
        ("1", "[0.1, 0.1, -0.1]", "[0, 0, 0]", "turning it about some axis gives energy away"),
        ("1", "[0.1, 0.1, 0.1]", "[0.2, 0, 0]", "turning it about some axis gives energy away"),
        (
            "1",
            "[0.1, 0.1, 0.3]",
            "[0, 0, 0]",
            "no body has moments of inertia like those of joint `b`: 0.1, 0.1 and 0.3 kg m^2",
        ),
    ] {
        let error = of(bar, &table(mass, moments, products), "").unwrap_err();
        assert!(error.contains(said), "{error}");
        let line = text_of(&[("a", &joint(0.0, bar)), ("b", &joint(0.5, ""))], "moving_mass_kg = 4\n").lines().count();
        assert!(error.contains(&format!("cell.toml:{line}")), "{line}: {error}");
    }
    let error = of(bar, bar, "payload_at = { joint = \"bb\", centre_m = [0, 0, 1] }").unwrap_err();
    assert!(error.contains("there is no joint `bb` that moves") && error.contains("did you mean `b`?"), "{error}");
}

/// The fence's robot with a mass, kg, and moments of inertia of each joint's moving side, by the joint's name.
fn with_inertias(folder: &Path, of: impl Fn(&str) -> (f64, f64)) {
    let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let mut cell: toml::Table = text.parse().unwrap();
    let robot = cell["robot"].as_array_mut().unwrap()[0].as_table_mut().unwrap();
    for joint in robot["joint"].as_array_mut().unwrap() {
        let joint = joint.as_table_mut().unwrap();
        let (kg, moment) = of(joint["name"].as_str().unwrap());
        let inertia =
            format!("mass_kg = {kg:?}\ncentre_m = [0.1, 0, 0]\nmoments_kg_m2 = [{moment:?}, {moment:?}, {moment:?}]\n");
        joint.insert("inertia".to_owned(), inertia.parse::<toml::Table>().unwrap().into());
    }
    write(folder, "heavy.toml", &toml::to_string(&cell).unwrap());
}

/// All mass, but for grams, in the middle of the gripper.
#[test]
fn at_the_only_mass_all_of_it_is_felt_in_every_direction_and_pose_with_the_payload_of_the_instant() {
    let dir = examples();
    let folder = dir.path().join("safety-fence");
    with_inertias(&folder, |joint| if joint == "joint_6" { (40.4, 1e-6) } else { (1e-3, 1e-6) });
    let prepared = fmi_hazard::scan::prepare::prepare(&folder.join("heavy.toml"), None).unwrap();
    let mut plant = prepared.plant(fmi_hazard::scan::StateChoice::Auto);
    let start = plant.restart().unwrap();
    let world = fmi_hazard::sim::World::new(prepared.cell.clone(), prepared.binding.clone());
    let rows = plant.advance(150, &world.initial_inputs().repeat(150)).unwrap();
    let rows = prepared.binding.rows(&rows, Some(&start), prepared.cell.step_s);
    let gripper = prepared.cell.links.iter().position(|link| link.name == "gripper").unwrap();
    let mut payloads = Vec::new();
    for row in rows.chunks(prepared.binding.columns()).step_by(5) {
        let frame = RobotFrame::new(&prepared.cell, &prepared.binding, row);
        let centre = frame.links[gripper].bounding_sphere().0;
        let payload = prepared.binding.robots[0].payload.read(row);
        for n in [Vec3::X, Vec3::Y, Vec3::new(0.1, 0.2, -3.0)] {
            let found = frame.reflected_mass_kg(gripper, centre, n).unwrap();
            assert!((found - 40.4 - payload).abs() < 0.05, "{n}: {found}, with {payload}");
        }
        assert_eq!(frame.reflected_mass_kg(gripper, centre, Vec3::ZERO), None);
        payloads.push(payload);
    }
    payloads.dedup();
    assert!(payloads.iter().any(|kg| *kg > 0.0), "{payloads:?}");
}

#[test]
fn a_scan_tells_it_of_every_hazard_and_decides_nothing_by_it() {
    if !sample::is_turn(0, 4) {
        return;
    }
    let dir = examples();
    let folder = dir.path().join("safety-fence");
    with_inertias(&folder, |_| (40.4 / 6.0, 0.05));
    let hazards = |cell: &str, out: &str| {
        let arguments =
            ["scan", "--no-advice", "--from", "start", cell, "--iterations", "60", "--strategy", "mcts-dpw"];
        fmi_hazard(&folder).args(arguments).args(["--out", out]).assert().code(1);
        scan_json(&folder.join(out))["hazards"].clone()
    };
    let (plain, mut told) = (hazards("cell.toml", "plain"), hazards("heavy.toml", "told"));
    let id = told[0]["id"].as_str().unwrap().to_owned();
    let mut masses = Vec::new();
    for hazard in told.as_array_mut().unwrap() {
        let mass = hazard.as_object_mut().unwrap().remove("reflected_mass_kg").unwrap();
        masses.push(mass.as_f64().unwrap_or(f64::INFINITY));
    }
    assert_eq!(plain, told);
    assert!(!masses.is_empty() && masses.iter().all(|kg| *kg >= 0.0), "{masses:?}");
    assert!(masses.iter().any(|kg| *kg > 1.0 && kg.is_finite()), "{masses:?}");
    let said = |arguments: &[&str]| {
        let output = fmi_hazard(&folder).args(arguments).output().unwrap();
        (
            output.status.code(),
            String::from_utf8(output.stdout).unwrap().split_whitespace().collect::<Vec<_>>().join(" "),
        )
    };
    let (code, text) = said(&["explain", "told", &id, "--no-changes"]);
    assert_eq!(code, Some(0));
    let of = |kg: f64| if kg < 9.5 { format!("{kg:.1}") } else { format!("{kg:.0}") };
    let sentence = format!("By the links' inertias and the pose the robot weighs {} kg", of(masses[0]));
    let sentence = if masses[0].is_finite() { sentence } else { "the robot cannot give way at this point".to_owned() };
    assert!(text.contains(&sentence) && text.contains("; M/2 + payload, which decides, is 23 kg."), "{text}");
    let plain_id = plain[0]["id"].as_str().unwrap();
    assert!(!said(&["explain", "plain", plain_id, "--no-changes"]).1.contains("inertias"));
    // It is the same again from a fresh instance, and read back.
    let (_, replayed) = said(&["replay", "told", &id]);
    assert!(replayed.contains(&format!("{id} reproduced: ")), "{replayed}");
}
