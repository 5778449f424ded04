//! `fmi-hazard scan`: search a cell for hazards.

use std::collections::BTreeSet;
use std::io::{Seek as _, Write as _};
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use clap::Parser as _;

use super::changes::Telling;
use super::events::Event;
use super::exit::{self, Failure};
use super::output::{self, Format, Levels, Progress};
use super::resume::{self, Command};
pub(super) use super::scan_arguments::Arguments;
use super::scan_arguments::{From, StopAt};
use super::{anywhere, beginnings, earlier, results, stopping};
use crate::cell::file::validate::BASELINE;
use crate::host::selftest::Rung;
use crate::report::assessment::Assessments;
use crate::report::baseline::Baseline;
use crate::report::hazard::Hazard;
use crate::report::judged::measure_cell;
use crate::report::model::{BeginningSubject, ScanReport, Verdict};
use crate::report::{moved, terminal};
use crate::scan::advise::advise;
use crate::scan::options::Method;
use crate::scan::prepare::prepare_in;
use crate::scan::probe::wrong_polarities;
use crate::scan::{self, Prepared, ScanOptions, StateChoice};
use crate::sim::journal::Journal;
use crate::stop::Stop;

/// The arguments of a scan, alone.
#[derive(clap::Parser)]
#[command(no_binary_name = true)]
struct Alone {
    #[command(flatten)]
    arguments: Arguments,
    #[command(flatten)]
    verbosity: output::Verbosity,
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
    let assessments = results::assessments(cell_path)?;
    output::phase(&format!("trying out {}", path.display()));
    // Nothing is lost before the search: until then Ctrl-C ends the program.
    let (stop, began) = (Stop::default(), Instant::now());
    let mut prepared = tried_out(arguments, path, &stop)?;
    prepared.warn(wrong_polarities(&prepared));
    let from = arguments.people_from(&prepared.cell);
    let of_starts = arguments.of_starts().or_else(|| arguments.limit_of_starts());
    if let (From::Anywhere, Some(option)) = (from, of_starts) {
        return Err(Failure::unusable_with_help(
            format!("{option} is for scans from the cell's starts, and this one is from anywhere"),
            "leave it out, or add --from start",
        ));
    }
    if let (From::Start, Some(_)) = (from, arguments.until) {
        return Err(Failure::unusable_with_help(
            "--until is for scans from anywhere",
            "add --from anywhere; how long a scan from the cell's starts is says [search] actions in the cell file",
        ));
    }
    if let (From::Start | From::Both, Some(option)) = (from, arguments.of_anywhere()) {
        return Err(Failure::unusable_with_help(
            format!("{option} is for scans from anywhere alone"),
            "add --from anywhere",
        ));
    }
    if from == From::Anywhere {
        let several = false;
        let run = Run { arguments, path, cell_path, assessments: &assessments, stop: &stop, began, goes_on, several };
        return anywhere::run(&run, &prepared, command.as_ref());
    }
    let all = match arguments.begin {
        Some(number) => vec![prepared.beginning(number as usize - 1)?],
        // Each of them is looked at before any is searched: a wrong one is told at once.
        None => (0..prepared.cell.beginnings.len()).map(|b| prepared.beginning(b)).collect::<Result<_, _>>()?,
    };
    let several = all.len() > 1;
    if several && arguments.write_baseline {
        return Err(Failure::unusable_with_help(
            "a cell with several beginnings has a result for each of them, and no single baseline",
            "keep the whole folder with the results, and name it with --baseline",
        ));
    }
    // Before anything is told: whoever reads it may interrupt.
    stopping::by_signals(&stop);
    introduce(&prepared, arguments.state);
    let own = || {
        let of_cell = Path::new("out").join(file_name(&prepared.cell.name));
        let one = arguments.begin.filter(|_| prepared.cell.beginnings.len() > 1);
        one.map_or_else(|| of_cell.clone(), |number| of_cell.join(beginnings::folder(number as usize)))
    };
    let out = arguments.out.clone().unwrap_or_else(own);
    let cannot = |e: std::io::Error| Failure::unusable(format!("cannot write results to {}: {e}", out.display()));
    std::fs::create_dir_all(&out).map_err(cannot)?;
    anywhere::forget(&out);
    output::event(&Event::Results { folder: out.display().to_string() });
    if let Some(command) = &command {
        command.write(&out)?;
    }
    let run = Run { arguments, path, cell_path, assessments: &assessments, stop: &stop, began, goes_on, several };
    let journals = command.is_some();
    let baselines = all.iter().map(|prepared| run.baseline(prepared, prepared.subject.beginning.as_ref()));
    let baselines = baselines.collect::<Result<Vec<_>, _>>()?;
    let whole = if from == From::Both { anywhere::first(&run, &prepared, &out, journals)? } else { None };
    if whole == Some(exit::INTERRUPTED) {
        output::note(&format!(" Go on: fmi-hazard scan --resume {}", out.display()));
        return Ok(exit::INTERRUPTED);
    }
    let code = if several {
        run.all(&all, &baselines, &out, journals)?
    } else {
        beginnings::forget(&out);
        if let Some(time) = run.time_left() {
            stop.within(time);
        }
        if whole.is_some() && arguments.format == Format::Table {
            output::result("\nFrom the cell's start");
        }
        run.one(&all[0], baselines[0].as_ref(), &out, journals)?.code
    };
    if journals {
        if stop.is_asked() {
            output::note(&format!(" Go on: fmi-hazard scan --resume {}", out.display()));
        } else {
            resume::finished(&out, false);
        }
    }
    // Nobody hit from one start says nothing against somebody hit from elsewhere, or against what is not known of others.
    Ok(match whole {
        Some(exit::HAZARDS) if code != exit::INTERRUPTED => exit::HAZARDS,
        Some(exit::INCONCLUSIVE) if code == exit::NO_HAZARD => exit::INCONCLUSIVE,
        _ => code,
    })
}

