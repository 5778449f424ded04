//! Every action sequence, level by level: sequences that lead to the same state are continued once.
//!
//! A level holds the distinct states that are reached by safe sequences of so many actions, each with the *exact number*
//! of sequences it stands for and the calmest of them. So at the end every one of the `A^H` sequences is accounted for:
//! it meets an unsafe state (counted at its first), or reaches the horizon without, or comes to a state from which, by a
//! bound, no unsafe state can be met any more.
//!
//! What makes states equal, and the bound, are the environment's: see [`Expansion`].

use std::collections::BTreeMap;
use std::collections::btree_map::Entry;
use std::ops::ControlFlow;

use num_bigint::BigUint;

/// What one action does.
#[derive(Clone, Debug, PartialEq)]
pub enum Effect<U> {
    /// Leads to the state with this index in [`Expanded::next`].
    To(usize),
    /// Leads to an unsafe state: the sequence ends.
    Unsafe(U),
    /// The simulator could not finish it: what it leads to is not known.
    NotEvaluated(String),
}

/// A state with all that can be done from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Expanded<S, U> {
    /// Successors that safe actions lead to.
    pub next: Vec<S>,
    /// What each action does.
    pub effects: Vec<Effect<U>>,
    /// What is unsafe on the way of an action without ending it: the action, and what is known of it.
    pub noted: Vec<(usize, U)>,
}

/// Expanded states of an [`Expansion`], in the order in which they were asked for.
pub type ExpandedBy<E> = Vec<Expanded<<E as Expansion>::State, <E as Expansion>::Unsafe>>;

/// An environment whose states can be told apart and expanded many at a time.
pub trait Expansion {
    /// A state. Equal states have the same future.
    type State: Clone + Ord;
    /// What is known of an unsafe state.
    type Unsafe;
    /// A failure that ends the search.
    type Error;

    /// Number of actions; the same in every state.
    fn actions(&self) -> usize;

    /// Length of the sequences.
    fn horizon(&self) -> usize;

    /// How far from calm an action is: of sequences of the same length the one with the least sum is the calmest.
    fn effort(&self, action: usize) -> u32;

    /// The state before the first action.
    ///
    /// # Errors
    /// When it cannot be reached.
    fn start(&mut self) -> Result<Self::State, Self::Error>;

    /// Whether an unsafe state may be met from `state` in `remaining` actions. `false` needs proof.
    fn may_matter(&self, state: &Self::State, remaining: usize) -> bool;

    /// All actions from each of `states`, which are `depth` actions from the start; nothing if `go_on`, asked now and
    /// then, says no.
    ///
    /// # Errors
    /// When the simulation cannot go on at all.
    fn expand(
        &mut self,
        depth: usize,
        states: &[&Self::State],
        go_on: &mut dyn FnMut() -> bool,
    ) -> Result<Option<ExpandedBy<Self>>, Self::Error>;

    /// States of less than `depth` actions are not asked for again.
    fn release_before(&mut self, depth: usize);

    /// States to expand at a time: more share more, fewer let a wish or a budget end the search sooner.
    fn together(&self) -> usize {
        1024
    }

    /// Work done so far, in a unit of the environment's own that does not depend on the machine.
    fn work(&self) -> u64 {
        0
    }

    /// All that was done so far, work included, in another unit of that kind.
    fn cost(&self) -> u64 {
        self.work()
    }

    /// Memory held besides the states themselves, bytes, about.
    fn bytes(&self) -> usize;

    /// Memory that a state takes, bytes, about.
    fn state_bytes(&self) -> usize {
        size_of::<Self::State>()
    }
}

/// The sequences that lead to a state.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Prefixes {
    /// How many there are.
    pub count: BigUint,
    /// Sum of efforts of the calmest.
    pub effort: u32,
    /// The calmest; of equals the first in the order of actions.
    pub calmest: Vec<u32>,
}

impl Prefixes {
    fn join(&mut self, other: Self) {
        self.count += other.count;
        if (other.effort, &other.calmest) < (self.effort, &self.calmest) {
            (self.effort, self.calmest) = (other.effort, other.calmest);
        }
    }
}

