//! Parts of the body by name.

use serde::{Deserialize, Serialize};

use crate::standards::BodyRegion;

/// Which side of the body.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum Side {
    /// The human's own left.
    Left,
    /// The human's own right.
    Right,
}

impl Side {
    /// Both sides, left first.
    pub const BOTH: [Self; 2] = [Self::Left, Self::Right];

    /// +1 to the left, -1 to the right: the sign along the body's y axis.
    #[must_use]
    pub(crate) const fn sign(self) -> f64 {
        match self {
            Self::Left => 1.0,
            Self::Right => -1.0,
        }
    }
}

/// A part of the body that has a capsule of its own.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum BodyPart {
    /// Head, a sphere.
    Head,
    /// Neck.
    Neck,
    /// Chest at the height of the armpits, with both shoulder caps.
    UpperChest,
    /// Chest at the height of the lower ribs.
    LowerChest,
    /// Abdomen.
    Abdomen,
    /// Pelvis.
    Pelvis,
    /// Left thigh and knee.
    LeftThigh,
    /// Right thigh and knee.
    RightThigh,
    /// Left lower leg and foot.
    LeftShank,
    /// Right lower leg and foot.
    RightShank,
}

impl BodyPart {
    /// Every part once, from the head down; the order of [`PlacedBody::parts`](super::PlacedBody::parts).
    pub const ALL: [Self; 10] = [
        Self::Head,
        Self::Neck,
        Self::UpperChest,
        Self::LowerChest,
        Self::Abdomen,
        Self::Pelvis,
        Self::LeftThigh,
        Self::RightThigh,
        Self::LeftShank,
        Self::RightShank,
    ];

    /// Its name, as in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Head => "head",
            Self::Neck => "neck",
            Self::UpperChest => "upper_chest",
            Self::LowerChest => "lower_chest",
            Self::Abdomen => "abdomen",
            Self::Pelvis => "pelvis",
            Self::LeftThigh => "left_thigh",
            Self::RightThigh => "right_thigh",
            Self::LeftShank => "left_shank",
            Self::RightShank => "right_shank",
        }
    }

    /// The regions that a point on its surface may belong to.
    #[must_use]
    pub const fn regions(self) -> &'static [BodyRegion] {
        match self {
            Self::Head => &[BodyRegion::Face, BodyRegion::SkullForehead],
            Self::Neck => &[BodyRegion::NeckFront, BodyRegion::Neck],
            Self::UpperChest | Self::LowerChest | Self::Abdomen => {
                &[BodyRegion::BackShoulders, BodyRegion::Chest, BodyRegion::Abdomen]
            }
            Self::Pelvis => &[BodyRegion::Pelvis],
            Self::LeftThigh | Self::RightThigh => &[BodyRegion::Thigh],
            Self::LeftShank | Self::RightShank => &[BodyRegion::LowerLeg],
        }
    }

    /// Whether the part moves with the trunk when it bends.
    #[must_use]
    pub const fn is_trunk(self) -> bool {
        matches!(self, Self::Head | Self::Neck | Self::UpperChest | Self::LowerChest | Self::Abdomen)
    }
}
