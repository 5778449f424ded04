//! What a search from a start does with every field of a cell: taken apart without `..`, so that a new field, key of a sensor, person
//! or control, or kind of sensor does not compile before that is said here. The twin of this for people from anywhere is
//! `scan/reachability/fields.rs`.

use super::keys::keys;
use crate::cell::file::format::SearchTable;
use crate::cell::sensor::kind::Unseen;
use crate::cell::sensor::{DetectionZone, Placing, Sensor};
use crate::cell::workcell::{Clamping, Control, InitialCondition, Link, Obstacle, Robot, SecondPerson, Workcell};
use crate::geometry::segment_cuboid::segment_cuboid;
use crate::geometry::{Cuboid, Vec3};
use crate::hazard::Criteria;
use crate::hazard::criterion::pressure::LinkContact;
use crate::hazard::criterion::separation::Separation;
use crate::human::arm::ArmModel;
use crate::human::{Arrangement, ControlKind, ControlledBy, Presses};
use crate::sim::detection_plane::DetectionPlane;

/// What a cell asks that stepping and looking do not answer.
#[derive(Debug, Default)]
pub(super) struct Fields {
    /// Names of curtains and the like of which a hand of somebody low may be below before the body is in them.
    pub room_for_legs: Vec<String>,
    /// Names of controls that a hand may get to through more than one plane.
    pub behind_planes: Vec<String>,
    /// Whether there are planes that hands go through.
    pub planes: bool,
    /// Names of light curtains that let a hand through by what the cell file says of them.
    pub coarse: Vec<String>,
    /// Names of fields that somebody low may be under.
    pub above: Vec<String>,
    /// Links of unknown pressure, where that counts.
    pub pressure: Vec<String>,
    /// The input by which it was tried out how far robots go on after a contact.
    pub travel: Option<String>,
    /// Whether anything follows the FMU.
    pub follows: bool,
    /// Whether there are sensors.
    pub sensors: bool,
}

impl Fields {
    /// Of this cell.
    pub(super) fn of(cell: &Workcell) -> Self {
        let Workcell {
            // Names and files: printed, and part of the result's identity. Keys are taken apart by themselves.
            name: _,
            sha256: _,
            fmus: _,
            files: _,
            warnings: _,
            baseline: _,
            file,
            // Stepped and looked at as they are.
            step_s: _,
            steps_per_action: _,
            start: _,
            body: _,
            arm_speed_m_s: _,
            held_m: _,
            pose: _,
            travel_after_contact_m: _,
            // Each beginning is searched by itself, and has its own result.
            beginnings,
            beginning: _,
            starts: _,
            start_areas: _,
            // For people from anywhere. From a start they walk on beyond these, which is more.
            floor: _,
            from: _,
            start_region: _,
            // What can be accepted is looked for by whoever tries it out.
            accepted: _,
            robots,
            links,
            obstacles,
            following,
            sensors,
            placings,
            controls,
            repertoire,
            second,
            criteria,
            clamping,
            separation,
            search,
        } = cell;
        keys(file);
        robots.iter().for_each(robot);
        obstacles.iter().for_each(obstacle);
        controls.iter().for_each(control);
        beginnings.iter().for_each(beginning);
        counts(criteria, separation.as_ref(), search);
        if let Some(second) = second {
            person(second);
        }
        let mut fields = Self {
            room_for_legs: planes_with_room_for_legs(cell),
            behind_planes: controls_between_planes(cell),
            pressure: cell.links_of_unknown_pressure().into_iter().map(str::to_owned).collect(),
            travel: travel(clamping),
            follows: !following.is_empty(),
            sensors: !sensors.is_empty(),
            planes: sensors.iter().any(|sensor| sensor.zone.plane().is_some()),
            ..Self::default()
        };
        links.iter().for_each(link);
        let low = !repertoire.low().is_empty();
        for (one, placing) in sensors.iter().zip(placings) {
            fields.sensor(one, placing, low);
        }
        fields
    }

