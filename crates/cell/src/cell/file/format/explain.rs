//! What `explain` may change of a cell, in the cell file.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

/// What `explain` may change of a cell, and how far; what is not named it may change as far as it usually does.
#[derive(Clone, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ExplainTable {
    /// FMU parameters, by variable name.
    #[schemars(with = "BTreeMap<String, ParameterLimits>")]
    pub parameters: BTreeMap<String, Spanned<ParameterLimits>>,
    /// Sensors, by name.
    #[schemars(with = "BTreeMap<String, SensorLimits>")]
    pub sensor: BTreeMap<String, Spanned<SensorLimits>>,
    /// Obstacles, by name.
    #[schemars(with = "BTreeMap<String, ObstacleLimits>")]
    pub obstacle: BTreeMap<String, Spanned<ObstacleLimits>>,
    /// Robots, by name.
    #[schemars(with = "BTreeMap<String, RobotLimits>")]
    pub robot: BTreeMap<String, Spanned<RobotLimits>>,
}

/// How far `explain` may change a parameter of the FMU, in its own unit.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ParameterLimits {
    /// The least value that is tried; the search goes on to there.
    pub least: Option<f64>,
    /// The largest value that is tried; the search goes on to there.
    pub most: Option<f64>,
    /// No smaller value than now.
    pub never_smaller: bool,
    /// No larger value than now.
    pub never_larger: bool,
    /// It stays as it is.
    pub fixed: bool,
}

/// How far `explain` may change a sensor.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct SensorLimits {
    /// Mat and scanner field: how much wider the zone may become on every side, m.
    pub most_wider_m: Option<f64>,
    /// Light curtain and door: how high the upper end may be, m above the floor.
    pub most_top_m: Option<f64>,
    /// Light curtain and door: how much farther from the robot it may be, m.
    pub most_farther_m: Option<f64>,
    /// It stays as it is.
    pub fixed: bool,
}

/// How far `explain` may change a box.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct ObstacleLimits {
    /// How high its top may be, m above the floor.
    pub most_top_m: Option<f64>,
    /// How low its underside may be, m above the floor.
    pub least_underside_m: Option<f64>,
    /// It stays as it is.
    pub fixed: bool,
}

/// How far `explain` may move a robot.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct RobotLimits {
    /// How much farther from the person its base may be, m.
    pub most_farther_m: Option<f64>,
    /// It stays where it is.
    pub fixed: bool,
}
