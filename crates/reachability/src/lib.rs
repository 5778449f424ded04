//! Somebody is anywhere, whom no sensor has seen so far, walks in any way, looks anywhere, bends and reaches: can a robot harm
//! them, at any instant of any history of the FMU that this leads to?
//!
//! As long as the sensors report the same, the robots do the same, whoever is where. So there are as many histories as there are
//! histories of readings ([`machine`]), and for each instant of each a set of places ([`reading_regions`]). What remains is a question about sets of
//! poses: a [`PoseBox`] of places and headings, for each posture, is settled when no robot of any instant can be met harmfully
//! from any pose of it, shown by bounds; else its middle is tried, and it is halved. What is neither settled nor hazardous
//! when the halves are small is *open*, and told.
//!
//! Between two instants only bounds are known of a robot. So a history is looked at twice: with links that are as large as what they may
//! sweep around each instant, which settles nearly all, and with the links themselves where that does not. Only they harm anybody.
//!
//! Bounds hold for all of a box because nothing of the body moves farther in it than [`PoseBox::moves_m`] says. Arms are
//! looked at with the tolerance of every arm search and, in the smallest boxes, that much more. Of the body a smallest box is known
//! by its middle: a harm that is gone when the person is moved by [`BODY_TOLERANCE_M`] may be missed, since depth, region and
//! speed of what is touched may all be others then.

mod behind;
mod candidate_poses;
mod controls;
mod delayed;
pub mod held;
mod history_search;
pub mod instants;
pub mod internal_sensors;
pub mod machine;
pub mod of_behaviours;
mod outside;
mod passes;
mod questions;
pub mod reading_regions;
mod readings;
pub mod reduced;
mod shoulders;
pub mod widths;

use std::collections::{BTreeMap, BTreeSet};
use std::f64::consts::{PI, TAU};
use std::sync::atomic::AtomicBool;
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use serde::{Deserialize, Serialize};

use self::behind::SignalledPeople;
use self::history_search::HistorySearch;
use self::internal_sensors::{InternalSensorMap, arc};
use self::outside::Outside;
pub use self::passes::{Histories, InParts, Means};
use self::readings::{may_report, may_stay_clear};
use crate::cell::{Sensor, Workcell};
use crate::geometry::joined::{joined, joined_two, merged};
use crate::geometry::{Cuboid, Vec3};
use crate::hazard::Contact;
use crate::human::ControlledBy;
use crate::human::posture::{cut_back, may_be_cut_back};
use crate::human::{BendFraction, DistanceField, Floor, PlacedBody, PoseBox, Posture, Presses, is_without_room};
use crate::search::behaviours::Number;
use crate::sim::Coverage;
use crate::sim::detection_plane::DetectionPlane;
use crate::sim::encounter::{Encounter, Judge};
use crate::sim::robot::RobotFrame;
use crate::sim::sensors::{self, sees};
use crate::standards::iso_13855::WALKING_SPEED_M_S;
use crate::stop::Stop;

use fmi_hazard_cell::cell;
use fmi_hazard_criteria as hazard;
use fmi_hazard_human::{geometry, human, standards};
use fmi_hazard_search as search;
use fmi_hazard_simulation as sim;
use fmi_hazard_stop as stop;
use fmu_host::host;

/// Edge of a cell of the floor, m, where there are no more than so many of them: 25 m by 25 m.
pub const FLOOR_M: f64 = 0.025;
const MOST_CELLS: f64 = 1e6;
/// Half an edge of the cells in which a hazard is told once, m.
pub const CELL_M: f64 = 0.05;
/// Contacts of trunk, head and legs that are harmless when the person is moved by no more than this may be missed, m.
pub const BODY_TOLERANCE_M: f64 = 0.01;
/// Halves of boxes are made so that what is this far from the axis between the feet moves little, m.
const LEVER_M: f64 = 0.8;

/// The floor is looked at this far around what is on it, m: more than a person is wide.
const AROUND_M: f64 = 0.5;

