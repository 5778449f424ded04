//! Sets of poses in the search from anywhere against people who are placed in them one by one, by the rules alone: where a set is taken
//! to be settled nobody in it is hit with some millimetres to spare. So it counts how far a set carries a shoulder and an arm,
//! and how deep behind a plane anybody in it may be.

use std::f64::consts::{PI, TAU};

use crate::common::anywhere::cell;
use crate::common::instant::{ANYWHERE, Instant, seen, uniform};
use crate::sample;
use fmi_hazard::geometry::kinematics::Neighbourhood;
use fmi_hazard::geometry::{Cuboid, Solid, Vec3};
use fmi_hazard::human::arm::ArmModel;
use fmi_hazard::human::posture::cut_back;
use fmi_hazard::human::reach::{ArmSegment, ContactScore, ReachQuery, reach};
use fmi_hazard::human::shoulder::is_available;
use fmi_hazard::human::{PlacedBody, PoseBox, Posture, Side};
use fmi_hazard::reachability::{BODY_TOLERANCE_M, ReachabilitySearch as Search, ReachableInstant as AnInstant};
use fmi_hazard::search::Rng;
use fmi_hazard::sim::Coverage;
use fmi_hazard::sim::detection_plane::DetectionPlane;
use fmi_hazard::sim::encounter::{Encounter, Judge, Person};
use fmi_hazard::sim::robot::RobotFrame;
use fmi_hazard::sim::sensors::{SensorTarget, sees};
use fmi_hazard::standards::BodyRegion;

/// The tolerance of arm searches in these cells, m.
const TOLERANCE_M: f64 = 0.005;
/// Arms that get less far than this, or have no more room, are within the tolerance, m.
const SPARE_M: f64 = 2.2 * TOLERANCE_M;
/// Communication steps until the bar points to the south.
const STEPS: usize = 7;
/// Boxes of joint angles after which an arm is taken to touch nothing.
const MOST_BOXES: u32 = 2000;
/// Force over limit of contacts of which every point around is harmful as well.
const CLEARLY: f64 = 1.15;
/// What a hand that was before a plane a step ago gets behind it, m: 2.0 m/s for 20 ms.
const A_STEP_M: f64 = 0.04;

/// What is asked of some sets.
struct Asked<'a> {
    text: String,
    /// What is reported, and how deep behind a plane an arm may be that it has told of, m.
    reading: Option<bool>,
    depths_m: &'a [f64],
    /// Whether whoever a plane tells of was before it until then.
    come_before: bool,
    boxes: usize,
    /// How many of a hundred of them are so small that arms are searched, where one just gets to the bar or does not.
    small: usize,
}

/// How deep behind a plane arms and bodies are by the rules, m; nothing where there is no limit.
struct Depths {
    arm_m: Option<f64>,
    body_m: Option<f64>,
}

/// How hard an arm is hit, as times the limit.
struct Force<'a>(&'a RobotFrame);

impl ContactScore for Force<'_> {
    fn upper_bound(&self, _: ArmSegment, _: usize) -> f64 {
        f64::INFINITY
    }

    fn upper_bound_near(&self, _: ArmSegment, _: usize, _: &Neighbourhood<'_>) -> f64 {
        f64::INFINITY
    }

    fn score(&self, segment: ArmSegment, link: usize, on_link: Vec3) -> f64 {
        let region = match segment {
            ArmSegment::Hand => BodyRegion::Hand,
            ArmSegment::Forearm => BodyRegion::LowerArm,
            ArmSegment::UpperArm | ArmSegment::Elbow => BodyRegion::UpperArm,
        };
        self.0.strike(link).ratio(region, self.0.velocity(link, on_link).length())
    }
}

/// One person, by the rules.
struct One<'a> {
    instant: &'a Instant,
    asked: &'a Asked<'a>,
    curtain: Option<&'a DetectionPlane>,
    obstacles: &'a [Cuboid],
    encounter: &'a Encounter,
    thinner: &'a ArmModel,
}

