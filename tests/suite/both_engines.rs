//! Something new in a cell does not compile before both engines say what they do with it.

use std::fs;
use std::path::Path;
use std::process::Command;

/// What each engine says it in.
const ENGINES: [&str; 2] = ["src/scan/from_start", "src/scan/reachability"];

/// A file, and what stands behind a line of it then.
const NEW: [(&str, &str, &str, &str); 7] = [
    (
        "a field of the cell",
        "crates/cell/src/cell/workcell.rs",
        "    pub pose: Vec<PoseQuantity>,\n",
        "    /// Another.\n    pub invented: bool,\n",
    ),
    (
        "a field of a sensor",
        "crates/cell/src/cell/sensor.rs",
        "    pub delay_steps: usize,\n",
        "    /// Another.\n    pub invented: bool,\n",
    ),
    (
        "a key of a sensor",
        "crates/cell/src/cell/file/format/surroundings.rs",
        "    pub kind: SensorKind,\n",
        "    /// Another.\n    #[serde(default)]\n    pub invented: bool,\n",
    ),
    (
        "a key of a person",
        "crates/cell/src/cell/file/format/person.rs",
        "    pub from: Option<PeopleFrom>,\n",
        "    /// Another.\n    #[serde(default)]\n    pub invented: bool,\n",
    ),
    (
        "a key of a control",
        "crates/cell/src/cell/file/format/surroundings.rs",
        "    pub by: ControlledBy,\n",
        "    /// Another.\n    #[serde(default)]\n    pub invented: bool,\n",
    ),
    (
        "a way to detect people",
        "crates/cell/src/cell/sensor/zone.rs",
        "pub enum DetectionZone {\n",
        "    /// Another.\n    Invented,\n",
    ),
    (
        "what a sensor does not see",
        "crates/cell/src/cell/sensor/kind.rs",
        "pub enum Unseen {\n",
        "    /// Another.\n    Invented,\n",
    ),
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

/// What the compiler says once the crates beneath the engines compile: where one of them has to say what it does with what is new, too, it
/// is given something to say.
fn answered_below(copied: &Path, target: &Path) -> (bool, String) {
    for _ in 0..10 {
        let (compiles, said) = checked(copied, target);
        let mut asked = false;
        // From the end, so that what stands before stays where it is.
        for line in said.lines().rev().filter(|line| line.starts_with("crates/")) {
            let [file, row, column, rest] = line.splitn(4, ':').collect::<Vec<_>>()[..] else { continue };
            let answer = match rest {
                _ if rest.contains("E0063") => " invented: Default::default(),",
                _ if rest.contains("E0004") => " _ => loop {},",
                _ => continue,
            };
            let path = copied.join(file);
            let text = fs::read_to_string(&path).unwrap();
            let before = text.lines().take(row.parse::<usize>().unwrap() - 1).map(|line| line.len() + 1).sum::<usize>();
            let at = before + column.parse::<usize>().unwrap() - 1;
            let behind = at + text[at..].find('{').unwrap() + 1;
            fs::write(&path, format!("{}{answer}{}", &text[..behind], &text[behind..])).unwrap();
            asked = true;
        }
        if !asked {
            return (compiles, said);
        }
    }
    panic!("the crates beneath the engines do not compile with what is new");
}

#[test]
#[ignore = "some minutes: it compiles the program eight times; nothing quicker shows what does not compile"]
fn what_is_new_in_a_cell_does_not_compile_before_both_say_what_they_do_with_it() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let dir = tempfile::tempdir().unwrap();
    let (copied, target) = (dir.path().join("copy"), dir.path().join("target"));
    for folder in ["src", "crates", "fmus", "benches", "research", "tests/house", "tests/sample"] {
        copy(&root.join(folder), &copied.join(folder));
    }
    for file in ["Cargo.toml", "Cargo.lock", "README.md", "clippy.toml"] {
        fs::copy(root.join(file), copied.join(file)).unwrap();
    }
    let (compiles, said) = checked(&copied, &target);
    assert!(compiles, "{said}");
    for (what, file, behind, new) in NEW {
        let path = copied.join(file);
        let text = fs::read_to_string(&path).unwrap();
        assert!(text.contains(behind), "{file} has no {behind}");
        fs::write(&path, text.replacen(behind, &format!("{behind}{new}"), 1)).unwrap();
        let (compiles, said) = answered_below(&copied, &target);
        assert!(!compiles, "{what} compiles");
        for engine in ENGINES {
            let asks = said.lines().any(|line| line.starts_with(engine) && line.contains("error"));
            assert!(asks, "{engine} is not asked for {what}:\n{said}");
        }
        copy(&root.join("crates"), &copied.join("crates"));
    }
}
