//! Masses in files, where one that nothing moves is `null`: `#[serde(default, skip_serializing_if = "Option::is_none", with =
//! "immovable")]`. What is not known is left out.

use serde::{Deserialize as _, Deserializer, Serialize as _, Serializer};

/// Writes the mass.
pub(super) fn serialize<S: Serializer>(mass_kg: &Option<f64>, to: S) -> Result<S::Ok, S::Error> {
    mass_kg.filter(|kg| kg.is_finite()).serialize(to)
}

/// Reads it.
pub(super) fn deserialize<'de, D: Deserializer<'de>>(from: D) -> Result<Option<f64>, D::Error> {
    Ok(Some(Option::<f64>::deserialize(from)?.unwrap_or(f64::INFINITY)))
}

#[cfg(test)]
mod tests {
    use serde::{Deserialize, Serialize};

    #[derive(Debug, PartialEq, Serialize, Deserialize)]
    struct Hit {
        #[serde(default, skip_serializing_if = "Option::is_none", with = "super")]
        mass_kg: Option<f64>,
    }

    #[test]
    fn unknown_immovable_and_movable_are_three_things_and_read_back() {
        for (mass_kg, text) in
            [(None, "{}"), (Some(f64::INFINITY), r#"{"mass_kg":null}"#), (Some(2.5), r#"{"mass_kg":2.5}"#)]
        {
            assert_eq!(serde_json::to_string(&Hit { mass_kg }).unwrap(), text);
            assert_eq!(serde_json::from_str::<Hit>(text).unwrap(), Hit { mass_kg });
        }
    }
}
