//! Changes of a cell against a hazard: what came of each, and what that rests on.

use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::Serialize;

use super::begin::InitialConditionRecord;
use super::figures::grouped;
use super::paragraph::wrapped;
use crate::human::Action;
use crate::standards::BodyRegion;
use fmi_hazard_criteria::criterion::Class;

/// A change of the cell against a hazard.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RiskReduction {
    /// The change, in words: the smallest that helps, else the largest that was tried.
    pub change: String,
    /// The cell file with it.
    #[serde(skip)]
    pub cell: String,
    /// What the cell file allows, if nothing beyond was tried for that reason, and nothing up to there is enough.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub limit: Option<String>,
    /// What came of it.
    pub outcome: RiskReductionOutcome,
}

/// What came of a change.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
#[schemars(rename = "RemedyOutcome")]
pub enum RiskReductionOutcome {
    /// Nothing in the cell is hazardous any more: every sequence was looked at.
    Sufficient(TestedAgainst),
    /// No hazard was met, but not everything was looked at.
    NotMet(TestedAgainst),
    /// The cause of this hazard is gone, other causes of the scan are not.
    OthersRemain(RemainingHazards),
    /// No hazard is met within the time that the cell file looks at, but later.
    OnlyLater(HazardAfterChange),
    /// It is met no more, for a reason that does not count.
    NoAdvice {
        /// The reason.
        cause: String,
    },
    /// The hazard is still met.
    NoHelp {
        /// Why no more of the change was tried.
        limit: Option<String>,
    },
    /// The cell or the FMU does not take the change.
    NotTried {
        /// Why.
        cause: String,
    },
}

/// What a change was held against.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
pub struct TestedAgainst {
    /// Sequences of the scan, for all its hazards.
    pub known_sequences: usize,
    /// Sequences that led to a hazard after smaller changes.
    pub counterexamples: u32,
    /// New sequences from the start.
    pub searched: u32,
    /// The complete search from each of the cell's beginnings, the own first.
    pub complete: Vec<ExhaustiveCheck>,
    /// Places around the start from which the person began, too.
    pub around: usize,
    /// Whether all sequences from there were looked at, else some.
    pub around_complete: bool,
    /// What came of a search from anywhere, if there was one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub everywhere: Option<ReachabilityCheck>,
    /// Longest time of known and new sequences that were tried beyond that of the cell file, s.
    pub longest_s: f64,
    /// What one step less leads to.
    pub one_less: NextSmaller,
}

/// A search from anywhere in which nobody was shown to be hit.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "RemedyFromAnywhere")]
pub struct ReachabilityCheck {
    /// How long after the start of the FMU, s.
    pub until_s: f64,
    /// Why it does not show that nobody is hit; nothing if it does.
    pub reasons: Vec<String>,
    /// Whether it is only close: on some floor it is not known whether somebody is hit, so a little more of the change may be shown.
    #[serde(skip)]
    pub is_close: bool,
}

/// A complete search.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct ExhaustiveCheck {
    /// From which of the cell's beginnings, from 1.
    pub beginning: usize,
    /// How many sequences there are, in decimal.
    pub sequences: String,
    /// How many actions they have.
    pub actions: usize,
    /// All of so many actions were looked at.
    pub looked_at: usize,
    /// Why not all; nothing if it is complete.
    pub reasons: Vec<String>,
}

/// What the next smaller change leads to.
#[derive(Clone, Debug, Default, PartialEq, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum NextSmaller {
    /// No change at all: the cell as it is.
    #[default]
    AsItIs,
    /// A hazard.
    Met(HazardAfterChange),
    /// It cannot be tried.
    NotTried {
        /// Why.
        cause: String,
    },
    /// Nothing is met with a little less, and it is too close to be shown for everybody from anywhere.
    Close {
        /// The least of the change with which nothing was met, in words.
        change: String,
        /// What one step less than that leads to, if it is a hazard.
        met: Option<HazardAfterChange>,
    },
}

