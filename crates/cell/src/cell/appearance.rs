//! What robots look like: the meshes that a URDF has for the eye. Only pictures are made of them; what is hit is the link's
//! shape, and a mesh that cannot be read is left out.

use std::fs::File;
use std::io::Read as _;

use super::foreign::mesh;
use super::workcell::{Look, Workcell};
use crate::geometry::Vec3;
use crate::geometry::surface::Triangles;

/// Most triangles in a report, which people mail: about 20 bytes each.
pub const MOST_TRIANGLES: usize = 10_000;

/// Most bytes of a file that is looked at: ten times what that many triangles need.
const MOST_BYTES: u64 = 8 << 20;

/// What links look like: the number of the link, and triangles in the frame of its shape, m. Meshes with fewer triangles come
/// first, as many as there may be.
#[must_use]
pub fn meshes(cell: &Workcell) -> Vec<(usize, Triangles)> {
    let looks =
        cell.links.iter().enumerate().flat_map(|(link, shown)| shown.looks.iter().map(move |look| (link, look)));
    let mut meshes: Vec<_> = looks.filter_map(|(link, look)| Some((link, triangles(look)?))).collect();
    meshes.sort_by_key(|(_, mesh)| mesh.triangles.len());
    let mut left = MOST_TRIANGLES;
    let mut fits = |mesh: &Triangles| {
        let less = left.checked_sub(mesh.triangles.len());
        left = less.unwrap_or(0);
        less.is_some()
    };
    meshes.retain(|(_, mesh)| fits(mesh));
    meshes.sort_by_key(|(link, _)| *link);
    meshes
}

fn triangles(look: &Look) -> Option<Triangles> {
    let mut bytes = Vec::new();
    let read = File::open(&look.path).ok()?.take(MOST_BYTES + 1).read_to_end(&mut bytes).ok()?;
    if read as u64 > MOST_BYTES {
        return None;
    }
    let mesh = mesh::read(&look.path, &bytes).ok()?;
    let points: Vec<Vec3> = mesh.points.iter().map(|point| look.pose * (*point * look.scale)).collect();
    Some(Triangles::merged(&points, &mesh.triangles))
}
