//! Where the cell of an FMU is looked for, and reading it.

use std::path::{Path, PathBuf};

use toml::Spanned;

use super::binding::{BoundUnit, bind};
use super::draft::TODO;
use super::error::{OpenError, Problems, Source, display_name};
use super::file::extended::{alone, extended};
use super::file::layers::as_one;
use super::file::reading::read as read_tables;
use super::file::validate::{check, validate};
use super::foreign::ssp::{self, Wiring, is_ssp};
use super::{CellError, EXTRA_FOLDER, Workcell};
use crate::fmi::Fmu;

/// A cell with its FMU opened, not loaded.
pub struct OpenedCell {
    /// The validated cell.
    pub cell: Workcell,
    /// Its text, for messages about bindings.
    pub source: Source,
    /// The FMUs with their names; one without a name, or several.
    pub fmus: Vec<(String, Fmu)>,
    /// How they are connected, when they come as a system.
    pub wiring: Option<Wiring>,
    /// Where the cell was found, in words.
    pub found: String,
}

/// What a path to an FMU or a system gives.
struct Plants {
    fmus: Vec<(String, Fmu)>,
    wiring: Option<Wiring>,
    /// A cell file inside: what it is called, its text, and the folder that its files are in.
    inside: Option<(String, String, PathBuf)>,
}

impl Plants {
    fn open(path: &Path) -> Result<Self, OpenError> {
        if is_ssp(path) {
            let ssp::System { structure, source, fmus, sha256, cell: inside, archive } = ssp::open(path)?;
            let wiring = Some(Wiring { structure, source, path: path.to_owned(), sha256, archive });
            return Ok(Self { fmus, wiring, inside });
        }
        let fmu = Fmu::open(path)?;
        let own = format!("{EXTRA_FOLDER}/cell.toml");
        let inside = match fmu.file(&own) {
            Some(file) => Some((format!("{}!{own}", path.display()), read(&file)?, folder_of(&file).to_owned())),
            None => None,
        };
        Ok(Self { fmus: vec![(String::new(), fmu)], wiring: None, inside })
    }
}

/// Opens a cell file, or an FMU or a system of FMUs together with its cell.
///
/// For an FMU (or system) the cell is, in this order, `cell` if given; `<stem>.cell.toml` and then `cell.toml` beside it;
/// `extra/io.github.fmi-hazard/cell.toml` inside it.
///
/// # Errors
/// [`OpenError`], each with what to do.
pub fn open(path: &Path, cell: Option<&Path>) -> Result<OpenedCell, OpenError> {
    let Located { source, own, inside } = located(path, cell)?;
    let found = source.name().to_owned();
    let source = if inside { alone(source) } else { extended(source) }?;
    let cell = validate(&source)?;
    let Plants { fmus, wiring, .. } = match own {
        Some(own) => {
            if let Some(unit) = cell.fmus.iter().find(|unit| !unit.name.is_empty()) {
                let message = "this cell couples several FMUs and cannot be used with one";
                let help = Some("give the cell file instead of the FMU".to_owned());
                return Err(OpenError::Cell(source.error(unit.path.span(), "one of them", message, help)));
            }
            own
        }
        None => {
            if cell.fmus.is_empty() {
                return Err(OpenError::Cell(no_fmu(&source)));
            }
            let problems = Problems::default();
            let units = cell.fmus.iter().map(|unit| (unit.name.clone(), unit.path.clone()));
            let plants = named_plants(&source, units, &problems)?;
            problems.take_or(())?;
            plants
        }
    };
    Ok(OpenedCell { found, cell, source, fmus, wiring })
}

/// A cell that may have mistakes.
pub struct Examined {
    /// Its text.
    pub source: Source,
    /// All that is wrong with it.
    pub problems: Option<Box<CellError>>,
    /// Lines that are still to be filled in.
    pub todo: Vec<Todo>,
}

/// A line that is still to be filled in.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Todo {
    /// The cell file, or one that it extends, as messages call it.
    pub file: String,
    /// Its line, from 1.
    pub line: usize,
    /// What it says.
    pub text: String,
}

