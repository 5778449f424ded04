//! The interfaces of all example FMUs as tables, and the modelDescription.xml made from them.
//!
//! This folder knows nothing of how a model behaves. The build script includes it as source, therefore paths within
//! it are relative (`super::`). A workcell is one file of data: its robots, programmes and safeguard.

pub mod coupled;
pub mod description;
pub mod description3;
pub mod door_edge;
pub mod faulty;
pub mod gantry;
pub mod guarded;
pub mod hand_at_table;
pub mod head_collision;
pub mod heavy_workpiece;
pub mod hostile;
pub mod liar;
pub mod light_curtain;
pub mod muted_entrance;
pub mod reset_inside;
pub mod reset_outside;
pub mod robots;
pub mod safety_fence;
pub mod sensor_mat;
pub mod sharp_workpiece;
pub mod short_zone;
pub mod two_scanners;
pub mod types3;
pub mod under_curtain;
pub mod variables;
pub mod wall_behind;
pub mod workcell;

use variables::{Interface, Variant};
use workcell::Spec;

/// The workcells: the six of the paper, in the order of its table, and one for each criterion that the paper does not have (two
/// for clamping), two whose flaw is a reset button, one that people crawl into, one with a door, and one that a pallet leaves.
pub const WORKCELLS: [&Spec; 15] = [
    &safety_fence::SPEC,
    &sensor_mat::SPEC,
    &head_collision::SPEC,
    &light_curtain::SPEC,
    &two_scanners::SPEC,
    &heavy_workpiece::SPEC,
    &hand_at_table::SPEC,
    &wall_behind::SPEC,
    &sharp_workpiece::SPEC,
    &short_zone::SPEC,
    &reset_inside::SPEC,
    &reset_outside::SPEC,
    &under_curtain::SPEC,
    &door_edge::SPEC,
    &muted_entrance::SPEC,
];

/// Builds the interfaces of all models in the library and their variants, in a fixed order. FMI 3.0 has `types3` as
/// well; `hostile` has a library of its own.
pub fn all() -> Vec<Interface> {
    let workcells =
        WORKCELLS.into_iter().flat_map(|spec| Variant::ALL.map(|variant| workcell::interface(spec, variant).0));
    let faulty = [Variant::Faithful, Variant::NoState].map(faulty::interface);
    let others = [gantry::interface(), guarded::interface(), liar::interface()];
    workcells.chain(coupled::all()).chain(coupled::stations()).chain(faulty).chain(others).collect()
}
