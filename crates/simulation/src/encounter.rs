//! Person against robot at one instant: is there a contact that harms, and if not, how near is one?
//!
//! Contact rules: every pair of body part and link that overlaps is judged by itself, and so is every part of an arm with
//! every link, so that no harmless contact hides another; an arm whose shoulder is behind a wall is not available; a hand
//! acts only along a free straight line from the wrist.

mod clamping;
mod targets;

pub use self::targets::Judge;
use self::targets::{Target, Targets, arm_region};
use super::Coverage;
use super::robot::RobotFrame;
use crate::geometry::kinematics::Neighbourhood;
use crate::geometry::segment_cuboid::segment_hits_cuboid;
use crate::geometry::{Capsule, Cuboid, Pose, Vec3};
use crate::hazard::STANDSTILL_M_S;
use crate::hazard::contact::Touch;
use crate::hazard::danger::Proximity;
use crate::hazard::finding::ArmPose;
use crate::hazard::{Class, Contact};
use crate::human::arm::ArmModel;
use crate::human::reach::cells::ArmCells;
use crate::human::reach::{ArmContact, ArmSegment, ContactScore as _, ReachQuery, reach};
use crate::human::{BodyPart, PlacedBody, Side, is_kept_from};
use crate::standards::BodyRegion;
use crate::stop::Stop;

/// What an arm check is for.
struct Aim {
    threshold: f64,
    enough: f64,
    work_limit: u32,
    /// Whether an unfinished search may have missed a hazard.
    must_complete: bool,
}

/// Is there a contact above the limit? The guarantee of the method.
const ANY_HAZARD: Aim = Aim { threshold: 1.0, enough: 1.0, work_limit: 2_000_000, must_complete: true };

/// The worst contact, for the record; good enough when the work limit ends it, because what it
/// found is a real contact and nothing is excluded by it.
const WORST: Aim = Aim { threshold: 0.0, enough: f64::INFINITY, work_limit: 10_000, must_complete: false };

/// As much worse than a contact that is known has to be what is looked for, as in each search of the worst.
const CLEARLY_WORSE: f64 = 1.05;

/// The same for the reward of an episode that found nothing, which only steers the search.
const REWARD: Aim = Aim { work_limit: 1_000, ..WORST };

/// The same for many instants together: when that takes long, they are looked at in smaller groups.
const NO_HAZARD: Aim = Aim { work_limit: 10_000, ..ANY_HAZARD };

/// Boxes after which a search about many poses at once gives up: fewer poses are looked at then.
const CARRIED_WORK: u32 = 1_000;

/// The person at one instant.
#[derive(Clone, Debug)]
pub struct Person {
    /// Body in world coordinates.
    pub body: PlacedBody,
    /// Arms whose shoulder is not behind a wall.
    pub arms: Vec<Side>,
    /// Walking velocity, m/s.
    pub velocity: Vec3,
    /// How far wrists are at most from where they are when the arms hang, m; nothing if they may be anywhere.
    pub wrists_m: Option<f64>,
}

/// What stays the same over a scan.
#[derive(Clone, Debug)]
pub struct Encounter {
    /// Its number among those of a cell: each has other obstacles.
    pub number: usize,
    /// Static obstacles.
    pub obstacles: Vec<Cuboid>,
    /// The person's arm.
    pub arm: ArmModel,
    /// Depth of contact that the arm check may miss, m.
    pub reach_tolerance_m: f64,
    /// Whether the worst arm contact is looked for where there is an unsafe one: for the record, not for the verdict.
    pub worst: bool,
    /// What is looked for.
    pub judge: Judge,
    /// What of clamping is known, where it counts.
    pub clamping: Option<Clamping>,
    /// When searches have to end: what they had not finished says nothing then.
    pub stop: Stop,
}

/// What of clamping does not follow from the robots at an instant.
#[derive(Clone, Debug)]
pub struct Clamping {
    /// For each link how far it goes on after a contact, m.
    pub travel_m: Vec<f64>,
}

/// A contact, and the arm pose if an arm makes it.
pub(crate) type Encountered = (Contact, Option<ArmPose>);

