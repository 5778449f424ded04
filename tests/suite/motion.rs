//! Motion that is not the FMU's: what it says of events and of the end of a step is followed or told, and the self-test sees what it
//! does not say, by half steps and by Event Mode.

use std::path::Path;

use crate::common::archives::{XML, entries_of, pack};
use crate::common::{faulty_cell, fmi_hazard, test_fmus, write};
use fmi_hazard::fmi::{EventMode, Fmu, Instance, Stepping};
use fmi_hazard::host::selftest::{Motion, Untried};
use fmi_hazard::scan::Prepared;
use fmi_hazard::scan::prepare::prepare;

/// What of a test FMU's description is replaced by what.
type Changes<'a> = &'a [(&'a str, &'a str)];

/// A test FMU, with changes to its description, with a fault in the sixth step, in its cell.
fn folder(fmu: &str, kind: i32, changes: Changes) -> tempfile::TempDir {
    let mut all = entries_of(fmu);
    let (_, xml) = all.iter_mut().find(|(name, _)| name == XML).unwrap();
    let mut text = String::from_utf8(xml.clone()).unwrap();
    for (from, to) in changes {
        assert!(text.contains(from), "{from}: {text}");
        text = text.replace(from, to);
    }
    *xml = text.into_bytes();
    let dir = tempfile::TempDir::new().unwrap();
    std::fs::write(dir.path().join("x.fmu"), pack(&all)).unwrap();
    write(dir.path(), "cell.toml", &faulty_cell("x.fmu", kind, 5));
    dir
}

fn prepared(fmu: &str, kind: i32, changes: Changes) -> Prepared {
    prepare(&folder(fmu, kind, changes).path().join("cell.toml"), None).unwrap()
}

/// How they came out in a word, which is all that the table below asks.
fn word(motion: &Motion) -> &'static str {
    match motion {
        Motion::Same { most, .. } if most.share == 0.0 => "same to the last bit",
        Motion::Same { .. } => "same",
        Motion::Differs { .. } => "differs",
        Motion::Failed { .. } => "failed",
        Motion::NotTried { why: Untried::NoEventMode } => "no event mode",
        Motion::NotTried { .. } => "not tried",
    }
}

/// Flawed (19 to 21) and repaired (0 and 18, which has the event of 19 and 20), of FMI 2 and FMI 3. That of 20 is dropped by whole and
/// half steps alike, so only Event Mode shows it; that of 19 is dropped with and without, so only half steps do.
#[test]
fn half_steps_and_event_mode_show_a_motion_that_is_not_the_fmus() {
    for (fmu, kind, halves, modes) in [
        ("faulty.fmu", 0, "same to the last bit", "no event mode"),
        ("faulty.fmu", 18, "same to the last bit", "no event mode"),
        ("faulty.fmu", 19, "differs", "no event mode"),
        ("faulty.fmu", 21, "differs", "no event mode"),
        ("faulty-fmi3.fmu", 0, "same to the last bit", "same to the last bit"),
        ("faulty-fmi3.fmu", 18, "same to the last bit", "same to the last bit"),
        ("faulty-fmi3.fmu", 19, "differs", "same to the last bit"),
        ("faulty-fmi3.fmu", 20, "same to the last bit", "differs"),
        ("faulty-fmi3.fmu", 21, "differs", "same to the last bit"),
        ("faulty-nostate.fmu", 19, "differs", "no event mode"),
    ] {
        let prepared = prepared(fmu, kind, &[]);
        let test = &prepared.self_test;
        assert_eq!((word(&test.half_steps), word(&test.event_mode)), (halves, modes), "{fmu} with fault {kind}");
        let reasons = prepared.self_test.against_motion();
        let differ = [halves, modes].into_iter().filter(|word| *word == "differs").count();
        assert_eq!(reasons.len(), differ, "{reasons:?}");
        assert!(
            reasons.iter().all(|reason| reason.contains("output `q`") || reason.contains("output `qd`")),
            "{reasons:?}"
        );
        let shown = test.motion_shown();
        assert_eq!(
            shown.len(),
            [halves, modes].into_iter().filter(|word| word.starts_with("same")).count(),
            "{shown:?}"
        );
        let json = serde_json::to_value(test).unwrap();
        assert_eq!(json["half_steps"]["result"], if halves == "differs" { "differs" } else { "same" });
    }
}

