//! The branch and bound against a plain grid sampler and against parry, in random scenes and at fences.

use std::sync::Arc;

use parry3d_f64::{query, shape};

use super::*;
use crate::geometry::kinematics::Twist;
use crate::geometry::surface::Triangles;
use crate::geometry::test_meshes as meshes;
use crate::geometry::{Mesh, Rotation, Surface, rotation_about};
use crate::human::arm::{ABDUCTION, ELBOW, flexion_range, rotation_range};
use crate::sample;
use crate::search::Rng;

const TOLERANCE: f64 = 0.02;

/// Each link has one score; the hand counts less, as in the force limits.
struct ByLink(Vec<f64>);

impl ContactScore for ByLink {
    fn upper_bound(&self, segment: ArmSegment, link: usize) -> f64 {
        self.0[link] * if segment == ArmSegment::Hand { 0.9 } else { 1.0 }
    }
    fn upper_bound_near(&self, segment: ArmSegment, link: usize, _points: &Neighbourhood<'_>) -> f64 {
        self.upper_bound(segment, link)
    }
    fn score(&self, segment: ArmSegment, link: usize, _on_link: Vec3) -> f64 {
        self.upper_bound(segment, link)
    }
}

struct Scene {
    world_from_shoulder: Pose,
    links: Vec<Solid>,
    obstacles: Vec<Cuboid>,
    score: ByLink,
}

impl Scene {
    fn query<'a>(&'a self, arm: &'a ArmModel, side: Side) -> ReachQuery<'a, ByLink> {
        ReachQuery {
            arm,
            side,
            world_from_shoulder: self.world_from_shoulder,
            carried_m: 0.0,
            hangs_from: None,
            known: None,
            wrist_within: None,
            links: &self.links,
            obstacles: &self.obstacles,
            score: &self.score,
            threshold: 0.0,
            tolerance_m: TOLERANCE,
            enough: f64::INFINITY,
            work_limit: 60_000,
            stop: None,
        }
    }
}

fn uniform(rng: &mut Rng, low: f64, high: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "20 bits")]
    let unit = rng.below(1 << 20) as f64 / f64::from(1 << 20);
    low + (high - low) * unit
}

fn vector(rng: &mut Rng, size: f64) -> Vec3 {
    Vec3::new(uniform(rng, -size, size), uniform(rng, -size, size), uniform(rng, -size, size))
}

/// A robot of seven capsules somewhere around the shoulder, and some boxes.
fn random_scene(rng: &mut Rng, boxes: usize) -> Scene {
    let turn = rotation_about(Vec3::Z, uniform(rng, -3.0, 3.0)) * rotation_about(Vec3::Y, uniform(rng, 0.0, 0.7));
    let middle = vector(rng, 0.8);
    let links = (0..7).map(|_| {
        let a = middle + vector(rng, 0.4);
        Solid::Capsule(Capsule { a, b: a + vector(rng, 0.3), radius: uniform(rng, 0.04, 0.10) })
    });
    let links = links.collect();
    let obstacles = (0..boxes).map(|_| Cuboid {
        centre: vector(rng, 0.9),
        half: Vec3::new(uniform(rng, 0.02, 0.3), uniform(rng, 0.02, 0.3), uniform(rng, 0.02, 0.3)),
        rotation: rotation_about(Vec3::Z, uniform(rng, 0.0, 3.0)),
    });
    let obstacles = obstacles.collect();
    let score = ByLink((0..7).map(|_| uniform(rng, 0.5, 2.0)).collect());
    Scene { world_from_shoulder: Pose::from_parts(Vec3::ZERO, turn), links, obstacles, score }
}

/// A person at a 20 mm panel with an opening (x -0.3..0.3, z 0.8..1.2), the robot behind it.
fn fence_scene(rng: &mut Rng) -> Scene {
    let panel = |x: (f64, f64), z: (f64, f64)| Cuboid {
        centre: Vec3::new(0.5 * (x.0 + x.1), 0.0, 0.5 * (z.0 + z.1)),
        half: Vec3::new(0.5 * (x.1 - x.0), 0.01, 0.5 * (z.1 - z.0)),
        rotation: Rotation::IDENTITY,
    };
    let obstacles = vec![
        panel((-1.5, -0.3), (0.0, 2.0)),
        panel((0.3, 1.5), (0.0, 2.0)),
        panel((-0.3, 0.3), (0.0, 0.8)),
        panel((-0.3, 0.3), (1.2, 2.0)),
    ];
    let shoulder = Vec3::new(uniform(rng, -0.9, 0.9), uniform(rng, -0.5, -0.08), uniform(rng, 1.1, 1.4));
    let heading = rotation_about(Vec3::Z, uniform(rng, 0.8, 2.4));
    let tool = Vec3::new(uniform(rng, -0.3, 0.6), uniform(rng, 0.35, 0.9), uniform(rng, 0.9, 1.1));
    let links = vec![
        Solid::Capsule(Capsule { a: tool, b: tool, radius: 0.08 }),
        Solid::Capsule(Capsule { a: tool, b: tool + Vec3::new(0.0, 0.4, 0.3), radius: 0.06 }),
    ];
    Scene { world_from_shoulder: Pose::from_parts(shoulder, heading), links, obstacles, score: ByLink(vec![1.5, 1.2]) }
}

