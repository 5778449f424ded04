//! Cells cut into three FMUs that are to be coupled: safety controller, robot controller, kinematics. `sensor-mat` is one, and
//! `two-operators` another, of the same robot with another safety controller: it has one field for two stations.

use super::sensor_mat::SPEC;
use super::variables::Causality::{Input, Output, Parameter};
use super::variables::{Interface, Kind, Variable, Variant};

/// Place (= value reference) of each variable of the safety controller.
#[allow(missing_docs, reason = "each is described in the table below; in the build script the lint is silent")]
pub mod plc {
    pub const T_REACT: usize = 1;
    pub const MAT_CLEAR: usize = 2;
    pub const RESET: usize = 3;
    pub const STOP: usize = 4;
}

/// Place of each variable of the safety controller with two stations; the first are those of the other.
#[allow(missing_docs, reason = "as above")]
pub mod stations_plc {
    pub const FIELD_CLEAR: usize = super::plc::MAT_CLEAR;
    pub const STATION_A: usize = 5;
    pub const STATION_B: usize = 6;
    pub const MUTES: usize = 7;
}

/// Place of each variable of the robot controller; arrays give their first element.
#[allow(missing_docs, reason = "as above")]
pub mod controller {
    pub const T_RAMP: usize = 1;
    pub const SPEED_SCALE: usize = 2;
    pub const PHASE0: usize = 3;
    pub const STOP: usize = 4;
    pub const POSITION: usize = 5;
    pub const VELOCITY: usize = 8;
    pub const OVERRIDE: usize = 11;
    pub const LEG: usize = 12;
}

/// Place of each variable of the kinematics; arrays give their first element.
#[allow(missing_docs, reason = "as above")]
pub mod kinematics {
    pub const POSITION: usize = 1;
    pub const VELOCITY: usize = 4;
    pub const Q: usize = 7;
    pub const QD: usize = 13;
    pub const PAYLOAD: usize = 19;
}

/// The three interfaces of `sensor-mat`, upstream first.
pub fn all() -> [Interface; 3] {
    let cell = SPEC.name;
    [plc_interface(), controller_interface(cell), kinematics_interface(cell)]
}

/// The cell with two stations.
pub const STATIONS: &str = "two-operators";

/// One sentence on what it is.
pub const STATIONS_ABOUT: &str =
    "Robot with two stations in front of it; one field stops it, but for who is at a station";

/// The three interfaces of the cell with two stations, upstream first.
pub fn stations() -> [Interface; 3] {
    [stations_plc_interface(), controller_interface(STATIONS), kinematics_interface(STATIONS)]
}

fn interface(cell: &str, part: &str, description: &'static str, variables: Vec<Variable>) -> Interface {
    Interface {
        identifier: format!("{}_{part}", cell.replace('-', "_")),
        name: format!("{cell}-{part}"),
        description,
        variant: Variant::Faithful,
        variables,
    }
}

fn stations_plc_interface() -> Interface {
    let boolean = |start| Kind::Boolean { start };
    interface(
        STATIONS,
        "plc",
        "Safety controller of the cell two-operators: latches the field's demand, but for who is at a station, and passes it on",
        vec![
            Variable::time(),
            Variable::new(
                "t_react",
                "Reaction time; rounded up to 1 ms",
                Parameter,
                Kind::real_in("s", SPEC.t_react, 0.0, 5.0),
            ),
            Variable::new("field_clear", "Signal of the field; false demands a stop, latched", Input, boolean(true)),
            Variable::new("reset", "Restart button: a rising edge while the field is clear", Input, boolean(false)),
            Variable::new("stop", "The robot has to stop", Output, boolean(false)),
            Variable::new("station_a", "Mat of station A: its operator is there", Input, boolean(false)),
            Variable::new("station_b", "Mat of station B: its operator is there", Input, boolean(false)),
            Variable::new(
                "mute_at_stations",
                "Whether the field demands nothing while an operator is at a station",
                Parameter,
                boolean(true),
            ),
        ],
    )
}

