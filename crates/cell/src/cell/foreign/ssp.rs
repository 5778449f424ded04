//! Systems of FMUs from SSP files (System Structure and Parameterization 1.0 and 2.0, Modelica Association): `.ssp`
//! archives and bare `.ssd` files.
//!
//! Read is a flat system of co-simulation FMUs: components, connections with unit conversion and linear transformation,
//! parameters inline and from `.ssv` files. What would change a result and is not read is refused, by element and line.

mod parameters;
mod structure;

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::cell::EXTRA_FOLDER;
use crate::cell::error::{OpenError, Source, display_name};
use crate::fmi::{Archive, Fmu};

pub(crate) use parameters::Parameter;
pub use structure::{Link, Structure};

/// A system with its FMUs opened, not loaded.
pub struct System {
    /// What is connected with what.
    pub structure: Structure,
    /// The system structure description, for messages.
    pub source: Source,
    /// The FMUs by the names of their components, in the order of the file.
    pub fmus: Vec<(String, Fmu)>,
    /// SHA-256 of the file, lower-case hex.
    pub sha256: String,
    /// A cell file that travels inside: what it is called, its text, and its folder.
    pub cell: Option<(String, String, PathBuf)>,
    /// The unpacked archive, for as long as files in it are wanted.
    pub archive: Option<Arc<Archive>>,
}

/// A system of FMUs, without them.
#[derive(Clone)]
pub struct Wiring {
    /// Components, connections, parameters.
    pub structure: Structure,
    /// The description, for messages.
    pub source: Source,
    /// The SSP file.
    pub path: PathBuf,
    /// SHA-256 of it, lower-case hex.
    pub sha256: String,
    /// Its files, if it is an archive: a cell file inside may name some.
    pub archive: Option<Arc<Archive>>,
}

/// Whether a path is that of an SSP file.
#[must_use]
pub fn is_ssp(path: &Path) -> bool {
    path.extension().is_some_and(|e| e.eq_ignore_ascii_case("ssp") || e.eq_ignore_ascii_case("ssd"))
}

/// The name of the description inside an archive.
const DESCRIPTION: &str = "SystemStructure.ssd";

/// Opens the system at `path`.
///
/// # Errors
/// When it cannot be read, or is of a kind that is not supported.
pub fn open(path: &Path) -> Result<System, OpenError> {
    let archive = match path.extension() {
        Some(e) if e.eq_ignore_ascii_case("ssp") => Some(Archive::open(path)?),
        _ => None,
    };
    let (file, name) = match &archive {
        Some(archive) => (archive.folder().join(DESCRIPTION), format!("{}!{DESCRIPTION}", path.display())),
        None => (path.to_owned(), display_name(path)),
    };
    let folder = file.parent().unwrap_or(Path::new("")).to_owned();
    let read =
        |file: &Path| std::fs::read_to_string(file).map_err(|error| OpenError::Read { path: path.to_owned(), error });
    let source = Source::new(&name, &read(&file)?).in_folder(&folder);
    let structure = structure::read(&source)?;
    let mut fmus = Vec::with_capacity(structure.components.len());
    for component in &structure.components {
        let inside = folder.join(&component.source);
        if !inside.is_file() {
            let message = format!("the FMU {} of component `{}` is not there", component.source, component.name);
            let help = "its path is relative to the system structure description".to_owned();
            return Err(OpenError::Cell(source.error(component.place.clone(), "named here", message, Some(help))));
        }
        fmus.push((component.name.clone(), Fmu::open(&inside)?));
    }
    let sha256 = match &archive {
        Some(archive) => archive.sha256().to_owned(),
        None => source.sha256(),
    };
    let own = format!("{}/cell.toml", EXTRA_FOLDER);
    let cell = archive.as_ref().map(|archive| archive.folder().join(&own)).filter(|cell| cell.is_file());
    let cell = match cell {
        Some(cell) => {
            let folder = cell.parent().unwrap_or(Path::new("")).to_owned();
            Some((format!("{}!{own}", path.display()), read(&cell)?, folder))
        }
        None => None,
    };
    Ok(System { structure, source, fmus, sha256, cell, archive: archive.map(Arc::new) })
}

/// A path inside a system, if it stays there.
fn inside(path: &str) -> Option<PathBuf> {
    let plain = path_clean::clean(Path::new(path));
    let stays = !plain.is_absolute() && !plain.starts_with("..") && !path.contains("://");
    stays.then_some(plain)
}
