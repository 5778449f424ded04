//! What counts as unsafe: contacts against their limits, and which hazards are the same.
//!
//! - [`cause`]: hazards that an engineer would call one flaw, under a stable id
//! - [`contact`]: a contact against its limits; the unsafe-state criterion U
//! - [`criterion`]: what may count as unsafe, as the cell chooses
//! - [`danger`]: danger level and reward of the paper
//! - [`finding`]: one hazardous action sequence
//! - [`group`]: findings of the same kind, under a stable id
//! - `part`: what of a person is hit
//! - [`place`]: the floor in squares
//! - [`strike`]: how hard a robot strikes at one instant

pub mod cause;
pub mod contact;
pub mod criterion;
pub mod danger;
pub mod finding;
pub mod group;
mod part;
pub mod place;
pub mod strike;

pub use contact::Contact;
pub use criterion::{Class, Criteria, Criterion};
pub use finding::Finding;
pub use group::{Group, Groups, Identity};
pub use part::BodyOrArm;
pub use strike::{STANDSTILL_M_S, Strike};

use fmi_hazard_human::{geometry, human, standards};
