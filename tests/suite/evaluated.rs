//! Planes that the FMU evaluates itself, from where it is told that people are, while it is told of arms: what is refused, and what
//! `check` and a scan say of a plane that is not where the FMU has it. That the rules hold, `rules_twice` shows.

use std::path::Path;

use crate::common::twin::cells::curtain_inside;
use crate::common::{fmi_hazard, scan_json};

/// The cell with these texts replaced, and what the command makes of it: exit code, what it prints.
fn ran(dir: &Path, arguments: &[&str], changes: &[(&str, &str)]) -> (Option<i32>, String) {
    let file = curtain_inside().write(dir);
    let text = std::fs::read_to_string(&file).unwrap();
    let text = changes.iter().fold(text, |text, (old, new)| {
        assert_eq!(text.matches(old).count(), 1, "{old}");
        text.replace(old, new)
    });
    std::fs::write(&file, text).unwrap();
    let output = fmi_hazard(dir).args(arguments).output().unwrap();
    let told = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
    // Errors are broken into lines.
    let words: Vec<&str> = told.split_whitespace().filter(|word| *word != "│").collect();
    (output.status.code(), words.join(" "))
}

const EVALUATED: &str = "evaluated = { variable = \"curtain.interrupted\", active = true }\n";
const WHOLE: [&str; 6] = ["scan", "cell.toml", "--strategy", "exhaustive", "--no-advice", "--out=out"];

#[test]
fn a_plane_that_is_not_where_the_fmu_has_it_is_told() {
    let dir = tempfile::tempdir().unwrap();
    let (code, told) = ran(dir.path(), &["check", "cell.toml"], &[]);
    assert_eq!((code, told.contains("sensor `curtain`: the FMU")), (Some(0), false), "{told}");
    let elsewhere = ("\"curtain.own_depth\" = 0.137\n", "\"curtain.own_depth\" = 0.137\n\"curtain.own_y\" = 0.5\n");
    let everywhere = ("\"curtain.own_depth\" = 0.137\n", "\"curtain.own_depth\" = 9\n");
    let inverted = ("active = true", "active = false");
    let [silent, always, wrong] = [
        "the FMU does not report a person who stands in its plane, at (",
        "the FMU reports a person who stands 3 m away from it, at (",
        "evaluated.active = true",
    ];
    for (change, expected) in [(elsewhere, silent), (everywhere, always), (inverted, wrong)] {
        let (_, told) = ran(dir.path(), &["check", "cell.toml"], &[change]);
        assert!(told.contains(expected), "{told}");
    }
    // A scan says it, too.
    let short = ("actions = 3", "actions = 1");
    let (_, told) = ran(dir.path(), &WHOLE, &[elsewhere, short]);
    assert!(told.contains(silent), "{told}");
    let warnings = scan_json(&dir.path().join("out"))["warnings"].to_string();
    assert!(warnings.contains(silent), "{warnings}");
}

#[test]
fn what_the_fmu_cannot_know_is_refused() {
    let dir = tempfile::tempdir().unwrap();
    let pose = ("[pose]\ny = \"person.y\"\n", "");
    let high = ("heights_m = [0, 2.6]", "heights_m = [0.9, 2.6]");
    let crouching = ("[human]\n", "[human]\nalso = [\"crouch\"]\n");
    let mat = (
        "kind = \"light_curtain\"\nzone = { line_m = [[-3, 0], [3, 0]], heights_m = [0, 2.6] }",
        "kind = \"mat\"\nzone = { polygon_m = [[-3, 0], [3, 0], [3, 1]] }",
    );
    for (change, expected) in [
        (pose, "evaluates sensor `curtain` and is not told where the person is"),
        (high, "which begins at 0.9 m, and does not know who bends below it"),
        (crouching, "does not know who crouches, kneels or crawls"),
        (mat, "sensor `curtain` has evaluated, which only a light curtain or a door has"),
        ((EVALUATED, "evaluated = { variable = \"curtain.broken\" }\n"), "variable `curtain.broken` is not in"),
    ] {
        let (code, told) = ran(dir.path(), &WHOLE, &[change]);
        assert!(code == Some(2) && told.contains(expected), "{code:?} {told}");
    }
    let (code, told) = ran(dir.path(), &["scan", "cell.toml", "--from", "anywhere"], &[]);
    assert!(code == Some(2) && told.contains("evaluates `curtain` in part"), "{code:?} {told}");
}

/// Who tells the FMU of everything stops the slide earlier; who tells it of no arm, later: the three counts are far apart.
#[test]
fn arms_are_told_and_upright_bodies_are_not() {
    let dir = tempfile::tempdir().unwrap();
    let shorter = ("actions = 3", "actions = 2");
    let nearer = ("[0.0, -0.35]", "[0.0, -0.1]");
    let reported = "[[sensor]]\nname = \"curtain\"\nkind = \"light_curtain\"\n\
                    zone = { line_m = [[-3, 0], [3, 0]], heights_m = [0, 2.6] }\nvariable = \"plc.curtain_clear\"\nactive = false\n";
    let inside = (
        format!("{reported}{EVALUATED}"),
        "[[sensor]]\nname = \"curtain\"\nkind = \"reported\"\nvariable = \"curtain.interrupted\"\nactive = true\n",
    );
    let counts = [vec![], vec![(EVALUATED, "")], vec![(inside.0.as_str(), inside.1)]].map(|mut changes| {
        changes.extend([shorter, nearer]);
        ran(dir.path(), &WHOLE, &changes);
        let scan = scan_json(&dir.path().join("out"));
        assert_eq!(scan["certificate"]["complete"], true);
        scan["certificate"]["hazardous"].as_str().unwrap().parse::<u64>().unwrap()
    });
    let [evaluated, all_told, none_told] = counts;
    assert!(all_told < evaluated && evaluated < none_told, "{counts:?}");
}
