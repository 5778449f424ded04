//! From the cell file to a [`Workcell`]: SI units, checked values, every mistake with its line and what to do.

use std::cell::RefCell;
use std::ops::Range;
use std::path::PathBuf;

use toml::Spanned;
use toml::de::{DeTable, DeValue};

use super::CellError;
use super::error::{Problems, Source, meant};
use super::files::Files;
use super::format::{CellFile, FailOnTable, HumanTable, PoseQuantity, PoseTable, SearchTable, Sex, StartTable};
use crate::geometry::kinematics::KinematicTree;
use crate::geometry::{Cuboid, Pose, Rotation, Solid, Vec3, rotation_about};
use crate::human::action::ACTION_S;
use crate::human::body::BodyError;
use crate::human::{Anthropometry, Body, Radii, Start};
use crate::standards::anthropometry::{Percentile, Sex as AnsurSex};

/// A validated cell in SI units and radians.
#[derive(Debug)]
pub struct Workcell {
    /// Name of the cell.
    pub name: String,
    /// SHA-256 of the cell file's text, lower-case hex.
    pub sha256: String,
    /// The FMUs as written, relative to the cell file: one without a name, or several with names; none if the file
    /// travels inside its FMU.
    pub fmus: Vec<UnitFile>,
    /// Communication step and contact-check interval, s.
    pub step_s: f64,
    /// Communication steps in one action.
    pub steps_per_action: usize,
    /// Robots.
    pub robots: Vec<Robot>,
    /// Files beside the cell file that robots, shapes and obstacles come from, in the order in which they were first read.
    pub files: Vec<GeometryFile>,
    /// What the user should know of those.
    pub warnings: Vec<String>,
    /// Robot collision shapes, robot after robot.
    pub links: Vec<Link>,
    /// Static boxes by name.
    pub obstacles: Vec<(String, Cuboid)>,
    /// For each of them the obstacle of the cell file that says it; none for boxes in a mesh.
    pub obstacle_tables: Vec<Option<usize>>,
    /// Sensors.
    pub sensors: Vec<Sensor>,
    /// What of the person's pose goes to the FMU.
    pub pose: Vec<PoseQuantity>,
    /// Where and when the person may begin; each is searched by itself.
    pub beginnings: Vec<Beginning>,
    /// Which of them this is about, from 0.
    pub beginning: usize,
    /// The person's start.
    pub start: Start,
    /// The person's body.
    pub body: Body,
    /// Budget.
    pub search: SearchTable,
    /// The scan whose hazards are known and do not make another scan fail, relative to the cell file; none if every
    /// hazard does.
    pub baseline: Option<String>,
    /// The file itself, for binding variables.
    pub(super) file: CellFile,
}

/// Where and when the person begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Beginning {
    /// Where the person stands and looks.
    pub start: Start,
    /// Communication steps from the FMU's own start until the person begins.
    pub lead_in_steps: usize,
}

impl Beginning {
    /// Time from the FMU's own start until the person begins, s.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "an hour of small steps at most")]
    pub fn begins_s(&self, step_s: f64) -> f64 {
        self.lead_in_steps as f64 * step_s
    }
}

/// An FMU of the cell.
#[derive(Clone, Debug)]
pub struct UnitFile {
    /// Name in front of its variables; empty for the only FMU.
    pub name: String,
    /// Path relative to the cell file.
    pub path: Spanned<String>,
}

/// A robot.
#[derive(Clone, Debug)]
pub struct Robot {
    /// Name.
    pub name: String,
    /// `world_from_base`.
    pub world_from_base: Pose,
    /// Kinematics, unless the FMU gives the poses of its parts.
    pub kinematics: Option<Kinematics>,
    /// Mass of the moving parts `M`, kg.
    pub moving_mass_kg: f64,
    /// Line of the cell file that says so, or names the URDF that does, from 1.
    pub mass_line: usize,
}

