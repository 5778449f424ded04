//! Episodes that are resumed where they leave those that are known.
//!
//! The environment is deterministic, so what a sequence has in common with an earlier one need not be simulated again:
//! its state is restored. And a sequence that begins like an episode that has ended is no new one.

use std::collections::{BTreeMap, BTreeSet};

use super::{Environment, Iteration, Rng};

/// Most states kept; later ones are not added.
const STATES_KEPT: usize = 200_000;

/// An episode that was run.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Episode {
    /// Actions until it ended.
    pub actions: Vec<usize>,
    /// How it ended, and its reward.
    pub iteration: Iteration,
}

/// Ways that have been gone.
#[derive(Clone, Debug)]
pub(crate) struct EpisodeTree<S> {
    /// States on the way and the reward until there, by the actions that lead there.
    states: BTreeMap<Vec<usize>, (S, f64)>,
    ended: BTreeSet<Vec<usize>>,
}

impl<S> Default for EpisodeTree<S> {
    fn default() -> Self {
        Self { states: BTreeMap::new(), ended: BTreeSet::new() }
    }
}

impl<S: Clone> EpisodeTree<S> {
    /// Whether an episode with these actions has been run; it may have ended before the last of them.
    #[must_use]
    pub(crate) fn is_known(&self, actions: &[usize]) -> bool {
        (1..=actions.len()).any(|length| self.ended.contains(&actions[..length]))
    }

    /// Runs an episode. If `actions` end before it does, it goes on with random ones.
    ///
    /// # Errors
    /// Passes on what the environment reports as fatal.
    pub(crate) fn follow<E>(
        &mut self,
        environment: &mut E,
        actions: &[usize],
        rng: &mut Rng,
    ) -> Result<Episode, E::Error>
    where
        E: Environment<Snapshot = S>,
    {
        environment.reset()?;
        let mut taken = Vec::with_capacity(environment.horizon());
        let mut total_reward = 0.0;
        // The last action is always taken: it tells how the episode ends.
        let known = (1..actions.len()).rev().find(|&length| self.states.contains_key(&actions[..length]));
        if let Some((length, (state, reward))) = known.and_then(|n| Some((n, self.states.get(&actions[..n])?))) {
            environment.restore(state)?;
            taken.extend_from_slice(&actions[..length]);
            total_reward = *reward;
        }
        loop {
            let action = actions.get(taken.len()).copied().unwrap_or_else(|| rng.below(environment.actions()));
            let step = environment.step(action)?;
            taken.push(action);
            total_reward += step.reward;
            if let Some(end) = step.end {
                self.ended.insert(taken.clone());
                let iteration = Iteration { end, total_reward, random: false };
                return Ok(Episode { actions: taken, iteration });
            }
            if self.states.len() < STATES_KEPT {
                self.states.entry(taken.clone()).or_insert_with(|| (environment.save(), total_reward));
            }
        }
    }
}

/// Uniformly random actions, as many as the longest episode has.
pub(crate) fn random_sequence<E: Environment>(environment: &E, rng: &mut Rng) -> Vec<usize> {
    (0..environment.horizon()).map(|_| rng.below(environment.actions())).collect()
}
