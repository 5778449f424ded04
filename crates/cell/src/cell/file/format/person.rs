//! The people in the cell file: their size, the reach of their bends, and where and when they begin.

use std::borrow::Cow;
use std::fmt;

use schemars::{JsonSchema, Schema, SchemaGenerator, json_schema};
use serde::de::value::MapAccessDeserializer;
use serde::de::{Error as _, MapAccess, SeqAccess, Visitor};
use serde::{Deserialize, Deserializer};
use toml::Spanned;

use crate::human::{Ability, Radii};
use crate::standards::anthropometry::Sex;

/// Where a scan has people begin.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum PeopleFrom {
    /// At the starts of the cell file.
    Start,
    /// Anywhere that no sensor sees.
    Anywhere,
    /// Anywhere first, then at the starts.
    Both,
}

/// The people: one as `[human]`, or two as `[[human]]`.
#[derive(Debug)]
pub struct People {
    /// The person that every cell has.
    pub first: HumanTable,
    /// A second one.
    pub second: Option<SecondTable>,
}

impl<'de> Deserialize<'de> for People {
    fn deserialize<D: Deserializer<'de>>(from: D) -> Result<Self, D::Error> {
        struct OneOrTwo;

        impl<'de> Visitor<'de> for OneOrTwo {
            type Value = People;

            fn expecting(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str("one person as [human], or two as [[human]]")
            }

            fn visit_map<A: MapAccess<'de>>(self, map: A) -> Result<People, A::Error> {
                let first = HumanTable::deserialize(MapAccessDeserializer::new(map))?;
                Ok(People { first, second: None })
            }

            fn visit_seq<A: SeqAccess<'de>>(self, mut list: A) -> Result<People, A::Error> {
                let first = list.next_element()?.ok_or_else(|| A::Error::custom("there is no person in `human`"))?;
                let second = list.next_element()?;
                match list.next_element::<serde::de::IgnoredAny>()? {
                    None => Ok(People { first, second }),
                    Some(_) => Err(A::Error::custom("there are more than two people in `human`")),
                }
            }
        }

        from.deserialize_any(OneOrTwo)
    }
}

impl JsonSchema for People {
    fn schema_name() -> Cow<'static, str> {
        "People".into()
    }

    fn json_schema(generator: &mut SchemaGenerator) -> Schema {
        let (first, second) = (generator.subschema_for::<HumanTable>(), generator.subschema_for::<SecondTable>());
        json_schema!({
            "description": "One person as `[human]`, with the keys of `HumanTable`; or two as `[[human]]`, the first with those keys, the second with the keys of `SecondTable`.",
            "anyOf": [
                first,
                { "type": "array", "prefixItems": [first, second], "items": false, "minItems": 1 },
            ],
        })
    }
}

/// The person.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct HumanTable {
    /// What the person is called in results, where there are two.
    #[serde(default)]
    pub name: Option<String>,
    /// Where the person stands at the start and looks. May be left out where there are start areas: then their first place
    /// is the start.
    #[serde(default)]
    #[schemars(with = "Option<StartTable>")]
    pub start: Option<Spanned<StartTable>>,
    /// Where a scan has people begin that is not told it (as with --from): at the starts, anywhere that no sensor sees, or both.
    #[serde(default)]
    pub from: Option<PeopleFrom>,
    /// Sex of the body measures.
    #[serde(default)]
    pub sex: Sex,
    /// Percentile of the body measures: 5, 50 or 95.
    #[serde(default = "p50")]
    #[schemars(with = "u8")]
    pub percentile: Spanned<u8>,
    /// Angle of a forward bend, degrees.
    #[serde(default = "forty_five")]
    pub bend_forward_deg: f64,
    /// Angle of a sideways bend, degrees.
    #[serde(default = "thirty")]
    pub bend_lateral_deg: f64,
    /// How fast hands move, m/s: at a contact, the wrist is no farther from where it is when the arm hangs than it gets at this speed
    /// since the sequence began. Without it arms are anywhere at once. Safety distances are made with 2.0 (ISO 13855).
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub arm_speed_m_s: Option<Spanned<f64>>,
    /// What the person does besides walking, bending and reaching. Nothing of it by default: each makes the search larger.
    #[serde(default = "nothing")]
    #[schemars(with = "Vec<Ability>")]
    pub also: Spanned<Vec<Ability>>,
    /// How far what the person holds, a tool or a workpiece, reaches beyond the finger tips, m, 0.05 to 1: in either hand, and in whatever
    /// direction the hand turns it. What hits it is taken to hit the hand. Nothing by default.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub held_m: Option<Spanned<f64>>,
    /// How fast who runs does so, m/s: two, three or four times the walking speed of 1.6 m/s. No standard counts on people who run.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub run_m_s: Option<Spanned<f64>>,
    /// Radii of body parts that are not those of a person of this stature.
    #[serde(default)]
    #[schemars(with = "Option<Radii>")]
    pub radii_m: Option<Spanned<Radii>>,
    /// Further starts; each is searched by itself.
    #[serde(default)]
    #[schemars(with = "Vec<StartTable>")]
    pub other_starts: Vec<Spanned<StartTable>>,
    /// Areas in which the person may start: every free place of a lattice in them is a start, and is searched by itself.
    #[serde(default, rename = "start_area")]
    #[schemars(with = "Vec<StartAreaTable>")]
    pub start_areas: Vec<Spanned<StartAreaTable>>,
    /// Floor that people may be on in a scan from anywhere: corners of a convex or concave polygon in the floor plane, m, in order.
    /// Without it that is all floor that is joined to the outside; with it, they come from where they start.
    #[serde(default)]
    #[schemars(with = "Option<Vec<[f64; 2]>>")]
    pub floor_m: Option<Spanned<Vec<[f64; 2]>>>,
    /// Floor from which people come in a scan from anywhere, over floor where no sensor sees them, whether before the FMU starts or
    /// later: corners of a polygon in the floor plane, m, in order. Without it they come from outside.
    #[serde(default)]
    #[schemars(with = "Option<Vec<[f64; 2]>>")]
    pub start_region_m: Option<Spanned<Vec<[f64; 2]>>>,
    /// When the person begins, s after the FMU's own start; each is searched by itself, from every start. So a scan does
    /// not depend on where in its cycle the robot is. Until then the person stands at the start.
    #[serde(default = "at_once")]
    #[schemars(with = "Vec<f64>")]
    pub begins_s: Spanned<Vec<f64>>,
}

