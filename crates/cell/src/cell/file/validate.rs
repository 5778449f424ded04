//! From the cell file to a [`Workcell`]: SI units, checked values, every mistake with its line and what to do.

use std::sync::Arc;

use super::accepted::Subjects;
use super::checker::Checker;
use super::criteria::Chosen;
use super::format::{CellFile, FailOnTable, SearchTable};
use super::reading::read;
use super::starts::Starts;
use crate::cell::CellError;
use crate::cell::error::Source;
use crate::cell::workcell::{UnitFile, Workcell};
use crate::fmi::number;
use crate::human::action::ACTION_S;

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
pub(crate) fn check(source: &Source, file: CellFile) -> Result<Workcell, Box<CellError>> {
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
        let planes = sensors.iter().any(|sensor| sensor.zone.plane().is_some());
        let following = self.following(&file, &sensors, controls.len());
        let (following, follows) = following.map_or_else(Default::default, |(all, numbers)| (Some(all), numbers));
        let obstacles = self.obstacles(&file, (&controls, planes), &follows);
        if let Some(following) = &following {
            self.kept_ready(&file, following, obstacles.len());
        }
        obstacles.iter().filter_map(|obstacle| obstacle.opened_by).for_each(|number| controls[number].door = true);
        let human = &file.human.first;
        let body = self.problems.keep(self.body(&human.into()));
        let arm_speed = self.problems.keep(self.arm_speed(human));
        let repertoire = self.problems.keep(self.repertoire((&human.also, human.run_m_s.as_ref()), controls.len()));
        let may_hold = chosen.as_ref().is_none_or(|Chosen { criteria, separation, .. }| {
            !criteria.clamping && !criteria.pressure && separation.is_none()
        });
        let held = self.problems.keep(self.held(human.held_m.as_ref(), may_hold));
        let second = file.human.second.as_ref();
        let second = second.map(|table| self.second(table, &file, (&sensors, &controls), may_hold));
        let second = second.map(|second| self.problems.keep(second));
        let Starts { tables: starts, areas: start_areas } = self.starts(human, body.as_ref(), &obstacles);
        let beginnings = self.beginnings(human, &starts, step.map_or(0.02, |(step_s, _)| step_s));
        let floor = self.problems.keep(self.floor_polygon(human.floor_m.as_ref(), "human.floor_m"));
        let region = self.floor_polygon(human.start_region_m.as_ref(), "human.start_region_m");
        let region = self.problems.keep(region);
        let accepted = self.accepted(
            &file,
            &Subjects {
                robots: &robots,
                sensors: &sensors,
                controls: &controls,
                clamping: chosen.as_ref().map(|chosen| &chosen.clamping),
                has_pose: !file.pose.is_empty(),
            },
        );
        self.limits(&file);
        self.plausible_surroundings(&file);
        let budget = self.problems.keep(self.search(&file.search));
        let baseline = self.problems.keep(self.baseline(&file.fail_on));
        let ((), ()) = (known?, budget?);
        let ((step_s, steps_per_action), chosen) = (step?, chosen?);
        let second = match second {
            Some(second) => Some(second?),
            None => None,
        };
        let repertoire = match &second {
            Some(second) => repertoire?.beside(second.repertoire.clone()),
            None => repertoire?,
        };
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
            following: following?,
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
            from: human.from,
            start_region: region?,
            body: body?,
            arm_speed_m_s: arm_speed?,
            held_m: held?,
            repertoire,
            second,
            criteria: chosen.criteria,
            clamping: chosen.clamping,
            separation: chosen.separation,
            search: file.search,
            baseline: baseline?,
            accepted,
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

    fn search(&self, s: &SearchTable) -> Result<(), Box<CellError>> {
        self.that(s.iterations > 0 && (1..=64).contains(&s.actions), self.source.table("search"), || {
            ("[search] needs iterations > 0 and actions from 1 to 64".to_owned(), "the paper uses 320 and 8".to_owned())
        })?;
        self.that((0.001..=0.05).contains(&s.reach_tolerance_m), self.source.table("search"), || {
            (format!("search.reach_tolerance_m is {}", number(s.reach_tolerance_m)), "use 0.001 to 0.05 m".to_owned())
        })
    }
}
