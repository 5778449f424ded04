//! `--merge`: how equal states of the FMU are told, as the command line says it.

use clap::ValueEnum;

use crate::sequences::Merge;

/// See [`Merge`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum MergeBy {
    /// By equal serialised states if the FMU offers them, else by equal inputs
    Auto,
    /// By equal inputs only
    History,
}

impl From<MergeBy> for Merge {
    fn from(by: MergeBy) -> Self {
        match by {
            MergeBy::Auto => Self::Auto,
            MergeBy::History => Self::History,
        }
    }
}
