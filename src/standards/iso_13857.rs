//! The arm that ISO 13857 assumes: lengths derived from its distances for reaching around with limited movement.
//!
//! The table states how far danger must be behind an opening for an arm that is held back at the shoulder, the elbow or
//! the wrist. Each step between two rows is the length of the segment set free.

use super::provenance::Table;

/// What stands behind the data of this file.
pub(super) const TABLES: [Table; 1] = [Table {
    id: "iso_13857_reach_around",
    title: "ISO 13857:2019, Table 3: reaching around with limitation of movement",
    source: "public secondary sources that quote Table 3",
    confidence: "the full arm (850 mm) in two independent public sources; elbow (550 mm) and wrist (230 mm) in one",
    verified: false,
}];

/// Safety distance when the arm is held at the shoulder only, m: the whole arm reaches.
pub const FROM_SHOULDER_M: f64 = 0.85;
/// Safety distance when the arm is held up to the elbow, m: forearm and hand reach.
pub const FROM_ELBOW_M: f64 = 0.55;
/// Safety distance when the arm is held up to the wrist, m: the hand reaches.
pub const FROM_WRIST_M: f64 = 0.23;

/// Length of the upper arm, m (0.30): what letting go of the elbow adds.
pub const UPPER_ARM_M: f64 = FROM_SHOULDER_M - FROM_ELBOW_M;
/// Length of the forearm, m (0.32): what letting go of the wrist adds.
pub const FOREARM_M: f64 = FROM_ELBOW_M - FROM_WRIST_M;
/// Radius of the sphere around the wrist that stands for every pose of the hand, m.
pub const HAND_RADIUS_M: f64 = FROM_WRIST_M;

#[cfg(test)]
mod tests {
    use super::*;
    use crate::standards::anthropometry::{Percentile, Sex, measures};

    /// The lengths that Huck et al. (ICRA 2021) print.
    #[test]
    fn segments_are_those_of_the_paper() {
        assert!((UPPER_ARM_M - 0.30).abs() < 1e-12);
        assert!((FOREARM_M - 0.32).abs() < 1e-12);
        assert!((HAND_RADIUS_M - 0.23).abs() < 1e-12);
    }

    /// The standard's arm is meant for the 95th percentile: longer than a median man's measured arm, and within
    /// 3 cm of a long one's (acromion to radiale to wrist, plus the hand).
    #[test]
    fn whole_arm_agrees_with_measured_arms() {
        let whole = UPPER_ARM_M + FOREARM_M + HAND_RADIUS_M;
        let measured = |percentile| measures(Sex::Male, percentile).arm_length_m;
        assert!(whole > measured(Percentile::P50));
        assert!((whole - measured(Percentile::P95)).abs() < 0.03);
    }
}
