//! glTF 2.0 and GLB: the triangles of a scene in its own frame, metres and y up, each primitive of each node a part.
//!
//! Offsets and counts are read with care: a file may say anything.

use base64::Engine as _;
use base64::engine::general_purpose::STANDARD;
use gltf::accessor::{DataType, Dimensions};
use gltf::buffer::Source;
use gltf::mesh::Mode;
use gltf::scene::Transform;
use gltf::{Accessor, Gltf, Node, Semantic};
use percent_encoding::percent_decode_str;

use super::mesh::Mesh;
use crate::geometry::{Matrix3, Rotation, Vec3};

/// Where something of a node is in the scene.
#[derive(Clone, Copy)]
struct NodePose {
    linear: Matrix3,
    offset: Vec3,
}

impl NodePose {
    fn then(self, child: Self) -> Self {
        Self { linear: self.linear * child.linear, offset: self.linear * child.offset + self.offset }
    }

    fn of(transform: &Transform) -> Self {
        let vector = |[x, y, z]: [f32; 3]| Vec3::new(x.into(), y.into(), z.into());
        match *transform {
            Transform::Matrix { matrix } => {
                let [x, y, z, offset] = matrix.map(|[x, y, z, _]| vector([x, y, z]));
                Self { linear: Matrix3::from_cols(x, y, z), offset }
            }
            Transform::Decomposed { translation, rotation, scale } => {
                let [x, y, z, w] = rotation.map(f64::from);
                let length = (x * x + y * y + z * z + w * w).sqrt();
                let turned = match length > 0.0 {
                    true => Matrix3::from_quat(Rotation::from_xyzw(x / length, y / length, z / length, w / length)),
                    false => Matrix3::IDENTITY,
                };
                let scale = vector(scale);
                let linear =
                    Matrix3::from_cols(turned.x_axis * scale.x, turned.y_axis * scale.y, turned.z_axis * scale.z);
                Self { linear, offset: vector(translation) }
            }
        }
    }
}

/// Named parts of the scene in `bytes`; `beside` reads a file that it names.
///
/// # Errors
/// Why it cannot be read.
pub(in crate::cell) fn read(
    bytes: &[u8],
    beside: &dyn Fn(&str) -> Result<Vec<u8>, String>,
) -> Result<Vec<(String, Mesh)>, String> {
    let mut gltf = Gltf::from_slice_without_validation(bytes).map_err(|error| format!("it is no glTF: {error}"))?;
    let json = gltf.document.as_json();
    if !json.extensions_required.is_empty() {
        let all = json.extensions_required.join(", ");
        return Err(format!("it needs extensions of glTF that are not read ({all}); export it without compression"));
    }
    // The library's own checks look these up before they check them.
    let mut attributes =
        json.meshes.iter().flat_map(|mesh| &mesh.primitives).flat_map(|primitive| primitive.attributes.values());
    if attributes.any(|accessor| accessor.value() >= json.accessors.len()) {
        return Err("it is no valid glTF: it names an accessor that is not there".to_owned());
    }
    gltf = Gltf::from_slice(bytes).map_err(|error| format!("it is no valid glTF: {error}"))?;
    let buffers = gltf.document.buffers().map(|buffer| match buffer.source() {
        Source::Bin => gltf.blob.clone().ok_or_else(|| "its binary part is missing".to_owned()),
        Source::Uri(uri) => match uri.strip_prefix("data:") {
            Some(data) => {
                let (_, data) = data.split_once(";base64,").ok_or("it holds data that are not base64")?;
                STANDARD.decode(data).map_err(|error| format!("it holds data that are no base64: {error}"))
            }
            None if uri.contains("://") => Err(format!("it names {uri}, which is not fetched; put the file beside it")),
            None => beside(&percent_decode_str(uri).decode_utf8_lossy()),
        },
    });
    let buffers: Vec<Vec<u8>> = buffers.collect::<Result<_, _>>()?;
    let scene = gltf.document.default_scene().or_else(|| gltf.document.scenes().next());
    let roots: Vec<Node<'_>> = match &scene {
        Some(scene) => scene.nodes().collect(),
        None => return Err("it has no scene; export one".to_owned()),
    };
    let still = NodePose { linear: Matrix3::IDENTITY, offset: Vec3::ZERO };
    let mut open: Vec<(Node<'_>, NodePose)> = roots.into_iter().rev().map(|node| (node, still)).collect();
    let mut known = vec![false; gltf.document.nodes().len()];
    let mut parts = Vec::new();
    while let Some((node, parent)) = open.pop() {
        let name = node.name().map_or_else(|| format!("node {}", node.index()), |name| format!("`{name}`"));
        match known.get_mut(node.index()) {
            Some(seen) if !*seen => *seen = true,
            _ => return Err(format!("{name} is in the scene twice: nodes of glTF are trees")),
        }
        let place = parent.then(NodePose::of(&node.transform()));
        for primitive in node.mesh().into_iter().flat_map(|mesh| mesh.primitives()) {
            if primitive.mode() != Mode::Triangles {
                return Err(format!("{name} has {:?}; only triangles are read", primitive.mode()));
            }
            let positions = primitive.get(&Semantic::Positions).ok_or_else(|| format!("{name} has no positions"))?;
            let told = |error: String| format!("{name}: {error}");
            let points = points(&positions, &buffers).map_err(told)?;
            let corners: Vec<u32> = match primitive.indices() {
                Some(indices) => indices_of(&indices, &buffers).map_err(told)?,
                None => (0u32..).take(points.len()).collect(),
            };
            let points: Vec<Vec3> = points.into_iter().map(|point| place.linear * point + place.offset).collect();
            if points.iter().any(|point| !point.is_finite()) {
                return Err(format!("{name} has a corner that is not finite"));
            }
            // What is mirrored is inside out.
            let mirrored = place.linear.determinant() < 0.0;
            let (whole, _) = corners.as_chunks::<3>();
            let turned = |[a, b, c]: &[u32; 3]| if mirrored { [*a, *c, *b] } else { [*a, *b, *c] };
            parts.push((name.clone(), Mesh { points, triangles: whole.iter().map(turned).collect() }));
        }
        let children: Vec<Node<'_>> = node.children().collect();
        open.extend(children.into_iter().rev().map(|child| (child, place)));
    }
    Ok(parts)
}

