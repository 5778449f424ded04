//! Where an arm gets to whatever its shoulder's limits: cubes of space in which a wrist, an elbow or a shoulder may be of an arm
//! that touches a link.
//!
//! An arm is a chain: from a wrist a hand may get to a link; from an elbow a wrist may be got to that does, or the forearm
//! touches one; and from a shoulder an elbow. So what is known of the cubes that wrists are in decides about those of elbows,
//! and they about shoulders. A cube that is not shown to be out of it is halved, down to the smallest. Each is worked out when
//! it is first asked for, and then remembered: many people ask about the same ones.
//!
//! What is told of a cube holds for every point of it: the two ends of a limb are taken to be anywhere in theirs, and a limb is
//! in the way only where it is so for all of them. Directions have no limits here, so no heading changes an answer.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, AtomicU8, Ordering};
use std::sync::{Arc, Mutex, OnceLock, PoisonError};

use super::barrier::{Barrier, Placed, Region};
use super::obstructed::crosses;
use super::sweep::Range;
use super::{ELBOW_ZONE_M, SHOULDER_CLEARANCE_M, cut};
use crate::geometry::distance::point_segment;
use crate::geometry::segment_cuboid::{segment_cuboid, segment_cuboid_apart};
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::human::arm::ArmModel;
use crate::stop::Stop;

/// With more pieces in reach of a limb, it is looked for each cube whether there is time for more.
const CROWD: usize = 200;

/// Half edges of cubes, m, each half the one before.
const HALVES_M: [f64; 6] = [0.1, 0.05, 0.025, 0.0125, 0.00625, 0.003_125];
/// The smallest.
const SMALLEST: usize = HALVES_M.len() - 1;
/// Of cubes no larger than this, half of what the other end of a limb moves is enough: smaller ones would show little more.
const SMALL_ENOUGH: usize = 3;
/// More than what rounding does to a place, m.
const ROUNDING_M: f64 = 1e-9;
/// From the middle of a cube to a corner, as a multiple of half its edge: the root of 3.
const DIAGONAL: f64 = 1.732_050_807_568_877_3;

/// A link that matters, and which parts of an arm it may harm.
pub struct Target<'a> {
    /// The link, world.
    pub solid: &'a Solid,
    /// Hands.
    pub hand: bool,
    /// Forearms, with what counts as elbow.
    pub forearm: bool,
    /// Upper arms.
    pub upper_arm: bool,
}

/// See the top of this file.
pub struct ArmCells {
    arm: ArmModel,
    obstacles: Vec<(Cuboid, f64)>,
    /// What separates, of all of them, and of those that no shoulder passes either.
    barriers: Vec<Barrier>,
    firm: Vec<Barrier>,
    hand: Vec<Piece>,
    forearm: Vec<Piece>,
    upper_arm: Vec<Piece>,
    low: Vec3,
    /// Largest cubes along x, y and z.
    count: [usize; 3],
    known: [CubeMemo; 3],
    /// When it has to end: whatever is not known then may be.
    stop: Option<Stop>,
    /// It was due.
    over: AtomicBool,
    /// Of shoulders that hang from somewhere on these sides of barriers.
    beside: Mutex<BTreeMap<Sides, Arc<CubeMemo>>>,
}

/// Numbers of barriers that no shoulder passes, and the side on which what it hangs from is.
type Sides = Vec<(usize, bool)>;

/// What is known of the cubes of one joint of the chain, of each largest cube by size.
type CubeMemo = Vec<[OnceLock<Box<[AtomicU8]>>; HALVES_M.len()]>;

/// Of more cubes than this those are left out that are in spheres around long pieces and far from the pieces themselves.
const MANY: usize = 100_000;

