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
#[serde(from = "VerdictName", into = "VerdictName")]
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
enum VerdictName {
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

impl From<Verdict> for VerdictName {
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

impl From<VerdictName> for Verdict {
    fn from(word: VerdictName) -> Self {
        match word {
            VerdictName::HazardsFound => Self::HazardsFound,
            VerdictName::NoneFound => Self::NoneFound(Clean::earned()),
            VerdictName::Inconclusive => Self::Inconclusive,
            VerdictName::FmuFailed => Self::FmuFailed,
            VerdictName::Interrupted => Self::Interrupted,
        }
    }
}

/// How a search ended.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct SearchEnd {
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
    pub fn of(SearchEnd { found, failed, interrupted }: SearchEnd, obligations: &Obligations) -> Self {
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