/// A second person, who is there from the beginning. They do not stand in each other's way.
#[derive(Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct SecondTable {
    /// What the person is called in results.
    #[serde(default)]
    pub name: Option<String>,
    /// Where the person stands at the start and looks.
    #[schemars(with = "StartTable")]
    pub start: Spanned<StartTable>,
    /// Sex of the body measures.
    #[serde(default)]
    pub sex: Sex,
    /// Percentile of the body measures: 5, 50 or 95.
    #[serde(default = "p50")]
    #[schemars(with = "u8")]
    pub percentile: Spanned<u8>,
    /// Angle of a forward bend, degrees.
    #[serde(default = "forty_five")]
    pub bend_forward_deg: f64,
    /// Angle of a sideways bend, degrees.
    #[serde(default = "thirty")]
    pub bend_lateral_deg: f64,
    /// What the person does besides walking, bending and reaching. Nothing of it by default: each makes the search larger.
    #[serde(default = "nothing")]
    #[schemars(with = "Vec<Ability>")]
    pub also: Spanned<Vec<Ability>>,
    /// How far what the person holds, a tool or a workpiece, reaches beyond the finger tips, m, 0.05 to 1: in either hand, and in whatever
    /// direction the hand turns it. What hits it is taken to hit the hand. Nothing by default.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub held_m: Option<Spanned<f64>>,
    /// How fast who runs does so, m/s: two, three or four times the walking speed of 1.6 m/s. No standard counts on people who run.
    #[serde(default)]
    #[schemars(with = "Option<f64>")]
    pub run_m_s: Option<Spanned<f64>>,
    /// Radii of body parts that are not those of a person of this stature.
    #[serde(default)]
    #[schemars(with = "Option<Radii>")]
    pub radii_m: Option<Spanned<Radii>>,
}

fn at_once() -> Spanned<Vec<f64>> {
    Spanned::new(0..0, vec![0.0])
}

fn nothing() -> Spanned<Vec<Ability>> {
    Spanned::new(0..0, Vec::new())
}

fn p50() -> Spanned<u8> {
    Spanned::new(0..0, 50)
}
const fn forty_five() -> f64 {
    45.0
}
const fn thirty() -> f64 {
    30.0
}

/// A start pose.
#[derive(Clone, Copy, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartTable {
    /// Floor position, m.
    pub xy_m: [f64; 2],
    /// Heading, degrees from +x towards +y.
    pub heading_deg: f64,
}

/// An area in which the person may start: at the places whose coordinates are whole multiples of the spacing in the world
/// frame, its edge included, where no obstacle is in the way, in each of the headings.
#[derive(Clone, Debug, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct StartAreaTable {
    /// Corners of a convex or concave polygon in the floor plane, m, in order.
    pub polygon_m: Vec<[f64; 2]>,
    /// Distance of neighbouring places along x and y, m, 0.05 to 5.
    pub spacing_m: f64,
    /// Headings, degrees from +x towards +y.
    pub heading_deg: Vec<f64>,
}
