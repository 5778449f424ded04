//! The virtual human's arm: four joints, two capsules, and a sphere at the wrist that stands for every hand pose.
//!
//! Joint ranges with their couplings after Klopcar and Lenarcic (Meccanica 40, 2005), lengths after ISO 13857 as in
//! Huck et al. 2021. The published text does not settle the order of the shoulder's axes; here, from the hanging arm
//! outwards: elbow, rotation about the upper arm, flexion about the lateral axis, abduction about the forward axis.

use super::Side;
use crate::geometry::{Vec3, rotation_about};
use crate::standards::iso_13857::{FOREARM_M, HAND_RADIUS_M, UPPER_ARM_M};

/// Joint angles in radians: abduction, flexion, rotation of the upper arm (inwards positive), elbow flexion (0 is
/// straight).
pub(crate) type Config = [f64; 4];

/// Lengths and radii of an arm, m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmModel {
    /// Shoulder joint to elbow.
    pub upper_arm_m: f64,
    /// Elbow to wrist.
    pub forearm_m: f64,
    /// Sphere around the wrist that every point of the hand, and of what it holds, stays in.
    pub hand_radius_m: f64,
    /// Capsule radius of the upper arm.
    pub upper_arm_radius_m: f64,
    /// Capsule radius of the forearm.
    pub forearm_radius_m: f64,
}

impl Default for ArmModel {
    /// 0.30 m, 0.32 m and 0.23 m (ISO 13857 Table 3); radii of a median man.
    fn default() -> Self {
        Self {
            upper_arm_m: UPPER_ARM_M,
            forearm_m: FOREARM_M,
            hand_radius_m: HAND_RADIUS_M,
            upper_arm_radius_m: 0.055,
            forearm_radius_m: 0.045,
        }
    }
}

/// The part of the length of what is held that its contacts are looked for to.
const HELD_TOLERANCE: f64 = 0.1;

/// What rounding puts a finger tip beyond itself, m.
const ROUNDING_M: f64 = 1e-6;

const DEG: f64 = std::f64::consts::PI / 180.0;

/// Range of abduction, rad.
pub const ABDUCTION: (f64, f64) = (-10.0 * DEG, 170.0 * DEG);
/// Range of elbow flexion, rad: -90 to 60 degrees in the source, where 0 is the right angle.
pub const ELBOW: (f64, f64) = (0.0, 150.0 * DEG);

/// Range of flexion at an abduction; both bounds are linear in it.
#[must_use]
pub fn flexion_range(abduction: f64) -> (f64, f64) {
    (-60.0 * DEG + abduction / 3.0, 170.0 * DEG - abduction / 6.0)
}

/// Range of the rotation of the upper arm at an abduction and a flexion; both bounds are bilinear in them.
#[must_use]
pub fn rotation_range(abduction: f64, flexion: f64) -> (f64, f64) {
    let (a, f) = (abduction / DEG, flexion / DEG);
    let low = -60.0 + 7.0 * a / 9.0 - f / 9.0 + 2.0 * a * f / 810.0;
    let high = 90.0 + 4.0 * a / 9.0 - 5.0 * f / 9.0 + 5.0 * a * f / 810.0;
    (low * DEG, high * DEG)
}

/// The configuration within the limits that is nearest joint by joint.
#[must_use]
pub(crate) fn clamped([abduction, flexion, rotation, elbow]: Config) -> Config {
    let abduction = abduction.clamp(ABDUCTION.0, ABDUCTION.1);
    let (low, high) = flexion_range(abduction);
    let flexion = flexion.clamp(low, high);
    let (low, high) = rotation_range(abduction, flexion);
    [abduction, flexion, rotation.clamp(low, high), elbow.clamp(ELBOW.0, ELBOW.1)]
}

impl ArmModel {
    /// The arm of somebody who holds a thing that reaches so far beyond the finger tips, m, in whatever direction the hand turns it.
    #[must_use]
    pub fn holding(held_m: f64) -> Self {
        Self { hand_radius_m: HAND_RADIUS_M + held_m, ..Self::default() }
    }

    /// How far what the hand holds reaches beyond the finger tips, m; 0 for nothing.
    #[must_use]
    pub(crate) fn held_m(&self) -> f64 {
        self.hand_radius_m - HAND_RADIUS_M
    }

    /// How deep a contact of the hand, and of what it holds, may be and still be missed where one of the arm may be missed that is no
    /// deeper than `tolerance_m`, m: how long a thing is, and how it is held, is known to a tenth.
    #[must_use]
    pub fn hand_tolerance_m(&self, tolerance_m: f64) -> f64 {
        tolerance_m + HELD_TOLERANCE * self.held_m()
    }

    /// How far beyond the finger tips of a hand with this wrist a point is, m; nothing for a point that fingers get to.
    #[must_use]
    pub fn beyond_fingers_m(wrist: Vec3, point: Vec3) -> Option<f64> {
        let beyond_m = (point - wrist).length() - HAND_RADIUS_M;
        (beyond_m > ROUNDING_M).then_some(beyond_m)
    }

    /// Farthest distance of a hand point from the shoulder joint, m.
    #[must_use]
    pub fn reach(&self) -> f64 {
        self.upper_arm_m + self.forearm_m + self.hand_radius_m
    }

