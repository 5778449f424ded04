//! modelDescription.xml as data, in the same terms for FMI 2.0 and FMI 3.0. Reading it is in `read_xml`.

use std::collections::BTreeMap;

use super::variable::{Causality, Dimension, Handle, Scalar, Variable};
use super::version::FmiVersion;

/// The content of modelDescription.xml that matters to an importer.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ModelDescription {
    /// As written, for instance `2.0` or `3.0`.
    pub fmi_version: String,
    /// Model name.
    pub model_name: String,
    /// Identifies the export (`guid`, in FMI 3.0 `instantiationToken`); the binary checks it.
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
    /// Units that the file defines, with the factor of each to its base units: not always one that can be computed with.
    pub units: BTreeMap<String, f64>,
    pub(super) by_name: BTreeMap<String, usize>,
    /// Start values of structural parameters by value reference.
    pub(super) sizes: BTreeMap<u32, usize>,
}

/// More values than this in one variable are taken for a mistake: they would not fit into memory many times.
pub const MOST_VALUES: usize = 100_000_000;

impl ModelDescription {
    /// The variable of this name.
    #[must_use]
    pub fn variable(&self, name: &str) -> Option<&Variable> {
        self.by_name.get(name).map(|&i| &self.variables[i])
    }

    /// The version, if it is one that can be used.
    #[must_use]
    pub fn version(&self) -> Option<FmiVersion> {
        let v = self.fmi_version.as_str();
        let numbers = |rest: &str| !rest.is_empty() && rest.bytes().all(|b| b.is_ascii_digit());
        if v.starts_with("2.") {
            return Some(FmiVersion::V2);
        }
        // Pre-releases such as 3.1-beta.1 have interfaces of their own.
        (v == "3.0" || v.strip_prefix("3.0.").is_some_and(numbers)).then_some(FmiVersion::V3)
    }

    /// Extents of a variable: none for a scalar, `None` where a structural parameter is missing or too large.
    #[must_use]
    pub fn extents(&self, variable: &Variable) -> Option<Vec<usize>> {
        let extent = |d: &Dimension| match d {
            Dimension::Fixed(n) => Some(*n),
            Dimension::Parameter(reference) => self.sizes.get(reference).copied(),
        };
        variable.dimensions.iter().map(extent).collect()
    }

    /// Number of values of a variable, with the start values of structural parameters; 1 for a scalar.
    #[must_use]
    pub fn count(&self, variable: &Variable) -> Option<usize> {
        let extents = self.extents(variable)?;
        let count = extents.into_iter().try_fold(1_usize, usize::checked_mul)?;
        (count <= MOST_VALUES).then_some(count)
    }

    /// The one value that `name` means: a scalar variable of this very name, else the element `name[i]` or
    /// `name[i,j]` of an array, counted from 1. Gives the variable, the element's place among its values (row by row)
    /// and how many values the variable has.
    #[must_use]
    pub fn element(&self, name: &str) -> Option<(&Variable, usize, usize)> {
        if let Some(variable) = self.variable(name) {
            return variable.dimensions.is_empty().then_some((variable, 0, 1));
        }
        let (array, indices) = name.trim_end().strip_suffix(']')?.rsplit_once('[')?;
        let variable = self.variable(array.trim_end())?;
        let (extents, count) = (self.extents(variable)?, self.count(variable)?);
        let indices: Vec<usize> = indices.split(',').map(|i| i.trim().parse().ok()).collect::<Option<_>>()?;
        if indices.len() != extents.len() || extents.is_empty() {
            return None;
        }
        let mut offset = 0;
        for (index, extent) in indices.into_iter().zip(extents) {
            let index = index.checked_sub(1).filter(|i| *i < extent)?;
            offset = offset * extent + index;
        }
        Some((variable, offset, count))
    }

    /// What to give to a [`Plan`](super::Plan) for the value that `name` means, as in [`ModelDescription::element`].
    #[must_use]
    pub fn handle(&self, name: &str) -> Option<Handle> {
        let (variable, offset, count) = self.element(name)?;
        Some(Handle::element(variable, offset, count))
    }

    /// The values of a variable one by one, row by row, under the names that [`ModelDescription::element`] knows.
    pub fn elements<'a>(&self, variable: &'a Variable) -> impl Iterator<Item = (String, Handle)> + use<'a> {
        let (extents, count) = (self.extents(variable).unwrap_or_default(), self.count(variable).unwrap_or(0));
        (0..count).map(move |offset| {
            let mut rest = offset;
            let mut indices: Vec<String> = Vec::new();
            for extent in extents.iter().rev() {
                indices.push((rest % extent + 1).to_string());
                rest /= extent;
            }
            indices.reverse();
            let name = &variable.name;
            let name = if indices.is_empty() { name.clone() } else { format!("{name}[{}]", indices.join(",")) };
            (name, Handle::element(variable, offset, count))
        })
    }

    /// Whether inputs of this FMU have their full meaning in Event Mode only: it has clocks to be driven from outside.
    #[must_use]
    pub fn needs_event_mode(&self) -> bool {
        self.variables.iter().any(|v| v.scalar == Scalar::Clock && v.causality == Causality::Input)
    }
}

/// The co-simulation interface.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct CoSimulation {
    /// What it says it can do.
    pub capabilities: Capabilities,
}

/// Capability flags.
#[derive(Clone, Debug, Default, PartialEq)]
#[expect(clippy::struct_excessive_bools, reason = "these are the flags of the standard")]
pub struct Capabilities {
    /// Name of the binary.
    pub model_identifier: String,
    /// `canGetAndSetFMUstate` (`canGetAndSetFMUState`).
    pub can_get_and_set_state: bool,
    /// `canSerializeFMUstate` (`canSerializeFMUState`).
    pub can_serialize_state: bool,
    /// `canHandleVariableCommunicationStepSize`.
    pub can_handle_variable_step: bool,
    /// `canBeInstantiatedOnlyOncePerProcess`.
    pub once_per_process: bool,
    /// `needsExecutionTool`.
    pub needs_execution_tool: bool,
    /// `hasEventMode` (FMI 3.0).
    pub has_event_mode: bool,
    /// `mightReturnEarlyFromDoStep` (FMI 3.0).
    pub might_return_early: bool,
    /// `canReturnEarlyAfterIntermediateUpdate` (FMI 3.0).
    pub can_return_early_after_intermediate_update: bool,
    /// `providesIntermediateUpdate` (FMI 3.0).
    pub provides_intermediate_update: bool,
    /// `fixedInternalStepSize`, s (FMI 3.0).
    pub fixed_internal_step: Option<f64>,
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

impl DefaultExperiment {
    /// The stop time, s, of an experiment that takes any time at all.
    #[must_use]
    pub fn ends_s(&self) -> Option<f64> {
        self.stop_time.filter(|stop| *stop > self.start_time.unwrap_or(0.0).max(0.0))
    }

    /// How many of `wanted` steps of `step_s` seconds from time 0 end before the stop time or at it; one at least.
    #[must_use]
    pub fn steps(&self, wanted: usize, step_s: f64) -> usize {
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "saturates; neither is negative")]
        let within = |stop: f64| (stop / step_s + 1e-6).floor() as usize;
        self.ends_s().map_or(wanted, |stop| wanted.min(within(stop)).max(1))
    }
}
