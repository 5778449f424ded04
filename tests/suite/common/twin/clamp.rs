//! Clamping, written a second time from the page `docs/src/howto/criteria.md` alone: no search, but every few millimetres of
//! each link's surface looked at, in both directions of the push.
//!
//! The program promises to find what stays clamped when the point or the arm moves by its tolerance, and to tell of nothing that
//! is none. So what is found here has two degrees: *bare*, where a point satisfies the rules as they stand, and *certain*, where
//! all points around it do, too. What the program tells is looked at by itself ([`Scene::is_true`]): it names the point.

use super::arm::{self, Pose};
use super::body::{Body, Part, shoulder};
use super::force::{FACE, Region, SKULL, THROAT};
use super::geometry::{
    M3, Solid, V3, add, between, cross, dot, length, nearest, nearest_on, scaled, sub, turned, turned_back,
};

/// Both surfaces face the push at least so well.
const FACING: f64 = 0.5;
const HAND: f64 = 0.23;
const FORE_RADIUS: f64 = 0.045;

/// The gap of ISO 13854 for a region, m.
pub fn iso_gap(region: Region) -> f64 {
    match region {
        "chest" | "back_shoulders" | "abdomen" | "pelvis" => 0.5,
        SKULL | FACE | THROAT | "neck" => 0.3,
        "thigh" | "lower_leg" => 0.18,
        "upper_arm" | "lower_arm" => 0.12,
        "hand" => 0.1,
        other => panic!("no region: {other}"),
    }
}

/// Spring constant, N/m, and quasi-static limit, N: of A.2, or the stricter that the energies of A.4 imply.
pub fn spring_and_limit(region: Region) -> (f64, f64) {
    match region {
        SKULL => (150e3, 130.0),
        FACE => (75e3, 65.0),
        THROAT | "neck" => (50e3, 145.0),
        "back_shoulders" => (35e3, 210.0),
        "chest" => (25e3, 140.0),
        "abdomen" => (10e3, 110.0),
        "pelvis" => (25e3, 180.0),
        "upper_arm" => (30e3, 150.0),
        "lower_arm" => (40e3, 160.0),
        "hand" => (75e3, 135.0),
        "thigh" => (50e3, 220.0),
        "lower_leg" => (60e3, 125.0),
        other => panic!("no region: {other}"),
    }
}

/// The speed of closing above which a region is clamped too hard by a robot of this effective mass, m/s.
pub fn bearable(region: Region, m_r: f64) -> f64 {
    let (k, limit) = spring_and_limit(region);
    limit / (m_r * k).sqrt()
}

/// Why a point is none where a part of the body can be: it is in another link that the same joint carries.
pub const IN_ITS_NEIGHBOUR: &str = "the point is in another link of the same joint";

/// A box, turned in any way.
#[derive(Debug, Clone, Copy)]
pub struct Block {
    pub centre: V3,
    pub half: V3,
    pub rotation: M3,
}

impl Block {
    fn local(&self, p: V3) -> V3 {
        turned_back(&self.rotation, sub(p, self.centre))
    }

    pub fn holds(&self, p: V3) -> bool {
        let at = self.local(p);
        (0..3).all(|i| at[i].abs() < self.half[i])
    }

    /// As [`Solid::gap`].
    pub fn gap(&self, s: [V3; 2]) -> f64 {
        Solid::Box { low: scaled(self.half, -1.0), high: self.half }.gap(s.map(|p| self.local(p)))
    }

    /// Whether it keeps a part of the body from a link, by the page on the method: the part's axis is all on one side of the
    /// middle plane across the shortest edge, the link all on the other, and the circle in which that plane cuts the part is
    /// within the faces.
    fn keeps(&self, part: &Part, link: &Moving) -> bool {
        let thin = (0..3).fold(0, |best, i| if self.half[i] < self.half[best] { i } else { best });
        let at = part.core.map(|p| self.local(p));
        let side = at[0][thin].signum();
        let [near, link_near] = [at, link.core.map(|p| self.local(p))].map(|ends| ends.map(|p| p[thin] * side));
        let near = near[0].min(near[1]);
        if near <= 0.0 || near >= part.radius || link_near[0].max(link_near[1]) + link.radius > 0.0 {
            return false;
        }
        let across = (part.radius * part.radius - near * near).sqrt();
        (0..3).all(|i| i == thin || at.into_iter().all(|p| p[i].abs() + across <= self.half[i]))
    }

