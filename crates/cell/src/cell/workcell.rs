//! A cell as it is understood: SI units and radians, checked. `file::validate` makes it from the cell file.

use std::path::PathBuf;
use std::sync::Arc;

use toml::Spanned;

use super::file::format::{CellFile, PeopleFrom, PoseQuantity, SearchTable, StartTable};
use super::following::Following;
use super::sensor::{Placing, Sensor};
use crate::geometry::kinematics::KinematicTree;
use crate::geometry::{Capsule, Cuboid, Masses, Pose, Solid, Vec3};
use crate::hazard::Criteria;
use crate::hazard::criterion::pressure::LinkContact;
use crate::hazard::criterion::separation::Separation;
use crate::human::arm::ArmModel;
use crate::human::floor::Floor;
use crate::human::{Arrangement, Body, ControlKind, ControlledBy, Presses, Repertoire, Start, Who};
use crate::obligations::Acceptance;
use crate::stop::Stop;

/// The leaf of an open door is so deep in the ground, m.
const OUT_OF_THE_WAY_M: f64 = 1e3;

/// A validated cell in SI units and radians.
#[derive(Clone, Debug)]
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
    /// Boxes that are in the way.
    pub obstacles: Vec<Obstacle>,
    /// What follows the FMU's outputs.
    pub following: Following,
    /// Sensors.
    pub sensors: Vec<Sensor>,
    /// For each of them what its safety distance depends on besides.
    pub placings: Vec<Placing>,
    /// What people work.
    pub controls: Vec<Control>,
    /// What of the person's pose goes to the FMU.
    pub pose: Vec<PoseQuantity>,
    /// Where and when the person may begin; each is searched by itself.
    pub beginnings: Vec<InitialCondition>,
    /// Which of them this is about, from 0.
    pub beginning: usize,
    /// The starts of the beginnings of one time, as a cell file gives them: those by themselves, then those of areas.
    pub starts: Vec<StartTable>,
    /// What became of the start areas.
    pub start_areas: Vec<StartArea>,
    /// Corners of the floor that people may be on in a scan from anywhere, floor plan, m, if that is bounded.
    pub floor: Option<Vec<[f64; 2]>>,
    /// Where a scan has people begin that is not told it.
    pub from: Option<PeopleFrom>,
    /// Corners of the floor from which people come in a scan from anywhere, floor plan, m, if that is not the outside.
    pub start_region: Option<Vec<[f64; 2]>>,
    /// The person's start.
    pub start: Start,
    /// The person's body.
    pub body: Body,
    /// How fast hands move, m/s, where arms take their time.
    pub arm_speed_m_s: Option<f64>,
    /// How far what the person holds reaches beyond the finger tips, m; 0 for nothing.
    pub held_m: f64,
    /// What the person does, and a second one beside it.
    pub repertoire: Repertoire,
    /// A second person.
    pub second: Option<SecondPerson>,
    /// What of contacts counts as unsafe.
    pub criteria: Criteria,
    /// How far robots go on after a contact.
    pub clamping: Clamping,
    /// For each link how far it goes on after a contact, m: as stated, or as found out.
    pub travel_after_contact_m: Vec<f64>,
    /// The distance that is kept from robots that move, if that counts.
    pub separation: Option<Separation>,
    /// Budget.
    pub search: SearchTable,
    /// The scan whose hazards are known and do not make another scan fail, relative to the cell file; none if every
    /// hazard does.
    pub baseline: Option<String>,
    /// What can only be tried out, and is accepted.
    pub accepted: Vec<Acceptance>,
    /// The file itself, for binding variables.
    pub file: Arc<CellFile>,
}

/// A box that is in the way.
#[derive(Clone, Debug, PartialEq)]
pub struct Obstacle {
    /// Its name, different for each box of a mesh.
    pub name: String,
    /// Where it stands.
    pub cuboid: Cuboid,
    /// The obstacle of the cell file that says it; none for boxes in a mesh.
    pub table: Option<usize>,
    /// The control that opens it, if it is the leaf of a door.
    pub opened_by: Option<usize>,
    /// Its number in [`Workcell::following`], if it follows the FMU.
    pub follows: Option<usize>,
}

