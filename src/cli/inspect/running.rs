//! `fmi-hazard inspect --run`: what an FMU does when it is run: whether it moves, repeats itself and keeps its state, and which
//! inputs stop it, after how long and with which polarity.
//!
//! With a cell the speed is that of the fastest point of any robot; without one, that of the joints that are guessed, or of
//! whatever changes among the outputs.

use std::path::Path;

use serde::Serialize;

use super::Arguments;
use super::self_test::STEPS;
use crate::cell::binding::alone::Alone;
use crate::cell::draft::interface::Interface;
use crate::cell::draft::roles::{Guess, Role};
use crate::cell::error::OpenError;
use crate::cell::find::open;
use crate::cli::exit::{FMU_FAILED, Failure, NO_HAZARD};
use crate::cli::output::{self, Format};
use crate::cli::subject::Subject;
use crate::fmi::number;
use crate::host::isolation::{Examination, Isolated, Launcher, Unpacked, WorkerRestore, affordable, examine};
use crate::host::port::PortKind;
use crate::host::selftest::{SelfTest, Stage};
use crate::host::{Plant, PlantError, SystemSetup};
use crate::scan::prepare::prepare_in;
use crate::scan::probe::{Effect, Moment, ProbeRun, Prober, RUN_S, Reaction, Reported, probe_inputs};
use crate::scan::speeds::Speeds;
use crate::scan::{Hosting, PrepareError};

/// What may help an FMU that fails from the start.
const TRUST: &str = "`fmi-hazard inspect --self-test` tries it in parts; an FMU that needs files or a tool of this machine (Python, \
                     MATLAB, a licence) runs with --trust-fmu";

/// What is printed as JSON.
#[derive(Serialize)]
struct ProbeOutput {
    /// Whether a cell file said what is what.
    with_cell: bool,
    /// What speeds are measured in.
    unit: &'static str,
    /// The fastest that anything was while nobody was detected.
    fastest: f64,
    /// How long each run was, s.
    run_s: f64,
    /// Inputs that had to be set for anything to move.
    set: Vec<String>,
    reactions: Vec<Reaction>,
    /// Inputs that were left as they are: only those that are true or false are tried.
    not_tried: Vec<String>,
    /// What all sensors together do.
    #[serde(skip_serializing_if = "Option::is_none")]
    together: Option<Reaction>,
    /// What sensors inside the FMU report.
    reported: Vec<Reported>,
    warnings: Vec<String>,
    self_test: SelfTest,
}

pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    let hosting = arguments.hosting.hosting()?;
    let told = match open(&arguments.path, arguments.cell.as_deref()) {
        _ if arguments.fmu_only => of_fmu(&arguments.path, &hosting)?,
        Ok(_) => of_cell(arguments, &hosting)?,
        Err(OpenError::NoCell { .. }) => of_fmu(&arguments.path, &hosting)?,
        Err(error) => return Err(error.into()),
    };
    match arguments.format {
        Format::Json => output::json_of(&told)?,
        Format::Table => {
            output::result(&render(&told));
            told.warnings.iter().for_each(|warning| output::warning(warning));
        }
    }
    Ok(if told.self_test.repeatable() { NO_HAZARD } else { FMU_FAILED })
}

fn of_cell(arguments: &Arguments, hosting: &Hosting) -> Result<ProbeOutput, Failure> {
    let prepared = prepare_in(&arguments.path, arguments.cell.as_deref(), hosting)?;
    let found = probe_inputs(&prepared).map_err(failed)?;
    let speeds = Speeds::new(&prepared.cell, &prepared.binding, &found.motion).sentences();
    Ok(ProbeOutput {
        with_cell: true,
        unit: "m/s",
        fastest: found.fastest_m_s,
        run_s: found.run_s,
        set: Vec::new(),
        reactions: found.reactions.into_iter().chain(found.others).collect(),
        not_tried: found.not_tried,
        together: found.together,
        reported: found.reported,
        warnings: found.warnings.into_iter().chain(found.idle_sensors).chain(speeds).collect(),
        self_test: prepared.self_test,
    })
}

fn failed(error: PlantError) -> Failure {
    if error.not_loaded {
        Failure::unusable(error)
    } else {
        Failure::running_with_help(format!("the FMU failed: {error}"), TRUST)
    }
}

