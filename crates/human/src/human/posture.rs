//! How far a bend gets before an obstacle is in the way.
//!
//! Without this, a trunk would be pushed through guards, and a fence that conforms to the standards would look
//! hazardous. The human bends from upright until head, neck, chest, shoulder line or spine line would enter an obstacle.

use super::body::world_from_feet;
use super::obstacles::{TOUCHING_M, capsule_hits};
use super::placed::moved;
use super::{BendFraction, Body, PoseBox, Posture};
use crate::geometry::segment_cuboid::segment_cuboid;
use crate::geometry::{Capsule, Cuboid, Vec3};

/// How a guarded shape takes part in the test against one obstacle.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Guard {
    /// With its flesh.
    Whole,
    /// With its core line only: upright, its flesh is in the obstacle already.
    Core,
    /// Not at all: upright, even its core line is in the obstacle.
    Ignored,
}

impl Guard {
    fn of(upright: &Capsule, obstacle: &Cuboid) -> Self {
        if !capsule_hits(upright, obstacle) {
            Self::Whole
        } else if !capsule_hits(&core(upright), obstacle) {
            Self::Core
        } else {
            Self::Ignored
        }
    }

    fn hits(self, capsule: &Capsule, obstacle: &Cuboid) -> bool {
        match self {
            Self::Whole => capsule_hits(capsule, obstacle),
            Self::Core => capsule_hits(&core(capsule), obstacle),
            Self::Ignored => false,
        }
    }
}

const fn core(capsule: &Capsule) -> Capsule {
    Capsule { radius: 0.0, ..*capsule }
}

/// The largest share of the bend that the human reaches from upright, standing at `position` (on the floor, world
/// frame) and looking along `heading_rad`; the full bend when nothing is in the way.
///
/// Head, neck, chest, shoulder line and spine line are swept in sixteenths of the bend, which move the head by at most
/// 45 mm for the default angles, far less than it is thick. A person who stands right beside a wall has a shoulder in it even upright, because
/// walking is blocked by the middle of the body only. Such a part does not forbid every bend: it is held to its core
/// line instead, and if that is in the wall too, the other parts decide.
#[must_use]
pub fn cut_back(body: &Body, position: Vec3, heading_rad: f64, posture: Posture, obstacles: &[Cuboid]) -> BendFraction {
    if posture == Posture::Upright {
        return BendFraction::FULL;
    }
    let reach = body.trunk_reach(position, posture);
    let mut near = obstacles.iter().filter(|obstacle| capsule_hits(&reach, obstacle)).peekable();
    if near.peek().is_none() {
        return BendFraction::FULL;
    }
    let world_from_feet = world_from_feet(position, heading_rad);
    let in_trunk = body.guarded();
    let shapes = |fraction: BendFraction| {
        let world_from_trunk = body.world_from_trunk(&world_from_feet, posture, fraction);
        in_trunk.map(|capsule| moved(&world_from_trunk, &capsule))
    };
    // Who gets down low is not kept from it by what is above: the walk asks whether there is room. Nearest to all of it is what is free.
    let near: Vec<&Cuboid> = near.collect();
    let clear = |shapes: &[Capsule]| near.iter().all(|obstacle| shapes.iter().all(|s| !capsule_hits(s, obstacle)));
    // Knees and feet go through no wall.
    let legs_clear = |fraction: BendFraction| clear(&body.leg_lines(&world_from_feet, posture, fraction));
    if posture.is_low() {
        let is_free = |fraction: &BendFraction| legs_clear(*fraction) && clear(&shapes(*fraction));
        if let Some(lowest) = BendFraction::ALL.into_iter().rev().find(is_free) {
            return lowest;
        }
    }
    let upright = shapes(BendFraction::UPRIGHT);
    let guarded: Vec<_> =
        near.iter().map(|obstacle| (upright.map(|shape| Guard::of(&shape, obstacle)), obstacle)).collect();
    let is_hit = |shapes: &[Capsule]| {
        let hit = |(guard, shape): (&Guard, &Capsule), obstacle| guard.hits(shape, obstacle);
        guarded.iter().any(|(guards, obstacle)| guards.iter().zip(shapes).any(|pair| hit(pair, obstacle)))
    };
    // Upright itself is free by the choice of the guards.
    let is_free = |fraction: &&BendFraction| !is_hit(&shapes(**fraction)) && legs_clear(**fraction);
    let free = BendFraction::ALL[1..].iter().take_while(is_free).count();
    BendFraction::ALL[free]
}

/// The least and the largest share of the bend that [`cut_back`] may give anywhere in a box of places and headings.
#[must_use]
pub fn may_be_cut_back(
    body: &Body,
    at: &PoseBox,
    posture: Posture,
    obstacles: &[Cuboid],
) -> (BendFraction, BendFraction) {
    let reach = body.trunk_reach(at.position(), posture);
    let wider = Capsule { radius: reach.radius + at.place_moves_m() + TOUCHING_M, ..reach };
    let near: Vec<&Cuboid> = obstacles.iter().filter(|obstacle| capsule_hits(&wider, obstacle)).collect();
    if posture == Posture::Upright || near.is_empty() {
        return (BendFraction::FULL, BendFraction::FULL);
    }
    let world_from_feet = world_from_feet(at.position(), at.heading_rad);
    let in_trunk = body.guarded();
    // Of each shape, and each obstacle: signed distance of its core line, and how far it moves in the box.
    let gaps = |fraction: BendFraction| {
        let world_from_trunk = body.world_from_trunk(&world_from_feet, posture, fraction);
        in_trunk.map(|capsule| {
            let Capsule { a, b, radius } = moved(&world_from_trunk, &capsule);
            let lever = |end: Vec3| libm::hypot(end.x - at.xy_m[0], end.y - at.xy_m[1]);
            let moves = at.moves_m(lever(a).max(lever(b))) + TOUCHING_M;
            let gaps: Vec<f64> = near.iter().map(|o| segment_cuboid(a, b, o).distance).collect();
            (gaps, moves, radius)
        })
    };
    let upright = gaps(BendFraction::UPRIGHT);
    // Whether some pose has a shape in an obstacle, and whether all have, however the shape takes part in that.
    let hits = |fraction: BendFraction| {
        let (mut may, mut must) = (false, false);
        for ((gaps, moves, radius), (first, first_moves, _)) in gaps(fraction).iter().zip(&upright) {
            for (gap, first) in gaps.iter().zip(first) {
                let whole = first + first_moves >= *radius;
                let (core, ignored) =
                    (first - first_moves < *radius && first + first_moves >= 0.0, first - first_moves < 0.0);
                let within = |depth: f64| (gap - moves < depth, gap + moves < depth);
                may |= (whole && within(*radius).0) || (core && within(0.0).0);
                must |= !ignored && (!whole || within(*radius).1) && (!core || within(0.0).1);
            }
        }
        (may, must)
    };
    let mut least = None;
    for (number, fraction) in BendFraction::ALL.into_iter().enumerate().skip(1) {
        let (may, must) = hits(fraction);
        if may {
            least.get_or_insert(BendFraction::ALL[number - 1]);
        }
        if must {
            return (least.unwrap_or(BendFraction::ALL[number - 1]), BendFraction::ALL[number - 1]);
        }
    }
    (least.unwrap_or(BendFraction::FULL), BendFraction::FULL)
}

#[cfg(test)]
#[path = "posture_tests.rs"]
mod tests;
