//! Few behaviours in place of many histories.
//!
//! A machine is stepped with one of a few *readings* at a time. States of it that show the same now, and the same after each of some
//! steps while any one reading is held, are taken for one: a *behaviour*. How often readings changed before does not matter then, nor
//! when: where only so many behaviours turn up, they are all there ever are, and a history of any length is a way through them.
//!
//! That states which are taken for one answer any readings alike, and not only held ones, is an assumption. It holds where everything
//! that the machine remembers shows while one reading is held for so long: timers run out and ramps end. It does not where it counts or
//! looks at a clock. [`walks`] tries that out.

pub mod decided;
pub mod net;
pub mod shows;
pub mod stays;
pub mod walks;

use std::collections::{BTreeMap, VecDeque};
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

    /// Whether two things that are shown may be the same, but for what rounding does.
    fn alike(&self, one: Shown, other: Shown) -> bool;
    /// Whether something that is shown is what may be shown in place of the middle one of three that follow one another, where rounding
    /// decides in which of two steps something switches.
    fn switches(&self, one: Shown, among: [Shown; 3]) -> bool;

    /// The state at the start, and what it shows.
    ///
    /// # Errors
    /// When it cannot be begun.
    fn begin(&mut self) -> Result<(Self::State, Shown), Self::Error>;

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
pub type Shown = u32;

/// What is shown after each step, and the state after the last.
pub type Held<S> = (Vec<Shown>, S);

/// The same of several holds; nothing where some could not be finished.
pub type AllHeld<S> = Option<Vec<Held<S>>>;

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
pub struct Behaviours {
    readings: usize,
    /// What each behaviour shows.
    shows: Vec<Shown>,
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

impl Behaviours {
    /// None yet.
    fn none(readings: usize) -> Self {
        let (shows, depth, came, next) = Default::default();
        Self { readings, shows, depth, came, next, merged: 0, ended: Ended::Closed }
    }

    /// Another, which was come to from one by a step with a reading.
    #[expect(clippy::cast_possible_truncation, reason = "fewer than are allowed")]
    fn add(&mut self, shown: Shown, came: Option<(Number, usize)>) -> Number {
        let number = self.len() as Number;
        self.shows.push(shown);
        self.depth.push(came.map_or(0, |(before, _)| self.depth[before as usize] + 1));
        self.came.push(came.map_or((number, 0), |(before, reading)| (before, reading as u32)));
        self.next.extend(std::iter::repeat_n(NONE, self.readings));
        if let Some((before, reading)) = came {
            self.follow(before, reading, number);
        }
        number
    }

    /// One is followed by another after a step with a reading.
    fn follow(&mut self, number: Number, reading: usize, next: Number) {
        self.next[number as usize * self.readings + reading] = next;
    }

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
    pub fn shown(&self, number: Number) -> Shown {
        self.shows[number as usize]
    }

    /// The one after a step with a reading; nothing where that was not looked at.
    #[must_use]
    pub fn next(&self, number: Number, reading: usize) -> Option<Number> {
        Some(self.next[number as usize * self.readings + reading]).filter(|next| *next != NONE)
    }

    /// The one before, on a way that leads to one in as few steps as any; nothing at the start.
    #[must_use]
    pub fn before(&self, number: Number) -> Option<Number> {
        (self.depth(number) > 0).then(|| self.came[number as usize].0)
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
    ahead: VecDeque<Shown>,
    tip: S,
}

/// A behaviour whose successors are to be found.
struct Open<S> {
    number: Number,
    state: S,
    /// By reading.
    runs: Vec<Run<S>>,
}

/// So many behaviours are gone on from at once.
const AT_ONCE: usize = 48;

/// Finds all behaviours.
///
/// # Errors
/// What the machine reports.
pub fn find<M: Machine>(
    machine: &mut M,
    extent: Extent,
    tell: &mut dyn FnMut(usize) -> ControlFlow<()>,
) -> Result<Behaviours, M::Error> {
    let mut search = Search::new(machine, extent);
    let ended = search.run(tell)?;
    Ok(Behaviours { ended, ..search.found })
}

struct Search<'a, M: Machine> {
    machine: &'a mut M,
    extent: Extent,
    found: Behaviours,
    /// Behaviours by what tells them from others, in short.
    known: BTreeMap<[u8; 32], Number>,
}

impl<'a, M: Machine> Search<'a, M> {
    fn new(machine: &'a mut M, extent: Extent) -> Self {
        let found = Behaviours::none(machine.readings());
        Self { machine, extent, found, known: BTreeMap::new() }
    }

