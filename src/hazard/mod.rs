//! What counts as unsafe, and the records of it.
//!
//! - [`cause`]: hazards that an engineer would call one flaw, under a stable id
//! - [`contact`]: force of a contact against its limit; the unsafe-state criterion U
//! - [`danger`]: danger level and reward of the paper
//! - [`finding`]: one hazardous action sequence
//! - [`group`]: findings of the same kind, under a stable id

pub mod cause;
pub mod contact;
pub mod danger;
pub mod finding;
pub mod group;

pub use contact::{Class, Contact, Criterion, Strike};
pub use finding::Finding;
pub use group::{Group, Groups, Identity};
