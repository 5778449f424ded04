//! Loading the binary of an FMU: checked before it is loaded, loaded so that missing symbols show at once, never
//! unloaded.
#![expect(unsafe_code, reason = "loads a shared library and reads C strings from it")]

use std::collections::BTreeMap;
use std::ffi::{CStr, c_char};
use std::path::Path;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, OnceLock};

use super::Files;
use super::abi::Common;
use super::description::{Capabilities, ModelDescription};
use super::error::Error;
use super::text::printable;
use super::version::FmiVersion;
use super::{abi2, abi3};
use libloading::os::unix::{Library, RTLD_GLOBAL, RTLD_LOCAL, RTLD_NOW};
use object::read::elf::{ElfFile64, FileHeader as _};
use object::{Endianness, Object as _, ObjectSection as _};

/// A loaded FMU binary from which instances are made. Cheap to clone; keeps the extracted files alive.
#[derive(Clone)]
pub struct Slave(Arc<Inner>);

/// The functions that differ between the versions.
pub(super) enum Table {
    V2(abi2::Functions),
    V3(abi3::Functions),
}

struct Inner {
    // Leaked like the library they point into.
    common: &'static Common,
    table: &'static Table,
    guid: String,
    /// FMI 2.0: a URI. FMI 3.0: a path with a separator at its end, if there are resources.
    resources: Option<String>,
    capabilities: Capabilities,
    /// Start values of arrays by value reference.
    array_starts: BTreeMap<u32, Vec<f64>>,
    prefers_event_mode: AtomicBool,
    needs_event_mode: bool,
    /// The step of the default experiment, s.
    step_size: Option<f64>,
    /// When an FMU without Event Mode first said at the end of a step that an event is to be handled, s.
    left_event_s: OnceLock<f64>,
    poisoned: AtomicBool,
    _files: Arc<Files>,
}

impl Slave {
    /// What the FMU says it can do.
    #[must_use]
    pub fn capabilities(&self) -> &Capabilities {
        &self.0.capabilities
    }

    /// Version of the standard.
    #[must_use]
    pub fn version(&self) -> FmiVersion {
        match self.table() {
            Table::V2(_) => FmiVersion::V2,
            Table::V3(_) => FmiVersion::V3,
        }
    }

    /// Sets whether [`Slave::instantiate`] uses the Event Mode that the FMU has. At first only if it has clocks to be
    /// driven from outside.
    pub fn prefer_event_mode(&self, prefer: bool) {
        self.0.prefers_event_mode.store(prefer, Ordering::Relaxed);
    }

    /// Whether [`Slave::instantiate`] uses the Event Mode of an FMU that has one.
    #[must_use]
    pub fn prefers_event_mode(&self) -> bool {
        self.0.prefers_event_mode.load(Ordering::Relaxed)
    }

    /// Whether the FMU has clocks to be driven from outside.
    pub(crate) fn needs_event_mode(&self) -> bool {
        self.0.needs_event_mode
    }

    /// The step of the default experiment, s.
    pub(crate) fn step_size(&self) -> Option<f64> {
        self.0.step_size
    }

    /// When this FMU, which has no Event Mode, first said at the end of a step that an event is to be handled there, s.
    pub(crate) fn left_event_s(&self) -> Option<f64> {
        self.0.left_event_s.get().copied()
    }

    /// Notes that it said so.
    pub(super) fn leaves_event(&self, at_s: f64) {
        let _ = self.0.left_event_s.set(at_s);
    }

    pub(super) fn common(&self) -> &'static Common {
        self.0.common
    }

    pub(super) fn table(&self) -> &'static Table {
        self.0.table
    }

    pub(super) fn guid(&self) -> &str {
        &self.0.guid
    }

    pub(super) fn resources(&self) -> Option<&str> {
        self.0.resources.as_deref()
    }

    /// Start values of the array with this value reference; none for a scalar.
    pub(super) fn array_start(&self, reference: u32) -> &[f64] {
        self.0.array_starts.get(&reference).map_or(&[], Vec::as_slice)
    }

    /// Whether an instance reported a fatal error: then no function may be called any more.
    pub(super) fn is_poisoned(&self) -> bool {
        self.0.poisoned.load(Ordering::Relaxed)
    }

    pub(super) fn poison(&self) {
        self.0.poisoned.store(true, Ordering::Relaxed);
    }
}

/// The folder of `binaries/` for this machine: FMI 3.0 renamed them all.
pub(super) const fn platform(version: FmiVersion) -> &'static str {
    const LINUX: bool = cfg!(target_os = "linux");
    const X86_64: bool = cfg!(target_arch = "x86_64");
    match version {
        FmiVersion::V2 if LINUX && X86_64 => "linux64",
        FmiVersion::V2 if !LINUX => "darwin64",
        FmiVersion::V3 if LINUX && X86_64 => "x86_64-linux",
        FmiVersion::V3 if !LINUX && X86_64 => "x86_64-darwin",
        FmiVersion::V3 if !LINUX => "aarch64-darwin",
        FmiVersion::V2 | FmiVersion::V3 => "aarch64-linux",
    }
}

