//! What people hold in a hand: how far it reaches, what results say of it, and with what it does not go together. That planes and
//! obstacles count as for arms, `rules_twice` shows.

use fmi_hazard::record::model::{ScanReport, Verdict};
use fmi_hazard::scan::prepare::{Prepared, prepare};

use crate::common::anywhere::{cell, look};
use crate::common::guarded::{every_sequence, guarded};
use crate::common::{examples, fmi_hazard, scan_json, write};

/// Nobody gets near a bar in one action; a rod does if it is long enough: as far as the arm is long, and no farther.
#[test]
fn a_rod_reaches_as_much_farther_as_it_is_long() {
    let dir = guarded();
    let prepared = |held_m: f64| -> Prepared {
        let held = if held_m > 0.0 { format!("held_m = {held_m}\n") } else { String::new() };
        let text = cell(1.0, "").replace("xy_m = [0, -3]", "xy_m = [0, -1.5]");
        let text = text.replace("heading_deg = 90 }\n", &format!("heading_deg = 90 }}\n{held}"));
        let text = text.replace("actions = 2", "actions = 1");
        prepare(&write(dir.path(), "cell.toml", &text), None).unwrap()
    };
    let scanned = |held_m: f64| -> ScanReport { every_sequence(&prepared(held_m), false) };
    let counts = [0.0, 0.1, 0.2, 0.4].map(|held_m| {
        let report = scanned(held_m);
        assert_eq!(report.settings.held_m, Some(held_m).filter(|held_m| *held_m > 0.0));
        for hazard in &report.hazards {
            let arm = hazard.arm.as_ref().unwrap();
            let [wrist, touched] = [arm.wrist_m, hazard.contact_point_m];
            let from_wrist = (0..3).map(|i| (wrist[i] - touched[i]).powi(2)).sum::<f64>().sqrt();
            let beyond = arm.held_m.unwrap_or(0.0);
            assert!(
                beyond <= held_m + 1e-6 && (beyond == 0.0 || (from_wrist - 0.23 - beyond).abs() < 1e-9),
                "{hazard:?}"
            );
            assert_eq!(
                hazard.described().contains("meets the thing in the hand"),
                beyond > 0.0,
                "{}",
                hazard.described()
            );
        }
        let held = report.hazards.iter().any(|hazard| hazard.arm.as_ref().is_some_and(|arm| arm.held_m.is_some()));
        let hazardous: u64 = report.certificate.unwrap().hazardous.parse().unwrap();
        (hazardous, held)
    });
    let [(none, _), (short, _), (longer, _), (long, held)] = counts;
    assert!(none <= short && short <= longer && longer < long && held, "{counts:?}");
}

/// A bar that hands meet already: with a rod in them no sequence is lost that they have without.
#[test]
fn who_holds_something_meets_all_that_empty_hands_do() {
    let dir = guarded();
    let scanned = |held: &str| -> ScanReport {
        let wall = "[[obstacle]]\nname = \"slit\"\ncentre_m = [0, -0.75, 0.65]\nsize_m = [3, 0.02, 0.7]\n[[obstacle]]\n\
                    name = \"above\"\ncentre_m = [0, -0.75, 1.75]\nsize_m = [3, 0.02, 1.3]\n";
        let text = cell(1.0, wall).replace("xy_m = [0, -3]", "xy_m = [0, -1.15]");
        let text = text.replace("heading_deg = 90 }\n", &format!("heading_deg = 90 }}\n{held}"));
        every_sequence(&prepare(&write(dir.path(), "cell.toml", &text), None).unwrap(), false)
    };
    let [empty, rod] = ["", "held_m = 0.6\n"].map(|held| scanned(held).certificate.unwrap());
    let [empty, rod] = [empty, rod].map(|certificate| certificate.hazardous.parse::<u64>().unwrap());
    assert!(empty > 0 && rod >= empty, "{empty} {rod}");
}

/// From a strip of floor from which empty hands do not get to the bar, for people who stand upright.
#[test]
fn from_anywhere_a_rod_reaches_what_hands_do_not() {
    let dir = guarded();
    let looked = |held: &str| {
        let floor = "floor_m = [[-0.1, -1.7], [0.1, -1.7], [0.1, -1.5], [-0.1, -1.5]]";
        let human = format!("bend_forward_deg = 0\nbend_lateral_deg = 0\n{floor}\n{held}");
        let text = cell(1.0, "")
            .replace("[human]\n", &format!("[human]\n{human}"))
            .replace("xy_m = [0, -3]", "xy_m = [0, -1.6]");
        look(dir.path(), &text, 0.2, 2)
    };
    let [empty, rod] = ["", "held_m = 0.6\n"].map(looked);
    assert!(empty.verdict.is_clean() && empty.open == 0, "{empty:#?}");
    assert!(rod.verdict == Verdict::HazardsFound && rod.hazards.iter().all(|hazard| hazard.confirmed), "{rod:#?}");
}

#[test]
fn what_is_held_is_told_and_refused_where_it_says_nothing() {
    let dir = examples();
    let file = |name: &str, human: &str, more: &str| {
        let text =
            format!("extends = \"cell.toml\"\nname = \"{name}\"\n[human]\n{human}\n{more}\n[search]\nactions = 4\n");
        write(&dir.path().join("sensor-mat"), &format!("{name}.toml"), &text)
    };
    let ran = |arguments: &[&str]| {
        let output = fmi_hazard(dir.path()).args(arguments).output().unwrap();
        let told = String::from_utf8([output.stdout, output.stderr].concat()).unwrap();
        let words: Vec<&str> = told.split_whitespace().filter(|word| *word != "│").collect();
        (output.status.code(), words.join(" "))
    };
    for (held, more, expected) in [
        ("held_m = 0.01", "", "held_m is 0.01"),
        ("held_m = 2", "", "held_m is 2"),
        ("held_m = 0.3", "[criteria]\npressure = true", "`held_m` says nothing of clamping, pressure and separation"),
        ("held_m = 0.3", "[criteria]\nclamping = true", "says nothing of clamping, pressure and"),
    ] {
        let path = file("refused", held, more);
        let (code, told) = ran(&["check", path.to_str().unwrap()]);
        assert!(code == Some(2) && told.contains(expected), "{code:?} {told}");
    }
    let scan = |name: &str, held: &str| {
        let path = file(name, held, "");
        let out = dir.path().join(name);
        let arguments = ["scan", path.to_str().unwrap(), "--strategy", "exhaustive", "--no-advice", "--out"];
        let (code, told) = ran(&[&arguments[..], &[out.to_str().unwrap()]].concat());
        assert!(matches!(code, Some(0 | 1)), "{told}");
        (scan_json(&out), told)
    };
    let (with, told) = scan("rod", "held_m = 0.6");
    assert!(told.contains("thing in the hand by"), "{told}");
    let (without, told) = scan("nothing", "");
    assert!(!told.contains("thing in the hand"), "{told}");
    let counts =
        [&with, &without].map(|scan| scan["certificate"]["hazardous"].as_str().unwrap().parse::<u64>().unwrap());
    assert!(counts[0] > 0 && counts[1] == 0, "{counts:?}");
    assert!(without["settings"].get("held_m").is_none() && with["settings"]["held_m"] == 0.6);
    // Who holds less has not mended the cell.
    let (_, told) = ran(&["compare", "rod", "nothing"]);
    assert!(!told.contains("fixed "), "{told}");
}
