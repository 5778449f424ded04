//! Plan and verify: imagine many sequences from what was observed so far, run the one that promises most, learn from it.
//!
//! The first episode takes the calm action throughout. From then on the environment can say without any simulation
//! where a sequence *would* meet an unsafe state, if the rest of the world moved as it was seen to move before
//! ([`SurrogateModel`]). What was imagined counts for nothing until the real simulation has shown it; and a refuted guess is an
//! observation too, so the next guess is better.

use std::collections::BTreeMap;

use super::episode::{Episode, EpisodeTree, random_sequence};
use super::{End, Environment, Iteration, Rng, Strategy};

/// Most sequences imagined for one that is run, as long as no unsafe state was met.
pub(crate) const IMAGINED_BEFORE: usize = 400;

/// The same from then on: kinds of endings not promised yet become rare, and imagining is cheap but not free.
pub(crate) const IMAGINED_AFTER: usize = 12;

/// What imagining may cost for one sequence that is run, in units of what running costs: [`SurrogateModel::imagine`] says nothing more then. In
/// the example cells it is not reached, at most half of it; with links of thousands of corners a few hundred sequences took minutes.
pub(crate) const ROLLOUT_BUDGET: u64 = 400_000;

/// What kind of ending an unsafe state is. Opaque to a search: equal numbers are the same kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub struct EndingKind(pub [i64; 5]);

/// An unsafe state that was imagined.
#[derive(Clone, Debug, PartialEq)]
pub struct PredictedHazard {
    /// The actions until there.
    pub actions: Vec<usize>,
    /// What kind of ending that would be.
    pub niche: EndingKind,
}

/// What an imagined sequence leads to.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Rollout {
    /// Unsafe states that the sequence meets, or would meet if one of its actions were a related one.
    pub visions: Vec<PredictedHazard>,
    /// Whether everything on the way was observed before, so that nothing could be learnt about it.
    pub exact: bool,
}

/// An environment that can imagine what a sequence would lead to.
pub trait SurrogateModel: Environment {
    /// The action that disturbs the least.
    fn calm(&self) -> usize;

    /// From now on imagining may cost so much, whatever was imagined before. What is told does not depend on earlier runs, so neither may
    /// what this counts.
    fn begin_imagining(&mut self, budget: u64);

    /// What a sequence from the start would lead to, from outputs observed since the strategy began and nothing else.
    /// Nothing is simulated. Nothing more is told, and nothing is exact, once it costs more than it may.
    fn imagine(&mut self, actions: &[usize]) -> Rollout;

    /// Whether it has cost more than it may.
    fn is_over_budget(&self) -> bool;
}

/// Which sequences to verify.
#[derive(Clone, Debug, Default)]
pub(crate) struct Planner {
    started: bool,
    /// An unsafe state was met.
    met: bool,
    /// How often a kind of ending was promised by a sequence that was then run.
    promised: BTreeMap<EndingKind, u32>,
}

/// A sequence to run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Proposal {
    /// It promises a kind of ending that was promised so many times before.
    Promising(Vec<usize>, u32),
    /// It promises nothing, but not everything about it is known.
    Unknown(Vec<usize>),
    /// Nothing better was found.
    Any(Vec<usize>),
}

impl Proposal {
    /// The sequence.
    #[must_use]
    pub(crate) fn actions(&self) -> &[usize] {
        match self {
            Self::Promising(actions, _) | Self::Unknown(actions) | Self::Any(actions) => actions,
        }
    }
}

impl Planner {
    /// Takes in an episode.
    pub(crate) fn observe(&mut self, episode: &Episode) {
        self.met |= episode.iteration.end == End::Unsafe;
    }

    /// Imagines random sequences until one promises what none promised before, or there were enough, or they cost more than
    /// [`ROLLOUT_BUDGET`]; then the one whose promise was made least often. No sequence that was run is proposed again.
    pub(crate) fn propose<E: SurrogateModel>(
        &mut self,
        environment: &mut E,
        trodden: &EpisodeTree<E::Snapshot>,
        rng: &mut Rng,
    ) -> Proposal {
        if !self.started {
            self.started = true;
            return Proposal::Unknown(vec![environment.calm(); environment.horizon()]);
        }
        let mut best: Option<(u32, Vec<usize>, EndingKind)> = None;
        let (mut unknown, mut any) = (None, Vec::new());
        environment.begin_imagining(ROLLOUT_BUDGET);
        for _ in 0..if self.met { IMAGINED_AFTER } else { IMAGINED_BEFORE } {
            let sequence = random_sequence(environment, rng);
            let imagined = environment.imagine(&sequence);
            for vision in imagined.visions {
                let times = self.promised.get(&vision.niche).copied().unwrap_or(0);
                if best.as_ref().is_some_and(|(least, _, _)| *least <= times) {
                    continue;
                }
                let mut actions = sequence.clone();
                actions[..vision.actions.len()].copy_from_slice(&vision.actions);
                if !trodden.is_known(&actions) {
                    best = Some((times, actions, vision.niche));
                }
            }
            if best.as_ref().is_some_and(|(times, _, _)| *times == 0) {
                break;
            }
            if unknown.is_none() && !imagined.exact && !trodden.is_known(&sequence) {
                unknown = Some(sequence.clone());
            }
            any = sequence;
            if environment.is_over_budget() {
                break;
            }
        }
        match (best, unknown) {
            (Some((times, actions, niche)), _) => {
                *self.promised.entry(niche).or_insert(0) += 1;
                Proposal::Promising(actions, times)
            }
            (None, Some(actions)) => Proposal::Unknown(actions),
            (None, None) => Proposal::Any(any),
        }
    }
}

/// The strategy.
#[derive(Clone, Debug)]
pub struct Plan<S> {
    planner: Planner,
    trodden: EpisodeTree<S>,
}

impl<S> Default for Plan<S> {
    fn default() -> Self {
        Self { planner: Planner::default(), trodden: EpisodeTree::default() }
    }
}

impl<E: SurrogateModel> Strategy<E> for Plan<E::Snapshot> {
    fn name(&self) -> &'static str {
        "plan"
    }

    fn iterate(&mut self, environment: &mut E, rng: &mut Rng) -> Result<Iteration, E::Error> {
        let proposal = self.planner.propose(environment, &self.trodden, rng);
        let episode = self.trodden.follow(environment, proposal.actions(), rng)?;
        self.planner.observe(&episode);
        Ok(episode.iteration)
    }
}

#[cfg(test)]
#[path = "plan_tests.rs"]
pub(super) mod tests;
