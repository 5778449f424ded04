//! How far points of an arm move within a box of joint angles, how near to a solid a limb comes with that, and how far
//! the solid's nearest point moves along.

use std::cell::Cell;

use super::joint_box::JointBox;
use super::sweep::{Levers, Range, Sweep, Turn};
use crate::geometry::{Closest, Hull, Pose, Solid, Vec3};
use crate::human::Side;
use crate::human::arm::ArmModel;

/// The arm in one configuration, world.
#[derive(Clone, Copy)]
pub(super) struct Placed {
    pub(super) shoulder: Vec3,
    pub(super) elbow: Vec3,
    pub(super) wrist: Vec3,
    /// Sine and cosine of each joint angle.
    pub(super) turns: [Turn; 4],
}

/// The axes of the shoulder's frame, world: forward, towards the side of the arm, up.
#[derive(Clone, Copy)]
pub(super) struct Frame([Vec3; 3]);

impl Frame {
    pub(super) fn new(world_from_shoulder: &Pose, side: Side) -> Self {
        Self([Vec3::X, Vec3::Y * side.sign(), Vec3::Z].map(|axis| world_from_shoulder.transform_vector(axis)))
    }

    /// A vector of the world, in the frame.
    fn of(&self, v: Vec3) -> Vec3 {
        Vec3::from_array(self.0.map(|axis| axis.dot(v)))
    }

    /// A vector of the frame, in the world.
    pub(super) fn to_world(self, v: Vec3) -> Vec3 {
        self.0[0] * v.x + self.0[1] * v.y + self.0[2] * v.z
    }
}

/// How far elbow and wrist can be from where they are in the middle of a box, m, wherever the arm is carried.
pub(super) struct Movement {
    /// How far the arm as a whole may be carried.
    pub(super) shoulder: f64,
    pub(super) elbow: f64,
    pub(super) wrist: f64,
    /// The joint whose halving shrinks it most.
    pub(super) widest_joint: usize,
    frame: Frame,
    sweep: Sweep,
}

/// More than what rounding can do to a length, as a part of it.
const ROUNDED_UP: f64 = 1.0 + 1e-9;

impl Movement {
    /// Within the box `b`, in whose middle the arm is `placed`; `frame` is the shoulder's.
    ///
    /// The joints are turned from the middle to any configuration of the box one after the other, the outermost first: when
    /// its turn comes, what is beyond a joint is still as in the middle, so its lever is the one there. In any
    /// configuration a lever is longer by no more than what the joints beyond it move. What the arm as a whole is `carried`
    /// comes on top.
    pub(super) fn of(arm: &ArmModel, b: &JointBox, placed: &Placed, frame: Frame, carried: f64) -> Self {
        let (upper, fore) = (arm.upper_arm_m, arm.forearm_m);
        let quarters = b.half.map(|h| libm::sincos(0.5 * h));
        let halves = quarters.map(|(sin, cos)| (2.0 * sin * cos, 1.0 - 2.0 * sin * sin));
        // A point at distance r that turns by an angle h moves along an arc, by a chord of 2 r sin(h / 2).
        let chord = |j: usize| if b.half[j] < std::f64::consts::PI { 2.0 * quarters[j].0 } else { 2.0 };
        let chords: [f64; 4] = std::array::from_fn(chord);
        // The wrist is farthest from the shoulder with the elbow as straight as the box allows, and farthest from the
        // upper arm's axis with the elbow as near the right angle as it allows.
        let ((sin, cos), (sin_half, cos_half)) = (placed.turns[3], halves[3]);
        let straightest = if b.low(3) > 0.0 { cos * cos_half + sin * sin_half } else { 1.0 };
        let from_shoulder = (upper * upper + fore * fore + 2.0 * upper * fore * straightest).sqrt();
        let right_angle = (b.low(3)..=b.high(3)).contains(&std::f64::consts::FRAC_PI_2);
        let bent = if right_angle { 1.0 } else { sin * cos_half + (cos * sin_half).abs() };
        let anywhere = [from_shoulder, from_shoulder, fore * bent, fore];
        let [elbow, wrist] = arm.at(&placed.turns);
        let (sin_abduction, cos_abduction) = placed.turns[0];
        let raised = wrist.z * cos_abduction - wrist.y * sin_abduction;
        let middle = [libm::hypot(wrist.y, wrist.z), libm::hypot(wrist.x, raised), fore * sin, fore];
        let middle: [f64; 4] = std::array::from_fn(|joint| middle[joint].min(anywhere[joint]) * ROUNDED_UP);
        let by_joint: [f64; 4] = std::array::from_fn(|joint| middle[joint] * chords[joint]);
        let beyond = |joint: usize| by_joint[joint + 1..].iter().sum::<f64>();
        let levers = std::array::from_fn(|joint| (middle[joint] + beyond(joint)).min(anywhere[joint] * ROUNDED_UP));
        let abducted = (libm::hypot(elbow.y, elbow.z) * ROUNDED_UP).min(upper);
        let levers = Levers { elbow: [(abducted + upper * chords[1]).min(upper), upper], wrist: levers };
        let sweep = Sweep::of(arm, b.half, &placed.turns, &halves, levers);
        let (by_corners, widest_joint) = sweep.size();
        Self {
            shoulder: carried,
            elbow: abducted * chords[0] + upper * chords[1] + carried,
            wrist: by_corners.min(by_joint.iter().sum()) + carried,
            widest_joint,
            frame,
            sweep,
        }
    }

