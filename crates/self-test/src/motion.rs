//! How two runs of an FMU compare that should show the same motion: by how much, and not bit by bit.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::number;

/// How two runs compare that should show the same motion.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", tag = "result")]
pub enum Motion {
    /// The same motion.
    Same {
        /// Of the outputs that are bound, the one that differs most.
        most: Apart,
        /// An output that the cell does not bind and that shows another motion.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        unbound: Option<Apart>,
    },
    /// Another motion.
    Differs {
        /// The bound output that differs most.
        most: Apart,
    },
    /// The FMU failed in the other run.
    Failed {
        /// What it said.
        reason: String,
    },
    /// Nothing was compared.
    NotTried {
        /// Why.
        why: Untried,
    },
}

/// How far an output is apart in two runs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Apart {
    /// Its name.
    pub output: String,
    /// The largest difference as a share of what it ranges over; of one that counts or is true or false, the share of rows that
    /// differ. What comes up to half a communication step earlier or later (a whole one, of the latter) is no difference.
    pub share: f64,
}

/// Why motions were not compared.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", tag = "kind")]
pub enum Untried {
    /// It was not asked for, or by a version that did not have it.
    #[default]
    NotAsked,
    /// Several FMUs, or one connected with itself: they exchange values once in a communication step.
    Coupled,
    /// The FMU makes steps of its own length only.
    OwnSteps {
        /// This one, s.
        step_s: f64,
    },
    /// The FMU has clocks that are driven once in a communication step, or in Event Mode only.
    Clocks,
    /// The FMU does not repeat its runs.
    NotRepeated,
    /// No output moved.
    NothingMoved,
    /// The FMU has no Event Mode.
    NoEventMode,
    /// The FMU refuses the step.
    Refused {
        /// What it said.
        reason: String,
    },
}

impl Default for Motion {
    fn default() -> Self {
        Self::NotTried { why: Untried::default() }
    }
}

impl fmt::Display for Apart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "`{}` by {:.2} %", self.output, self.share * 100.0)
    }
}

impl fmt::Display for Untried {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotAsked => f.write_str("not asked for"),
            Self::Coupled => f.write_str("connected FMUs exchange values once in a step"),
            Self::OwnSteps { step_s } => write!(f, "the FMU makes steps of {} s only", number(*step_s)),
            Self::Clocks => f.write_str("the FMU has clocks that need Event Mode and tick once in a step"),
            Self::NotRepeated => f.write_str("the FMU does not repeat its runs"),
            Self::NothingMoved => f.write_str("no output moved"),
            Self::NoEventMode => f.write_str("the FMU has no Event Mode"),
            Self::Refused { reason } => write!(f, "the FMU refuses the step: {reason}"),
        }
    }
}

impl fmt::Display for Motion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Same { most, unbound } => {
                write!(f, "same, most apart {most}")?;
                match unbound {
                    Some(apart) => write!(f, "; not bound and WRONG, {apart}"),
                    None => Ok(()),
                }
            }
            Self::Differs { most } => write!(f, "WRONG, {most}"),
            Self::Failed { reason } => write!(f, "FAILED: {reason}"),
            Self::NotTried { why } => write!(f, "not tried: {why}"),
        }
    }
}
