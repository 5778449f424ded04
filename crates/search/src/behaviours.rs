//! Few behaviours in place of many histories.
//!
//! A machine is stepped with one of a few *readings* at a time. States of it that show the same now, and the same after each of some
//! steps while any one reading that may come next is held, are taken for one: a *behaviour*. How often readings changed before does not matter then, nor
//! when: where only so many behaviours turn up, they are all there ever are, and a history of any length is a way through them.
//!
//! That states which are taken for one answer any readings alike, and not only held ones, is an assumption. It holds where everything
//! that the machine remembers shows while one reading is held for so long: timers run out and ramps end. It does not where it counts or
//! looks at a clock. [`walks`] tries that out.

pub mod answers;
pub mod covers;
pub mod decided;
pub mod net;
pub(crate) mod shows;
pub mod stays;
pub mod walks;

use std::collections::{BTreeMap, BTreeSet, VecDeque};
use std::ops::ControlFlow;

use sha2::{Digest as _, Sha256};

/// A machine whose states can be come back to.
pub trait Machine {
    /// A state.
    type State;
    /// What makes all of it pointless.
    type Error;

    /// How many readings there are.
    fn readings(&self) -> usize;

    /// Which others may follow each of them.
    fn others(&self) -> Others {
        any(self.readings())
    }

    /// Readings that are taken for one have numbers of their own from now on, or no longer.
    fn tell_apart(&mut self, _apart: bool) {}

    /// The number of what a reading is taken for.
    fn taken_for(&self, reading: usize) -> usize {
        reading
    }

    /// Whether two things that are shown may be the same, but for what rounding does.
    fn alike(&self, one: OutputClass, other: OutputClass) -> bool;
    /// The same, whatever is on its way that does not show yet.
    fn look_alike(&self, one: OutputClass, other: OutputClass) -> bool {
        self.alike(one, other)
    }

    /// Whether something that is shown is what may be shown in place of the middle one of three that follow one another, where rounding
    /// decides in which of two steps something switches.
    fn switches(&self, one: OutputClass, among: [OutputClass; 3]) -> bool;

    /// The state at the start, and what it shows.
    ///
    /// # Errors
    /// When it cannot be begun.
    fn begin(&mut self) -> Result<(Self::State, OutputClass), Self::Error>;

    /// Holds readings for some steps each: what is shown after each step, and the state after the last. Nothing where some could not be
    /// finished.
    ///
    /// # Errors
    /// When the machine cannot go on at all.
    fn hold_each(&mut self, holds: &[Hold<'_, Self::State>]) -> Result<AllHeld<Self::State>, Self::Error>;

    /// The same of one.
    ///
    /// # Errors
    /// When the machine cannot go on at all.
    fn hold(
        &mut self,
        state: &Self::State,
        reading: usize,
        steps: usize,
    ) -> Result<Option<Held<Self::State>>, Self::Error> {
        let all = self.hold_each(&[Hold { from: Begins::At(state), reading, steps, last: false }])?;
        Ok(all.and_then(|mut all| all.pop()))
    }
}

/// By reading, others that may follow it: those of a higher number first, and then from 0 on.
pub type Others = Vec<Vec<usize>>;

/// Where any of so many readings may follow any other.
#[must_use]
pub fn any(readings: usize) -> Others {
    (0..readings).map(|reading| (1..readings).map(|by| (reading + by) % readings).collect()).collect()
}

/// A reading that is held.
#[derive(Debug)]
pub struct Hold<'a, S> {
    /// From where on.
    pub from: Begins<'a, S>,
    /// Which.
    pub reading: usize,
    /// For so many steps.
    pub steps: usize,
    /// Whether only what is shown after the last of them is asked for.
    pub last: bool,
}

/// Where a hold begins.
#[derive(Debug)]
pub enum Begins<'a, S> {
    /// At a state.
    At(&'a S),
    /// Where an earlier one of the same holds ended, by its number.
    After(usize),
}

/// The number of what is shown: the same for states that show the same.
pub type OutputClass = u32;

/// What is shown after each step, and the state after the last.
pub type Held<S> = (Vec<OutputClass>, S);

/// The same of several holds; nothing where some could not be finished.
pub type AllHeld<S> = Option<Vec<Held<S>>>;

/// How far is looked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent<'a> {
    /// By reading, for so many steps it is held before states are taken for one.
    pub held: &'a [usize],
    /// So many steps from the start at most.
    pub steps: usize,
    /// So many behaviours at most.
    pub most: usize,
}

