//! Tests of bodies as boxes: by hand, and that nothing is filled that the body does not fill.

use rand_core::{Rng, SeedableRng};
use rand_pcg::Pcg64;

use super::*;
use crate::geometry::{rotation_about, test_meshes as meshes};

type Raw = (Vec<[f64; 3]>, Vec<[u32; 3]>);

fn merged((points, triangles): &Raw) -> Triangles {
    Triangles::merged(&points.iter().map(|p| Vec3::from_array(*p)).collect::<Vec<_>>(), triangles)
}

/// A fence panel 2 m wide, 1.4 m high and 20 mm thick, with an opening of 0.15 m.
fn panel_with_opening() -> Raw {
    let corners = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.4], [0.0, 1.4], [1.0, 0.8], [1.15, 0.8], [1.15, 0.95], [1.0, 0.95]];
    // Between the outer and the inner corners.
    let caps = [[0, 1, 5], [0, 5, 4], [1, 2, 6], [1, 6, 5], [2, 3, 7], [2, 7, 6], [3, 0, 4], [3, 4, 7]];
    let (points, mut triangles) = meshes::prism(&corners, &caps, 0.02);
    // The sides of the prism go from corner to corner as if it had one outline: once round outside, once inside.
    triangles.truncate(16);
    for i in 0..4 {
        let j = (i + 1) % 4;
        triangles.extend([[i, 8 + i, 8 + j], [i, 8 + j, j]]);
        let (i, j) = (i + 4, j + 4);
        triangles.extend([[j, 8 + j, 8 + i], [j, 8 + i, i]]);
    }
    (points, triangles)
}

/// An L: 0.63 m wide, 0.47 m high, legs of 0.11 m.
fn angle() -> Raw {
    let corners = [[0.0, 0.0], [0.63, 0.0], [0.63, 0.11], [0.11, 0.11], [0.11, 0.47], [0.0, 0.47]];
    meshes::prism(&corners, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]], 0.3)
}

/// A ball of flat faces.
fn ball(radius: f64) -> Raw {
    let (rings, around) = (16, 24);
    let mut points = vec![[0.0, 0.0, -radius]];
    for ring in 1..rings {
        let (z, r) = libm::sincos(std::f64::consts::PI * (f64::from(ring) / f64::from(rings) - 0.5));
        for n in 0..around {
            let (s, c) = libm::sincos(std::f64::consts::TAU * f64::from(n) / f64::from(around));
            points.push([radius * r * c, radius * r * s, radius * z]);
        }
    }
    points.push([0.0, 0.0, radius]);
    let at = |ring: u32, n: u32| 1 + (ring - 1) * around + n % around;
    let last = u32::try_from(points.len()).unwrap() - 1;
    let mut triangles = Vec::new();
    for n in 0..around {
        triangles.extend([[0, at(1, n + 1), at(1, n)], [last, at(rings - 1, n), at(rings - 1, n + 1)]]);
        for ring in 1..rings - 1 {
            triangles.push([at(ring, n), at(ring, n + 1), at(ring + 1, n + 1)]);
            triangles.push([at(ring, n), at(ring + 1, n + 1), at(ring + 1, n)]);
        }
    }
    (points, triangles)
}

/// The boxes in a body, after points in them and in no box were looked at: how much of the volume is filled.
fn within(body: &Triangles, resolution: f64) -> (Vec<Cuboid>, f64) {
    let surface = Surface::new(body.clone()).unwrap();
    let (boxes, filled) = inside(&surface, resolution, 2000).unwrap();
    let mut random = Pcg64::seed_from_u64(4);
    let mut unit = || f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0;
    for cuboid in &boxes {
        for _ in 0..200 {
            let at = cuboid.centre + cuboid.rotation * (cuboid.half * Vec3::new(unit(), unit(), unit()));
            assert!(surface.holds(at) || (surface.nearest(at) - at).length() < 1e-5, "{at}");
        }
    }
    // Against counting: the boxes may overlap.
    let (low, high) = surface.extent();
    let mut hits = 0;
    for _ in 0..20_000 {
        let at = (low + high) * 0.5 + (high - low) * 0.5 * Vec3::new(unit(), unit(), unit());
        let hit = |c: &Cuboid| (c.rotation.inverse() * (at - c.centre)).abs().cmple(c.half).all();
        hits += usize::from(boxes.iter().any(hit));
    }
    let counted = f64::from(u32::try_from(hits).unwrap()) / 20_000.0 * (high - low).element_product();
    assert!(
        (counted - filled).abs() < 0.05 * filled.max(0.05 * body.volume()),
        "{counted} m³ counted, {filled} m³ told"
    );
    (boxes, filled / body.volume())
}

#[test]
fn a_box_is_one_box_wherever_it_is() {
    let raw = meshes::cuboid([0.1, 0.2, 0.3], [1.3, 0.9, 0.32]);
    let turn = rotation_about(Vec3::new(0.48, 0.6, 0.64), 0.8);
    let body = merged(&raw).mapped(|point| turn * point);
    let found = as_box(&body).unwrap();
    assert!((found.centre - turn * Vec3::new(0.7, 0.55, 0.31)).length() < 1e-9, "{found:?}");
    let mut size = (found.half * 2.0).to_array();
    size.sort_by(f64::total_cmp);
    assert!(size.iter().zip([0.02, 0.7, 1.2]).all(|(a, b)| (a - b).abs() < 1e-9), "{size:?}");
    // The thinnest edge points the way z was turned.
    let thin = (0..3).min_by(|a, b| found.half[*a].total_cmp(&found.half[*b])).unwrap();
    let axis = found.rotation * [Vec3::X, Vec3::Y, Vec3::Z][thin];
    assert!((axis.dot(turn * Vec3::Z).abs() - 1.0).abs() < 1e-9);
}

