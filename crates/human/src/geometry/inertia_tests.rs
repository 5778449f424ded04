//! What a point weighs: by hand for pendulums and arms of two links, and against the energy of grains for random trees.

use std::f64::consts::{FRAC_PI_2, FRAC_PI_3};

use super::super::kinematics::{Joint, KinematicTree, Motion};
use super::super::rotation_about;
use super::*;

fn close(a: f64, b: f64) -> bool {
    (a - b).abs() <= 1e-9 * b.abs().max(1.0)
}

fn turns(parent: Option<usize>, x: f64) -> Joint {
    Joint { parent, parent_from_joint: Pose::translation(x, 0.0, 0.0), motion: Motion::Revolute, axis: Vec3::Z }
}

/// Two links of 0.5 m and 0.4 m in the plane, with 3 kg in the elbow and 2 kg in the tip.
const L: [f64; 2] = [0.5, 0.4];
const M: [f64; 2] = [3.0, 2.0];

fn planar() -> (KinematicTree, Masses) {
    let tree = KinematicTree { world_from_base: Pose::IDENTITY, joints: vec![turns(None, 0.0), turns(Some(0), L[0])] };
    (tree, Masses::free((0..2).map(|i| Inertia::point(M[i], Vec3::X * L[i])).collect()))
}

/// The tip and the direction of the second link.
fn tip(q: [f64; 2]) -> (Vec3, Vec3) {
    let along = |angle: f64| Vec3::new(libm::cos(angle), libm::sin(angle), 0.0);
    (along(q[0]) * L[0] + along(q[0] + q[1]) * L[1], along(q[0] + q[1]))
}

#[test]
fn a_pendulum_weighs_its_moment_of_inertia_over_the_lever_squared() {
    let tree = KinematicTree { world_from_base: Pose::translation(1.0, 2.0, 3.0), joints: vec![turns(None, 0.0)] };
    let placed = tree.place(&[FRAC_PI_2]);
    let rod = Inertia::new(4.0, Vec3::X * 0.3, [0.0, 0.1, 0.1], [0.0; 3]);
    let masses = Masses::free(vec![rod]);
    // It points along y now; pushed at 0.8 m from its axis.
    let at = Vec3::new(1.0, 2.8, 3.0);
    let m = |direction| masses.reflected_mass_kg(&placed, None, 0, at, direction);
    assert!(close(m(Vec3::X), (4.0 * 0.09 + 0.1) / 0.64));
    assert!(close(m(Vec3::X * -3.0), m(Vec3::X)));
    // At 60 degrees from the way it can go.
    assert!(close(m(Vec3::new(0.5, 0.0, 3.0_f64.sqrt() / 2.0)), 4.0 * m(Vec3::X)));
    // Along the rod, along the axis, at the axis, and nowhere at all.
    for immovable in [m(Vec3::Y), m(Vec3::Z), m(Vec3::ZERO), m(Vec3::splat(f64::NAN))] {
        assert!(immovable == f64::INFINITY, "{immovable}");
    }
    let axis = masses.reflected_mass_kg(&placed, None, 0, Vec3::new(1.0, 2.0, 7.0), Vec3::X);
    assert!(axis == f64::INFINITY, "{axis}");
    // With 1.5 kg carried at 0.6 m.
    let load = Some((0, Inertia::point(1.5, Vec3::X * 0.6)));
    let loaded = masses.reflected_mass_kg(&placed, load, 0, at, Vec3::X);
    assert!(close(loaded, (4.0 * 0.09 + 0.1 + 1.5 * 0.36) / 0.64));
}

#[test]
fn a_slide_weighs_what_it_is_along_its_axis_and_gives_way_nowhere_else() {
    let slide = Joint { motion: Motion::Prismatic, axis: Vec3::X, ..turns(None, 0.0) };
    let tree = KinematicTree { world_from_base: Pose::IDENTITY, joints: vec![slide] };
    let masses = Masses::free(vec![Inertia::new(6.0, Vec3::Y, [1.0; 3], [0.0; 3])]);
    let m = |direction| masses.reflected_mass_kg(&tree.place(&[0.7]), None, 0, Vec3::new(5.0, 1.0, 2.0), direction);
    assert!(close(m(Vec3::X), 6.0) && close(m(Vec3::new(1.0, 1.0, 0.0)), 12.0) && m(Vec3::Z) == f64::INFINITY);
}

