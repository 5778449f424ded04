//! What is asked behind the first hazard by contact of a sequence: whether a part of the body is clamped. A hit, or a pressure, does
//! not end what the robot does: it may push the person on to something that does not give way, and that is worse.

use super::super::Coverage;
use super::super::encounter::Person;
use super::{Earlier, Frames, Hit, Instant, Stance, World};

impl World {
    /// Whether a search goes on behind a hazard by contact, and asks for clamping alone then.
    #[must_use]
    pub const fn goes_on(&self) -> bool {
        self.clamping.is_some()
    }

    /// The worst clamping after step `i` of an action, whatever else is touched.
    pub(super) fn clamping_near<E: Earlier>(
        &self,
        person: &Person,
        stance: &Stance,
        (frames, i): (&Frames, usize),
        earlier: &mut E,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        let Some(clamping) = &self.clamping else { return Ok(None) };
        let mut own = Coverage::new(self.cell.sensors.len());
        let hit = clamping.contact_near(person, stance, (frames, i), true, earlier, &mut own)?;
        coverage.merge_arms(&own);
        Ok(hit)
    }

    /// The same of several instants.
    pub(super) fn clampings<E: Earlier>(
        &self,
        stance: &Stance,
        posed: &mut Option<Person>,
        instants: &mut [Instant<'_, E>],
        coverage: &mut Coverage,
    ) -> Result<Vec<Option<Hit>>, E::Error> {
        let Some(clamping) = &self.clamping else { return Ok(vec![None; instants.len()]) };
        let mut own = Coverage::new(self.cell.sensors.len());
        let hits = clamping.ending_contacts(stance, posed, instants, &mut own)?;
        coverage.contact_checks += own.contact_checks;
        coverage.merge_arms(&own);
        Ok(hits)
    }

    /// Puts the worst clamping at the same instant to each of these hits.
    pub(super) fn with_clampings<E: Earlier>(
        &self,
        stance: &Stance,
        posed: &mut Option<Person>,
        instants: &mut [Instant<'_, E>],
        hits: &mut [Option<Hit>],
        coverage: &mut Coverage,
    ) -> Result<(), E::Error> {
        if !self.goes_on() || hits.iter().all(Option::is_none) {
            return Ok(());
        }
        let person = posed.take().unwrap_or_else(|| self.person(stance));
        let person = Person { velocity: self.velocity(stance), ..person };
        for (hit, instant) in hits.iter_mut().zip(instants) {
            let Some(hit) = hit else { continue };
            let Instant { frames, i, earlier } = instant;
            hit.clamps = self.clamping_near(&person, stance, (frames, *i), earlier, coverage)?.map(Box::new);
        }
        *posed = Some(person);
        Ok(())
    }
}