    /// How far elbow and wrist can move along `n`, no longer than a unit vector.
    pub(super) fn both(&self, n: Vec3) -> [Range; 2] {
        self.sweep.both(self.frame.of(n)).map(|range| range.wider(self.shoulder))
    }

    /// How far the shoulder can.
    pub(super) const fn of_shoulder(&self) -> Range {
        Range::NONE.wider(self.shoulder)
    }

    /// How far a point of the arm can be from where it is in the middle, m.
    fn at_most(&self, point: Share) -> f64 {
        point.of(self.shoulder, self.elbow, self.wrist)
    }

    /// How far the wrist can.
    pub(super) fn wrist(&self, n: Vec3) -> Range {
        self.both(n)[1]
    }

    /// How far the elbow can.
    pub(super) fn elbow(&self, n: Vec3) -> Range {
        self.sweep.elbow(self.frame.of(n)).wider(self.shoulder)
    }
}

/// A point of the arm: shoulder, elbow and wrist weighted, with the rest of one on the shoulder. It moves with them.
#[derive(Clone, Copy)]
pub(super) struct Share {
    pub(super) elbow: f64,
    pub(super) wrist: f64,
}

impl Share {
    pub(super) const SHOULDER: Self = Self { elbow: 0.0, wrist: 0.0 };
    pub(super) const ELBOW: Self = Self { elbow: 1.0, wrist: 0.0 };

    /// So far, as a fraction, from the elbow to the wrist.
    pub(super) const fn on_forearm(part: f64) -> Self {
        Self { elbow: 1.0 - part, wrist: part }
    }

    /// What moves with it, of shoulder, elbow and wrist.
    const fn of(self, shoulder: f64, elbow: f64, wrist: f64) -> f64 {
        self.elbow * elbow + self.wrist * wrist + (1.0 - self.elbow - self.wrist) * shoulder
    }

    pub(super) fn at(self, placed: &Placed) -> Vec3 {
        let Placed { shoulder, elbow, wrist, .. } = placed;
        *shoulder + (*elbow - *shoulder) * self.elbow + (*wrist - *shoulder) * self.wrist
    }
}

/// A part of the arm with thickness.
pub(super) struct Limb {
    /// Its ends.
    pub(super) ends: [Share; 2],
    /// Its radius, m.
    pub(super) radius: f64,
}

/// A plane that a solid is behind.
#[derive(Clone, Copy)]
pub(super) struct Plane {
    /// Unit vector away from the solid.
    normal: Vec3,
    /// How far the solid reaches along it, from the origin, m.
    reach_m: f64,
}

impl Plane {
    /// The one across the way to a slab of a hull, if that is apart.
    pub(super) fn remember(last: &Cell<Option<Self>>, link: &Solid, near: &Closest) {
        if let (Solid::Hull(hull), Some(normal)) = (link, link.outward(near))
            && hull.is_cut()
        {
            Self::remember_across(last, hull, normal);
        }
    }

    /// The one across this unit vector.
    fn remember_across(last: &Cell<Option<Self>>, hull: &Hull, normal: Vec3) {
        last.set(Some(Self { normal, reach_m: hull.reach_along(normal) }));
    }
}

