//! How deep behind a plane that told of them people are, and their arms.
//!
//! Whoever was before a plane when it was last clear has no hand behind it then, but one that leads round its ends or over its
//! top. So a hand is no deeper later than it gets in that time at 2.0 m/s, wherever the shoulder has come to; and while the plane
//! tells of the body, no part of that is either, however it bends. That is the rule of all scans (`sim/curtain.rs`). Nothing is
//! known of people who may have been behind the plane already and yet near enough to tell it of an arm.
//!
//! The same holds of whoever stands before a plane that was clear a step ago, and leans through it since.

use super::{History, ReachabilitySearch, ReachableInstant};
use crate::geometry::{Cuboid, Hull, Solid, Vec3};
use crate::human::reach::cells::{ArmCells, Target};
use crate::human::{BendFraction, Floor, PoseBox, Posture, Side};
use crate::sim::detection_plane::{DetectionPlane, depth_m};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Steps in which somebody may have leaned through a plane that was clear before.
const SINCE_CLEAR: usize = 1;

/// What keeps an arm from a link at an instant, besides what keeps it from all.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kept {
    /// All of the link is out of reach in time.
    Out,
    /// Everything is that is deeper behind planes than an arm may be: how deep it may be behind those that have told, m, and the
    /// planes.
    Beyond(f64, Vec<Limit>),
}

/// A plane that limits how deep an arm may be.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Limit {
    /// It has told of somebody: as deep as an arm gets since.
    Signalled(usize),
    /// It was clear a step ago.
    Clear(usize),
}

/// What is known of a plane.
#[derive(Clone, Debug, Default)]
pub(super) struct SignalledPeople {
    /// Whether whoever it tells of was before it until then.
    come_before: bool,
    /// The cells of the floor behind it to which people get of whom it has told nothing: another way.
    others: Vec<bool>,
}

impl SignalledPeople {
    /// Whether somebody in a box may be one of whom it has told nothing.
    fn may_have_come_another_way(&self, ground: &Floor, at: &PoseBox) -> bool {
        !ground.holds(at.xy_m, at.half_m) || ground.within(at.xy_m, at.half_m).any(|cell| self.others[cell])
    }
}

/// Everybody in a cell of the floor, whatever they look at.
fn everybody_in(ground: &Floor, cell: usize) -> PoseBox {
    PoseBox {
        xy_m: ground.middle(cell),
        half_m: 0.5 * ground.cell_m(),
        heading_rad: 0.0,
        half_rad: std::f64::consts::PI,
    }
}

/// Whether everybody in a box is behind a plane.
fn is_behind(curtain: &DetectionPlane, at: &PoseBox) -> bool {
    curtain.depth(at.position() + Vec3::Z) > at.place_moves_m()
}

/// Whether everybody in a box has the hip before a plane, and no way from there to a link round its ends or over its top that is
/// short enough, `from_hip` being the hip's height and the longest reach from it, m.
fn gets_there_through_it_only(
    curtain: &DetectionPlane,
    (height_m, reach_m): (f64, f64),
    link: &Solid,
    at: &PoseBox,
) -> bool {
    let (hip, reach_m) = at.around(height_m, reach_m);
    curtain.depth(hip) + at.place_moves_m() <= 0.0 && curtain.closed.out_of_reach(hip, reach_m, link)
}

