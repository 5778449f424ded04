//! The example FMUs simulated by our master and by FMPy with the same input table: the same outputs to the last bit.
//! Needs the Python environment that `tools/test` makes.

use crate::common::fmpy::compare;
use crate::common::{examples, test_fmus};

#[test]
fn our_master_and_fmpy_give_the_same_bits_for_every_example_in_both_versions() {
    let dir = examples();
    let mut checked = 0;
    for example in fmi_hazard::examples::all() {
        for (name, _) in example.fmus {
            compare(dir.path(), &dir.path().join(example.name).join(name));
            checked += 1;
        }
    }
    // Fifteen cells, the three parts of one of them and of one more, in FMI 2.0 and FMI 3.0.
    assert_eq!(checked, 42);
}

#[test]
fn the_hostile_fmu_is_an_honest_one_to_fmpy_until_it_is_told_otherwise() {
    let dir = tempfile::TempDir::new().unwrap();
    for name in ["hostile.fmu", "hostile-fmi3.fmu"] {
        compare(dir.path(), &test_fmus().join(name));
    }
}
