//! Distances from points, segments and capsules to a box, exact, and whether a segment passes through a box.
//!
//! The squared distance from a point that runs along a segment to a box is convex and piecewise quadratic in the
//! segment parameter; its derivative is piecewise linear with at most six kinks (where the point passes a face plane).
//! Looking at the sign of the derivative at every kink leaves one linear piece, whose root is the answer. Overlap depth
//! comes from the faces of the Minkowski sum of box and segment: the three box axes and their cross products with the
//! segment.

use super::{Capsule, Closest, Cuboid, Vec3};
use crate::stop::count_work;

/// How deep inside the box a line has to be before it counts as passing through, metres: a line along a face is free.
pub(crate) const HIT_DEPTH_M: f64 = 1e-9;

/// Nearest point of the box to a point, both in the frame of the box.
fn clamp_to_box(point: Vec3, half: Vec3) -> Vec3 {
    point.clamp(-half, half)
}

/// Signed distance and the nearest surface point, in the frame of the box.
fn point_box_local(point: Vec3, half: Vec3) -> (f64, Vec3) {
    count_work(1);
    let nearest = clamp_to_box(point, half);
    let outside = (point - nearest).length();
    if outside > 0.0 {
        return (outside, nearest);
    }
    let room = half - point.abs();
    let mut surface = point;
    let face = |half: f64, coordinate: f64| if coordinate < 0.0 { -half } else { half };
    if room.x <= room.y && room.x <= room.z {
        surface.x = face(half.x, point.x);
        (-room.x, surface)
    } else if room.y <= room.z {
        surface.y = face(half.y, point.y);
        (-room.y, surface)
    } else {
        surface.z = face(half.z, point.z);
        (-room.z, surface)
    }
}

/// A lower bound on the distance from a segment to a box, quickly: the widest gap between the two along an axis of the
/// box, negative where they overlap along all three.
#[must_use]
pub fn segment_cuboid_apart(a: Vec3, b: Vec3, cuboid: &Cuboid) -> f64 {
    count_work(1);
    let box_from_world = cuboid.rotation.inverse();
    let (a, b) = (box_from_world * (a - cuboid.centre), box_from_world * (b - cuboid.centre));
    (a.min(b) - cuboid.half).max(-cuboid.half - a.max(b)).max_element()
}

/// Parameter in `[0, 1]` at which the segment `a + t (b - a)` is nearest to a box of half edges `half` about the origin.
fn segment_box_parameter(a: Vec3, b: Vec3, half: Vec3) -> f64 {
    count_work(2);
    let along = b - a;
    // Half the derivative of the squared distance.
    let slope = |t: f64| {
        let point = a + along * t;
        along.dot(point - clamp_to_box(point, half))
    };
    let (mut low, mut high) = (0.0, 1.0);
    let mut slope_low = slope(low);
    if slope_low >= 0.0 {
        return low;
    }
    let mut slope_high = slope(high);
    if slope_high <= 0.0 {
        return high;
    }
    for (start, step, edge) in [(a.x, along.x, half.x), (a.y, along.y, half.y), (a.z, along.z, half.z)] {
        if step == 0.0 {
            continue;
        }
        for plane in [-edge, edge] {
            let t = (plane - start) / step;
            if t > low && t < high {
                let at = slope(t);
                if at < 0.0 {
                    (low, slope_low) = (t, at);
                } else {
                    (high, slope_high) = (t, at);
                }
            }
        }
    }
    low + (high - low) * (-slope_low / (slope_high - slope_low))
}

/// How far a segment that meets the box must be moved to leave it.
fn overlap_depth(a: Vec3, b: Vec3, half: Vec3) -> f64 {
    let (middle, reach) = ((a + b) * 0.5, (b - a).abs() * 0.5);
    let faces = half + reach - middle.abs();
    let mut depth = faces.min_element();
    let along = b - a;
    for normal in
        [Vec3::new(0.0, along.z, -along.y), Vec3::new(-along.z, 0.0, along.x), Vec3::new(along.y, -along.x, 0.0)]
    {
        let length = normal.length();
        if length > 1e-9 {
            depth = depth.min((half.dot(normal.abs()) - middle.dot(normal).abs()) / length);
        }
    }
    depth.max(0.0)
}

/// A segment against a box in the frame of the box: signed distance (negative: overlap depth) and the parameter of the
/// nearest point, or of a point inside.
pub(crate) fn segment_box_local(a: Vec3, b: Vec3, half: Vec3) -> (f64, f64) {
    let t = segment_box_parameter(a, b, half);
    let point = a + (b - a) * t;
    let outside = (point - clamp_to_box(point, half)).length();
    // Where the root was found numerically a crossing segment can seem to stay outside by rounding.
    if outside > 1e-12 { (outside, t) } else { (-overlap_depth(a, b, half), t) }
}

