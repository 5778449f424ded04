//! Everybody in the cell at once: where they are, where an action leads them, and what the sensors see of any of them.
//!
//! A second person is a [`World`] of their own beside the first one's: the same obstacles, sensors and controls, another body and
//! start. They do not stand in each other's way. A sensor that sees either reports somebody, and a control is worked if the hands of
//! either get to it.

use super::{Sight, Stance, World};
use crate::human::walk::WalkTrace;
use crate::human::{Action, Arrangement, Place, Posture, Who};

/// Where everybody is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct Places {
    /// The first person.
    pub first: Place,
    /// The second one, counted from a start of their own, if there is one.
    pub second: Option<Place>,
}

impl Places {
    /// The same while things stand so that follow the FMU.
    #[must_use]
    pub(crate) fn amid(&self, arrangement: Arrangement) -> Self {
        Self { first: self.first.amid(arrangement), second: self.second.map(|place| place.amid(arrangement)) }
    }

    /// Where one of them is.
    #[must_use]
    pub const fn of(&self, who: Who) -> Option<&Place> {
        match who {
            Who::First => Some(&self.first),
            Who::Second => self.second.as_ref(),
        }
    }
}

/// Where an action leads everybody.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Walks {
    /// The first person.
    pub first: WalkTrace,
    /// The second one, if there is one.
    pub second: Option<WalkTrace>,
}

impl Walks {
    /// Where it leads one of them.
    #[must_use]
    pub const fn of(&self, who: Who) -> Option<&WalkTrace> {
        match who {
            Who::First => Some(&self.first),
            Who::Second => self.second.as_ref(),
        }
    }

    /// Each with who goes there.
    pub fn each(&self) -> impl Iterator<Item = (Who, &WalkTrace)> {
        Who::ALL.into_iter().filter_map(|who| Some((who, self.of(who)?)))
    }

    /// Where everybody is at the start, turns already made.
    #[must_use]
    pub fn starts(&self) -> Places {
        Places { first: self.first.start, second: self.second.as_ref().map(|walked| walked.start) }
    }

    /// Where everybody is at the end.
    #[must_use]
    pub fn ends(&self) -> Places {
        Places { first: self.first.end(), second: self.second.as_ref().map(WalkTrace::end) }
    }

    /// Whether an obstacle stops anybody.
    #[must_use]
    pub(crate) fn blocked(&self) -> bool {
        self.each().any(|(_, walked)| walked.blocked.contains(&true))
    }
}

impl World {
    /// The world of one of the people, if they are there.
    #[must_use]
    pub fn of(&self, who: Who) -> Option<&Self> {
        match who {
            Who::First => Some(self),
            Who::Second => self.second.as_deref(),
        }
    }

    /// The world of who has this stance.
    pub fn of_stance(&self, stance: &Stance) -> &Self {
        self.of(stance.who).unwrap_or(self)
    }

    /// Everybody who is there, each with their world.
    pub fn people(&self) -> impl Iterator<Item = (Who, &Self)> {
        Who::ALL.into_iter().filter_map(|who| Some((who, self.of(who)?)))
    }

    /// Where everybody begins.
    #[must_use]
    pub fn starts(&self) -> Places {
        Places { first: self.start(), second: self.second.as_ref().map(|second| second.start()) }
    }

    /// The action as everybody takes it, see [`World::taken`].
    #[must_use]
    pub fn taken_by_all(&self, from: &Places, action: Action) -> Action {
        match (&self.second, &from.second) {
            (Some(second), Some(place)) => {
                let own = self.taken(&from.first, action.of(Who::First));
                own.beside(second.taken(place, action.of(Who::Second)))
            }
            _ => self.taken(&from.first, action),
        }
    }

    /// Where an action leads everybody.
    #[must_use]
    pub fn walks(&self, from: Places, action: Action) -> Walks {
        let second = self.second.as_ref().zip(from.second);
        Walks {
            first: self.walk(from.first, action),
            second: second.map(|(second, place)| second.walk(place, action.of(Who::Second))),
        }
    }

    /// What there is for the sensors to see of anybody at the start of each step.
    #[must_use]
    pub(crate) fn sights_of_all(&self, walks: &Walks, action: Action) -> Vec<Sight> {
        let own = self.sights(&walks.first, action.posture());
        match (&self.second, &walks.second) {
            (Some(second), Some(walked)) => {
                Sight::of_either(&own, &second.sights(walked, action.of(Who::Second).posture()))
            }
            _ => own,
        }
    }

    /// What each sensor sees at the start.
    #[must_use]
    pub fn seen_at_start(&self) -> Vec<bool> {
        let of = |world: &Self| world.seen_by_each(&world.start(), Posture::Upright);
        let own = of(self);
        match &self.second {
            Some(second) => own.iter().zip(of(second)).map(|(own, other)| *own || other).collect(),
            None => own,
        }
    }
}
