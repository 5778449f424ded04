//! `strategies`: what each strategy spends until its first hazard on the built-in cells, and how many hazards it finds with a whole
//! budget.

use std::error::Error;

use clap::ValueEnum;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::scan::{Exhaustive, StrategyName};
use fmi_hazard::search::exhaustive::Budget;
use fmi_hazard::sequences::Merge;
use fmi_hazard::strategies::paper;

use crate::comparison::{Comparison, csv_header, growth_table, table};
use crate::note;
use crate::runs::{self, ComparisonOptions};

/// How tables are printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Format {
    #[default]
    Table,
    Json,
    Csv,
    Md,
}

const ALL: [StrategyName; 4] = [StrategyName::Hybrid, StrategyName::Plan, StrategyName::MctsDpw, StrategyName::Random];

/// Limits of the search for all hazards: memory alone.
const TRUTH_BUDGET: Budget = Budget { states: 20_000_000, bytes: 4_000_000_000, work: u64::MAX, drop: true };

#[derive(Debug, clap::Args)]
pub(crate) struct Arguments {
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

/// Runs the comparison, and gives it in the format that is asked for.
///
/// # Errors
/// When a cell is unknown, its FMU fails, or a file cannot be written.
pub(crate) fn run(arguments: &Arguments) -> Result<String, Box<dyn Error>> {
    let known: Vec<&str> = paper::TABLE.iter().map(|scenario| scenario.cell).collect();
    if let Some(unknown) = arguments.cells.iter().find(|cell| !known.contains(&cell.as_str())) {
        return Err(format!("`{unknown}` is no built-in cell; there are {}", known.join(", ")).into());
    }
    let wanted = |cell: &&str| arguments.cells.is_empty() || arguments.cells.iter().any(|name| name == cell);
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
    let folder = tempfile::tempdir()?;
    fmi_hazard::examples::export(folder.path())?;
    let mut comparisons = Vec::new();
    for cell in known.into_iter().filter(wanted) {
        note(&format!("{cell}: {} seeds of {} strategies", options.seeds, options.strategies.len()));
        let prepared = prepare(&folder.path().join(cell).join("cell.toml"), None)?;
        let comparison = runs::run(&prepared, &options)?;
        comparison.notes.iter().for_each(|told| note(told));
        comparisons.push(comparison);
    }
    render(&comparisons, arguments)
}

fn render(comparisons: &[Comparison], arguments: &Arguments) -> Result<String, Box<dyn Error>> {
    Ok(match arguments.format {
        Format::Json => serde_json::to_string_pretty(comparisons)? + "\n",
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
