//! What is known of people who come from where no sensor sees them, on any walk and at any moment: `anywhere.json`, and
//! words for it.

use schemars::JsonSchema;
use serde::Serialize;

use super::hazard::SensorState;
use super::headline::{counted, not_shown};
use super::model::{Headline, ScanReport, Subject, Verdict};
use crate::human::Action;
use crate::obligations::Obligations;
use crate::standards::BodyRegion;
use fmi_hazard_criteria::{Class, Criterion};

/// Name of this way to search, where that of a strategy stands.
pub const REACHABILITY: &str = "anywhere";

/// What came out.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct ReachabilityResult {
    /// Version of this form, that of scan results.
    pub schema_version: u32,
    /// Program and version.
    pub tool: String,
    /// Result in one word. `none_found` is said only where no obligation is open.
    pub verdict: Verdict,
    /// What was looked at.
    pub subject: Subject,
    /// How long after the start of the FMU, s.
    pub until_s: f64,
    /// Whether what is said to be clean is so for all time, as behaviours stand for all that the FMU ever does.
    #[serde(skip_serializing_if = "std::ops::Not::not")]
    pub any_time: bool,
    /// How often the robots repeat what they do while nobody comes, s, if they did so twice until then.
    pub cycle_s: Option<f64>,
    /// Which speed decides. With that of approach, this is about people who stand: who walks comes to the robot faster.
    pub speed_criterion: Criterion,
    /// Edge of the cells of the floor, m.
    pub cell_m: f64,
    /// Contacts of trunk, head and legs that are harmless when the person stands no more than this elsewhere may be missed, m.
    pub body_tolerance_m: f64,
    /// The same of contacts of arms, and those with less room for the arm, m.
    pub arm_tolerance_m: f64,
    /// Contacts between two communication steps that are harmless with links that are smaller by this may be missed, m.
    pub step_tolerance_m: f64,
    /// How often controls were worked at most, all together, if the cell has any that are.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub presses: Option<u32>,
    /// How often what sensors report changed at most, if that was limited: coming in is one change, going out another.
    pub changes: Option<usize>,
    /// What the robots did while sensors reported what they report of somebody unseen.
    pub histories: Vec<HistoryRecord>,
    /// Of each body region and robot link the worst that was tried, the worst first.
    pub hazards: Vec<HarmfulPose>,
    /// Length of the spans of time of `floor`, s: the first begins with the FMU.
    pub span_s: f64,
    /// Cells of the floor in which somebody who stands there is hit, row by row.
    pub floor: Vec<Cell>,
    /// Whether poses that are hit at some moment were looked at in each span of time.
    pub followed: bool,
    /// The floor, and what the robots sweep.
    pub ground: Ground,
    /// Cells of the floor and postures of which it is not known whether anybody is hit in them.
    pub open: usize,
    /// Where something is open: the middles of those cells, each once, floor plan, m.
    pub open_m: Vec<[f64; 2]>,
    /// Cells of the floor that were not looked at to the end, where the search ended early: nobody was found to be hit there, and not
    /// everything that sensors may report was followed.
    pub not_looked_at: usize,
    /// Where those are, and what is farther out, as rectangles by low x and y and high x and y, floor plan, m.
    pub not_looked_at_m: Vec<[f64; 4]>,
    /// Cells of the floor and postures in which nobody is hit at any communication step, and somebody may be between two: robots are
    /// taken to be as much nearer then as they may move in half a step.
    pub between: usize,
    /// Where those are: the middles, each once, floor plan, m.
    pub between_m: Vec<[f64; 2]>,
    /// What the result rests on: everything that "nobody is hit" needs, shown, assumed or open.
    pub obligations: Obligations,
    /// Why the absence of further hazards is not shown: the obligations that are open, in words.
    pub reasons: Vec<String>,
    /// What the user should know.
    pub warnings: Vec<String>,
    /// What it took.
    pub spent: Spent,
}

