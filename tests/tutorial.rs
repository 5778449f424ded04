//! The book: the commands of its tutorial are run as they stand, its reference is what the program writes, and its links lead
//! somewhere. Needs the Python environment that `tools/test` makes.
#![allow(clippy::unwrap_used, clippy::panic, reason = "a test fails by panicking")]

mod common;

use std::path::{Path, PathBuf};
use std::process::Command;

use common::fmi_hazard;
use common::fmpy::python;
use tempfile::TempDir;

fn book() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/src")
}

/// A block of code: what stands behind its fence, and its text.
fn blocks(page: &str) -> Vec<(Vec<&str>, String)> {
    let mut blocks = Vec::new();
    let mut open: Option<(Vec<&str>, String)> = None;
    for line in page.lines() {
        match (&mut open, line.strip_prefix("```")) {
            (None, Some(info)) => open = Some((info.split(',').collect(), String::new())),
            (Some(_), Some(_)) => blocks.extend(open.take()),
            (Some((_, text)), None) => {
                text.push_str(line);
                text.push('\n');
            }
            (None, None) => {}
        }
    }
    assert!(open.is_none(), "a block is not closed");
    blocks
}

/// Replaces the lines with `-` by those with `+`, as a reader does in an editor.
fn edit(file: &Path, diff: &str) {
    let of = |sign: char| -> String {
        diff.lines().filter_map(|line| line.strip_prefix(sign)).map(|line| format!("{line}\n")).collect()
    };
    let text = std::fs::read_to_string(file).unwrap();
    let (old, new) = (of('-'), of('+'));
    assert_eq!(text.matches(&old).count(), 1, "not there, or not once:\n{old}in\n{text}");
    std::fs::write(file, text.replace(&old, &new)).unwrap();
}

/// Python as a shared library, if this machine has it.
fn python_library() -> String {
    let tools = Path::new(env!("CARGO_MANIFEST_DIR")).join("tools");
    let program = "import exporter_zoo; print(exporter_zoo.python_library())";
    let output = Command::new(python()).args(["-c", program]).env("PYTHONPATH", tools).output().unwrap();
    String::from_utf8(output.stdout).unwrap().trim().to_owned()
}

#[test]
fn the_commands_of_the_tutorial_do_what_it_says() {
    let page = std::fs::read_to_string(book().join("tutorial.md")).unwrap();
    let library = python_library();
    if library.is_empty() {
        println!("NOT TESTED: this machine has no shared library of Python (install libpython3)");
        return;
    }
    let dir = TempDir::new().unwrap();
    let programs =
        [python().parent().unwrap().to_owned(), assert_cmd::cargo::cargo_bin("fmi-hazard").parent().unwrap().into()];
    let path =
        std::env::join_paths(programs.into_iter().chain(std::env::split_paths(&std::env::var_os("PATH").unwrap())));
    let path = path.unwrap();
    let fetched = python().parent().unwrap().join("../third-party/yourdfpy-0.0.60.tar.gz");
    let (mut commands, mut edits) = (0, 0);
    for (info, text) in blocks(&page) {
        let file = info.iter().find_map(|word| word.strip_prefix("file=")).map(|name| dir.path().join(name));
        match (info[0], file) {
            ("python", Some(file)) => std::fs::write(file, text).unwrap(),
            ("diff", Some(file)) => {
                edits += 1;
                edit(&file, &text);
            }
            ("sh", None) if info.contains(&"setup") => {}
            // What tools/test has fetched need not be fetched again.
            ("sh", None) if info.contains(&"download") && fetched.is_file() => {
                std::fs::copy(&fetched, dir.path().join("yourdfpy-0.0.60.tar.gz")).unwrap();
            }
            ("sh", None) => {
                let expected = info.iter().find_map(|word| word.strip_prefix("exit=")).unwrap_or("0");
                let trusted = info.contains(&"trusted");
                let script = text.replace("export LD_PRELOAD=libpython3.11.so.1.0\n", "");
                let mut shell = Command::new("bash");
                shell.args(["-euc", &script]).current_dir(dir.path()).env("PATH", &path).env("NO_COLOR", "1");
                if trusted {
                    shell.env("LD_PRELOAD", &library);
                }
                let output = shell.output().unwrap();
                let told =
                    [output.stdout, output.stderr].map(|said| String::from_utf8_lossy(&said).into_owned()).concat();
                assert_eq!(output.status.code().unwrap().to_string(), expected, "{text}{told}");
                for (command, words) in SAYS {
                    if text.contains(command) {
                        assert!(told.contains(words), "{command}: `{words}` is not in\n{told}");
                    }
                }
                commands += text.lines().count();
            }
            _ => {}
        }
    }
    assert!(commands >= 11 && edits >= 6, "{commands} commands, {edits} edits");
    for file in
        ["PandaCell.cell.check.svg", "first/report.html", "first/scan.json", "PandaCell-packed.fmu", "cell.schema.json"]
    {
        assert!(dir.path().join(file).is_file(), "{file}");
    }
}

