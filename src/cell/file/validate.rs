//! From the cell file to a [`Workcell`]: SI units, checked values, every mistake with its line and what to do.

use std::sync::Arc;

use super::checker::Checker;
use super::format::{CellFile, FailOnTable, HumanTable, SearchTable, Sex};
use super::obstacles::Obstacles;
use super::reading::read;
use super::starts::Starts;
use crate::cell::CellError;
use crate::cell::error::Source;
use crate::cell::workcell::{UnitFile, Workcell};
use crate::fmi::number;
use crate::human::action::ACTION_S;
use crate::human::body::BodyError;
use crate::human::{Ability, Anthropometry, Body, Radii, Repertoire};
use crate::standards::anthropometry::{Percentile, Sex as AnsurSex};
use crate::standards::iso_13855::WALKING_SPEED_M_S;

/// Most communication steps of an action: contacts are checked at each of them.
const MOST_STEPS: f64 = 1000.0;

/// The baseline's file unless the cell names another.
pub const BASELINE: &str = "baseline.json";

/// Reads and checks a cell file.
///
/// # Errors
/// All mistakes together, each with its line.
pub fn validate(source: &Source) -> Result<Workcell, Box<CellError>> {
    let mut read = read(source);
    let (file, problems) = (read.file.take(), read.problems.take());
    let checked = file.map(|file| read.counting(check(source, file))).transpose();
    match (checked, problems) {
        (Ok(Some(Some(cell))), None) => Ok(cell),
        (Err(others), first) => Err(others.and(first.map(|first| *first))),
        (Ok(_), Some(first)) => Err(first),
        (Ok(_), None) => Err(source.error(0..0, "in this file", "it cannot be read", None)),
    }
}

/// Checks what a cell file says.
///
/// # Errors
/// All mistakes together, each with its line.
pub fn check(source: &Source, file: CellFile) -> Result<Workcell, Box<CellError>> {
    let check = Checker::new(source);
    let cell = check.workcell(file);
    check.problems.take_or(cell).map(|cell| cell.expect("nothing is missing without a problem"))
}

