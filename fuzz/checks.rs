//! The rules that opening an FMU and reading a modelDescription.xml keep whatever the bytes are. Shared by the fuzz
//! targets and by `tests/suite/mutated_fmus.rs`. Breaking one is a panic.

use std::path::{Path, PathBuf};
use std::sync::OnceLock;

use fmi_hazard::fmi::{ArchiveLimits, Fmu, ModelDescription, Warning, is_unsafe};
use tempfile::TempDir;

/// Longest message of one problem, in characters.
const LONGEST: usize = 5000;

/// A message that a person can be shown.
fn printable(message: &str) {
    assert!(message.chars().count() > 5, "no message: {message:?}");
    assert!(message.chars().count() < LONGEST, "a message of {} bytes", message.len());
    assert!(!message.contains(|c: char| c != '\n' && is_unsafe(c)), "{message:?}");
}

/// Reads `bytes` as modelDescription.xml; whether that worked.
#[allow(dead_code, reason = "one fuzz target uses it")]
pub fn description(bytes: &[u8]) -> bool {
    match ModelDescription::from_xml(bytes) {
        Ok((description, warnings)) => {
            sound(&description, &warnings);
            true
        }
        Err(problem) => {
            printable(&problem.to_string());
            assert!(problem.line >= 1 && problem.column >= 1, "{problem:?}");
            assert!(problem.line <= bytes.len() + 1 && problem.column <= bytes.len() + 1, "{problem:?}");
            false
        }
    }
}

/// What was read fits together.
fn sound(description: &ModelDescription, warnings: &[Warning]) {
    assert!(warnings.len() <= 51, "{} warnings", warnings.len());
    warnings.iter().for_each(|w| printable(&w.to_string()));
    if let Some(co_simulation) = &description.co_simulation {
        let name = &co_simulation.capabilities.model_identifier;
        assert!(!name.is_empty() && name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_'), "{name:?}");
    }
    for variable in &description.variables {
        assert_eq!(description.variable(&variable.name), Some(variable));
        let count = description.count(variable).expect("a description with arrays of unknown size is refused");
        for (name, handle) in description.elements(variable).take(10) {
            assert!(handle.offset < count && handle.count == count, "{name}: {handle:?} of {count}");
            // An element of an array may have the name of a scalar, which then comes first.
            assert!(description.handle(&name).is_some(), "{name:?}");
        }
    }
}

/// A folder deep inside a fresh one, used for all temporary files of this process: what climbs out of it is seen.
fn sandbox() -> &'static (TempDir, PathBuf) {
    static SANDBOX: OnceLock<(TempDir, PathBuf)> = OnceLock::new();
    SANDBOX.get_or_init(|| {
        let outer = TempDir::new().expect("a temporary folder");
        let temporary = outer.path().join("1/2/3/4/5/6/7/8");
        std::fs::create_dir_all(&temporary).expect("a folder");
        tempfile::env::override_temp_dir(&temporary).expect("nothing asked for a temporary folder before");
        (outer, temporary)
    })
}

/// All files and folders below one, folders first.
fn tree(folder: &Path) -> Vec<PathBuf> {
    let mut found: Vec<PathBuf> = Vec::new();
    for entry in std::fs::read_dir(folder).expect("a folder").flatten() {
        found.push(entry.path());
        if entry.file_type().is_ok_and(|t| t.is_dir()) {
            found.extend(tree(&entry.path()));
        }
    }
    found
}

/// Opens `bytes` as an FMU; whether that worked.
#[allow(dead_code, reason = "one fuzz target uses it")]
pub fn archive(bytes: &[u8]) -> bool {
    let (outer, temporary) = sandbox();
    let path = outer.path().join("x.fmu");
    std::fs::write(&path, bytes).expect("a file can be written");
    let limits =
        ArchiveLimits { total_bytes: 1 << 20, entries: 100, description_bytes: 1 << 18, ..ArchiveLimits::default() };
    let opened = match Fmu::open_with(&path, &limits) {
        Ok(fmu) => {
            sound(fmu.description(), fmu.warnings());
            let folder = fmu.file("modelDescription.xml").expect("it was read").parent().expect("a folder").to_owned();
            // All folders of a process lie in one.
            assert_eq!(folder.parent().and_then(|own| own.parent()), Some(temporary.as_path()));
            let files = tree(&folder);
            assert!(files.iter().all(|f| !f.is_symlink()), "{files:?}");
            let bytes: u64 =
                files.iter().filter_map(|f| f.metadata().ok()).filter(|m| m.is_file()).map(|m| m.len()).sum();
            assert!(bytes <= limits.total_bytes, "{bytes} bytes were written");
            true
        }
        Err(error) => {
            printable(&error.to_string());
            false
        }
    };
    // Eight folders and the FMU itself.
    assert_eq!(tree(outer.path()).len(), 9, "left behind: {:?}", tree(outer.path()));
    opened
}
