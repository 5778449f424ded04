//! What a search sees of the world: actions, steps, rewards, and ways back.

/// Why an episode stopped.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum End {
    /// An unsafe state was reached.
    Unsafe,
    /// The last action was taken and no unsafe state was reached.
    Horizon,
    /// The simulator could not finish the action: the sequence counts as *not evaluated*, never as safe.
    NotEvaluated,
}

/// The outcome of one action.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Step {
    /// Reward for this action.
    pub reward: f64,
    /// Set when the episode is over.
    pub end: Option<End>,
}

/// A deterministic simulation that can be steered, saved and brought back.
pub trait Environment {
    /// Everything needed to come back to a state.
    type Snapshot: Clone;
    /// A failure that ends the whole search.
    type Error;

    /// Number of actions; the same in every state.
    fn actions(&self) -> usize;

    /// Longest episode, in actions.
    fn horizon(&self) -> usize;

    /// Goes to the start state.
    ///
    /// # Errors
    /// When the start state cannot be reached any more.
    fn reset(&mut self) -> Result<(), Self::Error>;

    /// Takes one action. Must not be called after an episode ended.
    ///
    /// # Errors
    /// When the simulation cannot go on at all.
    fn step(&mut self, action: usize) -> Result<Step, Self::Error>;

    /// Saves the present state.
    fn save(&self) -> Self::Snapshot;

    /// Comes back to a saved state.
    ///
    /// # Errors
    /// When the simulation cannot go on at all.
    fn restore(&mut self, snapshot: &Self::Snapshot) -> Result<(), Self::Error>;
}
