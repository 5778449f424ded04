//! The FMU that does harm on purpose: honest until told otherwise, it really does what it is told, and what the
//! self-test finds out about it.

use std::path::Path;

use crate::common::hostile::{FMU, Hostile};
use crate::common::{fmi_hazard, test_fmus};
use crate::sample;
use fmi_hazard::fmi::{Fmu, Handle, Plan};
use tempfile::TempDir;

const STEP_S: f64 = 0.02;

/// q and qd at the start and after each step; the drive is stopped for a while, and pushed all the time.
fn run(path: &Path, steps: u32) -> Vec<[f64; 2]> {
    let fmu = Fmu::open(path).unwrap();
    let slave = fmu.load().unwrap();
    let handles = |names: [&str; 2]| -> Vec<Handle> {
        names.iter().map(|name| fmu.description().handle(name).unwrap()).collect()
    };
    let mut inputs = Plan::new(&slave, &handles(["stop", "push"]));
    let mut outputs = Plan::new(&slave, &handles(["q", "qd"]));
    let instance = slave.instantiate("test").unwrap();
    let mut instance = instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap();
    let mut rows = Vec::new();
    for step in 0..=steps {
        let mut row = [0.0; 2];
        outputs.read(&mut instance, &mut row).unwrap();
        rows.push(row);
        if step < steps {
            let stop = if (60..80).contains(&step) { 1.0 } else { 0.0 };
            let push = if step < 35 { 0.0 } else { 0.01 * f64::from(step % 7) };
            inputs.write(&mut instance, &[stop, push]).unwrap();
            instance.do_step(f64::from(step) * STEP_S, STEP_S).unwrap();
        }
    }
    rows
}

/// What the self-test says, and its exit code.
fn selftest(hostile: &Hostile) -> (serde_json::Value, i32) {
    let dir = TempDir::new().unwrap();
    hostile.write(dir.path());
    let output = fmi_hazard(dir.path()).args(["inspect", "--self-test", FMU, "--format", "json"]).output().unwrap();
    let errors = String::from_utf8_lossy(&output.stderr);
    let result = serde_json::from_slice(&output.stdout).unwrap_or_else(|_| panic!("{hostile:?}: {errors}"));
    (result, output.status.code().unwrap())
}

/// The part of the result about the FMU's promises, in one word each.
fn verdicts(hostile: &Hostile) -> ([String; 5], i32) {
    let (result, code) = selftest(hostile);
    let parts = ["deterministic", "second_instance", "restore", "reset", "serialize"];
    (parts.map(|part| result[part]["result"].as_str().unwrap().to_owned()), code)
}

/// What an FMU is told that cannot even make its first run: exit code 3 and a message.
fn no_first_run(hostile: &Hostile) -> String {
    let dir = TempDir::new().unwrap();
    hostile.write(dir.path());
    let output = fmi_hazard(dir.path()).args(["inspect", "--self-test", FMU]).assert().code(3).get_output().clone();
    assert!(output.stdout.is_empty(), "{hostile:?}");
    let text = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(text.contains("first plain run"), "{hostile:?}: {text}");
    text.replace(['│', '\n'], " ").split_whitespace().collect::<Vec<_>>().join(" ")
}

#[test]
fn without_a_behaviour_it_keeps_every_promise() {
    for hostile in Hostile::both() {
        assert_eq!(verdicts(&hostile), (["exact"; 5].map(str::to_owned), 0));
        let (result, _) = selftest(&hostile.saves(false).serializes(false));
        assert_eq!(result["restore"]["result"], "not_offered");
    }
}

#[test]
fn it_turns_like_the_other_test_fmu_in_both_versions_and_as_calculated_by_hand() {
    let rows = ["faulty.fmu", "hostile.fmu", "hostile-fmi3.fmu"].map(|name| run(&test_fmus().join(name), 120));
    let bits = rows.each_ref().map(|r| r.iter().flatten().map(|v| v.to_bits()).collect::<Vec<u64>>());
    assert_eq!(bits[0], bits[1]);
    assert_eq!(bits[1], bits[2]);
    // One period of the clock, 35 steps: mean swell 1.1 over 0.7 s at 0.5 rad/s.
    assert!((rows[1][35][0] - 0.5 * 1.1 * 0.7).abs() < 1e-12, "{:?}", rows[1][35]);
}

#[test]
fn a_crash_in_the_first_run_is_told_with_its_signal() {
    for (row, call) in
        ["load", "instantiate", "setup", "enter-init", "exit-init", "set", "get", "terminate", "free-instance"]
            .into_iter()
            .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            let text = no_first_run(&hostile.what("segfault").at(call, 1));
            assert!(text.contains("ended its process (signal 11, SIGSEGV, invalid memory access)"), "{call}: {text}");
        }
    }
    for (row, (what, words)) in [
        ("segfault", &["SIGSEGV"][..]),
        ("abort", &["SIGABRT"]),
        ("exit0", &["exit code 0"]),
        ("exit3", &["exit code 3"]),
        // A frame that leaps over the guard page is an invalid access and no more: where the stack begins decides it.
        ("stack-overflow", &["SIGABRT", "SIGSEGV"]),
        ("fpe", &["SIGFPE"]),
    ]
    .into_iter()
    .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            let text = no_first_run(&hostile.what(what).at("step", 12));
            assert!(words.iter().any(|word| text.contains(word)), "{what}: {text}");
        }
    }
}

