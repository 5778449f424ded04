//! Known hazards in changed cells: what only begins elsewhere, counts less, or cannot be tried from where it began is not fixed, for
//! `replay --changed`, `compare` and JUnit alike; what was repaired is.

use std::path::Path;

use crate::common::guarded::bar;
use crate::common::{examples, fmi_hazard, json, scan_json, test_fmus, write};
use crate::sample;

fn ran(dir: &Path, arguments: &[&str]) -> (Option<i32>, String) {
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).unwrap().split_whitespace().collect::<Vec<_>>().join(" ");
    (output.status.code(), text(output.stdout) + &text(output.stderr))
}

const START: &str = "xy_m = [-0.6, 0], heading_deg = 0";
const MAT: &str = "polygon_m = [[-0.1, -1.4], [1.4, -1.4], [1.4, 1.4], [-0.1, 1.4]]";
const FAST: &str = "\"drive.speed\" = 5";

/// A bar that turns, beside whom somebody begins outside of its mat.
fn turning_bar() -> String {
    let bar = bar("bar", 0.0, 0.45).replace("to_m = [0.8,", "to_m = [0.35,");
    format!(
        "schema = 1\nname = \"bar\"\nfmu = \"guarded.fmu\"\n{bar}[[sensor]]\nname = \"mat\"\nkind = \"mat\"\nvariable = \"clear\"\n\
         active = false\nzone = {{ {MAT} }}\n[human]\nstart = {{ {START} }}\n[search]\nactions = 2\n[parameters]\n{FAST}\n\
         \"ssm.distance\" = 0.0\n"
    )
}

