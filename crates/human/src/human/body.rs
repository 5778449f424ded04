//! The body of the virtual human as ten capsules, scaled by stature, and where they are in a given pose.
//!
//! Everything above the hip pivot (abdomen, chest, neck, head, shoulders) is one rigid trunk that bends about it;
//! pelvis and legs stay upright, but in the low postures ([`super::low`]). Arms are not part of it: they are searched for,
//! from [`PlacedBody::shoulder`].
//! Body frames: x forward, y left, z up. The measures are those of a median man (ANSUR II, shaped as capsules; a
//! modelling choice), and all of them scale with stature.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::low::{HIP_PIVOT, Legs, OnFloor};
use super::part::{BodyPart, Side};
use super::placed::{SHOULDER_OUT, SHOULDER_UP, moved, shoulder_line};
use super::{BendFraction, PlacedBody, Posture};
use crate::geometry::{Capsule, Pose, Rotation, Vec3, rotation_about};
use crate::standards::anthropometry::{Percentile, Sex, measures};

/// Stature of the median man for whom the measures below are given, m.
const REFERENCE_STATURE_M: f64 = 1.755;
/// Centre of the head above the hip pivot.
const HEAD_UP: f64 = 0.72;
const HEAD_RADIUS: f64 = 0.105;
/// Radius of the upright capsule that stands for the whole body when it walks into something.
const BLOCKING_RADIUS: f64 = 0.14;
/// Lowest point of that capsule: cables and door sills do not stop a walk.
const BLOCKING_FROM: f64 = 0.05;

/// Capsule of the median man: in the trunk frame (origin at the hip pivot) for trunk parts, else in the frame of
/// the feet (origin on the floor).
fn reference_capsule(part: BodyPart) -> Capsule {
    let upright = |out: f64, low: f64, high: f64, radius: f64| Capsule {
        a: Vec3::new(0.0, out, low),
        b: Vec3::new(0.0, out, high),
        radius,
    };
    let level = |half_width: f64, up: f64, radius: f64| Capsule {
        a: Vec3::new(0.0, half_width, up),
        b: Vec3::new(0.0, -half_width, up),
        radius,
    };
    match part {
        BodyPart::Head => level(0.0, HEAD_UP, HEAD_RADIUS),
        BodyPart::Neck => upright(0.0, 0.52, 0.62, 0.06),
        BodyPart::UpperChest => level(0.08, 0.40, 0.13),
        BodyPart::LowerChest => level(0.08, 0.25, 0.14),
        BodyPart::Abdomen => level(0.0, 0.12, 0.13),
        BodyPart::Pelvis => level(0.07, 0.95, 0.14),
        BodyPart::LeftThigh => upright(0.09, 0.49, 0.85, 0.08),
        BodyPart::RightThigh => upright(-0.09, 0.49, 0.85, 0.08),
        // Down to the floor: the feet are counted as lower legs.
        BodyPart::LeftShank => upright(0.09, 0.055, 0.49, 0.055),
        BodyPart::RightShank => upright(-0.09, 0.055, 0.49, 0.055),
    }
}

/// Radii of body parts, m, instead of those of the median man scaled by stature: of the person who will work there, or with
/// thick clothes. What stops a walk, and where joints are, stays as it is.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(default, deny_unknown_fields)]
pub struct Radii {
    /// Head, a sphere.
    pub head: Option<f64>,
    /// Neck.
    pub neck: Option<f64>,
    /// Chest at the height of the armpits, and shoulders.
    pub upper_chest: Option<f64>,
    /// Chest at the height of the lower ribs.
    pub lower_chest: Option<f64>,
    /// Abdomen.
    pub abdomen: Option<f64>,
    /// Pelvis.
    pub pelvis: Option<f64>,
    /// Both thighs.
    pub thigh: Option<f64>,
    /// Both lower legs.
    pub shank: Option<f64>,
}

impl Radii {
    /// The radius of a part, if it is told.
    const fn of(&self, part: BodyPart) -> Option<f64> {
        match part {
            BodyPart::Head => self.head,
            BodyPart::Neck => self.neck,
            BodyPart::UpperChest => self.upper_chest,
            BodyPart::LowerChest => self.lower_chest,
            BodyPart::Abdomen => self.abdomen,
            BodyPart::Pelvis => self.pelvis,
            BodyPart::LeftThigh | BodyPart::RightThigh => self.thigh,
            BodyPart::LeftShank | BodyPart::RightShank => self.shank,
        }
    }
}

/// Whose body it is and how far it bends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
#[serde(default, deny_unknown_fields)]
pub struct Anthropometry {
    /// Population.
    pub sex: Sex,
    /// Percentile of stature within it.
    pub percentile: Percentile,
    /// Forward bend about the hip, degrees in 0..=90.
    pub bend_forward_deg: f64,
    /// Sideways bend about the hip, degrees in 0..=90.
    pub bend_lateral_deg: f64,
    /// Radii that are not those of the median man.
    pub radii_m: Radii,
}

