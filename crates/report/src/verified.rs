//! What became of known hazards in a changed cell, for people and as JUnit XML.

use std::fmt::Write as _;

use quick_junit::{NonSuccessKind, TestCaseStatus};
use schemars::JsonSchema;
use serde::Serialize;

use super::junit::{self, xml};
use fmi_hazard_record::cause::{Cause, grouped};
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::narrower::Narrower;
use fmi_hazard_record::paragraph::wrapped;

/// A known hazard, tried again.
#[derive(Clone, Debug, PartialEq)]
pub struct Verified {
    /// As it was recorded.
    pub hazard: Hazard,
    /// What became of it.
    pub outcome: VerifiedOutcome,
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
    pub outcome: VerifiedOutcome,
}

/// What became of a hazard.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(tag = "result", rename_all = "snake_case")]
#[schemars(rename = "VerifiedOutcome")]
pub enum VerifiedOutcome {
    /// Its sequences, from where and when they began, end without an unsafe contact. Others may lead to the same hazard.
    Fixed,
    /// Somebody has no room any more where it begins: nothing is known of who begins elsewhere.
    NoRoom,
    /// A sensor reports somebody already where it begins, which it did not: whoever gets there does so past that sensor.
    Seen {
        /// The sensor.
        sensor: String,
    },
    /// The robot does not move while the person stands where it begins: a robot that stands shows nothing.
    Still {
        /// The robot.
        robot: String,
    },
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
    /// The changed cell asks less than the scan did, so what is not met is not fixed.
    NotJudged {
        /// What of it is narrower.
        cause: Narrower,
    },
    /// The FMU failed.
    NotRun {
        /// Why.
        cause: String,
    },
}

impl VerifiedOutcome {
    /// How it stands.
    #[must_use]
    pub const fn standing(&self) -> Standing {
        match self {
            Self::Fixed => Standing::Fixed,
            Self::NoRoom | Self::Seen { .. } | Self::Still { .. } => Standing::NotShown,
            Self::StillThere { .. } => Standing::StillThere,
            Self::NotJudged { .. } => Standing::NotJudged,
            Self::NotRun { .. } => Standing::NotRun,
        }
    }

    /// In words.
    #[must_use]
    pub fn words(&self) -> String {
        match self {
            Self::Fixed => "its sequences end without an unsafe contact".to_owned(),
            Self::NoRoom => "somebody has no room any more where it begins".to_owned(),
            Self::Seen { sensor } => format!("{sensor} reports somebody already where it begins"),
            Self::Still { robot } => format!("{robot} does not move while somebody stands where it begins"),
            Self::StillThere { ratio, force_n, body_region, robot_link, time_s } => {
                format!("{ratio:.2}x  {force_n:.0} N  {body_region} <- {robot_link}  at {time_s:.2} s")
            }
            Self::NotJudged { cause } => format!("the changed cell {}: {}", cause.words(), cause.help()),
            Self::NotRun { cause } => format!("the FMU failed: {cause}"),
        }
    }
}

/// How a known hazard stands, the worst first.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Standing {
    /// It is there.
    StillThere,
    /// The FMU failed.
    NotRun,
    /// Less is asked than it takes.
    NotJudged,
    /// From where it begins nothing can be shown any more.
    NotShown,
    /// Its sequences end without an unsafe contact.
    Fixed,
}

impl Standing {
    /// As printed.
    #[must_use]
    pub(crate) const fn words(self) -> &'static str {
        match self {
            Self::StillThere => "STILL THERE",
            Self::NotRun => "NOT RUN",
            Self::NotJudged => "NOT JUDGED",
            Self::NotShown => "NOT SHOWN",
            Self::Fixed => "fixed",
        }
    }
}

/// How all of them stand together: as the worst does; nothing if none was known.
#[must_use]
pub fn together(verified: &[Verified]) -> Option<Standing> {
    verified.iter().map(|one| one.outcome.standing()).min()
}

impl Verified {
    /// Whether its sequences lead to nothing any more.
    #[must_use]
    pub(crate) fn is_fixed(&self) -> bool {
        self.outcome.standing() == Standing::Fixed
    }

