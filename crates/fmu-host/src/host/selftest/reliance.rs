//! Whether the motion of the self-test's runs may be taken for that of the FMU: what speaks against it, and what shows it.

use serde::{Deserialize, Serialize};

use super::motion::{self, Motion, Untried};
use super::{Agreement, SelfTest, Stage};
use crate::fmi::{Slave, number};
use crate::host::system::SystemSetup;

/// What the first run and the FMUs tell besides outputs.
#[derive(Clone, Debug, Default, Serialize, Deserialize)]
pub(in crate::host) struct Facts {
    /// Whether each FMU is run with its Event Mode.
    pub event_mode: Vec<bool>,
    /// Why half steps would say nothing.
    pub against_half_steps: Option<Untried>,
    /// Why the other of with Event Mode and without would say nothing.
    pub against_other_mode: Option<Untried>,
    /// See [`SelfTest::remarks`].
    pub remarks: Vec<String>,
}

impl Facts {
    /// After the first run.
    pub(in crate::host) fn of(slaves: &[Slave], setup: &SystemSetup) -> Self {
        let remark = |(slave, name): (&Slave, &String)| {
            let at_s = slave.left_event_s()?;
            let of = if slaves.len() > 1 { format!("`{name}`") } else { "the FMU".to_owned() };
            Some(format!(
                "{of} says at t = {at_s:.3} s, at the end of a step, that an event is to be handled in Event Mode, which its \
                 modelDescription.xml does not offer (hasEventMode): it is stepped on without. Ask its maker whether it \
                 handles its events by itself"
            ))
        };
        Self {
            event_mode: slaves.iter().map(Slave::prefers_event_mode).collect(),
            against_half_steps: motion::against_half_steps(slaves, setup),
            against_other_mode: motion::against_other_mode(slaves),
            remarks: slaves.iter().zip(&setup.names).filter_map(remark).collect(),
        }
    }
}

impl SelfTest {
    /// Whether a stage that compares motions makes sense after what was found before it; notes it if not. `remembered` if the
    /// first run need not be made again for it, in the same process.
    pub(in crate::host) fn wants_motion(&mut self, stage: Stage, skip: &[Stage], remembered: bool) -> bool {
        let repeats = self.repeatable() && (remembered || self.deterministic == Agreement::Exact);
        let noted = if stage == Stage::HalfSteps { &mut self.half_steps } else { &mut self.event_mode };
        if skip.contains(&stage) || *noted != Motion::default() {
            return false;
        }
        if !repeats {
            *noted = Motion::NotTried { why: Untried::NotRepeated };
        }
        repeats
    }

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
