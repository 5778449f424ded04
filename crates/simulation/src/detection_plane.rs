//! Reaching through a light curtain: where a hand can be, given when it broke the plane.
//!
//! Arms are posed at once, so an arm behind a light curtain must have broken its plane some time before: a contact at
//! depth p counts only if the plane was broken at least p / 2.0 s earlier (ISO 13855, K = 2000 mm/s for upper limbs).
//! Time being counted in communication steps, a plane first reported broken `k` samples before the instant may have been
//! passed up to `k + 1` steps before, so the hand may be up to `2.0 (k + 1) h` deep: nothing possible is excluded.
//!
//! A door is the same with another switch. So are the buttons of a two-hand control for the hands that let them go, but
//! not for the rest of the body; and hands that have been free for long are held by nothing.

use crate::cell::{DetectionZone, Sensor, Workcell};
use crate::geometry::distance::{point_segment, segment_segment};
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::standards::iso_13855::HAND_SPEED_M_S;

/// Half the thickness of a plane that arms must not pass, m.
const HALF_THICKNESS_M: f64 = 0.005;

/// Half the width, height and depth of the space behind a plane that is out of a hand's reach in time, m: more than any
/// arm is long.
const BEYOND_M: f64 = 3.0;

/// An upright plane that no arm passes unseen.
#[derive(Clone, Debug, PartialEq)]
pub struct DetectionPlane {
    /// Index of its sensor.
    pub sensor: usize,
    /// Where it is, a box without thickness.
    pub plane: Cuboid,
    /// A point before it, from where people come, m.
    from: Vec3,
    /// Whether it tells of hands only: a two-hand control.
    pub hands_only: bool,
    /// What it closes with the guarding beside it.
    pub closed: Closed,
    /// Whether somebody in a low posture has room below: that it tells of the body then says nothing of how long it has been there.
    pub lets_below: bool,
    /// How far legs of who is low get behind it below its lower edge before the rest of the body is in it, m.
    pub legs_below_m: f64,
}

impl DetectionPlane {
    /// All those of a cell, whose person begins at `start`.
    #[must_use]
    pub fn all(cell: &Workcell, start: Vec3, obstacles: &[Cuboid]) -> Vec<Self> {
        let lowest_m = cell.repertoire.low().iter().map(|low| cell.body.height_m(*low)).fold(f64::INFINITY, f64::min);
        let curtain = |(number, Sensor { zone, .. }): (usize, &Sensor)| {
            let curtain = Self::new(number, zone, start, obstacles)?;
            let lets_below = !curtain.hands_only && curtain.closed.low.is_some_and(|low_m| low_m >= lowest_m);
            let below = |low_m: f64| cell.repertoire.low().iter().map(move |low| cell.body.legs_below_m(*low, low_m));
            let legs_below_m = curtain.closed.low.map_or(0.0, |low_m| below(low_m).fold(0.0, f64::max));
            Some(Self { lets_below, legs_below_m, ..curtain })
        };
        cell.sensors.iter().enumerate().filter_map(curtain).collect()
    }

    /// That of a sensor whose zone has a plane.
    #[must_use]
    pub fn new(sensor: usize, zone: &DetectionZone, start: Vec3, obstacles: &[Cuboid]) -> Option<Self> {
        let (plane, post) = zone.plane()?;
        Some(Self {
            sensor,
            plane: *plane,
            from: post.map_or(start, |post| Vec3::new(post[0][0], post[0][1], 0.0)),
            hands_only: post.is_some(),
            closed: Closed::new(plane, obstacles),
            lets_below: false,
            legs_below_m: 0.0,
        })
    }

    /// No point of one plane is nearer to one of the other than this, m: seen from above.
    #[must_use]
    pub(crate) fn apart_m(&self, other: &Self) -> f64 {
        let ends = |plane: &Cuboid| {
            let (middle, half) = (plane.centre.with_z(0.0), plane.rotation * Vec3::X * plane.half.x);
            [middle - half, middle + half]
        };
        let ([a, b], [c, d]) = (ends(&self.plane), ends(&other.plane));
        segment_segment(a, b, c, d).distance
    }

    /// The plane as a wall: for arms that do not break it.
    #[must_use]
    pub fn unbroken(&self) -> Cuboid {
        Cuboid { half: self.plane.half.with_y(HALF_THICKNESS_M), ..self.plane }
    }

