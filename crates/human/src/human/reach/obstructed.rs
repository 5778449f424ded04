//! When a limb is certainly in an obstacle, wherever its ends are within what they can move.

use super::sweep::Range;
use crate::geometry::{Cuboid, Vec3};

/// Whether a limb of this radius that ends at `end` certainly has that end in a box, or within its radius of a face,
/// for all ends that move along a direction `n` within `along(n)`.
pub(super) fn ends_inside(o: &Cuboid, end: Vec3, radius: f64, along: impl Fn(Vec3) -> Range) -> bool {
    let local = o.rotation.inverse() * (end - o.centre);
    let outside = (local.abs() - o.half).to_array();
    if outside.iter().any(|d| *d > radius) {
        return false;
    }
    let face = (1..3).fold(0, |f, i| if outside[i] > outside[f] { i } else { f });
    let axes = [Vec3::X, Vec3::Y, Vec3::Z];
    (0..3).all(|i| {
        let Range { low, high } = along(o.rotation * axes[i]);
        let most = (local[i] + high).max(-local[i] - low) - o.half[i];
        most <= if i == face { radius } else { 0.0 }
    })
}

/// Whether a limb certainly passes through a flat box from one side to the other, for all ends that move along
/// a direction `n` within `along(n)`.
///
/// The ends stay on opposite sides of the middle plane of the box's thinnest direction, so the limb crosses that
/// plane, at a point that is no farther from the present line than the ends move: if the part of the present line near
/// the plane is that much inside the face, the crossing is in the box. A limb of some radius may miss the face by a
/// little and still touch (0.7 of the radius along both edges stays within the radius at the corner).
pub(super) fn crosses(o: &Cuboid, ends: [Vec3; 2], radius: f64, along: impl Fn(Vec3) -> [Range; 2]) -> bool {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| o.rotation * axis);
    let half = o.half.to_array();
    let thin = (1..3).fold(0, |t, i| if half[i] < half[t] { i } else { t });
    let local = ends.map(|p| axes.map(|axis| (p - o.centre).dot(axis)));
    let (a, b) = (local[0][thin], local[1][thin]);
    if a * b >= 0.0 {
        return false;
    }
    let moves = along(axes[thin]);
    let stays = |at: f64, moves: Range| if at > 0.0 { at + moves.low > 0.0 } else { at + moves.high < 0.0 };
    if !stays(a, moves[0]) || !stays(b, moves[1]) {
        return false;
    }
    // Parameters at which the present line is within the movement of the plane.
    let margin = moves[0].most().max(moves[1].most());
    let at = |level: f64| ((level - a) / (b - a)).clamp(0.0, 1.0);
    let part = [at(-margin), at(margin)];
    (0..3).filter(|&i| i != thin).all(|i| {
        let moves = along(axes[i]);
        let room = half[i] + 0.7 * radius - moves[0].most().max(moves[1].most());
        part.iter().all(|t| (local[0][i] + t * (local[1][i] - local[0][i])).abs() < room)
    })
}
