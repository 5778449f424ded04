//! What of a person is hit: the body, or an arm that reaches.

use crate::standards::BodyRegion;

/// What of the person is hit: an arm needs other guards than the rest.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "snake_case")]
pub enum BodyOrArm {
    /// Head, trunk and legs, which are where the person stands.
    Body,
    /// A hand, a lower arm or an upper arm, which reaches.
    Arm,
}

impl BodyOrArm {
    /// In words.
    #[must_use]
    pub const fn words(self) -> &'static str {
        match self {
            Self::Body => "body",
            Self::Arm => "arm",
        }
    }

    /// That of a region.
    #[must_use]
    pub const fn of(region: BodyRegion) -> Self {
        match region {
            BodyRegion::UpperArm | BodyRegion::LowerArm | BodyRegion::Hand => Self::Arm,
            _ => Self::Body,
        }
    }
}
