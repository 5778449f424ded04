//! What keeps a part of the body from giving way: obstacles, the floor, and other links that a point of the robot's surface moves
//! towards, with less room between than ISO 13854 asks for.
//!
//! The rule is in `docs/src/howto/criteria.md`. Surfaces are looked at by points that are no farther apart than the tolerance
//! of the arm search: a clamping that ends when its point is moved by that may be missed.

use super::Encounter;
use crate::geometry::distance::point_segment;
use crate::geometry::sampled::surface_points;
use crate::geometry::samples::SurfacePoint;
use crate::geometry::segment_cuboid::{point_cuboid, segment_cuboid_apart};
use crate::geometry::{Capsule, Cuboid, Solid, Vec3};
use crate::hazard::contact::{Against, Clamped};
use crate::pinch::{Pinch, ratio};
use crate::robot::RobotFrame;
use crate::standards::BodyRegion;
use crate::standards::iso_13854::{LONGEST_OF_ARMS_M, least_gap_m};

/// How much of a surface faces the push: the cosine of the angle between both is no less.
const FACING: f64 = 0.5;

/// What is nearer than this is met, m.
const MEETS_M: f64 = 5e-4;

/// Farther from a link, a ray goes on by what is soon told of the distance, m.
const SOON_TOLD_M: f64 = 0.01;

/// Steps of a ray before it is given up: it glides along a surface.
const MOST_STEPS: u32 = 1000;

/// What a ray meets.
struct RayHit {
    after_m: f64,
    /// Outward unit normal of what is met.
    outward: Vec3,
    velocity: Vec3,
    against: Against,
}

impl Encounter {
    /// Where links may clamp an arm that has its shoulder at one of these points.
    pub(super) fn pinches_near(&self, frame: &RobotFrame, shoulders: &[Vec3]) -> Vec<Pinch> {
        let Some(clamping) = &self.clamping else { return Vec::new() };
        let within = |at: Vec3, around: f64| {
            shoulders.iter().any(|shoulder| (at - *shoulder).length() - around <= self.arm.reach())
        };
        let links = frame.links.iter().enumerate().filter(|(_, solid)| {
            let (centre, radius) = solid.bounding_sphere();
            within(centre, radius)
        });
        let mut near = Vec::new();
        for (link, _) in links {
            let all = frame.pinches.of(self.number, link, || self.pinches_of(frame, link, clamping.travel_m[link]));
            near.extend(all.iter().copied().filter(|pinch| within(pinch.clamped.at, 0.0)));
        }
        near
    }

    fn pinches_of(&self, frame: &RobotFrame, link: usize, travel_m: f64) -> Vec<Pinch> {
        const ARMS: [BodyRegion; 3] = [BodyRegion::Hand, BodyRegion::LowerArm, BodyRegion::UpperArm];
        let strike = frame.strike(link);
        let longest_m = LONGEST_OF_ARMS_M + travel_m;
        let things = Things::near(self, frame, link, longest_m, &|closing_m_s| {
            ARMS.iter().any(|region| strike.clamped_ratio(*region, closing_m_s) > 1.0)
        });
        if things.is_empty() {
            return Vec::new();
        }
        let points = surface_points(&frame.links[link], self.reach_tolerance_m);
        let at = |point: SurfacePoint| things.clamped_at(&point, travel_m, longest_m);
        let all = points.into_iter().flat_map(at).map(|clamped| Pinch { link, clamped });
        all.filter(|pinch| ARMS.iter().any(|region| pinch.ratio(*region, strike) > 1.0)).collect()
    }

