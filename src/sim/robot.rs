//! The robot at one instant: placed link shapes, their velocities, and how hard it would strike.

use crate::cell::{Binding, Workcell};
use crate::geometry::chain::Twist;
use crate::geometry::{Solid, Vec3};
use crate::hazard::Strike;

/// The robot after one communication step.
#[derive(Clone, Debug)]
pub struct RobotFrame {
    /// Link shapes in world coordinates, in the order of [`Workcell::links`].
    pub links: Vec<Solid>,
    /// Velocity of each shape.
    twists: Vec<Twist>,
    /// Upper bound on the speed of any point of each shape, m/s.
    pub speed_bounds: Vec<f64>,
    /// Largest entry of `speed_bounds`, m/s.
    pub fastest: f64,
    /// Effective mass and force ratios.
    pub strike: Strike,
    /// Programme phase, where the cell names one.
    pub phase: Option<i64>,
}

impl RobotFrame {
    /// The robot for one row of FMU outputs.
    #[must_use]
    pub fn new(cell: &Workcell, binding: &Binding, outputs: &[f64]) -> Self {
        let angles: Vec<f64> = binding.angles.iter().map(|r| r.read(outputs)).collect();
        let speeds: Vec<f64> = binding.speeds.iter().map(|r| r.read(outputs)).collect();
        let placed = cell.chain.place(&angles);
        let joint_twists = placed.twists(&speeds);
        let links: Vec<Solid> = cell.links.iter().map(|l| l.shape.placed(placed.world_from_link[l.joint])).collect();
        let twists: Vec<Twist> = cell.links.iter().map(|l| joint_twists[l.joint]).collect();
        let speed_bounds: Vec<f64> = links.iter().zip(&twists).map(|(s, t)| speed_bound(s, t)).collect();
        let fastest = speed_bounds.iter().copied().fold(0.0, f64::max);
        let strike = Strike::new(cell.moving_mass_kg, binding.payload.read(outputs));
        #[expect(clippy::cast_possible_truncation, reason = "an FMI integer")]
        let phase = binding.phase.as_ref().map(|r| r.read(outputs) as i64);
        Self { links, twists, speed_bounds, fastest, strike, phase }
    }

    /// Velocity of the point of shape `link` at world position `point`, m/s.
    #[must_use]
    pub fn velocity(&self, link: usize, point: Vec3) -> Vec3 {
        self.twists[link].velocity_at(point)
    }

    /// Upper bound on the speed of points of shape `link` within `radius` of `point`, m/s.
    #[must_use]
    pub fn speed_bound_near(&self, link: usize, point: Vec3, radius: f64) -> f64 {
        let near = self.velocity(link, point).length() + self.twists[link].angular.length() * radius;
        near.min(self.speed_bounds[link])
    }
}

/// Speed is a convex function of the point, so over a capsule its core ends bound the core, and the radius adds
/// `|omega| r`; over a hull the bounding sphere does.
fn speed_bound(solid: &Solid, twist: &Twist) -> f64 {
    let (speed, radius) = match solid {
        Solid::Capsule(c) => (twist.velocity_at(c.a).length().max(twist.velocity_at(c.b).length()), c.radius),
        Solid::Hull(_) => {
            let (centre, radius) = solid.bounding_sphere();
            (twist.velocity_at(centre).length(), radius)
        }
    };
    speed + twist.angular.length() * radius
}
