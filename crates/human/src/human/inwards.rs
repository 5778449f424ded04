//! The floor rounded inwards: small squares in all of which somebody may be, and what of them is joined to where people come from.
//!
//! A [`super::Floor`] holds every place that may have room, and more; this holds fewer. Who walks from square to square here does so in
//! fact: a square is entered only while looking along one of eight headings for which all of it is clear, and nobody turns but from
//! one such heading to another. Between two walls that leave less than 2.5 squares besides the body, no square may lie, and a way may be
//! missed.

use std::f64::consts::{FRAC_PI_4, FRAC_PI_8};

use super::PoseBox;
use crate::stop::Stop;

/// Edge of a square, m.
pub(crate) const SQUARE_M: f64 = 0.005;
/// Squares to a side of a block, a power of two.
const SIDE: usize = 32;
/// Squares of a block.
const SQUARES: usize = SIDE * SIDE;
/// Squares that people get to from one look at the clock to the next.
const BETWEEN_LOOKS: usize = 1024;
/// Headings for all of which something holds.
pub(crate) const ALL_HEADINGS: u8 = 0xff;
/// Columns and rows by heading, the first along the columns, each further to the left.
const AHEAD: [(isize, isize); 8] = [(1, 0), (1, 1), (0, 1), (-1, 1), (-1, 0), (-1, -1), (0, -1), (1, -1)];

/// Of headings, as bits, those for which every place of a square is clear, and those for which none is; of the others it is not
/// known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Decided {
    /// Every place.
    pub clear: u8,
    /// No place.
    pub shut: u8,
}

/// Squares that are judged together where all are alike.
#[derive(Clone, Debug, PartialEq)]
enum Block {
    Shut,
    /// Clear for every heading, and whether people get there.
    Clear(bool),
    /// Of each square the headings for which it is clear, and whether people get there.
    Mixed(Box<[(u8, bool); SQUARES]>),
}

/// See the top of this file.
#[derive(Clone, Debug, PartialEq)]
pub struct Inwards {
    /// By how much the squares are turned from +x towards +y, rad, with its sine and cosine.
    turned_rad: f64,
    turned: (f64, f64),
    /// The low corner along the turned axes, m.
    low_m: [f64; 2],
    /// Blocks along both.
    size: [usize; 2],
    blocks: Vec<Block>,
}

/// Whether something holds of all places of some squares together, or of none; else it is asked of each.
pub(crate) type Of<'a> = &'a dyn Fn(&PoseBox) -> Option<bool>;

/// A square by its column and row among all.
type At = (isize, isize);

impl Inwards {
    /// Over all of a rectangle, from its low corner to its high one, m, with squares that are turned by so much. `decide` tells of
    /// squares, each a [`PoseBox`] whose places are no farther from its middle than [`PoseBox::place_moves_m`] says, for which of
    /// some headings they are clear: the first looks where the squares are turned to. Where there is no time for it people get to fewer.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some thousand blocks to a side")]
    pub fn new(
        (low_m, high_m): ([f64; 2], [f64; 2]),
        turned_rad: f64,
        decide: &dyn Fn(&PoseBox, u8) -> Decided,
        stop: &Stop,
    ) -> Self {
        let turned = libm::sincos(turned_rad);
        let mut this = Self { turned_rad, turned, low_m, size: [0; 2], blocks: Vec::new() };
        let corners = [low_m, high_m, [low_m[0], high_m[1]], [high_m[0], low_m[1]]].map(|at| this.inwards(at));
        let over = |axis: usize, pick: fn(f64, f64) -> f64| corners.map(|at| at[axis]).into_iter().reduce(pick);
        let low = [0, 1].map(|axis| over(axis, f64::min).unwrap_or_default());
        let high = [0, 1].map(|axis| over(axis, f64::max).unwrap_or_default());
        let edge = SIDE as f64 * SQUARE_M;
        this.low_m = low;
        this.size = [0, 1].map(|axis| ((high[axis] - low[axis]) / edge).ceil().max(1.0) as usize);
        let all = (0..this.size[1]).flat_map(|row| (0..this.size[0]).map(move |column| (column, row)));
        this.blocks = all.map(|at| this.block(at, decide, stop)).collect();
        this
    }

    /// Along the turned axes.
    fn inwards(&self, [x, y]: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.turned;
        [cos * x + sin * y, cos * y - sin * x]
    }

    /// So many squares from the low corner, floor plan, m.
    fn outwards(&self, squares: [f64; 2]) -> [f64; 2] {
        let (sin, cos) = self.turned;
        let [x, y] = [0, 1].map(|axis| self.low_m[axis] + squares[axis] * SQUARE_M);
        [cos * x - sin * y, sin * x + cos * y]
    }

