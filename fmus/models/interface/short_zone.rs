//! `short-zone`: a robot that carries castings behind a conveyor; a scanner stops it, which takes longer with a casting.
//!
//! Base frame: axes as the cell's, origin on the robot's stand.

use super::robots::UR10E;
use super::workcell::{Place, RobotSpec, Safeguard, Spec, UR_POINTING_DOWN, leg, loaded};

/// A casting, kg.
const CASTING: f64 = 8.0;

/// To the left empty, to the right with a casting.
pub const SPEC: Spec = Spec {
    identifier: "short_zone",
    name: "short-zone",
    description: "Robot that carries castings; a scanner stops it, which takes longer with a casting",
    robots: &[RobotSpec {
        suffix: "",
        robot: &UR10E,
        rotation: UR_POINTING_DOWN,
        near: [2.1304, -1.3559, 1.8336, -2.0485, -1.57, -2.582],
        start: [0.55, -0.55, 0.30],
        legs: &[leg([-0.55, -0.55, 0.30], 0.9), loaded([0.55, -0.55, 0.30], 0.9, CASTING)],
        tool_kg: 2.0,
    }],
    t_react: 0.10,
    t_ramp: 0.30,
    t_ramp_loaded: Some(0.70),
    phase0: 1.1,
    v_approach: None,
    safeguard: Safeguard::Stop {
        input: "plc.field_clear",
        about: "Signal of the laser scanner; false is the demand for a protective stop (category 1, path kept, latched)",
    },
    output: Place::Joints,
};