    /// Where a ray from outside enters: how far, and the outward normal there.
    fn entered(&self, p: V3, u: V3) -> Option<(f64, V3)> {
        let (at, along) = (self.local(p), turned_back(&self.rotation, u));
        let (mut first, mut last, mut face) = (f64::MIN, f64::MAX, None);
        for i in 0..3 {
            if along[i] == 0.0 {
                if at[i].abs() > self.half[i] {
                    return None;
                }
                continue;
            }
            let [a, b] = [-1.0, 1.0].map(|side| (side * self.half[i] - at[i]) / along[i]);
            if a.min(b) > first {
                let mut normal = [0.0; 3];
                normal[i] = -along[i].signum();
                (first, face) = (a.min(b), Some(normal));
            }
            last = last.min(a.max(b));
        }
        let face = face.filter(|_| first >= 0.0 && first <= last)?;
        Some((first, turned(&self.rotation, face)))
    }
}

/// A link of a robot: a capsule and how it moves.
#[derive(Debug, Clone, Copy)]
pub struct Moving {
    pub core: [V3; 2],
    pub radius: f64,
    /// A point of the frame that carries it, its velocity, and the angular velocity.
    pub origin: V3,
    pub velocity: V3,
    pub spin: V3,
    /// What carries it: links with the same number do not close on each other.
    pub carrier: usize,
    /// Effective mass of its robot, kg.
    pub m_r: f64,
}

impl Moving {
    pub fn moves(&self, point: V3) -> V3 {
        add(self.velocity, cross(self.spin, sub(point, self.origin)))
    }

    /// The point of the surface above `x`, and the normal there.
    pub fn above(&self, x: V3) -> (V3, V3) {
        let on = nearest_on(x, self.core[0], self.core[1]);
        let out = sub(x, on);
        let normal = scaled(out, 1.0 / length(out));
        (add(on, scaled(normal, self.radius)), normal)
    }

    pub fn holds(&self, p: V3) -> bool {
        length(sub(p, nearest_on(p, self.core[0], self.core[1]))) < self.radius
    }

    /// Where a ray from outside enters: how far, and the outward normal there.
    fn entered(&self, p: V3, u: V3) -> Option<(f64, V3)> {
        let [a, b] = self.core;
        let mut roots = Vec::new();
        let mut solve = |qa: f64, qb: f64, qc: f64| {
            let d = qb * qb - qa * qc;
            if qa > 1e-15 && d >= 0.0 {
                roots.push((-qb - d.sqrt()) / qa);
            }
        };
        for end in [a, b] {
            let w = sub(p, end);
            solve(1.0, dot(w, u), dot(w, w) - self.radius * self.radius);
        }
        let axis = sub(b, a);
        if length(axis) > 0.0 {
            let axis = scaled(axis, 1.0 / length(axis));
            let across = |x: V3| sub(x, scaled(axis, dot(x, axis)));
            let (w, d) = (across(sub(p, a)), across(u));
            solve(dot(d, d), dot(w, d), dot(w, w) - self.radius * self.radius);
        }
        let enters = |t: f64| {
            let q = add(p, scaled(u, t));
            let out = sub(q, nearest_on(q, a, b));
            // The first of these points that is on the capsule, not inside it.
            ((length(out) - self.radius).abs() < 1e-9).then(|| (t, scaled(out, 1.0 / self.radius)))
        };
        let first = roots.into_iter().filter(|t| *t >= 0.0).filter_map(enters);
        first.reduce(|best, one| if one.0 < best.0 { one } else { best })
    }

