//! Obstacles and sensors that follow outputs of the FMU: random sequences against those stepped by hand, the exhaustive search against plain
//! enumeration, and mistakes in cell files.

use std::path::{Path, PathBuf};

use crate::common::by_hand::{ByHand, Mattered};
use crate::common::enumerated::{Enumeration, whole_scan_as_enumerated};
use crate::common::exhausted::{BUDGET, Few, exhausted, key};
use crate::common::guarded::every_sequence;
use crate::common::twin::geometry::{V3, length, sub};
use crate::common::{examples, fmi_hazard, write};
use crate::sample;
use fmi_hazard::host::Hosted;
use fmi_hazard::human::{Action, Posture, Walk};
use fmi_hazard::scan::{StateChoice, prepare::prepare};
use fmi_hazard::search::{Environment as _, Rng};
use fmi_hazard::sim::Simulation;

const POSTURES: [Posture; 6] =
    [Posture::Upright, Posture::Forward, Posture::Left, Posture::Right, Posture::ForwardLeft, Posture::ForwardRight];

const CURTAIN: &str = "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\nvariable = \"plc.curtain_clear\"\nactive = false\n\
                       zone = { line_m = [[-0.5, 0], [0.5, 0]], heights_m = [0, 1.8] }\n";

/// A box in the way, and what it follows.
fn thing(centre: V3, size: V3, follows: &str) -> String {
    format!("[[obstacle]]\nname = \"thing\"\ncentre_m = {centre:?}\nsize_m = {size:?}\n{follows}\n")
}

/// A sensor of the floor, from one corner to another.
fn floor(kind: &str, [x0, y0]: [f64; 2], [x1, y1]: [f64; 2], counts: &str) -> String {
    let polygon = [[x0, y0], [x1, y0], [x1, y1], [x0, y1]];
    format!(
        "[[sensor]]\nname = \"floor\"\nkind = \"{kind}\"\nzone = {{ polygon_m = {polygon:?} }}\n\
         variable = \"plc.curtain_clear\"\nactive = false\n{counts}\n"
    )
}

/// The example with other things and sensors, and the person before them; when the conveyor begins, and how fast it is.
struct Variant {
    parts: String,
    y: f64,
    begins_s: f64,
    conveyor: (f64, f64),
    mute_s: f64,
}

impl Variant {
    /// The cell file, with the robot this far back.
    fn file(&self, dir: &Path, robot_m: f64, search: &str) -> PathBuf {
        let text = std::fs::read_to_string(dir.join("muted-entrance/cell.toml")).unwrap();
        let (before, _) = text.split_once("# It fills the entrance").unwrap();
        let base = "xyz_m = [0, 2.55, 0.275]";
        assert!(before.contains(base));
        let before = before.replace(base, &format!("xyz_m = [0, {robot_m}, 0.275]"));
        let text = format!(
            "{before}{}[inputs]\n\"plc.reset\" = false\n\
             [human]\nstart = {{ xy_m = [0.1, {}], heading_deg = 90 }}\nbegins_s = [{}]\n\
             [parameters]\n\"conveyor.begins_s\" = {}\n\"conveyor.speed\" = {}\n\"plc.mute_s\" = {}\n[search]\n{search}\n",
            self.parts, self.y, self.begins_s, self.conveyor.0, self.conveyor.1, self.mute_s
        );
        write(&dir.join("muted-entrance"), "variant.toml", &text)
    }
}

fn bits(row: &[f64]) -> Vec<u64> {
    row.iter().map(|x| x.to_bits()).collect()
}

