//! The person: place, walk, posture, capsules and regions.

use super::cell::Cell;
use super::force::{FACE, Region, SKULL, THROAT};
use super::geometry::{M3, Solid, UNIT, V3, about, add, product, scaled, turned};

pub const WALKS: [(&str, i64, bool); 6] = [
    ("stop", 0, false),
    ("forward", 0, true),
    ("left45", 1, true),
    ("left90", 2, true),
    ("right45", -1, true),
    ("right90", -2, true),
];

/// Name, forward, to the left.
pub const POSTURES: [(&str, f64, f64); 6] = [
    ("upright", 0.0, 0.0),
    ("bend-forward", 1.0, 0.0),
    ("bend-left", 0.0, 1.0),
    ("bend-right", 0.0, -1.0),
    ("bend-forward-left", 1.0, 1.0),
    ("bend-forward-right", 1.0, -1.0),
];

const WALKING_SPEED: f64 = 1.6;
const BEND_FORWARD: f64 = 45.0;
const BEND_SIDEWAYS: f64 = 30.0;
const PIVOT: f64 = 0.92;
pub const NECK_BASE: V3 = [0.0, 0.0, 0.48];
/// Overlaps below this are none.
const NANOMETRE: f64 = 1e-9;

/// Sub-steps along the four directions, and the heading in eighths of a turn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub struct Place {
    pub ways: [i64; 4],
    pub heading: i64,
}

fn small(n: i64) -> f64 {
    f64::from(i32::try_from(n).expect("a small number"))
}

fn direction(cell: &Cell, eighths: i64) -> [f64; 2] {
    let angle = (cell.heading + 45.0 * small(eighths)).to_radians();
    [libm::cos(angle), libm::sin(angle)]
}

impl Place {
    pub const START: Self = Self { ways: [0; 4], heading: 0 };

    pub fn turned(mut self, eighths: i64) -> Self {
        self.heading = (self.heading + eighths).rem_euclid(8);
        self
    }

    pub fn ahead(mut self) -> Self {
        let along = usize::try_from(self.heading % 4).expect("not negative");
        self.ways[along] += if self.heading < 4 { 1 } else { -1 };
        self
    }

    /// The velocity of a person who walks here, as they look.
    pub fn walking(&self, cell: &Cell) -> V3 {
        let [x, y] = direction(cell, self.heading);
        scaled([x, y, 0.0], WALKING_SPEED)
    }

    pub fn xy(&self, cell: &Cell) -> [f64; 2] {
        let mut at = cell.start;
        for (eighths, count) in (0..).zip(self.ways) {
            let d = direction(cell, eighths);
            for i in 0..2 {
                at[i] += d[i] * small(count) * WALKING_SPEED * cell.step;
            }
        }
        at
    }

    fn blocked(&self, cell: &Cell) -> bool {
        cell.obstacles.iter().any(|o| self.is_in(cell, o))
    }

    /// Whether the upright capsule that walks with the person overlaps this.
    pub fn is_in(&self, cell: &Cell, solid: &Solid) -> bool {
        let [x, y] = self.xy(cell);
        let (r, top) = (0.14, PIVOT + 0.72 + 0.105);
        solid.gap([[x, y, 0.05 + r], [x, y, top - r]]) < r - NANOMETRE
    }
}

/// The place at the end of each communication step of an action.
pub fn walk(cell: &Cell, from: Place, walk: usize) -> Vec<Place> {
    let (_, eighths, moves) = WALKS[walk];
    let mut at = from.turned(eighths);
    let mut free = moves;
    (0..cell.steps())
        .map(|_| {
            if free {
                let next = at.ahead();
                free = !next.blocked(cell);
                if free {
                    at = next;
                }
            }
            at
        })
        .collect()
}

/// A part of the body, in the world.
#[derive(Debug, Clone)]
pub struct Part {
    pub name: &'static str,
    pub core: [V3; 2],
    pub radius: f64,
}

/// The body at a place, in a posture.
#[derive(Debug, Clone)]
pub struct Body {
    pub parts: Vec<Part>,
    /// Of the trunk: world from trunk.
    pub rotation: M3,
    pub origin: V3,
    pub sixteenths: u32,
    pub feet: [[f64; 2]; 2],
}

const TRUNK: [(&str, V3, V3, f64); 5] = [
    ("head", [0.0, 0.0, 0.72], [0.0, 0.0, 0.72], 0.105),
    ("neck", [0.0, 0.0, 0.52], [0.0, 0.0, 0.62], 0.06),
    ("upper chest", [0.0, 0.08, 0.40], [0.0, -0.08, 0.40], 0.13),
    ("lower chest", [0.0, 0.08, 0.25], [0.0, -0.08, 0.25], 0.14),
    ("abdomen", [0.0, 0.0, 0.12], [0.0, 0.0, 0.12], 0.13),
];

