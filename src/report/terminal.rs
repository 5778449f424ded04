//! The result of a scan for a person at a terminal.

use std::fmt::Write as _;

use super::model::{Certificate, Residual, RunAgain, ScanReport, Verdict};
use crate::hazard::Class;
use crate::human::Action;

/// Hazards printed in full; the rest are counted.
const ROWS: usize = 15;

/// The table, the coverage beside it, and what it means.
#[must_use]
pub fn render(report: &ScanReport) -> String {
    let mut out = String::new();
    hazard_table(report, &mut out);
    if let Some(certificate) = &report.certificate {
        certified(report, certificate, &mut out);
    }
    if let Some(figures) = &report.residual {
        residual(figures, &mut out);
    }
    coverage(report, &mut out);
    for fault in &report.faults {
        let _ = writeln!(out, "  Not evaluated  {}", fault.message.replace('\n', "\n                 "));
    }
    for warning in &report.warnings {
        let _ = writeln!(out, "  Note      {warning}");
    }
    let unverified = report.tables.iter().filter(|t| !t.verified).count();
    let _ = writeln!(
        out,
        "  Limits    {}; {unverified} of {} tables not yet verified against the purchased standards",
        report.standard_edition,
        report.tables.len()
    );
    let _ = writeln!(out, "\n {}", sentence(report));
    out
}

