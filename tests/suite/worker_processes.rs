//! FMUs in worker processes: whichever way states are brought back, the result is the same; and what an FMU leaks does not
//! add up.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::common::hostile::Hostile;
use crate::common::{examples, fmi_hazard, json};
use crate::sample;
use fmi_hazard::fmi::Fmu;
use fmi_hazard::host::isolation::{Guard, Isolated, Launcher, Limits, Unpacked, WorkerRestore};
use fmi_hazard::host::port::Port;
use fmi_hazard::host::{Plant as _, SystemSetup, UnitPort};

fn program() -> PathBuf {
    PathBuf::from(env!("CARGO_BIN_EXE_fmi-hazard"))
}

/// What is said of a way of bringing states back that was asked for.
fn by(state: &str) -> &'static str {
    match state {
        "fmu" => "saved_states",
        "fork" => "copies",
        "replay" => "instances",
        _ => "processes",
    }
}

#[test]
fn every_cell_gives_the_same_bytes_on_every_rung() {
    let dir = examples();
    let mut cells: Vec<String> = std::fs::read_dir(dir.path())
        .unwrap()
        .map(|entry| format!("{}/cell.toml", entry.unwrap().file_name().to_string_lossy()))
        .filter(|cell| dir.path().join(cell).is_file())
        .collect();
    cells.sort();
    assert_eq!(cells.len(), 16);
    cells.push("sensor-mat/coupled.toml".to_owned());
    let mut went: BTreeMap<&str, [u64; 2]> = BTreeMap::new();
    // In each of eight shares there is a cell in which something is brought back.
    for (number, cell) in sample::some(cells.into_iter().enumerate(), 8) {
        // Its saved states, and one other rung: cells of the same run take turns with them.
        let others = ["replay", "fork", "process"].into_iter().enumerate();
        let others = others.filter(|(other, _)| sample::takes(other + number / 8, 3)).map(|(_, state)| state);
        let results = std::iter::once("fmu").chain(others).map(|state| {
            let args = [
                "scan",
                "--no-advice",
                &cell,
                "--strategy",
                "mcts-dpw",
                "--iterations",
                "6",
                "--state",
                state,
                "--out",
                state,
            ];
            let code = fmi_hazard(dir.path()).args(args).output().unwrap().status.code();
            assert!(matches!(code, Some(1 | 4)), "{cell} {state}: {code:?}");
            let effort = json(&dir.path().join(state).join("run.json"));
            assert_eq!(effort["states_by"], by(state), "{cell}");
            let count = |what: &str| effort["fmu"][what].as_u64().unwrap();
            let own = went.entry(state).or_insert([0, 0]);
            *own = [own[0] + count("restores"), own[1] + count("restarts")];
            std::fs::read_to_string(dir.path().join(state).join("scan.json")).unwrap()
        });
        let results: Vec<String> = results.collect();
        for result in &results {
            let differs = result.lines().zip(results[0].lines()).find(|(line, first)| line != first);
            assert!(result == &results[0], "{cell}: {differs:?}");
        }
    }
    // Each really went its own way. Of a share copies have one cell only, which may need none.
    let enough = if sample::is_whole() { 20 } else { 0 };
    for (state, [restores, restarts]) in went {
        let own = match state {
            "fmu" => restores > enough,
            "fork" => restores > enough || !sample::is_whole(),
            _ => restores == 0 && restarts > enough,
        };
        assert!(own, "{state}: {restores} {restarts}");
    }
}

/// All sequences of three actions: in this cell equal states are told by their bytes.
#[test]
fn an_exhaustive_search_gives_the_same_certificate_on_every_rung() {
    let dir = examples();
    let cell = std::fs::read_to_string(dir.path().join("heavy-workpiece/cell.toml")).unwrap();
    let short = dir.path().join("heavy-workpiece/short.toml");
    std::fs::write(&short, cell + "\n[search]\nactions = 3\n").unwrap();
    let results = ["fmu", "fork", "replay", "process"].map(|state| {
        let args = [
            "scan",
            "--no-advice",
            "heavy-workpiece/short.toml",
            "--strategy",
            "exhaustive",
            "--state",
            state,
            "--out",
            state,
        ];
        let output = fmi_hazard(dir.path()).args(args).output().unwrap();
        assert!(matches!(output.status.code(), Some(0 | 1 | 4)), "{}", String::from_utf8_lossy(&output.stderr));
        std::fs::read_to_string(dir.path().join(state).join("scan.json")).unwrap()
    });
    assert!(results.iter().all(|r| *r == results[0]));
    assert!(results[0].contains("\"sequences\": \"46656\""));
}

/// A plant of the FMU at `path` with all that the tests need of it.
fn plant(path: &Path, keeping: WorkerRestore, limits: Limits) -> (Fmu, Isolated) {
    let fmu = Fmu::open(path).unwrap();
    let port = |name: &str| {
        let handle = fmu.description().handle(name).unwrap();
        UnitPort { unit: 0, port: Port::new(name.to_owned(), handle, 0.0).unwrap() }
    };
    let setup = SystemSetup {
        names: vec![String::new()],
        inputs: vec![port("stop")],
        initial_inputs: vec![0.0],
        outputs: vec![port("q")],
        step_s: 0.02,
        ..SystemSetup::default()
    };
    let launcher = Launcher::new(program(), vec![Unpacked::of(&fmu)], setup, Guard::Sandboxed, limits);
    (fmu, Isolated::new(launcher, keeping))
}

fn resident(pid: u32) -> u64 {
    let pages = std::fs::read_to_string(format!("/proc/{pid}/statm")).unwrap_or_default();
    pages.split_whitespace().nth(1).and_then(|p| p.parse::<u64>().ok()).unwrap_or(0) * 4096
}

