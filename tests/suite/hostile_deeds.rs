//! FMUs that reach for the machine, or change the process they run in: a guarded one cannot touch anything, a trusted one
//! can, neither leaves a process behind, and the results are those of the honest FMU.
#![allow(clippy::print_stdout, reason = "figures for who reads the log")]

use std::net::TcpListener;
use std::path::Path;
use std::process::{Child, Command, Output};
use std::time::Duration;

use crate::common::hostile::{FMU, Hostile};
use crate::common::scanned::{Place, Ran};
use crate::sample;
use fmi_hazard::host::Plant as _;
use fmi_hazard::host::isolation::{Guard, Limits};
use fmi_hazard::scan::prepare::prepare_in;
use fmi_hazard::scan::{Hosting, Prepared, StateChoice};

fn prepared(place: &Place, guard: Guard) -> Prepared {
    let program = env!("CARGO_BIN_EXE_fmi-hazard").into();
    prepare_in(&place.cell(), None, &Hosting::Workers { program, guard, limits: Limits::default() }).unwrap()
}

/// Whether a deed in step 2 could be done: what `qd` is after it.
fn done(hostile: &Hostile, guard: Guard, state: StateChoice) -> bool {
    let place = Place::new(hostile);
    let prepared = prepared(&place, guard);
    let mut plant = prepared.plant(state);
    assert_eq!((plant.input_count(), plant.output_count()), (1, 2));
    plant.restart().unwrap();
    let rows = plant.advance(3, &[0.0; 3]).unwrap();
    let shown = rows[5];
    assert!(shown == 0.0 || shown == 1.0, "nothing was tried: {rows:?}");
    shown == 1.0
}

/// Whether this machine can keep FMUs from it: where the kernel lacks what is named so in its warning, a test of it means
/// nothing, which is then to be read in its output.
fn guarded(lacking: &str) -> bool {
    let missing = prepared(&Place::new(&Hostile::v2()), Guard::Sandboxed).missing_protection;
    let lacks = missing.iter().find(|missing| missing.contains(lacking));
    if let Some(lacks) = lacks {
        println!("NOT TESTED on this machine: {lacks}");
    }
    lacks.is_none()
}

/// That a guarded FMU cannot do it, however its states are brought back, and that a trusted one can.
fn only_if_trusted(told: &dyn Fn(&Path) -> Hostile) {
    let place = tempfile::TempDir::new().unwrap();
    let file = place.path().join("file");
    let exists = |expected: bool, hostile: &Hostile| {
        assert_eq!(file.exists(), expected, "{hostile:?}");
        let _ = std::fs::remove_file(&file);
    };
    let hostile = told(&file);
    for state in [StateChoice::Fmu, StateChoice::Fork, StateChoice::Process] {
        assert!(!done(&hostile, Guard::Sandboxed, state), "{hostile:?}");
        exists(false, &hostile);
    }
    assert!(done(&hostile, Guard::Trusted, StateChoice::Fmu), "{hostile:?}");
    let writes = format!("{hostile:?}").contains(&*file.to_string_lossy());
    exists(writes, &hostile);
}

#[test]
fn files_of_others_are_out_of_reach() {
    if !sample::is_turn(0, 4) {
        return;
    }
    if !guarded("has no Landlock") {
        return;
    }
    for hostile in sample::some(Hostile::both(), 2) {
        let deed = |what: &str| hostile.clone().what(what).at("step", 2);
        only_if_trusted(&|file| deed("write-file").path(file));
        only_if_trusted(&|file| deed("exec").path(file));
        only_if_trusted(&|_| deed("read-file").path(Path::new("/etc/passwd")));
        only_if_trusted(&|_| deed("write-resources"));
        // Not even while its binary is loaded.
        let place = Place::new(&hostile);
        let early = hostile.clone().what("write-file").at("load", 1).path(&place.outside());
        Place::new(&early).scan(&["--iterations", "2"]);
        assert!(!place.outside().exists());
        // It may write where it works. That folder is its own, and goes with it.
        assert!(done(&deed("write-cwd"), Guard::Sandboxed, StateChoice::Fmu));
        Place::new(&deed("write-cwd")).scan(&["--iterations", "2"]);
    }
}

