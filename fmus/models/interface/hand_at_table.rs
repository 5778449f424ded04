//! `hand-at-table`: a collaborating robot on a table that picks parts from the table and puts them down again.
//!
//! Base frame: axes as the cell's, origin on the table.

use super::robots::UR10E;
use super::workcell::{Place, RobotSpec, Safeguard, Spec, UR_POINTING_DOWN, approaching, leg, loaded};

/// A part, kg.
const PART: f64 = 1.0;
/// Where the tool centre point is above the tray.
const OVER_TRAY: [f64; 3] = [-0.25, -0.55, 0.35];
/// Where the approach to the tray begins, and in the tray.
const ABOVE_TRAY: [f64; 3] = [-0.25, -0.55, 0.18];
const IN_TRAY: [f64; 3] = [-0.25, -0.55, 0.07];
/// Where the approach to the next part begins, and at the part.
const ABOVE_PART: [f64; 3] = [0.15, -0.55, 0.18];
const AT_PART: [f64; 3] = [0.15, -0.55, 0.07];

/// From above the tray to the next part, down to it, up, back with it, and down into the tray. The gripper ends 40 mm
/// below the tool centre point, so an approach goes from 140 to 30 mm above the table.
pub const SPEC: Spec = Spec {
    identifier: "hand_at_table",
    name: "hand-at-table",
    description: "Collaborating robot that picks parts from the table at which people work",
    robots: &[RobotSpec {
        suffix: "",
        robot: &UR10E,
        rotation: UR_POINTING_DOWN,
        near: [0.8518, -1.6813, 2.0823, -1.9718, -1.57, -3.8606],
        start: OVER_TRAY,
        legs: &[
            leg(ABOVE_PART, 0.5),
            approaching(leg(AT_PART, 0.5)),
            loaded(ABOVE_PART, 0.5, PART),
            loaded(OVER_TRAY, 0.5, PART),
            loaded(ABOVE_TRAY, 0.5, PART),
            approaching(loaded(IN_TRAY, 0.5, PART)),
            leg(OVER_TRAY, 0.5),
        ],
        tool_kg: 1.5,
    }],
    t_react: 0.05,
    t_ramp: 0.30,
    t_ramp_loaded: None,
    phase0: 0.2,
    v_approach: Some(0.25),
    safeguard: Safeguard::Stop {
        input: "plc.emergency_stop_clear",
        about: "Emergency stop; false is the demand for a protective stop (category 1, path kept, latched)",
    },
    output: Place::Joints,
};
