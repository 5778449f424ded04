//! `muted-entrance`: the robot of `light-curtain` behind an entrance that a pallet leaves while the light curtain is muted.

use super::light_curtain;
use super::workcell::{Safeguard, Spec};

/// The robot and its programme are those of `light-curtain`; it works while the pallet is conveyed out.
pub const SPEC: Spec = Spec {
    identifier: "muted_entrance",
    name: "muted-entrance",
    description: "Industrial robot behind an entrance; a light curtain stops it, muted while a pallet leaves",
    phase0: 0.176,
    safeguard: Safeguard::Muted {
        input: "plc.curtain_clear",
        about: "Signal of the light curtain; false is the demand for a protective stop (category 1, path kept, latched)",
        start: [0.2, 0.5, 3.0, 0.75, 6.0],
    },
    ..light_curtain::SPEC
};
