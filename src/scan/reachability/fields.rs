//! What a scan from anywhere does with every field of a cell and of its options: taken apart without `..`, so that a new field, key
//! of a sensor, person or control, or kind of sensor does not compile before that is said here. The twin of this for searches from a
//! start is `scan/from_start/fields.rs`.

use super::AnalysisLimits;
use super::keys::keys;
use crate::cell::binding::{Binding, SensorBinding};
use crate::cell::file::format::SearchTable;
use crate::cell::sensor::kind::Unseen;
use crate::cell::sensor::{DetectionZone, Placing, Sensor};
use crate::cell::workcell::{Clamping, Control, InitialCondition, Link, Obstacle, Robot, SecondPerson, Workcell};
use crate::hazard::criterion::separation::Separation;
use crate::hazard::{Criteria, Criterion};
use crate::human::{ControlKind, ControlledBy};

/// Most two-hand controls of a cell: with each, what is reported of somebody who is nowhere near doubles.
pub(super) const MOST_TWO_HAND: usize = 3;

/// What a cell asks that the sets of poses do not answer by themselves.
#[derive(Debug, Default)]
pub(super) struct Fields {
    /// Why nobody can be looked for anywhere.
    pub refusal: Option<String>,
    /// Whether there are controls that somebody works.
    pub worked: bool,
    /// Whether there are two-hand controls.
    pub two_hand: bool,
    /// Whether there are doors that controls open.
    pub doors: bool,
    /// Whether the FMU is told where people are.
    pub pose: bool,
    /// Whether there are sensors inside the FMU.
    pub reported: bool,
    /// What the person does besides walking, bending and reaching.
    pub also: Vec<&'static str>,
    /// Whether the speed of approach decides.
    pub by_approach: bool,
    /// Whether other criteria count than the transient force.
    pub by_others: bool,
    /// Whether there are planes that hands go through.
    pub planes: bool,
    /// Names of light curtains that let a hand through by what the cell file says of them.
    pub coarse: Vec<String>,
}

impl Fields {
    /// Of this cell, bound so.
    pub(super) fn of(cell: &Workcell, binding: &Binding) -> Self {
        let Workcell {
            // Names and files: printed, and part of the result's identity. Keys are taken apart by themselves.
            name: _,
            sha256: _,
            fmus: _,
            files: _,
            warnings: _,
            file,
            // A baseline is held against the scan from the start.
            baseline: _,
            // Stepped and looked at as they are.
            step_s: _,
            steps_per_action: _,
            body: _,
            held_m: _,
            floor: _,
            start_region: _,
            // Hands are anywhere at once, which is more than arms that take their time.
            arm_speed_m_s: _,
            // People come from anywhere, at any time; the starts say from which side of planes.
            beginnings,
            beginning: _,
            starts: _,
            start_areas: _,
            start: _,
            from: _,
            // Of clamping, which is not looked at.
            travel_after_contact_m: _,
            // What can be accepted is looked for by whoever tries it out.
            accepted: _,
            robots,
            links,
            obstacles,
            following,
            sensors,
            placings,
            controls,
            pose,
            repertoire,
            second,
            criteria,
            clamping,
            separation,
            search,
        } = cell;
        let SearchTable { iterations: _, actions: _, seed: _, reach_tolerance_m: _ } = search;
        keys(file);
        robots.iter().for_each(robot);
        links.iter().for_each(link);
        beginnings.iter().for_each(beginning);
        let mut fields = Self {
            worked: controls.iter().filter(|one| control(one)).count() > 0,
            doors: !cell.doors().is_none(),
            pose: !pose.is_empty(),
            reported: sensors.iter().any(|sensor| sensor.zone.is_in_fmu()),
            also: repertoire.abilities().iter().map(|ability| ability.words()).collect(),
            by_approach: approaches(criteria),
            by_others: others(cell, criteria, clamping, separation.as_ref()),
            planes: sensors.iter().any(|sensor| sensor.zone.plane().is_some()),
            ..Self::default()
        };
        obstacles.iter().for_each(|one| fields.obstacle(one));
        let mut two_hand = 0;
        for (one, placing) in sensors.iter().zip(placings) {
            two_hand += usize::from(fields.sensor(one, placing));
        }
        fields.two_hand = two_hand > 0;
        fields.refusal = refusal(second.as_ref(), !following.is_empty(), evaluated(cell, binding), two_hand);
        fields
    }

