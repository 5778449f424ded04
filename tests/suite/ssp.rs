//! Systems of FMUs from SSP files: the same hazards as the FMU that is all of them in one, the same outputs as FMPy, and
//! clear words about what is not supported.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use crate::common::archives::pack;
use crate::common::fmpy::python;
use crate::common::{examples, fmi_hazard, scan_json, write};
use crate::sample;
use fmi_hazard::host::Plant as _;

const PARTS: [&str; 3] = ["plc", "controller", "kinematics"];
const TOOL: [&str; 6] =
    ["tcp.position.x", "tcp.position.y", "tcp.position.z", "tcp.velocity.x", "tcp.velocity.y", "tcp.velocity.z"];

/// The sensor mat's three FMUs as a system. `more` may change its description.
fn description(more: impl Fn(String) -> String) -> String {
    let connector = |name: &str, kind: &str, value: &str| {
        format!("<ssd:Connector name=\"{name}\" kind=\"{kind}\"><ssc:{value}/></ssd:Connector>\n")
    };
    let joints: Vec<String> =
        (1..=6).flat_map(|n| [format!("q[{n}]"), format!("qd[{n}]")]).chain(["payload".to_owned()]).collect();
    let outputs: String = joints.iter().map(|name| connector(name, "output", "Real")).collect();
    let tool = |kind: &str| TOOL.iter().map(|name| connector(name, kind, "Real")).collect::<String>();
    let component = |name: &str, connectors: &str| {
        format!(
            "<ssd:Component name=\"{name}\" type=\"application/x-fmu-sharedlibrary\" \
             source=\"resources/sensor-mat-{name}.fmu\" implementation=\"CoSimulation\">\n<ssd:Connectors>\n{connectors}\
             </ssd:Connectors>\n</ssd:Component>\n"
        )
    };
    let mut connections = String::from(
        "<ssd:Connection startConnector=\"mat_clear\" endElement=\"plc\" endConnector=\"mat_clear\"/>\n\
         <ssd:Connection startConnector=\"reset\" endElement=\"plc\" endConnector=\"reset\"/>\n\
         <ssd:Connection startElement=\"plc\" startConnector=\"stop\" endElement=\"controller\" endConnector=\"stop\"/>\n\
         <ssd:Connection startElement=\"controller\" startConnector=\"leg\" endConnector=\"leg\"/>\n",
    );
    for name in TOOL {
        writeln!(
            connections,
            "<ssd:Connection startElement=\"controller\" startConnector=\"{name}\" endElement=\"kinematics\" \
             endConnector=\"{name}\"/>"
        )
        .unwrap();
    }
    for name in &joints {
        writeln!(
            connections,
            "<ssd:Connection startElement=\"kinematics\" startConnector=\"{name}\" endConnector=\"{name}\"/>"
        )
        .unwrap();
    }
    let boolean = |name: &str, kind: &str| connector(name, kind, "Boolean");
    more(format!(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<ssd:SystemStructureDescription version=\"1.0\" name=\"mat\" \
         xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\" \
         xmlns:ssc=\"http://ssp-standard.org/SSP1/SystemStructureCommon\" \
         xmlns:ssv=\"http://ssp-standard.org/SSP1/SystemStructureParameterValues\">\n<ssd:System name=\"cell\">\n\
         <ssd:Connectors>\n{}{}{}{outputs}</ssd:Connectors>\n<ssd:Elements>\n{}{}{}</ssd:Elements>\n<ssd:Connections>\n\
         {connections}</ssd:Connections>\n</ssd:System>\n<ssd:DefaultExperiment startTime=\"0\" stopTime=\"1.6\"/>\n\
         </ssd:SystemStructureDescription>\n",
        boolean("mat_clear", "input"),
        boolean("reset", "input"),
        connector("leg", "output", "Integer"),
        component("plc", &(boolean("mat_clear", "input") + &boolean("reset", "input") + &boolean("stop", "output"))),
        component("controller", &(boolean("stop", "input") + &tool("output") + &connector("leg", "output", "Integer"))),
        component("kinematics", &(tool("input") + &outputs)),
    ))
}

