//! The causes of the hazards of a scan: which hazards belong together, and what there is to say about the worst of each.

use num_bigint::BigUint;

use super::confirm::worked_alone;
use super::explain::outside;
use super::footprint::{flat, heights, outline};
use super::hosting::StateChoice;
use super::initial_condition::Runs;
use super::prepare::Prepared;
use super::replay;
use crate::cell::workcell::Obstacle;
use crate::geometry::polygon::contains;
use crate::geometry::segment_cuboid::{capsule_cuboid, segment_hits_cuboid};
use crate::geometry::{Capsule, Cuboid, Vec3};
use crate::hazard::BodyOrArm;
use crate::hazard::cause::{self, Kind, Member};
use crate::host::selftest::StateRestore;
use crate::human::BodyPart;
use crate::record::cause::{Cause, Circumstances};
use crate::record::certificate::Certificate;
use crate::record::hazard::Hazard;
use crate::record::operated::OperatedControl;
use crate::sim::simulation::Instant;

/// Steps along an arm in which it is looked what it reaches past, m: thinner than any fence.
const ALONG_M: f64 = 0.005;

/// A hazard as causes see it. Of a link that the cell does not have, the robot is not known.
#[must_use]
pub(crate) fn member(prepared: &Prepared, hazard: &Hazard) -> Member {
    let cell = &prepared.cell;
    let link = cell.links.iter().find(|link| link.name == hazard.robot_link);
    let reporting = hazard.sensors.iter().filter(|s| s.person_detected).map(|s| s.name.clone()).collect();
    let since = hazard.sensors.iter().filter_map(|sensor| sensor.since_s).fold(0.0, f64::max);
    let mut worked: Vec<String> = Vec::new();
    // Where people get to, the FMU has a say in if something follows it: then that of the worst counts.
    let own = if cell.following.is_empty() {
        worked_alone(prepared, &hazard.shortest.actions)
    } else {
        hazard.worked.clone()
    };
    for OperatedControl { control, .. } in own {
        if !worked.contains(&control.name) {
            worked.push(control.name);
        }
    }
    worked.sort_unstable();
    let kind = Kind {
        robot: link.map_or_else(String::new, |link| cell.robots[link.robot].name.clone()),
        part: BodyOrArm::of(hazard.body_region),
        reporting,
        long: since > cause::LONG_S,
        criterion: hazard.class.beside_force(),
        worked,
    };
    let [x, y, _] = hazard.contact_point_m;
    Member { kind, person_m: hazard.person_xy_m, contact_m: [x, y] }
}

/// The causes of hazards, which are given worst first. The sequence of the worst of each is run once more, as plainly as
/// `rung` asks; where that cannot be done, less is said about it.
#[must_use]
pub(crate) fn causes(
    prepared: &Prepared,
    rung: StateRestore,
    hazards: &[Hazard],
    certificate: Option<&Certificate>,
) -> Vec<Cause> {
    let members: Vec<Member> = hazards.iter().map(|hazard| member(prepared, hazard)).collect();
    if members.is_empty() {
        return Vec::new();
    }
    let plainly = if rung == StateRestore::Processes { StateChoice::Process } else { StateChoice::Replay };
    let mut runs = Runs::new(prepared, plainly, hazards).ok();
    let all: Option<BigUint> = certificate.and_then(|certificate| certificate.sequences.parse().ok());
    let found = cause::causes(&members);
    let causes = found.into_iter().map(|cause::Cause { id, kind, members }| {
        let worst = &hazards[members[0]];
        let around = runs.as_mut().map(|runs| circumstances(prepared, runs, worst)).unwrap_or_default();
        let hazards: Vec<&Hazard> = members.iter().map(|&member| &hazards[member]).collect();
        Cause::new(id, (kind.robot, kind.part), &hazards, &around, all.as_ref())
    });
    causes.collect()
}

