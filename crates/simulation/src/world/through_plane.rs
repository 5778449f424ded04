//! Arms and planes: light curtains, doors, the buttons of two-hand controls. Which of an arm's ways past each plane are
//! possible where the person stands, how far the hand can have come, and where the robot is, if the plane told of the arm.
//!
//! Where the shoulder is decides (see the method page, "Arms and planes"): while the body is in the plane, arms are on both
//! sides; before it they stay there or go through; behind it they have the true run, with the plane clear behind them. For
//! each way the robots are those of a run in which the plane told of the arm in a [`Window`] of samples. The geometry is in
//! [`detection_plane`]; how the robots would move, [`SignalledRuns`] tells.

use std::sync::Arc;

use super::contacts::Posed;
use super::{Frames, Hit, IfSignalled, Instant, Occupant, PersonState, SignalledRuns, Window};
use crate::Coverage;
use crate::detection_plane::{self, DetectionPlane};
use crate::encounter::{ArmSpace, Encounter, Encountered, Person};
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::human::{Place, Side};
use crate::robot::RobotFrame;
use crate::sensors::{DelayLine, breaks};
use crate::standards::iso_13855::HAND_SPEED_M_S;

/// Samples since a plane was broken, or a control let go, that are not counted any more: anything is possible since.
const LONG_AGO: usize = DelayLine::LONGEST as usize;

/// No shoulder is farther from the middle of the feet along the floor, m.
const SHOULDER_WITHIN_M: f64 = 0.75;

/// Where an arm is with regard to a plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum ArmSide {
    /// Its shoulder is in front, and the body is not in the plane.
    Front,
    /// The body is in the plane, or a two-hand control is let go.
    In,
    /// Its shoulder is behind, and the body is not in the plane.
    Behind,
    /// The person holds the two-hand control and leans over its buttons: such an arm is tried as if it had let go.
    LeansOver,
}

/// A way of an arm past one plane, if the plane tells of it.
#[derive(Clone, Copy, Debug)]
struct PlanePass {
    window: Window,
    /// How far behind the plane the hand can be, m.
    limit_m: f64,
    /// The arm comes from behind: the limit is one in front of the plane.
    back: bool,
    /// The plane is clear behind the person: no arm passes it.
    closed: bool,
}

/// An arm's ways past one plane.
struct PlanePasses {
    /// Walls that keep an arm from what it cannot do untold; nothing if it can do nothing untold.
    untold: Option<Vec<Cuboid>>,
    /// How far behind the plane a hand can be untold, m.
    untold_limit_m: f64,
    /// Ways of which the plane tells, by the time they take.
    told: Vec<PlanePass>,
}

impl PlanePass {
    /// The one of two that leaves the hand more time.
    fn wider(self, other: Self) -> Self {
        if other.limit_m > self.limit_m { other } else { self }
    }
}

/// The robots, had planes told of an arm on these ways, one past each of some planes; as they are, on no way.
struct PassRun {
    ways: Vec<PlanePass>,
    frames: Frames,
    i: usize,
}

impl PassRun {
    fn frame(&self) -> &RobotFrame {
        &self.frames[self.i]
    }

    /// Which of its ways come from behind.
    fn backs(&self) -> impl Iterator<Item = bool> {
        self.ways.iter().map(|way| way.back)
    }
}

/// Planes that an arm may pass while they tell of it, and the walls of all others, which it passes untold; no plane at all
/// for an arm that none tells of.
struct Passage {
    planes: Vec<usize>,
    walls: Vec<Cuboid>,
}

/// Arms of a person whose shoulders are on the same sides of all planes.
struct Arms<'a> {
    encounter: &'a Encounter,
    person: Person,
    sides: Vec<ArmSide>,
    ways: Vec<PlanePasses>,
    passages: Vec<Passage>,
    shoulders: Vec<Vec3>,
}

/// A person at planes: arms by the ways that they have. Where the robots are has no part in it.
pub(super) struct AtPlanes<'a>(Vec<Arms<'a>>);

/// The runs of one passage, with the number of those that the FMU could not finish.
type OfPassage = (Vec<PassRun>, u64);

/// The runs that decide what arms meet at an instant, by arms and passage, as far as they were asked for.
pub(super) struct PassRuns(Vec<Vec<Option<OfPassage>>>);

impl PassRuns {
    /// None asked for yet.
    pub(super) fn new(at: &AtPlanes<'_>) -> Self {
        Self(at.0.iter().map(|arms| arms.passages.iter().map(|_| None).collect()).collect())
    }

