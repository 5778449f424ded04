//! The result of a scan for a person at a terminal.

use std::fmt::Write as _;

use super::basis::rests_on;
use super::covered::{self, Bounds, NO_SENSORS};
use super::view::View;
use crate::human::Action;
use fmi_hazard_record::cause::{Cause, Change, NO_CHANGE, TRIED_IN_PART};
use fmi_hazard_record::certificate::{Certificate, Residual};
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::headline::confirmed_words;
use fmi_hazard_record::judged::measure_cell;
use fmi_hazard_record::model::{Headline, ScanReport};
use fmi_hazard_record::paragraph::wrapped_to;

/// Hazards printed in full; the rest are counted.
const ROWS: usize = 15;

/// Most causes that are shown.
const CAUSES: usize = 8;

/// What was found, what that is worth, and what is behind it if that is wanted.
#[must_use]
pub fn render(report: &ScanReport, view: View) -> String {
    let mut out = String::new();
    if view.verbose {
        hazard_table(report, view, &mut out);
        coverage(report, view, &mut out);
    }
    if let Some(certificate) = &report.certificate {
        certified(report, certificate, view, &mut out);
    }
    if let Some(figures) = &report.residual {
        residual(figures, view, &mut out);
    }
    for fault in &report.faults {
        out += &wrapped_to(view.width, "  Not evaluated  ", &fault.message);
    }
    if let Some(criteria) = &report.settings.criteria {
        out += &wrapped_to(view.width, "  Unsafe is ", &criteria.words());
    }
    out += &rests_on(&report.obligations, view);
    for warning in &report.warnings {
        out += &wrapped_to(view.width, "  Note      ", warning);
    }
    if view.verbose {
        let verified = report.tables.iter().filter(|t| t.verified).count();
        let limits = limits_words(report.standard_edition, report.tables.len(), verified);
        out += &wrapped_to(view.width, "  Limits    ", &limits);
    }
    if !out.is_empty() {
        out.push('\n');
    }
    let Headline { says, covers } = &report.headline;
    let (on, off) = view.ink(if report.verdict.is_clean() { GREEN } else { RED });
    for line in wrapped_to(view.width, " ", says).lines() {
        let _ = writeln!(out, "{on}{line}{off}");
    }
    out += &cards(report, view);
    out + &wrapped_to(view.width, " ", covers)
}

/// The causes, a card each, with empty lines around them.
#[must_use]
pub(crate) fn cards(report: &ScanReport, view: View) -> String {
    let mut out = String::new();
    for cause in report.causes.iter().take(CAUSES) {
        out.push('\n');
        let worst = report.hazards.iter().find(|hazard| hazard.id == cause.worst);
        card(cause, worst, view, &mut out);
        if let Some(other) = worst.and_then(Hazard::other_force) {
            out += &wrapped_to(view.width, "   But: ", &other);
        }
    }
    if report.causes.len() > CAUSES {
        let _ = writeln!(out, "\n ... and {} more causes in the report", report.causes.len() - CAUSES);
    }
    if !report.causes.is_empty() {
        out.push('\n');
    }
    out
}

const RED: &str = "\u{1b}[1;31m";
const GREEN: &str = "\u{1b}[1;32m";
const BOLD: &str = "\u{1b}[1m";

/// One cause: what is wrong, how bad it is, where its worst hazard begins if that is not where the scan did, what is hit by
/// what, what helps.
fn card(cause: &Cause, worst: Option<&Hazard>, view: View, out: &mut String) {
    let share = cause.share_words().map_or_else(String::new, |share| format!("; {share}"));
    let (bold, off) = view.ink(BOLD);
    let head = format!(" {bold}{}{off}  ", cause.id);
    let text = wrapped_to(view.width, &" ".repeat(cause.id.len() + 3), &cause.sentence);
    *out += &text.replacen(&" ".repeat(cause.id.len() + 3), &head, 1);
    let own = worst.and_then(|worst| Some((worst, worst.begins?)));
    let from = if own.is_some() { String::new() } else { format!("; {}", cause.earliest_words()) };
    let figures = format!("{}{from}; {}{share}", cause.force_words(), cause.ways_words());
    *out += &wrapped_to(view.width, "   ", &figures);
    if let Some((worst, begins)) = own {
        *out += &wrapped_to(view.width, "   ", &worst.begins_words(begins));
    }
    let mut regions: Vec<(String, Vec<&str>)> = Vec::new();
    for line in &cause.lines {
        match regions.iter_mut().find(|(region, _)| *region == line.words()) {
            Some((_, links)) => links.push(&line.robot_link),
            None => regions.push((line.words().to_owned(), vec![&line.robot_link])),
        }
    }
    let hit = |(region, links): &(String, Vec<&str>)| format!("{region} by {}", links.join(", "));
    let hit: Vec<String> = regions.iter().map(hit).collect();
    let [done, _] = cause.class.done();
    let done = done[..1].to_uppercase() + &done[1..];
    *out += &wrapped_to(view.width, &format!("   {done}: "), &hit.join("; "));
    let Some(advice) = &cause.advice else { return };
    let (enough, part): (Vec<&Change>, Vec<&Change>) =
        advice.changes.iter().partition(|change| change.enough_until_s.is_some());
    let words = |changes: &[&Change]| changes.iter().take(CHANGES).map(|change| change.words()).collect::<Vec<_>>();
    if advice.changes.is_empty() {
        *out += &wrapped_to(view.width, "   What helps: ", NO_CHANGE);
    }
    for (title, changes) in [("What helps", enough), (TRIED_IN_PART, part)] {
        if !changes.is_empty() {
            *out += &wrapped_to(view.width, &format!("   {title}: "), &words(&changes).join("; or "));
        }
    }
}

