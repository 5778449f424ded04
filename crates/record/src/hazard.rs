//! A hazard as it stands in `scan.json`: the worst sequence of its group, with what is said of it.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::begin::InitialConditionRecord;
use super::immovable;
use super::judged::{Clamping, Judged, LimitKind, Measure};
use super::operated::{OperatedControl, worked_words};
use crate::human::action::Action;
use crate::human::arm::ArmModel;
use crate::standards::BodyRegion;
use fmi_hazard_criteria::{Class, Finding, Group, finding};

/// What is hit where it is not the hand itself.
pub(crate) const HELD_WORDS: &str = "thing in the hand";

/// A hazard: the worst sequence of its group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hazard {
    /// Stable id.
    pub id: String,
    /// Whether a fresh instance without any restore gave the same contact; `None` before that was tried.
    pub confirmed: Option<bool>,
    /// Where and when its sequences begin, if that is not where the scan did. Its times count from then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub begins: Option<InitialConditionRecord>,
    /// Why it is a finding.
    pub class: Class,
    /// How it was judged, where another criterion counts than the transient force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judged: Option<Judged>,
    /// Who is hit, where there are two people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub person: Option<String>,
    /// Body region touched.
    pub body_region: BodyRegion,
    /// Robot link that touches.
    pub robot_link: String,
    /// Potential collision force, N.
    pub force_n: f64,
    /// Limit, N.
    pub limit_n: f64,
    /// The force that decides, by the criterion of the settings, over `limit_n`.
    pub ratio: f64,
    /// Force with the speed of approach instead of the robot's own, N.
    pub directed_force_n: f64,
    /// `directed_force_n / limit_n`.
    #[serde(default)]
    pub directed_ratio: f64,
    /// Absolute speed of the robot point, m/s.
    pub speed_m_s: f64,
    /// Speed of approach, the person's walking included, m/s: of body and legs along the contact normal, of arms in any
    /// direction.
    pub approach_m_s: f64,
    /// Speed below which the force stays within the limit, m/s.
    pub safe_below_m_s: f64,
    /// Effective mass of the robot, kg.
    pub effective_mass_kg: f64,
    /// Mass of the robot at this point, in this pose, and in the direction of the contact (of body and legs along its normal, of
    /// arms along the velocity of the robot point), by the inertias of its links and its payload, kg: where the cell file or a
    /// URDF tells them. `null` where the robot cannot give way in that direction. Nothing is decided by it.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "immovable")]
    #[schemars(with = "Option<f64>")]
    pub reflected_mass_kg: Option<f64>,
    /// Time of the contact, s.
    pub time_s: f64,
    /// Contact point on the robot, m.
    pub contact_point_m: [f64; 3],
    /// Contact point on the body, m.
    pub body_point_m: [f64; 3],
    /// Signed distance of the shapes at that instant, m.
    pub distance_m: f64,
    /// Where the person stands, m.
    pub person_xy_m: [f64; 2],
    /// Where the person looks, degrees from +x towards +y.
    pub person_heading_deg: f64,
    /// Part of the bend that obstacles left possible, 0 to 1.
    pub bend_fraction: f64,
    /// Shoulder, elbow and wrist of the touching arm, m.
    pub arm: Option<Arm>,
    /// Sensors at the contact.
    pub sensors: Vec<SensorState>,
    /// Programme phase.
    pub phase: Option<i64>,
    /// For an arm through a light curtain or a door, or from a two-hand control: how long before the contact it broke the
    /// plane or let go, s; the robot is where it is when that is reported then. Of several planes the first.
    pub through_curtain_s: Option<f64>,
    /// The sensor of that.
    pub through_curtain: Option<String>,
    /// All planes that told of the arm, and when.
    #[serde(default)]
    pub through: Vec<Through>,
    /// The sequence of actions; the contact happens in the last.
    pub actions: Vec<Action>,
    /// Controls that are worked in it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub worked: Vec<OperatedControl>,
    /// The first hazard by contact of the sequence, where a clamping comes behind it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first_contact: Option<FirstContact>,
    /// Iteration in which the hazard was first met, from 1.
    pub first_iteration: u64,
    /// Sequences found that end in this hazard.
    pub times_found: u64,
    /// Earliest contact over these, s.
    pub earliest_time_s: f64,
    /// Sequences of full length that begin with this hazard, in decimal, where all were looked at.
    pub sequences: Option<String>,
    /// The shortest and calmest sequence.
    pub shortest: Shortest,
}