/// An unsafe state and the sequences that meet it first with this action.
pub struct Met<'a, U> {
    /// The unsafe state.
    pub unsafe_state: U,
    /// The last action.
    pub action: usize,
    /// The sequences before it.
    pub prefixes: &'a Prefixes,
    /// Number of full-length sequences that begin so.
    pub sequences: BigUint,
}

/// What is told while the search runs.
pub enum Told<'a, U> {
    /// Nothing new.
    Working,
    /// An unsafe state.
    Met(Met<'a, U>),
    /// Something unsafe with which sequences do not end.
    Noted {
        /// What it is.
        unsafe_state: U,
        /// The sequences before it.
        prefixes: &'a Prefixes,
    },
    /// An action that could not be evaluated.
    Failed {
        /// Why.
        reason: String,
        /// The action.
        action: usize,
        /// The sequences before it.
        prefixes: &'a Prefixes,
    },
    /// So many states of a level have been expanded.
    Progress {
        /// Actions before these states.
        depth: usize,
        /// States expanded.
        done: usize,
        /// States of the level.
        of: usize,
        /// What everything cost so far, see [`Expansion::cost`].
        cost: u64,
    },
}

/// Why the search stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stopped {
    /// It is complete.
    Complete,
    /// More states, or more memory, than allowed.
    Budget,
    /// Told to stop.
    Asked,
}

/// Figures of one level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Level {
    /// Distinct states.
    pub states: usize,
    /// Of these, dropped because no unsafe state can be met from them any more.
    pub dropped: usize,
}

/// Where every sequence went.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Account {
    /// All there are: `A^H`.
    pub total: BigUint,
    /// Met an unsafe state.
    pub hazardous: BigUint,
    /// Reached the horizon without.
    pub harmless: BigUint,
    /// Cannot meet one, by the bound.
    pub excluded: BigUint,
    /// The simulator could not finish them.
    pub not_evaluated: BigUint,
    /// Levels from the start; where the sequences end, states are not told apart any more.
    pub levels: Vec<Level>,
    /// All sequences of so many actions have been looked at.
    pub depth: usize,
    /// Why the search stopped.
    pub stopped: Stopped,
}

impl Account {
    /// Sequences whose fate is known.
    #[must_use]
    pub fn covered(&self) -> BigUint {
        &self.hazardous + &self.harmless + &self.excluded
    }

    /// Distinct states of all levels.
    #[must_use]
    pub fn states(&self) -> usize {
        self.levels.iter().map(|l| l.states).sum()
    }
}

/// Limits of the search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Budget {
    /// Most distinct states, all levels together.
    pub states: usize,
    /// Most memory, bytes, about.
    pub bytes: usize,
    /// Most work, in the environment's unit.
    pub work: u64,
    /// Whether states may be dropped by the bound; `false` is for comparisons.
    pub drop: bool,
}

/// Bytes that a state takes besides itself, about: its prefixes and its place in the map.
const STATE_BYTES: usize = 120;

