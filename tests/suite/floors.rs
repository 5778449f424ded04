//! Which crate of this repository uses which, held against what cargo resolves.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// Each crate that is published, and the others of them that it draws in, directly or through others: the floors beneath it.
const BENEATH: [(&str, &[&str]); 15] = [
    ("fmi-hazard-stop", &[]),
    ("fmi-hazard-examples", &[]),
    ("fmi-hazard-search", &[]),
    ("fmi-hazard-outcome", &[]),
    ("fmu-self-test", &[]),
    ("fmu-host", &["fmi-hazard-stop", "fmu-self-test"]),
    ("fmi-hazard-human", &["fmi-hazard-stop"]),
    ("fmi-hazard-criteria", &["fmi-hazard-human", "fmi-hazard-stop"]),
    (
        "fmi-hazard-record",
        &["fmi-hazard-criteria", "fmi-hazard-human", "fmi-hazard-outcome", "fmi-hazard-stop", "fmu-self-test"],
    ),
    (
        "fmi-hazard-cell",
        &[
            "fmi-hazard-criteria",
            "fmi-hazard-human",
            "fmi-hazard-outcome",
            "fmi-hazard-stop",
            "fmu-host",
            "fmu-self-test",
        ],
    ),
    (
        "fmi-hazard-report",
        &[
            "fmi-hazard-criteria",
            "fmi-hazard-human",
            "fmi-hazard-outcome",
            "fmi-hazard-record",
            "fmi-hazard-stop",
            "fmu-self-test",
        ],
    ),
    (
        "fmi-hazard-simulation",
        &[
            "fmi-hazard-cell",
            "fmi-hazard-criteria",
            "fmi-hazard-human",
            "fmi-hazard-outcome",
            "fmi-hazard-record",
            "fmi-hazard-search",
            "fmi-hazard-stop",
            "fmu-host",
            "fmu-self-test",
        ],
    ),
    (
        "fmi-hazard-sequences",
        &[
            "fmi-hazard-cell",
            "fmi-hazard-criteria",
            "fmi-hazard-human",
            "fmi-hazard-outcome",
            "fmi-hazard-record",
            "fmi-hazard-search",
            "fmi-hazard-simulation",
            "fmi-hazard-stop",
            "fmu-host",
            "fmu-self-test",
        ],
    ),
    (
        "fmi-hazard-reachability",
        &[
            "fmi-hazard-cell",
            "fmi-hazard-criteria",
            "fmi-hazard-human",
            "fmi-hazard-outcome",
            "fmi-hazard-record",
            "fmi-hazard-search",
            "fmi-hazard-simulation",
            "fmi-hazard-stop",
            "fmu-host",
            "fmu-self-test",
        ],
    ),
    (
        "fmi-hazard",
        &[
            "fmi-hazard-cell",
            "fmi-hazard-criteria",
            "fmi-hazard-examples",
            "fmi-hazard-human",
            "fmi-hazard-outcome",
            "fmi-hazard-reachability",
            "fmi-hazard-record",
            "fmi-hazard-report",
            "fmi-hazard-search",
            "fmi-hazard-sequences",
            "fmi-hazard-simulation",
            "fmi-hazard-stop",
            "fmu-host",
            "fmu-self-test",
        ],
    ),
];

/// What of others' packages a crate must not draw in: geometry into what hosts FMUs or searches, and the loading of code into what does not.
const NEVER: [(&str, &[&str]); 8] = [
    ("fmi-hazard-report", &["libloading", "zip", "seccompiler", "parry3d", "clap"]),
    ("fmi-hazard-record", &["libloading", "quick-xml", "zip", "clap"]),
    ("fmu-host", &["parry3d-f64", "nalgebra", "clap"]),
    ("fmu-self-test", &["libloading", "quick-xml", "zip"]),
    ("fmi-hazard-search", &["parry3d-f64", "nalgebra", "libloading", "serde", "clap"]),
    ("fmi-hazard-outcome", &["parry3d-f64", "nalgebra", "libloading", "clap"]),
    ("fmi-hazard-human", &["libloading", "quick-xml", "toml", "clap"]),
    ("fmi-hazard-criteria", &["libloading", "quick-xml", "toml", "clap"]),
];

/// All packages that are in a crate, itself left out.
fn drawn_in(package: &str) -> BTreeSet<String> {
    let tree =
        ["tree", "--offline", "--edges", "normal", "--prefix", "none", "--format", "{lib} {p}", "--package", package];
    let output = Command::new(env!("CARGO")).args(tree).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let text = String::from_utf8(output.stdout).unwrap();
    let names = text.lines().filter_map(|line| line.split_whitespace().nth(1));
    names.filter(|name| *name != package).map(str::to_owned).collect()
}

#[test]
fn no_crate_uses_one_above_it_or_draws_in_what_it_must_not() {
    let ours: BTreeSet<&str> = BENEATH.iter().map(|(name, _)| *name).collect();
    for (package, beneath) in BENEATH {
        let drawn = drawn_in(package);
        let found: BTreeSet<&str> = drawn.iter().map(String::as_str).filter(|name| ours.contains(name)).collect();
        assert_eq!(found, beneath.iter().copied().collect(), "{package}");
        let never = NEVER.iter().filter(|(name, _)| *name == package).flat_map(|(_, never)| *never);
        let wrong: Vec<_> = never.filter(|name| drawn.contains(**name)).collect();
        assert!(wrong.is_empty(), "{package} draws in {wrong:?}");
    }
    assert!(drawn_in("fmi-hazard").contains("parry3d-f64"), "what is drawn in is seen");
}

#[test]
fn every_crate_that_is_published_is_listed_here() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let list = ["metadata", "--offline", "--no-deps", "--format-version", "1"];
    let output = Command::new(env!("CARGO")).args(list).current_dir(root).output().unwrap();
    let known: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let published = known["packages"].as_array().unwrap().iter().filter(|package| package["publish"].is_null());
    let names: BTreeSet<&str> = published.map(|package| package["name"].as_str().unwrap()).collect();
    assert_eq!(names, BENEATH.iter().map(|(name, _)| *name).collect());
}
