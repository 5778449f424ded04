//! A cause as it stands in `scan.json`: what is wrong in one sentence, how bad it is, and the hazards under it.

use std::collections::{BTreeMap, BTreeSet};

use num_bigint::BigUint;
use num_traits::ToPrimitive as _;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::advice::{RiskReduction, RiskReductionOutcome};
use super::figures::{percent, plural};
use super::hazard::{HELD_WORDS, Hazard, SensorState};
use super::judged::{Judged, Measure};
use super::operated::worked_words;
use super::paragraph::wrapped;
use crate::standards::BodyRegion;
use fmi_hazard_criteria::cause::LONG_S;
use fmi_hazard_criteria::{BodyOrArm, Class};

/// Hazards that are one flaw.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Cause {
    /// Stable id.
    pub id: String,
    /// What is wrong, in one plain sentence.
    pub sentence: String,
    /// The robot.
    pub robot: String,
    /// What of the person is hit.
    pub part: BodyOrArm,
    /// The sensors at the contact of its worst hazard.
    pub sensors: Vec<SensorState>,
    /// Id of its worst hazard.
    pub worst: String,
    /// Why that is one.
    pub class: Class,
    /// How it was judged, where another criterion counts than the transient force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judged: Option<Judged>,
    /// Force of it that decides, N.
    pub force_n: f64,
    /// Limit, N.
    pub limit_n: f64,
    /// `force_n / limit_n`, or what else is over its limit.
    pub ratio: f64,
    /// Speed of the robot's point, m/s, where that is what counts.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub speed_m_s: Option<f64>,
    /// Earliest contact over all its hazards, s.
    pub earliest_time_s: f64,
    /// Sequences of full length that begin with one of its hazards, in decimal, where all were looked at.
    pub sequences: Option<String>,
    /// The same as a part of all sequences.
    pub share: Option<f64>,
    /// How many of its hazards a fresh replay confirmed.
    pub confirmed: usize,
    /// Ids of its hazards, worst first.
    pub hazards: Vec<String>,
    /// The same by what is hit by what, worst first.
    pub lines: Vec<Line>,
    /// What would be enough against it; none if that was not looked for.
    pub advice: Option<CauseAdvice>,
}

/// The hazards of a cause in which one link hits one region.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Line {
    /// What is hit.
    pub body_region: BodyRegion,
    /// Whether that is what the hand holds.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub held: bool,
    /// By what.
    pub robot_link: String,
    /// The highest force over its limit.
    pub ratio: f64,
    /// Their ids, worst first.
    pub hazards: Vec<String>,
}

impl Line {
    /// What is hit, in words.
    #[must_use]
    pub const fn words(&self) -> &'static str {
        if self.held { HELD_WORDS } else { self.body_region.words() }
    }
}

/// What was found against a cause.
#[derive(Clone, Debug, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CauseAdvice {
    /// The smallest changes that were not found wanting, the surest first: only what is `enough` helps for sure.
    pub changes: Vec<Change>,
    /// What was tried, and what that is worth.
    pub note: String,
}

/// A change of the cell with which a cause was not met any more.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Change {
    /// In words.
    pub change: String,
    /// What it was held against, in words.
    pub checked: String,
    /// Whether every sequence of the changed cell was looked at.
    pub complete: bool,
    /// Nothing is hazardous with it: every sequence was looked at, and everybody who comes from anywhere until then, s after the start of
    /// the FMU. Without it that is not shown.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub enough_until_s: Option<f64>,
    /// Whether nothing in the cell is hazardous with it; else only this cause is gone.
    pub removes_all: bool,
    /// What the next smaller change leads to, in words.
    pub less: String,
}

/// What is known of the worst hazard of a cause besides its record: from its sequence once more, and from the cell.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Circumstances {
    /// Whether the link had become slower since the first sensor reported the person.
    pub slowed: bool,
    /// How far the person stands outside of the zones of sensors that report nobody, m, by name.
    pub outside: Vec<(String, f64)>,
    /// For an arm: what it reaches over on its way from the shoulder to the contact.
    pub over: Option<String>,
    /// And what it reaches under.
    pub under: Option<String>,
    /// The curtain below which the whole person gets on the way, while it reports nobody.
    pub got_below: Option<String>,
    /// What the robot carries, kg, where the FMU tells it.
    pub payload_kg: Option<f64>,
}