#[test]
fn network_and_other_processes_are_out_of_reach() {
    if !guarded("system calls are not filtered") {
        return;
    }
    let listener = TcpListener::bind("127.0.0.1:0").unwrap();
    let port = listener.local_addr().unwrap().port();
    for hostile in sample::some(Hostile::both(), 2) {
        let deed = |what: &str| hostile.clone().what(what).at("step", 2);
        only_if_trusted(&|_| deed("socket-connect").port(port));
        only_if_trusted(&|_| deed("socket-bind").port(0));
        for what in ["child", "child-detached"] {
            assert!(!done(&deed(what), Guard::Sandboxed, StateChoice::Fmu));
            assert!(done(&deed(what), Guard::Trusted, StateChoice::Fmu));
        }
        for state in [StateChoice::Fmu, StateChoice::Fork, StateChoice::Process] {
            assert!(!done(&deed("kill-parent"), Guard::Sandboxed, state));
        }
    }
}

#[test]
fn children_do_not_outlive_a_scan() {
    for (row, what) in ["child", "child-detached"].into_iter().enumerate() {
        for hostile in Hostile::by_turns(row) {
            // Processes that copy themselves cannot be kept from having children.
            for more in [&["--trust-fmu"][..], &["--state", "fork"], &["--trust-fmu", "--state", "fork"]] {
                let place = Place::new(&hostile.clone().what(what).when_stopped(6).size(3600));
                // A short robot: the speed that shows the child is not that of its motion, which makes arm searches long, and
                // nothing certain.
                let cell = std::fs::read_to_string(place.cell()).unwrap();
                std::fs::write(place.cell(), cell.replace("to_m = [1.4, 0, 0]", "to_m = [0.2, 0, 0]")).unwrap();
                let ran = place.scan(more);
                assert!(ran.code == Some(4) && ran.faults().is_empty(), "{what} {more:?}: {ran:?}");
            }
        }
    }
}

/// The scan of the honest FMU of FMI 2.0, of which that of FMI 3.0 is another file of the same findings.
fn honest(more: &[&str]) -> Ran {
    Place::new(&Hostile::v2()).known(more)
}

#[test]
fn what_changes_its_process_changes_no_result() {
    if !sample::is_turn(3, 6) {
        return;
    }
    let honest = honest(&[]);
    for (row, (what, call, at)) in [
        ("locale", "load", 1),
        ("locale", "step", 0),
        ("fpu", "load", 1),
        ("fpu", "get", 9),
        ("signal-handlers", "load", 1),
        ("signal-handlers", "step", 0),
        ("thread-needed", "step", 0),
        ("null-log", "step", 3),
        ("log-from-thread", "step", 3),
    ]
    .into_iter()
    .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            let ran = Place::new(&hostile.what(what).at(call, at)).scan(&[]);
            assert_eq!((ran.code, ran.findings()), (Some(1), honest.findings()), "{what} in {call}");
            assert_eq!((ran.rung(), ran.replaced()), ("saved_states", 0), "{what} in {call}");
        }
    }
    // These show what they did in an output when they do it in a step.
    for (row, what) in ["chdir", "thread"].into_iter().enumerate() {
        for hostile in Hostile::by_turns(row) {
            let ran = Place::new(&hostile.what(what).at("setup", 99)).scan(&[]);
            assert_eq!((ran.code, ran.findings()), (Some(1), honest.findings()), "{what}");
        }
    }
}

