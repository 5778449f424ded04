//! A variable of an FMU: its direction, its type, its shape, and how it is addressed in the C interface.

use std::fmt;

use serde::{Deserialize, Serialize};

use super::version::FmiVersion;

/// A variable: one value, or an array of them.
#[derive(Clone, Debug, PartialEq)]
pub struct Variable {
    /// Name.
    pub name: String,
    /// Handle for the C interface.
    pub value_reference: u32,
    /// Direction.
    pub causality: Causality,
    /// When it may change.
    pub variability: Variability,
    /// Type with its attributes.
    pub kind: VariableType,
    /// Type in the C interface.
    pub scalar: Scalar,
    /// Shape; empty for one value.
    pub dimensions: Vec<Dimension>,
    /// Text for people; may be empty.
    pub description: String,
    /// Line in modelDescription.xml, from 1.
    pub line: usize,
}

/// Direction of a variable.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Causality {
    /// Set before initialisation.
    Parameter,
    /// Size of an array (FMI 3.0); this importer leaves it at its start value.
    StructuralParameter,
    /// Computed from parameters.
    CalculatedParameter,
    /// Set by the importer.
    Input,
    /// Result.
    Output,
    /// Internal.
    #[default]
    Local,
    /// Time.
    Independent,
}

impl fmt::Display for Causality {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Parameter => "parameter",
            Self::StructuralParameter => "structural parameter",
            Self::CalculatedParameter => "calculated parameter",
            Self::Input => "input",
            Self::Output => "output",
            Self::Local => "local",
            Self::Independent => "independent",
        })
    }
}

/// When a variable may change.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Variability {
    /// Never.
    Constant,
    /// Not after initialisation.
    Fixed,
    /// Between steps, by the importer.
    Tunable,
    /// At events.
    Discrete,
    /// Always.
    #[default]
    Continuous,
}

/// Type of a variable with its attributes. Start values: none, one (of an array: for all its values), or one for each
/// value, row by row. How wide a number is says [`Scalar`].
#[derive(Clone, Debug, PartialEq)]
pub enum VariableType {
    /// Floating point.
    Real {
        /// Unit name, its own or its declared type's.
        unit: Option<String>,
        /// Start values.
        start: Vec<f64>,
        /// Smallest value.
        min: Option<f64>,
        /// Largest value.
        max: Option<f64>,
    },
    /// Integer.
    Integer {
        /// Start values; wide enough for every integer type of FMI 3.0.
        start: Vec<i128>,
    },
    /// Boolean.
    Boolean {
        /// Start values.
        start: Vec<bool>,
    },
    /// Text.
    String {
        /// Start values.
        start: Vec<String>,
    },
    /// Enumeration.
    Enumeration {
        /// Start values.
        start: Vec<i128>,
    },
    /// Bytes (FMI 3.0).
    Binary {
        /// Start values.
        start: Vec<Vec<u8>>,
    },
    /// Clock (FMI 3.0).
    Clock,
}

impl VariableType {
    /// Number of start values.
    #[must_use]
    pub fn starts(&self) -> usize {
        match self {
            Self::Real { start, .. } => start.len(),
            Self::Integer { start } | Self::Enumeration { start } => start.len(),
            Self::Boolean { start } => start.len(),
            Self::String { start } => start.len(),
            Self::Binary { start } => start.len(),
            Self::Clock => 0,
        }
    }
}

/// Extent of an array in one direction.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Dimension {
    /// A number.
    Fixed(usize),
    /// The value of the structural parameter with this value reference.
    Parameter(u32),
}

/// Type of one value in the C interface. FMI 2.0's Real, Integer and Enumeration are `Float64` and `Int32`, FMI 3.0's
/// Enumeration is `Int64`.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[expect(missing_docs, reason = "the names of the standard")]
pub enum Scalar {
    Float64,
    Float32,
    Int8,
    UInt8,
    Int16,
    UInt16,
    Int32,
    UInt32,
    Int64,
    UInt64,
    Boolean,
    String,
    Binary,
    Clock,
}

impl Scalar {
    /// Smallest and largest value of an integer type.
    #[must_use]
    pub fn range(self) -> Option<(i128, i128)> {
        Some(match self {
            Self::Int8 => (i8::MIN.into(), i8::MAX.into()),
            Self::UInt8 => (0, u8::MAX.into()),
            Self::Int16 => (i16::MIN.into(), i16::MAX.into()),
            Self::UInt16 => (0, u16::MAX.into()),
            Self::Int32 => (i32::MIN.into(), i32::MAX.into()),
            Self::UInt32 => (0, u32::MAX.into()),
            Self::Int64 => (i64::MIN.into(), i64::MAX.into()),
            Self::UInt64 => (0, u64::MAX.into()),
            _ => return None,
        })
    }
}

impl fmt::Display for Scalar {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        // The names of the variants are those of the standard.
        fmt::Debug::fmt(self, f)
    }
}

/// One value of a variable in the C interface.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub struct Handle {
    /// The variable.
    pub value_reference: u32,
    /// Its type.
    pub scalar: Scalar,
    /// Which of its values, from 0, row by row.
    pub offset: usize,
    /// How many values it has: they travel together.
    pub count: usize,
    /// Whether the variable changes at events only.
    pub discrete: bool,
}

impl Handle {
    pub(super) fn element(variable: &Variable, offset: usize, count: usize) -> Self {
        Self {
            value_reference: variable.value_reference,
            scalar: variable.scalar,
            offset,
            count,
            discrete: variable.variability != Variability::Continuous,
        }
    }
}

impl Variable {
    /// The type as this version of the standard calls it.
    #[must_use]
    pub fn type_name(&self, version: FmiVersion) -> String {
        match (&self.kind, version) {
            (VariableType::Enumeration { .. }, _) => "Enumeration".to_owned(),
            (VariableType::Real { .. }, FmiVersion::V2) => "Real".to_owned(),
            (VariableType::Integer { .. }, FmiVersion::V2) => "Integer".to_owned(),
            _ => self.scalar.to_string(),
        }
    }

    /// Start values as numbers, booleans as 0 and 1: what stands in the elements of an array that nobody sets.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "whole numbers beyond 2^53 do not travel as f64 anyway")]
    pub fn numeric_start(&self) -> Vec<f64> {
        match &self.kind {
            VariableType::Real { start, .. } => start.clone(),
            VariableType::Integer { start } | VariableType::Enumeration { start } => {
                start.iter().map(|v| *v as f64).collect()
            }
            VariableType::Boolean { start } => start.iter().map(|v| f64::from(u8::from(*v))).collect(),
            VariableType::String { .. } | VariableType::Binary { .. } | VariableType::Clock => Vec::new(),
        }
    }
}
