//! What a scan writes for other tools, read by readers that this project did not write. Needs the Python environment that
//! `tools/test` makes.

use std::path::{Path, PathBuf};
use std::process::Command;

use crate::common::fmpy::python;
use crate::common::formats::{read_by_others, schemas};
use crate::common::guarded::guarded;
use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::python_package::flawed;
use crate::sample;

fn scan(dir: &Path, cell: &str, out: &str, more: &[&str]) -> Option<i32> {
    let few = ["--strategy", "hybrid", "--iterations", "20", "--out", out];
    fmi_hazard(dir).arg("scan").arg(cell).args(few).args(more).assert().get_output().status.code()
}

#[test]
fn tables_cases_logs_and_traces_are_read_by_others() {
    if !sample::is_turn(5, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    for example in sample::some(["head-collision", "safety-fence", "two-scanners"], 3) {
        let advised = sample::is_whole() && example == "head-collision";
        let more: &[&str] = if advised { &[] } else { &["--no-advice"] };
        let code = scan(dir, &format!("{example}/cell.toml"), "out", more);
        assert_eq!(code, Some(1));
        assert_eq!(scan_json(&dir.join("out"))["causes"][0]["advice"].is_null(), !advised);
        let said = read_by_others(&dir.join("out"), Some(&dir.join(example).join(format!("{example}.fmu"))));
        assert!(!said.contains(": 0 "), "{said}");
        // Typed, too.
        let sarif = std::fs::read_to_string(dir.join("out/hazards.sarif")).unwrap();
        let log: serde_sarif::sarif::Sarif = serde_json::from_str(&sarif).unwrap();
        let result = &log.runs[0].results.as_ref().unwrap()[0];
        let place = result.locations.as_ref().unwrap()[0].physical_location.as_ref().unwrap();
        let line = usize::try_from(place.region.as_ref().unwrap().start_line.unwrap()).unwrap();
        // The line that it points to names the joint of the link that hits.
        let cell = std::fs::read_to_string(dir.join(example).join("cell.toml")).unwrap();
        let link = scan_json(&dir.join("out"))["hazards"][0]["robot_link"].as_str().unwrap().to_owned();
        let before: Vec<&str> = cell.lines().take(line).collect();
        let carrier = ["joint = ", "frame = "].iter().any(|key| before[line - 1].starts_with(key));
        assert!(carrier, "{}", before[line - 1]);
        let name = before.iter().rfind(|line| line.starts_with("name = ")).unwrap();
        assert!(link.ends_with(name.trim_start_matches("name = ").trim_matches('"')), "{link} is not {name}");
        std::fs::remove_dir_all(dir.join("out")).unwrap();
    }
    // No hazard, and several FMUs, which have no traces.
    assert_eq!(scan(dir, "heavy-workpiece/fixed.toml", "none", &["--no-advice"]), Some(4));
    read_by_others(&dir.join("none"), None);
    assert!(
        scan(dir, "sensor-mat/coupled.toml", "coupled", &["--no-advice"]).is_some_and(|code| matches!(code, 1 | 4))
    );
    read_by_others(&dir.join("coupled"), None);
    let files = std::fs::read_dir(dir.join("coupled")).unwrap().flatten();
    assert!(files.map(|file| file.file_name()).all(|name| !name.to_string_lossy().contains(".inputs.")));
}

/// Advice is in all of them.
#[test]
fn what_helps_is_in_tables_and_page_and_read_by_others() {
    if !sample::is_turn(1, 6) {
        return;
    }
    let dir = guarded();
    let dir = dir.path();
    write(dir, "cell.toml", &flawed());
    let few = ["--strategy", "hybrid", "--iterations", "10", "--out", "out"];
    fmi_hazard(dir).args(["scan", "cell.toml"]).args(few).assert().code(1);
    let scan = scan_json(&dir.join("out"));
    let change = scan["causes"][0]["advice"]["changes"][0]["change"].as_str().unwrap();
    assert!(std::fs::read_to_string(dir.join("out/causes.csv")).unwrap().contains(change), "{change}");
    assert!(std::fs::read_to_string(dir.join("out/report.html")).unwrap().contains(change), "{change}");
    read_by_others(&dir.join("out"), None);
}

#[test]
fn known_hazards_do_not_fail_a_pipeline_and_new_ones_do() {
    if !sample::is_turn(4, 6) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let cell = "head-collision/cell.toml";
    // Where every sequence was looked at; a few show nothing of the others.
    let five = "extends = \"cell.toml\"\nname = \"five\"\n[search]\nactions = 5\n";
    write(dir, "head-collision/five.toml", five);
    let whole = |out: &str, more: &[&str]| {
        let all = ["scan", "--no-advice", "head-collision/five.toml", "--strategy", "exhaustive", "--out", out];
        fmi_hazard(dir).args(all).args(more).assert().get_output().status.code()
    };
    assert_eq!([whole("all", &[]), whole("known", &["--baseline", "all"])], [Some(1), Some(0)]);
    let said = read_by_others(&dir.join("known"), None);
    assert_eq!(scan(dir, cell, "first", &["--no-advice"]), Some(1));
    assert_eq!(scan(dir, cell, "again", &["--no-advice", "--baseline", "first"]), Some(4));
    assert!(said.contains(" 0 failures, 2 skipped"), "{said}");
    // A baseline that lacks one of them, and in which another was less hard.
    let path = dir.join("first/scan.json");
    let mut first = scan_json(&dir.join("first"));
    let lacking = first["hazards"].as_array_mut().unwrap().remove(0)["id"].as_str().unwrap().to_owned();
    let less = first["hazards"][0]["id"].as_str().unwrap().to_owned();
    first["hazards"][0]["ratio"] = serde_json::json!(0.5);
    std::fs::write(&path, first.to_string()).unwrap();
    assert_eq!(scan(dir, cell, "again", &["--no-advice", "--baseline", "first/scan.json"]), Some(1));
    let cases = std::fs::read_to_string(dir.join("again/junit.xml")).unwrap();
    // They are of one cause, whose test case says what is new in it.
    let case = cases.split("<testcase").find(|case| case.contains("C-")).unwrap();
    assert!(case.contains("type=\"hazard\""), "{case}");
    for (id, kind) in [(&lacking, "new: "), (&less, "worse: ")] {
        assert!(case.contains(&format!("{kind}{id} ")), "{case}");
    }
    assert_eq!(case.matches("known: ").count(), 4, "{case}");
    assert!(read_by_others(&dir.join("again"), None).contains(" 1 failures, 0 skipped"));
    // A cause of which all that is there is known, but less hard.
    first["hazards"].as_array_mut().unwrap().insert(0, scan_json(&dir.join("again"))["hazards"][0].clone());
    std::fs::write(&path, first.to_string()).unwrap();
    assert_eq!(scan(dir, cell, "again", &["--no-advice", "--baseline", "first/scan.json"]), Some(1));
    let cases = std::fs::read_to_string(dir.join("again/junit.xml")).unwrap();
    assert!(cases.contains("type=\"hazard that became worse\""), "{cases}");
}

#[test]
fn the_published_schemas_are_those_of_the_program_and_fit_what_it_reads_and_writes() {
    let dir = examples();
    let dir = dir.path();
    let read = |path: PathBuf| std::fs::read_to_string(path).unwrap();
    for (of, file) in [("cell", "cell.schema.json"), ("scan", "scan.schema.json")] {
        let output = fmi_hazard(dir).args(["schema", "--of", of]).output().unwrap();
        let printed = String::from_utf8(output.stdout).unwrap();
        assert!(
            printed == read(schemas().join(file)),
            "write it anew: fmi-hazard schema --of {of} > docs/schema/{file}"
        );
    }
    // The example is what this version writes, but for what it was made of.
    let example = schemas().join("scan.example.json");
    let compare = fmi_hazard(dir).arg("compare").args([&example, &example]).output().unwrap();
    assert!(compare.status.code() == Some(0) && String::from_utf8_lossy(&compare.stdout).contains("3 same."));
    let script = "import json, sys, tomllib, jsonschema\n\
                  schema = json.load(open(sys.argv[1]))\n\
                  cells = [json.load(open(p)) if p.endswith('.json') else tomllib.load(open(p, 'rb')) for p in sys.argv[2:]]\n\
                  [jsonschema.validate(cell, schema) for cell in cells]";
    let validates = |schema: &str, files: &[PathBuf]| {
        let mut command = Command::new(python());
        let output = command.args(["-c", script]).arg(schemas().join(schema)).args(files).output().unwrap();
        (output.status.success(), String::from_utf8_lossy(&output.stderr).into_owned())
    };
    let (valid, said) = validates("scan.schema.json", &[example]);
    assert!(valid, "{said}");
    let examples = fmi_hazard::examples::all().iter();
    let cells: Vec<PathBuf> =
        examples.flat_map(|e| ["cell.toml", "fixed.toml"].map(|file| dir.join(e.name).join(file))).collect();
    let (valid, said) = validates("cell.schema.json", &cells);
    assert!(valid && cells.len() == 32, "{said}");
    // It can fail.
    std::fs::write(&cells[0], read(cells[1].clone()).replace("moving_mass_kg", "moving_mas_kg")).unwrap();
    assert!(!validates("cell.schema.json", &cells[..1]).0);
}