fn parry_capsule(a: Vec3, b: Vec3, radius: f64) -> shape::Capsule {
    shape::Capsule::new(a, b, radius)
}

/// Signed distance of a capsule and a box by parry; negative when they overlap.
fn parry_clearance(a: Vec3, b: Vec3, radius: f64, o: &Cuboid) -> f64 {
    let pose = Pose::from_parts(o.centre, o.rotation);
    let contact =
        query::contact(&Pose::IDENTITY, &parry_capsule(a, b, radius), &pose, &shape::Cuboid::new(o.half), 1.0);
    contact.unwrap().map_or(1.0, |c| c.dist)
}

/// Whether points along the line are inside a box: slow, and independent of the slab test.
fn line_intersects(a: Vec3, b: Vec3, o: &Cuboid) -> bool {
    (0..=400).any(|i| {
        let p = o.rotation.inverse() * (a + (b - a) * (f64::from(i) / 400.0) - o.centre);
        p.abs().cmplt(o.half - Vec3::splat(1e-6)).all()
    })
}

/// The best score of a dense grid of configurations that touch deeper than the tolerance and leave it as clearance.
fn grid_best(scene: &Scene, arm: &ArmModel, side: Side, n: [u32; 4]) -> f64 {
    let at = |i: u32, n: u32, (low, high): (f64, f64)| low + (high - low) * (f64::from(i) + 0.5) / f64::from(n);
    let mut best: f64 = 0.0;
    for i in 0..n[0] {
        let abduction = at(i, n[0], ABDUCTION);
        for j in 0..n[1] {
            let flexion = at(j, n[1], flexion_range(abduction));
            for k in 0..n[2] {
                let rotation = at(k, n[2], rotation_range(abduction, flexion));
                for l in 0..n[3] {
                    let config = [abduction, flexion, rotation, at(l, n[3], ELBOW)];
                    best = best.max(grid_score(scene, arm, side, config));
                }
            }
        }
    }
    best
}

fn grid_score(scene: &Scene, arm: &ArmModel, side: Side, config: Config) -> f64 {
    let pose = &scene.world_from_shoulder;
    let (elbow, wrist) = arm.forward(side, config);
    let (shoulder, elbow, wrist) = (pose.translation, pose.transform_point(elbow), pose.transform_point(wrist));
    let (mut worst, tolerance): (f64, f64) = (0.0, arm.hand_tolerance_m(TOLERANCE));
    for (i, link) in scene.links.iter().enumerate() {
        let Solid::Capsule(c) = link else { unreachable!("capsule scenes") };
        let to = query::distance(
            &Pose::IDENTITY,
            &parry_capsule(elbow, wrist, arm.forearm_radius_m),
            &Pose::IDENTITY,
            &parry_capsule(c.a, c.b, c.radius),
        );
        // parry gives zero for overlaps; the depth comes from the cores.
        let core = |a: Vec3, b: Vec3| crate::geometry::distance::segment_segment(a, b, c.a, c.b).distance - c.radius;
        let fore = core(elbow, wrist) - arm.forearm_radius_m;
        assert!((to.unwrap().distance - fore.max(0.0)).abs() < 1e-4, "kernel and parry disagree");
        let near = link.point_distance(wrist);
        let line_free =
            near.distance <= 0.0 || !scene.obstacles.iter().any(|o| line_intersects(wrist, near.on_second, o));
        // A line that has no more room than what is held moves by is not looked for.
        let narrow = |o: &Cuboid| parry_clearance(wrist, near.on_second, 0.001, o) <= tolerance;
        let line_free = line_free && (arm.held_m() <= 0.0 || !scene.obstacles.iter().any(narrow));
        let hand = if line_free { near.distance - arm.hand_radius_m } else { f64::MAX };
        let upper = core(shoulder, elbow) - arm.upper_arm_radius_m;
        for (distance, segment) in
            [(hand, ArmSegment::Hand), (fore, ArmSegment::Forearm), (upper, ArmSegment::UpperArm)]
        {
            if distance <= -tolerance {
                worst = worst.max(scene.score.score(segment, i, wrist));
            }
        }
    }
    if worst == 0.0 {
        return 0.0;
    }
    let from = shoulder + (elbow - shoulder) * ((arm.upper_arm_radius_m + SHOULDER_CLEARANCE_M) / arm.upper_arm_m);
    let clear = scene.obstacles.iter().all(|o| {
        parry_clearance(elbow, wrist, arm.forearm_radius_m, o) > tolerance
            && parry_clearance(from, elbow, arm.upper_arm_radius_m, o) > tolerance
            && parry_clearance(shoulder, elbow, 0.001, o) > tolerance
    });
    if clear { worst } else { 0.0 }
}

