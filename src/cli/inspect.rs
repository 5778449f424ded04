//! `fmi-hazard inspect`: what an FMU is. Nothing of it is loaded or run.

use std::fmt::Write as _;
use std::path::PathBuf;

use super::exit::{Failure, NO_HAZARD};
use super::output;
use crate::cell::find::EXTRA_FOLDER;
use crate::fmi::{Causality, Fmu, Variable, VariableType};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// The FMU
    fmu: PathBuf,
    /// List local variables and parameters too
    #[arg(long)]
    all: bool,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let fmu = Fmu::open(&arguments.fmu)?;
    output::result(&render(&fmu, arguments.all));
    for warning in fmu.warnings() {
        output::note(&format!("warning: {warning}"));
    }
    Ok(NO_HAZARD)
}

fn render(fmu: &Fmu, all: bool) -> String {
    let d = fmu.description();
    let count = |c: Causality| d.variables.iter().filter(|v| v.causality == c).count();
    let mut text = String::new();
    let _ = writeln!(text, "{}  FMI {}  \"{}\"", fmu.path().display(), d.fmi_version, d.model_name);
    let _ = writeln!(text, "  exported by  {}", d.generation_tool.as_deref().unwrap_or("unknown"));
    let _ = writeln!(text, "  sha256       {}", fmu.sha256());
    let _ = writeln!(text, "  platforms    {}", fmu.platforms().join(", "));
    let yes = |b: bool| if b { "yes" } else { "no" };
    match &d.co_simulation {
        Some(cs) => {
            let c = &cs.capabilities;
            let _ = writeln!(
                text,
                "  co-simulation  state get/set {}, serialise {}, variable step {}, once per process {}, needs its tool {}",
                yes(c.can_get_and_set_state),
                yes(c.can_serialize_state),
                yes(c.can_handle_variable_step),
                yes(c.once_per_process),
                yes(c.needs_execution_tool)
            );
        }
        None => text.push_str("  co-simulation  no\n"),
    }
    let cell = format!("{EXTRA_FOLDER}/cell.toml");
    let _ = writeln!(text, "  own cell     {}", yes(fmu.file(&cell).is_some()));
    let _ = writeln!(
        text,
        "  variables    {} ({} inputs, {} outputs, {} parameters)",
        d.variables.len(),
        count(Causality::Input),
        count(Causality::Output),
        count(Causality::Parameter)
    );
    let shown = |v: &&Variable| all || matches!(v.causality, Causality::Input | Causality::Output);
    for v in d.variables.iter().filter(shown) {
        // Names come from the vendor: control characters must not reach the terminal.
        let name: String = v.name.chars().map(|c| if c.is_control() { '?' } else { c }).collect();
        let _ =
            writeln!(text, "    {:<12} {:<28} {:<10} {}", v.causality.to_string(), name, type_name(v), v.description);
    }
    text
}

fn type_name(v: &Variable) -> String {
    match &v.kind {
        VariableType::Real { unit: Some(unit), .. } => format!("Real {unit}"),
        VariableType::Real { .. } => "Real".to_owned(),
        VariableType::Integer { .. } => "Integer".to_owned(),
        VariableType::Boolean { .. } => "Boolean".to_owned(),
        VariableType::Enumeration { .. } => "Enumeration".to_owned(),
        VariableType::String { .. } => "String".to_owned(),
    }
}
