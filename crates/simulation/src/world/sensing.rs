//! What the sensors tell of the people on their way, and what the FMU is told: step after step, with what is on its way since before.

use std::ops::Range;

use super::{Occupant, OperatedControls, World};
use crate::cell::binding::SensorBinding;
use crate::cell::{DetectionZone, Sensor};
use crate::detection_plane::DetectionPlane;
use crate::geometry::Vec3;
use crate::geometry::segment_cuboid::point_cuboid;
use crate::human::low::OnFloor;
use crate::human::walk::WalkTrace;
use crate::human::{BendFraction, Place, Posture, Presses};
use crate::robot::RobotFrame;
use crate::sensors::{DelayLine, SensorTarget, input_row, sees};

/// What there is to see at the start of a step, whatever was seen before.
#[derive(Clone, Debug)]
pub struct RawReadings {
    /// The person, without the body.
    seen: SensorTarget,
    /// What each sensor sees.
    raw: Vec<bool>,
    /// What of that the FMU does not see itself.
    unknown: Vec<bool>,
}

impl RawReadings {
    /// What there is to see of two people: a sensor sees either.
    #[must_use]
    pub fn of_either(first: &[Self], second: &[Self]) -> Vec<Self> {
        let both = |a: &[bool], b: &[bool]| a.iter().zip(b).map(|(first, second)| *first || *second).collect();
        let either = |(first, second): (&Self, &Self)| Self {
            seen: first.seen.clone(),
            raw: both(&first.raw, &second.raw),
            unknown: both(&first.unknown, &second.unknown),
        };
        first.iter().zip(second).map(either).collect()
    }
}

/// Sensors and inputs over one action.
#[derive(Clone, Debug)]
pub struct InputTrace {
    /// FMU inputs, one row a step.
    pub inputs: Vec<f64>,
    /// The delay lines afterwards.
    pub delays: Vec<DelayLine>,
    /// Controls that stay switched over afterwards.
    pub switched: Presses,
    /// Readings in effect at the start of each step.
    pub readings: Vec<Vec<bool>>,
    /// For each step and light curtain, how many samples ago it was first broken; 0 for not at all.
    pub broken: Vec<Vec<usize>>,
}

impl InputTrace {
    /// Whether the FMU and the contact rules see the same.
    #[must_use]
    pub fn same(&self, other: &Self) -> bool {
        let bits = |s: &Self| s.inputs.iter().map(|v| v.to_bits()).collect::<Vec<_>>();
        self.delays == other.delays
            && self.switched == other.switched
            && self.readings == other.readings
            && self.broken == other.broken
            && bits(self) == bits(other)
    }
}

impl World {
    /// Sensors that have been reading for long what they read at the start.
    #[must_use]
    pub fn delays_at_start(&self) -> Vec<DelayLine> {
        let told = self.readings_at_start();
        let settled = |((s, raw), told): ((&Sensor, bool), bool)| {
            remembered(s, DelayLine::steady_with(told, raw, s.delay_steps).latching(s.latched, told))
        };
        self.cell.sensors.iter().zip(self.seen_at_start()).zip(told).map(settled).collect()
    }

    /// What the FMU is told of the sensors at the start. Who stands upright is seen by all that it evaluates itself.
    #[must_use]
    pub fn readings_at_start(&self) -> Vec<bool> {
        let told = |(raw, bound): (bool, &SensorBinding)| raw && !bound.is_evaluated();
        self.seen_at_start().into_iter().zip(&self.binding.sensors).map(told).collect()
    }

    /// The input values an FMU gets at initialisation: sensors as they read at the start.
    #[must_use]
    pub fn initial_inputs(&self) -> Vec<f64> {
        let seen = self.first.sensor_target(&self.first.start(), Posture::Upright);
        let readings = self.readings_at_start();
        let mut row = Vec::new();
        input_row(&self.cell, &self.binding, &readings, &seen, Presses::NONE, &mut row);
        row
    }

    /// Whether inputs and contacts of an action depend on the walk only, and not on the posture of who stands.
    #[must_use]
    pub(crate) fn posture_is_unseen(&self) -> bool {
        self.first.curtains.is_empty()
    }

