//! Poses of an arm against links and solids.
//!
//! Two ways. First a grid over the four angles and, from its best poses on, small steps: for a pose that stays a contact above
//! the limit when the arm moves a little (certain). Where that finds not even a bare contact, the box of all angles is
//! divided, and a part is left where no pose of it can touch, by the most that a point of the arm moves within it: if all parts
//! are left, there is none. What neither decides is uncertain.

use super::force::{Criterion, Region, Speeds, class, safe_speed};
use super::geometry::{M3, Solid, V3, about, add, between, length, product, scaled, sub, turned};
use super::robot::{Link, Robot};

/// For upper arm, forearm and hand: links that they may come near to, with the ends of their pieces.
type Near = [Vec<(usize, Vec<[V3; 2]>)>; 3];

pub const UPPER: f64 = 0.30;
pub const FORE: f64 = 0.32;
const ELBOW: f64 = 0.06;
pub const UPPER_RADIUS: f64 = 0.055;
const FORE_RADIUS: f64 = 0.045;
pub const HAND: f64 = 0.23;
const SHOULDER_FREE: f64 = 0.075;
/// How far from the shoulder each region can touch, with a hand of which nothing is farther from the wrist than this.
const fn reaches(hand: f64) -> [(Region, f64); 3] {
    [
        ("upper_arm", UPPER + ELBOW + UPPER_RADIUS),
        ("lower_arm", UPPER + FORE + FORE_RADIUS),
        ("hand", UPPER + FORE + hand),
    ]
}

/// One angle at a time, and two that often go together.
pub const DIRECTIONS: [[f64; 4]; 14] = [
    [1.0, 0.0, 0.0, 0.0],
    [-1.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0],
    [0.0, -1.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, -1.0, 0.0],
    [0.0, 0.0, 0.0, 1.0],
    [0.0, 0.0, 0.0, -1.0],
    [1.0, 1.0, 0.0, 0.0],
    [-1.0, -1.0, 0.0, 0.0],
    [1.0, 0.0, -1.0, 0.0],
    [-1.0, 0.0, 1.0, 0.0],
    [0.0, 0.7, 0.0, -1.0],
    [0.0, -0.7, 0.0, 1.0],
];
/// What is not decided by then is uncertain.
const MOST_BOXES: usize = 15_000;

#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    None,
    Uncertain,
    Certain,
}

/// Angles in degrees: abduction, flexion, rotation, elbow.
pub type Angles = [f64; 4];

fn flexion(a: f64) -> [f64; 2] {
    [-60.0 + a / 3.0, 170.0 - a / 6.0]
}

fn rotation(a: f64, f: f64) -> [f64; 2] {
    [-60.0 + 7.0 * a / 9.0 - f / 9.0 + 2.0 * a * f / 810.0, 90.0 + 4.0 * a / 9.0 - 5.0 * f / 9.0 + 5.0 * a * f / 810.0]
}

/// Whether all angles are within their ranges, by these margins.
pub fn within([a, f, r, e]: Angles, margin: [f64; 4]) -> bool {
    let inside = |x: f64, [low, high]: [f64; 2], m: f64| low + m <= x && x <= high - m;
    inside(a, [-10.0, 170.0], margin[0])
        && inside(f, flexion(a), margin[1])
        && inside(r, rotation(a, f), margin[2])
        && inside(e, [0.0, 150.0], margin[3])
}

/// A pose in the world.
#[derive(Debug, Clone, Copy)]
pub struct Pose {
    pub shoulder: V3,
    pub elbow: V3,
    pub wrist: V3,
}

impl Pose {
    pub fn upper(&self) -> [V3; 2] {
        [self.shoulder, self.elbow]
    }
    pub fn upper_that_counts(&self) -> [V3; 2] {
        [between(self.shoulder, self.elbow, SHOULDER_FREE / UPPER), self.elbow]
    }
    pub fn fore(&self) -> [V3; 2] {
        [self.elbow, self.wrist]
    }
    /// Upper arm, elbow, rest of the forearm: axis, radius, region.
    pub fn limbs(&self) -> [([V3; 2], f64, Region); 3] {
        let cut = between(self.elbow, self.wrist, ELBOW / FORE);
        [
            (self.upper(), UPPER_RADIUS, "upper_arm"),
            ([self.elbow, cut], FORE_RADIUS, "upper_arm"),
            ([cut, self.wrist], FORE_RADIUS, "lower_arm"),
        ]
    }
}