impl Limb {
    /// Whether the last plane that a solid was found to be behind keeps the limb from overlapping it by `depth` anywhere in a box of
    /// joint angles.
    pub(super) fn is_beyond(
        &self,
        last: &Cell<Option<Plane>>,
        depth: f64,
        placed: &Placed,
        movement: &Movement,
    ) -> bool {
        let Some(Plane { normal, reach_m }) = last.get() else { return false };
        let beyond = self.ends.map(|end| normal.dot(end.at(placed)) - reach_m - self.radius);
        let at_most = self.ends.map(|end| movement.at_most(end));
        beyond[0].min(beyond[1]) - at_most[0].max(at_most[1]) > -depth || self.lowest(normal, beyond, movement) > -depth
    }

    /// Of what both ends are beyond a plane, the least that is left of that in a box of joint angles, m.
    fn lowest(&self, normal: Vec3, beyond: [f64; 2], movement: &Movement) -> f64 {
        let [elbow, wrist] = movement.both(normal).map(|range| range.low);
        let lowest = |k: usize| beyond[k] + self.ends[k].of(-movement.shoulder, elbow, wrist);
        lowest(0).min(lowest(1))
    }

    /// Where the limb is nearest to a solid in the middle of a box of joint angles; none if they cannot overlap by `depth` in
    /// it. The plane between them is remembered: it will often do for the next box, too.
    pub(super) fn may_touch(
        &self,
        (link, last): (&Solid, &Cell<Option<Plane>>),
        depth: f64,
        placed: &Placed,
        movement: &Movement,
    ) -> Option<Closest> {
        let ends = self.ends.map(|end| end.at(placed));
        let at_most = self.ends.map(|end| movement.at_most(end));
        let apart = |distance: f64| distance - self.radius - at_most[0].max(at_most[1]) > -depth;
        if (!link.is_capsule() && apart(link.at_least(ends[0], ends[1])))
            || self.is_beyond(last, depth, placed, movement)
        {
            return None;
        }
        // No farther than this, they may overlap by `depth`; below zero they have to be as deep as that already.
        let far = self.radius + at_most[0].max(at_most[1]) - depth;
        let near = match link {
            _ if far < 0.0 => link.segment_distance(ends[0], ends[1]),
            Solid::Hull(hull) if hull.is_cut() => match hull.within(ends[0], ends[1], far) {
                Ok(near) => near,
                Err(normal) => {
                    Plane::remember_across(last, hull, normal);
                    return None;
                }
            },
            _ => link.segment_gap(ends[0], ends[1]),
        };
        Plane::remember(last, link, &near);
        if apart(near.distance) {
            return None;
        }
        let Some(n) = link.outward(&near).filter(|_| link.is_convex()) else { return Some(near) };
        // Signed distance from a convex solid is convex: it stays above its tangent plane.
        let plane = ends.map(|end| near.distance + (end - near.on_first).dot(n) - self.radius);
        (self.lowest(n, plane, movement) <= -depth).then_some(near)
    }

    /// Where the points of a solid can be at which the limb touches it within a box of joint angles, if the contact stays one
    /// when the arm moves by `tolerance`; `near` is where they are nearest in the middle.
    ///
    /// Such a contact may be moved by the tolerance towards the middle of the box, so only what is left of the movement
    /// counts, m. Let v be the vector from a capsule's core to the limb's axis. It is the shortest vector of the convex set
    /// of all such differences, which lies beyond a plane at |v| and moves by at most m: so the shortest one afterwards is
    /// no shorter along v than |v| - m, and no longer than |v| + m, and the cosine of the angle between the two at least
    /// (|v| - m) / (|v| + m). The touched point is on that side of the core.
    pub(super) fn touched(
        &self,
        link: &Solid,
        near: &Closest,
        tolerance: f64,
        placed: &Placed,
        movement: &Movement,
    ) -> Touched {
        let ends = self.ends.map(|end| end.at(placed));
        let at_most = self.ends.map(|end| movement.at_most(end));
        let by = (at_most[0].max(at_most[1]) - tolerance).max(0.0);
        let on_core = match (link, link.outward(near)) {
            (Solid::Capsule(c), Some(outward)) if near.distance + c.radius > by => {
                let from_core = near.distance + c.radius;
                let turned = 2.0 * (by / (from_core + by)).sqrt();
                let (middle, half) = ((c.a + c.b) * 0.5, 0.5 * (c.b - c.a).length());
                Some((middle + outward * c.radius, half + c.radius * turned))
            }
            _ => None,
        };
        // An axis that stays outside is no farther from what the limb touches than it is thick, and of a slab of a hull what it
        // touches from inside is on the axis. Speed is a convex function of the point, so it is greatest around one of the ends.
        let beside = match link {
            Solid::Hull(hull) if hull.is_cut() => {
                let beside = (self.radius + by).max(at_most[0].max(at_most[1]));
                let (centre, radius) = link.bounding_sphere();
                Some(near_ball(ends, centre, radius + beside).map(|end| (end, beside)))
            }
            _ => (near.distance > by).then(|| ends.map(|end| (end, self.radius + by))),
        };
        Touched { on_core, beside }
    }
}

