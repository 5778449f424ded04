//! modelDescription.xml that is broken, hostile, contradictory or odd: refused with the place and what to do, or taken
//! with a warning. Each is made here from that of a working test FMU by one change.

use std::fmt::Write as _;

use crate::common::archives::{
    BINARY, XML, entries, entries_of, folder_with, inspected, pack, refused, run, same, with, with_xml,
};
use crate::common::hostile::{CELL, FMU, Hostile};
use crate::common::{faulty_cell, write};

/// With one piece of the description replaced.
fn changed(from: &str, to: &str) -> Vec<u8> {
    with_xml(|x| x.replacen(from, to, 1))
}

/// The same of the FMI 3.0 test FMU.
fn changed3(from: &str, to: &str) -> Vec<u8> {
    let mut all = entries_of("faulty-fmi3.fmu");
    let xml = all.iter_mut().find(|(name, _)| name == XML).unwrap();
    let text = String::from_utf8(xml.1.clone()).unwrap();
    assert!(text.contains(from), "{text}");
    xml.1 = text.replacen(from, to, 1).into_bytes();
    pack(&all)
}

/// Refused with this message about modelDescription.xml.
#[track_caller]
fn wrong(fmu: &[u8], place_and_message: &str) {
    refused("inspect", fmu, &format!("modelDescription.xml of x.fmu, {place_and_message}"));
}

#[test]
fn xml_that_is_broken() {
    wrong(
        &changed("</ModelVariables>", ""),
        "line 61, column 1: this is not well-formed XML: ill-formed document: expected `</ModelVariables>`, but \
         `</fmiModelDescription>` was found",
    );
    wrong(&with(XML, |_| b"".to_vec()), "line 1, column 1: there is no <fmiModelDescription> element");
    wrong(&with(XML, |_| b"no XML".to_vec()), "line 1, column 1: there is no <fmiModelDescription> element");
    wrong(
        &with(XML, |_| b"<html/>".to_vec()),
        "line 1, column 1: the root element is <html>, it must be <fmiModelDescription>",
    );
    wrong(
        &with(XML, |b| b[..b.len() - 30].to_vec()),
        "line 60, column 3: this is not well-formed XML: syntax error: tag not closed: `>` not found before end of input",
    );
    wrong(&changed("</fmiModelDescription>", ""), "line 62, column 1: the file ends inside <fmiModelDescription>");
    wrong(
        &with_xml(|x| format!("{x}<fmiModelDescription fmiVersion=\"2.0\"/>")),
        "line 62, column 1: in <fmiModelDescription>: a second root element, the file must have one",
    );
    wrong(
        &changed("modelName=\"faulty\"", "modelName=\"faulty\" modelName=\"other\""),
        "line 2, column 1: in <fmiModelDescription>: position 60: duplicated attribute, previous declaration at \
         position 41",
    );
}

#[test]
fn entities_and_document_types() {
    let doctype = "a DOCTYPE, which FMUs never need and which can be abused; refused";
    for entity in ["b \"c\"", "b SYSTEM \"file:///etc/passwd\"", "% b SYSTEM \"http://localhost/x\""] {
        let text = format!("<!DOCTYPE a [<!ENTITY {entity}>]><fmiModelDescription");
        wrong(&changed("<fmiModelDescription", &text), &format!("line 2, column 1: {doctype}"));
    }
    let text = "in <fmiModelDescription>: at 1..5: unrecognized entity `evil`";
    wrong(&changed("modelName=\"faulty\"", "modelName=\"&evil;\""), &format!("line 2, column 1: {text}"));
    // The five entities of XML and character references are what they are.
    let name = changed("modelName=\"faulty\"", "modelName=\"&lt;&#65;&amp;&#x1b;\"");
    assert!(inspected(&name, &[]).contains("FMI 2.0  \"<A&\\u{1b}\""));
}