impl Cause {
    /// A cause without advice. `hazards` are its members, worst first; `all` is how many sequences there are, if they were
    /// counted.
    ///
    /// # Panics
    /// Never: a cause has a member.
    #[must_use]
    pub fn new(
        id: String,
        (robot, part): (String, BodyOrArm),
        hazards: &[&Hazard],
        around: &Circumstances,
        all: Option<&BigUint>,
    ) -> Self {
        let worst = hazards[0];
        let mut lines: Vec<Line> = Vec::new();
        for hazard in hazards {
            let held = hazard.arm.as_ref().is_some_and(|arm| arm.held_m.is_some());
            let same = |line: &&mut Line| {
                (line.body_region, line.held) == (hazard.body_region, held) && line.robot_link == hazard.robot_link
            };
            match lines.iter_mut().find(same) {
                Some(line) => line.hazards.push(hazard.id.clone()),
                None => lines.push(Line {
                    body_region: hazard.body_region,
                    held,
                    robot_link: hazard.robot_link.clone(),
                    ratio: hazard.ratio,
                    hazards: vec![hazard.id.clone()],
                }),
            }
        }
        let counted: Option<BigUint> =
            hazards.iter().map(|hazard| hazard.sequences.as_ref()?.parse::<BigUint>().ok()).sum();
        let share = counted.as_ref().zip(all).and_then(|(part, all)| Some(part.to_f64()? / all.to_f64()?));
        Self {
            id,
            sentence: sentence(worst, around) + &also_hit(hazards),
            robot,
            part,
            sensors: worst.sensors.clone(),
            worst: worst.id.clone(),
            class: worst.class,
            judged: worst.judged.clone(),
            force_n: worst.deciding_force_n(),
            limit_n: worst.deciding_limit_n(),
            ratio: worst.ratio,
            speed_m_s: (worst.class == Class::MovingContact).then_some(worst.speed_m_s),
            earliest_time_s: hazards.iter().map(|hazard| hazard.earliest_time_s).fold(f64::INFINITY, f64::min),
            sequences: counted.as_ref().map(ToString::to_string),
            share,
            confirmed: hazards.iter().filter(|hazard| hazard.confirmed == Some(true)).count(),
            hazards: hazards.iter().map(|hazard| hazard.id.clone()).collect(),
            lines,
            advice: None,
        }
    }

    /// Force and limit of the worst hazard.
    #[must_use]
    pub fn measured(&self) -> Measure {
        let figures = (self.force_n, self.limit_n, self.ratio, self.speed_m_s.unwrap_or_default());
        Measure::of(self.class, self.judged.as_ref(), figures)
    }

    /// The same in words.
    #[must_use]
    pub fn force_words(&self) -> String {
        self.measured().words()
    }

    /// From when on it is met.
    #[must_use]
    pub fn earliest_words(&self) -> String {
        format!("from {:.2} s on", self.earliest_time_s)
    }

    /// How many ways lead to it.
    #[must_use]
    pub fn ways_words(&self) -> String {
        plural(self.hazards.len(), "way")
    }

    /// How many of all sequences it is, where they were counted.
    #[must_use]
    pub fn share_words(&self) -> Option<String> {
        self.share.map(|share| format!("{} of all sequences", percent(share)))
    }
}

/// A cause with its hazards, of a scan of any version.
#[derive(Clone, Debug)]
pub struct Grouped<'a> {
    /// Its id.
    pub id: &'a str,
    /// What hits what, in few words.
    pub what: String,
    /// What is wrong.
    pub sentence: String,
    /// Its hazards, worst first.
    pub hazards: Vec<&'a Hazard>,
}

impl Grouped<'_> {
    /// As a title: the id, and what hits what.
    #[must_use]
    pub fn title(&self) -> String {
        format!("{} {}", self.id, self.what)
    }
}

/// The hazards of a scan by cause. Those of older versions, which knew no causes, are one each.
#[must_use]
pub fn grouped<'a>(causes: &'a [Cause], hazards: &'a [Hazard]) -> Vec<Grouped<'a>> {
    let by_id: BTreeMap<&str, &Hazard> = hazards.iter().map(|hazard| (hazard.id.as_str(), hazard)).collect();
    let mut all: Vec<Grouped<'_>> = causes
        .iter()
        .map(|cause| Grouped {
            id: &cause.id,
            what: format!("{} hit by {}", cause.part.words(), cause.robot),
            sentence: cause.sentence.clone(),
            hazards: cause.hazards.iter().filter_map(|id| by_id.get(id.as_str()).copied()).collect(),
        })
        .filter(|cause| !cause.hazards.is_empty())
        .collect();
    let known: BTreeSet<&str> = causes.iter().flat_map(|cause| &cause.hazards).map(String::as_str).collect();
    let alone = hazards.iter().filter(|hazard| !known.contains(hazard.id.as_str()));
    all.extend(alone.map(|hazard| Grouped {
        id: &hazard.id,
        what: format!("{} <- {}", hazard.body_region, hazard.robot_link),
        sentence: hazard.sentence(),
        hazards: vec![hazard],
    }));
    all
}

