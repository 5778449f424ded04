//! Whether what stands for all that a machine shows stands for a walk too, that is followed with the machine itself: how far apart the two
//! are at each step. Said of walks that were tried; of others it is a figure, and no bound.

use std::collections::BTreeMap;

use super::net::{FARTHEST, Measured};
use super::stays::{Stays, Transitions};
use super::{Begins, Behaviours, Hold, Number, OutputClass};

/// What stands for something may have lasted for so many steps less.
pub(super) const LATEST: usize = 4;

/// A step of that is as bad as so many widths.
const LATER: f32 = 1.5;

/// Readings follow others at any time.
struct Free(Vec<Vec<(usize, usize)>>);

impl Free {
    fn new(others: &[Vec<usize>]) -> Self {
        Self(others.iter().map(|others| others.iter().map(|other| (*other, 0)).collect()).collect())
    }
}

impl Transitions for Free {
    fn begins(&self) -> Vec<usize> {
        vec![0]
    }

    fn ways(&self) -> usize {
        self.0.len()
    }

    fn reading(&self, way: usize) -> usize {
        way
    }

    fn next(&self, way: usize) -> &[(usize, usize)] {
        &self.0[way]
    }

    fn is_unchanged(&self, _way: usize) -> bool {
        false
    }
}

/// What stands for all that a machine shows: by reading and what is shown, for how long the reading may have lasted.
pub struct Covers {
    pub(super) longest: BTreeMap<(usize, OutputClass), u32>,
    most: u32,
}

impl Covers {
    /// Of a net, with stays of so many steps at most.
    #[must_use]
    pub fn new(found: &Behaviours, most: u32) -> Self {
        let stays = Stays::find(found, &Free::new(found.others()), most);
        let mut longest: BTreeMap<(usize, OutputClass), u32> = BTreeMap::new();
        #[expect(clippy::cast_possible_truncation, reason = "fewer than are allowed")]
        for number in 0..found.count() as Number {
            for reading in 0..found.readings() {
                if let (Some(next), Some(stay)) = (found.next(number, reading), stays.of(number, reading)) {
                    let known = longest.entry((reading, found.shown(next))).or_default();
                    *known = (*known).max(stay.steps);
                }
            }
        }
        Self { longest, most }
    }

    /// What stands for a row after a step, with a reading that had lasted for so many steps before it.
    fn nearest<M: Measured>(
        &self,
        machine: &M,
        row: &[f64],
        reading: usize,
        lasted: usize,
    ) -> Option<(OutputClass, usize)> {
        let traits = machine.traits(row);
        let lasted = lasted.min(self.most as usize);
        let mut best: Option<(f32, OutputClass, usize)> = None;
        for late in 0..=LATEST {
            let lasts = |shown: OutputClass| {
                let longest = self.longest.get(&(reading, shown));
                longest.is_some_and(|longest| *longest as usize + late >= lasted)
            };
            let left = best.map_or(FARTHEST, |(least, ..)| least) - LATER * late as f32;
            for widths in [left.min(1.0), left].into_iter().filter(|widths| *widths > 0.0) {
                if let Some((shown, apart)) = machine.nearest(&traits, widths, &lasts) {
                    best = Some((apart + LATER * late as f32, shown, late));
                    break;
                }
            }
        }
        best.map(|(_, shown, late)| (shown, late))
    }
}

/// By how much what stands for something is off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Off {
    /// How fast it is by what stands for it, in the machine's own measures.
    pub fast: f64,
    /// By how much that is off, in the same.
    pub by: [f64; 2],
    /// It has lasted for so many steps less.
    pub late: usize,
}

/// How far what a machine shows on a walk is from what stands for it.
#[derive(Clone, Debug, PartialEq)]
pub enum Gap {
    /// No farther than so, in the machine's own measures, by how fast it is.
    Within(Vec<Off>),
    /// After so many steps, with so many changes of readings, nothing stands for it.
    Nothing {
        /// Steps.
        steps: usize,
        /// Changes.
        changes: usize,
    },
    /// A step could not be finished.
    Unfinished,
}

/// Walks from the start, through what stands for what is shown.
///
/// # Errors
/// What the machine reports.
pub fn gap<M: Measured>(machine: &mut M, covers: &Covers, readings: &[(usize, usize)]) -> Result<Gap, M::Error> {
    let (mut state, _) = machine.begin_rows()?;
    let (mut all, mut taken, columns) = (Vec::new(), 0, machine.columns());
    // As long as the same is reported, or what is taken for it.
    let (mut lasted, mut before) = (0, None);
    for (changes, (reading, steps)) in readings.iter().enumerate() {
        let hold = Hold { from: Begins::At(&state), reading: *reading, steps: *steps, last: false };
        let Some((rows, after)) = machine.rows_each(&[hold])?.and_then(|mut all| all.pop()) else {
            return Ok(Gap::Unfinished);
        };
        let of = machine.taken_for(*reading);
        for row in rows.chunks(columns) {
            lasted = if before == Some(of) { lasted + 1 } else { 0 };
            before = Some(of);
            taken += 1;
            let nearest = covers.nearest(machine, row, of, lasted);
            let off = nearest.and_then(|(shown, late)| Some((machine.off(row, shown)?, late)));
            let Some(off) = off.map(|((fast, by), late)| Off { fast, by, late }) else {
                return Ok(Gap::Nothing { steps: taken, changes });
            };
            all.push(off);
        }
        state = after;
    }
    Ok(Gap::Within(all))
}
