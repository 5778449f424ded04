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

/// What stands behind how far somebody reaches through an opening.
pub(super) const OPENING_TABLES: [Table; 1] = [Table {
    id: "iso_13857_openings",
    title: "ISO 13857:2019, Table 4: reaching through slots, persons of 14 years and above",
    source: "public secondary sources that quote Table 4",
    confidence: "the rule above 120 mm in two independent public sources, the distances in one",
    verified: false,
}];

/// How far somebody reaches through a slot so wide, m; none where more than an arm gets through.
#[must_use]
pub(crate) fn reach_through_slot_m(width_m: f64) -> Option<f64> {
    let rows = [(4, 2), (6, 10), (8, 20), (10, 80), (12, 100), (20, 120), (120, 850)];
    let width_mm = width_m * 1000.0 - 1e-6;
    let row = rows.into_iter().find(|(up_to, _)| width_mm <= f64::from(*up_to))?;
    Some(f64::from(row.1) / 1000.0)
}

/// Safety distance when the arm is held at the shoulder only, m: the whole arm reaches.
pub(crate) const FROM_SHOULDER_M: f64 = 0.85;
/// Safety distance when the arm is held up to the elbow, m: forearm and hand reach.
pub(crate) const FROM_ELBOW_M: f64 = 0.55;
/// Safety distance when the arm is held up to the wrist, m: the hand reaches.
pub(crate) const FROM_WRIST_M: f64 = 0.23;

/// Length of the upper arm, m (0.30): what letting go of the elbow adds.
pub(crate) const UPPER_ARM_M: f64 = FROM_SHOULDER_M - FROM_ELBOW_M;
/// Length of the forearm, m (0.32): what letting go of the wrist adds.
pub(crate) const FOREARM_M: f64 = FROM_ELBOW_M - FROM_WRIST_M;
/// Radius of the sphere around the wrist that stands for every pose of the hand, m.
pub(crate) const HAND_RADIUS_M: f64 = FROM_WRIST_M;

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

    /// Up to 4 mm a fingertip, up to 20 mm a hand, and then the arm: a slot is longer than 65 mm here.
    #[test]
    fn wider_slots_let_more_through() {
        for (width_mm, reach_mm) in
            [(0.0, 2.0), (4.0, 2.0), (4.1, 10.0), (8.0, 20.0), (20.0, 120.0), (20.1, 850.0), (120.0, 850.0)]
        {
            assert_eq!(reach_through_slot_m(width_mm / 1000.0), Some(reach_mm / 1000.0), "{width_mm}");
        }
        assert_eq!(reach_through_slot_m(0.121), None);
    }

    /// The standard's arm is meant for the 95th percentile: longer than a median man's measured arm, and within
    /// 3 cm of a long one's (acromion to radiale to wrist, plus the hand).
    #[test]
    fn whole_arm_agrees_with_measured_arms() {
        let whole = UPPER_ARM_M + FOREARM_M + HAND_RADIUS_M;
        let measured = |percentile| measures(Sex::Man, percentile).arm_length_m;
        assert!(whole > measured(Percentile::P50));
        assert!((whole - measured(Percentile::P95)).abs() < 0.03);
    }
}