/// Searches all sequences; `tell` hears what is found and may end the search.
///
/// # Errors
/// Passes on what the environment reports as fatal; unsafe states told so far are real.
pub fn exhaust<E: Expansion>(
    environment: &mut E,
    budget: Budget,
    tell: &mut dyn FnMut(Told<'_, E::Unsafe>) -> ControlFlow<()>,
) -> Result<Account, E::Error> {
    let (actions, horizon) = (environment.actions(), environment.horizon());
    let power = |exponent: usize| BigUint::from(actions).pow(u32::try_from(exponent).unwrap_or(u32::MAX));
    let mut account = Account {
        total: power(horizon),
        hazardous: BigUint::ZERO,
        harmless: BigUint::ZERO,
        excluded: BigUint::ZERO,
        not_evaluated: BigUint::ZERO,
        levels: Vec::new(),
        depth: 0,
        stopped: Stopped::Complete,
    };
    let first = Prefixes { count: BigUint::from(1_u32), effort: 0, calmest: Vec::new() };
    let mut level = BTreeMap::from([(environment.start()?, first)]);
    for depth in 0..horizon {
        let mut figures = Level { states: level.len(), dropped: 0 };
        let mut open: Vec<(E::State, Prefixes)> = Vec::with_capacity(level.len());
        for (state, prefixes) in level {
            if budget.drop && !environment.may_matter(&state, horizon - depth) {
                figures.dropped += 1;
                account.excluded += prefixes.count * power(horizon - depth);
            } else {
                open.push((state, prefixes));
            }
        }
        account.levels.push(figures);
        let left = power(horizon - depth - 1);
        let mut next: BTreeMap<E::State, Prefixes> = BTreeMap::new();
        let before = account.states();
        let together = environment.together().max(1);
        for (number, chunk) in open.chunks(together).enumerate() {
            let bytes = environment.bytes() + (open.len() + next.len()) * (environment.state_bytes() + STATE_BYTES);
            let spent = environment.work() > budget.work;
            if before + next.len() > budget.states || bytes > budget.bytes || spent {
                account.stopped = Stopped::Budget;
                return Ok(account);
            }
            let states: Vec<&E::State> = chunk.iter().map(|(state, _)| state).collect();
            let Some(expanded) = environment.expand(depth, &states, &mut || tell(Told::Working).is_continue())? else {
                account.stopped = Stopped::Asked;
                return Ok(account);
            };
            for ((_, prefixes), expanded) in chunk.iter().zip(expanded) {
                for (_, unsafe_state) in expanded.noted {
                    let _ = tell(Told::Noted { unsafe_state, prefixes });
                }
                // For each state that follows, how many actions lead there, and the calmest of them.
                let mut lead: Vec<Option<(u32, u32, usize)>> = vec![None; expanded.next.len()];
                for (action, effect) in expanded.effects.into_iter().enumerate() {
                    match effect {
                        Effect::To(index) => {
                            let effort = environment.effort(action);
                            lead[index] = Some(match lead[index] {
                                None => (1, effort, action),
                                Some((count, known, by)) if (known, by) <= (effort, action) => (count + 1, known, by),
                                Some((count, ..)) => (count + 1, effort, action),
                            });
                        }
                        Effect::NotEvaluated(reason) => {
                            account.not_evaluated += &prefixes.count * &left;
                            let _ = tell(Told::Failed { reason, action, prefixes });
                        }
                        Effect::Unsafe(unsafe_state) => {
                            let sequences = &prefixes.count * &left;
                            account.hazardous += &sequences;
                            let _ = tell(Told::Met(Met { unsafe_state, action, prefixes, sequences }));
                        }
                    }
                }
                for (state, lead) in expanded.next.into_iter().zip(lead) {
                    let Some((count, effort, action)) = lead else { continue };
                    let count = &prefixes.count * count;
                    if depth + 1 == horizon {
                        account.harmless += count;
                        continue;
                    }
                    let (effort, calmest) = (prefixes.effort + effort, with(&prefixes.calmest, action));
                    let longer = Prefixes { count, effort, calmest };
                    match next.entry(state) {
                        Entry::Occupied(mut known) => known.get_mut().join(longer),
                        Entry::Vacant(new) => {
                            new.insert(longer);
                        }
                    }
                }
            }
            let done = (number * together + chunk.len()).min(open.len());
            if tell(Told::Progress { depth, done, of: open.len(), cost: environment.cost() }).is_break() {
                account.stopped = Stopped::Asked;
                return Ok(account);
            }
        }
        account.depth = depth + 1;
        level = next;
        environment.release_before(depth + 1);
    }
    Ok(account)
}

fn with(actions: &[u32], action: usize) -> Vec<u32> {
    let last = u32::try_from(action).unwrap_or(u32::MAX);
    actions.iter().copied().chain([last]).collect()
}

#[cfg(test)]
#[path = "exhaustive_tests.rs"]
mod tests;
