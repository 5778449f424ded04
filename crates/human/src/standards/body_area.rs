//! The 29 areas of the body for which ISO/TS 15066:2016, Table A.2, states pressures, each with its region.

use super::BodyRegion;
use super::provenance::Table;

/// What stands behind the data of this file.
pub(super) const TABLES: [Table; 1] = [Table {
    id: "iso_ts_15066_pressure_limits",
    title: "ISO/TS 15066:2016, Table A.2: quasi-static pressure limits of 29 body areas, N/cm2; twice that for transient contact, \
            except for the head",
    source: "public secondary sources that quote Table A.2 (two safety controllers' data); the numbering from a research project",
    confidence: "two independent public sources agree on 23 of 29; shoulder joint, fifth lumbar vertebra, abdomen, pelvis, thigh, knee, \
                 shin and calf rest on one",
    verified: false,
}];

/// An area of the body, by its number in Table A.2 less one.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BodyArea {
    /// Middle of the forehead.
    MiddleOfForehead,
    /// Temple.
    Temple,
    /// Masticatory muscle.
    MasticatoryMuscle,
    /// Muscle of the neck.
    NeckMuscle,
    /// Seventh neck vertebra.
    SeventhNeckVertebra,
    /// Shoulder joint.
    ShoulderJoint,
    /// Fifth lumbar vertebra.
    FifthLumbarVertebra,
    /// Sternum.
    Sternum,
    /// Pectoral muscle.
    PectoralMuscle,
    /// Abdominal muscle.
    AbdominalMuscle,
    /// Pelvic bone.
    PelvicBone,
    /// Deltoid muscle.
    DeltoidMuscle,
    /// Humerus.
    Humerus,
    /// Radial bone.
    RadialBone,
    /// Forearm muscle.
    ForearmMuscle,
    /// The nerve at the elbow.
    ArmNerve,
    /// Pad of the forefinger, dominant hand.
    ForefingerPadDominant,
    /// Pad of the forefinger, other hand.
    ForefingerPadOther,
    /// End joint of the forefinger, dominant hand.
    ForefingerJointDominant,
    /// End joint of the forefinger, other hand.
    ForefingerJointOther,
    /// Thenar eminence.
    ThenarEminence,
    /// Palm of the dominant hand.
    PalmDominant,
    /// Palm of the other hand.
    PalmOther,
    /// Back of the dominant hand.
    BackOfHandDominant,
    /// Back of the other hand.
    BackOfHandOther,
    /// Thigh muscle.
    ThighMuscle,
    /// Kneecap.
    Kneecap,
    /// Middle of the shin.
    MiddleOfShin,
    /// Calf muscle.
    CalfMuscle,
}

use BodyArea as A;
use BodyRegion as R;

impl BodyArea {
    /// Each once, with its region and its quasi-static pressure, N/cm2. The arm nerve is that of the elbow, which counts with the
    /// upper arm here; sources differ on it.
    pub(crate) const ALL: [(Self, BodyRegion, f64); 29] = [
        (A::MiddleOfForehead, R::SkullForehead, 130.0),
        (A::Temple, R::SkullForehead, 110.0),
        (A::MasticatoryMuscle, R::Face, 110.0),
        (A::NeckMuscle, R::Neck, 140.0),
        (A::SeventhNeckVertebra, R::Neck, 210.0),
        (A::ShoulderJoint, R::BackShoulders, 160.0),
        (A::FifthLumbarVertebra, R::BackShoulders, 210.0),
        (A::Sternum, R::Chest, 120.0),
        (A::PectoralMuscle, R::Chest, 170.0),
        (A::AbdominalMuscle, R::Abdomen, 140.0),
        (A::PelvicBone, R::Pelvis, 210.0),
        (A::DeltoidMuscle, R::UpperArm, 190.0),
        (A::Humerus, R::UpperArm, 220.0),
        (A::RadialBone, R::LowerArm, 190.0),
        (A::ForearmMuscle, R::LowerArm, 180.0),
        (A::ArmNerve, R::UpperArm, 180.0),
        (A::ForefingerPadDominant, R::Hand, 300.0),
        (A::ForefingerPadOther, R::Hand, 270.0),
        (A::ForefingerJointDominant, R::Hand, 280.0),
        (A::ForefingerJointOther, R::Hand, 220.0),
        (A::ThenarEminence, R::Hand, 200.0),
        (A::PalmDominant, R::Hand, 260.0),
        (A::PalmOther, R::Hand, 260.0),
        (A::BackOfHandDominant, R::Hand, 200.0),
        (A::BackOfHandOther, R::Hand, 190.0),
        (A::ThighMuscle, R::Thigh, 250.0),
        (A::Kneecap, R::Thigh, 220.0),
        (A::MiddleOfShin, R::LowerLeg, 220.0),
        (A::CalfMuscle, R::LowerLeg, 210.0),
    ];

    /// Pressure that the area bears when it is clamped or pressed for long, N/cm2.
    #[must_use]
    pub const fn quasi_static_n_cm2(self) -> f64 {
        Self::ALL[self as usize].2
    }
}

/// The smallest pressure of the areas of a region when it is clamped or pressed for long, N/cm2. The throat, for which there is
/// none, has that of the neck, for ranking only.
#[must_use]
pub fn quasi_static_pressure_n_cm2(region: BodyRegion) -> f64 {
    let region = if region == R::NeckFront { R::Neck } else { region };
    let of_region = BodyArea::ALL.iter().filter(|(_, of, _)| *of == region).map(|(_, _, pressure)| *pressure);
    of_region.fold(f64::INFINITY, f64::min)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::standards::iso_ts_15066::{pressure_safe_speed_m_s, transient_limit_n};

    #[test]
    fn areas_stand_at_their_numbers_and_every_region_has_one() {
        for (number, (area, _, pressure)) in BodyArea::ALL.into_iter().enumerate() {
            assert_eq!(area as usize, number);
            assert!(area.quasi_static_n_cm2() == pressure && (110.0..=300.0).contains(&pressure));
        }
        for region in BodyRegion::ALL {
            assert!(quasi_static_pressure_n_cm2(region).is_finite(), "{region}");
        }
        // The smallest of the areas of a region in ISO/TS 15066, table A.2: of the hand the back of the other one.
        for (region, smallest) in [(R::Hand, 190.0), (R::Chest, 120.0), (R::Face, 110.0), (R::LowerArm, 180.0)] {
            assert_eq!(quasi_static_pressure_n_cm2(region), smallest, "{region}");
        }
    }

    /// The standard's own speed table (A.5), recalled, follows from the pressure limit on 1 cm2: of seven regions from the
    /// smallest of their areas. (That of the hand was made with 200 N/cm2, not with the 190 of the other hand's back.)
    #[test]
    fn pressures_give_the_recalled_speeds() {
        let rows = [
            (R::LowerArm, 1.4),
            (R::UpperArm, 1.4),
            (R::Abdomen, 1.0),
            (R::Pelvis, 0.93),
            (R::Thigh, 0.67),
            (R::LowerLeg, 0.58),
            (R::Chest, 0.52),
        ];
        for (region, recalled) in rows {
            let pressure_pa = 2.0 * quasi_static_pressure_n_cm2(region) * 1e4;
            let speed = pressure_safe_speed_m_s(region, 10.0, pressure_pa, 1e-4);
            assert!((speed / recalled - 1.0).abs() < 0.055, "{region}: {speed}");
            assert!(transient_limit_n(region) > 0.0);
        }
    }
}
