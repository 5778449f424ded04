//! What became of known hazards in a changed cell, for people and as JUnit XML.

use std::fmt::Write as _;

use quick_junit::{NonSuccessKind, TestCaseStatus};
use schemars::JsonSchema;
use serde::Serialize;

use super::cause::{Cause, grouped};
use super::junit::{self, xml};
use super::model::Hazard;
use super::paragraph::wrapped;

/// A known hazard, tried again.
#[derive(Clone, Debug, PartialEq)]
pub struct Verified {
    /// As it was recorded.
    pub hazard: Hazard,
    /// What became of it.
    pub outcome: Outcome,
}

/// The same for programs.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "VerifiedHazard")]
pub struct Row {
    /// Id of the hazard.
    pub id: String,
    /// Id of its cause, if the scan knows causes.
    pub cause: Option<String>,
    /// Force relative to the limit, as it was recorded.
    pub ratio: f64,
    /// What became of it.
    pub outcome: Outcome,
}

/// What became of a hazard.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "result", rename_all = "snake_case")]
#[schemars(rename = "VerifiedOutcome")]
pub enum Outcome {
    /// Its sequences end without an unsafe contact. Others may lead to the same hazard.
    Fixed,
    /// Nobody has room any more where it begins. Others may lead to the same hazard from elsewhere.
    NoRoom,
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
    /// The changed cell does not judge as strictly by the criterion that it breaks, or not at all; or it does not have a control
    /// that is worked on the way.
    NotJudged,
    /// The FMU failed.
    NotRun {
        /// Why.
        cause: String,
    },
}

impl Verified {
    /// Whether its sequences lead to nothing any more.
    #[must_use]
    pub fn is_fixed(&self) -> bool {
        matches!(self.outcome, Outcome::Fixed | Outcome::NoRoom)
    }

    /// In words.
    #[must_use]
    pub fn line(&self) -> String {
        let Hazard { id, ratio: was, .. } = &self.hazard;
        match &self.outcome {
            Outcome::Fixed => format!("fixed        {id}  {was:.2}x -> its sequences end without an unsafe contact"),
            Outcome::NoRoom => format!("fixed        {id}  {was:.2}x -> nobody has room any more where it begins"),
            Outcome::StillThere { ratio, force_n, body_region, robot_link, time_s } => {
                format!(
                    "STILL THERE  {id}  {was:.2}x -> {ratio:.2}x  {force_n:.0} N  {body_region} <- {robot_link}  at \
                     {time_s:.2} s"
                )
            }
            Outcome::NotJudged => format!(
                "NOT JUDGED   {id}  the changed cell does not count {} as strictly{}",
                self.hazard.class.name().replace('_', " "),
                if self.hazard.worked.is_empty() {
                    ", or has slower arms, or people who do or begin otherwise: see [criteria] and [human]"
                } else {
                    ", or lacks a control that is worked on the way, or has slower arms, or people who do or begin otherwise: see [criteria], [[control]] and [human]"
                }
            ),
            Outcome::NotRun { cause } => format!("NOT RUN      {id}  the FMU failed: {cause}"),
        }
    }
}

/// For programs: a row a hazard.
#[must_use]
pub fn rows(causes: &[Cause], verified: &[Verified]) -> Vec<Row> {
    let row = |one: &Verified| {
        let Hazard { id, ratio, .. } = &one.hazard;
        let cause = causes.iter().find(|cause| cause.hazards.contains(id)).map(|cause| cause.id.clone());
        Row { id: id.clone(), cause, ratio: *ratio, outcome: one.outcome.clone() }
    };
    verified.iter().map(row).collect()
}

/// The hazards of a scan that were tried again, by cause.
fn by_cause<'a>(causes: &'a [Cause], verified: &'a [Verified]) -> Vec<(Option<&'a Cause>, Vec<&'a Verified>)> {
    let of = |one: &Verified| causes.iter().position(|cause| cause.hazards.contains(&one.hazard.id));
    let mut all: Vec<(Option<&Cause>, Vec<&Verified>)> = causes.iter().map(|cause| (Some(cause), Vec::new())).collect();
    for one in verified {
        match of(one) {
            Some(cause) => all[cause].1.push(one),
            // Scans of older versions know no causes.
            None => all.push((None, vec![one])),
        }
    }
    all.retain(|(_, members)| !members.is_empty());
    all
}

