//! The cell: what surrounds the FMU. Robot geometry, obstacles, sensors, the person's start, and which FMU variable is
//! which.
//!
//! - [`mod@format`]: the TOML file as written
//! - [`validate`]: from the file to a [`Workcell`] in SI units, every mistake with its line
//! - [`binding`]: names of the cell file to variables of the FMU, with units and types checked
//! - [`find`]: where the cell of an FMU is looked for
//! - [`roles`]: what the variables of an FMU seem to be for
//! - [`interface`]: the variables of an FMU or a system by the names that cell files use, with their roles
//! - [`draft`]: a first cell file, from that
//! - [`knob`]: what in a cell can be turned to make it safer
//! - [`ssp`]: several FMUs as a system, from SSP files
//! - `robots`, `sensors`, `obstacles`: the parts of `validate` that check those
//! - [`described`]: robots from a URDF; below it `urdf` reads the file, `mesh` and `gltf` the shapes
//! - [`files`]: what a cell file names, read once and hashed; `xml`: errors that point into XML files
//! - [`error`]: messages that point into the file
//!
//! `binding` and `validate` do not know each other; `find` puts them together. Nothing here runs an FMU.

pub mod binding;
pub mod described;
pub mod draft;
pub mod error;
pub mod files;
pub mod find;
pub mod format;
mod gltf;
pub mod interface;
pub mod knob;
mod mesh;
mod obstacles;
mod robots;
pub mod roles;
mod sensors;
pub mod ssp;
mod urdf;
pub mod validate;
mod xml;

pub use binding::Binding;
pub use error::CellError;
pub use validate::{Sensor, Workcell, Zone};

/// Folder inside an FMU that belongs to this tool (FMI 2.0.2 and later reserve `extra/` for such use).
pub const EXTRA_FOLDER: &str = "extra/io.github.fmi-hazard";

/// The JSON Schema of the cell file (draft 2020-12), for editors.
#[must_use]
pub fn json_schema() -> serde_json::Value {
    schemars::schema_for!(format::CellFile).to_value()
}
