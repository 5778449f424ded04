//! Hazards that are known already, from an earlier scan: only new ones and worse ones shall fail a pipeline.

use std::collections::{BTreeMap, BTreeSet};

use super::difference::Change;
use fmi_hazard_record::cause::{Cause, Grouped, grouped};
use fmi_hazard_record::hazard::Hazard;
use fmi_hazard_record::model::ScanReport;
use fmi_hazard_record::narrower::Narrower;
use fmi_hazard_record::recorded::{Recorded, RecordedSubject};
use fmi_hazard_record::scan_question::ScanQuestion;

/// Known hazards by id, and their causes.
#[derive(Clone, Debug, Default)]
pub struct Baseline {
    known: BTreeMap<String, Hazard>,
    hazards: Vec<Hazard>,
    causes: Vec<Cause>,
    looks: Option<ScanQuestion>,
    edition: Option<String>,
    subject: Option<RecordedSubject>,
}

/// How a hazard stands to a baseline.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Standing {
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
        let known = scan.hazards.iter().map(|hazard| (hazard.id.clone(), hazard.clone())).collect();
        let looks = scan.looks().map(|looks| ScanQuestion { begins: scan.begins(), ..looks });
        Self {
            known,
            looks,
            edition: Some(scan.standard_edition),
            subject: Some(scan.subject),
            hazards: scan.hazards,
            causes: scan.causes,
        }
    }

    /// How a hazard stands to it.
    #[must_use]
    pub(crate) fn standing(&self, hazard: &Hazard) -> Standing {
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

    /// Causes that it knows, of which the scan found no hazard at all.
    #[must_use]
    pub(crate) fn gone_causes(&self, report: &ScanReport) -> Vec<Grouped<'_>> {
        let found: BTreeSet<&str> = report.hazards.iter().map(|hazard| hazard.id.as_str()).collect();
        let causes: BTreeSet<&str> = report.causes.iter().map(|cause| cause.id.as_str()).collect();
        let gone = |cause: &Grouped<'_>| {
            !causes.contains(cause.id) && cause.hazards.iter().all(|hazard| !found.contains(hazard.id.as_str()))
        };
        grouped(&self.causes, &self.hazards).into_iter().filter(gone).collect()
    }

    /// Why the scan may not have told this hazard though it is still there, if it is complete; nothing if it would have.
    #[must_use]
    pub(crate) fn narrower(&self, report: &ScanReport, hazard: &Hazard) -> Option<Narrower> {
        let ScanReport { subject, settings, standard_edition, .. } = report;
        let mut mine = ScanQuestion::from(settings);
        let (Some(mut its), Some(edition)) = (self.looks.clone(), &self.edition) else {
            return Some(Narrower::NotRecorded);
        };
        if edition != standard_edition {
            return Some(Narrower::Edition);
        }
        if self.subject.as_ref().is_some_and(|known| known.is_cell(&subject.cell_sha256, &subject.files)) {
            its.or_of(&mine);
            mine.or_of(&its);
        }
        mine.narrower(&its, hazard, report.hazards.iter().map(|hazard| hazard.class))
    }

    /// Hazards of a scan that are new or became worse.
    pub fn failing<'a>(&'a self, report: &'a ScanReport) -> impl Iterator<Item = &'a Hazard> {
        report.hazards.iter().filter(|hazard| self.standing(hazard) != Standing::Known)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use fmi_hazard_record::fixtures;

    #[test]
    fn known_hazards_that_became_worse_fail_as_new_ones_do() {
        let known = ["H-000001", "H-000002"].map(|id| (id.to_owned(), fixtures::hazard(id, 1.2)));
        let baseline = Baseline { known: BTreeMap::from(known), ..Baseline::default() };
        // Half a percent more than 1.2 is 1.206: up to there it is the same.
        for (id, ratio, standing) in [
            ("H-000001", 1.0, Standing::Known),
            ("H-000001", 1.2, Standing::Known),
            ("H-000001", 1.205, Standing::Known),
            ("H-000001", 1.21, Standing::Worse { was: 1.2 }),
            ("H-000003", 1.2, Standing::New),
        ] {
            assert_eq!(baseline.standing(&fixtures::hazard(id, ratio)), standing, "{id} {ratio}");
        }
        let found = [("H-000001", 1.3), ("H-000002", 1.2), ("H-000003", 1.1)];
        let report = fixtures::report(found.map(|(id, ratio)| fixtures::hazard(id, ratio)).to_vec(), Vec::new());
        let failing: Vec<&str> = baseline.failing(&report).map(|hazard| hazard.id.as_str()).collect();
        assert_eq!(failing, ["H-000001", "H-000003"]);
    }
}