/// Cells in which things come, go and pass while people walk, and sensors count for a time.
fn variants() -> Vec<(&'static str, Variant)> {
    let out = "moves_with = { variable = \"conveyor.pallet_m\", direction = [0, -1, 0], from_m = 0, to_m = 3 }";
    let pallet = thing([0.0, 0.15, 0.6], [0.9, 1.0, 1.2], out);
    let across = "moves_with = { variable = \"conveyor.pallet_m\", direction = [4, 1, 0], from_m = 0.1, to_m = 2.3, every_m = 0.15 }";
    let across = thing([-0.7, -0.7, 0.5], [0.4, 0.6, 1.0], across);
    let leaves = thing([0.0, -0.6, 0.6], [0.9, 0.3, 1.2], "stands_while = { variable = \"conveyor.in_entrance\" }");
    let comes = thing([0.1, -0.9, 0.5], [0.8, 0.8, 1.0], "stands_while = { variable = \"plc.muted\", is = false }");
    let both = "stands_while = { variable = \"conveyor.pallet_m\", from = 0.3, to = 1.7 }\n\
                moves_with = { variable = \"conveyor.pallet_m\", direction = [1, 0, 0], from_m = -1, to_m = 1.2, every_m = 0.4 }";
    let both = thing([-0.7, -0.8, 0.6], [0.8, 0.5, 1.2], both);
    let leg = thing([0.1, -0.6, 0.6], [0.6, 0.3, 1.2], "stands_while = { variable = \"ctrl.leg\", is = 0 }");
    let mat = floor("mat", [-0.6, -1.0], [0.6, -0.2], "counts_while = { variable = \"plc.muted\" }");
    let field = "counts_while = { variable = \"conveyor.pallet_m\", to = 0.5 }\ndelay_ms = 60";
    let field = floor("scanner_field", [-0.6, -1.0], [0.6, -0.2], field);
    let later = floor(
        "mat",
        [-0.6, -1.2],
        [0.6, -0.2],
        "counts_while = { variable = \"conveyor.pallet_m\", from = 0.4 }\ndelay_ms = 40",
    );
    let variant = |parts: &[&str], y: f64, begins_s: f64, conveyor: (f64, f64), mute_s: f64| Variant {
        parts: parts.concat(),
        y,
        begins_s,
        conveyor,
        mute_s,
    };
    vec![
        ("pallet", variant(&[&pallet, CURTAIN], -1.2, 0.1, (0.213, 2.0), 1.0)),
        ("across", variant(&[&across, CURTAIN], -1.6, 0.1, (0.107, 1.3), 1.0)),
        ("leaves", variant(&[&leaves, CURTAIN], -1.6, 0.1, (0.013, 2.0), 0.3)),
        ("comes", variant(&[&comes, CURTAIN], -1.8, 0.0, (0.213, 2.0), 0.23)),
        ("both", variant(&[&both, CURTAIN], -1.7, 0.06, (0.113, 1.9), 0.9)),
        ("leg", variant(&[&leg, &mat], -1.1, 0.1, (0.213, 2.0), 0.6)),
        ("mat", variant(&[&pallet, &mat], -1.3, 0.02, (0.117, 0.7), 0.57)),
        ("field", variant(&[&field, &leaves], -1.3, 0.02, (0.213, 1.9), 0.0)),
        ("later", variant(&[&later, &both], -1.3, 0.3, (0.613, 1.7), 0.0)),
    ]
}

