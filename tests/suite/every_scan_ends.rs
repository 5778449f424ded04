//! Whatever a scan is doing, Ctrl-C ends it soon and leaves valid results; and its time ends it too. With real signals, a
//! robot made of meshes, an FMU that hardly answers, and a reader who sees no terminal.
#![allow(clippy::print_stdout, reason = "says what it left out")]

use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use crate::common::hostile::{CELL, Hostile};
use crate::common::started::Started;
use crate::common::{examples, fmi_hazard, json, scan_json, write};
use crate::sample;
use fmi_hazard::host::isolation::{Guard, Limits};
use fmi_hazard::scan::options::{Method, Progress};
use fmi_hazard::scan::prepare::prepare_in;
use fmi_hazard::scan::{Exhaustive, Hosting, ScanOptions, StateChoice, StrategyName, scan};
use fmi_hazard::search::exhaustive::Budget;
use fmi_hazard::sequences::Merge;
use fmi_hazard::stop::Stop;
use serde_json::Value;

/// A cell with the Universal Robots UR5 and its collision meshes, where the arm of the light-curtain example was; nothing
/// if they were not fetched.
fn ur5(dir: &Path) -> Option<String> {
    let python =
        std::env::var_os("FMI_HAZARD_PYTHON").map_or_else(|| Path::new(".venv/bin/python").into(), PathBuf::from);
    let fetched = python.parent().unwrap().join("../third-party/example-robot-data");
    if !fetched.is_dir() {
        println!("NOT TESTED: tools/third_party.py has not fetched the UR5");
        return None;
    }
    std::os::unix::fs::symlink(fetched.canonicalize().unwrap(), dir.join("example-robot-data")).unwrap();
    let example = std::fs::read_to_string(dir.join("light-curtain/cell.toml")).unwrap();
    let mut cell = "schema = 1\nname = \"ur5\"\nfmu = \"light-curtain/light-curtain.fmu\"\n[time]\nstep_s = 0.02\n\
         [[robot]]\nname = \"UR5\"\nurdf = \"example-robot-data/robots/ur_description/urdf/ur5_robot.urdf\"\n\
         base = { xyz_m = [0, 0.75, 0.4] }\nmoving_mass_kg = 20\npayload_kg = 3\n"
        .to_owned();
    for (number, joint) in
        ["shoulder_pan", "shoulder_lift", "elbow", "wrist_1", "wrist_2", "wrist_3"].iter().enumerate()
    {
        let number = number + 1;
        write!(
            cell,
            "[[robot.joint]]\nname = \"{joint}_joint\"\nangle = {{ variable = \"robot.q[{number}]\" }}\n\
             speed = {{ variable = \"robot.qd[{number}]\" }}\n"
        )
        .unwrap();
    }
    let rest = &example[example.find("[[obstacle]]").unwrap()..];
    let mat = "kind = \"mat\"\nzone = { polygon_m = [[-0.5, 0.3], [0.5, 0.3], [0.5, 2], [-0.5, 2]] }";
    let curtain = "kind = \"light_curtain\"\nzone = { line_m = [[-0.5, 0], [0.5, 0]], heights_m = [0, 1.8] }";
    assert!(rest.contains(curtain));
    write(dir, "ur5.toml", &(cell + &rest.replace(curtain, mat)));
    Some("ur5.toml".to_owned())
}

/// Runs a command until it has said `word` and for a while after that, and interrupts it. Its exit code, what it printed,
/// and how long it took to end.
fn interrupted(dir: &Path, arguments: &[&str], word: &str, after: Duration) -> (Option<i32>, String, Duration) {
    let program = Started::until(dir, arguments, word);
    std::thread::sleep(after);
    let began = Instant::now();
    program.signal("-INT");
    // `timeout` sends it twice: to the program, and to the group that it is in. That is no second Ctrl-C.
    program.signal("-INT");
    let (code, printed) = program.end();
    (code, printed, began.elapsed())
}

/// What a scan left is whole: each file can be read, and no hazard is there that a run from the start refuted.
fn assert_valid(out: &Path) -> Value {
    let report = scan_json(out);
    for hazard in report["hazards"].as_array().unwrap() {
        assert_ne!(hazard["confirmed"], false, "{hazard}");
    }
    let lines = std::fs::read_to_string(out.join("hazards.jsonl")).unwrap();
    let ids: Vec<Value> =
        lines.lines().map(|line| serde_json::from_str::<Value>(line).unwrap()["id"].clone()).collect();
    let listed: Vec<Value> = report["hazards"].as_array().unwrap().iter().map(|hazard| hazard["id"].clone()).collect();
    assert_eq!(ids, listed);
    assert!(std::fs::read_to_string(out.join("report.html")).unwrap().ends_with("</html>\n"));
    assert!(std::fs::read_to_string(out.join("junit.xml")).unwrap().contains("</testsuites>"));
    let files = std::fs::read_dir(out).unwrap().map(|entry| entry.unwrap().file_name().into_string().unwrap());
    assert!(files.into_iter().all(|name| !name.contains(".part")));
    report
}

