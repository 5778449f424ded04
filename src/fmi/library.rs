//! Loading the binary of an FMU: checked before it is loaded, loaded so that missing symbols show at once, never
//! unloaded.
#![expect(unsafe_code, reason = "loads a shared library and reads C strings from it")]

use std::ffi::{CStr, c_char};
use std::path::Path;
use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use libloading::os::unix::{Library, RTLD_GLOBAL, RTLD_LOCAL, RTLD_NOW};
use object::read::elf::{ElfFile64, FileHeader as _};
use object::{Endianness, Object as _, ObjectSection as _};
use tempfile::TempDir;

use super::abi2::Functions;
use super::description::Capabilities;
use super::error::Error;

/// A loaded FMU binary from which instances are made. Cheap to clone; keeps the extracted files alive.
#[derive(Clone)]
pub struct Slave(Arc<Inner>);

struct Inner {
    functions: Functions,
    guid: String,
    resource_uri: String,
    capabilities: Capabilities,
    poisoned: AtomicBool,
    _files: Arc<TempDir>,
}

impl Slave {
    /// What the FMU says it can do.
    #[must_use]
    pub fn capabilities(&self) -> &Capabilities {
        &self.0.capabilities
    }

    pub(super) fn functions(&self) -> &Functions {
        &self.0.functions
    }

    pub(super) fn guid(&self) -> &str {
        &self.0.guid
    }

    pub(super) fn resource_uri(&self) -> &str {
        &self.0.resource_uri
    }

    /// Whether an instance reported a fatal error: then no function may be called any more.
    pub(super) fn is_poisoned(&self) -> bool {
        self.0.poisoned.load(Ordering::Relaxed)
    }

    pub(super) fn poison(&self) {
        self.0.poisoned.store(true, Ordering::Relaxed);
    }
}

/// The folder of `binaries/` for this machine.
pub(super) const PLATFORM: &str = if cfg!(all(target_os = "linux", target_arch = "x86_64")) {
    "linux64"
} else if cfg!(all(target_os = "linux", target_arch = "aarch64")) {
    "aarch64-linux"
} else {
    "darwin64"
};

/// Loads `binaries/<platform>/<identifier>.so` below `root`.
pub(super) fn load(
    files: &Arc<TempDir>,
    platforms: &[String],
    guid: &str,
    capabilities: &Capabilities,
) -> Result<Slave, Error> {
    let folder = files.path().join("binaries").join(PLATFORM);
    let identifier = &capabilities.model_identifier;
    let path = folder.join(format!("{identifier}{}", std::env::consts::DLL_SUFFIX));
    if !path.is_file() {
        return Err(Error::Binary(missing(&folder, identifier, platforms)));
    }
    check_header(&path)?;
    let library = open(&path)?;
    // SAFETY: a file that modelDescription.xml declares to be an FMI 2.0 binary; that it is one cannot be checked
    // further than by its version function below.
    let functions = unsafe { Functions::load(&library) }.map_err(|name| {
        Error::Binary(format!("the binary of this FMU lacks {name}, which every FMI 2.0 co-simulation FMU must have"))
    })?;
    // Never closed: FMUs leave threads and exit handlers behind that would run unmapped code.
    std::mem::forget(library);
    let text = |function: Option<unsafe extern "C" fn() -> *const c_char>| {
        // SAFETY: these two functions take nothing and return a constant text, or NULL.
        let pointer = unsafe { function?() };
        if pointer.is_null() {
            return None;
        }
        // SAFETY: not NULL, and NUL-terminated by the standard.
        Some(unsafe { CStr::from_ptr(pointer) }.to_string_lossy().into_owned())
    };
    for (what, expected, found) in
        [("version", "2.0", text(functions.get_version)), ("types", "default", text(functions.get_types_platform))]
    {
        if let Some(found) = found.filter(|f| f != expected) {
            return Err(Error::Binary(format!("the binary is of FMI {what} \"{found}\", its XML says \"{expected}\"")));
        }
    }
    let resource_uri = format!("file://{}", percent_encoded(&files.path().join("resources")));
    Ok(Slave(Arc::new(Inner {
        functions,
        guid: guid.to_owned(),
        resource_uri,
        capabilities: capabilities.clone(),
        poisoned: AtomicBool::new(false),
        _files: Arc::clone(files),
    })))
}

fn missing(folder: &Path, identifier: &str, platforms: &[String]) -> String {
    if !platforms.iter().any(|p| p == PLATFORM) {
        let found = if platforms.is_empty() { "no binaries at all".to_owned() } else { platforms.join(", ") };
        return format!(
            "this FMU has no binary for this machine: {PLATFORM} is needed, it contains {found}. Ask its maker for a \
             {PLATFORM} export, or run this program on a machine it was made for"
        );
    }
    let there: Vec<String> = std::fs::read_dir(folder)
        .into_iter()
        .flatten()
        .flatten()
        .map(|e| e.file_name().to_string_lossy().into_owned())
        .collect();
    format!("binaries/{PLATFORM} has no {identifier}{}; it contains {}", std::env::consts::DLL_SUFFIX, there.join(", "))
}

/// Reads the ELF header and the section table: a truncated or foreign file must not reach the loader, which may kill
/// the process over it.
fn check_header(path: &Path) -> Result<(), Error> {
    let name = path.file_name().map_or_else(String::new, |n| n.to_string_lossy().into_owned());
    if !cfg!(target_os = "linux") {
        return Ok(());
    }
    let bytes = std::fs::read(path).map_err(|error| Error::Read { path: path.to_owned(), error })?;
    let refuse =
        |why: &str| Err(Error::Binary(format!("{name} cannot be loaded: it {why}. Export the FMU for {PLATFORM}")));
    match object::FileKind::parse(bytes.as_slice()) {
        Ok(object::FileKind::Elf64) => {}
        Ok(object::FileKind::Elf32) => return refuse("is a 32-bit library"),
        Ok(_) => return refuse("is a library for another operating system"),
        Err(_) => return refuse("is not a shared library"),
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
        ". It needs a Python 3 library: start this program with LD_PRELOAD set to libpython3"
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
