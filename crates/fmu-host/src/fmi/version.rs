//! Versions of the standard.

use std::fmt;

/// Version of the standard an FMU is made for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum FmiVersion {
    /// FMI 2.0.
    V2,
    /// FMI 3.0.
    V3,
}

impl fmt::Display for FmiVersion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::V2 => "FMI 2.0",
            Self::V3 => "FMI 3.0",
        })
    }
}
