//! modelDescription.xml as exporters write it, and as they should not.

use super::*;

const HEAD: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" fmiVersion="2.0" modelName="Cell"
  guid="{1}" generationTool="Test" numberOfEventIndicators="0">
  <CoSimulation modelIdentifier="Cell" canGetAndSetFMUstate="true"/>"#;

fn with_variables(variables: &str) -> String {
    format!(
        "{HEAD}\n<TypeDefinitions><SimpleType name=\"Angle\"><Real unit=\"rad\" min=\"-3\" max=\"3\"/></SimpleType></TypeDefinitions><ModelVariables>\n{variables}\n</ModelVariables></fmiModelDescription>"
    )
}

fn problem(text: &str) -> (usize, String) {
    let p = read(text).unwrap_err();
    (line_and_column(text, p.offset).0, p.message)
}

#[test]
fn a_plain_description_is_read_whole() {
    let text = with_variables(
        r#"<ScalarVariable name="q" valueReference="3" causality="output" description="a &lt; b"><Real declaredType="Angle" max="2"/></ScalarVariable>
<ScalarVariable name="stop" valueReference="4" causality="input" variability="discrete"><Boolean start="1"/></ScalarVariable>
<ScalarVariable name="n" valueReference="5" causality="parameter" variability="fixed"><Integer start="-7"/></ScalarVariable>"#,
    );
    let (d, warnings) = read(&text).unwrap();
    assert_eq!(warnings, []);
    assert_eq!((d.model_name.as_str(), d.guid.as_str()), ("Cell", "{1}"));
    let capabilities = &d.co_simulation.as_ref().unwrap().capabilities;
    assert!(capabilities.can_get_and_set_state && !capabilities.can_serialize_state);
    let q = d.variable("q").unwrap();
    assert_eq!(q.kind, VariableType::Real { unit: Some("rad".into()), start: None, min: Some(-3.0), max: Some(2.0) });
    assert_eq!((q.value_reference, q.causality, q.description.as_str()), (3, Causality::Output, "a < b"));
    assert_eq!(d.variable("stop").unwrap().kind, VariableType::Boolean { start: Some(true) });
    assert_eq!(d.variable("n").unwrap().kind, VariableType::Integer { start: Some(-7) });
    assert_eq!(d.variable("n").unwrap().line, 8);
}

#[test]
fn what_is_unknown_is_a_warning_with_its_line() {
    let text = with_variables(r#"<ScalarVariable name="q" valueReference="3" colour="red"><Real/></ScalarVariable>"#);
    let (_, warnings) = read(&text).unwrap();
    assert_eq!(warnings.len(), 1);
    assert_eq!(warnings[0].to_string(), "line 6: unknown attribute `colour` in <ScalarVariable>");
}

#[test]
fn what_would_give_wrong_results_is_an_error_with_its_line() {
    for (variables, line, words) in [
        (r#"<ScalarVariable name="q"><Real/></ScalarVariable>"#, 6, "no valueReference"),
        (r#"<ScalarVariable name="q" valueReference="x"><Real/></ScalarVariable>"#, 6, "\"x\""),
        ("\n<ScalarVariable name=\"q\" valueReference=\"1\"><Real start=\"fast\"/></ScalarVariable>", 7, "\"fast\""),
        (r#"<ScalarVariable name="q" valueReference="1" causality="exit"><Real/></ScalarVariable>"#, 6, "\"exit\""),
        (
            "<ScalarVariable name=\"q\" valueReference=\"1\"><Real/></ScalarVariable>\n<ScalarVariable name=\"q\" valueReference=\"2\"><Real/></ScalarVariable>",
            7,
            "two variables are called `q` (the other is in line 6)",
        ),
    ] {
        let (at, message) = problem(&with_variables(variables));
        assert!(message.contains(words), "{message}");
        assert_eq!(at, line, "{message}");
    }
}

#[test]
fn hostile_xml_is_refused() {
    let bomb = r#"<?xml version="1.0"?><!DOCTYPE x [<!ENTITY a "aaaa">]><fmiModelDescription fmiVersion="2.0"/>"#;
    assert!(problem(bomb).1.contains("DOCTYPE"));
    for identifier in ["../../bin/sh", "a b", "a;rm", "1st", "", "caf\u{e9}"] {
        let text = HEAD.replace("modelIdentifier=\"Cell\"", &format!("modelIdentifier=\"{identifier}\""));
        assert!(problem(&format!("{text}</fmiModelDescription>")).1.contains("C identifier"), "{identifier}");
    }
    assert!(problem(HEAD).1.contains("ends inside"));
    assert!(problem("<a></b>").1.contains("root element"));
    assert!(problem("").1.contains("no <fmiModelDescription>"));
    assert!(problem(&format!("{HEAD}<x></fmiModelDescription>")).1.contains("not well-formed"));
}

#[test]
fn a_hundred_thousand_variables_are_read_without_quadratic_work() {
    use std::fmt::Write as _;
    let mut variables = String::new();
    for i in 0..100_000 {
        let _ = writeln!(variables, "<ScalarVariable name=\"v[{i}]\" valueReference=\"{i}\"><Real/></ScalarVariable>");
    }
    let (d, _) = read(&with_variables(&variables)).unwrap();
    assert_eq!(d.variables.len(), 100_000);
    assert_eq!(d.variable("v[99999]").unwrap().line, 100_005);
}