#[test]
fn a_crash_in_what_a_search_can_do_without_is_a_finding() {
    for hostile in Hostile::both() {
        for (call, bad) in [("restore", &[2, 4][..]), ("deserialize", &[4]), ("reset", &[3])] {
            let (found, code) = verdicts(&hostile.clone().what("segfault").at(call, 1));
            let expected: Vec<&str> = (0..5).map(|part| if bad.contains(&part) { "failed" } else { "exact" }).collect();
            assert_eq!(
                (&found[..], code),
                (&expected.iter().map(|v| (*v).to_owned()).collect::<Vec<_>>()[..], 0),
                "{call}"
            );
        }
    }
}

#[test]
fn statuses_and_values_that_end_a_run_are_told_with_their_time() {
    for (what, words) in [
        ("status-discard", "returned Discard"),
        ("status-error", "returned Error"),
        ("status-fatal", "returned Fatal"),
        ("bad-status", "returned 99, which the standard does not define"),
    ] {
        for hostile in Hostile::both() {
            let text = no_first_run(&hostile.what(what).at("step", 12));
            assert!(text.contains(words) && text.contains("at t = 0.240 s"), "{what}: {text}");
        }
    }
    assert!(no_first_run(&Hostile::v2().what("status-pending").at("step", 12)).contains("returned Pending"));
    assert!(no_first_run(&Hostile::v3().what("status-pending").at("step", 12)).contains("returned 5"));
    for (what, words) in [("nan", "`q` is NaN"), ("infinity", "`q` is infinite")] {
        for hostile in Hostile::both() {
            let text = no_first_run(&hostile.what(what).at("step", 12));
            assert!(text.contains(words) && text.contains("at t = 0.260 s"), "{what}: {text}");
            assert!(text.contains("steps of 0.02 s may be too long") && text.contains("time.step_s"), "{text}");
        }
    }
}

#[test]
fn false_promises_about_states_and_resets_are_found_out() {
    // Determinism, second instance, restore, reset, serialisation; exit code.
    for (row, (what, expected)) in [
        ("state-noop", ["exact", "exact", "differs", "exact", "differs"]),
        ("state-null", ["exact", "exact", "failed", "exact", "failed"]),
        ("state-shared", ["exact", "exact", "differs", "exact", "exact"]),
        ("state-forgets-clock", ["exact", "exact", "differs", "exact", "differs"]),
        ("state-freeze", ["exact", "exact", "differs", "exact", "exact"]),
        ("state-pointer", ["exact", "exact", "exact", "exact", "differs"]),
        ("reset-noop", ["exact", "exact", "exact", "differs", "exact"]),
        ("reset-refused", ["exact", "exact", "exact", "failed", "exact"]),
        ("shared-instances", ["exact", "differs", "exact", "exact", "exact"]),
        ("single-instance", ["exact", "failed", "exact", "exact", "exact"]),
    ]
    .into_iter()
    .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            assert_eq!(verdicts(&hostile.what(what)), (expected.map(str::to_owned), 0), "{what}");
        }
    }
}

#[test]
fn what_lives_outside_the_states_needs_fresh_processes_or_makes_findings_impossible_to_replay() {
    for (what, fresh_process, expected) in
        [("global-state", "exact", 0), ("forgets-rng", "exact", 0), ("clock-time", "differs", 3)]
    {
        for hostile in Hostile::both() {
            let (found, code) = selftest(&hostile.what(what));
            assert_eq!(found["deterministic"]["result"], "differs", "{what}");
            assert_eq!((found["fresh_process"]["result"].as_str(), code), (Some(fresh_process), expected), "{what}");
        }
    }
    for hostile in Hostile::both() {
        let (found, code) = verdicts(&hostile.what("once-per-process").once_per_process(true));
        // What needs one instance only is tried in a process of its own.
        let expected = ["failed", "failed", "exact", "exact", "failed"];
        assert_eq!((found, code), (expected.map(str::to_owned), 0));
    }
}

#[test]
fn what_only_looks_dangerous_passes() {
    if !sample::is_turn(1, 2) {
        return;
    }
    for (row, what) in
        ["status-warning", "thread", "thread-needed", "locale", "chdir", "big-state", "null-log", "log-from-thread"]
            .into_iter()
            .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            let (found, code) = verdicts(&hostile.what(what).at("step", 12));
            assert_eq!((found, code), (["exact"; 5].map(str::to_owned), 0), "{what}");
        }
    }
    let (result, _) = selftest(&Hostile::v2().what("big-state"));
    assert_eq!(result["bytes_per_state"], (10 << 20) + 10 * 8);
}

