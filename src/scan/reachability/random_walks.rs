//! Walks at random to where and when somebody may be harmed, for harms that no straight walk shows: after a stop that restarts, or past
//! sensors that the robot does not heed. They begin where no sensor at all sees anybody.

use std::f64::consts::{FRAC_PI_4, TAU};

use super::walk_in::{WalkIn, shown_by};
use crate::hazard::Finding;
use crate::human::{Action, Posture, Walk};
use crate::reachability::{Harm, History, ReachabilitySearch as Search, known};
use crate::scan::prepare::Prepared;
use crate::search::Rng;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Walks that are drawn, at most, to be run or not.
const MOST_DRAWN: usize = 20_000;
/// Most actions of a walk.
const MOST_ACTIONS: usize = 6;
/// Directions in which they may end.
const DIRECTIONS: usize = 720;

/// How somebody walks, and by how many eighths of a turn to the left that begins.
pub(super) type Drawn = (Walk, i8);

/// Where somebody is, floor plan, m, and looks, rad.
pub(super) type WalkPose = ([f64; 2], f64);

/// What is drawn of each action, with the eighths of a turn to the left that it begins with: mostly straight on.
const DRAWN: [Drawn; 10] = [
    (Walk::Forward, 0),
    (Walk::Forward, 0),
    (Walk::Forward, 0),
    (Walk::Forward, 0),
    (Walk::Forward, 0),
    (Walk::Left45, 1),
    (Walk::Right45, -1),
    (Walk::Left90, 2),
    (Walk::Right90, -2),
    (Walk::Stop, 0),
];

/// Draws walks to harms of one history.
pub(super) struct Seek<'a> {
    pub prepared: &'a Prepared,
    pub search: &'a Search<'a>,
    /// What sensors report at first.
    pub first: &'a [bool],
    pub history: &'a History,
    /// Whether walks may take longer than it is to the instant.
    pub any_time: bool,
}

impl Seek<'_> {
    /// The first walk that shows harm, of at most so many that are run; and how many were. The same seed draws the same.
    pub(crate) fn walk(&self, harms: &[Harm], most: usize, seed: u64) -> (Option<(Harm, WalkIn, Finding)>, usize) {
        let mut rng = Rng::new(seed);
        let mut run = 0;
        for _ in 0..MOST_DRAWN {
            if run == most || harms.is_empty() || self.prepared.stop().is_due() {
                break;
            }
            let harm = harms[rng.below(harms.len())];
            let drawn: Vec<Drawn> = (0..=rng.below(MOST_ACTIONS)).map(|_| DRAWN[rng.below(DRAWN.len())]).collect();
            let Some((way, _)) = self.ending(&harm, &drawn, &mut rng) else { continue };
            run += 1;
            if let Some(finding) = shown_by(self.prepared, &way, None) {
                return (Some((harm, way, finding)), run);
            }
        }
        (None, run)
    }

    /// A walk of these actions that is there in time, if there is room all the way and nobody is seen where it begins; with the places and headings after each
    /// step, the start first.
    #[expect(clippy::cast_precision_loss, reason = "some hundred")]
    pub(crate) fn ending(&self, harm: &Harm, drawn: &[Drawn], rng: &mut Rng) -> Option<(WalkIn, Vec<WalkPose>)> {
        let cell = &*self.prepared.cell;
        let (steps, length_m) = (cell.steps_per_action, WALKING_SPEED_M_S * cell.step_s);
        // In its last action it is there after so many steps.
        let reached = 1 + rng.below(steps);
        let bends = harm.posture != Posture::Upright;
        let ends = TAU * rng.below(DIRECTIONS) as f64 / DIRECTIONS as f64;
        let mut heading = if bends { harm.heading_rad } else { ends };
        let (mut at, mut places) = (harm.xy_m, vec![(harm.xy_m, heading)]);
        for (number, (walk, turn)) in drawn.iter().enumerate().rev() {
            let (sin, cos) = libm::sincos(heading);
            let taken = if number + 1 == drawn.len() { reached } else { steps };
            for _ in 0..taken {
                if *walk != Walk::Stop {
                    at = [at[0] - cos * length_m, at[1] - sin * length_m];
                }
                places.push((at, heading));
            }
            heading -= f64::from(*turn) * FRAC_PI_4;
        }
        let arrived = (drawn.len() - 1) * steps + reached;
        let lead_in = self.history.seen[harm.instant].step.checked_sub(arrived);
        let lead_in = if self.any_time { lead_in.unwrap_or(0) } else { lead_in? };
        let heading = heading.rem_euclid(TAU);
        let all = vec![true; self.first.len()];
        let begins = self.search.may_begin(at, heading, &known(self.first)) && self.search.comes_to(at, &all);
        if !begins || !places.iter().all(|(at, _)| self.search.has_room(*at)) {
            return None;
        }
        let mut actions: Vec<Action> = drawn.iter().map(|(walk, _)| Action::new(*walk, Posture::Upright)).collect();
        let last = actions.last_mut()?;
        *last = Action::new(last.walk(), harm.posture);
        places.reverse();
        Some((WalkIn { xy_m: at, heading_deg: heading.to_degrees(), lead_in, actions }, places))
    }
}
