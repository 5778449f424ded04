//! A robot's programme: a closed polyline of the tool centre point with a speed per leg, timed once for all.
//!
//! The tool keeps its orientation, stops at each corner and moves along each leg as fast as four limits allow: the
//! programmed speed, an acceleration along the path, and the speeds and accelerations of the joints. Timing is the
//! reachability method for path parameterisation (Pham and Pham 2018): on a grid along the leg, with u the square of
//! the path speed and a its acceleration, u is first bounded from the end backwards, then raised greedily forwards.
//! Between grid points the acceleration is constant, so place and speed are exact integrals of each other.

use crate::interface::robots::Robot;
use crate::interface::workcell::{Leg as Programmed, RobotSpec};
use crate::kinematics::{Chain, Joints, Pose, Rotation, Vec3, add, norm, scale};

/// Greatest acceleration of the tool along the path, m/s^2.
pub const MAX_PATH_ACCELERATION: f64 = 15.0;

/// Times in which a main axis and a wrist axis reach their full speed, s. Makers do not publish accelerations; these
/// fit the published cycle times of robots of this size.
const SPEED_UP: [f64; 6] = [0.10, 0.10, 0.10, 0.08, 0.08, 0.08];

/// Distance of grid points along a leg, m (at most).
const GRID: f64 = 0.002;

/// The timed programme. Never changes; instances share one.
#[derive(Debug)]
pub struct Path {
    robot: &'static Robot,
    rotation: Rotation,
    legs: Vec<Leg>,
}

#[derive(Debug)]
struct Leg {
    start: Vec3,
    direction: Vec3,
    /// How long it takes at full pace, s.
    duration: f64,
    /// Programmed speed, m/s.
    programmed: f64,
    /// Mass of the workpiece, kg.
    carries: f64,
    /// Whether it is slowed down to the speed of approach.
    approach: bool,
    /// At each grid point.
    knots: Vec<Knot>,
}

#[derive(Debug, Clone, Copy)]
struct Knot {
    /// Since the leg began, s.
    time: f64,
    /// From the start of the leg, m.
    distance: f64,
    /// Along the path, m/s.
    speed: f64,
    /// Joint angles, from which those nearby are found.
    q: Joints,
}

/// Where the robot is at some programme time, and how fast it would move at full pace.
#[derive(Debug, Clone, Copy)]
pub struct Motion {
    /// Leg, counted from 0.
    pub leg: usize,
    /// Tool centre point, base frame, m.
    pub position: Vec3,
    /// Its velocity, m/s.
    pub velocity: Vec3,
    /// Joint angles, rad.
    pub q: Joints,
    /// Joint speeds, rad/s.
    pub qd: Joints,
    /// The arm in this pose.
    pub chain: Chain,
    /// Speed of the tool centre point, m/s.
    pub tcp_speed: f64,
    /// Mass of the workpiece, kg.
    pub carries: f64,
}

impl Path {
    /// Times the programme of a robot; None if it leaves the reach, passes a singular pose, has a leg of no length or
    /// does not come back to its start.
    pub fn new(spec: &RobotSpec) -> Option<Self> {
        let mut path = Self { robot: spec.robot, rotation: spec.rotation, legs: Vec::new() };
        let mut at = spec.start;
        let mut q = path.angles(at, &spec.near)?;
        for leg in spec.legs {
            let knots = path.time_leg(at, leg, &q)?;
            let last = knots.last()?;
            let duration = last.time;
            q = last.q;
            let direction = direction(at, leg.end)?;
            let (programmed, carries, approach) = (leg.speed, leg.carries, leg.approach);
            path.legs.push(Leg { start: at, direction, duration, programmed, carries, approach, knots });
            at = leg.end;
        }
        (at == spec.start).then_some(path)
    }

    /// Duration of one cycle, s, if approaches are no faster than `v_approach`, m/s.
    fn cycle_time(&self, v_approach: f64) -> f64 {
        self.legs.iter().fold(0.0, |time, leg| time + leg.duration / leg.pace(v_approach))
    }

