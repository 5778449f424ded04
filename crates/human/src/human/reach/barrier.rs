//! What separates places: walls, and the corners in which two of them meet. A chain of lines from one side to the other passes
//! through the boxes that they are made of.
//!
//! A wall is the middle plane of a flat box, as far as the box goes. At a corner it may be certain of neither wall that it is
//! passed, but of both together: their middle planes meet in a line, and from there the two half planes are the boundary of a
//! wedge. A chain from inside the wedge to outside of it crosses that boundary, and if no point of the chain is beyond the ends
//! of the boxes, it does so in a box.

use crate::geometry::{Cuboid, Vec3};

/// Middle planes of boxes that end this far from each other meet, m: room that nothing gets through.
const GAP_M: f64 = 1e-6;
/// Axes of boxes that differ by less are one.
const SAME: f64 = 1e-9;
/// Walls that go on for less from a corner do not matter, m.
const SHORT_M: f64 = 0.05;

/// Points around one: a ball, and an upright cube that holds them as well.
#[derive(Clone, Copy, Debug)]
pub(super) struct Region {
    pub(super) centre: Vec3,
    pub(super) radius: f64,
    /// Half the edge of the cube; infinite for none.
    pub(super) half: f64,
}

impl Region {
    pub(super) const fn ball(centre: Vec3, radius: f64) -> Self {
        Self { centre, radius, half: f64::INFINITY }
    }

    /// How far its points are from the middle along a direction, at most.
    pub(super) fn along(&self, n: Vec3) -> f64 {
        let n = n.abs();
        self.radius.min(self.half * (n.x + n.y + n.z))
    }
}

/// Where all of a region is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Placed {
    /// Some of it may be beyond the ends: what is between it and anything else may pass there.
    Beyond,
    /// On either side.
    Unclear,
    /// On one side, inside the wedge for a corner.
    On(bool),
}

/// See the top of this file.
#[derive(Clone, Copy, Debug)]
pub(super) struct Barrier {
    /// A point of the plane, or of the line in which walls meet.
    at: Vec3,
    /// How far it goes in each of some directions, m.
    ends: [(Vec3, f64); 4],
    /// The normals that point to one side; inside of a wedge is on that side of both.
    inwards: [Vec3; 2],
}

impl Barrier {
    /// Every wall and every corner of the boxes.
    pub(super) fn all(boxes: &[Cuboid]) -> Vec<Self> {
        let pairs = boxes.iter().enumerate().flat_map(|(n, a)| boxes[n + 1..].iter().map(move |b| [a, b]));
        boxes.iter().map(Self::wall).chain(pairs.flat_map(Self::corners)).collect()
    }

    fn wall(o: &Cuboid) -> Self {
        let (axes, half, thin) = axes(o);
        let [first, second] = [(thin + 1) % 3, (thin + 2) % 3].map(|i| (axes[i], half[i]));
        let ends = [first, (-first.0, first.1), second, (-second.0, second.1)];
        Self { at: o.centre, ends, inwards: [axes[thin]; 2] }
    }

    /// The wedges between two boxes.
    fn corners(boxes: [&Cuboid; 2]) -> Vec<Self> {
        let [(axes, halves, thin), others] = boxes.map(axes);
        let (axes, halves, thin) = ([axes, others.0], [halves, others.1], [thin, others.2]);
        let normals = [0, 1].map(|n| axes[n][thin[n]]);
        let across = normals[0].cross(normals[1]);
        let Some(axis) = across.try_normalize() else { return Vec::new() };
        // Which of its other axes is the common one; the remaining one is along the wall.
        let common = [0, 1].map(|n| (0..3).find(|i| *i != thin[n] && axes[n][*i].cross(axis).length() < SAME));
        let [Some(first), Some(second)] = common else { return Vec::new() };
        let common = [first, second];
        let long = [0, 1].map(|n| 3 - thin[n] - common[n]);
        // The point of the line in which the middle planes meet that is nearest to the first box's middle.
        let from = boxes[0].centre;
        let along = axes[0][long[0]];
        let towards = along.dot(normals[1]);
        if towards.abs() < SAME {
            return Vec::new();
        }
        let at = from + along * ((boxes[1].centre - from).dot(normals[1]) / towards);
        let offset = [0, 1].map(|n| (at - boxes[n].centre).dot(axes[n][long[n]]));
        if (0..2).any(|n| offset[n].abs() > halves[n][long[n]] + GAP_M) {
            return Vec::new();
        }
        let middle = [0, 1].map(|n| (boxes[n].centre - at).dot(axis));
        let down = (0..2).fold(f64::MIN, |low, n| low.max(middle[n] - halves[n][common[n]]));
        let up = (0..2).fold(f64::MAX, |high, n| high.min(middle[n] + halves[n][common[n]]));
        let all = [[1.0, 1.0], [1.0, -1.0], [-1.0, 1.0], [-1.0, -1.0]].into_iter().filter_map(|signs| {
            let along = [0, 1].map(|n: usize| (axes[n][long[n]] * signs[n], halves[n][long[n]] - signs[n] * offset[n]));
            let inwards = [0, 1].map(|n: usize| normals[n] * normals[n].dot(along[1 - n].0).signum());
            let goes_on = down < up && along.iter().all(|(_, far)| *far > SHORT_M);
            goes_on.then_some(Self { at, ends: [along[0], along[1], (axis, up), (-axis, -down)], inwards })
        });
        all.collect()
    }

