//! The replays in a report: every step of a hazard's sequence; and what its FMU gets and answers.

use std::sync::Arc;

use super::arms::{self, Joints};
use super::footprint;
use super::hosting::StateChoice;
use super::prepare::Prepared;
use crate::cell::sensor::kind::Picture;
use crate::cell::sensor::zone::heights;
use crate::cell::{self, Control, DetectionZone, Sensor, Workcell, appearance};
use crate::geometry::distance::point_segment;
use crate::geometry::surface::Triangles;
use crate::geometry::{Capsule, Cuboid, Pose, Solid, Vec3};
use crate::host::system::UnitPort;
use crate::host::{Hosted, Plant as _, PlantError};
use crate::human::arm::ArmModel;
use crate::human::{Action, BendFraction, Posture, Who};
use crate::record::hazard::{Hazard, Through};
use crate::report::page::{
    ActionFrame, ArmPose, ArmShape, Floats, LinkShape, LinkVisual, MovedObstacle, Obstacle, PartShape, Replay,
    RobotBase, Scenery, SensorTimeline, StartPlace, ZoneOutline,
};
use crate::report::trace::Trace;
use crate::sim::simulation::{Instant, ReachedThrough, RecordedRun};
use crate::sim::{Simulation, World};
use crate::standards::BodyRegion;

/// Height of mats and fields in the picture, m; the model has none.
const FLOOR_M: f64 = 0.02;

/// What stands still.
#[must_use]
pub(crate) fn scenery(prepared: &Prepared) -> Scenery {
    let cell = &prepared.cell;
    let upright = cell.body.placed(Vec3::ZERO, 0.0, Posture::Upright, BendFraction::UPRIGHT);
    Scenery {
        name: cell.name.clone(),
        step_s: cell.step_s,
        obstacles: {
            let control = |number: usize| cell.controls[number].name.clone();
            let all = cell.obstacles.iter();
            all.map(|o| obstacle(o, o.opened_by.map(control))).collect()
        },
        sensors: cell.sensors.iter().map(|sensor| sensor.name.clone()).collect(),
        zones: {
            let sensors = cell.sensors.iter().filter_map(zone);
            sensors.chain(cell.controls.iter().filter_map(button)).collect()
        },
        links: cell
            .links
            .iter()
            .map(|link| {
                let (name, robot) = (link.name.clone(), cell.robots[link.robot].name.clone());
                match &link.shape {
                    Solid::Capsule(capsule) => LinkShape::Capsule { name, robot, radius_m: capsule.radius },
                    Solid::Hull(hull) => LinkShape::Hull {
                        name,
                        robot,
                        points_m: hull.shape().points().iter().map(|p| p.to_array()).collect(),
                    },
                    Solid::Mesh(mesh) => {
                        let (points_m, triangles) = drawn(mesh.surface().triangles());
                        LinkShape::Mesh { name, robot, points_m, triangles }
                    }
                }
            })
            .collect(),
        looks: appearance::meshes(cell)
            .iter()
            .map(|(link, mesh)| {
                let (points_m, triangles) = drawn(mesh);
                LinkVisual { link: *link, points_m, triangles }
            })
            .collect(),
        body: upright
            .parts()
            .iter()
            .map(|(part, capsule)| PartShape {
                region: part.name().to_owned(),
                name: part.name().replace('_', " "),
                radius_m: capsule.radius,
            })
            .collect(),
        arm: arm_shape(cell),
        robots: cell
            .robots
            .iter()
            .map(|robot| {
                let Pose { translation, rotation } = robot.world_from_base;
                RobotBase {
                    name: robot.name.clone(),
                    // Where the FMU tells the poses of its parts, the base says nothing.
                    base_m: robot.kinematics.as_ref().map(|_| translation.to_array()),
                    upright: (rotation * Vec3::Z).z > 0.99,
                }
            })
            .collect(),
        start: StartPlace { xy_m: cell.start.xy_m(), heading_deg: cell.start.heading_deg() },
    }
}

fn arm_shape(cell: &Workcell) -> ArmShape {
    let ArmModel { hand_radius_m, upper_arm_radius_m, forearm_radius_m, .. } = cell.arm();
    ArmShape { upper_arm_radius_m, forearm_radius_m, hand_radius_m, held_m: cell.held_m }
}

fn drawn(Triangles { points, triangles }: &Triangles) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    (points.iter().map(|point| point.to_array().map(tenth_of_a_millimetre)).collect(), triangles.clone())
}

/// Corners of meshes are many: no more digits than one sees.
fn tenth_of_a_millimetre(length_m: f64) -> f64 {
    (length_m * 1e4).round() / 1e4
}