    fn block(&self, (column, row): (usize, usize), decide: &dyn Fn(&PoseBox, u8) -> Decided, stop: &Stop) -> Block {
        let mut squares = Box::new([(0, false); SQUARES]);
        let mut pending = vec![(0, 0, SIDE, ALL_HEADINGS, 0)];
        while let Some((left, low, side, asked, known)) = pending.pop() {
            if stop.is_due() {
                return Block::Shut;
            }
            let corner = ((column * SIDE + left).cast_signed(), (row * SIDE + low).cast_signed());
            let at = self.pose_box(corner, side);
            let Decided { clear, shut } = decide(&at, asked);
            let (clear, asked) = (known | clear & asked, asked & !clear & !shut);
            if asked == 0 || side == 1 {
                for at in (low..low + side).flat_map(|row| (left..left + side).map(move |c| row * SIDE + c)) {
                    squares[at].0 = clear;
                }
            } else {
                let side = side / 2;
                let parts = [(0, 0), (side, 0), (0, side), (side, side)];
                pending.extend(parts.map(|(right, up)| (left + right, low + up, side, asked, clear)));
            }
        }
        let all = |mask: u8| squares.iter().all(|(clear, _)| *clear == mask);
        match () {
            () if all(0) => Block::Shut,
            () if all(ALL_HEADINGS) => Block::Clear(false),
            () => Block::Mixed(squares),
        }
    }

    /// The headings that a square is looked at for, by number, rad.
    pub fn headings(turned_rad: f64) -> impl Iterator<Item = (u8, f64)> {
        (0..8).map(move |number| (number, turned_rad + f64::from(number) * FRAC_PI_4))
    }

    /// The turns that tell two of these floors apart: from 0 to an eighth of a turn.
    #[must_use]
    pub fn turn_of(heading_rad: f64) -> f64 {
        // What rounding leaves of a whole turn is none.
        let turn = (heading_rad + 1e-9).rem_euclid(FRAC_PI_4) - 1e-9;
        debug_assert!(turn < 2.0 * FRAC_PI_8);
        turn.max(0.0)
    }

    fn number(&self, (column, row): At) -> Option<(usize, usize)> {
        let (column, row) = (usize::try_from(column).ok()?, usize::try_from(row).ok()?);
        let [columns, rows] = self.size;
        let (across, up) = (column / SIDE, row / SIDE);
        (across < columns && up < rows).then_some((up * columns + across, row % SIDE * SIDE + column % SIDE))
    }

    /// The square with a place in it.
    #[expect(clippy::cast_possible_truncation, reason = "some thousand squares to a side")]
    fn square(&self, xy_m: [f64; 2]) -> At {
        let at = self.inwards(xy_m);
        let [column, row] = [0, 1].map(|axis| ((at[axis] - self.low_m[axis]) / SQUARE_M).floor() as isize);
        (column, row)
    }

    /// The middle of a square, floor plan, m.
    fn middle(&self, (column, row): At) -> [f64; 2] {
        self.outwards([column as f64 + 0.5, row as f64 + 0.5])
    }

    /// Headings for which a square is clear, and whether people get there.
    fn state(&self, at: At) -> (u8, bool) {
        let Some((block, square)) = self.number(at) else { return (0, false) };
        match &self.blocks[block] {
            Block::Shut => (0, false),
            Block::Clear(reached) => (ALL_HEADINGS, *reached),
            Block::Mixed(squares) => squares[square],
        }
    }

    /// People get to a square, or all that are clear with it; which is added to what is looked at next where they did not before.
    fn reach(&mut self, at: At, next: &mut Vec<At>) {
        let Some((block, square)) = self.number(at) else { return };
        let is_new = match &mut self.blocks[block] {
            Block::Clear(reached) => !std::mem::replace(reached, true),
            Block::Mixed(squares) if squares[square].0 != 0 => !std::mem::replace(&mut squares[square].1, true),
            Block::Shut | Block::Mixed(_) => false,
        };
        if is_new {
            next.push(at);
        }
    }

    /// Squares from which a step leads on, for a square that people get to: itself, or the edge of its block if all of that is clear.
    fn edge_of(&self, at: At) -> Vec<At> {
        let is_clear = self.number(at).is_some_and(|(block, _)| matches!(self.blocks[block], Block::Clear(_)));
        if !is_clear {
            return vec![at];
        }
        let side = SIDE.cast_signed();
        let low = (at.0.div_euclid(side) * side, at.1.div_euclid(side) * side);
        let all = (0..side).flat_map(|row| (0..side).map(move |column| (column, row)));
        let is_edge = |(column, row): &At| [*column, *row].iter().any(|n| *n == 0 || *n == side - 1);
        all.filter(is_edge).map(|(column, row)| (low.0 + column, low.1 + row)).collect()
    }