    fn sensor(
        &mut self,
        Sensor { name, kind, zone, signal: _, delay_steps: _, latched: _ }: &Sensor,
        placing: &Placing,
        low: bool,
    ) {
        // How finely one sees and how high it is, its kind is asked. How a door opens, the line of buttons and what is added to a distance
        // are for the distance alone: the search has the door open at once.
        let Placing { detection: _, height_m: _, line_m: _, opening: _, supplement_m: _ } = placing;
        match zone {
            // Looked at in every sequence, each as it detects people.
            DetectionZone::Floor(_) | DetectionZone::Plane(_) | DetectionZone::Post { .. } | DetectionZone::InFmu => {}
        }
        for unseen in kind.unseen(placing) {
            match unseen {
                Unseen::HandsThrough => self.coarse.push(name.clone()),
                Unseen::LowBelow if low => self.above.push(name.clone()),
                // Nobody is low.
                Unseen::LowBelow => {}
            }
        }
    }
}

/// Where it stands, how it moves and how heavy it is, is looked at as it is.
fn robot(Robot { name: _, world_from_base: _, kinematics: _, moving_mass_kg: _, mass_place: _ }: &Robot) {}

/// Its shape is looked at as it is; of its contact the pressure is asked for above.
fn link(Link { name: _, robot: _, joint: _, shape: _, place: _, looks: _, contact }: &Link) {
    let LinkContact { surface: _, padding_n_m: _ } = contact;
}

/// In the way as it is, while its door is closed, and where the FMU has it.
fn obstacle(Obstacle { name: _, cuboid: _, table: _, opened_by: _, follows: _ }: &Obstacle) {}

fn beginning(InitialCondition { start: _, lead_in_steps: _ }: &InitialCondition) {}

/// The second person does all that the first does, at the same time.
fn person(SecondPerson { names: _, start: _, body: _, repertoire: _, held_m: _ }: &SecondPerson) {}

/// All criteria are judged at each instant.
fn counts(criteria: &Criteria, separation: Option<&Separation>, search: &SearchTable) {
    let Criteria { transient_force: _, clamping: _, pressure: _, moving_contact_m_s: _ } = criteria;
    if let Some(separation) = separation {
        let Separation { stop: _, intrusion_m: _, person_uncertainty_m: _, robot_uncertainty_m: _, approach_m_s: _ } =
            separation;
    }
    let SearchTable { iterations: _, actions: _, seed: _, reach_tolerance_m: _ } = search;
}

/// Worked in any action, by whoever may.
fn control(Control { name: _, place: _, by, kind, steps: _, door: _ }: &Control) {
    match kind {
        ControlKind::Momentary | ControlKind::Held | ControlKind::Toggled => {}
    }
    match by {
        ControlledBy::Person | ControlledBy::Anyone | ControlledBy::Nobody => {}
    }
}

fn travel(Clamping { stated_m: _, signal }: &Clamping) -> Option<String> {
    signal.clone()
}

/// Names of the planes below which people in low postures get with legs and hands, but not with the whole body.
fn planes_with_room_for_legs(cell: &Workcell) -> Vec<String> {
    if cell.repertoire.low().is_empty() {
        return Vec::new();
    }
    let obstacles: Vec<Cuboid> = cell.standing(Presses::NONE, Arrangement::NONE);
    let curtains = DetectionPlane::all(cell, Vec3::ZERO, &obstacles);
    let some = curtains.iter().filter(|c| !c.hands_only && !c.lets_below && c.closed.has_room_below());
    some.map(|curtain| cell.sensors[curtain.sensor].name.clone()).collect()
}

/// Names of the controls that a hand may get to through more than one plane that tells of it.
fn controls_between_planes(cell: &Workcell) -> Vec<String> {
    // Fingers work them, not what they hold.
    let reach = ArmModel::default().reach();
    let planes = || cell.sensors.iter().filter_map(|sensor| sensor.zone.plane());
    let several = |control: &&Control| {
        let Some(place) = control.place.filter(|_| control.by == ControlledBy::Person) else { return false };
        let near = |(plane, _): &(&Cuboid, _)| segment_cuboid(place.a, place.b, plane).distance <= reach + place.radius;
        planes().filter(near).count() > 1
    };
    cell.controls.iter().filter(several).map(|control| control.name.clone()).collect()
}
