//! `door-edge`: the robot of `sensor-mat` behind a door, whose opening the controller takes for a demand, not its being open.

use super::sensor_mat;
use super::workcell::{Safeguard, Spec};

/// The robot and its programme are those of `sensor-mat`.
pub const SPEC: Spec = Spec {
    identifier: "door_edge",
    name: "door-edge",
    description: "Robot between fences with a door; opening it stops the robot, a reset button starts it again",
    safeguard: Safeguard::Door {
        input: "plc.door_closed",
        about: "Contact of the door; its opening is the demand for a protective stop (category 1, path kept, latched)",
    },
    ..sensor_mat::SPEC
};