impl Default for Anthropometry {
    /// Median man, 45 degrees forward, 30 degrees sideways.
    fn default() -> Self {
        Self {
            sex: Sex::Man,
            percentile: Percentile::P50,
            bend_forward_deg: 45.0,
            bend_lateral_deg: 30.0,
            radii_m: Radii::default(),
        }
    }
}

/// A body that cannot be built.
#[derive(Clone, Copy, Debug, PartialEq, Error)]
pub enum BodyError {
    /// A bend that no trunk makes, or no number.
    #[error("the human's `{parameter}` is {degrees}: give an angle from 0 to 90 degrees")]
    BendOutOfRange {
        /// Name of the parameter.
        parameter: &'static str,
        /// Its value.
        degrees: f64,
    },
    /// A radius that no part of a body has, or no number.
    #[error("the human's radius of `{}` is {metres} m: give one from 0.02 to 0.4 m", part.name())]
    RadiusOutOfRange {
        /// The part.
        part: BodyPart,
        /// Its value.
        metres: f64,
    },
}

/// A body with its measures, not yet placed anywhere.
#[derive(Clone, Debug, PartialEq)]
pub struct Body {
    measures: Anthropometry,
    stature_m: f64,
    scale: f64,
    /// In the order of `BodyPart::ALL`, scaled, in the frames of `BodyPart::reference_capsule`.
    capsules: [Capsule; BodyPart::ALL.len()],
    /// Rotation of the trunk against the feet, by posture and sixteenths of its bend.
    bends: [[Rotation; BendFraction::STEPS]; Posture::ALL.len()],
    /// Where the legs are in the low postures, by sixteenths.
    legs: [[Legs; BendFraction::STEPS]; Posture::LOW.len()],
}

impl Body {
    /// Number of shapes that bends are tested with.
    pub(super) const GUARDED: usize = 7;

    /// A body with these measures.
    ///
    /// # Errors
    /// When a bend angle is outside 0 to 90 degrees, or a radius outside 0.02 to 0.4 m.
    pub fn new(parameters: &Anthropometry) -> Result<Self, BodyError> {
        let Anthropometry { sex, percentile, bend_forward_deg, bend_lateral_deg, radii_m } = *parameters;
        for (parameter, degrees) in [("bend_forward_deg", bend_forward_deg), ("bend_lateral_deg", bend_lateral_deg)] {
            if !(0.0..=90.0).contains(&degrees) {
                return Err(BodyError::BendOutOfRange { parameter, degrees });
            }
        }
        let stature_m = measures(sex, percentile).stature_m;
        let scale = stature_m / REFERENCE_STATURE_M;
        let mut capsules = BodyPart::ALL.map(|part| {
            let capsule = reference_capsule(part);
            Capsule { a: scale * capsule.a, b: scale * capsule.b, radius: scale * capsule.radius }
        });
        for (part, capsule) in BodyPart::ALL.into_iter().zip(&mut capsules) {
            let Some(metres) = radii_m.of(part) else { continue };
            if !(0.02..=0.4).contains(&metres) {
                return Err(BodyError::RadiusOutOfRange { part, metres });
            }
            capsule.radius = metres;
            if matches!(part, BodyPart::LeftShank | BodyPart::RightShank) {
                // Still down to the floor, and not below it.
                capsule.a.z = metres.min(capsule.b.z);
            }
        }
        let legs = Posture::LOW.map(|posture| BendFraction::ALL.map(|fraction| Legs::new(posture, fraction, scale)));
        let bends = Posture::ALL.map(|posture| {
            BendFraction::ALL.map(|fraction| {
                if posture.is_low() {
                    return rotation_about(Vec3::Y, Legs::lean_rad(posture, fraction));
                }
                let forward = posture.forward_share() * fraction.share() * bend_forward_deg.to_radians();
                let left = posture.left_share() * fraction.share() * bend_lateral_deg.to_radians();
                // Forward first, then sideways about the pelvis' own forward axis: the diagonal reaches as far forward
                // as the plain forward bend does.
                rotation_about(Vec3::X, -left) * rotation_about(Vec3::Y, forward)
            })
        });
        Ok(Self { measures: *parameters, stature_m, scale, capsules, bends, legs })
    }

    /// What it was made from.
    #[must_use]
    pub const fn measures(&self) -> &Anthropometry {
        &self.measures
    }

    /// Stature, m.
    #[cfg(test)]
    pub(crate) const fn stature_m(&self) -> f64 {
        self.stature_m
    }

    /// Stature over that of the median man, by which every measure is scaled.
    #[cfg(test)]
    pub(crate) const fn scale(&self) -> f64 {
        self.scale
    }

