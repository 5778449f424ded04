//! Top views: of one hazard, and of a cell before any scan. What is seen from above is handed to the drawing.

use std::collections::BTreeSet;
use std::sync::Arc;

use super::footprint::{flat, outline, part, top, zones};
use super::prepare::Prepared;
use super::probe::Probe;
use super::reachability::map;
use super::replay;
use crate::hazard::Class;
use crate::human::{Action, Place, Posture};
use crate::record::hazard::Hazard;
use crate::report::floorplan::Plan;
use crate::report::top_view::{LinkFootprint, Point, Scene};
use crate::sim::World;
use crate::sim::robot::RobotFrame;
use crate::sim::simulation::RecordedRun;
use crate::sim::world::Occupant;

/// The scene of `hazard`, whose sequence was watched.
#[must_use]
pub(crate) fn scene(prepared: &Prepared, hazard: &Hazard, watched: &RecordedRun) -> Scene {
    let cell = &prepared.cell;
    let contact = replay::contact_frame(prepared, hazard, watched);
    let until = &watched.instants[..=contact];
    // A few instants of each action, and the contact.
    let shown = |frame: usize| frame == contact || ((frame - 1) % cell.steps_per_action).is_multiple_of(3);
    let robot = (1..=contact).filter(|&frame| shown(frame)).map(|frame| &until[frame].frame.links);
    let amid = until[contact].arrangement;
    let there = cell.obstacles.iter().filter_map(|obstacle| Some((obstacle, cell.amid(obstacle, amid)?)));
    Scene {
        title: format!(
            "{}: {} meets {}, {:.2} s, {}",
            hazard.id,
            hazard.robot_link,
            hazard.struck_words(),
            hazard.time_s,
            match hazard.class {
                Class::Force | Class::HeadContact => {
                    format!("{:.0} N of {:.0} N", hazard.deciding_force_n(), hazard.limit_n)
                }
                _ => hazard.measure_words(),
            }
        ),
        obstacles: there.map(|(obstacle, cuboid)| (obstacle.name.clone(), outline(&cuboid), top(&cuboid))).collect(),
        zones: zones(cell),
        unseen: Vec::new(),
        reachable: Vec::new(),
        robot: robot.map(|links| links.iter().map(part).collect()).collect(),
        path: until.iter().map(|instant| flat(instant.position)).collect(),
        other_starts: Vec::new(),
        body: until[contact].body.parts().iter().map(|(_, c)| (flat(c.a), flat(c.b), c.radius)).collect(),
        arm: hazard.arm.iter().flat_map(|a| [a.shoulder_m, a.elbow_m, a.wrist_m]).map(|p| [p[0], p[1]]).collect(),
        contact: Some([hazard.contact_point_m[0], hazard.contact_point_m[1]]),
    }
}

/// What stands around on the map of a whole floor.
#[must_use]
pub(crate) fn plan(prepared: &Prepared) -> Plan {
    let (cell, subject) = (&prepared.cell, &prepared.subject);
    let fmus: Vec<&str> = subject.fmus.iter().map(|fmu| fmu.sha256.as_str()).collect();
    let based = cell.robots.iter().filter(|robot| robot.kinematics.is_some());
    Plan {
        name: cell.name.clone(),
        source: format!(
            "fmi-hazard {}. SHA-256 of the cell file {}, of its FMU {}.",
            env!("CARGO_PKG_VERSION"),
            subject.cell_sha256,
            fmus.join(", ")
        ),
        obstacles: cell.obstacles.iter().map(|o| (o.name.clone(), outline(&o.cuboid))).collect(),
        zones: zones(cell),
        robots: based.map(|robot| (robot.name.clone(), flat(robot.world_from_base.translation))).collect(),
    }
}

/// Instants of the sweep that are drawn.
const SWEEP: usize = 60;

/// The cell before any scan: obstacles, zones, what the robots sweep while nobody is detected (as `found` saw it), the
/// person's starts (`others` are the further ones) and all places that a sequence can lead to, and the floor on which a scan from
/// anywhere lets people begin.
#[must_use]
pub(crate) fn overview(prepared: &Prepared, others: &[Prepared], found: Option<&Probe>) -> Scene {
    let (cell, binding) = (&prepared.cell, &prepared.binding);
    let width = binding.outputs.len();
    let rows = found.map_or(&[][..], |found| &found.rows);
    let every = (rows.len() / width / SWEEP).max(1);
    let frame = |row: &[f64]| RobotFrame::new(cell, binding, row).links.iter().map(part).collect();
    let robot = rows.chunks(width).step_by(every).map(|row| frame(&binding.rows(row, None, cell.step_s)));
    let mut robot: Vec<Vec<LinkFootprint>> = robot.collect();
    // The last is drawn as it stands: the start.
    robot.reverse();
    let frames: Vec<RobotFrame> =
        rows.chunks(width).map(|row| RobotFrame::new(cell, binding, &binding.rows(row, None, cell.step_s))).collect();
    let all: Vec<&Prepared> = std::iter::once(prepared).chain(others).collect();
    let mut starts = all.iter().map(|one| one.cell.start.xy_m());
    Scene {
        title: format!("{}: the cell from above", cell.name),
        obstacles: cell.obstacles.iter().map(|o| (o.name.clone(), outline(&o.cuboid), top(&o.cuboid))).collect(),
        zones: zones(cell),
        unseen: map::unseen(prepared, &frames),
        reachable: reachable(&all),
        robot,
        path: starts.by_ref().take(1).collect(),
        other_starts: starts.collect(),
        ..Scene::default()
    }
}

/// Most starts from which walks are drawn one by one.
const ONE_BY_ONE: usize = 20;

/// Most starts from which walks are drawn at all, spread over all of them: those of neighbours on a lattice overlap.
const WALKED: usize = 64;

/// Of many starts, walks to places nearer than this are one dot, m.
const DOT_M: f64 = 0.05;

/// Places at the ends of actions that sequences of the cell's length can lead to from any of its starts.
fn reachable(all: &[&Prepared]) -> Vec<Point> {
    let every = all.len().div_ceil(WALKED).max(1);
    let world = |prepared: &&Prepared| World::new(Arc::clone(&prepared.cell), Arc::clone(&prepared.binding));
    // Headings are told apart there, and are one point here.
    let points = all.iter().step_by(every).flat_map(|prepared| places(&world(prepared).first));
    let dot = |point: Point| point.map(|v| (v / DOT_M).round() * DOT_M);
    let mut points: Vec<Point> = if all.len() > ONE_BY_ONE { points.map(dot).collect() } else { points.collect() };
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    points
}

/// From the start of a person, doors taken to be open: who gets a hand to which takes arm searches.
fn places(own: &Occupant) -> Vec<Point> {
    let start = own.start();
    let mut known = BTreeSet::from([start.with_open(start.open().either(own.doors()))]);
    let mut last = known.clone();
    for _ in 0..own.cell.search.actions {
        let next = last.iter().flat_map(|place| {
            // Everybody who stands goes the same ways, however they bend.
            let repertoire = &own.cell.repertoire;
            let postures = std::iter::once(Posture::Upright).chain(repertoire.low().iter().copied());
            let moves =
                postures.flat_map(|posture| repertoire.walks().iter().map(move |walk| Action::new(*walk, posture)));
            moves.map(|action| own.walk(*place, own.taken(place, action)).end()).collect::<Vec<_>>()
        });
        let next: BTreeSet<Place> = next.collect();
        last = next.into_iter().filter(|place| known.insert(*place)).collect();
    }
    known.iter().map(|place| flat(own.position(place))).collect()
}
