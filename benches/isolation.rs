//! What hosting an FMU in a worker process costs: an action and whole scans against the same in this process, and the ways
//! of coming back to a state over the length of the way there.
//!
//! `cargo bench --bench isolation`, and `cargo bench --bench isolation -- scans` for whole scans; read ratios within one
//! run, not single times.

#![expect(clippy::print_stdout, reason = "prints its table")]

mod common;

use std::ops::ControlFlow;
use std::path::PathBuf;
use std::sync::LazyLock;
use std::time::{Duration, Instant};

use divan::{Bencher, black_box};
use fmi_hazard::host::Plant as _;
use fmi_hazard::host::isolation::{Guard, Limits};
use fmi_hazard::scan::options::Method;
use fmi_hazard::scan::prepare::prepare_in;
use fmi_hazard::scan::{Hosting, Prepared, ScanOptions, StateChoice, StrategyName, scan};
use fmi_hazard::stop::Stop;

fn main() {
    // Divan takes all samples of one thing before those of the next; for a difference of a few percent that is too far
    // apart.
    if std::env::args().any(|argument| argument == "scans") {
        return scans();
    }
    divan::main();
}

fn here(scenario: &str) -> Prepared {
    prepare_in(&common::cell(scenario), None, &Hosting::InProcess(Stop::default())).expect("the example can be run")
}

fn apart(scenario: &str) -> Prepared {
    let program = PathBuf::from(env!("CARGO_BIN_EXE_fmi-hazard"));
    let hosting = Hosting::Workers { program, guard: Guard::Sandboxed, limits: Limits::default() };
    prepare_in(&common::cell(scenario), None, &hosting).expect("the example can be run")
}

static HERE: LazyLock<Prepared> = LazyLock::new(|| here("safety-fence"));
static APART: LazyLock<Prepared> = LazyLock::new(|| apart("safety-fence"));

/// The example cells, each with as many random sequences as take a second or two: contacts cost more in some.
const SCANS: [(&str, u32); 6] = [
    ("safety-fence", 12),
    ("sensor-mat", 600),
    ("head-collision", 1000),
    ("light-curtain", 20),
    ("two-scanners", 1000),
    ("heavy-workpiece", 800),
];

/// Samples of each scan.
const SAMPLES: usize = 9;

/// Steps in one action.
const STEPS: usize = 10;

/// The FMU's part of an action alone: the message is most of it.
#[divan::bench(args = ["here", "apart"])]
fn a_fmu_action(bencher: Bencher, place: &str) {
    let cell = if place == "here" { &HERE } else { &APART };
    let mut plant = cell.plant(StateChoice::Auto);
    plant.restart().expect("a start");
    let inputs = cell.binding.constants.repeat(STEPS);
    bencher.bench_local(|| black_box(plant.advance(STEPS, &inputs).expect("an action")));
}

/// A scan of an example cell, from its start to its confirmed report, here or with the FMU in a worker process. Samples
/// of the two are taken by turns, so that what else the machine does concerns both; their ratios are printed.
fn scans() {
    println!("a scan with the FMU in a worker process / in this process: ratio of medians and of shortest times");
    for (scenario, iterations) in SCANS {
        let cells = [here(scenario), apart(scenario)];
        let mut times = [const { Vec::new() }; 2];
        for _ in 0..SAMPLES {
            for (cell, times) in cells.iter().zip(&mut times) {
                times.push(a_scan(cell, iterations));
            }
        }
        times.iter_mut().for_each(|times| times.sort());
        let [here, apart] = times;
        let ratio = |at: usize| apart[at].as_secs_f64() / here[at].as_secs_f64();
        let (median, shortest) = (ratio(SAMPLES / 2), ratio(0));
        println!("{scenario:16} {median:.3} {shortest:.3}  ({:.2?} here)", here[SAMPLES / 2]);
    }
}

fn a_scan(cell: &Prepared, iterations: u32) -> Duration {
    let options = ScanOptions {
        method: Method::Strategy(StrategyName::Random),
        seed: 1,
        iterations,
        stop_at_first: false,
        posture_sweep: true,
        state: StateChoice::Auto,
    };
    let began = Instant::now();
    black_box(scan(cell, options, &mut |_| ControlFlow::Continue(())).expect("a scan"));
    began.elapsed()
}

/// Coming back to a state that the FMU saved, whatever led there.
#[divan::bench]
fn c_back_by_saved_state(bencher: Bencher) {
    back_by_state(bencher, StateChoice::Fmu);
}

/// Coming back to a copy of the process, whatever led there.
#[divan::bench(sample_count = 50)]
fn d_back_by_copy(bencher: Bencher) {
    back_by_state(bencher, StateChoice::Fork);
}

/// Making a copy of the process.
#[divan::bench(sample_count = 50)]
fn e_making_a_copy(bencher: Bencher) {
    let mut plant = APART.plant(StateChoice::Fork);
    plant.restart().expect("a start");
    bencher.bench_local(|| drop(plant.save().expect("a copy")));
}

/// The same by a fresh instance and so many actions again.
#[divan::bench(args = [0, 1, 2, 4, 8, 16], sample_count = 50)]
fn f_back_by_replay(bencher: Bencher, actions: usize) {
    back_by_replay(bencher, StateChoice::Replay, actions);
}

/// The same in a fresh process.
#[divan::bench(args = [0, 4, 8, 16], sample_count = 20)]
fn g_back_by_process(bencher: Bencher, actions: usize) {
    back_by_replay(bencher, StateChoice::Process, actions);
}

/// To a state and an action on.
fn back_by_state(bencher: Bencher, choice: StateChoice) {
    let mut plant = APART.plant(choice);
    plant.restart().expect("a start");
    let inputs = APART.binding.constants.repeat(STEPS);
    let state = plant.save().expect("a state");
    bencher.bench_local(|| {
        plant.restore(&state).expect("the state again");
        black_box(plant.advance(STEPS, &inputs).expect("an action"))
    });
}

/// To the state after so many actions and an action on.
fn back_by_replay(bencher: Bencher, choice: StateChoice, actions: usize) {
    let mut plant = APART.plant(choice);
    let inputs = APART.binding.constants.repeat(STEPS);
    bencher.bench_local(|| {
        plant.restart().expect("a start");
        for _ in 0..=actions {
            black_box(plant.advance(STEPS, &inputs).expect("an action"));
        }
    });
}
