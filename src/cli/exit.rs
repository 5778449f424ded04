//! Exit codes, and how a failure becomes one.

use miette::Diagnostic;

use crate::campaign::CampaignError;
use crate::cell::CellError;
use crate::cell::error::OpenError;
use crate::scan::{PrepareError, ScanError};

/// No hazard, with nothing open that this needs; or the command did what it was asked.
pub(crate) const NO_HAZARD: u8 = 0;
/// At least one hazard was found.
pub(crate) const HAZARDS: u8 = 1;
/// The command line, the cell file or the FMU file cannot be used.
pub(crate) const UNUSABLE: u8 = 2;
/// The FMU failed while running.
pub(crate) const FMU_FAILED: u8 = 3;
/// Nothing was found, and it is not shown that there is nothing.
pub(crate) const INCONCLUSIVE: u8 = 4;
/// Stopped by the user.
pub(crate) const INTERRUPTED: u8 = 130;

/// The same for `--help`.
pub(super) const HELP: &str = "Exit codes: 0 no hazard, with nothing open that this needs; 1 hazards found; 2 usage, cell file or FMU file error; \
3 the FMU failed while running; 4 nothing found, and not shown that there is nothing (the result says why); 130 interrupted";

/// A failure with its exit code.
pub(crate) struct Failure {
    code: u8,
    report: miette::Report,
}

impl Failure {
    /// A failure of the given class.
    pub(crate) fn new(code: u8, error: impl Diagnostic + Send + Sync + 'static) -> Self {
        Self { code, report: error.into() }
    }

    /// Something is wrong with what the user gave.
    pub(crate) fn unusable(message: impl std::fmt::Display) -> Self {
        Self { code: UNUSABLE, report: miette::miette!("{message}") }
    }

    /// The FMU failed while it ran.
    pub(crate) fn running(message: impl std::fmt::Display) -> Self {
        Self { code: FMU_FAILED, report: miette::miette!("{message}") }
    }

    /// The same, with what to do about it.
    pub(crate) fn running_with_help(message: impl std::fmt::Display, help: impl std::fmt::Display) -> Self {
        Self { code: FMU_FAILED, report: miette::miette!(help = help.to_string(), "{message}") }
    }

    /// Something is wrong with what the user gave, with what to do about it.
    pub(crate) fn unusable_with_help(message: impl std::fmt::Display, help: impl std::fmt::Display) -> Self {
        Self { code: UNUSABLE, report: miette::miette!(help = help.to_string(), "{message}") }
    }

    /// Nothing is wrong, and nothing was shown, with what to do about it.
    pub(super) fn inconclusive(message: impl std::fmt::Display, help: impl std::fmt::Display) -> Self {
        Self { code: INCONCLUSIVE, report: miette::miette!(help = help.to_string(), "{message}") }
    }

    /// Its exit code.
    pub(super) const fn code(&self) -> u8 {
        self.code
    }

    /// What a terminal shows of it.
    pub(super) fn text(&self) -> String {
        format!("{:?}", self.report)
    }
}

impl From<PrepareError> for Failure {
    fn from(error: PrepareError) -> Self {
        let code = if error.while_running() { FMU_FAILED } else { UNUSABLE };
        Self::new(code, error)
    }
}

impl From<OpenError> for Failure {
    fn from(error: OpenError) -> Self {
        Self::new(UNUSABLE, error)
    }
}

impl From<Box<CellError>> for Failure {
    fn from(error: Box<CellError>) -> Self {
        Self::new(UNUSABLE, *error)
    }
}

impl From<ScanError> for Failure {
    fn from(error: ScanError) -> Self {
        Self::new(FMU_FAILED, error)
    }
}

impl From<CampaignError> for Failure {
    fn from(error: CampaignError) -> Self {
        let code = if error.while_running() { FMU_FAILED } else { UNUSABLE };
        Self::new(code, error)
    }
}

impl From<crate::fmi::Error> for Failure {
    fn from(error: crate::fmi::Error) -> Self {
        let code = if error.while_running() { FMU_FAILED } else { UNUSABLE };
        Self { code, report: miette::miette!("{error}") }
    }
}
