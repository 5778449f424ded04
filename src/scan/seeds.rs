//! Many seeds of several strategies on one cell, on all cores; the result does not depend on how many.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use super::hosting::StateChoice;
use super::options::{ScanError, StrategyName};
use super::prepare::Prepared;
use crate::host::Hosted;
use crate::sim::Simulation;

/// What is to be run.
pub struct SeedRuns<'a> {
    /// Strategies.
    pub strategies: &'a [StrategyName],
    /// First seed.
    pub first_seed: u64,
    /// Number of seeds.
    pub seeds: u64,
    /// Check all six postures per walk.
    pub posture_sweep: bool,
    /// Threads.
    pub workers: usize,
}

/// Runs `one` for each strategy and seed; the results by strategy, in the order of seeds. `tell` hears how many have ended.
///
/// What an action does from a state is worked out once for all runs of a thread; `one` gets the simulation at the
/// beginning of a run.
///
/// # Errors
/// When the FMU fails.
pub fn run<T: Send>(
    prepared: &Prepared,
    runs: &SeedRuns<'_>,
    tell: &(dyn Fn(usize) + Sync),
    one: impl Fn(&mut Simulation<Hosted>, StrategyName, u64) -> Result<T, ScanError> + Sync,
) -> Result<Vec<(StrategyName, Vec<T>)>, ScanError> {
    let seeds = runs.first_seed..runs.first_seed + runs.seeds;
    let jobs: Vec<(StrategyName, u64)> =
        runs.strategies.iter().flat_map(|&strategy| seeds.clone().map(move |seed| (strategy, seed))).collect();
    let (next, ended) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let results = Mutex::new(Vec::from_iter(jobs.iter().map(|_| None)));
    let work = || -> Result<(), ScanError> {
        let mut simulation =
            prepared.simulation(StateChoice::Auto, runs.posture_sweep).map_err(|cause| ScanError { cause })?;
        loop {
            let job = next.fetch_add(1, Ordering::Relaxed);
            let Some(&(strategy, seed)) = jobs.get(job) else { return Ok(()) };
            simulation.begin_run();
            let result = one(&mut simulation, strategy, seed)?;
            results.lock().unwrap_or_else(PoisonError::into_inner)[job] = Some(result);
            tell(ended.fetch_add(1, Ordering::Relaxed) + 1);
        }
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..runs.workers.max(1)).map(|_| scope.spawn(work)).collect();
        threads.into_iter().try_for_each(|t| t.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    })?;
    let mut results = results.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().flatten();
    let count = usize::try_from(runs.seeds).unwrap_or(usize::MAX);
    Ok(runs.strategies.iter().map(|&strategy| (strategy, results.by_ref().take(count).collect())).collect())
}
