//! The result of a scan for a person at a terminal.

use std::fmt::Write as _;

use super::cause::{Cause, Change};
use super::headline::Headline;
use super::judged::measure_cell;
use super::model::{Certificate, Hazard, Residual, RunAgain, ScanReport};
use super::paragraph::{WIDTH, wrapped_to};
use super::resting::rests_on;
use crate::hazard::contact::STANDSTILL_M_S;
use crate::human::Action;
use crate::human::arm::ArmModel;
use crate::sim::coverage::RobotCoverage;

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
        let unverified = report.tables.iter().filter(|t| !t.verified).count();
        let limits = format!(
            "{}; {unverified} of {} tables not yet verified against the purchased standards",
            report.standard_edition,
            report.tables.len()
        );
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
        if let Some(worst) = worst {
            out += &other_force(worst, view);
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
    let ways = cause.hazards.len();
    let s = if ways == 1 { "" } else { "s" };
    let share = cause.share.map_or_else(String::new, |share| format!("; {} of all sequences", percent(share)));
    let (bold, off) = view.ink(BOLD);
    let head = format!(" {bold}{}{off}  ", cause.id);
    let text = wrapped_to(view.width, &" ".repeat(cause.id.len() + 3), &cause.sentence);
    *out += &text.replacen(&" ".repeat(cause.id.len() + 3), &head, 1);
    let own = worst.and_then(|worst| Some((worst, worst.begins?)));
    let from = if own.is_some() { String::new() } else { format!("; from {:.2} s on", cause.earliest_time_s) };
    let figures = format!("{}{from}; {ways} way{s}{share}", cause.force_words());
    *out += &wrapped_to(view.width, "   ", &figures);
    if let Some((worst, begins)) = own {
        let begins = format!("The worst begins {}; hit {:.2} s later", begins.words(), worst.time_s);
        *out += &wrapped_to(view.width, "   ", &begins);
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
        *out += &wrapped_to(view.width, "   What helps: ", "no single change that was tried");
    }
    for (title, changes) in [("   What helps: ", enough), ("   Tried in part: ", part)] {
        if !changes.is_empty() {
            *out += &wrapped_to(view.width, title, &words(&changes).join("; or "));
        }
    }
}

/// The force with the other speed, where the two are far apart.
fn other_force(worst: &Hazard, view: View) -> String {
    if worst.class.beside_force().is_some() {
        return String::new();
    }
    let own = worst.force_n / worst.limit_n;
    let [less, more] =
        if own < worst.directed_ratio { [own, worst.directed_ratio] } else { [worst.directed_ratio, own] };
    if more <= FAR_APART * less {
        return String::new();
    }
    let other = if worst.is_by_approach() {
        format!("with the robot's own speed {own:.2}x")
    } else {
        format!("with the speed of approach, the person's walking included, {:.2}x", worst.directed_ratio)
    };
    let decides = if worst.body_region.permits_no_contact() {
        "no contact is allowed there either way"
    } else {
        "criterion in the cell file says which decides"
    };
    wrapped_to(view.width, "   But: ", &format!("{other} ({decides})"))
}

/// Forces that differ by more than this factor are both told.
const FAR_APART: f64 = 2.0;

/// Most changes on a card.
const CHANGES: usize = 3;

/// A part of a whole, with the digits that mean something.
pub(super) fn percent(part: f64) -> String {
    match 100.0 * part {
        p if p <= 0.0 => "0 %".to_owned(),
        p if p >= 99.95 => "100 %".to_owned(),
        p if p >= 9.95 => format!("{p:.0} %"),
        p if p >= 0.095 => format!("{p:.1} %"),
        p if p >= 0.000_095 => {
            // Two digits that are not zero.
            let places = (-libm::floor(libm::log10(p)) + 1.0).clamp(2.0, 6.0);
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "2 to 6")]
            let places = places as usize;
            format!("{p:.places$} %")
        }
        _ => "less than 0.0001 %".to_owned(),
    }
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
            match h.confirmed {
                Some(true) => "yes",
                Some(false) => "NO",
                None => "not tried",
            }
            .to_owned(),
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
    let settings = &report.settings;
    let mut say = |head: &str, text: &str| *out += &wrapped_to(view.width, head, text);
    say("  Covered   ", &format!("{} of {} sequences", grouped(&c.covered), grouped(&c.sequences)));
    let what = if c.complete { "complete within:" } else { "NOT complete within:" };
    let held = settings.held_m.map_or_else(String::new, |held_m| {
        let tolerance_m = ArmModel::holding(held_m).hand_tolerance_m(settings.reach_tolerance_m);
        format!(", {:.0} mm for what is held", tolerance_m * 1000.0)
    });
    let within = format!(
        "{what} {} actions, {} steps of {:.0} ms, contact checked every {:.0} ms, reach tolerance {:.0} mm{held}",
        c.actions,
        c.horizon,
        settings.action_s * 1000.0,
        settings.contact_check_interval_s * 1000.0,
        settings.reach_tolerance_m * 1000.0
    );
    say(UNDER, &within);
    if !view.verbose {
        return;
    }
    let kinds = format!(
        "{} hazardous ({}), {} harmless, {} too far away to meet the robot any more",
        grouped(&c.hazardous),
        percent(c.hazardous_share),
        grouped(&c.harmless),
        grouped(&c.excluded)
    );
    say(UNDER, &kinds);
    let tried = match c.merged {
        0 => String::new(),
        of => {
            format!(" ({} histories merged, {} of the merges tried out)", grouped(&of.to_string()), c.merges_tried_out)
        }
    };
    let states = grouped(&c.states.to_string());
    say(UNDER, &format!("{states} distinct states; equal FMU states told by {}{tried}", c.merged_by));
    if c.run_again.compared > 0 {
        say(UNDER, &run_again(&c.run_again));
    }
    if let Some((random, mean)) =
        c.random_search.as_ref().and_then(|random| Some((random, random.iterations_to_hazard?)))
    {
        let mean = if mean < 10.0 { format!("{mean:.1}") } else { grouped(&format!("{mean:.0}")) };
        let random = format!(
            "one in {mean} random sequences is hazardous: random search needs {mean} iterations on average; within {} it \
             finds nothing in {} of runs",
            random.iterations,
            percent(random.miss_probability)
        );
        say(UNDER, &random);
    }
}

