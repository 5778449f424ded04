//! `safety-fence`: a handling robot behind a fence with a feed opening.
//!
//! The model knows the robot and its safety controller in the robot's base frame, not the fence: whether the opening
//! is too large is a matter of the cell around it. Moving the base makes the same FMU serve the repaired cell.

use crate::bytes::{Reader, Writer};
use crate::interface::safety_fence::{interface, vr};
use crate::interface::variables::Value;
use crate::kinematics::IRB_1200;
use crate::model::{Model, Outcome};
use crate::path::{LegTo, Motion, Path};
use crate::stop::{ProtectiveStop, StopSettings};
use std::sync::OnceLock;

/// Mass of gripper and workpiece, kg.
const PAYLOAD: f64 = 3.0;

/// The programme in the base frame: out of the feed opening (low), up, across to the tray, down, and back the same way.
const START: [f64; 3] = [0.60, 0.0, 0.4991];
const PROGRAMME: [LegTo; 6] = [
    LegTo { end: [0.60, 0.0, 0.5991], speed: 0.5 },
    LegTo { end: [0.20, 0.60, 0.5991], speed: 2.0 },
    LegTo { end: [0.20, 0.60, 0.4991], speed: 0.5 },
    LegTo { end: [0.20, 0.60, 0.5991], speed: 0.5 },
    LegTo { end: [0.60, 0.0, 0.5991], speed: 2.0 },
    LegTo { end: START, speed: 0.5 },
];

/// The timed programme, made by the first instance that needs it.
fn path() -> &'static Path {
    static PATH: OnceLock<Path> = OnceLock::new();
    #[expect(clippy::expect_used, reason = "a constant programme, checked by the tests of this file")]
    PATH.get_or_init(|| Path::new(IRB_1200, START, &PROGRAMME).expect("the programme is within reach"))
}

/// Parameters, inputs and state.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SafetyFence {
    settings: StopSettings,
    speed_scale: f64,
    phase0: f64,
    guard_closed: bool,
    reset: bool,
    stop: ProtectiveStop,
}

impl SafetyFence {
    /// All start values of the table.
    pub fn new() -> Self {
        let mut model = Self {
            settings: StopSettings { t_react: 0.0, t_ramp: 1.0 },
            speed_scale: 1.0,
            phase0: 0.0,
            guard_closed: true,
            reset: false,
            stop: ProtectiveStop::running(),
        };
        for (place, variable) in interface().variables.iter().enumerate() {
            model.set(place, variable.kind.start());
        }
        model
    }

    fn motion(&self) -> Motion {
        path().at(self.phase0 + self.speed_scale * self.stop.programme_time(&self.settings))
    }

    /// The value of one variable; the motion is handed in because finding it is the costly part.
    fn value(&self, motion: &Motion, variable: usize) -> Value {
        match variable {
            vr::T_REACT => Value::Real(self.settings.t_react),
            vr::T_RAMP => Value::Real(self.settings.t_ramp),
            vr::SPEED_SCALE => Value::Real(self.speed_scale),
            vr::PHASE0 => Value::Real(self.phase0),
            vr::GUARD_CLOSED => Value::Boolean(self.guard_closed),
            vr::RESET => Value::Boolean(self.reset),
            vr::Q..vr::QD => Value::Real(motion.q[variable - vr::Q]),
            vr::QD..vr::TCP_SPEED => Value::Real(motion.qd[variable - vr::QD] * self.pace()),
            vr::TCP_SPEED => Value::Real(motion.tcp_speed * self.pace()),
            vr::OVERRIDE => Value::Real(self.stop.pace(&self.settings)),
            vr::LEG => Value::Integer(i32::try_from(motion.leg).unwrap_or(i32::MAX)),
            vr::STOP_STATE => Value::Integer(self.stop.state(&self.settings)),
            vr::PAYLOAD => Value::Real(PAYLOAD),
            _ => Value::Real(f64::NAN),
        }
    }

    /// Programme seconds per second.
    fn pace(&self) -> f64 {
        self.speed_scale * self.stop.pace(&self.settings)
    }

