//! The campaign file: which cells, laid over with what, swept over which values, for which bodies, searched how.

use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

use clap::ValueEnum as _;
use serde::{Deserialize, Serialize};

use super::CampaignError;
use super::values::{rounded, steps};
use crate::scan::StrategyName;

/// Version of the format.
const SCHEMA: u32 = 1;

/// Most values of a sweep, and most cells of a campaign.
const MOST: usize = 10_000;

/// A campaign file.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct Description {
    /// Version of the format: 1.
    pub schema: u32,
    /// What results are called.
    pub name: String,
    /// Cell files, relative to this one.
    pub cells: Vec<PathBuf>,
    /// What is laid over each of them, as a variant of it would say it. A text that begins with `=` is worked out.
    #[serde(default)]
    pub over: toml::Table,
    /// Values that `over` uses by name: every one of each with every one of the others.
    #[serde(default, rename = "sweep")]
    sweeps: Vec<Sweep>,
    /// Bodies: each cell for each of them.
    #[serde(default, rename = "body")]
    pub bodies: Vec<BodyOf>,
    /// How each is searched.
    #[serde(default)]
    pub search: Search,
}

/// Values of something, as they are written.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
struct Sweep {
    name: String,
    #[serde(default)]
    unit: String,
    values: Option<Vec<f64>>,
    from: Option<f64>,
    to: Option<f64>,
    steps: Option<u32>,
}

/// A sweep with its values in their order.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Axis {
    /// Its name in `over` and in tables.
    pub name: String,
    /// What its values are in.
    pub unit: String,
    /// Rising.
    pub values: Vec<f64>,
}

/// A body.
#[derive(Clone, Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(crate) struct BodyOf {
    /// As in a cell file.
    pub sex: String,
    /// As in a cell file.
    pub percentile: u32,
}

/// How scans search.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize)]
#[serde(deny_unknown_fields, default)]
pub(crate) struct Search {
    /// One scan for each: `exhaustive`, `auto`, or a strategy.
    pub strategies: Vec<String>,
    /// One scan for each; the cell's, else 1, if there is none.
    pub seeds: Vec<u64>,
    /// Sequences of strategies; the cell's, else 320.
    pub iterations: Option<u32>,
    /// Whether a scan by a strategy ends with its first hazard.
    pub stop_at_first: bool,
    /// Into how many tasks each exhaustive search is divided; 1 for not at all.
    pub parts: u32,
    /// Most distinct states.
    pub max_states: usize,
    /// Most memory for states, MB.
    pub max_memory: usize,
    /// Most work of arm searches, millions of boxes.
    pub max_work: Option<u64>,
}

impl Default for Search {
    fn default() -> Self {
        Self {
            strategies: vec![EXHAUSTIVE.to_owned()],
            seeds: Vec::new(),
            iterations: None,
            stop_at_first: false,
            parts: 1,
            max_states: 20_000_000,
            max_memory: 4_000,
            max_work: None,
        }
    }
}

/// The name of the search of everything, and of the one with a strategy beside it.
pub(super) const EXHAUSTIVE: &str = "exhaustive";
pub(super) const AUTO: &str = "auto";

impl Description {
    /// Reads and looks at it.
    ///
    /// # Errors
    /// When it cannot be read, or says something that cannot be.
    pub(crate) fn read(path: &Path) -> Result<(Self, String), CampaignError> {
        let wrong = |what: String, help: &str| CampaignError::Description {
            path: path.to_owned(),
            what,
            help: help.to_owned(),
        };
        let text =
            std::fs::read_to_string(path).map_err(|e| wrong(format!("it cannot be read: {e}"), "give a TOML file"))?;
        let description: Self = toml::from_str(&text)
            .map_err(|e| wrong(e.to_string().trim_end().to_owned(), "the book's page on campaigns has every key"))?;
        description.check().map_err(|(what, help)| wrong(what, help))?;
        Ok((description, text))
    }