/// What a robot's joints are, and what moves them.
#[derive(Clone, Debug, PartialEq)]
pub struct Kinematics {
    /// The joints.
    pub tree: KinematicTree,
    /// For each joint, its position from those that the cell file names.
    pub driven: Vec<Driven>,
    /// For each joint the fastest that it may move by its URDF, rad/s or m/s, where that is told.
    pub fastest: Vec<Option<f64>>,
}

/// A joint's position: `factor * named + offset`. Other than 1 and 0 for joints that mimic others.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Driven {
    /// Index among the `joint`s of the cell file.
    pub named: usize,
    /// Factor.
    pub factor: f64,
    /// Offset, rad or m.
    pub offset: f64,
}

impl Kinematics {
    /// Positions and speeds of all joints from those of the named ones.
    #[must_use]
    pub fn all(&self, positions: &[f64], speeds: &[f64]) -> (Vec<f64>, Vec<f64>) {
        let position = |d: &Driven| d.factor * positions[d.named] + d.offset;
        let speed = |d: &Driven| d.factor * speeds[d.named];
        (self.driven.iter().map(position).collect(), self.driven.iter().map(speed).collect())
    }
}

/// A file beside the cell file that says part of what the cell is.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct GeometryFile {
    /// As the cell file, or the URDF, names it; relative to the cell file.
    pub path: PathBuf,
    /// SHA-256, lower-case hex.
    pub sha256: String,
}

/// A collision shape of a robot.
#[derive(Clone, Debug)]
pub struct Link {
    /// Name used in results; with several robots, the robot's name stands in front.
    pub name: String,
    /// Index of the robot.
    pub robot: usize,
    /// Index of the joint whose moving side carries it, or of the frame.
    pub joint: usize,
    /// Shape in the joint frame.
    pub shape: Solid,
    /// Line of the cell file that names its joint, from 1.
    pub line: usize,
}

/// A sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensor {
    /// Name used in results.
    pub name: String,
    /// Where it sees.
    pub zone: Zone,
    /// Value of the FMU variable while a person is detected.
    pub active: bool,
    /// Response time in whole steps.
    pub delay_steps: usize,
}

/// Where a sensor sees.
#[derive(Clone, Debug, PartialEq)]
pub enum Zone {
    /// A polygon on the floor, m, that feet stand on.
    Mat(Vec<[f64; 2]>),
    /// A polygon on the floor, m, above which legs stand.
    Field(Vec<[f64; 2]>),
    /// The upright plane of a light curtain, as a box without thickness.
    Curtain(Cuboid),
    /// The upright plane of a guard door, likewise.
    Door(Cuboid),
    /// A two-hand control.
    TwoHand {
        /// Polygon on the floor, m, in which its operator's feet are.
        post: Vec<[f64; 2]>,
        /// The upright plane through the buttons, which no hand passes that holds them.
        plane: Cuboid,
    },
    /// Inside the FMU.
    Reported,
}

impl Zone {
    /// The plane that arms do not pass unseen, and for a two-hand control, where its operator stands.
    #[must_use]
    pub fn plane(&self) -> Option<(&Cuboid, Option<&[[f64; 2]]>)> {
        match self {
            Self::Curtain(plane) | Self::Door(plane) => Some((plane, None)),
            Self::TwoHand { post, plane } => Some((plane, Some(post))),
            Self::Mat(_) | Self::Field(_) | Self::Reported => None,
        }
    }
}

impl Workcell {
    /// The file's tables, for binding variables.
    #[must_use]
    pub const fn file(&self) -> &CellFile {
        &self.file
    }

    /// Communication steps from the FMU's own start until the person begins.
    #[must_use]
    pub fn lead_in_steps(&self) -> usize {
        self.beginnings[self.beginning].lead_in_steps
    }

    /// Time from the FMU's own start until the person begins, s.
    #[must_use]
    pub fn begins_s(&self) -> f64 {
        self.beginnings[self.beginning].begins_s(self.step_s)
    }

    /// The same with another of its beginnings, which there must be.
    #[must_use]
    pub fn beginning_at(mut self, number: usize) -> Self {
        self.beginning = number;
        self.start = self.beginnings[number].start;
        self
    }
}