/// One history of the FMU.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "WatchedHistory")]
pub struct HistoryRecord {
    /// What the sensors report since somebody came to where they do.
    pub sensors: Vec<SensorState>,
    /// Whether that is from the start on: nobody was seen before.
    pub unseen: bool,
    /// Different instants at which a robot could harm somebody.
    pub instants: usize,
}

/// Somewhere to be hit.
#[derive(Clone, Debug, Serialize, JsonSchema)]
pub struct HarmfulPose {
    /// Whether a run of its own shows it, with a fresh FMU and somebody who stands there or walks in, and who begins where people get to
    /// unseen by the rules of a scan from the start. Where gaps leave less than 13 mm besides the person, that is not shown.
    pub confirmed: bool,
    /// Its id there.
    pub id: String,
    /// Body region.
    pub body_region: BodyRegion,
    /// Robot link.
    pub robot_link: String,
    /// Why it is hazardous.
    pub class: Option<Class>,
    /// Force over limit.
    pub ratio: f64,
    /// Force, N.
    pub force_n: f64,
    /// Limit, N.
    pub limit_n: f64,
    /// Speed of the robot's point, m/s.
    pub speed_m_s: f64,
    /// When, after the start of the FMU, s; where a run shows it.
    pub time_s: Option<f64>,
    /// Where the person stands, floor plan, m.
    pub xy_m: [f64; 2],
    /// Where the person looks, from +x towards +y, degrees.
    pub heading_deg: f64,
    /// How the person bends.
    pub posture: &'static str,
    /// Whether the person walks there; else stands there all the time.
    pub walks_in: bool,
    /// Where the person begins, floor plan, m.
    pub start_m: [f64; 2],
    /// Where they look there, degrees.
    pub start_heading_deg: f64,
    /// When a scan has to begin that shows it, after the start of the FMU, s.
    pub begins_s: f64,
    /// What the person does from there.
    pub actions: Vec<Action>,
    /// What the sensors report.
    pub sensors: Vec<SensorState>,
    /// In how many cells of the floor, one for each posture, this was met.
    pub cells: usize,
    /// In how many histories of what the sensors report.
    pub histories: usize,
}

impl HarmfulPose {
    /// It was met in other histories as well.
    pub const fn met_again(&mut self, other: &Self) {
        self.cells += other.cells;
        self.histories += other.histories;
    }

    /// What hits what, and how hard.
    #[must_use]
    pub fn how_hard(&self) -> String {
        let Self { body_region, robot_link, force_n, limit_n, ratio, .. } = self;
        if self.class == Some(Class::HeadContact) {
            // A ratio below 1 would read as harmless.
            format!("{body_region} touched by {robot_link}: {force_n:.0} N; a moving robot may not touch it at all")
        } else {
            format!("{ratio:.2}x  {body_region} hit by {robot_link}: {force_n:.0} N, limit {limit_n:.0} N")
        }
    }
}

/// A cell of the floor.
#[derive(Clone, Debug, Serialize, JsonSchema)]
#[schemars(rename = "FloorCell")]
pub struct Cell {
    /// Its middle, floor plan, m.
    pub xy_m: [f64; 2],
    /// Force over limit of the worst that was tried.
    pub ratio: f64,
    /// Whether somebody is hit there whom no sensor has seen; else only who was seen on the way, as soon as they may be there by
    /// bounds on their way.
    pub unseen: bool,
    /// When the earliest of those is hit, after the start of the FMU, s.
    pub earliest_s: f64,
    /// Number of a span of time, and force over limit of the worst that was tried there and then. Of spans that are not listed
    /// nothing was found in the poses that were tried; others may be hit then.
    pub spans: Vec<(usize, f64)>,
}

/// The floor as rectangles, each by its low x and y and its high x and y, m.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
pub struct Ground {
    /// Where people can be who came there unseen, as far as sensors leave that open.
    pub unseen_m: Vec<[f64; 4]>,
    /// Where else people can be: sensors see them there, or on the way there.
    pub watched_m: Vec<[f64; 4]>,
    /// What the robots sweep, seen from above, while nobody is seen.
    pub swept_m: Vec<[f64; 4]>,
}

