//! What is taken to hold of everybody in a box is looked at of people in it, one by one.

use super::*;
use crate::cell::DetectionZone;
use crate::geometry::{Capsule, rotation_about};
use crate::human::{Anthropometry, Body};
use crate::search::Rng;
use crate::stop::Stop;

fn uniform(rng: &mut Rng, low: f64, high: f64) -> f64 {
    low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
}

/// A plane 0.8 m wide and 1.2 m high that is turned so, with people before it.
fn curtain(turned: f64) -> DetectionPlane {
    let rotation = rotation_about(Vec3::Z, turned);
    let plane = Cuboid { centre: Vec3::new(0.0, 0.0, 0.6), half: Vec3::new(0.4, 0.0, 0.6), rotation };
    DetectionPlane::new(0, &DetectionZone::Plane(plane), rotation * Vec3::new(0.0, -3.0, 0.0), &[]).unwrap()
}

/// Somebody in a box, mostly at its edges.
fn somebody(rng: &mut Rng, at: &PoseBox) -> PoseBox {
    let mut within = |middle: f64| middle + at.half_m * uniform(rng, -2.0, 2.0).clamp(-1.0, 1.0);
    PoseBox::point([within(at.xy_m[0]), within(at.xy_m[1])], at.heading_rad)
}

#[test]
fn who_is_behind_a_plane_or_gets_through_it_only_is_so_everywhere_in_a_box() {
    let mut rng = Rng::new(7);
    let ball = |at: Vec3| Solid::Capsule(Capsule { a: at, b: at, radius: 0.1 });
    let (mut all, mut some) = ([0, 0], [0, 0]);
    for _ in 0..3000 {
        let turned = uniform(&mut rng, 0.0, 6.0);
        let curtain = curtain(turned);
        let along = |x: f64, y: f64, z: f64| rotation_about(Vec3::Z, turned) * Vec3::new(x, y, z);
        let link = ball(along(uniform(&mut rng, -0.3, 0.3), 0.5, uniform(&mut rng, 0.2, 1.0)));
        let middle = along(uniform(&mut rng, -0.8, 0.8), uniform(&mut rng, -0.9, 0.3), 0.0);
        let (xy_m, half_m) = ([middle.x, middle.y], uniform(&mut rng, 0.0, 0.2));
        let at = PoseBox { xy_m, half_m, heading_rad: 0.0, half_rad: 3.0 };
        let from_hip = (0.9, uniform(&mut rng, 0.5, 1.2));
        let is = |at: &PoseBox| [gets_there_through_it_only(&curtain, from_hip, &link, at), is_behind(&curtain, at)];
        let of_box = is(&at);
        for _ in 0..20 {
            let of_one = is(&somebody(&mut rng, &at));
            for number in 0..2 {
                assert!(of_one[number] || !of_box[number], "{number}: {at:?}");
                all[number] += usize::from(of_box[number]);
                some[number] += usize::from(of_one[number] && !of_box[number]);
            }
        }
    }
    assert!(all.iter().chain(&some).all(|count| *count > 500), "{all:?} {some:?}");
}

/// A hand that is 2.0 m/s fast is 0.04 m behind after 20 ms; one of somebody who stands before it and stretches 1.1 m from a hip 0.9 m
/// high gets over a plane 1.2 m high: 0.5 m to its edge, and 0.6 m on.
#[test]
fn by_hand_who_leans_through() {
    assert!((depth_m(SINCE_CLEAR, 0.02, 1.6) - 0.04).abs() < 1e-12);
    let curtain = curtain(0.0);
    let one = PoseBox::point([0.0, -0.4], 0.0);
    for (far, through_only) in [(0.69, false), (0.71, true)] {
        let at = Vec3::new(0.0, far, 1.2);
        let link = Solid::Capsule(Capsule { a: at, b: at, radius: 0.1 });
        assert_eq!(gets_there_through_it_only(&curtain, (0.9, 1.1), &link, &one), through_only, "{far}");
    }
}

#[test]
fn a_box_on_floor_to_which_others_get_holds_people_of_whom_nothing_was_told() {
    let body = Body::new(&Anthropometry::default()).unwrap();
    let floor = Floor::new(&body, &[], ([0.0, 0.0], [1.0, 1.0]), 0.1, &Stop::default()).unwrap();
    let mut others = vec![false; floor.cells()];
    // From 0.6 to 0.7 m along x and from 0.3 to 0.4 m along y.
    others[3 * 10 + 6] = true;
    let told_of = SignalledPeople { come_before: true, others };
    for (xy_m, half_m, may) in [
        ([0.65, 0.35], 0.01, true),
        ([0.65, 0.55], 0.16, true),
        ([0.65, 0.55], 0.14, false),
        ([0.5, 0.35], 0.11, true),
        ([0.5, 0.35], 0.09, false),
        // Beyond the rectangle nothing is known of anybody.
        ([0.95, 0.95], 0.04, false),
        ([0.95, 0.95], 0.06, true),
    ] {
        let at = PoseBox { xy_m, half_m, heading_rad: 0.0, half_rad: 0.1 };
        assert_eq!(told_of.may_have_come_another_way(&floor, &at), may, "{xy_m:?} {half_m}");
    }
}

#[test]
fn everybody_on_a_cell_of_the_floor_is_in_its_box() {
    let body = Body::new(&Anthropometry::default()).unwrap();
    let floor = Floor::new(&body, &[], ([-0.4, 0.2], [0.6, 0.8]), 0.05, &Stop::default()).unwrap();
    for cell in 0..floor.cells() {
        let at = everybody_in(&floor, cell);
        let corner = floor.corner((cell % floor.size()[0], cell / floor.size()[0]));
        for (middle, low) in at.xy_m.into_iter().zip(corner) {
            let ends = [middle - at.half_m, middle + at.half_m];
            assert!((ends[0] - low).abs() < 1e-9 && (ends[1] - low - 0.05).abs() < 1e-9, "{at:?}");
        }
        assert!(at.half_rad >= std::f64::consts::PI);
    }
}
