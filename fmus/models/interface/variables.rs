//! What an example FMU shows to the outside: its names, its variables and a GUID made from them.
//!
//! The library and the build script read the same tables, so the binary and its modelDescription.xml cannot disagree:
//! any change of a table changes the GUID, and an FMU with the wrong GUID refuses to start.

/// The outside of one model.
#[derive(Debug)]
pub struct Interface {
    /// FMI `modelIdentifier`: a C identifier, also the file name of the binary.
    pub identifier: String,
    /// FMI `modelName`, and the name of the .fmu file.
    pub name: String,
    /// One sentence on what the model is.
    pub description: &'static str,
    /// How faithfully the model keeps FMI's promises.
    pub variant: Variant,
    /// All variables; the value reference of each is its place here.
    pub variables: Vec<Variable>,
}

/// How faithfully a model keeps FMI's promises. All but the first are for tests of importers.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Variant {
    /// Keeps them all.
    Faithful,
    /// The state functions only return an error, and modelDescription.xml says so.
    NoState,
    /// A reset leaves the model as it is.
    IdleReset,
    /// A restored state forgets that a stop was demanded.
    ForgetsLatch,
    /// One instance in a process, once; modelDescription.xml says so.
    OncePerProcess,
}

impl Variant {
    /// All of them.
    pub const ALL: [Variant; 5] =
        [Variant::Faithful, Variant::NoState, Variant::IdleReset, Variant::ForgetsLatch, Variant::OncePerProcess];

    /// Identifier and name of this variant of a model.
    pub fn names(self, identifier: &str, name: &str) -> (String, String) {
        let ending = match self {
            Variant::Faithful => return (identifier.to_owned(), name.to_owned()),
            Variant::NoState => "nostate",
            Variant::IdleReset => "idlereset",
            Variant::ForgetsLatch => "forgets",
            Variant::OncePerProcess => "once",
        };
        (format!("{identifier}_{ending}"), format!("{name}-{ending}"))
    }

    /// Whether the state functions work at all.
    pub fn saves_state(self) -> bool {
        self != Variant::NoState
    }
}

/// One scalar variable.
#[derive(Debug)]
pub struct Variable {
    /// Name in the `structured` convention, e.g. `robot.q[1]`.
    pub name: String,
    /// One sentence, unit and frame included where it matters.
    pub description: String,
    /// Its role.
    pub causality: Causality,
    /// Type, unit and bounds.
    pub kind: Kind,
}

/// The roles used here. Parameters are `fixed`, outputs are `calculated`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Causality {
    /// The time of the simulation.
    Independent,
    /// Set before initialisation is left, then fixed.
    Parameter,
    /// Set at communication points, held over the step.
    Input,
    /// Computed.
    Output,
}

/// The type of a variable with its unit, start value and bounds. Outputs have no start value: theirs is ignored.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Kind {
    /// A real number.
    Real {
        /// Name of the unit, one of those in `description::UNITS`.
        unit: &'static str,
        /// Start value.
        start: f64,
        /// Smallest value.
        min: Option<f64>,
        /// Greatest value.
        max: Option<f64>,
    },
    /// A whole number.
    Integer {
        /// Start value.
        start: i32,
        /// Smallest value.
        min: Option<i32>,
        /// Greatest value.
        max: Option<i32>,
    },
    /// True or false.
    Boolean {
        /// Start value.
        start: bool,
    },
}

/// A value on its way in or out.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Value {
    /// Of a real variable.
    Real(f64),
    /// Of an integer variable.
    Integer(i32),
    /// Of a boolean variable.
    Boolean(bool),
}

impl Variable {
    /// The variable `time`, s.
    pub fn time() -> Self {
        let kind = Kind::Real { unit: "s", start: 0.0, min: None, max: None };
        Self::new("time", "Simulation time", Causality::Independent, kind)
    }

    /// A variable from its four parts.
    pub fn new(name: &str, description: &str, causality: Causality, kind: Kind) -> Self {
        Self { name: name.to_owned(), description: description.to_owned(), causality, kind }
    }
}

impl Kind {
    /// A real number with neither bounds nor a start value other than 0.
    pub fn real(unit: &'static str) -> Self {
        Kind::Real { unit, start: 0.0, min: None, max: None }
    }

    /// A real number between `min` and `max`.
    pub fn real_in(unit: &'static str, start: f64, min: f64, max: f64) -> Self {
        Kind::Real { unit, start, min: Some(min), max: Some(max) }
    }

    /// A whole number between `min` and `max`.
    pub fn integer_in(start: i32, min: i32, max: i32) -> Self {
        Kind::Integer { start, min: Some(min), max: Some(max) }
    }

    /// The start value.
    pub fn start(&self) -> Value {
        match *self {
            Kind::Real { start, .. } => Value::Real(start),
            Kind::Integer { start, .. } => Value::Integer(start),
            Kind::Boolean { start } => Value::Boolean(start),
        }
    }

    /// Whether `value` has this type, is finite and lies within the bounds.
    pub fn admits(&self, value: Value) -> bool {
        match (*self, value) {
            (Kind::Real { min, max, .. }, Value::Real(x)) => {
                x.is_finite() && min.is_none_or(|min| x >= min) && max.is_none_or(|max| x <= max)
            }
            (Kind::Integer { min, max, .. }, Value::Integer(n)) => {
                min.is_none_or(|min| n >= min) && max.is_none_or(|max| n <= max)
            }
            (Kind::Boolean { .. }, Value::Boolean(_)) => true,
            _ => false,
        }
    }
}

impl Interface {
    /// The place of the variable of this name.
    pub fn place(&self, name: &str) -> Option<usize> {
        self.variables.iter().position(|variable| variable.name == name)
    }

    /// The FMI 2.0 `guid` and FMI 3.0 `instantiationToken`: a fingerprint of everything in this interface, with an end of the
    /// name's own.
    pub fn guid(&self) -> String {
        let mut guid = fingerprint(&format!("{self:?}"));
        let end = self.end_of_guid();
        guid.truncate(guid.len() - end.len());
        guid + &end
    }

    /// What `guid` ends with.
    pub fn end_of_guid(&self) -> String {
        fingerprint(&self.name).split_off(GUID_END)
    }

    /// FMI 3.0 `hasEventMode`: only the faulty model has events.
    pub fn has_event_mode(&self) -> bool {
        self.identifier.starts_with("faulty")
    }
}

/// Where the last group of a GUID in braces begins.
const GUID_END: usize = "{00000000-0000-0000-0000-".len();

/// A fingerprint of a text (FNV-1a, 128 bit), written as a GUID in braces.
pub(super) fn fingerprint(text: &str) -> String {
    let mut hash: u128 = 0x6c62_272e_07bb_0142_62b8_2175_6295_c58d;
    for byte in text.bytes() {
        hash = (hash ^ u128::from(byte)).wrapping_mul(0x0000_0000_0100_0000_0000_0000_0000_013b);
    }
    let hex = format!("{hash:032x}");
    format!("{{{}-{}-{}-{}-{}}}", &hex[..8], &hex[8..12], &hex[12..16], &hex[16..20], &hex[20..])
}
