//! What a scan says about hazards that are left, from its random sequences: right where the truth is known, and only
//! said where it holds.

use std::collections::BTreeMap;

use crate::common::guarded::every_sequence;
use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;
use fmi_hazard::hazard::Groups;
use fmi_hazard::scan::residual::Watch;
use fmi_hazard::scan::{StateChoice, StrategyName, prepare::prepare};
use fmi_hazard::search::Rng;
use fmi_hazard::search::residual::Figures;

#[test]
fn the_figures_cover_what_the_exhaustive_search_counts() {
    if !sample::is_turn(2, 6) {
        return;
    }
    let dir = examples();
    // A nearer start and fewer actions, so that the exhaustive search takes a second.
    let text = std::fs::read_to_string(dir.path().join("heavy-workpiece/cell.toml")).unwrap();
    let near = text.replace("xy_m = [1.6, -1.2]", "xy_m = [1.3, -1.1]") + "\n[search]\nactions = 5\n";
    let prepared = prepare(&write(&dir.path().join("heavy-workpiece"), "near.toml", &near), None).unwrap();
    let truth = every_sequence(&prepared, false);
    assert_eq!(truth.residual, None, "where every sequence was looked at, nothing is left to estimate");
    let certificate = truth.certificate.unwrap();
    let all: f64 = certificate.sequences.parse().unwrap();
    let sequences = |text: &Option<String>| text.as_ref().unwrap().parse::<f64>().unwrap();
    let shares: BTreeMap<String, f64> =
        truth.hazards.iter().map(|h| (h.id.clone(), sequences(&h.sequences) / all)).collect();
    let links: Vec<String> = prepared.cell.links.iter().map(|l| l.name.clone()).collect();

    let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
    let mut run = |strategy: StrategyName, seed: u64| -> (Figures, f64) {
        simulation.begin_run();
        let (mut strategy, mut rng) = (strategy.build(), Rng::new(seed));
        let (mut watch, mut groups) = (Watch::new(320), Groups::default());
        for i in 1..=320 {
            let iteration = strategy.iterate(&mut simulation, &mut rng).unwrap();
            let findings = simulation.take_findings();
            watch.after(&iteration, &findings, &groups, &links);
            findings.into_iter().for_each(|finding| drop(groups.add(finding, i, &links)));
        }
        let listed: f64 = groups.ranked().iter().map(|group| shares[&group.id]).sum();
        (watch.figures().unwrap(), certificate.hazardous_share - listed)
    };
    assert!(certificate.hazardous_share > 0.01 && shares.len() > 10, "{shares:?}");
    // Of 40 figures that are right with 95 % each, 36 or more are with 95 %.
    for (strategy, random) in sample::some([(StrategyName::Random, 320), (StrategyName::Hybrid, 64)], 2) {
        let (mut within, mut below, mut unlisted) = (0, 0, 0);
        for seed in 1..=40 {
            let (f, left) = run(strategy, seed);
            assert_eq!((f.sequences, f.checked), (random, random * 3 / 4));
            within +=
                u32::from(f.share.low <= certificate.hazardous_share && certificate.hazardous_share <= f.share.high);
            below += u32::from(certificate.hazardous_share <= f.share_below);
            unlisted += u32::from(left <= f.unlisted_below);
        }
        assert!(within >= 36 && below >= 36 && unlisted >= 36, "{strategy:?}: {within} {below} {unlisted} of 40");
    }
}

#[test]
fn only_random_sequences_of_a_search_that_ran_as_fixed_are_counted_each_by_its_own_end() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let dir = examples();
    let scan = |more: &[&str]| {
        let arguments =
            ["scan", "--no-advice", "heavy-workpiece/cell.toml", "--iterations", "100", "--out", "out", "--strategy"];
        let output = fmi_hazard(dir.path()).args(arguments).args(more).output().unwrap();
        (scan_json(&dir.path().join("out"))["residual"].clone(), String::from_utf8(output.stdout).unwrap())
    };
    let (random, text) = scan(&["random"]);
    assert_eq!((&random["random_sequences"], &random["unlisted"]["checked"]), (&100.into(), &75.into()), "{random}");
    assert!(random["hazardous"].as_u64().unwrap() > 0, "{random}");
    assert!(text.contains("of 100 uniformly random sequences hazardous") && text.contains("not how likely"), "{text}");
    let (paper, _) = scan(&["random", "--paper-iterations"]);
    for same in ["random_sequences", "hazardous", "hazardous_share_interval", "hazardous_share_below"] {
        assert_eq!(random[same], paper[same], "{same}: other postures were counted");
    }
    let estimate = "good_turing_estimate";
    assert_eq!(random["unlisted"][estimate], paper["unlisted"][estimate], "other postures were counted");
    assert_eq!(scan(&["hybrid"]).0["random_sequences"], 20);
    assert!(scan(&["mcts-dpw"]).0.is_null(), "what a tree search chooses is no random sample");
    assert!(scan(&["random", "--stop-at", "first"]).0.is_null(), "it stopped because of what it met");
}

#[test]
fn a_scan_by_default_says_whether_it_is_complete() {
    let dir = examples();
    let text = std::fs::read_to_string(dir.path().join("heavy-workpiece/cell.toml")).unwrap();
    let near = text.replace("xy_m = [1.6, -1.2]", "xy_m = [1.3, -1.1]") + "\n[search]\nactions = 4\niterations = 50\n";
    write(&dir.path().join("heavy-workpiece"), "near.toml", &near);
    let scan = |more: &[&str]| {
        let arguments = ["scan", "--from", "start", "--no-advice", "-v", "heavy-workpiece/near.toml", "--out", "out"];
        let output = fmi_hazard(dir.path()).args(arguments).args(more).assert().code(1).get_output().clone();
        let told = String::from_utf8(output.stderr).unwrap();
        let mut ids: Vec<&str> =
            told.lines().filter_map(|l| l.trim().strip_prefix("Found ")?.split_whitespace().next()).collect();
        let lines = ids.len();
        ids.sort_unstable();
        ids.dedup();
        assert!(lines > 0 && ids.len() == lines, "a hazard is told once, though two searches meet it: {told}");
        let text = String::from_utf8(output.stdout).unwrap();
        (scan_json(&dir.path().join("out")), text.split_whitespace().collect::<Vec<_>>().join(" "))
    };
    let (all, text) = scan(&[]);
    assert_eq!((&all["settings"]["strategy"], &all["certificate"]["complete"]), (&"auto".into(), &true.into()));
    assert!(text.contains("Complete: all 1,679,616 sequences are accounted for"), "{text}");
    assert!(all["residual"].is_null() && !text.contains("Residual"), "{text}");
    let (cut, text) = scan(&["--max-states", "1"]);
    assert_eq!(cut["residual"]["random_sequences"], 10);
    assert!(text.contains("of 10 uniformly random sequences"), "{text}");
    assert!(
        text.contains("Not complete: a quick search of 50 sequences, and all beginnings of 1 of 4 actions"),
        "{text}"
    );
    assert!(text.contains("not proof of safety; the residual figures bound what is left"), "{text}");
    let (first, text) = scan(&["--stop-at", "first"]);
    assert!(first["certificate"].is_null() && first["residual"].is_null());
    assert_eq!(first["settings"]["strategy"], "auto");
    assert!(text.contains("Not complete: a quick search of") && text.contains("sequences alone"), "{text}");
}