fn circumstances(prepared: &Prepared, runs: &mut Runs<'_>, hazard: &Hazard) -> Circumstances {
    let cell = &prepared.cell;
    let (over, under) = past(prepared, hazard);
    let link = cell.links.iter().position(|link| link.name == hazard.robot_link);
    let mut around = Circumstances { over, under, ..Circumstances::default() };
    // An FMU that does not repeat itself, or none any more: what is known without it is told all the same.
    let Ok((_, watched)) = runs.watch(hazard) else { return around };
    let contact = replay::contact_frame(prepared, hazard, &watched);
    let since = hazard.sensors.iter().filter_map(|sensor| sensor.since_s).reduce(f64::max);
    if let (Some(link), Some(since_s)) = (link, since) {
        let first = contact.saturating_sub(replay::steps(prepared, since_s));
        let fastest = |frame: usize| watched.instants[frame].frame.speed_bounds[link];
        around.slowed = fastest(contact) < SLOWED * fastest(first);
    }
    around.outside = outside(prepared, hazard, &watched.instants[contact].readings)
        .map(|outside| (outside.name, outside.distance_m))
        .collect();
    around.got_below = got_below(prepared, &watched.instants[..=contact]);
    if let Some(link) = link {
        let frame = &watched.instants[contact].frame;
        let robot = cell.links[link].robot;
        let varies = prepared.binding.robots[robot].payload.varies();
        around.payload_kg =
            varies.then(|| frame.strike(link).effective_mass_kg - 0.5 * cell.robots[robot].moving_mass_kg);
    }
    around
}

/// A robot that has less than this part of its speed has become slower.
const SLOWED: f64 = 0.9;

/// The curtain or door below which the whole person gets, while it reports nobody.
fn got_below(prepared: &Prepared, instants: &[Instant]) -> Option<String> {
    let passes = |plane: &Cuboid, [before, after]: [&Instant; 2]| {
        let level = |at: &Instant| Vec3 { z: plane.centre.z, ..at.position };
        let in_it = |(_, part): &(BodyPart, Capsule)| capsule_cuboid(part, plane).distance <= 0.0;
        // Planes have no thickness, and nothing would be inside.
        let thick = Cuboid { half: plane.half + Vec3::Y * 1e-6, ..*plane };
        heights(plane)[0] > 0.0
            && segment_hits_cuboid(level(before), level(after), &thick)
            && [before, after].iter().all(|at| !at.body.parts().iter().any(in_it))
    };
    let sensors = prepared.cell.sensors.iter().enumerate();
    let mut below = sensors.filter(|(number, sensor)| {
        let Some(plane) = sensor.zone.walked_through() else { return false };
        instants.iter().all(|instant| !instant.readings[*number])
            && instants.windows(2).any(|pair| passes(plane, [&pair[0], &pair[1]]))
    });
    below.next().map(|(_, sensor)| sensor.name.clone())
}

/// What an arm that touches reaches over and under on its way, of several the highest.
fn past(prepared: &Prepared, hazard: &Hazard) -> (Option<String>, Option<String>) {
    let Some(arm) = &hazard.arm else { return (None, None) };
    let way = [arm.shoulder_m, arm.elbow_m, arm.wrist_m, hazard.contact_point_m].map(Vec3::from_array);
    let mut points = Vec::new();
    for pair in way.windows(2) {
        let [from, to] = [pair[0], pair[1]];
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few hundred")]
        let steps = ((to - from).length() / ALONG_M).ceil().max(1.0) as u32;
        points.extend((0..=steps).map(|step| from + (to - from) * (f64::from(step) / f64::from(steps))));
    }
    let is_open = |control: &str| {
        let moved = hazard.worked.iter().filter(|working| working.control.name == control);
        moved.filter_map(|working| working.opens).next_back() == Some(true)
    };
    // Where they were then that follow the FMU, is not asked.
    let is_there =
        |o: &&Obstacle| o.follows.is_none() && !o.opened_by.is_some_and(|n| is_open(&prepared.cell.controls[n].name));
    let highest = |passes: &dyn Fn(f64, [f64; 2]) -> bool| {
        let passed = |c: &Cuboid| {
            let (floor, between) = (outline(c), heights(c));
            points.iter().any(|point| contains(&floor, flat(*point)) && passes(point.z, between))
        };
        let extent = |c: &Cuboid| heights(c)[1] - heights(c)[0];
        let standing = prepared.cell.obstacles.iter().filter(is_there);
        let all = standing.filter(|o| passed(&o.cuboid));
        all.max_by(|a, b| extent(&a.cuboid).total_cmp(&extent(&b.cuboid))).map(|o| o.name.clone())
    };
    (highest(&|z, [_, top]| z > top), highest(&|z, [bottom, _]| z < bottom))
}
