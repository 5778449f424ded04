//! The verdict of a scan. That nothing was found is said by [`Clean`] alone, which nobody but this folder makes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::Obligations;

/// That everything an answer needs is shown, or assumed by somebody.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Clean(());

impl Clean {
    /// For [`Obligations::clean`], and for verdicts that are read back from files.
    pub(super) const fn earned() -> Self {
        Self(())
    }
}

/// Overall outcome; never a statement of safety.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(from = "Word", into = "Word")]
pub enum Verdict {
    /// At least one hazard.
    HazardsFound,
    /// There is none, and everything that this needs is shown or assumed.
    NoneFound(Clean),
    /// None found, and not shown that there is none.
    Inconclusive,
    /// None found, and the FMU failed on the way.
    FmuFailed,
    /// Stopped by the user before the end, nothing found so far.
    Interrupted,
}

/// Overall outcome in one word; never a statement of safety.
#[derive(Clone, Copy, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "Verdict")]
enum Word {
    /// At least one hazard.
    HazardsFound,
    /// There is none, and everything that this needs is shown or assumed: see the obligations.
    NoneFound,
    /// None found, and not shown that there is none: see the obligations that are open.
    Inconclusive,
    /// None found, and the FMU failed on the way.
    FmuFailed,
    /// Stopped by the user before the end, nothing found so far.
    Interrupted,
}

impl From<Verdict> for Word {
    fn from(verdict: Verdict) -> Self {
        match verdict {
            Verdict::HazardsFound => Self::HazardsFound,
            Verdict::NoneFound(_) => Self::NoneFound,
            Verdict::Inconclusive => Self::Inconclusive,
            Verdict::FmuFailed => Self::FmuFailed,
            Verdict::Interrupted => Self::Interrupted,
        }
    }
}

impl From<Word> for Verdict {
    fn from(word: Word) -> Self {
        match word {
            Word::HazardsFound => Self::HazardsFound,
            Word::NoneFound => Self::NoneFound(Clean::earned()),
            Word::Inconclusive => Self::Inconclusive,
            Word::FmuFailed => Self::FmuFailed,
            Word::Interrupted => Self::Interrupted,
        }
    }
}

/// How a search ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Ended {
    /// With hazards.
    pub found: bool,
    /// Because the FMU failed, or without what it could not do.
    pub failed: bool,
    /// Because somebody stopped it; not because its time was up.
    pub interrupted: bool,
}

impl Verdict {
    /// Of a search that ended so.
    #[must_use]
    pub fn of(Ended { found, failed, interrupted }: Ended, obligations: &Obligations) -> Self {
        match (found, failed, interrupted, obligations.clean()) {
            (true, ..) => Self::HazardsFound,
            (false, true, ..) => Self::FmuFailed,
            (false, false, true, _) => Self::Interrupted,
            (false, false, false, Some(clean)) => Self::NoneFound(clean),
            (false, false, false, None) => Self::Inconclusive,
        }
    }

    /// Whether there is nothing, and everything that this needs is shown or assumed.
    #[must_use]
    pub const fn is_clean(self) -> bool {
        matches!(self, Self::NoneFound(_))
    }
}
