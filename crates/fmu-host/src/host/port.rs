//! A bound FMU variable as the host sees it: one value of it and a type. All values travel as `f64`.

use serde::{Deserialize, Serialize};

use crate::fmi::{Causality, Handle, ModelDescription, Scalar, Variability, Variable};

/// Type of a bound variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum PortKind {
    /// Floating point.
    Real,
    /// Integer or enumeration.
    Integer,
    /// Boolean, as 0 and 1.
    Boolean,
}

impl PortKind {
    /// What a type of the C interface is to the host; nothing if it is no number.
    #[must_use]
    pub(crate) const fn of(scalar: Scalar) -> Option<Self> {
        Some(match scalar {
            Scalar::Float64 | Scalar::Float32 => Self::Real,
            Scalar::Int8
            | Scalar::UInt8
            | Scalar::Int16
            | Scalar::UInt16
            | Scalar::Int32
            | Scalar::UInt32
            | Scalar::Int64
            | Scalar::UInt64 => Self::Integer,
            Scalar::Boolean => Self::Boolean,
            Scalar::String | Scalar::Binary | Scalar::Clock => return None,
        })
    }
}

/// A bound FMU variable, or an element of one.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize)]
pub struct Port {
    /// Name, for messages.
    pub name: String,
    /// Which value of the FMU.
    pub handle: Handle,
    /// Type.
    pub kind: PortKind,
    /// Start value, where modelDescription.xml has one, else 0.
    pub start: f64,
}

impl Port {
    /// A port to this value with its start value, if it is a number.
    #[must_use]
    pub fn new(name: String, handle: Handle, start: f64) -> Option<Self> {
        Some(Self { name, handle, kind: PortKind::of(handle.scalar)?, start })
    }
}

/// Elements of one array that take part: the first of a large one stand for the rest.
const ELEMENTS: usize = 64;

/// The numbers of a variable, each with its start value.
#[must_use]
pub fn ports(description: &ModelDescription, variable: &Variable) -> Vec<(Port, f64)> {
    let start = variable.numeric_start();
    let of = |i: usize| start.get(i).or(start.first()).copied().unwrap_or(0.0);
    let elements = description.elements(variable).take(ELEMENTS).enumerate();
    elements.filter_map(|(i, (name, handle))| Some((Port::new(name, handle, of(i))?, of(i)))).collect()
}

/// All changing numbers of this causality.
#[must_use]
pub fn changing(description: &ModelDescription, causality: Causality) -> Vec<Port> {
    let changes = |v: &&Variable| !matches!(v.variability, Variability::Constant | Variability::Fixed);
    let variables = description.variables.iter().filter(|v| v.causality == causality).filter(changes);
    variables.flat_map(|v| ports(description, v)).map(|(port, _)| port).collect()
}