/// One run of the command.
pub(super) struct Run<'a> {
    pub(super) arguments: &'a Arguments,
    pub(super) path: &'a Path,
    pub(super) cell_path: &'a Path,
    pub(super) assessments: &'a Assessments,
    pub(super) stop: &'a Stop,
    /// When its time began.
    began: Instant,
    /// Whether it goes on with an interrupted one.
    pub(super) goes_on: bool,
    /// Whether the cell is searched from several beginnings.
    several: bool,
}

/// What came out of a search.
struct Ended {
    report: ScanReport,
    code: u8,
}

/// The cell with its FMU tried out, which is part of the time that is given.
fn tried_out(arguments: &Arguments, path: &Path, stop: &Stop) -> Result<Prepared, Failure> {
    let hosting = arguments.hosting.heeding(stop)?;
    let Some(time) = arguments.time() else {
        return Ok(prepare_in(path, arguments.cell.as_deref(), &hosting)?);
    };
    let began = Instant::now();
    stop.within(time);
    match prepare_in(path, arguments.cell.as_deref(), &hosting) {
        Err(error) if !(error.while_running() && stop.ends_search()) => Err(error.into()),
        Ok(prepared) if !stop.ends_search() => Ok(prepared),
        // What it says of the FMU then is about the time that it had.
        _ => Err(Failure::inconclusive(
            format!(
                "the time was over while the FMU was tried out: after {:.1} s of {} s nothing was searched yet",
                began.elapsed().as_secs_f64(),
                time.as_secs_f64()
            ),
            "give it more with --time. Each FMU is run some ten times first, for as long as a sequence takes where its steps are \
             quick; `fmi-hazard inspect --self-test` shows how long its steps take",
        )),
    }
}

