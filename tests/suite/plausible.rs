//! Numbers that nobody means: what makes the question meaningless is refused with the likely cause, what is odd is told, and what is only
//! unusual is neither. Each kind with several cells; no FMU is run.

use std::path::Path;

use crate::common::{fmi_hazard, test_fmus};
use fmi_hazard::cell::error::Source;
use fmi_hazard::cell::file::validate::validate;
use fmi_hazard::examples;
use fmi_hazard_sample::meshes::{cuboid, stl};

/// A cell in which everything fits.
const CELL: &str = r#"schema = 1
name = "plain"
fmu = "plain.fmu"
[[robot]]
name = "arm"
base = { xyz_m = [0, 0.8, 0.75], rpy_deg = [0, 0, 90] }
moving_mass_kg = 25
payload_kg = 3
[[robot.joint]]
name = "j1"
origin = { xyz_m = [0, 0, 0.18] }
axis = [0, 0, 1]
angle = { variable = "q1" }
[[robot.joint]]
name = "j2"
origin = { xyz_m = [0.55, 0, 0], rpy_deg = [0, 0, 30] }
axis = [0, 0, 1]
held_deg = 45
[[robot.link]]
name = "upper"
joint = "j1"
capsule = { from_m = [0, 0, 0], to_m = [0.55, 0, 0], radius_m = 0.07 }
[[robot.link]]
name = "lower"
joint = "j2"
capsule = { from_m = [0, 0, 0], to_m = [0.5, 0, 0], radius_m = 0.05 }
[[sensor]]
name = "mat"
kind = "mat"
variable = "clear"
active = false
delay_ms = 30
zone = { polygon_m = [[-1, -1], [1, -1], [1, 1], [-1, 1]] }
[[obstacle]]
name = "fence"
centre_m = [0, 2, 1]
size_m = [4, 0.05, 2]
[human]
start = { xy_m = [0, -2], heading_deg = 90 }
"#;

/// What is wrong, and what is odd.
fn told(folder: &Path, text: &str) -> (Vec<String>, Vec<String>) {
    match validate(&Source::new("cell.toml", text).in_folder(folder)) {
        Ok(cell) => (Vec::new(), cell.warnings),
        Err(error) => {
            let one = |e: &fmi_hazard::cell::CellError| {
                assert!(e.line().is_some(), "{e:?}");
                format!("{}. {}", e.message, e.help.as_deref().unwrap_or_default())
            };
            (error.each().map(one).collect(), Vec::new())
        }
    }
}

/// The cell with parts of its text changed.
fn changed(changes: &[(&str, &str)]) -> String {
    changes.iter().fold(CELL.to_owned(), |text, (from, to)| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    })
}

#[test]
fn what_fits_is_told_nothing() {
    let folder = tempfile::TempDir::new().unwrap();
    assert_eq!(told(folder.path(), CELL), (Vec::new(), Vec::new()));
    // Large, heavy and far, and all of that is there: a hall, an arm that carries a tonne, angles that are no round ones.
    for unusual in [
        vec![("size_m = [4, 0.05, 2]", "size_m = [90, 0.05, 12]")],
        vec![("moving_mass_kg = 25", "moving_mass_kg = 90")],
        vec![("rpy_deg = [0, 0, 90]", "rpy_deg = [0, 0, 1.5]")],
        vec![("rpy_deg = [0, 0, 90]", "rpy_deg = [0, 0, 0.52]")],
        vec![("heading_deg = 90", "heading_deg = 3.1")],
        vec![("delay_ms = 30", "delay_ms = 4")],
        // A zone with a notch, and one whose corners go the other way round.
        vec![("[1, 1], [-1, 1]]", "[1, 1], [0.2, 1], [0.2, 0], [-0.2, 0], [-0.2, 1], [-1, 1]]")],
        vec![("[[-1, -1], [1, -1], [1, 1], [-1, 1]]", "[[-1, 1], [1, 1], [1, -1], [-1, -1]]")],
        // One with a hole, to which a slit leads.
        vec![("[1, 1], [-1, 1]]", "[1, 1], [-1, 1], [-1, 0], [-0.5, 0], [0.5, 0.5], [0.5, 0], [-0.5, 0], [-1, 0]]")],
    ] {
        assert_eq!(told(folder.path(), &changed(&unusual)), (Vec::new(), Vec::new()), "{unusual:?}");
    }
}

