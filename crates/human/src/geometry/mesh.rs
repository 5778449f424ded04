//! A closed mesh as the shape of a robot link, hollows and notches and all.
//!
//! It is not convex: the point of it that is nearest to a moving point may jump, and there is no plane that it stays behind.

use std::sync::Arc;

use super::distance::{beyond, point_segment};
use super::{Closest, Pose, Surface, Vec3};

/// A closed surface shared between placements, with where it is.
#[derive(Clone, Debug)]
pub struct Mesh {
    surface: Arc<Surface>,
    pose: Pose,
    /// What is no farther from it than this belongs to it, m.
    margin_m: f64,
}

/// Points of a segment whose depth is looked at: the ends, and others at equal distances.
const SAMPLES: u8 = 9;

/// A segment this near to the surface meets it, m: it may pass between two triangles by rounding.
const MEETS_M: f64 = 1e-9;

/// Triangles that are looked at one by one to tell where a nearest point may move.
const FEW: usize = 200;

impl Mesh {
    /// A surface placed by `world_from_local`.
    #[must_use]
    pub const fn new(surface: Arc<Surface>, world_from_local: Pose) -> Self {
        Self { surface, pose: world_from_local, margin_m: 0.0 }
    }

    /// The surface in its own frame.
    #[must_use]
    pub fn surface(&self) -> &Surface {
        &self.surface
    }

    /// `world_from_local` of the surface.
    #[must_use]
    pub const fn pose(&self) -> Pose {
        self.pose
    }

    /// The mesh moved by `pose`.
    pub(super) fn placed(&self, pose: Pose) -> Self {
        Self { pose: pose * self.pose, ..self.clone() }
    }

    /// The mesh with everything that is no farther than `by_m` from it.
    pub(super) fn grown(&self, by_m: f64) -> Self {
        Self { margin_m: self.margin_m + by_m, ..self.clone() }
    }

    /// The distance from the segment between `a` and `b` is at least this, m.
    pub(super) fn at_least(&self, a: Vec3, b: Vec3) -> f64 {
        let (centre, radius) = self.sphere();
        point_segment(centre, a, b).distance - radius
    }

    /// Centre and radius of a sphere around it, world.
    pub(super) fn sphere(&self) -> (Vec3, f64) {
        let (centre, radius) = self.surface.sphere();
        (self.pose * centre, radius + self.margin_m)
    }

    fn world(&self, distance: f64, on_first: Vec3, on_second: Vec3) -> Closest {
        let near = Closest { distance, on_first: self.pose * on_first, on_second: self.pose * on_second };
        beyond(near, self.margin_m)
    }

    pub(super) fn point_distance(&self, point: Vec3) -> Closest {
        let (distance, on_second) = self.local_point_distance(self.pose.inverse_transform_point(point));
        beyond(Closest { distance, on_first: point, on_second: self.pose * on_second }, self.margin_m)
    }

    /// Signed distance of a point and the nearest point of the surface, local.
    fn local_point_distance(&self, point: Vec3) -> (f64, Vec3) {
        let on = self.surface.nearest(point);
        let distance = (on - point).length();
        (if self.surface.holds(point) { -distance } else { distance }, on)
    }

    /// Signed distance of a segment: D > 0, its distance from the body, or else the least of zero and the signed
    /// distances of some of its points.
    ///
    /// It changes by no more than the segment's points are moved. D does, as a distance from a set; so does the least, m,
    /// of the others, each of which does. Where D > 0 all points are outside, so m is the lower of zero and something
    /// positive: zero. A movement that begins at D > 0 and ends at m < 0 comes past D = 0 and m = 0, where the part by
    /// which D changes ends; what m changes after that is no more than what is left of the movement.
    pub(super) fn segment_distance(&self, a: Vec3, b: Vec3) -> Closest {
        let [a, b] = [a, b].map(|end| self.pose.inverse_transform_point(end));
        let (distance, on_first, on_second) = self.surface.nearest_to_segment(a, b);
        if distance > MEETS_M && !self.surface.holds(a) {
            return self.world(distance, on_first, on_second);
        }
        let touch = (0.0, on_first, on_second);
        let deepest = (0..SAMPLES).fold(touch, |deepest, n| {
            let point = a + (b - a) * (f64::from(n) / f64::from(SAMPLES - 1));
            if !self.surface.holds(point) {
                return deepest;
            }
            let on = self.surface.nearest(point);
            let signed = -(on - point).length();
            if signed < deepest.0 { (signed, point, on) } else { deepest }
        });
        self.world(deepest.0, deepest.1, deepest.2)
    }

    /// See [`super::Solid::nearest_within`].
    ///
    /// The point comes no nearer to any triangle, and no farther from the nearest, than it moves: so the nearest point is
    /// always on a triangle that is now no farther than the distance and twice the movement, and on each, as on any convex
    /// set, the nearest point moves no farther than the point.
    pub(super) fn nearest_within(&self, point: Vec3, near: &Closest, movement: f64) -> (Vec3, f64) {
        let from_surface = near.distance + self.margin_m;
        let distance = from_surface.max(0.0) + 2.0 * movement;
        let anywhere = (point, distance);
        if from_surface <= movement {
            return anywhere;
        }
        let local = self.pose.inverse_transform_point(point);
        match self.surface.near_points(local, distance + MEETS_M, FEW) {
            Some((centre, radius)) if radius + movement + self.margin_m < distance => {
                (self.pose * centre, radius + movement + self.margin_m)
            }
            _ => anywhere,
        }
    }
}

#[cfg(test)]
#[path = "mesh_tests.rs"]
mod tests;