/// The longest that a reading is held.
#[must_use]
pub fn longest(held: &[usize]) -> usize {
    held.iter().copied().max().unwrap_or_default()
}

/// Why no more behaviours were looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum BehaviourSearchEnd {
    /// There are no others, however long readings change.
    Closed,
    /// There are no others within the steps that were asked for.
    Steps,
    /// There are more than allowed.
    Most,
    /// Some steps could not be finished.
    Unfinished,
    /// Told to.
    Asked,
}

/// Number of a behaviour, in the order in which they were met: those of fewer steps from the start first.
pub type Number = u32;

/// No behaviour is known.
const NONE: Number = Number::MAX;

/// What was found.
#[derive(Clone, Debug)]
pub struct Behaviours {
    others: Others,
    /// Where any of these readings may come next: of each reading itself and the others, in order. The same by number.
    coming: Vec<(u32, Vec<usize>)>,
    /// What each behaviour shows.
    shows: Vec<OutputClass>,
    /// The fewest steps that lead to it, and the last of them: from which one, and the reading.
    depth: Vec<u32>,
    came: Vec<(Number, u32)>,
    /// By behaviour and reading, the one after a step.
    next: Vec<Number>,
    /// Successors that were a behaviour which was known.
    pub merged: u64,
    /// Why it ended.
    pub ended: BehaviourSearchEnd,
}

impl Behaviours {
    /// None yet.
    #[expect(clippy::cast_possible_truncation, reason = "a few readings")]
    fn none(others: Others) -> Self {
        let (shows, depth, came, next) = Default::default();
        let sets: Vec<BTreeSet<usize>> =
            others.iter().enumerate().map(|(own, others)| others.iter().copied().chain([own]).collect()).collect();
        let first = |set: &BTreeSet<usize>| sets.iter().position(|known| known == set).unwrap_or_default() as u32;
        let coming = sets.iter().map(|set| (first(set), set.iter().copied().collect())).collect();
        Self { others, coming, shows, depth, came, next, merged: 0, ended: BehaviourSearchEnd::Closed }
    }

    /// Readings that may come next after one, itself as well, in order; and a number that is the same for the same of them.
    fn coming(&self, reading: usize) -> (u32, &[usize]) {
        let (number, coming) = &self.coming[reading];
        (*number, coming)
    }

    /// Another, which was come to from one by a step with a reading.
    #[expect(clippy::cast_possible_truncation, reason = "fewer than are allowed")]
    fn add(&mut self, shown: OutputClass, came: Option<(Number, usize)>) -> Number {
        let number = self.count() as Number;
        self.shows.push(shown);
        self.depth.push(came.map_or(0, |(before, _)| self.depth[before as usize] + 1));
        self.came.push(came.map_or((number, 0), |(before, reading)| (before, reading as u32)));
        self.next.extend(std::iter::repeat_n(NONE, self.readings()));
        if let Some((before, reading)) = came {
            self.follow(before, reading, number);
        }
        number
    }

    /// One is followed by another after a step with a reading.
    fn follow(&mut self, number: Number, reading: usize, next: Number) {
        let readings = self.readings();
        self.next[number as usize * readings + reading] = next;
    }

    /// How many there are: the start at least.
    #[must_use]
    pub const fn count(&self) -> usize {
        self.shows.len()
    }

