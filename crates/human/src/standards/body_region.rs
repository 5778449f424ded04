//! The twelve body regions for which ISO/TS 15066:2016, Annex A, states limits, in the order of its Table A.2; and the front
//! of the neck, for which it states none.
//!
//! Their ids appear in cell files, hazard identities and reports, and so never change.

use std::fmt;
use std::str::FromStr;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

/// A body region of ISO/TS 15066, Table A.2. Its text form (`Display`, `FromStr`, serde) is [`BodyRegion::id`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum BodyRegion {
    /// Skull and forehead.
    SkullForehead,
    /// Face, from the brow down.
    Face,
    /// Rear of the neck, where both areas of the neck in Table A.2 are.
    Neck,
    /// Front of the neck, with the larynx.
    NeckFront,
    /// Rear of the trunk and both shoulders.
    BackShoulders,
    /// Front of the trunk above the xiphoid process.
    Chest,
    /// Front of the trunk below the chest.
    Abdomen,
    /// Pelvis.
    Pelvis,
    /// Upper arms and elbow joints.
    UpperArm,
    /// Lower arms and wrist joints.
    LowerArm,
    /// Hands and fingers.
    Hand,
    /// Thighs and knees.
    Thigh,
    /// Lower legs; feet, which the standard does not list, are counted here.
    LowerLeg,
}

/// A text that names no body region.
#[derive(Clone, Debug, PartialEq, Eq, Error)]
#[error("`{0}` is not a body region: use an id of ISO/TS 15066 such as `chest`, `hand` or `skull_forehead`")]
pub struct UnknownBodyRegion(pub String);

impl BodyRegion {
    /// Every region once, in the order of the standard's table; `ALL[r as usize] == r`.
    pub const ALL: [Self; 13] = [
        Self::SkullForehead,
        Self::Face,
        Self::Neck,
        Self::NeckFront,
        Self::BackShoulders,
        Self::Chest,
        Self::Abdomen,
        Self::Pelvis,
        Self::UpperArm,
        Self::LowerArm,
        Self::Hand,
        Self::Thigh,
        Self::LowerLeg,
    ];

    /// The stable id in snake case.
    #[must_use]
    pub const fn id(self) -> &'static str {
        match self {
            Self::SkullForehead => "skull_forehead",
            Self::Face => "face",
            Self::Neck => "neck",
            Self::NeckFront => "neck_front",
            Self::BackShoulders => "back_shoulders",
            Self::Chest => "chest",
            Self::Abdomen => "abdomen",
            Self::Pelvis => "pelvis",
            Self::UpperArm => "upper_arm",
            Self::LowerArm => "lower_arm",
            Self::Hand => "hand",
            Self::Thigh => "thigh",
            Self::LowerLeg => "lower_leg",
        }
    }

    /// The region in words, for sentences.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::SkullForehead => "skull",
            Self::Face => "face",
            Self::Neck => "neck",
            Self::NeckFront => "front of the neck",
            Self::BackShoulders => "back or shoulders",
            Self::Chest => "chest",
            Self::Abdomen => "abdomen",
            Self::Pelvis => "pelvis",
            Self::UpperArm => "upper arm",
            Self::LowerArm => "lower arm",
            Self::Hand => "hand",
            Self::Thigh => "thigh",
            Self::LowerLeg => "lower leg",
        }
    }

    /// Whether no contact with a moving robot is permitted, and there is no transient limit: the head (ISO/TS 15066, A.3.2),
    /// and the front of the neck, for which Table A.2 has no limit and 5.5.5 asks, as secondary sources have it, that contact
    /// with the larynx be prevented like that with the head.
    #[must_use]
    pub const fn permits_no_contact(self) -> bool {
        matches!(self, Self::SkullForehead | Self::Face | Self::NeckFront)
    }
}

impl fmt::Display for BodyRegion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.pad(self.id())
    }
}

impl FromStr for BodyRegion {
    type Err = UnknownBodyRegion;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        Self::ALL.into_iter().find(|region| region.id() == text).ok_or_else(|| UnknownBodyRegion(text.to_owned()))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// The ids are part of every stored report: this list is written out on purpose.
    #[test]
    fn ids_are_stable_in_every_text_form() {
        let ids = [
            "skull_forehead",
            "face",
            "neck",
            "neck_front",
            "back_shoulders",
            "chest",
            "abdomen",
            "pelvis",
            "upper_arm",
            "lower_arm",
            "hand",
            "thigh",
            "lower_leg",
        ];
        assert_eq!(BodyRegion::ALL.map(BodyRegion::id), ids);
        for (index, (region, id)) in BodyRegion::ALL.into_iter().zip(ids).enumerate() {
            assert_eq!(region as usize, index);
            assert_eq!(region.to_string(), id);
            assert_eq!(id.parse::<BodyRegion>(), Ok(region));
            assert_eq!(serde_json::to_string(&region).unwrap(), format!("\"{id}\""));
            assert_eq!(serde_json::from_str::<BodyRegion>(&format!("\"{id}\"")).unwrap(), region);
        }
    }

    #[test]
    fn an_unknown_region_is_named_in_the_error() {
        let error = "elbow".parse::<BodyRegion>().unwrap_err();
        assert!(error.to_string().contains("`elbow`"), "{error}");
    }
}