#[test]
fn the_planar_arm_is_as_its_formulas_say() {
    let (tree, masses) = planar();
    for q in [[0.3, 1.1], [-2.0, 0.4], [1.0, -2.5], [0.1, FRAC_PI_2]] {
        let placed = tree.place(&q);
        let matrix = masses.mass_matrix(&placed, None);
        let (cos, sin) = (libm::cos(q[1]), libm::sin(q[1]));
        let second = M[1] * L[1] * L[1];
        let both = second + M[1] * L[0] * L[1] * cos;
        let first = (M[0] + M[1]) * L[0] * L[0] + second + 2.0 * M[1] * L[0] * L[1] * cos;
        for ((i, j), by_hand) in [((0, 0), first), ((0, 1), both), ((1, 0), both), ((1, 1), second)] {
            assert!(close(matrix[(i, j)], by_hand), "{q:?}: {matrix}");
        }
        // Across the second link the tip swings alone. Along it the elbow has to go as well, across the first link; so by
        // |sin q2| of its way: m2 + m1 / sin^2 q2.
        let (at, along) = tip(q);
        let across = Vec3::Z.cross(along);
        let m = |direction| masses.reflected_mass_kg(&placed, None, 1, at, direction);
        let stiff = M[1] + M[0] / (sin * sin);
        assert!(close(m(across), M[1]) && close(m(along), stiff), "{q:?}: {} {}", m(across), m(along));
        // One does not move the other, so in between mobilities add up.
        let between = 1.0 / (0.75 / stiff + 0.25 / M[1]);
        let direction = along * libm::sin(FRAC_PI_3) + across * libm::cos(FRAC_PI_3);
        assert!(close(m(direction), between), "{q:?}: {} {between}", m(direction));
        // The elbow alone is a pendulum, whose second link trails: 1 / (n' J M^-1 J' n) of the first joint.
        let (cos, shoulder) = (libm::cos(q[0]), libm::sin(q[0]));
        let (at, n) = (Vec3::new(cos, shoulder, 0.0) * L[0], Vec3::new(-shoulder, cos, 0.0));
        let elbow = masses.reflected_mass_kg(&placed, None, 0, at, n);
        assert!(close(elbow, M[0] + M[1] * sin * sin), "{q:?}: {elbow}");
    }
}

#[test]
fn a_stretched_arm_gives_way_across_and_not_along_itself() {
    let (tree, masses) = planar();
    for bend in [0.0, std::f64::consts::PI] {
        let q = [0.4, bend];
        let (at, along) = tip(q);
        let m = |n| masses.reflected_mass_kg(&tree.place(&q), None, 1, at, n);
        assert!(m(along) == f64::INFINITY && close(m(Vec3::Z.cross(along)), M[1]), "{bend}: {}", m(along));
    }
    // Nearly stretched it weighs much, as the formula says.
    let q = [0.4, 1e-4];
    let (at, along) = tip(q);
    let m = masses.reflected_mass_kg(&tree.place(&q), None, 1, at, along);
    assert!((m / (M[1] + M[0] / (libm::sin(q[1]) * libm::sin(q[1]))) - 1.0).abs() < 1e-6, "{m}");
}

#[test]
fn joints_that_are_held_or_follow_another_give_way_as_one() {
    let (tree, mut masses) = planar();
    let q = [0.3, 1.1];
    let (at, _) = tip(q);
    let across = Vec3::Z.cross(at).normalize();
    let r = at.length();
    // The elbow is held: both links are one pendulum.
    masses.drives[1] = None;
    let held = masses.reflected_mass_kg(&tree.place(&q), None, 1, at, across);
    assert!(close(held, (M[0] * L[0] * L[0] + M[1] * r * r) / (r * r)), "{held}");
    assert!(masses.reflected_mass_kg(&tree.place(&q), None, 1, at, at) == f64::INFINITY);
    assert_eq!(masses.mass_matrix(&tree.place(&q), None).shape(), (1, 1));
    // The shoulder is held: the coordinate of the elbow keeps its number, and the tip swings alone.
    masses.drives = vec![None, Some(Drive { coordinate: 1, factor: 1.0 })];
    let swings = masses.reflected_mass_kg(&tree.place(&q), None, 1, at, Vec3::Z.cross(tip(q).1));
    assert!(close(swings, M[1]), "{swings}");
    // Links of one length, whose second joint turns back twice as far: the tip goes along x, at 2 l sin q.
    let tree = KinematicTree { joints: vec![turns(None, 0.0), turns(Some(0), L[0])], ..tree };
    masses.bodies[1] = Inertia::point(M[1], Vec3::X * L[0]);
    masses.drives = [1.0, -2.0].map(|factor| Some(Drive { coordinate: 0, factor })).to_vec();
    let placed = tree.place(&[0.7, -1.4]);
    let at = Vec3::X * (2.0 * L[0] * libm::cos(0.7_f64));
    let m = masses.reflected_mass_kg(&placed, None, 1, at, Vec3::X);
    assert!(close(m, M[1] + M[0] / (4.0 * libm::sin(0.7_f64) * libm::sin(0.7_f64))), "{m}");
    assert!(masses.reflected_mass_kg(&placed, None, 1, at, Vec3::Y) == f64::INFINITY);
}

