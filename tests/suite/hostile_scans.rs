//! Scans of FMUs that crash, hang, take all memory, fail or lie: each costs the actions that meet it, everything else is
//! found as if it were honest, and the machine is as before.

use crate::common::hostile::{FMU, Hostile};
use std::sync::LazyLock;

use crate::common::scanned::{Place, Ran};
use crate::sample;

/// Of an honest FMU.
static HONEST: LazyLock<Ran> = LazyLock::new(|| honest(&[]));

fn honest(more: &[&str]) -> Ran {
    Place::new(&Hostile::v2()).known(more)
}

/// Three random sequences, one of which meets what is done in the eighth step in a row with `stop` on, and another a hazard: for what
/// takes long each time it is met.
const FEW: [&str; 4] = ["--seed", "5", "--iterations", "3"];

/// The same; where all cases are looked at, as many as the cell says.
fn few() -> &'static [&'static str] {
    if sample::is_whole() { &[] } else { &FEW }
}

fn scan(hostile: &Hostile, more: &[&str]) -> Ran {
    Place::new(hostile).scan(more)
}

/// All is as with the honest FMU.
fn as_honest(ran: &Ran, what: &str) {
    assert_eq!((ran.code, ran.findings()), (Some(1), HONEST.findings()), "{what}: {ran:?}");
    assert!(ran.confirmed() && ran.hazards().len() > 3);
}

/// What is told about an action that meets a behaviour from the eighth step in a row with `stop` on, and how many
/// workers that costs at least: the message begins with the first text and ends with the second.
fn meets(hostile: &Hostile, words: &str, end: &str, more: &[&str], workers: u64) {
    // After an action that failed, other random sequences are drawn: more of them are what the honest FMU is asked for.
    static HONEST: LazyLock<Ran> = LazyLock::new(|| honest(&["--strategy", "random", "--iterations", "600"]));
    let ran = scan(hostile, &[&["--strategy", "random"], more].concat());
    // What was found besides is found, confirmed, and reported.
    assert_eq!(ran.code, Some(1), "{hostile:?}: {ran:?}");
    assert!(!ran.hazards().is_empty() && ran.confirmed(), "{hostile:?}");
    assert!(ran.scan["verdict"] == "hazards_found" && ran.rung() == "saved_states");
    assert!(ran.stderr.contains("Report out/report.html"), "{}", ran.stderr);
    // No sequence with the behaviour was evaluated; the others came out as they do with the honest FMU.
    assert!(ran.hazards().iter().all(|id| HONEST.hazards().contains(id)), "{:?} {:?}", ran.hazards(), HONEST.hazards());
    assert!(ran.scan["coverage"]["episodes_not_evaluated"].as_u64().unwrap() > 0 && HONEST.faults().is_empty());
    assert!(!ran.faults().is_empty());
    for (message, actions) in ran.faults() {
        // Rust's handler ends a process whose stack is full, unless its own is full, too: then the signal does.
        let full = format!("{hostile:?}").contains("stack-overflow");
        let own = if full { "11, SIGSEGV, invalid memory access" } else { "6, SIGABRT, abort" };
        let message = message.replace(own, "6, SIGABRT, abort");
        assert!(message.starts_with(words) && message.ends_with(end), "{hostile:?}: {message}");
        // The number of the step or the time tells the same action as the sequence does.
        let rest = message.strip_prefix(words).unwrap();
        let number: f64 = rest.split(' ').next().unwrap().parse().unwrap();
        let steps = if words.ends_with("t = ") { number * 50.0 } else { number };
        let before = 10.0 * (actions as f64 - 1.0);
        assert!((before..=before + 10.0).contains(&steps), "{message} after {actions} actions");
        let table = String::from_utf8_lossy(&ran.stdout);
        assert!(table.contains("Not evaluated"), "{table}");
    }
    assert!(ran.replaced() >= workers && (workers > 0 || ran.replaced() == 0), "{:?}", ran.run);
}

