//! What came out of a campaign: a row for each scan, a row for each cell, and from which value of a sweep on nobody is hit.

use std::collections::{BTreeMap, BTreeSet};

use serde::{Deserialize, Serialize};

use super::columns;
use fmi_hazard_record::begin::InitialConditionRecord;
use fmi_hazard_record::hazard::Hazard;

/// Version of the format of `campaign.json`.
const SCHEMA: u32 = 1;

/// A campaign's result.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Survey {
    /// Version of the format.
    pub schema_version: u32,
    /// Name and version of this tool.
    pub tool: String,
    /// Name of the campaign.
    pub campaign: String,
    /// What is swept, with units.
    pub sweeps: Vec<(String, String)>,
    /// What all of it cost, the same on every machine.
    pub cost: Cost,
    /// A row for each cell.
    pub cells: Vec<CellRow>,
    /// From which values on nobody is hit.
    pub margins: Vec<Margin>,
    /// A row for each scan.
    pub scans: Vec<Row>,
}

/// One scan.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Row {
    /// Its number, from 1.
    pub number: usize,
    /// Its cell.
    pub cell: String,
    /// The one of the campaign file that this comes from.
    pub of: String,
    /// Values of the sweeps.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub at: BTreeMap<String, f64>,
    /// The body, if the campaign has several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body: Option<String>,
    /// Number of the beginning, from 1.
    pub beginning: usize,
    /// Where and when the person begins.
    pub begins: InitialConditionRecord,
    /// How sequences were chosen.
    pub strategy: String,
    /// Seed, if the campaign names any.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub seed: Option<u64>,
    /// The folder with its `scan.json`, seen from that of the campaign.
    pub folder: String,
    /// What came out.
    #[serde(flatten)]
    pub outcome: ScanOutcome,
}

/// What came out of a scan.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct ScanOutcome {
    /// In a word.
    pub state: State,
    /// As in its `scan.json`.
    pub verdict: String,
    /// Whether every sequence is accounted for.
    pub complete: bool,
    /// Different hazards.
    pub hazards: usize,
    /// Flaws that they come from.
    pub causes: usize,
    /// The worst of them.
    pub worst: Option<Worst>,
    /// Part of all sequences that is known to be hazardous, where all were looked at.
    pub hazardous_share: Option<f64>,
    /// What it cost.
    pub cost: Cost,
    /// Where, when and how hard, for pictures.
    #[serde(skip)]
    pub met: Vec<Spot>,
}

/// What can be said after a scan, or after several.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum State {
    /// Every sequence was looked at, and none is hazardous.
    None,
    /// No hazard was found, and not every sequence is accounted for.
    Open,
    /// There are hazards.
    Hazards,
}

/// A hazard, in short.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Worst {
    /// Its id.
    pub id: String,
    /// Force that decides over limit.
    pub ratio: f64,
    /// What is hit.
    pub body_region: String,
    /// By what.
    pub robot_link: String,
}

/// A hazard on the floor and in the cycle.
#[derive(Clone, Debug, PartialEq)]
pub struct Spot {
    /// Its id.
    pub id: String,
    /// Where the person stands, m.
    pub xy_m: [f64; 2],
    /// When, from the FMU's own start, s.
    pub time_s: f64,
    /// How hard.
    pub ratio: f64,
}

/// What searching cost, in units that are the same on every machine.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
pub struct Cost {
    /// Communication steps of the FMU that differ.
    pub fmu_steps: u64,
    /// Comparisons of a person with the robots.
    pub contact_checks: u64,
    /// Boxes of joint angles that arm searches looked at: nearly all of the time.
    pub arm_boxes: u64,
}

/// One cell.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct CellRow {
    /// Its name.
    pub cell: String,
    /// The one of the campaign file that it comes from.
    pub of: String,
    /// Values of the sweeps.
    #[serde(skip_serializing_if = "BTreeMap::is_empty")]
    pub at: BTreeMap<String, f64>,
    /// The body, if the campaign has several.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub body: Option<String>,
    /// What its scans say together.
    pub state: State,
    /// How many they are, and how many of them have hazards.
    pub scans: usize,
    /// Those of them with hazards.
    pub hazardous_scans: usize,
    /// Different hazards by their ids.
    pub hazards: usize,
    /// Highest force that decides over limit.
    pub worst_ratio: Option<f64>,
}