/// The ends of what of a segment is in a ball; of one that is not, its point that is nearest to that, twice.
fn near_ball([a, b]: [Vec3; 2], centre: Vec3, radius: f64) -> [Vec3; 2] {
    let (along, to) = (b - a, centre - a);
    let length = along.length();
    if length < SHORT_M {
        return [a, b];
    }
    let middle = to.dot(along) / (length * length);
    let across = (to - along * middle).length();
    let half = (radius * radius - across * across).max(0.0).sqrt() / length;
    [middle - half, middle + half].map(|part| a + along * part.clamp(0.0, 1.0))
}

/// A segment below this is a point, m.
const SHORT_M: f64 = 1e-9;

/// Balls, each given by its centre and radius, that hold the points of a solid at which a limb touches it.
pub(super) struct Touched {
    /// One that holds them all, for a capsule.
    pub(super) on_core: Option<(Vec3, f64)>,
    /// Two of which the hull of both holds them all.
    pub(super) beside: Option<[(Vec3, f64); 2]>,
}

/// How far the point of a convex solid that is nearest to the wrist can move within a box of joint angles.
///
/// No farther than the wrist, as for any convex set. On a capsule of radius R it is c + R u: the core's nearest point c
/// moves along the core's direction only, as far as the wrist does along it; and u, the direction of v from there to the
/// wrist, turns the less the farther away the wrist is. The way v changes by no more than the wrist moves, so with d for
/// that movement u differs by at most d / (|v| - d / 2), and from its first order, the part of the movement across u over
/// |v|, by at most 0.58 (d / (|v| - d))^2: half its second derivative, whose norm is below 1.155 / |v|^2.
pub(super) struct NearestMoves<'a> {
    movement: &'a Movement,
    capsule: Option<SeenCapsule>,
}

/// See [`NearestMoves`].
pub(super) struct SeenCapsule {
    /// Direction of the core; zero for a ball.
    core: Vec3,
    /// How far the wrist moves along it, m.
    along_core: f64,
    outward: Vec3,
    /// R / |v|.
    ratio: f64,
    /// Most that turning moves the surface point, m.
    turning: f64,
    /// What its first order leaves out, m.
    rest: f64,
}

impl<'a> NearestMoves<'a> {
    /// Of a convex solid and a wrist outside it.
    pub(super) fn new(solid: &Solid, near: &Closest, movement: &'a Movement) -> Self {
        let by = movement.wrist;
        let capsule = match (solid, solid.outward(near)) {
            (Solid::Capsule(c), Some(outward)) if near.distance + c.radius > by => {
                let from_core = near.distance + c.radius;
                let core = (c.b - c.a).normalize_or_zero();
                let beyond = by / (from_core - by);
                Some(SeenCapsule {
                    core,
                    along_core: if core == Vec3::ZERO { 0.0 } else { movement.wrist(core).most() },
                    outward,
                    ratio: c.radius / from_core,
                    turning: c.radius * by / (from_core - 0.5 * by),
                    rest: 0.58 * c.radius * beyond * beyond,
                })
            }
            _ => None,
        };
        Self { movement, capsule }
    }

    /// Along the unit vector `n`, m.
    pub(super) fn along(&self, n: Vec3) -> f64 {
        let by = self.movement.wrist;
        let Some(c) = &self.capsule else { return by };
        let across = n - c.outward * n.dot(c.outward);
        let wrist = self.movement.wrist(across).most();
        let turning = c.ratio * (wrist + across.dot(c.core).abs() * c.along_core) + c.rest;
        by.min(c.core.dot(n).abs() * c.along_core + turning.min(c.turning))
    }

    /// In any direction, m.
    pub(super) fn at_most(&self) -> f64 {
        let by = self.movement.wrist;
        self.capsule.as_ref().map_or(by, |c| by.min(c.along_core + c.turning))
    }
}
