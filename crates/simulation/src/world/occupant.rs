//! One of the people, and the cell as it is for them: with their start, their body and arms, and what they can do.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::operating::Hands;
use super::{InputTrace, PersonState};
use crate::cell::following::Following;
use crate::cell::{Binding, Workcell};
use crate::detection_plane::DetectionPlane;
use crate::encounter::{Clamping, Encounter, Judge, Person};
use crate::geometry::{Cuboid, Vec3};
use crate::hazard::STANDSTILL_M_S;
use crate::human::arm::ArmModel;
use crate::human::walk::WalkTrace;
use crate::human::{Arrangement, BendFraction, Body, Place, PlacedBody, Posture, Presses, Side, Who, shoulder};
use crate::robot::RobotFrame;
use crate::standards::iso_13855::WALKING_SPEED_M_S;
use crate::stop::Stop;
use crate::threads::Memo;

/// Body and robot farther apart than this are not compared, m: the least distance is then not known either.
const COMPARED_WITHIN_M: f64 = 1.0;

/// See the module's text.
#[derive(Debug)]
pub struct Occupant {
    /// Who of the people it is.
    pub who: Who,
    /// The cell, with this one as its person.
    pub cell: Arc<Workcell>,
    /// Its variables.
    pub binding: Arc<Binding>,
    /// Person against robot while some doors are open, by the number of their set; one where there are no doors. Each for all
    /// arrangements of obstacles that follow the FMU; one where none does.
    encounters: Vec<Encounter>,
    /// The same with moving contacts as what is looked for, where they count.
    pub(super) moving: Option<Vec<Encounter>>,
    /// The same with clamping alone as what is looked for, where it counts: a hazard by contact does not end a sequence for it.
    pub(super) clamping: Option<Vec<Encounter>>,
    /// Controls that open and close doors.
    pub(super) doors: Presses,
    /// Obstacles that follow the FMU, each with all its boxes.
    pub(super) moving_obstacles: Vec<Vec<usize>>,
    /// How things stand that follow the FMU, but for those that stand on the person.
    pub(super) beside: Memo<Place, Arrangement>,
    /// Light curtains, doors, two-hand controls.
    pub curtains: Vec<DetectionPlane>,
    /// Those of which an arm may pass two at once.
    pub neighbours: Vec<(usize, usize)>,
    /// No part of the body but the arms is farther from the point 1 m above the place where it stands, m.
    pub(super) body_reach_m: f64,
    /// The same of the arms too.
    reach_m: f64,
    /// How far bends get.
    pub(super) bends: Memo<(Place, Posture), BendFraction>,
    /// Whether there is room for a posture.
    pub(super) fits: Memo<(Place, Posture), bool>,
    /// Hands that get to controls.
    pub(super) reached: Memo<(Place, Posture, usize), Hands>,
}

impl Occupant {
    pub(super) fn new(who: Who, cell: Arc<Workcell>, binding: Arc<Binding>) -> Self {
        let moving = cell.criteria.moving_contact_m_s.map(|limit_m_s| Judge::Moving(limit_m_s.max(STANDSTILL_M_S)));
        let clamping = cell.criteria.clamping.then_some(Judge::Clamping);
        let [body_reach_m, reach_m] =
            [0.0, cell.arm().reach()].map(|arm_m| cell.body.reach_from_one_metre(arm_m, cell.repertoire.low()));
        let boxes_of = |follower: usize| {
            let boxes = cell.obstacles.iter().enumerate().filter(|(_, obstacle)| obstacle.follows == Some(follower));
            boxes.map(|(number, _)| number).collect()
        };
        let followers: BTreeSet<usize> = cell.obstacles.iter().filter_map(|obstacle| obstacle.follows).collect();
        let mut own = Self {
            who,
            encounters: encounters(&cell, Judge::Ending),
            moving: moving.map(|judge| encounters(&cell, judge)),
            clamping: clamping.map(|judge| encounters(&cell, judge)),
            doors: cell.doors(),
            moving_obstacles: followers.into_iter().map(boxes_of).collect(),
            beside: Memo::new(),
            curtains: Vec::new(),
            neighbours: Vec::new(),
            body_reach_m,
            reach_m,
            bends: Memo::new(),
            fits: Memo::new(),
            reached: Memo::new(),
            cell,
            binding,
        };
        let start = own.start();
        own.curtains = DetectionPlane::all(&own.cell, own.position(&start), own.boxes(&start));
        let (curtains, reach) = (&own.curtains, own.arm().reach());
        let pairs = (0..curtains.len()).flat_map(|c| (c + 1..curtains.len()).map(move |d| (c, d)));
        own.neighbours = pairs.filter(|&(c, d)| curtains[c].apart_m(&curtains[d]) < reach).collect();
        own
    }

