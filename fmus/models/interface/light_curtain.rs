//! `light-curtain`: an industrial robot behind an entrance that a light curtain guards.
//!
//! Base frame: x towards the entrance, y to the right as seen from there, z up.

use super::robots::KR_16;
use super::workcell::{POINTING_DOWN, Place, RobotSpec, Safeguard, Spec, leg};

/// From side to side past the entrance, nearest to it in the middle.
pub const SPEC: Spec = Spec {
    identifier: "light_curtain",
    name: "light-curtain",
    description: "Industrial robot behind an entrance; a light curtain stops it",
    robots: &[RobotSpec {
        suffix: "",
        robot: &KR_16,
        rotation: POINTING_DOWN,
        near: [-1.0637, 0.2885, 0.3018, 0.0, 0.9804, -1.0637],
        start: [0.50, -0.90, 0.725],
        legs: &[
            leg([1.12, 0.0, 0.725], 2.0),
            leg([0.50, 0.90, 0.725], 2.0),
            leg([1.12, 0.0, 0.725], 2.0),
            leg([0.50, -0.90, 0.725], 2.0),
        ],
        tool_kg: 10.0,
    }],
    t_react: 0.05,
    t_ramp: 0.40,
    t_ramp_loaded: None,
    phase0: 0.176,
    v_approach: None,
    safeguard: Safeguard::Stop {
        input: "plc.curtain_clear",
        about: "Signal of the light curtain; false is the demand for a protective stop (category 1, path kept, latched)",
    },
    output: Place::Joints,
};