#[test]
fn encodings() {
    let latin = with(XML, |b| {
        let text = String::from_utf8(b.to_vec()).unwrap();
        let text = text.replace("UTF-8", "ISO-8859-1").replace("Angle of", "Gr\u{f6}\u{df}e of");
        text.chars().map(|c| u8::try_from(u32::from(c)).unwrap()).collect()
    });
    wrong(&latin, "line 44, column 64: this is not UTF-8, which FMI asks for. Save the file as UTF-8");
    let encoded = |to_bytes: fn(u16) -> [u8; 2], mark: &[u8]| {
        with(XML, |b| {
            let text = String::from_utf8(b.to_vec()).unwrap().replace("UTF-8", "UTF-16").replace("Angle", "\u{1f5ff}");
            mark.iter().copied().chain(text.encode_utf16().flat_map(to_bytes)).collect()
        })
    };
    let warning = ["line 1: the file is UTF-16, FMI asks for UTF-8: other programs may not read it"];
    for mark in [&[0xFF, 0xFE][..], &[]] {
        assert!(inspected(&encoded(u16::to_le_bytes, mark), &warning).contains("\u{1f5ff} of the joint"));
    }
    for mark in [&[0xFE, 0xFF][..], &[]] {
        assert!(inspected(&encoded(u16::to_be_bytes, mark), &warning).contains("\u{1f5ff} of the joint"));
    }
    wrong(
        &with(XML, |_| b"\xFF\xFE<\0a".to_vec()),
        "line 1, column 2: the file ends within a character of UTF-16. Save the file as UTF-8",
    );
    wrong(
        &with(XML, |_| b"\xFF\xFE<\0\x00\xD8<\0".to_vec()),
        "line 1, column 2: this is not UTF-16, although the file begins like it. Save the file as UTF-8",
    );
    inspected(&with(XML, |b| [b"\xEF\xBB\xBF", b].concat()), &[]);
}

#[test]
fn other_versions_and_kinds() {
    let version = |v: &str| changed("fmiVersion=\"2.0\"", &format!("fmiVersion=\"{v}\""));
    let first = "x.fmu: this is an FMI 1.0 FMU; FMI 2.0 co-simulation is needed, or FMI 3.0. Export it as FMI 2.0";
    refused("inspect", &version("1.0"), first);
    let next = "x.fmu: this is an FMI 3.1-beta.1 FMU, a version this program does not know (3.0 and 3.0.x are known). \
                Export it as FMI 3.0 or FMI 2.0";
    refused("inspect", &version("3.1-beta.1"), next);
    let text = "line 2, column 1: in <fmiModelDescription>: the attribute `instantiationToken` is missing";
    wrong(&version("3.0"), text);
    let text = "line 2, column 1: in <fmiModelDescription>: the attribute `fmiVersion` is missing";
    wrong(&changed("fmiVersion=\"2.0\"", ""), text);
    let exchange = with_xml(|x| x.replace("<CoSimulation", "<ModelExchange"));
    let none = "x.fmu: this FMU has no co-simulation interface, only model exchange. Export it as Co-Simulation";
    refused("inspect", &exchange, none);
    let two = changed("<UnitDefinitions>", "<CoSimulation modelIdentifier=\"b\"/><UnitDefinitions>");
    wrong(&two, "line 17, column 3: in <CoSimulation>: a second co-simulation interface, an FMU has one at most");
}

#[test]
fn model_identifiers_that_name_other_files() {
    for (identifier, shown) in [
        ("../../tmp/x", "../../tmp/x"),
        ("a;rm -rf b", "a;rm -rf b"),
        ("$(id)", "$(id)"),
        ("a&#10;b", "a\\nb"),
        ("\u{430}bc", "\u{430}bc"),
        ("", ""),
    ] {
        let fmu = changed("modelIdentifier=\"faulty\"", &format!("modelIdentifier=\"{identifier}\""));
        let message = "could name a file outside the FMU; refused. FMI asks for a C identifier";
        wrong(&fmu, &format!("line 11, column 3: in <CoSimulation>: modelIdentifier \"{shown}\" {message}"));
    }
}

