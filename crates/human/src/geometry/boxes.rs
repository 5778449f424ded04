//! Bodies as boxes that lie inside them: what only boxes can be asked may then be asked of any body, and nothing is
//! filled that the body does not fill.
//!
//! A body that is a box becomes that box. Others are cut into cells along their flat faces, finer where no face is, and
//! the cells that lie wholly inside are joined to boxes as large as possible, which may overlap: gaps between boxes would
//! have to be proved closed wherever that matters.

use std::collections::{BTreeMap, BTreeSet};

use super::surface::{Surface, Triangles};
use super::triangle::{Corners, normal};
use super::{Cuboid, Matrix3, Rotation, Vec3};

/// The thickness that flat parts get, m.
const SHEET_M: f64 = 0.002;

/// How far a box may stand out from the body that it stands for, at most, and as a part of its shortest edge: rounded
/// edges and dents. An opening goes all the way through.
const DENT_M: f64 = 0.001;
const DENT_PART: f64 = 0.05;

/// Of its volume a box has to be there, at least.
const FULL: f64 = 0.85;

/// Points this near to a plane are on it, m.
const ON_PLANE_M: f64 = 1e-6;

/// Cells are looked at this much smaller, m: faces along which they are cut do not pass through them.
const SHRUNK_M: f64 = 1e-6;

/// Most cells of a body, and most pairs of triangle and cell that are looked at.
const MOST_CELLS: usize = 1_000_000;
const MOST_PAIRS: usize = 50_000_000;

/// Most faces along which a body is cut, in each direction.
const MOST_CUTS: usize = 60;

/// Of how many of the largest faces the directions are tried.
const LARGEST: usize = 12;

/// Filling a body takes too many cells, or boxes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooMany;

/// Parts that have no corner in common, in the order of their first triangles.
#[must_use]
pub fn parts(all: &Triangles) -> Vec<Triangles> {
    fn root(of: &mut [u32], mut corner: u32) -> u32 {
        while of[corner as usize] != corner {
            of[corner as usize] = of[of[corner as usize] as usize];
            corner = of[corner as usize];
        }
        corner
    }
    let mut of: Vec<u32> = (0u32..).take(all.points.len()).collect();
    for [a, b, c] in &all.triangles {
        for other in [b, c] {
            let (one, other) = (root(&mut of, *a), root(&mut of, *other));
            of[one.max(other) as usize] = one.min(other);
        }
    }
    let mut order: Vec<u32> = Vec::new();
    let mut members: BTreeMap<u32, Vec<[u32; 3]>> = BTreeMap::new();
    for triangle in &all.triangles {
        let root = root(&mut of, triangle[0]);
        let list = members.entry(root).or_default();
        if list.is_empty() {
            order.push(root);
        }
        list.push(*triangle);
    }
    order.iter().filter_map(|root| members.get(root)).map(|list| Triangles::merged(&all.points, list)).collect()
}

/// Directions of a body's largest faces and their edges, `body_from_axes`: in one of these a box stands upright.
fn frames(body: &Triangles) -> Vec<Rotation> {
    let mut faces: Vec<(f64, usize)> =
        (0..body.triangles.len()).map(|number| (normal(&body.corners(number)).length(), number)).collect();
    faces.sort_by(|a, b| b.0.total_cmp(&a.0).then(a.1.cmp(&b.1)));
    let mut frames = Vec::new();
    for (_, number) in faces.into_iter().take(LARGEST) {
        let corners = body.corners(number);
        let Some(z) = normal(&corners).try_normalize() else { continue };
        for k in 0..3 {
            let edge = corners[(k + 1) % 3] - corners[k];
            let Some(x) = (edge - z * edge.dot(z)).try_normalize() else { continue };
            frames.push(Rotation::from_mat3(&Matrix3::from_cols(x, z.cross(x), z)).normalize());
        }
    }
    frames
}

/// Least and greatest coordinates along axes.
fn extent(body: &Triangles, body_from_axes: Rotation) -> (Vec3, Vec3) {
    let axes_from_body = body_from_axes.inverse();
    let start = (Vec3::splat(f64::INFINITY), Vec3::splat(f64::NEG_INFINITY));
    body.points.iter().map(|point| axes_from_body * *point).fold(start, |(low, high), p| (low.min(p), high.max(p)))
}

