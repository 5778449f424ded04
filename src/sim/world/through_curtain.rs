//! Contacts behind a light curtain: was there time to get there, and where is the robot if the curtain was broken that
//! long before? The geometry is in [`curtain`](super::super::curtain); how the robot would then move, [`Earlier`] tells.

use super::super::curtain::{Curtain, depth_m};
use super::super::encounter::{ArmSpace, Encountered, Person};
use super::super::robot::RobotFrame;
use super::super::sensors::DelayLine;
use super::{Earlier, Frames, Hit, Stance, World};
use crate::geometry::{Cuboid, Rotation, Solid, Vec3};
use crate::human::{Place, Side};
use crate::sim::Coverage;

impl World {
    /// An unsafe arm contact after step `i` of an action: without breaking a curtain, or through one, with the robot as
    /// it is when the curtain was broken as long before as the hand needs (see [`curtain`](super::super::curtain)).
    pub(super) fn reach_through<E: Earlier>(
        &self,
        person: &Person,
        stance: &Stance,
        frames: &Frames,
        i: usize,
        earlier: &mut E,
        coverage: &mut Coverage,
    ) -> Result<Option<Hit>, E::Error> {
        let step_s = self.cell.step_s;
        let walls = self.walls(person, stance);
        let shoulder = |side: Side| person.body.shoulder(side).translation;
        // Arms that are not through any plane yet, and do not go through one.
        let outside = |side: &Side| self.keeping_back(person, stance).all(|(_, c)| c.depth(shoulder(*side)) <= 0.0);
        let mut before = person.clone();
        before.arms.retain(outside);
        let around = |link: &Solid| {
            let reach = self.encounter.arm.reach();
            let arms = || before.arms.iter().map(|&side| shoulder(side));
            let passes = |c: &Curtain| arms().any(|s| !c.closed.out_of_reach(s, reach, link));
            self.keeping_back(person, stance).all(|(_, c)| c.within(0.0, link) || passes(c))
        };
        let links: Vec<bool> = frames[i].links.iter().map(around).collect();
        let space = ArmSpace { walls: &walls, links: Some(&links) };
        if let Some(found) = self.encounter.unsafe_arm_contact(&before, &frames[i], &space, coverage) {
            return Ok(Some(Hit::new(found, &frames[i])));
        }
        for (c, curtain) in self.keeping_back(person, stance) {
            let deepest = self.deepest(person, curtain);
            if deepest <= 0.0 {
                continue;
            }
            let mut before: Vec<(usize, Frames)> = Vec::new();
            for samples in 0.. {
                if samples > 0 && depth_m(samples, step_s) >= deepest {
                    break;
                }
                let Some(frames) = earlier.broken_for(c, samples)? else { break };
                // Of instants at which the robot is the same, the last leaves the hand the most time.
                if before.last().is_some_and(|(_, last)| last[i].same_outputs(&frames[i])) {
                    before.pop();
                }
                before.push((samples, frames));
            }
            let through = self.first_through((person, stance), (c, i), &before, coverage);
            if let Some((samples, frames, found)) = through {
                #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
                let since_s = Some((samples + 1) as f64 * step_s);
                return Ok(Some(Hit { broke: Some(curtain.sensor), since_s, ..Hit::new(found, &frames[i]) }));
            }
        }
        Ok(None)
    }

    /// The curtains that keep the person's arms back, with their places in the list of all.
    fn keeping_back(&self, person: &Person, stance: &Stance) -> impl Iterator<Item = (usize, &Curtain)> {
        let free = |c: usize, curtain: &Curtain| {
            let since = stance.broken[c];
            let far = || since == LONG_AGO || depth_m(since + 1, self.cell.step_s) >= self.deepest(person, curtain);
            self.is_inside(curtain, stance, c) || (curtain.hands_only && since > 0 && far())
        };
        self.curtains.iter().enumerate().filter(move |(c, curtain)| !free(*c, curtain))
    }

