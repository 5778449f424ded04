//! `sensor-mat`: a robot between side fences, open to the front, where a sensor mat stops it.
//!
//! Base frame: x towards the person's side, y to the right as seen from there, z up.

use super::robots::CRX_10IA_L;
use super::workcell::{POINTING_DOWN, Place, RobotSpec, Safeguard, Spec, leg};

/// Slowly up the right side, then fast to the left side, there to and fro, and back.
pub const SPEC: Spec = Spec {
    identifier: "sensor_mat",
    name: "sensor-mat",
    description: "Robot between side fences, open to the front; a sensor mat stops it",
    robots: &[RobotSpec {
        suffix: "",
        robot: &CRX_10IA_L,
        rotation: POINTING_DOWN,
        near: [0.5663, 1.0841, -1.2288, 0.0, 1.7156, 0.5663],
        start: [0.90, 0.75, 0.395],
        legs: &[
            leg([0.54, 0.75, 0.395], 0.45),
            leg([0.45, 0.0, 0.495], 2.0),
            leg([0.90, -0.75, 0.395], 2.0),
            leg([0.45, -0.75, 0.395], 2.0),
            leg([0.90, -0.75, 0.395], 2.0),
            leg([0.45, 0.0, 0.495], 2.0),
            leg([0.90, 0.75, 0.395], 2.0),
        ],
        tool_kg: 3.0,
    }],
    t_react: 0.05,
    t_ramp: 0.30,
    t_ramp_loaded: None,
    phase0: 0.20,
    v_approach: None,
    safeguard: Safeguard::Stop {
        input: "plc.mat_clear",
        about: "Signal of the sensor mat; false is the demand for a protective stop (category 1, path kept, latched)",
    },
    output: Place::Joints,
};
