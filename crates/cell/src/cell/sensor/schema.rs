//! The `kind` of a sensor in a cell file, and in its schema: one of the list of kinds.

use std::borrow::Cow;
use std::fmt;
use std::sync::LazyLock;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::{Deserialize, Deserializer, EnumAccess, Error, VariantAccess, Visitor};
use serde_json::{Value, json};

use super::{KINDS, SensorKind};

/// The keys of all kinds.
static KEYS: LazyLock<Vec<&'static str>> = LazyLock::new(|| KINDS.iter().map(|kind| kind.key()).collect());

impl<'de> Deserialize<'de> for SensorKind {
    fn deserialize<D: Deserializer<'de>>(deserializer: D) -> Result<Self, D::Error> {
        deserializer.deserialize_enum("SensorKind", KEYS.as_slice(), Named)
    }
}

struct Named;

impl<'de> Visitor<'de> for Named {
    type Value = SensorKind;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("enum SensorKind")
    }

    fn visit_enum<A: EnumAccess<'de>>(self, named: A) -> Result<SensorKind, A::Error> {
        let (kind, rest) = named.variant_seed(Key)?;
        rest.unit_variant()?;
        Ok(kind)
    }
}

struct Key;

impl<'de> serde::de::DeserializeSeed<'de> for Key {
    type Value = SensorKind;

    fn deserialize<D: Deserializer<'de>>(self, deserializer: D) -> Result<SensorKind, D::Error> {
        deserializer.deserialize_identifier(self)
    }
}

impl Visitor<'_> for Key {
    type Value = SensorKind;

    fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("variant identifier")
    }

    fn visit_str<E: Error>(self, key: &str) -> Result<SensorKind, E> {
        let kind = KINDS.iter().find(|kind| kind.key() == key);
        kind.copied().ok_or_else(|| E::unknown_variant(key, KEYS.as_slice()))
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