#[test]
fn what_cannot_be_compared_is_told_with_the_reason() {
    let variable = "canHandleVariableCommunicationStepSize=\"true\"";
    let fixed = "canHandleVariableCommunicationStepSize=\"false\"";
    let own = |step: &str| format!("{fixed} fixedInternalStepSize=\"{step}\"");
    let own_steps = |step_s: f64| Motion::NotTried { why: Untried::OwnSteps { step_s } };
    // The default experiment names 0.02 s, as the cell does.
    assert_eq!(prepared("faulty.fmu", 19, &[(variable, fixed)]).self_test.half_steps, own_steps(0.02));
    assert_eq!(prepared("faulty-fmi3.fmu", 19, &[(variable, &own("0.004"))]).self_test.half_steps, own_steps(0.004));
    assert_eq!(word(&prepared("faulty-fmi3.fmu", 19, &[(variable, &own("0.005"))]).self_test.half_steps), "differs");
    // Nobody certifies anything for it, and nothing is said to be wrong.
    let fixed = prepared("faulty.fmu", 19, &[(variable, fixed)]);
    assert_eq!((fixed.self_test.against_motion().len(), fixed.self_test.motion_shown().len()), (0, 0));
    let dir = tempfile::TempDir::new().unwrap();
    fmi_hazard::examples::by_name("sensor-mat").unwrap().export(dir.path()).unwrap();
    let coupled = prepare(&dir.path().join("sensor-mat/coupled.toml"), None).unwrap();
    assert_eq!(coupled.self_test.half_steps, Motion::NotTried { why: Untried::Coupled });
}

/// The faulty FMU of FMI 3.0 with an event that it announces, ten milliseconds after 0.1 s, used with Event Mode or without.
struct Announced {
    fmu: Fmu,
    instance: Instance<Stepping>,
}

impl Announced {
    fn new(mode: EventMode) -> Self {
        let fmu = Fmu::open(&test_fmus().join("faulty-fmi3.fmu")).unwrap();
        let reference = |name: &str| fmu.description().variable(name).unwrap().value_reference;
        let mut instance = fmu.load().unwrap().instantiate_with("test", mode).unwrap();
        instance.set_integer(&[reference("fault.kind"), reference("fault.step")], &[18, 5]).unwrap();
        let instance = instance.enter_initialization(0.0, None).unwrap().exit_initialization().unwrap();
        Self { fmu, instance }
    }

    /// The angles after these steps.
    fn steps(&mut self, steps: std::ops::Range<i32>) -> Vec<f64> {
        let q = self.fmu.description().variable("q").unwrap().value_reference;
        let after = |step: i32| {
            self.instance.do_step(f64::from(step) * 0.02, 0.02).unwrap();
            let mut value = [0.0];
            self.instance.get_real(&[q], &mut value).unwrap();
            value[0]
        };
        steps.map(after).collect()
    }
}

/// Steps end where an FMU in Event Mode announces its next event; saved states keep it, their bytes too.
#[test]
fn an_announced_event_is_gone_through_where_it_is_announced_for() {
    let alone = Announced::new(EventMode::Unused).steps(0..30);
    let mut with = Announced::new(EventMode::Used);
    assert_eq!(with.steps(0..30), alone);
    let mut with = Announced::new(EventMode::Used);
    with.steps(0..3);
    let saved = with.instance.save().unwrap();
    assert_eq!(with.steps(3..30), alone[3..]);
    with.instance.restore(&saved).unwrap();
    assert_eq!(with.steps(3..30), alone[3..], "after coming back");
    let bytes = with.instance.serialize(&saved).unwrap();
    let mut other = Announced::new(EventMode::Used);
    other.steps(0..9);
    let read = other.instance.deserialize(&bytes).unwrap();
    other.instance.restore(&read).unwrap();
    assert_eq!(other.steps(3..30), alone[3..], "from bytes");
}

