//! `sharp-workpiece`: a collaborating robot that carries a metal sheet over the bench at which people work.
//!
//! Base frame: axes as the cell's, origin on the bench.

use super::robots::UR10E;
use super::workcell::{Place, RobotSpec, Safeguard, Spec, UR_POINTING_DOWN, loaded};

/// The sheet of steel, 0.40 x 0.30 x 0.004 m, kg.
const SHEET: f64 = 3.8;

/// To and fro along the bench, as for an inspection.
pub const SPEC: Spec = Spec {
    identifier: "sharp_workpiece",
    name: "sharp-workpiece",
    description: "Collaborating robot that carries a metal sheet over the bench at which people work",
    robots: &[RobotSpec {
        suffix: "",
        robot: &UR10E,
        rotation: UR_POINTING_DOWN,
        near: [0.5993, -1.6097, 2.283, -2.2441, -1.57, -4.1131],
        start: [-0.35, -0.45, 0.22],
        legs: &[loaded([0.35, -0.45, 0.22], 0.4, SHEET), loaded([-0.35, -0.45, 0.22], 0.4, SHEET)],
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
