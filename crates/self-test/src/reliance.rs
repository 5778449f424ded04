//! Whether the motion of the self-test's runs may be taken for that of the FMU: what speaks against it, and what shows it.

use crate::{Motion, SelfTest, number};

impl SelfTest {
    /// Why the motion of these runs may not be that of the FMU: all reasons, each a sentence without its full stop.
    #[must_use]
    pub fn against_motion(&self) -> Vec<String> {
        let (half, whole) = (number(self.step_s / 2.0), number(self.step_s));
        let halves = match &self.half_steps {
            Motion::Differs { most } => Some(format!(
                "in steps of {half} s instead of {whole} s the FMU moves otherwise: output {most} of what it ranges over. What \
                 it does depends on the communication step, and which motion is its own is not known. Set time.step_s to the \
                 step that its maker names; if it is so there, too, ask them"
            )),
            Motion::Failed { reason } => Some(format!(
                "in steps of {half} s instead of {whole} s the FMU fails, so whether it moves alike is not known. Ask its maker \
                 which steps it can make: {reason}"
            )),
            Motion::Same { .. } | Motion::NotTried { .. } => None,
        };
        let modes = match &self.event_mode {
            Motion::Differs { most } => Some(format!(
                "with Event Mode the FMU moves otherwise than without: output {most} of what it ranges over. Which motion is \
                 its own is not known. Ask its maker to handle the same events in both"
            )),
            Motion::Same { .. } | Motion::Failed { .. } | Motion::NotTried { .. } => None,
        };
        halves.into_iter().chain(modes).collect()
    }

    /// How it was shown that the motion is that of the FMU, with figures, as far as it was.
    #[must_use]
    pub fn motion_shown(&self) -> Vec<String> {
        let shown = |way: String, motion: &Motion| match motion {
            Motion::Same { most, .. } => Some(format!(
                "{way} it moves alike for {} steps: most apart is output {most} of what it ranges over",
                self.steps
            )),
            Motion::Differs { .. } | Motion::Failed { .. } | Motion::NotTried { .. } => None,
        };
        let half = format!("in steps of {} s instead of {} s", number(self.step_s / 2.0), number(self.step_s));
        let halves = shown(half, &self.half_steps);
        halves.into_iter().chain(shown("with Event Mode and without".to_owned(), &self.event_mode)).collect()
    }
}