/// The elements of an accessor, `N` bytes each.
fn elements<'a, const N: usize>(accessor: &Accessor<'_>, buffers: &'a [Vec<u8>]) -> Result<Vec<&'a [u8; N]>, String> {
    if accessor.sparse().is_some() {
        return Err("sparse accessors are not read; export it without them".to_owned());
    }
    let view = accessor.view().ok_or("its data are missing")?;
    let missing = || "its data end too early".to_owned();
    let buffer = buffers.get(view.buffer().index()).ok_or_else(missing)?;
    let bytes = view.offset().checked_add(view.length()).and_then(|end| buffer.get(view.offset()..end));
    let bytes = bytes.ok_or_else(missing)?;
    let stride = view.stride().unwrap_or(N);
    let mut elements = Vec::new();
    for number in 0..accessor.count() {
        let from = stride.checked_mul(number).and_then(|at| at.checked_add(accessor.offset()));
        let rest = from.and_then(|from| bytes.get(from..)).ok_or_else(missing)?;
        elements.push(rest.first_chunk().ok_or_else(missing)?);
    }
    Ok(elements)
}

fn points(accessor: &Accessor<'_>, buffers: &[Vec<u8>]) -> Result<Vec<Vec3>, String> {
    if (accessor.data_type(), accessor.dimensions()) != (DataType::F32, Dimensions::Vec3) {
        return Err("its positions are not three 32-bit floating-point numbers each".to_owned());
    }
    let number = |bytes: &[u8; 12], at: usize| {
        let four = [bytes[at], bytes[at + 1], bytes[at + 2], bytes[at + 3]];
        f64::from(f32::from_le_bytes(four))
    };
    let elements = elements::<12>(accessor, buffers)?;
    Ok(elements.into_iter().map(|bytes| Vec3::new(number(bytes, 0), number(bytes, 4), number(bytes, 8))).collect())
}

fn indices_of(accessor: &Accessor<'_>, buffers: &[Vec<u8>]) -> Result<Vec<u32>, String> {
    match (accessor.data_type(), accessor.dimensions()) {
        (DataType::U8, Dimensions::Scalar) => {
            Ok(elements::<1>(accessor, buffers)?.into_iter().map(|[one]| u32::from(*one)).collect())
        }
        (DataType::U16, Dimensions::Scalar) => {
            Ok(elements::<2>(accessor, buffers)?.into_iter().map(|two| u32::from(u16::from_le_bytes(*two))).collect())
        }
        (DataType::U32, Dimensions::Scalar) => {
            Ok(elements::<4>(accessor, buffers)?.into_iter().map(|four| u32::from_le_bytes(*four)).collect())
        }
        _ => Err("its indices are no whole numbers".to_owned()),
    }
}