/// A hazard that was met after a change.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct HazardAfterChange {
    /// What it breaks.
    pub class: Class,
    /// What is hit.
    pub body_region: BodyRegion,
    /// By what.
    pub robot_link: String,
    /// Force over limit.
    pub ratio: f64,
    /// Time of the contact, s.
    pub time_s: f64,
    /// The sequence.
    pub actions: Vec<Action>,
    /// Where it begins, if that is not where the scan began.
    pub from: Option<InitialConditionRecord>,
    /// The cell file in which it is met.
    #[serde(skip)]
    pub cell: String,
    /// Which of its beginnings that is, from 0.
    #[serde(skip)]
    pub beginning: usize,
}

/// What is left after a change.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct RemainingHazards {
    /// Different hazards of other causes that were met; there may be more.
    pub at_least: usize,
    /// The worst of them, if any was met.
    pub worst: Option<HazardAfterChange>,
    /// Whether every sequence was looked at for hazards that are of no other cause.
    pub complete: bool,
    /// What it was held against.
    pub checked: TestedAgainst,
}

impl HazardAfterChange {
    fn words(&self) -> String {
        let mut words = format!(
            "{:.2}x {} {} {} after {:.2} s",
            self.ratio,
            self.body_region.words(),
            self.class.done().join(" "),
            self.robot_link,
            self.time_s
        );
        if let Some(InitialConditionRecord { xy_m: [x, y], heading_deg, begins_s }) = &self.from {
            let _ = write!(words, ", from ({x:.2}, {y:.2}) m, {heading_deg:.0} degrees");
            if *begins_s > 0.0 {
                let _ = write!(words, ", {begins_s:.2} s after the FMU");
            }
        }
        words
    }
}

impl TestedAgainst {
    /// Whether every sequence was looked at, from each of the cell's beginnings that it is about.
    #[must_use]
    pub fn is_complete(&self) -> bool {
        !self.complete.is_empty() && self.complete.iter().all(|complete| complete.reasons.is_empty())
    }

    /// Whether nothing is left: every sequence was looked at, and everybody from anywhere.
    #[must_use]
    pub fn is_enough(&self) -> bool {
        self.enough_until_s().is_some()
    }

    /// The same, with how long everybody from anywhere was looked for, s after the start of the FMU.
    #[must_use]
    pub(crate) fn enough_until_s(&self) -> Option<f64> {
        let from_anywhere = self.everywhere.as_ref().filter(|from_anywhere| from_anywhere.reasons.is_empty())?;
        self.is_complete().then_some(from_anywhere.until_s)
    }

    /// Which of two says more.
    #[must_use]
    pub fn rank(&self) -> u8 {
        u8::from(self.is_complete()) + u8::from(self.is_enough())
    }

    /// What was looked at, in words.
    #[must_use]
    pub(crate) fn words(&self) -> String {
        let mut words: Vec<String> = Vec::new();
        if self.complete.is_empty() {
            words.push("no search of every sequence".to_owned());
        }
        for (number, complete) in self.complete.iter().enumerate() {
            let from = if number == 0 { String::new() } else { format!(" from beginning {}", complete.beginning) };
            words.push(if complete.reasons.is_empty() {
                format!("all {} sequences of {} actions{from}", grouped(&complete.sequences), complete.actions)
            } else {
                let [looked_at, actions] = [complete.looked_at, complete.actions];
                format!("all sequences of {looked_at} of {actions} actions{from}, longer ones in part")
            });
        }
        let known = self.known_sequences + self.counterexamples as usize;
        words.push(format!("{known} known sequences and {} new ones", self.searched));
        match self.around {
            0 => {}
            n if self.around_complete => words.push(format!("all sequences from {n} places around the start")),
            n => words.push(format!("some from each of {n} places around the start")),
        }
        match &self.everywhere {
            Some(ReachabilityCheck { until_s, reasons, .. }) => words.push(match reasons.first() {
                None => format!("everybody who comes from anywhere, until {until_s:.1} s"),
                Some(reason) => format!("from anywhere that nobody is hit is not shown: {reason}"),
            }),
            None => words.push("nobody who comes from elsewhere".to_owned()),
        }
        if self.longest_s > 0.0 {
            words.push(format!("some of up to {:.1} s", self.longest_s));
        }
        words.join("; ")
    }

