//! What the simulation reads from the outputs of one step: linear combinations, orientations, and differences of two
//! steps where the FMU gives no speed.

use super::MotionBinding;
use crate::geometry::{Matrix3, Rotation, Vec3};

/// How a part is turned, in the base frame.
#[derive(Clone, Debug, PartialEq)]
pub enum Orientation {
    /// Not known: the part is a point.
    Unknown,
    /// Quaternion w, x, y, z.
    Quaternion(Box<[Reader; 4]>),
    /// Rotation matrix, row by row.
    Matrix(Box<[[Reader; 3]; 3]>),
}

impl Orientation {
    /// `base_from_frame` in one row of outputs.
    #[must_use]
    pub fn read(&self, outputs: &[f64]) -> Rotation {
        match self {
            Self::Unknown => Rotation::IDENTITY,
            Self::Quaternion(readers) => {
                let [w, x, y, z] = readers.each_ref().map(|r| r.read(outputs));
                Rotation::from_xyzw(x, y, z, w).normalize()
            }
            Self::Matrix(readers) => {
                let rows = readers.each_ref().map(|row| row.each_ref().map(|r| r.read(outputs)));
                from_matrix(rows).normalize()
            }
        }
    }
}

/// What is worked out from outputs of two steps one after the other: their backward difference, so the mean over the step.
#[derive(Clone, Debug, PartialEq)]
pub enum Derived {
    /// Change of a value per second.
    Rate {
        /// The value.
        of: Reader,
        /// Whether it is an angle, which may jump by full turns.
        turns: bool,
    },
    /// Angular velocity x, y, z of what is turned so.
    Turning {
        /// How it is turned.
        of: Orientation,
    },
}

impl Derived {
    /// How many columns it has.
    pub(super) const fn columns(&self) -> usize {
        match self {
            Self::Rate { .. } => 1,
            Self::Turning { .. } => 3,
        }
    }

    pub(super) fn append(&self, now: &[f64], before: &[f64], step_s: f64, to: &mut Vec<f64>) {
        match self {
            Self::Rate { of, turns } => {
                let change = of.read(now) - of.read(before);
                let whole = if *turns { (change / std::f64::consts::TAU).round() } else { 0.0 };
                to.push((change - whole * std::f64::consts::TAU) / step_s);
            }
            Self::Turning { of } => {
                let turned = of.read(now) * of.read(before).inverse();
                // The shorter way: a quaternion and its negative are one rotation.
                let sign = if turned.w < 0.0 { -1.0 } else { 1.0 };
                let vector = Vec3::new(turned.x, turned.y, turned.z) * sign;
                let sin = vector.length();
                let angle = 2.0 * libm::atan2(sin, turned.w * sign);
                let per_s = if sin > 0.0 { angle / (sin * step_s) } else { 0.0 };
                to.extend((vector * per_s).to_array());
            }
        }
    }
}

/// The rotation of a matrix, given row by row.
pub(super) fn from_matrix(rows: [[f64; 3]; 3]) -> Rotation {
    Rotation::from_mat3(&Matrix3::from_cols_array_2d(&rows).transpose())
}

/// A linear combination of bound outputs: `offset + sum(factor * output)`, SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reader {
    pub(super) terms: Vec<(usize, f64)>,
    pub(super) offset: f64,
}

/// In a term: the column is counted from the first that is derived.
pub(super) const DERIVED: usize = 1 << 32;

impl MotionBinding {
    /// Every reader.
    pub(super) fn readers(&mut self) -> Vec<&mut Reader> {
        match self {
            Self::Joints { positions, speeds } => positions.iter_mut().chain(speeds).collect(),
            Self::Frames(frames) => {
                frames.iter_mut().flat_map(|f| f.velocity.iter_mut().chain(&mut f.angular_velocity)).collect()
            }
        }
    }

    /// Puts what is derived behind so many outputs.
    pub(super) fn settle(&mut self, outputs: usize) {
        for (column, _) in self.readers().into_iter().flat_map(|reader| &mut reader.terms) {
            if *column >= DERIVED {
                *column = *column - DERIVED + outputs;
            }
        }
    }
}

impl Reader {
    /// The value of a column that is derived.
    pub(super) fn derived(column: usize) -> Self {
        Self { terms: vec![(DERIVED + column, 1.0)], offset: 0.0 }
    }

    /// The value in one row of outputs.
    #[must_use]
    pub fn read(&self, outputs: &[f64]) -> f64 {
        self.terms.iter().fold(self.offset, |sum, &(i, factor)| sum + factor * outputs[i])
    }
}