fn plc_interface() -> Interface {
    let boolean = |start| Kind::Boolean { start };
    interface(
        SPEC.name,
        "plc",
        "Safety controller of the cell sensor-mat: latches the mat's demand and passes it on after its reaction time",
        vec![
            Variable::time(),
            Variable::new(
                "t_react",
                "Reaction time; rounded up to 1 ms",
                Parameter,
                Kind::real_in("s", SPEC.t_react, 0.0, 5.0),
            ),
            Variable::new("mat_clear", "Signal of the mat; false demands a stop, latched", Input, boolean(true)),
            Variable::new("reset", "Restart button: a rising edge while the mat is clear", Input, boolean(false)),
            Variable::new("stop", "The robot has to stop", Output, boolean(false)),
        ],
    )
}

/// Variables of a vector.
fn vector(variables: &mut Vec<Variable>, name: &str, about: &str, input: bool, unit: &'static str) {
    for axis in ["x", "y", "z"] {
        let causality = if input { Input } else { Output };
        let kind = Kind::real_in(unit, 0.0, -100.0, 100.0);
        variables.push(Variable::new(&format!("{name}.{axis}"), about, causality, kind));
    }
}

fn controller_interface(cell: &str) -> Interface {
    let mut variables = vec![
        Variable::time(),
        Variable::new(
            "t_ramp",
            "Time in which the override falls linearly from 1 to 0",
            Parameter,
            Kind::real_in("s", SPEC.t_ramp, 0.001, 5.0),
        ),
        Variable::new(
            "speed_scale",
            "Programme speed as a fraction of the programmed speeds",
            Parameter,
            Kind::real_in("1", 1.0, 0.05, 1.0),
        ),
        Variable::new(
            "phase0",
            "Start offset into the cycle of the programme",
            Parameter,
            Kind::real_in("s", SPEC.phase0, 0.0, 60.0),
        ),
        Variable::new("stop", "Slow down to a stop, at once", Input, Kind::Boolean { start: false }),
    ];
    vector(&mut variables, "tcp.position", "Where the tool centre point is to be, base frame", false, "m");
    vector(&mut variables, "tcp.velocity", "How it is to move, base frame", false, "m/s");
    variables.push(Variable::new(
        "override",
        "Factor by which a stop slows the programme down",
        Output,
        Kind::real_in("1", 0.0, 0.0, 1.0),
    ));
    variables.push(Variable::new("leg", "Leg of the programme, counted from 0", Output, Kind::integer_in(0, 0, 6)));
    interface(cell, "controller", "Robot controller of a cell in parts: runs the programme of the tool", variables)
}

fn kinematics_interface(cell: &str) -> Interface {
    let arm = SPEC.robots[0].robot;
    let mut variables = vec![Variable::time()];
    vector(&mut variables, "tcp.position", "Where the tool centre point has to be, base frame", true, "m");
    vector(&mut variables, "tcp.velocity", "How it has to move, base frame", true, "m/s");
    for (place, start) in SPEC.robots[0].start.into_iter().enumerate() {
        if let Kind::Real { start: value, .. } = &mut variables[kinematics::POSITION + place].kind {
            *value = start;
        }
    }
    for joint in 0..6 {
        let (min, max) = arm.range(joint);
        variables.push(Variable::new(
            &format!("q[{}]", joint + 1),
            "Joint angle",
            Output,
            Kind::real_in("rad", 0.0, min, max),
        ));
    }
    for joint in 0..6 {
        variables.push(Variable::new(&format!("qd[{}]", joint + 1), "Joint speed", Output, Kind::real("rad/s")));
    }
    variables.push(Variable::new("payload", "Mass at the flange: tool and workpiece", Output, Kind::real("kg")));
    interface(cell, "kinematics", "Kinematics of a cell in parts: joint angles for the place of the tool", variables)
}
