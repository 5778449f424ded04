//! A body in one pose in the world: its capsules, its shoulders, and which body region a contact point belongs to.

use super::part::{BodyPart, Side};
use crate::geometry::{Capsule, Pose, Vec3};
use crate::standards::{BodyArea, BodyRegion};

/// Shoulder joints above the hip pivot, median man, m: 40 mm below the acromion.
pub(super) const SHOULDER_UP: f64 = 0.48;
/// Shoulder joints beside the middle of the body: 20 mm inside the acromion.
pub(super) const SHOULDER_OUT: f64 = 0.19;
/// Xiphoid process above the hip pivot: the front of the trunk is chest above it and abdomen below.
const XIPHOID_UP: f64 = 0.20;
/// Half of the chest's breadth: what sticks out farther beside the upper chest is a shoulder.
const CHEST_HALF_BREADTH: f64 = 0.1445;

/// A body in the world frame. Made by [`super::Body::placed`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedBody {
    parts: [(BodyPart, Capsule); BodyPart::ALL.len()],
    /// Origin at the hip pivot, axes of the trunk: x forward, y left, z up along the spine.
    world_from_trunk: Pose,
    scale: f64,
}

impl PlacedBody {
    pub(super) const fn new(
        parts: [(BodyPart, Capsule); BodyPart::ALL.len()],
        world_from_trunk: Pose,
        scale: f64,
    ) -> Self {
        Self { parts, world_from_trunk, scale }
    }

    /// Every part with its capsule in the world frame, from the head down.
    #[must_use]
    pub const fn parts(&self) -> &[(BodyPart, Capsule); BodyPart::ALL.len()] {
        &self.parts
    }

    /// The capsule of one part, world frame.
    #[must_use]
    pub(crate) const fn capsule(&self, part: BodyPart) -> &Capsule {
        &self.parts[part as usize].1
    }

    /// Frame of the trunk: origin at the hip pivot, x forward, y left, z up along the spine.
    #[must_use]
    pub const fn world_from_trunk(&self) -> Pose {
        self.world_from_trunk
    }

    /// Frame of a shoulder (`world_from_shoulder`): origin at the joint, axes of the trunk.
    #[must_use]
    pub fn shoulder(&self, side: Side) -> Pose {
        let joint = shoulder_line(self.scale, side).b;
        Pose::from_parts(self.world_from_trunk * joint, self.world_from_trunk.rotation)
    }

    /// The middle of the trunk at shoulder height, world: where the bones begin that carry the arms.
    #[must_use]
    pub fn middle_of_shoulders(&self) -> Vec3 {
        self.shoulder_line(Side::Left).a
    }

    /// From the middle of the trunk at shoulder height out to the shoulder joint, world frame.
    pub(super) fn shoulder_line(&self, side: Side) -> Capsule {
        moved(&self.world_from_trunk, &shoulder_line(self.scale, side))
    }

    /// The body region at a point on the surface of `part` (world frame).
    ///
    /// Where regions meet, the more sensitive one is taken. Contact on the limb capsules is their region all round; on
    /// the head, the lower half of the front is the face; the front half of the neck is that of the larynx; on the trunk, the front is chest above the xiphoid process and
    /// abdomen below, the rear and the shoulder caps are back and shoulders.
    #[must_use]
    pub fn region_of(&self, part: BodyPart, contact_point: Vec3) -> BodyRegion {
        let on_trunk = self.world_from_trunk.inverse_transform_point(contact_point) / self.scale;
        match part {
            BodyPart::Head => {
                let centre = self.world_from_trunk.inverse_transform_point(self.capsule(part).a) / self.scale;
                if on_trunk.x >= 0.0 && on_trunk.z <= centre.z { BodyRegion::Face } else { BodyRegion::SkullForehead }
            }
            BodyPart::Neck if on_trunk.x >= 0.0 => BodyRegion::NeckFront,
            BodyPart::Neck => BodyRegion::Neck,
            BodyPart::UpperChest | BodyPart::LowerChest | BodyPart::Abdomen => {
                let shoulder_cap = part == BodyPart::UpperChest && on_trunk.y.abs() > CHEST_HALF_BREADTH;
                if on_trunk.x < 0.0 || shoulder_cap {
                    BodyRegion::BackShoulders
                } else if on_trunk.z >= XIPHOID_UP {
                    BodyRegion::Chest
                } else {
                    BodyRegion::Abdomen
                }
            }
            BodyPart::Pelvis => BodyRegion::Pelvis,
            BodyPart::LeftThigh | BodyPart::RightThigh => BodyRegion::Thigh,
            BodyPart::LeftShank | BodyPart::RightShank => BodyRegion::LowerLeg,
        }
    }

