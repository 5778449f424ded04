//! How much of the robots' cycle a search from the start meets: the FMU is watched while the person stands at the start.

use std::ops::ControlFlow;
use std::sync::Arc;

use super::cycle::{LONGEST_WATCHED_S, STILL_M, cycle, path_m, points};
use super::hosting::StateChoice;
use super::options::Progress;
use super::prepare::Prepared;
use super::stop_time;
use crate::geometry::Vec3;
use crate::host::{PlantError, Policy};
use crate::human::action::ACTION_S;
use crate::human::{Action, Posture, Walk};
use crate::record::share::CycleShare;
use crate::sim::{Options, Simulation};

/// The first window that is looked at, s; the next is twice as long.
const FIRST_S: f64 = 8.0;

/// Most communication steps of the run, whatever they cost: 64 s of steps of 20 ms.
const MOST_STEPS: usize = 3200;

/// How much of the robots' cycle a search from the start of this cell meets; nothing if it was told to end, or the FMU cannot be started.
///
/// It takes a run of its own of 3200 communication steps at most, fewer where the robots repeat themselves sooner.
#[must_use]
pub(super) fn share(prepared: &Prepared, tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>) -> Option<CycleShare> {
    let stop = prepared.stop();
    if stop.ends_search() {
        return None;
    }
    // It must not take the time of what follows the search.
    stop.searching();
    let share = watch(prepared, tell);
    stop.finishing();
    share
}

fn watch(prepared: &Prepared, tell: &mut dyn FnMut(Progress<'_>) -> ControlFlow<()>) -> Option<CycleShare> {
    let cell = &prepared.cell;
    #[expect(clippy::cast_precision_loss, reason = "an hour of small steps")]
    let from_s = cell.lead_in_steps() as f64 * cell.step_s;
    let until_s = from_s + f64::from(cell.search.actions) * ACTION_S;
    let mut share = CycleShare { cycle_s: None, repeats_from_s: None, from_s, until_s, watched_s: 0.0, moves: false };
    // What is known of states stays, so that a longer window goes on where the last one ended.
    let options = Options { policy: Policy::States { max_checkpoints: 0 }, posture_sweep: false };
    let plant = prepared.plant(StateChoice::Replay);
    let mut simulation =
        Simulation::new(Arc::clone(&prepared.cell), Arc::clone(&prepared.binding), plant, options).ok()?;
    let most = stop_time::run_s(cell, &prepared.fmus, LONGEST_WATCHED_S).min(LONGEST_WATCHED_S);
    let most = actions(most).min(MOST_STEPS / cell.steps_per_action).max(1);
    let mut watched = actions(FIRST_S).min(most);
    loop {
        if prepared.stop().is_due() || tell(Progress::Working).is_break() {
            return None;
        }
        match robots(&mut simulation, watched) {
            Ok(instants) => {
                #[expect(clippy::cast_precision_loss, reason = "some hundred actions")]
                let watched_s = watched as f64 * ACTION_S;
                (share.watched_s, share.moves) = (watched_s, path_m(&instants) >= STILL_M);
                if let Some(found) = cycle(&instants) {
                    #[expect(clippy::cast_precision_loss, reason = "some thousand steps")]
                    let from = found.from as f64;
                    share.cycle_s = Some(found.steps * cell.step_s);
                    share.repeats_from_s = Some(from_s + from * cell.step_s);
                    return Some(share);
                }
            }
            Err(error) if error.stopped => return None,
            // What was seen until then stands.
            Err(_) => return Some(share),
        }
        if watched == most {
            return Some(share);
        }
        watched = (2 * watched).min(most);
    }
}

/// Where the robots are at each step while somebody stands there for so many actions.
fn robots<P: crate::host::Plant>(simulation: &mut Simulation<P>, actions: usize) -> Result<Vec<Vec<Vec3>>, PlantError> {
    let still = Action::new(Walk::Stop, Posture::Upright);
    let watched = simulation.watch(&vec![still; actions], &[])?;
    Ok(watched.instants.iter().map(|instant| points(&instant.frame)).collect())
}

/// So many actions take this time, s, or a little less.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a minute of actions")]
fn actions(time_s: f64) -> usize {
    (time_s / ACTION_S + 1e-9).floor().max(1.0) as usize
}
