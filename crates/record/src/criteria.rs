//! What counts as unsafe in a cell, as results record it: where that is more or other than the transient force.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use fmi_hazard_criteria::{Class, Criterion};

/// What counts as unsafe.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CriteriaRecord {
    /// The transient force, by this speed; none if it does not count.
    pub transient_force: Option<Criterion>,
    /// Clamping.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub clamping: Option<ClampingRecord>,
    /// Pressure.
    pub pressure: bool,
    /// Contacts with points of the robot that are faster than this, m/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub moving_contact_faster_than_m_s: Option<f64>,
    /// Separation.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub separation: Option<SeparationTerms>,
}

/// How clamping counts.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ClampingRecord {
    /// The FMU input that tells robots of a contact.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub contact_signal: Option<String>,
    /// How far the link that goes on farthest after a contact does, m.
    pub travel_after_contact_m: f64,
}

/// The terms of the protective separation distance that the cell file says.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SeparationTerms {
    /// The sensor or input that stops the robots; none if their stop is stated.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stop: Option<String>,
    /// The figures of a stop that is stated; older versions did not write them down.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub stated: Option<StatedStop>,
    /// How far a part of the body gets in before the person is seen, m.
    pub intrusion_m: f64,
    /// Uncertainty of where the person is, m.
    pub person_uncertainty_m: f64,
    /// Uncertainty of where the robot is, m.
    pub robot_uncertainty_m: f64,
    /// Speed at which people approach, m/s.
    pub approach_m_s: f64,
}

/// A stop of the robots, as the cell file states it.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StatedStop {
    /// From the command until they begin to brake, s.
    pub reaction_s: f64,
    /// From then until they stand, s.
    pub stop_time_s: f64,
    /// How far a point of them gets while they brake, m.
    pub stop_distance_m: f64,
}

impl ClampingRecord {
    /// Whether robots are stated to go on less far than they were stated to, or seen to. Where the FMU shows it, the machine is what
    /// it is.
    #[must_use]
    pub(crate) fn is_looser_than(&self, earlier: &Self) -> bool {
        let Self { contact_signal, travel_after_contact_m } = self;
        contact_signal.is_none() && *travel_after_contact_m < earlier.travel_after_contact_m
    }
}

impl SeparationTerms {
    /// The key of the cell file that makes the distance smaller than `earlier` had it, or perhaps smaller. A stop that the FMU shows
    /// is what it is.
    #[must_use]
    pub(crate) fn looser_than(&self, earlier: &Self) -> Option<&'static str> {
        let Self { stop, stated, intrusion_m, person_uncertainty_m, robot_uncertainty_m, approach_m_s } = self;
        let shorter = match (stop, &earlier.stop) {
            (Some(_), _) => None,
            (None, Some(_)) => Some("stop"),
            (None, None) => match (stated, earlier.stated) {
                (Some(mine), Some(its)) => mine.shorter_than(&its),
                _ => Some("stop"),
            },
        };
        let less = |mine: &f64, its: f64, key: &'static str| (*mine < its).then_some(key);
        shorter
            .or_else(|| less(approach_m_s, earlier.approach_m_s, "approach_m_s"))
            .or_else(|| less(intrusion_m, earlier.intrusion_m, "intrusion_m"))
            .or_else(|| less(person_uncertainty_m, earlier.person_uncertainty_m, "person_uncertainty_m"))
            .or_else(|| less(robot_uncertainty_m, earlier.robot_uncertainty_m, "robot_uncertainty_m"))
    }
}

impl StatedStop {
    fn shorter_than(&self, earlier: &Self) -> Option<&'static str> {
        let Self { reaction_s, stop_time_s, stop_distance_m } = self;
        let less = |mine: &f64, its: f64, key: &'static str| (*mine < its).then_some(key);
        less(reaction_s, earlier.reaction_s, "reaction_s")
            .or_else(|| less(stop_time_s, earlier.stop_time_s, "stop_time_s"))
            .or_else(|| less(stop_distance_m, earlier.stop_distance_m, "stop_distance_m"))
    }
}