/// Vendors' exporters put hyphens and dots there, which name the binary just as well.
#[test]
fn model_identifiers_that_are_file_names() {
    let mut all = entries();
    for (name, content) in &mut all {
        if name == BINARY {
            *name = name.replace("faulty.so", "my-cell.v2.so");
        } else if name == XML {
            let text = String::from_utf8(std::mem::take(content)).unwrap();
            *content = text.replace("modelIdentifier=\"faulty\"", "modelIdentifier=\"my-cell.v2\"").into_bytes();
        }
    }
    let dir = folder_with(&pack(&all));
    let (code, _, said) = run(dir.path(), &["inspect", "--self-test", "x.fmu"]);
    assert_eq!(code, 0, "{said}");
}

#[test]
fn names_and_references_that_stand_twice() {
    let twice = "line 47, column 1: two variables are called `q` (the other is in line 44)";
    wrong(&changed("name=\"qd\"", "name=\"q\""), twice);
    // An output that is an input: taken with a warning, but not where a cell uses both.
    let alias = changed("name=\"qd\" valueReference=\"6\"", "name=\"qd\" valueReference=\"4\"");
    let text = "output `qd` and input `push` are one variable (value reference 4): reading it gives what was written";
    inspected(&alias, &[&format!("line 47: {text}")]);
    let dir = folder_with(&alias);
    let cell = faulty_cell("x.fmu", 0, 0).replace("[human]", "[inputs]\n\"push\" = 0.1\n[human]");
    write(dir.path(), "cell.toml", &cell);
    let (code, _, stderr) = run(dir.path(), &["scan", "--no-advice", "cell.toml"]);
    let text = "Error: × `qd` and `push` are one variable in the FMU (value reference 4): reading the one gives what \
                was written to the other ╭─[cell.toml:1:1] 1 schema = 1 · ─────┬──── · ╰── in this file 2 name = \"faulty\" \
                ╰──── help: use another output, or have the FMU exported with a value reference for each";
    same(&stderr, text);
    assert_eq!(code, 2);
    let both = changed3("name=\"qd\" valueReference=\"6\"", "name=\"qd\" valueReference=\"5\"");
    let text = "in <Float64>: `qd` has the value reference 5 of `q` (line 36), in FMI 3.0 each variable has its own";
    wrong(&both, &format!("line 37, column 5: {text}"));
}

#[test]
fn units() {
    let undefined = with_xml(|x| x.replace("<Unit name=\"rad\">", "<Unit name=\"radian\">"));
    inspected(&undefined, &["line 44: `q` is in `rad`, a unit that the file does not define"]);
    // (unit of `q` in the FMU, unit in the cell, exit code is 2 and the message, or none)
    let scan = |fmu: &[u8], unit: &str| {
        let dir = folder_with(fmu);
        let unit = format!("variable = \"q\"{unit} }}");
        let cell = faulty_cell("x.fmu", 0, 0).replace("variable = \"q\", unit = \"rad\" }", &unit);
        write(dir.path(), "cell.toml", &cell.replace("iterations = 12", "iterations = 1"));
        let (code, stdout, stderr) =
            run(dir.path(), &["scan", "--no-advice", "cell.toml", "--strategy", "random", "--out", "o"]);
        (code, stdout + &stderr)
    };
    let in_mm = changed("<Real unit=\"rad\"/>", "<Real unit=\"mm\"/>");
    let (code, text) = scan(&in_mm, "");
    assert!(text.contains("`q` is in `mm`, which does not fit here") && text.contains("rad, deg, mrad"), "{text}");
    assert_eq!(code, 2);
    let (code, text) = scan(&in_mm, ", unit = \"rad\"");
    assert!(text.contains("the FMU says that `q` is in `mm`, the cell says `rad`"), "{text}");
    assert_eq!(code, 2);
    let none = changed("<Real unit=\"rad\"/>", "<Real/>");
    let (code, text) = scan(&none, "");
    assert!(text.contains("`q` has no unit in the FMU: taken as rad; confirm with unit = \"rad\""), "{text}");
    assert_ne!(code, 2);
    let (code, text) = scan(&none, ", unit = \"rad\"");
    assert!(!text.contains("has no unit"), "{text}");
    assert_ne!(code, 2);
}

