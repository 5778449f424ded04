//! The test FMU `guarded`, a bar that turns and a controller with safeguards, and complete searches of cells with it.

use std::ops::ControlFlow;

use fmi_hazard::record::model::ScanReport;
use fmi_hazard::scan::{Exhaustive, Method, Prepared, Progress, ScanOptions, StateChoice, scan};
use fmi_hazard::search::exhaustive::Budget;
use fmi_hazard::sequences::Merge;
use tempfile::TempDir;

/// A folder with the FMU.
pub fn guarded() -> TempDir {
    let dir = TempDir::new().unwrap();
    std::fs::copy(super::test_fmus().join("guarded.fmu"), dir.path().join("guarded.fmu")).unwrap();
    dir
}

/// A bar on a pillar.
pub fn bar(name: &str, x: f64, z: f64) -> String {
    format!(
        r#"[[robot]]
name = "{name}"
base = {{ xyz_m = [{x}, 0, {z}] }}
moving_mass_kg = 40
payload_kg = 3
[[robot.joint]]
name = "axis"
axis = [0, 0, 1]
angle = {{ variable = "q", unit = "rad", offset_deg = -125 }}
speed = {{ variable = "qd", unit = "rad/s" }}
[[robot.link]]
name = "bar"
joint = "axis"
capsule = {{ from_m = [0, 0, 0], to_m = [0.8, 0, 0], radius_m = 0.05 }}
"#
    )
}

/// Every sequence; ends early when only a hazard is asked for.
pub fn every_sequence(prepared: &Prepared, any: bool) -> ScanReport {
    let budget = Budget { states: usize::MAX, bytes: usize::MAX, work: u64::MAX, drop: true };
    let options = ScanOptions {
        method: Method::Exhaustive(Exhaustive { budget, merge: Merge::Auto, workers: 2 }),
        seed: 1,
        iterations: 0,
        stop_at_first: false,
        posture_sweep: true,
        state: StateChoice::Auto,
    };
    let mut tell = |event: Progress<'_>| match event {
        Progress::Level { hazards, .. } if any && hazards > 0 => ControlFlow::Break(()),
        _ => ControlFlow::Continue(()),
    };
    let report = scan(prepared, options, &mut tell).unwrap().report;
    let certificate = report.certificate.as_ref().unwrap();
    // That nobody was near the bar is no reason against it here.
    assert!(certificate.covered == certificate.sequences || (any && !report.hazards.is_empty()), "{certificate:?}");
    report
}
