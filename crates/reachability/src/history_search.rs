//! One history looked at: what bounds settle of the floor, poses that are tried, and what is left in ever smaller boxes.

mod arms;
pub(super) mod moments;

use std::collections::{BTreeMap, VecDeque};
use std::ops::ControlFlow;
use std::panic::resume_unwind;
use std::rc::Rc;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::Duration;

use self::arms::ArmVerdict;
use super::readings::lever;
use super::{
    CELL_M, Harm, History, HistoryOutcome, LEVER_M, ReachabilitySearch, ReachableInstant, headings, is_smallest,
};
use crate::geometry::{Cuboid, Vec3};
use crate::hazard::Contact;
use crate::human::posture::{cut_back, may_be_cut_back};
use crate::human::reach::ArmSegment;
use crate::human::reach::cells::{ArmCells, Target};
use crate::human::shoulder::is_available;
use crate::human::{BendFraction, BodyPart, PlacedBody, PoseBox, Posture, Side};
use crate::sim::Coverage;
use crate::sim::encounter::{ArmOverBox, ArmSpace, Encounter, Person, may_harm_part, may_meet};
use crate::sim::robot::RobotFrame;

/// Headings of which poses are tried.
const TRIED_HEADINGS: u32 = 16;
/// Arms that are tried in a cell.
const TRIED_ARMS: u32 = 10;
/// Questions about one of them, where planes limit how deep it may be at each instant.
const TRIED_DEPTHS: usize = 6;

/// With an arm that may be this far from where it is in the middle of a box, nothing is shown of links in its reach, m.
const HOPELESS_M: f64 = 0.025;
/// Between two looks at whether the search has to end.
const LOOK: Duration = Duration::from_millis(20);

/// What is known of a box, for one posture.
#[expect(clippy::large_enum_variant, reason = "one at a time")]
enum BoxVerdict {
    VerifiedSafe,
    Harmful(Harm),
    Undecided(UndecidedBy),
}

/// Why nothing is known of a box.
#[derive(Clone, Copy, PartialEq)]
enum UndecidedBy {
    /// Trunk, head or legs may be met.
    Body,
    /// Arms may.
    Arms,
}

impl UndecidedBy {
    /// What is no farther from the axis between the feet decides how a box is halved, m.
    const fn lever_m(self) -> f64 {
        match self {
            Self::Body => LEVER_M,
            // Exact searches are of a shoulder, and an arm's length beyond it.
            Self::Arms => 0.5 * LEVER_M,
        }
    }
}

/// A link at an instant.
struct Pair {
    /// Number of the instant.
    n: usize,
    link: usize,
    /// Only who is no farther by the history's fields may be there then, m.
    within_m: [f64; 2],
    centre: Vec3,
    radius: f64,
    /// Which parts of the body it may harm, in the order of [`BodyPart::ALL`].
    parts: [bool; BodyPart::ALL.len()],
    /// Whether it may harm arms.
    arms: bool,
}

impl Pair {
    /// Those of an instant that may harm anybody.
    fn all(
        n: usize,
        ReachableInstant { frame, within_m, .. }: &ReachableInstant,
        counts: &[bool],
    ) -> impl Iterator<Item = Self> {
        (0..frame.links.len()).filter(|link| counts[*link]).filter_map(move |link| {
            let (centre, radius) = frame.links[link].bounding_sphere();
            let parts = BodyPart::ALL.map(|part| may_harm_part(part, frame, link, frame.speed_bounds[link]));
            let arms = Encounter::may_harm_arms(frame, link);
            (arms || parts.contains(&true)).then_some(Self {
                n,
                link,
                within_m: *within_m,
                centre,
                radius,
                parts,
                arms,
            })
        })
    }

    fn target<'a>(&self, history: &'a History) -> Target<'a> {
        let frame = &history.seen[self.n].frame;
        let may = |segment| Encounter::may_harm_arm(frame, self.link, segment);
        Target {
            solid: &frame.links[self.link],
            hand: may(ArmSegment::Hand),
            forearm: may(ArmSegment::Forearm) || may(ArmSegment::Elbow),
            upper_arm: may(ArmSegment::UpperArm),
        }
    }

    /// Whether somebody may be there then who is so far at least by the history's fields.
    fn is_within(&self, least: [f64; 2]) -> bool {
        (0..2).all(|n| least[n] <= self.within_m[n])
    }

    /// Whether some of it is within `reach_m` of a point.
    fn is_near(&self, point: Vec3, reach_m: f64) -> bool {
        let reach = self.radius + reach_m;
        (self.centre - point).length_squared() <= reach * reach
    }
}

