//! Robots that heed different sensors are looked at one after the other, each with the sensors that it heeds: how they are told apart.

use super::super::accepted_for::fmu_digest;
use super::sensor_dependence::SensorDependence;
use super::trial_instants::{MOST, Moments, TrialStep};
use super::trials::{Kind, Trial};
use super::{AnalysisContext, SEED};
use crate::cell::Workcell;
use crate::host::{Plant, PlantError, Policy};
use crate::human::Presses;
use crate::obligations::{Assumption, Need, Point};
use crate::reachability::instants::RobotGroup;
use crate::scan::execution::ExecutionMode;
use crate::scan::prepare::Prepared;
use crate::search::Rng;

impl AnalysisContext<'_> {
    /// Something was tried out.
    pub(super) fn tried(&mut self, need: Need, assumption: &Assumption, tried: &str) {
        let (cell, fmu) = (&self.prepared.cell, fmu_digest(&self.prepared.subject));
        let point = Point::tried(assumption, tried, &cell.accepted, &fmu);
        self.say(need, point);
    }

    /// Robots that are looked at together, with the sensors that they heed; nothing if that cannot be known.
    pub(super) fn parts(
        &mut self,
        there: &Prepared,
        footing: ExecutionMode,
        kinds: &[Kind],
    ) -> Result<Option<Vec<RobotGroup>>, PlantError> {
        let cell = &there.cell;
        let all = RobotGroup { sensors: vec![true; cell.sensors.len()], links: vec![true; cell.links.len()].into() };
        let factors = cell.robots.len() > 1 && cell.sensors.len() > 1;
        if cell.pose.is_empty() && !factors {
            return Ok(Some(vec![all]));
        }
        let Some(nobody) = kinds.first() else { return Ok(Some(vec![all])) };
        let nobody = TrialStep { readings: nobody.readings.clone(), person: nobody.person(), pressed: Presses::NONE };
        let saves = matches!(footing.policy(there), Policy::States { max_checkpoints } if max_checkpoints >= MOST);
        let mut rng = Rng::new(SEED);
        let parts = (cell.as_ref(), there.binding.as_ref());
        let moments = match Moments::new(footing.plant(there), parts, nobody, (self.steps(), saves), &mut rng) {
            Ok(moments) => moments,
            Err(error) if error.stopped => return Err(error),
            // What failed is told by the search.
            Err(_) if cell.pose.is_empty() => return Ok(Some(vec![all])),
            Err(error) => {
                self.open(Need::PeopleAlike, format!("that could not be tried out: {error}"));
                return Ok(None);
            }
        };
        let mut trial = Trial {
            moments,
            cell,
            binding: &there.binding,
            kinds,
            steps: self.steps(),
            rng,
            presses: self.found.presses.is_some_and(|presses| presses > 0),
            runs: 0,
        };
        let outcome = self.tried_parts(&mut trial, factors, all);
        self.found.spent.fmu_steps += trial.moments.taken;
        outcome
    }

    /// The same, tried out.
    fn tried_parts<P: Plant>(
        &mut self,
        trial: &mut Trial<'_, P>,
        factors: bool,
        all: RobotGroup,
    ) -> Result<Option<Vec<RobotGroup>>, PlantError> {
        if !trial.cell.pose.is_empty() {
            match trial.are_people_alike() {
                Ok(true) => {
                    let tried = format!(
                        "they did so in {} runs that began {}, at random and with somebody else of whom the same is reported",
                        trial.runs,
                        trial.began()
                    );
                    self.tried(Need::PeopleAlike, &Assumption::PeopleAlike, &tried);
                }
                Err(error) if error.stopped => return Err(error),
                Err(error) => {
                    self.open(Need::PeopleAlike, format!("that could not be tried out: {error}"));
                    return Ok(None);
                }
                Ok(false) => {
                    self.open(
                        Need::PeopleAlike,
                        "what the robots do depends on where somebody is in more ways than its sensors report. Use start areas \
                         instead: [[human.start_area]] in the cell file",
                    );
                    return Ok(None);
                }
            }
        }
        match factors.then(|| trial.heeded()) {
            Some(Ok(heeded)) => Ok(Some(self.parts_of(trial.cell, &heeded, all))),
            Some(Err(error)) if error.stopped => Err(error),
            Some(Err(_)) | None => Ok(Some(vec![all])),
        }
    }

    /// Robots that heed the same sensors together; what was tried is told where that leaves something out.
    fn parts_of(&mut self, cell: &Workcell, heeded: &SensorDependence, all: RobotGroup) -> Vec<RobotGroup> {
        let mut parts: Vec<RobotGroup> = Vec::new();
        for (robot, sensors) in heeded.by_robot.iter().enumerate() {
            let links = cell.links.iter().map(|link| link.robot == robot);
            if let Some(part) = parts.iter_mut().find(|part| part.sensors == *sensors) {
                part.links = part.links.iter().zip(links).map(|(known, own)| *known || own).collect();
            } else {
                parts.push(RobotGroup { sensors: sensors.clone(), links: links.collect() });
            }
            let each = cell.sensors.iter().zip(sensors).zip(&heeded.tried);
            for ((sensor, _), tried) in each.filter(|((_, heeds), _)| !**heeds) {
                let (robot, sensor) = (cell.robots[robot].name.clone(), sensor.name.clone());
                self.tried(Need::Heeds, &Assumption::RobotIgnoresSensor { robot, sensor }, tried);
            }
        }
        if parts.iter().all(|part| part.sensors.iter().all(|heeds| *heeds)) { vec![all] } else { parts }
    }
}
