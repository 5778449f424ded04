//! How far robots and person can come at all: from lengths alone, never from what was observed.
//!
//! Revolute joints cannot bring a point farther from the first of them than the lengths of the segments between add up
//! to; the person walks at 1.6 m/s, or runs as fast as the cell file says, and is within a sphere around the middle of the body. So a state may be dropped when
//! the two cannot meet in the time that is left. Where parts slide, or the FMU itself
//! gives their poses, nothing bounds them, and nothing is dropped.

use crate::cell::Workcell;
use crate::cell::workcell::{Link, Robot};
use crate::geometry::Vec3;
use crate::geometry::kinematics::Motion;
use crate::human::action::ACTION_S;
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Rounding of positions and lengths, generously, m.
const ROUNDING_M: f64 = 1e-6;

/// Balls that the robots cannot leave.
#[derive(Clone, Debug, PartialEq)]
pub struct RobotBounds {
    /// Centre, world, and radius, m, of each robot; nothing if it is not bounded.
    balls: Vec<Option<(Vec3, f64)>>,
    /// How fast the person gets on, m/s.
    person_m_s: f64,
}

impl RobotBounds {
    /// The bounds that follow from a cell.
    #[must_use]
    pub fn new(cell: &Workcell) -> Self {
        let person_m_s = f64::from(cell.repertoire.strides()) * WALKING_SPEED_M_S;
        // How far a robot has to stay away is known from its stops only.
        if cell.separation.is_some() {
            return Self { balls: vec![None; cell.robots.len()], person_m_s };
        }
        let ball = |(index, robot): (usize, &Robot)| {
            let links: Vec<&Link> = cell.links.iter().filter(|l| l.robot == index).collect();
            bound(robot, &links)
        };
        Self { balls: cell.robots.iter().enumerate().map(ball).collect(), person_m_s }
    }

    /// Whether a person at `position` (floor plan), no part of which is farther than `reach_m` from the point 1 m above,
    /// may touch a robot within `actions` actions.
    #[must_use]
    pub fn may_meet(&self, position: Vec3, reach_m: f64, actions: usize) -> bool {
        self.balls.iter().any(|ball| self.may_touch_in(ball, position, reach_m, actions))
    }

    /// The same of each robot by itself.
    pub(super) fn each(&self, position: Vec3, reach_m: f64, actions: usize) -> Vec<bool> {
        self.balls.iter().map(|ball| self.may_touch_in(ball, position, reach_m, actions)).collect()
    }

    fn may_touch_in(&self, ball: &Option<(Vec3, f64)>, position: Vec3, reach_m: f64, actions: usize) -> bool {
        #[expect(clippy::cast_precision_loss, reason = "a few dozen")]
        let walk = self.person_m_s * ACTION_S * actions as f64;
        let Some((centre, radius)) = ball else { return true };
        let to = *centre - (position + Vec3::Z);
        let along = (libm::hypot(to.x, to.y) - walk).max(0.0);
        libm::hypot(along, to.z) <= radius + reach_m + ROUNDING_M
    }
}

