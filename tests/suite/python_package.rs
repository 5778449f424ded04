//! The Python package from its sources, with this build of the program: its tests, its types, and that these are made from the
//! published schema. `tools/installs.py` tries the wheel. Needs the Python environment that `tools/test` makes.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::common::anywhere;
use crate::common::fmpy::python;
use crate::common::formats::schemas;
use crate::common::guarded::guarded;
use crate::common::{examples, faulty_cell, fmi_hazard, test_fmus, write};
use crate::sample;
use tempfile::TempDir;

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// Runs Python with the package and the program; it must end well.
fn run(arguments: &[&str], more: &[(&str, &Path)]) -> String {
    let program = Path::new(env!("CARGO_BIN_EXE_fmi-hazard")).parent().unwrap().to_owned();
    let own = std::env::var_os("PATH").unwrap();
    let path = std::env::join_paths([program].into_iter().chain(std::env::split_paths(&own))).unwrap();
    let mut command = Command::new(python());
    command.args(arguments).current_dir(root()).env("PATH", path).env("PYTHONPATH", root().join("python"));
    command.env("PYTHONDONTWRITEBYTECODE", "1").envs(more.iter().copied());
    let Output { status, stdout, stderr } = command.output().unwrap();
    let told = [stdout, stderr].map(|said| String::from_utf8_lossy(&said).into_owned()).concat();
    assert!(status.success(), "{arguments:?}\n{told}");
    told
}

#[test]
fn results_exceptions_progress_and_interrupts_are_those_of_the_program() {
    if !sample::is_turn(7, 12) {
        return;
    }
    let dir = TempDir::new().unwrap();
    std::fs::copy(test_fmus().join("faulty.fmu"), dir.path().join("faulty.fmu")).unwrap();
    let failing = write(dir.path(), "cell.toml", &faulty_cell("faulty.fmu", 2, 5));
    let told = run(&["-m", "unittest", "discover", "python/tests"], &[("FMI_HAZARD_FAILING_CELL", &failing)]);
    assert!(told.contains("\nOK\n"), "none is left out: {told}");
}

/// Whoever installs it has Python's own library and nothing else.
#[test]
fn it_needs_no_other_package() {
    run(&["-S", "-c", "import fmi_hazard"], &[]);
}

#[test]
fn its_types_are_those_of_the_published_schema() {
    let printed = fmi_hazard(&root()).args(["schema", "--of", "commands"]).output().unwrap().stdout;
    let published = std::fs::read(schemas().join("commands.schema.json")).unwrap();
    assert!(printed == published, "fmi-hazard schema --of commands > docs/schema/commands.schema.json");
    run(&["tools/python_types.py", "--check"], &[]);
}

#[test]
fn its_types_hold() {
    if !sample::is_turn(2, 4) {
        return;
    }
    let cache = TempDir::new().unwrap();
    run(&["-m", "mypy", "--cache-dir", cache.path().to_str().unwrap()], &[]);
}

/// A bar that turns, with a mat before it, a small piece of floor beside it, and one number that advice may change: everything that commands
/// tell is told of it within seconds.
pub fn flawed() -> String {
    let fixed = "fixed = true";
    let parts = format!(
        r#"[[sensor]]
name = "mat"
kind = "mat"
variable = "clear"
active = false
zone = {{ polygon_m = [[-0.1, -1.4], [1.4, -1.4], [1.4, 1.4], [-0.1, 1.4]] }}
[explain.parameters]
"plc.t_react" = {{ {fixed} }}
"plc.t_ramp" = {{ {fixed} }}
"filter.tau" = {{ {fixed} }}
"muting.enabled" = {{ {fixed} }}
"muting.hold_time" = {{ {fixed} }}
"ssm.distance" = {{ {fixed} }}
"field.radius" = {{ {fixed} }}
[explain.robot]
bar = {{ {fixed} }}
[explain.sensor]
mat = {{ {fixed} }}
"#
    );
    let floor = "[human]\nbend_forward_deg = 0\nbend_lateral_deg = 0\nfloor_m = [[-0.7, -0.2], [-0.3, -0.2], [-0.3, 0.2], [-0.7, 0.2]]";
    let cell = anywhere::cell(0.45, &parts);
    assert!(cell.contains("[human]") && cell.contains("xy_m = [0, -3], heading_deg = 90"));
    cell.replace("[human]", floor).replace("xy_m = [0, -3], heading_deg = 90", "xy_m = [-0.6, 0], heading_deg = 0")
}

