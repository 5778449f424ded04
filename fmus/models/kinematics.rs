//! Six-axis robots: forward kinematics, joint speeds, and joint angles by Newton's method on the pose.
//!
//! Frames: the base frame as the robot's data have it, all frames aligned in the zero pose. Orientations are rotation
//! matrices by rows. Newton's method serves arms without a closed solution (wrists whose axes do not meet) as well, and
//! which of an arm's poses it finds follows from where it starts.

use crate::interface::robots::{Axis, Robot};
use crate::trig::sin_cos_of_all;

/// A vector in metres or m/s, or a direction.
pub type Vec3 = [f64; 3];
/// A rotation matrix by rows.
pub type Rotation = [[f64; 3]; 3];
/// Joint angles in rad, or speeds in rad/s.
pub type Joints = [f64; 6];

/// The tool centre point and the orientation of the tool.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    pub position: Vec3,
    pub rotation: Rotation,
}

/// An arm at given joint angles, base frame.
#[derive(Debug, Clone, Copy)]
pub struct Chain {
    /// Origins of the six joints, then the tool centre point.
    pub origins: [Vec3; 7],
    /// The joint axes.
    pub axes: [Vec3; 6],
    /// Orientation of each joint's moving side; the last is the tool's.
    pub rotations: [Rotation; 6],
}

const IDENTITY: Rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// Newton steps before a pose counts as out of reach, and the largest change of a joint in one step, rad.
const STEPS: usize = 60;
const LARGEST_STEP: f64 = 0.3;
/// How near the pose has to be met: m and rad together.
const MET: f64 = 1e-13;
/// What rounding may leave over.
const MET_AT_LAST: f64 = 1e-11;

impl Robot {
    /// Places the arm.
    pub fn place(&self, q: &Joints) -> Chain {
        let mut chain = Chain { origins: [[0.0; 3]; 7], axes: [[0.0; 3]; 6], rotations: [IDENTITY; 6] };
        let (mut rotation, mut at) = (IDENTITY, [0.0; 3]);
        let angles: Joints = std::array::from_fn(|joint| self.joints[joint].1.sign() * q[joint]);
        let turns = sin_cos_of_all(angles);
        for (joint, (offset, axis)) in self.joints.iter().enumerate() {
            at = add(at, apply(&rotation, *offset));
            chain.origins[joint] = at;
            chain.axes[joint] = apply(&rotation, axis.direction());
            rotation = product(&rotation, &axis.rotation(turns[joint]));
            chain.rotations[joint] = rotation;
        }
        chain.origins[6] = add(at, apply(&rotation, self.tool));
        chain
    }

    /// Joint angles that reach `pose`, searched from `near`; None if it is out of reach or a singular pose lies on the
    /// way. Joint ranges are not looked at.
    pub fn angles(&self, pose: &Pose, near: &Joints) -> Option<Joints> {
        let mut q = *near;
        let mut best = f64::INFINITY;
        for _ in 0..STEPS {
            let chain = self.place(&q);
            let linear = add(pose.position, scale(chain.origins[6], -1.0));
            let angular = turn(&chain.rotations[5], &pose.rotation);
            let off = norm(linear) + norm(angular);
            // Near the solution the error falls until rounding stops it.
            if off <= MET || (off <= MET_AT_LAST && off >= best) {
                return Some(q);
            }
            best = off;
            let step = chain.joint_speeds(linear, angular)?;
            let largest = step.iter().fold(0.0_f64, |most, change| most.max(change.abs()));
            let damping = if largest > LARGEST_STEP { LARGEST_STEP / largest } else { 1.0 };
            q = std::array::from_fn(|joint| q[joint] + damping * step[joint]);
        }
        None
    }
}

impl Chain {
    /// Joint speeds that move the tool centre point with `linear` (m/s) and turn the tool with `angular` (rad/s), both
    /// in the base frame; None in a singular pose.
    pub fn joint_speeds(&self, linear: Vec3, angular: Vec3) -> Option<Joints> {
        let mut rows = [[0.0; 7]; 6];
        for (joint, (axis, origin)) in self.axes.iter().zip(&self.origins).enumerate() {
            let moves = cross(*axis, add(self.origins[6], scale(*origin, -1.0)));
            for k in 0..3 {
                rows[k][joint] = moves[k];
                rows[k + 3][joint] = axis[k];
            }
        }
        for k in 0..3 {
            rows[k][6] = linear[k];
            rows[k + 3][6] = angular[k];
        }
        solve(rows)
    }

