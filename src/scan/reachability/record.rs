//! What was shown by runs of its own, as the ordinary record of a scan: hazards with where and when each begins, their causes,
//! and what is not known.

use std::collections::BTreeMap;

use super::walk_in::WalkIn;
use super::{AnalysisLimits, AnalysisResult};
use crate::hazard::{Finding, Group, Identity};
use crate::host::{self, PlantError};
use crate::human::action::ACTION_S;
use crate::record::begin::InitialConditionRecord;
use crate::record::hazard::{Hazard, Shortest};
use crate::record::model::{Headline, SCHEMA_VERSION, STANDARD_EDITION, ScanReport, Settings, Spent, Subject, Verdict};
use crate::record::reachability::{REACHABILITY, ReachabilityResult};
use crate::record::speeds::SpeedRecord;
use crate::scan::causes::causes;
use crate::scan::confirm::confirm;
use crate::scan::execution::ExecutionMode;
use crate::scan::hosting::StateChoice;
use crate::scan::minimise::minimise;
use crate::scan::prepare::Prepared;
use crate::scan::run::Scanned;
use crate::scan::settings::of_cell;
use crate::sequences::Merge;
use crate::sim::Coverage;
use crate::standards::tables::of_every_scan;

/// Hazards that a run of their own has shown.
#[derive(Debug, Default)]
pub(super) struct DemonstratedHazards(BTreeMap<Identity, DemonstratingRun>);

/// The worst of the runs that show a hazard.
#[derive(Debug)]
struct DemonstratingRun {
    finding: Finding,
    way: WalkIn,
    times: u64,
}

impl DemonstratedHazards {
    /// Takes in what a walk leads to.
    pub(crate) fn add(&mut self, finding: &Finding, way: &WalkIn, links: &[String]) {
        let new = || DemonstratingRun { finding: finding.clone(), way: way.clone(), times: 0 };
        let known = self.0.entry(Identity::of(finding, links)).or_insert_with(new);
        known.times += 1;
        if finding.contact.ratio() > known.finding.contact.ratio() {
            *known = DemonstratingRun { times: known.times, ..new() };
        }
    }
}

/// What came of it besides places.
#[derive(Debug)]
pub(super) struct Rest {
    /// Hazards.
    pub shown: DemonstratedHazards,
    /// What was seen.
    pub coverage: Coverage,
    /// What is told of speeds that are not those of the motion.
    pub speeds: Vec<SpeedRecord>,
    /// Different states of the FMU.
    pub states: usize,
    /// What the FMU did.
    pub did: host::FmuUsage,
}

impl Rest {
    /// Of nothing so far, with `sensors` sensors.
    pub(crate) fn new(sensors: usize) -> Self {
        Self {
            shown: DemonstratedHazards::default(),
            coverage: Coverage::new(sensors),
            speeds: Vec::new(),
            states: 0,
            did: host::FmuUsage::default(),
        }
    }
}

impl AnalysisResult {
    /// The ordinary record: its hazards are confirmed by fresh instances, their sequences shortened, and causes told.
    #[must_use]
    pub(crate) fn scanned(&self, prepared: &Prepared, effort: AnalysisLimits<'_>) -> Scanned {
        let (found, rest) = (&self.found, &self.rest);
        prepared.stop().finishing();
        let footing = ExecutionMode::asked(prepared, effort.state, Merge::Auto);
        let mut hazards: Vec<Hazard> =
            rest.shown.0.iter().map(|(identity, way)| hazard(prepared, footing, identity, way)).collect();
        hazards.sort_by(|a, b| b.ratio.total_cmp(&a.ratio).then_with(|| a.id.cmp(&b.id)));
        let rung = footing.rung(prepared);
        let causes = causes(prepared, rung, &hazards, None);
        let mut report = ScanReport {
            schema_version: SCHEMA_VERSION,
            tool: found.tool.clone(),
            verdict: found.verdict,
            headline: Headline::default(),
            // It is about none of the cell's beginnings.
            subject: Subject { beginning: None, ..prepared.subject.clone() },
            settings: settings(prepared, found),
            causes,
            warnings: warnings(found, &hazards),
            hazards,
            certificate: None,
            residual: None,
            coverage: rest.coverage.clone(),
            cycle: None,
            spent: Spent {
                iterations: 0,
                actions: 0,
                fmu_steps: found.spent.fmu_steps,
                fmu_states: rest.states,
                contact_checks: found.spent.boxes,
                arm_checks: found.spent.arm_checks,
            },
            speeds: rest.speeds.clone(),
            faults: Vec::new(),
            self_test: prepared.self_test.clone(),
            standard_edition: STANDARD_EDITION,
            tables: of_every_scan().collect(),
            obligations: found.obligations.clone(),
        };
        report.headline = found.headline(&report);
        Scanned { report, rung, effort: rest.did }
    }
}

