//! What cargo packs is what a build reads: the quick side of `tools/release`, which `tools/test --all` runs, where a file that is left out
//! shows as a build that fails.

use std::collections::BTreeSet;
use std::path::Path;
use std::process::Command;

/// What of the repository is read in building: each of these folders is named in `build.rs` or holds what a source includes.
const READ: [&str; 6] = ["build.rs", "src", "fmus/src", "fmus/hostile", "scenarios", "benches"];

/// All files at or below a path of the repository, as paths from its root.
fn files(of: &str, into: &mut BTreeSet<String>) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(of);
    if path.is_dir() {
        for entry in std::fs::read_dir(path).unwrap() {
            files(&format!("{of}/{}", entry.unwrap().file_name().to_string_lossy()), into);
        }
    } else {
        into.insert(of.to_owned());
    }
}

#[test]
fn what_a_build_reads_is_in_the_package_and_tests_are_not() {
    let list = ["package", "--list", "--allow-dirty", "--offline", "--package", "fmi-hazard"];
    let output = Command::new(env!("CARGO")).args(list).current_dir(env!("CARGO_MANIFEST_DIR")).output().unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let packed: BTreeSet<String> = String::from_utf8(output.stdout).unwrap().lines().map(str::to_owned).collect();
    let mut read = BTreeSet::new();
    READ.iter().for_each(|of| files(of, &mut read));
    assert!(read.len() > 300, "{read:?}");
    let missing: Vec<_> = read.difference(&packed).collect();
    assert!(missing.is_empty(), "not in the package: {missing:?}");
    for file in ["Cargo.toml", "Cargo.lock", "README.md", "LICENSE-MIT", "LICENSE-APACHE", "pyproject.toml"] {
        assert!(packed.contains(file), "{file}");
    }
    let others = ["tests/", "fuzz/", "tools/", "docs/", "viewer/"];
    let strange: Vec<_> = packed.iter().filter(|file| others.iter().any(|folder| file.starts_with(folder))).collect();
    assert!(strange.is_empty(), "in the package, though nothing reads it: {strange:?}");
}
