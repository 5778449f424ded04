//! Controls in a search from anywhere: what is on and for how long yet, how many presses are left, and where on the floor a hand gets
//! to them.
//!
//! A press begins at any communication step, and there are so many of them at most, by anybody. The person works what a hand may get
//! to (`reading_regions` makes a transition of that); what anyone may work is worked at any moment, wherever the person is. One that is held is let
//! go at any moment.
//!
//! A hand gets no farther from the shoulder than an arm is long, and the shoulders of somebody who turns in place are on circles: where
//! that excludes a control, nothing in the way is needed to. Obstacles are not counted, so a hand may be thought to get through a fence.

use std::f64::consts::FRAC_1_SQRT_2;

use super::ReachabilitySearch;
use crate::cell::{Control, Workcell};
use crate::geometry::distance::point_segment;
use crate::geometry::{Capsule, Vec3};
use crate::human::{BendFraction, ControlKind, ControlledBy, Posture, Presses, Side};

/// What is on, and how many presses are left.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Controls {
    left: u32,
    /// Of each that is let go by itself, for how many steps it is on yet.
    steps: [usize; Presses::MOST],
    held: Presses,
    switched: Presses,
}

impl Controls {
    /// None is on.
    #[must_use]
    pub(crate) const fn new(presses: u32) -> Self {
        Self { left: presses, steps: [0; Presses::MOST], held: Presses::NONE, switched: Presses::NONE }
    }

    /// Which are on.
    #[must_use]
    pub(crate) fn on(&self) -> Presses {
        let pressed = (0..Presses::MOST).filter(|control| self.steps[*control] > 0);
        pressed.fold(self.held.and(self.switched), |on, control| on.and(Presses::one(control)))
    }

    /// After a step.
    #[must_use]
    pub(crate) fn after_a_step(mut self) -> Self {
        self.steps.iter_mut().for_each(|steps| *steps = steps.saturating_sub(1));
        self
    }

    /// With these worked as well; `None` if there are not so many presses left, or if one is on already and has to be let go first.
    #[must_use]
    pub(crate) fn press(&self, presses: Presses, controls: &[Control]) -> Option<Self> {
        let mut after = self.clone();
        after.left = after.left.checked_sub(presses.count())?;
        for control in presses.numbers() {
            let of = controls.get(control)?;
            match of.kind {
                ControlKind::Momentary if after.steps[control] == 0 => after.steps[control] = of.steps,
                ControlKind::Held if !after.held.has(control) => after.held = after.held.and(Presses::one(control)),
                ControlKind::Toggled => after.switched = after.switched.either(Presses::one(control)),
                ControlKind::Momentary | ControlKind::Held => return None,
            }
        }
        Some(after)
    }

    /// What else this may be by what others work, and by what is let go: with what is worked.
    pub(crate) fn others(&self, cell: &Workcell) -> Vec<(Presses, Self)> {
        let subsets = |of: Presses| {
            Presses::all(cell.controls.len()).filter(move |set| set.numbers().all(|control| of.has(control)))
        };
        let by_anyone = by(cell, ControlledBy::Anyone).fold(Presses::NONE, |all, c| all.and(Presses::one(c)));
        let mut all = Vec::new();
        for released in subsets(self.held) {
            let free = Self { held: self.held.either(released), ..self.clone() };
            for presses in subsets(by_anyone) {
                if (released.is_none() && presses.is_none()) || presses.numbers().any(|control| released.has(control)) {
                    continue;
                }
                all.extend(free.press(presses, &cell.controls).map(|after| (presses, after)));
            }
        }
        all
    }
}

/// Numbers of the controls that somebody works.
fn by(cell: &Workcell, who: ControlledBy) -> impl Iterator<Item = usize> + '_ {
    let controls = cell.controls.iter().enumerate();
    controls.filter(move |(_, control)| control.by == who).map(|(number, _)| number)
}

/// Two hands.
const MOST_AT_ONCE: u32 = 2;

impl ReachabilitySearch<'_> {
    /// Cells of the floor from which the person may work controls, so many at once at most.
    pub(super) fn in_hand(&self, presses: u32) -> Vec<(Presses, Vec<bool>)> {
        let place = |control: usize| Some((control, self.cell.controls[control].place?));
        let own: Vec<(usize, Vec<bool>)> = by(self.cell, ControlledBy::Person)
            .filter_map(place)
            .map(|(control, place)| (control, self.near_hands(&place)))
            .collect();
        Presses::all(self.cell.controls.len())
            .filter(|set| (1..=presses.min(MOST_AT_ONCE)).contains(&set.count()))
            .filter(|set| set.numbers().all(|control| own.iter().any(|(own, _)| *own == control)))
            .map(|set| {
                let mut cells = vec![true; self.ground.cells()];
                for (_, near) in own.iter().filter(|(control, _)| set.has(*control)) {
                    cells.iter_mut().zip(near).for_each(|(cell, near)| *cell &= *near);
                }
                (set, cells)
            })
            .collect()
    }

    /// Whether the person may work all of these from there.
    #[must_use]
    pub fn may_work(&self, presses: Presses, xy_m: [f64; 2]) -> bool {
        let far_m = |at: &Capsule| self.hands_reach_m(at);
        let circles = self.shoulder_circles();
        presses.numbers().all(|control| {
            let place = self.cell.controls.get(control).and_then(|control| control.place);
            place.is_some_and(|at| is_near(&circles, &at, xy_m, far_m(&at)))
        })
    }

    /// Cells of the floor from some place of which a hand may get there.
    fn near_hands(&self, at: &Capsule) -> Vec<bool> {
        let far_m = self.hands_reach_m(at) + FRAC_1_SQRT_2 * self.ground.cell_m();
        let circles = self.shoulder_circles();
        let near = |cell: usize| self.ground.is_open(cell) && is_near(&circles, at, self.ground.middle(cell), far_m);
        (0..self.ground.cells()).map(near).collect()
    }

    /// How far a control is from the shoulder at most that a hand gets to, m.
    fn hands_reach_m(&self, at: &Capsule) -> f64 {
        self.encounter.arm.reach() + at.radius + 2.0 * self.cell.search.reach_tolerance_m
    }

    /// The circles on which shoulders are of somebody who turns in place, however they bend: radius and height, m.
    fn shoulder_circles(&self) -> Vec<[f64; 2]> {
        let mut all: Vec<[f64; 2]> = Vec::new();
        for posture in Posture::USUAL {
            for bend in BendFraction::ALL {
                let body = self.cell.body.placed(Vec3::ZERO, 0.0, posture, bend);
                for at in Side::BOTH.map(|side| body.shoulder(side).translation) {
                    all.push([libm::hypot(at.x, at.y), at.z]);
                }
            }
        }
        all
    }
}

/// Whether a point of one of these circles around the axis of somebody there is so near to a control's middle line.
fn is_near(circles: &[[f64; 2]], at: &Capsule, [x, y]: [f64; 2], far_m: f64) -> bool {
    let [low, high] = [at.a.z.min(at.b.z), at.a.z.max(at.b.z)];
    let flat = |point: Vec3| Vec3::new(point.x, point.y, 0.0);
    let away = point_segment(Vec3::new(x, y, 0.0), flat(at.a), flat(at.b)).distance;
    circles.iter().any(|[radius, z]| {
        let (across, up) = ((away - radius).max(0.0), (low - z).max(z - high).max(0.0));
        libm::hypot(across, up) <= far_m
    })
}
