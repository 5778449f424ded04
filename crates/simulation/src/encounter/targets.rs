//! What an arm may touch, and how bad that is: links at one instant or several, and places where links clamp it.

use std::borrow::Cow;

use crate::geometry::kinematics::Neighbourhood;
use crate::geometry::{Capsule, Solid, Vec3};
use crate::human::reach::{ArmSegment, ContactScore};
use crate::pinch::Pinch;
use crate::robot::RobotFrame;
use crate::standards::BodyRegion;

/// What is looked for.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum Judge {
    /// Contacts that break a limit: sequences end with them.
    #[default]
    Ending,
    /// Clampings, whatever else a contact breaks.
    Clamping,
    /// Contacts with a point of the robot that is faster than this, m/s.
    Moving(f64),
}

/// A link, or a place where it clamps an arm.
pub(super) struct Target<'a> {
    pub(super) frame: &'a RobotFrame,
    pub(super) link: usize,
    pub(super) pinch: Option<Pinch>,
    /// Whether it is looked at.
    counts: bool,
}

/// All that an arm of a person who walks at some velocity may touch.
pub(super) struct Targets<'a> {
    all: Vec<Target<'a>>,
    /// Links of a single instant, all of them and nothing else.
    links: Option<&'a [Solid]>,
    velocity: Vec3,
    judge: Judge,
}

pub(super) const fn arm_region(segment: ArmSegment) -> BodyRegion {
    match segment {
        ArmSegment::Hand => BodyRegion::Hand,
        ArmSegment::UpperArm | ArmSegment::Elbow => BodyRegion::UpperArm,
        ArmSegment::Forearm => BodyRegion::LowerArm,
    }
}

impl<'a> Targets<'a> {
    /// All links of some instants, of which those count that are named so, one instant after the other; and where they clamp arms.
    pub(super) fn all(
        frames: &[(&'a RobotFrame, Vec<Pinch>)],
        counts: Option<&[bool]>,
        velocity: Vec3,
        judge: Judge,
    ) -> Self {
        let mut all = Vec::new();
        let mut before = 0;
        for (frame, pinches) in frames {
            let counts = |link: usize| counts.is_none_or(|counts| counts[before + link]);
            let links = (0..frame.links.len()).map(|link| Target { frame, link, pinch: None, counts: counts(link) });
            all.extend(links);
            let places = pinches.iter().map(|&pinch| {
                let link = pinch.link;
                Target { frame, link, pinch: Some(pinch), counts: counts(link) }
            });
            if !matches!(judge, Judge::Moving(_)) {
                all.extend(places);
            }
            before += frame.links.len();
        }
        let links = match frames {
            [(frame, _)] if frame.links.len() == all.len() => Some(frame.links.as_slice()),
            _ => None,
        };
        Self { all, links, velocity, judge }
    }

    /// The same without those that are never bad enough, where there are others than the links of a single instant.
    pub(super) fn that_matter(mut self, threshold: f64) -> Self {
        if self.links.is_none() {
            let matters: Vec<bool> = (0..self.all.len()).map(|number| self.matters(number, threshold)).collect();
            let mut matters = matters.into_iter();
            self.all.retain(|_| matters.next().unwrap_or(true));
        }
        self
    }

    fn matters(&self, number: usize, threshold: f64) -> bool {
        let segments = [ArmSegment::Hand, ArmSegment::Forearm, ArmSegment::UpperArm];
        segments.iter().any(|segment| self.upper_bound(*segment, number) > threshold)
    }

    /// Links, each at an instant of its own, of somebody who stands.
    pub(super) fn each(links: &[(&'a RobotFrame, usize)]) -> Self {
        let all = links.iter().map(|&(frame, link)| Target { frame, link, pinch: None, counts: true }).collect();
        Self { all, links: None, velocity: Vec3::ZERO, judge: Judge::Ending }
    }

    /// That of a number.
    pub(super) fn target(&self, number: usize) -> &Target<'a> {
        &self.all[number]
    }

    /// Whether any contact with one of them could be bad enough.
    pub(super) fn may_matter(&self, threshold: f64) -> bool {
        (0..self.all.len()).any(|number| self.matters(number, threshold))
    }

    /// Their shapes.
    pub(super) fn solids(&self) -> Cow<'a, [Solid]> {
        if let Some(links) = self.links {
            return Cow::Borrowed(links);
        }
        let solid = |target: &Target<'a>| match target.pinch {
            None => target.frame.links[target.link].clone(),
            Some(pinch) => Solid::Capsule(Capsule { a: pinch.clamped.at, b: pinch.clamped.at, radius: 0.0 }),
        };
        self.all.iter().map(solid).collect()
    }

    fn of_moving(limit_m_s: f64, speed_m_s: f64) -> f64 {
        if speed_m_s > limit_m_s { 1.0 + speed_m_s } else { 0.0 }
    }
}

impl ContactScore for Targets<'_> {
    fn upper_bound(&self, segment: ArmSegment, number: usize) -> f64 {
        let Target { frame, link, pinch, counts } = &self.all[number];
        match (pinch, self.judge) {
            _ if !counts => 0.0,
            (Some(pinch), _) => pinch.ratio(arm_region(segment), frame.strike(*link)),
            (None, Judge::Ending) => {
                frame.ratio(arm_region(segment), *link, frame.deciding_speed_bound(*link, self.velocity))
            }
            (None, Judge::Clamping) => 0.0,
            (None, Judge::Moving(limit)) => Self::of_moving(limit, frame.speed_bounds[*link]),
        }
    }

    fn upper_bound_near(&self, segment: ArmSegment, number: usize, points: &Neighbourhood<'_>) -> f64 {
        let Target { frame, link, pinch, .. } = &self.all[number];
        match (pinch, self.judge) {
            (Some(_), _) => self.upper_bound(segment, number),
            (None, Judge::Ending) => {
                let speed = frame.deciding_speed_bound_near(*link, points, self.velocity);
                frame.ratio(arm_region(segment), *link, speed)
            }
            (None, Judge::Clamping) => 0.0,
            (None, Judge::Moving(limit)) => Self::of_moving(limit, frame.speed_bound_near(*link, points)),
        }
    }

    fn score(&self, segment: ArmSegment, number: usize, on_link: Vec3) -> f64 {
        let Target { frame, link, pinch, .. } = &self.all[number];
        let velocity = frame.velocity(*link, on_link);
        match (pinch, self.judge) {
            (Some(_), _) => self.upper_bound(segment, number),
            (None, Judge::Ending) => {
                let speed = frame.strike(*link).deciding_speed(velocity, self.velocity);
                frame.ratio(arm_region(segment), *link, speed)
            }
            (None, Judge::Clamping) => 0.0,
            (None, Judge::Moving(limit)) => Self::of_moving(limit, velocity.length()),
        }
    }
}
