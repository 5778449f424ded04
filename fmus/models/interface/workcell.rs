//! What the workcells have in common: a cell as data, and the table of variables made from it.

use super::robots::Robot;
use super::variables::Causality::{Input, Output, Parameter};
use super::variables::{Interface, Kind, Variable, Variant};

/// A cell as data.
#[derive(Debug)]
pub struct Spec {
    /// FMI `modelIdentifier`.
    pub identifier: &'static str,
    /// FMI `modelName`.
    pub name: &'static str,
    /// One sentence on what the cell is.
    pub description: &'static str,
    /// One or two robots.
    pub robots: &'static [RobotSpec],
    /// Start value of `plc.t_react`, s.
    pub t_react: f64,
    /// Start value of `ctrl.t_ramp`, s.
    pub t_ramp: f64,
    /// Start value of `ctrl.t_ramp_loaded`, s, where a stop takes longer with a workpiece.
    pub t_ramp_loaded: Option<f64>,
    /// Start value of `ctrl.phase0`, s.
    pub phase0: f64,
    /// Start value of `ctrl.v_approach`, m/s, where the programme has legs that approach something.
    pub v_approach: Option<f64>,
    /// What the safety controller listens to.
    pub safeguard: Safeguard,
    /// How the robots' place is told.
    pub output: Place,
}

/// A robot, its programme and its tool.
#[derive(Debug)]
pub struct RobotSpec {
    /// First part of the names of its variables; empty for the only robot of a cell (`robot`, `ctrl`, `plc`, `gripper`).
    pub suffix: &'static str,
    /// The arm.
    pub robot: &'static Robot,
    /// Orientation of the tool, base_from_tool by rows; the same all along the programme.
    pub rotation: [[f64; 3]; 3],
    /// Joint angles near those of the start, rad: they choose among the poses that reach it.
    pub near: [f64; 6],
    /// Start of the programme, base frame, m.
    pub start: [f64; 3],
    /// Its legs; the last leads back to the start.
    pub legs: &'static [Leg],
    /// Mass of the empty tool, kg.
    pub tool_kg: f64,
}

/// A straight leg of a programme.
#[derive(Debug, Clone, Copy)]
pub struct Leg {
    /// Where it ends, base frame, m.
    pub end: [f64; 3],
    /// How fast it may run, m/s.
    pub speed: f64,
    /// Mass of the workpiece that is carried along it, kg.
    pub carries: f64,
    /// Whether it approaches something: then `ctrl.v_approach` limits its speed as well.
    pub approach: bool,
}

/// An unloaded leg.
pub const fn leg(end: [f64; 3], speed: f64) -> Leg {
    Leg { end, speed, carries: 0.0, approach: false }
}

/// A leg with a workpiece.
pub const fn loaded(end: [f64; 3], speed: f64, carries: f64) -> Leg {
    Leg { end, speed, carries, approach: false }
}

/// The same leg as an approach.
pub const fn approaching(leg: Leg) -> Leg {
    Leg { approach: true, ..leg }
}

/// A UR's tool, which points along its own -y, straight down.
pub const UR_POINTING_DOWN: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 0.0, -1.0], [0.0, 1.0, 0.0]];

/// The tool straight down; the tool's y axis along the base's y axis.
pub const POINTING_DOWN: [[f64; 3]; 3] = [[0.0, 0.0, 1.0], [0.0, 1.0, 0.0], [-1.0, 0.0, 0.0]];

/// What the safety controller listens to and what it does about it.
#[derive(Debug)]
pub enum Safeguard {
    /// One signal, true while all is well; false demands a protective stop, latched until the reset button.
    Stop {
        /// Variable name.
        input: &'static str,
        /// Its description.
        about: &'static str,
    },
    /// One signal, true while all is well; while it is false the speed is limited, not latched.
    Slow {
        /// Variable name.
        input: &'static str,
        /// Its description.
        about: &'static str,
        /// Start value of the speed limit `plc.v_reduced`, m/s.
        v_reduced: f64,
    },
    /// The guard contact of [`Safeguard::Stop`], and a speed limit that always holds.
    AlwaysLimited {
        /// Variable name.
        input: &'static str,
        /// Its description.
        about: &'static str,
        /// Start value of the speed limit `plc.v_limit`, m/s.
        v_limit: f64,
    },
    /// The contact of a door, true while it is closed: its opening demands a protective stop, latched until the reset button. Whether
    /// the demand lasts for as long as the door is open, the parameter `plc.hold_while_open` says; it starts false.
    Door {
        /// Variable name.
        input: &'static str,
        /// Its description.
        about: &'static str,
    },
    /// The signal of a light curtain in an entrance, true while it is clear; false demands a protective stop, latched until the reset
    /// button. A pallet stands in the entrance and is conveyed out of it; meanwhile the curtain is muted.
    Muted {
        /// Variable name.
        input: &'static str,
        /// Its description.
        about: &'static str,
        /// Start values of the parameters in [`conveyor`].
        start: [f64; conveyor::COUNT],
    },
    /// Two laser scanners that are part of the FMU and see the person's feet; each stops its robot, latched.
    Fields {
        /// Start values of the rectangles: x from and to of field A, the same of field B, and y from, m.
        start: [f64; 5],
    },
}

