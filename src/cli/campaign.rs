//! `fmi-hazard campaign`: many scans as one piece of work. What hands its tasks to machines is outside: a shard or a task is a
//! command line.

use std::path::{Path, PathBuf};

use super::exit::{self, Failure};
use super::hosting::HostingArguments;
use super::output::{self, Format};
use super::run::file_name;
use super::stopping;
use crate::campaign::description::Description;
use crate::campaign::merge::merge;
use crate::campaign::plan::plan;
use crate::campaign::run::{CampaignEvent, Which, run as run_tasks};
use crate::campaign::status::status;
use crate::campaign::{Manifest, manifest::MANIFEST};
use crate::report::survey::State;
use crate::stop::Stop;

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    #[command(subcommand)]
    command: Command,
}

#[derive(Debug, clap::Subcommand)]
enum Command {
    /// Work out which scans a campaign file asks for, and write them down with hashes of all that they depend on
    Plan(Plan),
    /// Do tasks of a planned campaign: all, those of a shard, or some by name. What is done is left out
    Run(RunArguments),
    /// Say what of a campaign is there and what is missing. Exit code 4 if something is
    Status(Status),
    /// Put the results together: tables, pictures, a page, and the scan.json of each scan. Exit code 1 if there are hazards
    Merge(Merge),
}

#[derive(Debug, clap::Args)]
struct Plan {
    /// The campaign file
    path: PathBuf,
    /// Folder for the campaign (default: out/<its name>)
    #[arg(long)]
    out: Option<PathBuf>,
}

#[derive(Debug, clap::Args)]
struct RunArguments {
    /// Folder of the campaign
    folder: PathBuf,
    /// Only every Nth task, beginning with the Ith: what one of N machines does
    #[arg(long, value_name = "I/N", value_parser = shard)]
    shard: Option<(usize, usize)>,
    /// Only the task of this name; may be given several times
    #[arg(long, value_name = "ID", conflicts_with = "shard")]
    task: Vec<String>,
    /// Threads (default: one a core): as many tasks at a time; the results are the same
    #[arg(long)]
    workers: Option<usize>,
    #[command(flatten)]
    hosting: HostingArguments,
}

#[derive(Debug, clap::Args)]
struct Status {
    /// Folder of the campaign
    folder: PathBuf,
    /// Print the names of all tasks that have no result, one a line, and nothing else
    #[arg(long)]
    missing: bool,
    /// Print the names of all tasks, one a line, and nothing else
    #[arg(long, conflicts_with = "missing")]
    tasks: bool,
}

#[derive(Debug, clap::Args)]
struct Merge {
    /// Folder of the campaign
    folder: PathBuf,
    /// Work out here what has no result, instead of refusing
    #[arg(long)]
    work_out_missing: bool,
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
    match &arguments.command {
        Command::Plan(own) => plan_it(own),
        Command::Run(own) => run_it(own),
        Command::Status(own) => tell_status(own),
        Command::Merge(own) => merge_it(own),
    }
}

fn plan_it(own: &Plan) -> Result<u8, Failure> {
    let out = match &own.out {
        Some(out) => out.clone(),
        None => Path::new("out").join(file_name(&Description::read(&own.path)?.0.name)),
    };
    let manifest = plan(&own.path, &out)?;
    let (cells, scans, tasks) = (manifest.cells.len(), manifest.scans.len(), manifest.tasks().len());
    let plural = |n: usize, one: &str| if n == 1 { format!("1 {one}") } else { format!("{n} {one}s") };
    let words = [plural(cells, "cell"), plural(scans, "scan"), plural(tasks, "task")].join(", ");
    output::result(&format!("{}: {words}\n", manifest.campaign));
    output::note(&format!(" Plan    {}", out.join(MANIFEST).display()));
    output::note(&format!(" Next    fmi-hazard campaign run {}", out.display()));
    Ok(exit::NO_HAZARD)
}