/// Without Event Mode, and an event at the end of a step: stepped on, and told.
#[test]
fn an_event_of_an_fmu_without_event_mode_is_told() {
    let none = [("hasEventMode=\"true\"", "hasEventMode=\"false\"")];
    let told = prepared("faulty-fmi3.fmu", 17, &none).warnings().join("\n");
    assert!(
        told.contains("the FMU says at t = 0.120 s, at the end of a step, that an event is to be handled"),
        "{told}"
    );
    let honest = prepared("faulty-fmi3.fmu", 0, &none).warnings().join("\n");
    assert!(!honest.contains("event"), "{honest}");
    // Where it has one, it is used, and that it fails without is told.
    let used = prepared("faulty-fmi3.fmu", 17, &[]).self_test;
    assert!(used.uses_event_mode && word(&used.event_mode) == "failed" && used.remarks.is_empty(), "{used:?}");
}

/// FMI 2 says with Discard that it ends the simulation, or that it refuses a step.
#[test]
fn the_end_of_the_simulation_and_a_refused_step_are_told_apart() {
    let failed = |fmu: &str, kind: i32| match prepare(&folder(fmu, kind, &[]).path().join("cell.toml"), None) {
        Err(error) => error.to_string(),
        Ok(_) => panic!("{fmu}"),
    };
    for fmu in ["faulty.fmu", "faulty-fmi3.fmu"] {
        let (ended, refused) = (failed(fmu, 11), failed(fmu, 3));
        assert!(ended.contains("the FMU asked to end the simulation at t = 0.12"), "{ended}");
        assert!(refused.contains("Discard") && !refused.contains("asked to end"), "{refused}");
    }
}

/// A system of that FMU alone, with a parameter: the command takes none.
fn with_parameter(name: &str, value: &str) -> String {
    let connector = |name: &str, kind: &str, of: &str| {
        format!("<ssd:Connector name=\"{name}\" kind=\"{kind}\"><ssc:{of}/></ssd:Connector>")
    };
    let connectors =
        [connector("stop", "input", "Boolean"), connector("q", "output", "Real"), connector("qd", "output", "Real")]
            .concat();
    let outputs = ["q", "qd"]
        .map(|name| format!("<ssd:Connection startElement=\"x\" startConnector=\"{name}\" endConnector=\"{name}\"/>"));
    format!(
        "<ssd:SystemStructureDescription version=\"1.0\" name=\"x\" \
         xmlns:ssd=\"http://ssp-standard.org/SSP1/SystemStructureDescription\" \
         xmlns:ssc=\"http://ssp-standard.org/SSP1/SystemStructureCommon\" \
         xmlns:ssv=\"http://ssp-standard.org/SSP1/SystemStructureParameterValues\">\n<ssd:System name=\"x\">\n<ssd:Connectors>\
         {connectors}</ssd:Connectors>\n<ssd:Elements>\n<ssd:Component name=\"x\" type=\"application/x-fmu-sharedlibrary\" \
         source=\"x.fmu\" implementation=\"CoSimulation\">\n<ssd:Connectors>{connectors}</ssd:Connectors>\n\
         <ssd:ParameterBindings><ssd:ParameterBinding><ssd:ParameterValues><ssv:ParameterSet version=\"1.0\" name=\"p\">\
         <ssv:Parameters><ssv:Parameter name=\"{name}\"><ssv:Integer value=\"{value}\"/></ssv:Parameter></ssv:Parameters>\
         </ssv:ParameterSet></ssd:ParameterValues></ssd:ParameterBinding></ssd:ParameterBindings>\n</ssd:Component>\n\
         </ssd:Elements>\n<ssd:Connections>\n<ssd:Connection startConnector=\"stop\" endElement=\"x\" \
         endConnector=\"stop\"/>\n{}</ssd:Connections>\n</ssd:System>\n</ssd:SystemStructureDescription>\n",
        outputs.concat()
    )
}

