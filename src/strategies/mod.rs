//! Many seeds of several strategies, each until its first hazard, on all cores; the result does not depend on how many.

pub mod paper;
pub(crate) mod table;

use self::table::Campaign;
use crate::host::Hosted;
use crate::scan::options::{ScanError, StrategyName};
use crate::scan::prepare::Prepared;
use crate::scan::seeds::{self, SeedRuns};
use crate::search::Rng;
use crate::search::mcts_dpw::Parameters;
use crate::search::statistics::Runs;
use crate::sim::{Coverage, Simulation};

/// What to run.
#[derive(Clone, Debug)]
pub(crate) struct CampaignOptions {
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
pub(crate) fn run(
    prepared: &Prepared,
    options: &CampaignOptions,
    tell: &(dyn Fn(usize) + Sync),
) -> Result<Campaign, ScanError> {
    let runs = SeedRuns {
        strategies: &options.strategies,
        first_seed: options.first_seed,
        seeds: options.seeds,
        posture_sweep: options.posture_sweep,
        workers: options.workers,
    };
    let one = |simulation: &mut _, strategy, seed| first_hit(simulation, strategy, seed, options);
    let runs: Vec<_> = seeds::run(prepared, &runs, tell, one)?
        .into_iter()
        .map(|(strategy, results)| {
            let mut coverage = crate::sim::nothing_seen(&prepared.cell);
            let mut first_hit = Vec::with_capacity(results.len());
            for (hit, seen) in results {
                first_hit.push(hit);
                coverage.merge(&seen);
            }
            (name(strategy), Runs { first_hit, cap: options.iterations }, coverage)
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
    simulation: &mut Simulation<Hosted>,
    strategy: StrategyName,
    seed: u64,
    options: &CampaignOptions,
) -> Result<(Option<u32>, Coverage), ScanError> {
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