fn obstacle(obstacle: &cell::workcell::Obstacle, opened_by: Option<String>) -> Obstacle {
    let Cuboid { centre, half, rotation } = obstacle.cuboid;
    Obstacle {
        name: obstacle.name.clone(),
        centre_m: centre.to_array(),
        size_m: (half * 2.0).to_array(),
        quaternion: rotation.to_array(),
        opened_by,
        follows: obstacle.follows.is_some(),
    }
}

/// Where a sensor sees; nothing of one inside the FMU is known.
fn zone(Sensor { name, kind, zone, .. }: &Sensor) -> Option<ZoneOutline> {
    let z_m = match zone {
        DetectionZone::Floor(_) | DetectionZone::Post { .. } => [0.0, FLOOR_M],
        DetectionZone::Plane(plane) => heights(plane),
        DetectionZone::InFmu => return None,
    };
    let Picture { called, drawn } = kind.picture()?;
    Some(ZoneOutline::new((called, name), drawn.word(), footprint::zone(zone)?, z_m))
}

/// A control as something upright that is as large as what a hand has to get to, or a little larger.
fn button(control: &Control) -> Option<ZoneOutline> {
    let place = control.place?;
    let half = place.radius.max(footprint::BUTTON_M);
    let z_m = [place.a.z.min(place.b.z) - half, place.a.z.max(place.b.z) + half];
    Some(ZoneOutline::new(("button", &control.name), "button", footprint::button(control)?, z_m))
}

/// Runs the sequence of `hazard` and keeps everything that there is to see, of two people with the one who is hit as the person. Where it takes an arm through a light curtain,
/// the FMU is told so, at the time with which the contact was judged.
///
/// # Errors
/// When the FMU fails.
pub fn watch(
    simulation: &mut Simulation<Hosted>,
    prepared: &Prepared,
    hazard: &Hazard,
) -> Result<RecordedRun, PlantError> {
    let through: Vec<ReachedThrough> =
        hazard.through.iter().filter_map(|t| reached_through(prepared, hazard, t)).collect();
    let who = prepared.cell.who(hazard.person.as_deref()).unwrap_or_default();
    Ok(simulation.watch(&hazard.actions, &through)?.by(who))
}

fn reached_through(prepared: &Prepared, hazard: &Hazard, through: &Through) -> Option<ReachedThrough> {
    let cell = &prepared.cell;
    let sensor = cell.sensors.iter().position(|sensor| sensor.name == through.sensor)?;
    let now = steps(prepared, hazard.time_s) + cell.sensors[sensor].delay_steps;
    // The hand has all the time from the sample before the one that first told of it.
    let first = now.checked_sub(steps(prepared, through.since_s).saturating_sub(1))?;
    let until = match steps(prepared, through.until_s) {
        0 => usize::MAX,
        until => now.checked_sub(until)?,
    };
    Some(ReachedThrough { sensor, steps: first..until })
}

/// Where the obstacles are that follow the FMU.
fn moved(prepared: &Prepared, instants: &[Instant]) -> Vec<MovedObstacle> {
    let cell = &prepared.cell;
    let following = cell.obstacles.iter().enumerate().filter(|(_, obstacle)| obstacle.follows.is_some());
    let one = |(number, obstacle): (usize, &cell::workcell::Obstacle)| {
        let places: Vec<Option<Cuboid>> = instants.iter().map(|i| cell.amid(obstacle, i.arrangement)).collect();
        let middle = |cuboid: &Option<Cuboid>| cuboid.unwrap_or(obstacle.cuboid).centre.to_array();
        MovedObstacle {
            obstacle: number,
            there: places.iter().map(|place| if place.is_some() { '1' } else { '0' }).collect(),
            centre_m: Floats(places.iter().flat_map(middle).collect()),
        }
    };
    following.map(one).collect()
}

/// Whole steps in a time, s.
#[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few steps after the start")]
pub(super) fn steps(prepared: &Prepared, time_s: f64) -> usize {
    (time_s / prepared.cell.step_s).round() as usize
}

/// The frame in which `hazard` happens.
#[must_use]
pub fn contact_frame(prepared: &Prepared, hazard: &Hazard, watched: &RecordedRun) -> usize {
    steps(prepared, hazard.time_s).min(watched.instants.len() - 1)
}

