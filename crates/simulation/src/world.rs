//! What a scan has without its FMU: the person, the obstacles, the sensors, the contact rules. From these follow where a
//! walk leads, what the sensors then read, and whether a robot can be touched as it stands at some instant.
//!
//! Nothing here changes over a scan, so threads may share it.

mod behind;
mod following;
mod near;
mod passing;
mod people;
mod sensing;
mod through_plane;
mod walking;
mod working;

use std::collections::BTreeSet;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

use super::Coverage;
use super::curtain::Curtain;
use super::encounter::{ArmSpace, Clamping, Encounter, Judge, Person};
use super::robot::RobotFrame;
use super::threads::Memo;
use crate::cell::following::Following;
use crate::cell::{Binding, Workcell};
use crate::geometry::{Cuboid, Vec3};
use crate::hazard::STANDSTILL_M_S;
use crate::hazard::criterion::separation::{Separation, Stop, Stopping};
use crate::hazard::finding::{ArmPose, Through};
use crate::hazard::{Contact, Finding};
use crate::human::arm::ArmModel;
use crate::human::walk::WalkTrace;
use crate::human::{Arrangement, BendFraction, Body, Place, PlacedBody, Posture, Presses, Side, Who, shoulder};
use crate::standards::iso_13855::WALKING_SPEED_M_S;
use crate::stop::Stop as WorkStop;

/// Body and robot farther apart than this are not compared, m: the least distance is then not known either.
const COMPARED_WITHIN_M: f64 = 1.0;

pub use self::people::{Places, Walks};
pub use self::sensing::{Sensed, Sight};
pub use self::through_plane::Asked;
use self::through_plane::Runs;
use self::working::Hands;
pub use self::working::Worked;

/// The person at the end of a communication step, as far as contacts depend on it.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Stance {
    /// Who it is.
    pub who: Who,
    /// Where the person stands.
    pub place: Place,
    /// The bend that is tried.
    pub posture: Posture,
    /// How many sub-steps the person got ahead during the step; backwards less than none.
    pub moved: i8,
    /// For each light curtain, how many samples ago it was first broken; 0 for not at all.
    pub broken: Vec<usize>,
    /// Where arms take their time: for so many steps they have not hung any more. Nothing once they may be anywhere.
    pub raised: Option<usize>,
    /// Whether a hazard by contact came before: then clamping alone is asked for.
    pub struck: bool,
}

/// As if there were one person only, for the first: what was written down of cells without a second one stays known by it.
impl Hash for Stance {
    fn hash<H: Hasher>(&self, state: &mut H) {
        let Self { who, place, posture, moved, broken, raised, struck } = self;
        (place, posture, moved, broken, raised).hash(state);
        if *who != Who::First {
            who.hash(state);
        }
        // The same for what comes behind a hazard by contact.
        if *struck {
            struck.hash(state);
        }
    }
}

impl Stance {
    /// Whether body and arms are the same in both.
    #[must_use]
    pub fn poses_as(&self, other: &Self) -> bool {
        let of = |stance: &Self| (stance.who, stance.place, stance.posture, stance.raised);
        of(self) == of(other)
    }
}

/// An unsafe contact at one instant.
#[derive(Clone, Debug, PartialEq)]
pub struct Hit {
    /// The contact.
    pub contact: Contact,
    /// The arm, if it is one that touches.
    pub arm: Option<ArmPose>,
    /// Programme phase of the robot.
    pub phase: Option<i64>,
    /// Where planes told of the arm: when.
    pub windows: Vec<Window>,
    /// With a hazard by contact, and where clamping counts: the worst clamping at the same instant, which may be another contact.
    pub clamps: Option<Box<Hit>>,
}

impl Hit {
    fn new((contact, arm): (Contact, Option<ArmPose>), frame: &RobotFrame) -> Self {
        Self { phase: frame.phase(contact.link), contact, arm, windows: Vec::new(), clamps: None }
    }
}

/// The robots after each step of an action.
pub type Frames = Arc<[Arc<RobotFrame>]>;

/// The samples, counted back from an instant, in which a plane told of an arm: from the `from`th last sample on, until the
/// `until`th last, which is not one of them any more. None if the two are equal.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Window {
    /// The plane, by its place in the list of planes.
    pub curtain: usize,
    /// Samples before the instant, that one included.
    pub from: usize,
    /// Samples before the instant, that one not included.
    pub until: usize,
}