    /// Points all over the surface, no farther than about `step` from each other, with normals.
    pub fn samples(&self, step: f64) -> Vec<(V3, V3)> {
        let along = sub(self.core[1], self.core[0]);
        let long = length(along);
        let axis = if long > 0.0 { scaled(along, 1.0 / long) } else { [0.0, 0.0, 1.0] };
        let [e, f] = beside(axis);
        let mut all = Vec::new();
        let mut ring = |centre: V3, radius: f64, lift: f64, wide: f64| {
            let count = pieces(std::f64::consts::TAU * radius, step).max(1);
            for i in 0..count {
                let turn = std::f64::consts::TAU * f64::from(i) / f64::from(count);
                let out = add(scaled(e, libm::cos(turn)), scaled(f, libm::sin(turn)));
                let normal = add(scaled(out, wide), scaled(axis, lift));
                all.push((add(centre, scaled(normal, self.radius)), normal));
            }
        };
        let rows = pieces(long, step);
        for i in 0..=rows {
            let share = if rows == 0 { 0.0 } else { f64::from(i) / f64::from(rows) };
            ring(between(self.core[0], self.core[1], share), self.radius, 0.0, 1.0);
        }
        let rings = pieces(std::f64::consts::FRAC_PI_2 * self.radius, step);
        for i in 1..=rings {
            let up = std::f64::consts::FRAC_PI_2 * f64::from(i) / f64::from(rings);
            let (lift, wide) = (libm::sin(up), libm::cos(up));
            ring(self.core[1], self.radius * wide, lift, wide);
            ring(self.core[0], self.radius * wide, -lift, wide);
        }
        all
    }
}

fn pieces(size: f64, step: f64) -> u32 {
    (0..100_000).find(|n| f64::from(*n) * step >= size).expect("not that large")
}

/// Two directions across a unit vector.
pub fn beside(axis: V3) -> [V3; 2] {
    let least = (0..3).fold(0, |best, i| if axis[i].abs() < axis[best].abs() { i } else { best });
    let e = cross(axis, super::geometry::UNIT[least]);
    let e = scaled(e, 1.0 / length(e));
    [e, cross(axis, e)]
}

/// Which direction is meant by the push.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Along {
    Velocity,
    Normal,
}

pub const BOTH: [Along; 2] = [Along::Velocity, Along::Normal];

/// What does not give way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Met {
    Floor,
    Block(usize),
    Link(usize),
}

/// What a point of a link closes on.
#[derive(Debug, Clone, Copy)]
pub struct Push {
    pub toward: V3,
    pub gap: f64,
    pub closing: f64,
    pub met: Met,
    /// Whether nothing else is met before.
    pub first: bool,
    /// The lesser of the two cosines of how the surfaces face the push.
    pub faces: f64,
}

/// By how much rules are loosened (or, negative, tightened).
#[derive(Debug, Clone, Copy, Default)]
pub struct Slack {
    /// Radii, reach and gaps, m.
    pub metres: f64,
    /// Cosines of facing.
    pub facing: f64,
    /// The velocity along the normal, as a share of the speed.
    pub outward: f64,
    /// Forces, as a share of the limit.
    pub force: f64,
}

/// What the program tells of a clamping.
#[derive(Debug, Clone, Copy)]
pub struct Told {
    pub region: Region,
    pub link: usize,
    pub at: V3,
    pub toward: V3,
    pub gap: f64,
    pub closing: f64,
    pub force: f64,
    pub limit: f64,
}

/// Everything but the person.
#[derive(Debug, Clone, Default)]
pub struct Scene {
    pub links: Vec<Moving>,
    pub blocks: Vec<Block>,
    /// What a robot travels on after a contact, m.
    pub travel: f64,
}

/// A clamping, as found here.
#[derive(Debug, Clone, Copy)]
pub struct Clamped {
    pub region: Region,
    pub link: usize,
    pub at: V3,
    pub normal: V3,
    pub along: Along,
    pub push: Push,
}