fn run_it(own: &RunArguments) -> Result<u8, Failure> {
    let manifest = Manifest::read(&own.folder)?;
    let which = match (own.shard, own.task.as_slice()) {
        (Some((number, of)), _) => Which::Shard(number, of),
        (None, []) => Which::All,
        (None, names) => Which::Named(names.to_vec()),
    };
    let tasks = which.tasks(&manifest)?;
    let stop = Stop::default();
    let hosting = own.hosting.heeding(&stop)?;
    stopping::by_signals(&stop);
    let tell = |told: CampaignEvent<'_>| match told {
        CampaignEvent::Skipped => {}
        CampaignEvent::TaskStarted(name, words) => output::note(&format!("   Begins  {name}: {words}")),
        CampaignEvent::Done(name, seconds) => output::note(&format!("   Done    {name} in {seconds:.1} s")),
        CampaignEvent::Failed(name, error) => {
            output::warning(&format!("task {name} failed"));
            output::failed(&Failure::from(error));
        }
    };
    let ran = run_tasks(&own.folder, &manifest, &tasks, &hosting, (workers(own.workers), &stop), &tell)?;
    output::result(&format!(
        "{} tasks: {} done now, {} before, {} failed, {} left\n",
        tasks.len(),
        ran.done,
        ran.skipped,
        ran.failed,
        tasks.len() - ran.done - ran.skipped - ran.failed
    ));
    Ok(if ran.stopped {
        output::note(" Stopped: what was finished is kept. Run the same again to go on");
        exit::INTERRUPTED
    } else if ran.failed > 0 {
        exit::FMU_FAILED
    } else {
        exit::NO_HAZARD
    })
}

fn tell_status(own: &Status) -> Result<u8, Failure> {
    let manifest = Manifest::read(&own.folder)?;
    if own.tasks {
        let names: String = manifest.tasks().into_iter().map(|task| manifest.name(task) + "\n").collect();
        output::result(&names);
        return Ok(exit::NO_HAZARD);
    }
    let state = status(&own.folder, &manifest);
    let code = if state.missing.is_empty() { exit::NO_HAZARD } else { exit::INCONCLUSIVE };
    if own.missing {
        output::result(&state.missing.iter().map(|task| manifest.name(*task) + "\n").collect::<String>());
        return Ok(code);
    }
    let of = state.done.len() + state.missing.len();
    let mut text =
        format!("{}: {} of {of} tasks done, in {:.1} s of work\n", manifest.campaign, state.done.len(), state.seconds);
    for task in state.missing.iter().take(MOST_TOLD) {
        let word = if state.damaged.contains(task) { "damaged" } else { "missing" };
        let part = task.part.map_or_else(String::new, |part| format!(", part {} of {}", part.number, part.of));
        text += &format!("  {word}  {}: {}{part}\n", manifest.name(*task), manifest.words(task.scan));
    }
    if state.missing.len() > MOST_TOLD {
        text += &format!("  and {} more (--missing names them all)\n", state.missing.len() - MOST_TOLD);
    }
    if state.others > 0 {
        text += &format!("  {} results are of what is not planned any more, and are not taken\n", state.others);
    }
    output::result(&text);
    Ok(code)
}

/// Most missing tasks that are told one by one.
const MOST_TOLD: usize = 20;

fn merge_it(own: &Merge) -> Result<u8, Failure> {
    let manifest = Manifest::read(&own.folder)?;
    let stop = Stop::default();
    let hosting = own.hosting.heeding(&stop)?;
    stopping::by_signals(&stop);
    let mut tell = |done: usize, of: usize| output::phase(&format!("putting scan {} of {of} together", done + 1));
    let merged =
        merge(&own.folder, &manifest, &hosting, (workers(own.workers), &stop), own.work_out_missing, &mut tell)?;
    let Some((survey, merged)) = merged else {
        output::note(" Stopped before all was put together. Run the same again to go on");
        return Ok(exit::INTERRUPTED);
    };
    match own.format {
        Format::Json => output::json_of(&survey)?,
        Format::Table => output::result(&survey.render()),
    }
    if merged.worked_out > 0 {
        let were = if merged.worked_out == 1 { "task had no result and was" } else { "tasks had no result and were" };
        output::note(&format!(" {} {were} worked out here", merged.worked_out));
    }
    if merged.looked_up + merged.unanswered > 0 {
        output::note(&format!(
            " {} questions of divided searches were answered by their parts, {} were worked out here",
            merged.looked_up, merged.unanswered
        ));
    }
    output::note(&format!(" Report  {}", own.folder.join("campaign.html").display()));
    Ok(match survey.state() {
        State::Hazards => exit::HAZARDS,
        State::Open => exit::INCONCLUSIVE,
        State::None => exit::NO_HAZARD,
    })
}

fn workers(asked: Option<usize>) -> usize {
    asked.unwrap_or_else(|| std::thread::available_parallelism().map_or(1, Into::into))
}

/// A shard as `2/8`.
fn shard(text: &str) -> Result<(usize, usize), String> {
    let numbers = text.split_once('/').and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((number, of)) if number >= 1 && number <= of => Ok((number, of)),
        _ => Err("give it as 2/8: the second of eight".to_owned()),
    }
}
