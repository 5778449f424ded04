//! Clamping against a second implementation of the page `docs/src/howto/criteria.md`, by dense samples of every link's surface
//! and of the arms (`common/twin/clamp.rs`), in some thousand random scenes.
//!
//! Each scene is made around a point that may well be clamped, with all that decides on both sides of its limit: the gap, the
//! speed, which way the surfaces face, what is met and how it moves. Then
//!
//! - what is *certain* to the samples, which is that all points within the tolerance are clamped alike, the program tells;
//! - what the program tells is true to the letter: point, direction, gap, speed, force, limit, and that the part is there.
#![allow(clippy::print_stdout, reason = "figures of both for who reads the log")]

use crate::common::twin;

use std::collections::BTreeMap;

use crate::common::examples;
use crate::sample;
use fmi_hazard::hazard::Class;
use fmi_hazard::sim::world::Hit;
use twin::arm::{self, FORE, Pose, UPPER};
use twin::body::{Body, shoulder};
use twin::clamp::{Along, Arms, BOTH, Block, Clamped, IN_ITS_NEIGHBOUR, Met, Moving, Scene, Told, bearable};
use twin::clamp_asked::Asked;
use twin::clamp_scenes::{self, Case, Dice};
use twin::force::{FACE, SKULL, THROAT};
use twin::geometry::{UNIT, V3, about, length, sub};

/// `[search] reach_tolerance_m`.
const TOLERANCE: f64 = 0.02;
/// The program's rays to links end so near to them, m.
const NEAR: f64 = 1.5e-3;
/// Between samples of a surface, m.
const STEP: f64 = 0.004;

/// Somebody at the origin who looks along x.
fn upright() -> Body {
    Body::posed([0.0, 0.0], &UNIT, UNIT, 16)
}

fn boxed(low: V3, high: V3) -> Block {
    let mid = |i: usize| 0.5 * (low[i] + high[i]);
    let half = |i: usize| 0.5 * (high[i] - low[i]);
    Block { centre: [0, 1, 2].map(mid), half: [0, 1, 2].map(half), rotation: UNIT }
}

fn link(core: [V3; 2], radius: f64, velocity: V3) -> Moving {
    Moving { core, radius, origin: core[0], velocity, spin: [0.0; 3], carrier: 0, m_r: 20.0 }
}

/// Bare and certain clampings of head, trunk and legs, along the velocity and along the normal.
fn of_body(scene: &Scene, body: &Body) -> [(Option<Clamped>, Option<Clamped>); 2] {
    BOTH.map(|along| scene.body(body, along, STEP, TOLERANCE))
}

fn of_arms(scene: &Scene, body: &Body, region: &'static str, by: f64) -> Option<(Clamped, Pose)> {
    BOTH.into_iter().find_map(|along| {
        let targets = scene.targets(region, along, STEP, by);
        [1.0, -1.0].into_iter().filter(|side| scene.available(body, *side)).find_map(|side| {
            let arms = Arms { scene, body, side, by };
            arms.tried(&targets)
        })
    })
}

/// A ball of 0.12 m that comes down to a table.
fn press(above: f64, speed: f64) -> Scene {
    let centre = [0.45, 0.0, 0.8 + above + 0.06];
    Scene {
        links: vec![link([centre, centre], 0.06, [0.0, 0.0, -speed])],
        blocks: vec![boxed([0.25, -1.0, 0.75], [1.0, 1.0, 0.8])],
        travel: 0.0,
    }
}

