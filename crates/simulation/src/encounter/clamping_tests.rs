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