/// Unsafe pairs that overlap by no more than this less than the deepest one count as touched first, m: as far as body and
/// robot come towards each other in one or two communication steps.
const TOUCHED_FIRST_M: f64 = 0.02;

/// A body part against a link.
struct Pair {
    distance: f64,
    part: BodyPart,
    capsule: Capsule,
    link: usize,
    on_body: Vec3,
    on_robot: Vec3,
}

/// What is known of the contacts of an arm in many poses of a person.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ArmOverBox {
    /// There is none.
    Nowhere,
    /// There is one in the pose that was asked for, with the link of this number.
    Touches(usize),
    /// Neither was shown.
    Unknown,
}

/// What an arm may touch.
pub struct ArmSpace<'a> {
    /// Walls that block arms, besides the obstacles.
    pub walls: &'a [Cuboid],
    /// For each link whether any of it is in the space the walls leave; others are not looked at.
    pub links: Option<&'a [bool]>,
}

impl ArmSpace<'static> {
    /// All there is.
    pub(crate) const OPEN: Self = Self { walls: &[], links: None };
}

impl Encounter {
    /// The unsafe contact of trunk, head or legs with the robot, if there is one, of those that `counts`: of the pairs touched first the one with the highest ratio of force and limit.
    #[must_use]
    pub fn unsafe_body_contact(
        &self,
        person: &Person,
        frame: &RobotFrame,
        counts: impl Fn(&Contact) -> bool,
        coverage: &mut Coverage,
    ) -> Option<Contact> {
        let touching = self.touching(&person.body, frame, Some(coverage));
        let mut harmful: Vec<Contact> = Vec::new();
        let mut harmless: Option<f64> = None;
        for contact in touching.iter().flat_map(|pair| self.body_contacts(person, frame, pair)) {
            if contact.class().is_none() {
                harmless = Some(harmless.map_or(contact.ratio(), |worst| worst.max(contact.ratio())));
            } else if counts(&contact) {
                harmful.push(contact);
            }
        }
        if let (Some(ratio), true) = (harmless, harmful.is_empty()) {
            within_limits(ratio, coverage);
        }
        let deepest = harmful.iter().map(|c| c.distance_m).fold(f64::INFINITY, f64::min);
        let first = harmful.into_iter().filter(|c| c.distance_m <= deepest + TOUCHED_FIRST_M);
        first.reduce(|worst, c| if c.ratio() > worst.ratio() { c } else { worst }).map(|contact| frame.weighed(contact))
    }

    /// The unsafe contact of an arm with the robot, if there is one: the worse of the two arms, in the space that is
    /// open to them.
    ///
    /// Any arm contact above the limit makes the state unsafe; only then is the worst of them looked for.
    #[must_use]
    pub fn unsafe_arm_contact(
        &self,
        person: &Person,
        frame: &RobotFrame,
        space: &ArmSpace<'_>,
        coverage: &mut Coverage,
    ) -> Option<Encountered> {
        let any = self.arm_contact(person, frame, space, &ANY_HAZARD, coverage)?;
        if !self.worst || matches!(self.judge, Judge::Moving(_)) {
            return Some(any).filter(|(contact, _)| contact.class().is_some());
        }
        // Without clamping the search begins from nothing, as it always has: results stay what they were.
        let least = if self.clamping.is_some() { CLEARLY_WORSE * any.0.ratio() } else { WORST.threshold };
        let aim = Aim { threshold: least, ..WORST };
        let worst = self.arm_contact(person, frame, space, &aim, coverage).filter(|(c, _)| c.ratio() >= any.0.ratio());
        Some(worst.unwrap_or(any)).filter(|(contact, _)| contact.class().is_some())
    }