/// How the robots' place is told.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Place {
    /// Joint angles and speeds.
    Joints,
    /// Pose and velocity of each joint's moving side, base frame.
    LinkPoses,
}

/// Places in the parameter array of the model.
#[allow(missing_docs, reason = "each is described in the table below; in the build script the lint is silent")]
pub mod parameter {
    pub const T_REACT: usize = 0;
    pub const T_RAMP: usize = 1;
    pub const SPEED_SCALE: usize = 2;
    pub const PHASE0: usize = 3;
    pub const V_LIMIT: usize = 4;
    pub const FIELDS: usize = 5;
    pub const V_APPROACH: usize = 10;
    pub const T_RAMP_LOADED: usize = 11;
    pub const COUNT: usize = 12;
}

/// Places in the array of a conveyor's parameters.
#[allow(missing_docs, reason = "each is described in the table below; in the build script the lint is silent")]
pub mod conveyor {
    pub const BEGINS: usize = 0;
    pub const SPEED: usize = 1;
    pub const WAY: usize = 2;
    pub const CLEAR: usize = 3;
    pub const MUTE: usize = 4;
    pub const COUNT: usize = 5;
}

/// What a variable of a workcell stands for; the first number of an output is the robot's place in the spec.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
#[allow(missing_docs, reason = "the descriptions stand in the table below")]
pub enum Role {
    Time,
    Parameter(usize),
    Hold,
    Conveyor(usize),
    UntilClear,
    Clear,
    Foot(usize),
    Reset,
    Q(usize, usize),
    Qd(usize, usize),
    /// Robot, joint, component: position 0..3, quaternion (w first) 3..7, velocity 7..10, angular velocity 10..13.
    Link(usize, usize, usize),
    TcpSpeed(usize),
    Override(usize),
    Leg(usize),
    StopState(usize),
    Payload(usize),
    Occupied(usize),
    Pallet,
    InEntrance,
    Muted,
}

/// Names and units of the 13 numbers that describe a link, in the order of [`Role::Link`].
pub const LINK_COMPONENTS: [(&str, &str); 13] = [
    ("x", "m"),
    ("y", "m"),
    ("z", "m"),
    ("qw", "1"),
    ("qx", "1"),
    ("qy", "1"),
    ("qz", "1"),
    ("vx", "m/s"),
    ("vy", "m/s"),
    ("vz", "m/s"),
    ("wx", "rad/s"),
    ("wy", "rad/s"),
    ("wz", "rad/s"),
];

/// Collects variables with their roles.
struct Table {
    variables: Vec<Variable>,
    roles: Vec<Role>,
}

impl Table {
    fn parameter(&mut self, name: &str, about: &str, place: usize, unit: &'static str, [start, min, max]: [f64; 3]) {
        let kind = Kind::real_in(unit, start, min, max);
        self.variables.push(Variable::new(name, about, Parameter, kind));
        self.roles.push(Role::Parameter(place));
    }

    fn input(&mut self, name: &str, about: &str, role: Role, kind: Kind) {
        self.variables.push(Variable::new(name, about, Input, kind));
        self.roles.push(role);
    }

    fn output(&mut self, name: &str, about: &str, role: Role, kind: Kind) {
        self.variables.push(Variable::new(name, about, Output, kind));
        self.roles.push(role);
    }
}

