//! The exhaustive search against plain enumeration, with and without its shortcuts, and against random search.

use std::sync::Arc;

use std::collections::BTreeMap;
use std::convert::Infallible;
use std::path::Path;

use crate::common::exhausted::{BUDGET, Few, Unsafe, exhausted, expander, key};
use crate::common::guarded::every_sequence;
use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;
use fmi_hazard::hazard::Finding;
use fmi_hazard::host::{Advanced, Hosted, NodeId, Recall};
use fmi_hazard::human::{Action, Place, Posture, Presses, Repertoire, Walk};
use fmi_hazard::record::hazard::Hazard;
use fmi_hazard::scan::{Prepared, StateChoice, prepare::prepare};
use fmi_hazard::search::exhaustive::Budget;
use fmi_hazard::search::statistics::wilson;
use fmi_hazard::search::{End, Environment as _, Rng};
use fmi_hazard::sequences::Merge;
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::sim::sensors::DelayLine;
use fmi_hazard::sim::world::{Frames, Hit, IfSignalled, Instant, PersonState, SignalledRuns, Window};
use fmi_hazard::sim::{Coverage, World};

/// A cell of the examples, started elsewhere, with other search settings.
fn cell(dir: &Path, path: &str, start: &str, search: &str) -> Prepared {
    let text = std::fs::read_to_string(dir.join(path)).unwrap();
    let (before, after) = text.split_once("start = ").unwrap();
    let after = after.split_once('\n').map_or("", |(_, after)| after);
    let changed = format!("{before}start = {start}\n{after}\n[search]\n{search}\n");
    let file = dir.join(path).with_file_name("changed.toml");
    std::fs::write(&file, changed).unwrap();
    prepare(&file, None).unwrap()
}

/// The cells looked at here have no light curtain.
pub struct NoCurtain;

impl SignalledRuns for NoCurtain {
    type Error = Infallible;

    fn told_of(&mut self, _: &[Window]) -> Result<IfSignalled<Frames>, Infallible> {
        Ok(IfSignalled::BeforeTime)
    }
}

/// Every sequence by itself, one action after the other: no state is compared with another, nothing is shared but the
/// beginnings of sequences. Only whether a person so placed can touch robots so placed is asked once each.
struct Enumeration<'a> {
    world: World,
    recall: Recall<Hosted>,
    actions: &'a [Action],
    horizon: u32,
    found: Unsafe,
    harmless: u128,
    answers: BTreeMap<(PersonState, Vec<u64>), Option<Hit>>,
}

impl<'a> Enumeration<'a> {
    fn of(prepared: &Prepared, actions: &'a [Action], horizon: u32) -> Self {
        let world = World::new(prepared.cell.clone(), prepared.binding.clone());
        let recall = Recall::new(prepared.plant(StateChoice::Auto), prepared.policy(StateChoice::Auto)).unwrap();
        let (start, delays) = (world.first.start(), world.delays_at_start());
        let mut all =
            Self { world, recall, actions, horizon, found: Unsafe::new(), harmless: 0, answers: BTreeMap::new() };
        all.below(0, NodeId::ROOT, start, (&delays, Presses::NONE));
        all
    }

    fn below(&mut self, depth: u32, node: NodeId, place: Place, (delays, switched): (&[DelayLine], Presses)) {
        if depth == self.horizon {
            self.harmless += 1;
            return;
        }
        for &action in self.actions {
            let action = self.world.first.taken(&place, action);
            let walked = self.world.first.walk(place, action);
            let (sights, worked) =
                (self.world.first.sights(&walked, action.posture()), self.world.first.worked(&walked, action));
            let sensed = self.world.sense(delays, switched, &sights, &worked);
            let steps = self.world.cell.steps_per_action;
            let Advanced::To(to) = self.recall.advance(node, steps, &sensed.inputs).unwrap() else { panic!("a fault") };
            let rows = self.recall.outputs(to).chunks(self.world.binding.outputs.len());
            let frame = |r| Arc::new(RobotFrame::new(&self.world.cell, &self.world.binding, r));
            let frames: Frames = rows.map(frame).collect();
            let mut coverage = Coverage::new(self.world.cell.sensors.len());
            let met = (0..steps).find_map(|i| {
                let stance = self.world.first.stance(&walked, (depth as usize, i), action.posture(), &sensed);
                let robots = frames[i].outputs().iter().map(|v| v.to_bits()).collect();
                let mut instant = Instant { frames: &frames, i, earlier: NoCurtain };
                let ask = || self.world.first.contact(&stance, &mut instant, &mut coverage).unwrap();
                let hit = self.answers.entry((stance.clone(), robots)).or_insert_with(ask).clone()?;
                let taken = usize::try_from(depth).unwrap() + 1;
                self.world.first.finding(
                    &hit,
                    &stance,
                    self.world.readings(&sensed.readings[i], &frames[i]),
                    (taken, i),
                )
            });
            match met {
                Some(finding) => {
                    let finding = Finding { actions: vec![action], ..finding };
                    let rest = u128::try_from(self.actions.len()).unwrap().pow(self.horizon - depth - 1);
                    *self.found.entry(key(&finding)).or_default() += rest;
                }
                None => self.below(depth + 1, to, walked.end(), (&sensed.delays, sensed.switched)),
            }
        }
    }
}

