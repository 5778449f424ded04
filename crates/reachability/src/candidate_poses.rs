//! Poses near robots that somebody would be harmed in, whatever sensors report and however they came there: walks that lead to some of
//! them may be run before anything is known of how the FMU goes on.

use std::collections::BTreeSet;
use std::f64::consts::{PI, TAU};
use std::sync::Arc;
use std::sync::atomic::AtomicBool;

use super::history_search::HistorySearch;
use super::{CELL_M, Harm, History, ReachabilitySearch, ReachableInstant};
use crate::human::{PoseBox, Posture};
use crate::search::Rng;
use crate::sim::Coverage;

/// Robots that are looked at, at most, and places near them.
const MOST_ROBOTS: usize = 60;
const PLACES: usize = 120;
/// A finer share of a distance is not drawn.
const SHARES: usize = 1_000;

impl ReachabilitySearch<'_> {
    /// Some of the robots of some histories, and harms in poses near them. `None` where no robot of them can harm anybody. The same
    /// numbers draw the same.
    #[must_use]
    pub fn near_robots(&self, histories: &[History], rng: &mut Rng) -> Option<(History, Vec<Harm>)> {
        let history = any_of(histories, rng)?;
        let end = AtomicBool::new(false);
        let within = HistorySearch::new(self, &history, &end);
        let mut coverage = Coverage::new(self.cell.sensors.len());
        let mut harms = Vec::new();
        for _ in 0..PLACES {
            let links = &history.seen[rng.below(history.seen.len())].frame.links;
            let counting: Vec<usize> = (0..links.len()).filter(|link| history.links[*link]).collect();
            let (centre, radius) = links[counting[rng.below(counting.len())]].bounding_sphere();
            let far_m = share(rng) * (radius + self.body_m);
            let (sin, cos) = libm::sincos(TAU * share(rng));
            let xy_m = [centre.x + cos * far_m, centre.y + sin * far_m];
            let near = PoseBox { xy_m, half_m: CELL_M, heading_rad: 0.0, half_rad: PI };
            harms.extend(within.try_cell(&(near, Posture::USUAL.to_vec()), &mut coverage));
            if within.is_over() {
                break;
            }
        }
        drop(within);
        Some((history, harms))
    }
}

#[expect(clippy::cast_precision_loss, reason = "a thousand")]
fn share(rng: &mut Rng) -> f64 {
    rng.below(SHARES) as f64 / SHARES as f64
}

/// Some robots of all of these, of people of whom nothing is known.
fn any_of(histories: &[History], rng: &mut Rng) -> Option<History> {
    let first = histories.first()?;
    let mut known = BTreeSet::new();
    let is_new = |seen: &&ReachableInstant| known.insert(Arc::as_ptr(&seen.frame));
    let mut all: Vec<&ReachableInstant> = histories.iter().flat_map(|history| &history.seen).filter(is_new).collect();
    let mut seen = Vec::new();
    while seen.len() < MOST_ROBOTS && !all.is_empty() {
        let one = all.swap_remove(rng.below(all.len()));
        seen.push(ReachableInstant { within_m: [f64::MAX; 2], depth_m: f64::INFINITY, ..one.clone() });
    }
    let [_, from] = &first.fields;
    (!seen.is_empty() && first.links.contains(&true)).then(|| History {
        readings: vec![None; first.readings.len()],
        links: Arc::clone(&first.links),
        fields: [from, from].map(Arc::clone),
        seen,
    })
}
