//! `reset-outside`: the robot of `sensor-mat` behind a strip of mat at the front; its reset button is outside, where nobody sees
//! whether somebody is inside.

use super::sensor_mat;
use super::workcell::Spec;

/// The robot, its programme and its safety controller are those of `sensor-mat`: what is wrong is what the button does not ask.
pub const SPEC: Spec = Spec {
    identifier: "reset_outside",
    name: "reset-outside",
    description: "Robot between side fences; a strip of mat at the front stops it, a button outside starts it again",
    ..sensor_mat::SPEC
};