/// What was found really is a contact: within limits, touching, free, by parry.
fn verify(scene: &Scene, arm: &ArmModel, side: Side, found: &ArmContact) {
    assert_eq!(clamped(found.config), found.config, "outside the joint limits");
    let pose = &scene.world_from_shoulder;
    let (elbow, wrist) = arm.forward(side, found.config);
    assert!((pose.transform_point(elbow) - found.elbow).length() < 1e-12);
    assert!((pose.transform_point(wrist) - found.wrist).length() < 1e-12);
    for o in &scene.obstacles {
        assert!(parry_clearance(found.elbow, found.wrist, arm.forearm_radius_m, o) > -1e-4, "forearm in an obstacle");
        assert!(!line_intersects(pose.translation, found.elbow, o), "upper arm through an obstacle");
        if found.segment == ArmSegment::Hand {
            assert!(!line_intersects(found.wrist, found.on_link, o), "a hand through a wall");
        }
    }
    let Solid::Capsule(link) = &scene.links[found.link] else { unreachable!("capsule scenes") };
    let link = parry_capsule(link.a, link.b, link.radius);
    let limb = match found.segment {
        ArmSegment::Hand => parry_capsule(found.wrist, found.wrist, arm.hand_radius_m),
        ArmSegment::Elbow | ArmSegment::Forearm => parry_capsule(found.elbow, found.wrist, arm.forearm_radius_m),
        ArmSegment::UpperArm => parry_capsule(pose.translation, found.elbow, arm.upper_arm_radius_m),
    };
    let distance = query::distance(&Pose::IDENTITY, &limb, &Pose::IDENTITY, &link).unwrap().distance;
    assert!(distance < 1e-4, "no contact: {distance}");
}

/// Compares one scene; whether there was anything to find. A search that ended at its work limit promises nothing.
fn compare(arm: ArmModel, scene: &Scene, n: [u32; 4], name: &str) -> bool {
    let mut any = false;
    for side in Side::BOTH {
        let expected = grid_best(scene, &arm, side, n);
        let outcome = reach(&scene.query(&arm, side));
        if let Some(found) = &outcome.best {
            verify(scene, &arm, side, found);
        }
        let found = outcome.best.map_or(0.0, |b| b.score);
        assert!(
            !outcome.complete || found * SLACK >= expected - 1e-12,
            "{name} {side:?}: found {found}, the grid {expected}"
        );
        any |= expected > 0.0;
    }
    any
}

#[test]
fn finds_whatever_a_grid_finds_in_random_scenes() {
    if !sample::is_turn(1, 2) {
        return;
    }
    let mut rng = Rng::new(11);
    for arm in [ArmModel::default(), ArmModel::holding(0.3)] {
        let scenes: Vec<(usize, Scene)> = (0..60).map(|i| (i, random_scene(&mut rng, i % 8))).collect();
        let found = |(i, scene): &(usize, Scene)| compare(arm, scene, [7, 7, 5, 5], &format!("scene {i}"));
        let hits = sample::some(scenes, 6).filter(found).count();
        let most = if sample::is_whole() { 60 } else { 11 };
        assert!((sample::least(10, 10)..most).contains(&hits), "{hits} scenes with contacts: too easy or too hard");
    }
}

/// With the wrist kept near where it hangs: what is found is there, and no worse contact there is missed that random arms have.
#[test]
fn a_wrist_that_is_kept_near_is_looked_for_there() {
    let (arm, mut rng) = (ArmModel::default(), Rng::new(77));
    let (mut kept, mut lost, mut met) = (0, 0, 0);
    for number in 0..60 {
        let (scene, side) = (random_scene(&mut rng, number % 4), Side::BOTH[number % 2]);
        let (_, hangs) = arm.forward(side, [0.0; 4]);
        let (from, far_m) = (scene.world_from_shoulder.transform_point(hangs), uniform(&mut rng, 0.1, 0.9));
        let free = reach(&scene.query(&arm, side));
        let near = reach(&ReachQuery { wrist_within: Some((from, far_m)), ..scene.query(&arm, side) });
        if let Some(found) = &near.best {
            verify(&scene, &arm, side, found);
            assert!((found.wrist - from).length() <= far_m && free.best.is_some());
        }
        kept += usize::from(near.best.is_some());
        lost += usize::from(free.best.is_some() && near.best.is_none());
        let known = near.best.map_or(0.0, |best| best.score);
        for _ in 0..1500 {
            let abduction = uniform(&mut rng, ABDUCTION.0, ABDUCTION.1);
            let [flexion, elbow] = [flexion_range(abduction), ELBOW].map(|(low, high)| uniform(&mut rng, low, high));
            let (low, high) = rotation_range(abduction, flexion);
            let config = [abduction, flexion, uniform(&mut rng, low, high), elbow];
            let wrist = scene.world_from_shoulder.transform_point(arm.forward(side, config).1);
            if (wrist - from).length() > far_m - TOLERANCE {
                continue;
            }
            let score = grid_score(&scene, &arm, side, config);
            met += usize::from(score > 0.0);
            assert!(!near.complete || known * SLACK >= score - 1e-12, "{number}: found {known}, and there is {score}");
        }
    }
    assert!(kept > 10 && lost > 5 && met > 500, "{kept} {lost} {met}");
}

#[test]
fn finds_whatever_a_grid_finds_at_a_fence() {
    if !sample::is_turn(0, 2) {
        return;
    }
    let mut rng = Rng::new(5);
    for arm in [ArmModel::default(), ArmModel::holding(0.3)] {
        let scenes: Vec<(u32, Scene)> = (0..30).map(|i| (i, fence_scene(&mut rng))).collect();
        let found = |(i, scene): &(u32, Scene)| compare(arm, scene, [14, 14, 8, 8], &format!("fence {i}"));
        let hits = sample::some(scenes, 5).filter(found).count();
        assert!(!sample::is_whole() || (3..28).contains(&hits), "{hits} fences with contacts");
    }
}