/// Cells with a start from which a few actions suffice: one whose FMU sees a mat, one whose FMU sees the feet, one whose
/// robot comes out to the person.
const NEAR: [(&str, &str, &str); 3] = [
    ("sensor-mat", "{ xy_m = [-1.25, -0.35], heading_deg = 90 }", "[parameters]\n\"ctrl.phase0\" = 1.1"),
    ("two-scanners", "{ xy_m = [-0.35, -0.75], heading_deg = 45 }", ""),
    ("heavy-workpiece", "{ xy_m = [0.75, -0.85], heading_deg = 180 }", ""),
];

#[test]
fn three_of_36_actions_as_in_plain_enumeration() {
    let dir = examples();
    for (name, start, parameters) in sample::some(NEAR, NEAR.len()) {
        let search = format!("actions = 3\nreach_tolerance_m = 0.05\n{parameters}");
        let prepared = cell(dir.path(), &format!("{name}/cell.toml"), start, &search);
        let (account, found) = exhausted(&mut expander(&prepared, Merge::Auto), BUDGET);
        let all: Vec<Action> = Repertoire::usual(0).all().collect();
        let plain = Enumeration::of(&prepared, &all, 3);
        assert!(plain.found.len() > 10, "{name}: little to compare");
        assert_eq!(found, plain.found, "{name}");
        assert_eq!(u128::try_from(account.total.clone()).unwrap(), 36_u128.pow(3));
        assert_eq!(u128::try_from(account.hazardous.clone()).unwrap(), plain.found.values().sum::<u128>(), "{name}");
        let harmless = u128::try_from(account.harmless.clone() + &account.excluded).unwrap();
        assert_eq!(harmless, plain.harmless, "{name}");
    }
}

#[test]
fn five_of_six_walks_as_in_plain_enumeration() {
    if !sample::is_turn(0, 4) {
        return;
    }
    let dir = examples();
    let walks: Vec<Action> = Repertoire::usual(0).all().filter(|a| a.posture() == Posture::Upright).collect();
    for (name, start, parameters) in &NEAR[1..] {
        let search = format!("actions = 5\nreach_tolerance_m = 0.05\n{parameters}");
        let prepared = cell(dir.path(), &format!("{name}/cell.toml"), start, &search);
        let mut upright = Few::of(&prepared, &walks);
        let (account, found) = exhausted(&mut upright, BUDGET);
        let plain = Enumeration::of(&prepared, &walks, 5);
        assert!(!plain.found.is_empty(), "{name}: nothing to compare");
        assert_eq!(found, plain.found, "{name}");
        let harmless = u128::try_from(account.harmless.clone() + &account.excluded).unwrap();
        assert_eq!(harmless, plain.harmless, "{name}");
        if *name == "two-scanners" {
            assert!(upright.0.recall().merges().tried_out > 0, "states told by their bytes are merged");
        }
    }
}