    /// Reads what `write` wrote.
    pub fn read(input: &mut Reader) -> Option<Self> {
        Some(Self {
            settings: StopSettings { t_react: input.f64()?, t_ramp: input.f64()? },
            speed_scale: input.f64()?,
            phase0: input.f64()?,
            guard_closed: input.bool()?,
            reset: input.bool()?,
            stop: ProtectiveStop::read(input)?,
        })
    }
}

impl Model for SafetyFence {
    fn set(&mut self, variable: usize, value: Value) {
        match (variable, value) {
            (vr::T_REACT, Value::Real(x)) => self.settings.t_react = x,
            (vr::T_RAMP, Value::Real(x)) => self.settings.t_ramp = x,
            (vr::SPEED_SCALE, Value::Real(x)) => self.speed_scale = x,
            (vr::PHASE0, Value::Real(x)) => self.phase0 = x,
            (vr::GUARD_CLOSED, Value::Boolean(x)) => self.guard_closed = x,
            (vr::RESET, Value::Boolean(x)) => self.reset = x,
            _ => {}
        }
    }

    fn read_out(&self, values: &mut [Value]) {
        let motion = self.motion();
        for (place, value) in values.iter_mut().enumerate() {
            *value = self.value(&motion, place);
        }
    }

    fn step(&mut self, ticks: u64) -> Outcome {
        self.stop.advance(ticks, self.guard_closed, self.reset, &self.settings);
        Outcome::Done
    }

