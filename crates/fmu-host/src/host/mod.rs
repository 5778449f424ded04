//! Where an FMU runs, and how its state is brought back.
//!
//! - [`plant`]: the trait between the simulation and a running FMU; one action, one message
//! - [`hosted`]: FMUs, wherever they run
//! - [`port`]: bound variables
//! - [`in_process`]: an FMU in this process
//! - [`isolation`]: FMUs in a process of their own
//! - [`activity`]: what a plant is doing just now
//! - [`system`]: one FMU or several coupled ones
//! - [`recall`]: states by input history and the ladder of ways back to them
//! - [`audit`]: what was stepped from states, run once more from the start
//! - [`selftest`]: what an FMU's promises about its state are worth

pub mod activity;
pub mod audit;
pub(crate) mod hosted;
pub(crate) mod in_process;
pub mod isolation;
pub(crate) mod plant;
pub mod port;
pub(crate) mod recall;
mod rounding;
pub mod selftest;
pub mod system;

pub use hosted::Hosted;
pub use plant::{Arrived, Leg, LegStart, Plant, PlantError, Reads, StateCopy, Then, Unlike, for_all_steps};
pub use recall::{Advanced, FmuUsage, NodeId, Policy, Recall};
pub use system::{System, SystemSetup, UnitPort};
