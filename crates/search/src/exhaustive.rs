//! Every action sequence, level by level: sequences that lead to the same state are continued once.
//!
//! A level holds the distinct states that are reached by safe sequences of so many actions, each with the *exact number*
//! of sequences it stands for and the calmest of them. So at the end every one of the `A^H` sequences is accounted for:
//! it meets an unsafe state (counted at its first), or reaches the horizon without, or comes to a state from which, by a
//! bound, no unsafe state can be met any more.
//!
//! **Behind the first unsafe state** a search may go on for what is worse and comes later, where the environment says where an
//! unsafe action leads. That changes no count: a sequence is hazardous from its first unsafe state on. What is met there is noted.
//! A state that safe and unsafe sequences lead to is expanded once for both; those that only unsafe ones lead to may take half of the
//! budget, and are given up beyond that ([`Account::behind_cut`]).
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
    /// Leads to an unsafe state: the sequence counts as hazardous.
    Unsafe {
        /// What is unsafe.
        met: U,
        /// The index of the state that it leads to, where the search goes on for what comes behind it.
        then: Option<usize>,
    },
    /// The simulator could not finish it: what it leads to is not known.
    NotEvaluated(String),
}

impl<U> Effect<U> {
    /// The same of an action in which something unsafe is met, where the search goes on behind it or not.
    #[must_use]
    pub fn hits(&self, met: U, goes_on: bool) -> Self {
        let then = match self {
            Self::To(index) if goes_on => Some(*index),
            _ => None,
        };
        Self::Unsafe { met, then }
    }
}

/// A state with all that can be done from it.
#[derive(Clone, Debug, PartialEq)]
pub struct Expanded<S, U> {
    /// Successors, of actions that are safe, and of others behind which the search goes on.
    pub next: Vec<S>,
    /// What each action does.
    pub effects: Vec<Effect<U>>,
    /// What else is unsafe on the way of actions, and counts no sequence.
    pub noted: Vec<Noted<U>>,
}

/// Something unsafe on the way of an action that counts no sequence.
#[derive(Clone, Debug, PartialEq)]
pub struct Noted<U> {
    /// The action.
    pub action: usize,
    /// What is known of it.
    pub met: U,
    /// Which sequences meet it.
    pub of: Of,
}

/// Which of the sequences that lead to a state meet something in the next action.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Of {
    /// Those that are safe until then.
    Safe,
    /// The same, together with what makes the action unsafe: another person's.
    WithEnd,
    /// Those that met something unsafe before.
    Unsafe,
    /// All.
    Either,
}

/// What the sequences met that lead to a state which is expanded.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PriorState {
    /// Nothing unsafe.
    Safe,
    /// All of them something unsafe: what is asked is what comes behind it alone.
    Unsafe,
    /// Some nothing, some something.
    Either,
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

    /// All actions from each of `states`, which are `depth` actions from the start, with what was met before; nothing if `go_on`,
    /// asked now and then, says no. From states behind something unsafe no action is unsafe, only noted.
    ///
    /// # Errors
    /// When the simulation cannot go on at all.
    fn expand(
        &mut self,
        depth: usize,
        states: &[(&Self::State, PriorState)],
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
    /// The same with an action more.
    fn then(&self, lead: Lead) -> Self {
        let (effort, calmest) = (self.effort + lead.effort, with(&self.calmest, lead.action));
        Self { count: &self.count * lead.count, effort, calmest }
    }

    fn join(&mut self, other: Self) {
        self.count += other.count;
        if (other.effort, &other.calmest) < (self.effort, &self.calmest) {
            (self.effort, self.calmest) = (other.effort, other.calmest);
        }
    }
}

/// An unsafe state and the sequences that meet it first with one action.
pub struct UnsafePrefix<'a, U> {
    /// The unsafe state.
    pub unsafe_state: U,
    /// The sequences before it.
    pub prefixes: &'a Prefixes,
    /// Number of full-length sequences that begin so.
    pub sequences: BigUint,
}