#[test]
fn nothing_reaches_through_a_closed_wall() {
    let mut rng = Rng::new(8);
    let arm = ArmModel::default();
    for _ in 0..40 {
        let mut scene = fence_scene(&mut rng);
        scene.obstacles = vec![Cuboid {
            centre: Vec3::new(0.0, 0.0, 1.25),
            half: Vec3::new(3.0, 0.01, 1.25),
            rotation: Rotation::IDENTITY,
        }];
        for side in Side::BOTH {
            let outcome = reach(&scene.query(&arm, side));
            assert_eq!(outcome.best, None);
        }
    }
}

#[test]
fn enough_is_enough_and_a_work_limit_is_told() {
    let mut rng = Rng::new(2);
    let arm = ArmModel::default();
    let scene = (0..50).map(|_| random_scene(&mut rng, 4)).find(|s| reach(&s.query(&arm, Side::Left)).best.is_some());
    let scene = scene.expect("a scene with a contact");
    let all = reach(&scene.query(&arm, Side::Left));
    let some = reach(&ReachQuery { enough: 0.0, ..scene.query(&arm, Side::Left) });
    assert!(some.complete && some.best.is_some() && some.boxes <= all.boxes);
    let cut = reach(&ReachQuery { work_limit: 1, ..scene.query(&arm, Side::Left) });
    assert!(!cut.complete);
}

/// Pieces beyond those that a search can number are not left out without a word.
#[test]
fn too_many_pieces_are_told() {
    let arm = ArmModel::default();
    let mut scene = random_scene(&mut Rng::new(2), 0);
    let near = Vec3::new(0.3, 0.0, 0.0);
    for (links, complete) in [(65_535, true), (65_536, false)] {
        scene.links = vec![Solid::Capsule(Capsule { a: near, b: near, radius: 0.01 }); links];
        scene.score = ByLink(vec![1.0; links]);
        let query = ReachQuery { enough: 0.0, world_from_shoulder: Pose::IDENTITY, ..scene.query(&arm, Side::Left) };
        assert_eq!(reach(&query).complete, complete, "{links}");
    }
}

/// Links that turn about axes: what a point scores is how fast it is, and how tender the segment.
struct Turning(Vec<Twist>);

const TENDER: [f64; 4] = [1.3, 1.3, 1.15, 1.0];

impl Turning {
    fn tender(segment: ArmSegment) -> f64 {
        SEGMENTS.iter().position(|s| *s == segment).map_or(0.0, |i| TENDER[i])
    }
}

impl ContactScore for Turning {
    fn upper_bound(&self, segment: ArmSegment, link: usize) -> f64 {
        self.upper_bound_near(segment, link, &Neighbourhood::ball(Vec3::ZERO, 3.0))
    }
    fn upper_bound_near(&self, segment: ArmSegment, link: usize, points: &Neighbourhood<'_>) -> f64 {
        Self::tender(segment) * self.0[link].speed_bound(points)
    }
    fn score(&self, segment: ArmSegment, link: usize, on_link: Vec3) -> f64 {
        Self::tender(segment) * self.0[link].velocity_at(on_link).length()
    }
}

#[test]
fn no_promised_contact_is_in_a_box_that_is_dropped() {
    let scene = |rng: &mut Rng, i| if i % 2 == 0 { random_scene(rng, 3) } else { fence_scene(rng) };
    for (arm, scenes) in sample::some([(ArmModel::default(), 120), (ArmModel::holding(0.3), 60)], 2) {
        let [dropped, kept, dropped_in_touch] = dropped_boxes(arm, scenes, &scene);
        assert!(dropped > 30_000 && kept > 10_000 && dropped_in_touch > 2000, "{dropped} {kept} {dropped_in_touch}");
    }
}

/// Meshes with a notch instead of capsules: what holds for convex shapes alone would drop too much.
#[test]
fn no_promised_contact_with_a_mesh_is_in_a_box_that_is_dropped() {
    let surface = channel();
    let scene = |rng: &mut Rng, i| {
        let mut scene = if i % 2 == 0 { random_scene(rng, 3) } else { fence_scene(rng) };
        let Solid::Capsule(first) = &scene.links[0] else { unreachable!("capsule scenes") };
        let tool = first.a;
        scene.links = (0..2)
            .map(|_| {
                let turn =
                    rotation_about(Vec3::X, uniform(rng, -3.0, 3.0)) * rotation_about(Vec3::Z, uniform(rng, 0.0, 3.0));
                let place = Pose::from_parts(tool + vector(rng, 0.5), turn);
                Solid::Mesh(Mesh::new(Arc::clone(&surface), place))
            })
            .collect();
        scene
    };
    let [dropped, kept, dropped_in_touch] = dropped_boxes(ArmModel::default(), 40, &scene);
    assert!(dropped > 40_000 && kept > 4000 && dropped_in_touch > 2000, "{dropped} {kept} {dropped_in_touch}");
}

