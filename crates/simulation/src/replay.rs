//! One action sequence from a fresh instance, with no saved state: what a finding must survive to count as confirmed.

use std::sync::Arc;

use super::simulation::RecordedRun;
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
    Ok(replay_watched(cell, binding, plant, actions, &Wanted { who, like: &|_| false })?.found)
}

/// What is wanted of the contacts that a sequence leads to.
pub struct Wanted<'a> {
    /// Of two people that of this one; nothing for either.
    pub who: Option<Who>,
    /// Of several in the last action one of which this is true; else the worst.
    pub like: &'a dyn Fn(&Finding) -> bool,
}

/// What a sequence leads to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Replayed {
    /// The unsafe contact, if there is one.
    pub found: Option<Finding>,
    /// For how long before it each sensor had reported the person without a break, s; none for those that do not report them at the
    /// contact.
    pub reported_s: Vec<Option<f64>>,
    /// The first hazard by contact of the sequence, if that came before it.
    pub first: Option<Finding>,
}

/// The same of what is wanted, and what goes with it.
///
/// # Errors
/// As [`replay`].
pub fn replay_watched<P: Plant>(
    cell: Arc<Workcell>,
    binding: Arc<Binding>,
    plant: P,
    actions: &[Action],
    wanted: &Wanted<'_>,
) -> Result<Replayed, PlantError> {
    let options = Options { policy: Policy::Replay, posture_sweep: false };
    let mut simulation = Simulation::new(cell, binding, plant, options)?;
    simulation.reset()?;
    let mut end = None;
    for action in actions {
        end = simulation.take(*action)?.end;
        // Behind a hazard by contact clamping is looked for.
        let goes_on = end == Some(End::Unsafe) && simulation.goes_on();
        if end.is_some() && !goes_on {
            break;
        }
    }
    // What was found before it is known all the same.
    let not_evaluated = end == Some(End::NotEvaluated) || !simulation.is_evaluated();
    let mut found = simulation.take_findings();
    let first = found.iter().find(|finding| finding.class.ends()).cloned();
    found.extend(simulation.take_behind());
    found.retain(|finding| wanted.who.is_none_or(|who| finding.who == who));
    // Of those in the last action the worst, where there are several.
    let last = found.iter().map(|finding| finding.actions.len()).max();
    found.retain(|finding| Some(finding.actions.len()) == last);
    let like = found.iter().find(|finding| (wanted.like)(finding)).cloned();
    let worst = found.into_iter().reduce(|a, b| if a.contact.ratio() > b.contact.ratio() { a } else { b });
    match like.or(worst) {
        None if not_evaluated => Err(simulation.not_evaluated()),
        None => Ok(Replayed::default()),
        Some(found) => {
            // What the FMU did is known by now: nothing is stepped again.
            let reported = simulation.watch(actions, &[]).map(|watched| reported(&simulation, &watched, &found));
            let first = first.filter(|first| first.step < found.step);
            Ok(Replayed { found: Some(found), reported_s: reported.unwrap_or_default(), first })
        }
    }
}

/// For how long before the contact each sensor had reported the person, s.
fn reported<P: Plant>(simulation: &Simulation<P>, watched: &RecordedRun, found: &Finding) -> Vec<Option<f64>> {
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
