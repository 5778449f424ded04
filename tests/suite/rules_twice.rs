//! The program's exhaustive scan against a plain enumeration written from the page `docs/src/method.md` alone
//! (`common/twin`). Compared are, for each cell:
//!
//! - the number of hazardous sequences: equal where only head, trunk and legs are hit, else between what the enumeration is
//!   certain of and that with what it cannot decide (arms at the edge of a contact);
//! - each reported hazard, its worst and its shortest sequence: nothing before it is certainly unsafe; a body's contact has
//!   the same class, region, link, time and forces; an arm's pose is possible, free of obstacles and planes, and touches as
//!   reported in one of the runs that the planes allow. Forces are both, with the robot's own speed and with the speed of
//!   approach, whichever decides in the cell;
//! - that each hazard was confirmed.
#![allow(clippy::print_stdout, reason = "figures of both for who reads the log")]

use crate::common::twin;

use std::path::Path;

use crate::common::{examples, fmi_hazard, scan_json};
use crate::sample;
use serde_json::Value;
use twin::arm::{FORE, Pose, UPPER, Verdict, angles, within};
use twin::body::shoulder;
use twin::cell::Cell;
use twin::cells::{self, Gantry};
use twin::enumerate::{Count, Hit, Twin};
use twin::force::Forces;
use twin::geometry::{V3, length, sub};

/// What both found.
#[derive(Debug)]
struct Both {
    program: u64,
    twin: Count,
    /// Class, region and link of hazards: of the body, of arms.
    body: Vec<String>,
    arms: Vec<String>,
    disagree: Vec<String>,
}

impl Both {
    fn agree(&self) {
        let Self { program, twin, body, arms, disagree } = self;
        println!("program {program}, enumeration {} to {}; body {body:?}, arms {arms:?}", twin.certain, twin.at_most);
        assert!(disagree.is_empty(), "{}", disagree.join("\n"));
    }
}

/// The program's results.
fn scanned(file: &Path) -> Value {
    let out = file.with_file_name("out");
    let output = fmi_hazard(file.parent().unwrap())
        .args(["scan", "--no-advice", "--strategy", "exhaustive", "--out", "out"])
        .arg(file)
        .output()
        .unwrap();
    assert!(matches!(output.status.code(), Some(0 | 1)), "{}", String::from_utf8_lossy(&output.stderr));
    scan_json(&out)
}

/// Hazardous sequences by the program.
fn hazardous(scan: &Value) -> u64 {
    text(&scan["certificate"]["hazardous"]).parse().unwrap()
}

fn both(file: &Path) -> Both {
    let scan = scanned(file);
    let certificate = &scan["certificate"];
    let mut disagree = Vec::new();
    if certificate["complete"] != true {
        disagree.push(format!("not complete: {certificate}"));
    }
    let mut twin = Twin::new(Cell::read(file));
    let count = twin.count();
    let program = hazardous(&scan);
    if program < count.certain || program > count.at_most {
        disagree.push(format!("hazardous sequences: program {program}, enumeration {count:?}"));
    }
    let hazards = scan["hazards"].as_array().unwrap();
    let (mut body, mut arms) = (Vec::new(), Vec::new());
    for hazard in hazards {
        let list = if hazard["arm"].is_null() { &mut body } else { &mut arms };
        let [class, region, link] = ["class", "body_region", "robot_link"].map(|key| text(&hazard[key]));
        list.push(format!("{class} {region} {link}"));
        if hazard["confirmed"] != true || hazard["shortest"]["confirmed"] == false {
            disagree.push(format!("not confirmed: {}", hazard["id"]));
        }
        if let Err(why) = possible(&mut twin, hazard) {
            disagree.push(format!("{} {} {}: {why}", hazard["id"], hazard["body_region"], hazard["actions"]));
        }
        if let Err(why) = shortest(&mut twin, hazard) {
            disagree.push(format!("{} shortest {}: {why}", hazard["id"], hazard["shortest"]["actions"]));
        }
    }
    for list in [&mut body, &mut arms] {
        list.sort();
        list.dedup();
    }
    Both { program, twin: count, body, arms, disagree }
}

fn text(value: &Value) -> &str {
    value.as_str().unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap()
}

fn point(value: &Value) -> V3 {
    [0, 1, 2].map(|i| number(&value[i]))
}

fn sequence(value: &Value) -> Vec<String> {
    value.as_array().unwrap().iter().map(|action| text(action).to_owned()).collect()
}

