//! The hazards as CSV, one row each, and their causes, which are what one assesses. Columns stand in the order in which ISO
//! 12100 assesses: what the hazard is (5.4), how the risk is estimated (5.5), what is done (6), what is left. What people
//! decided comes from their file; what they decided about a cause holds for its hazards, unless they said otherwise.

use std::collections::BTreeMap;

use super::assessment::{Assessment, Assessments};
use crate::hazard::criterion::Class;
use crate::standards::iso_13849::required_performance_level;
use fmi_hazard_record::cause::Cause;
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::judged::Judged;
use fmi_hazard_record::model::ScanReport;

/// What ISO 12100, Table B.1 calls what this program can find: group, origin, consequence.
const KIND: [&str; 3] = ["mechanical", "moving elements", "impact"];

/// Columns of both tables that tell what kind of hazard it is.
const KIND_COLUMNS: [&str; 4] = ["task", "hazard_group", "origin", "consequence"];

/// Columns of both tables that people fill.
const PERSON_COLUMNS: [&str; 9] = [
    "severity",
    "exposure",
    "avoidance",
    "required_performance_level",
    "measure",
    "residual_risk",
    "decision",
    "by",
    "date",
];

/// The columns of hazards between these. Units are in the names; person and contact in the world frame.
const HAZARD_COLUMNS: [&str; 23] = [
    "hazard",
    "hit_by",
    "body_region",
    "person_x_m",
    "person_y_m",
    "person_heading_deg",
    "contact_x_m",
    "contact_y_m",
    "contact_z_m",
    "sensors_reporting",
    "phase",
    "shortest_actions",
    "force_n",
    "limit_n",
    "ratio",
    "approach_ratio",
    "speed_m_s",
    "safe_below_m_s",
    "time_s",
    "earliest_time_s",
    "times_found",
    "sequences",
    "confirmed",
];

/// The columns of causes between these.
const CAUSE_COLUMNS: [&str; 13] = [
    "what_is_wrong",
    "robot",
    "part_of_the_person",
    "hit",
    "force_n",
    "limit_n",
    "ratio",
    "earliest_time_s",
    "hazards",
    "confirmed",
    "share_of_sequences_percent",
    "worst_hazard",
    "smallest_change",
];

/// Further columns of both tables where more or other counts than the transient force: what is broken worst, whether the part of
/// the body can give way, what the limit is one of, what holds it, and the measure in words.
const CRITERION_COLUMNS: [&str; 5] = ["criterion", "contact_kind", "limit_kind", "held_against", "measure_and_limit"];

/// The last column of hazards where there are two people: who of them is hit.
const WHOM_COLUMN: &str = "who_is_hit";

/// What they say of a hazard or a cause.
fn criterion(class: Class, judged: Option<&Judged>, measure: String) -> Vec<String> {
    let text = |value: Option<String>| value.unwrap_or_default();
    vec![
        class.name().to_owned(),
        text(judged.map(|judged| judged.contact.name().to_owned())),
        text(judged.map(|judged| judged.limit.name().to_owned())),
        text(judged.and_then(|judged| judged.clamping.as_ref()).map(|clamping| clamping.against.clone())),
        measure,
    ]
}

/// What the part of the body suffers, as ISO 12100, Table B.1 calls it.
const fn consequence(class: Class) -> &'static str {
    match class {
        Class::Clamping => "crushing",
        _ => KIND[2],
    }
}

/// The table of hazards, with a header.
///
/// # Errors
/// Never: it is written to memory.
pub fn hazards(report: &ScanReport, assessments: &Assessments) -> Result<String, ::csv::Error> {
    let cause_of: BTreeMap<&str, &str> =
        report.causes.iter().flat_map(|c| c.hazards.iter().map(|id| (id.as_str(), c.id.as_str()))).collect();
    let more: &[&str] = if report.settings.criteria.is_some() { &CRITERION_COLUMNS } else { &[] };
    let whom: &[&str] = if report.settings.second.is_some() { &[WHOM_COLUMN] } else { &[] };
    let header: Vec<&str> =
        [&["id", "cause", "cell"], &KIND_COLUMNS[..], &HAZARD_COLUMNS, &PERSON_COLUMNS, more, whom].concat();
    let row = |hazard: &Hazard| {
        let cause = cause_of.get(hazard.id.as_str()).copied().unwrap_or_default();
        let person = assessments.get(&hazard.id).or_else(|| assessments.get(cause)).cloned().unwrap_or_default();
        let reporting: Vec<&str> =
            hazard.sensors.iter().filter(|s| s.person_detected).map(|s| s.name.as_str()).collect();
        let actions: Vec<String> = hazard.shortest.actions.iter().map(ToString::to_string).collect();
        let own: [String; HAZARD_COLUMNS.len()] = [
            hazard.sentence(),
            hazard.robot_link.clone(),
            hazard.body_region.to_string(),
            metres(hazard.person_xy_m[0]),
            metres(hazard.person_xy_m[1]),
            format!("{:.0}", hazard.person_heading_deg.rem_euclid(360.0)),
            metres(hazard.contact_point_m[0]),
            metres(hazard.contact_point_m[1]),
            metres(hazard.contact_point_m[2]),
            reporting.join(" "),
            hazard.phase.map_or_else(String::new, |phase| phase.to_string()),
            actions.join(" "),
            format!("{:.0}", hazard.deciding_force_n()),
            format!("{:.0}", hazard.limit_n),
            format!("{:.2}", hazard.ratio),
            format!("{:.2}", hazard.directed_ratio),
            format!("{:.2}", hazard.speed_m_s),
            format!("{:.2}", hazard.safe_below_m_s),
            format!("{:.2}", hazard.time_s),
            format!("{:.2}", hazard.earliest_time_s),
            hazard.times_found.to_string(),
            hazard.sequences.clone().unwrap_or_default(),
            hazard.confirmed.map_or_else(String::new, |yes| yes.to_string()),
        ];
        let judged = hazard.judged.as_ref();
        let mut row = whole([&hazard.id, cause, &report.subject.title()], hazard.class, own.to_vec(), &person);
        if !more.is_empty() {
            row.extend(criterion(hazard.class, judged, hazard.measure_words()));
        }
        if !whom.is_empty() {
            row.push(hazard.person.clone().unwrap_or_default());
        }
        row
    };
    written(&header, report.hazards.iter().map(row))
}

