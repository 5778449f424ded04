//! Plan, quality diversity and random episodes in turn.
//!
//! Planning is quick where the world moves on as it was seen to; the archive finds what depends on reactions that were
//! not seen yet; and every fifth episode is drawn uniformly at random, whatever the others found, so that statistics of
//! random sampling hold for these. All of them learn from all episodes.

use super::episode::{Trodden, random_sequence};
use super::plan::{Imagine, Planner, Proposal};
use super::quality_diversity::Archive;
use super::{Iteration, Rng, Strategy};

/// What an iteration does.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Turn {
    /// Plan; where nothing new is promised, vary an elite.
    Plan,
    Vary,
    Random,
}

/// The turns, over and over.
const TURNS: [Turn; 5] = [Turn::Plan, Turn::Plan, Turn::Vary, Turn::Plan, Turn::Random];

/// The strategy.
#[derive(Clone, Debug)]
pub struct Hybrid<S> {
    iterations: usize,
    planner: Planner,
    archive: Archive,
    trodden: Trodden<S>,
}

impl<S> Default for Hybrid<S> {
    fn default() -> Self {
        Self { iterations: 0, planner: Planner::default(), archive: Archive::default(), trodden: Trodden::default() }
    }
}

impl<E: Imagine> Strategy<E> for Hybrid<E::Snapshot> {
    fn name(&self) -> &'static str {
        "hybrid"
    }

    fn iterate(&mut self, environment: &mut E, rng: &mut Rng) -> Result<Iteration, E::Error> {
        let turn = TURNS[self.iterations % TURNS.len()];
        self.iterations += 1;
        let planned = match turn {
            Turn::Plan => match self.planner.propose(environment, &self.trodden, rng) {
                Proposal::Promising(actions, 0) => Some(actions),
                // The first episode of all.
                Proposal::Unknown(actions) if self.iterations == 1 => Some(actions),
                _ => None,
            },
            Turn::Vary => None,
            Turn::Random => Some(random_sequence(environment, rng)),
        };
        let actions = planned.unwrap_or_else(|| self.archive.propose(environment, &self.trodden, rng));
        let episode = self.trodden.follow(environment, &actions, rng)?;
        self.archive.observe(&episode);
        self.planner.observe(&episode);
        Ok(Iteration { random: turn == Turn::Random, ..episode.iteration })
    }
}

#[cfg(test)]
#[path = "hybrid_tests.rs"]
mod tests;