    /// Whether no arm contact above the limit is possible at any of several instants, shown by one search; the robots
    /// have the same links at all of them. `false` says nothing.
    #[must_use]
    pub(crate) fn no_arm_harmed(
        &self,
        person: &Person,
        frames: &[&RobotFrame],
        space: &ArmSpace<'_>,
        coverage: &mut Coverage,
    ) -> bool {
        if frames.is_empty() {
            return true;
        }
        let shoulders: Vec<Vec3> = person.arms.iter().map(|side| person.body.shoulder(*side).translation).collect();
        let frames: Vec<_> = frames.iter().map(|frame| (*frame, self.pinches_near(frame, &shoulders))).collect();
        let targets = Targets::all(&frames, space.links, person.velocity, self.judge);
        let links = targets.solids();
        let obstacles: Vec<Cuboid> = self.obstacles.iter().chain(space.walls).copied().collect();
        person.arms.iter().all(|&side| {
            coverage.arm_checks += 1;
            let outcome = reach(&ReachQuery {
                arm: &self.arm,
                side,
                world_from_shoulder: person.body.shoulder(side),
                carried_m: 0.0,
                hangs_from: None,
                known: None,
                wrist_within: self.wrist_within(person, side),
                links: &links,
                obstacles: &obstacles,
                score: &targets,
                threshold: NO_HAZARD.threshold,
                tolerance_m: self.reach_tolerance_m,
                enough: NO_HAZARD.enough,
                work_limit: NO_HAZARD.work_limit,
                stop: Some(&self.stop),
            });
            coverage.arm_boxes += u64::from(outcome.boxes);
            outcome.complete && outcome.best.is_none()
        })
    }

    /// An unsafe contact that an arm of somebody who stands can make with one of some links, each at an instant of its own; or
    /// whether there is none wherever shoulder, elbow and wrist are no farther than `carried_m` from where that body has them. To
    /// `try_only` takes little, and often finds one that there is.
    #[must_use]
    pub fn arm_over_box(
        &self,
        (body, side): (&PlacedBody, Side),
        carried_m: f64,
        links: &[(&RobotFrame, usize)],
        (walls, known): (&[Cuboid], &ArmCells),
        try_only: bool,
        coverage: &mut Coverage,
    ) -> ArmOverBox {
        let targets = Targets::each(links);
        let solids = targets.solids();
        let obstacles: Vec<Cuboid> = self.obstacles.iter().chain(walls).copied().collect();
        coverage.arm_checks += 1;
        let outcome = reach(&ReachQuery {
            arm: &self.arm,
            side,
            world_from_shoulder: body.shoulder(side),
            carried_m,
            // Planes are in the way of arms only: the person may stand in them as far as their sensor allows.
            hangs_from: (carried_m > 0.0).then(|| (body.middle_of_shoulders(), self.obstacles.as_slice())),
            known: Some(known),
            wrist_within: None,
            links: &solids,
            obstacles: &obstacles,
            score: &targets,
            threshold: NO_HAZARD.threshold,
            tolerance_m: self.reach_tolerance_m,
            enough: NO_HAZARD.enough,
            work_limit: if carried_m > 0.0 || try_only { CARRIED_WORK } else { ANY_HAZARD.work_limit },
            stop: Some(&self.stop),
        });
        coverage.arm_boxes += u64::from(outcome.boxes);
        match outcome.best {
            Some(found) => ArmOverBox::Touches(found.link),
            None if outcome.complete => ArmOverBox::Nowhere,
            None => ArmOverBox::Unknown,
        }
    }

    /// Whether a link at an instant may harm any arm of somebody who stands.
    #[must_use]
    pub fn may_harm_arms(frame: &RobotFrame, link: usize) -> bool {
        let segments = [ArmSegment::Hand, ArmSegment::Elbow, ArmSegment::Forearm, ArmSegment::UpperArm];
        segments.into_iter().any(|segment| Self::may_harm_arm(frame, link, segment))
    }

    /// The same of a part of an arm.
    #[must_use]
    pub fn may_harm_arm(frame: &RobotFrame, link: usize, segment: ArmSegment) -> bool {
        Targets::each(&[(frame, link)]).upper_bound(segment, 0) > NO_HAZARD.threshold
    }

