//! Whether arms get to a robot from wherever the shoulders of people in a box are.

use std::f64::consts::PI;

use super::Anywhere;
use super::readings::lever;
use crate::human::posture::may_be_cut_back;
use crate::human::reach::cells::ArmCells;
use crate::human::shoulder::is_certainly_unavailable;
use crate::human::{BendFraction, PlacedBody, PoseBox, Posture, Side};

/// Pieces of the arc that a shoulder may be on are looked at one by one, m.
const ARC_M: f64 = 0.02;
/// Shoulders that may be this far from where they are in the middle of a box are not looked at by what they hang from, m.
const HANGING_M: f64 = 0.1;
impl Anywhere<'_> {
    /// Whether, wherever on its arc around the axis a shoulder is, no arm gets to a robot from there, or none is available.
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some ten pieces")]
    pub(super) fn is_out_of_reach(
        &self,
        arms: &ArmCells,
        at: &PoseBox,
        (posture, bend, side): (Posture, BendFraction, Side),
    ) -> bool {
        let levers = |body: &PlacedBody| {
            [body.shoulder(side).translation, body.middle_of_shoulders()].map(|point| lever(at, point.x, point.y))
        };
        let half_rad = at.half_rad.min(PI);
        let [from_axis, _] = levers(&self.placed(at, posture, bend));
        let pieces = (half_rad * from_axis / at.place_moves_m().clamp(0.5 * ARC_M, ARC_M)).ceil().max(1.0) as u32;
        (0..pieces).all(|number| {
            let half_rad = half_rad / f64::from(pieces);
            let heading_rad = at.heading_rad - at.half_rad.min(PI) + f64::from(2 * number + 1) * half_rad;
            let piece = PoseBox { heading_rad, half_rad, ..*at };
            let body = self.placed(&piece, posture, bend);
            let [shoulder, middle] = levers(&body);
            let (by, from_by) = (piece.moves_m(shoulder), piece.moves_m(middle));
            let obstacles = &self.encounter.obstacles;
            let at = body.shoulder(side).translation;
            let bends = || may_be_cut_back(&self.cell.body, &piece, posture, obstacles);
            let is_bent_so = |(least, most): (BendFraction, BendFraction)| (least..=most).contains(&bend);
            !arms.may_touch(at, by)
                || !is_bent_so(bends())
                || is_certainly_unavailable(&body, side, obstacles, by.max(from_by))
                || (by <= HANGING_M && !arms.may_touch_hanging(at, by, (body.middle_of_shoulders(), from_by)))
        })
    }
}
