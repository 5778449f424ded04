//! The variables of the model that misbehaves on demand, with and without working state functions.

use super::variables::Causality::{Input, Output, Parameter};
use super::variables::{Interface, Kind, Variable, Variant};

/// Place (= value reference) of each variable in the table.
#[allow(missing_docs, reason = "each is described in the table below; in the build script the lint is silent")]
pub mod vr {
    pub const FAULT_KIND: usize = 1;
    pub const FAULT_STEP: usize = 2;
    pub const STOP: usize = 3;
    pub const PUSH: usize = 4;
    pub const Q: usize = 5;
    pub const QD: usize = 6;
}

fn variables() -> Vec<Variable> {
    vec![
        Variable::time(),
        Variable::new(
            "fault.kind",
            "0 none; 1 q is NaN; 2 a step returns Error; 3 Discard; 4 Fatal; 5 q depends on how many instances the \
             process has made; 6 a saved state forgets the hidden clock; 7 all saved states share one buffer; 8 reset \
             does nothing; 9 q is +infinity; 10 a step returns early at its half (FMI 3.0, where allowed); 11 the FMU \
             ends the simulation after a step; 12 after a step it has an event that doubles the pace of the drive \
             (over FMI 3.0 in event mode, where used); 13 a step that was made says it came only to its half (FMI 3.0); 14 \
             q and qd are 0 until a step was made, and the joint begins at 1.2 rad; 15 q jumps by 0.5 rad, which qd does \
             not tell; 16 like 12, but a step ends at its half with the event, where FMI 3.0 allows that, and the event is \
             left to the importer then, also to one that uses no event mode; 17 like 12, but the event is left to any importer \
             (FMI 3.0); 18 an event like that of 12, 10 ms after the beginning of a step of 20 ms, announced in event mode and \
             handled without; 19 the same, but it is lost if no step ends just then; 20 the same, but it is lost where event \
             mode is not used; 21 the drive's controller runs once in a step, as if that always took 20 ms",
            Parameter,
            Kind::integer_in(0, 0, 21),
        ),
        Variable::new(
            "fault.step",
            "Communication step, counted from 0, at which the fault strikes: kinds 2 to 4, 10 to 13, 16 and 17 in this \
             step, 18 to 20 in this one of 20 ms, 21 always, the others from this step on",
            Parameter,
            Kind::integer_in(0, 0, i32::MAX),
        ),
        Variable::new("stop", "While true the drive slows down to a stop", Input, Kind::Boolean { start: false }),
        Variable::new("push", "Speed added from outside", Input, Kind::real_in("rad/s", 0.0, -1.0, 1.0)),
        Variable::new("q", "Angle of the joint", Output, Kind::real("rad")),
        Variable::new("qd", "Speed of the joint over the last millisecond", Output, Kind::real("rad/s")),
    ]
}

/// The model, faithful (but for its faults) or without state functions.
pub fn interface(variant: Variant) -> Interface {
    let (identifier, name) = variant.names("faulty", "faulty");
    Interface {
        identifier,
        name,
        description: "One slowly turning joint that misbehaves on demand: for tests of importers",
        variant,
        variables: variables(),
    }
}
