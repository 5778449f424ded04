//! `explain`: its words and numbers, and that after the changes it names nothing is hazardous, by scans of every sequence in
//! cells changed by hand. `advice.rs` has more of that.

use std::path::Path;

use crate::common::{examples, faulty_cell, fmi_hazard, json, nearer};
use crate::sample;
use serde_json::Value;

fn ran(dir: &Path, arguments: &[&str]) -> (Option<i32>, String, String) {
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap();
    (output.status.code(), text(output.stdout), text(output.stderr))
}

/// An example with fewer actions, so that every sequence is looked at within seconds.
fn short(dir: &Path, example: &str, actions: u32) -> String {
    let text = std::fs::read_to_string(dir.join(example).join("cell.toml")).unwrap();
    text + &format!("\n[search]\nactions = {actions}\n")
}

/// Body regions and links of all hazards of a cell, every sequence looked at.
fn hazards(dir: &Path, example: &str, text: &str) -> Vec<(String, String)> {
    std::fs::write(dir.join(example).join("changed.toml"), text).unwrap();
    let cell = format!("{example}/changed.toml");
    let (code, _, said) = ran(dir, &["scan", "--no-advice", &cell, "--strategy", "exhaustive", "--out", "changed"]);
    assert!(code.is_some_and(|code| code < 2), "{said}");
    let scan = json(&dir.join("changed/scan.json"));
    assert_eq!(scan["certificate"]["complete"], true);
    let words = |value: &Value| value.as_str().unwrap().to_owned();
    let all = scan["hazards"].as_array().unwrap().iter();
    all.map(|hazard| (words(&hazard["body_region"]), words(&hazard["robot_link"]))).collect()
}

/// The worst hazard of a cell, explained.
fn explained(dir: &Path, example: &str, text: &str, more: &[&str]) -> (Value, Value) {
    hazards(dir, example, text);
    std::fs::remove_dir_all(dir.join("first")).ok();
    std::fs::rename(dir.join("changed"), dir.join("first")).unwrap();
    let hazard = json(&dir.join("first/scan.json"))["hazards"][0].clone();
    let id = hazard["id"].as_str().unwrap();
    let (code, text, said) =
        ran(dir, &[&["explain", "first", id, "--from", "start", "--format", "json"], more].concat());
    assert_eq!(code, Some(0), "{said}");
    (hazard, serde_json::from_str(&text).unwrap())
}

/// What came of the change that begins with `words`.
fn remedy<'a>(explanation: &'a Value, words: &str) -> &'a Value {
    let remedies = explanation["remedies"].as_array().unwrap();
    remedies.iter().find(|remedy| remedy["change"].as_str().unwrap().starts_with(words)).unwrap()
}

/// The same change, if it is enough.
fn change<'a>(explanation: &'a Value, words: &str) -> Option<&'a str> {
    let found = remedy(explanation, words);
    found["outcome"].get("sufficient").map(|_| found["change"].as_str().unwrap())
}

/// Whether the hazard that one step less leads to begins where the cell says and within its time, so that a scan of the cell
/// meets it.
fn one_less_is_within(explanation: &Value, words: &str, actions: usize) -> bool {
    let met = &remedy(explanation, words)["outcome"]["sufficient"]["one_less"]["met"];
    let length = met["actions"].as_array().unwrap().len();
    met["from"].is_null() && length <= actions
}

/// The number behind a word.
fn number(text: &str, behind: &str) -> f64 {
    let (_, rest) = text.split_once(behind).unwrap_or_else(|| panic!("no {behind} in {text}"));
    rest.split_whitespace().next().unwrap().trim_end_matches([',', '.', 'x']).parse().unwrap()
}

/// What else could be changed in this cell, each of which would be tried.
const OTHERS_STAY: &str = r#"[explain.parameters]
"plc.t_react" = { fixed = true }
"ctrl.t_ramp" = { fixed = true }
"ctrl.speed_scale" = { fixed = true }
[explain.obstacle]
table = { fixed = true }
"#;

#[test]
fn the_distance_that_it_names_is_the_smallest_in_which_no_sequence_hurts() {
    if !sample::is_turn(1, 12) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let text = short(dir, "head-collision", 5) + if sample::is_whole() { "" } else { OTHERS_STAY };
    let (_, explanation) = explained(dir, "head-collision", &text, &["--iterations", "8"]);
    let base = "base = { xyz_m = [0, 0.7, 0.8975]";
    assert!(text.contains(base));
    let with = |farther: f64| {
        let cell = text.replace(base, &format!("base = {{ xyz_m = [0, {}, 0.8975]", 0.7 + farther));
        !hazards(dir, "head-collision", &cell).is_empty()
    };
    let farther = number(change(&explanation, "UR5e").unwrap(), "UR5e ");
    assert!(!with(farther), "{farther}");
    if one_less_is_within(&explanation, "UR5e", 5) {
        assert!(with(farther - 0.01), "{farther}");
    }
    // Where to the robot slows down makes no difference: any motion is too much for a head.
    assert_eq!(change(&explanation, "FMU parameter plc.v_reduced"), None);
    // A zone in which the person starts would be a cell that stands still.
    let zone = remedy(&explanation, "zone of field");
    assert!(
        zone["change"].as_str().unwrap() < "zone of field 0.70" && zone["outcome"].get("sufficient").is_none(),
        "{zone}"
    );
}