/// The instant of a hazard, if nothing before it is certainly unsafe.
fn instant(twin: &mut Twin, actions: &Value, time: f64) -> Result<twin::enumerate::Instant, String> {
    let actions = sequence(actions);
    let instants = twin.follow(&actions, usize::MAX);
    let step = (1..100_000).find(|n| (f64::from(*n) * twin.cell.step - time).abs() < 1e-6).ok_or("no whole step")?;
    let step = usize::try_from(step).unwrap() - 1;
    if let Some((i, early)) =
        instants.iter().enumerate().take(step).find(|(_, i)| i.body.is_some() || i.arms == Verdict::Certain)
    {
        return Err(format!("unsafe before, at step {i}: {:?} {:?}", early.body, early.arms));
    }
    instants.get(step).cloned().ok_or_else(|| "the sequence is too short".to_owned())
}

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-6 * b.abs().max(1.0)
}

/// Both forces of a hazard, and the ratio of the one that decides.
fn same_forces(hazard: &Value, forces: &Forces) -> bool {
    close(number(&hazard["force_n"]), forces.own)
        && close(number(&hazard["directed_force_n"]), forces.approach)
        && close(number(&hazard["ratio"]), forces.ratio())
}

/// The worst sequence of a hazard.
fn possible(twin: &mut Twin, hazard: &Value) -> Result<(), String> {
    let at = instant(twin, &hazard["actions"], number(&hazard["time_s"]))?;
    let told = (text(&hazard["class"]), text(&hazard["body_region"]), text(&hazard["robot_link"]));
    let program = || {
        let [own, approach, ratio] = ["force_n", "directed_force_n", "ratio"].map(|key| number(&hazard[key]));
        format!("program {told:?} {own} {approach} {ratio} at {}", hazard["contact_point_m"])
    };
    let place = point(&hazard["contact_point_m"]);
    let arm = &hazard["arm"];
    if arm.is_null() {
        let hit = at.body.ok_or("head, trunk and legs are safe there")?;
        let own = (hit.class, hit.region, hit.link.as_str());
        let same = own == told && same_forces(hazard, &hit.forces) && length(sub(hit.point, place)) < 1e-6;
        return if same { Ok(()) } else { Err(format!("{}, enumeration {hit:?}", program())) };
    }
    if let Some(hit) = at.body {
        return Err(format!("the body is hit there: {hit:?}"));
    }
    if at.arms == Verdict::None {
        return Err("no pose of an arm is above the limit there".to_owned());
    }
    let side = if arm["side"] == "left" { 1.0 } else { -1.0 };
    let pose =
        Pose { shoulder: point(&arm["shoulder_m"]), elbow: point(&arm["elbow_m"]), wrist: point(&arm["wrist_m"]) };
    let body = twin.body(at.place, at.posture);
    let joint = body.in_world(shoulder(side));
    if length(sub(joint, pose.shoulder)) > 1e-6 {
        return Err(format!("the shoulder is at {joint:?}, not {:?}", pose.shoulder));
    }
    if !close(length(sub(pose.elbow, pose.shoulder)), UPPER) || !close(length(sub(pose.wrist, pose.elbow)), FORE) {
        return Err("the arm has another length".to_owned());
    }
    if !angles(&body.rotation, side, &pose).into_iter().any(|a| within(a, [-1e-4; 4])) {
        return Err(format!("no joint angles: {:?}", angles(&body.rotation, side, &pose)));
    }
    let contacts = twin.contacts(&at, side, &pose);
    let same = contacts.iter().any(|(touch, forces)| {
        (touch.region, touch.link.as_str()) == (told.1, told.2)
            && same_forces(hazard, forces)
            && length(sub(touch.point, place)) < 1e-5
    });
    if same { Ok(()) } else { Err(format!("{}, enumeration {contacts:?}", program())) }
}

/// The shortest sequence of a hazard: the page tells of its time, and of the force that decides.
fn shortest(twin: &mut Twin, hazard: &Value) -> Result<(), String> {
    let shortest = &hazard["shortest"];
    let at = instant(twin, &shortest["actions"], number(&shortest["time_s"]))?;
    let force = number(&shortest["force_n"]);
    match at.body {
        Some(hit) if hazard["arm"].is_null() => {
            let same = hit.region == text(&hazard["body_region"]) && hit.link == text(&hazard["robot_link"]);
            let same = same && close(force, hit.forces.decides);
            if same { Ok(()) } else { Err(format!("force {force}, enumeration {hit:?}")) }
        }
        Some(hit) => Err(format!("the body is hit there: {hit:?}")),
        None if hazard["arm"].is_null() => Err("head, trunk and legs are safe there".to_owned()),
        None if at.arms == Verdict::None => Err("no pose of an arm is above the limit there".to_owned()),
        None => Ok(()),
    }
}

fn gantry(cell: &Gantry) -> Both {
    let dir = tempfile::tempdir().unwrap();
    both(&cell.write(dir.path()))
}

/// Whether there is a hazard of this class, region and link.
fn has(hazards: &[String], one: &str) -> bool {
    hazards.iter().any(|hazard| hazard == one)
}

