//! Hazards that are known already, from an earlier scan: only new ones and worse ones shall fail a pipeline.

use std::collections::BTreeMap;

use super::difference::Change;
use super::model::{Hazard, ScanReport};
use super::recorded::Recorded;

/// Known hazards by id.
#[derive(Clone, Debug, Default)]
pub struct Baseline {
    known: BTreeMap<String, Hazard>,
}

/// How a hazard stands to a baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Standing {
    /// It is not in it.
    New,
    /// It is, but was less hard.
    Worse {
        /// Force ratio in the baseline.
        was: f64,
    },
    /// It is in it.
    Known,
}

impl Baseline {
    /// The hazards of an earlier scan.
    #[must_use]
    pub fn of(scan: Recorded) -> Self {
        Self { known: scan.hazards.into_iter().map(|hazard| (hazard.id.clone(), hazard)).collect() }
    }

    /// How a hazard stands to it.
    #[must_use]
    pub fn standing(&self, hazard: &Hazard) -> Standing {
        match self.known.get(&hazard.id) {
            None => Standing::New,
            Some(known) if Change::of_ratio(known.ratio, hazard.ratio) == Change::Worse => {
                Standing::Worse { was: known.ratio }
            }
            Some(_) => Standing::Known,
        }
    }

    /// What it knows and the scan did not find.
    pub fn gone<'a>(&'a self, report: &'a ScanReport) -> impl Iterator<Item = &'a Hazard> {
        self.known.values().filter(|known| report.hazards.iter().all(|hazard| hazard.id != known.id))
    }

    /// Hazards of a scan that are new or became worse.
    pub fn failing<'a>(&'a self, report: &'a ScanReport) -> impl Iterator<Item = &'a Hazard> {
        report.hazards.iter().filter(|hazard| self.standing(hazard) != Standing::Known)
    }
}
