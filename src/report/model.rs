//! The result of a scan as it stands in `scan.json`: SI units in the names, no clock times, so that the same cell, seed
//! and version give the same bytes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::cause::Cause;
use super::criteria::CriteriaRecord;
use super::headline::Headline;
use super::immovable;
use super::judged::Judged;
use super::people::{BodyRecord, SecondRecord};
use super::share::CycleShare;
use super::speeds::SpeedRecord;
use super::worked::{ControlRecord, Working, worked_words};
use crate::hazard::{Class, Criterion, Finding, Group, finding};
use crate::host::selftest::SelfTest;
use crate::human::Ability;
use crate::human::action::Action;
use crate::human::arm::ArmModel;
use crate::obligations::Obligations;
pub use crate::obligations::Verdict;
use crate::search::residual::Figures;
use crate::sim::Coverage;
use crate::standards::BodyRegion;
use crate::standards::provenance::Table;

/// Version of the format of `scan.json`; grows when a reader of the old one would misread the new one.
pub(crate) const SCHEMA_VERSION: u32 = 3;

/// The edition of the standard behind the limits, as printed.
pub(crate) const STANDARD_EDITION: &str = "ISO/TS 15066:2016 Annex A (contents now in ISO 10218-2:2025)";

/// The JSON Schema of `scan.json` (draft 2020-12). Within one [`SCHEMA_VERSION`] properties may be added.
#[must_use]
pub(crate) fn json_schema() -> serde_json::Value {
    let settings = schemars::generate::SchemaSettings::draft2020_12().for_serialize();
    settings.into_generator().into_root_schema_for::<ScanReport>().to_value()
}

/// A whole scan.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ScanReport {
    /// [`SCHEMA_VERSION`].
    pub schema_version: u32,
    /// Name and version of this tool.
    pub tool: String,
    /// Overall outcome.
    pub verdict: Verdict,
    /// The verdict and what it is about, in words.
    #[serde(default)]
    pub headline: Headline,
    /// What was scanned.
    pub subject: Subject,
    /// How it was searched.
    pub settings: Settings,
    /// What is wrong with the cell: hazards that belong together, worst first.
    #[serde(default)]
    pub causes: Vec<Cause>,
    /// Hazards, worst first.
    pub hazards: Vec<Hazard>,
    /// What an exhaustive search covered.
    pub certificate: Option<Certificate>,
    /// What random sequences say about what is left; none if every sequence was looked at, if the strategy keeps no
    /// random sequences apart, or if the search ended early, because of what it met or by wish.
    pub residual: Option<Residual>,
    /// What was seen.
    pub coverage: Coverage,
    /// How much of the robots' cycle a search from the start met; none if the search was stopped before that was asked, or is one from
    /// anywhere. The run that this takes is not counted in `spent`.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub cycle: Option<CycleShare>,
    /// What it cost.
    pub spent: Spent,
    /// Speeds that the FMU tells and that are not those of the motion: with any of them nothing is certified.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub speeds: Vec<SpeedRecord>,
    /// Actions that the FMU could not finish, with the sequences that lead there.
    pub faults: Vec<FaultRecord>,
    /// The state self-test.
    pub self_test: SelfTest,
    /// Edition of the limits.
    pub standard_edition: &'static str,
    /// Tables of figures used, each with source, confidence and whether a person has verified it.
    pub tables: Vec<Table>,
    /// What the result rests on: everything that "nobody is hit" needs, shown, assumed or open.
    pub obligations: Obligations,
    /// Things the user should know.
    pub warnings: Vec<String>,
}

/// What was scanned.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct Subject {
    /// Name of the cell.
    pub cell: String,
    /// Where the cell was found, as `path`; inside an archive behind a `!`.
    pub cell_found: String,
    /// SHA-256 of the cell file.
    pub cell_sha256: String,
    /// Other files that say what was scanned: the system of FMUs, robot descriptions, meshes.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub files: Vec<FileSubject>,
    /// Path that was scanned: in a file, relative to its folder where that is possible.
    pub path: String,
    /// The cell file, if one was named beside the path; as `path`.
    pub cell_file: Option<String>,
    /// The FMUs, in the order in which they are stepped.
    pub fmus: Vec<FmuSubject>,
    /// What the connections between them do.
    pub couplings: Vec<String>,
    /// Which of the cell's beginnings it is, if there are several or it is not at once.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub beginning: Option<BeginningSubject>,
}