/// Something of the run in which planes told of an arm besides.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum HadTold<T> {
    /// This is it.
    Is(T),
    /// There is no such run: the windows begin before the start of time.
    BeforeTime,
    /// The FMU could not finish it: what an arm meets in it is not known.
    Unfinished,
}

impl<T> HadTold<T> {
    /// The same of something that follows from it.
    pub fn map<U>(self, with: impl FnOnce(T) -> U) -> HadTold<U> {
        match self {
            Self::Is(it) => HadTold::Is(with(it)),
            Self::BeforeTime => HadTold::BeforeTime,
            Self::Unfinished => HadTold::Unfinished,
        }
    }
}

/// Tells the robots' motion as it would be at the same instant had planes told of an arm in some windows, each of another
/// plane.
pub trait Earlier {
    /// Why it cannot be told.
    type Error;

    /// The frames of the whole action.
    ///
    /// # Errors
    /// When the FMU fails.
    fn told_of(&mut self, windows: &[Window]) -> Result<HadTold<Frames>, Self::Error>;

    /// What a stop takes that is commanded at the instant; nothing where that does not matter.
    ///
    /// # Errors
    /// When the FMU fails.
    fn stopping(&mut self) -> Result<Option<Arc<Stopping>>, Self::Error> {
        Ok(None)
    }
}

/// The robots after step `i` of an action, and what there is to know of them.
pub struct Instant<'a, E> {
    /// After each step of the action.
    pub frames: &'a Frames,
    /// Number of the step in its action.
    pub i: usize,
    /// As they would be had planes told of an arm.
    pub earlier: E,
}

impl<E> Instant<'_, E> {
    fn frame(&self) -> &RobotFrame {
        &self.frames[self.i]
    }
}

/// See the module's text.
#[derive(Debug)]
pub struct World {
    /// The cell.
    pub cell: Arc<Workcell>,
    /// Its variables.
    pub binding: Arc<Binding>,
    /// Person against robot while some doors are open, by the number of their set; one where there are no doors. Each for all
    /// arrangements of obstacles that follow the FMU; one where none does.
    encounters: Vec<Encounter>,
    /// Controls that open and close doors.
    doors: Presses,
    /// Obstacles that follow the FMU, each with all its boxes.
    moving_obstacles: Vec<Vec<usize>>,
    /// How things stand that follow the FMU, but for those that stand on the person.
    beside: Memo<Place, Arrangement>,
    /// Light curtains, doors, two-hand controls.
    pub curtains: Vec<Curtain>,
    /// Those of which an arm may pass two at once.
    pub neighbours: Vec<(usize, usize)>,
    /// No part of the body but the arms is farther from the point 1 m above the place where it stands, m.
    body_reach_m: f64,
    /// The same of the arms too.
    reach_m: f64,
    /// How far bends get.
    bends: Memo<(Place, Posture), BendFraction>,
    /// Whether there is room for a posture.
    fits: Memo<(Place, Posture), bool>,
    /// Hands that get to controls.
    reached: Memo<(Place, Posture, usize), Hands>,
    /// The same with moving contacts as what is looked for, where they count.
    moving: Option<Box<World>>,
    /// The same with clamping alone as what is looked for, where it counts: a hazard by contact does not end a sequence for it.
    clamping: Option<Box<World>>,
    /// The same for the second person, if there is one.
    second: Option<Box<World>>,
    /// What stops the robots, where separation counts.
    pub(super) stop_command: Option<Command>,
}

/// An input of the FMU that is set to a value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Command {
    /// Its column.
    pub(super) column: usize,
    /// The value.
    pub(super) value: f64,
    /// So many steps after there is reason to: the response time of a sensor that sets it.
    pub(super) delay_steps: usize,
}

impl World {
    /// What follows from a cell and its variables.
    #[must_use]
    pub fn new(cell: Arc<Workcell>, binding: Arc<Binding>) -> Self {
        let moving = cell.criteria.moving_contact_m_s.map(|limit_m_s| {
            let judge = Judge::Moving(limit_m_s.max(STANDSTILL_M_S));
            Box::new(Self::looking_for(Arc::clone(&cell), Arc::clone(&binding), judge))
        });
        let clamping = cell
            .criteria
            .clamping
            .then(|| Box::new(Self::looking_for(Arc::clone(&cell), Arc::clone(&binding), Judge::Clamping)));
        let second = cell.of_second().map(|cell| Box::new(Self::new(Arc::new(cell), Arc::clone(&binding))));
        Self { moving, clamping, second, ..Self::looking_for(cell, binding, Judge::Ending) }
    }