    /// The same as walls; one that keeps no arm back is out of the way.
    fn walls(&self, person: &Person, stance: &Stance) -> Vec<Cuboid> {
        let mut walls = vec![NOWHERE; self.curtains.len()];
        self.keeping_back(person, stance).for_each(|(c, curtain)| walls[c] = curtain.unbroken());
        walls
    }

    /// The first of the robots `before` that an arm can get hold of through curtain `c` in time, and the contact.
    fn first_through<'a>(
        &self,
        (person, stance): (&Person, &Stance),
        (c, i): (usize, usize),
        before: &'a [(usize, Frames)],
        coverage: &mut Coverage,
    ) -> Option<(usize, &'a Frames, Encountered)> {
        let curtain = &self.curtains[c];
        let depth = |samples: usize| depth_m(samples + 1, self.cell.step_s);
        let mut walls = self.walls(person, stance);
        // A contact deeper than the tolerance that leaves as much room to what is out of reach in time: the guarantee of
        // the arm search asks for no more, and thin layers of space cost it most.
        let within = |(samples, frames): &(usize, Frames)| -> Vec<bool> {
            let far = depth(*samples) - 2.0 * self.encounter.reach_tolerance_m;
            frames[i].links.iter().map(|l| curtain.within(far, l)).collect()
        };
        let mut groups = vec![before];
        while let Some(group) = groups.pop() {
            match group {
                [] => {}
                [one @ (samples, frames)] => {
                    walls[c] = curtain.beyond(depth(*samples));
                    let links = within(one);
                    let space = ArmSpace { walls: &walls, links: Some(&links) };
                    let found = self.encounter.unsafe_arm_contact(person, &frames[i], &space, coverage);
                    if let Some(found) = found {
                        return Some((*samples, frames, found));
                    }
                }
                [.., (last, _)] => {
                    // The space open to the last of them holds that of all: nothing there is nothing for any.
                    walls[c] = curtain.beyond(depth(*last));
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
    fn deepest(&self, person: &Person, curtain: &Curtain) -> f64 {
        let depths = person.arms.iter().map(|&side| curtain.depth(person.body.shoulder(side).translation));
        depths.fold(f64::MIN, f64::max) + self.encounter.arm.reach()
    }

    /// How many samples before an instant it may matter that a light curtain was broken, for a person at this place.
    #[must_use]
    pub fn samples_that_may_matter(&self, place: &Place) -> usize {
        let at = self.position(place) + Vec3::Z;
        let depths = self.curtains.iter().map(|curtain| curtain.depth(at) + self.reach_m());
        let deepest = depths.fold(f64::MIN, f64::max);
        (0..).take_while(|&samples| depth_m(samples, self.cell.step_s) < deepest).count()
    }

    /// Whether a bend could have come as far as `point` behind each light curtain since it broke its plane. Who holds a
    /// two-hand control may lean over it.
    pub(super) fn in_time(&self, point: Vec3, stance: &Stance) -> bool {
        self.curtains.iter().enumerate().filter(|(_, curtain)| !curtain.hands_only).all(|(c, curtain)| {
            self.is_inside(curtain, stance, c)
                || stance.broken[c] == LONG_AGO
                || curtain.depth(point) <= depth_m(stance.broken[c] + 1, self.cell.step_s)
        })
    }

    /// Whether the person stands behind a curtain's plane that it has not been seen to break: it came another way.
    fn is_inside(&self, curtain: &Curtain, stance: &Stance, c: usize) -> bool {
        stance.broken[c] == 0 && curtain.depth(self.position(&stance.place)) > 0.0
    }
}

/// Samples since a plane was broken, or a control let go, that are not counted any more: anything is possible since.
const LONG_AGO: usize = DelayLine::LONGEST as usize;

/// A wall that is nowhere near a person.
const NOWHERE: Cuboid = Cuboid { centre: Vec3::new(0.0, 0.0, -100.0), half: Vec3::ZERO, rotation: Rotation::IDENTITY };
