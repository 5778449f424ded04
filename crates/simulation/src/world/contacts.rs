//! Whether somebody can touch the robots as they stand at an instant, and what is recorded of it.

use super::instant::{Hit, Instant, PersonState, Window};
use super::through_plane::PassRuns;
use super::{Occupant, SignalledRuns};
use crate::Coverage;
use crate::encounter::{ArmSpace, Encounter, Person};
use crate::hazard::finding::Through;
use crate::hazard::{Contact, Finding};
use crate::robot::RobotFrame;

/// Somebody in a stance, and what is looked for.
#[derive(Clone, Copy)]
pub(super) struct Posed<'a> {
    /// What is in the way there, and what is looked for.
    pub(super) encounter: &'a Encounter,
    /// Body and arms.
    pub(super) person: &'a Person,
    /// How they stand.
    pub(super) stance: &'a PersonState,
}

impl Occupant {
    /// The unsafe contact with the robots at an instant, if there is one; of somebody who met a hazard by contact before, the clamping.
    ///
    /// # Errors
    /// What [`Instant::earlier`] reports; it is asked only where there are light curtains.
    pub fn contact<E: SignalledRuns>(
        &self,
        stance: &PersonState,
        instant: &mut Instant<'_, E>,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        coverage.contact_checks += 1;
        let near = self.near(&stance.place, instant.frame());
        if !near && (self.cell.separation.is_none() || stance.struck) {
            return Ok(None);
        }
        let person = &self.person(stance);
        let posed = Posed { encounter: self.encounter(&stance.place), person, stance };
        if stance.struck {
            return self.clamping_near(posed, instant, coverage);
        }
        if near && let Some(hit) = self.contact_near(posed, instant, true, coverage)? {
            let clamps = self.clamping_near(posed, instant, coverage)?;
            return Ok(Some(Hit { clamps: clamps.map(Box::new), ..hit }));
        }
        self.passing(posed, instant, coverage)
    }

