//! The head of a result in words, the same at the terminal, in the report and in `scan.json`: what was found, and of what that is said.

use super::figures::{grouped, plural};
use super::model::{Headline, ScanReport, Verdict};
use crate::human::action::ACTION_S;
use crate::obligations::Obligations;

/// Of a search from a start.
#[must_use]
pub fn from_start(report: &ScanReport) -> Headline {
    let complete = report.obligations.clean().is_some();
    let asked = asked_from_start(report);
    let within = looked_at(report);
    let left = if report.residual.is_some() { "; the residual figures bound what is left" } else { "" };
    let covers = match (complete, report.hazards.is_empty()) {
        (true, true) => format!(
            "{asked}. Complete: {within} are accounted for. A statement about the model, not about the real cell."
        ),
        (true, false) => {
            format!("{asked}. Complete: {within} are accounted for, there are no other hazards in this model.")
        }
        (false, _) => format!("{asked}. Not complete: {within}. Not finding more is not proof of safety{left}."),
    };
    let says = match report.verdict {
        Verdict::HazardsFound => counted(report),
        Verdict::NoneFound(_) => "No sequence of actions is hazardous, in this model.".to_owned(),
        Verdict::Inconclusive => not_shown("found", &report.obligations),
        Verdict::FmuFailed => {
            "The FMU failed: nothing was found in what could be evaluated, which says little.".to_owned()
        }
        Verdict::Interrupted => "Interrupted; nothing was found so far.".to_owned(),
    };
    Headline { says, covers }
}

/// Why nothing clean is said, as a sentence: nothing was `found`, or what was is not `confirmed`.
#[must_use]
pub(crate) fn not_shown(what: &str, obligations: &Obligations) -> String {
    let why = obligations.first_reason().unwrap_or_else(|| "nothing is known of what it rests on".to_owned());
    format!("Nothing was {what}; not shown because {why}.")
}

/// How many causes and hazards there are, and how many are confirmed.
#[must_use]
pub(crate) fn counted(report: &ScanReport) -> String {
    let n = report.hazards.len();
    let sure = confirmed_of(report.hazards.iter().filter(|h| h.confirmed == Some(true)).count(), n);
    let causes = plural(report.causes.len(), "cause");
    format!("{causes} of {}, {sure} by a fresh replay.", plural(n, "possible hazard"))
}

/// How many are confirmed.
#[must_use]
pub fn confirmed_of(confirmed: usize, n: usize) -> String {
    match (confirmed, n) {
        (1, 1) => "confirmed".to_owned(),
        _ if confirmed == n => "all confirmed".to_owned(),
        _ => format!("{confirmed} confirmed"),
    }
}

/// Whether one is.
#[must_use]
pub const fn confirmed_words(confirmed: Option<bool>) -> &'static str {
    match confirmed {
        Some(true) => "yes",
        Some(false) => "NO",
        None => "not tried",
    }
}

/// The question, in words.
fn asked_from_start(report: &ScanReport) -> String {
    let horizon_s = f64::from(report.settings.actions_per_sequence) * ACTION_S;
    let which = match &report.subject.beginning {
        Some(beginning) if beginning.of > 1 => format!("beginning {} of {}", beginning.number, beginning.of),
        _ => "the start in the cell file".to_owned(),
    };
    match &report.cycle {
        Some(cycle) => format!("From {which}, {}", cycle.words()),
        None => format!("From {which}, for {horizon_s:.1} s"),
    }
}

/// Which sequences were looked at.
fn looked_at(report: &ScanReport) -> String {
    let (spent, settings) = (&report.spent, &report.settings);
    let auto = settings.strategy == "auto";
    let complete = report.obligations.clean().is_some();
    match &report.certificate {
        Some(c) if complete => format!("all {} sequences", grouped(&c.sequences)),
        Some(c) if c.complete_for_actions >= c.horizon && c.covered == c.sequences => {
            format!("all {} sequences were looked at, see above for what is missing", grouped(&c.sequences))
        }
        Some(c) => {
            let quick =
                if auto { format!("a quick search of {} sequences, and ", spent.iterations) } else { String::new() };
            format!("{quick}all beginnings of {} of {} actions", c.complete_for_actions, c.horizon)
        }
        None if auto => format!("a quick search of {} sequences alone, with seed {}", spent.iterations, settings.seed),
        None => format!("{} iterations of {} with seed {}", spent.iterations, settings.strategy, settings.seed),
    }
}