/// Ten moments, more of them early: from 10 ms to some seconds.
fn moments(seed: u64) -> impl Iterator<Item = Duration> {
    let mut state = seed;
    (0..10).map(move |_| {
        state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        Duration::from_secs_f64(
            0.01 * libm::pow(250.0, f64::from(u32::try_from(state >> 33).unwrap()) / f64::from(1_u32 << 31)),
        )
    })
}

#[test]
fn ctrl_c_is_heard_at_any_moment() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let mut scans: Vec<(String, &[&str])> = vec![
        ("safety-fence/cell.toml".to_owned(), &["--strategy", "exhaustive"]),
        ("light-curtain/cell.toml".to_owned(), &["--strategy", "exhaustive"]),
        ("two-scanners/cell.toml".to_owned(), &[]),
    ];
    scans.extend(ur5(dir).map(|cell| (cell, &["--strategy", "hybrid"][..])));
    let mut times = Vec::new();
    for (number, (cell, more)) in scans.iter().enumerate() {
        // In other scans of the same run other ones.
        let some = moments(number as u64 + 1).enumerate().filter(|(moment, _)| sample::takes(moment + 3 * number, 10));
        for (moment, after) in some {
            let out = format!("o{number}-{moment}");
            let arguments = [&["scan", "--from", "start", "--no-advice", cell, "--out", &out], *more].concat();
            let (code, printed, took) = interrupted(dir, &arguments, "States", after);
            times.push(took);
            assert_eq!(code, Some(130), "{cell} after {after:?}: {printed}");
            assert!(printed.contains("Stopping: what was found is kept"), "{printed}");
            let report = assert_valid(&dir.join(&out));
            assert!(report["certificate"].is_null() || report["certificate"]["complete"] == false);
        }
    }
    fmi_hazard(dir)
        .args([
            "scan",
            "--no-advice",
            "safety-fence/cell.toml",
            "--strategy",
            "hybrid",
            "--iterations",
            "10",
            "--out",
            "e",
        ])
        .assert()
        .code(1);
    let id = scan_json(&dir.join("e"))["hazards"][0]["id"].as_str().unwrap().to_owned();
    for after in sample::some(moments(9), 10) {
        let (code, printed, took) =
            interrupted(dir, &["explain", "e", &id, "--from", "start"], "Trying changes", after);
        times.push(took);
        // What is known at once is there in any case.
        assert!(code == Some(130) && printed.contains(&id) && printed.contains("Stopped"), "{code:?} {printed}");
    }
    times.sort();
    let (middle, longest) = (times[times.len() / 2], times[times.len() - 1]);
    println!("{} signals: half within {middle:?}, all within {longest:?}", times.len());
    // A busy machine may be late now and then.
    let late = if sample::is_whole() { times[times.len() * 9 / 10] } else { longest / 2 };
    assert!(middle < Duration::from_secs(2) && late < Duration::from_secs(5), "{times:?}");
}

/// Whoever uses the library and does not listen: a search that had to end is not complete, whenever that was.
#[test]
fn what_had_to_end_is_never_complete() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    let cell = std::fs::read_to_string(dir.path().join("safety-fence/cell.toml")).unwrap();
    let from = cell.find("start = { xy_m = ").unwrap();
    let start = &cell[from..from + cell[from..].find('\n').unwrap()];
    // On the way to its hazards.
    let begun = "start = { xy_m = [0.824, -0.834], heading_deg = 135 }\nbegins_s = [0.8]";
    let cell = cell.replace(start, begun) + "\n[search]\nactions = 3\n";
    let path = write(&dir.path().join("safety-fence"), "short.toml", &cell);
    let workers = |stop: &Stop| {
        let limits = Limits { stop: stop.clone(), ..Limits::default() };
        Hosting::Workers { program: env!("CARGO_BIN_EXE_fmi-hazard").into(), guard: Guard::Sandboxed, limits }
    };
    let scanned_in = |hosting: &dyn Fn(&Stop) -> Hosting, asks: &dyn Fn(u32, bool) -> bool| {
        let stop = Stop::default();
        let prepared = prepare_in(&path, None, &hosting(&stop)).unwrap();
        let budget = Budget { states: usize::MAX, bytes: usize::MAX, work: u64::MAX, drop: true };
        let how = Exhaustive { budget, merge: Merge::default(), workers: 2 };
        let method = Method::Auto(StrategyName::Hybrid, how);
        let options = ScanOptions {
            method,
            seed: 1,
            iterations: 6,
            stop_at_first: false,
            posture_sweep: true,
            state: StateChoice::Auto,
        };
        let mut seen = 0;
        let report = scan(&prepared, options, &mut |progress| {
            seen += 1;
            let confirming = matches!(progress, Progress::Confirming { .. });
            if asks(seen, confirming) && !stop.is_asked() {
                stop.ask();
                // Until the time for what follows is over, too.
                std::thread::sleep(Duration::from_secs(u64::from(confirming)));
            }
            ControlFlow::Continue(())
        });
        (report.unwrap().report, seen)
    };
    let scanned = |asks: &dyn Fn(u32, bool) -> bool| scanned_in(&workers, asks);
    let (whole, events) = scanned(&|_, _| false);
    assert!(whole.certificate.is_some_and(|c| c.complete) && whole.hazards.len() > 1);
    let mut cut = 0;
    for event in sample::some((1..events).step_by((events / 16).max(1) as usize), 3) {
        let (report, _) = scanned(&|seen, _| seen == event);
        let complete = report.certificate.is_some_and(|certificate| certificate.complete);
        let confirmed = report.hazards.iter().filter(|hazard| hazard.confirmed == Some(true)).count();
        assert!(!complete || confirmed == whole.hazards.len(), "stopped at event {event} of {events}");
        assert!(report.hazards.iter().all(|hazard| hazard.confirmed != Some(false)));
        cut += u32::from(!complete);
    }
    assert!(cut > if sample::is_whole() { 8 } else { 1 }, "{cut} of {events}");
    // An FMU in this process hears it, too.
    let (report, _) = scanned_in(&|stop| Hosting::InProcess(stop.clone()), &|seen, _| seen == events / 2);
    assert!(report.certificate.is_none_or(|certificate| !certificate.complete));
    let (report, _) = scanned(&|_, confirming| confirming);
    let certificate = report.certificate.unwrap();
    assert!(report.hazards.iter().any(|hazard| hazard.confirmed.is_none()));
    assert!(!certificate.complete && certificate.reasons[0].contains("not confirmed any more"), "{certificate:?}");
}

