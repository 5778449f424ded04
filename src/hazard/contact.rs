//! The potential collision force of a contact and its limit (ISO/TS 15066 Annex A), and whether that is unsafe.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cause::Part;
use crate::geometry::{Vec3, coordinates};
use crate::standards::BodyRegion;
use crate::standards::iso_ts_15066::{collision_force_n, robot_effective_mass, safe_speed_m_s, transient_limit_n};

/// Robot points slower than this count as standing still, m/s.
pub const STANDSTILL_M_S: f64 = 1e-3;

/// Which speed makes the force that decides whether a contact is unsafe, and how bad.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Criterion {
    /// That of the robot's point, whatever the person does: the paper's.
    #[default]
    Absolute,
    /// That at which the robot's point and the person come towards each other, as long as the robot's moves at all: the
    /// relative speed of ISO/TS 15066 A.3.5.
    Approach,
}

/// Why a contact is a finding.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Class {
    /// The potential collision force exceeds the limit of the body region.
    Force,
    /// The head, or the front of the neck, is touched by a moving robot: not permissible whatever the force
    /// (ISO/TS 15066 A.3.2, 5.5.5).
    HeadContact,
}

/// How hard the robot strikes as a whole at one instant: its effective mass, and force ratio per speed by region.
#[derive(Clone, Debug, PartialEq)]
pub struct Strike {
    /// Effective mass `m_R = M/2 + m_L` (A.4), kg.
    pub effective_mass_kg: f64,
    criterion: Criterion,
    ratio_per_speed: [f64; BodyRegion::ALL.len()],
}

impl Strike {
    /// For a robot of `moving_mass_kg` that carries `payload_kg`.
    #[must_use]
    pub fn new(moving_mass_kg: f64, payload_kg: f64, criterion: Criterion) -> Self {
        let effective_mass_kg = robot_effective_mass(moving_mass_kg, payload_kg);
        let ratio = |region| 1.0 / safe_speed_m_s(region, effective_mass_kg);
        Self { effective_mass_kg, criterion, ratio_per_speed: BodyRegion::ALL.map(ratio) }
    }

    /// `F_coll / F_max` for a contact of `region` with a robot point moving at `speed_m_s`; linear in the speed.
    #[must_use]
    pub fn ratio(&self, region: BodyRegion, speed_m_s: f64) -> f64 {
        self.ratio_per_speed[region as usize] * speed_m_s
    }

    /// The speed that decides when a robot point at velocity `robot` meets an arm of a person who walks at `human`, m/s. How an
    /// arm itself moves is open, so its approach has any direction.
    #[must_use]
    pub fn deciding_speed(&self, robot: Vec3, human: Vec3) -> f64 {
        match self.criterion {
            Criterion::Absolute => robot.length(),
            Criterion::Approach if robot.length() <= STANDSTILL_M_S => 0.0,
            Criterion::Approach => (robot - human).length(),
        }
    }

    /// An upper bound on the speed that decides where no robot point is faster than `robot_m_s`, nor faster than `relative`
    /// gives, m/s, seen by the person.
    #[must_use]
    pub fn deciding_speed_bound(&self, robot_m_s: f64, relative: impl FnOnce() -> f64) -> f64 {
        match self.criterion {
            Criterion::Absolute => robot_m_s,
            Criterion::Approach if robot_m_s <= STANDSTILL_M_S => 0.0,
            Criterion::Approach => relative(),
        }
    }

    /// Whether any contact with a robot point no faster than this could be unsafe: [`Contact::class`] asks both.
    #[must_use]
    pub fn may_harm(&self, speed_m_s: f64) -> bool {
        speed_m_s > STANDSTILL_M_S || self.largest_ratio(speed_m_s) > 1.0
    }

    /// Whether a contact of `region` with a robot point no faster than this could be unsafe, for somebody who stands.
    #[must_use]
    pub fn may_harm_region(&self, region: BodyRegion, speed_m_s: f64) -> bool {
        self.ratio(region, speed_m_s) > 1.0 || (region.permits_no_contact() && speed_m_s > STANDSTILL_M_S)
    }

    /// The largest ratio of any region at this speed.
    #[must_use]
    pub fn largest_ratio(&self, speed_m_s: f64) -> f64 {
        self.ratio_per_speed.iter().fold(0.0_f64, |m, r| m.max(r * speed_m_s))
    }
}