const LEGS: [(&str, V3, V3, f64); 5] = [
    ("pelvis", [0.0, 0.07, 0.95], [0.0, -0.07, 0.95], 0.14),
    ("thigh", [0.0, 0.09, 0.49], [0.0, 0.09, 0.85], 0.08),
    ("thigh", [0.0, -0.09, 0.49], [0.0, -0.09, 0.85], 0.08),
    ("lower leg", [0.0, 0.09, 0.055], [0.0, 0.09, 0.49], 0.055),
    ("lower leg", [0.0, -0.09, 0.055], [0.0, -0.09, 0.49], 0.055),
];

/// Shoulder joint in the frame of the trunk; `side` is 1 for the left one, -1 for the right one.
pub fn shoulder(side: f64) -> V3 {
    [0.0, side * 0.19, 0.48]
}

impl Body {
    pub fn new(cell: &Cell, place: Place, posture: usize) -> Self {
        let [x, y] = place.xy(cell);
        let feet = (about(UNIT[2], (cell.heading + 45.0 * small(place.heading)).to_radians()), [x, y, 0.0]);
        let origin = [x, y, PIVOT];
        let (_, forward, left) = POSTURES[posture];
        let bent = |sixteenths: u32| {
            let share = f64::from(sixteenths) / 16.0;
            let s = about(UNIT[0], (-left * share * BEND_SIDEWAYS).to_radians());
            let f = about(UNIT[1], (forward * share * BEND_FORWARD).to_radians());
            product(&feet.0, &product(&s, &f))
        };
        let sixteenths = if posture == 0 { 16 } else { free_bend(cell, origin, bent) };
        let rotation = bent(sixteenths);
        Self::posed([x, y], &feet.0, rotation, sixteenths)
    }

    /// The body on this spot of the floor, with the legs and the trunk turned so.
    pub fn posed([x, y]: [f64; 2], legs: &M3, rotation: M3, sixteenths: u32) -> Self {
        let feet = (*legs, [x, y, 0.0]);
        let origin = [x, y, PIVOT];
        let in_world = |(rotation, origin): &(M3, V3), (name, from, to, radius): (&'static str, V3, V3, f64)| Part {
            name,
            core: [from, to].map(|p| add(*origin, turned(rotation, p))),
            radius,
        };
        let trunk = TRUNK.into_iter().map(|part| in_world(&(rotation, origin), part));
        let legs = LEGS.into_iter().map(|part| in_world(&feet, part));
        let parts = trunk.chain(legs).collect();
        let foot = |side: f64| {
            let p = add(feet.1, turned(&feet.0, [0.0, side * 0.09, 0.0]));
            [p[0], p[1]]
        };
        Self { parts, rotation, origin, sixteenths, feet: [foot(1.0), foot(-1.0)] }
    }

    pub fn in_world(&self, of_trunk: V3) -> V3 {
        add(self.origin, turned(&self.rotation, of_trunk))
    }

    /// The region of a point of this part, given in the world.
    pub fn region(&self, part: &Part, point: V3) -> Region {
        let [x, y, z] = super::geometry::turned_back(&self.rotation, super::geometry::sub(point, self.origin));
        let front = x >= 0.0;
        let of_trunk = if z >= 0.20 { "chest" } else { "abdomen" };
        match part.name {
            "head" => {
                if front && z <= 0.72 {
                    FACE
                } else {
                    SKULL
                }
            }
            "neck" if front => THROAT,
            "neck" => "neck",
            "upper chest" if !front || y.abs() > 0.1445 => "back_shoulders",
            "upper chest" | "lower chest" | "abdomen" if front => of_trunk,
            "lower chest" | "abdomen" => "back_shoulders",
            "lower leg" => "lower_leg",
            other => other,
        }
    }
}

/// How many sixteenths of a bend obstacles leave.
fn free_bend(cell: &Cell, origin: V3, bent: impl Fn(u32) -> M3) -> u32 {
    let line = |a: V3, b: V3| ("line", a, b, 0.0);
    let shapes: Vec<_> = TRUNK[..4]
        .iter()
        .copied()
        .chain([line(NECK_BASE, shoulder(1.0)), line(NECK_BASE, shoulder(-1.0)), line([0.0; 3], TRUNK[0].1)])
        .collect();
    let upright = bent(0);
    let core = |rotation: &M3, a: V3, b: V3| [a, b].map(|p| add(origin, turned(rotation, p)));
    let enters = |o: &Solid, rotation: &M3, (_, a, b, _): (&str, V3, V3, f64), r: f64| {
        o.gap(core(rotation, a, b)) < r - NANOMETRE
    };
    // Per shape and obstacle the radius that counts; none where it is left out.
    let mut asked = Vec::new();
    for shape in &shapes {
        for o in &cell.obstacles {
            if !enters(o, &upright, *shape, shape.3) {
                asked.push((*shape, o, shape.3));
            } else if !enters(o, &upright, *shape, 0.0) {
                asked.push((*shape, o, 0.0));
            }
        }
    }
    for n in 1..=16 {
        let rotation = bent(n);
        if asked.iter().any(|(shape, o, r)| enters(o, &rotation, *shape, *r)) {
            return n - 1;
        }
    }
    16
}

/// The middle of the head.
pub fn head(body: &Body) -> V3 {
    body.in_world(scaled(UNIT[2], 0.72))
}
