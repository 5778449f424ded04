//! What the sensors report while the person walks, including their response time.
//!
//! A sensor is sampled at the *start* of each communication step, from where the person stands then; its FMU input
//! changes `delay_steps` later. Feet and legs do not move with the bends, so the readings depend on the walk alone.

use crate::cell::format::SensorKind;
use crate::cell::{Binding, Sensor};
use crate::geometry::Vec3;

/// The delay line of one sensor: bit `i` is the raw reading `i` steps ago.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord)]
pub struct DelayLine(u64);

impl DelayLine {
    /// A sensor that has been reading `raw` for long.
    #[must_use]
    pub const fn settled(raw: bool) -> Self {
        Self(if raw { u64::MAX } else { 0 })
    }

    /// Takes in the next raw reading; returns the reading that takes effect now.
    pub const fn push(&mut self, raw: bool, delay_steps: usize) -> bool {
        self.0 = (self.0 << 1) | raw as u64;
        (self.0 >> delay_steps) & 1 == 1
    }

    /// The reading in effect.
    #[must_use]
    pub const fn output(self, delay_steps: usize) -> bool {
        (self.0 >> delay_steps) & 1 == 1
    }
}

/// Whether `sensor` sees a person whose feet are at `feet` (floor points below the ankles, m).
///
/// A mat fires when the middle of a foot's support is on it, a scanner field when the axis of a leg is in it: half of
/// the leg, about 55 mm, is then inside, near the 70 mm that person-detecting scanners resolve.
#[must_use]
pub fn sees(sensor: &Sensor, feet: &[Vec3; 2]) -> bool {
    match sensor.kind {
        SensorKind::Mat | SensorKind::ScannerField => feet.iter().any(|f| inside(&sensor.polygon, f.x, f.y)),
    }
}

/// Even-odd rule; points exactly on the left or lower edge count as inside.
fn inside(polygon: &[[f64; 2]], x: f64, y: f64) -> bool {
    let mut odd = false;
    let mut previous = polygon[polygon.len() - 1];
    for &corner in polygon {
        let [(x1, y1), (x2, y2)] = [previous, corner].map(|c| (c[0], c[1]));
        if (y1 > y) != (y2 > y) && x < (x2 - x1) * (y - y1) / (y2 - y1) + x1 {
            odd = !odd;
        }
        previous = corner;
    }
    odd
}

/// One row of FMU inputs for the readings in effect.
pub fn input_row(sensors: &[Sensor], binding: &Binding, readings: &[bool], row: &mut Vec<f64>) {
    let start = row.len();
    let distinct = binding.inputs.len() - binding.constants.len();
    // An input is active when any of its sensors is.
    row.resize(start + distinct, 0.0);
    for ((sensor, &input), &reading) in sensors.iter().zip(&binding.sensor_inputs).zip(readings) {
        let others = sensors.iter().zip(&binding.sensor_inputs).zip(readings);
        let any = reading || others.filter(|((_, i), _)| **i == input).any(|(_, r)| *r);
        row[start + input] = f64::from(u8::from(any == sensor.active));
    }
    row.extend_from_slice(&binding.constants);
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_delay_of_three_steps_takes_three_steps() {
        let mut line = DelayLine::settled(false);
        let out: Vec<bool> = [true, true, false, false, false, false].iter().map(|&r| line.push(r, 3)).collect();
        assert_eq!(out, [false, false, false, true, true, false]);
        assert!(DelayLine::settled(true).push(false, 63));
    }

    #[test]
    fn an_l_shaped_zone() {
        let zone = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];
        for (x, y, expected) in [(0.5, 1.5, true), (1.5, 0.5, true), (1.5, 1.5, false), (-0.1, 0.5, false)] {
            assert_eq!(inside(&zone, x, y), expected, "({x}, {y})");
        }
    }
}
