//! How far it is at least to walk over the floor: from some cells to each other, on a way that stays in others.
//!
//! A way leaves the disc around the cell that it begins in, if it does not end in there; from where it leaves it goes on in
//! the same manner. Each such part is no shorter than the straight line between the two cells' middles, less what a point of
//! a cell may be off its middle at both ends. Inside a disc only cells count that are joined to its middle within it. So every
//! bound holds whatever the way does, and is a straight line's length where there is one: less a cell's diagonal for each
//! radius of the disc.
//!
//! A cell to which another disc leads sooner by a cell's diagonal begins none: whatever way goes on from it leaves that disc where the
//! straight line from its middle is no longer than the one to the cell and the way from there.

use std::cmp::Ordering;
use std::collections::BinaryHeap;
use std::f64::consts::SQRT_2;

use super::Floor;
use crate::stop::{Stop, count_work};

/// Radius of the discs, m.
const DISC_M: f64 = 1.0;

/// Discs that are gone through from one look at the clock to the next: some thousand cells each.
const BETWEEN_LOOKS: usize = 64;

/// A lower bound on the length of ways to each cell of a floor.
#[derive(Clone, Debug, PartialEq)]
pub struct DistanceField {
    floor: Floor,
    /// Infinite where no way leads.
    least_m: Vec<f64>,
}

/// A cell that a way leads to, by the least that it is long.
#[derive(PartialEq)]
struct HeapEntry(f64, usize);

impl Eq for HeapEntry {}

impl Ord for HeapEntry {
    fn cmp(&self, other: &Self) -> Ordering {
        other.0.total_cmp(&self.0).then(other.1.cmp(&self.1))
    }
}

