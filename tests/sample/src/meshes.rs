//! Mesh files for tests.
#![expect(clippy::unwrap_used, reason = "a test fails where something is wrong")]

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

/// A GLB file of a mesh: one node with this `transform`, as JSON members.
pub fn glb(points: &[[f64; 3]], triangles: &[[u32; 3]], transform: &str) -> Vec<u8> {
    let mut bin: Vec<u8> = triangles.iter().flatten().flat_map(|corner| corner.to_le_bytes()).collect();
    let indices = bin.len();
    #[allow(clippy::cast_possible_truncation, reason = "as glTF has them")]
    bin.extend(points.iter().flatten().flat_map(|v| (*v as f32).to_le_bytes()));
    let positions = bin.len() - indices;
    let comma = if transform.is_empty() { "" } else { "," };
    let mut json = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},\"scene\":0,\"scenes\":[{{\"nodes\":[0]}}],\"nodes\":[{{\"name\":\"thing\",\
         \"mesh\":0{comma}{transform}}}],\"meshes\":[{{\"primitives\":[{{\"attributes\":{{\"POSITION\":1}},\"indices\":0,\
         \"mode\":4}}]}}],\"buffers\":[{{\"byteLength\":{}}}],\"bufferViews\":[{{\"buffer\":0,\"byteOffset\":0,\
         \"byteLength\":{indices}}},{{\"buffer\":0,\"byteOffset\":{indices},\"byteLength\":{positions}}}],\"accessors\":\
         [{{\"bufferView\":0,\"componentType\":5125,\"count\":{},\"type\":\"SCALAR\"}},{{\"bufferView\":1,\
         \"componentType\":5126,\"count\":{},\"type\":\"VEC3\",\"min\":[-9,-9,-9],\"max\":[9,9,9]}}]}}",
        bin.len(),
        3 * triangles.len(),
        points.len()
    );
    while json.len() % 4 != 0 {
        json.push(' ');
    }
    bin.resize(bin.len().next_multiple_of(4), 0);
    let mut bytes = b"glTF".to_vec();
    let number = |bytes: &mut Vec<u8>, value: usize| bytes.extend(u32::try_from(value).unwrap().to_le_bytes());
    number(&mut bytes, 2);
    number(&mut bytes, 28 + json.len() + bin.len());
    number(&mut bytes, json.len());
    bytes.extend(b"JSON");
    bytes.extend(json.as_bytes());
    number(&mut bytes, bin.len());
    bytes.extend(b"BIN\0");
    bytes.extend(bin);
    bytes
}