    /// The motion at a programme time (s, taken modulo the cycle), if approaches are no faster than `v_approach`, m/s.
    pub fn at(&self, programme_time: f64, v_approach: f64) -> Motion {
        let time = programme_time.rem_euclid(self.cycle_time(v_approach));
        let (mut leg_number, mut begins) = (0, 0.0);
        for (number, leg) in self.legs.iter().enumerate().take(self.legs.len() - 1) {
            let ends = begins + leg.duration / leg.pace(v_approach);
            if time < ends {
                break;
            }
            (leg_number, begins) = (number + 1, ends);
        }
        let leg = &self.legs[leg_number];
        let pace = leg.pace(v_approach);
        let (distance, speed, near) = leg.place((time - begins) * pace);
        let speed = speed * pace;
        let position = add(leg.start, scale(leg.direction, distance));
        let velocity = scale(leg.direction, speed);
        // Both exist on the whole path: `new` has solved them on the grid, and the path keeps clear of the limits.
        let q = self.angles(position, near).unwrap_or([f64::NAN; 6]);
        let chain = self.robot.place(&q);
        let qd = chain.joint_speeds(velocity, [0.0; 3]).unwrap_or([f64::NAN; 6]);
        Motion { leg: leg_number, position, velocity, q, qd, chain, tcp_speed: speed, carries: leg.carries }
    }

    fn angles(&self, position: Vec3, near: &Joints) -> Option<Joints> {
        self.robot.angles(&Pose { position, rotation: self.rotation }, near)
    }
}

fn direction(from: Vec3, to: Vec3) -> Option<Vec3> {
    let vector = add(to, scale(from, -1.0));
    let length = norm(vector);
    (length > 0.0).then(|| scale(vector, 1.0 / length))
}

impl Leg {
    /// Seconds of the leg as it is timed per second. It begins and ends at rest, so slowed down it is still without jumps.
    fn pace(&self, v_approach: f64) -> f64 {
        if self.approach { (v_approach / self.programmed).min(1.0) } else { 1.0 }
    }

    /// Distance from the start of the leg and path speed, `time` seconds after its beginning, and joint angles nearby.
    fn place(&self, time: f64) -> (f64, f64, &Joints) {
        let next = self.knots.partition_point(|knot| knot.time <= time).clamp(1, self.knots.len() - 1);
        let (from, to) = (&self.knots[next - 1], &self.knots[next]);
        let acceleration = (to.speed - from.speed) / (to.time - from.time);
        let elapsed = (time - from.time).clamp(0.0, to.time - from.time);
        (
            from.distance + from.speed * elapsed + acceleration * elapsed * elapsed / 2.0,
            from.speed + acceleration * elapsed,
            &from.q,
        )
    }
}

/// Limits on (u, a) at one grid point: u <= u_max, |a| <= MAX_PATH_ACCELERATION, |rate a + bend u| <= limit per joint,
/// where rate and bend are the first and second derivatives of the joint angle by the distance.
struct Limits {
    u_max: f64,
    rate: Joints,
    bend: Joints,
    /// Greatest joint accelerations, rad/s^2.
    most: Joints,
}

impl Limits {
    /// The accelerations allowed at u; the interval is empty (low > high) if u is too high.
    fn accelerations(&self, u: f64) -> (f64, f64) {
        let (mut low, mut high) = (-MAX_PATH_ACCELERATION, MAX_PATH_ACCELERATION);
        for ((&rate, &bend), &limit) in self.rate.iter().zip(&self.bend).zip(&self.most) {
            if rate.abs() < 1e-9 {
                if (bend * u).abs() > limit {
                    return (f64::INFINITY, f64::NEG_INFINITY);
                }
                continue;
            }
            let (a, b) = ((-limit - bend * u) / rate, (limit - bend * u) / rate);
            low = low.max(a.min(b));
            high = high.min(a.max(b));
        }
        (low, high)
    }

    /// The greatest u from which the next point can be reached at no more than `next`. All limits are linear in u and
    /// a, and u = 0 fulfils them, so the good values of u are an interval from 0: bisection finds its end.
    fn controllable(&self, next: f64, spacing: f64) -> f64 {
        let good = |u: f64| {
            let (low, high) = self.accelerations(u);
            low <= high && u + 2.0 * spacing * low <= next
        };
        if good(self.u_max) {
            return self.u_max;
        }
        let (mut low, mut high) = (0.0, self.u_max);
        for _ in 0..60 {
            let middle = (low + high) / 2.0;
            if good(middle) {
                low = middle;
            } else {
                high = middle;
            }
        }
        low
    }
}