/// A cell of the floor in which somebody may be harmed, in some postures.
pub(super) type UndecidedCell = (PoseBox, Vec<Posture>);

/// A search within one history.
pub(super) struct HistorySearch<'a> {
    of: &'a ReachabilitySearch<'a>,
    history: &'a History,
    /// Links at instants, one instant after the other.
    pairs: Vec<Pair>,
    walls: Vec<Cuboid>,
    /// Where arms get to a robot at any instant.
    arms: Arc<ArmCells>,
    /// Set where it has to end.
    end: &'a AtomicBool,
}

impl<'a> HistorySearch<'a> {
    pub(super) fn new(of: &'a ReachabilitySearch<'a>, history: &'a History, end: &'a AtomicBool) -> Self {
        let pairs = Self::pairs(history);
        let walls = of.walls(history);
        let targets: Vec<Target<'_>> = pairs.iter().filter(|pair| pair.arms).map(|pair| pair.target(history)).collect();
        let arms = ArmCells::new(&of.encounter.arm, &targets, &of.encounter.obstacles, &walls);
        let arms = Arc::new(arms.heeding(&of.encounter.stop));
        Self { of, history, pairs, walls, arms, end }
    }

    /// The same history with other bounds on where links are: arms get to a robot only where by both they do.
    pub(super) fn with<'b>(&'b self, history: &'b History) -> HistorySearch<'b> {
        let Self { of, end, walls, arms, .. } = self;
        HistorySearch { of, history, pairs: Self::pairs(history), walls: walls.clone(), arms: Arc::clone(arms), end }
    }

    /// Which links count.
    pub(super) fn links(&self) -> &[bool] {
        &self.history.links
    }

    fn pairs(history: &History) -> Vec<Pair> {
        history.seen.iter().enumerate().flat_map(|(n, seen)| Pair::all(n, seen, &history.links)).collect()
    }

    /// Does `work` for each of some items, on so many threads: the results in the order of the items.
    pub(super) fn in_parallel<T: Sync, R: Send>(
        &self,
        workers: usize,
        items: &[T],
        tell: &mut dyn FnMut(f64) -> ControlFlow<()>,
        work: impl Fn(&T, &mut Coverage) -> R + Sync,
    ) -> Vec<(R, Coverage)> {
        let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
        let thread = || {
            let mut mine = Vec::new();
            loop {
                let number = next.fetch_add(1, Ordering::Relaxed);
                let Some(item) = items.get(number) else { return mine };
                let mut coverage = Coverage::new(self.of.cell.sensors.len());
                mine.push((number, work(item, &mut coverage), coverage));
                done.fetch_add(1, Ordering::Relaxed);
            }
        };
        let mut parts = std::thread::scope(|scope| {
            let threads: Vec<_> = (0..workers.max(1)).map(|_| scope.spawn(thread)).collect();
            while !threads.iter().all(std::thread::ScopedJoinHandle::is_finished) {
                #[expect(clippy::cast_precision_loss, reason = "some thousand")]
                let share = done.load(Ordering::Relaxed) as f64 / items.len().max(1) as f64;
                if tell(share).is_break() {
                    self.end.store(true, Ordering::Relaxed);
                }
                std::thread::sleep(LOOK);
            }
            let joined = threads.into_iter().map(|thread| thread.join().unwrap_or_else(|panic| resume_unwind(panic)));
            joined.flatten().collect::<Vec<_>>()
        });
        parts.sort_by_key(|(number, ..)| *number);
        parts.into_iter().map(|(_, result, coverage)| (result, coverage)).collect()
    }

