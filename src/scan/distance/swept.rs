//! What robots reach while nobody is detected: every link that moves, where it is after each communication step, from above.

use crate::geometry::distance::segment_segment;
use crate::geometry::polygon::contains;
use crate::geometry::{Solid, Vec3};
use crate::report::top_view::LinkFootprint;
use crate::scan::footprint::part;
use crate::scan::prepare::Prepared;
use crate::sim::motion::Comparison;
use crate::sim::robot::RobotFrame;

/// What is slower than this stands still, m/s, and what moves by less does not move, m.
const STILL: f64 = 1e-3;

/// The nearest point of the robots to an edge.
#[derive(Clone, Copy, Debug)]
pub(super) struct Near {
    /// How far it is, m: seen from above.
    pub distance_m: f64,
    /// The point of the edge, m.
    pub edge_m: [f64; 2],
    /// The link.
    pub link: usize,
    /// When, s after the beginning of the run.
    pub at_s: f64,
}

/// A link at one instant.
struct Piece {
    solid: Solid,
    seen: SweptShape,
    /// A circle around it.
    centre: Vec3,
    radius: f64,
    link: usize,
    at_s: f64,
}

/// A link from above: within a radius of lines between points, and of the inside if there are more than two.
struct SweptShape {
    points: Vec<Vec3>,
    radius: f64,
}

/// Everything that moving links reach in a run.
pub(super) struct Swept {
    pieces: Vec<Piece>,
}

impl Swept {
    /// Of a run whose outputs are these, at the start and after each step.
    pub(super) fn new(prepared: &Prepared, rows: &[f64]) -> Self {
        let (cell, binding) = (&prepared.cell, &prepared.binding);
        // Outputs after initialisation may be no pose of the robots.
        let unsettled = Comparison::new(cell, binding).unsettled();
        let (first, rest) = rows.split_at(binding.outputs.len());
        let derived = binding.first_rows(rest, Some(first), cell.step_s, unsettled);
        let frames: Vec<RobotFrame> =
            derived.chunks(binding.columns()).map(|row| RobotFrame::new(cell, binding, row)).collect();
        let settled = &frames[unsettled.min(frames.len())..];
        let moves = |link: usize| {
            let Some(first) = settled.first() else { return false };
            settled.iter().any(|frame| {
                frame.speed_bounds[link] > STILL || frame.links[link].moved_from(&first.links[link]) > STILL
            })
        };
        let moving: Vec<usize> = (0..cell.links.len()).filter(|link| moves(*link)).collect();
        let mut pieces = Vec::new();
        for (step, frame) in frames.iter().enumerate().skip(unsettled) {
            if step > unsettled && frame.same_outputs(&frames[step - 1]) {
                continue;
            }
            #[expect(clippy::cast_precision_loss, reason = "thousands")]
            let at_s = (step + 1) as f64 * cell.step_s;
            pieces.extend(moving.iter().map(|link| {
                let solid = frame.links[*link].clone();
                let (centre, radius) = solid.bounding_sphere();
                Piece { seen: seen(&solid), solid, centre: centre.with_z(0.0), radius, link: *link, at_s }
            }));
        }
        Self { pieces }
    }

    /// Whether anything moves.
    pub(super) const fn moves(&self) -> bool {
        !self.pieces.is_empty()
    }

    /// The nearest point to any of some lines on the floor.
    pub(super) fn nearest_to(&self, lines: &[[[f64; 2]; 2]]) -> Option<Near> {
        self.nearest(lines, None)
    }

    /// The same of what is between two heights, m. Hulls and meshes count as a whole.
    pub(super) fn nearest_between(&self, lines: &[[[f64; 2]; 2]], heights_m: [f64; 2]) -> Option<Near> {
        self.nearest(lines, Some(heights_m))
    }

    fn nearest(&self, lines: &[[[f64; 2]; 2]], heights_m: Option<[f64; 2]>) -> Option<Near> {
        let mut best: Option<Near> = None;
        for piece in &self.pieces {
            let within;
            let seen = match heights_m {
                None => &piece.seen,
                Some(heights) => match between(&piece.solid, &piece.seen, heights) {
                    None => continue,
                    Some(part) => {
                        within = part;
                        &within
                    }
                },
            };
            for line in lines {
                let [from, to] = line.map(|[x, y]| Vec3::new(x, y, 0.0));
                let middle = (from + to) * 0.5;
                let apart = (middle - piece.centre).length() - 0.5 * (to - from).length() - piece.radius;
                if best.is_some_and(|best| apart > best.distance_m) {
                    continue;
                }
                let (distance_m, on_edge) = distance(from, to, seen);
                if best.is_none_or(|best| distance_m < best.distance_m - 1e-12) {
                    let edge_m = [on_edge.x, on_edge.y];
                    best = Some(Near { distance_m, edge_m, link: piece.link, at_s: piece.at_s });
                }
            }
        }
        best
    }
}

