//! Polygons in the floor plan, convex or not: points inside, distance to the edge, the same polygon wider, convex hulls.

use super::Vec3;
use super::distance::{point_segment, segment_segment};

/// Whether a point is inside, by the even-odd rule; points exactly on a left or lower edge are.
#[must_use]
pub fn contains(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> bool {
    let mut inside = false;
    for ([x1, y1], [x2, y2]) in edges(polygon) {
        if (y1 > y) != (y2 > y) && x < (x2 - x1) * (y - y1) / (y2 - y1) + x1 {
            inside = !inside;
        }
    }
    inside
}

/// Distance of a point to the nearest edge, m.
#[must_use]
pub fn distance_to_edge(polygon: &[[f64; 2]], [x, y]: [f64; 2]) -> f64 {
    let flat = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
    let to = |(a, b): ([f64; 2], [f64; 2])| point_segment(flat([x, y]), flat(a), flat(b)).distance;
    edges(polygon).map(to).fold(f64::INFINITY, f64::min)
}

/// How far two polygons are apart, or a polygon and points with edges between them, m; 0 where they meet. It takes as long as there are pairs
/// of edges.
#[must_use]
pub fn apart(one: &[[f64; 2]], other: &[[f64; 2]]) -> f64 {
    let holds =
        |polygon: &[[f64; 2]], corners: &[[f64; 2]]| corners.first().is_some_and(|first| contains(polygon, *first));
    if holds(one, other) || holds(other, one) {
        return 0.0;
    }
    let flat = |[x, y]: [f64; 2]| Vec3::new(x, y, 0.0);
    let pairs = edges(one).flat_map(|edge| edges(other).map(move |other| (edge, other)));
    let of = |((a, b), (c, d))| segment_segment(flat(a), flat(b), flat(c), flat(d)).distance;
    pairs.map(of).fold(f64::INFINITY, f64::min)
}

/// The numbers of two edges that cross; nothing of a polygon that does not cross itself. Edges that only touch or lie on one another do not
/// cross: a slit to a hole is two of them. It takes as long as there are pairs of edges.
#[must_use]
pub fn crossing(polygon: &[[f64; 2]]) -> Option<(usize, usize)> {
    let side = |[ax, ay]: [f64; 2], [bx, by]: [f64; 2], [x, y]: [f64; 2]| (bx - ax) * (y - ay) - (by - ay) * (x - ax);
    let all: Vec<_> = edges(polygon).collect();
    let cross = |(one, other): &(usize, usize)| {
        let ((a, b), (c, d)) = (all[*one], all[*other]);
        side(a, b, c) * side(a, b, d) < 0.0 && side(c, d, a) * side(c, d, b) < 0.0
    };
    (0..all.len()).flat_map(|one| (one + 1..all.len()).map(move |other| (one, other))).find(cross)
}

/// The convex hull of points, anticlockwise (Andrew's monotone chain).
#[must_use]
pub fn convex_outline(mut points: Vec<[f64; 2]>) -> Vec<[f64; 2]> {
    points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
    points.dedup();
    if points.len() < 3 {
        return points;
    }
    let turns_left =
        |a: [f64; 2], b: [f64; 2], c: [f64; 2]| (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]) > 0.0;
    let half = |points: &mut dyn Iterator<Item = &[f64; 2]>| {
        let mut chain: Vec<[f64; 2]> = Vec::new();
        for point in points {
            while chain.len() >= 2 && !turns_left(chain[chain.len() - 2], chain[chain.len() - 1], *point) {
                chain.pop();
            }
            chain.push(*point);
        }
        chain.pop();
        chain
    };
    let mut outline = half(&mut points.iter());
    outline.extend(half(&mut points.iter().rev()));
    outline
}

/// The polygon with every edge moved outwards by `by` m, corners kept sharp. Meant for shapes wider than they are notched:
/// a notch narrower than twice `by` is turned inside out.
#[must_use]
pub fn widened(polygon: &[[f64; 2]], by: f64) -> Vec<[f64; 2]> {
    let count = polygon.len();
    let doubled_area: f64 = edges(polygon).map(|([x1, y1], [x2, y2])| x1 * y2 - x2 * y1).sum();
    let outwards = if doubled_area >= 0.0 { 1.0 } else { -1.0 };
    let normal = |from: [f64; 2], to: [f64; 2]| {
        let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
        let length = libm::hypot(dx, dy).max(f64::MIN_POSITIVE);
        [outwards * dy / length, -outwards * dx / length]
    };
    (0..count)
        .map(|i| {
            let (before, here, after) = (polygon[(i + count - 1) % count], polygon[i], polygon[(i + 1) % count]);
            let (a, b) = (normal(before, here), normal(here, after));
            // The two moved edges meet where both normals see `by`; nearly opposite edges would meet far away.
            let scale = by / (1.0 + a[0] * b[0] + a[1] * b[1]).max(0.1);
            [here[0] + scale * (a[0] + b[0]), here[1] + scale * (a[1] + b[1])]
        })
        .collect()
}

