//! Campaigns: many scans in parts, in any order, by whomever and however often, are what the same scans one by one are; a sweep
//! ends in the value that single scans give; what is torn, stopped, changed or missing is told and never taken.

use std::collections::BTreeMap;
use std::path::Path;

use crate::common::started::Started;
use crate::common::{examples, fmi_hazard, json, scan_json, write};
use crate::sample;

/// Three starts at eight times: 24 beginnings, of which some meet a robot within two actions.
pub const DAY: &str = r#"schema = 1
name = "day"
cells = ["two-scanners/cell.toml"]

[over.human]
start = { xy_m = [-0.4, -0.6], heading_deg = 90 }
other_starts = [{ xy_m = [0.3, -0.5], heading_deg = 45 }, { xy_m = [0, -1.2], heading_deg = 90 }]
begins_s = [0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4]

[over.search]
actions = 2
"#;

/// The same at four of the times, among them one at which nobody is met: 12 beginnings.
pub fn half_a_day() -> String {
    let times = "begins_s = [0, 0.2, 0.4, 0.6, 0.8, 1.0, 1.2, 1.4]";
    assert!(DAY.contains(times));
    DAY.replace(times, "begins_s = [0, 0.4, 1.2, 1.4]")
}

/// Runs `fmi-hazard campaign` and gives its exit code and all that it printed.
fn campaign(dir: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output = fmi_hazard(dir).arg("campaign").args(arguments).output().unwrap();
    let text = [output.stdout, output.stderr].map(|text| String::from_utf8_lossy(&text).into_owned()).concat();
    (output.status.code(), text)
}

/// All files that a merge writes, by their paths.
pub fn merged(out: &Path) -> BTreeMap<String, Vec<u8>> {
    let mut all = BTreeMap::new();
    for name in ["campaign.json", "campaign.csv", "campaign.html", "sweep.svg", "cycle.svg", "floor.svg"] {
        if let Ok(bytes) = std::fs::read(out.join(name)) {
            all.insert(name.to_owned(), bytes);
        }
    }
    for entry in std::fs::read_dir(out.join("scans")).unwrap() {
        let path = entry.unwrap().path();
        all.insert(
            path.file_name().unwrap().to_string_lossy().into_owned(),
            std::fs::read(path.join("scan.json")).unwrap(),
        );
    }
    all
}