    /// All of them, at an instant.
    pub(super) fn all<E: SignalledRuns>(at: &AtPlanes<'_>, instant: &mut Instant<'_, E>) -> Result<Self, E::Error> {
        let mut all = Self::new(at);
        for (a, arms) in at.0.iter().enumerate() {
            for p in 0..arms.passages.len() {
                all.of(at, (a, p), instant)?;
            }
        }
        Ok(all)
    }

    /// Those of one passage of some arms, both by their numbers.
    fn of<E: SignalledRuns>(
        &mut self,
        at: &AtPlanes<'_>,
        (a, p): (usize, usize),
        instant: &mut Instant<'_, E>,
    ) -> Result<&OfPassage, E::Error> {
        let (arms, place) = (&at.0[a], &mut self.0[a][p]);
        let planes = &arms.passages[p].planes;
        let found = match place.take() {
            Some(known) => known,
            None if planes.is_empty() => {
                let as_they_are = PassRun { ways: Vec::new(), frames: Arc::clone(instant.frames), i: instant.i };
                (vec![as_they_are], 0)
            }
            None => {
                let told: Vec<&[PlanePass]> = planes.iter().map(|&c| arms.ways[c].told.as_slice()).collect();
                runs(&told, instant)?
            }
        };
        Ok(place.insert(found))
    }
}

/// Most instants' robots that one search is asked about.
const MOST_TOGETHER: usize = 48;

