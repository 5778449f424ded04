//! The floor as cells: where a person has room, and what of that is joined to the outside.
//!
//! What has no room has none anywhere in its cell, shown by the signed distance from its middle, which changes by no more
//! than the place does. So the cells with room hold every place that a person can be in; by how far they hold more is half a
//! cell's diagonal.

use std::f64::consts::SQRT_2;

use super::{Body, PoseBox, Posture};
use crate::geometry::polygon::{contains, distance_to_edge};
use crate::geometry::segment_cuboid::segment_cuboid;
use crate::geometry::{Cuboid, Vec3};
use crate::stop::Stop;

/// More than what rounding does to a place, m.
const ROUNDING_M: f64 = 1e-9;

/// Cells that are gone through from one look at the clock to the next: each may be asked of hundreds of obstacles.
const BETWEEN_LOOKS: usize = 256;

/// Cells of a rectangle of the floor, row after row.
#[derive(Clone, Debug, PartialEq)]
pub struct Floor {
    low_m: [f64; 2],
    cell_m: f64,
    columns: usize,
    rows: usize,
    open: Vec<bool>,
    /// Whether there is nothing beyond.
    bounded: bool,
    /// Where people come from, if that is not the edge.
    entry: Option<Vec<bool>>,
}

/// What holds of each of so many cells; nothing, where there is no time for it.
pub fn of_cells<T>(cells: usize, stop: &Stop, of: impl Fn(usize) -> T) -> Option<Vec<T>> {
    let is_over = |cell: usize| cell.is_multiple_of(BETWEEN_LOOKS) && stop.is_due();
    (0..cells).map(|cell| (!is_over(cell)).then(|| of(cell))).collect()
}

/// Whether nobody has room to stand anywhere in a box.
#[must_use]
pub fn is_without_room(body: &Body, obstacles: &[Cuboid], at: &PoseBox) -> bool {
    let capsule = body.blocking_capsule(at.position(), Posture::Upright);
    let apart = |o: &Cuboid| segment_cuboid(capsule.a, capsule.b, o).distance;
    obstacles.iter().any(|o| apart(o) + at.place_moves_m() < capsule.radius)
}

/// Whether everybody has room to stand who is in a box.
#[must_use]
pub fn has_room_throughout(body: &Body, obstacles: &[Cuboid], at: &PoseBox) -> bool {
    let capsule = body.blocking_capsule(at.position(), Posture::Upright);
    let needs = capsule.radius + at.place_moves_m();
    let far = needs + 0.5 * (capsule.b - capsule.a).length();
    obstacles.iter().all(|o| {
        let apart = (o.centre - (capsule.a + capsule.b) * 0.5).length();
        apart > far + o.half.length() || segment_cuboid(capsule.a, capsule.b, o).distance >= needs
    })
}

impl Floor {
    /// The rectangle from `low_m` to `high_m` in cells of `cell_m`, with room where some place of the cell has it. Nothing, where there is no
    /// time for it: so with all that looks at every cell.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand cells to a side")]
    pub fn new(
        body: &Body,
        obstacles: &[Cuboid],
        (low_m, high_m): ([f64; 2], [f64; 2]),
        cell_m: f64,
        stop: &Stop,
    ) -> Option<Self> {
        let count = |axis: usize| ((high_m[axis] - low_m[axis]) / cell_m).ceil().max(1.0) as usize;
        let mut floor =
            Self { low_m, cell_m, columns: count(0), rows: count(1), open: Vec::new(), bounded: false, entry: None };
        let moves = 0.5 * SQRT_2 * cell_m;
        let open = |[x, y]: [f64; 2]| {
            let capsule = body.blocking_capsule(Vec3::new(x, y, 0.0), Posture::Upright);
            obstacles.iter().all(|o| {
                let middle = o.centre - (capsule.a + capsule.b) * 0.5;
                let far = o.half.length() + 0.5 * (capsule.b - capsule.a).length() + capsule.radius;
                middle.length() > far || segment_cuboid(capsule.a, capsule.b, o).distance + moves >= capsule.radius
            })
        };
        floor.open = of_cells(floor.cells(), stop, |cell| open(floor.middle(cell)))?;
        Some(floor)
    }

