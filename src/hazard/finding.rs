//! One hazardous action sequence: what was done, what was touched, when and where.

use super::contact::{Class, Contact};
use crate::geometry::Vec3;
use crate::human::action::Action;

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
    /// For an arm that reaches through a light curtain or a door, or from a two-hand control: how long before the contact
    /// it broke the plane or let go, s.
    pub through_curtain_s: Option<f64>,
    /// Index of the sensor of that curtain.
    pub curtain: Option<usize>,
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