/// 135 N are at 0.11 m/s of 20 kg.
#[test]
fn by_hand_a_hand_under_a_ball_that_comes_down_on_a_table() {
    let body = upright();
    assert!((bearable("hand", 20.0) - 0.1102).abs() < 1e-4);
    let (found, pose) = of_arms(&press(0.08, 0.3), &body, "hand", TOLERANCE).expect("clamped");
    assert!(found.push.met == Met::Block(0) && found.push.gap < 0.1 && found.push.closing > 0.11, "{found:?}");
    assert!(
        length(sub(pose.wrist, found.at)) <= 0.23 - TOLERANCE && length(sub(pose.elbow, pose.shoulder)) <= UPPER + 1e-9
    );
    for (above, speed) in [(0.105, 0.3), (0.08, 0.105), (0.08, -0.3)] {
        assert!(of_arms(&press(above, speed), &body, "hand", 0.0).is_none(), "{above} m, {speed} m/s");
    }
    // What the robot travels on is added to the gap.
    let further = Scene { travel: 0.03, ..press(0.105, 0.3) };
    assert!(of_arms(&further, &body, "hand", TOLERANCE).is_some());
    // Nobody reaches under a hood.
    let mut hooded = press(0.08, 0.3);
    hooded.blocks.push(boxed([0.3, -0.3, 0.8], [0.32, 0.3, 1.1]));
    hooded.blocks.push(boxed([0.6, -0.3, 0.8], [0.62, 0.3, 1.1]));
    hooded.blocks.push(boxed([0.3, -0.3, 0.8], [0.62, -0.28, 1.1]));
    hooded.blocks.push(boxed([0.3, 0.28, 0.8], [0.62, 0.3, 1.1]));
    hooded.blocks.push(boxed([0.3, -0.3, 1.1], [0.62, 0.3, 1.12]));
    assert!(of_arms(&hooded, &body, "hand", 0.0).is_none());
}

/// 140 N are at 0.198 m/s of 20 kg.
#[test]
fn by_hand_a_chest_before_a_wall() {
    let body = upright();
    let scene = |behind: f64, speed: f64| Scene {
        links: vec![link([[0.2, -0.1, 1.32], [0.2, 0.1, 1.32]], 0.1, [-speed, 0.0, 0.0])],
        blocks: vec![boxed([0.1 - behind - 0.2, -1.0, 0.0], [0.1 - behind, 1.0, 2.0])],
        travel: 0.0,
    };
    assert!((bearable("chest", 20.0) - 0.19799).abs() < 1e-5);
    for (bare, certain) in of_body(&scene(0.4, 0.3), &body) {
        let certain = certain.expect("clamped");
        assert!(certain.region == "chest" && certain.push.met == Met::Block(0), "{bare:?} {certain:?}");
    }
    for (behind, speed) in [(0.6, 0.3), (0.502, 0.3), (0.4, 0.19), (0.4, -0.3)] {
        let found = of_body(&scene(behind, speed), &body);
        assert!(found.iter().all(|(bare, _)| bare.is_none()), "{behind} m, {speed} m/s: {found:?}");
        let possible = BOTH.into_iter().find_map(|along| scene(behind, speed).body_possible(&body, along, STEP));
        assert!(possible.is_none() || behind < 0.52 && speed > 0.18, "{possible:?}");
    }
    assert!(of_body(&scene(0.495, 0.3), &body)[0].1.is_some());
}

/// A link that glides along a table closes on it nowhere but with the front that faces down to it, and there by the part of the
/// velocity along its normal.
#[test]
fn by_hand_a_link_that_glides_along_a_table() {
    let glide = |speed: f64| Scene {
        links: vec![link([[0.0, -0.2, 0.95], [0.0, 0.2, 0.95]], 0.05, [speed, 0.0, 0.0])],
        blocks: vec![boxed([-1.0, -1.0, 0.75], [1.0, 1.0, 0.85])],
        travel: 0.0,
    };
    assert!(glide(1.0).targets("hand", Along::Velocity, STEP, 0.0).is_empty());
    let front = glide(1.0).targets("hand", Along::Normal, STEP, 0.0);
    assert!(!front.is_empty());
    for target in &front {
        assert!(target.normal[0] > 0.0 && -target.normal[2] >= 0.5, "{target:?}");
        assert!((target.push.closing - target.normal[0]).abs() < 1e-9);
    }
    // Half of the gap is left under it, so of the front only what is steeper than 48 degrees is near enough: 0.05 sin + 0.05 +
    // 0.05 (1 - sin) = 0.1 sin at most.
    assert!(glide(0.1).targets("hand", Along::Normal, STEP, 0.0).is_empty());
}

