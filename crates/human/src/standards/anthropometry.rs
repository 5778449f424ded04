//! Body measures of the ANSUR II survey (US Army 2012; 4082 men, 1986 women): only those that place the parts of the
//! body model or check it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use thiserror::Error;

use super::provenance::Table;

/// What stands behind the data of this file.
pub(super) const TABLES: [Table; 1] = [Table {
    id: "ansur_ii",
    title: "ANSUR II 2012: body measures of men and women, 5th, 50th and 95th percentile",
    source: "percentiles computed from the public per-subject data",
    confidence: "two public copies of the data agree; soldiers, not a working population",
    verified: false,
}];

/// Sex of the ANSUR II figures.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Sex {
    /// Women.
    Woman,
    /// Men.
    #[default]
    Man,
}

/// Percentile of the population; as a number 5, 50 or 95 in files.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
#[serde(try_from = "u8", into = "u8")]
pub enum Percentile {
    /// Small person: 5 % are smaller.
    P5,
    /// Median.
    P50,
    /// Tall person: 5 % are taller.
    P95,
}

/// A percentile for which no measures are kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Error)]
#[error("no body measures for percentile {0}: use 5, 50 or 95")]
pub struct UnknownPercentile(pub u8);

impl TryFrom<u8> for Percentile {
    type Error = UnknownPercentile;

    fn try_from(percent: u8) -> Result<Self, Self::Error> {
        match percent {
            5 => Ok(Self::P5),
            50 => Ok(Self::P50),
            95 => Ok(Self::P95),
            _ => Err(UnknownPercentile(percent)),
        }
    }
}

impl From<Percentile> for u8 {
    fn from(percentile: Percentile) -> Self {
        match percentile {
            Percentile::P5 => 5,
            Percentile::P50 => 50,
            Percentile::P95 => 95,
        }
    }
}

/// Measures of one sex and percentile, metres; heights above the floor, standing upright. Each is the percentile of its
/// own measure, so they need not belong to one and the same person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Measures {
    /// Top of the head.
    pub stature_m: f64,
    /// Cervicale (seventh neck vertebra).
    pub cervicale_height_m: f64,
    /// Acromion (outer end of the shoulder).
    pub acromial_height_m: f64,
    /// Trochanterion, near the pivot of the hip.
    pub trochanterion_height_m: f64,
    /// Lateral epicondyle of the femur, near the pivot of the knee.
    pub knee_height_m: f64,
    /// Between the two acromia.
    pub biacromial_breadth_m: f64,
    /// Breadth of the chest without the arms.
    pub chest_breadth_m: f64,
    /// Acromion to radiale, radiale to stylion, and hand length, added.
    pub arm_length_m: f64,
}

/// The measures of a sex and percentile.
#[must_use]
pub(crate) const fn measures(sex: Sex, percentile: Percentile) -> Measures {
    // Millimetres as surveyed: stature, cervicale, acromion, trochanterion, knee, biacromial breadth, chest breadth,
    // upper arm, forearm, hand.
    let mm = match (sex, percentile) {
        (Sex::Man, Percentile::P5) => [1648, 1416, 1339, 824, 449, 384, 261, 307, 244, 177],
        (Sex::Man, Percentile::P50) => [1755, 1517, 1439, 899, 491, 415, 289, 335, 267, 193],
        (Sex::Man, Percentile::P95) => [1870, 1623, 1546, 985, 537, 447, 320, 365, 295, 210],
        (Sex::Woman, Percentile::P5) => [1525, 1300, 1242, 774, 422, 335, 241, 283, 218, 165],
        (Sex::Woman, Percentile::P50) => [1626, 1393, 1332, 844, 465, 365, 268, 311, 240, 180],
        (Sex::Woman, Percentile::P95) => [1740, 1498, 1434, 919, 511, 396, 302, 340, 268, 199],
    };
    Measures {
        stature_m: metres(mm[0]),
        cervicale_height_m: metres(mm[1]),
        acromial_height_m: metres(mm[2]),
        trochanterion_height_m: metres(mm[3]),
        knee_height_m: metres(mm[4]),
        biacromial_breadth_m: metres(mm[5]),
        chest_breadth_m: metres(mm[6]),
        arm_length_m: metres(mm[7] + mm[8] + mm[9]),
    }
}

/// Every sex and percentile once.
#[cfg(test)]
pub(crate) const ALL: [(Sex, Percentile); 6] = [
    (Sex::Woman, Percentile::P5),
    (Sex::Woman, Percentile::P50),
    (Sex::Woman, Percentile::P95),
    (Sex::Man, Percentile::P5),
    (Sex::Man, Percentile::P50),
    (Sex::Man, Percentile::P95),
];

const fn metres(mm: u16) -> f64 {
    // `f64::from` is not const.
    mm as f64 / 1000.0
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Ratios to stature published for other populations (Drillis and Contini; Winter) catch slipped columns: acromion
    /// 0.818, knee 0.285, biacromial breadth about 0.259 less the soft shoulder.
    #[test]
    fn proportions_are_those_of_a_human() {
        for (sex, percentile) in ALL {
            let m = measures(sex, percentile);
            let ratio = |measure: f64| measure / m.stature_m;
            assert!((ratio(m.acromial_height_m) - 0.818).abs() < 0.012, "{sex:?} {percentile:?}");
            assert!((ratio(m.knee_height_m) - 0.285).abs() < 0.015, "{sex:?} {percentile:?}");
            assert!((ratio(m.trochanterion_height_m) - 0.53).abs() < 0.035, "{sex:?} {percentile:?}");
            assert!((ratio(m.cervicale_height_m) - (1.0 - 0.182 + 0.04)).abs() < 0.012, "{sex:?} {percentile:?}");
            assert!((ratio(m.biacromial_breadth_m) - 0.23).abs() < 0.012, "{sex:?} {percentile:?}");
            assert!((ratio(m.arm_length_m) - (0.186 + 0.146 + 0.108)).abs() < 0.026, "{sex:?} {percentile:?}");
            assert!(m.chest_breadth_m < m.biacromial_breadth_m, "{sex:?} {percentile:?}");
        }
    }

    #[test]
    fn percentiles_are_numbers_in_files() {
        for percent in 0..=100_u8 {
            let parsed = serde_json::from_str::<Percentile>(&percent.to_string());
            assert_eq!(parsed.is_ok(), [5, 50, 95].contains(&percent), "{percent}");
            if let Ok(percentile) = parsed {
                assert_eq!(serde_json::to_string(&percentile).unwrap(), percent.to_string());
            }
        }
        assert_eq!(serde_json::to_string(&Sex::Woman).unwrap(), "\"woman\"");
    }
}
