//! What a run has seen, so that "no hazard" never stands alone.

mod robots;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

pub use self::robots::{NoContactReason, RobotCoverage};

/// Figures beside a verdict.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Coverage {
    /// Episodes begun.
    pub episodes: u64,
    /// Episodes the FMU could not finish: not evaluated, never counted as safe.
    pub episodes_not_evaluated: u64,
    /// Actions simulated.
    pub actions: u64,
    /// Instants at which person and robot were compared.
    pub contact_checks: u64,
    /// Arm searches run (an arm is searched only when the robot is in reach and fast enough to matter).
    pub arm_checks: u64,
    /// Arm searches that stopped at their work limit before they could exclude a contact; zero unless a cell is extreme.
    pub arm_checks_incomplete: u64,
    /// Runs in which a plane tells of an arm that the FMU could not finish: what the arm meets there is not evaluated, never
    /// counted as safe.
    #[serde(default)]
    pub arm_runs_not_evaluated: u64,
    /// Boxes of joint angles that all arm searches together looked at: what their work is measured in.
    pub arm_boxes: u64,
    /// Smallest distance between trunk, head or legs and the robot, m; negative when they met. An exhaustive search takes
    /// no notice of robots too slow to harm anyone.
    pub closest_approach_m: f64,
    /// Instants at which an arm could have bridged the distance to the robot, were nothing in between.
    pub checks_with_robot_in_arm_reach: u64,
    /// Contacts met that stay within the limits, at the ends of episodes or with the trunk.
    pub contacts_within_limits: u64,
    /// Highest force ratio of those.
    pub highest_ratio_within_limits: f64,
    /// Highest speed bound of any robot link, m/s, by the speeds that the FMU tells.
    pub robot_top_speed_m_s: f64,
    /// For each sensor, the number of actions in which it reported the person.
    pub sensor_actions: Vec<u64>,
    /// Actions in which an obstacle stopped the person's walk.
    pub walks_blocked: u64,
    /// For each control, the number of actions in which it was worked. Empty as `robots` is.
    #[serde(default)]
    pub control_actions: Vec<u64>,
    /// Each robot, in the order of the cell. Empty where that was not looked at, as from anywhere.
    #[serde(default)]
    pub robots: Vec<RobotCoverage>,
}

impl Coverage {
    /// Nothing seen yet, with `sensors` sensors.
    #[must_use]
    pub fn new(sensors: usize) -> Self {
        Self {
            episodes: 0,
            episodes_not_evaluated: 0,
            actions: 0,
            contact_checks: 0,
            arm_checks: 0,
            arm_checks_incomplete: 0,
            arm_runs_not_evaluated: 0,
            arm_boxes: 0,
            closest_approach_m: f64::MAX,
            checks_with_robot_in_arm_reach: 0,
            contacts_within_limits: 0,
            highest_ratio_within_limits: 0.0,
            robot_top_speed_m_s: 0.0,
            sensor_actions: vec![0; sensors],
            walks_blocked: 0,
            control_actions: Vec::new(),
            robots: Vec::new(),
        }
    }

    /// Nothing seen yet of a cell with so many sensors, so many controls, and robots of these names.
    #[must_use]
    pub fn of<'a>(sensors: usize, controls: usize, robots: impl Iterator<Item = &'a str>) -> Self {
        Self {
            control_actions: vec![0; controls],
            robots: robots.map(RobotCoverage::named).collect(),
            ..Self::new(sensors)
        }
    }

    /// Adds the figures of another run of the same cell.
    pub fn merge(&mut self, other: &Self) {
        self.episodes += other.episodes;
        self.episodes_not_evaluated += other.episodes_not_evaluated;
        self.actions += other.actions;
        self.contact_checks += other.contact_checks;
        self.arm_checks += other.arm_checks;
        self.arm_checks_incomplete += other.arm_checks_incomplete;
        self.arm_runs_not_evaluated += other.arm_runs_not_evaluated;
        self.arm_boxes += other.arm_boxes;
        self.closest_approach_m = self.closest_approach_m.min(other.closest_approach_m);
        self.checks_with_robot_in_arm_reach += other.checks_with_robot_in_arm_reach;
        self.contacts_within_limits += other.contacts_within_limits;
        self.highest_ratio_within_limits = self.highest_ratio_within_limits.max(other.highest_ratio_within_limits);
        self.robot_top_speed_m_s = self.robot_top_speed_m_s.max(other.robot_top_speed_m_s);
        self.sensor_actions.iter_mut().zip(&other.sensor_actions).for_each(|(a, b)| *a += b);
        self.walks_blocked += other.walks_blocked;
        let controls = self.control_actions.len().max(other.control_actions.len());
        self.control_actions.resize(controls, 0);
        self.control_actions.iter_mut().zip(&other.control_actions).for_each(|(a, b)| *a += b);
        other.robots.iter().enumerate().for_each(|(number, robot)| self.robot(number).merge(robot));
    }

    /// Adds what looking for arms cost in the same place once more, and what of it is not known.
    pub fn merge_arms(&mut self, other: &Self) {
        self.arm_checks += other.arm_checks;
        self.arm_checks_incomplete += other.arm_checks_incomplete;
        self.arm_runs_not_evaluated += other.arm_runs_not_evaluated;
        self.arm_boxes += other.arm_boxes;
    }

    /// Whether something is not known because the FMU could not finish it.
    #[must_use]
    pub const fn not_evaluated(&self) -> bool {
        self.episodes_not_evaluated > 0 || self.arm_runs_not_evaluated > 0
    }

    /// What comparing person and robots cost, beside so many steps of the FMU, see [`cost`].
    pub const fn cost(&self, steps: u64) -> u64 {
        cost(steps, self.contact_checks, self.arm_boxes)
    }
}

/// What a search did, in communication steps of an FMU in a worker, about: a question whether a person can be touched costs
/// 0.6 of one, a box of joint angles 0.25. The same on every machine.
#[must_use]
pub const fn cost(steps: u64, questions: u64, boxes: u64) -> u64 {
    steps + questions * 6 / 10 + boxes / 4
}

#[cfg(test)]
#[path = "coverage_tests.rs"]
mod tests;
