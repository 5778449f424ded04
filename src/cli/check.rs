//! `fmi-hazard check`: everything that is wrong with a cell, at once, and a picture of it from above. Nothing is searched.

use std::path::PathBuf;

use schemars::JsonSchema;
use serde::Serialize;

use super::exit::{FMU_FAILED, Failure, NO_HAZARD, UNUSABLE};
use super::hosting::HostingArguments;
use super::output::{self, Format};
use crate::cell::CellError;
use crate::cell::error::Source;
use crate::cell::find::{Examined, Todo, examine};
use crate::cell::workcell::{StartArea, Workcell};
use crate::fmi::number;
use crate::human::ControlledBy;
use crate::record::speeds::SpeedRecord;
use crate::report::top_view;
use crate::scan::prepare::prepare_in;
use crate::scan::probe::{Probe, probe, run_s};
use crate::scan::speeds::Speeds;
use crate::scan::{Prepared, top_view_data};

#[derive(Debug, clap::Args)]
pub(super) struct Arguments {
    /// A cell file (.toml), or an FMU with a cell file beside it or inside it
    path: PathBuf,
    /// The cell file of an FMU that has none of its own
    #[arg(long)]
    cell: Option<PathBuf>,
    /// Where to write the picture (default: <cell file>.check.svg beside it)
    #[arg(long, value_name = "FILE")]
    svg: Option<PathBuf>,
    /// Read files only: the FMU is not run, and there is no picture
    #[arg(long, conflicts_with = "svg")]
    no_run: bool,
    /// How to print the result
    #[arg(long, value_enum, default_value_t)]
    format: Format,
    #[command(flatten)]
    hosting: HostingArguments,
}

/// What is printed as JSON.
#[derive(Default, Serialize, JsonSchema)]
#[schemars(rename = "Check")]
pub(super) struct CheckOutput {
    /// What keeps the cell from being scanned.
    problems: Vec<Problem>,
    /// What else there is to know.
    warnings: Vec<String>,
    /// What the FMU did, if it was run and did not fail.
    probe: Option<Probe>,
    /// Where the picture is, if the FMU was run.
    picture: Option<PathBuf>,
}

