//! The self-test in workers, each stage in one of its own: one that ends the process is a finding, and damage that it does
//! to the memory is none of another stage's.

use std::time::{Duration, Instant};

use super::isolated::{Isolated, WorkerRestore};
use super::launch::Launcher;
use super::message::{WorkerReply, WorkerRequest};
use crate::host::plant::{Plant as _, PlantError, insist};
use crate::host::selftest::{self, Agreement, Columns, Facts, Found, SelfTest, Stage, agreement, moving, restore_test};

/// What the self-test of FMUs in a worker gave.
pub struct Examination {
    /// The findings.
    pub result: SelfTest,
    /// For workers that run these FMUs as the self-test did.
    pub launcher: Launcher,
    /// What of the sandbox this machine lacks.
    pub missing: Vec<String>,
    /// What a communication step took, about.
    pub step_time: Duration,
}

/// Runs in fresh processes, and copies of processes as states. Returns what a step took.
fn try_processes(launcher: &Launcher, steps: usize, result: &mut SelfTest) -> Duration {
    let setup = launcher.setup();
    let (width, columns) = (setup.inputs.len(), Columns::of(setup));
    let (main, other) = (moving(setup, steps, 0), moving(setup, steps, 1));
    let mut step_time = Duration::ZERO;
    let mut run = || -> Result<Vec<f64>, PlantError> {
        let mut plant = Isolated::new(launcher.clone(), WorkerRestore::Processes);
        let mut run = plant.restart()?;
        let began = Instant::now();
        run.extend(plant.advance(steps, &main)?);
        step_time = began.elapsed() / u32::try_from(steps.max(1)).unwrap_or(u32::MAX);
        Ok(run)
    };
    let mut run = || insist(&mut run);
    let reference: Vec<f64> = match run() {
        Ok(reference) => reference,
        Err(error) => {
            result.fresh_process = Agreement::from(error);
            return step_time;
        }
    };
    result.fresh_process = agreement(&reference, run(), &columns);
    let mut plant = Isolated::new(launcher.clone(), WorkerRestore::ByFork);
    let tried = plant.restart().and_then(|_| plant.advance(1, &main[..width]));
    result.fork = match (tried, plant.reason_against_copies()) {
        (Err(error), _) => Agreement::from(error),
        (Ok(_), Some(reason)) => Agreement::from(PlantError::of(reason)),
        (Ok(_), None) => restore_test(plant, &reference, (&main, &other), steps, width, &columns),
    };
    step_time
}

/// What the system says when it denies something, and programs that pass that on.
const DENIED: [&str; 6] =
    ["permission denied", "operation not permitted", "access denied", "eacces", "eperm", "cannot open shared object"];

/// The failure of a first run in the sandbox, which may be the reason: an FMU that did not expect to be denied a file or a
/// connection says so, or ends before its first step, when files are opened.
fn maybe_denied(error: PlantError) -> PlantError {
    if error.stopped {
        return error;
    }
    let said = format!("{}\n{}", error.message, error.printed.join("\n")).to_lowercase();
    // A refusal without a reason, or an end before the first step.
    let silent = error.printed.is_empty() && !error.message.contains('\n') && !error.message.contains("instantiated: ");
    let begins = error.not_started && silent || error.lost && !error.ended_by_us && error.time_s == Some(0.0);
    let hint = match () {
        () if DENIED.iter().any(|word| said.contains(word)) => "It was denied something, maybe by the sandbox",
        () if begins => "If it fails here only, the sandbox may be why",
        () => return error,
    };
    let message = format!(
        "{}. {hint}: there an FMU may read its own files and the system's libraries and write into its working folder, but not \
         open other files, make temporary ones elsewhere, use the network or start programs. If you trust it: --trust-fmu",
        error.message
    );
    PlantError { message, ..error }
}

/// A stage in a process of its own: what it answers. When that process is gone this is done again, as often as whatever ended
/// it may have been something else.
fn in_a_process(launcher: &Launcher, steps: usize, stage: Stage, reference: &[f64]) -> Tried {
    insist(&mut || {
        let mut worker = launcher.start(false)?;
        let question = WorkerRequest::SelfTest { steps, stage, reference: reference.to_vec() };
        let answer = match worker.ask(&question, &launcher.limits)? {
            WorkerReply::Failed(error) => WorkerReply::Failed(worker.with_last_words(error)),
            answer => answer,
        };
        Ok((answer, std::mem::take(&mut worker.missing)))
    })
}

/// An answer, and what of the sandbox is missing.
type Tried = Result<(WorkerReply, Vec<String>), PlantError>;

