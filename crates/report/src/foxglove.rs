//! The messages that Foxglove draws in its 3-D panel, as far as a replay needs them: `foxglove.SceneUpdate`, with the field
//! names and types of the schemas that Foxglove publishes. Lengths in m, world frame, z up.

use schemars::JsonSchema;
use serde::Serialize;

use crate::geometry::{Hull, Rotation, Vec3};

/// Entities to add, or to replace where the id is known.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub(crate) struct SceneUpdate {
    /// Entities to remove: none ever.
    pub deletions: Vec<Deletion>,
    /// Entities to add or replace.
    pub entities: Vec<Entity>,
}

/// An entity to remove.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub(crate) struct Deletion {
    timestamp: Time,
    #[serde(rename = "type")]
    kind: u8,
    id: String,
}

/// Time since the start.
#[derive(Clone, Copy, Debug, Default, Serialize, JsonSchema)]
pub(crate) struct Time {
    sec: u32,
    nsec: u32,
}

impl Time {
    /// From nanoseconds.
    #[must_use]
    pub(crate) fn new(nanoseconds: u64) -> Self {
        let part = |value: u64| u32::try_from(value).unwrap_or(u32::MAX);
        Self { sec: part(nanoseconds / 1_000_000_000), nsec: part(nanoseconds % 1_000_000_000) }
    }
}

/// Shapes that belong together.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub(crate) struct Entity {
    timestamp: Time,
    frame_id: &'static str,
    id: String,
    /// How long it is shown; zero: until it is replaced.
    lifetime: Time,
    frame_locked: bool,
    metadata: Vec<Pair>,
    arrows: Vec<Never>,
    cubes: Vec<Shape>,
    spheres: Vec<Shape>,
    cylinders: Vec<Cylinder>,
    lines: Vec<Line>,
    triangles: Vec<Triangles>,
    texts: Vec<Never>,
    models: Vec<Never>,
}

/// Kinds of shapes that are not used.
#[derive(Clone, Debug, Serialize, JsonSchema)]
struct Never {}

#[derive(Clone, Debug, Serialize, JsonSchema)]
struct Pair {
    key: String,
    value: String,
}

#[derive(Clone, Copy, Debug, Default, Serialize, JsonSchema)]
struct Xyz {
    x: f64,
    y: f64,
    z: f64,
}

#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
struct Quaternion {
    x: f64,
    y: f64,
    z: f64,
    w: f64,
}

#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
struct Pose {
    position: Xyz,
    orientation: Quaternion,
}

/// Red, green, blue and opacity, 0 to 1.
#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
pub(crate) struct Color {
    r: f64,
    g: f64,
    b: f64,
    a: f64,
}

#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
struct Shape {
    pose: Pose,
    size: Xyz,
    color: Color,
}

#[derive(Clone, Copy, Debug, Serialize, JsonSchema)]
struct Cylinder {
    pose: Pose,
    size: Xyz,
    bottom_scale: f64,
    top_scale: f64,
    color: Color,
}

#[derive(Clone, Debug, Serialize, JsonSchema)]
struct Line {
    /// 1: a closed line.
    #[serde(rename = "type")]
    kind: u8,
    pose: Pose,
    thickness: f64,
    scale_invariant: bool,
    points: Vec<Xyz>,
    color: Color,
    colors: Vec<Color>,
    indices: Vec<u32>,
}

#[derive(Clone, Debug, Serialize, JsonSchema)]
struct Triangles {
    pose: Pose,
    points: Vec<Xyz>,
    color: Color,
    colors: Vec<Color>,
    indices: Vec<u32>,
}

impl Color {
    /// An opaque colour from its hexadecimal digits.
    #[must_use]
    pub(crate) fn hex(rgb: u32) -> Self {
        let part = |shift: u32| f64::from((rgb >> shift) & 0xff) / 255.0;
        Self { r: part(16), g: part(8), b: part(0), a: 1.0 }
    }

    /// The same, to be looked through.
    #[must_use]
    pub(crate) const fn faint(self) -> Self {
        Self { a: 0.35, ..self }
    }
}

impl Entity {
    /// Without shapes, shown from `nanoseconds` on.
    #[must_use]
    pub(crate) fn new(id: String, nanoseconds: u64) -> Self {
        Self { timestamp: Time::new(nanoseconds), frame_id: "world", id, ..Self::default() }
    }

