//! Earlier scans that an argument names: reading them, finding a hazard in one, and preparing what they scanned again.

use std::path::{Path, PathBuf};

use super::exit::Failure;
use super::{initial_conditions, output};
use crate::cell::error::nearest;
use crate::cell::find::whole_text;
use crate::host::selftest::StateRestore;
use crate::record::hazard::Hazard;
use crate::record::model::{FileSubject, FmuSubject};
use crate::record::recorded::Recorded;
use crate::scan::prepare::prepare_unplaced;
use crate::scan::{Hosting, PrepareError, Prepared};

/// A recorded scan: its scan.json, or the folder with its results.
pub(super) fn read(path: &Path) -> Result<Recorded, Failure> {
    if initial_conditions::are_in(path) {
        let message = format!("{} holds a scan for each of the cell's beginnings", path.display());
        let first = path.join(initial_conditions::folder(1));
        return Err(Failure::unusable_with_help(message, format!("name one of them: {}", first.display())));
    }
    Recorded::read(path).map_err(|error| Failure::unusable_with_help(&error, error.help()))
}

/// The hazard `id` of a scan that was read from `path`; for the id of a cause, its worst.
pub(super) fn hazard<'a>(scan: &'a Recorded, id: &str, path: &Path) -> Result<&'a Hazard, Failure> {
    let worst = scan.causes.iter().find(|cause| cause.id == id).map_or(id, |cause| cause.worst.as_str());
    if let Some(hazard) = scan.hazards.iter().find(|hazard| hazard.id == worst) {
        return Ok(hazard);
    }
    let causes = scan.causes.iter().map(|cause| cause.id.as_str());
    let help = match nearest(id, causes.chain(scan.hazards.iter().map(|hazard| hazard.id.as_str()))) {
        Some(id) => format!("did you mean {id}?"),
        None => format!("it holds {} hazards; their ids stand in report.html and hazards.csv", scan.hazards.len()),
    };
    Err(Failure::unusable_with_help(format!("there is no hazard {id} in {}", path.display()), help))
}

/// The cell file of a scan with what it extends, as one text, if all of it is still where it was and as it was.
pub(super) fn cell_text(scan: &Recorded) -> Option<String> {
    let file = scan.cell_file().unwrap_or_else(|| scan.subject_path());
    let (source, text) = whole_text(&file)?;
    let known = |sha256: &String| scan.subject.files.iter().any(|file| file.sha256 == *sha256);
    let same = source.sha256() == scan.subject.cell_sha256 && source.bases().iter().all(|base| known(&base.sha256()));
    same.then_some(text)
}

/// Where what was scanned is now, if it is elsewhere.
#[derive(Clone, Debug, Default, clap::Args)]
pub(super) struct Elsewhere {
    /// The cell file, or an FMU with its cell, when it is no longer where the result says
    #[arg(long)]
    cell: Option<PathBuf>,
    /// The FMU, when it is no longer where the result or the cell file says
    #[arg(long)]
    fmu: Option<PathBuf>,
}

impl Elsewhere {
    /// The cell file that is named.
    pub(super) fn cell(&self) -> Option<&Path> {
        self.cell.as_deref()
    }
}

/// What was scanned, again: from where it was, or from where it is now, with the person where they began. Warns of what is not as it
/// was.
pub(super) fn prepare(scan: &mut Recorded, elsewhere: &Elsewhere, hosting: &Hosting) -> Result<Prepared, Failure> {
    let (path, cell_file) = (scan.subject_path(), scan.cell_file());
    let (path, cell_file) = match (elsewhere.cell.clone(), elsewhere.fmu.clone()) {
        (Some(cell), Some(fmu)) => (fmu, Some(cell)),
        // The FMU was named, and a cell file that need not name it.
        (Some(cell), None) if is_cell(&cell) && !is_cell(&path) && path.exists() => (path, Some(cell)),
        (Some(cell), None) => (cell, None),
        (None, Some(fmu)) if is_cell(&path) => (fmu, Some(path)),
        (None, Some(fmu)) => (fmu, cell_file),
        (None, None) => (path, cell_file),
    };
    let is_there = |file: &Path, option: &str| {
        if file.exists() {
            return Ok(());
        }
        let message = format!("what was scanned is not there: {} does not exist", file.display());
        Err(Failure::unusable_with_help(message, format!("say where it is now, with {option}")))
    };
    match &cell_file {
        Some(cell) => {
            is_there(cell, "--cell FILE")?;
            is_there(&path, "--fmu FILE")?;
        }
        None if is_cell(&path) => {
            is_there(&path, "--cell FILE")?;
            fmu_is_there(&path)?;
        }
        None => is_there(&path, "--fmu FILE, or --cell FILE with a cell file that names it")?,
    }
    let (prepared, free_start) = prepare_unplaced(&path, cell_file.as_deref(), hosting)?;
    match free_start {
        // It begins where the scan did.
        Ok(()) | Err(PrepareError::NoRoom(_) | PrepareError::DetectedAtTimes { .. }) => {}
        Err(error) => return Err(error.into()),
    }
    let prepared = as_begun(scan, prepared)?;
    let own = &scan.subject;
    if own.cell_sha256 != prepared.subject.cell_sha256 {
        output::warning("the cell file has changed since the scan");
    }
    // By what they hold: what lies elsewhere now is the same for that.
    let contents = |files: &[FileSubject]| files.iter().map(|file| file.sha256.clone()).collect::<Vec<_>>();
    if contents(&own.files) != contents(&prepared.subject.files) {
        output::warning(
            "a cell file that it extends, a robot description, a mesh or the system of FMUs has changed since the scan",
        );
    }
    let hashes = |fmus: &[FmuSubject]| fmus.iter().map(|fmu| fmu.sha256.clone()).collect::<Vec<_>>();
    if hashes(&own.fmus) != hashes(&prepared.subject.fmus) {
        output::warning("the FMU has changed since the scan");
    }
    Ok(prepared)
}

