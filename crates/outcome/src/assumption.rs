//! What can only be tried out of an FMU: it counts once the cell file accepts it (`[[accept]]`), with a name and a reason, for the FMU
//! that it was tried out with.

/// Something that can only be tried out.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Assumption {
    /// A robot does the same whatever a sensor reports.
    RobotIgnoresSensor {
        /// The robot.
        robot: String,
        /// The sensor.
        sensor: String,
    },
    /// The robots do the same with all people of whom the sensors report the same.
    PeopleAlike,
    /// A sensor inside the FMU reports the same people at any time.
    SensorSeesAlike {
        /// The sensor.
        sensor: String,
    },
    /// Controls are not worked more often than this, all together.
    Presses {
        /// How often.
        at_most: u32,
    },
    /// What the FMU remembers shows within this time while what the sensors report stays the same, and for each report as soon as it did in
    /// trials: states that show the same all that time do the same ever after.
    MemoryShows {
        /// Milliseconds.
        within_ms: u32,
    },
    /// FMU states in which the robots are nearly alike, and for this time at most, by each report as long as trials showed, while what the
    /// sensors report stays the same, lead on to such states.
    NearlyAlike {
        /// Milliseconds.
        within_ms: u32,
    },
    /// The FMU answers different reports of its sensors alike at any time, where it did so in trials.
    ReadingsAlike {
        /// Each with the one that stands for it: `this like that`.
        readings: Vec<String>,
    },
    /// Robots go on after a contact as far as was tried out.
    TravelAfterContact,
}

/// An assumption, and who accepts it.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Acceptance {
    /// What is accepted.
    pub assumption: Assumption,
    /// Who accepts it.
    pub by: String,
    /// Why.
    pub because: String,
}

impl Assumption {
    /// As in the cell file, behind `what`.
    #[must_use]
    pub const fn name(&self) -> &'static str {
        match self {
            Self::RobotIgnoresSensor { .. } => "robot_ignores_sensor",
            Self::PeopleAlike => "people_alike",
            Self::SensorSeesAlike { .. } => "sensor_sees_alike",
            Self::Presses { .. } => "presses",
            Self::MemoryShows { .. } => "memory_shows",
            Self::NearlyAlike { .. } => "nearly_alike",
            Self::ReadingsAlike { .. } => "readings_alike",
            Self::TravelAfterContact => "travel_after_contact",
        }
    }

    /// In half a sentence.
    #[must_use]
    pub(crate) fn words(&self) -> String {
        match self {
            Self::RobotIgnoresSensor { robot, sensor } => format!("{robot} does not heed {sensor}"),
            Self::PeopleAlike => {
                "the robots do the same with all people of whom the sensors report the same".to_owned()
            }
            Self::SensorSeesAlike { sensor } => format!("{sensor} sees the same people at any time"),
            Self::Presses { at_most: 0 } => "no control is worked".to_owned(),
            Self::Presses { at_most: 1 } => "controls are worked once at most".to_owned(),
            Self::Presses { at_most } => format!("controls are worked {at_most} times at most"),
            Self::MemoryShows { within_ms } => format!(
                "what the FMU remembers shows within {:.2} s, and as soon as it did in trials, while what the sensors report stays the same",
                f64::from(*within_ms) / 1000.0
            ),
            Self::NearlyAlike { within_ms } => format!(
                "robots that are and move nearly alike, now and as long as trials showed, {:.2} s at most, while what the sensors report stays \
                 the same, go on nearly alike",
                f64::from(*within_ms) / 1000.0
            ),
            Self::ReadingsAlike { .. } => {
                "the FMU answers different reports of its sensors alike at any time, where it did so in trials"
                    .to_owned()
            }
            Self::TravelAfterContact => "robots go on after a contact as far as they did in trials".to_owned(),
        }
    }

    /// Whether accepting this accepts `other`: the same, or more presses, or more time, than were asked for.
    #[must_use]
    pub fn covers(&self, other: &Self) -> bool {
        match (self, other) {
            // Whoever says that there is one press at most is answered by a search with two.
            (Self::Presses { at_most: mine }, Self::Presses { at_most: its }) => mine <= its,
            // What shows within a second shows within two.
            (Self::MemoryShows { within_ms: mine }, Self::MemoryShows { within_ms: its })
            | (Self::NearlyAlike { within_ms: mine }, Self::NearlyAlike { within_ms: its }) => mine <= its,
            // Whoever accepts more of them is answered where fewer are taken for one.
            (Self::ReadingsAlike { readings: mine }, Self::ReadingsAlike { readings: its }) => {
                its.iter().all(|one| mine.contains(one))
            }
            _ => self == other,
        }
    }

    /// The lines that accept it for an FMU, for the cell file.
    #[must_use]
    pub(crate) fn lines(&self, fmu: &str) -> String {
        let quoted = |text: &str| toml::Value::String(text.to_owned()).to_string();
        let mut lines = format!("[[accept]]\nwhat = {}\n", quoted(self.name()));
        match self {
            Self::RobotIgnoresSensor { robot, sensor } => {
                lines += &format!("robot = {}\nsensor = {}\n", quoted(robot), quoted(sensor));
            }
            Self::SensorSeesAlike { sensor } => lines += &format!("sensor = {}\n", quoted(sensor)),
            Self::Presses { at_most } => lines += &format!("at_most = {at_most}\n"),
            Self::MemoryShows { within_ms } | Self::NearlyAlike { within_ms } => {
                lines += &format!("within_s = {}\n", f64::from(*within_ms) / 1000.0);
            }
            Self::ReadingsAlike { readings } => {
                let readings: Vec<String> = readings.iter().map(|one| quoted(one)).collect();
                lines += &format!("readings = [{}]\n", readings.join(", "));
            }
            Self::PeopleAlike | Self::TravelAfterContact => {}
        }
        lines + &format!("fmu = {}\nby = \"\"       # who accepts it\nbecause = \"\"  # why it holds\n", quoted(fmu))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn presses_are_accepted_by_whoever_says_that_there_are_no_more() {
        let presses = |at_most| Assumption::Presses { at_most };
        assert!(presses(1).covers(&presses(1)) && presses(1).covers(&presses(2)));
        assert!(!presses(2).covers(&presses(1)) && !Assumption::PeopleAlike.covers(&presses(1)));
    }

    #[test]
    fn readings_are_accepted_one_by_one() {
        let alike =
            |of: &[&str]| Assumption::ReadingsAlike { readings: of.iter().map(|one| (*one).to_owned()).collect() };
        let (one, both, other) = (alike(&["a like b"]), alike(&["c like b", "a like b"]), alike(&["c like b"]));
        assert!(both.covers(&one) && both.covers(&other) && !one.covers(&both) && !one.covers(&other));
    }

    /// Names with quotes and backslashes stay names.
    #[test]
    fn the_lines_are_toml() {
        let robot = "a \"b\" \\ c".to_owned();
        let lines = Assumption::RobotIgnoresSensor { robot: robot.clone(), sensor: "mat".to_owned() }.lines("ab");
        let table: toml::Table = lines.parse().unwrap();
        let accept = &table["accept"][0];
        assert_eq!((accept["robot"].as_str(), accept["fmu"].as_str()), (Some(robot.as_str()), Some("ab")));
    }
}