impl Path {
    /// Times one leg that begins at `start` with joint angles `q`.
    fn time_leg(&self, start: Vec3, leg: &Programmed, q: &Joints) -> Option<Vec<Knot>> {
        let direction = direction(start, leg.end)?;
        let length = norm(add(leg.end, scale(start, -1.0)));
        let mut cells = 1_u32;
        while length / f64::from(cells) > GRID {
            cells += 1;
        }
        let spacing = length / f64::from(cells);
        let most = std::array::from_fn(|joint| self.robot.max_speed(joint) / SPEED_UP[joint]);
        let (mut limits, mut angles) = (Vec::new(), vec![*q]);
        for k in 0..=cells {
            let near = *angles.last()?;
            let at = |distance: f64| self.angles(add(start, scale(direction, distance)), &near);
            let rate_at = |q: &Joints| self.robot.place(q).joint_speeds(direction, [0.0; 3]);
            let distance = f64::from(k) * spacing;
            let q = at(distance)?;
            let rate = rate_at(&q)?;
            let (ahead, behind) = (rate_at(&at(distance + 1e-5)?)?, rate_at(&at(distance - 1e-5)?)?);
            let bend = std::array::from_fn(|joint| (ahead[joint] - behind[joint]) / 2e-5);
            let mut top = leg.speed;
            for (joint, rate) in rate.iter().enumerate() {
                top = top.min(self.robot.max_speed(joint) / rate.abs().max(1e-9));
            }
            limits.push(Limits { u_max: top * top, rate, bend, most });
            angles.push(q);
        }
        angles.remove(0);
        timed(&limits, &angles, spacing)
    }
}

