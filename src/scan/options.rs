//! How to search, and what is told meanwhile.

use thiserror::Error;

use super::hosting::StateChoice;
use crate::host::{Hosted, PlantError};
use crate::record::hazard::Hazard;
use crate::search::exhaustive::Budget;
use crate::search::mcts_dpw::Parameters;
use crate::search::{Hybrid, MctsDpw, Plan, Profile, Random, Strategy};
use crate::sequences::Merge;
use crate::sim::Simulation;
use crate::sim::simulation::Snapshot;

/// Strategies by name.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, clap::ValueEnum)]
pub enum StrategyName {
    /// Monte Carlo tree search with double progressive widening, the paper's method made to work.
    MctsDpw,
    /// The same with the parameters of the cited algorithm (adaptive stress testing).
    MctsDpwLee,
    /// The paper to the letter.
    MctsDpwLiteral,
    /// Uniform random sequences, the paper's baseline.
    Random,
    /// Sequences imagined from the robot motion seen so far, then verified.
    Plan,
    /// Plan, and every fifth sequence random.
    #[default]
    Hybrid,
}

/// How to search everything.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Exhaustive {
    /// Limits.
    pub budget: Budget,
    /// How equal states of the FMU are told.
    pub merge: Merge,
    /// Threads.
    pub workers: usize,
}

/// How sequences are chosen.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Method {
    /// One after the other, by a strategy, within a budget of iterations.
    Strategy(StrategyName),
    /// All of them, equal states once.
    Exhaustive(Exhaustive),
    /// All of them, as far as the budget goes, and beside it a strategy for a small part of the cost; where the budget ends
    /// before all of them were looked at, the strategy's own budget is used up.
    Auto(StrategyName, Exhaustive),
}

impl StrategyName {
    /// A fresh strategy.
    #[must_use]
    pub fn build(self) -> Box<dyn Strategy<Simulation<Hosted>>> {
        let mcts = |profile| Box::new(MctsDpw::<Snapshot>::new(profile));
        match self {
            Self::MctsDpw => mcts(Profile::Paper),
            Self::MctsDpwLee => mcts(Profile::Lee),
            Self::MctsDpwLiteral => mcts(Profile::PaperLiteral),
            Self::Random => Box::new(Random),
            Self::Plan => Box::new(Plan::<Snapshot>::default()),
            Self::Hybrid => Box::new(Hybrid::<Snapshot>::default()),
        }
    }
}

impl StrategyName {
    /// A fresh strategy; a tree search with these parameters instead of its profile's.
    #[must_use]
    pub(crate) fn build_with(self, parameters: Parameters) -> Box<dyn Strategy<Simulation<Hosted>>> {
        let mcts = |profile| Box::new(MctsDpw::<Snapshot>::with_parameters(profile, parameters));
        match self {
            Self::MctsDpw => mcts(Profile::Paper),
            Self::MctsDpwLee => mcts(Profile::Lee),
            Self::MctsDpwLiteral => mcts(Profile::PaperLiteral),
            other => other.build(),
        }
    }
}

/// How to search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct ScanOptions {
    /// How sequences are chosen.
    pub method: Method,
    /// Seed.
    pub seed: u64,
    /// Budget.
    pub iterations: u32,
    /// Stop at the first hazard.
    pub stop_at_first: bool,
    /// Check all six postures per walk.
    pub posture_sweep: bool,
    /// How states are brought back.
    pub state: StateChoice,
}

/// What is told while a scan runs.
pub enum Progress<'a> {
    /// An iteration has ended: how many so far, and how many hazards.
    Iteration {
        /// Iterations so far.
        done: u32,
        /// Hazards so far.
        hazards: usize,
    },
    /// States of one level of an exhaustive search.
    Level {
        /// Actions before these states.
        depth: usize,
        /// States looked at.
        done: usize,
        /// States of the level.
        of: usize,
        /// Hazards so far.
        hazards: usize,
        /// What the search cost so far, in communication steps, about.
        cost: u64,
    },
    /// Shorter sequences are looked for.
    Shortening {
        /// Hazards for which that is done.
        done: usize,
        /// Of so many.
        of: usize,
    },
    /// Hazards are confirmed by runs from the start.
    Confirming {
        /// Hazards so far.
        done: usize,
        /// Of so many.
        of: usize,
    },
    /// What the FMU did is run again from the start.
    RunAgain {
        /// Runs so far.
        done: usize,
        /// Of so many.
        of: usize,
    },
    /// Nothing found so far counts: everything is searched again on another footing.
    SearchAgain {
        /// Why, and how.
        because: &'a str,
    },
    /// Nothing new.
    Working,
    /// A hazard that was not met before; not confirmed yet.
    Found(&'a Hazard),
}

/// The scan could not go on.
#[derive(Debug, Error, miette::Diagnostic)]
#[error("the FMU failed: {cause}")]
#[diagnostic(help(
    "run `fmi-hazard inspect --self-test` on the FMU; its maker can reproduce the failure from what it prints"
))]
pub struct ScanError {
    /// What the FMU did.
    pub cause: PlantError,
}
