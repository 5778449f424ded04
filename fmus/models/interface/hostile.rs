//! The variables of the FMU that does harm on purpose; it is written in C, in `hostile`.

use super::variables::Causality::{Input, Output};
use super::variables::{Interface, Kind, Variable, Variant};

/// The interface. The C source holds the places of the variables once more, as its value references.
pub fn interface() -> Interface {
    Interface {
        identifier: "hostile".to_owned(),
        name: "hostile".to_owned(),
        description: "One slowly turning joint that does whatever its file resources/behaviour says: for tests of importers",
        variant: Variant::Faithful,
        variables: vec![
            Variable::time(),
            Variable::new("stop", "While true the drive slows down to a stop", Input, Kind::Boolean { start: false }),
            Variable::new("push", "Speed added from outside", Input, Kind::real_in("rad/s", 0.0, -1.0, 1.0)),
            Variable::new("q", "Angle of the joint", Output, Kind::real("rad")),
            Variable::new(
                "qd",
                "Speed of the joint over the last millisecond; after a behaviour that tries something outside the FMU, 1 \
                 if it could be done, else 0",
                Output,
                Kind::real("rad/s"),
            ),
        ],
    }
}