/// For people: a line a cause, and one for each of its hazards that is not fixed.
#[must_use]
pub fn render(causes: &[Cause], verified: &[Verified]) -> String {
    let mut out = String::new();
    let is_fixed = |one: &&Verified| one.is_fixed();
    let mut causes_fixed = 0;
    let by_cause = by_cause(causes, verified);
    for (cause, members) in &by_cause {
        let fixed = members.iter().copied().filter(is_fixed).count();
        causes_fixed += usize::from(fixed == members.len());
        let Some(cause) = cause else {
            members.iter().for_each(|one| out += &format!(" {}\n", one.line()));
            continue;
        };
        let of = members.len();
        let there = members.iter().filter(|one| matches!(one.outcome, Outcome::StillThere { .. })).count();
        let (word, rest) = match (fixed == of, there) {
            (true, _) => {
                let room = members.iter().filter(|one| one.outcome == Outcome::NoRoom).count();
                let room = match room {
                    0 => String::new(),
                    room => format!(", or nobody has room where they begin ({room})"),
                };
                (
                    "fixed        ",
                    format!("{}: the sequences of all {of} end without an unsafe contact{room}", cause.id),
                )
            }
            (false, 0) => match members.iter().filter(|one| one.outcome == Outcome::NotJudged).count() {
                0 => ("NOT RUN      ", format!("{}: the FMU failed in {} of {of} hazards", cause.id, of - fixed)),
                n => ("NOT JUDGED   ", format!("{}: {n} of {of} hazards, by what the changed cell counts", cause.id)),
            },
            (false, there) => ("STILL THERE  ", format!("{}: {there} of {of} hazards", cause.id)),
        };
        let _ = writeln!(out, " {word}{rest}");
        let _ = write!(out, "{}", wrapped(&format!("was: {}", cause.sentence), "              "));
        for one in members.iter().copied().filter(|one| !is_fixed(one)) {
            let _ = writeln!(out, "   {}", one.line());
        }
    }
    let fixed = verified.iter().filter(is_fixed).count();
    let causes = match causes.is_empty() {
        true => String::new(),
        false => format!(", {causes_fixed} of {} causes", by_cause.len()),
    };
    let _ = writeln!(
        out,
        "\n {fixed} of {} known hazards fixed{causes}, each by its recorded sequences. Scan again for others that lead \
         there.",
        verified.len()
    );
    out
}

/// As JUnit XML: a test case a cause, which succeeds if all its hazards are fixed.
///
/// # Errors
/// When it cannot be written as XML.
pub fn as_junit(cell: &str, causes: &[Cause], verified: &[Verified]) -> Result<String, quick_junit::SerializeError> {
    let cell = xml(cell);
    let case = |(cause, members): (Option<&Cause>, Vec<&Verified>)| {
        let any = |of: fn(&Outcome) -> bool| members.iter().any(|one| of(&one.outcome));
        let lines: Vec<String> = members.iter().filter(|one| !one.is_fixed()).map(|one| one.line()).collect();
        let failed = |kind, of: &str| {
            let mut status = TestCaseStatus::non_success(kind);
            status.set_type(of).set_message(xml(lines.first().map_or("", String::as_str)));
            status.set_description(xml(&lines.join("\n")));
            status
        };
        let status = if any(|outcome| matches!(outcome, Outcome::StillThere { .. })) {
            failed(NonSuccessKind::Failure, "hazard")
        } else if any(|outcome| matches!(outcome, Outcome::NotRun { .. })) {
            failed(NonSuccessKind::Error, "FMU fault")
        } else if any(|outcome| matches!(outcome, Outcome::NotJudged)) {
            failed(NonSuccessKind::Error, "not judged")
        } else {
            TestCaseStatus::success()
        };
        let hazards: Vec<Hazard> = members.iter().map(|one| one.hazard.clone()).collect();
        let title = grouped(cause.map(std::slice::from_ref).unwrap_or_default(), &hazards)[0].title();
        junit::case(&xml(&title), &cell, status)
    };
    junit::write(&cell, by_cause(causes, verified).into_iter().map(case).collect())
}