/// The replay of `hazard`, whose sequence was watched, to the end of the action in which it happens.
#[must_use]
pub fn record(prepared: &Prepared, hazard: &Hazard, watched: &RecordedRun, top_view: String) -> Replay {
    let (instants, step_s) = (&watched.instants, prepared.cell.step_s);
    let contact_frame = contact_frame(prepared, hazard, watched);
    let begun = |(number, action): (usize, &Action)| ActionFrame {
        name: action.to_string(),
        frame: number * prepared.cell.steps_per_action,
    };
    let link = prepared.cell.links.iter().position(|link| link.name == hazard.robot_link);
    let arms = arms::arms(instants, contact_frame, hazard.arm.as_ref(), step_s);
    let touched = Touched::new(hazard, &instants[contact_frame]);
    let curves: Vec<[f64; 3]> = instants
        .iter()
        .zip(&arms)
        .enumerate()
        .map(|(frame, (instant, arms))| {
            let part = touched.at(instant, arms);
            let gap = gap(instant, &part);
            match link {
                // What a hit would be does not depend on the hazard's own criterion, nor on what holds the person.
                _ if frame == contact_frame && hazard.class.beside_force().is_none() => {
                    [gap, hazard.speed_m_s, hazard.ratio]
                }
                Some(link) => {
                    let near = instant.frame.links[link].segment_distance(part.a, part.b);
                    let velocity = instant.frame.velocity(link, near.on_second);
                    let before = &instants[frame.saturating_sub(1)];
                    let walking = (instant.position - before.position) / step_s;
                    let strike = instant.frame.strike(link);
                    let deciding = strike.deciding_speed(velocity, walking);
                    [gap, velocity.length(), strike.ratio(hazard.body_region, deciding)]
                }
                None => [gap, f64::NAN, f64::NAN],
            }
        })
        .collect();
    let curve = |of: usize| Floats(curves.iter().map(|values| values[of]).collect());
    let sensor = |(number, sensor): (usize, &Sensor)| SensorTimeline {
        name: sensor.name.clone(),
        detected: instants.iter().map(|instant| if instant.readings[number] { '1' } else { '0' }).collect(),
    };
    #[expect(clippy::cast_precision_loss, reason = "a few steps after the start")]
    let time = |frame: usize| frame as f64 * step_s;
    Replay {
        id: hazard.id.clone(),
        frames: instants.len(),
        contact_frame,
        links: Floats(instants.iter().flat_map(|instant| instant.frame.links.iter().flat_map(place)).collect()),
        body: Floats(instants.iter().flat_map(|i| i.body.parts().iter().flat_map(|(_, part)| ends(part))).collect()),
        moved: moved(prepared, instants),
        beside_arms: Floats(if instants.iter().any(|instant| instant.second.is_some()) {
            let others = arms::arms(&watched.clone().by(Who::Second).instants, contact_frame, None, step_s);
            others.iter().flatten().flatten().flat_map(|joint| joint.to_array()).collect()
        } else {
            Vec::new()
        }),
        beside: Floats(
            instants
                .iter()
                .filter_map(|instant| instant.second.as_ref())
                .flat_map(|(_, body)| body.parts().iter().flat_map(|(_, part)| ends(part)))
                .collect(),
        ),
        arms: Floats(arms.iter().flatten().flatten().flat_map(|joint| joint.to_array()).collect()),
        arm: hazard
            .arm
            .as_ref()
            .map(|arm| ArmPose { side: arm.side.clone(), points_m: [arm.shoulder_m, arm.elbow_m, arm.wrist_m] }),
        contact_m: hazard.contact_point_m,
        time_s: Floats((0..instants.len()).map(time).collect()),
        distance_m: curve(0),
        speed_m_s: curve(1),
        force_ratio: curve(2),
        sensors: prepared.cell.sensors.iter().enumerate().map(sensor).collect(),
        actions: hazard.actions.iter().enumerate().map(begun).collect(),
        top_view,
    }
}

/// What the FMU gets and answers in a sequence that was watched; nothing for cells of several FMUs, of which each gets
/// what others answer.
///
/// # Errors
/// When the FMU fails before the person begins.
pub(crate) fn trace(prepared: &Prepared, watched: &RecordedRun) -> Result<Option<Trace>, PlantError> {
    if prepared.fmus.len() > 1 {
        return Ok(None);
    }
    let binding = &prepared.binding;
    let names = |ports: &[UnitPort]| ports.iter().map(|port| port.port.name.clone()).collect();
    let rows = |values: &[f64], width: usize| values.chunks(width.max(1)).map(<[f64]>::to_vec).collect();
    let before = prepared.cell.lead_in_steps();
    let before = if before == 0 {
        Vec::new()
    } else {
        let world = World::new(Arc::clone(&prepared.cell), Arc::clone(binding));
        let given = world.initial_inputs().repeat(before);
        let mut plant = prepared.plant_without_lead_in(StateChoice::Replay);
        plant.restart()?;
        let answered = plant.advance(before, &given)?;
        let row = |values: &[f64], width: usize, step: usize| values[step * width..(step + 1) * width].to_vec();
        let (inputs, outputs) = (binding.inputs.len(), binding.outputs.len());
        (0..before).map(|step| (row(&given, inputs, step), row(&answered, outputs, step))).collect()
    };
    Ok(Some(Trace {
        step_s: prepared.cell.step_s,
        inputs: names(&binding.inputs),
        outputs: names(&binding.outputs),
        given: rows(&watched.inputs, binding.inputs.len()),
        answered: rows(&watched.outputs, binding.outputs.len()),
        before,
    }))
}