/// Writes the system with this description and further files to `folder/mat.ssp`.
fn system(folder: &Path, description: &str, version: &str, files: &[(&str, &str)]) {
    let mut entries = vec![("SystemStructure.ssd".to_owned(), description.as_bytes().to_vec())];
    for part in PARTS {
        let fmu = std::fs::read(folder.join(format!("sensor-mat-{part}{version}.fmu"))).unwrap();
        entries.push((format!("resources/sensor-mat-{part}.fmu"), fmu));
    }
    entries.extend(files.iter().map(|(name, text)| ((*name).to_owned(), text.as_bytes().to_vec())));
    std::fs::write(folder.join("mat.ssp"), pack(&entries)).unwrap();
}

/// The coupled cell with the system in place of its units and connections, by the system's own names. `delay` holds the
/// safety controller's signal back, as the coupled cell does.
fn cell(folder: &Path, delay: bool) -> String {
    let text = std::fs::read_to_string(folder.join("coupled.toml")).unwrap();
    let mut table: toml::Table = text.parse().unwrap();
    table.remove("unit");
    table.remove("connection");
    table.insert("fmu".to_owned(), "mat.ssp".into());
    let mut text = toml::to_string(&table).unwrap();
    for part in ["kinematics:", "plc:", "controller:"] {
        text = text.replace(part, "");
    }
    if delay {
        text += "\n[[connection]]\nfrom = \"plc:stop\"\nto = \"controller:stop\"\ndelay_steps = 1\n";
    }
    text
}

fn scan(folder: &Path, file: &str) -> serde_json::Value {
    let arguments = ["--seed", "5", "--iterations", "60", "--strategy", "random", "--out", "o"];
    fmi_hazard(folder).args(["scan", "--no-advice"]).arg(file).args(arguments).assert().code(1);
    scan_json(&folder.join("o"))
}

fn hazards(scan: &serde_json::Value) -> Vec<serde_json::Value> {
    let mut hazards = scan["hazards"].as_array().unwrap().clone();
    hazards.sort_by_key(|h| h["id"].as_str().unwrap().to_owned());
    hazards
}

#[test]
fn a_system_of_three_fmus_has_the_hazards_of_the_one() {
    if !sample::is_turn(3, 6) {
        return;
    }
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    let one = std::fs::read_to_string(folder.join("cell.toml")).unwrap();
    write(&folder, "one.toml", &one.replace("step_s = 0.02", "step_s = 0.01"));
    let one = scan(&folder, "one.toml");
    for version in sample::some(["", "-fmi3"], 2) {
        system(&folder, &description(|text| text), version, &[]);
        // As exact as the coupled cell: the stop counts from the next step on, as in the one FMU.
        write(&folder, "delayed.toml", &cell(&folder, true));
        let delayed = scan(&folder, "delayed.toml");
        let (a, b) = (hazards(&one), hazards(&delayed));
        assert!(!a.is_empty() && a.len() == b.len());
        for (a, b) in a.iter().zip(&b) {
            assert_eq!((&a["id"], &a["actions"], &a["time_s"]), (&b["id"], &b["actions"], &b["time_s"]));
            assert!((a["force_n"].as_f64().unwrap() - b["force_n"].as_f64().unwrap()).abs() < 1e-6, "{a} {b}");
        }
        let coupling = |scan: &serde_json::Value| scan["subject"]["couplings"][0].as_str().unwrap().to_owned();
        assert!(coupling(&delayed).contains("plc:stop -> controller:stop: 10 ms later"), "{}", coupling(&delayed));
        assert_eq!(delayed["subject"]["files"][0]["path"], "mat.ssp");
        // As the system says: the stop acts up to a step early, and the scan says so. Every sequence that hurts then hurts
        // in the one FMU too, and no contact is more than a step away in time.
        write(&folder, "plain.toml", &cell(&folder, false));
        let plain = scan(&folder, "plain.toml");
        assert!(coupling(&plain).contains("acts up to 10 ms early, never late"), "{}", coupling(&plain));
        let b = hazards(&plain);
        let same = b.iter().filter(|h| a.iter().any(|other| other["id"] == h["id"])).count();
        assert!(same * 10 >= a.len() * 9 && b.len() * 10 >= a.len() * 9, "{same} of {} and {}", a.len(), b.len());
        for hazard in &b {
            let Some(other) = a.iter().find(|other| other["actions"] == hazard["actions"]) else { continue };
            let apart = hazard["time_s"].as_f64().unwrap() - other["time_s"].as_f64().unwrap();
            assert!(apart.abs() < 0.0101, "{apart} s apart: {hazard} {other}");
        }
    }
}

