//! A robot's programme: a closed polyline of the tool centre point with a speed per leg, timed once for all.
//!
//! The tool keeps its orientation, stops at each corner and moves along each leg as fast as four limits allow: the
//! programmed speed, an acceleration along the path, and the speeds and accelerations of the joints. Timing is the
//! reachability method for path parameterisation (Pham and Pham 2018): on a grid along the leg, with u the square of
//! the path speed and a its acceleration, u is first bounded from the end backwards, then raised greedily forwards.
//! Between grid points the acceleration is constant, so place and speed are exact integrals of each other.

use crate::interface::irb1200;
use crate::kinematics::{Arm, ELBOW_UP, Joints, POINTING_DOWN, Pose, Vec3, add, norm, scale};

/// Greatest acceleration of the tool along the path, m/s^2.
pub const MAX_PATH_ACCELERATION: f64 = 15.0;

/// Greatest joint accelerations, rad/s^2. The maker does not publish any. These are chosen: the main axes reach their
/// full speed in about 0.1 s, the wrist in about 0.08 s, which fits the published cycle times of robots of this size.
pub const MAX_JOINT_ACCELERATION: Joints = [50.0, 42.0, 52.0, 87.0, 88.0, 131.0];

/// Distance of grid points along a leg, m (at most).
const GRID: f64 = 0.002;

/// A straight leg of the programme: where it ends (base frame, m) and how fast it may run (m/s).
#[derive(Debug, Clone, Copy)]
pub struct LegTo {
    pub end: Vec3,
    pub speed: f64,
}

/// The timed programme. Never changes; instances share one.
#[derive(Debug)]
pub struct Path {
    arm: Arm,
    legs: Vec<Leg>,
    cycle_time: f64,
}

#[derive(Debug)]
struct Leg {
    start: Vec3,
    direction: Vec3,
    /// When the leg starts, s into the cycle.
    begins: f64,
    /// At each grid point: time since `begins`, distance from `start`, path speed.
    knots: Vec<Knot>,
}

#[derive(Debug, Clone, Copy)]
struct Knot {
    time: f64,
    distance: f64,
    speed: f64,
}

/// Where the robot is at some programme time, and how fast it would move at full pace.
#[derive(Debug, Clone, Copy)]
pub struct Motion {
    /// Leg, counted from 0.
    pub leg: usize,
    /// Joint angles, rad.
    pub q: Joints,
    /// Joint speeds, rad/s.
    pub qd: Joints,
    /// Speed of the tool centre point, m/s.
    pub tcp_speed: f64,
}

impl Path {
    /// Times the polyline that starts at `start` and must come back there; None if it leaves the reach of the elbow-up
    /// posture, passes a singular pose or has a leg of no length.
    pub fn new(arm: Arm, start: Vec3, legs: &[LegTo]) -> Option<Self> {
        let mut path = Self { arm, legs: Vec::with_capacity(legs.len()), cycle_time: 0.0 };
        let mut at = start;
        for leg in legs {
            let vector = add(leg.end, scale(at, -1.0));
            let length = norm(vector);
            if length <= 0.0 {
                return None;
            }
            let direction = scale(vector, 1.0 / length);
            let knots = time_leg(&arm, at, direction, length, leg.speed)?;
            let duration = knots.last()?.time;
            path.legs.push(Leg { start: at, direction, begins: path.cycle_time, knots });
            path.cycle_time += duration;
            at = leg.end;
        }
        Some(path)
    }

    /// Duration of one cycle at full pace, s.
    #[cfg(test)]
    pub fn cycle_time(&self) -> f64 {
        self.cycle_time
    }

    /// The motion at a programme time (s, taken modulo the cycle).
    pub fn at(&self, programme_time: f64) -> Motion {
        let time = programme_time.rem_euclid(self.cycle_time);
        let leg_number = self.legs.partition_point(|leg| leg.begins <= time).saturating_sub(1);
        let leg = &self.legs[leg_number];
        let (distance, speed) = leg.place(time - leg.begins);
        let position = add(leg.start, scale(leg.direction, distance));
        // Both exist on the whole path: `new` has solved them on the grid, and the path keeps clear of the limits.
        let q = angles(&self.arm, position).unwrap_or([f64::NAN; 6]);
        let qd = self.arm.joint_speeds(&q, scale(leg.direction, speed)).unwrap_or([f64::NAN; 6]);
        Motion { leg: leg_number, q, qd, tcp_speed: speed }
    }
}

impl Leg {
    /// Distance from the start of the leg and path speed, `time` seconds after its beginning.
    fn place(&self, time: f64) -> (f64, f64) {
        let next = self.knots.partition_point(|knot| knot.time <= time).clamp(1, self.knots.len() - 1);
        let (from, to) = (self.knots[next - 1], self.knots[next]);
        let acceleration = (to.speed - from.speed) / (to.time - from.time);
        let elapsed = (time - from.time).clamp(0.0, to.time - from.time);
        (
            from.distance + from.speed * elapsed + acceleration * elapsed * elapsed / 2.0,
            from.speed + acceleration * elapsed,
        )
    }
}

