//! Clamping behind the first contact: a tool on a slide hits somebody, which is a hazard, and pushes on to a plate. The complete search
//! against plain enumeration, against the same cell in which clamping alone counts, and what the commands say of it.

use std::collections::BTreeMap;
use std::ops::ControlFlow;
use std::path::Path;

use crate::common::exhausted::{BUDGET, Few};
use crate::common::hostile::{FMU, Hostile};
use crate::common::{fmi_hazard, scan_json, write};
use fmi_hazard::hazard::{Class, Finding, Identity};
use fmi_hazard::human::{Action, Posture, Walk};
use fmi_hazard::scan::{Prepared, StateChoice, prepare::prepare};
use fmi_hazard::search::exhaustive::{Account, SearchEvent, exhaust};
use fmi_hazard::search::{End, Environment as _};
use fmi_hazard::sim::Simulation;
use tempfile::TempDir;

/// The tool begins 0.63 m left of the plate at 0.5 m/s and more, and somebody stands between: their shoulder is touched when the
/// gap is 0.55 m, where it is no clamping yet, which begins at 0.50 m for a chest. The plate is so far to the right.
fn cell(plate_m: f64, mat: &str, actions: u32, criteria: &str) -> String {
    let plate_m = plate_m + 0.05;
    format!(
        r#"schema = 1
name = "press"
fmu = "{FMU}"
[[robot]]
name = "robot"
base = {{ xyz_m = [-0.75, 0, 1.2] }}
moving_mass_kg = 250
payload_kg = 30
[[robot.joint]]
name = "slide"
axis = [1, 0, 0]
position = {{ variable = "q" }}
speed = {{ variable = "qd" }}
[[robot.link]]
name = "tool"
joint = "slide"
capsule = {{ from_m = [0, -0.2, 0], to_m = [0, 0.2, 0], radius_m = 0.12 }}
[[obstacle]]
name = "plate"
centre_m = [{plate_m}, 0, 0.9]
size_m = [0.1, 1.6, 1.8]
[[sensor]]
name = "mat"
kind = "mat"
zone = {{ polygon_m = {mat} }}
variable = "stop"
active = true
[criteria]
{criteria}
[human]
start = {{ xy_m = [-0.35, 0.0], heading_deg = 90 }}
[search]
actions = {actions}
"#
    )
}

const FAR_AWAY: &str = "[[5, 5], [6, 5], [6, 6], [5, 6]]";
const EVERYWHERE: &str = "[[-3, -3], [3, -3], [3, 3], [-3, 3]]";
const BOTH: &str = "clamping = true";
const CLAMPING: &str = "clamping = true\ntransient_force = false";

fn prepared(dir: &Path, hostile: &Hostile, text: &str) -> Prepared {
    hostile.write(dir);
    prepare(&write(dir, "press.toml", text), None).unwrap()
}

/// Two ways to stand, and three to go away.
fn few() -> Vec<Action> {
    let all = [
        (Walk::Stop, Posture::Upright),
        (Walk::Stop, Posture::Forward),
        (Walk::Forward, Posture::Upright),
        (Walk::Right90, Posture::Upright),
        (Walk::Left90, Posture::Forward),
    ];
    all.into_iter().map(|(walk, posture)| Action::new(walk, posture)).collect()
}

/// Kinds of clampings, and how bad the worst of each is.
type Clampings = BTreeMap<String, f64>;

fn add(all: &mut Clampings, prepared: &Prepared, finding: &Finding) {
    if finding.class == Class::Clamping {
        let links: Vec<String> = prepared.cell.links.iter().map(|link| link.name.clone()).collect();
        let name = format!("{} {}", Identity::of(finding, &links).id(), finding.contact.region);
        let worst = all.entry(name).or_default();
        *worst = worst.max(finding.contact.ratio());
    }
}

/// By the complete search.
fn searched(prepared: &Prepared) -> (Account, Clampings) {
    let mut all = Clampings::new();
    let account = exhaust(&mut Few::of(prepared, &few()), BUDGET, &mut |told| {
        match told {
            SearchEvent::UnsafeState(met) => add(&mut all, prepared, &met.unsafe_state),
            SearchEvent::Noted { unsafe_state, .. } => add(&mut all, prepared, &unsafe_state),
            _ => {}
        }
        ControlFlow::Continue(())
    });
    (account.unwrap(), all)
}

/// By one sequence after the other: sequences with a hazard, and clampings, of which so many come behind one.
fn enumerated(prepared: &Prepared) -> (u128, Clampings, usize) {
    let mut simulation = prepared.simulation(StateChoice::Auto, false).unwrap();
    let (mut hazardous, mut all, mut behind) = (0, Clampings::new(), 0);
    let horizon = u32::try_from(simulation.horizon()).unwrap();
    let few = few();
    for code in 0..few.len().pow(horizon) {
        simulation.reset().unwrap();
        let mut is_hazardous = false;
        for place in 0..horizon {
            let action = few[code / few.len().pow(place) % few.len()];
            is_hazardous |= simulation.take(action).unwrap().end == Some(End::Unsafe);
            for finding in simulation.take_findings() {
                add(&mut all, prepared, &finding);
            }
            let later = simulation.take_behind();
            behind += later.len();
            later.iter().for_each(|finding| add(&mut all, prepared, finding));
        }
        hazardous += u128::from(is_hazardous);
    }
    (hazardous, all, behind)
}