/// The pose that follows from the angles: `m` is 1 for the left arm, -1 for the right one.
pub fn pose(shoulder: V3, trunk: &M3, m: f64, [a, f, r, e]: Angles) -> Pose {
    let turn = |axis: usize, degrees: f64| about(super::geometry::UNIT[axis], degrees.to_radians());
    let upper = product(&turn(0, m * a), &turn(1, -f));
    let fore = product(&upper, &product(&turn(2, -m * r), &turn(1, -e)));
    let elbow = add(shoulder, turned(trunk, turned(&upper, [0.0, 0.0, -UPPER])));
    let wrist = add(elbow, turned(trunk, turned(&fore, [0.0, 0.0, -FORE])));
    Pose { shoulder, elbow, wrist }
}

/// By how much the hand has to move, at most, to bring all angles into their ranges, m; negative within them.
pub fn beyond_limits([a, f, r, e]: Angles) -> f64 {
    let beyond = |x: f64, [low, high]: [f64; 2], radius: f64| (low - x).max(x - high).to_radians() * radius;
    beyond(a, [-10.0, 170.0], UPPER + FORE)
        .max(beyond(f, flexion(a), UPPER + FORE))
        .max(beyond(r, rotation(a, f), FORE))
        .max(beyond(e, [0.0, 150.0], FORE))
}

/// Angles spread over their ranges.
pub fn grid() -> Vec<Angles> {
    let steps = |low: f64, high: f64, count: u32| {
        (0..count).map(move |i| low + (high - low) * (f64::from(i) + 0.5) / f64::from(count))
    };
    let mut all = Vec::new();
    for a in steps(-10.0, 170.0, 8) {
        let [low, high] = flexion(a);
        for f in steps(low, high, 9) {
            let [low, high] = rotation(a, f);
            all.extend(steps(low, high, 7).flat_map(|r| steps(0.0, 150.0, 6).map(move |e| [a, f, r, e])));
        }
    }
    all
}

/// What an arm is asked about.
pub struct Question<'a> {
    pub shoulder: V3,
    /// World from trunk.
    pub trunk: M3,
    /// 1 for the left arm, -1 for the right one.
    pub side: f64,
    /// The velocity at which the person walks.
    pub walking: V3,
    pub criterion: Criterion,
    pub robot: &'a Robot,
    pub solids: &'a [Solid],
    /// Nothing of the hand, or of what it holds, is farther from the wrist, m.
    pub hand: f64,
    /// By how much the arm may move at a certain contact, m: no less than the program's tolerance.
    pub tight: f64,
}

/// A contact above the limit.
#[derive(Debug, Clone)]
pub struct Touch {
    pub region: Region,
    pub link: String,
    pub point: V3,
    pub speeds: Speeds,
}