/// Loads `binaries/<platform>/<identifier>.so` below `root`.
pub(super) fn load(
    files: &Arc<Files>,
    platforms: &[String],
    version: FmiVersion,
    description: &ModelDescription,
    capabilities: &Capabilities,
) -> Result<Slave, Error> {
    let wanted = platform(version);
    let folder = files.path().join("binaries").join(wanted);
    let identifier = &capabilities.model_identifier;
    let path = folder.join(format!("{identifier}{}", std::env::consts::DLL_SUFFIX));
    if !path.is_file() {
        let sources = files.path().join("sources").is_dir();
        return Err(Error::Binary(missing(&folder, wanted, identifier, platforms, sources)));
    }
    check_header(&path, wanted)?;
    let library = open(&path)?;
    let lacks = |name: &str| {
        Error::Binary(format!(
            "the binary of this FMU lacks {name}, which every {version} co-simulation FMU must have. Ask its maker for a \
             complete export"
        ))
    };
    let names = match version {
        FmiVersion::V2 => &abi2::NAMES,
        FmiVersion::V3 => &abi3::NAMES,
    };
    // SAFETY: a file that modelDescription.xml declares to be a binary of this version; that it is one cannot be
    // checked further than by its version function below.
    let common = unsafe { Common::load(&library, names) }.map_err(lacks)?;
    let table = match version {
        // SAFETY: as above.
        FmiVersion::V2 => Table::V2(unsafe { abi2::Functions::load(&library) }.map_err(lacks)?),
        // SAFETY: as above.
        FmiVersion::V3 => Table::V3(unsafe { abi3::Functions::load(&library) }.map_err(lacks)?),
    };
    // Never closed: FMUs leave threads and exit handlers behind that would run unmapped code.
    std::mem::forget(library);
    check_version(&common, &table)?;
    Ok(Slave(Arc::new(Inner {
        common: Box::leak(Box::new(common)),
        table: Box::leak(Box::new(table)),
        guid: description.guid.clone(),
        resources: resources(version, files.path())?,
        capabilities: capabilities.clone(),
        array_starts: description
            .variables
            .iter()
            .filter(|v| !v.dimensions.is_empty())
            .map(|v| (v.value_reference, v.numeric_start()))
            .collect(),
        prefers_event_mode: AtomicBool::new(description.needs_event_mode()),
        needs_event_mode: description.needs_event_mode(),
        step_size: description.default_experiment.step_size.filter(|step| step.is_finite() && *step > 0.0),
        left_event_s: OnceLock::new(),
        poisoned: AtomicBool::new(false),
        _files: Arc::clone(files),
    })))
}

/// What the binary says of itself must be what its XML says.
fn check_version(common: &Common, table: &Table) -> Result<(), Error> {
    let text = |function: Option<unsafe extern "C" fn() -> *const c_char>| {
        // SAFETY: these functions take nothing and return a constant text, or NULL.
        let pointer = unsafe { function?() };
        if pointer.is_null() {
            return None;
        }
        // SAFETY: not NULL, and NUL-terminated by the standard.
        Some(unsafe { CStr::from_ptr(pointer) }.to_string_lossy().into_owned())
    };
    let differs = |what: &str, found: &str, expected: &str| {
        Err(Error::Binary(format!(
            "the binary is of FMI {what} \"{found}\", its XML says \"{expected}\". Export the FMU again"
        )))
    };
    let found = text(common.get_version);
    match (table, found.as_deref()) {
        (Table::V2(_), Some(found)) if found != "2.0" => return differs("version", found, "2.0"),
        (Table::V3(_), Some(found)) if found != "3.0" && !found.starts_with("3.0.") => {
            return differs("version", found, "3.0");
        }
        _ => {}
    }
    if let Table::V2(functions) = table
        && let Some(found) = text(functions.get_types_platform).filter(|f| f != "default")
    {
        return differs("types", &found, "default");
    }
    Ok(())
}

/// Where the FMU finds its resources, as its version wants to be told.
fn resources(version: FmiVersion, files: &Path) -> Result<Option<String>, Error> {
    let folder = files.join("resources");
    match version {
        FmiVersion::V2 => Ok(Some(format!("file://{}", percent_encoded(&folder)))),
        FmiVersion::V3 if folder.is_dir() => {
            let folder = std::path::absolute(&folder).map_err(|error| Error::Read { path: folder, error })?;
            Ok(Some(format!("{}{}", folder.display(), std::path::MAIN_SEPARATOR)))
        }
        FmiVersion::V3 => Ok(None),
    }
}

