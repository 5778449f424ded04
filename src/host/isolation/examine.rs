//! The self-test in a worker: a part of it that ends the process is a finding, and the other parts are run without it.

use std::time::{Duration, Instant};

use super::isolated::{Isolated, Keeping};
use super::launch::Launcher;
use super::message::{Answer, Question};
use crate::host::plant::{Plant as _, PlantError, insist};
use crate::host::selftest::{Agreement, SelfTest, Stage, agreement, input_row, restore_test};

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
    let (width, rows) = (setup.inputs.len(), setup.outputs.len());
    let inputs = |seed: usize| (0..steps).flat_map(|i| input_row(setup, i, steps, seed)).collect::<Vec<f64>>();
    let (main, other) = (inputs(0), inputs(1));
    let mut step_time = Duration::ZERO;
    let mut run = || -> Result<Vec<f64>, PlantError> {
        let mut plant = Isolated::new(launcher.clone(), Keeping::Processes);
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
            result.fresh_process = Agreement::Failed { reason: error.message };
            return step_time;
        }
    };
    result.fresh_process = agreement(&reference, run());
    let mut plant = Isolated::new(launcher.clone(), Keeping::ByFork);
    let tried = plant.restart().and_then(|_| plant.advance(1, &main[..width]));
    result.fork = match (tried, plant.reason_against_copies()) {
        (Err(error), _) => Agreement::Failed { reason: error.message },
        (Ok(_), Some(reason)) => Agreement::Failed { reason },
        (Ok(_), None) => restore_test(plant, &reference, &main, &other, steps, width, rows),
    };
    step_time
}

/// Runs the self-test for `steps` communication steps, without the parts in `skip`.
///
/// # Errors
/// When the FMUs cannot be loaded or a first plain run is not possible at all.
pub fn examine(launcher: &Launcher, steps: usize, skip: &[Stage]) -> Result<Examination, PlantError> {
    let mut crashed: Vec<(Stage, String)> = Vec::new();
    let mut deaths: Vec<Stage> = Vec::new();
    let again = |deaths: &mut Vec<Stage>, stage: Stage, error: &PlantError| {
        deaths.push(stage);
        let so_far = deaths.iter().filter(|known| **known == stage).count();
        error.lost && u32::try_from(so_far).unwrap_or(u32::MAX) < error.tries()
    };
    loop {
        let mut worker = match launcher.start(false) {
            Ok(worker) => worker,
            Err(error) if again(&mut deaths, Stage::FirstRun, &error) => continue,
            Err(error) => return Err(error),
        };
        let left_out: Vec<Stage> = skip.iter().copied().chain(crashed.iter().map(|(stage, _)| *stage)).collect();
        let error = match worker.ask(&Question::SelfTest { steps, skip: left_out }, &launcher.limits) {
            Ok(Answer::Tested { result, event_mode }) => {
                let mut result: SelfTest = serde_json::from_str(&result)
                    .map_err(|e| PlantError::of(format!("the self-test's result cannot be read: {e}")))?;
                for (stage, reason) in crashed {
                    result.failed(stage, reason);
                }
                let launcher = launcher.clone().with_event_mode(event_mode);
                let missing = std::mem::take(&mut worker.missing);
                drop(worker);
                let step_time = try_processes(&launcher, steps, &mut result);
                return Ok(Examination { result, launcher, missing, step_time });
            }
            Ok(Answer::Failed(error)) => return Err(error),
            Ok(other) => return Err(PlantError::of(format!("a worker gave an unexpected answer: {other:?}"))),
            Err(error) => error,
        };
        let stage = Stage::numbered(worker.stage()).unwrap_or(Stage::FirstRun);
        if again(&mut deaths, stage, &error) {
            continue;
        }
        if stage == Stage::FirstRun || crashed.iter().any(|(known, _)| *known == stage) {
            return Err(error);
        }
        crashed.push((stage, error.message));
    }
}

impl SelfTest {
    /// Notes that the FMU ended the process in a part.
    fn failed(&mut self, stage: Stage, reason: String) {
        let failed = Agreement::Failed { reason };
        match stage {
            Stage::FirstRun | Stage::Deterministic => self.deterministic = failed,
            Stage::SecondInstance => self.second_instance = failed,
            Stage::Restore => self.restore = failed,
            Stage::StateSize | Stage::Serialize => self.serialize = failed,
            Stage::Reset => self.reset = failed,
        }
    }
}
