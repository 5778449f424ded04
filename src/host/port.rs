//! A bound FMU variable as the host sees it: a value reference and a type. All values travel as `f64`.

/// Type of a bound variable.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum PortKind {
    /// Floating point.
    Real,
    /// Integer or enumeration.
    Integer,
    /// Boolean, as 0 and 1.
    Boolean,
}

/// A bound FMU variable.
#[derive(Clone, Debug, PartialEq)]
pub struct Port {
    /// Name, for messages.
    pub name: String,
    /// Value reference.
    pub value_reference: u32,
    /// Type.
    pub kind: PortKind,
    /// Start value, where modelDescription.xml has one, else 0.
    pub start: f64,
}
