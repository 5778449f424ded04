//! How far points of an arm move within a box of joint angles, how near to a solid a limb comes with that, and how far
//! the solid's nearest point moves along.

use super::joint_box::JointBox;
use crate::geometry::{Closest, Solid, Vec3};
use crate::human::arm::ArmModel;

/// The arm in one configuration, world.
#[derive(Clone, Copy)]
pub(super) struct Placed {
    pub(super) shoulder: Vec3,
    pub(super) elbow: Vec3,
    pub(super) wrist: Vec3,
    /// Movement of elbow and wrist with each joint, world, m/rad.
    pub(super) derivatives: [[Vec3; 2]; 4],
}

/// How far elbow and wrist can be from where they are in the middle of a box, joint by joint, m.
pub(super) struct Movement {
    pub(super) elbow: f64,
    pub(super) wrist_by_joint: [f64; 4],
    pub(super) wrist: f64,
    pub(super) half: [f64; 4],
    /// What the first-order movement of elbow and wrist leaves out, at most, m.
    pub(super) elbow_rest: f64,
    pub(super) wrist_rest: f64,
}

impl Movement {
    /// Within the box `b`, in whose middle the arm is `placed`.
    ///
    /// The joints are turned from the middle to any configuration of the box one after the other, the outermost first: when
    /// its turn comes, what is beyond a joint is still as in the middle, so its lever is the one there. Second derivatives
    /// are those of any configuration: there a lever is longer by no more than what the joints beyond it move.
    pub(super) fn of(arm: &ArmModel, b: &JointBox, placed: &Placed) -> Self {
        let (upper, fore) = (arm.upper_arm_m, arm.forearm_m);
        // The wrist is farthest from the shoulder with the elbow as straight as the box allows, and farthest from the
        // upper arm's axis with the elbow as near the right angle as it allows.
        let straightest = b.low(3).max(0.0);
        let from_shoulder = (upper * upper + fore * fore + 2.0 * upper * fore * libm::cos(straightest)).sqrt();
        let right_angle = std::f64::consts::FRAC_PI_2.clamp(b.low(3), b.high(3));
        let from_axis = fore * libm::sin(right_angle).abs();
        let anywhere = [from_shoulder, from_shoulder, from_axis, fore];
        // A point at distance r that turns by an angle h moves along an arc, by a chord of 2 r sin(h / 2).
        let chords = b.half.map(|h| 2.0 * libm::sin(0.5 * h.min(std::f64::consts::PI)));
        // A derivative is as long as the distance from the axis; by rounding it may be told too short.
        let lever = |joint: usize, point: usize| placed.derivatives[joint][point].length() * (1.0 + 1e-12);
        let middle: [f64; 4] = std::array::from_fn(|joint| lever(joint, 1).min(anywhere[joint]));
        let wrist_by_joint: [f64; 4] = std::array::from_fn(|joint| middle[joint] * chords[joint]);
        let beyond = |joint: usize| wrist_by_joint[joint + 1..].iter().sum::<f64>();
        let levers: [f64; 4] = std::array::from_fn(|joint| (middle[joint] + beyond(joint)).min(anywhere[joint]));
        // Taylor: the second derivative by two joints is at most the lever of the inner one, because the inner joint
        // moves the point and the outer only turns that movement.
        let pairs = (0..4).flat_map(|i| (0..4).map(move |j| (i, j)));
        let wrist_rest = 0.5 * pairs.map(|(i, j)| b.half[i] * b.half[j] * levers[i.max(j)]).sum::<f64>();
        let abducted = lever(0, 0).min(upper);
        let most = (abducted + upper * chords[1]).min(upper);
        let [abduction, flexion, ..] = b.half;
        Self {
            elbow: abducted * chords[0] + upper * chords[1],
            wrist: wrist_by_joint.iter().sum(),
            wrist_by_joint,
            half: b.half,
            elbow_rest: 0.5 * (most * abduction * abduction + upper * flexion * (2.0 * abduction + flexion)),
            wrist_rest,
        }
    }

