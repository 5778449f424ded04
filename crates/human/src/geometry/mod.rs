//! Shapes, rigid transforms and distances, in metres and radians, f64 throughout (parry's f32 distance was seen to
//! over-estimate by up to 10.7 mm, the unsafe side).
//!
//! Vectors and rotations are parry's own types (glam underneath), so that parry can be called without conversion;
//! nalgebra is used only for joint-space algebra, converted at that one seam. Transforms are named `a_from_b`.
//!
//! - [`shape`]: capsules and boxes; [`distance`], [`segment_cuboid`], [`triangle`], [`polygon`]: closed forms for them
//! - [`solid`]: a robot link where it stands: a capsule, a [`hull`] or a [`mesh`], which is a closed [`surface`]
//! - [`boxes`]: a surface as boxes that lie in it, for obstacles; [`joined`]: walls that adjoin
//! - [`kinematics`]: where links are, and how fast; [`inertia`]: how heavy, for whoever is hit by a point of them
//! - [`sampled`]: the surface of a link as points; [`samples`]: such points, kept

pub mod boxes;
mod coarse;
pub mod coordinates;
pub mod distance;
mod facing;
pub(crate) mod hull;
pub mod inertia;
pub mod joined;
pub mod kinematics;
pub(crate) mod mesh;
pub mod polygon;
mod polyhedron;
pub mod sampled;
pub mod samples;
pub mod segment_cuboid;
pub(crate) mod shape;
mod slabs;
mod slices;
pub(crate) mod solid;
pub mod surface;
pub(crate) mod triangle;

#[cfg(test)]
pub(crate) use fmi_hazard_sample::meshes as test_meshes;

pub use distance::Closest;
pub use hull::Hull;
pub use inertia::{Inertia, Masses};
pub use mesh::Mesh;
pub use parry3d_f64::math::{Matrix as Matrix3, Pose, Rotation, Vector as Vec3};
pub use shape::{Capsule, Cuboid};
pub use solid::Solid;
pub use surface::Surface;

/// Rotation by `angle` radians about the unit vector `axis` (right-hand rule), with `libm` trigonometry so that the
/// bits do not depend on the machine.
#[must_use]
pub fn rotation_about(axis: Vec3, angle: f64) -> Rotation {
    let (s, c) = libm::sincos(0.5 * angle);
    Rotation::from_xyzw(axis.x * s, axis.y * s, axis.z * s, c)
}

/// Rotation for roll, pitch, yaw in radians about the fixed x, y and z axes (the URDF convention).
#[must_use]
pub fn roll_pitch_yaw([roll, pitch, yaw]: [f64; 3]) -> Rotation {
    rotation_about(Vec3::Z, yaw) * rotation_about(Vec3::Y, pitch) * rotation_about(Vec3::X, roll)
}
