//! Who gets a hand to which control, and what the FMU is told while it is worked.
//!
//! A hand works a control at the beginning of an action: from where the person then stands, turned and bent as the action has it, past
//! the obstacles, by an arm search of its own. A person has two hands, so two controls at most, each by another hand; of more the first
//! that can be worked together are, doors before all others. Two people have four hands. A press out of reach does nothing.
//!
//! A control that opens and closes a door moves its leaf as the action begins. It does not close on somebody who stands in the way.
//! Through a doorway whose door moves in the same action a hand works only what it gets to before and after: nobody reaches where a door
//! closes on the arm, nor where it has still to open.
//!
//! Nobody reaches through a light curtain or a door unseen: where that is the only way, its sensor sees the arm for as long as the
//! control is worked.

use std::ops::Range;

use super::{Occupant, World};
use crate::geometry::distance::point_segment;
use crate::geometry::kinematics::Neighbourhood;
use crate::geometry::{Capsule, Cuboid, Solid, Vec3};
use crate::human::arm::ArmModel;
use crate::human::reach::{ArmSegment, ContactScore, ReachQuery, reach};
use crate::human::walk::{WalkTrace, Walker};
use crate::human::{Action, ControlKind, ControlledBy, Place, PlacedBody, Posture, Presses, Side, Who, shoulder};

/// Boxes of joint angles after which a hand is taken to get there.
const WORK_LIMIT: u32 = 200_000;

/// Planes of which an arm may pass some to a control are told apart in a word of so many bits.
const MOST_PLANES: usize = 64;

/// The left and the right hand: if it gets to a control, the planes that it has to pass, a bit each.
pub(super) type Hands = [Option<u64>; 2];

/// Controls that are really worked in an action.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct OperatedControls {
    /// Which.
    pub presses: Presses,
    /// For each control the planes that an arm is in on the way to it, a bit each.
    through: [u64; Presses::MOST],
}

/// A hand on a control, and nothing else.
struct OnControl;

impl ContactScore for OnControl {
    fn upper_bound(&self, segment: ArmSegment, _: usize) -> f64 {
        f64::from(u8::from(segment == ArmSegment::Hand))
    }

    fn upper_bound_near(&self, segment: ArmSegment, link: usize, _: &Neighbourhood<'_>) -> f64 {
        self.upper_bound(segment, link)
    }

    fn score(&self, segment: ArmSegment, link: usize, _: Vec3) -> f64 {
        self.upper_bound(segment, link)
    }
}

impl Occupant {
    /// Which controls are really worked in an action of a single person that leads along this way.
    #[must_use]
    pub fn worked(&self, walked: &WalkTrace, action: Action) -> OperatedControls {
        self.worked_at(&walked.start, action)
    }

    /// The same in an action from a place, the turn already made and doors still as they were.
    pub(super) fn worked_at(&self, start: &Place, action: Action) -> OperatedControls {
        self.worked_with(start, None, action)
    }

    /// The same beside somebody else, who is at another place.
    pub(super) fn worked_with(
        &self,
        start: &Place,
        beside: Option<(&Self, &Place)>,
        action: Action,
    ) -> OperatedControls {
        let doors = self.works_doors(action);
        let others = action.presses().either(doors);
        // Ways to share out what is worked so far among the hands: which are busy, and what is worked through which planes.
        let mut ways = vec![([false; 4], OperatedControls::default())];
        for control in doors.numbers().chain(others.numbers()).filter(|control| *control < self.cell.controls.len()) {
            let by = self.cell.controls[control].by;
            if by == ControlledBy::Nobody || (doors.has(control) && self.closes_on(start, action, control)) {
                continue;
            }
            // A door is locked while it is closed.
            let is_open = doors.has(control) && start.open().has(control);
            if !is_open && !self.cell.following.lets_work(control, start.arrangement()) {
                continue;
            }
            if by == ControlledBy::Person {
                let mut hands = self.hands(start, action.posture(), control);
                let moved = ways[0].1.presses.common(doors);
                if !moved.is_none() {
                    let after = start.with_open(start.open().either(moved));
                    let after = self.hands(&after, action.posture(), control);
                    hands = std::array::from_fn(|side| hands[side].filter(|_| after[side].is_some()));
                }
                let posture = action.of(Who::Second).posture();
                let others = beside.map(|(second, place)| second.hands(place, posture, control)).unwrap_or_default();
                let hands = [hands[0], hands[1], others[0], others[1]];
                let mut after = Vec::new();
                for (busy, worked) in &ways {
                    for (side, through) in hands.iter().enumerate().filter(|(side, _)| !busy[*side]) {
                        let Some(through) = *through else { continue };
                        let mut with: OperatedControls = *worked;
                        with.through[control] = through;
                        after.push((std::array::from_fn(|s| s == side || busy[s]), with));
                    }
                }
                if after.is_empty() {
                    continue;
                }
                ways = after;
            }
            ways.iter_mut().for_each(|(_, worked)| worked.presses = worked.presses.and(Presses::one(control)));
        }
        let planes = |worked: &OperatedControls| worked.through.iter().map(|planes| planes.count_ones()).sum::<u32>();
        ways.into_iter().map(|(_, worked)| worked).min_by_key(planes).unwrap_or_default()
    }