/// Two links on a hinge, one of which turns towards the other.
#[test]
fn by_hand_a_wedge_of_two_links() {
    let wedge = |spin: f64, carrier: usize| {
        let hinge = [0.35, 0.0, 1.4];
        let lower = link([hinge, [0.35, 0.4, 1.4]], 0.03, [0.0; 3]);
        let opened = about(UNIT[0], 0.5);
        let end = twin::geometry::add(hinge, twin::geometry::turned(&opened, [0.0, 0.4, 0.0]));
        let mut upper = link([hinge, end], 0.03, [0.0; 3]);
        (upper.spin, upper.carrier) = ([spin, 0.0, 0.0], carrier);
        Scene { links: vec![lower, upper], blocks: Vec::new(), travel: 0.0 }
    };
    let body = upright();
    for region in ["hand", "lower_arm"] {
        let (found, _) = of_arms(&wedge(-2.0, 1), &body, region, 0.01).expect("clamped");
        assert_eq!((found.link, found.push.met), (1, Met::Link(0)));
        assert!(of_arms(&wedge(2.0, 1), &body, region, 0.0).is_none(), "it opens");
        assert!(of_arms(&wedge(-2.0, 0), &body, region, 0.0).is_none(), "both are carried by one joint");
    }
}

/// What the program is known to tell though it is not so, both on the safe side and rare: of a point within another link that the
/// same joint carries, where nobody can be; and of a slow link, what comes fast from behind a box that is in between.
const NEIGHBOUR: &str = "told, but not so: within another link of the same joint";
const BEHIND: &str = "told, but not so: something else is in between";

/// What came out over many scenes.
#[derive(Debug, Default)]
struct Tally {
    scenes: u32,
    /// By what was certain, by what only just holds, and by what the program told.
    counts: BTreeMap<String, u32>,
    missed: Vec<String>,
    untrue: Vec<String>,
}

impl Tally {
    fn count(&mut self, what: impl Into<String>) {
        *self.counts.entry(what.into()).or_default() += 1;
    }

    fn of(&self, what: &str) -> u32 {
        self.counts.get(what).copied().unwrap_or_default()
    }

    fn print(&self) {
        println!("{} scenes", self.scenes);
        for (what, count) in &self.counts {
            println!("{count:6} {what}");
        }
        for (list, what) in [(&self.missed, "missed"), (&self.untrue, "untrue")] {
            println!("{} {what}", list.len());
            list.iter().take(20).for_each(|one| println!("  {one}"));
        }
    }

    fn agree(&self) {
        self.print();
        let told: u32 = self.counts.iter().filter(|(what, _)| what.starts_with("told: along")).map(|(_, n)| n).sum();
        for known in [NEIGHBOUR, BEHIND] {
            assert!(20 * self.of(known) <= told, "{known}: {} of {told}", self.of(known));
        }
        assert!(
            self.missed.is_empty() && self.untrue.is_empty(),
            "{} missed, {} untrue",
            self.missed.len(),
            self.untrue.len()
        );
    }

    /// What the program told, held against the rules.
    fn told(&mut self, number: u32, case: &Case, hit: &Hit, body: &Body) {
        match truth(case, hit, body, NEAR) {
            Ok((region, along, met, first)) => {
                if truth(case, hit, body, 0.0).is_err() {
                    self.count("told: true to a millimetre only");
                }
                if !first {
                    self.count(BEHIND);
                }
                self.count(format!("told: {region}"));
                self.count(format!("told: along the {along:?}"));
                self.count(format!("told: against {}", kind(met)));
            }
            Err(why) if why == IN_ITS_NEIGHBOUR => self.count(NEIGHBOUR),
            Err(why) => self.untrue.push(format!("scene {number}: {why}; {:?}", hit.contact)),
        }
    }
}

fn kind(met: Met) -> &'static str {
    match met {
        Met::Floor => "the floor",
        Met::Block(_) => "a box",
        Met::Link(3) => "the other robot",
        Met::Link(_) => "another link",
    }
}

fn region(hit: &Hit) -> &'static str {
    match hit.contact.region.id() {
        "skull_forehead" => SKULL,
        "face" => FACE,
        "neck_front" => THROAT,
        "neck" => "neck",
        "back_shoulders" => "back_shoulders",
        "chest" => "chest",
        "abdomen" => "abdomen",
        "pelvis" => "pelvis",
        "upper_arm" => "upper_arm",
        "lower_arm" => "lower_arm",
        "hand" => "hand",
        "thigh" => "thigh",
        "lower_leg" => "lower_leg",
        other => panic!("no region: {other}"),
    }
}

