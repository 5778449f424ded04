//! The cell file as it is written: TOML tables, one struct each. Units stand in the key names (`_m`, `_deg`, `_kg`).
//!
//! Nothing is interpreted here; [`super::validate`] turns this into a [`crate::cell::Workcell`].

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde_json::{Value, json};
use toml::Spanned;

use crate::human::Radii;

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
    /// The person.
    pub human: HumanTable,
    /// Search budget.
    #[serde(default)]
    pub search: SearchTable,
    /// What makes a scan fail.
    #[serde(default)]
    pub fail_on: FailOnTable,
    /// What `explain` may change, and how far.
    #[serde(default)]
    pub explain: ExplainTable,
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

/// A robot arm.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct RobotTable {
    /// Name used in results.
    pub name: String,
    /// What of the same robot in the extended file is left out: names of joints, frames and links.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, Vec<String>>")]
    pub remove: BTreeMap<String, Spanned<Vec<String>>>,
    /// `world_from_base`.
    #[serde(default)]
    pub base: PoseTable,
    /// Robot description (URDF), relative to this file: kinematics, collision shapes and masses. Its joints are then named
    /// in `joint`, each with what moves it.
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub urdf: Option<Spanned<String>>,
    /// Whether the collision shapes of the URDF are used; `false` takes kinematics and masses only, for instance because
    /// its meshes are not there.
    #[serde(default = "yes")]
    pub urdf_shapes: bool,
    /// Where the packages are that the URDF names (`package://NAME/...`), by name; folders relative to this file. Those
    /// that are found without, above the URDF or beside it, need not be named.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, String>")]
    pub packages: BTreeMap<String, Spanned<String>>,
    /// Links of the URDF whose shapes are left out.
    #[serde(default)]
    #[schemars(with = "Vec<String>")]
    pub ignore_links: Vec<Spanned<String>>,
    /// Total mass of the moving parts `M`, kg (ISO/TS 15066 (A.4) uses half of it). A URDF with inertials gives it too.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub moving_mass_kg: Option<Spanned<f64>>,
    /// Effective payload `m_L` with tool and workpiece, kg; or `payload`.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub payload_kg: Option<Spanned<f64>>,
    /// The FMU output that gives the payload; or `payload_kg`.
    #[serde(default)]
    pub payload: Option<VariableTable>,
    /// Joints from the base to the tool, each on the one before, or those of the URDF; or `frame`s.
    #[serde(default, rename = "joint")]
    pub joints: Vec<JointTable>,
    /// Moving parts whose poses the FMU gives; or `joint`s.
    #[serde(default, rename = "frame")]
    pub frames: Vec<FrameTable>,
    /// Collision shapes, each rigidly attached to a joint's moving side.
    #[serde(default, rename = "link")]
    pub links: Vec<LinkTable>,
    /// Optional FMU output that tells the phase of the robot programme (Integer or Boolean); part of a hazard's identity.
    #[serde(default)]
    #[schemars(with = "Option<String>")]
    pub phase: Option<Spanned<String>>,
}

/// A joint: it turns by an `angle`, or slides by a `position`, or is held where it is.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct JointTable {
    /// Name used by links; with a URDF, the joint's name there.
    #[schemars(with = "String")]
    pub name: Spanned<String>,
    /// `parent_from_joint` at angle zero. With a URDF it is said there.
    #[serde(default)]
    #[schemars(with = "Option<PoseTable>")]
    pub origin: Option<Spanned<PoseTable>>,
    /// Axis in the joint frame; normalised on reading. With a URDF it is said there.
    #[serde(default)]
    #[schemars(with = "Option<[f64; 3]>")]
    pub axis: Option<Spanned<[f64; 3]>>,
    /// FMU output with the angle of a joint that turns.
    #[serde(default)]
    pub angle: Option<VariableTable>,
    /// FMU output with the position of a joint that slides.
    #[serde(default)]
    pub position: Option<VariableTable>,
    /// FMU output with the joint speed; differentiated, and the results say so, if it is left out.
    #[serde(default)]
    pub speed: Option<VariableTable>,
    /// Instead: the angle of a joint that does not move, degrees.
    #[serde(default)]
    pub held_deg: Option<f64>,
    /// Instead: the position of a slide that does not move, m.
    #[serde(default)]
    pub held_m: Option<f64>,
}

