//! Places where a link may clamp an arm, and how unsafe that is. A frame of the robots keeps those that were worked out of it.

use std::collections::BTreeMap;
use std::sync::{Arc, Mutex, PoisonError};

use crate::hazard::Strike;
use crate::hazard::contact::Clamped;
use crate::standards::BodyRegion;
use crate::standards::iso_13854::least_gap_m;

/// Where a link may clamp an arm.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Pinch {
    /// The link.
    pub link: usize,
    /// Where, how wide and how fast.
    pub clamped: Clamped,
}

/// Where the links of a frame may clamp an arm, by the number of the encounter, whose obstacles decide it, and the link: each once it was
/// asked for.
#[derive(Clone, Debug, Default)]
pub(crate) struct Pinches(Arc<Mutex<ByEncounter>>);

/// By the number of the encounter and the link.
type ByEncounter = BTreeMap<(usize, usize), Arc<[Pinch]>>;

impl Pinches {
    /// Those of a link, worked out where they are not known.
    pub(crate) fn of(&self, encounter: usize, link: usize, work: impl FnOnce() -> Vec<Pinch>) -> Arc<[Pinch]> {
        let known = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = known().get(&(encounter, link)) {
            return Arc::clone(known);
        }
        let worked_out: Arc<[Pinch]> = work().into();
        known().insert((encounter, link), Arc::clone(&worked_out));
        worked_out
    }
}

impl Pinch {
    /// How unsafe a contact of this region is there: nothing where the gap is wide enough for it.
    #[must_use]
    pub(crate) fn ratio(&self, region: BodyRegion, strike: &Strike) -> f64 {
        ratio(&self.clamped, region, strike)
    }
}

/// The same of a clamping of any part of the body.
#[must_use]
pub(crate) fn ratio(clamped: &Clamped, region: BodyRegion, strike: &Strike) -> f64 {
    let is_narrow = clamped.gap_m <= least_gap_m(region) + clamped.travel_m;
    if is_narrow { strike.clamped_ratio(region, clamped.closing_m_s) } else { 0.0 }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Vec3;
    use crate::hazard::contact::Against;

    /// A gap of 90 mm that closes at 0.2 m/s holds a hand, which needs 100 mm, and no part that is content with less; with 50 mm that the
    /// robot goes on one of 140 mm does.
    #[test]
    fn gaps_hold_what_needs_more_room() {
        let strike = Strike::new(
            29.1,
            5.0,
            crate::hazard::criterion::Criteria::default(),
            crate::hazard::criterion::pressure::LinkContact::default(),
        );
        let clamped = |gap_m: f64, travel_m: f64| Clamped {
            at: Vec3::ZERO,
            toward: Vec3::Z,
            against: Against::Floor,
            gap_m,
            travel_m,
            closing_m_s: 0.2,
        };
        // m_R = 19.55 kg; hand 0.2 sqrt(19.55 * 75e3) = 242.2 N of 135 N.
        let ratio = |gap, travel, region| ratio(&clamped(gap, travel), region, &strike);
        assert!((ratio(0.09, 0.0, BodyRegion::Hand) - 242.18 / 135.0).abs() < 1e-3);
        assert!(ratio(0.11, 0.0, BodyRegion::Hand) == 0.0 && ratio(0.11, 0.0, BodyRegion::LowerArm) > 0.0);
        assert!(ratio(0.14, 0.05, BodyRegion::Hand) > 1.0 && ratio(0.14, 0.0, BodyRegion::Hand) == 0.0);
        assert!(ratio(0.49, 0.0, BodyRegion::Chest) > 0.0 && ratio(0.51, 0.0, BodyRegion::Chest) == 0.0);
    }

    /// What is in the way decides where a link clamps: a frame remembers it for each set of obstacles by itself.
    #[test]
    fn places_that_clamp_are_remembered_by_what_is_in_the_way() {
        let clamped = Clamped {
            at: Vec3::ZERO,
            toward: Vec3::Z,
            against: Against::Floor,
            gap_m: 0.1,
            travel_m: 0.0,
            closing_m_s: 0.2,
        };
        let (pinches, pinch) = (Pinches::default(), Pinch { link: 3, clamped });
        assert!(pinches.of(0, 3, Vec::new).is_empty());
        assert_eq!(*pinches.of(1, 3, || vec![pinch]), [pinch]);
        assert!(pinches.of(1, 2, Vec::new).is_empty());
        // None is worked out twice.
        assert!(pinches.of(0, 3, || vec![pinch]).is_empty());
        assert_eq!(*pinches.clone().of(1, 3, Vec::new), [pinch]);
    }
}
