//! Least gaps of ISO 13854 that keep parts of the body from being crushed: what is between a moving part and a fixed one that
//! come no nearer to each other than so is not clamped.

use super::BodyRegion;
use super::provenance::Table;

/// What stands behind the data of this file.
pub(super) const TABLES: [Table; 1] = [Table {
    id: "iso_13854_least_gaps",
    title: "ISO 13854:2017, Table 1: least gaps to avoid crushing: body 500 mm, head 300 mm, leg 180 mm, foot 120 mm, toes 50 mm, \
            arm 120 mm, hand, wrist and fist 100 mm, finger 25 mm",
    source: "public secondary sources that quote Table 1 (a lookup made from reproductions of makers, an insurer's lexicon)",
    confidence: "two independent public sources agree; that necks count as heads, and feet as legs, is a choice of this program, \
                 on the safe side for feet",
    verified: false,
}];

/// The least gap at which a part of the body of this region is not crushed, m.
#[must_use]
pub const fn least_gap_m(region: BodyRegion) -> f64 {
    match region {
        BodyRegion::BackShoulders | BodyRegion::Chest | BodyRegion::Abdomen | BodyRegion::Pelvis => 0.5,
        BodyRegion::SkullForehead | BodyRegion::Face | BodyRegion::Neck | BodyRegion::NeckFront => 0.3,
        BodyRegion::Thigh | BodyRegion::LowerLeg => 0.18,
        BodyRegion::UpperArm | BodyRegion::LowerArm => 0.12,
        BodyRegion::Hand => 0.1,
    }
}

/// The longest of them, m.
pub const LONGEST_M: f64 = 0.5;

/// The longest of arms and hands, m.
pub const LONGEST_OF_ARMS_M: f64 = 0.12;

#[cfg(test)]
mod tests {
    use super::*;

    /// The table as it is quoted, mm.
    #[test]
    fn gaps_are_those_of_the_table() {
        let rows = [
            (500.0, &["back_shoulders", "chest", "abdomen", "pelvis"][..]),
            (300.0, &["skull_forehead", "face", "neck", "neck_front"]),
            (180.0, &["thigh", "lower_leg"]),
            (120.0, &["upper_arm", "lower_arm"]),
            (100.0, &["hand"]),
        ];
        let listed = rows.iter().flat_map(|(mm, regions)| regions.iter().map(move |region| (*mm, *region)));
        let mut seen = 0;
        for (mm, region) in listed {
            let region: BodyRegion = region.parse().unwrap();
            assert!((1000.0 * least_gap_m(region) - mm).abs() < 1e-9, "{region}");
            seen += 1;
        }
        assert_eq!(seen, BodyRegion::ALL.len());
        let gaps = || BodyRegion::ALL.into_iter().map(least_gap_m);
        assert!(gaps().fold(0.0, f64::max) == LONGEST_M && gaps().any(|gap| gap == LONGEST_OF_ARMS_M));
    }
}
