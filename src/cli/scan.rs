//! `fmi-hazard scan`: search a cell for hazards.

use std::collections::BTreeSet;
use std::io::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, LazyLock};

use clap::builder::PossibleValue;
use clap::{Parser as _, ValueEnum};

use super::exit::{self, Failure};
use super::hosting::HostingArguments;
use super::output::{self, Levels, Progress};
use super::resume::{self, Command};
use super::{compare, results};
use crate::report::baseline::Baseline;
use crate::report::model::{Hazard, ScanReport, Verdict};
use crate::report::terminal;
use crate::scan::prepare::prepare_in;
use crate::scan::run::Method;
use crate::scan::{self, Exhaustive, Prepared, ScanOptions, StateChoice, StrategyName};
use crate::search::exhaustive::Budget;
use crate::sim::expansion::Merge;
use crate::sim::journal::Journal;

/// How the result is printed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum Format {
    /// For people.
    #[default]
    Table,
    /// What also stands in scan.json.
    Json,
}

/// When a scan is over.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, ValueEnum)]
enum StopAt {
    /// At the first hazard; auto then ends with its quick part, if that found one.
    First,
    /// When the budget is spent.
    #[default]
    Budget,
}

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A cell file (.toml), or an FMU with a cell file beside it or inside it
    #[arg(required_unless_present = "resume")]
    path: Option<PathBuf>,
    /// Go on with the interrupted scan whose results are in this folder, as it was started; it ends with the same result
    /// as one that was not interrupted
    #[arg(long, value_name = "DIR", exclusive = true)]
    resume: Option<PathBuf>,
    /// The cell file of an FMU that has none of its own
    #[arg(long)]
    cell: Option<PathBuf>,
    /// How sequences are chosen
    #[arg(long, value_enum, default_value = "auto")]
    strategy: Choice,
    /// Seed of the random generator (default: the cell's, else 1)
    #[arg(long)]
    seed: Option<u64>,
    /// Sequences to try; for auto, in its quick part (default: the cell's, else 320 as in the paper)
    #[arg(long, value_parser = clap::value_parser!(u32).range(1..))]
    iterations: Option<u32>,
    /// When to stop
    #[arg(long, value_enum, default_value_t)]
    stop_at: StopAt,
    /// Folder for the results (default: out/<cell name>)
    #[arg(long)]
    out: Option<PathBuf>,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    /// Results of an earlier scan whose hazards are known: the exit code, JUnit and SARIF then tell of new and worse ones
    #[arg(long, value_name = "SCAN")]
    baseline: Option<PathBuf>,
    /// Check only the posture of each sequence, so that iterations compare with the paper's
    #[arg(long)]
    paper_iterations: bool,
    /// How FMU states are brought back; the results are the same
    #[arg(long, value_enum, default_value_t)]
    state: StateChoice,
    #[command(flatten)]
    hosting: HostingArguments,
    #[command(flatten)]
    exhaustive: ExhaustiveArguments,
}

/// How a scan searches: one of the strategies, all sequences, or both.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Choice {
    Auto,
    Exhaustive,
    One(StrategyName),
}

impl ValueEnum for Choice {
    fn value_variants<'a>() -> &'a [Self] {
        static ALL: LazyLock<Vec<Choice>> = LazyLock::new(|| {
            let strategies = StrategyName::value_variants().iter().map(|&name| Choice::One(name));
            [Choice::Auto, Choice::Exhaustive].into_iter().chain(strategies).collect()
        });
        &ALL
    }

    fn to_possible_value(&self) -> Option<PossibleValue> {
        match self {
            Self::Auto => Some(PossibleValue::new("auto").help(
                "First `hybrid`, so that something is there soon; then `exhaustive`, as far as the budget goes",
            )),
            Self::Exhaustive => Some(PossibleValue::new("exhaustive").help(
                "Every sequence there is, equal states once: a complete list of hazards, or the proof that there is none \
                 in the model",
            )),
            Self::One(name) => name.to_possible_value(),
        }
    }
}

