//! Our master against FMPy, an importer that this project did not write: the same FMU, the same inputs, the same bits.
//! Needs the Python environment that `tools/test` makes.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::process::Command;

use fmi_hazard::fmi::{Causality, Fmu, Handle, Plan, Variable, VariableType};

use super::write;

/// The Python that `tools/test` makes.
pub fn python() -> PathBuf {
    let own = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(".venv/bin/python");
    let python = std::env::var_os("FMI_HAZARD_PYTHON").map_or(own, PathBuf::from);
    assert!(python.is_file(), "no Python with FMPy at {}: run tools/test once", python.display());
    python
}

const STEPS: u32 = 120;
const STEP_S: f64 = 0.02;

/// An input at a step: Booleans leave their start value from 0.42 to 0.9 s and once more, each at its own time; feet walk
/// into the scanners' fields; other reals wander near their start.
fn input(variable: &Variable, place: usize, step: u32) -> f64 {
    let start = variable.numeric_start().first().copied().unwrap_or(0.0);
    let at = step + 7 * u32::try_from(place).unwrap();
    match variable.kind {
        VariableType::Boolean { .. } if (21..45).contains(&at) || (65..67).contains(&at) => 1.0 - start,
        VariableType::Boolean { .. } => start,
        _ if variable.name.contains("foot.y") => 0.016 * f64::from(at) - 2.0,
        _ => start - 0.004 * f64::from(at % 13),
    }
}

/// Runs an FMU in FMPy and in our master with the same input table; all numeric outputs have the same bits. FMPy must find
/// nothing wrong with the FMU.
pub fn compare(dir: &Path, path: &Path) {
    compare_with(dir, path, &[]);
}

/// The same for an FMU of others, in which FMPy's validation may find mistakes.
pub fn compare_lenient(dir: &Path, path: &Path) {
    compare_with(dir, path, &["--lenient"]);
}

fn compare_with(dir: &Path, path: &Path, options: &[&str]) {
    let fmu = Fmu::open(path).unwrap();
    let of = |causality| fmu.description().variables.iter().filter(move |v| v.causality == causality);
    let inputs: Vec<&Variable> = of(Causality::Input).collect();
    let names: Vec<&str> = inputs.iter().map(|v| v.name.as_str()).collect();
    let mut table = format!("time,{}\n", names.join(","));
    for step in 0..STEPS {
        let _ = write!(table, "{:?}", f64::from(step) * STEP_S);
        for (place, variable) in inputs.iter().enumerate() {
            let _ = write!(table, ",{:?}", input(variable, place, step));
        }
        table.push('\n');
    }
    let table = write(dir, "inputs.csv", &table);
    let out = dir.join("outputs.csv");
    let script = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tools/fmpy_check.py");
    let output = Command::new(python())
        // What our side preloads is of no use to a Python of another version.
        .env_remove("LD_PRELOAD")
        .arg(script)
        .arg(path)
        .args(options)
        .args(["--step", "0.02", "--stop", &format!("{}", f64::from(STEPS) * STEP_S), "--input"])
        .arg(table)
        .arg("--output")
        .arg(&out)
        .output()
        .unwrap();
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "FMPy found problems in {}: {said}", path.display());

    let slave = fmu.load().unwrap();
    let handles = |variables: &[&Variable]| -> Vec<Handle> {
        variables.iter().map(|v| fmu.description().handle(&v.name).unwrap()).collect()
    };
    let outputs: Vec<&Variable> = of(Causality::Output).collect();
    let mut writes = Plan::new(&slave, &handles(&inputs));
    let mut reads = Plan::new(&slave, &handles(&outputs));
    let instance = slave.instantiate("test").unwrap();
    let mut instance = instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap();
    let text = std::fs::read_to_string(out).unwrap();
    let mut lines = text.lines();
    let header: Vec<&str> = lines.next().unwrap().split(',').skip(1).collect();
    assert_eq!(header, outputs.iter().map(|v| v.name.as_str()).collect::<Vec<_>>());
    let (mut row, mut compared, mut ranges) = (vec![0.0; outputs.len()], 0, vec![(f64::MAX, f64::MIN); outputs.len()]);
    for (step, line) in (0..).zip(lines) {
        if step > 0 {
            let values: Vec<f64> = inputs.iter().enumerate().map(|(p, v)| input(v, p, step - 1)).collect();
            writes.write(&mut instance, &values).unwrap();
            instance.do_step(f64::from(step - 1) * STEP_S, STEP_S).unwrap();
        }
        reads.read(&mut instance, &mut row).unwrap();
        for ((theirs, ours), name) in line.split(',').skip(1).zip(&row).zip(&header) {
            let theirs = match theirs {
                "True" => 1.0,
                "False" => 0.0,
                number => number.parse::<f64>().unwrap(),
            };
            assert_eq!(ours.to_bits(), theirs.to_bits(), "{} {name} at step {step}: {ours} {theirs}", path.display());
            compared += 1;
        }
        ranges.iter_mut().zip(&row).for_each(|(r, v)| *r = (r.0.min(*v), r.1.max(*v)));
    }
    assert_eq!(compared, outputs.len() * (STEPS as usize + 1));
    assert!(ranges.iter().any(|(low, high)| high > low), "{}: nothing moved", path.display());
}