    /// Everything in a first box that bounds settle, and the cells of the floor that are left.
    pub(super) fn first(&self, first: PoseBox, coverage: &mut Coverage) -> (HistoryOutcome, Vec<UndecidedCell>) {
        let (mut outcome, mut undecided) = (HistoryOutcome::default(), Vec::new());
        let all: Rc<Vec<usize>> = Rc::new((0..self.pairs.len()).collect());
        let mut pending = vec![(first, Posture::USUAL.to_vec(), all)];
        while let Some((at, mut postures, pairs)) = pending.pop() {
            let near = Rc::new(self.near(&at, pairs.iter().copied()));
            if near.is_empty() {
                continue;
            }
            postures.retain(|posture| !self.is_settled(&at, *posture, &near, &mut outcome, coverage));
            if self.is_over() {
                outcome.stopped = true;
                break;
            }
            if postures.is_empty() {
                continue;
            }
            if at.half_m > CELL_M {
                pending.extend(at.quarters().map(|part| (part, postures.clone(), Rc::clone(&near))));
            } else {
                undecided.push((at, postures));
            }
        }
        (outcome, undecided)
    }

    /// Harms in some poses in a cell of the floor.
    pub(super) fn try_cell(&self, (cell, postures): &UndecidedCell, coverage: &mut Coverage) -> Vec<Harm> {
        let near = self.near(cell, 0..self.pairs.len());
        if near.is_empty() || self.is_over() { Vec::new() } else { self.try_poses(cell, postures, &near, coverage) }
    }

    /// Of some links at instants those that anybody in a box may meet.
    fn near(&self, at: &PoseBox, pairs: impl Iterator<Item = usize>) -> Vec<usize> {
        let least = self.history.least(at.xy_m, at.half_m);
        let near = |number: &usize| {
            let pair = &self.pairs[*number];
            let (centre, reach_m) = at.around(1.0, if pair.arms { self.of.reach_m } else { self.of.body_m });
            pair.is_within(least)
                && pair.is_near(centre, reach_m)
                && self.history.seen[pair.n].frame.links[pair.link].is_nearer_than(reach_m, centre)
        };
        pairs.filter(near).collect()
    }

    pub(super) fn is_over(&self) -> bool {
        self.end.load(Ordering::Relaxed) || self.of.encounter.stop.is_due()
    }

    /// Whether it is shown of all of a box that nobody is harmed in it; a box of every heading in arcs, as far as that helps.
    fn is_settled(
        &self,
        at: &PoseBox,
        posture: Posture,
        near: &[usize],
        outcome: &mut HistoryOutcome,
        coverage: &mut Coverage,
    ) -> bool {
        let mut pending = vec![*at];
        while let Some(at) = pending.pop() {
            if self.is_over() {
                return false;
            }
            outcome.boxes += 1;
            match self.judge(&at, posture, near, false, coverage) {
                BoxVerdict::VerifiedSafe => {}
                // What arms do is looked at arc by arc there.
                BoxVerdict::Undecided(UndecidedBy::Body) if at.moves_m(LEVER_M) > 2.0 * at.place_moves_m() => {
                    pending.extend(at.halves());
                }
                BoxVerdict::Harmful(_) | BoxVerdict::Undecided(_) => return false,
            }
        }
        true
    }

    /// Whether it is shown of all of a box by itself that nobody is harmed in it.
    pub(super) fn settles(&self, at: &PoseBox, posture: Posture, coverage: &mut Coverage) -> bool {
        let near = self.near(at, 0..self.pairs.len());
        self.of.has_no_room(at) || matches!(self.judge(at, posture, &near, true, coverage), BoxVerdict::VerifiedSafe)
    }

    /// A cell of the floor in ever smaller boxes, no more of them for a posture than told, up to the first harm.
    pub(super) fn closely(
        &self,
        (cell, postures): &UndecidedCell,
        most: u64,
        coverage: &mut Coverage,
    ) -> HistoryOutcome {
        let mut outcome = HistoryOutcome::default();
        let near = self.near(cell, 0..self.pairs.len());
        for posture in postures {
            let mut pending = VecDeque::from([*cell]);
            let mut boxes = 0;
            while let Some(at) = pending.pop_front() {
                if self.is_over() {
                    outcome.stopped = true;
                    return outcome;
                }
                boxes += 1;
                if self.of.has_no_room(&at) {
                    continue;
                }
                match self.judge(&at, *posture, &near, true, coverage) {
                    BoxVerdict::VerifiedSafe => {}
                    BoxVerdict::Harmful(harm) => {
                        outcome.boxes += boxes;
                        outcome.harms.push(harm);
                        return outcome;
                    }
                    // What was not looked at to the end is not told to be open.
                    BoxVerdict::Undecided(_) if self.is_over() => {
                        outcome.stopped = true;
                        return outcome;
                    }
                    BoxVerdict::Undecided(_) if is_smallest(&at) || boxes >= most => {
                        outcome.boxes += boxes;
                        outcome.open.push(cell.xy_m);
                        return outcome;
                    }
                    BoxVerdict::Undecided(why) => pending.extend(at.parts(why.lever_m())),
                }
            }
            outcome.boxes += boxes;
        }
        outcome
    }