#[derive(Debug, clap::Args)]
#[command(next_help_heading = "Exhaustive search")]
struct ExhaustiveArguments {
    /// Most distinct states
    #[arg(long, default_value_t = 20_000_000)]
    max_states: usize,
    /// Most memory for states, MB
    #[arg(long, default_value_t = 4_000)]
    max_memory: usize,
    /// Most work of arm searches, millions of joint-angle boxes [default: 600 for auto, a few minutes; none for
    /// exhaustive]
    #[arg(long)]
    max_work: Option<u64>,
    /// How equal states of the FMU are told
    #[arg(long, value_enum, default_value_t)]
    merge: Merge,
    /// Threads (default: one a core); the result is the same
    #[arg(long)]
    workers: Option<usize>,
}

impl Default for ExhaustiveArguments {
    fn default() -> Self {
        Self { max_states: 20_000_000, max_memory: 4_000, max_work: None, merge: Merge::default(), workers: None }
    }
}

impl Arguments {
    fn method(&self) -> Method {
        let cores = || std::thread::available_parallelism().map_or(1, Into::into);
        if let Choice::One(name) = self.strategy {
            return Method::Strategy(name);
        }
        let own = &self.exhaustive;
        let auto = self.strategy == Choice::Auto;
        let work = own.max_work.or_else(|| auto.then_some(AUTO_WORK)).map_or(u64::MAX, |w| w * 1_000_000);
        let budget = Budget { states: own.max_states, bytes: own.max_memory * 1_000_000, work, drop: true };
        let how = Exhaustive { budget, merge: own.merge, workers: own.workers.unwrap_or_else(cores) };
        if auto { Method::Auto(StrategyName::default(), how) } else { Method::Exhaustive(how) }
    }
}

impl Arguments {
    /// What the demo runs: the quick search alone, `iterations` sequences.
    pub(super) fn for_demo(path: PathBuf, out: PathBuf, iterations: u32) -> Self {
        Self {
            path: Some(path),
            resume: None,
            cell: None,
            strategy: Choice::One(StrategyName::Hybrid),
            seed: None,
            iterations: Some(iterations),
            stop_at: StopAt::default(),
            out: Some(out),
            format: Format::default(),
            baseline: None,
            paper_iterations: false,
            state: StateChoice::default(),
            hosting: HostingArguments::default(),
            exhaustive: ExhaustiveArguments::default(),
        }
    }
}

/// Work of the exhaustive part of `auto`, millions of boxes.
const AUTO_WORK: u64 = 600;

/// The arguments of a scan, alone.
#[derive(clap::Parser)]
#[command(no_binary_name = true)]
struct Alone {
    #[command(flatten)]
    arguments: Arguments,
}

/// The command: a scan, or the rest of one.
pub(super) fn command(arguments: &Arguments) -> Result<u8, Failure> {
    let Some(out) = &arguments.resume else {
        return run_as(arguments, Command::of_this_process(), false);
    };
    let command = Command::of_scan(out)?;
    let first = Alone::try_parse_from(&command.arguments).map_err(Failure::unusable)?;
    std::env::set_current_dir(&command.folder)
        .map_err(|e| Failure::unusable(format!("cannot go back to {}: {e}", command.folder.display())))?;
    output::note(&format!("   Resumed fmi-hazard scan {}", command.arguments.join(" ")));
    run_as(&first.arguments, Some(command), true)
}

/// A scan that nobody goes on with.
pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    run_as(arguments, None, false)
}

