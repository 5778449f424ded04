//! What stands right below and above an upright plane closes the way with it.

use crate::geometry::{Cuboid, Vec3};

/// Pieces of guarding this far apart close what is between them, m: less than a hand.
pub(super) const GAP_M: f64 = 0.03;

/// From which height to which an upright plane is closed, with upright boxes right below and above it that are as wide, m.
#[must_use]
pub(super) fn closed(plane: &Cuboid, boxes: &[Cuboid]) -> [f64; 2] {
    let (mut low, mut high) = (plane.centre.z - plane.half.z, plane.centre.z + plane.half.z);
    let spans: Vec<[f64; 2]> = boxes.iter().filter_map(|cuboid| beside(plane, cuboid)).collect();
    for _ in 0..spans.len() {
        for [from, to] in &spans {
            if *from <= high + GAP_M && *to > high {
                high = *to;
            }
            if *to >= low - GAP_M && *from < low {
                low = from.max(0.0);
            }
        }
    }
    [low, high]
}

/// From which height to which a box closes all of the width of an upright plane, if it does.
fn beside(plane: &Cuboid, cuboid: &Cuboid) -> Option<[f64; 2]> {
    let plane_from_world = plane.rotation.inverse();
    let turned = plane_from_world * cuboid.rotation;
    // Turned by quarters only, so that all of its faces are along the plane's axes.
    let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| (turned * axis).abs());
    if axes.iter().any(|axis| axis.max_element() < 1.0 - 1e-6) {
        return None;
    }
    let centre = plane_from_world * (cuboid.centre - plane.centre);
    let half = axes[0] * cuboid.half.x + axes[1] * cuboid.half.y + axes[2] * cuboid.half.z;
    let wide = centre.x - half.x <= -plane.half.x + GAP_M && centre.x + half.x >= plane.half.x - GAP_M;
    let in_plane = centre.y.abs() <= half.y + GAP_M;
    (wide && in_plane).then_some([cuboid.centre.z - half.z, cuboid.centre.z + half.z])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::rotation_about;

    fn boxed(centre: [f64; 3], size: [f64; 3], yaw_deg: f64) -> Cuboid {
        Cuboid {
            centre: Vec3::from_array(centre),
            half: Vec3::from_array(size) * 0.5,
            rotation: rotation_about(Vec3::Z, yaw_deg.to_radians()),
        }
    }

    #[test]
    fn boxes_close_what_is_below_and_above_a_curtain_only_where_they_are_as_wide() {
        let plane = boxed([1.0, 0.0, 1.2], [1.0, 0.0, 1.2], 90.0);
        let of = |boxes: &[Cuboid]| closed(&plane, boxes);
        let is = |found: [f64; 2], low: f64, high: f64| {
            assert!((found[0] - low).abs() < 1e-9 && (found[1] - high).abs() < 1e-9, "{found:?}");
        };
        is(of(&[]), 0.6, 1.8);
        let (sill, panel) =
            (boxed([1.0, 0.0, 0.3], [0.1, 1.0, 0.6], 0.0), boxed([1.0, 0.0, 2.2], [0.1, 1.2, 0.8], 0.0));
        let more = boxed([1.0, 0.0, 2.7], [1.2, 0.1, 0.2], 90.0);
        is(of(&[more, sill, panel]), 0.0, 2.8);
        // Too narrow, beside the plane, turned, with a gap.
        is(of(&[boxed([1.0, 0.0, 2.2], [0.1, 0.8, 0.8], 0.0)]), 0.6, 1.8);
        is(of(&[boxed([1.2, 0.0, 2.2], [0.1, 1.2, 0.8], 0.0)]), 0.6, 1.8);
        is(of(&[boxed([1.0, 0.0, 2.2], [0.1, 1.2, 0.8], 20.0)]), 0.6, 1.8);
        is(of(&[boxed([1.0, 0.0, 2.3], [0.1, 1.2, 0.9], 0.0)]), 0.6, 1.8);
    }
}
