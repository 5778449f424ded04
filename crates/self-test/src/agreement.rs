//! How two runs of an FMU compare that should be the same, to the last bit, and in what they differ.

use std::fmt;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::text::Said;

/// How two runs that should agree compare.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", tag = "result")]
pub enum Agreement {
    /// Every bit of every output.
    Exact,
    /// Different; the largest relative difference `|a - b| / max(1, |a|)`.
    Differs {
        /// Largest relative difference of numbers; 0 where all numbers are the same.
        largest: f64,
        /// In what the first one differs.
        #[serde(default)]
        first: Difference,
        /// The first output that differs.
        #[serde(default, skip_serializing_if = "Option::is_none")]
        output: Option<String>,
    },
    /// The FMU returned an error.
    Failed {
        /// What it said.
        reason: String,
        /// The last lines that it printed, for people: see `PlantError::printed` of `fmu-host`.
        #[serde(skip)]
        printed: Vec<String>,
    },
    /// The FMU does not offer this.
    NotOffered,
}

/// In what two values differ that should be the same.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Difference {
    /// Two numbers.
    #[default]
    Number,
    /// True and false.
    Truth,
    /// 0 and -0.
    SignOfZero,
    /// A number, and one that is not finite.
    NotFinite,
    /// It could be read once, and not again.
    Unreadable,
}

impl fmt::Display for Difference {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::Number => "other numbers",
            Self::Truth => "true in one run and false in the other",
            Self::SignOfZero => "0 in one run and -0 in the other",
            Self::NotFinite => "a number in one run and none (NaN or infinite) in the other",
            Self::Unreadable => "could be read in one run and not in the other",
        })
    }
}

impl fmt::Display for Agreement {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Exact => f.write_str("exact"),
            Self::Differs { largest, first, output } => {
                let numbers = format!("differs by up to {largest:.2e}");
                match first {
                    Difference::Number => write!(f, "WRONG, {numbers}")?,
                    other => write!(f, "WRONG, {other}")?,
                }
                if let Some(output) = output {
                    write!(f, ", first in `{output}`")?;
                }
                if *first != Difference::Number && *largest > 0.0 {
                    write!(f, "; a number {numbers}")?;
                }
                Ok(())
            }
            Self::Failed { reason, printed } => write!(f, "FAILED: {}", Said { message: reason, printed }),
            Self::NotOffered => f.write_str("not offered"),
        }
    }
}
