//! `fmi-hazard scan --from anywhere`: people who come from where no sensor sees them, on any walk and at any moment.

use std::fmt::Write as _;
use std::ops::ControlFlow;
use std::path::{Path, PathBuf};
use std::time::{Duration, Instant};

use super::exit::{self, Failure};
use super::output::{self, Format, Progress};
use super::scan::{Arguments, introduce};
use super::stopping;
use crate::cell::file::files::named_from;
use crate::report::anywhere::{Anywhere, Place};
use crate::report::model::Verdict;
use crate::scan::Prepared;
use crate::scan::anywhere::{Effort, Told, anywhere, refusal};
use crate::stop::Stop;

/// Where the result is kept.
const RESULT: &str = "anywhere.json";
/// How long after the start of the FMU is looked at.
const UNTIL: Duration = Duration::from_secs(4);
/// Steps of the progress bar.
const STEPS: u64 = 1000;

/// The command.
pub(super) fn run(arguments: &Arguments, prepared: &Prepared, cell: &Path, stop: &Stop) -> Result<u8, Failure> {
    if let Some(reason) = refusal(prepared) {
        return Err(Failure::unusable(reason));
    }
    stopping::by_signals(stop);
    introduce(prepared, arguments.state);
    let out = arguments.out.clone().unwrap_or_else(|| Path::new("out").join(&prepared.cell.name));
    std::fs::create_dir_all(&out)
        .map_err(|e| Failure::unusable(format!("cannot write results to {}: {e}", out.display())))?;
    if let Some(time) = arguments.time() {
        stop.within(time);
    }
    stop.searching();
    let began = Instant::now();
    let mut progress = Progress::new(STEPS, "of the floor");
    let mut tell = |told: Told| {
        match told {
            Told::States(states, most) => output::phase(&format!("stepping the FMU: {states} states, {most} at most")),
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
        until_s: arguments.until.unwrap_or(UNTIL).as_secs_f64(),
        workers: arguments.workers(),
        most_states: arguments.most_states(),
        state: arguments.state,
    };
    let found = anywhere(prepared, effort, &mut tell)?;
    progress.finish();
    output::detail(&format!(
        "   Took    {:.1} s, {} FMU steps, {} sets of poses, {} arm searches",
        began.elapsed().as_secs_f64(),
        found.spent.fmu_steps,
        found.spent.boxes,
        found.spent.arm_checks
    ));
    let json = output::pretty(&found)?;
    output::write_file(&out.join(RESULT), &json)?;
    let first = places(&found, cell, &out)?;
    match arguments.format {
        Format::Json => output::json(&json),
        Format::Table => {
            let mut text = format!("\n{}", found.render(output::view().width));
            let _ = writeln!(text, " Result  {}", out.join(RESULT).display());
            if let Some(first) = first {
                let _ = writeln!(text, " Next    fmi-hazard scan {}", first.display());
            }
            output::result(&text);
        }
    }
    found.warnings.iter().for_each(|warning| output::warning(warning));
    Ok(match found.verdict {
        Verdict::HazardsFound => exit::HAZARDS,
        Verdict::NoneFound => exit::NO_HAZARD,
        Verdict::Interrupted => exit::INTERRUPTED,
        _ => exit::INCONCLUSIVE,
    })
}

/// A cell file for each place, whose scan shows what happens there; the first of them.
fn places(found: &Anywhere, cell: &Path, out: &Path) -> Result<Option<PathBuf>, Failure> {
    if cell.extension().is_none_or(|ending| ending != "toml") {
        return Ok(None);
    }
    let mut first = None;
    for (number, place) in found.hazards.iter().enumerate() {
        let path = out.join(format!("place-{}.toml", number + 1));
        let name = format!("{} place {}", found.subject.cell, number + 1);
        output::write_file(&path, &text(place, &name, &named_from(cell, out)))?;
        first.get_or_insert(path);
    }
    Ok(first)
}

fn text(place: &Place, name: &str, cell: &str) -> String {
    let Place { start_m: [x, y], start_heading_deg: heading_deg, begins_s, actions, .. } = place;
    let count = actions.len();
    format!(
        "# Written by fmi-hazard: {} hit by {}, {:.2}x the limit, {}.\nextends = {cell:?}\nname = {name:?}\n\n[human]\nstart = {{ xy_m = [{x}, \
         {y}], heading_deg = {heading_deg} }}\nother_starts = []\nstart_area = []\nbegins_s = [{begins_s}]\n\n[search]\n\
         actions = {count}\n",
        place.body_region, place.robot_link, place.ratio, place.posture
    )
}
