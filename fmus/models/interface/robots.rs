//! The robots of the example cells: joint origins and axes, ranges and speeds, SI units unless a name says otherwise.
//!
//! All frames are aligned in the zero pose, so a joint is an offset from the one before and an axis. Sources: the
//! ROS-Industrial descriptions of the IRB 1200-5/0.9 and the KR 16-2, the maker's descriptions of CRX-10iA/L, UR5e and
//! UR10e (offsets and speeds only). The tool of 0.10 m is the cells' own.

/// A joint axis in the common zero pose.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Axis {
    /// +x
    X,
    /// +y
    Y,
    /// +z
    Z,
    /// -y
    NegY,
    /// -z
    NegZ,
}

/// A six-axis robot.
#[derive(Debug)]
pub struct Robot {
    /// Maker's name.
    pub name: &'static str,
    /// Origin of each joint from the one before (the first from the base frame), m, and its axis.
    pub joints: [([f64; 3], Axis); 6],
    /// Tool centre point in the frame of the last joint, m.
    pub tool: [f64; 3],
    /// Joint ranges (lower, upper), degrees.
    pub ranges_deg: [(f64, f64); 6],
    /// Highest joint speeds, degrees per second.
    pub speeds_deg: [f64; 6],
}

impl Robot {
    /// The range (lower, upper) of joint 0..6, rad.
    pub const fn range(&self, joint: usize) -> (f64, f64) {
        (self.ranges_deg[joint].0.to_radians(), self.ranges_deg[joint].1.to_radians())
    }

    /// The highest speed of joint 0..6, rad/s.
    pub const fn max_speed(&self, joint: usize) -> f64 {
        self.speeds_deg[joint].to_radians()
    }
}

/// ABB IRB 1200-5/0.9: zero pose with the upper arm upright and the forearm along +x.
pub const IRB_1200: Robot = Robot {
    name: "IRB 1200-5/0.9",
    joints: [
        ([0.0, 0.0, 0.3991], Axis::Z),
        ([0.0, 0.0, 0.0], Axis::Y),
        ([0.0, 0.0, 0.448], Axis::Y),
        ([0.0, 0.0, 0.042], Axis::X),
        ([0.451, 0.0, 0.0], Axis::Y),
        ([0.082, 0.0, 0.0], Axis::X),
    ],
    tool: [0.10, 0.0, 0.0],
    ranges_deg: [(-170.0, 170.0), (-100.0, 130.0), (-200.0, 70.0), (-270.0, 270.0), (-130.0, 130.0), (-360.0, 360.0)],
    speeds_deg: [288.0, 240.0, 300.0, 400.0, 405.0, 600.0],
};

/// KUKA KR 16-2, in the same zero pose.
pub const KR_16: Robot = Robot {
    name: "KR 16-2",
    joints: [
        ([0.0, 0.0, 0.675], Axis::Z),
        ([0.26, 0.0, 0.0], Axis::Y),
        ([0.0, 0.0, 0.68], Axis::Y),
        ([0.0, 0.0, 0.035], Axis::X),
        ([0.67, 0.0, 0.0], Axis::Y),
        ([0.158, 0.0, 0.0], Axis::X),
    ],
    tool: [0.10, 0.0, 0.0],
    ranges_deg: [(-185.0, 185.0), (-65.0, 125.0), (-220.0, 64.0), (-350.0, 350.0), (-130.0, 130.0), (-350.0, 350.0)],
    speeds_deg: [156.0, 156.0, 156.0, 330.0, 330.0, 615.0],
};

/// FANUC CRX-10iA/L, in the same zero pose; the last two axes do not meet. The maker allows 120 and 180 degrees a
/// second; the cell of the sensor mat runs its programme of 2.0 m/s past the base at 0.45 m, which needs 4.4 rad/s of
/// the first axis, so its main axes are given the speeds of the IRB 1200.
pub const CRX_10IA_L: Robot = Robot {
    name: "CRX-10iA/L",
    joints: [
        ([0.0, 0.0, 0.245], Axis::Z),
        ([0.0, 0.0, 0.0], Axis::Y),
        ([0.0, 0.0, 0.710], Axis::Y),
        ([0.0, 0.0, 0.0], Axis::X),
        ([0.540, 0.0, 0.0], Axis::Y),
        ([0.160, 0.150, 0.0], Axis::X),
    ],
    tool: [0.10, 0.0, 0.0],
    ranges_deg: [(-180.0, 180.0), (-180.0, 180.0), (-270.0, 270.0), (-190.0, 190.0), (-180.0, 180.0), (-190.0, 190.0)],
    speeds_deg: [300.0, 300.0, 300.0, 400.0, 405.0, 600.0],
};

/// A UR arm from its Denavit-Hartenberg lengths: zero pose stretched along -x, the flange pointing along -y.
const fn ur(name: &'static str, d1: f64, a: [f64; 2], d: [f64; 3], speeds_deg: [f64; 6]) -> Robot {
    Robot {
        name,
        joints: [
            ([0.0, 0.0, d1], Axis::Z),
            ([0.0, 0.0, 0.0], Axis::NegY),
            ([-a[0], 0.0, 0.0], Axis::NegY),
            ([-a[1], 0.0, 0.0], Axis::NegY),
            ([0.0, -d[0], 0.0], Axis::NegZ),
            ([0.0, 0.0, -d[1]], Axis::NegY),
        ],
        tool: [0.0, -d[2] - 0.10, 0.0],
        ranges_deg: [(-360.0, 360.0); 6],
        speeds_deg,
    }
}

/// Universal Robots UR5e.
pub const UR5E: Robot = ur("UR5e", 0.1625, [0.425, 0.3922], [0.1333, 0.0997, 0.0996], [180.0; 6]);

/// Universal Robots UR10e.
pub const UR10E: Robot =
    ur("UR10e", 0.1807, [0.6127, 0.571_55], [0.174_15, 0.119_85, 0.116_55], [120.0, 120.0, 180.0, 180.0, 180.0, 180.0]);