    fn looking_for(cell: Arc<Workcell>, binding: Arc<Binding>, judge: Judge) -> Self {
        let doors = cell.doors();
        let sets = Presses::all(if doors.is_none() { 0 } else { cell.controls.len() });
        let arrangements = cell.following.of_obstacles();
        let sets = sets.flat_map(|open| (0..arrangements).map(move |number| (open, Following::numbered(number))));
        let with_open = |(number, (open, arrangement)): (usize, (Presses, Arrangement))| Encounter {
            number,
            obstacles: cell.standing(open, arrangement),
            arm: cell.arm(),
            reach_tolerance_m: cell.search.reach_tolerance_m,
            worst: true,
            judge,
            clamping: (cell.criteria.clamping && !matches!(judge, Judge::Moving(_)))
                .then(|| Clamping { travel_m: cell.travel_after_contact_m.clone() }),
            stop: WorkStop::default(),
        };
        let encounters: Vec<Encounter> = sets.enumerate().map(with_open).collect();
        let [body_reach_m, reach_m] =
            [0.0, cell.arm().reach()].map(|arm_m| cell.body.reach_from_one_metre(arm_m, cell.repertoire.low()));
        let stop_command = match &cell.separation {
            Some(Separation { stop: Stop::Measured(name), .. }) => {
                let sensor = cell.sensors.iter().find(|sensor| sensor.name == *name);
                let delay_steps = sensor.map_or(0, |sensor| sensor.delay_steps);
                binding.command(&cell, name).map(|(column, value)| Command { column, value, delay_steps })
            }
            _ => None,
        };
        let (curtains, neighbours) = (Vec::new(), Vec::new());
        let boxes_of = |follower: usize| {
            let boxes = cell.obstacles.iter().enumerate().filter(|(_, obstacle)| obstacle.follows == Some(follower));
            boxes.map(|(number, _)| number).collect()
        };
        let followers: BTreeSet<usize> = cell.obstacles.iter().filter_map(|obstacle| obstacle.follows).collect();
        let moving_obstacles = followers.into_iter().map(boxes_of).collect();
        let mut world = Self {
            cell,
            binding,
            encounters,
            doors,
            moving_obstacles,
            beside: Memo::new(),
            curtains,
            neighbours,
            body_reach_m,
            reach_m,
            bends: Memo::new(),
            fits: Memo::new(),
            reached: Memo::new(),
            moving: None,
            clamping: None,
            second: None,
            stop_command,
        };
        let start = world.start();
        world.curtains = Curtain::all(&world.cell, world.position(&start), world.boxes(&start));
        let (curtains, reach) = (&world.curtains, world.arm().reach());
        let pairs = (0..curtains.len()).flat_map(|c| (c + 1..curtains.len()).map(move |d| (c, d)));
        world.neighbours = pairs.filter(|&(c, d)| curtains[c].apart_m(&curtains[d]) < reach).collect();
        world
    }

    /// The same, but its searches end when `stop` says so: then what they find says nothing.
    #[must_use]
    pub fn heeding(mut self, stop: WorkStop) -> Self {
        self.moving = self.moving.map(|moving| Box::new(moving.heeding(stop.clone())));
        self.clamping = self.clamping.map(|clamping| Box::new(clamping.heeding(stop.clone())));
        self.second = self.second.map(|second| Box::new(second.heeding(stop.clone())));
        for encounter in &mut self.encounters {
            encounter.stop = stop.clone();
        }
        self
    }

    /// Person against robot while the doors, and what follows the FMU, are as they are at a place; but for what stands on the person.
    pub(super) fn encounter(&self, place: &Place) -> &Encounter {
        &self.encounters[self.number(place, self.beside(place))]
    }

    /// The number of the encounter while the doors are as they are at a place, and what follows the FMU stands so.
    fn number(&self, place: &Place, arrangement: Arrangement) -> usize {
        let following = &self.cell.following;
        let open = if self.doors.is_none() { 0 } else { place.open().index() };
        open * following.of_obstacles() + following.standing(arrangement)
    }

    /// What is in the way of arms and bends at a place.
    fn boxes(&self, place: &Place) -> &[Cuboid] {
        &self.encounter(place).obstacles
    }