    /// Where a link clamps a part of the body worst, and which region is there: of the points of its surface that are in the part.
    pub(super) fn clamps_part(
        &self,
        part: &Capsule,
        frame: &RobotFrame,
        link: usize,
        region_of: impl Fn(Vec3) -> BodyRegion,
    ) -> Option<(BodyRegion, Clamped)> {
        let clamping = self.clamping.as_ref()?;
        let (strike, travel_m) = (frame.strike(link), clamping.travel_m[link]);
        // Whatever the region there: the widest gap that any part of the body needs.
        let longest_m = crate::standards::iso_13854::LONGEST_M + travel_m;
        let things = Things::near(self, frame, link, longest_m, &|closing_m_s| {
            BodyRegion::ALL.iter().any(|region| strike.clamped_ratio(*region, closing_m_s) > 1.0)
        });
        if things.is_empty() {
            return None;
        }
        let in_part = |point: &SurfacePoint| point_segment(point.at, part.a, part.b).distance <= part.radius;
        let points = surface_points(&frame.links[link], self.reach_tolerance_m);
        let mut worst: Option<(f64, BodyRegion, Clamped)> = None;
        for point in points.iter().filter(|point| in_part(point)) {
            let region = region_of(point.at);
            for clamped in things.clamped_at(point, travel_m, least_gap_m(region) + travel_m) {
                let ratio = ratio(&clamped, region, strike);
                if ratio > worst.as_ref().map_or(1.0, |worst| worst.0) {
                    worst = Some((ratio, region, clamped));
                }
            }
        }
        worst.map(|(_, region, clamped)| (region, clamped))
    }
}

/// What does not give way near a link.
struct Things<'a> {
    frame: &'a RobotFrame,
    link: usize,
    floor: bool,
    obstacles: Vec<(usize, &'a Cuboid)>,
    links: Vec<usize>,
    /// Links that the same part carries: nobody is within them.
    neighbours: Vec<usize>,
}

impl<'a> Things<'a> {
    /// All that is no farther than `longest_m` from the link, and that it may come towards fast enough to matter.
    fn near(
        encounter: &'a Encounter,
        frame: &'a RobotFrame,
        link: usize,
        longest_m: f64,
        matters: &dyn Fn(f64) -> bool,
    ) -> Self {
        let (solid, speed) = (&frame.links[link], frame.speed_bounds[link]);
        let (centre, radius) = solid.bounding_sphere();
        let in_reach = |other: usize| {
            let (other_centre, other_radius) = frame.links[other].bounding_sphere();
            (other_centre - centre).length() - radius - other_radius <= longest_m
        };
        let others = |same_body: bool| {
            let all = (0..frame.links.len()).filter(move |other| *other != link);
            all.filter(move |other| frame.same_body(link, *other) == same_body)
        };
        let fast = |other: &usize| matters(speed + frame.speed_bounds[*other]) && in_reach(*other);
        let links: Vec<usize> = others(false).filter(fast).collect();
        let (mut floor, mut obstacles) = (false, Vec::new());
        // What does not count itself may still be between a link and one that comes towards it.
        if matters(speed) || !links.is_empty() {
            floor = centre.z - radius <= longest_m;
            let apart = |wall: &Cuboid| match solid {
                Solid::Capsule(c) => segment_cuboid_apart(c.a, c.b, wall) - c.radius,
                Solid::Hull(_) | Solid::Mesh(_) => point_cuboid(centre, wall).distance - radius,
            };
            let all = encounter.obstacles.iter().enumerate();
            obstacles.extend(all.filter(|(_, wall)| apart(wall) <= longest_m));
        }
        let neighbours = others(true).filter(|other| in_reach(*other)).collect();
        Self { frame, link, floor, obstacles, links, neighbours }
    }

    const fn is_empty(&self) -> bool {
        !self.floor && self.obstacles.is_empty() && self.links.is_empty()
    }

    /// What a point of the surface clamps against, in both directions of the push.
    fn clamped_at(&self, point: &SurfacePoint, travel_m: f64, longest_m: f64) -> Vec<Clamped> {
        let velocity = self.frame.velocity(self.link, point.at);
        let Some(moves) = velocity.try_normalize().filter(|_| velocity.dot(point.outward) > 0.0) else {
            return Vec::new();
        };
        let clamped = |toward: Vec3| {
            if toward.dot(point.outward) < FACING {
                return None;
            }
            let met = self.met(point.at, toward, longest_m)?;
            let closing_m_s = (velocity - met.velocity).dot(toward);
            (closing_m_s > 0.0 && -met.outward.dot(toward) >= FACING).then_some(Clamped {
                at: point.at,
                toward,
                against: met.against,
                gap_m: met.after_m,
                travel_m,
                closing_m_s,
            })
        };
        [moves, point.outward].into_iter().filter_map(clamped).collect()
    }

