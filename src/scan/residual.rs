//! What the random sequences of a search met, for the figures of [`crate::search::residual`].

use crate::hazard::{Finding, Groups, Identity};
use crate::record::certificate::{Residual, Unlisted};
use crate::search::residual::{Figures, RandomSample, SampleEnd};
use crate::search::{End, Iteration};

/// Follows a search with a fixed number of iterations. After a quarter of them, random sequences are checked against
/// the hazards known by then: what is not known by then is rare, and three quarters bound it well.
#[derive(Clone, Debug)]
pub struct Watch {
    sample: RandomSample<Identity>,
    quarter: u32,
    done: u32,
}

impl Watch {
    /// Of a search of so many iterations.
    #[must_use]
    pub fn new(iterations: u32) -> Self {
        Self { sample: RandomSample::default(), quarter: iterations / 4, done: 0 }
    }

    /// Takes in an iteration and the findings that came with it; `groups` is what was known before it.
    ///
    /// A sequence counts by its own end alone. What the other postures of its walks met is in the list but is no sample:
    /// these are other sequences, and where a beginning is restored instead of simulated they are not met again.
    pub fn after(&mut self, iteration: &Iteration, findings: &[Finding], groups: &Groups, links: &[String]) {
        if self.done == self.quarter {
            self.sample.check_against(groups.identities().cloned().collect());
        }
        self.done += 1;
        if !iteration.random {
            return;
        }
        // The contact that ends a sequence comes last, after those of the other postures; of two people who are hit at once, both.
        let own = findings.last();
        let at_once =
            |finding: &&Finding| own.is_some_and(|own| (&own.actions, own.step) == (&finding.actions, finding.step));
        let ends = findings.iter().rev().filter(at_once).filter(|finding| finding.class.ends());
        let is_new = |finding: &&Finding| !groups.has(&Identity::of(finding, links));
        let own = ends.clone().find(is_new).or(own);
        self.sample.observe(match (iteration.end, own) {
            (End::Unsafe, Some(own)) => SampleEnd::Group(Identity::of(own, links)),
            (End::Unsafe, None) | (End::NotEvaluated, _) => SampleEnd::Unknown,
            (End::Horizon, _) => SampleEnd::Nothing,
        });
    }

    /// The figures; none without a random sequence.
    #[must_use]
    pub fn figures(&self) -> Option<Figures> {
        self.sample.figures()
    }
}

/// The record of figures; `listed`: whether any hazard was found.
#[must_use]
pub fn record(f: &Figures, listed: bool) -> Residual {
    let unlisted = Unlisted {
        checked: f.checked,
        met_others: f.unlisted,
        probability_below: f.unlisted_below,
        good_turing_estimate: f.good_turing,
    };
    Residual {
        holds_for: Residual::HOLDS_FOR.to_owned(),
        random_sequences: f.sequences,
        hazardous: f.hazardous,
        not_evaluated: f.not_evaluated,
        hazardous_share_interval: [f.share.low, f.share.high],
        hazardous_share_below: f.share_below,
        unlisted: listed.then_some(unlisted),
    }
}