#[test]
fn crashes() {
    if !sample::is_turn(0, 2) {
        return;
    }
    for (row, (what, how)) in [
        ("segfault", "signal 11, SIGSEGV, invalid memory access"),
        ("abort", "signal 6, SIGABRT, abort"),
        ("exit0", "exit code 0"),
        ("exit3", "exit code 3"),
        ("stack-overflow", "signal 6, SIGABRT, abort"),
        ("fpe", "signal 8, SIGFPE, arithmetic error"),
    ]
    .into_iter()
    .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            let words = format!("the FMU ended its process ({how}) in a step, number ");
            meets(&hostile.what(what).when_stopped(8), &words, " of its run", few(), 3);
        }
    }
}

#[test]
fn calls_that_never_return() {
    if !sample::is_turn(1, 2) {
        return;
    }
    // Busy in one version, blocked in the other: each is waited for some times.
    let (waits, time) = if sample::is_whole() { ("1", "1") } else { ("200ms", "0.2") };
    for (hostile, what) in Hostile::both().into_iter().zip(["hang", "sleep-forever"]) {
        let words = format!("the FMU gave no answer for {time} s in a step, number ");
        meets(
            &hostile.what(what).when_stopped(8),
            &words,
            " of its run",
            &[few(), &["--fmu-timeout", waits]].concat(),
            2,
        );
    }
}

/// Whoever waits for the first word of an FMU is soon told for what.
#[test]
fn who_waits_for_the_first_word_is_told_for_what() {
    if !sample::is_turn(7, 12) {
        return;
    }
    for hostile in sample::some(Hostile::both(), 2) {
        let ran = scan(&hostile.what("hang").at("load", 1), &["--fmu-timeout", "3"]);
        assert!(ran.waited);
        fails_in_its_first_run(&ran, "gave no answer for 3 s while its binary was loaded", "hang in load");
    }
}

#[test]
fn too_much_memory() {
    if !sample::is_turn(2, 6) {
        return;
    }
    for (hostile, what) in Hostile::both().into_iter().zip(["leak", "allocate-without-end"]) {
        let words = "the FMU took more than 200 MB of memory in a step, number ";
        let hostile = hostile.what(what).when_stopped(8).size(300_000_000);
        meets(&hostile, words, " of its run", &[few(), &["--fmu-memory", "200"]].concat(), 2);
    }
    // Less than is allowed in one run, more in all of them: fresh processes take over, and nothing is lost.
    for hostile in sample::some(Hostile::both(), 2) {
        let ran = scan(&hostile.what("leak").when_stopped(1).size(4_000_000), &["--fmu-memory", "500"]);
        as_honest(&ran, "leak");
    }
}

#[test]
fn statuses() {
    for (third, hostile) in sample::some([false, true].into_iter().zip(Hostile::both()), 2) {
        let call = if third { "fmi3DoStep" } else { "fmi2DoStep" };
        let when = |what: &str| hostile.clone().what(what).when_stopped(8);
        for (what, words) in [
            ("status-discard", "Discard (the call was refused)"),
            ("status-error", "Error"),
            ("status-fatal", "Fatal (it must not be called any more)"),
            (
                "status-pending",
                if third {
                    "5, which the standard does not define"
                } else {
                    "Pending (asynchronous steps are not supported)"
                },
            ),
            ("bad-status", "99, which the standard does not define"),
        ] {
            let end = match (what, third) {
                ("status-discard", true) => {
                    "; it is in the same state as before this call, nothing of the step was done"
                }
                _ => " s",
            };
            let workers = u64::from(what == "status-fatal");
            meets(&when(what), &format!("the FMU returned {words} from {call} at t = "), end, &[], workers);
        }
        as_honest(&scan(&when("status-warning"), &[]), "status-warning");
    }
}