impl Subject {
    /// What acceptances in a cell file are bound to: the SHA-256 of its FMU, of several of them that of all of theirs.
    #[must_use]
    pub(crate) fn fmu_digest(&self) -> String {
        match &self.fmus[..] {
            [only] => only.sha256.clone(),
            all => {
                let lines = all.iter().map(|fmu| format!("{} {}\n", fmu.unit, fmu.sha256));
                crate::cell::sha256(lines.collect::<String>().as_bytes())
            }
        }
    }

    /// Name of the cell, and which of its beginnings it is if there are several.
    #[must_use]
    pub(crate) fn title(&self) -> String {
        match &self.beginning {
            Some(beginning) if beginning.of > 1 => {
                format!("{}, beginning {} of {}", self.cell, beginning.number, beginning.of)
            }
            _ => self.cell.clone(),
        }
    }
}

/// Where and when the person begins; times of hazards count from then.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BeginningSubject {
    /// Its number, from 1.
    pub number: usize,
    /// How many the cell has.
    pub of: usize,
    /// Where the person stands, m.
    pub xy_m: [f64; 2],
    /// Where the person looks, degrees from +x towards +y.
    pub heading_deg: f64,
    /// Time from the FMU's own start, s.
    pub begins_s: f64,
}

impl BeginningSubject {
    /// Whether it is the same start at the same time, whatever its number.
    #[must_use]
    pub(crate) fn same(&self, other: &Self) -> bool {
        self.begin().bits() == other.begin().bits()
    }

    /// The same without its number.
    #[must_use]
    pub(crate) const fn begin(&self) -> Begin {
        let Self { number: _, of: _, xy_m, heading_deg, begins_s } = *self;
        Begin { xy_m, heading_deg, begins_s }
    }

    /// For people.
    #[must_use]
    pub(crate) fn words(&self) -> String {
        self.begin().words()
    }
}

/// Where and when a person begins.
#[derive(Clone, Copy, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Begin {
    /// Floor plan, m.
    pub xy_m: [f64; 2],
    /// Heading from +x towards +y, degrees.
    pub heading_deg: f64,
    /// Time from the FMU's own start, s.
    pub begins_s: f64,
}

impl Begin {
    /// For comparisons: to the last bit.
    #[must_use]
    pub(crate) fn bits(&self) -> [u64; 4] {
        let Self { xy_m: [x, y], heading_deg, begins_s } = *self;
        [x, y, heading_deg, begins_s].map(f64::to_bits)
    }

    /// For people.
    #[must_use]
    pub(crate) fn words(&self) -> String {
        let [x, y] = self.xy_m;
        let heading = self.heading_deg;
        format!(
            "at ({x:.2}, {y:.2}) m, looking towards {heading:.0} degrees, {:.2} s after the FMU's start",
            self.begins_s
        )
    }
}

/// A file that says part of what the cell is.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct FileSubject {
    /// As the cell file names it; of a system of FMUs the file name.
    pub path: String,
    /// SHA-256 of the file.
    pub sha256: String,
}

/// An FMU that was scanned.
#[derive(Clone, Debug, Serialize, Deserialize, JsonSchema)]
pub struct FmuSubject {
    /// Name of the unit; empty for the only one.
    pub unit: String,
    /// SHA-256 of the FMU file.
    pub sha256: String,
    /// FMI version.
    pub fmi_version: String,
    /// Model name.
    pub model_name: String,
    /// Exporting tool.
    pub generation_tool: String,
}

