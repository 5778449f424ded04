//! The search from anywhere at one instant against many poses, one by one, by the rules alone: whoever is hit in a pose, and wherever
//! they are within the tolerance, is in a square that is told, hit or open. So every margin of a box of poses counts, and no walk.

use std::collections::BTreeSet;
use std::f64::consts::TAU;
use std::ops::ControlFlow;

use crate::common::anywhere::{cell, mat};
use crate::common::guarded::guarded;
use crate::common::instant::{ANYWHERE, Instant, seen, slow, uniform};
use crate::common::write;
use crate::sample;
use fmi_hazard::geometry::Vec3;
use fmi_hazard::human::posture::cut_back;
use fmi_hazard::human::shoulder::is_available;
use fmi_hazard::human::{PoseBox, Posture, Side};
use fmi_hazard::reachability::internal_sensors::{ARCS, InternalSensorMap, InternalSensorProbe, arc};
use fmi_hazard::reachability::reading_regions::ReadingRegions;
use fmi_hazard::reachability::{BODY_TOLERANCE_M, Histories, Means, ReachabilitySearch as Search, told_in};
use fmi_hazard::scan::StateChoice;
use fmi_hazard::scan::prepare::prepare;
use fmi_hazard::search::Rng;
use fmi_hazard::sim::Coverage;
use fmi_hazard::sim::answers::Answers;
use fmi_hazard::sim::encounter::{ArmSpace, Encounter, Judge, Person};
use fmi_hazard::sim::sensors::{SensorTarget, sees};

/// What is asked of some poses at an instant.
struct Asked<'a> {
    text: String,
    steps: usize,
    reading: Option<bool>,
    walked: (&'a dyn Fn([f64; 2]) -> bool, f64),
    poses: usize,
    arms: bool,
}