/// The robots at an instant, and where somebody may be then.
#[derive(Clone, Debug)]
pub struct ReachableInstant {
    /// Communication steps from the start of the FMU to the instant.
    pub step: usize,
    /// For how many of these the readings had lasted when the last one began, 0 for their first sample.
    pub lasting: usize,
    /// The robots.
    pub frame: Arc<RobotFrame>,
    /// No farther than this by the history's two fields, m; finite, as places where nobody can be are infinitely far.
    pub within_m: [f64; 2],
    /// An arm is no deeper than this behind planes that report it, m.
    pub depth_m: f64,
    /// One way in which it came to that, where controls are worked.
    pub story: Arc<StateOrigin>,
    /// The behaviour that the last step began with, where there are few in place of many histories.
    pub came: Option<Number>,
}

/// How it came to a state of the FMU.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct StateOrigin {
    /// The communication step that was the first to begin with other readings than at the start.
    pub changed: Option<usize>,
    /// Controls that were worked, and the step that began with that.
    pub pressed: Vec<(usize, Presses)>,
}

/// What the robots do while the sensors report the same.
#[derive(Clone, Debug)]
pub struct History {
    /// What each sensor reported at the sample before each instant; of those that do not matter nothing.
    pub readings: Vec<Option<bool>>,
    /// Which links count.
    pub links: Arc<[bool]>,
    /// How far it is to places from where somebody was when these readings began, and from where they were never seen.
    pub fields: [Arc<DistanceField>; 2],
    /// Instants at which the robots may harm anybody.
    pub seen: Vec<ReachableInstant>,
}

impl History {
    /// How far it is at least to any place of the square, by both fields.
    fn least(&self, xy_m: [f64; 2], half_m: f64) -> [f64; 2] {
        [0, 1].map(|n| self.fields[n].least(xy_m, half_m))
    }
}

/// A pose in which somebody is harmed.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Harm {
    /// Where they stand, floor plan, m.
    pub xy_m: [f64; 2],
    /// Where they look, from +x towards +y, rad.
    pub heading_rad: f64,
    /// How they bend.
    pub posture: Posture,
    /// Which of the instants of the history.
    pub instant: usize,
    /// Index of the link.
    pub link: usize,
    /// The contact.
    pub contact: Contact,
}

impl Harm {
    /// When and how hard, in its history.
    #[must_use]
    pub fn at(&self, history: &History) -> Moment {
        Moment { xy_m: self.xy_m, step: history.seen[self.instant].step, ratio: self.contact.ratio() }
    }
}

/// Harm at an instant to somebody who is in a pose in which a search found harm.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Moment {
    /// Where they stand, floor plan, m.
    pub xy_m: [f64; 2],
    /// Communication steps from the start of the FMU.
    pub step: usize,
    /// Force over limit.
    pub ratio: f64,
}

/// What came out for one history and what is between its instants.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub struct HistoryOutcome {
    /// Poses in which somebody is harmed: at least one in each cell of the floor in which there is any, but where it is open.
    pub harms: Vec<Harm>,
    /// Middles of the cells of the floor in which some boxes are neither settled nor hazardous, floor plan, m.
    pub open: Vec<[f64; 2]>,
    /// The same of those in which nobody is harmed at any instant, and it is not shown that nobody is between two.
    pub between: Vec<[f64; 2]>,
    /// What comes to people in poses of `harms` at other instants, the worst of each span.
    pub moments: Vec<Moment>,
    /// Whether there was time for all of that.
    pub followed: bool,
    /// Boxes that were looked at, once for each posture.
    pub boxes: u64,
    /// Whether it was told to end.
    pub stopped: bool,
}

impl HistoryOutcome {
    /// Whether nobody is harmed there at all.
    const fn is_settled(&self) -> bool {
        !self.stopped && self.harms.is_empty() && self.open.is_empty()
    }

    /// Of a cell of the floor in which, with what is between instants, somebody may be harmed, where at the instants this is so.
    fn narrowed(self, mut at_instants: Self) -> Self {
        if at_instants.is_settled() {
            at_instants.between = self.harms.iter().map(|harm| harm.xy_m).chain(self.open).collect();
        }
        at_instants.boxes += self.boxes;
        at_instants.stopped |= self.stopped;
        at_instants
    }

