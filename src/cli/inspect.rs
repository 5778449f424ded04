//! `fmi-hazard inspect`: what an FMU is. Nothing of it is loaded or run.

use std::fmt::Write as _;
use std::path::PathBuf;

use super::exit::{Failure, NO_HAZARD};
use super::output;
use crate::cell::find::EXTRA_FOLDER;
use crate::fmi::{Causality, FmiVersion, Fmu, ModelDescription, Variable, VariableType, printable};

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
        output::warning(&warning.to_string());
    }
    Ok(NO_HAZARD)
}

fn render(fmu: &Fmu, all: bool) -> String {
    let d = fmu.description();
    let count = |c: Causality| d.variables.iter().filter(|v| v.causality == c).count();
    let mut text = String::new();
    let _ = writeln!(text, "{}  FMI {}  \"{}\"", fmu.path().display(), d.fmi_version, printable(&d.model_name));
    let _ = writeln!(text, "  exported by  {}", printable(d.generation_tool.as_deref().unwrap_or("unknown")));
    let _ = writeln!(text, "  sha256       {}", fmu.sha256());
    let _ = writeln!(text, "  platforms    {}", printable(&fmu.platforms().join(", ")));
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
            if d.version() == Some(FmiVersion::V3) {
                let fixed = c.fixed_internal_step.map_or_else(|| "no".to_owned(), |h| format!("{h} s"));
                let _ = writeln!(
                    text,
                    "  FMI 3.0        event mode {}, might return early {}, intermediate update {}, fixed internal step {fixed}",
                    yes(c.has_event_mode),
                    yes(c.might_return_early),
                    yes(c.provides_intermediate_update)
                );
            }
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
        // What comes from the vendor may be of any length; its control characters are escaped where it is printed.
        let _ = writeln!(
            text,
            "    {:<12} {:<28} {:<10} {}",
            v.causality.to_string(),
            printable(&v.name),
            printable(&type_name(d, v)),
            printable(&v.description)
        );
    }
    text
}

/// Type, unit and shape, for instance `Float64[3] m/s`.
fn type_name(d: &ModelDescription, v: &Variable) -> String {
    let mut text = d.version().map_or_else(|| v.scalar.to_string(), |version| v.type_name(version));
    if let Some(extents) = d.extents(v).filter(|e| !e.is_empty()) {
        let extents: Vec<String> = extents.iter().map(ToString::to_string).collect();
        let _ = write!(text, "[{}]", extents.join(","));
    }
    if let VariableType::Real { unit: Some(unit), .. } = &v.kind {
        let _ = write!(text, " {unit}");
    }
    text
}