#[test]
fn shards_in_any_order_stopped_killed_and_done_twice_give_what_one_process_gives() {
    if !sample::is_turn(5, 12) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    let (day, all) = if sample::is_whole() { (DAY.to_owned(), 24) } else { (half_a_day(), 12) };
    let quarter = all / 4;
    write(dir, "day.toml", &day);
    for out in ["one", "four"] {
        let (code, told) = campaign(dir, &["plan", "day.toml", "--out", out]);
        assert!(code == Some(0) && told.contains(&format!("1 cell, {all} scans, {all} tasks")), "{told}");
    }
    let (code, told) = campaign(dir, &["run", "one"]);
    assert!(code == Some(0) && told.contains(&format!("{all} done now")), "{told}");
    let (code, told) = campaign(dir, &["merge", "one"]);
    assert!(code == Some(1) && told.contains(&format!("day: {all} scans")), "{told}");
    let whole = merged(&dir.join("one"));
    let rows = json(&dir.join("one/campaign.json"));
    let hit = usize::try_from(rows["cells"][0]["hazardous_scans"].as_u64().unwrap()).unwrap();
    assert!(whole.len() == all + 5 && (1..all).contains(&hit), "{hit} of {all} scans show too little");
    // Alone each scan gives the same bytes.
    for number in [1, 6, all - 1] {
        let (begin, out) = (number.to_string(), format!("one/scans/{number:04}"));
        let cell = "one/cells/two-scanners-day.toml";
        let alone = ["scan", cell, "--strategy", "exhaustive", "--no-advice", "--begin", &begin, "--out", &out];
        fmi_hazard(dir).args(alone).output().unwrap();
        assert!(std::fs::read(dir.join(out).join("scan.json")).unwrap() == whole[&format!("{number:04}")], "{number}");
    }
    // Four shards: the third first, one twice; one killed half-way, one stopped, with what a torn write leaves behind.
    let (code, told) = campaign(dir, &["merge", "four"]);
    assert!(code == Some(2) && told.contains(&format!("{all} of {all} tasks have no result")), "{told}");
    for (shard, signal, code) in [("3/4", "-KILL", None), ("1/4", "-INT", Some(130))] {
        let run = ["campaign", "run", "four", "--shard", shard, "--workers", "1"];
        let started = Started::until(dir, &run, "Done");
        let began = std::time::Instant::now();
        started.signal(signal);
        let (ended, told) = started.end();
        assert!(ended == code && began.elapsed().as_secs_f64() < 5.0, "{ended:?} {told}");
    }
    let (code, told) = campaign(dir, &["status", "four"]);
    assert!(code == Some(4) && told.contains("missing") && !told.contains("damaged"), "{told}");
    let names = campaign(dir, &["status", "four", "--tasks"]).1;
    let names: Vec<&str> = names.lines().collect();
    std::fs::write(dir.join("four/tasks").join(names[1]), "{\"task\":").unwrap();
    assert!(campaign(dir, &["status", "four"]).1.contains(&format!("damaged  {}", names[1])));
    let (now, before) = (format!("{quarter} done now"), format!("{quarter} before"));
    for (shard, already) in [("3/4", "before"), ("1/4", "before"), ("4/4", &now), ("2/4", &now), ("1/4", &before)] {
        let (code, told) = campaign(dir, &["run", "four", "--shard", shard]);
        assert!(code == Some(0) && told.contains(already) && told.contains("0 left"), "{told}");
    }
    let (code, told) = campaign(dir, &["run", "four", "--task", names[7], "--task", names[1]]);
    assert!(code == Some(0) && told.contains("2 tasks: 0 done now, 2 before"), "{told}");
    assert_eq!(campaign(dir, &["status", "four", "--missing"]), (Some(0), String::new()));
    for _ in 0..2 {
        assert_eq!(campaign(dir, &["merge", "four"]).0, Some(1));
        for (name, bytes) in merged(&dir.join("four")) {
            // The plan has no path in it, and neither has what follows from it.
            assert!(whole[&name] == bytes, "{name}");
        }
    }
    // What is missing is worked out when that is asked for.
    std::fs::remove_file(dir.join("four/tasks").join(names[4])).unwrap();
    let (code, told) = campaign(dir, &["merge", "four", "--work-out-missing"]);
    assert!(code == Some(1) && told.contains("1 task had no result and was worked out here"), "{told}");
    assert!(merged(&dir.join("four")) == whole);
}

