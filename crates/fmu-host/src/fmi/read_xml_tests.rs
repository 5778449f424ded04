//! modelDescription.xml as exporters write it, and as they should not.

use super::super::variable::{Dimension, Scalar, Variability};
use super::*;

const HEAD: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription xmlns:xsi="http://www.w3.org/2001/XMLSchema-instance" fmiVersion="2.0" modelName="Cell"
  guid="{1}" generationTool="Test" numberOfEventIndicators="0">
  <CoSimulation modelIdentifier="Cell" canGetAndSetFMUstate="true"/><UnitDefinitions><Unit name="rad"/><Unit name="m"/></UnitDefinitions>"#;

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
    assert_eq!(q.kind, VariableType::Real { unit: Some("rad".into()), start: vec![], min: Some(-3.0), max: Some(2.0) });
    assert_eq!((q.value_reference, q.causality, q.description.as_str()), (3, Causality::Output, "a < b"));
    assert_eq!(d.variable("stop").unwrap().kind, VariableType::Boolean { start: vec![true] });
    assert_eq!(d.variable("n").unwrap().kind, VariableType::Integer { start: vec![-7] });
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
    for identifier in ["My-Cell", "cell.v2", "1st"] {
        let text = with_variables("").replace("modelIdentifier=\"Cell\"", &format!("modelIdentifier=\"{identifier}\""));
        let (d, _) = read(&text).unwrap();
        assert_eq!(d.co_simulation.unwrap().capabilities.model_identifier, identifier);
    }
    for identifier in ["../../bin/sh", "a/b", "a b", "a;rm", ".so", "-v", "..", "", "caf\u{e9}"] {
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

const HEAD3: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="3.0" modelName="Cell" instantiationToken="{3}" generationTool="Test">
  <CoSimulation modelIdentifier="Cell" canGetAndSetFMUState="true" hasEventMode="true" fixedInternalStepSize="1e-3"
    mightReturnEarlyFromDoStep="true" providesEvaluateDiscreteStates="false"/>
  <UnitDefinitions><Unit name="rad"/><Unit name="m"/></UnitDefinitions><TypeDefinitions><Float64Type name="Angle" unit="rad" min="-3"/><EnumerationType name="Mode"><Item name="a" value="1"/></EnumerationType></TypeDefinitions>"#;

fn third(variables: &str) -> String {
    format!("{HEAD3}\n<ModelVariables>\n{variables}\n</ModelVariables><ModelStructure/></fmiModelDescription>")
}

#[test]
fn every_type_of_fmi_3_is_read() {
    let text = third(
        r#"<Float64 name="q" valueReference="1" causality="output" declaredType="Angle" initial="exact" start="0.5" max="2">
  <Alias name="q2" description="the same" displayUnit="deg"/>
</Float64>
<Float32 name="f" valueReference="2" start="INF" unit="m"/>
<Int8 name="i8" valueReference="3" start="-128"/><UInt8 name="u8" valueReference="4" start="255"/>
<Int16 name="i16" valueReference="5" start="-32768"/><UInt16 name="u16" valueReference="6" start="65535"/>
<Int32 name="i32" valueReference="7" start="-7"/><UInt32 name="u32" valueReference="8" start="4294967295"/>
<Int64 name="i64" valueReference="9" start="-9223372036854775808" min="0"/>
<UInt64 name="u64" valueReference="10" start="18446744073709551615"/>
<Boolean name="b" valueReference="11" start="true" causality="parameter" variability="fixed"/>
<String name="s" valueReference="12"><Start value="a b"/></String>
<Binary name="x" valueReference="13" mimeType="a/b" maxSize="9"><Start value="00ff 1A"/></Binary>
<Enumeration name="e" valueReference="14" declaredType="Mode" start="1"/>
<Clock name="c" valueReference="15" causality="input" intervalVariability="triggered" priority="1"/>"#,
    );
    let (d, warnings) = read(&text).unwrap();
    assert_eq!(
        warnings.iter().map(ToString::to_string).collect::<Vec<_>>(),
        ["line 10: the start value of `f` is not finite"]
    );
    assert_eq!((d.version(), d.guid.as_str()), (Some(FmiVersion::V3), "{3}"));
    let capabilities = &d.co_simulation.as_ref().unwrap().capabilities;
    assert!(capabilities.can_get_and_set_state && capabilities.has_event_mode && capabilities.might_return_early);
    assert_eq!(capabilities.fixed_internal_step, Some(1e-3));
    let q = d.variable("q").unwrap();
    assert_eq!(
        q.kind,
        VariableType::Real { unit: Some("rad".into()), start: vec![0.5], min: Some(-3.0), max: Some(2.0) }
    );
    let alias = d.variable("q2").unwrap();
    assert_eq!((alias.value_reference, alias.line, alias.description.as_str()), (1, 8, "the same"));
    assert_eq!((&alias.kind, alias.causality), (&q.kind, Causality::Output));
    for (name, scalar, start) in [
        ("i8", Scalar::Int8, -128),
        ("u8", Scalar::UInt8, 255),
        ("i16", Scalar::Int16, -32768),
        ("u16", Scalar::UInt16, 65535),
        ("i32", Scalar::Int32, -7),
        ("u32", Scalar::UInt32, u32::MAX.into()),
        ("i64", Scalar::Int64, i64::MIN.into()),
        ("u64", Scalar::UInt64, u64::MAX.into()),
    ] {
        let v = d.variable(name).unwrap();
        assert_eq!((v.scalar, &v.kind), (scalar, &VariableType::Integer { start: vec![start] }));
        assert_eq!(v.variability, Variability::Discrete);
    }
    assert_eq!(d.variable("f").unwrap().scalar, Scalar::Float32);
    assert_eq!(d.variable("b").unwrap().variability, Variability::Fixed);
    assert_eq!(d.variable("s").unwrap().kind, VariableType::String { start: vec!["a b".into()] });
    assert_eq!(d.variable("x").unwrap().kind, VariableType::Binary { start: vec![vec![0, 255, 26]] });
    let e = d.variable("e").unwrap();
    assert_eq!((e.scalar, e.type_name(FmiVersion::V3).as_str()), (Scalar::Int64, "Enumeration"));
    assert!(d.needs_event_mode());
}

#[test]
fn arrays_of_fmi_3_are_addressed_by_element() {
    let text = third(
        r#"<UInt64 name="n" valueReference="1" causality="structuralParameter" start="3"/>
<Float64 name="a" valueReference="2" causality="input" start="1 2 3
  4 5 6"><Dimension start="2"/><Dimension valueReference="1"/></Float64>
<Boolean name="b" valueReference="3" start="true false true"><Dimension valueReference="1"/></Boolean>
<Float64 name="b[2]" valueReference="4"/>
<String name="s" valueReference="5"><Dimension start="2"/><Start value="x"/><Start value=""/></String>
<Float64 name="odd" valueReference="6" start="1 2 3"><Dimension start="2"/></Float64>"#,
    );
    let (d, warnings) = read(&text).unwrap();
    assert_eq!(
        warnings.iter().map(ToString::to_string).collect::<Vec<_>>(),
        ["line 13: `odd` has 2 values, but 3 start values"]
    );
    let a = d.variable("a").unwrap();
    assert_eq!(a.dimensions, [Dimension::Fixed(2), Dimension::Parameter(1)]);
    assert_eq!((d.count(a), a.numeric_start()), (Some(6), vec![1.0, 2.0, 3.0, 4.0, 5.0, 6.0]));
    let place = |name: &str| d.element(name).map(|(v, offset, count)| (v.value_reference, offset, count));
    assert_eq!(place("a[1,1]"), Some((2, 0, 6)));
    assert_eq!(place("a[2, 3]"), Some((2, 5, 6)));
    assert_eq!(place("b[3]"), Some((3, 2, 3)));
    // A scalar of this very name comes first.
    assert_eq!(place("b[2]"), Some((4, 0, 1)));
    for none in ["a", "a[1]", "a[0,1]", "a[3,1]", "a[1,4]", "a[1,1,1]", "a[]", "a[x,1]", "n[1]", "z[1]", "]", "a[-1,1]"]
    {
        assert_eq!(place(none), None, "{none}");
    }
    for (name, handle) in d.elements(a) {
        assert_eq!(d.handle(&name), Some(handle), "{name}");
    }
    assert_eq!(d.elements(a).count(), 6);
    assert_eq!(d.variable("s").unwrap().kind, VariableType::String { start: vec!["x".into(), String::new()] });
}

#[test]
fn what_is_wrong_in_fmi_3_is_told_with_its_line() {
    for (variables, line, words) in [
        (r#"<Int8 name="q" valueReference="1" start="128"/>"#, 7, "-128 to 127"),
        (r#"<UInt64 name="q" valueReference="1" start="-1"/>"#, 7, "0 to 18446744073709551615"),
        ("\n<Float32 name=\"q\" valueReference=\"1\" start=\"1 fast\"/>", 8, "\"fast\""),
        (r#"<Boolean name="q" valueReference="1" start="true maybe"/>"#, 7, "\"maybe\""),
        (r#"<Float64 name="q"/>"#, 7, "no valueReference"),
        ("<Binary name=\"q\" valueReference=\"1\">\n<Start value=\"abc\"/></Binary>", 8, "hexadecimal"),
        ("<Float64 name=\"q\" valueReference=\"1\">\n<Dimension/></Float64>", 8, "either start or valueReference"),
        ("<Float64 name=\"q\" valueReference=\"1\">\n<Dimension start=\"x\"/></Float64>", 8, "\"x\""),
        (
            "\n<Float64 name=\"q\" valueReference=\"1\"><Dimension valueReference=\"9\"/></Float64>",
            8,
            "size of the array `q`",
        ),
        (r#"<Float64 name="q" valueReference="1"><Dimension start="999999999999"/></Float64>"#, 7, "100000000 values"),
        ("<Float64 name=\"q\" valueReference=\"1\">\n<Alias name=\"q\"/></Float64>", 8, "two variables are called `q`"),
    ] {
        let (at, message) = problem(&third(variables));
        assert!(message.contains(words), "{message}");
        assert_eq!(at, line, "{message}");
    }
    let text = third(r#"<Int32 name="q" valueReference="3" colour="red"/><Thing/>"#);
    let (_, warnings) = read(&text).unwrap();
    let warnings: Vec<String> = warnings.iter().map(ToString::to_string).collect();
    assert_eq!(warnings, ["line 7: unknown attribute `colour` in <Int32>", "line 7: unknown element <Thing>"]);
}

#[test]
fn what_would_cost_more_and_more_does_not() {
    // Many other names, each with a copy of many start values.
    let starts = "1 ".repeat(20_000);
    let names: String = (0..1000).map(|i| format!("<Alias name=\"a{i}\"/>")).collect();
    let variable = format!(
        "<Float64 name=\"q\" valueReference=\"1\" start=\"{starts}\"><Dimension start=\"20000\"/>\n{names}</Float64>"
    );
    let (line, message) = problem(&third(&variable));
    assert_eq!((line, message.as_str()), (7, "`q` has 20000 start values under 1001 names, which is refused"));
    // A hundred thousand elements, one in another.
    let (d, _) = read(&third(&format!("{}{}", "<a>".repeat(100_000), "</a>".repeat(100_000)))).unwrap();
    assert_eq!(d.variables, []);
}

#[test]
fn versions_are_told_apart() {
    for (version, known) in [
        ("2.0", Some(FmiVersion::V2)),
        ("3.0", Some(FmiVersion::V3)),
        ("3.0.2", Some(FmiVersion::V3)),
        ("3.1", None),
        ("3.1-beta.1", None),
        ("3.0-beta.4", None),
        ("3.0.", None),
        ("1.0", None),
    ] {
        let d = ModelDescription { fmi_version: version.to_owned(), ..ModelDescription::default() };
        assert_eq!(d.version(), known, "{version}");
    }
    let (d, _) = read(r#"<fmiModelDescription fmiVersion="3.1-beta.1"><CoSimulation/></fmiModelDescription>"#).unwrap();
    assert_eq!(d.fmi_version, "3.1-beta.1");
}