/// A contact between a body region and a robot link at one instant.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Contact {
    /// Body region touched (first touched, where several overlap).
    pub region: BodyRegion,
    /// Index of the robot link shape.
    pub link: usize,
    /// Contact point on the robot, world, m.
    #[serde(with = "coordinates")]
    pub on_robot: Vec3,
    /// Contact point on the body, world, m.
    #[serde(with = "coordinates")]
    pub on_body: Vec3,
    /// Signed distance, m; negative when the shapes overlap at the instant of the check.
    pub distance_m: f64,
    /// Absolute speed of the robot point, m/s (the paper's conservative choice).
    pub speed_m_s: f64,
    /// Speed of approach, human walking included, m/s; never negative. Of body and legs along the contact normal, of arms,
    /// whose own motion is open, in any direction.
    pub approach_m_s: f64,
    /// Effective mass of the robot, kg.
    pub effective_mass_kg: f64,
    /// Mass of the robot at this point and in the direction of the contact, by inertias and pose, kg, where that is known;
    /// infinite where the robot cannot give way. For information: nothing is decided by it.
    pub reflected_mass_kg: Option<f64>,
    /// Potential collision force `v sqrt(mu k)`, N.
    pub force_n: f64,
    /// The same with the approach speed, N.
    pub directed_force_n: f64,
    /// Limit for a transient contact, N.
    pub limit_n: f64,
    /// Which of the two forces decides.
    pub criterion: Criterion,
}

/// Where and how fast a contact is, before forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Body region.
    pub region: BodyRegion,
    /// Index of the robot link shape.
    pub link: usize,
    /// Point on the robot's surface, world, m.
    pub on_robot: Vec3,
    /// Point on the body's surface, world, m.
    pub on_body: Vec3,
    /// Signed distance, m.
    pub distance_m: f64,
    /// Velocity of the robot point, m/s.
    pub robot_velocity: Vec3,
    /// Walking velocity of the person, m/s.
    pub human_velocity: Vec3,
}

impl Contact {
    /// Force and limit for a touch.
    #[must_use]
    pub fn new(touch: &Touch, strike: &Strike) -> Self {
        let speed = touch.robot_velocity.length();
        let relative = touch.robot_velocity - touch.human_velocity;
        // The normal points from the robot to the body; surface points swap sides when the shapes overlap.
        let across = touch.on_body - touch.on_robot;
        let normal = if touch.distance_m < 0.0 { -across } else { across };
        let approach = match normal.try_normalize() {
            Some(normal) if Part::of(touch.region) == Part::Body => relative.dot(normal).max(0.0),
            // An arm, or exactly touching: no direction is known, so none is excluded.
            _ => relative.length(),
        };
        let m_r = strike.effective_mass_kg;
        Self {
            region: touch.region,
            link: touch.link,
            on_robot: touch.on_robot,
            on_body: touch.on_body,
            distance_m: touch.distance_m,
            speed_m_s: speed,
            approach_m_s: approach,
            effective_mass_kg: m_r,
            reflected_mass_kg: None,
            force_n: collision_force_n(touch.region, m_r, speed),
            directed_force_n: collision_force_n(touch.region, m_r, approach),
            limit_n: transient_limit_n(touch.region),
            criterion: strike.criterion,
        }
    }

    /// Direction from the robot to the body where that is hit, if there is one; none of an arm, whose pose is one of many.
    #[must_use]
    pub fn normal(&self) -> Option<Vec3> {
        let across = (self.on_body - self.on_robot) * if self.distance_m < 0.0 { -1.0 } else { 1.0 };
        across.try_normalize().filter(|_| Part::of(self.region) == Part::Body)
    }

    /// The force that decides, N. With a robot point that stands, only the person moves.
    #[must_use]
    pub fn deciding_force_n(&self) -> f64 {
        match self.criterion {
            Criterion::Absolute => self.force_n,
            Criterion::Approach if self.speed_m_s <= STANDSTILL_M_S => 0.0,
            Criterion::Approach => self.directed_force_n,
        }
    }

    /// `F_coll / F_max`, of the force that decides.
    #[must_use]
    pub fn ratio(&self) -> f64 {
        self.deciding_force_n() / self.limit_n
    }

    /// Speed of the robot point at which the force would equal the limit, m/s.
    #[must_use]
    pub fn safe_speed_m_s(&self) -> f64 {
        safe_speed_m_s(self.region, self.effective_mass_kg)
    }