/// The first hazard by contact of a sequence in which somebody is clamped later.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FirstContact {
    /// Time of the contact, s.
    pub time_s: f64,
    /// Why it is a hazard.
    pub class: Class,
    /// Who is hit, where there are two people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub person: Option<String>,
    /// Body region touched.
    pub body_region: BodyRegion,
    /// Robot link that touches.
    pub robot_link: String,
    /// What is broken worst, over its limit.
    pub ratio: f64,
}

impl FirstContact {
    /// That of a finding.
    #[must_use]
    pub fn of(first: &Finding, link_names: &[String], people: Option<&[String; 2]>) -> Self {
        Self {
            time_s: first.time_s,
            class: first.class,
            person: people.map(|names| names[first.who as usize].clone()),
            body_region: first.contact.region,
            robot_link: link_names[first.contact.link].clone(),
            ratio: first.contact.ratio(),
        }
    }

    /// "after the tool hit the chest at 0.62 s".
    #[must_use]
    pub(crate) fn words(&self) -> String {
        let [done, _] = self.class.done();
        let whose = self.person.as_ref().map_or_else(String::new, |person| format!(" of {person}"));
        let (region, time_s) = (self.body_region.words(), self.time_s);
        format!("after the {region}{whose} was {done} by {} at {time_s:.2} s", self.robot_link)
    }
}

/// A plane that told of an arm: a light curtain, a door, a two-hand control that it let go.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Through {
    /// Its sensor.
    pub sensor: String,
    /// How long before the contact the arm broke the plane or let go, s.
    pub since_s: f64,
    /// How long before the contact the sensor began to tell of the body itself, s: the robot then is as if the plane had told
    /// of the arm until that only. 0 if the plane tells of the arm until the contact.
    pub until_s: f64,
}

/// The shortest sequence found that ends in a hazard; of these the calmest. The very shortest there is when the search
/// was exhaustive.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Shortest {
    /// The actions.
    pub actions: Vec<Action>,
    /// Time of the contact, s.
    pub time_s: f64,
    /// Force, N.
    pub force_n: f64,
    /// `force / limit`.
    pub ratio: f64,
    /// Whether a fresh instance without any restore gave the same contact; `None` before that was tried.
    pub confirmed: Option<bool>,
}

/// The touching arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Arm {
    /// `left` or `right`.
    pub side: String,
    /// Shoulder joint, m.
    pub shoulder_m: [f64; 3],
    /// Elbow, m.
    pub elbow_m: [f64; 3],
    /// Wrist, m.
    pub wrist_m: [f64; 3],
    /// Where what the hand holds is hit: how far beyond the finger tips, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_m: Option<f64>,
}

/// A sensor's output.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SensorState {
    /// Sensor name.
    pub name: String,
    /// Whether it reports the person.
    pub person_detected: bool,
    /// For how long before the contact it had reported the person without a break, s; none if it does not report them, or
    /// the hazard was not confirmed.
    #[serde(default)]
    pub since_s: Option<f64>,
}