impl One<'_> {
    /// How deep they are, whose shoulder is there.
    fn depths(&self, at: [f64; 2], shoulder: Vec3, told_m: f64) -> Depths {
        let none = Depths { arm_m: None, body_m: None };
        let (Some(curtain), Some(told)) = (self.curtain, self.asked.reading) else { return none };
        let (link, reach) = (&self.instant.frame.links[0], ArmModel::default().reach());
        let depth = curtain.depth(shoulder);
        if told {
            let is_limited =
                if depth <= 0.0 { curtain.closed.out_of_reach(shoulder, reach, link) } else { self.asked.come_before };
            return Depths { arm_m: is_limited.then_some(told_m), body_m: self.asked.come_before.then_some(told_m) };
        }
        let (height, reach) = self.instant.prepared.cell.body.reach_from_hip(reach);
        let hip = Vec3::new(at[0], at[1], height);
        let leans = curtain.depth(hip) <= 0.0 && curtain.closed.out_of_reach(hip, reach, link);
        Depths { arm_m: (leans && depth > 0.0).then_some(A_STEP_M), body_m: leans.then_some(A_STEP_M) }
    }

    fn body(&self, [x, y]: [f64; 2], heading: f64, posture: Posture) -> PlacedBody {
        let (cell, position) = (&self.instant.prepared.cell, Vec3::new(x, y, 0.0));
        let bend = cut_back(&cell.body, position, heading, posture, self.obstacles);
        cell.body.placed(position, heading, posture, bend)
    }

    /// Whether a plane is clear of them there.
    fn is_clear(&self, at: [f64; 2], heading: f64, posture: Posture) -> bool {
        let bodies = [posture, Posture::Upright].map(|posture| self.body(at, heading, posture));
        let sees = |body| {
            let person = SensorTarget { body: Some(body), ..seen(&self.instant.prepared, at, heading) };
            self.instant.prepared.cell.sensors.iter().any(|sensor| sees(sensor, &person))
        };
        !bodies.into_iter().any(sees)
    }

    /// Whether they are hit at an instant at which an arm is so deep behind a plane that has told.
    fn is_hit(&self, at: [f64; 2], heading: f64, posture: Posture, told_m: f64) -> bool {
        let frame = &self.instant.frame;
        let mut coverage = Coverage::new(1);
        let mut is_met = |at: [f64; 2], heading: f64| {
            let body = self.body(at, heading, posture);
            let limit = self.depths(at, body.shoulder(Side::Left).translation, told_m).body_m;
            let person = Person { body, arms: Vec::new(), velocity: Vec3::ZERO, wrists_m: None };
            let counts = |contact: &fmi_hazard::hazard::Contact| {
                limit.is_none_or(|limit| self.curtain.is_none_or(|c| c.depth(contact.on_robot) <= limit - SPARE_M))
            };
            self.encounter.unsafe_body_contact(&person, frame, counts, &mut coverage).is_some()
        };
        let around = |number: u32| {
            let (sin, cos) = libm::sincos(f64::from(number) * TAU / 12.0);
            [at[0] + BODY_TOLERANCE_M * cos, at[1] + BODY_TOLERANCE_M * sin]
        };
        if is_met(at, heading)
            && (0..12).all(|number| is_met(around(number), heading))
            && [-0.0125, 0.0125].into_iter().all(|turned| is_met(at, heading + turned))
        {
            return true;
        }
        let body = self.body(at, heading, posture);
        Side::BOTH.into_iter().any(|side| {
            let shoulder = body.shoulder(side).translation;
            let far = self.thinner.reach();
            if frame.links[0].point_distance(shoulder).distance > far || !is_available(&body, side, self.obstacles) {
                return false;
            }
            let mut walls = Vec::new();
            if let (Some(curtain), Some(told)) = (self.curtain, self.asked.reading) {
                walls.extend((!told).then(|| wider(&curtain.unbroken())));
                let limit = self.depths(at, shoulder, told_m).arm_m;
                walls.extend(limit.map(|limit| curtain.beyond(limit - SPARE_M)));
            }
            let obstacles: Vec<Cuboid> = self.obstacles.iter().map(wider).chain(walls).collect();
            let query = ReachQuery {
                arm: self.thinner,
                side,
                world_from_shoulder: body.shoulder(side),
                carried_m: 0.0,
                hangs_from: None,
                known: None,
                wrist_within: None,
                links: &frame.links,
                obstacles: &obstacles,
                score: &Force(frame),
                threshold: CLEARLY,
                tolerance_m: TOLERANCE_M,
                enough: CLEARLY,
                work_limit: MOST_BOXES,
                stop: Some(&self.encounter.stop),
            };
            reach(&query).best.is_some()
        })
    }
}

