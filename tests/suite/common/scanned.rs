//! Scans of hostile FMUs in a place of their own: whatever an FMU does there, afterwards no process and no file of it is
//! left.

use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};
use std::time::{Duration, Instant};

use serde_json::Value;
use tempfile::TempDir;

use super::hostile::{CELL, FMU, Hostile};
use super::stored::scanned;
use super::{json, nearer};

/// A folder to work in, with an FMU and its cell, and one for temporary files.
pub struct Place {
    root: TempDir,
}

/// What a command left behind.
#[derive(Debug)]
pub struct Ran {
    pub code: Option<i32>,
    pub stdout: Vec<u8>,
    /// In one line, without decoration.
    pub stderr: String,
    /// Whether it was told that the FMU keeps it waiting, which depends on the machine and is left out of the above.
    pub waited: bool,
    /// scan.json and run.json; null if there are none.
    pub scan: Value,
    pub run: Value,
    /// fmu.log.
    pub log: Option<Vec<u8>>,
}

impl Place {
    /// With this FMU. Its robot is longer and nearer to the person than in other tests, so that it hurts, and the mat
    /// covers one way to it only.
    pub fn new(hostile: &Hostile) -> Self {
        let place = Self { root: TempDir::new().expect("a temporary folder") };
        std::fs::create_dir(place.work()).expect("a folder can be made");
        std::fs::create_dir(place.temporary()).expect("a folder can be made");
        hostile.write(&place.work());
        let cell = std::fs::read_to_string(place.work().join(CELL)).expect("the cell is there");
        std::fs::write(place.work().join(CELL), nearer(&cell)).expect("a file can be written");
        place
    }

    /// The working folder.
    pub fn work(&self) -> PathBuf {
        self.root.path().join("work")
    }

    /// The cell file.
    pub fn cell(&self) -> PathBuf {
        self.work().join(CELL)
    }

    /// A file that a well guarded FMU cannot write.
    pub fn outside(&self) -> PathBuf {
        self.root.path().join("outside")
    }

    /// The folder for temporary files.
    pub fn temporary(&self) -> PathBuf {
        self.root.path().join("temporary")
    }

