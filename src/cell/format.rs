//! The cell file as it is written: TOML tables, one struct each. Units stand in the key names (`_m`, `_deg`, `_kg`).
//!
//! Nothing is interpreted here; [`super::validate`] turns this into a [`super::Workcell`].

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::Deserialize;
use toml::Spanned;

/// The whole file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CellFile {
    /// Version of this format; 1.
    #[schemars(with = "u32")]
    pub schema: Spanned<u32>,
    /// Name of the cell, used in results.
    pub name: String,
    /// The FMU, relative to this file. Left out when the file travels inside the FMU.
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub fmu: Option<Spanned<String>>,
    /// Time steps.
    #[serde(default)]
    pub time: TimeTable,
    /// The robot: kinematic chain, link shapes, moving mass, and where its motion comes from.
    #[schemars(with = "RobotTable")]
    pub robot: Spanned<RobotTable>,
    /// Static boxes: fences, tables, machines.
    #[serde(default, rename = "obstacle")]
    pub obstacles: Vec<ObstacleTable>,
    /// Sensors evaluated on the human's body and written to FMU inputs.
    #[serde(default, rename = "sensor")]
    pub sensors: Vec<SensorTable>,
    /// FMU parameters set before initialisation, by variable name.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Literal>")]
    pub parameters: BTreeMap<String, Spanned<Literal>>,
    /// FMU inputs held constant, by variable name.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Literal>")]
    pub inputs: BTreeMap<String, Spanned<Literal>>,
    /// The person.
    pub human: HumanTable,
    /// Search budget.
    #[serde(default)]
    pub search: SearchTable,
}

/// A number or a truth value for an FMU variable.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(untagged)]
pub enum Literal {
    /// `true` or `false`, for Boolean variables.
    Bool(bool),
    /// A number, in the FMU variable's own unit.
    Number(f64),
}

/// Time steps.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct TimeTable {
    /// FMI communication step and contact-check interval, s; must divide 0.2 s and not exceed 0.02 s.
    #[schemars(with = "f64")]
    pub step_s: Spanned<f64>,
}

impl Default for TimeTable {
    fn default() -> Self {
        Self { step_s: Spanned::new(0..0, 0.02) }
    }
}

/// A position and orientation: translation in metres, then roll, pitch, yaw in degrees about the fixed x, y, z axes.
#[derive(Clone, Copy, Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct PoseTable {
    /// Translation, m.
    pub xyz_m: [f64; 3],
    /// Roll, pitch, yaw about the fixed axes, degrees (as in URDF).
    pub rpy_deg: [f64; 3],
}

/// A robot arm.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobotTable {
    /// Name used in results.
    pub name: String,
    /// `world_from_base`.
    #[serde(default)]
    pub base: PoseTable,
    /// Total mass of the moving parts `M`, kg (ISO/TS 15066 (A.4) uses half of it).
    #[schemars(with = "f64")]
    pub moving_mass_kg: Spanned<f64>,
    /// Effective payload `m_L` with tool and workpiece, kg; or `payload`.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub payload_kg: Option<Spanned<f64>>,
    /// The FMU output that gives the payload; or `payload_kg`.
    #[serde(default)]
    pub payload: Option<VariableTable>,
    /// Revolute joints from the base to the tool.
    #[serde(rename = "joint")]
    pub joints: Vec<JointTable>,
    /// Collision shapes, each rigidly attached to a joint's moving side.
    #[serde(default, rename = "link")]
    pub links: Vec<LinkTable>,
    /// Optional FMU output that tells the phase of the robot programme (Integer or Boolean); part of a hazard's identity.
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub phase: Option<Spanned<String>>,
}

/// A revolute joint.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointTable {
    /// Name used by links.
    #[schemars(with = "String")]
    pub name: Spanned<String>,
    /// `parent_from_joint` at angle zero.
    #[serde(default)]
    pub origin: PoseTable,
    /// Rotation axis in the joint frame; normalised on reading.
    #[schemars(with = "[f64; 3]")]
    pub axis: Spanned<[f64; 3]>,
    /// FMU output with the joint angle.
    pub angle: VariableTable,
    /// FMU output with the joint speed.
    pub speed: VariableTable,
}

/// An FMU output and what it takes to read it as SI: `value = sign * unit(variable) + offset + sum(plus)`.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct VariableTable {
    /// Name in modelDescription.xml.
    #[schemars(with = "String")]
    pub variable: Spanned<String>,
    /// Unit of the FMU's value, when its modelDescription does not say (rad, deg, rad/s, deg/s, kg, g).
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub unit: Option<Spanned<String>>,
    /// +1 or -1.
    #[serde(default = "one")]
    pub sign: f64,
    /// Added to the angle, degrees.
    #[serde(default)]
    pub offset_deg: f64,
    /// Coupled axes: further variables (same unit) times a factor, for instance J3 that also follows J2.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, f64>")]
    pub plus: BTreeMap<String, Spanned<f64>>,
}