#[test]
fn the_cell_may_travel_beside_or_inside_the_system() {
    if !sample::is_turn(0, 6) {
        return;
    }
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    let own = cell(&folder, true).replace("fmu = \"mat.ssp\"", "");
    system(&folder, &description(|text| text), "", &[("extra/io.github.fmi-hazard/cell.toml", &own)]);
    let inside = scan(&folder, "mat.ssp");
    assert!(inside["subject"]["cell_found"].as_str().unwrap().contains("mat.ssp!extra/io.github.fmi-hazard/cell.toml"));
    write(&folder, "mat.cell.toml", &cell(&folder, true));
    let beside = scan(&folder, "mat.ssp");
    assert!(beside["subject"]["cell_found"].as_str().unwrap().ends_with("mat.cell.toml"));
    assert_eq!(hazards(&inside), hazards(&beside));
    // A bare description beside its resources.
    std::fs::create_dir(folder.join("resources")).unwrap();
    for part in PARTS {
        let name = format!("sensor-mat-{part}.fmu");
        std::fs::copy(folder.join(&name), folder.join("resources").join(&name)).unwrap();
    }
    write(&folder, "mat.ssd", &description(|text| text));
    write(&folder, "bare.toml", &cell(&folder, true).replace("mat.ssp", "mat.ssd"));
    assert_eq!(hazards(&scan(&folder, "bare.toml")), hazards(&beside));
    let output = fmi_hazard(&folder).args(["check", "bare.toml"]).assert().code(0).get_output().clone();
    assert!(String::from_utf8_lossy(&output.stdout).contains("nothing wrong"));
}

