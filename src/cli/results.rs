//! The files with the results of a scan, all made from the report that also stands in `scan.json`.

use std::path::Path;

use percent_encoding::{AsciiSet, CONTROLS, utf8_percent_encode};

use super::exit::Failure;
use super::output;
use crate::cell::workcell::Link;
use crate::host::FmuUsage;
use crate::host::isolation::LastLines;
use crate::host::selftest::StateRestore;
use crate::record::cause::Cause;
use crate::record::hazard::Hazard;
use crate::record::model::ScanReport;
use crate::record::reachability::ReachabilityResult;
use crate::report::assessment::{self, Assessments};
use crate::report::baseline::Baseline;
use crate::report::page::Replay;
use crate::report::sarif::{self, CellFile};
use crate::report::{csv, junit, page, top_view, trace};
use crate::scan::initial_condition::Runs;
use crate::scan::moved;
use crate::scan::{Prepared, StateChoice, replay, top_view_data};
use crate::sim::simulation::RecordedRun;
use path_clean::clean;

/// Most hazards for which a picture is drawn and a trace is written.
const PICTURES: usize = 10;

/// Most hazards with a replay in the page: so that it can be mailed.
const REPLAYS: usize = 36;

/// What goes into the files besides the report.
pub(super) struct Context<'a> {
    /// The cell that was scanned.
    pub prepared: &'a Prepared,
    /// How its states were brought back.
    pub rung: StateRestore,
    /// What was scanned, as given: the cell file, or an FMU.
    pub path: &'a Path,
    /// The command that gives the same result, in the folder of the results.
    pub reproduce: &'a str,
    /// Hazards that are known already.
    pub baseline: Option<&'a Baseline>,
    /// What people decided.
    pub assessments: &'a Assessments,
    /// What is known of people from anywhere, if that was looked at.
    pub whole: Option<&'a ReachabilityResult>,
}

/// What people decided about this cell's hazards.
pub(super) fn assessments(path: &Path) -> Result<Assessments, Failure> {
    assessment::beside(path).map_err(|error| {
        Failure::unusable_with_help(
            error,
            "it is yours and never written here: mend it, or save it anew from the report",
        )
    })
}

/// Writes everything that is derived from the report. Returns what stands in `scan.json`.
pub(super) fn write(report: &ScanReport, context: &Context<'_>, out: &Path) -> Result<String, Failure> {
    let report = &moved::relative(report, out);
    let json = output::pretty(report)?;
    output::write_file(&out.join("scan.json"), &json)?;
    // The log of the search is written again with what confirmation added, in the order of scan.json.
    let lines = report.hazards.iter().map(serde_json::to_string).collect::<Result<Vec<_>, _>>();
    let lines: String = lines.map_err(Failure::unusable)?.into_iter().map(|l| l + "\n").collect();
    output::write_file(&out.join("hazards.jsonl"), &lines)?;
    let hazards = csv::hazards(report, context.assessments).map_err(Failure::unusable)?;
    output::write_file(&out.join("hazards.csv"), &hazards)?;
    let causes = csv::causes(report, context.assessments).map_err(Failure::unusable)?;
    output::write_file(&out.join("causes.csv"), &causes)?;
    let cases = junit::render(report, context.baseline).map_err(Failure::unusable)?;
    output::write_file(&out.join("junit.xml"), &cases)?;
    let log = sarif::render(report, &cell_file(context), context.baseline);
    output::write_file(&out.join("hazards.sarif"), &(output::pretty(&log)?))?;
    let replays = write_hazards(report, context, out)?;
    let scenery = replay::scenery(context.prepared);
    let title = report.subject.title();
    let page = page::render(report, &title, context.reproduce, context.assessments, &scenery, &replays, context.whole);
    output::write_file(&out.join("report.html"), &page.map_err(Failure::unusable)?)?;
    Ok(json)
}

/// Runs the worst hazards' sequences once more, writes their pictures and traces, and returns their replays.
fn write_hazards(report: &ScanReport, context: &Context<'_>, out: &Path) -> Result<Vec<Replay>, Failure> {
    let prepared = context.prepared;
    let hazards = shown(&report.causes, &report.hazards, &[]);
    replays(prepared, context.rung, &hazards, |number, hazard, (there, watched), svg| {
        if number >= PICTURES {
            return Ok(());
        }
        output::write_file(&out.join(format!("{}.svg", hazard.id)), svg)?;
        let traced = match replay::trace(there, watched) {
            Ok(trace) => trace,
            Err(error) => {
                if !error.stopped {
                    output::warning(&format!("{} has no trace: {error}", hazard.id));
                }
                None
            }
        };
        if let Some(trace) = traced {
            let (inputs, outputs) = (trace.input_table(), trace.output_table());
            output::write_file(&out.join(trace::input_file(hazard)), &inputs.map_err(Failure::unusable)?)?;
            output::write_file(&out.join(trace::output_file(hazard)), &outputs.map_err(Failure::unusable)?)?;
        }
        Ok(())
    })
}

