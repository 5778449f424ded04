//! Which arms may be searched for a contact.

use super::PlacedBody;
use super::obstacles::capsule_hits;
use super::part::Side;
use super::reach::certainly_crosses;
use crate::geometry::Cuboid;

/// Whether the arm on this side is on the human's side of every obstacle.
///
/// Walking is blocked by the middle of the body (0.14 m), but shoulders reach farther out: beside a thin wall a shoulder
/// joint may lie in it or behind it. From there the arm would act on the far side of the wall, so it is not available.
/// The line from the middle of the trunk to the joint decides; a wall that is merely nearer to the joint than the
/// shoulder is thick leaves the arm available, and the arm's own tests see that wall.
#[must_use]
pub fn is_available(placed: &PlacedBody, side: Side, obstacles: &[Cuboid]) -> bool {
    let line = placed.shoulder_line(side);
    !obstacles.iter().any(|obstacle| capsule_hits(&line, obstacle))
}

/// Whether the arm is certainly not available in any pose in which neither end of the line is farther than `moves_m` from
/// where it is in this one.
#[must_use]
pub fn is_certainly_unavailable(placed: &PlacedBody, side: Side, obstacles: &[Cuboid], moves_m: f64) -> bool {
    let line = placed.shoulder_line(side);
    obstacles.iter().any(|obstacle| certainly_crosses(obstacle, [line.a, line.b], moves_m))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Rotation, Vec3};
    use crate::human::{Anthropometry, BendFraction, Body, Posture};

    const NORTH: f64 = std::f64::consts::FRAC_PI_2;

    /// A fence along y, 20 mm thick, 2 m high, its middle at `x`.
    fn fence(x: f64) -> Cuboid {
        Cuboid { centre: Vec3::new(x, 0.1, 1.0), half: Vec3::new(0.01, 1.9, 1.0), rotation: Rotation::IDENTITY }
    }

    fn available(fence_x: f64, x: f64, heading: f64, posture: Posture) -> [bool; 2] {
        let body = Body::new(&Anthropometry::default()).unwrap();
        let placed = body.placed(Vec3::new(x, -0.2, 0.0), heading, posture, BendFraction::FULL);
        Side::BOTH.map(|side| is_available(&placed, side, &[fence(fence_x)]))
    }

    /// The fence of the sensor mat cell at x = -1: standing along it with the trunk's middle outside and the right
    /// shoulder (0.19 m out) behind the panel must not lend that arm to the inside.
    #[test]
    fn shoulder_behind_or_inside_a_wall_is_not_available() {
        assert_eq!(available(-1.0, -1.16, NORTH, Posture::Upright), [true, false], "behind");
        assert_eq!(available(-1.0, -1.19, NORTH, Posture::Upright), [true, false], "inside");
        assert_eq!(available(-1.0, -0.84, NORTH, Posture::Upright), [false, true], "from the other side");
        assert_eq!(available(-1.0, -1.16, -NORTH, Posture::Upright), [false, true], "facing the other way");
    }

    #[test]
    fn shoulder_near_a_wall_stays_available() {
        assert_eq!(available(-1.0, -1.201, NORTH, Posture::Upright), [true, true], "1 mm before the panel");
        assert_eq!(available(-1.0, -1.15, 0.0, Posture::Upright), [true, true], "facing the panel");
    }

    /// The line tilts with the trunk: bent towards the fence by 30 degrees the right shoulder is 0.48 sin 30 +
    /// 0.19 cos 30 = 0.40 m out; the left one 0.24 - 0.16 = 0.08 m towards the fence.
    #[test]
    fn line_tilts_with_the_trunk() {
        assert_eq!(available(-1.0, -1.42, NORTH, Posture::Right), [true, true]);
        assert_eq!(available(-1.0, -1.40, NORTH, Posture::Right), [true, false]);
        // Now the fence is between the trunk's middle at shoulder height (0.24 m) and the left joint.
        assert_eq!(available(-1.0, -1.16, NORTH, Posture::Right), [false, true]);
    }
}
