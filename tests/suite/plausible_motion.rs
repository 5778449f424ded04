//! What a run of the FMU shows that nobody can mean: robots through obstacles and the floor, out of everybody's reach, that stand still,
//! angles in another unit, zones that nobody gets to. Three cells of each kind; those that are as they should be are told nothing.

use std::path::Path;

use crate::common::archives::{XML, entries, pack};
use crate::common::{examples, faulty_cell, write};
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::probe::probe;

/// An example, what is changed of its text, and what is told.
type Case<'a> = (&'a str, &'a [(&'a str, &'a str)], &'a str);

/// What is odd about a cell.
fn told(cell: &Path) -> Vec<String> {
    probe(&prepare(cell, None).unwrap()).unwrap().warnings
}

/// What is odd about an example's flawed cell with parts of its text changed.
fn of_example(folder: &Path, example: &str, changes: &[(&str, &str)]) -> Vec<String> {
    let folder = folder.join(example);
    let text = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    let text = changes.iter().fold(text, |text, (from, to)| {
        assert!(text.contains(from), "{example}: {from}");
        text.replacen(from, to, 1)
    });
    told(&write(&folder, "changed.toml", &text))
}

/// Each of them is.
fn are_told(cases: &[Case<'_>]) {
    let folder = examples();
    for (example, changes, expected) in cases {
        let all = of_example(folder.path(), example, changes);
        assert!(all.iter().any(|one| one.contains(expected)), "{example} {changes:?}: {all:#?}");
    }
}

#[test]
fn robots_where_no_robot_is_are_told() {
    let fence =
        |at: &str, size: &str| format!("[[obstacle]]\nname = \"odd\"\ncentre_m = {at}\nsize_m = {size}\n\n[human]\n");
    let [across, beside, thin] =
        [("[0, 0.5, 1]", "[2, 0.05, 2]"), ("[0.45, 0.9, 1]", "[0.1, 1, 2]"), ("[0, 0.6, 0.9]", "[1, 0.004, 1.8]")]
            .map(|(at, size)| fence(at, size));
    let through = "passes through obstacle `odd`";
    let cases: &[Case<'_>] = &[
        ("safety-fence", &[("[human]\n", &across)], through),
        ("sensor-mat", &[("[human]\n", &beside)], through),
        ("light-curtain", &[("[human]\n", &thin)], through),
        (
            "safety-fence",
            &[("base = { xyz_m = [0, 1.05, 0.4509]", "base = { xyz_m = [0, 1.05, -0.6]")],
            "m below the floor",
        ),
        ("sensor-mat", &[("rpy_deg = [0, 0, ", "rpy_deg = [180, 0, ")], "m below the floor"),
        ("light-curtain", &[("rpy_deg = [0, 0, -90]", "rpy_deg = [90, 0, -90]")], "m below the floor"),
        ("safety-fence", &[("xyz_m = [0, 1.05, 0.4509]", "xyz_m = [0, 1.05, 4.509]")], "is never lower than 4.6"),
        (
            "head-collision",
            &[("[human]\n", "[human]\nfloor_m = [[-6, -9], [6, -9], [6, -4], [-6, -4]]\n")],
            "is never nearer than",
        ),
        (
            "sensor-mat",
            &[("[human]\n", "[human]\nfloor_m = [[-4, -6], [-3, -6], [-3, 6], [-4, 6]]\n")],
            "is never nearer than",
        ),
    ];
    are_told(cases);
}

#[test]
fn zones_that_nobody_gets_to_are_told() {
    let mat = "[[-1, -1.2], [1, -1.2], [1, 2], [-1, 2]]";
    let cases: &[Case<'_>] = &[
        ("sensor-mat", &[("xy_m = [-0.74, -1.36]", "xy_m = [-0.74, -6]")], "no walk of 8 actions gets to the zone"),
        ("short-zone", &[("xy_m = [0, -2.75]", "xy_m = [12, -2.75]")], "no walk of 8 actions gets to the zone"),
        ("sensor-mat", &[(mat, "[[-9, -12], [-7, -12], [-7, -8], [-9, -8]]")], "no walk of 8 actions gets to the zone"),
        (
            "sensor-mat",
            &[("base = { xyz_m = [0, 1.2,", "base = { xyz_m = [0, 4,"), (mat, "[[2, -1], [4, -1], [4, 1], [2, 1]]")],
            "with x and y exchanged",
        ),
        (
            "sensor-mat",
            &[("[human]\n", "[human]\nfloor_m = [[-4, -6], [4, -6], [4, -2], [-4, -2]]\n")],
            "nobody is ever in the zone",
        ),
    ];
    are_told(cases);
}

#[test]
fn radians_for_degrees_and_robots_that_stand_still_are_told() {
    let folder = tempfile::TempDir::new().unwrap();
    let mut files = entries();
    for (name, content) in &mut files {
        if name == XML {
            let text = String::from_utf8(content.clone()).unwrap();
            *content =
                text.replace("<Real unit=\"rad\"/>", "<Real/>").replace("<Real unit=\"rad/s\"/>", "<Real/>").into();
        }
    }
    std::fs::write(folder.path().join("x.fmu"), pack(&files)).unwrap();
    let cell = faulty_cell("x.fmu", 0, 0);
    let all = |text: &str| told(&write(folder.path(), "cell.toml", text));
    assert_eq!(all(&cell), Vec::<String>::new());
    let degrees = cell.replace("unit = \"rad\"", "unit = \"deg\"").replace("unit = \"rad/s\"", "unit = \"deg/s\"");
    let odd = all(&degrees);
    assert!(odd.iter().any(|one| one.contains("these are radians, more likely")), "{odd:#?}");
    // A second robot whose joint is held, or reads what never changes.
    let second = cell[cell.find("[[robot]]").unwrap()..cell.find("[[sensor]]").unwrap()].replace("turntable", "other");
    let held = "held_deg = 0";
    let still = second
        .replace("angle = { variable = \"q\", unit = \"rad\" }\nspeed = { variable = \"qd\", unit = \"rad/s\" }", held);
    assert!(still.contains(held));
    let odd = all(&cell.replacen("[[sensor]]", &format!("{still}[[sensor]]"), 1));
    assert!(odd.iter().any(|one| one.contains("robot `other` stands still")), "{odd:#?}");
}