    /// Harms in some poses of a box: of each region of trunk, head and legs and each link the worst, and one of arms, those first
    /// whose shoulders are nearest to a robot.
    fn try_poses(&self, at: &PoseBox, postures: &[Posture], near: &[usize], coverage: &mut Coverage) -> Vec<Harm> {
        let mut harms: BTreeMap<(u8, usize), Harm> = BTreeMap::new();
        let ReachabilitySearch { cell, encounter, .. } = self.of;
        let quarter = 0.5 * at.half_m;
        let places = [(0.0, 0.0), (-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)]
            .map(|(x, y)| [at.xy_m[0] + x * quarter, at.xy_m[1] + y * quarter]);
        let mut reaching: Vec<(f64, PoseBox, Posture, PlacedBody, Side)> = Vec::new();
        // Wherever shoulders are in the cell: within what holds the rest of the body.
        let shoulders = at.around(1.0, self.of.body_m);
        let in_time = |pair: &&Pair| pair.arms && self.is_in_time(pair, at, shoulders);
        let in_time: Vec<&Pair> = near.iter().map(|&number| &self.pairs[number]).filter(in_time).collect();
        let headings = || headings(TRIED_HEADINGS).map(|(heading_rad, _)| heading_rad);
        for (posture, xy_m) in postures.iter().flat_map(|posture| places.map(|xy_m| (*posture, xy_m))) {
            for heading_rad in headings() {
                if self.is_over() {
                    break;
                }
                let pose = PoseBox::point(xy_m, heading_rad);
                let bend = cut_back(&cell.body, pose.position(), heading_rad, posture, &encounter.obstacles);
                let body = self.of.placed(&pose, posture, bend);
                let possible = || self.of.is_possible(xy_m, heading_rad, posture, &self.history.readings);
                let parts = body.parts();
                let least = self.history.least(xy_m, 0.0);
                let near = || near.iter().map(|&number| &self.pairs[number]).filter(|pair| pair.is_within(least));
                let met = near().find(|pair| {
                    let frame = &self.history.seen[pair.n].frame;
                    let harmed = parts.iter().zip(pair.parts).filter(|(_, harmed)| *harmed);
                    harmed.into_iter().any(|((part, core), _)| {
                        let middle = (core.a + core.b) * 0.5;
                        pair.is_near(middle, 0.5 * (core.b - core.a).length() + core.radius)
                            && may_meet(*part, core, 0.0, frame, pair.link)
                    })
                });
                if let Some(pair) = met.filter(|_| possible())
                    && let Some(harm) = self.harm_of_body(&pose, posture, &body, pair, coverage)
                {
                    let known = harms.entry((harm.contact.region as u8, harm.link)).or_insert(harm);
                    if harm.contact.ratio() > known.contact.ratio() {
                        *known = harm;
                    }
                }
                for side in Side::BOTH {
                    let shoulder = body.shoulder(side).translation;
                    let near = in_time.iter().filter(|pair| pair.is_within(least));
                    let gap = near.map(|pair| (pair.centre - shoulder).length() - pair.radius).reduce(f64::min);
                    if let Some(gap) = gap.filter(|gap| *gap <= encounter.arm.reach()) {
                        reaching.push((gap, pose, posture, body, side));
                    }
                }
            }
        }
        reaching.sort_by(|a, b| a.0.total_cmp(&b.0));
        let mut tried = 0;
        for (_, pose, posture, body, side) in reaching {
            let shoulder = body.shoulder(side).translation;
            if !is_available(&body, side, &encounter.obstacles)
                || !self.arms.may_touch(shoulder, 0.0)
                || !self.arms.may_touch_hanging(shoulder, 0.0, (body.middle_of_shoulders(), 0.0))
                || !self.of.is_possible(pose.xy_m, pose.heading_rad, posture, &self.history.readings)
            {
                continue;
            }
            let least = self.history.least(pose.xy_m, 0.0);
            let may = |pair: &&Pair| pair.is_within(least) && pair.is_near(shoulder, encounter.arm.reach());
            let groups = self.by_planes(in_time.iter().copied().filter(may), &pose, (shoulder, 0.0));
            tried += u32::from(!groups.is_empty());
            if tried > TRIED_ARMS || self.is_over() {
                break;
            }
            let harm = groups.iter().find_map(|alike| {
                let met = self.meet(alike, TRIED_DEPTHS, |pairs, walls| {
                    self.ask((&body, side), 0.0, pairs, walls, true, coverage)
                });
                let ArmVerdict::Touches(pair, walls) = met else { return None };
                self.harm_of_arm(&pose, posture, &body, (pair, &walls), coverage)
            });
            if let Some(harm) = harm {
                harms.insert((harm.contact.region as u8, harm.link), harm);
                break;
            }
        }
        harms.into_values().collect()
    }