#[test]
fn outputs_are_those_that_fmpy_simulates() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    // Without the kinematics: FMPy begins with a tool at 0, 0, 0, which no arm reaches.
    let without = description(|text| {
        let component = text.find("<ssd:Component name=\"kinematics\"").unwrap();
        let end = component + text[component..].find("</ssd:Component>\n").unwrap() + "</ssd:Component>\n".len();
        let text = format!("{}{}", &text[..component], &text[end..]);
        let lines = text.lines().filter(|line| !line.contains("kinematics") && !line.contains("name=\"q"));
        let mut kept: String = lines.map(|line| format!("{line}\n")).collect();
        for name in TOOL {
            kept = kept.replacen(
                "</ssd:Connectors>",
                &format!("<ssd:Connector name=\"{name}\" kind=\"output\"><ssc:Real/></ssd:Connector></ssd:Connectors>"),
                1,
            );
            kept = kept.replacen(
                "</ssd:Connections>",
                &format!(
                    "<ssd:Connection startElement=\"controller\" startConnector=\"{name}\" endConnector=\"{name}\"/>\n\
                     </ssd:Connections>"
                ),
                1,
            );
        }
        kept
    });
    system(&folder, &without, "", &[]);
    // A robot that is a point, and FMPy's step of delay.
    let text = "schema = 1\nname = \"fmpy\"\nfmu = \"mat.ssp\"\n[time]\nstep_s = 0.01\n[[robot]]\nname = \"r\"\n\
                moving_mass_kg = 30\npayload_kg = 0\nphase = \"leg\"\n[[robot.frame]]\nname = \"tcp\"\nposition = \
                [\"tcp.position.x\", \"tcp.position.y\", \"tcp.position.z\"]\nvelocity = [\"tcp.velocity.x\", \
                \"tcp.velocity.y\", \"tcp.velocity.z\"]\n[[robot.link]]\nname = \"tool\"\nframe = \"tcp\"\ncapsule = { \
                from_m = [0, 0, 0], to_m = [0, 0, 0], radius_m = 0.08 }\n[[sensor]]\nname = \"mat\"\nkind = \
                \"mat\"\nvariable = \"mat_clear\"\nactive = false\nzone = { polygon_m = [[1, 1], [2, 1], [2, 2]] \
                }\n[inputs]\nreset = false\n[human]\nstart = { xy_m = [0, -2], heading_deg = 90 }\n[[connection]]\nfrom = \
                \"plc:stop\"\nto = \"controller:stop\"\ndelay_steps = 1\n";
    write(&folder, "fmpy.toml", text);
    let output = Command::new(python())
        .arg(Path::new(env!("CARGO_MANIFEST_DIR")).join("tools/simulate_ssp.py"))
        .args([folder.join("mat.ssp").to_str().unwrap(), "--step", "0.01", "--stop", "1.5"])
        .args([
            "--input",
            "mat_clear:0=1",
            "--input",
            "reset:0=0",
            "--input",
            "reset:0.2=1",
            "--input",
            "mat_clear:0.8=0",
        ])
        .output()
        .unwrap();
    assert!(output.status.success(), "{}", String::from_utf8_lossy(&output.stderr));
    let theirs: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let prepared = fmi_hazard::scan::prepare::prepare(&folder.join("fmpy.toml"), None).unwrap();
    let binding = &prepared.binding;
    let steps = theirs["time"].as_array().unwrap().len();
    let column = |name: &str| binding.inputs.iter().position(|input| input.port.name == name).unwrap();
    let mut rows = vec![0.0; steps * binding.inputs.len()];
    // What FMPy is given for one step counts from the next one on; nothing but 0 in the first.
    for (step, row) in rows.chunks_mut(binding.inputs.len()).enumerate().skip(1) {
        let given = step - 1;
        row[column("mat_clear")] = f64::from(u8::from(given < 80));
        row[column("reset")] = f64::from(u8::from(given >= 20));
    }
    let mut plant = prepared.plant_from(fmi_hazard::scan::StateChoice::Replay, &vec![0.0; binding.inputs.len()]);
    plant.restart().unwrap();
    let ours = plant.advance(steps, &rows).unwrap();
    let (mut compared, mut moved): (u32, f64) = (0, 0.0);
    for (place, output) in binding.outputs.iter().enumerate() {
        let name = &output.port.name;
        let their = |step: usize| theirs[name.as_str()][step].as_f64().unwrap_or_else(|| panic!("{name}: {theirs}"));
        let our = |step: usize| ours[step * binding.outputs.len() + place];
        // The system's outputs are handed on a step later too; and the first steps begin at other inputs.
        for step in 5..steps {
            compared += 1;
            moved = moved.max((our(step) - our(5)).abs());
            let apart = (our(step) - their(step)).abs();
            assert!(apart < 1e-9, "{name}, step {step}: {} here, {} in FMPy", our(step), their(step));
        }
    }
    assert!(compared > 900 && moved > 0.1, "{compared} values, {moved}");
}

