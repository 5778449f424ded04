//! The strategies on the example cells: each finds the hazard of the safety fence, repeats itself, and is compared the
//! same by any number of workers.

use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;
use fmi_hazard::scan::{StateChoice, prepare::prepare};
use fmi_hazard::search::{Environment as _, Imagine as _, Rng};

const CELL: &str = "safety-fence/cell.toml";

#[test]
fn each_finds_the_hazard_of_the_fence_and_repeats_itself() {
    if !sample::is_turn(0, 3) {
        return;
    }
    let dir = examples();
    // Planning meets it in the second sequence: the robot does not react there, so what is imagined is true.
    for (strategy, iterations) in [("plan", "2"), ("hybrid", "6")] {
        let scan = |out: &str| {
            let out = format!("{strategy}-{out}");
            let args =
                ["scan", "--no-advice", CELL, "--strategy", strategy, "--iterations", iterations, "--paper-iterations"];
            fmi_hazard(dir.path()).args(args).args(["--out", &out]).assert().code(1);
            std::fs::read(dir.path().join(out).join("scan.json")).unwrap()
        };
        assert!(scan("a") == scan("b"), "{strategy}");
        let report = scan_json(&dir.path().join(format!("{strategy}-a")));
        let hazards = report["hazards"].as_array().unwrap();
        assert!(hazards.iter().all(|h| h["confirmed"] == true), "{strategy}: {hazards:?}");
        assert_eq!(report["settings"]["strategy"], strategy);
    }
}

#[test]
fn ways_of_bringing_states_back_do_not_change_what_is_imagined() {
    let dir = examples();
    let scan = |state: &str| {
        let args = [
            "scan",
            "--no-advice",
            "sensor-mat/cell.toml",
            "--strategy",
            "hybrid",
            "--iterations",
            "8",
            "--state",
            state,
        ];
        let _ = fmi_hazard(dir.path()).args(args).args(["--out", state]).output();
        scan_json(&dir.path().join(state))
    };
    let (saved, replayed) = (scan("fmu"), scan("replay"));
    assert_eq!(saved["hazards"], replayed["hazards"]);
    assert_eq!(saved["coverage"], replayed["coverage"]);
}

#[test]
fn the_number_of_workers_does_not_matter() {
    if !sample::is_turn(1, 3) {
        return;
    }
    let dir = examples();
    let bench = |workers: &str| {
        let args = ["bench", "strategies", "--cells", "sensor-mat", "--seeds", "3", "--coverage-seeds", "1"];
        let more = ["--iterations", "6", "--format", "json", "--workers", workers];
        fmi_hazard(dir.path()).args(args).args(more).assert().code(0).get_output().stdout.clone()
    };
    let one = bench("1");
    assert!(one == bench("3"));
    let comparison: serde_json::Value = serde_json::from_slice(&one).unwrap();
    assert_eq!(comparison[0]["rows"].as_array().unwrap().len(), 4);
}

#[test]
fn what_is_imagined_with_certainty_is_what_happens() {
    let dir = examples();
    let (mut safe, mut hits) = (0, 0);
    for cell in ["safety-fence", "sensor-mat"] {
        let prepared = prepare(&dir.path().join(cell).join("cell.toml"), None).unwrap();
        let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
        let mut rng = Rng::new(4);
        for _ in 0..60 {
            let actions: Vec<usize> = (0..simulation.horizon()).map(|_| rng.below(36)).collect();
            let imagined = simulation.imagine(&actions);
            // Actions taken, and whether the last of them met an unsafe state.
            let mut run = |actions: &[usize]| {
                simulation.reset().unwrap();
                let before = actions.iter().take_while(|&&a| simulation.step(a).unwrap().end.is_none()).count();
                (before + 1, !simulation.take_findings().is_empty())
            };
            for vision in imagined.visions.iter().filter(|_| imagined.exact) {
                assert_eq!(run(&vision.actions), (vision.actions.len(), true), "{cell} {vision:?}");
                hits += 1;
            }
            let ran = run(&actions);
            if imagined.exact && imagined.visions.is_empty() {
                assert_eq!(ran, (actions.len(), false), "{cell} {actions:?}");
                safe += 1;
            }
        }
    }
    assert!(safe > 10 && hits > 5, "{safe} {hits}");
}

/// A comparison of two strategies on one cell.
fn bench(format: &str, more: &[&str]) -> String {
    let dir = examples();
    let args = ["bench", "strategies", "--cells", "heavy-workpiece", "--strategies", "hybrid,random"];
    let rest = ["--seeds", "2", "--coverage-seeds", "2", "--iterations", "40", "--format", format];
    let output = fmi_hazard(dir.path()).args(args).args(rest).args(more).assert().code(0).get_output().clone();
    String::from_utf8(output.stdout).unwrap()
}

#[test]
#[ignore = "10 s: every sequence of eight actions; `different_hazards_are_counted_and_told_in_every_format` has the same without the complete list, and a unit test of `report::growth` calculates with one"]
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
    if !sample::is_turn(2, 3) {
        return;
    }
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
fn what_imagining_may_cost_ends_it_at_the_same_place_whatever_was_imagined_before() {
    let dir = examples();
    let prepared = prepare(&dir.path().join(CELL), None).unwrap();
    let told = |budget: u64, before: bool| {
        let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
        simulation.reset().unwrap();
        while simulation.step(0).unwrap().end.is_none() {}
        let mut sequence = {
            let mut rng = Rng::new(5);
            let horizon = simulation.horizon();
            move || (0..horizon).map(|_| rng.below(36)).collect::<Vec<usize>>()
        };
        let sequences: Vec<_> = (0..30).map(|_| sequence()).collect();
        if before {
            sequences.iter().for_each(|actions| drop(simulation.imagine(actions)));
        }
        simulation.begin_imagining(budget);
        let told: Vec<_> = sequences.iter().map(|actions| simulation.imagine(actions)).collect();
        (told, simulation.is_over_budget())
    };
    let (all, ended) = told(u64::MAX, false);
    assert!(!ended && all.iter().any(|imagined| !imagined.visions.is_empty()));
    let mut cut = 0;
    for budget in [1, 40, 300, 1_000, 3_000, 8_000] {
        let fresh = told(budget, false);
        assert!(fresh == told(budget, true), "{budget}");
        let same = fresh.0.iter().zip(&all).take_while(|(a, b)| a == b).count();
        // What is told after that is neither exact nor more than the whole.
        assert!(fresh.0[same..].iter().all(|imagined| !imagined.exact), "{budget}");
        assert_eq!(same < all.len(), fresh.1, "{budget}");
        cut += usize::from(fresh.1);
    }
    assert!(cut >= 3, "{cut}");
}