impl PartialOrd for HeapEntry {
    fn partial_cmp(&self, other: &Self) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl DistanceField {
    /// Nothing to walk to these cells, and no way to others.
    #[must_use]
    pub fn at_once(floor: &Floor, cells: &[bool]) -> Self {
        let least_m = cells.iter().map(|cell| if *cell { 0.0 } else { f64::INFINITY }).collect();
        Self { floor: floor.clone(), least_m }
    }

    /// From any point of `sources`, through cells of `domain`; a source that is no cell of it is none. Of ways that are longer than
    /// `most_m` it is told only that they are. Nothing, where there is no time for it.
    #[must_use]
    pub fn from(floor: &Floor, sources: &[bool], domain: &[bool], most_m: f64, stop: &Stop) -> Option<Self> {
        let mut least_m = vec![f64::INFINITY; floor.cells()];
        // As far as two points are nearer to each other than the middles of their cells.
        let off_m = SQRT_2 * floor.cell_m();
        let mut starts = vec![f64::INFINITY; floor.cells()];
        let mut next = BinaryHeap::new();
        let is_source = |cell: usize| sources[cell] && domain[cell];
        for cell in (0..floor.cells()).filter(|cell| is_source(*cell)) {
            least_m[cell] = 0.0;
            // A way from inside of the sources leaves them at one of their edges.
            if floor.around(cell).any(|other| domain[other] && !sources[other]) {
                starts[cell] = 0.0;
                next.push(HeapEntry(0.0, cell));
            }
        }
        let mut disc = Disc::new(floor, domain);
        let mut discs = 0_usize;
        while let Some(HeapEntry(far, cell)) = next.pop() {
            if far > starts[cell] || far >= least_m[cell] + off_m {
                continue;
            }
            discs += 1;
            if discs.is_multiple_of(BETWEEN_LOOKS) && stop.is_due() {
                return None;
            }
            disc.around(floor, domain, cell, |other, apart, leaves| {
                let length = far + (apart - off_m).max(0.0);
                if leaves && length < starts[other] && length < least_m[other] + off_m && length <= most_m {
                    starts[other] = length;
                    next.push(HeapEntry(length, other));
                }
                least_m[other] = least_m[other].min(length);
            });
        }
        for (least, _) in least_m.iter_mut().zip(domain).filter(|(least, inside)| **inside && least.is_finite()) {
            *least = least.min(most_m);
        }
        // Where no way led so far, one that is longer may.
        if most_m.is_finite() {
            let farther = least_m.iter_mut().zip(domain).filter(|(least, inside)| **inside && least.is_infinite());
            farther.for_each(|(least, _)| *least = most_m);
        }
        Some(Self { floor: floor.clone(), least_m })
    }

    /// A lower bound for a cell, m; infinite where no way leads.
    #[must_use]
    pub fn at(&self, cell: usize) -> f64 {
        self.least_m[cell]
    }

    /// The bounds of all cells, m.
    #[must_use]
    pub fn all(&self) -> &[f64] {
        &self.least_m
    }

    /// The least within the square of half edge `half_m` around `xy_m`; 0 where that goes beyond the floor's rectangle, of which
    /// nothing is known.
    #[must_use]
    pub fn least(&self, xy_m: [f64; 2], half_m: f64) -> f64 {
        if !self.floor.holds(xy_m, half_m) {
            return 0.0;
        }
        self.floor.within(xy_m, half_m).map(|cell| self.least_m[cell]).fold(f64::INFINITY, f64::min)
    }
}

/// The cells of a disc that are joined to its middle.
struct Disc {
    /// By cell, the last middle that it was met from, and that count.
    met: Vec<usize>,
    count: usize,
    pending: Vec<(usize, usize)>,
    /// Lengths by how many columns and rows apart two cells are, m; as many of each as it takes to leave a disc.
    apart_m: Vec<f64>,
    width: usize,
    /// What is told of a disc in which nothing is in the way: how much farther in the list of all cells, how far apart, m, and whether it
    /// is outside of the disc.
    open: Vec<(isize, f64, bool)>,
    closed: Closed,
}

/// How many cells of a floor are outside of a domain.
struct Closed {
    size: [usize; 2],
    /// In the rectangle of all columns and rows before these.
    before: Vec<u32>,
}

impl Closed {
    fn new([columns, rows]: [usize; 2], domain: &[bool]) -> Self {
        let mut before = vec![0; (columns + 1) * (rows + 1)];
        for row in 0..rows {
            let mut in_row = 0;
            for column in 0..columns {
                in_row += u32::from(!domain[row * columns + column]);
                before[(row + 1) * (columns + 1) + column + 1] = before[row * (columns + 1) + column + 1] + in_row;
            }
        }
        Self { size: [columns, rows], before }
    }