/// What stands under the head of a paragraph.
const UNDER: &str = "            ";

/// What was run again plainly.
fn run_again(again: &RunAgain) -> String {
    let part = |done: u64, of: u64| match done == of {
        true => format!("all {}", grouped(&of.to_string())),
        false => format!("{} of {}", grouped(&done.to_string()), grouped(&of.to_string())),
    };
    let merges = match again.merges {
        0 => String::new(),
        of => format!(", and {} merges gone on with", part(again.merges_compared, of)),
    };
    let whole = (again.compared, again.merges_compared) == (again.transitions, again.merges);
    let sample = if whole { "" } else { " (a sample, chosen by a key)" };
    format!("{} FMU transitions run again from the start{merges}{sample}", part(again.compared, again.transitions))
}

/// What random sequences say about what is left.
fn residual(r: &Residual, view: View, out: &mut String) {
    let mut say = |head: &str, text: &str| *out += &wrapped_to(view.width, head, text);
    let not_evaluated =
        if r.not_evaluated > 0 { format!(", {} not evaluated", r.not_evaluated) } else { String::new() };
    let share = match r.hazardous {
        0 => format!("below {}", percent(r.hazardous_share_below)),
        _ => format!("{} to {}", percent(r.hazardous_share_interval[0]), percent(r.hazardous_share_interval[1])),
    };
    let random = format!(
        "{} of {} uniformly random sequences hazardous{not_evaluated}: of all sequences {share} are",
        r.hazardous, r.random_sequences
    );
    say("  Residual  ", &random);
    if let Some(u) = &r.unlisted {
        let unlisted = format!(
            "one more ends in a hazard not listed here with a probability below {} ({} of {} later ones did)",
            percent(u.probability_below),
            u.met_others,
            u.checked
        );
        say(UNDER, &unlisted);
        if view.verbose {
            let estimate = percent(u.good_turing_estimate);
            say(UNDER, &format!("Good-Turing estimate without the chosen sequences: {estimate}"));
        }
    }
    say(UNDER, &format!("95 % confidence each; for {}", r.holds_for));
}

fn coverage(report: &ScanReport, view: View, out: &mut String) {
    let mut say = |head: &str, text: &str| *out += &wrapped_to(view.width, head, text);
    let c = &report.coverage;
    let sequences = match &report.certificate {
        Some(_) => String::new(),
        None => format!("{} sequences, {} not evaluated; ", report.spent.iterations, c.episodes_not_evaluated),
    };
    let spent = format!(
        "{sequences}{} actions, {} FMU steps, {} contact checks",
        c.actions, report.spent.fmu_steps, c.contact_checks
    );
    say("  Coverage  ", &spent);
    let robot = format!(
        "robot moved at up to {:.2} m/s; closest approach of the body {}; robot within arm's reach at {} instants",
        c.robot_top_speed_m_s,
        approach(c.closest_approach_m),
        c.checks_with_robot_in_arm_reach
    );
    say(UNDER, &robot);
    for robot in c.robots.iter().filter(|_| c.robots.len() > 1) {
        say(UNDER, &of_robot(robot));
    }
    let contacts = format!(
        "{} contacts within the limits (highest {:.2}x); obstacles stopped the person {} times",
        c.contacts_within_limits, c.highest_ratio_within_limits, c.walks_blocked
    );
    say(UNDER, &contacts);
    let sensors = &report.coverage.sensor_actions;
    let text = match sensors.len() {
        0 => "none in this cell: the safeguard is the guarding itself".to_owned(),
        _ => format!("reported the person in {sensors:?} actions"),
    };
    say(UNDER, &format!("sensors {text}"));
}

/// How near somebody came.
fn approach(closest_m: f64) -> String {
    if closest_m < 1e6 { format!("{closest_m:.2} m") } else { "never near".to_owned() }
}

/// What was seen of one of several robots.
fn of_robot(robot: &RobotCoverage) -> String {
    let moved = match (robot.moved, robot.top_speed_m_s) {
        (false, speed) if speed < STANDSTILL_M_S => "never moved".to_owned(),
        (_, speed) => format!("up to {speed:.2} m/s"),
    };
    let closest = match (robot.instants_in_reach, robot.closest_approach_m) {
        // Too slow to harm whenever somebody was near: its distance was not asked for.
        (1.., closest_m) if closest_m >= 1e6 => String::new(),
        (_, closest_m) => format!("closest approach {}; ", approach(closest_m)),
    };
    format!("{}: {moved}; {closest}near enough to touch at {} instants", robot.name, robot.instants_in_reach)
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
}