impl Question<'_> {
    pub fn pose(&self, angles: Angles) -> Pose {
        pose(self.shoulder, &self.trunk, self.side, angles)
    }

    /// How free the pose is: negative where it is not, m. With `slack`, only what stays when upper arm and wrist move so.
    fn clearance(&self, pose: &Pose) -> (f64, f64) {
        let (mut upper, mut fore) = (f64::MAX, f64::MAX);
        for solid in self.solids {
            upper = upper.min(solid.gap(pose.upper())).min(solid.gap(pose.upper_that_counts()) - UPPER_RADIUS);
            fore = fore.min(solid.gap(pose.fore()) - FORE_RADIUS);
        }
        (upper, fore)
    }

    fn line_depth(&self, wrist: V3, point: V3) -> f64 {
        self.solids.iter().map(|s| s.gap([wrist, point])).fold(f64::MAX, f64::min)
    }

    /// The point of a link at which the hand touches it, and the distance from the wrist.
    fn hand(link: &Link, wrist: V3) -> (V3, f64) {
        let (point, gap) = link.surface([wrist, wrist]);
        if gap < 0.0 { (wrist, 0.0) } else { (point, gap) }
    }

    /// Of a point that an arm touches: how the arm itself moves is not known, so the direction does not count.
    fn speeds(&self, link: &Link, point: V3) -> Speeds {
        Speeds { own: link.speed(point), towards: length(sub(link.moves(point), self.walking)) }
    }

    fn touches(&self, pose: &Pose) -> Vec<Touch> {
        let mut all = Vec::new();
        let mut offer = |region: Region, link: &Link, point: V3| {
            let speeds = self.speeds(link, point);
            if class(region, self.robot.effective_mass, speeds, self.criterion).is_some() {
                all.push(Touch { region, link: link.name.clone(), point, speeds });
            }
        };
        for link in &self.robot.links {
            for (axis, radius, region) in pose.limbs() {
                let (point, gap) = link.surface(axis);
                if gap <= radius {
                    offer(region, link, point);
                }
            }
            let (point, gap) = Self::hand(link, pose.wrist);
            if gap <= self.hand && self.line_depth(pose.wrist, point) >= 0.0 {
                offer("hand", link, point);
            }
        }
        all
    }

    /// Contacts above the limit of a pose that is free of solids; none if it is not.
    pub fn contacts(&self, pose: &Pose) -> Vec<Touch> {
        let (upper, fore) = self.clearance(pose);
        if upper < -1e-9 || fore < -1e-9 { Vec::new() } else { self.touches(pose) }
    }

    /// Pieces of links that are fast enough for a region and within reach of the shoulder.
    fn near(&self, region: Region, reach: f64) -> Vec<(usize, Vec<[V3; 2]>)> {
        let safe = safe_speed(region, self.robot.effective_mass);
        // Whatever the direction: the person at most adds their own speed, and what stands hits nobody.
        let fastest = |own: f64| Speeds { own, towards: own + length(self.walking) }.decides(self.criterion);
        let mut all = Vec::new();
        for (i, link) in self.robot.links.iter().enumerate() {
            let fast: Vec<[V3; 2]> = link
                .pieces
                .iter()
                .filter(|(core, speed)| {
                    let (p, q) = super::geometry::nearest([self.shoulder; 2], *core);
                    fastest(*speed) > safe && length(sub(p, q)) <= reach + link.radius
                })
                .map(|piece| piece.0)
                .collect();
            if !fast.is_empty() {
                all.push((i, fast));
            }
        }
        all
    }

    /// Whether any link that is fast enough for any part of an arm is within its reach.
    pub fn in_reach(&self) -> bool {
        let near = |(region, reach): (Region, f64)| !self.near(region, reach).is_empty();
        reaches(self.hand).into_iter().any(near)
    }

    pub fn verdict(&self) -> Verdict {
        let near = reaches(self.hand).map(|(region, reach)| self.near(region, reach));
        if near.iter().all(Vec::is_empty) {
            return Verdict::None;
        }
        match self.tried() {
            least if least <= 0.0 => Verdict::Certain,
            least if least <= self.tight => Verdict::Uncertain,
            _ if self.possible_at_all(&near) => Verdict::Uncertain,
            _ => Verdict::None,
        }
    }

    /// What is missing at best to a contact that stays one when the arm moves a little, m: by a grid over the angles, and
    /// from its best poses on by smaller and smaller steps of one angle after the other.
    fn tried(&self) -> f64 {
        let mut best = [(f64::MAX, [0.0; 4]); 8];
        let steps = |low: f64, high: f64, count: u32| {
            (0..count).map(move |i| low + (high - low) * (f64::from(i) + 0.5) / f64::from(count))
        };
        for a in steps(-10.0, 170.0, 7) {
            let [low, high] = flexion(a);
            for f in steps(low, high, 8) {
                let [low, high] = rotation(a, f);
                for r in steps(low, high, 6) {
                    for e in steps(0.0, 150.0, 5) {
                        let missing = self.missing([a, f, r, e]);
                        if missing < best[7].0 {
                            best[7] = (missing, [a, f, r, e]);
                            best.sort_by(|a, b| a.0.total_cmp(&b.0));
                        }
                    }
                }
            }
        }
        let mut least = f64::MAX;
        for (mut missing, mut at) in best {
            let mut step = 8.0;
            while step > 0.2 && missing > 0.0 {
                let mut better = false;
                for direction in DIRECTIONS {
                    let mut next = at;
                    next.iter_mut().zip(direction).for_each(|(x, d)| *x += step * d);
                    let there = self.missing(next);
                    if there < missing {
                        (missing, at, better) = (there, next, true);
                    }
                }
                if !better {
                    step *= 0.5;
                }
            }
            least = least.min(missing);
            if least <= 0.0 {
                break;
            }
        }
        least
    }

    /// What is missing to a contact that stays one when the arm moves a little, m.
    fn missing(&self, angles: Angles) -> f64 {
        let pose = self.pose(angles);
        let limits = beyond_limits(angles);
        let (upper, fore) = self.clearance(&pose);
        let mut contact = f64::MAX;
        for link in &self.robot.links {
            let mut offer = |region: Region, point: V3, apart: f64| {
                let surely = self.speeds(link, point).changed(-2.0 * self.tight * length(link.spin));
                let surely = surely.decides(self.criterion);
                let slow = (safe_speed(region, self.robot.effective_mass) - surely).max(0.0);
                contact = contact.min(if slow > 0.0 { apart.max(0.0) + 0.1 + slow } else { apart });
            };
            for (axis, radius, region) in pose.limbs() {
                let (point, gap) = link.surface(axis);
                offer(region, point, gap - radius);
            }
            let (point, gap) = Self::hand(link, pose.wrist);
            offer("hand", point, (gap - self.hand).max(-self.line_depth(pose.wrist, point)));
        }
        contact.max(limits).max(-upper).max(-fore) + self.tight
    }

    /// Whether a contact in a box of these half widths around a pose is possible, when the upper arm moves by `upper` and
    /// the wrist by `wrist`.
    fn possible(&self, near: &Near, pose: &Pose, (upper, wrist): (f64, f64)) -> bool {
        let limbs = pose.limbs();
        let reaches = |axis: [V3; 2], radius: f64, moves: f64, region: usize| {
            near[region].iter().any(|(i, fast)| {
                let link = &self.robot.links[*i];
                fast.iter().any(|core| {
                    let (p, q) = super::geometry::nearest(axis, *core);
                    length(sub(p, q)) - link.radius - radius <= moves
                })
            })
        };
        if reaches(limbs[0].0, limbs[0].1, upper, 0)
            || reaches(limbs[1].0, limbs[1].1, wrist, 0)
            || reaches(limbs[2].0, limbs[2].1, wrist, 1)
        {
            return true;
        }
        near[2].iter().any(|(i, fast)| {
            let link = &self.robot.links[*i];
            let (point, _) = Self::hand(link, pose.wrist);
            // The nearest point of a convex link moves no farther than the wrist.
            let fastest = self.speeds(link, point).changed(length(link.spin) * wrist);
            class("hand", self.robot.effective_mass, fastest, self.criterion).is_some()
                && self.line_depth(pose.wrist, point) >= -wrist
                && fast.iter().any(|core| {
                    let (p, q) = super::geometry::nearest([pose.wrist; 2], *core);
                    length(sub(p, q)) - link.radius - self.hand <= wrist
                })
        })
    }

    /// Whether a contact above the limit is possible at all: the box of all angles divided, until each part is left.
    fn possible_at_all(&self, near: &Near) -> bool {
        // Where a box is not divided any more.
        let finest = 0.3 * self.tight;
        // Middle and half widths of each box, degrees.
        let mut boxes: Vec<([f64; 4], [f64; 4])> = vec![([80.0, 55.0, 70.0, 75.0], [90.0, 120.0, 180.0, 75.0])];
        let mut looked = 0;
        while let Some((middle, half)) = boxes.pop() {
            looked += 1;
            if looked > MOST_BOXES {
                return true;
            }
            if !ranges_meet(middle, half) {
                continue;
            }
            let pose = self.pose(middle);
            let [a, f, r, e] = half.map(f64::to_radians);
            let bent = [(middle[3] - half[3]).max(0.0), (middle[3] + half[3]).min(150.0)].map(f64::to_radians);
            // From the shoulder to the wrist, and from the axis of the upper arm to the wrist, at most.
            let far = (UPPER * UPPER + FORE * FORE + 2.0 * UPPER * FORE * libm::cos(bent[0])).sqrt();
            let right = std::f64::consts::FRAC_PI_2;
            let off = FORE * libm::sin(right.clamp(bent[0], bent[1]));
            let moves = [far * a, far * f, off * r, FORE * e];
            let upper = UPPER * (a + f);
            let wrist = moves.iter().sum::<f64>().max(upper);
            let (free_upper, free_fore) = self.clearance(&pose);
            if free_upper < -upper || free_fore < -wrist {
                continue;
            }
            if !self.possible(near, &pose, (upper, wrist)) {
                continue;
            }
            let free = free_upper >= 0.0 && free_fore >= 0.0;
            if wrist < finest || (free && within(middle, [0.0; 4]) && !self.touches(&pose).is_empty()) {
                return true;
            }
            let widest = (0..4).fold(0, |best, i| if moves[i] > moves[best] { i } else { best });
            let mut narrow = half;
            narrow[widest] *= 0.5;
            let mut parts = [-1.0, 1.0].map(|sign| {
                let mut at = middle;
                at[widest] += sign * narrow[widest];
                let wrist = self.pose(at).wrist;
                let gap = |i: &usize| self.robot.links[*i].surface([wrist; 2]).1;
                (near.iter().flatten().map(|n| gap(&n.0)).fold(f64::MAX, f64::min), at)
            });
            // The nearer one first.
            parts.sort_by(|a, b| b.0.total_cmp(&a.0));
            boxes.extend(parts.map(|(_, at)| (at, narrow)));
        }
        false
    }
}

