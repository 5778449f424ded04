//! Two people in a cell: the example pair, and the search for both at once against an enumeration that knows each of them alone.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

use crate::common::exhausted::{BUDGET, Few, Unsafe, exhausted, key};
use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::exhaustive::NoCurtain;
use crate::sample;
use fmi_hazard::cell::binding::SensorBinding;
use fmi_hazard::hazard::Finding;
use fmi_hazard::host::{Advanced, Hosted, NodeId, Recall};
use fmi_hazard::human::{Action, Place, Posture, Presses, Repertoire, Walk, Who};
use fmi_hazard::scan::{Prepared, StateChoice, prepare::prepare};
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::sim::sensors::DelayLine;
use fmi_hazard::sim::world::{Frames, Hit, InputTrace, Instant, PersonState};
use fmi_hazard::sim::{Coverage, World};

/// What is remembered of one of them: where they are, what is on its way to the FMU of them alone, and what they switched.
#[derive(Clone)]
struct Alone {
    place: Place,
    delays: Vec<DelayLine>,
    switched: Presses,
}

/// Every sequence by itself. Each of the two is in a world of their own, as if the other were not there; only what the FMU is told is put
/// together: a sensor reports if it would report either, a control is on if either has it on.
struct Enumeration<'a> {
    worlds: [World; 2],
    /// What each input of the FMU is while nobody is there.
    rest: Vec<f64>,
    recall: Recall<Hosted>,
    actions: &'a [Action],
    horizon: usize,
    found: Unsafe,
    both_at_once: u32,
    harmless: u128,
    answers: BTreeMap<(usize, PersonState, Vec<u64>), Option<Hit>>,
}

impl<'a> Enumeration<'a> {
    fn of(prepared: &Prepared, actions: &'a [Action], horizon: usize) -> Self {
        let (cell, binding) = (&prepared.cell, &prepared.binding);
        let mut first = fmi_hazard::cell::Workcell::clone(cell);
        first.second = None;
        first.repertoire = Repertoire::usual(first.controls.len());
        let alone = [first, cell.of_second().unwrap()];
        let worlds = alone.map(|cell| World::new(Arc::new(cell), Arc::clone(binding)));
        let mut rest = vec![0.0; binding.sensor_inputs];
        for (sensor, bound) in cell.sensors.iter().zip(&binding.sensors) {
            let SensorBinding::Input(column) = bound else { panic!("all are inputs") };
            rest[*column] = sensor.signal.value(false);
        }
        rest.extend(binding.controls.iter().map(|values| values[0]));
        let recall = Recall::new(prepared.plant(StateChoice::Auto), prepared.policy(StateChoice::Auto)).unwrap();
        let start = |world: &World| Alone {
            place: world.first.start(),
            delays: world.delays_at_start(),
            switched: Presses::NONE,
        };
        let people = [start(&worlds[0]), start(&worlds[1])];
        let (found, answers) = (Unsafe::new(), BTreeMap::new());
        let mut all = Self { worlds, rest, recall, actions, horizon, found, both_at_once: 0, harmless: 0, answers };
        all.below(0, NodeId::ROOT, &people);
        all
    }

    /// What the FMU is told of both.
    fn told(&self, [a, b]: [&InputTrace; 2]) -> Vec<f64> {
        let width = a.inputs.len() / a.readings.len();
        let either = |(number, (a, b)): (usize, (&f64, &f64))| {
            let rest = self.rest.get(number % width);
            if rest == Some(a) { *b } else { *a }
        };
        a.inputs.iter().zip(&b.inputs).enumerate().map(either).collect()
    }