impl Hazard {
    /// The record of a group; names by index.
    #[must_use]
    pub fn new(group: &Group, link_names: &[String], sensor_names: &[String], people: Option<&[String; 2]>) -> Self {
        let f = &group.worst;
        let c = &f.contact;
        let arm = f.arm.map(|a| Arm {
            side: if a.left { "left" } else { "right" }.to_owned(),
            shoulder_m: a.shoulder.to_array(),
            elbow_m: a.elbow.to_array(),
            wrist_m: a.wrist.to_array(),
            held_m: (c.region == BodyRegion::Hand).then(|| ArmModel::beyond_fingers_m(a.wrist, c.on_robot)).flatten(),
        });
        let sensor =
            |(name, &on): (&String, &bool)| SensorState { name: name.clone(), person_detected: on, since_s: None };
        Self {
            id: group.id.clone(),
            confirmed: None,
            begins: None,
            class: f.class,
            judged: Judged::of(c, f.class, link_names),
            person: people.map(|names| names[f.who as usize].clone()),
            body_region: c.region,
            robot_link: link_names[c.link].clone(),
            force_n: c.force_n,
            limit_n: c.limit_n,
            ratio: c.ratio(),
            directed_force_n: c.directed_force_n,
            directed_ratio: c.directed_force_n / c.limit_n,
            speed_m_s: c.speed_m_s,
            approach_m_s: c.approach_m_s,
            safe_below_m_s: c.safe_speed_m_s(),
            effective_mass_kg: c.effective_mass_kg,
            reflected_mass_kg: c.reflected_mass_kg,
            time_s: f.time_s,
            contact_point_m: c.on_robot.to_array(),
            body_point_m: c.on_body.to_array(),
            distance_m: c.distance_m,
            person_xy_m: [f.person.x, f.person.y],
            person_heading_deg: f.heading_rad.to_degrees(),
            bend_fraction: f64::from(f.bend_sixteenths) / 16.0,
            arm,
            sensors: sensor_names.iter().zip(&f.sensors).map(sensor).collect(),
            phase: f.phase,
            through_curtain_s: f.through.first().map(|through| through.since_s),
            through_curtain: f.through.first().map(|through| sensor_names[through.sensor].clone()),
            through: f
                .through
                .iter()
                .map(|&finding::Through { sensor, since_s, until_s }| Through {
                    sensor: sensor_names[sensor].clone(),
                    since_s,
                    until_s,
                })
                .collect(),
            actions: f.actions.clone(),
            worked: Vec::new(),
            first_contact: None,
            first_iteration: group.first_iteration,
            times_found: group.times_found,
            earliest_time_s: group.earliest_s,
            sequences: group.sequences.as_ref().map(ToString::to_string),
            shortest: Shortest {
                actions: group.shortest.actions.clone(),
                time_s: group.shortest.time_s,
                force_n: group.shortest.contact.deciding_force_n(),
                ratio: group.shortest.contact.ratio(),
                confirmed: None,
            },
        }
    }

    /// The force that decides, N: the one that `ratio` is of, where that is a force.
    #[must_use]
    pub fn deciding_force_n(&self) -> f64 {
        if let Some(clamping) = self.clamping() {
            return clamping.force_n;
        }
        if !matches!(self.class, Class::Force | Class::HeadContact) {
            return self.force_n;
        }
        let off = |force: f64| (force / self.limit_n - self.ratio).abs();
        if off(self.directed_force_n) < off(self.force_n) { self.directed_force_n } else { self.force_n }
    }

    /// Whether that is the force with the speed of approach.
    #[must_use]
    pub fn is_by_approach(&self) -> bool {
        self.deciding_force_n().to_bits() != self.force_n.to_bits()
    }

    /// What happens, in words.
    #[must_use]
    pub fn described(&self) -> String {
        let reports = self.reports_words();
        let stands = match &self.person {
            Some(name) => format!("{name} stands"),
            None => "the person stands".to_owned(),
        };
        let state = |s: &SensorState| s.words(reports);
        let sensors: Vec<String> = self.sensors.iter().map(state).collect();
        let sensors = if sensors.is_empty() { String::new() } else { format!("; {}", sensors.join(", ")) };
        let begins = self.begins.map_or_else(String::new, |begins| format!("; begun {}", begins.words()));
        let worked = match worked_words(&self.worked) {
            words if words.is_empty() => words,
            words => format!("; {words}"),
        };
        let meets = if self.class == Class::Separation { "comes too near" } else { "meets" };
        format!(
            "at {:.2} s the robot's {} {meets} the {} at {:.2} m/s at ({:.2}, {:.2}, {:.2}) m; {stands} at ({:.2}, \
             {:.2}){sensors}{worked}{begins}",
            self.time_s,
            self.robot_link,
            self.struck_words(),
            self.speed_m_s,
            self.contact_point_m[0],
            self.contact_point_m[1],
            self.contact_point_m[2],
            self.person_xy_m[0],
            self.person_xy_m[1],
        )
    }

