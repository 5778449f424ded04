//! Six-axis robot with parallel shoulder and elbow axes and a spherical wrist: forward and analytic inverse
//! kinematics and joint speeds.
//!
//! Frames: the base frame stands on the floor of the robot, z up, x forward. In the zero pose the upper arm is
//! upright and the forearm horizontal along +x. Orientations are rotation matrices base_from_flange by rows; the
//! flange axis is their first column. Wrist partitioning after Pieper; ortho-parallel parameters after Brandstötter,
//! Angerer, Hofbaur (2014), with the third joint counted from the horizontal forearm instead of the stretched arm.

use crate::interface::irb1200;
use crate::trig::{acos, atan2, sin_cos};
use std::f64::consts::PI;

/// A vector in metres or m/s, or a direction.
pub type Vec3 = [f64; 3];
/// A rotation matrix by rows.
pub type Rotation = [[f64; 3]; 3];
/// Joint angles in rad, or speeds in rad/s.
pub type Joints = [f64; 6];

/// Lengths of the arm, m; `tool` reaches from the flange to the tool centre point along the flange axis.
#[derive(Debug, Clone, Copy)]
pub struct Arm {
    pub base_to_shoulder: f64,
    pub upper_arm: f64,
    pub elbow_offset: f64,
    pub forearm: f64,
    pub wrist_to_flange: f64,
    pub tool: f64,
}

/// The IRB 1200-5/0.9 with the gripper of the example cells.
pub const IRB_1200: Arm = Arm {
    base_to_shoulder: irb1200::BASE_TO_SHOULDER,
    upper_arm: irb1200::UPPER_ARM,
    elbow_offset: irb1200::ELBOW_OFFSET,
    forearm: irb1200::FOREARM,
    wrist_to_flange: irb1200::WRIST_TO_FLANGE,
    tool: irb1200::TOOL,
};

/// The tool centre point and the orientation of the flange.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Pose {
    pub position: Vec3,
    pub rotation: Rotation,
}

/// The flange axis straight down, the flange's y axis along the base's y axis.
pub const POINTING_DOWN: Rotation = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]];

/// One of the eight solutions of the inverse kinematics.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Branch {
    /// The first joint turned away by half a turn, the arm reaching over its own shoulder.
    pub shoulder_back: bool,
    /// The elbow below the line from shoulder to wrist.
    pub elbow_down: bool,
    /// The fifth joint negative.
    pub wrist_flipped: bool,
}

/// Facing the work, elbow up, fifth joint positive: the usual pose.
pub const ELBOW_UP: Branch = Branch { shoulder_back: false, elbow_down: false, wrist_flipped: false };

impl Arm {
    /// Origins of the six joints and of the tool centre point, the joint axes (all in the base frame), and the
    /// orientation of the flange.
    fn chain(&self, q: &Joints) -> ([Vec3; 7], [Vec3; 6], Rotation) {
        let links = [
            ([0.0, 0.0, self.base_to_shoulder], Axis::Z),
            ([0.0, 0.0, 0.0], Axis::Y),
            ([0.0, 0.0, self.upper_arm], Axis::Y),
            ([0.0, 0.0, self.elbow_offset], Axis::X),
            ([self.forearm, 0.0, 0.0], Axis::Y),
            ([self.wrist_to_flange, 0.0, 0.0], Axis::X),
        ];
        let mut rotation = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        let (mut origins, mut axes) = ([[0.0; 3]; 7], [[0.0; 3]; 6]);
        let mut at = [0.0; 3];
        for (joint, (offset, axis)) in links.iter().enumerate() {
            at = add(at, apply(&rotation, *offset));
            let turn = axis.rotation(q[joint]);
            origins[joint] = at;
            axes[joint] = column(&rotation, *axis as usize);
            rotation = product(&rotation, &turn);
        }
        origins[6] = add(at, apply(&rotation, [self.tool, 0.0, 0.0]));
        (origins, axes, rotation)
    }

    /// Forward kinematics. The cells need only the inverse; this is what checks it.
    #[cfg(test)]
    pub fn forward(&self, q: &Joints) -> Pose {
        let (origins, _, rotation) = self.chain(q);
        Pose { position: origins[6], rotation }
    }

