//! Writes modelDescription.xml of FMI 3.0 (co-simulation), from the same interface tables as that of FMI 2.0.

use super::description::{attribute, escaped, role, write_kind, write_log_and_experiment, write_units};
use super::variables::{Causality, Interface, Kind, Variable, Variant};
use std::fmt::Write as _;

/// What differs from one description to the next.
#[derive(Debug)]
pub(super) struct Parts<'a> {
    /// `modelIdentifier`
    pub identifier: &'a str,
    /// `modelName`
    pub name: &'a str,
    /// `description`
    pub description: &'a str,
    /// `instantiationToken`
    pub token: &'a str,
    /// Whether the state functions work.
    pub saves_state: bool,
    /// Whether a process can have one instance only.
    pub once: bool,
    /// Whether there is an event mode, and steps that may end early.
    pub has_events: bool,
    /// The units in use.
    pub units: &'a [&'a str],
    /// The element `TypeDefinitions`, or nothing.
    pub types: &'a str,
    /// What is in the element `ModelVariables`.
    pub variables: &'a str,
    /// The value references of all outputs.
    pub outputs: &'a [usize],
}

/// Renders the whole file; `version` is the version of this project.
pub fn xml3(interface: &Interface, version: &str) -> String {
    let mut variables = String::new();
    for (reference, variable) in interface.variables.iter().enumerate() {
        write_variable(&mut variables, reference, variable);
    }
    let units: Vec<_> = interface
        .variables
        .iter()
        .filter_map(|variable| if let Kind::Real { unit, .. } = variable.kind { Some(unit) } else { None })
        .collect();
    let is_output = |place: &usize| interface.variables[*place].causality == Causality::Output;
    let outputs: Vec<_> = (0..interface.variables.len()).filter(is_output).collect();
    let parts = Parts {
        identifier: &interface.identifier,
        name: &interface.name,
        description: interface.description,
        token: &interface.guid(),
        saves_state: interface.variant.saves_state(),
        once: interface.variant == Variant::OncePerProcess,
        has_events: interface.has_event_mode(),
        units: &units,
        types: "",
        variables: &variables,
        outputs: &outputs,
    };
    document(&parts, version)
}

/// Puts the parts together.
pub(super) fn document(parts: &Parts, version: &str) -> String {
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let _ = write!(
        text,
        "<fmiModelDescription\n  fmiVersion=\"3.0\"\n  modelName=\"{name}\"\n  instantiationToken=\"{token}\"\n  \
         description=\"{description}\"\n  version=\"{version}\"\n  license=\"MIT OR Apache-2.0\"\n  \
         generationTool=\"fmi-hazard {version}\"\n  variableNamingConvention=\"structured\">\n  \
         <CoSimulation\n    modelIdentifier=\"{identifier}\"\n    canGetAndSetFMUState=\"{state}\"\n    \
         canSerializeFMUState=\"{state}\"\n    canHandleVariableCommunicationStepSize=\"true\"\n    \
         canBeInstantiatedOnlyOncePerProcess=\"{once}\"\n    \
         mightReturnEarlyFromDoStep=\"{events}\"\n    hasEventMode=\"{events}\"/>\n",
        name = escaped(parts.name),
        token = parts.token,
        description = escaped(parts.description),
        identifier = parts.identifier,
        state = parts.saves_state,
        once = parts.once,
        events = parts.has_events,
    );
    write_units(&mut text, |unit| parts.units.contains(&unit));
    text.push_str(parts.types);
    write_log_and_experiment(&mut text);
    let _ = write!(text, "  <ModelVariables>\n{}  </ModelVariables>\n  <ModelStructure>\n", parts.variables);
    for element in ["Output", "InitialUnknown"] {
        for reference in parts.outputs {
            let _ = writeln!(text, "    <{element} valueReference=\"{reference}\"/>");
        }
    }
    text.push_str("  </ModelStructure>\n</fmiModelDescription>\n");
    text
}

/// One variable: the type is the element, and all else its attributes.
pub(super) fn write_variable(text: &mut String, reference: usize, variable: &Variable) {
    let element = match variable.kind {
        Kind::Real { .. } => "Float64",
        Kind::Integer { .. } => "Int32",
        Kind::Boolean { .. } => "Boolean",
    };
    let (causality, variability, initial) = role(variable);
    let _ = write!(
        text,
        "    <{element} name=\"{}\" valueReference=\"{reference}\" description=\"{}\" causality=\"{causality}\" \
         variability=\"{variability}\"",
        escaped(&variable.name),
        escaped(&variable.description),
    );
    attribute(text, "initial", initial.map(str::to_owned));
    write_kind(text, variable);
    text.push_str("/>\n");
}

#[cfg(test)]
mod tests {
    use super::super::{faulty, safety_fence, workcell};
    use super::*;

    #[test]
    fn variables_are_written_as_the_standard_wants_them() {
        let text = xml3(&workcell::interface(&safety_fence::SPEC, Variant::Faithful).0, "0");
        for line in [
            "    <Float64 name=\"time\" valueReference=\"0\" description=\"Simulation time\" causality=\"independent\" \
             variability=\"continuous\" unit=\"s\"/>\n",
            "causality=\"output\" variability=\"discrete\" initial=\"calculated\"",
            "    <Boolean name=\"plc.guard_closed\"",
            "hasEventMode=\"false\"",
        ] {
            assert!(text.contains(line), "{line}\n{text}");
        }
        assert!(text.contains(&format!(
            "instantiationToken=\"{}\"",
            workcell::interface(&safety_fence::SPEC, Variant::Faithful).0.guid()
        )));
        assert!(xml3(&faulty::interface(Variant::Faithful), "0").contains("hasEventMode=\"true\""));
        assert!(xml3(&faulty::interface(Variant::NoState), "0").contains("canGetAndSetFMUState=\"false\""));
    }
}
