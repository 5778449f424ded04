//! The paper's transition function: plant, person, sensors and contacts joined into one [`Environment`].
//!
//! - [`robot`]: the robot at one instant, from the FMU's outputs
//! - [`sensors`]: what the sensors report while the person walks
//! - [`encounter`]: person against robot at one instant: contact, danger
//! - [`clamping`]: what keeps a part of the body from giving way
//! - [`world`]: what follows without the FMU: walking, sensing, touching
//! - [`curtain`]: reaching through a light curtain, and when
//! - [`expansion`]: all actions from many states at once, on all cores
//! - `threads`: independent work on all of them, for that
//! - [`journal`]: what such a search has worked out, on disk
//! - [`answers`]: the same of several machines that share one search out
//! - [`bound`]: how far robots and person can come at all
//! - [`simulation`]: one action after the other, with snapshots of *everything*
//! - [`between`]: where they may be in a part of a communication step
//! - `befallen`: what befalls people in one action
//! - `behind`: what comes behind the first hazard by contact
//! - [`imagination`]: what a sequence would lead to if the robots moved as they were seen to
//! - [`coverage`]: what a run has seen, so that "no hazard" is never empty
//! - [`motion`]: whether the speeds that the FMU tells are those at which it moves
//! - [`replay`]: one sequence from a fresh instance, with no restore
//!
//! [`Environment`]: crate::search::Environment

pub(crate) mod answers;
pub mod anywhere;
mod befallen;
mod behind;
pub(crate) mod between;
pub(crate) mod bound;
pub(crate) mod clamping;
pub(crate) mod coverage;
pub mod curtain;
pub mod encounter;
pub mod expansion;
mod going;
pub(crate) mod imagination;
pub(crate) mod journal;
pub mod motion;
pub mod replay;
pub mod robot;
mod robots;
pub mod sensors;
pub(crate) mod simulation;
mod threads;
pub mod world;

pub use coverage::Coverage;
pub use simulation::{Instant, Options, Simulation, Snapshot};
pub use world::World;