    /// Whether this contact makes the state unsafe, and why.
    #[must_use]
    pub fn class(&self) -> Option<Class> {
        if self.deciding_force_n() > self.limit_n {
            Some(Class::Force)
        } else if self.region.permits_no_contact() && self.speed_m_s > STANDSTILL_M_S {
            Some(Class::HeadContact)
        } else {
            None
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn touch(region: BodyRegion, robot_velocity: Vec3) -> Touch {
        Touch {
            region,
            link: 0,
            on_robot: Vec3::ZERO,
            on_body: Vec3::new(0.0, -0.01, 0.0),
            distance_m: 0.01,
            robot_velocity,
            human_velocity: Vec3::new(0.0, 1.6, 0.0),
        }
    }

    #[test]
    fn worked_values_of_the_data_sheet() {
        // M 40.4 kg and 3 kg: m_R 23.2; hand at 2 m/s 418.9 N against 270 N, ratio 1.55.
        let strike = Strike::new(40.4, 3.0, Criterion::Absolute);
        let c = Contact::new(&touch(BodyRegion::Hand, Vec3::new(2.0, 0.0, 0.0)), &strike);
        assert!((c.force_n - 418.9).abs() < 0.05 && (c.ratio() - 1.551).abs() < 5e-4, "{c:?}");
        assert!((strike.ratio(BodyRegion::Hand, 2.0) - c.ratio()).abs() < 1e-12);
        assert_eq!(c.class(), Some(Class::Force));
        // M 29.1 kg and 12.5 kg: chest at 0.48 m/s 304.9 N, ratio 1.09.
        let c = Contact::new(
            &touch(BodyRegion::Chest, Vec3::new(0.48, 0.0, 0.0)),
            &Strike::new(29.1, 12.5, Criterion::Absolute),
        );
        assert!((c.force_n - 304.9).abs() < 0.05 && (c.ratio() - 1.089).abs() < 1e-3, "{c:?}");
    }

    /// By hand: the body is at -y of the robot point, and the person walks towards +y at 1.6 m/s.
    #[test]
    fn approach_counts_what_comes_towards_the_person_and_absolute_what_the_robot_does() {
        let strikes = [Criterion::Absolute, Criterion::Approach].map(|criterion| Strike::new(40.4, 3.0, criterion));
        let contacts = |region, robot_velocity: Vec3| {
            strikes.each_ref().map(|strike| Contact::new(&touch(region, robot_velocity), strike))
        };
        // A robot that moves sideways only closes through the person's own walking.
        let [absolute, approach] = contacts(BodyRegion::Chest, Vec3::new(2.0, 0.0, 0.0));
        assert!((absolute.approach_m_s - 1.6).abs() < 1e-12 && (absolute.speed_m_s - 2.0).abs() < 1e-12);
        assert!((absolute.ratio() / approach.ratio() - 2.0 / 1.6).abs() < 1e-12);
        // One that draws back harms nobody.
        let [absolute, approach] = contacts(BodyRegion::Chest, Vec3::new(0.0, 2.0, 0.0));
        assert!(absolute.class() == Some(Class::Force) && approach.class().is_none() && approach.ratio() < 1e-12);
        // One that comes slowly meets somebody who walks into it, unless it stands.
        let [absolute, approach] = contacts(BodyRegion::Chest, Vec3::new(0.0, -0.1, 0.0));
        assert!(absolute.class().is_none() && approach.class() == Some(Class::Force));
        assert!((approach.approach_m_s - 1.7).abs() < 1e-12);
        assert!(contacts(BodyRegion::Chest, Vec3::ZERO).iter().all(|c| c.class().is_none()));
        // Of an arm the direction is open.
        let [_, approach] = contacts(BodyRegion::Hand, Vec3::new(0.0, 2.0, 0.0));
        assert!((approach.approach_m_s - 0.4).abs() < 1e-12);
        let speed = strikes[1].deciding_speed(Vec3::new(0.0, 2.0, 0.0), Vec3::new(0.0, 1.6, 0.0));
        assert!((strikes[1].ratio(BodyRegion::Hand, speed) - approach.ratio()).abs() < 1e-12);
        let bounds = strikes.each_ref().map(|strike| strike.deciding_speed_bound(2.0, || 0.4));
        assert!((bounds[0] - 2.0).abs() < 1e-12 && (bounds[1] - speed).abs() < 1e-12, "{bounds:?}");
        assert!(strikes[1].deciding_speed_bound(0.5 * STANDSTILL_M_S, || 1.6) < 1e-12);
    }

    #[test]
    fn a_moving_robot_at_the_head_is_a_finding_and_a_standing_one_is_not() {
        let strike = Strike::new(17.7, 3.0, Criterion::Absolute);
        let slow = Contact::new(&touch(BodyRegion::Face, Vec3::new(0.02, 0.0, 0.0)), &strike);
        assert_eq!(slow.class(), Some(Class::HeadContact));
        assert_eq!(Contact::new(&touch(BodyRegion::Face, Vec3::ZERO), &strike).class(), None);
        let throat = Contact::new(&touch(BodyRegion::NeckFront, Vec3::new(0.02, 0.0, 0.0)), &strike);
        assert_eq!(throat.class(), Some(Class::HeadContact));
        assert_eq!(Contact::new(&touch(BodyRegion::Neck, Vec3::new(0.02, 0.0, 0.0)), &strike).class(), None);
        let chest = Contact::new(&touch(BodyRegion::Chest, Vec3::new(0.02, 0.0, 0.0)), &strike);
        assert_eq!(chest.class(), None);
        assert!(strike.may_harm(0.02) && !strike.may_harm(0.0));
    }
}