    /// How far elbow and wrist can move along the unit vector `n`, m: first order plus the rest.
    pub(super) fn along(&self, placed: &Placed, n: Vec3) -> (f64, f64) {
        let sum = |point: usize| (0..4).map(|j| placed.derivatives[j][point].dot(n).abs() * self.half[j]).sum::<f64>();
        ((sum(0) + self.elbow_rest).min(self.elbow), (sum(1) + self.wrist_rest).min(self.wrist))
    }

    /// The joint whose halving shrinks the movement most.
    pub(super) fn widest_joint(&self) -> usize {
        (1..4).fold(0, |best, j| if self.wrist_by_joint[j] > self.wrist_by_joint[best] { j } else { best })
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

    pub(super) const fn of(self, elbow: f64, wrist: f64) -> f64 {
        self.elbow * elbow + self.wrist * wrist
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

impl Limb {
    /// Where the limb is nearest to a solid in the middle of a box of joint angles; none if they cannot overlap by `depth` in
    /// it.
    pub(super) fn may_touch(&self, link: &Solid, depth: f64, placed: &Placed, movement: &Movement) -> Option<Closest> {
        let ends = self.ends.map(|end| end.at(placed));
        let at_most = self.ends.map(|end| end.of(movement.elbow, movement.wrist));
        let apart = |distance: f64| distance - self.radius - at_most[0].max(at_most[1]) > -depth;
        if !matches!(link, Solid::Capsule(_)) && apart(link.at_least(ends[0], ends[1])) {
            return None;
        }
        let near = link.segment_distance(ends[0], ends[1]);
        if apart(near.distance) {
            return None;
        }
        let Some(n) = link.outward(&near).filter(|_| link.is_convex()) else { return Some(near) };
        // Signed distance from a convex solid is convex: it stays above its tangent plane.
        let plane = ends.map(|end| near.distance + (end - near.on_first).dot(n) - self.radius);
        let (elbow, wrist) = movement.along(placed, n);
        let nearest = |k: usize| plane[k] - self.ends[k].of(elbow, wrist);
        (nearest(0).min(nearest(1)) <= -depth).then_some(near)
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
        let at_most = self.ends.map(|end| end.of(movement.elbow, movement.wrist));
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
        // An axis that stays outside is no farther from what the limb touches than it is thick. Speed is a convex function
        // of the point, so it is greatest around one of the ends.
        let beside = (near.distance > by).then(|| ends.map(|end| (end, self.radius + by)));
        Touched { on_core, beside }
    }
}

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
    placed: &'a Placed,
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
    pub(super) fn new(solid: &Solid, near: &Closest, placed: &'a Placed, movement: &'a Movement) -> Self {
        let by = movement.wrist;
        let capsule = match (solid, solid.outward(near)) {
            (Solid::Capsule(c), Some(outward)) if near.distance + c.radius > by => {
                let from_core = near.distance + c.radius;
                let core = (c.b - c.a).normalize_or_zero();
                let beyond = by / (from_core - by);
                Some(SeenCapsule {
                    core,
                    along_core: if core == Vec3::ZERO { 0.0 } else { movement.along(placed, core).1 },
                    outward,
                    ratio: c.radius / from_core,
                    turning: c.radius * by / (from_core - 0.5 * by),
                    rest: 0.58 * c.radius * beyond * beyond,
                })
            }
            _ => None,
        };
        Self { placed, movement, capsule }
    }

    /// Along the unit vector `n`, m.
    pub(super) fn along(&self, n: Vec3) -> f64 {
        let by = self.movement.wrist;
        let Some(c) = &self.capsule else { return by };
        let across = n - c.outward * n.dot(c.outward);
        let wrist = self.movement.along(self.placed, across).1;
        let turning = c.ratio * (wrist + across.dot(c.core).abs() * c.along_core) + c.rest;
        by.min(c.core.dot(n).abs() * c.along_core + turning.min(c.turning))
    }

    /// In any direction, m.
    pub(super) fn at_most(&self) -> f64 {
        let by = self.movement.wrist;
        self.capsule.as_ref().map_or(by, |c| by.min(c.along_core + c.turning))
    }
}