impl Scene {
    /// What a point of a link closes on in one of the directions, whatever the part.
    pub fn pushes(&self, link: usize, (p, n): (V3, V3), along: Along, slack: &Slack) -> Vec<Push> {
        let one = &self.links[link];
        let v = one.moves(p);
        let speed = length(v);
        // 2: the link moves outwards.
        if speed <= 0.0 || dot(n, v) <= -slack.outward * speed {
            return Vec::new();
        }
        let u = match along {
            Along::Velocity => scaled(v, 1.0 / speed),
            Along::Normal => n,
        };
        // 4, of the link.
        if dot(n, u) < FACING - slack.facing {
            return Vec::new();
        }
        // 3: the ray, and what it meets.
        let mut met: Vec<(f64, V3, V3, Met)> = Vec::new();
        if u[2] < 0.0 && p[2] >= 0.0 {
            met.push((p[2] / -u[2], [0.0, 0.0, 1.0], [0.0; 3], Met::Floor));
        }
        for (i, block) in self.blocks.iter().enumerate() {
            met.extend(block.entered(p, u).map(|(t, m)| (t, m, [0.0; 3], Met::Block(i))));
        }
        for (i, other) in self.links.iter().enumerate() {
            if i != link && other.carrier != one.carrier {
                let entered = other.entered(p, u);
                met.extend(entered.map(|(t, m)| (t, m, other.moves(add(p, scaled(u, t))), Met::Link(i))));
            }
        }
        met.sort_by(|a, b| a.0.total_cmp(&b.0));
        let push = |(i, (gap, m, other, met)): (usize, (f64, V3, V3, Met))| {
            let closing = dot(sub(v, other), u);
            // 4, of what is met, and 5.
            let faces = dot(n, u).min(-dot(m, u));
            let push = Push { toward: u, gap, closing, met, first: i == 0, faces };
            (faces >= FACING - slack.facing && closing > 0.0).then_some(push)
        };
        met.into_iter().enumerate().filter_map(push).collect()
    }

    /// 3 and 5, for a region.
    fn harms(&self, link: usize, push: &Push, region: Region, slack: &Slack) -> bool {
        let (k, limit) = spring_and_limit(region);
        push.gap <= iso_gap(region) + self.travel + slack.metres
            && push.closing * (self.links[link].m_r * k).sqrt() > limit * (1.0 - slack.force)
    }

    /// Whether a point is outside of every obstacle and other link. The page says it of hands; the program asks it of every part:
    /// what is in a box is not before it.
    fn is_open(&self, link: usize, p: V3) -> bool {
        !self.blocks.iter().any(|block| block.holds(p))
            && !self.links.iter().enumerate().any(|(i, other)| i != link && other.holds(p))
    }

    /// Points around a point of a link's surface, a tolerance away and half of that.
    fn around(&self, link: usize, (p, n): (V3, V3), by: f64) -> Vec<(V3, V3)> {
        let [e, f] = beside(n);
        let one = &self.links[link];
        let offset = |turn: f64, by: f64| add(scaled(e, by * libm::cos(turn)), scaled(f, by * libm::sin(turn)));
        let turns = (0..12).map(|i| std::f64::consts::TAU * f64::from(i) / 12.0);
        turns.flat_map(|turn| [0.5 * by, by].map(|by| one.above(add(p, offset(turn, by))))).collect()
    }

    /// Head, trunk and legs: points where the rules hold as they are loosened, in this direction; all regions that the part has
    /// near there when `any`, else the one that takes most.
    fn body_at(
        &self,
        body: &Body,
        (link, point): (usize, (V3, V3)),
        along: Along,
        slack: &Slack,
        any: bool,
    ) -> Vec<(usize, Region, Push)> {
        let within = |part: &&Part| {
            let d = length(sub(point.0, nearest_on(point.0, part.core[0], part.core[1])));
            let kept = || self.blocks.iter().any(|block| block.keeps(part, &self.links[link]));
            d <= part.radius + slack.metres && (any || !kept())
        };
        let mut parts = body.parts.iter().filter(within).peekable();
        if parts.peek().is_none() {
            return Vec::new();
        }
        if !any && !self.is_open(link, point.0) {
            return Vec::new();
        }
        let pushes = self.pushes(link, point, along, slack);
        let mut all = Vec::new();
        for part in parts {
            let number = body.parts.iter().position(|p| std::ptr::eq(p, part)).expect("one of them");
            let regions = regions_at(body, part, point.0);
            for push in pushes.iter().filter(|push| any || push.first) {
                let harmed = |region: &&Region| self.harms(link, push, region, slack);
                let told = if any { regions.iter().find(harmed) } else { regions.iter().find(|r| !harmed(r)) };
                match (any, told) {
                    (true, Some(region)) => all.push((number, *region, *push)),
                    (false, None) => all.push((number, regions[0], *push)),
                    _ => {}
                }
            }
        }
        all
    }

