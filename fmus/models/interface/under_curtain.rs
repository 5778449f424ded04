//! `under-curtain`: the robot of `light-curtain`, far enough behind a curtain whose lowest beam is too high.

use super::light_curtain;
use super::workcell::Spec;

/// The robot, its programme and its safety controller are those of `light-curtain`: what is wrong is where the beams are.
pub const SPEC: Spec = Spec {
    identifier: "under_curtain",
    name: "under-curtain",
    description: "Industrial robot behind an entrance; a light curtain with room below it stops it",
    ..light_curtain::SPEC
};