#[test]
fn results_of_another_cell_are_not_taken() {
    let dir = examples();
    let dir = dir.path();
    let text = "schema = 1\nname = \"c\"\ncells = [\"sensor-mat/cell.toml\"]\n[over.search]\nactions = 1\n[search]\n\
                strategies = [\"exhaustive\", \"random\"]\nseeds = [1, 2]\niterations = 3\n";
    write(dir, "c.toml", text);
    assert!(campaign(dir, &["plan", "c.toml", "--out", "c"]).1.contains("4 scans"));
    assert_eq!(campaign(dir, &["run", "c", "--shard", "1/2"]).0, Some(0));
    let path = dir.join("sensor-mat/cell.toml");
    let cell = std::fs::read_to_string(&path).unwrap();
    std::fs::write(&path, cell.replace("heading_deg = 90", "heading_deg = 45")).unwrap();
    let (code, told) = campaign(dir, &["run", "c"]);
    assert!(code == Some(3) && told.contains("has changed, its cell file,") && told.contains("plan again"), "{told}");
    assert!(campaign(dir, &["plan", "c.toml", "--out", "c"]).1.contains("4 tasks"));
    let (code, told) = campaign(dir, &["status", "c"]);
    assert!(
        code == Some(4) && told.contains("0 of 4 tasks") && told.contains("2 results are of what is not planned"),
        "{told}"
    );
    // As it was before: they count again.
    std::fs::write(&path, &cell).unwrap();
    campaign(dir, &["plan", "c.toml", "--out", "c"]);
    assert!(campaign(dir, &["status", "c"]).1.contains("2 of 4 tasks"));
    // The same of a file that the cell file only names.
    write(dir, "sensor-mat/more.toml", "schema = 1\nname = \"more\"\nextends = \"cell.toml\"\n[search]\nactions = 1\n");
    let text = "schema = 1\nname = \"m\"\ncells = [\"sensor-mat/more.toml\"]\n[search]\nstrategies = [\"random\"]\niterations = 3\n";
    write(dir, "m.toml", text);
    assert_eq!(campaign(dir, &["plan", "m.toml", "--out", "m"]).0, Some(0));
    assert_eq!(campaign(dir, &["run", "m"]).0, Some(0));
    assert!(campaign(dir, &["status", "m"]).1.contains("1 of 1 task"));
    write(dir, "sensor-mat/cell.toml", &cell.replace("heading_deg = 90", "heading_deg = 45"));
    assert_eq!(campaign(dir, &["plan", "m.toml", "--out", "m"]).0, Some(0));
    assert!(campaign(dir, &["status", "m"]).1.contains("0 of 1 task"));
    let (code, told) = campaign(dir, &["run", "c", "--task", "nothing"]);
    assert!(code == Some(2) && told.contains("no task nothing"), "{told}");
    let (code, told) = campaign(dir, &["run", "elsewhere"]);
    assert!(code == Some(2) && told.contains("there is no plan in elsewhere"), "{told}");
}

#[test]
fn a_sweep_ends_in_the_smallest_value_that_single_scans_give() {
    if !sample::is_turn(10, 12) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    // The mat, from 0.1 to 1.0 m wide in front of what it guards.
    let text = r#"schema = 1
name = "width"
cells = ["sensor-mat/fixed.toml"]

[[sweep]]
name = "width"
unit = "m"
from = 0.1
to = 1.0
steps = 10

[[over.sensor]]
name = "mat"
zone = { polygon_m = [[-1, "= -0.8 - width"], [1, "= -0.8 - width"], [1, 2], [-1, 2]] }

[over.human]
start = { xy_m = [-0.74, -1.36], heading_deg = 90 }

[over.search]
actions = 5
"#;
    write(dir, "width.toml", text);
    let (code, told) = campaign(dir, &["plan", "width.toml", "--out", "w"]);
    assert!(code == Some(0) && told.contains("10 cells, 10 scans"), "{told}");
    assert_eq!(campaign(dir, &["run", "w"]).0, Some(0));
    let (_, told) = campaign(dir, &["merge", "w"]);
    let survey = json(&dir.join("w/campaign.json"));
    let margin = &survey["margins"][0];
    // The same cells by hand, scanned one by one.
    let fixed = std::fs::read_to_string(dir.join("sensor-mat/fixed.toml")).unwrap();
    let mut smallest = None;
    for tenth in [10, 6, 4, 3, 2] {
        let edge = -0.8 - f64::from(tenth) / 10.0;
        let edge = format!("{edge:.1}");
        let mut cell = fixed.clone();
        for (old, new) in [
            ("[[-1, -1.8], [1, -1.8],", format!("[[-1, {edge}], [1, {edge}],")),
            ("xy_m = [-0.55, -2]", "xy_m = [-0.74, -1.36]".to_owned()),
        ] {
            assert!(cell.contains(old));
            cell = cell.replace(old, &new);
        }
        write(dir, "sensor-mat/by-hand.toml", &(cell + "\n[search]\nactions = 5\n"));
        let scan = ["scan", "sensor-mat/by-hand.toml", "--strategy", "exhaustive", "--no-advice", "--out", "by-hand"];
        fmi_hazard(dir).args(scan).output().unwrap();
        let alone = scan_json(&dir.join("by-hand"));
        let of_campaign = scan_json(&dir.join(format!("w/scans/{tenth:04}")));
        assert_eq!(alone["hazards"], of_campaign["hazards"], "{tenth}");
        assert_eq!(alone["certificate"], of_campaign["certificate"], "{tenth}");
        if !alone["hazards"].as_array().unwrap().is_empty() {
            break;
        }
        smallest = Some(f64::from(tenth) / 10.0);
    }
    assert_eq!(margin["none_from"].as_f64(), smallest, "{told}");
    let smallest = smallest.unwrap();
    assert!((0.2..1.0).contains(&smallest), "{smallest} m shows too little");
    assert!(told.contains(&format!("no hazard from {smallest} m on")), "{told}");
    let picture = std::fs::read_to_string(dir.join("w/sweep.svg")).unwrap();
    assert_eq!(picture.matches("sensor-mat-fixed-width-").count(), 10, "a point for each");
    assert!(std::fs::read_to_string(dir.join("w/campaign.html")).unwrap().contains("no hazard from"));
}

