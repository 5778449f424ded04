//! What follows the FMU's outputs ([`Following`](crate::cell::following::Following)): read after each step, in effect in the next.
//!
//! An obstacle that would come to stand on the person is not in their way until they are clear of it: nobody is locked in by it. So
//! it may be there for one of two people, and not for the other.
//!
//! Where an action leads depends on what the FMU says in it, and that on where it leads. A step of the FMU depends on nothing later, so
//! [`World::walks_amid`] what it last said, again and again, ends after as many rounds as an action has steps, mostly at once.

use super::{Places, Walks, World};
use crate::geometry::Cuboid;
use crate::human::obstacles::capsule_hits;
use crate::human::walk::WalkTrace;
use crate::human::{Action, Arrangement, Place, Posture, Who};
use crate::sim::robot::RobotFrame;

impl World {
    /// Whether anything follows the FMU.
    #[must_use]
    pub fn follows(&self) -> bool {
        !self.cell.following.is_empty()
    }

    /// What a row of outputs says of it.
    #[must_use]
    pub fn arrangement(&self, outputs: &[f64]) -> Arrangement {
        self.cell.following.arrangement(|reading| self.binding.followed[reading].read(outputs))
    }

    /// The same after each step.
    pub(in crate::sim) fn arrangements<'a>(
        &self,
        frames: impl IntoIterator<Item = &'a RobotFrame>,
    ) -> Vec<Arrangement> {
        frames.into_iter().map(|frame| self.arrangement(frame.outputs())).collect()
    }

    /// A place while things stand so, but for what would stand on somebody there.
    fn arranged(&self, place: Place, posture: Posture, arrangement: Arrangement) -> Place {
        if arrangement.is_none() {
            return place.amid(arrangement);
        }
        let posture = if posture.is_low() { posture } else { Posture::Upright };
        let capsule = self.body().blocking_capsule(self.position(&place), posture);
        let following = &self.cell.following;
        let hit = |cuboid: &Cuboid| capsule_hits(&capsule, cuboid);
        let moved = self.cell.obstacles.iter().filter_map(|obstacle| {
            let number = obstacle.follows?;
            let offset = following.offset(number, arrangement)?;
            hit(&Cuboid { centre: obstacle.cuboid.centre + offset, ..obstacle.cuboid }).then_some(number)
        });
        place.amid(moved.fold(arrangement, |arrangement, number| following.without(number, arrangement)))
    }

    /// Where everybody is as an action begins, in the postures of the action before it, after the FMU has said so.
    pub(in crate::sim) fn all_arranged(&self, places: &Places, before: Action, outputs: &[f64]) -> Places {
        if !self.follows() {
            return *places;
        }
        let arrangement = self.arrangement(outputs);
        let second = self.of(Who::Second).zip(places.second);
        Places {
            first: self.arranged(places.first, before.posture(), arrangement),
            second: second.map(|(own, place)| own.arranged(place, before.of(Who::Second).posture(), arrangement)),
        }
    }

    /// Whether everybody walks amid what the FMU said after each step of the action.
    pub(in crate::sim) fn is_amid(&self, walks: &Walks, action: Action, said: &[Arrangement]) -> bool {
        walks.each().all(|(who, walked)| {
            let (own, posture) = (self.of(who).unwrap_or(self), action.of(who).posture());
            let pairs = walked.places.windows(2).zip(said);
            pairs
                .into_iter()
                .all(|(pair, said)| own.arranged(pair[0], posture, *said).arrangement() == pair[1].arrangement())
        })
    }

    /// Where an action leads everybody, in whose steps the FMU says this.
    pub(in crate::sim) fn walks_amid(&self, from: Places, action: Action, said: &[Arrangement]) -> Walks {
        let second = self.of(Who::Second).zip(from.second);
        Walks {
            first: self.walk_amid(from.first, action, said),
            second: second.map(|(own, place)| own.walk_amid(place, action.of(Who::Second), said)),
        }
    }

    fn walk_amid(&self, from: Place, action: Action, said: &[Arrangement]) -> WalkTrace {
        let begun = self.walk(from, action);
        let (mut place, mut stopped) = (begun.start, false);
        // Doors move as the action begins.
        if let Some(first) = begun.places.first() {
            place = place.with_open(first.open());
        }
        let mut trace = WalkTrace { start: begun.start, places: Vec::new(), blocked: Vec::new() };
        for step in 0..begun.places.len() {
            if step > 0 {
                let said = said.get(step - 1).copied().unwrap_or_default();
                place = self.arranged(place, action.posture(), said);
            }
            place = self.walker(&place).step(place, action, &mut stopped);
            trace.places.push(place);
            trace.blocked.push(stopped);
        }
        trace
    }
}
