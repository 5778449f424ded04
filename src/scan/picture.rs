//! The top view of one hazard: what is seen from above of its sequence is handed to the drawing.

use super::film;
use super::prepare::Prepared;
use crate::cell::Zone;
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::report::model::Hazard;
use crate::report::topview::{Point, Scene};
use crate::sim::simulation::Watched;

const fn flat(v: Vec3) -> Point {
    [v.x, v.y]
}

/// The scene of `hazard`, whose sequence was watched.
#[must_use]
pub fn scene(prepared: &Prepared, hazard: &Hazard, watched: &Watched) -> Scene {
    let cell = &prepared.cell;
    let contact = film::contact_frame(prepared, hazard, watched);
    let until = &watched.instants[..=contact];
    // A few instants of each action, and the contact.
    let shown = |frame: usize| frame == contact || ((frame - 1) % cell.steps_per_action).is_multiple_of(3);
    let robot = (1..=contact).filter(|&frame| shown(frame)).map(|frame| &until[frame].frame.links);
    Scene {
        title: format!(
            "{}: {} meets {}, {:.2} s, {:.0} N of {:.0} N",
            hazard.id,
            hazard.robot_link,
            hazard.body_region.words(),
            hazard.time_s,
            hazard.force_n,
            hazard.limit_n
        ),
        obstacles: cell.obstacles.iter().map(|(name, c)| (name.clone(), outline(c), top(c))).collect(),
        zones: cell.sensors.iter().filter_map(|s| Some((s.name.clone(), zone(&s.zone)?))).collect(),
        robot: robot.map(|links| links.iter().map(segment).collect()).collect(),
        path: until.iter().map(|instant| flat(instant.position)).collect(),
        body: until[contact].body.iter().map(|c| (flat(c.a), flat(c.b), c.radius)).collect(),
        arm: hazard.arm.iter().flat_map(|a| [a.shoulder_m, a.elbow_m, a.wrist_m]).map(|p| [p[0], p[1]]).collect(),
        contact: Some([hazard.contact_point_m[0], hazard.contact_point_m[1]]),
    }
}

/// Where a sensor sees, from above; the plane of a light curtain as a thin strip.
pub(super) fn zone(zone: &Zone) -> Option<Vec<Point>> {
    match zone {
        Zone::Mat(polygon) | Zone::Field(polygon) => Some(polygon.clone()),
        Zone::Curtain(plane) => Some(outline(&Cuboid { half: plane.half.with_y(0.01), ..*plane })),
        Zone::Reported => None,
    }
}

fn segment(link: &Solid) -> (Point, Point, f64) {
    match link {
        Solid::Capsule(c) => (flat(c.a), flat(c.b), c.radius),
        Solid::Hull(_) => {
            let (centre, radius) = link.bounding_sphere();
            (flat(centre), flat(centre), radius)
        }
    }
}

fn corners(c: &Cuboid) -> impl Iterator<Item = Vec3> + '_ {
    [-1.0, 1.0].into_iter().flat_map(move |z| {
        [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)]
            .into_iter()
            .map(move |(x, y)| c.centre + c.rotation * (c.half * Vec3::new(x, y, z)))
    })
}

/// Footprint: the lower face, exact for boxes that stand upright.
fn outline(c: &Cuboid) -> Vec<Point> {
    corners(c).take(4).map(flat).collect()
}

fn top(c: &Cuboid) -> f64 {
    corners(c).map(|p| p.z).fold(f64::MIN, f64::max)
}
