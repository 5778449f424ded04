//! Checks of the controls in a cell file: who works them, where, and for how long.

use toml::Spanned;

use super::checker::Checker;
use super::format::{CellFile, ControlTable};
use crate::cell::CellError;
use crate::cell::workcell::Control;
use crate::fmi::number;
use crate::geometry::{Capsule, Vec3};
use crate::human::Presses;
use crate::human::action::ACTION_S;
use crate::human::{ControlKind, ControlledBy};

/// A hand that comes this near works a control unless told otherwise, m.
const WITHIN_M: f64 = 0.03;

impl Checker<'_> {
    /// All controls of a cell whose actions have so many steps.
    pub(super) fn controls(&self, file: &CellFile, steps_per_action: usize) -> Vec<Control> {
        if let Some(one_more) = file.controls.get(Presses::MOST) {
            let message =
                format!("a cell has at most {} controls, this one has {}", Presses::MOST, file.controls.len());
            let help = "each doubles the actions: leave out those that do not matter for safety".to_owned();
            self.problems.tell(self.source.error(one_more.variable.span(), "one more", message, Some(help)));
        }
        for (number, control) in file.controls.iter().enumerate() {
            let alone = file.controls[..number].iter().all(|other| other.name != control.name);
            let _ = self.problems.keep(self.that(alone, control.variable.span(), || {
                (format!("two controls are called `{}`", control.name), "give each its own name".to_owned())
            }));
        }
        self.problems.keep_all(file.controls.iter().map(|control| self.control(control, steps_per_action)))
    }

    fn control(&self, control: &ControlTable, steps_per_action: usize) -> Result<Control, Box<CellError>> {
        let name = &control.name;
        let unreachable = control.at_m.is_none() && control.by == ControlledBy::Person;
        self.that(!unreachable, control.variable.span(), || {
            let help = "add at_m = [x, y, z], or by = \"anyone\" if a colleague may work it at any time".to_owned();
            (format!("control `{name}` does not say where it is"), help)
        })?;
        let place = control.at_m.as_ref().map(|at| self.hand_place(control, at)).transpose()?;
        for (key, value) in [
            ("to_m", control.to_m.as_ref().map(Spanned::span)),
            ("within_m", control.within_m.as_ref().map(Spanned::span)),
        ] {
            let Some(span) = value else { continue };
            self.that(place.is_some(), span, || {
                (format!("control `{name}` has {key} and no at_m"), format!("add at_m, or remove {key}"))
            })?;
        }
        let steps = match &control.for_ms {
            None => steps_per_action,
            Some(for_ms) => {
                self.that(control.kind == ControlKind::Momentary, for_ms.span(), || {
                    let message = format!("control `{name}` has for_ms, which is for momentary ones");
                    (message, "remove it: how long it is worked, is for the search to say".to_owned())
                })?;
                let ms = *for_ms.get_ref();
                self.that(ms > 0.0 && ms <= 1000.0 * ACTION_S, for_ms.span(), || {
                    let help = "use up to 200, one action; pressed longer it is kind = \"held\"".to_owned();
                    (format!("for_ms of control `{name}` is {}", number(ms)), help)
                })?;
                #[expect(clippy::cast_precision_loss, reason = "at most 1000 steps")]
                let steps = (ms / (1000.0 * ACTION_S) * steps_per_action as f64 - 1e-9).ceil();
                #[expect(
                    clippy::cast_possible_truncation,
                    clippy::cast_sign_loss,
                    reason = "checked: an action at most"
                )]
                let steps = steps.max(1.0) as usize;
                steps
            }
        };
        Ok(Control { name: name.clone(), place, by: control.by, kind: control.kind, steps, door: false })
    }

    /// Where a hand works it.
    fn hand_place(&self, control: &ControlTable, at: &Spanned<[f64; 3]>) -> Result<Capsule, Box<CellError>> {
        let name = &control.name;
        let radius = control.within_m.as_ref().map_or(WITHIN_M, |within| *within.get_ref());
        let span = control.within_m.as_ref().map_or_else(|| at.span(), Spanned::span);
        self.that((0.0..=1.0).contains(&radius), span, || {
            (format!("within_m of control `{name}` is {}", number(radius)), "use 0 to 1 m".to_owned())
        })?;
        let to = control.to_m.as_ref().unwrap_or(at);
        for point in [at, to] {
            self.finite(point.get_ref(), &point.span(), &format!("the place of control `{name}`"))?;
        }
        let [a, b] = [at, to].map(|point| Vec3::from_array(*point.get_ref()));
        Ok(Capsule { a, b, radius })
    }
}
