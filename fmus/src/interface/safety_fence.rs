//! The variables of the feed-opening cell `safety-fence`.

use super::irb1200;
use super::variables::Causality::{Input, Output, Parameter};
use super::variables::{Interface, Kind, Variable};

/// Place (= value reference) of each variable in the table; arrays give their first element.
#[allow(missing_docs, reason = "each is described in the table below; in the build script the lint is silent")]
pub mod vr {
    pub const T_REACT: usize = 1;
    pub const T_RAMP: usize = 2;
    pub const SPEED_SCALE: usize = 3;
    pub const PHASE0: usize = 4;
    pub const GUARD_CLOSED: usize = 5;
    pub const RESET: usize = 6;
    pub const Q: usize = 7;
    pub const QD: usize = 13;
    pub const TCP_SPEED: usize = 19;
    pub const OVERRIDE: usize = 20;
    pub const LEG: usize = 21;
    pub const STOP_STATE: usize = 22;
    pub const PAYLOAD: usize = 23;
}

/// Builds the table.
pub fn interface() -> Interface {
    let mut variables = vec![
        Variable::time(),
        Variable::new(
            "plc.t_react",
            "Reaction time: from the demand (guard no longer closed) to the start of the deceleration; rounded up to 1 ms",
            Parameter,
            Kind::real_in("s", 0.05, 0.0, 5.0),
        ),
        Variable::new(
            "ctrl.t_ramp",
            "Time in which the override falls linearly from 1 to 0 (and rises again after a restart)",
            Parameter,
            Kind::real_in("s", 0.30, 0.001, 5.0),
        ),
        Variable::new(
            "ctrl.speed_scale",
            "Programme speed as a fraction of the programmed speeds",
            Parameter,
            Kind::real_in("1", 1.0, 0.05, 1.0),
        ),
        Variable::new(
            "ctrl.phase0",
            "Start offset into the cycle of the programme, taken modulo the cycle time",
            Parameter,
            Kind::real_in("s", 0.0, 0.0, 60.0),
        ),
        Variable::new(
            "plc.guard_closed",
            "Guard contact; false is the demand for a protective stop (category 1, path kept, latched)",
            Input,
            Kind::Boolean { start: true },
        ),
        Variable::new(
            "plc.reset",
            "Restart button: a rising edge restarts a stopped robot if the guard is closed",
            Input,
            Kind::Boolean { start: false },
        ),
    ];
    for joint in 0..6 {
        let (min, max) = irb1200::range(joint);
        let number = joint + 1;
        variables.push(Variable::new(
            &format!("robot.q[{number}]"),
            &format!("Angle of joint {number}"),
            Output,
            Kind::real_in("rad", 0.0, min, max),
        ));
    }
    for joint in 0..6 {
        let number = joint + 1;
        variables.push(Variable::new(
            &format!("robot.qd[{number}]"),
            &format!("Speed of joint {number}: time derivative of robot.q[{number}]"),
            Output,
            Kind::real_in("rad/s", 0.0, -irb1200::max_speed(joint), irb1200::max_speed(joint)),
        ));
    }
    variables.extend([
        Variable::new("robot.tcp_speed", "Speed of the tool centre point", Output, Kind::real("m/s")),
        Variable::new(
            "ctrl.override",
            "Factor by which the protective stop slows the programme down: 1 runs, 0 stands",
            Output,
            Kind::real_in("1", 0.0, 0.0, 1.0),
        ),
        Variable::new("ctrl.leg", "Leg of the programme, counted from 0", Output, Kind::integer_in(0, 0, 5)),
        Variable::new(
            "plc.stop_state",
            "0 running, 1 reserved (reduced speed), 2 stopping (from the demand on), 3 stopped",
            Output,
            Kind::integer_in(0, 0, 3),
        ),
        Variable::new("gripper.payload", "Mass at the flange: tool and workpiece", Output, Kind::real("kg")),
    ]);
    Interface {
        identifier: "safety_fence",
        name: "safety-fence",
        description: "Handling robot behind a fence with a feed opening; the guard contact stops it",
        saves_state: true,
        variables,
    }
}