fn edges(polygon: &[[f64; 2]]) -> impl Iterator<Item = ([f64; 2], [f64; 2])> + '_ {
    polygon.iter().copied().zip(polygon.iter().copied().cycle().skip(1))
}

#[cfg(test)]
mod tests {
    use super::*;

    const L: [[f64; 2]; 6] = [[0.0, 0.0], [2.0, 0.0], [2.0, 1.0], [1.0, 1.0], [1.0, 2.0], [0.0, 2.0]];

    #[test]
    fn polygons_are_apart_as_far_as_their_nearest_points_and_not_at_all_where_they_meet() {
        let about = |a: f64, b: f64| assert!((a - b).abs() < 1e-12, "{a} {b}");
        let square = |x: f64, y: f64, half: f64| {
            [[x - half, y - half], [x + half, y - half], [x + half, y + half], [x - half, y + half]]
        };
        // In the notch, beside it, over a corner, a single point, one within the other, and a cross of which no corner is in the other.
        about(apart(&L, &square(1.7, 1.7, 0.3)), 0.4);
        about(apart(&L, &square(4.0, 0.5, 0.5)), 1.5);
        about(apart(&L, &square(4.0, -3.0, 1.0)), libm::hypot(1.0, 2.0));
        about(apart(&[[-1.0, 0.5]], &L), 1.0);
        about(apart(&square(0.5, 0.5, 0.1), &L), 0.0);
        about(apart(&L, &square(0.5, 0.5, 0.1)), 0.0);
        about(
            apart(
                &[[-1.0, 0.4], [3.0, 0.4], [3.0, 0.6], [-1.0, 0.6]],
                &[[0.4, -1.0], [0.6, -1.0], [0.6, 3.0], [0.4, 3.0]],
            ),
            0.0,
        );
    }

    #[test]
    fn a_convex_outline_leaves_out_what_is_inside_or_on_an_edge() {
        let points =
            vec![[0.0, 0.0], [1.0, 1.0], [2.0, 0.0], [1.0, 0.0], [2.0, 2.0], [0.0, 2.0], [0.5, 1.5], [0.0, 0.0]];
        assert_eq!(convex_outline(points), [[0.0, 0.0], [2.0, 0.0], [2.0, 2.0], [0.0, 2.0]]);
        assert_eq!(convex_outline(vec![[1.0, 0.0], [0.0, 0.0]]), [[0.0, 0.0], [1.0, 0.0]]);
    }

    #[test]
    fn an_l_shape() {
        assert!(contains(&L, [0.5, 0.5]) && contains(&L, [1.5, 0.5]) && contains(&L, [0.5, 1.5]));
        assert!(!contains(&L, [1.5, 1.5]) && !contains(&L, [-0.1, 0.5]));
        assert!((distance_to_edge(&L, [1.5, 1.5]) - 0.5).abs() < 1e-12);
        assert!((distance_to_edge(&L, [3.0, 2.0]) - 2.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn widened_by_the_same_on_every_side_whichever_way_round_it_goes() {
        let wider = [[-0.5, -0.5], [2.5, -0.5], [2.5, 1.5], [1.5, 1.5], [1.5, 2.5], [-0.5, 2.5]];
        let close = |a: &[[f64; 2]], b: &[[f64; 2]]| {
            a.iter().zip(b).all(|(a, b)| libm::hypot(a[0] - b[0], a[1] - b[1]) < 1e-12)
        };
        assert!(close(&widened(&L, 0.5), &wider), "{:?}", widened(&L, 0.5));
        let (mut around, mut expected) = (L, wider);
        around.reverse();
        expected.reverse();
        assert!(close(&widened(&around, 0.5), &expected));
        assert!(close(&widened(&wider, -0.5), &L));
    }
}