fn seen(solid: &Solid) -> SweptShape {
    let up = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
    match part(solid) {
        LinkFootprint::Capsule(a, b, radius) => SweptShape { points: vec![up(a), up(b)], radius },
        LinkFootprint::Outline(outline) => SweptShape { points: outline.into_iter().map(up).collect(), radius: 0.0 },
    }
}

/// What of a link may be between two heights, from above.
fn between(solid: &Solid, whole: &SweptShape, [low, high]: [f64; 2]) -> Option<SweptShape> {
    let points: Vec<Vec3> = match solid {
        Solid::Capsule(c) => {
            // The part of the core no farther from these heights than the surface is from the core.
            let (low, high) = (low - c.radius, high + c.radius);
            let rise = c.b.z - c.a.z;
            let [from, to] = if rise.abs() < 1e-12 {
                if c.a.z < low || c.a.z > high { [1.0, 0.0] } else { [0.0, 1.0] }
            } else {
                let [s, t] = [(low - c.a.z) / rise, (high - c.a.z) / rise];
                [s.min(t).max(0.0), s.max(t).min(1.0)]
            };
            if from > to {
                return None;
            }
            return Some(SweptShape {
                points: [from, to].map(|share| (c.a + (c.b - c.a) * share).with_z(0.0)).to_vec(),
                radius: c.radius,
            });
        }
        Solid::Hull(hull) => hull.shape().points().iter().map(|point| hull.pose() * *point).collect(),
        Solid::Mesh(mesh) => mesh.surface().triangles().points.iter().map(|point| mesh.pose() * *point).collect(),
    };
    let reaches = points.iter().any(|point| point.z >= low) && points.iter().any(|point| point.z <= high);
    reaches.then(|| SweptShape { points: whole.points.clone(), radius: whole.radius })
}

/// How far a link is from a line on the floor, m, not less than 0, and from which point of it.
fn distance(from: Vec3, to: Vec3, seen: &SweptShape) -> (f64, Vec3) {
    let points = &seen.points;
    if points.len() > 2 {
        let outline: Vec<[f64; 2]> = points.iter().map(|point| [point.x, point.y]).collect();
        if let Some(inside) = [from, to].into_iter().find(|end| contains(&outline, [end.x, end.y])) {
            return (0.0, inside);
        }
    }
    let edges = points.iter().zip(points.iter().cycle().skip(1));
    let near = edges.map(|(a, b)| segment_segment(from, to, *a, *b)).min_by(|a, b| a.distance.total_cmp(&b.distance));
    near.map_or((f64::INFINITY, from), |near| ((near.distance - seen.radius).max(0.0), near.on_first))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Capsule, Hull};

    #[test]
    fn distances_from_above_by_hand() {
        let (from, to) = (Vec3::new(-1.0, 0.0, 0.0), Vec3::new(1.0, 0.0, 0.0));
        // An arm that hangs down towards the line: its lower end is 0.5 m away less 0.1 m, higher up it is farther.
        let arm = Solid::Capsule(Capsule { a: Vec3::new(0.3, 0.5, 1.0), b: Vec3::new(0.3, 1.5, 2.0), radius: 0.1 });
        let all = seen(&arm);
        let is = |found: (f64, Vec3), expected: f64, x: f64| {
            assert!((found.0 - expected).abs() < 1e-12 && (found.1.x - x).abs() < 1e-12, "{found:?}");
        };
        is(distance(from, to, &all), 0.4, 0.3);
        // Above 1.6 m: the core from 1.5 m on, which is 1.0 m away.
        is(distance(from, to, &between(&arm, &all, [1.6, 1.8]).unwrap()), 0.9, 0.3);
        is(distance(from, to, &between(&arm, &all, [0.0, 0.95]).unwrap()), 0.4, 0.3);
        assert!(between(&arm, &all, [0.0, 0.89]).is_none() && between(&arm, &all, [2.11, 3.0]).is_none());
        let flat = Solid::Capsule(Capsule { a: Vec3::new(0.0, 2.0, 1.0), b: Vec3::new(3.0, 2.0, 1.0), radius: 0.1 });
        assert!(
            between(&flat, &seen(&flat), [1.11, 2.0]).is_none() && between(&flat, &seen(&flat), [1.09, 2.0]).is_some()
        );
        // A box, beside the line and across it.
        let corners = |y: f64| {
            let at = |i: u8| f64::from(i) * 0.4 - 0.2;
            let all = (0..8_u8).map(|n| Vec3::new(at(n & 1), y + at(n >> 1 & 1), 1.0 + at(n >> 2)));
            Solid::Hull(Hull::from_points(&all.collect::<Vec<_>>()).unwrap())
        };
        assert!((distance(from, to, &seen(&corners(0.7))).0 - 0.5).abs() < 1e-12);
        assert!(distance(from, to, &seen(&corners(0.1))).0 < 1e-12);
        assert!(distance(Vec3::ZERO, Vec3::new(0.01, 0.0, 0.0), &seen(&corners(0.1))).0 < 1e-12);
    }
}