/// Something wrong with a cell.
#[derive(Serialize, JsonSchema)]
struct Problem {
    /// The cell file, or one that it extends.
    file: String,
    /// Its line.
    line: Option<usize>,
    /// What is wrong.
    message: String,
    /// What to do about it.
    help: Option<String>,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let Examined { source, problems, todo } = examine(&arguments.path, arguments.cell.as_deref())?;
    let file = source.name().to_owned();
    let mut all: Vec<Problem> = problems.iter().flat_map(|first| first.each()).map(told).collect();
    let left = |Todo { file, line, text }: &Todo| Problem {
        file: file.clone(),
        line: Some(*line),
        message: format!("still to be filled in: {text}"),
        help: Some("fill it in and remove the word TODO".to_owned()),
    };
    let left: Vec<Problem> = todo.iter().map(left).collect();
    if problems.is_some() || !left.is_empty() {
        if arguments.format == Format::Json {
            all.extend(left);
            output::json_of(&CheckOutput { problems: all, ..CheckOutput::default() })?;
            return Ok(UNUSABLE);
        }
        let count = all.len() + left.len();
        if let Some(error) = problems {
            output::failed(&Failure::from(error));
        }
        let line = |p: &Problem| format!("  {}:{}: {}\n", p.file, p.line.unwrap_or_default(), p.message);
        let lines: String = left.iter().map(line).collect();
        output::result(&format!("{lines}{file}: {count} problem{}\n", if count == 1 { "" } else { "s" }));
        return Ok(UNUSABLE);
    }
    if arguments.no_run {
        match arguments.format {
            Format::Json => output::json_of(&CheckOutput::default())?,
            Format::Table => output::result(&format!("{file}: nothing wrong; the FMU was not run\n")),
        }
        return Ok(NO_HAZARD);
    }
    let hosting = arguments.hosting.hosting()?;
    let prepared = prepare_in(&arguments.path, arguments.cell.as_deref(), &hosting)?;
    // Those of the first time; the starts of others are the same.
    let others = (1..prepared.cell.starts.len()).map(|number| prepared.beginning(number));
    let others = others.collect::<Result<Vec<_>, _>>()?;
    let (found, run_s) = (probe(&prepared), number(run_s(&prepared)));
    let drawn = top_view::render(&top_view_data::overview(&prepared, &others, found.as_ref().ok()));
    let picture = arguments.svg.clone().unwrap_or_else(|| {
        let beside = arguments.cell.as_ref().unwrap_or(&arguments.path);
        beside.with_extension("check.svg")
    });
    output::write_file(&picture, &drawn)?;
    let mut warnings = prepared.warnings();
    let mut lies = None;
    if let Ok(found) = &found {
        warnings.extend(found.warnings.iter().chain(&found.idle_sensors).cloned());
        let speeds = Speeds::new(&prepared.cell, &prepared.binding, &found.motion);
        lies = of_speeds(&source, &prepared, &speeds);
        warnings.extend(speeds.warnings);
        if found.fastest_m_s < 1e-3 && found.motion.moved.is_empty() {
            warnings.push(format!(
                "no robot moves in {run_s} s while nobody is detected: are all [inputs] as they should be?"
            ));
        }
    }
    match arguments.format {
        Format::Json => {
            let probe = found.as_ref().ok().cloned();
            let problems: Vec<Problem> = lies.iter().flat_map(|first| first.each()).map(told).collect();
            output::json_of(&CheckOutput { problems, warnings, probe, picture: Some(picture) })?;
            if lies.is_some() {
                return Ok(UNUSABLE);
            }
        }
        Format::Table => {
            output::result(&summary(&prepared, found.as_ref().ok()));
            warnings.iter().for_each(|warning| output::warning(warning));
            output::result(&format!("  picture   {}\n", picture.display()));
            if let Some(lies) = lies {
                let count = lies.each().count();
                let code = output::failed(&Failure::from(lies));
                output::result(&format!("{file}: {count} problem{}\n", if count == 1 { "" } else { "s" }));
                return Ok(code);
            }
            if found.is_ok() {
                let read = match warnings.len() {
                    0 => String::new(),
                    1 => " that keeps it from being scanned; 1 warning to read".to_owned(),
                    count => format!(" that keeps it from being scanned; {count} warnings to read"),
                };
                output::result(&format!("{file}: nothing wrong{read}\n"));
            }
        }
    }
    match found {
        Ok(_) => Ok(NO_HAZARD),
        Err(error) => {
            output::error(&format!("the FMU failed when it was run for {run_s} s: {error}"));
            Ok(FMU_FAILED)
        }
    }
}

/// Speeds that are not those of the motion, as mistakes of the cell file.
fn of_speeds(source: &Source, prepared: &Prepared, speeds: &Speeds) -> Option<Box<CellError>> {
    let problem = |(number, record): (usize, &SpeedRecord)| {
        let span = speeds.named_at(number, &prepared.cell).unwrap_or(0..0);
        *source.error(span, "named here", record.message(), Some(record.advice()))
    };
    let mut problems = speeds.records.iter().enumerate().map(problem);
    let first = problems.next()?;
    Some(first.and(problems))
}

fn told(error: &CellError) -> Problem {
    Problem {
        file: error.file().to_owned(),
        line: error.line(),
        message: error.message.clone(),
        help: error.help.clone(),
    }
}

