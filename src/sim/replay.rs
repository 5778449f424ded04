//! One action sequence from a fresh instance, with no saved state: what a finding must survive to count as confirmed.

use std::sync::Arc;

use super::simulation::Watched;
use super::{Options, Simulation};
use crate::cell::{Binding, Workcell};
use crate::hazard::Finding;
use crate::host::{Plant, PlantError, Policy};
use crate::human::{Action, Who};
use crate::search::{End, Environment as _};

/// Runs `actions` and returns the unsafe contact they lead to, if any; of two people that of `who`, or of either.
///
/// # Errors
/// When the FMU cannot be started, or cannot finish an action, or a run in which a plane tells of an arm, and nothing was
/// found: what would come then is not known.
pub fn replay<P: Plant>(
    cell: Arc<Workcell>,
    binding: Arc<Binding>,
    plant: P,
    actions: &[Action],
    who: Option<Who>,
) -> Result<Option<Finding>, PlantError> {
    Ok(replay_watched(cell, binding, plant, actions, who)?.0)
}

/// The same, and for how long before the contact each sensor had reported the person without a break, s; none for those that
/// do not report them at the contact.
///
/// # Errors
/// As [`replay`].
pub fn replay_watched<P: Plant>(
    cell: Arc<Workcell>,
    binding: Arc<Binding>,
    plant: P,
    actions: &[Action],
    who: Option<Who>,
) -> Result<(Option<Finding>, Vec<Option<f64>>), PlantError> {
    let options = Options { policy: Policy::Replay, posture_sweep: false };
    let mut simulation = Simulation::new(cell, binding, plant, options)?;
    simulation.reset()?;
    let mut end = None;
    for action in actions {
        end = simulation.take(*action)?.end;
        if end.is_some() {
            break;
        }
    }
    // What was found before it is known all the same.
    let not_evaluated = end == Some(End::NotEvaluated) || !simulation.is_evaluated();
    let mut found = simulation.take_findings();
    found.retain(|finding| who.is_none_or(|who| finding.who == who));
    // Of those in the last action the worst, where several people are hit at once.
    let last = found.last().map(|finding| finding.actions.len());
    found.retain(|finding| Some(finding.actions.len()) == last);
    match found.into_iter().reduce(|a, b| if a.contact.ratio() > b.contact.ratio() { a } else { b }) {
        None if not_evaluated => Err(simulation.not_evaluated()),
        None => Ok((None, Vec::new())),
        Some(found) => {
            // What the FMU did is known by now: nothing is stepped again.
            let reported = simulation.watch(actions, &[]).map(|watched| reported(&simulation, &watched, &found));
            Ok((Some(found), reported.unwrap_or_default()))
        }
    }
}

/// For how long before the contact each sensor had reported the person, s.
fn reported<P: Plant>(simulation: &Simulation<P>, watched: &Watched, found: &Finding) -> Vec<Option<f64>> {
    let world = simulation.world();
    let since = |sensor: usize| {
        if let Some(through) = found.through.iter().find(|through| through.sensor == sensor) {
            // A plane tells of the arm, which is in no sample of the body.
            return Some(through.since_s);
        }
        let reports = |step: &usize| watched.instants.get(*step).is_some_and(|instant| instant.readings[sensor]);
        let first = (0..=found.step).rev().take_while(reports).last()?;
        // The FMU is told at the start of a step what its end shows; of its own sensors it tells at the end.
        let told = !world.binding.sensors[sensor].is_evaluated();
        #[expect(clippy::cast_precision_loss, reason = "a few steps")]
        let steps = (found.step - first.saturating_sub(usize::from(told))) as f64;
        Some(steps * world.cell.step_s)
    };
    (0..world.cell.sensors.len()).map(|sensor| since(sensor).filter(|_| found.sensors[sensor])).collect()
}