impl Checker<'_> {
    /// The cell; nothing if there were problems that leave a gap.
    fn workcell(&self, file: CellFile) -> Option<Workcell> {
        let known = self.that(*file.schema.get_ref() == 1, file.schema.span(), || {
            (
                format!("cell format {} is not known to this version", file.schema.get_ref()),
                "this version reads `schema = 1`".to_owned(),
            )
        });
        let known = self.problems.keep(known);
        self.extends(&file);
        let step = self.problems.keep(self.step(&file));
        let fmus = self.problems.keep(self.fmus(&file));
        let (robots, mut links) = self.robots(&file);
        self.link_contacts(&file, &mut links);
        let chosen = self.criteria(&file);
        let (sensors, placings) = self.sensors(&file, step.map_or(0.02, |(step_s, _)| step_s));
        let mut controls = self.controls(&file, step.map_or(10, |(_, steps)| steps));
        let Obstacles { boxes: obstacles, tables: obstacle_tables, opened_by } =
            self.obstacles(&file, &controls, sensors.iter().any(|sensor| sensor.zone.plane().is_some()));
        opened_by.iter().flatten().for_each(|number| controls[*number].door = true);
        let body = self.problems.keep(self.body(&file));
        let arm_speed = self.problems.keep(self.arm_speed(&file.human));
        let repertoire = self.problems.keep(self.repertoire(&file.human, controls.len()));
        let Starts { tables: starts, areas: start_areas } = self.starts(&file.human, body.as_ref(), &obstacles);
        let beginnings = self.beginnings(&file.human, &starts, step.map_or(0.02, |(step_s, _)| step_s));
        let floor = self.problems.keep(self.floor_polygon(file.human.floor_m.as_ref(), "human.floor_m"));
        let region = self.floor_polygon(file.human.start_region_m.as_ref(), "human.start_region_m");
        let region = self.problems.keep(region);
        self.limits(&file);
        let budget = self.problems.keep(self.search(&file.search));
        let baseline = self.problems.keep(self.baseline(&file.fail_on));
        let ((), ()) = (known?, budget?);
        let ((step_s, steps_per_action), chosen) = (step?, chosen?);
        let search = SearchTable { criterion: chosen.criteria.speed(), ..file.search };
        Some(Workcell {
            name: file.name.clone(),
            sha256: self.source.sha256(),
            fmus: fmus?,
            step_s,
            steps_per_action,
            robots,
            files: self.files.take(),
            warnings: self.warnings.take(),
            travel_after_contact_m: vec![chosen.clamping.stated_m; links.len()],
            links,
            obstacles,
            obstacle_tables,
            opened_by,
            sensors,
            placings,
            controls,
            pose: file.pose.keys().copied().collect(),
            start: beginnings.first()?.start,
            beginnings,
            beginning: 0,
            starts,
            start_areas,
            floor: floor?,
            from: file.human.from,
            start_region: region?,
            body: body?,
            arm_speed_m_s: arm_speed?,
            repertoire: repertoire?,
            criteria: chosen.criteria,
            clamping: chosen.clamping,
            separation: chosen.separation,
            search,
            baseline: baseline?,
            file: Arc::new(file),
        })
    }

    /// What only files that extend others may say.
    fn extends(&self, file: &CellFile) {
        if let Some(named) = &file.extends {
            let message = "what it extends was not read";
            let help = Some("open it as a file: nothing is known of what is beside a text".to_owned());
            self.problems.tell(self.source.error(named.span(), "here", message, help));
        }
        let of_robots = file.robots.iter().flat_map(|robot| &robot.get_ref().remove);
        for (_, names) in file.remove.iter().chain(of_robots) {
            let message = "there is nothing that this could be removed from";
            let help = "`remove` is for files that extend another, and for robots that are in that one".to_owned();
            self.problems.tell(self.source.error(names.span(), "here", message, Some(help)));
        }
        self.files.note(self.source.bases().iter().map(|base| (base.path.as_path(), base.text.as_bytes())));
    }

    fn baseline(&self, table: &FailOnTable) -> Result<Option<String>, Box<CellError>> {
        match (&table.baseline, table.new_only) {
            (None, false) => Ok(None),
            (None, true) => Ok(Some(BASELINE.to_owned())),
            (Some(path), true) => Ok(Some(path.get_ref().clone())),
            (Some(path), false) => Err(self.source.error(
                path.span(),
                "never read",
                "a baseline is named, and every hazard makes a scan fail all the same",
                Some("add `new_only = true`, or leave the baseline out".to_owned()),
            )),
        }
    }

    fn step(&self, file: &CellFile) -> Result<(f64, usize), Box<CellError>> {
        let step = *file.time.step_s.get_ref();
        let help = || "use 0.02, 0.01 or 0.005".to_owned();
        self.that(step.is_finite() && step > 0.0 && step <= 0.02 + 1e-12, file.time.step_s.span(), || {
            (format!("time.step_s is {}; contacts must be checked at least every 0.02 s", number(step)), help())
        })?;
        let count = (ACTION_S / step).round();
        self.that(count <= MOST_STEPS, file.time.step_s.span(), || {
            let least = ACTION_S / MOST_STEPS;
            (
                format!("time.step_s is {}; an action of 0.2 s may have {MOST_STEPS} steps at most", number(step)),
                format!(
                    "use {least} or more, for instance 0.005: an FMU may take smaller steps of its own within each"
                ),
            )
        })?;
        self.that((count * step - ACTION_S).abs() < 1e-9, file.time.step_s.span(), || {
            (format!("time.step_s = {step} does not divide one action of 0.2 s"), help())
        })?;
        #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "checked: between 10 and 1000")]
        Ok((step, count as usize))
    }

    /// The FMUs that the file names.
    fn fmus(&self, file: &CellFile) -> Result<Vec<UnitFile>, Box<CellError>> {
        if let (Some(fmu), Some(unit)) = (&file.fmu, file.units.first()) {
            let message = "the cell names one FMU with `fmu` and others with `unit`";
            let help = Some(format!("make `{}` a unit as well, or remove it", fmu.get_ref()));
            return Err(self.source.error(unit.span(), "here", message, help));
        }
        for (i, unit) in file.units.iter().enumerate() {
            let name = &unit.get_ref().name;
            self.that(!name.is_empty() && !name.contains(':'), unit.span(), || {
                (format!("a unit is called `{name}`"), "give each unit a name without a colon".to_owned())
            })?;
            self.that(file.units[..i].iter().all(|u| u.get_ref().name != *name), unit.span(), || {
                (format!("two units are called `{name}`"), "give each unit its own name".to_owned())
            })?;
        }
        let only = file.fmu.iter().map(|path| UnitFile { name: String::new(), path: path.clone() });
        let units = file.units.iter().map(|u| u.get_ref());
        Ok(only.chain(units.map(|u| UnitFile { name: u.name.clone(), path: u.fmu.clone() })).collect())
    }

    fn arm_speed(&self, human: &HumanTable) -> Result<Option<f64>, Box<CellError>> {
        let Some(speed) = &human.arm_speed_m_s else { return Ok(None) };
        self.that((0.1..=10.0).contains(speed.get_ref()), speed.span(), || {
            let help = "use 0.1 to 10 m/s; safety distances are made with 2.0".to_owned();
            (format!("arm_speed_m_s is {}", number(*speed.get_ref())), help)
        })?;
        Ok(Some(*speed.get_ref()))
    }

    /// What the person does in a cell with so many controls.
    fn repertoire(&self, human: &HumanTable, controls: usize) -> Result<Repertoire, Box<CellError>> {
        let also = human.also.get_ref();
        let twice = also.iter().enumerate().find(|(i, ability)| also[..*i].contains(ability));
        self.that(twice.is_none(), human.also.span(), || {
            ("`also` names something twice".to_owned(), "name each once".to_owned())
        })?;
        let Some(speed) = &human.run_m_s else {
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

    fn body(&self, file: &CellFile) -> Result<Body, Box<CellError>> {
        let h = &file.human;
        let percentile = match h.percentile.get_ref() {
            5 => Percentile::P5,
            50 => Percentile::P50,
            95 => Percentile::P95,
            other => {
                let message = format!("body measures are known for percentiles 5, 50 and 95, not {other}");
                let help = Some("take the nearest; 5 and 95 show what size changes".to_owned());
                return Err(self.source.error(h.percentile.span(), "here", message, help));
            }
        };
        let sex = match h.sex {
            Sex::Woman => AnsurSex::Female,
            Sex::Man => AnsurSex::Male,
        };
        let measures = Anthropometry {
            sex,
            percentile,
            bend_forward_deg: h.bend_forward_deg,
            bend_lateral_deg: h.bend_lateral_deg,
            radii_m: h.radii_m.as_ref().map_or_else(Radii::default, |radii| *radii.get_ref()),
        };
        Body::new(&measures).map_err(|e| {
            let (span, help) = match (&e, &h.radii_m) {
                (BodyError::RadiusOutOfRange { .. }, Some(radii)) => (radii.span(), "radii are in m"),
                _ => (self.source.table("human"), "bends of a person are between 0 and 90 degrees"),
            };
            self.source.error(span, "for this person", e.to_string(), Some(help.to_owned()))
        })
    }

    fn search(&self, s: &SearchTable) -> Result<(), Box<CellError>> {
        self.that(s.iterations > 0 && (1..=64).contains(&s.actions), self.source.table("search"), || {
            ("[search] needs iterations > 0 and actions from 1 to 64".to_owned(), "the paper uses 320 and 8".to_owned())
        })?;
        self.that((0.001..=0.05).contains(&s.reach_tolerance_m), self.source.table("search"), || {
            (format!("search.reach_tolerance_m is {}", number(s.reach_tolerance_m)), "use 0.001 to 0.05 m".to_owned())
        })
    }
}
