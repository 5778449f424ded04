//! What a scan says before it searches: the FMU and the cell, how states are brought back, and what is to be known of all that.

use super::output;
use crate::scan::{Prepared, StateChoice};

/// Says it.
pub(super) fn introduce(prepared: &Prepared, state: StateChoice) {
    let s = &prepared.subject;
    for fmu in &s.fmus {
        let unit = if fmu.unit.is_empty() { String::new() } else { format!("{} = ", fmu.unit) };
        let tool = if fmu.generation_tool.is_empty() { "tool unknown" } else { &fmu.generation_tool };
        output::note(&format!("   Loaded  {unit}{} (FMI {} co-simulation, {tool})", fmu.model_name, fmu.fmi_version));
    }
    output::note(&format!("   Cell    {} from {}", s.cell, s.cell_found));
    if s.fmus.len() > 1 {
        let order: Vec<&str> = s.fmus.iter().map(|fmu| fmu.unit.as_str()).collect();
        output::note(&format!("   Coupled {}, stepped in this order", order.join(", then ")));
    }
    for coupling in &s.couplings {
        output::note(&format!("           {coupling}"));
    }
    let how = match state {
        StateChoice::Auto => prepared.self_test.because(prepared.rung),
        StateChoice::Fmu => "saved FMU states, as asked".to_owned(),
        StateChoice::Fork => "copies of the FMU's process, as asked".to_owned(),
        StateChoice::Process => "a fresh process and replay, as asked".to_owned(),
        StateChoice::Replay => "every sequence from a fresh instance, as asked".to_owned(),
    };
    let bytes = prepared.self_test.bytes_per_state.map_or_else(String::new, |b| format!(", {b} bytes each"));
    output::note(&format!("   States  {how}{bytes}"));
    for fmu in prepared.fmus.iter() {
        output::detail(&format!("   FMU     {}, sha256 {}", fmu.path().display(), fmu.sha256()));
    }
    let t = &prepared.self_test;
    output::detail(&format!(
        "   Tested  repeats itself {}; states restored {}; process copied {}; fresh process {}; reset {}",
        t.deterministic, t.restore, t.fork, t.fresh_process, t.reset
    ));
    for missing in &prepared.missing_protection {
        output::warning(&format!("protection against the FMU: {missing}"));
    }
    for warning in &prepared.warnings() {
        output::warning(warning);
    }
    for warning in prepared.fmus.iter().flat_map(crate::fmi::Fmu::warnings) {
        output::warning(&format!("modelDescription.xml: {warning}"));
    }
}
