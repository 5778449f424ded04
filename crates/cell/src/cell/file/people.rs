//! Checks of who is in the cell: bodies, what people do, and what a second person needs of the rest of the file.

use std::ops::Range;

use toml::Spanned;

use super::checker::Checker;
use super::format::{CellFile, HumanTable, SecondTable};
use crate::cell::CellError;
use crate::cell::sensor::Sensor;
use crate::cell::workcell::{Control, SecondPerson};
use crate::fmi::number;
use crate::human::body::BodyError;
use crate::human::{Ability, Anthropometry, Body, Radii, Repertoire, Start};
use crate::standards::anthropometry::{Percentile, Sex};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// What the table of a person says of the body.
pub(super) struct BodyKeys<'a> {
    sex: Sex,
    percentile: &'a Spanned<u8>,
    bend_forward_deg: f64,
    bend_lateral_deg: f64,
    radii_m: Option<&'a Spanned<Radii>>,
    /// Where a mistake is shown; the table's head if that is not told.
    here: Option<Range<usize>>,
}

impl<'a> From<&'a HumanTable> for BodyKeys<'a> {
    fn from(table: &'a HumanTable) -> Self {
        Self {
            sex: table.sex,
            percentile: &table.percentile,
            bend_forward_deg: table.bend_forward_deg,
            bend_lateral_deg: table.bend_lateral_deg,
            radii_m: table.radii_m.as_ref(),
            here: None,
        }
    }
}

impl<'a> From<&'a SecondTable> for BodyKeys<'a> {
    fn from(table: &'a SecondTable) -> Self {
        Self {
            sex: table.sex,
            percentile: &table.percentile,
            bend_forward_deg: table.bend_forward_deg,
            bend_lateral_deg: table.bend_lateral_deg,
            radii_m: table.radii_m.as_ref(),
            here: Some(table.start.span()),
        }
    }
}