#[test]
fn units_that_fit_are_converted() {
    use fmi_hazard::cell::binding::{BoundUnit, MotionBinding, bind};
    const TURN: f64 = std::f64::consts::PI;
    for (angle, speed, mass, [rad, rad_s, kg]) in [
        ("rad", "rad/s", "kg", [1.0, 1.0, 1.0]),
        ("deg", "deg/s", "g", [TURN / 180.0, TURN / 180.0, 1e-3]),
        ("mrad", "rpm", "kg", [1e-3, TURN / 30.0, 1.0]),
        ("rad", "1/min", "kg", [1.0, TURN / 30.0, 1.0]),
    ] {
        let load = "<ScalarVariable name=\"load\" valueReference=\"7\" causality=\"output\"><Real unit=\"kg\"/></ScalarVariable>";
        let fmu = with_xml(|x| {
            x.replace("</ModelVariables>", &format!("{load}</ModelVariables>"))
                .replace("<Real unit=\"rad\"/>", &format!("<Real unit=\"{angle}\"/>"))
                .replace("<Real unit=\"rad/s\"/>", &format!("<Real unit=\"{speed}\"/>"))
                .replace("unit=\"kg\"", &format!("unit=\"{mass}\""))
        });
        let dir = folder_with(&fmu);
        let cell = faulty_cell("x.fmu", 0, 0)
            .replace(", unit = \"rad\"", "")
            .replace(", unit = \"rad/s\"", "")
            .replace("payload_kg = 3", "payload = { variable = \"load\" }");
        let opened = fmi_hazard::cell::find::open(&write(dir.path(), "cell.toml", &cell), None).unwrap();
        let (name, fmu) = &opened.fmus[0];
        let unit = BoundUnit { name, description: fmu.description(), file: "x.fmu".to_owned() };
        let binding = bind(opened.cell.file(), &opened.source, &[unit], None).unwrap();
        let MotionBinding::Joints { positions: angles, speeds } = &binding.robots[0].motion else { panic!("joints") };
        // All outputs one: what is read is the factor.
        let ones = vec![1.0; binding.outputs.len()];
        let read = [angles[0].read(&ones), speeds[0].read(&ones), binding.robots[0].payload.read(&ones)];
        for (read, expected) in read.into_iter().zip([rad, rad_s, kg]) {
            assert!((read - expected).abs() < 1e-12, "{angle} {speed} {mass}: {read} {expected}");
        }
        assert!(binding.warnings.is_empty(), "{:?}", binding.warnings);
    }
}