/// A moving part of the robot whose pose and velocity the FMU gives, in the robot's base frame. What it does not give of
/// the velocities is differentiated, and the results say so. Of a part without orientation only spheres around its origin
/// are known: the centre of a tool, say.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct FrameTable {
    /// Name used by links.
    #[schemars(with = "String")]
    pub name: Spanned<String>,
    /// FMU outputs x, y, z of its origin.
    #[schemars(with = "[String; 3]")]
    pub position: [Spanned<String>; 3],
    /// FMU outputs w, x, y, z of the unit quaternion `base_from_frame`.
    #[serde(default)]
    #[schemars(with = "Option<[String; 4]>")]
    pub quaternion: Option<[Spanned<String>; 4]>,
    /// Or FMU outputs of the rotation matrix `base_from_frame`, row by row. (Modelica's `R.T` is its transpose.)
    #[serde(default)]
    #[schemars(with = "Option<[[String; 3]; 3]>")]
    pub rotation_matrix: Option<[[Spanned<String>; 3]; 3]>,
    /// FMU outputs x, y, z of the velocity of its origin.
    #[serde(default)]
    #[schemars(with = "Option<[String; 3]>")]
    pub velocity: Option<[Spanned<String>; 3]>,
    /// FMU outputs x, y, z of its angular velocity.
    #[serde(default)]
    #[schemars(with = "Option<[String; 3]>")]
    pub angular_velocity: Option<[Spanned<String>; 3]>,
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

const fn yes() -> bool {
    true
}

const fn one() -> f64 {
    1.0
}

/// A collision shape of the robot, beside those of a URDF; several entries may share a name.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
#[schemars(transform = joint_or_frame)]
pub struct LinkTable {
    /// Name used in results.
    pub name: String,
    /// The joint whose moving side carries the shape, or the frame; with a URDF also one of its links.
    #[serde(alias = "frame")]
    #[schemars(with = "String")]
    pub joint: Spanned<String>,
    /// A capsule in the joint frame.
    #[serde(default)]
    pub capsule: Option<CapsuleTable>,
    /// Corner points of a convex hull in the joint frame, m.
    #[serde(default)]
    #[schemars(with = "Option<Vec<[f64; 3]>>")]
    pub hull_m: Option<Spanned<Vec<[f64; 3]>>>,
    /// A mesh file in the joint frame; its convex hull, unless told otherwise.
    #[serde(default)]
    pub mesh: Option<MeshTable>,
}

/// A mesh file: STL or OBJ.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct MeshTable {
    /// The file, relative to this one.
    #[schemars(with = "String")]
    pub file: Spanned<String>,
    /// Metres for one of its units; 0.001 for a file in millimetres.
    pub metres_per_unit: f64,
    /// Which of its axes points up.
    #[serde(default)]
    pub up: UpAxis,
    /// Where its origin is.
    #[serde(default)]
    pub at: PoseTable,
    /// Whether the mesh is taken as it is, with its hollows, instead of its convex hull. It has to be closed then, and arm
    /// searches take longer.
    #[serde(default)]
    pub exact: bool,
}

/// Which axis of a mesh points up.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum UpAxis {
    /// y: its (x, y, z) is (x, -z, y) here.
    Y,
    /// z, as everywhere here.
    #[default]
    Z,
}