impl Run<'_> {
    /// What is left of the time that is given.
    pub(super) fn time_left(&self) -> Option<Duration> {
        Some(self.arguments.time()?.saturating_sub(self.began.elapsed()))
    }

    /// One beginning after the other.
    fn all(&self, all: &[Prepared], baselines: &[Option<Baseline>], out: &Path, journals: bool) -> Result<u8, Failure> {
        let mut table = beginnings::Table::begun(out, &all[0].subject, self.goes_on);
        table.keep(out)?;
        let mut left = all.iter().filter(|prepared| !table.has(prepared.cell.beginning + 1)).count();
        for (prepared, baseline) in all.iter().zip(baselines) {
            let number = prepared.cell.beginning + 1;
            if table.has(number) {
                continue;
            }
            // What one does not use of its time, the others have.
            if let Some(time) = self.time_left() {
                self.stop.within(time / u32::try_from(left).unwrap_or(1));
            }
            left -= 1;
            if let Some(beginning) = &prepared.subject.beginning {
                output::note(&format!("   Begins  {number} of {}: {}", all.len(), beginning.words()));
            }
            let own = out.join(beginnings::folder(number));
            let (hazards, code) = match self.one(prepared, baseline.as_ref(), &own, journals) {
                Ok(Ended { report, code }) => (report.hazards, code),
                // The others are searched all the same.
                Err(failure) if failure.code() == exit::FMU_FAILED => (Vec::new(), output::failed(&failure)),
                Err(failure) => return Err(failure),
            };
            if code == exit::INTERRUPTED {
                return Ok(code);
            }
            if journals {
                resume::finished(&own, false);
            }
            table.add(&prepared.subject, &hazards, code, out)?;
        }
        match self.arguments.format {
            Format::Json => output::json_of(&table)?,
            Format::Table => output::result(&table.render(out)),
        }
        Ok(table.exit_code())
    }

    /// A search from one beginning, and its results.
    fn one(
        &self,
        prepared: &Prepared,
        baseline: Option<&Baseline>,
        out: &Path,
        journals: bool,
    ) -> Result<Ended, Failure> {
        let Self { arguments, path, cell_path, assessments, stop, .. } = *self;
        let options = ScanOptions {
            method: arguments.method(),
            seed: arguments.seed.unwrap_or(prepared.cell.search.seed),
            iterations: arguments.iterations.unwrap_or(prepared.cell.search.iterations),
            stop_at_first: arguments.stop_at == StopAt::First,
            posture_sweep: !arguments.paper_iterations,
            state: arguments.state,
        };
        stop.searching();
        let cannot = |e: std::io::Error| Failure::unusable(format!("cannot write results to {}: {e}", out.display()));
        std::fs::create_dir_all(out).map_err(cannot)?;
        let journal = if journals { resume::journal(out, prepared, self.goes_on)? } else { Journal::default() };
        let before = self.goes_on.then(|| Before::of(out)).flatten();
        let mut log = std::fs::File::create(out.join(LOG)).map_err(cannot)?;
        let iterating = !matches!(options.method, Method::Exhaustive(_));
        let mut progress = Progress::new(if iterating { u64::from(options.iterations) } else { 1 }, "iterations");
        let mut logged = BTreeSet::new();
        let mut levels = Levels::new(prepared.cell.search.actions);
        let mut audit: Option<Progress> = None;
        let mut estimate = output::Estimate::new(prepared.cell.search.actions);
        let mut tell = |event: scan::Progress<'_>| {
            match event {
                scan::Progress::Working => {}
                scan::Progress::Shortening { done, of } => {
                    output::phase(&format!("looking for shorter sequences: {done} of {of} hazards"));
                }
                scan::Progress::Confirming { done, of } => {
                    output::phase(&format!("confirming from a fresh start: {done} of {of} hazards"));
                }
                scan::Progress::RunAgain { done, of } => {
                    output::phase(&format!("running what the FMU did again from the start: {done} of {of}"));
                    levels.finish();
                    audit.get_or_insert_with(|| Progress::new(of as u64, "runs from the start")).at(done as u64, "");
                }
                scan::Progress::SearchAgain { because } => {
                    progress.finish();
                    levels.finish();
                    output::warning(because);
                    // What was found so far does not count.
                    (audit, levels) = (None, Levels::new(prepared.cell.search.actions));
                    logged.clear();
                    let _ = log.set_len(0).and_then(|()| log.rewind());
                }
                scan::Progress::Iteration { done, hazards } => {
                    let s = if hazards == 1 { "" } else { "s" };
                    let told = format!("{hazards} hazard{s}");
                    output::phase(&format!("sequence {done} of at most {}, {told}", options.iterations));
                    progress.at(u64::from(done), &told);
                }
                scan::Progress::Level { depth, done, of, hazards, cost: _ } => {
                    progress.finish();
                    let s = if hazards == 1 { "" } else { "s" };
                    estimate.level(depth, done, of);
                    let left = estimate.left(stop.left());
                    output::phase(&format!(
                        "action {} of {}: {done}/{of} states, {hazards} hazard{s}{left}",
                        depth + 1,
                        prepared.cell.search.actions
                    ));
                    levels.at(depth, done, of, &format!("{hazards} hazard{s}{left}"));
                }
                scan::Progress::Found(hazard) => {
                    output::event(&Event::Hazard { hazard });
                    // One line each would bury the terminal; what auto found before is not told again.
                    if output::verbose() && hazard.first_iteration > 0 {
                        progress.line(&found(hazard));
                    }
                    if logged.insert(hazard.id.clone()) {
                        // A full disk must not end the search: scan.json at the end reports the problem.
                        let line = serde_json::to_string(hazard).unwrap_or_default();
                        let _ = writeln!(log, "{line}").and_then(|()| log.flush());
                    }
                }
            }
            if stop.ends_search() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
        };
        let began = Instant::now();
        let scan::Scanned { mut report, rung, effort, remembered } =
            scan::scan_with(prepared, options, journal, &mut tell)?;
        let searched = began.elapsed();
        progress.finish();
        levels.finish();
        if let Some(audit) = &audit {
            audit.finish();
        }
        output::phase("writing the results");
        let interrupted = stop.is_asked();
        if let Some(before) =
            before.filter(|before| report.verdict == Verdict::Interrupted || (interrupted && before.has_more(&report)))
        {
            before.put_back(out)?;
            output::note(&format!(
                " Stopped before it came as far as the scan that it goes on with: the results in {} are still those",
                out.display()
            ));
            return Ok(Ended { report, code: exit::INTERRUPTED });
        }
        let several = prepared.cell.beginnings.len() > 1;
        let beginning = several.then_some(prepared.cell.beginning + 1);
        let reproduce = &arguments.reproduce(path, out, beginning, Some(&options));
        let context =
            results::Context { prepared, rung, path: cell_path, reproduce, baseline, assessments, whole: None };
        let mut json = results::write(&report, &context, out)?;
        results::write_run(prepared, rung, (effort, remembered), reproduce, out)?;
        let written = began.elapsed() - searched;
        // What was found is kept by now, whatever becomes of the search for changes.
        if self.advise(prepared, rung, &mut report) {
            json = results::write(&report, &context, out)?;
        }
        let (advised, calls) = (began.elapsed() - searched - written, effort.steps);
        output::detail(&format!(
            "   Took    {:.1} s to search and confirm ({calls} FMU steps), {:.1} s to write the results, {:.1} s to look for \
             changes",
            searched.as_secs_f64(),
            written.as_secs_f64(),
            advised.as_secs_f64()
        ));
        match arguments.format {
            Format::Json if self.several => {}
            Format::Json => output::json(&json),
            Format::Table => output::result(&(String::from("\n") + &terminal::render(&report, output::view()))),
        }
        let code = self.conclude((prepared, &report, interrupted), baseline, out)?;
        Ok(Ended { report, code })
    }

    /// Tells where everything is and what is new, keeps the baseline if that is wanted, and gives the exit code.
    pub(super) fn conclude(
        &self,
        (prepared, report, interrupted): (&Prepared, &ScanReport, bool),
        baseline: Option<&Baseline>,
        out: &Path,
    ) -> Result<u8, Failure> {
        conclude(report, out);
        if let Some(baseline) = baseline {
            against(report, baseline);
        }
        if self.arguments.write_baseline {
            let path = self.baseline_path(prepared, report.subject.beginning.as_ref());
            let path = path.unwrap_or_else(|| self.cell_path.with_file_name(BASELINE));
            if !interrupted && matches!(report.verdict, Verdict::HazardsFound | Verdict::NoneFound(_)) {
                let beside = path.parent().unwrap_or(Path::new(""));
                output::write_file(&path, &output::pretty(&moved::relative(report, beside))?)?;
                output::note(&format!(" Baseline kept in {}: {} hazards", path.display(), report.hazards.len()));
            } else {
                output::warning(&format!(
                    "{} is not written: the scan has no result to hold others against",
                    path.display()
                ));
            }
        }
        Ok(code(report, baseline, interrupted))
    }

    /// Looks for changes that would be enough, and says whether there is something new to write: whoever interrupts that has
    /// all but it.
    fn advise(&self, prepared: &Prepared, rung: Rung, report: &mut ScanReport) -> bool {
        let stop = self.stop;
        let how = self
            .arguments
            .advice(&prepared.cell, self.several)
            .filter(|_| !report.causes.is_empty() && !stop.ends_search());
        let Some(how) = how else { return false };
        output::note("   Looking for changes that would be enough. Ctrl-C ends that and keeps the results");
        let telling = Telling::new(false);
        stop.searching();
        let advised = advise(prepared, rung, report, how, &|told| telling.hear(&told));
        stop.finishing();
        // The FMU may fail where nobody looked before: what was found stays.
        if let Err(error) = advised
            && !error.stopped
        {
            output::warning(&format!("changes were not looked for to the end: the FMU failed: {}", error.message));
        }
        !stop.is_asked() && report.causes.iter().any(|cause| cause.advice.is_some())
    }

    /// The hazards that are known from this beginning. Of one that a folder of earlier results has not, none is.
    pub(super) fn baseline(
        &self,
        prepared: &Prepared,
        beginning: Option<&BeginningSubject>,
    ) -> Result<Option<Baseline>, Failure> {
        if self.arguments.write_baseline {
            return Ok(None);
        }
        let named = self.arguments.baseline.is_some() || prepared.cell.baseline.is_some();
        match self.baseline_path(prepared, beginning) {
            Some(path) => known(&path, self.arguments).map(Some),
            None => Ok(named.then(Baseline::default)),
        }
    }

    /// The baseline: what the command line says, else what the cell says.
    fn baseline_path(&self, prepared: &Prepared, beginning: Option<&BeginningSubject>) -> Option<PathBuf> {
        let own = || prepared.cell.baseline.as_ref().map(|name| self.cell_path.with_file_name(name));
        let path = self.arguments.baseline.clone().or_else(own)?;
        // The folder with a scan's results, as everywhere.
        Some(if beginnings::are_in(&path) {
            match beginnings::same_in(&path, beginning) {
                Ok(found) => found?.join("scan.json"),
                // Reading it tells what is wrong with it.
                Err(table) => table,
            }
        } else if path.is_dir() {
            path.join("scan.json")
        } else {
            path
        })
    }
}

