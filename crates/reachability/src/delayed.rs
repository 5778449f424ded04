//! What of readings is on its way to the FMU, by number: what the FMU is told step by step while a reading is held.

use std::collections::BTreeMap;

use foldhash::quality::FixedState;
use indexmap::IndexSet;

use crate::sim::sensors::DelayLine;

/// The number of what is on its way.
pub(crate) type Lines = u32;

/// A step with a reading.
#[derive(Clone, Debug)]
pub struct Step {
    /// What the FMU is told.
    pub row: Box<[f64]>,
    /// What is on its way after it.
    pub after: Lines,
    /// The number of what of that counts where readings are taken for one.
    pub counts: i64,
}

/// What may be on its way, and what becomes of it.
#[derive(Debug, Default)]
pub(crate) struct DelayedReadings {
    all: IndexSet<Box<[DelayLine]>, FixedState>,
    /// By what is on its way and the reading.
    steps: BTreeMap<(Lines, (usize, usize)), Step>,
}

/// What the FMU is told in some steps, and what is on its way after each of them that counts, and after the last.
#[derive(Clone, Debug)]
pub struct DelayedInputs {
    /// Row-major; the last row goes on to the end.
    pub inputs: Vec<f64>,
    /// By step.
    pub counts: Vec<i64>,
    /// After the last.
    pub lines: Lines,
}

impl DelayedReadings {
    /// The number of this.
    #[expect(clippy::cast_possible_truncation, reason = "a few hundred")]
    pub fn number(&mut self, lines: &[DelayLine]) -> Lines {
        let known = self.all.get_index_of(lines);
        known.unwrap_or_else(|| self.all.insert_full(lines.into()).0) as Lines
    }

    /// What there is under a number.
    #[must_use]
    pub(crate) fn lines(&self, number: Lines) -> &[DelayLine] {
        &self.all[number as usize]
    }

    /// What a reading is told as in so many steps, by what each step is that is not known yet.
    pub(crate) fn told(
        &mut self,
        mut lines: Lines,
        reading: (usize, usize),
        steps: usize,
        step: &mut dyn FnMut(&mut Self, Lines) -> Step,
    ) -> DelayedInputs {
        let (mut inputs, mut counts) = (Vec::new(), Vec::with_capacity(steps));
        while counts.len() < steps {
            let key = (lines, reading);
            if !self.steps.contains_key(&key) {
                let next = step(self, lines);
                self.steps.insert(key, next);
            }
            let next = &self.steps[&key];
            inputs.extend(&next.row);
            if next.after == lines {
                // It stays so.
                counts.resize(steps, next.counts);
                break;
            }
            counts.push(next.counts);
            lines = next.after;
        }
        DelayedInputs { inputs, counts, lines }
    }
}
