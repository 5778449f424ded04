//! The corners of mesh files, for convex hulls: STL and OBJ.
//!
//! COLLADA is not read: what its scenes say of units, axes and placements decides where a mesh is, and the reader at hand
//! leaves it out.

use std::path::Path;

use mesh_loader::Loader;

use crate::geometry::Vec3;

/// The vertices of the mesh in `bytes`, in the file's own unit and axes. The ending of `path` says the format.
///
/// # Errors
/// Why it cannot be read.
pub(super) fn vertices(path: &Path, bytes: &[u8]) -> Result<Vec<Vec3>, String> {
    let loader = Loader::default();
    let ending = path.extension().map(|e| e.to_string_lossy().to_ascii_lowercase()).unwrap_or_default();
    let scene = match ending.as_str() {
        "stl" => loader.load_stl_from_slice(bytes, path),
        "obj" => loader.load_obj_from_slice(bytes, path),
        other => return Err(format!("meshes of type `{other}` are not read; export it as STL or OBJ")),
    };
    let scene = scene.map_err(|error| format!("it is no mesh: {error}"))?;
    let corner = |v: &[f32; 3]| Vec3::from_array(v.map(f64::from));
    let all: Vec<Vec3> = scene.meshes.iter().flat_map(|mesh| mesh.vertices.iter().map(corner)).collect();
    if all.iter().any(|v| !v.is_finite()) {
        return Err("it has a corner that is not finite".to_owned());
    }
    Ok(all)
}
