//! Robots that heed different sensors are looked at one after the other, each with the sensors that it heeds: how they are told apart.

use super::alike::{Kind, Trial};
use super::{Looking, SEED};
use crate::host::PlantError;
use crate::obligations::{Assumption, Need, Point};
use crate::scan::footing::Footing;
use crate::scan::prepare::Prepared;
use crate::search::Rng;
use crate::sim::anywhere::machine::Part;

impl Looking<'_> {
    /// Something was tried out.
    fn tried(&mut self, need: Need, assumption: &Assumption, tried: &str) {
        let (cell, fmu) = (&self.prepared.cell, self.prepared.subject.fmu_digest());
        let point = Point::tried(assumption, tried, &cell.accepted, &fmu);
        self.said.push((need, point));
    }

    /// Robots that are looked at together, with the sensors that they heed; nothing if that cannot be known.
    pub(super) fn parts(
        &mut self,
        there: &Prepared,
        footing: Footing,
        kinds: &[Kind],
    ) -> Result<Option<Vec<Part>>, PlantError> {
        let cell = &there.cell;
        let all = Part { sensors: vec![true; cell.sensors.len()], links: vec![true; cell.links.len()].into() };
        let factors = cell.robots.len() > 1 && cell.sensors.len() > 1;
        if cell.pose.is_empty() && !factors {
            return Ok(Some(vec![all]));
        }
        let mut trial = Trial {
            plant: footing.plant(there),
            cell,
            binding: &there.binding,
            kinds,
            steps: self.steps(),
            rng: Rng::new(SEED),
            presses: self.found.presses.is_some_and(|presses| presses > 0),
            taken: 0,
        };
        if !cell.pose.is_empty() {
            match trial.are_people_alike() {
                Ok(true) => {
                    let tried = "the robots did the same with all people of whom the sensors report the same, in all runs in which \
                                 that was tried";
                    self.tried(Need::PeopleAlike, &Assumption::PeopleAlike, tried);
                }
                Err(error) if error.stopped => return Err(error),
                Ok(false) | Err(_) => {
                    self.open(
                        Need::PeopleAlike,
                        "what the robots do depends on where somebody is in more ways than its sensors report. Use start areas \
                         instead: [[human.start_area]] in the cell file",
                    );
                    return Ok(None);
                }
            }
        }
        let heeded = match factors.then(|| trial.heeded()) {
            Some(Ok(heeded)) => heeded,
            Some(Err(error)) if error.stopped => return Err(error),
            Some(Err(_)) | None => return Ok(Some(vec![all])),
        };
        self.found.spent.fmu_steps += trial.taken;
        let mut parts: Vec<Part> = Vec::new();
        for (robot, sensors) in heeded.iter().enumerate() {
            let links = cell.links.iter().map(|link| link.robot == robot);
            if let Some(part) = parts.iter_mut().find(|part| part.sensors == *sensors) {
                part.links = part.links.iter().zip(links).map(|(known, own)| *known || own).collect();
            } else {
                parts.push(Part { sensors: sensors.clone(), links: links.collect() });
            }
            for (sensor, _) in cell.sensors.iter().zip(sensors).filter(|(_, heeds)| !**heeds) {
                let (robot, sensor) = (cell.robots[robot].name.clone(), sensor.name.clone());
                let tried = "it did the same whatever that reported, in all runs in which it was tried";
                self.tried(Need::Heeds, &Assumption::RobotIgnoresSensor { robot, sensor }, tried);
            }
        }
        if parts.iter().all(|part| part.sensors.iter().all(|heeds| *heeds)) {
            return Ok(Some(vec![all]));
        }
        Ok(Some(parts))
    }
}