impl ReachabilitySearch<'_> {
    /// What is known of a plane; nothing, where there is no time for it.
    pub(super) fn tells_of(&self, curtain: &DetectionPlane) -> Option<SignalledPeople> {
        let all = SignalledPeople { come_before: false, others: vec![true; self.ground.cells()] };
        let Some(solid) = solid(&curtain.unbroken()).filter(|_| !curtain.hands_only) else { return Some(all) };
        let target = Target { solid: &solid, hand: true, forearm: true, upper_arm: true };
        let arms =
            ArmCells::new(&self.encounter.arm, &[target], &self.encounter.obstacles, &[]).heeding(&self.encounter.stop);
        // Other sensors may have told of them.
        let untold = self.untold_by(|sensor| sensor == curtain.sensor)?;
        let is_behind = |cell: usize| curtain.depth(self.at_height_of_plane(cell)) > 0.0;
        let behind: Vec<bool> = (0..self.ground.cells()).map(|cell| untold[cell] && is_behind(cell)).collect();
        let (centre, radius) = solid.bounding_sphere();
        let near = |cell: usize| (centre - self.at_height_of_plane(cell)).length() <= radius + self.reach_m;
        let near_behind = (0..self.ground.cells()).filter(|cell| behind[*cell] && near(*cell));
        for cell in near_behind {
            if self.encounter.stop.is_due() {
                return None;
            }
            if self.may_reach(&arms, cell) {
                return Some(all);
            }
        }
        Some(SignalledPeople { come_before: true, others: behind })
    }

    fn at_height_of_plane(&self, cell: usize) -> Vec3 {
        let [x, y] = self.ground.middle(cell);
        Vec3::new(x, y, 1.0)
    }

    /// Whether anybody in a cell of the floor may touch what `arms` are about.
    fn may_reach(&self, arms: &ArmCells, cell: usize) -> bool {
        let at = everybody_in(&self.ground, cell);
        Posture::USUAL.into_iter().any(|posture| {
            BendFraction::ALL
                .into_iter()
                .any(|bend| Side::BOTH.into_iter().any(|side| !self.is_out_of_reach(arms, &at, (posture, bend, side))))
        })
    }

    /// What keeps an arm of somebody in a box, whose shoulder is within `moves_m` of a point, from a link at an instant, if anything
    /// more does than at others.
    pub(super) fn kept(
        &self,
        history: &History,
        (seen, link): (&ReachableInstant, &Solid),
        at: &PoseBox,
        (shoulder, moves_m): (Vec3, f64),
    ) -> Option<Kept> {
        let reach = self.encounter.arm.reach() + moves_m;
        let mut limits = Vec::new();
        for (number, curtain) in self.curtains.iter().enumerate() {
            let depth = curtain.depth(shoulder);
            let is_told = history.readings[curtain.sensor] == Some(true) && !curtain.hands_only;
            // What holds of arms from before the plane holds of whoever is there.
            let is_limited = || is_told && depth + moves_m <= 0.0 || self.has_told_of(number, is_told, at);
            let reaches_round = || depth - moves_m <= 0.0 && !curtain.closed.out_of_reach(shoulder, reach, link);
            let limit = if seen.depth_m.is_finite() && is_limited() && !reaches_round() {
                Limit::Signalled(number)
            } else if depth + moves_m > 0.0 && self.leans_through(curtain, history, link, at) {
                Limit::Clear(number)
            } else {
                continue;
            };
            let depth_m = self.depth_m(limit, seen.depth_m);
            if !curtain.within(depth_m, link) {
                return Some(Kept::Out);
            }
            if !curtain.holds(depth_m, link) {
                limits.push(limit);
            }
        }
        (!limits.is_empty()).then_some(Kept::Beyond(seen.depth_m, limits))
    }

    /// How deep an arm may be, m, where it may be as deep as that behind planes that have told.
    fn depth_m(&self, limit: Limit, told_m: f64) -> f64 {
        match limit {
            Limit::Signalled(_) => told_m,
            Limit::Clear(_) => depth_m(SINCE_CLEAR, self.cell.step_s, WALKING_SPEED_M_S),
        }
    }

    /// What nothing of an arm gets to then.
    pub(super) fn beyond(&self, limit: Limit, told_m: f64) -> Cuboid {
        let (Limit::Signalled(number) | Limit::Clear(number)) = limit;
        self.curtains[number].beyond(self.depth_m(limit, told_m))
    }

    /// Whether whoever is in a box gets to a link behind a plane only through it, which was clear a step ago: they stand before it,
    /// and no way round its ends or over its top is short enough.
    fn leans_through(&self, curtain: &DetectionPlane, history: &History, link: &Solid, at: &PoseBox) -> bool {
        let from_hip = self.cell.body.reach_from_hip(self.encounter.arm.reach());
        history.readings[curtain.sensor] == Some(false)
            && !curtain.hands_only
            && gets_there_through_it_only(curtain, from_hip, link, at)
    }

    /// Whether a plane has told of whoever is in a box, who was before it until then: it does now, or they are behind it where nobody
    /// gets of whom it has told nothing. Who leans over it may be told by other sensors only.
    fn has_told_of(&self, number: usize, is_told: bool, at: &PoseBox) -> bool {
        let is_known = |told_of: &SignalledPeople| {
            told_of.come_before
                && (is_told
                    || (is_behind(&self.curtains[number], at) && !told_of.may_have_come_another_way(&self.ground, at)))
        };
        self.told_of(number).is_some_and(is_known)
    }

    /// Whether planes keep the body of whoever is in a box from a link at an instant.
    pub(super) fn keeps_bodies(
        &self,
        history: &History,
        (seen, link): (&ReachableInstant, &Solid),
        at: &PoseBox,
    ) -> bool {
        self.limiting(history, (seen, link), at).any(|(curtain, depth_m)| !curtain.within(depth_m, link))
    }

    /// Whether a body may be met at a point of a link at an instant, as far as planes go.
    pub(super) fn may_be_at(
        &self,
        history: &History,
        (seen, link): (&ReachableInstant, &Solid),
        at: &PoseBox,
        point: Vec3,
    ) -> bool {
        self.limiting(history, (seen, link), at).all(|(curtain, depth_m)| curtain.depth(point) <= depth_m)
    }

    /// Planes that limit how deep a body may be behind them, with the depth, m: those that tell of one which was before them, and
    /// those that were clear a step ago.
    fn limiting<'a>(
        &'a self,
        history: &'a History,
        (seen, link): (&'a ReachableInstant, &'a Solid),
        at: &'a PoseBox,
    ) -> impl Iterator<Item = (&'a DetectionPlane, f64)> {
        self.curtains.iter().enumerate().filter_map(move |(number, curtain)| {
            let has_told = || {
                history.readings[curtain.sensor] == Some(true)
                    && self.told_of(number).is_some_and(|told_of| told_of.come_before)
            };
            let limit = if seen.depth_m.is_finite() && has_told() {
                Limit::Signalled(number)
            } else if self.leans_through(curtain, history, link, at) {
                Limit::Clear(number)
            } else {
                return None;
            };
            Some((curtain, self.depth_m(limit, seen.depth_m)))
        })
    }
}

/// A box as a solid.
fn solid(cuboid: &Cuboid) -> Option<Solid> {
    let corner = |bits: u8| {
        let sign = |bit: u8| if bits >> bit & 1 == 1 { 1.0 } else { -1.0 };
        cuboid.centre + cuboid.rotation * (cuboid.half * Vec3::new(sign(0), sign(1), sign(2)))
    };
    Hull::from_points(&(0..8).map(corner).collect::<Vec<_>>()).map(Solid::Hull)
}

#[cfg(test)]
#[path = "behind_tests.rs"]
mod tests;
