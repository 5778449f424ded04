//! Half-spaces, sorted by where they face: those that hold both ends of a segment are passed over by many at once.
//!
//! A convex polyhedron is what its faces' half-spaces have in common, and a segment near it is beyond few of them. They are halved, time
//! and again, along the axis where their normals differ most; of each half it is known how far its normals are from their middle, so no
//! point can be farther beyond one of them than that allows.

use super::Vec3;
use crate::stop::count_work;

/// See the top of this file.
#[derive(Debug)]
pub(super) struct Facing {
    /// A point that all half-spaces hold, or nearly: the nearer it is to what is asked for, the sooner that is told.
    centre: Vec3,
    /// Each group before its halves.
    groups: Vec<Group>,
    /// The outward normal of each, and how far it reaches along that, m; group by group.
    sides: Vec<(Vec3, f64)>,
}

/// Half-spaces that face about the same way.
#[derive(Debug)]
struct Group {
    /// The middle of their normals, and how far the farthest is from there.
    middle: Vec3,
    spread: f64,
    /// How far from the centre the one that ends first ends, m.
    least_m: f64,
    /// The group after this and its halves.
    next: usize,
    /// Of one that is not halved, where its half-spaces are; of another nothing.
    begins: usize,
    ends: usize,
}

/// So many half-spaces are looked at one by one.
const FEW: usize = 8;

/// More than what is worked out here rounds by, m.
const ROUNDING_M: f64 = 1e-9;

impl Facing {
    pub(super) fn new(centre: Vec3, mut sides: Vec<(Vec3, f64)>) -> Self {
        let mut groups = Vec::new();
        if !sides.is_empty() {
            halve(centre, &mut sides, 0, &mut groups);
        }
        Self { centre, groups, sides }
    }

    /// Of each half-space that does not hold the segment from `a` to `b`: how far beyond it both ends are, m. Others may be among them.
    pub(super) fn beyond(&self, a: Vec3, b: Vec3, mut consider: impl FnMut(f64, f64)) {
        let ends = [a - self.centre, b - self.centre];
        let far = ends.map(Vec3::length);
        let mut at = 0;
        while let Some(group) = self.groups.get(at) {
            count_work(1);
            let most = [0, 1].map(|end| group.middle.dot(ends[end]) + group.spread * far[end]);
            if most[0].max(most[1]) + ROUNDING_M <= group.least_m {
                at = group.next;
                continue;
            }
            for (normal, reach) in &self.sides[group.begins..group.ends] {
                consider(normal.dot(a) - reach, normal.dot(b) - reach);
            }
            at += 1;
        }
    }
}

/// Adds the group of these half-spaces, which are the ones from `begins` on, and its halves.
fn halve(centre: Vec3, sides: &mut [(Vec3, f64)], begins: usize, groups: &mut Vec<Group>) {
    let (mut low, mut high) = (Vec3::INFINITY, Vec3::NEG_INFINITY);
    for (normal, _) in &*sides {
        (low, high) = (low.min(*normal), high.max(*normal));
    }
    let middle = (low + high) * 0.5;
    let spread = sides.iter().map(|(normal, _)| (*normal - middle).length()).fold(0.0, f64::max);
    let least_m = sides.iter().map(|(normal, reach)| reach - normal.dot(centre)).fold(f64::INFINITY, f64::min);
    let at = groups.len();
    let is_halved = sides.len() > FEW;
    let ends = if is_halved { begins } else { begins + sides.len() };
    groups.push(Group { middle, spread, least_m, next: 0, begins, ends });
    if is_halved {
        let (axis, half) = (longest(high - low), sides.len() / 2);
        sides.select_nth_unstable_by(half, |one, other| one.0.dot(axis).total_cmp(&other.0.dot(axis)));
        let (first, second) = sides.split_at_mut(half);
        halve(centre, first, begins, groups);
        halve(centre, second, begins + half, groups);
    }
    groups[at].next = groups.len();
}

/// The axis along which a box of this size is longest.
pub(super) fn longest(size: Vec3) -> Vec3 {
    let axes = [Vec3::X, Vec3::Y, Vec3::Z].into_iter();
    axes.fold(Vec3::X, |longest, axis| if size.dot(axis) > size.dot(longest) { axis } else { longest })
}

#[cfg(test)]
mod tests {
    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;

    /// Against looking at all: of faces of a ball, of a flat box and of a single one.
    #[test]
    fn no_half_space_that_does_not_hold_the_segment_is_passed_over() {
        let mut random = Pcg64::seed_from_u64(3);
        let mut unit = || f64::from(random.next_u32()) / f64::from(u32::MAX) * 2.0 - 1.0;
        let mut point = |size: f64| Vec3::new(unit(), unit(), unit()) * size;
        let ball: Vec<(Vec3, f64)> = (0..500).map(|_| (point(1.0).normalize(), 0.3)).collect();
        let axes = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z];
        let flat = axes.map(|axis| (axis, if axis.z == 0.0 { 1.0 } else { 0.01 }));
        let (mut told, mut asked) = (0, 0);
        for sides in [ball, flat.to_vec(), vec![(Vec3::Z, 0.2)], Vec::new()] {
            let facing = Facing::new(Vec3::new(0.02, 0.0, 0.0), sides.clone());
            for _ in 0..2000 {
                let (a, b) = (point(0.5), point(0.5));
                let mut found = Vec::new();
                facing.beyond(a, b, |from, to| {
                    told += 1;
                    if from > 0.0 || to > 0.0 {
                        found.push([from, to]);
                    }
                });
                let all = sides.iter().map(|(normal, reach)| [normal.dot(a) - reach, normal.dot(b) - reach]);
                let mut all: Vec<_> = all.filter(|[from, to]| *from > 0.0 || *to > 0.0).collect();
                let order = |one: &[f64; 2], other: &[f64; 2]| {
                    one[0].total_cmp(&other[0]).then_with(|| one[1].total_cmp(&other[1]))
                };
                found.sort_by(order);
                all.sort_by(order);
                assert_eq!(found, all, "{a} {b}");
                asked += sides.len();
            }
        }
        assert!(told * 2 < asked, "{told} of {asked}");
    }
}
