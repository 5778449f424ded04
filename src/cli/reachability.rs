//! `fmi-hazard scan --from anywhere`: people who come from where no sensor sees them, on any walk and at any moment.

use std::ops::ControlFlow;
use std::path::Path;
use std::time::{Duration, Instant};

use super::events::Event;
use super::exit::{self, Failure};
use super::introduction::introduce;
use super::output::{self, Format, Progress};
use super::resume::{self, Command};
use super::run::{Run, file_name};
use super::{initial_conditions, results, stopping};
use crate::cell::file::files::named_from;
use crate::record::model::Verdict;
use crate::record::reachability::{HarmfulPose, ReachabilityResult};
use crate::report::baseline::Baseline;
use crate::report::floor_map::FloorMap;
use crate::report::{floorplan, from_anywhere};
use crate::scan::reachability::{AnalysisEvent, AnalysisLimits, analyse, refusal};
use crate::scan::{Prepared, Scanned, top_view_data};
use crate::sim::answers::Answers;

/// Where the results are kept beside those of a scan from the starts.
const FOLDER: &str = "anywhere";
/// Where the result is kept.
const RESULT: &str = "anywhere.json";
/// There as long as the scan has not ended: what is in the folder is what was known when it was interrupted.
const UNFINISHED: &str = "unfinished";
/// The floor as a picture.
const FLOOR: &str = "floor.svg";
/// Steps of the progress bar.
const STEPS: u64 = 1000;

/// The command.
pub(super) fn run(run: &Run<'_>, prepared: &Prepared, command: Option<&Command>) -> Result<u8, Failure> {
    let Run { arguments, stop, .. } = *run;
    if let Some(reason) = refusal(prepared) {
        return Err(Failure::unusable(reason));
    }
    stopping::by_signals(stop);
    introduce(prepared, arguments.state);
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(file_name(&prepared.cell.name)));
    // It is about none of the cell's beginnings.
    let baseline = run.baseline(prepared, None)?;
    make(&out)?;
    if let Some(command) = command {
        command.write(&out)?;
    }
    output::event(&Event::Results { folder: out.display().to_string() });
    let answers = answers(run, prepared, &out, command.is_some())?.only(arguments.partition);
    let ReachabilityRun { code, cut_short } =
        look(run, prepared, baseline.as_ref(), (&out, run.time_left()), (&answers, false))?;
    if let (known @ 1.., all) = answers.remembered() {
        output::note(&format!("   Known   {known} of {all} questions were answered before"));
    }
    if command.is_some() {
        if cut_short {
            output::note(&format!(" Go on: fmi-hazard scan --resume {}", out.display()));
        } else {
            resume::finished(&out, arguments.partition.is_some());
        }
    }
    Ok(code)
}

/// Before a scan from the starts: with half of its time, in a folder of its own within `out`. The exit code; nothing where nobody
/// can be looked for anywhere, which is told.
pub(super) fn first(run: &Run<'_>, prepared: &Prepared, out: &Path, keeps: bool) -> Result<Option<u8>, Failure> {
    if let Some(reason) = refusal(prepared) {
        output::note(&format!("   From    the cell's starts only: {reason}"));
        // Who asked for both has no answer to one of them.
        let asked = run.arguments.asks_for_both(&prepared.cell);
        return Ok(asked.then_some(exit::INCONCLUSIVE));
    }
    let own = out.join(FOLDER);
    if run.goes_on {
        // Without the folder the first one was from the starts alone.
        let code = ended(&own);
        if code.is_some() || !own.is_dir() {
            return Ok(code);
        }
    }
    output::note(
        "   From    anywhere that no sensor sees, first; then from the cell's start (--from start: that alone)",
    );
    if run.arguments.format == Format::Table {
        output::result("\nFrom anywhere");
    }
    let unfinished = own.join(UNFINISHED);
    make(&own)?;
    // What an earlier scan left there is no result of this one, should it fail.
    forget(&own);
    output::write_file(&unfinished, "")?;
    let answers = answers(run, prepared, &own, keeps)?;
    let looked = look(run, prepared, None, (&own, run.time_left().map(|time| time / 2)), (&answers, true));
    if !matches!(looked, Ok(ReachabilityRun { code: exit::INTERRUPTED, .. })) {
        let _ = std::fs::remove_file(unfinished);
        resume::finished(&own, false);
    }
    match looked {
        Ok(ReachabilityRun { code, .. }) => Ok(Some(code)),
        // What is wrong with the FMU the scan from the starts tells, too.
        Err(failure) if failure.code() == exit::FMU_FAILED => {
            output::warning(&format!("from anywhere nothing is known: {}", failure.text()));
            Ok(Some(exit::INCONCLUSIVE))
        }
        Err(failure) => Err(failure),
    }
}

/// The answers in the folder of the results, with those of parts that ran elsewhere; none if nothing is kept there.
fn answers(run: &Run<'_>, prepared: &Prepared, out: &Path, keeps: bool) -> Result<Answers, Failure> {
    if !keeps {
        return Ok(Answers::default());
    }
    let from = format!("anywhere, until {}", run.arguments.extent());
    resume::answers(out, prepared, &from, run.goes_on, &run.arguments.parts)
}

/// Results of a scan from anywhere that do not belong to the one that begins.
pub(super) fn forget(out: &Path) {
    for file in [RESULT, FLOOR] {
        let _ = std::fs::remove_file(out.join(file));
    }
}

