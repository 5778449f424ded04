//! `fmi-hazard selftest`: what an FMU's promises about its state are worth, for any FMU.
//!
//! The FMU runs in a process of its own: when it crashes or hangs in one stage, that is a finding, and the other stages
//! are run again without it.

use std::fmt::Write as _;
use std::io::Write as _;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::{Duration, Instant};

use clap::ValueEnum as _;

use super::exit::{FMU_FAILED, Failure, NO_HAZARD, UNUSABLE};
use super::output;
use crate::fmi::{Causality, Fmu, ModelDescription, Variability, Variable};
use crate::host::port::Port;
use crate::host::selftest::{Agreement, SelfTest, Stage, selftest};
use crate::host::{SystemSetup, UnitPort};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The FMU
    fmu: PathBuf,
    /// Communication step, s (default: the FMU's own, else 0.02)
    #[arg(long, value_parser = positive)]
    step: Option<f64>,
    /// Number of steps in a run
    #[arg(long, default_value_t = 80, value_parser = clap::value_parser!(u32).range(8..100_000))]
    steps: u32,
    /// Print JSON
    #[arg(long)]
    json: bool,
    /// Leave stages out (used by the process that watches over this one)
    #[arg(long, value_enum, hide = true)]
    skip: Vec<Stage>,
    /// Write stages and outcome to this file (used by the process that watches over this one)
    #[arg(long, hide = true)]
    child_result: Option<PathBuf>,
}

fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(v) if v.is_finite() && v > 0.0 => Ok(v),
        _ => Err("a number greater than zero is needed".to_owned()),
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    if let Some(result) = &arguments.child_result {
        return child(arguments, result);
    }
    // The file is read here first, so that what is wrong with it is said once and plainly.
    let name = Fmu::open(&arguments.fmu)?.description().model_name.clone();
    let mut crashed: Vec<(Stage, String)> = Vec::new();
    let mut result = loop {
        match in_child(arguments, &crashed)? {
            Ended::Result(result) => break *result,
            Ended::Code(code) => return Ok(code),
            Ended::Crash(Stage::FirstRun, how) => {
                return Err(Failure::running(format!("the FMU {how} in its first plain run")));
            }
            Ended::Crash(stage, how) => crashed.push((stage, how)),
        }
    };
    for (stage, how) in crashed {
        let failed = Agreement::Failed { reason: format!("the FMU {how}") };
        match stage {
            Stage::FirstRun | Stage::Deterministic => result.deterministic = failed,
            Stage::SecondInstance => result.second_instance = failed,
            Stage::Restore => result.restore = failed,
            Stage::Serialize => result.serialize = failed,
            Stage::Reset => result.reset = failed,
        }
    }
    if arguments.json {
        let text = serde_json::to_string_pretty(&result).map_err(Failure::unusable)?;
        output::result(&(text + "\n"));
    } else {
        output::result(&render(&name, &result));
    }
    Ok(if result.repeatable() { NO_HAZARD } else { FMU_FAILED })
}

/// How a child process ended.
enum Ended {
    /// With a result.
    Result(Box<SelfTest>),
    /// With a message of its own.
    Code(u8),
    /// Killed by the FMU in this stage, and how.
    Crash(Stage, String),
}

/// Longest time for all stages together.
const LIMIT: Duration = Duration::from_secs(120);

/// Runs the stages that have not crashed in a process of their own. What the FMU prints does not reach the result.
fn in_child(arguments: &Arguments, crashed: &[(Stage, String)]) -> Result<Ended, Failure> {
    let cannot = |e: std::io::Error| Failure::unusable(format!("cannot start a process for the self-test: {e}"));
    let file = tempfile::NamedTempFile::new().map_err(cannot)?;
    let mut command = Command::new(std::env::current_exe().map_err(cannot)?);
    command.arg("selftest").arg(&arguments.fmu).args(["--steps", &arguments.steps.to_string()]);
    if let Some(step) = arguments.step {
        command.args(["--step", &step.to_string()]);
    }
    for (stage, _) in crashed {
        let name = stage.to_possible_value().map_or_else(String::new, |v| v.get_name().to_owned());
        command.args(["--skip", &name]);
    }
    command.arg("--child-result").arg(file.path()).stdin(Stdio::null()).stdout(Stdio::null());
    let mut child = command.spawn().map_err(cannot)?;
    let started = Instant::now();
    let status = loop {
        if let Some(status) = child.try_wait().map_err(cannot)? {
            break Some(status);
        }
        if started.elapsed() > LIMIT {
            let _ = child.kill();
            let _ = child.wait();
            break None;
        }
        std::thread::sleep(Duration::from_millis(5));
    };
    let text = std::fs::read_to_string(file.path()).map_err(cannot)?;
    let mut stage = Stage::FirstRun;
    for line in text.lines() {
        if let Ok(result) = serde_json::from_str::<SelfTest>(line) {
            return Ok(Ended::Result(Box::new(result)));
        }
        stage = serde_json::from_str(line).unwrap_or(stage);
    }
    Ok(match status {
        None => Ended::Crash(stage, format!("gave no answer within {} s", LIMIT.as_secs())),
        // It said itself what is wrong.
        Some(status) if status.code().is_some_and(|c| c == i32::from(UNUSABLE) || c == i32::from(FMU_FAILED)) => {
            Ended::Code(u8::try_from(status.code().unwrap_or(0)).unwrap_or(FMU_FAILED))
        }
        Some(status) => Ended::Crash(stage, format!("ended the process ({status})")),
    })
}

