//! People of a cell, as results tell of them: their bodies, and a second person.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::human::{Ability, Anthropometry, Body, Radii};
use crate::standards::anthropometry::{Percentile, Sex};

/// Whose body it is and how far it bends.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BodyRecord {
    /// Sex of the body measures.
    pub sex: Sex,
    /// Percentile of the body measures: 5, 50 or 95.
    pub percentile: u8,
    /// How far they bend forward, degrees.
    pub bend_forward_deg: f64,
    /// How far they bend to the side, degrees.
    pub bend_lateral_deg: f64,
    /// Radii of body parts that the cell file says, m.
    #[serde(default, skip_serializing_if = "is_median")]
    pub radii_m: Radii,
}

fn is_median(radii: &Radii) -> bool {
    *radii == Radii::default()
}

impl From<&Body> for BodyRecord {
    fn from(body: &Body) -> Self {
        let Anthropometry { sex, percentile, bend_forward_deg, bend_lateral_deg, radii_m } = *body.measures();
        Self { sex, percentile: percentile.into(), bend_forward_deg, bend_lateral_deg, radii_m }
    }
}

impl BodyRecord {
    /// The body itself; none if there is no such body.
    #[must_use]
    pub fn body(&self) -> Option<Body> {
        let Self { sex, percentile, bend_forward_deg, bend_lateral_deg, radii_m } = *self;
        let percentile = Percentile::try_from(percentile).ok()?;
        Body::new(&Anthropometry { sex, percentile, bend_forward_deg, bend_lateral_deg, radii_m }).ok()
    }
}

/// A second person.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SecondRecord {
    /// What the first and the second person are called.
    pub names: [String; 2],
    /// Where the second one begins, floor plan, m.
    pub xy_m: [f64; 2],
    /// Where they look then, degrees from +x towards +y.
    pub heading_deg: f64,
    /// What they do besides walking, bending and reaching.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<Ability>,
    /// How fast they run, m/s, if they do.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub run_m_s: Option<f64>,
    /// How far what they hold reaches beyond the finger tips, m, if they hold something.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_m: Option<f64>,
    /// Their body; older versions did not write it down.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<BodyRecord>,
}

impl SecondRecord {
    /// Whether they are and do the same, from the same place, whatever they are called.
    #[must_use]
    pub(crate) fn does_the_same_as(&self, other: &Self) -> bool {
        let Self { names: _, xy_m, heading_deg, also, run_m_s, held_m, body } = self;
        let figures = |xy_m: [f64; 2], heading_deg: f64| [xy_m[0], xy_m[1], heading_deg].map(f64::to_bits);
        figures(*xy_m, *heading_deg) == figures(other.xy_m, other.heading_deg)
            && (also, run_m_s, held_m, body) == (&other.also, &other.run_m_s, &other.held_m, &other.body)
    }
}