#[test]
fn what_cannot_be_meant_is_refused() {
    let folder = tempfile::TempDir::new().unwrap();
    let (points, triangles) = cuboid([0.0, -60.0, -60.0], [550.0, 60.0, 60.0]);
    std::fs::write(folder.path().join("mm.stl"), stl(&points, &triangles)).unwrap();
    let mesh = |more: &str| format!("mesh = {{ file = \"mm.stl\", metres_per_unit = {more} }}");
    let upper = "capsule = { from_m = [0, 0, 0], to_m = [0.55, 0, 0], radius_m = 0.07 }";
    let (fence, zone) = ("size_m = [4, 0.05, 2]", "[[-1, -1], [1, -1], [1, 1], [-1, 1]]");
    let refused: &[(&str, &str, &[&str])] = &[
        // Obstacles.
        (
            fence,
            "size_m = [4000, 50, 2000]",
            &["obstacle `fence` has a length or coordinate of 4000 m", "4000 mm would be 4"],
        ),
        ("centre_m = [0, 2, 1]", "centre_m = [0, 2000, 1000]", &["obstacle `fence`", "2000 mm would be 2"]),
        (fence, "size_m = [400, 5, 201]", &["obstacle `fence`", "400 mm would be 0.4"]),
        // The base, and joints.
        ("xyz_m = [0, 0.8, 0.75]", "xyz_m = [0, 0.8, 750]", &["the base of robot `arm`", "750 mm would be 0.75"]),
        ("xyz_m = [0, 0.8, 0.75]", "xyz_m = [0, 800, 0.75]", &["the base of robot `arm`", "800 mm would be 0.8"]),
        ("xyz_m = [0, 0.8, 0.75]", "xyz_m = [0, 0.8, 75]", &["at a height of 75 m", "75 cm would be 0.75"]),
        ("xyz_m = [0.55, 0, 0]", "xyz_m = [550, 0, 0]", &["joint `j2` is 550 m from the one before", "0.55"]),
        // Links.
        (upper, &mesh("1"), &["this mesh is 575.59 m long", "575.59 mm would be 0.576", "metres_per_unit is 0.001"]),
        (upper, &mesh("1, exact = true"), &["this mesh is 575.59 m long"]),
        (upper, "capsule = { from_m = [0, 0, 0], to_m = [550, 0, 0], radius_m = 70 }", &["link `upper`", "690 m long"]),
        (upper, "hull_m = [[0, 0, 0], [550, 0, 0], [0, 60, 0], [0, 0, 60]]", &["link `upper` is", "mm would be 0.55"]),
        (upper, "capsule = { from_m = [0, 0, 300], to_m = [0.5, 0, 300], radius_m = 0.07 }", &["m from its joint"]),
        // Zones.
        (
            zone,
            "[[-1000, -1000], [1000, -1000], [1000, 1000], [-1000, 1000]]",
            &["the zone of sensor `mat`", "-1000 mm would be -1"],
        ),
        (zone, "[[-1, -1], [1, 1], [1, -1], [-1, 1]]", &["crosses itself", "(-1, -1) to (1, 1)", "(1, -1) to (-1, 1)"]),
        // A star, and two corners that changed places.
        (
            zone,
            "[[0, 1], [0.6, -0.8], [-1, 0.3], [1, 0.3], [-0.6, -0.8]]",
            &["crosses itself", "(0, 1) to (0.6, -0.8)"],
        ),
        (
            zone,
            "[[-1, -1], [1.5, 0], [1, -1], [1, 1], [-1, 1], [-1.5, 0]]",
            &["crosses itself", "(-1, -1) to (1.5, 0)"],
        ),
        // The person.
        (
            "xy_m = [0, -2]",
            "xy_m = [0, -2000]",
            &["the start has a length or coordinate of -2000 m", "-2000 mm would be -2"],
        ),
        ("[human]\n", "[human]\nfloor_m = [[-3, -3], [3, 3], [3, -3], [-3, 3]]\n", &["human.floor_m crosses itself"]),
        (
            "[human]\n",
            "[human]\nfloor_m = [[-3000, -3000], [3000, -3000], [0, 3000]]\n",
            &["human.floor_m", "-3000 mm"],
        ),
    ];
    for (from, to, words) in refused {
        let (wrong, _) = told(folder.path(), &changed(&[(from, to)]));
        assert!(words.iter().all(|word| wrong.iter().any(|said| said.contains(word))), "{to}: {words:?} in {wrong:?}");
        assert!(wrong.len() <= 2, "{wrong:?}");
    }
}

