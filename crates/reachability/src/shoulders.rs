//! Whether arms get to a robot from wherever the shoulders of people in a box are.

use std::f64::consts::PI;

use super::ReachabilitySearch;
use super::readings::lever;
use crate::geometry::Vec3;
use crate::human::posture::may_be_cut_back;
use crate::human::reach::cells::ArmCells;
use crate::human::shoulder::is_certainly_unavailable;
use crate::human::{BendFraction, PlacedBody, PoseBox, Posture, Side};

/// Pieces of the arc that a shoulder may be on are looked at one by one, m.
const ARC_M: f64 = 0.02;
/// Shoulders that may be this far from where they are in the middle of a box are not looked at by what they hang from, m.
const HANGING_M: f64 = 0.1;

/// Where a shoulder of people in a box is, and the middle between both: points, and how far from them it can be, m.
struct Hanging {
    shoulder: (Vec3, f64),
    from: (Vec3, f64),
}

impl Hanging {
    /// Of a body in the middle of the box.
    fn of(body: &PlacedBody, side: Side, at: &PoseBox) -> Self {
        let moves = |point: Vec3| (point, at.moves_m(lever_of(at, point)));
        Self { shoulder: moves(body.shoulder(side).translation), from: moves(body.middle_of_shoulders()) }
    }
}

fn lever_of(at: &PoseBox, point: Vec3) -> f64 {
    lever(at, point.x, point.y)
}

/// Into how many pieces an arc is cut for something so far from the axis: none moves it much more than the places do.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some ten pieces")]
fn pieces(at: &PoseBox, from_axis: f64) -> u32 {
    (at.half_rad.min(PI) * from_axis / at.place_moves_m().clamp(0.5 * ARC_M, ARC_M)).ceil().max(1.0) as u32
}

impl ReachabilitySearch<'_> {
    /// Whether, wherever on its arc around the axis a shoulder is, no arm gets to a robot from there, or none is available.
    pub(super) fn is_out_of_reach(
        &self,
        arms: &ArmCells,
        at: &PoseBox,
        (posture, bend, side): (Posture, BendFraction, Side),
    ) -> bool {
        let from_axis = lever_of(at, self.placed(at, posture, bend).shoulder(side).translation);
        at.arcs(pieces(at, from_axis)).all(|piece| {
            let body = self.placed(&piece, posture, bend);
            let Hanging { shoulder: (at, by), from } = Hanging::of(&body, side, &piece);
            let obstacles = &self.encounter.obstacles;
            let bends = || may_be_cut_back(&self.cell.body, &piece, posture, obstacles);
            let is_bent_so = |(least, most): (BendFraction, BendFraction)| (least..=most).contains(&bend);
            !arms.may_touch(at, by)
                || !is_bent_so(bends())
                || is_certainly_unavailable(&body, side, obstacles, by.max(from.1))
                || (by <= HANGING_M && !arms.may_touch_hanging(at, by, from))
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::human::{Anthropometry, Body};
    use crate::search::Rng;

    /// Random poses of random boxes: in one of the pieces, with the shoulder and what it hangs from no farther than told from where
    /// they are in its middle, some nearly as far.
    #[test]
    fn shoulders_and_what_they_hang_from_are_where_a_piece_says() {
        let mut rng = Rng::new(11);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let body = Body::new(&Anthropometry::default()).unwrap();
        let placed = |at: &PoseBox, posture| body.placed(at.position(), at.heading_rad, posture, BendFraction::FULL);
        let mut nearly = [0, 0];
        for number in 0..3000 {
            let at = PoseBox {
                xy_m: [uniform(-1.0, 1.0), uniform(-1.0, 1.0)],
                half_m: uniform(0.0, 0.1),
                heading_rad: uniform(0.0, 6.0),
                half_rad: uniform(0.0, 4.0),
            };
            let (posture, side) = (Posture::USUAL[number % 6], Side::BOTH[number % 2]);
            let edge = |sign: f64| sign.clamp(-1.0, 1.0);
            let xy = [0, 1].map(|axis| at.xy_m[axis] + at.half_m * edge(uniform(-2.0, 2.0)));
            let turned = at.half_rad * edge(uniform(-1.2, 1.2));
            let pose = PoseBox::point(xy, at.heading_rad + turned);
            let from_axis = lever_of(&at, placed(&at, posture).shoulder(side).translation);
            let holds = |piece: &PoseBox| {
                let turn = (pose.heading_rad - piece.heading_rad + PI).rem_euclid(2.0 * PI) - PI;
                turn.abs() <= piece.half_rad + 1e-9
            };
            let piece = at.arcs(pieces(&at, from_axis)).find(holds).unwrap();
            let (told, is) = (Hanging::of(&placed(&piece, posture), side, &piece), placed(&pose, posture));
            let points = [(told.shoulder, is.shoulder(side).translation), (told.from, is.middle_of_shoulders())];
            for (nearly, ((middle, by), point)) in nearly.iter_mut().zip(points) {
                let moved = (point - middle).length();
                assert!(moved <= by + 1e-9, "{moved} beyond {by}: {at:?} {posture:?}");
                *nearly += usize::from(moved > 0.9 * by);
            }
        }
        assert!(nearly.iter().all(|nearly| *nearly > 50), "{nearly:?}");
    }
}
