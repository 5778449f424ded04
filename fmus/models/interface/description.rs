//! Writes modelDescription.xml (FMI 2.0, co-simulation) from an interface table.

use super::variables::{Causality, Interface, Kind, Variable, Variant};
use std::fmt::Write as _;

/// The units in use: name and exponents of the SI base units.
pub const UNITS: [(&str, &str); 7] = [
    ("1", ""),
    ("kg", "kg=\"1\""),
    ("m", "m=\"1\""),
    ("m/s", "m=\"1\" s=\"-1\""),
    ("rad", "rad=\"1\""),
    ("rad/s", "rad=\"1\" s=\"-1\""),
    ("s", "s=\"1\""),
];

/// Communication step the importer should take unless told otherwise, s.
pub const DEFAULT_STEP: f64 = 0.02;

/// How long they are run unless told otherwise, s: some cycles of the slowest. They go on for ever.
const DEFAULT_STOP: u32 = 60;

/// Renders the whole file; `version` is the version of this project.
pub fn xml(interface: &Interface, version: &str) -> String {
    let mut text = String::from("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    let state = interface.variant.saves_state();
    let once = interface.variant == Variant::OncePerProcess;
    let _ = write!(
        text,
        "<fmiModelDescription\n  fmiVersion=\"2.0\"\n  modelName=\"{name}\"\n  guid=\"{guid}\"\n  \
         description=\"{description}\"\n  version=\"{version}\"\n  license=\"MIT OR Apache-2.0\"\n  \
         generationTool=\"fmi-hazard {version}\"\n  variableNamingConvention=\"structured\">\n  \
         <CoSimulation\n    modelIdentifier=\"{identifier}\"\n    canHandleVariableCommunicationStepSize=\"true\"\n    \
         canGetAndSetFMUstate=\"{state}\"\n    canSerializeFMUstate=\"{state}\"\n    canBeInstantiatedOnlyOncePerProcess=\"{once}\"/>\n",
        name = escaped(&interface.name),
        guid = interface.guid(),
        description = escaped(interface.description),
        identifier = interface.identifier,
    );
    let used = |unit: &str| {
        interface.variables.iter().any(|variable| matches!(variable.kind, Kind::Real { unit: of, .. } if of == unit))
    };
    write_units(&mut text, used);
    write_log_and_experiment(&mut text);
    text.push_str("  <ModelVariables>\n");
    for (reference, variable) in interface.variables.iter().enumerate() {
        write_variable(&mut text, reference, variable);
    }
    text.push_str("  </ModelVariables>\n  <ModelStructure>\n");
    for list in ["Outputs", "InitialUnknowns"] {
        let _ = writeln!(text, "    <{list}>");
        for (reference, variable) in interface.variables.iter().enumerate() {
            if variable.causality == Causality::Output {
                let _ = writeln!(text, "      <Unknown index=\"{}\"/>", reference + 1);
            }
        }
        let _ = writeln!(text, "    </{list}>");
    }
    text.push_str("  </ModelStructure>\n</fmiModelDescription>\n");
    text
}

/// The definitions of the units in use.
pub(super) fn write_units(text: &mut String, used: impl Fn(&str) -> bool) {
    text.push_str("  <UnitDefinitions>\n");
    for (name, exponents) in UNITS.iter().filter(|(name, _)| used(name)) {
        let space = if exponents.is_empty() { "" } else { " " };
        let _ = writeln!(text, "    <Unit name=\"{name}\"><BaseUnit{space}{exponents}/></Unit>");
    }
    text.push_str("  </UnitDefinitions>\n");
}

/// The categories of log messages, and the experiment to make unless told otherwise.
pub(super) fn write_log_and_experiment(text: &mut String) {
    text.push_str("  <LogCategories>\n");
    for category in ["logStatusError", "logStatusDiscard", "logStatusFatal"] {
        let _ = writeln!(text, "    <Category name=\"{category}\"/>");
    }
    let _ = write!(
        text,
        "  </LogCategories>\n  <DefaultExperiment startTime=\"0\" stopTime=\"{DEFAULT_STOP}\" stepSize=\"{DEFAULT_STEP:?}\"/>\n"
    );
}

/// The attributes causality, variability and, where it has one, initial.
pub(super) fn role(variable: &Variable) -> (&'static str, &'static str, Option<&'static str>) {
    let real = matches!(variable.kind, Kind::Real { .. });
    match variable.causality {
        Causality::Independent => ("independent", "continuous", None),
        Causality::Parameter => ("parameter", "fixed", Some("exact")),
        Causality::Input => ("input", if real { "continuous" } else { "discrete" }, None),
        Causality::Output => ("output", if real { "continuous" } else { "discrete" }, Some("calculated")),
    }
}

fn write_variable(text: &mut String, reference: usize, variable: &Variable) {
    let (causality, variability, initial) = role(variable);
    let _ = write!(
        text,
        "    <ScalarVariable name=\"{}\" valueReference=\"{reference}\" description=\"{}\" causality=\"{causality}\" \
         variability=\"{variability}\"",
        escaped(&variable.name),
        escaped(&variable.description),
    );
    if let Some(initial) = initial {
        let _ = write!(text, " initial=\"{initial}\"");
    }
    text.push_str(">\n      ");
    text.push_str(match variable.kind {
        Kind::Real { .. } => "<Real",
        Kind::Integer { .. } => "<Integer",
        Kind::Boolean { .. } => "<Boolean",
    });
    write_kind(text, variable);
    text.push_str("/>\n    </ScalarVariable>\n");
}

/// The attributes that come with the type.
pub(super) fn write_kind(text: &mut String, variable: &Variable) {
    let starts = matches!(variable.causality, Causality::Parameter | Causality::Input);
    match variable.kind {
        Kind::Real { unit, start, min, max } => {
            attribute(text, "unit", Some(unit.to_owned()));
            attribute(text, "min", min.map(|x| format!("{x:?}")));
            attribute(text, "max", max.map(|x| format!("{x:?}")));
            attribute(text, "start", starts.then(|| format!("{start:?}")));
        }
        Kind::Integer { start, min, max } => {
            attribute(text, "min", min.map(|n| n.to_string()));
            attribute(text, "max", max.map(|n| n.to_string()));
            attribute(text, "start", starts.then(|| start.to_string()));
        }
        Kind::Boolean { start } => {
            attribute(text, "start", starts.then(|| start.to_string()));
        }
    }
}

/// Writes an attribute that has a value.
pub(super) fn attribute(text: &mut String, name: &str, value: Option<String>) {
    if let Some(value) = value {
        let _ = write!(text, " {name}=\"{value}\"");
    }
}

/// Text as XML wants it.
pub(super) fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::super::{all, coupled, faulty, gantry, guarded, safety_fence, workcell};
    use super::*;

    #[test]
    fn each_place_in_a_table_is_the_one_its_constant_names() {
        let faulty = faulty::interface(Variant::Faithful);
        for (place, name) in [
            (faulty::vr::FAULT_KIND, "fault.kind"),
            (faulty::vr::FAULT_STEP, "fault.step"),
            (faulty::vr::STOP, "stop"),
            (faulty::vr::PUSH, "push"),
            (faulty::vr::Q, "q"),
            (faulty::vr::QD, "qd"),
        ] {
            assert_eq!(faulty.variables[place].name, name);
        }
        let slides = gantry::interface();
        for (place, name) in [
            (gantry::vr::LATCHED, "plc.latched"),
            (gantry::vr::REACTION, "plc.reaction_ms"),
            (gantry::vr::FILTER, "plc.filter_ms"),
            (gantry::vr::RAMP, "plc.ramp_ms"),
            (gantry::vr::MUTING_FROM, "muting.from_ms"),
            (gantry::vr::MUTING_TO, "muting.to_ms"),
            (gantry::vr::STROKE, "axis.stroke[1]"),
            (gantry::vr::SPEED, "axis.speed[1]"),
            (gantry::vr::PHASE0, "axis.phase0[1]"),
            (gantry::vr::CURTAIN_CLEAR, "plc.curtain_clear"),
            (gantry::vr::DOOR_CLEAR, "plc.door_clear"),
            (gantry::vr::RESET, "plc.reset"),
            (gantry::vr::POSITION, "axis.position[1]"),
            (gantry::vr::VELOCITY, "axis.velocity[1]"),
            (gantry::vr::LEG, "ctrl.leg"),
        ] {
            assert_eq!(slides.variables[place].name, name);
        }
        let guarded = guarded::interface();
        for (place, name) in [
            (guarded::vr::SPEED, "drive.speed"),
            (guarded::vr::T_REACT, "plc.t_react"),
            (guarded::vr::T_RAMP, "plc.t_ramp"),
            (guarded::vr::TAU, "filter.tau"),
            (guarded::vr::MUTING, "muting.enabled"),
            (guarded::vr::HOLD_TIME, "muting.hold_time"),
            (guarded::vr::SSM_DISTANCE, "ssm.distance"),
            (guarded::vr::FIELD_RADIUS, "field.radius"),
            (guarded::vr::CLEAR, "clear"),
            (guarded::vr::PERSON_X, "person.x"),
            (guarded::vr::PERSON_Y, "person.y"),
            (guarded::vr::Q, "q"),
            (guarded::vr::QD, "qd"),
            (guarded::vr::OCCUPIED, "field.occupied"),
            (guarded::vr::COUNTS, "demand.counts"),
        ] {
            assert_eq!(guarded.variables[place].name, name);
        }
        let [plc, controller, kinematics] = coupled::all();
        let [stations, ..] = coupled::stations();
        for (interface, place, name) in [
            (&plc, coupled::plc::T_REACT, "t_react"),
            (&plc, coupled::plc::MAT_CLEAR, "mat_clear"),
            (&plc, coupled::plc::RESET, "reset"),
            (&plc, coupled::plc::STOP, "stop"),
            (&stations, coupled::plc::T_REACT, "t_react"),
            (&stations, coupled::stations_plc::FIELD_CLEAR, "field_clear"),
            (&stations, coupled::plc::RESET, "reset"),
            (&stations, coupled::plc::STOP, "stop"),
            (&stations, coupled::stations_plc::STATION_A, "station_a"),
            (&stations, coupled::stations_plc::STATION_B, "station_b"),
            (&stations, coupled::stations_plc::MUTES, "mute_at_stations"),
            (&controller, coupled::controller::PHASE0, "phase0"),
            (&controller, coupled::controller::STOP, "stop"),
            (&controller, coupled::controller::POSITION, "tcp.position.x"),
            (&controller, coupled::controller::VELOCITY, "tcp.velocity.x"),
            (&controller, coupled::controller::LEG, "leg"),
            (&kinematics, coupled::kinematics::POSITION, "tcp.position.x"),
            (&kinematics, coupled::kinematics::VELOCITY, "tcp.velocity.x"),
            (&kinematics, coupled::kinematics::Q, "q[1]"),
            (&kinematics, coupled::kinematics::QD, "qd[1]"),
            (&kinematics, coupled::kinematics::PAYLOAD, "payload"),
        ] {
            assert_eq!(interface.variables[place].name, name);
        }
    }

    #[test]
    fn names_are_unique_in_each_table() {
        for interface in all() {
            let mut names: Vec<_> = interface.variables.iter().map(|variable| &variable.name).collect();
            names.sort();
            names.dedup();
            assert_eq!(names.len(), interface.variables.len(), "{}", interface.name);
        }
    }

    #[test]
    fn guids_differ_and_follow_the_table() {
        let mut guids: Vec<_> = all().iter().map(Interface::guid).collect();
        let mut changed = workcell::interface(&safety_fence::SPEC, Variant::Faithful).0;
        changed.variables[1].kind = Kind::real_in("s", 0.06, 0.0, 5.0);
        guids.push(changed.guid());
        guids.sort();
        let count = guids.len();
        guids.dedup();
        assert_eq!(guids.len(), count);
        assert_eq!(guids[0].len(), 38);
    }

    #[test]
    fn names_and_texts_are_escaped() {
        let mut interface = faulty::interface(Variant::Faithful);
        interface.variables[3].description = "a < b & \"c\"".to_owned();
        assert!(xml(&interface, "0").contains("description=\"a &lt; b &amp; &quot;c&quot;\""));
    }
}
