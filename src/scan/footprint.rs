//! Parts of a cell from above, m.

use crate::cell::{Control, DetectionZone, Workcell};
use crate::geometry::polygon::convex_outline;
use crate::geometry::{Cuboid, Pose, Solid, Vec3};
use crate::report::top_view::{LinkFootprint, Point};

pub(super) const fn flat(v: Vec3) -> Point {
    [v.x, v.y]
}

/// Where a sensor sees, from above; a plane as a thin strip.
pub(super) fn zone(zone: &DetectionZone) -> Option<Vec<Point>> {
    match zone {
        DetectionZone::Floor(polygon) | DetectionZone::Post { post: polygon, .. } => Some(polygon.clone()),
        DetectionZone::Plane(plane) => Some(outline(&Cuboid { half: plane.half.with_y(0.01), ..*plane })),
        DetectionZone::InFmu => None,
    }
}

/// Where sensors see and where controls are, from above, with their names.
pub(super) fn zones(cell: &Workcell) -> Vec<(String, Vec<Point>)> {
    let sensors = cell.sensors.iter().filter_map(|sensor| Some((sensor.name.clone(), zone(&sensor.zone)?)));
    let buttons = cell.controls.iter().filter_map(|control| Some((control.name.clone(), button(control)?)));
    sensors.chain(buttons).collect()
}

/// A control, as the rectangle around what a hand has to get to.
pub(super) fn button(control: &Control) -> Option<Vec<Point>> {
    let place = control.place?;
    let (a, b, half) = (flat(place.a), flat(place.b), place.radius.max(BUTTON_M));
    let [low, high] = [f64::min, f64::max].map(|of: fn(f64, f64) -> f64| [of(a[0], b[0]), of(a[1], b[1])]);
    let (low, high) = (low.map(|at| at - half), high.map(|at| at + half));
    Some(vec![low, [high[0], low[1]], high, [low[0], high[1]]])
}

/// Half the edge of the square that a button is drawn as, m.
pub(super) const BUTTON_M: f64 = 0.05;

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

/// A hull of more corners than this is drawn by those that are outermost along so many directions.
const MANY: usize = 500;
const DIRECTIONS: u32 = 90;

/// A link from above; of a mesh the outline of its hull.
pub(super) fn part(link: &Solid) -> LinkFootprint {
    let outline = |points: &[Vec3], pose: Pose| {
        LinkFootprint::Outline(convex_outline(points.iter().map(|point| flat(pose * *point)).collect()))
    };
    match link {
        Solid::Capsule(c) => LinkFootprint::Capsule(flat(c.a), flat(c.b), c.radius),
        // Of thousands of corners as many as can be told apart in a picture.
        Solid::Hull(hull) if hull.shape().points().len() > MANY => {
            let around = (0..DIRECTIONS).map(|n| std::f64::consts::TAU * f64::from(n) / f64::from(DIRECTIONS));
            let farthest = around.map(|angle| {
                let (y, x) = libm::sincos(angle);
                flat(hull.outermost(Vec3::new(x, y, 0.0)))
            });
            LinkFootprint::Outline(convex_outline(farthest.collect()))
        }
        Solid::Hull(hull) => outline(hull.shape().points(), hull.pose()),
        Solid::Mesh(mesh) => outline(&mesh.surface().triangles().points, mesh.pose()),
    }
}