/// With no room where the tolerance leaves none.
fn wider(o: &Cuboid) -> Cuboid {
    Cuboid { half: o.half + Vec3::splat(SPARE_M), ..*o }
}

/// How many sets were settled, and in how many others somebody was hit.
fn look_at_sets(asked: &Asked<'_>) -> (usize, usize) {
    let instant = Instant::of(&asked.text, STEPS);
    let cell = &instant.prepared.cell;
    let search = Search::new(cell, std::iter::once(&*instant.frame), 0.0, instant.prepared.stop()).unwrap();
    let mut history = instant.history(&search, asked.reading, ANYWHERE);
    let once = history.seen[0].clone();
    history.seen = asked.depths_m.iter().map(|depth_m| AnInstant { depth_m: *depth_m, ..once.clone() }).collect();
    let obstacles: Vec<Cuboid> = cell.obstacles.iter().map(|obstacle| obstacle.cuboid).collect();
    let from = cell.beginnings[0].start.xy_m();
    let curtains = DetectionPlane::all(cell, Vec3::new(from[0], from[1], 0.0), &obstacles);
    let arm = ArmModel::default();
    let encounter = Encounter {
        number: 0,
        judge: Judge::Ending,
        clamping: None,
        obstacles: obstacles.clone(),
        arm,
        reach_tolerance_m: TOLERANCE_M,
        worst: false,
        stop: instant.prepared.stop(),
    };
    let thinner = ArmModel {
        hand_radius_m: arm.hand_radius_m - SPARE_M,
        upper_arm_radius_m: arm.upper_arm_radius_m - SPARE_M,
        forearm_radius_m: arm.forearm_radius_m - SPARE_M,
        ..arm
    };
    let (curtain, obstacles) = (curtains.first(), obstacles.as_slice());
    let one = One { instant: &instant, asked, curtain, obstacles, encounter: &encounter, thinner: &thinner };
    let mut rng = Rng::new(3);
    let tip = match &instant.frame.links[0] {
        Solid::Capsule(bar) => bar.b,
        other => panic!("{other:?}"),
    };
    let mut boxes = Vec::new();
    while boxes.len() < asked.boxes {
        let is_small = boxes.len() % 100 < asked.small;
        let size = |rng: &mut Rng, low: f64, high: f64| low * libm::pow(high / low, uniform(rng, 0.0, 1.0));
        let at = PoseBox {
            xy_m: [uniform(&mut rng, -1.3, 1.3), uniform(&mut rng, -1.8, 0.9)],
            half_m: if is_small { size(&mut rng, 0.004, 0.012) } else { size(&mut rng, 0.01, 0.2) },
            heading_rad: uniform(&mut rng, 0.0, TAU),
            half_rad: if is_small { size(&mut rng, 0.002, 0.008) } else { size(&mut rng, 0.05, PI) },
        };
        let posture = Posture::USUAL[rng.below(6)];
        let body = one.body(at.xy_m, at.heading_rad, posture);
        let gap = (body.shoulder(Side::BOTH[rng.below(2)]).translation - tip).length() - 0.05 - arm.reach();
        if !is_small || (-0.01..0.015).contains(&gap) {
            boxes.push((at, posture));
        }
    }
    let mut coverage = Coverage::new(cell.sensors.len());
    let settled = search.settles(&history, &boxes, &mut coverage);
    let mut others = 0;
    for ((at, posture), is_settled) in boxes.iter().zip(&settled) {
        for _ in 0..if *is_settled { 24 } else { 2 } {
            // Mostly at its edges.
            let mut within = |middle: f64, half: f64| middle + half * uniform(&mut rng, -3.0, 3.0).clamp(-0.99, 0.99);
            let xy_m = [within(at.xy_m[0], at.half_m), within(at.xy_m[1], at.half_m)];
            let heading = within(at.heading_rad, at.half_rad);
            // Where they were a step ago.
            let (sin, cos) = libm::sincos(uniform(&mut rng, 0.0, TAU));
            let far = uniform(&mut rng, 0.0, 1.6 * cell.step_s);
            let before = [xy_m[0] + far * cos, xy_m[1] + far * sin];
            let told_m = asked.depths_m[rng.below(asked.depths_m.len())];
            let is_hit = search.has_room(xy_m)
                && (asked.reading != Some(false) || one.is_clear(before, heading, *posture))
                && one.is_hit(xy_m, heading, *posture, told_m);
            assert!(!is_hit || !is_settled, "{xy_m:?} {heading} in {at:?} {posture:?}: {}", asked.text);
            if is_hit {
                others += 1;
                break;
            }
        }
    }
    let count = settled.iter().filter(|settled| **settled).count();
    (count, others)
}

