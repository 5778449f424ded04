//! Strategies compared: what each spends until its first hazard, and how many different hazards it finds with a whole
//! budget, beside the complete list if that is asked for. Over many seeds, on all cores; the result does not depend on
//! how many.

use std::ops::ControlFlow;

use fmi_hazard::hazard::Groups;
use fmi_hazard::host::Hosted;
use fmi_hazard::scan::prepare::Prepared;
use fmi_hazard::scan::seeds::{self, SeedRuns};
use fmi_hazard::scan::{Exhaustive, Method, ScanError, ScanOptions, StateChoice, StrategyName, scan};
use fmi_hazard::search::Rng;
use fmi_hazard::sim::Simulation;

use crate::comparison::{Comparison, Spent};
use crate::growth::{Cost, Growth, Truth, checkpoints};

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

/// Runs the comparison on one cell.
///
/// # Errors
/// When the FMU fails.
pub(crate) fn run(prepared: &Prepared, options: &ComparisonOptions) -> Result<Comparison, ScanError> {
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
    let results = seeds::run(prepared, &runs, &|_| (), one)?;
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
    let options = ScanOptions {
        method: Method::Exhaustive(how),
        seed: 1,
        iterations: 0,
        stop_at_first: false,
        posture_sweep: true,
        state: StateChoice::Auto,
    };
    let report = scan(prepared, options, &mut |_| ControlFlow::Continue(()))?.report;
    let cell = &prepared.cell.name;
    match &report.certificate {
        Some(certificate) if certificate.complete => {}
        certificate => {
            let reasons = certificate.as_ref().map_or_else(String::new, |found| found.reasons.join("; "));
            return Ok(Err(format!("{cell}: no recall, because the exhaustive search is not complete: {reasons}")));
        }
    }
    let sequences = |count: &Option<String>| count.as_ref().and_then(|count| count.parse::<f64>().ok()).unwrap_or(0.0);
    let all: f64 = report.hazards.iter().map(|hazard| sequences(&hazard.sequences)).sum();
    Ok(Ok(report.hazards.into_iter().map(|hazard| (hazard.id.clone(), sequences(&hazard.sequences) / all)).collect()))
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