    /// Whether a door would close on who is there: on where they stand, or on what bends or crawls through it.
    fn closes_on(&self, place: &Place, action: Action, control: usize) -> bool {
        let (closed, posture) = (place.with_open(place.open().either(Presses::one(control))), action.posture());
        let has_room = || {
            let walker = Walker { obstacles: self.boxes(&closed), ..self.walker(&closed) };
            walker.is_free(closed, posture) && self.bend(&closed, posture) == self.bend(place, posture)
        };
        place.open().has(control) && !has_room()
    }

    /// Hands that get to a control, and through what.
    fn hands(&self, place: &Place, posture: Posture, control: usize) -> Hands {
        let Some(at) = self.cell.controls[control].place else { return Hands::default() };
        let middle = self.position(place) + Vec3::Z;
        let tolerance_m = self.cell.search.reach_tolerance_m;
        if point_segment(middle, at.a, at.b).distance > self.reach_m() + at.radius + tolerance_m {
            return Hands::default();
        }
        self.reached.of((*place, posture, control), || {
            let heading_rad = place.heading_rad(&self.cell.start);
            let bend = self.bend(place, posture);
            let body = self.cell.body.placed(self.position(place), heading_rad, posture, bend);
            let planes: Vec<Cuboid> = self.unbroken();
            let single = (0..planes.len().min(MOST_PLANES)).map(|plane| 1_u64 << plane);
            let all = single.clone().fold(0, |all, plane| all | plane);
            // As few planes as will do.
            let none = std::iter::once(0);
            let several = (planes.len() > 1).then_some(all);
            let mut hands = Hands::default();
            for through in none.chain(single).chain(several) {
                let closed =
                    planes.iter().enumerate().filter(|(plane, _)| *plane >= MOST_PLANES || through >> plane & 1 == 0);
                let walls: Vec<Cuboid> = closed.map(|(_, wall)| *wall).collect();
                for (hand, side) in hands.iter_mut().zip(Side::BOTH) {
                    *hand = hand.or_else(|| self.hand_gets_to((place, &body), side, &at, &walls).then_some(through));
                }
            }
            hands
        })
    }

    /// Whether one hand gets there, past these walls and the obstacles. A search that gives up counts as if it did.
    fn hand_gets_to(&self, (place, body): (&Place, &PlacedBody), side: Side, at: &Capsule, walls: &[Cuboid]) -> bool {
        let boxes = self.boxes(place);
        if !shoulder::is_available(body, side, boxes) {
            return false;
        }
        // What is no deeper in it than the tolerance may be missed.
        let tolerance_m = self.cell.search.reach_tolerance_m;
        let target = Solid::Capsule(Capsule { radius: at.radius + tolerance_m, ..*at });
        let obstacles: Vec<Cuboid> = boxes.iter().chain(walls).copied().collect();
        let found = reach(&ReachQuery {
            // Fingers work it, not what they hold.
            arm: &ArmModel::default(),
            side,
            world_from_shoulder: body.shoulder(side),
            carried_m: 0.0,
            hangs_from: None,
            known: None,
            wrist_within: None,
            links: &[target],
            obstacles: &obstacles,
            score: &OnControl,
            threshold: 0.0,
            tolerance_m,
            enough: 0.0,
            work_limit: WORK_LIMIT,
            stop: Some(self.stop()),
        });
        found.best.is_some() || !found.complete
    }
}

impl World {
    /// Steps of an action during which a hand is at a control.
    fn at_control(&self, control: usize) -> Range<usize> {
        match self.cell.controls[control].kind {
            ControlKind::Momentary => 0..self.cell.controls[control].steps,
            ControlKind::Held => 0..self.cell.steps_per_action,
            ControlKind::Toggled => 0..1,
        }
    }

    /// Controls that stay switched over after an action, of those that were before it.
    pub(super) fn switched_after(&self, switched: Presses, worked: &OperatedControls) -> Presses {
        let toggled = worked.presses.numbers().filter(|c| self.cell.controls[*c].kind == ControlKind::Toggled);
        toggled.fold(switched, |switched, control| switched.either(Presses::one(control)))
    }

    /// Controls that the FMU is told are on in a step of an action.
    pub(super) fn on_in_step(&self, step: usize, switched: Presses, worked: &OperatedControls) -> Presses {
        let held = worked.presses.numbers().filter(|control| {
            self.cell.controls[*control].kind != ControlKind::Toggled && self.at_control(*control).contains(&step)
        });
        held.fold(self.switched_after(switched, worked), |on, control| on.and(Presses::one(control)))
    }

    /// Planes that an arm on its way to a control is in, in a step of an action.
    pub(super) fn arm_in_planes(&self, step: usize, worked: &OperatedControls) -> impl Iterator<Item = usize> {
        let at = worked.presses.numbers().filter(|control| self.at_control(*control).contains(&step));
        let planes = at.fold(0, |planes, control| planes | worked.through[control]);
        (0..self.first.curtains.len().min(MOST_PLANES)).filter(move |plane| planes >> plane & 1 == 1)
    }
}
