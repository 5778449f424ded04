//! Hazards that are known, tried again in a cell that was changed: from where and when they began then, and with the body that the
//! person had then, whatever the changed cell says of these. What is not met then is fixed only where the changed cell asks as much
//! as the scan did, and where something could have been met.

use std::cell::OnceCell;
use std::sync::Arc;

use super::hosting::StateChoice;
use super::prepare::Prepared;
use super::prepare_error::PrepareError;
use super::settings::{self, criteria};
use crate::cell::Workcell;
use crate::hazard::{Class, Finding, STANDSTILL_M_S};
use crate::host::PlantError;
use crate::human::{Action, Body};
use crate::record::begin::InitialConditionRecord;
use crate::record::hazard::Hazard;
use crate::record::narrower::Narrower;
use crate::record::recorded::Recorded;
use crate::record::scan_question::ScanQuestion;
use crate::report::verified::{Verified, VerifiedOutcome};
use crate::sim::replay::replay;
use crate::sim::simulation::Instant;

/// A changed cell, and what a scan of another knows.
pub(crate) struct Again<'a> {
    prepared: &'a Prepared,
    /// What the scan looked for; nothing if the cell file is the one that was scanned, in which all of it is the same.
    earlier: Option<ScanQuestion>,
    /// Where hazards begin that have no beginning of their own.
    begun: Result<CellAtCondition, VerifiedOutcome>,
}

/// A cell as the person begins at one place.
struct CellAtCondition {
    prepared: Prepared,
    /// What there is to see while the person stands there.
    rest: OnceCell<Result<Vec<Instant>, PlantError>>,
}

impl<'a> Again<'a> {
    /// Ready to try what `scan` knows.
    ///
    /// # Errors
    /// When the changed cell cannot be simulated from there, but for want of room.
    pub(crate) fn new(prepared: &'a Prepared, scan: &Recorded) -> Result<Self, PrepareError> {
        let same = scan.subject.is_cell(&prepared.subject.cell_sha256, &prepared.subject.files);
        let looks = scan.looks().map(|looks| ScanQuestion { begins: scan.begins(), ..looks });
        let not_recorded = || VerifiedOutcome::NotJudged { cause: Narrower::NotRecorded };
        let body = looks.as_ref().and_then(|looks| looks.body?.body());
        let actions = scan.hazards.iter().map(longest).max().unwrap_or_default();
        let begins = looks.as_ref().and_then(|looks| looks.begins);
        let begun = match (begins, body) {
            _ if scan.is_from_anywhere() => Err(not_recorded()),
            (Some(begins), Some(body)) => CellAtCondition::new(prepared, begins, Some(body), actions)?,
            // Of the same file what is not written down is the same.
            (begins, _) if same => {
                let begins = begins.unwrap_or_else(|| prepared.begins_at_once());
                CellAtCondition::new(prepared, begins, None, actions)?
            }
            _ => Err(not_recorded()),
        };
        Ok(Self { prepared, earlier: looks.filter(|_| !same), begun })
    }

    /// Runs the worst and the shortest sequence of a hazard from a fresh instance each, from where and when it begins.
    ///
    /// # Errors
    /// When the changed cell cannot be simulated from there, but for want of room.
    pub(crate) fn verify(&self, hazard: &Hazard) -> Result<Verified, PrepareError> {
        let outcome = match self.asks_less(hazard) {
            Some(cause) => VerifiedOutcome::NotJudged { cause },
            None => self.outcome(hazard)?,
        };
        Ok(Verified { hazard: hazard.clone(), outcome })
    }

    /// Why the changed cell may not tell the hazard though it is there.
    fn asks_less(&self, hazard: &Hazard) -> Option<Narrower> {
        let cell = &self.prepared.cell;
        let link = &hazard.robot_link;
        if hazard.class == Class::Pressure && cell.links_of_unknown_pressure().contains(&link.as_str()) {
            return Some(Narrower::Surface { link: link.clone() });
        }
        looks(cell).judges_less(self.earlier.as_ref()?, hazard)
    }

    fn outcome(&self, hazard: &Hazard) -> Result<VerifiedOutcome, PrepareError> {
        let own;
        let place = match (hazard.begins, &self.begun) {
            (None, Ok(begun)) => begun,
            (None, Err(outcome)) => return Ok(outcome.clone()),
            (Some(begins), _) => {
                let body = self.earlier.as_ref().and_then(|earlier| earlier.body?.body());
                if self.earlier.is_some() && body.is_none() {
                    return Ok(VerifiedOutcome::NotJudged { cause: Narrower::NotRecorded });
                }
                match CellAtCondition::new(self.prepared, begins, body, longest(hazard))? {
                    Ok(place) => own = place,
                    Err(outcome) => return Ok(outcome),
                }
                &own
            }
        };
        let sequences = [&hazard.actions, &hazard.shortest.actions];
        let different = if sequences[0] == sequences[1] { 1 } else { 2 };
        let mut worst: Option<Finding> = None;
        for actions in &sequences[..different] {
            match place.run(actions) {
                Err(error) => return Ok(VerifiedOutcome::NotRun { cause: error.message }),
                Ok(Some(found)) if worst.as_ref().is_none_or(|w| found.contact.ratio() > w.contact.ratio()) => {
                    worst = Some(found);
                }
                Ok(_) => {}
            }
        }
        let Some(found) = worst else {
            return Ok(place.shows_nothing(hazard, &self.saw(hazard, place)).unwrap_or(VerifiedOutcome::Fixed));
        };
        Ok(VerifiedOutcome::StillThere {
            ratio: found.contact.ratio(),
            force_n: found.contact.deciding_force_n(),
            body_region: found.contact.region.to_string(),
            robot_link: self.prepared.cell.links[found.contact.link].name.clone(),
            time_s: found.time_s,
        })
    }
}