/// One sequence stepped by hand and told by the library: the person's places, sensors, inputs and outputs are the same.
fn compared(
    by_hand: &ByHand,
    simulation: &mut Simulation<Hosted>,
    does: &[(usize, usize)],
    of: &str,
) -> (Mattered, usize) {
    let action = |(walk, posture): &(usize, usize)| Action::new(Walk::USUAL[*walk], POSTURES[*posture]);
    let actions: Vec<Action> = does.iter().map(action).collect();
    let (went, watched) = (by_hand.walk(does), simulation.watch(&actions, &[]).unwrap());
    assert_eq!(watched.instants.len(), went.places.len() + 1);
    for (step, instant) in watched.instants[1..].iter().enumerate() {
        let told = format!("{of}: {does:?}, step {step}");
        let ([x, y], position) = (went.places[step], instant.position);
        assert!((position.x - x).hypot(position.y - y) < 1e-9, "{told}: {x}, {y}, {position}");
        let head = instant.body.parts()[0].1.a.to_array();
        assert!(length(sub(head, went.heads[step])) < 1e-9, "{told}: {head:?}, {:?}", went.heads[step]);
        assert_eq!(instant.readings, went.readings[step], "{told}");
        for (rows, own) in [(&watched.inputs, &went.inputs), (&watched.outputs, &went.outputs)] {
            let columns = own.len() / went.places.len();
            let row = step * columns..(step + 1) * columns;
            assert_eq!(bits(&rows[row.clone()]), bits(&own[row]), "{told}");
        }
    }
    assert_eq!((watched.inputs.len(), watched.outputs.len()), (went.inputs.len(), went.outputs.len()));
    // Taken one after the other, they may end in a hazard: it is there where the person stood by hand.
    simulation.reset().unwrap();
    let _ = actions.iter().map(|action| simulation.take(*action).unwrap().end).find(Option::is_some);
    let met = simulation.take_findings();
    for finding in &met {
        let ([x, y], told) = (went.places[finding.step - 1], format!("{of}: {does:?}, {finding:?}"));
        assert!((finding.person.x - x).hypot(finding.person.y - y) < 1e-9, "{told}");
        assert!(!finding.through.is_empty() || finding.sensors == went.readings[finding.step - 1], "{told}");
    }
    (went.mattered, met.len())
}

/// Random sequences, in each cell with all that changes in it a little later each time.
#[test]
fn what_follows_the_fmu_as_stepped_by_hand() {
    if !sample::is_turn(3, 6) {
        return;
    }
    let dir = examples();
    let mut rng = Rng::new(20);
    let (mut sequences, mut mattered, mut all, mut hazards) = (0_u32, 0_u32, Mattered::default(), 0);
    let back = variants().into_iter().map(|variant| (variant, 2.55));
    for ((name, mut variant), robot_m) in back.chain(near().into_iter().map(|variant| (variant, 1.75))) {
        let mut of_cell = Mattered::default();
        for _ in 0..4 {
            let file = variant.file(dir.path(), robot_m, "actions = 6");
            let prepared = prepare(&file, None).unwrap();
            let by_hand = ByHand::new(&file, &prepared);
            let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
            for _ in 0..12 {
                let mut one = || ([1, 1, rng.below(6)][rng.below(3)], [0, rng.below(6)][rng.below(2)]);
                let does: Vec<(usize, usize)> = (0..6).map(|_| one()).collect();
                let (told, met) = compared(&by_hand, &mut simulation, &does, name);
                sequences += 1;
                hazards += met;
                mattered += u32::from(told != Mattered::default());
                of_cell.add(told);
            }
            variant.conveyor.0 += 0.06;
            variant.mute_s += 0.06;
        }
        assert!(robot_m < 2.0 || of_cell != Mattered::default(), "{name}: nothing follows");
        all.add(of_cell);
    }
    assert!(
        2 * mattered > sequences && hazards > 20,
        "{mattered} of {sequences}, {hazards} hazards: little to compare"
    );
    assert!(all.stopped.min(all.let_through) > 10 && all.walked_out.min(all.unheeded) > 100, "{all:?}");
}

/// The same from near, where few actions lead to the robot.
fn near() -> Vec<(&'static str, Variant)> {
    let out = "moves_with = { variable = \"conveyor.pallet_m\", direction = [0, -1, 0], from_m = 0, to_m = 3 }";
    let pallet = thing([0.0, 0.15, 0.6], [0.9, 1.0, 1.2], out);
    let leaves = thing([0.0, 0.0, 0.6], [0.9, 0.2, 1.2], "stands_while = { variable = \"conveyor.in_entrance\" }");
    let comes = "stands_while = { variable = \"conveyor.pallet_m\", from = 0.45, to = 0.9 }";
    let comes = thing([0.3, 0.5, 0.6], [0.6, 0.3, 1.2], comes);
    let mat = floor("mat", [-0.6, -0.4], [0.6, 0.2], "counts_while = { variable = \"conveyor.pallet_m\", from = 0.5 }");
    let field = "counts_while = { variable = \"conveyor.pallet_m\", to = 0.5 }\ndelay_ms = 60";
    let field = floor("scanner_field", [-0.6, -0.2], [0.6, 0.6], field);
    let variant = |parts: &[&str], conveyor: (f64, f64), mute_s: f64| Variant {
        parts: parts.concat(),
        y: -0.5,
        begins_s: 0.1,
        conveyor,
        mute_s,
    };
    vec![
        ("pallet", variant(&[&pallet, CURTAIN], (0.113, 2.0), 0.5)),
        // It leaves in the last step of an action: who stands before it walks on in the first of the next.
        ("leaves", variant(&[&leaves, CURTAIN], (0.095, 1.9), 0.7)),
        ("mat", variant(&[&comes, &mat], (0.113, 1.7), 0.0)),
        ("field", variant(&[&pallet, &comes, &field], (0.113, 0.7), 0.0)),
    ]
}

