//! From the cell file to a [`Workcell`]: SI units, checked values, every mistake with its line and what to do.

use std::ops::Range;

use sha2::{Digest as _, Sha256};
use toml::Spanned;

use super::CellError;
use super::error::{Source, nearest};
use super::format::{CapsuleTable, CellFile, LinkTable, PoseTable, SearchTable, SensorKind, SensorTable, Sex};
use crate::geometry::chain::{Joint, KinematicChain};
use crate::geometry::{Capsule, Cuboid, Hull, Pose, Rotation, Solid, Vec3, rotation_about};
use crate::human::action::ACTION_S;
use crate::human::{Anthropometry, Body, Start};
use crate::standards::anthropometry::{Percentile, Sex as AnsurSex};

/// A validated cell in SI units and radians.
#[derive(Debug)]
pub struct Workcell {
    /// Name of the cell.
    pub name: String,
    /// SHA-256 of the cell file's text, lower-case hex.
    pub sha256: String,
    /// The FMU's file name as written, relative to the cell file.
    pub fmu: Option<Spanned<String>>,
    /// Communication step and contact-check interval, s.
    pub step_s: f64,
    /// Communication steps in one action.
    pub steps_per_action: usize,
    /// Robot name.
    pub robot_name: String,
    /// Robot kinematics.
    pub chain: KinematicChain,
    /// Robot collision shapes.
    pub links: Vec<Link>,
    /// Mass of the moving parts `M`, kg.
    pub moving_mass_kg: f64,
    /// Static boxes by name.
    pub obstacles: Vec<(String, Cuboid)>,
    /// Sensors.
    pub sensors: Vec<Sensor>,
    /// The person's start.
    pub start: Start,
    /// The person's body.
    pub body: Body,
    /// Budget.
    pub search: SearchTable,
    /// The file itself, for binding variables.
    pub(super) file: CellFile,
}

/// A collision shape of the robot.
#[derive(Clone, Debug)]
pub struct Link {
    /// Name used in results.
    pub name: String,
    /// Index of the joint whose moving side carries it.
    pub joint: usize,
    /// Shape in the joint frame.
    pub shape: Solid,
}

/// A sensor on the floor plan.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Name used in results.
    pub name: String,
    /// Kind.
    pub kind: SensorKind,
    /// Polygon on the floor, m.
    pub polygon: Vec<[f64; 2]>,
    /// Height of a scanner field, m.
    pub height_m: f64,
    /// Value written while a person is detected.
    pub active: bool,
    /// Response time in whole steps.
    pub delay_steps: usize,
}

/// Longest sensor response in steps: the delay line is one 64-bit word.
const MAX_DELAY_STEPS: usize = 63;

/// Reads and checks a cell file.
///
/// # Errors
/// The first mistake, with its line.
pub fn validate(source: &Source) -> Result<Workcell, Box<CellError>> {
    let file: CellFile = toml::from_str(source.text()).map_err(|e| source.parse_error(&e))?;
    let check = Checker(source);
    check.that(*file.schema.get_ref() == 1, file.schema.span(), || {
        (
            format!("cell format {} is not known to this version", file.schema.get_ref()),
            "this version reads `schema = 1`".to_owned(),
        )
    })?;
    let (step_s, steps_per_action) = check.step(&file)?;
    let chain = check.chain(&file)?;
    let links = check.links(&file)?;
    let sensors = check.sensors(&file, step_s)?;
    let obstacles = check.obstacles(&file)?;
    let mass = &file.robot.get_ref().moving_mass_kg;
    check.positive(*mass.get_ref(), &mass.span(), "the moving mass of the robot")?;
    if let Some(payload) = &file.robot.get_ref().payload_kg {
        let kg = *payload.get_ref();
        check.that(kg.is_finite() && kg >= 0.0, payload.span(), || {
            (format!("payload_kg is {kg}"), "use zero or more kilograms".to_owned())
        })?;
    }
    let start = file.human.start.get_ref();
    check.finite(&[start.xy_m[0], start.xy_m[1], start.heading_deg], &file.human.start.span(), "the start pose")?;
    let body = check.body(&file)?;
    check.search(&file.search)?;
    Ok(Workcell {
        name: file.name.clone(),
        sha256: Sha256::digest(source.text().as_bytes()).iter().map(|b| format!("{b:02x}")).collect(),
        fmu: file.fmu.clone(),
        step_s,
        steps_per_action,
        robot_name: file.robot.get_ref().name.clone(),
        chain,
        links,
        moving_mass_kg: *mass.get_ref(),
        obstacles,
        sensors,
        start: Start::new(start.xy_m[0], start.xy_m[1], start.heading_deg),
        body,
        search: file.search,
        file,
    })
}

fn pose(table: &PoseTable) -> Pose {
    Pose::from_parts(Vec3::from_array(table.xyz_m), roll_pitch_yaw(table.rpy_deg))
}

