//! The flawed and the repaired cell of an example, changed alike so that every sequence of both is soon looked at.

use std::path::Path;

use serde_json::Value;

use super::{fmi_hazard, scan_json, write};

/// Both scanned; the results are in the folders `flawed` and `fixed`.
pub struct Pair {
    /// `scan.json` of the flawed cell.
    pub flawed: Value,
    /// What its scan printed, in one line.
    pub told: String,
    /// The file of the repaired cell.
    pub fixed: String,
}

impl Pair {
    /// With these changes, which leave the person so many actions: both scans are complete, the flawed cell has hazards, all of them
    /// confirmed, the repaired one has none.
    pub fn scanned(dir: &Path, example: &str, changes: &str, actions: u32) -> Self {
        let scan = |base: &str, out: &str, hazards: bool| {
            let file = format!("{example}/near-{out}.toml");
            write(dir, &file, &format!("extends = \"{base}\"\nname = \"near\"\n{changes}"));
            let arguments = ["scan", &file, "--strategy", "exhaustive", "--no-advice", "--out", out];
            let ran = fmi_hazard(dir).args(arguments).output().expect("the command runs");
            let told = in_one_line(&ran.stdout);
            assert_eq!(ran.status.code(), Some(i32::from(hazards)), "{told}{}", in_one_line(&ran.stderr));
            let report = scan_json(&dir.join(out));
            let certificate = &report["certificate"];
            assert!(certificate["complete"] == true && certificate["actions"] == actions, "{certificate}");
            let found = list(&report, "hazards");
            assert_eq!((found.is_empty(), list(&report, "causes").is_empty()), (!hazards, !hazards), "{told}");
            assert!(found.iter().all(|hazard| hazard["confirmed"] == true), "{told}");
            (report, told, file)
        };
        let (flawed, told, _) = scan("cell.toml", "flawed", true);
        let (_, _, fixed) = scan("fixed.toml", "fixed", false);
        Self { flawed, told, fixed }
    }

    /// The hazards of the flawed cell, the worst first.
    pub fn hazards(&self) -> &[Value] {
        list(&self.flawed, "hazards")
    }

    /// What is told of their causes, a sentence each.
    pub fn causes(&self) -> Vec<&str> {
        list(&self.flawed, "causes").iter().map(|cause| cause["sentence"].as_str().expect("a sentence")).collect()
    }

    /// What is told of the worst hazard and of what helps, in one line.
    pub fn worst_explained(&self, dir: &Path) -> String {
        let worst = self.hazards()[0]["id"].as_str().expect("a text");
        let arguments = ["explain", "flawed", worst, "--from", "start", "--max-states", "1000"];
        in_one_line(&fmi_hazard(dir).args(arguments).output().expect("the command runs").stdout)
    }
}

fn list<'a>(report: &'a Value, key: &str) -> &'a [Value] {
    report[key].as_array().expect("a list")
}

fn in_one_line(text: &[u8]) -> String {
    let text = String::from_utf8_lossy(text).replace('│', " ");
    text.split_whitespace().collect::<Vec<_>>().join(" ")
}
