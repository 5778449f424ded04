//! `safety-fence`: a handling robot behind a fence with a feed opening; the guard contact stops it.

use super::robots::IRB_1200;
use super::workcell::{POINTING_DOWN, Place, RobotSpec, Safeguard, Spec, leg};

/// Out of the feed opening (low), up, across to the tray, down, and back the same way.
pub const SPEC: Spec = Spec {
    identifier: "safety_fence",
    name: "safety-fence",
    description: "Handling robot behind a fence with a feed opening; the guard contact stops it",
    robots: &[RobotSpec {
        suffix: "",
        robot: &IRB_1200,
        rotation: POINTING_DOWN,
        near: [0.0, 0.3, 0.25, 0.0, 1.0, 0.0],
        start: [0.60, 0.0, 0.4991],
        legs: &[
            leg([0.60, 0.0, 0.5991], 0.5),
            leg([0.20, 0.60, 0.5991], 2.0),
            leg([0.20, 0.60, 0.4991], 0.5),
            leg([0.20, 0.60, 0.5991], 0.5),
            leg([0.60, 0.0, 0.5991], 2.0),
            leg([0.60, 0.0, 0.4991], 0.5),
        ],
        tool_kg: 3.0,
    }],
    t_react: 0.05,
    t_ramp: 0.30,
    t_ramp_loaded: None,
    phase0: 0.0,
    v_approach: None,
    safeguard: Safeguard::Stop {
        input: "plc.guard_closed",
        about: "Guard contact; false is the demand for a protective stop (category 1, path kept, latched)",
    },
    output: Place::Joints,
};
