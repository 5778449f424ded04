//! Many seeds of several strategies, each until its first hazard, on all cores; the result does not depend on how many.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use super::prepare::{Prepared, StateChoice};
use super::run::{ScanError, StrategyName};
use crate::report::campaign::Campaign;
use crate::search::Rng;
use crate::search::statistics::Runs;

/// What to run.
#[derive(Clone, Debug)]
pub struct CampaignOptions {
    /// Strategies; the last is the reference of the ratios.
    pub strategies: Vec<StrategyName>,
    /// First seed.
    pub first_seed: u64,
    /// Number of seeds.
    pub seeds: u64,
    /// Budget of each run.
    pub iterations: u32,
    /// Check all six postures per walk.
    pub posture_sweep: bool,
    /// Threads.
    pub workers: usize,
}

/// Runs the campaign; `tell` hears how many runs have ended.
///
/// # Errors
/// When the FMU fails.
pub fn run(
    prepared: &Prepared,
    options: &CampaignOptions,
    tell: &(dyn Fn(usize) + Sync),
) -> Result<Campaign, ScanError> {
    let jobs: Vec<(StrategyName, u64)> =
        options.strategies.iter().flat_map(|&s| (0..options.seeds).map(move |i| (s, options.first_seed + i))).collect();
    let (next, ended) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let results = Mutex::new(vec![None; jobs.len()]);
    let work = || -> Result<(), ScanError> {
        loop {
            let job = next.fetch_add(1, Ordering::Relaxed);
            let Some(&(strategy, seed)) = jobs.get(job) else { return Ok(()) };
            let result = first_hit(prepared, strategy, seed, options)?;
            results.lock().unwrap_or_else(PoisonError::into_inner)[job] = Some(result);
            tell(ended.fetch_add(1, Ordering::Relaxed) + 1);
        }
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..options.workers.max(1)).map(|_| scope.spawn(work)).collect();
        threads.into_iter().try_for_each(|t| t.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    })?;
    let results = results.into_inner().unwrap_or_else(PoisonError::into_inner);
    let per_strategy = usize::try_from(options.seeds).unwrap_or(1).max(1);
    let runs: Vec<_> = options
        .strategies
        .iter()
        .zip(results.chunks(per_strategy))
        .map(|(s, chunk)| {
            let (first_hit, actions): (Vec<_>, Vec<_>) = chunk.iter().flatten().copied().unzip();
            (name(*s), Runs { first_hit, cap: options.iterations }, actions)
        })
        .collect();
    let seeds = [options.first_seed, options.seeds];
    Ok(Campaign::new(&prepared.cell.name, seeds, options.iterations, options.posture_sweep, &runs))
}

fn name(strategy: StrategyName) -> String {
    strategy.build().name().to_owned()
}

/// Iteration of the first hazard (from 1) and the actions simulated until then.
fn first_hit(
    prepared: &Prepared,
    strategy: StrategyName,
    seed: u64,
    options: &CampaignOptions,
) -> Result<(Option<u32>, u64), ScanError> {
    let wrap = |cause| ScanError { cause };
    let mut simulation = prepared.simulation(StateChoice::Auto, options.posture_sweep).map_err(wrap)?;
    let mut strategy = strategy.build();
    let mut rng = Rng::new(seed);
    for iteration in 1..=options.iterations {
        strategy.iterate(&mut simulation, &mut rng).map_err(wrap)?;
        if !simulation.take_findings().is_empty() {
            return Ok((Some(iteration), simulation.coverage().actions));
        }
    }
    Ok((None, simulation.coverage().actions))
}
