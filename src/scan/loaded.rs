//! FMUs loaded and self-tested, with all their outputs.

use std::time::Duration;

use super::hosting::{Hosting, Source};
use super::prepare_error::PrepareError;
use super::stop_time::earliest;
use crate::fmi::{Causality, Fmu, number};
use crate::host::activity::Activity;
use crate::host::isolation::{Examination, Launcher, Unpacked, affordable, examine};
use crate::host::port::changing;
use crate::host::selftest::{SelfTest, Stage, selftest};
use crate::host::{PlantError, SystemSetup, UnitPort};

/// Most outputs that a cell does not bind and the self-test compares all the same.
const MOST_WATCHED: usize = 1000;

/// Numbers that the FMUs give and nobody asked for.
pub(super) fn unbound(fmus: &[Fmu], setup: &SystemSetup) -> Vec<UnitPort> {
    let outputs = fmus.iter().enumerate().flat_map(|(unit, fmu)| {
        let all = changing(fmu.description(), Causality::Output);
        all.into_iter().map(move |port| UnitPort { unit, port })
    });
    let bound = |p: &UnitPort| setup.outputs.iter().any(|o| o.unit == p.unit && o.port.handle == p.port.handle);
    outputs.filter(|port| !bound(port)).take(MOST_WATCHED).collect()
}

/// What the self-test gave, and the FMUs loaded.
pub(super) struct Tested {
    pub self_test: SelfTest,
    pub missing_protection: Vec<String>,
    /// Of a communication step.
    pub step_time: Duration,
    pub source: Source,
}

/// Loads the FMUs and tests them.
pub(super) fn try_out(
    fmus: &[Fmu],
    hosting: &Hosting,
    setup: &SystemSetup,
    steps: usize,
) -> Result<Tested, PrepareError> {
    // Serialised states are not needed here, and bringing one back in another instance crashes some FMUs.
    let skip = [Stage::Serialize];
    match hosting {
        Hosting::InProcess(stop) => {
            let slaves = fmus.iter().map(Fmu::load).collect::<Result<Vec<_>, _>>()?;
            let result = selftest(&slaves, setup, steps, &skip, Activity::unseen());
            Ok(Tested {
                self_test: result.map_err(|error| PrepareError::FirstRun(hinted(error, fmus)))?,
                missing_protection: Vec::new(),
                step_time: Duration::ZERO,
                source: Source::Here { slaves, setup: setup.clone(), stop: stop.clone() },
            })
        }
        Hosting::Workers { program, guard, limits } => {
            let unpacked = fmus.iter().map(Unpacked::of).collect();
            let launcher = Launcher::new(program.clone(), unpacked, setup.clone(), *guard, limits.clone());
            let Examination { result, launcher, missing, step_time } =
                examine(&launcher, affordable(&launcher, steps), &skip)
                    .map_err(|error| PrepareError::first_run(hinted(error, fmus)))?;
            Ok(Tested { self_test: result, missing_protection: missing, step_time, source: Source::Apart(launcher) })
        }
    }
}

/// What may have made an FMU fail.
fn hinted(error: PlantError, fmus: &[Fmu]) -> PlantError {
    let error = with_tool(error, fmus);
    match (earliest(fmus), error.time_s) {
        (Some((_, stop)), Some(time)) if time > stop - 1e-9 => {
            let message = format!("{}. It was run beyond its stopTime of {} s", error.message, number(stop));
            PlantError { message, ..error }
        }
        _ => error,
    }
}

/// An FMU that says that it needs a tool of this machine may find it outside the sandbox only.
fn with_tool(error: PlantError, fmus: &[Fmu]) -> PlantError {
    let needs =
        |fmu: &Fmu| fmu.description().co_simulation.as_ref().is_some_and(|cs| cs.capabilities.needs_execution_tool);
    if !fmus.iter().any(needs) {
        return error;
    }
    let message =
        format!("{}. It needs the tool that made it, which it may reach with --trust-fmu only", error.message);
    PlantError { message, ..error }
}