impl CriteriaRecord {
    /// In words, for people.
    #[must_use]
    pub fn words(&self) -> String {
        let mut all = Vec::new();
        match self.transient_force {
            Some(Criterion::Absolute) => all.push("transient force".to_owned()),
            Some(Criterion::Approach) => all.push("transient force by the speed of approach".to_owned()),
            None => {}
        }
        if let Some(clamping) = &self.clamping {
            let travel = 1000.0 * clamping.travel_after_contact_m;
            let on = if travel > 0.0 { format!(" (robots go on by up to {travel:.0} mm)") } else { String::new() };
            all.push(format!("clamping{on}"));
        }
        if self.pressure {
            all.push("pressure".to_owned());
        }
        if let Some(limit) = self.moving_contact_faster_than_m_s {
            let from = if limit > 0.0 { format!(" faster than {limit:.2} m/s") } else { String::new() };
            all.push(format!("contact with a robot that moves{from}"));
        }
        if let Some(terms) = &self.separation {
            let stop = terms.stop.as_ref().map_or_else(|| "stated".to_owned(), |stop| format!("by {stop}"));
            all.push(format!(
                "separation (stop {stop}, {:.2} m/s, {:.0} mm intrusion, {:.0} mm uncertainty)",
                terms.approach_m_s,
                1000.0 * terms.intrusion_m,
                1000.0 * (terms.person_uncertainty_m + terms.robot_uncertainty_m)
            ));
        }
        all.join(", ")
    }
}

/// Whether a hazard of this class is one by what counts as unsafe; without a record the transient force does, and nothing else.
#[must_use]
pub(crate) fn judges(criteria: Option<&CriteriaRecord>, class: Class) -> bool {
    let Some(criteria) = criteria else { return class.beside_force().is_none() };
    match class {
        Class::Force | Class::HeadContact => criteria.transient_force.is_some(),
        Class::Clamping => criteria.clamping.is_some(),
        Class::Pressure => criteria.pressure,
        Class::MovingContact => criteria.moving_contact_faster_than_m_s.is_some(),
        Class::Separation => criteria.separation.is_some(),
    }
}

/// Whether a scan that accounted for every sequence, and found hazards of these classes, would have told every hazard of a class. Of
/// those with which sequences do not end, a worse one of the same action stands for others.
#[must_use]
pub(crate) fn tells_all(
    criteria: Option<&CriteriaRecord>,
    class: Class,
    mut found: impl Iterator<Item = Class>,
) -> bool {
    judges(criteria, class) && (class.ends() || !found.any(|other| !other.ends()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(separation: bool) -> CriteriaRecord {
        let terms = SeparationTerms {
            stop: None,
            stated: None,
            intrusion_m: 0.2,
            person_uncertainty_m: 0.0,
            robot_uncertainty_m: 0.0,
            approach_m_s: 1.6,
        };
        CriteriaRecord {
            transient_force: None,
            clamping: None,
            pressure: true,
            moving_contact_faster_than_m_s: None,
            separation: separation.then_some(terms),
        }
    }

    /// What is not looked for is not gone.
    #[test]
    fn what_does_not_count_is_not_told() {
        assert!(judges(None, Class::Force) && judges(None, Class::HeadContact) && !judges(None, Class::Clamping));
        let one = record(false);
        assert!(judges(Some(&one), Class::Pressure) && !judges(Some(&one), Class::Force));
        assert!(!tells_all(Some(&one), Class::Separation, [].into_iter()));
        // One that is told in each action may hide others that do not end it.
        let all = record(true);
        assert!(tells_all(Some(&all), Class::Separation, [Class::Pressure].into_iter()));
        assert!(!tells_all(Some(&all), Class::Separation, [Class::Separation].into_iter()));
        assert!(tells_all(Some(&all), Class::Pressure, [Class::Separation].into_iter()));
    }
}
