//! Sensors whose variable is a number: an integer, a level, and what a sensor inside the FMU says. The same cell with the Boolean signal
//! gives the same, from the start and from anywhere, by FMUs of both versions; values that the variable cannot have are refused.

use crate::common::{assert_same_hazards, fmi_hazard, scan_json, write};
use crate::restarts::{WATCHES, cell, folder, look};
use crate::sample;

/// The signal of the door or the mat as a Boolean, and as numbers.
const BOOLEAN: &str = "variable = \"plc.door_clear\"\nactive = false\n";
const NUMBERS: [&str; 3] = [
    "variable = \"plc.gate_state\"\nvalues = { clear = 1, detected = 0 }\n",
    "variable = \"plc.gate_state\"\nvalues = { clear = 1, detected = 2 }\n",
    "variable = \"plc.mat_level\"\nvalues = { clear = 0.125, detected = 0.75 }\n",
];

fn with(text: &str, from: &str, to: &str) -> String {
    assert!(text.contains(from), "{from}");
    text.replacen(from, to, 1)
}

/// Every sequence from the start.
fn from_start(dir: &std::path::Path, text: &str) -> serde_json::Value {
    write(dir, "cell.toml", text);
    let scan =
        ["scan", "cell.toml", "--from", "start", "--strategy", "exhaustive", "--no-advice", "--quiet", "--out", "out"];
    fmi_hazard(dir).args(scan).output().unwrap();
    scan_json(&dir.join("out"))
}

#[test]
fn a_number_does_what_the_boolean_does() {
    let cases = ["gantry.fmu", "gantry-fmi3.fmu", "gantry.fmu"].into_iter().zip(NUMBERS);
    for (fmu, number) in sample::some(cases, 1) {
        let dir = folder(fmu);
        for latched_by in ["nobody", "PLC"] {
            let boolean = cell(WATCHES[0], latched_by);
            let number = with(&boolean, BOOLEAN, number);
            let scans = [&boolean, &number].map(|text| from_start(dir.path(), text));
            assert_same_hazards(&scans[0], &scans[1]);
            assert_eq!(scans[0]["verdict"], scans[1]["verdict"], "{fmu} {number}");
            assert_eq!(scans[0]["statistics"]["sequences"], scans[1]["statistics"]["sequences"]);
            // Whoever passes what restarts takes long to look for.
            if latched_by == "nobody" {
                continue;
            }
            let looked = [&boolean, &number].map(|text| look(&dir, text, 300_000));
            for found in looked {
                assert!(found.verdict.is_clean(), "{fmu} {number}: {:?}", found.reasons);
            }
        }
    }
}

#[test]
fn what_the_fmu_reports_as_a_number_is_read() {
    let inside = |signal: &str| {
        let text = cell(WATCHES[0], "nobody");
        let sensor = &text[text.find("[[sensor]]").unwrap()..text.find("[[obstacle]]").unwrap()];
        let reported = format!("[[sensor]]\nname = \"watch\"\nkind = \"reported\"\n{signal}[pose]\ny = \"person.y\"\n");
        let own = "[parameters]\n\"curtain.own_y\" = -0.55\n\"curtain.own_depth\" = 0.3\n";
        with(&with(&text, sensor, &reported), "[parameters]\n", own)
    };
    let dir = folder("gantry.fmu");
    let boolean = from_start(dir.path(), &inside("variable = \"curtain.interrupted\"\nactive = true\n"));
    let number =
        from_start(dir.path(), &inside("variable = \"curtain.state\"\nvalues = { clear = 7, detected = 4 }\n"));
    assert!(!boolean["hazards"].as_array().unwrap().is_empty());
    assert_same_hazards(&boolean, &number);
    let seen = |scan: &serde_json::Value| -> Vec<String> {
        scan["hazards"].as_array().unwrap().iter().map(|hazard| hazard["sensors"].to_string()).collect()
    };
    assert!(seen(&boolean).iter().any(|sensors| sensors.contains("watch")), "{:?}", seen(&boolean));
    assert_eq!(seen(&boolean), seen(&number));
}

#[test]
fn values_that_cannot_be_are_refused() {
    let dir = folder("gantry.fmu");
    let refused: &[(&str, &[&str])] = &[
        (
            "variable = \"plc.gate_state\"\nactive = false\n",
            &["input `plc.gate_state` of sensor `watch` is a number", "values = {"],
        ),
        ("variable = \"plc.gate_state\"\n", &["does not say which value", "values = { clear = 1, detected = 0 }"]),
        ("variable = \"plc.gate_state\"\nvalues = { clear = 1, detected = 1 }\n", &["says the same whether"]),
        ("variable = \"plc.gate_state\"\nvalues = { clear = 1, detected = 0.5 }\n", &["needs a whole number"]),
        (
            "variable = \"plc.gate_state\"\nvalues = { clear = 1, detected = 0 }\nactive = true\n",
            &["both `active` and `values`"],
        ),
        (
            "variable = \"plc.door_clear\"\nvalues = { clear = 1, detected = 0 }\n",
            &["is true or false, and has no other values"],
        ),
        ("variable = \"plc.mat_level\"\nvalues = { clear = 0, detected = nan }\n", &["`values` of sensor `watch`"]),
        ("variable = \"person.y\"\nvalues = { clear = 0 }\n", &["missing field `detected`"]),
    ];
    for (signal, expected) in refused {
        write(dir.path(), "cell.toml", &with(&cell(WATCHES[0], "PLC"), BOOLEAN, signal));
        let output = fmi_hazard(dir.path()).args(["check", "cell.toml"]).output().unwrap();
        let text = String::from_utf8_lossy(&output.stdout).into_owned() + &String::from_utf8_lossy(&output.stderr);
        assert_eq!(output.status.code(), Some(2), "{signal}: {text}");
        assert!(expected.iter().all(|part| text.contains(part)), "{signal}: {text}");
    }
}