    /// Whether it is a two-hand control.
    fn sensor(
        &mut self,
        Sensor { name, kind, zone, signal: _, delay_steps: _, latched: _ }: &Sensor,
        placing: &Placing,
    ) -> bool {
        // How finely one sees and how high it is, its kind is asked. How a door opens, the line of buttons and what is added to a distance
        // are for the distance alone.
        let Placing { detection: _, height_m: _, line_m: _, opening: _, supplement_m: _ } = placing;
        for unseen in kind.unseen(placing) {
            match unseen {
                Unseen::HandsThrough => self.coarse.push(name.clone()),
                // Nobody is low.
                Unseen::LowBelow => {}
            }
        }
        match zone {
            DetectionZone::Floor(_) | DetectionZone::Plane(_) | DetectionZone::InFmu => false,
            DetectionZone::Post { .. } => true,
        }
    }

    /// In the way as it is. One that follows the FMU is refused.
    fn obstacle(&mut self, Obstacle { name: _, cuboid: _, table: _, opened_by, follows: _ }: &Obstacle) {
        self.doors |= opened_by.is_some();
    }
}

/// Where it stands, how it moves and how heavy it is, is looked at as it is.
fn robot(Robot { name: _, world_from_base: _, kinematics: _, moving_mass_kg: _, mass_place: _ }: &Robot) {}

/// Its shape is looked at as it is; its contact is of pressure, which is not looked at.
fn link(Link { name: _, robot: _, joint: _, shape: _, place: _, looks: _, contact: _ }: &Link) {}

/// Everybody begins with the FMU, or comes later.
fn beginning(InitialCondition { start: _, lead_in_steps: _ }: &InitialCondition) {}

/// Whether it is worked: at any moment, by whoever may.
fn control(Control { name: _, place: _, by, kind, steps: _, door: _ }: &Control) -> bool {
    match kind {
        ControlKind::Momentary | ControlKind::Held | ControlKind::Toggled => {}
    }
    match by {
        ControlledBy::Person | ControlledBy::Anyone => true,
        ControlledBy::Nobody => false,
    }
}

/// Whether the speed of approach decides.
fn approaches(criteria: &Criteria) -> bool {
    match criteria.transient_force {
        None | Some(Criterion::Absolute) => false,
        Some(Criterion::Approach) => true,
    }
}

/// Whether anything counts but the transient force, which alone is looked at.
fn others(cell: &Workcell, criteria: &Criteria, clamping: &Clamping, separation: Option<&Separation>) -> bool {
    let Criteria { transient_force: _, clamping: _, pressure: _, moving_contact_m_s: _ } = criteria;
    let Clamping { stated_m: _, signal: _ } = clamping;
    !cell.judges_by_force_alone() || separation.is_some()
}

/// The sensor that the FMU evaluates in part.
fn evaluated<'a>(cell: &'a Workcell, binding: &Binding) -> Option<&'a str> {
    let partly = binding.sensors.iter().position(|bound| matches!(bound, SensorBinding::Both { .. }));
    partly.map(|sensor| cell.sensors[sensor].name.as_str())
}

/// Why nobody can be looked for anywhere in a cell.
fn refusal(second: Option<&SecondPerson>, follows: bool, evaluated: Option<&str>, two_hand: usize) -> Option<String> {
    if second.is_some() {
        return Some(
            "two people have their starts; to look from anywhere, leave one of them out of the cell file".to_owned(),
        );
    }
    if follows {
        return Some(
            "obstacles, sensors or controls follow the FMU, which a scan from the cell's starts looks at; from anywhere, leave \
             stands_while, moves_with, counts_while and works_while out of the cell file"
                .to_owned(),
        );
    }
    if let Some(name) = evaluated {
        return Some(format!(
            "the FMU evaluates `{name}` in part, which a scan from the cell's starts looks at; from anywhere, leave `evaluated` out of \
             the cell file, and connect its `variable` to the whole signal"
        ));
    }
    (two_hand > MOST_TWO_HAND).then(|| {
        format!("the cell has {two_hand} two-hand controls; up to {MOST_TWO_HAND} can be looked at from anywhere")
    })
}

/// The options that say how far and how hard is looked: each is told, or does not change the result.
pub(super) fn options(effort: &AnalysisLimits<'_>) {
    let AnalysisLimits {
        // The scope.
        until: _,
        // What they leave out is told by the search.
        most_states: _,
        presses: _,
        answers: _,
        // The result is the same.
        workers: _,
        state: _,
    } = effort;
}
