//! Distances between points, segments and capsules, in closed form; boxes are in `segment_cuboid`.
//!
//! Plain multiply and add in f64, no iteration, no trigonometry: the same bits on every machine. Knows the shapes and
//! nothing else.

use super::Vec3;
use crate::stop::count_work;

/// The nearest pair of surface points of two shapes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closest {
    /// Surface to surface in metres; negative when the shapes overlap (how far they must be moved apart).
    pub distance: f64,
    /// The point on the surface of the first shape. Overlapping shapes: its deepest point.
    pub on_first: Vec3,
    /// The point on the surface of the second shape.
    pub on_second: Vec3,
}

/// Parameter in `[0, 1]` of the point of the segment `a + t (b - a)` nearest to `point`; 0 for a segment of no length.
#[must_use]
pub(crate) fn point_segment_parameter(point: Vec3, a: Vec3, b: Vec3) -> f64 {
    count_work(1);
    let along = b - a;
    let length_squared = along.dot(along);
    if length_squared > 0.0 { ((point - a).dot(along) / length_squared).clamp(0.0, 1.0) } else { 0.0 }
}

/// Nearest point of the segment from `a` to `b`: `on_first` is `point` itself.
#[must_use]
pub fn point_segment(point: Vec3, a: Vec3, b: Vec3) -> Closest {
    let on_second = a + (b - a) * point_segment_parameter(point, a, b);
    Closest { distance: (point - on_second).length(), on_first: point, on_second }
}

/// Parameters `(s, t)` of the nearest points `p + s (q - p)` and `a + t (b - a)` of two segments.
///
/// The common perpendicular is taken when its feet lie on both segments; otherwise the optimum has an end point on one
/// side, and the best of the four is taken. Nearly parallel segments compare both, because the feet are then badly
/// conditioned.
#[must_use]
pub(crate) fn segment_segment_parameters(p: Vec3, q: Vec3, a: Vec3, b: Vec3) -> (f64, f64) {
    count_work(1);
    let (u, v, w) = (q - p, b - a, p - a);
    let (uu, uv, vv) = (u.dot(u), u.dot(v), v.dot(v));
    let (uw, vw) = (u.dot(w), v.dot(w));
    let determinant = uu * vv - uv * uv;
    let mut best = (0.0, 0.0);
    let mut best_squared = f64::INFINITY;
    if determinant > 1e-14 * uu * vv {
        let s = (uv * vw - vv * uw) / determinant;
        if (0.0..=1.0).contains(&s) {
            let t = (uv * s + vw) / vv;
            if (0.0..=1.0).contains(&t) {
                if determinant > 1e-8 * uu * vv {
                    return (s, t);
                }
                best = (s, t);
                best_squared = (w + u * s - v * t).length_squared();
            }
        }
    }
    let foot = |numerator: f64, denominator: f64| {
        if denominator > 0.0 { (numerator / denominator).clamp(0.0, 1.0) } else { 0.0 }
    };
    let ends = [(0.0, foot(vw, vv)), (1.0, foot(vw + uv, vv)), (foot(-uw, uu), 0.0), (foot(uv - uw, uu), 1.0)];
    for (s, t) in ends {
        let squared = (w + u * s - v * t).length_squared();
        if squared < best_squared {
            best = (s, t);
            best_squared = squared;
        }
    }
    best
}

/// Nearest points of the segments from `p` to `q` and from `a` to `b`.
#[must_use]
pub fn segment_segment(p: Vec3, q: Vec3, a: Vec3, b: Vec3) -> Closest {
    let (s, t) = segment_segment_parameters(p, q, a, b);
    let (on_first, on_second) = (p + (q - p) * s, a + (b - a) * t);
    Closest { distance: (on_first - on_second).length(), on_first, on_second }
}

/// A unit vector perpendicular to both arguments as far as they allow it: the direction in which crossing cores part.
pub(super) fn perpendicular_to(u: Vec3, v: Vec3) -> Vec3 {
    u.cross(v).try_normalize().unwrap_or_else(|| {
        let along = if u.length_squared() > v.length_squared() { u } else { v };
        let away = if along.x.abs() < 0.5 * along.length() { Vec3::X } else { Vec3::Y };
        along.cross(away).try_normalize().unwrap_or(Vec3::Z)
    })
}

/// From the surface of a shape to that of everything no farther than `by_m` from it: the nearest point there is as much farther out.
pub(super) fn beyond(near: Closest, by_m: f64) -> Closest {
    let towards = near.on_first - near.on_second;
    let outward = if near.distance > 0.0 { towards } else { -towards }.normalize_or_zero();
    Closest { distance: near.distance - by_m, on_second: near.on_second + outward * by_m, ..near }
}