/// The box that a body is, if it is one: closed, with every triangle in one of the box's faces; or flat, a rectangle.
#[must_use]
pub fn as_box(body: &Triangles) -> Option<Cuboid> {
    let closed = body.closed().is_ok();
    frames(body).into_iter().find_map(|frame| {
        let (low, high) = extent(body, frame);
        let size = high - low;
        let same = if closed { is_box(body, frame, low, high) } else { is_rectangle(body, frame, low, high) };
        // Both sides of a folded sheet may be near the faces of the box around it: there has to be something in between.
        let same = same && (!closed || body.volume().abs() >= FULL * size.element_product());
        let half = if closed { size * 0.5 } else { (size * 0.5).with_z(0.5 * SHEET_M) };
        same.then(|| Cuboid { centre: frame * ((low + high) * 0.5), half, rotation: frame })
    })
}

/// Whether a closed surface is the surface of a box: as it is closed, it goes all the way round.
fn is_box(body: &Triangles, frame: Rotation, low: Vec3, high: Vec3) -> bool {
    let near = DENT_M.min(DENT_PART * (high - low).min_element());
    let axes_from_body = frame.inverse();
    near > 0.0
        && (0..body.triangles.len()).all(|number| {
            let corners = body.corners(number).map(|corner| axes_from_body * corner);
            let on = |distance: &dyn Fn(Vec3) -> Vec3| {
                let [a, b, c] = corners.map(distance);
                a.max(b).max(c).min_element() <= near
            };
            on(&|p| p - low) || on(&|p| high - p)
        })
}

/// Whether triangles in one plane fill a rectangle: each line inside has as many on one side as on the other, so that what
/// is covered ends only at the rectangle's sides.
fn is_rectangle(body: &Triangles, frame: Rotation, low: Vec3, high: Vec3) -> bool {
    let size = high - low;
    if size.z > ON_PLANE_M || size.x <= ON_PLANE_M || size.y <= ON_PLANE_M {
        return false;
    }
    let mut alone: BTreeSet<[u32; 2]> = BTreeSet::new();
    let mut known: BTreeSet<[u32; 3]> = BTreeSet::new();
    for triangle in &body.triangles {
        let mut sorted = *triangle;
        sorted.sort_unstable();
        // Both sides of a sheet may be there.
        if !known.insert(sorted) {
            continue;
        }
        let [a, b, c] = sorted;
        for edge in [[a, b], [b, c], [a, c]] {
            if !alone.remove(&edge) {
                alone.insert(edge);
            }
        }
    }
    let axes_from_body = frame.inverse();
    let on_side = |edge: &[u32; 2]| {
        let [a, b] = edge.map(|corner| axes_from_body * body.points[corner as usize]);
        let near = |distance: Vec3| distance.truncate().min_element() <= ON_PLANE_M;
        near((a - low).max(b - low)) || near((high - a).max(high - b))
    };
    !alone.is_empty() && alone.iter().all(on_side)
}

/// Cells between planes across three axes.
struct Grid {
    /// `body_from_axes`.
    frame: Rotation,
    /// Where the planes are, rising.
    planes: [Vec<f64>; 3],
    /// How many cells along each axis.
    count: [usize; 3],
}

impl Grid {
    fn index(&self, [i, j, k]: [usize; 3]) -> usize {
        (k * self.count[1] + j) * self.count[0] + i
    }

    fn low(&self, cell: [usize; 3]) -> Vec3 {
        Vec3::from_array([0, 1, 2].map(|axis| self.planes[axis][cell[axis]]))
    }

    /// The box from one cell up to before another.
    fn cuboid(&self, from: [usize; 3], to: [usize; 3]) -> Cuboid {
        let (low, high) = (self.low(from), self.low(to));
        Cuboid { centre: self.frame * ((low + high) * 0.5), half: (high - low) * 0.5, rotation: self.frame }
    }

    /// Cells along an axis that an interval, made longer a little, is part of.
    fn range(&self, axis: usize, low: f64, high: f64) -> std::ops::Range<usize> {
        let planes = &self.planes[axis];
        let from = planes.partition_point(|plane| *plane <= low - SHRUNK_M).saturating_sub(1);
        let to = planes.partition_point(|plane| *plane < high + SHRUNK_M).min(self.count[axis]);
        from..to
    }
}