#[test]
fn units_transformations_and_parameters() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    let values = "<ssv:ParameterSet version=\"1.0\" name=\"p\" \
                  xmlns:ssv=\"http://ssp-standard.org/SSP1/SystemStructureParameterValues\"><ssv:Parameters>\
                  <ssv:Parameter name=\"PARAMETER\"><ssv:Real value=\"0.5\"/></ssv:Parameter></ssv:Parameters>\
                  </ssv:ParameterSet>";
    let fmu = fmi_hazard::fmi::Fmu::open(&folder.join("sensor-mat-controller.fmu")).unwrap();
    let parameters: Vec<&str> = fmu
        .description()
        .variables
        .iter()
        .filter(|v| v.causality == fmi_hazard::fmi::Causality::Parameter && v.numeric_start().len() == 1)
        .filter(|v| matches!(v.kind, fmi_hazard::fmi::VariableType::Real { .. }))
        .map(|v| v.name.as_str())
        .collect();
    let [first @ "t_ramp", second, ..] = parameters[..] else { panic!("{parameters:?}") };
    let changed = description(|text| {
        let units = "<ssd:Units><ssc:Unit name=\"u\"><ssc:BaseUnit m=\"1\" factor=\"0.001\" offset=\"2\"/></ssc:Unit>\
                     <ssc:Unit name=\"w\"><ssc:BaseUnit m=\"1\" factor=\"0.01\"/></ssc:Unit></ssd:Units>";
        let real = |name: &str, unit: &str, text: String| {
            let old = format!(
                "<ssd:Connector name=\"{name}\" kind=\"{}\"><ssc:Real/>",
                if unit == "u" { "output" } else { "input" }
            );
            text.replacen(&old, &old.replace("<ssc:Real/>", &format!("<ssc:Real unit=\"{unit}\"/>")), 1)
        };
        let text = real("tcp.position.x", "u", real("tcp.position.x", "w", text));
        // Millimetres that the description says nothing about; the FMU's own unit is the metre.
        let old = "<ssd:Connector name=\"tcp.position.y\" kind=\"output\"><ssc:Real/>";
        let text = text.replacen(old, &old.replace("<ssc:Real/>", "<ssc:Real unit=\"mm\"/>"), 1);
        let scaled = "startConnector=\"tcp.position.y\" endElement=\"kinematics\" endConnector=\"tcp.position.y\"";
        text.replacen("</ssd:System>\n", &format!("</ssd:System>\n{units}\n"), 1)
            .replacen(&format!("{scaled}/>"), &format!("{scaled}><ssc:LinearTransformation factor=\"-2\" offset=\"0.25\"/></ssd:Connection>"), 1)
            .replacen(
                "implementation=\"CoSimulation\">\n<ssd:Connectors>\n<ssd:Connector name=\"stop\" kind=\"input\">",
                &format!(
                    "implementation=\"CoSimulation\">\n<ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues>{}\
                     </ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>\n<ssd:Connectors>\n<ssd:Connector \
                     name=\"stop\" kind=\"input\">",
                    values.replace("PARAMETER", first).replace("value=\"0.5\"", "value=\"500\" unit=\"ms\"")
                ),
                1,
            )
            .replacen(
                "<ssd:System name=\"cell\">\n",
                "<ssd:System name=\"cell\">\n<ssd:ParameterBindings><ssd:ParameterBinding source=\"resources/p.ssv\" \
                 prefix=\"controller.\"/></ssd:ParameterBindings>\n",
                1,
            )
    });
    system(&folder, &changed, "", &[("resources/p.ssv", &values.replace("PARAMETER", second))]);
    write(&folder, "cell.toml", &cell(&folder, true));
    let opened = fmi_hazard::cell::find::open(&folder.join("cell.toml"), None).unwrap();
    let units = fmi_hazard::cell::binding::BoundUnit::all(opened.fmus.iter().map(|(name, fmu)| (name, fmu)));
    let binding =
        fmi_hazard::cell::binding::bind(opened.cell.file(), &opened.source, &units, opened.wiring.as_ref()).unwrap();
    let of =
        |name: &str| binding.connections.iter().find(|c| c.to.port.name == name).map(|c| (c.factor, c.offset)).unwrap();
    // By hand: 0.001 u + 2 = 0.01 w, so w = 0.1 u + 200.
    let (factor, offset) = of("tcp.position.x");
    assert!((factor - 0.1).abs() < 1e-12 && (offset - 200.0).abs() < 1e-9, "{factor} {offset}");
    let (factor, offset) = of("tcp.position.y");
    assert!((factor + 0.002).abs() < 1e-15 && (offset - 0.25).abs() < 1e-15, "{factor} {offset}");
    assert_eq!(of("tcp.position.z"), (1.0, 0.0));
    let set: Vec<(&str, f64)> =
        binding.parameters.iter().map(|(port, value)| (port.port.name.as_str(), *value)).collect();
    assert_eq!(set, [(first, 0.5), (second, 0.5)]);
}

