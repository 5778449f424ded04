//! A hazard is confirmed when a fresh instance of the FMU, without any restore, gives the same contact: its worst sequence and its
//! shortest; the same run shows what led to the contact.

use std::sync::Arc;

use super::prepare::Prepared;
use super::settings;
use crate::hazard::{Finding, Group};
use crate::host::{Hosted, PlantError, Policy};
use crate::human::Action;
use crate::record::hazard::{FirstContact, Hazard};
use crate::record::operated::OperatedControl;
use crate::sim::replay::{Replayed, Wanted, replay_watched};
use crate::sim::{Options, Simulation, World};

/// Runs the sequences of `group` plainly, and puts what they show into the record of it. Why a run could not be made, if not because
/// there was no time, is put into `not_run`.
pub(super) fn confirm(
    prepared: &Prepared,
    plain: &mut Hosted,
    group: &Group,
    hazard: &mut Hazard,
    not_run: &mut Option<PlantError>,
) {
    let cell = &prepared.cell;
    hazard.worked = worked(prepared, plain, &hazard.actions);
    hazard.name_obstacles(|number| cell.obstacles[number].name.clone());
    let (confirmed, again) = reproduced(prepared, plain, &group.worst, not_run);
    hazard.confirmed = confirmed;
    let links: Vec<String> = cell.links.iter().map(|link| link.name.clone()).collect();
    hazard.first_contact = again.first.map(|first| FirstContact::of(&first, &links, cell.names()));
    for (sensor, since_s) in hazard.sensors.iter_mut().zip(again.reported_s) {
        sensor.since_s = since_s;
    }
    hazard.shortest.confirmed = match group.shortest == group.worst {
        true => confirmed,
        false => reproduced(prepared, plain, &group.shortest, not_run).0,
    };
}

/// What is really worked in a sequence: not where a hand presses into the air.
fn worked(prepared: &Prepared, plant: &mut Hosted, actions: &[Action]) -> Vec<OperatedControl> {
    if prepared.cell.following.is_empty() || actions.iter().all(|action| action.presses().is_none()) {
        return worked_alone(prepared, actions);
    }
    // Where people get to, the FMU has a say in.
    let options = Options { policy: Policy::Replay, posture_sweep: false };
    let (cell, binding) = (Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
    let watched = Simulation::new(cell, binding, plant, options).and_then(|mut s| s.watch(actions, &[]));
    let worked = watched.map(|watched| watched.worked).unwrap_or_default();
    OperatedControl::all(worked, &settings::controls(&prepared.cell), prepared.cell.second.is_some())
}

/// The same where nothing follows the FMU.
pub(super) fn worked_alone(prepared: &Prepared, actions: &[Action]) -> Vec<OperatedControl> {
    if actions.iter().all(|action| action.presses().is_none()) {
        return Vec::new();
    }
    let world = World::new(Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
    let mut places = world.starts();
    let presses = actions.iter().map(|action| {
        let action = world.taken_by_all(&places, *action);
        let walks = world.walks(places, action);
        places = walks.ends();
        world.worked_by(&walks.starts(), action).presses
    });
    OperatedControl::all(presses, &settings::controls(&prepared.cell), prepared.cell.second.is_some())
}

/// Whether a fresh instance without any restore gives the same contact to the last bit, and what goes with it; nothing if there was no time to see, or the FMU does not begin any more: why is put into
/// `not_run`.
fn reproduced(
    prepared: &Prepared,
    plant: &mut Hosted,
    finding: &Finding,
    not_run: &mut Option<PlantError>,
) -> (Option<bool>, Replayed) {
    let (cell, binding) = (Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
    let wanted = Wanted { who: Some(finding.who), like: &|found| found == finding };
    match replay_watched(cell, binding, plant, &finding.actions, &wanted) {
        Ok(again) => match again.found.as_ref() == Some(finding) {
            true => (Some(true), again),
            false => (Some(false), Replayed::default()),
        },
        Err(error) if error.tried_nothing() => {
            if !error.stopped {
                not_run.get_or_insert(error);
            }
            (None, Replayed::default())
        }
        Err(_) => (Some(false), Replayed::default()),
    }
}