fn truth(case: &Case, hit: &Hit, body: &Body, near: f64) -> Result<(&'static str, Along, Met, bool), String> {
    if hit.contact.class() != Some(Class::Clamping) {
        return Err(format!("of class {:?}", hit.contact.class()));
    }
    let clamp = hit.contact.clamp.ok_or("nothing is told of the clamping")?;
    let told = Told {
        region: region(hit),
        link: hit.contact.link,
        at: clamp.at.to_array(),
        toward: clamp.toward.to_array(),
        gap: clamp.gap_m,
        closing: clamp.closing_m_s,
        force: clamp.force_n,
        limit: clamp.limit_n,
    };
    let arm = hit.arm.map(|arm| {
        let [shoulder, elbow, wrist] = [arm.shoulder, arm.elbow, arm.wrist].map(|p| p.to_array());
        (if arm.left { 1.0 } else { -1.0 }, Pose { shoulder, elbow, wrist })
    });
    if let Some((side, pose)) = arm {
        possible(&case.scene, body, side, &pose)?;
    }
    let (along, met, first) = case.scene.is_true(body, &told, arm.as_ref().map(|(_, pose)| pose), near)?;
    Ok((told.region, along, met, first))
}

/// Whether an arm may be so.
fn possible(scene: &Scene, body: &Body, side: f64, pose: &Pose) -> Result<(), String> {
    let joint = body.in_world(shoulder(side));
    let lengths = [sub(joint, pose.shoulder), sub(pose.elbow, pose.shoulder), sub(pose.wrist, pose.elbow)].map(length);
    if lengths.into_iter().zip([0.0, UPPER, FORE]).any(|(a, b)| (a - b).abs() > 1e-6) {
        return Err(format!("an arm of other lengths: {lengths:?}"));
    }
    if !arm::angles(&body.rotation, side, pose).into_iter().any(|a| arm::within(a, [-1e-4; 4])) {
        return Err("no joint angles".to_owned());
    }
    if !scene.available(body, side) || scene.clearance(pose) < -1e-9 {
        return Err(format!("not free of obstacles: {} m", scene.clearance(pose)));
    }
    Ok(())
}

const ALONE: &str = "transient_force = false\nclamping = true";
const TRAVELS: &str = "transient_force = false\nclamping = { travel_after_contact_m = 0.06 }";
const TRAVEL: f64 = 0.06;

#[test]
fn head_trunk_and_legs_are_clamped_where_samples_say_so() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let dir = examples();
    let folder = dir.path().join("head-collision");
    let asked = [(Asked::new(&folder, ALONE), 0.0), (Asked::new(&folder, TRAVELS), TRAVEL)];
    let (mut dice, mut tally) = (Dice::new(20), Tally::default());
    for number in 0..1500 {
        let (asked, travel) = &asked[usize::from(number % 4 == 3)];
        let case = clamp_scenes::at_body(&mut dice, *travel);
        if !sample::takes(number as usize, 3) {
            continue;
        }
        let (hit, body) = asked.says(&case, number % 2 == 0);
        tally.scenes += 1;
        let hit_of_body = hit.as_ref().filter(|hit| hit.arm.is_none());
        if let Some(hit) = &hit {
            tally.told(number, &case, hit, &body);
        }
        let found = of_body(&case.scene, &body);
        let certain: Vec<&Clamped> = found.iter().filter_map(|(_, certain)| certain.as_ref()).collect();
        let bare = found.iter().any(|(bare, _)| bare.is_some());
        let possible = |along| case.scene.body_possible(&body, along, STEP).is_some();
        let said = if hit_of_body.is_some() { "told" } else { "not told" };
        if certain.is_empty() {
            let possible = bare || BOTH.into_iter().any(possible);
            let word = if bare {
                "just so"
            } else if possible {
                "hardly"
            } else {
                "none"
            };
            tally.count(format!("{word}, {said}"));
            if let (false, Some(hit)) = (possible, hit_of_body) {
                tally.untrue.push(format!("scene {number}: no sample is clamped: {:?}", hit.contact));
            }
            continue;
        }
        tally.count(format!("certain, {said}"));
        for one in &certain {
            tally.count(format!("certain: {}", one.region));
            tally.count(format!("certain: against {}", kind(one.push.met)));
        }
        if let [one] = certain[..] {
            let other = BOTH.into_iter().find(|along| *along != one.along).unwrap();
            if !possible(other) {
                tally.count(format!("certain: only along the {:?}", one.along));
            }
        }
        if hit_of_body.is_none() {
            tally.missed.push(format!("scene {number}: {certain:?}"));
        }
    }
    tally.agree();
    // Both answers are common, and all that decides is among them.
    let least = |cases: u32| if sample::is_whole() { cases } else { cases / 6 };
    assert!(tally.of("certain, told") > least(500) && tally.of("none, not told") > least(200));
    for what in ["against the floor", "against a box", "against another link", "against the other robot"] {
        assert!(tally.of(&format!("certain: {what}")) > 0, "{what}");
    }
    // Of some parts of the body there are hardly ten in all.
    if !sample::is_whole() {
        return;
    }
    for what in [
        "only along the Velocity",
        "only along the Normal",
        "against the floor",
        "against a box",
        "against another link",
        "against the other robot",
        SKULL,
        FACE,
        THROAT,
        "neck",
        "back_shoulders",
        "chest",
        "abdomen",
        "pelvis",
        "thigh",
        "lower_leg",
    ] {
        assert!(tally.of(&format!("certain: {what}")) >= 8, "{what}");
    }
}

