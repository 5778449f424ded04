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
    pub const BURST_AT: usize = 9;
    pub const BURST_BY: usize = 10;
    pub const TOLD_SHARE: usize = 11;
    pub const ONCE: usize = 12;
    pub const FORGETS: usize = 13;
    pub const SSM_FROM: usize = 14;
    pub const FIELD_UNTIL: usize = 15;
    pub const FIELD_LATER: usize = 16;
    pub const CLEAR: usize = 17;
    pub const PERSON_X: usize = 18;
    pub const PERSON_Y: usize = 19;
    pub const Q: usize = 20;
    pub const QD: usize = 21;
    pub const OCCUPIED: usize = 22;
    pub const COUNTS: usize = 23;
}

fn variables() -> Vec<Variable> {
    let parameter = |name, about, unit, [start, min, max]: [f64; 3]| {
        Variable::new(name, about, Parameter, Kind::real_in(unit, start, min, max))
    };
    let flag = |name, about| Variable::new(name, about, Parameter, Kind::Boolean { start: false });
    vec![
        Variable::time(),
        parameter("drive.speed", "Speed of the bar", "rad/s", [1.0, 0.01, 5.0]),
        parameter("plc.t_react", "From a demand to the start of the deceleration", "s", [0.05, 0.0, 5.0]),
        parameter("plc.t_ramp", "From full speed to standstill", "s", [0.3, 0.001, 5.0]),
        parameter("filter.tau", "For so long a demand has to last before it counts", "s", [0.0, 0.0, 5.0]),
        flag("muting.enabled", "Whether demands to stop are muted for a time after the start"),
        parameter("muting.hold_time", "For so long after the start demands are muted", "s", [0.0, 0.0, 20.0]),
        parameter("ssm.distance", "The bar stands while a person is nearer than this; 0: off", "m", [0.0, 0.0, 10.0]),
        parameter("field.radius", "Radius of the scanner's field around the bar; 0: off", "m", [0.0, 0.0, 10.0]),
        // What is wrong with it, on demand. Without units that tell what they are: nothing that advice could turn.
        parameter("burst.at", "After so many seconds the bar is faster for 10 ms", "1", [1e3, 0.0, 1e3]),
        parameter("burst.by", "So many rad/s faster", "1", [0.0, 0.0, 20.0]),
        parameter("stopping.told", "The share of qd that is told once a stop is demanded", "1", [1.0, 0.0, 1.0]),
        parameter("latch.once", "Not 0: only the first demand to stop is looked at", "1", [0.0, 0.0, 1.0]),
        parameter("state.forgets", "Not 0: saved states leave out for how long a demand lasted", "1", [0.0, 0.0, 1.0]),
        parameter("ssm.from", "The distance counts after so many seconds", "1", [0.0, 0.0, 1e3]),
        parameter("field.until", "After so many seconds the field has another radius", "1", [1e3, 0.0, 1e3]),
        parameter("field.later", "That radius, metres", "1", [0.0, 0.0, 10.0]),
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
