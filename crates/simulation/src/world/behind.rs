//! What is asked behind the first hazard by contact of a sequence: whether a part of the body is clamped. A hit, or a pressure, does
//! not end what the robot does: it may push the person on to something that does not give way, and that is worse.

use super::contacts::Posed;
use super::{Hit, Instant, Occupant, PersonState, SignalledRuns, World};
use crate::Coverage;
use crate::encounter::{Encounter, Person};
use crate::human::Place;

impl World {
    /// Whether a search goes on behind a hazard by contact, and asks for clamping alone then.
    #[must_use]
    pub const fn goes_on(&self) -> bool {
        self.first.clamping.is_some()
    }
}

impl Occupant {
    /// The encounter at a place with clamping alone as what is looked for, where it counts.
    fn clamping(&self, place: &Place) -> Option<&Encounter> {
        self.clamping.as_ref().map(|clamping| self.among(clamping, place))
    }

    /// The worst clamping at an instant, whatever else is touched.
    pub(super) fn clamping_near<E: SignalledRuns>(
        &self,
        posed: Posed<'_>,
        instant: &mut Instant<'_, E>,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        let Some(encounter) = self.clamping(&posed.stance.place) else { return Ok(None) };
        let mut own = Coverage::new(self.cell.sensors.len());
        let hit = self.contact_near(Posed { encounter, ..posed }, instant, true, &mut own)?;
        coverage.merge_arms(&own);
        Ok(hit)
    }

    /// The same of several instants.
    pub(super) fn clampings<E: SignalledRuns>(
        &self,
        stance: &PersonState,
        posed: &mut Option<Person>,
        instants: &mut [Instant<'_, E>],
        coverage: &mut Coverage,
    ) -> Result<Vec<Option<Hit>>, E::Error> {
        let Some(clamping) = self.clamping(&stance.place) else { return Ok(vec![None; instants.len()]) };
        let mut own = Coverage::new(self.cell.sensors.len());
        let hits = self.ending_contacts(clamping, stance, posed, instants, &mut own)?;
        coverage.contact_checks += own.contact_checks;
        coverage.merge_arms(&own);
        Ok(hits)
    }

    /// Puts the worst clamping at the same instant to each of these hits.
    pub(super) fn with_clampings<E: SignalledRuns>(
        &self,
        stance: &PersonState,
        posed: &mut Option<Person>,
        instants: &mut [Instant<'_, E>],
        hits: &mut [Option<Hit>],
        coverage: &mut Coverage,
    ) -> Result<(), E::Error> {
        if self.clamping.is_none() || hits.iter().all(Option::is_none) {
            return Ok(());
        }
        let posed = Posed { encounter: self.encounter(&stance.place), person: self.posed(stance, posed), stance };
        for (hit, instant) in hits.iter_mut().zip(instants) {
            let Some(hit) = hit else { continue };
            hit.clamps = self.clamping_near(posed, instant, coverage)?.map(Box::new);
        }
        Ok(())
    }
}
