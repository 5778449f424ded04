//! What becomes of the actions of two people: each of them is asked about alone, once for all actions that bring them the same, and an
//! action is over for both when one of them is hit.

use super::{Pending, State};
use crate::hazard::Finding;
use crate::human::{Action, Posture};
use crate::search::exhaustive::{Effect, Expanded};
use crate::sim::befallen::Befallen;

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

/// What was met, by the number of the question: what ends the action comes last.
pub(super) struct Met(Vec<Vec<Finding>>);

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
    pub(super) fn settle(self, met: &Met, expanded: &mut [Expanded<State, Finding>]) {
        for Both { state, index, action, asked } in self.all {
            let befallen = Befallen::of(asked.iter().map(|number| met.0[*number].as_slice()));
            let in_action = |finding: Finding| Finding { actions: vec![action], ..finding };
            let Expanded { effects, noted, .. } = &mut expanded[state];
            // Where both are hit at once, both is told, and the sequence counts for the first.
            let mut ends = befallen.ends.into_iter().map(in_action);
            if let Some(hit) = ends.next() {
                effects[index] = Effect::Unsafe(hit);
            }
            noted.extend(befallen.noted.into_iter().map(in_action).chain(ends).map(|finding| (index, finding)));
        }
    }
}

impl Met {
    /// Nothing yet.
    pub(super) fn of(joined: &Joined) -> Self {
        Self(vec![Vec::new(); joined.asked])
    }

    /// Takes in what a question met; whether it is to be asked on.
    pub(super) fn keeps_on(&mut self, number: usize, finding: Finding) -> bool {
        let goes_on = !finding.class.ends();
        self.0[number].push(finding);
        goes_on
    }
}
