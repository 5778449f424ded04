//! `head-collision`: a collaborating robot on a table; a scanner field slows it down. Tells the pose of each link.
//!
//! Base frame: axes as the cell's, origin on the table.

use super::robots::UR5E;
use super::workcell::{Place, RobotSpec, Safeguard, Spec, leg};

/// Up on the left, across, down on the right, and back the same way, the tool pointing to the person's side.
pub const SPEC: Spec = Spec {
    identifier: "head_collision",
    name: "head-collision",
    description: "Collaborating robot on a table; a scanner field slows it down",
    robots: &[RobotSpec {
        suffix: "",
        robot: &UR5E,
        rotation: [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]],
        near: [0.421, -1.4726, 1.9588, -0.4862, 0.421, 0.0],
        start: [-0.30, -0.48, 0.3025],
        legs: &[
            leg([-0.30, -0.48, 0.5025], 0.6),
            leg([0.30, -0.48, 0.5025], 1.0),
            leg([0.30, -0.48, 0.3025], 0.6),
            leg([0.30, -0.48, 0.5025], 0.6),
            leg([-0.30, -0.48, 0.5025], 1.0),
            leg([-0.30, -0.48, 0.3025], 0.6),
        ],
        tool_kg: 3.0,
    }],
    t_react: 0.12,
    t_ramp: 0.50,
    t_ramp_loaded: None,
    phase0: 0.0,
    v_approach: None,
    safeguard: Safeguard::Slow {
        input: "plc.field_clear",
        about: "Signal of the laser scanner; false limits the speed as long as it lasts",
        v_reduced: 0.25,
    },
    output: Place::LinkPoses,
};