/// From which value of a sweep on, or up to which, no hazard was found and every sequence was looked at.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub struct Margin {
    /// The sweep.
    pub sweep: String,
    /// What its values are in.
    pub unit: String,
    /// The cell, the values of the other sweeps and the body, which are the same all along.
    pub with: String,
    /// The values that were tried, and what is known of each.
    pub tried: Vec<(f64, State)>,
    /// From this value on, of those that were tried.
    pub none_from: Option<f64>,
    /// Up to this value.
    pub none_up_to: Option<f64>,
}

/// What is read of a `scan.json`.
#[derive(Deserialize)]
struct Scanned {
    verdict: String,
    subject: Subject,
    #[serde(default)]
    causes: Vec<serde::de::IgnoredAny>,
    hazards: Vec<Hazard>,
    certificate: Option<Certificate>,
    coverage: Coverage,
    spent: Spent,
}

#[derive(Deserialize)]
struct Subject {
    #[serde(default)]
    beginning: Option<InitialConditionRecord>,
}

#[derive(Deserialize)]
struct Certificate {
    complete: bool,
    hazardous_share: f64,
}

#[derive(Deserialize)]
struct Coverage {
    contact_checks: u64,
    arm_boxes: u64,
}

#[derive(Deserialize)]
struct Spent {
    fmu_steps: u64,
}

impl ScanOutcome {
    /// What a `scan.json` says.
    ///
    /// # Errors
    /// When it is none.
    pub fn read(bytes: &[u8]) -> Result<Self, serde_json::Error> {
        let scan: Scanned = serde_json::from_slice(bytes)?;
        let complete = scan.certificate.as_ref().is_some_and(|c| c.complete);
        let state = match (scan.hazards.is_empty(), scan.verdict.as_str()) {
            (false, _) => State::Hazards,
            (true, "none_found") if complete => State::None,
            (true, _) => State::Open,
        };
        let begins_s = scan.subject.beginning.map_or(0.0, |begin| begin.begins_s);
        let spot = |hazard: &Hazard| Spot {
            id: hazard.id.clone(),
            xy_m: hazard.person_xy_m,
            time_s: begins_s + hazard.time_s,
            ratio: hazard.ratio,
        };
        Ok(Self {
            state,
            complete,
            hazards: scan.hazards.len(),
            causes: scan.causes.len(),
            worst: scan.hazards.first().map(|hazard| Worst {
                id: hazard.id.clone(),
                ratio: hazard.ratio,
                body_region: hazard.body_region.to_string(),
                robot_link: hazard.robot_link.clone(),
            }),
            hazardous_share: scan.certificate.filter(|c| c.complete).map(|c| c.hazardous_share),
            cost: Cost {
                fmu_steps: scan.spent.fmu_steps,
                contact_checks: scan.coverage.contact_checks,
                arm_boxes: scan.coverage.arm_boxes,
            },
            met: scan.hazards.iter().map(spot).collect(),
            verdict: scan.verdict,
        })
    }
}

impl State {
    /// What is known after two searches of the same.
    const fn with(self, other: Self) -> Self {
        match (self, other) {
            (Self::Hazards, _) | (_, Self::Hazards) => Self::Hazards,
            (Self::None, _) | (_, Self::None) => Self::None,
            (Self::Open, Self::Open) => Self::Open,
        }
    }

    /// For people.
    #[must_use]
    pub(crate) const fn words(self) -> &'static str {
        match self {
            Self::None => "no hazard, complete",
            Self::Open => "no hazard, not complete",
            Self::Hazards => "hazards",
        }
    }
}

impl Survey {
    /// The result of these scans.
    #[must_use]
    pub fn new(campaign: &str, tool: &str, sweeps: &[(String, String)], scans: Vec<Row>) -> Self {
        let mut cost = Cost::default();
        for row in &scans {
            cost.fmu_steps += row.outcome.cost.fmu_steps;
            cost.contact_checks += row.outcome.cost.contact_checks;
            cost.arm_boxes += row.outcome.cost.arm_boxes;
        }
        let cells: Vec<CellRow> = scans.chunk_by(|a, b| a.cell == b.cell).map(CellRow::of).collect();
        Self {
            schema_version: SCHEMA,
            tool: tool.to_owned(),
            campaign: campaign.to_owned(),
            sweeps: sweeps.to_vec(),
            cost,
            margins: sweeps.iter().flat_map(|sweep| Margin::all(sweep, &cells)).collect(),
            cells,
            scans,
        }
    }

