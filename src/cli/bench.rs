//! `fmi-hazard bench`: many seeds of several strategies on one cell, each to its first hazard.

use std::path::PathBuf;
use std::sync::{Mutex, PoisonError};

use clap::ValueEnum;

use super::exit::{Failure, NO_HAZARD};
use super::output::{self, Progress};
use crate::scan::StrategyName;
use crate::scan::campaign::{self, CampaignOptions};
use crate::scan::prepare::prepare;

#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Format {
    #[default]
    Table,
    Json,
}

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A cell file, or an FMU with its cell
    path: PathBuf,
    /// Strategies; the last is the reference
    #[arg(long, value_enum, value_delimiter = ',', default_values_t = [StrategyName::MctsDpw, StrategyName::MctsDpwLee, StrategyName::Random])]
    strategies: Vec<StrategyName>,
    /// Number of seeds
    #[arg(long, default_value_t = 10, value_parser = clap::value_parser!(u64).range(1..100_000))]
    seeds: u64,
    /// First seed
    #[arg(long, default_value_t = 1)]
    first_seed: u64,
    /// Budget of each run, in iterations
    #[arg(long, default_value_t = 320, value_parser = clap::value_parser!(u32).range(1..))]
    iterations: u32,
    /// Check all six postures per walk; iterations then do not compare with the paper's
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
    let prepared = prepare(&arguments.path, None)?;
    let workers = arguments.workers.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, Into::into));
    let options = CampaignOptions {
        strategies: arguments.strategies.clone(),
        first_seed: arguments.first_seed,
        seeds: arguments.seeds,
        iterations: arguments.iterations,
        posture_sweep: arguments.posture_sweep,
        workers,
    };
    let total = options.seeds * options.strategies.len() as u64;
    let progress = Mutex::new(Progress::new(total, "runs"));
    let tell = |done: usize| progress.lock().unwrap_or_else(PoisonError::into_inner).at(done as u64, "");
    let campaign = campaign::run(&prepared, &options, &tell)?;
    progress.lock().unwrap_or_else(PoisonError::into_inner).finish();
    match arguments.format {
        Format::Table => output::result(&campaign.render()),
        Format::Json => {
            let text = serde_json::to_string_pretty(&campaign).map_err(Failure::unusable)?;
            output::result(&(text + "\n"));
        }
    }
    Ok(NO_HAZARD)
}
