//! `fmi-hazard bench`: many seeds of several strategies, each to its first hazard: on one cell, or on the paper's six
//! beside the paper's own figures.

use std::path::{Path, PathBuf};
use std::sync::{Mutex, PoisonError};

use super::bench_format::Format;
use super::exit::{Failure, NO_HAZARD};
use super::hosting::HostingArguments;
use super::output::{self, Progress};
use crate::scan::StrategyName;
use crate::scan::prepare::{Prepared, prepare, prepare_in};
use crate::search::Profile;
use crate::search::mcts_dpw::Parameters;
use crate::strategies::table::{CSV_HEADER, Campaign, beside_the_paper};
use crate::strategies::{self, CampaignOptions, paper};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A cell file, an FMU with its cell, or `paper`: the six built-in cells beside the paper's results
    path: PathBuf,
    /// Strategies; the last is the reference
    #[arg(long, value_enum, value_delimiter = ',', default_values_t = [StrategyName::MctsDpw, StrategyName::Random])]
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
    /// Tree searches with another widening factor k, widening exponent alpha or exploration weight c than their
    /// profile's, for sensitivity studies: k,alpha,c
    #[arg(long, value_delimiter = ',', num_args = 3, value_names = ["K", "ALPHA", "C"])]
    mcts: Option<Vec<f64>>,
    /// Threads (default: one a core); the result is the same
    #[arg(long)]
    workers: Option<usize>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    hosting: HostingArguments,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let workers = arguments.workers.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, Into::into));
    let parameters =
        arguments.mcts.as_ref().map(|v| Parameters { k: v[0], alpha: v[1], c: v[2], ..Profile::Paper.parameters() });
    let options = CampaignOptions {
        strategies: arguments.strategies.clone(),
        first_seed: arguments.first_seed,
        seeds: arguments.seeds,
        iterations: arguments.iterations,
        posture_sweep: arguments.posture_sweep,
        parameters,
        workers,
    };
    let (cells, _folder) = cells(&arguments.path, &arguments.hosting)?;
    let total = options.seeds * options.strategies.len() as u64;
    let progress = Mutex::new(Progress::new(total * cells.len() as u64, "runs"));
    let mut campaigns = Vec::with_capacity(cells.len());
    for (place, cell) in cells.iter().enumerate() {
        let before = total * place as u64;
        let tell = |done: usize| {
            progress.lock().unwrap_or_else(PoisonError::into_inner).at(before + done as u64, &cell.cell.name);
        };
        campaigns.push(strategies::run(cell, &options, &tell)?);
    }
    progress.lock().unwrap_or_else(PoisonError::into_inner).finish();
    let print = if matches!(arguments.format, Format::Json) { output::json } else { output::result };
    print(&render(&campaigns, arguments.format)?);
    Ok(NO_HAZARD)
}

/// The cells to run; the folder holds the built-in ones as long as they are used.
fn cells(path: &Path, hosting: &HostingArguments) -> Result<(Vec<Prepared>, Option<tempfile::TempDir>), Failure> {
    if path != Path::new("paper") {
        return Ok((vec![prepare_in(path, None, &hosting.hosting()?)?], None));
    }
    let folder = tempfile::tempdir().map_err(Failure::unusable)?;
    crate::examples::export(folder.path()).map_err(Failure::unusable)?;
    let cells = paper::TABLE.iter().map(|s| prepare(&folder.path().join(s.cell).join("cell.toml"), None));
    Ok((cells.collect::<Result<_, _>>()?, Some(folder)))
}

fn render(campaigns: &[Campaign], format: Format) -> Result<String, Failure> {
    Ok(match (format, campaigns) {
        (Format::Json, [one]) => output::pretty(one)?,
        (Format::Json, all) => output::pretty(all)?,
        (Format::Csv, all) => CSV_HEADER.to_owned() + &all.iter().map(Campaign::csv).collect::<String>(),
        (Format::Md, all) => beside_the_paper(all, true),
        (Format::Table, [one]) => one.render(),
        (Format::Table, all) => {
            let [first, count] = all[0].seeds;
            let head = format!(
                "Iterations to the first hazard, {count} seeds from {first}, misses counted as {}; the paper ran 10 seeds.\n\n",
                all[0].iterations
            );
            head + &beside_the_paper(all, false)
        }
    })
}