#[test]
fn what_turns_without_inertia_gives_way_by_itself() {
    // The tip's mass is in the axis of a third joint, at which a weightless pointer of 0.1 m sits.
    let (mut tree, mut masses) = planar();
    tree.joints.push(turns(Some(1), L[1]));
    masses = Masses::free([masses.bodies, vec![Inertia::point(1.0, Vec3::ZERO)]].concat());
    let q = [0.3, 1.1, 0.0];
    let (at, along) = tip([q[0], q[1]]);
    let placed = tree.place(&q);
    let end = at + along * 0.1;
    let m = |n| masses.reflected_mass_kg(&placed, None, 2, end, n);
    assert!(m(Vec3::Z.cross(along)).abs() < 1e-12, "{}", m(Vec3::Z.cross(along)));
    assert!(close(m(along), M[1] + 1.0 + M[0] / (libm::sin(1.1_f64) * libm::sin(1.1_f64))), "{}", m(along));
    assert!(m(Vec3::Z) == f64::INFINITY);
}

/// A point mass: mass, place in its link.
type Grain = (f64, Vec3);

/// Numbers between -1 and 1 that look random.
fn numbers() -> impl FnMut() -> f64 {
    let mut state = 0.437_f64;
    move || {
        state = 3.99 * state * (1.0 - state);
        2.0 * state - 1.0
    }
}

fn grains(next: &mut impl FnMut() -> f64) -> Vec<Grain> {
    (0..15).map(|_| (0.3 + 0.2 * next(), Vec3::new(0.1 * next(), 0.15 * next(), 0.1 + 0.2 * next()))).collect()
}

fn together(grains: &[Grain]) -> Inertia {
    grains.iter().fold(Inertia::NONE, |body, (kg, at)| body.with(&Inertia::point(*kg, *at)))
}

/// Eight joints, of which two slide, in two branches from the sixth on, and the grains of each link.
fn random_tree() -> (KinematicTree, Vec<Vec<Grain>>) {
    let mut next = numbers();
    let joint = |i: usize, next: &mut dyn FnMut() -> f64| Joint {
        parent: [None, Some(0), Some(1), Some(2), Some(3), Some(4), Some(5), Some(5)][i],
        parent_from_joint: Pose::from_parts(
            Vec3::new(0.2 * next(), 0.2 * next(), 0.3 + 0.1 * next()),
            rotation_about(Vec3::new(next(), next(), 1.0).normalize(), 2.0 * next()),
        ),
        motion: if [2, 6].contains(&i) { Motion::Prismatic } else { Motion::Revolute },
        axis: Vec3::new(next(), next(), next()).normalize(),
    };
    let world_from_base = Pose::from_parts(Vec3::new(0.3, -0.2, 0.4), rotation_about(Vec3::Z, 0.7));
    let tree = KinematicTree { world_from_base, joints: (0..8).map(|i| joint(i, &mut next)).collect() };
    let all = (0..8).map(|_| grains(&mut next)).collect();
    (tree, all)
}

