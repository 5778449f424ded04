//! The variables of the model whose saved states lie.

use super::variables::Causality::{Input, Output, Parameter};
use super::variables::{Interface, Kind, Variable, Variant};

/// Place (= value reference) of each variable in the table.
#[allow(missing_docs, reason = "each is described in the table below; in the build script the lint is silent")]
pub mod vr {
    pub const LIE: usize = 1;
    pub const STOP: usize = 2;
    pub const X: usize = 3;
    pub const Y: usize = 4;
    pub const Q: usize = 5;
    pub const QD: usize = 6;
    pub const SPARE: usize = 7;
}

fn variables() -> Vec<Variable> {
    let place = |start| Kind::real_in("m", start, -100.0, 100.0);
    vec![
        Variable::time(),
        Variable::new(
            "lie",
            "0 none; 1 a saved state lacks the flag that the person came near, and so do its bytes; 2 a restored state \
             keeps a latch that was set since; 3 only the bytes lack the flag; 4 a saved state lacks the past of the \
             integrator, which restarts when x or y changes; 5 spare is noise; 6 q is noise once the person came near; \
             7 a state saved within 12 steps after x or y changed, having been held, is restored wrongly; 8 all instances of a \
             process share the flag, which nothing takes back; 9 only the bytes lack the flag, which is that the person \
             came past a corner, and matters once the person is near",
            Parameter,
            Kind::integer_in(0, 0, 9),
        ),
        Variable::new("stop", "While true the drive slows down to a stop", Input, Kind::Boolean { start: false }),
        Variable::new("x", "Where the person is", Input, place(9.0)),
        Variable::new("y", "Where the person is", Input, place(9.0)),
        Variable::new("q", "Angle of the joint", Output, Kind::real("rad")),
        Variable::new("qd", "Speed of the joint over the last millisecond", Output, Kind::real("rad/s")),
        Variable::new("spare", "Nothing that moves; with lie 5 noise", Output, Kind::real("rad")),
    ]
}

/// The model.
pub fn interface() -> Interface {
    Interface {
        identifier: "liar".to_owned(),
        name: "liar".to_owned(),
        description: "One turning joint that slows down for good once a person comes near, and lies about its state on \
                      demand: for tests of importers",
        variant: Variant::Faithful,
        variables: variables(),
    }
}
