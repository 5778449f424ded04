//! Search over action sequences, knowing nothing of FMUs, humans or geometry.
//!
//! An [`Environment`] offers a finite set of actions, steps, saves and restores; a [`Strategy`] proposes episodes, one
//! per iteration. So strategies are tested on small puzzles with known answers, and a new strategy is one file.
//!
//! - [`environment`]: the trait that `sim` implements
//! - [`random`]: the paper's baseline, uniform actions from the start
//! - [`mcts_dpw`]: Monte Carlo tree search with double progressive widening, in three profiles
//! - [`plan`]: sequences imagined from what was observed so far, then verified
//! - [`hybrid`]: planning, and a fixed share of random episodes
//! - [`episode`]: episodes that are resumed where they leave those that are known
//! - [`exhaustive`]: all sequences, level by level, equal states once
//! - [`rng`]: the one door for randomness
//! - [`residual`]: what uniformly random sequences say about the hazards that are left
//! - [`statistics`]: capped means, intervals and misses over many seeds, binomial bounds
//! - [`tracks`]: all histories of a few readings, as long as ways between them take

pub mod behaviours;
pub(crate) mod environment;
pub(crate) mod episode;
pub mod exhaustive;
pub(crate) mod hybrid;
pub mod mcts_dpw;
pub mod plan;
pub(crate) mod random;
pub mod residual;
pub(crate) mod rng;
pub mod statistics;
pub mod tracks;

pub use environment::{End, Environment, Step};
pub use hybrid::Hybrid;
pub use mcts_dpw::{MctsDpw, Profile};
pub use plan::{EndingKind, Plan, SurrogateModel};
pub use random::Random;
pub use rng::Rng;

/// How one iteration (one episode from the start state) ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Iteration {
    /// Why the episode stopped.
    pub end: End,
    /// Undiscounted sum of its rewards.
    pub total_reward: f64,
    /// Whether its actions were drawn uniformly at random, and that this would be so was settled beforehand: what holds
    /// for random search holds for such episodes, whatever else a strategy does.
    pub random: bool,
}

/// A way of choosing which action sequences to try.
pub trait Strategy<E: Environment> {
    /// The name used on the command line and in results.
    fn name(&self) -> &'static str;

    /// Runs one episode from the start state.
    ///
    /// # Errors
    /// Passes on what the environment reports as fatal to the whole search; an episode that merely could not be
    /// evaluated ends with [`End::NotEvaluated`] instead.
    fn iterate(&mut self, environment: &mut E, rng: &mut Rng) -> Result<Iteration, E::Error>;
}
