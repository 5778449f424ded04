//! Two scans side by side: which causes and hazards are fixed, which are the same, worse or less, which are new, and what of the
//! inputs is different.

use std::collections::BTreeMap;
use std::fmt::Write as _;

use schemars::JsonSchema;
use serde::Serialize;

use fmi_hazard_record::cause::{Grouped, grouped};
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::model::FmuSubject;
use fmi_hazard_record::narrower::Narrower;
use fmi_hazard_record::paragraph::wrapped_under;
use fmi_hazard_record::recorded::{Recorded, RecordedSubject};

/// Relative change of the force ratio below which a hazard is the same.
const SAME: f64 = 0.005;

/// What became of a hazard.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Serialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Change {
    /// Only after.
    New,
    /// In both, harder after.
    Worse,
    /// In both, about as hard.
    Same,
    /// In both, less hard after.
    Less,
    /// Only before, and the later scan was not complete, or asked less: it may still be there.
    NotFoundAgain,
    /// Only before, and the later scan is complete, and would have told it.
    Fixed,
}

impl Change {
    /// Of a force ratio.
    #[must_use]
    pub(crate) fn of_ratio(before: f64, after: f64) -> Self {
        if after > before * (1.0 + SAME) {
            Self::Worse
        } else if after < before * (1.0 - SAME) {
            Self::Less
        } else {
            Self::Same
        }
    }

    /// As printed.
    #[must_use]
    pub(crate) const fn words(self) -> &'static str {
        match self {
            Self::New => "NEW",
            Self::Worse => "WORSE",
            Self::Same => "same",
            Self::Less => "less",
            Self::NotFoundAgain => "not found again",
            Self::Fixed => "fixed",
        }
    }
}

/// A hazard in both scans or in one of them.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "HazardChange")]
pub struct Row {
    /// What became of it.
    pub change: Change,
    /// Its id.
    pub id: String,
    /// Body region.
    pub body_region: String,
    /// Robot link.
    pub robot_link: String,
    /// Force ratio before.
    pub before: Option<f64>,
    /// Force ratio after.
    pub after: Option<f64>,
    /// Why the later scan may not have told it though it is still there, if it was not found again and what the later scan asks
    /// is narrower.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub narrower: Option<Narrower>,
}

impl Row {
    /// Of a hazard of the earlier scan.
    fn of(hazard: &Hazard, change: Change) -> Self {
        Self {
            change,
            id: hazard.id.clone(),
            body_region: hazard.body_region.to_string(),
            robot_link: hazard.robot_link.clone(),
            before: Some(hazard.ratio),
            after: None,
            narrower: None,
        }
    }
}

/// A cause in both scans or in one of them.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "CauseChange")]
pub struct CauseRow {
    /// What became of it: it is fixed when all its hazards are.
    pub change: Change,
    /// Its id.
    pub id: String,
    /// What is wrong.
    pub sentence: String,
    /// Its hazards before.
    pub before: usize,
    /// Its hazards after.
    pub after: usize,
}

/// Two scans side by side.
#[derive(Clone, Debug, PartialEq, Serialize, JsonSchema)]
#[schemars(rename = "Comparison")]
pub struct Difference {
    /// The causes: new ones first.
    pub causes: Vec<CauseRow>,
    /// The hazards: new ones first, then by id.
    pub hazards: Vec<Row>,
    /// How many of each kind.
    pub counts: BTreeMap<Change, usize>,
    /// What of the inputs is different, in words.
    pub inputs: Vec<String>,
    /// Whether each of the two is complete: what it did not find is not there, within what it asks.
    pub complete: [bool; 2],
}