/// Most changes on a card.
const CHANGES: usize = 3;

fn hazard_table(report: &ScanReport, view: View, out: &mut String) {
    if report.hazards.is_empty() {
        return;
    }
    let header = ["id", "ratio", "body region", "hit by", "force / limit", "safe below", "time", "seen", "confirmed"];
    let row = |h: &Hazard| {
        let figures = (h.deciding_force_n(), h.deciding_limit_n(), h.speed_m_s);
        let force = measure_cell(h.class, h.judged.as_ref(), figures);
        [
            h.id.clone(),
            format!("{:.2}x", h.ratio),
            h.body_region.to_string(),
            h.robot_link.clone(),
            force,
            // No speed of a moving robot is safe for a head or a throat.
            h.safe_words(),
            format!("{:.2} s", h.time_s),
            h.times_found.to_string(),
            confirmed_words(h.confirmed).to_owned(),
        ]
    };
    let rows: Vec<[String; 9]> = report.hazards.iter().take(ROWS).map(row).collect();
    let width = |c: usize| rows.iter().map(|r| r[c].len()).max().unwrap_or(0).max(header[c].len());
    let widths: Vec<usize> = (0..header.len()).map(width).collect();
    // As many columns as there is room for.
    let mut room = view.width;
    let fits = |width: &&usize| {
        let fits = room >= **width + 2;
        room = room.saturating_sub(**width + 2);
        fits
    };
    let columns = widths.iter().take_while(fits).count().max(2);
    let line = |cells: &[&str]| {
        let cells = cells.iter().zip(&widths).take(columns);
        let padded: Vec<String> = cells.map(|(c, w)| format!("{c:<w$}")).collect();
        format!(" {}", padded.join("  ").trim_end())
    };
    let _ = writeln!(out, "{}", line(&header));
    for r in &rows {
        let _ = writeln!(out, "{}", line(&r.each_ref().map(String::as_str)));
    }
    if report.hazards.len() > ROWS {
        let _ = writeln!(out, " ... and {} more in scan.json", report.hazards.len() - ROWS);
    }
    out.push('\n');
    let worst = &report.hazards[0];
    out.push_str(&wrapped_to(view.width, "  Worst     ", &format!("{}: {}", worst.id, worst.described())));
    let names = |actions: &[Action]| actions.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let actions = format!("actions of 0.2 s: {}", names(&worst.actions));
    out.push_str(&wrapped_to(view.width, "            ", &actions));
    if worst.shortest.actions != worst.actions {
        let calmest = format!(
            "the shortest and calmest way there, {:.2}x: {}",
            worst.shortest.ratio,
            names(&worst.shortest.actions)
        );
        out.push_str(&wrapped_to(view.width, "            ", &calmest));
    }
}

/// Where the limits are from, and how many of the tables nobody verified.
pub(super) fn limits_words(edition: &str, tables: usize, verified: usize) -> String {
    let unverified = tables - verified;
    format!("{edition}; {unverified} of {tables} tables not yet verified against the purchased standards")
}

/// What an exhaustive search covered.
fn certified(report: &ScanReport, c: &Certificate, view: View, out: &mut String) {
    let mut say = |head: &str, text: &str| *out += &wrapped_to(view.width, head, text);
    say("  Covered   ", &covered::sequences(c));
    let what = if c.complete { "complete within:" } else { "NOT complete within:" };
    say(UNDER, &format!("{what} {}", covered::within(c, &report.settings)));
    if !view.verbose {
        return;
    }
    say(UNDER, &covered::fates(c));
    say(UNDER, &covered::states(c));
    for text in [covered::run_again(&c.run_again), covered::random_search(c)].into_iter().flatten() {
        say(UNDER, &text);
    }
}

/// What stands under the head of a paragraph.
const UNDER: &str = "            ";

/// What random sequences say about what is left.
fn residual(r: &Residual, view: View, out: &mut String) {
    let mut say = |head: &str, text: &str| *out += &wrapped_to(view.width, head, text);
    say("  Residual  ", &covered::share(r, Bounds::Nearest));
    if let Some(u) = &r.unlisted {
        say(UNDER, &covered::unlisted(u, Bounds::Nearest));
        if view.verbose {
            say(UNDER, &covered::estimate(u));
        }
    }
    say(UNDER, &covered::confidence(r));
}

fn coverage(report: &ScanReport, view: View, out: &mut String) {
    let mut say = |head: &str, text: &str| *out += &wrapped_to(view.width, head, text);
    let c = &report.coverage;
    say("  Coverage  ", &covered::spent(c, &report.spent, report.certificate.is_some()));
    say(UNDER, &format!("robot {}", covered::robot(c)));
    for robot in c.robots.iter().filter(|_| c.robots.len() > 1) {
        say(UNDER, &format!("{}: {}", robot.name, covered::of_robot(robot)));
    }
    say(UNDER, &covered::contacts(c));
    let text = match &c.sensor_actions {
        none if none.is_empty() => NO_SENSORS.to_owned(),
        sensors => format!("reported the person in {sensors:?} actions"),
    };
    say(UNDER, &format!("sensors {text}"));
}