#[test]
fn what_commands_print_fits_the_published_schema() {
    if !sample::is_turn(0, 4) {
        return;
    }
    let dir = guarded();
    let cell = flawed();
    write(dir.path(), "cell.toml", &cell);
    assert!(cell.contains("\"drive.speed\" = 5"));
    write(dir.path(), "fixed.toml", &cell.replace("\"drive.speed\" = 5", "\"drive.speed\" = 0.4"));
    let all = fits_the_published_schema(dir.path(), ["cell.toml", "fixed.toml"]);
    // What stands in lists that may be empty is in these.
    let one =
        |command: &'static str| all.iter().filter(move |(name, _)| *name == command).map(|(_, text)| text.as_str());
    let scan: serde_json::Value = serde_json::from_str(one("scan").next().unwrap()).unwrap();
    assert!(!scan["causes"][0]["advice"]["changes"].as_array().unwrap().is_empty(), "no advice: {}", scan["causes"]);
    assert!(
        one("replay_changed").any(|text| text.contains("\"fixed\""))
            && one("replay_changed").any(|t| t.contains("\"still_there\""))
    );
    let whole: serde_json::Value = serde_json::from_str(one("anywhere").next().unwrap()).unwrap();
    assert!(!whole["hazards"].as_array().unwrap().is_empty(), "nobody is hit: {whole}");
}

/// The same of an example, whose safeguards have a distance.
#[test]
#[ignore = "two minutes: advice for an example and all of its floor; `what_commands_print_fits_the_published_schema` has a small cell"]
fn what_commands_print_of_an_example_fits_the_published_schema() {
    let dir = examples();
    fits_the_published_schema(dir.path(), ["head-collision/cell.toml", "head-collision/fixed.toml"]);
}

/// What every command that prints JSON prints of a flawed and a repaired cell, after it was held against the published schema.
fn fits_the_published_schema(dir: &Path, [cell, fixed]: [&str; 2]) -> Vec<(&'static str, String)> {
    let program = |arguments: &[&str]| fmi_hazard(dir).args(arguments).output().unwrap();
    let quick = ["--strategy", "hybrid", "--iterations", "10"];
    let scan = [&["--progress", "json", "scan", cell, "--out", "out"], &quick[..]].concat();
    let scanned = program(&scan);
    assert_eq!(scanned.status.code(), Some(1));
    let lines: Vec<&str> = std::str::from_utf8(&scanned.stderr).unwrap().lines().collect();
    let mut all = vec![("scan", std::fs::read_to_string(dir.join("out/scan.json")).unwrap())];
    all.extend(lines.iter().map(|line| ("progress", (*line).to_owned())));
    let worst = crate::common::scan_json(&dir.join("out"))["causes"][0]["id"].as_str().unwrap().to_owned();
    for (command, arguments) in [
        ("check", &[cell][..]),
        ("distance", &[fixed][..]),
        ("explain", &["out", worst.as_str(), "--from", "start", "--quick", "--iterations", "2"][..]),
        ("compare", &["out", "out"][..]),
        ("replay_changed", &["out", "--changed", fixed][..]),
        ("replay_changed", &["out", "--changed", cell][..]),
        ("replay", &["out", "all"][..]),
    ] {
        let name = command.split('_').next().unwrap();
        let output = program(&[&[name], arguments, &["--format", "json"]].concat());
        all.push((command, String::from_utf8(output.stdout).unwrap()));
    }
    let anywhere = ["scan", cell, "--from", "anywhere", "--until", "1s", "--format", "json", "--out", "all"];
    all.push(("anywhere", String::from_utf8(program(&anywhere).stdout).unwrap()));
    for event in ["doing", "progress", "hazard", "results", "note"] {
        let tag = format!("\"event\":\"{event}\"");
        assert!(lines.iter().any(|line| line.contains(&tag)), "{event} is told: {lines:?}");
    }
    let script = "import json, sys, jsonschema\n\
                  schema = json.load(open(sys.argv[1]))\n\
                  check = jsonschema.Draft202012Validator({**schema, 'required': []}).validate\n\
                  [check({key: json.loads(text)}) for key, text in json.load(open(sys.argv[2]))]\n\
                  wrong = [{'progress': {'event': 'doing'}}, {'replay_changed': [{'id': 1}]}, {'check': {}}]\n\
                  print(sum(jsonschema.Draft202012Validator({**schema, 'required': []}).is_valid(one) for one in wrong))";
    let file = write(dir, "printed.json", &serde_json::to_string(&all).unwrap());
    let schema = schemas().join("commands.schema.json");
    let told = run(&["-c", script, schema.to_str().unwrap(), file.to_str().unwrap()], &[]);
    assert_eq!(told.trim(), "0", "it can fail");
    all
}

/// A safeguard with a distance, whose parts a small cell does not have.
#[test]
fn what_distance_prints_of_a_mat_fits_the_published_schema() {
    let dir = examples();
    let output =
        fmi_hazard(dir.path()).args(["distance", "sensor-mat/fixed.toml", "--format", "json"]).output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let said: serde_json::Value = serde_json::from_str(&text).unwrap();
    assert!(!said["safeguards"][0]["ways"].as_array().unwrap().is_empty(), "{text}");
    let script = "import json, sys, jsonschema\n\
                  schema = json.load(open(sys.argv[1]))\n\
                  jsonschema.Draft202012Validator({**schema, 'required': []}).validate({'distance': json.load(open(sys.argv[2]))})";
    let file = write(dir.path(), "printed.json", &text);
    let schema = schemas().join("commands.schema.json");
    run(&["-c", script, schema.to_str().unwrap(), file.to_str().unwrap()], &[]);
}
