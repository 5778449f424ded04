//! The variables of a turning bar whose safety controller has all that such controllers have that can be set wrongly: for
//! tests of advice.

use super::variables::Causality::{Input, Output, Parameter};
use super::variables::{Interface, Kind, Variable, Variant};

/// Place (= value reference) of each variable in the table.
#[allow(missing_docs, reason = "each is described in the table below; in the build script the lint is silent")]
pub mod vr {
    pub const SPEED: usize = 1;
    pub const T_REACT: usize = 2;
    pub const T_RAMP: usize = 3;
    pub const TAU: usize = 4;
    pub const MUTING: usize = 5;
    pub const HOLD_TIME: usize = 6;
    pub const SSM_DISTANCE: usize = 7;
    pub const FIELD_RADIUS: usize = 8;
    pub const CLEAR: usize = 9;
    pub const PERSON_X: usize = 10;
    pub const PERSON_Y: usize = 11;
    pub const Q: usize = 12;
    pub const QD: usize = 13;
    pub const OCCUPIED: usize = 14;
    pub const COUNTS: usize = 15;
}

fn variables() -> Vec<Variable> {
    let parameter = |name, about, unit, [start, min, max]: [f64; 3]| {
        Variable::new(name, about, Parameter, Kind::real_in(unit, start, min, max))
    };
    vec![
        Variable::time(),
        parameter("drive.speed", "Speed of the bar", "rad/s", [1.0, 0.01, 5.0]),
        parameter("plc.t_react", "From a demand to the start of the deceleration", "s", [0.05, 0.0, 5.0]),
        parameter("plc.t_ramp", "From full speed to standstill", "s", [0.3, 0.001, 5.0]),
        parameter("filter.tau", "For so long a demand has to last before it counts", "s", [0.0, 0.0, 5.0]),
        Variable::new(
            "muting.enabled",
            "Whether demands to stop are muted for a time after the start",
            Parameter,
            Kind::Boolean { start: false },
        ),
        parameter("muting.hold_time", "For so long after the start demands are muted", "s", [0.0, 0.0, 20.0]),
        parameter("ssm.distance", "The bar stands while a person is nearer than this; 0: off", "m", [0.0, 0.0, 10.0]),
        parameter("field.radius", "Radius of the scanner's field around the bar; 0: off", "m", [0.0, 0.0, 10.0]),
        Variable::new("clear", "Signal of the mat; false demands a stop", Input, Kind::Boolean { start: true }),
        Variable::new(
            "person.x",
            "Where the person is, from the bar's axis",
            Input,
            Kind::real_in("m", 0.0, -1e3, 1e3),
        ),
        Variable::new(
            "person.y",
            "Where the person is, from the bar's axis",
            Input,
            Kind::real_in("m", -20.0, -1e3, 1e3),
        ),
        Variable::new("q", "Angle of the bar", Output, Kind::real("rad")),
        Variable::new("qd", "Speed of the bar", Output, Kind::real("rad/s")),
        Variable::new("field.occupied", "Whether a person is in the field", Output, Kind::Boolean { start: false }),
        Variable::new(
            "demand.counts",
            "Whether a demand has lasted long enough",
            Output,
            Kind::Boolean { start: false },
        ),
    ]
}

/// The model.
pub fn interface() -> Interface {
    Interface {
        identifier: "guarded".to_owned(),
        name: "guarded".to_owned(),
        description: "A turning bar that a mat, a field and the distance to a person stop: for tests of advice",
        variant: Variant::Faithful,
        variables: variables(),
    }
}