/// How it was searched.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Settings {
    /// Strategy name.
    pub strategy: String,
    /// Seed.
    pub seed: u64,
    /// Budget in iterations.
    pub iterations: u32,
    /// Stop at the first hazard instead of using the budget.
    pub stop_at_first: bool,
    /// All postures checked per walk.
    pub posture_sweep: bool,
    /// Actions in a sequence.
    pub actions_per_sequence: u32,
    /// Duration of an action, s.
    pub action_s: f64,
    /// Communication step and contact-check interval, s.
    pub contact_check_interval_s: f64,
    /// Depth of contact that the arm check may miss, m.
    pub reach_tolerance_m: f64,
    /// Which speed makes the force that decides.
    pub speed_criterion: Criterion,
    /// What counts as unsafe, where that is more or other than the transient force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub criteria: Option<CriteriaRecord>,
    /// How fast hands move, m/s, if arms take their time.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub arm_speed_m_s: Option<f64>,
    /// How far what the person holds reaches beyond the finger tips, m, if they hold something.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_m: Option<f64>,
    /// What the person does besides walking, bending and reaching.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<Ability>,
    /// How fast who runs does so, m/s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub run_m_s: Option<f64>,
    /// A second person beside them.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub second: Option<SecondRecord>,
    /// Controls that the search works.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub controls: Vec<ControlRecord>,
    /// Of a scan from anywhere: how long after the FMU's own start it looked, s.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub until_s: Option<f64>,
    /// Of such a scan: how often controls were worked at most, if the cell has any that are.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub presses: Option<u32>,
    /// Of a scan from a start: where and when the person begins.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub begins: Option<Begin>,
    /// Of such a scan: the sensors that see somebody there already; of those inside the FMU it is not known before it runs.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub seen_at_start: Vec<String>,
    /// The person's body.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub body: Option<BodyRecord>,
    /// Of a scan from anywhere: corners of the floor that people may be on, floor plan, m, if that is bounded.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub floor_m: Option<Vec<[f64; 2]>>,
    /// Of such a scan: corners of the floor from which they come, floor plan, m, if that is not the outside.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub start_region_m: Option<Vec<[f64; 2]>>,
}

/// What the search cost.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Spent {
    /// Iterations run.
    pub iterations: u64,
    /// 200 ms actions simulated.
    pub actions: u64,
    /// FMI communication steps of all different transitions; what was repeated to come back to a state is in run.json.
    pub fmu_steps: u64,
    /// Different FMU states met.
    pub fmu_states: usize,
    /// Person-robot comparisons.
    pub contact_checks: u64,
    /// Arm searches.
    pub arm_checks: u64,
}

/// An action the FMU could not finish.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
pub struct FaultRecord {
    /// What happened.
    pub message: String,
    /// The sequence.
    pub actions: Vec<Action>,
}

/// A hazard: the worst sequence of its group.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hazard {
    /// Stable id.
    pub id: String,
    /// Whether a fresh instance without any restore gave the same contact; `None` before that was tried.
    pub confirmed: Option<bool>,
    /// Where and when its sequences begin, if that is not where the scan did. Its times count from then.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub begins: Option<Begin>,
    /// Why it is a finding.
    pub class: Class,
    /// How it was judged, where another criterion counts than the transient force.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub judged: Option<Judged>,
    /// Who is hit, where there are two people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub person: Option<String>,
    /// Body region touched.
    pub body_region: BodyRegion,
    /// Robot link that touches.
    pub robot_link: String,
    /// Potential collision force, N.
    pub force_n: f64,
    /// Limit, N.
    pub limit_n: f64,
    /// The force that decides, by the criterion of the settings, over `limit_n`.
    pub ratio: f64,
    /// Force with the speed of approach instead of the robot's own, N.
    pub directed_force_n: f64,
    /// `directed_force_n / limit_n`.
    #[serde(default)]
    pub directed_ratio: f64,
    /// Absolute speed of the robot point, m/s.
    pub speed_m_s: f64,
    /// Speed of approach, the person's walking included, m/s: of body and legs along the contact normal, of arms in any
    /// direction.
    pub approach_m_s: f64,
    /// Speed below which the force stays within the limit, m/s.
    pub safe_below_m_s: f64,
    /// Effective mass of the robot, kg.
    pub effective_mass_kg: f64,
    /// Mass of the robot at this point, in this pose, and in the direction of the contact (of body and legs along its normal, of
    /// arms along the velocity of the robot point), by the inertias of its links and its payload, kg: where the cell file or a
    /// URDF tells them. `null` where the robot cannot give way in that direction. Nothing is decided by it.
    #[serde(default, skip_serializing_if = "Option::is_none", with = "immovable")]
    #[schemars(with = "Option<f64>")]
    pub reflected_mass_kg: Option<f64>,
    /// Time of the contact, s.
    pub time_s: f64,
    /// Contact point on the robot, m.
    pub contact_point_m: [f64; 3],
    /// Contact point on the body, m.
    pub body_point_m: [f64; 3],
    /// Signed distance of the shapes at that instant, m.
    pub distance_m: f64,
    /// Where the person stands, m.
    pub person_xy_m: [f64; 2],
    /// Where the person looks, degrees from +x towards +y.
    pub person_heading_deg: f64,
    /// Part of the bend that obstacles left possible, 0 to 1.
    pub bend_fraction: f64,
    /// Shoulder, elbow and wrist of the touching arm, m.
    pub arm: Option<Arm>,
    /// Sensors at the contact.
    pub sensors: Vec<SensorState>,
    /// Programme phase.
    pub phase: Option<i64>,
    /// For an arm through a light curtain or a door, or from a two-hand control: how long before the contact it broke the
    /// plane or let go, s; the robot is where it is when that is reported then. Of several planes the first.
    pub through_curtain_s: Option<f64>,
    /// The sensor of that.
    pub through_curtain: Option<String>,
    /// All planes that told of the arm, and when.
    #[serde(default)]
    pub through: Vec<Through>,
    /// The sequence of actions; the contact happens in the last.
    pub actions: Vec<Action>,
    /// Controls that are worked in it.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub worked: Vec<Working>,
    /// The first hazard by contact of the sequence, where a clamping comes behind it.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub first_contact: Option<FirstContact>,
    /// Iteration in which the hazard was first met, from 1.
    pub first_iteration: u64,
    /// Sequences found that end in this hazard.
    pub times_found: u64,
    /// Earliest contact over these, s.
    pub earliest_time_s: f64,
    /// Sequences of full length that begin with this hazard, in decimal, where all were looked at.
    pub sequences: Option<String>,
    /// The shortest and calmest sequence.
    pub shortest: Shortest,
}

