//! Controls: buttons that the person reaches or that anyone presses. The examples whose flaw is a reset, what their results tell,
//! where a hand gets to, and what a wrong cell file is told.

use std::path::Path;

use fmi_hazard::cell::binding::SensorBinding;
use fmi_hazard::geometry::segment_cuboid::segment_hits_cuboid;
use fmi_hazard::geometry::{Cuboid, Vec3};
use fmi_hazard::human::arm::{ABDUCTION, ArmModel, ELBOW, flexion_range, rotation_range};
use fmi_hazard::human::{Action, Posture, Presses, Side, Walk, Who, shoulder};
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::search::Rng;
use fmi_hazard::sim::World;
use fmi_hazard::sim::world::PersonState;

use crate::common::pair::Pair;
use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;

/// What a command prints, and how it ends.
fn ran(dir: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let text = [output.stdout, output.stderr].concat();
    let text = String::from_utf8_lossy(&text).replace(['│', '\n'], " ");
    assert!(!text.contains("panicked"), "{text}");
    (output.status.code(), text.split_whitespace().collect::<Vec<_>>().join(" "))
}

/// A variant of an example file.
fn variant(dir: &Path, example: &str, base: &str, more: &str) -> String {
    let file = format!("{example}/variant.toml");
    std::fs::write(dir.join(&file), format!("extends = \"{base}\"\nname = \"variant\"\n{more}\n")).unwrap();
    file
}

/// The person begins on the mat, so that five actions are enough.
const ON_THE_MAT: &str = "[human]\nstart = { xy_m = [-0.55, -1.2], heading_deg = 90 }\n[search]\nactions = 5\n";

#[test]
fn a_reset_with_somebody_inside_is_found_told_and_mended() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let pairs = [("reset-inside", "The person presses reset"), ("reset-outside", "A colleague presses reset")];
    // The search itself is compared with plain enumeration for both, in `exhaustive::presses_as_in_plain_enumeration`.
    for (example, who) in sample::some(pairs, pairs.len()) {
        let pair = Pair::scanned(dir, example, ON_THE_MAT, 72);
        assert_eq!(pair.flawed["certificate"]["sequences"], 72_u64.pow(5).to_string());
        for sentence in pair.causes() {
            assert!(sentence.starts_with(who) && sentence.contains("No sensor reports the person"), "{sentence}");
        }
        assert!(pair.told.contains(who), "{}", pair.told);
        // Nobody is hit without the press: it is in every sequence, and told by name.
        let hazards = pair.hazards();
        assert!(hazards.len() > 1);
        for hazard in hazards {
            let worked = hazard["worked"].as_array().unwrap();
            assert!(!worked.is_empty() && worked.iter().all(|working| working["name"] == "reset"), "{hazard}");
            assert!(hazard["shortest"]["confirmed"] == true, "{hazard}");
            let actions = hazard["shortest"]["actions"].as_array().unwrap();
            let presses = actions.iter().filter(|action| action.as_str().unwrap().ends_with("+press1"));
            assert_eq!(presses.count(), 1, "the calmest way presses once: {actions:?}");
        }
        let id = hazards[0]["id"].as_str().unwrap();
        let (code, told) = ran(dir, &["explain", "flawed", id, "--no-changes"]);
        let does = who.replace("The person", "the person").replace("A colleague", "a colleague");
        assert!(code == Some(1) || code == Some(0), "{told}");
        assert!(told.contains(&does), "{told}");
        // The page shows the button.
        let page = std::fs::read_to_string(dir.join("flawed/report.html")).unwrap();
        assert!(page.contains("\"name\":\"reset\",\"kind\":\"button\""), "{example}");
        // What became of the hazards in the repaired twin.
        let (code, told) = ran(dir, &["compare", "flawed", "fixed"]);
        assert!(code == Some(0) && told.contains(&format!(" {} fixed.", hazards.len())), "{told}");
        let (code, told) = ran(dir, &["replay", "flawed", "--changed", &pair.fixed]);
        assert_eq!(code, Some(0), "{told}");
        // Without the control nothing is found, and nothing is fixed by that.
        let held = format!("{ON_THE_MAT}\n[remove]\ncontrol = [\"reset\"]\n[inputs]\n\"plc.reset\" = false");
        let held = variant(dir, example, "cell.toml", &held);
        let (code, _) = ran(dir, &["scan", "--no-advice", &held, "--strategy", "exhaustive", "--out", "held"]);
        assert_eq!(code, Some(0));
        let (_, told) = ran(dir, &["compare", "flawed", "held"]);
        assert!(told.contains(&format!(" {} not found again.", hazards.len())), "{told}");
        let (code, told) = ran(dir, &["replay", "flawed", "--changed", &held]);
        assert!(code == Some(4) && told.contains("lacks a control that is worked on the way"), "{told}");
        // Whose button nobody works is no longer asked about it.
        let unworked = format!(
            "{ON_THE_MAT}\n[remove]\ncontrol = [\"reset\"]\n[[control]]\nname = \"reset\"\nvariable = \"plc.reset\"\nby = \"nobody\""
        );
        let unworked = variant(dir, example, "cell.toml", &unworked);
        let (code, told) = ran(dir, &["replay", "flawed", "--changed", &unworked]);
        assert!(code == Some(4) && told.contains("lacks a control that is worked on the way"), "{told}");
    }
}

