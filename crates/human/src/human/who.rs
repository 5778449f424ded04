//! Which person of a cell is meant: the one that every cell has, or a second one.

use serde::{Deserialize, Serialize};

/// Which person of a cell.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, PartialOrd, Ord, Hash, Serialize, Deserialize)]
pub enum Who {
    /// The one that every cell has.
    #[default]
    First,
    /// The second one, where the cell file has it.
    Second,
}

impl Who {
    /// Each once.
    pub const ALL: [Self; 2] = [Self::First, Self::Second];
}
