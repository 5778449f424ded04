//! README and book: their commands are those of the program, and are run as they stand (those that take long in `tools/test --all`), the
//! reference is what the program writes, and links lead somewhere. Needs the Python environment that `tools/test` makes.
//!
//! A page about an example is that example's README, which mdBook includes: so does [`text_of`], through which every page is read.
//!
//! What stands behind the fence of a block says how it is run: `exit=1` (the exit code; 0 or 1 otherwise), `trusted` (with
//! Python's library), `setup` and `download` (not run again), `file=NAME` (the block is that file, or a change of it).

use std::ffi::OsString;
use std::path::{Path, PathBuf};
use std::process::Command;

use crate::common::fmpy::python;
use crate::common::from_start::path_with_program;
use crate::common::{fmi_hazard, scan_json};
use crate::sample;
use serde_json::Value;
use tempfile::TempDir;

fn book() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("docs/src")
}

/// A line with which mdBook includes a file: its path from the page.
fn included(line: &str) -> Option<&str> {
    line.strip_prefix("{{#include ")?.strip_suffix("}}")
}

/// A page as the book shows it, with the files that it includes.
fn text_of(page: &Path) -> String {
    let read = |path: &Path| std::fs::read_to_string(path).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
    let folder = page.parent().unwrap();
    let mut text = String::new();
    for line in read(page).lines() {
        match included(line) {
            Some(file) => text.push_str(&read(&folder.join(file))),
            None => text.extend([line, "\n"]),
        }
    }
    assert!(text.starts_with("# ") && text.len() > 200, "{} says nothing:\n{text}", page.display());
    assert!(
        !text.contains("{{#"),
        "{}: only lines of their own, in pages alone, are taken as includes",
        page.display()
    );
    text
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

/// A folder in which a page is gone through.
struct Reader {
    dir: TempDir,
    _programs: TempDir,
    path: OsString,
    /// Longest time for a scan, and for an explanation: then it is interrupted, as by Ctrl-C.
    patience: Option<u32>,
    /// Changes of a page's commands that make them quick.
    quicker: &'static [(&'static str, &'static str)],
    commands: usize,
    edits: usize,
}

impl Reader {
    fn new(patience: Option<u32>) -> Self {
        let dir = TempDir::new().unwrap();
        let programs = TempDir::new().unwrap();
        let path = path_with_program(programs.path());
        let python = python().parent().unwrap().to_owned();
        let path = std::env::join_paths(std::iter::once(python).chain(std::env::split_paths(&path))).unwrap();
        Self { dir, _programs: programs, path, patience, quicker: &[], commands: 0, edits: 0 }
    }

    /// What a script tells, and its exit code.
    fn run(&mut self, script: &str, preload: Option<&str>) -> (i32, String) {
        let mut shell = Command::new("bash");
        shell.args(["-euc", script]).current_dir(self.dir.path()).env("PATH", &self.path).env("NO_COLOR", "1");
        if let Some(library) = preload {
            shell.env("LD_PRELOAD", library);
        }
        let output = shell.output().unwrap();
        self.commands += script.lines().count();
        let told = [output.stdout, output.stderr].map(|said| String::from_utf8_lossy(&said).into_owned()).concat();
        (output.status.code().unwrap(), told)
    }

    /// Each command of a block by itself.
    fn each(&mut self, text: &str) {
        for line in text.lines().filter(|line| !line.trim_start().starts_with('#')) {
            // What is built already is not built again, and what runs this need not run in it.
            let command = line.replace("cargo run --release -- ", "fmi-hazard ");
            if command.starts_with("tools/test") || command.starts_with("python tools/") {
                continue;
            }
            let long = ["fmi-hazard scan", "fmi-hazard explain", "fmi-hazard examples run"]
                .iter()
                .any(|c| command.starts_with(c));
            let within = |reader: &mut Self, seconds: u32| {
                reader.run(&format!("timeout --preserve-status --signal=INT {seconds} {command}"), None)
            };
            let (code, told) = match self.patience.filter(|_| long) {
                // On a machine that is busy a scan has not even begun by then, and leaves nothing.
                Some(seconds) => match within(self, seconds) {
                    (130, told) if !told.contains("Report  ") => within(self, 10 * seconds),
                    done => done,
                },
                None => self.run(&command, None),
            };
            // What ends early shows nothing, and neither does what compares it.
            let expected: &[i32] = if long { &[0, 1, 4, 130] } else { &[0, 1, 4] };
            assert!(expected.contains(&code), "{line}: {code}\n{told}");
        }
    }

    /// Goes through a page; `library` is Python's, for what needs it.
    fn read(&mut self, page: &str, library: &str) {
        let fetched = python().parent().unwrap().join("../third-party/yourdfpy-0.0.60.tar.gz");
        for (info, text) in blocks(page) {
            let named = |key: &str| info.iter().find_map(|word| word.strip_prefix(key));
            let file = named("file=").map(|name| self.dir.path().join(name));
            match (info[0], file) {
                ("diff", Some(file)) => {
                    self.edits += 1;
                    edit(&file, &text);
                }
                (_, Some(file)) => std::fs::write(file, text).unwrap(),
                ("sh", None) if info.contains(&"setup") => {}
                // What tools/test has fetched need not be fetched again.
                ("sh", None) if info.contains(&"download") && fetched.is_file() => {
                    std::fs::copy(&fetched, self.dir.path().join("yourdfpy-0.0.60.tar.gz")).unwrap();
                }
                ("sh", None) if self.patience.is_some() => self.each(&text),
                ("sh", None) => {
                    let expected = named("exit=").unwrap_or("0");
                    let mut script = text.replace("export LD_PRELOAD=libpython3.11.so.1.0\n", "");
                    for (old, new) in self.quicker {
                        script = script.replace(old, new);
                    }
                    let (code, told) = self.run(&script, info.contains(&"trusted").then_some(library));
                    assert_eq!(code.to_string(), expected, "{text}{told}");
                    for (command, words) in SAYS {
                        if script.contains(command) {
                            assert!(told.contains(words), "{command}: `{words}` is not in\n{told}");
                        }
                    }
                }
                _ => {}
            }
        }
    }
}

/// From an FMU and a URDF of others to a report.
#[test]
#[ignore = "half a minute: an FMU in Python is scanned; `exporter_zoo` runs such FMUs, `first_cell` the same commands"]
fn the_commands_of_the_tutorial_do_what_it_says() {
    let library = python_library();
    if library.is_empty() {
        println!("NOT TESTED: this machine has no shared library of Python (install libpython3)");
        return;
    }
    let mut reader = Reader::new(None);
    reader.read(&text_of(&book().join("tutorial.md")), &library);
    assert!(reader.commands >= 11 && reader.edits >= 6, "{} commands, {} edits", reader.commands, reader.edits);
    for file in
        ["PandaCell.cell.check.svg", "first/report.html", "first/scan.json", "PandaCell-packed.fmu", "cell.schema.json"]
    {
        assert!(reader.dir.path().join(file).is_file(), "{file}");
    }
}

/// From a scan to a summary that can be signed, as the page has it: what is told, and what is in the results. Sequences of four actions, and
/// no advice.
#[test]
fn the_commands_of_the_assessment_end_with_nothing_left() {
    let quicker = &[
        (
            "examples export cells\n",
            "examples export cells\nprintf '\\n[search]\\nactions = 4\\n' >> cells/heavy-workpiece/cell.toml\n",
        ),
        ("cell.toml --out out/before", "cell.toml --strategy exhaustive --no-advice --out out/before"),
    ];
    assessed(quicker);
}

/// The same as it stands, with what helps.
#[test]
#[ignore = "a minute: eight actions and advice; `the_commands_of_the_assessment_end_with_nothing_left` has four, `without_a_safeguard_the_speed_is_the_one_that_the_standard_allows` such advice"]
fn the_commands_of_the_assessment_tell_what_helps() {
    let before = assessed(&[]);
    let changes = before["causes"][0]["advice"]["changes"].as_array().unwrap();
    assert!(
        changes.iter().any(|change| change["change"] == "FMU parameter plc.v_limit = 0.2448 m/s instead of 0.48 m/s")
    );
}

/// Goes through the page of the assessment; its first scan.
fn assessed(quicker: &'static [(&'static str, &'static str)]) -> Value {
    let mut reader = Reader::new(None);
    reader.quicker = quicker;
    let page = text_of(&book().join("howto/assessment.md"));
    assert!(quicker.iter().all(|(old, _)| page.contains(old)), "the page is another one");
    reader.read(&page, "");
    let dir = reader.dir.path();
    let [before, after] = ["before", "after"].map(|name| scan_json(&dir.join("out").join(name)));
    assert_eq!((&before["causes"][0]["id"], before["causes"].as_array().unwrap().len()), (&"C-e203ea".into(), 1));
    assert_eq!((&after["verdict"], &after["certificate"]["complete"]), (&"none_found".into(), &true.into()));
    let report = std::fs::read_to_string(dir.join("out/before/report.html")).unwrap();
    assert!(report.contains("clamping at the stand assessed separately"));
    before
}

/// README and all pages but those that are gone through by themselves, and the reference.
fn other_pages() -> Vec<PathBuf> {
    let mut all = pages(&book());
    all.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md"));
    all.retain(|page| {
        !["tutorial.md", "assessment.md", "commands.md", "cell-file.md"].iter().any(|own| page.ends_with(own))
    });
    all.sort();
    all
}

/// Runs the commands of a page of which `runs` says so; how many it ran. What a reader brings along is there: an FMU with the robot's
/// description, and the cell file with its TODOs filled in.
fn gone_through(page: &Path, runs: impl Fn(&str) -> bool) -> usize {
    let text = text_of(page);
    let mut reader = Reader::new(Some(SECONDS));
    let dir = reader.dir.path().to_owned();
    fmi_hazard::examples::export(&dir.join("cells")).unwrap();
    let example = dir.join("cells/safety-fence");
    std::fs::copy(example.join("safety-fence.fmu"), dir.join("cell.fmu")).unwrap();
    std::fs::write(dir.join("robot.urdf"), URDF).unwrap();
    let those =
        |text: &str| -> String { text.lines().filter(|line| runs(line)).map(|line| format!("{line}\n")).collect() };
    for (info, block) in blocks(&text) {
        if let Some(file) = info.iter().find_map(|word| word.strip_prefix("file=")) {
            std::fs::write(dir.join(file), &block).unwrap();
        }
        if info[0] == "sh" && !info.contains(&"setup") {
            let (first, filled) = block.split_once("fmi-hazard check cell.cell.toml").unwrap_or((&block, ""));
            reader.each(&those(first));
            if !filled.is_empty() {
                let cell = std::fs::read_to_string(example.join("cell.toml")).unwrap();
                let cell = cell.replace("safety-fence.fmu", "cell.fmu");
                std::fs::write(dir.join("cell.cell.toml"), cell).unwrap();
                reader.each(&those(&format!("fmi-hazard check cell.cell.toml{filled}")));
            }
        }
    }
    reader.commands
}

/// All other pages. Scans are interrupted soon: what they find by then is what the commands behind them work on.
#[test]
#[ignore = "minutes: some thirty scans; one page of them is `the_commands_of_a_page_about_a_cell_run`"]
fn the_other_commands_of_readme_and_book_run() {
    let commands: usize = other_pages().iter().map(|page| gone_through(page, |_| true)).sum();
    assert!(commands > 30, "{commands}");
}

/// One page with a scan of a flawed cell and of the repaired one, what is different, and the known ways tried again.
#[test]
fn the_commands_of_a_page_about_a_cell_run() {
    if !sample::is_turn(5, 6) {
        return;
    }
    let commands = gone_through(&book().join("howto/light-curtain.md"), |_| true);
    assert!(commands >= 6, "{commands}");
}

/// Commands of README and book that take a second each; `first_cell` checks the examples as they are.
#[test]
fn the_quick_commands_of_readme_and_book_run() {
    if !sample::is_turn(3, 4) {
        return;
    }
    let quick = ["examples export", "inspect", "init", "check", "distance", "campaign plan"];
    let is_quick = |line: &str| {
        let example = line.starts_with("fmi-hazard check") && line.ends_with("/cell.toml");
        !example && quick.iter().any(|command| line.starts_with(&format!("fmi-hazard {command} ")))
    };
    let pages = other_pages().into_iter().filter(|page| !page.ends_with("light-curtain.md"));
    let commands: usize = pages.map(|page| gone_through(&page, is_quick)).sum();
    assert!(commands > 15, "{commands}");
}

/// Every command of README and book has the options and the values that the program knows: all that stands before `--help` is parsed.
#[test]
fn every_command_of_readme_and_book_is_understood() {
    let mut reader = Reader::new(None);
    let mut all = pages(&book());
    all.push(Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md"));
    let mut understood = 0;
    for page in all {
        for (info, block) in blocks(&text_of(&page)) {
            for line in block.lines().filter(|line| info[0] == "sh" && line.starts_with("fmi-hazard ")) {
                let (command, _) = line.split_once(" #").unwrap_or((line, ""));
                let (code, told) = reader.run(&format!("{} --help", command.trim_end()), None);
                assert!(code == 0 && told.contains("Usage: fmi-hazard"), "{}: {line}: {code}\n{told}", page.display());
                understood += 1;
            }
        }
    }
    assert!(understood > 60, "{understood}");
    for wrong in ["fmi-hazard scan cell.toml --strateg random", "fmi-hazard scan cell.toml --strategy randomly"] {
        assert_eq!(reader.run(&format!("{wrong} --help"), None).0, 2, "it can fail: {wrong}");
    }
}

/// Long enough for the quick part of a scan to find something.
const SECONDS: u32 = 3;

/// A robot with the six joints of the example.
const URDF: &str = r#"<robot name="arm">
<link name="base"/><link name="upper"/>
<joint name="joint_1" type="revolute"><parent link="base"/><child link="upper"/><axis xyz="0 0 1"/>
<limit lower="-3" upper="3" effort="1" velocity="1"/></joint></robot>"#;

/// What the tutorial promises of a command's output.
const SAYS: &[(&str, &str)] = &[
    ("inspect", "q1 ... q7 (7)"),
    ("inspect --run", "S_PSE_Mat = false: stops it, at rest after 0.40 s, first change after 0.020 s"),
    ("init", "the cell file takes the kinematics only"),
    ("--no-run", "still to be filled in"),
    ("--no-run", "PandaCell.cell.toml: 8 problems"),
    ("check PandaCell.cell.toml --trust-fmu", "nothing wrong"),
    ("scan PandaCell", "confirmed by a fresh replay"),
    ("replay first", "reproduced"),
    ("cell.toml --out out/before", "Tried in part: "),
    ("replay out/before --changed", "fixed"),
    ("--out out/after", "No sequence of actions is hazardous"),
    ("compare", "fixed"),
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

/// What links name the headings of a page: words joined by hyphens, as mdBook and GitHub do.
fn headings(text: &str) -> Vec<String> {
    let mut code = false;
    let is_heading = |line: &&str| {
        code ^= line.starts_with("```");
        !code && line.starts_with('#')
    };
    let named = |line: &str| {
        let kept = line.trim_start_matches('#').trim().chars().filter(|c| c.is_alphanumeric() || " -_".contains(*c));
        kept.collect::<String>().to_lowercase().replace(' ', "-")
    };
    text.lines().filter(is_heading).map(named).collect()
}

/// Where the links of a text lead: file, nothing for the text itself, and heading. Not those out of the book.
fn links(text: &str) -> Vec<(&str, Option<&str>)> {
    let targets = text.split("](").skip(1).map(|rest| rest.split(')').next().unwrap());
    let inside = targets.filter(|target| !target.contains("://"));
    inside
        .map(|target| target.split_once('#').map_or((target, None), |(file, heading)| (file, Some(heading))))
        .collect()
}

#[test]
fn every_page_is_in_the_book_and_every_link_leads_to_one() {
    let summary = text_of(&book().join("SUMMARY.md"));
    let all = pages(&book());
    assert!(all.len() > 10);
    for page in &all {
        let name = page.strip_prefix(book()).unwrap().to_str().unwrap();
        assert!(name == "SUMMARY.md" || summary.contains(&format!("({name})")), "{name} is not in SUMMARY.md");
        for (file, heading) in links(&text_of(page)) {
            let target = if file.is_empty() { page.clone() } else { page.parent().unwrap().join(file) };
            assert!(target.is_file(), "{name}: {file} leads nowhere");
            if let Some(heading) = heading {
                assert!(headings(&text_of(&target)).iter().any(|h| h == heading), "{name}: {file} has no #{heading}");
            }
        }
    }
}

/// Files of this repository that a page names, as they are written: from its root.
fn files_named(text: &str) -> impl Iterator<Item = &str> {
    let roots =
        ["src/", "crates/", "fmus/", "tests/", "tools/", "research/", "viewer/", "benches/", "docs/", "scenarios/"];
    let path = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    let quoted = text.split('`').skip(1).step_by(2);
    quoted.filter(move |of| roots.iter().any(|root| of.starts_with(root)) && of.chars().all(path))
}

#[test]
fn every_file_that_readme_and_book_name_is_there() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let others = ["README.md", "CONTRIBUTING.md", "SECURITY.md"].map(|file| root.join(file));
    let mut found = 0;
    for page in pages(&book()).into_iter().chain(others) {
        for file in files_named(&text_of(&page)) {
            assert!(root.join(file).exists(), "{}: there is no {file}", page.display());
            found += 1;
        }
    }
    assert!(found > 80, "{found}");
}

/// A page about an example is the README that is exported with it. There no other page is beside it.
#[test]
fn a_page_about_an_example_is_its_readme_and_needs_no_other_page() {
    let mut examples = 0;
    for page in pages(&book()) {
        let written = std::fs::read_to_string(&page).unwrap();
        let Some(file) = included(written.trim_end()) else { continue };
        let name = file.strip_prefix("../../../scenarios/").and_then(|rest| rest.strip_suffix("/README.md")).unwrap();
        let example = fmi_hazard::examples::by_name(name).unwrap();
        let (_, readme) = example.files.iter().find(|(file, _)| *file == "README.md").unwrap();
        let text = text_of(&page);
        assert!(text.as_bytes() == *readme, "{name}");
        assert!(links(&text).iter().all(|(file, _)| file.is_empty()), "{name}: links to {:?}", links(&text));
        for file in ["cell", "fixed"] {
            let scan = format!("\nfmi-hazard scan cells/{name}/{file}.toml");
            assert!(text.contains(&scan), "{name}: no command that scans {file}.toml");
        }
        examples += 1;
    }
    assert_eq!(examples, 6, "pages about examples");
}

#[test]
fn cell_files_in_the_book_are_cell_files() {
    // Excerpts: each has to be TOML, and its keys have to be those of cell files.
    let schema = fmi_hazard::cell::json_schema();
    let tables = schema["$defs"].as_object().unwrap().values().chain([&schema]);
    let keys: Vec<&String> =
        tables.filter_map(|table| table["properties"].as_object()).flat_map(serde_json::Map::keys).collect();
    for page in pages(&book()) {
        for (info, block) in blocks(&text_of(&page)) {
            if info[0] == "toml" {
                let table: toml::Table = block.parse().unwrap_or_else(|e| panic!("{}: {e}\n{block}", page.display()));
                for key in table.keys() {
                    assert!(keys.contains(&key), "{}: cell files have no `{key}`", page.display());
                }
            }
        }
    }
}