/// What happens in the worst hazard of a cause, which controls are worked on the way, and what the safeguards did about it.
fn sentence(hazard: &Hazard, around: &Circumstances) -> String {
    let what = what_happens(hazard, around);
    match worked_words(&hazard.worked) {
        words if words.is_empty() => what,
        words => format!("{}. {what}", capitalised(&words)),
    }
}

/// Where others are hit than in the worst hazard: that they are.
fn also_hit(hazards: &[&Hazard]) -> String {
    let other =
        hazards.iter().filter(|hazard| hazard.person != hazards[0].person).find_map(|hazard| hazard.person.as_ref());
    other.map_or_else(String::new, |name| format!(" {} is hit too.", capitalised(name)))
}

/// With a capital letter.
#[must_use]
pub fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    letters.next().map_or_else(String::new, |first| first.to_uppercase().chain(letters).collect())
}

fn what_happens(hazard: &Hazard, around: &Circumstances) -> String {
    let region = match &hazard.person {
        Some(name) => format!("{} of {name}", hazard.struck_words()),
        None => hazard.struck_words().to_owned(),
    };
    // A sensor does not tell who it is.
    let person = if hazard.person.is_some() { "somebody" } else { "the person" };
    let speed = hazard.speed_m_s;
    let (does, held) = does(hazard);
    // Of several robots the link's name says which.
    let link = match hazard.robot_link.split_once('/') {
        Some((robot, link)) => format!("{robot}'s {link}"),
        None => hazard.robot_link.clone(),
    };
    let load = match around.payload_kg {
        Some(kg) if kg > 0.0 => format!(", with a load of {kg:.1} kg,"),
        _ => String::new(),
    };
    let reach = match (&around.over, &around.under) {
        (Some(over), Some(under)) => format!(" that reaches in between {over} and {under}"),
        (Some(over), None) => format!(" that reaches over {over}"),
        (None, Some(under)) => format!(" that reaches under {under}"),
        (None, None) => String::new(),
    };
    let reporting: Vec<&SensorState> = hazard.sensors.iter().filter(|sensor| sensor.person_detected).collect();
    if !reporting.is_empty() {
        let longest = reporting.iter().filter_map(|sensor| sensor.since_s).fold(0.0, f64::max);
        let names: Vec<&str> = reporting.iter().map(|sensor| sensor.name.as_str()).collect();
        let has = if names.len() == 1 { "has" } else { "have" };
        let for_so_long = match longest {
            s if s > LONG_S => format!(" for {s:.2} s"),
            s if s > 0.0 => format!(" for only {s:.2} s"),
            _ => String::new(),
        };
        let robot = if around.slowed {
            format!("{link}{load} is slower but not at rest: at {speed:.2} m/s it {does}")
        } else {
            format!("{link}{load} goes on at {speed:.2} m/s and {does}")
        };
        return format!(
            "{} {has} reported {person}{for_so_long}, but {robot} the {region}{reach}{held}.",
            joined(&names)
        );
    }
    let hit = format!("{link}{load} moves at {speed:.2} m/s and {does} the {region}{reach}{held}");
    if let Some(curtain) = &around.got_below {
        return format!("The person gets below {curtain}, and no sensor reports them: {hit}.");
    }
    match (hazard.sensors.len(), around.outside.iter().min_by(|a, b| a.1.total_cmp(&b.1))) {
        (0, _) => format!("No sensor watches over this: {hit}."),
        (_, Some((name, metres))) => {
            let person = hazard.person.as_deref().unwrap_or("the person");
            format!("No sensor reports {person}, who stands {metres:.2} m outside of {name}: {hit}.")
        }
        (1, None) => format!("{} does not report {person}: {hit}.", hazard.sensors[0].name),
        (_, None) => format!("No sensor reports {person}: {hit}."),
    }
}

/// What the robot does to the part of the body, and by what that is unsafe where it is not the force of the stroke.
fn does(hazard: &Hazard) -> (&'static str, String) {
    match (hazard.class, hazard.clamping()) {
        (Class::Clamping, Some(clamping)) => {
            let after = hazard.first_contact.as_ref().map_or_else(String::new, |first| format!(", {}", first.words()));
            let (against, gap_mm) = (&clamping.against, 1000.0 * clamping.gap_m);
            ("clamps", format!(" against {against}, with {gap_mm:.0} mm of room{after}"))
        }
        (Class::Pressure, _) => ("presses", " with too small a surface".to_owned()),
        (Class::MovingContact, _) => ("touches", String::new()),
        (Class::Separation, _) => ("comes too near", String::new()),
        (Class::Force | Class::HeadContact | Class::Clamping, _) => ("hits", String::new()),
    }
}