/// The first hazard by contact of a sequence in which somebody is clamped later.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FirstContact {
    /// Time of the contact, s.
    pub time_s: f64,
    /// Why it is a hazard.
    pub class: Class,
    /// Who is hit, where there are two people.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub person: Option<String>,
    /// Body region touched.
    pub body_region: BodyRegion,
    /// Robot link that touches.
    pub robot_link: String,
    /// What is broken worst, over its limit.
    pub ratio: f64,
}

impl FirstContact {
    /// That of a finding.
    #[must_use]
    pub(crate) fn of(first: &Finding, link_names: &[String], people: Option<&[String; 2]>) -> Self {
        Self {
            time_s: first.time_s,
            class: first.class,
            person: people.map(|names| names[first.who as usize].clone()),
            body_region: first.contact.region,
            robot_link: link_names[first.contact.link].clone(),
            ratio: first.contact.ratio(),
        }
    }

    /// "after the tool hit the chest at 0.62 s".
    #[must_use]
    pub(crate) fn words(&self) -> String {
        let [done, _] = self.class.done();
        let whose = self.person.as_ref().map_or_else(String::new, |person| format!(" of {person}"));
        let (region, time_s) = (self.body_region.words(), self.time_s);
        format!("after the {region}{whose} was {done} by {} at {time_s:.2} s", self.robot_link)
    }
}

/// A plane that told of an arm: a light curtain, a door, a two-hand control that it let go.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Through {
    /// Its sensor.
    pub sensor: String,
    /// How long before the contact the arm broke the plane or let go, s.
    pub since_s: f64,
    /// How long before the contact the sensor began to tell of the body itself, s: the robot then is as if the plane had told
    /// of the arm until that only. 0 if the plane tells of the arm until the contact.
    pub until_s: f64,
}

/// The shortest sequence found that ends in a hazard; of these the calmest. The very shortest there is when the search
/// was exhaustive.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Shortest {
    /// The actions.
    pub actions: Vec<Action>,
    /// Time of the contact, s.
    pub time_s: f64,
    /// Force, N.
    pub force_n: f64,
    /// `force / limit`.
    pub ratio: f64,
    /// Whether a fresh instance without any restore gave the same contact; `None` before that was tried.
    pub confirmed: Option<bool>,
}