    /// How deep `point` is behind the plane, m; negative before it.
    #[must_use]
    pub fn depth(&self, point: Vec3) -> f64 {
        depth(&self.plane, self.from, point)
    }

    /// What lies deeper than `depth` behind the plane: out of reach in time.
    #[must_use]
    pub fn beyond(&self, depth: f64) -> Cuboid {
        beyond(&self.plane, self.from, depth)
    }

    /// What lies farther than `depth` before the plane: out of reach in time for an arm from behind.
    #[must_use]
    pub(crate) fn before(&self, depth: f64) -> Cuboid {
        // Seen from a mirrored point, the sides change places.
        let across = self.plane.rotation * Vec3::Y;
        let mirrored = self.from - across * (2.0 * side(&self.plane, self.from));
        beyond(&self.plane, mirrored, depth)
    }

    /// Whether some part of `shape` is no deeper than `depth` behind the plane.
    #[must_use]
    pub fn within(&self, depth: f64, shape: &Solid) -> bool {
        self.depths(shape).0 <= depth
    }

    /// Whether no part of `shape` is deeper than `depth` behind the plane.
    #[must_use]
    pub fn holds(&self, depth: f64, shape: &Solid) -> bool {
        self.depths(shape).1 <= depth
    }

    /// Whether some part of `shape` is before the plane, no farther than `depth`.
    #[must_use]
    pub(crate) fn within_before(&self, depth: f64, shape: &Solid) -> bool {
        let (least, most) = self.depths(shape);
        least <= 0.0 && -most <= depth
    }

    /// The least and the greatest depth of a shape behind the plane, m; wider for what is no capsule.
    fn depths(&self, shape: &Solid) -> (f64, f64) {
        match shape {
            Solid::Capsule(c) => {
                let (a, b) = (self.depth(c.a), self.depth(c.b));
                (a.min(b) - c.radius, a.max(b) + c.radius)
            }
            Solid::Hull(_) | Solid::Mesh(_) => {
                let (centre, radius) = shape.bounding_sphere();
                (self.depth(centre) - radius, self.depth(centre) + radius)
            }
        }
    }
}

/// Signed distance of a point from the plane; positive on the side of its normal.
fn side(plane: &Cuboid, point: Vec3) -> f64 {
    (plane.rotation * Vec3::Y).dot(point - plane.centre)
}

/// How deep `point` is behind the plane, as seen from a person who comes from `from`, m; negative before it.
fn depth(plane: &Cuboid, from: Vec3, point: Vec3) -> f64 {
    if side(plane, from) > 0.0 { -side(plane, point) } else { side(plane, point) }
}

/// How deep a hand can be after `steps` whole steps of `step_s`, m; faster than at a hand's own speed only where the body is.
#[must_use]
pub fn depth_m(steps: usize, step_s: f64, body_m_s: f64) -> f64 {
    #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
    let time = steps as f64 * step_s;
    HAND_SPEED_M_S.max(body_m_s) * time
}

/// A rectangle in a light curtain's plane that no arm passes unseen: the curtain and the guarding that adjoins it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Closed {
    plane: Cuboid,
    /// From and to along the plane, from the curtain's centre, m.
    along: [f64; 2],
    /// Its top above the floor, m.
    top: f64,
    /// Its lower edge above the floor, m, where there is room below.
    low: Option<f64>,
}

/// Guarding that begins no farther than this from a curtain's end closes it: an arm does not fit through, m.
const GAP_M: f64 = 0.05;