/// Few actions from near, with a curtain or with a mat or a field instead that counts for a time: every finding to the last bit, with how
/// many sequences begin so.
#[test]
fn exhaustive_counts_of_what_follows_as_in_plain_enumeration() {
    let dir = examples();
    let moves = [
        (Walk::Stop, Posture::Upright),
        (Walk::Forward, Posture::Upright),
        (Walk::Forward, Posture::ForwardLeft),
        (Walk::Right45, Posture::Forward),
        (Walk::Left90, Posture::Upright),
    ];
    let few = moves.map(|(walk, posture)| Action::new(walk, posture));
    let mut merged = 0;
    // From a fresh instance each takes three times as long.
    let state = if sample::is_whole() { StateChoice::Replay } else { StateChoice::Auto };
    for (name, variant) in sample::some(near(), 2) {
        let file = variant.file(dir.path(), 1.75, "actions = 6\nreach_tolerance_m = 0.05");
        let prepared = prepare(&file, None).unwrap();
        let mut expansion = Few::of(&prepared, &few);
        let (account, found) = exhausted(&mut expansion, BUDGET);
        let plain = Enumeration::of(&prepared, state, &few, &key);
        assert_eq!(found, plain.found, "{name}");
        let [hazardous, harmless, excluded] = [&account.hazardous, &account.harmless, &account.excluded]
            .map(|count| u128::try_from(count.clone()).unwrap());
        assert_eq!((hazardous, harmless + excluded), (plain.hazardous(), plain.harmless), "{name}");
        assert_eq!(hazardous + harmless + excluded, 5_u128.pow(6), "{name}");
        assert!(found.len() > 5 && plain.harmless > 1000, "{name}: little to compare");
        merged += expansion.0.recall().merges().merged;
    }
    assert!(merged > if sample::is_whole() { 500 } else { 0 }, "{merged} states merged");
}

/// The pair of examples, from just before the curtain: whole scans, and, with the robot nearer and the pallet in the entrance until
/// then, every sequence of three of all actions. Muted no longer than that, nobody is harmed.
fn muted_entrance_as_in_plain_enumeration(base: &str, harmed: bool) {
    let dir = examples();
    let nearer = "[[robot]]\nname = \"KR 16-2\"\nbase = { xyz_m = [0, 2.25, 0.275], rpy_deg = [0, 0, -90] }\n\
                  [parameters]\n\"conveyor.begins_s\" = 2.3\n\"conveyor.speed\" = 2.0\n";
    let prepared = |actions: u32, more: &str| {
        let text = format!(
            "extends = \"{base}.toml\"\nname = \"near\"\n{more}[search]\nactions = {actions}\nreach_tolerance_m = 0.05\n\
             [human]\nstart = {{ xy_m = [0.1, -0.15], heading_deg = 90 }}\nbegins_s = [2.6]\n"
        );
        prepare(&write(&dir.path().join("muted-entrance"), "near.toml", &text), None).unwrap()
    };
    let (hazardous, nearer) = whole_scan_as_enumerated(&prepared(3, nearer), StateChoice::Auto, base);
    assert_eq!(hazardous > 500, harmed, "{base}: {hazardous}");
    let whole = every_sequence(&prepared(4, ""), false);
    for (report, least) in [(nearer, 5), (whole, 50)] {
        assert_eq!((report.hazards.is_empty(), report.hazards.len() > least), (!harmed, harmed), "{base}");
        assert!(report.hazards.iter().all(|hazard| hazard.confirmed == Some(true)), "{base}");
    }
}