/// The cell with the beginning that the scan was about, and the body that the person had then. Where the cell has no such beginning any
/// more, or another person, hazards say themselves where they begin. From anywhere each does.
fn as_begun(scan: &mut Recorded, prepared: Prepared) -> Result<Prepared, Failure> {
    let recorded = scan.looks().and_then(|looks| looks.body);
    let other = recorded.filter(|body| *body != (&prepared.cell.body).into()).and_then(|body| body.body());
    if other.is_some() {
        output::warning(
            "the cell has a person with another body now: here they have the one that they had in the scan",
        );
    }
    if scan.is_from_anywhere() {
        return Ok(prepared.with_body(other));
    }
    let begins = scan.begins().unwrap_or_else(|| prepared.begins_at_once());
    match prepared.initial_condition_at(begins) {
        Some(number) if other.is_none() => return Ok(prepared.beginning(number)?),
        Some(_) => {}
        None => {
            output::warning(&format!("the cell has no such beginning any more: here people begin {}", begins.words()))
        }
    }
    scan.hazards.iter_mut().for_each(|hazard| hazard.begins = hazard.begins.or(Some(begins)));
    Ok(prepared.with_body(other))
}

fn is_cell(path: &Path) -> bool {
    path.extension().is_some_and(|extension| extension.eq_ignore_ascii_case("toml"))
}

/// Whether the FMU is there that a cell file names, if it names one; other mistakes are told when it is read.
fn fmu_is_there(cell: &Path) -> Result<(), Failure> {
    let table = whole_text(cell).and_then(|(_, text)| text.parse::<toml::Table>().ok());
    let named = table.as_ref().and_then(|table| table.get("fmu")?.as_str());
    let (message, what) = match (named, &table) {
        (Some(named), _) if cell.with_file_name(named).exists() => return Ok(()),
        (Some(named), _) => {
            let fmu = cell.with_file_name(named);
            (
                format!("the FMU is not there that {} names: {} does not exist", cell.display(), fmu.display()),
                "it is now",
            )
        }
        (None, Some(table)) if !table.contains_key("unit") => {
            (format!("{} does not say which FMU it describes", cell.display()), "that is")
        }
        _ => return Ok(()),
    };
    Err(Failure::unusable_with_help(message, format!("say where {what}, with --fmu FILE")))
}

/// What stands in the scan.json of an earlier scan.
pub(super) fn text_of(path: &Path) -> Result<String, Failure> {
    let file = if path.is_dir() { path.join("scan.json") } else { path.to_owned() };
    std::fs::read_to_string(&file).map_err(|e| Failure::unusable(format!("cannot read {}: {e}", file.display())))
}

/// The command that gives the same result, if the scan left it.
pub(super) fn reproduce(path: &Path) -> Option<String> {
    #[derive(serde::Deserialize)]
    struct Run {
        reproduce: String,
    }
    let run: Run = serde_json::from_str(&run_of(path)?).ok()?;
    Some(run.reproduce)
}

/// The run.json beside an earlier scan.
fn run_of(path: &Path) -> Option<String> {
    let folder = if path.is_dir() { Some(path) } else { path.parent() };
    std::fs::read_to_string(folder?.join("run.json")).ok()
}

/// The same, with states brought back as plainly as the scan in `path` did: it may have found out that the FMU needs that.
pub(super) fn as_plainly(mut prepared: Prepared, path: &Path) -> Prepared {
    #[derive(serde::Deserialize)]
    struct Run {
        states_by: StateRestore,
    }
    let run: Option<Run> = run_of(path).and_then(|text| serde_json::from_str(&text).ok());
    prepared.rung = run.map_or(prepared.rung, |run| run.states_by.max(prepared.rung));
    prepared
}
