//! Nothing clean is said, by exit code, in words or in files, while anything is open that it needs; and what is accepted in the cell file
//! is no longer open.

use std::path::Path;

use fmi_hazard::obligations::{Need, Standing};
use fmi_hazard::scan::prepare::prepare;
use serde_json::Value;

use crate::common::anywhere::{look, two_bars};
use crate::common::guarded::guarded;
use crate::common::{examples, fmi_hazard, scan_json, write};

/// The exit code, what is open, and what is printed.
fn scanned(dir: &Path, path: &str, more: &[&str]) -> (Option<i32>, Vec<String>, Value, String) {
    let arguments = [&["scan", "--no-advice", path, "--out", "o"], more].concat();
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let report = scan_json(&dir.join("o"));
    let is_open = |one: &&Value| one["standing"] == "open";
    let open = report["obligations"].as_array().unwrap().iter().filter(is_open);
    let open = open.map(|one| one["need"].as_str().unwrap().to_owned()).collect();
    let told = String::from_utf8_lossy(&output.stdout).split_whitespace().collect::<Vec<_>>().join(" ");
    (output.status.code(), open, report, told)
}

/// Samples and spent budgets, of flawed cells in which little is looked at and of repaired ones, in both versions of FMI; and the whole
/// searches of small questions beside them.
#[test]
fn a_search_that_ended_early_or_took_samples_says_nothing_clean() {
    let dir = examples();
    let fixed = |cell: &str, actions: u32| {
        let text = format!("extends = \"fixed.toml\"\nname = \"short\"\n[search]\nactions = {actions}\n");
        write(&dir.path().join(cell), "short.toml", &text);
    };
    ["heavy-workpiece", "light-curtain", "sensor-mat"].iter().for_each(|cell| fixed(cell, 2));
    let cases: [(&str, &[&str]); 5] = [
        ("safety-fence/cell.toml", &["--strategy", "random", "--iterations", "1"]),
        ("light-curtain/fixed.toml", &["--from", "start", "--max-states", "40"]),
        ("head-collision/fixed.toml", &["--strategy", "exhaustive", "--max-states", "50"]),
        (
            "sensor-mat/sensor-mat-fmi3.fmu",
            &["--cell", "sensor-mat/fixed.toml", "--strategy", "mcts-dpw", "--iterations", "5"],
        ),
        ("heavy-workpiece/fixed.toml", &["--strategy", "hybrid", "--iterations", "5"]),
    ];
    for (path, more) in cases {
        let (code, open, report, told) = scanned(dir.path(), path, more);
        assert_eq!((code, &report["verdict"]), (Some(4), &Value::from("inconclusive")), "{path}: {told}");
        assert_eq!(open.first().map(String::as_str), Some("searched"), "{path}: {told}");
        assert!(told.contains("Nothing was found; not shown because"), "{path}: {told}");
        assert!(report["headline"]["covers"].as_str().unwrap().contains("Not complete"), "{path}: {told}");
    }
    let whole: [(&str, &[&str]); 3] = [
        ("heavy-workpiece/short.toml", &[]),
        ("light-curtain/light-curtain-fmi3.fmu", &["--cell", "light-curtain/short.toml"]),
        ("sensor-mat/short.toml", &["--strategy", "exhaustive"]),
    ];
    for (path, more) in whole {
        let (code, open, report, told) = scanned(dir.path(), path, &[more, &["--from", "start"]].concat());
        let expected = (Some(0), Value::from("none_found"));
        // Where two actions do not get to a sensor, or near the robot, that is what is open.
        if open.is_empty() {
            assert_eq!((code, report["verdict"].clone()), expected, "{path}: {told}");
            assert_eq!(report["certificate"]["complete"], true, "{path}");
        } else {
            assert!(code == Some(4) && !open.contains(&"searched".to_owned()), "{path}: {open:?}");
        }
    }
}

/// Two bars that heed a mat each: tried out, and accepted by somebody for this FMU.
#[test]
fn what_was_only_tried_out_counts_once_it_is_accepted() {
    let dir = guarded();
    let floor = "floor_m = [[-4.6, -0.1], [4.6, -0.1], [4.6, 0.1], [-4.6, 0.1]]\nstart = { xy_m = [0, 0]";
    let straight = "[human]\nbend_forward_deg = 0\nbend_lateral_deg = 0\n";
    let cell = two_bars(["a", "b"]).replace("[human]\n", straight).replace("start = { xy_m = [0, -3]", floor);
    let tried = look(dir.path(), &cell, 0.2, 2);
    let open: Vec<Need> = tried.obligations.open().map(|one| one.need).collect();
    assert_eq!((tried.verdict.is_clean(), open), (false, vec![Need::Heeds; 2]), "{tried:#?}");
    let lines = tried.obligations.lines_to_accept().unwrap();
    let signed = lines.replace("by = \"\"", "by = \"A. B.\"").replace("because = \"\"", "because = \"wired so\"");
    let accepted = look(dir.path(), &format!("{cell}\n{signed}"), 0.2, 2);
    assert!(accepted.verdict.is_clean(), "{accepted:#?}");
    let assumed = accepted.obligations.all().iter().filter(|one| matches!(one.standing, Standing::Assumed { .. }));
    assert_eq!(assumed.count(), 2);
    // One of them is not enough.
    let first = signed.split("[[accept]]").nth(1).unwrap();
    let half = look(dir.path(), &format!("{cell}\n[[accept]]{first}"), 0.2, 2);
    assert_eq!((half.verdict.is_clean(), half.obligations.open().count()), (false, 1), "{half:#?}");
    // Each is about something that is there, by somebody, for this FMU.
    let own = |change: &dyn Fn(&str) -> String| {
        let path = write(dir.path(), "wrong.toml", &format!("{cell}\n[[accept]]{}", change(first)));
        format!("{:?}", miette::Report::new(prepare(&path, None).err().unwrap()))
    };
    let fmu = first.split("fmu = \"").nth(1).unwrap().split('"').next().unwrap();
    for (said, words) in [
        (own(&|lines| lines.replace("mat b", "mat c")), "there is no sensor `mat c`"),
        (own(&|lines| lines.replace("A. B.", " ")), "by nobody"),
        (own(&|lines| lines.replace("robot_ignores_sensor", "people_alike")), "`robot` says nothing here"),
        (own(&|lines| lines.replace(fmu, "0123")), "another FMU"),
        (own(&|lines| lines.replace(fmu, "0123")), fmu),
    ] {
        assert!(said.replace(['\n', ' ', '│'], "").contains(&words.replace(' ', "")), "{words}: {said}");
    }
}