/// Latest that a person may begin, s.
const LATEST_S: f64 = 3600.0;

/// The baseline's file unless the cell names another.
pub const BASELINE: &str = "baseline.json";

/// Reads and checks a cell file.
///
/// # Errors
/// All mistakes together, each with its line.
pub fn validate(source: &Source) -> Result<Workcell, Box<CellError>> {
    check(source, parse(source)?)
}

/// Reads a cell file's tables.
///
/// # Errors
/// What is no TOML or of another type, and all unknown keys before it.
pub fn parse(source: &Source) -> Result<CellFile, Box<CellError>> {
    let unknown = Problems::default();
    let mut text = source.text().to_owned();
    loop {
        let error = match toml::from_str(&text) {
            Ok(file) => return unknown.take_or(file),
            Err(error) => error,
        };
        let problem = source.parse_error(&error);
        match without_unknown_key(&text, &error) {
            Some(rest) => text = rest,
            None => return Err(problem.and(unknown.take_or(()).err().map(|others| *others))),
        }
        unknown.tell(problem);
    }
}

/// `text` with the unknown key that is complained about put right if it is a slip, else blanked out; other places stay
/// where they are.
fn without_unknown_key(text: &str, error: &toml::de::Error) -> Option<String> {
    let span = error.span().filter(|_| error.message().starts_with("unknown field"))?;
    let (before, after) = (text.get(..span.start)?, text.get(span.end..)?);
    let room = span.len() + after.len() - after.trim_start_matches(' ').len();
    if let Some(meant) = meant(error.message()).filter(|meant| meant.len() <= room) {
        let mended = format!("{before}{meant:<room$}{}", &text[span.start + room..]);
        if DeTable::parse(&mended).is_ok() {
            return Some(mended);
        }
    }
    let end = value_of(DeTable::parse(text).ok()?.get_ref(), span.start).filter(|end| *end >= span.end)?;
    let line = before.rfind('\n').map_or(0, |newline| newline + 1);
    let (mut from, mut to) = (span.start, end);
    if !before[line..].trim().is_empty() {
        // In an inline table, where commas stand between.
        let rest = &text[end..];
        match (rest.trim_start().starts_with(','), before.trim_end().ends_with(',')) {
            (true, _) => to += rest.find(',')? + 1,
            (false, true) => from = before.rfind(',')?,
            (false, false) => {}
        }
    }
    let blank = text[from..to].chars().map(|c| if c == '\n' { "\n".to_owned() } else { " ".repeat(c.len_utf8()) });
    Some(format!("{}{}{}", &text[..from], blank.collect::<String>(), &text[to..]))
}

/// Where the value ends whose key begins at `key`.
fn value_of(table: &DeTable<'_>, key: usize) -> Option<usize> {
    table.iter().find_map(|(name, value)| {
        if name.span().start == key {
            return Some(value.span().end);
        }
        in_value(value.get_ref(), key)
    })
}

fn in_value(value: &DeValue<'_>, key: usize) -> Option<usize> {
    match value {
        DeValue::Table(table) => value_of(table, key),
        DeValue::Array(list) => list.iter().find_map(|item| in_value(item.get_ref(), key)),
        _ => None,
    }
}

/// Checks what a cell file says.
///
/// # Errors
/// All mistakes together, each with its line.
pub fn check(source: &Source, file: CellFile) -> Result<Workcell, Box<CellError>> {
    let check = Checker::new(source);
    let cell = check.workcell(file);
    check.problems.take_or(cell).map(|cell| cell.expect("nothing is missing without a problem"))
}

pub(super) fn pose(table: &PoseTable) -> Pose {
    Pose::from_parts(Vec3::from_array(table.xyz_m), roll_pitch_yaw(table.rpy_deg.map(f64::to_radians)))
}