    /// Some clear squares of all of which something holds: at least one of each block that is clear and has any.
    fn where_all(&self, is: Of<'_>) -> Vec<At> {
        let [columns, rows] = self.size;
        let blocks = (0..rows).flat_map(|row| (0..columns).map(move |column| (column, row)));
        let of_block = |(column, row): (usize, usize)| {
            let low = ((column * SIDE).cast_signed(), (row * SIDE).cast_signed());
            let side = SIDE.cast_signed();
            let block = &self.blocks[row * columns + column];
            let known = if *block == Block::Shut { Some(false) } else { is(&self.pose_box(low, SIDE)) };
            let all = (0..side).flat_map(move |row| (0..side).map(move |column| (low.0 + column, low.1 + row)));
            let all = all.filter(move |at| {
                self.state(*at).0 != 0 && known.or_else(|| is(&self.pose_box(*at, 1))).unwrap_or_default()
            });
            let enough = match block {
                Block::Clear(_) => 1,
                Block::Shut | Block::Mixed(_) if known == Some(false) => 0,
                Block::Shut | Block::Mixed(_) => SQUARES,
            };
            all.take(enough).collect::<Vec<_>>()
        };
        blocks.flat_map(of_block).collect()
    }

    /// People come from wherever `comes` holds of all of a square, and from squares with some places, and get to all that is joined to
    /// those; to fewer, where there is no time for it.
    pub fn join(&mut self, comes: Of<'_>, places: &[[f64; 2]], stop: &Stop) {
        let mut next = Vec::new();
        let from = [self.where_all(comes), places.iter().map(|at| self.square(*at)).collect()].concat();
        from.into_iter().for_each(|at| self.reach(at, &mut next));
        let mut looked_at = 0_usize;
        while let Some(at) = next.pop() {
            looked_at += 1;
            if looked_at.is_multiple_of(BETWEEN_LOOKS) && stop.is_due() {
                return;
            }
            for from in self.edge_of(at) {
                let (clear, _) = self.state(from);
                for (heading, (across, up)) in (0..8).zip(AHEAD) {
                    let to = (from.0 + across, from.1 + up);
                    if clear & self.state(to).0 & 1 << heading != 0 {
                        self.reach(to, &mut next);
                    }
                }
            }
        }
    }

    /// So many squares to a side, from that of the low corner on.
    fn pose_box(&self, (column, row): At, side: usize) -> PoseBox {
        let half = 0.5 * side as f64;
        let xy_m = self.outwards([column as f64 + half, row as f64 + half]);
        PoseBox { xy_m, half_m: half * SQUARE_M, heading_rad: self.turned_rad, half_rad: 0.0 }
    }

    /// Whether people get to all of the square that a place is in.
    #[must_use]
    pub fn is_reached(&self, xy_m: [f64; 2]) -> bool {
        self.state(self.square(xy_m)).1
    }

    /// Middles of squares with some clear heading, floor plan, m, that are no farther than `far_m` from a place, the nearest first;
    /// only those that people get to, if `reached`.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "some squares")]
    pub fn near(&self, xy_m: [f64; 2], far_m: f64, reached: bool) -> Vec<[f64; 2]> {
        let far = (far_m / SQUARE_M).ceil() as isize;
        let (column, row) = self.square(xy_m);
        let all = (row - far..=row + far).flat_map(|row| (column - far..=column + far).map(move |c| (c, row)));
        let apart = |at: &[f64; 2]| libm::hypot(at[0] - xy_m[0], at[1] - xy_m[1]);
        let is = |at: &At| {
            let (clear, is_reached) = self.state(*at);
            clear != 0 && (is_reached || !reached)
        };
        let middles = all.filter(is).map(|at| self.middle(at));
        let mut near: Vec<[f64; 2]> = middles.filter(|at| apart(at) <= far_m).collect();
        near.sort_by(|a, b| apart(a).total_cmp(&apart(b)));
        near
    }

    /// Whether people get to some square of all of which something holds.
    #[must_use]
    pub fn reaches(&self, is: Of<'_>) -> bool {
        self.where_all(is).into_iter().any(|at| self.state(at).1)
    }
}

#[cfg(test)]
mod tests {
    use std::f64::consts::SQRT_2;

    use super::*;
    use crate::geometry::{Cuboid, Vec3, rotation_about};
    use crate::human::{Anthropometry, Body, Posture, has_room_throughout, is_without_room};
    use crate::search::Rng;

    const RECTANGLE: ([f64; 2], [f64; 2]) = ([-0.5, -0.5], [0.5, 0.5]);