/// Whether a box has a pose within the ranges: those that depend on other angles are extreme at the corners.
fn ranges_meet(middle: [f64; 4], half: [f64; 4]) -> bool {
    let low = |i: usize| middle[i] - half[i];
    let high = |i: usize| middle[i] + half[i];
    if high(0) < -10.0 || low(0) > 170.0 || low(3) > 150.0 || high(3) < 0.0 {
        return false;
    }
    let ends = [low(0), high(0)];
    let least = ends.map(|a| flexion(a)[0]).into_iter().fold(f64::MAX, f64::min);
    let most = ends.map(|a| flexion(a)[1]).into_iter().fold(f64::MIN, f64::max);
    if high(1) < least || low(1) > most {
        return false;
    }
    let corners = ends.into_iter().flat_map(|a| [low(1), high(1)].map(|f| rotation(a, f)));
    let (least, most) = corners.fold((f64::MAX, f64::MIN), |(l, h), [low, high]| (l.min(low), h.max(high)));
    high(2) >= least && low(2) <= most
}

/// Angles that give this pose, degrees: at most two sets, as flexion beyond 90 degrees is abduction from the other side.
pub fn angles(trunk: &M3, side: f64, pose: &Pose) -> Vec<Angles> {
    let back = |v: V3| super::geometry::turned_back(trunk, v);
    let u = scaled(back(sub(pose.elbow, pose.shoulder)), 1.0 / UPPER);
    let w = scaled(back(sub(pose.wrist, pose.elbow)), 1.0 / FORE);
    let near = libm::asin(u[0].clamp(-1.0, 1.0));
    let mut all = Vec::new();
    for f in [near, std::f64::consts::PI - near] {
        let c = if libm::cos(f) < 0.0 { -1.0 } else { 1.0 };
        let mut a = side * libm::atan2(u[1] * c, -u[2] * c);
        if a < -0.5 * std::f64::consts::PI {
            a += 2.0 * std::f64::consts::PI;
        }
        let upper = product(&about([1.0, 0.0, 0.0], side * a), &about([0.0, 1.0, 0.0], -f));
        let local = super::geometry::turned_back(&upper, w);
        let e = libm::acos((-local[2]).clamp(-1.0, 1.0));
        let r = -side * libm::atan2(local[1], local[0]);
        all.push([a, f, r, e].map(f64::to_degrees));
        all.push([a, f, r + 2.0 * std::f64::consts::PI, e].map(f64::to_degrees));
        all.push([a, f, r - 2.0 * std::f64::consts::PI, e].map(f64::to_degrees));
    }
    all
}
