//! Archives that are damaged, hostile or simply not FMUs: refused with a message that says what to do, before anything
//! is written. Each is made here from a working test FMU by one change.

use std::io::{Cursor, Write as _};
use std::path::{Path, PathBuf};

use crate::common::archives::{Entries, XML, entries, folder_with, inspected, pack, plus, refused, run, with};
use crate::common::test_fmus;
use fmi_hazard::fmi::{ArchiveLimits, Fmu};
use zip::write::SimpleFileOptions;

/// Replaces all occurrences of some bytes by others of the same number.
fn patch(archive: &[u8], from: &[u8], to: &[u8]) -> Vec<u8> {
    assert_eq!(from.len(), to.len());
    let (mut out, mut found) = (archive.to_vec(), 0);
    for at in 0..=out.len() - from.len() {
        if out[at..].starts_with(from) {
            out[at..at + from.len()].copy_from_slice(to);
            found += 1;
        }
    }
    assert!(found > 0, "nothing to replace");
    out
}

#[test]
fn what_is_no_archive_is_named_so() {
    let end = "not a zip archive (invalid Zip archive: Could not find EOCD)";
    let again = "Export or copy it again";
    refused("inspect", b"", &format!("x.fmu is not a readable FMU: {end}. {again}"));
    refused("inspect", b"this is a letter", &format!("x.fmu is not a readable FMU: {end}. {again}"));
    let good = pack(&entries());
    refused("inspect", &good[..good.len() / 2], &format!("x.fmu is not a readable FMU: {end}. {again}"));
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::create_dir(dir.path().join("x.fmu")).unwrap();
    let message = "Error: × x.fmu is not a readable FMU: it is a folder, an FMU is a file: zip the folder's contents. \
                   Export or copy it again";
    assert_eq!(run(dir.path(), &["inspect", "x.fmu"]), (2, String::new(), message.to_owned()));
    let message = "Error: × cannot read y.fmu: No such file or directory (os error 2)";
    assert_eq!(run(dir.path(), &["inspect", "y.fmu"]), (2, String::new(), message.to_owned()));
}

#[test]
fn contents_that_were_damaged_on_the_way_are_noticed() {
    let good = pack(&vec![(XML.to_owned(), b"<a/>".to_vec()), ("resources/a".to_owned(), vec![b'x'; 1000])]);
    // The checksum in both headers, or a byte of the compressed file.
    let checksum = crc32(&[b'x'; 1000]);
    let message = "x.fmu is not a readable FMU: resources/a: Invalid checksum. Export or copy it again";
    refused("inspect", &patch(&good, &checksum, &[1, 2, 3, 4]), message);
    // A size in the headers that is not the real one: neither more nor less is written.
    let message = "x.fmu is not a readable FMU: resources/a: File is larger than its declared uncompressed size. \
                   Export or copy it again";
    let smaller = patch(&good, &[0xE8, 3, 0, 0], &[0xE7, 3, 0, 0]);
    refused("inspect", &smaller, message);
    let message = "x.fmu is not a readable FMU: resources/a: its size is not the one that the archive says. \
                   Export or copy it again";
    let larger = patch(&good, &[0xE8, 3, 0, 0], &[0xE8, 0xFF, 0, 0]);
    refused("inspect", &larger, message);
}

/// The checksum of zip archives, bit by bit, as it stands in their headers.
fn crc32(bytes: &[u8]) -> [u8; 4] {
    let mut crc = !0_u32;
    for byte in bytes {
        crc ^= u32::from(*byte);
        for _ in 0..8 {
            crc = (crc >> 1) ^ if crc & 1 == 1 { 0xEDB8_8320 } else { 0 };
        }
    }
    (!crc).to_le_bytes()
}

#[test]
fn paths_that_leave_the_folder() {
    for name in ["../escaped", "/escaped", "a/../../escaped", "C:/escaped", "a\\..\\..\\escaped", "./../a", "a/./../b"]
    {
        refused(
            "inspect",
            &plus(name, b"x"),
            &format!("x.fmu was refused, nothing was unpacked: the path {name} would write outside the FMU's folder"),
        );
    }
    // Escaped in the message, whatever the name holds.
    let message = "x.fmu was refused, nothing was unpacked: the path ../\\u{1b}[2J\\u{202e}a would write outside the \
                   FMU's folder";
    refused("inspect", &plus("../\u{1b}[2J\u{202e}a", b"x"), message);
}

