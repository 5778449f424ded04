//! The variables of the gantry: two slides, one on the other, and a safety controller whose stop can be of many kinds.

use super::variables::Causality::{Input, Output, Parameter};
use super::variables::{Interface, Kind, Variable, Variant};

/// Slides.
pub const AXES: usize = 2;

/// Place (= value reference) of each variable in the table. Those of the second slide follow those of the first.
#[allow(missing_docs, reason = "each is described in the table below; in the build script the lint is silent")]
pub mod vr {
    pub const LATCHED: usize = 1;
    pub const REACTION: usize = 2;
    pub const FILTER: usize = 3;
    pub const RAMP: usize = 4;
    pub const MUTING_FROM: usize = 5;
    pub const MUTING_TO: usize = 6;
    pub const FAILS_UNTIL: usize = 7;
    pub const STROKE: usize = 8;
    pub const SPEED: usize = 10;
    pub const PHASE0: usize = 12;
    pub const CURTAIN_CLEAR: usize = 14;
    pub const DOOR_CLEAR: usize = 15;
    pub const RESET: usize = 16;
    pub const POSITION: usize = 17;
    pub const VELOCITY: usize = 19;
    pub const LEG: usize = 21;
    pub const OWN_Y: usize = 22;
    pub const OWN_DEPTH: usize = 23;
    pub const PERSON_Y: usize = 24;
    pub const INTERRUPTED: usize = 25;
    pub const GATE_STATE: usize = 26;
    pub const MAT_LEVEL: usize = 27;
    pub const CURTAIN_STATE: usize = 28;
}

/// The longest time of a parameter, ms.
const LONGEST: i32 = 3_600_000;

fn variables() -> Vec<Variable> {
    let milliseconds = |name: &str, about: &str, start| {
        Variable::new(
            name,
            about,
            Parameter,
            Kind::integer_in(start, if name == "plc.ramp_ms" { 1 } else { 0 }, LONGEST),
        )
    };
    let of_axes = |name: &str, about: &str, causality, kind: [Kind; AXES]| {
        [0, 1].map(|axis| Variable::new(&format!("{name}[{}]", axis + 1), about, causality, kind[axis]))
    };
    let boolean = |start| Kind::Boolean { start };
    let mut all = vec![
        Variable::time(),
        Variable::new(
            "plc.latched",
            "Whether a stop lasts until the reset button is pressed; else it ends with the demand",
            Parameter,
            boolean(true),
        ),
        milliseconds("plc.reaction_ms", "From a demand that counts to the beginning of the ramp, ms", 40),
        milliseconds("plc.filter_ms", "A demand counts when it has lasted so long, ms", 0),
        milliseconds("plc.ramp_ms", "From full pace to standstill, and back, ms", 200),
        milliseconds("muting.from_ms", "The curtain is muted from here, ms after the start", 0),
        milliseconds("muting.to_ms", "To here; never, if that is not later", 0),
        milliseconds(
            "fault.fails_until_ms",
            "A demand of the door before this makes the step fail, ms after the start",
            0,
        ),
    ];
    let stroke = Kind::real_in("m", 0.0, 0.0, 100.0);
    let speed = Kind::real_in("m/s", 0.0, 0.0, 10.0);
    all.extend(of_axes("axis.stroke", "Way between the ends of the slide", Parameter, [stroke; AXES]));
    all.extend(of_axes("axis.speed", "Speed at full pace, at once at both ends", Parameter, [speed; AXES]));
    let phase = Kind::real_in("s", 0.0, 0.0, 1000.0);
    all.extend(of_axes(
        "axis.phase0",
        "Time at full pace from the near end to where the slide starts",
        Parameter,
        [phase; AXES],
    ));
    all.extend([
        Variable::new("plc.curtain_clear", "Signal of the light curtain; false demands a stop", Input, boolean(true)),
        Variable::new("plc.door_clear", "Signal of the door; false demands a stop", Input, boolean(true)),
        Variable::new("plc.reset", "The reset button is down", Input, boolean(false)),
    ]);
    all.extend(of_axes("axis.position", "Position of the slide", Output, [Kind::real("m"); AXES]));
    all.extend(of_axes("axis.velocity", "Velocity of the slide", Output, [Kind::real("m/s"); AXES]));
    let leg = "0 while the first slide moves away from its near end, 1 while it comes back";
    all.push(Variable::new("ctrl.leg", leg, Output, Kind::integer_in(0, 0, 1)));
    let at = "Where the curtain is, along x";
    all.push(Variable::new("curtain.own_y", at, Parameter, Kind::real_in("m", 0.0, -1e3, 1e3)));
    let depth = "The curtain itself sees who is no farther from it; nobody, if that is 0";
    all.push(Variable::new("curtain.own_depth", depth, Parameter, Kind::real_in("m", 0.0, 0.0, 10.0)));
    all.push(Variable::new("person.y", "Where the person is", Input, Kind::real_in("m", -1e3, -1e3, 1e3)));
    let interrupted = "Whether the curtain itself sees a person";
    all.push(Variable::new("curtain.interrupted", interrupted, Output, Kind::Boolean { start: false }));
    // The same signals as numbers, as some safety controllers have them.
    let gate = "The gate: 1 = closed, 0 = open, 2 = fault; all but 1 demand a stop";
    all.push(Variable::new("plc.gate_state", gate, Input, Kind::integer_in(1, 0, 2)));
    let level = "Level of the mat, which demands a stop from 0.5 on";
    all.push(Variable::new("plc.mat_level", level, Input, Kind::real_in("1", 0.0, 0.0, 1.0)));
    let state = "What the curtain itself sees: 7 = nobody, 4 = somebody";
    all.push(Variable::new("curtain.state", state, Output, Kind::integer_in(7, 0, 9)));
    all
}

/// The model.
pub fn interface() -> Interface {
    let (identifier, name) = Variant::Faithful.names("gantry", "gantry");
    Interface {
        identifier,
        name,
        description: "Two slides that move back and forth; its stop can be latched or not, muted, filtered and late",
        variant: Variant::Faithful,
        variables: variables(),
    }
}
