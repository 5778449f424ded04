//! Cubes of space against searches of all that an arm can do, from random shoulders around random walls.

use super::*;
use crate::geometry::segment_cuboid::segment_hits_cuboid;
use crate::geometry::{Capsule, Hull, Pose, rotation_about};
use crate::human::Side;
use crate::human::reach::{ArmSegment, ContactScore, ReachQuery, reach};
use crate::sample;
use crate::search::Rng;
use crate::stop::Stop;

fn uniform(rng: &mut Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
}

fn vector(rng: &mut Rng, size: f64) -> Vec3 {
    Vec3::new(uniform(rng, -size, size), uniform(rng, -size, size), uniform(rng, -size, size))
}

/// Any contact of some parts of an arm counts.
struct Counts([bool; 3]);

impl ContactScore for Counts {
    fn upper_bound(&self, segment: ArmSegment, _: usize) -> f64 {
        let [hand, forearm, upper_arm] = self.0;
        f64::from(u8::from(match segment {
            ArmSegment::Hand => hand,
            ArmSegment::Forearm | ArmSegment::Elbow => forearm,
            ArmSegment::UpperArm => upper_arm,
        }))
    }

    fn upper_bound_near(
        &self,
        segment: ArmSegment,
        link: usize,
        _: &crate::geometry::kinematics::Neighbourhood<'_>,
    ) -> f64 {
        self.upper_bound(segment, link)
    }

    fn score(&self, segment: ArmSegment, link: usize, _: Vec3) -> f64 {
        self.upper_bound(segment, link)
    }
}

/// A corner of two walls with a slot in one of them, turned and moved, and links beyond it.
struct Scene {
    walls: Vec<Cuboid>,
    plane: Vec<Cuboid>,
    links: Vec<Solid>,
    counts: [bool; 3],
}

fn scene(rng: &mut Rng) -> Scene {
    let turned = rotation_about(Vec3::Z, uniform(rng, 0.0, 6.0));
    let slot = uniform(rng, 0.0, 0.25);
    let thick = uniform(rng, 0.002, 0.02);
    let wall = |middle: Vec3, half: Vec3| Cuboid { centre: turned * middle, half, rotation: turned };
    let mut walls = vec![
        wall(Vec3::new(0.0, 1.0, 0.0), Vec3::new(thick, 1.0, 1.0)),
        wall(Vec3::new(0.3, 0.0, 0.0), Vec3::new(0.3, thick, 1.0)),
    ];
    let plane = vec![wall(Vec3::new(1.3 + slot, 0.0, 0.0), Vec3::new(0.7, 0.005, 1.0))];
    if rng.below(2) == 0 {
        let rotation = turned * rotation_about(Vec3::X, uniform(rng, 0.0, 1.0));
        walls.push(Cuboid { centre: turned * Vec3::new(0.7, 0.5, 0.3), half: Vec3::new(0.2, 0.02, 0.1), rotation });
    }
    let links = (0..4).map(|_| {
        let a = turned * Vec3::new(uniform(rng, 0.15, 0.9), uniform(rng, 0.15, 0.7), uniform(rng, -0.4, 0.4));
        Solid::Capsule(Capsule { a, b: a + vector(rng, 0.1), radius: uniform(rng, 0.02, 0.08) })
    });
    let links = links.collect();
    let counts = [rng.below(4) > 0, rng.below(2) == 0, rng.below(2) == 0];
    Scene { walls, plane, links, counts }
}

#[test]
fn where_an_arm_gets_to_a_robot_the_cubes_say_so_and_mostly_only_there() {
    let arm = ArmModel::default();
    let (mut touched, mut from_behind, mut out_of_reach, mut said) = (0, 0, 0, 0);
    let mut boxes = vec![0; 2];
    for number in sample::some(0..25, 5) {
        let mut rng = Rng::new(31 + number);
        let Scene { walls, plane, links, counts } = scene(&mut rng);
        let [hand, forearm, upper_arm] = counts;
        let targets: Vec<Target<'_>> = links.iter().map(|solid| Target { solid, hand, forearm, upper_arm }).collect();
        let cells = ArmCells::new(&arm, &targets, &walls, &plane);
        let obstacles = [walls.clone(), plane].concat();
        for _ in 0..40 {
            let shoulder = vector(&mut rng, 1.0);
            let turned = rotation_about(Vec3::Z, uniform(&mut rng, 0.0, 6.0));
            let side = Side::BOTH[rng.below(2)];
            let look = |known| {
                reach(&ReachQuery {
                    arm: &arm,
                    side,
                    world_from_shoulder: Pose::from_parts(shoulder, turned),
                    carried_m: 0.0,
                    hangs_from: None,
                    known,
                    wrist_within: None,
                    links: &links,
                    obstacles: &obstacles,
                    score: &Counts(counts),
                    threshold: 0.5,
                    tolerance_m: 0.01,
                    enough: 0.5,
                    work_limit: 20_000,
                    stop: None,
                })
            };
            let (outcome, sooner) = (look(None), look(Some(&cells)));
            // What is known of elbows leaves out what is found to be out of reach without it, and nothing else.
            assert!(sooner.boxes <= outcome.boxes, "{shoulder} {walls:?}");
            assert!(outcome.best.is_none_or(|best| sooner.best == Some(best)), "{shoulder} {walls:?}");
            boxes = boxes.iter().zip([outcome.boxes, sooner.boxes]).map(|(all, own)| all + own).collect();
            if outcome.best.is_none() {
                out_of_reach += u32::from(outcome.complete);
                said += u32::from(outcome.complete && !cells.may_touch(shoulder, 0.0));
                continue;
            }
            touched += 1;
            let (moved, by) = (vector(&mut rng, 0.08), 0.08 * 1.75);
            assert!(cells.may_touch(shoulder, 0.0) && cells.may_touch(shoulder + moved, by), "{shoulder} {walls:?}");
            // From wherever nothing is between.
            let from = shoulder + vector(&mut rng, 0.3);
            if walls.iter().any(|o| segment_hits_cuboid(from, shoulder, o)) {
                continue;
            }
            from_behind += 1;
            let hanging = |by: f64, from_by: f64| {
                let moved = [vector(&mut Rng::new(1), by / 1.75), vector(&mut Rng::new(2), from_by / 1.75)];
                cells.may_touch_hanging(shoulder + moved[0], by, (from + moved[1], from_by))
            };
            assert!(hanging(0.0, 0.0) && hanging(0.05, 0.02) && hanging(0.02, 0.1), "{shoulder} from {from} {walls:?}");
        }
    }
    let (met, behind, apart) = if sample::is_whole() { (80, 40, 250) } else { (3, 0, 20) };
    assert!(touched > met && from_behind > behind, "{touched} {from_behind}");
    assert!(if sample::is_whole() { 4 * boxes[1] < 3 * boxes[0] } else { boxes[1] < boxes[0] }, "{boxes:?}");
    // What is left is for joints' limits and for corners of cubes.
    assert!(
        out_of_reach > apart && 10 * said > if sample::is_whole() { 7 } else { 6 } * out_of_reach,
        "{said} of {out_of_reach}"
    );
}