impl Difference {
    /// What is different in `after`. `texts` are the two cell files, if they are still as scanned.
    #[must_use]
    pub fn between(before: &Recorded, after: &Recorded, texts: [Option<&str>; 2]) -> Self {
        let by_id = |scan: &'_ Recorded| -> BTreeMap<String, Hazard> {
            scan.hazards.iter().map(|hazard| (hazard.id.clone(), hazard.clone())).collect()
        };
        let (old, new) = (by_id(before), by_id(after));
        let mut hazards: Vec<Row> = old
            .values()
            .map(|hazard| match new.get(&hazard.id) {
                Some(found) => {
                    Row { after: Some(found.ratio), ..Row::of(hazard, Change::of_ratio(hazard.ratio, found.ratio)) }
                }
                None => Row {
                    narrower: after.narrower(before, hazard),
                    ..Row::of(
                        hazard,
                        if after.would_report(before, hazard) { Change::Fixed } else { Change::NotFoundAgain },
                    )
                },
            })
            .chain(new.values().filter(|hazard| !old.contains_key(&hazard.id)).map(|hazard| Row {
                before: None,
                after: Some(hazard.ratio),
                ..Row::of(hazard, Change::New)
            }))
            .collect();
        hazards.sort_by(|a, b| a.change.cmp(&b.change).then_with(|| a.id.cmp(&b.id)));
        let mut counts = BTreeMap::new();
        hazards.iter().for_each(|row| *counts.entry(row.change).or_default() += 1);
        let causes = causes(before, after, &hazards);
        Self {
            causes,
            hazards,
            counts,
            inputs: inputs(before, after, texts),
            complete: [before.complete(), after.complete()],
        }
    }

    /// How many hazards changed so.
    #[must_use]
    pub(crate) fn count(&self, change: Change) -> usize {
        self.counts.get(&change).copied().unwrap_or(0)
    }

    /// Whether something is there that was not, or is worse than it was.
    #[must_use]
    pub fn is_worse(&self) -> bool {
        self.count(Change::New) + self.count(Change::Worse) > 0
    }

    /// Whether the later scan shows that nothing is new or worse, and what it calls gone: it is complete, and would have told all that it
    /// did not find again.
    #[must_use]
    pub fn is_shown(&self) -> bool {
        self.complete[1] && self.count(Change::NotFoundAgain) == 0
    }

    /// For people; with every hazard if that is wanted.
    #[must_use]
    pub fn render(&self, every: bool) -> String {
        let mut out = String::new();
        for CauseRow { change, id, sentence, before, after } in &self.causes {
            let ways = match (before, after) {
                (0, after) => format!("{after} hazards"),
                (before, 0) => format!("{before} hazards before"),
                (before, after) => format!("{before} hazards before, {after} after"),
            };
            out += &wrapped_under(&format!(" {:<15}  {id}  ", change.words()), &format!("{sentence} ({ways})"));
        }
        if !self.causes.is_empty() {
            out.push('\n');
        }
        let ratio = |ratio: Option<f64>| ratio.map_or_else(|| "-".to_owned(), |ratio| format!("{ratio:.2}x"));
        let rows: Vec<Vec<String>> = self
            .hazards
            .iter()
            .map(|row| {
                vec![
                    row.change.words().to_owned(),
                    row.id.clone(),
                    ratio(row.before),
                    ratio(row.after),
                    row.body_region.clone(),
                    row.robot_link.clone(),
                ]
            })
            .collect();
        if every && !rows.is_empty() {
            out += &super::columns(&["", "id", "before", "after", "body region", "hit by"], &rows, false);
            out.push('\n');
        }
        let counted: Vec<String> = self.counts.iter().map(|(change, n)| format!("{n} {}", change.words())).collect();
        let summary = if counted.is_empty() { "no hazards in either scan".to_owned() } else { counted.join(", ") };
        let _ = writeln!(out, " {summary}.");
        if self.inputs.is_empty() {
            out += " Inputs are the same: cell file, FMUs, settings, tool.\n";
        }
        for input in &self.inputs {
            let _ = writeln!(out, " Differs: {input}");
        }
        for (scan, complete) in ["first", "second"].iter().zip(self.complete) {
            if !complete {
                let _ = writeln!(out, " The {scan} scan is not complete: it may have missed hazards.");
            }
        }
        let mut narrower: BTreeMap<&Narrower, usize> = BTreeMap::new();
        self.hazards
            .iter()
            .filter_map(|row| row.narrower.as_ref())
            .for_each(|why| *narrower.entry(why).or_default() += 1);
        for (why, n) in narrower {
            let s = if n == 1 { "" } else { "s" };
            let text =
                format!("{n} hazard{s} may still be there: the second scan {}. To know, {}.", why.words(), why.help());
            out += &wrapped_under(" ", &text);
        }
        out
    }
}

/// What became of the causes, by what became of their hazards.
fn causes(before: &Recorded, after: &Recorded, hazards: &[Row]) -> Vec<CauseRow> {
    let by_id: BTreeMap<&str, &Row> = hazards.iter().map(|row| (row.id.as_str(), row)).collect();
    let [old, new] = [before, after].map(|scan| grouped(&scan.causes, &scan.hazards));
    let mut all: Vec<CauseRow> = Vec::new();
    for cause in new.iter().chain(&old) {
        if all.iter().any(|row| row.id == cause.id) {
            continue;
        }
        let members = |of: &[Grouped<'_>]| -> Vec<String> {
            let found = of.iter().filter(|other| other.id == cause.id);
            found.flat_map(|cause| cause.hazards.iter().map(|hazard| hazard.id.clone())).collect()
        };
        let [mine_before, mine_after] = [&old, &new].map(|of| members(of));
        let rows: Vec<&Row> =
            mine_before.iter().chain(&mine_after).filter_map(|id| by_id.get(id.as_str()).copied()).collect();
        let all_are = |kinds: &[Change]| rows.iter().all(|row| kinds.contains(&row.change));
        let worst = |of: fn(&Row) -> Option<f64>| rows.iter().filter_map(|row| of(row)).fold(0.0, f64::max);
        let change = if all_are(&[Change::New]) {
            Change::New
        } else if all_are(&[Change::Fixed]) {
            Change::Fixed
        } else if all_are(&[Change::Fixed, Change::NotFoundAgain]) {
            Change::NotFoundAgain
        } else if rows.iter().any(|row| matches!(row.change, Change::New | Change::Worse)) {
            Change::Worse
        } else if all_are(&[Change::Same]) {
            Change::Same
        } else {
            match Change::of_ratio(worst(|row| row.before), worst(|row| row.after)) {
                // Some of its hazards are gone.
                Change::Same => Change::Less,
                other => other,
            }
        };
        let (before, after) = (mine_before.len(), mine_after.len());
        all.push(CauseRow { change, id: cause.id.to_owned(), sentence: cause.sentence.clone(), before, after });
    }
    all.sort_by(|a, b| a.change.cmp(&b.change).then_with(|| a.id.cmp(&b.id)));
    all
}