    /// Velocity of the origin of each joint's moving side and its angular velocity, for joint `speeds`.
    pub fn twists(&self, speeds: &Joints) -> [(Vec3, Vec3); 6] {
        let mut twists = [([0.0; 3], [0.0; 3]); 6];
        for (link, twist) in twists.iter_mut().enumerate() {
            for (joint, &speed) in speeds.iter().enumerate().take(link + 1) {
                let arm = add(self.origins[link], scale(self.origins[joint], -1.0));
                twist.0 = add(twist.0, scale(cross(self.axes[joint], arm), speed));
                twist.1 = add(twist.1, scale(self.axes[joint], speed));
            }
        }
        twists
    }
}

/// The small rotation that turns `from` to `to`, as a vector: exact in the first order, and zero only where they agree
/// (or are half a turn apart).
fn turn(from: &Rotation, to: &Rotation) -> Vec3 {
    let sum = (0..3).fold([0.0; 3], |sum, k| add(sum, cross(column(from, k), column(to, k))));
    scale(sum, 0.5)
}

/// Gaussian elimination with column pivoting of a 6 x 6 system, the right-hand side in the last column.
fn solve(mut rows: [[f64; 7]; 6]) -> Option<Joints> {
    for step in 0..6 {
        let pivot = (step..6).max_by(|&a, &b| rows[a][step].abs().total_cmp(&rows[b][step].abs()))?;
        rows.swap(step, pivot);
        let top = rows[step];
        if top[step].abs() < 1e-9 {
            return None;
        }
        for (index, row) in rows.iter_mut().enumerate() {
            if index != step {
                let factor = row[step] / top[step];
                for (value, above) in row.iter_mut().zip(top) {
                    *value -= factor * above;
                }
            }
        }
    }
    Some(std::array::from_fn(|k| rows[k][6] / rows[k][k]))
}

impl Axis {
    fn direction(self) -> Vec3 {
        match self {
            Axis::X => [1.0, 0.0, 0.0],
            Axis::Y => [0.0, 1.0, 0.0],
            Axis::Z => [0.0, 0.0, 1.0],
            Axis::NegY => [0.0, -1.0, 0.0],
            Axis::NegZ => [0.0, 0.0, -1.0],
        }
    }

    /// Whether it turns with or against the axis of the frame that it lies on.
    fn sign(self) -> f64 {
        match self {
            Axis::X | Axis::Y | Axis::Z => 1.0,
            Axis::NegY | Axis::NegZ => -1.0,
        }
    }

    /// The turn about the axis of the frame, from its sine and cosine.
    fn rotation(self, (s, c): (f64, f64)) -> Rotation {
        match self {
            Axis::X => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
            Axis::Y | Axis::NegY => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
            Axis::Z | Axis::NegZ => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
        }
    }
}

/// The unit quaternion (w, x, y, z) of a rotation, with the largest component positive (Shepperd 1978).
pub fn quaternion(m: &Rotation) -> [f64; 4] {
    let trace = m[0][0] + m[1][1] + m[2][2];
    let diagonal = [trace, m[0][0], m[1][1], m[2][2]];
    let largest = (1..4).fold(0, |best, k| if diagonal[k] > diagonal[best] { k } else { best });
    let root = (1.0 + 2.0 * diagonal[largest] - trace).sqrt();
    let part = 0.5 / root;
    let mut q = [0.0; 4];
    q[largest] = 0.5 * root;
    if largest == 0 {
        q[1] = (m[2][1] - m[1][2]) * part;
        q[2] = (m[0][2] - m[2][0]) * part;
        q[3] = (m[1][0] - m[0][1]) * part;
    } else {
        let (i, j, k) = (largest - 1, largest % 3, (largest + 1) % 3);
        q[0] = (m[k][j] - m[j][k]) * part;
        q[j + 1] = (m[j][i] + m[i][j]) * part;
        q[k + 1] = (m[k][i] + m[i][k]) * part;
    }
    q
}

