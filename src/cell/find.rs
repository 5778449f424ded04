//! Where the cell of an FMU is looked for, and reading it.

use std::path::{Path, PathBuf};

use thiserror::Error;
use toml::Spanned;

use super::binding::{BoundUnit, bind};
use super::draft::TODO;
use super::error::display_name;
use super::error::{Problems, Source};
use super::format::CellFile;
use super::validate::{check, parse, validate};
use super::{CellError, Workcell};
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
}

/// Opens a cell file, or an FMU together with its cell.
///
/// For an FMU the cell is, in this order, `cell` if given; `<stem>.cell.toml` and then `cell.toml` beside it;
/// `extra/io.github.fmi-hazard/cell.toml` inside it.
///
/// # Errors
/// [`OpenError`], each with what to do.
pub fn open(path: &Path, cell: Option<&Path>) -> Result<OpenedCell, OpenError> {
    match located(path, cell)? {
        Located::Cell(cell) => open_cell(&cell),
        Located::Inside { cell, name, fmu } => with_fmu(&cell, &name, *fmu),
    }
}

/// A cell that may have mistakes.
pub struct Examined {
    /// Its text.
    pub source: Source,
    /// All that is wrong with it.
    pub problems: Option<Box<CellError>>,
    /// Lines that are still to be filled in, with what they say.
    pub todo: Vec<(usize, String)>,
}

/// Finds everything that is wrong with a cell file, or with the cell of an FMU, that can be told without running the FMU.
///
/// # Errors
/// When a file cannot be read at all.
pub fn examine(path: &Path, cell: Option<&Path>) -> Result<Examined, OpenError> {
    let (source, own) = match located(path, cell)? {
        Located::Cell(cell) => (Source::new(&display_name(&cell), &read(&cell)?).in_folder(folder_of(&cell)), None),
        Located::Inside { cell, name, fmu } => {
            (Source::new(&name, &read(&cell)?).in_folder(folder_of(&cell)), Some(*fmu))
        }
    };
    let lines = source.text().lines().enumerate().filter(|(_, line)| line.contains(TODO) && !line.contains("`# TODO`"));
    let todo = lines.map(|(number, line)| (number + 1, line.trim().to_owned())).collect();
    let problems = Problems::default();
    let Some(file) = problems.keep(parse(&source)) else {
        return Ok(Examined { problems: problems.take_or(()).err(), source, todo });
    };
    let mut fmus: Vec<(String, Fmu)> = own.map(|fmu| (String::new(), fmu)).into_iter().collect();
    let mut missing = false;
    if fmus.is_empty() {
        let units = file.units.iter().map(|unit| (unit.get_ref().name.clone(), unit.get_ref().fmu.clone()));
        for (name, path) in file.fmu.clone().map(|path| (String::new(), path)).into_iter().chain(units) {
            match problems.keep(named_fmu(&source, &path)) {
                Some(path) => fmus.push((name, Fmu::open(&path)?)),
                None => missing = true,
            }
        }
    }
    if fmus.is_empty() && !missing {
        let _ = problems.keep(Err::<(), _>(no_fmu(&source)));
    }
    if !missing && !fmus.is_empty() {
        let _ = problems.keep(bind(&file, &source, &bound(&fmus)));
    }
    let _ = problems.keep(check(&source, file));
    Ok(Examined { problems: problems.take_or(()).err(), source, todo })
}

/// The FMUs as the binder sees them.
#[must_use]
pub fn bound(fmus: &[(String, Fmu)]) -> Vec<BoundUnit<'_>> {
    let file = |fmu: &Fmu| fmu.path().file_name().map_or_else(String::new, |name| name.to_string_lossy().into_owned());
    fmus.iter().map(|(name, fmu)| BoundUnit { name, description: fmu.description(), file: file(fmu) }).collect()
}

/// Where a cell is.
enum Located {
    /// A cell file.
    Cell(PathBuf),
    /// A cell file without an FMU of its own: that FMU, and what the file is called.
    Inside { cell: PathBuf, name: String, fmu: Box<Fmu> },
}

fn located(path: &Path, cell: Option<&Path>) -> Result<Located, OpenError> {
    if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml")) {
        return Ok(Located::Cell(path.to_owned()));
    }
    let fmu = Box::new(Fmu::open(path)?);
    if let Some(cell) = cell {
        return Ok(Located::Inside { cell: cell.to_owned(), name: display_name(cell), fmu });
    }
    let beside = [path.with_extension("cell.toml"), path.with_file_name("cell.toml")];
    for candidate in &beside {
        if candidate.is_file() && names_this_fmu(candidate, path) {
            return Ok(Located::Inside { cell: candidate.clone(), name: display_name(candidate), fmu });
        }
    }
    let inside = format!("{EXTRA_FOLDER}/cell.toml");
    if let Some(file) = fmu.file(&inside) {
        let name = format!("{}!{inside}", path.display());
        return Ok(Located::Inside { cell: file, name, fmu });
    }
    let looked = beside.iter().map(|p| p.display().to_string()).chain([format!("{inside} inside the FMU")]);
    Err(OpenError::NoCell { fmu: path.to_owned(), looked: looked.collect::<Vec<_>>().join(", ") })
}

/// A cell file names no FMU and is not inside one.
fn no_fmu(source: &Source) -> Box<CellError> {
    let help = Some("add `fmu = \"your.fmu\"` at its top".to_owned());
    source.error(0..0, "in this file", "it does not say which FMU it describes", help)
}

/// The FMU that a cell file names at `named`.
fn named_fmu(source: &Source, named: &Spanned<String>) -> Result<PathBuf, Box<CellError>> {
    let path = source.folder().join(named.get_ref());
    if path.is_file() {
        return Ok(path);
    }
    let message = format!("the FMU {} does not exist", path.display());
    Err(source.error(named.span(), "named here", message, Some("the path is relative to the cell file".to_owned())))
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
        return Err(OpenError::Cell(no_fmu(&source)));
    }
    let problems = Problems::default();
    let mut fmus = Vec::with_capacity(cell.fmus.len());
    for unit in &cell.fmus {
        if let Some(path) = problems.keep(named_fmu(&source, &unit.path)) {
            fmus.push((unit.name.clone(), Fmu::open(&path)?));
        }
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