#[test]
fn what_is_not_supported_is_refused_by_element_and_line() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    let stop = "<ssd:Connection startElement=\"plc\" startConnector=\"stop\" endElement=\"controller\" endConnector=\"stop\"/>";
    let refusals: &[(&str, &str, &str)] = &[
        (
            "<ssd:Elements>\n",
            "<ssd:Elements>\n<ssd:System name=\"inner\"/>\n",
            "<System> inside a system is not supported",
        ),
        (
            "<ssd:Elements>\n",
            "<ssd:Elements>\n<ssd:SignalDictionary name=\"d\"/>\n",
            "<SignalDictionary> inside a system",
        ),
        ("implementation=\"CoSimulation\"", "implementation=\"ModelExchange\"", "`plc` is for model exchange"),
        (
            "application/x-fmu-sharedlibrary",
            "application/x-ssp-definition",
            "is of type `application/x-ssp-definition`",
        ),
        ("resources/sensor-mat-plc.fmu", "resources/none.fmu", "resources/none.fmu of component `plc` is not there"),
        ("resources/sensor-mat-plc.fmu", "../../none.fmu", "`plc` is outside the system"),
        ("Description version=\"1.0\"", "Description version=\"9.0\"", "SSP 9.0 is not known"),
        ("startElement=\"plc\"", "startElement=\"plcc\"", "there is no component `plcc`"),
        (
            "startElement=\"plc\" startConnector=\"stop\"",
            "startElement=\"plc\" startConnector=\"halt\"",
            "no variable `plc.halt`",
        ),
        (
            "endElement=\"controller\" endConnector=\"stop\"",
            "endElement=\"controller\" endConnector=\"leg\"",
            "`controller.leg` is not an input",
        ),
        (stop, &format!("{stop}\n{stop}"), "`controller.stop` is driven by two things at once"),
        (
            "<ssd:Connector name=\"q[1]\" kind=\"output\"><ssc:Real/>",
            "<ssd:Connector name=\"q[1]\" kind=\"output\"><ssc:Real/><ssc:Dimension size=\"2\"/>",
            "`q[1]` is an array",
        ),
        (
            "<ssd:Connector name=\"reset\" kind=\"input\"><ssc:Boolean/>",
            "<ssd:Connector name=\"reset\" kind=\"input\"><ssc:Binary/>",
            "is of type Binary",
        ),
        (
            "endConnector=\"stop\"/>",
            "endConnector=\"stop\"><ssc:BooleanMappingTransformation/></ssd:Connection>",
            "<BooleanMappingTransformation> is not supported",
        ),
        (
            "endElement=\"plc\" endConnector=\"mat_clear\"/>",
            "endElement=\"plc\" endConnector=\"mat_clear\"><ssc:LinearTransformation factor=\"2\"/></ssd:Connection>",
            "connector of the system itself is transformed",
        ),
        ("</ssd:System>", "</ssd:Systems>", "it is no XML"),
        ("startConnector=\"tcp.position.x\"", "startConnector=\"leg\"", "Integer is connected with Real"),
        (
            "<ssd:System name=\"cell\">",
            "<ssd:System name=\"cell\"><ssd:ParameterBindings><ssd:ParameterBinding source=\"no.ssv\"/></ssd:ParameterBindings>",
            "the parameter set no.ssv cannot be read",
        ),
    ];
    write(&folder, "system.toml", &cell(&folder, false));
    for (from, to, words) in refusals {
        let changed = description(|text| {
            assert!(text.contains(from), "{from}");
            text.replacen(from, to, 1)
        });
        system(&folder, &changed, "", &[]);
        let output = fmi_hazard(&folder).args(["check", "system.toml", "--no-run"]).output().unwrap();
        assert_eq!(output.status.code(), Some(2), "{from} -> {to}");
        let said = String::from_utf8_lossy(&output.stderr).replace(['│', '\n'], " ");
        let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(said.contains(words) && said.contains("help:"), "`{words}`: {said}");
        assert!(said.contains("SystemStructure.ssd:"), "no line: {said}");
    }
}