#[test]
fn the_command_prints_a_line_for_each() {
    let printed = |fmu: &str, kind: &str| {
        let dir = folder(fmu, 0, &[]);
        write(dir.path(), "x.ssd", &with_parameter("fault.kind", kind));
        let output =
            fmi_hazard(dir.path()).args(["inspect", "--self-test", "x.ssd"]).assert().success().get_output().clone();
        String::from_utf8(output.stdout).unwrap()
    };
    let line = |text: &str, begin: &str| -> String {
        let words: Vec<&str> = text.lines().find(|line| line.contains(begin)).unwrap().split_whitespace().collect();
        words.join(" ")
    };
    let honest = printed("faulty-fmi3.fmu", "18");
    assert_eq!(line(&honest, "half steps"), "the same motion in half steps same, most apart `q` by 0.00 %");
    assert_eq!(line(&honest, "Event Mode"), "with its Event Mode same, most apart `q` by 0.00 %");
    let flawed = printed("faulty-fmi3.fmu", "20");
    assert!(line(&flawed, "Event Mode").contains("with its Event Mode WRONG, `q"), "{flawed}");
    let second = printed("faulty.fmu", "21");
    assert!(line(&second, "half steps").contains("in half steps WRONG, `q"), "{second}");
    assert!(line(&second, "Event Mode").contains("not tried: the FMU has no Event Mode"), "{second}");
}

/// A scan of every sequence of a flawed FMU says so among its reasons; that of the repaired one does not.
#[test]
fn a_scan_says_that_half_steps_differ() {
    let told = |kind: i32| {
        let dir = folder("faulty.fmu", kind, &[]);
        scan(dir.path())
    };
    let words = "in steps of 0.01 s instead of 0.02 s the FMU moves otherwise";
    let (flawed, repaired) = (told(19), told(18));
    assert!(flawed.to_string().contains(words) && flawed["verdict"] == "inconclusive", "{}", flawed["verdict"]);
    assert!(!repaired.to_string().contains(words));
    assert_eq!(flawed["self_test"]["half_steps"]["result"], "differs");
}

fn scan(dir: &Path) -> serde_json::Value {
    let arguments =
        ["scan", "--no-advice", "cell.toml", "--from", "start", "--strategy", "random", "--iterations", "2"];
    let _ = fmi_hazard(dir).args(arguments).args(["--out", "o"]).output().unwrap();
    crate::common::scan_json(&dir.join("o"))
}

/// The example FMUs compute in milliseconds, whatever the step: all move alike to the last bit, of FMI 2 and FMI 3.
#[test]
fn every_example_moves_alike_in_half_steps() {
    let scenarios = std::fs::read_dir(Path::new(env!("CARGO_MANIFEST_DIR")).join("scenarios")).unwrap();
    let names = scenarios.map(|entry| entry.unwrap().file_name().into_string().unwrap());
    let mut fmus: Vec<_> = names.flat_map(|name| [format!("{name}.fmu"), format!("{name}-fmi3.fmu")]).collect();
    fmus.retain(|name| test_fmus().join(name).is_file());
    assert!(fmus.len() >= 30, "{fmus:?}");
    for name in fmus {
        let prepared = prepare(&test_fmus().join(&name), None).unwrap();
        let test = &prepared.self_test;
        assert_eq!(word(&test.half_steps), "same to the last bit", "{name}: {}", test.half_steps);
        assert_eq!(
            (word(&test.event_mode), prepared.self_test.against_motion()),
            ("no event mode", Vec::new()),
            "{name}"
        );
    }
}
