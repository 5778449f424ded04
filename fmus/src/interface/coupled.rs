//! The cell `sensor-mat` cut into three FMUs that are to be coupled: safety controller, robot controller, kinematics.

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

/// The three interfaces, upstream first.
pub fn all() -> [Interface; 3] {
    [plc_interface(), controller_interface(), kinematics_interface()]
}

fn interface(part: &str, description: &'static str, variables: Vec<Variable>) -> Interface {
    Interface {
        identifier: format!("{}_{part}", SPEC.identifier),
        name: format!("{}-{part}", SPEC.name),
        description,
        variant: Variant::Faithful,
        variables,
    }
}

fn plc_interface() -> Interface {
    let boolean = |start| Kind::Boolean { start };
    interface(
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

fn controller_interface() -> Interface {
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
    interface("controller", "Robot controller of the cell sensor-mat: runs the programme of the tool", variables)
}

fn kinematics_interface() -> Interface {
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
    interface("kinematics", "Kinematics of the cell sensor-mat: joint angles for the place of the tool", variables)
}
