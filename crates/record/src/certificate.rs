//! What every sequence of a search came to, and what random sequences say about the rest.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::obligations::Obligations;

/// What an exhaustive search covered, and what random search can expect from that. Numbers of sequences are decimal
/// strings: they do not fit into JSON's numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Certificate {
    /// Whether every sequence is accounted for, and nothing is open that this needs.
    pub complete: bool,
    /// Why that is not so: the obligations that are open, in words.
    pub reasons: Vec<String>,
    /// All sequences: actions to the power of the horizon.
    pub sequences: String,
    /// Those whose fate is known: hazardous, harmless or excluded.
    pub covered: String,
    /// Met an unsafe state.
    pub hazardous: String,
    /// Reached the horizon without.
    pub harmless: String,
    /// Cannot meet one: too far away for the time that is left, by lengths and speeds.
    pub excluded: String,
    /// The FMU could not finish them.
    pub not_evaluated: String,
    /// Part of all sequences that is known to be hazardous.
    pub hazardous_share: f64,
    /// Distinct states.
    pub states: usize,
    /// Distinct states by number of actions before them, and how many of these were dropped as excluded.
    pub levels: Vec<[usize; 2]>,
    /// All sequences of so many actions were looked at.
    pub complete_for_actions: usize,
    /// Actions of the FMU that differ in its state or inputs.
    pub fmu_transitions: usize,
    /// Different questions whether a person can be touched.
    pub questions: u64,
    /// How equal states of the FMU were told.
    pub merged_by: String,
    /// Histories that led to a state of the FMU known already, by its bytes.
    pub merged: u64,
    /// Of these, tried out by stepping both states on.
    pub merges_tried_out: u64,
    /// What of the FMU was run again plainly, to show that nothing rests on a state that was brought back wrongly.
    pub run_again: RunAgain,
    /// Actions to choose from.
    pub actions: usize,
    /// Actions in a sequence.
    pub horizon: usize,
    /// What random search can expect, if the search was complete.
    pub random_search: Option<RandomSearch>,
}

impl Certificate {
    /// Once it is known what it rests on.
    pub fn close(&mut self, obligations: &Obligations) {
        self.reasons = obligations.reasons();
        self.complete = obligations.clean().is_some();
        if !self.complete {
            self.random_search = None;
        }
    }
}

/// How much of what an FMU did in a search was run again from the start, by a fresh instance with all inputs and without
/// any restore, and gave the same in all bound outputs, bit for bit. Where it is not all, it is a sample, chosen by a key
/// made from the inputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RunAgain {
    /// Actions of the FMU that were stepped.
    pub transitions: u64,
    /// Of these, run again.
    pub compared: u64,
    /// Histories that were merged with another one, which went on.
    pub merges: u64,
    /// Of these, run on from the start with the other one's inputs.
    pub merges_compared: u64,
}

/// Exact figures of uniform random search, from the share of hazardous sequences.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RandomSearch {
    /// Budget, iterations.
    pub iterations: u32,
    /// Mean iterations to the first hazard, however many it takes: one over the share of hazardous sequences.
    pub iterations_to_hazard: Option<f64>,
    /// The same cut at the budget, a miss counting as the budget: what the paper's tables call T.
    pub mean_iterations: f64,
    /// Standard deviation of that.
    pub sigma: f64,
    /// Probability to find nothing.
    pub miss_probability: f64,
}

/// What the uniformly random sequences of a search say about what is left, each figure with 95 % confidence. Sequences
/// that a strategy chose are never counted.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Residual {
    /// What the figures hold for.
    pub holds_for: String,
    /// Uniformly random sequences.
    pub random_sequences: u64,
    /// Of these, hazardous by their own end; findings in other postures of their walks do not count.
    pub hazardous: u64,
    /// Of these, not evaluated, because the FMU could not finish them; upper bounds count them as the worse.
    pub not_evaluated: u64,
    /// Clopper-Pearson interval, two-sided, of the share of all sequences that is hazardous: what an exhaustive search
    /// gives as `hazardous / sequences`.
    pub hazardous_share_interval: [f64; 2],
    /// Upper bound, one-sided, of the same share.
    pub hazardous_share_below: f64,
    /// About hazards that are not listed; none if no hazard is, as the share above is then the answer.
    pub unlisted: Option<Unlisted>,
}

/// How often a random sequence ends in a hazard that is not listed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Unlisted {
    /// Random sequences after the first quarter of the search, each checked against the hazards known by then.
    pub checked: u64,
    /// Of these, ended in a hazard not known then, or not evaluated.
    pub met_others: u64,
    /// Upper bound, one-sided, of the probability that one more random sequence ends in a hazard that is not listed.
    pub probability_below: f64,
    /// Good-Turing estimate, no bound, from the random sequences alone: the probability that one more ends in a hazard
    /// that none of them ended in.
    pub good_turing_estimate: f64,
}

impl Residual {
    /// What figures are about.
    pub const HOLDS_FOR: &'static str = "uniformly random sequences of these actions, horizon and start in this model; \
                                         not how likely a person is hurt";
}
