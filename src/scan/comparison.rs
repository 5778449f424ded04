//! Strategies compared: what each spends until its first hazard, and how many different hazards it finds with a whole
//! budget, beside the complete list if that is asked for. Over many seeds, on all cores; the result does not depend on
//! how many.

use std::ops::ControlFlow;

use num_bigint::BigUint;
use num_traits::ToPrimitive as _;

use super::exhaustive::census;
use super::footing::{Footing, not_repeatable};
use super::hosting::StateChoice;
use super::options::Exhaustive;
use super::options::{ScanError, StrategyName};
use super::prepare::Prepared;
use super::seeds::{self, SeedRuns};
use crate::hazard::{Group, Groups};
use crate::host::Hosted;
use crate::report::comparison::{Comparison, Spent};
use crate::report::growth::{Cost, Growth, Truth, checkpoints};
use crate::search::Rng;
use crate::sim::Simulation;
use crate::sim::journal::Journal;

/// What to run.
#[derive(Clone, Debug)]
pub(crate) struct ComparisonOptions {
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
pub(crate) fn run(
    prepared: &Prepared,
    options: &ComparisonOptions,
    tell: &(dyn Fn(usize) + Sync),
) -> Result<Comparison, ScanError> {
    let truth = options.truth.map(|how| complete(prepared, how)).transpose()?;
    let truth_missing = truth.as_ref().and_then(|truth| truth.as_ref().err().cloned());
    let truth = truth.and_then(Result::ok);
    let runs = SeedRuns {
        strategies: &options.strategies,
        first_seed: options.first_seed,
        seeds: options.seeds.max(options.coverage_seeds),
        posture_sweep: options.posture_sweep,
        workers: options.workers,
    };
    let one = |simulation: &mut _, strategy, seed| one(prepared, simulation, (strategy, seed), options, truth.as_ref());
    let results = seeds::run(prepared, &runs, tell, one)?;
    let counted = usize::try_from(options.seeds).unwrap_or(1).max(1);
    let name = |s: &StrategyName| s.build().name().to_owned();
    let runs: Vec<(String, Vec<Spent>)> = results.into_iter().map(|(s, spent)| (name(&s), spent)).collect();
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
    if let Some(reason) = prepared.unsteady() {
        return Ok(Err(format!("{}: no recall: {reason}", prepared.cell.name)));
    }
    let mut footing = Footing::asked(prepared, StateChoice::Auto, how.merge);
    let census = loop {
        let on = (footing, &mut footing.plain(prepared));
        let found =
            census(prepared, on, how, Journal::default(), &links, &mut groups, &mut |_| ControlFlow::Continue(()))?;
        match &found.doubt {
            None => break found,
            Some(doubt) => match footing.lower(prepared, doubt.unlike) {
                Some(next) => (footing, groups) = (next, Groups::default()),
                None => return Ok(Err(format!("{}: no recall: {}", prepared.cell.name, not_repeatable(doubt)))),
            },
        }
    };
    if let Some(cause) = census.broken {
        return Err(ScanError { cause });
    }
    let reasons = match census.certificate {
        Some(_) if census.gaps.is_empty() => {
            let sequences = |group: &Group| group.sequences.as_ref().and_then(BigUint::to_f64).unwrap_or(0.0);
            let groups = groups.ranked();
            let all: f64 = groups.iter().map(|group| sequences(group)).sum();
            return Ok(Ok(groups.into_iter().map(|group| (group.id.clone(), sequences(group) / all)).collect()));
        }
        Some(_) => census.gaps.iter().filter_map(|(_, point)| point.why()).collect::<Vec<_>>().join("; "),
        None => "the FMU failed".to_owned(),
    };
    Ok(Err(format!("{}: no recall, because the exhaustive search is not complete: {reasons}", prepared.cell.name)))
}

/// One run: what it spends until its first hazard, and if it goes on, the number of different hazards.
fn one(
    prepared: &Prepared,
    simulation: &mut Simulation<Hosted>,
    (strategy, seed): (StrategyName, u64),
    options: &ComparisonOptions,
    truth: Option<&Truth>,
) -> Result<Spent, ScanError> {
    let links: Vec<String> = prepared.cell.links.iter().map(|l| l.name.clone()).collect();
    let mut strategy = strategy.build();
    let mut rng = Rng::new(seed);
    let mut groups = Groups::default();
    let mut first: Option<Spent> = None;
    let whole = seed - options.first_seed < options.coverage_seeds;
    let spent = |simulation: &Simulation<Hosted>, iterations: u32, hit: bool| Spent {
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
