//! What uniformly random sequences say about the hazards that are left: exact bounds, without looking at all sequences.
//!
//! Two questions, each answered with 95 % confidence, both for *one more uniformly random sequence* and nothing else:
//!
//! 1. How probable is it that it is hazardous? Its own end counts, so this is the share that an exhaustive search
//!    counts. Clopper and Pearson (1934), from all random sequences.
//! 2. How probable is it that it ends in a hazard that is not on the list? From some moment on that is fixed
//!    beforehand, random sequences are checked against the list as it stood then. They did not make that list, so the number that
//!    ended elsewhere is binomial, and the bound on its probability is exact however the list came about: whatever else
//!    a search tries, guided by what it met, may lengthen the list, but is never counted as a sample. A list that grows
//!    later only lowers the probability.
//!
//! Beside the second stands the estimate of Good (1953): groups that exactly one random sequence ended in, over the
//! number of sequences. It has next to no bias but is too low about as often as not, so it never stands alone. The
//! bound for it that holds for every distribution (McAllester and Schapire, COLT 2000) adds a term of the order of
//! `sqrt(ln(1/0.05) / n)`, 0.1 and more for 320 sequences, which says nothing at the size of these figures.
//!
//! The number of random sequences must be fixed beforehand: a search that stops because of what it met gives no figures.

use std::collections::{BTreeMap, BTreeSet};

use super::statistics::{Interval, binomial_upper, clopper_pearson};

/// One minus the confidence of one-sided bounds.
const ALPHA: f64 = 0.05;

/// What a random sequence ended in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum SampleEnd<G> {
    /// No unsafe state.
    Nothing,
    /// An unsafe state of this group.
    Group(G),
    /// The simulator could not finish it: bounds count it as the worse.
    Unknown,
}

/// What the random sequences of a search met. `G` tells groups of hazards apart.
#[derive(Clone, Debug)]
pub struct RandomSample<G> {
    sequences: u64,
    hazardous: u64,
    unknown: u64,
    times: BTreeMap<G, u64>,
    list: Option<BTreeSet<G>>,
    checked: u64,
    unlisted: u64,
}

impl<G> Default for RandomSample<G> {
    fn default() -> Self {
        Self { sequences: 0, hazardous: 0, unknown: 0, times: BTreeMap::new(), list: None, checked: 0, unlisted: 0 }
    }
}

/// What follows from a [`RandomSample`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Figures {
    /// Uniformly random sequences.
    pub sequences: u64,
    /// Of these, ended in an unsafe state.
    pub hazardous: u64,
    /// Of these, could not be evaluated.
    pub not_evaluated: u64,
    /// Two-sided interval of the probability that a sequence is hazardous.
    pub share: Interval,
    /// One-sided upper bound of the same.
    pub share_below: f64,
    /// Random sequences that were checked against the list.
    pub checked: u64,
    /// Of these, ended in a group that was not on it, or could not be evaluated.
    pub unlisted: u64,
    /// One-sided upper bound of the probability that a sequence ends in a group that is not on the list.
    pub unlisted_below: f64,
    /// Good's estimate of the probability that a sequence ends in a group that no random one ended in before.
    pub good_turing: f64,
}

impl<G: Ord> RandomSample<G> {
    /// From now on, random sequences are checked against this list.
    pub fn check_against(&mut self, list: BTreeSet<G>) {
        self.list = Some(list);
    }

    /// Takes in a random sequence.
    pub fn observe(&mut self, met: SampleEnd<G>) {
        self.sequences += 1;
        let unlisted = match (&met, &self.list) {
            (SampleEnd::Nothing, _) | (_, None) => false,
            (SampleEnd::Unknown, Some(_)) => true,
            (SampleEnd::Group(group), Some(list)) => !list.contains(group),
        };
        self.checked += u64::from(self.list.is_some());
        self.unlisted += u64::from(unlisted);
        match met {
            SampleEnd::Nothing => {}
            SampleEnd::Unknown => self.unknown += 1,
            SampleEnd::Group(group) => {
                self.hazardous += 1;
                *self.times.entry(group).or_default() += 1;
            }
        }
    }

    /// The figures; none without a sequence.
    #[must_use]
    pub fn figures(&self) -> Option<Figures> {
        if self.sequences == 0 {
            return None;
        }
        let worst = self.hazardous + self.unknown;
        let once = self.times.values().filter(|&&n| n == 1).count();
        Some(Figures {
            sequences: self.sequences,
            hazardous: self.hazardous,
            not_evaluated: self.unknown,
            share: Interval {
                low: clopper_pearson(self.hazardous, self.sequences).low,
                high: clopper_pearson(worst, self.sequences).high,
            },
            share_below: binomial_upper(worst, self.sequences, ALPHA),
            checked: self.checked,
            unlisted: self.unlisted,
            unlisted_below: binomial_upper(self.unlisted, self.checked, ALPHA),
            good_turing: once as f64 / self.sequences as f64,
        })
    }
}

#[cfg(test)]
#[path = "residual_tests.rs"]
mod tests;
