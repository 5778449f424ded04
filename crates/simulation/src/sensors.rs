//! What the sensors report while the person walks, including their response time, and what of the person's pose the
//! FMU is told.
//!
//! A sensor is sampled at the *start* of each communication step, from where the person stands then; its FMU input
//! changes `delay_steps` later. Feet and legs do not move with the bends, so all readings but those of light curtains
//! depend on the walk alone.

use crate::cell::file::format::PoseQuantity;
use crate::cell::{Binding, DetectionZone, Sensor, Workcell};
use crate::geometry::polygon::contains;
use crate::geometry::segment_cuboid::segment_cuboid;
use crate::geometry::{Cuboid, Vec3};
use crate::human::{PlacedBody, Presses};

/// Whether a sensor's reading is held once it has taken effect.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
enum Latch {
    /// It is not.
    #[default]
    None,
    /// It will be.
    Armed,
    /// It is.
    Held,
}

/// What is remembered of a sensor's raw readings: those still on their way to the FMU, how long ago the sensor first
/// saw the person, and whether its reading is held. Nothing else of the past matters, so equal lines have equal futures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct DelayLine {
    /// Bit `i` is the raw reading `i` steps ago, as many as are on their way.
    recent: u64,
    /// Samples since the person was first seen, that one included; 0 for never.
    seen: u8,
    latch: Latch,
}

impl DelayLine {
    /// More samples than this are not told apart: a hand gets anywhere in that time.
    pub(crate) const LONGEST: u8 = 64;

    /// A sensor that has been reading `raw` for long.
    #[must_use]
    pub const fn steady(raw: bool, delay_steps: usize) -> Self {
        let (recent, seen) = if raw { (Self::kept(delay_steps), Self::LONGEST) } else { (0, 0) };
        Self { recent, seen, latch: Latch::None }
    }

    /// The same where the FMU has been `told` for long what is not seen of the body.
    #[must_use]
    pub(crate) const fn steady_with(told: bool, raw: bool, delay_steps: usize) -> Self {
        Self { seen: Self::steady(raw, delay_steps).seen, ..Self::steady(told, delay_steps) }
    }

    /// The same of a sensor that is `latched`, if it is: one whose reading is held from when it has taken effect, as it has where it
    /// was `told` for long.
    #[must_use]
    pub const fn latching(self, latched: bool, told: bool) -> Self {
        let latch = match (latched, told) {
            (false, _) => Latch::None,
            (true, false) => Latch::Armed,
            (true, true) => Latch::Held,
        };
        Self { latch, ..self }
    }

    /// Bits still on their way after a reading has taken effect.
    const fn kept(delay_steps: usize) -> u64 {
        if delay_steps >= 64 { u64::MAX } else { (1 << delay_steps) - 1 }
    }

    /// Takes in the next raw reading; returns the reading that takes effect now.
    pub const fn push(&mut self, raw: bool, delay_steps: usize) -> bool {
        let line = (self.recent << 1) | raw as u64;
        self.recent = line & Self::kept(delay_steps);
        if (raw || self.seen > 0) && self.seen < Self::LONGEST {
            self.seen += 1;
        }
        let told = (line >> delay_steps) & 1 == 1;
        match self.latch {
            Latch::None => return told,
            Latch::Armed if told => self.latch = Latch::Held,
            Latch::Armed => return false,
            Latch::Held => {}
        }
        // What is on its way to an input that is held changes nothing.
        self.recent = 0;
        true
    }

    /// The same where what is `told` is not what is seen of the body: a hand that works a control is in the plane, or the FMU sees
    /// the body itself.
    pub(crate) const fn push_apart(&mut self, told: bool, raw: bool, delay_steps: usize) -> bool {
        let mut body = *self;
        body.push(raw, delay_steps);
        let told = self.push(told, delay_steps);
        self.seen = body.seen;
        told
    }

    /// Takes in the next raw reading of a sensor that counts only from when it last began to see the person.
    pub(crate) const fn push_anew(&mut self, raw: bool, delay_steps: usize) -> bool {
        if !raw {
            self.seen = 0;
        }
        self.push(raw, delay_steps)
    }

    /// The same without how long ago the person was first seen, for sensors where that does not matter.
    #[must_use]
    pub const fn on_its_way(self) -> Self {
        Self { seen: 0, ..self }
    }

    /// How many samples ago the sensor first saw the person, at most [`Self::LONGEST`]: 0 for never, 1 for the last
    /// sample only.
    #[must_use]
    pub const fn first_seen(self) -> usize {
        self.seen as usize
    }
}

/// The person as sensors see it.
#[derive(Clone, Debug)]
pub struct SensorTarget {
    /// Floor points below the ankles, left and right, m; below the knees of who kneels or crawls.
    pub feet: [Vec3; 2],
    /// What else touches the floor.
    pub besides: Option<[Vec3; 4]>,
    /// The body, if the cell has a light curtain.
    pub body: Option<PlacedBody>,
    /// Middle between the feet on the floor, m.
    pub position: Vec3,
    /// Heading from +x towards +y, rad.
    pub heading_rad: f64,
}

