//! The paper's baseline: uniformly random actions from the start, same checks, same budget.

use super::{Environment, Iteration, Rng, Strategy};

/// Uniform random episodes.
#[derive(Clone, Copy, Debug, Default)]
pub struct Random;

impl<E: Environment> Strategy<E> for Random {
    fn name(&self) -> &'static str {
        "random"
    }

    fn iterate(&mut self, environment: &mut E, rng: &mut Rng) -> Result<Iteration, E::Error> {
        environment.reset()?;
        Ok(Iteration { random: true, ..rollout(environment, rng)? })
    }
}

/// Uniform random actions from where the environment stands until the episode ends.
pub(super) fn rollout<E: Environment>(environment: &mut E, rng: &mut Rng) -> Result<Iteration, E::Error> {
    let mut total_reward = 0.0;
    loop {
        let action = rng.below(environment.actions());
        let step = environment.step(action)?;
        total_reward += step.reward;
        if let Some(end) = step.end {
            return Ok(Iteration { end, total_reward, random: false });
        }
    }
}
