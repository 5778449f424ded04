//! The example FMUs simulated by our master and by FMPy with the same input table: the same outputs to the last bit.
//! Needs the Python environment that `tools/test` makes.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::common::fmpy::{compare, python};
use crate::common::{examples, test_fmus};
use crate::sample;

#[test]
fn our_master_and_fmpy_give_the_same_bits_for_every_example_in_both_versions() {
    if !sample::is_turn(2, 6) {
        return;
    }
    let dir = examples();
    let mut all = 0;
    for example in fmi_hazard::examples::all() {
        for (name, _) in example.fmus {
            if sample::takes(all, 3) {
                compare(dir.path(), &dir.path().join(example.name).join(name));
            }
            all += 1;
        }
    }
    // Fifteen cells, the three parts of one of them and of one more, in FMI 2.0 and FMI 3.0.
    assert_eq!(all, 42);
}

#[test]
fn the_hostile_fmu_is_an_honest_one_to_fmpy_until_it_is_told_otherwise() {
    let dir = tempfile::TempDir::new().unwrap();
    for name in ["hostile.fmu", "hostile-fmi3.fmu"] {
        compare(dir.path(), &test_fmus().join(name));
    }
}

/// Those that are built for tests alone as well, each for itself.
#[test]
fn fmpy_finds_every_fmu_valid_and_runs_it() {
    if !sample::is_turn(1, 6) {
        return;
    }
    let mut fmus: Vec<PathBuf> = std::fs::read_dir(test_fmus()).unwrap().map(|entry| entry.unwrap().path()).collect();
    fmus.sort();
    assert!(fmus.len() > 42, "{fmus:?}");
    let fmus: Vec<PathBuf> = sample::some(fmus, 4).collect();
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tools/fmpy_check.py");
    let output = Command::new(python()).arg(script).args(&fmus).output().unwrap();
    let said = [output.stdout, output.stderr].map(|said| String::from_utf8_lossy(&said).into_owned()).concat();
    assert!(output.status.success(), "{said}");
    for fmu in fmus {
        assert!(said.contains(&format!("{}: 102 rows", fmu.display())), "{}: {said}", fmu.display());
    }
}