/// How many random poses were harmful, all of them in squares that are told, and how many were in others.
fn look_at_poses(asked: &Asked<'_>) -> (usize, usize) {
    let instant = Instant::of(&asked.text, asked.steps);
    let (prepared, frame) = (&instant.prepared, &instant.frame);
    let cell = &prepared.cell;
    let search = Search::new(cell, std::iter::once(&**frame), 0.0, prepared.stop()).unwrap();
    let history = instant.history(&search, asked.reading, asked.walked);
    let mut coverage = Coverage::new(cell.sensors.len());
    let tell = &mut |_| ControlFlow::Continue(());
    let means = Means { workers: 2, answers: &Answers::default() };
    let found = search.search(
        Histories { at_instants: &history, around: &history, in_parts: &|_, _| Some(history.clone()) },
        5,
        means,
        &mut coverage,
        tell,
    );
    assert!(found.between.is_empty() && !found.stopped);
    let told: BTreeSet<[i64; 2]> =
        found.harms.iter().map(|harm| told_in(harm.xy_m)).chain(found.open.iter().map(|at| told_in(*at))).collect();
    let obstacles: Vec<_> = cell.obstacles.iter().map(|obstacle| obstacle.cuboid).collect();
    let encounter = Encounter {
        number: 0,
        judge: Judge::Ending,
        clamping: None,
        obstacles: obstacles.clone(),
        arm: fmi_hazard::human::arm::ArmModel::default(),
        reach_tolerance_m: cell.search.reach_tolerance_m,
        worst: false,
        stop: prepared.stop(),
    };
    let mut rng = Rng::new(3);
    let (mut harmed, mut elsewhere) = (0, 0);
    for _ in 0..asked.poses {
        let at = [uniform(&mut rng, -1.3, 1.3), uniform(&mut rng, -1.3, 1.3)];
        let (heading, posture) = (uniform(&mut rng, 0.0, TAU), Posture::USUAL[rng.below(6)]);
        // What was read of them a step ago, where they were then.
        let (far, towards) = (uniform(&mut rng, 0.0, 1.6 * cell.step_s), uniform(&mut rng, 0.0, TAU));
        let before = [at[0] + far * libm::cos(towards), at[1] + far * libm::sin(towards)];
        let reads = |sensor: &fmi_hazard::cell::Sensor| {
            let bodies = [posture, Posture::Upright].map(|posture| {
                let position = Vec3::new(before[0], before[1], 0.0);
                let bend = cut_back(&cell.body, position, heading, posture, &obstacles);
                cell.body.placed(position, heading, posture, bend)
            });
            bodies
                .into_iter()
                .any(|body| sees(sensor, &SensorTarget { body: Some(body), ..seen(prepared, before, heading) }))
        };
        // Who stands before a plane that is clear is held by it.
        let is_held = |sensor: &fmi_hazard::cell::Sensor| sensor.zone.walked_through().is_some() && at[1] <= -0.6;
        if !search.has_room(at)
            || history.fields[0].least(at, 0.0) > asked.walked.1
            || cell
                .sensors
                .iter()
                .any(|sensor| asked.reading.is_some_and(|reading| reads(sensor) != reading) || is_held(sensor))
        {
            continue;
        }
        let bend = cut_back(&cell.body, Vec3::new(at[0], at[1], 0.0), heading, posture, &obstacles);
        let body = |dx: f64, dy: f64, turned: f64| {
            cell.body.placed(Vec3::new(at[0] + dx, at[1] + dy, 0.0), heading + turned, posture, bend)
        };
        let mut is_hit = |dx: f64, dy: f64, turned: f64| {
            let person = Person { body: body(dx, dy, turned), arms: Vec::new(), velocity: Vec3::ZERO, wrists_m: None };
            encounter.unsafe_body_contact(&person, frame, |_| true, &mut coverage).is_some()
        };
        let by = BODY_TOLERANCE_M;
        let around = |number: u32| libm::sincos(f64::from(number) * TAU / 12.0);
        let mut is_harmed = is_hit(0.0, 0.0, 0.0)
            && (0..12).all(|number| is_hit(by * around(number).0, by * around(number).1, 0.0))
            && [-by / 0.8, by / 0.8].into_iter().all(|turned| is_hit(0.0, 0.0, turned));
        if asked.arms && !told.contains(&told_in(at)) {
            let person = body(0.0, 0.0, 0.0);
            let arms = Side::BOTH.into_iter().filter(|side| is_available(&person, *side, &obstacles)).collect();
            let person = Person { body: person, arms, velocity: Vec3::ZERO, wrists_m: None };
            let space = ArmSpace { walls: &[], links: None };
            let contact = encounter.unsafe_arm_contact(&person, frame, &space, &mut coverage);
            is_harmed |= contact.is_some_and(|(contact, _)| contact.distance_m < -2.0 * cell.search.reach_tolerance_m);
        }
        let pose = PoseBox::point(at, heading);
        assert!(!is_harmed || told.contains(&told_in(at)), "{pose:?} {posture:?}, read at {before:?}: {}", asked.text);
        harmed += usize::from(is_harmed);
        elsewhere += usize::from(!told.contains(&told_in(at)));
    }
    (harmed, elsewhere)
}

