//! What becomes of the actions of two people: each of them is asked about alone, once for all actions that bring them the same, and an
//! action is over for both when one of them is hit.

use super::{Pending, State, note_clamping};
use crate::hazard::Finding;
use crate::human::{Action, Posture};
use crate::search::exhaustive::{Expanded, Noted, Of, PriorState};
use crate::sim::action_hazards::{ActionHazards, PersonCourse};

/// An action of two people, and the numbers of what is asked about either.
struct Both {
    state: usize,
    index: usize,
    action: Action,
    asked: [usize; 2],
}

/// Actions of two people from some states.
#[derive(Default)]
pub(super) struct Joined {
    all: Vec<Both>,
    /// Questions about either, so far.
    asked: usize,
    /// Those of the state at hand, of either: what one of the people meets follows from their posture and from the transition, which is
    /// of one way of theirs.
    of_state: [Vec<Option<usize>>; 2],
}

/// What was met, by the number of the question.
pub(super) struct CoursesByQuestion(Vec<PersonCourse>);

impl Joined {
    /// Goes on with another state.
    pub(super) fn begin(&mut self) {
        self.of_state.iter_mut().for_each(Vec::clear);
    }

    /// Whether there are two people.
    pub(super) const fn is_used(&self) -> bool {
        !self.all.is_empty()
    }

    /// An action from a state; what has not been asked yet is put among what is pending, by its number.
    pub(super) fn add(
        &mut self,
        (state, index): (usize, usize),
        action: Action,
        both: [Pending; 2],
        pending: &mut Vec<Pending>,
    ) {
        let asked = both.map(|one| {
            let who = one.who as usize;
            let known = &mut self.of_state[who];
            let alone = one.transition * Posture::ALL.len() + one.action.posture() as usize;
            if known.len() <= alone {
                known.resize(alone + 1, None);
            }
            *known[alone].get_or_insert_with(|| {
                pending.push(Pending { index: self.asked, ..one });
                self.asked += 1;
                self.asked - 1
            })
        });
        self.all.push(Both { state, index, action, asked });
    }

    /// What becomes of every action.
    pub(super) fn settle(
        self,
        met: &CoursesByQuestion,
        befores: &[PriorState],
        goes_on: bool,
        expanded: &mut [Expanded<State, Finding>],
    ) {
        for Both { state, index, action, asked } in self.all {
            let befallen = ActionHazards::of(asked.iter().map(|number| &met.0[*number]));
            let in_action = |finding: Finding| Finding { actions: vec![action], ..finding };
            let Expanded { effects, noted, .. } = &mut expanded[state];
            // Where both are hit at once, both is told, and the sequence counts for the first.
            let mut ends = befallen.ends.into_iter().map(in_action);
            if let Some(hit) = ends.next() {
                effects[index] = effects[index].hits(hit, goes_on);
            }
            let of = |of: Of| move |met: Finding| Noted { action: index, met, of };
            noted.extend(befallen.noted.into_iter().map(in_action).map(of(Of::Safe)));
            noted.extend(ends.map(of(Of::WithEnd)));
            for (clamping, is_told) in befallen.clampings {
                note_clamping(noted, (index, in_action(clamping)), befores[state], is_told);
            }
        }
    }
}

impl CoursesByQuestion {
    /// Nothing yet.
    pub(super) fn of(joined: &Joined) -> Self {
        Self(vec![PersonCourse::default(); joined.asked])
    }

    /// What a question met.
    pub(super) fn course(&mut self, number: usize) -> &mut PersonCourse {
        &mut self.0[number]
    }
}