    /// In words.
    #[must_use]
    pub(crate) fn line(&self) -> String {
        let Hazard { id, ratio: was, .. } = &self.hazard;
        let was = match self.outcome.standing() {
            Standing::Fixed | Standing::StillThere => format!("{was:.2}x -> "),
            Standing::NotRun | Standing::NotJudged | Standing::NotShown => String::new(),
        };
        let says = self.outcome.words();
        format!("{:<11}  {id}  {was}{says}", self.outcome.standing().words())
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
    if verified.is_empty() {
        return format!(" {NONE_KNOWN}. Scan the changed cell.\n");
    }
    let mut out = String::new();
    let mut causes_fixed = 0;
    let by_cause = by_cause(causes, verified);
    for (cause, members) in &by_cause {
        let all_fixed = members.iter().all(|one| one.is_fixed());
        causes_fixed += usize::from(all_fixed);
        let Some(cause) = cause else {
            members.iter().for_each(|one| out += &format!(" {}\n", one.line()));
            continue;
        };
        let _ = writeln!(out, " {}", of_cause(cause, members));
        let _ = write!(out, "{}", wrapped(&format!("was: {}", cause.sentence), "              "));
        for one in members.iter().filter(|one| !one.is_fixed()) {
            let _ = writeln!(out, "   {}", one.line());
        }
    }
    let count = |standing| verified.iter().filter(|one| one.outcome.standing() == standing).count();
    let causes = match causes.is_empty() {
        true => String::new(),
        false => format!(", {causes_fixed} of {} causes", by_cause.len()),
    };
    let _ = writeln!(
        out,
        "\n {} of {} known hazards fixed{causes}, each by its recorded sequences. Scan again for others that lead \
         there.",
        count(Standing::Fixed),
        verified.len()
    );
    if count(Standing::NotShown) > 0 {
        let text = format!(" {} not shown: {WHAT_TO_DO}.", count(Standing::NotShown));
        out += &wrapped(&text, " ");
    }
    out
}

/// What is said where nothing was known.
const NONE_KNOWN: &str = "The scan knows no hazards, so nothing was tried, and nothing is shown";

/// What to do where nothing can be shown from where hazards began.
const WHAT_TO_DO: &str = "their sequences say nothing of the changed cell. Scan it from anywhere (--from anywhere), or from a start outside its \
safeguards with room around it";

/// A line for a cause: it stands as the worst of its hazards does.
fn of_cause(cause: &Cause, members: &[&Verified]) -> String {
    let of = members.len();
    let worst = members.iter().map(|one| one.outcome.standing()).min().unwrap_or(Standing::Fixed);
    let n = members.iter().filter(|one| one.outcome.standing() == worst).count();
    let says = match worst {
        Standing::Fixed => format!("the sequences of all {of} end without an unsafe contact"),
        Standing::StillThere => format!("{n} of {of} hazards"),
        Standing::NotRun => format!("the FMU failed in {n} of {of} hazards"),
        Standing::NotJudged => format!("{n} of {of} hazards: the changed cell asks less than the scan did"),
        Standing::NotShown => format!("{n} of {of} hazards, from where they begin"),
    };
    format!("{:<11}  {}: {says}", worst.words(), cause.id)
}

/// As JUnit XML: a test case a cause, which succeeds if all its hazards are fixed.
///
/// # Errors
/// When it cannot be written as XML.
pub fn as_junit(cell: &str, causes: &[Cause], verified: &[Verified]) -> Result<String, quick_junit::SerializeError> {
    let cell = xml(cell);
    if verified.is_empty() {
        let mut status = TestCaseStatus::skipped();
        status.set_message(NONE_KNOWN);
        return junit::write(&cell, vec![junit::case("known hazards", &cell, status)]);
    }
    let case = |(cause, members): (Option<&Cause>, Vec<&Verified>)| {
        let lines: Vec<String> = members.iter().filter(|one| !one.is_fixed()).map(|one| one.line()).collect();
        let failed = |kind, of: &str| {
            let mut status = TestCaseStatus::non_success(kind);
            status.set_type(of).set_message(xml(lines.first().map_or("", String::as_str)));
            status.set_description(xml(&lines.join("\n")));
            status
        };
        let status = match members.iter().map(|one| one.outcome.standing()).min() {
            Some(Standing::StillThere) => failed(NonSuccessKind::Failure, "hazard"),
            Some(Standing::NotRun) => failed(NonSuccessKind::Error, "FMU fault"),
            Some(Standing::NotJudged) => failed(NonSuccessKind::Error, "not judged"),
            Some(Standing::NotShown) => failed(NonSuccessKind::Error, "not shown"),
            Some(Standing::Fixed) | None => TestCaseStatus::success(),
        };
        let hazards: Vec<Hazard> = members.iter().map(|one| one.hazard.clone()).collect();
        let title = grouped(cause.map(std::slice::from_ref).unwrap_or_default(), &hazards)[0].title();
        junit::case(&xml(&title), &cell, status)
    };
    junit::write(&cell, by_cause(causes, verified).into_iter().map(case).collect())
}
