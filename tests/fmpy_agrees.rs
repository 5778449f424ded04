//! The example FMU simulated by our master and by FMPy with the same input table: the same outputs to the last bit.
//! Needs the Python environment that `tools/test` makes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::path::PathBuf;
use std::process::Command;

use common::{examples, write};
use fmi_hazard::fmi::{Causality, Fmu, VariableType};

fn python() -> PathBuf {
    let own = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(".venv/bin/python");
    let python = std::env::var_os("FMI_HAZARD_PYTHON").map_or(own, PathBuf::from);
    assert!(python.is_file(), "no Python with FMPy at {}: run tools/test once", python.display());
    python
}

/// The guard opens at 0.42 s, closes at 0.9 s, and the restart button is pressed at 1.3 s.
fn inputs(step: u32) -> (bool, bool) {
    (!(21..45).contains(&step), (65..67).contains(&step))
}

const STEPS: u32 = 150;

#[test]
fn our_master_and_fmpy_give_the_same_bits() {
    let dir = examples();
    let path = dir.path().join("safety-fence/safety-fence.fmu");
    let mut table = "time,plc.guard_closed,plc.reset\n".to_owned();
    for step in 0..STEPS {
        let (closed, reset) = inputs(step);
        let _ = writeln!(table, "{:?},{},{}", f64::from(step) * 0.02, u8::from(closed), u8::from(reset));
    }
    let table = write(dir.path(), "inputs.csv", &table);
    let out = dir.path().join("outputs.csv");
    let script = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tools/fmpy_check.py");
    let status = Command::new(python())
        .arg(script)
        .arg(&path)
        .args(["--step", "0.02", "--stop", "3", "--input"])
        .arg(table)
        .arg("--output")
        .arg(&out)
        .status()
        .unwrap();
    assert!(status.success(), "FMPy found problems");

    let fmu = Fmu::open(&path).unwrap();
    let reference = |name: &str| fmu.description().variable(name).unwrap().value_reference;
    let instance = fmu.load().unwrap().instantiate("test").unwrap();
    let mut instance = instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap();
    let text = std::fs::read_to_string(out).unwrap();
    let mut lines = text.lines();
    let names: Vec<&str> = lines.next().unwrap().split(',').collect();
    let outputs = fmu.description().variables.iter().filter(|v| v.causality == Causality::Output).count();
    assert_eq!(names.len(), outputs + 1, "{names:?}");
    let (mut compared, mut stopped) = (0, false);
    for (step, line) in (0..).zip(lines) {
        let row: BTreeMap<&str, &str> = names.iter().copied().zip(line.split(',')).collect();
        if step > 0 {
            let (closed, reset) = inputs(step - 1);
            let references = [reference("plc.guard_closed"), reference("plc.reset")];
            instance.set_boolean(&references, &[closed, reset]).unwrap();
            instance.do_step(f64::from(step - 1) * 0.02, 0.02).unwrap();
        }
        for name in &names[1..] {
            let variable = fmu.description().variable(name).unwrap();
            if matches!(variable.kind, VariableType::Integer { .. }) {
                let mut value = [0];
                instance.get_integer(&[variable.value_reference], &mut value).unwrap();
                assert_eq!(value[0].to_string(), row[name], "{name} at step {step}");
                stopped |= *name == "plc.stop_state" && value[0] == 3;
            } else {
                let mut value = [0.0];
                instance.get_real(&[variable.value_reference], &mut value).unwrap();
                let theirs: f64 = row[name].parse().unwrap();
                assert_eq!(value[0].to_bits(), theirs.to_bits(), "{name} at step {step}: {} {theirs}", value[0]);
            }
            compared += 1;
        }
    }
    assert_eq!(compared, outputs * (STEPS as usize + 1));
    assert!(stopped, "the input table never stopped the robot");
}
