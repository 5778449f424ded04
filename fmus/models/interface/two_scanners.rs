//! `two-scanners`: two robots on one table, each stopped by its own laser scanner. The scanners are part of the FMU.
//!
//! Base frames: x towards the person's side, y to the right as seen from there, z up.

use super::robots::IRB_1200;
use super::workcell::{POINTING_DOWN, Place, RobotSpec, Safeguard, Spec, leg};

/// Each robot goes to and fro between the middle of the table and its own end.
pub const SPEC: Spec = Spec {
    identifier: "two_scanners",
    name: "two-scanners",
    description: "Two robots on one table; each is stopped by its own laser scanner, which sees the person's feet",
    robots: &[
        RobotSpec {
            suffix: "_a",
            robot: &IRB_1200,
            rotation: POINTING_DOWN,
            near: [0.7309, 0.8604, -0.5218, 0.0, 1.2323, 0.7309],
            start: [0.58, 0.52, 0.3991],
            legs: &[leg([0.58, -0.30, 0.3991], 1.8), leg([0.58, 0.52, 0.3991], 1.8)],
            tool_kg: 3.0,
        },
        RobotSpec {
            suffix: "_b",
            robot: &IRB_1200,
            rotation: POINTING_DOWN,
            near: [-0.7309, 0.8604, -0.5218, 0.0, 1.2323, -0.7309],
            start: [0.58, -0.52, 0.3991],
            legs: &[leg([0.58, 0.30, 0.3991], 1.8), leg([0.58, -0.52, 0.3991], 1.8)],
            tool_kg: 3.0,
        },
    ],
    t_react: 0.10,
    t_ramp: 0.30,
    t_ramp_loaded: None,
    phase0: 0.0,
    v_approach: None,
    safeguard: Safeguard::Fields { start: [-2.4, 0.0, 0.0, 2.4, -1.6] },
    output: Place::Joints,
};