    /// The body area of ISO/TS 15066, Table A.2, at a point on the surface of `part` (world frame), where the point tells those of
    /// its region apart.
    #[must_use]
    pub fn area_of(&self, part: BodyPart, contact_point: Vec3) -> Option<BodyArea> {
        /// Half of the breastbone's width, and some, m.
        const STERNUM_M: f64 = 0.05;
        /// A point this far in front or behind is no longer at the side, m.
        const BESIDE_M: f64 = 0.03;
        let trunk = self.world_from_trunk.inverse_transform_point(contact_point) / self.scale;
        let capsule = self.capsule(part);
        let toward_feet = (capsule.a.z.max(capsule.b.z) - contact_point.z) / self.scale;
        let [left, right] = [BodyPart::LeftShank, BodyPart::RightShank].map(|shank| self.capsule(shank).a);
        let ahead = (left - right).cross(Vec3::Z).dot(contact_point - capsule.a);
        match self.region_of(part, contact_point) {
            BodyRegion::SkullForehead if trunk.x > 2.0 * BESIDE_M => Some(BodyArea::MiddleOfForehead),
            BodyRegion::Face => Some(BodyArea::MasticatoryMuscle),
            BodyRegion::Chest if trunk.y.abs() > STERNUM_M => Some(BodyArea::PectoralMuscle),
            BodyRegion::Abdomen => Some(BodyArea::AbdominalMuscle),
            BodyRegion::BackShoulders if trunk.x < -BESIDE_M && trunk.z < XIPHOID_UP => {
                Some(BodyArea::FifthLumbarVertebra)
            }
            BodyRegion::Pelvis => Some(BodyArea::PelvicBone),
            BodyRegion::Thigh if toward_feet < 0.2 => Some(BodyArea::ThighMuscle),
            BodyRegion::LowerLeg if ahead > 0.0 => Some(BodyArea::MiddleOfShin),
            _ => None,
        }
    }
}

/// The capsule, given in frame `b`, in frame `a`.
pub(super) fn moved(a_from_b: &Pose, capsule: &Capsule) -> Capsule {
    Capsule { a: *a_from_b * capsule.a, b: *a_from_b * capsule.b, radius: capsule.radius }
}

