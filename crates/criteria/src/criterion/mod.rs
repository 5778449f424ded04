//! What counts as unsafe in a cell: the criteria that its file chooses, any number of them.
//!
//! - transient force and clamping are judged by [`Strike`](super::Strike), pressure by [`pressure`], separation by [`separation`]
//! - `docs/src/howto/criteria.md` says what each means

pub mod pressure;
pub mod separation;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Which speed makes the force that decides whether a contact is unsafe, and how bad.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Criterion {
    /// That of the robot's point, whatever the person does: the paper's.
    #[default]
    Absolute,
    /// That at which the robot's point and the person come towards each other, as long as the robot's moves at all: the
    /// relative speed of ISO/TS 15066 A.3.5.
    Approach,
}

/// The criteria by which contacts are judged.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Criteria {
    /// The potential collision force on somebody who can give way, with this speed; nothing if it does not count.
    pub transient_force: Option<Criterion>,
    /// The force on a part of the body that cannot give way.
    pub clamping: bool,
    /// The pressure of links that say how small they touch.
    pub pressure: bool,
    /// Any contact with a point of the robot that is faster than this, m/s.
    pub moving_contact_m_s: Option<f64>,
}

impl Default for Criteria {
    /// The paper's.
    fn default() -> Self {
        Self { transient_force: Some(Criterion::Absolute), clamping: false, pressure: false, moving_contact_m_s: None }
    }
}

impl Criteria {
    /// The same for another speed of the transient force.
    #[must_use]
    pub const fn with_speed(self, speed: Criterion) -> Self {
        Self { transient_force: Some(speed), ..self }
    }

    /// Which speed makes forces.
    #[must_use]
    pub fn speed(self) -> Criterion {
        self.transient_force.unwrap_or_default()
    }
}

/// Which criterion a hazard breaks.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Class {
    /// The potential collision force exceeds the limit of the body region.
    Force,
    /// The head, or the front of the neck, is touched by a moving robot: not permissible whatever the force
    /// (ISO/TS 15066 A.3.2, 5.5.5).
    HeadContact,
    /// A part of the body that cannot give way bears more than the quasi-static limit.
    Clamping,
    /// The pressure exceeds the limit of the body area.
    Pressure,
    /// A robot that moves is touched, where that is not allowed.
    MovingContact,
    /// A robot that moves is nearer than the protective separation distance.
    Separation,
}

impl Class {
    /// As in files.
    #[must_use]
    pub const fn name(self) -> &'static str {
        match self {
            Self::Force => "force",
            Self::HeadContact => "head_contact",
            Self::Clamping => "clamping",
            Self::Pressure => "pressure",
            Self::MovingContact => "moving_contact",
            Self::Separation => "separation",
        }
    }

    /// The criterion of the cell file, where that is not the transient force.
    #[must_use]
    pub const fn beside_force(self) -> Option<&'static str> {
        match self {
            Self::Force | Self::HeadContact => None,
            Self::Clamping | Self::Pressure | Self::MovingContact | Self::Separation => Some(self.name()),
        }
    }

    /// What happened to a part of the body, and the word that stands before what did it.
    #[must_use]
    pub const fn done(self) -> [&'static str; 2] {
        match self {
            Self::Force | Self::HeadContact => ["hit", "by"],
            Self::Clamping => ["clamped", "by"],
            Self::Pressure => ["pressed", "by"],
            Self::MovingContact => ["touched", "by"],
            Self::Separation => ["too near", "to"],
        }
    }

    /// Whether sequences end with it: after a contact within all limits, or a distance that is too short, they go on. Where clamping
    /// counts it is looked for behind such a hazard too, which counts no sequence twice.
    #[must_use]
    pub const fn ends(self) -> bool {
        !matches!(self, Self::MovingContact | Self::Separation)
    }
}