/// The schema of a link: `frame` is another name of `joint`, and one of them is there.
fn joint_or_frame(link: &mut Schema) {
    let Some(joint) = link.pointer("/properties/joint").cloned() else { return };
    if let Some(Value::Object(properties)) = link.pointer_mut("/properties") {
        properties.insert("frame".to_owned(), joint);
    }
    if let Some(Value::Array(required)) = link.get_mut("required") {
        required.retain(|name| name != "joint");
    }
    link.insert("oneOf".to_owned(), json!([{ "required": ["joint"] }, { "required": ["frame"] }]));
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

/// What stands still: a box, or the parts of a mesh file, taken as boxes that lie inside them.
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

/// What a sensor is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum SensorKind {
    /// A pressure-sensitive mat: fires when a foot stands on the zone (ISO 13856-1).
    Mat,
    /// A scanner field: fires when a leg is in the zone (IEC 61496-3).
    ScannerField,
    /// A light curtain: fires when a part of the body or an arm passes through an upright plane (IEC 61496-2). An arm
    /// that reaches through it does so at 2.0 m/s (ISO 13855).
    LightCurtain,
    /// The switch of a guard door (ISO 14119): fires while a part of the body or an arm is in the doorway, an upright plane.
    /// Whoever has passed has closed the door behind them: no door tells of less.
    InterlockedDoor,
    /// A two-hand control (ISO 13851): fires unless the person stands at its post with both hands on it. A hand may let go
    /// at any time; behind the plane of the buttons it is then as far as it gets at 2.0 m/s.
    TwoHandControl,
    /// A sensor inside the FMU, which reports it with a Boolean output.
    Reported,
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
    #[schemars(with = "Option<ZoneTable>")]
    pub zone: Option<Spanned<ZoneTable>>,
    /// FMU input it drives, or for `reported` the output that tells it (Boolean).
    #[schemars(with = "String")]
    pub variable: Spanned<String>,
    /// Value while a person is detected; `false` is the usual fail-safe polarity of safety signals. May be left out where
    /// the name says that it is one (`S_...` of PLCopen, `...OSSD...`): then it is `false`.
    #[serde(default)]
    pub active: Option<bool>,
    /// Response time before the input changes, ms; rounded up to whole steps.
    #[serde(default)]
    #[schemars(with = "f64")]
    pub delay_ms: Option<Spanned<f64>>,
}

/// Where a sensor sees.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct ZoneTable {
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
    /// Where the person stands at the start and looks. May be left out where there are start areas: then their first place
    /// is the start.
    #[serde(default)]
    #[schemars(with = "Option<StartTable>")]
    pub start: Option<Spanned<StartTable>>,
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
    /// Radii of body parts that are not those of a person of this stature.
    #[serde(default)]
    #[schemars(with = "Option<Radii>")]
    pub radii_m: Option<Spanned<Radii>>,
    /// Further starts; each is searched by itself.
    #[serde(default)]
    #[schemars(with = "Vec<StartTable>")]
    pub other_starts: Vec<Spanned<StartTable>>,
    /// Areas in which the person may start: every free place of a lattice in them is a start, and is searched by itself.
    #[serde(default, rename = "start_area")]
    #[schemars(with = "Vec<StartAreaTable>")]
    pub start_areas: Vec<Spanned<StartAreaTable>>,
    /// When the person begins, s after the FMU's own start; each is searched by itself, from every start. So a scan does
    /// not depend on where in its cycle the robot is. Until then the person stands at the start.
    #[serde(default = "at_once")]
    #[schemars(with = "Vec<f64>")]
    pub begins_s: Spanned<Vec<f64>>,
}

fn at_once() -> Spanned<Vec<f64>> {
    Spanned::new(0..0, vec![0.0])
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

/// An area in which the person may start: at the places whose coordinates are whole multiples of the spacing in the world
/// frame, its edge included, where no obstacle is in the way, in each of the headings.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartAreaTable {
    /// Corners of a convex or concave polygon in the floor plane, m, in order.
    pub polygon_m: Vec<[f64; 2]>,
    /// Distance of neighbouring places along x and y, m, 0.05 to 5.
    pub spacing_m: f64,
    /// Headings, degrees from +x towards +y.
    pub heading_deg: Vec<f64>,
}

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
