//! The result of a scan for a person at a terminal.

use std::fmt::Write as _;

use super::cause::{Cause, Change, NO_CHANGE, TRIED_IN_PART};
use super::covered::{self, Bounds, NO_SENSORS};
use super::headline::{Headline, confirmed_words};
use super::judged::measure_cell;
use super::model::{Certificate, Hazard, Residual, ScanReport};
use super::paragraph::{WIDTH, wrapped_to};
use super::resting::rests_on;
use crate::human::Action;

/// How the result is shown.
#[derive(Clone, Copy, Debug)]
pub(crate) struct View {
    /// Columns of the terminal.
    pub width: usize,
    /// Also every hazard, and what the search covered.
    pub verbose: bool,
    /// Whether colours are wanted.
    pub colour: bool,
}

impl Default for View {
    /// As where nobody looks: wide, short, plain.
    fn default() -> Self {
        Self { width: WIDTH, verbose: false, colour: false }
    }
}

/// Hazards printed in full; the rest are counted.
const ROWS: usize = 15;

/// Most causes that are shown.
const CAUSES: usize = 8;

/// What was found, what that is worth, and what is behind it if that is wanted.
#[must_use]
pub(crate) fn render(report: &ScanReport, view: View) -> String {
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

impl View {
    /// What begins and ends text of a kind.
    const fn ink(self, kind: &'static str) -> (&'static str, &'static str) {
        if self.colour { (kind, "\u{1b}[0m") } else { ("", "") }
    }
}

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

/// A part of a whole, with the digits that mean something.
pub(super) fn percent(part: f64) -> String {
    match 100.0 * part {
        p if p <= 0.0 => "0 %".to_owned(),
        p if p >= 99.95 => "100 %".to_owned(),
        p => match places(p) {
            Some(places) => format!("{p:.places$} %"),
            None => "less than 0.0001 %".to_owned(),
        },
    }
}

/// Decimal places with which a percentage is told; none if it is too small for that.
fn places(percentage: f64) -> Option<usize> {
    match percentage {
        p if p >= 9.95 => Some(0),
        p if p >= 0.095 => Some(1),
        p if p >= 0.000_095 => {
            // Two digits that are not zero.
            let places = (-libm::floor(libm::log10(p)) + 1.0).clamp(2.0, 6.0);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "2 to 6")]
            let places = places as usize;
            Some(places)
        }
        _ => None,
    }
}

/// A bound from above: never rounded down.
pub(super) fn at_most(part: f64) -> String {
    rounded(part, f64::ceil)
}

/// A bound from below: never rounded up.
pub(super) fn at_least(part: f64) -> String {
    rounded(part, f64::floor)
}

fn rounded(part: f64, to: fn(f64) -> f64) -> String {
    let Some(places) = places(100.0 * part) else { return percent(part) };
    let scale = (0..places).fold(100.0, |scale, _| 10.0 * scale);
    // What is a round figure but for the last bits stays it.
    let nearest = (part * scale).round();
    let whole = if (part * scale - nearest).abs() < 1e-9 { nearest } else { to(part * scale) };
    percent(whole / scale)
}

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

/// A number with its thousands set apart.
#[must_use]
pub(crate) fn grouped(digits: &str) -> String {
    let first = (digits.len() + 2) % 3 + 1;
    let (head, tail) = digits.split_at(first.min(digits.len()));
    let groups = tail.as_bytes().chunks(3).map(|c| String::from_utf8_lossy(c).into_owned());
    std::iter::once(head.to_owned()).chain(groups).collect::<Vec<_>>().join(",")
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shares_have_the_digits_that_mean_something() {
        for (part, words) in [
            (0.0, "0 %"),
            (1.0, "100 %"),
            (0.254_6, "25 %"),
            (0.033_46, "3.3 %"),
            (0.009_97, "1.0 %"),
            (0.000_97, "0.1 %"),
            (0.000_041, "0.0041 %"),
            (0.000_001_2, "0.00012 %"),
            (0.000_000_1, "less than 0.0001 %"),
        ] {
            assert_eq!(percent(part), words);
        }
    }

    #[test]
    fn bounds_hold_as_they_are_printed() {
        let bounds =
            [(0.019_3, "2.0 %", "1.9 %"), (0.02, "2.0 %", "2.0 %"), (0.254_6, "26 %", "25 %"), (0.0, "0 %", "0 %")];
        for (part, above, below) in bounds {
            assert_eq!([at_most(part), at_least(part)], [above, below]);
        }
        assert_eq!([at_most(0.999_1), at_least(0.999_9)], ["100 %", "99 %"]);
    }
}