    /// What is known of a box; if `search`, also what only a search of all that an arm can do tells.
    fn judge(
        &self,
        at: &PoseBox,
        posture: Posture,
        near: &[usize],
        search: bool,
        coverage: &mut Coverage,
    ) -> BoxVerdict {
        let ReachabilitySearch { cell, encounter, .. } = self.of;
        let (least, most) = may_be_cut_back(&cell.body, at, posture, &encounter.obstacles);
        let own = cut_back(&cell.body, at.position(), at.heading_rad, posture, &encounter.obstacles);
        // Whether somebody can be as in the middle of the box: asked only where that matters.
        let possible = || self.of.is_possible(at.xy_m, at.heading_rad, posture, &self.history.readings);
        let far = self.history.least(at.xy_m, at.half_m);
        let (centre, body_m) = at.around(1.0, self.of.body_m);
        let near_body = |pair: &&Pair| {
            let seen = &self.history.seen[pair.n];
            pair.is_within(far)
                && pair.is_near(centre, body_m)
                && !self.of.keeps_bodies(self.history, (seen, &seen.frame.links[pair.link]), at)
        };
        let bodily: Vec<&Pair> = near.iter().map(|&number| &self.pairs[number]).filter(near_body).collect();
        for bend in BendFraction::ALL.into_iter().filter(|bend| (least..=most).contains(bend)) {
            if self.is_over() {
                return BoxVerdict::Undecided(UndecidedBy::Arms);
            }
            let body = self.of.placed(at, posture, bend);
            if !self.of.may_have_read(at, posture, &body, &self.history.readings) {
                continue;
            }
            // Around each part, with how far it moves.
            let parts = body.parts().map(|(part, core)| {
                let by = at.moves_m(lever(at, core.a.x, core.a.y).max(lever(at, core.b.x, core.b.y)));
                let middle = (core.a + core.b) * 0.5;
                (part, core, by, middle, 0.5 * (core.b - core.a).length() + core.radius + by)
            });
            let met = |pair: &&&Pair| {
                let frame = &self.history.seen[pair.n].frame;
                parts.iter().zip(pair.parts).any(|((part, core, by, middle, around), harmed)| {
                    harmed && pair.is_near(*middle, *around) && may_meet(*part, core, *by, frame, pair.link)
                })
            };
            let mut met = bodily.iter().filter(met).peekable();
            if met.peek().is_some() {
                let is = bend == own && possible();
                if !search || !(is || is_smallest(at)) {
                    return BoxVerdict::Undecided(UndecidedBy::Body);
                }
                match met.find_map(|pair| self.harm_of_body(at, posture, &body, pair, coverage)) {
                    Some(harm) if is => return BoxVerdict::Harmful(harm),
                    Some(_) => return BoxVerdict::Undecided(UndecidedBy::Body),
                    // What holds in the middle of a smallest box holds in all of it, but for the tolerance.
                    None if is_smallest(at) => {}
                    None => return BoxVerdict::Undecided(UndecidedBy::Body),
                }
            }
            for side in Side::BOTH {
                let shoulder = body.shoulder(side).translation;
                let from_axis = lever(at, shoulder.x, shoulder.y);
                let carried = at.moves_m(from_axis + encounter.arm.upper_arm_m + encounter.arm.forearm_m);
                let reach = encounter.arm.reach() + carried;
                let in_reach = |pair: &&Pair| pair.arms && pair.is_within(far) && pair.is_near(shoulder, reach);
                let pairs = near.iter().map(|&number| &self.pairs[number]).filter(in_reach);
                let groups = self.by_planes(pairs, at, (shoulder, carried));
                if groups.is_empty() || self.of.is_out_of_reach(&self.arms, at, (posture, bend, side)) {
                    continue;
                }
                if !search || carried > HOPELESS_M {
                    return BoxVerdict::Undecided(UndecidedBy::Arms);
                }
                // What holds in the middle of a small box holds in all of it, but for the tolerance; not of a shoulder that is
                // behind a wall there.
                let available = is_available(&body, side, &encounter.obstacles);
                let carried = if available && carried <= encounter.reach_tolerance_m { 0.0 } else { carried };
                for alike in groups {
                    let met = self.meet(&alike, usize::MAX, |pairs, walls| {
                        self.ask((&body, side), carried, pairs, walls, false, coverage)
                    });
                    match met {
                        ArmVerdict::Nowhere => {}
                        ArmVerdict::Unknown => return BoxVerdict::Undecided(UndecidedBy::Arms),
                        ArmVerdict::Touches(pair, walls) => {
                            let is = bend == own && available && possible();
                            let harm = is.then(|| self.harm_of_arm(at, posture, &body, (pair, &walls), coverage));
                            return harm
                                .flatten()
                                .map_or(BoxVerdict::Undecided(UndecidedBy::Arms), BoxVerdict::Harmful);
                        }
                    }
                }
            }
        }
        BoxVerdict::VerifiedSafe
    }

