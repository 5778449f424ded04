//! Open an FMU safely, read its description, call it. FMI 2.0 and FMI 3.0 co-simulation, behind one interface.
//!
//! This floor knows nothing of humans, robots or processes and could be a crate of its own. In order of use:
//!
//! 1. [`Fmu::open`] checks and unpacks the archive and reads modelDescription.xml; nothing of the FMU runs.
//!    [`ModelDescription::from_xml`] reads the latter alone.
//! 2. [`Fmu::load`] checks the binary's header and loads it: from here on the FMU's code may run.
//! 3. [`Slave::instantiate`] makes an instance, whose life is a chain of types: [`Instance<Instantiated>`],
//!    [`Instance<Initializing>`], [`Instance<Stepping>`].
//! 4. [`Plan`] writes and reads rows of variables of any numeric type, one C call for each type; [`Instance::get`] and
//!    its like reach single ones.
//! 5. [`Instance::save`] and [`Instance::restore`] keep states, owned by their instance.
//!
//! Where FMI 3.0 differs and what is done about it: arrays are addressed element by element
//! ([`ModelDescription::element`]), structural parameters keep their start values, steps that return early are
//! continued, Event Mode is used where it is needed ([`EventMode`]), intermediate updates are not asked for and input
//! clocks are not driven.
//!
//! # Example
//!
//! ```
//! # let dir = tempfile::tempdir()?;
//! # fmi_hazard_examples::export(dir.path())?;
//! # let path = dir.path().join("safety-fence/safety-fence.fmu");
//! use fmu_host::fmi::Fmu;
//!
//! let fmu = Fmu::open(&path)?;
//! let speed = fmu.description().variable("robot.tcp_speed").expect("an output").value_reference;
//! let instance = fmu.load()?.instantiate("robot")?;
//! let mut instance = instance.enter_initialization(0.0, None)?.exit_initialization()?;
//! let start = instance.save()?;
//! instance.do_step(0.0, 0.02)?;
//! let mut value = [0.0];
//! instance.get_real(&[speed], &mut value)?;
//! assert!(value[0] > 0.0);
//! instance.restore(&start)?;
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod abi;
mod abi2;
mod abi3;
mod archive;
mod description;
mod error;
mod instance;
mod library;
mod log;
mod plan;
mod raw;
mod raw2;
mod raw3;
mod read_xml;
pub(crate) mod temporary;
mod text;
mod values;
mod variable;
mod version;

use std::path::{Path, PathBuf};
use std::sync::Arc;

pub use archive::{Archive, ArchiveLimits};
pub use description::{Capabilities, CoSimulation, DefaultExperiment, MOST_VALUES, ModelDescription};
pub use error::{CallFailure, Error, Status};
pub use fmu_self_test::number;
pub use instance::{EventMode, Initializing, Instance, Instantiated, Stepping};
pub use library::Slave;
pub use log::on_log;
pub use plan::Plan;
pub use raw::State;
pub use read_xml::{DescriptionError, Warning};
pub use text::{escaped, is_unsafe, printable};
pub use values::{Number, Values};
pub use variable::{Causality, Dimension, Handle, Scalar, Variability, Variable, VariableType};
pub use version::FmiVersion;

/// The unpacked files of an FMU.
enum Files {
    /// Removed with the last one who needs them.
    Own(temporary::Folder),
    /// Somebody else's.
    Others(PathBuf),
}

impl Files {
    fn path(&self) -> &Path {
        match self {
            Self::Own(folder) => folder.path(),
            Self::Others(folder) => folder,
        }
    }
}

/// An FMU that was opened and read. Nothing of it is loaded or run.
pub struct Fmu {
    path: PathBuf,
    sha256: String,
    files: Arc<Files>,
    description: ModelDescription,
    warnings: Vec<Warning>,
    platforms: Vec<String>,
}

impl Fmu {
    /// Opens the FMU at `path` within the default [`ArchiveLimits`].
    ///
    /// # Errors
    /// When the file is no FMU, or one that could do harm, or one of a kind that cannot be used.
    pub fn open(path: &Path) -> Result<Self, Error> {
        Self::open_with(path, &ArchiveLimits::default())
    }