    /// All encounters, whatever is looked for in them.
    fn all_encounters(&mut self) -> impl Iterator<Item = &mut Encounter> {
        let besides = [&mut self.moving, &mut self.clamping].into_iter().flatten().flatten();
        self.encounters.iter_mut().chain(besides)
    }

    /// See [`World::heeding`](super::World::heeding).
    pub(super) fn heeding(mut self, stop: &Stop) -> Self {
        self.all_encounters().for_each(|encounter| encounter.stop = stop.clone());
        self
    }

    /// See [`World::content_with_any`](super::World::content_with_any).
    pub(super) fn content_with_any(mut self) -> Self {
        self.clamping = None;
        self.all_encounters().for_each(|encounter| encounter.worst = false);
        self
    }

    /// Person against robot while the doors, and what follows the FMU, are as they are at a place; but for what stands on the person.
    pub(crate) fn encounter(&self, place: &Place) -> &Encounter {
        self.among(&self.encounters, place)
    }

    /// The same among those in which something is looked for.
    pub(super) fn among<'a>(&self, encounters: &'a [Encounter], place: &Place) -> &'a Encounter {
        &encounters[self.number(place, self.beside(place))]
    }

    /// The number of the encounter while the doors are as they are at a place, and what follows the FMU stands so.
    fn number(&self, place: &Place, arrangement: Arrangement) -> usize {
        let following = &self.cell.following;
        let open = if self.doors.is_none() { 0 } else { place.open().index() };
        open * following.of_obstacles() + following.standing(arrangement)
    }

    /// What is in the way of arms and bends at a place.
    pub(super) fn boxes(&self, place: &Place) -> &[Cuboid] {
        &self.encounter(place).obstacles
    }

    /// What is in the way of who walks at a place.
    pub(super) fn in_the_way(&self, place: &Place) -> &[Cuboid] {
        &self.encounters[self.number(place, place.arrangement())].obstacles
    }

    /// The arms.
    pub(super) fn arm(&self) -> &ArmModel {
        &self.encounters[0].arm
    }

    /// When searches have to end.
    pub(super) fn stop(&self) -> &Stop {
        &self.encounters[0].stop
    }

    /// The body.
    pub(super) fn body(&self) -> &Body {
        &self.cell.body
    }

    /// Length of a sub-step, m.
    pub(super) fn sub_step_m(&self) -> f64 {
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
    pub fn body_of(&self, stance: &PersonState) -> PlacedBody {
        self.person(stance).body
    }

    /// The person after step `i` of an action that so many actions come before and that leads along this way.
    #[must_use]
    pub fn stance(
        &self,
        walked: &WalkTrace,
        (before, i): (usize, usize),
        posture: Posture,
        sensed: &InputTrace,
    ) -> PersonState {
        let (place, broken) = (walked.places[i], sensed.broken[i].clone());
        let raised = self.raised(before * self.cell.steps_per_action + i + 1);
        PersonState { who: self.who, place, posture, moved: Self::moved(walked, i), broken, raised, struck: false }
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
    pub(crate) fn person(&self, stance: &PersonState) -> Person {
        let PersonState { place, posture, .. } = stance;
        let (at, heading) = (self.position(place), place.heading_rad(&self.cell.start));
        let body = self.body().placed(at, heading, *posture, self.bend(place, *posture));
        let arms = Side::BOTH.into_iter().filter(|&s| shoulder::is_available(&body, s, self.boxes(place))).collect();
        let wrists_m = stance.raised.and_then(|steps| self.wrists_m(steps));
        Person { body, arms, velocity: self.velocity(stance), wrists_m }
    }

    /// Walls that arms do not pass because that would break a light curtain, by curtain.
    pub(crate) fn unbroken(&self) -> Vec<Cuboid> {
        self.curtains.iter().map(DetectionPlane::unbroken).collect()
    }
}

/// Person against robot with something as what is looked for, by their numbers.
fn encounters(cell: &Workcell, judge: Judge) -> Vec<Encounter> {
    let sets = Presses::all(if cell.doors().is_none() { 0 } else { cell.controls.len() });
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
        stop: Stop::default(),
    };
    sets.enumerate().map(with_open).collect()
}
