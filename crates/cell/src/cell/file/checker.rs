//! What checks parts of a cell file: the file at hand, so that each mistake is shown where it stands, and the mistakes so
//! far.

use std::cell::RefCell;
use std::ops::Range;

use super::files::Files;
use super::format::PoseTable;
use crate::cell::CellError;
use crate::cell::error::{Problems, Source};
use crate::fmi::number;
use crate::geometry::{Pose, Vec3, roll_pitch_yaw};

pub(super) fn pose(table: &PoseTable) -> Pose {
    Pose::from_parts(Vec3::from_array(table.xyz_m), roll_pitch_yaw(table.rpy_deg.map(f64::to_radians)))
}

/// Checks with the file at hand, so that each mistake can be shown where it stands.
pub(super) struct Checker<'a> {
    pub(super) source: &'a Source,
    pub(super) problems: Problems,
    /// Files that were read.
    pub(super) files: Files,
    pub(super) warnings: RefCell<Vec<String>>,
}

impl<'a> Checker<'a> {
    pub(super) fn new(source: &'a Source) -> Self {
        Self { source, problems: Problems::default(), files: Files::default(), warnings: RefCell::default() }
    }
}

impl Checker<'_> {
    pub(super) fn that(
        &self,
        ok: bool,
        span: Range<usize>,
        say: impl FnOnce() -> (String, String),
    ) -> Result<(), Box<CellError>> {
        if ok {
            return Ok(());
        }
        let (message, help) = say();
        Err(self.source.error(span, "here", message, Some(help)))
    }

    pub(super) fn positive(&self, value: f64, span: &Range<usize>, what: &str) -> Result<(), Box<CellError>> {
        self.that(value.is_finite() && value > 0.0, span.clone(), || {
            (
                format!("{what} must be greater than zero, not {}", number(value)),
                "check the number and its unit".to_owned(),
            )
        })
    }

    pub(super) fn finite(&self, values: &[f64], span: &Range<usize>, what: &str) -> Result<(), Box<CellError>> {
        self.that(values.iter().all(|v| v.is_finite()), span.clone(), || {
            (format!("{what} is not finite"), "write plain numbers".to_owned())
        })
    }
}