/// Hulls that are cut into slabs: planes that are remembered from box to box, speeds at corners, and axes that are inside.
#[test]
fn no_promised_contact_with_a_hull_is_in_a_box_that_is_dropped() {
    let scene = |rng: &mut Rng, i| {
        let mut scene = if i % 2 == 0 { random_scene(rng, 3) } else { fence_scene(rng) };
        let Solid::Capsule(first) = &scene.links[0] else { unreachable!("capsule scenes") };
        let tool = first.a;
        scene.links = (0..3)
            .map(|_| {
                let size = Vec3::new(uniform(rng, 0.2, 0.5), uniform(rng, 0.05, 0.3), uniform(rng, 0.05, 0.2));
                let points: Vec<Vec3> = (0..60).map(|_| vector(rng, 1.0).normalize() * size).collect();
                let turn =
                    rotation_about(Vec3::X, uniform(rng, -3.0, 3.0)) * rotation_about(Vec3::Z, uniform(rng, 0.0, 3.0));
                let hull = Solid::Hull(Hull::from_points(&points).unwrap());
                hull.placed(Pose::from_parts(tool + vector(rng, 0.4), turn)).grown(uniform(rng, 0.0, 0.02))
            })
            .collect();
        scene
    };
    let [dropped, kept, dropped_in_touch] = dropped_boxes(ArmModel::default(), 20, &scene);
    assert!(dropped > 20_000 && kept > 4000 && dropped_in_touch > 2000, "{dropped} {kept} {dropped_in_touch}");
}

/// A forearm deep in a link is not left out where contacts are looked for to more than it is thick.
#[test]
fn what_is_deep_in_a_link_may_touch_it_whatever_the_tolerance() {
    let (arm, pose) = (ArmModel::default(), Pose::IDENTITY);
    let frame = Frame::new(&pose, Side::Left);
    let mut b = JointBox::whole();
    b.half = [1e-3; 4];
    let turns = b.middle.map(libm::sincos);
    let [elbow, wrist] = arm.at(&turns).map(|point| frame.to_world(point));
    let placed = Placed { shoulder: pose.translation, elbow, wrist, turns };
    let middle = (elbow + wrist) * 0.5;
    let corners = |n: i32| {
        let at = move |k: i32| f64::from(k) * 0.4 / f64::from(n) - 0.2;
        (0..=n)
            .flat_map(move |x| (0..=n).flat_map(move |y| [-0.2, 0.2].map(|z| Vec3::new(at(x), at(y), z))))
            .collect::<Vec<_>>()
    };
    let round: Vec<Vec3> = corners(4).into_iter().map(|corner| corner.normalize() * 0.25).collect();
    let hulls = [corners(1), round].map(|points| Solid::Hull(Hull::from_points(&points).unwrap()));
    let ball = Solid::Capsule(Capsule { a: Vec3::ZERO, b: Vec3::ZERO, radius: 0.2 });
    for (solid, is_cut) in hulls.into_iter().zip([false, true]).chain([(ball, false)]) {
        assert_eq!(matches!(&solid, Solid::Hull(hull) if hull.is_cut()), is_cut);
        let solid = solid.placed(Pose::from_parts(middle, Rotation::IDENTITY));
        let limb = Limb { ends: [Share::ELBOW, Share::on_forearm(1.0)], radius: arm.forearm_radius_m };
        let movement = Movement::of(&arm, &b, &placed, frame, 0.0);
        // The largest tolerance of a cell file, and one below the radius.
        for tolerance in [0.05, 0.02] {
            assert!(limb.may_touch((&solid, &Cell::default()), tolerance, &placed, &movement).is_some(), "{solid:?}");
        }
    }
}

/// A channel 1.2 m wide and 0.8 m high: an arm has room in it, and two walls and a floor to meet.
fn channel() -> Arc<Surface> {
    let corners =
        [[0.0, 0.0], [1.2, 0.0], [1.2, 0.8], [1.15, 0.8], [1.15, 0.05], [0.05, 0.05], [0.05, 0.8], [0.0, 0.8]];
    let caps = [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4], [0, 5, 6], [0, 6, 7]];
    let (points, triangles) = meshes::prism(&corners, &caps, 0.6);
    let middle = Vec3::new(0.6, 0.3, 0.4);
    let points: Vec<Vec3> = points.into_iter().map(|point| Vec3::from_array(point) - middle).collect();
    Arc::new(Surface::new(Triangles::merged(&points, &triangles)).unwrap())
}