#[test]
fn inspect_tells_what_a_system_is() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    system(&folder, &description(|text| text), "", &[]);
    let output = fmi_hazard(&folder).args(["inspect", "mat.ssp"]).assert().code(0).get_output().clone();
    let text = String::from_utf8(output.stdout).unwrap();
    for words in [
        "3 components",
        "mat_clear -> plc:mat_clear",
        "plc:stop -> controller:stop",
        "component kinematics",
        "q[1] = kinematics:q[1]",
    ] {
        assert!(text.contains(words), "`{words}`: {text}");
    }
    let output =
        fmi_hazard(&folder).args(["inspect", "mat.ssp", "--format", "json"]).assert().code(0).get_output().clone();
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(json["components"].as_array().unwrap().len(), 3);
    assert_eq!(json["ssp_version"], "1.0");
}

#[test]
fn a_system_is_probed_and_tested_as_an_fmu_is() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    system(&folder, &description(|text| text), "", &[]);
    let said = |arguments: &[&str]| {
        let output = fmi_hazard(&folder).args(arguments).output().unwrap();
        (
            output.status.code().unwrap(),
            String::from_utf8(output.stdout).unwrap()
                + &crate::common::archives::flat(&String::from_utf8_lossy(&output.stderr)),
        )
    };
    let (code, text) = said(&["inspect", "--self-test", "mat.ssp"]);
    assert!(code == 0 && text.contains("cell: 80 steps of 0.02 s with 2 moving inputs"), "{text}");
    let arguments = ["inspect", "--self-test", "mat.ssp", "--format", "json", "--in-process"];
    let output = fmi_hazard(&folder).args(arguments).assert().code(0).get_output().clone();
    let json: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    assert_eq!(json["deterministic"]["result"], "exact", "{json}");
    let (code, text) = said(&["inspect", "--run", "mat.ssp"]);
    assert!(code == 0 && text.contains("moves     5.236 in the unit of its joint speeds"), "{text}");
    assert!(
        text.contains("input     mat_clear = false: stops it") && text.contains("input     reset = true"),
        "{text}"
    );
    // What is wrong in the system is told with its line.
    system(&folder, &description(|text| text.replace("startConnector=\"stop\"", "startConnector=\"stopp\"")), "", &[]);
    for option in ["--self-test", "--run"] {
        let (code, text) = said(&["inspect", option, "mat.ssp"]);
        assert!(code == 2 && text.contains("there is no variable `plc.stopp`"), "{text}");
    }
}