/// The table of a cell, and the role of each variable.
pub fn interface(spec: &Spec, variant: Variant) -> (Interface, Vec<Role>) {
    let mut table = Table { variables: vec![Variable::time()], roles: vec![Role::Time] };
    parameters(&mut table, spec);
    inputs(&mut table, spec);
    for (number, robot) in spec.robots.iter().enumerate() {
        outputs(&mut table, spec, number, robot);
    }
    if let Safeguard::Fields { .. } = spec.safeguard {
        for (field, name) in ["a", "b"].into_iter().enumerate() {
            table.output(
                &format!("scanner.{name}.occupied"),
                &format!("Whether scanner {} sees a leg in its field", name.to_uppercase()),
                Role::Occupied(field),
                Kind::Boolean { start: false },
            );
        }
    }
    if let Safeguard::Muted { .. } = spec.safeguard {
        let flag = Kind::Boolean { start: true };
        table.output(
            "conveyor.pallet_m",
            "How far the pallet is on its way",
            Role::Pallet,
            Kind::real_in("m", 0.0, 0.0, 20.0),
        );
        table.output(
            "conveyor.in_entrance",
            "Whether the pallet has still to leave the entrance",
            Role::InEntrance,
            flag,
        );
        table.output("plc.muted", "Whether the light curtain is muted", Role::Muted, flag);
    }
    let (identifier, name) = variant.names(spec.identifier, spec.name);
    let interface = Interface { identifier, name, description: spec.description, variant, variables: table.variables };
    (interface, table.roles)
}

fn parameters(table: &mut Table, spec: &Spec) {
    table.parameter(
        "plc.t_react",
        "Reaction time: from the demand to the start of the deceleration; rounded up to 1 ms",
        parameter::T_REACT,
        "s",
        [spec.t_react, 0.0, 5.0],
    );
    table.parameter(
        "ctrl.t_ramp",
        "Time in which the override falls linearly from 1 to 0 (and rises again after a restart)",
        parameter::T_RAMP,
        "s",
        [spec.t_ramp, 0.001, 5.0],
    );
    if let Some(t_ramp_loaded) = spec.t_ramp_loaded {
        table.parameter(
            "ctrl.t_ramp_loaded",
            "The same while the robot carries a workpiece: which holds is decided when the override begins to change",
            parameter::T_RAMP_LOADED,
            "s",
            [t_ramp_loaded, 0.001, 5.0],
        );
    }
    table.parameter(
        "ctrl.speed_scale",
        "Programme speed as a fraction of the programmed speeds",
        parameter::SPEED_SCALE,
        "1",
        [1.0, 0.05, 1.0],
    );
    table.parameter(
        "ctrl.phase0",
        "Start offset into the cycle of the programme, taken modulo the cycle time",
        parameter::PHASE0,
        "s",
        [spec.phase0, 0.0, 60.0],
    );
    if let Some(v_approach) = spec.v_approach {
        table.parameter(
            "ctrl.v_approach",
            "Greatest speed of the legs that approach a place where something is gripped or put down",
            parameter::V_APPROACH,
            "m/s",
            [v_approach, 0.01, 10.0],
        );
    }
    match spec.safeguard {
        Safeguard::Stop { .. } => {}
        Safeguard::Door { .. } => {
            let about = "Whether the open door is a demand for as long as it is open; otherwise only its opening is";
            let kind = Kind::Boolean { start: false };
            table.variables.push(Variable::new("plc.hold_while_open", about, Parameter, kind));
            table.roles.push(Role::Hold);
        }
        Safeguard::Muted { start, .. } => {
            for (place, (name, about, unit, max)) in [
                ("conveyor.begins_s", "When the pallet begins to move out", "s", 60.0),
                ("conveyor.speed", "Its speed", "m/s", 2.0),
                ("conveyor.way_m", "How far it goes", "m", 20.0),
                ("conveyor.clear_m", "After so much of its way it has left the entrance", "m", 20.0),
                ("plc.mute_s", "The curtain is muted from the start on for no longer than this", "s", 60.0),
            ]
            .into_iter()
            .enumerate()
            {
                let kind = Kind::real_in(unit, start[place], 0.0, max);
                table.variables.push(Variable::new(name, about, Parameter, kind));
                table.roles.push(Role::Conveyor(place));
            }
            let about = "Whether muting ends as soon as the pallet has left the entrance; otherwise only its time ends it";
            let kind = Kind::Boolean { start: false };
            table.variables.push(Variable::new("plc.mute_until_clear", about, Parameter, kind));
            table.roles.push(Role::UntilClear);
        }
        Safeguard::Slow { v_reduced, .. } => table.parameter(
            "plc.v_reduced",
            "Speed of the tool centre point while the signal is false: safely limited speed, 0 for a safe operating stop",
            parameter::V_LIMIT,
            "m/s",
            [v_reduced, 0.0, 10.0],
        ),
        Safeguard::AlwaysLimited { v_limit, .. } => table.parameter(
            "plc.v_limit",
            "Safely limited speed of the tool centre point, always in force; it does not know the payload",
            parameter::V_LIMIT,
            "m/s",
            [v_limit, 0.05, 10.0],
        ),
        Safeguard::Fields { start } => {
            let names = ["a.x_from", "a.x_to", "b.x_from", "b.x_to", "y_from"];
            for (place, (name, start)) in names.into_iter().zip(start).enumerate() {
                table.parameter(
                    &format!("scanner.{name}"),
                    "Edge of a scanner's field in the cell's frame",
                    parameter::FIELDS + place,
                    "m",
                    [start, -20.0, 20.0],
                );
            }
        }
    }
}

