//! `reset-inside`: the robot of `sensor-mat` behind a strip of mat at the front; its reset button can be reached from behind the
//! mat.

use super::sensor_mat;
use super::workcell::Spec;

/// The robot, its programme and its safety controller are those of `sensor-mat`: what is wrong is where the button is.
pub const SPEC: Spec = Spec {
    identifier: "reset_inside",
    name: "reset-inside",
    description: "Robot between side fences; a strip of mat at the front stops it, a reset button starts it again",
    ..sensor_mat::SPEC
};