/// What an exhaustive search covered, and what random search can expect from that. Numbers of sequences are decimal
/// strings: they do not fit into JSON's numbers.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Certificate {
    /// Whether every sequence is accounted for, and nothing is open that this needs.
    pub complete: bool,
    /// Why that is not so: the obligations that are open, in words.
    pub reasons: Vec<String>,
    /// All sequences: actions to the power of the horizon.
    pub sequences: String,
    /// Those whose fate is known: hazardous, harmless or excluded.
    pub covered: String,
    /// Met an unsafe state.
    pub hazardous: String,
    /// Reached the horizon without.
    pub harmless: String,
    /// Cannot meet one: too far away for the time that is left, by lengths and speeds.
    pub excluded: String,
    /// The FMU could not finish them.
    pub not_evaluated: String,
    /// Part of all sequences that is known to be hazardous.
    pub hazardous_share: f64,
    /// Distinct states.
    pub states: usize,
    /// Distinct states by number of actions before them, and how many of these were dropped as excluded.
    pub levels: Vec<[usize; 2]>,
    /// All sequences of so many actions were looked at.
    pub complete_for_actions: usize,
    /// Actions of the FMU that differ in its state or inputs.
    pub fmu_transitions: usize,
    /// Different questions whether a person can be touched.
    pub questions: u64,
    /// How equal states of the FMU were told.
    pub merged_by: String,
    /// Histories that led to a state of the FMU known already, by its bytes.
    pub merged: u64,
    /// Of these, tried out by stepping both states on.
    pub merges_tried_out: u64,
    /// What of the FMU was run again plainly, to show that nothing rests on a state that was brought back wrongly.
    pub run_again: RunAgain,
    /// Actions to choose from.
    pub actions: usize,
    /// Actions in a sequence.
    pub horizon: usize,
    /// What random search can expect, if the search was complete.
    pub random_search: Option<RandomSearch>,
}

impl Certificate {
    /// Once it is known what it rests on.
    pub(crate) fn close(&mut self, obligations: &Obligations) {
        self.reasons = obligations.reasons();
        self.complete = obligations.clean().is_some();
        if !self.complete {
            self.random_search = None;
        }
    }
}

/// How much of what an FMU did in a search was run again from the start, by a fresh instance with all inputs and without
/// any restore, and gave the same in all bound outputs, bit for bit. Where it is not all, it is a sample, chosen by a key
/// made from the inputs.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RunAgain {
    /// Actions of the FMU that were stepped.
    pub transitions: u64,
    /// Of these, run again.
    pub compared: u64,
    /// Histories that were merged with another one, which went on.
    pub merges: u64,
    /// Of these, run on from the start with the other one's inputs.
    pub merges_compared: u64,
}

/// Exact figures of uniform random search, from the share of hazardous sequences.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct RandomSearch {
    /// Budget, iterations.
    pub iterations: u32,
    /// Mean iterations to the first hazard, however many it takes: one over the share of hazardous sequences.
    pub iterations_to_hazard: Option<f64>,
    /// The same cut at the budget, a miss counting as the budget: what the paper's tables call T.
    pub mean_iterations: f64,
    /// Standard deviation of that.
    pub sigma: f64,
    /// Probability to find nothing.
    pub miss_probability: f64,
}

/// What the uniformly random sequences of a search say about what is left, each figure with 95 % confidence. Sequences
/// that a strategy chose are never counted. See [`crate::search::residual`].
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Residual {
    /// What the figures hold for.
    pub holds_for: String,
    /// Uniformly random sequences.
    pub random_sequences: u64,
    /// Of these, hazardous by their own end; findings in other postures of their walks do not count.
    pub hazardous: u64,
    /// Of these, not evaluated, because the FMU could not finish them; upper bounds count them as the worse.
    pub not_evaluated: u64,
    /// Clopper-Pearson interval, two-sided, of the share of all sequences that is hazardous: what an exhaustive search
    /// gives as `hazardous / sequences`.
    pub hazardous_share_interval: [f64; 2],
    /// Upper bound, one-sided, of the same share.
    pub hazardous_share_below: f64,
    /// About hazards that are not listed; none if no hazard is, as the share above is then the answer.
    pub unlisted: Option<Unlisted>,
}

/// How often a random sequence ends in a hazard that is not listed.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Unlisted {
    /// Random sequences after the first quarter of the search, each checked against the hazards known by then.
    pub checked: u64,
    /// Of these, ended in a hazard not known then, or not evaluated.
    pub met_others: u64,
    /// Upper bound, one-sided, of the probability that one more random sequence ends in a hazard that is not listed.
    pub probability_below: f64,
    /// Good-Turing estimate, no bound, from the random sequences alone: the probability that one more ends in a hazard
    /// that none of them ended in.
    pub good_turing_estimate: f64,
}