    /// What an arm of somebody meets of links at some instants, between walls: [`Encounter::arm_over_box`].
    fn ask(
        &self,
        of: (&PlacedBody, Side),
        carried_m: f64,
        pairs: &[&Pair],
        walls: &[Cuboid],
        try_only: bool,
        coverage: &mut Coverage,
    ) -> ArmOverBox {
        let links: Vec<(&RobotFrame, usize)> =
            pairs.iter().map(|pair| (&*self.history.seen[pair.n].frame, pair.link)).collect();
        self.of.encounter.arm_over_box(of, carried_m, &links, (walls, &self.arms), try_only, coverage)
    }

    /// The harm to trunk, head or legs that somebody in the middle of a box comes to at an instant, if any.
    fn harm_of_body(
        &self,
        at: &PoseBox,
        posture: Posture,
        body: &PlacedBody,
        pair: &Pair,
        coverage: &mut Coverage,
    ) -> Option<Harm> {
        let seen = &self.history.seen[pair.n];
        let person = Person { body: *body, arms: Vec::new(), velocity: Vec3::ZERO, wrists_m: None };
        let counts = |contact: &Contact| {
            self.history.links[contact.link] && {
                let link = &seen.frame.links[contact.link];
                self.of.may_be_at(self.history, (seen, link), at, contact.on_robot)
            }
        };
        let contact = self.of.encounter.unsafe_body_contact(&person, &seen.frame, counts, coverage)?;
        Some(harm(at, posture, pair, contact))
    }

    /// The same of an arm and one link, with what else keeps it off.
    fn harm_of_arm(
        &self,
        at: &PoseBox,
        posture: Posture,
        body: &PlacedBody,
        (pair, walls): (&Pair, &[Cuboid]),
        coverage: &mut Coverage,
    ) -> Option<Harm> {
        let (encounter, frame) = (&self.of.encounter, &self.history.seen[pair.n].frame);
        let available = Side::BOTH.into_iter().filter(|&side| is_available(body, side, &encounter.obstacles));
        let person = Person { body: *body, arms: available.collect(), velocity: Vec3::ZERO, wrists_m: None };
        let links: Vec<bool> = (0..frame.links.len()).map(|link| link == pair.link).collect();
        let space = ArmSpace { walls, links: Some(&links) };
        let (contact, _) = encounter.unsafe_arm_contact(&person, frame, &space, coverage)?;
        Some(harm(at, posture, pair, contact))
    }
}

fn harm(at: &PoseBox, posture: Posture, pair: &Pair, contact: Contact) -> Harm {
    let (xy_m, heading_rad) = (at.xy_m, at.heading_rad);
    Harm { xy_m, heading_rad, posture, instant: pair.n, link: contact.link, contact }
}