/// Stands for three actions: hit in the first, clamped in the next, worse.
#[test]
fn by_hand_somebody_who_stands_is_hit_and_then_clamped() {
    let dir = TempDir::new().unwrap();
    let prepared = prepared(dir.path(), &Hostile::v2().slides(), &cell(0.0, FAR_AWAY, 2, BOTH));
    let mut simulation: Simulation<_> = prepared.simulation(StateChoice::Auto, false).unwrap();
    simulation.reset().unwrap();
    assert_eq!(simulation.take(Action::REST).unwrap().end, Some(End::Unsafe));
    let hit = simulation.take_findings();
    let [hit] = hit.as_slice() else { panic!("{hit:?}") };
    assert!(hit.class == Class::Force && hit.contact.clamp.is_none(), "{hit:?}");
    assert!(simulation.take_behind().is_empty() && simulation.goes_on());
    simulation.take(Action::REST).unwrap();
    assert!(simulation.take_findings().is_empty());
    let behind = simulation.take_behind();
    let worst = behind.iter().max_by(|a, b| a.contact.ratio().total_cmp(&b.contact.ratio())).unwrap();
    let clamp = worst.contact.clamp.unwrap();
    // m_R = 155 kg; with 0.5 to 0.6 m/s, which the FMU swells to, 1968 N a m/s on a chest that bears 140 N.
    assert!(worst.class == Class::Clamping && clamp.gap_m <= 0.5 && (0.5..0.601).contains(&clamp.closing_m_s));
    assert!(worst.contact.ratio() > 3.0 * hit.contact.ratio(), "{hit:?} {worst:?}");
    assert!(worst.actions.len() == 2 && worst.step > hit.step);
}

/// Nothing is lost where states are merged, and numbers of sequences are those of the first hazard.
#[test]
fn what_comes_behind_is_found_as_in_plain_enumeration() {
    for hostile in Hostile::both().map(Hostile::slides) {
        let dir = TempDir::new().unwrap();
        let prepared = prepared(dir.path(), &hostile, &cell(0.0, FAR_AWAY, 3, BOTH));
        let (account, found) = searched(&prepared);
        let (hazardous, plain, behind) = enumerated(&prepared);
        assert_eq!(found, plain);
        assert_eq!(account.hazardous, hazardous.into());
        assert!(behind > 20 && account.behind_cut.is_none(), "{behind}");
    }
}

/// With the force beside it every clamping is told that is one alone, as bad or worse.
#[test]
fn the_force_hides_no_clamping() {
    let dir = TempDir::new().unwrap();
    for plate_m in [0.0, -0.08] {
        let of = |criteria| {
            searched(&prepared(dir.path(), &Hostile::v2().slides(), &cell(plate_m, FAR_AWAY, 3, criteria))).1
        };
        let (alone, both) = (of(CLAMPING), of(BOTH));
        assert!(!alone.is_empty());
        for (kind, ratio) in alone {
            assert!(both.get(&kind).is_some_and(|both| *both >= ratio), "{kind} {ratio}: {both:?}");
        }
    }
}

/// Where there is room behind, and where a mat stops the tool soon enough, somebody is hit all the same, and nobody is clamped.
#[test]
fn repaired_twins_hit_and_do_not_clamp() {
    for (plate_m, mat) in [(1.3, FAR_AWAY), (0.3, EVERYWHERE)] {
        let dir = TempDir::new().unwrap();
        let prepared = prepared(dir.path(), &Hostile::v3().slides(), &cell(plate_m, mat, 2, BOTH));
        let (account, found) = searched(&prepared);
        assert!(account.hazardous > 0_u32.into() && found.is_empty(), "{plate_m}: {found:?}");
    }
}

/// The clamping that comes behind a hit is confirmed, told with the hit, and replays.
#[test]
fn a_scan_tells_it_and_a_replay_meets_it_again() {
    let dir = TempDir::new().unwrap();
    Hostile::v3().slides().write(dir.path());
    write(dir.path(), "press.toml", &cell(0.0, FAR_AWAY, 2, BOTH));
    for how in [&["exhaustive"][..], &["random", "--iterations", "12"]] {
        let scan = fmi_hazard(dir.path())
            .args(["scan", "--no-advice", "press.toml", "--out", "out", "--strategy"])
            .args(how)
            .output()
            .unwrap();
        assert_eq!(scan.status.code(), Some(1), "{}", String::from_utf8_lossy(&scan.stderr));
        let scan = scan_json(&dir.path().join("out"));
        let hazards = scan["hazards"].as_array().unwrap();
        let behind: Vec<_> = hazards.iter().filter(|hazard| hazard["first_contact"].is_object()).collect();
        assert!(!behind.is_empty() && hazards[0]["class"] == "clamping", "{how:?}");
        for hazard in hazards {
            assert_eq!((&hazard["confirmed"], &hazard["shortest"]["confirmed"]), (&true.into(), &true.into()));
        }
        assert!(behind.iter().any(|hazard| hazard["first_contact"]["class"] == "force"), "{how:?}");
        for hazard in behind {
            // Or clamped already, and less badly.
            let first = &hazard["first_contact"];
            assert!(
                hazard["class"] == "clamping" && (first["class"] == "force" || first["class"] == "clamping"),
                "{hazard}"
            );
            assert!(
                first["time_s"].as_f64() < hazard["time_s"].as_f64()
                    && first["ratio"].as_f64() < hazard["ratio"].as_f64()
            );
        }
    }
    let replay = fmi_hazard(dir.path()).args(["replay", "out", "all"]).output().unwrap();
    let said = String::from_utf8_lossy(&replay.stdout);
    assert!(said.lines().count() > 1 && said.lines().all(|line| line.contains(" reproduced: ")), "{said}");
}