#[test]
fn a_folder_that_is_listed_as_here() {
    let renamed = |to: &dyn Fn(&str) -> String| -> Vec<(String, Vec<u8>)> {
        entries().into_iter().map(|(name, content)| (to(&name), content)).collect()
    };
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    archive.add_directory("./", SimpleFileOptions::default()).unwrap();
    for (name, content) in renamed(&|name| format!("./{name}")) {
        archive.start_file(name, SimpleFileOptions::default()).unwrap();
        archive.write_all(&content).unwrap();
    }
    inspected(&archive.finish().unwrap().into_inner(), &[]);
    inspected(&plus("a/./b", b"x"), &[]);
    // What then has the same path is one file twice.
    let message = "x.fmu was refused, nothing was unpacked: it contains ./modelDescription.xml twice (also as \
                   modelDescription.xml)";
    refused("inspect", &plus("./modelDescription.xml", b"x"), message);
}

#[test]
fn links() {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in entries() {
        archive.start_file(name, SimpleFileOptions::default()).unwrap();
        archive.write_all(&content).unwrap();
    }
    archive.add_symlink("resources/link", "/etc/passwd", SimpleFileOptions::default()).unwrap();
    let message = "x.fmu was refused, nothing was unpacked: resources/link is a link, which could point outside the \
                   FMU's folder";
    refused("inspect", &archive.finish().unwrap().into_inner(), message);
}

#[test]
fn names_that_collide() {
    let reason = |text: &str| format!("x.fmu was refused, nothing was unpacked: {text}");
    let clash = plus("modelDescription.xmL", b"x");
    let twice = "it contains modelDescription.xmL twice (also as modelDescription.xml)";
    refused("inspect", &clash, &reason(twice));
    // The same name to the letter, which libraries hide by keeping one of the two.
    let same = patch(&clash, b"modelDescription.xmL", XML.as_bytes());
    refused("inspect", &same, &reason("two of its entries have the same name"));
    let both = "it contains documentation/index.html both as a file and as a folder";
    refused("inspect", &plus("documentation/index.html/a", b"x"), &reason(both));
    inspected(&plus("documentation/index.html.a/a", b"x"), &[]);
}

#[test]
fn names_that_no_file_system_takes() {
    let name = "n".repeat(256);
    let shown = |name: &str| {
        format!("x.fmu was refused, nothing was unpacked: the path {name} is longer than file systems take")
    };
    refused("inspect", &plus(&name, b"x"), &shown(&name));
    inspected(&plus(&name[1..], b"x"), &[]);
    let deep = "d/".repeat(1600) + "f";
    let start = &deep[..200];
    let end = &deep[deep.len() - 200..];
    refused("inspect", &plus(&deep, b"x"), &shown(&format!("{start} ... (2801 characters left out) ... {end}")));
    inspected(&plus(&("d/".repeat(1000) + "f"), b"x"), &[]);
}

#[test]
fn compression_and_encryption_that_fmus_must_not_use() {
    let reason = |text: &str| format!("x.fmu was refused, nothing was unpacked: {text}");
    let stored: Entries = vec![(XML.to_owned(), b"<a/>".to_vec())];
    let deflated = pack(&stored);
    // The method stands before the time (zero here) in both headers; 12 is bzip2.
    let at = |method: u8| [method, 0, 0, 0, 0x21, 0];
    let bzip2 = patch(&deflated, &at(8), &at(12));
    let text = "modelDescription.xml is compressed with Bzip2, FMUs may use Deflate only. Zip it again";
    refused("inspect", &bzip2, &reason(text));
    // Bit 0 of the flags, which stand before the method, says encrypted.
    let flags = |flags: u8| [flags, 0, 8, 0, 0, 0, 0x21, 0];
    let encrypted = patch(&deflated, &flags(0), &flags(1));
    let text = "modelDescription.xml is encrypted. Zip the FMU without a password";
    refused("inspect", &encrypted, &reason(text));
}