/// The stages in this process; each is written to `result` before it begins, the outcome at the end, one JSON a line.
fn child(arguments: &Arguments, result: &Path) -> Result<u8, Failure> {
    let cannot = |e: std::io::Error| Failure::unusable(format!("cannot write {}: {e}", result.display()));
    let mut log = std::fs::OpenOptions::new().append(true).open(result).map_err(cannot)?;
    let fmu = Fmu::open(&arguments.fmu)?;
    let slave = fmu.load()?;
    let description = fmu.description();
    let default_step = description.default_experiment.step_size.filter(|h| h.is_finite() && *h > 0.0);
    let step_s = arguments.step.or(default_step).unwrap_or(0.02);
    let (inputs, initial_inputs) = inputs(description);
    let outputs = outputs(description);
    if outputs.is_empty() {
        return Err(Failure::unusable_with_help(
            "this FMU has no numeric output or local variable to compare",
            "a self-test needs at least one",
        ));
    }
    let alone = |ports: Vec<Port>| ports.into_iter().map(|port| UnitPort { unit: 0, port }).collect();
    let setup = SystemSetup {
        names: vec![String::new()],
        inputs: alone(inputs),
        initial_inputs,
        outputs: alone(outputs),
        step_s,
        ..SystemSetup::default()
    };
    let steps = usize::try_from(arguments.steps).unwrap_or(80);
    let mut announce = |stage: Stage| {
        let _ = writeln!(log, "{}", serde_json::to_string(&stage).unwrap_or_default());
    };
    let outcome = selftest(&[slave], &setup, steps, &arguments.skip, &mut announce)
        .map_err(|e| Failure::running(format!("the FMU failed in its first plain run: {e}")))?;
    let text = serde_json::to_string(&outcome).map_err(Failure::unusable)?;
    writeln!(log, "{text}").map_err(cannot)?;
    Ok(NO_HAZARD)
}

fn render(name: &str, r: &SelfTest) -> String {
    let mut text = String::new();
    let _ = writeln!(
        text,
        "{name}: {} steps of {} s with {} moving inputs, {} outputs compared bit by bit",
        r.steps, r.step_s, r.inputs, r.outputs
    );
    for (what, result) in [
        ("two fresh instances agree", &r.deterministic),
        ("a second instance beside it", &r.second_instance),
        ("restored state, two held at once", &r.restore),
        ("reset against a fresh instance", &r.reset),
        ("serialised state in another instance", &r.serialize),
    ] {
        let _ = writeln!(text, "  {what:<38} {result}");
    }
    let bytes = r.bytes_per_state.map_or_else(|| "unknown".to_owned(), |b| b.to_string());
    let _ = writeln!(text, "  {:<38} {bytes}", "bytes in a state");
    let _ = writeln!(text, "  {:<38} {:.4}", "largest movement of an output", r.output_range);
    let conclusion = if r.repeatable() {
        format!("A scan brings states back by: {}", r.choice())
    } else {
        "A scan is not possible: findings could not be replayed".to_owned()
    };
    let _ = writeln!(text, "{conclusion}");
    text
}

/// Elements of one array that take part: the first of a large one stand for the rest.
const ELEMENTS: usize = 64;

/// The numbers of a variable, each with its start value.
fn ports(description: &ModelDescription, variable: &Variable) -> Vec<(Port, f64)> {
    let start = variable.numeric_start();
    let of = |i: usize| start.get(i).or(start.first()).copied().unwrap_or(0.0);
    let elements = description.elements(variable).take(ELEMENTS).enumerate();
    elements.filter_map(|(i, (name, handle))| Some((Port::new(name, handle, of(i))?, of(i)))).collect()
}

/// Inputs that can be moved, with their start values.
fn inputs(description: &ModelDescription) -> (Vec<Port>, Vec<f64>) {
    let inputs = description.variables.iter().filter(|v| v.causality == Causality::Input);
    inputs.flat_map(|v| ports(description, v)).unzip()
}

/// Outputs; for an FMU without any, its changing local variables.
fn outputs(description: &ModelDescription) -> Vec<Port> {
    let of = |wanted: Causality| -> Vec<Port> {
        let changing = |v: &&Variable| !matches!(v.variability, Variability::Constant | Variability::Fixed);
        let variables = description.variables.iter().filter(|v| v.causality == wanted).filter(changing);
        variables.flat_map(|v| ports(description, v)).map(|(port, _)| port).collect()
    };
    let outputs = of(Causality::Output);
    if outputs.is_empty() { of(Causality::Local) } else { outputs }
}