#[test]
fn what_is_odd_is_told() {
    let folder = tempfile::TempDir::new().unwrap();
    let odd: &[(&[(&str, &str)], &str)] = &[
        // Masses.
        (&[("moving_mass_kg = 25", "moving_mass_kg = 25000")], "25000 kg move, more than of any arm that is made"),
        (&[("moving_mass_kg = 25", "moving_mass_kg = 250")], "250 kg move, of arms that reach 1.1 m"),
        (&[("moving_mass_kg = 25", "moving_mass_kg = 0.025")], "0.03 kg move"),
        (&[("moving_mass_kg = 25", "moving_mass_kg = 1")], "take it from the data sheet"),
        (&[("payload_kg = 3", "payload_kg = 3000")], "3000 kg are its payload, more than of any arm that is made"),
        (&[("payload_kg = 3", "payload_kg = 800")], "it carries 800 kg and moves 25 kg of its own"),
        // Angles.
        (&[("rpy_deg = [0, 0, 90]", "rpy_deg = [0, 0, 1.5708]")], "by 1.5708 degrees: is that in radians, and 90"),
        (&[("rpy_deg = [0, 0, 30]", "rpy_deg = [0, 0, 0.5236]")], "joint `j2` is turned by 0.5236 degrees"),
        (&[("held_deg = 45", "held_deg = -0.7854")], "is that in radians, and -45 degrees are meant"),
        (&[("heading_deg = 90", "heading_deg = 1.571")], "where the person starts is turned by 1.571 degrees"),
        (
            &[("size_m = [4, 0.05, 2]", "size_m = [4, 0.05, 2]\nrpy_deg = [0, 0, 0.785]")],
            "obstacle `fence` is turned by 0.785",
        ),
        // Sizes and places.
        (
            &[("to_m = [0.55, 0, 0], radius_m = 0.07", "to_m = [5.5, 0, 0], radius_m = 0.07")],
            "link `upper` is 5.64 m long",
        ),
        (
            &[
                ("to_m = [0.55, 0, 0], radius_m = 0.07", "to_m = [0.00055, 0, 0], radius_m = 0.00007"),
                ("to_m = [0.5, 0, 0], radius_m = 0.05", "to_m = [0.0005, 0, 0], radius_m = 0.00005"),
            ],
            "is 0.69 mm long: are its shapes scaled twice?",
        ),
        (&[("centre_m = [0, 2, 1]", "centre_m = [0, 2, -1]")], "obstacle `fence` is below the floor"),
        // Response times.
        (&[("delay_ms = 30", "delay_ms = 0.03")], "is that 0.03 s?"),
    ];
    for (changes, words) in odd {
        let (wrong, warned) = told(folder.path(), &changed(changes));
        assert_eq!(wrong, [""; 0], "{changes:?}");
        assert!(warned.len() == 1 && warned[0].contains(words), "{changes:?}: {words:?} in {warned:?}");
    }
}

