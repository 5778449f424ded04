//! A contact at one instant: its potential collision force and the limit of that (ISO/TS 15066 Annex A), what else of it counts,
//! and whether that is unsafe.

use serde::{Deserialize, Serialize};

use super::criterion::{Class, Criterion};
use super::part::BodyOrArm;
use super::strike::{STANDSTILL_M_S, Strike};
use crate::geometry::{Vec3, coordinates};
use crate::standards::iso_ts_15066::{Recoil, quasi_static_limit_n, transient_limit_n};
use crate::standards::{BodyArea, BodyRegion};

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
    /// Speed of the robot point at which the force that decides would equal the limit, m/s.
    pub safe_speed_m_s: f64,
    /// What keeps the part of the body from giving way, where clamping counts and there is something.
    pub clamp: Option<Clamp>,
    /// The pressure, where that counts and the link says how small it touches.
    pub pressure: Option<Pressed>,
    /// The separation, where that is what is broken.
    pub apart: Option<Apart>,
    class: Option<Class>,
    ratio: f64,
    /// Of clamping alone: force or pressure on a part that cannot give way, over its limit.
    clamping_ratio: f64,
    counts_force: bool,
}

/// Something that does not give way, behind a part of the body that the robot moves towards it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Clamp {
    /// Point on the robot's surface from where the gap is measured, world, m.
    #[serde(with = "coordinates")]
    pub at: Vec3,
    /// Unit vector along which it is measured.
    #[serde(with = "coordinates")]
    pub toward: Vec3,
    /// What is there.
    pub against: Against,
    /// How wide the gap is, m.
    pub gap_m: f64,
    /// How far the robot goes on after the contact, m, where that is known.
    pub travel_m: f64,
    /// How fast the gap closes, m/s.
    pub closing_m_s: f64,
    /// Force on the part, `c sqrt(m_R k)`, N.
    pub force_n: f64,
    /// Quasi-static limit, N.
    pub limit_n: f64,
}

/// What does not give way.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
pub enum Against {
    /// The floor.
    Floor,
    /// An obstacle, by its place in the cell's list.
    Obstacle(usize),
    /// A link, by its place in the cell's list.
    Link(usize),
}

/// Where a part is clamped, before forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Clamped {
    /// Point on the robot's surface, world, m.
    pub at: Vec3,
    /// Unit vector towards what does not give way.
    pub toward: Vec3,
    /// What that is.
    pub against: Against,
    /// How far it is, m.
    pub gap_m: f64,
    /// How far the robot goes on after the contact, m.
    pub travel_m: f64,
    /// How fast the gap closes, m/s.
    pub closing_m_s: f64,
}

/// A pressure and its limit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Pressed {
    /// The pressure, N/cm2.
    pub n_cm2: f64,
    /// Its limit for the area of the body, N/cm2.
    pub limit_n_cm2: f64,
    /// Whether it is that of a part that cannot give way.
    pub clamped: bool,
}

/// A robot that is too near.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize)]
pub struct Apart {
    /// Protective separation distance, m; infinite if the robot does not stop.
    pub required_m: f64,
    /// How long the robot goes on if it is stopped now, s.
    pub stops_after_s: f64,
    /// How far the link gets in that time at most, m.
    pub travel_m: f64,
}