/// The fastest timing of a leg within the limits at its grid points.
fn timed(limits: &[Limits], angles: &[Joints], spacing: f64) -> Option<Vec<Knot>> {
    // Backwards: from where on can the robot still stop at the end?
    let mut bound = vec![0.0; limits.len()];
    for k in (0..limits.len() - 1).rev() {
        bound[k] = limits[k].controllable(bound[k + 1], spacing);
    }
    // Forwards: as fast as that allows.
    let (mut u, mut knots) = (0.0_f64, vec![Knot { time: 0.0, distance: 0.0, speed: 0.0, q: *angles.first()? }]);
    for (k, (limit, bound)) in limits.iter().zip(bound.iter().skip(1)).enumerate() {
        let (_, acceleration) = limit.accelerations(u);
        let next = (u + 2.0 * spacing * acceleration).min(*bound).max(0.0);
        let (from, to) = (u.sqrt(), next.sqrt());
        if from + to <= 0.0 {
            return None;
        }
        let time = knots[k].time + 2.0 * spacing / (from + to);
        let distance = knots[k].distance + spacing;
        knots.push(Knot { time, distance, speed: to, q: angles[k + 1] });
        u = next;
    }
    Some(knots)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::robots::IRB_1200;
    use crate::interface::workcell::{POINTING_DOWN, leg};
    use crate::interface::{WORKCELLS, safety_fence};

    fn to_and_fro(from: Vec3, to: Vec3, speed: f64) -> Option<Path> {
        let legs: &'static [Programmed] = Box::leak(Box::new([leg(to, speed), leg(from, speed)]));
        let first = &safety_fence::SPEC.robots[0];
        Path::new(&RobotSpec {
            suffix: "",
            robot: &IRB_1200,
            rotation: POINTING_DOWN,
            near: first.near,
            start: from,
            legs,
            tool_kg: 1.0,
        })
    }

    #[test]
    fn a_straight_leg_takes_the_time_of_a_trapezoid() {
        // Slow and far from any joint limit: t = length / v + v / a.
        let path = to_and_fro([0.5, 0.0, 0.6], [0.5, 0.0, 0.8], 0.4).unwrap();
        let expected = 2.0 * (0.2 / 0.4 + 0.4 / MAX_PATH_ACCELERATION);
        assert!(
            (path.cycle_time(f64::INFINITY) - expected).abs() < 2e-3,
            "{} s, expected {expected} s",
            path.cycle_time(f64::INFINITY)
        );
    }

    #[test]
    fn a_joint_limit_slows_a_leg_down() {
        // Past the first axis at 0.25 m: 2 m/s would need 8 rad/s, the joint turns at 5.03.
        let path = to_and_fro([0.25, -0.3, 0.6], [0.25, 0.3, 0.6], 2.0).unwrap();
        let mut fastest: f64 = 0.0;
        let mut time = 0.0;
        while time < path.cycle_time(f64::INFINITY) {
            let motion = path.at(time, f64::INFINITY);
            for joint in 0..6 {
                assert!(motion.qd[joint].abs() <= IRB_1200.max_speed(joint) * 1.001, "joint {joint} at {time} s");
            }
            fastest = fastest.max(motion.qd[0].abs());
            time += 1e-3;
        }
        assert!(fastest > 0.98 * IRB_1200.max_speed(0), "the limit is not used: {fastest} rad/s");
    }

    #[test]
    fn out_of_reach_and_open_programmes_are_refused() {
        assert!(to_and_fro([0.5, 0.0, 0.6], [1.5, 0.0, 0.6], 1.0).is_none());
        let first = &safety_fence::SPEC.robots[0];
        let open = RobotSpec { legs: &first.legs[..3], rotation: POINTING_DOWN, suffix: "", ..*first };
        assert!(Path::new(&open).is_none());
    }

    /// Distance of a point from the programme's polyline, computed without the code under test.
    fn off_the_polyline(spec: &RobotSpec, point: Vec3) -> f64 {
        let ends: Vec<Vec3> = std::iter::once(spec.start).chain(spec.legs.iter().map(|leg| leg.end)).collect();
        ends.windows(2)
            .map(|ends| {
                let along = add(ends[1], scale(ends[0], -1.0));
                let to = add(point, scale(ends[0], -1.0));
                let dot = |a: Vec3, b: Vec3| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                let part = (dot(to, along) / dot(along, along)).clamp(0.0, 1.0);
                norm(add(to, scale(along, -part)))
            })
            .fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn every_programme_keeps_to_its_polyline_within_all_limits_without_jumps() {
        for spec in WORKCELLS.iter().flat_map(|cell| cell.robots) {
            let path = Path::new(spec).unwrap_or_else(|| panic!("{} cannot be run", spec.robot.name));
            let robot = spec.robot;
            let mut before = path.at(0.0, f64::INFINITY);
            let mut legs = vec![0];
            let mut time = 0.0;
            while time < path.cycle_time(f64::INFINITY) {
                let motion = path.at(time, f64::INFINITY);
                let chain = robot.place(&motion.q);
                assert!(off_the_polyline(spec, chain.origins[6]) < 1e-9, "{} at {time} s", robot.name);
                for (row, expected) in chain.rotations[5].iter().zip(&spec.rotation) {
                    assert!(row.iter().zip(expected).all(|(a, b)| (a - b).abs() < 1e-9), "{} at {time} s", robot.name);
                }
                assert!(motion.tcp_speed <= spec.legs[motion.leg].speed * (1.0 + 1e-12), "too fast at {time} s");
                for joint in 0..6 {
                    let (low, high) = robot.range(joint);
                    assert!(low < motion.q[joint] && motion.q[joint] < high, "{} joint {joint}", robot.name);
                    assert!(motion.qd[joint].abs() <= robot.max_speed(joint) * 1.001, "{} joint {joint}", robot.name);
                    // The trapezoid of the speeds over 1 ms against the difference of the angles: off by no more than
                    // a jump of the acceleration within the millisecond.
                    let by_speed = (motion.qd[joint] + before.qd[joint]) / 2.0 * 1e-3;
                    let off = (motion.q[joint] - before.q[joint] - by_speed).abs();
                    assert!(time == 0.0 || off < 5e-5, "{} joint {joint} at {time} s: {off:e}", robot.name);
                }
                if legs.last() != Some(&motion.leg) {
                    legs.push(motion.leg);
                }
                before = motion;
                time += 1e-3;
            }
            assert_eq!(legs, (0..spec.legs.len()).collect::<Vec<_>>(), "{}", robot.name);
        }
    }

    #[test]
    fn the_cycle_of_the_safety_fence_takes_the_time_of_six_trapezoids() {
        // Each leg: length / v + v / a. Lengths 0.1, sqrt(0.4^2 + 0.6^2), 0.1 m, and the same back.
        let slow = 0.1 / 0.5 + 0.5 / 15.0;
        let fast = 0.52_f64.sqrt() / 2.0 + 2.0 / 15.0;
        let expected = 4.0 * slow + 2.0 * fast;
        let cycle = Path::new(&safety_fence::SPEC.robots[0]).unwrap().cycle_time(f64::INFINITY);
        assert!(cycle >= expected - 1e-9, "{cycle} s is faster than the limits allow: {expected} s");
        assert!(cycle - expected < 5e-3, "{cycle} s, expected {expected} s");
    }
}
