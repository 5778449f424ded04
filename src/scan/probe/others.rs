//! Inputs that no sensor drives: what each of them does. Those that the cell file holds, and those that it leaves at their
//! start values.

use super::{Effect, Prober, Reaction};
use crate::fmi::Causality;
use crate::host::port::{PortKind, ports};
use crate::host::system::UnitPort;
use crate::host::{PlantError, SystemSetup};
use crate::scan::hosting::StateChoice;
use crate::scan::prepare::Prepared;

/// What each of these inputs does, or why that could not be tried; and the names of those that were not.
type Tried = (Vec<Result<Reaction, PlantError>>, Vec<String>);

/// Tries so many of these inputs, each in a run of `run_s` seconds in which the others are as in `inputs`. Also the names of those that are
/// neither true nor false, which are not tried; where the person is, is told by the cell and no input of its own.
pub(super) fn tried(
    prepared: &Prepared,
    inputs: &[f64],
    (run_s, most): (f64, usize),
    speeds: &dyn Fn(&[f64]) -> Vec<f64>,
) -> Result<Tried, PlantError> {
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let left = left(prepared);
    let all: Vec<&UnitPort> = binding.inputs.iter().chain(left.iter().map(|(port, _)| port)).collect();
    let inputs: Vec<f64> = inputs.iter().copied().chain(left.iter().map(|(_, start)| *start)).collect();
    let driven = |column: usize| {
        let by_sensor = binding.sensors.iter().any(|sensor| sensor.input() == Some(column));
        by_sensor || (binding.sensor_inputs..binding.inputs.len() - binding.constants.len()).contains(&column)
    };
    let name = |port: &UnitPort| match prepared.names[port.unit].as_str() {
        "" => port.port.name.clone(),
        unit => format!("{unit}:{}", port.port.name),
    };
    let own: Vec<usize> = (0..all.len()).filter(|column| !driven(*column)).collect();
    let (boolean, others): (Vec<usize>, Vec<usize>) =
        own.into_iter().partition(|&column| all[column].port.kind == PortKind::Boolean);
    let not_tried = others.into_iter().map(|column| name(all[column])).collect();
    if boolean.is_empty() {
        return Ok((Vec::new(), not_tried));
    }
    let more: Vec<UnitPort> = left.iter().map(|(port, _)| port.clone()).collect();
    let plant = |inputs: &[f64]| {
        prepared.plant_of(StateChoice::Replay, |setup| SystemSetup {
            inputs: setup.inputs.iter().chain(&more).cloned().collect(),
            initial_inputs: inputs.to_vec(),
            ..setup.clone()
        })
    };
    let prober = Prober::new(&plant, cell.step_s, run_s, speeds);
    let idle = prober.run(&inputs, None)?;
    let reactions = boolean
        .into_iter()
        .take(most)
        .map(|column| prober.reaction(&name(all[column]), &inputs, (column, 1.0 - inputs[column]), &idle));
    Ok((reactions.collect(), not_tried))
}

/// What is odd about an input that is held: with its other value the robots are faster.
pub(super) fn held_back(reaction: &Reaction) -> Option<String> {
    let Reaction { input, idle, mean_speed: [before, after], .. } = reaction;
    let how = match reaction.effect {
        Effect::Starts => "move".to_owned(),
        Effect::SpeedsUp => format!("are {:.1} times as fast", after / before),
        Effect::Stops | Effect::Slows | Effect::Changes | Effect::Nothing => return None,
    };
    Some(format!(
        "input `{input}` is {idle} all the time, and robots {how} when it is {}: what they do to people then is not looked at. If it is \
         not {idle} all the time in the cell, change it in [inputs]",
        !idle
    ))
}

/// Inputs that neither the cell nor a connection drives, with their start values.
fn left(prepared: &Prepared) -> Vec<(UnitPort, f64)> {
    let binding = &prepared.binding;
    let mirrored = binding.mirrors.iter().map(|(_, port)| port);
    let connected = binding.connections.iter().map(|connection| &connection.to);
    let taken: Vec<&UnitPort> = binding.inputs.iter().chain(mirrored).chain(connected).collect();
    let is_taken =
        |unit: usize, port: &UnitPort| taken.iter().any(|t| t.unit == unit && t.port.handle == port.port.handle);
    let mut left = Vec::new();
    for (unit, fmu) in prepared.fmus.iter().enumerate() {
        let description = fmu.description();
        for variable in description.variables.iter().filter(|variable| variable.causality == Causality::Input) {
            let all = ports(description, variable).into_iter().map(|(port, start)| (UnitPort { unit, port }, start));
            left.extend(all.filter(|(port, _)| !is_taken(unit, port)));
        }
    }
    left
}