fn angles(arm: &Arm, position: Vec3) -> Option<Joints> {
    arm.inverse(&Pose { position, rotation: POINTING_DOWN }, ELBOW_UP)
}

/// Limits on (u, a) at one grid point: u <= u_max, |a| <= MAX_PATH_ACCELERATION, |rate a + bend u| <= limit per joint,
/// where rate and bend are the first and second derivatives of the joint angle by the distance.
struct Limits {
    u_max: f64,
    rate: Joints,
    bend: Joints,
}

impl Limits {
    /// The accelerations allowed at u; the interval is empty (low > high) if u is too high.
    fn accelerations(&self, u: f64) -> (f64, f64) {
        let (mut low, mut high) = (-MAX_PATH_ACCELERATION, MAX_PATH_ACCELERATION);
        for ((&rate, &bend), &limit) in self.rate.iter().zip(&self.bend).zip(&MAX_JOINT_ACCELERATION) {
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

fn time_leg(arm: &Arm, start: Vec3, direction: Vec3, length: f64, speed: f64) -> Option<Vec<Knot>> {
    let mut cells = 1_u32;
    while length / f64::from(cells) > GRID {
        cells += 1;
    }
    let spacing = length / f64::from(cells);
    let mut limits = Vec::new();
    for k in 0..=cells {
        let rate_at = |distance: f64| {
            let q = angles(arm, add(start, scale(direction, distance)))?;
            arm.joint_speeds(&q, direction)
        };
        let distance = f64::from(k) * spacing;
        let rate = rate_at(distance)?;
        let (ahead, behind) = (rate_at(distance + 1e-5)?, rate_at(distance - 1e-5)?);
        let bend = std::array::from_fn(|joint| (ahead[joint] - behind[joint]) / 2e-5);
        let mut top = speed;
        for (joint, rate) in rate.iter().enumerate() {
            top = top.min(irb1200::max_speed(joint) / rate.abs().max(1e-9));
        }
        limits.push(Limits { u_max: top * top, rate, bend });
    }
    // Backwards: from where on can the robot still stop at the end?
    let mut bound = vec![0.0; limits.len()];
    for k in (0..limits.len() - 1).rev() {
        bound[k] = limits[k].controllable(bound[k + 1], spacing);
    }
    // Forwards: as fast as that allows.
    let (mut u, mut knots) = (0.0_f64, vec![Knot { time: 0.0, distance: 0.0, speed: 0.0 }]);
    for (k, (limit, bound)) in limits.iter().zip(bound.iter().skip(1)).enumerate() {
        let (_, acceleration) = limit.accelerations(u);
        let next = (u + 2.0 * spacing * acceleration).min(*bound).max(0.0);
        let (from, to) = (u.sqrt(), next.sqrt());
        if from + to <= 0.0 {
            return None;
        }
        let time = knots[k].time + 2.0 * spacing / (from + to);
        let distance = knots[k].distance + spacing;
        knots.push(Knot { time, distance, speed: to });
        u = next;
    }
    Some(knots)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::kinematics::IRB_1200;

    #[test]
    fn a_straight_leg_takes_the_time_of_a_trapezoid() {
        // Slow and far from any joint limit: t = length / v + v / a.
        let (a, b) = ([0.5, 0.0, 0.6], [0.5, 0.0, 0.8]);
        let path = Path::new(IRB_1200, a, &[LegTo { end: b, speed: 0.4 }, LegTo { end: a, speed: 0.4 }]).unwrap();
        let expected = 2.0 * (0.2 / 0.4 + 0.4 / MAX_PATH_ACCELERATION);
        assert!((path.cycle_time() - expected).abs() < 2e-3, "{} s, expected {expected} s", path.cycle_time());
    }

    #[test]
    fn a_joint_limit_slows_a_leg_down() {
        // Past the first axis at 0.25 m: 2 m/s would need 8 rad/s, the joint turns at 5.03.
        let (a, b) = ([0.25, -0.3, 0.6], [0.25, 0.3, 0.6]);
        let path = Path::new(IRB_1200, a, &[LegTo { end: b, speed: 2.0 }, LegTo { end: a, speed: 2.0 }]).unwrap();
        let mut fastest: f64 = 0.0;
        let mut time = 0.0;
        while time < path.cycle_time() {
            let motion = path.at(time);
            for joint in 0..6 {
                assert!(motion.qd[joint].abs() <= irb1200::max_speed(joint) * 1.001, "joint {joint} at {time} s");
            }
            fastest = fastest.max(motion.qd[0].abs());
            time += 1e-3;
        }
        assert!(fastest > 0.98 * irb1200::max_speed(0), "the limit is not used: {fastest} rad/s");
    }

    #[test]
    fn out_of_reach_is_refused() {
        let far = LegTo { end: [1.5, 0.0, 0.6], speed: 1.0 };
        assert!(Path::new(IRB_1200, [0.5, 0.0, 0.6], &[far]).is_none());
    }
}