impl Occupant {
    /// What arms of a person can do at the planes.
    pub(super) fn at_planes<'a>(&self, posed: Posed<'a>) -> AtPlanes<'a> {
        let Posed { encounter, person, stance } = posed;
        // Arms whose shoulders are on different sides of a plane go different ways.
        let sides = |side: Side| -> Vec<ArmSide> {
            let shoulder = person.body.shoulder(side).translation;
            (0..self.curtains.len()).map(|c| self.side_of(c, person, stance, shoulder)).collect()
        };
        let mut groups: Vec<(Vec<ArmSide>, Vec<Side>)> = Vec::new();
        for &arm in &person.arms {
            let sides = sides(arm);
            match groups.iter_mut().find(|(known, _)| *known == sides) {
                Some((_, arms)) => arms.push(arm),
                None => groups.push((sides, vec![arm])),
            }
        }
        let arms = |(sides, arms): (Vec<ArmSide>, Vec<Side>)| {
            let person = Person { arms, ..person.clone() };
            let ways: Vec<PlanePasses> = (0..sides.len()).map(|c| self.ways(c, sides[c], &person, stance)).collect();
            let shoulders = person.arms.iter().map(|&side| person.body.shoulder(side).translation).collect();
            Arms { encounter, passages: self.passages(&ways), person, sides, ways, shoulders }
        };
        AtPlanes(groups.into_iter().map(arms).collect())
    }

    /// Which planes arms with these ways may pass at once: none, one, or two neighbours.
    fn passages(&self, ways: &[PlanePasses]) -> Vec<Passage> {
        let one = (0..ways.len()).map(|c| vec![c]);
        let two = self.neighbours.iter().map(|&(c, d)| vec![c, d]);
        let passage = |planes: Vec<usize>| {
            let others = (0..ways.len()).filter(|c| !planes.contains(c));
            let walls = others.map(|c| ways[c].untold.as_deref()).collect::<Option<Vec<_>>>()?.concat();
            Some(Passage { planes, walls })
        };
        std::iter::once(Vec::new()).chain(one).chain(two).filter_map(passage).collect()
    }

    /// An unsafe arm contact at an instant: untold by planes, or with the robots as they are when one plane, or
    /// two, told of the arm as long before as the hand needs.
    pub(super) fn reach_past_planes<E: SignalledRuns>(
        &self,
        at: &AtPlanes<'_>,
        runs: &mut PassRuns,
        instant: &mut Instant<'_, E>,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        for (a, arms) in at.0.iter().enumerate() {
            for (p, passage) in arms.passages.iter().enumerate() {
                let (runs, unfinished) = runs.of(at, (a, p), instant)?;
                coverage.arm_runs_not_evaluated += *unfinished;
                let runs: Vec<&PassRun> = runs.iter().collect();
                if let Some((run, found)) = self.first_of(arms, passage, &runs, coverage) {
                    let windows = run.ways.iter().map(|way| way.window).collect();
                    return Ok(Some(Hit { windows, ..Hit::new(found, run.frame()) }));
                }
            }
        }
        Ok(None)
    }

    /// Whether no arm contact above the limit is possible in the runs, all of them asked for, of any of several instants, shown for many of them
    /// at once. `false` says nothing.
    pub(super) fn none_reaches_past_planes(
        &self,
        at: &AtPlanes<'_>,
        instants: &[&PassRuns],
        coverage: &mut Coverage,
    ) -> bool {
        let none = at.0.iter().enumerate().all(|(a, arms)| {
            arms.passages.iter().enumerate().all(|(p, passage)| {
                let mut runs: Vec<&PassRun> =
                    instants.iter().flat_map(|runs| runs.0[a][p].iter().flat_map(|(runs, _)| runs)).collect();
                // Ways from in front and from behind have different walls.
                runs.sort_by_key(|run| run.backs().collect::<Vec<_>>());
                let alike = |a: &&PassRun, b: &&PassRun| a.backs().eq(b.backs());
                runs.chunk_by(alike).all(|runs| self.nobody_reaches(arms, passage, runs, coverage))
            })
        });
        if none {
            let unfinished = instants.iter().flat_map(|runs| runs.0.iter().flatten().flatten()).map(|(_, n)| n);
            coverage.arm_runs_not_evaluated += unfinished.sum::<u64>();
        }
        none
    }

    /// The same for runs whose ways lead to the same sides.
    fn nobody_reaches(&self, arms: &Arms<'_>, passage: &Passage, runs: &[&PassRun], coverage: &mut Coverage) -> bool {
        let Some(first) = runs.first() else { return true };
        // The space open to the widest ways holds that of all: nothing there is nothing for any.
        let widest = |n: usize| runs.iter().map(|run| run.ways[n]).reduce(PlanePass::wider);
        let widest: Vec<PlanePass> = (0..first.ways.len()).filter_map(widest).collect();
        let walls = self.walls_past(passage, &widest);
        // Of runs in which the robots are the same, one stands for all.
        let mut frames: Vec<&RobotFrame> = Vec::new();
        let mut links: Vec<bool> = Vec::new();
        for run in runs {
            let within = self.links_within(arms, passage, run);
            if within.iter().all(|within| !within) {
                continue;
            }
            match frames.iter().position(|known| known.same_outputs(run.frame())) {
                Some(known) => {
                    let all = &mut links[known * within.len()..][..within.len()];
                    all.iter_mut().zip(within).for_each(|(any, within)| *any |= within);
                }
                None => {
                    frames.push(run.frame());
                    links.extend(within);
                }
            }
        }
        let per_frame = first.frame().links.len();
        let mut groups = frames.chunks(MOST_TOGETHER).zip(links.chunks(MOST_TOGETHER * per_frame.max(1)));
        groups.all(|(frames, links)| {
            let space = ArmSpace { walls: &walls, links: Some(links) };
            arms.encounter.no_arm_harmed(&arms.person, frames, &space, coverage)
        })
    }

    /// For each link of a run whether an arm can get hold of it past these planes.
    fn links_within(&self, arms: &Arms<'_>, passage: &Passage, run: &PassRun) -> Vec<bool> {
        let others: Vec<usize> = (0..arms.sides.len()).filter(|c| !passage.planes.contains(c)).collect();
        let reach = self.arm().reach();
        let within = |link: &Solid| {
            let (centre, radius) = link.bounding_sphere();
            arms.shoulders.iter().any(|shoulder| (centre - *shoulder).length() - radius <= reach)
                && run.ways.iter().all(|way| self.in_reach(way, link))
                && others.iter().all(|&c| self.reachable_untold(arms, c, link))
        };
        run.frame().links.iter().map(within).collect()
    }

    /// Whether some part of a link may be touched without plane `c` telling of it.
    fn reachable_untold(&self, arms: &Arms<'_>, c: usize, link: &Solid) -> bool {
        let curtain = &self.curtains[c];
        match arms.sides[c] {
            ArmSide::Front => {
                let reach = self.arm().reach();
                curtain.within(0.0, link)
                    || arms.shoulders.iter().any(|s| !curtain.closed.out_of_reach(*s, reach, link))
            }
            _ => curtain.within(arms.ways[c].untold_limit_m - self.cell.search.reach_tolerance_m, link),
        }
    }

    /// The first of `runs` in which an arm can get hold of a robot in time, and the contact.
    fn first_of<'a>(
        &self,
        arms: &Arms<'_>,
        passage: &Passage,
        runs: &[&'a PassRun],
        coverage: &mut Coverage,
    ) -> Option<(&'a PassRun, Encountered)> {
        let alike = |a: &&PassRun, b: &&PassRun| a.backs().eq(b.backs());
        let mut groups: Vec<&[&PassRun]> = runs.chunk_by(alike).rev().collect();
        while let Some(group) = groups.pop() {
            if let [run] = group {
                let (walls, links) = (self.walls_past(passage, &run.ways), self.links_within(arms, passage, run));
                let space = ArmSpace { walls: &walls, links: Some(&links) };
                let found = arms.encounter.unsafe_arm_contact(&arms.person, run.frame(), &space, coverage);
                if let Some(found) = found {
                    return Some((run, found));
                }
            } else if !self.nobody_reaches(arms, passage, group, coverage) {
                let (first, second) = group.split_at(group.len() / 2);
                groups.extend([second, first]);
            }
        }
        None
    }

    /// What an arm does not pass on these ways past the planes of a passage.
    fn walls_past(&self, passage: &Passage, ways: &[PlanePass]) -> Vec<Cuboid> {
        passage.walls.iter().copied().chain(ways.iter().flat_map(|way| self.walls_of(way))).collect()
    }

    /// What an arm does not pass on a way past a plane: what is out of the hand's reach, and a plane that is clear.
    fn walls_of(&self, way: &PlanePass) -> Vec<Cuboid> {
        let curtain = &self.curtains[way.window.curtain];
        let out_of_reach = if way.back { curtain.before(way.limit_m) } else { curtain.beyond(way.limit_m) };
        std::iter::once(out_of_reach).chain(way.closed.then(|| curtain.unbroken())).collect()
    }

    /// Whether a hand on a way past a plane can get hold of a link, and still could with the arm moved by the tolerance: the
    /// guarantee of the arm search asks for no more, and thin layers of space cost it most.
    fn in_reach(&self, way: &PlanePass, link: &Solid) -> bool {
        let far = way.limit_m - self.cell.search.reach_tolerance_m;
        let curtain = &self.curtains[way.window.curtain];
        if way.back { curtain.within_before(far, link) } else { curtain.within(far, link) }
    }

    /// Where an arm with this shoulder is with regard to plane `c`.
    fn side_of(&self, c: usize, person: &Person, stance: &PersonState, shoulder: Vec3) -> ArmSide {
        let curtain = &self.curtains[c];
        let behind = curtain.depth(shoulder) > 0.0;
        match (curtain.hands_only, behind) {
            (true, _) if stance.broken[c] > 0 => ArmSide::In,
            (true, false) => ArmSide::Front,
            (true, true) => ArmSide::LeansOver,
            _ if breaks(&person.body, &curtain.plane) => ArmSide::In,
            (false, false) => ArmSide::Front,
            (false, true) => ArmSide::Behind,
        }
    }

    /// How deep behind a plane a hand can be after so many steps, m.
    fn depth_m(&self, steps: usize) -> f64 {
        detection_plane::depth_m(steps, self.cell.step_s, self.fastest_m_s())
    }

    /// How deep every hand can be after so many steps, of who runs and who does not, m: so long ways past a plane are looked for.
    fn at_least_m(&self, steps: usize) -> f64 {
        detection_plane::depth_m(steps, self.cell.step_s, 0.0)
    }

    /// The ways of an arm on this side of plane `c`.
    fn ways(&self, c: usize, side: ArmSide, person: &Person, stance: &PersonState) -> PlanePasses {
        let (curtain, since) = (&self.curtains[c], stance.broken[c]);
        let reach = self.arm().reach();
        let depths = person.arms.iter().map(|&arm| curtain.depth(person.body.shoulder(arm).translation));
        let (nearest, deepest) = depths.fold((f64::MAX, f64::MIN), |(n, d), depth| (n.min(depth), d.max(depth)));
        let (deepest, most_before) = (deepest + reach, reach - nearest);
        // Whoever came another way, or long ago, is held back by nothing.
        let is_held = since != LONG_AGO && !(side == ArmSide::Behind && since == 0);
        let free = curtain.lets_below || !is_held;
        let untold_limit_m = match side {
            ArmSide::Front | ArmSide::LeansOver => 0.0,
            ArmSide::In | ArmSide::Behind if free => f64::INFINITY,
            ArmSide::In | ArmSide::Behind => self.depth_m(since + 1),
        };
        let mut untold = Vec::new();
        if matches!(side, ArmSide::Front | ArmSide::Behind) {
            untold.push(curtain.unbroken());
        }
        if matches!(side, ArmSide::In | ArmSide::Behind) && untold_limit_m < deepest {
            untold.push(curtain.beyond(untold_limit_m));
        }
        let told = |from: usize, until: usize, back: bool| PlanePass {
            window: Window { curtain: c, from, until },
            limit_m: self.depth_m(from + 1),
            back,
            closed: side == ArmSide::Behind && !back,
        };
        let through = |most: f64, back: bool| {
            let in_time = move |&s: &usize| s == 0 || self.at_least_m(s) < most;
            (0..).take_while(in_time).map(move |s| told(s, 0, back)).filter(move |_| most > 0.0)
        };
        let ahead = |until: usize| {
            let needed = move |j: &usize| self.at_least_m(since + j) < deepest;
            (1..).take_while(needed).take_while(|_| is_held).map(move |j| told(since + j, until, false))
        };
        // The body is told of from then on, but not where the FMU sees it itself, maybe later: the arm is still there then.
        let until = if self.is_evaluated(c) { 0 } else { since };
        let told: Vec<PlanePass> = match side {
            ArmSide::Front | ArmSide::LeansOver => through(deepest, false).collect(),
            ArmSide::In => ahead(until).collect(),
            ArmSide::Behind => ahead(since).chain(through(most_before, true)).collect(),
        };
        PlanePasses { untold: (side != ArmSide::LeansOver).then_some(untold), untold_limit_m, told }
    }

    /// In which windows planes may have told of an arm, for a person at this place: every one that a pose of it may ask
    /// [`SignalledRuns`] for.
    #[must_use]
    pub fn windows_that_may_matter(&self, place: &Place, broken: &[usize]) -> Vec<Asked> {
        let (at, arm) = (self.position(place) + Vec3::Z, self.arm().reach());
        let of = |(curtain, &since): (&DetectionPlane, &usize)| {
            let depth = curtain.depth(at);
            let deepest = depth + self.reach_m();
            let samples = |most: f64| (0..).take_while(|&s| self.at_least_m(s) < most).count();
            // Nobody so far in front reaches the plane, and nobody so far behind reaches back through it.
            let near = deepest > 0.0 && depth < SHOULDER_WITHIN_M + arm;
            let through = if near { samples(deepest.max(arm + SHOULDER_WITHIN_M)) } else { 0 };
            let ahead = if since == 0 || since == LONG_AGO { 0 } else { samples(deepest).saturating_sub(since) };
            let until_now = ahead > 0 && self.cell_evaluates(curtain);
            Asked { through, ahead, since: if ahead > 0 { since } else { 0 }, until_now }
        };
        self.curtains.iter().zip(broken).map(of).collect()
    }

    /// In which windows until now plane `c` may have told of an arm, as far as that decides what an arm meets later: for a
    /// person who is at this place and was first seen in the plane `since` samples ago.
    ///
    /// A window matters as long as the hand is not for sure deeper than it reaches. No part of the body, and no hand, is
    /// farther from the middle of the feet than `Occupant::reach_m`, and these walk slower than a hand moves, so a window that is
    /// long enough now would be so later. Who is first seen later than now is no farther behind the plane then, or, at a
    /// two-hand control, where it is let go.
    #[must_use]
    pub(crate) fn windows_that_will_matter(&self, place: &Place, c: usize, since: usize) -> Vec<Window> {
        let curtain = &self.curtains[c];
        let (at, reach) = (self.position(place) + Vec3::Z, self.reach_m());
        let depth = curtain.depth(at).max(0.0);
        let samples = |deepest: f64| (0..).find(|&s| self.at_least_m(s) >= deepest).unwrap_or(0);
        // What was sensed and has not taken effect will.
        let delay = self.cell.sensors[curtain.sensor].delay_steps;
        let first_seen = if curtain.hands_only { depth.max(reach) } else { reach };
        // Who runs may get farther behind the plane than a hand does in that time: any window may matter later.
        let runs = self.fastest_m_s() > HAND_SPEED_M_S;
        let longest = samples(first_seen + reach).max(if runs { LONG_AGO } else { 0 }) + delay;
        let through = (1..=longest).map(|from| Window { curtain: c, from, until: 0 });
        let is_tracked = since > 0 && since < LONG_AGO;
        let ahead = if runs { LONG_AGO } else { samples(depth + reach) };
        let longest = if is_tracked { ahead } else { 0 };
        let ahead = (since + 1..=longest).map(|from| Window { curtain: c, from, until: since });
        let until_now = (since + 1..=longest).filter(|_| self.is_evaluated(c));
        let until_now = until_now.map(|from| Window { curtain: c, from, until: 0 });
        through.chain(ahead).chain(until_now).collect()
    }

    /// Whether the FMU sees bodies in plane `c` itself.
    fn is_evaluated(&self, c: usize) -> bool {
        self.cell_evaluates(&self.curtains[c])
    }

    fn cell_evaluates(&self, curtain: &DetectionPlane) -> bool {
        self.binding.sensors[curtain.sensor].is_evaluated()
    }

    /// Whether the body could have come as far as `point` behind each plane that it is in. Who holds a two-hand control may
    /// lean over it; who is not in a plane passed it before, or went round it.
    pub(super) fn in_time(&self, point: Vec3, person: &Person, stance: &PersonState) -> bool {
        self.curtains.iter().enumerate().filter(|(_, curtain)| !curtain.hands_only).all(|(c, curtain)| {
            let since = stance.broken[c];
            since == LONG_AGO
                || curtain.lets_below
                || curtain.depth(point) <= self.depth_m(since + 1) + curtain.legs_below_m
                || !breaks(&person.body, &curtain.plane)
        })
    }
}