impl Again<'_> {
    /// The sensors that reported somebody who stood there when the hazard was found.
    fn saw(&self, hazard: &Hazard, place: &CellAtCondition) -> Vec<String> {
        match &self.earlier {
            // The same zones.
            None => place.prepared.seen_at_start(),
            Some(earlier) if hazard.begins.is_none() => earlier.seen_at_start.clone(),
            // Who comes from anywhere begins where no zone is, and has no hands on anything.
            Some(_) => {
                let sensors = place.prepared.cell.sensors.iter();
                let hands = sensors.filter(|sensor| sensor.zone.is_post());
                hands.map(|sensor| sensor.name.clone()).collect()
            }
        }
    }
}

/// How many actions a hazard takes.
fn longest(hazard: &Hazard) -> usize {
    hazard.actions.len().max(hazard.shortest.actions.len())
}

impl CellAtCondition {
    /// The cell from there, for so many actions at least; or why nothing can be tried from there.
    fn new(
        prepared: &Prepared,
        begins: InitialConditionRecord,
        body: Option<Body>,
        actions: usize,
    ) -> Result<Result<Self, VerifiedOutcome>, PrepareError> {
        match prepared.prepared_at(begins, body, actions) {
            Ok(prepared) => Ok(Ok(Self { prepared, rest: OnceCell::new() })),
            Err(PrepareError::NoRoom(_)) => Ok(Err(VerifiedOutcome::NoRoom)),
            Err(PrepareError::DetectedAtTimes { sensor, .. }) => Ok(Err(VerifiedOutcome::Seen { sensor })),
            Err(error) => Err(error),
        }
    }

    fn run(&self, actions: &[Action]) -> Result<Option<Finding>, PlantError> {
        let Prepared { cell, binding, .. } = &self.prepared;
        replay(Arc::clone(cell), Arc::clone(binding), self.prepared.plant(StateChoice::Replay), actions, None)
    }

    /// Why it says nothing that nothing was met from there: a sensor that saw nobody there reports somebody who only stands there,
    /// or the robot does not move then. Where a control is worked that may be what is repaired.
    fn shows_nothing(&self, hazard: &Hazard, seen_before: &[String]) -> Option<VerifiedOutcome> {
        let rest = self.rest.get_or_init(|| {
            let mut simulation = self.prepared.simulation(StateChoice::Replay, false)?;
            let actions = vec![Action::REST; self.prepared.cell.search.actions as usize];
            Ok(simulation.watch(&actions, &[])?.instants)
        });
        let rest = match rest {
            Ok(rest) => rest,
            Err(error) => return Some(VerifiedOutcome::NotRun { cause: error.message.clone() }),
        };
        let cell = &self.prepared.cell;
        let rest = &rest[..rest.len().min(longest(hazard) * cell.steps_per_action + 1)];
        let reports = |sensor: usize| rest.iter().any(|instant| instant.readings[sensor]);
        let mut sensors = cell.sensors.iter().enumerate().filter(|(_, sensor)| !seen_before.contains(&sensor.name));
        if let Some((_, sensor)) = sensors.find(|(number, _)| reports(*number)) {
            return Some(VerifiedOutcome::Seen { sensor: sensor.name.clone() });
        }
        let link = cell.links.iter().find(|link| link.name == hazard.robot_link);
        let is_its = |robot: usize| link.is_none_or(|link| link.robot == robot);
        let moves = |instant: &Instant| {
            let mut speeds = cell.links.iter().zip(&instant.frame.speed_bounds);
            speeds.any(|(link, speed)| is_its(link.robot) && *speed > STANDSTILL_M_S)
        };
        // What is told before the first step is no motion.
        if !hazard.worked.is_empty() || rest.iter().skip(1).any(moves) {
            return None;
        }
        let robot = link.map_or_else(|| "the robot".to_owned(), |link| cell.robots[link.robot].name.clone());
        Some(VerifiedOutcome::Still { robot })
    }
}

/// What a scan of the cell would look for, but from where and how long.
fn looks(cell: &Workcell) -> ScanQuestion {
    ScanQuestion {
        speed_criterion: cell.criteria.speed(),
        criteria: criteria(cell),
        arm_speed_m_s: cell.arm_speed_m_s,
        held_m: cell.holds_m(),
        also: cell.repertoire.abilities().to_vec(),
        run_m_s: cell.repertoire.run_m_s(),
        second: settings::second(cell),
        controls: settings::controls(cell),
        actions_per_sequence: cell.search.actions,
        contact_check_interval_s: cell.step_s,
        reach_tolerance_m: cell.search.reach_tolerance_m,
        until_s: None,
        presses: None,
        begins: None,
        seen_at_start: Vec::new(),
        body: Some((&cell.body).into()),
        floor_m: None,
        start_region_m: None,
    }
}
