//! For how long somebody may have been where, while a machine shows each of its behaviours.
//!
//! Readings change as something moves: a [`Ways`]'s ways say which reading may follow which, after how many steps at least. Of each
//! behaviour and way the longest stay is looked for: who stayed longest may be wherever who stayed less long may. Stays are counted up to
//! a limit, from which on longer ones tell nothing more.

use std::collections::VecDeque;

use super::{Behaviours, Number};
use crate::search::tracks::Lasting;

/// The ways to come to readings.
pub trait Ways {
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
    all: Vec<Option<Stay>>,
}

/// The most that there is of each.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Stay {
    /// Steps since the reading began, 0 for the first instant.
    pub steps: u32,
    /// Steps since the reading first changed, 0 for the first instant after that, and where it never did.
    pub since_first: u32,
}

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
    pub fn find<S>(of: &Behaviours<S>, ways: &dyn Ways, most: u32) -> Self {
        let mut this = Self { ways: ways.ways(), all: vec![None; of.len() * ways.ways()] };
        let mut open = VecDeque::new();
        for way in ways.begins() {
            this.come(0, way, Stay { steps: 0, since_first: 0 }, &mut open);
        }
        while let Some((number, way)) = open.pop_front() {
            let Some(stay) = this.of(number, way) else { continue };
            let Some(next) = of.next(number, ways.reading(way)) else { continue };
            let longer = |steps: u32| (steps + 1).min(most);
            let since_first = if ways.is_unchanged(way) { 0 } else { longer(stay.since_first) };
            this.come(next, way, Stay { steps: longer(stay.steps), since_first }, &mut open);
            for (other, least) in ways.next(way) {
                if *least <= stay.steps as usize || stay.steps == most {
                    this.come(next, *other, Stay { steps: 0, since_first }, &mut open);
                }
            }
        }
        this
    }

    /// Somebody may have stayed so long.
    fn come(&mut self, number: Number, way: usize, stay: Stay, open: &mut VecDeque<(Number, usize)>) {
        let known = &mut self.all[number as usize * self.ways + way];
        let longest = known.map_or(stay, |known| Stay {
            steps: known.steps.max(stay.steps),
            since_first: known.since_first.max(stay.since_first),
        });
        if *known != Some(longest) {
            *known = Some(longest);
            open.push_back((number, way));
        }
    }

    /// The longest stay on a way to where a behaviour is shown; nothing where nobody can be then.
    #[must_use]
    pub fn of(&self, number: Number, way: usize) -> Option<Stay> {
        self.all[number as usize * self.ways + way]
    }
}