pub fn add(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] + b[0], a[1] + b[1], a[2] + b[2]]
}

pub fn scale(a: Vec3, factor: f64) -> Vec3 {
    [a[0] * factor, a[1] * factor, a[2] * factor]
}

pub fn norm(a: Vec3) -> f64 {
    (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt()
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn column(m: &Rotation, k: usize) -> Vec3 {
    [m[0][k], m[1][k], m[2][k]]
}

fn apply(m: &Rotation, v: Vec3) -> Vec3 {
    m.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
}

fn product(a: &Rotation, b: &Rotation) -> Rotation {
    a.map(|row| [0, 1, 2].map(|k| row[0] * b[0][k] + row[1] * b[1][k] + row[2] * b[2][k]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::robots::{CRX_10IA_L, IRB_1200, KR_16, UR5E, UR10E};
    use std::f64::consts::PI;

    fn assert_near(a: &[f64], b: &[f64], tolerance: f64) {
        for (x, y) in a.iter().zip(b) {
            assert!((x - y).abs() <= tolerance, "{a:?} is not {b:?}");
        }
    }

    fn pose(robot: &Robot, q: &Joints) -> Pose {
        let chain = robot.place(q);
        Pose { position: chain.origins[6], rotation: chain.rotations[5] }
    }

    #[test]
    fn zero_poses_by_hand() {
        // IRB 1200: 0.3991 + 0.448 + 0.042 high; forearm, flange and tool forward: 0.451 + 0.082 + 0.100.
        assert_near(&pose(&IRB_1200, &[0.0; 6]).position, &[0.633, 0.0, 0.8891], 1e-15);
        // KR 16-2: 0.675 + 0.680 + 0.035 high; 0.260 + 0.670 + 0.158 + 0.100 forward.
        assert_near(&pose(&KR_16, &[0.0; 6]).position, &[1.188, 0.0, 1.390], 1e-15);
        assert_near(&pose(&CRX_10IA_L, &[0.0; 6]).position, &[0.800, 0.150, 0.955], 1e-15);
        // UR5e with all angles zero, from its Denavit-Hartenberg table: (-a2-a3, -d4-d6, d1-d5), the tool along -y.
        assert_near(&pose(&UR5E, &[0.0; 6]).position, &[-0.8172, -0.2329 - 0.100, 0.0628], 1e-15);
    }

    /// Denavit-Hartenberg matrices of a UR10e, multiplied out: another convention, the same flange.
    #[test]
    fn a_ur_agrees_with_its_denavit_hartenberg_table() {
        let table = [
            (0.1807, 0.0, PI / 2.0),
            (0.0, -0.6127, 0.0),
            (0.0, -0.571_55, 0.0),
            (0.174_15, 0.0, PI / 2.0),
            (0.119_85, 0.0, -PI / 2.0),
            (0.116_55, 0.0, 0.0),
        ];
        for seed in 0..50_u32 {
            let q: Joints = std::array::from_fn(|k| (f64::from(seed) * [0.7, 1.3, 2.1, 0.4, 1.9, 0.9][k]) % 6.0 - 3.0);
            let (mut rotation, mut at) = (IDENTITY, [0.0; 3]);
            for ((d, a, alpha), theta) in table.into_iter().zip(q) {
                let [about_z, about_x] = sin_cos_of_all([theta, alpha]);
                let turned = product(&rotation, &Axis::Z.rotation(about_z));
                at = add(at, apply(&turned, [a, 0.0, d]));
                rotation = product(&turned, &Axis::X.rotation(about_x));
            }
            let flange = add(at, scale(column(&rotation, 2), 0.10));
            assert_near(&pose(&UR10E, &q).position, &flange, 1e-12);
        }
    }

    #[test]
    fn bent_poses_by_hand() {
        let quarter = PI / 2.0;
        // Upper arm level forward (q2 = 90 deg), forearm then hanging straight down: offset points forward.
        let bent = pose(&IRB_1200, &[0.0, quarter, 0.0, 0.0, 0.0, 0.0]);
        assert_near(&bent.position, &[0.448 + 0.042, 0.0, 0.3991 - 0.633], 1e-15);
        // Turned left by 90 deg, wrist bent down by 90 deg: the tool points down at the left of the base.
        let bent = pose(&IRB_1200, &[quarter, 0.0, 0.0, 0.0, quarter, 0.0]);
        assert_near(&bent.position, &[0.0, 0.451, 0.8891 - 0.182], 1e-15);
        assert_near(&column(&bent.rotation, 0), &[0.0, 0.0, -1.0], 1e-15);
    }

    #[test]
    fn angles_lead_back_to_the_pose_they_were_searched_for() {
        for robot in [&IRB_1200, &KR_16, &CRX_10IA_L, &UR5E, &UR10E] {
            let mut found = 0;
            for seed in 0..200_u32 {
                let part = |k: usize| (f64::from(seed + 1) * [0.754, 0.569, 0.430, 0.324, 0.245, 0.184][k]).fract();
                let q: Joints = std::array::from_fn(|k| 2.4 * part(k) - 1.2);
                let near: Joints = std::array::from_fn(|k| q[k] + 0.1 * part(5 - k) - 0.05);
                let wanted = pose(robot, &q);
                let Some(angles) = robot.angles(&wanted, &near) else { continue };
                let again = pose(robot, &angles);
                assert_near(&again.position, &wanted.position, 2e-11);
                for (row, expected) in again.rotation.iter().zip(&wanted.rotation) {
                    assert_near(row, expected, 2e-11);
                }
                found += 1;
            }
            assert!(found > 185, "{}: only {found} of 200", robot.name);
        }
    }

    #[test]
    fn out_of_reach_is_none() {
        let down = crate::interface::workcell::POINTING_DOWN;
        let far = Pose { position: [1.2, 0.0, 0.4], rotation: down };
        assert_eq!(IRB_1200.angles(&far, &[0.0, 0.3, 0.3, 0.0, 1.0, 0.0]), None);
    }

    #[test]
    fn joint_speeds_and_twists_are_derivatives() {
        let q = [0.3, 0.4, 0.2, 0.5, 0.8, -0.3];
        for robot in [&IRB_1200, &CRX_10IA_L, &UR5E] {
            let velocity = [0.7, -1.1, 0.4];
            let speeds = robot.place(&q).joint_speeds(velocity, [0.0; 3]).unwrap();
            let step = 1e-6;
            let at = |sign: f64| robot.place(&std::array::from_fn(|k| q[k] + sign * step * speeds[k]));
            let (ahead, behind) = (at(1.0), at(-1.0));
            let by = |a: Vec3, b: Vec3| scale(add(a, scale(b, -1.0)), 0.5 / step);
            assert_near(&by(ahead.origins[6], behind.origins[6]), &velocity, 1e-8);
            for (row, other) in ahead.rotations[5].iter().zip(&behind.rotations[5]) {
                assert_near(row, other, 1e-10);
            }
            let twists = robot.place(&q).twists(&speeds);
            for (link, twist) in twists.iter().enumerate() {
                assert_near(&twist.0, &by(ahead.origins[link], behind.origins[link]), 1e-8);
                let turned = scale(turn(&behind.rotations[link], &ahead.rotations[link]), 0.5 / step);
                assert_near(&twist.1, &turned, 1e-8);
            }
        }
    }

    #[test]
    fn quaternions_turn_vectors_as_their_matrices_do() {
        for seed in 0..100_u32 {
            let q: Joints = std::array::from_fn(|k| f64::from(seed) * [0.37, 0.71, 1.13, 0.59, 0.23, 0.97][k]);
            let rotation = IRB_1200.place(&q).rotations[5];
            let [w, x, y, z] = quaternion(&rotation);
            assert!((w * w + x * x + y * y + z * z - 1.0).abs() < 1e-12);
            // v + 2 u x (u x v + w v)
            let (u, v) = ([x, y, z], [0.3, -0.5, 0.8]);
            let inner = add(cross(u, v), scale(v, w));
            assert_near(&add(v, scale(cross(u, inner), 2.0)), &apply(&rotation, v), 1e-12);
        }
    }
}
