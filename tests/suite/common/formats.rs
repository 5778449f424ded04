//! Results read by readers that this project did not write. Needs the Python environment that `tools/test` makes.

use std::path::{Path, PathBuf};
use std::process::Command;

use super::fmpy::python;

/// The OASIS schema, which comes with a library that reads SARIF.
fn sarif_schema() -> PathBuf {
    let mut cargo = Command::new(env!("CARGO"));
    // Packages of other platforms may never have been downloaded here.
    let platform = format!("{}-unknown-linux-gnu", std::env::consts::ARCH);
    cargo.args(["metadata", "--format-version", "1", "--offline", "--filter-platform", &platform]);
    cargo.current_dir(env!("CARGO_MANIFEST_DIR"));
    let text = cargo.output().unwrap().stdout;
    let metadata: serde_json::Value = serde_json::from_slice(&text).unwrap();
    let packages = metadata["packages"].as_array().unwrap();
    let package = packages.iter().find(|package| package["name"] == "serde-sarif").unwrap();
    Path::new(package["manifest_path"].as_str().unwrap()).with_file_name("src").join("schema.json")
}

/// The published schemas.
pub fn schemas() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/schema")
}

/// Reads the results in `out` with other programs' readers, its traces with FMPy if `fmu` is named; what they said.
pub fn read_by_others(out: &Path, fmu: Option<&Path>) -> String {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tools/check_formats.py");
    let mut command = Command::new(python());
    command.arg(script).arg(out).arg("--sarif-schema").arg(sarif_schema());
    command.arg("--scan-schema").arg(schemas().join("scan.schema.json"));
    if let Some(fmu) = fmu {
        command.arg("--fmu").arg(fmu);
    }
    let output = command.output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    text
}
