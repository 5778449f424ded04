//! What comes to somebody who is in a pose in which a search found harm, at every other instant of the same history.
//!
//! A search ends at the first harm of a cell of the floor. When else somebody is hit there, and how much harder, is found by
//! looking at its poses once more, instant after instant. Other poses of the cell may be hit at other instants: what is told is
//! what was tried.

use std::collections::{BTreeMap, BTreeSet};

use super::arms::ArmVerdict;
use super::{HistorySearch, TRIED_DEPTHS};
use crate::human::posture::cut_back;
use crate::human::shoulder::is_available;
use crate::human::{PoseBox, Side};
use crate::sim::Coverage;
use crate::sim::encounter::may_meet;
use crate::standards::BodyRegion;
use crate::{Harm, Moment};

/// Poses of a cell that are looked at again, of those in which trunk, head or legs are hit; and of those in which an arm is.
const BODIES: usize = 3;
const ARMS: usize = 1;
/// Instants of a span that are looked at, of those of many states of the FMU spread over all of them.
const INSTANTS: usize = 16;

/// Of some harms in one cell of the floor those whose poses are looked at again, the worst first.
pub(crate) fn worth_following(mut harms: Vec<Harm>) -> Vec<Harm> {
    harms.sort_by(|a, b| b.contact.ratio().total_cmp(&a.contact.ratio()));
    let mut left = BTreeMap::from([(false, BODIES), (true, ARMS)]);
    let mut chosen: Vec<Harm> = Vec::new();
    for harm in harms {
        let same = |other: &Harm| {
            (other.xy_m, other.posture, is_of_arm(other)) == (harm.xy_m, harm.posture, is_of_arm(&harm))
                && other.heading_rad.to_bits() == harm.heading_rad.to_bits()
        };
        if let Some(left) = left.get_mut(&is_of_arm(&harm)).filter(|left| **left > 0)
            && !chosen.iter().any(same)
        {
            *left -= 1;
            chosen.push(harm);
        }
    }
    chosen
}

const fn is_of_arm(harm: &Harm) -> bool {
    matches!(harm.contact.region, BodyRegion::Hand | BodyRegion::LowerArm | BodyRegion::UpperArm)
}

impl HistorySearch<'_> {
    /// The worst that comes to somebody in the pose of a harm in each span of so many steps; nothing where there was no time for
    /// all of it. Of an arm the first harm that is found in a span is told, which may not be its worst.
    pub(crate) fn follow(&self, harm: &Harm, span: usize, coverage: &mut Coverage) -> Option<Vec<Moment>> {
        let encounter = &self.of.encounter;
        let pose = PoseBox::point(harm.xy_m, harm.heading_rad);
        let bend = cut_back(&self.of.cell.body, pose.position(), harm.heading_rad, harm.posture, &encounter.obstacles);
        let body = self.of.placed(&pose, harm.posture, bend);
        let parts = body.parts();
        let sides: Vec<Side> =
            Side::BOTH.into_iter().filter(|side| is_available(&body, *side, &encounter.obstacles)).collect();
        let mut spans: BTreeMap<usize, Vec<usize>> = BTreeMap::new();
        for number in self.near(&pose, 0..self.pairs.len()) {
            spans
                .entry(self.history.seen[self.pairs[number].n].step.saturating_sub(1) / span)
                .or_default()
                .push(number);
        }
        let mut moments = Vec::new();
        for pairs in spans.values().map(|pairs| self.some_of(pairs)) {
            let mut worst: Option<Harm> = None;
            let mut met = |found: Option<Harm>| {
                if let Some(found) = found
                    && worst.is_none_or(|worst| found.contact.ratio() > worst.contact.ratio())
                {
                    worst = Some(found);
                }
            };
            if is_of_arm(harm) {
                for side in &sides {
                    let shoulder = body.shoulder(*side).translation;
                    if !self.arms.may_touch(shoulder, 0.0) {
                        continue;
                    }
                    let in_reach = pairs.iter().map(|number| &self.pairs[*number]);
                    let in_reach = in_reach.filter(|pair| pair.arms && pair.is_near(shoulder, encounter.arm.reach()));
                    for alike in self.by_planes(in_reach, &pose, (shoulder, 0.0)) {
                        let touched = self.meet(&alike, TRIED_DEPTHS, |pairs, walls| {
                            self.ask((&body, *side), 0.0, pairs, walls, true, coverage)
                        });
                        if let ArmVerdict::Touches(pair, walls) = touched {
                            met(self.harm_of_arm(&pose, harm.posture, &body, (pair, &walls), coverage));
                        }
                    }
                }
            } else {
                let mut last = None;
                for pair in pairs.iter().map(|number| &self.pairs[*number]) {
                    let frame = &self.history.seen[pair.n].frame;
                    let harmed = || {
                        parts
                            .iter()
                            .zip(pair.parts)
                            .any(|((part, core), harmed)| harmed && may_meet(*part, core, 0.0, frame, pair.link))
                    };
                    // All links of an instant are looked at together.
                    if last != Some(pair.n) && harmed() {
                        last = Some(pair.n);
                        met(self.harm_of_body(&pose, harm.posture, &body, pair, coverage));
                    }
                }
            }
            if self.is_over() {
                return None;
            }
            moments.extend(worst.map(|harm| harm.at(self.history)));
        }
        Some(moments)
    }

    /// The pairs of some instants.
    fn some_of(&self, pairs: &[usize]) -> Vec<usize> {
        let instants: BTreeSet<usize> = pairs.iter().map(|number| self.pairs[*number].n).collect();
        let some: BTreeSet<usize> =
            instants.iter().copied().step_by(instants.len().div_ceil(INSTANTS).max(1)).collect();
        pairs.iter().copied().filter(|number| some.contains(&self.pairs[*number].n)).collect()
    }
}
