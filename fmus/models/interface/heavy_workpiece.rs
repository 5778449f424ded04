//! `heavy-workpiece`: a collaborating robot that fetches a heavy workpiece from a stand outside its fence.
//!
//! The robot hangs sideways so that its arm moves in a level plane. Base frame: x towards the stand, y up, z to the left
//! as seen from the stand.

use super::robots::UR10E;
use super::workcell::{Leg, Place, RobotSpec, Safeguard, Spec, leg};

/// The workpiece, kg.
const WORKPIECE: f64 = 11.0;

/// Out to the stand, back in with the workpiece, aside to put it down, and out again.
pub const SPEC: Spec = Spec {
    identifier: "heavy_workpiece",
    name: "heavy-workpiece",
    description: "Collaborating robot that fetches a heavy workpiece from a stand; its speed is safely limited",
    robots: &[RobotSpec {
        suffix: "",
        robot: &UR10E,
        rotation: [[0.0, -1.0, 0.0], [-1.0, 0.0, 0.0], [0.0, 0.0, -1.0]],
        near: [3.1414, -0.688, 1.7864, 2.0433, -1.5706, 0.0],
        start: [0.95, 0.174, 0.1807],
        legs: &[
            leg([1.15, 0.174, 0.1807], 0.48),
            Leg { end: [0.40, 0.174, 0.1807], speed: 0.48, carries: WORKPIECE, approach: false },
            Leg { end: [0.30, 0.174, -0.0693], speed: 0.48, carries: WORKPIECE, approach: false },
            leg([0.40, 0.174, 0.1807], 0.48),
            leg([0.95, 0.174, 0.1807], 0.48),
        ],
        tool_kg: 1.5,
    }],
    t_react: 0.05,
    t_ramp: 0.50,
    t_ramp_loaded: None,
    phase0: 0.0,
    v_approach: None,
    safeguard: Safeguard::AlwaysLimited {
        input: "plc.guard_closed",
        about: "Contact of the cell door; false is the demand for a protective stop (category 1, path kept, latched)",
        v_limit: 0.48,
    },
    output: Place::Joints,
};
