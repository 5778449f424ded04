//! The pipelines of `docs/pipelines`, run as they stand there: the cell's own baseline, exit codes, and the files that the
//! services pick up. And the command in a report that gives the same result.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

use tempfile::TempDir;

use crate::common::fmpy::python;
use crate::common::from_start::path_with_program;
use crate::common::{examples, fmi_hazard, json};
use crate::sample;

fn docs() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/pipelines")
}

/// Runs a line of a shell in `dir`, with the program on the path.
fn shell(dir: &Path, line: &str) -> Output {
    let programs = TempDir::new().unwrap();
    let path = path_with_program(programs.path());
    Command::new("sh").args(["-ec", line]).current_dir(dir).env("PATH", path).output().unwrap()
}

fn said(output: &Output) -> String {
    String::from_utf8_lossy(&output.stderr).split_whitespace().collect::<Vec<_>>().join(" ")
}

/// The blocks of `language` in the page.
fn blocks(language: &str) -> Vec<String> {
    let page = fs::read_to_string(docs().join("README.md")).unwrap();
    let fence = format!("```{language}\n");
    let blocks = page.split(&fence).skip(1);
    blocks.map(|block| block.split("```").next().unwrap().to_owned()).collect()
}

/// A YAML file as its services read it.
fn yaml(name: &str) -> serde_json::Value {
    let script = "import json, sys, yaml; json.dump(yaml.safe_load(open(sys.argv[1])), sys.stdout, default=str)";
    let path = docs().join(name);
    let output = Command::new(python()).arg("-c").arg(script).arg(path).output().unwrap();
    assert!(output.status.success(), "{}", said(&output));
    serde_json::from_slice(&output.stdout).unwrap()
}

/// Leaves nothing for advice to change, which would be tried for long.
const NOTHING_CHANGES: &str = r#"[explain.parameters]
"plc.t_react" = { fixed = true }
"plc.v_reduced" = { fixed = true }
"ctrl.t_ramp" = { fixed = true }
"ctrl.speed_scale" = { fixed = true }
[explain.obstacle]
table = { fixed = true }
[explain.sensor]
field = { fixed = true }
[explain.robot]
UR5e = { fixed = true }
"#;

/// A repository with an example cell that is searched for a second only, with the page's `[fail_on]`.
fn repository() -> TempDir {
    let dir = examples();
    let cell = dir.path().join("cell");
    fs::rename(dir.path().join("head-collision"), &cell).unwrap();
    let text = fs::read_to_string(cell.join("cell.toml")).unwrap();
    let few = "[search]\nactions = 5\niterations = 12\n";
    let stays = if sample::is_whole() { "" } else { NOTHING_CHANGES };
    fs::write(cell.join("cell.toml"), format!("{text}\n{few}{stays}{}", blocks("toml").concat())).unwrap();
    dir
}

#[test]
fn the_page_and_its_workflows_work_as_written() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let repository = repository();
    let (dir, cell) = (repository.path(), repository.path().join("cell"));
    let [once, change, repaired] = blocks("sh").try_into().unwrap();
    // No baseline yet.
    let output = shell(&cell, &change);
    assert!(output.status.code() == Some(2) && said(&output).contains("--write-baseline"), "{}", said(&output));
    let output = shell(&cell, &once);
    assert!(output.status.code() == Some(1) && said(&output).contains("Baseline kept in baseline.json: 3 hazards"));
    assert_eq!(json(&cell.join("baseline.json"))["hazards"].as_array().unwrap().len(), 3);
    let output = shell(&cell, &change);
    assert_eq!(output.status.code(), Some(0), "{}", said(&output));
    assert!(said(&output).contains("Against the baseline: 0 new or worse; 3 known, 0 not found again"));

    let [github, gitlab] = ["github-actions.yml", "gitlab-ci.yml"].map(yaml);
    let steps = github["jobs"]["scan"]["steps"].as_array().unwrap();
    let step = |name: &str| steps.iter().find(|step| step["name"] == name).unwrap();
    let lines = [step("Scan")["run"].as_str().unwrap(), gitlab["hazards"]["script"][0].as_str().unwrap()];
    let scanned = |code: i32| {
        for line in sample::some(lines, 2) {
            let output = shell(dir, line);
            assert_eq!(output.status.code(), Some(code), "{line}: {}", said(&output));
            let kept = step("Keep the report")["with"]["path"].as_str().unwrap().lines();
            let sarif = step("Findings at the lines of the cell file")["with"]["sarif_file"].as_str();
            for file in kept.chain(sarif).chain(gitlab["hazards"]["artifacts"]["reports"]["junit"].as_str()) {
                assert!(dir.join(file).is_file(), "{file}");
            }
            // What a service shows at a line must be a file of the repository.
            let log = json(&dir.join("hazards/hazards.sarif"));
            for result in log["runs"][0]["results"].as_array().unwrap() {
                let place = &result["locations"][0]["physicalLocation"]["artifactLocation"]["uri"];
                assert_eq!(place.as_str(), Some("cell/cell.toml"));
            }
            fs::remove_dir_all(dir.join("hazards")).unwrap();
        }
    };
    scanned(0);

    // A hazard that nobody knew.
    let mut baseline = json(&cell.join("baseline.json"));
    let new = baseline["hazards"].as_array_mut().unwrap().remove(1)["id"].as_str().unwrap().to_owned();
    fs::write(cell.join("baseline.json"), baseline.to_string()).unwrap();
    scanned(1);
    let output = shell(&cell, &change);
    assert!(said(&output).contains(&format!("1 new or worse: {new}; 2 known")), "{}", said(&output));

    // The known ones are still there when tried again, which ends the block; the scan alone writes the baseline anew.
    assert_eq!(shell(&cell, &repaired).status.code(), Some(1));
    let output = shell(&cell, repaired.lines().last().unwrap());
    assert!(said(&output).contains("3 hazards"), "{}", said(&output));
}

