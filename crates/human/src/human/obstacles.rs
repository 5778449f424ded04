//! What obstacles do to a body: they are in its way, and they keep parts of it from what is behind them.

use parry3d_f64::query::details::distance_support_map_support_map;
use parry3d_f64::shape::{Cuboid as ParryCuboid, Segment};

use crate::geometry::{Capsule, Cuboid, Pose, Solid, Vec3};

/// Overlap that still counts as touching, m: far above rounding, far below anything that matters.
pub(super) const TOUCHING_M: f64 = 1e-9;

/// Whether the capsule overlaps the obstacle; touching is not overlapping. A capsule of radius 0 is its core line.
pub fn capsule_hits(capsule: &Capsule, obstacle: &Cuboid) -> bool {
    let half = (obstacle.half - TOUCHING_M).max(Vec3::ZERO);
    let box_from_world = obstacle.rotation.inverse();
    let a = box_from_world * (capsule.a - obstacle.centre);
    let b = box_from_world * (capsule.b - obstacle.centre);
    // Bounds from below and above settle nearly every case without iteration: the gap between the box and the core's
    // bounding box (exact for most capsules before a wall), and the gaps between the box and the ends.
    let gap = |low: Vec3, high: Vec3| (low - half).max(-half - high).max(Vec3::ZERO).length_squared();
    let within = capsule.radius * capsule.radius;
    if gap(a.min(b), a.max(b)) > within {
        return false;
    }
    if gap(a, a) <= within || gap(b, b) <= within {
        return true;
    }
    distance_support_map_support_map(&Pose::IDENTITY, &Segment::new(a, b), &ParryCuboid::new(half)) <= capsule.radius
}

/// Whether a wall keeps all of a part of the body from a solid: the solid is beyond its middle plane, the part's core before it, and
/// what of the part would stick out beyond is within the wall's edges. There the wall is in its way, not the solid.
#[must_use]
pub fn is_kept_from(part: &Capsule, solid: &Solid, wall: &Cuboid) -> bool {
    let wall_from_world = wall.rotation.inverse();
    let [a, b] = [part.a, part.b].map(|end| (wall_from_world * (end - wall.centre)).to_array());
    let half = wall.half.to_array();
    let thin = (1..3).fold(0, |thin, axis| if half[axis] < half[thin] { axis } else { thin });
    let (near, far) = (a[thin].abs().min(b[thin].abs()), part.radius);
    if a[thin] * b[thin] <= 0.0 || near >= far {
        return false;
    }
    let normal = wall.rotation * [Vec3::X, Vec3::Y, Vec3::Z][thin] * a[thin].signum();
    let beyond = |point: Vec3, radius: f64| normal.dot(point - wall.centre) + radius <= 0.0;
    let is_beyond = match solid {
        Solid::Capsule(c) => beyond(c.a, c.radius) && beyond(c.b, c.radius),
        Solid::Hull(_) | Solid::Mesh(_) => {
            let (centre, radius) = solid.bounding_sphere();
            beyond(centre, radius)
        }
    };
    let across = (far * far - near * near).sqrt();
    let covers = |axis: usize| axis == thin || a[axis].abs().max(b[axis].abs()) + across <= half[axis];
    is_beyond && (0..3).all(covers)
}

#[cfg(test)]
mod tests {
    use parry3d_f64::query::contact;
    use parry3d_f64::shape::Capsule as ParryCapsule;
    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::geometry::{Rotation, rotation_about};

    fn capsule(a: [f64; 3], b: [f64; 3], radius: f64) -> Capsule {
        Capsule { a: a.into(), b: b.into(), radius }
    }

    /// Seeded random capsules and boxes against parry's own capsule, apart from pairs that nearly touch.
    #[test]
    fn agrees_with_parry() {
        let mut random = Pcg64::seed_from_u64(7);
        let mut unit = || f64::from(random.next_u32()) / f64::from(u32::MAX);
        let mut hits = 0;
        for _ in 0..20_000 {
            let mut vector = |size: f64| Vec3::new(unit() - 0.5, unit() - 0.5, unit() - 0.5) * (2.0 * size);
            let rotation = rotation_about(vector(1.0).normalize(), 3.0);
            let obstacle = Cuboid { centre: vector(0.8), half: vector(0.5).abs(), rotation };
            let (a, b) = (vector(0.8), vector(0.8));
            let radius = vector(0.2).x.abs();
            let world_from_box = Pose::from_parts(obstacle.centre, obstacle.rotation);
            let solid = ParryCapsule::new(a, b, radius);
            let contact = contact(&Pose::IDENTITY, &solid, &world_from_box, &ParryCuboid::new(obstacle.half), 9.0);
            let signed = contact.unwrap().unwrap().dist;
            if signed.abs() > 1e-6 {
                assert_eq!(capsule_hits(&Capsule { a, b, radius }, &obstacle), signed < 0.0, "{signed} m");
                hits += u32::from(signed < 0.0);
            }
        }
        assert!((2_000..18_000).contains(&hits), "both answers must be common: {hits} hits");
    }