fn of_fmu(path: &Path, hosting: &Hosting) -> Result<ProbeOutput, Failure> {
    let Hosting::Workers { program, guard, limits } = hosting else {
        return Err(Failure::unusable_with_help(
            "an FMU without a cell file is run in worker processes only",
            "leave out --in-process",
        ));
    };
    let subject = Subject::open(path)?;
    let Interface { roles, .. } = subject.interface();
    let mut alone = subject.alone(None)?;
    subject.add_locals(&mut alone, &roles);
    let Alone { setup, inputs: names, outputs } = alone;
    let _ = setup.order().map_err(PrepareError::from)?;
    let unpacked = subject.fmus().into_iter().map(Unpacked::of).collect();
    let launcher = Launcher::new(program.clone(), unpacked, setup.clone(), *guard, limits.clone());
    let tested = affordable(&launcher, subject.steps(STEPS, setup.step_s));
    let Examination { result, launcher, .. } = examine(&launcher, tested, &[Stage::Serialize]).map_err(failed)?;
    let (columns, unit) = measured(&setup, &outputs, &roles);
    let (width, step_s) = (setup.outputs.len(), setup.step_s);
    let speeds = |rows: &[f64]| -> Vec<f64> {
        let rows: Vec<&[f64]> = rows.chunks(width).collect();
        rows.windows(2)
            .map(|pair| columns.iter().map(|c| c.speed(pair[0], pair[1], step_s)).fold(0.0, f64::max))
            .collect()
    };
    let plant = |inputs: &[f64]| {
        let setup = SystemSetup { initial_inputs: inputs.to_vec(), ..setup.clone() };
        Isolated::new(launcher.clone().with_setup(setup), WorkerRestore::Processes)
    };
    let run_s = subject.ends_s().map_or(RUN_S, |stop| RUN_S.min(stop));
    let prober = Prober::new(&plant, step_s, run_s, &speeds);
    let (inputs, idle, set) = moving(&prober, &setup, &names, &roles).map_err(failed)?;
    let mut not_tried = Vec::new();
    let mut reactions = Vec::new();
    for (column, input) in setup.inputs.iter().enumerate() {
        if input.port.kind == PortKind::Boolean {
            reactions
                .push(prober.reaction(&names[column], &inputs, (column, 1.0 - inputs[column]), &idle).map_err(failed)?);
        } else {
            not_tried.push(names[column].clone());
        }
    }
    let mut warnings = Vec::new();
    if !idle.moves() {
        warnings
            .push("nothing moves, whatever Boolean input is set: other inputs or parameters may have to be".to_owned());
    }
    Ok(ProbeOutput {
        with_cell: false,
        unit,
        fastest: idle.fastest(),
        run_s: prober.run_s(),
        set,
        reactions,
        not_tried,
        together: None,
        reported: Vec::new(),
        warnings,
        self_test: result,
    })
}

/// A column of the outputs that tells how fast something is.
enum Column {
    /// A speed.
    Speed(usize),
    /// What changes.
    Position(usize),
}

impl Column {
    fn speed(&self, before: &[f64], now: &[f64], step_s: f64) -> f64 {
        match *self {
            Self::Speed(column) => now[column].abs(),
            Self::Position(column) => ((now[column] - before[column]) / step_s).abs(),
        }
    }
}

/// The outputs that tell how fast the robot is: joint speeds, else joint angles or poses, else all.
fn measured(setup: &SystemSetup, names: &[String], roles: &[Guess]) -> (Vec<Column>, &'static str) {
    let find = |wanted: fn(&Role) -> bool| -> Vec<usize> {
        let found: Vec<&str> = roles.iter().filter(|g| wanted(&g.role)).map(|g| g.variable.as_str()).collect();
        (0..names.len()).filter(|&column| found.contains(&names[column].as_str())).collect()
    };
    let speeds = find(|role| matches!(role, Role::JointSpeed { .. }));
    if !speeds.is_empty() {
        return (speeds.into_iter().map(Column::Speed).collect(), "in the unit of its joint speeds");
    }
    let angles = find(|role| matches!(role, Role::JointAngle { .. } | Role::LinkPose { .. }));
    if !angles.is_empty() {
        return (angles.into_iter().map(Column::Position).collect(), "per s, of its joint angles or poses");
    }
    let real = setup.outputs.iter().enumerate().filter(|(_, output)| output.port.kind == PortKind::Real);
    (real.map(|(column, _)| Column::Position(column)).collect(), "per s, of any output")
}

