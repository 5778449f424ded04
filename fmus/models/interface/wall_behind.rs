//! `wall-behind`: a collaborating robot that hands parts out through a window, to people in front of a wall.
//!
//! The robot hangs sideways so that its arm moves in a level plane. Base frame: x out of the window, y up, z to the left
//! as seen from outside.

use super::robots::UR10E;
use super::workcell::{Place, RobotSpec, Safeguard, Spec, leg, loaded};

/// A part, kg.
const PART: f64 = 1.0;

/// Out with a part, in again without.
pub const SPEC: Spec = Spec {
    identifier: "wall_behind",
    name: "wall-behind",
    description: "Collaborating robot that hands parts out to people in front of a wall",
    robots: &[RobotSpec {
        suffix: "",
        robot: &UR10E,
        rotation: [[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
        near: [3.1414, -0.688, 1.7864, 2.0433, -1.5706, 0.0],
        start: [0.85, 0.174, 0.1807],
        legs: &[loaded([1.15, 0.174, 0.1807], 0.3, PART), leg([0.85, 0.174, 0.1807], 0.3)],
        tool_kg: 1.5,
    }],
    t_react: 0.05,
    t_ramp: 0.30,
    t_ramp_loaded: None,
    phase0: 0.0,
    v_approach: None,
    safeguard: Safeguard::Stop {
        input: "plc.emergency_stop_clear",
        about: "Emergency stop; false is the demand for a protective stop (category 1, path kept, latched)",
    },
    output: Place::Joints,
};