#[test]
fn memory_is_taken_until_there_is_none() {
    if !sample::is_turn(0, 2) {
        return;
    }
    // 20 MB in each of 100 steps: a limit of 1 GB on the address space ends it, not the machine.
    for hostile in sample::some(Hostile::both(), 2).map(|hostile| hostile.what("leak").size(20_000_000)) {
        let dir = TempDir::new().unwrap();
        hostile.write(dir.path());
        let command = format!(
            "ulimit -v 1000000; exec '{}' inspect --self-test {FMU} --steps 100",
            env!("CARGO_BIN_EXE_fmi-hazard")
        );
        let output = std::process::Command::new("sh").args(["-c", &command]).current_dir(dir.path()).output().unwrap();
        let text = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.code() == Some(3) && text.contains("SIGSEGV"), "{text}");
    }
}

/// qd after the third step, in this process: 1 if the deed could be done.
fn done(hostile: &Hostile) -> f64 {
    let dir = TempDir::new().unwrap();
    run(&hostile.write(dir.path()), 3)[3][1]
}

#[test]
fn it_really_does_what_it_is_told() {
    let dir = TempDir::new().unwrap();
    for hostile in Hostile::both() {
        let file = dir.path().join("a file with blanks");
        let told = |what: &str| hostile.clone().what(what).at("step", 2).path(&file);
        assert_eq!(done(&told("read-file")), 0.0, "there is none yet");
        assert_eq!(done(&told("write-file")), 1.0);
        assert_eq!(done(&told("read-file")), 1.0);
        std::fs::remove_file(&file).unwrap();
        assert_eq!(done(&told("exec")), 1.0);
        assert!(file.exists());
        std::fs::remove_file(&file).unwrap();
        assert_eq!(done(&hostile.clone().what("write-file").at("load", 1).path(&file)), 1.0);
        assert!(file.exists(), "written when it was loaded");
        std::fs::remove_file(&file).unwrap();
        let listener = std::net::TcpListener::bind("127.0.0.1:0").unwrap();
        let port = listener.local_addr().unwrap().port();
        assert_eq!(done(&hostile.clone().what("socket-connect").port(port)), 1.0);
        assert_eq!(done(&hostile.clone().what("socket-bind").port(port)), 0.0, "the port is taken");
        assert_eq!(done(&hostile.clone().what("socket-bind").port(0)), 1.0);
        drop(listener);
        assert_eq!(done(&hostile.clone().what("socket-connect").port(port)), 0.0);
        // It tells the number of its child, which is this process's child too.
        assert_eq!(done(&told("child").size(1)), 1.0);
        assert!(std::fs::read_to_string(&file).unwrap().trim().parse::<u32>().is_ok());
        std::fs::remove_file(&file).unwrap();
    }
}

#[test]
fn habits_that_a_scan_lives_with_are_told() {
    for (row, (what, habit)) in [
        ("chdir", "working_folder"),
        ("fpu", "rounding_mode"),
        ("signal-handlers", "signal_handlers"),
        ("thread", "threads"),
        ("write-cwd", "files"),
        ("print", "prints"),
        ("leak", "leaks"),
    ]
    .into_iter()
    .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            let (result, code) = selftest(&hostile.what(what).size(1000));
            let habits: Vec<&str> =
                result["habits"].as_array().unwrap().iter().map(|h| h["habit"].as_str().unwrap()).collect();
            // A thread for each instance that never ends is a leak too.
            let expected = if what == "thread" { vec![habit, "leaks"] } else { vec![habit] };
            assert_eq!((habits, code), (expected, 0), "{what}");
        }
    }
    for hostile in Hostile::both() {
        let (result, code) = selftest(&hostile.clone().what("leak").at("save", 1).size(1000));
        assert_eq!((result["habits"][0]["habit"].as_str(), code), (Some("leaks_states"), 0));
        let bytes = result["habits"][0]["bytes_per_state"].as_u64().unwrap();
        assert!((400..1500).contains(&bytes) && result["habits"].as_array().unwrap().len() == 1, "{result}");
        let (result, _) = selftest(&hostile);
        assert_eq!(result["habits"], serde_json::json!([]), "an honest one has none");
        assert_eq!(result["states_by"], "saved_states");
    }
    let dir = TempDir::new().unwrap();
    Hostile::v2().what("signal-handlers").write(dir.path());
    let output = fmi_hazard(dir.path()).args(["inspect", "--self-test", FMU]).assert().code(0).get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    assert!(
        text.contains("The FMU handles signals: ") && text.contains("--in-process they would take Ctrl-C"),
        "{text}"
    );
}
