//! What cargo packs is what a build reads: the quick side of `tools/release`, which `tools/test --all` runs, where a file that is left out
//! shows as a build that fails.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// What is read in building a package: its name, its folder, and what of that: each is named in a `build.rs` or holds what a source includes.
const READ: [(&str, &str, &[&str]); 15] = [
    ("fmi-hazard", "", &["src", "benches"]),
    ("fmi-hazard-stop", "crates/stop", &["build.rs", "src"]),
    ("fmi-hazard-search", "crates/search", &["src"]),
    ("fmi-hazard-outcome", "crates/outcome", &["src"]),
    ("fmi-hazard-human", "crates/human", &["src"]),
    ("fmi-hazard-criteria", "crates/criteria", &["src"]),
    ("fmi-hazard-record", "crates/record", &["src"]),
    ("fmi-hazard-report", "crates/report", &["src"]),
    ("fmi-hazard-sequences", "crates/sequences", &["src"]),
    ("fmi-hazard-reachability", "crates/reachability", &["src"]),
    ("fmi-hazard-cell", "crates/cell", &["src"]),
    ("fmi-hazard-simulation", "crates/simulation", &["src"]),
    ("fmu-self-test", "crates/self-test", &["src"]),
    ("fmu-host", "crates/fmu-host", &["build.rs", "src"]),
    ("fmi-hazard-examples", "fmus", &["build.rs", "src", "models", "hostile", "scenarios"]),
];

/// All files at or below a path of a package's folder, as paths from there.
fn files(folder: &Path, of: &str, into: &mut BTreeSet<String>) {
    let path = folder.join(of);
    if path.is_dir() {
        for entry in std::fs::read_dir(path).unwrap() {
            files(folder, &format!("{of}/{}", entry.unwrap().file_name().to_string_lossy()), into);
        }
    } else {
        into.insert(of.to_owned());
    }
}

/// What cargo packs of a package.
fn packed(package: &str) -> BTreeSet<String> {
    let list = ["package", "--list", "--allow-dirty", "--offline", "--package", package];
    let output = Command::new(env!("CARGO")).args(list).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect()
}

#[test]
fn what_a_build_reads_is_in_the_packages_and_tests_are_not() {
    let mut all = 0;
    for (package, folder, what) in READ {
        let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
        let mut read = BTreeSet::new();
        what.iter().for_each(|of| files(&folder, of, &mut read));
        all += read.len();
        let packed = packed(package);
        let missing: Vec<_> = read.difference(&packed).collect();
        assert!(missing.is_empty(), "not in the package {package}: {missing:?}");
    }
    assert!(all > 300, "{all}");
    let packed = packed("fmi-hazard");
    for file in ["Cargo.toml", "Cargo.lock", "README.md", "LICENSE-MIT", "LICENSE-APACHE", "pyproject.toml"] {
        assert!(packed.contains(file), "{file}");
    }
    let others = ["tests/", "fuzz/", "tools/", "docs/", "viewer/"];
    let strange: Vec<_> = packed.iter().filter(|file| others.iter().any(|folder| file.starts_with(folder))).collect();
    assert!(strange.is_empty(), "in the package, though nothing reads it: {strange:?}");
}
