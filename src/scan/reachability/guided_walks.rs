//! Walks to harm after a stop that restarts by itself. Mostly it is enough to go there and stay: the robot comes. What takes several
//! entries mostly does not depend on how long each of them lasts: walks that come and go some times before they stay are run as well.
//! Else the sensors have to report what led to it: where that is known of behaviours, of walks drawn at random those are run on which the
//! FMU is told most nearly that.

use super::behaviours::Few;
use super::random_walks::{Drawn, Seek, WalkPose};
use super::walk_in::{WalkIn, shown_by};
use crate::hazard::Finding;
use crate::human::{Action, Posture, Walk};
use crate::reachability::Harm;
use crate::reachability::reading_regions::Readings;
use crate::search::Rng;

/// Walks that are drawn, at most, and that are run: those to wait at the end of, those that follow a history, and those that come and go.
const MOST_DRAWN: usize = 20_000;
const MOST_WAITING: usize = 24;
const MOST_RUN: usize = 60;
const MOST_COMING: usize = 120;
/// What is reported changes so often at least where somebody comes and goes.
const LEAST_CHANGES: usize = 3;
/// Those that are no more than so many steps off are run.
const MOST_OFF: usize = 30;
/// Somebody waits for so many actions at most.
const WAITS: usize = 60;
/// Straight ways of a walk, actions on each, and actions of standing still between two.
const MOST_WAYS: usize = 4;
const MOST_FORWARD: usize = 12;
const MOST_STOPS: usize = 6;
/// How often somebody comes and goes on a walk, and most actions straight on, or of standing still, each time.
const MOST_TIMES: usize = 8;
const MOST_BETWEEN: usize = 2;
const TURNS: [Drawn; 4] = [(Walk::Left45, 1), (Walk::Right45, -1), (Walk::Left90, 2), (Walk::Right90, -2)];

/// Twice one of these leads back.
const BACK: [Drawn; 2] = [TURNS[2], TURNS[3]];

/// What the FMU is told, by number, and for how many steps each.
type Held = Vec<(usize, usize)>;

/// Draws walks to harms on one way.
pub(super) struct Guided<'a> {
    pub seek: Seek<'a>,
    /// Behaviours, and of which way they are, where that is known.
    pub few: Option<(&'a Few, usize)>,
    /// So many steps after the start of the FMU they begin at most.
    pub until: usize,
}

/// A walk to a harm, and what is reported on it until then, step by step.
struct Walked {
    harm: Harm,
    way: WalkIn,
    reported: Vec<Readings>,
    /// Whether it was drawn to come and go.
    comes: bool,
}

impl Guided<'_> {
    /// The first walk that shows harm. The same seed draws the same.
    pub(crate) fn walk(&self, harms: &[Harm], seed: u64) -> Option<(Harm, WalkIn, Finding)> {
        let mut rng = Rng::new(seed);
        let mut waiting: Vec<(Harm, WalkIn)> = Vec::new();
        let mut following: Vec<(usize, Harm, WalkIn)> = Vec::new();
        let mut coming: Vec<(Harm, WalkIn)> = Vec::new();
        for number in 0..MOST_DRAWN {
            if self.seek.prepared.stop().is_due() {
                break;
            }
            let Some(Walked { harm, way, reported, comes }) = self.drawn(harms, number, &mut rng) else { continue };
            if comes && coming.len() < MOST_COMING {
                coming.push((harm, self.and_waits(&harm, way.clone(), &mut rng)));
            } else if waiting.len() < MOST_WAITING {
                waiting.push((harm, self.and_waits(&harm, way.clone(), &mut rng)));
            }
            let off = self.few.and_then(|few| self.off(&harm, &reported, few));
            following.extend(off.map(|(off, lead_in)| (off, harm, WalkIn { lead_in, ..way })));
        }
        following.sort_by_key(|(off, ..)| *off);
        let following = following.into_iter().take(MOST_RUN).map(|(_, harm, way)| (harm, way));
        waiting.into_iter().chain(following).chain(coming).find_map(|(harm, way)| self.shown(harm, way))
    }

    /// Runs walks that wait at their ends, or come and go before, as long as `goes_on`: tells of those that show harm. The same seed draws the same.
    pub(crate) fn each(
        &self,
        harms: &[Harm],
        seed: u64,
        goes_on: &dyn Fn() -> bool,
        tell: &mut dyn FnMut(&Harm, &WalkIn, &Finding),
    ) {
        let mut rng = Rng::new(seed);
        let mut left = [MOST_WAITING, MOST_COMING];
        for number in 0..MOST_DRAWN {
            if left == [0, 0] || !goes_on() {
                break;
            }
            let Some(walked) = self.drawn(harms, number, &mut rng) else { continue };
            let left = &mut left[usize::from(walked.comes)];
            if *left > 0 {
                *left -= 1;
                let way = self.and_waits(&walked.harm, walked.way, &mut rng);
                if let Some((harm, way, finding)) = self.shown(walked.harm, way) {
                    tell(&harm, &way, &finding);
                }
            }
        }
    }

    /// A walk to one of some harms, if there is room for it.
    fn drawn(&self, harms: &[Harm], number: usize, rng: &mut Rng) -> Option<Walked> {
        let harm = if harms.is_empty() { return None } else { harms[rng.below(harms.len())] };
        let comes = number % 2 == 1;
        let drawn = if comes { comings(rng) } else { actions(rng) };
        let (way, places) = self.seek.ending(&harm, &drawn, rng)?;
        let reported = self.reported(&places);
        let comes = comes && changes(&reported) > LEAST_CHANGES;
        Some(Walked { harm, way, reported, comes })
    }

    /// A walk that shows harm, up to then.
    fn shown(&self, harm: Harm, mut way: WalkIn) -> Option<(Harm, WalkIn, Finding)> {
        let finding = shown_by(self.seek.prepared, &way, None)?;
        way.actions.truncate(finding.step.div_ceil(self.seek.prepared.cell.steps_per_action).max(1));
        Some((harm, way, finding))
    }

    /// The same, begun at some moment, and then they stay.
    fn and_waits(&self, harm: &Harm, mut way: WalkIn, rng: &mut Rng) -> WalkIn {
        way.lead_in = rng.below(self.until);
        way.actions.extend(vec![Action::new(Walk::Stop, harm.posture); WAITS]);
        way
    }

    /// What is reported on a walk, step by step, until the harm: nothing is sampled any more there.
    fn reported(&self, places: &[WalkPose]) -> Vec<Readings> {
        let reports = |(xy_m, heading_rad): &WalkPose| self.seek.search.reports(*xy_m, *heading_rad, Posture::Upright);
        places[..places.len() - 1].iter().map(reports).collect()
    }

    /// By how many steps what is reported on a walk is off from what leads to a harm, and when it has to begin for that.
    fn off(&self, harm: &Harm, reported: &[Readings], (few, way): (&Few, usize)) -> Option<(usize, usize)> {
        let history = self.seek.history;
        let walked: Option<Vec<usize>> = reported.iter().map(|readings| few.told(readings)).collect();
        let walked = merged(walked?.into_iter().map(|told| (told, 1)));
        let last = walked.last().map_or(0, |(_, steps)| *steps);
        let told = few.history(history.seen[harm.instant].came?, way, last.saturating_sub(1));
        let told = merged(told.into_iter());
        if told.len() != walked.len() || told.iter().zip(&walked).any(|((told, _), (walked, _))| told != walked) {
            return None;
        }
        let off = told.iter().zip(&walked).skip(1).map(|((_, told), (_, walked))| told.abs_diff(*walked)).sum();
        let steps: usize = told.iter().map(|(_, steps)| steps).sum();
        let lead_in = steps.checked_sub(walked.iter().map(|(_, steps)| steps).sum())?;
        (off <= MOST_OFF).then_some((off, lead_in))
    }
}

