//! One hazardous action sequence: what was done, what was touched, when and where.

use super::contact::Contact;
use super::criterion::Class;
use super::place::place_cell;
use crate::geometry::Vec3;
use crate::human::{Action, Who};

/// A sequence of human actions that reached an unsafe state.
#[derive(Clone, Debug, PartialEq)]
pub struct Finding {
    /// Why it is unsafe.
    pub class: Class,
    /// The contact.
    pub contact: Contact,
    /// The actions, the last one being that in which the contact happens.
    pub actions: Vec<Action>,
    /// Communication steps from the start to the contact.
    pub step: usize,
    /// Time of the contact, s.
    pub time_s: f64,
    /// Whom it happens to.
    pub who: Who,
    /// Where the person stands at the contact, floor plan, m.
    pub person: Vec3,
    /// Heading of the person, rad from +x towards +y.
    pub heading_rad: f64,
    /// Sixteenths of the bend that obstacles left possible.
    pub bend_sixteenths: u8,
    /// For an arm contact: elbow and wrist, world, m, and whether it is the left arm.
    pub arm: Option<ArmPose>,
    /// Each sensor's output at the contact: `true` while it reports a person.
    pub sensors: Vec<bool>,
    /// Programme phase of the robot, where the cell names one.
    pub phase: Option<i64>,
    /// Planes that told of the arm: light curtains, doors, two-hand controls that it let go.
    pub through: Vec<Through>,
}

impl Finding {
    /// Whether both are the same kind of hazard to an engineer: what [`Identity`](super::Identity) tells apart.
    #[must_use]
    pub fn is_like(&self, other: &Self) -> bool {
        let of = |f: &Self| (f.class, f.contact.region, f.contact.link, f.phase, place_cell(f.person), f.who);
        of(self) == of(other) && self.sensors == other.sensors
    }

    /// Whether it is told rather than another one of the same action, with neither of which sequences end: a contact before a
    /// distance, then the worse one, then this.
    #[must_use]
    pub fn outweighs(&self, other: &Self) -> bool {
        let touches = |finding: &Self| finding.class == Class::MovingContact;
        match (touches(self), touches(other)) {
            (true, false) => true,
            (false, true) => false,
            _ => self.contact.ratio() >= other.contact.ratio(),
        }
    }
}

/// A plane that told of an arm, and when.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Through {
    /// Index of its sensor.
    pub sensor: usize,
    /// How long before the contact the arm broke the plane or let go, s.
    pub since_s: f64,
    /// How long before the contact the body itself was seen in the plane, s: from then on the sensors tell of that alone. 0
    /// if the arm is told of until the contact.
    pub until_s: f64,
}

/// Where the touching arm is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ArmPose {
    /// Left arm, else right.
    pub left: bool,
    /// Shoulder joint, world, m.
    pub shoulder: Vec3,
    /// Elbow, world, m.
    pub elbow: Vec3,
    /// Wrist, world, m.
    pub wrist: Vec3,
}