/// What an interrupted scan left, for one that goes on with it and is interrupted before it comes as far.
struct Before {
    hazards: Vec<String>,
    log: String,
}

impl Before {
    /// In this folder, if there is a result.
    fn of(out: &Path) -> Option<Self> {
        let recorded = earlier::read(out).ok()?;
        let log = std::fs::read_to_string(out.join(LOG)).ok()?;
        Some(Self { hazards: recorded.hazards.into_iter().map(|hazard| hazard.id).collect(), log })
    }

    /// Whether it holds a hazard that is not found again yet.
    fn has_more(&self, report: &ScanReport) -> bool {
        self.hazards.iter().any(|id| report.hazards.iter().all(|hazard| hazard.id != *id))
    }

    /// All but its log is still there.
    fn put_back(&self, out: &Path) -> Result<(), Failure> {
        output::write_file(&out.join(LOG), &self.log)
    }
}

/// The hazards as they are found.
const LOG: &str = "hazards.jsonl";

/// The hazards that a baseline holds.
fn known(path: &Path, arguments: &Arguments) -> Result<Baseline, Failure> {
    if arguments.baseline.is_none() && !path.exists() {
        return Err(Failure::unusable_with_help(
            format!("the cell's fail_on.baseline {} does not exist", path.display()),
            "write it with `fmi-hazard scan ... --write-baseline`, look at each of its hazards, and keep it beside the \
             cell file",
        ));
    }
    Ok(Baseline::of(earlier::read(path)?))
}

