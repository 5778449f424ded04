//! Controls that are worked on the way to a hazard, by their names: who works them, how, and when.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::human::action::ACTION_S;
use crate::human::{ControlKind, ControlledBy, Presses};

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
    /// Whether it opens a door and closes it again.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub door: bool,
}

/// A control that is worked in an action.
#[derive(Clone, Debug, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OperatedControl {
    /// The control.
    #[serde(flatten)]
    pub control: ControlRecord,
    /// When the action begins, s.
    pub at_s: f64,
    /// Whether either of two people may be the one who works it.
    #[serde(default, skip_serializing_if = "std::ops::Not::not")]
    pub by_either: bool,
    /// Of a door: whether it is opened, or closed.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub opens: Option<bool>,
}

/// Who works a control that is out of reach.
const COLLEAGUE: &str = "a colleague";

const fn verb(kind: ControlKind) -> &'static str {
    match kind {
        ControlKind::Momentary => "presses",
        ControlKind::Held => "holds",
        ControlKind::Toggled => "switches",
    }
}

impl ControlRecord {
    /// What is done in any action that works it, behind what the person does: "presses reset", "a colleague presses reset".
    #[must_use]
    pub fn words(&self) -> String {
        let who = if self.by == ControlledBy::Anyone { format!("{COLLEAGUE} ") } else { String::new() };
        let does = if self.door { "opens or closes" } else { verb(self.kind) };
        format!("{who}{does} {}", self.name)
    }
}

impl OperatedControl {
    /// What is done: "the person presses reset", "a colleague opens door".
    #[must_use]
    pub fn words(&self) -> String {
        let who = match self.control.by {
            ControlledBy::Person if self.by_either => "one of the people",
            ControlledBy::Person => "the person",
            ControlledBy::Anyone => COLLEAGUE,
            ControlledBy::Nobody => "nobody",
        };
        let does = match (self.opens, self.control.kind) {
            (Some(true), _) => "opens",
            (Some(false), _) => "closes",
            (None, kind) => verb(kind),
        };
        format!("{who} {does} {}", self.control.name)
    }

    /// What is worked in a sequence, in order, of which this is worked in each action; by either of two people, or by the only one.
    #[must_use]
    pub fn all(worked: impl IntoIterator<Item = Presses>, controls: &[ControlRecord], by_either: bool) -> Vec<Self> {
        let (mut all, mut open) = (Vec::new(), Presses::NONE);
        for (number, presses) in worked.into_iter().enumerate() {
            #[expect(clippy::cast_precision_loss, reason = "a few actions")]
            let at_s = number as f64 * ACTION_S;
            open = open.either(presses);
            let worked = presses.numbers().filter_map(|number| Some((number, controls.get(number)?)));
            let opens = |number, control: &ControlRecord| control.door.then(|| open.has(number));
            all.extend(worked.map(|(n, control)| Self {
                control: control.clone(),
                at_s,
                by_either,
                opens: opens(n, control),
            }));
        }
        all
    }
}

/// What was worked, once each control: "the person presses reset at 0.60 s, a colleague switches mode at 0.80 s and 1.20 s";
/// nothing if nothing was.
#[must_use]
pub(crate) fn worked_words(worked: &[OperatedControl]) -> String {
    let mut told: Vec<(&OperatedControl, Vec<String>)> = Vec::new();
    for working in worked {
        let time = format!("{:.2} s", working.at_s);
        let same = |known: &OperatedControl| (&known.control, known.opens) == (&working.control, working.opens);
        match told.iter_mut().find(|(known, _)| same(known)) {
            Some((_, times)) => times.push(time),
            None => told.push((working, vec![time])),
        }
    }
    let times = |times: &[String]| match times {
        [first @ .., last] if !first.is_empty() => format!("{} and {last}", first.join(", ")),
        one => one.concat(),
    };
    let words = told.iter().map(|(working, at)| format!("{} at {}", working.words(), times(at)));
    words.collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::human::Presses;

    #[test]
    fn what_is_worked_is_told_with_its_times() {
        let control =
            |name: &str, by, kind| ControlRecord { name: name.to_owned(), by, kind, pressed_steps: None, door: false };
        let controls = [
            control("reset", ControlledBy::Person, ControlKind::Momentary),
            control("mode", ControlledBy::Anyone, ControlKind::Toggled),
        ];
        let [reset, mode] = [0, 1].map(Presses::one);
        let worked =
            OperatedControl::all([Presses::NONE, reset.and(mode), Presses::NONE, mode, mode], &controls, false);
        assert_eq!(
            worked_words(&worked),
            "the person presses reset at 0.20 s, a colleague switches mode at 0.20 s, 0.60 s and 0.80 s"
        );
        assert_eq!(worked_words(&[]), "");
        let door = ControlRecord { door: true, ..control("door", ControlledBy::Person, ControlKind::Toggled) };
        let door = [door, controls[0].clone()];
        let [opens, reset] = [0, 1].map(Presses::one);
        let worked = OperatedControl::all([opens, reset, opens, opens], &door, false);
        assert_eq!(
            worked_words(&worked),
            "the person opens door at 0.00 s and 0.60 s, the person presses reset at 0.20 s, the person closes door at 0.40 s"
        );
    }
}
