//! How the mass of bodies is spread, and how heavy a robot is for whoever is hit by a point of it.
//!
//! A robot that is pushed at a point gives way in all of its joints at once. Of its mass `M(q)` as the joints have it is
//! left, at that point in the unit direction n,
//!
//! ```text
//! m = 1 / (n' J M(q)^-1 J' n)
//! ```
//!
//! with J the linear Jacobian of the point (O. Khatib, *Inertial properties in robotic manipulation: an object-level
//! framework*, IJRR 14(1), 1995: the effective mass in a direction). Drives, gears and rotors, friction and gravity are left
//! out: joints turn and slide freely.

use nalgebra::{DMatrix, DVector, Matrix6xX};

use super::kinematics::PlacedTree;
use super::{Matrix3, Pose, Vec3};

/// A point that weighs more than so many times all that moves does not give way: its joints cannot move it there, but for
/// rounding.
const IMMOVABLE: f64 = 1e12;

/// A coordinate of which less than this part of its inertia is left once those before it give way has none, but for rounding.
const WEIGHTLESS: f64 = 1e-12;

/// How far moments and products of inertia may be off what a body can have, as part of the sum of its moments: data sheets
/// round.
const ROUNDED: f64 = 1e-3;

/// A rigid body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Inertia {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Centre of mass, m.
    pub centre: Vec3,
    /// Inertia tensor about the centre of mass in the axes of the frame, kg m^2.
    pub tensor: Matrix3,
}

impl Inertia {
    /// Nothing.
    pub const NONE: Self = Self { mass_kg: 0.0, centre: Vec3::ZERO, tensor: Matrix3::ZERO };

    /// All mass in one point.
    #[must_use]
    pub const fn point(mass_kg: f64, at: Vec3) -> Self {
        Self { mass_kg, centre: at, tensor: Matrix3::ZERO }
    }

    /// With the moments xx, yy, zz and products xy, xz, yz about the centre of mass: the entries of the tensor.
    #[must_use]
    pub const fn new(mass_kg: f64, centre: Vec3, [xx, yy, zz]: [f64; 3], [xy, xz, yz]: [f64; 3]) -> Self {
        let tensor = Matrix3::from_cols(Vec3::new(xx, xy, xz), Vec3::new(xy, yy, yz), Vec3::new(xz, yz, zz));
        Self { mass_kg, centre, tensor }
    }

    /// The same seen from another frame.
    #[must_use]
    pub fn placed(&self, other_from_this: Pose) -> Self {
        let turned = Matrix3::from_quat(other_from_this.rotation);
        Self {
            mass_kg: self.mass_kg,
            centre: other_from_this.transform_point(self.centre),
            tensor: turned * self.tensor * turned.transpose(),
        }
    }

    /// Both as one body.
    #[must_use]
    pub fn with(&self, other: &Self) -> Self {
        let mass_kg = self.mass_kg + other.mass_kg;
        if mass_kg <= 0.0 {
            return Self::NONE;
        }
        let centre = (self.mass_kg * self.centre + other.mass_kg * other.centre) / mass_kg;
        Self { mass_kg, centre, tensor: self.tensor_about(centre) + other.tensor_about(centre) }
    }

    /// Inertia tensor about a point (Huygens and Steiner).
    fn tensor_about(&self, point: Vec3) -> Matrix3 {
        let d = self.centre - point;
        let outer = Matrix3::from_cols(d * d.x, d * d.y, d * d.z);
        self.tensor + (Matrix3::from_diagonal(Vec3::splat(d.length_squared())) - outer) * self.mass_kg
    }

    /// Whether turning it takes energy about every axis, or none.
    #[must_use]
    pub fn is_semidefinite(&self) -> bool {
        is_semidefinite(&self.tensor, ROUNDED * trace(&self.tensor))
    }

    /// Whether any spread of mass has this tensor: no principal moment is greater than both others together. That is so where
    /// the second moments of mass, `tr(I)/2 - I`, are no less than zero in any direction.
    #[must_use]
    pub fn is_of_a_body(&self) -> bool {
        let sum = trace(&self.tensor);
        let spread = Matrix3::from_diagonal(Vec3::splat(0.5 * sum)) - self.tensor;
        is_semidefinite(&spread, ROUNDED * sum)
    }
}

fn trace(m: &Matrix3) -> f64 {
    m.x_axis.x + m.y_axis.y + m.z_axis.z
}

/// Whether a symmetric matrix plus `slack` has no negative eigenvalue, by its principal minors.
fn is_semidefinite(m: &Matrix3, slack: f64) -> bool {
    let m = *m + Matrix3::from_diagonal(Vec3::splat(slack.abs()));
    let (xx, yy, zz) = (m.x_axis.x, m.y_axis.y, m.z_axis.z);
    let (xy, xz, yz) = (m.x_axis.y, m.x_axis.z, m.y_axis.z);
    let first = [xx, yy, zz];
    let second = [xx * yy - xy * xy, xx * zz - xz * xz, yy * zz - yz * yz];
    first.into_iter().chain(second).chain([m.determinant()]).all(|minor| minor >= 0.0)
}