/// Arms drawn at random, by their own forward kinematics: one that touches the button is one that the world knows of.
#[test]
fn a_hand_that_gets_there_is_not_missed() {
    let dir = examples();
    let prepared = prepare(&dir.path().join("reset-inside/cell.toml"), None).unwrap();
    let world = World::new(prepared.cell.clone(), prepared.binding.clone());
    assert!(matches!(prepared.binding.sensors[0], SensorBinding::Input(0)));
    let obstacles: Vec<Cuboid> = prepared.cell.obstacles.iter().map(|obstacle| obstacle.cuboid).collect();
    let button = prepared.cell.controls[0].place.unwrap();
    let (arm, mut rng) = (ArmModel::default(), Rng::new(5));
    let mut uniform = |(low, high): (f64, f64)| low + (high - low) * rng.below(1 << 30) as f64 / f64::from(1 << 30);
    let (mut reached, mut out_of_reach) = (0, 0);
    let mut place = world.first.start();
    for step in 0..40 {
        let walks = [Walk::Forward, Walk::Left45, Walk::Stop, Walk::Right45, Walk::Forward];
        let posture = Posture::USUAL[step % 6];
        let walked = world.first.walk(place, Action::new(walks[step % 5], posture));
        let action = Action::new(walks[step % 5], posture).pressing(Presses::one(0));
        let known = !world.first.worked(&walked, action).presses.is_none();
        let stance = PersonState {
            who: Who::First,
            place: walked.start,
            posture,
            moved: 0,
            broken: Vec::new(),
            raised: None,
            struck: false,
        };
        let body = world.first.body_of(&stance);
        let mut touched = false;
        for side in Side::BOTH.into_iter().filter(|side| shoulder::is_available(&body, *side, &obstacles)) {
            let frame = body.shoulder(side);
            for _ in 0..4000 {
                let abduction = uniform(ABDUCTION);
                let flexion = uniform(flexion_range(abduction));
                let config = [abduction, flexion, uniform(rotation_range(abduction, flexion)), uniform(ELBOW)];
                let (elbow, wrist) = arm.forward(side, config);
                let [elbow, wrist] = [elbow, wrist].map(|point| frame.translation + frame.rotation * point);
                let free = |a: Vec3, b: Vec3| !obstacles.iter().any(|obstacle| segment_hits_cuboid(a, b, obstacle));
                let near = (wrist - button.a).length() <= button.radius + arm.hand_radius_m - 0.05;
                touched |= near && free(frame.translation, elbow) && free(elbow, wrist);
            }
        }
        assert!(known || !touched, "step {step}: a hand gets there and is not known");
        let far = Side::BOTH.map(|side| (body.shoulder(side).translation - button.a).length());
        if far.into_iter().fold(f64::INFINITY, f64::min) > arm.reach() + button.radius + 0.03 {
            assert!(!known, "step {step}: nobody reaches so far");
            out_of_reach += 1;
        }
        reached += usize::from(touched);
        place = walked.end();
    }
    assert!(reached > 3 && out_of_reach > 3, "{reached} reached, {out_of_reach} out of reach");
}

