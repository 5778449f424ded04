//! One action sequence from a fresh instance, with no saved state: what a finding must survive to count as confirmed.

use std::sync::Arc;

use super::{Options, Simulation};
use crate::cell::{Binding, Workcell};
use crate::hazard::Finding;
use crate::host::{Plant, PlantError, Policy};
use crate::human::action::Action;
use crate::search::{End, Environment as _};

/// Runs `actions` and returns the unsafe contact they lead to, if any.
///
/// # Errors
/// When the FMU cannot be started, or cannot finish an action, or a run in which a plane tells of an arm, and nothing was
/// found: what would come then is not known.
pub fn replay<P: Plant>(
    cell: Arc<Workcell>,
    binding: Arc<Binding>,
    plant: P,
    actions: &[Action],
) -> Result<Option<Finding>, PlantError> {
    let options = Options { policy: Policy::Replay, posture_sweep: false };
    let mut simulation = Simulation::new(cell, binding, plant, options)?;
    simulation.reset()?;
    for action in actions {
        match simulation.step(action.index())?.end {
            Some(End::NotEvaluated) => return Err(simulation.not_evaluated()),
            Some(_) => break,
            None => {}
        }
    }
    match simulation.take_findings().pop() {
        None if !simulation.is_evaluated() => Err(simulation.not_evaluated()),
        found => Ok(found),
    }
}