    /// Two walls in line, turned, that leave a gap about their middle, off it by so much.
    fn walls(turned_rad: f64, gap_m: f64, off_m: f64) -> [Cuboid; 2] {
        let rotation = rotation_about(Vec3::Z, turned_rad);
        [-1.0, 1.0].map(|side| Cuboid {
            centre: rotation * Vec3::new(off_m + side * (0.5 * gap_m + 0.6), 0.0, 1.0),
            half: Vec3::new(0.6, 0.01, 1.0),
            rotation,
        })
    }

    fn uniform(rng: &mut Rng, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    }

    /// Who comes from one side of a line through the middle gets to the other through gaps that are wider than the body by 2.5 squares, and
    /// through none that is narrower, wherever and however squares lie.
    #[test]
    fn gaps_are_passed_only_by_who_fits() {
        let body = Body::new(&Anthropometry::default()).unwrap();
        let wide_m = 2.0 * body.blocking_capsule(Vec3::ZERO, Posture::Upright).radius;
        assert!((wide_m - 0.28).abs() < 1e-9);
        let lost_m = (1.0 + SQRT_2) * SQUARE_M;
        let mut rng = Rng::new(11);
        let (mut passed, mut shut, mut between) = (0, 0, 0);
        for number in 0..60 {
            let turned = if number % 3 == 0 { 0.0 } else { uniform(&mut rng, -0.7, 0.7) };
            let gap_m = uniform(&mut rng, wide_m - 0.02, wide_m + 0.03);
            let walls = walls(turned, gap_m, uniform(&mut rng, -0.03, 0.03));
            let decide = |at: &PoseBox, asked: u8| match () {
                () if is_without_room(&body, &walls, at) => Decided { clear: 0, shut: asked },
                () if has_room_throughout(&body, &walls, at) => Decided { clear: asked, shut: 0 },
                () => Decided { clear: 0, shut: 0 },
            };
            let before_m = |[x, y]: [f64; 2]| x * libm::sin(turned) - y * libm::cos(turned);
            let comes = |at: &PoseBox| {
                let (before, moves) = (before_m(at.xy_m) - 0.2, at.place_moves_m());
                (before.abs() > moves).then_some(before > 0.0)
            };
            let mut floor = Inwards::new(RECTANGLE, if number % 2 == 0 { 0.0 } else { 0.3 }, &decide, &Stop::default());
            floor.join(&comes, &[], &Stop::default());
            let there = [-0.25 * libm::sin(turned), 0.25 * libm::cos(turned)];
            let is = floor.is_reached(there);
            assert!(gap_m >= wide_m || !is, "{gap_m} turned by {turned}");
            assert!(gap_m < wide_m + lost_m || is, "{gap_m} turned by {turned}");
            passed += usize::from(is);
            shut += usize::from(gap_m < wide_m);
            between += usize::from(!is && gap_m >= wide_m);
        }
        assert!(passed > 10 && shut > 10 && between < 20, "{passed} {shut} {between}");
    }

    /// Clear for some headings alone: nobody gets anywhere else than ahead, in squares that are turned as well.
    #[test]
    fn nobody_walks_but_where_they_look() {
        for turned in [0.0, 0.4] {
            let at = |x: f64, y: f64| {
                let (sin, cos) = libm::sincos(turned);
                [cos * x - sin * y, sin * x + cos * y]
            };
            let along = |[x, y]: [f64; 2]| {
                let (sin, cos) = libm::sincos(turned);
                [cos * x + sin * y, cos * y - sin * x]
            };
            let reached = |headings: u8| {
                let decide = |_: &PoseBox, asked| Decided { clear: asked & headings, shut: asked & !headings };
                let mut floor = Inwards::new(RECTANGLE, turned, &decide, &Stop::default());
                // From a square of 0.1 m about the middle.
                floor.join(
                    &|at: &PoseBox| {
                        let far = along(at.xy_m).map(f64::abs).into_iter().fold(0.0, f64::max);
                        let moves = at.place_moves_m();
                        ((far - 0.05).abs() > moves).then_some(far < 0.05)
                    },
                    &[],
                    &Stop::default(),
                );
                [at(0.3, 0.0), at(0.0, 0.3), at(-0.3, 0.0), at(0.0, -0.3), at(0.3, 0.3), at(0.3, 0.15)]
                    .map(|at| floor.is_reached(at))
            };
            assert_eq!(reached(0b1), [true, false, false, false, false, false]);
            assert_eq!(reached(0b10), [false, false, false, false, true, false]);
            // Ahead and to the left: and wherever a turn in between leads.
            assert_eq!(reached(0b101), [true, true, false, false, true, true]);
            assert_eq!(reached(0b1_0000), [false, false, true, false, false, false]);
            assert_eq!(reached(ALL_HEADINGS), [true; 6]);
        }
    }
}
