//! A box of joint angles of an arm, the thing that the search for contacts bounds, drops and splits.

use crate::human::arm::{ABDUCTION, Config, ELBOW, flexion_range, rotation_range};

/// A box of joint angles: middle and half widths.
#[derive(Clone, Copy)]
pub(super) struct JointBox {
    pub(super) middle: Config,
    pub(super) half: [f64; 4],
}

impl JointBox {
    /// All configurations: the limits of flexion and rotation at their widest.
    pub(super) fn whole() -> Self {
        let flexion = (flexion_range(ABDUCTION.0).0, flexion_range(ABDUCTION.0).1);
        let corners = [ABDUCTION.0, ABDUCTION.1].into_iter().flat_map(|a| {
            let (low, high) = flexion_range(a);
            [rotation_range(a, low), rotation_range(a, high)]
        });
        let rotation = corners.fold((f64::MAX, f64::MIN), |(l, h), (low, high)| (l.min(low), h.max(high)));
        let ranges = [ABDUCTION, flexion, rotation, ELBOW];
        Self { middle: ranges.map(|(l, h)| 0.5 * (l + h)), half: ranges.map(|(l, h)| 0.5 * (h - l)) }
    }

    pub(super) fn low(&self, joint: usize) -> f64 {
        self.middle[joint] - self.half[joint]
    }

    pub(super) fn high(&self, joint: usize) -> f64 {
        self.middle[joint] + self.half[joint]
    }

    /// The part of the box that holds all of its configurations within the joint limits, if there is any. The bounds are
    /// linear or bilinear, so their extremes over the box are at its corners; those of rotation follow from what is left of
    /// flexion.
    pub(super) fn within_limits(mut self) -> Option<Self> {
        let abduction = [self.low(0), self.high(0)];
        self.cut(1, widest(abduction.iter().map(|&a| flexion_range(a))))?;
        let flexion = [self.low(1), self.high(1)];
        let corners = abduction.iter().flat_map(|&a| flexion.map(|f| rotation_range(a, f)));
        self.cut(2, widest(corners))?;
        Some(self)
    }

    /// Leaves of one joint's range what is between two bounds.
    fn cut(&mut self, joint: usize, (least, most): (f64, f64)) -> Option<()> {
        let (low, high) = (self.low(joint), self.high(joint));
        if low < least || high > most {
            let (low, high) = (low.max(least), high.min(most));
            if low > high {
                return None;
            }
            self.middle[joint] = 0.5 * (low + high);
            // By rounding, the ends may be a little farther from the middle.
            self.half[joint] = 0.5 * (high - low) * (1.0 + 1e-12) + 1e-15;
        }
        Some(())
    }

    pub(super) fn halves(&self, joint: usize) -> [Self; 2] {
        let mut half = self.half;
        half[joint] *= 0.5;
        [-1.0, 1.0].map(|sign| {
            let mut middle = self.middle;
            middle[joint] += sign * half[joint];
            Self { middle, half }
        })
    }
}

fn widest(ranges: impl Iterator<Item = (f64, f64)>) -> (f64, f64) {
    ranges.fold((f64::MAX, f64::MIN), |(l, h), (low, high)| (l.min(low), h.max(high)))
}