/// Inputs with which something moves: as the FMU starts, or with what the names of its inputs promise, or with Boolean
/// inputs set all, or one by one. Also the run, and which inputs are not as they start.
fn moving<P: Plant>(
    prober: &Prober<'_, P>,
    setup: &SystemSetup,
    names: &[String],
    roles: &[Guess],
) -> Result<(Vec<f64>, ProbeRun, Vec<String>), PlantError> {
    let start = setup.initial_inputs.clone();
    let boolean = |column: &usize| setup.inputs[*column].port.kind == PortKind::Boolean;
    let columns: Vec<usize> = (0..setup.inputs.len()).filter(boolean).collect();
    let with = |of: &dyn Fn(usize) -> f64| {
        let mut row = start.clone();
        columns.iter().for_each(|&column| row[column] = of(column));
        row
    };
    let promised = |column: usize| {
        let guess = roles.iter().find(|guess| guess.variable == names[column]);
        match guess.map(|guess| &guess.role) {
            Some(Role::SensorInput { active: Some(active) }) => f64::from(u8::from(!active)),
            Some(Role::Constant) => 0.0,
            _ => start[column],
        }
    };
    let mut rows = vec![start.clone(), with(&promised), with(&|_| 1.0), with(&|_| 0.0)];
    rows.extend(
        columns.iter().map(|&one| with(&|column| if column == one { 1.0 - start[column] } else { start[column] })),
    );
    let mut first = None;
    for row in rows {
        let run = prober.run(&row, None)?;
        if run.moves() {
            let changed = columns.iter().filter(|&&column| row[column].to_bits() != start[column].to_bits());
            let set = changed.map(|&c| format!("{} = {}", names[c], row[c] != 0.0)).collect();
            return Ok((row, run, set));
        }
        first.get_or_insert((row, run));
    }
    let (row, run) = match first {
        Some(first) => first,
        None => (start.clone(), prober.run(&start, None)?),
    };
    Ok((row, run, Vec::new()))
}

/// Most inputs that are named because they were not tried.
const NAMED: usize = 12;

fn render(told: &ProbeOutput) -> String {
    let mut lines = vec![format!("  moves     {:.3} {} at most in {} s", told.fastest, told.unit, number(told.run_s))];
    lines.extend(shortened(told.run_s));
    if !told.set.is_empty() {
        lines.push(format!("  needs     {} to move", told.set.join(", ")));
    }
    for reaction in &told.reactions {
        lines.push(format!("  input     {} = {}: {}", reaction.input, !reaction.idle, words(reaction, "")));
        if let (Some(active), false) = (reaction.active(), told.with_cell) {
            lines.push(format!("            so active = {active} would mean a person, if it is a sensor"));
        }
    }
    if !told.not_tried.is_empty() {
        let (few, count) = (told.not_tried.iter().take(NAMED), told.not_tried.len());
        let more = if count > NAMED { format!(" and {} more", count - NAMED) } else { String::new() };
        let few: Vec<&str> = few.map(String::as_str).collect();
        lines.push(format!("  not tried {}{more}: only inputs that are true or false are", few.join(", ")));
    }
    lines.extend(told.together.iter().map(|all| format!("  inputs    all together: {}", words(all, ""))));
    lines.extend(told.reported.iter().map(reported_words));
    lines.push(format!("  repeats   {}", told.self_test.deterministic));
    lines.push(format!("  states    restored {}", told.self_test.restore));
    lines.join("\n") + "\n"
}

/// That runs are shorter than usual, and why.
pub(in crate::cli) fn shortened(run_s: f64) -> Option<String> {
    let shorter = run_s < RUN_S - 1e-9;
    shorter.then(|| {
        format!("  runs      of {} s instead of {RUN_S} s: none goes beyond the FMU's stopTime or has more than 50,000 steps", number(run_s))
    })
}

/// What an input does, in words.
pub(in crate::cli) fn words(reaction: &Reaction, unit: &str) -> String {
    let [before, after] = reaction.mean_speed;
    let begin = reaction.first_change_s.map_or_else(String::new, |s| format!(", first change after {s:.3} s"));
    let speeds = format!("{before:.2} to {after:.2} {unit}");
    let speeds = speeds.trim_end();
    let did = match reaction.effect {
        Effect::Stops => {
            let still = reaction.still_after_s.unwrap_or_default();
            format!("stops it, at rest after {still:.2} s{begin}")
        }
        Effect::Slows => format!("slows it, {speeds}{begin}"),
        Effect::Starts => format!("starts it, {speeds}{begin}"),
        Effect::SpeedsUp => format!("makes it faster, {speeds}{begin}"),
        Effect::Changes => format!("changes something, not how fast it is{begin}"),
        Effect::Nothing => "changes nothing".to_owned(),
    };
    let others: Vec<String> = reaction.at_other_moments.iter().map(moment_words).collect();
    if others.is_empty() { did } else { format!("at {:.2} s {did}; {}", reaction.at_s, others.join("; ")) }
}

fn moment_words(moment: &Moment) -> String {
    let did = match moment.effect {
        Effect::Stops => format!("stops it after {:.2} s", moment.still_after_s.unwrap_or_default()),
        Effect::Slows => "slows it".to_owned(),
        Effect::Starts => "starts it".to_owned(),
        Effect::SpeedsUp => "makes it faster".to_owned(),
        Effect::Changes => "changes something".to_owned(),
        Effect::Nothing => "changes nothing".to_owned(),
    };
    format!("at {:.2} s {did}", moment.at_s)
}

/// What a sensor inside the FMU did, as a line.
pub(in crate::cli) fn reported_words(sensor: &Reported) -> String {
    format!(
        "  sensor    {} inside the FMU: fires at {} of {} places of the person",
        sensor.sensor, sensor.at, sensor.of
    )
}