    fn check(&self) -> Result<(), (String, &'static str)> {
        if self.schema != SCHEMA {
            return Err((format!("schema is {}", self.schema), "this version reads schema = 1"));
        }
        if self.cells.is_empty() {
            return Err(("it names no cell".to_owned(), "add cells = [\"cell.toml\"]"));
        }
        if self.name.trim().is_empty() {
            return Err(("its name is empty".to_owned(), "give it one: results are called by it"));
        }
        for key in ["name", "extends", "schema"] {
            if self.over.contains_key(key) {
                return Err((format!("`over.{key}` is set"), "leave it out: the campaign gives each variant its own"));
            }
        }
        let mut names = BTreeSet::new();
        for sweep in &self.sweeps {
            let good = |c: char| c.is_alphanumeric() || c == '_';
            let begins = sweep.name.starts_with(|c: char| c.is_alphabetic() || c == '_');
            if !begins || !sweep.name.chars().all(good) {
                return Err((format!("a sweep is called `{}`", sweep.name), "names are of letters, digits and _"));
            }
            if !names.insert(&sweep.name) {
                return Err((format!("two sweeps are called `{}`", sweep.name), "give each a name of its own"));
            }
            sweep.axis().map_err(|what| {
                (format!("sweep `{}` {what}", sweep.name), "give values = [...], or from, to and steps (2 to 10000)")
            })?;
        }
        let axes = self.axes();
        let variants =
            axes.iter().fold(self.cells.len() * self.bodies.len().max(1), |n, a| n.saturating_mul(a.values.len()));
        if variants > MOST {
            return Err((format!("it makes {variants} cells"), "10000 are the most"));
        }
        self.search.check()
    }

    /// The sweeps with their values.
    #[must_use]
    pub(crate) fn axes(&self) -> Vec<Axis> {
        self.sweeps.iter().filter_map(|sweep| sweep.axis().ok()).collect()
    }
}

impl Sweep {
    fn axis(&self) -> Result<Axis, String> {
        let mut values = match (&self.values, self.from, self.to, self.steps) {
            (Some(values), None, None, None) => values.clone(),
            (None, Some(from), Some(to), Some(count)) if (2..=10_000).contains(&count) => steps(from, to, count),
            _ => return Err("does not say which values it has".to_owned()),
        };
        if values.is_empty() || values.len() > MOST || values.iter().any(|value| !value.is_finite()) {
            return Err("has no values, too many, or one that is no number".to_owned());
        }
        values.iter_mut().for_each(|value| *value = rounded(*value));
        values.sort_by(f64::total_cmp);
        values.dedup();
        Ok(Axis { name: self.name.clone(), unit: self.unit.clone(), values })
    }
}

impl Search {
    fn check(&self) -> Result<(), (String, &'static str)> {
        for name in &self.strategies {
            if !is_of_all(name) && StrategyName::from_str(name, false).is_err() {
                return Err((
                    format!("there is no strategy `{name}`"),
                    "they are exhaustive, auto, mcts-dpw, mcts-dpw-lee, mcts-dpw-literal, random, plan and hybrid",
                ));
            }
        }
        let strategies: BTreeSet<_> = self.strategies.iter().collect();
        let seeds: BTreeSet<_> = self.seeds.iter().collect();
        if strategies.len() < self.strategies.len() || seeds.len() < self.seeds.len() {
            return Err(("search names a strategy or a seed twice".to_owned(), "the same scan twice gives the same"));
        }
        let alone = self.strategies.iter().all(|name| name == EXHAUSTIVE);
        match self {
            _ if self.strategies.is_empty() => {
                Err(("search.strategies is empty".to_owned(), "leave it out, or name one"))
            }
            _ if !(1..=10_000).contains(&self.parts) => {
                Err(("search.parts is not from 1 to 10000".to_owned(), "1 does not divide"))
            }
            _ if self.parts > 1 && !alone => Err((
                "search.parts divides exhaustive searches only".to_owned(),
                "put other strategies into a campaign of their own",
            )),
            _ if self.parts > 1 && self.max_work.is_some() => {
                Err(("search.max_work bounds one machine's work".to_owned(), "leave it out where searches are divided"))
            }
            _ => Ok(()),
        }
    }
}

/// Whether a search of this name goes through all sequences, as far as it comes.
pub(super) fn is_of_all(name: &str) -> bool {
    [EXHAUSTIVE, AUTO].contains(&name)
}