    fn add(&mut self, other: Self) {
        self.harms.extend(other.harms);
        self.open.extend(other.open);
        self.between.extend(other.between);
        self.boxes += other.boxes;
        self.stopped |= other.stopped;
    }
}

/// The edge of a cell of a floor of these corners, m: longer ones where there would be too many. Longer ones exclude less.
fn cell_m(wanted_m: f64, (low_m, high_m): ([f64; 2], [f64; 2])) -> f64 {
    let area_m2 = (high_m[0] - low_m[0]) * (high_m[1] - low_m[1]);
    wanted_m.max((area_m2 / MOST_CELLS).sqrt())
}

/// A rectangle, its low corner and its high one, m, with 1 m around the origin, if it is near that, or there is none.
fn with_origin((low_m, high_m): ([f64; 2], [f64; 2])) -> ([f64; 2], [f64; 2]) {
    let is_far = |axis: usize| low_m[axis] > 1.0 || high_m[axis] < -1.0;
    // Who measures in a hall has a cell that is far from the hall's origin.
    if low_m[0] <= high_m[0] && (0..2).any(is_far) {
        return (low_m, high_m);
    }
    (low_m.map(|low| low.min(-1.0)), high_m.map(|high| high.max(1.0)))
}

/// Everything that stays the same over the search.
#[derive(Debug)]
pub struct ReachabilitySearch<'a> {
    cell: &'a Workcell,
    encounter: Encounter,
    curtains: Vec<DetectionPlane>,
    /// Where somebody has room, joined to the outside.
    ground: Floor,
    /// What sensors inside the FMU report there, where it is told where people are.
    told: Option<InternalSensorMap>,
    /// The cells of it that are joined to the outside by others in which no sensor that keeps people out certainly sees them.
    unseen: Vec<bool>,
    /// What is known of each plane: worked out when it is asked for.
    told_of: OnceLock<Vec<SignalledPeople>>,
    /// Held by who works that out.
    asking: Mutex<()>,
    /// By which sensors matter, where people get to by the rules of a scan from the start: worked out when it is asked for.
    outside: Mutex<BTreeMap<Vec<bool>, Arc<Outside>>>,
    /// What the sensors may report in each cell of the floor: worked out when it is asked for.
    by_cell: OnceLock<Vec<BTreeSet<reading_regions::Readings>>>,
    /// How far somebody walks in a communication step, m.
    step_m: f64,
    /// No point of an arm is farther from the point 1 m above the place, m; and none of the rest of the body.
    reach_m: f64,
    body_m: f64,
}

/// Whether sensors can report something of somebody.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MayReport {
    /// Of somebody there, who looks there: floor plan, m, and rad.
    At([f64; 2], f64),
    /// Of nobody.
    Nowhere,
    /// Neither was shown.
    Unknown,
}

