//! The outside of `types3`, a model for tests of importers: every type of variable that FMI 3.0 knows, and arrays.
//!
//! It has more types than the tables of the cells can tell, hence a description of its own, for FMI 3.0 only.

use super::description::attribute;
use super::description3::{Parts, document, write_variable};
use super::faulty;
use super::variables::{Variant, fingerprint};
use std::fmt::Write as _;
use std::sync::OnceLock;

/// FMI `modelIdentifier`.
pub const IDENTIFIER: &str = "types3";
/// FMI `modelName`, and the name of the .fmu file.
pub const NAME: &str = "types3";
/// One sentence on what the model is.
pub const DESCRIPTION: &str = "One slowly turning joint with variables of all FMI 3.0 types: for tests of importers";

/// All types with their start values, written as in modelDescription.xml. Clocks have none.
pub const TYPES: [(&str, &str); 15] = [
    ("Float32", "0.5"),
    ("Float64", "-0.25"),
    ("Int8", "-8"),
    ("UInt8", "8"),
    ("Int16", "-16"),
    ("UInt16", "16"),
    ("Int32", "-32"),
    ("UInt32", "32"),
    ("Int64", "-64"),
    ("UInt64", "64"),
    ("Boolean", "true"),
    ("String", "start"),
    ("Binary", "00ff10"),
    ("Enumeration", "2"),
    ("Clock", ""),
];

/// The roles in which each type appears: an output equals its input, a local variable its parameter.
pub const ROLES: [&str; 4] = ["input", "output", "parameter", "local"];

/// Value references. Those from 1 to 60 belong to the types, see [`vr::of`].
#[allow(missing_docs, reason = "each is described below; in the build script the lint is silent")]
pub mod vr {
    pub const TIME: usize = 0;
    pub const STOP: usize = 61;
    pub const Q: usize = 62;
    pub const QD: usize = 63;
    /// Three numbers: q, qd and the input `Float64.input`.
    pub const FIXED_ARRAY: usize = 64;
    /// The structural parameter that tells the size of the next one.
    pub const N: usize = 65;
    /// n numbers: q, 2 q, 3 q and so on.
    pub const SIZED_ARRAY: usize = 66;

    /// The variable of a type in a role, both by their places in the tables.
    pub const fn of(kind: usize, role: usize) -> usize {
        1 + kind * super::ROLES.len() + role
    }
}

/// Start value and greatest value of the size of `sized_array`; the least is 1.
pub const SIZE: (u64, u64) = (4, 64);

/// Names of the values of the enumeration; the first is 1.
pub const LEVELS: [&str; 3] = ["low", "middle", "high"];

/// The `instantiationToken`: a fingerprint of the rest of the description.
pub fn token() -> &'static str {
    static TOKEN: OnceLock<String> = OnceLock::new();
    TOKEN.get_or_init(|| fingerprint(&description("", "")))
}

/// Renders modelDescription.xml (FMI 3.0); `version` is the version of this project.
pub fn xml3(version: &str) -> String {
    description(token(), version)
}

fn description(token: &str, version: &str) -> String {
    let mut variables = String::new();
    let mut outputs = Vec::new();
    let faulty = faulty::interface(Variant::Faithful).variables;
    write_variable(&mut variables, vr::TIME, &faulty[0]);
    for (kind, (name, start)) in TYPES.iter().enumerate() {
        for (place, role) in ROLES.iter().enumerate() {
            // A clock that is a parameter makes no sense.
            if (*name, *role) != ("Clock", "parameter") {
                write_typed(&mut variables, vr::of(kind, place), (name, start), role);
            }
        }
        outputs.push(vr::of(kind, 1));
    }
    for (reference, place) in [(vr::STOP, faulty::vr::STOP), (vr::Q, faulty::vr::Q), (vr::QD, faulty::vr::QD)] {
        write_variable(&mut variables, reference, &faulty[place]);
    }
    let array = |name: &str, reference: usize, dimension: &str| {
        format!(
            "    <Float64 name=\"{name}\" valueReference=\"{reference}\" causality=\"output\" \
             variability=\"continuous\" initial=\"calculated\"><Dimension {dimension}/></Float64>\n"
        )
    };
    variables.push_str(&array("fixed_array", vr::FIXED_ARRAY, "start=\"3\""));
    let _ = writeln!(
        variables,
        "    <UInt64 name=\"n\" valueReference=\"{}\" causality=\"structuralParameter\" variability=\"fixed\" \
         initial=\"exact\" min=\"1\" max=\"{}\" start=\"{}\"/>",
        vr::N,
        SIZE.1,
        SIZE.0,
    );
    variables.push_str(&array("sized_array", vr::SIZED_ARRAY, &format!("valueReference=\"{}\"", vr::N)));
    outputs.extend([vr::Q, vr::QD, vr::FIXED_ARRAY, vr::SIZED_ARRAY]);

    let mut types = String::from("  <TypeDefinitions>\n    <EnumerationType name=\"Level\">\n");
    for (place, level) in LEVELS.iter().enumerate() {
        let _ = writeln!(types, "      <Item name=\"{level}\" value=\"{}\"/>", place + 1);
    }
    types.push_str("    </EnumerationType>\n  </TypeDefinitions>\n");
    let parts = Parts {
        identifier: IDENTIFIER,
        name: NAME,
        description: DESCRIPTION,
        token,
        saves_state: true,
        once: false,
        has_events: true,
        units: &["rad", "rad/s", "s"],
        types: &types,
        variables: &variables,
        outputs: &outputs,
    };
    document(&parts, version)
}

fn write_typed(text: &mut String, reference: usize, (kind, start): (&str, &str), role: &str) {
    let changes = if kind.starts_with("Float") { "continuous" } else { "discrete" };
    let variability = match role {
        _ if kind == "Clock" => "discrete",
        "parameter" | "local" => "fixed",
        _ => changes,
    };
    let _ = write!(
        text,
        "    <{kind} name=\"{kind}.{role}\" valueReference=\"{reference}\" causality=\"{role}\" \
         variability=\"{variability}\""
    );
    let starts = matches!(role, "input" | "parameter");
    match kind {
        "Clock" => attribute(text, "intervalVariability", Some("triggered".to_owned())),
        _ => attribute(text, "initial", Some(if starts { "exact" } else { "calculated" }.to_owned())),
    }
    if kind == "Enumeration" {
        attribute(text, "declaredType", Some("Level".to_owned()));
    }
    match kind {
        "Clock" => text.push_str("/>\n"),
        "String" | "Binary" if starts => {
            let _ = writeln!(text, "><Start value=\"{start}\"/></{kind}>");
        }
        _ => {
            attribute(text, "start", starts.then(|| start.to_owned()));
            text.push_str("/>\n");
        }
    }
}
