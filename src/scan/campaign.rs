//! Many seeds of several strategies, each until its first hazard, on all cores; the result does not depend on how many.

use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use super::prepare::{Prepared, StateChoice};
use super::run::{ScanError, StrategyName};
use crate::host::System;
use crate::report::campaign::Campaign;
use crate::search::Rng;
use crate::search::mcts_dpw::Parameters;
use crate::search::statistics::Runs;
use crate::sim::{Coverage, Simulation};

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
    /// Other parameters for the tree searches than those of their profiles, for sensitivity studies.
    pub parameters: Option<Parameters>,
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
        // What an action does from a state is worked out once for all runs of a thread.
        let wrap = |cause| ScanError { cause };
        let mut simulation = prepared.simulation(StateChoice::Auto, options.posture_sweep).map_err(wrap)?;
        loop {
            let job = next.fetch_add(1, Ordering::Relaxed);
            let Some(&(strategy, seed)) = jobs.get(job) else { return Ok(()) };
            let result = first_hit(&mut simulation, strategy, seed, options)?;
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
            let mut coverage = Coverage::new(prepared.cell.sensors.len());
            let mut first_hit = Vec::with_capacity(chunk.len());
            for (hit, seen) in chunk.iter().flatten() {
                first_hit.push(*hit);
                coverage.merge(seen);
            }
            (name(*s), Runs { first_hit, cap: options.iterations }, coverage)
        })
        .collect();
    let seeds = [options.first_seed, options.seeds];
    Ok(Campaign::new(&prepared.cell.name, seeds, options.iterations, options.posture_sweep, &runs))
}

fn name(strategy: StrategyName) -> String {
    strategy.build().name().to_owned()
}

/// Iteration of the first hazard (from 1) and what was seen until then.
fn first_hit(
    simulation: &mut Simulation<System>,
    strategy: StrategyName,
    seed: u64,
    options: &CampaignOptions,
) -> Result<(Option<u32>, Coverage), ScanError> {
    simulation.begin_run();
    let mut strategy = options.parameters.map_or_else(|| strategy.build(), |p| strategy.build_with(p));
    let mut rng = Rng::new(seed);
    for iteration in 1..=options.iterations {
        strategy.iterate(simulation, &mut rng).map_err(|cause| ScanError { cause })?;
        if !simulation.take_findings().is_empty() {
            return Ok((Some(iteration), simulation.coverage().clone()));
        }
    }
    Ok((None, simulation.coverage().clone()))
}