fn ends(capsule: &Capsule) -> [f64; 6] {
    let (a, b) = (capsule.a, capsule.b);
    [a.x, a.y, a.z, b.x, b.y, b.z]
}

fn place(link: &Solid) -> [f64; 7] {
    match link {
        Solid::Capsule(capsule) => {
            let [ax, ay, az, bx, by, bz] = ends(capsule);
            [ax, ay, az, bx, by, bz, 0.0]
        }
        Solid::Hull(hull) => pose(hull.pose()),
        Solid::Mesh(mesh) => pose(mesh.pose()),
    }
}

fn pose(Pose { translation, rotation }: Pose) -> [f64; 7] {
    let ([x, y, z], [qx, qy, qz, qw]) = (translation.to_array(), rotation.to_array());
    [x, y, z, qx, qy, qz, qw]
}

/// What of the person is touched.
enum Touched {
    /// A part of the body, by its number.
    Body(usize),
    /// A limb of the left or the right arm, and its radius.
    Limb(usize, Limb, f64),
}

/// A limb, between two of an arm's joints.
#[derive(Clone, Copy)]
enum Limb {
    UpperArm,
    Forearm,
    Hand,
}

impl Limb {
    fn ends(self, [shoulder, elbow, wrist]: Joints) -> (Vec3, Vec3) {
        match self {
            Self::UpperArm => (shoulder, elbow),
            Self::Forearm => (elbow, wrist),
            Self::Hand => (wrist, wrist),
        }
    }
}

impl Touched {
    fn new(hazard: &Hazard, contact: &Instant) -> Self {
        let held_m = hazard.arm.as_ref().and_then(|arm| arm.held_m).unwrap_or_default();
        let (at, shape) = (Vec3::from_array(hazard.body_point_m), ArmModel::holding(held_m));
        let Some(arm) = &hazard.arm else {
            let off = |part: &Capsule| (point_segment(at, part.a, part.b).distance - part.radius).abs();
            let parts = contact.body.parts().iter().enumerate();
            let nearest = parts.min_by(|(_, (_, p)), (_, (_, q))| off(p).total_cmp(&off(q)));
            return Self::Body(nearest.map_or(0, |(number, _)| number));
        };
        let joints = [arm.shoulder_m, arm.elbow_m, arm.wrist_m].map(Vec3::from_array);
        // The contact is on the surface of the limb. An elbow counts as upper arm, on both sides of the joint.
        let off = |limb: Limb, radius: f64| {
            let (a, b) = limb.ends(joints);
            (point_segment(at, a, b).distance - radius).abs()
        };
        let upper_arm = off(Limb::UpperArm, shape.upper_arm_radius_m);
        let forearm = off(Limb::Forearm, shape.forearm_radius_m);
        let (limb, radius) = match hazard.body_region {
            BodyRegion::UpperArm if upper_arm <= forearm => (Limb::UpperArm, shape.upper_arm_radius_m),
            BodyRegion::UpperArm | BodyRegion::LowerArm => (Limb::Forearm, shape.forearm_radius_m),
            _ => (Limb::Hand, shape.hand_radius_m),
        };
        Self::Limb(usize::from(arm.side != "left"), limb, radius)
    }

    /// Where it is, with these arms.
    fn at(&self, instant: &Instant, arms: &[Joints; 2]) -> Capsule {
        match *self {
            Self::Body(part) => instant.body.parts()[part].1,
            Self::Limb(side, limb, radius) => {
                let (a, b) = limb.ends(arms[side]);
                Capsule { a, b, radius }
            }
        }
    }
}

/// From the nearest link to a part of the person, m; none where they overlap.
fn gap(instant: &Instant, part: &Capsule) -> f64 {
    let near = instant.frame.links.iter().map(|link| link.segment_distance(part.a, part.b).distance);
    (near.fold(f64::INFINITY, f64::min) - part.radius).max(0.0)
}
