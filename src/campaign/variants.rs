//! The cell files that follow from a campaign file: each of its cells, laid over with each combination of values and bodies.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use toml::{Table, Value};

use super::CampaignError;
use super::description::{Axis, Description};
use super::values::{Values, evaluate, shown};
use crate::cell::file::files::named_from;
use crate::cell::find::{OpenedCell, open};

/// A cell of a campaign: what is scanned.
pub(crate) struct Variant {
    /// The cell file, seen from the folder of the campaign.
    pub path: PathBuf,
    /// What is written there; nothing if it is one of the user's own.
    pub text: Option<String>,
    /// Values of the sweeps.
    pub at: Values,
    /// The body, if the campaign file names some.
    pub body: Option<String>,
    /// The cell that it is laid over, as it calls itself.
    pub of: String,
}

/// All of them, in the order of cells, then of values (the first sweep changes slowest), then of bodies. `beside` is the folder of
/// the campaign file, `folder` that of the campaign.
///
/// # Errors
/// When a cell cannot be opened, or `over` cannot be worked out.
pub(crate) fn variants(description: &Description, path: &Path, folder: &Path) -> Result<Vec<Variant>, CampaignError> {
    let beside = path.parent().unwrap_or(Path::new(""));
    let wrong =
        |what: String, help: &str| CampaignError::Description { path: path.to_owned(), what, help: help.to_owned() };
    let bodies: Vec<Option<&_>> = match description.bodies.as_slice() {
        [] => vec![None],
        bodies => bodies.iter().map(Some).collect(),
    };
    let all = combinations(&description.axes());
    let (mut found, mut names) = (Vec::new(), BTreeMap::new());
    for cell in &description.cells {
        let base = beside.join(cell);
        let OpenedCell { cell: opened, .. } = open(&base, None)?;
        if opened.second.is_some() && !description.bodies.is_empty() {
            let what = format!("{} has two people: [[body]] does not say of whom", base.display());
            return Err(wrong(what, "give each body in a cell file of its own, or in [[over.human]] by name"));
        }
        let plain = all.len() == 1
            && description.over.is_empty()
            && description.bodies.is_empty()
            && description.axes().is_empty();
        for at in &all {
            for &body in &bodies {
                let told = at.iter().map(|(name, value)| format!("-{name}-{}", shown(*value)));
                let told: String = told.chain(body.map(|body| format!("-{}-{}", body.sex, body.percentile))).collect();
                let told = if told.is_empty() { format!("-{}", description.name) } else { told };
                let name = if plain { opened.name.clone() } else { format!("{}{told}", opened.name) };
                if let Some(other) = names.insert(name.clone(), base.clone()) {
                    let what = format!("{} and {} both make a cell `{name}`", other.display(), base.display());
                    return Err(wrong(what, "give one of them another name: results are kept by it"));
                }
                let (path, text) = if plain {
                    (named_from(&base, folder).into(), None)
                } else {
                    let own = Path::new(CELLS).join(file_name(&name) + ".toml");
                    let mut table = Table::new();
                    table.insert("extends".to_owned(), named_from(&base, &folder.join(CELLS)).into());
                    table.insert("name".to_owned(), name.as_str().into());
                    let over = worked_out(&Value::Table(description.over.clone()), at, "over")
                        .map_err(|what| wrong(what, "values of sweeps are used by their names: \"= -1 + width\""))?;
                    if let Value::Table(over) = over {
                        table.extend(over);
                    }
                    if let Some(body) = body {
                        let human = table.entry("human").or_insert_with(|| Value::Table(Table::new()));
                        if let Value::Table(human) = human {
                            human.insert("sex".to_owned(), body.sex.as_str().into());
                            human.insert("percentile".to_owned(), i64::from(body.percentile).into());
                        }
                    }
                    let text = toml::to_string(&table).map_err(|e| CampaignError::Ours(e.to_string()))?;
                    (own, Some(text))
                };
                let body = body.map(|body| format!("{} {} %", body.sex, body.percentile));
                found.push(Variant { path, text, at: at.clone(), body, of: opened.name.clone() });
            }
        }
    }
    Ok(found)
}

/// Where cell files are written, in the folder of the campaign.
pub(super) const CELLS: &str = "cells";

/// Every value of each axis with every one of the others.
fn combinations(axes: &[Axis]) -> Vec<Values> {
    axes.iter().fold(vec![Values::new()], |all, axis| {
        let with = |values: &Values, value: &f64| {
            let mut values = values.clone();
            values.insert(axis.name.clone(), *value);
            values
        };
        all.iter().flat_map(|values| axis.values.iter().map(move |value| with(values, value))).collect()
    })
}

/// What is laid over, with every text that begins with `=` worked out.
fn worked_out(value: &Value, at: &Values, key: &str) -> Result<Value, String> {
    Ok(match value {
        Value::String(text) => match text.strip_prefix('=') {
            Some(text) => {
                let value = evaluate(text, at).map_err(|why| format!("`{key}` is `={text}`: {why}"))?;
                number(value)
            }
            None => value.clone(),
        },
        Value::Array(all) => {
            Value::Array(all.iter().map(|value| worked_out(value, at, key)).collect::<Result<_, _>>()?)
        }
        Value::Table(all) => {
            let one = |(name, value): (&String, &Value)| {
                Ok::<_, String>((name.clone(), worked_out(value, at, &format!("{key}.{name}"))?))
            };
            Value::Table(all.iter().map(one).collect::<Result<_, _>>()?)
        }
        other => other.clone(),
    })
}

/// A whole number as one: some keys take no other.
fn number(value: f64) -> Value {
    #[expect(clippy::cast_possible_truncation, reason = "it is whole and small")]
    let whole = value as i64;
    if value.fract() == 0.0 && value.abs() < 1e9 { Value::Integer(whole) } else { Value::Float(value) }
}

/// A file name from a cell's name.
fn file_name(name: &str) -> String {
    name.chars().map(|c| if c.is_alphanumeric() || "-_.".contains(c) { c } else { '-' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_value_meets_every_other_and_only_texts_with_an_equals_sign_are_worked_out() {
        let axis =
            |name: &str, values: &[f64]| Axis { name: name.to_owned(), unit: String::new(), values: values.to_vec() };
        let all = combinations(&[axis("b", &[1.0, 2.0]), axis("a", &[3.0, 4.0, 5.0])]);
        let pairs: Vec<(f64, f64)> = all.iter().map(|at| (at["b"], at["a"])).collect();
        assert_eq!(pairs, [(1.0, 3.0), (1.0, 4.0), (1.0, 5.0), (2.0, 3.0), (2.0, 4.0), (2.0, 5.0)]);
        let table: Table = "x = \"= a / 2\"\ny = [\"=b\", \"b\", 7]\nz = { w = \"=-b\" }".parse().unwrap();
        let out = worked_out(&Value::Table(table), &all[1], "over").unwrap();
        assert_eq!(toml::to_string(&out).unwrap(), "x = 2\ny = [1, \"b\", 7]\n\n[z]\nw = -1\n");
        let table: Table = "[q]\nx = \"= c\"".parse().unwrap();
        let told = worked_out(&Value::Table(table), &all[0], "over").unwrap_err();
        assert!(told.contains("`over.q.x`") && told.contains("`c`"), "{told}");
    }
}