/// A forearm that is said not to overlap a mesh by the tolerance within a box of joint angles never does.
#[test]
fn no_limb_overlaps_a_mesh_where_it_is_said_not_to() {
    let (mut rng, arm, surface) = (Rng::new(17), ArmModel::default(), channel());
    let mut apart = 0;
    for _ in 0..4000 {
        let turn = rotation_about(Vec3::X, uniform(&mut rng, -3.0, 3.0))
            * rotation_about(Vec3::Z, uniform(&mut rng, 0.0, 3.0));
        let link = Solid::Mesh(Mesh::new(Arc::clone(&surface), Pose::from_parts(vector(&mut rng, 0.7), turn)));
        let (pose, whole) = (Pose::IDENTITY, JointBox::whole());
        let frame = Frame::new(&pose, Side::Left);
        let place = |config: Config| {
            let turns = config.map(libm::sincos);
            let [elbow, wrist] = arm.at(&turns);
            Placed { shoulder: pose.translation, elbow, wrist, turns }
        };
        let mut b = whole;
        for joint in 0..4 {
            b.half[joint] = (uniform(&mut rng, 0.0, 0.5) * uniform(&mut rng, 0.0, 1.0)).min(whole.half[joint]);
            let room = whole.half[joint] - b.half[joint];
            b.middle[joint] = whole.middle[joint] + uniform(&mut rng, -room, room);
        }
        let radius = arm.forearm_radius_m;
        let limb = Limb { ends: [Share::ELBOW, Share::on_forearm(1.0)], radius };
        if limb
            .may_touch(
                (&link, &Cell::default()),
                TOLERANCE,
                &place(b.middle),
                &Movement::of(&arm, &b, &place(b.middle), frame, 0.0),
            )
            .is_some()
        {
            continue;
        }
        apart += 1;
        for _ in 0..20 {
            let mut config = b.middle;
            // Towards the corners, where the farthest movements are.
            (0..4).for_each(|j| config[j] += b.half[j] * (if rng.below(2) == 0 { -1.0 } else { 1.0 }));
            let there = place(config);
            let distance = link.segment_distance(there.elbow, there.wrist).distance - radius;
            assert!(distance >= -TOLERANCE - 1e-8, "{distance} m");
        }
    }
    assert!(apart > 500, "{apart}");
}

/// A frame that shoulder, elbow and wrist are carried to: moved, and turned about the vertical.
fn carried<S: ContactScore>(rng: &mut Rng, query: &ReachQuery<'_, S>) -> Pose {
    let share = uniform(rng, 0.0, 1.0);
    let moved = vector(rng, 1.0).normalize_or_zero() * (share * query.carried_m);
    let turned =
        rotation_about(Vec3::Z, (1.0 - share) * query.carried_m / (query.arm.upper_arm_m + query.arm.forearm_m));
    let at = query.world_from_shoulder;
    Pose::from_parts(at.translation + moved, turned * at.rotation)
}

/// Boxes of all sizes that are dropped, and configurations in them: none has a contact that was promised to be found. How
/// many boxes were dropped, how many promised contacts were kept, and how many others are in boxes that were dropped.
fn dropped_boxes(arm: ArmModel, scenes: usize, scene: &dyn Fn(&mut Rng, usize) -> Scene) -> [usize; 3] {
    let mut rng = Rng::new(21);
    let (mut dropped, mut kept, mut dropped_in_touch) = (0, 0, 0);
    for i in 0..scenes {
        let scene = scene(&mut rng, i);
        let twist = |_: &Solid| Twist { angular: vector(&mut rng, 1.0), linear_at_origin: vector(&mut rng, 0.3) };
        let score = Turning(scene.links.iter().map(twist).collect());
        let side = Side::BOTH[i % 2];
        let query = ReachQuery {
            arm: &arm,
            side,
            world_from_shoulder: scene.world_from_shoulder,
            carried_m: if i % 2 == 0 { 0.0 } else { uniform(&mut rng, 0.0, 0.12) },
            hangs_from: None,
            known: None,
            wrist_within: None,
            links: &scene.links,
            obstacles: &scene.obstacles,
            score: &score,
            threshold: uniform(&mut rng, 0.3, 0.9),
            tolerance_m: TOLERANCE,
            enough: f64::INFINITY,
            work_limit: 0,
            stop: None,
        };
        let search = Search::new(&query);
        if search.pieces.is_empty() {
            continue;
        }
        for _ in 0..3000 {
            let whole = JointBox::whole();
            let size = uniform(&mut rng, 0.0, 1.0).powi(2);
            let mut b = whole;
            for joint in 0..4 {
                b.half[joint] = (0.01 + 0.5 * size * uniform(&mut rng, 0.1, 1.0)).min(whole.half[joint]);
                let room = whole.half[joint] - b.half[joint];
                b.middle[joint] = whole.middle[joint] + uniform(&mut rng, -room, room);
            }
            let placed = search.place(b.middle);
            let movement = Movement::of(&arm, &b, &placed, search.frame, query.carried_m);
            let elsewhere = ReachQuery { world_from_shoulder: carried(&mut rng, &query), carried_m: 0.0, ..query };
            let elsewhere = Search::new(&elsewhere);
            let open = search.pieces.iter().any(|p| {
                search.hand_or_forearm_may_matter(true, p, &placed, &movement)
                    || search.elbow_or_upper_arm_may_matter(p, &placed, &movement)
            });
            let drop = !open || search.certainly_blocked(&placed, &movement);
            for _ in 0..12 {
                let mut config = b.middle;
                (0..4).for_each(|j| config[j] += uniform(&mut rng, -b.half[j], b.half[j]));
                if clamped(config) != config {
                    continue;
                }
                let there = elsewhere.place(config);
                let (a, w) = (elsewhere.clear_of_shoulder(&there), there.wrist);
                let room = |o: &Cuboid| {
                    !segment_hits_cuboid(there.shoulder, there.elbow, o)
                        && segment_cuboid(a, there.elbow, o).distance > arm.upper_arm_radius_m + TOLERANCE
                        && segment_cuboid(there.elbow, w, o).distance > arm.forearm_radius_m + TOLERANCE
                };
                let has_room = scene.obstacles.iter().all(room);
                elsewhere.each_contact(config, &there, |contact| {
                    dropped_in_touch += usize::from(drop);
                    // Promised: deeper, in more room, and faster by what the tolerance makes of speeds.
                    let tolerance =
                        if contact.segment == ArmSegment::Hand { arm.hand_tolerance_m(TOLERANCE) } else { TOLERANCE };
                    let least = query.threshold + TENDER[0] * score.0[contact.link].angular.length() * tolerance;
                    if contact.signed_distance < -tolerance && contact.score > least && has_room {
                        assert!(!drop, "scene {i}: {contact:?} in {:?} +- {:?}", b.middle, b.half);
                        kept += 1;
                    }
                });
            }
            dropped += usize::from(drop);
        }
    }
    [dropped, kept, dropped_in_touch]
}