/// A second person in a cell.
#[derive(Clone, Debug)]
pub struct SecondPerson {
    /// What the first and the second person are called.
    pub names: [String; 2],
    /// Where the person begins.
    pub start: Start,
    /// The person's body.
    pub body: Body,
    /// What the person does.
    pub repertoire: Repertoire,
    /// How far what the person holds reaches beyond the finger tips, m; 0 for nothing.
    pub held_m: f64,
}

/// What became of a start area.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StartArea {
    /// Distance of neighbouring places, m.
    pub spacing_m: f64,
    /// How many headings each place has.
    pub headings: usize,
    /// Free places.
    pub places: usize,
    /// Places at which an obstacle is in the way.
    pub left_out: usize,
}

/// Where and when the person begins.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InitialCondition {
    /// Where the person stands and looks.
    pub start: Start,
    /// Communication steps from the FMU's own start until the person begins.
    pub lead_in_steps: usize,
}

impl InitialCondition {
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
    pub kinematics: Option<Arc<Kinematics>>,
    /// Mass of the moving parts `M`, kg.
    pub moving_mass_kg: f64,
    /// Where the cell file says so, or names the URDF that does.
    pub mass_place: FileLine,
}

/// A line of the cell file, or of one that it extends.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct FileLine {
    /// The extended file, seen from the folder of the cell file; none if it is the cell file itself.
    pub base: Option<PathBuf>,
    /// The line, from 1.
    pub line: usize,
}

impl std::fmt::Display for FileLine {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match &self.base {
            None => write!(f, "line {}", self.line),
            Some(base) => write!(f, "line {} of {}", self.line, base.display()),
        }
    }
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
    /// For each joint between which positions it moves by its URDF, rad or m, where that is told.
    pub ranges: Vec<Option<[f64; 2]>>,
    /// How the mass of what moves is spread, where that is told of all of it.
    pub masses: Option<Masses>,
    /// The joint whose moving side carries the payload, and where its centre of mass is in that joint's frame, m.
    pub payload_at: (usize, Vec3),
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
    /// Where the cell file names its joint.
    pub place: FileLine,
    /// What it looks like, where a URDF says so and the shape turns with it: for pictures alone.
    pub looks: Vec<Look>,
    /// What it is like where it touches.
    pub contact: LinkContact,
}

/// How far robots go on after a contact, where clamping counts.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Clamping {
    /// As stated, m.
    pub stated_m: f64,
    /// The FMU input that tells of a contact, by which it is found out.
    pub signal: Option<String>,
}

/// A mesh to look at.
#[derive(Clone, Debug, PartialEq)]
pub struct Look {
    /// The file; relative ones from the working directory.
    pub path: PathBuf,
    /// Factor of each axis.
    pub scale: Vec3,
    /// `shape_from_mesh`: where the mesh is in the frame of the link's shape.
    pub pose: Pose,
}

/// Something that people work.
#[derive(Clone, Debug, PartialEq)]
pub struct Control {
    /// Name used in results.
    pub name: String,
    /// Where a hand works it: whatever is inside; none if it is not told, which is for those that anyone works.
    pub place: Option<Capsule>,
    /// Who works it.
    pub by: ControlledBy,
    /// How.
    pub kind: ControlKind,
    /// Communication steps for which it is pressed in an action.
    pub steps: usize,
    /// Whether it opens a door and closes it again.
    pub door: bool,
}

impl Workcell {
    /// Controls that open and close doors.
    #[must_use]
    pub fn doors(&self) -> Presses {
        let doors = self.controls.iter().enumerate().filter(|(_, control)| control.door);
        doors.fold(Presses::NONE, |doors, (number, _)| doors.and(Presses::one(number)))
    }

    /// What the people are called, where there are two.
    #[must_use]
    pub fn names(&self) -> Option<&[String; 2]> {
        self.second.as_ref().map(|second| &second.names)
    }