impl Closed {
    /// The curtain with the upright obstacles in its plane that lengthen it without a gap; others are not counted.
    #[must_use]
    pub(crate) fn new(plane: &Cuboid, obstacles: &[Cuboid]) -> Self {
        let mut along = [-plane.half.x, plane.half.x];
        let (low, top) = (plane.centre.z - plane.half.z, plane.centre.z + plane.half.z);
        let spans: Vec<[f64; 2]> = obstacles.iter().filter_map(|o| span(plane, o, [low, top])).collect();
        // Each pass may join one more piece at either end.
        for _ in 0..=spans.len() {
            for [from, to] in &spans {
                if *from <= along[1] + GAP_M && *to > along[1] {
                    along[1] = *to;
                }
                if *to >= along[0] - GAP_M && *from < along[0] {
                    along[0] = *from;
                }
            }
        }
        let mut below: Vec<[f64; 2]> = obstacles.iter().filter_map(|o| span(plane, o, [0.0, low - GAP_M])).collect();
        below.sort_by(|a, b| a[0].total_cmp(&b[0]));
        let closed_to = |end: f64, [from, to]: &[f64; 2]| if *from <= end + GAP_M { end.max(*to) } else { end };
        let has_room_below = low > GAP_M && below.iter().fold(along[0], closed_to) < along[1] - GAP_M;
        Self { plane: *plane, along, top, low: has_room_below.then_some(low) }
    }

    /// Whether there is room below it.
    #[must_use]
    pub const fn has_room_below(&self) -> bool {
        self.low.is_some()
    }

    /// Whether an arm of this reach is too short to lead from `shoulder` around the rectangle's ends, over its top or below it to
    /// `shape`: by the lengths from the shoulder to each edge and on from there, which no arm undercuts. A shoulder behind
    /// the plane is not answered.
    #[must_use]
    pub fn out_of_reach(&self, shoulder: Vec3, reach: f64, shape: &Solid) -> bool {
        let (axis, up) = (self.plane.rotation * Vec3::X, Vec3::Z);
        let floor = self.plane.centre.with_z(0.0);
        let corner = |end: f64, z: f64| floor + axis * end + up * z;
        let [left, right] = self.along;
        // Edges are lines; both ends go up as far as any arm.
        let level = |z: f64| (corner(left, z), corner(right, z));
        let edges = [
            level(self.top),
            (corner(left, 0.0), corner(left, 2.0 * BEYOND_M)),
            (corner(right, 0.0), corner(right, 2.0 * BEYOND_M)),
        ];
        edges.into_iter().chain(self.low.map(level)).all(|(a, b)| {
            let to_edge = point_segment(shoulder, a, b).distance;
            to_edge + shape.segment_distance(a, b).distance.max(0.0) > reach
        })
    }
}

/// The part of a curtain's plane, along it, that an obstacle closes from `low` to `top`; only for boxes that stand
/// square to the plane.
fn span(plane: &Cuboid, obstacle: &Cuboid, [low, top]: [f64; 2]) -> Option<[f64; 2]> {
    let turned = plane.rotation.inverse() * obstacle.rotation;
    let extent = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| {
        let parts = (turned.inverse() * axis).abs();
        (parts.max_element() > 1.0 - 1e-9).then(|| parts.dot(obstacle.half))
    });
    let [Some(x), Some(y), Some(z)] = extent else { return None };
    let at = plane.rotation.inverse() * (obstacle.centre - plane.centre);
    let closes = at.y.abs() <= y && obstacle.centre.z - z <= low + GAP_M && obstacle.centre.z + z >= top;
    closes.then_some([at.x - x, at.x + x])
}