    /// The command, in this place.
    pub fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_fmi-hazard"));
        command.args(arguments).current_dir(self.work()).env("TMPDIR", self.temporary()).env("NO_COLOR", "1");
        command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped());
        command
    }

    /// Arguments of a scan, by tree search unless told otherwise.
    pub fn scan_arguments<'a>(more: &[&'a str]) -> Vec<&'a str> {
        let strategy = if more.contains(&"--strategy") { &[][..] } else { &["--strategy", "mcts-dpw"] };
        [&["scan", "--no-advice", CELL], strategy, more, &["--out", "out"]].concat()
    }

    /// What such a scan says, made once for all tests: of an FMU that does no harm.
    pub fn known(&self, more: &[&str]) -> Ran {
        let ran = scanned(&self.work(), &Self::scan_arguments(more)[1..]);
        self.results(ran.code, ran.stdout.into_bytes(), &ran.stderr)
    }

    /// Scans, and looks that nothing is left.
    pub fn scan(&self, more: &[&str]) -> Ran {
        self.after(self.command(&Self::scan_arguments(more)).output().expect("the command runs"))
    }

    /// What a command that has ended left behind: files where they belong, nothing else.
    pub fn after(&self, output: Output) -> Ran {
        self.nobody_left();
        assert_eq!(names(&self.temporary()), Vec::<String>::new(), "temporary files are left");
        let said = String::from_utf8_lossy(&output.stderr).into_owned();
        let ran = self.results(output.status.code(), output.stdout, &said);
        let work = names(&self.work());
        let work: Vec<&str> = work.iter().map(String::as_str).filter(|name| *name != "out").collect();
        assert_eq!(work, [FMU, CELL], "the FMU wrote a file");
        for name in names(&self.work().join("out")) {
            let ours = [
                "report.html",
                "scan.json",
                "causes.csv",
                "hazards.csv",
                "junit.xml",
                "hazards.sarif",
                "hazards.jsonl",
                "run.json",
                "fmu.log",
            ];
            let ours = ours.contains(&name.as_str());
            // What is needed to go on is left by scans that have not ended.
            let rest =
                ran.code != Some(0) && ran.code != Some(1) && ["resume.json", "answers.bin"].contains(&name.as_str());
            let of_hazard = [".svg", ".inputs.csv", ".outputs.csv"].iter().any(|end| name.ends_with(end));
            assert!(ours || rest || (name.starts_with("H-") && of_hazard), "{name}: {ran:?}");
        }
        ran
    }

    fn results(&self, code: Option<i32>, stdout: Vec<u8>, said: &str) -> Ran {
        let out = self.work().join("out");
        let read = |name: &str| if out.join(name).exists() { json(&out.join(name)) } else { Value::Null };
        let (waiting, others): (Vec<&str>, Vec<&str>) =
            said.lines().partition(|line| line.starts_with("  trying out "));
        let text = others.join(" ").replace(['│', '×'], " ");
        Ran {
            code,
            stdout,
            stderr: text.split_whitespace().collect::<Vec<_>>().join(" "),
            waited: !waiting.is_empty(),
            scan: read("scan.json"),
            run: read("run.json"),
            log: std::fs::read(out.join("fmu.log")).ok(),
        }
    }

    /// Processes of this place: those that were told its folder for temporary files, and those that are in it.
    pub fn processes(&self) -> Vec<String> {
        let place = self.root.path().to_string_lossy().into_owned();
        let mut found = Vec::new();
        for process in std::fs::read_dir("/proc").expect("/proc is there").flatten() {
            let path = process.path();
            let told = std::fs::read(path.join("environ")).unwrap_or_default();
            let at = std::fs::read_link(path.join("cwd")).unwrap_or_default();
            let told = String::from_utf8_lossy(&told).contains(&place);
            if told || at.starts_with(&place) {
                found.push(process.file_name().to_string_lossy().into_owned());
            }
        }
        found
    }

    /// Waits for processes that were just killed; they need not wait for a slow machine.
    pub fn nobody_left(&self) {
        let began = Instant::now();
        while began.elapsed() < Duration::from_secs(60) {
            if self.processes().is_empty() {
                return;
            }
            std::thread::sleep(Duration::from_millis(5));
        }
        panic!("processes are left: {:?}", self.processes());
    }
}

fn names(dir: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(dir).into_iter().flatten().flatten();
    let mut names: Vec<String> = entries.map(|entry| entry.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

impl Ran {
    /// Identities of the hazards.
    pub fn hazards(&self) -> Vec<&str> {
        self.scan["hazards"].as_array().unwrap().iter().map(|h| h["id"].as_str().unwrap()).collect()
    }

    /// Messages of the faults and lengths of their sequences.
    pub fn faults(&self) -> Vec<(&str, usize)> {
        let faults = self.scan["faults"].as_array().unwrap().iter();
        faults.map(|f| (f["message"].as_str().unwrap(), f["actions"].as_array().unwrap().len())).collect()
    }

    /// All hazards were confirmed.
    pub fn confirmed(&self) -> bool {
        self.scan["hazards"].as_array().unwrap().iter().all(|h| h["confirmed"] == true)
    }

    /// How states were brought back.
    pub fn rung(&self) -> &str {
        self.run["states_by"].as_str().unwrap()
    }

    /// Workers that were replaced.
    pub fn replaced(&self) -> u64 {
        self.run["fmu"]["workers_replaced"].as_u64().unwrap()
    }

    /// What a scan says about the cell, and nothing about the FMU's promises.
    pub fn findings(&self) -> [Value; 3] {
        [self.scan["hazards"].clone(), self.scan["coverage"].clone(), self.scan["faults"].clone()]
    }
}
