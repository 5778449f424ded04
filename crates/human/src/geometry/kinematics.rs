//! Kinematic trees of revolute and prismatic joints: where each link is, and how fast any of its points moves.
//!
//! Joint-space algebra (the geometric Jacobian) is nalgebra's job; points and poses are parry's types. This file is
//! the one seam between them.

use nalgebra::{DVector, Matrix6xX, Vector6};

use super::{Pose, Rotation, Vec3, rotation_about};

/// How a joint moves.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Motion {
    /// It turns about its axis; its position is an angle, rad.
    Revolute,
    /// It slides along its axis; its position is a length, m.
    Prismatic,
}

/// A joint: the fixed transform to its frame, and the axis that it turns about or slides along.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Joint {
    /// The joint whose moving side carries it, an earlier one; none for the base.
    pub parent: Option<usize>,
    /// `parent_from_joint` at position zero.
    pub parent_from_joint: Pose,
    /// How it moves.
    pub motion: Motion,
    /// Unit axis in the joint frame.
    pub axis: Vec3,
}

/// Joints from the base on; each comes after the one that carries it. Without branches, a serial chain.
#[derive(Clone, Debug, PartialEq)]
pub struct KinematicTree {
    /// `world_from_base`.
    pub world_from_base: Pose,
    /// Joints, each after its parent.
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

    /// The same seen by somebody who moves at `velocity`, m/s.
    #[must_use]
    pub fn seen_from(&self, velocity: Vec3) -> Self {
        Self { angular: self.angular, linear_at_origin: self.linear_at_origin - velocity }
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

/// A tree at given joint positions.
#[derive(Clone, Debug, PartialEq)]
pub struct PlacedTree<'a> {
    /// `world_from_link` for the moving side of each joint.
    pub world_from_link: Vec<Pose>,
    /// Unit joint axes in world coordinates.
    axes: Vec<Vec3>,
    joints: &'a [Joint],
}

impl KinematicTree {
    /// Forward kinematics for joint `positions`, rad or m, one a joint.
    #[must_use]
    pub fn place(&self, positions: &[f64]) -> PlacedTree<'_> {
        let mut placed = PlacedTree { world_from_link: Vec::new(), axes: Vec::new(), joints: &self.joints };
        for (joint, &position) in self.joints.iter().zip(positions) {
            let parent = joint.parent.map_or(self.world_from_base, |parent| placed.world_from_link[parent]);
            let world = parent * joint.parent_from_joint;
            placed.axes.push(world.rotation * joint.axis);
            let moved = match joint.motion {
                Motion::Revolute => Pose::from_parts(Vec3::ZERO, rotation_about(joint.axis, position)),
                Motion::Prismatic => Pose::from_parts(joint.axis * position, Rotation::IDENTITY),
            };
            placed.world_from_link.push(world * moved);
        }
        placed
    }
}

impl PlacedTree<'_> {
    /// Geometric Jacobian of the link moved by joint `link`, at the world origin: 6 x joints, angular rows first.
    ///
    /// Column `i` is `(z_i, -z_i x o_i)` for a revolute joint and `(0, z_i)` for a prismatic one, if it is `link` or
    /// carries it, else zero (Siciliano et al., *Robotics*, 3.1.3, taken at the world origin so that one Jacobian serves
    /// every point of the link).
    #[must_use]
    pub(crate) fn jacobian(&self, link: usize) -> Matrix6xX<f64> {
        let mut jacobian = Matrix6xX::zeros(self.axes.len());
        let mut next = Some(link);
        while let Some(i) = next {
            let (axis, origin) = (self.axes[i], self.world_from_link[i].translation);
            let (angular, linear) = match self.joints[i].motion {
                Motion::Revolute => (axis, origin.cross(axis)),
                Motion::Prismatic => (Vec3::ZERO, axis),
            };
            jacobian.set_column(i, &Vector6::new(angular.x, angular.y, angular.z, linear.x, linear.y, linear.z));
            next = self.joints[i].parent;
        }
        jacobian
    }

    /// No point of the link moved by joint `link` that is no farther than `radius_m` from the segment between two points goes
    /// farther from where it is here, m, while no joint's position differs by more than `by`, rad or m. A lever changes by no more than
    /// that itself: with levers `l` it is `sum(l by) / (1 - sum(by))`, sums over joints that turn; infinite where they turn by a radian.
    #[must_use]
    pub fn moves_m(&self, link: usize, (a, b): (Vec3, Vec3), radius_m: f64, by: &[f64]) -> f64 {
        let (mut moves_m, mut turned, mut next) = (0.0, 0.0, Some(link));
        while let Some(i) = next {
            match self.joints[i].motion {
                Motion::Revolute => {
                    let lever = |point: Vec3| self.axes[i].cross(point - self.world_from_link[i].translation).length();
                    moves_m += (lever(a).max(lever(b)) + radius_m) * by[i];
                    turned += by[i];
                }
                Motion::Prismatic => moves_m += by[i],
            }
            next = self.joints[i].parent;
        }
        if turned < 1.0 { moves_m / (1.0 - turned) } else { f64::INFINITY }
    }

    /// Twist of every link for joint `speeds`, rad/s or m/s.
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

    fn planar_arm() -> KinematicTree {
        let joint = |parent, x| Joint {
            parent,
            parent_from_joint: Pose::translation(x, 0.0, 0.0),
            motion: Motion::Revolute,
            axis: Vec3::Z,
        };
        KinematicTree { world_from_base: Pose::IDENTITY, joints: vec![joint(None, 0.0), joint(Some(0), 0.5)] }
    }

    #[test]
    fn planar_arm_by_hand() {
        // First link 0.5 m along x turned 90 degrees, second turned back by 90: its frame is at (0, 0.5), unrotated.
        let quarter = std::f64::consts::FRAC_PI_2;
        let arm = planar_arm();
        let placed = arm.place(&[quarter, -quarter]);
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
        // Six turning joints one after the other, then two fingers that slide apart on the last.
        let joint = |i: u8| {
            let along = f64::from(i);
            let tilt = rotation_about(Vec3::new(1.0, 0.0, 0.0), 0.4 * along);
            Joint {
                parent: [None, Some(0), Some(1), Some(2), Some(3), Some(4), Some(5), Some(5)][usize::from(i)],
                parent_from_joint: Pose::from_parts(Vec3::new(0.05, 0.1, 0.2), tilt),
                motion: if i < 6 { Motion::Revolute } else { Motion::Prismatic },
                axis: Vec3::new(0.3, 1.0 - 0.1 * along, 0.2 * along).normalize(),
            }
        };
        let tree = KinematicTree {
            world_from_base: Pose::from_parts(Vec3::new(0.1, -0.2, 0.4), rotation_about(Vec3::Z, 0.7)),
            joints: (0..8).map(joint).collect(),
        };
        let q = [0.3, -0.8, 1.1, 0.2, -0.5, 0.9, 0.02, 0.03];
        let qd = [1.0, -0.4, 0.7, 2.0, -1.5, 0.3, 0.25, -0.2];
        let local = Vec3::new(0.02, 0.03, 0.2);
        for link in 0..8 {
            let at = |h: f64| {
                let q: Vec<f64> = q.iter().zip(&qd).map(|(a, s)| a + h * s).collect();
                tree.place(&q).world_from_link[link].transform_point(local)
            };
            let h = 1e-6;
            let numeric = (at(h) - at(-h)) / (2.0 * h);
            let analytic = tree.place(&q).twists(&qd)[link].velocity_at(at(0.0));
            assert!((numeric - analytic).length() < 1e-8, "{link}: {numeric} {analytic}");
        }
    }
}