#[test]
fn start_values_and_limits() {
    let push = "<Real unit=\"rad/s\" min=\"-1.0\" max=\"1.0\" start=\"0.0\"/>";
    let with = |attributes: &str| changed(push, &format!("<Real unit=\"rad/s\" {attributes}/>"));
    wrong(&with("start=\"fast\""), "line 42, column 7: in <Real>: `start` is \"fast\", which is no such number");
    wrong(&with("min=\"1,5\""), "line 42, column 7: in <Real>: `min` is \"1,5\", which is no such number");
    wrong(
        &changed("<Boolean start=\"false\"/>", "<Boolean start=\"no\"/>"),
        "line 39, column 7: in <Boolean>: `start` is \"no\", it must be true or false",
    );
    wrong(
        &changed("max=\"21\" start=\"0\"", "max=\"21\" start=\"0.5\""),
        "line 33, column 7: in <Integer>: `start` is \"0.5\", which is no such number",
    );
    for start in ["NaN", "INF", "-INF"] {
        let text = "line 42: the start value of `push` is not finite";
        inspected(&with(&format!("start=\"{start}\"")), &[text]);
    }
    let outside = "line 42: the start value 2 of `push` is outside its limits, -1 to 1";
    inspected(&with("min=\"-1\" max=\"1\" start=\"2\""), &[outside]);
    let outside = "line 42: the start value -2 of `push` is outside its limits, -1 to inf";
    inspected(&with("min=\"-1\" start=\"-2\""), &[outside]);
    let limits = "line 42: the limits of `push` make no sense: min 2, max 1";
    inspected(&with("min=\"2\" max=\"1\" start=\"0\""), &[limits]);
    let integer = "line 33: the start value 22 of `fault.kind` is outside its limits, 0 to 21";
    inspected(&changed("max=\"21\" start=\"0\"", "max=\"21\" start=\"22\""), &[integer]);
    // A cell that leaves the limits is told so.
    let dir = folder_with(&with("min=\"-0.1\" max=\"0.1\" start=\"0\""));
    let cell = faulty_cell("x.fmu", 0, 0).replace("[human]", "[inputs]\n\"push\" = 0.5\n[human]");
    write(dir.path(), "cell.toml", &cell.replace("iterations = 12", "iterations = 1"));
    let (_, _, stderr) = run(dir.path(), &["scan", "--no-advice", "cell.toml", "--strategy", "random", "--out", "o"]);
    assert!(stderr.contains("Warning `push` is set to 0.5, the FMU allows -0.1 to 0.1"), "{stderr}");
}

#[test]
fn experiments_that_make_no_sense() {
    let good = "startTime=\"0\" stopTime=\"60\" stepSize=\"0.02\"";
    let with = |attributes: &str| changed(good, attributes);
    for (attributes, warning) in [
        ("startTime=\"3\" stopTime=\"2\"", "stopTime 2 is before startTime 3"),
        ("stopTime=\"-1\"", "stopTime -1 is before startTime 0"),
        ("stopTime=\"NaN\"", "stopTime is NaN, which is no time"),
        ("startTime=\"-INF\"", "startTime is -inf, which is no time"),
        ("stepSize=\"0\"", "stepSize 0 is not greater than zero"),
        ("stepSize=\"-1e-300\"", "stepSize -1e-300 is not greater than zero"),
        ("stepSize=\"1e999\"", "stepSize is inf, which is no time"),
        ("stopTime=\"2\" stepSize=\"1e9\"", "stepSize 1000000000 is longer than the experiment"),
    ] {
        let fmu = with(attributes);
        inspected(&fmu, &[&format!("line 27: {warning}; ignored")]);
        // The self-test then takes its own step.
        let (code, stdout, _) = run(folder_with(&fmu).path(), &["inspect", "--self-test", "x.fmu", "--steps", "8"]);
        assert!(stdout.starts_with("faulty: 8 steps of 0.02 s"), "{stdout}");
        assert_eq!(code, 0);
    }
    inspected(&changed(&format!("<DefaultExperiment {good}/>"), ""), &[]);
    wrong(
        &with("stepSize=\"quick\""),
        "line 27, column 3: in <DefaultExperiment>: `stepSize` is \"quick\", which is no such number",
    );
}