fn missing(folder: &Path, wanted: &str, identifier: &str, platforms: &[String], sources: bool) -> String {
    if !platforms.iter().any(|p| p == wanted) {
        let found = if platforms.is_empty() { "no binaries at all".to_owned() } else { platforms.join(", ") };
        let compile = if sources { ", or compile the sources in it (`fmpy compile` does that)" } else { "" };
        return format!(
            "this FMU has no binary for this machine: {wanted} is needed, it contains {}. Ask its maker for a {wanted} \
             export, or run this program on a machine it was made for{compile}",
            printable(&found)
        );
    }
    let mut there: Vec<String> = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .collect();
    there.sort();
    let there = if there.is_empty() { "nothing".to_owned() } else { there.join(", ") };
    format!(
        "binaries/{wanted} has no {identifier}{}, the name that modelDescription.xml gives; it contains {}. Export the \
         FMU again",
        std::env::consts::DLL_SUFFIX,
        printable(&there)
    )
}

/// Reads the ELF header and the section table: a truncated or foreign file must not reach the loader, which may kill
/// the process over it.
fn check_header(path: &Path, platform: &str) -> Result<(), Error> {
    let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    let bytes = std::fs::read(path).map_err(|error| Error::Read { path: path.to_owned(), error })?;
    let refuse =
        |why: &str| Err(Error::Binary(format!("{name} cannot be loaded: it {why}. Export the FMU for {platform}")));
    // What the other systems' libraries begin with; those of macOS in either order of bytes.
    let macos = [0xFEED_FACF_u32, 0xCAFE_BABE].map(u32::to_be_bytes);
    let reversed = |mut magic: [u8; 4]| {
        magic.reverse();
        magic
    };
    if bytes.starts_with(b"MZ") {
        return refuse("is a library for Windows");
    }
    if macos.iter().any(|magic| bytes.starts_with(magic) || bytes.starts_with(&reversed(*magic))) {
        return refuse("is a library for macOS");
    }
    match object::FileKind::parse(bytes.as_slice()) {
        Ok(object::FileKind::Elf64) => {}
        Ok(object::FileKind::Elf32) => return refuse("is a 32-bit library"),
        _ => return refuse("is not a shared library"),
    }
    let Ok(file) = ElfFile64::<Endianness>::parse(bytes.as_slice()) else { return refuse("is damaged") };
    let machine = file.elf_header().e_machine(file.endian());
    let wanted = if cfg!(target_arch = "x86_64") { object::elf::EM_X86_64 } else { object::elf::EM_AARCH64 };
    if machine != wanted {
        return refuse("is for another processor");
    }
    let length = bytes.len() as u64;
    let within = |offset: u64, size: u64| offset.checked_add(size).is_some_and(|end| end <= length);
    let segments = file.elf_program_headers().iter().all(|segment| {
        use object::read::elf::ProgramHeader as _;
        within(segment.p_offset(file.endian()), segment.p_filesz(file.endian()))
    });
    let sections = file.sections().all(|s| s.file_range().is_none_or(|(offset, size)| within(offset, size)));
    if segments && sections { Ok(()) } else { refuse("is truncated") }
}

/// `dlopen` with all symbols resolved now; once more with libm loaded for all where a library forgot to ask for it.
fn open(path: &Path) -> Result<Library, Error> {
    // SAFETY: loading runs the library's initialisers: that is what the user asked for by giving the FMU.
    let first = unsafe { Library::open(Some(path), RTLD_NOW | RTLD_LOCAL) };
    let error = match first {
        Ok(library) => return Ok(library),
        Err(error) => reason(&error),
    };
    if error.contains("undefined symbol") {
        // SAFETY: libm is the system's mathematical library; it stays loaded.
        if let Ok(libm) = unsafe { Library::open(Some("libm.so.6"), RTLD_NOW | RTLD_GLOBAL) } {
            std::mem::forget(libm);
            // SAFETY: as for the first try.
            if let Ok(library) = unsafe { Library::open(Some(path), RTLD_NOW | RTLD_LOCAL) } {
                return Ok(library);
            }
        }
    }
    Err(Error::Binary(format!("the binary of this FMU cannot be loaded: {error}{}", advice(&error))))
}

fn reason(error: &libloading::Error) -> String {
    use std::error::Error as _;
    error.source().map_or_else(|| error.to_string(), ToString::to_string)
}

fn advice(error: &str) -> &'static str {
    if error.contains("undefined symbol: _Py") || error.contains("undefined symbol: Py") {
        ". It is written in Python and needs Python's library: start this program with LD_PRELOAD set to that library, for \
         instance LD_PRELOAD=libpython3.11.so.1 (on Debian 12 in the package libpython3.11)"
    } else if error.contains("liblapack") {
        ". On Debian the package liblapack3 has this library"
    } else if error.contains("libgfortran") {
        ". On Debian the package libgfortran5 has the present version of this library"
    } else if error.contains("cannot open shared object file") {
        ". Install the library that is named here"
    } else if error.contains("undefined symbol") {
        ". The export is incomplete: ask its maker for one that brings this function"
    } else {
        ""
    }
}

/// A path as the path part of a URI (RFC 3986).
fn percent_encoded(path: &Path) -> String {
    use std::fmt::Write as _;
    let mut out = String::new();
    for byte in path.to_string_lossy().bytes() {
        if byte.is_ascii_alphanumeric() || b"/-._~".contains(&byte) {
            out.push(char::from(byte));
        } else {
            let _ = write!(out, "%{byte:02X}");
        }
    }
    out
}
