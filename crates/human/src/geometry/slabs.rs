//! A polyhedron cut into slabs across its longest side: together they hold the polyhedron.
//!
//! What is told of the surroundings of a shape is the tighter the smaller the shape is, and links of robots are long. Of one of many corners
//! the slabs are those of a [`coarse`] one, with what that leaves out around them.

use std::sync::Arc;

use super::Vec3;
use super::coarse::coarse;
use super::facing::longest;
use super::polyhedron::Polyhedron;

/// The slabs of a polyhedron.
#[derive(Clone, Debug, Default)]
pub(super) struct Slabs {
    /// None of one that stays whole.
    pub(super) all: Arc<[Arc<Polyhedron>]>,
    /// What is no farther than this from them holds the polyhedron, m.
    pub(super) margin_m: f64,
}

/// Thickest slab, m.
const SLAB_M: f64 = 0.08;
/// Most slabs; of a longer polyhedron they are thicker.
const MOST: u32 = 32;
/// Polyhedra of so many corners, as boxes are, stay whole.
const WHOLE: usize = 8;

/// Of more corners than this a coarser polyhedron is cut.
const FINE: usize = 64;
/// How far what that leaves out may be from it, m: less than arms are looked for to.
const COARSE_M: f64 = 0.001;

impl Slabs {
    /// Of a polyhedron.
    pub(super) fn of(whole: &Polyhedron) -> Self {
        if whole.corners().len() <= WHOLE {
            return Self::default();
        }
        let (all, margin_m) = if whole.corners().len() > FINE {
            // What is cut of it is no farther out than its own corners.
            (coarse(whole, COARSE_M - ROUNDING_M).map_or_else(Vec::new, |few| cut(&few)), COARSE_M)
        } else {
            (cut(whole), 0.0)
        };
        Self { all: all.into_iter().map(Arc::new).collect(), margin_m }
    }
}

/// More than coordinates are rounded by, m.
const ROUNDING_M: f64 = 1e-9;

/// The slabs; none where there is one at most.
fn cut(whole: &Polyhedron) -> Vec<Polyhedron> {
    let corners = whole.corners();
    let low = corners.iter().fold(Vec3::splat(f64::INFINITY), |low, corner| low.min(*corner));
    let high = corners.iter().fold(Vec3::splat(f64::NEG_INFINITY), |high, corner| high.max(*corner));
    let axis = longest(high - low);
    let (from, length) = (low.dot(axis), (high - low).dot(axis));
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a few")]
    let count = (length / SLAB_M).ceil().clamp(1.0, f64::from(MOST)) as u32;
    let at = |number: u32| from + length * (f64::from(number) / f64::from(count));
    let all = (0..count).map(|number| slab(whole, axis, [at(number), at(number + 1)]));
    // One that is too thin to be a volume would be missing: then there are none.
    all.collect::<Option<Vec<_>>>().filter(|slabs| slabs.len() > 1).unwrap_or_default()
}

/// What of a polyhedron is between two planes across an axis.
fn slab(whole: &Polyhedron, axis: Vec3, [from, to]: [f64; 2]) -> Option<Polyhedron> {
    let within = whole.corners().iter().copied().filter(|corner| (from..=to).contains(&corner.dot(axis)));
    let cut = |[a, b]: [Vec3; 2]| {
        let [start, end] = [a, b].map(|corner| corner.dot(axis));
        let crosses = move |plane: &f64| (start - plane) * (end - plane) < 0.0;
        [from, to].into_iter().filter(crosses).map(move |plane| a + (b - a) * ((plane - start) / (end - start)))
    };
    Polyhedron::around(&within.chain(whole.edges().flat_map(cut)).collect::<Vec<_>>())
}

#[cfg(test)]
mod tests {
    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::geometry::{Hull, Pose, Solid, rotation_about};

    /// The nearest slab is as near as the hull, and so much nearer at most.
    #[test]
    fn slabs_are_the_hull() {
        let mut random = Pcg64::seed_from_u64(5);
        let mut unit = || f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0;
        for size in [Vec3::new(0.6, 0.15, 0.1), Vec3::new(0.1, 0.1, 0.09), Vec3::new(0.2, 1.9, 0.3)] {
            let points: Vec<Vec3> = (0..90).map(|_| Vec3::new(unit(), unit(), unit()).normalize() * size).collect();
            let place = Pose::from_parts(Vec3::X, rotation_about(Vec3::Z, 1.0));
            let Solid::Hull(hull) = Solid::Hull(Hull::from_points(&points).unwrap()).placed(place).grown(0.01) else {
                panic!()
            };
            let slabs: Vec<Hull> = hull.slabs().collect();
            assert!(slabs.len() >= 3, "{}", slabs.len());
            for _ in 0..300 {
                let [a, b] = [(); 2].map(|()| place * (Vec3::new(unit(), unit(), unit()) * size * 1.5));
                let whole = hull.segment_distance(a, b).distance;
                assert!(
                    hull.at_least(a, b) <= whole + 1e-9
                        && slabs.iter().all(|slab| slab.at_least(a, b) <= slab.segment_distance(a, b).distance + 1e-9)
                );
                let nearest = slabs.iter().map(|slab| slab.segment_distance(a, b).distance).fold(f64::MAX, f64::min);
                if whole > -0.01 {
                    // Nothing of the hull is missing, and what is more is within the margin.
                    assert!((-0.0021..1e-7).contains(&(nearest - whole)), "{whole} {nearest}");
                } else {
                    // The way out of a slab is no longer than that of the hull, but for the margin.
                    assert!((whole - 0.0021..=-0.01 + 1e-9).contains(&nearest), "{whole} {nearest}");
                }
            }
        }
    }

    /// Of a box there are none, nor of what is short.
    #[test]
    fn what_is_small_stays_whole() {
        let cuboid: Vec<Vec3> = (0..8_u8)
            .map(|n| Vec3::new(f64::from(n & 1), 0.1 * f64::from(n >> 1 & 1), 0.1 * f64::from(n >> 2)))
            .collect();
        assert_eq!(Hull::from_points(&cuboid).unwrap().slabs().count(), 0);
        let turns = (0..24).map(|n| libm::sincos(f64::from(n) * 0.3));
        let ring: Vec<Vec3> = turns.flat_map(|(y, x)| [0.0, 0.01].map(|z| Vec3::new(x, y, z) * 0.03)).collect();
        assert_eq!(Hull::from_points(&ring).unwrap().slabs().count(), 0);
    }
}