/// The corner of the largest cubes around what lies between such corners, as far as an arm reaches, and how many there are along x, y and z.
#[expect(
    clippy::cast_possible_truncation,
    clippy::cast_sign_loss,
    reason = "some ten cubes to a side, and a thousand along a hall"
)]
fn cubes(pieces: impl Iterator<Item = (Vec3, Vec3)>, reach_m: f64) -> (Vec3, [usize; 3]) {
    let far = Vec3::splat(reach_m + 2.0 * HALVES_M[0]);
    let around = |(low, high): (Vec3, Vec3), (from, to): (Vec3, Vec3)| (low.min(from - far), high.max(to + far));
    let (low, high) = pieces.fold((Vec3::splat(f64::MAX), Vec3::splat(f64::MIN)), around);
    let size = (high - low).max(Vec3::ZERO);
    (low, size.to_array().map(|size| (size / (2.0 * HALVES_M[0])).ceil().max(1.0) as usize))
}

struct Piece {
    solid: Solid,
    centre: Vec3,
    radius: f64,
}

#[derive(Clone, Copy)]
struct Cube {
    size: usize,
    at: [usize; 3],
}

const UNKNOWN: u8 = 0;
const NOT: u8 = 1;
const MAY: u8 = 2;

impl ArmCells {
    /// For links that matter, at any instant, and everything in the way of arms: obstacles, and what only they do not pass.
    #[must_use]
    pub fn new(arm: &ArmModel, targets: &[Target<'_>], firm: &[Cuboid], others: &[Cuboid]) -> Self {
        let obstacles = [firm, others].concat();
        let pieces = |counts: &dyn Fn(&Target<'_>) -> bool| -> Vec<Piece> {
            let cut = targets.iter().filter(|target| counts(target)).flat_map(|target| cut(target.solid));
            let piece = |solid: Solid| {
                let (centre, radius) = solid.bounding_sphere();
                Piece { solid, centre, radius }
            };
            cut.map(piece).collect()
        };
        let [hand, forearm, upper_arm] =
            [pieces(&|target| target.hand), pieces(&|target| target.forearm), pieces(&|target| target.upper_arm)];
        let all = || hand.iter().chain(&forearm).chain(&upper_arm);
        let spheres =
            all().map(|piece| (piece.centre - Vec3::splat(piece.radius), piece.centre + Vec3::splat(piece.radius)));
        let (mut low, mut count) = cubes(spheres, arm.reach());
        if count.iter().product::<usize>() > MANY {
            (low, count) = cubes(all().map(|piece| piece.solid.bounds()), arm.reach());
        }
        Self {
            arm: *arm,
            obstacles: obstacles.iter().map(|o| (*o, o.half.length())).collect(),
            barriers: Barrier::all(&obstacles),
            firm: Barrier::all(firm),
            hand,
            forearm,
            upper_arm,
            low,
            count,
            known: std::array::from_fn(|_| nothing(count)),
            stop: None,
            over: AtomicBool::new(false),
            beside: Mutex::default(),
        }
    }

    /// The same, but for what is not known yet when `stop` is due: that may be, then.
    #[must_use]
    pub fn heeding(self, stop: &Stop) -> Self {
        Self { stop: Some(stop.clone()), ..self }
    }

    fn is_over(&self) -> bool {
        let Some(stop) = &self.stop else { return false };
        // A cube is asked of each link at each instant: of thousands of pieces.
        let is_over = self.over.load(Ordering::Relaxed) || stop.is_due();
        if is_over {
            self.over.store(true, Ordering::Relaxed);
        }
        is_over
    }

    /// Whether an arm may touch a link harmfully, in some direction, whose shoulder is within `radius_m` of a point: `false`
    /// says that none does.
    #[must_use]
    pub fn may_touch(&self, shoulder: Vec3, radius_m: f64) -> bool {
        let within = Region::ball(shoulder, radius_m);
        self.any(&within, 0.0, &|cube| self.shoulder(cube), &|_| true)
    }

    /// Whether forearm or hand of one may whose elbow is within `radius_m` of a point.
    #[must_use]
    pub(crate) fn may_touch_from_elbow(&self, elbow: Vec3, radius_m: f64) -> bool {
        self.any(&Region::ball(elbow, radius_m), 0.0, &|cube| self.elbow(cube), &|_| true)
    }

    /// The same of a shoulder that hangs from somewhere within `moves_m` of a point, with no obstacle between them; asked where
    /// [`ArmCells::may_touch`] says nothing.
    #[must_use]
    pub fn may_touch_hanging(&self, shoulder: Vec3, radius_m: f64, (from, moves_m): (Vec3, f64)) -> bool {
        let (from, shoulder) = (Region::ball(from, moves_m), Region::ball(shoulder, radius_m));
        let far = (shoulder.centre - from.centre).length() + radius_m + self.arm.upper_arm_m;
        let near = self.firm.iter().enumerate().filter(|(_, barrier)| barrier.is_within(from.centre, far));
        let side = |(number, barrier): (usize, &Barrier)| match barrier.place(&from) {
            Placed::On(inside) => Some((number, inside)),
            Placed::Beyond | Placed::Unclear => None,
        };
        let sides: Sides = near.filter_map(side).collect();
        if sides.is_empty() {
            return true;
        }
        let mut all = self.beside.lock().unwrap_or_else(PoisonError::into_inner);
        let known = Arc::clone(all.entry(sides.clone()).or_insert_with(|| Arc::new(nothing(self.count))));
        drop(all);
        let may = |cube| self.remembered(&known, cube, |region| self.upper_arm_may(region, &sides));
        self.any(&shoulder, 0.0, &may, &|_| true)
    }

    /// Whether some smallest cube that may hold points at `length` from the region passes `may`, as do all that hold it, and is
    /// not shut off by `open`.
    fn any(&self, from: &Region, length: f64, may: &dyn Fn(Cube) -> bool, open: &dyn Fn(&Region) -> bool) -> bool {
        let far = length + from.radius;
        let span = |axis: usize| {
            let (at, low) = (from.centre.to_array()[axis], self.low.to_array()[axis]);
            let edge = 2.0 * HALVES_M[0];
            #[expect(clippy::cast_precision_loss, reason = "some hundred cubes to a side")]
            let cube = |value: f64| ((value - low) / edge).floor().clamp(-1.0, self.count[axis] as f64) + 1.0;
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "clamped to the grid")]
            let span = (cube(at - far) as usize)..(cube(at + far) as usize + 1);
            // Whatever is outside of the grid is out of reach of everything.
            span.start.max(1) - 1..(span.end.max(1) - 1).min(self.count[axis])
        };
        let (x, y, z) = (span(0), span(1), span(2));
        z.into_iter().any(|k| {
            y.clone()
                .any(|j| x.clone().any(|i| self.within(Cube { size: 0, at: [i, j, k] }, (from, length), may, open)))
        })
    }

    fn within(
        &self,
        cube: Cube,
        (from, length): (&Region, f64),
        may: &dyn Fn(Cube) -> bool,
        open: &dyn Fn(&Region) -> bool,
    ) -> bool {
        let region = self.region(cube);
        let beyond = ((region.centre - from.centre).abs() - Vec3::splat(region.half)).max(Vec3::ZERO).length();
        let farthest = ((region.centre - from.centre).abs() + Vec3::splat(region.half)).length();
        if beyond > length + from.radius || farthest < length - from.radius || !may(cube) || !open(&region) {
            return false;
        }
        cube.size == SMALLEST
            || (cube.size >= SMALL_ENOUGH && 2.0 * region.radius <= from.radius)
            || self.parts(cube).into_iter().any(|part| self.within(part, (from, length), may, open))
    }

    /// Whether a hand may get to a link from a wrist in a cube.
    fn wrist(&self, cube: Cube) -> bool {
        self.remembered(&self.known[0], cube, |region| {
            !self.is_blocked(region, self.arm.forearm_radius_m)
                && self.hand.iter().any(|piece| self.hand_may(region, piece))
        })
    }

    fn hand_may(&self, wrist: &Region, piece: &Piece) -> bool {
        let far = self.arm.hand_radius_m + wrist.radius;
        if (piece.centre - wrist.centre).length() - piece.radius > far
            || piece.solid.at_least(wrist.centre, wrist.centre) > far
        {
            return false;
        }
        let near = piece.solid.point_distance(wrist.centre);
        if near.distance > far {
            return false;
        }
        // A wrist that may be inside the link has no line to check.
        if near.distance <= wrist.radius {
            return true;
        }
        let (to, by) = piece.solid.nearest_within(wrist.centre, &near, wrist.radius);
        let to = Region::ball(to, by);
        !self.obstacles.iter().any(|(o, r)| self.blocks(o, *r, (wrist, &to), 0.0))
            && !self.is_round_a_corner(wrist, &to)
    }

    /// Whether forearm or hand may touch a link with the elbow in a cube.
    fn elbow(&self, cube: Cube) -> bool {
        self.remembered(&self.known[1], cube, |elbow| {
            let radius = self.arm.forearm_radius_m;
            if self.is_blocked(elbow, radius.max(self.arm.upper_arm_radius_m)) {
                return false;
            }
            let zone = near(&self.forearm, elbow.centre, elbow.radius + ELBOW_ZONE_M + radius);
            if zone
                .iter()
                .any(|piece| piece.solid.point_distance(elbow.centre).distance <= elbow.radius + ELBOW_ZONE_M + radius)
            {
                return true;
            }
            let beside = near(&self.forearm, elbow.centre, elbow.radius + self.arm.forearm_m + radius);
            self.limb(elbow, (self.arm.forearm_m, radius), &beside, &|cube| self.wrist(cube), &[])
        })
    }

    /// Whether any of the arm may touch a link with the shoulder in a cube.
    fn shoulder(&self, cube: Cube) -> bool {
        self.remembered(&self.known[2], cube, |region| self.upper_arm_may(region, &[]))
    }

    fn upper_arm_may(&self, shoulder: &Region, sides: &[(usize, bool)]) -> bool {
        let (length, radius) = (self.arm.upper_arm_m, self.arm.upper_arm_radius_m);
        let beside = near(&self.upper_arm, shoulder.centre, shoulder.radius + length + radius);
        self.limb(shoulder, (length, radius), &beside, &|cube| self.elbow(cube), sides)
    }

    /// Whether a limb from a region may end in a cube from which the rest of the arm may touch, or touch one of some pieces
    /// itself.
    fn limb(
        &self,
        from: &Region,
        (length, radius): (f64, f64),
        beside: &[&Piece],
        rest: &dyn Fn(Cube) -> bool,
        sides: &[(usize, bool)],
    ) -> bool {
        let obstacles: Vec<_> = self
            .obstacles
            .iter()
            .filter(|(o, r)| (o.centre - from.centre).length() - r <= length + from.radius)
            .collect();
        let is_upper = length.to_bits() == self.arm.upper_arm_m.to_bits();
        let open = |to: &Region| {
            let in_the_way = |o: &Cuboid, r: f64| {
                if !is_upper {
                    return self.blocks(o, r, (from, to), radius);
                }
                // An upper arm may lean against a wall with its shoulder: there only its axis counts.
                let part = ((radius + SHOULDER_CLEARANCE_M) / length).min(1.0);
                let clear = Region::ball(
                    from.centre + (to.centre - from.centre) * part,
                    from.radius + (to.radius - from.radius) * part,
                );
                self.blocks(o, r, (from, to), 0.0) || self.blocks(o, r, (&clear, to), radius)
            };
            !obstacles.iter().any(|(o, r)| in_the_way(o, *r))
                && !self.is_round_a_corner(from, to)
                && !sides.iter().any(|side| self.is_behind(*side, [from, to]))
        };
        let may = |cube: Cube| {
            rest(cube) || (beside.len() > CROWD && self.is_over()) || {
                let to = self.region(cube);
                let far = radius + from.radius.max(to.radius);
                beside.iter().any(|piece| {
                    point_segment(piece.centre, from.centre, to.centre).distance - piece.radius <= far
                        && piece.solid.is_within(far, from.centre, to.centre)
                })
            }
        };
        self.any(from, length, &may, &open)
    }

    /// Whether an obstacle is in the way of a limb wherever its ends are.
    fn blocks(&self, o: &Cuboid, around: f64, (a, b): (&Region, &Region), radius: f64) -> bool {
        let middle = (a.centre + b.centre) * 0.5;
        if (o.centre - middle).length() - around > 0.5 * (b.centre - a.centre).length() + radius
            || segment_cuboid_apart(a.centre, b.centre, o) > radius
        {
            return false;
        }
        segment_cuboid(a.centre, b.centre, o).distance - radius < -a.radius.max(b.radius)
            || crosses(o, [a.centre, b.centre], radius, |n| [a, b].map(|end| Range::NONE.wider(end.along(n))))
    }

    /// Whether a corner of walls is, though it may be neither of them for certain.
    fn is_round_a_corner(&self, a: &Region, b: &Region) -> bool {
        self.barriers.iter().any(|barrier| barrier.is_passed(&[*a, *b]))
    }

    /// Whether a chain certainly passes a barrier that comes from this side of it.
    fn is_behind(&self, (barrier, from): (usize, bool), chain: [&Region; 2]) -> bool {
        for region in chain {
            match self.firm[barrier].place(region) {
                Placed::Beyond => return false,
                Placed::Unclear => {}
                Placed::On(side) if side != from => return true,
                Placed::On(_) => {}
            }
        }
        false
    }

    /// Whether all of a region is within `radius` of one obstacle.
    fn is_blocked(&self, region: &Region, radius: f64) -> bool {
        let corners = |o: &Cuboid| {
            (0..8_u32).all(|number| {
                let sign = |bit: u32| if number >> bit & 1 == 0 { -region.half } else { region.half };
                let corner = region.centre + Vec3::new(sign(0), sign(1), sign(2));
                segment_cuboid(corner, corner, o).distance < radius
            })
        };
        self.obstacles
            .iter()
            .filter(|(o, r)| (o.centre - region.centre).length() <= r + radius)
            // The distance to a convex solid is a convex function: it is greatest in a corner.
            .any(|(o, _)| segment_cuboid(region.centre, region.centre, o).distance < radius && corners(o))
    }

    fn region(&self, cube: Cube) -> Region {
        let half = HALVES_M[cube.size];
        #[expect(clippy::cast_precision_loss, reason = "some thousand cubes to a side")]
        let at = cube.at.map(|at| (2 * at + 1) as f64 * half);
        Region {
            centre: self.low + Vec3::from_array(at),
            radius: DIAGONAL * half + ROUNDING_M,
            half: half + ROUNDING_M,
        }
    }

    fn parts(&self, cube: Cube) -> [Cube; 8] {
        std::array::from_fn(|number| Cube {
            size: cube.size + 1,
            at: std::array::from_fn(|axis| 2 * cube.at[axis] + (number >> axis & 1)),
        })
    }

    fn remembered(&self, known: &CubeMemo, cube: Cube, work: impl FnOnce(&Region) -> bool) -> bool {
        let top = cube.at.map(|at| at >> cube.size);
        let top = (top[2] * self.count[1] + top[1]) * self.count[0] + top[0];
        let of_size = known[top][cube.size]
            .get_or_init(|| std::iter::repeat_with(|| AtomicU8::new(UNKNOWN)).take(1 << (3 * cube.size)).collect());
        let [x, y, z] = cube.at.map(|at| at & ((1 << cube.size) - 1));
        let memory = &of_size[(((z << cube.size) + y) << cube.size) + x];
        match memory.load(Ordering::Relaxed) {
            UNKNOWN if self.is_over() => true,
            UNKNOWN => {
                let may = work(&self.region(cube));
                memory.store(if may { MAY } else { NOT }, Ordering::Relaxed);
                may
            }
            known => known == MAY,
        }
    }
}

/// Pieces that may be within a distance of a point.
fn near(pieces: &[Piece], point: Vec3, far: f64) -> Vec<&Piece> {
    pieces.iter().filter(|piece| (piece.centre - point).length() - piece.radius <= far).collect()
}

/// Nothing yet, of so many largest cubes.
fn nothing(count: [usize; 3]) -> CubeMemo {
    std::iter::repeat_with(Default::default).take(count.iter().product()).collect()
}

#[cfg(test)]
#[path = "cells_tests.rs"]
mod tests;