    /// How near this instant is to harm, for the reward at the end of an episode that found nothing.
    #[must_use]
    pub(crate) fn proximity(
        &self,
        person: &Person,
        frame: &RobotFrame,
        space: &ArmSpace<'_>,
        coverage: &mut Coverage,
    ) -> Proximity {
        let touching = self.touching(&person.body, frame, None);
        let touched = touching
            .iter()
            .map(|pair| Contact::new(&touch_of_body(person, frame, pair), frame.strike(pair.link)).ratio());
        let arm = self.arm_contact(person, frame, space, &REWARD, coverage).map(|(contact, _)| {
            within_limits(contact.ratio(), coverage);
            contact.ratio()
        });
        if let Some(ratio) = touched.chain(arm).reduce(f64::max) {
            return Proximity::Contact { ratio };
        }
        let mut best = Proximity::Far;
        let mut closest = f64::MAX;
        let mut consider = |distance_m: f64, region: BodyRegion, link: usize, from: Vec3, to: Vec3| {
            if distance_m < closest && !self.blocked(from, to) {
                closest = distance_m;
                let ratio = frame.ratio(region, link, frame.velocity(link, to).length());
                best = Proximity::Near { distance_m, ratio };
            }
        };
        for (link, solid) in frame.links.iter().enumerate() {
            for &(part, capsule) in person.body.parts() {
                let near = solid.segment_distance(capsule.a, capsule.b);
                let region = person.body.region_of(part, near.on_first);
                consider(near.distance - capsule.radius, region, link, near.on_first, near.on_second);
            }
            for &side in &person.arms {
                let shoulder = person.body.shoulder(side).translation;
                let near = solid.segment_distance(shoulder, shoulder);
                let distance = (near.distance - self.arm.reach()).max(0.0);
                consider(distance, BodyRegion::Hand, link, shoulder, near.on_second);
            }
        }
        best
    }

    /// A contact that either arm can make, as bad as `aim` asks for.
    fn arm_contact(
        &self,
        person: &Person,
        frame: &RobotFrame,
        space: &ArmSpace<'_>,
        aim: &Aim,
        coverage: &mut Coverage,
    ) -> Option<Encountered> {
        let shoulders: Vec<(Side, Pose)> = person.arms.iter().map(|&s| (s, person.body.shoulder(s))).collect();
        let in_reach = |p: &Pose| {
            frame.links.iter().any(|l| {
                let (centre, radius) = l.bounding_sphere();
                (centre - p.translation).length() - radius <= self.arm.reach()
            })
        };
        if !shoulders.iter().any(|(_, p)| in_reach(p)) {
            return None;
        }
        coverage.checks_with_robot_in_arm_reach += 1;
        let centres: Vec<Vec3> = shoulders.iter().map(|(_, at)| at.translation).collect();
        let targets =
            Targets::all(&[(frame, self.pinches_near(frame, &centres))], space.links, person.velocity, self.judge);
        let targets = targets.that_matter(aim.threshold);
        if !targets.may_matter(aim.threshold) {
            return None;
        }
        let links = targets.solids();
        let mut obstacles = Vec::new();
        let obstacles = if space.walls.is_empty() {
            &self.obstacles
        } else {
            obstacles.extend_from_slice(&self.obstacles);
            obstacles.extend_from_slice(space.walls);
            &obstacles
        };
        let mut worst: Option<Encountered> = None;
        for (side, world_from_shoulder) in shoulders {
            coverage.arm_checks += 1;
            let outcome = reach(&ReachQuery {
                arm: &self.arm,
                side,
                world_from_shoulder,
                carried_m: 0.0,
                hangs_from: None,
                known: None,
                wrist_within: self.wrist_within(person, side),
                links: &links,
                obstacles,
                score: &targets,
                threshold: aim.threshold,
                tolerance_m: self.reach_tolerance_m,
                enough: aim.enough,
                work_limit: aim.work_limit,
                stop: Some(&self.stop),
            });
            coverage.arm_boxes += u64::from(outcome.boxes);
            coverage.arm_checks_incomplete += u64::from(!outcome.complete && aim.must_complete && !self.stop.is_due());
            let Some(found) = outcome.best else { continue };
            let contact = self.arm_touch(person, targets.target(found.link), &found);
            if worst.as_ref().is_none_or(|(w, _)| contact.ratio() > w.ratio()) {
                let pose = ArmPose {
                    left: side == Side::Left,
                    shoulder: world_from_shoulder.translation,
                    elbow: found.elbow,
                    wrist: found.wrist,
                };
                worst = Some((contact, Some(pose)));
            }
        }
        worst
    }

