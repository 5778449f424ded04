//! What of a sensor can be turned: its kind says which changes of its zone are tried, and whether it may be held.

use super::{DesignParameters, Encounter, FARTHEST, FIXED, Modification, ParameterRange, STEP, most_words};
use crate::cell::file::format::SensorLimits;
use crate::cell::sensor::kind::{Change, Key};
use crate::cell::sensor::{Sensor, zone};
use crate::cell::workcell::Workcell;
use crate::geometry::Vec3;

/// Why a plane is left where it is.
const EVALUATED: &str = "the FMU has it where it is";

impl DesignParameters {
    pub(super) fn sensors(&mut self, cell: &Workcell, encounter: &Encounter) {
        let world_from_base = cell.robots[encounter.robot].world_from_base.translation;
        for (number, sensor) in cell.sensors.iter().enumerate() {
            let limits = cell.file().explain.sensor.get(&sensor.name).map(|limits| *limits.get_ref());
            let limits = limits.unwrap_or_default();
            let is_host_side = cell.file().sensors[number].evaluated.is_none();
            if sensor.kind.has(Key::Latched) && is_host_side && !sensor.latched && !limits.fixed {
                self.add(
                    Modification::Latched { sensor: number },
                    &sensor.name,
                    ParameterRange { steps: 1, ..ParameterRange::default() },
                );
            }
            if limits.fixed {
                self.hold(&sensor.name, FIXED);
            } else if is_host_side {
                sensor
                    .kind
                    .changes()
                    .iter()
                    .for_each(|change| self.zone((number, sensor), *change, &limits, world_from_base));
            } else {
                // Moved in the cell file alone, it would not be where the FMU sees people.
                self.hold(&sensor.name, EVALUATED);
            }
        }
    }

    /// A change of a sensor's zone, against a robot that stands there.
    fn zone(&mut self, (number, sensor): (usize, &Sensor), change: Change, limits: &SensorLimits, robot: Vec3) {
        let own = |most: Option<f64>, now: f64| most.map(|most| (most - now, most_words(most, "m")));
        let room = |allowed| ParameterRange::new(STEP, f64::INFINITY, FARTHEST, allowed);
        let plane = sensor.zone.walked_through();
        // From the robot to the plane.
        let away = || {
            let plane = plane?;
            let normal = plane.rotation * Vec3::Y;
            let side = if normal.dot(robot - plane.centre) > 0.0 { -1.0 } else { 1.0 };
            Some([side * normal.x, side * normal.y])
        };
        let (turn, room) = match change {
            Change::Wider => (Modification::Wider { sensor: number }, room(own(limits.most_wider_m, 0.0))),
            Change::Higher => {
                let Some([_, top]) = plane.map(zone::heights) else { return };
                (Modification::HigherPlane { sensor: number }, room(own(limits.most_top_m, top)))
            }
            Change::DownToTheFloor => {
                if plane.is_none_or(|plane| plane.centre.z <= plane.half.z) {
                    return;
                }
                (
                    Modification::DownToTheFloor { sensor: number },
                    ParameterRange { steps: 1, ..ParameterRange::default() },
                )
            }
            Change::MatBehind => {
                let Some(direction) = away().map(|away| away.map(|part: f64| -part)) else { return };
                (
                    Modification::MatBehind { sensor: number, direction },
                    ParameterRange { steps: FARTHEST, ..ParameterRange::default() },
                )
            }
            Change::Farther => {
                let Some(direction) = away() else { return };
                (Modification::FartherPlane { sensor: number, direction }, room(own(limits.most_farther_m, 0.0)))
            }
        };
        self.add(turn, &sensor.name, room);
    }
}