/// The replays of hazards, each of whose sequences is run once more; `each` hears of it, with the picture from above.
pub(super) fn replays(
    prepared: &Prepared,
    rung: StateRestore,
    hazards: &[&Hazard],
    mut each: impl FnMut(usize, &Hazard, (&Prepared, &RecordedRun), &str) -> Result<(), Failure>,
) -> Result<Vec<Replay>, Failure> {
    let mut replays = Vec::new();
    if hazards.is_empty() {
        return Ok(replays);
    }
    // As a hazard is confirmed: no saved state is relied on here.
    let plainly = if rung == StateRestore::Processes { StateChoice::Process } else { StateChoice::Replay };
    let untold = |from: usize| {
        let of = hazards.len();
        output::note(&format!("   Stopped: {} of {of} hazards have no picture and no replay in the report", of - from));
    };
    let mut runs = match Runs::new(prepared, plainly, hazards.iter().copied()) {
        Err(error) if error.stopped => {
            untold(0);
            return Ok(replays);
        }
        Ok(started) => started,
        // What was found is told all the same.
        Err(error) => {
            output::warning(&format!("no hazard has a picture and a replay: {error}"));
            return Ok(replays);
        }
    };
    for (number, hazard) in hazards.iter().enumerate() {
        let (there, watched) = match runs.watch(hazard) {
            Ok(watched) => watched,
            Err(error) if error.stopped => {
                untold(number);
                break;
            }
            // An FMU that does not repeat itself, say: the hazard is told all the same.
            Err(error) => {
                output::warning(&format!("{} has no picture and no replay: {error}", hazard.id));
                continue;
            }
        };
        let svg = top_view::render(&top_view_data::scene(&there, hazard, &watched));
        each(number, hazard, (&there, &watched), &svg)?;
        replays.push(replay::record(&there, hazard, &watched, svg));
    }
    Ok(replays)
}

/// The hazards with a replay: those that are asked for, the worst of each cause, the worst of each region and link in it,
/// then the others by rank.
pub(super) fn shown<'a>(causes: &[Cause], hazards: &'a [Hazard], asked: &[String]) -> Vec<&'a Hazard> {
    let worst = causes.iter().map(|cause| &cause.worst);
    let lines = causes.iter().flat_map(|cause| cause.lines.iter().flat_map(|line| line.hazards.first()));
    let mut ids: Vec<&String> = asked.iter().collect();
    for id in worst.chain(lines).chain(hazards.iter().map(|hazard| &hazard.id)) {
        if ids.len() < REPLAYS.max(asked.len()) && !ids.contains(&id) {
            ids.push(id);
        }
    }
    ids.into_iter().filter_map(|id| hazards.iter().find(|hazard| hazard.id == *id)).collect()
}

/// Failures whose last lines are shown: the others are most often the same one elsewhere, and stand in run.json.
const MOST_FAILURES: usize = 1;

/// How the scan went, which is no result: run.json, and what the FMU printed.
pub(super) fn write_run(
    prepared: &Prepared,
    rung: StateRestore,
    (effort, remembered): (FmuUsage, u64),
    reproduce: &str,
    out: &Path,
) -> Result<(), Failure> {
    let (printed, bytes) = prepared.printed();
    let failures = prepared.before_failures();
    let run = serde_json::json!({
        "states_by": rung,
        "reproduce": reproduce,
        "fmu": effort,
        "questions_from_journal": remembered,
        "missing_protection": prepared.missing_protection,
        "fmu_printed_bytes": bytes,
        "printed_before_failures": failures,
    });
    let text = output::pretty(&run)?;
    output::write_file(&out.join("run.json"), &text)?;
    for LastLines { failure, printed } in failures.iter().take(MOST_FAILURES) {
        output::note(&format!(
            "   Note    {failure}. The last lines that it printed:\n             {}",
            printed.join("\n             ")
        ));
    }
    if bytes > 0 {
        output::write_file(&out.join("fmu.log"), &printed)?;
        output::note(&format!(
            "   Note    the FMU printed {bytes} bytes, the first megabyte of it is in {}",
            out.join("fmu.log").display()
        ));
    }
    Ok(())
}

/// What stands for something else in a URI path.
const ESCAPED: &AsciiSet =
    &CONTROLS.add(b' ').add(b'"').add(b'#').add(b'%').add(b'<').add(b'>').add(b'?').add(b'`').add(b'{').add(b'}');

/// Where findings are shown: seen from the folder of the scan, which is that of the repository where pipelines read it.
fn cell_file(context: &Context<'_>) -> CellFile {
    let uri_of = |path: &Path| {
        let text = utf8_percent_encode(&path.to_string_lossy(), ESCAPED).to_string();
        if path.is_absolute() { format!("file://{text}") } else { text }
    };
    let uri = uri_of(context.path);
    // A cell file inside an FMU has no lines that anything could show.
    let own = context.path.extension().is_some_and(|extension| extension == "toml");
    let links = context.prepared.cell.links.iter().filter(|_| own);
    // A file that it extends is found from its folder.
    let seen = |base: &Path| {
        let path = clean(context.path.parent().unwrap_or(Path::new("")).join(base));
        uri_of(&path)
    };
    let place = |link: &Link| (link.place.base.as_deref().map(seen), link.place.line);
    CellFile { uri, lines: links.map(|link| (link.name.clone(), place(link))).collect() }
}
