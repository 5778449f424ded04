//! The result of a scan as it stands in `scan.json`: SI units in the names, no clock times, so that the same cell, seed
//! and version give the same bytes.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::begin::InitialConditionRecord;
use super::cause::Cause;
use super::certificate::{Certificate, Residual};
use super::criteria::CriteriaRecord;
use super::hazard::Hazard;
use super::operated::ControlRecord;
use super::people::{BodyRecord, SecondRecord};
use super::share::CycleShare;
use super::speeds::SpeedRecord;
use crate::coverage::Coverage;
use crate::human::Ability;
use crate::human::action::Action;
use crate::obligations::Obligations;
pub use crate::obligations::Verdict;
use crate::standards::provenance::Table;
use fmi_hazard_criteria::Criterion;
use fmu_self_test::SelfTest;

/// Version of the format of `scan.json`; grows when a reader of the old one would misread the new one.
pub const SCHEMA_VERSION: u32 = 3;

/// The edition of the standard behind the limits, as printed.
pub const STANDARD_EDITION: &str = "ISO/TS 15066:2016 Annex A (contents now in ISO 10218-2:2025)";

/// The JSON Schema of `scan.json` (draft 2020-12). Within one [`SCHEMA_VERSION`] properties may be added.
#[must_use]
pub fn json_schema() -> serde_json::Value {
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

/// The head of a result.
#[derive(Clone, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct Headline {
    /// What was found, or why nothing is said.
    pub says: String,
    /// What was asked, and what of it was looked at.
    pub covers: String,
}

impl Headline {
    /// Of a result that has none.
    #[must_use]
    pub fn of_an_earlier_version() -> Self {
        let says = "This result was written by an earlier version, which did not say what it rests on. Scan again.";
        Self { says: says.to_owned(), covers: String::new() }
    }
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
    pub beginning: Option<NumberedInitialCondition>,
}

impl Subject {
    /// Name of the cell, and which of its beginnings it is if there are several.
    #[must_use]
    pub fn title(&self) -> String {
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
pub struct NumberedInitialCondition {
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

impl NumberedInitialCondition {
    /// Whether it is the same start at the same time, whatever its number.
    #[must_use]
    pub fn same(&self, other: &Self) -> bool {
        self.begin().bits() == other.begin().bits()
    }

    /// The same without its number.
    #[must_use]
    pub const fn begin(&self) -> InitialConditionRecord {
        let Self { number: _, of: _, xy_m, heading_deg, begins_s } = *self;
        InitialConditionRecord { xy_m, heading_deg, begins_s }
    }

    /// For people.
    #[must_use]
    pub fn words(&self) -> String {
        self.begin().words()
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
    pub begins: Option<InitialConditionRecord>,
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