#[test]
fn the_muted_entrance_as_in_plain_enumeration() {
    if !sample::is_turn(6, 12) {
        return;
    }
    muted_entrance_as_in_plain_enumeration("cell", true);
}

#[test]
fn the_repaired_muted_entrance_as_in_plain_enumeration() {
    if !sample::is_turn(2, 6) {
        return;
    }
    muted_entrance_as_in_plain_enumeration("fixed", false);
}

/// Mistakes in the cell file are told, and what a scan from anywhere cannot look at.
#[test]
fn mistakes_with_what_follows_are_told() {
    let dir = examples();
    let text = std::fs::read_to_string(dir.path().join("muted-entrance/cell.toml")).unwrap();
    let way = text.lines().find(|line| line.starts_with("moves_with")).unwrap();
    let door = "opened_by = \"door\"\nstands_while = { variable = \"plc.muted\" }\n[[control]]\nname = \"door\"\n\
                kind = \"toggled\"\nvariable = \"plc.reset\"\nat_m = [0.7, -0.1, 1.1]";
    let stands = |range: &str| format!("stands_while = {{ variable = \"conveyor.pallet_m\", {range} }}");
    let (both, none) = (stands("is = 1, from = 0"), stands("from = 2, to = 1"));
    let low = "follows the FMU, and the person crouches or crawls";
    let second = format!("{way}\n{}", thing([0.0, 2.0, 0.6], [0.1; 3], way).replace("thing", "second"));
    for (changed, to, problem) in [
        (way, door, "obstacle `pallet` is the leaf of a door, and follows the FMU"),
        ("1.8] }", "1.8] }\ncounts_while = { variable = \"plc.muted\" }", "`curtain` is no mat and no scanner field"),
        (way, &both, "`is` and a range are given"),
        (way, &none, "nothing is from 2 to 1"),
        ("every_m = 0.05", "every_m = 0", "every_m of obstacle `pallet`"),
        ("from_m = 0, to_m = 3", "from_m = 3, to_m = 0", "obstacle `pallet` moves from 3 to 0 m"),
        ("direction = [0, -1, 0]", "direction = [0, 0, 0]", "obstacle `pallet` moves in no direction"),
        ("conveyor.pallet_m", "conveyor.palet_m", "variable `conveyor.palet_m` is not in muted-entrance.fmu"),
        ("conveyor.pallet_m", "plc.muted", "a Real output is needed here, `plc.muted` is Boolean"),
        ("every_m = 0.05", "every_m = 0.001", "obstacle `pallet` has 3001 positions, 1000 at most"),
        (way, &second.replace("every_m = 0.05", "every_m = 0.04"), "stand in more than 1024 ways"),
        ("[human]", "[human]\nalso = [\"kneel\"]", low),
        ("[human]", "[human]\nalso = [\"crouch\"]", low),
        ("[human]", "[human]\nalso = [\"run\", \"crawl\"]", low),
    ] {
        assert!(text.contains(changed), "{changed}");
        let file = write(&dir.path().join("muted-entrance"), "wrong.toml", &text.replacen(changed, to, 1));
        let error = prepare(&file, None).err().map_or_else(String::new, |error| error.to_string());
        assert!(error.contains(problem), "{problem}: {error}");
    }
    let scan = ["scan", "muted-entrance/cell.toml", "--from", "anywhere"];
    let ran = fmi_hazard(dir.path()).args(scan).output().unwrap();
    let told = String::from_utf8_lossy(&ran.stderr).replace('│', " ");
    let told = told.split_whitespace().collect::<Vec<_>>().join(" ");
    assert_eq!(ran.status.code(), Some(2), "{told}");
    assert!(
        told.contains("leave stands_while, moves_with, counts_while and works_while out of the cell file"),
        "{told}"
    );
}