#[test]
fn a_hundred_thousand_steps_of_an_fmu_that_leaks_take_bounded_memory() {
    let dir = tempfile::TempDir::new().unwrap();
    // 20 kB a step: 2 GB without an end.
    let path = Hostile::v2().what("leak").size(20_000).write(dir.path());
    let limits = Limits { growth: 64 << 20, ..Limits::default() };
    let (_fmu, mut plant) = plant(&path, WorkerRestore::Instances, limits);
    let (inputs, mut first, mut most, mut workers) = (vec![0.0; 1000], None, 0, BTreeSet::new());
    // A million steps, where all cases are looked at.
    let runs = if sample::is_whole() { 1000 } else { 100 };
    for _ in 0..runs {
        plant.restart().unwrap();
        let run = plant.advance(1000, &inputs).unwrap();
        assert_eq!(first.get_or_insert_with(|| run.clone()), &run);
        let [pid, _] = plant.pids().unwrap();
        most = most.max(resident(pid));
        workers.insert(pid);
    }
    // The limit, a run of a thousand steps, and the worker itself.
    assert!(most < (64 << 20) + 20_000_000 + (32 << 20), "{most} bytes");
    assert!(most > 64 << 20 && workers.len() > runs / 5, "{most} bytes, {} workers: does it leak?", workers.len());
}

/// Sends a signal to a process.
fn signal(name: &str, pid: u32) {
    assert!(Command::new("kill").args([name, &pid.to_string()]).status().unwrap().success());
}

/// On a busy machine a process that is to go may do so late: nobody else is woken in its stead.
#[test]
fn a_parked_state_that_goes_late_is_not_taken_for_another() {
    let dir = tempfile::TempDir::new().unwrap();
    let (_fmu, mut plant) = plant(&Hostile::v2().write(dir.path()), WorkerRestore::ByFork, Limits::default());
    plant.restart().unwrap();
    let children = |pid: u32| -> BTreeSet<u32> {
        let list = std::fs::read_to_string(format!("/proc/{pid}/task/{pid}/children")).unwrap();
        list.split_whitespace().map(|pid| pid.parse().unwrap()).collect()
    };
    let [live, _] = plant.pids().unwrap();
    let early = plant.save().unwrap();
    let parked = *children(live).first().unwrap();
    let run = plant.advance(60, &[0.0; 60]).unwrap();
    signal("-STOP", parked);
    drop(early);
    let late: Vec<_> = (0..3).map(|_| plant.save().unwrap()).collect();
    let on = plant.advance(60, &[0.0; 60]).unwrap();
    assert_ne!(run, on);
    signal("-CONT", parked);
    // Time to go, or to take the place of another.
    std::thread::sleep(std::time::Duration::from_millis(50));
    for state in late.iter().cycle().take(60) {
        plant.restore(state).unwrap();
        assert_eq!(plant.advance(60, &[0.0; 60]).unwrap(), on);
    }
    assert_eq!(plant.replaced(), 0);
}

#[test]
fn a_worker_has_its_time() {
    let dir = tempfile::TempDir::new().unwrap();
    let path = Hostile::v2().write(dir.path());
    let (_fmu, mut plant) = plant(&path, WorkerRestore::ByFmu, Limits { steps: 100, ..Limits::default() });
    plant.restart().unwrap();
    let at_start = plant.save().unwrap();
    let first = plant.pids();
    let run = plant.advance(60, &[0.0; 60]).unwrap();
    plant.restore(&at_start).unwrap();
    // Not in the middle of a run, however long.
    assert_eq!(plant.advance(60, &[0.0; 60]).unwrap(), run);
    assert_eq!((plant.pids(), plant.holds(&at_start)), (first, true));
    // But where it begins anew: its states are gone then, and it is told.
    let error = plant.restore(&at_start).unwrap_err();
    assert!(error.lost && !plant.holds(&at_start) && plant.pids().is_none(), "{error}");
    plant.restart().unwrap();
    assert_eq!(plant.advance(60, &[0.0; 60]).unwrap(), run);
    assert!(plant.pids().is_some() && plant.pids() != first);
    assert_eq!(plant.replaced(), 0, "nothing failed");
}

/// The processors on which a process may run.
fn processors(pid: u32) -> String {
    let status = std::fs::read_to_string(format!("/proc/{pid}/status")).unwrap();
    status.lines().find_map(|line| line.strip_prefix("Cpus_allowed_list:")).unwrap().trim().to_owned()
}

#[test]
fn a_worker_shares_a_processor_with_whoever_asks_it_unless_it_has_threads() {
    let anywhere = processors(std::process::id());
    for (hostile, alone) in [(Hostile::v2(), true), (Hostile::v2().what("thread").at("step", 20), false)] {
        let dir = tempfile::TempDir::new().unwrap();
        let (_fmu, mut plant) = plant(&hostile.write(dir.path()), WorkerRestore::ByFmu, Limits::default());
        plant.restart().unwrap();
        let pid = plant.pids().unwrap()[0];
        assert_eq!(processors(pid), anywhere, "it has shown nothing yet");
        plant.advance(10, &[0.0; 10]).unwrap();
        assert!(processors(pid).parse::<u32>().is_ok(), "{}", processors(pid));
        // Its threads are seen after some questions at the latest.
        for _ in 0..5000 {
            plant.advance(10, &[0.0; 10]).unwrap();
        }
        assert_eq!(processors(pid) != anywhere, alone || anywhere.parse::<u32>().is_ok());
        assert_eq!(processors(std::process::id()), anywhere, "this thread may go anywhere again");
    }
}