/// What of the inputs is different.
fn inputs(before: &Recorded, after: &Recorded, texts: [Option<&str>; 2]) -> Vec<String> {
    let mut out = Vec::new();
    let mut tell = |what: &str, a: &str, b: &str| {
        if a != b {
            out.push(format!("{what}: {a} -> {b}"));
        }
    };
    tell("tool", &before.tool, &after.tool);
    tell("edition of the limits", &before.standard_edition, &after.standard_edition);
    tell("cell", &before.subject.cell, &after.subject.cell);
    let begins =
        |scan: &Recorded| scan.begins().map_or_else(|| "as the cell file says".to_owned(), |begins| begins.words());
    tell("the person begins", &begins(before), &begins(after));
    let unit = |scan: &Recorded, name: &str| {
        let found = scan.subject.fmus.iter().find(|fmu| fmu.unit == name);
        found.map_or_else(|| "none".to_owned(), |FmuSubject { sha256, .. }| short(sha256))
    };
    let mut units: Vec<&str> =
        before.subject.fmus.iter().chain(&after.subject.fmus).map(|fmu| fmu.unit.as_str()).collect();
    units.sort_unstable();
    units.dedup();
    for name in units {
        tell(format!("FMU {name}").trim_end(), &unit(before, name), &unit(after, name));
    }
    let keys: std::collections::BTreeSet<&String> = before.settings.keys().chain(after.settings.keys()).collect();
    for key in keys.into_iter().filter(|key| *key != "begins") {
        let value = |scan: &Recorded| scan.settings.get(key).map_or_else(|| "none".to_owned(), ToString::to_string);
        tell(&format!("settings.{key}"), &value(before), &value(after));
    }
    if before.subject.files != after.subject.files {
        let told = |subject: &RecordedSubject| {
            let files = subject.files.iter().map(|file| format!("{} {}", file.path, short(&file.sha256)));
            files.collect::<Vec<_>>().join(", ")
        };
        tell("other files", &told(&before.subject), &told(&after.subject));
    }
    if before.subject.cell_sha256 != after.subject.cell_sha256 {
        let tables = texts.map(|text| text.and_then(|text| text.parse::<toml::Table>().ok()));
        if let [Some(a), Some(b)] = tables {
            let (a, b) = (leaves(&toml::Value::Table(a)), leaves(&toml::Value::Table(b)));
            let keys: std::collections::BTreeSet<&String> = a.keys().chain(b.keys()).collect();
            for key in keys {
                let value = |of: &BTreeMap<String, String>| of.get(key).cloned().unwrap_or_else(|| "none".to_owned());
                tell(&format!("cell file, {key}"), &value(&a), &value(&b));
            }
        }
        // Comments and layout are no difference that matters, but the bytes are not the same.
        tell("cell file", &short(&before.subject.cell_sha256), &short(&after.subject.cell_sha256));
    }
    out
}

/// The first digits of a hash.
fn short(sha256: &str) -> String {
    format!("sha256 {}...", sha256.chars().take(12).collect::<String>())
}

/// Every value of a cell file under its path; tables in a list go by their name where they have one.
fn leaves(value: &toml::Value) -> BTreeMap<String, String> {
    fn visit(value: &toml::Value, path: &str, out: &mut BTreeMap<String, String>) {
        let under = |key: &str| if path.is_empty() { key.to_owned() } else { format!("{path}.{key}") };
        match value {
            toml::Value::Table(table) => table.iter().for_each(|(key, value)| visit(value, &under(key), out)),
            toml::Value::Array(items) if items.iter().any(toml::Value::is_table) => {
                for (number, item) in items.iter().enumerate() {
                    let name = item.get("name").and_then(toml::Value::as_str);
                    visit(item, &under(&name.map_or_else(|| number.to_string(), str::to_owned)), out);
                }
            }
            leaf => {
                out.insert(path.to_owned(), leaf.to_string());
            }
        }
    }
    let mut out = BTreeMap::new();
    visit(value, "", &mut out);
    out
}