    /// The arms.
    fn arm(&self) -> &ArmModel {
        &self.encounters[0].arm
    }

    /// When searches have to end.
    pub fn stop(&self) -> &WorkStop {
        &self.encounters[0].stop
    }

    /// The same, but where there is an unsafe arm contact any such is told, not the worst: whether there is one, is the
    /// same, and much sooner known. What comes behind a hazard by contact is not looked for.
    #[must_use]
    pub fn content_with_any(mut self) -> Self {
        for encounter in &mut self.encounters {
            encounter.worst = false;
        }
        self.moving = self.moving.map(|moving| Box::new(moving.content_with_any()));
        self.clamping = None;
        self.second = self.second.map(|second| Box::new(second.content_with_any()));
        self
    }

    /// The body.
    fn body(&self) -> &Body {
        &self.cell.body
    }

    /// Length of a sub-step, m.
    fn sub_step_m(&self) -> f64 {
        WALKING_SPEED_M_S * self.cell.step_s
    }

    /// Where a place is, floor plan, m.
    #[must_use]
    pub fn position(&self, place: &Place) -> Vec3 {
        place.position(&self.cell.start, self.sub_step_m())
    }

    /// Where the person begins.
    #[must_use]
    pub const fn start(&self) -> Place {
        Place::START
    }

    /// The body in the world.
    #[must_use]
    pub fn body_of(&self, stance: &Stance) -> PlacedBody {
        self.of_stance(stance).person(stance).body
    }

    /// One of the people after step `i` of an action that so many actions come before and that leads them along this way.
    #[must_use]
    pub fn stance(
        &self,
        (who, walked): (Who, &WalkTrace),
        (before, i): (usize, usize),
        posture: Posture,
        sensed: &Sensed,
    ) -> Stance {
        let (place, broken) = (walked.places[i], sensed.broken[i].clone());
        let raised = self.raised(before * self.cell.steps_per_action + i + 1);
        Stance { who, place, posture, moved: Self::moved(walked, i), broken, raised, struck: false }
    }

    /// So many steps, as long as arms cannot be anywhere after them.
    fn raised(&self, steps: usize) -> Option<usize> {
        let farthest_m = self.arm().farthest_from_hanging_m();
        self.wrists_m(steps).filter(|far_m| *far_m < farthest_m).map(|_| steps)
    }

    /// How far wrists get in so many steps, m, where arms take their time.
    #[expect(clippy::cast_precision_loss, reason = "some hundred steps")]
    fn wrists_m(&self, steps: usize) -> Option<f64> {
        Some(self.cell.arm_speed_m_s? * steps as f64 * self.cell.step_s)
    }

    /// The unsafe contact of a person with the robots after step `i` of an action, if there is one; of somebody who met a hazard by
    /// contact before, the clamping.
    ///
    /// # Errors
    /// What `earlier` reports; it is asked only where there are light curtains.
    pub fn contact<E: Earlier>(
        &self,
        stance: &Stance,
        frames: &Frames,
        i: usize,
        earlier: &mut E,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        let own = self.of_stance(stance);
        if !std::ptr::eq(own, self) {
            return own.contact(stance, frames, i, earlier, coverage);
        }
        coverage.contact_checks += 1;
        let near = self.near(&stance.place, &frames[i]);
        if !near && (self.cell.separation.is_none() || stance.struck) {
            return Ok(None);
        }
        let person = self.person(stance);
        if stance.struck {
            return self.clamping_near(&person, stance, (frames, i), earlier, coverage);
        }
        if near && let Some(hit) = self.contact_near(&person, stance, (frames, i), true, earlier, coverage)? {
            let clamps = self.clamping_near(&person, stance, (frames, i), earlier, coverage)?;
            return Ok(Some(Hit { clamps: clamps.map(Box::new), ..hit }));
        }
        self.passing(&person, stance, (frames, i), earlier, coverage)
    }

