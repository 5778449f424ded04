//! The paper's transition function: plant, person, sensors and contacts joined into one [`Environment`].
//!
//! - [`robot`]: the robot at one instant, from the FMU's outputs
//! - [`sensors`]: what the sensors report while the person walks
//! - [`encounter`]: person against robot at one instant: contact, danger
//! - `pinch`: where a link may clamp an arm
//! - [`world`]: what follows without the FMU: walking, sensing, touching
//! - [`detection_plane`]: reaching through a detection plane, and when
//! - [`threads`]: independent work on all cores, for what asks that of many
//! - [`bound`]: how far robots and person can come at all
//! - [`simulation`]: one action after the other, with snapshots of *everything*
//! - [`between`]: where they may be in a part of a communication step
//! - `action_hazards`: the hazards of one action, for all people
//! - `action`: an action from a state: where it leads, what is detected, what the FMU answers
//! - `behind`: what comes behind the first hazard by contact
//! - [`surrogate`]: what a sequence would lead to if the robots moved as they were seen to
//! - [`motion`]: whether the speeds that the FMU reports are those at which it moves
//! - [`answers`]: answers to questions whether people can be touched, kept and shared
//! - [`replay`]: one sequence from a fresh instance, with no restore
//!
//! [`Environment`]: fmi_hazard_search::Environment

pub mod action;
pub mod action_hazards;
pub mod answers;
pub(crate) mod behind;
pub mod between;
pub mod bound;
pub mod detection_plane;
pub mod encounter;
pub mod motion;
pub(crate) mod pinch;
pub mod replay;
pub mod robot;
pub mod robots;
pub mod sensors;
pub mod simulation;
pub mod surrogate;
pub mod threads;
pub mod world;

pub use fmi_hazard_record::coverage::{self, Coverage};
pub use simulation::{Instant, Options, Simulation, Snapshot};
pub use world::World;

use fmi_hazard_cell::cell;
use fmi_hazard_criteria as hazard;
use fmi_hazard_human::{geometry, human, standards};
use fmi_hazard_search as search;
use fmi_hazard_stop as stop;
use fmu_host::host;

/// Nothing seen yet of this cell.
#[must_use]
pub fn nothing_seen(cell: &cell::Workcell) -> Coverage {
    Coverage::of(cell.sensors.len(), cell.controls.len(), cell.robots.iter().map(|robot| robot.name.as_str()))
}
