//! Contacts behind a light curtain: was there time to get there, and where is the robot if the curtain was broken that
//! long before? The geometry is in [`curtain`]; how the robot would then move, [`Earlier`] tells.

use super::super::curtain;
use super::super::encounter::{ArmSpace, Person};
use super::super::robot::RobotFrame;
use super::{Earlier, Frames, Hit, Stance, World};
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::hazard::Contact;
use crate::hazard::finding::ArmPose;
use crate::human::{Place, Side};
use crate::sim::Coverage;

impl World {
    /// An unsafe arm contact after step `i` of an action: without breaking a curtain, or through one, with the robot as
    /// it is when the curtain was broken as long before as the hand needs (see [`curtain`]).
    pub(super) fn reach_through<E: Earlier>(
        &self,
        person: &Person,
        stance: &Stance,
        frames: &Frames,
        i: usize,
        earlier: &mut E,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        let (from, step_s) = (self.position(&self.start()), self.cell.step_s);
        let walls = self.unbroken();
        let shoulder = |side: Side| person.body.shoulder(side).translation;
        // Arms that are not through any plane yet, and do not go through one.
        let outside =
            |side: &Side| self.curtains.iter().all(|(_, plane)| curtain::depth(plane, from, shoulder(*side)) <= 0.0);
        let mut before = person.clone();
        before.arms.retain(outside);
        let around = |link: &Solid| {
            let reach = self.encounter.arm.reach();
            let arms = || before.arms.iter().map(|&side| shoulder(side));
            let passes = |closed: &curtain::Closed| arms().any(|s| !closed.out_of_reach(s, reach, link));
            self.curtains
                .iter()
                .zip(&self.closed)
                .all(|((_, plane), closed)| curtain::within(plane, from, 0.0, link) || passes(closed))
        };
        let links: Vec<bool> = frames[i].links.iter().map(around).collect();
        let space = ArmSpace { walls: &walls, links: Some(&links) };
        let hit = |(contact, arm): (Contact, Option<ArmPose>), frame: &RobotFrame| {
            let phase = frame.phase(contact.link);
            Hit { contact, arm, phase, broke: None, since_s: None }
        };
        if let Some(found) = self.encounter.unsafe_arm_contact(&before, &frames[i], &space, coverage) {
            return Ok(Some(hit(found, &frames[i])));
        }
        for (c, (sensor, plane)) in self.curtains.iter().enumerate() {
            if self.is_inside(plane, stance, c) {
                let found = self.encounter.unsafe_arm_contact(person, &frames[i], &ArmSpace::OPEN, coverage);
                return Ok(found.map(|found| hit(found, &frames[i])));
            }
            let deepest = self.deepest(person, plane);
            if deepest <= 0.0 {
                continue;
            }
            let mut samples = 0;
            let mut now = earlier.broken_for(c, samples)?;
            while let Some(frames) = now {
                let frame = &frames[i];
                // Of instants at which the robot is the same, the last leaves the hand the most time.
                let depth = curtain::depth_m(samples + 1, step_s);
                let later = if depth < deepest { earlier.broken_for(c, samples + 1)? } else { None };
                if later.as_ref().is_none_or(|later| !later[i].same_outputs(frame)) {
                    let mut walls = walls.clone();
                    walls[c] = curtain::beyond(plane, from, depth);
                    // A contact deeper than the tolerance that leaves as much room to what is out of reach in time: the
                    // guarantee of the arm search asks for no more, and thin layers of space cost it most.
                    let far = depth - 2.0 * self.encounter.reach_tolerance_m;
                    let links: Vec<bool> = frame.links.iter().map(|l| curtain::within(plane, from, far, l)).collect();
                    let space = ArmSpace { walls: &walls, links: Some(&links) };
                    if let Some(found) = self.encounter.unsafe_arm_contact(person, frame, &space, coverage) {
                        #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
                        let since_s = Some((samples + 1) as f64 * step_s);
                        return Ok(Some(Hit { broke: Some(*sensor), since_s, ..hit(found, frame) }));
                    }
                }
                samples += 1;
                now = later;
            }
        }
        Ok(None)
    }

    /// How deep behind a plane the person's hands can be, m.
    fn deepest(&self, person: &Person, plane: &Cuboid) -> f64 {
        let from = self.position(&self.start());
        let shoulder = |side: Side| person.body.shoulder(side).translation;
        let depths = person.arms.iter().map(|&side| curtain::depth(plane, from, shoulder(side)));
        depths.fold(f64::MIN, f64::max) + self.encounter.arm.reach()
    }

    /// How many samples before an instant it may matter that a light curtain was broken, for a person at this place.
    #[must_use]
    pub fn samples_that_may_matter(&self, place: &Place) -> usize {
        let (from, at) = (self.position(&self.start()), self.position(place) + Vec3::Z);
        let depth = |(_, plane): &(usize, Cuboid)| curtain::depth(plane, from, at) + self.reach_m();
        let deepest = self.curtains.iter().map(depth).fold(f64::MIN, f64::max);
        (0..).take_while(|&samples| curtain::depth_m(samples, self.cell.step_s) < deepest).count()
    }

    /// Whether a bend could have come as far as `point` behind each light curtain since it broke its plane.
    pub(super) fn in_time(&self, point: Vec3, stance: &Stance) -> bool {
        let from = self.position(&self.start());
        self.curtains.iter().enumerate().all(|(c, (_, plane))| {
            self.is_inside(plane, stance, c)
                || curtain::depth(plane, from, point) <= curtain::depth_m(stance.broken[c] + 1, self.cell.step_s)
        })
    }

    /// Whether the person stands behind a curtain's plane that it has not been seen to break: it came another way.
    fn is_inside(&self, plane: &Cuboid, stance: &Stance, c: usize) -> bool {
        let from = self.position(&self.start());
        stance.broken[c] == 0 && curtain::depth(plane, from, self.position(&stance.place)) > 0.0
    }
}