    /// The same within other limits.
    ///
    /// # Errors
    /// As [`Fmu::open`].
    pub fn open_with(path: &Path, limits: &ArchiveLimits) -> Result<Self, Error> {
        let unpacked = archive::unpack(path, limits)?;
        Self::read(path, unpacked.sha256, Files::Own(unpacked.files))
    }

    /// The FMU at `path` that [`Fmu::open`] has unpacked to `folder` before, maybe in another process. The folder stays
    /// with its owner; the checksum is not known here.
    ///
    /// # Errors
    /// As [`Fmu::open`].
    pub fn reopen(path: &Path, folder: &Path) -> Result<Self, Error> {
        Self::read(path, String::new(), Files::Others(folder.to_owned()))
    }

    fn read(path: &Path, sha256: String, files: Files) -> Result<Self, Error> {
        let xml = files.path().join("modelDescription.xml");
        let bytes = std::fs::read(&xml).map_err(|error| Error::Read { path: path.to_owned(), error })?;
        let (description, warnings) = ModelDescription::from_xml(&bytes)
            .map_err(|problem| Error::Description { path: path.to_owned(), problem })?;
        supported(&description).map_err(|e| e.of(path))?;
        let entries = std::fs::read_dir(files.path().join("binaries")).into_iter().flatten().flatten();
        let mut platforms: Vec<String> = entries
            .filter(|entry| entry.path().is_dir())
            .map(|entry| entry.file_name().to_string_lossy().into_owned())
            .collect();
        platforms.sort();
        Ok(Self { path: path.to_owned(), sha256, files: Arc::new(files), description, warnings, platforms })
    }

    /// Where it was opened from.
    #[must_use]
    pub fn path(&self) -> &Path {
        &self.path
    }

    /// SHA-256 of the file, lower-case hex.
    #[must_use]
    pub fn sha256(&self) -> &str {
        &self.sha256
    }

    /// modelDescription.xml.
    #[must_use]
    pub const fn description(&self) -> &ModelDescription {
        &self.description
    }

    /// What was odd in it.
    #[must_use]
    pub fn warnings(&self) -> &[Warning] {
        &self.warnings
    }

    /// Folders below `binaries/`.
    #[must_use]
    pub fn platforms(&self) -> &[String] {
        &self.platforms
    }

    /// Whether it has a binary for this machine, by the name of the folder.
    #[must_use]
    pub fn runs_here(&self) -> bool {
        let version = self.description.version();
        version.is_some_and(|version| self.platforms.iter().any(|folder| folder == library::platform(version)))
    }

    /// The folder of the unpacked files; it lives as long as this FMU and what was loaded from it.
    #[must_use]
    pub fn folder(&self) -> &Path {
        self.files.path()
    }

    /// The unpacked file with this path inside the FMU, if there is one.
    #[must_use]
    pub fn file(&self, name: &str) -> Option<PathBuf> {
        let path = self.files.path().join(name);
        path.is_file().then_some(path)
    }

    /// Loads the binary: its code runs from here on.
    ///
    /// # Errors
    /// When there is none for this machine or it cannot be loaded.
    pub fn load(&self) -> Result<Slave, Error> {
        let load = || {
            let Some(co_simulation) = &self.description.co_simulation else { return Err(no_co_simulation()) };
            let version = supported(&self.description)?;
            library::load(&self.files, &self.platforms, version, &self.description, &co_simulation.capabilities)
        };
        load().map_err(|e| e.of(&self.path))
    }
}

fn no_co_simulation() -> Error {
    Error::Unsupported(
        "this FMU has no co-simulation interface, only model exchange. Export it as Co-Simulation".to_owned(),
    )
}

/// The versions and interfaces that can be used.
fn supported(description: &ModelDescription) -> Result<FmiVersion, Error> {
    let Some(version) = description.version() else {
        let version = description.fmi_version.as_str();
        let text = if version.starts_with('3') {
            format!(
                "this is an FMI {version} FMU, a version this program does not know (3.0 and 3.0.x are known). Export \
                 it as FMI 3.0 or FMI 2.0"
            )
        } else {
            format!("this is an FMI {version} FMU; FMI 2.0 co-simulation is needed, or FMI 3.0. Export it as FMI 2.0")
        };
        return Err(Error::Unsupported(text));
    };
    if description.co_simulation.is_none() {
        return Err(no_co_simulation());
    }
    Ok(version)
}