/// Files of results of tasks, by their names.
fn results(out: &Path) -> BTreeMap<String, Vec<u8>> {
    let files = std::fs::read_dir(out.join("tasks")).unwrap().map(|entry| entry.unwrap().path());
    files
        .map(|path| (path.file_name().unwrap().to_string_lossy().into_owned(), std::fs::read(&path).unwrap()))
        .collect()
}

/// What follows the line that tells the time.
fn body(bytes: &[u8]) -> &[u8] {
    &bytes[bytes.iter().position(|byte| *byte == b'\n').unwrap() + 1..]
}

#[test]
fn one_search_in_parts_gives_the_bytes_of_one_machine() {
    if !sample::is_turn(4, 12) {
        return;
    }
    let dir = examples();
    let dir = dir.path();
    // With scanners in the FMU and hazards; with a plane, where arms meet robots as they would be had it told of them.
    for (cell, actions) in sample::some([("two-scanners/cell", 5), ("light-curtain/cell", 3)], 2) {
        let out = cell.replace('/', "-");
        let text = format!(
            "schema = 1\nname = \"p\"\ncells = [\"{cell}.toml\"]\n[over.search]\nactions = {actions}\n[search]\nparts = 4\n"
        );
        write(dir, "parts.toml", &text);
        let (code, told) = campaign(dir, &["plan", "parts.toml", "--out", &out]);
        assert!(code == Some(0) && told.contains("1 scan, 4 tasks"), "{told}");
        let names = campaign(dir, &["status", &out, "--tasks"]).1;
        let names: Vec<&str> = names.lines().collect();
        for (part, workers) in [(2, "1"), (0, "2"), (3, "1")] {
            let run = ["run", &out, "--task", names[part], "--workers", workers];
            assert_eq!(campaign(dir, &run).0, Some(0));
        }
        // Three of four are not a search, and no scan is told of.
        let (code, told) = campaign(dir, &["merge", &out]);
        assert!(code == Some(2) && told.contains("1 of 4 tasks have no result"), "{told}");
        assert!(!dir.join(&out).join("campaign.json").exists());
        let (code, told) = campaign(dir, &["merge", &out, "--work-out-missing"]);
        assert!(code == Some(1), "{told}");
        let number = |told: &str, word: &str| -> u64 {
            let line = told.lines().find(|line| line.contains("questions of divided")).unwrap();
            line.split(word).next().unwrap().split_whitespace().last().unwrap().parse().unwrap()
        };
        let missing = number(&told, " were worked out here");
        assert!(missing * 10 > number(&told, " questions"), "a quarter of the questions: {told}");
        let without_one = merged(&dir.join(&out));
        // One machine alone.
        let variant = format!("{out}/cells/{}-p.toml", cell.split('/').next().unwrap());
        let own = format!("{out}/scans/0001");
        fmi_hazard(dir)
            .args(["scan", &variant, "--strategy", "exhaustive", "--no-advice", "--out", &own])
            .output()
            .unwrap();
        let alone = std::fs::read(dir.join(&own).join("scan.json")).unwrap();
        assert!(alone == without_one["0001"]);
        assert_eq!(scan_json(&dir.join(&own))["certificate"]["complete"], true);
        // The last part, and another one once more: the same bytes whenever it is done.
        std::fs::remove_file(dir.join(&out).join("tasks").join(names[0].split('.').next().unwrap())).unwrap();
        let before = results(&dir.join(&out));
        std::fs::remove_file(dir.join(&out).join("tasks").join(names[2])).unwrap();
        assert_eq!(campaign(dir, &["run", &out, "--shard", "1/1"]).0, Some(0));
        let after = results(&dir.join(&out));
        assert!(body(&after[names[2]]) == body(&before[names[2]]));
        let sizes: Vec<usize> = names.iter().map(|name| after[*name].len()).collect();
        let all: usize = sizes.iter().sum();
        assert!(all > 20_000 && sizes.iter().all(|size| (all / 5..all / 3).contains(size)), "{sizes:?}");
        let (code, told) = campaign(dir, &["merge", &out]);
        assert!(code == Some(1), "{told}");
        let (answered, missing) = (number(&told, " questions"), number(&told, " were worked out here"));
        assert!(answered > 500 && missing * 20 < answered, "{told}");
        assert!(merged(&dir.join(&out)) == without_one);
    }
}