    /// Whether head, trunk or legs may be clamped at all: some sample does it when everything is looser by what lies between
    /// samples.
    pub fn body_possible(&self, body: &Body, along: Along, step: f64) -> Option<Clamped> {
        for (link, one) in self.links.iter().enumerate() {
            let turned = step / one.radius;
            let slack =
                Slack { metres: 3.0 * step, facing: 2.0 * turned.min(0.4), outward: turned.min(0.5), force: 0.05 };
            for point in self.near_body(body, link, step) {
                if let Some((_, region, push)) =
                    self.body_at(body, (link, point), along, &slack, true).into_iter().next()
                {
                    return Some(Clamped { region, link, at: point.0, normal: point.1, along, push });
                }
            }
        }
        None
    }

    fn near_body(&self, body: &Body, link: usize, step: f64) -> Vec<(V3, V3)> {
        let one = &self.links[link];
        let meets = |part: &Part| {
            let (p, q) = nearest(part.core, one.core);
            length(sub(p, q)) <= part.radius + one.radius + 0.03
        };
        let parts: Vec<&Part> = body.parts.iter().filter(|part| meets(part)).collect();
        if parts.is_empty() {
            return Vec::new();
        }
        let mut all = one.samples(step);
        all.retain(|(p, _)| {
            parts.iter().any(|part| length(sub(*p, nearest_on(*p, part.core[0], part.core[1]))) <= part.radius + 0.03)
        });
        all
    }

    /// A clamping of head, trunk or legs by the rules as they stand, and whether it is certain: it stays one, by the same push of
    /// the same thing at the same part, when the point moves by `by`.
    pub fn body(&self, body: &Body, along: Along, step: f64, by: f64) -> (Option<Clamped>, Option<Clamped>) {
        let (mut bare, mut certain) = (None, None);
        for link in 0..self.links.len() {
            for point in self.near_body(body, link, step) {
                let exact = Slack::default();
                for (part, region, push) in self.body_at(body, (link, point), along, &exact, false) {
                    let found = Clamped { region, link, at: point.0, normal: point.1, along, push };
                    bare.get_or_insert(found);
                    let stays = |near: &(V3, V3)| {
                        let there = self.body_at(body, (link, *near), along, &exact, false);
                        there.iter().any(|(p, _, other)| *p == part && other.met == push.met)
                    };
                    if certain.is_none() && self.around(link, point, by).iter().all(stays) {
                        certain = Some(found);
                    }
                }
                if certain.is_some() {
                    return (bare, certain);
                }
            }
        }
        (bare, certain)
    }

    /// Points at which an arm's region would be clamped, if it got there, and all around them, too (`by` 0: by themselves).
    pub fn targets(&self, region: Region, along: Along, step: f64, by: f64) -> Vec<Clamped> {
        let exact = Slack::default();
        let mut all = Vec::new();
        for (link, one) in self.links.iter().enumerate() {
            let holds = |point: (V3, V3), met: Option<Met>| {
                let mut pushes = self.pushes(link, point, along, &exact).into_iter().filter(|push| push.first);
                let push = pushes.find(|push| self.harms(link, push, region, &exact))?;
                (self.is_open(link, point.0) && met.is_none_or(|met| met == push.met)).then_some(push)
            };
            for point in one.samples(step) {
                let Some(push) = holds(point, None) else { continue };
                if by == 0.0 || self.around(link, point, by).into_iter().all(|p| holds(p, Some(push.met)).is_some()) {
                    all.push(Clamped { region, link, at: point.0, normal: point.1, along, push });
                }
            }
        }
        all
    }

