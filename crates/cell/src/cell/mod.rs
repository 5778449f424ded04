//! The cell: what surrounds the FMU. Robot geometry, obstacles, sensors, the person's start, and which FMU variable is
//! which.
//!
//! - [`file`](mod@file): the cell file, from its text to a [`Workcell`]
//! - [`workcell`]: the cell as it is understood, in SI units
//! - [`sensor`]: what sensors are, one file a kind
//! - [`foreign`]: robots, shapes and systems in the formats of others: URDF, meshes, SSP
//! - [`binding`]: names of the cell file to variables of the FMU, with units and types checked
//! - [`find`]: where the cell of an FMU is looked for
//! - [`draft`]: a first cell file, from what the variables of an FMU seem to be for
//! - [`design_parameter`]: what in a cell may be changed to reduce its risks
//! - [`error`]: messages that point into a file; `hash`: what tells one file from another
//!
//! `binding` and `file` do not know each other; `find` puts them together. Nothing here runs an FMU.

pub mod appearance;
pub mod binding;
pub mod design_parameter;
pub mod draft;
pub mod error;
pub mod file;
pub mod find;
pub mod following;
pub mod foreign;
mod hash;
pub mod sensor;
pub mod workcell;

pub use binding::Binding;
pub use error::CellError;
pub use hash::sha256;
pub use sensor::{DetectionZone, Sensor};
pub use workcell::{Control, Workcell};

/// Folder inside an FMU that belongs to this tool (FMI 2.0.2 and later reserve `extra/` for such use).
pub const EXTRA_FOLDER: &str = "extra/io.github.fmi-hazard";

/// The JSON Schema of the cell file (draft 2020-12), for editors.
#[must_use]
pub fn json_schema() -> serde_json::Value {
    schemars::schema_for!(file::format::CellFile).to_value()
}