/// Behind a closed fence, 3 m from all that the bar sweeps or 0.3 m, nobody is hit, whatever the size of the floor's cells; through a fence
/// that lacks a panel somebody is.
#[test]
fn a_closed_fence_keeps_everybody_out_on_cells_of_any_size() {
    if !sample::is_turn(3, 4) {
        return;
    }
    // Each side of two panels side by side: nothing gets through between them.
    let fence = |half_m: f64, sides: usize| -> String {
        let panel = |number: usize| {
            let at = if number < 4 { -half_m } else { half_m };
            let along = if number.is_multiple_of(2) { -0.5 * half_m } else { 0.5 * half_m };
            let (centre, size) = ([at, along], [0.02, half_m + 0.02]);
            let turned = |[a, b]: [f64; 2]| if number & 2 == 0 { [a, b] } else { [b, a] };
            let ([x, y], [wide, deep]) = (turned(centre), turned(size));
            format!(
                "[[obstacle]]\nname = \"panel {number}\"\ncentre_m = [{x}, {y}, 1.1]\nsize_m = [{wide}, {deep}, 2.2]\n"
            )
        };
        (0..2 * sides).map(panel).collect()
    };
    for (half_m, sides) in [(3.35, 4), (0.65, 4), (0.65, 3)] {
        let parts = fence(half_m, sides);
        let text = if half_m < 1.0 { slow(1.15, &parts, false) } else { cell(0.9, &parts) };
        let text = text.replace("xy_m = [0, -3]", "xy_m = [0, -4]");
        let instant = Instant::of(&text, 30);
        let cell = &instant.prepared.cell;
        for floor_m in [0.1, 0.05, 0.025] {
            let frames = std::iter::once(&*instant.frame);
            let search = Search::on_cells_of(floor_m, cell, frames, 0.0, instant.prepared.stop()).unwrap();
            let history = instant.history(&search, None, ANYWHERE);
            let means = Means { workers: 2, answers: &Answers::default() };
            let tell = &mut |_| ControlFlow::Continue(());
            let found = search.search(
                Histories { at_instants: &history, around: &history, in_parts: &|_, _| Some(history.clone()) },
                5,
                means,
                &mut Coverage::new(0),
                tell,
            );
            let is_met = !found.harms.is_empty() || !found.open.is_empty() || !found.between.is_empty();
            assert_eq!(is_met, sides < 4, "{half_m} m, cells of {floor_m} m: {found:?}");
        }
    }
}

#[test]
fn whoever_bends_and_is_hit_is_in_a_square_that_is_told() {
    if !sample::is_turn(2, 6) {
        return;
    }
    // A beam that stops heads, and a pillar beside.
    let beam = "[[obstacle]]\nname = \"beam\"\ncentre_m = [0, 0.72, 1.5]\nsize_m = [1.0, 0.04, 0.5]\n[[obstacle]]\nname = \"pillar\"\n\
                centre_m = [-0.6, -0.5, 1.1]\nsize_m = [0.1, 0.1, 2.2]\n";
    let curtain = "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\nzone = { line_m = [[-0.9, -0.6], [0.9, -0.6]], heights_m = \
                   [0, 2.2] }\nvariable = \"clear\"\nactive = false\n";
    for (parts, reading) in [(beam, None), (curtain, Some(false))] {
        let text = slow(1.15, parts, true);
        let asked = Asked { text, steps: 30, reading, walked: ANYWHERE, poses: 40_000, arms: false };
        let (harmed, elsewhere) = look_at_poses(&asked);
        assert!(harmed > 200 && elsewhere > 1000, "{harmed} {elsewhere}");
    }
}

#[test]
fn whoever_reaches_past_a_wall_and_is_hit_is_in_a_square_that_is_told() {
    if !sample::is_turn(1, 6) {
        return;
    }
    let wall = "[[obstacle]]\nname = \"wall\"\ncentre_m = [-0.5, -0.45, 1.1]\nsize_m = [1.6, 0.02, 2.2]\n[[obstacle]]\nname = \"low\"\n\
                centre_m = [0.9, -0.45, 0.6]\nsize_m = [1.2, 0.02, 1.2]\n";
    let south: &dyn Fn([f64; 2]) -> bool = &|[x, y]| y < -0.6 && x < -0.2;
    let text = cell(0.9, wall).replace("[human]\n", "[human]\nbend_lateral_deg = 0\n");
    let asked = Asked { text, steps: 30, reading: None, walked: (south, 0.1), poses: 12_000, arms: true };
    let (_, elsewhere) = look_at_poses(&asked);
    assert!(elsewhere > 200, "{elsewhere}");
}

