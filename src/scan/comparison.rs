//! Strategies compared: what each spends until its first hazard, and how many different hazards it finds with a whole
//! budget, beside the complete list if that is asked for. Over many seeds, on all cores; the result does not depend on
//! how many.

use std::ops::ControlFlow;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

use num_bigint::BigUint;
use num_traits::ToPrimitive as _;

use super::exhaustive::{Exhaustive, census};
use super::prepare::{Prepared, StateChoice};
use super::run::{ScanError, StrategyName};
use crate::hazard::{Group, Groups};
use crate::host::System;
use crate::report::comparison::{Comparison, Spent};
use crate::report::growth::{Cost, Growth, Truth, checkpoints};
use crate::search::Rng;
use crate::sim::Simulation;

/// What to run.
#[derive(Clone, Debug)]
pub struct ComparisonOptions {
    /// Strategies.
    pub strategies: Vec<StrategyName>,
    /// The one that the others are measured by, if it is among them.
    pub reference: StrategyName,
    /// First seed.
    pub first_seed: u64,
    /// Number of seeds.
    pub seeds: u64,
    /// The first so many seeds go on after the first hazard, to the end of the budget.
    pub coverage_seeds: u64,
    /// Budget of each run.
    pub iterations: u32,
    /// First look at every sequence, for the complete list of hazards.
    pub truth: Option<Exhaustive>,
    /// Check all six postures per walk.
    pub posture_sweep: bool,
    /// Threads.
    pub workers: usize,
}

/// Runs the comparison on one cell; `tell` hears how many runs have ended.
///
/// # Errors
/// When the FMU fails.
pub fn run(
    prepared: &Prepared,
    options: &ComparisonOptions,
    tell: &(dyn Fn(usize) + Sync),
) -> Result<Comparison, ScanError> {
    let truth = options.truth.map(|how| complete(prepared, how)).transpose()?;
    let truth_missing = truth.as_ref().and_then(|truth| truth.as_ref().err().cloned());
    let truth = truth.and_then(Result::ok);
    let seeds = options.seeds.max(options.coverage_seeds);
    let jobs: Vec<(StrategyName, u64)> =
        options.strategies.iter().flat_map(|&s| (0..seeds).map(move |i| (s, i))).collect();
    let (next, ended) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let results = Mutex::new(vec![None; jobs.len()]);
    let work = || -> Result<(), ScanError> {
        // What an action does from a state is worked out once for all runs of a thread; what a run spends is counted as
        // if it were alone.
        let mut simulation =
            prepared.simulation(StateChoice::Auto, options.posture_sweep).map_err(|cause| ScanError { cause })?;
        loop {
            let job = next.fetch_add(1, Ordering::Relaxed);
            let Some(&(strategy, seed)) = jobs.get(job) else { return Ok(()) };
            let result = one(prepared, &mut simulation, (strategy, seed), options, truth.as_ref())?;
            results.lock().unwrap_or_else(PoisonError::into_inner)[job] = Some(result);
            tell(ended.fetch_add(1, Ordering::Relaxed) + 1);
        }
    };
    std::thread::scope(|scope| {
        let threads: Vec<_> = (0..options.workers.max(1)).map(|_| scope.spawn(work)).collect();
        threads.into_iter().try_for_each(|t| t.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic)))
    })?;
    let results: Vec<Spent> =
        results.into_inner().unwrap_or_else(PoisonError::into_inner).into_iter().flatten().collect();
    let per_strategy = usize::try_from(seeds).unwrap_or(1).max(1);
    let counted = usize::try_from(options.seeds).unwrap_or(1).max(1);
    let name = |s: &StrategyName| s.build().name().to_owned();
    let runs: Vec<(String, Vec<Spent>)> =
        options.strategies.iter().map(name).zip(results.chunks(per_strategy).map(<[Spent]>::to_vec)).collect();
    let settings = (options.first_seed, counted, options.iterations, options.posture_sweep);
    let all = truth.as_ref().map(Truth::len);
    let mut comparison = Comparison::new(&prepared.cell.name, settings, &runs, &name(&options.reference), all);
    comparison.notes.extend(truth_missing);
    Ok(comparison)
}

/// Every hazard of the cell; or why it is not known.
fn complete(prepared: &Prepared, how: Exhaustive) -> Result<Result<Truth, String>, ScanError> {
    let links: Vec<String> = prepared.cell.links.iter().map(|l| l.name.clone()).collect();
    let mut groups = Groups::default();
    let census = census(prepared, StateChoice::Auto, how, &links, &mut groups, &mut |_| ControlFlow::Continue(()))?;
    if let Some(cause) = census.broken {
        return Err(ScanError { cause });
    }
    let reasons = match census.certificate {
        Some(certificate) if certificate.complete => {
            let sequences = |group: &Group| group.sequences.as_ref().and_then(BigUint::to_f64).unwrap_or(0.0);
            let groups = groups.ranked();
            let all: f64 = groups.iter().map(|group| sequences(group)).sum();
            return Ok(Ok(groups.into_iter().map(|group| (group.id.clone(), sequences(group) / all)).collect()));
        }
        Some(certificate) => certificate.reasons.join("; "),
        None => "the FMU failed".to_owned(),
    };
    Ok(Err(format!("{}: no recall, because the exhaustive search is not complete: {reasons}", prepared.cell.name)))
}

/// One run: what it spends until its first hazard, and if it goes on, the number of different hazards.
fn one(
    prepared: &Prepared,
    simulation: &mut Simulation<System>,
    (strategy, number): (StrategyName, u64),
    options: &ComparisonOptions,
    truth: Option<&Truth>,
) -> Result<Spent, ScanError> {
    let links: Vec<String> = prepared.cell.links.iter().map(|l| l.name.clone()).collect();
    simulation.begin_run();
    let mut strategy = strategy.build();
    let mut rng = Rng::new(options.first_seed + number);
    let mut groups = Groups::default();
    let mut first: Option<Spent> = None;
    let whole = number < options.coverage_seeds;
    let spent = |simulation: &Simulation<System>, iterations: u32, hit: bool| Spent {
        hit,
        iterations,
        actions: simulation.coverage().actions,
        fmu_steps: simulation.fmu_steps_of_run(),
        growth: None,
    };
    let checkpoints = checkpoints(options.iterations);
    let mut growth = Growth::default();
    for iteration in 1..=options.iterations {
        strategy.iterate(simulation, &mut rng).map_err(|cause| ScanError { cause })?;
        for finding in simulation.take_findings() {
            if let Some(id) = groups.add(finding, u64::from(iteration), &links) {
                growth.met(id, truth);
            }
        }
        let Spent { iterations, actions, fmu_steps, .. } = spent(simulation, iteration, true);
        growth.after(Cost { iterations, actions, fmu_steps }, &checkpoints, truth);
        if first.is_none() && !groups.is_empty() {
            first = Some(spent(simulation, iteration, true));
        }
        if first.is_some() && !whole {
            break;
        }
    }
    let mut result = first.unwrap_or_else(|| spent(simulation, options.iterations, false));
    result.growth = whole.then_some(growth);
    Ok(result)
}