fn hazard_table(report: &ScanReport, out: &mut String) {
    if report.hazards.is_empty() {
        return;
    }
    let header = ["id", "ratio", "body region", "hit by", "force / limit", "safe below", "time", "seen", "confirmed"];
    let row = |h: &super::model::Hazard| {
        let force = match h.class {
            Class::Force => format!("{:.0} N / {:.0} N", h.force_n, h.limit_n),
            Class::HeadContact => format!("{:.0} N / none allowed", h.force_n),
        };
        [
            h.id.clone(),
            format!("{:.2}x", h.ratio),
            h.body_region.to_string(),
            h.robot_link.clone(),
            force,
            // No speed of a moving robot is safe for a head or a throat.
            if h.body_region.permits_no_contact() { "none".to_owned() } else { format!("{:.2} m/s", h.safe_below_m_s) },
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
    let line = |cells: &[&str]| {
        let padded: Vec<String> = cells.iter().zip(&widths).map(|(c, w)| format!("{c:<w$}")).collect();
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
    let _ = writeln!(out, "  Worst     {}: {}", worst.id, worst.described());
    let names = |actions: &[Action]| actions.iter().map(ToString::to_string).collect::<Vec<_>>().join(", ");
    let _ = writeln!(out, "            actions of 0.2 s: {}", names(&worst.actions));
    if worst.shortest.actions != worst.actions {
        let _ = writeln!(
            out,
            "            the shortest and calmest way there, {:.2}x: {}",
            worst.shortest.ratio,
            names(&worst.shortest.actions)
        );
    }
}

/// A number with its thousands set apart.
pub(super) fn grouped(digits: &str) -> String {
    let first = (digits.len() + 2) % 3 + 1;
    let (head, tail) = digits.split_at(first.min(digits.len()));
    let groups = tail.as_bytes().chunks(3).map(|c| String::from_utf8_lossy(c).into_owned());
    std::iter::once(head.to_owned()).chain(groups).collect::<Vec<_>>().join(",")
}

/// What an exhaustive search covered.
fn certified(report: &ScanReport, c: &Certificate, out: &mut String) {
    let s = &report.settings;
    let _ = writeln!(
        out,
        "  Covered   {} of {} sequences in {} distinct states",
        grouped(&c.covered),
        grouped(&c.sequences),
        grouped(&c.states.to_string())
    );
    let what = if c.complete { "complete within:" } else { "NOT complete within:" };
    let _ = writeln!(
        out,
        "            {what} {} actions, {} steps of {:.0} ms, contact checked every {:.0} ms, reach tolerance {:.0} mm",
        c.actions,
        c.horizon,
        s.action_s * 1000.0,
        s.contact_check_interval_s * 1000.0,
        s.reach_tolerance_m * 1000.0
    );
    for reason in &c.reasons {
        let _ = writeln!(out, "            {reason}");
    }
    let _ = writeln!(
        out,
        "            {} hazardous, {} harmless, {} too far away to meet the robot any more",
        grouped(&c.hazardous),
        grouped(&c.harmless),
        grouped(&c.excluded)
    );
    let tried = if c.merged > 0 {
        format!(
            " ({} histories merged, {} of the merges tried out)",
            grouped(&c.merged.to_string()),
            c.merges_tried_out
        )
    } else {
        String::new()
    };
    let _ = writeln!(out, "            equal FMU states told by {}{tried}", c.merged_by);
    if c.run_again.compared > 0 {
        let _ = writeln!(out, "            {}", run_again(&c.run_again));
    }
    if let Some((random, mean)) =
        c.random_search.as_ref().and_then(|random| Some((random, random.iterations_to_hazard?)))
    {
        let mean = if mean < 10.0 { format!("{mean:.1}") } else { grouped(&format!("{mean:.0}")) };
        let _ = writeln!(
            out,
            "            one in {mean} random sequences is hazardous: random search needs {mean} iterations on average; \
             within {} it finds nothing in {:.1} % of runs",
            random.iterations,
            100.0 * random.miss_probability
        );
    }
}

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
fn residual(r: &Residual, out: &mut String) {
    let not_evaluated =
        if r.not_evaluated > 0 { format!(", {} not evaluated", r.not_evaluated) } else { String::new() };
    let share = match r.hazardous {
        0 => format!("below {:.2e} (one-sided)", r.hazardous_share_below),
        _ => {
            format!("{:.2e} to {:.2e} (Clopper-Pearson)", r.hazardous_share_interval[0], r.hazardous_share_interval[1])
        }
    };
    let _ = writeln!(
        out,
        "  Residual  {} of {} uniformly random sequences hazardous{not_evaluated}: share of all sequences {share}",
        r.hazardous, r.random_sequences
    );
    if let Some(u) = &r.unlisted {
        let _ = writeln!(
            out,
            "            one more ends in a hazard not listed here with probability below {:.2e} ({} of {} later ones did; \
             Good-Turing estimate without the chosen sequences {:.2e})",
            u.probability_below, u.met_others, u.checked, u.good_turing_estimate
        );
    }
    let _ = writeln!(out, "            95 % confidence each; for {}", r.holds_for);
}

fn coverage(report: &ScanReport, out: &mut String) {
    let c = &report.coverage;
    let sequences = match &report.certificate {
        Some(_) => String::new(),
        None => format!("{} sequences, {} not evaluated; ", report.spent.iterations, c.episodes_not_evaluated),
    };
    let _ = writeln!(
        out,
        "  Coverage  {sequences}{} actions, {} FMU steps, {} contact checks",
        c.actions, report.spent.fmu_steps, c.contact_checks
    );
    let approach =
        if c.closest_approach_m < 1e6 { format!("{:.2} m", c.closest_approach_m) } else { "never near".to_owned() };
    let _ = writeln!(
        out,
        "            robot moved at up to {:.2} m/s; closest approach of the body {approach}; robot within arm's reach at {} instants",
        c.robot_top_speed_m_s, c.checks_with_robot_in_arm_reach
    );
    let _ = writeln!(
        out,
        "            {} contacts within the limits (highest {:.2}x); obstacles stopped the person {} times",
        c.contacts_within_limits, c.highest_ratio_within_limits, c.walks_blocked
    );
    let sensors = &report.coverage.sensor_actions;
    let text = match sensors.len() {
        0 => "none in this cell: the safeguard is the guarding itself".to_owned(),
        _ => format!("reported the person in {sensors:?} actions"),
    };
    let _ = writeln!(out, "            sensors {text}");
}

/// Which sequences were looked at.
fn looked_at(report: &ScanReport) -> String {
    let (spent, settings) = (&report.spent, &report.settings);
    let auto = settings.strategy == "auto";
    match &report.certificate {
        Some(c) if c.complete => format!("all {} sequences", grouped(&c.sequences)),
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

fn sentence(report: &ScanReport) -> String {
    let within = looked_at(report);
    let complete = report.certificate.as_ref().is_some_and(|c| c.complete);
    let left = if report.residual.is_some() { "; the residual figures above bound what is left" } else { "" };
    let scope = match complete {
        true => format!("Complete: {within} are accounted for."),
        false => format!("Not complete: {within}. Not finding more is not proof of safety{left}."),
    };
    match report.verdict {
        Verdict::HazardsFound => {
            let n = report.hazards.len();
            let confirmed = report.hazards.iter().filter(|h| h.confirmed == Some(true)).count();
            let s = if n == 1 { "" } else { "s" };
            let others = match complete {
                true => " There are no others within the stated actions and horizon, in this model.",
                false => "",
            };
            format!("{n} possible hazard{s}, {confirmed} confirmed by a fresh replay.\n {scope}{others}")
        }
        Verdict::NoneFound if complete => {
            format!(
                "No sequence of the stated actions and horizon is hazardous, in this model.\n {scope} A statement about the \
                 model, not about the real cell."
            )
        }
        Verdict::NoneFound => format!("No hazard found.\n {scope}"),
        Verdict::Inconclusive => {
            "Inconclusive: nothing was found, which says nothing about the cell. See the notes above.".to_owned()
        }
        Verdict::FmuFailed => {
            "The FMU failed: nothing was found in what could be evaluated, which says little.".to_owned()
        }
        Verdict::Interrupted => format!("Interrupted; nothing found so far in {within}."),
    }
}
