//! What people do in an action, in words: of one person, or of two by their names.

use crate::human::{Action, Who};
use fmi_hazard_record::operated::ControlRecord;

/// Walk and posture: "walks straight ahead, bent forward"; of two people what each does.
#[must_use]
pub(crate) fn moves(action: Action, names: Option<&[String; 2]>) -> String {
    let does = |action: Action| format!("{}, {}", action.walk().words(), action.posture().words());
    match names {
        None => does(action),
        Some(names) => {
            let of = |who: Who| format!("{} {}", names[who as usize], does(action.of(who)));
            format!("{}; {}", of(Who::First), of(Who::Second))
        }
    }
}

/// The same with the controls that are worked: "stands, upright, presses reset".
#[must_use]
pub(crate) fn acts(action: Action, names: Option<&[String; 2]>, controls: &[ControlRecord]) -> String {
    let works = |number: usize| match controls.get(number) {
        Some(control) => control.words(),
        None => format!("works control {}", number + 1),
    };
    std::iter::once(moves(action, names)).chain(action.presses().numbers().map(works)).collect::<Vec<_>>().join(", ")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::human::{ControlKind, ControlledBy};

    #[test]
    fn what_each_does_is_told_and_what_is_worked() {
        let control =
            |name: &str, by, kind, door| ControlRecord { name: name.to_owned(), by, kind, pressed_steps: None, door };
        let controls = [
            control("reset", ControlledBy::Anyone, ControlKind::Momentary, false),
            control("gate", ControlledBy::Person, ControlKind::Toggled, true),
        ];
        let told = |text: &str, names: Option<&[String; 2]>| acts(text.parse().unwrap(), names, &controls);
        assert_eq!(told("left90/bend-forward", None), "turns left by 90 degrees and walks on, bent forward");
        assert_eq!(
            told("stop/upright+press1+press2+press3", None),
            "stands, upright, a colleague presses reset, opens or closes gate, works control 3"
        );
        let names = ["Ann", "Bob"].map(str::to_owned);
        assert_eq!(
            told("forward/upright&stop/crouch+press2", Some(&names)),
            "Ann walks straight ahead, upright; Bob stands, crouching, opens or closes gate"
        );
    }
}
