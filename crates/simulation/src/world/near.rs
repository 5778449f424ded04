//! How near people get to each robot in an action, whatever they could do there: what a result rests on that says nobody is hit.

use super::{Frames, World};
use crate::Coverage;
use crate::bound::RobotBounds;
use crate::geometry::Vec3;
use crate::human::Who;
use crate::human::walk::WalkTrace;
use crate::robot::RobotFrame;

impl World {
    /// Nothing seen yet of the cell, but which robots are within reach by lengths alone.
    #[must_use]
    pub fn nothing_seen(&self) -> Coverage {
        let mut coverage = crate::nothing_seen(&self.cell);
        let actions = usize::try_from(self.cell.search.actions).unwrap_or(usize::MAX);
        for own in self.people() {
            let reachable = RobotBounds::new(&own.cell).each(own.position(&own.start()), own.reach_m(), actions);
            for (robot, reachable) in reachable.into_iter().enumerate() {
                coverage.robot(robot).reachable |= reachable;
            }
        }
        coverage
    }

    /// Counts for each robot the instants of an action, so many before it, at which somebody was near it, or could have walked to it. And
    /// takes in how fast it is told to be.
    pub(crate) fn count_near(
        &self,
        walks: &[(Who, &WalkTrace)],
        before: usize,
        frames: &Frames,
        coverage: &mut Coverage,
    ) {
        for (i, frame) in frames.iter().enumerate() {
            let (mut near, mut walkable) = (vec![false; self.cell.robots.len()], vec![false; self.cell.robots.len()]);
            #[expect(clippy::cast_precision_loss, reason = "at most 64 000 steps")]
            let time_s = (before * self.cell.steps_per_action + i + 1) as f64 * self.cell.step_s;
            for (who, walked) in walks {
                let own = self.of(*who).unwrap_or(&self.first);
                let (at, reach_m) = (own.position(&walked.places[i]) + Vec3::Z, own.reach_m());
                let start = own.position(&own.start()) + Vec3::Z;
                for link in 0..frame.links.len() {
                    let robot = frame.robot(link);
                    near[robot] = near[robot] || is_within(frame, link, at, reach_m);
                    let walk_m = own.fastest_m_s() * time_s;
                    walkable[robot] = walkable[robot] || is_within(frame, link, start, reach_m + walk_m);
                }
            }
            for (robot, (near, walkable)) in near.into_iter().zip(walkable).enumerate() {
                let figures = coverage.robot(robot);
                figures.instants_in_reach += u64::from(near);
                figures.instants_to_walk_to += u64::from(walkable);
            }
            for (link, speed_m_s) in frame.speed_bounds.iter().enumerate() {
                let figures = coverage.robot(frame.robot(link));
                figures.top_speed_m_s = figures.top_speed_m_s.max(*speed_m_s);
            }
        }
    }
}

/// Whether a link is no farther than so from a point.
fn is_within(frame: &RobotFrame, link: usize, point: Vec3, within_m: f64) -> bool {
    let solid = &frame.links[link];
    let (centre, radius) = solid.bounding_sphere();
    (centre - point).length() - radius <= within_m && solid.point_distance(point).distance <= within_m
}
