//! `explain`: its words and numbers, and that the changes it names do remove the hazard, while smaller ones do not: by scans
//! of every sequence in the changed cells.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::path::Path;

use common::{examples, fmi_hazard, json};
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
    let (code, _, said) = ran(dir, &["scan", &cell, "--strategy", "exhaustive", "--out", "changed"]);
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
    let (code, text, said) = ran(dir, &[&["explain", "first", id, "--format", "json"], more].concat());
    assert_eq!(code, Some(0), "{said}");
    (hazard, serde_json::from_str(&text).unwrap())
}

/// The change that begins with `words`, if it helps.
fn change<'a>(explanation: &'a Value, words: &str) -> Option<&'a str> {
    let remedies = explanation["remedies"].as_array().unwrap();
    let found = remedies.iter().find(|remedy| remedy["change"].as_str().unwrap().starts_with(words)).unwrap();
    found["outcome"].get("removed").map(|_| found["change"].as_str().unwrap())
}

/// The number behind a word.
fn number(text: &str, behind: &str) -> f64 {
    let (_, rest) = text.split_once(behind).unwrap_or_else(|| panic!("no {behind} in {text}"));
    rest.split_whitespace().next().unwrap().trim_end_matches([',', '.', 'x']).parse().unwrap()
}

#[test]
fn the_speed_that_it_names_is_the_highest_at_which_no_sequence_hurts() {
    let dir = examples();
    let dir = dir.path();
    let text = short(dir, "heavy-workpiece", 6);
    let (hazard, explanation) = explained(dir, "heavy-workpiece", &text, &[]);
    let region = hazard["body_region"].as_str().unwrap();
    let with = |v: f64| {
        let cell = format!("{text}\n[parameters]\n\"plc.v_limit\" = {v}\n");
        hazards(dir, "heavy-workpiece", &cell).iter().any(|(hit, _)| hit == region)
    };
    let limit = number(change(&explanation, "FMU parameter plc.v_limit").unwrap(), "= ");
    // One step is a hundredth of what it was, 0.48 m/s.
    assert!(!with(limit) && with(limit + 0.0048), "{limit}");
    // By hand: the force grows with the speed, so the limit is about 1/ratio of the old one; not exactly, as the point that
    // touches is not the tool centre point whose speed is limited.
    let expected = 0.48 / hazard["ratio"].as_f64().unwrap();
    assert!((limit - expected).abs() < 0.05, "{limit} {expected}");
}

#[test]
fn the_distance_that_it_names_is_the_smallest_in_which_no_sequence_hurts() {
    let dir = examples();
    let dir = dir.path();
    let text = short(dir, "head-collision", 5);
    let (hazard, explanation) = explained(dir, "head-collision", &text, &[]);
    let region = hazard["body_region"].as_str().unwrap();
    let base = "base = { xyz_m = [0, 0.7, 0.8975]";
    assert!(text.contains(base));
    let with = |farther: f64| {
        let cell = text.replace(base, &format!("base = {{ xyz_m = [0, {}, 0.8975]", 0.7 + farther));
        hazards(dir, "head-collision", &cell).iter().any(|(hit, _)| hit == region)
    };
    let farther = number(change(&explanation, "UR5e").unwrap(), "UR5e ");
    assert!(!with(farther) && with(farther - 0.01), "{farther}");
    // No speed but standstill is safe for a head; where the robot is slowed down to makes no difference above that.
    let slow = change(&explanation, "FMU parameter plc.v_reduced");
    assert!(slow.is_none_or(|slow| number(slow, "= ") == 0.0), "{slow:?}");
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
    for words in ["walks straight ahead, upright, for 0.2 s", "reports the person from", "changed.toml:", "verified"] {
        assert!(text.contains(words), "{words}: {text}");
    }
    assert!(!text.contains("Smallest changes"));
    // One that nobody knows, and one that is not there any more.
    let (code, _, said) = ran(dir, &["explain", "first", &format!("{id}0")]);
    assert!(code == Some(2) && said.contains(&format!("did you mean {id}?")), "{said}");
    let (code, _, said) = ran(dir, &["explain", "first", id, "--cell", "head-collision/fixed.toml"]);
    assert!(code == Some(2) && said.contains("is not there any more"), "{said}");
}