#[test]
fn what_is_wrong_with_a_control_is_told() {
    let dir = examples();
    let control = |lines: &str| format!("[[control]]\nname = \"other\"\n{lines}\n");
    for (lines, problem) in [
        ("variable = \"plc.reset\"\nby = \"anyone\"", "`plc.reset` is driven by two things at once"),
        ("variable = \"plc.rest\"\nby = \"anyone\"", "did you mean `plc.reset`"),
        ("variable = \"plc.mat_clear\"", "control `other` does not say where it is"),
        ("variable = \"plc.mat_clear\"\nby = \"anyone\"\nwithin_m = 0.1", "has within_m and no at_m"),
        ("variable = \"plc.mat_clear\"\nat_m = [0, 0, 1]\nwithin_m = 7", "within_m of control `other` is 7"),
        ("variable = \"plc.mat_clear\"\nby = \"anyone\"\nfor_ms = 500", "for_ms of control `other` is 500"),
        (
            "variable = \"plc.mat_clear\"\nby = \"anyone\"\nkind = \"held\"\nfor_ms = 50",
            "has for_ms, which is for momentary ones",
        ),
    ] {
        let file = variant(dir.path(), "reset-inside", "cell.toml", &control(lines));
        let (code, told) = ran(dir.path(), &["check", &file]);
        assert!(code == Some(2) && told.contains(problem), "{lines}: {told}");
    }
    let same = "[remove]\ncontrol = [\"reset\"]\n[[control]]\nname = \"r\"\nby = \"anyone\"\nvariable = \"plc.reset\"\npressed = false";
    let file = variant(dir.path(), "reset-inside", "cell.toml", same);
    let (code, told) = ran(dir.path(), &["check", &file]);
    assert!(code == Some(2) && told.contains("has one value, pressed or not"), "{told}");
}

/// Through a light curtain a hand gets to a button, and the curtain tells of it: the stop is there for as long as it is pressed. A
/// button between two planes is not called complete.
#[test]
fn a_press_through_a_curtain_is_seen_by_it() {
    if !sample::is_turn(2, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    // Behind the entrance, seen from before it; the person stands so near that nothing but the arm is in the plane.
    let behind = "[remove]\ninputs = [\"plc.reset\"]\n[[control]]\nname = \"reset\"\nvariable = \"plc.reset\"\nat_m = [0.3, 0.25, 1.2]\n\
                  [human]\nstart = { xy_m = [0.3, -0.35], heading_deg = 90 }\n[search]\nactions = 2\n";
    let prepared = prepare(&dir.join(variant(dir, "light-curtain", "cell.toml", behind)), None).unwrap();
    let world = World::new(prepared.cell.clone(), prepared.binding.clone());
    let press = Action::new(Walk::Stop, Posture::Upright).pressing(Presses::one(0));
    let walked = world.first.walk(world.first.start(), press);
    let worked = world.first.worked(&walked, press);
    assert!(!worked.presses.is_none(), "a hand gets there");
    let sights = world.first.sights(&walked, press.posture());
    let sensed = world.sense(&world.delays_at_start(), Presses::NONE, &sights, &worked);
    let without = world.sense(&world.delays_at_start(), Presses::NONE, &sights, &Default::default());
    assert!(sensed.readings.iter().all(|readings| readings[0]), "the curtain tells of the arm");
    assert!(without.readings.iter().all(|readings| !readings[0]), "and of nothing else");
    // Whose body was in the plane, it does not say: arms are as far behind it as without the press.
    assert_eq!(sensed.broken, without.broken);
    let two = format!(
        "{behind}\n[[sensor]]\nname = \"second\"\nkind = \"light_curtain\"\nactive = false\nvariable = \"plc.curtain_clear\"\n\
         zone = {{ line_m = [[-0.5, 0.6], [0.5, 0.6]], heights_m = [0, 1.8] }}\n"
    );
    let file = variant(dir, "light-curtain", "fixed.toml", &two);
    let (_, told) = ran(dir, &["scan", "--no-advice", &file, "--strategy", "exhaustive", "--out", "two"]);
    assert!(told.contains("a hand may get to reset through more than one light curtain"), "{told}");
    assert_ne!(scan_json(&dir.join("two"))["certificate"]["complete"], true);
}