/// Links of a URDF: one mesh in millimetres, joints in millimetres, and masses that nobody filled in.
#[test]
fn a_urdf_is_looked_at_as_well() {
    let folder = tempfile::TempDir::new().unwrap();
    let urdf = |way: &str, shape: &str, kg: [f64; 3]| {
        let link = |n: usize| {
            let mass = kg[n];
            format!(
                "<link name=\"l{n}\"><inertial><mass value=\"{mass}\"/></inertial><collision><geometry>{shape}</geometry></collision></link>\
                 <joint name=\"j{n}\" type=\"revolute\"><origin xyz=\"0 0 {way}\"/><parent link=\"{}\"/><child link=\"l{n}\"/>\
                 <axis xyz=\"0 0 1\"/><limit lower=\"-3\" upper=\"3\" effort=\"1\" velocity=\"3\"/></joint>",
                if n == 0 { "base".to_owned() } else { format!("l{}", n - 1) }
            )
        };
        let text = format!("<robot name=\"r\"><link name=\"base\"/>{}{}{}</robot>", link(0), link(1), link(2));
        std::fs::write(folder.path().join("arm.urdf"), text).unwrap();
        let cell =
            "schema = 1\nname = \"r\"\nfmu = \"r.fmu\"\n[[robot]]\nname = \"r\"\nurdf = \"arm.urdf\"\npayload_kg = 3\n";
        let joint = |n: usize| format!("[[robot.joint]]\nname = \"j{n}\"\nangle = {{ variable = \"q{n}\" }}\n");
        let text = format!(
            "{cell}{}{}{}[human]\nstart = {{ xy_m = [0, -2], heading_deg = 90 }}\n",
            joint(0),
            joint(1),
            joint(2)
        );
        told(folder.path(), &text)
    };
    let cylinder = "<cylinder radius=\"0.05\" length=\"0.4\"/>";
    assert_eq!(urdf("0.3", cylinder, [8.0, 6.0, 3.0]), (Vec::new(), Vec::new()));
    let (wrong, _) = urdf("300", cylinder, [8.0, 6.0, 3.0]);
    assert!(wrong[0].contains("joint `j0` of the URDF is 300 m from the one before"), "{wrong:?}");
    let (wrong, _) = urdf("0.3", "<cylinder radius=\"50\" length=\"400\"/>", [8.0, 6.0, 3.0]);
    assert!(wrong[0].contains("link `l0` is 4") && wrong[0].contains("scale=\"0.001 0.001 0.001\""), "{wrong:?}");
    let (_, odd) = urdf("0.3", cylinder, [2.0; 3]);
    assert!(odd.len() == 1 && odd[0].contains("all 3 links of its URDF weigh 2 kg"), "{odd:?}");
}

/// What is told of the cells that come with the program is true of them: nothing is odd there.
#[test]
fn nothing_is_odd_in_the_examples() {
    let folder = tempfile::TempDir::new().unwrap();
    examples::export(folder.path()).unwrap();
    let mut cells = 0;
    for example in
        std::fs::read_dir(folder.path()).unwrap().map(|entry| entry.unwrap().path()).filter(|path| path.is_dir())
    {
        for file in std::fs::read_dir(&example).unwrap().map(|entry| entry.unwrap().path()) {
            let text = std::fs::read_to_string(&file).unwrap_or_default();
            if file.extension().is_some_and(|ending| ending == "toml")
                && !text.contains("extends = ")
                && text.contains("[[robot]]")
            {
                assert_eq!(told(&example, &text), (Vec::new(), Vec::new()), "{}", file.display());
                cells += 1;
            }
        }
    }
    assert!(cells >= 16, "{cells}");
}

/// A URDF on one line is shown around the place alone, and a xacro file says how it becomes one.
#[test]
fn files_of_programs_are_shown_in_part() {
    let folder = tempfile::TempDir::new().unwrap();
    let refused = |urdf: &str| {
        std::fs::write(folder.path().join("arm.urdf"), urdf).unwrap();
        let output = fmi_hazard(folder.path()).args(["init", "arm.fmu", "--urdf", "arm.urdf"]).assert().code(2);
        String::from_utf8_lossy(&output.get_output().stderr).split_whitespace().collect::<Vec<_>>().join(" ")
    };
    std::fs::copy(test_fmus().join("guarded.fmu"), folder.path().join("arm.fmu")).unwrap();
    let link = |n: usize| format!("<link name=\"l{n}\"><inertial><mass value=\"3\"/></inertial></link>");
    let long: String = (0..400).map(link).collect();
    for urdf in [
        format!("<robot name=\"r\">{long}<joint name=\"j\" type=\"revo\"/>{long}</robot>"),
        format!("<robot name=\"r\">\n{long}\n<joint name=\"j\" type=\"revo\"/>\n{long}</robot>"),
        format!("<robot name=\"ä\"><!-- {} --><link/>{long}</robot>", "ö".repeat(400)),
    ] {
        let said = refused(&urdf);
        assert!(said.len() < 2000 && said.contains("arm.urdf:"), "{} bytes: {said:.3000}", said.len());
    }
    let xacro = "<robot name=\"r\" xmlns:xacro=\"http://www.ros.org/wiki/xacro\">";
    for content in ["<xacro:include filename=\"a.xacro\"/>", "<link name=\"b\"/><xacro:arm prefix=\"\"/>"] {
        let said = refused(&format!("{xacro}{content}</robot>"));
        assert!(said.contains("it is xacro") && said.contains("xacro robot.urdf.xacro > robot.urdf"), "{said}");
    }
}
