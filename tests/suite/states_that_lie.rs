//! FMUs whose saved states lie where no self-test need meet it: whichever way states are brought back, hazards and counts
//! are those of plain replay, or there is no certificate.
//!
//! Each lie is met in every run of the tests, by default and with one more way of bringing states back; with all of them, in both versions
//! of FMI, where all cases are looked at.

use std::path::Path;

use crate::common::stored::scanned;
use crate::common::{fmi_hazard, json, scan_json, test_fmus, write};
use crate::sample;
use serde_json::Value;

/// One turning bar near the floor, where no hand gets, and a person who begins within three actions of being hit.
fn cell(lie: i32) -> String {
    let (actions, begins) = (actions(lie), if is_short(lie) { "begins_s = [0.2]\n" } else { "" });
    format!(
        r#"schema = 1
name = "liar"
fmu = "x.fmu"
[[robot]]
name = "turntable"
base = {{ xyz_m = [0, 0, 0.2] }}
moving_mass_kg = 40
payload_kg = 3
[[robot.joint]]
name = "table"
axis = [0, 0, 1]
angle = {{ variable = "q", unit = "rad" }}
speed = {{ variable = "qd", unit = "rad/s" }}
[[robot.link]]
name = "bar"
joint = "table"
capsule = {{ from_m = [0, 0, 0], to_m = [1.4, 0, 0], radius_m = 0.05 }}
[[sensor]]
name = "mat"
kind = "mat"
zone = {{ polygon_m = [[-3, 2.0], [3, 2.0], [3, 2.5], [-3, 2.5]] }}
variable = "stop"
active = true
[pose]
x = "x"
y = "y"
[parameters]
lie = {lie}
[human]
start = {{ xy_m = [0.3, 1.2], heading_deg = -90 }}
{begins}bend_forward_deg = 5
bend_lateral_deg = 5
[search]
actions = {actions}
iterations = 10
"#
    )
}

/// Sequences of so many actions: only longer ones have equal bytes that are gone on from.
fn actions(lie: i32) -> u32 {
    match lie {
        3 | 9 => 4,
        _ if is_short(lie) => 2,
        _ => 3,
    }
}

/// Where each sequence takes a process, a few of them: who begins 0.2 s later may slow the bar down in the second action already.
fn is_short(lie: i32) -> bool {
    lie == 8 && !sample::is_whole()
}

/// What came out of a scan.
#[derive(Debug)]
struct Ran {
    code: Option<i32>,
    scan: Value,
    run: Value,
    stderr: String,
}

impl Ran {
    fn complete(&self) -> bool {
        self.scan["certificate"]["complete"] == true
    }

    fn counts(&self) -> (&Value, Vec<(&str, &Value, &Value, &Value)>) {
        let hazards = self.scan["hazards"].as_array().unwrap().iter();
        let hazards = hazards.map(|h| (h["id"].as_str().unwrap(), &h["sequences"], &h["force_n"], &h["shortest"]));
        (&self.scan["certificate"]["hazardous"], hazards.collect())
    }

    fn rung(&self) -> &str {
        self.run["states_by"].as_str().unwrap()
    }

    fn confirmed(&self) -> bool {
        self.scan["hazards"].as_array().unwrap().iter().all(|h| h["confirmed"] == true)
    }

    /// Everything that a user reads about why.
    fn told(&self) -> String {
        let reasons = &self.scan["certificate"]["reasons"];
        format!("{} {reasons} {} {}", self.scan["warnings"], self.scan["obligations"], self.stderr)
    }
}

fn prepare(dir: &Path, fmu: &str, cell: &str) {
    std::fs::copy(test_fmus().join(fmu), dir.join("x.fmu")).unwrap();
    write(dir, "cell.toml", cell);
}

fn scan_in(dir: &Path, fmu: &str, lie: i32, more: &[&str]) -> Ran {
    prepare(dir, fmu, &cell(lie));
    let strategy = if more.contains(&"--strategy") { &[][..] } else { &["--strategy", "exhaustive"] };
    let args = ["scan", "--no-advice", "cell.toml", "--workers", "1", "--out", "o"];
    let output = fmi_hazard(dir).args(args).args(strategy).args(more).output().unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(dir.join("o/scan.json").is_file(), "{stderr}");
    let (scan, run) = (scan_json(&dir.join("o")), json(&dir.join("o/run.json")));
    Ran { code: output.status.code(), scan, run, stderr }
}

fn scan(fmu: &str, lie: i32, more: &[&str]) -> Ran {
    scan_in(tempfile::TempDir::new().unwrap().path(), fmu, lie, more)
}

const FMUS: [&str; 2] = ["liar.fmu", "liar-fmi3.fmu"];

/// What a user may ask for.
type Way = &'static [&'static str];

