//! The floor in squares: where somebody is hit, so coarsely that a neighbouring place is the same hazard.

use crate::geometry::Vec3;

/// Edge of a place cell, m.
pub(crate) const PLACE_CELL_M: f64 = 0.25;

/// The square of floor that a place is on.
#[must_use]
pub fn place_cell(person: Vec3) -> (i64, i64) {
    #[expect(clippy::cast_possible_truncation, reason = "metres on a shop floor, divided by 0.25")]
    let square = |v: f64| (v / PLACE_CELL_M).floor() as i64;
    (square(person.x), square(person.y))
}
