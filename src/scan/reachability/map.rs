//! What a map of the floor shows: where people can be, what robots sweep, and in each cell of it how hard and when somebody is hit.

use std::collections::{BTreeMap, BTreeSet};

use super::refusal;
use crate::geometry::Vec3;
use crate::geometry::distance::point_segment;
use crate::geometry::polygon::contains;
use crate::reachability::{CELL_M, Moment, ReachabilitySearch as Search, told_in};
use crate::record::reachability::{Cell, Ground};
use crate::report::top_view::LinkFootprint;
use crate::scan::footprint::part;
use crate::scan::prepare::Prepared;
use crate::sim::robot::RobotFrame;
use crate::stop::Stop;

/// Spans of time are this long, s, or longer: no more of them than [`MOST_SPANS`].
const SPAN_S: f64 = 0.1;
const MOST_SPANS: f64 = 60.0;
/// Instants of which the robots are drawn, about.
const DRAWN: usize = 200;
/// Floor is told this far beyond what is looked at, m.
const BEYOND_M: f64 = 5.0;

/// How many communication steps a span of time has.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an hour of small steps at most")]
pub(super) fn span(until_s: f64, step_s: f64) -> usize {
    // What rounding does to a whole number of steps makes no step more.
    ((SPAN_S.max(until_s / MOST_SPANS) / step_s - 1e-6).ceil() as usize).max(1)
}

/// How long that is, s.
#[expect(clippy::cast_precision_loss, reason = "an hour of small steps at most")]
pub(super) fn span_s(until_s: f64, step_s: f64) -> f64 {
    span(until_s, step_s) as f64 * step_s
}

/// The cells of the floor in which somebody is harmed: the worst that was tried there, the earliest, and the worst of each span of so
/// many steps; of each moment is told whether somebody unseen is hit.
pub(super) fn hazardous(moments: &[(Moment, bool)], span: usize, step_s: f64) -> Vec<Cell> {
    let mut by: BTreeMap<[i64; 2], (bool, BTreeMap<usize, Moment>)> = BTreeMap::new();
    for (moment, is_unseen) in moments {
        let (unseen, spans) = by.entry(told_in(moment.xy_m)).or_default();
        *unseen |= *is_unseen;
        let known = spans.entry(moment.step.saturating_sub(1) / span).or_insert(*moment);
        known.ratio = known.ratio.max(moment.ratio);
        known.step = known.step.min(moment.step);
    }
    #[expect(clippy::cast_precision_loss, reason = "an hour of small steps at most")]
    let cell = |(cell, (unseen, spans)): ([i64; 2], (bool, BTreeMap<usize, Moment>))| Cell {
        unseen,
        xy_m: middle(cell),
        ratio: spans.values().map(|moment| moment.ratio).fold(0.0, f64::max),
        earliest_s: spans.values().map(|moment| moment.step).min().unwrap_or_default() as f64 * step_s,
        spans: spans.into_iter().map(|(number, moment)| (number, rounded(moment.ratio))).collect(),
    };
    by.into_iter().map(cell).collect()
}

/// Floor on which people can be.
#[derive(Clone, Debug, Default)]
pub(super) struct Walkable {
    /// Cells as they are told.
    pub cells: BTreeSet<[i64; 2]>,
    /// What is farther out, as rectangles by low x and y and high x and y, m.
    pub beyond_m: Vec<[f64; 4]>,
}

impl Walkable {
    /// Whether there is none, or none was looked for.
    pub(crate) fn is_empty(&self) -> bool {
        self.cells.is_empty() && self.beyond_m.is_empty()
    }
}

