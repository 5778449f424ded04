//! FMI 3.0 FMUs that use what FMI 2.0 does not have: early return, end of the simulation, event mode, all types of
//! variables. Each is handled, or refused with a message that says what to do.

use std::path::Path;

use crate::common::fmpy::python;
use crate::common::{faulty_cell, fmi_hazard, scan_json, test_fmus, write};
use fmi_hazard::fmi::{EventMode, Fmu, Values};

/// The faulty FMU of FMI 3.0 with a fault, beside its cell.
fn faulty(kind: i32, step: i32) -> tempfile::TempDir {
    faulty_of("faulty-fmi3.fmu", kind, step)
}

fn faulty_of(fmu: &str, kind: i32, step: i32) -> tempfile::TempDir {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::copy(test_fmus().join(fmu), dir.path().join("faulty.fmu")).unwrap();
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
        assert!(text.contains(words) && text.contains("--self-test"), "fault {kind}: {text}");
    }
}

/// The angle after each of thirty steps of the faulty FMU with a fault in the fourth.
fn angles(kind: i32, mode: EventMode) -> Result<Vec<f64>, fmi_hazard::fmi::Error> {
    let fmu = Fmu::open(&test_fmus().join("faulty-fmi3.fmu")).unwrap();
    let slave = fmu.load().unwrap();
    let reference = |name: &str| fmu.description().variable(name).unwrap().value_reference;
    let mut instance = slave.instantiate_with("test", mode).unwrap();
    instance.set_integer(&[reference("fault.kind"), reference("fault.step")], &[kind, 3]).unwrap();
    let mut instance = instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap();
    assert_eq!(instance.uses_event_mode(), mode == EventMode::Used);
    let mut angles = Vec::new();
    for step in 0..30 {
        instance.do_step(f64::from(step) * 0.02, 0.02)?;
        let mut q = [0.0];
        instance.get_real(&[reference("q")], &mut q).unwrap();
        angles.push(q[0]);
    }
    Ok(angles)
}

/// With the event at the end of a step, and halfway: there an FMU that returns early leaves it to the importer, even to one without Event
/// Mode. As FMPy has it, with both and without.
#[test]
fn an_event_gives_the_same_with_event_mode_and_without_and_as_in_fmpy() {
    let honest = angles(0, EventMode::Unused).unwrap();
    assert_eq!(angles(10, EventMode::Used).unwrap(), honest, "an early return without an event");
    for kind in [12, 16] {
        let [with, without] = [EventMode::Used, EventMode::Unused].map(|mode| angles(kind, mode).unwrap());
        assert_eq!(with, without, "fault {kind}");
        assert!(honest[29] < 0.7 * with[29], "the pace is doubled: {} {}", honest[29], with[29]);
        for both in ["True", "False"] {
            let script = format!(
                "import sys, fmpy\n\
                 told = fmpy.simulate_fmu(sys.argv[1], stop_time=0.6, output_interval=0.02, output=['q'], \
                 start_values={{'fault.kind': {kind}, 'fault.step': 3}}, early_return_allowed={both}, use_event_mode={both})\n\
                 at = {{round(float(t) * 1000): float(q) for t, q in told}}\n\
                 print(*[repr(at[20 * n]) for n in range(1, 31)])"
            );
            let fmu = test_fmus().join("faulty-fmi3.fmu");
            let output = std::process::Command::new(python()).args(["-c", &script]).arg(fmu).output().unwrap();
            assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
            let told = String::from_utf8_lossy(&output.stdout).into_owned();
            let told: Vec<f64> = told.split_whitespace().map(|q| q.parse().unwrap()).collect();
            assert_eq!(told, with, "fault {kind}, FMPy with both {both}");
        }
    }
}

/// An event that is left to an importer without Event Mode is told; a scan uses Event Mode then.
#[test]
fn an_event_that_is_left_to_the_importer_is_followed_or_told() {
    let told = angles(17, EventMode::Unused).unwrap_err().to_string();
    let words = "the FMU ended a step at t = 0.08 s for an event that is to be handled in Event Mode";
    assert!(told.contains(words), "{told}");
    assert_eq!(angles(17, EventMode::Used).unwrap(), angles(12, EventMode::Used).unwrap());
    let of = [12, 16, 17].map(|kind| coverage(faulty(kind, 3).path()));
    assert_eq!((&of[0], &of[1]), (&of[2], &coverage(faulty_of("faulty.fmu", 16, 3).path())));
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