#[test]
fn arms_are_clamped_where_samples_of_arms_say_so() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    let folder = dir.path().join("head-collision");
    let asked = [(Asked::new(&folder, ALONE), 0.0), (Asked::new(&folder, TRAVELS), TRAVEL)];
    let (mut dice, mut tally) = (Dice::new(21), Tally::default());
    for number in 0..600 {
        let (asked, travel) = &asked[usize::from(number % 4 == 3)];
        let case = clamp_scenes::at_arm(&mut dice, *travel);
        if !sample::takes(number as usize, 5) {
            continue;
        }
        let (hit, body) = asked.says(&case, number % 2 == 0);
        tally.scenes += 1;
        if let Some(hit) = &hit {
            tally.told(number, &case, hit, &body);
            if hit.arm.is_none() {
                tally.count("of the body");
                continue;
            }
        }
        let regions = ["hand", "lower_arm", "upper_arm"];
        let find = |by: f64| regions.into_iter().filter_map(|r| of_arms(&case.scene, &body, r, by)).collect::<Vec<_>>();
        let certain = find(TOLERANCE);
        let said = if hit.is_some() { "told" } else { "not told" };
        if certain.is_empty() {
            let word = if find(0.0).is_empty() { "none" } else { "just so" };
            tally.count(format!("{word}, {said}"));
            continue;
        }
        tally.count(format!("certain, {said}"));
        for (one, _) in &certain {
            tally.count(format!("certain: {}", one.region));
            tally.count(format!("certain: against {}", kind(one.push.met)));
        }
        if hit.is_none() {
            tally.missed.push(format!("scene {number}: {certain:?}"));
        }
    }
    tally.agree();
    // A fifth of the scenes has a fifth of each, more or less.
    let least = |cases: u32| if sample::is_whole() { cases } else { cases / 10 };
    assert!(tally.of("certain, told") > least(150) && tally.of("none, not told") > least(60));
    for (what, cases) in [("hand", 100), ("lower_arm", 8), ("upper_arm", 8)] {
        assert!(tally.of(&format!("certain: {what}")) >= least(cases).max(1), "{what}");
    }
}

/// With both criteria a state is unsafe that is so by one of them.
#[test]
fn transient_force_and_clamping_together_are_either() {
    let dir = examples();
    let folder = dir.path().join("head-collision");
    let asked = [ALONE, "", "clamping = true"].map(|criteria| Asked::new(&folder, criteria));
    let (mut dice, mut tally) = (Dice::new(22), Tally::default());
    for number in 0..400 {
        let case = clamp_scenes::at_body(&mut dice, 0.0);
        let [clamped, struck, both] = asked.each_ref().map(|asked| {
            let (hit, body) = asked.says(&case, true);
            (hit.filter(|hit| hit.arm.is_none()), body)
        });
        let body = both.1;
        let told = [&clamped.0, &struck.0, &both.0].map(|hit| hit.is_some());
        tally.count(format!("clamped {}, struck {}, either {}", told[0], told[1], told[2]));
        if told[2] != (told[0] || told[1]) {
            tally.missed.push(format!("scene {number}: {told:?}"));
        }
        if let Some(hit) = both.0.filter(|hit| hit.contact.class() == Some(Class::Clamping)) {
            tally.told(number, &case, &hit, &body);
        }
    }
    tally.agree();
    assert!(tally.of("clamped true, struck false, either true") > 30);
    assert!(tally.of("clamped false, struck true, either true") > 30);
}
