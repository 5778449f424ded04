//! `report.html`: one file that holds the result, the replays and what shows them, and needs nothing else.
//!
//! Everything is drawn by the viewer (`viewer/` at the top of the source tree) from one JSON object, whose form its
//! README describes.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use flate2::Compression;
use flate2::write::GzEncoder;
use serde::{Serialize, Serializer};

use super::assessment::Assessments;
use super::assumptions::assumptions;
use super::floor_map::FloorMap;
use super::words::Words;
use fmi_hazard_record::reachability::ReachabilityResult;

/// What the viewer is built to.
const SCRIPT: &str = include_str!("viewer/viewer.js");
const STYLE: &str = include_str!("viewer/viewer.css");

/// Version of the form of [`Data`].
const FORMAT: u32 = 3;

/// What is in the page. Lengths in m, world frame, z up.
#[derive(Serialize)]
struct Data<'a, S> {
    format: u32,
    scan: &'a S,
    words: Words,
    reproduce: &'a str,
    assumptions: Vec<String>,
    assessments: &'a Assessments,
    cell: &'a Scenery,
    /// A list of [`Replay`] as JSON, gzip, base64: so that fifty of them can be mailed.
    replays: String,
    /// The map of the floor, where people come from anywhere.
    #[serde(skip_serializing_if = "Option::is_none")]
    whole: Option<FloorMap<'a>>,
}

/// The cell.
#[derive(Clone, Debug, Serialize)]
pub struct Scenery {
    /// Its name.
    pub name: String,
    /// Time between two frames, s.
    pub step_s: f64,
    /// Boxes that neither person nor robot pass.
    pub obstacles: Vec<Obstacle>,
    /// Names of all sensors, in the order of the coverage.
    pub sensors: Vec<String>,
    /// Where sensors see, but for those inside the FMU.
    pub zones: Vec<ZoneOutline>,
    /// The robots' links.
    pub links: Vec<LinkShape>,
    /// What some of them look like, packed as replays are.
    #[serde(serialize_with = "packed_list", skip_serializing_if = "Vec::is_empty")]
    pub looks: Vec<LinkVisual>,
    /// The parts of the body.
    pub body: Vec<PartShape>,
    /// The arms.
    pub arm: ArmShape,
    /// The robots.
    pub robots: Vec<RobotBase>,
    /// Where the person begins.
    pub start: StartPlace,
}

/// A box.
#[derive(Clone, Debug, Serialize)]
pub struct Obstacle {
    /// Its name.
    pub name: String,
    /// Its middle.
    pub centre_m: [f64; 3],
    /// Its edges.
    pub size_m: [f64; 3],
    /// Its rotation, x, y, z, w.
    pub quaternion: [f64; 4],
    /// The control that opens it, if it is the leaf of a door.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub opened_by: Option<String>,
    /// Whether it follows the FMU: where it is, the replays say.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub follows: bool,
}

/// Where a sensor sees, or where a control is.
#[derive(Clone, Debug, Serialize)]
pub struct ZoneOutline {
    /// The name of the sensor or of the control.
    pub name: String,
    /// `mat`, `field`, `curtain`, `door`, `post` or `button`.
    pub kind: &'static str,
    /// What it is called and its name, the former only where the name does not tell it.
    pub title: String,
    /// Its outline on the floor plan.
    pub polygon_m: Vec<[f64; 2]>,
    /// From which height to which.
    pub z_m: [f64; 2],
}

impl ZoneOutline {
    /// One of this kind, with what it is called and its name.
    #[must_use]
    pub fn new((called, name): (&str, &str), kind: &'static str, polygon_m: Vec<[f64; 2]>, z_m: [f64; 2]) -> Self {
        let told = name.to_lowercase().contains(called);
        let title = if told { name.to_owned() } else { format!("{called} {name}") };
        Self { name: name.to_owned(), kind, title, polygon_m, z_m }
    }
}

