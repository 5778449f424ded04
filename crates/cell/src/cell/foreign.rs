//! What others wrote and a cell uses: robots, shapes and systems, in their formats.
//!
//! - `urdf`: links and joints of a robot
//! - `packages`: where the meshes are that it names
//! - `mesh`, `gltf`: triangles of STL, OBJ, COLLADA and glTF files
//! - [`ssp`]: several FMUs as a system, from SSP files
//! - `xml`: errors that point into XML files

pub(super) mod gltf;
pub(super) mod mesh;
pub(super) mod packages;
pub mod ssp;
pub(super) mod urdf;
mod xml;
