//! The top view of one hazard: the sequence is run once more and what is seen from above is handed to the drawing.

use super::prepare::{Prepared, StateChoice};
use super::run::ScanError;
use crate::cell::Zone;
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::report::model::Hazard;
use crate::report::topview::{Point, Scene};
use crate::search::Environment as _;

const fn flat(v: Vec3) -> Point {
    [v.x, v.y]
}

/// The scene of `hazard`.
///
/// # Errors
/// When the FMU fails.
pub fn scene(prepared: &Prepared, hazard: &Hazard) -> Result<Scene, ScanError> {
    let wrap = |cause| ScanError { cause };
    let mut simulation = prepared.simulation(StateChoice::Auto, false).map_err(wrap)?;
    simulation.reset().map_err(wrap)?;
    let mut path = vec![simulation.position()];
    let mut robot = Vec::new();
    let step_s = prepared.cell.step_s;
    for action in &hazard.actions {
        let before = path.len() - 1;
        let ended = simulation.step(action.index()).map_err(wrap)?.end.is_some();
        for (i, instant) in simulation.last_action().into_iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "a handful of steps")]
            let time_s = (before + i + 1) as f64 * step_s;
            if time_s > hazard.time_s + 0.5 * step_s {
                break;
            }
            path.push(instant.position);
            if i % 3 == 0 || (time_s - hazard.time_s).abs() < 0.5 * step_s {
                robot.push(instant.frame.links.iter().map(segment).collect());
            }
        }
        if ended {
            break;
        }
    }
    let cell = &prepared.cell;
    let body = simulation.body_at(hazard.person_xy_m, hazard.person_heading_deg, hazard.actions.last().copied());
    Ok(Scene {
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
        robot,
        path: path.into_iter().map(flat).collect(),
        body: body.into_iter().map(|c| (flat(c.a), flat(c.b), c.radius)).collect(),
        arm: hazard.arm.iter().flat_map(|a| [a.shoulder_m, a.elbow_m, a.wrist_m]).map(|p| [p[0], p[1]]).collect(),
        contact: Some([hazard.contact_point_m[0], hazard.contact_point_m[1]]),
    })
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
