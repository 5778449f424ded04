//! Walls that adjoin, side by side or one on the other: what they are together, as far as that is a box.
//!
//! Whatever passes through where two of them meet passes through neither for certain, but through both together.

use super::{Cuboid, Vec3};

/// Walls that end this far from each other meet, m: room that nothing gets through.
const GAP_M: f64 = 1e-6;
/// Axes of boxes that differ by less are one.
const SAME: f64 = 1e-9;
/// Volumes that differ by no more than this part of them are the same.
const SAME_PART: f64 = 1e-5;
/// What is narrower than this where two meet does not matter, m.
const NARROW_M: f64 = 0.05;

/// Walls with those made one that are a box together: panels of a fence.
#[must_use]
pub fn merged(walls: &[Cuboid]) -> Vec<Cuboid> {
    let mut all = walls.to_vec();
    loop {
        let mut pairs = (1..all.len()).flat_map(|n| (0..n).map(move |m| (m, n)));
        let Some((m, n, both)) = pairs.find_map(|(m, n)| {
            let both = joined_two(&all[m], &all[n])?;
            let is_all = (volume(&both) - volume(&all[m]) - volume(&all[n])).abs() <= SAME_PART * volume(&both);
            is_all.then_some((m, n, both))
        }) else {
            return all;
        };
        all[m] = both;
        all.remove(n);
    }
}

/// Boxes that lie in the union of two walls which adjoin, and in neither.
#[must_use]
pub fn joined(walls: &[Cuboid]) -> Vec<Cuboid> {
    let pairs = (1..walls.len()).flat_map(|n| (0..n).map(move |m| (n, m)));
    pairs.filter_map(|(n, m)| joined_two(&walls[n], &walls[m])).collect()
}

fn volume(o: &Cuboid) -> f64 {
    8.0 * o.half.x * o.half.y * o.half.z
}