    /// How far it is from a point at least, m, and so everything that it separates.
    pub(super) fn is_within(&self, point: Vec3, far: f64) -> bool {
        let from = point - self.at;
        self.inwards.iter().any(|inwards| from.dot(*inwards).abs() <= far)
            && self.ends.iter().all(|(along, end)| from.dot(*along) - end <= far)
    }

    /// Where a region is.
    pub(super) fn place(&self, region: &Region) -> Placed {
        let from = region.centre - self.at;
        if self.ends.iter().any(|(along, end)| from.dot(*along) + region.along(*along) >= *end) {
            Placed::Beyond
        } else if self.inwards.iter().all(|inwards| from.dot(*inwards) > region.along(*inwards)) {
            Placed::On(true)
        } else if self.inwards.iter().any(|inwards| from.dot(*inwards) < -region.along(*inwards)) {
            Placed::On(false)
        } else {
            Placed::Unclear
        }
    }

    /// Whether a chain of lines certainly passes through it, wherever its corners are in their regions.
    pub(super) fn is_passed(&self, chain: &[Region]) -> bool {
        let mut side = None;
        for region in chain {
            match self.place(region) {
                Placed::Beyond => return false,
                Placed::Unclear => {}
                Placed::On(inside) if *side.get_or_insert(inside) != inside => return true,
                Placed::On(_) => {}
            }
        }
        false
    }
}

/// The axes of a box, half of how far it goes along each, and along which that is least.
fn axes(o: &Cuboid) -> ([Vec3; 3], [f64; 3], usize) {
    let half = o.half.to_array();
    let thin = (1..3).fold(0, |t, i| if half[i] < half[t] { i } else { t });
    ([Vec3::X, Vec3::Y, Vec3::Z].map(|axis| o.rotation * axis), half, thin)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::rotation_about;
    use crate::geometry::segment_cuboid::segment_hits_cuboid;
    use crate::search::Rng;

    /// Random lines around the corner of two walls: where they are said to cross, so does every line whose ends are as near; and
    /// of lines that barely move it is said mostly, where each wall by itself leaves them out.
    #[test]
    fn what_is_said_to_cross_does_so_wherever_its_ends_are() {
        let mut rng = Rng::new(41);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let (mut said, mut crossing, mut missed) = (0, 0, 0);
        for _ in 0..20_000 {
            let turned = rotation_about(Vec3::Z, uniform(0.0, 6.0));
            let opening = rotation_about(Vec3::Z, uniform(0.6, 2.5));
            let half = Vec3::new(0.8, 0.01, 1.0);
            let wall = |rotation| Cuboid { centre: rotation * Vec3::new(0.8, 0.0, 1.0), half, rotation };
            let walls = [wall(turned), wall(turned * opening)];
            let mut point = || Vec3::new(uniform(-0.5, 0.5), uniform(-0.5, 0.5), uniform(0.2, 1.8));
            let chain = [point(), point()];
            let mut vector = || Vec3::new(uniform(-1.0, 1.0), uniform(-1.0, 1.0), uniform(-1.0, 1.0));
            let by = 0.1 * vector().x.abs();
            let hits = |chain: &[Vec3; 2]| walls.iter().any(|o| segment_hits_cuboid(chain[0], chain[1], o));
            let all = Barrier::all(&walls);
            assert_eq!(all.len(), 3);
            let corner = all[2];
            let says = corner.is_passed(&chain.map(|end| Region::ball(end, by)));
            let well_inside = corner.is_passed(&chain.map(|end| Region::ball(end, 0.03)));
            crossing += usize::from(hits(&chain));
            missed += usize::from(well_inside && !hits(&chain));
            if says {
                said += 1;
                for _ in 0..10 {
                    let other = chain.map(|end| end + vector().normalize_or_zero() * by);
                    assert!(hits(&other), "{chain:?} {by} {other:?} {walls:?}");
                }
            }
        }
        assert!(said > 2000 && crossing > said && missed == 0, "{said} of {crossing}, {missed}");
    }

    /// Random chains and boxes: where a chain is said to cross, so does every one whose corners are as near.
    #[test]
    fn chains_that_cross_do_so_wherever_their_corners_are() {
        let mut rng = Rng::new(23);
        let mut uniform = |low: f64, high: f64| {
            low + (high - low) * f64::from(u32::try_from(rng.below(1 << 20)).unwrap()) / f64::from(1 << 20)
        };
        let mut vector = |size: f64| Vec3::new(uniform(-size, size), uniform(-size, size), uniform(-size, size));
        let (mut cross, mut said) = (0, 0);
        for _ in 0..20_000 {
            let o = Cuboid {
                centre: vector(0.2),
                half: Vec3::new(0.7, 0.01, 0.9) + vector(0.005),
                rotation: rotation_about(vector(1.0).normalize(), 1.0),
            };
            let chain: [Vec3; 4] = std::array::from_fn(|_| vector(0.5));
            let moves: [f64; 4] = std::array::from_fn(|_| vector(0.1).x.abs());
            let crosses = |chain: &[Vec3; 4]| chain.windows(2).any(|ends| segment_hits_cuboid(ends[0], ends[1], &o));
            cross += usize::from(crosses(&chain));
            let regions: [Region; 4] = std::array::from_fn(|n| Region::ball(chain[n], moves[n]));
            if !Barrier::wall(&o).is_passed(&regions) {
                continue;
            }
            said += 1;
            for _ in 0..10 {
                let other = std::array::from_fn(|n| chain[n] + vector(1.0).normalize_or_zero() * moves[n]);
                assert!(crosses(&other), "{chain:?} {moves:?} {other:?} {o:?}");
            }
        }
        assert!(said > 1000 && cross > 2 * said / 2, "{said} of {cross}");
    }
}
