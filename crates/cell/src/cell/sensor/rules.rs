//! How far a safeguard has to stand from the robots by ISO 13855, as its kind says it: the ways past it that the standard knows, and of
//! each where it begins and what it asks for a time until the robots stand. How near the robots come is measured elsewhere.

use super::{DetectionZone, Placing};
use crate::geometry::Cuboid;
use crate::standards::iso_13855::{Edition, Required};

/// A safeguard where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Standing<'a> {
    /// By which edition it is asked.
    pub edition: Edition,
    /// What is known of it besides.
    pub placing: Placing,
    /// Where it detects people.
    pub zone: &'a DetectionZone,
    /// What is in the way, with all doors open.
    pub obstacles: &'a [Cuboid],
}

/// The ways past a safeguard.
#[derive(Default)]
pub struct Rules {
    /// Each of them.
    pub ways: Vec<Approach>,
    /// What is not known of it, and why: then it never counts as far enough away.
    pub not_known: Vec<String>,
    /// What else there is to say.
    pub notes: Vec<String>,
}

/// What is asked for a time until the robots stand, s.
pub type Asks = Box<dyn Fn(f64) -> Required>;

/// What is asked for a time until the robots stand, s, because of what of them is between two heights, m; nothing if nobody gets there.
pub type AsksBetween = Box<dyn Fn(f64, [f64; 2]) -> Option<Required>>;

/// A way past a safeguard.
pub struct Approach {
    /// How somebody comes: through it, over it, into it.
    pub how: &'static str,
    /// From where it is measured, and what is asked.
    pub from: From,
}

/// From where the distance to the robots is measured, and what is asked.
pub enum From {
    /// From where people get over the edge of the zone on the floor, coming from where nothing has seen them.
    Edge {
        /// How deep it has to be at least, m, so that nobody steps over it.
        least_depth_m: Option<f64>,
        /// What is asked.
        asks: Asks,
    },
    /// From a line, seen from above, m.
    Line {
        /// The line.
        line_m: [[f64; 2]; 2],
        /// What is asked.
        asks: Asks,
    },
    /// From a line, to what of the robots is in each of these bands of heights: the one with the least room counts. It is a way only where
    /// the time until the robots stand is known.
    Bands {
        /// The line.
        line_m: [[f64; 2]; 2],
        /// From which height to which each of them is, m.
        bands_m: Vec<[f64; 2]>,
        /// What is asked.
        asks: AsksBetween,
    },
}

impl Rules {
    /// One way.
    #[must_use]
    pub fn one(how: &'static str, from: From) -> Self {
        Self { ways: vec![Approach { how, from }], ..Self::default() }
    }
}