/// Boxes that lie in a closed body, and the volume that they fill together, m³. Cells have edges of at most
/// `resolution` m.
///
/// # Errors
/// When that takes more cells than can be looked at, or more than `most` boxes.
pub fn inside(surface: &Surface, resolution: f64, most: usize) -> Result<(Vec<Cuboid>, f64), TooMany> {
    let body = surface.triangles();
    let volume = |frame: &Rotation| {
        let (low, high) = extent(body, *frame);
        (high - low).element_product()
    };
    // Upright unless another frame is clearly tighter.
    let tightest = frames(body).into_iter().map(|frame| (volume(&frame), frame)).min_by(|a, b| a.0.total_cmp(&b.0));
    let frame = match tightest {
        Some((tight, frame)) if tight < 0.999 * volume(&Rotation::IDENTITY) => frame,
        _ => Rotation::IDENTITY,
    };
    let grid = grid(body, frame, resolution)?;
    let free = free_cells(body, &grid)?;
    let mut filled = vec![false; free.len()];
    let mut cells = 0.0;
    for k in 0..grid.count[2] {
        for j in 0..grid.count[1] {
            for i in 0..grid.count[0] {
                let (cell, index) = ([i, j, k], grid.index([i, j, k]));
                let cuboid = grid.cuboid(cell, cell.map(|at| at + 1));
                if free[index] && surface.holds(cuboid.centre) {
                    filled[index] = true;
                    cells += 8.0 * cuboid.half.element_product();
                }
            }
        }
    }
    Ok((joined(&grid, &filled, most)?, cells))
}

/// Planes along the flat faces across each axis, the largest first, and others between, no farther apart than told.
fn grid(body: &Triangles, frame: Rotation, resolution: f64) -> Result<Grid, TooMany> {
    let axes_from_body = frame.inverse();
    let (low, high) = extent(body, frame);
    let mut areas: [Vec<(f64, f64)>; 3] = Default::default();
    for number in 0..body.triangles.len() {
        let corners = body.corners(number).map(|corner| axes_from_body * corner);
        let (area, size) =
            (normal(&corners), corners[0].max(corners[1]).max(corners[2]) - corners[0].min(corners[1]).min(corners[2]));
        for (axis, found) in areas.iter_mut().enumerate() {
            if size[axis] <= ON_PLANE_M {
                found.push((corners[0][axis], area[axis].abs()));
            }
        }
    }
    let mut planes: [Vec<f64>; 3] = Default::default();
    for axis in 0..3 {
        let mut found = std::mem::take(&mut areas[axis]);
        found.sort_by(|a, b| a.0.total_cmp(&b.0));
        // Faces in one plane count together.
        let mut faces: Vec<(f64, f64)> = Vec::new();
        for (at, area) in found {
            match faces.last_mut().filter(|last| at - last.0 <= 2.0 * ON_PLANE_M) {
                Some(last) => last.1 += area,
                None => faces.push((at, area)),
            }
        }
        faces.sort_by(|a, b| b.1.total_cmp(&a.1).then(a.0.total_cmp(&b.0)));
        let mut cuts: Vec<f64> = faces.into_iter().take(MOST_CUTS).map(|(at, _)| at).collect();
        cuts.extend([low[axis], high[axis]]);
        cuts.sort_by(f64::total_cmp);
        cuts.dedup_by(|b, a| *b - *a <= 2.0 * ON_PLANE_M);
        for ends in cuts.windows(2) {
            let steps = ((ends[1] - ends[0]) / resolution - 1e-9).ceil().clamp(1.0, 1e6);
            if planes[axis].len() as f64 + steps > 1e6 {
                return Err(TooMany);
            }
            let mut step = 0.0;
            while step < steps {
                planes[axis].push(ends[0] + (ends[1] - ends[0]) * (step / steps));
                step += 1.0;
            }
        }
        planes[axis].extend(cuts.last());
    }
    let count = planes.each_ref().map(|planes| planes.len().saturating_sub(1));
    let cells = count.iter().try_fold(1usize, |all, one| all.checked_mul(*one)).ok_or(TooMany)?;
    if cells > MOST_CELLS { Err(TooMany) } else { Ok(Grid { frame, planes, count }) }
}

/// Cells that no triangle passes through.
fn free_cells(body: &Triangles, grid: &Grid) -> Result<Vec<bool>, TooMany> {
    let axes_from_body = grid.frame.inverse();
    let mut free = vec![true; grid.count.iter().product()];
    let mut pairs = 0;
    for number in 0..body.triangles.len() {
        let corners = body.corners(number).map(|corner| axes_from_body * corner);
        let (low, high) = (corners[0].min(corners[1]).min(corners[2]), corners[0].max(corners[1]).max(corners[2]));
        let [x, y, z] = [0, 1, 2].map(|axis| grid.range(axis, low[axis], high[axis]));
        pairs += x.len() * y.len() * z.len();
        if pairs > MOST_PAIRS {
            return Err(TooMany);
        }
        for k in z {
            for j in y.clone() {
                for i in x.clone() {
                    let (low, high) = (grid.low([i, j, k]), grid.low([i + 1, j + 1, k + 1]));
                    let index = grid.index([i, j, k]);
                    if free[index] && overlap(&corners, (low + high) * 0.5, (high - low) * 0.5 - SHRUNK_M) {
                        free[index] = false;
                    }
                }
            }
        }
    }
    Ok(free)
}