/// Rotation for roll, pitch, yaw in radians about the fixed x, y and z axes (the URDF convention).
pub(super) fn roll_pitch_yaw([r, p, y]: [f64; 3]) -> Rotation {
    rotation_about(Vec3::Z, y) * rotation_about(Vec3::Y, p) * rotation_about(Vec3::X, r)
}

/// Checks with the file at hand, so that each mistake can be shown where it stands.
pub(super) struct Checker<'a> {
    pub(super) source: &'a Source,
    pub(super) problems: Problems,
    /// Files that were read.
    pub(super) files: Files,
    pub(super) warnings: RefCell<Vec<String>>,
}

impl<'a> Checker<'a> {
    pub(super) fn new(source: &'a Source) -> Self {
        Self { source, problems: Problems::default(), files: Files::default(), warnings: RefCell::default() }
    }
}

impl Checker<'_> {
    /// The cell; nothing if there were problems that leave a gap.
    fn workcell(&self, file: CellFile) -> Option<Workcell> {
        let known = self.that(*file.schema.get_ref() == 1, file.schema.span(), || {
            (
                format!("cell format {} is not known to this version", file.schema.get_ref()),
                "this version reads `schema = 1`".to_owned(),
            )
        });
        let known = self.problems.keep(known);
        let step = self.problems.keep(self.step(&file));
        let fmus = self.problems.keep(self.fmus(&file));
        let robots = self.robots(&file);
        let sensors = self.sensors(&file, step.map_or(0.02, |(step_s, _)| step_s));
        let (obstacles, obstacle_tables) = self.obstacles(&file);
        let beginnings = self.beginnings(&file.human, step.map_or(0.02, |(step_s, _)| step_s));
        let body = self.problems.keep(self.body(&file));
        let budget = self.problems.keep(self.search(&file.search));
        let baseline = self.problems.keep(self.baseline(&file.fail_on));
        let ((), ()) = (known?, budget?);
        let ((step_s, steps_per_action), (robots, links)) = (step?, robots);
        Some(Workcell {
            name: file.name.clone(),
            sha256: self.source.sha256(),
            fmus: fmus?,
            step_s,
            steps_per_action,
            robots,
            files: self.files.take(),
            warnings: self.warnings.take(),
            links,
            obstacles,
            obstacle_tables,
            sensors,
            pose: file.pose.keys().copied().collect(),
            start: beginnings.first()?.start,
            beginnings,
            beginning: 0,
            body: body?,
            search: file.search,
            baseline: baseline?,
            file,
        })
    }

    /// Every start at every time, the starts of one time together.
    fn beginnings(&self, human: &HumanTable, step_s: f64) -> Vec<Beginning> {
        let starts = std::iter::once(&human.start).chain(&human.other_starts);
        let starts = self.problems.keep_all(starts.map(|table| {
            let StartTable { xy_m: [x, y], heading_deg } = *table.get_ref();
            self.finite(&[x, y, heading_deg], &table.span(), "the start pose")?;
            Ok(Start::new(x, y, heading_deg))
        }));
        let times = &human.begins_s;
        let none = self.that(!times.get_ref().is_empty(), times.span(), || {
            ("human.begins_s is empty".to_owned(), "leave it out, or give [0, 1.5, 3]".to_owned())
        });
        let _ = self.problems.keep(none);
        let times = self.problems.keep_all(times.get_ref().iter().map(|&time| {
            self.that((0.0..=LATEST_S).contains(&time), times.span(), || {
                (format!("human.begins_s has {time}"), format!("use times from 0 to {LATEST_S} s"))
            })?;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "checked: an hour of small steps"
            )]
            Ok((time / step_s).round() as usize)
        }));
        let at = |&lead_in_steps: &usize| starts.iter().map(move |&start| Beginning { start, lead_in_steps });
        times.iter().flat_map(at).collect()
    }

    fn baseline(&self, table: &FailOnTable) -> Result<Option<String>, Box<CellError>> {
        match (&table.baseline, table.new_only) {
            (None, false) => Ok(None),
            (None, true) => Ok(Some(BASELINE.to_owned())),
            (Some(path), true) => Ok(Some(path.get_ref().clone())),
            (Some(path), false) => Err(self.source.error(
                path.span(),
                "never read",
                "a baseline is named, and every hazard makes a scan fail all the same",
                Some("add `new_only = true`, or leave the baseline out".to_owned()),
            )),
        }
    }

    pub(super) fn that(
        &self,
        ok: bool,
        span: Range<usize>,
        say: impl FnOnce() -> (String, String),
    ) -> Result<(), Box<CellError>> {
        if ok {
            return Ok(());
        }
        let (message, help) = say();
        Err(self.source.error(span, "here", message, Some(help)))
    }

    pub(super) fn positive(&self, value: f64, span: &Range<usize>, what: &str) -> Result<(), Box<CellError>> {
        self.that(value.is_finite() && value > 0.0, span.clone(), || {
            (format!("{what} must be greater than zero, not {value}"), "check the number and its unit".to_owned())
        })
    }

    pub(super) fn finite(&self, values: &[f64], span: &Range<usize>, what: &str) -> Result<(), Box<CellError>> {
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

    /// The FMUs that the file names.
    fn fmus(&self, file: &CellFile) -> Result<Vec<UnitFile>, Box<CellError>> {
        if let (Some(fmu), Some(unit)) = (&file.fmu, file.units.first()) {
            let message = "the cell names one FMU with `fmu` and others with `unit`";
            let help = Some(format!("make `{}` a unit as well, or remove it", fmu.get_ref()));
            return Err(self.source.error(unit.span(), "here", message, help));
        }
        for (i, unit) in file.units.iter().enumerate() {
            let name = &unit.get_ref().name;
            self.that(!name.is_empty() && !name.contains(':'), unit.span(), || {
                (format!("a unit is called `{name}`"), "give each unit a name without a colon".to_owned())
            })?;
            self.that(file.units[..i].iter().all(|u| u.get_ref().name != *name), unit.span(), || {
                (format!("two units are called `{name}`"), "give each unit its own name".to_owned())
            })?;
        }
        let only = file.fmu.iter().map(|path| UnitFile { name: String::new(), path: path.clone() });
        let units = file.units.iter().map(|u| u.get_ref());
        Ok(only.chain(units.map(|u| UnitFile { name: u.name.clone(), path: u.fmu.clone() })).collect())
    }

    fn body(&self, file: &CellFile) -> Result<Body, Box<CellError>> {
        let h = &file.human;
        let percentile = match h.percentile.get_ref() {
            5 => Percentile::P5,
            50 => Percentile::P50,
            95 => Percentile::P95,
            other => {
                let message = format!("body measures are known for percentiles 5, 50 and 95, not {other}");
                let help = Some("take the nearest; 5 and 95 show what size changes".to_owned());
                return Err(self.source.error(h.percentile.span(), "here", message, help));
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
            radii_m: h.radii_m.as_ref().map_or_else(Radii::default, |radii| *radii.get_ref()),
        };
        Body::new(&measures).map_err(|e| {
            let (span, help) = match (&e, &h.radii_m) {
                (BodyError::RadiusOutOfRange { .. }, Some(radii)) => (radii.span(), "radii are in m"),
                _ => (h.start.span(), "bends of a person are between 0 and 90 degrees"),
            };
            self.source.error(span, "for this person", e.to_string(), Some(help.to_owned()))
        })
    }

    fn search(&self, s: &SearchTable) -> Result<(), Box<CellError>> {
        self.that(s.iterations > 0 && (1..=64).contains(&s.actions), self.source.table("search"), || {
            ("[search] needs iterations > 0 and actions from 1 to 64".to_owned(), "the paper uses 320 and 8".to_owned())
        })?;
        self.that((0.001..=0.05).contains(&s.reach_tolerance_m), self.source.table("search"), || {
            (format!("search.reach_tolerance_m is {}", s.reach_tolerance_m), "use 0.001 to 0.05 m".to_owned())
        })
    }
}