/// From the middle of the trunk at shoulder height out to the shoulder joint, in the trunk frame: the bones that carry
/// the arm. A capsule of radius 0.
pub(super) fn shoulder_line(scale: f64, side: Side) -> Capsule {
    let middle = Vec3::new(0.0, 0.0, SHOULDER_UP);
    let joint = Vec3::new(0.0, side.sign() * SHOULDER_OUT, SHOULDER_UP);
    Capsule { a: scale * middle, b: scale * joint, radius: 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::rotation_about;
    use crate::human::{Anthropometry, BendFraction, Body, Posture};

    /// Points given in the frame of the feet or of the trunk of a median man standing upright at the origin, looking
    /// along +x, so that both differ by the pivot's height only; then the same points on bodies turned and bent.
    #[test]
    fn regions_of_known_points() {
        let body = Body::new(&Anthropometry::default()).unwrap();
        let trunk_points = [
            (BodyPart::Head, [0.105, 0.0, 0.70], BodyRegion::Face),
            (BodyPart::Head, [0.09, 0.0, 0.77], BodyRegion::SkullForehead),
            (BodyPart::Head, [-0.10, 0.0, 0.70], BodyRegion::SkullForehead),
            (BodyPart::Head, [0.0, 0.0, 0.825], BodyRegion::SkullForehead),
            (BodyPart::Neck, [0.06, 0.0, 0.55], BodyRegion::NeckFront),
            (BodyPart::Neck, [0.001, 0.06, 0.55], BodyRegion::NeckFront),
            (BodyPart::Neck, [-0.06, 0.0, 0.55], BodyRegion::Neck),
            (BodyPart::UpperChest, [0.13, 0.0, 0.40], BodyRegion::Chest),
            (BodyPart::UpperChest, [-0.13, 0.0, 0.40], BodyRegion::BackShoulders),
            (BodyPart::UpperChest, [0.02, 0.208, 0.40], BodyRegion::BackShoulders),
            (BodyPart::UpperChest, [0.02, -0.208, 0.40], BodyRegion::BackShoulders),
            (BodyPart::LowerChest, [0.14, 0.05, 0.25], BodyRegion::Chest),
            (BodyPart::LowerChest, [0.11, 0.05, 0.16], BodyRegion::Abdomen),
            (BodyPart::LowerChest, [-0.11, 0.05, 0.16], BodyRegion::BackShoulders),
            (BodyPart::Abdomen, [0.13, 0.0, 0.12], BodyRegion::Abdomen),
            (BodyPart::Abdomen, [-0.13, 0.0, 0.12], BodyRegion::BackShoulders),
            (BodyPart::Abdomen, [0.09, 0.0, 0.22], BodyRegion::Chest),
        ];
        let poses =
            [(0.0, Posture::Upright), (1.0, Posture::Forward), (-2.0, Posture::ForwardRight), (4.0, Posture::Left)];
        for (heading, posture) in poses {
            let at = Vec3::new(0.7, -0.4, 0.0);
            let placed = body.placed(at, heading, posture, BendFraction::FULL);
            for (part, point, region) in trunk_points {
                let world = placed.world_from_trunk() * Vec3::from(point);
                assert_eq!(placed.region_of(part, world), region, "{part:?} at {point:?}, {posture:?}");
            }
            // Whatever the point, the region is one that the part may have.
            for (part, capsule) in placed.parts() {
                for n in 0..200_u32 {
                    let (out, up) = (libm::sincos(f64::from(n)), f64::from(n % 11) / 5.0 - 1.0);
                    let point = capsule.a + Vec3::new(out.0, out.1, up).normalize() * capsule.radius;
                    assert!(part.regions().contains(&placed.region_of(*part, point)), "{part:?} at {point}");
                }
            }
            let leg_points = [
                (BodyPart::Pelvis, [0.14, 0.0, 0.95], BodyRegion::Pelvis),
                (BodyPart::Pelvis, [-0.14, 0.0, 0.95], BodyRegion::Pelvis),
                (BodyPart::LeftThigh, [0.08, 0.09, 0.6], BodyRegion::Thigh),
                (BodyPart::RightThigh, [0.08, -0.09, 0.5], BodyRegion::Thigh),
                (BodyPart::LeftShank, [-0.055, 0.09, 0.3], BodyRegion::LowerLeg),
                (BodyPart::RightShank, [0.0, -0.09, 0.0], BodyRegion::LowerLeg),
            ];
            for (part, point, region) in leg_points {
                let world = at + rotation_about(Vec3::Z, heading) * Vec3::from(point);
                assert_eq!(placed.region_of(part, world), region, "{part:?} at {point:?}, {posture:?}");
            }
        }
    }

    /// Within 5 cm of its middle, a point of the chest may be on the breastbone, which bears less than the muscle beside it: there no
    /// area is told, so that the smallest pressure of the region counts.
    #[test]
    fn the_muscle_of_the_chest_begins_beside_the_breastbone() {
        let body = Body::new(&Anthropometry::default()).unwrap();
        let placed = body.placed(Vec3::new(0.7, -0.4, 0.0), 1.0, Posture::Forward, BendFraction::FULL);
        let muscle = Some(BodyArea::PectoralMuscle);
        for (part, x, z) in [(BodyPart::UpperChest, 0.13, 0.40), (BodyPart::LowerChest, 0.14, 0.25)] {
            for (y, area) in [(-0.06, muscle), (-0.04, None), (0.0, None), (0.01, None), (0.04, None), (0.06, muscle)] {
                let world = placed.world_from_trunk() * Vec3::new(x, y, z);
                assert_eq!(placed.area_of(part, world), area, "{part:?} {y} m beside the middle");
            }
        }
    }
}