#[test]
fn a_stop_time_is_kept_where_an_fmu_is_tried_out_and_told_where_a_scan_goes_beyond_it() {
    for hostile in Hostile::both() {
        // It ends with its stopTime, as some do.
        let dir = tempfile::TempDir::new().unwrap();
        hostile.clone().what("status-error").at("step", 50).stop_time("1").write(dir.path());
        let (code, stdout, stderr) = run(dir.path(), &["inspect", "--self-test", FMU]);
        let told = stdout.contains(": 50 steps of 0.02 s") && stdout.contains("50 steps instead of 80: the FMU gives");
        assert!(code == 0 && told && stdout.contains("stopTime of 1 s"), "{stdout} {stderr}");
        let (code, _, stderr) = run(dir.path(), &["inspect", "--self-test", FMU, "--steps", "60"]);
        assert!(code == 3 && stderr.contains("60 steps of 0.02 s go beyond the stopTime of 1 s"), "{stderr}");
        let (code, stdout, stderr) = run(dir.path(), &["inspect", "--run", FMU, "--fmu-only"]);
        let told = stdout.contains(" in 1 s\n") && stdout.contains("of 1 s instead of 10 s");
        assert!(code == 0 && told, "{stdout} {stderr}");
        // A scan needs 1.6 s of it.
        let (code, _, stderr) = run(dir.path(), &["check", CELL]);
        assert!(code == 3 && stderr.contains("It was run beyond its stopTime of 1 s"), "{stderr}");
        hostile.clone().what("status-error").at("step", 80).stop_time("1.6").write(dir.path());
        let (code, stdout, stderr) = run(dir.path(), &["check", CELL]);
        assert!(code == 0 && stdout.contains(" in 1.6 s while nobody"), "{stdout} {stderr}");
        assert!(!stderr.contains("stopTime"), "{stderr}");
        // It goes on: so does a scan, and says so.
        hostile.clone().stop_time("1").write(dir.path());
        let (code, _, stderr) = run(dir.path(), &["check", CELL]);
        let warning = "sequences go on to 1.60 s (8 actions of 0.2 s), beyond the stopTime of 1 s that x.fmu gives";
        assert!(code == 0 && stderr.contains(warning) && stderr.contains("search.actions"), "{stderr}");
    }
}

#[test]
fn a_unit_that_nothing_can_be_converted_with_is_not_computed_with() {
    for (attributes, told) in [
        ("factor=\"0\"", "the factor 0 and the offset 0"),
        ("factor=\"NaN\"", "the factor NaN and the offset 0"),
        ("factor=\"1e999\"", "the factor inf and the offset 0"),
        ("factor=\"ten\"", "the factor NaN and the offset 0"),
        ("factor=\"1e-300\" offset=\"NaN\"", "the factor 1e-300 and the offset NaN"),
    ] {
        let unit = "<Unit name=\"rad\"><BaseUnit";
        let fmu = changed(unit, &format!("{unit} {attributes}"));
        let dir = folder_with(&fmu);
        let (_, _, stderr) = run(dir.path(), &["inspect", "x.fmu"]);
        let warning = format!("unit `rad` has {told}: nothing can be converted with it");
        assert!(stderr.contains(&warning), "{attributes}: {stderr}");
        let cell = faulty_cell("x.fmu", 0, 0);
        write(dir.path(), "cell.toml", &cell.replace(", unit = \"rad\" }", " }"));
        let (code, _, stderr) = run(dir.path(), &["check", "cell.toml", "--no-run"]);
        let words = "`q` is in `rad`, which modelDescription.xml defines with the factor";
        assert!(code == 2 && stderr.contains(words) && stderr.contains("unit = \"rad\""), "{attributes}: {stderr}");
        // Who says what is meant can use it.
        write(dir.path(), "cell.toml", &cell);
        assert_eq!(run(dir.path(), &["check", "cell.toml", "--no-run"]).0, 0, "{attributes}");
    }
    // As every FMU has it.
    let fmu = changed("<Unit name=\"rad\"><BaseUnit", "<Unit name=\"rad\"><BaseUnit factor=\"1\" offset=\"0\"");
    let dir = folder_with(&fmu);
    write(dir.path(), "cell.toml", &faulty_cell("x.fmu", 0, 0).replace(", unit = \"rad\" }", " }"));
    assert_eq!(run(dir.path(), &["check", "cell.toml", "--no-run"]).0, 0);
}