    fn below(&mut self, depth: usize, node: NodeId, people: &[Alone; 2]) {
        if depth == self.horizon {
            self.harmless += 1;
            return;
        }
        for &action in self.actions {
            let does = Who::ALL.map(|who| action.of(who));
            let walked = [0, 1].map(|n| self.worlds[n].first.walk(people[n].place, does[n]));
            let sensed = [0, 1].map(|n| {
                let (world, alone) = (&self.worlds[n], &people[n]);
                let sights = world.first.sights(&walked[n], does[n].posture());
                world.sense(&alone.delays, alone.switched, &sights, &world.first.worked(&walked[n], does[n]))
            });
            let inputs = self.told([&sensed[0], &sensed[1]]);
            let steps = self.worlds[0].cell.steps_per_action;
            let Advanced::To(to) = self.recall.advance(node, steps, &inputs).unwrap() else { panic!("a fault") };
            let world = &self.worlds[0];
            let rows = self.recall.outputs(to).chunks(world.binding.outputs.len());
            let frame = |row| Arc::new(RobotFrame::new(&world.cell, &world.binding, row));
            let frames: Frames = rows.map(frame).collect();
            let met: Option<Vec<Finding>> = (0..steps).find_map(|i| {
                let reported = |sensor: usize| sensed.iter().any(|sensed| sensed.readings[i][sensor]);
                let readings: Vec<bool> = (0..world.cell.sensors.len()).map(reported).collect();
                let hit = |n: usize| {
                    let own = &self.worlds[n].first;
                    let stance = own.stance(&walked[n], (depth, i), does[n].posture(), &sensed[n]);
                    let robots = frames[i].outputs().iter().map(|v| v.to_bits()).collect();
                    let mut coverage = Coverage::new(readings.len());
                    let mut instant = Instant { frames: &frames, i, earlier: NoCurtain };
                    let ask = || own.contact(&stance, &mut instant, &mut coverage).unwrap();
                    let hit = self.answers.entry((n, stance.clone(), robots)).or_insert_with(ask).clone()?;
                    let finding = own.finding(&hit, &stance, world.readings(&readings, &frames[i]), (depth + 1, i))?;
                    Some(Finding { actions: vec![action], who: Who::ALL[n], ..finding })
                };
                let hits: Vec<Finding> = [0, 1].into_iter().filter_map(hit).collect();
                (!hits.is_empty()).then_some(hits)
            });
            match met {
                Some(hits) => {
                    let left = u32::try_from(self.horizon - depth - 1).unwrap();
                    *self.found.entry(key(&hits[0])).or_default() += (self.actions.len() as u128).pow(left);
                    self.both_at_once += u32::from(hits.len() > 1);
                }
                None => {
                    let after = |n: usize| Alone {
                        place: walked[n].end(),
                        delays: sensed[n].delays.clone(),
                        switched: sensed[n].switched,
                    };
                    self.below(depth + 1, to, &[after(0), after(1)]);
                }
            }
        }
    }
}

/// The cell with other starts, and whatever else is changed.
fn changed(dir: &Path, name: &str, changes: &[(&str, &str)]) -> Prepared {
    let mut text = std::fs::read_to_string(dir.join("two-operators/cell.toml")).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}");
        text = text.replace(from, to);
    }
    let file = dir.join("two-operators").join(name);
    std::fs::write(&file, text).unwrap();
    prepare(&file, None).unwrap()
}