    /// Who is called so; nobody, where there is no such name, and the only person, where there is one.
    #[must_use]
    pub fn who(&self, name: Option<&str>) -> Option<Who> {
        match &self.second {
            None => Some(Who::First),
            Some(second) => Who::ALL.into_iter().find(|who| name == Some(second.names[*who as usize].as_str())),
        }
    }

    /// The same cell with its second person alone, if there is one.
    #[must_use]
    pub fn of_second(&self) -> Option<Self> {
        let second = self.second.as_ref()?;
        let SecondPerson { start, body, repertoire, held_m, .. } = second.clone();
        Some(Self { start, body, repertoire, held_m, second: None, ..self.clone() })
    }

    /// How far what the person holds reaches beyond the finger tips, m, if they hold something.
    #[must_use]
    pub fn holds_m(&self) -> Option<f64> {
        Some(self.held_m).filter(|held_m| *held_m > 0.0)
    }

    /// The person's arm, with what it holds.
    #[must_use]
    pub fn arm(&self) -> ArmModel {
        ArmModel::holding(self.held_m)
    }

    /// Where an obstacle is while things stand so that follow the FMU; nothing if it is not there.
    #[must_use]
    pub fn amid(&self, obstacle: &Obstacle, arrangement: Arrangement) -> Option<Cuboid> {
        let Obstacle { cuboid, follows, .. } = obstacle;
        let Some(number) = follows else { return Some(*cuboid) };
        let offset = self.following.offset(*number, arrangement)?;
        Some(Cuboid { centre: cuboid.centre + offset, ..*cuboid })
    }

    /// What is in the way while some doors are open and things stand so that follow the FMU, in the order of the obstacles: each keeps
    /// its number.
    #[must_use]
    pub fn standing(&self, open: Presses, arrangement: Arrangement) -> Vec<Cuboid> {
        let below = |cuboid: &Cuboid| Cuboid { centre: cuboid.centre - Vec3::Z * OUT_OF_THE_WAY_M, ..*cuboid };
        let is_open = |obstacle: &Obstacle| obstacle.opened_by.is_some_and(|control| open.has(control));
        let where_it_is = |obstacle: &Obstacle| match self.amid(obstacle, arrangement) {
            Some(cuboid) if !is_open(obstacle) => cuboid,
            _ => below(&obstacle.cuboid),
        };
        self.obstacles.iter().map(where_it_is).collect()
    }

    /// Communication steps after which arms are anywhere, where they take their time.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some hundred steps at most")]
    pub fn raising_steps(&self) -> Option<usize> {
        let farthest_m = self.arm().farthest_from_hanging_m();
        self.arm_speed_m_s.map(|speed| (farthest_m / (speed * self.step_s)).ceil() as usize)
    }

    /// Whether nothing but the transient force counts as unsafe.
    #[must_use]
    pub fn judges_by_force_alone(&self) -> bool {
        let force = Criteria::default().with_speed(self.criteria.speed());
        self.criteria == force && self.separation.is_none()
    }

    /// A floor that ends where people may not be, and that they enter where they come from; nothing, where there is no time for it.
    #[must_use]
    pub fn bounded(&self, floor: Floor, stop: &Stop) -> Option<Floor> {
        let floor = match &self.floor {
            Some(polygon) => floor.bounded_by(polygon, stop)?,
            None => floor,
        };
        match &self.start_region {
            Some(polygon) => floor.entered_in(polygon, stop),
            None => Some(floor),
        }
    }

    /// Links whose pressure is not known, where that counts: their names, each once.
    #[must_use]
    pub fn links_of_unknown_pressure(&self) -> Vec<&str> {
        let mut names: Vec<&str> = Vec::new();
        let unknown = self.links.iter().filter(|link| self.criteria.pressure && link.contact.surface.is_none());
        for link in unknown {
            if !names.contains(&link.name.as_str()) {
                names.push(&link.name);
            }
        }
        names
    }

    /// The file's tables, for binding variables.
    #[must_use]
    pub fn file(&self) -> &CellFile {
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
    pub fn initial_condition_at(mut self, number: usize) -> Self {
        self.beginning = number;
        self.start = self.beginnings[number].start;
        self
    }
}
