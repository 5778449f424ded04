//! Distances from points and segments to a triangle. A triangle without area is the lines between its corners.

use super::Vec3;
use super::distance::{point_segment, segment_segment};

/// The corners of a triangle, m.
pub(crate) type Corners = [Vec3; 3];

/// The normal, as long as twice the area; zero where there is none.
#[must_use]
pub(crate) fn normal(&[a, b, c]: &Corners) -> Vec3 {
    (b - a).cross(c - a)
}

/// Whether the foot of a point on the plane of the triangle, whose normal is `normal`, is inside it.
fn above(point: Vec3, corners: &Corners, normal: Vec3) -> bool {
    (0..3).all(|k| {
        let (from, to) = (corners[k], corners[(k + 1) % 3]);
        (to - from).cross(point - from).dot(normal) >= 0.0
    })
}

/// The point of a triangle that is nearest to `point`.
#[must_use]
pub(crate) fn nearest_to_point(point: Vec3, corners: &Corners) -> Vec3 {
    let normal = normal(corners);
    let square = normal.length_squared();
    if square > 0.0 && above(point, corners, normal) {
        let foot = point - normal * ((point - corners[0]).dot(normal) / square);
        if foot.is_finite() {
            return foot;
        }
    }
    let edges = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| point_segment(point, corners[i], corners[j]));
    edges[1..].iter().fold(edges[0], |best, edge| if edge.distance < best.distance { *edge } else { best }).on_second
}

/// Distance of a segment from a triangle, m, with the nearest points of the one and of the other; zero where they meet.
#[must_use]
pub(crate) fn nearest_to_segment(a: Vec3, b: Vec3, corners: &Corners) -> (f64, Vec3, Vec3) {
    let normal = normal(corners);
    let [from, to] = [a, b].map(|end| (end - corners[0]).dot(normal));
    if from * to <= 0.0 && from != to {
        let crossing = a + (b - a) * (from / (from - to));
        if crossing.is_finite() && above(crossing, corners, normal) {
            return (0.0, crossing, crossing);
        }
    }
    let ends = [a, b].map(|end| {
        let on = nearest_to_point(end, corners);
        ((end - on).length(), end, on)
    });
    let edges = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| {
        let near = segment_segment(a, b, corners[i], corners[j]);
        (near.distance, near.on_first, near.on_second)
    });
    ends.into_iter()
        .chain(edges)
        .fold((f64::INFINITY, a, corners[0]), |best, one| if one.0 < best.0 { one } else { best })
}

#[cfg(test)]
mod tests {
    use parry3d_f64::query;
    use parry3d_f64::shape::{Segment, Triangle};
    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::geometry::Pose;

    fn vector(random: &mut Pcg64) -> Vec3 {
        let mut unit = || f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0;
        Vec3::new(unit(), unit(), unit())
    }

    #[test]
    fn distances_are_those_of_parry() {
        let mut random = Pcg64::seed_from_u64(5);
        for _ in 0..3000 {
            let [p, q, r] = [(); 3].map(|()| vector(&mut random));
            let [a, b] = [(); 2].map(|()| vector(&mut random) * 1.5);
            let triangle = Triangle::new(p, q, r);
            let by_parry = query::distance(&Pose::IDENTITY, &Segment::new(a, b), &Pose::IDENTITY, &triangle).unwrap();
            let (distance, on_segment, on_triangle) = nearest_to_segment(a, b, &[p, q, r]);
            assert!((distance - by_parry.distance).abs() < 1e-6, "{distance} {}", by_parry.distance);
            assert!(((on_segment - on_triangle).length() - distance).abs() < 1e-9);
            let on = nearest_to_point(a, &[p, q, r]);
            assert!((on - nearest_to_segment(a, a, &[p, q, r]).2).length() < 1e-9);
        }
    }

    #[test]
    fn a_triangle_without_area_is_its_edges() {
        let line = [Vec3::ZERO, Vec3::X, Vec3::X * 2.0];
        assert!((nearest_to_point(Vec3::new(1.5, 1.0, 0.0), &line) - Vec3::new(1.5, 0.0, 0.0)).length() < 1e-12);
        let point = [Vec3::X; 3];
        assert_eq!(nearest_to_segment(Vec3::ZERO, Vec3::Y, &point).0, 1.0);
    }
}
