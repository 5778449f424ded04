//! Everybody in the cell at once: where they are, where an action leads them, and what the sensors see of any of them.
//!
//! The second person is an [`Occupant`] like the first: with the same obstacles, sensors and controls, but another body and start. They do not stand in each other's way. A sensor that sees either reports somebody, and a control is worked if the hands of
//! either get to it.

use super::{Occupant, OperatedControls, PersonState, RawReadings, World};
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
    /// One of the people, if they are there.
    #[must_use]
    pub const fn of(&self, who: Who) -> Option<&Occupant> {
        match who {
            Who::First => Some(&self.first),
            Who::Second => self.second.as_ref(),
        }
    }

    /// Who has this stance.
    #[must_use]
    pub fn of_person_state(&self, stance: &PersonState) -> &Occupant {
        self.of(stance.who).unwrap_or(&self.first)
    }

    /// Everybody who is there.
    pub fn people(&self) -> impl Iterator<Item = &Occupant> {
        std::iter::once(&self.first).chain(&self.second)
    }

    /// The second one with something of theirs, if there is one.
    fn second_with<'a, T>(&'a self, of: Option<&'a T>) -> Option<(&'a Occupant, &'a T)> {
        self.second.as_ref().zip(of)
    }

    /// Where everybody begins.
    #[must_use]
    pub fn starts(&self) -> Places {
        Places { first: self.first.start(), second: self.second.as_ref().map(Occupant::start) }
    }

    /// The action as everybody takes it, see [`Occupant::taken`].
    #[must_use]
    pub fn taken_by_all(&self, from: &Places, action: Action) -> Action {
        match self.second_with(from.second.as_ref()) {
            Some((second, place)) => {
                let own = self.first.taken(&from.first, action.of(Who::First));
                own.beside(second.taken(place, action.of(Who::Second)))
            }
            None => self.first.taken(&from.first, action),
        }
    }

    /// Actions from the start as people take them.
    #[must_use]
    pub fn as_taken(&self, actions: &[Action]) -> Vec<Action> {
        let mut places = self.starts();
        let mut take = |action: &Action| {
            let taken = self.taken_by_all(&places, *action);
            places = self.walks(places, taken).ends();
            taken
        };
        let nobody_is_low = self.people().all(|own| own.cell.repertoire.low().is_empty());
        // Nobody is low where obstacles follow the FMU, which is not asked here.
        if nobody_is_low { actions.to_vec() } else { actions.iter().map(&mut take).collect() }
    }

    /// Where an action leads everybody.
    #[must_use]
    pub fn walks(&self, from: Places, action: Action) -> Walks {
        let second = self.second_with(from.second.as_ref());
        Walks {
            first: self.first.walk(from.first, action),
            second: second.map(|(second, place)| second.walk(*place, action.of(Who::Second))),
        }
    }

    /// Controls that are really worked in an action from where everybody stands, turns already made and doors still as they were.
    #[must_use]
    pub fn worked_by(&self, starts: &Places, action: Action) -> OperatedControls {
        self.first.worked_with(&starts.first, self.second_with(starts.second.as_ref()), action)
    }

    /// What there is for the sensors to see of anybody at the start of each step.
    #[must_use]
    pub(crate) fn raw_readings_of_all(&self, walks: &Walks, action: Action) -> Vec<RawReadings> {
        let own = self.first.sights(&walks.first, action.posture());
        match self.second_with(walks.second.as_ref()) {
            Some((second, walked)) => {
                RawReadings::of_either(&own, &second.sights(walked, action.of(Who::Second).posture()))
            }
            None => own,
        }
    }

    /// What each sensor sees at the start.
    #[must_use]
    pub fn seen_at_start(&self) -> Vec<bool> {
        let of = |own: &Occupant| own.seen_by_each(&own.start(), Posture::Upright);
        let own = of(&self.first);
        match &self.second {
            Some(second) => own.iter().zip(of(second)).map(|(own, other)| *own || other).collect(),
            None => own,
        }
    }
}
