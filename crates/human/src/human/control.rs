//! How people work controls: who, and what a hand does there.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

/// Who can work a control.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ControlledBy {
    /// The person in the cell, when a hand gets there from where the person stands as the action begins.
    #[default]
    Person,
    /// Anyone, at any time: a colleague outside who does not see the person.
    Anyone,
    /// Nobody, while the person is in the cell: as if it were out of reach, or had no effect then.
    Nobody,
}

/// How a control is worked.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ControlKind {
    /// A push button: pressed for a time, then released.
    #[default]
    Momentary,
    /// Held for as long as somebody's hand is on it: whole actions.
    Held,
    /// A switch, a key, a bolt: it stays as it was put until it is worked again.
    Toggled,
}