    /// Whether the square of so many cells to each side of one is on the floor, and all of it in the domain.
    fn none_near(&self, [column, row]: [usize; 2], far: usize) -> bool {
        let [columns, rows] = self.size;
        if column < far || row < far || column + far >= columns || row + far >= rows {
            return false;
        }
        let before = |row: usize, column: usize| self.before[row * (columns + 1) + column];
        let (top, right) = (row + far + 1, column + far + 1);
        before(top, right) + before(row - far, column - far) == before(top, column - far) + before(row - far, right)
    }
}

impl Disc {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "some ten cells")]
    #[expect(clippy::cast_precision_loss, reason = "some ten cells")]
    fn new(floor: &Floor, domain: &[bool]) -> Self {
        let width = (DISC_M / floor.cell_m()).ceil() as usize + 2;
        let apart = |n: usize| floor.cell_m() * libm::hypot((n % width) as f64, (n / width) as f64);
        let apart_m: Vec<f64> = (0..width * width).map(apart).collect();
        let [columns, _] = floor.size();
        let sides = 1 - width.cast_signed()..width.cast_signed();
        let all = sides.clone().flat_map(|row| sides.clone().map(move |column| (row, column)));
        let told = |(row, column): (isize, isize)| {
            let apart = |row: usize, column: usize| apart_m[row * width + column];
            let (rows, across) = (row.unsigned_abs(), column.unsigned_abs());
            // It is in the disc, or one beside it is.
            let is_told = apart(rows.saturating_sub(1), across.saturating_sub(1)) <= DISC_M && rows + across > 0;
            let far = apart(rows, across);
            is_told.then_some((row * columns.cast_signed() + column, far, far > DISC_M))
        };
        let open = all.filter_map(told).collect();
        let closed = Closed::new(floor.size(), domain);
        Self { met: vec![0; floor.cells()], count: 0, pending: Vec::new(), apart_m, width, open, closed }
    }

    /// Tells of each cell how far its middle is from that of the disc, and whether it is the first outside of it.
    fn around(&mut self, floor: &Floor, domain: &[bool], middle: usize, mut tell: impl FnMut(usize, f64, bool)) {
        let [columns, rows] = floor.size();
        let (column, row) = (middle % columns, middle / columns);
        count_work(self.open.len() / 4);
        if self.closed.none_near([column, row], self.width - 1) {
            self.open
                .iter()
                .for_each(|(other, apart, leaves)| tell(middle.wrapping_add_signed(*other), *apart, *leaves));
            return;
        }
        self.count += 1;
        self.met[middle] = self.count;
        self.pending.push((column, row));
        while let Some((at_column, at_row)) = self.pending.pop() {
            for other_row in at_row.saturating_sub(1)..(at_row + 2).min(rows) {
                for other_column in at_column.saturating_sub(1)..(at_column + 2).min(columns) {
                    let other = other_row * columns + other_column;
                    if !domain[other] || self.met[other] == self.count {
                        continue;
                    }
                    self.met[other] = self.count;
                    let apart = self.apart_m[other_row.abs_diff(row) * self.width + other_column.abs_diff(column)];
                    tell(other, apart, apart > DISC_M);
                    if apart <= DISC_M {
                        self.pending.push((other_column, other_row));
                    }
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Cuboid, Rotation, Vec3};
    use crate::human::{Anthropometry, Body};
    use crate::sample;
    use crate::search::Rng;

    fn floor(obstacles: &[Cuboid], cell_m: f64) -> Floor {
        Floor::new(
            &Body::new(&Anthropometry::default()).unwrap(),
            obstacles,
            ([-3.0, -3.0], [3.0, 3.0]),
            cell_m,
            &Stop::default(),
        )
        .unwrap()
    }

    fn open(floor: &Floor) -> Vec<bool> {
        (0..floor.cells()).map(|cell| floor.is_open(cell)).collect()
    }

    /// The whole of it.
    fn whole(floor: &Floor, sources: &[bool], domain: &[bool], most_m: f64) -> DistanceField {
        DistanceField::from(floor, sources, domain, most_m, &Stop::default()).unwrap()
    }

    fn only(floor: &Floor, xy_m: [f64; 2]) -> Vec<bool> {
        let cell = floor.within(xy_m, 0.0).next().unwrap();
        (0..floor.cells()).map(|other| other == cell).collect()
    }

    fn wall(from: [f64; 2], to: [f64; 2]) -> Cuboid {
        let half = Vec3::new(0.5 * (to[0] - from[0]), 0.5 * (to[1] - from[1]), 1.0);
        let centre = Vec3::new(0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1]), 1.0);
        Cuboid { centre, half, rotation: Rotation::IDENTITY }
    }

    #[test]
    fn where_nothing_is_in_the_way_it_is_the_straight_line_less_a_little() {
        if !sample::is_turn(1, 6) {
            return;
        }
        let floor = floor(&[], 0.025);
        let field = whole(&floor, &only(&floor, [0.01, 0.01]), &open(&floor), f64::INFINITY);
        for angle in 0..24 {
            for far in [0.1, 0.5, 0.99, 1.5, 2.7] {
                let (sin, cos) = libm::sincos(f64::from(angle) * 0.27);
                let told = field.least([0.01 + far * cos, 0.01 + far * sin], 0.0);
                assert!(told <= far, "{told} for {far}");
                assert!(told >= 0.96 * far - 2.0 * SQRT_2 * 0.025, "{told} for {far}");
            }
        }
    }

    /// A disc in which nothing is in the way tells the same as one that is gone through cell by cell.
    #[test]
    fn an_open_disc_is_as_if_gone_through_by_cells() {
        for cell_m in [0.05, 0.07, 0.3] {
            let floor = floor(&[], cell_m);
            let domain = open(&floor);
            let middle = floor.within([0.01, 0.01], 0.0).next().unwrap();
            let mut disc = Disc::new(&floor, &domain);
            let told = |disc: &mut Disc| {
                let mut told = Vec::new();
                disc.around(&floor, &domain, middle, |other, apart, leaves| {
                    told.push((other, apart.to_bits(), leaves))
                });
                told.sort_unstable();
                told
            };
            let at_once = told(&mut disc);
            disc.closed = Closed::new(floor.size(), &vec![false; floor.cells()]);
            assert!(at_once.len() > 20 && disc.count == 0, "{}", at_once.len());
            assert_eq!(told(&mut disc), at_once, "{cell_m}");
            assert_eq!(disc.count, 1);
            // A single cell that is closed counts, to the edge of the square and no farther.
            let [columns, _] = floor.size();
            let far = disc.width - 1;
            for (off, is_near) in [(far, true), (far + 1, false)] {
                let mut domain = vec![true; floor.cells()];
                domain[middle + off] = false;
                let closed = Closed::new(floor.size(), &domain);
                assert_eq!(closed.none_near([middle % columns, middle / columns], far), !is_near, "{off}");
            }
        }
    }

    /// The same with a disc around every cell that leaves one.
    fn by_all_discs(floor: &Floor, sources: &[bool], domain: &[bool]) -> Vec<f64> {
        let off_m = SQRT_2 * floor.cell_m();
        let mut least_m: Vec<f64> = sources.iter().map(|own| if *own { 0.0 } else { f64::INFINITY }).collect();
        let mut starts = least_m.clone();
        let mut next: BinaryHeap<HeapEntry> =
            (0..floor.cells()).filter(|cell| sources[*cell]).map(|cell| HeapEntry(0.0, cell)).collect();
        let mut disc = Disc::new(floor, domain);
        while let Some(HeapEntry(far, cell)) = next.pop() {
            if far <= starts[cell] {
                disc.around(floor, domain, cell, |other, apart, leaves| {
                    let length = far + (apart - off_m).max(0.0);
                    least_m[other] = least_m[other].min(length);
                    if leaves && length < starts[other] {
                        starts[other] = length;
                        next.push(HeapEntry(length, other));
                    }
                });
            }
        }
        least_m
    }

    /// Where nothing is in the way, cells that begin no disc would not have told anything less.
    #[test]
    fn who_begins_none_would_tell_nothing_less() {
        let floor = floor(&[], 0.15);
        let domain = open(&floor);
        let mut rng = Rng::new(23);
        for _ in 0..4 {
            let sources: Vec<bool> = (0..floor.cells()).map(|_| rng.below(400) == 0).collect();
            let (told, all) =
                (whole(&floor, &sources, &domain, f64::INFINITY), by_all_discs(&floor, &sources, &domain));
            for (cell, least) in all.into_iter().enumerate() {
                assert!(
                    (told.at(cell) - least).abs() < 1e-9,
                    "{} and {least} at {:?}",
                    told.at(cell),
                    floor.middle(cell)
                );
            }
        }
    }

    /// Random walks among random walls: none is shorter than what is told of the cells that it passes.
    #[test]
    fn no_walk_is_shorter() {
        let mut rng = Rng::new(41);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let (mut far, mut near) = (0, 0);
        for _ in 0..6 {
            let walls: Vec<Cuboid> = (0..5)
                .map(|_| {
                    let at = [uniform(-2.0, 1.5), uniform(-2.0, 1.5)];
                    let to = if uniform(0.0, 1.0) < 0.5 { [0.02, 1.2] } else { [1.2, 0.02] };
                    wall(at, [at[0] + to[0], at[1] + to[1]])
                })
                .collect();
            let floor = floor(&walls, 0.05);
            let (domain, from) = (open(&floor), [uniform(-2.0, 2.0), uniform(-2.0, 2.0)]);
            let field = whole(&floor, &only(&floor, from), &domain, f64::INFINITY);
            for _ in 0..60 {
                let (mut at, mut walked, mut heading) = (from, 0.0, uniform(0.0, 6.3));
                let on_floor = |at: [f64; 2]| floor.within(at, 0.0).next().is_some_and(|cell| domain[cell]);
                for _ in 0..900 {
                    heading += uniform(-0.3, 0.3);
                    let (sin, cos) = libm::sincos(heading);
                    let next = [at[0] + 0.01 * cos, at[1] + 0.01 * sin];
                    if !on_floor(next) {
                        heading += 1.0;
                        continue;
                    }
                    (at, walked) = (next, walked + 0.01);
                    let told = field.least(at, 0.0);
                    assert!(told <= walked, "{told} after {walked} at {at:?}");
                    far += usize::from(told > 1.2);
                    near += usize::from(told > 0.85 * walked - 0.1);
                }
            }
        }
        assert!(far > 1000 && near > 1000, "{far} {near}");
    }

    /// Behind a wall of 4 m, the way leads round one of its ends.
    #[test]
    fn ways_lead_round_walls_and_none_through_closed_ones() {
        if !sample::is_turn(5, 6) {
            return;
        }
        let floor_of = floor(&[wall([-2.0, -0.01], [2.0, 0.01])], 0.025);
        let field = whole(&floor_of, &only(&floor_of, [0.0, -0.3]), &open(&floor_of), f64::INFINITY);
        let round = 2.0 * libm::hypot(2.0, 0.3);
        let told = field.least([0.0, 0.3], 0.0);
        assert!(told <= round && told > 0.75 * round, "{told} for {round}");
        let shut = floor(&[wall([-3.1, -0.01], [3.1, 0.01])], 0.025);
        let field = whole(&shut, &only(&shut, [0.0, -0.3]), &open(&shut), f64::INFINITY);
        assert!(field.least([0.0, 0.3], 0.1).is_infinite());
    }

    /// Who has no time is told nothing. How much is done between two looks at the clock, all tests count.
    #[test]
    fn nothing_half_done_is_told() {
        let floor = floor(&[], 0.05);
        let (sources, domain, stop) = (only(&floor, [0.0, 0.0]), open(&floor), Stop::default());
        let made = || DistanceField::from(&floor, &sources, &domain, f64::INFINITY, &stop);
        assert!(made().is_some());
        stop.ask();
        assert!(made().is_none());
    }

    /// Beyond the rectangle nothing is known, and of ways that are longer than asked for only that they are.
    #[test]
    fn what_is_beyond_the_rectangle_or_farther_than_asked_for_is_not_excluded() {
        let shut = floor(&[wall([-3.1, -0.01], [3.1, 0.01])], 0.05);
        let field = whole(&shut, &only(&shut, [0.0, -1.0]), &open(&shut), 0.8);
        assert!(
            (field.least([0.0, -2.5], 0.0) - 0.8).abs() < 1e-12 && (field.least([0.0, 1.0], 0.0) - 0.8).abs() < 1e-12
        );
        assert!(field.least([0.0, -1.6], 0.0) < 0.6 && field.least([0.0, 0.0], 0.0).is_infinite());
        assert!(field.least([3.2, -1.0], 0.0) <= 0.0 && field.least([2.9, -1.0], 0.2) <= 0.0);
    }

    /// Length of the shortest way between two places past rectangles, none of which it enters: from corner to corner.
    fn shortest(from: [f64; 2], to: [f64; 2], rectangles: &[[f64; 4]]) -> f64 {
        let corners = rectangles.iter().flat_map(|&[a, b, c, d]| [[a, b], [c, b], [c, d], [a, d]]);
        let points: Vec<[f64; 2]> = [from, to].into_iter().chain(corners).collect();
        let apart = |[a, b]: [f64; 2], [c, d]: [f64; 2]| libm::hypot(c - a, d - b);
        let enters = |p: [f64; 2], q: [f64; 2], &[a, b, c, d]: &[f64; 4]| {
            // Between where it comes in and goes out by x and by y.
            let (low, high) = ([a, b], [c, d]);
            let (mut first, mut last) = (0.0_f64, 1.0_f64);
            for axis in 0..2 {
                let (at, by) = (p[axis], q[axis] - p[axis]);
                if by.abs() < 1e-12 {
                    if at <= low[axis] + 1e-9 || at >= high[axis] - 1e-9 {
                        return false;
                    }
                    continue;
                }
                let (s, e) = ((low[axis] - at) / by, (high[axis] - at) / by);
                (first, last) = (first.max(s.min(e)), last.min(s.max(e)));
            }
            first < last - 1e-9
        };
        let mut least = vec![f64::INFINITY; points.len()];
        let mut left: Vec<usize> = (0..points.len()).collect();
        least[0] = 0.0;
        while let Some(number) = (0..left.len()).min_by(|a, b| least[left[*a]].total_cmp(&least[left[*b]])) {
            let at = left.swap_remove(number);
            for &other in &left {
                if !rectangles.iter().any(|rectangle| enters(points[at], points[other], rectangle)) {
                    least[other] = least[other].min(least[at] + apart(points[at], points[other]));
                }
            }
        }
        least[1]
    }

    /// Against exact shortest ways past random boxes of whole cells: never more, and not much less.
    #[test]
    fn shortest_ways_past_boxes_are_no_shorter_and_hardly_longer() {
        let mut rng = Rng::new(17);
        let all = floor(&[], 0.05);
        let (mut round, mut told_m, mut true_m) = (0, 0.0, 0.0);
        for _ in 0..12 {
            // Edges are edges of cells; some boxes meet in corners, none along an edge: no way leads between those.
            let mut edge = || 0.05 * f64::from(u32::try_from(20 + rng.below(60)).unwrap()) - 3.0;
            let mut boxes: Vec<[f64; 4]> = Vec::new();
            while boxes.len() < 6 {
                let (x, y, number) = (edge(), edge(), u8::try_from(boxes.len()).unwrap());
                let (long, short) = (0.05 * f64::from(20 + number), 0.05 * f64::from(2 + number));
                let own = if number % 2 == 0 { [x, y, x + long, y + short] } else { [x, y, x + short, y + long] };
                let apart =
                    |other: &[f64; 4], axis: usize| (own[axis] - other[axis + 2]).max(other[axis] - own[axis + 2]);
                let beside = |other: &[f64; 4]| {
                    let gaps = [apart(other, 0), apart(other, 1)];
                    gaps.iter().any(|gap| gap.abs() < 1e-9) && gaps.iter().any(|gap| *gap < -1e-9)
                };
                if !boxes.iter().any(beside) {
                    boxes.push(own);
                }
            }
            let is_in = |[x, y]: [f64; 2]| boxes.iter().any(|&[a, b, c, d]| a < x && x < c && b < y && y < d);
            let domain: Vec<bool> = (0..all.cells()).map(|cell| !is_in(all.middle(cell))).collect();
            let mut place = || loop {
                let cell = rng.below(all.cells());
                if domain[cell] {
                    break all.middle(cell);
                }
            };
            let from = place();
            let field = whole(&all, &only(&all, from), &domain, f64::INFINITY);
            for _ in 0..25 {
                let to = place();
                let (told, length) = (field.least(to, 0.0), shortest(from, to, &boxes));
                assert!(told <= length + 1e-9, "{told} for {length} from {from:?} to {to:?} past {boxes:?}");
                (told_m, true_m) = (told_m + told, true_m + length.min(20.0));
                round += usize::from(length > 1.05 * libm::hypot(to[0] - from[0], to[1] - from[1]));
            }
        }
        assert!(round > 20 && told_m > 0.85 * true_m, "{round} {told_m} of {true_m}");
    }
}
