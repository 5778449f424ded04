//! Which crate of this repository uses which, held against what cargo knows.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// Each crate that is published, and those that it uses: each stands above all that it uses.
const USES: [(&str, &[&str]); 15] = [
    ("fmi-hazard-examples", &[]),
    ("fmi-hazard-outcome", &[]),
    ("fmi-hazard-search", &[]),
    ("fmi-hazard-stop", &[]),
    ("fmu-self-test", &[]),
    ("fmi-hazard-human", &["fmi-hazard-stop"]),
    ("fmu-host", &["fmi-hazard-stop", "fmu-self-test"]),
    ("fmi-hazard-criteria", &["fmi-hazard-human"]),
    (
        "fmi-hazard-cell",
        &["fmi-hazard-criteria", "fmi-hazard-human", "fmi-hazard-outcome", "fmi-hazard-stop", "fmu-host"],
    ),
    ("fmi-hazard-record", &["fmi-hazard-criteria", "fmi-hazard-human", "fmi-hazard-outcome", "fmu-self-test"]),
    (
        "fmi-hazard-report",
        &["fmi-hazard-criteria", "fmi-hazard-human", "fmi-hazard-outcome", "fmi-hazard-record", "fmu-self-test"],
    ),
    (
        "fmi-hazard-simulation",
        &[
            "fmi-hazard-cell",
            "fmi-hazard-criteria",
            "fmi-hazard-human",
            "fmi-hazard-record",
            "fmi-hazard-search",
            "fmi-hazard-stop",
            "fmu-host",
        ],
    ),
    (
        "fmi-hazard-reachability",
        &[
            "fmi-hazard-cell",
            "fmi-hazard-criteria",
            "fmi-hazard-human",
            "fmi-hazard-search",
            "fmi-hazard-simulation",
            "fmi-hazard-stop",
            "fmu-host",
        ],
    ),
    (
        "fmi-hazard-sequences",
        &[
            "fmi-hazard-cell",
            "fmi-hazard-criteria",
            "fmi-hazard-human",
            "fmi-hazard-search",
            "fmi-hazard-simulation",
            "fmu-host",
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
        ],
    ),
];

/// What of others' packages a crate must not draw in: geometry into what hosts FMUs or searches, the loading of code into what does not, pictures and
/// command lines into what finds hazards.
const NEVER: [(&str, &[&str]); 10] = [
    ("fmi-hazard-sequences", &["clap", "svg"]),
    ("fmi-hazard-reachability", &["clap", "svg"]),
    ("fmi-hazard-report", &["libloading", "zip", "seccompiler", "clap"]),
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
fn no_crate_uses_one_above_it() {
    let list = ["metadata", "--offline", "--no-deps", "--format-version", "1"];
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let output = Command::new(env!("CARGO")).args(list).current_dir(folder).output().unwrap();
    let known: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let name = |of: &serde_json::Value| of["name"].as_str().unwrap().to_owned();
    let published = known["packages"].as_array().unwrap().iter().filter(|package| package["publish"].is_null());
    let names: BTreeSet<String> = published.clone().map(name).collect();
    assert_eq!(names, USES.iter().map(|(name, _)| (*name).to_owned()).collect());
    for package in published {
        let normal = package["dependencies"].as_array().unwrap().iter().filter(|one| one["kind"].is_null());
        let used: BTreeSet<String> = normal.map(name).filter(|name| names.contains(name)).collect();
        let place = USES.iter().position(|(own, _)| *own == name(package)).unwrap();
        assert_eq!(used, USES[place].1.iter().map(|name| (*name).to_owned()).collect(), "{}", USES[place].0);
        let below = |name: &&str| USES[..place].iter().any(|(lower, _)| lower == name);
        assert!(USES[place].1.iter().all(below), "{} uses one above it", USES[place].0);
    }
}

#[test]
fn no_crate_draws_in_what_it_must_not() {
    let all = drawn_in("fmi-hazard");
    for (package, never) in NEVER {
        assert!(never.iter().all(|name| all.contains(*name)), "one that nothing draws in is not looked for: {never:?}");
        let drawn = drawn_in(package);
        let wrong: Vec<_> = never.iter().filter(|name| drawn.contains(**name)).collect();
        assert!(wrong.is_empty(), "{package} draws in {wrong:?}");
    }
}
