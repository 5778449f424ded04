//! What counts as unsafe, and the records of it.
//!
//! - [`contact`]: force of a contact against its limit; the unsafe-state criterion U
//! - [`danger`]: danger level and reward of the paper
//! - [`finding`]: one hazardous action sequence
//! - [`group`]: findings of the same kind, under a stable id

pub mod contact;
pub mod danger;
pub mod finding;
pub mod group;

pub use contact::{Class, Contact, Strike};
pub use finding::Finding;
pub use group::{Group, Groups, Identity};
