//! FMUs made by exporters that nobody here wrote, in FMI 2.0 and FMI 3.0: opened, loaded, simulated with moving inputs, and
//! every output compared with FMPy's bit by bit. Needs the Python environment that `tools/test` makes.

use std::path::PathBuf;
use std::process::Command;
use std::sync::OnceLock;

use crate::common::archives::run;
use crate::common::fmpy::{compare_lenient, python};
use crate::common::test_fmus;
use fmi_hazard::fmi::Fmu;
use tempfile::TempDir;

/// Set in a process of this test that has Python's library loaded.
const PREPARED: &str = "FMI_HAZARD_ZOO";

/// The folder of the FMUs, made once, and Python's library.
fn zoo() -> (PathBuf, String) {
    static ZOO: OnceLock<(TempDir, String)> = OnceLock::new();
    if let Some(folder) = std::env::var_os(PREPARED) {
        return (folder.into(), String::new());
    }
    let (folder, library) = ZOO.get_or_init(|| {
        let folder = TempDir::new().unwrap();
        let script = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("tools/exporter_zoo.py");
        let output = Command::new(python()).arg(script).arg(folder.path()).arg(test_fmus()).output().unwrap();
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        assert!(output.status.success(), "{text}{}", String::from_utf8_lossy(&output.stderr));
        let library = text.strip_suffix('\n').unwrap_or(&text).rsplit('\n').next().unwrap_or_default().to_owned();
        (folder, library)
    });
    (folder.path().to_owned(), library.clone())
}

#[test]
fn containers_of_other_fmus() {
    let (folder, _) = zoo();
    for (name, version, tool) in
        [("container2.fmu", "2.0", "FMUContainer-2.0"), ("container3.fmu", "3.0", "FMUContainer-2.0")]
    {
        let path = folder.join(name);
        let fmu = Fmu::open(&path).unwrap();
        assert_eq!(fmu.description().fmi_version, version);
        assert_eq!(fmu.description().generation_tool.as_deref(), Some(tool));
        compare_lenient(TempDir::new().unwrap().path(), &path);
    }
}

#[test]
fn fmus_written_in_python_say_what_they_need() {
    let (folder, _) = zoo();
    for name in ["joint2.fmu", "joint3.fmu"] {
        let (code, _, stderr) = run(&folder, &["inspect", "--self-test", name]);
        let text = format!("Error: × {name}: the binary of this FMU cannot be loaded: ");
        assert!(stderr.starts_with(&text) && stderr.contains("undefined symbol: "), "{stderr}");
        assert!(
            stderr.contains(". It is written in Python and needs Python's library: start this program with"),
            "{stderr}"
        );
        assert_eq!(code, 2);
    }
}

#[test]
fn fmus_written_in_python_run_once_they_have_it() {
    let (folder, library) = zoo();
    if std::env::var_os(PREPARED).is_some() {
        for (name, tool) in [("joint2.fmu", "PythonFMU 0.7.0"), ("joint3.fmu", "PythonFMU3 0.3.4")] {
            let path = folder.join(name);
            assert_eq!(Fmu::open(&path).unwrap().description().generation_tool.as_deref(), Some(tool));
            compare_lenient(TempDir::new().unwrap().path(), &path);
        }
        return;
    }
    if library.is_empty() {
        println!(
            "this machine has no shared library of Python: FMUs written in Python are not run (install libpython3)"
        );
        return;
    }
    // The same test again, in a process that has the library: it must be there before anything else is loaded.
    let again = Command::new(std::env::current_exe().unwrap())
        .args(["--exact", "exporter_zoo::fmus_written_in_python_run_once_they_have_it", "--nocapture"])
        .env("LD_PRELOAD", &library)
        .env(PREPARED, &folder)
        .output()
        .unwrap();
    let text = String::from_utf8_lossy(&again.stdout).into_owned();
    assert!(again.status.success(), "{text}{}", String::from_utf8_lossy(&again.stderr));
    assert!(text.contains("1 passed"), "{text}");
}
