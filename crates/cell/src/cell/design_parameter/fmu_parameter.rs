//! Which parameters of an FMU can be turned, and how far: speeds, lengths, times and truth values, told by their units, else
//! by their words. Whole numbers and enumerations are not turned: what their values mean is not known.

use toml::{Table, Value};

use crate::cell::binding::BoundUnit;
use crate::fmi::{Causality, Variable, VariableType};

/// What a parameter is.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Quantity {
    /// A speed, or a part of one.
    Speed,
    /// With so many of its units in a metre.
    Length {
        /// Units in a metre.
        per_m: f64,
    },
    /// With so many of its units in a second.
    Time {
        /// Units in a second.
        per_s: f64,
    },
}

/// The value of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Setting {
    /// A number, and what it is.
    Number {
        /// The number.
        value: f64,
        /// What it is.
        quantity: Quantity,
        /// Smallest value that the FMU states.
        min: f64,
        /// Largest value that the FMU states.
        max: f64,
    },
    /// A truth value.
    Flag(bool),
}

/// A parameter of an FMU.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FmuParameter {
    /// With the unit's name in front, as in cell files.
    pub name: String,
    /// Unit of its value; empty if it has none.
    pub unit: String,
    /// As the cell file sets it, else its start.
    pub setting: Setting,
}

/// Words in the names and descriptions of times that have no unit.
const TIMES: [&str; 12] = [
    "time", "delay", "hold", "tau", "filter", "timeout", "debounce", "dwell", "latency", "duration", "reaction",
    "response",
];

/// What can be turned among the parameters that a cell can set.
pub(super) fn parameters(text: &Table, units: &[BoundUnit<'_>]) -> Vec<FmuParameter> {
    let set = text.get("parameters").and_then(Value::as_table);
    let mut found = Vec::new();
    for unit in units {
        for variable in &unit.description.variables {
            if variable.causality != Causality::Parameter || !variable.dimensions.is_empty() {
                continue;
            }
            let name =
                if unit.name.is_empty() { variable.name.clone() } else { format!("{}:{}", unit.name, variable.name) };
            let own = set.and_then(|set| set.get(&name));
            let setting = match &variable.kind {
                VariableType::Boolean { start } => own
                    .and_then(Value::as_bool)
                    .or_else(|| start.first().copied())
                    .map(|b| (Setting::Flag(b), String::new())),
                VariableType::Real { start, min, max, .. } => quantity(variable).and_then(|(quantity, of)| {
                    let value = own.and_then(super::number).or_else(|| start.first().copied())?;
                    let (min, max) = (min.unwrap_or(f64::NEG_INFINITY), max.unwrap_or(f64::INFINITY));
                    Some((Setting::Number { value, quantity, min, max }, of))
                }),
                _ => None,
            };
            found.extend(setting.map(|(setting, unit)| FmuParameter { name, unit, setting }));
        }
    }
    found
}

/// Whether a parameter is a speed, a length or a time: by its unit, or, for those without one, by its words.
fn quantity(variable: &Variable) -> Option<(Quantity, String)> {
    let VariableType::Real { unit, .. } = &variable.kind else { return None };
    let unit = unit.as_deref().unwrap_or_default();
    let words = words(&format!("{} {}", variable.name, variable.description));
    let any = |of: &[&str]| words.iter().any(|word| of.contains(&word.as_str()));
    let bare = || if unit == "%" { unit.to_owned() } else { String::new() };
    let told = |quantity| Some((quantity, unit.to_owned()));
    match unit {
        "m/s" | "mm/s" | "rad/s" | "deg/s" => told(Quantity::Speed),
        "m" => told(Quantity::Length { per_m: 1.0 }),
        "mm" => told(Quantity::Length { per_m: 1000.0 }),
        "s" => told(Quantity::Time { per_s: 1.0 }),
        "ms" => told(Quantity::Time { per_s: 1000.0 }),
        "min" => told(Quantity::Time { per_s: 1.0 / 60.0 }),
        "" | "1" | "%" if any(&["speed", "velocity", "override"]) => Some((Quantity::Speed, bare())),
        "" if any(&TIMES) => Some((Quantity::Time { per_s: 1.0 }, String::new())),
        _ => None,
    }
}

/// The words of a text in lower case; `holdTime` and `hold_time` are two each.
fn words(text: &str) -> Vec<String> {
    let mut words = vec![String::new()];
    let mut before = ' ';
    for c in text.chars() {
        if !c.is_alphanumeric() || (c.is_uppercase() && before.is_lowercase()) {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut().filter(|_| c.is_alphanumeric()) {
            word.extend(c.to_lowercase());
        }
        before = c;
    }
    words.retain(|word| !word.is_empty());
    words
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fmi::{Scalar, Variability};

    fn real(name: &str, description: &str, unit: &str) -> Variable {
        Variable {
            name: name.to_owned(),
            value_reference: 0,
            causality: Causality::Parameter,
            variability: Variability::Fixed,
            kind: VariableType::Real {
                unit: (!unit.is_empty()).then(|| unit.to_owned()),
                start: vec![1.0],
                min: None,
                max: None,
            },
            scalar: Scalar::Float64,
            dimensions: Vec::new(),
            description: description.to_owned(),
            line: 1,
        }
    }

    #[test]
    fn times_are_told_by_their_unit_else_by_their_words() {
        let is_time = |name, description, unit| {
            matches!(quantity(&real(name, description, unit)), Some((Quantity::Time { .. }, _)))
        };
        assert!(is_time("x", "", "s") && is_time("x", "", "ms") && is_time("x", "", "min"));
        assert!(
            is_time("filter.tau", "", "")
                && is_time("muting.holdTime", "", "")
                && is_time("T1", "Delay of the relay", "")
        );
        // No part of a word is one.
        assert!(!is_time("threshold", "restaurant", "") && !is_time("hold", "", "N"));
        assert_eq!(quantity(&real("x", "", "ms")).map(|(q, _)| q), Some(Quantity::Time { per_s: 1000.0 }));
        assert_eq!(quantity(&real("speedFactor", "", "1")), Some((Quantity::Speed, String::new())));
    }
}
