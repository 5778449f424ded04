//! FMI 3.0 FMUs that use what FMI 2.0 does not have: early return, end of the simulation, event mode, all types of
//! variables. Each is handled, or refused with a message that says what to do.

use std::path::Path;

use crate::common::{faulty_cell, fmi_hazard, scan_json, test_fmus, write};
use fmi_hazard::fmi::{EventMode, Fmu, Values};

/// The faulty FMU of FMI 3.0 with a fault, beside its cell.
fn faulty(kind: i32, step: i32) -> tempfile::TempDir {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::copy(test_fmus().join("faulty-fmi3.fmu"), dir.path().join("faulty.fmu")).unwrap();
    write(dir.path(), "cell.toml", &faulty_cell("faulty.fmu", kind, step));
    dir
}

fn coverage(dir: &Path) -> serde_json::Value {
    let _ = fmi_hazard(dir)
        .args(["scan", "--no-advice", "cell.toml", "--strategy", "mcts-dpw", "--out", "o"])
        .output()
        .unwrap();
    scan_json(&dir.join("o"))["coverage"].clone()
}

#[test]
fn an_early_return_is_stepped_on_and_changes_nothing() {
    let honest = coverage(faulty(0, 0).path());
    assert_eq!(coverage(faulty(10, 3).path()), honest);
}

#[test]
fn an_fmu_that_ends_the_simulation_or_lies_about_its_time_is_exit_code_3() {
    for (kind, words) in [(3, "iscard"), (11, "asked to end the simulation"), (13, "0.1")] {
        let dir = faulty(kind, 5);
        let output = fmi_hazard(dir.path())
            .args(["scan", "--no-advice", "cell.toml", "--strategy", "mcts-dpw"])
            .assert()
            .code(3)
            .get_output()
            .clone();
        let text = String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(words) && text.contains("selftest"), "fault {kind}: {text}");
    }
}

#[test]
fn an_event_gives_the_same_with_event_mode_and_without() {
    let fmu = Fmu::open(&test_fmus().join("faulty-fmi3.fmu")).unwrap();
    let slave = fmu.load().unwrap();
    let reference = |name: &str| fmu.description().variable(name).unwrap().value_reference;
    let run = |mode: EventMode| {
        let mut instance = slave.instantiate_with("test", mode).unwrap();
        instance.set_integer(&[reference("fault.kind"), reference("fault.step")], &[12, 3]).unwrap();
        let mut instance = instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap();
        let (uses, mut angles) = (instance.uses_event_mode(), Vec::new());
        for step in 0..30 {
            instance.do_step(f64::from(step) * 0.02, 0.02).unwrap();
            let mut q = [0.0];
            instance.get_real(&[reference("q")], &mut q).unwrap();
            angles.push(q[0].to_bits());
        }
        (uses, angles)
    };
    let ((with, a), (without, b)) = (run(EventMode::Used), run(EventMode::Unused));
    assert!(with && !without);
    assert_eq!(a, b);
}

#[test]
fn every_type_of_variable_is_read_without_failing() {
    let fmu = Fmu::open(&test_fmus().join("types3.fmu")).unwrap();
    let description = fmu.description();
    let slave = fmu.load().unwrap();
    let instance = slave.instantiate("test").unwrap();
    let mut instance = instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap();
    instance.do_step(0.0, 0.02).unwrap();
    let mut kinds = std::collections::BTreeSet::new();
    for variable in &description.variables {
        let count = description.count(variable).unwrap();
        let values = instance.values(variable, count).unwrap_or_else(|e| panic!("{}: {e}", variable.name));
        kinds.insert(format!("{:?}", variable.scalar));
        if variable.name == "sized_array" {
            // As long as the structural parameter n says: 4; element k is k q.
            assert_eq!(count, 4);
            let mut q = [0.0];
            instance.get_real(&[description.variable("q").unwrap().value_reference], &mut q).unwrap();
            let Values::Real(array) = values else { panic!("{values:?}") };
            assert!(q[0] > 0.0);
            for (k, value) in (1..).zip(array) {
                assert!((value - f64::from(k) * q[0]).abs() < 1e-12, "{value} {k}");
            }
        }
    }
    assert_eq!(kinds.len(), 14, "all types of FMI 3.0, the enumeration as a whole number: {kinds:?}");
}

#[test]
fn array_elements_can_be_bound_and_other_types_are_refused_in_words() {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::copy(test_fmus().join("types3.fmu"), dir.path().join("types3.fmu")).unwrap();
    let cell = faulty_cell("types3.fmu", 0, 0);
    let cell = cell.split("[parameters]").next().unwrap().to_owned()
        + "[human]\nstart = { xy_m = [0, -1.6], heading_deg = 90 }\n[search]\niterations = 12\n";
    let angle = |variable: &str| cell.replace("variable = \"q\"", &format!("variable = \"{variable}\""));
    write(dir.path(), "plain.toml", &cell);
    write(dir.path(), "array.toml", &angle("sized_array[1]"));
    let of = |file: &str| {
        let out = file.replace(".toml", "-out");
        let _ = fmi_hazard(dir.path())
            .args(["scan", "--no-advice", file, "--strategy", "mcts-dpw", "--out", &out])
            .output()
            .unwrap();
        scan_json(&dir.path().join(out))["coverage"].clone()
    };
    // The first element is q itself.
    assert_eq!(of("array.toml"), of("plain.toml"));
    for (variable, words) in [
        ("sized_array[5]", "sized_array[4]"),
        ("sized_array", "array of 4"),
        ("String.output", "String"),
        ("Binary.output", "Binary"),
    ] {
        write(dir.path(), "wrong.toml", &angle(variable));
        let output =
            fmi_hazard(dir.path()).args(["scan", "--no-advice", "wrong.toml"]).assert().code(2).get_output().clone();
        let text = String::from_utf8_lossy(&output.stderr).into_owned();
        assert!(text.contains(words), "{variable}: {text}");
    }
}