/// What is told while the search runs.
pub enum SearchEvent<'a, U> {
    /// Nothing new.
    Working,
    /// An unsafe state.
    UnsafeState(UnsafePrefix<'a, U>),
    /// Something unsafe that counts no sequence: it does not end them, or comes behind what did.
    Noted {
        /// What it is.
        unsafe_state: U,
        /// The sequences before it; without their number where they met something unsafe before.
        prefixes: &'a Prefixes,
        /// Whether it comes together with what makes these sequences hazardous.
        with_end: bool,
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
    /// Distinct states besides, that only sequences lead to which met something unsafe, and that were not dropped.
    pub behind: usize,
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
    /// What comes behind something unsafe was looked at for sequences of so many actions only, because that took too much; nothing
    /// where all of it was looked at.
    pub behind_cut: Option<usize>,
    /// Whether the simulator could not finish some of what comes behind something unsafe.
    pub behind_not_evaluated: bool,
}

impl Account {
    /// Of so many sequences nothing is known yet.
    fn of(total: BigUint) -> Self {
        Self {
            total,
            hazardous: BigUint::ZERO,
            harmless: BigUint::ZERO,
            excluded: BigUint::ZERO,
            not_evaluated: BigUint::ZERO,
            levels: Vec::new(),
            depth: 0,
            stopped: Stopped::Complete,
            behind_cut: None,
            behind_not_evaluated: false,
        }
    }

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

    /// Distinct states of all levels that only sequences lead to which met something unsafe.
    #[must_use]
    pub(crate) fn states_behind(&self) -> usize {
        self.levels.iter().map(|l| l.behind).sum()
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

/// Looks at an environment under way, asking now and then whether to go on: whether the search goes on.
pub type Look<'a, E> = dyn FnMut(&E, &mut dyn FnMut() -> bool) -> Result<bool, <E as Expansion>::Error> + 'a;

/// Searches all sequences; `tell` hears what is found and may end the search.
///
/// # Errors
/// Passes on what the environment reports as fatal; unsafe states told so far are real.
pub fn exhaust<E: Expansion>(
    environment: &mut E,
    budget: Budget,
    tell: &mut dyn FnMut(SearchEvent<'_, E::Unsafe>) -> ControlFlow<()>,
) -> Result<Account, E::Error> {
    exhaust_watched(environment, budget, &mut |_, _| Ok(true), tell)
}

/// The same; `look` sees the environment each time before states are expanded, and may end the search too.
///
/// # Errors
/// The same, and what `look` reports.
pub fn exhaust_watched<E: Expansion>(
    environment: &mut E,
    budget: Budget,
    look: &mut Look<'_, E>,
    tell: &mut dyn FnMut(SearchEvent<'_, E::Unsafe>) -> ControlFlow<()>,
) -> Result<Account, E::Error> {
    let horizon = environment.horizon();
    let start = environment.start()?;
    let first = Prefixes { count: BigUint::from(1_u32), effort: 0, calmest: Vec::new() };
    let account = Account::of(power(environment.actions(), horizon));
    let (mut level, mut behind) = (BTreeMap::from([(start, first)]), BTreeMap::new());
    let (next, behind_next) = (BTreeMap::new(), BTreeMap::new());
    let mut search = Search { environment, budget, look, tell, account, next, behind: behind_next, open: 0 };
    for depth in 0..horizon {
        let (open, other) = search.sorted(level, behind, horizon - depth);
        search.open = open.len() + other.len();
        if let Some(stopped) = search.safe(depth, &open)? {
            search.account.stopped = stopped;
            return Ok(search.account);
        }
        if let Some(stopped) = search.unsafe_before(depth, &other)? {
            search.account.stopped = stopped;
            return Ok(search.account);
        }
        search.account.depth = depth + 1;
        (level, behind) = (std::mem::take(&mut search.next), std::mem::take(&mut search.behind));
        search.environment.release_before(depth + 1);
    }
    Ok(search.account)
}

/// A level's states by their prefixes.
type LevelOf<S> = BTreeMap<S, Prefixes>;

/// A state, the safe sequences that lead there, and the calmest of the others if there are any.
type Open<S> = (S, Prefixes, Option<Prefixes>);

/// Those of a level, and the states that only sequences lead to that met something unsafe.
type Sorted<S> = (Vec<Open<S>>, Vec<(S, Prefixes)>);

/// A search under way.
struct Search<'a, 'b, E: Expansion> {
    environment: &'a mut E,
    budget: Budget,
    look: &'a mut Look<'b, E>,
    tell: &'a mut (dyn FnMut(SearchEvent<'_, E::Unsafe>) -> ControlFlow<()> + 'b),
    account: Account,
    /// The next level, by safe sequences.
    next: LevelOf<E::State>,
    /// The same, by sequences that met something unsafe: no number of sequences, but the calmest.
    behind: LevelOf<E::State>,
    /// States of this level.
    open: usize,
}

impl<E: Expansion> Search<'_, '_, E> {
    /// The states of a level that are to be expanded: those that safe sequences lead to, and those that only others lead to.
    fn sorted(
        &mut self,
        level: LevelOf<E::State>,
        mut behind: LevelOf<E::State>,
        remaining: usize,
    ) -> Sorted<E::State> {
        let mut figures = Level { states: level.len(), ..Level::default() };
        let mut open = Vec::with_capacity(level.len());
        for (state, prefixes) in level {
            let others = behind.remove(&state);
            if self.budget.drop && !self.environment.may_matter(&state, remaining) {
                figures.dropped += 1;
                self.account.excluded += prefixes.count * power(self.environment.actions(), remaining);
            } else {
                open.push((state, prefixes, others));
            }
        }
        if self.budget.drop {
            behind.retain(|state, _| self.environment.may_matter(state, remaining));
        }
        figures.behind = behind.len();
        self.account.levels.push(figures);
        (open, behind.into_iter().collect())
    }

    /// Expands what safe sequences lead to; why that ended early, if it did.
    fn safe(&mut self, depth: usize, open: &[Open<E::State>]) -> Result<Option<Stopped>, E::Error> {
        let together = self.environment.together().max(1);
        let before = self.account.states();
        for (number, chunk) in open.chunks(together).enumerate() {
            if self.behind_is_spent() {
                self.give_up_behind(depth);
            }
            let spent = self.environment.work() > self.budget.work;
            if before + self.next.len() > self.budget.states || self.bytes() > self.budget.bytes || spent {
                return Ok(Some(Stopped::Budget));
            }
            let before_of =
                |others: &Option<Prefixes>| if others.is_some() { PriorState::Either } else { PriorState::Safe };
            let states: Vec<_> = chunk.iter().map(|(state, _, others)| (state, before_of(others))).collect();
            let Some(expanded) = self.expand(depth, &states)? else { return Ok(Some(Stopped::Asked)) };
            for ((_, prefixes, others), expanded) in chunk.iter().zip(expanded) {
                self.take_in(depth, (Some(prefixes), others.as_ref()), expanded);
            }
            let done = (number * together + chunk.len()).min(open.len());
            let cost = self.environment.cost();
            if (self.tell)(SearchEvent::Progress { depth, done, of: open.len(), cost }).is_break() {
                return Ok(Some(Stopped::Asked));
            }
        }
        Ok(None)
    }

    /// Expands what only sequences lead to that met something unsafe before.
    fn unsafe_before(&mut self, depth: usize, behind: &[(E::State, Prefixes)]) -> Result<Option<Stopped>, E::Error> {
        for chunk in behind.chunks(self.environment.together().max(1)) {
            if self.behind_is_spent() {
                self.give_up_behind(depth);
            }
            if self.account.behind_cut.is_some() {
                break;
            }
            let states: Vec<_> = chunk.iter().map(|(state, _)| (state, PriorState::Unsafe)).collect();
            let Some(expanded) = self.expand(depth, &states)? else { return Ok(Some(Stopped::Asked)) };
            for ((_, prefixes), expanded) in chunk.iter().zip(expanded) {
                self.take_in(depth, (None, Some(prefixes)), expanded);
            }
            if (self.tell)(SearchEvent::Working).is_break() {
                return Ok(Some(Stopped::Asked));
            }
        }
        Ok(None)
    }

    fn expand(&mut self, depth: usize, states: &[(&E::State, PriorState)]) -> Result<Option<ExpandedBy<E>>, E::Error> {
        let tell = &mut *self.tell;
        let mut go_on = || tell(SearchEvent::Working).is_continue();
        if !(self.look)(self.environment, &mut go_on)? {
            return Ok(None);
        }
        self.environment.expand(depth, states, &mut go_on)
    }

    /// What the actions from a state lead to: of safe sequences, and of those that met something unsafe before.
    fn take_in(
        &mut self,
        depth: usize,
        (safe, others): (Option<&Prefixes>, Option<&Prefixes>),
        expanded: Expanded<E::State, E::Unsafe>,
    ) {
        for Noted { met, of, .. } in expanded.noted {
            // Of what both kinds of sequences meet, the calmest is told.
            let prefixes = match of {
                Of::Safe | Of::WithEnd => safe,
                Of::Unsafe => others,
                Of::Either => [safe, others].into_iter().flatten().min_by_key(|p| (p.effort, &p.calmest)),
            };
            if let Some(prefixes) = prefixes {
                let _ = (self.tell)(SearchEvent::Noted { unsafe_state: met, prefixes, with_end: of == Of::WithEnd });
            }
        }
        let left = power(self.environment.actions(), self.environment.horizon() - depth - 1);
        // For each state that follows, how many actions lead there, and the calmest of them.
        let mut lead: Vec<Option<Lead>> = vec![None; expanded.next.len()];
        let mut lead_behind = lead.clone();
        for (action, effect) in expanded.effects.into_iter().enumerate() {
            let one = Lead { count: 1, effort: self.environment.effort(action), action };
            match effect {
                Effect::To(index) => {
                    Lead::add(&mut lead[index], one);
                    Lead::add(&mut lead_behind[index], one);
                }
                Effect::NotEvaluated(reason) => {
                    // Of a sequence that is unsafe already nothing more is counted.
                    if let Some(prefixes) = safe {
                        self.account.not_evaluated += &prefixes.count * &left;
                        let _ = (self.tell)(SearchEvent::Failed { reason, action, prefixes });
                    } else {
                        self.account.behind_not_evaluated = true;
                    }
                }
                Effect::Unsafe { met, then } => {
                    if let Some(index) = then {
                        Lead::add(&mut lead_behind[index], one);
                    }
                    let Some(prefixes) = safe else { continue };
                    if let Some(index) = then.filter(|_| depth + 1 < self.environment.horizon()) {
                        let state = expanded.next[index].clone();
                        self.goes_on(state, prefixes, one);
                    }
                    let sequences = &prefixes.count * &left;
                    self.account.hazardous += &sequences;
                    let _ =
                        (self.tell)(SearchEvent::UnsafeState(UnsafePrefix { unsafe_state: met, prefixes, sequences }));
                }
            }
        }
        for (state, (lead, lead_behind)) in expanded.next.into_iter().zip(lead.into_iter().zip(lead_behind)) {
            if let (Some(prefixes), Some(lead)) = (others, lead_behind)
                && depth + 1 < self.environment.horizon()
            {
                self.goes_on(state.clone(), prefixes, lead);
            }
            let (Some(prefixes), Some(lead)) = (safe, lead) else { continue };
            if depth + 1 == self.environment.horizon() {
                self.account.harmless += &prefixes.count * lead.count;
            } else {
                put(&mut self.next, state, prefixes.then(lead));
            }
        }
    }

    /// A sequence goes on though it met something unsafe.
    fn goes_on(&mut self, state: E::State, prefixes: &Prefixes, lead: Lead) {
        if self.account.behind_cut.is_none() {
            put(&mut self.behind, state, Prefixes { count: BigUint::ZERO, ..prefixes.then(lead) });
        }
    }

    fn bytes(&self) -> usize {
        let states = self.open + self.next.len() + self.behind.len();
        self.environment.bytes() + states * (self.environment.state_bytes() + STATE_BYTES)
    }

    /// What only unsafe sequences lead to may take half of what there is: what is safe until then counts more.
    fn behind_is_spent(&self) -> bool {
        let states = self.account.states_behind() + self.behind.len();
        let is_used = states > 0 && self.account.behind_cut.is_none();
        is_used
            && (states > self.budget.states / 2
                || self.bytes() > self.budget.bytes / 2
                || self.environment.work() > self.budget.work / 2)
    }

    fn give_up_behind(&mut self, depth: usize) {
        self.account.behind_cut.get_or_insert(depth);
        self.behind.clear();
    }
}

/// So many actions from a state lead to another one, and this is the calmest of them.
#[derive(Clone, Copy)]
struct Lead {
    count: u32,
    effort: u32,
    action: usize,
}

impl Lead {
    fn add(known: &mut Option<Self>, one: Self) {
        *known = Some(match *known {
            None => one,
            Some(known) => {
                let calmer = if (known.effort, known.action) <= (one.effort, one.action) { known } else { one };
                Self { count: known.count + one.count, ..calmer }
            }
        });
    }
}

fn put<S: Ord>(level: &mut LevelOf<S>, state: S, prefixes: Prefixes) {
    match level.entry(state) {
        Entry::Occupied(mut known) => known.get_mut().join(prefixes),
        Entry::Vacant(new) => {
            new.insert(prefixes);
        }
    }
}

/// Sequences of so many actions each.
fn power(actions: usize, length: usize) -> BigUint {
    BigUint::from(actions).pow(u32::try_from(length).unwrap_or(u32::MAX))
}

fn with(actions: &[u32], action: usize) -> Vec<u32> {
    let last = u32::try_from(action).unwrap_or(u32::MAX);
    actions.iter().copied().chain([last]).collect()
}

#[cfg(test)]
#[path = "exhaustive_tests.rs"]
mod tests;
