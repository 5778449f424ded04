//! The rule by hand, on rays and boxes of which one sees what comes out.

use super::*;
use crate::geometry::{Rotation, rotation_about};

fn table() -> Cuboid {
    Cuboid { centre: Vec3::new(0.0, 0.0, 0.4), half: Vec3::new(0.5, 0.5, 0.4), rotation: Rotation::IDENTITY }
}

#[test]
fn rays_enter_boxes_through_the_face_that_they_see() {
    let down = Vec3::new(0.0, 0.0, -1.0);
    let Enters::At(after, outward) = enters(Vec3::new(0.1, 0.2, 0.9), down, &table()) else { panic!("it enters") };
    assert!((after - 0.1).abs() < 1e-12 && (outward - Vec3::Z).length() < 1e-12);
    // Beside it, away from it, inside of it.
    assert!(matches!(enters(Vec3::new(0.6, 0.0, 0.9), down, &table()), Enters::Never));
    assert!(matches!(enters(Vec3::new(0.1, 0.2, 0.9), Vec3::Z, &table()), Enters::Never));
    assert!(matches!(enters(Vec3::new(0.1, 0.2, 0.7), down, &table()), Enters::Inside));
    // Turned by a right angle about x it is seen from its side.
    let turned = Cuboid { rotation: rotation_about(Vec3::X, std::f64::consts::FRAC_PI_2), ..table() };
    let Enters::At(after, outward) = enters(Vec3::new(0.0, 0.0, 1.0), down, &turned) else { panic!("it enters") };
    assert!((after - 0.1).abs() < 1e-12 && (outward - Vec3::Z).length() < 1e-9, "{after} {outward}");
}

/// A gap of 90 mm that closes at 0.2 m/s holds a hand, which needs 100 mm, and no part that is content with less; with 50 mm that the
/// robot goes on one of 140 mm does.
#[test]
fn gaps_hold_what_needs_more_room() {
    let strike = Strike::new(
        29.1,
        5.0,
        crate::hazard::criterion::Criteria::default(),
        crate::hazard::criterion::pressure::LinkContact::default(),
    );
    let clamped = |gap_m: f64, travel_m: f64| Clamped {
        at: Vec3::ZERO,
        toward: Vec3::Z,
        against: Against::Floor,
        gap_m,
        travel_m,
        closing_m_s: 0.2,
    };
    // m_R = 19.55 kg; hand 0.2 sqrt(19.55 * 75e3) = 242.2 N of 135 N.
    let ratio = |gap, travel, region| ratio(&clamped(gap, travel), region, &strike);
    assert!((ratio(0.09, 0.0, BodyRegion::Hand) - 242.18 / 135.0).abs() < 1e-3);
    assert!(ratio(0.11, 0.0, BodyRegion::Hand) == 0.0 && ratio(0.11, 0.0, BodyRegion::LowerArm) > 0.0);
    assert!(ratio(0.14, 0.05, BodyRegion::Hand) > 1.0 && ratio(0.14, 0.0, BodyRegion::Hand) == 0.0);
    assert!(ratio(0.49, 0.0, BodyRegion::Chest) > 0.0 && ratio(0.51, 0.0, BodyRegion::Chest) == 0.0);
}

/// What is in the way decides where a link clamps: a frame remembers it for each set of obstacles by itself.
#[test]
fn places_that_clamp_are_remembered_by_what_is_in_the_way() {
    let clamped = Clamped {
        at: Vec3::ZERO,
        toward: Vec3::Z,
        against: Against::Floor,
        gap_m: 0.1,
        travel_m: 0.0,
        closing_m_s: 0.2,
    };
    let (pinches, pinch) = (Pinches::default(), Pinch { link: 3, clamped });
    assert!(pinches.of(0, 3, Vec::new).is_empty());
    assert_eq!(*pinches.of(1, 3, || vec![pinch]), [pinch]);
    assert!(pinches.of(1, 2, Vec::new).is_empty());
    // None is worked out twice.
    assert!(pinches.of(0, 3, || vec![pinch]).is_empty());
    assert_eq!(*pinches.clone().of(1, 3, Vec::new), [pinch]);
}
