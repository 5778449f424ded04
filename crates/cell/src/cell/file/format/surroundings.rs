//! What is around the robots in the cell file: obstacles and sensors.

use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde_json::json;
use toml::Spanned;

use crate::human::{ControlKind, ControlledBy};

use super::{Literal, PoseTable, UpAxis};
use crate::cell::sensor::SensorKind;

/// What is in the way: a box, or the parts of a mesh file, taken as boxes that lie inside them.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = box_or_mesh)]
pub struct ObstacleTable {
    /// Name used in messages and pictures; of several boxes of a mesh, `name`, `name/2` and so on.
    #[schemars(with = "String")]
    pub name: Spanned<String>,
    /// Box: centre, m.
    #[serde(default)]
    pub centre_m: Option<[f64; 3]>,
    /// Box: full edge lengths, m.
    #[serde(default)]
    #[schemars(with = "Option<[f64; 3]>")]
    pub size_m: Option<Spanned<[f64; 3]>>,
    /// Box: roll, pitch, yaw, degrees.
    #[serde(default)]
    pub rpy_deg: Option<[f64; 3]>,
    /// Or a mesh file.
    #[serde(default)]
    pub mesh: Option<StaticMeshTable>,
    /// Mesh: longest edge of the cells that a part is filled with where it is no box, m; 0.05 unless told otherwise.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub resolution_m: Option<Spanned<f64>>,
    /// A door's leaf: name of the control, `kind = "toggled"`, that opens it and closes it again. While it is open, nothing is there; it
    /// begins closed.
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub opened_by: Option<Spanned<String>>,
    /// It is there only while an output of the FMU says so, such as a pallet in an entrance.
    #[serde(default)]
    #[schemars(with = "Option<WhileTable>")]
    pub stands_while: Option<Spanned<WhileTable>>,
    /// It moves along a straight line with an output of the FMU.
    #[serde(default)]
    #[schemars(with = "Option<MovesTable>")]
    pub moves_with: Option<Spanned<MovesTable>>,
}

/// While an output of the FMU has a value, or is in a range: read after each communication step, in effect in the next.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct WhileTable {
    /// The output: Boolean, Integer or Real.
    #[schemars(with = "String")]
    pub variable: Spanned<String>,
    /// Its value, in the FMU's own unit; `true` or 1 unless told otherwise.
    #[serde(default)]
    pub is: Option<Literal>,
    /// Or the least value of a range.
    #[serde(default)]
    pub from: Option<f64>,
    /// And the largest one.
    #[serde(default)]
    pub to: Option<f64>,
}

/// How an obstacle moves with an output of the FMU. Where the output says 0, it is where `centre_m` or `mesh` has it.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MovesTable {
    /// The output, a length: how far it is along `direction`.
    #[schemars(with = "String")]
    pub variable: Spanned<String>,
    /// Unit of the FMU's value, when its modelDescription does not say (m, mm, cm).
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub unit: Option<Spanned<String>>,
    /// Along which way, world frame; its length does not matter.
    pub direction: [f64; 3],
    /// Where its way begins, m; before it stays there.
    pub from_m: f64,
    /// Where its way ends, m; beyond it stays there.
    pub to_m: f64,
    /// It is taken to be at the nearest of positions that are no farther apart, m; 0.05 unless told otherwise.
    #[serde(default = "every_m")]
    pub every_m: f64,
}

const fn every_m() -> f64 {
    0.05
}

/// A mesh file of what stands still: STL, OBJ, glTF or GLB.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StaticMeshTable {
    /// The file, relative to this one.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Metres for one of its units; 0.001 for a file in millimetres. May be left out for glTF, which is in metres.
    #[serde(default)]
    pub metres_per_unit: Option<f64>,
    /// Which of its axes points up: z unless told otherwise, y for glTF.
    #[serde(default)]
    pub up: Option<UpAxis>,
    /// Where its origin is.
    #[serde(default)]
    pub at: PoseTable,
}

/// The schema of an obstacle: a box or a mesh.
fn box_or_mesh(obstacle: &mut Schema) {
    obstacle.insert("oneOf".to_owned(), json!([{ "required": ["centre_m", "size_m"] }, { "required": ["mesh"] }]));
}