fn run_as(arguments: &Arguments, command: Option<Command>, goes_on: bool) -> Result<u8, Failure> {
    let Some(path) = &arguments.path else { return Err(Failure::unusable("no cell is named")) };
    let cell_path = arguments.cell.as_deref().unwrap_or(path);
    let baseline = arguments.baseline.as_deref().map(compare::read).transpose()?.map(Baseline::of);
    let baseline = baseline.as_ref();
    let assessments = results::assessments(cell_path)?;
    let prepared = prepare_in(path, arguments.cell.as_deref(), &arguments.hosting.hosting()?)?;
    // Before anything is told: whoever reads it may interrupt.
    let stop = stop_flag();
    introduce(&prepared, arguments.state);
    let options = ScanOptions {
        method: arguments.method(),
        seed: arguments.seed.unwrap_or(prepared.cell.search.seed),
        iterations: arguments.iterations.unwrap_or(prepared.cell.search.iterations),
        stop_at_first: arguments.stop_at == StopAt::First,
        posture_sweep: !arguments.paper_iterations,
        state: arguments.state,
    };
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(file_name(&prepared.cell.name)));
    let cannot = |e: std::io::Error| Failure::unusable(format!("cannot write results to {}: {e}", out.display()));
    std::fs::create_dir_all(&out).map_err(cannot)?;
    let journal = match &command {
        Some(command) => {
            command.write(&out)?;
            resume::journal(&out, &prepared, goes_on)?
        }
        None => Journal::default(),
    };
    let mut log = std::fs::File::create(out.join("hazards.jsonl")).map_err(cannot)?;
    let iterating = !matches!(options.method, Method::Exhaustive(_));
    let mut progress = Progress::new(if iterating { u64::from(options.iterations) } else { 1 }, "iterations");
    let mut logged = BTreeSet::new();
    let mut levels = Levels::new(prepared.cell.search.actions);
    let mut tell = |event: scan::Progress<'_>| {
        match event {
            scan::Progress::Working => {}
            scan::Progress::Iteration { done, hazards } => {
                progress.at(u64::from(done), &format!("{hazards} hazard{}", if hazards == 1 { "" } else { "s" }));
            }
            scan::Progress::Level { depth, done, of, hazards } => {
                progress.finish();
                let s = if hazards == 1 { "" } else { "s" };
                levels.at(depth, done, of, &format!("{hazards} hazard{s}"));
            }
            scan::Progress::Found(hazard) => {
                // One line each would bury the terminal where an exhaustive search, which has no iterations, finds
                // hundreds; what auto found before is not told again.
                if hazard.first_iteration > 0 {
                    progress.line(&found(hazard));
                }
                if logged.insert(hazard.id.clone()) {
                    // A full disk must not end the search: scan.json at the end reports the problem.
                    let line = serde_json::to_string(hazard).unwrap_or_default();
                    let _ = writeln!(log, "{line}").and_then(|()| log.flush());
                }
            }
        }
        if stop.load(Ordering::Relaxed) { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let scan::Scanned { report, effort, remembered } = scan::scan_with(&prepared, options, journal, &mut tell)?;
    progress.finish();
    levels.finish();
    let interrupted = stop.load(Ordering::Relaxed);
    let context = results::Context { prepared: &prepared, path: cell_path, baseline, assessments: &assessments };
    let json = results::write(&report, &context, &out)?;
    results::write_run(&prepared, effort, remembered, &out)?;
    match arguments.format {
        Format::Json => output::json(&json),
        Format::Table => output::result(&(String::from("\n") + &terminal::render(&report))),
    }
    conclude(&report, &out);
    if let Some(baseline) = baseline {
        against(&report, baseline);
    }
    if command.is_some() {
        if interrupted {
            output::note(&format!(" Go on: fmi-hazard scan --resume {}", out.display()));
        } else {
            resume::finished(&out);
        }
    }
    Ok(code(&report, baseline, interrupted))
}

fn code(report: &ScanReport, baseline: Option<&Baseline>, interrupted: bool) -> u8 {
    match report.verdict {
        _ if interrupted => exit::INTERRUPTED,
        Verdict::HazardsFound if baseline.is_some_and(|known| known.failing(report).next().is_none()) => {
            exit::NO_HAZARD
        }
        Verdict::HazardsFound => exit::HAZARDS,
        Verdict::NoneFound => exit::NO_HAZARD,
        Verdict::Inconclusive => exit::INCONCLUSIVE,
        Verdict::FmuFailed => exit::FMU_FAILED,
        Verdict::Interrupted => exit::INTERRUPTED,
    }
}

