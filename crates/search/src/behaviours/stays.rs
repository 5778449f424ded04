//! For how long somebody may have been where, while a machine shows each of its behaviours.
//!
//! Readings change as something moves: [`Transitions`] say which reading may follow which, after how many steps at least. Of each
//! behaviour and way the longest stay is looked for: who stayed longest may be wherever who stayed less long may. Stays are counted up to
//! a limit, from which on longer ones tell nothing more. How each came about is kept, so that there is a history to show for it.

use std::collections::VecDeque;

use super::{Behaviours, Number};
use crate::tracks::Lasting;

/// The ways to come to readings.
pub trait Transitions {
    /// How a run begins: by its number, the ways to come to readings at the very start.
    fn begins(&self) -> Vec<usize>;

    /// How many ways there are.
    fn ways(&self) -> usize;

    /// The reading that a way leads to.
    fn reading(&self, way: usize) -> usize;

    /// Other ways that may follow, and for how many steps the reading has lasted at least, where 0 is for its first instant.
    fn next(&self, way: usize) -> &[(usize, usize)];

    /// Whether no reading ever changed on it.
    fn is_unchanged(&self, way: usize) -> bool;
}

/// Longest stays, by behaviour and way.
#[derive(Clone, Debug)]
pub struct Stays {
    ways: usize,
    /// Number of the last of `all` that is of a behaviour and way.
    last: Vec<u32>,
    all: Vec<Come>,
}

/// The most that there is of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stay {
    /// Steps since the reading began, 0 for the first instant.
    pub steps: u32,
    /// Steps since the reading first changed, 0 for the first instant after that, and where it never did.
    pub since_first: u32,
}

/// Somebody came to where a behaviour is shown, on a way, and has stayed longer than was known.
#[derive(Clone, Copy, Debug)]
struct Come {
    way: u32,
    stay: Stay,
    /// From which of these by a step, if from any; and the one of the same behaviour and way before.
    from: u32,
    before: u32,
}

/// None of them.
const NONE: u32 = u32::MAX;

impl Stay {
    /// As tracks have it.
    #[must_use]
    pub const fn lasting(self, is_unchanged: bool) -> Lasting {
        Lasting { steps: self.steps as usize, changes: !is_unchanged as usize, since_first: self.since_first as usize }
    }
}

impl Stays {
    /// Of all behaviours that are known with what follows them, and stays of at most so many steps.
    #[must_use]
    pub fn find(of: &Behaviours, ways: &dyn Transitions, most: u32) -> Self {
        let mut this = Self { ways: ways.ways(), last: vec![NONE; of.count() * ways.ways()], all: Vec::new() };
        let mut open = VecDeque::new();
        for way in ways.begins() {
            this.come((0, way), Stay { steps: 0, since_first: 0 }, NONE, &mut open);
        }
        while let Some((number, way)) = open.pop_front() {
            let from = this.last[number as usize * this.ways + way];
            let stay = this.all[from as usize].stay;
            let Some(next) = of.next(number, ways.reading(way)) else { continue };
            let longer = |steps: u32| (steps + 1).min(most);
            let since_first = if ways.is_unchanged(way) { 0 } else { longer(stay.since_first) };
            this.come((next, way), Stay { steps: longer(stay.steps), since_first }, from, &mut open);
            for (other, least) in ways.next(way) {
                if *least <= stay.steps as usize || stay.steps == most {
                    this.come((next, *other), Stay { steps: 0, since_first }, from, &mut open);
                }
            }
        }
        this
    }

    /// Somebody may have stayed so long.
    #[expect(clippy::cast_possible_truncation, reason = "as many as memory holds")]
    fn come(&mut self, (number, way): (Number, usize), stay: Stay, from: u32, open: &mut VecDeque<(Number, usize)>) {
        let before = self.last[number as usize * self.ways + way];
        let known = self.all.get(before as usize).map(|come| come.stay);
        let longest = known.map_or(stay, |known| Stay {
            steps: known.steps.max(stay.steps),
            since_first: known.since_first.max(stay.since_first),
        });
        if known != Some(longest) {
            self.last[number as usize * self.ways + way] = self.all.len() as u32;
            self.all.push(Come { way: way as u32, stay: longest, from, before });
            open.push_back((number, way));
        }
    }

    /// The longest stay on a way to where a behaviour is shown; nothing where nobody can be then.
    #[must_use]
    pub fn of(&self, number: Number, way: usize) -> Option<Stay> {
        self.all.get(self.last[number as usize * self.ways + way] as usize).map(|come| come.stay)
    }

    /// A history that leads to a behaviour on a way, with a stay of so many steps at least if there is one: ways, one after the other, with
    /// the steps that are taken on each.
    #[must_use]
    pub fn history(&self, number: Number, way: usize, steps: usize) -> Vec<(usize, usize)> {
        let mut come = self.last[number as usize * self.ways + way];
        // The first that is long enough takes the fewest steps.
        while let Some(Come { before, .. }) = self.all.get(come as usize)
            && self.all.get(*before as usize).is_some_and(|before| before.stay.steps as usize >= steps)
        {
            come = *before;
        }
        let mut history: Vec<(usize, usize)> = Vec::new();
        while let Some(Come { way, from, .. }) = self.all.get(come as usize) {
            match history.last_mut() {
                // A reading that is come to anew has no step before.
                Some((last, steps)) if *last == *way as usize => *steps += 1,
                _ => history.push((*way as usize, 1)),
            }
            come = *from;
        }
        history.reverse();
        history
    }
}
