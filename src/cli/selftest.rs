//! `fmi-hazard selftest`: what an FMU's promises about its state are worth, for any FMU.

use std::fmt::Write as _;
use std::path::PathBuf;

use super::exit::{FMU_FAILED, Failure, NO_HAZARD};
use super::output;
use crate::fmi::{Causality, Fmu, Variability, Variable, VariableType};
use crate::host::in_process::Setup;
use crate::host::port::{Port, PortKind};
use crate::host::selftest::{SelfTest, selftest};

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
}

fn positive(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(v) if v.is_finite() && v > 0.0 => Ok(v),
        _ => Err("a number greater than zero is needed".to_owned()),
    }
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let fmu = Fmu::open(&arguments.fmu)?;
    let slave = fmu.load()?;
    let description = fmu.description();
    let default_step = description.default_experiment.step_size.filter(|h| h.is_finite() && *h > 0.0);
    let step_s = arguments.step.or(default_step).unwrap_or(0.02);
    let (inputs, initial_inputs) = inputs(&description.variables);
    let outputs = outputs(&description.variables);
    if outputs.is_empty() {
        return Err(Failure::unusable_with_help(
            "this FMU has no numeric output or local variable to compare",
            "a self-test needs at least one",
        ));
    }
    let setup = Setup { parameters: Vec::new(), inputs, initial_inputs, outputs, step_s };
    let steps = usize::try_from(arguments.steps).unwrap_or(80);
    let result = match selftest(&slave, &setup, steps) {
        Ok(result) => result,
        Err(error) => {
            output::error(&format!("the FMU failed in its first plain run: {error}"));
            return Ok(FMU_FAILED);
        }
    };
    if arguments.json {
        let text = serde_json::to_string_pretty(&result).map_err(Failure::unusable)?;
        output::result(&(text + "\n"));
    } else {
        output::result(&render(&description.model_name, &result));
    }
    Ok(if result.repeatable() { NO_HAZARD } else { FMU_FAILED })
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

fn kind(variable: &Variable) -> Option<PortKind> {
    match variable.kind {
        VariableType::Real { .. } => Some(PortKind::Real),
        VariableType::Integer { .. } | VariableType::Enumeration { .. } => Some(PortKind::Integer),
        VariableType::Boolean { .. } => Some(PortKind::Boolean),
        VariableType::String { .. } => None,
    }
}

fn port(variable: &Variable) -> Option<Port> {
    let kind = kind(variable)?;
    Some(Port { name: variable.name.clone(), value_reference: variable.value_reference, kind })
}

/// Inputs that can be moved, with their start values.
fn inputs(variables: &[Variable]) -> (Vec<Port>, Vec<f64>) {
    let inputs = variables.iter().filter(|v| v.causality == Causality::Input);
    inputs.filter_map(|v| Some((port(v)?, start(v)))).unzip()
}

fn start(variable: &Variable) -> f64 {
    match &variable.kind {
        VariableType::Real { start, .. } => start.unwrap_or(0.0),
        VariableType::Integer { start, .. } | VariableType::Enumeration { start, .. } => f64::from(start.unwrap_or(0)),
        VariableType::Boolean { start, .. } => f64::from(u8::from(start.unwrap_or(false))),
        VariableType::String { .. } => 0.0,
    }
}

/// Outputs; for an FMU without any, its changing local variables.
fn outputs(variables: &[Variable]) -> Vec<Port> {
    let of = |wanted: Causality| -> Vec<Port> {
        let changing = |v: &&Variable| !matches!(v.variability, Variability::Constant | Variability::Fixed);
        variables.iter().filter(|v| v.causality == wanted).filter(changing).filter_map(port).collect()
    };
    let outputs = of(Causality::Output);
    if outputs.is_empty() { of(Causality::Local) } else { outputs }
}
