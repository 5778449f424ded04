//! Walks to harm after a stop that restarts by itself. Mostly it is enough to go there and stay: the robot comes. Else the sensors have to
//! report what led to it, so walks are drawn at random, and those are run on which the FMU is told most nearly that.

use super::behaviours::Few;
use super::seek::{Drawn, Place, Seek};
use super::show::shown_by;
use super::walk_in::WalkIn;
use crate::hazard::Finding;
use crate::human::{Action, Posture, Walk};
use crate::search::Rng;
use crate::sim::anywhere::Harm;

/// Walks that are drawn, at most, and that are run: those to wait at the end of, and those that follow a history.
const MOST_DRAWN: usize = 20_000;
const MOST_WAITING: usize = 24;
const MOST_RUN: usize = 60;
/// Those that are no more than so many steps off are run.
const MOST_OFF: usize = 30;
/// Somebody waits for so many actions at most.
const WAITS: usize = 60;
/// Straight ways of a walk, actions on each, and actions of standing still between two.
const MOST_WAYS: usize = 4;
const MOST_FORWARD: usize = 12;
const MOST_STOPS: usize = 6;
const TURNS: [Drawn; 4] = [(Walk::Left45, 1), (Walk::Right45, -1), (Walk::Left90, 2), (Walk::Right90, -2)];

/// Twice one of these leads back.
const BACK: [Drawn; 2] = [TURNS[2], TURNS[3]];

/// What the FMU is told, by number, and for how many steps each.
type Reported = Vec<(usize, usize)>;

/// Draws walks to harms on one way.
pub(super) struct Guided<'a> {
    pub seek: Seek<'a>,
    pub few: &'a Few,
    pub way: usize,
    /// So many steps after the start of the FMU they begin at most.
    pub until: usize,
}

impl Guided<'_> {
    /// The first walk that shows harm. The same seed draws the same.
    pub fn walk(&self, harms: &[Harm], seed: u64) -> Option<(Harm, WalkIn, Finding)> {
        let mut rng = Rng::new(seed);
        let mut waiting: Vec<(Harm, WalkIn)> = Vec::new();
        let mut following: Vec<(usize, Harm, WalkIn)> = Vec::new();
        for _ in 0..if harms.is_empty() { 0 } else { MOST_DRAWN } {
            if self.seek.prepared.stop().is_due() {
                break;
            }
            let harm = harms[rng.below(harms.len())];
            let Some((way, places)) = self.seek.ending(&harm, &actions(&mut rng), &mut rng) else { continue };
            if waiting.len() < MOST_WAITING {
                waiting.push((harm, self.and_waits(&harm, way.clone(), &mut rng)));
            }
            following.extend(self.off(&harm, &places).map(|(off, lead_in)| (off, harm, WalkIn { lead_in, ..way })));
        }
        following.sort_by_key(|(off, ..)| *off);
        let following = following.into_iter().take(MOST_RUN).map(|(_, harm, way)| (harm, way));
        let shown = |(harm, mut way): (Harm, WalkIn)| {
            let finding = shown_by(self.seek.prepared, &way, None)?;
            // What they did until then.
            way.actions.truncate(finding.step.div_ceil(self.seek.prepared.cell.steps_per_action).max(1));
            Some((harm, way, finding))
        };
        waiting.into_iter().chain(following).find_map(shown)
    }

    /// The same, begun at some moment, and then they stay.
    fn and_waits(&self, harm: &Harm, mut way: WalkIn, rng: &mut Rng) -> WalkIn {
        way.lead_in = rng.below(self.until);
        way.actions.extend(vec![Action::new(Walk::Stop, harm.posture); WAITS]);
        way
    }

    /// By how many steps what is reported on a walk is off from what leads to a harm, and when it has to begin for that.
    fn off(&self, harm: &Harm, places: &[Place]) -> Option<(usize, usize)> {
        let Seek { search, history, .. } = self.seek;
        let reports =
            |(xy_m, heading_rad): &Place| self.few.told(&search.reports(*xy_m, *heading_rad, Posture::Upright));
        // Nothing is sampled any more where the harm is.
        let walked: Option<Vec<usize>> = places[..places.len() - 1].iter().map(reports).collect();
        let walked = merged(walked?.into_iter().map(|told| (told, 1)));
        let last = walked.last().map_or(0, |(_, steps)| *steps);
        let told = self.few.history(history.seen[harm.instant].came?, self.way, last.saturating_sub(1));
        let told = merged(told.into_iter());
        if told.len() != walked.len() || told.iter().zip(&walked).any(|((told, _), (walked, _))| told != walked) {
            return None;
        }
        let off = told.iter().zip(&walked).skip(1).map(|((_, told), (_, walked))| told.abs_diff(*walked)).sum();
        let steps: usize = told.iter().map(|(_, steps)| steps).sum();
        let lead_in = steps.checked_sub(places.len() - 1)?;
        (off <= MOST_OFF).then_some((off, lead_in))
    }
}

/// Straight ways with turns or stops between them.
fn actions(rng: &mut Rng) -> Vec<Drawn> {
    let mut all = Vec::new();
    for number in 0..=rng.below(MOST_WAYS) {
        if number > 0 {
            match rng.below(TURNS.len() + BACK.len() + 1) {
                turn if turn < TURNS.len() => all.push(TURNS[turn]),
                back if back < TURNS.len() + BACK.len() => all.extend([BACK[back - TURNS.len()]; 2]),
                _ => all.extend(vec![(Walk::Stop, 0); 1 + rng.below(MOST_STOPS)]),
            }
        }
        all.extend(vec![(Walk::Forward, 0); rng.below(MOST_FORWARD + 1)]);
    }
    if all.is_empty() {
        all.push((Walk::Stop, 0));
    }
    all
}

/// The same one after the other as one.
fn merged(told: impl Iterator<Item = (usize, usize)>) -> Reported {
    let mut all = Reported::new();
    for (told, steps) in told {
        match all.last_mut() {
            Some((known, known_steps)) if *known == told => *known_steps += steps,
            _ => all.push((told, steps)),
        }
    }
    all
}