/// Two mats with a gap of 2 cm between them, askew: whoever looks across it, within 6 degrees, has both feet in it. No middle of an arc of
/// headings is so near, and few middles of cells of the floor.
#[test]
fn a_gap_of_2_cm_that_few_headings_show_is_floor_on_which_nobody_is_seen() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let heading = 0.5 * TAU / f64::from(ARCS);
    let (sin, cos) = libm::sincos(heading);
    // So far along the heading, and to the left of it: along the gap.
    let at = |along: f64, left: f64| [along * cos - left * sin, along * sin + left * cos];
    let (half, step) = if sample::is_whole() { (1.5, 0.014) } else { (0.8, 0.007) };
    let polygon = |from: f64, to: f64| format!("{:?}", [at(from, -half), at(to, -half), at(to, half), at(from, half)]);
    let side = |name: &str, from: f64, to: f64| {
        let zone = format!("zone = {{ polygon_m = {} }}\n", polygon(from, to));
        let mat = mat(name, "clear", [0.0; 4]);
        format!("{}{zone}", mat.split("zone = ").next().unwrap())
    };
    let text = cell(0.45, &[side("left", -half, -0.01), side("right", 0.01, half)].concat());
    let dir = guarded();
    let prepared = prepare(&write(dir.path(), "cell.toml", &text), None).unwrap();
    let search = Search::new(&prepared.cell, std::iter::empty(), 0.0, prepared.stop()).unwrap();
    let zones = ReadingRegions::new(&search, &[false; 2], &[true; 2], (0.032, 30), 0).unwrap();
    let (floor, unseen, _) = search.ground();
    for number in 0..200 {
        let place = at(0.0, f64::from(number - 100) * step);
        assert!(search.is_possible(place, heading, Posture::Upright, &[Some(false); 2]), "{place:?}");
        assert!(floor.within(place, 0.0).any(|cell| unseen[cell]), "{place:?}");
        assert!(zones.origin().least(place, 0.0) <= 0.0 && zones.ways[0].field.least(place, 0.0) <= 0.0, "{place:?}");
        let beside = at(0.2, f64::from(number - 100) * step);
        assert!(!floor.within(beside, 0.0).any(|cell| unseen[cell]), "{beside:?}");
    }
}

/// Sensors inside an FMU, one that tells late of a circle and two with rectangles that look at feet: what is reported of random people is
/// among what is told of their cell and arc.
#[test]
fn what_an_fmu_reports_of_people_is_among_what_is_told() {
    let examples = crate::common::examples();
    let dir = guarded();
    let field = "[[sensor]]\nname = \"field\"\nkind = \"reported\"\nvariable = \"demand.counts\"\nactive = true\n[pose]\nx = \
                 \"person.x\"\ny = \"person.y\"\n";
    let late = format!("{}\"field.radius\" = 0.7\n\"filter.tau\" = 0.1\n", cell(0.9, field));
    let paths = [write(dir.path(), "cell.toml", &late), examples.path().join("two-scanners/fixed.toml")];
    for (path, low) in paths.iter().zip([[0.3, 0.3], [-1.9, -1.9]]) {
        let prepared = prepare(path, None).unwrap();
        let cell = &prepared.cell;
        let floor =
            fmi_hazard::human::Floor::new(&cell.body, &[], (low, low.map(|at| at + 0.4)), 0.025, &prepared.stop())
                .unwrap();
        let plant = prepared.plant(StateChoice::Auto);
        let mut asking = InternalSensorProbe::new(plant, cell, &prepared.binding, 15, true).unwrap();
        assert!(asking.settle(&floor, &mut || true).unwrap());
        let told = InternalSensorMap::ask(&mut asking, &floor, &mut |_| ControlFlow::Continue(())).unwrap().unwrap();
        let mut patient =
            InternalSensorProbe::new(prepared.plant(StateChoice::Auto), cell, &prepared.binding, 15, true).unwrap();
        let (mut rng, mut kinds) = (Rng::new(19), BTreeSet::new());
        for _ in 0..1500 {
            let at = low.map(|low| uniform(&mut rng, low, low + 0.4));
            let heading = uniform(&mut rng, 0.0, TAU);
            let reported = patient.reports((at, heading)).unwrap().pop().unwrap();
            let is_told = |cell: usize| told.kinds(cell, arc(heading)).any(|kind| *kind == *reported);
            assert!(floor.within(at, 0.0).any(is_told), "{reported:?} at {at:?} {heading}");
            kinds.insert(reported);
        }
        assert!(kinds.len() > 1, "{kinds:?}");
    }
}