#[test]
fn values_that_are_no_numbers() {
    for (row, (what, words)) in [("nan", "NaN (not a number)"), ("infinity", "infinite")].into_iter().enumerate() {
        for hostile in Hostile::by_turns(row) {
            let words = format!("the FMU's output `q` is {words} at t = ");
            meets(&hostile.what(what).when_stopped(8), &words, "`fmi-hazard inspect --self-test`", &[], 0);
        }
    }
}

#[test]
fn with_nothing_found_a_fault_decides_the_exit_code() {
    for hostile in Hostile::both() {
        let ran = scan(&hostile.what("abort").when_stopped(6), &["--seed", "3", "--iterations", "4"]);
        assert_eq!((ran.code, ran.scan["verdict"].as_str()), (Some(3), Some("fmu_failed")), "{ran:?}");
        assert!(ran.hazards().is_empty() && !ran.faults().is_empty());
    }
}

/// It is told with these words, and nothing else is.
fn fails_in_its_first_run(ran: &Ran, words: &str, what: &str) {
    let help = "help: no search is possible. `fmi-hazard inspect --self-test` shows what the FMU can do without a cell";
    let text = format!("Error: the FMU failed in its first run: the FMU {words} {help}");
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(3), text.as_str()), "{what}");
    assert!(ran.stdout.is_empty() && ran.scan.is_null());
}

#[test]
fn an_fmu_that_fails_in_its_first_run_cannot_be_scanned() {
    let dies = "ended its process (signal 11, SIGSEGV, invalid memory access)";
    for (row, (what, call, at, words)) in [
        ("segfault", "load", 1, format!("{dies} while its binary was loaded")),
        ("segfault", "instantiate", 1, format!("{dies} while it was instantiated")),
        ("segfault", "setup", 1, format!("{dies} during initialisation")),
        ("segfault", "enter-init", 1, format!("{dies} during initialisation")),
        ("segfault", "exit-init", 1, format!("{dies} during initialisation")),
        ("segfault", "step", 12, format!("{dies} in a step, number 13 of its run")),
        ("segfault", "free-instance", 1, format!("{dies} while an instance was freed")),
        ("segfault", "terminate", 1, format!("{dies} while an instance was freed")),
        ("hang", "step", 12, "gave no answer for 0.4 s in a step, number 13 of its run".to_owned()),
        (
            "allocate-without-end",
            "step",
            12,
            "took more than 200 MB of memory in a step, number 13 of its run".to_owned(),
        ),
    ]
    .into_iter()
    .enumerate()
    {
        // Each second of them in a run, of each version each fourth.
        let both = Hostile::both().into_iter().enumerate();
        for (_, hostile) in both.filter(|(version, _)| sample::takes(2 * version + row, 4)) {
            let limits = ["--fmu-timeout", "400ms", "--fmu-memory", "200"];
            let ran = scan(&hostile.what(what).at(call, at), &limits);
            // Before its first step it may have met the sandbox.
            let begins =
                what == "segfault" && ["load", "instantiate", "setup", "enter-init", "exit-init"].contains(&call);
            let sandbox = if begins {
                ". If it fails here only, the sandbox may be why: there an FMU may read its own files and the system's \
                 libraries and write into its working folder, but not open other files, make temporary ones elsewhere, \
                 use the network or start programs. If you trust it: --trust-fmu"
            } else {
                ""
            };
            fails_in_its_first_run(&ran, &format!("{words}{sandbox}"), &format!("{what} {call}"));
        }
    }
    for hostile in sample::some(Hostile::both(), 2) {
        let ran = scan(&hostile.what("clock-time"), &[]);
        let text =
            "Error: two fresh instances of the FMU gave different outputs for the same inputs (WRONG, differs by";
        assert!(ran.code == Some(3) && ran.stderr.starts_with(text), "{}", ran.stderr);
        assert!(ran.stderr.ends_with("findings could not be replayed. Ask its maker for a deterministic export"));
    }
}