impl Residual {
    /// What figures are about.
    pub(crate) const HOLDS_FOR: &'static str = "uniformly random sequences of these actions, horizon and start in this model; \
                                         not how likely a person is hurt";

    /// The record of figures; `listed`: whether any hazard was found.
    #[must_use]
    pub(crate) fn new(f: &Figures, listed: bool) -> Self {
        let unlisted = Unlisted {
            checked: f.checked,
            met_others: f.unlisted,
            probability_below: f.unlisted_below,
            good_turing_estimate: f.good_turing,
        };
        Self {
            holds_for: Self::HOLDS_FOR.to_owned(),
            random_sequences: f.sequences,
            hazardous: f.hazardous,
            not_evaluated: f.not_evaluated,
            hazardous_share_interval: [f.share.low, f.share.high],
            hazardous_share_below: f.share_below,
            unlisted: listed.then_some(unlisted),
        }
    }
}

/// The touching arm.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Arm {
    /// `left` or `right`.
    pub side: String,
    /// Shoulder joint, m.
    pub shoulder_m: [f64; 3],
    /// Elbow, m.
    pub elbow_m: [f64; 3],
    /// Wrist, m.
    pub wrist_m: [f64; 3],
    /// Where what the hand holds is hit: how far beyond the finger tips, m.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_m: Option<f64>,
}

/// A sensor's output.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SensorState {
    /// Sensor name.
    pub name: String,
    /// Whether it reports the person.
    pub person_detected: bool,
    /// For how long before the contact it had reported the person without a break, s; none if it does not report them, or
    /// the hazard was not confirmed.
    #[serde(default)]
    pub since_s: Option<f64>,
}

/// What is hit where it is not the hand itself.
pub(crate) const HELD_WORDS: &str = "thing in the hand";

impl Hazard {
    /// The record of a group; names by index.
    #[must_use]
    pub(crate) fn new(
        group: &Group,
        link_names: &[String],
        sensor_names: &[String],
        people: Option<&[String; 2]>,
    ) -> Self {
        let f = &group.worst;
        let c = &f.contact;
        let arm = f.arm.map(|a| Arm {
            side: if a.left { "left" } else { "right" }.to_owned(),
            shoulder_m: a.shoulder.to_array(),
            elbow_m: a.elbow.to_array(),
            wrist_m: a.wrist.to_array(),
            held_m: (c.region == BodyRegion::Hand).then(|| ArmModel::beyond_fingers_m(a.wrist, c.on_robot)).flatten(),
        });
        let sensor =
            |(name, &on): (&String, &bool)| SensorState { name: name.clone(), person_detected: on, since_s: None };
        Self {
            id: group.id.clone(),
            confirmed: None,
            begins: None,
            class: f.class,
            judged: Judged::of(c, f.class, link_names),
            person: people.map(|names| names[f.who as usize].clone()),
            body_region: c.region,
            robot_link: link_names[c.link].clone(),
            force_n: c.force_n,
            limit_n: c.limit_n,
            ratio: c.ratio(),
            directed_force_n: c.directed_force_n,
            directed_ratio: c.directed_force_n / c.limit_n,
            speed_m_s: c.speed_m_s,
            approach_m_s: c.approach_m_s,
            safe_below_m_s: c.safe_speed_m_s(),
            effective_mass_kg: c.effective_mass_kg,
            reflected_mass_kg: c.reflected_mass_kg,
            time_s: f.time_s,
            contact_point_m: c.on_robot.to_array(),
            body_point_m: c.on_body.to_array(),
            distance_m: c.distance_m,
            person_xy_m: [f.person.x, f.person.y],
            person_heading_deg: f.heading_rad.to_degrees(),
            bend_fraction: f64::from(f.bend_sixteenths) / 16.0,
            arm,
            sensors: sensor_names.iter().zip(&f.sensors).map(sensor).collect(),
            phase: f.phase,
            through_curtain_s: f.through.first().map(|through| through.since_s),
            through_curtain: f.through.first().map(|through| sensor_names[through.sensor].clone()),
            through: f
                .through
                .iter()
                .map(|&finding::Through { sensor, since_s, until_s }| Through {
                    sensor: sensor_names[sensor].clone(),
                    since_s,
                    until_s,
                })
                .collect(),
            actions: f.actions.clone(),
            worked: Vec::new(),
            first_contact: None,
            first_iteration: group.first_iteration,
            times_found: group.times_found,
            earliest_time_s: group.earliest_s,
            sequences: group.sequences.as_ref().map(ToString::to_string),
            shortest: Shortest {
                actions: group.shortest.actions.clone(),
                time_s: group.shortest.time_s,
                force_n: group.shortest.contact.deciding_force_n(),
                ratio: group.shortest.contact.ratio(),
                confirmed: None,
            },
        }
    }

