//! Mesh files: STL and OBJ, as corners for convex hulls or as triangles.
//!
//! COLLADA is not read: what its scenes say of units, axes and placements decides where a mesh is, and the reader at hand
//! leaves it out.

use std::path::Path;

use mesh_loader::Loader;

use crate::geometry::Vec3;

/// A mesh in its file's own unit and axes.
#[derive(Clone, Debug, Default, PartialEq)]
pub(in crate::cell) struct Mesh {
    /// Corners; the same place may be there several times.
    pub points: Vec<Vec3>,
    /// Indices of three corners each.
    pub triangles: Vec<[u32; 3]>,
}

/// The ending of a file's name, in lower case.
pub(in crate::cell) fn ending(path: &Path) -> String {
    path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default()
}

/// Whether files of this name can be read.
pub(in crate::cell) fn is_read(path: &Path) -> bool {
    matches!(ending(path).as_str(), "stl" | "obj")
}

/// The mesh in `bytes`. The ending of `path` says the format.
///
/// # Errors
/// Why it cannot be read.
pub(in crate::cell) fn read(path: &Path, bytes: &[u8]) -> Result<Mesh, String> {
    let loader = Loader::default();
    let scene = match ending(path).as_str() {
        "stl" => loader.load_stl_from_slice(bytes, path),
        "obj" => loader.load_obj_from_slice(bytes, path),
        other => return Err(format!("meshes of type `{other}` are not read; export it as STL or OBJ")),
    };
    let scene = scene.map_err(|error| format!("it is no mesh: {error}"))?;
    let mut all = Mesh::default();
    for mesh in &scene.meshes {
        let before = u32::try_from(all.points.len()).map_err(|_| "it is too large".to_owned())?;
        all.points.extend(mesh.vertices.iter().map(|v| Vec3::from_array(v.map(f64::from))));
        all.triangles.extend(mesh.faces.iter().map(|face| face.map(|corner| corner.saturating_add(before))));
    }
    if all.points.iter().any(|v| !v.is_finite()) {
        return Err("it has a corner that is not finite".to_owned());
    }
    Ok(all)
}
