//! A second person of a cell, as results tell of them.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cell::Workcell;
use crate::human::Ability;

/// A second person.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SecondRecord {
    /// What the first and the second person are called.
    pub names: [String; 2],
    /// Where the second one begins, floor plan, m.
    pub xy_m: [f64; 2],
    /// Where they look then, degrees from +x towards +y.
    pub heading_deg: f64,
    /// What they do besides walking, bending and reaching.
    #[serde(default, skip_serializing_if = "Vec::is_empty")]
    pub also: Vec<Ability>,
    /// How fast they run, m/s, if they do.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub run_m_s: Option<f64>,
    /// How far what they hold reaches beyond the finger tips, m, if they hold something.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub held_m: Option<f64>,
}

impl SecondRecord {
    /// Whether they do the same from the same place, whatever they are called.
    #[must_use]
    pub fn does_the_same_as(&self, other: &Self) -> bool {
        let figures = |of: &Self| [of.xy_m[0], of.xy_m[1], of.heading_deg].map(f64::to_bits);
        let does = |of: &Self| (of.also.clone(), of.run_m_s, of.held_m);
        figures(self) == figures(other) && does(self) == does(other)
    }

    /// That of a cell, if it has one.
    #[must_use]
    pub fn of(cell: &Workcell) -> Option<Self> {
        let second = cell.second.as_ref()?;
        Some(Self {
            names: second.names.clone(),
            xy_m: second.start.xy_m(),
            heading_deg: second.start.heading_deg(),
            also: second.repertoire.abilities().to_vec(),
            run_m_s: second.repertoire.run_m_s(),
            held_m: Some(second.held_m).filter(|held_m| *held_m > 0.0),
        })
    }
}