/// The independent way: energies of all grains by differences of where they are.
#[test]
fn a_random_tree_has_the_energy_of_its_grains() {
    let (tree, all) = random_tree();
    let masses = Masses::free(all.iter().map(|grains| together(grains)).collect());
    let load = (7, vec![(0.8, Vec3::new(0.05, 0.02, 0.1)), (0.4, Vec3::new(-0.03, 0.04, 0.2))]);
    let q = [0.3, -0.8, 0.1, 0.2, -0.5, 0.9, 0.02, 1.3];
    let (h, count) = (1e-5, q.len());
    let moved = |speeds: &[f64], h: f64| -> Vec<f64> { q.iter().zip(speeds).map(|(q, speed)| q + h * speed).collect() };
    let velocity = |link: usize, at: Vec3, speeds: &[f64]| {
        let place = |h| tree.place(&moved(speeds, h)).world_from_link[link].transform_point(at);
        (place(h) - place(-h)) / (2.0 * h)
    };
    let twice_energy = |speeds: &[f64]| -> f64 {
        let links = all.iter().enumerate().chain([(load.0, &load.1)]);
        let grains = links.flat_map(|(link, grains)| grains.iter().map(move |grain| (link, grain)));
        grains.map(|(link, (kg, at))| kg * velocity(link, *at, speeds).length_squared()).sum()
    };
    let one = |i: usize| -> Vec<f64> { (0..count).map(|j| f64::from(u8::from(i == j))).collect() };
    let sum = |a: &[f64], b: &[f64]| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| a + b).collect() };
    let numeric = DMatrix::from_fn(count, count, |i, j| {
        0.5 * (twice_energy(&sum(&one(i), &one(j))) - twice_energy(&one(i)) - twice_energy(&one(j)))
    });
    let (placed, body) = (tree.place(&q), Some((load.0, together(&load.1))));
    let matrix = masses.mass_matrix(&placed, body);
    assert!((&matrix - &numeric).amax() < 1e-6, "{matrix} {numeric}");
    assert_eq!(matrix, matrix.transpose());
    assert!(matrix.clone().cholesky().is_some() && matrix.symmetric_eigenvalues().min() > 0.0);

    let at = Vec3::new(0.1, -0.05, 0.3);
    let inverse = numeric.try_inverse().unwrap();
    for (link, n) in (0..count).flat_map(|link| [Vec3::X, Vec3::new(0.6, 0.0, 0.8), -Vec3::Y].map(|n| (link, n))) {
        let along = DVector::from_fn(count, |i, _| velocity(link, at, &one(i)).dot(n));
        let expected = 1.0 / (along.transpose() * &inverse * &along)[(0, 0)];
        let point = placed.world_from_link[link].transform_point(at);
        let found = masses.reflected_mass_kg(&placed, body, link, point, n);
        assert!((found / expected - 1.0).abs() < 1e-5, "{link} {n}: {found} {expected}");
    }
    // Two joints follow the first: energies with the speeds that it then gives.
    let mut masses = masses;
    masses.drives = vec![Some(Drive { coordinate: 0, factor: 1.0 }), None, Some(Drive { coordinate: 1, factor: -0.5 })];
    masses.drives.extend([0.7, -1.0, 0.0, 2.0, 0.3].map(|factor| Some(Drive { coordinate: 0, factor })));
    let driven = [vec![1.0, 0.0, 0.0, 0.7, -1.0, 0.0, 2.0, 0.3], vec![0.0, 0.0, -0.5, 0.0, 0.0, 0.0, 0.0, 0.0]];
    let matrix = masses.mass_matrix(&placed, body);
    for (i, j) in [(0, 0), (0, 1), (1, 1)] {
        let energy = twice_energy(&sum(&driven[i], &driven[j])) - twice_energy(&driven[i]) - twice_energy(&driven[j]);
        assert!((matrix[(i, j)] - 0.5 * energy).abs() < 1e-6, "{matrix}");
    }
}

#[test]
fn a_body_seen_from_elsewhere_is_the_same_grains() {
    let mut next = numbers();
    let grains = grains(&mut next);
    let pose = Pose::from_parts(Vec3::new(0.4, -1.0, 2.0), rotation_about(Vec3::new(0.6, 0.0, 0.8), 1.2));
    let moved: Vec<Grain> = grains.iter().map(|(kg, at)| (*kg, pose.transform_point(*at))).collect();
    let (a, b) = (together(&grains).placed(pose), together(&moved));
    assert!(close(a.mass_kg, b.mass_kg) && (a.centre - b.centre).length() < 1e-12);
    assert!((a.tensor - b.tensor).abs_diff_eq(Matrix3::ZERO, 1e-12), "{} {}", a.tensor, b.tensor);
    assert!(a.is_semidefinite() && a.is_of_a_body());
}

#[test]
fn tensors_that_no_body_has_are_known() {
    let with = |moments, products| Inertia::new(1.0, Vec3::ZERO, moments, products);
    // A ball, a thin rod, a thin disc, a point, and a rod at 45 degrees in the plane of x and y.
    for (moments, products) in [
        ([0.4, 0.4, 0.4], [0.0; 3]),
        ([0.0, 0.1, 0.1], [0.0; 3]),
        ([0.25, 0.25, 0.5], [0.0; 3]),
        ([0.0; 3], [0.0; 3]),
        ([0.05, 0.05, 0.1], [-0.05, 0.0, 0.0]),
        ([0.0007, 0.0006, 0.001_301], [0.0; 3]),
    ] {
        let body = with(moments, products);
        assert!(body.is_semidefinite() && body.is_of_a_body(), "{moments:?}");
    }
    assert!(!with([0.1, 0.1, 0.3], [0.0; 3]).is_of_a_body());
    assert!(!with([-0.1, 0.1, 0.1], [0.0; 3]).is_semidefinite());
    assert!(!with([0.1, 0.1, 0.1], [0.2, 0.0, 0.0]).is_semidefinite());
    // About its main axes: 0.1 + 0.09, 0.1 - 0.09 and 0.1.
    let turned = with([0.1, 0.1, 0.1], [0.09, 0.0, 0.0]);
    assert!(turned.is_semidefinite() && !turned.is_of_a_body());
}