#[test]
fn what_is_wrong_with_a_campaign_file_is_told_with_what_to_do() {
    let dir = examples();
    let dir = dir.path();
    let head = "schema = 1\nname = \"n\"\ncells = [\"sensor-mat/cell.toml\"]\n";
    for (text, words) in [
        ("schema = 1\nname = \"n\"\ncells = []\n".to_owned(), "names no cell"),
        (head.replace("= 1", "= 2"), "this version reads schema = 1"),
        (format!("{head}cell = 1\n"), "unknown field `cell`"),
        (head.replace("sensor-mat/cell", "nowhere"), "nowhere.toml"),
        (format!("{head}[over]\nname = \"x\"\n"), "`over.name` is set"),
        (format!("{head}[over.search]\nactions = \"= n\"\n"), "no sweep is called `n`"),
        (format!("{head}[[sweep]]\nname = \"a b\"\nvalues = [1]\n"), "letters, digits"),
        (format!("{head}[[sweep]]\nname = \"a\"\nfrom = 1\n"), "which values"),
        (format!("{head}[[sweep]]\nname = \"a\"\nvalues = []\n"), "no values"),
        (format!("{head}[search]\nstrategies = [\"best\"]\n"), "no strategy `best`"),
        (format!("{head}[search]\nstrategies = [\"random\"]\nparts = 3\n"), "divides exhaustive searches only"),
        (format!("{head}[search]\nseeds = [1, 1]\n"), "twice"),
        (head.replace("cells = [", "cells = [\"sensor-mat/cell.toml\", "), "both make a cell `sensor-mat`"),
        (format!("{head}[over]\nsensors = 1\n"), "sensors"),
    ] {
        write(dir, "wrong.toml", &text);
        let (code, told) = campaign(dir, &["plan", "wrong.toml", "--out", "wrong"]);
        let told = told.replace('│', " ").split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(code == Some(2) && told.contains(words), "{words}: {code:?} {told}");
        assert!(!dir.join("wrong/manifest.json").exists(), "{words}");
    }
}