    /// The shape that stops the walk: an upright capsule around the middle of the body, from just above the floor to
    /// the top of the head. It is the same for every heading, and for every posture of who stands, so whether a walk is blocked
    /// does not depend on them; in low postures it is as high as the body is then. `position` on the floor, world frame.
    #[must_use]
    pub fn blocking_capsule(&self, position: Vec3, posture: Posture) -> Capsule {
        let radius = self.scale * BLOCKING_RADIUS;
        Capsule {
            a: position + Vec3::new(0.0, 0.0, BLOCKING_FROM + radius),
            b: position + Vec3::new(0.0, 0.0, self.height_m(posture) - radius),
            radius,
        }
    }

    /// How high the body is in a posture, m: the stature for every posture of who stands.
    #[must_use]
    pub fn height_m(&self, posture: Posture) -> f64 {
        if !posture.is_low() {
            return self.stature_m;
        }
        let placed = self.placed(Vec3::ZERO, 0.0, posture, BendFraction::FULL);
        placed.parts().iter().map(|(_, c)| c.a.z.max(c.b.z) + c.radius).fold(0.0, f64::max)
    }

    /// Where the feet stand: the floor points below both legs, left first, world frame.
    #[must_use]
    pub fn feet(&self, position: Vec3, heading_rad: f64) -> [Vec3; 2] {
        let world_from_feet = Pose::from_parts(position, rotation_about(Vec3::Z, heading_rad));
        [BodyPart::LeftShank, BodyPart::RightShank].map(|shank| {
            let foot = world_from_feet * self.capsules[shank as usize].b;
            Vec3::new(foot.x, foot.y, 0.0)
        })
    }

    /// What touches the floor, `position` on it, world frame: the feet of who stands or crouches, and knees and hands of who
    /// kneels or crawls.
    #[must_use]
    pub fn on_floor(&self, position: Vec3, heading_rad: f64, posture: Posture, fraction: BendFraction) -> OnFloor {
        match self.legs_in(posture, fraction) {
            Some(legs) => legs.on_floor(&world_from_feet(position, heading_rad), posture, fraction),
            None => OnFloor { feet: self.feet(position, heading_rad), besides: None },
        }
    }

    /// How long the legs are along the heading, as far as they are lower than this in a low posture, m.
    #[must_use]
    pub fn legs_below_m(&self, posture: Posture, height_m: f64) -> f64 {
        let placed = self.placed(Vec3::ZERO, 0.0, posture, BendFraction::FULL);
        let legs = placed.parts().iter().filter(|(part, _)| !part.is_trunk()).map(|(_, capsule)| capsule);
        let below = legs.filter(|c| c.a.z.min(c.b.z) - c.radius < height_m);
        let ends = below.flat_map(|c| [c.a.x - c.radius, c.a.x + c.radius, c.b.x - c.radius, c.b.x + c.radius]);
        let (low, high) = ends.fold((f64::MAX, f64::MIN), |(low, high), x| (low.min(x), high.max(x)));
        (high - low).max(0.0)
    }

    /// Radius of a sphere around the point 1 m above the feet that holds the body and every arm `arm_reach_m` long, in
    /// every posture of who stands and in those low ones.
    #[must_use]
    pub fn reach_from_one_metre(&self, arm_reach_m: f64, low: &[Posture]) -> f64 {
        let (hip, reach) = self.reach_from_hip(arm_reach_m);
        let trunk = (hip - 1.0).abs() + self.trunk_radius().max(reach);
        let standing = trunk.max(self.farthest(Vec3::Z, |part| !part.is_trunk()));
        let farthest = |posture: Posture| {
            let far = |legs: &Legs| (legs.hip() - Vec3::Z).length() + self.trunk_radius().max(reach);
            let trunk = self.legs[low_number(posture)].iter().map(far).fold(0.0, f64::max);
            let body = BendFraction::ALL.map(|fraction| {
                let placed = self.placed(Vec3::ZERO, 0.0, posture, fraction);
                let ends =
                    placed.parts().iter().flat_map(|(_, c)| [c.a, c.b].map(|end| (end - Vec3::Z).length() + c.radius));
                ends.fold(0.0, f64::max)
            });
            body.into_iter().fold(trunk, f64::max)
        };
        low.iter().map(|posture| farthest(*posture)).fold(standing, f64::max)
    }

    /// The height of the hip pivot above the feet, and how long the way from there to the end of an arm `arm_reach_m` long is at
    /// most, past the shoulder, m.
    #[must_use]
    pub fn reach_from_hip(&self, arm_reach_m: f64) -> (f64, f64) {
        let shoulder = self.scale * Vec3::new(0.0, SHOULDER_OUT, SHOULDER_UP).length();
        (self.scale * HIP_PIVOT, shoulder + arm_reach_m)
    }