/// Two people who walk in, and a key between them that mutes the field while either holds it, as in an enumeration that knows each alone.
#[test]
fn two_people_as_in_plain_enumeration() {
    if !sample::is_turn(5, 6) {
        return;
    }
    let dir = examples();
    let mat = "[[sensor]]\nname = \"station A\"\nkind = \"mat\"\n\
               zone = { polygon_m = [[-1, -2.5], [-0.2, -2.5], [-0.2, -1.8], [-1, -1.8]] }\n\
               variable = \"plc:station_a\"\nactive = true\n";
    let key = "[[control]]\nname = \"key\"\nkind = \"held\"\nvariable = \"plc:station_a\"\nat_m = [0.0, -1.2, 1.1]\n";
    let moves = [(Walk::Stop, Posture::Upright), (Walk::Forward, Posture::ForwardRight)];
    let moves = moves.map(|(walk, posture)| Action::new(walk, posture));
    let both = moves.iter().flat_map(|first| moves.iter().map(move |second| first.beside(*second)));
    let few: Vec<Action> =
        Presses::all(1).flat_map(|set| both.clone().map(move |action| action.pressing(set))).collect();
    let mut hit = [0, 0];
    // The robot is on the left: once the first is there, once the second.
    let places = [("[-0.5, -1.81]", "[0.6, -1.85]"), ("[0.6, -1.85]", "[-0.5, -1.81]")];
    for (first, second) in sample::some(places, 2) {
        let changes = [
            (mat, ""),
            ("[-0.6, -1.95]", "FIRST"),
            ("[0.6, -1.95]", second),
            ("FIRST", first),
            ("[inputs]", &format!("{key}[inputs]")),
            ("actions = 4", "actions = 5\nreach_tolerance_m = 0.05"),
        ];
        let prepared = changed(dir.path(), "both.toml", &changes);
        let (account, found) = exhausted(&mut Few::of(&prepared, &few), BUDGET);
        let plain = Enumeration::of(&prepared, &few, 5);
        for (count, who) in hit.iter_mut().zip(["who: First", "who: Second"]) {
            *count += plain.found.keys().filter(|key| key.contains(who)).count();
        }
        // Nobody is hit without the key once both are off the mat.
        assert!(plain.found.keys().any(|key| key.contains("presses: Presses(1)")), "{:?}", plain.found);
        assert_eq!(found, plain.found);
        let harmless = u128::try_from(account.harmless.clone() + &account.excluded).unwrap();
        assert_eq!(harmless, plain.harmless);
        assert!(account.states() > 100, "{} states", account.states());
    }
    assert!(
        hit.iter().filter(|count| **count > 2).count() > usize::from(sample::is_whole()),
        "little to compare: {hit:?}"
    );
}

/// Quick strategies look at other postures besides: what they find of one person is there as well when the other one is looked at, so
/// every way of it is met again by a run of its own.
#[test]
fn what_quick_strategies_find_of_two_is_met_again() {
    if !sample::is_turn(0, 4) {
        return;
    }
    let dir = examples();
    let changes = [
        ("[[-1, -2.5], [1, -2.5], [1, 2], [-1, 2]]", "[[-1, -9], [1, -9], [1, -8], [-1, -8]]"),
        ("[-0.6, -1.95]", "[-0.5, -0.6]"),
        ("[0.6, -1.95]", "[-0.2, -0.6]"),
        ("[search]", "[criteria]\nmoving_contact = true\n[search]"),
    ];
    let _ = changed(dir.path(), "near.toml", &changes);
    let mut scan = fmi_hazard(dir.path());
    scan.args([
        "scan",
        "two-operators/near.toml",
        "--strategy",
        "random",
        "--iterations",
        "60",
        "--no-advice",
        "--out",
        "near",
    ]);
    let told = String::from_utf8_lossy(&scan.output().unwrap().stdout).into_owned();
    let report = scan_json(&dir.path().join("near"));
    let hazards = report["hazards"].as_array().unwrap();
    for who in ["operator A", "operator B"] {
        assert!(hazards.iter().filter(|hazard| hazard["person"] == who).count() > 3, "{who}: {told}");
    }
    assert!(hazards.iter().all(|hazard| hazard["confirmed"] == true), "{told}");
    assert!(report["causes"].to_string().contains(" is hit too."), "{told}");
}

