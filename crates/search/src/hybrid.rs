//! Planning, and every fifth sequence random.
//!
//! Planning finds most with least, but what it runs depends on what it saw, so no statistics of random sampling hold for
//! it. Every fifth sequence is drawn uniformly at random, whatever the others found: for these such statistics hold, and
//! they see what planning has no reason to look for. Planning learns from all of them.

use super::episode::{EpisodeTree, random_sequence};
use super::plan::{Planner, SurrogateModel};
use super::{Iteration, Rng, Strategy};

/// One sequence of so many is random.
const RANDOM_EVERY: usize = 5;

/// The strategy.
#[derive(Clone, Debug)]
pub struct Hybrid<S> {
    iterations: usize,
    planner: Planner,
    trodden: EpisodeTree<S>,
}

impl<S> Default for Hybrid<S> {
    fn default() -> Self {
        Self { iterations: 0, planner: Planner::default(), trodden: EpisodeTree::default() }
    }
}

impl<E: SurrogateModel> Strategy<E> for Hybrid<E::Snapshot> {
    fn name(&self) -> &'static str {
        "hybrid"
    }

    fn iterate(&mut self, environment: &mut E, rng: &mut Rng) -> Result<Iteration, E::Error> {
        self.iterations += 1;
        let random = self.iterations.is_multiple_of(RANDOM_EVERY);
        let actions = if random {
            random_sequence(environment, rng)
        } else {
            self.planner.propose(environment, &self.trodden, rng).actions().to_vec()
        };
        let episode = self.trodden.follow(environment, &actions, rng)?;
        self.planner.observe(&episode);
        Ok(Iteration { random, ..episode.iteration })
    }
}

#[cfg(test)]
#[path = "hybrid_tests.rs"]
mod tests;