/// A button that the person reaches, one that anyone presses at any time, and a switch that stays as it was put.
#[test]
fn presses_as_in_plain_enumeration() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    let moves = [(Walk::Stop, Posture::Upright), (Walk::Forward, Posture::Upright), (Walk::Right45, Posture::Forward)];
    let moves = moves.map(|(walk, posture)| Action::new(walk, posture));
    let few: Vec<Action> =
        Presses::all(1).flat_map(|presses| moves.iter().map(move |action| action.pressing(presses))).collect();
    for (name, kind) in [("reset-inside", "momentary\"\nfor_ms = 60"), ("reset-outside", "toggled\"")] {
        let file = dir.path().join(name).join("cell.toml");
        let text = std::fs::read_to_string(&file).unwrap();
        let control = "variable = \"plc.reset\"\n";
        assert!(text.contains(control));
        std::fs::write(&file, text.replace(control, &format!("{control}kind = \"{kind}\n"))).unwrap();
        // In one of them arms take their time.
        let speed = if name == "reset-outside" { "\narm_speed_m_s = 1" } else { "" };
        let start = &format!("{{ xy_m = [-0.6, -1.15], heading_deg = 90 }}{speed}");
        let prepared = cell(dir.path(), &format!("{name}/cell.toml"), start, "actions = 6\nreach_tolerance_m = 0.05");
        let mut expansion = Few::of(&prepared, &few);
        let (account, found) = exhausted(&mut expansion, BUDGET);
        let plain = Enumeration::of(&prepared, &few, 6);
        assert!(
            plain.found.len() > 5 && plain.found.keys().any(|key| key.contains("Force")),
            "{name}: little to compare"
        );
        assert_eq!(found, plain.found, "{name}");
        let harmless = u128::try_from(account.harmless.clone() + &account.excluded).unwrap();
        assert_eq!(harmless, plain.harmless, "{name}");
        assert!(account.states() > 100, "{name}: {} states", account.states());
    }
}

/// A door that opens and closes in front of the person and behind, and a reset button beside it.
#[test]
fn doors_as_in_plain_enumeration() {
    if !sample::is_turn(9, 12) {
        return;
    }
    let dir = examples();
    let file = dir.path().join("door-edge/cell.toml");
    let text = std::fs::read_to_string(&file).unwrap().replace("[0.9, -2.9, 1.1]", "[0.0, -2.0, 1.1]");
    let fast = "[parameters]\n\"ctrl.t_ramp\" = 0.05\n\"plc.t_react\" = 0.0\n";
    let (before, _) = text.split_once("[search]").unwrap();
    std::fs::write(&file, format!("{before}{fast}")).unwrap();
    let start = "{ xy_m = [0.2, -1.95], heading_deg = 90 }";
    let prepared = cell(dir.path(), "door-edge/cell.toml", start, "actions = 6\nreach_tolerance_m = 0.05");
    let moves = [(Walk::Stop, Posture::Upright), (Walk::Forward, Posture::Forward)];
    let moves = moves.map(|(walk, posture)| Action::new(walk, posture));
    let few: Vec<Action> =
        Presses::all(2).flat_map(|presses| moves.iter().map(move |action| action.pressing(presses))).collect();
    let (account, found) = exhausted(&mut Few::of(&prepared, &few), BUDGET);
    let plain = Enumeration::of(&prepared, &few, 6);
    assert!(plain.found.len() > 1, "little to compare: {:?}", plain.found);
    assert_eq!(found, plain.found);
    let harmless = u128::try_from(account.harmless.clone() + &account.excluded).unwrap();
    assert_eq!(harmless, plain.harmless);
    assert!(account.states() > 100, "{} states", account.states());
}