#[test]
fn a_small_opening_stays_open() {
    let body = merged(&panel_with_opening());
    assert!(body.closed().is_ok() && body.volume() > 0.99 * 2.0 * 1.4 * 0.02, "{}", body.volume());
    assert_eq!(as_box(&body), None);
    let (boxes, share) = within(&body, 0.05);
    // Exactly: cut along its faces, though it is thinner than a cell. Left, right, above, below.
    assert!((share - 1.0).abs() < 1e-6 && boxes.len() == 4, "{share} {}", boxes.len());
    let through = |c: &Cuboid| (Vec3::new(1.07, 0.01, 0.87) - c.centre).abs().cmple(c.half).all();
    assert!(!boxes.iter().any(through));
    // Flat, the same: nothing is known of its inside, and it is no rectangle.
    let flat = Triangles::merged(&body.points, &body.triangles[..8]);
    assert_eq!(as_box(&flat), None);
}

#[test]
fn a_folded_sheet_is_no_box() {
    // 0.8 mm thick, folded once: every triangle is near a side of the box around it.
    for thick in [0.0005, 0.0008, 0.002] {
        let corners = [[0.0, 0.0], [1.0, 0.0], [1.0, thick], [thick, thick], [thick, 1.5], [0.0, 1.5]];
        let sheet = merged(&meshes::prism(&corners, &[[0, 1, 2], [0, 2, 3], [0, 3, 4], [0, 4, 5]], 2.0));
        assert!(sheet.closed().is_ok() && as_box(&sheet).is_none(), "{thick} m");
        let (boxes, _) = inside(&Surface::new(sheet).unwrap(), 0.05, 2000).unwrap();
        let holds = |point: Vec3| {
            let inside = |c: &Cuboid| (c.rotation.inverse() * (point - c.centre)).abs().cmple(c.half).all();
            boxes.iter().any(inside)
        };
        assert!(!holds(Vec3::new(0.5, 0.7, 1.0)), "air is filled");
    }
}

#[test]
fn an_angle_a_ball_and_a_turned_angle_are_filled_from_inside() {
    let (boxes, share) = within(&merged(&angle()), 0.05);
    assert!((share - 1.0).abs() < 1e-6 && boxes.len() == 2, "{share} {}", boxes.len());
    let turn = rotation_about(Vec3::new(0.0, 0.6, 0.8), 0.5);
    let (boxes, share) = within(&merged(&angle()).mapped(|point| turn * point), 0.05);
    assert!((share - 1.0).abs() < 1e-4 && boxes.len() == 2, "{share} {}", boxes.len());
    let (coarse, fine) = (within(&merged(&ball(0.4)), 0.1), within(&merged(&ball(0.4)), 0.04));
    assert!(coarse.1 > 0.4 && fine.1 > 0.75 && fine.1 < 1.0, "{} {}", coarse.1, fine.1);
    assert!(coarse.0.len() < fine.0.len() && fine.0.len() < 600, "{} {}", coarse.0.len(), fine.0.len());
}

#[test]
fn sheets_are_rectangles_or_nothing() {
    let corners = [Vec3::ZERO, Vec3::X, Vec3::new(1.0, 0.0, 2.0), Vec3::new(0.0, 0.0, 2.0), Vec3::new(0.5, 0.0, 1.0)];
    let sheet = |triangles: &[[u32; 3]]| as_box(&Triangles::merged(&corners, triangles));
    for whole in [
        &[[0, 1, 2], [0, 2, 3]][..],
        &[[0, 1, 2], [0, 2, 1], [2, 3, 0], [3, 2, 0]],
        &[[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]],
    ] {
        let found = sheet(whole).unwrap();
        assert!((found.centre - Vec3::new(0.5, 0.0, 1.0)).length() < 1e-12);
        assert!((found.half.element_product() - 0.5 * 1.0 * 0.001).abs() < 1e-12, "{found:?}");
    }
    assert_eq!(sheet(&[[0, 1, 2]]), None);
    assert_eq!(sheet(&[[0, 1, 4], [1, 2, 4], [2, 3, 4]]), None);
    assert_eq!(sheet(&[]), None);
}

#[test]
fn parts_have_no_corner_in_common_and_work_is_bounded() {
    let (mut points, mut triangles) = meshes::cuboid([0.0; 3], [1.0; 3]);
    let other = meshes::cuboid([2.0; 3], [3.0; 3]);
    points.extend(other.0);
    triangles.extend(other.1.iter().map(|t| t.map(|corner| corner + 8)));
    let parts = parts(&merged(&(points, triangles)));
    assert_eq!(parts.len(), 2);
    assert!(parts.iter().all(|part| part.points.len() == 8 && (part.volume() - 1.0).abs() < 1e-12));
    let surface = Surface::new(merged(&ball(1.0))).unwrap();
    assert_eq!(inside(&surface, 0.01, 2000), Err(TooMany));
    assert_eq!(inside(&surface, 0.1, 20), Err(TooMany));
    let large = Surface::new(merged(&ball(400.0))).unwrap();
    assert_eq!(inside(&large, 0.05, 2000), Err(TooMany));
}
