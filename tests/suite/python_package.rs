//! The Python package from its sources, with this build of the program: its tests, its types, and that these are made from the
//! published schema. `tools/installs.py` tries the wheel. Needs the Python environment that `tools/test` makes.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use crate::common::fmpy::python;
use crate::common::formats::schemas;
use crate::common::{faulty_cell, fmi_hazard, test_fmus, write};
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
    let dir = TempDir::new().unwrap();
    std::fs::copy(test_fmus().join("faulty.fmu"), dir.path().join("faulty.fmu")).unwrap();
    let failing = write(dir.path(), "cell.toml", &faulty_cell("faulty.fmu", 2, 5));
    let told = run(&["-m", "unittest", "discover", "python/tests"], &[("FMI_HAZARD_FAILING_CELL", &failing)]);
    assert!(told.contains("\nOK\n"), "none is left out: {told}");
}

#[test]
fn its_types_are_those_of_the_published_schema_and_hold() {
    let printed = fmi_hazard(&root()).args(["schema", "--of", "commands"]).output().unwrap().stdout;
    let published = std::fs::read(schemas().join("commands.schema.json")).unwrap();
    assert!(printed == published, "fmi-hazard schema --of commands > docs/schema/commands.schema.json");
    run(&["tools/python_types.py", "--check"], &[]);
    let cache = TempDir::new().unwrap();
    run(&["-m", "mypy", "--cache-dir", cache.path().to_str().unwrap()], &[]);
}

#[test]
fn what_commands_print_fits_the_published_schema() {
    let dir = TempDir::new().unwrap();
    fmi_hazard::examples::export(dir.path()).unwrap();
    let program = |arguments: &[&str]| fmi_hazard(dir.path()).args(arguments).output().unwrap();
    let (cell, fixed) = ("head-collision/cell.toml", "head-collision/fixed.toml");
    let quick = ["--strategy", "hybrid", "--iterations", "10"];
    let scan = [&["--progress", "json", "scan", cell, "--out", "out"], &quick[..]].concat();
    let scanned = program(&scan);
    assert_eq!(scanned.status.code(), Some(1));
    let lines: Vec<&str> = std::str::from_utf8(&scanned.stderr).unwrap().lines().collect();
    let mut all = vec![("scan", std::fs::read_to_string(dir.path().join("out/scan.json")).unwrap())];
    all.extend(lines.iter().map(|line| ("progress", (*line).to_owned())));
    let worst = crate::common::scan_json(&dir.path().join("out"))["causes"][0]["id"].as_str().unwrap().to_owned();
    for arguments in [
        &["check", cell][..],
        &["distance", fixed],
        &["explain", "out", &worst, "--quick", "--iterations", "2"],
        &["compare", "out", "out"],
        &["verify", "out", fixed],
        &["verify", "out", cell],
        &["replay", "out", "all"],
    ] {
        let output = program(&[arguments, &["--format", "json"]].concat());
        all.push((arguments[0], String::from_utf8(output.stdout).unwrap()));
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
                  wrong = [{'progress': {'event': 'doing'}}, {'verify': [{'id': 1}]}, {'check': {}}]\n\
                  print(sum(jsonschema.Draft202012Validator({**schema, 'required': []}).is_valid(one) for one in wrong))";
    let file = write(dir.path(), "printed.json", &serde_json::to_string(&all).unwrap());
    let schema = schemas().join("commands.schema.json");
    let told = run(&["-c", script, schema.to_str().unwrap(), file.to_str().unwrap()], &[]);
    assert_eq!(told.trim(), "0", "it can fail");
}