/// What lies deeper than `depth` behind the plane, as seen from a person who comes from `from`: out of reach in time.
fn beyond(plane: &Cuboid, from: Vec3, depth: f64) -> Cuboid {
    let away = if side(plane, from) > 0.0 { -1.0 } else { 1.0 };
    let normal = plane.rotation * (Vec3::Y * away);
    Cuboid {
        centre: plane.centre + normal * (depth + BEYOND_M),
        half: plane.half + Vec3::splat(BEYOND_M),
        rotation: plane.rotation,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{Rotation, rotation_about};

    #[test]
    fn half_a_metre_takes_a_quarter_of_a_second() {
        // 13 samples of 20 ms have passed for the 12th: 2.0 m/s * 0.26 s.
        assert!((depth_m(13, 0.02, 1.6) - 0.52).abs() < 1e-12);
        assert!((depth_m(13, 0.02, 3.2) - 0.832).abs() < 1e-12);
    }

    #[test]
    fn what_is_beyond_begins_at_the_depth_on_the_far_side() {
        for yaw in [0.0, 0.7, 3.0] {
            let rotation: Rotation = rotation_about(Vec3::Z, yaw);
            let centre = Vec3::new(1.0, -2.0, 0.9);
            let plane = Cuboid { centre, half: Vec3::new(0.5, 0.0, 0.9), rotation };
            let normal = rotation * Vec3::Y;
            for sign in [-1.0, 1.0] {
                let wall = beyond(&plane, centre - normal * sign, 0.3);
                let inside = |p: Vec3| {
                    let local = rotation.inverse() * (p - wall.centre);
                    local.abs().cmple(wall.half + 1e-12).all()
                };
                assert!(inside(centre + normal * (sign * 0.301)));
                assert!(!inside(centre + normal * (sign * 0.299)));
                assert!(!inside(centre - normal * (sign * 0.1)));
            }
        }
    }

    #[test]
    fn guarding_beside_a_curtain_lengthens_what_is_closed() {
        let upright = |x0: f64, x1: f64, height: f64| Cuboid {
            centre: Vec3::new(0.5 * (x0 + x1), 0.0, 0.5 * height),
            half: Vec3::new(0.5 * (x1 - x0), 0.01, 0.5 * height),
            rotation: Rotation::IDENTITY,
        };
        let plane = Cuboid { half: Vec3::new(0.5, 0.0, 0.9), ..upright(-0.5, 0.5, 1.8) };
        let low = upright(0.5, 2.0, 1.2);
        let apart = upright(0.6, 2.0, 2.0);
        let (left, next) = (upright(-1.0, -0.52, 2.0), upright(-2.0, -1.0, 1.8));
        assert_eq!(Closed::new(&plane, &[low, apart]).along, [-0.5, 0.5]);
        let closed = Closed::new(&plane, &[next, left, upright(0.5, 1.5, 2.0)]);
        assert_eq!(closed.along, [-2.0, 1.5]);
        // From (0, -0.3, 1.4) over the top at 1.8: 0.5 m, then 0.5 m on to a ball 0.4 m behind at 1.4, less 0.1 m.
        let ball = Solid::Capsule(crate::geometry::Capsule {
            a: Vec3::new(0.0, 0.3, 1.4),
            b: Vec3::new(0.0, 0.3, 1.4),
            radius: 0.1,
        });
        let shoulder = Vec3::new(0.0, -0.3, 1.4);
        assert!(closed.out_of_reach(shoulder, 0.899, &ball));
        assert!(!closed.out_of_reach(shoulder, 0.901, &ball));
        // From (0, -0.3, 0.9), bent, below an edge at 0.5: 0.5 m, then 0.424 m on to a ball 0.3 m behind at 0.2, less 0.1 m.
        let down = |low: f64| Cuboid { half: plane.half.with_z(0.5 * (1.8 - low)), ..upright(-0.5, 0.5, 1.8 + low) };
        let ends = [next, left, upright(0.5, 1.5, 2.0)];
        let ball_below = Solid::Capsule(crate::geometry::Capsule {
            a: Vec3::new(0.0, 0.3, 0.2),
            b: Vec3::new(0.0, 0.3, 0.2),
            radius: 0.1,
        });
        let bent = Vec3::new(0.0, -0.3, 0.9);
        for (what, low, others, is_out) in [
            ("room below", 0.5, vec![], [true, false]),
            ("down to the floor", 0.0, vec![], [true, true]),
            ("a board below", 0.5, vec![upright(-0.52, 0.5, 0.48)], [true, true]),
            ("two", 0.5, vec![upright(-0.5, 0.0, 0.5), upright(0.0, 0.5, 0.5)], [true, true]),
            ("a gap between two", 0.5, vec![upright(-0.5, 0.0, 0.5), upright(0.1, 0.5, 0.5)], [true, false]),
            ("a low one", 0.5, vec![upright(-0.5, 0.5, 0.4)], [true, false]),
        ] {
            let closed = Closed::new(&down(low), &[&ends[..], &others].concat());
            assert_eq!([0.823, 0.825].map(|reach| closed.out_of_reach(bent, reach, &ball_below)), is_out, "{what}");
        }
        // With open ends, round the corner at (0.5, 0): 0.583 + 0.483.
        let open = Closed::new(&Cuboid { half: plane.half.with_z(3.0), ..plane }, &[]);
        assert!(open.out_of_reach(shoulder, 1.06, &ball) && !open.out_of_reach(shoulder, 1.07, &ball));
    }
}