    /// The same for one stance and several instants, each with its own robots. One search often settles many of them.
    /// `posed` keeps the person for the next stance of the same place and posture.
    ///
    /// # Errors
    /// What [`Instant::earlier`] reports; it is asked only where there are light curtains.
    pub fn contacts<E: SignalledRuns>(
        &self,
        stance: &PersonState,
        posed: &mut Option<Person>,
        instants: &mut [Instant<'_, E>],
        coverage: &mut Coverage,
    ) -> Result<Vec<Option<Hit>>, E::Error> {
        if stance.struck {
            return self.clampings(stance, posed, instants, coverage);
        }
        let encounter = self.encounter(&stance.place);
        let mut hits = self.ending_contacts(encounter, stance, posed, instants, coverage)?;
        self.with_clampings(stance, posed, instants, &mut hits, coverage)?;
        if self.moving.is_none() && self.cell.separation.is_none() {
            return Ok(hits);
        }
        let posed = Posed { encounter, person: self.posed(stance, posed), stance };
        for (hit, instant) in hits.iter_mut().zip(instants).filter(|(hit, _)| hit.is_none()) {
            *hit = self.passing(posed, instant, coverage)?;
        }
        Ok(hits)
    }

    /// Body and arms in a stance, of which `posed` has those of the same place and posture if they are known; it keeps them.
    pub(super) fn posed<'a>(&self, stance: &PersonState, posed: &'a mut Option<Person>) -> &'a Person {
        let person = posed.take().unwrap_or_else(|| self.person(stance));
        posed.insert(Person { velocity: self.velocity(stance), ..person })
    }

    /// Those that end an action, by what is looked for.
    pub(super) fn ending_contacts<E: SignalledRuns>(
        &self,
        encounter: &Encounter,
        stance: &PersonState,
        posed: &mut Option<Person>,
        instants: &mut [Instant<'_, E>],
        coverage: &mut Coverage,
    ) -> Result<Vec<Option<Hit>>, E::Error> {
        let mut hits = vec![None; instants.len()];
        let near = |n: &usize| self.near(&stance.place, instants[*n].frame());
        let near: Vec<usize> = (0..instants.len()).filter(near).collect();
        coverage.contact_checks += instants.len() as u64;
        if near.is_empty() {
            return Ok(hits);
        }
        let posed = Posed { encounter, person: self.posed(stance, posed), stance };
        if !self.curtains.is_empty() {
            self.contacts_at_planes(posed, instants, &mut hits, coverage)?;
            return Ok(hits);
        }
        let mut groups: Vec<&[usize]> = vec![&near];
        while let Some(group) = groups.pop() {
            let frames: Vec<&RobotFrame> = group.iter().map(|&n| instants[n].frame()).collect();
            let harmless = group.len() > 1 && encounter.no_arm_harmed(posed.person, &frames, &ArmSpace::OPEN, coverage);
            if group.len() > 1 && !harmless {
                let (first, second) = group.split_at(group.len() / 2);
                groups.extend([second, first]);
                continue;
            }
            for &n in group {
                hits[n] = self.contact_near(posed, &mut instants[n], !harmless, coverage)?;
            }
        }
        Ok(hits)
    }

    /// The same at planes: what arms can do there follows from the stance, so one search asks for the robots of many
    /// instants, each with those that there would be had a plane told of an arm.
    fn contacts_at_planes<E: SignalledRuns>(
        &self,
        posed: Posed<'_>,
        instants: &mut [Instant<'_, E>],
        hits: &mut [Option<Hit>],
        coverage: &mut Coverage,
    ) -> Result<(), E::Error> {
        let at = self.at_planes(posed);
        let mut open: Vec<(usize, PassRuns)> = Vec::new();
        for (n, instant) in instants.iter_mut().enumerate() {
            hits[n] = self.body_hit(posed, instant.frame(), coverage);
            if hits[n].is_none() {
                open.push((n, PassRuns::all(&at, instant)?));
            }
        }
        let mut groups: Vec<&mut [(usize, PassRuns)]> = vec![&mut open];
        while let Some(group) = groups.pop() {
            match group {
                [] => {}
                [(n, runs)] => hits[*n] = self.reach_past_planes(&at, runs, &mut instants[*n], coverage)?,
                _ => {
                    let runs: Vec<&PassRuns> = group.iter().map(|(_, runs)| runs).collect();
                    if !self.none_reaches_past_planes(&at, &runs, coverage) {
                        let (first, second) = group.split_at_mut(group.len() / 2);
                        groups.extend([second, first]);
                    }
                }
            }
        }
        Ok(())
    }

    /// The unsafe contact of trunk, head or legs, if there is one.
    fn body_hit(&self, posed: Posed<'_>, frame: &RobotFrame, coverage: &mut Coverage) -> Option<Hit> {
        let Posed { encounter, person, stance } = posed;
        let counts = |contact: &Contact| self.in_time(contact.on_robot, person, stance);
        let contact = encounter.unsafe_body_contact(person, frame, counts, coverage)?;
        Some(Hit::new((contact, None), frame))
    }

    /// The unsafe contact at an instant, whether or not a robot is near: of the body, and, where they are asked for, of the arms.
    pub(super) fn contact_near<E: SignalledRuns>(
        &self,
        posed: Posed<'_>,
        instant: &mut Instant<'_, E>,
        arms: bool,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        let frame = instant.frame();
        let hit = self.body_hit(posed, frame, coverage);
        if hit.is_some() || !arms {
            return Ok(hit);
        }
        if self.curtains.is_empty() {
            let found = posed.encounter.unsafe_arm_contact(posed.person, frame, &ArmSpace::OPEN, coverage);
            return Ok(found.map(|found| Hit::new(found, frame)));
        }
        let at = self.at_planes(posed);
        self.reach_past_planes(&at, &mut PassRuns::new(&at), instant, coverage)
    }

    /// What is recorded of a hit after step `i` of the last of `taken` actions, while sensors report so ([`World::readings`]).
    ///
    /// [`World::readings`]: super::World::readings
    #[must_use]
    pub fn finding(
        &self,
        hit: &Hit,
        stance: &PersonState,
        mut sensors: Vec<bool>,
        (taken, i): (usize, usize),
    ) -> Option<Finding> {
        for window in &hit.windows {
            // What the last sample but `delay` told takes effect in this step.
            let sensor = self.curtains[window.curtain].sensor;
            let (delay, latched) = (self.cell.sensors[sensor].delay_steps, self.cell.sensors[sensor].latched);
            sensors[sensor] |= window.from > delay && (window.until <= delay || latched);
        }
        #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
        let seconds = |samples: usize| samples as f64 * self.cell.step_s;
        let through = |window: &Window| Through {
            sensor: self.curtains[window.curtain].sensor,
            // The first sample that told of it was taken up to a step after it was broken.
            since_s: seconds(window.from + 1),
            until_s: seconds(window.until),
        };
        let step = (taken - 1) * self.cell.steps_per_action + i + 1;
        #[expect(clippy::cast_precision_loss, reason = "at most 64 000 steps")]
        let time_s = step as f64 * self.cell.step_s;
        Some(Finding {
            class: hit.contact.class()?,
            contact: hit.contact,
            actions: Vec::new(),
            step,
            time_s,
            who: stance.who,
            person: self.position(&stance.place),
            heading_rad: stance.place.heading_rad(&self.cell.start),
            bend_sixteenths: self.bend(&stance.place, stance.posture).sixteenths(),
            arm: hit.arm,
            sensors,
            phase: hit.phase,
            through: hit.windows.iter().map(through).collect(),
        })
    }
}
