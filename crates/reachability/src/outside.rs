//! Where people get to from outside by the rules of a scan from the start: what a walk may begin with that is shown.
//!
//! The sets of a search are rounded outwards, so they hold places that nobody gets to: beyond a gap that is a little narrower than a
//! person, or between mats on which every way has a foot. This rounds inwards ([`Inwards`]): doors are closed, every place of a square has
//! room, and no sensor that matters sees whoever is there while they look where they go, bent or not. What it holds is joined to where
//! people come from by ways that somebody can walk; a place beside it counts where a straight way leads there, looked at in every
//! millimetre. Gaps that leave less than 13 mm besides the person may be missed.

use std::sync::{Arc, PoisonError};

use super::internal_sensors::arc;
use super::readings::may_report;
use super::{FLOOR_M, ReachabilitySearch, is_plane, is_reported, starts};
use crate::cell::{DetectionZone, Sensor};
use crate::geometry::polygon::{contains, distance_to_edge};
use crate::geometry::segment_cuboid::point_cuboid;
use crate::geometry::{Cuboid, Vec3};
use crate::human::inwards::Decided;
use crate::human::posture::{cut_back, may_be_cut_back};
use crate::human::{
    Arrangement, Inwards, PoseBox, Posture, Presses, capsule_hits, has_room_throughout, is_without_room,
};
use crate::sim::sensors::{SensorTarget, sees};
use crate::stop::Stop;

/// A place is beside a square if it is no farther from its middle, m.
const BESIDE_M: f64 = 0.03;
/// Straight ways to a place that are tried, and how near to each other places on them are looked at, m.
const MOST_WAYS: usize = 24;
const APART_M: f64 = 0.001;
/// Directions of edges of zones along which ways are looked for, besides x.
const MOST_TURNED: usize = 3;
/// Directions no farther from each other than this are one, rad.
const ALIKE_RAD: f64 = 1e-3;

/// What people get to of whom some sensors tell nothing.
#[derive(Debug)]
pub(super) struct Outside {
    floors: Vec<Inwards>,
    /// Whether they get off the floor's rectangle.
    leaves: bool,
}

impl ReachabilitySearch<'_> {
    /// Whether it is shown that somebody gets there from where people come from, with none of the sensors that `matter` seeing them on the
    /// way: see the top of this file.
    #[must_use]
    pub fn comes_to(&self, xy_m: [f64; 2], matter: &[bool]) -> bool {
        let outside = self.outside_of(matter);
        if !self.ground.holds(xy_m, 0.0) {
            return outside.leaves;
        }
        let rules = Rules::new(self, matter);
        // Who starts there is there.
        rules.has_room(xy_m)
            && (starts(self.cell).contains(&xy_m)
                || outside.floors.iter().any(|floor| {
                    let beside = || floor.near(xy_m, BESIDE_M, true).into_iter().take(MOST_WAYS);
                    floor.is_reached(xy_m) || beside().any(|from| rules.leads(from, xy_m, true))
                }))
    }

    fn outside_of(&self, matter: &[bool]) -> Arc<Outside> {
        let mut known = self.outside.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(outside) = known.get(matter) {
            return Arc::clone(outside);
        }
        let outside = Arc::new(Outside::new(self, matter));
        // What there was no time for is not kept: people get to fewer places by it.
        if !self.encounter.stop.is_due() {
            known.insert(matter.to_vec(), Arc::clone(&outside));
        }
        outside
    }
}

impl Outside {
    fn new(of: &ReachabilitySearch<'_>, matter: &[bool]) -> Self {
        let rules = Rules::new(of, matter);
        let mut floors: Vec<Inwards> = rules
            .turned()
            .into_iter()
            .map(|turned| Inwards::new(of.ground.bounds(), turned, &|at, asked| rules.decide(at, asked), rules.stop()))
            .collect();
        floors.iter_mut().for_each(|floor| rules.join(floor));
        let leaves =
            of.cell.start_region.is_none() || floors.iter().any(|floor| floor.reaches(&|at| rules.is_edge(at)));
        Self { floors, leaves }
    }
}

/// What holds of people, exactly or for all of a box.
struct Rules<'a> {
    of: &'a ReachabilitySearch<'a>,
    /// What is in the way, doors closed.
    obstacles: Vec<Cuboid>,
    /// Sensors that matter and keep people out.
    sensors: Vec<&'a Sensor>,
    /// By sensor, whether it matters and is inside the FMU.
    told: Vec<bool>,
}