/// Finds everything that is wrong with a cell file, or with the cell of an FMU, that can be told without running the FMU.
///
/// # Errors
/// When a file cannot be read at all.
pub fn examine(path: &Path, cell: Option<&Path>) -> Result<Examined, OpenError> {
    let Located { source, own, inside } = located(path, cell)?;
    let problems = Problems::default();
    let source = match if inside { alone(source.clone()) } else { extended(source.clone()) } {
        Ok(source) => source,
        Err(problem) => {
            let problems = Some(problem);
            return Ok(Examined { todo: left_to_fill_in(&source, problems.as_deref()), problems, source });
        }
    };
    let mut tables = read_tables(&source);
    tables.problems.take().into_iter().for_each(|unread| problems.tell(unread));
    let Some(file) = tables.file.take() else {
        let problems = problems.take_or(()).err();
        return Ok(Examined { todo: left_to_fill_in(&source, problems.as_deref()), problems, source });
    };
    let named = file.units.len() + usize::from(file.fmu.is_some());
    let plants = match own {
        Some(own) => own,
        None => {
            let units = file.units.iter().map(|unit| (unit.get_ref().name.clone(), unit.get_ref().fmu.clone()));
            let only = file.fmu.clone().map(|path| (String::new(), path));
            named_plants(&source, only.into_iter().chain(units), &problems)?
        }
    };
    if plants.fmus.is_empty() && named == 0 {
        problems.tell(no_fmu(&source));
    }
    // With an FMU missing, names of its variables cannot be told from mistakes.
    if !plants.fmus.is_empty() && plants.fmus.len() >= named {
        let units = BoundUnit::all(plants.fmus.iter().map(|(name, fmu)| (name, fmu)));
        let _ = problems.keep(tables.counting(bind(&file, &source, &units, plants.wiring.as_ref())));
    }
    let _ = problems.keep(tables.counting(check(&source, file)));
    let problems = problems.take_or(()).err();
    Ok(Examined { todo: left_to_fill_in(&source, problems.as_deref()), problems, source })
}

/// The lines that are still to be filled in, with what they say, except for those of which a problem tells that something is
/// missing there: that names the line's key, in the same table.
fn left_to_fill_in(source: &Source, problems: Option<&CellError>) -> Vec<Todo> {
    let bases = source.bases().iter().map(|base| (base.name.as_str(), base.text.as_str()));
    let files = std::iter::once((source.name(), source.text())).chain(bases);
    files.flat_map(|(name, text)| left_in(name, text, problems)).collect()
}

/// The same of one file.
fn left_in(file: &str, text: &str, problems: Option<&CellError>) -> Vec<Todo> {
    let lines: Vec<&str> = text.lines().collect();
    let is_header = |line: &&str| line.starts_with('[');
    let mut told = vec![false; lines.len()];
    for problem in problems.into_iter().flat_map(CellError::each).filter(|problem| problem.file() == file) {
        let Some(at) = problem.line().map(|line| line - 1).filter(|at| *at < lines.len()) else { continue };
        let words = format!("{} {}", problem.message, problem.help.as_deref().unwrap_or_default());
        let own = lines[..=at].iter().rev().find(|line| is_header(line));
        // Until the next table of its kind.
        let end = lines[at + 1..].iter().position(|line| is_header(line) && own == Some(line));
        let end = end.map_or(lines.len(), |end| at + 1 + end);
        let asks = |line: &usize| lines[*line].contains(TODO) && names(lines[*line], &words) && !told[*line];
        if let Some(line) = (at..end).find(asks) {
            told[line] = true;
        }
    }
    let left = lines.iter().zip(told).enumerate().filter(|(_, (line, told))| line.contains(TODO) && !told);
    left.map(|(number, (line, _))| Todo { file: file.to_owned(), line: number + 1, text: line.trim().to_owned() })
        .collect()
}

/// Whether a problem in `words` is about the key that a line has commented out.
fn names(line: &str, words: &str) -> bool {
    let Some(comment) = line.trim().strip_prefix('#') else { return false };
    let key = comment.split_once('=').map_or("", |(key, _)| key.trim());
    let word = |key: &str| words.split(|c: char| !c.is_alphanumeric() && c != '_').any(|word| word == key);
    // The shapes of a robot's parts are tables of their own.
    if key.is_empty() { comment.contains("capsule") && word("capsule") } else { word(key) }
}

