//! What counts as unsafe, in the cell file.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

use crate::hazard::Criterion;

/// What counts as unsafe: any number of criteria at once.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct CriteriaTable {
    /// The potential collision force on somebody who can give way, as in the paper: by which speed, or `false` where it does not
    /// count. `"absolute"` unless told otherwise.
    #[schemars(with = "Option<SpeedOrOff>")]
    pub transient_force: Option<Spanned<SpeedOrOff>>,
    /// The force on a part of the body that is held by something that does not give way: an obstacle, the floor, another link.
    #[schemars(with = "Option<OnOrClamping>")]
    pub clamping: Option<Spanned<OnOrClamping>>,
    /// Pressure of links that say how small they touch (`contact`); results list the others as not known.
    pub pressure: bool,
    /// Any contact with a point of the robot that moves, or that is faster than said.
    #[schemars(with = "Option<OnOrMoving>")]
    pub moving_contact: Option<Spanned<OnOrMoving>>,
    /// Nobody is nearer to a robot that moves than the protective separation distance of ISO/TS 15066, 5.5.4.
    #[schemars(with = "Option<SeparationTable>")]
    pub separation: Option<Spanned<SeparationTable>>,
}

/// A speed that makes forces, or `false`.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum SpeedOrOff {
    /// By this speed.
    By(Criterion),
    /// `false`: it does not count. `true`: by the absolute speed.
    Counts(bool),
}

/// `true`, or how far the robot goes on after a contact.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum OnOrClamping {
    /// Whether it counts.
    Counts(bool),
    /// It counts, with these figures.
    With(ClampingTable),
}

/// How far robots go on after a contact: gaps count that would be closed so far.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ClampingTable {
    /// FMU input that tells of a contact, named in `inputs` with its value while nobody is touched: how far robots go on is then
    /// found by running the FMU.
    pub contact_signal: Option<String>,
    /// Or how far, m.
    pub travel_after_contact_m: Option<f64>,
}

/// `true`, or from which speed on.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum OnOrMoving {
    /// Whether it counts.
    Counts(bool),
    /// It counts, from this speed on.
    With(MovingTable),
}

/// Which contacts with a robot that moves count.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovingTable {
    /// Points that are faster than this, m/s.
    pub faster_than_m_s: f64,
}

/// Protective separation distance `S_p = v_h T + S + C + Z_d + Z_r`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SeparationTable {
    /// What stops the robots: the sensor that does, or an FMU input named in `inputs`. How long they go on, and how far, is found by
    /// running the FMU; or it is stated by the next three.
    #[serde(default)]
    pub stop: Option<String>,
    /// From the command until a robot begins to brake, s.
    #[serde(default)]
    pub reaction_s: Option<f64>,
    /// From then until it stands, s.
    #[serde(default)]
    pub stop_time_s: Option<f64>,
    /// How far any point of it gets while it brakes, m.
    #[serde(default)]
    pub stop_distance_m: Option<f64>,
    /// How far a part of the body gets in before the person is seen, beyond trunk and legs, m.
    pub intrusion_m: f64,
    /// Uncertainty of where the person is, m.
    #[serde(default)]
    pub person_uncertainty_m: f64,
    /// Uncertainty of where the robot is, m.
    #[serde(default)]
    pub robot_uncertainty_m: f64,
    /// Speed at which people approach, m/s: that of walking unless told otherwise.
    #[serde(default)]
    pub approach_m_s: Option<f64>,
}

/// What a link is like where it touches.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ContactTable {
    /// An edge or corner that is rounded with this radius, m; or `area_cm2`.
    #[serde(default)]
    pub radius_m: Option<f64>,
    /// A flat surface of so many cm2.
    #[serde(default)]
    pub area_cm2: Option<f64>,
    /// Stiffness of the padding in front of it, N/mm, if it has one.
    #[serde(default)]
    pub padding_n_mm: Option<f64>,
}
