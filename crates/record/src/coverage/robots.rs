//! What a run has seen of each robot: whether it moved, and whether anybody ever got near it. Where nobody was near a robot, finding no
//! contact with it says nothing.

use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Coverage;
use fmi_hazard_criteria::STANDSTILL_M_S;

/// Figures of one robot.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RobotCoverage {
    /// Its name in the cell.
    pub name: String,
    /// Highest speed bound of any of its links, m/s, by the speeds that the FMU tells.
    pub top_speed_m_s: f64,
    /// Whether anything of it changed its place, whatever speeds the FMU told.
    pub moved: bool,
    /// Whether somebody can be near it at all by the end of the sequences: by the lengths of the robot and the person's speed alone. True
    /// where nothing bounds the robot (parts that slide, poses that the FMU gives, separation).
    pub reachable: bool,
    /// Instants at which it was where somebody who walks, or runs, straight from the start with nothing in between could touch it by
    /// then. None of them: the time was too short, or the robot is elsewhere than in the real cell.
    pub instants_to_walk_to: u64,
    /// Instants at which it was near enough to be touched in some posture: a link no farther from the point 1 m above somebody's feet
    /// than any part of them gets from there. What is in between is not looked at, nor whether the robot moved. Each instant of an action
    /// counts once, whatever follows from it, also those after a hazard.
    pub instants_in_reach: u64,
    /// Smallest distance between trunk, head or legs and this robot, m; negative when they met. `f64::MAX`: never measured, because
    /// nobody was within 1 m of its reach while any robot was fast enough to harm. An exhaustive search takes no notice of robots too slow
    /// to harm anyone, so ask `instants_in_reach` whether anybody was near.
    pub closest_approach_m: f64,
}

impl Default for RobotCoverage {
    fn default() -> Self {
        Self {
            name: String::new(),
            top_speed_m_s: 0.0,
            moved: false,
            reachable: false,
            instants_to_walk_to: 0,
            instants_in_reach: 0,
            closest_approach_m: f64::MAX,
        }
    }
}

impl RobotCoverage {
    /// Nothing seen yet of the robot of this name.
    pub(super) fn named(name: &str) -> Self {
        Self { name: name.to_owned(), ..Self::default() }
    }

    /// Adds the figures of another run of the same cell.
    pub(super) fn merge(&mut self, other: &Self) {
        if self.name.is_empty() {
            self.name.clone_from(&other.name);
        }
        self.top_speed_m_s = self.top_speed_m_s.max(other.top_speed_m_s);
        self.moved |= other.moved;
        self.reachable |= other.reachable;
        self.instants_to_walk_to += other.instants_to_walk_to;
        self.instants_in_reach += other.instants_in_reach;
        self.closest_approach_m = self.closest_approach_m.min(other.closest_approach_m);
    }
}

/// Why finding no contact with a robot needs another look.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", tag = "what")]
pub enum NoContactReason {
    /// No action was simulated, so nothing is known.
    NotSimulated,
    /// Nobody could be near it in the time, whatever they did.
    TooFar,
    /// It never moved.
    NeverMoved {
        /// Whether some control of the cell was worked meanwhile, and the FMU answered. Then that it stands is what was looked for, as far
        /// as it is the control that would start this robot.
        controls_worked: bool,
    },
    /// Nobody was ever near it, though a straight way would have been short enough, and no obstacle stopped anybody.
    NeverNear,
    /// Nobody was ever near it, though a straight way would have been short enough; obstacles stopped people.
    KeptOut,
}

impl NoContactReason {
    /// Whether it answers the question all the same: a guard that keeps people out, a start that is prevented.
    #[must_use]
    pub const fn is_shown(self) -> bool {
        match self {
            Self::KeptOut | Self::NeverMoved { controls_worked: true } => true,
            Self::NotSimulated | Self::TooFar | Self::NeverNear | Self::NeverMoved { controls_worked: false } => false,
        }
    }

    /// For people, of the robot that they call `robot`.
    #[must_use]
    pub fn words(self, robot: &str) -> String {
        let mut words = match self {
            Self::NotSimulated => format!("no action with {robot} was simulated"),
            Self::TooFar => {
                format!("{robot} was never near enough to be touched: nobody could walk to where it was in the time")
            }
            Self::NeverMoved { controls_worked: false } => format!("{robot} never moved"),
            Self::NeverMoved { controls_worked: true } => {
                format!("{robot} never moved, though controls of the cell were worked")
            }
            Self::NeverNear => format!("nobody was ever near enough to touch {robot}"),
            Self::KeptOut => format!("nobody was ever near enough to touch {robot}: obstacles kept everybody away"),
        };
        let _ = match self {
            Self::TooFar => write!(
                words,
                ". Begin nearer (human.start), look at longer sequences (search.actions), or mend the robot's base, joints or units"
            ),
            Self::NeverMoved { controls_worked: false } => {
                write!(words, ". Are all [inputs] as they should be, and do its joints name the right variables?")
            }
            Self::NotSimulated | Self::NeverNear | Self::KeptOut | Self::NeverMoved { controls_worked: true } => Ok(()),
        };
        words
    }
}

impl Coverage {
    /// Why no contact with a robot, by its number in the cell, was met, where it never moved or nobody was ever near it; nothing where
    /// somebody was near it and it moved.
    ///
    /// It is about the actions that were simulated; whether these were all is another question.
    #[must_use]
    pub fn no_contact_reason(&self, robot: usize) -> Option<NoContactReason> {
        let Some(own) = self.robots.get(robot) else { return Some(NoContactReason::NotSimulated) };
        let simulated = self.actions > 0;
        if !own.reachable || (simulated && own.instants_to_walk_to == 0 && own.instants_in_reach == 0) {
            return Some(NoContactReason::TooFar);
        }
        if !simulated {
            return Some(NoContactReason::NotSimulated);
        }
        if own.top_speed_m_s < STANDSTILL_M_S && !own.moved {
            let controls_worked = self.control_actions.iter().any(|actions| *actions > 0);
            return Some(NoContactReason::NeverMoved { controls_worked });
        }
        let away = if self.walks_blocked > 0 { NoContactReason::KeptOut } else { NoContactReason::NeverNear };
        (own.instants_in_reach == 0).then_some(away)
    }

    /// The figures of a robot, by its number in the cell.
    pub fn robot(&mut self, robot: usize) -> &mut RobotCoverage {
        if self.robots.len() <= robot {
            self.robots.resize(robot + 1, RobotCoverage::default());
        }
        &mut self.robots[robot]
    }
}
