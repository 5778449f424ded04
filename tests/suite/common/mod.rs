//! What the integration tests share: exported examples, variants of cell files, the command.

pub mod anywhere;
pub mod archives;
pub mod by_hand;
pub mod enumerated;
pub mod exhausted;
pub mod fmpy;
pub mod formats;
pub mod from_start;
pub mod guarded;
pub mod hostile;
pub mod instant;
pub mod pair;
pub mod scanned;
pub mod started;
pub mod stored;
pub mod twin;

use std::path::{Path, PathBuf};

use assert_cmd::Command;
use tempfile::TempDir;

/// The command under test, in `dir`.
pub fn fmi_hazard(dir: &Path) -> Command {
    let mut command = Command::cargo_bin("fmi-hazard").expect("the binary is built");
    command.current_dir(dir).env("NO_COLOR", "1");
    command
}

/// All examples in a fresh folder.
pub fn examples() -> TempDir {
    let dir = TempDir::new().expect("a temporary folder");
    fmi_hazard::examples::export(dir.path()).expect("examples can be written");
    dir
}

/// Folder with the FMUs built only for tests.
pub fn test_fmus() -> PathBuf {
    PathBuf::from(fmi_hazard::examples::TEST_FMUS)
}

/// A cell for the `faulty` test FMU: one joint with a tool, a mat that stops it, and the given parameters.
pub fn faulty_cell(fmu: &str, kind: i32, step: i32) -> String {
    format!(
        r#"schema = 1
name = "faulty"
fmu = "{fmu}"
[[robot]]
name = "turntable"
base = {{ xyz_m = [0, 0, 0.9] }}
moving_mass_kg = 40
payload_kg = 3
[[robot.joint]]
name = "table"
axis = [0, 0, 1]
angle = {{ variable = "q", unit = "rad" }}
speed = {{ variable = "qd", unit = "rad/s" }}
[[robot.link]]
name = "bar"
joint = "table"
capsule = {{ from_m = [0, 0, 0], to_m = [0.8, 0, 0], radius_m = 0.05 }}
[[sensor]]
name = "mat"
kind = "mat"
zone = {{ polygon_m = [[-3, -0.9], [3, -0.9], [3, -0.5], [-3, -0.5]] }}
variable = "stop"
active = true
[parameters]
"fault.kind" = {kind}
"fault.step" = {step}
[human]
start = {{ xy_m = [0, -1.6], heading_deg = 90 }}
[search]
iterations = 12
"#
    )
}

/// The same cell with a robot that is longer and nearer to the person, so that it hurts, and a mat that covers one way to it
/// only.
pub fn nearer(cell: &str) -> String {
    let mut nearer = cell.to_owned();
    for (old, new) in [
        ("to_m = [0.8, 0, 0]", "to_m = [1.4, 0, 0]"),
        ("xy_m = [0, -1.6], heading_deg = 90", "xy_m = [0.9, 1.4], heading_deg = -90"),
        ("[[-3, -0.9], [3, -0.9], [3, -0.5], [-3, -0.5]]", "[[-3, 0.8], [0.9, 0.8], [0.9, 1.2], [-3, 1.2]]"),
        ("iterations = 12", "iterations = 30"),
    ] {
        assert!(nearer.contains(old), "the cell is another one");
        nearer = nearer.replace(old, new);
    }
    nearer
}

/// Writes `text` to `dir/name` and returns the path.
pub fn write(dir: &Path, name: &str, text: &str) -> PathBuf {
    let path = dir.join(name);
    std::fs::write(&path, text).expect("a file can be written");
    path
}

/// `scan.json` of a results folder.
pub fn scan_json(out: &Path) -> serde_json::Value {
    json(&out.join("scan.json"))
}

/// Both scans have the same hazards; forces to a millionth of a newton, because shapes given in two ways differ by rounding.
pub fn assert_same_hazards(one: &serde_json::Value, other: &serde_json::Value) {
    let [one, other] = [one, other].map(|scan| scan["hazards"].as_array().expect("a list"));
    assert_eq!(one.len(), other.len());
    for (a, b) in one.iter().zip(other) {
        for key in ["id", "time_s", "robot_link", "body_region", "actions"] {
            assert_eq!(a[key], b[key], "{key}");
        }
        let [a, b] = [a, b].map(|hazard| hazard["force_n"].as_f64().expect("a number"));
        assert!((a - b).abs() < 1e-6, "{a} N {b} N");
    }
}

/// A JSON file.
pub fn json(path: &Path) -> serde_json::Value {
    let text = std::fs::read_to_string(path).expect("the file exists");
    serde_json::from_str(&text).expect("it is JSON")
}
