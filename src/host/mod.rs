//! Where an FMU runs, and how its state is brought back.
//!
//! - [`plant`]: the trait between the simulation and a running FMU; one action, one message
//! - [`port`]: bound variables
//! - [`in_process`]: an FMU in this process
//! - [`system`]: one FMU or several coupled ones
//! - [`recall`]: states by input history and the ladder of ways back to them
//! - [`selftest`]: what an FMU's promises about its state are worth

pub mod in_process;
pub mod plant;
pub mod port;
pub mod recall;
pub mod selftest;
pub mod system;

pub use plant::{Plant, PlantError};
pub use recall::{Advanced, NodeId, Policy, Recall};
pub use system::{System, SystemSetup, UnitPort};