    /// The first that a ray meets within some length; nothing for a ray that begins inside of something.
    fn met(&self, from: Vec3, along: Vec3, longest_m: f64) -> Option<RayHit> {
        if self.neighbours.iter().any(|other| self.frame.links[*other].holds(from)) {
            return None;
        }
        let mut first: Option<RayHit> = None;
        let mut longest = longest_m;
        if self.floor {
            if from.z < 0.0 {
                return None;
            }
            let after_m = if along.z < 0.0 { -from.z / along.z } else { f64::INFINITY };
            if after_m <= longest {
                longest = after_m;
                first = Some(RayHit { after_m, outward: Vec3::Z, velocity: Vec3::ZERO, against: Against::Floor });
            }
        }
        for &(number, wall) in &self.obstacles {
            match enters(from, along, wall) {
                Enters::Inside => return None,
                Enters::At(after_m, outward) if after_m <= longest => {
                    longest = after_m;
                    let against = Against::Obstacle(number);
                    first = Some(RayHit { after_m, outward, velocity: Vec3::ZERO, against });
                }
                Enters::At(..) | Enters::Never => {}
            }
        }
        for &other in &self.links {
            let solid = &self.frame.links[other];
            let (centre, radius) = solid.bounding_sphere();
            if point_segment(centre, from, from + along * longest).distance > radius {
                continue;
            }
            if solid.at_least(from, from + along * longest) > MEETS_M {
                continue;
            }
            if solid.holds(from) {
                return None;
            }
            let mut after_m = 0.0;
            for _ in 0..MOST_STEPS {
                let at = from + along * after_m;
                let at_least_m = solid.at_least(at, at);
                if at_least_m > SOON_TOLD_M {
                    after_m += at_least_m;
                    if after_m > longest {
                        break;
                    }
                    continue;
                }
                let near = solid.point_distance(at);
                if near.distance <= MEETS_M {
                    let Some(outward) = solid.outward(&near) else { break };
                    let velocity = self.frame.velocity(other, from + along * after_m);
                    longest = after_m;
                    first = Some(RayHit { after_m, outward, velocity, against: Against::Link(other) });
                    break;
                }
                after_m += near.distance;
                if after_m > longest {
                    break;
                }
            }
        }
        first
    }
}

/// Where a ray enters a box.
enum Enters {
    /// After so many metres, through the face with this outward normal.
    At(f64, Vec3),
    Never,
    /// It begins inside.
    Inside,
}

fn enters(from: Vec3, along: Vec3, wall: &Cuboid) -> Enters {
    let box_from_world = wall.rotation.inverse();
    let (from, along) = ((box_from_world * (from - wall.centre)).to_array(), (box_from_world * along).to_array());
    let half = wall.half.to_array();
    if (0..3).all(|axis| from[axis].abs() < half[axis]) {
        return Enters::Inside;
    }
    let (mut enter, mut leave, mut face) = (f64::NEG_INFINITY, f64::INFINITY, 0);
    for axis in 0..3 {
        if along[axis] == 0.0 {
            if from[axis].abs() > half[axis] {
                return Enters::Never;
            }
            continue;
        }
        let [one, other] = [-half[axis], half[axis]].map(|edge| (edge - from[axis]) / along[axis]);
        if one.min(other) > enter {
            (enter, face) = (one.min(other), axis);
        }
        leave = leave.min(one.max(other));
    }
    if enter > leave || leave < 0.0 || enter < 0.0 {
        return Enters::Never;
    }
    let normal = [Vec3::X, Vec3::Y, Vec3::Z][face] * -along[face].signum();
    Enters::At(enter, wall.rotation * normal)
}

#[cfg(test)]
#[path = "clamping_tests.rs"]
mod tests;