/// The part of `[0, 1]` in which `a + t (b - a)` lies in the box, if any.
fn clip_local(a: Vec3, b: Vec3, half: Vec3) -> Option<(f64, f64)> {
    count_work(1);
    let along = b - a;
    let (mut enter, mut leave) = (0.0_f64, 1.0_f64);
    for (start, step, edge) in [(a.x, along.x, half.x), (a.y, along.y, half.y), (a.z, along.z, half.z)] {
        if edge < 0.0 {
            return None;
        }
        if step == 0.0 {
            if start.abs() > edge {
                return None;
            }
            continue;
        }
        let (first, second) = ((-edge - start) / step, (edge - start) / step);
        enter = enter.max(first.min(second));
        leave = leave.min(first.max(second));
    }
    (enter <= leave).then_some((enter, leave))
}

/// Whether the segment passes through the box in the frame of the box (see [`segment_hits_cuboid`]).
pub(crate) fn segment_hits_box_local(a: Vec3, b: Vec3, half: Vec3) -> bool {
    clip_local(a, b, half - Vec3::splat(HIT_DEPTH_M)).is_some()
}

/// Point in the frame of the box.
fn to_local(cuboid: &Cuboid, point: Vec3) -> Vec3 {
    cuboid.rotation.inverse() * (point - cuboid.centre)
}

/// Point of the frame of the box in the world.
fn to_world(cuboid: &Cuboid, point: Vec3) -> Vec3 {
    cuboid.rotation * point + cuboid.centre
}

/// Signed distance from a point to the surface of a box, negative inside; `on_first` is the point itself.
#[must_use]
pub fn point_cuboid(point: Vec3, cuboid: &Cuboid) -> Closest {
    let (distance, surface) = point_box_local(to_local(cuboid, point), cuboid.half);
    Closest { distance, on_first: point, on_second: to_world(cuboid, surface) }
}

/// Signed distance from the segment between `a` and `b` to a box; negative is the exact depth of the overlap.
///
/// When they overlap, `on_first` is the deepest of three points of the part inside (its ends and its middle) and
/// `on_second` the box surface point nearest to that.
#[must_use]
pub fn segment_cuboid(a: Vec3, b: Vec3, cuboid: &Cuboid) -> Closest {
    let (start, end, half) = (to_local(cuboid, a), to_local(cuboid, b), cuboid.half);
    let (distance, t) = segment_box_local(start, end, half);
    if distance > 0.0 {
        let nearest = clamp_to_box(start + (end - start) * t, half);
        return Closest { distance, on_first: a + (b - a) * t, on_second: to_world(cuboid, nearest) };
    }
    let (enter, leave) = clip_local(start, end, half).unwrap_or((t, t));
    let mut chosen = (f64::INFINITY, start, t);
    for inside in [0.5 * (enter + leave), enter, leave] {
        let (depth, surface) = point_box_local(start + (end - start) * inside, half);
        if depth < chosen.0 {
            chosen = (depth, surface, inside);
        }
    }
    Closest { distance, on_first: a + (b - a) * chosen.2, on_second: to_world(cuboid, chosen.1) }
}

/// Signed distance of a capsule and a box. While the core stays outside it is the core's distance less the radius, and
/// the points are the nearest pair; with the core inside, the depth of the core plus the radius.
#[must_use]
pub fn capsule_cuboid(capsule: &Capsule, cuboid: &Cuboid) -> Closest {
    let core = segment_cuboid(capsule.a, capsule.b, cuboid);
    let outward = (core.on_first - core.on_second).try_normalize().unwrap_or(Vec3::Z);
    // With the core outside, the capsule's nearest point lies towards the box; inside, its deepest lies away from the face.
    let deepest = if core.distance > 0.0 { -outward } else { outward };
    Closest {
        distance: core.distance - capsule.radius,
        on_first: core.on_first + deepest * capsule.radius,
        on_second: core.on_second,
    }
}

/// Whether the straight line from `a` to `b` passes through the box; running along its surface (within
/// [`HIT_DEPTH_M`]) does not count.
#[must_use]
pub fn segment_hits_cuboid(a: Vec3, b: Vec3, cuboid: &Cuboid) -> bool {
    segment_hits_box_local(to_local(cuboid, a), to_local(cuboid, b), cuboid.half)
}
