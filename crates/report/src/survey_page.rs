//! `campaign.html`: what came out of a campaign, for people. One file, no network, no script.

use std::fmt::Write as _;

use super::survey::{State, Survey};
use super::survey_charts::Chart;

/// Most scans in the page; the others are in `campaign.csv`.
const MOST: usize = 2000;

const STYLE: &str = "body{font:15px/1.45 system-ui,sans-serif;color:#1c2430;max-width:70rem;margin:2rem auto;padding:0 1rem}\
table{border-collapse:collapse;margin:1rem 0;font-variant-numeric:tabular-nums}\
th,td{padding:.25rem .7rem;border-bottom:1px solid #dfe3e9;text-align:left}\
.none{color:#1a7f4b}.open{color:#8a6d00}.hazards{color:#b3140d;font-weight:600}\
svg{max-width:100%;height:auto}figcaption{color:#566273}";

/// The page.
#[must_use]
pub fn render(survey: &Survey, pictures: &[Chart]) -> String {
    let name = escaped(&survey.campaign);
    let mut page = format!(
        "<!doctype html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{name}: campaign</title>\
         <meta name=\"viewport\" content=\"width=device-width\"><style>{STYLE}</style></head><body>\n<h1>{name}</h1>\n"
    );
    let scans = survey.scans.len();
    let hit = survey.scans.iter().filter(|row| row.outcome.state == State::Hazards).count();
    let open = survey.scans.iter().filter(|row| row.outcome.state == State::Open).count();
    let _ = writeln!(
        page,
        "<p>{scans} scans: {hit} with hazards, {open} without but not complete, {} without where every sequence was looked at. \
         No scan proves that a cell is safe: each is about its model, its actions and its horizon.</p>",
        scans - hit - open
    );
    for margin in &survey.margins {
        let _ = writeln!(page, "<p><strong>{}</strong></p>", escaped(&margin.sentence()));
    }
    page += "<h2>Cells</h2>\n<table><tr><th>cell<th>body<th>scans<th>with hazards<th>hazards<th>worst<th>says</tr>\n";
    for cell in &survey.cells {
        let worst = cell.worst_ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.2}x"));
        let _ = writeln!(
            page,
            "<tr><td>{}<td>{}<td>{}<td>{}<td>{}<td>{worst}<td class=\"{}\">{}</tr>",
            escaped(&cell.cell),
            escaped(cell.body.as_deref().unwrap_or("-")),
            cell.scans,
            cell.hazardous_scans,
            cell.hazards,
            class(cell.state),
            cell.state.words()
        );
    }
    page += "</table>\n";
    for picture in pictures {
        let _ =
            writeln!(page, "<figure>{}<figcaption>{}</figcaption></figure>", picture.svg, escaped(&picture.caption));
    }
    page += "<h2>Scans</h2>\n<table><tr><th>scan<th>cell<th>begins<th>strategy<th>hazards<th>worst<th>says\
             <th>arm boxes<th>FMU steps</tr>\n";
    for row in survey.scans.iter().take(MOST) {
        let outcome = &row.outcome;
        let worst = outcome.worst.as_ref();
        let worst = worst.map_or_else(
            || "-".to_owned(),
            |w| format!("{:.2}x {} &larr; {}", w.ratio, w.body_region, escaped(&w.robot_link)),
        );
        let seed = row.seed.map_or_else(String::new, |seed| format!(", seed {seed}"));
        let _ = writeln!(
            page,
            "<tr><td><a href=\"{folder}/scan.json\">{}</a><td>{}<td>{}<td>{}{seed}<td>{}<td>{worst}<td class=\"{}\">{}<td>{}<td>{}</tr>",
            row.number,
            escaped(&row.cell),
            row.begins.words(),
            row.strategy,
            outcome.hazards,
            class(outcome.state),
            outcome.state.words(),
            outcome.cost.arm_boxes,
            outcome.cost.fmu_steps,
            folder = row.folder,
        );
    }
    page += "</table>\n";
    if scans > MOST {
        let _ = writeln!(page, "<p>And {} more, in <code>campaign.csv</code>.</p>", scans - MOST);
    }
    let _ = writeln!(
        page,
        "<p>All together: {} arm boxes, {} contact checks, {} FMU steps. <code>fmi-hazard report</code> makes the report of one scan \
         from its folder. Made by {}.</p>\n</body></html>",
        survey.cost.arm_boxes,
        survey.cost.contact_checks,
        survey.cost.fmu_steps,
        escaped(&survey.tool)
    );
    page
}

const fn class(state: State) -> &'static str {
    match state {
        State::None => "none",
        State::Open => "open",
        State::Hazards => "hazards",
    }
}

fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

#[cfg(test)]
mod tests {
    use super::super::survey::tests::survey;
    use super::super::survey_charts::all;
    use super::*;

    #[test]
    fn names_are_escaped_and_every_scan_has_a_row() {
        let mut survey = survey(&[State::Hazards, State::None]);
        survey.campaign = "a < b".to_owned();
        let page = render(&survey, &all(&survey));
        assert!(page.contains("<h1>a &lt; b</h1>") && page.contains("a&lt;b") && !page.contains("a<b"), "{page}");
        assert_eq!(page.matches("scan.json\">").count(), 2);
        assert_eq!(page.matches("<svg").count(), 2);
        assert!(page.contains("no hazard from 0.2 m on") && !page.contains("<script"));
    }
}