fn introduce(prepared: &Prepared, state: StateChoice) {
    let s = &prepared.subject;
    for fmu in &s.fmus {
        let unit = if fmu.unit.is_empty() { String::new() } else { format!("{} = ", fmu.unit) };
        let tool = if fmu.generation_tool.is_empty() { "tool unknown" } else { &fmu.generation_tool };
        output::note(&format!("   Loaded  {unit}{} (FMI {} co-simulation, {tool})", fmu.model_name, fmu.fmi_version));
    }
    output::note(&format!("   Cell    {} from {}", s.cell, s.cell_found));
    if s.fmus.len() > 1 {
        let order: Vec<&str> = s.fmus.iter().map(|fmu| fmu.unit.as_str()).collect();
        output::note(&format!("   Coupled {}, stepped in this order", order.join(", then ")));
    }
    for coupling in &s.couplings {
        output::note(&format!("           {coupling}"));
    }
    let how = match state {
        StateChoice::Auto => prepared.self_test.because(prepared.rung),
        StateChoice::Fmu => "saved FMU states, as asked".to_owned(),
        StateChoice::Fork => "copies of the FMU's process, as asked".to_owned(),
        StateChoice::Process => "a fresh process and replay, as asked".to_owned(),
        StateChoice::Replay => "every sequence from a fresh instance, as asked".to_owned(),
    };
    let bytes = prepared.self_test.bytes_per_state.map_or_else(String::new, |b| format!(", {b} bytes each"));
    output::note(&format!("   States  {how}{bytes}"));
    for missing in &prepared.missing_protection {
        output::note(&format!("   Warning protection against the FMU: {missing}"));
    }
    for warning in &prepared.binding.warnings {
        output::note(&format!("   Warning {warning}"));
    }
    for warning in prepared.fmus.iter().flat_map(crate::fmi::Fmu::warnings) {
        output::note(&format!("   Warning modelDescription.xml: {warning}"));
    }
}

fn found(h: &Hazard) -> String {
    format!(
        "     Found {}  {} <- {}  {:.0} N / {:.0} N  {:.2}x  after {} actions ({:.2} s), iteration {}",
        h.id,
        h.body_region,
        h.robot_link,
        h.force_n,
        h.limit_n,
        h.ratio,
        h.actions.len(),
        h.time_s,
        h.first_iteration
    )
}

fn conclude(report: &ScanReport, out: &Path) {
    output::note(&format!(
        " Results in {}: report.html, scan.json, hazards.csv, junit.xml, hazards.sarif{}",
        out.display(),
        match report.hazards.first() {
            Some(h) => format!(", {}.svg (seen from above)", h.id),
            None => String::new(),
        }
    ));
    if let Some(h) = report.hazards.first() {
        output::note(&format!(" Next: fmi-hazard replay {} {}", out.join("scan.json").display(), h.id));
    }
}

/// What is new against the hazards that are known.
fn against(report: &ScanReport, baseline: &Baseline) {
    let failing: Vec<&str> = baseline.failing(report).map(|hazard| hazard.id.as_str()).collect();
    let known = report.hazards.len() - failing.len();
    let gone = baseline.gone(report).count();
    let which = if failing.is_empty() { String::new() } else { format!(": {}", failing.join(", ")) };
    output::note(&format!(
        " Against the baseline: {} new or worse{which}; {known} known, {gone} not found again",
        failing.len()
    ));
}

/// Set by Ctrl-C and SIGTERM; the scan then ends after the iteration it is in.
fn stop_flag() -> Arc<AtomicBool> {
    let flag = Arc::new(AtomicBool::new(false));
    let handler = Arc::clone(&flag);
    // A second handler in one process cannot be set; the default (end at once) then stays.
    let _ = ctrlc::set_handler(move || handler.store(true, Ordering::Relaxed));
    flag
}

/// A folder name from a cell's name.
fn file_name(name: &str) -> String {
    let safe = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '-' };
    let name: String = name.chars().map(safe).collect();
    if name.trim_matches('.').is_empty() { "cell".to_owned() } else { name }
}