    /// What all scans say together.
    #[must_use]
    pub fn state(&self) -> State {
        self.cells.iter().map(|cell| cell.state).max().unwrap_or(State::Open)
    }

    /// A row for each scan, comma-separated.
    ///
    /// # Errors
    /// Never, in practice.
    pub fn csv(&self) -> Result<String, String> {
        let mut writer = csv::Writer::from_writer(Vec::new());
        let fixed = ["scan", "cell", "body", "x_m", "y_m", "heading_deg", "begins_s", "strategy", "seed", "state"];
        let rest = [
            "verdict",
            "complete",
            "hazards",
            "causes",
            "worst",
            "worst_ratio",
            "body_region",
            "hit_by",
            "hazardous_share",
            "fmu_steps",
            "contact_checks",
            "arm_boxes",
            "folder",
        ];
        let sweeps = self
            .sweeps
            .iter()
            .map(|(name, unit)| if unit.is_empty() { name.clone() } else { format!("{name}_{unit}") });
        let header: Vec<String> =
            fixed.iter().map(ToString::to_string).chain(sweeps).chain(rest.iter().map(ToString::to_string)).collect();
        writer.write_record(&header).map_err(|e| e.to_string())?;
        for row in &self.scans {
            let (begins, outcome) = (&row.begins, &row.outcome);
            let worst = |of: fn(&Worst) -> String| outcome.worst.as_ref().map(of).unwrap_or_default();
            let state = match outcome.state {
                State::None => "none",
                State::Open => "open",
                State::Hazards => "hazards",
            };
            let mut record = vec![
                row.number.to_string(),
                row.cell.clone(),
                row.body.clone().unwrap_or_default(),
                begins.xy_m[0].to_string(),
                begins.xy_m[1].to_string(),
                begins.heading_deg.to_string(),
                begins.begins_s.to_string(),
                row.strategy.clone(),
                row.seed.map(|seed| seed.to_string()).unwrap_or_default(),
                state.to_owned(),
            ];
            record.extend(
                self.sweeps.iter().map(|(name, _)| row.at.get(name).map(ToString::to_string).unwrap_or_default()),
            );
            record.extend([
                outcome.verdict.clone(),
                outcome.complete.to_string(),
                outcome.hazards.to_string(),
                outcome.causes.to_string(),
                worst(|worst| worst.id.clone()),
                worst(|worst| worst.ratio.to_string()),
                worst(|worst| worst.body_region.clone()),
                worst(|worst| worst.robot_link.clone()),
                outcome.hazardous_share.map(|share| share.to_string()).unwrap_or_default(),
                outcome.cost.fmu_steps.to_string(),
                outcome.cost.contact_checks.to_string(),
                outcome.cost.arm_boxes.to_string(),
                row.folder.clone(),
            ]);
            writer.write_record(&record).map_err(|e| e.to_string())?;
        }
        let bytes = writer.into_inner().map_err(|e| e.to_string())?;
        String::from_utf8(bytes).map_err(|e| e.to_string())
    }

    /// For a terminal: a row for each cell, and what follows.
    #[must_use]
    pub fn render(&self) -> String {
        let header = ["cell", "scans", "with hazards", "hazards", "worst", "says"];
        let row = |cell: &CellRow| {
            vec![
                cell.cell.clone(),
                cell.scans.to_string(),
                cell.hazardous_scans.to_string(),
                cell.hazards.to_string(),
                cell.worst_ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.2}x")),
                cell.state.words().to_owned(),
            ]
        };
        let rows: Vec<Vec<String>> = self.cells.iter().map(row).collect();
        let margins: String = self.margins.iter().map(|margin| format!("\n {}\n", margin.sentence())).collect();
        let s = if self.scans.len() == 1 { "" } else { "s" };
        format!("{}: {} scan{s}\n\n{}{margins}", self.campaign, self.scans.len(), columns(&header, &rows, false))
    }
}