impl<'a> Rules<'a> {
    fn new(of: &'a ReachabilitySearch<'_>, matter: &[bool]) -> Self {
        let counts = |(sensor, matters): (&'a Sensor, &bool)| matters.then_some(sensor);
        let all = of.cell.sensors.iter().zip(matter);
        let keeps_out = |sensor: &&Sensor| sensor.zone.keeps_out();
        Self {
            of,
            obstacles: of.cell.standing(Presses::NONE, Arrangement::NONE),
            sensors: all.clone().filter_map(counts).filter(keeps_out).collect(),
            told: all.map(|(sensor, matters)| *matters && is_reported(sensor)).collect(),
        }
    }

    const fn stop(&self) -> &'a Stop {
        &self.of.encounter.stop
    }

    /// How squares are turned: along x, and along edges of zones, as a foot keeps beside those all along.
    fn turned(&self) -> Vec<f64> {
        let polygon = |polygon: &[[f64; 2]]| -> Vec<f64> {
            let next = polygon.iter().cycle().skip(1);
            polygon.iter().zip(next).map(|([a, b], [c, d])| libm::atan2(d - b, c - a)).collect()
        };
        let of_zone = |sensor: &&Sensor| match &sensor.zone {
            DetectionZone::Floor(edges) => polygon(edges),
            DetectionZone::Plane(plane) => {
                let along = plane.rotation * Vec3::X;
                vec![libm::atan2(along.y, along.x)]
            }
            DetectionZone::Post { .. } | DetectionZone::InFmu => Vec::new(),
        };
        let mut turned = vec![0.0];
        for turn in self.sensors.iter().flat_map(of_zone).map(Inwards::turn_of) {
            let is_known = turned.iter().any(|known: &f64| (known - turn).abs() < ALIKE_RAD);
            if !is_known && turned.len() <= MOST_TURNED {
                turned.push(turn);
            }
        }
        turned
    }

    /// People come from where the cell file says, or over the edge of the floor, and are where they start.
    fn join(&self, floor: &mut Inwards) {
        let starts = starts(self.of.cell);
        let leads = |start: &[f64; 2]| {
            let near = floor.near(*start, BESIDE_M, false).into_iter();
            near.filter(|to| self.leads(*start, *to, false)).collect::<Vec<_>>()
        };
        // Whatever sees them there.
        let begun: Vec<[f64; 2]> = starts.iter().flat_map(leads).collect();
        let edge = |at: &PoseBox| self.is_edge(at);
        match &self.of.cell.start_region {
            None => floor.join(&edge, &begun, self.stop()),
            Some(region) => {
                floor.join(&|at| is_in(region, at), &begun, self.stop());
                // Who leaves the rectangle comes back anywhere.
                if floor.reaches(&edge) {
                    floor.join(&edge, &[], self.stop());
                }
            }
        }
    }

    /// Whether all of a box is at the edge of the floor's rectangle or beyond; none of it if there is nothing beyond.
    fn is_edge(&self, at: &PoseBox) -> Option<bool> {
        let moves = at.place_moves_m();
        if self.of.ground.holds(at.xy_m, FLOOR_M + moves) {
            return Some(false);
        }
        (moves < FLOOR_M).then(|| !self.of.ground.holds(at.xy_m, FLOOR_M - moves))
    }

    /// For which headings all of a box is clear, or none of it.
    fn decide(&self, at: &PoseBox, asked: u8) -> Decided {
        let (of, body) = (self.of, &self.of.cell.body);
        let on_floor = of.cell.floor.as_ref().map_or(Some(true), |polygon| is_in(polygon, at));
        if on_floor == Some(false) || is_without_room(body, &self.obstacles, at) {
            return Decided { clear: 0, shut: asked };
        }
        let mut decided = Decided { clear: 0, shut: 0 };
        if on_floor.is_none() || !has_room_throughout(body, &self.obstacles, at) {
            return decided;
        }
        for (number, heading_rad) in Inwards::headings(at.heading_rad).filter(|(number, _)| asked >> number & 1 == 1) {
            match self.is_unseen_in(&PoseBox { heading_rad, ..*at }) {
                Some(true) => decided.clear |= 1 << number,
                Some(false) => decided.shut |= 1 << number,
                None => {}
            }
        }
        decided
    }