/// Whether a triangle and an upright box overlap: no plane across one of the box's axes, the triangle's normal or an edge
/// of both parts them.
fn overlap(corners: &Corners, centre: Vec3, half: Vec3) -> bool {
    let [a, b, c] = corners.map(|corner| corner - centre);
    let parted = |axis: Vec3| {
        let reach = half.dot(axis.abs());
        let [a, b, c] = [a, b, c].map(|corner| corner.dot(axis));
        a.min(b).min(c) > reach || a.max(b).max(c) < -reach
    };
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    let edges = [b - a, c - b, a - c];
    !(axes.into_iter().any(parted)
        || parted(edges[0].cross(edges[1]))
        || edges.into_iter().any(|edge| axes.into_iter().any(|axis| parted(axis.cross(edge)))))
}

/// Filled cells, counted from the first on, so that those in a box are known at once.
struct Sums<'a> {
    grid: &'a Grid,
    sums: Vec<usize>,
}

impl<'a> Sums<'a> {
    fn new(grid: &'a Grid, filled: &[bool]) -> Self {
        let [nx, ny, nz] = grid.count.map(|count| count + 1);
        let mut this = Self { grid, sums: vec![0; nx * ny * nz] };
        for k in 1..nz {
            for j in 1..ny {
                for i in 1..nx {
                    let own = usize::from(filled[grid.index([i - 1, j - 1, k - 1])]);
                    let more = this.at(i - 1, j, k)
                        + this.at(i, j - 1, k)
                        + this.at(i, j, k - 1)
                        + this.at(i - 1, j - 1, k - 1);
                    let less = this.at(i - 1, j - 1, k) + this.at(i - 1, j, k - 1) + this.at(i, j - 1, k - 1);
                    this.sums[(k * ny + j) * nx + i] = own + more - less;
                }
            }
        }
        this
    }

    fn at(&self, i: usize, j: usize, k: usize) -> usize {
        self.sums[(k * (self.grid.count[1] + 1) + j) * (self.grid.count[0] + 1) + i]
    }

    /// Whether all cells from one up to before another are filled.
    fn full(&self, [a, b, c]: [usize; 3], [d, e, f]: [usize; 3]) -> bool {
        let more = self.at(d, e, f) + self.at(a, b, f) + self.at(a, e, c) + self.at(d, b, c);
        let less = self.at(a, e, f) + self.at(d, b, f) + self.at(d, e, c) + self.at(a, b, c);
        more - less == (d - a) * (e - b) * (f - c)
    }
}

/// Boxes that cover the filled cells and no others: from the first cell that is not covered, as far as the cells go, in
/// the order of axes that gives the largest.
fn joined(grid: &Grid, filled: &[bool], most: usize) -> Result<Vec<Cuboid>, TooMany> {
    let sums = Sums::new(grid, filled);
    let mut open = filled.to_vec();
    let mut boxes = Vec::new();
    for k in 0..grid.count[2] {
        for j in 0..grid.count[1] {
            for i in 0..grid.count[0] {
                if !open[grid.index([i, j, k])] {
                    continue;
                }
                if boxes.len() == most {
                    return Err(TooMany);
                }
                let grown = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]]
                    .map(|axes| grown(&sums, [i, j, k], axes));
                let volume =
                    |(from, to): &([usize; 3], [usize; 3])| (grid.low(*to) - grid.low(*from)).element_product();
                let mut best = grown[0];
                for one in &grown[1..] {
                    if volume(one) > volume(&best) {
                        best = *one;
                    }
                }
                let (from, to) = best;
                for c in from[2]..to[2] {
                    for b in from[1]..to[1] {
                        for a in from[0]..to[0] {
                            open[grid.index([a, b, c])] = false;
                        }
                    }
                }
                boxes.push(grid.cuboid(from, to));
            }
        }
    }
    Ok(boxes)
}

/// The largest box of filled cells around one, along the axes one after the other.
fn grown(sums: &Sums<'_>, cell: [usize; 3], axes: [usize; 3]) -> ([usize; 3], [usize; 3]) {
    let (mut from, mut to) = (cell, cell.map(|at| at + 1));
    for axis in axes {
        while to[axis] < sums.grid.count[axis] {
            let mut next = to;
            next[axis] += 1;
            if !sums.full(from, next) {
                break;
            }
            to = next;
        }
        while from[axis] > 0 {
            let mut next = from;
            next[axis] -= 1;
            if !sums.full(next, to) {
                break;
            }
            from = next;
        }
    }
    (from, to)
}

#[cfg(test)]
#[path = "boxes_tests.rs"]
mod tests;