/// Rotation for roll, pitch, yaw in degrees about the fixed x, y and z axes (the URDF convention).
fn roll_pitch_yaw(deg: [f64; 3]) -> Rotation {
    let [r, p, y] = deg.map(f64::to_radians);
    rotation_about(Vec3::Z, y) * rotation_about(Vec3::Y, p) * rotation_about(Vec3::X, r)
}

struct Checker<'a>(&'a Source);

impl Checker<'_> {
    fn that(&self, ok: bool, span: Range<usize>, say: impl FnOnce() -> (String, String)) -> Result<(), Box<CellError>> {
        if ok {
            return Ok(());
        }
        let (message, help) = say();
        Err(self.0.error(span, "here", message, Some(help)))
    }

    fn positive(&self, value: f64, span: &Range<usize>, what: &str) -> Result<(), Box<CellError>> {
        self.that(value.is_finite() && value > 0.0, span.clone(), || {
            (format!("{what} must be greater than zero, not {value}"), "check the number and its unit".to_owned())
        })
    }

    fn finite(&self, values: &[f64], span: &Range<usize>, what: &str) -> Result<(), Box<CellError>> {
        self.that(values.iter().all(|v| v.is_finite()), span.clone(), || {
            (format!("{what} is not finite"), "write plain numbers".to_owned())
        })
    }

    fn step(&self, file: &CellFile) -> Result<(f64, usize), Box<CellError>> {
        let step = *file.time.step_s.get_ref();
        let help = || "use 0.02, 0.01 or 0.005".to_owned();
        self.that(step.is_finite() && step > 0.0 && step <= 0.02 + 1e-12, file.time.step_s.span(), || {
            (format!("time.step_s is {step}; contacts must be checked at least every 0.02 s"), help())
        })?;
        let count = (ACTION_S / step).round();
        self.that((count * step - ACTION_S).abs() < 1e-9 && count <= 1000.0, file.time.step_s.span(), || {
            (format!("time.step_s = {step} does not divide one action of 0.2 s"), help())
        })?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked: between 10 and 1000")]
        Ok((step, count as usize))
    }

    fn chain(&self, file: &CellFile) -> Result<KinematicChain, Box<CellError>> {
        let robot = file.robot.get_ref();
        self.that(!robot.joints.is_empty(), file.robot.span(), || {
            ("the robot has no joints".to_owned(), "add [[robot.joint]] tables, base to tool".to_owned())
        })?;
        let mut joints = Vec::with_capacity(robot.joints.len());
        for (i, joint) in robot.joints.iter().enumerate() {
            let name = joint.name.get_ref();
            self.that(robot.joints[..i].iter().all(|j| j.name.get_ref() != name), joint.name.span(), || {
                (format!("two joints are called `{name}`"), "give each joint its own name".to_owned())
            })?;
            let axis = Vec3::from_array(*joint.axis.get_ref());
            self.that(axis.is_finite() && axis.length() > 1e-9, joint.axis.span(), || {
                (format!("the axis of joint `{name}` has no direction"), "for instance axis = [0, 0, 1]".to_owned())
            })?;
            joints.push(Joint { parent_from_joint: pose(&joint.origin), axis: axis / axis.length() });
        }
        Ok(KinematicChain { world_from_base: pose(&robot.base), joints })
    }

    fn links(&self, file: &CellFile) -> Result<Vec<Link>, Box<CellError>> {
        let robot = file.robot.get_ref();
        self.that(!robot.links.is_empty(), file.robot.span(), || {
            (
                "the cell has no robot geometry: without link shapes nothing can be hit".to_owned(),
                "add [[robot.link]] tables with a `capsule` or `hull_m` each".to_owned(),
            )
        })?;
        robot.links.iter().map(|link| self.link(link, file)).collect()
    }

    fn link(&self, link: &LinkTable, file: &CellFile) -> Result<Link, Box<CellError>> {
        let joints = &file.robot.get_ref().joints;
        let wanted = link.joint.get_ref();
        let Some(joint) = joints.iter().position(|j| j.name.get_ref() == wanted) else {
            let names: Vec<&str> = joints.iter().map(|j| j.name.get_ref().as_str()).collect();
            let help = match nearest(wanted, names.iter().copied()) {
                Some(name) => format!("did you mean `{name}`?"),
                None => format!("the joints are {}", names.join(", ")),
            };
            return Err(self.0.error(link.joint.span(), "here", format!("there is no joint `{wanted}`"), Some(help)));
        };
        let span = link.joint.span();
        let shape = match (&link.capsule, &link.hull_m) {
            (Some(capsule), None) => Solid::Capsule(self.capsule(capsule, &span)?),
            (None, Some(points)) => {
                let list: Vec<Vec3> = points.get_ref().iter().map(|p| Vec3::from_array(*p)).collect();
                let hull = Hull::from_points(&list).ok_or_else(|| {
                    let help = "give at least four corner points that are not in one plane".to_owned();
                    self.0.error(points.span(), "here", "these points have no convex hull with volume", Some(help))
                })?;
                Solid::Hull(hull)
            }
            _ => {
                let message = format!("link `{}` needs one shape: either `capsule` or `hull_m`", link.name);
                return Err(self.0.error(span, "in this link", message, None));
            }
        };
        Ok(Link { name: link.name.clone(), joint, shape })
    }

    fn capsule(&self, table: &CapsuleTable, span: &Range<usize>) -> Result<Capsule, Box<CellError>> {
        self.positive(table.radius_m, span, "the radius of a link")?;
        let (a, b) = (Vec3::from_array(table.from_m), Vec3::from_array(table.to_m));
        self.that(a.is_finite() && b.is_finite(), span.clone(), || {
            ("a capsule end is not finite".to_owned(), "write plain numbers".to_owned())
        })?;
        Ok(Capsule { a, b, radius: table.radius_m })
    }

    fn obstacles(&self, file: &CellFile) -> Result<Vec<(String, Cuboid)>, Box<CellError>> {
        let mut all = Vec::with_capacity(file.obstacles.len());
        for o in &file.obstacles {
            for edge in o.size_m.get_ref() {
                self.positive(*edge, &o.size_m.span(), &format!("each edge of obstacle `{}`", o.name))?;
            }
            let centre = Vec3::from_array(o.centre_m);
            self.finite(&o.centre_m, &o.size_m.span(), &format!("the centre of obstacle `{}`", o.name))?;
            let half = Vec3::from_array(*o.size_m.get_ref()) * 0.5;
            all.push((o.name.clone(), Cuboid { centre, half, rotation: roll_pitch_yaw(o.rpy_deg) }));
        }
        Ok(all)
    }

    fn sensors(&self, file: &CellFile, step_s: f64) -> Result<Vec<Sensor>, Box<CellError>> {
        file.sensors.iter().map(|s| self.sensor(s, step_s)).collect()
    }

    fn sensor(&self, s: &SensorTable, step_s: f64) -> Result<Sensor, Box<CellError>> {
        let polygon = s.zone.polygon_m.get_ref();
        let span = s.zone.polygon_m.span();
        self.that(polygon.len() >= 3, span.clone(), || {
            (format!("the zone of sensor `{}` needs at least three corners", s.name), "[[x, y], ...] in m".to_owned())
        })?;
        self.finite(&polygon.concat(), &span, &format!("the zone of sensor `{}`", s.name))?;
        let height_m = match (s.kind, s.zone.height_m) {
            (SensorKind::ScannerField, None) => 0.2,
            (_, h) => h.unwrap_or(0.0),
        };
        self.that((0.0..=1.0).contains(&height_m), span.clone(), || {
            (format!("the height of sensor `{}` is {height_m} m", s.name), "ISO 13855 allows 0 to 1 m".to_owned())
        })?;
        let delay_ms = s.delay_ms.as_ref().map_or(0.0, |d| *d.get_ref());
        let steps = (delay_ms / 1000.0 / step_s - 1e-9).ceil();
        let delay_span = s.delay_ms.as_ref().map_or(span, Spanned::span);
        #[expect(clippy::cast_precision_loss, reason = "63")]
        self.that(delay_ms >= 0.0 && steps <= MAX_DELAY_STEPS as f64, delay_span, || {
            let most = MAX_DELAY_STEPS as f64 * step_s * 1000.0;
            (format!("delay_ms of sensor `{}` is {delay_ms}", s.name), format!("use 0 to {most:.0} ms"))
        })?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked: 0 to 63")]
        let delay_steps = steps.max(0.0) as usize;
        Ok(Sensor {
            name: s.name.clone(),
            kind: s.kind,
            polygon: polygon.clone(),
            height_m,
            active: s.active,
            delay_steps,
        })
    }

    fn body(&self, file: &CellFile) -> Result<Body, Box<CellError>> {
        let h = &file.human;
        let percentile = match h.percentile.get_ref() {
            5 => Percentile::P5,
            50 => Percentile::P50,
            95 => Percentile::P95,
            other => {
                let message = format!("body measures are known for percentiles 5, 50 and 95, not {other}");
                return Err(self.0.error(h.percentile.span(), "here", message, None));
            }
        };
        let sex = match h.sex {
            Sex::Woman => AnsurSex::Female,
            Sex::Man => AnsurSex::Male,
        };
        let measures = Anthropometry {
            sex,
            percentile,
            bend_forward_deg: h.bend_forward_deg,
            bend_lateral_deg: h.bend_lateral_deg,
        };
        Body::new(&measures).map_err(|e| self.0.error(h.start.span(), "for this person", e.to_string(), None))
    }

    fn search(&self, s: &SearchTable) -> Result<(), Box<CellError>> {
        self.that(s.iterations > 0 && (1..=64).contains(&s.actions), 0..0, || {
            ("[search] needs iterations > 0 and actions from 1 to 64".to_owned(), "the paper uses 320 and 8".to_owned())
        })?;
        self.that((0.001..=0.05).contains(&s.reach_tolerance_m), 0..0, || {
            (format!("search.reach_tolerance_m is {}", s.reach_tolerance_m), "use 0.001 to 0.05 m".to_owned())
        })
    }
}
