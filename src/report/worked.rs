//! Controls that are worked on the way to a hazard, by their names: who works them, how, and when.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::cell::Control;
use crate::cell::file::format::{ControlKind, ControlledBy};
use crate::human::Presses;
use crate::human::action::ACTION_S;

/// A control of a cell.
#[derive(Clone, Debug, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
pub struct ControlRecord {
    /// Its name.
    pub name: String,
    /// Who works it.
    pub by: ControlledBy,
    /// How it is worked.
    pub kind: ControlKind,
    /// Of a momentary one: for how many communication steps it is pressed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub pressed_steps: Option<usize>,
}

/// A control that is worked in an action.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Working {
    /// The control.
    #[serde(flatten)]
    pub control: ControlRecord,
    /// When the action begins, s.
    pub at_s: f64,
}

impl From<&Control> for ControlRecord {
    fn from(control: &Control) -> Self {
        let pressed_steps = (control.kind == ControlKind::Momentary).then_some(control.steps);
        Self { name: control.name.clone(), by: control.by, kind: control.kind, pressed_steps }
    }
}

impl ControlRecord {
    /// What is done: "the person presses reset".
    #[must_use]
    pub fn words(&self) -> String {
        let who = match self.by {
            ControlledBy::Person => "the person",
            ControlledBy::Anyone => "a colleague",
            ControlledBy::Nobody => "nobody",
        };
        let does = match self.kind {
            ControlKind::Momentary => "presses",
            ControlKind::Held => "holds",
            ControlKind::Toggled => "switches",
        };
        format!("{who} {does} {}", self.name)
    }
}

impl Working {
    /// What is worked in a sequence, in order, of which this is worked in each action.
    #[must_use]
    pub fn all(worked: impl IntoIterator<Item = Presses>, controls: &[Control]) -> Vec<Self> {
        let mut all = Vec::new();
        for (number, presses) in worked.into_iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "a few actions")]
            let at_s = number as f64 * ACTION_S;
            let worked = presses.numbers().filter_map(|control| controls.get(control));
            all.extend(worked.map(|control| Self { control: control.into(), at_s }));
        }
        all
    }
}

/// What was worked, once each control: "the person presses reset at 0.60 s, a colleague switches mode at 0.80 s and 1.20 s";
/// nothing if nothing was.
#[must_use]
pub fn worked_words(worked: &[Working]) -> String {
    let mut told: Vec<(&ControlRecord, Vec<String>)> = Vec::new();
    for Working { control, at_s } in worked {
        let time = format!("{at_s:.2} s");
        match told.iter_mut().find(|(known, _)| *known == control) {
            Some((_, times)) => times.push(time),
            None => told.push((control, vec![time])),
        }
    }
    let times = |times: &[String]| match times {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        one => one.concat(),
    };
    let words = told.iter().map(|(control, at)| format!("{} at {}", control.words(), times(at)));
    words.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::human::Presses;

    #[test]
    fn what_is_worked_is_told_with_its_times() {
        let control = |name: &str, by, kind| Control { name: name.to_owned(), place: None, by, kind, steps: 10 };
        let controls = [
            control("reset", ControlledBy::Person, ControlKind::Momentary),
            control("mode", ControlledBy::Anyone, ControlKind::Toggled),
        ];
        let [reset, mode] = [0, 1].map(Presses::one);
        let worked = Working::all([Presses::NONE, reset.and(mode), Presses::NONE, mode, mode], &controls);
        assert_eq!(
            worked_words(&worked),
            "the person presses reset at 0.20 s, a colleague switches mode at 0.20 s, 0.60 s and 0.80 s"
        );
        assert_eq!(worked_words(&[]), "");
    }
}
