//! The strategies on the example cells: each finds the hazard of the safety fence, repeats itself, and is compared the
//! same by any number of workers.

use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;
use fmi_hazard::scan::{StateChoice, prepare::prepare};
use fmi_hazard::search::{Environment as _, Rng, SurrogateModel as _};

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