#[test]
fn its_time_ends_a_scan_and_the_report_says_what_was_not_looked_at() {
    let dir = examples();
    let dir = dir.path();
    let cell = ur5(dir).unwrap_or_else(|| "light-curtain/cell.toml".to_owned());
    let output = fmi_hazard(dir)
        .args(["scan", "--from", "start", "--no-advice", &cell, "--time", "6s", "--out", "o"])
        .output()
        .unwrap();
    let report = assert_valid(&dir.join("o"));
    let hazards = !report["hazards"].as_array().unwrap().is_empty();
    assert_eq!(output.status.code(), Some(if hazards { 1 } else { 4 }), "{}", String::from_utf8_lossy(&output.stderr));
    let told = report["warnings"].to_string();
    assert!(told.contains("its time ended the search"), "{told}");
    // A busy machine may not come to its complete part.
    if report["certificate"].is_object() {
        let reasons = report["certificate"]["reasons"].to_string();
        assert!(reasons.contains("longer ones in part"), "{reasons}");
    }
    assert!(std::fs::read_to_string(dir.join("o/report.html")).unwrap().contains("its time ended the search"));
    assert!(json(&dir.join("o/run.json")).is_object());
    // Without any limit of its own a wrong one is told.
    let wrong = fmi_hazard(dir).args(["scan", "--no-advice", &cell, "--time", "soon"]).output().unwrap();
    assert!(wrong.status.code() == Some(2) && String::from_utf8_lossy(&wrong.stderr).contains("90s, 5m or 2h"));
}

/// Each step takes 0.2 s: before anything is searched it is run for a minute.
#[test]
fn the_time_is_also_that_in_which_an_fmu_is_tried_out() {
    for hostile in Hostile::both() {
        let dir = tempfile::TempDir::new().unwrap();
        hostile.what("slow").size(200).write(dir.path());
        let output = fmi_hazard(dir.path())
            .args(["scan", CELL, "--from", "start", "--time", "2s", "--out", "o"])
            .output()
            .unwrap();
        let told = String::from_utf8_lossy(&output.stderr).replace("\n  │ ", " ");
        assert_eq!(output.status.code(), Some(4), "{told}");
        assert!(told.contains("the time was over while the FMU was tried out") && told.contains("--time"), "{told}");
        assert!(!dir.path().join("o/scan.json").exists());
    }
}

#[test]
fn going_on_never_leaves_less_than_there_was() {
    let dir = examples();
    let dir = dir.path();
    let scan = ["scan", "--no-advice", "safety-fence/cell.toml", "--strategy", "hybrid", "--out", "o"];
    let (code, ..) = interrupted(dir, &scan, "32/320 iterations", Duration::from_millis(10));
    assert_eq!(code, Some(130));
    let before = ["scan.json", "hazards.jsonl"].map(|file| std::fs::read(dir.join("o").join(file)).unwrap());
    let (code, printed, _) = interrupted(dir, &["scan", "--resume", "o"], "States", Duration::from_millis(10));
    assert_eq!(code, Some(130));
    assert!(printed.contains("the results in") && printed.contains("are still those"), "{printed}");
    let after = ["scan.json", "hazards.jsonl"].map(|file| std::fs::read(dir.join("o").join(file)).unwrap());
    assert!(before == after);
}