impl Ground {
    /// Whether nothing is known of it.
    #[must_use]
    pub const fn is_empty(&self) -> bool {
        self.unseen_m.is_empty() && self.watched_m.is_empty()
    }
}

/// What it took.
#[derive(Clone, Debug, Default, Serialize, JsonSchema)]
#[schemars(rename = "AnywhereSpent")]
pub struct Spent {
    /// Communication steps of the FMU.
    pub fmu_steps: u64,
    /// Sets of poses that were looked at.
    pub boxes: u64,
    /// Arm searches.
    pub arm_checks: u64,
    /// Boxes of joint angles that they looked at.
    pub arm_boxes: u64,
    /// Steps of the FMU that were run again from the start and compared.
    pub run_again: u64,
}

/// How often what sensors report changes, in words.
pub fn changes_words(changes: usize) -> String {
    match changes {
        1 => "What the sensors report changes at most once then.".to_owned(),
        more => format!("What the sensors report changes at most {more} times then."),
    }
}

/// How often controls are worked, in words.
pub fn presses_words(presses: u32) -> String {
    match presses {
        0 => "No control is worked then.".to_owned(),
        1 => "Controls are worked at most once, at any moment.".to_owned(),
        more => format!("Controls are worked at most {more} times, at any moment."),
    }
}

impl ReachabilityResult {
    /// How long that is, measured by what the robots repeat.
    fn cycles(&self) -> String {
        match self.cycle_s {
            Some(cycle_s) => format!(
                "While nobody comes the robots repeat what they do every {cycle_s:.2} s: that is {:.1} times.",
                self.until_s / cycle_s
            ),
            None => "While nobody comes the robots do not do the same twice in that time: where they have a cycle, most of what \
                     they do later was not looked at. --until 2cycles asks for two of them."
                .to_owned(),
        }
    }

    /// What was found, and of what that is said. `report` is the record of the same scan.
    #[must_use]
    pub fn headline(&self, report: &ScanReport) -> Headline {
        let until = format!("{:.1} s", self.until_s);
        let presses = self.presses.map_or_else(String::new, |presses| format!(" {}", presses_words(presses)));
        let says = match self.verdict {
            Verdict::HazardsFound => format!(
                "Somebody who comes from where no sensor sees them can be hit harder than allowed, within {:.1} s of the start. \
                 {}",
                self.until_hit_s(),
                counted(report)
            ),
            Verdict::NoneFound(_) if self.any_time => "Nobody is hit harder than allowed, at any time, who comes from where no sensor sees them, wherever they walk or \
                 stand, and however they bend and reach."
                .to_owned(),
            Verdict::NoneFound(_) => format!(
                "Nobody is hit harder than allowed within {until} of the start who comes from where no sensor sees them, wherever \
                 and whenever they walk or stand, and however they bend and reach."
            ),
            Verdict::Interrupted => "It was stopped: nothing is known of what was not looked at.".to_owned(),
            Verdict::Inconclusive | Verdict::FmuFailed => {
                not_shown(if self.hazards.is_empty() { "found" } else { "confirmed" }, &self.obligations)
            }
        };
        let people = "people who come from anywhere that no sensor sees";
        let complete = if self.obligations.clean().is_some() { "" } else { "Not complete. " };
        let moments = if self.any_time {
            "at any moment.".to_owned()
        } else {
            format!("at any moment within {until} of the start.{presses} {}", self.cycles())
        };
        let covers =
            format!("{complete}About {people}, {moments} A statement about the model, not about the real cell.");
        Headline { says, covers }
    }

    /// Until when somebody is hit for sure, s after the start: those who come again and again may be later than what was looked at.
    #[must_use]
    pub fn until_hit_s(&self) -> f64 {
        let hits = self.hazards.iter().filter(|hazard| hazard.confirmed).filter_map(|hazard| hazard.time_s);
        self.until_s.max(hits.min_by(f64::total_cmp).unwrap_or(self.until_s))
    }
}