/// The self-test may take about so long, and has the FMU run about so often.
const AFFORDED: Duration = Duration::from_secs(30);
const RUNS: u32 = 33;

/// Steps of each run where they take long: the most that can be afforded, and these at least.
const FEW_STEPS: [usize; 2] = [20, 4];

/// A step that takes no longer than this is never too long, however busy the machine may be.
const QUICK: Duration = Duration::from_millis(10);

/// How often, and for how long, it is looked again whether a step takes so long.
const AGAIN: u32 = 12;
const AGAIN_WITHIN: Duration = Duration::from_secs(3);

/// As many of these steps as the self-test can have where they take long. Few values, so that it is the same ones again.
#[must_use]
pub fn affordable(launcher: &Launcher, steps: usize) -> usize {
    let time = |steps: usize| {
        let began = Instant::now();
        let ran = in_a_process(launcher, steps, Stage::FirstRun, &[]);
        matches!(ran, Ok((WorkerReply::FirstRun { .. }, _))).then(|| began.elapsed())
    };
    let few = FEW_STEPS[1].min(steps);
    // Whoever cannot do this may do the real run, whose inputs change later.
    let (Some(mut start), Some(mut run)) = (time(1), time(1 + few)) else { return steps };
    // What takes long because this machine is busy takes less another time; of what takes long by itself a few tries are enough.
    let began = Instant::now();
    for _ in 0..AGAIN {
        if run.saturating_sub(start) > QUICK * u32::try_from(few).unwrap_or(1) && began.elapsed() < AGAIN_WITHIN {
            (start, run) = (start.min(time(1).unwrap_or(start)), run.min(time(1 + few).unwrap_or(run)));
        }
    }
    let step = run.saturating_sub(start) / u32::try_from(few.max(1)).unwrap_or(1);
    let fits = |steps: usize| (start + step * u32::try_from(steps).unwrap_or(u32::MAX)) * RUNS <= AFFORDED;
    if step <= QUICK || fits(steps) {
        steps
    } else {
        FEW_STEPS.into_iter().find(|few| fits(*few)).unwrap_or(FEW_STEPS[1]).min(steps)
    }
}

/// Most numbers of a first run that are kept; of a longer one each process makes its own.
pub(super) const KEPT: usize = super::channel::AREA / 32;

/// What a worker told as JSON.
fn read<T: serde::de::DeserializeOwned>(told: &str) -> Result<T, PlantError> {
    serde_json::from_str(told).map_err(|e| PlantError::of(format!("the self-test's result cannot be read: {e}")))
}

/// Runs the self-test for `steps` communication steps, without the parts in `skip`.
///
/// # Errors
/// When the FMUs cannot be loaded or a first plain run is not possible at all.
pub fn examine(launcher: &Launcher, steps: usize, skip: &[Stage]) -> Result<Examination, PlantError> {
    let unexpected = |answer: WorkerReply| PlantError::of(format!("a worker gave an unexpected answer: {answer:?}"));
    let columns = launcher.setup().columns();
    let long = (steps + 1) * columns > KEPT;
    let (mut reference, facts, missing) = match in_a_process(launcher, steps, Stage::FirstRun, &[]) {
        Ok((WorkerReply::FirstRun { rows, facts }, missing)) => (rows, read::<Facts>(&facts)?, missing),
        Err(error) | Ok((WorkerReply::Failed(error), _)) if launcher.is_sandboxed() => return Err(maybe_denied(error)),
        Err(error) | Ok((WorkerReply::Failed(error), _)) => return Err(error),
        Ok((answer, _)) => return Err(unexpected(answer)),
    };
    let launcher = launcher.clone().with_event_mode(facts.event_mode.clone());
    let mut result = selftest::begun(launcher.setup(), steps, &reference, &facts);
    if long {
        reference.clear();
    }
    let tried = |stage: Stage| match in_a_process(&launcher, steps, stage, &reference) {
        Ok((WorkerReply::Tested(found), _)) => read(&found),
        Ok((WorkerReply::Failed(error), _)) => Ok(Found::failed(stage, error)),
        Ok((answer, _)) => Err(unexpected(answer)),
        Err(error) if error.lost => Ok(Found::failed(stage, error)),
        Err(error) => Err(error),
    };
    for stage in Stage::LATER {
        if selftest::wants(&result, stage, skip) {
            selftest::note(&mut result, stage, tried(stage)?);
        }
    }
    let step_time = try_processes(&launcher, steps, &mut result);
    for stage in Stage::MOTION {
        if selftest::wants_motion(&mut result, stage, skip, !long) {
            selftest::note(&mut result, stage, tried(stage)?);
        }
    }
    Ok(Examination { result, launcher, missing, step_time })
}