#[test]
fn a_known_hazard_that_is_gone_passes_only_if_every_sequence_was_looked_at() {
    if !sample::is_turn(1, 4) {
        return;
    }
    let repository = repository();
    let dir = repository.path();
    let scan = |more: &[&str]| {
        let arguments = ["scan", "--from", "start", "--no-advice", "cell/cell.toml", "--out", "out"];
        fmi_hazard(dir).args(arguments).args(more).output().unwrap().status.code()
    };
    assert_eq!(scan(&["--write-baseline"]), Some(1));
    let path = dir.join("cell/baseline.json");
    let mut baseline = json(&path);
    baseline["hazards"][2]["id"] = "H-000000".into();
    fs::write(&path, baseline.to_string()).unwrap();
    let case = || {
        let cases = fs::read_to_string(dir.join("out/junit.xml")).unwrap();
        cases.split("<testcase ").find(|case| case.contains("H-000000")).unwrap().to_owned()
    };
    assert_eq!(scan(&["--strategy", "exhaustive"]), Some(1));
    assert!(!case().contains("skipped"), "{}", case());
    // A few sequences, in which nothing is met.
    assert_eq!(scan(&["--strategy", "hybrid", "--iterations", "5"]), Some(4));
    assert!(case().contains("not found again, but the scan is not complete"), "{}", case());
}

#[test]
fn the_command_in_the_report_gives_the_same_result_in_its_folder() {
    let dir = examples();
    let dir = dir.path();
    let cell = dir.join("it's a cell.toml");
    let text = fs::read_to_string(dir.join("head-collision/cell.toml")).unwrap();
    fs::write(&cell, text.replace("fmu = \"head-collision.fmu\"\n", "") + "\n[search]\nactions = 4\n").unwrap();
    let scan =
        ["scan", "--no-advice", "head-collision/head-collision.fmu", "--cell", "it's a cell.toml", "--out", "first"];
    for more in [
        &["--strategy", "exhaustive", "--max-states", "50", "--merge", "history", "--workers", "1"][..],
        &["--strategy", "random", "--iterations", "30", "--seed", "7", "--paper-iterations", "--state", "replay"],
        &["--max-work", "1", "--max-memory", "50", "--iterations", "3", "--stop-at", "first", "--fmu-timeout", "20"],
    ] {
        let output = fmi_hazard(dir).args(scan).args(more).output().unwrap();
        assert!(matches!(output.status.code(), Some(0 | 1 | 4)), "{}", said(&output));
        let command = reproduce(&dir.join("first"));
        let again = shell(&dir.join("first"), &command);
        assert_eq!(again.status.code(), output.status.code(), "{command}: {}", said(&again));
        // The same but for where it is seen from.
        let read = |out: &str| {
            let mut scan = json(&dir.join(out).join("scan.json"));
            for key in ["path", "cell_file", "cell_found"] {
                let _ = scan["subject"][key].take();
            }
            scan
        };
        assert!(read("first") == read("first/out/head-collision"), "{command}");
        fs::remove_dir_all(dir.join("first/out")).unwrap();
    }
}

/// The command in the report of a scan.
fn reproduce(out: &Path) -> String {
    let page = fs::read_to_string(out.join("report.html")).unwrap();
    let data = page.split("id=\"data\">").nth(1).unwrap().split("</script>").next().unwrap();
    let data: serde_json::Value = serde_json::from_str(data).unwrap();
    data["reproduce"].as_str().unwrap().to_owned()
}

