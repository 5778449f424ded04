//! The numbers that other people measured or agreed on, each in one place with its clause: contact limits
//! (ISO/TS 15066), performance levels (ISO 13849-1), least gaps (ISO 13854), approach speeds and separation distances (ISO 13855), arm
//! lengths (ISO 13857) and body measures (ANSUR II).
//!
//! Data and formulas, no state; knows nothing of the floors above. One file a standard. No purchased standard text was
//! available when the tables were compiled, so every one of them is registered as unverified in [`tables`], and
//! reports print that.

pub mod anthropometry;
pub mod body_area;
pub(crate) mod body_region;
pub mod iso_13849;
pub mod iso_13854;
pub mod iso_13855;
#[cfg(test)]
mod iso_13855_tests;
pub(crate) mod iso_13857;
pub mod iso_ts_15066;
pub mod provenance;
pub mod tables;

pub use body_area::BodyArea;
pub use body_region::BodyRegion;