/// A wall across x, and a link beyond it.
fn behind_a_wall() -> (Cuboid, Solid) {
    let wall = Cuboid {
        centre: Vec3::new(0.0, 0.0, 1.0),
        half: Vec3::new(0.01, 2.0, 1.0),
        rotation: rotation_about(Vec3::Z, 0.0),
    };
    let link = Solid::Capsule(Capsule { a: Vec3::new(0.3, -0.2, 1.2), b: Vec3::new(0.3, 0.2, 1.2), radius: 0.05 });
    (wall, link)
}

/// When it has to end, what is not known yet may be: nothing more is worked out.
#[test]
fn little_is_worked_out_once_it_has_to_end() {
    let (wall, link) = behind_a_wall();
    let targets = [Target { solid: &link, hand: true, forearm: true, upper_arm: true }];
    let arm = ArmModel::default();
    let stop = Stop::default();
    let cells = ArmCells::new(&arm, &targets, &[wall], &[]).heeding(&stop);
    let shoulder = Vec3::new(-0.1, 0.0, 1.2);
    assert!(!cells.may_touch(shoulder, 0.05));
    let worked_out = |cells: &ArmCells| {
        let all = cells.known.iter().flatten().flatten().filter_map(OnceLock::get).flat_map(|cubes| cubes.iter());
        all.filter(|cube| cube.load(Ordering::Relaxed) != UNKNOWN).count()
    };
    assert!(worked_out(&cells) > 100);
    stop.ask();
    // What is known stays.
    assert!(!cells.may_touch(shoulder, 0.05));
    let cells = ArmCells::new(&arm, &targets, &[wall], &[]).heeding(&stop);
    assert!(cells.may_touch(shoulder, 0.05));
    assert_eq!(worked_out(&cells), 0);
}

/// Who is on the other side of a wall from the robot, and cannot reach round it, is out of its reach wherever the shoulder is;
/// one that is behind the wall itself is not known to be, unless told where it hangs from.
#[test]
fn a_shoulder_in_a_wall_is_known_by_what_it_hangs_from() {
    let (wall, link) = behind_a_wall();
    let targets = [Target { solid: &link, hand: true, forearm: true, upper_arm: true }];
    let cells = ArmCells::new(&ArmModel::default(), &targets, &[wall], &[]);
    for y in [-0.3, 0.0, 0.2] {
        assert!(!cells.may_touch(Vec3::new(-0.1, y, 1.2), 0.05));
        for x in [-0.03, 0.0, 0.03] {
            let shoulder = Vec3::new(x, y, 1.2);
            assert!(cells.may_touch(shoulder, 0.05));
            assert!(!cells.may_touch_hanging(shoulder, 0.05, (Vec3::new(-0.2, y, 1.2), 0.1)));
            assert!(cells.may_touch_hanging(shoulder, 0.05, (Vec3::new(0.2, y, 1.2), 0.1)));
            // Nor if it is not known on which side that is.
            assert!(cells.may_touch_hanging(shoulder, 0.05, (Vec3::new(-0.05, y, 1.2), 0.1)));
        }
    }
}

/// Spheres around a plane along a hall hold most of the hall: cubes there would take gigabytes.
#[test]
fn what_is_long_is_looked_at_in_few_cubes() {
    let ends =
        [-1.0, 1.0].into_iter().flat_map(|x| [-1.0, 1.0].into_iter().flat_map(move |y| [-1.0, 1.0].map(|z| (x, y, z))));
    let corners: Vec<Vec3> = ends.map(|(x, y, z)| Vec3::new(100.0 * x, 0.001 * y, 0.9 + 0.9 * z)).collect();
    let solid = Solid::Hull(Hull::from_points(&corners).unwrap());
    let target = Target { solid: &solid, hand: true, forearm: true, upper_arm: true };
    let cells = ArmCells::new(&ArmModel::default(), &[target], &[], &[]);
    assert!(cells.count.iter().product::<usize>() < 3 * MANY, "{:?}", cells.count);
    for (x, y, may) in
        [(0.0, 0.5, true), (-99.0, 0.5, true), (99.0, -0.5, true), (0.0, 1.5, false), (102.0, 0.0, false)]
    {
        assert_eq!(cells.may_touch(Vec3::new(x, y, 1.4), 0.01), may, "{x} {y}");
    }
}