/// What the tutorial promises of a command's output.
const SAYS: &[(&str, &str)] = &[
    ("inspect", "q1 ... q7 (7)"),
    ("probe", "S_PSE_Mat = false: stops it, at rest after 0.40 s, first change after 0.020 s"),
    ("init", "the cell file takes the kinematics only"),
    ("--no-run", "still to be filled in"),
    ("--no-run", "PandaCell.cell.toml: 8 problems"),
    ("check PandaCell.cell.toml --trust-fmu", "nothing wrong"),
    ("scan", "confirmed by a fresh replay"),
    ("replay", "reproduced"),
];

#[test]
fn the_reference_is_what_the_program_writes() {
    let dir = TempDir::new().unwrap();
    fmi_hazard(dir.path()).args(["manual", "--book", "reference"]).assert().code(0);
    for page in ["commands.md", "cell-file.md"] {
        let [written, committed] = [dir.path().join("reference"), book().join("reference")]
            .map(|folder| std::fs::read_to_string(folder.join(page)).unwrap());
        assert!(written == committed, "docs/src/reference/{page} is old: fmi-hazard manual --book docs/src/reference");
    }
}

/// All pages of a folder and below.
fn pages(folder: &Path) -> Vec<PathBuf> {
    let mut all = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap().flatten() {
        let path = entry.path();
        if path.is_dir() {
            all.extend(pages(&path));
        } else if path.extension().is_some_and(|e| e == "md") {
            all.push(path);
        }
    }
    all
}

#[test]
fn every_page_is_in_the_book_and_every_link_leads_to_one() {
    let summary = std::fs::read_to_string(book().join("SUMMARY.md")).unwrap();
    let all = pages(&book());
    assert!(all.len() > 10);
    for page in &all {
        let name = page.strip_prefix(book()).unwrap().to_str().unwrap();
        assert!(name == "SUMMARY.md" || summary.contains(&format!("({name})")), "{name} is not in SUMMARY.md");
        let text = std::fs::read_to_string(page).unwrap();
        for target in text.split("](").skip(1).map(|rest| rest.split(')').next().unwrap()) {
            let target = target.split('#').next().unwrap();
            let outside = target.is_empty() || target.contains("://");
            assert!(outside || page.parent().unwrap().join(target).is_file(), "{name}: {target} leads nowhere");
        }
    }
}

#[test]
fn cell_files_in_the_book_are_cell_files() {
    // Excerpts: each has to be TOML, and its keys have to be those of cell files.
    let schema = fmi_hazard::cell::json_schema();
    let tables = schema["$defs"].as_object().unwrap().values().chain([&schema]);
    let keys: Vec<&String> =
        tables.filter_map(|table| table["properties"].as_object()).flat_map(serde_json::Map::keys).collect();
    for page in pages(&book()) {
        let text = std::fs::read_to_string(&page).unwrap();
        for (info, block) in blocks(&text) {
            if info[0] == "toml" {
                let table: toml::Table = block.parse().unwrap_or_else(|e| panic!("{}: {e}\n{block}", page.display()));
                for key in table.keys() {
                    assert!(keys.contains(&key), "{}: cell files have no `{key}`", page.display());
                }
            }
        }
    }
}