#[test]
fn words_and_numbers() {
    let dir = examples();
    let dir = dir.path();
    let text = short(dir, "head-collision", 5);
    let (hazard, explanation) = explained(dir, "head-collision", &text, &["--no-changes"]);
    assert_eq!(explanation["hazard"], hazard);
    let id = hazard["id"].as_str().unwrap();
    let (code, text, _) = ran(dir, &["explain", "first", id, "--no-changes"]);
    assert_eq!(code, Some(0));
    let text = text.split_whitespace().collect::<Vec<_>>().join(" ");
    // The formula gives the force, and its parts are those that the standard says, with the numbers as printed.
    let [v, k] = [number(&text, "mu k) = "), number(&text, "kg x ")];
    let [mu, m_r, m_h] = ["mu ", "m_R ", "m_H "].map(|symbol| number(&text, &format!(" {symbol}")));
    let force = v * (mu * k * 1000.0).sqrt();
    assert!((force - hazard["force_n"].as_f64().unwrap()).abs() < 0.01 * force, "{text}");
    assert!((mu - 1.0 / (1.0 / m_r + 1.0 / m_h)).abs() < 2e-3, "{text}");
    let payload = number(text.split("half of M = ").nth(1).unwrap(), ") and ");
    assert!((m_r - (number(&text, "half of M = ") / 2.0 + payload)).abs() < 0.01, "{text}");
    for words in [
        "walks straight ahead, upright, for 0.2 s",
        "reports the person from",
        "changed.toml:",
        "not yet verified against",
        "not allowed at all",
        "No speed is safe: only a robot that stands",
    ] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(!text.contains("Smallest changes") && !text.contains("Safe below"));
    // One that nobody knows, and one that is not there any more.
    let (code, _, said) = ran(dir, &["explain", "first", &format!("{id}0")]);
    assert!(code == Some(2) && said.contains(&format!("did you mean {id}?")), "{said}");
    let (code, _, said) = ran(dir, &["explain", "first", id, "--cell", "head-collision/fixed.toml"]);
    assert!(code == Some(2) && said.contains("is not there any more"), "{said}");
}

#[test]
fn a_scan_of_an_fmu_with_a_cell_file_elsewhere_is_explained_and_replayed_from_what_it_recorded() {
    let dir = examples();
    let dir = dir.path();
    let text = short(dir, "head-collision", 5).replace("fmu = \"head-collision.fmu\"\n", "");
    std::fs::write(dir.join("mine.toml"), &text).unwrap();
    let fmu = "head-collision/head-collision.fmu";
    let (code, _, said) =
        ran(dir, &["scan", "--no-advice", fmu, "--cell", "mine.toml", "--strategy", "exhaustive", "--out", "first"]);
    assert_eq!(code, Some(1), "{said}");
    let id = json(&dir.join("first/scan.json"))["hazards"][0]["id"].as_str().unwrap().to_owned();
    let (code, _, said) = ran(dir, &["explain", "first", &id, "--no-changes"]);
    assert!(code == Some(0) && !said.contains("changed"), "{said}");
    std::fs::rename(dir.join("mine.toml"), dir.join("moved.toml")).unwrap();
    for command in [&["explain", "first", &id, "--no-changes"][..], &["replay", "first", &id]] {
        let (code, _, said) = ran(dir, command);
        assert!(code == Some(2) && said.contains("mine.toml"), "{said}");
        let (code, text, said) = ran(dir, &[command, &["--cell", "moved.toml"]].concat());
        assert!(code < Some(2) && text.contains(&id) && !said.contains("changed"), "{said}");
    }
    // A contact that is as hard at the same time, with another link, is another one.
    let (_, replayed, _) = ran(dir, &["replay", "first", &id, "--cell", "moved.toml"]);
    assert!(replayed.contains(&format!("{id} reproduced: ")), "{replayed}");
    let mut recorded = json(&dir.join("first/scan.json"));
    recorded["hazards"][0]["robot_link"] = "another".into();
    std::fs::write(dir.join("first/scan.json"), recorded.to_string()).unwrap();
    let (_, replayed, _) = ran(dir, &["replay", "first", &id, "--cell", "moved.toml"]);
    assert!(replayed.contains(&format!("{id} DIFFERS: ")) && replayed.contains("<- another)"), "{replayed}");
    // Another cell is told to be another.
    std::fs::write(dir.join("moved.toml"), text.replace("actions = 5", "actions = 6")).unwrap();
    let (_, _, said) = ran(dir, &["replay", "first", &id, "--cell", "moved.toml"]);
    assert!(said.contains("Warning the cell file has changed"), "{said}");
}

#[test]
fn a_zone_that_reaches_the_start_and_one_that_stops_nothing_remove_nothing() {
    let dir = tempfile::TempDir::new().unwrap();
    let dir = dir.path();
    std::fs::copy(crate::common::test_fmus().join("faulty.fmu"), dir.join("faulty.fmu")).unwrap();
    // A turning table with a mat beside which the person starts.
    std::fs::write(dir.join("cell.toml"), nearer(&faulty_cell("faulty.fmu", 0, 0))).unwrap();
    let (code, _, said) = ran(dir, &["scan", "--no-advice", "cell.toml", "--strategy", "hybrid", "--out", "out"]);
    assert_eq!(code, Some(1), "{said}");
    let id = json(&dir.join("out/scan.json"))["hazards"][0]["id"].as_str().unwrap().to_owned();
    let (code, text, said) = ran(dir, &["explain", "out", &id, "--from", "start", "--format", "json"]);
    assert_eq!(code, Some(0), "{said}");
    let explanation: Value = serde_json::from_str(&text).unwrap();
    // The mat's edge is 0.2 m from the start: nothing that is wider was tried to the end.
    let mat = remedy(&explanation, "zone of mat");
    let limit = mat["outcome"]["no_help"]["limit"].as_str().unwrap();
    assert_eq!(limit, "mat then reports the person at the start already");
    assert!(number(mat["change"].as_str().unwrap(), "zone of mat ") <= 0.2, "{mat}");
    // The bar is 1.4 m long, and the person walks after it.
    assert_eq!(change(&explanation, "turntable"), None);
}
