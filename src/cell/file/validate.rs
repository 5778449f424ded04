//! From the cell file to a [`Workcell`]: SI units, checked values, every mistake with its line and what to do.

use toml::de::{DeTable, DeValue};

use super::checker::Checker;
use super::format::{CellFile, FailOnTable, HumanTable, SearchTable, Sex, StartTable};
use crate::cell::CellError;
use crate::cell::error::{Problems, Source, meant};
use crate::cell::workcell::{Beginning, UnitFile, Workcell};
use crate::human::action::ACTION_S;
use crate::human::body::BodyError;
use crate::human::{Anthropometry, Body, Radii, Start};
use crate::standards::anthropometry::{Percentile, Sex as AnsurSex};

/// Latest that a person may begin, s.
const LATEST_S: f64 = 3600.0;

/// The baseline's file unless the cell names another.
pub const BASELINE: &str = "baseline.json";

/// Reads and checks a cell file.
///
/// # Errors
/// All mistakes together, each with its line.
pub fn validate(source: &Source) -> Result<Workcell, Box<CellError>> {
    check(source, parse(source)?)
}

/// Reads a cell file's tables.
///
/// # Errors
/// What is no TOML or of another type, and all unknown keys before it.
pub fn parse(source: &Source) -> Result<CellFile, Box<CellError>> {
    let unknown = Problems::default();
    let mut text = source.text().to_owned();
    loop {
        let error = match toml::from_str(&text) {
            Ok(file) => return unknown.take_or(file),
            Err(error) => error,
        };
        let problem = source.parse_error(&error);
        match without_unknown_key(&text, &error) {
            Some(rest) => text = rest,
            None => return Err(problem.and(unknown.take_or(()).err().map(|others| *others))),
        }
        unknown.tell(problem);
    }
}

/// `text` with the unknown key that is complained about put right if it is a slip, else blanked out; other places stay
/// where they are.
fn without_unknown_key(text: &str, error: &toml::de::Error) -> Option<String> {
    let span = error.span().filter(|_| error.message().starts_with("unknown field"))?;
    let (before, after) = (text.get(..span.start)?, text.get(span.end..)?);
    let room = span.len() + after.len() - after.trim_start_matches(' ').len();
    if let Some(meant) = meant(error.message()).filter(|meant| meant.len() <= room) {
        let mended = format!("{before}{meant:<room$}{}", &text[span.start + room..]);
        if DeTable::parse(&mended).is_ok() {
            return Some(mended);
        }
    }
    let end = value_of(DeTable::parse(text).ok()?.get_ref(), span.start).filter(|end| *end >= span.end)?;
    let line = before.rfind('\n').map_or(0, |newline| newline + 1);
    let (mut from, mut to) = (span.start, end);
    if !before[line..].trim().is_empty() {
        // In an inline table, where commas stand between.
        let rest = &text[end..];
        match (rest.trim_start().starts_with(','), before.trim_end().ends_with(',')) {
            (true, _) => to += rest.find(',')? + 1,
            (false, true) => from = before.rfind(',')?,
            (false, false) => {}
        }
    }
    let blank = text[from..to].chars().map(|c| if c == '\n' { "\n".to_owned() } else { " ".repeat(c.len_utf8()) });
    Some(format!("{}{}{}", &text[..from], blank.collect::<String>(), &text[to..]))
}

/// Where the value ends whose key begins at `key`.
fn value_of(table: &DeTable<'_>, key: usize) -> Option<usize> {
    table.iter().find_map(|(name, value)| {
        if name.span().start == key {
            return Some(value.span().end);
        }
        in_value(value.get_ref(), key)
    })
}

fn in_value(value: &DeValue<'_>, key: usize) -> Option<usize> {
    match value {
        DeValue::Table(table) => value_of(table, key),
        DeValue::Array(list) => list.iter().find_map(|item| in_value(item.get_ref(), key)),
        _ => None,
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
        let step = self.problems.keep(self.step(&file));
        let fmus = self.problems.keep(self.fmus(&file));
        let robots = self.robots(&file);
        let sensors = self.sensors(&file, step.map_or(0.02, |(step_s, _)| step_s));
        let (obstacles, obstacle_tables) = self.obstacles(&file);
        let beginnings = self.beginnings(&file.human, step.map_or(0.02, |(step_s, _)| step_s));
        let body = self.problems.keep(self.body(&file));
        let budget = self.problems.keep(self.search(&file.search));
        let baseline = self.problems.keep(self.baseline(&file.fail_on));
        let ((), ()) = (known?, budget?);
        let ((step_s, steps_per_action), (robots, links)) = (step?, robots);
        Some(Workcell {
            name: file.name.clone(),
            sha256: self.source.sha256(),
            fmus: fmus?,
            step_s,
            steps_per_action,
            robots,
            files: self.files.take(),
            warnings: self.warnings.take(),
            links,
            obstacles,
            obstacle_tables,
            sensors,
            pose: file.pose.keys().copied().collect(),
            start: beginnings.first()?.start,
            beginnings,
            beginning: 0,
            body: body?,
            search: file.search,
            baseline: baseline?,
            file,
        })
    }

    /// Every start at every time, the starts of one time together.
    fn beginnings(&self, human: &HumanTable, step_s: f64) -> Vec<Beginning> {
        let starts = std::iter::once(&human.start).chain(&human.other_starts);
        let starts = self.problems.keep_all(starts.map(|table| {
            let StartTable { xy_m: [x, y], heading_deg } = *table.get_ref();
            self.finite(&[x, y, heading_deg], &table.span(), "the start pose")?;
            Ok(Start::new(x, y, heading_deg))
        }));
        let times = &human.begins_s;
        let none = self.that(!times.get_ref().is_empty(), times.span(), || {
            ("human.begins_s is empty".to_owned(), "leave it out, or give [0, 1.5, 3]".to_owned())
        });
        let _ = self.problems.keep(none);
        let times = self.problems.keep_all(times.get_ref().iter().map(|&time| {
            self.that((0.0..=LATEST_S).contains(&time), times.span(), || {
                (format!("human.begins_s has {time}"), format!("use times from 0 to {LATEST_S} s"))
            })?;
            #[expect(
                clippy::cast_possible_truncation,
                clippy::cast_sign_loss,
                reason = "checked: an hour of small steps"
            )]
            Ok((time / step_s).round() as usize)
        }));
        let at = |&lead_in_steps: &usize| starts.iter().map(move |&start| Beginning { start, lead_in_steps });
        times.iter().flat_map(at).collect()
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
            (format!("time.step_s is {step}; contacts must be checked at least every 0.02 s"), help())
        })?;
        let count = (ACTION_S / step).round();
        self.that((count * step - ACTION_S).abs() < 1e-9 && count <= 1000.0, file.time.step_s.span(), || {
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
                _ => (h.start.span(), "bends of a person are between 0 and 90 degrees"),
            };
            self.source.error(span, "for this person", e.to_string(), Some(help.to_owned()))
        })
    }

    fn search(&self, s: &SearchTable) -> Result<(), Box<CellError>> {
        self.that(s.iterations > 0 && (1..=64).contains(&s.actions), self.source.table("search"), || {
            ("[search] needs iterations > 0 and actions from 1 to 64".to_owned(), "the paper uses 320 and 8".to_owned())
        })?;
        self.that((0.001..=0.05).contains(&s.reach_tolerance_m), self.source.table("search"), || {
            (format!("search.reach_tolerance_m is {}", s.reach_tolerance_m), "use 0.001 to 0.05 m".to_owned())
        })
    }
}