/// Kneeling, crouching, crawling, steps back and running, beside a beam that only some postures get below: where there is no room to
/// stand up, nobody does.
#[test]
fn what_else_people_do_as_in_plain_enumeration() {
    if !sample::is_turn(1, 3) {
        return;
    }
    let dir = examples();
    let beam = "[[obstacle]]\nname = \"beam\"\ncentre_m = [1.0, -0.85, 1.1]\nsize_m = [0.1, 2, 0.5]\n";
    let file = dir.path().join("heavy-workpiece/cell.toml");
    let text = std::fs::read_to_string(&file).unwrap();
    std::fs::write(&file, format!("{text}\n{beam}")).unwrap();
    let all = "also = [\"kneel\", \"crouch\", \"crawl\", \"step_back\", \"run\"]\nrun_m_s = 4.8";
    let start = format!("{{ xy_m = [1.4, -0.85], heading_deg = 180 }}\n{all}");
    let prepared = cell(dir.path(), "heavy-workpiece/cell.toml", &start, "actions = 4\nreach_tolerance_m = 0.05");
    let moves = [
        (Walk::Forward, Posture::Upright),
        (Walk::Stop, Posture::Forward),
        (Walk::Forward, Posture::Crawling),
        (Walk::Run, Posture::Crouching),
        (Walk::Back, Posture::Kneeling),
        (Walk::Run, Posture::Left),
    ];
    let moves = moves.map(|(walk, posture)| Action::new(walk, posture));
    let (account, found) = exhausted(&mut Few::of(&prepared, &moves), BUDGET);
    let plain = Enumeration::of(&prepared, &moves, 4);
    let low = |key: &&String| ["Crawling", "Crouching"].iter().any(|low| key.contains(low));
    assert!(plain.found.len() > 10 && plain.found.keys().any(|key| low(&key)), "little to compare: {:?}", plain.found);
    assert_eq!(found, plain.found);
    let harmless = u128::try_from(account.harmless.clone() + &account.excluded).unwrap();
    assert_eq!(harmless, plain.harmless);
    // A whole scan tells sequences as they are taken: each is confirmed by a run of its own.
    let crawls = "{ xy_m = [1.4, -0.85], heading_deg = 180 }\nalso = [\"crawl\"]";
    let crawling = cell(dir.path(), "heavy-workpiece/cell.toml", crawls, "actions = 5\nreach_tolerance_m = 0.05");
    let report = every_sequence(&crawling, false);
    assert!(report.hazards.len() > 3 && report.hazards.iter().all(|hazard| hazard.confirmed == Some(true)));
    let low = |hazard: &Hazard| hazard.actions.iter().filter(|a| a.posture() == Posture::Crawling).count();
    assert!(report.hazards.iter().any(|hazard| low(hazard) > 1));
    // Below the beam an upright action is taken low, and the walk goes on.
    let world = World::new(prepared.cell.clone(), prepared.binding.clone());
    let below = world.first.walk(world.first.start(), Action::new(Walk::Run, Posture::Crouching)).places[3];
    let upright = Action::new(Walk::Forward, Posture::ForwardLeft);
    assert_eq!(world.first.taken(&below, upright), Action::new(Walk::Forward, Posture::Crouching));
    assert_eq!(world.first.taken(&world.first.start(), upright), upright);
    assert!(
        world.first.walk(world.first.start(), Action::new(Walk::Forward, Posture::Upright)).blocked.contains(&true)
    );
}

#[test]
fn dropping_what_is_too_far_away_and_merging_change_nothing() {
    let dir = examples();
    let cells = [
        ("heavy-workpiece", "{ xy_m = [1.9, -1.3], heading_deg = 180 }", 6),
        ("sensor-mat", "{ xy_m = [-0.9, -1.5], heading_deg = 90 }", 5),
        ("two-scanners", "{ xy_m = [-0.6, -1.2], heading_deg = 45 }", 4),
    ];
    for (name, start, actions) in sample::some(cells, cells.len()) {
        let search = format!("actions = {actions}\nreach_tolerance_m = 0.05");
        let prepared = cell(dir.path(), &format!("{name}/cell.toml"), start, &search);
        let (dropping, found) = exhausted(&mut expander(&prepared, Merge::Auto), BUDGET);
        let keep = Budget { drop: false, ..BUDGET };
        let (keeping, all) = exhausted(&mut expander(&prepared, Merge::Auto), keep);
        let (history, by_history) = exhausted(&mut expander(&prepared, Merge::History), BUDGET);
        assert_eq!(found, all, "{name}: dropped a state that mattered");
        assert_eq!(found, by_history, "{name}: merged states that differ");
        assert_eq!(dropping.covered(), dropping.total, "{name}");
        assert_eq!((&keeping.hazardous, keeping.covered()), (&dropping.hazardous, keeping.total.clone()), "{name}");
        assert_eq!(history.hazardous, dropping.hazardous, "{name}");
        if name == "two-scanners" {
            assert!(dropping.states() < history.states(), "{} states by bytes", dropping.states());
        }
        if name == "heavy-workpiece" {
            assert!(dropping.levels.iter().any(|l| l.dropped > 0), "nothing was dropped: {:?}", dropping.levels);
        }
    }
}

/// The share of hazardous sequences is exact, so that of random sequences must come out near it.
/// Of the 36^8 sequences of each flawed cell the hazardous ones, as `scan --strategy exhaustive` counts them.
const HAZARDOUS: [(&str, u64); 6] = [
    ("safety-fence", 94_404_963_456),
    ("sensor-mat", 12_374_244_288),
    ("head-collision", 28_131_515_136),
    ("light-curtain", 718_070_671_488),
    ("two-scanners", 13_582_630_800),
    ("heavy-workpiece", 52_362_851_112),
];

/// Those that take a few seconds are counted again here.
const QUICK: [&str; 2] = ["head-collision", "heavy-workpiece"];