impl CellRow {
    /// What scans of one cell say together.
    fn of(rows: &[Row]) -> Self {
        let first = &rows[0];
        let ids: BTreeSet<&String> = rows.iter().flat_map(|row| &row.outcome.met).map(|spot| &spot.id).collect();
        // From one beginning a hazard of any search counts, and a complete search more than others that found nothing.
        let mut states: BTreeMap<usize, State> = BTreeMap::new();
        for row in rows {
            let known = states.entry(row.beginning).or_insert(row.outcome.state);
            *known = known.with(row.outcome.state);
        }
        let worst = rows.iter().filter_map(|row| row.outcome.worst.as_ref()).map(|worst| worst.ratio);
        Self {
            cell: first.cell.clone(),
            of: first.of.clone(),
            at: first.at.clone(),
            body: first.body.clone(),
            state: states.into_values().max().unwrap_or(State::Open),
            scans: rows.len(),
            hazardous_scans: rows.iter().filter(|row| row.outcome.hazards > 0).count(),
            hazards: ids.len(),
            worst_ratio: worst.reduce(f64::max),
        }
    }
}

impl Margin {
    /// Those of a sweep: one for each cell, body and choice of values of the other sweeps, where there are two values at least.
    fn all((sweep, unit): &(String, String), cells: &[CellRow]) -> Vec<Self> {
        let mut lines: BTreeMap<String, Vec<&CellRow>> = BTreeMap::new();
        let mut order = Vec::new();
        for cell in cells.iter().filter(|cell| cell.at.contains_key(sweep)) {
            let with = line_of(cell, sweep);
            if !lines.contains_key(&with) {
                order.push(with.clone());
            }
            lines.entry(with).or_default().push(cell);
        }
        let margin = |with: String| {
            let mut tried: Vec<(f64, State)> = lines[&with].iter().map(|cell| (cell.at[sweep], cell.state)).collect();
            tried.sort_by(|a, b| a.0.total_cmp(&b.0));
            let is_none = |tried: &&(f64, State)| tried.1 == State::None;
            let none_from = tried.iter().rev().take_while(is_none).last().map(|t| t.0);
            let none_up_to = tried.iter().take_while(is_none).last().map(|t| t.0);
            Self { sweep: sweep.clone(), unit: unit.clone(), with, tried, none_from, none_up_to }
        };
        order.into_iter().map(margin).filter(|margin| margin.tried.len() > 1).collect()
    }

    /// What follows, for people.
    #[must_use]
    pub(crate) fn sentence(&self) -> String {
        let value = |value: f64| match self.unit.as_str() {
            "" => format!("{value}"),
            unit => format!("{value} {unit}"),
        };
        let (first, last) = (self.tried.first().map_or(0.0, |t| t.0), self.tried.last().map_or(0.0, |t| t.0));
        let (low, high) = (value(first), value(last));
        let said = match (self.none_from, self.none_up_to) {
            (Some(from), _) if from.total_cmp(&first).is_eq() => format!("no hazard at any value from {low} to {high}"),
            (Some(from), None) => {
                let before = self.tried.iter().rev().find(|t| t.0 < from);
                let before = before.map_or_else(String::new, |t| format!("; at {} {}", value(t.0), State::told(t.1)));
                format!("no hazard from {} on, up to {high}{before}", value(from))
            }
            (None, Some(to)) => {
                let after = self.tried.iter().find(|t| t.0 > to);
                let after = after.map_or_else(String::new, |t| format!("; at {} {}", value(t.0), State::told(t.1)));
                format!("no hazard up to {}, from {low} on{after}", value(to))
            }
            (Some(from), Some(to)) => {
                format!("no hazard up to {} and none from {} on; in between there is something", value(to), value(from))
            }
            (None, None) => match self.tried.iter().any(|t| t.1 == State::None) {
                true => format!("no single limit between {low} and {high}: see the table"),
                false => format!("no value from {low} to {high} is shown to be without hazards"),
            },
        };
        format!("{} ({}): {said}", self.sweep, self.with)
    }
}

impl State {
    /// In a sentence about a value.
    const fn told(self) -> &'static str {
        match self {
            Self::None => "there is none",
            Self::Open => "not every sequence could be looked at",
            Self::Hazards => "somebody is hit",
        }
    }
}