/// The default, and what a user may ask for.
const WAYS: [Way; 6] = [
    &[],
    &["--state", "fmu"],
    &["--state", "fork"],
    &["--state", "fork", "--merge", "history"],
    &["--state", "replay"],
    &["--state", "process"],
];

/// The first of these ways with an FMU of one version, and one other way with one of the other version: each lie has another, and each
/// run of the tests. All of them with both where all cases are looked at.
fn tried(lie: i32, ways: &[Way]) -> Vec<(&'static str, Way)> {
    let lie = usize::try_from(lie).unwrap();
    let (first, others) = ways.split_at(1);
    let mut all = Vec::new();
    for (number, ways) in [first, others].into_iter().enumerate() {
        let pairs: Vec<(&str, Way)> = ways.iter().flat_map(|way| FMUS.map(|fmu| (fmu, *way))).collect();
        let parts = pairs.len();
        let own = pairs.into_iter().enumerate().filter(|(case, _)| sample::takes(case + lie + number, parts));
        all.extend(own.map(|(_, pair)| pair));
    }
    all
}

/// The same, and that the FMU runs in this program.
fn tried_in_process_too(lie: i32) -> Vec<(&'static str, Way)> {
    let in_process: Way = &["--in-process"];
    tried(lie, &[&WAYS[..], &[in_process]].concat())
}

/// What plain replay finds in this cell: asked for by several tests.
fn plainly_of(cell: &str) -> Ran {
    let dir = tempfile::TempDir::new().unwrap();
    prepare(dir.path(), FMUS[0], cell);
    let plain = ["--no-advice", "cell.toml", "--workers", "1", "--strategy", "exhaustive", "--state", "replay"];
    let ran = scanned(dir.path(), &[&plain[..], &["--merge", "history", "--out", "o"]].concat());
    let (scan, run) = (scan_json(&dir.path().join("o")), json(&dir.path().join("o/run.json")));
    Ran { code: ran.code, scan, run, stderr: ran.stderr }
}

/// What plain replay finds.
fn plainly(lie: i32) -> Ran {
    plainly_of(&cell(lie))
}

/// With the flag as it should be, in the cell for a lie.
fn honest(lie: i32) -> Ran {
    plainly_of(&cell(lie).replace(&format!("lie = {lie}\n"), "lie = 0\n"))
}

/// All ways agree with `truth`; each is complete, and what is said holds these words where states are those of the FMU, as they are by
/// default.
fn all_agree(lie: i32, truth: &Ran, words: &str) {
    assert!(truth.complete() && truth.confirmed() && truth.counts().1.len() > 1, "{truth:?}");
    for (fmu, way) in tried(lie, &WAYS) {
        let ran = scan(fmu, lie, way);
        assert!(ran.complete() && ran.confirmed(), "{fmu} {lie} {way:?}: {ran:?}");
        assert_eq!(ran.counts(), truth.counts(), "{fmu} {lie} {way:?}");
        let again = &ran.scan["certificate"]["run_again"];
        assert!(again["compared"] == again["transitions"] && again["compared"].as_u64() > Some(20), "{again}");
        if way.is_empty() || way.contains(&"fmu") {
            assert!(ran.told().contains(words), "{fmu} {lie}: {}", ran.told());
            assert!(words.is_empty() || ran.rung() != "saved_states" || ran.told().contains("same bytes"));
        }
    }
}

#[test]
fn an_honest_one_is_searched_with_its_saved_states() {
    if !sample::is_turn(1, 2) {
        return;
    }
    all_agree(0, &honest(0), "");
    for fmu in sample::some(FMUS, 2) {
        let ran = scan(fmu, 0, &[]);
        assert_eq!((ran.rung(), ran.code), ("saved_states", Some(1)));
        assert!(!ran.told().contains("searched again"), "{}", ran.told());
    }
}

#[test]
fn a_flag_outside_the_saved_state() {
    all_agree(1, &honest(1), "saved FMU states cannot be relied on");
}

/// Whoever takes sequences one after the other, or asks what to do, is told the same as of an honest one.
#[test]
fn a_flag_outside_the_saved_state_changes_neither_quick_searches_nor_advice() {
    if !sample::is_turn(3, 4) {
        return;
    }
    for fmu in sample::some(FMUS, 2) {
        let few = if sample::is_whole() { "60" } else { "30" };
        let quick = |lie, state: &str| {
            let ran = scan(fmu, lie, &["--strategy", "random", "--iterations", few, "--state", state]);
            assert!(ran.confirmed() && ran.scan["hazards"].as_array().is_some_and(|all| !all.is_empty()));
            ran.scan["hazards"].clone()
        };
        if sample::takes(0, 4) || sample::takes(1, 4) {
            assert_eq!(quick(1, "fmu"), quick(0, "replay"));
        }
        let advised = |lie| {
            let dir = tempfile::TempDir::new().unwrap();
            let ran = scan_in(dir.path(), fmu, lie, &[]);
            let id = ran.scan["hazards"][0]["id"].as_str().unwrap();
            let output = fmi_hazard(dir.path())
                .args(["explain", "o", id, "--from", "start", "--quick", "--format", "json"])
                .output()
                .unwrap();
            let told: Value = serde_json::from_slice(&output.stdout).unwrap();
            let told = told["remedies"].as_array().unwrap().iter();
            told.map(|r| format!("{}: {}", r["change"], r["outcome"]).replace("lie = 1", "lie = 0")).collect::<Vec<_>>()
        };
        if sample::takes(2, 4) || sample::takes(3, 4) {
            assert_eq!(advised(1), advised(0));
        }
    }
}