#[test]
fn six_actions_are_hazardous_as_often_as_counted() {
    let dir = examples();
    let short = "extends = \"cell.toml\"\nname = \"short\"\n[search]\nactions = 6\n";
    let prepared = prepare(&write(dir.path(), "heavy-workpiece/short.toml", short), None).unwrap();
    let (account, _) = exhausted(&mut expander(&prepared, Merge::Auto), BUDGET);
    assert_eq!(account.hazardous, 16_637_400_u64.into());
}

#[test]
#[ignore = "half a minute: eight actions; `six_actions_are_hazardous_as_often_as_counted` has six"]
fn sequences_are_hazardous_as_often_as_counted() {
    let dir = examples();
    for (name, hazardous) in HAZARDOUS.iter().filter(|(name, _)| QUICK.contains(name)) {
        let prepared = prepare(&dir.path().join(name).join("cell.toml"), None).unwrap();
        let (account, _) = exhausted(&mut expander(&prepared, Merge::Auto), BUDGET);
        assert_eq!(account.hazardous, (*hazardous).into(), "{name}");
    }
}

/// Random sequences tell of those that take minutes as well.
#[test]
fn random_sequences_are_hazardous_as_often_as_counted() {
    if !sample::is_turn(0, 3) {
        return;
    }
    let dir = examples();
    for (name, hazardous) in sample::some(HAZARDOUS, HAZARDOUS.len()) {
        as_often_as_counted(dir.path(), name, hazardous);
    }
}

fn as_often_as_counted(dir: &Path, name: &str, hazardous: u64) {
    let prepared = prepare(&dir.join(name).join("cell.toml"), None).unwrap();
    let episodes = if QUICK.contains(&name) { 6000 } else { 3000 };
    let exact = hazardous as f64 / 36_f64.powi(8);
    let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
    let (mut rng, mut hits) = (Rng::new(11), 0);
    for _ in 0..episodes {
        simulation.reset().unwrap();
        let end = loop {
            if let Some(end) = simulation.step(rng.below(36)).unwrap().end {
                break end;
            }
        };
        hits += usize::from(end == End::Unsafe);
    }
    let interval = wilson(hits, episodes);
    assert!(interval.low <= exact && exact <= interval.high, "{name}: {exact} outside {interval:?}, {hits} hits");
}

