//! What there is to tell about a hazard, gathered from its cell and from its sequence once more.

use super::prepare::Prepared;
use super::replay::contact_frame;
use super::settings;
use crate::geometry::polygon::{contains, distance_to_edge};
use crate::human::action::ACTION_S;
use crate::record::hazard::Hazard;
use crate::report::explanation::{Explanation, Outside, Reports, Robot};
use crate::sim::simulation::RecordedRun;

/// The explanation of `hazard`, whose sequence was watched, without remedies; nothing if the cell has no such link.
#[must_use]
pub(crate) fn explain(prepared: &Prepared, hazard: &Hazard, watched: &RecordedRun) -> Option<Explanation> {
    let cell = &prepared.cell;
    let link = cell.links.iter().find(|link| link.name == hazard.robot_link)?;
    let robot = &cell.robots[link.robot];
    let until = &watched.instants[..=contact_frame(prepared, hazard, watched)];
    let reports = |(number, sensor): (usize, &crate::cell::Sensor)| {
        let mut reported = false;
        let mut changes_s = Vec::new();
        for (frame, instant) in until.iter().enumerate() {
            if instant.readings[number] != reported {
                reported = !reported;
                // The FMU is told at the start of a step what its end shows; of its own sensors it tells at the end.
                let told = !prepared.binding.sensors[number].is_evaluated();
                #[expect(clippy::cast_precision_loss, reason = "a few steps after the start")]
                changes_s.push(frame.saturating_sub(usize::from(told)) as f64 * cell.step_s);
            }
        }
        Reports { name: sensor.name.clone(), changes_s }
    };
    Some(Explanation {
        hazard: hazard.clone(),
        start: (cell.start.xy_m(), cell.start.heading_deg()),
        second: settings::second(cell),
        begins_s: cell.begins_s(),
        action_s: ACTION_S,
        sensors: cell.sensors.iter().enumerate().map(reports).collect(),
        outside: outside(prepared, hazard, &until[until.len() - 1].readings).collect(),
        robot: Robot {
            name: robot.name.clone(),
            moving_mass_kg: robot.moving_mass_kg,
            mass_from: prepared.shown(&robot.mass_place),
        },
        remedies: Vec::new(),
    })
}

/// How far the person stands outside of the zones of sensors that report nobody at the contact.
pub(super) fn outside(prepared: &Prepared, hazard: &Hazard, readings: &[bool]) -> impl Iterator<Item = Outside> {
    prepared.cell.sensors.iter().zip(readings).filter_map(|(sensor, &reports)| {
        let polygon = sensor.zone.stepped_on()?;
        let is_outside = !reports && !contains(polygon, hazard.person_xy_m);
        let distance_m = distance_to_edge(polygon, hazard.person_xy_m);
        is_outside.then(|| Outside { name: sensor.name.clone(), distance_m })
    })
}