    fn write(&self, out: &mut Writer) {
        for value in [self.settings.t_react, self.settings.t_ramp, self.speed_scale, self.phase0] {
            out.f64(value);
        }
        out.bool(self.guard_closed);
        out.bool(self.reset);
        self.stop.write(out);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::interface::irb1200;
    use crate::kinematics::{Joints, add, norm, scale};

    fn real(model: &SafetyFence, variable: usize) -> f64 {
        match model.value(&model.motion(), variable) {
            Value::Real(x) => x,
            other => panic!("{other:?} is not real"),
        }
    }

    fn joints(model: &SafetyFence, first: usize) -> Joints {
        std::array::from_fn(|k| real(model, first + k))
    }

    /// Distance of a point from the programme's polyline, computed without the code under test.
    fn off_the_polyline(point: [f64; 3]) -> f64 {
        let corners = [START, [0.60, 0.0, 0.5991], [0.20, 0.60, 0.5991], [0.20, 0.60, 0.4991]];
        corners
            .windows(2)
            .map(|ends| {
                let along = add(ends[1], scale(ends[0], -1.0));
                let to = add(point, scale(ends[0], -1.0));
                let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
                let part = (dot(to, along) / dot(along, along)).clamp(0.0, 1.0);
                norm(add(to, scale(along, -part)))
            })
            .fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn starts_at_the_first_point_and_moves() {
        let mut model = SafetyFence::new();
        let pose = IRB_1200.forward(&joints(&model, vr::Q));
        assert!(norm(add(pose.position, scale(START, -1.0))) < 1e-12);
        assert_eq!(model.value(&model.motion(), vr::STOP_STATE), Value::Integer(0));
        model.step(20);
        assert!(real(&model, vr::TCP_SPEED) > 0.25);
    }

    #[test]
    fn stays_on_the_polyline_within_all_limits_without_jumps() {
        let mut model = SafetyFence::new();
        let mut before = joints(&model, vr::Q);
        let mut legs = Vec::new();
        for tick in 0..4500 {
            let (q, qd) = (joints(&model, vr::Q), joints(&model, vr::QD));
            let pose = IRB_1200.forward(&q);
            assert!(off_the_polyline(pose.position) < 1e-9, "off the path at tick {tick}");
            assert!((pose.rotation[2][0] + 1.0).abs() < 1e-9, "the tool does not point down at tick {tick}");
            for joint in 0..6 {
                let (low, high) = irb1200::range(joint);
                assert!(low < q[joint] && q[joint] < high, "joint {joint} out of range at tick {tick}");
                assert!(qd[joint].abs() <= irb1200::max_speed(joint), "joint {joint} too fast at tick {tick}");
                // At most 5.1 rad/s in 1 ms.
                assert!((q[joint] - before[joint]).abs() < 0.0052, "joint {joint} jumps at tick {tick}");
            }
            let Value::Integer(leg) = model.value(&model.motion(), vr::LEG) else { panic!("leg is an integer") };
            let limit = PROGRAMME[usize::try_from(leg).unwrap()].speed;
            assert!(real(&model, vr::TCP_SPEED) <= limit * (1.0 + 1e-12), "too fast at tick {tick}");
            if legs.last() != Some(&leg) {
                legs.push(leg);
            }
            before = q;
            model.step(1);
        }
        assert_eq!(legs[..8], [0, 1, 2, 3, 4, 5, 0, 1]);
    }

    #[test]
    fn speeds_are_the_derivatives_of_the_angles_also_while_stopping() {
        for scale in [1.0, 0.4] {
            let mut model = SafetyFence::new();
            model.set(vr::SPEED_SCALE, Value::Real(scale));
            let mut worst: f64 = 0.0;
            for tick in 0..2500_u32 {
                model.set(vr::GUARD_CLOSED, Value::Boolean(!(450..460).contains(&tick)));
                model.set(vr::RESET, Value::Boolean(tick >= 1000));
                // Over 1 ms: the trapezoid of the speeds against the difference of the angles.
                let (q, qd) = (joints(&model, vr::Q), joints(&model, vr::QD));
                model.step(1);
                let (next_q, next_qd) = (joints(&model, vr::Q), joints(&model, vr::QD));
                for joint in 0..6 {
                    let by_speed = (qd[joint] + next_qd[joint]) / 2.0 * 1e-3;
                    worst = worst.max((next_q[joint] - q[joint] - by_speed).abs());
                }
            }
            // The trapezoid is off by a jump of the acceleration within the millisecond: 90 rad/s^2 * (1 ms)^2 / 4.
            assert!(worst < 2.3e-5, "speeds and angles disagree by {worst:e} rad in 1 ms");
        }
    }

    #[test]
    fn the_tool_speed_is_that_of_the_forward_kinematics() {
        let mut model = SafetyFence::new();
        for _ in 0..200 {
            model.step(17);
            if model.motion().tcp_speed == 0.0 {
                continue;
            }
            let (q, qd) = (joints(&model, vr::Q), joints(&model, vr::QD));
            let h = 1e-7;
            let ahead = IRB_1200.forward(&std::array::from_fn(|k| q[k] + h * qd[k])).position;
            let behind = IRB_1200.forward(&std::array::from_fn(|k| q[k] - h * qd[k])).position;
            let measured = norm(add(ahead, scale(behind, -1.0))) / (2.0 * h);
            assert!((measured - real(&model, vr::TCP_SPEED)).abs() < 1e-6);
        }
    }

    #[test]
    fn the_phase_shifts_the_programme_and_wraps() {
        let mut late = SafetyFence::new();
        late.set(vr::PHASE0, Value::Real(0.5 + path().cycle_time()));
        let mut early = SafetyFence::new();
        early.step(500);
        for (a, b) in joints(&late, vr::Q).iter().zip(joints(&early, vr::Q)) {
            assert!((a - b).abs() < 1e-9);
        }
    }

    #[test]
    fn the_cycle_takes_the_time_of_six_trapezoids() {
        // Each leg: length / v + v / a. Lengths 0.1, sqrt(0.4^2 + 0.6^2), 0.1 m, and the same back.
        let slow = 0.1 / 0.5 + 0.5 / 15.0;
        let fast = 0.52_f64.sqrt() / 2.0 + 2.0 / 15.0;
        let expected = 4.0 * slow + 2.0 * fast;
        let cycle = path().cycle_time();
        assert!(cycle >= expected - 1e-9, "{cycle} s is faster than the limits allow: {expected} s");
        assert!(cycle - expected < 5e-3, "{cycle} s, expected {expected} s");
    }

    #[test]
    fn half_speed_takes_twice_the_time() {
        let mut slow = SafetyFence::new();
        slow.set(vr::SPEED_SCALE, Value::Real(0.5));
        let mut full = SafetyFence::new();
        slow.step(1200);
        full.step(600);
        for (a, b) in joints(&slow, vr::Q).iter().zip(joints(&full, vr::Q)) {
            assert!((a - b).abs() < 1e-9);
        }
        assert!((real(&slow, vr::TCP_SPEED) - real(&full, vr::TCP_SPEED) / 2.0).abs() < 1e-9);
    }
}