/// A change of the cell, and what is said of the hazards that were known before.
struct Case {
    name: &'static str,
    /// What is replaced.
    changes: &'static [(&'static str, &'static str)],
    verify: (i32, &'static str),
    /// And of a complete scan of it; none where it cannot be scanned.
    compare: Option<(i32, &'static str)>,
}

const SLOW: (&str, &str) = (FAST, "\"drive.speed\" = 0.4");
const ELSEWHERE: (&str, &str) = (START, "xy_m = [-3, 0], heading_deg = 0");

const CASES: [Case; 9] = [
    Case {
        name: "moved",
        changes: &[ELSEWHERE],
        verify: (1, "STILL THERE"),
        compare: Some((4, "begins at another place or time")),
    },
    Case { name: "slow", changes: &[SLOW], verify: (0, "fixed"), compare: Some((0, "fixed.")) },
    Case {
        name: "slow-and-moved",
        changes: &[SLOW, ELSEWHERE],
        verify: (0, "fixed"),
        compare: Some((4, "begins at another place or time")),
    },
    Case {
        name: "mat-over-the-start",
        changes: &[(MAT, "polygon_m = [[-2, -1.4], [1.4, -1.4], [1.4, 1.4], [-2, 1.4]]")],
        // Some are hit in the first step all the same.
        verify: (1, "NOT SHOWN"),
        compare: Some((1, "begins where mat reports somebody already")),
    },
    Case {
        name: "wall-over-the-start",
        changes: &[(
            "[human]",
            "[[obstacle]]\nname = \"wall\"\ncentre_m = [-0.6, 0, 1]\nsize_m = [0.1, 2, 2]\n[human]",
        )],
        verify: (4, "somebody has no room any more where it begins"),
        compare: None,
    },
    Case {
        name: "stands",
        changes: &[(
            "\"ssm.distance\" = 0.0",
            "\"ssm.distance\" = 10.0\n\"plc.t_react\" = 0.0\n\"plc.t_ramp\" = 0.001\n[inputs]\n\"person.y\" = -1.0",
        )],
        verify: (4, "bar does not move while somebody stands where it begins"),
        compare: Some((4, "The second scan is not complete")),
    },
    Case {
        name: "other-speed",
        changes: &[SLOW, ("[human]", "[criteria]\ntransient_force = \"approach\"\n[human]")],
        verify: (4, "the changed cell judges the force by another speed"),
        // Who walks against the slow bar is hit harder than the limit then.
        compare: Some((1, "the second scan judges the force by another speed")),
    },
    Case {
        name: "other-body",
        changes: &[SLOW, ("[human]", "[human]\nsex = \"woman\"\npercentile = 5")],
        verify: (0, "fixed"),
        compare: Some((4, "has a person with another body")),
    },
    Case {
        name: "coarser",
        changes: &[SLOW, ("actions = 2", "actions = 2\nreach_tolerance_m = 0.05")],
        verify: (4, "NOT JUDGED"),
        compare: Some((4, "may miss deeper contacts")),
    },
];

/// FMUs of both versions of the standard say the same.
#[test]
fn only_what_was_repaired_is_fixed() {
    for (fmu, cases) in [("guarded.fmu", &CASES[..]), ("guarded-fmi3.fmu", &CASES[..4])] {
        if fmu.contains("fmi3") && !sample::is_whole() {
            continue;
        }
        let dir = tempfile::tempdir().unwrap();
        let dir = dir.path();
        std::fs::copy(test_fmus().join(fmu), dir.join("guarded.fmu")).unwrap();
        write(dir, "cell.toml", &turning_bar());
        let scan = |cell: &str, out: &str, more: &[&str]| {
            ran(dir, &[&["scan", "--no-advice", cell, "--strategy", "exhaustive", "--out", out][..], more].concat())
        };
        let (code, said) = scan("cell.toml", "before", &[]);
        assert_eq!(code, Some(1), "{said}");
        let before = scan_json(&dir.join("before"));
        assert_eq!(before["settings"]["begins"]["xy_m"], serde_json::json!([-0.6, 0.0]));
        assert!(before["settings"]["seen_at_start"].is_null());
        assert_eq!(before["settings"]["body"]["percentile"], 50);
        for Case { name, changes, verify, compare } in sample::some(cases, 3) {
            let mut text = turning_bar();
            for (old, new) in *changes {
                assert!(text.contains(old), "{name}");
                text = text.replace(old, new);
            }
            let file = format!("{name}.toml");
            write(dir, &file, &text);
            let (code, said) = ran(dir, &["replay", "before", "--changed", &file, "--junit", "verified.xml"]);
            assert!(code == Some(verify.0) && said.contains(verify.1), "{fmu} {name}: {code:?} {said}");
            let junit = std::fs::read_to_string(dir.join("verified.xml")).unwrap();
            let bad = junit.contains("<failure") || junit.contains("<error");
            assert_eq!(bad, verify.0 != 0, "{name}: {junit}");
            let Some(compare) = compare else { continue };
            scan(&file, name, &["--baseline", "before"]);
            let (code, said) = ran(dir, &["compare", "before", name]);
            assert!(code == Some(compare.0) && said.contains(compare.1), "{fmu} {name}: {code:?} {said}");
            assert_eq!(said.contains("0 fixed") || !said.contains(" fixed."), compare.0 != 0, "{name}: {said}");
            let junit = std::fs::read_to_string(dir.join(name).join("junit.xml")).unwrap();
            assert_eq!(junit.contains("not found again"), compare.0 != 0, "{name}: {junit}");
        }
    }
}

/// A record that does not say where it began, as versions before wrote it: the same cell is tried from where it begins, another is not
/// judged.
#[test]
fn a_record_that_does_not_say_where_it_began_is_of_use_for_the_same_cell_only() {
    let dir = tempfile::tempdir().unwrap();
    let dir = dir.path();
    std::fs::copy(test_fmus().join("guarded.fmu"), dir.join("guarded.fmu")).unwrap();
    write(dir, "cell.toml", &turning_bar());
    write(dir, "slow.toml", &turning_bar().replace(SLOW.0, SLOW.1));
    let scan = ["scan", "--no-advice", "--strategy", "random", "--iterations", "10"];
    assert_eq!(ran(dir, &[&scan[..], &["cell.toml", "--out", "before"]].concat()).0, Some(1));
    let file = dir.join("before/scan.json");
    let mut old = json(&file);
    let settings = old["settings"].as_object_mut().unwrap();
    assert!(settings.remove("begins").is_some() && settings.remove("body").is_some());
    std::fs::write(&file, old.to_string()).unwrap();
    let (code, said) = ran(dir, &["replay", "before", "--changed", "cell.toml"]);
    assert!(code == Some(1) && said.contains("STILL THERE"), "{said}");
    let (code, said) = ran(dir, &["replay", "before", "all"]);
    assert!(code == Some(1) && said.contains("as recorded to the last bit"), "{said}");
    let (code, said) = ran(dir, &["replay", "before", "--changed", "slow.toml"]);
    assert!(code == Some(4) && said.contains("does not say where the person began"), "{said}");
}

/// Of no hazards nothing is fixed.
#[test]
fn where_nothing_is_known_nothing_is_fixed() {
    let dir = tempfile::tempdir().unwrap();
    let dir = dir.path();
    std::fs::copy(test_fmus().join("guarded.fmu"), dir.join("guarded.fmu")).unwrap();
    write(dir, "slow.toml", &turning_bar().replace(SLOW.0, SLOW.1));
    ran(dir, &["scan", "--no-advice", "slow.toml", "--strategy", "random", "--iterations", "3", "--out", "before"]);
    let (code, said) = ran(dir, &["replay", "before", "--changed", "slow.toml", "--junit", "verified.xml"]);
    assert!(code == Some(4) && said.contains("knows no hazards") && !said.contains("fixed"), "{said}");
    let junit = std::fs::read_to_string(dir.join("verified.xml")).unwrap();
    assert!(junit.contains("<skipped"), "{junit}");
}

/// The examples: one whose repair moved the start is tried from the old one, and fixed; one whose field is over the old one is not
/// shown. Replays and explanations begin where the scan did.
#[test]
fn examples_are_tried_from_where_they_were_scanned() {
    let dir = examples();
    let dir = dir.path();
    for (example, code, says) in [
        ("heavy-workpiece", 0, "known hazards fixed"),
        ("head-collision", 4, "reports somebody already where it begins"),
    ] {
        let [flawed, fixed, moved] = ["cell", "fixed", "moved"].map(|name| format!("{example}/{name}.toml"));
        let scan = ["scan", "--no-advice", "--strategy", "hybrid", "--iterations", "10", "--out", "before"];
        assert_eq!(ran(dir, &[&scan[..], &[&flawed]].concat()).0, Some(1));
        let (verified, said) = ran(dir, &["replay", "before", "--changed", &fixed]);
        assert!(verified == Some(code) && said.contains(says), "{said}");
        let elsewhere =
            "extends = \"cell.toml\"\nname = \"moved\"\n[human]\nstart = { xy_m = [0.2, -6.0], heading_deg = 90 }\n";
        write(dir, &moved, elsewhere);
        let (verified, said) = ran(dir, &["replay", "before", "--changed", &moved]);
        assert!(verified == Some(1) && said.contains(" 0 of "), "{said}");
        let (replayed, said) = ran(dir, &["replay", "before", "all", "--cell", &moved]);
        assert!(
            replayed == Some(1)
                && said.contains("as recorded to the last bit; begins at")
                && !said.contains("NOT reproduced"),
            "{said}"
        );
        let id = scan_json(&dir.join("before"))["hazards"][0]["id"].as_str().unwrap().to_owned();
        let (explained, said) = ran(dir, &["explain", "before", &id, "--no-changes", "--cell", &moved]);
        assert_eq!(explained, Some(0), "{said}");
    }
}
