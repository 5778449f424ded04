//! The hazards as CSV, one row a group, columns in the order in which ISO 12100 assesses: what the hazard is (5.4), how
//! the risk is estimated (5.5), what is done (6), what is left. What people decided comes from their file.

use super::assessment::Assessments;
use super::model::ScanReport;

/// The columns. Units are in the names; person and contact in the world frame.
const COLUMNS: [&str; 32] = [
    "id",
    "cell",
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
    "speed_m_s",
    "safe_below_m_s",
    "time_s",
    "earliest_time_s",
    "times_found",
    "sequences",
    "confirmed",
    "severity",
    "exposure",
    "avoidance",
    "measure",
    "residual_risk",
    "decision",
    "by",
    "date",
];

/// The table, with a header.
///
/// # Errors
/// Never: it is written to memory.
pub fn table(report: &ScanReport, assessments: &Assessments) -> Result<String, ::csv::Error> {
    let mut to = ::csv::Writer::from_writer(Vec::new());
    to.write_record(COLUMNS)?;
    for hazard in &report.hazards {
        let reporting: Vec<&str> =
            hazard.sensors.iter().filter(|s| s.person_detected).map(|s| s.name.as_str()).collect();
        let actions: Vec<String> = hazard.shortest.actions.iter().map(ToString::to_string).collect();
        let person = assessments.get(&hazard.id).cloned().unwrap_or_default();
        let row: [String; COLUMNS.len()] = [
            hazard.id.clone(),
            report.subject.title(),
            hazard.sentence(),
            hazard.robot_link.clone(),
            hazard.body_region.to_string(),
            hazard.person_xy_m[0].to_string(),
            hazard.person_xy_m[1].to_string(),
            hazard.person_heading_deg.to_string(),
            hazard.contact_point_m[0].to_string(),
            hazard.contact_point_m[1].to_string(),
            hazard.contact_point_m[2].to_string(),
            reporting.join(" "),
            hazard.phase.map_or_else(String::new, |phase| phase.to_string()),
            actions.join(" "),
            hazard.force_n.to_string(),
            hazard.limit_n.to_string(),
            hazard.ratio.to_string(),
            hazard.speed_m_s.to_string(),
            hazard.safe_below_m_s.to_string(),
            hazard.time_s.to_string(),
            hazard.earliest_time_s.to_string(),
            hazard.times_found.to_string(),
            hazard.sequences.clone().unwrap_or_default(),
            hazard.confirmed.map_or_else(String::new, |yes| yes.to_string()),
            person.severity,
            person.exposure,
            person.avoidance,
            person.measure,
            person.residual,
            person.decision,
            person.by,
            person.date,
        ];
        to.write_record(row.map(harmless))?;
    }
    Ok(String::from_utf8_lossy(&to.into_inner().map_err(|e| e.into_error())?).into_owned())
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
}