/// Whether `sensor` sees the person. One inside the FMU is not asked here.
///
/// A mat fires when the middle of a foot's support is on it, a scanner field when the axis of a leg is in it: half of
/// the leg, about 55 mm, is then inside, near the 70 mm that person-detecting scanners resolve. Knees, toes and hands on the
/// floor count as feet there. A light curtain fires
/// when any part of head, trunk or legs passes through its plane, and so does a door; a two-hand control, when a foot
/// leaves the operator's post. Arms are a matter of the contact check.
#[must_use]
pub fn sees(sensor: &Sensor, seen: &SensorTarget) -> bool {
    match &sensor.zone {
        DetectionZone::Floor(polygon) => {
            let besides = seen.besides.iter().flatten();
            seen.feet.iter().chain(besides).any(|f| contains(polygon, [f.x, f.y]))
        }
        DetectionZone::Plane(plane) => seen.body.as_ref().is_some_and(|body| breaks(body, plane)),
        // Both feet: who has one outside leans away, and the hands may be anywhere.
        DetectionZone::Post { post, .. } => !seen.feet.iter().all(|f| contains(post, [f.x, f.y])),
        DetectionZone::InFmu => false,
    }
}

/// Whether head, trunk or a leg is in a plane.
pub(super) fn breaks(body: &PlacedBody, plane: &Cuboid) -> bool {
    body.parts().iter().any(|(_, c)| segment_cuboid(c.a, c.b, plane).distance < c.radius)
}

/// One row of FMU inputs: sensors by the readings in effect, pose, controls of which these are on, constants.
pub fn input_row(
    cell: &Workcell,
    binding: &Binding,
    readings: &[bool],
    seen: &SensorTarget,
    pressed: Presses,
    row: &mut Vec<f64>,
) {
    let start = row.len();
    // An input is active when any of its sensors is.
    row.resize(start + binding.sensor_inputs, 0.0);
    for (sensor, bound) in cell.sensors.iter().zip(&binding.sensors) {
        let Some(input) = bound.input() else { continue };
        let any = binding.sensors.iter().zip(readings).any(|(other, &reading)| other.input() == Some(input) && reading);
        row[start + input] = sensor.signal.value(any);
    }
    row.extend(cell.pose.iter().map(|quantity| match quantity {
        PoseQuantity::X => seen.position.x,
        PoseQuantity::Y => seen.position.y,
        PoseQuantity::Heading => seen.heading_rad,
        PoseQuantity::LeftFootX => seen.feet[0].x,
        PoseQuantity::LeftFootY => seen.feet[0].y,
        PoseQuantity::RightFootX => seen.feet[1].x,
        PoseQuantity::RightFootY => seen.feet[1].y,
    }));
    row.extend(binding.controls.iter().enumerate().map(|(control, values)| values[usize::from(pressed.has(control))]));
    row.extend_from_slice(&binding.constants);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_delay_of_three_steps_takes_three_steps() {
        let mut line = DelayLine::steady(false, 3);
        let out: Vec<bool> = [true, true, false, false, false, false].iter().map(|&r| line.push(r, 3)).collect();
        assert_eq!(out, [false, false, false, true, true, false]);
        assert!(DelayLine::steady(true, 63).push(false, 63));
    }

    #[test]
    fn what_is_latched_is_held_from_when_it_takes_effect() {
        let mut line = DelayLine::steady(false, 2).latching(true, false);
        let raw = [false, true, false, false, false, false];
        assert_eq!(raw.map(|raw| line.push(raw, 2)), [false, false, false, true, true, true]);
        // Whoever comes again tells nothing new: the state is the same.
        let before = line.on_its_way();
        assert!(line.push(true, 2));
        assert_eq!(line.on_its_way(), before);
        // Who is seen at the start is told of for good; and what is not latched is as ever.
        assert!(DelayLine::steady(true, 0).latching(true, true).push(false, 0));
        assert!(!DelayLine::steady(true, 0).latching(false, true).push(false, 0));
    }

    #[test]
    fn hands_that_come_back_begin_anew() {
        let (mut hands, mut curtain) = (DelayLine::default(), DelayLine::default());
        let seen = |line: &mut DelayLine, raw: [bool; 5], push: fn(&mut DelayLine, bool, usize) -> bool| {
            raw.map(|raw| {
                push(line, raw, 0);
                line.first_seen()
            })
        };
        let raw = [true, true, false, false, true];
        assert_eq!(seen(&mut hands, raw, DelayLine::push_anew), [1, 2, 0, 0, 1]);
        assert_eq!(seen(&mut curtain, raw, DelayLine::push), [1, 2, 3, 4, 5]);
    }
}
