//! Scans that are made once: whoever asks first makes one, all others get what came of it, in this run of the tests and in later ones
//! of the same program. For tests that look at what a scan says; those about scanning itself run their own.
//!
//! Results lie below `target/scans/`, in a folder of the program that made them, by what was scanned: the arguments, and all files in the
//! folder but results. They hold nothing of where or when they were made that a test may ask for.

use std::fs::{self, File};
use std::path::{Path, PathBuf};
use std::process::ExitStatus;
use std::sync::LazyLock;

use rustix::fs::{FlockOperation, flock};
use sha2::{Digest as _, Sha256};

use super::fmi_hazard;

/// What a command said, as `std::process::Output` has it.
pub struct Scanned {
    pub code: Option<i32>,
    pub stdout: String,
    pub stderr: String,
    /// Now, and not before.
    pub made: bool,
}

/// Runs `fmi-hazard scan` in `dir` with these arguments, the last two of which are `--out` and a folder there, unless that was done before.
pub fn scanned(dir: &Path, arguments: &[&str]) -> Scanned {
    let [.., "--out", out] = arguments else { panic!("the last arguments are `--out` and a folder: {arguments:?}") };
    let kept = PROGRAM.join(key(dir, arguments));
    fs::create_dir_all(&*PROGRAM).expect("a folder can be made");
    // Whoever comes while it is made waits for it.
    let lock = File::create(kept.with_extension("lock")).expect("a file can be made");
    flock(&lock, FlockOperation::LockExclusive).expect("a file can be locked");
    let made = !kept.is_dir();
    if made {
        let ran = fmi_hazard(dir).arg("scan").args(arguments).output().expect("the command runs");
        // What was ended from outside says nothing of the next one.
        if ran.status.code().is_none_or(|code| code > 4) {
            let [stdout, stderr] = [ran.stdout, ran.stderr].map(|text| String::from_utf8_lossy(&text).into_owned());
            return Scanned { code: ran.status.code(), stdout, stderr, made };
        }
        let making = tempfile::tempdir_in(&*PROGRAM).expect("a folder can be made");
        copy(&dir.join(out), &making.path().join("out"));
        let said = [code(ran.status).to_string().into_bytes(), ran.stdout, ran.stderr];
        for (name, bytes) in NAMES.iter().zip(said) {
            fs::write(making.path().join(name), bytes).expect("a file can be written");
        }
        fs::rename(making.keep(), &kept).expect("a folder can be renamed");
    } else {
        copy(&kept.join("out"), &dir.join(out));
    }
    let [code, stdout, stderr] =
        NAMES.map(|name| String::from_utf8_lossy(&fs::read(kept.join(name)).expect("it was written")).into_owned());
    Scanned { code: code.parse().ok().filter(|code| *code >= 0), stdout, stderr, made }
}

const NAMES: [&str; 3] = ["code", "stdout", "stderr"];

fn code(status: ExitStatus) -> i32 {
    status.code().unwrap_or(-1)
}

/// The folder of this program's results; those of earlier ones are gone.
static PROGRAM: LazyLock<PathBuf> = LazyLock::new(|| {
    let program = Path::new(env!("CARGO_BIN_EXE_fmi-hazard"));
    let all = program.ancestors().nth(2).expect("it lies below target/").join("scans");
    let own = all.join(hex(Sha256::digest(fs::read(program).expect("the program is built")).as_slice()));
    if !own.is_dir() {
        // Another process may just have begun to keep what this program gives.
        for old in fs::read_dir(&all).into_iter().flatten().flatten().filter(|old| old.path() != own) {
            let _ = fs::remove_dir_all(old.path());
        }
    }
    own
});

/// By what is scanned: the arguments, and all files in the folder, of which links lead to none.
fn key(dir: &Path, arguments: &[&str]) -> String {
    let mut all = Sha256::new();
    let mut add = |bytes: &[u8]| {
        all.update(bytes.len().to_le_bytes());
        all.update(bytes);
    };
    arguments.iter().for_each(|argument| add(argument.as_bytes()));
    for file in files(dir) {
        add(file.strip_prefix(dir).expect("it is in there").as_os_str().as_encoded_bytes());
        add(&fs::read(&file).expect("a file can be read"));
    }
    hex(all.finalize().as_slice())
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().map(|byte| format!("{byte:02x}")).collect()
}

/// All files below a folder, sorted, but for results of scans.
fn files(dir: &Path) -> Vec<PathBuf> {
    let mut entries: Vec<PathBuf> = fs::read_dir(dir).expect("a folder").flatten().map(|entry| entry.path()).collect();
    entries.sort();
    let is_result = entries.iter().any(|entry| entry.ends_with("run.json"));
    if is_result {
        return Vec::new();
    }
    entries.into_iter().flat_map(|entry| if entry.is_dir() { files(&entry) } else { vec![entry] }).collect()
}

fn copy(from: &Path, to: &Path) {
    let Ok(entries) = fs::read_dir(from) else { return };
    fs::create_dir_all(to).expect("a folder can be made");
    for entry in entries.flatten() {
        let (path, to) = (entry.path(), to.join(entry.file_name()));
        if path.is_dir() {
            copy(&path, &to);
        } else {
            fs::copy(&path, &to).expect("a file can be copied");
        }
    }
}
