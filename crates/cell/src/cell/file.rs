//! The cell file: as written, and from there to a [`Workcell`](super::Workcell).
//!
//! - [`mod@format`]: the TOML file as written
//! - [`extended`]: the files that it extends; [`layers`]: its tables laid over theirs
//! - [`reading`]: its text to tables, past what does not fit
//! - [`validate`]: these to a checked cell, every mistake with its line
//! - `checker`: what those share that check a part; `robots`, `inertias`, `sensors`, `obstacles`, `starts`, `limits`:
//!   the parts
//! - [`accepted`]: what it accepts of an FMU
//! - [`described`]: robots from a URDF
//! - [`files`]: what a cell file names, read once and hashed

pub mod accepted;
mod checker;
mod controls;
mod criteria;
pub mod described;
pub(crate) mod extended;
pub mod files;
mod following;
pub mod format;
mod inertias;
pub mod layers;
mod limits;
mod obstacles;
mod people;
mod plausible;
pub(crate) mod reading;
mod robots;
mod sensors;
mod starts;
pub mod validate;

pub(super) use sensors::signal;
