//! `scan --from anywhere` against a program that somebody else wrote from the book alone: every walk on a fine grid, and random
//! walks without one, with FMPy as the FMU's host. Needs the Python environment that `tools/test` makes.

use std::path::Path;
use std::process::{Command, Output};

use crate::common::fmpy::python;
use crate::common::{json, test_fmus, write};
use tempfile::TempDir;

/// Runs one of the scripts.
fn script(name: &str, arguments: &[&Path], more: &[&str]) -> (Output, String) {
    let scripts = Path::new(env!("CARGO_MANIFEST_DIR")).join("tools/second_opinion");
    let output = Command::new(python()).arg(scripts.join(name)).args(arguments).args(more).output().unwrap();
    let said = String::from_utf8_lossy(&output.stdout).into_owned();
    (output, said)
}

/// The number before a word.
fn number(said: &str, word: &str) -> u64 {
    let before = said.split(word).next().unwrap_or_default().trim_end();
    before.rsplit(' ').next().and_then(|number| number.parse().ok()).unwrap_or_else(|| panic!("no {word} in {said}"))
}

#[test]
#[ignore = "minutes: the scan, and every walk in Python, which runs here alone; `whatever_a_scan_of_somebody_upright_from_a_random_place_finds_is_found` is another independent route"]
fn every_harm_of_every_walk_on_a_grid_and_of_random_walks_is_told() {
    let dir = TempDir::new().unwrap();
    let (cells, out) = (dir.path().join("cells"), dir.path().join("out"));
    let (made, said) =
        script("cells.py", &[&cells, &test_fmus().join("guarded.fmu"), &test_fmus().join("gantry.fmu")], &[]);
    assert!(made.status.success(), "{said}{}", String::from_utf8_lossy(&made.stderr));
    let arguments: [&Path; 3] = [Path::new(env!("CARGO_BIN_EXE_fmi-hazard")), &out, &cells.join("small-mat.toml")];

    let (brute, said) = script("brute.py", &arguments, &["1.0", "--grid-mm", "16", "--half-m", "1.6"]);
    assert_eq!(brute.status.code(), Some(0), "{said}{}", String::from_utf8_lossy(&brute.stderr));
    assert!(number(&said, "harmful, at") > 1000 && number(&said, "of them not told") == 0, "{said}");

    let file = out.join("small-mat/scan/anywhere.json");
    let more = ["1.0", "--walks", "10000", "--told"];
    let (walks, said) = script("walks.py", &arguments, &[&more[..], &[file.to_str().unwrap()]].concat());
    assert_eq!(walks.status.code(), Some(0), "{said}{}", String::from_utf8_lossy(&walks.stderr));
    assert!(number(&said, "harmful poses") > 100 && number(&said, "of them of people") > 100, "{said}");

    // Of floor that is not told the walks do miss something.
    let mut told = json(&file);
    told["floor"].as_array_mut().unwrap().retain(|cell| cell["xy_m"][0].as_f64().unwrap() < 0.0);
    told["open_m"].as_array_mut().unwrap().retain(|open| open[0].as_f64().unwrap() < 0.0);
    told["open"] = told["open_m"].as_array().unwrap().len().into();
    let half = write(dir.path(), "half.json", &told.to_string());
    let (walks, said) = script("walks.py", &arguments, &[&more[..], &[half.to_str().unwrap()]].concat());
    assert!(walks.status.code() == Some(1) && said.contains("MISSED"), "{said}");
}
