//! FMUs made from a working one by one change, and what the command says about them.

use std::io::{Cursor, Read as _, Write as _};
use std::path::Path;

use tempfile::TempDir;
use zip::write::SimpleFileOptions;

use super::{fmi_hazard, test_fmus};

pub type Entries = Vec<(String, Vec<u8>)>;

pub const XML: &str = "modelDescription.xml";
pub const BINARY: &str = "binaries/linux64/faulty.so";

/// The files of a test FMU.
pub fn entries_of(fmu: &str) -> Entries {
    let bytes = std::fs::read(test_fmus().join(fmu)).unwrap();
    let mut archive = zip::ZipArchive::new(Cursor::new(bytes)).unwrap();
    (0..archive.len())
        .map(|i| {
            let mut file = archive.by_index(i).unwrap();
            let mut content = Vec::new();
            file.read_to_end(&mut content).unwrap();
            (file.name().unwrap().into_owned(), content)
        })
        .collect()
}

/// The files of the FMU that most changes are made to: FMI 2.0, one joint.
pub fn entries() -> Entries {
    entries_of("faulty.fmu")
}

pub fn pack(entries: &Entries) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in entries {
        archive.start_file(name.as_str(), SimpleFileOptions::default()).unwrap();
        archive.write_all(content).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// With one more file.
pub fn plus(name: &str, content: &[u8]) -> Vec<u8> {
    let mut all = entries();
    all.push((name.to_owned(), content.to_vec()));
    pack(&all)
}

/// With other bytes in one file.
pub fn with(name: &str, change: impl Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
    let mut all = entries();
    let entry = all.iter_mut().find(|(n, _)| n == name).unwrap();
    entry.1 = change(&entry.1);
    pack(&all)
}

pub fn with_binary(change: impl Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
    with(BINARY, change)
}

pub fn with_xml(change: impl Fn(&str) -> String) -> Vec<u8> {
    with(XML, |bytes| {
        let text = String::from_utf8(bytes.to_vec()).unwrap();
        let changed = change(&text);
        assert_ne!(text, changed, "the change did nothing");
        changed.into_bytes()
    })
}

/// The bytes of `x.fmu` in a fresh folder.
pub fn folder_with(fmu: &[u8]) -> TempDir {
    let dir = TempDir::new().unwrap();
    std::fs::write(dir.path().join("x.fmu"), fmu).unwrap();
    dir
}

/// A message without the line breaks and the frame that fit it to a terminal.
pub fn flat(text: &str) -> String {
    let text = text.replace(['│', '\n'], " ").split_whitespace().collect::<Vec<_>>().join(" ");
    // Words are broken at hyphens too.
    text.replace("- ", "-")
}

/// Two messages are the same, wherever their lines were broken: also within long words and at slashes.
#[track_caller]
pub fn same(said: &str, expected: &str) {
    let squeezed = |text: &str| text.split_whitespace().collect::<String>();
    assert!(squeezed(said) == squeezed(&flat(expected)), "said:\n{said}\nexpected:\n{expected}");
}

/// What a command says in `dir`: exit code, standard output, standard error without frames. Never a panic.
pub fn run(dir: &Path, arguments: &[&str]) -> (i32, String, String) {
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("what is printed is UTF-8");
    let error = text(&output.stderr);
    assert!(!error.contains("panicked"), "{error}");
    (output.status.code().expect("not killed by a signal"), text(&output.stdout), flat(&error))
}

/// `command` refuses this FMU: exit code 2, nothing on standard output, nothing written, and exactly this message.
#[track_caller]
pub fn refused(command: &str, fmu: &[u8], message: &str) {
    let dir = folder_with(fmu);
    let (code, stdout, stderr) = run(dir.path(), &[&command.split(' ').collect::<Vec<_>>()[..], &["x.fmu"]].concat());
    same(&stderr, &format!("Error: × {message}"));
    assert_eq!((code, stdout.as_str()), (2, ""));
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1, "something was written beside it");
}

/// `inspect` takes this FMU and says exactly this on standard error; returns what it says on standard output.
#[track_caller]
pub fn inspected(fmu: &[u8], warnings: &[&str]) -> String {
    let dir = folder_with(fmu);
    let (code, stdout, stderr) = run(dir.path(), &["inspect", "x.fmu"]);
    same(&stderr, &warnings.iter().map(|w| format!("   Warning {w}\n")).collect::<String>());
    assert_eq!(code, 0);
    stdout
}
