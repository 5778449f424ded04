//! FMU files that are damaged, hostile or of the wrong kind: refused with a clear message before they can do harm.
//! Each is made here from the working test FMU by one change.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::io::{Cursor, Read as _, Write as _};
use std::path::{Path, PathBuf};

use common::{fmi_hazard, test_fmus};
use fmi_hazard::fmi::{ArchiveLimits, Fmu};
use zip::write::SimpleFileOptions;

type Entries = Vec<(String, Vec<u8>)>;

const XML: &str = "modelDescription.xml";
const BINARY: &str = "binaries/linux64/faulty.so";

fn entries() -> Entries {
    let bytes = std::fs::read(test_fmus().join("faulty.fmu")).unwrap();
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

fn pack(entries: &Entries) -> Vec<u8> {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in entries {
        archive.start_file(name.as_str(), SimpleFileOptions::default()).unwrap();
        archive.write_all(content).unwrap();
    }
    archive.finish().unwrap().into_inner()
}

/// `bytes` as x.fmu; what `inspect` (reads) or `selftest` (loads) says about it on stderr. Exit code 2, no panic.
fn refused(command: &str, bytes: &[u8]) -> String {
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::write(dir.path().join("x.fmu"), bytes).unwrap();
    let output = fmi_hazard(dir.path()).args([command, "x.fmu"]).assert().code(2).get_output().clone();
    let text = String::from_utf8(output.stderr).unwrap();
    assert!(!text.contains("panicked"), "{text}");
    assert_eq!(std::fs::read_dir(dir.path()).unwrap().count(), 1, "something was written beside it");
    text.replace(['│', '\n'], " ").split_whitespace().collect::<Vec<_>>().join(" ")
}

fn with_xml(change: impl Fn(&str) -> String) -> Vec<u8> {
    let mut all = entries();
    let xml = all.iter_mut().find(|(name, _)| name == XML).unwrap();
    let text = String::from_utf8(xml.1.clone()).unwrap();
    let changed = change(&text);
    assert_ne!(text, changed, "the change did nothing");
    xml.1 = changed.into_bytes();
    pack(&all)
}

fn with_binary(change: impl Fn(&[u8]) -> Vec<u8>) -> Vec<u8> {
    let mut all = entries();
    let binary = all.iter_mut().find(|(name, _)| name == BINARY).unwrap();
    binary.1 = change(&binary.1);
    pack(&all)
}

fn plus(name: &str, content: &[u8]) -> Vec<u8> {
    let mut all = entries();
    all.push((name.to_owned(), content.to_vec()));
    pack(&all)
}

#[test]
fn damaged_archives() {
    let good = pack(&entries());
    assert!(refused("inspect", b"").contains("not a"), "empty");
    assert!(refused("inspect", &good[..good.len() / 2]).contains("not a readable FMU"), "truncated");
    let mut flipped = good.clone();
    for byte in &mut flipped[2000..2100] {
        *byte ^= 0x55;
    }
    assert!(refused("inspect", &flipped).contains("not a readable FMU"), "bad checksum");
}

#[test]
fn paths_that_leave_the_folder_and_names_that_collide() {
    for name in ["../escaped", "/escaped", "a/../../escaped", "C:/escaped", "a\\..\\..\\escaped"] {
        assert!(refused("inspect", &plus(name, b"x")).contains("outside the FMU's folder"), "{name}");
    }
    assert!(refused("inspect", &plus("MODELDESCRIPTION.XML", b"x")).contains("twice"));
}

#[test]
fn links_are_refused() {
    let mut archive = zip::ZipWriter::new(Cursor::new(Vec::new()));
    for (name, content) in entries() {
        archive.start_file(name, SimpleFileOptions::default()).unwrap();
        archive.write_all(&content).unwrap();
    }
    archive.add_symlink("resources/link", "/etc/passwd", SimpleFileOptions::default()).unwrap();
    assert!(refused("inspect", &archive.finish().unwrap().into_inner()).contains("is a link"));
}

#[test]
fn archives_that_unpack_to_too_much() {
    assert!(refused("inspect", &plus("resources/zeros", &vec![0; 20 << 20])).contains("times its size"));
    let dir = tempfile::TempDir::new().unwrap();
    let path = dir.path().join("x.fmu");
    std::fs::write(&path, plus("resources/a", b"0123456789")).unwrap();
    let fails = |limits| Fmu::open_with(&path, &limits).err().map(|e| e.to_string()).unwrap_or_default();
    let limits = ArchiveLimits::default();
    assert!(fails(ArchiveLimits { total_bytes: 1000, ..limits }).contains("unpacks to more than"));
    assert!(fails(ArchiveLimits { entries: 2, ..limits }).contains("entries"));
    assert!(Fmu::open(&path).is_ok());
}

#[test]
fn a_missing_or_nested_description() {
    let without: Entries = entries().into_iter().filter(|(name, _)| name != XML).collect();
    assert!(refused("inspect", &pack(&without)).contains("no modelDescription.xml"));
    let nested: Entries = entries().into_iter().map(|(name, c)| (format!("cell/{name}"), c)).collect();
    assert!(refused("inspect", &pack(&nested)).contains("zip the folder's contents"));
}

#[test]
fn other_versions_and_kinds() {
    let version = |v: &str| with_xml(|x| x.replace("fmiVersion=\"2.0\"", &format!("fmiVersion=\"{v}\"")));
    assert!(refused("inspect", &version("1.0")).contains("FMI 1.0 FMU; FMI 2.0 co-simulation is needed"));
    assert!(refused("inspect", &version("3.1-beta.1")).contains("FMI 3.1-beta.1 FMU, a version"));
    assert!(refused("inspect", &version("3.0")).contains("`instantiationToken` is missing"));
    let exchange =
        with_xml(|x| x.replace("<CoSimulation", "<ModelExchange").replace("</CoSimulation", "</ModelExchange"));
    assert!(refused("inspect", &exchange).contains("no co-simulation interface"));
    let broken = with_xml(|x| x.replace("</ModelVariables>", ""));
    assert!(refused("inspect", &broken).contains("modelDescription.xml of x.fmu, line"));
    let doctype =
        with_xml(|x| x.replace("<fmiModelDescription", "<!DOCTYPE a [<!ENTITY b \"c\">]><fmiModelDescription"));
    assert!(refused("inspect", &doctype).contains("DOCTYPE"));
    let shell = with_xml(|x| x.replace("modelIdentifier=\"faulty\"", "modelIdentifier=\"../../tmp/x\""));
    assert!(refused("inspect", &shell).contains("not a C identifier"));
}

#[test]
fn binaries_that_cannot_be_loaded() {
    let windows: Entries = entries().into_iter().map(|(n, c)| (n.replace("linux64", "win64"), c)).collect();
    assert!(refused("selftest", &pack(&windows)).contains("linux64 is needed, it contains win64"));
    let renamed: Entries = entries().into_iter().map(|(n, c)| (n.replace("faulty.so", "other.so"), c)).collect();
    assert!(refused("selftest", &pack(&renamed)).contains("has no faulty.so; it contains other.so"));
    assert!(refused("selftest", &with_binary(|_| b"MZ not a library".to_vec())).contains("not a shared library"));
    assert!(refused("selftest", &with_binary(|b| b[..b.len() / 2].to_vec())).contains("faulty.so cannot be loaded"));
    let elf32 = |b: &[u8]| [&b[..4], &[1], &b[5..]].concat();
    assert!(refused("selftest", &with_binary(elf32)).contains("32-bit"));
    // e_machine at offset 18: 0xB7 is AArch64.
    let arm = |b: &[u8]| [&b[..18], &[0xB7, 0], &b[20..]].concat();
    assert!(refused("selftest", &with_binary(arm)).contains("another processor"));
}

#[test]
fn a_guid_that_does_not_fit_is_explained_with_the_fmus_own_words() {
    let xml = with_xml(|x| {
        let start = x.find("guid=\"").unwrap() + 6;
        let end = start + x[start..].find('"').unwrap();
        format!("{}wrong{}", &x[..start], &x[end..])
    });
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::write(dir.path().join("x.fmu"), xml).unwrap();
    let output = fmi_hazard(dir.path()).args(["selftest", "x.fmu"]).assert().code(3).get_output().clone();
    let text = String::from_utf8(output.stderr).unwrap();
    assert!(text.contains("different exports") && text.contains("last log lines"), "{text}");
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
}

/// A binary with the functions that are needed and a body for `fmi2DoStep`, compiled here.
fn binary_with_step(body: &str) -> Vec<u8> {
    let dir = tempfile::TempDir::new().unwrap();
    let source = format!(
        "#include <stdlib.h>\n#include <unistd.h>\n\
         void *fmi2Instantiate(void) {{ return malloc(1); }}\n\
         void fmi2FreeInstance(void *c) {{ free(c); }}\n\
         int fmi2SetupExperiment(void) {{ return 0; }}\n\
         int fmi2EnterInitializationMode(void) {{ return 0; }}\n\
         int fmi2ExitInitializationMode(void) {{ return 0; }}\n\
         int fmi2SetReal(void) {{ return 0; }}\nint fmi2SetBoolean(void) {{ return 0; }}\n\
         int fmi2GetReal(void *c, const unsigned *v, size_t n, double *x) {{ while (n--) x[n] = 1; return 0; }}\n\
         int fmi2DoStep(void) {{ {body} }}\n"
    );
    std::fs::write(dir.path().join("f.c"), source).unwrap();
    let status = std::process::Command::new("cc")
        .args(["-shared", "-fPIC", "-o", "f.so", "f.c"])
        .current_dir(dir.path())
        .status()
        .unwrap();
    assert!(status.success());
    std::fs::read(dir.path().join("f.so")).unwrap()
}

#[test]
fn an_fmu_that_kills_its_process_is_a_finding_and_not_a_crash_of_ours() {
    for (body, words) in
        [("*(volatile int *)0 = 1; return 0;", "SIGSEGV"), ("abort();", "SIGABRT"), ("exit(0);", "exit code 0")]
    {
        let library = binary_with_step(body);
        let dir = tempfile::TempDir::new().unwrap();
        std::fs::write(dir.path().join("x.fmu"), with_binary(|_| library.clone())).unwrap();
        let output = fmi_hazard(dir.path()).args(["selftest", "x.fmu"]).assert().code(3).get_output().clone();
        let text = String::from_utf8(output.stderr).unwrap();
        let text = text.replace(['│', '\n'], " ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(text.contains(words) && text.contains("first plain run"), "{text}");
    }
    // The same binary without a fault passes what it offers.
    let dir = tempfile::TempDir::new().unwrap();
    let library = binary_with_step("return 0;");
    std::fs::write(dir.path().join("x.fmu"), with_binary(|_| library.clone())).unwrap();
    fmi_hazard(dir.path()).args(["selftest", "x.fmu"]).assert().code(0);
}

#[test]
fn an_fmu_that_fails_on_the_way_leaves_valid_results_and_unevaluated_sequences() {
    let dir = tempfile::TempDir::new().unwrap();
    let library = binary_with_step("static int n; return ++n > 1500 ? 3 : 0;");
    std::fs::write(dir.path().join("x.fmu"), with_binary(|_| library.clone())).unwrap();
    let cell = common::faulty_cell("x.fmu", 0, 0).replace("[parameters]\n\"fault.kind\" = 0\n\"fault.step\" = 0\n", "");
    common::write(dir.path(), "cell.toml", &cell.replace("iterations = 12", "iterations = 400"));
    let output =
        fmi_hazard(dir.path()).args(["scan", "cell.toml", "--strategy", "mcts-dpw", "--out", "o"]).output().unwrap();
    let scan = common::scan_json(&dir.path().join("o"));
    assert!(scan["coverage"]["episodes_not_evaluated"].as_u64().unwrap() > 0, "{}", scan["coverage"]);
    assert!(scan["faults"][0]["message"].as_str().unwrap().contains("fmi2DoStep"), "{}", scan["faults"]);
    assert!(!scan["faults"][0]["actions"].as_array().unwrap().is_empty());
    let expected = if scan["hazards"].as_array().unwrap().is_empty() { 3 } else { 1 };
    assert_eq!(output.status.code(), Some(expected), "{}", String::from_utf8_lossy(&output.stderr));
}
