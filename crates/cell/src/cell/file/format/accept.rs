//! What the cell file accepts of an FMU that can only be tried out.

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

/// What can be accepted: a closed list. A scan prints the lines for what it needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Acceptable {
    /// `robot` does the same whatever `sensor` reports.
    RobotIgnoresSensor,
    /// The robots do the same with all people of whom the sensors report the same.
    PeopleAlike,
    /// `sensor`, which is inside the FMU, sees the same people at any time.
    SensorSeesAlike,
    /// Controls are not worked more often than `at_most`, all together, in the time that a scan from anywhere looks at.
    Presses,
    /// What the FMU remembers shows within `within_s`, and as soon as it did in trials, while what the sensors report stays the same: a scan
    /// from anywhere then follows people who come and go as often as they like.
    MemoryShows,
    /// Robots that are and move nearly alike, now and as long as trials showed, `within_s` at most, while what the sensors report stays the
    /// same, go on nearly alike: the same for FMUs that hardly ever come back to just the same.
    NearlyAlike,
    /// The FMU answers these `readings` of its sensors alike at any time, as it did in trials: a scan from anywhere then tells fewer of them
    /// apart.
    ReadingsAlike,
    /// Robots go on after a contact as far as they did when that was tried out.
    TravelAfterContact,
}

/// Something that can only be tried out, and that somebody accepts.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct AcceptTable {
    /// What is accepted.
    pub what: Acceptable,
    /// The robot that it is about.
    #[serde(default)]
    pub robot: Option<String>,
    /// The sensor that it is about.
    #[serde(default)]
    pub sensor: Option<String>,
    /// How often, of `presses`.
    #[serde(default)]
    pub at_most: Option<u32>,
    /// How soon, s, of `memory_shows` and `nearly_alike`.
    #[serde(default)]
    pub within_s: Option<f64>,
    /// Which reports of sensors are answered like which, of `readings_alike`: `door like mat`.
    #[serde(default)]
    pub readings: Option<Vec<String>>,
    /// The FMU that it was tried out with: its SHA-256, as the scan prints it.
    #[schemars(with = "String")]
    pub fmu: Spanned<String>,
    /// Who accepts it.
    pub by: String,
    /// Why it holds.
    pub because: String,
}