impl<'a> ReachabilitySearch<'a> {
    /// For a cell whose robots are never farther from each other, and from the places that matter, than `frames` show; where others are, nothing is left out.
    /// The floor goes on for `around_m` more. Nothing, where there is no time for it.
    #[must_use]
    pub fn new<'b>(
        cell: &'a Workcell,
        frames: impl Iterator<Item = &'b RobotFrame>,
        around_m: f64,
        stop: Stop,
    ) -> Option<Self> {
        Self::on_cells_of(FLOOR_M, cell, frames, around_m, stop)
    }

    /// The same on a floor of cells that are so large: smaller ones exclude more, and cost more.
    #[must_use]
    pub fn on_cells_of<'b>(
        floor_m: f64,
        cell: &'a Workcell,
        frames: impl Iterator<Item = &'b RobotFrame>,
        around_m: f64,
        stop: Stop,
    ) -> Option<Self> {
        // Doors are taken to be open.
        let fixed = cell.obstacles.iter().filter(|obstacle| obstacle.opened_by.is_none());
        let obstacles = merged(&fixed.map(|obstacle| obstacle.cuboid).collect::<Vec<_>>());
        let obstacles = [joined(&obstacles), obstacles].concat();
        let arm = cell.arm();
        let reach_m = cell.body.reach_from_one_metre(arm.reach(), &[]);
        let mut bounds: ([f64; 2], [f64; 2]) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        let mut hold = |at: [f64; 2], far: f64| {
            for (axis, at) in at.into_iter().enumerate() {
                bounds.0[axis] = bounds.0[axis].min(at - far);
                bounds.1[axis] = bounds.1[axis].max(at + far);
            }
        };
        for link in frames.flat_map(|frame| &frame.links) {
            let (centre, radius) = link.bounding_sphere();
            hold([centre.x, centre.y], radius + reach_m + around_m);
        }
        // What keeps people away, or sees them, may be farther out.
        let planes = cell.sensors.iter().filter_map(|sensor| Some(sensor.zone.plane()?.0));
        for cuboid in obstacles.iter().chain(planes) {
            hold([cuboid.centre.x, cuboid.centre.y], cuboid.half.length() + AROUND_M);
        }
        for sensor in &cell.sensors {
            sensor.zone.corners().into_iter().flatten().for_each(|corner| hold(*corner, AROUND_M));
        }
        let in_hand = cell.controls.iter().filter(|control| control.by == ControlledBy::Person);
        for place in in_hand.filter_map(|control| control.place) {
            [place.a, place.b].iter().for_each(|at| hold([at.x, at.y], place.radius + reach_m + AROUND_M));
        }
        let starts = starts(cell);
        if cell.floor.is_some() {
            // Where the floor is bounded, people come from there.
            starts.iter().for_each(|start| hold(*start, AROUND_M));
        }
        let bounds = with_origin(bounds);
        let from = starts.first().map_or(Vec3::ZERO, |[x, y]| Vec3::new(*x, *y, 0.0));
        let curtains = DetectionPlane::all(cell, from, &obstacles);
        let encounter = Encounter {
            number: 0,
            obstacles,
            arm,
            reach_tolerance_m: cell.search.reach_tolerance_m,
            worst: false,
            judge: Judge::Ending,
            clamping: None,
            stop,
        };
        let stop = &encounter.stop;
        let floor =
            cell.bounded(Floor::new(&cell.body, &encounter.obstacles, bounds, cell_m(floor_m, bounds), stop)?, stop)?;
        let ground = floor.joined_to_the_outside(&starts, |_| true, stop)?;
        let mut this = Self {
            cell,
            encounter,
            curtains,
            unseen: Vec::new(),
            told_of: OnceLock::new(),
            asking: Mutex::new(()),
            outside: Mutex::default(),
            by_cell: OnceLock::new(),
            step_m: WALKING_SPEED_M_S * cell.step_s,
            reach_m,
            body_m: cell.body.reach_from_one_metre(0.0, &[]),
            ground,
            told: None,
        };
        this.unseen = this.untold_by(|_| true)?;
        Some(this)
    }

    /// The same with what sensors inside the FMU report of people.
    #[must_use]
    pub fn with(mut self, told: InternalSensorMap) -> Option<Self> {
        self.told = Some(told);
        self.outside = Mutex::default();
        (self.by_cell, self.told_of) = (OnceLock::new(), OnceLock::new());
        self.unseen = self.untold_by(|_| true)?;
        Some(self)
    }

    /// Where somebody has room.
    #[must_use]
    pub const fn floor(&self) -> &Floor {
        &self.ground
    }

    /// Whether it is known what sensors inside the FMU report.
    #[must_use]
    pub const fn is_told(&self) -> bool {
        self.told.is_some()
    }

    /// The cells over which people come who may be seen already, as sensors inside the FMU may see beyond the floor.
    fn entrances(&self) -> Vec<bool> {
        let mut entrances = vec![false; self.ground.cells()];
        if self.told.is_some() {
            self.ground.edge().for_each(|cell| entrances[cell] = self.ground.is_open(cell));
        }
        entrances
    }

    /// What is known of a plane; nothing, where there is no time for it.
    fn told_of(&self, plane: usize) -> Option<&SignalledPeople> {
        if self.told_of.get().is_none() {
            let _alone = self.asking.lock().unwrap_or_else(PoisonError::into_inner);
            if self.told_of.get().is_none() {
                let of_all: Option<_> = self.curtains.iter().map(|curtain| self.tells_of(curtain)).collect();
                let _ = self.told_of.set(of_all?);
            }
        }
        Some(&self.told_of.get()?[plane])
    }

    /// Where people get to of whom some sensors have told nothing.
    fn untold_by(&self, sensors: impl Fn(usize) -> bool) -> Option<Vec<bool>> {
        let may_pass = |cell| self.may_pass_unseen(cell, &sensors);
        let untold = self.ground.clone().joined_to_the_outside(&starts(self.cell), may_pass, &self.encounter.stop)?;
        Some((0..untold.cells()).map(|cell| untold.is_open(cell)).collect())
    }

    /// Whether somebody may be in a cell of the floor with none of some sensors seeing them that keeps people out.
    fn may_pass_unseen(&self, cell: usize, counts: &dyn Fn(usize) -> bool) -> bool {
        let sensors = self.cell.sensors.iter().enumerate();
        let sensors: Vec<_> =
            sensors.filter(|(n, sensor)| counts(*n) && sensor.zone.keeps_out()).map(|(_, sensor)| sensor).collect();
        (0..).zip(headings(internal_sensors::ARCS)).any(|(arc, (heading_rad, half_rad))| {
            let at =
                PoseBox { xy_m: self.ground.middle(cell), half_m: 0.5 * self.ground.cell_m(), heading_rad, half_rad };
            // Who bends may pass below a plane, or above; legs and hips do not bend.
            let body = self.placed(&at, Posture::Upright, BendFraction::FULL);
            let clear = |kind: &[bool]| kind.iter().enumerate().all(|(sensor, told)| !told || !counts(sensor));
            let is_clear = |told: &InternalSensorMap| told.kinds(cell, arc).any(clear);
            sensors.iter().all(|sensor| may_stay_clear(sensor, &self.cell.body, &body, &at))
                && self.told.as_ref().is_none_or(is_clear)
        })
    }

    /// Whether sensors inside the FMU may report this of somebody.
    fn may_be_told(&self, xy_m: [f64; 2], heading_rad: f64, readings: &[Option<bool>]) -> bool {
        let Some(told) = &self.told else { return true };
        let matches = |kind: &[bool]| {
            let sensors = self.cell.sensors.iter().zip(kind).zip(readings);
            sensors
                .into_iter()
                .all(|((sensor, told), reading)| !is_reported(sensor) || reading.is_none_or(|reading| reading == *told))
        };
        self.ground.within(xy_m, 0.0).any(|cell| told.kinds(cell, arc(heading_rad)).any(matches))
    }

    /// Whether nobody has room to stand anywhere in a box.
    fn has_no_room(&self, at: &PoseBox) -> bool {
        is_without_room(&self.cell.body, &self.encounter.obstacles, at)
    }

    fn placed(&self, at: &PoseBox, posture: Posture, bend: BendFraction) -> PlacedBody {
        self.cell.body.placed(at.position(), at.heading_rad, posture, bend)
    }

    /// The floor as cells: where people can be whom no sensor sees that keeps people out, having come there unseen; and where else
    /// people can be.
    #[must_use]
    pub fn ground(&self) -> (&Floor, Vec<bool>, Vec<bool>) {
        let watched = (0..self.ground.cells()).map(|cell| self.ground.is_open(cell) && !self.unseen[cell]);
        (&self.ground, self.unseen.clone(), watched.collect())
    }

    /// Whether it has to end: to be asked wherever many places are looked at.
    #[must_use]
    pub fn is_due(&self) -> bool {
        self.encounter.stop.is_due()
    }

    /// Whether somebody can stand there.
    #[must_use]
    pub fn has_room(&self, xy_m: [f64; 2]) -> bool {
        self.ground.any_open(xy_m, 0.0) && !self.has_no_room(&PoseBox::point(xy_m, 0.0))
    }

    /// Whether somebody may be there at the start, upright, of whom the sensors then report these readings.
    #[must_use]
    pub fn may_begin(&self, xy_m: [f64; 2], heading_rad: f64, readings: &[Option<bool>]) -> bool {
        let beyond = self.cell.start_region.is_none() && !self.ground.holds(xy_m, 0.0);
        (beyond || self.ground.within(xy_m, 0.0).any(|cell| self.unseen[cell]))
            && self.is_possible(xy_m, heading_rad, Posture::Upright, readings)
    }

    /// What the sensors report of somebody there, without arms.
    #[must_use]
    pub fn reports(&self, xy_m: [f64; 2], heading_rad: f64, posture: Posture) -> reading_regions::Readings {
        let position = PoseBox::point(xy_m, heading_rad).position();
        let bend = cut_back(&self.cell.body, position, heading_rad, posture, &self.encounter.obstacles);
        let body = Some(self.placed(&PoseBox::point(xy_m, heading_rad), posture, bend));
        let feet = self.cell.body.feet(position, heading_rad);
        let seen = sensors::SensorTarget { feet, besides: None, body, position, heading_rad };
        self.cell.sensors.iter().map(|sensor| sees(sensor, &seen)).collect()
    }

    /// Whether somebody can stand there while the sensors report these readings.
    #[must_use]
    pub fn is_possible(&self, xy_m: [f64; 2], heading_rad: f64, posture: Posture, readings: &[Option<bool>]) -> bool {
        let at = PoseBox::point(xy_m, heading_rad);
        let position = at.position();
        if !self.has_room(xy_m) || !self.may_be_told(xy_m, heading_rad, readings) {
            return false;
        }
        // Who bends in a plane was upright in it, or comes into it: both are seen.
        let reads = |posture: Posture| {
            let bend = cut_back(&self.cell.body, position, heading_rad, posture, &self.encounter.obstacles);
            let body = Some(self.placed(&at, posture, bend));
            let seen = sensors::SensorTarget {
                feet: self.cell.body.feet(position, heading_rad),
                besides: None,
                body,
                position,
                heading_rad,
            };
            // What a plane reports may be an arm.
            let told = |(sensor, reading): (&Sensor, &Option<bool>)| {
                let is = |reading| (reading && is_plane(sensor)) || sees(sensor, &seen) == reading;
                is_reported(sensor) || reading.is_none_or(is)
            };
            self.cell.sensors.iter().zip(readings).all(told)
        };
        reads(posture) && reads(Posture::Upright)
    }

    /// Whether the sensors may have reported these readings of somebody who is in a box, bends so, and was no more than a step
    /// elsewhere.
    fn may_have_read(&self, at: &PoseBox, posture: Posture, body: &PlacedBody, readings: &[Option<bool>]) -> bool {
        let around = PoseBox { half_m: at.half_m + self.step_m, ..*at };
        let obstacles = &self.encounter.obstacles;
        let may = |(sensor, reading): (&Sensor, &Option<bool>)| {
            let Some(reading) = *reading else { return true };
            if !is_plane(sensor) {
                return may_report(sensor, &self.cell.body, body, &around).be(reading);
            }
            // Where obstacles limit the bend, it may have been another a step elsewhere.
            let is_bent_alike = || {
                let (least, most) = may_be_cut_back(&self.cell.body, &around, posture, obstacles);
                least == most
            };
            reading
                || may_report(sensor, &self.cell.body, body, &around).clear
                || (may_stay_clear(sensor, &self.cell.body, body, &around) && !is_bent_alike())
        };
        self.cell.sensors.iter().zip(readings).all(may)
    }

    /// Whether there is a pose, upright, in which the sensors report these readings.
    #[must_use]
    pub fn somewhere(&self, readings: &[bool]) -> MayReport {
        let cells = (0..self.ground.cells()).filter(|cell| self.unseen[*cell]);
        let first = |cell| PoseBox {
            xy_m: self.ground.middle(cell),
            half_m: 0.5 * self.ground.cell_m(),
            heading_rad: 0.0,
            half_rad: PI,
        };
        let mut pending: Vec<PoseBox> = cells.map(first).collect();
        let mut is_known = true;
        // Runs begin with all doors closed.
        let leaves = self.cell.obstacles.iter().filter(|obstacle| obstacle.opened_by.is_some());
        let leaves: Vec<Cuboid> = leaves.map(|leaf| leaf.cuboid).collect();
        let in_a_leaf = |at: &PoseBox| {
            !leaves.is_empty()
                && is_without_room(&self.cell.body, &leaves, &PoseBox { half_m: 0.0, half_rad: 0.0, ..*at })
        };
        while let Some(at) = pending.pop() {
            let body = self.placed(&at, Posture::Upright, BendFraction::FULL);
            let may = |(sensor, reading): (&_, &bool)| may_report(sensor, &self.cell.body, &body, &at).be(*reading);
            if !self.cell.sensors.iter().zip(readings).all(may) {
                continue;
            }
            let is_possible = self.is_possible(at.xy_m, at.heading_rad, Posture::Upright, &known(readings));
            if is_possible && !in_a_leaf(&at) {
                return MayReport::At(at.xy_m, at.heading_rad);
            }
            if is_smallest(&at) {
                is_known = false;
            } else {
                pending.extend(at.parts(LEVER_M));
            }
        }
        if is_known { MayReport::Nowhere } else { MayReport::Unknown }
    }

    /// Of which of some boxes, each in a posture, it is shown without halving them that nobody is harmed in a history: what a search
    /// rests on.
    #[must_use]
    pub fn settles(&self, history: &History, boxes: &[(PoseBox, Posture)], coverage: &mut Coverage) -> Vec<bool> {
        let end = AtomicBool::new(false);
        let within = HistorySearch::new(self, history, &end);
        boxes.iter().map(|(at, posture)| within.settles(at, *posture, coverage)).collect()
    }

    /// What else than obstacles nobody's arm passes: planes while their sensors are clear, and what they are together with what they
    /// adjoin.
    fn walls(&self, history: &History) -> Vec<Cuboid> {
        let is_clear = |c: &&DetectionPlane| history.readings[c.sensor] == Some(false);
        let planes = self.curtains.iter().filter(is_clear).map(DetectionPlane::unbroken);
        let planes: Vec<Cuboid> = planes.collect();
        let with =
            |plane: &Cuboid| self.encounter.obstacles.iter().filter_map(|o| joined_two(plane, o)).collect::<Vec<_>>();
        let together: Vec<Cuboid> = planes.iter().flat_map(with).collect();
        [planes, together].concat()
    }
}

