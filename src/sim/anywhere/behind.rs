//! How deep behind a plane that told of them people are, and their arms.
//!
//! Whoever was before a plane when it was last clear has no hand behind it then, but one that leads round its ends or over its
//! top. So a hand is no deeper later than it gets in that time at 2.0 m/s, wherever the shoulder has come to; and while the plane
//! tells of the body, no part of that is either, however it bends. That is the rule of all scans (`sim/curtain.rs`). Nothing is
//! known of people who may have been behind the plane already and yet near enough to tell it of an arm.

use super::{Anywhere, History, Seen};
use crate::geometry::Hull;
use crate::geometry::{Cuboid, Solid, Vec3};
use crate::human::reach::cells::{ArmCells, Target};
use crate::human::{BendFraction, PoseBox, Posture, Side};
use crate::sim::curtain::Curtain;

/// What keeps an arm from a link at an instant, besides what keeps it from all.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Kept {
    /// All of the link is out of reach in time.
    Out,
    /// Everything deeper than so far behind some planes is, m: their numbers.
    Beyond(f64, Vec<usize>),
}

impl Kept {
    /// As walls.
    pub(super) fn walls(&self, curtains: &[Curtain]) -> Vec<Cuboid> {
        match self {
            Self::Out => Vec::new(),
            Self::Beyond(depth_m, planes) => planes.iter().map(|plane| curtains[*plane].beyond(*depth_m)).collect(),
        }
    }
}

/// What is known of a plane.
#[derive(Clone, Debug, Default)]
pub(super) struct ToldOf {
    /// Whether whoever it tells of was before it until then.
    come_before: bool,
    /// The cells of the floor behind it to which people get of whom it has told nothing: another way.
    others: Vec<bool>,
}

impl Anywhere<'_> {
    /// What is known of a plane.
    pub(super) fn told_of(&self, curtain: &Curtain) -> ToldOf {
        let all = ToldOf { come_before: false, others: vec![true; self.ground.cells()] };
        let Some(solid) = solid(&curtain.unbroken()).filter(|_| !curtain.hands_only) else { return all };
        let target = Target { solid: &solid, hand: true, forearm: true, upper_arm: true };
        let arms = ArmCells::new(&self.encounter.arm, &[target], &self.encounter.obstacles, &[]);
        // Other sensors may have told of them.
        let untold = self.untold_by(|sensor| sensor == curtain.sensor);
        let is_behind = |cell: usize| curtain.depth(self.at_height_of_plane(cell)) > 0.0;
        let behind: Vec<bool> = (0..self.ground.cells()).map(|cell| untold[cell] && is_behind(cell)).collect();
        let (centre, radius) = solid.bounding_sphere();
        let near = |cell: usize| (centre - self.at_height_of_plane(cell)).length() <= radius + self.reach_m;
        let mut near_behind = (0..self.ground.cells()).filter(|cell| behind[*cell] && near(*cell));
        if near_behind.any(|cell| self.may_reach(&arms, cell)) {
            return all;
        }
        ToldOf { come_before: true, others: behind }
    }

    fn at_height_of_plane(&self, cell: usize) -> Vec3 {
        let [x, y] = self.ground.middle(cell);
        Vec3::new(x, y, 1.0)
    }

    /// Whether anybody in a cell of the floor may touch what `arms` are about.
    fn may_reach(&self, arms: &ArmCells, cell: usize) -> bool {
        let at = PoseBox {
            xy_m: self.ground.middle(cell),
            half_m: 0.5 * self.ground.cell_m(),
            heading_rad: 0.0,
            half_rad: std::f64::consts::PI,
        };
        Posture::ALL.into_iter().any(|posture| {
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
        (seen, link): (&Seen, &Solid),
        at: &PoseBox,
        (shoulder, moves_m): (Vec3, f64),
    ) -> Option<Kept> {
        if seen.depth_m.is_infinite() {
            return None;
        }
        let reach = self.encounter.arm.reach() + moves_m;
        let mut planes = Vec::new();
        for (number, curtain) in self.curtains.iter().enumerate() {
            let depth = curtain.depth(shoulder);
            let is_told = history.readings[curtain.sensor] == Some(true) && !curtain.hands_only;
            // What holds of arms from before the plane holds of whoever is there.
            let is_limited = || is_told && depth + moves_m <= 0.0 || self.has_told_of(number, is_told, at);
            if !is_limited() || (depth - moves_m <= 0.0 && !curtain.closed.out_of_reach(shoulder, reach, link)) {
                continue;
            }
            if !curtain.within(seen.depth_m, link) {
                return Some(Kept::Out);
            }
            if !curtain.holds(seen.depth_m, link) {
                planes.push(number);
            }
        }
        (!planes.is_empty()).then_some(Kept::Beyond(seen.depth_m, planes))
    }

    /// Whether a plane has told of whoever is in a box, who was before it until then: it does now, or they are behind it where nobody
    /// gets of whom it has told nothing. Who leans over it may be told by other sensors only.
    fn has_told_of(&self, number: usize, is_told: bool, at: &PoseBox) -> bool {
        let ToldOf { come_before, others } = &self.told_of[number];
        let another = || self.ground.within(at.xy_m, at.half_m).any(|cell| others[cell]);
        let is_behind = || self.curtains[number].depth(at.position() + Vec3::Z) > at.place_moves_m();
        *come_before && (is_told || (is_behind() && self.ground.holds(at.xy_m, at.half_m) && !another()))
    }

    /// Whether no part of a body that a plane tells of gets to a link at an instant.
    pub(super) fn keeps_bodies(&self, history: &History, seen: &Seen, link: &Solid) -> bool {
        self.limiting(history, seen).any(|curtain| !curtain.within(seen.depth_m, link))
    }

    /// Whether a body may be met at a point at an instant, as far as planes that tell of it go.
    pub(super) fn may_be_at(&self, history: &History, seen: &Seen, point: Vec3) -> bool {
        self.limiting(history, seen).all(|curtain| curtain.depth(point) <= seen.depth_m)
    }

    /// Planes that tell of a body which was before them.
    fn limiting<'a>(&'a self, history: &'a History, seen: &Seen) -> impl Iterator<Item = &'a Curtain> {
        let is_finite = seen.depth_m.is_finite();
        let planes = self.curtains.iter().zip(&self.told_of).filter(move |_| is_finite);
        let is =
            |(curtain, told): &(&Curtain, &ToldOf)| told.come_before && history.readings[curtain.sensor] == Some(true);
        planes.filter(is).map(|(curtain, _)| curtain)
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