    /// What one step less leads to, in words.
    pub(super) fn one_less(&self) -> String {
        match &self.one_less {
            NextSmaller::AsItIs => "One step less is the cell as it is.".to_owned(),
            NextSmaller::Met(met) => format!("One step less: {}.", met.words()),
            NextSmaller::NotTried { cause } => format!("One step less cannot be tried: {cause}."),
            NextSmaller::Close { change, met } => {
                let less =
                    met.as_ref().map_or_else(String::new, |met| format!(" One step less than that: {}.", met.words()));
                format!(
                    "With {change} no hazard was met, but it is too close to be shown for everybody from anywhere.{less}"
                )
            }
        }
    }
}

impl RiskReduction {
    /// One line as soon as it is known; nothing if it is no advice.
    #[must_use]
    pub fn told(&self) -> Option<String> {
        match &self.outcome {
            RiskReductionOutcome::Sufficient(checked) if checked.is_enough() => {
                Some(format!("{}: no hazard is left", self.change))
            }
            RiskReductionOutcome::Sufficient(_) => {
                Some(format!("{}: no hazard is left from the starts in the cell file", self.change))
            }
            RiskReductionOutcome::NotMet(_) => {
                Some(format!("{}: no hazard was met; not every sequence was looked at", self.change))
            }
            RiskReductionOutcome::OthersRemain(_) => {
                Some(format!("{}: this cause is gone, others remain", self.change))
            }
            _ => None,
        }
    }
}

/// The title of what is enough.
const ENOUGH: &str = "Enough: smallest changes after which nothing in the cell is hazardous, from anywhere";

/// A title, and the changes under it with what is said of each.
fn section(out: &mut String, title: &str, changes: &[(&str, Vec<String>)]) {
    if changes.is_empty() {
        return;
    }
    let _ = writeln!(out, "\n {title}");
    for (change, lines) in changes {
        *out += &wrapped(change, "   ");
        lines.iter().for_each(|line| *out += &wrapped(line, "      "));
    }
}