/// Elbow and wrist stay within what is told of a box, along any direction and in any; sometimes they get nearly as far.
#[test]
fn elbow_and_wrist_sweep_no_more_than_told() {
    let (mut rng, whole) = (Rng::new(41), JointBox::whole());
    let longer = ArmModel { upper_arm_m: 0.41, forearm_m: 0.24, ..ArmModel::default() };
    let (mut beyond, mut used, mut nearly) = (f64::MIN, [0; 2], [0; 2]);
    for number in 0..6000 {
        let arm = if number % 3 == 0 { longer } else { ArmModel::default() };
        let side = Side::BOTH[number % 2];
        let scene = random_scene(&mut rng, 0);
        let search_of = scene.query(&arm, side);
        let search = Search::new(&search_of);
        let size = uniform(&mut rng, 0.05, 1.0).powi(2);
        let mut b = whole;
        for joint in 0..4 {
            b.half[joint] =
                whole.half[joint] * size * if rng.below(3) == 0 { 0.01 } else { uniform(&mut rng, 0.1, 1.0) };
            let room = whole.half[joint] - b.half[joint];
            b.middle[joint] = whole.middle[joint] + uniform(&mut rng, -room, room);
        }
        let placed = search.place(b.middle);
        let movement = Movement::of(&arm, &b, &placed, search.frame, 0.0);
        // Within the box, and on its sides, edges and corners.
        let configs: Vec<Config> = (0..60)
            .map(|_| {
                std::array::from_fn(|j| {
                    b.middle[j] + b.half[j] * [-1.0, 1.0, uniform(&mut rng, -1.0, 1.0)][rng.below(3)]
                })
            })
            .collect();
        let moved: Vec<[Vec3; 2]> = configs
            .iter()
            .map(|config| {
                let there = search.place(*config);
                [there.elbow - placed.elbow, there.wrist - placed.wrist]
            })
            .collect();
        for [elbow, wrist] in &moved {
            beyond = beyond.max(elbow.length() - movement.elbow).max(wrist.length() - movement.wrist);
        }
        for _ in 0..4 {
            let n = vector(&mut rng, 1.0).normalize_or(Vec3::X);
            for (point, range) in movement.both(n).into_iter().enumerate() {
                let along = moved.iter().map(|moved| moved[point].dot(n));
                let (least, most) = along.fold((f64::MAX, f64::MIN), |(l, m), a| (l.min(a), m.max(a)));
                beyond = beyond.max(most - range.high).max(range.low - least);
                used[point] += 1;
                nearly[point] += usize::from(most - least > 0.8 * (range.high - range.low));
            }
            let (both, one) = (movement.both(n)[0], movement.elbow(n));
            assert_eq!((both.low, both.high), (one.low, one.high));
        }
    }
    assert!(beyond < 1e-9, "{beyond} m beyond what is told");
    // Sixty places in four dimensions are few: where they fill four fifths, the bounds are tight.
    assert!((0..2).all(|point| 3 * nearly[point] > used[point]), "{nearly:?} of {used:?} nearly filled");
}

/// A box that may hold a contact is done with only when neither elbow nor wrist moves by more than the tolerance in it.
#[test]
fn a_box_is_done_with_when_the_whole_arm_hardly_moves() {
    let (mut rng, arm, whole) = (Rng::new(51), ArmModel::default(), JointBox::whole());
    let (mut done, mut split) = (0, 0);
    for _ in 0..300 {
        let scene = random_scene(&mut rng, 0);
        let query = scene.query(&arm, Side::Left);
        let mut search = Search::new(&query);
        let open: Vec<u16> = (0..search.pieces.len()).filter_map(|i| u16::try_from(i).ok()).collect();
        for _ in 0..200 {
            // Bent elbows bring the wrist near the axes of the shoulder.
            let mut b = whole;
            for joint in 0..4 {
                b.half[joint] = if joint < 2 { uniform(&mut rng, 0.0, 0.2) } else { uniform(&mut rng, 0.0, 0.02) };
                b.middle[joint] = whole.middle[joint] + uniform(&mut rng, -0.9, 0.9) * whole.half[joint];
            }
            let placed = search.place(b.middle);
            let mut left =
                OpenPieces { beyond_elbow: open.clone(), near_shoulder: open.clone(), hand_was_tried: false };
            search.best = None;
            let next = search.look_at(&b, &placed, &mut left);
            if left.beyond_elbow.is_empty() || next.is_some() {
                split += usize::from(next.is_some());
                continue;
            }
            done += 1;
            for corner in 0..16 {
                let there = search.place(std::array::from_fn(|j| {
                    b.middle[j] + if corner >> j & 1 == 0 { b.half[j] } else { -b.half[j] }
                }));
                let moved = (there.elbow - placed.elbow).length().max((there.wrist - placed.wrist).length());
                assert!(moved <= TOLERANCE + 1e-9, "{moved} m in {:?} +- {:?}", b.middle, b.half);
            }
        }
    }
    assert!(done > 100 && split > 1000, "{done} {split}");
}