    /// The same, but there is no floor outside of a polygon: not in the rectangle, and not beyond it.
    #[must_use]
    pub fn bounded_by(mut self, polygon: &[[f64; 2]], stop: &Stop) -> Option<Self> {
        let may_be_in = self.may_be_in(polygon, stop)?;
        self.open.iter_mut().zip(may_be_in).for_each(|(open, may)| *open &= may);
        self.bounded = true;
        Some(self)
    }

    /// The same, but people come from within a polygon.
    #[must_use]
    pub fn entered_in(mut self, polygon: &[[f64; 2]], stop: &Stop) -> Option<Self> {
        self.entry = Some(self.may_be_in(polygon, stop)?);
        Some(self)
    }

    /// Whether some place of each cell may be in a polygon.
    fn may_be_in(&self, polygon: &[[f64; 2]], stop: &Stop) -> Option<Vec<bool>> {
        let moves = 0.5 * SQRT_2 * self.cell_m;
        let may_be_in = |at| contains(polygon, at) || distance_to_edge(polygon, at) <= moves;
        of_cells(self.cells(), stop, |cell| may_be_in(self.middle(cell)))
    }

    /// How many cells there are.
    #[must_use]
    pub const fn cells(&self) -> usize {
        self.columns * self.rows
    }

    /// Whether some place of a cell may have room.
    #[must_use]
    pub fn is_open(&self, cell: usize) -> bool {
        self.open[cell]
    }

    /// The middle of a cell, m.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "some thousand cells to a side")]
    pub fn middle(&self, cell: usize) -> [f64; 2] {
        let at = [cell % self.columns, cell / self.columns];
        std::array::from_fn(|axis| self.low_m[axis] + (at[axis] as f64 + 0.5) * self.cell_m)
    }

    /// How many cells along x and along y.
    #[must_use]
    pub const fn size(&self) -> [usize; 2] {
        [self.columns, self.rows]
    }

    /// The place so many cells along x and along y from the rectangle's low corner, m.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "some thousand cells to a side")]
    pub fn corner(&self, (column, row): (usize, usize)) -> [f64; 2] {
        [self.low_m[0] + column as f64 * self.cell_m, self.low_m[1] + row as f64 * self.cell_m]
    }

    /// The rectangle, its low corner and its high one, m.
    #[must_use]
    pub fn bounds(&self) -> ([f64; 2], [f64; 2]) {
        (self.low_m, self.corner((self.columns, self.rows)))
    }

