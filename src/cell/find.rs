//! Where the cell of an FMU is looked for, and reading it.

use std::path::{Path, PathBuf};

use thiserror::Error;

use super::error::display_name;
use super::format::CellFile;
use super::validate::validate;
use super::{CellError, Workcell};
use crate::cell::error::{Problems, Source};
use crate::fmi::Fmu;

/// Folder inside an FMU that belongs to this tool (FMI 2.0.2 and later reserve `extra/` for such use).
pub const EXTRA_FOLDER: &str = "extra/io.github.fmi-hazard";

/// A cell with its FMU opened, not loaded.
pub struct OpenedCell {
    /// The validated cell.
    pub cell: Workcell,
    /// Its text, for messages about bindings.
    pub source: Source,
    /// The FMUs with their names; one without a name, or several.
    pub fmus: Vec<(String, Fmu)>,
    /// Where the cell was found, in words.
    pub found: String,
}

/// Why a cell could not be opened.
#[derive(Debug, Error, miette::Diagnostic)]
#[non_exhaustive]
pub enum OpenError {
    /// The cell file is wrong.
    #[error(transparent)]
    #[diagnostic(transparent)]
    Cell(#[from] Box<CellError>),
    /// The FMU could not be read.
    #[error(transparent)]
    Fmu(#[from] crate::fmi::Error),
    /// A file could not be read.
    #[error("cannot read {path}: {error}")]
    Read {
        /// The file.
        path: PathBuf,
        /// The system's reason.
        error: std::io::Error,
    },
    /// An FMU without a cell.
    #[error("{fmu} comes without a cell file, so neither the robot's shape nor the person's start is known")]
    #[diagnostic(help(
        "write a cell file and scan that: `fmi-hazard examples export DIR` gives complete examples, `fmi-hazard schema` \
         every key. Looked for: {looked}"
    ))]
    NoCell {
        /// The FMU.
        fmu: PathBuf,
        /// Places tried.
        looked: String,
    },
    /// A cell file that names no FMU and is not inside one.
    #[error("{cell} does not say which FMU it describes")]
    #[diagnostic(help("add `fmu = \"your.fmu\"` at its top"))]
    NoFmu {
        /// The cell file.
        cell: PathBuf,
    },
}

/// Opens a cell file, or an FMU together with its cell.
///
/// For an FMU the cell is, in this order, `cell` if given; `<stem>.cell.toml` and then `cell.toml` beside it;
/// `extra/io.github.fmi-hazard/cell.toml` inside it.
///
/// # Errors
/// [`OpenError`], each with what to do.
pub fn open(path: &Path, cell: Option<&Path>) -> Result<OpenedCell, OpenError> {
    let is_cell = path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml"));
    if is_cell {
        return open_cell(path);
    }
    let fmu = Fmu::open(path)?;
    if let Some(cell) = cell {
        return with_fmu(cell, &display_name(cell), fmu);
    }
    let beside = [path.with_extension("cell.toml"), path.with_file_name("cell.toml")];
    for candidate in &beside {
        if candidate.is_file() && names_this_fmu(candidate, path) {
            return with_fmu(candidate, &display_name(candidate), fmu);
        }
    }
    let inside = format!("{EXTRA_FOLDER}/cell.toml");
    if let Some(file) = fmu.file(&inside) {
        let name = format!("{}!{inside}", path.display());
        return with_fmu(&file, &name, fmu);
    }
    let looked = beside.iter().map(|p| p.display().to_string()).chain([format!("{inside} inside the FMU")]);
    Err(OpenError::NoCell { fmu: path.to_owned(), looked: looked.collect::<Vec<_>>().join(", ") })
}

/// Whether the cell file beside an FMU is about that FMU: it names it, or names none.
fn names_this_fmu(cell: &Path, fmu: &Path) -> bool {
    let Ok(text) = std::fs::read_to_string(cell) else { return false };
    // A file that cannot be parsed is taken: its error message helps more than a silent skip.
    let Ok(file) = toml::from_str::<CellFile>(&text) else { return true };
    // A FMI 3.0 export of the same model may lie beside it.
    let stem = |path: &Path| path.file_stem().map(|stem| stem.to_string_lossy().trim_end_matches("-fmi3").to_owned());
    file.units.is_empty() && file.fmu.is_none_or(|name| stem(Path::new(name.get_ref())) == stem(fmu))
}

fn read(path: &Path) -> Result<String, OpenError> {
    std::fs::read_to_string(path).map_err(|error| OpenError::Read { path: path.to_owned(), error })
}

fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}

fn open_cell(path: &Path) -> Result<OpenedCell, OpenError> {
    let source = Source::new(&display_name(path), &read(path)?).in_folder(folder_of(path));
    let cell = validate(&source)?;
    if cell.fmus.is_empty() {
        return Err(OpenError::NoFmu { cell: path.to_owned() });
    }
    let problems = Problems::default();
    let mut fmus = Vec::with_capacity(cell.fmus.len());
    for unit in &cell.fmus {
        let fmu_path = source.folder().join(unit.path.get_ref());
        if fmu_path.is_file() {
            fmus.push((unit.name.clone(), Fmu::open(&fmu_path)?));
            continue;
        }
        let message = format!("the FMU {} does not exist", fmu_path.display());
        let help = Some("the path is relative to the cell file".to_owned());
        let _ = problems.keep(Err::<(), _>(source.error(unit.path.span(), "named here", message, help)));
    }
    problems.take_or(())?;
    Ok(OpenedCell { found: display_name(path), cell, source, fmus })
}

fn with_fmu(path: &Path, name: &str, fmu: Fmu) -> Result<OpenedCell, OpenError> {
    let source = Source::new(name, &read(path)?).in_folder(folder_of(path));
    let cell = validate(&source)?;
    if let Some(unit) = cell.fmus.iter().find(|unit| !unit.name.is_empty()) {
        let message = "this cell couples several FMUs and cannot be used with one";
        let help = Some("give the cell file instead of the FMU".to_owned());
        return Err(OpenError::Cell(source.error(unit.path.span(), "one of them", message, help)));
    }
    Ok(OpenedCell { found: name.to_owned(), cell, source, fmus: vec![(String::new(), fmu)] })
}