    /// The same for one stance and several instants, each with its own robots. One search often settles many of them.
    /// `posed` keeps the person for the next stance of the same place and posture.
    ///
    /// # Errors
    /// What `earlier` reports; it is asked only where there are light curtains.
    pub fn contacts<E: Earlier>(
        &self,
        stance: &Stance,
        posed: &mut Option<Person>,
        instants: &mut [Instant<'_, E>],
        coverage: &mut Coverage,
    ) -> Result<Vec<Option<Hit>>, E::Error> {
        let own = self.of_stance(stance);
        if !std::ptr::eq(own, self) {
            return own.contacts(stance, posed, instants, coverage);
        }
        if stance.struck {
            return self.clampings(stance, posed, instants, coverage);
        }
        let mut hits = self.ending_contacts(stance, posed, instants, coverage)?;
        self.with_clampings(stance, posed, instants, &mut hits, coverage)?;
        if self.moving.is_none() && self.cell.separation.is_none() {
            return Ok(hits);
        }
        let person = posed.take().unwrap_or_else(|| self.person(stance));
        let person = Person { velocity: self.velocity(stance), ..person };
        for (hit, instant) in hits.iter_mut().zip(instants).filter(|(hit, _)| hit.is_none()) {
            let Instant { frames, i, earlier } = instant;
            *hit = self.passing(&person, stance, (frames, *i), earlier, coverage)?;
        }
        *posed = Some(person);
        Ok(hits)
    }

    /// Those that end an action.
    fn ending_contacts<E: Earlier>(
        &self,
        stance: &Stance,
        posed: &mut Option<Person>,
        instants: &mut [Instant<'_, E>],
        coverage: &mut Coverage,
    ) -> Result<Vec<Option<Hit>>, E::Error> {
        let mut hits = vec![None; instants.len()];
        let near = |n: &usize| self.near(&stance.place, instants[*n].frame());
        let near: Vec<usize> = (0..instants.len()).filter(near).collect();
        coverage.contact_checks += instants.len() as u64;
        if near.is_empty() {
            return Ok(hits);
        }
        let mut person = posed.take().unwrap_or_else(|| self.person(stance));
        person.velocity = self.velocity(stance);
        let person = &*posed.insert(person);
        if !self.curtains.is_empty() {
            self.contacts_at_planes(person, stance, instants, &mut hits, coverage)?;
            return Ok(hits);
        }
        let mut groups: Vec<&[usize]> = vec![&near];
        while let Some(group) = groups.pop() {
            let frames: Vec<&RobotFrame> = group.iter().map(|&n| instants[n].frame()).collect();
            let encounter = self.encounter(&stance.place);
            let harmless = group.len() > 1 && encounter.no_arm_harmed(person, &frames, &ArmSpace::OPEN, coverage);
            if group.len() > 1 && !harmless {
                let (first, second) = group.split_at(group.len() / 2);
                groups.extend([second, first]);
                continue;
            }
            for &n in group {
                let Instant { frames, i, earlier } = &mut instants[n];
                hits[n] = self.contact_near(person, stance, (frames, *i), !harmless, earlier, coverage)?;
            }
        }
        Ok(hits)
    }

    /// The same at planes: what arms can do there follows from the stance, so one search asks for the robots of many
    /// instants, each with those that there would be had a plane told of an arm.
    fn contacts_at_planes<E: Earlier>(
        &self,
        person: &Person,
        stance: &Stance,
        instants: &mut [Instant<'_, E>],
        hits: &mut [Option<Hit>],
        coverage: &mut Coverage,
    ) -> Result<(), E::Error> {
        let at = self.at_planes(person, stance);
        let mut open: Vec<(usize, Runs)> = Vec::new();
        for (n, instant) in instants.iter_mut().enumerate() {
            hits[n] = self.body_hit(person, stance, instant.frame(), coverage);
            if hits[n].is_none() {
                open.push((n, Runs::all(&at, (instant.frames, instant.i), &mut instant.earlier)?));
            }
        }
        let mut groups: Vec<&mut [(usize, Runs)]> = vec![&mut open];
        while let Some(group) = groups.pop() {
            match group {
                [] => {}
                [(n, runs)] => {
                    let Instant { frames, i, earlier, .. } = &mut instants[*n];
                    hits[*n] = self.reach_past_planes(&at, (frames, *i), runs, earlier, coverage)?;
                }
                _ => {
                    let runs: Vec<&Runs> = group.iter().map(|(_, runs)| runs).collect();
                    if !self.none_reaches_past_planes(&at, &runs, coverage) {
                        let (first, second) = group.split_at_mut(group.len() / 2);
                        groups.extend([second, first]);
                    }
                }
            }
        }
        Ok(())
    }

    /// The unsafe contact of trunk, head or legs, if there is one.
    fn body_hit(&self, person: &Person, stance: &Stance, frame: &RobotFrame, coverage: &mut Coverage) -> Option<Hit> {
        let counts = |contact: &Contact| self.in_time(contact.on_robot, person, stance);
        let contact = self.encounter(&stance.place).unsafe_body_contact(person, frame, counts, coverage)?;
        Some(Hit::new((contact, None), frame))
    }

    fn contact_near<E: Earlier>(
        &self,
        person: &Person,
        stance: &Stance,
        (frames, i): (&Frames, usize),
        arms: bool,
        earlier: &mut E,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        let frame = &frames[i];
        let hit = self.body_hit(person, stance, frame, coverage);
        if hit.is_some() || !arms {
            return Ok(hit);
        }
        if self.curtains.is_empty() {
            let found = self.encounter(&stance.place).unsafe_arm_contact(person, frame, &ArmSpace::OPEN, coverage);
            return Ok(found.map(|found| Hit::new(found, frame)));
        }
        let at = self.at_planes(person, stance);
        self.reach_past_planes(&at, (frames, i), &mut Runs::new(&at), earlier, coverage)
    }

    /// What is recorded of a hit after step `i` of the last of `taken` actions.
    #[must_use]
    pub fn finding(
        &self,
        hit: &Hit,
        stance: &Stance,
        readings: &[bool],
        frame: &RobotFrame,
        (taken, i): (usize, usize),
    ) -> Option<Finding> {
        let own = self.of_stance(stance);
        let mut readings = readings.to_vec();
        for window in &hit.windows {
            // What the last sample but `delay` told takes effect in this step.
            let sensor = self.curtains[window.curtain].sensor;
            let (delay, latched) = (self.cell.sensors[sensor].delay_steps, self.cell.sensors[sensor].latched);
            readings[sensor] |= window.from > delay && (window.until <= delay || latched);
        }
        #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
        let seconds = |samples: usize| samples as f64 * self.cell.step_s;
        let through = |window: &Window| Through {
            sensor: self.curtains[window.curtain].sensor,
            // The first sample that told of it was taken up to a step after it was broken.
            since_s: seconds(window.from + 1),
            until_s: seconds(window.until),
        };
        let step = (taken - 1) * self.cell.steps_per_action + i + 1;
        #[expect(clippy::cast_precision_loss, reason = "at most 64 000 steps")]
        let time_s = step as f64 * self.cell.step_s;
        Some(Finding {
            class: hit.contact.class()?,
            contact: hit.contact,
            actions: Vec::new(),
            step,
            time_s,
            who: stance.who,
            person: own.position(&stance.place),
            heading_rad: stance.place.heading_rad(&own.cell.start),
            bend_sixteenths: own.bend(&stance.place, stance.posture).sixteenths(),
            arm: hit.arm,
            sensors: (0..self.cell.sensors.len()).map(|s| self.reading(s, &readings, frame)).collect(),
            phase: hit.phase,
            through: hit.windows.iter().map(through).collect(),
        })
    }

    /// Whether any part of the person could touch the robot, or come so near that the distance is worth knowing.
    pub fn near(&self, place: &Place, frame: &RobotFrame) -> bool {
        // A robot that a light curtain would have stopped may be elsewhere.
        if !self.curtains.is_empty() {
            return true;
        }
        let centre = self.position(place) + Vec3::Z;
        let reach = self.reach_m();
        frame.links.iter().any(|l| {
            let (c, r) = l.bounding_sphere();
            (c - centre).length() - r - reach <= COMPARED_WITHIN_M
        })
    }

    /// No part of the person is farther from the point 1 m above the place where it stands, m.
    pub const fn reach_m(&self) -> f64 {
        self.reach_m
    }

    /// The body and its arms.
    pub(super) fn person(&self, stance: &Stance) -> Person {
        let Stance { place, posture, .. } = stance;
        let (at, heading) = (self.position(place), place.heading_rad(&self.cell.start));
        let body = self.body().placed(at, heading, *posture, self.bend(place, *posture));
        let arms = Side::BOTH.into_iter().filter(|&s| shoulder::is_available(&body, s, self.boxes(place))).collect();
        let wrists_m = stance.raised.and_then(|steps| self.wrists_m(steps));
        Person { body, arms, velocity: self.velocity(stance), wrists_m }
    }

    /// Walls that arms do not pass because that would break a light curtain, by curtain.
    pub(super) fn unbroken(&self) -> Vec<Cuboid> {
        self.curtains.iter().map(Curtain::unbroken).collect()
    }
}
