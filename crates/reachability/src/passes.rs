//! A history looked at, several times: what bounds settle in large boxes; poses that are tried in the cells of the floor that are left;
//! the rest in ever smaller boxes, where somebody is hit elsewhere twice, the second time for longer; and what is not decided between two
//! instants in parts of steps. Last what is hit once more, in each span of time.

use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::ops::ControlFlow;
use std::sync::atomic::AtomicBool;

use super::history_search::moments::worth_following;
use super::history_search::{HistorySearch, UndecidedCell};
use super::questions::{about, key};
use super::{Harm, History, HistoryOutcome, ReachabilitySearch, told_in};
use crate::geometry::{Solid, Vec3};
use crate::human::PoseBox;
use crate::sim::Coverage;
use crate::sim::answers::Answers;
use crate::sim::robot::RobotFrame;

/// Half an edge of the boxes that a search begins with, m.
const FIRST_M: f64 = 0.2;
/// Boxes of a cell of the floor and a posture after which it is left open.
const MOST_BOXES: u64 = 20_000;
/// The same where somebody is hit elsewhere; what is open then is looked at again, up to more of them, if that is no more than so many
/// cells.
const FEW_BOXES: u64 = 60;
const MORE_BOXES: u64 = 2_000;
const FEW_OPEN: usize = 60;
/// Parts of a step in which cells are looked at, first and then, in which nobody is hit but between two instants, where somebody is hit
/// elsewhere: so many cells at most. Where nobody is hit at all it stays not known, whatever tolerances would allow.
const PARTS: [usize; 2] = [8, 32];
const MOST_DOUBTFUL: usize = 8;
/// How near robots are that count then, beyond what they and arms reach, m.
const NEAR_M: f64 = 0.1;

/// A history with steps in so many parts, of robots that are where it says; none where that is not known, or too much.
pub type InParts<'a> = &'a dyn Fn(usize, &dyn Fn(&RobotFrame) -> bool) -> Option<History>;

/// What the robots do while the sensors report the same, more and less closely.
#[derive(Clone, Copy)]
pub struct Histories<'a> {
    /// At its instants.
    pub at_instants: &'a History,
    /// With what is between them: links as large as what they may sweep in half a step.
    pub around: &'a History,
    /// In parts of steps.
    pub in_parts: InParts<'a>,
}

/// What a search is done with.
#[derive(Clone, Copy, Debug)]
pub struct Means<'a> {
    /// Threads.
    pub workers: usize,
    /// What is known from before, and what is kept.
    pub answers: &'a Answers,
}