/// What is known of one elbow says nothing of others in a box, from which a hand gets farther.
#[test]
fn a_hand_is_out_of_reach_when_it_is_from_every_elbow_of_a_box() {
    let (arm, quarter) = (ArmModel::default(), std::f64::consts::FRAC_PI_2);
    let middle = Vec3::new(0.65, 0.0, -0.28);
    let link = Solid::Capsule(Capsule { a: middle, b: middle, radius: 0.05 });
    let targets = [cells::Target { solid: &link, hand: true, forearm: true, upper_arm: true }];
    let known = ArmCells::new(&arm, &targets, &[], &[]);
    let scene = Scene {
        world_from_shoulder: Pose::IDENTITY,
        links: vec![link.clone()],
        obstacles: Vec::new(),
        score: ByLink(vec![1.0]),
    };
    let query = ReachQuery { known: Some(&known), ..scene.query(&arm, Side::Left) };
    let search = Search::new(&query);
    // Hanging, with the elbow bent at a right angle, and so far to both sides of it.
    let is_out_of_reach = |half_rad: f64| {
        let b = JointBox { middle: [0.0, 0.0, 0.0, quarter], half: [0.0, half_rad, 0.0, half_rad] };
        let placed = search.place(b.middle);
        search.is_known_beyond_elbow(&placed, &Movement::of(&arm, &b, &placed, search.frame, 0.0))
    };
    // The hand gets 0.32 m + 0.23 m forward of the elbow; the link begins 0.6 m forward of it.
    assert!(is_out_of_reach(0.0));
    // Raised by 0.4 rad, with the forearm level, the elbow is 0.3 m x sin 0.4 = 0.117 m farther forward: the hand is in the link.
    let raised = search.place([0.0, 0.4, 0.0, quarter - 0.4]);
    assert!(link.point_distance(raised.wrist).distance < arm.hand_radius_m);
    assert!(!is_out_of_reach(0.4));
}

/// The point of a capsule that is nearest to the wrist moves no farther than told, and sometimes nearly as far.
#[test]
fn nearest_points_move_no_farther_than_told() {
    let (mut rng, arm) = (Rng::new(31), ArmModel::default());
    let (mut closest, mut closest_along): (f64, f64) = (0.0, 0.0);
    for _ in 0..20_000 {
        let scene = random_scene(&mut rng, 0);
        let query = scene.query(&arm, Side::Left);
        let search = Search::new(&query);
        let whole = JointBox::whole();
        let b = JointBox {
            middle: std::array::from_fn(|j| whole.middle[j] + uniform(&mut rng, -0.5, 0.5) * whole.half[j]),
            // Some joints hardly turn: what is along one direction and what across it then differ.
            half: std::array::from_fn(|_| if rng.below(2) == 0 { 0.001 } else { uniform(&mut rng, 0.005, 0.15) }),
        };
        let placed = search.place(b.middle);
        let movement = Movement::of(&arm, &b, &placed, search.frame, 0.0);
        // Just outside of the wrist's ball, where directions turn most.
        let radius = uniform(&mut rng, 0.02, 0.5);
        let away = movement.wrist * uniform(&mut rng, 1.01, 3.0) + radius;
        let (a, core) = (placed.wrist + vector(&mut rng, 1.0).normalize_or(Vec3::X) * away, vector(&mut rng, 0.5));
        let link = Solid::Capsule(Capsule { a: a - core, b: a + core, radius });
        let near = link.point_distance(placed.wrist);
        if near.distance <= movement.wrist {
            continue;
        }
        let moves = NearestMoves::new(&link, &near, &movement);
        // Corners move most.
        for corner in 0..16 {
            let to: Config =
                std::array::from_fn(|j| b.middle[j] + if corner >> j & 1 == 0 { b.half[j] } else { -b.half[j] });
            let moved = link.point_distance(search.place(to).wrist).on_second - near.on_second;
            closest = closest.max(moved.length() / moves.at_most());
            let core = core.normalize_or(Vec3::X);
            for n in [moved + vector(&mut rng, 0.3 * moved.length()), core, moved - core * moved.dot(core)] {
                let n = n.normalize_or(Vec3::X);
                closest_along = closest_along.max(moved.dot(n).abs() / moves.along(n));
            }
        }
    }
    for ratio in [closest, closest_along] {
        assert!(ratio <= 1.0 + 1e-9, "moved {ratio} times as far as told");
        assert!(ratio > 0.9, "at most {ratio} of what is told: the bounds are loose");
    }
}
