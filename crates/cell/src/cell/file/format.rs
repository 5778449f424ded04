//! The cell file as it is written: TOML tables, one struct each. Units stand in the key names (`_m`, `_deg`, `_kg`).
//!
//! The file as a whole, FMUs and times are here; `accept`, `robot`, `surroundings`, `person`, `criteria` and `explain` have the rest. Nothing
//! is interpreted here; [`super::validate`] turns this into a [`crate::cell::Workcell`].

mod accept;
mod criteria;
mod explain;
mod person;
mod robot;
mod surroundings;

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde_json::{Value, json};
use toml::Spanned;

pub(crate) use accept::{AcceptTable, Acceptable};
pub use criteria::{ContactTable, CriteriaTable, OnOrClamping, OnOrMoving, SeparationTable, SpeedOrOff};
pub(crate) use explain::{ExplainTable, ParameterLimits, SensorLimits};
pub use person::{HumanTable, People, PeopleFrom, SecondTable, StartAreaTable, StartTable};
pub(crate) use robot::{
    CapsuleTable, FrameTable, InertiaTable, JointTable, LinkTable, MeshTable, RobotTable, UpAxis, VariableTable,
};
pub use surroundings::{
    ControlTable, DetectionZoneTable, EvaluatedTable, MovesTable, ObstacleTable, SensorTable, StaticMeshTable,
    ValuesTable, WhileTable,
};

/// The whole file.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = whole_or_variant)]
pub struct CellFile {
    /// Version of this format; 1.
    #[schemars(with = "u32")]
    pub schema: Spanned<u32>,
    /// Name of the cell, used in results. A file that extends another has one of its own.
    pub name: String,
    /// Another cell file, relative to this one: what this file does not say is as it is there. Tables are laid over each
    /// other key by key, entries of lists by their names; other values take the place of those there.
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub extends: Option<Spanned<String>>,
    /// What of the extended file is left out: names of entries by list, keys by table.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Vec<String>>")]
    pub remove: BTreeMap<String, Spanned<Vec<String>>>,
    /// The FMU, relative to this file. Left out when the file travels inside the FMU, or when there are `unit`s.
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub fmu: Option<Spanned<String>>,
    /// Several FMUs that are coupled; variables are then written `unit:variable`.
    #[serde(default, rename = "unit")]
    #[schemars(with = "Vec<UnitTable>")]
    pub units: Vec<Spanned<UnitTable>>,
    /// Outputs of units that drive inputs of units.
    #[serde(default, rename = "connection")]
    pub connections: Vec<ConnectionTable>,
    /// Time steps.
    #[serde(default)]
    pub time: TimeTable,
    /// The robots: kinematic chain or link frames, link shapes, moving mass, and where the motion comes from.
    #[serde(rename = "robot")]
    #[schemars(with = "Vec<RobotTable>")]
    pub robots: Vec<Spanned<RobotTable>>,
    /// What stands still: fences, tables, machines.
    #[serde(default, rename = "obstacle")]
    pub obstacles: Vec<ObstacleTable>,
    /// Sensors evaluated on the human's body and written to FMU inputs.
    #[serde(default, rename = "sensor")]
    pub sensors: Vec<SensorTable>,
    /// What people work: buttons, switches, acknowledgements.
    #[serde(default, rename = "control")]
    pub controls: Vec<ControlTable>,
    /// FMU parameters set before initialisation, by variable name.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Literal>")]
    pub parameters: BTreeMap<String, Spanned<Literal>>,
    /// FMU inputs held constant, by variable name.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Literal>")]
    pub inputs: BTreeMap<String, Spanned<Literal>>,
    /// What of the person's pose is written to FMU inputs (Real) at every step.
    #[serde(default)]
    #[schemars(with = "BTreeMap<PoseQuantity, String>")]
    pub pose: BTreeMap<PoseQuantity, Spanned<String>>,
    /// The person, or two.
    pub human: People,
    /// What counts as unsafe; without it, the transient force of the paper.
    #[serde(default)]
    pub criteria: CriteriaTable,
    /// Search budget.
    #[serde(default)]
    pub search: SearchTable,
    /// What makes a scan fail.
    #[serde(default)]
    pub fail_on: FailOnTable,
    /// What `explain` may change, and how far.
    #[serde(default)]
    pub explain: ExplainTable,
    /// What can only be tried out of the FMU, and is accepted.
    #[serde(default, rename = "accept")]
    #[schemars(with = "Vec<AcceptTable>")]
    pub accepts: Vec<Spanned<AcceptTable>>,
}

/// The schema of the file: what a whole cell needs, a file that extends another may leave to that one.
fn whole_or_variant(file: &mut Schema) {
    let Some(Value::Array(required)) = file.get_mut("required") else { return };
    let (own, left): (Vec<Value>, Vec<Value>) = required.drain(..).partition(|key| key == "name");
    *required = own;
    file.insert("if".to_owned(), json!({ "not": { "required": ["extends"] } }));
    file.insert("then".to_owned(), json!({ "required": left }));
}

/// One of several coupled FMUs.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct UnitTable {
    /// Name used in front of its variables.
    pub name: String,
    /// The FMU, relative to this file.
    #[schemars(with = "String")]
    pub fmu: Spanned<String>,
}

/// An output that drives an input.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ConnectionTable {
    /// The output, `unit:variable`.
    #[schemars(with = "String")]
    pub from: Spanned<String>,
    /// The input, `unit:variable`.
    #[schemars(with = "String")]
    pub to: Spanned<String>,
    /// Whole communication steps by which the value is held back. 0: what the source gives at the end of a step counts
    /// for that same step, so a change within it acts up to one step early; 1: it counts from the next step on.
    #[serde(default)]
    pub delay_steps: u8,
}

/// A part of the person's pose that an FMU may be told: m in the world frame, or rad.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PoseQuantity {
    /// Middle between the feet, x.
    X,
    /// Middle between the feet, y.
    Y,
    /// Heading from +x towards +y, rad, in 0 to 2 pi.
    Heading,
    /// Left foot, x.
    LeftFootX,
    /// Left foot, y.
    LeftFootY,
    /// Right foot, x.
    RightFootX,
    /// Right foot, y.
    RightFootY,
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

/// What makes a scan fail, for pipelines.
#[derive(Debug, Default, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct FailOnTable {
    /// Only hazards that are not in the baseline, and those that became worse than there.
    pub new_only: bool,
    /// The baseline: the scan.json of an earlier scan, relative to this file; `baseline.json` unless told otherwise.
    #[schemars(with = "Option<String>")]
    pub baseline: Option<Spanned<String>>,
}