/// The same with the robot nearer and a stop that is there at once, of two actions: now it is operator B who is hit.
#[test]
fn who_is_at_a_station_near_the_robot_hides_who_walks_in() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    let folder = dir.path().join("two-operators");
    let changes = [
        ("xyz_m = [0, 1.2, 0.505]", "xyz_m = [0, 0.4, 0.505]"),
        ("actions = 4", "actions = 2\nreach_tolerance_m = 0.05"),
        ("[search]", "[parameters]\n\"controller:t_ramp\" = 0.05\n\"plc:t_react\" = 0.0\n[search]"),
    ];
    let _ = changed(dir.path(), "near.toml", &changes);
    let fixed = std::fs::read_to_string(folder.join("fixed.toml")).unwrap();
    write(&folder, "fixed-near.toml", &fixed.replace("extends = \"cell.toml\"", "extends = \"near.toml\""));
    for (name, other) in [("a-alone", "operator B"), ("b-alone", "operator A")] {
        let alone = "extends = \"near.toml\"\nname = \"alone\"\n[search]\nactions = 4\n";
        write(&folder, &format!("{name}.toml"), &format!("{alone}[remove]\nhuman = [\"{other}\"]\n"));
    }
    for (cell, hazards, actions) in
        [("near", true, 1296), ("fixed-near", false, 1296), ("a-alone", false, 36), ("b-alone", false, 36)]
    {
        scanned_completely(dir.path(), cell, hazards, actions);
    }
    let report = scan_json(&dir.path().join("near"));
    let hazards = report["hazards"].as_array().unwrap();
    assert!(!hazards.is_empty() && hazards.iter().all(|hazard| hazard["person"] == "operator B"), "{hazards:?}");
    let sentence = report["causes"][0]["sentence"].as_str().unwrap();
    assert!(sentence.contains("reported somebody") && sentence.ends_with("the hand of operator B."), "{sentence}");
    let table = std::fs::read_to_string(dir.path().join("near/hazards.csv")).unwrap();
    assert!(table.lines().next().unwrap().ends_with(",who_is_hit") && table.contains(",operator B\n"), "{table}");
    let worst = hazards[0]["id"].as_str().unwrap();
    let told = fmi_hazard(dir.path()).args(["explain", "near", worst, "--no-changes"]).output().unwrap();
    let told = String::from_utf8_lossy(&told.stdout).split_whitespace().collect::<Vec<_>>().join(" ");
    let does = "operator B walks straight ahead, upright";
    assert!(told.contains(does) && told.contains("the hand of operator B"), "{told}");
    let again = fmi_hazard(dir.path()).args(["replay", "near", worst]).output().unwrap();
    assert_eq!(again.status.code(), Some(1), "{}", String::from_utf8_lossy(&again.stdout));
}

/// A scan of every sequence is complete, finds as much, and every hazard is confirmed.
fn scanned_completely(dir: &Path, cell: &str, hazards: bool, actions: u32) {
    let mut scan = fmi_hazard(dir);
    let file = dir.join("two-operators").join(format!("{cell}.toml"));
    scan.arg("scan").arg(file).args(["--strategy", "exhaustive", "--no-advice", "--out", cell]);
    let ran = scan.output().unwrap();
    let told = String::from_utf8_lossy(&ran.stdout);
    assert_eq!(ran.status.code(), Some(i32::from(hazards)), "{told}{}", String::from_utf8_lossy(&ran.stderr));
    let report = scan_json(&dir.join(cell));
    let certificate = &report["certificate"];
    assert!(certificate["complete"] == true && certificate["actions"] == actions, "{certificate}");
    assert!(report["hazards"].as_array().unwrap().iter().all(|hazard| hazard["confirmed"] == true), "{told}");
}