fn code(report: &ScanReport, baseline: Option<&Baseline>, interrupted: bool) -> u8 {
    match report.verdict {
        _ if interrupted => exit::INTERRUPTED,
        // Of what is not shown, others than the known ones may be left.
        Verdict::HazardsFound if baseline.is_some_and(|known| known.failing(report).next().is_none()) => {
            if report.obligations.clean().is_some() { exit::NO_HAZARD } else { exit::INCONCLUSIVE }
        }
        Verdict::HazardsFound => exit::HAZARDS,
        Verdict::NoneFound(_) => exit::NO_HAZARD,
        Verdict::Inconclusive => exit::INCONCLUSIVE,
        Verdict::FmuFailed => exit::FMU_FAILED,
        Verdict::Interrupted => exit::INTERRUPTED,
    }
}

pub(super) fn introduce(prepared: &Prepared, state: StateChoice) {
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
    for fmu in prepared.fmus.iter() {
        output::detail(&format!("   FMU     {}, sha256 {}", fmu.path().display(), fmu.sha256()));
    }
    let t = &prepared.self_test;
    output::detail(&format!(
        "   Tested  repeats itself {}; states restored {}; process copied {}; fresh process {}; reset {}",
        t.deterministic, t.restore, t.fork, t.fresh_process, t.reset
    ));
    for missing in &prepared.missing_protection {
        output::warning(&format!("protection against the FMU: {missing}"));
    }
    for warning in &prepared.warnings() {
        output::warning(warning);
    }
    for warning in prepared.fmus.iter().flat_map(crate::fmi::Fmu::warnings) {
        output::warning(&format!("modelDescription.xml: {warning}"));
    }
}