/// Where people start by the cell file, floor plan, m.
fn starts(cell: &Workcell) -> Vec<[f64; 2]> {
    cell.beginnings.iter().map(|beginning| beginning.start.xy_m()).collect()
}

/// Readings of all sensors, where all matter.
#[must_use]
pub fn known(readings: &[bool]) -> Vec<Option<bool>> {
    readings.iter().copied().map(Some).collect()
}

/// The cell of the floor in which something there is told.
#[must_use]
#[expect(clippy::cast_possible_truncation, reason = "some thousand cells to a side")]
pub fn told_in(xy_m: [f64; 2]) -> [i64; 2] {
    xy_m.map(|at| (at / (2.0 * CELL_M)).floor() as i64)
}

/// All headings as so many arcs: the middle of each, and half of it, rad.
fn headings(count: u32) -> impl Iterator<Item = (f64, f64)> {
    let arc = TAU / f64::from(count);
    (0..count).map(move |number| (f64::from(number) * arc, 0.5 * arc))
}

/// Whether a box is not halved any more.
fn is_smallest(at: &PoseBox) -> bool {
    at.moves_m(LEVER_M) <= BODY_TOLERANCE_M
}

/// Whether a sensor is inside the FMU.
const fn is_reported(sensor: &Sensor) -> bool {
    sensor.zone.is_in_fmu()
}

/// Whether a sensor tells of arms.
const fn is_plane(sensor: &Sensor) -> bool {
    sensor.zone.walked_through().is_some()
}
