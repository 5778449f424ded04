//! Where an action leads, and how: walks that obstacles end, postures for which there is room, bends that end at a wall.

use super::{Occupant, PersonState};
use crate::geometry::Vec3;
use crate::human::walk::{WalkTrace, Walker};
use crate::human::{Action, BendFraction, Place, Posture, Presses, posture};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

impl Occupant {
    /// Whether the person's start is free of obstacles.
    #[must_use]
    pub fn start_is_free(&self) -> bool {
        self.walker(&self.start()).is_free(self.start(), Posture::Upright)
    }

    /// Where an action leads that is taken as it is. Doors that are worked in it move as it begins.
    #[must_use]
    pub fn walk(&self, from: Place, action: Action) -> WalkTrace {
        let open = self.walk_opens(from, action);
        let walked = self.walker(&from.with_open(open)).walk(from.with_open(open), action, self.cell.steps_per_action);
        WalkTrace { start: walked.start.with_open(from.open()), ..walked }
    }

    /// The doors that stand open during an action from a place.
    #[must_use]
    pub fn walk_opens(&self, from: Place, action: Action) -> Presses {
        if self.works_doors(action).is_none() {
            return from.open();
        }
        let start = from.turned(action.walk().turn_eighths());
        from.open().either(self.worked_at(&start, action).presses.common(self.doors))
    }

    /// Controls of doors that an action works if it gets to them.
    #[must_use]
    pub fn works_doors(&self, action: Action) -> Presses {
        action.presses().common(self.doors)
    }

    /// Controls of doors.
    #[must_use]
    pub const fn doors(&self) -> Presses {
        self.doors
    }

    /// The action as the person takes it from a place: who has got below something stays as low as there is room for.
    #[must_use]
    pub fn taken(&self, from: &Place, action: Action) -> Action {
        let low = self.cell.repertoire.low();
        if low.is_empty() || self.boxes(from).is_empty() || self.fits(from, action.posture()) {
            return action;
        }
        let lower = low.iter().find(|low| **low > action.posture() && self.fits(from, **low));
        lower.map_or(action, |low| action.in_posture(*low))
    }

    /// Whether there is room for a posture at a place; as much for every one of who stands.
    fn fits(&self, place: &Place, posture: Posture) -> bool {
        let posture = if posture.is_low() { posture } else { Posture::Upright };
        self.fits.of((*place, posture), || self.walker(place).is_free(*place, posture))
    }

    /// How many sub-steps the person got ahead during step `i` of an action.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "a few")]
    pub fn moved(walked: &WalkTrace, i: usize) -> i8 {
        let before = if i == 0 { &walked.start } else { &walked.places[i - 1] };
        walked.places[i].ahead_of(before) as i8
    }

    /// How fast anybody gets on, m/s.
    pub(crate) fn fastest_m_s(&self) -> f64 {
        f64::from(self.cell.repertoire.strides()) * WALKING_SPEED_M_S
    }

    pub(crate) fn bend(&self, place: &Place, bent: Posture) -> BendFraction {
        if bent == Posture::Upright || self.boxes(place).is_empty() {
            return BendFraction::FULL;
        }
        self.bends.of((*place, bent), || {
            let heading_rad = place.heading_rad(&self.cell.start);
            posture::cut_back(self.body(), self.position(place), heading_rad, bent, self.boxes(place))
        })
    }

    /// Who walks while the doors are as they are at a place.
    pub(super) fn walker(&self, place: &Place) -> Walker<'_> {
        Walker {
            body: self.body(),
            start: &self.cell.start,
            sub_step_len_m: self.sub_step_m(),
            obstacles: self.in_the_way(place),
            moving: &self.moving_obstacles,
            strides: self.cell.repertoire.strides(),
        }
    }

    /// How the person walks, m/s.
    pub(super) fn velocity(&self, stance: &PersonState) -> Vec3 {
        let place = &stance.place;
        let back = |place: Place, _| if stance.moved > 0 { place.stepped_back() } else { place.stepped() };
        let before = (0..stance.moved.unsigned_abs()).fold(*place, back);
        (self.position(place) - self.position(&before)) / self.cell.step_s
    }
}
