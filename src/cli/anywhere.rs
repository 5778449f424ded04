//! `fmi-hazard scan --from anywhere`: people who come from where no sensor sees them, on any walk and at any moment.

use std::ops::ControlFlow;
use std::path::Path;
use std::time::Instant;

use super::exit::Failure;
use super::output::{self, Format, Progress};
use super::scan::{Run, file_name, introduce};
use super::{beginnings, results, stopping};
use crate::cell::file::files::named_from;
use crate::report::anywhere::{Anywhere, Place};
use crate::report::floorplan;
use crate::report::whole::Whole;
use crate::scan::anywhere::{Effort, Told, anywhere, refusal};
use crate::scan::{Prepared, Scanned, picture};

/// Where the result is kept.
const RESULT: &str = "anywhere.json";
/// The floor as a picture.
const FLOOR: &str = "floor.svg";
/// Steps of the progress bar.
const STEPS: u64 = 1000;

/// The command.
pub(super) fn run(run: &Run<'_>, prepared: &Prepared) -> Result<u8, Failure> {
    let Run { arguments, path, cell_path, assessments, stop, .. } = *run;
    if let Some(reason) = refusal(prepared) {
        return Err(Failure::unusable(reason));
    }
    stopping::by_signals(stop);
    introduce(prepared, arguments.state);
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(file_name(&prepared.cell.name)));
    std::fs::create_dir_all(&out)
        .map_err(|e| Failure::unusable(format!("cannot write results to {}: {e}", out.display())))?;
    // It is about none of the cell's beginnings.
    let baseline = run.baseline(prepared, None)?;
    beginnings::forget(&out);
    if let Some(time) = arguments.time() {
        stop.within(time);
    }
    stop.searching();
    let began = Instant::now();
    let mut progress = Progress::new(STEPS, "of the floor");
    let mut tell = |told: Told| {
        match told {
            Told::States(states, most) => output::phase(&format!("stepping the FMU: {states} states, {most} at most")),
            Told::Asked(share) => {
                output::phase(&format!("asking the FMU what its sensors report: {:.0} %", share * 100.0));
            }
            Told::RunAgain(done, of) => output::phase(&format!("running again from the start: {done} of {of}")),
            Told::Floor(share, hazards) => {
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
    let effort = Effort {
        until: arguments.until(),
        workers: arguments.workers(),
        most_states: arguments.most_states(),
        state: arguments.state,
    };
    let looked = anywhere(prepared, effort, &mut tell)?;
    progress.finish();
    output::phase("confirming from a fresh start");
    let Scanned { report, rung, effort: did, remembered } = looked.scanned(prepared, effort);
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
    output::write_file(&out.join(FLOOR), &floorplan::render(&Whole::from(&found), &picture::plan(prepared)))?;
    places(&found, cell_path, &out)?;
    let interrupted = stop.is_asked();
    let (baseline, reproduce) = (baseline.as_ref(), &arguments.reproduce(path, &out, None, None));
    let context =
        results::Context { prepared, rung, path: cell_path, reproduce, baseline, assessments, whole: Some(&found) };
    results::write(&report, &context, &out)?;
    results::write_run(prepared, rung, (did, remembered), reproduce, &out)?;
    match arguments.format {
        Format::Json => output::json(&json),
        Format::Table => output::result(&format!("\n{}", found.render(&report, output::view()))),
    }
    found.warnings.iter().for_each(|warning| output::warning(warning));
    run.conclude((prepared, &report, interrupted), baseline, &out)
}

/// A cell file for each place, whose scan shows what happens there, too.
fn places(found: &Anywhere, cell: &Path, out: &Path) -> Result<(), Failure> {
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

fn text(place: &Place, name: &str, cell: &str) -> String {
    let Place { start_m: [x, y], start_heading_deg: heading_deg, begins_s, actions, .. } = place;
    let count = actions.len();
    format!(
        "# Written by fmi-hazard: {} hit by {}, {:.2}x the limit, {}.\nextends = {cell:?}\nname = {name:?}\n\n[human]\nfrom = \"start\"\nstart = {{ xy_m = [{x}, \
         {y}], heading_deg = {heading_deg} }}\nother_starts = []\nstart_area = []\nbegins_s = [{begins_s}]\n\n[search]\n\
         actions = {count}\n",
        place.body_region, place.robot_link, place.ratio, place.posture
    )
}