    /// A wall 20 mm thick, its faces at x = 0.99 and x = 1.01, 2 m high.
    fn wall(rotation: Rotation) -> Cuboid {
        Cuboid { centre: rotation * Vec3::new(1.0, 0.0, 1.0), half: Vec3::new(0.01, 3.0, 1.0), rotation }
    }

    #[test]
    fn overlap_begins_where_the_surfaces_meet() {
        for turn in [0.0, 0.3, 1.0, 2.0, 4.0] {
            let rotation = rotation_about(Vec3::Z, turn);
            let wall = wall(rotation);
            let turned =
                |capsule: Capsule| Capsule { a: rotation * capsule.a, b: rotation * capsule.b, radius: capsule.radius };
            for (case, expected) in [
                (capsule([0.85, 0.0, 0.2], [0.85, 0.0, 1.6], 0.14), false),
                (capsule([0.85 + 1e-7, 0.0, 0.2], [0.85 + 1e-7, 0.0, 1.6], 0.14), true),
                (capsule([1.15 - 1e-7, 2.0, 1.0], [1.15 - 1e-7, 2.0, 1.0], 0.14), true),
                (capsule([1.15 + 1e-7, 2.0, 1.0], [1.15 + 1e-7, 2.0, 1.0], 0.14), false),
                // Core lines: through the panel, ending in it, before it, along its face, over its top.
                (capsule([0.5, 0.0, 1.0], [1.5, 0.5, 1.2], 0.0), true),
                (capsule([0.5, 0.0, 1.0], [1.0, 0.5, 1.2], 0.0), true),
                (capsule([0.5, 0.0, 1.0], [0.98, 0.5, 1.2], 0.0), false),
                (capsule([0.99 - 1e-7, -1.0, 0.5], [0.99 - 1e-7, 1.0, 0.7], 0.0), false),
                (capsule([0.5, 0.0, 1.9], [1.5, 0.0, 2.2], 0.0), false),
                (capsule([0.5, 0.0, 1.9], [1.5, 0.0, 2.08], 0.0), true),
            ] {
                assert_eq!(capsule_hits(&turned(case), &wall), expected, "turned by {turn}: {case:?}");
            }
        }
    }

    /// A wall of 2 m by 2 m, and a chest of 0.2 m that leans into it from the left: what is behind the wall is kept from it; not what
    /// reaches through its plane, nor what is beside its edge.
    #[test]
    fn a_wall_keeps_a_chest_from_what_is_behind_it() {
        let turned = rotation_about(Vec3::Z, 0.5);
        let wall = Cuboid { centre: Vec3::new(0.3, -0.2, 1.0), half: Vec3::new(0.01, 1.0, 1.0), rotation: turned };
        let at = |x: f64, y: f64, z: f64| wall.centre + turned * Vec3::new(x, y, z);
        let capsule = |a: Vec3, b: Vec3, radius: f64| Capsule { a, b, radius };
        let chest = capsule(at(-0.15, 0.0, 0.2), at(-0.18, 0.0, 0.4), 0.2);
        let link = |x: f64, y: f64| Solid::Capsule(capsule(at(x, y, 0.2), at(x + 0.3, y, 0.2), 0.04));
        assert!(is_kept_from(&chest, &link(0.045, 0.0), &wall));
        assert!(!is_kept_from(&chest, &link(0.035, 0.0), &wall));
        assert!(!is_kept_from(&chest, &link(-0.2, 0.0), &wall));
        // A core that is in the wall's plane, or beyond it, is not before it.
        assert!(!is_kept_from(&capsule(at(-0.1, 0.0, 0.2), at(0.02, 0.0, 0.4), 0.2), &link(0.045, 0.0), &wall));
        // Beside the edge, something sticks out past it: by the circle in which the plane cuts the chest, 0.13 m.
        let beside = |y: f64| capsule(at(-0.15, y, 0.2), at(-0.15, y, 0.4), 0.2);
        assert!(is_kept_from(&beside(0.86), &link(0.045, 0.9), &wall));
        assert!(!is_kept_from(&beside(0.88), &link(0.045, 0.9), &wall));
        // What does not reach the plane is kept by its own distance.
        assert!(!is_kept_from(&capsule(at(-0.3, 0.0, 0.2), at(-0.3, 0.0, 0.4), 0.2), &link(0.045, 0.0), &wall));
    }
}
