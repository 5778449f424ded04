//! Figures of the robot in the feed-opening cell: an ABB IRB 1200-5/0.9, SI units.
//!
//! Source: the maker's figures as published in the ROS-Industrial description of that robot (joint origins, axes,
//! limits, speeds). Zero pose: upper arm upright, forearm horizontal and pointing forward (+x of the base frame).

/// Height of the shoulder axes (joints 1 and 2 meet there) above the base frame, m.
pub const BASE_TO_SHOULDER: f64 = 0.3991;
/// Length of the upper arm, joint 2 to joint 3, m.
pub const UPPER_ARM: f64 = 0.448;
/// How far the forearm axis lies above joint 3 in the zero pose, m.
pub const ELBOW_OFFSET: f64 = 0.042;
/// Length of the forearm along its axis, joint 4 to the wrist centre, m.
pub const FOREARM: f64 = 0.451;
/// Wrist centre to flange, m.
pub const WRIST_TO_FLANGE: f64 = 0.082;
/// Flange to tool centre point, along the flange axis, m (the cell's gripper, not the robot maker's figure).
pub const TOOL: f64 = 0.10;

/// Joint ranges (lower, upper), degrees.
const RANGES_DEG: [(f64, f64); 6] =
    [(-170.0, 170.0), (-100.0, 130.0), (-200.0, 70.0), (-270.0, 270.0), (-130.0, 130.0), (-360.0, 360.0)];
/// Highest joint speeds, degrees per second.
const SPEEDS_DEG: [f64; 6] = [288.0, 240.0, 300.0, 400.0, 405.0, 600.0];

/// The range (lower, upper) of joint 0..6, rad.
pub const fn range(joint: usize) -> (f64, f64) {
    (RANGES_DEG[joint].0.to_radians(), RANGES_DEG[joint].1.to_radians())
}

/// The highest speed of joint 0..6, rad/s.
pub const fn max_speed(joint: usize) -> f64 {
    SPEEDS_DEG[joint].to_radians()
}
