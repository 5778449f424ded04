//! modelDescription.xml as data, in the terms of FMI 2.0. Reading it is in `read_xml`.

use std::collections::BTreeMap;
use std::fmt;

/// The content of modelDescription.xml that matters to an importer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelDescription {
    /// As written, for instance `2.0`.
    pub fmi_version: String,
    /// Model name.
    pub model_name: String,
    /// Identifies the export; the binary checks it.
    pub guid: String,
    /// Exporting tool.
    pub generation_tool: Option<String>,
    /// Co-simulation interface.
    pub co_simulation: Option<CoSimulation>,
    /// Whether there is a model-exchange interface.
    pub has_model_exchange: bool,
    /// Variables in the order of the file.
    pub variables: Vec<Variable>,
    /// Suggested experiment.
    pub default_experiment: DefaultExperiment,
    pub(super) by_name: BTreeMap<String, usize>,
}

impl ModelDescription {
    /// The variable of this name.
    #[must_use]
    pub fn variable(&self, name: &str) -> Option<&Variable> {
        self.by_name.get(name).map(|&i| &self.variables[i])
    }
}

/// The co-simulation interface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CoSimulation {
    /// What it says it can do.
    pub capabilities: Capabilities,
}

/// Capability flags.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
#[expect(clippy::struct_excessive_bools, reason = "these are the flags of the standard")]
pub struct Capabilities {
    /// Name of the binary.
    pub model_identifier: String,
    /// `canGetAndSetFMUstate`.
    pub can_get_and_set_state: bool,
    /// `canSerializeFMUstate`.
    pub can_serialize_state: bool,
    /// `canHandleVariableCommunicationStepSize`.
    pub can_handle_variable_step: bool,
    /// `canBeInstantiatedOnlyOncePerProcess`.
    pub once_per_process: bool,
    /// `needsExecutionTool`.
    pub needs_execution_tool: bool,
}

/// Suggested experiment.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct DefaultExperiment {
    /// Start time, s.
    pub start_time: Option<f64>,
    /// Stop time, s.
    pub stop_time: Option<f64>,
    /// Step, s.
    pub step_size: Option<f64>,
}

/// A scalar variable.
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

/// Type of a variable.
#[derive(Clone, Debug, PartialEq)]
pub enum VariableType {
    /// Floating point.
    Real {
        /// Unit name, its own or its declared type's.
        unit: Option<String>,
        /// Start value.
        start: Option<f64>,
        /// Smallest value.
        min: Option<f64>,
        /// Largest value.
        max: Option<f64>,
    },
    /// Integer.
    Integer {
        /// Start value.
        start: Option<i32>,
    },
    /// Boolean.
    Boolean {
        /// Start value.
        start: Option<bool>,
    },
    /// Text.
    String {
        /// Start value.
        start: Option<String>,
    },
    /// Enumeration.
    Enumeration {
        /// Start value.
        start: Option<i32>,
    },
}
