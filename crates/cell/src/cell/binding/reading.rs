//! What the simulation reads from the outputs of one step: linear combinations, orientations, and differences of two
//! steps where the FMU gives no speed.

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
    /// What it is read by.
    pub(crate) fn readers(&self) -> impl Iterator<Item = &Reader> {
        let (quaternion, matrix) = match self {
            Self::Unknown => (None, None),
            Self::Quaternion(readers) => (Some(readers.iter()), None),
            Self::Matrix(rows) => (None, Some(rows.iter().flatten())),
        };
        quaternion.into_iter().flatten().chain(matrix.into_iter().flatten())
    }

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

/// No joint and no link of a robot changes its speed faster, rad/s^2 or m/s^2: what does has not moved there, it was put
/// there.
pub const HARDEST: f64 = 100.0;

/// Whether a value has jumped: its mean speed over a step is not what the means over the next two steps lead to, backwards,
/// nor within reach of them for any robot.
#[must_use]
pub fn jumps(first: f64, next: [f64; 2], step_s: f64) -> bool {
    let (low, high) = (next[0].min(next[1]), next[0].max(next[1]));
    let reach = 2.0 * (high - low) + HARDEST * step_s;
    first < low - reach || first > high + reach
}

impl Derived {
    /// How many columns it has.
    pub(super) const fn columns(&self) -> usize {
        match self {
            Self::Rate { .. } => 1,
            Self::Turning { .. } => 3,
        }
    }

    /// Its columns in a row, from the outputs of this step and of one before, `step_s` seconds earlier.
    pub fn append(&self, now: &[f64], before: &[f64], step_s: f64, to: &mut Vec<f64>) {
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
fn from_matrix(rows: [[f64; 3]; 3]) -> Rotation {
    Rotation::from_mat3(&Matrix3::from_cols_array_2d(&rows).transpose())
}

/// A number in a row: an output, or what is derived from outputs. The latter stand behind the outputs and are counted from the
/// end of the row, so that outputs may still be added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Column {
    Output(usize),
    Derived(usize),
}

/// A linear combination of bound outputs: `offset + sum(factor * output)`, SI.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Reader {
    pub(super) terms: Vec<(Column, f64)>,
    pub(super) offset: f64,
}

impl Reader {
    /// The value of a column that is derived.
    pub(super) fn derived(column: usize) -> Self {
        Self { terms: vec![(Column::Derived(column), 1.0)], offset: 0.0 }
    }

    /// The value of an output, times a factor.
    #[must_use]
    pub fn output(column: usize, factor: f64) -> Self {
        Self { terms: vec![(Column::Output(column), factor)], offset: 0.0 }
    }

    /// A value that never changes.
    pub(super) const fn constant(offset: f64) -> Self {
        Self { terms: Vec::new(), offset }
    }

    /// Whether it reads anything that may change.
    #[must_use]
    pub const fn varies(&self) -> bool {
        !self.terms.is_empty()
    }

    /// The outputs that it reads, by their columns, where it reads nothing that is derived.
    #[must_use]
    pub fn given(&self) -> Option<Vec<usize>> {
        let output = |(column, _): &(Column, f64)| match *column {
            Column::Output(column) => Some(column),
            Column::Derived(_) => None,
        };
        self.terms.iter().map(output).collect()
    }

    /// The outputs that it reads itself, by their columns.
    pub(crate) fn outputs(&self) -> impl Iterator<Item = usize> + '_ {
        self.terms.iter().filter_map(|(column, _)| match *column {
            Column::Output(column) => Some(column),
            Column::Derived(_) => None,
        })
    }

    /// By what its output is multiplied and what is added then, where it reads one.
    #[must_use]
    pub fn of_one(&self) -> Option<(f64, f64)> {
        match self.terms[..] {
            [(Column::Output(_), factor)] => Some((factor, self.offset)),
            _ => None,
        }
    }

    /// The value in one row of outputs, with what is derived from them.
    #[must_use]
    pub fn read(&self, row: &[f64]) -> f64 {
        let value = |column: &Column| match *column {
            Column::Output(column) => row[column],
            Column::Derived(column) => row[row.len() - 1 - column],
        };
        self.terms.iter().fold(self.offset, |sum, (column, factor)| sum + factor * value(column))
    }
}