/// One field for two stations: while one operator is at theirs, the other walks in unheeded. Each alone is safe.
#[test]
#[ignore = "two minutes: the whole examples; `who_is_at_a_station_near_the_robot_hides_who_walks_in` has two actions"]
fn who_is_at_a_station_hides_who_walks_in_and_it_is_found_told_and_mended() {
    let dir = examples();
    let folder = dir.path().join("two-operators");
    let alone =
        "extends = \"cell.toml\"\nname = \"alone\"\nremove = { human = [\"operator B\"] }\n[search]\nactions = 8\n";
    write(&folder, "alone.toml", alone);
    for (cell, hazards, actions) in [("cell", true, 1296), ("fixed", false, 1296), ("alone", false, 36)] {
        scanned_completely(dir.path(), cell, hazards, actions);
    }
    let report = scan_json(&dir.path().join("cell"));
    let hazards = report["hazards"].as_array().unwrap();
    assert!(hazards.iter().all(|hazard| hazard["person"] == "operator A"), "{hazards:?}");
    assert_eq!(report["settings"]["second"]["names"], serde_json::json!(["operator A", "operator B"]));
    let sentence = report["causes"][0]["sentence"].as_str().unwrap();
    assert!(sentence.contains("reported somebody") && sentence.ends_with("the hand of operator A."), "{sentence}");
    // The table says whom it happens to, and every word about a way says what both do.
    let table = std::fs::read_to_string(dir.path().join("cell/hazards.csv")).unwrap();
    assert!(table.lines().next().unwrap().ends_with(",who_is_hit") && table.contains(",operator A\n"), "{table}");
    let worst = hazards[0]["id"].as_str().unwrap();
    let told = fmi_hazard(dir.path())
        .args(["explain", "cell", worst, "--from", "start", "--max-states", "10"])
        .output()
        .unwrap();
    let told = String::from_utf8_lossy(&told.stdout);
    let does = "operator A walks straight ahead, upright; operator B stands, upright";
    assert!(told.contains(does) && told.contains("the hand of operator A"), "{told}");
    let again = fmi_hazard(dir.path()).args(["replay", "cell", worst]).output().unwrap();
    assert_eq!(again.status.code(), Some(1), "{}", String::from_utf8_lossy(&again.stdout));
}

/// Who begins where, what they are called, and what does not go together: told with the way out.
#[test]
fn what_does_not_go_together_with_two_people_is_told() {
    let dir = examples();
    let text = std::fs::read_to_string(dir.path().join("two-operators/cell.toml")).unwrap();
    let second = "name = \"operator B\"\nstart = { xy_m = [0.6, -1.95], heading_deg = 90 }";
    let curtain = "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\nvariable = \"plc:station_b\"\nactive = true\n\
                   zone = { line_m = [[-1, -1], [1, -1]], heights_m = [0.0, 1.8] }\n";
    let third = format!("[[human]]\n{second}\n[search]");
    for (from, to, problem) in [
        ("[search]", third.as_str(), "more than two people"),
        ("operator B", "operator A", "both people are called `operator A`"),
        ("name = \"operator B\"", "name = \" \"", "a person has an empty name"),
        ("[0.6, -1.95]", "[1.0, -1.95]", "the second person's start (1.00, -1.95) m is inside an obstacle"),
        ("[inputs]", &format!("{curtain}[inputs]"), "with two people, planes are not looked at: `curtain`"),
        ("[search]", "[pose]\nx = \"plc:x\"\n[search]", "with two people, the FMU cannot be told where the person is"),
        (second, &format!("{second}\nbegins_s = [1.0]"), "unknown field `begins_s`"),
        (second, "name = \"operator B\"", "missing field `start`"),
    ] {
        assert!(text.contains(from), "{from}");
        let file = write(&dir.path().join("two-operators"), "wrong.toml", &text.replacen(from, to, 1));
        let error = prepare(&file, None).err().unwrap().to_string();
        assert!(error.contains(problem), "{problem}: {error}");
    }
    // Laid over another file, people are told apart by their names, and none is dropped unheard.
    let laid = |more: &str| {
        let text = format!("extends = \"cell.toml\"\nname = \"laid\"\n{more}");
        prepare(&write(&dir.path().join("two-operators"), "laid.toml", &text), None)
    };
    let error = laid("[human]\npercentile = 5").err().unwrap().to_string();
    assert!(error.contains("has `[[human]]`, a list, and this has `[human]`"), "{error}");
    let small = laid("[[human]]\nname = \"operator B\"\npercentile = 5").unwrap();
    let height = |body: &fmi_hazard::human::Body| body.height_m(Posture::Kneeling);
    assert!(height(&small.cell.second.as_ref().unwrap().body) < height(&small.cell.body));
    let scan = ["scan", "two-operators/cell.toml", "--from", "anywhere"];
    let ran = fmi_hazard(dir.path()).args(scan).output().unwrap();
    let told = String::from_utf8_lossy(&ran.stderr);
    assert!(ran.status.code() == Some(2) && told.contains("two people have their starts"), "{told}");
}