    /// Radius of a sphere around the hip pivot that holds the trunk in every posture, m.
    fn trunk_radius(&self) -> f64 {
        self.farthest(Vec3::ZERO, BodyPart::is_trunk)
    }

    /// The farthest from `point`, in their frame, of those parts, m.
    fn farthest(&self, point: Vec3, of: impl Fn(BodyPart) -> bool) -> f64 {
        let parts = BodyPart::ALL.into_iter().zip(&self.capsules).filter(|(part, _)| of(*part));
        let far = parts.map(|(_, c)| (c.a - point).length().max((c.b - point).length()) + c.radius);
        far.fold(0.0, f64::max)
    }

    /// A sphere around the hip pivot of who stands that holds the trunk on its whole way into a posture.
    pub(super) fn trunk_reach(&self, position: Vec3, posture: Posture) -> Capsule {
        let upright = Vec3::new(0.0, 0.0, self.scale * HIP_PIVOT);
        let farther = if posture.is_low() {
            self.legs[low_number(posture)].iter().map(|legs| (legs.hip() - upright).length()).fold(0.0, f64::max)
        } else {
            0.0
        };
        let hip = position + upright;
        Capsule { a: hip, b: hip, radius: self.trunk_radius() + farther }
    }

    /// Where the legs are, in a low posture.
    fn legs_in(&self, posture: Posture, fraction: BendFraction) -> Option<&Legs> {
        posture.is_low().then(|| &self.legs[low_number(posture)][usize::from(fraction.sixteenths())])
    }

    /// What a bend must not push into an obstacle, in the trunk frame: head, neck, chest, and the lines of the shoulders
    /// and the spine (capsules of radius 0).
    pub(super) fn guarded(&self) -> [Capsule; Self::GUARDED] {
        let [head, neck, upper_chest, lower_chest, ..] = self.capsules;
        let spine = Capsule { a: Vec3::ZERO, b: head.a, radius: 0.0 };
        let [left, right] = Side::BOTH.map(|side| shoulder_line(self.scale, side));
        [head, neck, upper_chest, lower_chest, left, right, spine]
    }

    /// The lines of pelvis, thighs and shanks in a low posture, world frame: what must not be pushed through a wall either.
    pub(super) fn leg_lines(&self, world_from_feet: &Pose, posture: Posture, fraction: BendFraction) -> Vec<Capsule> {
        let legs = BodyPart::ALL.into_iter().filter(|part| !part.is_trunk());
        let line = |legs_in: &Legs, part: BodyPart| {
            let capsule = moved(&(*world_from_feet * *legs_in.pose_of(part)), &self.capsules[part as usize]);
            Capsule { radius: 0.0, ..capsule }
        };
        self.legs_in(posture, fraction).map_or_else(Vec::new, |bent| legs.map(|part| line(bent, part)).collect())
    }

    /// The body at `position` (on the floor, world frame), looking along `heading_rad` (anticlockwise from +x), with
    /// that much of the posture's bend.
    #[must_use]
    pub fn placed(&self, position: Vec3, heading_rad: f64, posture: Posture, fraction: BendFraction) -> PlacedBody {
        let world_from_feet = world_from_feet(position, heading_rad);
        let world_from_trunk = self.world_from_trunk(&world_from_feet, posture, fraction);
        let legs = self.legs_in(posture, fraction);
        let parts = std::array::from_fn(|index| {
            let part = BodyPart::ALL[index];
            let bent = legs.filter(|_| !part.is_trunk()).map(|legs| world_from_feet * *legs.pose_of(part));
            let upright = if part.is_trunk() { &world_from_trunk } else { &world_from_feet };
            (part, moved(bent.as_ref().unwrap_or(upright), &self.capsules[index]))
        });
        PlacedBody::new(parts, world_from_trunk, self.scale)
    }

    /// Origin at the hip pivot, axes of the trunk.
    pub(super) fn world_from_trunk(&self, world_from_feet: &Pose, posture: Posture, fraction: BendFraction) -> Pose {
        let upright = Vec3::new(0.0, 0.0, self.scale * HIP_PIVOT);
        let hip = self.legs_in(posture, fraction).map_or(upright, Legs::hip);
        let bend = self.bends[posture as usize][usize::from(fraction.sixteenths())];
        *world_from_feet * Pose::from_parts(hip, bend)
    }
}

/// The place of a low posture in the list of those.
const fn low_number(posture: Posture) -> usize {
    posture as usize - Posture::USUAL.len()
}

/// Origin on the floor between the feet, x along the heading, z up.
pub(super) fn world_from_feet(position: Vec3, heading_rad: f64) -> Pose {
    Pose::from_parts(position, rotation_about(Vec3::Z, heading_rad))
}

#[cfg(test)]
#[path = "body_tests.rs"]
mod tests;