fn inputs(table: &mut Table, spec: &Spec) {
    match spec.safeguard {
        Safeguard::Stop { input, about }
        | Safeguard::Door { input, about }
        | Safeguard::Muted { input, about, .. }
        | Safeguard::Slow { input, about, .. }
        | Safeguard::AlwaysLimited { input, about, .. } => {
            table.input(input, about, Role::Clear, Kind::Boolean { start: true });
        }
        Safeguard::Fields { .. } => {
            for (place, name) in ["left_foot.x", "left_foot.y", "right_foot.x", "right_foot.y"].into_iter().enumerate()
            {
                let far = if place % 2 == 0 { 0.0 } else { -20.0 };
                table.input(
                    &format!("human.{name}"),
                    "Where the middle of the person's foot is, cell's frame",
                    Role::Foot(place),
                    Kind::real_in("m", far, -1e3, 1e3),
                );
            }
        }
    }
    table.input(
        "plc.reset",
        "Restart button: a rising edge restarts a stopped robot if the demand is gone",
        Role::Reset,
        Kind::Boolean { start: false },
    );
}

fn outputs(table: &mut Table, spec: &Spec, number: usize, robot: &RobotSpec) {
    let suffix = robot.suffix;
    let arm = robot.robot;
    match spec.output {
        Place::Joints => {
            for joint in 0..6 {
                let (min, max) = arm.range(joint);
                let name = joint + 1;
                table.output(
                    &format!("robot{suffix}.q[{name}]"),
                    &format!("Angle of joint {name}"),
                    Role::Q(number, joint),
                    Kind::real_in("rad", 0.0, min, max),
                );
            }
            for joint in 0..6 {
                let name = joint + 1;
                table.output(
                    &format!("robot{suffix}.qd[{name}]"),
                    &format!("Speed of joint {name}: time derivative of robot{suffix}.q[{name}]"),
                    Role::Qd(number, joint),
                    Kind::real_in("rad/s", 0.0, -arm.max_speed(joint), arm.max_speed(joint)),
                );
            }
        }
        Place::LinkPoses => {
            for joint in 0..6 {
                for (component, (name, unit)) in LINK_COMPONENTS.into_iter().enumerate() {
                    table.output(
                        &format!("robot{suffix}.link[{}].{name}", joint + 1),
                        "Position, unit quaternion, velocity or angular velocity of the joint's moving side, base frame",
                        Role::Link(number, joint, component),
                        Kind::real(unit),
                    );
                }
            }
        }
    }
    table.output(
        &format!("robot{suffix}.tcp_speed"),
        "Speed of the tool centre point",
        Role::TcpSpeed(number),
        Kind::real("m/s"),
    );
    table.output(
        &format!("ctrl{suffix}.override"),
        "Factor by which the safety controller slows the programme down: 1 runs, 0 stands",
        Role::Override(number),
        Kind::real_in("1", 0.0, 0.0, 1.0),
    );
    let last = i32::try_from(robot.legs.len()).map_or(0, |n| n - 1);
    table.output(
        &format!("ctrl{suffix}.leg"),
        "Leg of the programme, counted from 0",
        Role::Leg(number),
        Kind::integer_in(0, 0, last),
    );
    table.output(
        &format!("plc{suffix}.stop_state"),
        "0 running, 1 reduced speed demanded, 2 stopping (from the demand on), 3 stopped",
        Role::StopState(number),
        Kind::integer_in(0, 0, 3),
    );
    table.output(
        &format!("gripper{suffix}.payload"),
        "Mass at the flange: tool and workpiece",
        Role::Payload(number),
        Kind::real("kg"),
    );
}