    /// Inverse kinematics on one branch; None if the pose is out of reach. At a stretched wrist, where joints 4 and 6
    /// turn about one axis, joint 4 is set to zero. Joint limits are not looked at.
    pub fn inverse(&self, pose: &Pose, branch: Branch) -> Option<Joints> {
        let approach = column(&pose.rotation, 0);
        let wrist = add(pose.position, scale(approach, -(self.wrist_to_flange + self.tool)));
        let radius = (wrist[0] * wrist[0] + wrist[1] * wrist[1]).sqrt();
        let facing = if branch.shoulder_back { -1.0 } else { 1.0 };
        let q1 = atan2(facing * wrist[1], facing * wrist[0]);
        // In the plane of the arm: `out` forward, `up` from the shoulder; angles from the vertical, forward positive.
        let (out, up) = (facing * radius, wrist[2] - self.base_to_shoulder);
        let forearm = (self.forearm * self.forearm + self.elbow_offset * self.elbow_offset).sqrt();
        let reach = (out * out + up * up).sqrt();
        let cosine =
            (reach * reach + self.upper_arm * self.upper_arm - forearm * forearm) / (2.0 * reach * self.upper_arm);
        if !(-1.0..=1.0).contains(&cosine) {
            return None;
        }
        let lift = acos(cosine) * facing * if branch.elbow_down { -1.0 } else { 1.0 };
        let q2 = atan2(out, up) - lift;
        let (sine, cosine) = sin_cos(q2);
        let to_wrist = atan2(out - self.upper_arm * sine, up - self.upper_arm * cosine);
        let q3 = half_turn(to_wrist - atan2(self.forearm, self.elbow_offset) - q2);
        let arm = product(&Axis::Z.rotation(q1), &Axis::Y.rotation(q2 + q3));
        let wrist = product(&transposed(&arm), &pose.rotation);
        let sine = (wrist[1][0] * wrist[1][0] + wrist[2][0] * wrist[2][0]).sqrt();
        let (q4, q5, q6) = if sine < 1e-9 {
            (0.0, atan2(sine, wrist[0][0]), atan2(wrist[2][1], wrist[1][1]))
        } else {
            let flip = if branch.wrist_flipped { -1.0 } else { 1.0 };
            (
                atan2(flip * wrist[1][0], -flip * wrist[2][0]),
                atan2(flip * sine, wrist[0][0]),
                atan2(flip * wrist[0][1], flip * wrist[0][2]),
            )
        };
        Some([q1, half_turn(q2), q3, q4, q5, q6])
    }

    /// Joint speeds that move the tool centre point with `velocity` (base frame) and do not turn the tool; None in a
    /// singular pose.
    pub fn joint_speeds(&self, q: &Joints, velocity: Vec3) -> Option<Joints> {
        let (origins, axes, _) = self.chain(q);
        let mut rows = [[0.0; 7]; 6];
        for joint in 0..6 {
            let linear = cross(axes[joint], add(origins[6], scale(origins[joint], -1.0)));
            for k in 0..3 {
                rows[k][joint] = linear[k];
                rows[k + 3][joint] = axes[joint][k];
            }
        }
        for k in 0..3 {
            rows[k][6] = velocity[k];
        }
        solve(rows)
    }
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
    let mut solution = [0.0; 6];
    for (k, value) in solution.iter_mut().enumerate() {
        *value = rows[k][6] / rows[k][k];
    }
    Some(solution)
}

#[derive(Clone, Copy)]
enum Axis {
    X,
    Y,
    Z,
}

impl Axis {
    fn rotation(self, angle: f64) -> Rotation {
        let (s, c) = sin_cos(angle);
        match self {
            Axis::X => [[1.0, 0.0, 0.0], [0.0, c, -s], [0.0, s, c]],
            Axis::Y => [[c, 0.0, s], [0.0, 1.0, 0.0], [-s, 0.0, c]],
            Axis::Z => [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]],
        }
    }
}

