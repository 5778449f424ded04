//! Workers that something else kills, at any time: the result of a scan does not change.
//!
//! On its own in this file, because it kills all workers of its process.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

#[path = "suite/common/mod.rs"]
#[allow(dead_code, reason = "this program uses little of it")]
mod common;
use fmi_hazard_sample as sample;

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

use common::examples;
use fmi_hazard::host::isolation::{Guard, Limits};
use fmi_hazard::scan::options::Method;
use fmi_hazard::scan::prepare::prepare_in;
use fmi_hazard::scan::{Hosting, Prepared, ScanOptions, StateChoice, StrategyName, scan};
use fmi_hazard::search::Rng;

fn hosting() -> Hosting {
    let program = PathBuf::from(env!("CARGO_BIN_EXE_fmi-hazard"));
    Hosting::Workers { program, guard: Guard::Sandboxed, limits: Limits::default() }
}

/// Processes below `parent`, and below them.
fn descendants(parent: u32) -> Vec<u32> {
    let mut all = Vec::new();
    let tasks = std::fs::read_dir(format!("/proc/{parent}/task")).into_iter().flatten().flatten();
    for task in tasks {
        let children = std::fs::read_to_string(task.path().join("children")).unwrap_or_default();
        for child in children.split_whitespace().filter_map(|pid| pid.parse().ok()) {
            all.push(child);
            all.extend(descendants(child));
        }
    }
    all
}

fn is_worker(pid: u32) -> bool {
    std::fs::read(format!("/proc/{pid}/cmdline")).is_ok_and(|line| line.split(|b| *b == 0).nth(1) == Some(b"worker"))
}

fn report(cell: &Prepared, state: StateChoice) -> (String, u64) {
    let options = ScanOptions {
        method: Method::Strategy(StrategyName::MctsDpw),
        seed: 3,
        iterations: 12,
        stop_at_first: false,
        posture_sweep: false,
        state,
    };
    let scanned = scan(cell, options, &mut |_| ControlFlow::Continue(())).unwrap();
    (serde_json::to_string(&scanned.report).unwrap(), scanned.effort.workers_replaced)
}

/// Raises a flag at the end of its life, also when a test fails.
struct Raise<'a>(&'a AtomicBool);

impl Drop for Raise<'_> {
    fn drop(&mut self) {
        self.0.store(true, Ordering::Relaxed);
    }
}

#[test]
fn workers_killed_at_any_time_change_nothing() {
    let dir = examples();
    let cell = prepare_in(&dir.path().join("safety-fence/cell.toml"), None, &hosting()).unwrap();
    let (kills, over) = (AtomicU64::new(0), AtomicBool::new(false));
    let states = [StateChoice::Fork, StateChoice::Process, StateChoice::Replay];
    let undisturbed = states.map(|state| report(&cell, state).0);
    // A hundred of them where all cases are looked at.
    let enough = if sample::is_whole() { 34 } else { 10 };
    assert!(undisturbed[0].contains("H-"), "there is something to find");
    std::thread::scope(|scope| {
        let _end = Raise(&over);
        scope.spawn(|| {
            let mut rng = Rng::new(17);
            while !over.load(Ordering::Relaxed) {
                std::thread::sleep(Duration::from_micros(30_000 + u64::try_from(rng.below(90_000)).unwrap()));
                let family: Vec<u32> =
                    descendants(std::process::id()).into_iter().filter(|pid| is_worker(*pid)).collect();
                let Some(victim) = family.get(rng.below(family.len().max(1))) else { continue };
                let killed = std::process::Command::new("kill").args(["-9", &victim.to_string()]).status().unwrap();
                kills.fetch_add(u64::from(killed.success()), Ordering::Relaxed);
            }
        });
        let mut replaced = 0;
        for (state, undisturbed) in states.into_iter().zip(&undisturbed) {
            let before = kills.load(Ordering::Relaxed);
            while kills.load(Ordering::Relaxed) < before + enough {
                let (disturbed, workers) = report(&cell, state);
                assert!(disturbed == *undisturbed, "{state:?}: {disturbed}");
                replaced += workers;
            }
        }
        // Many meet a worker at the end of its life, or only a copy that nobody needs any more: it goes on until some meet another.
        for (state, undisturbed) in states.into_iter().zip(&undisturbed).cycle() {
            if replaced >= enough / 10 {
                break;
            }
            assert!(kills.load(Ordering::Relaxed) < 100 * enough, "{replaced}");
            let (disturbed, workers) = report(&cell, state);
            assert!(disturbed == *undisturbed, "{state:?}: {disturbed}");
            replaced += workers;
        }
    });
}
