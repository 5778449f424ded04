//! Strategies are compared the same by any number of workers, and told in every format.

#![expect(clippy::unwrap_used, reason = "a test fails where something is wrong")]

use assert_cmd::Command;

fn research() -> Command {
    Command::new(env!("CARGO_BIN_EXE_fmi-hazard-research"))
}

/// A comparison of two strategies on one cell.
fn bench(format: &str, more: &[&str]) -> String {
    let args = ["strategies", "--cells", "heavy-workpiece", "--strategies", "hybrid,random"];
    let rest = ["--seeds", "2", "--coverage-seeds", "2", "--iterations", "40", "--format", format];
    let output = research().args(args).args(rest).args(more).assert().code(0).get_output().clone();
    String::from_utf8(output.stdout).unwrap()
}

#[test]
#[ignore = "10 s: every sequence of eight actions; `different_hazards_are_counted_and_told_in_every_format` has the same without the complete list, and a unit test of `growth` calculates with one"]
fn recall_is_counted_against_the_complete_list() {
    let json: serde_json::Value = serde_json::from_str(&bench("json", &["--truth"])).unwrap();
    let cell = &json[0];
    assert_eq!((&cell["checkpoints"], &cell["notes"]), (&serde_json::json!([10, 20, 40]), &serde_json::json!([])));
    let all = cell["all_hazards"].as_f64().unwrap();
    assert!(all > 10.0);
    for row in cell["rows"].as_array().unwrap() {
        for run in row["runs"].as_array().unwrap() {
            let of = |name: &str| -> Vec<f64> {
                run["growth"][name].as_array().unwrap().iter().map(|v| v.as_f64().unwrap()).collect()
            };
            let (groups, recall, weighted) = (of("groups"), of("recall"), of("weighted_recall"));
            // Every hazard found is on the list, so the part of it follows from the number.
            assert!(groups.iter().zip(&recall).all(|(n, part)| (n / all - part).abs() < 1e-12), "{run}");
            assert!(recall.is_sorted() && weighted.is_sorted() && weighted.iter().all(|w| *w <= 1.0 + 1e-12), "{run}");
            assert!(run["growth"]["unknown"].as_array().unwrap().is_empty());
        }
    }
    let at_40 = |row: usize| cell["rows"][row]["recall_at"][2]["mean"].as_f64().unwrap();
    assert!(at_40(0) > at_40(1), "hybrid finds more of all hazards than random search: {} {}", at_40(0), at_40(1));
}

#[test]
fn different_hazards_are_counted_and_told_in_every_format() {
    let json: serde_json::Value = serde_json::from_str(&bench("json", &[])).unwrap();
    let cell = &json[0];
    assert_eq!((&cell["checkpoints"], &cell["notes"]), (&serde_json::json!([10, 20, 40]), &serde_json::json!([])));
    let at_40 = |row: usize| -> u64 {
        let runs = cell["rows"][row]["runs"].as_array().unwrap().iter();
        let last = runs.map(|run| {
            let groups: Vec<u64> =
                run["growth"]["groups"].as_array().unwrap().iter().map(|n| n.as_u64().unwrap()).collect();
            assert!(groups.len() == 3 && groups.is_sorted(), "{run}");
            groups[2]
        });
        last.sum()
    };
    assert!(at_40(0) > at_40(1), "hybrid finds more different hazards than random search: {cell}");
    let (text, csv, markdown) = (bench("table", &[]), bench("csv", &[]), bench("md", &[]));
    assert!(text.contains("Different hazards after so many iterations") && text.contains("at 20"), "{text}");
    assert!(csv.starts_with("cell,strategy,") && csv.contains("weighted_recall_at_40\n"), "{csv}");
    assert_eq!(markdown.lines().filter(|line| line.starts_with("| heavy-workpiece")).count(), 2, "{markdown}");
}

#[test]
fn the_number_of_workers_does_not_matter() {
    let bench = |workers: &str| {
        let args = ["strategies", "--cells", "sensor-mat", "--seeds", "3", "--coverage-seeds", "1"];
        let more = ["--iterations", "6", "--format", "json", "--workers", workers];
        research().args(args).args(more).assert().code(0).get_output().stdout.clone()
    };
    let one = bench("1");
    assert!(one == bench("3"));
    let comparison: serde_json::Value = serde_json::from_slice(&one).unwrap();
    assert_eq!(comparison[0]["rows"].as_array().unwrap().len(), 4);
}