/// The table of causes, with a header.
///
/// # Errors
/// Never: it is written to memory.
pub fn causes(report: &ScanReport, assessments: &Assessments) -> Result<String, ::csv::Error> {
    let more: &[&str] = if report.settings.criteria.is_some() { &CRITERION_COLUMNS } else { &[] };
    let header: Vec<&str> = [&["id", "cell"], &KIND_COLUMNS[..], &CAUSE_COLUMNS, &PERSON_COLUMNS, more].concat();
    let row = |cause: &Cause| {
        let person = assessments.get(&cause.id).cloned().unwrap_or_default();
        let mut hit: Vec<&str> = Vec::new();
        for line in &cause.lines {
            let region = line.words();
            if !hit.contains(&region) {
                hit.push(region);
            }
        }
        let change = cause.advice.iter().flat_map(|advice| advice.changes.first());
        let own: [String; CAUSE_COLUMNS.len()] = [
            cause.sentence.clone(),
            cause.robot.clone(),
            cause.part.words().to_owned(),
            hit.join(", "),
            format!("{:.0}", cause.force_n),
            format!("{:.0}", cause.limit_n),
            format!("{:.2}", cause.ratio),
            format!("{:.2}", cause.earliest_time_s),
            cause.hazards.len().to_string(),
            cause.confirmed.to_string(),
            cause.share.map_or_else(String::new, |share| {
                format!("{:.2e}", 100.0 * share).parse::<f64>().unwrap_or(0.0).to_string()
            }),
            cause.worst.clone(),
            change.map(|change| change.change.clone()).collect(),
        ];
        let mut row = whole([&cause.id, &report.subject.title()], cause.class, own.to_vec(), &person);
        if !more.is_empty() {
            row.extend(criterion(cause.class, cause.judged.as_ref(), cause.force_words()));
        }
        row
    };
    written(&header, report.causes.iter().map(row))
}

/// A row: what it is about, of which kind, its own columns, what people decided.
fn whole<const N: usize>(first: [&str; N], class: Class, own: Vec<String>, person: &Assessment) -> Vec<String> {
    let level = required_performance_level(&person.severity, &person.exposure, &person.avoidance);
    let mut row: Vec<String> = first.map(str::to_owned).to_vec();
    row.push(person.task.clone());
    row.extend([KIND[0], KIND[1], consequence(class)].map(str::to_owned));
    row.extend(own);
    row.extend([&person.severity, &person.exposure, &person.avoidance].map(Clone::clone));
    row.push(level.map_or_else(String::new, String::from));
    row.extend([&person.measure, &person.residual, &person.decision, &person.by, &person.date].map(Clone::clone));
    row
}

fn written(header: &[&str], rows: impl Iterator<Item = Vec<String>>) -> Result<String, ::csv::Error> {
    let mut to = ::csv::Writer::from_writer(Vec::new());
    to.write_record(header)?;
    for row in rows {
        to.write_record(row.into_iter().map(harmless))?;
    }
    Ok(String::from_utf8_lossy(&to.into_inner().map_err(|e| e.into_error())?).into_owned())
}

/// To the millimetre, and never a negative zero.
fn metres(length_m: f64) -> String {
    format!("{:.3}", (1000.0 * length_m).round() / 1000.0 + 0.0)
}

/// Names come from strangers: a cell that begins like a formula would be run by a spreadsheet.
fn harmless(cell: String) -> String {
    let risky =
        cell.starts_with(['=', '+', '@', '\t', '\r']) || (cell.starts_with('-') && cell.parse::<f64>().is_err());
    if risky { format!("'{cell}") } else { cell }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fmi_hazard_record::fixtures;

    #[test]
    fn formulas_are_text_and_negative_numbers_are_numbers() {
        for (cell, written) in [
            ("=1+1", "'=1+1"),
            ("-0.25", "-0.25"),
            ("-1e-3", "-1e-3"),
            ("-cmd", "'-cmd"),
            ("@x", "'@x"),
            ("tool", "tool"),
        ] {
            assert_eq!(harmless(cell.to_owned()), written);
        }
    }

    #[test]
    fn what_was_decided_of_a_cause_holds_for_its_hazards_unless_they_have_their_own() {
        let ids = ["H-000001", "H-000002", "H-000003"];
        let found = ids.map(|id| fixtures::hazard(id, 1.5)).to_vec();
        let report = fixtures::report(found, vec![fixtures::cause("C-000001", &ids[..2])]);
        let by = |id: &str, by: &str| (id.to_owned(), Assessment { by: by.to_owned(), ..Assessment::default() });
        let assessments = Assessments::from([by("C-000001", "of the cause"), by("H-000002", "of the hazard")]);
        let table = hazards(&report, &assessments).unwrap();
        let mut rows = ::csv::Reader::from_reader(table.as_bytes());
        let column = rows.headers().unwrap().iter().position(|name| name == "by").unwrap();
        let told: Vec<String> = rows.records().map(|row| row.unwrap()[column].to_owned()).collect();
        assert_eq!(told, ["of the cause", "of the hazard", ""]);
    }
}
