//! `report.html` of every example cell in a browser: see `viewer/test/report.mjs` for what is checked. Needs what
//! `tools/test` installs: Chromium, and the viewer's packages.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::common::{examples, fmi_hazard, scan_json};

/// A scan with few sequences and a file of decisions beside the cell; the page.
fn page(dir: &Path, cell: &str, out: &str) -> PathBuf {
    let few = ["--strategy", "hybrid", "--iterations", "12", "--out", out];
    let code = fmi_hazard(dir).args(["scan", "--no-advice"]).arg(cell).args(few).assert().get_output().status.code();
    assert!(code.is_some_and(|code| code < 2), "{cell}: {code:?}");
    dir.join(out).join("report.html")
}

fn opened_in_a_browser(options: &[&str], pages: &[PathBuf]) -> String {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("viewer/test/check_report.mjs");
    let output = Command::new("node").arg(script).args(options).args(pages).output().unwrap();
    let text = String::from_utf8_lossy(&output.stdout).into_owned();
    assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
    text
}

#[test]
fn every_report_opens_moves_and_saves_in_a_browser() {
    let dir = examples();
    let dir = dir.path();
    // One of each kind: an arm over a zone, two robots, and all checks for a body without a sensor.
    let cells = ["head-collision", "light-curtain", "two-scanners", "heavy-workpiece"];
    let given = r#"{"format":1,"assessments":{"H-000000":{"decision":"accepted","by":"somebody"}}}"#;
    std::fs::write(dir.join("head-collision/assessments.json"), given).unwrap();
    let pages: Vec<PathBuf> =
        cells.iter().map(|cell| page(dir, &format!("{cell}/cell.toml"), &format!("{cell}-out"))).collect();
    for page in &pages {
        let bytes = std::fs::metadata(page).unwrap().len();
        assert!(bytes < 2_000_000, "{}: {bytes} bytes", page.display());
    }
    // All checks for one of them, the main ones for the others.
    let said = opened_in_a_browser(&[], &pages[3..]) + &opened_in_a_browser(&["--main"], &pages[..3]);
    for check in
        ["draws a scene that is not blank", "scrubbing changes the picture", "the form saves", "a link with an id"]
    {
        assert_eq!(said.matches(check).count(), cells.len(), "{check}: {said}");
    }
    assert_eq!(std::fs::read_to_string(dir.join("head-collision/assessments.json")).unwrap(), given, "never written");
    assert!(std::fs::read_to_string(&pages[0]).unwrap().contains("\"by\":\"somebody\""));
}

#[test]
fn a_report_without_hazards_and_one_of_a_hostile_cell_open_too() {
    let dir = examples();
    let dir = dir.path();
    let none = page(dir, "heavy-workpiece/fixed.toml", "none");
    assert!(scan_json(&dir.join("none"))["hazards"].as_array().unwrap().is_empty());
    // Names are a stranger's.
    let cell = dir.join("heavy-workpiece/cell.toml");
    let text = std::fs::read_to_string(&cell).unwrap();
    let name = text.lines().find(|line| line.starts_with("name = ")).unwrap().to_owned();
    let wild = r#"name = "</script><img src=x onerror=alert(1)>&amp;""#;
    std::fs::write(&cell, text.replacen(&name, wild, 1)).unwrap();
    let wild = page(dir, "heavy-workpiece/cell.toml", "wild");
    opened_in_a_browser(&[], &[none]);
    opened_in_a_browser(&["--main"], &[wild]);
}

#[test]
fn the_same_scan_gives_the_same_page_and_tables() {
    let dir = examples();
    let dir = dir.path();
    page(dir, "head-collision/cell.toml", "one");
    page(dir, "head-collision/cell.toml", "two");
    for file in ["report.html", "causes.csv", "hazards.csv", "hazards.sarif", "junit.xml"] {
        let read = |out: &str| std::fs::read(dir.join(out).join(file)).unwrap();
        assert!(read("one") == read("two"), "{file}");
    }
}
