//! What modelDescription.xml says of the model as a whole: its identity and its co-simulation interface.

use super::super::description::{Capabilities, CoSimulation};
use super::super::version::FmiVersion;
use super::attributes::Attributes;
use super::{Parser, Problem};

impl Parser {
    pub(super) fn root(&mut self, a: &mut Attributes) -> Result<(), Problem> {
        self.d.fmi_version = a.required("fmiVersion")?;
        // Other versions name other things differently: the caller says so before anything is missed.
        let Some(version) = self.d.version() else {
            a.values.clear();
            return Ok(());
        };
        self.d.model_name = a.required("modelName")?;
        self.d.guid = a.required(match version {
            FmiVersion::V2 => "guid",
            FmiVersion::V3 => "instantiationToken",
        })?;
        self.d.generation_tool = a.take("generationTool");
        for known in [
            "description",
            "author",
            "version",
            "copyright",
            "license",
            "generationDateAndTime",
            "variableNamingConvention",
            "numberOfEventIndicators",
        ] {
            a.take(known);
        }
        Ok(())
    }

    pub(super) fn co_simulation(&mut self, a: &mut Attributes) -> Result<(), Problem> {
        if self.d.co_simulation.is_some() {
            return Err(a.problem("a second co-simulation interface, an FMU has one at most"));
        }
        let model_identifier = a.required("modelIdentifier")?;
        // FMI asks for a C identifier. Hyphens and dots are met, name a file all the same, and do no harm.
        let letter = |c: char| c.is_ascii_alphanumeric() || c == '_';
        let is_name =
            model_identifier.starts_with(letter) && model_identifier.chars().all(|c| letter(c) || "-.".contains(c));
        if !is_name {
            return Err(a.problem(format_args!(
                "modelIdentifier \"{}\" could name a file outside the FMU; refused. FMI asks for a C identifier",
                model_identifier.escape_debug()
            )));
        }
        let mut flag = |name: &str| Ok::<bool, Problem>(a.boolean(name)?.unwrap_or(false));
        let mut capabilities = Capabilities {
            can_handle_variable_step: flag("canHandleVariableCommunicationStepSize")?,
            once_per_process: flag("canBeInstantiatedOnlyOncePerProcess")?,
            needs_execution_tool: flag("needsExecutionTool")?,
            model_identifier,
            ..Capabilities::default()
        };
        let known: &[&str] = match self.d.version() {
            Some(FmiVersion::V3) => {
                capabilities.can_get_and_set_state = flag("canGetAndSetFMUState")?;
                capabilities.can_serialize_state = flag("canSerializeFMUState")?;
                capabilities.has_event_mode = flag("hasEventMode")?;
                capabilities.might_return_early = flag("mightReturnEarlyFromDoStep")?;
                capabilities.can_return_early_after_intermediate_update =
                    flag("canReturnEarlyAfterIntermediateUpdate")?;
                capabilities.provides_intermediate_update = flag("providesIntermediateUpdate")?;
                capabilities.fixed_internal_step = a.number("fixedInternalStepSize")?;
                &[
                    "maxOutputDerivativeOrder",
                    "recommendedIntermediateInputSmoothness",
                    "providesDirectionalDerivatives",
                    "providesAdjointDerivatives",
                    "providesPerElementDependencies",
                    "providesEvaluateDiscreteStates",
                ]
            }
            _ => {
                capabilities.can_get_and_set_state = flag("canGetAndSetFMUstate")?;
                capabilities.can_serialize_state = flag("canSerializeFMUstate")?;
                &[
                    "canInterpolateInputs",
                    "maxOutputDerivativeOrder",
                    "canRunAsynchronuously",
                    "canNotUseMemoryManagementFunctions",
                    "providesDirectionalDerivative",
                ]
            }
        };
        for name in known {
            a.take(name);
        }
        if capabilities.needs_execution_tool {
            let message = "the FMU needs the tool that made it (needsExecutionTool): it runs only where that tool is \
                           installed and licensed";
            self.warn(a.offset, message.to_owned());
        }
        self.d.co_simulation = Some(CoSimulation { capabilities });
        Ok(())
    }
}