/// A sensor.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SensorTable {
    /// Name used in results.
    pub name: String,
    /// Kind.
    pub kind: SensorKind,
    /// Where it sees; not for `reported`.
    #[serde(default)]
    #[schemars(with = "Option<DetectionZoneTable>")]
    pub zone: Option<Spanned<DetectionZoneTable>>,
    /// Mats and scanner fields: it counts only while an output of the FMU says so, such as one of several fields that the FMU switches
    /// between. Several sensors may drive one input: it is active when any of those that count sees somebody.
    #[serde(default)]
    #[schemars(with = "Option<WhileTable>")]
    pub counts_while: Option<Spanned<WhileTable>>,
    /// FMU input it drives, or for `reported` the output that tells it: Boolean, or a number with `values`.
    #[schemars(with = "String")]
    pub variable: Spanned<String>,
    /// Light curtains and doors that the FMU evaluates itself, from where `[pose]` says that the person is: the output with which it
    /// says so. Then `variable` is an input with which the FMU is told of the rest: arms, and bodies that bend; `delay_ms` is of that.
    #[serde(default)]
    #[schemars(with = "Option<EvaluatedTable>")]
    pub evaluated: Option<Spanned<EvaluatedTable>>,
    /// Of a Boolean variable, its value while a person is detected; `false` is the usual fail-safe polarity of safety signals. May be
    /// left out where the name says that it is one (`S_...` of PLCopen, `...OSSD...`): then it is `false`.
    #[serde(default)]
    pub active: Option<bool>,
    /// Of a variable that is a number or an enumeration, its values, instead of `active`.
    #[serde(default)]
    #[schemars(with = "Option<ValuesTable>")]
    pub values: Option<Spanned<ValuesTable>>,
    /// Response time before the input changes, ms; rounded up to whole steps.
    #[serde(default)]
    #[schemars(with = "f64")]
    pub delay_ms: Option<Spanned<f64>>,
    /// Mats, scanner fields, light curtains and doors: once the input says that somebody is detected it is held so, and nothing takes
    /// that back. It stands for a stop of the controller that does not restart by itself.
    #[serde(default)]
    #[schemars(with = "bool")]
    pub latched: Option<Spanned<bool>>,
    /// Light curtain and scanner field: resolution or detection capability, mm; for `distance` alone, which does not know the
    /// safety distance without it.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub resolution_mm: Option<Spanned<f64>>,
    /// Light curtain that is a row of single beams: how many; for `distance` alone, instead of a resolution.
    #[serde(default)]
    #[schemars(with = "Option<u32>")]
    pub beams: Option<Spanned<u32>>,
    /// Door: how wide it is open at most when its switch tells, mm; for `distance` alone.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub opening_mm: Option<Spanned<f64>>,
    /// Door: time from when its switch tells until somebody gets through, ms; for `distance` alone, where it counts for the door.
    /// A scan has doors open at once.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub opening_ms: Option<Spanned<f64>>,
    /// Supplement to the safety distance, mm, such as the tolerance of a scanner: Z of ISO 13855; for `distance` alone, none unless
    /// told otherwise.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub supplement_mm: Option<Spanned<f64>>,
}

/// What a sensor's variable is that is a number.
#[derive(Clone, Copy, Debug, PartialEq, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ValuesTable {
    /// Its value while nobody is detected.
    pub clear: f64,
    /// Its value while a person is detected. What an output says that is neither of the two counts as this.
    pub detected: f64,
}

/// What an FMU says of a light curtain or a door that it evaluates itself.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct EvaluatedTable {
    /// FMU output that tells it (Boolean).
    #[schemars(with = "String")]
    pub variable: Spanned<String>,
    /// Its value while a person is detected; that of the sensor, unless told otherwise.
    #[serde(default)]
    pub active: Option<bool>,
}

/// Something that people work: a button, a switch, an acknowledgement. The search works it in any action, if whoever may does
/// reach it.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ControlTable {
    /// Name used in results.
    pub name: String,
    /// FMU input that it drives.
    #[schemars(with = "String")]
    pub variable: Spanned<String>,
    /// Who works it.
    #[serde(default)]
    pub by: ControlledBy,
    /// How it is worked.
    #[serde(default)]
    pub kind: ControlKind,
    /// Where it is, m; needed for one that the person works.
    #[serde(default)]
    #[schemars(with = "Option<[f64; 3]>")]
    pub at_m: Option<Spanned<[f64; 3]>>,
    /// Where it ends, m, if it is a bar or a rope; `at_m` is where it begins.
    #[serde(default)]
    #[schemars(with = "Option<[f64; 3]>")]
    pub to_m: Option<Spanned<[f64; 3]>>,
    /// A hand that comes this near works it, m; 0.03 unless told otherwise.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub within_m: Option<Spanned<f64>>,
    /// Momentary: how long it is pressed, ms, rounded up to whole steps; one action of 200 ms unless told otherwise. Pressed for
    /// the whole of two actions in a row it is not released between them.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub for_ms: Option<Spanned<f64>>,
    /// Value while nobody works it, and at the start; `false` or 0 unless told otherwise.
    #[serde(default)]
    #[schemars(with = "Option<Literal>")]
    pub released: Option<Spanned<Literal>>,
    /// Value while it is pressed, held, or switched over; `true` or 1 unless told otherwise.
    #[serde(default)]
    #[schemars(with = "Option<Literal>")]
    pub pressed: Option<Spanned<Literal>>,
    /// It can be worked only while an output of the FMU says so as an action begins, such as a door that is locked while the robot moves.
    /// A door that is open can be closed at any time.
    #[serde(default)]
    #[schemars(with = "Option<WhileTable>")]
    pub works_while: Option<Spanned<WhileTable>>,
}

/// Where a sensor sees.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct DetectionZoneTable {
    /// Mat, scanner field and post of a two-hand control: corners of a convex or concave polygon in the floor plane, m, in
    /// order.
    #[serde(default)]
    pub polygon_m: Option<Vec<[f64; 2]>>,
    /// Light curtain and door: the two ends of the plane on the floor, m. Two-hand control: the line of the buttons, seen
    /// from above.
    #[serde(default)]
    pub line_m: Option<[[f64; 2]; 2]>,
    /// Scanner field: height above the floor, m; 0.2 unless told otherwise.
    #[serde(default)]
    pub height_m: Option<f64>,
    /// Light curtain and door: from and to above the floor, m.
    #[serde(default)]
    pub heights_m: Option<[f64; 2]>,
}
