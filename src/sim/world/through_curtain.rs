//! Contacts behind a light curtain: was there time to get there, and where is the robot if the curtain was broken that
//! long before? The geometry is in [`curtain`]; how the robot would then move, [`Earlier`] tells.

use super::super::curtain;
use super::super::encounter::{ArmSpace, Encountered, Person};
use super::super::robot::RobotFrame;
use super::{Earlier, Frames, Hit, Stance, World};
use crate::geometry::{Cuboid, Solid, Vec3};
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
        if let Some(found) = self.encounter.unsafe_arm_contact(&before, &frames[i], &space, coverage) {
            return Ok(Some(Hit::new(found, &frames[i])));
        }
        for (c, (sensor, plane)) in self.curtains.iter().enumerate() {
            if self.is_inside(plane, stance, c) {
                let found = self.encounter.unsafe_arm_contact(person, &frames[i], &ArmSpace::OPEN, coverage);
                return Ok(found.map(|found| Hit::new(found, &frames[i])));
            }
            let deepest = self.deepest(person, plane);
            if deepest <= 0.0 {
                continue;
            }
            let mut before: Vec<(usize, Frames)> = Vec::new();
            for samples in 0.. {
                if samples > 0 && curtain::depth_m(samples, step_s) >= deepest {
                    break;
                }
                let Some(frames) = earlier.broken_for(c, samples)? else { break };
                // Of instants at which the robot is the same, the last leaves the hand the most time.
                if before.last().is_some_and(|(_, last)| last[i].same_outputs(&frames[i])) {
                    before.pop();
                }
                before.push((samples, frames));
            }
            if let Some((samples, frames, found)) = self.first_through(person, c, i, &before, coverage) {
                #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
                let since_s = Some((samples + 1) as f64 * step_s);
                return Ok(Some(Hit { broke: Some(*sensor), since_s, ..Hit::new(found, &frames[i]) }));
            }
        }
        Ok(None)
    }

    /// The first of the robots `before` that an arm can get hold of through curtain `c` in time, and the contact.
    fn first_through<'a>(
        &self,
        person: &Person,
        c: usize,
        i: usize,
        before: &'a [(usize, Frames)],
        coverage: &mut Coverage,
    ) -> Option<(usize, &'a Frames, Encountered)> {
        let (plane, from) = (&self.curtains[c].1, self.position(&self.start()));
        let depth = |samples: usize| curtain::depth_m(samples + 1, self.cell.step_s);
        let mut walls = self.unbroken();
        // A contact deeper than the tolerance that leaves as much room to what is out of reach in time: the guarantee of
        // the arm search asks for no more, and thin layers of space cost it most.
        let within = |(samples, frames): &(usize, Frames)| -> Vec<bool> {
            let far = depth(*samples) - 2.0 * self.encounter.reach_tolerance_m;
            frames[i].links.iter().map(|l| curtain::within(plane, from, far, l)).collect()
        };
        let mut groups = vec![before];
        while let Some(group) = groups.pop() {
            match group {
                [] => {}
                [one @ (samples, frames)] => {
                    walls[c] = curtain::beyond(plane, from, depth(*samples));
                    let links = within(one);
                    let space = ArmSpace { walls: &walls, links: Some(&links) };
                    let found = self.encounter.unsafe_arm_contact(person, &frames[i], &space, coverage);
                    if let Some(found) = found {
                        return Some((*samples, frames, found));
                    }
                }
                [.., (last, _)] => {
                    // The space open to the last of them holds that of all: nothing there is nothing for any.
                    walls[c] = curtain::beyond(plane, from, depth(*last));
                    let links: Vec<bool> = group.iter().flat_map(within).collect();
                    let space = ArmSpace { walls: &walls, links: Some(&links) };
                    let frames: Vec<&RobotFrame> = group.iter().map(|(_, frames)| &frames[i]).collect();
                    if !self.encounter.no_arm_harmed(person, &frames, &space, coverage) {
                        let (first, second) = group.split_at(group.len() / 2);
                        groups.extend([second, first]);
                    }
                }
            }
        }
        None
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