    fn run(&mut self, tell: &mut dyn FnMut(usize) -> ControlFlow<()>) -> Result<Ended, M::Error> {
        let (state, shown) = self.machine.begin()?;
        let each: Vec<_> = (0..self.found.readings)
            .map(|reading| Hold { from: Begins::At(&state), reading, steps: self.extent.held, last: false })
            .collect();
        let Some(runs) = self.machine.hold_each(&each)? else { return Ok(Ended::Unfinished) };
        let runs = runs.into_iter().map(|(ahead, tip)| Run { ahead: ahead.into(), tip }).collect::<Vec<_>>();
        let (first, _) = self.behaviour(shown, &runs, None);
        let mut open = VecDeque::from([Open { number: first, state, runs }]);
        while !open.is_empty() {
            if tell(self.found.len()).is_break() {
                return Ok(Ended::Asked);
            }
            let some: Vec<Open<M::State>> = open.drain(..AT_ONCE.min(open.len())).collect();
            let Some(held) = self.machine.hold_each(&self.holds(&some))? else { return Ok(Ended::Unfinished) };
            let mut held = held.into_iter();
            for one in some {
                if self.found.depth(one.number) == self.extent.steps {
                    return Ok(Ended::Steps);
                }
                for (reading, run) in one.runs.into_iter().enumerate() {
                    let own = held.by_ref().take(1 + self.found.readings).collect();
                    match self.step(one.number, reading, run, own) {
                        Some(next) => open.push_back(next),
                        None => self.found.merged += 1,
                    }
                    if self.found.len() > self.extent.most {
                        return Ok(Ended::Most);
                    }
                }
            }
        }
        Ok(Ended::Closed)
    }

    /// What is asked of some behaviours: by reading, the state after a step with it; a step more while it is held; and all other readings
    /// held from that state on.
    fn holds<'b>(&self, some: &'b [Open<M::State>]) -> Vec<Hold<'b, M::State>> {
        let mut all = Vec::new();
        for one in some {
            for (reading, run) in one.runs.iter().enumerate() {
                let after = all.len();
                all.push(Hold { from: Begins::At(&one.state), reading, steps: 1, last: false });
                all.push(Hold { from: Begins::At(&run.tip), reading, steps: 1, last: false });
                let others = (0..self.found.readings).filter(|other| *other != reading);
                all.extend(others.map(|other| Hold {
                    from: Begins::After(after),
                    reading: other,
                    steps: self.extent.held,
                    last: false,
                }));
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
        mut run: Run<M::State>,
        held: Vec<Held<M::State>>,
    ) -> Option<Open<M::State>> {
        let mut held = held.into_iter();
        let (Some((_, state)), Some((more, tip))) = (held.next(), held.next()) else { return None };
        let shown = run.ahead.pop_front().unwrap_or(NONE);
        run.tip = tip;
        run.ahead.extend(more);
        let mut runs: Vec<Run<M::State>> = held.map(|(ahead, tip)| Run { ahead: ahead.into(), tip }).collect();
        runs.insert(reading.min(runs.len()), run);
        let (next, is_new) = self.behaviour(shown, &runs, Some((number, reading)));
        is_new.then_some(Open { number: next, state, runs })
    }

    /// The behaviour that shows this now, and that while readings are held; whether it is new.
    fn behaviour(&mut self, shown: Shown, runs: &[Run<M::State>], came: Option<(Number, usize)>) -> (Number, bool) {
        let ahead = std::iter::once(shown).chain(runs.iter().flat_map(|run| run.ahead.iter().copied()));
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