    /// A box of edges `size`.
    pub(crate) fn cuboid(&mut self, centre: Vec3, rotation: Rotation, size: Vec3, color: Color) {
        self.cubes.push(Shape { pose: pose(centre, rotation), size: xyz(size), color });
    }

    /// A ball.
    pub(crate) fn ball(&mut self, centre: Vec3, radius: f64, color: Color) {
        let size = xyz(Vec3::splat(2.0 * radius));
        self.spheres.push(Shape { pose: pose(centre, Rotation::IDENTITY), size, color });
    }

    /// A capsule: a cylinder along z, turned, and a ball at each end.
    pub(crate) fn capsule(&mut self, a: Vec3, b: Vec3, radius: f64, color: Color) {
        self.ball(a, radius, color);
        if let Some(along) = (b - a).try_normalize() {
            self.ball(b, radius, color);
            let size = Xyz { x: 2.0 * radius, y: 2.0 * radius, z: (b - a).length() };
            let pose = pose((a + b) * 0.5, Rotation::from_rotation_arc(Vec3::Z, along));
            self.cylinders.push(Cylinder { pose, size, bottom_scale: 1.0, top_scale: 1.0, color });
        }
    }

    /// A convex hull of points in its own frame; nothing if they are flat.
    pub(crate) fn hull(&mut self, points: &[Vec3], translation: Vec3, rotation: Rotation, color: Color) {
        let Some(hull) = Hull::from_points(points) else { return };
        let (points, triangles) = hull.shape().to_trimesh();
        self.mesh(&points, &triangles, translation, rotation, color);
    }

    /// Triangles between points in their own frame.
    pub(crate) fn mesh(
        &mut self,
        points: &[Vec3],
        triangles: &[[u32; 3]],
        translation: Vec3,
        rotation: Rotation,
        color: Color,
    ) {
        self.triangles.push(Triangles {
            pose: pose(translation, rotation),
            points: points.iter().copied().map(xyz).collect(),
            color,
            colors: Vec::new(),
            indices: triangles.iter().flatten().copied().collect(),
        });
    }

    /// A closed line.
    pub(crate) fn outline(&mut self, points: impl Iterator<Item = Vec3>, color: Color) {
        self.lines.push(Line {
            kind: 1,
            pose: pose(Vec3::ZERO, Rotation::IDENTITY),
            thickness: 0.02,
            scale_invariant: false,
            points: points.map(xyz).collect(),
            color,
            colors: Vec::new(),
            indices: Vec::new(),
        });
    }
}

const fn xyz(v: Vec3) -> Xyz {
    Xyz { x: v.x, y: v.y, z: v.z }
}

fn pose(translation: Vec3, rotation: Rotation) -> Pose {
    let [x, y, z, w] = rotation.to_array();
    Pose { position: xyz(translation), orientation: Quaternion { x, y, z, w } }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_capsule_is_a_cylinder_turned_from_z_to_its_axis() {
        let mut entity = Entity::new("arm".to_owned(), 1_020_000_000);
        entity.capsule(Vec3::new(1.0, 0.0, 0.5), Vec3::new(3.0, 0.0, 0.5), 0.1, Color::hex(0xff_80_00));
        let json = serde_json::to_value(&entity).unwrap_or_default();
        assert_eq!(json["timestamp"], serde_json::json!({ "sec": 1, "nsec": 20_000_000 }));
        let cylinder = &json["cylinders"][0];
        assert_eq!(cylinder["pose"]["position"], serde_json::json!({ "x": 2.0, "y": 0.0, "z": 0.5 }));
        assert_eq!(cylinder["size"]["z"], 2.0);
        // z turned to x: a quarter turn about y.
        let half = std::f64::consts::FRAC_1_SQRT_2;
        for (axis, expected) in [("x", 0.0), ("y", half), ("z", 0.0), ("w", half)] {
            let value = cylinder["pose"]["orientation"][axis].as_f64().unwrap_or(f64::NAN);
            assert!((value - expected).abs() < 1e-12, "{axis}: {value}");
        }
        assert_eq!(json["spheres"].as_array().map(Vec::len), Some(2));
        assert_eq!(json["spheres"][0]["color"]["g"], 128.0 / 255.0);
    }
}