/// The windows of one plane that may be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Asked {
    /// In the last 0, 1, 2, ... samples until now, so many.
    through: usize,
    /// In the 1, 2, ... samples before the body was first seen, so many.
    ahead: usize,
    /// How many samples ago that was.
    since: usize,
    /// Whether those are asked for until now, too.
    until_now: bool,
}

impl Asked {
    /// All of them: of one plane, and of two `neighbours` at once.
    #[must_use]
    pub fn windows(asked: &[Self], neighbours: &[(usize, usize)]) -> Vec<Vec<Window>> {
        let of = |(curtain, asked): (usize, &Self)| -> Vec<Window> {
            let through = (0..asked.through).map(|from| Window { curtain, from, until: 0 });
            let ahead = (1..=asked.ahead).map(|j| Window { curtain, from: asked.since + j, until: asked.since });
            let until_now = (1..=asked.ahead).filter(|_| asked.until_now);
            let until_now = until_now.map(|j| Window { curtain, from: asked.since + j, until: 0 });
            through.chain(ahead).chain(until_now).collect()
        };
        let windows: Vec<Vec<Window>> = asked.iter().enumerate().map(of).collect();
        let mut all: Vec<Vec<Window>> = windows.iter().flatten().map(|window| vec![*window]).collect();
        for &(c, d) in neighbours {
            all.extend(windows[c].iter().flat_map(|a| windows[d].iter().map(|b| vec![*a, *b])));
        }
        all
    }
}