    /// What is hit: a region of the body, or what the hand holds.
    #[must_use]
    pub fn struck_words(&self) -> &'static str {
        if self.arm.as_ref().is_some_and(|arm| arm.held_m.is_some()) { HELD_WORDS } else { self.body_region.words() }
    }

    /// The same with what it means.
    #[must_use]
    pub fn sentence(&self) -> String {
        let described = self.described();
        match self.class {
            Class::Force => format!(
                "{:.0} N on the {} (limit {:.0} N, {:.2}x): {described}",
                self.deciding_force_n(),
                self.struck_words(),
                self.limit_n,
                self.ratio
            ),
            Class::HeadContact => format!(
                "{:.0} N on the {}, where no contact with a moving robot is allowed: {described}",
                self.deciding_force_n(),
                self.struck_words()
            ),
            Class::Clamping => {
                let against = self.clamping().map_or_else(String::new, |c| {
                    format!(", held against {} {:.0} mm away", c.against, 1000.0 * c.gap_m)
                });
                let after =
                    self.first_contact.as_ref().map_or_else(String::new, |first| format!(", {}", first.words()));
                format!("{} on the {}{against}{after}: {described}", self.measure_words(), self.struck_words())
            }
            Class::Pressure => format!("{} on the {}: {described}", self.measure_words(), self.struck_words()),
            Class::MovingContact => {
                format!("the {} is {}: {described}", self.struck_words(), self.measure_words())
            }
            Class::Separation => format!(
                "the {} is {}, and the robot's {} moves: {}",
                self.struck_words(),
                self.measure_words(),
                self.robot_link,
                self.described()
            ),
        }
    }
}

impl Hazard {
    /// Gives what holds a part of the body its name, where it is an obstacle.
    pub fn name_obstacles(&mut self, name: impl Fn(usize) -> String) {
        if let Some(judged) = &mut self.judged {
            judged.name_obstacles(name);
        }
    }

    /// What holds the part of the body, if that is what counts.
    #[must_use]
    pub fn clamping(&self) -> Option<&Clamping> {
        self.judged.as_ref().filter(|_| self.class == Class::Clamping)?.clamping.as_ref()
    }

    /// The limit of the force that decides, N.
    #[must_use]
    pub fn deciding_limit_n(&self) -> f64 {
        self.clamping().map_or(self.limit_n, |clamping| clamping.limit_n)
    }

    /// The speed below which it would be none, in few words.
    #[must_use]
    pub fn safe_words(&self) -> String {
        let below = match self.class {
            Class::Force | Class::HeadContact if self.body_region.permits_no_contact() => None,
            Class::Force => Some(self.safe_below_m_s),
            Class::Clamping => self
                .clamping()
                .filter(|_| self.judged.as_ref().is_some_and(|judged| judged.limit == LimitKind::Force))
                .map(|clamping| clamping.closing_m_s * clamping.limit_n / clamping.force_n),
            Class::HeadContact | Class::Pressure | Class::MovingContact | Class::Separation => None,
        };
        // No speed of a moving robot is safe for a head or a throat.
        let no_speed = self.class == Class::MovingContact || self.body_region.permits_no_contact();
        below.map_or_else(|| if no_speed { "none" } else { "-" }.to_owned(), |below| format!("{below:.2} m/s"))
    }

    /// What is broken, and by how much.
    #[must_use]
    pub fn measured(&self) -> Measure {
        let figures = (self.deciding_force_n(), self.deciding_limit_n(), self.ratio, self.speed_m_s);
        Measure::of(self.class, self.judged.as_ref(), figures)
    }

    /// The same in few words.
    #[must_use]
    pub fn measure_words(&self) -> String {
        self.measured().words()
    }
}
