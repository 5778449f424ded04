//! Robots in the cell file: joints or frames, link shapes, and the outputs that they are read from.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema};
use serde::Deserialize;
use serde_json::{Value, json};
use toml::Spanned;

use super::{ContactTable, PoseTable};

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
    /// Where the payload's centre of mass is, for how heavy the robot is where it hits; if not told, in the middle of the last of
    /// the robot's shapes. (Of use where `inertia`s, or those of a URDF, say how the robot's mass is spread.)
    #[serde(default)]
    pub payload_at: Option<PayloadPlaceTable>,
    /// Joints from the base to the tool, each on the one before, or those of the URDF; or `frame`s.
    #[serde(default, rename = "joint")]
    pub joints: Vec<JointTable>,
    /// Moving parts whose poses the FMU gives; or `joint`s.
    #[serde(default, rename = "frame")]
    pub frames: Vec<FrameTable>,
    /// Collision shapes, each rigidly attached to a joint's moving side.
    #[serde(default, rename = "link")]
    pub links: Vec<LinkTable>,
    /// What all its links are like where they touch that do not say it themselves: for the pressure.
    #[serde(default)]
    #[schemars(with = "Option<ContactTable>")]
    pub contact: Option<Spanned<ContactTable>>,
    /// The same of links by name, for instance of a URDF.
    #[serde(default)]
    #[schemars(with = "BTreeMap<String, ContactTable>")]
    pub contacts: BTreeMap<String, Spanned<ContactTable>>,
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
    /// How the mass of its moving side is spread, up to the next joints: for how heavy the robot is where it hits, which is told
    /// of hazards where this is known of all joints. It counts instead of what a URDF says.
    #[serde(default)]
    #[schemars(with = "Option<InertiaTable>")]
    pub inertia: Option<Spanned<InertiaTable>>,
}

/// How the mass of a rigid body is spread.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct InertiaTable {
    /// Its mass, kg.
    pub mass_kg: f64,
    /// Its centre of mass in the joint frame, m.
    pub centre_m: [f64; 3],
    /// Moments of inertia xx, yy, zz about the centre of mass, in the directions of the joint frame, kg m^2.
    pub moments_kg_m2: [f64; 3],
    /// Products of inertia xy, xz, yz likewise, as entries of the tensor: `-sum(m x y)` and so on.
    #[serde(default)]
    pub products_kg_m2: [f64; 3],
}

/// Where the payload is.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct PayloadPlaceTable {
    /// The joint whose moving side carries it; with a URDF also one of its links.
    #[schemars(with = "String")]
    pub joint: Spanned<String>,
    /// Its centre of mass in that frame, m.
    pub centre_m: [f64; 3],
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
    /// What the shape is like where it touches: for the pressure.
    #[serde(default)]
    #[schemars(with = "Option<ContactTable>")]
    pub contact: Option<Spanned<ContactTable>>,
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
