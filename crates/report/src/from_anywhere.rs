//! What is known of people who come from anywhere, for a person at a terminal.

use std::fmt::Write as _;

use super::basis::rests_on;
use super::terminal::cards;
use super::view::View;
use fmi_hazard_record::model::{Headline, ScanReport};
use fmi_hazard_record::paragraph::wrapped_to;
use fmi_hazard_record::reachability::ReachabilityResult;

/// For people. `report` is the record of the same scan.
#[must_use]
pub fn render(anywhere: &ReachabilityResult, report: &ScanReport, view: View) -> String {
    let mut text = String::new();
    let width = view.width;
    let Headline { says, covers } = &report.headline;
    text += &wrapped_to(width, " ", says);
    text += &wrapped_to(width, " ", covers);
    text += &cards(report, view);
    for hazard in anywhere.hazards.iter().filter(|hazard| !hazard.confirmed) {
        let [x, y] = hazard.xy_m;
        let line = format!(
            "Not confirmed: {}, by somebody at ({x:.2}, {y:.2}) m who looks towards {:.0} degrees, {}{}",
            hazard.how_hard(),
            hazard.heading_deg,
            hazard.posture,
            if hazard.histories > 1 {
                format!("; in {} histories of what the sensors report", hazard.histories)
            } else {
                String::new()
            },
        );
        let _ = write!(text, "{}", wrapped_to(width, " ", &line));
    }
    text + &rests_on(&anywhere.obligations, view)
}