    /// The force that decides, N: the one that `ratio` is of, where that is a force.
    #[must_use]
    pub(crate) fn deciding_force_n(&self) -> f64 {
        if let Some(clamping) = self.clamping() {
            return clamping.force_n;
        }
        if !matches!(self.class, Class::Force | Class::HeadContact) {
            return self.force_n;
        }
        let off = |force: f64| (force / self.limit_n - self.ratio).abs();
        if off(self.directed_force_n) < off(self.force_n) { self.directed_force_n } else { self.force_n }
    }

    /// Whether that is the force with the speed of approach.
    #[must_use]
    pub(crate) fn is_by_approach(&self) -> bool {
        self.deciding_force_n().to_bits() != self.force_n.to_bits()
    }

    /// What happens, in words.
    #[must_use]
    pub fn described(&self) -> String {
        let reports = self.reports_words();
        let stands = match &self.person {
            Some(name) => format!("{name} stands"),
            None => "the person stands".to_owned(),
        };
        let state = |s: &SensorState| s.words(reports);
        let sensors: Vec<String> = self.sensors.iter().map(state).collect();
        let sensors = if sensors.is_empty() { String::new() } else { format!("; {}", sensors.join(", ")) };
        let begins = self.begins.map_or_else(String::new, |begins| format!("; begun {}", begins.words()));
        let worked = match worked_words(&self.worked) {
            words if words.is_empty() => words,
            words => format!("; {words}"),
        };
        let meets = if self.class == Class::Separation { "comes too near" } else { "meets" };
        format!(
            "at {:.2} s the robot's {} {meets} the {} at {:.2} m/s at ({:.2}, {:.2}, {:.2}) m; {stands} at ({:.2}, \
             {:.2}){sensors}{worked}{begins}",
            self.time_s,
            self.robot_link,
            self.struck_words(),
            self.speed_m_s,
            self.contact_point_m[0],
            self.contact_point_m[1],
            self.contact_point_m[2],
            self.person_xy_m[0],
            self.person_xy_m[1],
        )
    }

    /// What is hit: a region of the body, or what the hand holds.
    #[must_use]
    pub(crate) fn struck_words(&self) -> &'static str {
        if self.arm.as_ref().is_some_and(|arm| arm.held_m.is_some()) { HELD_WORDS } else { self.body_region.words() }
    }

    /// The same with what it means.
    #[must_use]
    pub(crate) fn sentence(&self) -> String {
        let described = self.described();
        match self.class {
            Class::Force => format!(
                "{:.0} N on the {} (limit {:.0} N, {:.2}x): {described}",
                self.deciding_force_n(),
                self.struck_words(),
                self.limit_n,
                self.ratio
            ),
            Class::HeadContact => format!(
                "{:.0} N on the {}, where no contact with a moving robot is allowed: {described}",
                self.deciding_force_n(),
                self.struck_words()
            ),
            Class::Clamping => {
                let against = self.clamping().map_or_else(String::new, |c| {
                    format!(", held against {} {:.0} mm away", c.against, 1000.0 * c.gap_m)
                });
                let after =
                    self.first_contact.as_ref().map_or_else(String::new, |first| format!(", {}", first.words()));
                format!("{} on the {}{against}{after}: {described}", self.measure_words(), self.struck_words())
            }
            Class::Pressure => format!("{} on the {}: {described}", self.measure_words(), self.struck_words()),
            Class::MovingContact => {
                format!("the {} is {}: {described}", self.struck_words(), self.measure_words())
            }
            Class::Separation => format!(
                "the {} is {}, and the robot's {} moves: {}",
                self.struck_words(),
                self.measure_words(),
                self.robot_link,
                self.described()
            ),
        }
    }
}