/// What the cell is, one line a thing.
fn summary(prepared: &Prepared, found: Option<&Probe>) -> String {
    let cell = &prepared.cell;
    let mut lines: Vec<String> = prepared.extends().map(|file| format!("  extends   {file}")).collect();
    for fmu in prepared.fmus.iter() {
        let description = fmu.description();
        lines.push(format!(
            "  FMU       {} ({}, FMI {})",
            fmu.path().display(),
            description.model_name,
            description.fmi_version
        ));
    }
    for (number, robot) in cell.robots.iter().enumerate() {
        let shapes = cell.links.iter().filter(|link| link.robot == number).count();
        let joints = robot.kinematics.as_ref().map_or_else(
            || "poses from the FMU".to_owned(),
            |kinematics| format!("{} joints", kinematics.tree.joints.len()),
        );
        lines.push(format!(
            "  robot     {}: {joints}, {shapes} shapes, {:.1} kg moving ({})",
            robot.name, robot.moving_mass_kg, robot.mass_place
        ));
    }
    for sensor in &cell.sensors {
        let reaction = found.and_then(|found| found.reactions.iter().find(|reaction| reaction.input == sensor.name));
        let said =
            reaction.map_or_else(String::new, |reaction| format!("; {}", super::inspect::words(reaction, "m/s")));
        lines.push(format!("  sensor    {} ({} = person){said}", sensor.name, sensor.signal));
    }
    for control in &cell.controls {
        let who = match control.by {
            ControlledBy::Person if cell.second.is_some() => "either of the people, where a hand gets to it",
            ControlledBy::Person => "the person, where a hand gets to it",
            ControlledBy::Anyone => "a colleague, at any moment",
            ControlledBy::Nobody => "nobody, while the person is there",
        };
        lines.push(format!("  control   {}: {who}", control.name));
    }
    lines.extend(starts(cell));
    lines.push(format!(
        "            {} actions of 0.2 s, {:.2} m on foot at most",
        cell.search.actions,
        0.32 * f64::from(cell.search.actions)
    ));
    if let Some(found) = found {
        lines.extend(
            found.together.iter().map(|all| format!("  sensors   all together: {}", super::inspect::words(all, "m/s"))),
        );
        lines.extend(found.reported.iter().map(super::inspect::reported_words));
        let run_s = number(found.run_s);
        lines.push(format!("  moves     up to {:.2} m/s in {run_s} s while nobody is detected", found.fastest_m_s));
        lines.extend(super::inspect::shortened(found.run_s));
    }
    lines.join("\n") + "\n"
}

/// Where and when the person begins: one by one, or how many if there are start areas.
fn starts(cell: &Workcell) -> Vec<String> {
    let own = match cell.start_areas.is_empty() {
        true => cell.beginnings.len(),
        false => {
            let human = &cell.file().human.first;
            human.start.iter().chain(&human.other_starts).count()
        }
    };
    let mut lines: Vec<String> = Vec::new();
    for beginning in &cell.beginnings[..own.min(cell.beginnings.len())] {
        let [x, y] = beginning.start.xy_m();
        let after = beginning.begins_s(cell.step_s);
        let after = if after > 0.0 { format!(" {after:.2} s after the FMU") } else { String::new() };
        lines.push(format!("  person    starts at ({x:.2}, {y:.2}) m{after}"));
    }
    if let Some(second) = &cell.second {
        let [x, y] = second.start.xy_m();
        lines.push(format!("  person    {} starts at ({x:.2}, {y:.2}) m, beside {}", second.names[1], second.names[0]));
    }
    for StartArea { spacing_m, headings, places, left_out } in &cell.start_areas {
        let [s, h] = [*places, *headings].map(|count| if count == 1 { "" } else { "s" });
        let out = match left_out {
            0 => String::new(),
            1 => "; 1 more is left out: an obstacle is there".to_owned(),
            more => format!("; {more} more are left out: obstacles are there"),
        };
        let spacing = number(*spacing_m);
        lines.push(format!(
            "  person    starts at {places} place{s} of an area, {spacing} m apart, {headings} heading{h} each{out}"
        ));
    }
    if !cell.start_areas.is_empty() {
        let (starts, all) = (cell.starts.len(), cell.beginnings.len());
        let last = cell.beginnings.last().map_or(0.0, |last| last.begins_s(cell.step_s));
        lines.push(match all / starts.max(1) {
            1 => format!("            {all} beginnings"),
            times => format!(
                "            {starts} starts at {times} times, the last {last:.2} s after the FMU: {all} beginnings"
            ),
        });
    }
    lines
}