#[test]
fn what_the_fmu_needs_is_said() {
    let flags = |flags: &str| changed("canBeInstantiatedOnlyOncePerProcess=\"false\"", flags);
    let text = "line 11: the FMU needs the tool that made it (needsExecutionTool): it runs only where that tool is \
                installed and licensed";
    let stdout = inspected(&flags("needsExecutionTool=\"true\""), &[text]);
    assert!(stdout.contains("needs its tool yes"), "{stdout}");
    let stdout = inspected(&flags("canBeInstantiatedOnlyOncePerProcess=\"true\""), &[]);
    assert!(stdout.contains("once per process yes"), "{stdout}");
    let fixed = "canHandleVariableCommunicationStepSize=\"";
    let stdout = inspected(&changed(&format!("{fixed}true"), &format!("{fixed}false")), &[]);
    assert!(stdout.contains("variable step no"), "{stdout}");
    let text = "line 11, column 3: in <CoSimulation>: `needsExecutionTool` is \"maybe\", it must be true or false";
    wrong(&flags("needsExecutionTool=\"maybe\""), text);
}

#[test]
fn names_that_steer_the_terminal_or_turn_text_around() {
    let evil = "q\u{9b}2J\u{202e}&#27;[2J&#10;\u{2066}";
    let shown = "q\\u{9b}2J\\u{202e}\\u{1b}[2J\\n\\u{2066}";
    let all = with_xml(|x| {
        x.replace("name=\"q\"", &format!("name=\"{evil}\""))
            .replace("unit=\"rad\"", &format!("unit=\"{evil}\""))
            .replace("modelName=\"faulty\"", &format!("modelName=\"{evil}\""))
            .replace("generationTool=\"", &format!("generationTool=\"{evil}"))
            .replace("Angle of", evil)
    });
    let text = format!("line 44: `{shown}` is in `{shown}`, a unit that the file does not define");
    let stdout = inspected(&all, &[&text]);
    assert_eq!(stdout.matches(shown).count(), 5, "{stdout}");
    let clean = |text: &str| !text.contains(|c: char| c != '\n' && fmi_hazard::fmi::is_unsafe(c));
    assert!(clean(&stdout), "{stdout}");
    // Where a cell's mistake makes it be named, and in what a scan and a self-test print.
    let dir = folder_with(&all);
    write(dir.path(), "cell.toml", &faulty_cell("x.fmu", 0, 0).replace("\"q\"", "\"q\\u001b\""));
    for arguments in [
        &["scan", "--from", "start", "--no-advice", "cell.toml"][..],
        &["inspect", "--self-test", "x.fmu"],
        &["inspect", "--self-test", "x.fmu", "--format", "json"],
    ] {
        let output = crate::common::fmi_hazard(dir.path()).args(arguments).output().unwrap();
        for bytes in [output.stdout, output.stderr] {
            let text = String::from_utf8(bytes).unwrap();
            assert!(clean(&text), "{text:?}");
        }
    }
}

#[test]
fn names_of_seventy_thousand_characters() {
    let long = "n".repeat(70_000);
    let fmu = with_xml(|x| x.replace("name=\"q\"", &format!("name=\"{long}\"")));
    let stdout = inspected(&fmu, &[]);
    assert!(stdout.contains("nnn ... (69600 characters left out) ... nnn") && stdout.len() < 3000, "{stdout}");
    let twice =
        with_xml(|x| x.replace("name=\"q\"", &format!("name=\"{long}\"")).replace("\"qd\"", &format!("\"{long}\"")));
    let message = format!(
        "line 47, column 1: two variables are called `{} ... (69653 characters left out) ... {}` (the other is in line 44)",
        &long[..174],
        &long[..173]
    );
    wrong(&twice, &message);
}

#[test]
fn a_hundred_thousand_variables() {
    let fmu = with_xml(|x| {
        let mut more = String::new();
        for i in 0..100_000 {
            let _ =
                writeln!(more, "<ScalarVariable name=\"v[{i}]\" valueReference=\"{}\"><Real/></ScalarVariable>", i + 7);
        }
        x.replace("</ModelVariables>", &format!("{more}</ModelVariables>"))
    });
    let stdout = inspected(&fmu, &[]);
    assert!(stdout.contains("variables    100007 (2 inputs, 2 outputs, 2 parameters, 100000 locals)"), "{stdout}");
}
