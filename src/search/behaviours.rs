//! Few behaviours in place of many histories.
//!
//! A machine is stepped with one of a few *readings* at a time. States of it that show the same now, and the same after each of some
//! steps while any one reading is held, are taken for one: a *behaviour*. How often readings changed before does not matter then, nor
//! when: where only so many behaviours turn up, they are all there ever are, and a history of any length is a way through them.
//!
//! That states which are taken for one answer any readings alike, and not only held ones, is an assumption. It holds where everything
//! that the machine remembers shows while one reading is held for so long: timers run out and ramps end. It does not where it counts or
//! looks at a clock. [`walks`] tries that out.

pub mod stays;
pub mod walks;

use std::collections::{BTreeMap, VecDeque};
use std::ops::ControlFlow;

use sha2::{Digest as _, Sha256};

/// A machine whose states can be come back to.
pub trait Machine {
    /// A state.
    type State;
    /// What a state shows: equal for states that show the same.
    type Shown: Clone + Ord;
    /// What makes all of it pointless.
    type Error;

    /// How many readings there are.
    fn readings(&self) -> usize;

    /// Whether two things that are shown may be the same, but for what rounding does.
    fn alike(&self, one: &Self::Shown, other: &Self::Shown) -> bool;

    /// The state at the start, and what it shows.
    ///
    /// # Errors
    /// When it cannot be begun.
    fn begin(&mut self) -> Result<(Self::State, Self::Shown), Self::Error>;

    /// Holds a reading for some steps: what is shown after each, and the state after the last. Nothing where they could not be finished.
    ///
    /// # Errors
    /// When the machine cannot go on at all.
    fn hold(&mut self, state: &Self::State, reading: usize, steps: usize) -> Result<Held<Self>, Self::Error>;
}

/// What is shown after each step, and the state after the last.
pub type Held<M> = Option<(Vec<<M as Machine>::Shown>, <M as Machine>::State)>;

/// How far is looked.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Extent {
    /// For so many steps a reading is held before states are taken for one.
    pub held: usize,
    /// So many steps from the start at most.
    pub steps: usize,
    /// So many behaviours at most.
    pub most: usize,
}

/// Why no more behaviours were looked for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Ended {
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
pub struct Behaviours<S> {
    readings: usize,
    /// What each behaviour shows.
    shows: Vec<u32>,
    shown: Vec<S>,
    /// The fewest steps that lead to it, and the last of them: from which one, and the reading.
    depth: Vec<u32>,
    came: Vec<(Number, u32)>,
    /// By behaviour and reading, the one after a step.
    next: Vec<Number>,
    /// Successors that were a behaviour which was known.
    pub merged: u64,
    /// Why it ended.
    pub ended: Ended,
}

impl<S> Behaviours<S> {
    /// How many there are.
    #[must_use]
    pub const fn len(&self) -> usize {
        self.shows.len()
    }

