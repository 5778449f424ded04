//! Scenes around a point that may well be clamped.

use super::arm::{self, FORE, UPPER};
use super::body::{Body, POSTURES, shoulder};
use super::clamp::{Block, Moving, Scene, bearable, beside, iso_gap};
use super::force::Region;
use super::geometry::{M3, UNIT, V3, about, add, between, cross, dot, length, product, scaled, sub, turned};

/// Random numbers (SplitMix64).
pub struct Dice(u64);

impl Dice {
    pub const fn new(seed: u64) -> Self {
        Self(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9E37_79B9_7F4A_7C15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
        z ^ (z >> 31)
    }

    pub fn number(&mut self, low: f64, high: f64) -> f64 {
        let unit = f64::from(u32::try_from(self.next() >> 32).expect("32 bits")) / f64::from(u32::MAX);
        low + (high - low) * unit
    }

    fn chance(&mut self, p: f64) -> bool {
        self.number(0.0, 1.0) < p
    }

    fn below(&mut self, count: usize) -> usize {
        usize::try_from(self.next() >> 33).expect("31 bits") % count
    }

    fn direction(&mut self) -> V3 {
        loop {
            let v = [0; 3].map(|_| self.number(-1.0, 1.0));
            let l = length(v);
            if l > 0.1 && l < 1.0 {
                return scaled(v, 1.0 / l);
            }
        }
    }

    /// A direction that is so many degrees from another.
    fn tilted(&mut self, from: V3, degrees: f64) -> V3 {
        let [e, f] = beside(from);
        let (turn, tilt) = (self.number(0.0, std::f64::consts::TAU), degrees.to_radians());
        let side = add(scaled(e, libm::cos(turn)), scaled(f, libm::sin(turn)));
        add(scaled(from, libm::cos(tilt)), scaled(side, libm::sin(tilt)))
    }
}

/// The four frames' poses and motions: the links 0 and 1 are carried by the first, 2 by the second; the last one by another robot.
pub const CARRIERS: [usize; 4] = [0, 0, 1, 2];

/// A frame of a robot.
#[derive(Debug, Clone, Copy)]
pub struct Frame {
    pub axis: V3,
    pub angle: f64,
    pub origin: V3,
    pub velocity: V3,
    pub spin: V3,
}

impl Frame {
    pub fn rotation(&self) -> M3 {
        about(self.axis, self.angle)
    }
}

/// A person and a scene.
#[derive(Debug, Clone)]
pub struct Case {
    pub xy: [f64; 2],
    pub heading_deg: f64,
    pub posture: usize,
    pub walks: bool,
    /// Effective masses of both robots, kg.
    pub masses: [f64; 2],
    pub frames: [Frame; 3],
    pub scene: Scene,
}

impl Case {
    pub fn legs(&self) -> M3 {
        about(UNIT[2], self.heading_deg.to_radians())
    }
}

/// What is aimed at: a point in a part, a direction from the part to the robot there, the region.
struct Aim {
    at: V3,
    out: V3,
    region: Region,
    /// Whether it is pressed against the floor.
    floor: bool,
}

const FORWARD: f64 = 45.0;
const SIDEWAYS: f64 = 30.0;

struct Person {
    xy: [f64; 2],
    heading_deg: f64,
    posture: usize,
    body: Body,
}

fn person(dice: &mut Dice) -> Person {
    let xy = [dice.number(-2.0, 2.0), dice.number(-2.0, 2.0)];
    let heading_deg = dice.number(-180.0, 180.0);
    let posture = if dice.chance(0.5) { 0 } else { dice.below(6) };
    let legs = about(UNIT[2], heading_deg.to_radians());
    let (_, forward, left) = POSTURES[posture];
    let bend =
        product(&about(UNIT[0], (-left * SIDEWAYS).to_radians()), &about(UNIT[1], (forward * FORWARD).to_radians()));
    Person { xy, heading_deg, posture, body: Body::posed(xy, &legs, product(&legs, &bend), 16) }
}

/// A capsule whose surface has this point with this normal.
fn capsule(dice: &mut Dice, (p, n): (V3, V3)) -> ([V3; 2], f64) {
    let radius = if dice.chance(0.2) { dice.number(0.02, 0.04) } else { dice.number(0.04, 0.13) };
    let foot = add(p, scaled(n, -radius));
    if dice.chance(0.6) {
        let along = dice.tilted(n, 90.0);
        let far = |dice: &mut Dice| dice.number(0.0, 0.35);
        let (a, b) = (far(dice), far(dice));
        ([add(foot, scaled(along, a)), add(foot, scaled(along, -b))], radius)
    } else {
        let tilt = dice.number(90.0, 180.0);
        let (along, far) = (dice.tilted(n, tilt), if dice.chance(0.2) { 0.0 } else { dice.number(0.0, 0.5) });
        ([foot, add(foot, scaled(along, far))], radius)
    }
}

fn block(dice: &mut Dice, (q, m): (V3, V3)) -> Block {
    let wide = if dice.chance(0.4) { [0.02, 0.12] } else { [0.1, 0.7] };
    let half = [dice.number(0.01, 0.3), dice.number(wide[0], wide[1]), dice.number(wide[0], wide[1])];
    let [e, f] = beside(m);
    let turn = about(m, dice.number(0.0, 3.0));
    let (e, f) = (turned(&turn, e), turned(&turn, f));
    let (a, b) = (dice.number(-0.9, 0.9) * half[1], dice.number(-0.9, 0.9) * half[2]);
    let centre = add(add(q, scaled(m, -half[0])), add(scaled(e, a), scaled(f, b)));
    // Columns are the box's axes.
    let rotation = [0, 1, 2].map(|i| [m[i], e[i], f[i]]);
    Block { centre, half, rotation }
}

fn frame(dice: &mut Dice, near: V3) -> Frame {
    let origin = add(near, scaled(dice.direction(), dice.number(0.0, 0.6)));
    let (axis, angle) = (dice.direction(), dice.number(-3.0, 3.0));
    let spin = if dice.chance(0.4) { [0.0; 3] } else { scaled(dice.direction(), dice.number(0.0, 2.0)) };
    Frame { axis, angle, origin, velocity: [0.0; 3], spin }
}

/// Lets a point of the frame have this velocity.
fn move_at(frame: &mut Frame, point: V3, velocity: V3) {
    frame.velocity = sub(velocity, cross(frame.spin, sub(point, frame.origin)));
}

fn around(dice: &mut Dice, person: &Person, aim: &Aim, travel: f64) -> Case {
    let p = aim.at;
    let down = aim.floor || dice.chance(0.25);
    let tilt = if dice.chance(0.5) { dice.number(0.0, 30.0) } else { dice.number(0.0, 80.0) };
    let n = if down { dice.tilted([0.0, 0.0, -1.0], 0.7 * tilt) } else { dice.tilted(scaled(aim.out, -1.0), tilt) };
    let skew = match dice.below(10) {
        0..=4 => dice.number(0.0, 35.0),
        5..=8 => dice.number(35.0, 85.0),
        _ => dice.number(80.0, 120.0),
    };
    let v = dice.tilted(n, skew);
    let u = if dice.chance(0.5) || skew > 88.0 { n } else { v };
    let allowed = iso_gap(aim.region) + travel;
    let gap = allowed * if dice.chance(0.5) { dice.number(0.05, 0.95) } else { dice.number(0.83, 1.12) };
    let q = add(p, scaled(u, gap));
    let facing = if dice.chance(0.7) { dice.number(0.0, 50.0) } else { dice.number(45.0, 75.0) };
    let m = dice.tilted(scaled(u, -1.0), facing);
    let masses = [dice.number(5.0, 40.0), dice.number(5.0, 40.0)];
    let hard = if dice.chance(0.7) { dice.number(1.1, 4.0) } else { dice.number(0.6, 1.3) };
    let closing = bearable(aim.region, masses[0]) * hard;

    let mut frames = [0; 3].map(|_| frame(dice, p));
    let far = |i: f64| [[100.0 + i, 0.0, 5.0]; 2];
    let mut cores = [(far(0.0), 0.05), (far(1.0), 0.05), (far(2.0), 0.05), (far(3.0), 0.05)];
    cores[0] = capsule(dice, (p, n));
    let mut blocks = Vec::new();
    let mut other = [0.0; 3];
    match if aim.floor { 20 } else { dice.below(20) } {
        0..=9 => blocks.push(block(dice, (q, m))),
        kind @ 10..=17 => {
            let link = match kind {
                10..=13 => 2,
                14..=16 => 3,
                _ => 1,
            };
            cores[link] = capsule(dice, (q, m));
            other = match dice.below(4) {
                0 => [0.0; 3],
                1 => scaled(dice.direction(), dice.number(0.0, 1.0) * closing),
                2 => scaled(u, -dice.number(0.2, 1.5) * closing),
                _ => scaled(u, dice.number(0.2, 1.5) * closing),
            };
            if link == 1 {
                other = [0.0; 3];
            } else {
                move_at(&mut frames[CARRIERS[link]], q, other);
            }
        }
        _ => {}
    }
    // What the same joint carries often begins in the link.
    if cores[1].0[0][0] > 50.0 && dice.chance(0.2) {
        let end = cores[0].0[dice.below(2)];
        let far = scaled(dice.direction(), dice.number(0.0, 0.4));
        cores[1] = ([end, add(end, far)], dice.number(0.03, 0.13));
    }
    if cores[2].0[0][0] > 50.0 {
        frames[1].spin = [0.0; 3];
    }
    if cores[3].0[0][0] > 50.0 {
        frames[2].spin = [0.0; 3];
    }
    let speed = (closing + dot(other, u)) / dot(v, u).max(0.2);
    move_at(&mut frames[0], p, scaled(v, speed.max(0.02)));
    for _ in 0..[0, 0, 1, 2][dice.below(4)] {
        let at = add(p, scaled(dice.direction(), dice.number(0.15, 0.9)));
        let face = dice.direction();
        blocks.push(block(dice, (at, face)));
    }
    let links = (0..4).map(|i| {
        let Frame { origin, velocity, spin, .. } = frames[CARRIERS[i]];
        let (core, radius) = cores[i];
        Moving { core, radius, origin, velocity, spin, carrier: CARRIERS[i], m_r: masses[usize::from(i == 3)] }
    });
    let scene = Scene { links: links.collect(), blocks, travel };
    let Person { xy, heading_deg, posture, .. } = *person;
    Case { xy, heading_deg, posture, walks: dice.chance(0.3), masses, frames, scene }
}

/// A scene at head, trunk or legs.
pub fn at_body(dice: &mut Dice, travel: f64) -> Case {
    let person = person(dice);
    let floor = dice.chance(0.1);
    loop {
        let part = &person.body.parts[dice.below(person.body.parts.len())];
        let on = between(part.core[0], part.core[1], dice.number(0.0, 1.0));
        let out = dice.direction();
        let at = add(on, scaled(out, part.radius * dice.number(0.2, 1.02)));
        if at[2] > 0.01 && (!floor || at[2] < 0.24) {
            let region = person.body.region(part, at);
            return around(dice, &person, &Aim { at, out, region, floor }, travel);
        }
    }
}

/// A scene at an arm.
pub fn at_arm(dice: &mut Dice, travel: f64) -> Case {
    let person = person(dice);
    let side = if dice.chance(0.5) { 1.0 } else { -1.0 };
    let joint = person.body.in_world(shoulder(side));
    loop {
        let angles =
            [dice.number(-5.0, 150.0), dice.number(-30.0, 140.0), dice.number(-40.0, 90.0), dice.number(10.0, 140.0)];
        if !arm::within(angles, [4.0; 4]) {
            continue;
        }
        let pose = arm::pose(joint, &person.body.rotation, side, angles);
        let out = dice.direction();
        let (at, region) = match dice.below(20) {
            0..=7 => (add(pose.wrist, scaled(out, dice.number(0.02, 0.21))), "hand"),
            kind => {
                let ([a, b], radius, region) = pose.limbs()[kind % 3];
                let on = between(a, b, dice.number(0.0, 1.0));
                (add(on, scaled(out, radius * dice.number(0.0, 0.9))), region)
            }
        };
        if at[2] > 0.02 && length(sub(at, joint)) < UPPER + FORE + 0.2 {
            return around(dice, &person, &Aim { at, out, region, floor: false }, travel);
        }
    }
}