/// "a", "a and b", "a, b and c".
fn joined(names: &[&str]) -> String {
    match names {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

impl Change {
    /// The change, and what is left then.
    #[must_use]
    pub fn words(&self) -> String {
        format!("{} ({})", self.change, self.left_words())
    }

    /// What is left with it.
    fn left_words(&self) -> String {
        if let Some(until_s) = self.enough_until_s {
            return format!(
                "nothing is left: every sequence from the start, and everybody from anywhere until {until_s:.1} s"
            );
        }
        let left = match (self.removes_all, self.complete) {
            (true, true) => "nothing is left from the start, every sequence looked at; from elsewhere not shown",
            (true, false) => "nothing was met any more, not every sequence looked at",
            (false, true) => "this cause is gone, every sequence looked at; others are left",
            (false, false) => "this cause was not met any more; others are left",
        };
        left.to_owned()
    }

    /// The same as a sentence of its own.
    #[must_use]
    pub fn effect(&self) -> String {
        match self.enough_until_s {
            Some(_) => format!("{}.", capitalised(&self.left_words())),
            None => format!("{TRIED_IN_PART}: {}.", self.left_words()),
        }
    }

    /// What it was held against, as a sentence.
    #[must_use]
    pub fn checked_words(&self) -> String {
        let part = if self.complete { "" } else { " (not every sequence)" };
        format!("Checked: {}{part}.", self.checked.trim_end_matches('.'))
    }

    /// A change with which the cause was not met any more; nothing if it was.
    fn of(remedy: &RiskReduction) -> Option<Self> {
        let (checked, complete, removes_all) = match &remedy.outcome {
            RiskReductionOutcome::Sufficient(checked) => (checked, true, true),
            RiskReductionOutcome::NotMet(checked) => (checked, false, true),
            RiskReductionOutcome::OthersRemain(others) => (&others.checked, others.complete, false),
            _ => return None,
        };
        let change = remedy.change.clone();
        let enough_until_s = checked.enough_until_s().filter(|_| removes_all);
        Some(Self { change, checked: checked.words(), complete, enough_until_s, removes_all, less: checked.one_less() })
    }
}

impl CauseAdvice {
    /// From what came of the changes that were tried, of which some may be missing if the search `was_stopped`.
    #[must_use]
    pub fn of(remedies: &[RiskReduction], was_stopped: bool) -> Self {
        let mut changes: Vec<Change> = remedies.iter().filter_map(Change::of).collect();
        changes.sort_by_key(|change| (!change.removes_all, change.enough_until_s.is_none(), !change.complete));
        let tried =
            remedies.iter().filter(|remedy| !matches!(remedy.outcome, RiskReductionOutcome::NotTried { .. })).count();
        let tried = match tried {
            0 => "No change could be tried".to_owned(),
            1 => "1 change tried".to_owned(),
            n => format!("{n} changes tried"),
        };
        let stopped = if was_stopped { ", then stopped" } else { "" };
        let note = if remedies.iter().all(|remedy| matches!(remedy.outcome, RiskReductionOutcome::NotTried { .. })) {
            format!("{tried}{stopped}. fmi-hazard explain tells why.")
        } else if changes.is_empty() {
            format!("{tried}{stopped}: none of them alone keeps it from being met. fmi-hazard explain tells of each.")
        } else {
            format!("{tried}{stopped}. {NO_PROOF}")
        };
        Self { changes, note }
    }

    /// For people: one line a change.
    #[must_use]
    pub fn render(&self) -> String {
        self.changes.iter().map(|change| wrapped(&change.words(), "   ")).collect()
    }

    /// For a cause that is gone with a worse one.
    #[must_use]
    pub fn as_for_a_worse_one(changes: Vec<Change>) -> Self {
        Self { changes, note: format!("The same changes as for a worse cause. {NO_PROOF}") }
    }
}

/// Of changes that are not shown to be enough.
pub const TRIED_IN_PART: &str = "Tried in part";

/// What helps where nothing does.
pub const NO_CHANGE: &str = "no single change that was tried";

/// What advice is worth.
const NO_PROOF: &str = "Tried in the model only, from the starts and for the times said here: no proof for the real cell. \
                        Whether a change can be built, and what it does to the work, is for people to judge.";