/// The same direction in (-pi, pi].
fn half_turn(angle: f64) -> f64 {
    if angle > PI {
        angle - 2.0 * PI
    } else if angle <= -PI {
        angle + 2.0 * PI
    } else {
        angle
    }
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

fn transposed(m: &Rotation) -> Rotation {
    [column(m, 0), column(m, 1), column(m, 2)]
}

#[cfg(test)]
mod tests {
    use super::*;

    fn assert_near(a: &[f64], b: &[f64], tolerance: f64) {
        for (x, y) in a.iter().zip(b) {
            assert!((x - y).abs() <= tolerance, "{a:?} is not {b:?}");
        }
    }

    #[test]
    fn zero_pose_by_hand() {
        // Upright upper arm: 0.3991 + 0.448 + 0.042 high; forearm, flange and tool forward: 0.451 + 0.082 + 0.100.
        let pose = IRB_1200.forward(&[0.0; 6]);
        assert_near(&pose.position, &[0.633, 0.0, 0.8891], 1e-15);
        assert_eq!(pose.rotation, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]);
    }

    #[test]
    fn bent_poses_by_hand() {
        let quarter = PI / 2.0;
        // Upper arm level forward (q2 = 90 deg), forearm then hanging straight down: offset points forward.
        let pose = IRB_1200.forward(&[0.0, quarter, 0.0, 0.0, 0.0, 0.0]);
        assert_near(&pose.position, &[0.448 + 0.042, 0.0, 0.3991 - 0.633], 1e-15);
        // Turned left by 90 deg, wrist bent down by 90 deg: the tool points down at the left of the base.
        let pose = IRB_1200.forward(&[quarter, 0.0, 0.0, 0.0, quarter, 0.0]);
        assert_near(&pose.position, &[0.0, 0.451, 0.8891 - 0.182], 1e-15);
        assert_near(&[pose.rotation[0][0], pose.rotation[1][0], pose.rotation[2][0]], &[0.0, 0.0, -1.0], 1e-15);
    }

    #[test]
    fn every_branch_of_the_inverse_leads_back_to_the_pose() {
        let mut branches_found = 0;
        for seed in 0..200_u32 {
            // Low-discrepancy joint angles over most of the ranges.
            let q: Joints = std::array::from_fn(|joint| {
                let part = (f64::from(seed) * [0.754, 0.569, 0.430, 0.324, 0.245, 0.184][joint]).fract();
                let (low, high) = irb1200::range(joint);
                low + part * (high - low)
            });
            let pose = IRB_1200.forward(&q);
            let mut matches = 0;
            for code in 0..8 {
                let branch =
                    Branch { shoulder_back: code & 1 != 0, elbow_down: code & 2 != 0, wrist_flipped: code & 4 != 0 };
                let Some(found) = IRB_1200.inverse(&pose, branch) else { continue };
                let again = IRB_1200.forward(&found);
                assert_near(&again.position, &pose.position, 1e-12);
                for (row, expected) in again.rotation.iter().zip(&pose.rotation) {
                    assert_near(row, expected, 1e-7);
                }
                branches_found += 1;
                let same = found.iter().zip(&q).all(|(a, b)| {
                    let turns = (a - b) / (2.0 * PI);
                    (turns - turns.round()).abs() < 1e-7
                });
                matches += usize::from(same);
            }
            // With a stretched wrist only the sum of joints 4 and 6 is determined.
            let stretched = q[4].abs() < 1e-6;
            assert!(matches >= 1 || stretched, "no branch returns the joint angles {q:?}");
        }
        assert!(branches_found > 1000);
    }

    #[test]
    fn elbow_up_is_the_higher_elbow() {
        let pose = Pose { position: [0.6, 0.1, 0.5], rotation: POINTING_DOWN };
        let up = IRB_1200.inverse(&pose, ELBOW_UP).unwrap();
        let down = IRB_1200.inverse(&pose, Branch { elbow_down: true, ..ELBOW_UP }).unwrap();
        assert!(IRB_1200.chain(&up).0[2][2] > IRB_1200.chain(&down).0[2][2] + 0.1);
        assert!(up[4] > 0.0);
    }

    #[test]
    fn out_of_reach_is_none() {
        assert_eq!(IRB_1200.inverse(&Pose { position: [1.2, 0.0, 0.4], rotation: POINTING_DOWN }, ELBOW_UP), None);
    }

    #[test]
    fn joint_speeds_move_the_tool_as_asked() {
        let q = [0.3, 0.4, 0.2, 0.5, 0.8, -0.3];
        let velocity = [0.7, -1.1, 0.4];
        let speeds = IRB_1200.joint_speeds(&q, velocity).unwrap();
        let step = 1e-6;
        let ahead: Joints = std::array::from_fn(|k| q[k] + step * speeds[k]);
        let behind: Joints = std::array::from_fn(|k| q[k] - step * speeds[k]);
        let (ahead, behind) = (IRB_1200.forward(&ahead), IRB_1200.forward(&behind));
        let measured = scale(add(ahead.position, scale(behind.position, -1.0)), 0.5 / step);
        assert_near(&measured, &velocity, 1e-8);
        for (row, other) in ahead.rotation.iter().zip(&behind.rotation) {
            assert_near(row, other, 1e-10);
        }
    }
}
