//! How long FMUs are meant to be run: the stopTime of the default experiment in modelDescription.xml.
//!
//! No FMU is told a stop time, so by FMI each has to run on; but beyond its stopTime nobody may ever have looked at it, and
//! some end there. Often it is no more than the length of a demonstration. So what merely tries an FMU out stays within it,
//! and a scan, whose length the user chooses, goes beyond it and says so.

use crate::cell::Workcell;
use crate::fmi::{Fmu, number};
use crate::human::action::ACTION_S;

/// The FMU that is to be stopped first, and when, s.
pub(super) fn earliest(fmus: &[Fmu]) -> Option<(&Fmu, f64)> {
    let ends = fmus.iter().filter_map(|fmu| Some((fmu, fmu.description().default_experiment.ends_s()?)));
    ends.min_by(|a, b| a.1.total_cmp(&b.1))
}

/// How long the FMUs of a cell are run to see what they do, once the person is there, s: `wanted` if that ends before the
/// first stopTime, else as far as there, but never shorter than the cell's sequences, which a scan runs anyway.
pub(super) fn run_s(cell: &Workcell, fmus: &[Fmu], wanted: f64) -> f64 {
    let left = earliest(fmus).map_or(wanted, |(_, stop)| stop - lead_in_s(cell));
    wanted.min(left.max(horizon_s(cell)))
}

/// What a scan beyond the first stopTime is to be told.
pub(super) fn beyond(cell: &Workcell, fmus: &[Fmu]) -> Option<String> {
    let (fmu, stop) = earliest(fmus)?;
    let (lead_in, horizon) = (lead_in_s(cell), horizon_s(cell));
    let end = lead_in + horizon;
    if end <= stop + 1e-9 {
        return None;
    }
    let before = if lead_in > 0.0 { format!("{lead_in:.2} s before the person begins, and ") } else { String::new() };
    Some(format!(
        "sequences go on to {end:.2} s ({before}{} actions of {ACTION_S} s), beyond the stopTime of {} s that {} gives \
         (DefaultExperiment in modelDescription.xml). FMI lets it run on, but nobody may have looked at what it does then: ask \
         whoever exported it whether it is valid for so long, and have it exported with that stopTime, or shorten \
         human.begins_s or search.actions",
        cell.search.actions,
        number(stop),
        fmu.path().file_name().unwrap_or_default().to_string_lossy(),
    ))
}

fn lead_in_s(cell: &Workcell) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "an hour of small steps")]
    let steps = cell.lead_in_steps() as f64;
    steps * cell.step_s
}

fn horizon_s(cell: &Workcell) -> f64 {
    f64::from(cell.search.actions) * ACTION_S
}