    /// Whether what the program tells of a clamping is one, by the rules as they stand, and with what is said to be met; the arm
    /// is the one that it told. Rays to links end within `near` of them, m.
    pub fn is_true(
        &self,
        body: &Body,
        told: &Told,
        pose: Option<&Pose>,
        near: f64,
    ) -> Result<(Along, Met, bool), String> {
        const FINE: f64 = 1e-6;
        let one = self.links.get(told.link).ok_or("no such link")?;
        let (p, n) = one.above(told.at);
        if length(sub(p, told.at)) > FINE {
            return Err(format!("the point is {} m from the link's surface", length(sub(p, told.at))));
        }
        if !self.is_open(told.link, p) {
            let of_it = |(i, other): (usize, &Moving)| i != told.link && other.carrier == one.carrier && other.holds(p);
            let same = self.links.iter().enumerate().any(of_it);
            return Err(if same { IN_ITS_NEIGHBOUR } else { "the point is in an obstacle or another link" }.to_owned());
        }
        let loose = Slack { metres: near, facing: FINE + 50.0 * near, ..Slack::default() };
        let same = |a: f64, b: f64| (a - b).abs() <= FINE * b.abs().max(1.0);
        let (mut why, mut found) = (String::new(), None);
        for along in BOTH {
            for push in self.pushes(told.link, (p, n), along, &loose) {
                why = format!("{why} {along:?} {push:?};");
                let near = if matches!(push.met, Met::Link(_)) { near + FINE } else { FINE };
                if length(sub(push.toward, told.toward)) <= FINE
                    && (push.gap - told.gap).abs() <= near
                    && (push.closing - told.closing).abs() <= 3.0 * near
                    && push.faces >= FACING - FINE - 50.0 * (near - FINE)
                    && push.gap <= iso_gap(told.region) + self.travel + near
                {
                    found = Some((along, push));
                }
            }
        }
        let Some((along, push)) = found else {
            return Err(format!("no such push: v {:?} n {n:?}; there are:{why}", one.moves(p)));
        };
        let (k, limit) = spring_and_limit(told.region);
        let force = told.closing * (one.m_r * k).sqrt();
        if !same(force, told.force) || !same(limit, told.limit) || told.force <= told.limit {
            return Err(format!("{force} N against {limit} N"));
        }
        let inside = match pose {
            None => body.parts.iter().any(|part| {
                let d = length(sub(p, nearest_on(p, part.core[0], part.core[1])));
                d <= part.radius + FINE && regions_at(body, part, p).contains(&told.region)
            }),
            Some(pose) => self.arm_gets(pose, p, told.region, 0.0, f64::MAX) <= FINE,
        };
        if inside { Ok((along, push.met, push.first)) } else { Err("the part is not there".to_owned()) }
    }

    /// Whether the shoulder is on the person's side of every obstacle.
    pub fn available(&self, body: &Body, side: f64) -> bool {
        let line = [super::body::NECK_BASE, shoulder(side)].map(|p| body.in_world(p));
        self.blocks.iter().all(|block| block.gap(line) >= 0.0)
    }

    /// How free a pose is of obstacles, m; negative where it is not.
    pub fn clearance(&self, pose: &Pose) -> f64 {
        let of = |block: &Block| {
            let upper = block.gap(pose.upper()).min(block.gap(pose.upper_that_counts()) - arm::UPPER_RADIUS);
            upper.min(block.gap(pose.fore()) - FORE_RADIUS)
        };
        self.blocks.iter().map(of).fold(f64::MAX, f64::min)
    }