    /// Where the wrist hangs, and no farther from there than this it is.
    fn wrist_within(&self, person: &Person, side: Side) -> Option<(Vec3, f64)> {
        let far_m = person.wrists_m?;
        let (_, hangs) = self.arm.forward(side, [0.0; 4]);
        let shoulder = person.body.shoulder(side);
        Some((shoulder.translation + shoulder.rotation * hangs, far_m))
    }

    /// The walking velocity stands for the arm's own: how fast the arm gets where it is, the method leaves open.
    fn arm_touch(&self, person: &Person, target: &Target<'_>, found: &ArmContact) -> Contact {
        let Target { frame, link, .. } = *target;
        let radius = match found.segment {
            // What is told of a hand is a point of it already.
            ArmSegment::Hand => 0.0,
            ArmSegment::Elbow | ArmSegment::Forearm => self.arm.forearm_radius_m,
            ArmSegment::UpperArm => self.arm.upper_arm_radius_m,
        };
        let inside = found.signed_distance + radius < 0.0;
        let touch = Touch {
            region: arm_region(found.segment),
            area: None,
            link,
            on_robot: found.on_link,
            on_body: on_surface(found.on_arm, found.on_link, inside, radius),
            distance_m: found.signed_distance,
            robot_velocity: frame.velocity(link, found.on_link),
            human_velocity: person.velocity,
        };
        let clamped = target.pinch.as_ref().map(|pinch| &pinch.clamped);
        self.as_judged(frame.weighed(Contact::judged(&touch, clamped, frame.strike(link))))
    }

    /// A contact as what is looked for.
    fn as_judged(&self, contact: Contact) -> Contact {
        match self.judge {
            Judge::Ending => contact,
            Judge::Clamping => contact.as_clamping(),
            Judge::Moving(limit) if contact.speed_m_s > limit.max(STANDSTILL_M_S) => {
                contact.breaking(Some(Class::MovingContact))
            }
            Judge::Moving(_) => contact.breaking(None),
        }
    }

    /// Part of the body and link as they are, however far apart, where no obstacle is between.
    pub(super) fn approach(
        &self,
        person: &Person,
        frame: &RobotFrame,
        (part, capsule): (BodyPart, &Capsule),
        link: usize,
    ) -> Option<Contact> {
        let near = frame.links[link].segment_distance(capsule.a, capsule.b);
        let on_body = on_surface(near.on_first, near.on_second, near.distance < 0.0, capsule.radius);
        let distance = near.distance - capsule.radius;
        if distance > 0.0 && self.blocked(on_body, near.on_second) {
            return None;
        }
        let pair = Pair { distance, part, capsule: *capsule, link, on_body, on_robot: near.on_second };
        Some(Contact::new(&touch_of_body(person, frame, &pair), frame.strike(link)))
    }

    /// The contacts of a part of the body with a link, as what is looked for: as somebody who can give way, and where they cannot.
    fn body_contacts(&self, person: &Person, frame: &RobotFrame, pair: &Pair) -> impl Iterator<Item = Contact> {
        let strike = frame.strike(pair.link);
        let free = Contact::new(&touch_of_body(person, frame, pair), strike);
        let region_of = |at: Vec3| person.body.region_of(pair.part, at);
        let looks = !matches!(self.judge, Judge::Moving(_)) && self.clamping.is_some();
        let held = looks.then(|| self.clamps_part(&pair.capsule, frame, pair.link, region_of)).flatten();
        let held = held.map(|(region, clamped)| {
            let touch = Touch {
                region,
                area: person.body.area_of(pair.part, clamped.at),
                link: pair.link,
                on_robot: clamped.at,
                on_body: clamped.at,
                distance_m: pair.distance,
                robot_velocity: frame.velocity(pair.link, clamped.at),
                human_velocity: person.velocity,
            };
            Contact::judged(&touch, Some(&clamped), strike)
        });
        std::iter::once(free).chain(held).map(|contact| self.as_judged(contact))
    }