#[test]
fn a_first_cell_file_of_a_system_names_its_variables_as_the_cell_does() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    system(&folder, &description(|text| text), "", &[]);
    fmi_hazard(&folder).args(["init", "mat.ssp", "--out", "first.toml"]).assert().code(0);
    let text = std::fs::read_to_string(folder.join("first.toml")).unwrap();
    let table: toml::Table = text.parse().unwrap();
    assert_eq!(table["fmu"].as_str(), Some("mat.ssp"));
    let joints = table["robot"][0]["joint"].as_array().unwrap();
    let named = |key: &str| joints.iter().map(|j| j[key]["variable"].as_str().unwrap()).collect::<Vec<_>>();
    let expected = |name: &str| (1..=6).map(|n| format!("kinematics:{name}[{n}]")).collect::<Vec<_>>();
    assert_eq!(named("angle"), expected("q"));
    assert_eq!(named("speed"), expected("qd"));
    // What the system calls by a name of its own, and nothing that is connected inside.
    let sensor = &table["sensor"][0];
    assert_eq!((sensor["variable"].as_str(), sensor["active"].as_bool()), (Some("mat_clear"), Some(false)));
    assert_eq!(table["inputs"]["reset"].as_bool(), Some(false));
    assert!(!text.contains("controller:stop"), "{text}");
    // What is missing, and nothing else, is wrong with it.
    let output = fmi_hazard(&folder).args(["check", "first.toml", "--no-run", "--format", "json"]).output().unwrap();
    let told: serde_json::Value = serde_json::from_slice(&output.stdout).unwrap();
    let problems = told["problems"].as_array().unwrap();
    let known = ["still to be filled in", "no moving mass", "has no zone", "no robot geometry", "has no axis"];
    for problem in problems {
        let message = problem["message"].as_str().unwrap();
        assert!(known.iter().any(|words| message.contains(words)), "{message}");
    }
}

#[test]
fn an_input_of_the_system_may_drive_several_variables_and_each_is_driven_once() {
    let dir = examples();
    let folder = dir.path().join("sensor-mat");
    let own = "<ssd:Connection startConnector=\"reset\" endElement=\"plc\" endConnector=\"reset\"/>\n";
    let also = "<ssd:Connection startConnector=\"mat_clear\" endElement=\"plc\" endConnector=\"reset\"/>\n";
    let text = cell(&folder, true);
    // The mat's signal at the reset button too, which then is no input of its own.
    system(&folder, &description(|text| text.replacen(own, also, 1)), "", &[]);
    let mut table: toml::Table = text.parse().unwrap();
    table.remove("inputs");
    let without = toml::to_string(&table).unwrap();
    write(&folder, "both.toml", &without);
    let opened = fmi_hazard::cell::find::open(&folder.join("both.toml"), None).unwrap();
    let units = fmi_hazard::cell::binding::BoundUnit::all(opened.fmus.iter().map(|(name, fmu)| (name, fmu)));
    let binding =
        fmi_hazard::cell::binding::bind(opened.cell.file(), &opened.source, &units, opened.wiring.as_ref()).unwrap();
    assert_eq!(binding.inputs.len(), 1);
    let [(0, mirror)] = &binding.mirrors[..] else { panic!("{:?}", binding.mirrors) };
    assert_eq!(mirror.port.name, "reset");
    let setup = binding.setup(&["plc", "controller", "kinematics"], vec![1.0], 0.01);
    let plc = setup.unit(0);
    let names: Vec<&str> = plc.inputs.iter().map(|port| port.name.as_str()).collect();
    assert_eq!((names, plc.initial_inputs), (vec!["mat_clear", "reset"], vec![1.0, 1.0]));
    // Held constant as well, or connected as a whole: refused.
    let refused = |text: &str, words: &str| {
        write(&folder, "refused.toml", text);
        let output = fmi_hazard(&folder).args(["check", "refused.toml", "--no-run"]).output().unwrap();
        let said = String::from_utf8_lossy(&output.stderr).replace(['│', '\n'], " ");
        let said = said.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(output.status.code() == Some(2) && said.contains(words), "`{words}`: {said}");
    };
    let held = format!("{without}\n[inputs]\n\"plc:reset\" = false\n");
    refused(&held, "`plc:reset` is driven by two things at once");
    refused(
        &format!("{without}\n[[connection]]\nfrom = \"plc:stop\"\nto = \"mat_clear\"\n"),
        "`mat_clear` of the system drives several variables",
    );
}