    /// What one shows.
    #[must_use]
    pub fn shown(&self, number: Number) -> OutputClass {
        self.shows[number as usize]
    }

    /// The one after a step with a reading; nothing where that was not looked at.
    #[must_use]
    pub fn next(&self, number: Number, reading: usize) -> Option<Number> {
        Some(self.next[number as usize * self.readings() + reading]).filter(|next| *next != NONE)
    }

    /// The one before, on a way that leads to one in as few steps as any; nothing at the start.
    #[must_use]
    pub fn before(&self, number: Number) -> Option<Number> {
        (self.depth(number) > 0).then(|| self.came[number as usize].0)
    }

    /// How many readings there are.
    #[must_use]
    pub const fn readings(&self) -> usize {
        self.others.len()
    }

    /// Which others may follow each of them.
    #[must_use]
    pub(crate) fn others(&self) -> &[Vec<usize>] {
        &self.others
    }

    /// The fewest steps that lead to one.
    #[must_use]
    pub fn depth(&self, number: Number) -> usize {
        self.depth[number as usize] as usize
    }

    /// Readings that lead to one from the start, in as few steps as any.
    #[cfg(test)]
    pub(crate) fn way_to(&self, mut number: Number) -> Vec<usize> {
        let mut way = Vec::new();
        while self.depth[number as usize] > 0 {
            let (before, reading) = self.came[number as usize];
            way.push(reading as usize);
            number = before;
        }
        way.reverse();
        way
    }
}

/// What is shown while a reading is held from a state on: the next so many steps, and the state after the last of them.
struct HeldRun<S> {
    ahead: VecDeque<OutputClass>,
    tip: S,
}

/// A behaviour whose successors are to be found.
struct Open<S> {
    number: Number,
    state: S,
    /// Readings that may come next, in order.
    runs: Vec<(usize, HeldRun<S>)>,
}

/// So many behaviours are gone on from at once.
const AT_ONCE: usize = 48;

/// Finds all behaviours.
///
/// # Errors
/// What the machine reports.
pub fn find<M: Machine>(
    machine: &mut M,
    extent: Extent<'_>,
    tell: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Result<Behaviours, M::Error> {
    let mut search = Search::new(machine, extent);
    let ended = search.run(tell)?;
    Ok(Behaviours { ended, ..search.found })
}

struct Search<'a, M: Machine> {
    machine: &'a mut M,
    extent: Extent<'a>,
    found: Behaviours,
    /// Behaviours by what tells them from others, in short.
    known: BTreeMap<[u8; 32], Number>,
}

impl<'a, M: Machine> Search<'a, M> {
    fn new(machine: &'a mut M, extent: Extent<'a>) -> Self {
        let found = Behaviours::none(machine.others());
        Self { machine, extent, found, known: BTreeMap::new() }
    }

    fn run(&mut self, tell: &mut dyn FnMut(usize) -> ControlFlow<()>) -> Result<BehaviourSearchEnd, M::Error> {
        let (state, shown) = self.machine.begin()?;
        let coming = self.found.coming(0).1.to_vec();
        let hold = |reading: &usize| Hold {
            from: Begins::At(&state),
            reading: *reading,
            steps: self.extent.held[*reading],
            last: false,
        };
        let each: Vec<_> = coming.iter().map(hold).collect();
        let Some(runs) = self.machine.hold_each(&each)? else { return Ok(BehaviourSearchEnd::Unfinished) };
        let runs =
            coming.into_iter().zip(runs).map(|(reading, (ahead, tip))| (reading, HeldRun { ahead: ahead.into(), tip }));
        let runs: Vec<_> = runs.collect();
        let (first, _) = self.behaviour((0, shown), &runs, None);
        let mut open = VecDeque::from([Open { number: first, state, runs }]);
        while !open.is_empty() {
            if tell(self.found.count()).is_break() {
                return Ok(BehaviourSearchEnd::Asked);
            }
            let some: Vec<Open<M::State>> = open.drain(..AT_ONCE.min(open.len())).collect();
            let Some(held) = self.machine.hold_each(&self.holds(&some))? else {
                return Ok(BehaviourSearchEnd::Unfinished);
            };
            let mut held = held.into_iter();
            for one in some {
                if self.found.depth(one.number) == self.extent.steps {
                    return Ok(BehaviourSearchEnd::Steps);
                }
                for (reading, run) in one.runs {
                    let own = held.by_ref().take(2 + self.found.others[reading].len()).collect();
                    match self.step(one.number, reading, run, own) {
                        Some(next) => open.push_back(next),
                        None => self.found.merged += 1,
                    }
                    if self.found.count() > self.extent.most {
                        return Ok(BehaviourSearchEnd::Most);
                    }
                }
            }
        }
        Ok(BehaviourSearchEnd::Closed)
    }

