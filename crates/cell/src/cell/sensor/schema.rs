//! The `kind` of a sensor in a cell file, and in its schema: one of the list of kinds.

use std::borrow::Cow;
use std::sync::LazyLock;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, Error as _};
use serde_json::{Value, json};

use super::{KINDS, SensorKind};

/// The keys of all kinds.
static KEYS: LazyLock<Vec<&'static str>> = LazyLock::new(|| KINDS.iter().map(|kind| kind.key()).collect());

impl<'de> Deserialize<'de> for SensorKind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        let key = Cow::<str>::deserialize(deserializer)?;
        let kind = KINDS.iter().find(|kind| kind.key() == key);
        kind.copied().ok_or_else(|| D::Error::unknown_variant(&key, KEYS.as_slice()))
    }
}

impl JsonSchema for SensorKind {
    fn schema_name() -> Cow<'static, str> {
        "SensorKind".into()
    }

    fn schema_id() -> Cow<'static, str> {
        concat!(module_path!(), "::SensorKind").into()
    }

    fn json_schema(_: &mut SchemaGenerator) -> Schema {
        let one = |kind: &SensorKind| json!({ "description": kind.doc(), "type": "string", "const": kind.key() });
        let all: Vec<Value> = KINDS.iter().map(one).collect();
        json_schema!({ "description": "What a sensor is.", "oneOf": all })
    }
}