/// The robots of each way past one plane, or of each pair of ways past two; ways by the time they take, as long as there is
/// time. Those that the FMU could not finish are left out; the second number counts them.
fn runs<E: SignalledRuns>(told: &[&[PlanePass]], instant: &mut Instant<'_, E>) -> Result<OfPassage, E::Error> {
    let i = instant.i;
    let (mut runs, mut unfinished): OfPassage = (Vec::new(), 0);
    let Some((last, before)) = told.split_last() else { return Ok((runs, unfinished)) };
    let before: Vec<Vec<PlanePass>> = match before {
        [ways] => ways.iter().map(|way| vec![*way]).collect(),
        _ => vec![Vec::new()],
    };
    for besides in before {
        for of_kind in last.chunk_by(|a, b| a.back == b.back) {
            let first = runs.len();
            for &way in of_kind {
                let ways: Vec<PlanePass> = besides.iter().copied().chain([way]).collect();
                let windows: Vec<Window> = ways.iter().map(|way| way.window).collect();
                let frames = match instant.earlier.told_of(&windows)? {
                    IfSignalled::Is(frames) => frames,
                    IfSignalled::BeforeTime => break,
                    IfSignalled::Unfinished => {
                        unfinished += 1;
                        continue;
                    }
                };
                // Of instants at which the robots are the same, the last leaves the hand the most time.
                if runs[first..].last().is_some_and(|last| last.frames[i].same_outputs(&frames[i])) {
                    runs.pop();
                }
                runs.push(PassRun { ways, frames, i });
            }
        }
    }
    Ok((runs, unfinished))
}
