//! Tests of meshes against hulls, by hand, and of what the arm search relies on.

use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64;

use super::*;
use crate::geometry::segment_cuboid::segment_cuboid;
use crate::geometry::surface::{Flaw, Triangles};
use crate::geometry::test_meshes as meshes;
use crate::geometry::{Cuboid, Hull, Solid, rotation_about};

type Raw = (Vec<[f64; 3]>, Vec<[u32; 3]>);

fn merged((points, triangles): &Raw) -> Triangles {
    Triangles::merged(&points.iter().map(|p| Vec3::from_array(*p)).collect::<Vec<_>>(), triangles)
}

fn mesh(raw: &Raw) -> Solid {
    Solid::Mesh(Mesh::new(Arc::new(Surface::new(merged(raw)).unwrap()), Pose::IDENTITY))
}

fn hull((points, _): &Raw) -> Solid {
    Solid::Hull(Hull::from_points(&points.iter().map(|p| Vec3::from_array(*p)).collect::<Vec<_>>()).unwrap())
}

/// A U: 0.6 m wide, 0.4 m high, 0.3 m deep, walls of 0.1 m.
fn channel() -> Raw {
    let corners = [[0.0, 0.0], [0.6, 0.0], [0.6, 0.4], [0.5, 0.4], [0.5, 0.1], [0.1, 0.1], [0.1, 0.4], [0.0, 0.4]];
    let caps = [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4], [0, 5, 6], [0, 6, 7]];
    meshes::prism(&corners, &caps, 0.3)
}

fn vector(random: &mut Pcg64, size: f64) -> Vec3 {
    let mut unit = || (f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0) * size;
    Vec3::new(unit(), unit(), unit())
}

#[test]
fn a_cube_is_as_far_as_its_hull_and_has_the_same_inside() {
    let raw = meshes::cuboid([-0.3, -0.2, -0.1], [0.3, 0.2, 0.1]);
    let place = Pose::from_parts(Vec3::new(0.1, -0.2, 0.3), rotation_about(Vec3::new(0.6, 0.0, 0.8), 0.7));
    let cuboid = Cuboid { centre: place.translation, half: Vec3::new(0.3, 0.2, 0.1), rotation: place.rotation };
    let (mesh, hull) = (mesh(&raw).placed(place), hull(&raw).placed(place));
    assert!((mesh.bounding_sphere().0 - hull.bounding_sphere().0).length() < 1e-12);
    assert!((mesh.bounding_sphere().1 - hull.bounding_sphere().1).abs() < 1e-12);
    let mut random = Pcg64::seed_from_u64(11);
    let mut inside = 0;
    for _ in 0..3000 {
        let [a, b] = [(); 2].map(|()| vector(&mut random, 0.7));
        let (by_mesh, by_hull) = (mesh.point_distance(a), hull.point_distance(a));
        assert!((by_mesh.distance - by_hull.distance).abs() < 1e-9, "{} {}", by_mesh.distance, by_hull.distance);
        let (by_mesh, by_hull) = (mesh.segment_distance(a, b), hull.segment_distance(a, b));
        if by_hull.distance > 1e-6 {
            assert!((by_mesh.distance - by_hull.distance).abs() < 1e-6, "{} {}", by_mesh.distance, by_hull.distance);
            assert!(((by_mesh.on_first - by_mesh.on_second).length() - by_mesh.distance).abs() < 1e-9);
            assert!(mesh.outward(&by_mesh).is_some());
        } else if by_hull.distance < -1e-6 {
            inside += 1;
            // No point of the segment is deeper than the segment, and it is deeper than the samples by little.
            let by_box = segment_cuboid(a, b, &cuboid);
            assert!(by_mesh.distance <= 0.0 && by_mesh.distance > by_box.distance - 1e-9, "{by_mesh:?} {by_box:?}");
            assert!(mesh.outward(&by_mesh).is_none());
            let point = |n: u32| a + (b - a) * (f64::from(n) / 200.0);
            let deepest = (0..=200).map(|n| mesh.point_distance(point(n)).distance).fold(f64::INFINITY, f64::min);
            // Half the way between two of the points that are looked at.
            assert!(by_mesh.distance - (b - a).length() / (2.0 * f64::from(SAMPLES - 1)) <= deepest + 1e-9);
        }
    }
    assert!(inside > 300, "{inside}");
}

#[test]
fn a_notch_is_free() {
    let (mesh, hull) = (mesh(&channel()), hull(&channel()));
    let (a, b) = (Vec3::new(0.3, -1.0, 0.3), Vec3::new(0.3, 1.0, 0.3));
    // 0.2 m to each wall and to the floor.
    assert!((mesh.segment_distance(a, b).distance - 0.2).abs() < 1e-12);
    assert!(hull.segment_distance(a, b).distance < -0.05);
    // Through a wall; within the floor, 50 mm deep.
    assert!(mesh.segment_distance(Vec3::new(0.3, 0.1, 0.3), Vec3::new(1.0, 0.1, 0.3)).distance <= 0.0);
    let within = mesh.segment_distance(Vec3::new(0.2, 0.1, 0.05), Vec3::new(0.4, 0.2, 0.05));
    assert!((within.distance + 0.05).abs() < 1e-12, "{}", within.distance);
}