#[test]
fn what_is_no_fault_of_a_sequence_costs_time_only() {
    if !sample::is_turn(1, 4) {
        return;
    }
    // It dies in calls that are counted in each process: in a fresh one the same action goes well.
    // Often enough that a process of the search comes so far, and none of the self-test.
    // Which calls there are does not depend on how busy this machine is.
    let often: &[&str] = &["--iterations", "90", "--state", "fmu"];
    let honest = honest(often);
    for (row, (what, call, at)) in
        [("segfault", "set", 700), ("abort", "get", 700), ("exit0", "save", 20), ("hang", "restore", 40)]
            .into_iter()
            .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            // What hangs is waited for; of the others none is taken for hanging because this machine is busy.
            let waits: &[&str] = if what == "hang" { &["--fmu-timeout", "2"] } else { &[] };
            let ran = scan(&hostile.what(what).at(call, at), &[often, waits].concat());
            assert_eq!((ran.code, ran.findings()), (Some(1), honest.findings()), "{call}: {ran:?}");
            assert!(ran.confirmed() && ran.replaced() > 0, "{call}: it did not happen, {:?}", ran.run);
        }
    }
}

#[test]
fn lies_about_states_and_instances_change_no_result() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let says = "the FMU says it can save its state, but does not do it exactly";
    let [exact, replay] = [("saved_states", "restored exactly"), ("instances", says)];
    let once = ("copies", "and runs once in a process");
    for (row, (what, (rung, why))) in [
        ("state-noop", replay),
        ("state-null", replay),
        ("state-shared", replay),
        ("state-forgets-clock", replay),
        ("state-freeze", replay),
        ("state-pointer", exact),
        ("reset-refused", exact),
        ("reset-noop", exact),
        ("shared-instances", exact),
        ("single-instance", exact),
        ("global-state", once),
        ("once-per-process", once),
    ]
    .into_iter()
    .enumerate()
    {
        for hostile in Hostile::by_turns(row) {
            let ran = scan(&hostile.what(what), &[]);
            as_honest(&ran, what);
            // Where its steps take long, copies of the process are better than fresh instances.
            assert!(ran.rung() == rung || (rung == "instances" && ran.rung() == "copies"), "{what}: {:?}", ran.run);
            assert_eq!(ran.replaced(), 0, "{what}");
            assert!(ran.stderr.contains(why), "{what}: {}", ran.stderr);
        }
    }
}

#[test]
fn models_of_another_motion_give_the_same_on_all_rungs() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let iterations = if sample::is_whole() { "30" } else { "12" };
    for (row, (what, rung)) in [("forgets-rng", "copies"), ("big-state", "saved_states")].into_iter().enumerate() {
        for hostile in Hostile::by_turns(row) {
            let hostile = hostile.what(what);
            let scan = |state| scan(&hostile, &["--state", state, "--iterations", iterations]);
            let [auto, fork, process] = ["auto", "fork", "process"].map(scan);
            assert!(auto.rung() == rung && auto.confirmed() && auto.code == Some(1), "{what}: {auto:?}");
            assert_eq!((auto.findings(), process.findings()), (fork.findings(), auto.findings()), "{what}");
        }
    }
}

#[test]
fn the_honest_one_runs_in_this_process_too() {
    for hostile in sample::some(Hostile::both(), 2) {
        let here = scan(&hostile, &["--in-process"]);
        as_honest(&here, "in this process");
        as_honest(&scan(&hostile, &[]), "in workers");
        assert!(here.stderr.starts_with("Warning the FMU runs in this process"), "{}", here.stderr);
    }
}

#[test]
fn inspecting_runs_nothing() {
    for hostile in Hostile::both() {
        let place = Place::new(&hostile.what("segfault").at("load", 1));
        let ran = place.after(place.command(&["inspect", FMU]).output().unwrap());
        assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    }
}
