//! Speeds that an FMU tells against the way that its robot comes: where they disagree nothing is certified, and no cell
//! that tells the truth is accused.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::path::{Path, PathBuf};

use common::{examples, faulty_cell, fmi_hazard, nearer, scan_json, test_fmus, write};
use fmi_hazard::host::Plant as _;
use fmi_hazard::report::speeds::Speeds;
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::sim::World;
use fmi_hazard::sim::motion::{Comparison, Motion};
use serde_json::Value;

/// What is said of a cell's motion over 10 s: idle, and with every sensor reporting for a while, from several moments on.
fn said(path: &Path) -> Speeds {
    let prepared = prepare(path, None).unwrap();
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let comparison = Comparison::new(cell, binding);
    let mut motion = Motion::default();
    let world = World::new(cell.clone(), binding.clone());
    let idle = world.initial_inputs();
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "hundreds")]
    let steps = (10.0 / cell.step_s) as usize;
    for at in [steps, steps / 7, steps / 5, steps / 3, steps / 2] {
        let mut plant = prepared.plant_from(StateChoice::Replay, &idle);
        let mut rows = plant.restart().unwrap();
        let mut stop = idle.clone();
        for (number, sensor) in cell.sensors.iter().enumerate() {
            if let fmi_hazard::cell::binding::SensorBinding::Input(column) = binding.sensors[number] {
                stop[column] = f64::from(u8::from(sensor.active));
            }
        }
        for step in 0..steps {
            let stopped = (at..at + steps / 7).contains(&step);
            rows.extend(plant.advance(1, if stopped { &stop } else { &idle }).unwrap());
        }
        comparison.look(&rows, 0, 0, &mut motion);
    }
    assert!(motion.moved, "{}", path.display());
    Speeds::new(cell, binding, &motion)
}

#[test]
fn no_cell_that_tells_the_truth_is_accused() {
    let dir = examples();
    let mut cells: Vec<PathBuf> = Vec::new();
    for name in ["safety-fence", "sensor-mat", "head-collision", "light-curtain", "two-scanners", "heavy-workpiece"] {
        for file in ["cell.toml", "fixed.toml"] {
            let path = dir.path().join(name).join(file);
            let text = std::fs::read_to_string(&path).unwrap();
            let old = format!("fmu = \"{name}.fmu\"");
            assert!(text.contains(&old));
            let fmi3 = test_fmus().join(format!("{name}-fmi3.fmu"));
            let fmi3 = text.replace(&old, &format!("fmu = \"{}\"", fmi3.display()));
            cells.push(write(dir.path(), &format!("{name}/fmi3-{file}"), &fmi3));
            cells.push(path);
        }
    }
    cells.push(dir.path().join("sensor-mat/coupled.toml"));
    for fmu in ["faulty.fmu", "faulty-fmi3.fmu"] {
        let fmu = test_fmus().join(fmu).display().to_string();
        cells.push(write(dir.path(), "honest.toml", &faulty_cell(&fmu, 0, 0)));
    }
    for cell in &cells {
        let said = said(cell);
        assert_eq!(said.sentences(), Vec::<String>::new(), "{}", cell.display());
    }
}

/// Another `speed` for the joint of the faulty cell, and what is said of it.
const LIES: [(&str, &str); 5] = [
    ("{ variable = \"qd\", plus = { \"qd\" = -1 } }", "is always 0"),
    ("{ variable = \"qd\", sign = -1 }", "opposite sign"),
    ("{ variable = \"qd\", plus = { \"qd\" = 56.29578 } }", "57.3 times"),
    ("{ variable = \"qd\", plus = { \"qd\" = 1 } }", "0.50 times"),
    ("{ variable = \"qd\", plus = { \"qd\" = -0.5 } }", "2.00 times"),
];

const TRUE_SPEED: &str = "{ variable = \"qd\", unit = \"rad/s\" }";

fn scan(dir: &Path, cell: &str, arguments: &[&str]) -> (i32, String, Value) {
    let mut scan = fmi_hazard(dir);
    let output = scan.args(["scan", cell, "--out", "out", "--force"]).args(arguments).output().unwrap();
    let text = [output.stdout, output.stderr].map(|bytes| String::from_utf8_lossy(&bytes).into_owned()).concat();
    (output.status.code().unwrap(), text, scan_json(&dir.join("out")))
}
