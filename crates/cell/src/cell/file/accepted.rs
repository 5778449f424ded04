//! What the cell file accepts (`[[accept]]`): each has to be about something that this cell has, for the FMU that it has.

use toml::Spanned;

use super::checker::Checker;
use super::format::{AcceptTable, Acceptable, CellFile};
use crate::cell::CellError;
use crate::cell::error::Source;
use crate::cell::sensor::Sensor;
use crate::cell::workcell::{Clamping, Control, Robot};
use crate::human::ControlledBy;
use crate::obligations::{Acceptance, Assumption, readings as named};

/// Longest time in which something is accepted to show, s.
const MOST_S: f64 = 60.0;

/// What acceptances may be about.
pub(super) struct Subjects<'a> {
    pub robots: &'a [Robot],
    pub sensors: &'a [Sensor],
    pub controls: &'a [Control],
    pub clamping: Option<&'a Clamping>,
    /// Whether the FMU is told where people are.
    pub has_pose: bool,
}

impl Checker<'_> {
    /// All of them; those with problems are left out.
    pub(super) fn accepted(&self, file: &CellFile, subjects: &Subjects<'_>) -> Vec<Acceptance> {
        let one = |table: &Spanned<AcceptTable>| self.problems.keep(self.acceptance(table, subjects));
        file.accepts.iter().filter_map(one).collect()
    }

    fn acceptance(&self, table: &Spanned<AcceptTable>, subjects: &Subjects<'_>) -> Result<Acceptance, Box<CellError>> {
        let AcceptTable { what, robot, sensor, at_most, within_s, readings, fmu: _, by, because } = table.get_ref();
        let refused =
            |message: String, help: &str| Err(self.source.error(table.span(), "here", message, Some(help.to_owned())));
        if by.trim().is_empty() || because.trim().is_empty() {
            return refused(
                "something is accepted by nobody, or for no reason".to_owned(),
                "say in `by` who accepts it, and in `because` why it holds",
            );
        }
        let wanted: &[&str] = match what {
            Acceptable::RobotIgnoresSensor => &["robot", "sensor"],
            Acceptable::SensorSeesAlike => &["sensor"],
            Acceptable::Presses => &["at_most"],
            Acceptable::MemoryShows | Acceptable::NearlyAlike => &["within_s"],
            Acceptable::ReadingsAlike => &["readings"],
            Acceptable::PeopleAlike | Acceptable::TravelAfterContact => &[],
        };
        let keys = [
            ("robot", robot.is_some()),
            ("sensor", sensor.is_some()),
            ("at_most", at_most.is_some()),
            ("within_s", within_s.is_some()),
            ("readings", readings.is_some()),
        ];
        for (key, there) in keys {
            match (wanted.contains(&key), there) {
                (true, false) => {
                    return refused(format!("`{key}` is missing"), "take the lines as the scan prints them");
                }
                (false, true) => {
                    return refused(format!("`{key}` says nothing here"), "take the lines as the scan prints them");
                }
                (true, true) | (false, false) => {}
            }
        }
        if within_s.is_some_and(|within_s| !(0.0..=MOST_S).contains(&within_s)) {
            return refused(
                format!("`within_s` is a time of up to {MOST_S} s"),
                "take the lines as the scan prints them",
            );
        }
        let names = (robot.clone().unwrap_or_default(), sensor.clone().unwrap_or_default());
        let numbers = (at_most.unwrap_or_default(), within_s.unwrap_or_default());
        let readings = readings.clone().unwrap_or_default();
        let (assumption, matches) = assumption(*what, names, (numbers, readings), subjects);
        if let Some(why_not) = matches {
            return refused(
                format!("`{}` matches nothing in this cell: {why_not}", assumption.name()),
                "mend the name, or remove it",
            );
        }
        Ok(Acceptance { assumption, by: by.clone(), because: because.clone() })
    }
}

/// What is accepted, and why it matches nothing, if it does not.
fn assumption(
    what: Acceptable,
    (robot, sensor): (String, String),
    ((at_most, within_s), readings): ((u32, f64), Vec<String>),
    subjects: &Subjects<'_>,
) -> (Assumption, Option<String>) {
    let Subjects { robots, sensors, controls, clamping, has_pose } = subjects;
    let no_robot = || (!robots.iter().any(|one| one.name == robot)).then(|| format!("there is no robot `{robot}`"));
    let no_sensor =
        || (!sensors.iter().any(|one| one.name == sensor)).then(|| format!("there is no sensor `{sensor}`"));
    match what {
        Acceptable::RobotIgnoresSensor => {
            let alone = || {
                (robots.len() < 2 || sensors.len() < 2)
                    .then(|| "with one robot, or one sensor, each is looked at with every sensor".to_owned())
            };
            let why_not = no_robot().or_else(no_sensor).or_else(alone);
            (Assumption::RobotIgnoresSensor { robot, sensor }, why_not)
        }
        Acceptable::PeopleAlike => {
            let why_not = (!has_pose).then(|| "the FMU is not told where people are ([pose])".to_owned());
            (Assumption::PeopleAlike, why_not)
        }
        Acceptable::SensorSeesAlike => {
            let outside = || {
                let inside = |one: &&Sensor| one.name == sensor && one.zone.is_in_fmu();
                (sensors.iter().filter(inside).count() == 0).then(|| format!("`{sensor}` is not inside the FMU"))
            };
            let why_not = no_sensor().or_else(outside);
            (Assumption::SensorSeesAlike { sensor }, why_not)
        }
        Acceptable::Presses => {
            let worked = controls.iter().any(|control| control.by != ControlledBy::Nobody);
            let why_not = (!worked).then(|| "there is no control that anybody works".to_owned());
            (Assumption::Presses { at_most }, why_not)
        }
        Acceptable::MemoryShows | Acceptable::NearlyAlike => {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "a minute at most")]
            let within_ms = (1000.0 * within_s).round() as u32;
            let why_not = sensors.is_empty().then(|| "there is no sensor".to_owned());
            let is_near = what == Acceptable::NearlyAlike;
            let assumption =
                if is_near { Assumption::NearlyAlike { within_ms } } else { Assumption::MemoryShows { within_ms } };
            (assumption, why_not)
        }
        Acceptable::ReadingsAlike => {
            let names: Vec<&str> = sensors.iter().map(|sensor| sensor.name.as_str()).collect();
            let other = readings.iter().find(|one| !named::is_of(one, &names));
            let why_not = if readings.is_empty() {
                Some("it names no readings".to_owned())
            } else {
                other.map(|one| format!("`{one}` is not of its sensors"))
            };
            (Assumption::ReadingsAlike { readings }, why_not)
        }
        Acceptable::TravelAfterContact => {
            let tried = clamping.is_some_and(|clamping| clamping.signal.is_some());
            let why_not =
                (!tried).then(|| "how far robots go on is not tried out (criteria.clamping.contact_signal)".to_owned());
            (Assumption::TravelAfterContact, why_not)
        }
    }
}

/// Whether all that a cell file accepts is about these FMUs.
///
/// # Errors
/// With the line that would be about them.
pub fn accepted_for(file: &CellFile, source: &Source, fmu: &str) -> Result<(), Box<CellError>> {
    let other = file.accepts.iter().map(|table| &table.get_ref().fmu).find(|named| named.get_ref() != fmu);
    let Some(named) = other else { return Ok(()) };
    let message = "this was accepted for another FMU than the one that the cell has";
    let help = format!("look again whether it holds for this one. If it does, write: fmu = \"{fmu}\"");
    Err(source.error(named.span(), "of another FMU", message, Some(help)))
}