/// Where a cell was found.
struct Located {
    /// The cell file, without those that it extends.
    source: Source,
    /// The FMUs, if it was they that were named.
    own: Option<Plants>,
    /// Whether it is inside an FMU or a system.
    inside: bool,
}

/// The cell file, and the FMUs if it was they that were named.
fn located(path: &Path, cell: Option<&Path>) -> Result<Located, OpenError> {
    let file = |cell: &Path| -> Result<Source, OpenError> {
        Ok(Source::new(&display_name(cell), &read(cell)?).in_folder(folder_of(cell)))
    };
    if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("toml")) {
        return Ok(Located { source: file(path)?, own: None, inside: false });
    }
    let mut plants = Plants::open(path)?;
    if let Some(cell) = cell {
        return Ok(Located { source: file(cell)?, own: Some(plants), inside: false });
    }
    let beside = [path.with_extension("cell.toml"), path.with_file_name("cell.toml")];
    for candidate in &beside {
        if candidate.is_file() && names_this_fmu(candidate, path) {
            return Ok(Located { source: file(candidate)?, own: Some(plants), inside: false });
        }
    }
    if let Some((name, text, folder)) = plants.inside.take() {
        let source = Source::new(&name, &text).in_folder(&folder);
        return Ok(Located { source, own: Some(plants), inside: true });
    }
    let inside = format!("{EXTRA_FOLDER}/cell.toml inside it");
    let looked = beside.iter().map(|p| p.display().to_string()).chain([inside]);
    Err(OpenError::NoCell { fmu: path.to_owned(), looked: looked.collect::<Vec<_>>().join(", ") })
}

/// The FMUs, or the system, that a cell file names. Those that are not there are among `problems`.
fn named_plants(
    source: &Source,
    units: impl Iterator<Item = (String, Spanned<String>)>,
    problems: &Problems,
) -> Result<Plants, OpenError> {
    let mut plants = Plants { fmus: Vec::new(), wiring: None, inside: None };
    for (name, path) in units {
        let Some(file) = problems.keep(named_fmu(source, &path)) else { continue };
        if !is_ssp(&file) {
            plants.fmus.push((name, Fmu::open(&file)?));
        } else if name.is_empty() {
            return Plants::open(&file);
        } else {
            let message = format!("unit `{name}` is a system of FMUs, not an FMU");
            let help = "name the system with `fmu` alone".to_owned();
            problems.tell(source.error(path.span(), "named here", message, Some(help)));
        }
    }
    Ok(plants)
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

/// A cell file names no FMU and is not inside one.
fn no_fmu(source: &Source) -> Box<CellError> {
    let help = Some("add `fmu = \"your.fmu\"` at its top".to_owned());
    source.error(0..0, "in this file", "it does not say which FMU it describes", help)
}

/// Whether the cell file beside an FMU is about that FMU: it names it, or names none.
fn names_this_fmu(cell: &Path, fmu: &Path) -> bool {
    let Ok(text) = std::fs::read_to_string(cell) else { return false };
    let source = Source::new(&display_name(cell), &text).in_folder(folder_of(cell));
    // A file that cannot be read is taken: its error message helps more than a silent skip.
    let Ok(source) = extended(source) else { return true };
    let Some(file) = read_tables(&source).file else { return true };
    // A FMI 3.0 export of the same model may lie beside it.
    let stem = |path: &Path| path.file_stem().map(|stem| stem.to_string_lossy().trim_end_matches("-fmi3").to_owned());
    file.units.is_empty() && file.fmu.is_none_or(|name| stem(Path::new(name.get_ref())) == stem(fmu))
}

/// The cell file at `path` with what it extends, as one text, and the files that it extends; nothing if they cannot be read.
#[must_use]
pub fn whole_text(path: &Path) -> Option<(Source, String)> {
    let text = std::fs::read_to_string(path).ok()?;
    let source = extended(Source::new(&display_name(path), &text).in_folder(folder_of(path))).ok()?;
    let whole = as_one(&source);
    Some((source, whole))
}

fn read(path: &Path) -> Result<String, OpenError> {
    std::fs::read_to_string(path).map_err(|error| OpenError::Read { path: path.to_owned(), error })
}

fn folder_of(path: &Path) -> &Path {
    path.parent().unwrap_or(Path::new(""))
}