    /// No wrist is farther from where it hangs, m.
    #[must_use]
    pub fn farthest_from_hanging_m(&self) -> f64 {
        2.0 * (self.upper_arm_m + self.forearm_m)
    }

    /// Elbow and wrist of a left arm in the shoulder frame, from sine and cosine of each joint angle.
    #[must_use]
    pub(crate) fn at(&self, [abduction, flexion, rotation, elbow]: &[(f64, f64); 4]) -> [Vec3; 2] {
        let sideways = |forwards: f64, side: f64, up: f64| {
            Vec3::new(forwards, side * abduction.1 - up * abduction.0, side * abduction.0 + up * abduction.1)
        };
        let raised = |forwards: f64, side: f64, up: f64| {
            sideways(forwards * flexion.1 - up * flexion.0, side, forwards * flexion.0 + up * flexion.1)
        };
        let bent = self.forearm_m * elbow.0;
        let wrist = raised(bent * rotation.1, -bent * rotation.0, -self.upper_arm_m - self.forearm_m * elbow.1);
        [raised(0.0, 0.0, -self.upper_arm_m), wrist]
    }

    /// Elbow and wrist in the shoulder frame (x forward, y left, z up; the arm hangs along -z at zero).
    #[must_use]
    pub fn forward(&self, side: Side, [abduction, flexion, rotation, elbow]: Config) -> (Vec3, Vec3) {
        // The right arm is the left one seen in a mirror: rotations about x and z change sign.
        let mirror = side.sign();
        let upper = rotation_about(Vec3::X, mirror * abduction) * rotation_about(Vec3::Y, -flexion);
        let fore = upper * rotation_about(Vec3::Z, -mirror * rotation) * rotation_about(Vec3::Y, -elbow);
        let at_elbow = upper * Vec3::new(0.0, 0.0, -self.upper_arm_m);
        (at_elbow, at_elbow + fore * Vec3::new(0.0, 0.0, -self.forearm_m))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn near(a: Vec3, b: [f64; 3]) {
        assert!((a - Vec3::from_array(b)).length() < 1e-12, "{a} {b:?}");
    }

    #[test]
    fn poses_by_hand() {
        let arm = ArmModel::default();
        let quarter = 90.0 * DEG;
        let (elbow, wrist) = arm.forward(Side::Left, [0.0; 4]);
        near(elbow, [0.0, 0.0, -0.30]);
        near(wrist, [0.0, 0.0, -0.62]);
        // Elbow bent: the forearm points forward.
        near(arm.forward(Side::Left, [0.0, 0.0, 0.0, quarter]).1, [0.32, 0.0, -0.30]);
        // Raised forward, straight: both point forward.
        near(arm.forward(Side::Right, [0.0, quarter, 0.0, 0.0]).1, [0.62, 0.0, 0.0]);
        // Raised sideways: outwards on each side.
        near(arm.forward(Side::Left, [quarter, 0.0, 0.0, 0.0]).1, [0.0, 0.62, 0.0]);
        near(arm.forward(Side::Right, [quarter, 0.0, 0.0, 0.0]).1, [0.0, -0.62, 0.0]);
        // Hanging, elbow bent, rotated inwards: the forearm lies across the belly.
        near(arm.forward(Side::Left, [0.0, 0.0, quarter, quarter]).1, [0.0, -0.32, -0.30]);
        near(arm.forward(Side::Right, [0.0, 0.0, quarter, quarter]).1, [0.0, 0.32, -0.30]);
    }

    #[test]
    fn by_sines_and_cosines_it_is_the_same() {
        let arm = ArmModel::default();
        let config = [0.4, 0.7, -0.3, 1.1];
        let [elbow, wrist] = arm.at(&config.map(libm::sincos));
        for (side, mirror) in [(Side::Left, Vec3::ONE), (Side::Right, Vec3::new(1.0, -1.0, 1.0))] {
            let (e, w) = arm.forward(side, config);
            assert!((e - elbow * mirror).length() < 1e-15 && (w - wrist * mirror).length() < 1e-15, "{side:?}");
        }
    }

    #[test]
    fn published_rotation_ranges() {
        for ((a, f), (low, high)) in [
            ((0.0, 0.0), (-60.0, 90.0)),
            ((90.0, 0.0), (10.0, 130.0)),
            ((0.0, 90.0), (-70.0, 40.0)),
            ((90.0, 90.0), (20.0, 130.0)),
        ] {
            let range = rotation_range(a * DEG, f * DEG);
            assert!((range.0 / DEG - low).abs() < 1e-9 && (range.1 / DEG - high).abs() < 1e-9, "{a} {f}: {range:?}");
        }
    }

    #[test]
    fn wrist_distances_span_what_the_lengths_allow() {
        // 150 degrees of flexion: sqrt(0.3^2 + 0.32^2 - 2 * 0.3 * 0.32 * cos 30) = 0.1616 m.
        let arm = ArmModel::default();
        let at = |e| arm.forward(Side::Left, [0.3, 0.4, 0.2, e]).1.length();
        assert!((at(ELBOW.0) - 0.62).abs() < 1e-12);
        assert!((at(ELBOW.1) - 0.161_6).abs() < 1e-4, "{}", at(ELBOW.1));
    }
}