#[test]
fn results_are_moved_with_their_cell_and_mailed_without_it() {
    if !sample::is_turn(2, 6) {
        return;
    }
    let dir = TempDir::new().unwrap();
    let dir = dir.path();
    let (first, mail) = (dir.join("first"), dir.join("mail"));
    [first.join("cells"), mail.clone()].iter().for_each(|folder| fs::create_dir_all(folder).unwrap());
    fs::copy(crate::common::test_fmus().join("faulty.fmu"), first.join("cells/faulty.fmu")).unwrap();
    fs::write(first.join("cells/cell.toml"), crate::common::nearer(&crate::common::faulty_cell("faulty.fmu", 0, 0)))
        .unwrap();
    let ran = |dir: &Path, arguments: &[&str]| {
        let output = fmi_hazard(dir).args(arguments).output().unwrap();
        let text = crate::common::archives::flat(&String::from_utf8_lossy(&output.stderr));
        (output.status.code(), String::from_utf8(output.stdout).unwrap(), text)
    };
    // However the cell is named.
    let cell = first.join("cells/cell.toml").display().to_string();
    let scan = ["scan", "--no-advice", &cell, "--strategy", "hybrid", "--iterations", "12", "--out", "results/a"];
    let (code, _, text) = ran(&first, &scan);
    assert_eq!(code, Some(1), "{text}");
    let result = json(&first.join("results/a/scan.json"));
    let id = result["hazards"][0]["id"].as_str().unwrap();
    assert_eq!(result["subject"]["path"], "../../cells/cell.toml");
    for file in fs::read_dir(first.join("results/a")).unwrap().map(|entry| entry.unwrap().path()) {
        let bytes = fs::read(&file).unwrap();
        let own = dir.display().to_string();
        // Findings are shown where the scan was told that the cell is.
        let names = bytes.windows(own.len()).any(|part| part == own.as_bytes());
        assert!(!names || file.ends_with("hazards.sarif") || file.ends_with("fmu.log"), "{}", file.display());
    }
    // All of it elsewhere.
    let moved = dir.join("elsewhere");
    fs::rename(&first, &moved).unwrap();
    let known = |dir: &Path, results: &str, cell: &str, more: &[&str]| {
        for command in [&["replay", results, id][..], &["explain", results, id, "--no-changes"]] {
            let (code, out, text) = ran(dir, &[command, more].concat());
            assert!(code < Some(2) && out.contains(id) && !text.contains("changed"), "{command:?}: {text}");
        }
        let (code, out, text) = ran(dir, &["replay", results, "--changed", cell]);
        assert!(code == Some(1) && out.contains(id), "{out} {text}");
    };
    known(&moved, "results/a", "cells/cell.toml", &[]);
    known(&moved.join("results"), "a/scan.json", "../cells/cell.toml", &[]);
    known(dir, "elsewhere/results/a", "elsewhere/cells/cell.toml", &[]);
    let command = reproduce(&moved.join("results/a"));
    let again = shell(&moved.join("results/a"), &format!("{command} --out again"));
    assert_eq!(again.status.code(), Some(1), "{command}: {}", said(&again));
    assert_eq!(json(&moved.join("results/a/again/scan.json"))["hazards"], result["hazards"]);
    let (code, _, text) = ran(dir, &["compare", "elsewhere/results/a", "elsewhere/results/a/again"]);
    // A quick search is not complete.
    assert_eq!(code, Some(4), "{text}");
    // A scan that was interrupted before goes on there.
    let rest = serde_json::json!({
        "arguments": ["--no-advice", "cells/cell.toml", "--strategy", "hybrid", "--iterations", "12", "--out", "results/a"],
        "folder": "../..",
    });
    fs::write(moved.join("results/a/resume.json"), rest.to_string()).unwrap();
    let (code, _, text) = ran(&mail, &["scan", "--resume", "../elsewhere/results/a"]);
    assert_eq!(code, Some(1), "{text}");
    assert!(json(&moved.join("results/a/scan.json")) == result, "it is the same again");
    // The results alone.
    fs::rename(moved.join("results/a"), mail.join("a")).unwrap();
    for command in [&["replay", "a", id][..], &["explain", "a", id]] {
        let (code, _, text) = ran(&mail, command);
        assert!(code == Some(2) && text.contains("does not exist") && text.contains("--cell FILE"), "{text}");
    }
    known(&mail, "a", "../elsewhere/cells/cell.toml", &["--cell", "../elsewhere/cells/cell.toml"]);
    // And the cell file without its FMU.
    fs::rename(moved.join("cells/cell.toml"), mail.join("cell.toml")).unwrap();
    for command in [&["replay", "a", id][..], &["explain", "a", id]] {
        let (code, _, text) = ran(&mail, &[command, &["--cell", "cell.toml"]].concat());
        assert!(code == Some(2) && text.contains("faulty.fmu does not exist") && text.contains("--fmu FILE"), "{text}");
        let more = ["--cell", "cell.toml", "--fmu", "../elsewhere/cells/faulty.fmu"];
        let (code, out, text) = ran(&mail, &[command, &more].concat());
        assert!(code < Some(2) && out.contains(id) && !text.contains("changed"), "{text}");
    }
}