/// Where and how fast a contact is, before forces.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Touch {
    /// Body region.
    pub region: BodyRegion,
    /// The area of it for which there is a pressure limit, where the point tells.
    pub area: Option<BodyArea>,
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
    /// Forces, pressures and limits for a touch of somebody who can give way.
    #[must_use]
    pub fn new(touch: &Touch, strike: &Strike) -> Self {
        Self::judged(touch, None, strike)
    }

    /// The same; and of a part that cannot give way, if it is clamped.
    #[must_use]
    pub fn judged(touch: &Touch, clamped: Option<&Clamped>, strike: &Strike) -> Self {
        let (region, speed) = (touch.region, touch.robot_velocity.length());
        let relative = touch.robot_velocity - touch.human_velocity;
        // The normal points from the robot to the body; surface points swap sides when the shapes overlap.
        let across = touch.on_body - touch.on_robot;
        let normal = if touch.distance_m < 0.0 { -across } else { across };
        let approach = match normal.try_normalize() {
            Some(normal) if BodyOrArm::of(region) == BodyOrArm::Body => relative.dot(normal).max(0.0),
            // An arm, or exactly touching: no direction is known, so none is excluded.
            _ => relative.length(),
        };
        let clamp = clamped.map(|clamped| Clamp {
            at: clamped.at,
            toward: clamped.toward,
            against: clamped.against,
            gap_m: clamped.gap_m,
            travel_m: clamped.travel_m,
            closing_m_s: clamped.closing_m_s,
            force_n: strike.force_n(region, Recoil::None, clamped.closing_m_s),
            limit_n: quasi_static_limit_n(region),
        });
        let mut contact = Self {
            region,
            link: touch.link,
            on_robot: touch.on_robot,
            on_body: touch.on_body,
            distance_m: touch.distance_m,
            speed_m_s: speed,
            approach_m_s: approach,
            effective_mass_kg: strike.effective_mass_kg,
            reflected_mass_kg: None,
            force_n: strike.force_n(region, Recoil::Free, speed),
            directed_force_n: strike.force_n(region, Recoil::Free, approach),
            limit_n: transient_limit_n(region),
            criterion: strike.criteria.speed(),
            safe_speed_m_s: transient_limit_n(region) / strike.force_n(region, Recoil::Free, 1.0),
            clamp,
            pressure: None,
            apart: None,
            class: None,
            ratio: 0.0,
            clamping_ratio: 0.0,
            counts_force: strike.criteria.transient_force.is_some(),
        };
        contact.judge(touch.area, strike);
        contact
    }

    /// Which of the chosen criteria the contact breaks worst.
    fn judge(&mut self, area: Option<BodyArea>, strike: &Strike) {
        let pressed = |force_n, recoil| {
            let (n_cm2, limit_n_cm2) = strike.pressed(self.region, area, force_n, recoil)?;
            Some(Pressed { n_cm2, limit_n_cm2, clamped: recoil == Recoil::None })
        };
        let free = pressed(self.transient_force_n(), Recoil::Free);
        let held = self.clamp.and_then(|clamp| pressed(clamp.force_n, Recoil::None));
        let of = |pressed: Option<Pressed>| pressed.map_or(0.0, |p| p.n_cm2 / p.limit_n_cm2);
        self.pressure = if of(held) > of(free) { held } else { free };
        let counts = strike.criteria.transient_force.is_some();
        let force = if counts { self.transient_force_n() / self.limit_n } else { 0.0 };
        let clamping = self.clamp.map_or(0.0, |clamp| clamp.force_n / clamp.limit_n);
        self.clamping_ratio = clamping.max(of(held));
        let ranked = [(Class::Force, force), (Class::Clamping, self.clamping_ratio), (Class::Pressure, of(free))];
        let mut worst = ranked[0];
        for one in ranked {
            if one.1 > worst.1 {
                worst = one;
            }
        }
        self.ratio = worst.1;
        self.class = if worst.1 > 1.0 {
            Some(worst.0)
        } else if counts && self.region.permits_no_contact() && self.speed_m_s > STANDSTILL_M_S {
            Some(Class::HeadContact)
        } else {
            None
        };
    }

    /// Direction from the robot to the body where that is hit, if there is one; none of an arm, whose pose is one of many.
    #[must_use]
    pub fn normal(&self) -> Option<Vec3> {
        let across = (self.on_body - self.on_robot) * if self.distance_m < 0.0 { -1.0 } else { 1.0 };
        across.try_normalize().filter(|_| BodyOrArm::of(self.region) == BodyOrArm::Body)
    }

    /// All criteria that it breaks, the worst first.
    #[must_use]
    pub fn breaks(&self) -> Vec<Class> {
        if self.apart.is_some() {
            // Nobody is touched, so forces are only what they would be.
            return vec![Class::Separation];
        }
        let mut all: Vec<(Class, f64)> = Vec::new();
        if self.counts_force && self.transient_force_n() > self.limit_n {
            all.push((Class::Force, self.transient_force_n() / self.limit_n));
        }
        if let Some(clamp) = self.clamp.filter(|clamp| clamp.force_n > clamp.limit_n) {
            all.push((Class::Clamping, clamp.force_n / clamp.limit_n));
        }
        if let Some(p) = self.pressure.filter(|p| p.n_cm2 > p.limit_n_cm2) {
            all.push((if p.clamped { Class::Clamping } else { Class::Pressure }, p.n_cm2 / p.limit_n_cm2));
        }
        all.sort_by(|a, b| b.1.total_cmp(&a.1));
        let mut classes: Vec<Class> = self.class.into_iter().chain(all.into_iter().map(|(class, _)| class)).collect();
        let mut seen = Vec::new();
        classes.retain(|class| {
            !seen.contains(class) && {
                seen.push(*class);
                true
            }
        });
        classes
    }

    /// The same as a breach of another criterion: the force stays for information.
    #[must_use]
    pub fn breaking(self, class: Option<Class>) -> Self {
        Self { class, ..self }
    }

    /// The same as a clamping, whatever else it breaks; of no class where it is none.
    #[must_use]
    pub fn as_clamping(self) -> Self {
        let class = (self.clamping_ratio > 1.0).then_some(Class::Clamping);
        Self { class, ratio: self.clamping_ratio, ..self }
    }

    /// The same as of a robot that is too near.
    #[must_use]
    pub fn too_near(self, apart: Apart) -> Self {
        /// What is nearer than this counts as so near, m.
        const LEAST_M: f64 = 0.001;
        /// Ratios are not told beyond this.
        const MOST: f64 = 1000.0;
        let ratio = (apart.required_m / self.distance_m.max(LEAST_M)).min(MOST);
        Self { apart: Some(apart), class: Some(Class::Separation), ratio, ..self }
    }

    /// The transient force that decides, N. With a robot point that stands, only the person moves.
    fn transient_force_n(&self) -> f64 {
        match self.criterion {
            Criterion::Absolute => self.force_n,
            Criterion::Approach if self.speed_m_s <= STANDSTILL_M_S => 0.0,
            Criterion::Approach => self.directed_force_n,
        }
    }

    /// The force that decides, N: on a part that is clamped where that is what counts most, else the transient one.
    #[must_use]
    pub fn deciding_force_n(&self) -> f64 {
        match (self.class, self.clamp) {
            (Some(Class::Clamping), Some(clamp)) => clamp.force_n,
            _ => self.transient_force_n(),
        }
    }

    /// What is broken worst, over its limit: for the transient force `F_coll / F_max`, of the force that decides.
    #[must_use]
    pub const fn ratio(&self) -> f64 {
        self.ratio
    }

    /// Speed of the robot point at which the transient force would equal the limit, m/s.
    #[must_use]
    pub const fn safe_speed_m_s(&self) -> f64 {
        self.safe_speed_m_s
    }

    /// Whether this contact makes the state unsafe, and why.
    #[must_use]
    pub const fn class(&self) -> Option<Class> {
        self.class
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn touch(region: BodyRegion, robot_velocity: Vec3) -> Touch {
        Touch {
            region,
            area: None,
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
        let strike = Strike::of_robot(40.4, 3.0, Criterion::Absolute);
        let c = Contact::new(&touch(BodyRegion::Hand, Vec3::new(2.0, 0.0, 0.0)), &strike);
        assert!((c.force_n - 418.9).abs() < 0.05 && (c.ratio() - 1.551).abs() < 5e-4, "{c:?}");
        assert!((strike.ratio(BodyRegion::Hand, 2.0) - c.ratio()).abs() < 1e-12);
        assert_eq!(c.class(), Some(Class::Force));
        // M 29.1 kg and 12.5 kg: chest at 0.48 m/s 304.9 N, ratio 1.09.
        let c = Contact::new(
            &touch(BodyRegion::Chest, Vec3::new(0.48, 0.0, 0.0)),
            &Strike::of_robot(29.1, 12.5, Criterion::Absolute),
        );
        assert!((c.force_n - 304.9).abs() < 0.05 && (c.ratio() - 1.089).abs() < 1e-3, "{c:?}");
    }

    /// By hand: the body is at -y of the robot point, and the person walks towards +y at 1.6 m/s.
    #[test]
    fn approach_counts_what_comes_towards_the_person_and_absolute_what_the_robot_does() {
        let strikes =
            [Criterion::Absolute, Criterion::Approach].map(|criterion| Strike::of_robot(40.4, 3.0, criterion));
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
        let strike = Strike::of_robot(17.7, 3.0, Criterion::Absolute);
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
