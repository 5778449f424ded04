//! How far links go on after a contact, where the cell names the FMU input that tells the robots of one: found by running the FMU
//! with nobody there and setting that input at many moments.

use std::sync::Arc;

use crate::cell::Workcell;
use crate::cell::binding::Binding;
use crate::hazard::STANDSTILL_M_S;
use crate::host::{Plant, PlantError};
use crate::sim::World;
use crate::sim::robot::RobotFrame;

/// How long the FMU is run at most before the contact, and how long after it, s.
pub(super) const RUN_S: f64 = 10.0;
const WAIT_S: f64 = 5.0;

/// Moments are so far apart, s.
const APART_S: f64 = 0.1;

/// For each link how far it goes on, m, at the worst of the moments until `until_s`; nothing if the robots do not stand after some of
/// them. `plant` opens the FMU with its first inputs.
///
/// # Errors
/// When the FMU fails.
pub(super) fn travel_after_contact<P: Plant>(
    (cell, binding): (&Arc<Workcell>, &Arc<Binding>),
    signal: &str,
    until_s: f64,
    plant: impl FnOnce(&[f64]) -> P,
) -> Result<Option<Vec<f64>>, PlantError> {
    let Some((column, value)) = binding.command(cell, signal) else {
        return Err(PlantError::of(format!("`{signal}` is no input of the FMU")));
    };
    let world = World::new(Arc::clone(cell), Arc::clone(binding));
    let idle = world.initial_inputs();
    let mut touched = idle.clone();
    touched[column] = value;
    let steps = |seconds: f64| {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            reason = "seconds over steps of milliseconds"
        )]
        let steps = (seconds / cell.step_s).round() as usize;
        steps
    };
    let until = steps(until_s);
    let mut plant = plant(&idle);
    let mut worst_m = vec![0.0_f64; cell.links.len()];
    for at in (0..until).step_by(steps(APART_S).max(1)) {
        let mut rows = plant.restart()?;
        if at > 0 {
            rows = plant.advance(at, &idle.repeat(at))?;
        }
        let width = binding.outputs.len();
        let before = rows[rows.len() - width..].to_vec();
        let wait = steps(WAIT_S);
        let after = plant.advance(wait, &touched.repeat(wait))?;
        let derived = binding.rows(&after, Some(&before), cell.step_s);
        let frames: Vec<RobotFrame> =
            derived.chunks(binding.columns()).map(|row| RobotFrame::new(cell, binding, row)).collect();
        let moving = frames.iter().rposition(|frame| frame.fastest > STANDSTILL_M_S).map_or(0, |last| last + 1);
        if moving == frames.len() {
            return Ok(None);
        }
        let mut travel_m = vec![0.0; cell.links.len()];
        for frame in &frames[..moving] {
            let links = travel_m.iter_mut().zip(&frame.speed_bounds);
            links.for_each(|(travel, speed)| *travel += speed * cell.step_s);
        }
        worst_m.iter_mut().zip(travel_m).for_each(|(worst, travel)| *worst = worst.max(travel));
    }
    Ok(Some(worst_m))
}