/// A robot link.
#[derive(Clone, Debug, Serialize)]
#[serde(tag = "shape", rename_all = "snake_case")]
pub enum LinkShape {
    /// Its end points are in the replays.
    Capsule {
        /// Link name.
        name: String,
        /// Robot name.
        robot: String,
        /// Radius.
        radius_m: f64,
    },
    /// Its pose is in the replays.
    Hull {
        /// Link name.
        name: String,
        /// Robot name.
        robot: String,
        /// Corners in the link's frame.
        points_m: Vec<[f64; 3]>,
    },
    /// Its pose is in the replays.
    Mesh {
        /// Link name.
        name: String,
        /// Robot name.
        robot: String,
        /// Corners in the link's frame.
        points_m: Vec<[f64; 3]>,
        /// Three corners each, anticlockwise as seen from outside.
        triangles: Vec<[u32; 3]>,
    },
}

/// What a link looks like: more than its shape, which is what is hit.
#[derive(Clone, Debug, Serialize)]
pub struct LinkVisual {
    /// Number of the link, whose shape it turns with.
    pub link: usize,
    /// Corners in the frame of that shape.
    pub points_m: Vec<[f64; 3]>,
    /// Three corners each.
    pub triangles: Vec<[u32; 3]>,
}

/// A part of the body, a capsule.
#[derive(Clone, Debug, Serialize)]
pub struct PartShape {
    /// Its id.
    pub region: String,
    /// Its name.
    pub name: String,
    /// Its radius.
    pub radius_m: f64,
}

/// How thick the arms are.
#[derive(Clone, Debug, Serialize)]
pub struct ArmShape {
    /// Radius of the upper arm.
    pub upper_arm_radius_m: f64,
    /// Radius of the forearm.
    pub forearm_radius_m: f64,
    /// Radius of the sphere around the wrist that the hand, and what it holds, stays in.
    pub hand_radius_m: f64,
    /// How far what it holds reaches beyond the finger tips; 0 for nothing.
    #[serde(skip_serializing_if = "is_zero")]
    pub held_m: f64,
}

/// Nothing that is told.
#[expect(clippy::trivially_copy_pass_by_ref, reason = "serde wants it so")]
fn is_zero(length_m: &f64) -> bool {
    *length_m <= 0.0
}

/// Where a robot stands.
#[derive(Clone, Debug, Serialize)]
pub struct RobotBase {
    /// Its name.
    pub name: String,
    /// Its base, where the cell file says it.
    pub base_m: Option<[f64; 3]>,
    /// Whether that stands upright.
    pub upright: bool,
}

/// Where the person begins.
#[derive(Clone, Debug, Serialize)]
pub struct StartPlace {
    /// On the floor plan.
    pub xy_m: [f64; 2],
    /// From +x towards +y, degrees.
    pub heading_deg: f64,
}

/// Parts of a metre, or of whatever else, that replays tell apart.
const ROUND: f64 = 2048.0;

/// Numbers as the viewer reads them: 32-bit floats, little-endian, base64.
#[derive(Clone, Debug, Default)]
pub struct Floats(pub Vec<f64>);

impl Floats {
    /// Whether there is none.
    #[must_use]
    pub(crate) const fn is_empty(&self) -> bool {
        self.0.is_empty()
    }
}

impl Serialize for Floats {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        // To half a millimetre, in a way that leaves zeros behind, which gzip likes.
        let rounded = self.0.iter().map(|value| (value * ROUND).round() / ROUND);
        #[expect(clippy::cast_possible_truncation, reason = "for pictures")]
        let bytes: Vec<u8> = rounded.flat_map(|value| (value as f32).to_le_bytes()).collect();
        to.serialize_str(&STANDARD.encode(bytes))
    }
}

