//! Checks of what counts as unsafe in a cell file, and of how links touch.

use std::collections::BTreeSet;
use std::ops::Range;

use toml::Spanned;

use super::checker::Checker;
use super::format::{CellFile, ContactTable, Literal, OnOrClamping, OnOrMoving, SeparationTable, SpeedOrOff};
use crate::cell::CellError;
use crate::cell::error::nearest;
use crate::cell::workcell::{Clamping, Link};
use crate::fmi::number;
use crate::hazard::criterion::pressure::{LinkContact, Surface};
use crate::hazard::criterion::separation::{Separation, Stop};
use crate::hazard::{Criteria, Criterion};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// What counts as unsafe.
pub(super) struct Chosen {
    pub(super) criteria: Criteria,
    pub(super) clamping: Clamping,
    pub(super) separation: Option<Separation>,
}

impl Checker<'_> {
    /// What counts as unsafe.
    pub(super) fn criteria(&self, file: &CellFile) -> Option<Chosen> {
        let table = &file.criteria;
        let speed = Self::speed(file);
        let clamping = self.problems.keep(self.clamping(file));
        let moving = match &table.moving_contact {
            None => Some(None),
            Some(moving) => self.problems.keep(self.moving(moving)).map(Some).map(Option::flatten),
        };
        let separation = match &table.separation {
            None => Some(None),
            Some(separation) => self.problems.keep(self.separation(file, separation)).map(Some),
        };
        let (clamping, separation) = (clamping?, separation?);
        let criteria = Criteria {
            transient_force: speed,
            clamping: clamping.is_some(),
            pressure: table.pressure,
            moving_contact_m_s: moving?,
        };
        let any = criteria.transient_force.is_some()
            || criteria.clamping
            || criteria.pressure
            || criteria.moving_contact_m_s.is_some()
            || separation.is_some();
        let off = table.transient_force.as_ref().map_or(0..0, Spanned::span);
        self.problems.keep(self.that(any, off, || {
            ("nothing counts as unsafe".to_owned(), "choose at least one criterion, or leave [criteria] out".to_owned())
        }))?;
        Some(Chosen { criteria, clamping: clamping.unwrap_or_default(), separation })
    }

    /// By which speed forces count, if they do.
    fn speed(file: &CellFile) -> Option<Criterion> {
        match file.criteria.transient_force.as_ref().map_or(SpeedOrOff::Counts(true), |chosen| *chosen.get_ref()) {
            SpeedOrOff::Counts(counts) => counts.then(Criterion::default),
            SpeedOrOff::By(speed) => Some(speed),
        }
    }

    /// How far robots go on after a contact, if clamping counts.
    fn clamping(&self, file: &CellFile) -> Result<Option<Clamping>, Box<CellError>> {
        let Some(clamping) = &file.criteria.clamping else { return Ok(None) };
        let table = match clamping.get_ref() {
            OnOrClamping::Counts(counts) => return Ok(counts.then(Clamping::default)),
            OnOrClamping::With(table) => table,
        };
        let one = table.contact_signal.is_none() || table.travel_after_contact_m.is_none();
        self.that(one, clamping.span(), || {
            let message = "how far the robots go on after a contact is said twice".to_owned();
            (message, "keep `contact_signal`, by which it is found out, or `travel_after_contact_m`".to_owned())
        })?;
        if let Some(input) = &table.contact_signal {
            self.named_input(file, input, &clamping.span(), "the contact signal")?;
        }
        let stated_m = table.travel_after_contact_m.unwrap_or(0.0);
        self.within(stated_m, 0.0..=2.0, &clamping.span(), "travel_after_contact_m")?;
        Ok(Some(Clamping { stated_m, signal: table.contact_signal.clone() }))
    }

    fn moving(&self, moving: &Spanned<OnOrMoving>) -> Result<Option<f64>, Box<CellError>> {
        match *moving.get_ref() {
            OnOrMoving::Counts(counts) => Ok(counts.then_some(0.0)),
            OnOrMoving::With(table) => {
                self.within(table.faster_than_m_s, 0.0..=100.0, &moving.span(), "faster_than_m_s")?;
                Ok(Some(table.faster_than_m_s))
            }
        }
    }

    fn separation(&self, file: &CellFile, table: &Spanned<SeparationTable>) -> Result<Separation, Box<CellError>> {
        let (span, t) = (table.span(), table.get_ref());
        let stated = [t.reaction_s, t.stop_time_s, t.stop_distance_m];
        let stop = match (&t.stop, stated) {
            (Some(name), [None, None, None]) => {
                match file.sensors.iter().find(|sensor| sensor.name == *name) {
                    None => self.named_input(file, name, &span, "what stops the robots")?,
                    Some(sensor) => self.that(!sensor.kind.is_in_fmu(), span.clone(), || {
                        let message = format!("`{name}` is a sensor inside the FMU, and no input that could be set");
                        (message, "name the FMU input that stops the robots, or state how they stop".to_owned())
                    })?,
                }
                Stop::Measured(name.clone())
            }
            (None, [Some(reaction_s), Some(stop_time_s), Some(stop_distance_m)]) => {
                Stop::Stated { reaction_s, stop_time_s, stop_distance_m }
            }
            _ => {
                let message = "how the robots stop is not said, or said twice";
                let help = "give `stop`, the sensor or the FMU input that stops them, or all of `reaction_s`, `stop_time_s` and \
                            `stop_distance_m`";
                return Err(self.source.error(span, "in this table", message, Some(help.to_owned())));
            }
        };
        let approach_m_s = t.approach_m_s.unwrap_or(WALKING_SPEED_M_S);
        for (value, most, what) in [
            (t.intrusion_m, 10.0, "intrusion_m"),
            (t.person_uncertainty_m, 10.0, "person_uncertainty_m"),
            (t.robot_uncertainty_m, 10.0, "robot_uncertainty_m"),
            (approach_m_s, 10.0, "approach_m_s"),
            (t.reaction_s.unwrap_or(0.0), 60.0, "reaction_s"),
            (t.stop_time_s.unwrap_or(0.0), 60.0, "stop_time_s"),
            (t.stop_distance_m.unwrap_or(0.0), 60.0, "stop_distance_m"),
        ] {
            self.within(value, 0.0..=most, &span, what)?;
        }
        Ok(Separation {
            stop,
            intrusion_m: t.intrusion_m,
            person_uncertainty_m: t.person_uncertainty_m,
            robot_uncertainty_m: t.robot_uncertainty_m,
            approach_m_s,
        })
    }

    /// An FMU input that the file holds at a truth value.
    fn named_input(&self, file: &CellFile, name: &str, span: &Range<usize>, what: &str) -> Result<(), Box<CellError>> {
        match file.inputs.get(name).map(Spanned::get_ref) {
            Some(Literal::Bool(_)) => Ok(()),
            Some(Literal::Number(_)) => Err(self.source.error(
                span.clone(),
                "here",
                format!("`{name}` is a number, and {what} is true or false"),
                Some("name an FMU input that is Boolean".to_owned()),
            )),
            None => {
                let names = file.inputs.keys().map(String::as_str).chain(file.sensors.iter().map(|s| s.name.as_str()));
                let near =
                    nearest(name, names).map_or_else(String::new, |near| format!("did you mean `{near}`? Otherwise "));
                Err(self.source.error(
                    span.clone(),
                    "here",
                    format!(
                        "{what} is `{name}`, and no sensor is called so, nor is an FMU input of that name held here"
                    ),
                    Some(format!("{near}add it to [inputs] with the value that it has while nothing happens")),
                ))
            }
        }
    }

    fn within(
        &self,
        value: f64,
        range: std::ops::RangeInclusive<f64>,
        span: &Range<usize>,
        what: &str,
    ) -> Result<(), Box<CellError>> {
        self.that(range.contains(&value), span.clone(), || {
            let (least, most) = (number(*range.start()), number(*range.end()));
            (
                format!("{what} is {}", number(value)),
                format!("give a figure from {least} to {most}, in the unit of its name"),
            )
        })
    }

    /// What a link is like where it touches.
    pub(super) fn link_contact(&self, table: &Spanned<ContactTable>) -> Result<LinkContact, Box<CellError>> {
        let (span, t) = (table.span(), table.get_ref());
        let surface = match (t.radius_m, t.area_cm2) {
            (Some(radius), None) => {
                self.within(radius, 1e-4..=1.0, &span, "radius_m")?;
                Some(Surface::Radius(radius))
            }
            (None, Some(area)) => {
                self.within(area, 1e-3..=1e4, &span, "area_cm2")?;
                Some(Surface::Area(area * 1e-4))
            }
            (None, None) if t.padding_n_mm.is_some() => None,
            _ => {
                let message = "how small the link touches is not said, or said twice";
                let help = "give `radius_m`, of an edge or corner, or `area_cm2`, of a flat surface";
                return Err(self.source.error(span, "here", message, Some(help.to_owned())));
            }
        };
        let padding = t.padding_n_mm.unwrap_or(1.0);
        self.within(padding, 1e-3..=1e6, &span, "padding_n_mm")?;
        Ok(LinkContact { surface, padding_n_m: t.padding_n_mm.map(|padding| padding * 1e3) })
    }

    /// The same for all links of robots that say it for links by name, or for all.
    pub(super) fn link_contacts(&self, file: &CellFile, links: &mut [Link]) {
        for (number, robot) in file.robots.iter().enumerate() {
            let robot = robot.get_ref();
            let of_all = robot.contact.as_ref().and_then(|table| self.problems.keep(self.link_contact(table)));
            let mut named = BTreeSet::new();
            for link in links.iter_mut().filter(|link| link.robot == number) {
                let own = link.name.strip_prefix(&format!("{} ", robot.name)).unwrap_or(&link.name);
                let by_name = [own, link.name.as_str()].into_iter().find(|name| robot.contacts.contains_key(*name));
                if let Some(name) = by_name {
                    named.insert(name.to_owned());
                    let contact = self.problems.keep(self.link_contact(&robot.contacts[name]));
                    link.contact = contact.unwrap_or_default();
                } else if link.contact == LinkContact::default() {
                    link.contact = of_all.unwrap_or_default();
                }
            }
            for (name, table) in robot.contacts.iter().filter(|(name, _)| !named.contains(*name)) {
                let names: Vec<&str> = links.iter().filter(|l| l.robot == number).map(|l| l.name.as_str()).collect();
                let message = format!("the robot has no link `{name}`");
                let help = format!("its links are {}", names.join(", "));
                self.problems.tell(self.source.error(table.span(), "here", message, Some(help)));
            }
        }
        let used = links.iter().any(|link| link.contact.surface.is_some());
        if used && !file.criteria.pressure {
            self.warnings.borrow_mut().push(
                "links say how small they touch, and pressure does not count: add `pressure = true` to [criteria]"
                    .to_owned(),
            );
        }
    }
}