const fn one() -> f64 {
    1.0
}

/// A collision shape of the robot; several entries may share a name.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct LinkTable {
    /// Name used in results.
    pub name: String,
    /// The joint whose moving side carries the shape.
    #[schemars(with = "String")]
    pub joint: Spanned<String>,
    /// A capsule in the joint frame.
    #[serde(default)]
    pub capsule: Option<CapsuleTable>,
    /// Corner points of a convex hull in the joint frame, m.
    #[serde(default)]
    #[schemars(with = "Option<Vec<[f64; 3]>>")]
    pub hull_m: Option<Spanned<Vec<[f64; 3]>>>,
}

/// A capsule.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct CapsuleTable {
    /// One end of the core, m.
    pub from_m: [f64; 3],
    /// The other end, m (equal to `from_m` for a sphere).
    pub to_m: [f64; 3],
    /// Radius, m.
    pub radius_m: f64,
}

/// A static box.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ObstacleTable {
    /// Name used in messages and pictures.
    pub name: String,
    /// Centre, m.
    pub centre_m: [f64; 3],
    /// Full edge lengths, m.
    #[schemars(with = "[f64; 3]")]
    pub size_m: Spanned<[f64; 3]>,
    /// Roll, pitch, yaw, degrees.
    #[serde(default)]
    pub rpy_deg: [f64; 3],
}

/// What a sensor is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SensorKind {
    /// A pressure-sensitive mat: fires when a foot stands on the zone.
    Mat,
    /// A scanner field: fires when a part of the body is in the zone at the field's height.
    ScannerField,
}

/// A sensor.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SensorTable {
    /// Name used in results.
    pub name: String,
    /// Kind.
    pub kind: SensorKind,
    /// Where it sees.
    pub zone: ZoneTable,
    /// FMU input it drives (Boolean).
    #[schemars(with = "String")]
    pub variable: Spanned<String>,
    /// Value of the input while a person is detected; `false` is the usual fail-safe polarity of safety signals.
    pub active: bool,
    /// Response time before the input changes, ms; rounded up to whole steps.
    #[serde(default)]
    #[schemars(with = "f64")]
    pub delay_ms: Option<Spanned<f64>>,
}

/// A zone on the floor plan.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZoneTable {
    /// Corners of a convex or concave polygon in the floor plane, m, in order.
    #[schemars(with = "Vec<[f64; 2]>")]
    pub polygon_m: Spanned<Vec<[f64; 2]>>,
    /// Height of a scanner field above the floor, m.
    #[serde(default)]
    pub height_m: Option<f64>,
}

/// Sex of the ANSUR II figures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sex {
    /// Women.
    Woman,
    /// Men.
    #[default]
    Man,
}

/// The person.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HumanTable {
    /// Where the person stands at the start and looks.
    #[schemars(with = "StartTable")]
    pub start: Spanned<StartTable>,
    /// Sex of the body measures.
    #[serde(default)]
    pub sex: Sex,
    /// Percentile of the body measures: 5, 50 or 95.
    #[serde(default = "p50")]
    #[schemars(with = "u8")]
    pub percentile: Spanned<u8>,
    /// Angle of a forward bend, degrees.
    #[serde(default = "forty_five")]
    pub bend_forward_deg: f64,
    /// Angle of a sideways bend, degrees.
    #[serde(default = "thirty")]
    pub bend_lateral_deg: f64,
}

fn p50() -> Spanned<u8> {
    Spanned::new(0..0, 50)
}
const fn forty_five() -> f64 {
    45.0
}
const fn thirty() -> f64 {
    30.0
}

/// A start pose.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartTable {
    /// Floor position, m.
    pub xy_m: [f64; 2],
    /// Heading, degrees from +x towards +y.
    pub heading_deg: f64,
}

/// Search budget.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct SearchTable {
    /// Iterations (episodes).
    pub iterations: u32,
    /// Actions in an episode, 200 ms each.
    pub actions: u32,
    /// Seed of the random generator.
    pub seed: u64,
    /// No contact deeper than this is missed by the arm check, m.
    pub reach_tolerance_m: f64,
}

impl Default for SearchTable {
    fn default() -> Self {
        Self { iterations: 320, actions: 8, seed: 1, reach_tolerance_m: 0.02 }
    }
}