/// How often what is reported changes, with what is reported first.
fn changes(reported: &[Readings]) -> usize {
    1 + reported.windows(2).filter(|two| two[0] != two[1]).count()
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

/// Zigzags or rounds, which come to some place and leave it several times where that is at its edge, and straight on after that.
fn comings(rng: &mut Rng) -> Vec<Drawn> {
    let mut all = vec![(Walk::Forward, 0); rng.below(MOST_BETWEEN + 1)];
    let (one, is_round) = (rng.below(TURNS.len()), rng.below(3) == 0);
    // In a round all turns are to one side, and twice as many.
    let turns: &[usize] = if is_round { &[one; 4] } else { &[one, one ^ 1] };
    for time in 0..=rng.below(MOST_TIMES) {
        for (number, turn) in turns.iter().enumerate() {
            all.push(TURNS[*turn]);
            if !is_round || number % 2 == 1 {
                all.extend(vec![(Walk::Forward, 0); rng.below(MOST_BETWEEN + 1)]);
            }
            if time > 0 && rng.below(turns.len() * 2) == 0 {
                all.extend(vec![(Walk::Stop, 0); rng.below(MOST_BETWEEN + 1)]);
            }
        }
    }
    if rng.below(2) == 0 {
        all.push(TURNS[rng.below(TURNS.len())]);
    }
    all.extend(vec![(Walk::Forward, 0); rng.below(MOST_FORWARD / 2)]);
    all
}

/// The same one after the other as one.
fn merged(told: impl Iterator<Item = (usize, usize)>) -> Held {
    let mut all = Held::new();
    for (told, steps) in told {
        match all.last_mut() {
            Some((known, known_steps)) if *known == told => *known_steps += steps,
            _ => all.push((told, steps)),
        }
    }
    all
}

#[cfg(test)]
mod tests {
    use std::f64::consts::{FRAC_PI_4, TAU};

    use super::*;

    /// Of walks that come and go a good part enters a half of the floor three times and more where that is somewhere on their way; of the
    /// others hardly any does.
    #[test]
    fn who_comes_and_goes_enters_several_times() {
        let mut rng = Rng::new(1);
        let mut several =
            |draw: fn(&mut Rng) -> Vec<Drawn>| (0..2_000).filter(|_| entries(&draw(&mut rng), TAU / 7.0) >= 3).count();
        let (coming, others) = (several(comings), several(actions));
        assert!(coming > 400 && others < 40, "{coming} {others}");
    }

    /// How often a walk comes to what is more to the right than its middle.
    fn entries(walk: &[Drawn], mut heading: f64) -> usize {
        let (mut x, mut all) = (0.0, vec![0.0]);
        for (walk, turn) in walk {
            heading += f64::from(*turn) * FRAC_PI_4;
            x += if *walk == Walk::Stop { 0.0 } else { libm::cos(heading) };
            all.push(x);
        }
        let mut ordered = all.clone();
        ordered.sort_by(f64::total_cmp);
        let edge = ordered[all.len() / 2];
        all.windows(2).filter(|two| two[0] < edge && two[1] >= edge).count()
    }
}
