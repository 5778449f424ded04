//! `fmi-hazard bench strategies`: what each strategy spends until its first hazard on the built-in cells, and how many
//! hazards it finds with a whole budget.

use std::sync::{Mutex, PoisonError};

use super::bench_format::Format;
use super::exit::{Failure, NO_HAZARD};
use super::output::{self, Progress};
use crate::report::comparison::{Comparison, csv_header, growth_table, table};
use crate::report::paper;
use crate::scan::comparison::{self, ComparisonOptions};
use crate::scan::prepare::prepare;
use crate::scan::{Exhaustive, StrategyName};
use crate::search::exhaustive::Budget;
use crate::sim::expansion::Merge;

const ALL: [StrategyName; 4] = [StrategyName::Hybrid, StrategyName::Plan, StrategyName::MctsDpw, StrategyName::Random];

/// Limits of the search for all hazards: memory alone.
const TRUTH_BUDGET: Budget = Budget { states: 20_000_000, bytes: 4_000_000_000, work: u64::MAX, drop: true };

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// Strategies
    #[arg(long, value_enum, value_delimiter = ',', default_values_t = ALL)]
    strategies: Vec<StrategyName>,
    /// Built-in cells (default: all six)
    #[arg(long, value_delimiter = ',')]
    cells: Vec<String>,
    /// Number of seeds
    #[arg(long, default_value_t = 20, value_parser = clap::value_parser!(u64).range(1..100_000))]
    seeds: u64,
    /// So many seeds go on to the end of the budget, to count the different hazards found
    #[arg(long, default_value_t = 5, value_parser = clap::value_parser!(u64).range(0..100_000))]
    coverage_seeds: u64,
    /// First seed
    #[arg(long, default_value_t = 1)]
    first_seed: u64,
    /// Budget of each run, in iterations
    #[arg(long, default_value_t = 320, value_parser = clap::value_parser!(u32).range(1..))]
    iterations: u32,
    /// First look at every sequence of each cell, and say which part of all hazards the strategies find; takes minutes a
    /// cell, and long for cells with a light curtain
    #[arg(long)]
    truth: bool,
    /// Check all six postures per walk, as `scan` does
    #[arg(long)]
    posture_sweep: bool,
    /// Threads (default: one a core); the result is the same
    #[arg(long)]
    workers: Option<usize>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let known: Vec<&str> = paper::TABLE.iter().map(|s| s.cell).collect();
    if let Some(unknown) = arguments.cells.iter().find(|c| !known.contains(&c.as_str())) {
        return Err(Failure::unusable(format!("`{unknown}` is no built-in cell; there are {}", known.join(", "))));
    }
    let wanted = |cell: &&str| arguments.cells.is_empty() || arguments.cells.iter().any(|c| c == cell);
    let cells: Vec<&str> = known.into_iter().filter(wanted).collect();
    let workers = arguments.workers.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, Into::into));
    let options = ComparisonOptions {
        strategies: arguments.strategies.clone(),
        reference: StrategyName::MctsDpw,
        first_seed: arguments.first_seed,
        seeds: arguments.seeds,
        coverage_seeds: arguments.coverage_seeds,
        iterations: arguments.iterations,
        truth: arguments.truth.then_some(Exhaustive { budget: TRUTH_BUDGET, merge: Merge::default(), workers }),
        posture_sweep: arguments.posture_sweep,
        workers,
    };
    let folder = tempfile::tempdir().map_err(Failure::unusable)?;
    crate::examples::export(folder.path()).map_err(Failure::unusable)?;
    let each = options.seeds.max(options.coverage_seeds) * options.strategies.len() as u64;
    let progress = Mutex::new(Progress::new(each * cells.len() as u64, "runs"));
    let mut comparisons = Vec::with_capacity(cells.len());
    for (before, cell) in (0..).step_by(usize::try_from(each).unwrap_or(1).max(1)).zip(cells) {
        let prepared = prepare(&folder.path().join(cell).join("cell.toml"), None)?;
        let tell = |done: usize| {
            let done: usize = before + done;
            progress.lock().unwrap_or_else(PoisonError::into_inner).at(done as u64, cell);
        };
        if arguments.truth {
            output::note(&format!("  Looking at every sequence of {cell}, then at what strategies find of it"));
        }
        let comparison = comparison::run(&prepared, &options, &tell)?;
        comparison.notes.iter().for_each(|note| output::note(&format!("  Note      {note}")));
        comparisons.push(comparison);
    }
    progress.lock().unwrap_or_else(PoisonError::into_inner).finish();
    let print = if matches!(arguments.format, Format::Json) { output::json } else { output::result };
    print(&render(&comparisons, arguments)?);
    Ok(NO_HAZARD)
}

fn render(comparisons: &[Comparison], arguments: &Arguments) -> Result<String, Failure> {
    Ok(match arguments.format {
        Format::Json => output::pretty(comparisons)?,
        Format::Csv => csv_header(arguments.iterations) + &comparisons.iter().map(Comparison::csv).collect::<String>(),
        Format::Md => table(comparisons, true) + "\n" + &growth_table(comparisons, true),
        Format::Table => {
            let head = format!(
                "Cost of the first hazard, {} seeds from {}, at most {} iterations; hazards: different ones after all of \
                 them, {} seeds.\n\n",
                arguments.seeds, arguments.first_seed, arguments.iterations, arguments.coverage_seeds
            );
            let growth = match (arguments.coverage_seeds, arguments.truth) {
                (0, _) => String::new(),
                (seeds, true) => format!(
                    "\nPart of all hazards found after so many iterations, {seeds} seeds; in brackets the part of all \
                     hazardous sequences that begin with one of them.\n\n"
                ),
                (seeds, false) => format!("\nDifferent hazards after so many iterations, {seeds} seeds.\n\n"),
            };
            head + &table(comparisons, false) + &growth + &growth_table(comparisons, false)
        }
    })
}
