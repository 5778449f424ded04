//! What the page says of how a scan was made: its settings, and what the self-test of the FMU found.

use serde_json::Value;

use super::Row;
use fmi_hazard_record::forces::speed_words;
use fmi_hazard_record::model::Settings;
use fmu_self_test::{Agreement, SelfTest, number};

/// Units by what names end in.
const UNITS: [(&str, &str); 4] = [("_m_s", " m/s"), ("_s", " s"), ("_m", " m"), ("_deg", " degrees")];

/// Every setting as it stands in `scan.json`.
pub(super) fn settings(all: &Value, told: &Settings) -> Vec<Row> {
    let one = |(key, value): (&String, &Value)| match key.as_str() {
        "speed_criterion" => (label(key), speed_words(told.speed_criterion).to_owned()),
        _ => named(key, value),
    };
    all.as_object().into_iter().flatten().map(one).collect()
}

fn label(key: &str) -> String {
    key.replace('_', " ")
}

/// Any value in words, with the unit that its name ends in, and the name without it.
fn named(key: &str, value: &Value) -> Row {
    let measured = is_measured(value);
    let (name, unit) = UNITS
        .into_iter()
        .filter(|_| measured)
        .find_map(|(end, unit)| Some((key.strip_suffix(end)?, unit)))
        .unwrap_or((key, ""));
    (label(name), format!("{}{unit}", in_words(value)))
}

/// Whether it is a number, or numbers.
fn is_measured(value: &Value) -> bool {
    match value {
        Value::Array(all) => !all.is_empty() && all.iter().all(is_measured),
        one => one.is_number(),
    }
}

fn in_words(value: &Value) -> String {
    let inside = |value: &Value| match value {
        Value::Array(_) | Value::Object(_) => format!("({})", in_words(value)),
        _ => in_words(value),
    };
    match value {
        Value::Null => "none".to_owned(),
        Value::Bool(true) => "yes".to_owned(),
        Value::Bool(false) => "no".to_owned(),
        Value::Number(n) if n.is_f64() => n.as_f64().map_or_else(String::new, number),
        Value::Number(n) => n.to_string(),
        Value::String(text) => text.clone(),
        Value::Array(all) if all.is_empty() => "none".to_owned(),
        Value::Array(all) => all.iter().map(inside).collect::<Vec<_>>().join("; "),
        Value::Object(all) => {
            let one = |(key, value): (&String, &Value)| {
                let (name, words) = named(key, value);
                if value.is_object() { format!("{name} ({words})") } else { format!("{name} {words}") }
            };
            all.iter().map(one).collect::<Vec<_>>().join(", ")
        }
    }
}

/// What the self-test found.
pub(super) fn self_test(test: &SelfTest) -> Vec<Row> {
    let row = |term: &str, text: String| (term.to_owned(), text);
    let mut rows = vec![
        row("steps", format!("{} of {} s", test.steps, number(test.step_s))),
        row("inputs", test.inputs.to_string()),
        row("outputs", test.outputs.to_string()),
    ];
    let agreements: [(&str, &Agreement); 7] = [
        ("deterministic", &test.deterministic),
        ("second instance", &test.second_instance),
        ("restore", &test.restore),
        ("fork", &test.fork),
        ("fresh process", &test.fresh_process),
        ("reset", &test.reset),
        ("serialize", &test.serialize),
    ];
    rows.extend(agreements.map(|(term, agreement)| row(term, agreement.to_string())));
    rows.push(row("half steps", test.half_steps.to_string()));
    rows.push(row("event mode", test.event_mode.to_string()));
    rows.extend(test.remarks.iter().map(|remark| row("remark", remark.clone())));
    let bytes = test.bytes_per_state.map_or_else(|| "unknown".to_owned(), |bytes| bytes.to_string());
    rows.push(row("bytes per state", bytes));
    rows.push(row("output range", format!("{:.4}", test.output_range)));
    rows
}

#[cfg(test)]
mod tests {
    use serde_json::json;

    use super::*;

    #[test]
    fn settings_are_told_with_their_units() {
        let told = |key: &str, value: Value| {
            let (name, words) = named(key, &value);
            format!("{name}: {words}")
        };
        assert_eq!(told("reach_tolerance_m", json!(0.02)), "reach tolerance: 0.02 m");
        assert_eq!(told("until_s", json!(8)), "until: 8 s");
        assert_eq!(told("posture_sweep", json!(true)), "posture sweep: yes");
        assert_eq!(told("criteria", json!(null)), "criteria: none");
        assert_eq!(told("also", json!(["run", "kneel"])), "also: run; kneel");
        assert_eq!(told("body", json!({ "sex": "man", "radii_m": {} })), "body: radii m (), sex man");
        assert_eq!(
            told("begins", json!({ "xy_m": [1.0, -0.5], "heading_deg": 90.0 })),
            "begins: heading 90 degrees, xy 1; -0.5 m"
        );
        let corners = json!([[0.0, 1.0], [2.5, 1.0]]);
        assert_eq!(told("floor_m", corners), "floor: (0; 1); (2.5; 1) m");
        let second = json!({ "names": ["a", "b"], "body": { "percentile": 50 } });
        assert_eq!(told("second", second), "second: body (percentile 50), names a; b");
    }
}
