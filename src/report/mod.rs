//! What people and pipelines read. Plain data in, text out: one file a format.
//!
//! - [`model`]: the result of a scan as it stands in `scan.json`
//! - [`terminal`]: the table on the terminal
//! - [`topview`]: an SVG of the cell from above with one hazard in it
//! - [`campaign`]: many seeds of several strategies side by side

pub mod campaign;
pub mod model;
pub mod paper;
pub mod terminal;
pub mod topview;