    /// Whether everybody in a box is unseen, bent in some way, or nobody is in any.
    fn is_unseen_in(&self, at: &PoseBox) -> Option<bool> {
        let told = self.is_untold_in(at)?;
        if !told {
            return Some(false);
        }
        let body_of = &self.of.cell.body;
        let mut is_shut = true;
        for posture in self.postures(at) {
            let (least, most) = may_be_cut_back(body_of, at, posture, &self.obstacles);
            if least != most {
                is_shut = false;
                continue;
            }
            let body = self.of.placed(at, posture, least);
            let may = self.sensors.iter().map(|sensor| may_report(sensor, body_of, &body, at));
            let (mut sees, mut certainly) = (false, false);
            for may in may {
                sees |= may.see;
                certainly |= !may.clear;
            }
            if !sees {
                return Some(true);
            }
            is_shut &= certainly;
        }
        is_shut.then_some(false)
    }

    /// Ways to bend that make a difference there: only planes tell them apart.
    fn postures(&self, at: &PoseBox) -> Vec<Posture> {
        let (centre, reach_m) = at.around(1.0, self.of.body_m);
        let is_near = |sensor: &&Sensor| {
            is_plane(sensor)
                && sensor.zone.plane().is_some_and(|(plane, _)| point_cuboid(centre, plane).distance <= reach_m)
        };
        if self.sensors.iter().any(is_near) { Posture::USUAL.to_vec() } else { vec![Posture::Upright] }
    }

    /// Whether no sensor inside the FMU tells of anybody in a box, or of everybody. Of people beyond the floor nothing is known.
    fn is_untold_in(&self, at: &PoseBox) -> Option<bool> {
        let Some(told) = self.of.told.as_ref().filter(|_| self.told.contains(&true)) else { return Some(true) };
        if !self.of.ground.holds(at.xy_m, 0.0) {
            return Some(false);
        }
        let clear = |kind: &[bool]| kind.iter().zip(&self.told).all(|(told, matters)| !(*told && *matters));
        let cells = self.of.ground.within(at.xy_m, at.place_moves_m());
        let mut kinds = cells.flat_map(|cell| told.kinds(cell, arc(at.heading_rad))).map(clear);
        let first = kinds.next().unwrap_or(false);
        kinds.all(|other| other == first).then_some(first)
    }

    /// Whether somebody stands there by the rules of a scan from the start, and on the floor.
    fn has_room(&self, xy_m: [f64; 2]) -> bool {
        let capsule = self.of.cell.body.blocking_capsule(Vec3::new(xy_m[0], xy_m[1], 0.0), Posture::Upright);
        let on_floor = self.of.cell.floor.as_ref().is_none_or(|polygon| contains(polygon, xy_m));
        on_floor && !self.obstacles.iter().any(|obstacle| capsule_hits(&capsule, obstacle))
    }

    /// Whether somebody can stand there, bent in some way, with no sensor seeing them.
    fn is_unseen(&self, xy_m: [f64; 2], heading_rad: f64) -> bool {
        let at = PoseBox::point(xy_m, heading_rad);
        let (body, position) = (&self.of.cell.body, at.position());
        let clear = |posture: Posture| {
            let bend = cut_back(body, position, heading_rad, posture, &self.obstacles);
            let seen = SensorTarget {
                feet: body.feet(position, heading_rad),
                besides: None,
                body: Some(self.of.placed(&at, posture, bend)),
                position,
                heading_rad,
            };
            !self.sensors.iter().any(|sensor| sees(sensor, &seen))
        };
        self.is_untold_in(&at) == Some(true) && self.postures(&at).into_iter().any(clear)
    }

    /// Whether somebody walks straight from one place to another, and no sensor sees them, if that is asked for.
    fn leads(&self, from: [f64; 2], to: [f64; 2], unseen: bool) -> bool {
        let way = [0, 1].map(|axis| to[axis] - from[axis]);
        let heading_rad = libm::atan2(way[1], way[0]);
        let mut parts = 1.0;
        while libm::hypot(way[0], way[1]) > parts * APART_M {
            parts += 1.0;
        }
        let mut part = 0.0;
        while part <= parts {
            let at = [0, 1].map(|axis| from[axis] + part / parts * way[axis]);
            if !self.has_room(at) || unseen && !self.is_unseen(at, heading_rad) {
                return false;
            }
            part += 1.0;
        }
        true
    }
}

/// Whether all of a box is in a polygon, or none.
fn is_in(polygon: &[[f64; 2]], at: &PoseBox) -> Option<bool> {
    (distance_to_edge(polygon, at.xy_m) > at.place_moves_m()).then(|| contains(polygon, at.xy_m))
}

#[cfg(test)]
#[path = "outside_tests.rs"]
mod tests;