#[test]
fn threads_are_not_copied_and_the_self_test_says_so() {
    for hostile in sample::some(Hostile::both(), 2) {
        for what in ["thread", "thread-needed"] {
            let place = Place::new(&hostile.clone().what(what));
            let ran =
                place.after(place.command(&["inspect", "--self-test", FMU, "--format", "json"]).output().unwrap());
            let result: serde_json::Value = serde_json::from_slice(&ran.stdout).unwrap();
            let reason = "the FMU runs 1 thread of its own, which a copy does not have";
            assert_eq!(result["fork"], serde_json::json!({ "result": "failed", "reason": reason }));
            assert_eq!((result["restore"]["result"].as_str(), ran.code), (Some("exact"), Some(0)));
        }
        // Without saved states it then is run again.
        let ran = Place::new(&hostile.clone().what("thread-needed").saves(false).serializes(false)).scan(&[]);
        assert_eq!((ran.code, ran.rung()), (Some(1), "instances"));
        let place = Place::new(&hostile.clone().what("child"));
        let ran = place.after(place.command(&["inspect", "--self-test", FMU, "--trust-fmu"]).output().unwrap());
        let text = String::from_utf8(ran.stdout).unwrap();
        assert!(text.contains("FAILED: the FMU has started other processes, which are not copied"), "{text}");
    }
}

#[test]
fn what_it_prints_goes_to_a_log() {
    if !sample::is_turn(2, 4) {
        return;
    }
    let large = if sample::is_whole() { 3_000_000 } else { 1_200_000 };
    let more: &[&str] = if sample::is_whole() { &[] } else { &["--iterations", "12"] };
    for hostile in sample::some(Hostile::both(), 2) {
        let honest = honest(more);
        for (what, size) in [("print", large), ("print", 300)] {
            let place = Place::new(&hostile.clone().what(what).at("step", 2).size(size));
            let ran = place.scan(&[more, &["--format", "json"]].concat());
            assert_eq!((ran.code, ran.findings()), (Some(1), honest.findings()));
            // Standard output is JSON and nothing else, the terminal is left alone.
            assert_eq!(serde_json::from_slice::<serde_json::Value>(&ran.stdout).unwrap(), ran.scan);
            assert!(!ran.stderr.contains("something to say"), "{}", ran.stderr);
            let printed = ran.run["fmu_printed_bytes"].as_u64().unwrap();
            assert!(
                ran.stderr.contains(&format!("Note the FMU printed {printed} bytes, the first megabyte of it is in"))
            );
            let log = ran.log.unwrap();
            assert!(log.starts_with(b"the FMU has something to say "));
            assert!(log.len() <= 1 << 20 && (size < 1 << 20 || (printed > 1 << 22 && log.len() > 1_000_000)));
        }
        assert!(honest.log.is_none() && honest.run["fmu_printed_bytes"] == 0);
    }
}

/// A scan without an end that has found something already.
fn endless(place: &Place) -> Child {
    let child = place.command(&Place::scan_arguments(&["--iterations", "4000000000"])).spawn().unwrap();
    let log = place.work().join("out/hazards.jsonl");
    while std::fs::read_to_string(&log).map_or(true, |text| !text.contains('\n')) {
        std::thread::sleep(Duration::from_millis(5));
    }
    assert!(!place.processes().is_empty(), "this test would not see processes that are left");
    child
}

fn send(signal: &str, child: &Child) {
    let sent = Command::new("kill").args([format!("-{signal}"), child.id().to_string()]).status().unwrap();
    assert!(sent.success());
}

fn end(child: Child) -> Output {
    child.wait_with_output().unwrap()
}

#[test]
fn an_interrupted_scan_takes_a_deaf_fmu_with_it() {
    for hostile in Hostile::both() {
        for signal in ["INT", "TERM"] {
            let place = Place::new(&hostile.clone().what("signal-handlers").at("load", 1));
            let child = endless(&place);
            send(signal, &child);
            let ran = place.after(end(child));
            assert_eq!(ran.code, Some(130), "{signal}: {}", ran.stderr);
            assert!(!ran.hazards().is_empty() && ran.confirmed() && ran.faults().is_empty(), "{signal}");
        }
    }
}

#[test]
fn a_killed_scan_takes_a_deaf_fmu_with_it_and_the_next_one_tidies_up() {
    for hostile in Hostile::both() {
        let place = Place::new(&hostile.what("signal-handlers").at("load", 1));
        let child = endless(&place);
        send("KILL", &child);
        assert_eq!(end(child).status.code(), None);
        place.nobody_left();
        let ran = place.scan(&["--strategy", "random", "--iterations", "2"]);
        assert!(ran.code.is_some_and(|code| code < 5), "{ran:?}");
    }
}
