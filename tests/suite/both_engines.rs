//! Something new in a cell does not compile before both engines say what they do with it.

use std::fs;
use std::path::Path;
use std::process::Command;

/// What each engine says it in.
const ENGINES: [&str; 2] = ["src/scan/from_start", "src/scan/anywhere"];

/// A file, and what stands behind a line of it then.
const NEW: [(&str, &str, &str, &str); 6] = [
    ("a field of the cell", "src/cell/workcell.rs", "    pub pose: Vec<PoseQuantity>,\n", "    pub invented: bool,\n"),
    ("a field of a sensor", "src/cell/workcell.rs", "    pub delay_steps: usize,\n", "    pub invented: bool,\n"),
    (
        "a key of a sensor",
        "src/cell/file/format/surroundings.rs",
        "    pub kind: SensorKind,\n",
        "    #[serde(default)]\n    pub invented: bool,\n",
    ),
    (
        "a key of a person",
        "src/cell/file/format/person.rs",
        "    pub from: Option<PeopleFrom>,\n",
        "    #[serde(default)]\n    pub invented: bool,\n",
    ),
    (
        "a key of a control",
        "src/cell/file/format/surroundings.rs",
        "    pub by: ControlledBy,\n",
        "    #[serde(default)]\n    pub invented: bool,\n",
    ),
    ("a kind of sensor", "src/cell/workcell.rs", "pub enum Zone {\n", "    /// Another.\n    Invented,\n"),
];

fn copy(from: &Path, to: &Path) {
    fs::create_dir_all(to).unwrap();
    for entry in fs::read_dir(from).unwrap().flatten() {
        let (here, there) = (entry.path(), to.join(entry.file_name()));
        if here.is_dir() {
            copy(&here, &there);
        } else {
            fs::copy(here, there).unwrap();
        }
    }
}

/// What the compiler says.
fn checked(crate_of: &Path, target: &Path) -> (bool, String) {
    let cargo = Command::new(env!("CARGO"))
        .args(["check", "--lib", "--offline", "--quiet", "--message-format", "short"])
        .current_dir(crate_of)
        .env("CARGO_TARGET_DIR", target)
        .env_remove("RUSTFLAGS")
        .output()
        .unwrap();
    (cargo.status.success(), String::from_utf8_lossy(&cargo.stderr).into_owned())
}

#[test]
#[ignore = "some minutes: it compiles the program seven times; nothing quicker shows what does not compile"]
fn what_is_new_in_a_cell_does_not_compile_before_both_say_what_they_do_with_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dir = tempfile::tempdir().unwrap();
    let (copied, target) = (dir.path().join("copy"), dir.path().join("target"));
    for folder in ["src", "fmus", "scenarios", "benches"] {
        copy(&root.join(folder), &copied.join(folder));
    }
    for file in ["Cargo.toml", "Cargo.lock", "build.rs", "README.md", "clippy.toml"] {
        fs::copy(root.join(file), copied.join(file)).unwrap();
    }
    let (compiles, said) = checked(&copied, &target);
    assert!(compiles, "{said}");
    for (what, file, behind, new) in NEW {
        let path = copied.join(file);
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains(behind), "{file} has no {behind}");
        fs::write(&path, text.replacen(behind, &format!("{behind}{new}"), 1)).unwrap();
        let (compiles, said) = checked(&copied, &target);
        assert!(!compiles, "{what} compiles");
        for engine in ENGINES {
            let asks = said.lines().any(|line| line.starts_with(engine) && line.contains("error"));
            assert!(asks, "{engine} is not asked for {what}:\n{said}");
        }
        fs::write(&path, text).unwrap();
    }
}
