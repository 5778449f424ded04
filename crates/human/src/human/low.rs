//! The low postures: kneeling, crouching, crawling. Where the legs are then, and what touches the floor.
//!
//! A leg is two rigid segments in the plane of the walk, each turned about the lateral axis: the shank by an angle forward from
//! upright, the thigh by one backward, the trunk leans forward. All three grow with the share of the posture, so the lengths of the
//! limbs stay what they are, and a body that is kept from going down all the way is somewhere between. With the measures of the
//! median man the body is 1.31 m (kneeling), 0.84 m (crouching) and 0.65 m (crawling) high and crawls 1.3 m long: the figures
//! of a modelling choice, tested in `body_tests.rs`, not of a standard.
//!
//! The place where somebody is lies below the knees of who kneels, below the feet of who crouches, and below the middle of who
//! crawls.

use super::part::BodyPart;
use super::{BendFraction, Posture};
use crate::geometry::{Pose, Vec3, rotation_about};

/// Ankle and knee of the standing median man above the floor, m.
const ANKLE: f64 = 0.055;
const KNEE: f64 = 0.49;
/// Height of the hip pivot, m.
pub(super) const HIP_PIVOT: f64 = 0.92;
/// From the hip pivot to the shoulders, along the trunk, and from the middle to each hand on the floor, m.
const SHOULDERS: f64 = 0.48;
const HANDS_OUT: f64 = 0.19;

/// How a posture is taken, for all of it.
struct Bent {
    /// Where the ankles are before the place, m.
    ankles_m: f64,
    /// Shanks forward from upright, degrees.
    shank_deg: f64,
    /// Thighs backward from upright, degrees.
    thigh_deg: f64,
    /// Trunk forward from upright, degrees.
    lean_deg: f64,
}

impl Bent {
    const fn of(posture: Posture) -> Self {
        match posture {
            Posture::Kneeling => Self { ankles_m: ANKLE - KNEE, shank_deg: 90.0, thigh_deg: 0.0, lean_deg: 0.0 },
            Posture::Crouching => Self { ankles_m: 0.0, shank_deg: 35.0, thigh_deg: 95.0, lean_deg: 60.0 },
            Posture::Crawling => {
                Self { ankles_m: ANKLE - KNEE - 0.25, shank_deg: 90.0, thigh_deg: 0.0, lean_deg: 85.0 }
            }
            _ => Self { ankles_m: 0.0, shank_deg: 0.0, thigh_deg: 0.0, lean_deg: 0.0 },
        }
    }
}

/// What touches the floor, world frame, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OnFloor {
    /// Left and right foot; of who kneels or crawls, the knees.
    pub feet: [Vec3; 2],
    /// Of who kneels, the toes; of who crawls, toes and hands.
    pub besides: Option<[Vec3; 4]>,
}

/// Where pelvis and legs are in one low posture, in the frame of the feet.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Legs {
    ankle: Vec3,
    knee: Vec3,
    hip: Vec3,
    scale: f64,
    /// Where the parts of somebody upright get to.
    pelvis: Pose,
    thigh: Pose,
    shank: Pose,
}

impl Legs {
    /// The legs with that much of the posture.
    pub(super) fn new(posture: Posture, fraction: BendFraction, scale: f64) -> Self {
        let Bent { ankles_m, shank_deg, thigh_deg, .. } = Bent::of(posture);
        let share = fraction.share();
        let shank = rotation_about(Vec3::Y, share * shank_deg.to_radians());
        let thigh = rotation_about(Vec3::Y, -share * thigh_deg.to_radians());
        let up = |height: f64| scale * Vec3::new(0.0, 0.0, height);
        let ankle = scale * Vec3::new(share * ankles_m, 0.0, ANKLE);
        let knee = ankle + shank * up(KNEE - ANKLE);
        let hip = knee + thigh * up(HIP_PIVOT - KNEE);
        Self {
            ankle,
            knee,
            hip,
            scale,
            pelvis: Pose::from_translation(hip - up(HIP_PIVOT)),
            thigh: Pose::from_parts(knee - thigh * up(KNEE), thigh),
            shank: Pose::from_parts(ankle - shank * up(ANKLE), shank),
        }
    }

    /// How far the trunk leans forward in a low posture, rad.
    pub(super) fn lean_rad(posture: Posture, fraction: BendFraction) -> f64 {
        fraction.share() * Bent::of(posture).lean_deg.to_radians()
    }

    /// The hip pivot, in the frame of the feet.
    pub(super) const fn hip(&self) -> Vec3 {
        self.hip
    }

    /// Where a part that is no part of the trunk gets to, from where it is on somebody upright.
    pub(super) const fn pose_of(&self, part: BodyPart) -> &Pose {
        match part {
            BodyPart::LeftShank | BodyPart::RightShank => &self.shank,
            BodyPart::LeftThigh | BodyPart::RightThigh => &self.thigh,
            _ => &self.pelvis,
        }
    }

    /// What touches the floor. Knees and hands do so only with all of the posture.
    pub(super) fn on_floor(&self, world_from_feet: &Pose, posture: Posture, fraction: BendFraction) -> OnFloor {
        const LEGS_OUT: f64 = 0.09;
        let both =
            |x: f64, out: f64| [out, -out].map(|y| (*world_from_feet * Vec3::new(x, self.scale * y, 0.0)).with_z(0.0));
        let (ankles, knees) = (both(self.ankle.x, LEGS_OUT), both(self.knee.x, LEGS_OUT));
        if fraction != BendFraction::FULL || posture == Posture::Crouching {
            return OnFloor { feet: ankles, besides: None };
        }
        let hands = if posture == Posture::Crawling {
            let lean = Self::lean_rad(posture, fraction);
            both(self.hip.x + self.scale * SHOULDERS * libm::sin(lean), HANDS_OUT)
        } else {
            ankles
        };
        OnFloor { feet: knees, besides: Some([ankles[0], ankles[1], hands[0], hands[1]]) }
    }
}
