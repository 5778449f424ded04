//! `fmi-hazard scan`: search a cell for hazards.

use std::path::{Path, PathBuf};
use std::time::Instant;

use clap::Parser as _;

use super::events::Event;
use super::exit::{self, Failure};
use super::introduction::introduce;
use super::output::{self, Format};
use super::resume::{self, Command};
use super::run::{Run, file_name};
pub(super) use super::scan_arguments::Arguments;
use super::scan_arguments::From;
use super::{initial_conditions, reachability, results, stopping};
use crate::scan::Prepared;
use crate::scan::prepare::prepare_in;
use crate::scan::probe::wrong_polarities;
use crate::stop::Stop;

/// The arguments of a scan, alone.
#[derive(clap::Parser)]
#[command(no_binary_name = true)]
struct Alone {
    #[command(flatten)]
    arguments: Arguments,
    #[command(flatten)]
    verbosity: output::Verbosity,
}

/// The command: a scan, or the rest of one.
pub(super) fn command(arguments: &Arguments) -> Result<u8, Failure> {
    let Some(out) = &arguments.resume else {
        return run_as(arguments, Command::of_this_process(), false);
    };
    let command = Command::of_scan(out)?;
    let first = Alone::try_parse_from(&command.arguments).map_err(Failure::unusable)?;
    std::env::set_current_dir(&command.folder)
        .map_err(|e| Failure::unusable(format!("cannot go back to {}: {e}", command.folder.display())))?;
    output::note(&format!("   Resumed fmi-hazard scan {}", command.arguments.join(" ")));
    run_as(&first.arguments, Some(command), true)
}

/// A scan that nobody goes on with.
pub(super) fn run(arguments: &Arguments) -> Result<u8, Failure> {
    run_as(arguments, None, false)
}

fn run_as(arguments: &Arguments, command: Option<Command>, goes_on: bool) -> Result<u8, Failure> {
    let Some(path) = &arguments.path else { return Err(Failure::unusable("no cell is named")) };
    let cell_path = arguments.cell.as_deref().unwrap_or(path);
    let assessments = results::assessments(cell_path)?;
    output::phase(&format!("trying out {}", path.display()));
    // Nothing is lost before the search: until then Ctrl-C ends the program.
    let (stop, began) = (Stop::default(), Instant::now());
    let mut prepared = tried_out(arguments, path, &stop)?;
    prepared.warn(wrong_polarities(&prepared));
    let from = arguments.people_from(&prepared.cell);
    allowed(arguments, from)?;
    if from == From::Anywhere {
        let several = false;
        let run = Run { arguments, path, cell_path, assessments: &assessments, stop: &stop, began, goes_on, several };
        return reachability::run(&run, &prepared, command.as_ref());
    }
    let all = beginnings_of(arguments, &prepared)?;
    let several = all.len() > 1;
    // Before anything is told: whoever reads it may interrupt.
    stopping::by_signals(&stop);
    introduce(&prepared, arguments.state);
    let out = arguments.out.clone().unwrap_or_else(|| own_folder(arguments, &prepared));
    let cannot = |e: std::io::Error| Failure::unusable(format!("cannot write results to {}: {e}", out.display()));
    std::fs::create_dir_all(&out).map_err(cannot)?;
    reachability::forget(&out);
    output::event(&Event::Results { folder: out.display().to_string() });
    if let Some(command) = &command {
        command.write(&out)?;
    }
    let run = Run { arguments, path, cell_path, assessments: &assessments, stop: &stop, began, goes_on, several };
    let keeps = command.is_some();
    let baselines = all.iter().map(|prepared| run.baseline(prepared, prepared.subject.beginning.as_ref()));
    let baselines = baselines.collect::<Result<Vec<_>, _>>()?;
    let whole = if from == From::Both { reachability::first(&run, &prepared, &out, keeps)? } else { None };
    if whole == Some(exit::INTERRUPTED) {
        output::note(&format!(" Go on: fmi-hazard scan --resume {}", out.display()));
        return Ok(exit::INTERRUPTED);
    }
    let code = if several {
        run.all(&all, &baselines, &out, keeps)?
    } else {
        initial_conditions::forget(&out);
        if let Some(time) = run.time_left() {
            stop.within(time);
        }
        if whole.is_some() && arguments.format == Format::Table {
            output::result("\nFrom the cell's start");
        }
        run.one(&all[0], baselines[0].as_ref(), &out, keeps)?.code
    };
    if keeps {
        if stop.is_asked() {
            output::note(&format!(" Go on: fmi-hazard scan --resume {}", out.display()));
        } else {
            resume::finished(&out, false);
        }
    }
    Ok(together(whole, code))
}