    /// Sensor readings at the start of each step, and the FMU inputs that follow, while controls are worked.
    #[must_use]
    pub fn sense(
        &self,
        delays: &[DelayLine],
        switched: Presses,
        sights: &[RawReadings],
        worked: &OperatedControls,
    ) -> InputTrace {
        let steps = sights.len();
        let mut sensed = InputTrace {
            inputs: Vec::with_capacity(steps * self.binding.inputs.len()),
            delays: delays.to_vec(),
            switched: self.switched_after(switched, worked),
            readings: Vec::with_capacity(steps),
            broken: Vec::with_capacity(steps),
        };
        for (step, RawReadings { seen, raw, unknown }) in sights.iter().enumerate() {
            let by_arm: Vec<usize> =
                self.arm_in_planes(step, worked).map(|plane| self.first.curtains[plane].sensor).collect();
            let sensors = self.cell.sensors.iter().zip(&mut sensed.delays).enumerate();
            let reading = |(number, (sensor, line)): (usize, (&Sensor, &mut DelayLine))| {
                told(sensor, line, [raw[number], unknown[number]], by_arm.contains(&number))
            };
            let readings: Vec<bool> = sensors.map(reading).collect();
            let on = self.on_in_step(step, switched, worked);
            input_row(&self.cell, &self.binding, &readings, seen, on, &mut sensed.inputs);
            sensed.readings.push(readings);
            sensed.broken.push(self.first.curtains.iter().map(|c| sensed.delays[c.sensor].first_seen()).collect());
        }
        for (sensor, line) in self.cell.sensors.iter().zip(&mut sensed.delays) {
            *line = remembered(sensor, *line);
        }
        sensed
    }

    /// An arm is in the plane of `sensor` in these steps of an action: its reading, and what the FMU is told.
    pub(crate) fn report_arm(&self, sensor: usize, steps: Range<usize>, sensed: &mut InputTrace) {
        let Some(column) = self.binding.sensors[sensor].input() else { return };
        let active = self.cell.sensors[sensor].signal.value(true);
        let rows = sensed.inputs.chunks_mut(self.binding.inputs.len());
        // What is held stays when the arm is back.
        let end = if self.cell.sensors[sensor].latched { usize::MAX } else { steps.end };
        for (row, readings) in rows.zip(&mut sensed.readings).take(end).skip(steps.start) {
            row[column] = active;
            readings[sensor] = true;
        }
    }

    /// Whether a sensor reports the person: what it told the FMU at the start of the step, or what the FMU says at the step's
    /// end of one that it evaluates.
    #[must_use]
    pub fn reading(&self, sensor: usize, readings: &[bool], frame: &RobotFrame) -> bool {
        // Of one that the FMU evaluates alone nothing is read outside of it.
        readings[sensor] || self.binding.sensors[sensor].reports(frame.outputs(), self.cell.sensors[sensor].signal)
    }

    /// Whether each sensor reports the person, see [`World::reading`].
    #[must_use]
    pub fn readings(&self, readings: &[bool], frame: &RobotFrame) -> Vec<bool> {
        (0..readings.len()).map(|sensor| self.reading(sensor, readings, frame)).collect()
    }

    /// Whether any sensor reports the person.
    #[must_use]
    pub fn any_reports(&self, readings: &[bool], frame: &RobotFrame) -> bool {
        (0..readings.len()).any(|sensor| self.reading(sensor, readings, frame))
    }
}

impl Occupant {
    /// Whether inputs and contacts of an action along this way do not depend on the posture of who stands: no plane that would tell of the
    /// body is near.
    #[must_use]
    pub fn posture_is_unseen_on(&self, walked: &WalkTrace) -> bool {
        std::iter::once(&walked.start).chain(&walked.places).all(|place| !self.may_be_in_a_plane(place))
    }

    /// Whether some part of the body, in some posture, could be in a plane that tells of it.
    fn may_be_in_a_plane(&self, place: &Place) -> bool {
        let middle = self.position(place) + Vec3::Z;
        let near = |c: &DetectionPlane| !c.hands_only && point_cuboid(middle, &c.plane).distance <= self.body_reach_m;
        self.curtains.iter().any(near)
    }

