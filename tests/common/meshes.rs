//! Mesh files for tests.

use std::fmt::Write as _;

/// A box from `low` to `high` as corners and triangles that are turned outwards.
pub fn cuboid(low: [f64; 3], high: [f64; 3]) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let corner = |n: usize| [0, 1, 2].map(|axis| if n >> axis & 1 == 0 { low[axis] } else { high[axis] });
    let quads = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]];
    let triangles = quads.iter().flat_map(|[a, b, c, d]| [[*a, *b, *c], [*a, *c, *d]]).collect();
    ((0..8).map(corner).collect(), triangles)
}

/// A polygon in the plane of x and z, pulled from y = 0 to `depth`; `caps` are triangles of its corners, anticlockwise as
/// seen with x to the right and z up. The corners are in that order, too.
pub fn prism(polygon: &[[f64; 2]], caps: &[[u32; 3]], depth: f64) -> (Vec<[f64; 3]>, Vec<[u32; 3]>) {
    let n = u32::try_from(polygon.len()).unwrap();
    let points = [0.0, depth].iter().flat_map(|y| polygon.iter().map(move |[x, z]| [*x, *y, *z])).collect();
    let mut triangles: Vec<[u32; 3]> = caps.to_vec();
    triangles.extend(caps.iter().map(|[a, b, c]| [n + a, n + c, n + b]));
    for i in 0..n {
        let j = (i + 1) % n;
        triangles.extend([[i, n + i, n + j], [i, n + j, j]]);
    }
    (points, triangles)
}

/// As the text of an STL file: every triangle with corners of its own.
pub fn stl(points: &[[f64; 3]], triangles: &[[u32; 3]]) -> String {
    let mut text = String::from("solid s\n");
    for triangle in triangles {
        text.push_str("facet normal 0 0 0\nouter loop\n");
        for [x, y, z] in triangle.map(|corner| points[corner as usize]) {
            writeln!(text, "vertex {x} {y} {z}").unwrap();
        }
        text.push_str("endloop\nendfacet\n");
    }
    text + "endsolid s\n"
}
