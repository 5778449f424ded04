//! A hazard as an MCAP recording, read by the format's own Python library. Needs the feature `mcap` and the Python
//! environment that `tools/test` makes.

use std::path::Path;
use std::process::Command;

use crate::common::fmpy::python;
use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;

#[test]
fn recordings_are_read_by_the_formats_own_library() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    // Frames, capsules and reported sensors; and a cell of several FMUs, which has no traces.
    for (cell, traces) in sample::some([("two-scanners/cell.toml", true), ("sensor-mat/coupled.toml", false)], 2) {
        let few = ["--strategy", "hybrid", "--iterations", "20", "--out", "out"];
        assert_eq!(
            fmi_hazard(dir).args(["scan", "--no-advice", cell]).args(few).output().unwrap().status.code(),
            Some(1),
            "{cell}"
        );
        let hazards = scan_json(&dir.join("out"))["hazards"].as_array().unwrap().clone();
        let id = hazards[0]["id"].as_str().unwrap().to_owned();
        for file in ["a.mcap", "b.mcap"] {
            let output = fmi_hazard(dir).args(["replay", "out", &id, "--mcap", file]).output().unwrap();
            assert_eq!(output.status.code(), Some(1), "{}", String::from_utf8_lossy(&output.stderr));
        }
        let read = |file: &str| std::fs::read(dir.join(file)).unwrap();
        assert!(read("a.mcap") == read("b.mcap"), "the same hazard, other bytes");
        let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("tools/check_mcap.py");
        let mut command = Command::new(python());
        command.arg(script).args([dir.join("a.mcap"), dir.join("out")]).arg(&id);
        let output = command.output().unwrap();
        let said = String::from_utf8_lossy(&output.stdout);
        assert!(output.status.success(), "{said}{}", String::from_utf8_lossy(&output.stderr));
        assert_eq!(said.contains("/fmu/outputs"), traces, "{said}");
        let output = fmi_hazard(dir).args(["replay", "out", "all", "--mcap", "all.mcap"]).output().unwrap();
        assert_eq!(output.status.code(), Some(if hazards.len() > 1 { 2 } else { 1 }));
        assert_eq!(dir.join("all.mcap").exists(), hazards.len() == 1);
    }
}
