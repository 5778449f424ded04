//! Places and headings around one, all at once: what a search over everything that a person may do halves until all of it is
//! settled.
//!
//! Everything of a body moves with the place as far as the place does, and with the heading along a circle about the upright
//! axis between the feet. So what is known of the middle holds for all of the box, give or take that movement.

use std::f64::consts::{PI, SQRT_2, TAU};

use serde::{Deserialize, Serialize};

use crate::geometry::Vec3;

/// Places in an upright square of the floor plan, and headings on an arc.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct PoseBox {
    /// Middle of the places, floor plan, m.
    pub xy_m: [f64; 2],
    /// Half an edge of the square, m.
    pub half_m: f64,
    /// Middle of the headings, from +x towards +y, rad.
    pub heading_rad: f64,
    /// Half the arc, rad; pi for any heading.
    pub half_rad: f64,
}

impl PoseBox {
    /// A place and a heading alone.
    #[must_use]
    pub const fn point(xy_m: [f64; 2], heading_rad: f64) -> Self {
        Self { xy_m, half_m: 0.0, heading_rad, half_rad: 0.0 }
    }

    /// The middle of the places, on the floor, m.
    #[must_use]
    pub fn position(&self) -> Vec3 {
        Vec3::new(self.xy_m[0], self.xy_m[1], 0.0)
    }

    /// How far a place can be from the middle, m.
    #[must_use]
    pub fn place_moves_m(&self) -> f64 {
        SQRT_2 * self.half_m
    }

    /// How far a point of the body can be from where it is in the middle of the box, m, if it is no farther than `lever_m` from
    /// the axis between the feet.
    #[must_use]
    pub fn moves_m(&self, lever_m: f64) -> f64 {
        self.place_moves_m() + 2.0 * lever_m * libm::sin(0.5 * self.half_rad.min(PI))
    }

    /// Middle and radius of a ball, m, that holds whatever is no farther than `far_m` from the point `height_m` above the feet of
    /// anybody in the box.
    #[must_use]
    pub fn around(&self, height_m: f64, far_m: f64) -> (Vec3, f64) {
        (self.position() + Vec3::Z * height_m, far_m + self.place_moves_m())
    }

    /// Boxes whose union it is, of equal arcs.
    pub fn arcs(&self, count: u32) -> impl Iterator<Item = Self> + use<> {
        let whole = Self { half_rad: self.half_rad.min(PI), ..*self };
        let half_rad = whole.half_rad / f64::from(count.max(1));
        let first_rad = whole.heading_rad - whole.half_rad;
        (0..count.max(1)).map(move |number| Self {
            heading_rad: first_rad + f64::from(2 * number + 1) * half_rad,
            half_rad,
            ..whole
        })
    }

    /// Parts whose union it is: quarters of the square, or halves of the arc, whichever moves a point more that is `lever_m`
    /// from the axis.
    #[must_use]
    pub fn parts(&self, lever_m: f64) -> Vec<Self> {
        if 2.0 * self.place_moves_m() >= self.moves_m(lever_m) {
            self.quarters().to_vec()
        } else {
            self.halves().to_vec()
        }
    }

    /// The quarters of the square.
    #[must_use]
    pub fn quarters(&self) -> [Self; 4] {
        let half_m = 0.5 * self.half_m;
        let [x, y] = self.xy_m;
        let part = |(i, j): (f64, f64)| Self { xy_m: [x + i * half_m, y + j * half_m], half_m, ..*self };
        [(-1.0, -1.0), (1.0, -1.0), (-1.0, 1.0), (1.0, 1.0)].map(part)
    }

    /// The halves of the arc.
    #[must_use]
    pub fn halves(&self) -> [Self; 2] {
        let half_rad = 0.5 * self.half_rad.min(PI);
        let part =
            |side: f64| Self { heading_rad: (self.heading_rad + side * half_rad).rem_euclid(TAU), half_rad, ..*self };
        [-1.0, 1.0].map(part)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::rotation_about;
    use crate::search::Rng;

    fn uniform(rng: &mut Rng, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
    }

    /// Random poses of random boxes: no point moves farther than told, some nearly as far; and each pose is in a part.
    #[test]
    fn points_move_no_farther_than_told_and_parts_leave_nothing_out() {
        let mut rng = Rng::new(5);
        let (mut nearly, mut nearly_outside) = (0, 0);
        for _ in 0..4000 {
            let of = PoseBox {
                xy_m: [uniform(&mut rng, -2.0, 2.0), uniform(&mut rng, -2.0, 2.0)],
                half_m: uniform(&mut rng, 0.0, 0.4),
                heading_rad: uniform(&mut rng, 0.0, TAU),
                half_rad: uniform(&mut rng, 0.0, PI),
            };
            let lever = uniform(&mut rng, 0.0, 1.2);
            let along = uniform(&mut rng, 0.0, TAU);
            let point = Vec3::new(lever * libm::cos(along), lever * libm::sin(along), uniform(&mut rng, 0.0, 2.0));
            let sides = [(); 3].map(|()| if rng.below(4) == 0 { 1.0 } else { uniform(&mut rng, -1.0, 1.0) });
            let xy = [of.xy_m[0] + sides[0] * of.half_m, of.xy_m[1] + sides[1] * of.half_m];
            let heading = of.heading_rad + sides[2] * of.half_rad;
            let at = |position: Vec3, heading: f64| position + rotation_about(Vec3::Z, heading) * point;
            let moved = (at(Vec3::new(xy[0], xy[1], 0.0), heading) - at(of.position(), of.heading_rad)).length();
            let told = of.moves_m(lever);
            assert!(moved <= told + 1e-12, "{moved} beyond {told}: {of:?}");
            nearly += usize::from(moved > 0.9 * told);
            let holds = |part: &PoseBox| {
                let turn = (heading - part.heading_rad + PI).rem_euclid(TAU) - PI;
                (0..2).all(|axis| (xy[axis] - part.xy_m[axis]).abs() <= part.half_m + 1e-12)
                    && turn.abs() <= part.half_rad + 1e-12
            };
            let parts = of.parts(lever);
            assert!(parts.iter().any(holds), "{of:?}");
            assert!(parts.iter().all(|part| part.moves_m(lever) < told), "{of:?}");
            assert!(of.arcs(1 + u32::try_from(rng.below(5)).unwrap()).any(|part| holds(&part)), "{of:?}");
            let far = uniform(&mut rng, 0.0, 1.2);
            let (middle, radius) = of.around(point.z, far);
            let end = Vec3::new(xy[0], xy[1], point.z) + Vec3::new(libm::cos(along), libm::sin(along), 0.0) * far;
            let gap = radius - (end - middle).length();
            assert!(gap >= -1e-12, "{end:?} outside of {middle:?} {radius}");
            nearly_outside += usize::from(gap < 0.02 * of.half_m);
        }
        assert!(nearly > 50 && nearly_outside > 5, "{nearly} {nearly_outside}");
    }
}
