//! What follows the FMU's outputs ([`Following`](crate::cell::following::Following)): read after each step, in effect in the next.
//!
//! An obstacle that has come to stand on somebody lets them walk out of it, and no deeper in ([`Walker`](crate::human::walk::Walker));
//! their arms and bends pass it meanwhile.
//!
//! Where an action leads depends on what the FMU says in it, and that on where it leads. A step of the FMU depends on nothing later, so
//! [`World::walks_amid`] what it last said, again and again, ends after as many rounds as an action has steps, mostly at once.

use super::{Occupant, Places, Walks, World};
use crate::human::walk::WalkTrace;
use crate::human::{Action, Arrangement, Place, Posture, Who, capsule_hits};

impl Walks {
    /// Whether everybody walks amid what the FMU said after each step of the action.
    pub(crate) fn are_amid(&self, said: &[Arrangement]) -> bool {
        self.each().all(|(_, walked)| {
            let during = walked.places.iter().skip(1).map(Place::arrangement);
            during.zip(said).all(|(during, said)| during == *said)
        })
    }
}

impl World {
    /// Whether anything follows the FMU.
    #[must_use]
    pub fn follows(&self) -> bool {
        !self.cell.following.is_empty()
    }

    /// What a row of outputs says of it.
    #[must_use]
    pub(crate) fn arrangement(&self, outputs: &[f64]) -> Arrangement {
        self.cell.following.arrangement(|reading| self.binding.followed[reading].read(outputs))
    }

    /// The sensors that see somebody at their start and do not always count: whether they do then, the FMU would have to say before it
    /// begins.
    #[must_use]
    pub fn seen_at_start_at_times(&self) -> Vec<&str> {
        let following = &self.cell.following;
        let seen = self.seen_at_start().into_iter().zip(&self.cell.sensors).enumerate();
        seen.filter(|(n, (seen, _))| *seen && following.has_sensor(*n)).map(|(_, (_, s))| s.name.as_str()).collect()
    }

    /// Where an action leads everybody, in whose steps the FMU says this.
    pub(crate) fn walks_amid(&self, from: Places, action: Action, said: &[Arrangement]) -> Walks {
        let second = self.second.as_ref().zip(from.second);
        Walks {
            first: self.first.walk_amid(from.first, action, said),
            second: second.map(|(own, place)| own.walk_amid(place, action.of(Who::Second), said)),
        }
    }
}

impl Occupant {
    /// How things stand that follow the FMU at a place, but for what stands on the person there: arms and bends pass that, as somebody whom
    /// it pushes along has them free.
    pub(super) fn beside(&self, place: &Place) -> Arrangement {
        if self.moving_obstacles.is_empty() || place.arrangement().is_none() {
            return place.arrangement();
        }
        self.beside.of(*place, || {
            let capsule = self.body().blocking_capsule(self.position(place), Posture::Upright);
            let on_the_person = self.cell.obstacles.iter().filter_map(|obstacle| {
                let (number, cuboid) = (obstacle.follows?, self.cell.amid(obstacle, place.arrangement())?);
                capsule_hits(&capsule, &cuboid).then_some(number)
            });
            let following = &self.cell.following;
            on_the_person.fold(place.arrangement(), |arrangement, number| following.without(number, arrangement))
        })
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
                place = place.amid(said.get(step - 1).copied().unwrap_or_default());
            }
            place = self.walker(&place).step(place, action, &mut stopped);
            trace.places.push(place);
            trace.blocked.push(stopped);
        }
        trace
    }
}