fn settings(prepared: &Prepared, found: &ReachabilityResult) -> Settings {
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "an hour of actions at most")]
    let actions = (found.until_s / ACTION_S).ceil() as u32;
    Settings {
        strategy: REACHABILITY.to_owned(),
        posture_sweep: true,
        actions_per_sequence: actions,
        until_s: Some(found.until_s),
        presses: found.presses,
        floor_m: prepared.cell.floor.clone(),
        start_region_m: prepared.cell.start_region.clone(),
        ..of_cell(&prepared.cell)
    }
}

/// What the user should know.
fn warnings(found: &ReachabilityResult, hazards: &[Hazard]) -> Vec<String> {
    let mut all = found.warnings.clone();
    let unconfirmed = hazards.iter().filter(|hazard| hazard.confirmed != Some(true)).count();
    if unconfirmed > 0 {
        all.push(format!("{unconfirmed} hazards were not confirmed by another fresh run"));
    }
    if found.verdict == Verdict::HazardsFound {
        all.push("of each body region and robot link the worst that was tried is told; there may be others".to_owned());
    }
    all
}

/// The record of a hazard.
fn hazard(prepared: &Prepared, footing: ExecutionMode, identity: &Identity, shown: &DemonstratingRun) -> Hazard {
    let cell = &prepared.cell;
    let links: Vec<String> = cell.links.iter().map(|link| link.name.clone()).collect();
    let sensors: Vec<String> = cell.sensors.iter().map(|sensor| sensor.name.clone()).collect();
    let DemonstratingRun { finding, way, times } = shown;
    let mut group = Group {
        id: identity.id(),
        worst: finding.clone(),
        first_iteration: 0,
        times_found: *times,
        earliest_s: finding.time_s,
        shortest: finding.clone(),
        sequences: None,
    };
    let begins =
        InitialConditionRecord { xy_m: way.xy_m, heading_deg: way.heading_deg, begins_s: way.begins_s(cell.step_s) };
    let with = |group: &Group| Hazard { begins: Some(begins), ..Hazard::new(group, &links, &sensors, None) };
    let first = with(&group);
    // A run of its own has shown it there.
    let Ok(there) = prepared.of_hazard(&first) else { return first };
    let shortest = || -> Result<Finding, PlantError> {
        let mut simulation = there.simulation(StateChoice::Replay, false)?;
        minimise(&mut simulation, finding, identity, &links, |_| !there.stop().is_asked())
    };
    if finding.actions.len() > 1
        && let Ok(shortest) = shortest()
    {
        group.shortest = shortest;
    }
    let mut hazard = with(&group);
    let mut plain = footing.plain(&there);
    confirm(&there, &mut plain, &group, &mut hazard, &mut None);
    if hazard.shortest.confirmed != Some(true) {
        // The worst is sure, so it stands for both.
        group.shortest = group.worst.clone();
        hazard.shortest = Shortest { confirmed: hazard.confirmed, ..with(&group).shortest };
    }
    hazard
}
