//! What can go wrong with a campaign, whose fault it is and what to do next.

use std::path::{Path, PathBuf};

use thiserror::Error;

use crate::cell::error::OpenError;
use crate::scan::{PrepareError, ScanError};

/// Why a campaign, or a task of it, cannot go on.
#[derive(Debug, Error, miette::Diagnostic)]
#[non_exhaustive]
pub(crate) enum CampaignError {
    /// The campaign file says something that cannot be.
    #[error("your campaign file {} is wrong: {what}", path.display())]
    Description {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        what: String,
        /// What to do.
        #[help]
        help: String,
    },
    /// A cell cannot be opened.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Open(#[from] OpenError),
    /// A cell cannot be simulated.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Prepare(#[from] PrepareError),
    /// The FMU failed.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Scan(#[from] ScanError),
    /// There is no plan, or it is not one of this program.
    #[error("there is no plan in {}: {what}", folder.display())]
    #[diagnostic(help("make one with `fmi-hazard campaign plan CAMPAIGN.toml --out {}`", folder.display()))]
    NoPlan {
        /// Where it was looked for.
        folder: PathBuf,
        /// Why.
        what: String,
    },
    /// What is planned is not what is there.
    #[error("{what} since the campaign was planned")]
    #[diagnostic(help(
        "plan again: results of what has not changed are kept, those of what has changed are not taken"
    ))]
    Changed {
        /// What has changed.
        what: String,
    },
    /// A name of no task.
    #[error("the plan has no task {name}")]
    #[diagnostic(help("`fmi-hazard campaign status DIR --tasks` lists them all"))]
    NoTask {
        /// The name.
        name: String,
    },
    /// Results are missing.
    #[error("{missing} of {of} tasks have no result: {first}{}", if *missing > 1 { " and others" } else { "" })]
    #[diagnostic(help(
        "run them (`fmi-hazard campaign status DIR` says which), or have them worked out here with --work-out-missing, which may \
         take as long as running them"
    ))]
    Missing {
        /// How many.
        missing: usize,
        /// Of how many.
        of: usize,
        /// One of them.
        first: String,
    },
    /// The machine does not give what is needed.
    #[error("this machine cannot {doing} {}: {cause}", path.display())]
    #[diagnostic(help("look at the rights, the space and the health of the disk; what was finished before is kept"))]
    Machine {
        /// What was to be done.
        doing: &'static str,
        /// With which file.
        path: PathBuf,
        /// Why it cannot.
        cause: std::io::Error,
    },
    /// Something of ours is wrong.
    #[error("this is an error of this tool: {0}")]
    #[diagnostic(help("please report it, with the campaign file"))]
    Ours(String),
}

impl CampaignError {
    /// Whether it is the FMU's fault, while it ran.
    #[must_use]
    pub(crate) fn while_running(&self) -> bool {
        match self {
            Self::Prepare(error) => error.while_running(),
            Self::Scan(_) => true,
            _ => false,
        }
    }

    /// For a file that cannot be read, written or made.
    pub(super) fn machine(doing: &'static str, path: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let path = path.to_owned();
        move |cause| Self::Machine { doing, path, cause }
    }
}