/// The floor on which people can be; nothing, where there is no time for it.
pub(super) fn walkable(search: &Search<'_>, stop: &Stop) -> Option<Walkable> {
    let (floor, unseen, watched) = search.ground();
    // A cell may lie in several of those that are told.
    let half = 0.499 * floor.cell_m();
    let mut cells = BTreeSet::new();
    for cell in (0..floor.cells()).filter(|cell| unseen[*cell] || watched[*cell]) {
        if stop.is_due() {
            return None;
        }
        let [low, high] = [-half, half].map(|by| told_in(floor.middle(cell).map(|at| at + by)));
        let row = |row: i64| (low[0]..=high[0]).map(move |column| [column, row]);
        cells.extend((low[1]..=high[1]).flat_map(row));
    }
    let beyond_m = floor.beyond(BEYOND_M).into_iter().map(|sides| sides.map(rounded)).collect();
    Some(Walkable { cells, beyond_m })
}

/// Cells of the floor, as they are told, as rectangles: runs of a row, and equal ones above each other as one.
pub(super) fn rectangles(cells: &BTreeSet<[i64; 2]>) -> Vec<[f64; 4]> {
    let mut rows: BTreeMap<i64, Vec<[i64; 2]>> = BTreeMap::new();
    let by_row: BTreeSet<[i64; 2]> = cells.iter().map(|[column, row]| [*row, *column]).collect();
    for [row, column] in by_row {
        let runs = rows.entry(row).or_default();
        match runs.last_mut() {
            Some([_, to]) if *to == column => *to += 1,
            _ => runs.push([column, column + 1]),
        }
    }
    // Columns from and to, rows from and to.
    let mut all: Vec<[i64; 4]> = Vec::new();
    let mut growing: BTreeMap<[i64; 2], usize> = BTreeMap::new();
    for (row, runs) in rows {
        let mut now = BTreeMap::new();
        for run in runs {
            let below = growing.get(&run).copied().filter(|number| all[*number][3] == row);
            let number = below.unwrap_or(all.len());
            match below {
                Some(number) => all[number][3] += 1,
                None => all.push([run[0], run[1], row, row + 1]),
            }
            now.insert(run, number);
        }
        growing = now;
    }
    #[expect(clippy::cast_precision_loss, reason = "some thousand cells to a side")]
    let at = |number: i64| rounded(number as f64 * 2.0 * CELL_M);
    all.into_iter().map(|[left, right, low, high]| [at(left), at(low), at(right), at(high)]).collect()
}

/// The middle of a cell of the floor as it is told, m.
#[expect(clippy::cast_precision_loss, reason = "some thousand cells to a side")]
pub(super) fn middle(cell: [i64; 2]) -> [f64; 2] {
    cell.map(|at| (at as f64 + 0.5) * 2.0 * CELL_M)
}

/// The floor, with what the robots sweep at some instants; nothing, where there is no time for it.
pub(crate) fn ground(search: &Search<'_>, frames: &[RobotFrame], stop: &Stop) -> Option<Ground> {
    let (floor, unseen, watched) = search.ground();
    let mut swept = vec![false; unseen.len()];
    for frame in frames.iter().step_by(frames.len().div_ceil(DRAWN).max(1)) {
        for link in &frame.links {
            if stop.is_due() {
                return None;
            }
            let (centre, radius) = link.bounding_sphere();
            let part = part(link);
            for cell in floor.within([centre.x, centre.y], radius) {
                swept[cell] = swept[cell] || covers(&part, floor.middle(cell));
            }
        }
    }
    let rectangles = |cells: &[bool]| floor.rectangles(cells);
    let told = |all: Vec<[f64; 4]>| all.into_iter().map(|sides| sides.map(rounded)).collect();
    // What sensors inside the FMU see beyond was not asked.
    let beyond = if search.is_told() { Vec::new() } else { floor.beyond(BEYOND_M) };
    Some(Ground {
        unseen_m: told([rectangles(&unseen), beyond].concat()),
        watched_m: told(rectangles(&watched)),
        swept_m: told(rectangles(&swept)),
    })
}