    /// What is asked of some behaviours: by reading, the state after a step with it; a step more while it is held; and all others that may
    /// follow held from that state on.
    fn holds<'b>(&self, some: &'b [Open<M::State>]) -> Vec<Hold<'b, M::State>> {
        let mut all = Vec::new();
        for one in some {
            for (reading, run) in &one.runs {
                let (after, reading) = (all.len(), *reading);
                all.push(Hold { from: Begins::At(&one.state), reading, steps: 1, last: false });
                all.push(Hold { from: Begins::At(&run.tip), reading, steps: 1, last: false });
                let other = |other: &usize| {
                    let (reading, steps) = (*other, self.extent.held[*other]);
                    Hold { from: Begins::After(after), reading, steps, last: false }
                };
                all.extend(self.found.others[reading].iter().map(other));
            }
        }
        all
    }

    /// Takes in a step with a reading, of which `run` tells what is shown while it is held, and what that asked for: how the behaviour after
    /// it goes on, if it is new.
    fn step(
        &mut self,
        number: Number,
        reading: usize,
        mut run: HeldRun<M::State>,
        held: Vec<Held<M::State>>,
    ) -> Option<Open<M::State>> {
        let mut held = held.into_iter();
        let (Some((_, state)), Some((more, tip))) = (held.next(), held.next()) else { return None };
        let shown = run.ahead.pop_front().unwrap_or(NONE);
        run.tip = tip;
        run.ahead.extend(more);
        let others = self.found.others[reading].iter().copied();
        let others = others.zip(held).map(|(other, (ahead, tip))| (other, HeldRun { ahead: ahead.into(), tip }));
        let mut runs: Vec<_> = others.chain([(reading, run)]).collect();
        runs.sort_by_key(|(reading, _)| *reading);
        let (next, is_new) = self.behaviour((reading, shown), &runs, Some((number, reading)));
        is_new.then_some(Open { number: next, state, runs })
    }

    /// The behaviour that shows this now after a reading, and that while those are held that may follow; whether it is new.
    fn behaviour(
        &mut self,
        (reading, shown): (usize, OutputClass),
        runs: &[(usize, HeldRun<M::State>)],
        came: Option<(Number, usize)>,
    ) -> (Number, bool) {
        let now = [self.found.coming(reading).0, shown].into_iter();
        let ahead = now.chain(runs.iter().flat_map(|(_, run)| run.ahead.iter().copied()));
        let key =
            ahead.fold(Sha256::new(), |digest, number| digest.chain_update(number.to_le_bytes())).finalize().into();
        if let Some(known) = self.known.get(&key).copied() {
            if let Some((before, reading)) = came {
                self.found.follow(before, reading, known);
            }
            return (known, false);
        }
        let number = self.found.add(shown, came);
        self.known.insert(key, number);
        (number, true)
    }
}

#[cfg(test)]
#[path = "behaviours_tests.rs"]
mod tests;