/// One hazard from the start to the end of its last action, a frame a communication step; frame 0 is the start.
#[derive(Clone, Debug, Serialize)]
pub struct Replay {
    /// The hazard.
    pub id: String,
    /// How many frames.
    pub frames: usize,
    /// That of the contact.
    pub contact_frame: usize,
    /// Frames x links x 7: end points of a capsule and 0, or position and quaternion (x, y, z, w) of a hull or mesh.
    pub links: Floats,
    /// Frames x parts x 6: end points.
    pub body: Floats,
    /// Where obstacles are that follow the FMU.
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub moved: Vec<MovedObstacle>,
    /// The same of another person, who is not hit; empty if there is none.
    #[serde(skip_serializing_if = "Floats::is_empty")]
    pub beside: Floats,
    /// Their arms, which hang.
    #[serde(skip_serializing_if = "Floats::is_empty")]
    pub beside_arms: Floats,
    /// Frames x 2 x 9: shoulder, elbow and wrist of the left arm, then of the right. They hang; one that touches is raised
    /// to the pose that touches, for the reader alone: the model looks at all poses at once.
    pub arms: Floats,
    /// The arm that touches, at the contact.
    pub arm: Option<ArmPose>,
    /// Where robot and person touch.
    pub contact_m: [f64; 3],
    /// Time, s.
    pub time_s: Floats,
    /// From the nearest robot to what is touched: the part of the body, or the limb of the arm as it is drawn, m; 0 where
    /// shapes overlap.
    pub distance_m: Floats,
    /// Speed of the link's point nearest to that, m/s; at the contact that of the contact.
    pub speed_m_s: Floats,
    /// What a hit of this link at that speed on this region would be, relative to its limit, wherever the person is.
    pub force_ratio: Floats,
    /// What the sensors report.
    pub sensors: Vec<SensorTimeline>,
    /// The actions.
    pub actions: Vec<ActionFrame>,
    /// The contact from above, as SVG.
    pub top_view: String,
}

/// An arm.
#[derive(Clone, Debug, Serialize)]
pub struct ArmPose {
    /// `left` or `right`.
    pub side: String,
    /// Shoulder, elbow, wrist.
    pub points_m: [[f64; 3]; 3],
}

/// An obstacle that follows the FMU.
#[derive(Clone, Debug, Serialize)]
pub struct MovedObstacle {
    /// Its number among the obstacles.
    pub obstacle: usize,
    /// A digit a frame: 1 where it is there.
    pub there: String,
    /// Frames x 3: its middle.
    pub centre_m: Floats,
}

/// A sensor's reports.
#[derive(Clone, Debug, Serialize)]
pub struct SensorTimeline {
    /// Its name.
    pub name: String,
    /// A digit a frame: 1 where it reports the person.
    pub detected: String,
}

/// An action.
#[derive(Clone, Debug, Serialize)]
pub struct ActionFrame {
    /// Its name.
    pub name: String,
    /// Frame in which it begins.
    pub frame: usize,
}

/// JSON, gzip, base64.
fn packed<T: Serialize>(list: &[T]) -> std::io::Result<String> {
    let mut packed = GzEncoder::new(Vec::new(), Compression::best());
    serde_json::to_writer(&mut packed, list)?;
    Ok(STANDARD.encode(packed.finish()?))
}

fn packed_list<T: Serialize, S: Serializer>(list: &[T], to: S) -> Result<S::Ok, S::Error> {
    to.serialize_str(&packed(list).map_err(serde::ser::Error::custom)?)
}

/// The page. `scan` is a [`ScanReport`](fmi_hazard_record::model::ScanReport), or one that was read back as JSON; `whole` is what is known of people
/// who come from anywhere, if that was asked.
///
/// # Errors
/// When `scan` is none, or the data cannot be written as JSON, or not be packed.
pub fn render(
    scan: &impl Serialize,
    title: &str,
    reproduce: &str,
    assessments: &Assessments,
    cell: &Scenery,
    replays: &[Replay],
    whole: Option<&ReachabilityResult>,
) -> std::io::Result<String> {
    let (replays, whole) = (packed(replays)?, whole.map(FloorMap::from));
    let told = serde_json::to_value(scan)?;
    let (assumptions, words) = (assumptions(&told["settings"]), Words::of(&told, &cell.sensors)?);
    let data = Data { format: FORMAT, scan, words, reproduce, assumptions, assessments, cell, replays, whole };
    // Nothing in a JSON text can end the element that holds it, then.
    let data = serde_json::to_string(&data)?.replace('<', "\\u003c");
    let title = title.replace('&', "&amp;").replace('<', "&lt;");
    Ok(format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\">\n<meta http-equiv=\"Content-Security-Policy\" \
         content=\"default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data: blob:\">\n\
         <meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">\n<title>{title}: hazard report</title>\n\
         <style>{STYLE}</style></head>\n<body><noscript>This report needs JavaScript; scan.json beside it holds the same \
         results.</noscript><main id=\"report\"></main>\n<script type=\"application/json\" id=\"data\">{data}</script>\n\
         <script>{SCRIPT}</script></body></html>\n"
    ))
}
