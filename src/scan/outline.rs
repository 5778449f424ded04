//! Parts of a cell from above, m.

use crate::cell::Zone;
use crate::geometry::{Cuboid, Vec3};
use crate::report::topview::Point;

pub(super) const fn flat(v: Vec3) -> Point {
    [v.x, v.y]
}

/// Where a sensor sees, from above; the plane of a light curtain as a thin strip.
pub(super) fn zone(zone: &Zone) -> Option<Vec<Point>> {
    match zone {
        Zone::Mat(polygon) | Zone::Field(polygon) | Zone::TwoHand { post: polygon, .. } => Some(polygon.clone()),
        Zone::Curtain(plane) | Zone::Door(plane) => Some(outline(&Cuboid { half: plane.half.with_y(0.01), ..*plane })),
        Zone::Reported => None,
    }
}

/// Footprint: the lower face, exact for boxes that stand upright.
pub(super) fn outline(c: &Cuboid) -> Vec<Point> {
    corners(c).take(4).map(flat).collect()
}

pub(super) fn top(c: &Cuboid) -> f64 {
    heights(c)[1]
}

/// From which height to which a box reaches.
pub(super) fn heights(c: &Cuboid) -> [f64; 2] {
    [corners(c).map(|p| p.z).fold(f64::MAX, f64::min), corners(c).map(|p| p.z).fold(f64::MIN, f64::max)]
}

fn corners(c: &Cuboid) -> impl Iterator<Item = Vec3> + '_ {
    [-1.0, 1.0].into_iter().flat_map(move |z| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .into_iter()
            .map(move |(x, y)| c.centre + c.rotation * (c.half * Vec3::new(x, y, z)))
    })
}