impl Checker<'_> {
    /// The body of a person.
    pub(super) fn body(&self, keys: &BodyKeys<'_>) -> Result<Body, Box<CellError>> {
        let percentile = match keys.percentile.get_ref() {
            5 => Percentile::P5,
            50 => Percentile::P50,
            95 => Percentile::P95,
            other => {
                let message = format!("body measures are known for percentiles 5, 50 and 95, not {other}");
                let help = Some("take the nearest; 5 and 95 show what size changes".to_owned());
                return Err(self.source.error(keys.percentile.span(), "here", message, help));
            }
        };
        let measures = Anthropometry {
            sex: keys.sex,
            percentile,
            bend_forward_deg: keys.bend_forward_deg,
            bend_lateral_deg: keys.bend_lateral_deg,
            radii_m: keys.radii_m.map_or_else(Radii::default, |radii| *radii.get_ref()),
        };
        Body::new(&measures).map_err(|e| {
            let (span, help) = match (&e, keys.radii_m) {
                (BodyError::RadiusOutOfRange { .. }, Some(radii)) => (radii.span(), "radii are in m"),
                _ => (
                    keys.here.clone().unwrap_or_else(|| self.source.table("human")),
                    "bends of a person are between 0 and 90 degrees",
                ),
            };
            self.source.error(span, "for this person", e.to_string(), Some(help.to_owned()))
        })
    }

    /// How fast hands move, if arms take their time.
    pub(super) fn arm_speed(&self, human: &HumanTable) -> Result<Option<f64>, Box<CellError>> {
        let Some(speed) = &human.arm_speed_m_s else { return Ok(None) };
        self.that((0.1..=10.0).contains(speed.get_ref()), speed.span(), || {
            let help = "use 0.1 to 10 m/s; safety distances are made with 2.0".to_owned();
            (format!("arm_speed_m_s is {}", number(*speed.get_ref())), help)
        })?;
        Ok(Some(*speed.get_ref()))
    }

    /// How far what a person holds reaches beyond the finger tips, m.
    pub(super) fn held(&self, held: Option<&Spanned<f64>>, allows: bool) -> Result<f64, Box<CellError>> {
        let Some(held) = held else { return Ok(0.0) };
        let here = || held.span();
        self.that((0.05..=1.0).contains(held.get_ref()), here(), || {
            let help = "use 0.05 to 1 m beyond the finger tips, or leave it out".to_owned();
            (format!("held_m is {}", number(*held.get_ref())), help)
        })?;
        self.that(allows, here(), || {
            let message = "what is held is not clamped as a hand is, has no skin, and is no part of a person: `held_m` says nothing of \
                           clamping, pressure and separation";
            (message.to_owned(), "leave `held_m` out, or these criteria, and scan once with each".to_owned())
        })?;
        Ok(*held.get_ref())
    }

    /// What a person does, as their table says it, in a cell with so many controls.
    pub(super) fn repertoire(
        &self,
        (abilities, run_m_s): (&Spanned<Vec<Ability>>, Option<&Spanned<f64>>),
        controls: usize,
    ) -> Result<Repertoire, Box<CellError>> {
        let also = abilities.get_ref();
        let twice = also.iter().enumerate().find(|(i, ability)| also[..*i].contains(ability));
        self.that(twice.is_none(), abilities.span(), || {
            ("`also` names something twice".to_owned(), "name each once".to_owned())
        })?;
        let Some(speed) = run_m_s else {
            return Ok(Repertoire::new(also, 2, controls));
        };
        self.that(also.contains(&Ability::Run), speed.span(), || {
            let help = "write `also = [\"run\"]` beside it, or leave it out".to_owned();
            ("`run_m_s` says how fast nobody runs".to_owned(), help)
        })?;
        let strides =
            (2..=Repertoire::FASTEST).find(|n| (f64::from(*n) * WALKING_SPEED_M_S - speed.get_ref()).abs() < 1e-9);
        self.that(strides.is_some(), speed.span(), || {
            let help = "use 3.2, 4.8 or 6.4 m/s: a whole multiple of the walking speed, 1.6 m/s".to_owned();
            (format!("run_m_s is {}", number(*speed.get_ref())), help)
        })?;
        Ok(Repertoire::new(also, strides.unwrap_or(2), controls))
    }

    /// A second person, in a cell with these sensors and controls.
    pub(super) fn second(
        &self,
        table: &SecondTable,
        file: &CellFile,
        (sensors, controls): (&[Sensor], &[Control]),
        may_hold: bool,
    ) -> Result<SecondPerson, Box<CellError>> {
        let here = || table.start.span();
        let plane = sensors.iter().find(|sensor| sensor.zone.plane().is_some());
        self.that(plane.is_none(), here(), || {
            let name = plane.map_or("", |sensor| &sensor.name);
            let help =
                "scan the cell for each person alone, or leave the plane out and say so where the result is used";
            let message = format!(
                "with two people, planes are not looked at: `{name}` is a light curtain, a door or a two-hand control"
            );
            (message, help.to_owned())
        })?;
        self.that(file.pose.is_empty(), here(), || {
            let help = "remove [pose], or scan the cell for each person alone".to_owned();
            ("with two people, the FMU cannot be told where the person is".to_owned(), help)
        })?;
        let door = controls.iter().find(|control| control.door);
        self.that(door.is_none(), here(), || {
            let name = door.map_or("", |control| &control.name);
            let help = "scan the cell for each person alone, or leave `opened_by` out".to_owned();
            (format!("with two people, doors with a leaf are not looked at: `{name}` opens one"), help)
        })?;
        let [x, y] = table.start.get_ref().xy_m;
        let heading_deg = table.start.get_ref().heading_deg;
        self.finite(&[x, y, heading_deg], &here(), "the start pose")?;
        let names = [&file.human.first.name, &table.name].map(|name| name.as_deref().map(str::trim));
        self.that(names.iter().all(|name| name.is_none_or(|name| !name.is_empty())), here(), || {
            ("a person has an empty name".to_owned(), "name each, or leave `name` out".to_owned())
        })?;
        let [first, second] = names;
        let names = [first.unwrap_or("first person").to_owned(), second.unwrap_or("second person").to_owned()];
        self.that(names[0] != names[1], here(), || {
            (format!("both people are called `{}`", names[0]), "give each a name of their own".to_owned())
        })?;
        Ok(SecondPerson {
            names,
            start: Start::new(x, y, heading_deg),
            body: self.body(&table.into())?,
            repertoire: self.repertoire((&table.also, table.run_m_s.as_ref()), 0)?,
            held_m: self.held(table.held_m.as_ref(), may_hold)?,
        })
    }
}