    /// What a part of an arm lacks to get to a point, m, and, when it moves by `by`, still does; something no less than `enough`
    /// where it is that at least.
    fn arm_gets(&self, pose: &Pose, p: V3, region: Region, by: f64, enough: f64) -> f64 {
        if region != "hand" {
            let limb = pose.limbs().into_iter().filter(|limb| limb.2 == region);
            let lacks = limb.map(|(axis, radius, _)| length(sub(p, nearest_on(p, axis[0], axis[1]))) - radius);
            return lacks.fold(f64::MAX, f64::min) + by;
        }
        let far = length(sub(pose.wrist, p)) - HAND + by;
        if far >= enough {
            return far;
        }
        let mut lines = vec![[pose.wrist, p]];
        if by > 0.0 {
            for axis in super::geometry::UNIT {
                lines.extend([-by, by].map(|by| [add(pose.wrist, scaled(axis, by)), p]));
            }
        }
        let free = lines.iter().flat_map(|line| self.blocks.iter().map(|block| block.gap(*line)));
        far.max(-free.fold(f64::MAX, f64::min))
    }
}

/// Regions that a point in a part may be taken to belong to: by where it is, and by the surface of the part above it.
fn regions_at(body: &Body, part: &Part, p: V3) -> Vec<Region> {
    let on = nearest_on(p, part.core[0], part.core[1]);
    let out = sub(p, on);
    let mut regions = vec![body.region(part, p)];
    if length(out) > 0.0 {
        let above = body.region(part, add(on, scaled(out, part.radius / length(out))));
        if above != regions[0] {
            regions.push(above);
        }
    }
    regions
}

/// A pose of an arm that gets to one of the targets and still does when arm or joints move by `by`: angles on a grid, and from
/// the best of them on by smaller and smaller steps.
pub struct Arms<'a> {
    pub scene: &'a Scene,
    pub body: &'a Body,
    pub side: f64,
    pub by: f64,
}

impl Arms<'_> {
    /// What is missing at best, of which target, and the pose; more than `enough` matters not.
    fn lacks(&self, angles: arm::Angles, targets: &[Clamped], enough: f64) -> (f64, usize, Pose) {
        let joint = self.body.in_world(shoulder(self.side));
        let pose = arm::pose(joint, &self.body.rotation, self.side, angles);
        let mut least = arm::beyond_limits(angles) + self.by;
        if least < enough {
            least = least.max(self.by - self.scene.clearance(&pose));
        }
        if least >= enough {
            return (least, 0, pose);
        }
        let (mut best, mut which) = (enough, 0);
        for (i, target) in targets.iter().enumerate() {
            let lacks = self.scene.arm_gets(&pose, target.at, target.region, self.by, best);
            if lacks < best {
                (best, which) = (lacks, i);
            }
        }
        (best.max(least), which, pose)
    }

    pub fn tried(&self, targets: &[Clamped]) -> Option<(Clamped, Pose)> {
        let joint = self.body.in_world(shoulder(self.side));
        let mut near: Vec<Clamped> =
            targets.iter().copied().filter(|t| length(sub(t.at, joint)) < arm::UPPER + arm::FORE + HAND).collect();
        // Those that are spread over all.
        let stride = near.len().div_ceil(40).max(1);
        near = near.into_iter().step_by(stride).collect();
        if near.is_empty() {
            return None;
        }
        let mut best = [(f64::MAX, [0.0; 4]); 6];
        for angles in arm::grid() {
            let (lacks, which, pose) = self.lacks(angles, &near, best[5].0);
            if lacks <= 0.0 {
                return Some((near[which], pose));
            }
            if lacks < best[5].0 {
                best[5] = (lacks, angles);
                best.sort_by(|a, b| a.0.total_cmp(&b.0));
            }
        }
        for (mut lacks, mut at) in best {
            let mut step = 8.0;
            while step > 0.3 {
                let mut better = false;
                for direction in arm::DIRECTIONS {
                    let mut next = at;
                    next.iter_mut().zip(direction).for_each(|(x, d)| *x += step * d);
                    let (there, which, pose) = self.lacks(next, &near, lacks);
                    if there <= 0.0 {
                        return Some((near[which], pose));
                    }
                    if there < lacks {
                        (lacks, at, better) = (there, next, true);
                    }
                }
                if !better {
                    step *= 0.5;
                }
            }
        }
        None
    }
}