/// The bar with a finer arm search, so that a contact 1 cm deep counts.
fn fine(z: f64, parts: &str) -> String {
    let text = cell(z, parts).replace("to_m = [0.35,", "to_m = [0.6,");
    text.replace("[search]\n", &format!("[search]\nreach_tolerance_m = {TOLERANCE_M}\n"))
}

/// A light curtain at `y`, to `half_m` on both sides.
fn curtain(y: f64, half_m: f64, low: f64, top: f64) -> String {
    format!(
        "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\nzone = {{ line_m = [[-{half_m}, {y}], [{half_m}, {y}]], heights_m = \
         [{low}, {top}] }}\nvariable = \"clear\"\nactive = false\n"
    )
}

/// With floor on which nobody gets behind a plane of 3 m but through it.
fn closed(text: &str) -> String {
    text.replace("[human]\n", "[human]\nfloor_m = [[-1.5, -3.5], [1.5, -3.5], [1.5, 1.0], [-1.5, 1.0]]\n")
}

#[test]
fn sets_that_are_settled_hold_nobody_who_gets_an_arm_to_the_bar() {
    if !sample::is_turn(5, 12) {
        return;
    }
    let wall = "[[obstacle]]\nname = \"wall\"\ncentre_m = [-0.5, -0.7, 1.1]\nsize_m = [1.0, 0.02, 2.2]\n[[obstacle]]\nname = \"low\"\n\
                centre_m = [0.9, -0.7, 0.6]\nsize_m = [1.2, 0.02, 1.2]\n";
    // Those of half as many are the first of all.
    let (boxes, least) = if sample::is_whole() { (400, [40, 10]) } else { (200, [10, 2]) };
    for parts in sample::some(["", wall], 2) {
        let asked = Asked {
            text: fine(0.9, parts),
            reading: None,
            depths_m: &[f64::INFINITY],
            come_before: false,
            boxes,
            small: 75,
        };
        let (settled, others) = look_at_sets(&asked);
        assert!(settled > least[0] && others > least[1], "{settled} {others}");
    }
}

#[test]
fn sets_that_are_settled_hold_nobody_who_is_hit_behind_a_plane_that_tells() {
    if !sample::is_turn(5, 6) {
        return;
    }
    // Whoever stands behind it reaches over it into the plane.
    let barrier = "[[obstacle]]\nname = \"barrier\"\ncentre_m = [0, -0.5, 0.25]\nsize_m = [1.2, 0.58, 0.5]\n";
    let cells = [
        (closed(&fine(0.9, &curtain(-0.8, 1.5, 0.0, 2.2))), true, [0.16, 0.3], (200, 90)),
        (closed(&fine(0.9, &curtain(-0.8, 1.5, 0.0, 1.2))), true, [0.05, 0.1], (1000, 0)),
        (fine(0.9, &format!("{barrier}{}", curtain(-0.8, 0.3, 0.6, 1.4))), false, [0.05, 0.1], (1000, 0)),
        (fine(0.9, &curtain(-0.8, 1.5, 0.0, 2.2)), false, [0.05, 0.1], (1000, 0)),
    ];
    for (text, come_before, depths_m, (boxes, small)) in sample::some(cells, 2) {
        let asked = Asked { text, reading: Some(true), depths_m: &depths_m, come_before, boxes, small };
        let (settled, others) = look_at_sets(&asked);
        assert!(settled > 40 && others > 10, "{settled} {others}");
    }
}

#[test]
fn sets_that_are_settled_hold_nobody_who_is_hit_behind_a_plane_that_is_clear() {
    if !sample::is_turn(4, 6) {
        return;
    }
    for parts in sample::some([curtain(-0.7, 1.5, 0.0, 2.2), curtain(-0.8, 0.3, 0.0, 2.2)], 2) {
        let text = fine(1.15, &parts);
        let asked =
            Asked { text, reading: Some(false), depths_m: &[f64::INFINITY], come_before: false, boxes: 800, small: 0 };
        let (settled, others) = look_at_sets(&asked);
        assert!(settled > 40 && others > 10, "{settled} {others}");
    }
}
