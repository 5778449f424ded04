//! What happens at a contact and how its force comes about, with its numbers: sentences that `explain` and the page share.

use crate::begin::InitialConditionRecord;
use crate::hazard::{Hazard, SensorState, Through};
use crate::standards::iso_ts_15066 as limits;
use fmi_hazard_criteria::Class;

/// What a sensor does that reports somebody: the only person, or one of two. It does not tell who it is.
pub const REPORTS: [&str; 2] = ["reports the person", "reports somebody"];

impl SensorState {
    /// What it reports: "mat reports the person", "mat clear".
    #[must_use]
    pub fn words(&self, reports: &str) -> String {
        format!("{} {}", self.name, if self.person_detected { reports } else { "clear" })
    }
}

impl Hazard {
    /// Which link meets which part of whom, how fast, when and where.
    #[must_use]
    pub fn meeting_words(&self) -> String {
        let arm = self.arm.as_ref().map_or_else(String::new, |arm| format!(" (of the {} arm)", arm.side));
        let meets = if self.class == Class::Separation { "comes too near" } else { "meets" };
        let (of, who) = match &self.person {
            Some(name) => (format!(" of {name}"), name.clone()),
            None => (String::new(), "The person".to_owned()),
        };
        format!(
            "At {:.2} s the robot's {}, which moves at {:.2} m/s, {meets} the {}{of}{arm} at ({:.2}, {:.2}, {:.2}) m. {who} \
             stands at ({:.2}, {:.2}) m then.",
            self.time_s,
            self.robot_link,
            self.speed_m_s,
            self.struck_words(),
            self.contact_point_m[0],
            self.contact_point_m[1],
            self.contact_point_m[2],
            self.person_xy_m[0],
            self.person_xy_m[1],
        )
    }

    /// What a sensor does that reports somebody.
    #[must_use]
    pub const fn reports_words(&self) -> &'static str {
        REPORTS[self.person.is_some() as usize]
    }

    /// Where its own worst sequence begins, and when it ends.
    #[must_use]
    pub fn begins_words(&self, begins: InitialConditionRecord) -> String {
        format!("The worst begins {}; hit {:.2} s later", begins.words(), self.time_s)
    }

    /// The speed that makes the force that decides, m/s.
    #[must_use]
    pub(crate) fn deciding_speed_m_s(&self) -> f64 {
        if self.is_by_approach() { self.approach_m_s } else { self.speed_m_s }
    }

    /// The formula of the force with its numbers.
    #[must_use]
    pub fn force_formula(&self) -> String {
        let k = limits::spring_constant_n_m(self.body_region);
        let mu = limits::reduced_mass(limits::effective_mass_kg(self.body_region), self.effective_mass_kg);
        format!(
            "F = v sqrt(mu k) = {:.3} m/s x sqrt({mu:.3} kg x {:.0} kN/m) = {:.0} N",
            self.deciding_speed_m_s(),
            k / 1000.0,
            self.deciding_force_n()
        )
    }

    /// Below which speed the force stays within its limit, if that makes it safe.
    #[must_use]
    pub fn safe_speed_words(&self) -> String {
        if self.body_region.permits_no_contact() {
            return format!(
                "No speed is safe: only a robot that stands may touch the head or the throat. (The force would stay within {:.0} N \
                 below {:.2} m/s.)",
                self.limit_n, self.safe_below_m_s
            );
        }
        format!(
            "Safe below {:.2} m/s{} at this point: {:.0} % of the speed there",
            self.safe_below_m_s,
            if self.is_by_approach() { " of approach" } else { "" },
            100.0 * self.safe_below_m_s / self.deciding_speed_m_s()
        )
    }
}

impl Through {
    /// That the arm went past the plane, and when.
    #[must_use]
    pub fn words(&self) -> String {
        let Self { sensor, since_s, until_s } = self;
        let ahead = if *until_s > 0.0 { ", ahead of the body" } else { "" };
        format!("The arm went past {sensor} {since_s:.2} s before{ahead}, on its way there.")
    }
}