#[test]
fn archives_that_unpack_to_too_much() {
    let zeros = "x.fmu was refused, nothing was unpacked: resources/zeros unpacks to more than 1000 times its size";
    refused("inspect", &plus("resources/zeros", &vec![0; 20 << 20]), zeros);
    let dir = folder_with(&plus("resources/a", b"0123456789"));
    let path = dir.path().join("x.fmu");
    let fails = |limits| Fmu::open_with(&path, &limits).err().map(|e| e.to_string()).unwrap_or_default();
    let limits = ArchiveLimits::default();
    let refused = |why: &str| format!("{} was refused, nothing was unpacked: {why}", path.display());
    assert_eq!(fails(ArchiveLimits { total_bytes: 1000, ..limits }), refused("it unpacks to more than 0 MiB"));
    assert_eq!(fails(ArchiveLimits { entries: 3, ..limits }), refused("it has 4 entries, the limit is 3"));
    let large = refused("modelDescription.xml is larger than 0 MiB");
    assert_eq!(fails(ArchiveLimits { description_bytes: 1000, ..limits }), large);
    assert!(Fmu::open_with(&path, &ArchiveLimits { entries: 4, ..limits }).is_ok());
}

#[test]
fn more_entries_than_any_fmu_has() {
    let mut all = entries();
    all.extend((0..100_000).map(|i| (format!("resources/{i}"), Vec::new())));
    let message = "x.fmu was refused, nothing was unpacked: it has 100003 entries, the limit is 100000";
    refused("inspect", &pack(&all), message);
}

#[test]
fn entries_that_share_their_bytes() {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in entries() {
        archive.start_file(name, SimpleFileOptions::default()).unwrap();
        archive.write_all(&content).unwrap();
    }
    archive.shallow_copy_file(XML, "resources/again").unwrap();
    let message = "x.fmu was refused, nothing was unpacked: some of its entries share the same bytes, as in archives \
                   made to fill a disk";
    refused("inspect", &archive.finish().unwrap().into_inner(), message);
}

#[test]
fn a_missing_or_misplaced_description() {
    let without: Entries = entries().into_iter().filter(|(name, _)| name != XML).collect();
    let message = "x.fmu has no modelDescription.xml at its top level: this is a zip file, but not an FMU";
    refused("inspect", &pack(&without), message);
    let nested: Entries = entries().into_iter().map(|(name, c)| (format!("cell/{name}"), c)).collect();
    let message = "x.fmu has no modelDescription.xml at its top level, only cell/modelDescription.xml: zip the folder's \
                   contents, not the folder";
    refused("inspect", &pack(&nested), message);
    let other: Entries = entries().into_iter().map(|(n, c)| (n.replace("modelD", "ModelD"), c)).collect();
    let message = "x.fmu has no modelDescription.xml at its top level, only ModelDescription.xml: its name must be \
                   modelDescription.xml, in these letters";
    refused("inspect", &pack(&other), message);
}

#[test]
fn no_room_to_unpack_is_not_the_fmus_fault() {
    let dir = folder_with(&pack(&entries()));
    let mut command = crate::common::fmi_hazard(dir.path());
    let output = command.env("TMPDIR", "nowhere").args(["inspect", "x.fmu"]).output().unwrap();
    let text = crate::common::archives::flat(&String::from_utf8(output.stderr).unwrap());
    assert!(text.starts_with("Error: × cannot unpack x.fmu into nowhere: No such file or directory"), "{text}");
    assert!(text.ends_with(". Set the environment variable TMPDIR to a folder with room for it"), "{text}");
    assert_eq!(output.status.code(), Some(2));
}

#[test]
fn unpacked_files_are_removed_again() {
    fn unpacked_to(fmu: &Fmu) -> PathBuf {
        fmu.file(XML).unwrap().parent().unwrap().to_owned()
    }
    let fmu = Fmu::open(&test_fmus().join("faulty.fmu")).unwrap();
    let folder = unpacked_to(&fmu);
    assert!(folder.is_dir());
    let safe = |p: &Path| p.to_string_lossy().chars().all(|c| c.is_ascii_alphanumeric() || "-_/.".contains(c));
    assert!(safe(&folder), "{}", folder.display());
    drop(fmu);
    assert!(!folder.exists());
    // Also after an error on the way.
    let dir = folder_with(&with(XML, |_| b"<a/>".to_vec()));
    let temporary = tempfile::TempDir::new().unwrap();
    let mut command = crate::common::fmi_hazard(dir.path());
    command.env("TMPDIR", temporary.path()).args(["inspect", "x.fmu"]).assert().code(2);
    assert_eq!(std::fs::read_dir(temporary.path()).unwrap().count(), 0);
}