    /// The cells beside which the rectangle ends; none if there is nothing beyond.
    pub fn edge(&self) -> impl Iterator<Item = usize> + '_ {
        let (columns, rows) = (self.columns, self.rows);
        let on_edge = move |cell: &usize| {
            let (column, row) = (cell % columns, cell / columns);
            !self.bounded && (column == 0 || row == 0 || column + 1 == columns || row + 1 == rows)
        };
        (0..self.cells()).filter(on_edge)
    }

    /// Edge of a cell, m.
    #[must_use]
    pub const fn cell_m(&self) -> f64 {
        self.cell_m
    }

    /// Leaves open only what is joined by open cells that `may_pass` to where people come from, else to the edge of the rectangle, if
    /// the floor has no boundary, or to a cell where somebody `starts`; cells that meet in a corner are joined.
    #[must_use]
    pub fn joined_to_the_outside(
        mut self,
        starts: &[[f64; 2]],
        may_pass: impl Fn(usize) -> bool,
        stop: &Stop,
    ) -> Option<Self> {
        let passable = of_cells(self.cells(), stop, |cell| self.open[cell] && may_pass(cell))?;
        let is_start = |cell: &usize| {
            let [x, y] = self.middle(*cell);
            starts.iter().any(|start| (start[0] - x).abs().max((start[1] - y).abs()) <= 0.5 * self.cell_m + ROUNDING_M)
        };
        let mut from = vec![false; self.cells()];
        let edge: Vec<usize> = self.edge().filter(|cell| passable[*cell]).collect();
        match &self.entry {
            None => edge.iter().for_each(|cell| from[*cell] = true),
            Some(entry) => (0..self.cells()).for_each(|cell| from[cell] = entry[cell] && passable[cell]),
        }
        // Who starts there is there, whatever sees them.
        (0..self.cells()).filter(|cell| self.open[*cell]).filter(is_start).for_each(|cell| from[cell] = true);
        self.open = self.spread(&from, &passable);
        // Who leaves the rectangle comes back anywhere.
        if edge.iter().any(|cell| self.open[*cell]) {
            edge.iter().for_each(|cell| from[*cell] = true);
            self.open = self.spread(&from, &passable);
        }
        Some(self)
    }

    /// Some cells, and all that are joined to them by others that `may_pass` holds.
    #[must_use]
    pub fn spread(&self, from: &[bool], may_pass: &[bool]) -> Vec<bool> {
        let mut joined = from.to_vec();
        let mut next: Vec<usize> = (0..self.cells()).filter(|cell| from[*cell]).collect();
        while let Some(cell) = next.pop() {
            for other in self.around(cell) {
                if may_pass[other] && !joined[other] {
                    joined[other] = true;
                    next.push(other);
                }
            }
        }
        joined
    }

    /// The cells that meet a cell in an edge or a corner, and itself.
    pub(crate) fn around(&self, cell: usize) -> impl Iterator<Item = usize> + use<> {
        let (columns, rows) = (self.columns, self.rows);
        let (column, row) = (cell % columns, cell / columns);
        let across = column.saturating_sub(1)..(column + 2).min(columns);
        (row.saturating_sub(1)..(row + 2).min(rows))
            .flat_map(move |row| across.clone().map(move |column| row * columns + column))
    }

    /// Whether all is known of the square of half edge `half_m` around `xy_m`: it is in the rectangle, or there is nothing beyond.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "some thousand cells to a side")]
    pub fn holds(&self, xy_m: [f64; 2], half_m: f64) -> bool {
        let high = |axis: usize, count: usize| self.low_m[axis] + count as f64 * self.cell_m;
        self.bounded
            || (0..2).all(|axis| xy_m[axis] - half_m >= self.low_m[axis] - ROUNDING_M)
                && xy_m[0] + half_m <= high(0, self.columns) + ROUNDING_M
                && xy_m[1] + half_m <= high(1, self.rows) + ROUNDING_M
    }

    /// The cells of which some point is in the square of half edge `half_m` around `xy_m`.
    pub fn within(&self, xy_m: [f64; 2], half_m: f64) -> impl Iterator<Item = usize> + use<> {
        #[expect(
            clippy::cast_possible_truncation,
            clippy::cast_sign_loss,
            clippy::cast_precision_loss,
            reason = "clamped to the rectangle"
        )]
        let span = |axis: usize, count: usize| {
            let at = |value: f64| (value - self.low_m[axis]) / self.cell_m;
            let (low, high) = (at(xy_m[axis] - half_m), at(xy_m[axis] + half_m));
            let off = high < -ROUNDING_M || low > count as f64 + ROUNDING_M;
            // What is on the rectangle's edge is in the cells beside it.
            if off { 0..0 } else { (low.max(0.0) as usize).min(count - 1)..(high.max(0.0) as usize + 1).min(count) }
        };
        let (columns, across) = (self.columns, span(0, self.columns));
        span(1, self.rows).flat_map(move |row| across.clone().map(move |column| row * columns + column))
    }

    /// The cells of which some point is no farther than `far_m` from one of some others, at least.
    #[must_use]
    pub fn grown(&self, cells: &[bool], far_m: f64) -> Vec<bool> {
        let mut grown = vec![false; self.cells()];
        let far = far_m + SQRT_2 * self.cell_m;
        for cell in (0..self.cells()).filter(|cell| cells[*cell]) {
            // Deep inside of them all are.
            if self.around(cell).all(|other| cells[other]) {
                grown[cell] = true;
                continue;
            }
            let [x, y] = self.middle(cell);
            for other in self.within([x, y], far) {
                let at = self.middle(other);
                grown[other] |= libm::hypot(at[0] - x, at[1] - y) <= far + ROUNDING_M;
            }
        }
        grown
    }

    /// What is beyond the rectangle, as far as this, as rectangles like those of [`Self::rectangles`]: none if there is no floor.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "some thousand cells to a side")]
    pub fn beyond(&self, far_m: f64) -> Vec<[f64; 4]> {
        let [left, low] = self.low_m;
        let (right, high) = (left + self.columns as f64 * self.cell_m, low + self.rows as f64 * self.cell_m);
        let (from, to) = (left - far_m, right + far_m);
        let all = [
            [from, low - far_m, to, low],
            [from, low, left, high],
            [right, low, to, high],
            [from, high, to, high + far_m],
        ];
        if self.bounded { Vec::new() } else { all.to_vec() }
    }

    /// Some cells as rectangles, each by its low x and y and its high ones, m: of neighbours in a row one, and of equal ones in rows
    /// one above the other.
    #[must_use]
    #[expect(clippy::cast_precision_loss, reason = "some thousand cells to a side")]
    pub fn rectangles(&self, cells: &[bool]) -> Vec<[f64; 4]> {
        // Columns from and to, rows from and to.
        let mut done: Vec<[usize; 4]> = Vec::new();
        let mut growing: Vec<[usize; 4]> = Vec::new();
        for row in 0..self.rows {
            let mut now = Vec::new();
            let is = |column: usize| column < self.columns && cells[row * self.columns + column];
            let mut column = 0;
            while column < self.columns {
                let from = column;
                while is(column) {
                    column += 1;
                }
                if column > from {
                    let below = growing.iter().position(|[a, b, ..]| (*a, *b) == (from, column));
                    let since = below.map_or(row, |number| growing.swap_remove(number)[2]);
                    now.push([from, column, since, row + 1]);
                }
                column += 1;
            }
            done.append(&mut growing);
            growing = now;
        }
        done.append(&mut growing);
        done.sort_by_key(|[left, _, low, _]| (*low, *left));
        let at = |axis: usize, number: usize| self.low_m[axis] + number as f64 * self.cell_m;
        done.into_iter().map(|[left, right, low, high]| [at(0, left), at(1, low), at(0, right), at(1, high)]).collect()
    }

    /// Whether some cell within the square of half edge `half_m` around `xy_m` is open; so is what is outside the rectangle, unless
    /// the floor has a boundary.
    #[must_use]
    pub fn any_open(&self, xy_m: [f64; 2], half_m: f64) -> bool {
        !self.holds(xy_m, half_m) || self.within(xy_m, half_m).any(|cell| self.open[cell])
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Rotation;
    use crate::human::walk::Walker;
    use crate::human::{Anthropometry, Place, Start};
    use crate::search::Rng;

    fn wall(x: f64, y: f64, half_x: f64, half_y: f64) -> Cuboid {
        Cuboid { centre: Vec3::new(x, y, 1.0), half: Vec3::new(half_x, half_y, 1.0), rotation: Rotation::IDENTITY }
    }

    /// A room of 3 m with a door in its south wall.
    fn room(door_m: f64) -> Vec<Cuboid> {
        let side = 0.5 * (3.0 - door_m);
        let front = [-1.0, 1.0].map(|s| wall(s * (0.5 * door_m + 0.5 * side), -1.5, 0.5 * side, 0.01));
        [vec![wall(0.0, 1.5, 1.51, 0.01), wall(-1.5, 0.0, 0.01, 1.51), wall(1.5, 0.0, 0.01, 1.51)], front.to_vec()]
            .concat()
    }

    #[test]
    fn a_box_is_without_room_only_where_nobody_in_it_has_any() {
        let mut rng = Rng::new(3);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let body = Body::new(&Anthropometry::default()).unwrap();
        let obstacles = [wall(0.2, 0.0, 0.25, 0.3), wall(-0.5, 0.4, 0.01, 0.4)];
        let mut without = [0, 0];
        for _ in 0..4000 {
            let at = PoseBox {
                xy_m: [uniform(-0.8, 0.7), uniform(-0.6, 0.9)],
                half_m: uniform(0.0, 0.08),
                heading_rad: 0.0,
                half_rad: 3.0,
            };
            let xy_m = [0, 1].map(|axis| at.xy_m[axis] + at.half_m * uniform(-2.0, 2.0).clamp(-1.0, 1.0));
            let of_box = is_without_room(&body, &obstacles, &at);
            let of_one = is_without_room(&body, &obstacles, &PoseBox::point(xy_m, 0.0));
            assert!(of_one || !of_box, "{xy_m:?} in {at:?}");
            without = [without[0] + usize::from(of_box), without[1] + usize::from(of_one && !of_box)];
        }
        assert!(without.iter().all(|count| *count > 100), "{without:?}");
    }

    fn floor(obstacles: &[Cuboid], cell_m: f64) -> Floor {
        let body = Body::new(&Anthropometry::default()).unwrap();
        Floor::new(&body, obstacles, ([-2.5, -2.5], [2.5, 2.5]), cell_m, &Stop::default()).unwrap()
    }

    #[test]
    fn the_edge_of_the_rectangle_is_in_it_and_beyond_nothing_is_known() {
        let all = floor(&[], 0.025);
        let bounded =
            all.clone().bounded_by(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]], &Stop::default()).unwrap();
        for at in [[2.5, 0.0], [-2.5, 0.0], [0.0, 2.5], [2.5, -2.5]] {
            assert!(all.holds(at, 0.0) && all.within(at, 0.0).count() > 0, "{at:?}");
        }
        assert!(!all.holds([2.6, 0.0], 0.0) && all.any_open([2.6, 0.0], 0.0));
        assert!(bounded.holds([2.6, 0.0], 0.0) && !bounded.any_open([2.6, 0.0], 0.0));
        assert!(bounded.any_open([0.9, 0.9], 0.0) && !bounded.any_open([1.1, 0.0], 0.0));
    }

    #[test]
    fn rectangles_hold_the_cells_and_nothing_else() {
        let floor = floor(&room(0.8), 0.05);
        let open: Vec<bool> = (0..floor.cells()).map(|cell| floor.is_open(cell)).collect();
        let all = floor.rectangles(&open);
        assert!(all.len() < 100, "{}", all.len());
        for (cell, is_open) in open.iter().enumerate() {
            let [x, y] = floor.middle(cell);
            let holds = |[left, low, right, high]: &&[f64; 4]| *left < x && x < *right && *low < y && y < *high;
            assert_eq!(all.iter().filter(holds).count(), usize::from(*is_open), "{x} {y}");
        }
        // Beyond there is floor all around, and none with a boundary.
        let area = |all: &[[f64; 4]]| all.iter().map(|[a, b, c, d]| (c - a) * (d - b)).sum::<f64>();
        assert!((area(&floor.beyond(1.0)) - (7.0 * 7.0 - 5.0 * 5.0)).abs() < 1e-6);
        assert!(
            floor
                .bounded_by(&[[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0]], &Stop::default())
                .unwrap()
                .beyond(1.0)
                .is_empty()
        );
    }

    #[test]
    fn places_with_room_are_in_open_cells() {
        let body = Body::new(&Anthropometry::default()).unwrap();
        let obstacles = room(0.8);
        let mut rng = Rng::new(3);
        let mut shut = 0;
        for cell_m in [0.025, 0.1, 0.3] {
            let floor = floor(&obstacles, cell_m);
            for _ in 0..3000 {
                let mut at =
                    || 5.0 * (f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)) - 2.5;
                let xy = [at(), at()];
                let start = Start::new(xy[0], xy[1], 0.0);
                let walker = Walker {
                    body: &body,
                    start: &start,
                    sub_step_len_m: 0.032,
                    obstacles: &obstacles,
                    moving: &[],
                    strides: 1,
                };
                let open = floor.any_open(xy, 0.0);
                assert!(open || !walker.is_free(Place::START, Posture::Upright), "{xy:?} with {cell_m} m");
                shut += usize::from(!open);
            }
        }
        assert!(shut > 200, "{shut}");
    }

    /// The body is 0.28 m wide: a door of 0.25 m is shut, and one of 0.35 m lets in.
    #[test]
    fn a_room_is_joined_to_the_outside_through_a_door_that_is_wide_enough() {
        for (door_m, joined) in [(0.0, false), (0.25, false), (0.35, true)] {
            let floor = floor(&room(door_m), 0.025).joined_to_the_outside(&[], |_| true, &Stop::default()).unwrap();
            assert_eq!(floor.any_open([0.0, 0.0], 0.1), joined, "{door_m} m");
            assert!(floor.any_open([2.0, 0.0], 0.1));
        }
        // Who starts in a closed room is in it.
        let inside = floor(&room(0.0), 0.025).joined_to_the_outside(&[[0.3, 0.2]], |_| true, &Stop::default()).unwrap();
        assert!(inside.any_open([-0.5, 0.0], 0.1) && inside.any_open([2.0, 0.0], 0.1));
        // Who comes from the room only is in the room only, where it is shut, and anywhere else.
        let in_room = [[-0.3, -0.3], [0.3, -0.3], [0.3, 0.3]];
        let within = |door_m| {
            floor(&room(door_m), 0.025)
                .entered_in(&in_room, &Stop::default())
                .unwrap()
                .joined_to_the_outside(&[], |_| true, &Stop::default())
                .unwrap()
        };
        assert!(within(0.0).any_open([-0.5, 0.0], 0.1) && !within(0.0).any_open([2.0, 0.0], 0.1));
        assert!(within(0.35).any_open([2.0, 0.0], 0.1) && within(0.35).any_open([-0.5, 0.0], 0.1));
        // Where nobody may pass the door, nobody is in the room.
        let all = floor(&room(0.8), 0.025);
        let shut = all
            .clone()
            .joined_to_the_outside(
                &[],
                |cell| all.middle(cell)[1].abs() > 0.2 + 1.5 || all.middle(cell)[1] > -1.3,
                &Stop::default(),
            )
            .unwrap();
        assert!(!shut.any_open([0.0, 0.0], 0.1));
    }

    /// A triangle that no edge of a cell follows: whoever is in it is in one of its cells; and whoever is no farther than so from a
    /// place in some cells is in cells grown by that.
    #[test]
    fn places_in_a_polygon_and_places_near_some_cells_are_in_the_cells_that_are_told() {
        let triangle = [[-1.03, -0.87], [1.21, -0.4], [-0.33, 1.17]];
        let all = floor(&[], 0.1);
        let bounded = all.clone().bounded_by(&triangle, &Stop::default()).unwrap();
        // Only cells that the edge of the triangle may cross may be passed, and have their middles outside.
        let is_cut = |at| !contains(&triangle, at) && distance_to_edge(&triangle, at) <= 0.0708;
        let entered = all
            .clone()
            .entered_in(&triangle, &Stop::default())
            .unwrap()
            .joined_to_the_outside(&[], |cell| is_cut(all.middle(cell)), &Stop::default())
            .unwrap();
        let some: Vec<bool> = (0..all.cells()).map(|cell| cell % 97 == 0).collect();
        let grown = all.grown(&some, 0.16);
        let mut rng = Rng::new(13);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let (mut inside, mut cut, mut near) = (0, 0, 0);
        for _ in 0..40_000 {
            let at = [uniform(-1.3, 1.3), uniform(-1.3, 1.3)];
            if contains(&triangle, at) {
                assert!(bounded.any_open(at, 0.0), "{at:?}");
                inside += 1;
                if all.within(at, 0.0).all(|cell| is_cut(all.middle(cell))) {
                    assert!(entered.any_open(at, 0.0), "{at:?}");
                    cut += 1;
                }
            }
            let to = [at[0] + uniform(-0.16, 0.16), at[1] + uniform(-0.16, 0.16)];
            if all.within(at, 0.0).any(|cell| some[cell]) && libm::hypot(to[0] - at[0], to[1] - at[1]) <= 0.16 {
                assert!(all.within(to, 0.0).any(|cell| grown[cell]), "{at:?} {to:?}");
                near += 1;
            }
        }
        assert!(inside > 5000 && cut > 200 && near > 100, "{inside} {cut} {near}");
        assert!(grown.iter().filter(|is| **is).count() < all.cells() / 2);
    }

    /// Beyond the rectangle there is floor: who gets to its edge comes back over any other, even where a wall is between.
    #[test]
    fn who_leaves_the_rectangle_comes_back_anywhere() {
        let all = floor(&[wall(0.0, 0.0, 2.6, 0.01)], 0.05);
        let south = [[-0.5, -2.0], [0.5, -2.0], [0.0, -1.0]];
        let entered = all
            .clone()
            .entered_in(&south, &Stop::default())
            .unwrap()
            .joined_to_the_outside(&[], |_| true, &Stop::default())
            .unwrap();
        assert!(entered.any_open([0.0, -1.0], 0.0) && entered.any_open([0.0, 1.0], 0.0));
        let bounded = all.bounded_by(&[[-2.4, -2.4], [2.4, -2.4], [2.4, 2.4], [-2.4, 2.4]], &Stop::default()).unwrap();
        let entered = bounded
            .entered_in(&south, &Stop::default())
            .unwrap()
            .joined_to_the_outside(&[], |_| true, &Stop::default())
            .unwrap();
        assert!(entered.any_open([0.0, -1.0], 0.0) && !entered.any_open([0.0, 1.0], 0.0));
    }
}