#[test]
fn a_restored_state_that_keeps_a_live_latch() {
    all_agree(2, &plainly(2), "saved FMU states cannot be relied on");
}

/// What is gone on from equal bytes is what comes out, though they lack something; these words are said of it.
fn bytes_that_lack(lie: i32, shown: &str) {
    let truth = plainly(lie);
    assert!(truth.complete() && truth.confirmed());
    let mut ways = vec![WAYS[0], WAYS[1], WAYS[2], WAYS[4]];
    if sample::is_whole() {
        // A process for each of so many sequences takes a quarter of a minute.
        ways.push(WAYS[5]);
    }
    for (fmu, way) in tried(lie, &ways) {
        let ran = scan(fmu, lie, way);
        assert!(ran.complete() && ran.confirmed(), "{fmu} {way:?}: {ran:?}");
        assert_eq!(ran.counts(), truth.counts(), "{fmu} {way:?}");
        if way == WAYS[4] {
            continue;
        }
        let told = ran.told();
        assert!(told.contains("with the same bytes") && told.contains(shown), "{told}");
        // The states themselves are right, so they are kept.
        let asked = if way.contains(&"fork") { "copies" } else { "processes" };
        assert_eq!(ran.rung(), if way.is_empty() || way.contains(&"fmu") { "saved_states" } else { asked });
    }
}

#[test]
fn bytes_that_lack_what_the_state_holds() {
    bytes_that_lack(3, "went on differently");
}

/// Nothing shows while merges are tried out: only runs from the start meet it.
#[test]
fn bytes_that_lack_what_matters_much_later_only() {
    bytes_that_lack(9, "run again from the start");
}

#[test]
fn a_state_that_is_exact_only_where_inputs_never_rest() {
    if !sample::is_turn(0, 2) {
        return;
    }
    for (lie, truth) in [(4, plainly(4)), (7, honest(7))] {
        for fmu in sample::some(FMUS, 2) {
            let dir = tempfile::TempDir::new().unwrap();
            let ran = scan_in(dir.path(), fmu, lie, &[]);
            assert_eq!(ran.scan["self_test"]["restore"]["result"], "differs", "{fmu} {lie}");
            assert!(ran.complete() && ran.confirmed() && ran.rung() != "saved_states", "{fmu} {lie}: {ran:?}");
            assert_eq!(ran.counts(), truth.counts());
            // What the self-test of the FMU alone says is the same.
            let output =
                fmi_hazard(dir.path()).args(["inspect", "--self-test", "x.fmu", "--format", "json"]).output().unwrap();
            let alone: Value = serde_json::from_slice(&output.stdout).unwrap();
            assert!(lie != 4 || alone["restore"]["result"] == "exact", "its lie is a parameter, and 0 there");
        }
        all_agree(lie, &truth, "");
    }
}

#[test]
fn noise_in_an_output_that_is_not_bound_is_not_certified() {
    let honest = honest(5);
    for (fmu, way) in tried_in_process_too(5) {
        let ran = scan(fmu, 5, way);
        assert!(!ran.complete() && ran.confirmed() && ran.code == Some(1), "{fmu} {way:?}: {ran:?}");
        assert!(ran.told().contains("does not repeat its output `spare`"), "{}", ran.told());
        assert_eq!(ran.counts(), honest.counts(), "what was found is there");
    }
}

#[test]
fn noise_that_only_a_rare_input_wakes_is_not_certified() {
    for (fmu, way) in tried_in_process_too(6) {
        let ran = scan(fmu, 6, way);
        assert!(!ran.complete() && ran.scan["verdict"] != "none_found", "{fmu} {way:?}: {ran:?}");
        assert!(ran.told().contains("does not repeat itself"), "{fmu} {way:?}: {}", ran.told());
        assert!(!ran.told().contains("--self-test"), "{}", ran.told());
    }
}

#[test]
fn instances_that_share_a_flag_get_processes_of_their_own() {
    let honest = honest(8);
    for (fmu, way) in tried(8, &WAYS) {
        let ran = scan(fmu, 8, way);
        assert!(ran.complete() && ran.confirmed(), "{fmu} {way:?}: {ran:?}");
        assert_eq!((ran.counts(), ran.rung()), (honest.counts(), "processes"));
    }
}