    /// Whether there is none.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.shows.is_empty()
    }

    /// What one shows.
    #[must_use]
    pub fn shown(&self, number: Number) -> &S {
        &self.shown[self.shows[number as usize] as usize]
    }

    /// The one after a step with a reading; nothing where that was not looked at.
    #[must_use]
    pub fn next(&self, number: Number, reading: usize) -> Option<Number> {
        Some(self.next[number as usize * self.readings + reading]).filter(|next| *next != NONE)
    }

    /// How many readings there are.
    #[must_use]
    pub const fn readings(&self) -> usize {
        self.readings
    }

    /// The fewest steps that lead to one.
    #[must_use]
    pub fn depth(&self, number: Number) -> usize {
        self.depth[number as usize] as usize
    }

    /// Readings that lead to one from the start, in as few steps as any.
    #[must_use]
    pub fn way_to(&self, mut number: Number) -> Vec<usize> {
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
struct Run<S> {
    ahead: VecDeque<u32>,
    tip: S,
}

/// The behaviour after a step, and how it goes on, if it is new; nothing where that could not be finished.
type Next<S> = Option<(Number, Option<(S, Vec<Run<S>>)>)>;

/// A behaviour whose successors are to be found.
struct Open<S> {
    number: Number,
    state: S,
    /// By reading.
    runs: Vec<Run<S>>,
}

/// What is shown while each reading is held; nothing where steps could not be finished.
type Runs<S> = Option<Vec<Run<S>>>;

/// Finds all behaviours.
///
/// # Errors
/// What the machine reports.
pub fn find<M: Machine>(
    machine: &mut M,
    extent: Extent,
    tell: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Result<Behaviours<M::Shown>, M::Error> {
    let mut search = Search::new(machine, extent);
    let ended = search.run(tell)?;
    Ok(Behaviours { ended, ..search.found })
}

struct Search<'a, M: Machine> {
    machine: &'a mut M,
    extent: Extent,
    found: Behaviours<M::Shown>,
    /// Numbers of what is shown.
    numbers: BTreeMap<M::Shown, u32>,
    /// Behaviours by what tells them from others, in short.
    known: BTreeMap<[u8; 32], Number>,
}

impl<'a, M: Machine> Search<'a, M> {
    fn new(machine: &'a mut M, extent: Extent) -> Self {
        let found = Behaviours {
            readings: machine.readings(),
            shows: Vec::new(),
            shown: Vec::new(),
            depth: Vec::new(),
            came: Vec::new(),
            next: Vec::new(),
            merged: 0,
            ended: Ended::Closed,
        };
        Self { machine, extent, found, numbers: BTreeMap::new(), known: BTreeMap::new() }
    }

    fn run(&mut self, tell: &mut dyn FnMut(usize) -> ControlFlow<()>) -> Result<Ended, M::Error> {
        let (state, shown) = self.machine.begin()?;
        let shown = self.number(shown);
        let Some(runs) = self.runs(&state, None)? else { return Ok(Ended::Unfinished) };
        let (first, _) = self.behaviour(shown, &runs, None);
        let mut open = VecDeque::from([Open { number: first, state, runs }]);
        while let Some(Open { number, state, runs }) = open.pop_front() {
            if self.found.depth(number) == self.extent.steps {
                return Ok(Ended::Steps);
            }
            for (reading, run) in runs.into_iter().enumerate() {
                if tell(self.found.len()).is_break() {
                    return Ok(Ended::Asked);
                }
                let Some((next, is_new)) = self.step((number, &state), reading, run)? else {
                    return Ok(Ended::Unfinished);
                };
                match is_new {
                    Some((state, runs)) => open.push_back(Open { number: next, state, runs }),
                    None => self.found.merged += 1,
                }
                if self.found.len() > self.extent.most {
                    return Ok(Ended::Most);
                }
            }
        }
        Ok(Ended::Closed)
    }

    /// The behaviour after a step with a reading, of which `run` tells what is shown while it is held; and how it goes on, if it is new.
    fn step(
        &mut self,
        (number, state): (Number, &M::State),
        reading: usize,
        mut run: Run<M::State>,
    ) -> Result<Next<M::State>, M::Error> {
        let Some((_, state)) = self.machine.hold(state, reading, 1)? else { return Ok(None) };
        let Some((more, tip)) = self.machine.hold(&run.tip, reading, 1)? else { return Ok(None) };
        let shown = run.ahead.pop_front().unwrap_or(NONE);
        run.tip = tip;
        for one in more {
            let one = self.number(one);
            run.ahead.push_back(one);
        }
        let Some(runs) = self.runs(&state, Some((reading, run)))? else { return Ok(None) };
        #[expect(clippy::cast_possible_truncation, reason = "a few readings")]
        let (next, is_new) = self.behaviour(shown, &runs, Some((number, reading as u32)));
        self.found.next[number as usize * self.found.readings + reading] = next;
        Ok(Some((next, is_new.then_some((state, runs)))))
    }

    /// What is shown while each reading is held from a state on; of one that is known already.
    fn runs(
        &mut self,
        state: &M::State,
        mut known: Option<(usize, Run<M::State>)>,
    ) -> Result<Runs<M::State>, M::Error> {
        let mut runs = Vec::with_capacity(self.found.readings);
        for reading in 0..self.found.readings {
            if let Some((_, run)) = known.take_if(|(own, _)| *own == reading) {
                runs.push(run);
                continue;
            }
            let Some((ahead, tip)) = self.machine.hold(state, reading, self.extent.held)? else { return Ok(None) };
            runs.push(Run { ahead: ahead.into_iter().map(|shown| self.number(shown)).collect(), tip });
        }
        Ok(Some(runs))
    }

    /// The behaviour that shows this now, and that while readings are held; whether it is new.
    #[expect(clippy::cast_possible_truncation, reason = "fewer than are allowed")]
    fn behaviour(&mut self, shown: u32, runs: &[Run<M::State>], came: Option<(Number, u32)>) -> (Number, bool) {
        let ahead = std::iter::once(shown).chain(runs.iter().flat_map(|run| run.ahead.iter().copied()));
        let key =
            ahead.fold(Sha256::new(), |digest, number| digest.chain_update(number.to_le_bytes())).finalize().into();
        let number = self.found.len() as Number;
        if let Some(known) = self.known.get(&key) {
            return (*known, false);
        }
        self.known.insert(key, number);
        let found = &mut self.found;
        found.shows.push(shown);
        found.depth.push(came.map_or(0, |(before, _)| found.depth[before as usize] + 1));
        found.came.push(came.unwrap_or((number, 0)));
        found.next.extend(std::iter::repeat_n(NONE, found.readings));
        (number, true)
    }

    /// The number of what is shown.
    #[expect(clippy::cast_possible_truncation, reason = "fewer than steps")]
    fn number(&mut self, shown: M::Shown) -> u32 {
        let next = self.found.shown.len() as u32;
        let number = *self.numbers.entry(shown.clone()).or_insert(next);
        if number == next {
            self.found.shown.push(shown);
        }
        number
    }
}

#[cfg(test)]
#[path = "behaviours_tests.rs"]
mod tests;