/// Options that are not about the places people come from in this scan are refused.
fn allowed(arguments: &Arguments, from: From) -> Result<(), Failure> {
    let of_starts = arguments.of_starts().or_else(|| arguments.limit_of_starts());
    if let (From::Anywhere, Some(option)) = (from, of_starts) {
        return Err(Failure::unusable_with_help(
            format!("{option} is for scans from the cell's starts, and this one is from anywhere"),
            "leave it out, or add --from start",
        ));
    }
    if let (From::Start, Some(_)) = (from, arguments.until) {
        return Err(Failure::unusable_with_help(
            "--until is for scans from anywhere",
            "add --from anywhere; how long a scan from the cell's starts is says [search] actions in the cell file",
        ));
    }
    if let (From::Start | From::Both, Some(option)) = (from, arguments.of_anywhere()) {
        return Err(Failure::unusable_with_help(
            format!("{option} is for scans from anywhere alone"),
            "add --from anywhere",
        ));
    }
    Ok(())
}

/// The cell from each of the beginnings that are searched. All are looked at before any is searched: a wrong one is told at once.
fn beginnings_of(arguments: &Arguments, prepared: &Prepared) -> Result<Vec<Prepared>, Failure> {
    let all = match arguments.begin {
        Some(number) => vec![prepared.beginning(number as usize - 1)?],
        None => (0..prepared.cell.beginnings.len()).map(|b| prepared.beginning(b)).collect::<Result<_, _>>()?,
    };
    if all.len() > 1 && arguments.write_baseline {
        return Err(Failure::unusable_with_help(
            "a cell with several beginnings has a result for each of them, and no single baseline",
            "keep the whole folder with the results, and name it with --baseline",
        ));
    }
    Ok(all)
}

/// Where results go that the user names no folder for.
fn own_folder(arguments: &Arguments, prepared: &Prepared) -> PathBuf {
    let of_cell = Path::new("out").join(file_name(&prepared.cell.name));
    match arguments.begin.filter(|_| prepared.cell.beginnings.len() > 1) {
        Some(number) => of_cell.join(initial_conditions::folder(number as usize)),
        None => of_cell,
    }
}

/// The exit code of a scan from anywhere, if there was one, and from the beginnings. Nobody hit from one start says nothing against
/// somebody hit from elsewhere, or against what is not known of others.
const fn together(whole: Option<u8>, code: u8) -> u8 {
    match whole {
        Some(exit::HAZARDS) if code != exit::INTERRUPTED => exit::HAZARDS,
        Some(exit::INCONCLUSIVE) if code == exit::NO_HAZARD => exit::INCONCLUSIVE,
        _ => code,
    }
}

/// The cell with its FMU tried out, which is part of the time that is given.
fn tried_out(arguments: &Arguments, path: &Path, stop: &Stop) -> Result<Prepared, Failure> {
    let hosting = arguments.hosting.heeding(stop)?;
    let Some(time) = arguments.time() else {
        return Ok(prepare_in(path, arguments.cell.as_deref(), &hosting)?);
    };
    let began = Instant::now();
    stop.within(time);
    match prepare_in(path, arguments.cell.as_deref(), &hosting) {
        Err(error) if !(error.while_running() && stop.ends_search()) => Err(error.into()),
        Ok(prepared) if !stop.ends_search() => Ok(prepared),
        // What it says of the FMU then is about the time that it had.
        _ => Err(Failure::inconclusive(
            format!(
                "the time was over while the FMU was tried out: after {:.1} s of {} s nothing was searched yet",
                began.elapsed().as_secs_f64(),
                time.as_secs_f64()
            ),
            "give it more with --time. Each FMU is run some ten times first, for as long as a sequence takes where its steps are \
             quick; `fmi-hazard inspect --self-test` shows how long its steps take",
        )),
    }
}
