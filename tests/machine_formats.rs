//! What a scan writes for other tools, read by readers that this project did not write. Needs the Python environment that
//! `tools/test` makes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::path::{Path, PathBuf};
use std::process::Command;

use common::fmpy::python;
use common::{examples, fmi_hazard, scan_json};

/// The OASIS schema, which comes with a library that reads SARIF.
fn sarif_schema() -> PathBuf {
    let mut cargo = Command::new(env!("CARGO"));
    cargo.args(["metadata", "--format-version", "1", "--offline"]).current_dir(env!("CARGO_MANIFEST_DIR"));
    let text = cargo.output().unwrap().stdout;
    let metadata: serde_json::Value = serde_json::from_slice(&text).unwrap();
    let packages = metadata["packages"].as_array().unwrap();
    let package = packages.iter().find(|package| package["name"] == "serde-sarif").unwrap();
    Path::new(package["manifest_path"].as_str().unwrap()).with_file_name("src").join("schema.json")
}

fn read_by_others(out: &Path, fmu: Option<&Path>) -> String {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tools/check_formats.py");
    let mut command = Command::new(python());
    command.arg(script).arg(out).arg("--sarif-schema").arg(sarif_schema());
    if let Some(fmu) = fmu {
        command.arg("--fmu").arg(fmu);
    }
    let output = command.output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    text
}

fn scan(dir: &Path, cell: &str, out: &str, more: &[&str]) -> Option<i32> {
    let few = ["--strategy", "hybrid", "--iterations", "20", "--out", out];
    fmi_hazard(dir).arg("scan").arg(cell).args(few).args(more).assert().get_output().status.code()
}

#[test]
fn tables_cases_logs_and_traces_are_read_by_others() {
    let dir = examples();
    let dir = dir.path();
    for example in ["head-collision", "safety-fence", "two-scanners"] {
        let code = scan(dir, &format!("{example}/cell.toml"), "out", &[]);
        assert_eq!(code, Some(1));
        let said = read_by_others(&dir.join("out"), Some(&dir.join(example).join(format!("{example}.fmu"))));
        assert!(!said.contains(": 0 "), "{said}");
        // Typed, too.
        let sarif = std::fs::read_to_string(dir.join("out/hazards.sarif")).unwrap();
        let log: serde_sarif::sarif::Sarif = serde_json::from_str(&sarif).unwrap();
        let result = &log.runs[0].results.as_ref().unwrap()[0];
        let place = result.locations.as_ref().unwrap()[0].physical_location.as_ref().unwrap();
        let line = usize::try_from(place.region.as_ref().unwrap().start_line.unwrap()).unwrap();
        // The line that it points to names the joint of the link that hits.
        let cell = std::fs::read_to_string(dir.join(example).join("cell.toml")).unwrap();
        let link = scan_json(&dir.join("out"))["hazards"][0]["robot_link"].as_str().unwrap().to_owned();
        let before: Vec<&str> = cell.lines().take(line).collect();
        let carrier = ["joint = ", "frame = "].iter().any(|key| before[line - 1].starts_with(key));
        assert!(carrier, "{}", before[line - 1]);
        let name = before.iter().rfind(|line| line.starts_with("name = ")).unwrap();
        assert!(link.ends_with(name.trim_start_matches("name = ").trim_matches('"')), "{link} is not {name}");
        std::fs::remove_dir_all(dir.join("out")).unwrap();
    }
    // No hazard, and several FMUs, which have no traces.
    assert_eq!(scan(dir, "heavy-workpiece/fixed.toml", "none", &[]), Some(0));
    read_by_others(&dir.join("none"), None);
    assert!(scan(dir, "sensor-mat/coupled.toml", "coupled", &[]).is_some_and(|code| code < 2));
    read_by_others(&dir.join("coupled"), None);
    let files = std::fs::read_dir(dir.join("coupled")).unwrap().flatten();
    assert!(files.map(|file| file.file_name()).all(|name| !name.to_string_lossy().contains(".inputs.")));
}

#[test]
fn known_hazards_do_not_fail_a_pipeline_and_new_ones_do() {
    let dir = examples();
    let dir = dir.path();
    let cell = "head-collision/cell.toml";
    assert_eq!(scan(dir, cell, "first", &[]), Some(1));
    assert_eq!(scan(dir, cell, "again", &["--baseline", "first"]), Some(0));
    let said = read_by_others(&dir.join("again"), None);
    assert!(said.contains(" 0 failures, 6 skipped"), "{said}");
    // A baseline that lacks one of them, and in which another was less hard.
    let path = dir.join("first/scan.json");
    let mut first = scan_json(&dir.join("first"));
    let lacking = first["hazards"].as_array_mut().unwrap().remove(0)["id"].as_str().unwrap().to_owned();
    let less = first["hazards"][0]["id"].as_str().unwrap().to_owned();
    first["hazards"][0]["ratio"] = serde_json::json!(0.5);
    std::fs::write(&path, first.to_string()).unwrap();
    assert_eq!(scan(dir, cell, "again", &["--baseline", "first/scan.json"]), Some(1));
    let cases = std::fs::read_to_string(dir.join("again/junit.xml")).unwrap();
    for (id, kind) in [(&lacking, "type=\"hazard\""), (&less, "type=\"hazard that became worse\"")] {
        let case = cases.split("<testcase").find(|case| case.contains(id.as_str())).unwrap();
        assert!(case.contains(kind), "{case}");
    }
    assert!(read_by_others(&dir.join("again"), None).contains(" 2 failures, 4 skipped"));
}