impl ReachabilitySearch<'_> {
    /// Every pose in which the sensors report what they do in a history, on so many threads, at its instants and with what is
    /// between them; where somebody may be hit between two only, in parts of steps. What is hit is looked at again in each span of so
    /// many steps. `tell` hears of the share that is done, and may end it.
    pub fn search(
        &self,
        Histories { at_instants: history, around: between, in_parts }: Histories<'_>,
        span: usize,
        Means { workers, answers }: Means<'_>,
        coverage: &mut Coverage,
        tell: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) -> HistoryOutcome {
        let about = about([history, between], answers);
        let mut first = self.first_boxes(between);
        first.retain(|square| answers.share().is_none_or(|share| share.owns(&key(&about, "share", square))));
        let end = AtomicBool::new(false);
        let (within, around) = (HistorySearch::new(self, history, &end), HistorySearch::new(self, between, &end));
        let mut all = HistoryOutcome::default();
        let mut undecided = Vec::new();
        let first = around.in_parallel(workers, &first, &mut |share| tell(0.3 * share), |at, coverage| {
            answers.answer(|| key(&about, "first", at), coverage, || around.is_over(), |c| around.first(*at, c))
        });
        for ((part, cells), seen) in first {
            coverage.merge(&seen);
            all.add(part);
            undecided.extend(cells);
        }
        let tried = within.in_parallel(workers, &undecided, &mut |share| tell(0.3 + 0.2 * share), |cell, coverage| {
            answers.answer(|| key(&about, "tried", cell), coverage, || within.is_over(), |c| within.try_cell(cell, c))
        });
        let mut left = Vec::new();
        for (cell, (harms, seen)) in undecided.into_iter().zip(tried) {
            coverage.merge(&seen);
            if harms.is_empty() {
                left.push(cell);
            }
            all.harms.extend(harms);
        }
        // Where there are hazards, what is not decided yet is of less interest.
        let is_hit = !all.harms.is_empty();
        let look = |cell: &UndecidedCell, most: u64, coverage: &mut Coverage| {
            // First what is more likely to answer both.
            if is_hit {
                let at_instants = within.closely(cell, most, coverage);
                if at_instants.is_settled() {
                    around.closely(cell, most, coverage).narrowed(at_instants)
                } else {
                    at_instants
                }
            } else {
                let wide = around.closely(cell, most, coverage);
                if wide.is_settled() { wide } else { wide.narrowed(within.closely(cell, most, coverage)) }
            }
        };
        let mut closely = |cells: &[UndecidedCell], most: u64, from: f64| {
            let stage = format!("closely, {most}");
            let tell = &mut |share: f64| tell(from + (1.0 - from) * share);
            within.in_parallel(workers, cells, tell, |cell, coverage| {
                answers.answer(|| key(&about, &stage, cell), coverage, || within.is_over(), |c| look(cell, most, c))
            })
        };
        let mut looked = closely(&left, if is_hit { FEW_BOXES } else { MOST_BOXES }, 0.5);
        let open: Vec<usize> = (0..looked.len()).filter(|number| !looked[*number].0.open.is_empty()).collect();
        if is_hit && (1..=FEW_OPEN).contains(&open.len()) && !looked.iter().any(|(part, _)| part.stopped) {
            let cells: Vec<UndecidedCell> = open.iter().map(|number| left[*number].clone()).collect();
            for (number, (mut part, seen)) in open.iter().zip(closely(&cells, MORE_BOXES, 0.7)) {
                part.boxes += looked[*number].0.boxes;
                looked[*number].0 = part;
                looked[*number].1.merge(&seen);
            }
        }
        if is_hit {
            self.look_in_parts(&around, in_parts, (workers, &left), &mut looked, tell);
        }
        for (part, seen) in looked {
            coverage.merge(&seen);
            all.add(part);
        }
        if !all.stopped {
            let mut by_cell: BTreeMap<[i64; 2], Vec<Harm>> = BTreeMap::new();
            for harm in &all.harms {
                by_cell.entry(told_in(harm.xy_m)).or_default().push(*harm);
            }
            let poses: Vec<Harm> = by_cell.into_values().flat_map(worth_following).collect();
            let by = format!("followed, {span}");
            let follow = |harm: &Harm, coverage: &mut Coverage| within.follow(harm, span, coverage);
            let followed = within.in_parallel(workers, &poses, &mut |_| tell(1.0), |harm, coverage| {
                answers.answer(|| key(&about, &by, harm), coverage, || within.is_over(), |c| follow(harm, c))
            });
            all.followed = true;
            for (moments, seen) in followed {
                // Nothing is excluded by these: one that gave up early leaves nothing open.
                coverage.arm_checks += seen.arm_checks;
                coverage.arm_boxes += seen.arm_boxes;
                all.followed &= moments.is_some();
                all.moments.extend(moments.unwrap_or_default());
            }
        }
        all
    }

    /// Of cells in which nobody is hit but between two instants, whether that is so in parts of steps, too: some of what was looked at.
    fn look_in_parts(
        &self,
        around: &HistorySearch<'_>,
        in_parts: InParts<'_>,
        (workers, left): (usize, &[UndecidedCell]),
        looked: &mut [(HistoryOutcome, Coverage)],
        tell: &mut dyn FnMut(f64) -> ControlFlow<()>,
    ) {
        for parts in PARTS {
            let is_doubtful = |number: &usize| !looked[*number].0.between.is_empty();
            let doubtful: Vec<usize> = (0..looked.len()).filter(is_doubtful).collect();
            let is_asked = (1..=MOST_DOUBTFUL).contains(&doubtful.len());
            if !is_asked || looked.iter().any(|(part, _)| part.stopped) {
                return;
            }
            let cells: Vec<UndecidedCell> = doubtful.iter().map(|number| left[*number].clone()).collect();
            let near = |frame: &RobotFrame| self.is_near_any(frame, around.links(), &cells);
            let Some(steps) = in_parts(parts, &near) else { return };
            let finely = around.with(&steps);
            let again = finely.in_parallel(workers, &cells, &mut |_| tell(1.0), |cell, coverage| {
                finely.closely(cell, MOST_BOXES, coverage)
            });
            for (number, (part, seen)) in doubtful.iter().zip(again) {
                let (known, coverage) = &mut looked[*number];
                if part.is_settled() {
                    known.between.clear();
                }
                known.boxes += part.boxes;
                known.stopped |= part.stopped;
                // What is not decided so stays between two instants.
                coverage.arm_checks += seen.arm_checks;
                coverage.arm_boxes += seen.arm_boxes;
            }
        }
    }

    /// Boxes that hold every place from which a robot can be met.
    fn first_boxes(&self, history: &History) -> Vec<PoseBox> {
        let mut low = [f64::MAX; 2];
        let mut high = [f64::MIN; 2];
        for link in history.seen.iter().flat_map(|seen| &seen.frame.links) {
            let (centre, radius) = link.bounding_sphere();
            for (axis, at) in [centre.x, centre.y].into_iter().enumerate() {
                low[axis] = low[axis].min(at - radius - self.reach_m);
                high[axis] = high[axis].max(at + radius + self.reach_m);
            }
        }
        let mut boxes = Vec::new();
        // Whole multiples of the edge, so that cells stay where they are.
        let from = low.map(|at| (at / (2.0 * FIRST_M)).floor());
        let mut y = from[1];
        while y * 2.0 * FIRST_M < high[1] {
            let mut x = from[0];
            while x * 2.0 * FIRST_M < high[0] {
                let xy_m = [(x + 0.5) * 2.0 * FIRST_M, (y + 0.5) * 2.0 * FIRST_M];
                boxes.push(PoseBox { xy_m, half_m: FIRST_M, heading_rad: 0.0, half_rad: PI });
                x += 1.0;
            }
            y += 1.0;
        }
        boxes
    }

    /// Whether any of the links that count is near enough to any of these cells that somebody there might meet it a step later.
    fn is_near_any(&self, frame: &RobotFrame, links: &[bool], cells: &[UndecidedCell]) -> bool {
        let around: Vec<(Vec3, f64)> = cells.iter().map(|(at, _)| at.around(1.0, self.reach_m)).collect();
        let is_near =
            |link: &Solid| around.iter().any(|(centre, reach_m)| link.is_nearer_than(reach_m + NEAR_M, *centre));
        frame.links.iter().zip(links).any(|(link, counts)| *counts && is_near(link))
    }
}