#[test]
fn distances_change_by_no_more_than_the_points_move() {
    let mesh = mesh(&channel());
    let mut random = Pcg64::seed_from_u64(3);
    let mut kinds = [0; 3];
    for _ in 0..20_000 {
        let [a, b] = [(); 2].map(|()| Vec3::new(0.3, 0.15, 0.2) + vector(&mut random, 0.4));
        let size = if random.next_u32().is_multiple_of(2) { 0.3 } else { 0.01 };
        let [c, d] = [a, b].map(|end| end + vector(&mut random, size));
        let moved = (c - a).length().max((d - b).length());
        let (before, after) = (mesh.segment_distance(a, b).distance, mesh.segment_distance(c, d).distance);
        assert!((before - after).abs() <= moved + 1e-8, "{before} {after} {moved}");
        kinds[usize::from(before <= 0.0) + usize::from(after <= 0.0)] += 1;
        let (before, after) = (mesh.point_distance(a).distance, mesh.point_distance(c).distance);
        assert!((before - after).abs() <= (c - a).length() + 1e-9, "{before} {after}");
    }
    assert!(kinds.iter().all(|count| *count > 1000), "{kinds:?}");
}

#[test]
fn the_nearest_point_stays_where_it_is_told_to() {
    let mesh = mesh(&channel());
    let mut random = Pcg64::seed_from_u64(8);
    let mut tighter = 0;
    for _ in 0..20_000 {
        let point = Vec3::new(0.3, 0.15, 0.2) + vector(&mut random, 0.5);
        let near = mesh.point_distance(point);
        let moved = vector(&mut random, 0.1);
        let movement = moved.length();
        let (centre, radius) = mesh.nearest_within(point, &near, movement);
        let then = mesh.point_distance(point + moved);
        let at = if then.distance > 0.0 { then.on_second } else { point + moved };
        assert!((at - centre).length() <= radius + 1e-8, "{at} is not within {radius} of {centre}");
        tighter += u32::from(radius < near.distance + 2.0 * movement);
    }
    assert!(tighter > 2000, "{tighter}");
}

#[test]
fn a_surface_is_closed_open_turned_or_flat() {
    let good = merged(&channel());
    assert_eq!(good.points.len(), 16);
    assert!((good.volume() - 0.3 * (0.6 * 0.1 + 2.0 * 0.3 * 0.1)).abs() < 1e-12);
    // Inside out as a whole: turned round.
    assert!((Surface::new(good.clone().turned()).unwrap().triangles().volume() - good.volume()).abs() < 1e-12);
    let mut open = good.clone();
    open.triangles.pop();
    assert_eq!(open.closed(), Err(Flaw::Open(3)));
    let mut turned = good.clone();
    turned.triangles[0].swap(0, 1);
    assert_eq!(turned.closed(), Err(Flaw::Turned(3)));
    let sheet = Triangles { points: good.points.clone(), triangles: vec![[0, 1, 4], [1, 0, 4]] };
    assert_eq!(sheet.closed(), Err(Flaw::Flat));
    assert_eq!(Triangles::default().closed(), Err(Flaw::Flat));
}

#[test]
fn triangles_without_area_and_hollows_tell_no_lies() {
    // A corner in the middle of an edge, for the triangle on one side of it alone: the gap is a triangle without area.
    let (mut points, mut triangles) = meshes::cuboid([0.0; 3], [1.0; 3]);
    let edge = triangles.iter().position(|t| *t == [0, 3, 1]).unwrap();
    points.push([0.5, 0.5, 0.0]);
    triangles[edge] = [0, 8, 1];
    triangles.extend([[8, 3, 1], [0, 3, 8]]);
    // A hollow in it, whose surface is turned inwards, and a body in the hollow.
    let hollow = meshes::cuboid([0.25; 3], [0.75; 3]);
    let body = meshes::cuboid([0.4; 3], [0.6; 3]);
    for (more, inwards) in [(hollow, true), (body, false)] {
        let before = u32::try_from(points.len()).unwrap();
        points.extend(more.0);
        let other = |[a, b, c]: [u32; 3]| if inwards { [a, c, b] } else { [a, b, c] };
        triangles.extend(more.1.into_iter().map(|t| other(t).map(|corner| corner + before)));
    }
    let solid = mesh(&(points, triangles));
    let mut random = Pcg64::seed_from_u64(21);
    for _ in 0..20_000 {
        let point = Vec3::splat(0.5) + vector(&mut random, 0.8);
        let within = |half: f64| (point - 0.5).abs().max_element() < half;
        let inside = within(0.1) || (within(0.5) && !within(0.25));
        assert_eq!(solid.point_distance(point).distance < 0.0, inside, "{point}");
    }
    // Exactly on edges and corners: no panic, and no side is far from the surface.
    for corner in [Vec3::ZERO, Vec3::ONE, Vec3::new(0.5, 0.5, 0.0), Vec3::new(0.3, 0.3, 0.0)] {
        assert!(solid.point_distance(corner).distance.abs() < 1e-12);
        assert!(solid.segment_distance(corner, corner).distance.abs() < 1e-12);
    }
}