/// The first unsafe contact of head, trunk or legs in a sequence, by the enumeration.
fn first_hit(cell: &Gantry, actions: &[&str]) -> Option<Hit> {
    let dir = tempfile::tempdir().unwrap();
    let mut twin = Twin::new(Cell::read(&cell.write(dir.path())));
    let actions: Vec<String> = actions.iter().map(|&action| action.to_owned()).collect();
    twin.follow(&actions, usize::MAX).into_iter().find_map(|instant| instant.body)
}

fn example(name: &str, changes: &[(&str, &str)]) -> Both {
    let dir = examples();
    both(&cells::example(dir.path(), name, changes))
}

#[test]
fn a_robot_at_head_height() {
    let found = example(
        "head-collision",
        &[(
            "start = { xy_m = [0.2, -1.9], heading_deg = 90 }",
            "start = { xy_m = [0.2, -0.7], heading_deg = 90 }\n[search]\nactions = 3",
        )],
    );
    found.agree();
    assert_eq!(found.twin.certain, found.twin.at_most);
    assert!(found.twin.certain > 0 && found.arms.is_empty(), "{found:?}");
}

#[test]
fn a_slow_link_in_the_trunk_hides_no_faster_one_at_the_thighs() {
    let found = gantry(&cells::slow_and_fast_at_the_body());
    found.agree();
    assert_eq!(found.twin.certain, found.twin.at_most);
}

#[test]
fn a_heavy_workpiece_and_a_forearm_at_the_thigh() {
    let found = example(
        "heavy-workpiece",
        &[(
            "start = { xy_m = [1.6, -1.2], heading_deg = 180 }",
            "start = { xy_m = [0, -0.25], heading_deg = 0 }\nbegins_s = [0.8]\n[parameters]\n\"plc.v_limit\" = 0.4368\n[search]\nactions = 2",
        )],
    );
    found.agree();
}

/// A robot that passes: who turns beside it, or behind it, is hit by its own speed only; who walks into what is slow is hit by
/// the speed of approach only.
#[test]
fn legs_that_a_robot_comes_to_and_draws_back_from() {
    let absolute = cells::comes_and_draws_back();
    let approach = Gantry { approach: true, ..cells::comes_and_draws_back() };
    let hit = |cell: &Gantry, actions: &[&str]| first_hit(cell, actions).map(|hit| hit.link);
    let turns = ["forward/upright", "left90/upright"];
    assert_eq!(hit(&absolute, &turns).as_deref(), Some("fast"));
    assert_eq!(hit(&approach, &turns), None);
    let walks_on = ["right90/upright"];
    assert_eq!(hit(&absolute, &walks_on), None);
    assert_eq!(hit(&approach, &walks_on).as_deref(), Some("slow"));
    let [absolute, approach] = [absolute, approach].map(|cell| gantry(&cell));
    for found in [&absolute, &approach] {
        found.agree();
        assert_eq!(found.twin.certain, found.twin.at_most);
        assert!(found.twin.certain > 0 && found.arms.is_empty(), "{found:?}");
        assert!(has(&found.body, "force lower_leg fast"), "{found:?}");
    }
    assert!(!has(&absolute.body, "force lower_leg slow"), "{absolute:?}");
    assert!(has(&approach.body, "force lower_leg slow"), "{approach:?}");
    assert_ne!(absolute.program, approach.program);
}

/// A gripper that goes down, away from a face above it: too fast for a face by its own speed. By the speed of approach it is
/// a contact of a moving robot with the head still, and who walks beside it is hit at hands and arms.
#[test]
fn a_robot_that_draws_back_from_a_face() {
    if !sample::is_turn(0, 2) {
        return;
    }
    let [absolute, approach] = ["", "[criteria]\ntransient_force = \"approach\"\n"].map(|criterion| {
        let start = "start = { xy_m = [0.3, -0.32], heading_deg = 90 }\nbegins_s = [3.9]\n[search]\nactions = 2\n";
        example(
            "head-collision",
            &[("start = { xy_m = [0.2, -1.9], heading_deg = 90 }", format!("{start}{criterion}").as_str())],
        )
    });
    absolute.agree();
    approach.agree();
    assert!(has(&absolute.body, "force face gripper"), "{absolute:?}");
    assert!(has(&approach.body, "head_contact face gripper"), "{approach:?}");
    assert!(absolute.arms.is_empty() && !approach.arms.is_empty(), "{absolute:?} {approach:?}");
    assert!(approach.twin.certain > absolute.twin.at_most && absolute.twin.certain > 0, "{absolute:?} {approach:?}");
}

#[test]
fn limbs_that_are_hit_while_the_hand_is_within_its_limit() {
    gantry(&cells::too_fast_for_limbs()).agree();
}