    /// The pairs of body part and link that touch or overlap; `coverage` takes in the least signed distance of any pair, and of any
    /// with each robot.
    fn touching(&self, body: &PlacedBody, frame: &RobotFrame, mut coverage: Option<&mut Coverage>) -> Vec<Pair> {
        let mut pairs = Vec::new();
        for (link, solid) in frame.links.iter().enumerate() {
            let (centre, radius) = solid.bounding_sphere();
            let robot = frame.robot(link);
            let mut closest_m = coverage.as_mut().map_or(0.0, |coverage| coverage.robot(robot).closest_approach_m);
            for &(part, capsule) in body.parts() {
                // A cheap lower bound first: most pairs are far from the closest.
                let middle = (capsule.a + capsule.b) * 0.5;
                let half = (capsule.b - capsule.a).length() * 0.5 + capsule.radius;
                let bound = (centre - middle).length() - radius - half;
                if bound > 0.0 && bound >= closest_m {
                    continue;
                }
                let bound = || solid.at_least(capsule.a, capsule.b) - capsule.radius;
                if !solid.is_capsule() && bound() > closest_m.max(0.0) {
                    continue;
                }
                let near = solid.segment_distance(capsule.a, capsule.b);
                let distance = near.distance - capsule.radius;
                closest_m = closest_m.min(distance);
                let is_kept = || self.obstacles.iter().any(|wall| is_kept_from(&capsule, solid, wall));
                if distance <= 0.0 && !is_kept() {
                    let on_body = on_surface(near.on_first, near.on_second, near.distance < 0.0, capsule.radius);
                    pairs.push(Pair { distance, part, capsule, link, on_body, on_robot: near.on_second });
                }
            }
            if let Some(coverage) = &mut coverage {
                coverage.robot(robot).closest_approach_m = closest_m;
                coverage.closest_approach_m = coverage.closest_approach_m.min(closest_m);
            }
        }
        pairs
    }

    fn blocked(&self, from: Vec3, to: Vec3) -> bool {
        self.obstacles.iter().any(|o| segment_hits_cuboid(from, to, o))
    }
}

/// Whether a part of somebody who stands may be harmed by a link at all.
#[must_use]
pub fn may_harm_part(part: BodyPart, frame: &RobotFrame, link: usize, speed_m_s: f64) -> bool {
    part.regions().iter().any(|region| frame.strike(link).may_harm_region(*region, speed_m_s))
}

/// Whether a part of somebody who stands may touch a link harmfully, no point of its core being farther than `by` from where it
/// is in `capsule`. Wherever in that the core is, the touched point of the link is no farther from it than the part is thick, or,
/// from inside the link, than it is deep there.
#[must_use]
pub fn may_meet(part: BodyPart, capsule: &Capsule, by: f64, frame: &RobotFrame, link: usize) -> bool {
    let (solid, within) = (&frame.links[link], capsule.radius + by);
    if !solid.is_within(within, capsule.a, capsule.b) {
        return false;
    }
    let near = solid.segment_distance(capsule.a, capsule.b).distance;
    // Speed is a convex function of the point, so it is greatest around one of the ends.
    let around = capsule.radius.max(by - near) + by;
    let at = |end: Vec3| frame.deciding_speed_bound_near(link, &Neighbourhood::ball(end, around), Vec3::ZERO);
    may_harm_part(part, frame, link, at(capsule.a).max(at(capsule.b)))
}

fn within_limits(ratio: f64, coverage: &mut Coverage) {
    coverage.contacts_within_limits += 1;
    coverage.highest_ratio_within_limits = coverage.highest_ratio_within_limits.max(ratio);
}

/// The point of a capsule's surface towards a point of a link, seen from the nearest point of its axis, which may be `inside`
/// of the link.
fn on_surface(on_axis: Vec3, on_link: Vec3, inside: bool, radius: f64) -> Vec3 {
    let direction = (on_link - on_axis).normalize_or_zero();
    on_axis + if inside { -direction } else { direction } * radius
}

fn touch_of_body(person: &Person, frame: &RobotFrame, pair: &Pair) -> Touch {
    Touch {
        region: person.body.region_of(pair.part, pair.on_body),
        area: person.body.area_of(pair.part, pair.on_body),
        link: pair.link,
        on_robot: pair.on_robot,
        on_body: pair.on_body,
        distance_m: pair.distance,
        robot_velocity: frame.velocity(pair.link, pair.on_robot),
        human_velocity: person.velocity,
    }
}