fn found(h: &Hazard) -> String {
    format!(
        "     Found {}  {} <- {}  {}  {:.2}x  after {} actions ({:.2} s), iteration {}",
        h.id,
        h.body_region,
        h.robot_link,
        measure_cell(h.class, h.judged.as_ref(), (h.deciding_force_n(), h.deciding_limit_n(), h.speed_m_s)),
        h.ratio,
        h.actions.len(),
        h.time_s,
        h.first_iteration
    )
}

fn conclude(report: &ScanReport, out: &Path) {
    let picture = report.hazards.first().map_or_else(String::new, |h| format!(", {}.svg (seen from above)", h.id));
    output::note(&format!(" Report  {}", out.join("report.html").display()));
    output::detail(&format!(
        "         and beside it scan.json, causes.csv, hazards.csv, junit.xml, hazards.sarif{picture}"
    ));
    if let Some(cause) = report.causes.first() {
        output::note(&format!(" Next    fmi-hazard explain {} {}", out.display(), cause.id));
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

/// A folder name from a cell's name.
pub(super) fn file_name(name: &str) -> String {
    let safe = |c: char| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '-' };
    let name: String = name.chars().map(safe).collect();
    if name.trim_matches('.').is_empty() { "cell".to_owned() } else { name }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::report::fixtures;
    use crate::scan::Hosting;

    /// There may be more than it found by then.
    #[test]
    fn an_interrupted_scan_is_not_kept_as_the_baseline() {
        let folder = tempfile::tempdir().unwrap();
        crate::examples::export(folder.path()).unwrap();
        let path = folder.path().join("safety-fence/cell.toml");
        let prepared = prepare_in(&path, None, &Hosting::InProcess(Stop::default())).unwrap();
        let mut arguments = Arguments::of_example(path.clone(), folder.path().to_owned(), 1);
        arguments.write_baseline = true;
        let (assessments, stop) = (Assessments::new(), Stop::default());
        let run = Run {
            arguments: &arguments,
            path: &path,
            cell_path: &path,
            assessments: &assessments,
            began: Instant::now(),
            stop: &stop,
            goes_on: false,
            several: false,
        };
        let report = fixtures::report(vec![fixtures::hazard("H-000001", 1.5)], Vec::new());
        let code = |interrupted: bool| run.conclude((&prepared, &report, interrupted), None, folder.path()).ok();
        let kept = path.with_file_name(BASELINE);
        assert_eq!((code(true), kept.exists()), (Some(exit::INTERRUPTED), false));
        assert_eq!((code(false), kept.exists()), (Some(exit::HAZARDS), true));
    }
}