/// The same with the speed of approach: a hand is hit by who walks, but bears the robot where the person stands, or was
/// stopped by the wall.
#[test]
fn hands_that_are_walked_into_a_robot() {
    let dir = tempfile::tempdir().unwrap();
    let absolute = scanned(&cells::too_fast_for_limbs().write(dir.path()));
    let found = gantry(&Gantry { approach: true, ..cells::too_fast_for_limbs() });
    found.agree();
    assert!(found.twin.certain > 0 && found.body.is_empty(), "{found:?}");
    assert!(has(&found.arms, "force hand tool"), "{found:?}");
    let hands = absolute["hazards"].as_array().unwrap().iter().filter(|hazard| hazard["body_region"] == "hand");
    assert_eq!(hands.count(), 0);
    assert!(found.program > hazardous(&absolute), "{found:?}");
}

#[test]
fn the_end_of_a_forearm_that_is_hit_beside_the_hand() {
    gantry(&cells::too_fast_for_the_end_of_a_forearm()).agree();
}

#[test]
fn a_fast_link_within_a_slow_one() {
    gantry(&cells::fast_within_slow()).agree();
}

/// A curtain that is muted for too long, or a door that does not latch.
#[test]
fn a_plane_that_the_person_has_passed_before_the_robot_comes() {
    if !sample::is_turn(3, 6) {
        return;
    }
    for cell in sample::some([cells::palletiser(), cells::door_that_does_not_latch()], 2) {
        gantry(&cell).agree();
    }
}

#[test]
fn a_curtain_that_the_fmu_evaluates_itself() {
    if !sample::is_turn(2, 6) {
        return;
    }
    let found = gantry(&cells::curtain_inside());
    found.agree();
    assert!(found.twin.certain > 0 && !found.arms.is_empty(), "{found:?}");
}

/// What an arm meets in a run that the FMU cannot finish is not known: nothing is certified, nothing is fixed.
#[test]
fn a_door_that_an_arm_opens_before_the_controller_is_ready() {
    const LATE: &str = "\"plc.reaction_ms\" = 400\n";
    let dir = tempfile::tempdir().unwrap();
    let ran = |arguments: &[&str]| {
        let output = fmi_hazard(dir.path()).args(arguments).output().unwrap();
        (output.status.code(), String::from_utf8(output.stdout).unwrap())
    };
    let file = cells::behind_a_door(LATE).write(dir.path());
    both(&file).agree();
    let known = scan_json(&dir.path().join("out"))["hazards"].as_array().unwrap().len();
    assert!(known > 1);
    let cell = std::fs::read_to_string(&file).unwrap();
    std::fs::write(
        dir.path().join("early.toml"),
        cell.replace(LATE, &format!("{LATE}\"fault.fails_until_ms\" = 110\n")),
    )
    .unwrap();
    let (code, _) = ran(&["scan", "--no-advice", "early.toml", "--strategy", "exhaustive", "--out", "early"]);
    let scan = scan_json(&dir.path().join("early"));
    let certificate = &scan["certificate"];
    assert_eq!((code, &scan["verdict"], &certificate["hazardous"]), (Some(3), &"fmu_failed".into(), &"0".into()));
    assert_eq!((&certificate["complete"], &certificate["not_evaluated"]), (&false.into(), &"0".into()));
    assert!(text(&certificate["reasons"][0]).contains("in which a plane tells of an arm"), "{certificate}");
    assert!(scan["coverage"]["arm_runs_not_evaluated"].as_u64().unwrap() > 0);
    assert!(text(&scan["faults"][0]["message"]).starts_with("while a plane told of an arm: "), "{}", scan["faults"]);
    let (_, told) = ran(&["replay", "out", "--changed", "early.toml"]);
    assert_eq!(told.matches("   NOT RUN      H-").count(), known, "{told}");
    assert!(told.starts_with(" NOT RUN      C-") && !told.contains("STILL THERE"), "{told}");
    let (_, told) = ran(&["compare", "out", "early"]);
    assert!(told.contains("not found again") && !told.contains("fixed "), "{told}");
}

/// The same hands without the rods meet less.
#[test]
fn rods_that_are_held() {
    if !sample::is_turn(1, 2) {
        return;
    }
    let late = "\"plc.reaction_ms\" = 400\n";
    for cell in [cells::within_reach_of_a_rod(), Gantry { held: 0.25, ..cells::behind_a_door(late) }] {
        let found = gantry(&cell);
        found.agree();
        assert!(found.twin.certain > 0 && has(&found.arms, "force hand tool"), "{found:?}");
        let without = gantry(&Gantry { held: 0.0, ..cell });
        without.agree();
        assert!(without.program < found.twin.certain, "{without:?}");
    }
}

#[test]
fn a_curtain_behind_a_door() {
    if !sample::is_turn(1, 6) {
        return;
    }
    gantry(&cells::curtain_behind_a_door()).agree();
}
