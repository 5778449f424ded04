//! Whether sensors inside the FMU see the same people later as at the start, where they were asked of all of the floor: some are asked about
//! again at many moments. What came out the same was tried out, and is no more than that.

use super::{AnalysisContext, AnalysisEvent, EventSink};
use crate::host::{Hosted, PlantError};
use crate::obligations::{Assumption, Need};
use crate::reachability::internal_sensors::{InternalSensorMap as ToldPeople, InternalSensorProbe, StandingPose};

/// At so many moments they are asked again, besides the start, and of so many people.
const MOMENTS: usize = 12;
const PEOPLE: usize = 240;

/// What a sensor does otherwise than at the start, and what it does there.
const SEES: (&str, &str) = ("reports", "; at the start it does not");
const OVERLOOKS: (&str, &str) = ("does not report", "; at the start it does");
const LOSES: (&str, &str) =
    ("reports, and soon no longer reports,", " and stays there; at the start it is asked for as long");

impl AnalysisContext<'_> {
    /// Asks again, of somebody who comes when only `nobody` was there before, of whom nothing is reported. `false` if it was told to end.
    pub(super) fn asked_later(
        &mut self,
        asking: &mut InternalSensorProbe<'_, Hosted>,
        told: &ToldPeople,
        nobody: StandingPose,
        tell: &mut EventSink<'_>,
    ) -> Result<bool, PlantError> {
        let people = told.some(PEOPLE);
        let sensors: Vec<usize> = self.inside().collect();
        let mut differs = vec![false; self.prepared.cell.sensors.len()];
        let mut last_s = 0.0;
        for moment in 0..=MOMENTS {
            let steps = moment * self.steps().saturating_sub(asking.steps()) / MOMENTS;
            asking.after(steps, nobody)?;
            #[expect(clippy::cast_precision_loss, reason = "an hour of small steps at most")]
            let at_s = steps as f64 * self.prepared.cell.step_s;
            last_s = at_s;
            for (person, before) in &people {
                if tell(AnalysisEvent::Asked(1.0)).is_break() {
                    return Ok(false);
                }
                let reports = asking.reports(*person)?;
                for sensor in &sensors {
                    let of = |now: &Vec<bool>| now.get(*sensor).copied().unwrap_or_default();
                    let seen: Vec<bool> = reports.iter().map(of).collect();
                    let what = if seen.is_sorted() {
                        let now = seen.last().copied().unwrap_or_default();
                        (now != of(&before.to_vec())).then_some(if now { SEES } else { OVERLOOKS })
                    } else {
                        Some(LOSES)
                    };
                    if let Some(what) = what.filter(|_| !std::mem::replace(&mut differs[*sensor], true)) {
                        self.reports_other(*sensor, at_s, *person, what);
                    }
                }
            }
        }
        for sensor in sensors.into_iter().filter(|sensor| !differs[*sensor]) {
            let tried = format!(
                "asked again at {MOMENTS} moments until {last_s:.2} s of {} people, it reported of each what it does at the start",
                people.len()
            );
            let sensor = self.prepared.cell.sensors[sensor].name.clone();
            self.tried(Need::ReportsLater, &Assumption::SensorSeesAlike { sensor }, &tried);
        }
        Ok(true)
    }

    /// Sensors inside the FMU, by number.
    fn inside(&self) -> impl Iterator<Item = usize> + use<> {
        let sensors = self.prepared.cell.sensors.iter().enumerate();
        let inside = sensors.filter(|(_, sensor)| sensor.zone.is_in_fmu()).map(|(number, _)| number);
        inside.collect::<Vec<_>>().into_iter()
    }

    /// A sensor reports another thing of somebody than at the start.
    fn reports_other(
        &mut self,
        sensor: usize,
        at_s: f64,
        ([x, y], heading): StandingPose,
        (what, before): (&str, &str),
    ) {
        let name = &self.prepared.cell.sensors[sensor].name;
        let heading = heading.to_degrees();
        self.open(
            Need::ReportsLater,
            format!(
                "{name} {what} somebody who comes to ({x:.2}, {y:.2}) m after {at_s:.2} s and looks along {heading:.0} degrees{before}. A \
                 search from anywhere takes what it reports then for what it always reports"
            ),
        );
    }
}
