//! The reference chapters of the book: commands from their definition, the cell file from its schema. In Markdown.

use std::fmt::Write as _;

use clap::Command;
use serde_json::{Map, Value};

/// Every command with its help.
pub(super) fn commands(command: &Command) -> String {
    let mut text = String::from("# Commands\n\nMade by `fmi-hazard manual --book`; do not edit.\n");
    let mut command = command.clone().term_width(100);
    command.build();
    for sub in command.get_subcommands_mut() {
        if sub.get_name() == "help" {
            continue;
        }
        let help = sub.clone().term_width(100).render_long_help().to_string();
        let help: Vec<&str> = help.lines().map(str::trim_end).collect();
        let _ = write!(text, "\n## {}\n\n```text\n{}\n```\n", sub.get_name(), help.join("\n").trim_end());
    }
    text
}

/// Every table of the cell file with its keys.
pub(super) fn cell_file(schema: &Value) -> String {
    let mut text = String::from(
        "# The cell file\n\nMade from its schema by `fmi-hazard manual --book`; do not edit. Lengths are in metres, angles in \
         degrees, masses in kilograms, as the names of the keys say; the world has z up and the floor at z = 0.\n",
    );
    table(&mut text, "The whole file", schema);
    let definitions = schema.get("$defs").and_then(Value::as_object);
    for (name, definition) in definitions.into_iter().flatten() {
        table(&mut text, name, definition);
    }
    text
}

fn table(text: &mut String, name: &str, definition: &Value) {
    let _ = write!(text, "\n## {name}\n");
    if let Some(about) = definition.get("description").and_then(Value::as_str) {
        let _ = write!(text, "\n{}\n", prose(about));
    }
    // What a variant may leave out is needed all the same.
    let required = [definition.get("required"), definition.get("then").and_then(|then| then.get("required"))];
    let required: Vec<&str> =
        required.into_iter().flatten().filter_map(Value::as_array).flatten().filter_map(Value::as_str).collect();
    if let Some(keys) = definition.get("properties").and_then(Value::as_object) {
        text.push_str("\n| key | takes | |\n|---|---|---|\n");
        for (key, value) in keys {
            let needed = if required.contains(&key.as_str()) { " **needed.**" } else { "" };
            let about = value.get("description").and_then(Value::as_str).map(prose).unwrap_or_default();
            let default = value.get("default").filter(|v| !v.is_null() && !v.is_array() && !v.is_object());
            let default = default.map(|value| format!(" Default: `{value}`.")).unwrap_or_default();
            let _ = writeln!(text, "| `{key}` | {} | {}{needed}{default} |", kind(value), cell(&about));
        }
    }
    let choices = definition.get("oneOf").or_else(|| definition.get("anyOf")).and_then(Value::as_array);
    for choice in choices.into_iter().flatten().filter_map(Value::as_object) {
        if let Some(value) = choice.get("const") {
            let about = choice.get("description").and_then(Value::as_str).map(prose).unwrap_or_default();
            let _ = write!(text, "\n- `{value}`: {about}");
        }
    }
    if !text.ends_with('\n') {
        text.push('\n');
    }
}

/// Text of a description on one line.
fn prose(text: &str) -> String {
    text.split_whitespace().collect::<Vec<_>>().join(" ").replace(['<', '>'], "")
}

/// The same within a table.
fn cell(text: &str) -> String {
    text.replace('|', "\\|")
}

/// What a key takes, in a word or a link.
fn kind(value: &Value) -> String {
    let Some(value) = value.as_object() else { return "anything".to_owned() };
    if let Some(reference) = value.get("$ref").and_then(Value::as_str) {
        let name = reference.rsplit('/').next().unwrap_or(reference);
        return format!("[{name}](#{})", name.to_lowercase());
    }
    let alternatives = value.get("anyOf").or_else(|| value.get("oneOf")).and_then(Value::as_array);
    if let Some(alternatives) = alternatives {
        let all: Vec<String> = alternatives.iter().map(kind).filter(|kind| kind != "null").collect();
        return all.join(" or ");
    }
    match value.get("type") {
        Some(Value::String(one)) => named(one, value),
        Some(Value::Array(many)) => {
            let all: Vec<String> = many
                .iter()
                .filter_map(Value::as_str)
                .filter(|one| *one != "null")
                .map(|one| named(one, value))
                .collect();
            all.join(" or ")
        }
        _ => "value".to_owned(),
    }
}

fn named(kind: &str, value: &Map<String, Value>) -> String {
    match kind {
        "array" => match (value.get("items"), value.get("minItems").and_then(Value::as_u64)) {
            (Some(items), Some(count)) => format!("{count} x {}", self::kind(items)),
            (Some(items), None) => format!("list of {}", self::kind(items)),
            _ => "list".to_owned(),
        },
        "object" => match value.get("additionalProperties") {
            Some(of @ Value::Object(_)) => format!("table: name = {}", self::kind(of)),
            _ => "table".to_owned(),
        },
        "integer" => "whole number".to_owned(),
        "string" => "text".to_owned(),
        "boolean" => "true or false".to_owned(),
        other => other.to_owned(),
    }
}