/// All of them, for people: what is enough comes first.
#[must_use]
pub fn render(remedies: &[RiskReduction]) -> String {
    if remedies.is_empty() {
        return String::new();
    }
    let mut out = String::new();
    let of = |lines: &dyn Fn(&RiskReductionOutcome) -> Option<Vec<String>>| -> Vec<(&str, Vec<String>)> {
        let told = |remedy: &RiskReduction| {
            let limit = remedy.limit.iter().map(|limit| format!("More was not tried: {limit}."));
            Some(lines(&remedy.outcome)?.into_iter().chain(limit).collect())
        };
        remedies.iter().filter_map(|remedy| Some((remedy.change.as_str(), told(remedy)?))).collect()
    };
    let sufficient = |enough: bool| {
        of(&|outcome| match outcome {
            RiskReductionOutcome::Sufficient(checked) if checked.is_enough() == enough => {
                Some(vec![format!("Looked at: {}.", checked.words()), checked.one_less()])
            }
            _ => None,
        })
    };
    let enough = sufficient(true);
    section(&mut out, ENOUGH, &enough);
    if enough.is_empty() {
        let _ = writeln!(out, "\n {ENOUGH}\n   none of those tried is shown to be");
    }
    section(
        &mut out,
        "Tried in part: nothing is hazardous from the starts in the cell file, every sequence looked at; from elsewhere that is not shown",
        &sufficient(false),
    );
    let not_met = of(&|outcome| match outcome {
        RiskReductionOutcome::NotMet(checked) => {
            let mut lines = vec![format!("Looked at: {}.", checked.words())];
            lines.extend(checked.complete.iter().flat_map(|c| c.reasons.first()).map(|r| format!("Not all: {r}.")));
            lines.push(checked.one_less());
            Some(lines)
        }
        _ => None,
    });
    section(&mut out, "Tried in part: no hazard was met after these, and not every sequence was looked at", &not_met);
    let others = of(&|outcome| match outcome {
        RiskReductionOutcome::OthersRemain(others) => {
            let mut lines = vec![format!("Looked at: {}.", others.checked.words()), others.checked.one_less()];
            if let (Some(worst), s) = (&others.worst, if others.at_least == 1 { "" } else { "s" }) {
                lines.push(format!("Left, at least: {} hazard{s}, worst {}.", others.at_least, worst.words()));
            }
            Some(lines)
        }
        _ => None,
    });
    section(&mut out, "Smallest changes after which this cause is gone; other causes remain", &others);
    let later = of(&|outcome| match outcome {
        RiskReductionOutcome::OnlyLater(met) => Some(vec![format!("Met again: {}.", met.words())]),
        _ => None,
    });
    section(&mut out, "Not enough: only later than the cell file looks", &later);
    let mut causes: Vec<(&str, Vec<&str>)> = Vec::new();
    for remedy in remedies {
        let RiskReductionOutcome::NoAdvice { cause } = &remedy.outcome else { continue };
        match causes.iter_mut().find(|(known, _)| known == cause) {
            Some((_, changes)) => changes.push(&remedy.change),
            None => causes.push((cause, vec![&remedy.change])),
        }
    }
    let no_advice: Vec<(&str, Vec<String>)> =
        causes.iter().map(|(cause, changes)| (*cause, vec![format!("{}.", changes.join("; "))])).collect();
    section(&mut out, "Not advised", &no_advice);
    out.push('\n');
    let no_help = |remedy: &RiskReduction| match &remedy.outcome {
        RiskReductionOutcome::NoHelp { limit: None } => Some(remedy.change.clone()),
        RiskReductionOutcome::NoHelp { limit: Some(why) } => Some(format!("{} (not more: {why})", remedy.change)),
        _ => None,
    };
    let no_help: Vec<String> = remedies.iter().filter_map(no_help).collect();
    if !no_help.is_empty() {
        out += &wrapped(&format!("Does not help alone: {}.", no_help.join("; ")), "   ");
    }
    for remedy in remedies {
        if let RiskReductionOutcome::NotTried { cause } = &remedy.outcome {
            out += &wrapped(&format!("Could not be tried: {}: {cause}", remedy.change), "   ");
        }
    }
    out += &wrapped(
        "Make the change, then scan again. All this is about the model, from the starts and for the times said above. Whether \
         a change can be built, and what it does to the work, is for people to judge.",
        "   ",
    );
    out
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Enough takes every sequence and everybody from anywhere: with either of them missing or in part it is not said, in no words.
    #[test]
    fn enough_is_said_of_what_nothing_is_open_with() {
        let from_start = |reasons: &[&str]| ExhaustiveCheck {
            beginning: 1,
            sequences: "36".to_owned(),
            actions: 1,
            looked_at: 1,
            reasons: reasons.iter().map(|&reason| reason.to_owned()).collect(),
        };
        let from_anywhere = |reason: Option<&str>| {
            Some(ReachabilityCheck {
                until_s: 4.0,
                reasons: reason.map(str::to_owned).into_iter().collect(),
                is_close: false,
            })
        };
        let checked = |complete: Vec<ExhaustiveCheck>, everywhere: Option<ReachabilityCheck>| TestedAgainst {
            complete,
            everywhere,
            ..TestedAgainst::default()
        };
        let whole = checked(vec![from_start(&[])], from_anywhere(None));
        assert_eq!((whole.enough_until_s(), whole.rank()), (Some(4.0), 2));
        let told = |checked: TestedAgainst| {
            let remedy = RiskReduction {
                change: "mat wider".to_owned(),
                cell: String::new(),
                limit: None,
                outcome: RiskReductionOutcome::Sufficient(checked),
            };
            (remedy.told().unwrap(), render(&[remedy]))
        };
        assert!(told(whole).0.ends_with("no hazard is left"));
        for less in [
            checked(vec![from_start(&[])], None),
            checked(vec![from_start(&[])], from_anywhere(Some("2 cells are open"))),
            checked(vec![from_start(&["a robot never moved"])], from_anywhere(None)),
            checked(Vec::new(), from_anywhere(None)),
        ] {
            assert!(!less.is_enough() && less.rank() < 2, "{less:?}");
            let (line, all) = told(less);
            assert!(line.ends_with("from the starts in the cell file"), "{line}");
            assert!(all.contains("none of those tried is shown to be") && all.contains("Tried in part"), "{all}");
        }
    }
}