/// What moves a joint: `factor` times a coordinate. Several joints may follow one.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Drive {
    /// Number of the coordinate.
    pub coordinate: usize,
    /// Factor.
    pub factor: f64,
}

/// The masses of a kinematic tree.
#[derive(Clone, Debug, PartialEq)]
pub struct Masses {
    /// What the moving side of each joint carries, in its frame.
    pub bodies: Vec<Inertia>,
    /// What moves each joint; nothing for one that is held.
    pub drives: Vec<Option<Drive>>,
}

impl Masses {
    /// Of joints that each move by themselves.
    #[cfg(test)]
    pub(crate) fn free(bodies: Vec<Inertia>) -> Self {
        let drives = (0..bodies.len()).map(|coordinate| Some(Drive { coordinate, factor: 1.0 })).collect();
        Self { bodies, drives }
    }

    /// Mass matrix of the coordinates, kg m^2, kg m or kg, where the moving side of joint `load.0` carries `load.1` as well, in
    /// its frame.
    ///
    /// `sum of m v_i . v_j + w_i . I w_j` over the bodies, with v and w the velocities of the centre of mass and of turning per
    /// speed of the coordinates i and j (Siciliano et al., *Robotics*, 7.1.1).
    #[must_use]
    pub fn mass_matrix(&self, placed: &PlacedTree<'_>, load: Option<(usize, Inertia)>) -> DMatrix<f64> {
        let size = self.coordinates();
        let mut matrix = DMatrix::zeros(size, size);
        let bodies = self.bodies.iter().copied().enumerate().chain(load);
        for (link, body) in bodies.filter(|(_, body)| body.mass_kg > 0.0) {
            let body = body.placed(placed.world_from_link[link]);
            let columns = self.columns(&placed.jacobian(link), body.centre);
            for (i, (v_i, w_i)) in columns.iter().enumerate() {
                for (j, (v_j, w_j)) in columns.iter().enumerate().take(i + 1) {
                    matrix[(i, j)] += body.mass_kg * v_i.dot(*v_j) + w_i.dot(body.tensor * *w_j);
                }
            }
        }
        matrix.fill_upper_triangle_with_lower_triangle();
        matrix
    }

    /// Mass, kg, that whoever pushes at the point of `link` at world position `point` along `direction`, whatever its length,
    /// has to move. Infinite where no joint moves that point that way, or where there is no direction; never less than zero, and
    /// a number always.
    #[must_use]
    pub fn reflected_mass_kg(
        &self,
        placed: &PlacedTree<'_>,
        load: Option<(usize, Inertia)>,
        link: usize,
        point: Vec3,
        direction: Vec3,
    ) -> f64 {
        let Some(n) = direction.try_normalize() else { return f64::INFINITY };
        let columns = self.columns(&placed.jacobian(link), point);
        let along = DVector::from_iterator(columns.len(), columns.iter().map(|(v, _)| v.dot(n)));
        let total: f64 = self.bodies.iter().chain(load.iter().map(|(_, load)| load)).map(|body| body.mass_kg).sum();
        let mobility = mobility(&self.mass_matrix(placed, load), &along);
        // The negation holds for what is no number as well.
        if mobility * total * IMMOVABLE >= 1.0 { 1.0 / mobility } else { f64::INFINITY }
    }

    fn coordinates(&self) -> usize {
        self.drives.iter().flatten().map(|drive| drive.coordinate + 1).max().unwrap_or(0)
    }

    /// Velocity of a link at a world point, and of its turning, per speed of each coordinate.
    fn columns(&self, jacobian: &Matrix6xX<f64>, point: Vec3) -> Vec<(Vec3, Vec3)> {
        let mut columns = vec![(Vec3::ZERO, Vec3::ZERO); self.coordinates()];
        for (column, drive) in jacobian.column_iter().zip(&self.drives) {
            let Some(Drive { coordinate, factor }) = *drive else { continue };
            let turning = Vec3::new(column[0], column[1], column[2]);
            let at_origin = Vec3::new(column[3], column[4], column[5]);
            columns[coordinate].0 += factor * (at_origin + turning.cross(point));
            columns[coordinate].1 += factor * turning;
        }
        columns
    }
}

/// `a' M^-1 a` of a symmetric matrix without negative eigenvalues, by M = L D L'; infinite where a is in no image of M, and
/// M^-1 a any of the vectors that M takes to a else. What has no inertia gives way by itself.
fn mobility(matrix: &DMatrix<f64>, a: &DVector<f64>) -> f64 {
    let (mut m, mut y) = (matrix.clone(), a.clone());
    let mut sum = 0.0;
    for i in 0..m.nrows() {
        let pivot = m[(i, i)];
        if pivot <= WEIGHTLESS * matrix[(i, i)] {
            // Below a pivot of zero the column is zero as well.
            if y[i].abs() > WEIGHTLESS * a.amax() {
                return f64::INFINITY;
            }
            continue;
        }
        sum += y[i] * y[i] / pivot;
        for row in i + 1..m.nrows() {
            let factor = m[(row, i)] / pivot;
            y[row] -= factor * y[i];
            for column in i + 1..=row {
                m[(row, column)] -= factor * m[(column, i)];
            }
        }
    }
    sum
}

#[cfg(test)]
#[path = "inertia_tests.rs"]
mod tests;
