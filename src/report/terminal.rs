//! The result of a scan for a person at a terminal.

use std::fmt::Write as _;

use super::model::{ScanReport, Verdict};
use crate::hazard::Class;

/// Hazards printed in full; the rest are counted.
const ROWS: usize = 15;

/// The table, the coverage beside it, and what it means.
#[must_use]
pub fn render(report: &ScanReport) -> String {
    let mut out = String::new();
    hazard_table(report, &mut out);
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
            format!("{:.2} m/s", h.safe_below_m_s),
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
    let _ = writeln!(out, "  Worst     {}: {}", worst.id, describe(worst));
    let names: Vec<String> = worst.actions.iter().map(ToString::to_string).collect();
    let _ = writeln!(out, "            actions of 0.2 s: {}", names.join(", "));
}

fn describe(h: &super::model::Hazard) -> String {
    let sensors: Vec<String> = h
        .sensors
        .iter()
        .map(|s| format!("{} {}", s.name, if s.person_detected { "reports the person" } else { "clear" }))
        .collect();
    let sensors = if sensors.is_empty() { String::new() } else { format!("; {}", sensors.join(", ")) };
    format!(
        "at {:.2} s the robot's {} meets the {} at {:.2} m/s at ({:.2}, {:.2}, {:.2}) m; the person stands at ({:.2}, {:.2}){sensors}",
        h.time_s,
        h.robot_link,
        h.body_region.words(),
        h.speed_m_s,
        h.contact_point_m[0],
        h.contact_point_m[1],
        h.contact_point_m[2],
        h.person_xy_m[0],
        h.person_xy_m[1],
    )
}

fn coverage(report: &ScanReport, out: &mut String) {
    let c = &report.coverage;
    let _ = writeln!(
        out,
        "  Coverage  {} sequences, {} not evaluated; {} actions, {} FMU steps, {} contact checks",
        report.spent.iterations, c.episodes_not_evaluated, c.actions, report.spent.fmu_steps, c.contact_checks
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

fn sentence(report: &ScanReport) -> String {
    let within = format!(
        "{} iterations of {} with seed {}",
        report.spent.iterations, report.settings.strategy, report.settings.seed
    );
    match report.verdict {
        Verdict::HazardsFound => {
            let n = report.hazards.len();
            let confirmed = report.hazards.iter().filter(|h| h.confirmed == Some(true)).count();
            let s = if n == 1 { "" } else { "s" };
            format!(
                "{n} possible hazard{s}, {confirmed} confirmed by a fresh replay. Not finding more is not proof of safety."
            )
        }
        Verdict::NoneFound => format!("No hazard found in {within}. This is not proof of safety."),
        Verdict::Inconclusive => {
            "Inconclusive: nothing was found, but nothing could have been. See the note above.".to_owned()
        }
        Verdict::FmuFailed => {
            "The FMU failed: nothing was found in what could be evaluated, which says little.".to_owned()
        }
        Verdict::Interrupted => format!("Interrupted after {within}; nothing found so far."),
    }
}
