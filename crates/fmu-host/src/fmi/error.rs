//! What can go wrong with an FMU: each message says who is at fault and what to do.

use std::fmt;
use std::path::{Path, PathBuf};

use thiserror::Error;

use super::read_xml::DescriptionError;
use super::variable::Scalar;

/// Status values of FMI 2.0 and FMI 3.0 other than OK and warning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// FMI 2.0: the step was done in part or not at all. FMI 3.0: the FMU is as it was before the call.
    Discard,
    /// The call failed; the instance may be restored or reset.
    Error,
    /// The model must not be called any more, in any instance.
    Fatal,
    /// The call goes on in the background, which this importer does not accept (FMI 2.0).
    Pending,
    /// A number that the standard does not define.
    Unknown(i32),
}

impl fmt::Display for Status {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Discard => f.write_str("Discard (the call was refused)"),
            Self::Error => f.write_str("Error"),
            Self::Fatal => f.write_str("Fatal (it must not be called any more)"),
            Self::Pending => f.write_str("Pending (asynchronous steps are not supported)"),
            Self::Unknown(n) => write!(f, "{n}, which the standard does not define"),
        }
    }
}

/// A failed call.
#[derive(Clone, Debug, PartialEq)]
pub struct CallFailure {
    /// FMI function.
    pub function: &'static str,
    /// What it returned.
    pub status: Status,
    /// Communication point, s, for steps.
    pub time_s: Option<f64>,
    /// Last successful time, s, where the FMU told it.
    pub last_successful_s: Option<f64>,
    /// What the failure means, where the standard says so.
    pub note: Option<&'static str>,
    /// The FMU's last log lines.
    pub log: Vec<String>,
}

impl fmt::Display for CallFailure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write!(f, "the FMU returned {} from {}", self.status, self.function)?;
        if let Some(t) = self.time_s {
            write!(f, " at t = {t:.3} s")?;
        }
        if let Some(t) = self.last_successful_s {
            write!(f, "; it got as far as t = {t:.3} s")?;
        }
        if let Some(note) = self.note {
            write!(f, "; {note}")?;
        }
        write_log(&self.log, f)
    }
}

fn write_log(log: &[String], f: &mut fmt::Formatter<'_>) -> fmt::Result {
    if log.is_empty() {
        return Ok(());
    }
    f.write_str("\nits last log lines:")?;
    log.iter().try_for_each(|line| write!(f, "\n  {line}"))
}

/// The same for messages built elsewhere.
pub(super) struct Log<'a>(pub(super) &'a [String]);

impl fmt::Display for Log<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        write_log(self.0, f)
    }
}

/// Why an FMU cannot be opened, loaded or called.
#[derive(Debug, Error)]
#[non_exhaustive]
pub enum Error {
    /// The file cannot be read.
    #[error("cannot read {path}: {error}")]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        error: std::io::Error,
    },
    /// There is no room, or no permission, to unpack it.
    #[error(
        "cannot unpack {path} into {folder}: {error}. Set the environment variable TMPDIR to a folder with room for it"
    )]
    Unpack {
        /// The file.
        path: PathBuf,
        /// Where to.
        folder: PathBuf,
        /// The system's reason.
        error: std::io::Error,
    },
    /// The archive is damaged, or none at all.
    #[error("{path} is not a readable FMU: {reason}. Export or copy it again")]
    Archive {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// The archive could do harm; nothing was unpacked.
    #[error("{path} was refused, nothing was unpacked: {reason}")]
    Refused {
        /// The file.
        path: PathBuf,
        /// What is wrong.
        reason: String,
    },
    /// modelDescription.xml is missing.
    #[error("{path} has no modelDescription.xml at its top level{hint}")]
    NoDescription {
        /// The file.
        path: PathBuf,
        /// Where one was seen instead.
        hint: String,
    },
    /// modelDescription.xml is wrong.
    #[error("modelDescription.xml of {path}, {problem}")]
    Description {
        /// The file.
        path: PathBuf,
        /// What is wrong, and where.
        problem: DescriptionError,
    },
    /// The FMU is of a kind that cannot be used.
    #[error("{0}")]
    Unsupported(String),
    /// The binary is missing or cannot be loaded.
    #[error("{0}")]
    Binary(String),
    /// The FMU lacks a function that is needed now.
    #[error("the FMU does not have {0}, which is needed here")]
    MissingFunction(&'static str),
    /// The FMU refused to be instantiated.
    #[error("{0}")]
    Instantiation(String),
    /// A call failed.
    #[error("{0}")]
    Call(Box<CallFailure>),
    /// The FMU asked for the end of the simulation.
    #[error("the FMU asked to end the simulation at t = {time_s:.3} s{}", Log(.log))]
    Ended {
        /// When, s.
        time_s: f64,
        /// The FMU's last log lines.
        log: Vec<String>,
    },
    /// The FMU answered OK, but what it said cannot be.
    #[error("{message}{}", Log(.log))]
    Misbehaved {
        /// What it said, and when.
        message: String,
        /// The FMU's last log lines.
        log: Vec<String>,
    },
    /// Values of a type that FMI 2.0 does not have.
    #[error("FMI 2.0 has no {0} variables (an error of this program)")]
    NoSuchType(Scalar),
    /// After a fatal error nothing may be called.
    #[error("the FMU reported a fatal error earlier and must not be called any more: start the program again")]
    AfterFatal,
    /// A state was used on an instance that did not make it.
    #[error(
        "a saved state belongs to the instance that made it and was used on another one (an error of this program)"
    )]
    ForeignState,
}

impl Error {
    /// The same, saying which file is meant.
    pub(super) fn of(self, path: &Path) -> Self {
        let named = |text: String| format!("{}: {text}", path.display());
        match self {
            Self::Unsupported(text) => Self::Unsupported(named(text)),
            Self::Binary(text) => Self::Binary(named(text)),
            other => other,
        }
    }

    /// Whether the running FMU failed, as opposed to a file that is wrong.
    #[must_use]
    pub const fn while_running(&self) -> bool {
        matches!(
            self,
            Self::Call(_)
                | Self::Ended { .. }
                | Self::Misbehaved { .. }
                | Self::AfterFatal
                | Self::ForeignState
                | Self::MissingFunction(_)
                | Self::NoSuchType(_)
        )
    }

    /// Whether no further call on this FMU is allowed.
    #[must_use]
    pub fn is_fatal(&self) -> bool {
        match self {
            Self::AfterFatal => true,
            Self::Call(failure) => failure.status == Status::Fatal,
            _ => false,
        }
    }
}
