//! What a simulated action costs and where it goes, on scenario 1: the bare C-ABI loop as the floor, the plant with its
//! traces, forward kinematics, contact checks with and without arms, and 320 iterations as a whole.
//!
//! `cargo bench --bench scan`; read ratios within one run, not single times.

mod common;

use std::ops::ControlFlow;
use std::sync::LazyLock;

use divan::{Bencher, black_box};
use fmi_hazard::host::Plant as _;
use fmi_hazard::human::Action;
use fmi_hazard::scan::options::Method;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::{Prepared, ScanOptions, StateChoice, StrategyName, scan};
use fmi_hazard::search::Environment as _;
use fmi_hazard::sim::robot::RobotFrame;

fn main() {
    divan::main();
}

static CELL: LazyLock<Prepared> =
    LazyLock::new(|| prepare(&common::cell("safety-fence"), None).expect("the example can be run"));

/// Steps in one action.
const STEPS: usize = 10;

/// An action by the bare C interface: set inputs, step, get outputs, ten times. The floor for everything else.
#[divan::bench]
fn a_bare_c_abi_action(bencher: Bencher) {
    let mut instance = CELL.fmus[0].load().expect("loads").instantiate("bench").expect("an instance");
    instance.set_boolean(&[], &[]).ok();
    let instance = instance.enter_initialization(0.0, None).expect("initialisation");
    let mut instance = instance.exit_initialization().expect("initialisation");
    let of = |kind| -> Vec<u32> {
        CELL.binding.outputs.iter().filter(|p| p.port.kind == kind).map(|p| p.port.handle.value_reference).collect()
    };
    let (real, integer) = (of(fmi_hazard::host::port::PortKind::Real), of(fmi_hazard::host::port::PortKind::Integer));
    let inputs: Vec<u32> = CELL.binding.inputs.iter().map(|p| p.port.handle.value_reference).collect();
    let values: Vec<bool> = CELL.binding.constants.iter().map(|v| *v != 0.0).collect();
    let (mut reals, mut integers) = (vec![0.0; real.len()], vec![0; integer.len()]);
    let mut step = 0.0;
    bencher.bench_local(|| {
        for _ in 0..STEPS {
            instance.set_boolean(&inputs, &values).expect("inputs");
            instance.do_step(step * 0.02, 0.02).expect("a step");
            instance.get_real(&real, &mut reals).expect("outputs");
            instance.get_integer(&integer, &mut integers).expect("outputs");
            step += 1.0;
        }
        black_box(&reals);
    });
}

/// The same action through the plant: trace in, trace out, outputs checked for NaN.
#[divan::bench]
fn b_plant_action(bencher: Bencher) {
    let mut plant = CELL.plant(StateChoice::Auto);
    plant.restart().expect("a start");
    let inputs = CELL.binding.constants.repeat(STEPS);
    bencher.bench_local(|| black_box(plant.advance(STEPS, &inputs).expect("an action")));
}

/// A state saved and restored.
#[divan::bench]
fn c_save_and_restore(bencher: Bencher) {
    let mut plant = CELL.plant(StateChoice::Auto);
    plant.restart().expect("a start");
    bencher.bench_local(|| {
        let state = plant.save().expect("a state");
        plant.restore(&state).expect("the state again");
    });
}

/// Forward kinematics, link speeds and force coefficients of one action's ten rows.
#[divan::bench]
fn d_robot_frames_of_an_action(bencher: Bencher) {
    let mut plant = CELL.plant(StateChoice::Auto);
    plant.restart().expect("a start");
    let trace = plant.advance(STEPS, &CELL.binding.constants.repeat(STEPS)).expect("an action");
    let width = CELL.binding.outputs.len();
    bencher.bench_local(|| {
        for row in trace.chunks(width) {
            black_box(RobotFrame::new(&CELL.cell, &CELL.binding, row));
        }
    });
}

/// One action whose outcome is remembered: what a search pays for going down a path it knows.
#[divan::bench]
fn e_remembered_action(bencher: Bencher) {
    let mut simulation = CELL.simulation(StateChoice::Auto, false).expect("a simulation");
    bencher.bench_local(|| {
        simulation.reset().expect("the start");
        black_box(simulation.take(Action::REST).expect("an action"));
    });
}

/// 320 iterations as in the paper, from opened cell to confirmed report.
#[divan::bench(args = [StrategyName::MctsDpw, StrategyName::Random], sample_count = 10)]
fn f_scan_of_320_iterations(bencher: Bencher, strategy: StrategyName) {
    let options = ScanOptions {
        method: Method::Strategy(strategy),
        seed: 1,
        iterations: 320,
        stop_at_first: false,
        posture_sweep: false,
        state: StateChoice::Auto,
    };
    bencher.bench_local(|| black_box(scan(&CELL, options, &mut |_| ControlFlow::Continue(())).expect("a scan")));
}