/// The exit code of the scan from anywhere that ended in a folder, if one did.
fn ended(out: &Path) -> Option<u8> {
    if out.join(UNFINISHED).exists() {
        return None;
    }
    let text = std::fs::read_to_string(out.join(RESULT)).ok()?;
    let found: serde_json::Value = serde_json::from_str(&text).ok()?;
    match serde_json::from_value(found["verdict"].clone()).ok()? {
        Verdict::HazardsFound => Some(exit::HAZARDS),
        Verdict::NoneFound(_) => Some(exit::NO_HAZARD),
        Verdict::Interrupted => None,
        Verdict::Inconclusive | Verdict::FmuFailed => Some(exit::INCONCLUSIVE),
    }
}

fn make(out: &Path) -> Result<(), Failure> {
    std::fs::create_dir_all(out)
        .map_err(|e| Failure::unusable(format!("cannot write results to {}: {e}", out.display())))
}

/// What came out.
struct ReachabilityRun {
    code: u8,
    /// Whether there is more to look at.
    cut_short: bool,
}

/// Looks, and writes the results; with others `beside`.
fn look(
    run: &Run<'_>,
    prepared: &Prepared,
    baseline: Option<&Baseline>,
    (out, time): (&Path, Option<Duration>),
    (answers, beside): (&Answers, bool),
) -> Result<ReachabilityRun, Failure> {
    let Run { arguments, path, cell_path, assessments, stop, .. } = *run;
    make(out)?;
    initial_conditions::forget(out);
    if let Some(time) = time {
        stop.within(time);
    }
    stop.searching();
    let began = Instant::now();
    let mut progress = Progress::new(STEPS, "of the floor");
    let mut tell = |told: AnalysisEvent| {
        match told {
            AnalysisEvent::States(states, most) => {
                output::phase(&format!("stepping the FMU: {states} states, {most} at most"))
            }
            AnalysisEvent::Behaviours(found, most) => {
                output::phase(&format!("looking for behaviours of the FMU: {found}, {most} at most"));
            }
            AnalysisEvent::Asked(share) => {
                output::phase(&format!("asking the FMU what its sensors report: {:.0} %", share * 100.0));
            }
            AnalysisEvent::RunAgain(done, of) => {
                output::phase(&format!("running again from the start: {done} of {of}"))
            }
            AnalysisEvent::Floor(share, hazards) => {
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "a share of a thousand steps"
                )]
                let done = (share * 1000.0) as u64;
                output::phase(&format!("looking everywhere: {:.0} % of the floor", share * 100.0));
                progress.at(done, &if hazards == 0 { String::new() } else { format!("{hazards} hazards") });
            }
        }
        if stop.ends_search() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    };
    let effort = AnalysisLimits {
        until: arguments.until(),
        workers: arguments.workers(),
        most_states: arguments.most_states(),
        presses: arguments.presses,
        state: arguments.state,
        answers,
    };
    let looked = analyse(prepared, effort, &mut tell)?;
    progress.finish();
    output::phase("confirming from a fresh start");
    let Scanned { report, rung, effort: did, .. } = looked.scanned(prepared, effort);
    let cut_short = looked.was_cut_short() || stop.is_asked();
    let found = looked.found;
    output::detail(&format!(
        "   Took    {:.1} s, {} FMU steps, {} sets of poses, {} arm searches",
        began.elapsed().as_secs_f64(),
        found.spent.fmu_steps,
        found.spent.boxes,
        found.spent.arm_checks
    ));
    output::phase("writing the results");
    let json = output::pretty(&found)?;
    output::write_file(&out.join(RESULT), &json)?;
    output::write_file(&out.join(FLOOR), &floorplan::render(&FloorMap::from(&found), &top_view_data::plan(prepared)))?;
    places(&found, cell_path, out)?;
    let interrupted = stop.is_asked();
    let reproduce = &arguments.reproduce(path, out, None, None);
    let context =
        results::Context { prepared, rung, path: cell_path, reproduce, baseline, assessments, whole: Some(&found) };
    results::write(&report, &context, out)?;
    results::write_run(prepared, rung, (did, answers.remembered().0), reproduce, out)?;
    match arguments.format {
        Format::Json if beside => {}
        Format::Json => output::json(&json),
        Format::Table => output::result(&format!("\n{}", from_anywhere::render(&found, &report, output::view()))),
    }
    found.warnings.iter().for_each(|warning| output::warning(warning));
    let code = run.conclude((prepared, &report, interrupted), baseline, out)?;
    Ok(ReachabilityRun { code, cut_short })
}

/// A cell file for each place, whose scan shows what happens there, too.
fn places(found: &ReachabilityResult, cell: &Path, out: &Path) -> Result<(), Failure> {
    if cell.extension().is_none_or(|ending| ending != "toml") {
        return Ok(());
    }
    for (number, place) in found.hazards.iter().enumerate() {
        let path = out.join(format!("place-{}.toml", number + 1));
        let name = format!("{} place {}", found.subject.cell, number + 1);
        output::write_file(&path, &text(place, &name, &named_from(cell, out)))?;
    }
    Ok(())
}

fn text(place: &HarmfulPose, name: &str, cell: &str) -> String {
    let HarmfulPose { start_m: [x, y], start_heading_deg: heading_deg, begins_s, actions, .. } = place;
    let count = actions.len();
    format!(
        "# Written by fmi-hazard: {} hit by {}, {:.2}x the limit, {}.\nextends = {cell:?}\nname = {name:?}\n\n[human]\nfrom = \"start\"\nstart = {{ xy_m = [{x}, \
         {y}], heading_deg = {heading_deg} }}\nother_starts = []\nstart_area = []\nbegins_s = [{begins_s}]\n\n[search]\n\
         actions = {count}\n",
        place.body_region, place.robot_link, place.ratio, place.posture
    )
}
