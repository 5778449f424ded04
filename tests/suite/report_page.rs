//! `report.html` of example cells in a browser: see `viewer/test/report.mjs` for what is checked. Needs what
//! `tools/test` installs: Chromium, and the viewer's packages.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::common::stored::scanned;
use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;

/// Arguments for few sequences.
fn few<'a>(cell: &'a str, out: &'a str) -> [&'a str; 8] {
    [cell, "--no-advice", "--strategy", "hybrid", "--iterations", "12", "--out", out]
}

/// A scan with few sequences and what lies beside the cell; the page.
fn page(dir: &Path, cell: &str, out: &str) -> PathBuf {
    let code = scanned(dir, &few(cell, out)).code;
    assert!(matches!(code, Some(1 | 4)), "{cell}: {code:?}");
    dir.join(out).join("report.html")
}

fn opened_in_a_browser(options: &[&str], pages: &[PathBuf]) -> String {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("viewer/test/check_report.mjs");
    let output = Command::new("node").arg(script).args(options).args(pages).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    text
}

/// Decisions on a hazard that is not in the report.
const GIVEN: &str = r#"{"format":1,"assessments":{"H-000000":{"decision":"accepted","by":"somebody"}}}"#;

/// Opens the pages of cells, the first of which has decisions beside it, each with its options.
fn opened(cells: &[&str], options: &[&[&str]]) {
    let dir = examples();
    let dir = dir.path();
    let beside = dir.join(cells[0]).join("assessments.json");
    std::fs::write(&beside, GIVEN).unwrap();
    let pages: Vec<PathBuf> =
        cells.iter().map(|cell| page(dir, &format!("{cell}/cell.toml"), &format!("{cell}-out"))).collect();
    let mut said = String::new();
    for (page, options) in pages.iter().zip(options) {
        let bytes = std::fs::metadata(page).unwrap().len();
        assert!(bytes < 2_000_000, "{}: {bytes} bytes", page.display());
        said += &opened_in_a_browser(options, std::slice::from_ref(page));
    }
    // The picture of a scene that is blank does not change.
    let blank = (!options.contains(&&["--quick"][..])).then_some("draws a scene that is not blank");
    for check in ["scrubbing changes the picture", "the form saves", "a link with an id"].into_iter().chain(blank) {
        assert_eq!(said.matches(check).count(), cells.len(), "{check}: {said}");
    }
    assert_eq!(std::fs::read_to_string(beside).unwrap(), GIVEN, "never written");
    assert!(std::fs::read_to_string(&pages[0]).unwrap().contains("\"by\":\"somebody\""));
}

#[test]
fn a_report_opens_moves_and_saves_in_a_browser() {
    if !sample::is_turn(3, 4) {
        return;
    }
    opened(&["heavy-workpiece"], &[&["--quick"]]);
}

/// One of each kind: an arm over a zone, two robots, and all checks for a body without a sensor; the main ones for the others.
#[test]
#[ignore = "minutes: three pages with pictures of full size; one of them is `a_report_opens_moves_and_saves_in_a_browser`"]
fn every_report_opens_moves_and_saves_in_a_browser() {
    let main = &["--main"][..];
    opened(&["head-collision", "two-scanners", "heavy-workpiece"], &[main, main, &[]]);
}

/// A page without hazards, of a cell that counts more than the force, and one of a cell whose names are a stranger's.
fn none_and_wild(dir: &Path) -> [PathBuf; 2] {
    let fixed = dir.join("heavy-workpiece/fixed.toml");
    let text = std::fs::read_to_string(&fixed).unwrap() + "\n[criteria]\nmoving_contact = { faster_than_m_s = 20.0 }\n";
    std::fs::write(&fixed, text).unwrap();
    let none = page(dir, "heavy-workpiece/fixed.toml", "none");
    assert!(scan_json(&dir.join("none"))["hazards"].as_array().unwrap().is_empty());
    let cell = dir.join("heavy-workpiece/cell.toml");
    let text = std::fs::read_to_string(&cell).unwrap();
    let name = text.lines().find(|line| line.starts_with("name = ")).unwrap().to_owned();
    let wild = r#"name = "</script><img src=x onerror=alert(1)>&amp;""#;
    std::fs::write(&cell, text.replacen(&name, wild, 1)).unwrap();
    [none, page(dir, "heavy-workpiece/cell.toml", "wild")]
}

#[test]
fn a_report_without_hazards_and_one_of_a_hostile_cell_open_too() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let dir = examples();
    let checks = ["works without a hazard", "puts nothing of the data into the page as markup"];
    for (page, check) in sample::some(none_and_wild(dir.path()).into_iter().zip(checks), 2) {
        let said = opened_in_a_browser(&["--flat"], &[page]);
        assert_eq!(said.matches(check).count(), 1, "{check}: {said}");
    }
}

#[test]
#[ignore = "most of a minute: with 3-D graphics; without them `a_report_without_hazards_and_one_of_a_hostile_cell_open_too`"]
fn a_report_without_hazards_and_one_of_a_hostile_cell_open_in_three_dimensions_too() {
    let dir = examples();
    let [none, wild] = none_and_wild(dir.path());
    opened_in_a_browser(&[], &[none]);
    opened_in_a_browser(&["--main"], &[wild]);
}

/// Two scans that are really made.
#[test]
fn the_same_scan_gives_the_same_page_and_tables() {
    let dir = examples();
    let dir = dir.path();
    for out in ["one", "two"] {
        fmi_hazard(dir).arg("scan").args(few("head-collision/cell.toml", out)).assert().code(1);
    }
    for file in ["report.html", "causes.csv", "hazards.csv", "hazards.sarif", "junit.xml"] {
        let read = |out: &str| std::fs::read(dir.join(out).join(file)).unwrap();
        assert!(read("one") == read("two"), "{file}");
    }
}
