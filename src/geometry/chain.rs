//! Serial kinematic chains of revolute joints: where each link is, and how fast any of its points moves.
//!
//! Joint-space algebra (the geometric Jacobian) is nalgebra's job; points and poses are parry's types. This file is
//! the one seam between them.

use nalgebra::{DVector, Matrix6xX, Vector6};

use super::{Pose, Vec3, rotation_about};

/// A revolute joint: the fixed transform to its frame and the axis it turns about.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// `parent_from_joint` at angle zero.
    pub parent_from_joint: Pose,
    /// Unit axis in the joint frame.
    pub axis: Vec3,
}

/// A chain from the base to the tool.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicChain {
    /// `world_from_base`.
    pub world_from_base: Pose,
    /// Joints in order.
    pub joints: Vec<Joint>,
}

/// Velocity of a rigid body in world coordinates.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Twist {
    /// Angular velocity, rad/s.
    pub angular: Vec3,
    /// Velocity of the point of the body that is at the world origin, m/s.
    pub linear_at_origin: Vec3,
}

impl Twist {
    /// Velocity of the body's point at world position `point`, m/s.
    #[must_use]
    pub fn velocity_at(&self, point: Vec3) -> Vec3 {
        self.linear_at_origin + self.angular.cross(point)
    }

    /// No body's point among these is faster, m/s: `|v + w x d| <= |v| + v/|v| (w x d) + |w x d|^2 / (2 |v|)`.
    #[must_use]
    pub fn speed_bound(&self, points: &Neighbourhood<'_>) -> f64 {
        let velocity = self.velocity_at(points.centre);
        let (speed, across) = (velocity.length(), self.angular.length() * points.radius);
        let (Some(unit), Some(along)) = (velocity.try_normalize(), points.along) else { return speed + across };
        let gradient = unit.cross(self.angular);
        let first = gradient.try_normalize().map_or(0.0, |n| gradient.length() * along(n));
        (speed + across).min(speed + first + across * across / (2.0 * speed))
    }
}

/// Points around a centre, world.
#[derive(Clone, Copy)]
pub struct Neighbourhood<'a> {
    /// The centre.
    pub centre: Vec3,
    /// No point is farther from it, m.
    pub radius: f64,
    /// Nor farther along a unit vector than this says, m, if that is known.
    pub along: Option<&'a dyn Fn(Vec3) -> f64>,
}

impl Neighbourhood<'_> {
    /// A ball.
    #[must_use]
    pub const fn ball(centre: Vec3, radius: f64) -> Self {
        Self { centre, radius, along: None }
    }
}

/// A chain at given joint angles.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedChain {
    /// `world_from_link` for the moving side of each joint.
    pub world_from_link: Vec<Pose>,
    /// Unit joint axes in world coordinates.
    axes: Vec<Vec3>,
}

impl KinematicChain {
    /// Forward kinematics for `angles` in radians, one a joint.
    #[must_use]
    pub fn place(&self, angles: &[f64]) -> PlacedChain {
        let mut world = self.world_from_base;
        let mut placed = PlacedChain { world_from_link: Vec::new(), axes: Vec::new() };
        for (joint, &angle) in self.joints.iter().zip(angles) {
            world *= joint.parent_from_joint;
            placed.axes.push(world.rotation * joint.axis);
            world *= Pose::from_parts(Vec3::ZERO, rotation_about(joint.axis, angle));
            placed.world_from_link.push(world);
        }
        placed
    }
}

impl PlacedChain {
    /// Geometric Jacobian of the link moved by joint `link`, at the world origin: 6 x joints, angular rows first.
    ///
    /// Column `i` is `(z_i, -z_i x o_i)` for joints at or before `link`, else zero (Siciliano et al., *Robotics*, 3.1.3,
    /// taken at the world origin so that one Jacobian serves every point of the link).
    #[must_use]
    pub fn jacobian(&self, link: usize) -> Matrix6xX<f64> {
        let mut jacobian = Matrix6xX::zeros(self.axes.len());
        for (i, (axis, pose)) in self.axes.iter().zip(&self.world_from_link).enumerate().take(link + 1) {
            let linear = pose.translation.cross(*axis);
            jacobian.set_column(i, &Vector6::new(axis.x, axis.y, axis.z, linear.x, linear.y, linear.z));
        }
        jacobian
    }

    /// Twist of every link for joint `speeds` in rad/s.
    #[must_use]
    pub fn twists(&self, speeds: &[f64]) -> Vec<Twist> {
        let speeds = DVector::from_column_slice(speeds);
        (0..self.axes.len())
            .map(|link| {
                let v = self.jacobian(link) * &speeds;
                Twist { angular: Vec3::new(v[0], v[1], v[2]), linear_at_origin: Vec3::new(v[3], v[4], v[5]) }
            })
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn planar_arm() -> KinematicChain {
        let joint = |x| Joint { parent_from_joint: Pose::translation(x, 0.0, 0.0), axis: Vec3::Z };
        KinematicChain { world_from_base: Pose::IDENTITY, joints: vec![joint(0.0), joint(0.5)] }
    }

    #[test]
    fn planar_arm_by_hand() {
        // First link 0.5 m along x turned 90 degrees, second turned back by 90: its frame is at (0, 0.5), unrotated.
        let quarter = std::f64::consts::FRAC_PI_2;
        let placed = planar_arm().place(&[quarter, -quarter]);
        let tip = placed.world_from_link[1].transform_point(Vec3::new(0.3, 0.0, 0.0));
        assert!((tip - Vec3::new(0.3, 0.5, 0.0)).length() < 1e-12, "{tip}");
        // Only the first joint moves at 2 rad/s: v = w x r.
        let v = placed.twists(&[2.0, 0.0])[1].velocity_at(tip);
        assert!((v - Vec3::new(-1.0, 0.6, 0.0)).length() < 1e-12, "{v}");
        // The second joint alone moves the tip about (0, 0.5), and the first link not at all.
        let twists = placed.twists(&[0.0, 1.0]);
        assert!((twists[1].velocity_at(tip) - Vec3::new(0.0, 0.3, 0.0)).length() < 1e-12);
        assert_eq!(twists[0], Twist::default());
    }

    #[test]
    fn point_speed_agrees_with_finite_differences() {
        let chain = KinematicChain {
            world_from_base: Pose::from_parts(Vec3::new(0.1, -0.2, 0.4), rotation_about(Vec3::Z, 0.7)),
            joints: (0..6)
                .map(|i| {
                    let i = f64::from(i);
                    let tilt = rotation_about(Vec3::new(1.0, 0.0, 0.0), 0.4 * i);
                    let axis = Vec3::new(0.3, 1.0 - 0.1 * i, 0.2 * i).normalize();
                    Joint { parent_from_joint: Pose::from_parts(Vec3::new(0.05, 0.1, 0.2), tilt), axis }
                })
                .collect(),
        };
        let q = [0.3, -0.8, 1.1, 0.2, -0.5, 0.9];
        let qd = [1.0, -0.4, 0.7, 2.0, -1.5, 0.3];
        let local = Vec3::new(0.02, 0.03, 0.2);
        let at = |h: f64| {
            let q: Vec<f64> = q.iter().zip(&qd).map(|(a, s)| a + h * s).collect();
            chain.place(&q).world_from_link[5].transform_point(local)
        };
        let h = 1e-6;
        let numeric = (at(h) - at(-h)) / (2.0 * h);
        let analytic = chain.place(&q).twists(&qd)[5].velocity_at(at(0.0));
        assert!((numeric - analytic).length() < 1e-8, "{numeric} {analytic}");
    }
}