fn bound(robot: &Robot, links: &[&Link]) -> Option<(Vec3, f64)> {
    let joints = &robot.kinematics.as_ref()?.tree.joints;
    // What slides could slide as far as the FMU says.
    if joints.iter().any(|joint| joint.motion == Motion::Prismatic) {
        return None;
    }
    let roots = joints.iter().filter(|joint| joint.parent.is_none()).count();
    // A single first joint does not move; several have the base in common.
    let (centre, offset) = match joints.first()? {
        first if roots == 1 => ((robot.world_from_base * first.parent_from_joint).translation, 0.0),
        _ => (robot.world_from_base.translation, 1.0),
    };
    let mut lengths: Vec<f64> = Vec::with_capacity(joints.len());
    for joint in joints {
        let own = joint.parent_from_joint.translation.length();
        lengths.push(joint.parent.map_or(offset * own, |parent| lengths[parent] + own));
    }
    let farthest = |link: &&Link| {
        let (middle, radius) = link.shape.bounding_sphere();
        lengths[link.joint] + middle.length() + radius
    };
    Some((centre, links.iter().map(farthest).fold(0.0, f64::max)))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use rand_core::{Rng, SeedableRng};
    use rand_pcg::Pcg64;

    use super::*;
    use crate::cell::find::open;
    use crate::geometry::Solid;

    /// Random joint angles of the example robots never leave their ball, and some come near its surface.
    #[test]
    fn no_pose_leaves_the_ball() {
        let folder = tempfile::tempdir().unwrap();
        fmi_hazard_examples::export(folder.path()).unwrap();
        let mut random = Pcg64::seed_from_u64(3);
        for name in ["safety-fence", "sensor-mat", "light-curtain", "two-scanners", "heavy-workpiece"] {
            let cell = open(&folder.path().join(name).join("cell.toml"), None).unwrap().cell;
            let bounds = RobotBounds::new(&cell);
            let balls: Vec<(Vec3, f64)> = bounds.balls.iter().map(|ball| ball.unwrap()).collect();
            for (index, robot) in cell.robots.iter().enumerate() {
                let tree = &robot.kinematics.as_ref().unwrap().tree;
                let mut farthest: f64 = 0.0;
                for _ in 0..2000 {
                    let angle = |_: &_| f64::from(random.next_u32()) / f64::from(u32::MAX) * std::f64::consts::TAU;
                    let angles: Vec<f64> = tree.joints.iter().map(angle).collect();
                    let placed = tree.place(&angles);
                    for link in cell.links.iter().filter(|l| l.robot == index) {
                        let Solid::Capsule(c) = link.shape.placed(placed.world_from_link[link.joint]) else { continue };
                        for end in [c.a, c.b] {
                            farthest = farthest.max((end - balls[index].0).length() + c.radius);
                        }
                    }
                }
                assert!(farthest <= balls[index].1, "{name}: {farthest} m beyond {} m", balls[index].1);
                assert!(farthest > 0.7 * balls[index].1, "{name}: {farthest} m of {} m", balls[index].1);
            }
        }
        let cell = open(Path::new(&folder.path().join("head-collision/cell.toml")), None).unwrap().cell;
        assert!(RobotBounds::new(&cell).may_meet(Vec3::splat(1e6), 1.0, 1), "the FMU gives poses: no bound");
    }

    #[test]
    fn distance_speed_and_reach_by_hand() {
        let bounds = RobotBounds { balls: vec![Some((Vec3::new(0.0, 0.0, 1.0), 1.0))], person_m_s: 1.6 };
        // 1 m of robot, 1.2 m of person, 0.32 m of walking an action.
        assert!(bounds.may_meet(Vec3::new(3.15, 0.0, 0.0), 1.2, 3));
        assert!(!bounds.may_meet(Vec3::new(3.17, 0.0, 0.0), 1.2, 3));
        assert!(bounds.may_meet(Vec3::new(0.0, -3.47, 0.0), 1.2, 4));
        let high = RobotBounds { balls: vec![Some((Vec3::new(0.0, 0.0, 3.3), 1.0))], person_m_s: 1.6 };
        assert!(!high.may_meet(Vec3::ZERO, 1.2, 5) && high.may_meet(Vec3::ZERO, 1.4, 0));
        // Who runs at 4.8 m/s gets 0.96 m an action.
        let runs = RobotBounds { person_m_s: 4.8, ..bounds };
        assert!(runs.may_meet(Vec3::new(5.07, 0.0, 0.0), 1.2, 3));
        assert!(!runs.may_meet(Vec3::new(5.09, 0.0, 0.0), 1.2, 3));
        // Of two that are far apart each by itself; what is not bounded may be anywhere.
        let balls = vec![Some((Vec3::Z, 1.0)), Some((Vec3::new(9.0, 0.0, 1.0), 1.0)), None];
        let three = RobotBounds { balls, person_m_s: 1.6 };
        assert_eq!(three.each(Vec3::new(3.15, 0.0, 0.0), 1.2, 3), [true, false, true]);
    }
}