/// The floor on which people may be whom no sensor has seen; none where nobody can be looked for anywhere, or there is no time for it.
pub(crate) fn unseen(prepared: &Prepared, frames: &[RobotFrame]) -> Vec<[f64; 4]> {
    // Where sensors inside the FMU see people only a scan asks.
    if refusal(prepared).is_some() || !prepared.cell.pose.is_empty() {
        return Vec::new();
    }
    let search = Search::new(&prepared.cell, frames.iter(), 0.0, prepared.stop());
    search.and_then(|search| ground(&search, &[], &prepared.stop())).map(|ground| ground.unseen_m).unwrap_or_default()
}

fn covers(part: &LinkFootprint, at: [f64; 2]) -> bool {
    match part {
        LinkFootprint::Capsule(a, b, radius) => {
            let flat = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
            point_segment(flat(at), flat(*a), flat(*b)).distance <= *radius
        }
        LinkFootprint::Outline(points) => contains(points, at),
    }
}

/// To a thousandth: what a picture shows.
fn rounded(value: f64) -> f64 {
    (value * 1000.0).round() / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn cells_are_told_as_few_rectangles_that_hold_them_and_nothing_else() {
        let holes = |[column, row]: &[i64; 2]| (column * 7 + row * 3) % 11 != 0 && !(-3..4).contains(column);
        let some: BTreeSet<[i64; 2]> =
            (-20..20).flat_map(|column| (-9..9).map(move |row| [column, row])).filter(holes).collect();
        let told = rectangles(&some);
        for (column, row) in (-21..21).flat_map(|column| (-10..10).map(move |row| (column, row))) {
            let [x, y] = middle([column, row]);
            let holds = |[left, low, right, high]: &&[f64; 4]| *left < x && x < *right && *low < y && y < *high;
            assert_eq!(told.iter().filter(holds).count(), usize::from(some.contains(&[column, row])), "{column} {row}");
        }
        // By hand: 400 m² but for one cell are four: below it, beside it on both sides, and above.
        let mut all: BTreeSet<[i64; 2]> = (0..200).flat_map(|column| (0..200).map(move |row| [column, row])).collect();
        assert_eq!(rectangles(&all), [[0.0, 0.0, 20.0, 20.0]]);
        all.remove(&[50, 70]);
        let four = [[0.0, 0.0, 20.0, 7.0], [0.0, 7.0, 5.0, 7.1], [5.1, 7.0, 20.0, 7.1], [0.0, 7.1, 20.0, 20.0]];
        assert_eq!(rectangles(&all), four);
    }

    #[test]
    fn spans_are_whole_steps_and_not_too_many() {
        assert_eq!([span(4.0, 0.02), span(4.0, 0.03), span(4.0, 0.5)], [5, 4, 1]);
        assert_eq!(span(60.0, 0.02), 50);
    }

    #[test]
    fn a_cell_tells_its_worst_its_earliest_and_the_worst_of_each_span() {
        let moment = |x: f64, step, ratio, unseen| (Moment { xy_m: [x, -0.42], step, ratio }, unseen);
        let all = [
            moment(0.31, 7, 1.2, true),
            moment(0.39, 9, 1.5, false),
            moment(0.35, 21, 1.1, false),
            moment(0.41, 5, 1.04, false),
        ];
        let cells = hazardous(&all, 5, 0.02);
        let about = |a: f64, b: f64| (a - b).abs() < 1e-9;
        assert_eq!([cells[0].unseen, cells[1].unseen], [true, false]);
        assert_eq!(cells.len(), 2);
        assert!(about(cells[0].xy_m[0], 0.35) && about(cells[0].xy_m[1], -0.45));
        assert!(about(cells[0].ratio, 1.5) && about(cells[0].earliest_s, 0.14));
        // Steps 6 to 10 are the second span, those up to 5 the first.
        assert_eq!(cells[0].spans, [(1, 1.5), (4, 1.1)]);
        assert_eq!(cells[1].spans, [(0, 1.04)]);
    }
}