/// `scan.json` of a scan of every sequence, and what it printed, in one line.
fn run(dir: &Path, file: &str, workers: &str, code: i32) -> (serde_json::Value, String) {
    let arguments = ["scan", "--no-advice", file, "--strategy", "exhaustive", "--workers", workers, "--out", "out"];
    let output = fmi_hazard(dir).args(arguments).assert().code(code).get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    (scan_json(&dir.join("out")), text.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// The certificate of a cell without hazards, of so many actions; `sequences` as they are printed.
fn certified(file: &str, actions: u32, sequences: &str) {
    let dir = examples();
    let short = format!("extends = \"fixed.toml\"\nname = \"short\"\n[search]\nactions = {actions}\n");
    write(dir.path(), "heavy-workpiece/short.toml", &short);
    let (fixed, text) = run(dir.path(), file, "2", 0);
    let certificate = &fixed["certificate"];
    assert_eq!(fixed["verdict"], "none_found");
    assert_eq!((&certificate["complete"], &certificate["hazardous"]), (&true.into(), &"0".into()), "{certificate}");
    assert_eq!(certificate["sequences"], sequences.replace(',', ""));
    assert_eq!(certificate["covered"], certificate["sequences"]);
    assert!(text.contains(&format!("{sequences} of {sequences} sequences complete")), "{text}");
    let within = format!("complete within: 36 actions, {actions} steps of 200 ms, contact checked every 20 ms");
    assert!(text.contains(&within), "{text}");
}

#[test]
fn the_certificate_of_a_repaired_cell() {
    if !sample::is_turn(2, 3) {
        return;
    }
    certified("heavy-workpiece/short.toml", 6, "2,176,782,336");
}

#[test]
#[ignore = "half a minute: eight actions; `the_certificate_of_a_repaired_cell` has six"]
fn the_certificate_of_a_repaired_cell_as_it_is() {
    certified("heavy-workpiece/fixed.toml", 8, "2,821,109,907,456");
}

#[test]
fn the_same_bytes_with_any_number_of_workers() {
    if !sample::is_turn(5, 6) {
        return;
    }
    let dir = examples();
    let run = |file: &str, workers: &str, code: i32| run(dir.path(), file, workers, code);
    cell(dir.path(), "two-scanners/cell.toml", NEAR[1].1, "actions = 3");
    let (one, _) = run("two-scanners/changed.toml", "1", 1);
    let (three, text) = run("two-scanners/changed.toml", "3", 1);
    assert!(serde_json::to_string(&one).unwrap() == serde_json::to_string(&three).unwrap(), "workers matter");
    let sequences = |h: &serde_json::Value| h["sequences"].as_str().unwrap().parse::<u128>().unwrap();
    let hazards = one["hazards"].as_array().unwrap();
    let sum: u128 = hazards.iter().map(sequences).sum();
    assert_eq!(sum.to_string(), one["certificate"]["hazardous"].as_str().unwrap());
    assert!(hazards.iter().all(|h| h["confirmed"] == true && h["shortest"]["confirmed"] == true));
    assert!(text.contains("there are no other hazards in this model"), "{text}");
}

#[test]
fn a_spent_budget_is_said_and_what_was_found_stays() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let dir = examples();
    cell(dir.path(), "two-scanners/cell.toml", NEAR[1].1, "actions = 5");
    let arguments = [
        "scan",
        "--no-advice",
        "two-scanners/changed.toml",
        "--strategy",
        "exhaustive",
        "--max-states",
        "600",
        "--out",
        "out",
    ];
    let output = fmi_hazard(dir.path()).args(arguments).assert().code(1).get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    let result = scan_json(&dir.path().join("out"));
    assert_eq!(result["certificate"]["complete"], false);
    assert!(result["certificate"]["random_search"].is_null());
    assert!(text.contains("NOT complete within") && text.contains("Raise --max-states"), "{text}");
    assert!(text.contains("Not finding more is not proof of safety"), "{text}");
    assert!(!result["hazards"].as_array().unwrap().is_empty());
}

#[test]
fn no_strategy_meets_a_hazard_that_the_exhaustive_search_does_not() {
    if !sample::is_turn(1, 6) {
        return;
    }
    let dir = examples();
    cell(dir.path(), "two-scanners/cell.toml", NEAR[1].1, "actions = 4\nreach_tolerance_m = 0.05");
    let run = |strategy: &str, more: &[&str]| {
        let arguments = ["scan", "--no-advice", "two-scanners/changed.toml", "--strategy", strategy, "--out", "out"];
        fmi_hazard(dir.path()).args(arguments).args(more).assert().code(1);
        scan_json(&dir.path().join("out"))
    };
    let ids = |result: &serde_json::Value| -> Vec<String> {
        let mut ids: Vec<String> =
            result["hazards"].as_array().unwrap().iter().map(|h| h["id"].as_str().unwrap().to_owned()).collect();
        ids.sort();
        ids
    };
    let length = |h: &serde_json::Value| h["shortest"]["actions"].as_array().unwrap().len();
    let all = run("exhaustive", &[]);
    let known = ids(&all);
    for strategy in ["hybrid", "mcts-dpw", "random"] {
        let found = run(strategy, &["--iterations", "40"]);
        assert!(ids(&found).iter().all(|id| known.contains(id)), "{strategy}: {:?} beside {known:?}", ids(&found));
        for hazard in found["hazards"].as_array().unwrap() {
            let exact = all["hazards"].as_array().unwrap().iter().find(|h| h["id"] == hazard["id"]).unwrap();
            assert!(length(hazard) >= length(exact), "{strategy}: shorter than the shortest: {hazard}");
            assert!(length(hazard) <= hazard["actions"].as_array().unwrap().len(), "{hazard}");
        }
    }
    let auto = run("auto", &["--iterations", "20"]);
    assert_eq!(ids(&auto), known);
    // Beside a complete search, sequences are tried only as far as they cost little.
    let tried = auto["spent"]["iterations"].as_u64().unwrap();
    assert!(auto["certificate"]["complete"] == true && (5..=20).contains(&tried), "{tried}");
    assert!(auto["hazards"].as_array().unwrap().iter().all(|h| h["sequences"].is_string()));
    // A budget that ends the second part keeps what the first one met.
    let cut = run("auto", &["--iterations", "20", "--max-states", "1"]);
    assert_eq!((&cut["certificate"]["complete"], &cut["spent"]["iterations"]), (&false.into(), &20.into()));
    assert!(!cut["hazards"].as_array().unwrap().is_empty());
}
