//! What became of known hazards in a changed cell, for people and as JUnit XML.

use std::fmt::Write as _;

use quick_junit::{NonSuccessKind, TestCaseStatus};

use super::junit::{self, xml};
use super::model::Hazard;

/// A known hazard, tried again.
#[derive(Clone, Debug, PartialEq)]
pub struct Verified {
    /// As it was recorded.
    pub hazard: Hazard,
    /// What became of it.
    pub outcome: Outcome,
}

/// What became of a hazard.
#[derive(Clone, Debug, PartialEq)]
pub enum Outcome {
    /// Its sequences end without an unsafe contact. Others may lead to the same hazard.
    Fixed,
    /// One of them ends in an unsafe contact, the hardest of which is this.
    StillThere {
        /// Force relative to the limit.
        ratio: f64,
        /// Force, N.
        force_n: f64,
        /// Body region.
        body_region: String,
        /// Robot link.
        robot_link: String,
        /// Time of the contact, s.
        time_s: f64,
    },
    /// The FMU failed.
    NotRun {
        /// Why.
        cause: String,
    },
}

impl Verified {
    /// In words.
    #[must_use]
    pub fn line(&self) -> String {
        let Hazard { id, ratio: was, .. } = &self.hazard;
        match &self.outcome {
            Outcome::Fixed => format!("fixed        {id}  {was:.2}x -> its sequences end without an unsafe contact"),
            Outcome::StillThere { ratio, force_n, body_region, robot_link, time_s } => {
                format!(
                    "STILL THERE  {id}  {was:.2}x -> {ratio:.2}x  {force_n:.0} N  {body_region} <- {robot_link}  at \
                     {time_s:.2} s"
                )
            }
            Outcome::NotRun { cause } => format!("NOT RUN      {id}  the FMU failed: {cause}"),
        }
    }
}

/// For people.
#[must_use]
pub fn render(verified: &[Verified]) -> String {
    let mut out = String::new();
    for one in verified {
        let _ = writeln!(out, " {}", one.line());
    }
    let fixed = verified.iter().filter(|one| one.outcome == Outcome::Fixed).count();
    let _ = writeln!(
        out,
        "\n {fixed} of {} known hazards fixed, each by its recorded sequences. Scan again for others that lead there.",
        verified.len()
    );
    out
}

/// As JUnit XML: a test case a hazard, which succeeds if it is fixed.
///
/// # Errors
/// When it cannot be written as XML.
pub fn as_junit(cell: &str, verified: &[Verified]) -> Result<String, quick_junit::SerializeError> {
    let cell = xml(cell);
    let case = |one: &Verified| {
        let failed = |kind, of: &str| {
            let mut status = TestCaseStatus::non_success(kind);
            status.set_type(of).set_message(xml(&one.line()));
            status
        };
        let status = match &one.outcome {
            Outcome::Fixed => TestCaseStatus::success(),
            Outcome::StillThere { .. } => failed(NonSuccessKind::Failure, "hazard"),
            Outcome::NotRun { .. } => failed(NonSuccessKind::Error, "FMU fault"),
        };
        junit::case(&junit::title(&one.hazard), &cell, status)
    };
    junit::write(&cell, verified.iter().map(case).collect())
}