/// What is the same in all cells that differ in one sweep alone.
pub(super) fn line_of(cell: &CellRow, sweep: &str) -> String {
    let others = cell.at.iter().filter(|(name, _)| *name != sweep).map(|(name, value)| format!("{name} {value}"));
    std::iter::once(cell.of.clone()).chain(others).chain(cell.body.clone()).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
pub(super) mod tests {
    use super::*;

    /// A scan of the cell `c` at value `at` of the sweep `w`, from beginning `beginning`.
    pub(crate) fn scanned(at: f64, beginning: usize, state: State, ratio: f64) -> Row {
        let hazards = usize::from(state == State::Hazards);
        let begins = InitialConditionRecord { xy_m: [0.5, -1.0], heading_deg: 90.0, begins_s: 0.2 * beginning as f64 };
        let spot = Spot { id: format!("H-{beginning}"), xy_m: [0.1 * beginning as f64, -0.5], time_s: 1.0, ratio };
        let worst = Worst { id: spot.id.clone(), ratio, body_region: "neck".into(), robot_link: "a<b".into() };
        Row {
            number: 1,
            cell: format!("c-w-{at}"),
            of: "c".to_owned(),
            at: BTreeMap::from([("w".to_owned(), at)]),
            body: None,
            beginning,
            begins,
            strategy: "exhaustive".to_owned(),
            seed: None,
            folder: "scans/0001".to_owned(),
            outcome: ScanOutcome {
                state,
                verdict: String::new(),
                complete: state != State::Open,
                hazards,
                causes: hazards,
                worst: (hazards > 0).then_some(worst),
                hazardous_share: None,
                cost: Cost { fmu_steps: 1, contact_checks: 2, arm_boxes: 3 },
                met: if hazards > 0 { vec![spot] } else { Vec::new() },
            },
        }
    }

    /// The survey of these states at 0.1, 0.2, ... m.
    pub(crate) fn survey(states: &[State]) -> Survey {
        let at = |n: usize| (n + 1) as f64 / 10.0;
        let rows = states.iter().enumerate().map(|(n, state)| scanned(at(n), 1, *state, 2.0 - at(n)));
        Survey::new("width", "t", &[("w".to_owned(), "m".to_owned())], rows.collect())
    }

    #[test]
    fn the_smallest_value_without_hazards_is_that_above_all_others() {
        use State::{Hazards as H, None as N, Open as O};
        for (states, from, up_to, words) in [
            (vec![H, H, N, N], Some(0.3), None, "no hazard from 0.3 m on, up to 0.4 m; at 0.2 m somebody is hit"),
            (vec![H, N, H, N], Some(0.4), None, "no hazard from 0.4 m on"),
            (vec![H, N, O, N], Some(0.4), None, "at 0.3 m not every sequence"),
            (vec![N, N, H, O], None, Some(0.2), "no hazard up to 0.2 m"),
            (vec![N, N], Some(0.1), Some(0.2), "no hazard at any value from 0.1 m to 0.2 m"),
            (vec![N, H, N], Some(0.3), Some(0.1), "up to 0.1 m and none from 0.3 m on"),
            (vec![H, N, H], None, None, "no single limit"),
            (vec![H, O, O], None, None, "no value from 0.1 m to 0.3 m"),
        ] {
            let survey = survey(&states);
            let margin = &survey.margins[0];
            assert_eq!((margin.none_from, margin.none_up_to), (from, up_to), "{states:?}");
            assert!(margin.sentence().contains(words), "{}", margin.sentence());
            assert!(survey.render().contains(words));
        }
        assert!(survey(&[N]).margins.is_empty(), "one value is no sweep");
    }

    #[test]
    fn a_cell_is_without_hazards_only_if_every_beginning_is() {
        use State::{Hazards as H, None as N, Open as O};
        for (states, expected) in [
            (vec![(1, N), (2, N)], N),
            (vec![(1, N), (2, O)], O),
            (vec![(1, N), (1, O)], N),
            (vec![(1, N), (1, H)], H),
            (vec![(1, O), (2, H)], H),
        ] {
            let rows = states.iter().map(|(beginning, state)| scanned(0.1, *beginning, *state, 1.2)).collect();
            let survey = Survey::new("n", "t", &[], rows);
            assert_eq!(survey.cells.len(), 1);
            assert_eq!(survey.state(), expected, "{states:?}");
            let csv = survey.csv().unwrap();
            assert_eq!(csv.lines().count(), states.len() + 1, "{csv}");
        }
    }
}