    /// The person at `place` as sensors see it.
    fn sensor_target(&self, place: &Place, bent: Posture) -> SensorTarget {
        let position = self.position(place);
        let heading_rad = place.heading_rad(&self.cell.start);
        let body = self
            .may_be_in_a_plane(place)
            .then(|| self.body().placed(position, heading_rad, bent, self.bend(place, bent)));
        // Bends leave the feet where they are.
        let fraction = if bent.is_low() { self.bend(place, bent) } else { BendFraction::FULL };
        let OnFloor { feet, besides } = self.body().on_floor(position, heading_rad, bent, fraction);
        SensorTarget { feet, besides, body, position, heading_rad }
    }

    /// What each sensor sees of the person at a place.
    pub(super) fn seen_by_each(&self, place: &Place, bent: Posture) -> Vec<bool> {
        let seen = self.sensor_target(place, bent);
        self.cell.sensors.iter().map(|sensor| sees(sensor, &seen)).collect()
    }

    /// What of `raw` the FMU does not see itself, of who is at `place`: all, where it evaluates nothing; and of what it evaluates bodies
    /// that are in a plane only because of how they bend. It knows where the feet are.
    fn unknown_to_fmu(&self, raw: &[bool], place: &Place) -> Vec<bool> {
        let is_evaluated = |(seen, bound): (&bool, &SensorBinding)| *seen && bound.is_evaluated();
        if !raw.iter().zip(&self.binding.sensors).any(is_evaluated) {
            return raw.to_vec();
        }
        let upright = self.sensor_target(place, Posture::Upright);
        let sensors = raw.iter().zip(&self.binding.sensors).zip(&self.cell.sensors);
        sensors.map(|((seen, bound), sensor)| *seen && !(bound.is_evaluated() && sees(sensor, &upright))).collect()
    }

    /// What there is for the sensors to see of this person at the start of each step.
    #[must_use]
    pub fn sights(&self, walked: &WalkTrace, bent: Posture) -> Vec<RawReadings> {
        let steps = walked.places.len();
        let sight = |(place, during): (&Place, &Place)| {
            let arrangement = during.arrangement();
            let place = place.amid(arrangement);
            let seen = self.sensor_target(&place, bent);
            let counts = |number: usize| self.cell.following.counts(number, arrangement);
            let sensors = self.cell.sensors.iter().enumerate();
            let raw: Vec<bool> = sensors.map(|(number, sensor)| sees(sensor, &seen) && counts(number)).collect();
            let unknown = self.unknown_to_fmu(&raw, &place);
            RawReadings { seen: SensorTarget { body: None, ..seen }, raw, unknown }
        };
        let begins = std::iter::once(&walked.start).chain(&walked.places).take(steps);
        begins.zip(&walked.places).map(sight).collect()
    }
}

/// The reading of a sensor that takes effect when it next sees `raw` of the body, of which the FMU does not know `unknown`, or an
/// arm on its way to a control: of that it is told like of the body, but whose body is there, it does not say.
const fn told(sensor: &Sensor, line: &mut DelayLine, [raw, unknown]: [bool; 2], by_arm: bool) -> bool {
    match sensor.zone {
        // Hands that are back on it were never away.
        DetectionZone::Post { .. } => line.push_anew(raw || by_arm, sensor.delay_steps),
        DetectionZone::Floor(_) | DetectionZone::Plane(_) | DetectionZone::InFmu => {
            line.push_apart(unknown || by_arm, raw, sensor.delay_steps)
        }
    }
}

/// Only where hands may be behind a plane it matters since when.
fn remembered(sensor: &Sensor, line: DelayLine) -> DelayLine {
    if sensor.zone.plane().is_some() { line } else { line.on_its_way() }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A sensor that tells three steps late saw somebody at the last sample, or nobody: until then the FMU is told the same.
    #[test]
    fn what_is_only_on_its_way_is_not_the_same() {
        let sensed = |seen: bool| {
            let mut line = DelayLine::steady(false, 3);
            let told = line.push(seen, 3);
            assert!(!told);
            InputTrace {
                inputs: vec![1.0],
                delays: vec![line.on_its_way()],
                switched: Presses::NONE,
                readings: vec![vec![told]],
                broken: vec![Vec::new()],
            }
        };
        assert!(sensed(true).same(&sensed(true)) && sensed(false).same(&sensed(false)));
        assert!(!sensed(true).same(&sensed(false)) && !sensed(false).same(&sensed(true)));
    }
}
