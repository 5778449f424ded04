//! Protective separation distance of speed and separation monitoring (ISO/TS 15066, 5.5.4): `S_p = v_h T + S + C + Z_d + Z_r`.

/// What of it the cell file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Separation {
    /// How long robots go on when they are stopped, and how far.
    pub stop: Stop,
    /// How far a part of the body gets in before the person is seen, `C`, m.
    pub intrusion_m: f64,
    /// Uncertainty of where the person is, `Z_d`, m.
    pub person_uncertainty_m: f64,
    /// Uncertainty of where the robot is, `Z_r`, m.
    pub robot_uncertainty_m: f64,
    /// Speed at which people approach, `v_h`, m/s.
    pub approach_m_s: f64,
}

/// Where the stop's figures are from.
#[derive(Clone, Debug, PartialEq)]
pub enum Stop {
    /// The FMU is run on with this sensor reporting somebody, or with this input changed: its name, and its place in the file
    /// as a line for messages.
    Measured(String),
    /// They are stated.
    Stated {
        /// From the command until the robot begins to brake, `T_r`, s.
        reaction_s: f64,
        /// From then until it stands, `T_s`, s.
        stop_time_s: f64,
        /// How far a point of it gets while it brakes, `S_s`, m.
        stop_distance_m: f64,
    },
}

/// What a stop takes, from an instant on.
#[derive(Clone, Debug, PartialEq)]
pub struct Stopping {
    /// How long some link still moves, s; infinite if it does not stand after the time that is waited.
    pub time_s: f64,
    /// How far any point of each link gets until then at most, m.
    pub travel_m: Vec<f64>,
}

impl Separation {
    /// The protective separation distance from a link that still gets `travel_m` far in `time_s`, m.
    #[must_use]
    pub fn required_m(&self, time_s: f64, travel_m: f64) -> f64 {
        self.approach_m_s * time_s + travel_m + self.intrusion_m + self.person_uncertainty_m + self.robot_uncertainty_m
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A calculation by hand: 1.6 m/s for 0.1 s and 0.35 s, a robot of 1 m/s that goes 0.1 m in the first and 0.175 m in the
    /// second, and 0.85 + 0.1 + 0.02 m: 0.72 + 0.275 + 0.97 = 1.965 m.
    #[test]
    fn by_hand() {
        let separation = Separation {
            stop: Stop::Measured("scanner".to_owned()),
            intrusion_m: 0.85,
            person_uncertainty_m: 0.1,
            robot_uncertainty_m: 0.02,
            approach_m_s: 1.6,
        };
        assert!((separation.required_m(0.45, 0.275) - 1.965).abs() < 1e-12);
    }
}
