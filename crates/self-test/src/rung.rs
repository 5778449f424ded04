//! How the states of an FMU are brought back.

use std::fmt;

use serde::{Deserialize, Serialize};

/// A way of bringing states back, the plainest last. With an FMU that keeps its promises only the speed differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize)]
#[serde(rename_all = "snake_case")]
pub enum StateRestore {
    /// States saved by the FMU.
    SavedStates,
    /// Copies of the FMU's process.
    Copies,
    /// A fresh instance and the same inputs again.
    Instances,
    /// A fresh process and the same inputs again.
    Processes,
}

impl fmt::Display for StateRestore {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::SavedStates => "saved FMU states",
            Self::Copies => "copies of the FMU's process",
            Self::Instances => "fresh instance and replay",
            Self::Processes => "fresh process and replay",
        })
    }
}