/// The box in the union of two walls that goes on where one of them ends, if they adjoin in a plane.
#[must_use]
pub fn joined_two(a: &Cuboid, b: &Cuboid) -> Option<Cuboid> {
    let from_a = |v: Vec3| [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| (a.rotation * axis).dot(v));
    // How far the second goes along each axis of the first.
    let axes = [Vec3::X, Vec3::Y, Vec3::Z].map(|axis| from_a(b.rotation * axis));
    let mut far = [0.0; 3];
    for (axis, half) in axes.into_iter().zip(b.half.to_array()) {
        let along = (0..3).find(|i| axis[*i].abs() > 1.0 - SAME)?;
        far[along] = half;
    }
    let half = a.half.to_array();
    let middle = from_a(b.centre - a.centre);
    let thin = |half: [f64; 3]| (1..3).fold(0, |t, i| if half[i] < half[t] { i } else { t });
    if thin(half) != thin(far) {
        return None;
    }
    let spans = [0, 1, 2].map(|i| ([-half[i], half[i]], [middle[i] - far[i], middle[i] + far[i]]));
    let goes_on = |i: usize| {
        let (own, other) = spans[i];
        let is_longer = (other[1] > own[1] && other[0] > own[0]) || (other[1] < own[1] && other[0] < own[0]);
        i != thin(half) && is_longer && other[0] <= own[1] + GAP_M && own[0] <= other[1] + GAP_M
    };
    let along = (0..3).find(|i| goes_on(*i))?;
    let mut ends = [[0.0; 2]; 3];
    for (i, (own, other)) in spans.into_iter().enumerate() {
        let both = [own[0].max(other[0]), own[1].min(other[1])];
        let least = if i == thin(half) { GAP_M } else { NARROW_M };
        ends[i] = if i == along { [own[0].min(other[0]), own[1].max(other[1])] } else { both };
        if ends[i][1] - ends[i][0] < least {
            return None;
        }
    }
    let at = |of: &dyn Fn([f64; 2]) -> f64| Vec3::from_array(ends.map(of));
    Some(Cuboid {
        centre: a.centre + a.rotation * at(&|[low, high]| 0.5 * (low + high)),
        half: at(&|[low, high]| 0.5 * (high - low)),
        rotation: a.rotation,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::rotation_about;
    use crate::geometry::segment_cuboid::point_cuboid;
    use crate::search::Rng;

    /// Panels, posts and a curtain in a row, at any angle, with axes named one way or another: every point of what is made of two of them
    /// is in one of them.
    #[test]
    fn what_is_made_of_walls_is_in_them() {
        let mut rng = Rng::new(7);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let mut made = 0;
        for _ in 0..300 {
            let turned = rotation_about(Vec3::new(uniform(-1.0, 1.0), uniform(-1.0, 1.0), 1.0).normalize(), 2.0);
            let mut x = 0.0;
            let mut walls = Vec::new();
            for n in 0..4 {
                let half = Vec3::new(uniform(0.1, 0.8), uniform(0.005, 0.03), uniform(0.8, 1.0));
                // Axes may be named otherwise.
                let about = rotation_about(Vec3::Z, std::f64::consts::FRAC_PI_2 * f64::from(n));
                let (half, own) = if n % 2 == 1 { (Vec3::new(half.y, half.x, half.z), half) } else { (half, half) };
                let centre = turned * Vec3::new(x + own.x, uniform(-0.004, 0.004), uniform(-0.05, 0.05));
                walls.push(Cuboid { centre, half, rotation: turned * about });
                x += 2.0 * own.x;
            }
            let all = joined(&walls);
            made += all.len();
            assert_eq!((all.len(), merged(&walls).len()), (3, 4), "{all:?}");
            for o in &all {
                for _ in 0..50 {
                    let at = o.half * Vec3::new(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0));
                    let at = o.centre + o.rotation * at;
                    assert!(walls.iter().any(|wall| point_cuboid(at, wall).distance < 1e-7), "{o:?} {walls:?}");
                }
            }
        }
        assert!(made == 900, "{made}");
    }

    /// Four panels in a row and four on top are one wall, in whatever order they come; a fifth that is lower is not of it.
    #[test]
    fn panels_are_one_wall() {
        let turned = rotation_about(Vec3::Z, 0.7);
        let panel = |x: f64, z: f64, height: f64| Cuboid {
            centre: turned * Vec3::new(x + 0.5, 2.0, z + 0.5 * height),
            half: Vec3::new(0.5, 0.01, 0.5 * height),
            rotation: turned,
        };
        let row = |z: f64| [3.0, 0.0, 2.0, 1.0].map(|x| panel(x, z, 1.0));
        let walls = [row(0.0).as_slice(), &row(1.0), &[panel(4.0, 0.0, 0.6)]].concat();
        let all = merged(&walls);
        let size = |o: &Cuboid| o.half * 2.0;
        assert_eq!(all.len(), 2, "{all:?}");
        assert!((size(&all[0]) - Vec3::new(4.0, 0.02, 2.0)).length() < 1e-9, "{all:?}");
        assert!((all[0].centre - turned * Vec3::new(2.0, 2.0, 1.0)).length() < 1e-9);
        // Along the lower one, both together.
        let both = joined(&all);
        assert!(both.len() == 1 && (size(&both[0]) - Vec3::new(5.0, 0.02, 0.6)).length() < 1e-9, "{both:?}");
    }

    #[test]
    fn walls_that_do_not_adjoin_in_a_plane_make_nothing() {
        let wall = |centre: [f64; 3], half: [f64; 3]| Cuboid {
            centre: Vec3::from_array(centre),
            half: Vec3::from_array(half),
            rotation: rotation_about(Vec3::Z, 0.0),
        };
        let first = wall([0.0; 3], [1.0, 0.01, 1.0]);
        let none = [
            ("a gap of a millimetre", wall([2.001, 0.0, 0.0], [1.0, 0.01, 1.0])),
            ("one behind the other", wall([2.0, 0.03, 0.0], [1.0, 0.01, 1.0])),
            ("a corner", wall([1.0, 1.0, 0.0], [0.01, 1.0, 1.0])),
            ("one above and beside the other", wall([2.0, 0.0, 2.0], [1.0, 0.01, 1.0])),
            ("the same", first),
        ];
        for (what, other) in none {
            assert_eq!(joined(&[first, other]), [], "{what}");
        }
        let turned = Cuboid { rotation: rotation_about(Vec3::Z, 1e-3), ..wall([2.0, 0.0, 0.0], [1.0, 0.01, 1.0]) };
        assert_eq!(joined(&[first, turned]), []);
        assert_eq!(joined(&[first, wall([2.0, 0.0, 0.0], [1.0, 0.01, 1.0])]).len(), 1);
    }
}
